# SPDX-License-Identifier: MIT
"""Section IV, Theorem 4.2, and what stabilizability adds: the Riccati recursion from zero is increasing and bounded; statement of Theorem 4.3.

From P_0 = 0 the covariances increase: P_1 >= 0, and a larger noise covariance
[APA' + Q, -S; -S', R] gives a larger error covariance (Lemma 2.5). They stay
below those of the stable observer. So they converge, and the limit solves the
Riccati equation if its right side passes to the limit.

That is where the footnote of the paper is too quick. The last block of a
(1)-inverse is unique, but it is no continuous function of P: for

    E = [I_2; 0], A = [1, 0; 0, 0; 0, 1], Q = 0, no measurement,

and P = (1, e)'(1, e) the right side is zero for e other than zero and diag(1, 0)
for e = 0. What holds is that the right side at P_k lies between (1 - e) and 1
times that at P if (1 - e)P <= P_k <= P. An increasing sequence that tends to P
has this property with e tending to zero, as its ranges do not change from some
k on.

Stabilizability at t = 0 is full row rank of [E, Q, -S; C, -S', R], which makes
the 3-block matrix invertible for every P >= 0. The paper prints S for -S.
"""

from __future__ import annotations

from fractions import Fraction

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, first, induction, instances, null_vector, order, restated, steps, within
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    always,
    block,
    forall,
    given,
    hstack,
    inv,
    laurent,
    let,
    loewner,
    matrix,
    nonneg,
    positive_semidefinite,
    psd,
    rank,
    rec,
    scalar,
    sequence_of,
    sym,
    symbols,
    symmetric_matrix,
    vector,
    vstack,
    when,
)
from proofs.nwl92.notation import any_one_inverse, one_inverse
from proofs.nwl92.notation_system import (
    BOTTOM,
    COVARIANCE,
    F_BLOCK,
    GRAM,
    IMPLIED_RANK,
    INVERSE,
    LAST,
    NOISE,
    NOISE_G,
    OMEGA,
    OMEGA_INVERSE,
    ONE_INVERSE,
    OTHER_INVERSE,
    RANDOM_NOISE,
    RANDOM_NOISE_FREE,
    RANK,
    SIZES,
    STABILIZABLE_PAIR,
    STABILIZABLE_PENCIL,
    STEP,
    STEP_GIVEN,
    SYSTEM,
    TWO_GAINS,
    TWO_INVERSES,
    TWO_LETS,
    TWO_OVER,
    TWO_STANDING,
    U1,
    U2,
    Y2,
    A,
    C,
    E,
    K,
    L,
    Oi,
    Oia,
    Oib,
    Om,
    Oma,
    Omb,
    P,
    Pa,
    Pb,
    Q,
    R,
    S,
    block_types,
    drawn,
    filter_identities,
    identities_of,
    inverse_blocks,
    l,
    made_blocks,
    n,
    noise,
    noise_by_form,
    p,
    solutions,
    solved,
    three_block,
)
from proofs.nwl92.section_4_steady_state import (
    AT_EACH,
    FROM_ZERO,
    LG,
    NO_EIGENVECTOR,
    ONE_SOLUTION,
    PAIR_OF_SOLUTIONS,
    SAME,
    SOLVED,
    SOLVED_GAINS,
    UNBIASED,
    Pz,
    constant_gain,
    error_of,
    next_covariance,
)

DEFINITION = "a definition: it fixes notation and asserts nothing"
t = sym("t")

# ------------------------------------------------------------------ definitions of the Riccati equation and recursion
GAIN = hstack(T(U1), T(U2))
NEXT = -(LAST * Oi * BOTTOM)
SMALL = {"l": 1, "p": 1, "n": 1, A: [[1]], P: [[0]], Q: [[1]], S: [[0]], R: [[1]], E: [[1]], C: [[0]], INVERSE[0]: [[0]], INVERSE[1]: [[0]],
         INVERSE[2]: [[1]], U1: [[1]], U2: [[0]], INVERSE[5]: [[-1]]}
NO_INVERSE = example({**SMALL, U1: [[2]]})
claim("NWL92-E4.19", "the right side of the Riccati equation is the error covariance of the filter, whichever (1)-inverse is taken",
      (GAIN * noise(P) * T(GAIN) == NEXT) & psd(NEXT), sizes=["l", "n", "p"], over=STEP, where=[OMEGA, OMEGA_INVERSE], given=STEP_GIVEN,
      by=[filter_identities([], [error_of(GAIN, P)]), NO_INVERSE, example({**SMALL, U1: [[2]], INVERSE[5]: [[4]]}), drawn()],
      note="A definition; what is checked is that a solution is nonnegative, as the equation gives P as a covariance.")
claim("NWL92-E4.20", "the Riccati recursion gives error covariances, whichever (1)-inverses are taken",
      (GAIN * noise(P) * T(GAIN) == NEXT) & (GAIN * F_BLOCK == Identity(n)), sizes=["l", "n", "p"], over=STEP, where=[OMEGA, OMEGA_INVERSE], given=STEP_GIVEN,
      by=[filter_identities(), NO_INVERSE, drawn()], note="A definition; what is checked is that the next P is the error covariance with the gains of (4.29).")

# ------------------------------------------------------------------ increasing and bounded
Wt, P0 = symbols("Wt P0")
RECURSION_SIZES = {"l": (1, 2), "p": (1, 2), "n": (1, 2)}
NOTHING = Zero(n, n)
claim("NWL92-E4.21", "the first covariance is not smaller than zero",
      loewner(NEXT, NOTHING), sizes=["l", "n", "p"], over={**SYSTEM, **block_types()}, where=[let(Om, three_block(NOTHING)), OMEGA_INVERSE],
      given=[ONE_INVERSE, NOISE, IMPLIED_RANK],
      by=[filter_identities([error_of(GAIN, NOTHING)], of=((NOTHING, INVERSE),)), example({**{x: v for x, v in SMALL.items() if x is not P}, INVERSE[5]: [[1]]}), drawn()])

not_checked("NWL92-E4.22", "the induction hypothesis", "the hypothesis of an induction, assumed and not asserted")

STATES, FIRST_PART = vstack(A, Zero(p, n)), hstack(Identity(l), Zero(l, p))
M1, M2, xa, xb, xh, nu, u, r, y = symbols("M1 M2 xa xb xh nu u r y")
MEASURED = {**STEP, xa: vector(n), xb: vector(n), xh: vector(n), nu: vector(n), u: vector(l), r: vector(p), y: vector(p), M1: matrix(n, l), M2: matrix(n, p)}
ONE_MEASUREMENT = vstack(A * xh, y) == F_BLOCK * xb + vstack(A * nu - u, r)
DATA = [given("(4.1)", E * xb == A * xa + u), given("(4.2)", y == C * xb + r), given("estimate", xh == xa + nu)]
NOISE_MAP = block([[A, -Identity(l), Zero(l, p)], [Zero(p, n), Zero(p, l), Identity(p)]])
JOINT = block([[P, Zero(n, l), Zero(n, p)], [Zero(l, n), Q, S], [Zero(p, n), T(S), R]])
OTHER_GAIN = hstack(M1, M2)
BEST_GAIN = loewner(OTHER_GAIN * noise(P) * T(OTHER_GAIN), GAIN * noise(P) * T(GAIN))
OTHER_UNBIASED = given("M1, M2 unbiased", M1 * E + M2 * C == Identity(n))
X1, X2 = symbols("X1 X2")
OTHER_MADE = {M1: T(U1) + X1 - (X1 * E + X2 * C) * T(U1), M2: T(U2) + X2 - (X1 * E + X2 * C) * T(U2)}
OTHER_FREE = {X1: matrix(n, l), X2: matrix(n, p)}
DATA_MADE = {u: E * xb - A * xa, y: C * xb + r, xh: xa + nu, **OTHER_MADE}
DATA_ONES = {**SMALL, xa: [0], xb: [0], xh: [0], nu: [0], u: [0], r: [0], y: [0], M1: [[1]], M2: [[0]]}
DATA_FOILS = [example({**DATA_ONES, **change}) for change in ({U1: [[2]]}, {xb: [1]}, {y: [1]}, {xh: [1]}, {M1: [[0]]})]
#: the bound is one as well if either of the parts of the noise, which are nonnegative, enters it with the other sign
WEAKER_BOUNDS = [filter_identities([], [], [error_of(OTHER_GAIN - GAIN, P), 2 * GAIN * part * T(GAIN)], []) for part in (
    STATES * P * T(STATES), T(FIRST_PART) * FIRST_PART * COVARIANCE * T(FIRST_PART) * FIRST_PART)]
claim("NWL92-E4.23", "P_j is the error covariance of the estimate of x(j) from one measurement",
      ONE_MEASUREMENT & (NOISE_MAP * JOINT * T(NOISE_MAP) == noise(P)) & BEST_GAIN & (GAIN * noise(P) * T(GAIN) == NEXT), sizes=["l", "n", "p"], over=MEASURED,
      where=[OMEGA, OMEGA_INVERSE], given=[ONE_INVERSE, NOISE, IMPLIED_RANK, *DATA, OTHER_UNBIASED],
      by=[filter_identities([], [], [error_of(OTHER_GAIN - GAIN, P)], []), *WEAKER_BOUNDS, *DATA_FOILS, drawn(made_by=DATA_MADE, using=OTHER_FREE)],
      note=("xa, xb are x(j-1), x(j), P is P_(j-1), xh = x(j-1) + nu its estimate. The gain of the (1)-inverse has the smallest error covariance of all unbiased ones, "
            "(M1 M2), and that is the right side of (4.20)."))

#: P_j for P_(j-1) = 0: E = A = Q = R = 1, C = S = 0
LATER = {**{x: v for x, v in SMALL.items() if x is not P}, Pa: [[0]], Pb: [[1]], INVERSE[5]: [[-2]], M1: [[1]], M2: [[0]]}
LATER_OVER = {**SYSTEM, Pa: positive_semidefinite(n), Pb: positive_semidefinite(n), **block_types(), M1: matrix(n, l), M2: matrix(n, p)}
LATER_LETS = [let(Om, three_block(Pb)), OMEGA_INVERSE, let(sym("N"), noise(Pb))]
FROM_PAST = given("(4.20)", Pb == next_covariance(Pa))
Nj = sym("N")
LATER_BEST = loewner(OTHER_GAIN * Nj * T(OTHER_GAIN), GAIN * Nj * T(GAIN))
LATER_DRAWN = drawn(before={Pb: next_covariance(Pa)}, made_by=OTHER_MADE, using=OTHER_FREE)
claim("NWL92-E4.24", "the error covariance of the estimate of x(j+1), as printed with P_(j-1)",
      LATER_BEST & (GAIN * Nj * T(GAIN) == Pa), sizes=["l", "n", "p"], over=LATER_OVER, where=LATER_LETS,
      given=[ONE_INVERSE, NOISE, IMPLIED_RANK, FROM_PAST, OTHER_UNBIASED], by=[example(LATER), LATER_DRAWN],
      repair=repair("index", "it is P_(j+1), as in (4.23) one step later; P_(j-1) belongs to x(j-1)",
                    LATER_BEST & (GAIN * Nj * T(GAIN) == NEXT), sizes=["l", "n", "p"], over=LATER_OVER, where=LATER_LETS,
                    given=[ONE_INVERSE, NOISE, IMPLIED_RANK, OTHER_UNBIASED],
                    by=[filter_identities([error_of(OTHER_GAIN - GAIN, Pb)], of=((Pb, INVERSE),)),
                        *[example({**LATER, **change}) for change in ({U1: [[2]]}, {M1: [[0]]})], LATER_DRAWN]),
      note="Pa is P_(j-1), Pb is P_j; the right side of the corrected statement is that of (4.20) for P_j. The measurement is that of (4.23) one step later.")

D0, D1, D2, Fi = symbols("D0 D1 D2 Fi")
HALF = Fraction(1, 2)
claim("NWL92-E4.25", "a larger error covariance gives a larger noise covariance",
      loewner(noise(Pb), noise(Pa)), sizes=["l", "n", "p"], over={**SYSTEM, Pa: symmetric_matrix(n), Pb: symmetric_matrix(n)}, given=[given("(4.22)", loewner(Pb, Pa))],
      by=[order([vstack(A, Zero(p, n)) * (Pb - Pa) * T(vstack(A, Zero(p, n)))]),
          example({"l": 1, "p": 1, "n": 1, A: [[1]], Q: [[0]], S: [[0]], R: [[0]], E: [[0]], C: [[0]], Pa: [[1]], Pb: [[0]]}),
          instances(made_by={Pb: Pa + D0}, using={D0: positive_semidefinite(n)}, **RECURSION_SIZES)], note="Pa, Pb are P_(j-1), P_j.")

Py, Pt = symbols("Py Pt")
FROM_ONE = rec(Py, t, next_covariance(NOTHING), next_covariance(Py[t]))
TWO = ((Pa, INVERSE), (Pb, OTHER_INVERSE))
COVARIANCE_A, COVARIANCE_B = symbols("Ca Cb")
GAIN_A, GAIN_B = hstack(T(INVERSE[3]), T(INVERSE[4])), hstack(T(OTHER_INVERSE[3]), T(OTHER_INVERSE[4]))
#: by how much the second covariance is larger if P is
UPPER_TERMS = [GAIN_B * STATES * (Pb - Pa) * T(STATES) * T(GAIN_B), error_of(GAIN_B - GAIN_A, Pa)]
AFTER_LETS = [let(Oma, three_block(Pa)), let(Oia, inverse_blocks()), let(Omb, three_block(Pb)), let(Oib, inverse_blocks(OTHER_INVERSE)),
              let(COVARIANCE_A, -(LAST * Oia * BOTTOM)), let(COVARIANCE_B, -(LAST * Oib * BOTTOM))]
MADE_A, FREE_A = made_blocks(Oma)
MADE_B, FREE_B = made_blocks(Omb, OTHER_INVERSE, Y2)
#: E = A = Q = R = 1, C = S = 0: the right side is P + 1
AFTER_ONES = {"l": 1, "p": 1, "n": 1, A: [[1]], E: [[1]], C: [[0]], Q: [[1]], S: [[0]], R: [[1]], Pa: [[1]], Pb: [[1]],
              **dict(zip(INVERSE, ([[0]], [[0]], [[1]], [[1]], [[0]], [[-2]]), strict=True)),
              **dict(zip(OTHER_INVERSE, ([[0]], [[0]], [[1]], [[1]], [[0]], [[-2]]), strict=True))}
EARLIER = given("(4.22)", loewner(Pb, Pa))
#: P_0, P_1, ... by (4.20) from P_0 = 0, with a (1)-inverse Oi_k of each 3-block matrix, whichever is taken
J_LAST, k_ = symbols("J k")
EACH = tuple(x[t] for x in INVERSE)
AT_K, AFTER_K = tuple(x[k_] for x in INVERSE), tuple(x[t + 1] for x in INVERSE)
RECURSION = rec(P, t, NOTHING, -(LAST * inverse_blocks(EACH) * BOTTOM))
EACH_INVERSE = given("(2.20) for P_k", forall(k_, 0, J_LAST, three_block(P[k_]) * inverse_blocks(AT_K) * three_block(P[k_]) == three_block(P[k_])))


def gain_of(blocks):
    """The gain that these blocks give."""
    return hstack(T(blocks[3]), T(blocks[4]))


def increasing():
    """Evidence for P_j <= P_(j+1) at the next j: both covariances are errors, and the gain of the second is not better for the first."""
    (one, other), needs, inside = identities_of([(P[t], EACH), (P[t + 1], AFTER_K)], n)
    own = error_of(gain_of(EACH), P[t])
    half = len(needs) // 2
    through = gain_of(AFTER_K)
    larger = [through * STATES * (P[t + 1] - P[t]) * T(STATES) * T(through), error_of(through - gain_of(EACH), P[t])]
    return order(*needs[:half], [own], *needs[half:], [own], larger,
                 lemmas=[one, psd(P[t + 1]), other], inside=[inside[0], {**inside[1], "number": 2}])


def random_inverses():
    """Blocks of a (1)-inverse for each k <= 2: the P_k do not depend on which are taken, so that one will do for them."""
    one = next_covariance(NOTHING)
    whole = any_one_inverse(three_block(when(k_ == 0, NOTHING, when(k_ == 1, one, next_covariance(one)))), Y2)
    a, b, c = vstack(Identity(l), Zero(p + n, l)), vstack(Zero(l, p), Identity(p), Zero(n, p)), vstack(Zero(l + p, n), Identity(n))
    return {name: (k_, T(x) * whole * y) for name, (x, y) in zip(INVERSE, ((a, a), (a, b), (b, b), (a, c), (b, c), (c, c)), strict=True)}


FIRST = tuple(x[0] for x in INVERSE)
FROM_NOTHING = filter_identities([], [error_of(gain_of(FIRST), P[0])], of=((P[0], FIRST),))
#: E = A = Q = R = 1, C = S = 0 and J = 1, but for the last block
EACH_ONES = {"l": 1, "p": 1, "n": 1, "J": 1, A: [[1]], E: [[1]], C: [[0]], Q: [[1]], S: [[0]], R: [[1]],
             **dict(zip(INVERSE[:5], ([[[0]]] * 2, [[[0]]] * 2, [[[1]]] * 2, [[[1]]] * 2, [[[0]]] * 2), strict=True))}
claim("NWL92-S33", "the covariances from zero increase",
      loewner(Pb, Pa), sizes=["l", "n", "p", "J"],
      over={**SYSTEM, **{x: sequence_of(kind, 0, J_LAST) for x, kind in block_types().items()}}, where=[RECURSION, let(Pa, P[J_LAST]), let(Pb, P[J_LAST + 1])],
      given=[EACH_INVERSE, NOISE, IMPLIED_RANK],
      by=[induction(before=[first(forall(t, 0, J_LAST, psd(P[t]) & loewner(P[t + 1], P[t])), base=FROM_NOTHING, step=increasing())], base=order([P[J_LAST + 1] - P[J_LAST]])),
          *[example({**EACH_ONES, INVERSE[5]: blocks}) for blocks in ([[[-2]], [[-1]]], [[[1]], [[1]]])],
          instances(12, made_by={**RANDOM_NOISE, **random_inverses()}, using={**RANDOM_NOISE_FREE, Y2: matrix(l + p + n, l + p + n)},
                    l=(1, 2), p=(1,), n=(1, 2), J=(0, 1, 2))],
      note="Pa, Pb are P_J and P_(J+1), for any J: P_0 = 0, and P_(k+1) is what (4.20) makes of P_k, whichever (1)-inverse is taken at each k.")

Ps, Wn, Pow = symbols("Ps Wn Pow")
OBSERVED = given("(4.18)", Ps == constant_gain(Ps))
LK = {L: matrix(n, l), K: matrix(n, p)}
CLOSED = T(T(L * A))
#: A = 0, with any unbiased gains
NO_MEMORY = {Fi: inv(GRAM), L: Fi * T(E) + D1 - (D1 * E + D2 * C) * Fi * T(E), K: Fi * T(C) + D2 - (D1 * E + D2 * C) * Fi * T(C), A: Zero(l, n),
             Ps: constant_gain(NOTHING)}
BOUND_ONES = {"l": 1, "n": 1, "p": 1, A: [[1]], E: [[1]], C: [[1]], Q: [[0]], S: [[0]], R: [[1]], L: [[1]], K: [[0]], P: [[1]], Wn: [[1]], Ps: [[1]], INVERSE[0]: [["1/2"]],
              INVERSE[1]: [["-1/2"]], INVERSE[2]: [["1/2"]], U1: [["1/2"]], U2: [["1/2"]], INVERSE[5]: [["-1/2"]]}
claim("NWL92-S30", "the covariances of the stable filter bound those of the optimal one, and tend to P_s",
      loewner(constant_gain(Wn), NEXT) & (constant_gain(Wn) - Ps == (L * A) * (Wn - Ps) * T(L * A)), sizes=["l", "n", "p"],
      over={**STEP, **LK, Wn: symmetric_matrix(n), Ps: symmetric_matrix(n)}, where=[OMEGA, OMEGA_INVERSE],
      given=[ONE_INVERSE, NOISE, IMPLIED_RANK, UNBIASED, given("P_k <= P_s(k)", loewner(Wn, P)), OBSERVED],
      by=[restated("induction on k", "the powers of a stable matrix tend to zero"),
          filter_identities([CLOSED * (Wn - P) * T(CLOSED), error_of(hstack(L, K) - GAIN, P)], []),
          filter_identities([CLOSED * (Wn - P) * T(CLOSED), error_of(hstack(L, K), P), error_of(GAIN, P)], []),  # for a bound of the other sign
          *[example({**BOUND_ONES, **change}) for change in ({INVERSE[5]: [[-2]]}, {L: [[0]], Ps: [[0]]}, {P: [[4]], INVERSE[5]: [["-4/5"]], Wn: [["1/2"]], INVERSE[0]: [["1/5"]],
                                                              INVERSE[1]: [["-1/5"]], INVERSE[2]: [["1/5"]], U1: [["1/5"]], U2: [["4/5"]]}, {K: [[1]], L: [[0]], Ps: [[2]]})],
          drawn(10, before=NO_MEMORY, made_by={Wn: P + D0}, using={D1: matrix(n, l), D2: matrix(n, p), D0: positive_semidefinite(n)}),
          solutions(8, made_by={L: T(U1), K: T(U2), Ps: P, Wn: P + D0}, using={D0: positive_semidefinite(n)}, l=(1, 2))],
      note=("L, K are L_e, L_c; P is P_k and Wn is P_s(k), one step later. Both filters start with one covariance. The difference from P_s goes through the powers of "
            "the stable L_e A."))

claim("NWL92-S28", "the covariances from zero increase and are bounded",
      psd(COVARIANCE_A) & loewner(COVARIANCE_B, COVARIANCE_A) & loewner(Ps, COVARIANCE_B), sizes=["l", "n", "p"],
      over={**TWO_OVER, **LK, Ps: symmetric_matrix(n)}, where=AFTER_LETS,
      given=[*TWO_INVERSES, NOISE, IMPLIED_RANK, UNBIASED, EARLIER, given("bounded", loewner(Ps, Pb)), OBSERVED],
      by=[restated("induction on j", "an increasing bounded sequence of symmetric matrices converges", "its limit satisfies (4.19) (NWL92-S29)"),
          filter_identities([error_of(GAIN_A, Pa)], UPPER_TERMS, [CLOSED * (Ps - Pb) * T(CLOSED), error_of(hstack(L, K) - GAIN_B, Pb)], of=TWO),
          *[example({**AFTER_ONES, L: [["1/2"]], K: [["1/2"]], C: [[1]], A: [[0]], Q: [[0]], R: [[4]], Ps: [[1]], Pa: [[0]], Pb: [[0]],
                     **dict(zip(INVERSE, ([[1]], [[-1]], [[1]], [[1]], [[0]], [[0]]), strict=True)),
                     **dict(zip(OTHER_INVERSE, ([[1]], [[-1]], [[1]], [[1]], [[0]], [[0]]), strict=True)), **change})
            for change in ({INVERSE[5]: [[-1]]}, {INVERSE[5]: [[1]]}, {OTHER_INVERSE[5]: [[1]]}, {OTHER_INVERSE[5]: [[-2]]}, {Ps: [[-1]]})],
          instances(10, made_by={**RANDOM_NOISE, **NO_MEMORY, Pb: Ps * HALF, Pa: Pb * HALF, **MADE_A, **MADE_B},
                    using={**RANDOM_NOISE_FREE, **FREE_A, **FREE_B, D1: matrix(n, l), D2: matrix(n, p)}, **SIZES),
          instances(8, made_by={**SOLVED_GAINS, Ps: P, Pb: P * HALF, Pa: Pb * HALF, **MADE_A, **MADE_B},
                    using={**solved()[1], **FREE_A, **FREE_B, P: positive_semidefinite(n)}, l=(1, 2), p=(1, 2), n=(1, 2))],
      note=("Pa, Pb are P_(j-1), P_j and Ca, Cb what (4.20) makes of them, whichever (1)-inverses are taken; Ps is the P_s of the stable filter with L_e = L, L_c = K, "
            "and not smaller than P_0 = 0 (NWL92-E4.18)."))

MONOTONE = {"sizes": ["l", "n", "p"], "over": {**LG, P: positive_semidefinite(n)}, "where": [FROM_ZERO, FROM_ONE],
            "given": [NOISE, UNBIASED, given("(4.18)", P == constant_gain(P))]}
BOUNDED_ONES = {"l": 1, "n": 1, "p": 1, A: [[0]], E: [[1]], C: [[0]], Q: [[1]], S: [[0]], R: [[1]], L: [[1]], K: [[0]], P: [[0]]}
MONOTONE_DRAWN = instances(8, made_by=SOLVED_GAINS, using=solved()[1], horizon=3, l=(1, 2), p=(1, 2), n=(1, 2))

# ------------------------------------------------------------------ the limit
V0, V1, i = symbols("V0 V1 i")
ALONG = (V0 + V1 / Z) * T(V0 + V1 / Z)
AT_LIMIT = -(LAST * one_inverse(three_block(V0 * T(V0))) * BOTTOM)
AT_INFINITY = next_covariance(ALONG)
#: E = (I_2; 0), A = (1, 0; 0, 0; 0, 1), Q = 0, C = S = 0, R = 1; P = (1, e)'(1, e)
CURVE = {"l": 3, "p": 1, "n": 2, A: [[1, 0], [0, 0], [0, 1]], E: [[1, 0], [0, 1], [0, 0]], C: [[0, 0]], Q: [[0, 0, 0]] * 3, S: [[0], [0], [0]], R: [[1]],
         V0: [[1, 0], [0, 0]], V1: [[0, 0], [1, 0]]}
e, f = symbols("e f")
FLIP = block([[Identity(l), Zero(l, p)], [Zero(p, l), -Identity(p)]])
LOWER_TERMS = [GAIN_A * STATES * (Pa - f * Pb) * T(STATES) * T(GAIN_A), e * (GAIN_A * FLIP * COVARIANCE * FLIP * T(GAIN_A)),
               f * error_of(GAIN_A - GAIN_B, Pb)]
NEAR = [given("P_k <= P", loewner(Pb, Pa)), given("(1 - e)P <= P_k", loewner(Pa, f * Pb)), given("f = 1 - e", e + f == 1)]
SANDWICH = loewner(COVARIANCE_B, COVARIANCE_A) & loewner(COVARIANCE_A, f * COVARIANCE_B)
NEAR_OVER = {**TWO_OVER, e: nonneg(), f: nonneg()}
NEAR_GIVEN = [*TWO_INVERSES, NOISE, IMPLIED_RANK, *NEAR]
g = sym("g")
NEAR_DRAWN = instances(12, made_by={**RANDOM_NOISE, f: 1 / (1 + g * g), e: 1 - f, Pa: f * Pb + e * f * Pb, **MADE_A, **MADE_B},
                       using={**RANDOM_NOISE_FREE, **FREE_A, **FREE_B, g: scalar()}, **SIZES)
NEAR_ONES = {**AFTER_ONES, e: 0, f: 1}
NEAR_FOILS = [example({**NEAR_ONES, **change}) for change in (
    {INVERSE[5]: [[-3]]}, {OTHER_INVERSE[5]: [[-1]]}, {Pa: [[2]], INVERSE[5]: [[-3]]}, {Pa: [[0]], INVERSE[5]: [[-1]]}, {e: 0, f: 2, Pa: [[2]], INVERSE[5]: [[-3]]},
    {e: 0, f: 0, Pa: [[0]], INVERSE[5]: [[-1]]}, {Q: [[0]], e: 1, f: 2, Pa: [[2]], Pb: [[1]], INVERSE[5]: [[-2]], OTHER_INVERSE[5]: [[-1]]},
    {Q: [[0]], e: 1, f: 1, Pa: [[0]], Pb: [[0]], INVERSE[5]: [[0]], OTHER_INVERSE[5]: [[-1]]},
    {f: 2, e: 0, Pa: [[0]], Pb: [[0]], INVERSE[5]: [[-1]], OTHER_INVERSE[5]: [[-1]]},
    {f: 0, Q: [[0]], Pa: [[0]], INVERSE[5]: [[0]], OTHER_INVERSE[5]: [[-1]]}, {f: 2, e: 0, Pa: [[2]], Pb: [[2]], INVERSE[5]: [[-3]], OTHER_INVERSE[5]: [[-3]]})]
NEAR_PROOF = filter_identities(UPPER_TERMS, LOWER_TERMS, of=TWO)
claim("NWL92-S29", "the right side of (4.20) passes to the limit as the inverse does, as the footnote has it",
      forall(i, 1, n, laurent(AT_INFINITY[i, i], 0) == AT_LIMIT[i, i]), sizes=["l", "p", "n"], over={**SYSTEM, V0: matrix(n, n), V1: matrix(n, n)},
      given=[NOISE, IMPLIED_RANK],
      by=[example(CURVE), instances(8, made_by=RANDOM_NOISE, using=RANDOM_NOISE_FREE, l=1, p=1, n=1)],
      repair=repair("missing hypothesis", ("the last block is unique but no continuous function of P, and (A.10) contains more than true inverses; the limit is right where "
                                           "(1 - e)P <= P_k <= P with e tending to zero, as for the increasing sequence of Theorem 4.2"),
                    SANDWICH, sizes=["l", "n", "p"], over=NEAR_OVER, where=AFTER_LETS, given=NEAR_GIVEN, by=[restated("the ranges of an increasing sequence of nonnegative matrices become constant", "what lies between two sequences of one limit tends to it"), NEAR_PROOF, *NEAR_FOILS, NEAR_DRAWN]),
      note=("Read as: if P_k tends to P, the right side of (4.20) at P_k tends to that at P, here along P_k = (V0 + V1/k)(V0 + V1/k)': the coefficient of z^0 at infinity is the "
            "limit for k = z. In the corrected statement Pa is P_k, Pb is P; for e = 0 it is the uniqueness of the block. The limit that Theorem 4.2 takes is right: the "
            "ranges of an increasing sequence that converges are those of its limit from some k on, so that it has this property."))

claim("NWL92-T4.2", "detectability gives a nonnegative solution of the Riccati equation, the limit of an increasing bounded sequence",
      always(t, loewner(Py[t], Pz[t])) & always(t, loewner(P, Pz[t])), **MONOTONE,
      by=[steps("NWL92-E4.21", "NWL92-E4.25", "NWL92-L2.5", "NWL92-S33", "NWL92-S30", "NWL92-S28",
                facts=["an increasing bounded sequence of symmetric matrices converges", "the ranges of an increasing sequence of nonnegative matrices become constant"],
                prose=("The stable filter of Theorem 4.1 bounds the sequence from zero, which increases; so it tends to some P. From some k on the ranges are that of P, hence "
                       "(1 - e)P <= P_k <= P with e tending to zero, and by the corrected NWL92-S29 the right side of (4.20) tends to that at P, so that P = P_(k+1) in the limit.")),
          example(BOUNDED_ONES), MONOTONE_DRAWN],
      note="What is tested is that the sequence from zero increases and is bounded; its limit is the solution.")

# ------------------------------------------------------------------ what stabilizability gives
v0, v1 = null_vector(0), null_vector(1)
VV = vstack(v0, v1)
PRINTED_ROWS = block([[E, Q, S], [C, T(S), R]])
RIGHT_ROWS = block([[E, Q, -S], [C, -T(S), R]])
Rows = sym("Rows")
#: E = C = Q = S = R = 1, A = 0, with a right inverse up to the noise
SAME_SIGN = {"l": 1, "p": 1, "n": 1, A: [[0]], Q: [[1]], S: [[1]], R: [[1]], E: [[1]], C: [[1]]}
ROWS_DRAWN = instances(made_by={**RANDOM_NOISE, A: Zero(l, n)}, using=RANDOM_NOISE_FREE, **RECURSION_SIZES)
EMPTY = {"l": 1, "p": 1, "n": 1, A: [[0]], Q: [[0]], S: [[0]], R: [[0]], E: [[0]], C: [[0]]}
claim("NWL92-S34", "stabilizability gives full row rank, as printed with S for -S",
      rank(Rows) == l + p, sizes=["l", "n", "p"], over=SYSTEM, where=[let(Rows, PRINTED_ROWS)], given=[NOISE, STABILIZABLE_PAIR], by=[example(SAME_SIGN), ROWS_DRAWN],
      repair=repair("sign", "S must have the sign it has in Definition 4.1, which (s, t) = (1, 0) gives: with S for -S the rank is another one",
                    rank(Rows) == l + p, sizes=["l", "n", "p"], over=SYSTEM, where=[let(Rows, RIGHT_ROWS)], given=[STABILIZABLE_PAIR],
                    by=[order(inside=[within(0, VV == Zero(l + p, 1), vector="left", pencil=STABILIZABLE_PENCIL, on=0)]), example(EMPTY), ROWS_DRAWN]))

ROWS_ENERGY = [T(VV) * COVARIANCE * VV, T(v0) * A * P * T(A) * v0]
ROWS_PROOF = order([], ROWS_ENERGY, [], inside=[within(0, (ROWS_ENERGY[0] + ROWS_ENERGY[1]) * Identity(1) == Zero(1, 1), COVARIANCE * VV == Zero(l + p, 1),
                                                       vector="left")])
ROWS_P = {**SYSTEM, P: positive_semidefinite(n)}
claim("NWL92-S35", "full row rank without APA' gives it with APA'",
      rank(Rows) == l + p, sizes=["l", "n", "p"], over=ROWS_P, where=[let(Rows, block([[E, A * P * T(A) + Q, S], [C, T(S), R]]))],
      given=[NOISE, given("full row rank", rank(PRINTED_ROWS) == l + p)],
      by=[ROWS_PROOF, example({"l": 1, "p": 1, "n": 1, A: [[0]], P: [[0]], Q: [[0]], S: [[0]], R: [[0]], E: [[0]], C: [[0]]}),
          instances(made_by=RANDOM_NOISE, using=RANDOM_NOISE_FREE, **RECURSION_SIZES)],
      note="With S as printed here; with -S it is true as well.")

lam1, lam2, x = symbols("lam1 lam2 x")
LAM = vstack(lam1, lam2)
LAM_ENERGY = T(LAM) * noise_by_form(P, n) * LAM
NULL_STEPS = [T(F_BLOCK) * LAM == Zero(n, 1), LAM_ENERGY * Identity(1) == Zero(1, 1), T(LAM) * NOISE_G == Zero(1, l + p), LAM == Zero(l + p, 1),
              F_BLOCK * x == Zero(l + p, 1)]
LAM_TERMS = [T(LAM) * FLIP * COVARIANCE * FLIP * LAM, T(LAM) * STATES * P * T(STATES) * LAM]
NULL_ONES = {"l": 1, "p": 1, "n": 1, A: [[0]], P: [[0]], Q: [[0]], S: [[0]], R: [[0]], E: [[1]], C: [[0]], lam1: [0], lam2: [0], x: [0]}
NULL_DRAWN = instances(made_by={**RANDOM_NOISE, lam1: Zero(l, 1), lam2: Zero(p, 1), x: Zero(n, 1)}, using=RANDOM_NOISE_FREE, **RECURSION_SIZES)
claim("NWL92-S36", "stabilizability makes the 3-block matrix invertible for every P",
      (lam1 == Zero(l, 1)) & (lam2 == Zero(p, 1)) & (x == Zero(n, 1)), sizes=["l", "n", "p"],
      over={**SYSTEM, P: positive_semidefinite(n), lam1: vector(l), lam2: vector(p), x: vector(n)}, where=[OMEGA],
      given=[NOISE, RANK, given("stabilizable at (s, t) = (1, 0)", rank(RIGHT_ROWS) == l + p), given("null vector", Om * vstack(lam1, lam2, x) == Zero(l + p + n, 1))],
      by=[order([], [], LAM_TERMS, [], [], [], [], [inv(GRAM)], lemmas=NULL_STEPS),
          *[example({**NULL_ONES, **change}) for change in ({lam2: [1]}, {E: [[0]], Q: [[1]], R: [[1]], x: [1]}, {R: [[1]], x: [1]}, {R: [[1]], lam1: [1]})], NULL_DRAWN],
      note=("Invertible is said as: a null vector (lam1; lam2; x) is zero. So the (1)-inverses in (4.29) and (4.32) are inverses. Of stabilizability only the point "
            "(1, 0) is used."))

# ------------------------------------------------------------------ Theorem 4.3
not_checked("NWL92-E4.33", "the Riccati recursion through the gains", DEFINITION)
not_checked("NWL92-E4.34", "the gains at step k", DEFINITION)
not_checked("NWL92-E4.35", "the algebraic Riccati equation through the gains", DEFINITION)
not_checked("NWL92-E4.37", "the steady-state filter", DEFINITION)

claim("NWL92-T4.3.3", "the steady-state filter is stable", **NO_EIGENVECTOR, note=AT_EACH)

UNIQUE_GIVEN = [*TWO_STANDING, *SOLVED, NOISE, IMPLIED_RANK, STABILIZABLE_PAIR]
UNIQUE_EVIDENCE = [example(PAIR_OF_SOLUTIONS), *[example({**PAIR_OF_SOLUTIONS, **ONE_SOLUTION, Pa: [[c]], Pb: [[1 - c]]}) for c in (1, 0)], SAME]
EXISTENCE_FACTS = ["an increasing bounded sequence of symmetric matrices converges", "the ranges of an increasing sequence of nonnegative matrices become constant"]
UNIQUE_STEPS = steps("NWL92-S28", "NWL92-S37", "NWL92-E4.45", "NWL92-E4.46", "NWL92-S39", facts=EXISTENCE_FACTS,
                     prose="There is a solution, by the argument of Theorem 4.2, and two are equal.")
claim("NWL92-T4.3.2", "the Riccati equation has exactly one nonnegative solution",
      Pa == Pb, sizes=["l", "n", "p"], over=TWO_OVER, where=[*TWO_LETS, *TWO_GAINS], given=UNIQUE_GIVEN, by=[UNIQUE_STEPS, *UNIQUE_EVIDENCE],
      note="That there is one is Theorem 4.2.")

WHOLE = {"sizes": ["l", "n", "p"], "over": {**LG, P: positive_semidefinite(n), P0: positive_semidefinite(n)},
         "where": [FROM_ZERO, rec(Pt, t, P0, next_covariance(Pt[t])), rec(Wt, t, P0, constant_gain(Wt[t])), rec(Pow, t, Identity(n), L * A * Pow[t])],
         "given": [NOISE, UNBIASED, given("(4.35)", P == constant_gain(P))]}
BETWEEN = always(t, loewner(Pt[t], Pz[t])) & always(t, loewner(Wt[t], Pt[t])) & always(t, Wt[t] - P == Pow[t] * (P0 - P) * T(Pow[t]))
WHOLE_DRAWN = instances(8, made_by=SOLVED_GAINS, using=solved()[1], horizon=3, l=(1, 2), p=(1, 2), n=(1, 2))
WHOLE_ONES = example({**BOUNDED_ONES, P0: [[0]]})
RATE = ("From above P_k is bounded by W_k, which tends to P as powers of the stable LA do; from below by the covariance from zero, which tends to P, and then exponentially fast as "
        "P - P_(k+1)^0 = (LA)(P - P_k^0)(L_k A)' (NWL92-S41) with L_k A tending to LA.")
CONVERGENCE = steps("NWL92-S28", "NWL92-S37", "NWL92-S39", "NWL92-S40", "NWL92-S41", "NWL92-S42", facts=["the powers of a stable matrix tend to zero exponentially fast"],
                    prose=RATE)
claim("NWL92-T4.3.1", "from every start the covariances converge exponentially fast to the solution", BETWEEN, **WHOLE, by=[CONVERGENCE, WHOLE_ONES, WHOLE_DRAWN],
      note="L, K are the gains of the solution P. What is tested is that P_k lies between the covariance from zero and W_k, and how W_k tends to P.")

claim("NWL92-T4.3", "convergence, uniqueness and stability", BETWEEN, **WHOLE,
      by=[steps("NWL92-S28", "NWL92-S37", "NWL92-S39", "NWL92-S40", "NWL92-S41", "NWL92-S42", "NWL92-T4.3.3",
                facts=[*EXISTENCE_FACTS, "the powers of a stable matrix tend to zero exponentially fast"], prose="There is one solution, as for NWL92-T4.3.2. " + RATE), WHOLE_ONES, WHOLE_DRAWN],
      note="The three parts are NWL92-T4.3.1, NWL92-T4.3.2 and NWL92-T4.3.3; what is tested here is the first.")
