# SPDX-License-Identifier: MIT
"""Section III, from Theorem 3.1 on: the 3-block form of the filter and of its Riccati equation.

An estimate of x(j) with error covariance P, the dynamics
E x(j+1) = A x(j) + u and the measurement y = C x(j+1) + r are one measurement
of x(j+1): (A xh; y) = (E; C) x(j+1) + (A nu - u; r), with noise covariance
N = [APA' + Q, -S; -S', R]. Its 2-block matrix, read in three blocks, is

    Omega = [APA' + Q, -S, E; -S', R, C; E', C', 0],

and everything said in section II about blocks of a (1)-inverse applies: the
last block row gives the estimate, and minus the last block is its error
covariance. The paper prints (3.5) without that minus sign.

Omega is invertible exactly if (E; C) has full column rank and [N, (E; C)]
full row rank; the paper's rank condition has S in the place of -S, which is
not the same, as the sign cannot be moved to one of E, C.

For S = 0 and R > 0 the measurement can be eliminated: with W = C'R^-1 C and
M = [Sigma, E; E', -W] the last diagonal block of Omega^-1 is that of M^-1.
With Sigma = APA' + Q this gives a recursion for Sigma. The equation of Wang
and Bernhard is another form of it: diag(Sigma, W) = M - [0, E; 0, -W] -
[0, 0; E', -W], and M^-1 takes the columns of M to those of I. In the display
of this argument the sign of W is wrong in two places, and Q is once left out.
If Sigma > 0 as well, -M^-1 has the last block (E'Sigma^-1 E + W)^-1.
"""

from __future__ import annotations

from exactkf.claims import claim, repair
from exactkf.evidence import example, identity, instances, order
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    given,
    hstack,
    iff,
    inv,
    invertible,
    let,
    matrix,
    positive_definite,
    positive_semidefinite,
    rank,
    sym,
    symbols,
    vector,
    vstack,
)
from proofs.nwl92.notation_filter import FILTER, FILTER_DRAWN, FILTERED, FOILS, ONES, filter_proof, filtered_with
from proofs.nwl92.notation_system import (
    BOTTOM,
    F_BLOCK,
    GRAM,
    LAST,
    NOISE,
    OMEGA,
    OMEGA_INVERSE,
    ONE_INVERSE,
    RANDOM_NOISE,
    RANDOM_NOISE_FREE,
    RANK,
    SIZES,
    STEP_VARYING,
    U1,
    U2,
    VARYING,
    A,
    C,
    E,
    Oi,
    Om,
    P,
    Q,
    R,
    S,
    Tb,
    drawn,
    filter_identities,
    l,
    m,
    n,
    noise,
    noise_by_form,
    p,
)

N = sym("N")
GAIN = hstack(T(U1), T(U2))
VARYING_SIZES = {**SIZES, "m": (1, 2)}
STEP_LETS = [OMEGA, OMEGA_INVERSE, let(N, noise(P))]
#: n = l = p = m = 1: E = Q = R = 1, A = C = S = 0
SMALL = {"l": 1, "p": 1, "n": 1, "m": 1, A: [[0]], P: [[0]], Q: [[1]], S: [[0]], R: [[1]], E: [[1]], C: [[0]], sym("W1"): [[0]], sym("W2"): [[0]],
         sym("W3"): [[1]], U1: [[1]], U2: [[0]], Tb: [[-1]]}
SIGN = "the minus sign before the block of the (1)-inverse is missing, as (2.22) and (4.20) show"
NOTE = ("x(j) is J X for the unknowns X of all earlier equations, which are a = F X + V e; z is x(j+1), and z0, X0, e0, f0 are the true values. Of all "
        "(X, z, e, f) that satisfy the equations until j + 1, those found have the smallest e'e + f'f, that is the largest likelihood, as e0'e0 + f0'f0 = "
        "e'e + f'f + |e0 - e|^2 + |f0 - f|^2; and no other z goes with them.")

claim("NWL92-T3.1", "the filter and its Riccati equation in 3-block form, with (3.5) as printed",
      filtered_with(1), **FILTER, by=[example(ONES), FILTER_DRAWN],
      repair=repair("sign", SIGN, filtered_with(-1), **FILTER, by=[filter_proof(), *FOILS, FILTER_DRAWN]),
      note=f"{NOTE} The error z - z0 is the gain times the noise of (3.3) and (3.2), whose covariance is the block of the 3-block matrix.")

claim("NWL92-E3.4", "the filter in 3-block form", FILTERED, **FILTER, by=[filter_proof(), *FOILS, FILTER_DRAWN], note=NOTE)

claim("NWL92-E3.5", "the error covariance in 3-block form, as printed without a minus sign",
      GAIN * N * T(GAIN) == LAST * Oi * BOTTOM,
      sizes=["l", "m", "n", "p"], over=STEP_VARYING, where=STEP_LETS, given=[ONE_INVERSE, NOISE, RANK],
      by=[example(SMALL), drawn(m=(1, 2))],
      repair=repair("sign", SIGN, GAIN * N * T(GAIN) == -(LAST * Oi * BOTTOM),
                    sizes=["l", "m", "n", "p"], over=STEP_VARYING, where=STEP_LETS, given=[ONE_INVERSE, NOISE, RANK],
                    by=[filter_identities(before=m), example({**SMALL, U1: [[2]]}), drawn(m=(1, 2))]),
      note=("The error of the estimate (3.4) is the gain times the noise (A nu - u; r). The scan of (3.5) is damaged in the first row of the matrix; its "
            "outer factors are clear, and no sign stands before them, while (4.19) and (4.20) have it."))

Rows = sym("Rows")
PRINTED_ROWS = block([[A * P * T(A) + Q, S, E], [T(S), R, C]])
RIGHT_ROWS = block([[A * P * T(A) + Q, -S, E], [-T(S), R, C]])
ALONE = {**VARYING, P: positive_semidefinite(m)}
lam1, lam2, x = symbols("lam1 lam2 x")
LAM = vstack(lam1, lam2)
NULL_VECTOR = given("null vector", Om * vstack(lam1, lam2, x) == Zero(l + p + n, 1))
LAM_NOISE = T(LAM) * noise_by_form(P, m) * LAM
NULL_STEPS = [T(F_BLOCK) * LAM == Zero(n, 1), LAM_NOISE * Identity(1) == Zero(1, 1), noise_by_form(P, m) * LAM == Zero(l + p, 1),
              F_BLOCK * x == Zero(l + p, 1), inv(GRAM) * T(F_BLOCK) * (F_BLOCK * x) == Zero(n, 1), x == Zero(n, 1)]
NULL_FOIL = {"l": 1, "p": 1, "n": 1, "m": 1, A: [[0]], P: [[0]], Q: [[1]], S: [[0]], R: [[1]], E: [[1]], C: [[0]], lam1: [0], lam2: [0], x: [0]}
claim("NWL92-T3.1.1", "full row rank without redundant perfect information makes the 3-block matrix invertible",
      (rank(Rows) == l + p) >> invertible(Om),
      sizes=["l", "m", "n", "p"], over=ALONE, where=[OMEGA, let(Rows, PRINTED_ROWS)], given=[NOISE, RANK],
      by=[example({"l": 1, "p": 1, "n": 1, "m": 1, A: [[0]], P: [[0]], Q: [[1]], S: [[1]], R: [[1]], E: [[1]], C: [[-1]]}),
          instances(made_by=RANDOM_NOISE, using=RANDOM_NOISE_FREE, **VARYING_SIZES)],
      repair=repair("sign", "S must have the sign it has in the 3-block matrix: with S for -S the rank is another one",
                    (lam1 == Zero(l, 1)) & (lam2 == Zero(p, 1)) & (x == Zero(n, 1)), sizes=["l", "m", "n", "p"],
                    over={**ALONE, lam1: vector(l), lam2: vector(p), x: vector(n)}, where=[OMEGA, let(Rows, RIGHT_ROWS)],
                    given=[NOISE, RANK, given("full row rank", rank(Rows) == l + p), NULL_VECTOR],
                    by=[order([], [], [LAM_NOISE], [], [], [inv(GRAM)], [], [], lemmas=NULL_STEPS), *[example({**NULL_FOIL, **change}) for change in (
                            {E: [[0]], x: [1]}, {Q: [[0]], E: [[0]], C: [[1]], lam1: [1]}, {x: [1]})],
                        instances(made_by={**RANDOM_NOISE, lam1: Zero(l, 1), lam2: Zero(p, 1), x: Zero(n, 1)}, using=RANDOM_NOISE_FREE, **VARYING_SIZES)]),
      note="The corrected statement says invertible as: a null vector (lam1; lam2; x) is zero.")

# ------------------------------------------------------------------ S = 0 and R > 0
Sig, Sigj, Mj = symbols("Sig Sigj M")
ROW_A, COLUMN_A = hstack(Zero(l, l), A), vstack(Zero(l, l), T(A))
INFORMATION = T(C) * inv(R) * C
CLASSICAL = {A: matrix(l, n), E: matrix(l, n), C: matrix(p, n), Q: positive_semidefinite(l), R: positive_definite(p)}
PREDICTED = {**CLASSICAL, Sig: positive_semidefinite(l)}
M_J = let(Mj, block([[Sig, E], [T(E), -INFORMATION]]))
WIDE = block([[R, Zero(p, l), C], [Zero(l, p), Sig, E], [T(C), T(E), Zero(n, n)]])
WB_SIZES = {"l": (1, 2), "p": (1, 2), "n": (1, 2)}
WIDE_LAST = vstack(Zero(p, n), Zero(l, n), Identity(n))

GAIN_WIDE = T(WIDE_LAST) * inv(WIDE) * block([[Identity(p), Zero(p, l)], [Zero(l, p), Identity(l)], [Zero(n, p), Zero(n, l)]])
ERROR_WIDE = GAIN_WIDE * block([[R, Zero(p, l)], [Zero(l, p), Sig]]) * T(GAIN_WIDE)
X = ROW_A * inv(Mj) * block([[Sig, Zero(l, n)], [Zero(n, l), INFORMATION]]) * inv(Mj) * COLUMN_A + Q
SHORT = -(ROW_A * inv(Mj) * COLUMN_A) + Q
claim("NWL92-S21", "with R > 0, S = 0 and (E; C) of full row rank the 3-block matrix is invertible, and (3.6) follows",
      (lam1 == Zero(l, 1)) & (lam2 == Zero(p, 1)) & (x == Zero(n, 1)) & (A * ERROR_WIDE * T(A) + Q == X), sizes=["l", "p", "n"],
      over={**CLASSICAL, P: positive_semidefinite(n), lam1: vector(l), lam2: vector(p), x: vector(n)},
      where=[let(Sig, A * P * T(A) + Q), M_J, let(Om, block([[A * P * T(A) + Q, Zero(l, p), E], [Zero(p, l), R, C], [T(E), T(C), Zero(n, n)]]))],
      given=[given("(E; C) has full column rank", rank(F_BLOCK) == n), given("(E; C) has full row rank", rank(F_BLOCK) == l + p), NULL_VECTOR],
      by=[order([], [], [], [], [], lemmas=[T(F_BLOCK) * LAM == Zero(n, 1), LAM == Zero(l + p, 1), F_BLOCK * x == Zero(l + p, 1)]),
          example({"l": 1, "p": 1, "n": 3, A: [[0, 0, 0]], P: [[0, 0, 0]] * 3, Q: [[0]], R: [[1]], E: [[1, 0, 0]], C: [[0, 1, 0]], lam1: [0], lam2: [0],
                   x: [0, 0, 1]}),
          example({"l": 1, "p": 1, "n": 1, A: [[0]], P: [[0]], Q: [[0]], R: [[1]], E: [[0]], C: [[1]], lam1: [1], lam2: [0], x: [0]}),
          example({"l": 1, "p": 1, "n": 2, A: [[0, 0]], P: [[0, 0]] * 2, Q: [[0]], R: [[1]], E: [[1, 0]], C: [[0, 1]], lam1: [1], lam2: [0], x: [0, 0]}),
          instances(made_by={lam1: Zero(l, 1), lam2: Zero(p, 1), x: Zero(n, 1)}, n=(2, 3), l=(1, 2), p=(1, 2))],
      note=("Invertible is said as: a null vector (lam1; lam2; x) is zero. No redundant perfect information means that this matrix is invertible (NWL92-T3.1.1). The last equation is that of "
            "Wang and Bernhard, (3.6), for the error covariance of (3.5); NWL92-E3.9 to NWL92-E3.13 are the same in steps."))

#: l = p = n = 1, all of Sigma, E, A, C, R one
ONES = {"l": 1, "p": 1, "n": 1, A: [[1]], E: [[1]], C: [[1]], Q: [[1]], R: [[1]], Sig: [[1]]}

claim("NWL92-E3.6", "the Riccati equation of Wang and Bernhard follows from that of the 3-block filter",
      A * ERROR_WIDE * T(A) + Q == X, sizes=["l", "p", "n"], over=PREDICTED, where=[M_J],
      by=[identity(l=(1, 2), p=1, n=(1, 2)), instances(**WB_SIZES)],
      note=("Sigma is any covariance of the prediction; the left side is APA' + Q with the error covariance P of the next filtered "
            "estimate. Where the 3-block matrix is invertible, so is M (NWL92-E3.7)."))

#: all but the first p coordinates, and the elimination of these
WITHOUT_P = block([[Zero(p, l), Zero(p, n)], [Identity(l), Zero(l, n)], [Zero(n, l), Identity(n)]])
ONLY_P = vstack(Identity(p), Zero(l, p), Zero(n, p))
ELIMINATE = block([[Identity(p), Zero(p, l), Zero(p, n)], [Zero(l, p), Identity(l), Zero(l, n)], [-(T(C) * inv(R)), Zero(n, l), Identity(n)]])
claim("NWL92-E3.7", "M is invertible exactly if the 3-block matrix is",
      iff(invertible(WIDE), invertible(Mj)), sizes=["l", "p", "n"], over=PREDICTED, where=[M_J],
      by=[order([T(WITHOUT_P) * inv(WIDE) * WITHOUT_P], [T(ELIMINATE) * (ONLY_P * inv(R) * T(ONLY_P) + WITHOUT_P * inv(Mj) * T(WITHOUT_P)) * ELIMINATE]),
          instances(**WB_SIZES)], note="A definition; what is checked is that M takes the place of the 3-block matrix. Their last blocks of the inverse are NWL92-E3.10.")

Pb, Pj = symbols("Pb Pj")
AHEAD = hstack(A, -Identity(l))
PREDICTION = AHEAD * block([[Pb, Zero(n, l)], [Zero(l, n), Q]]) * T(AHEAD)
STEP_J = [let(Sig, A * Pb * T(A) + Q), let(Pj, ERROR_WIDE)]
claim("NWL92-E3.8", "error covariance of the prediction of E x(j)",
      PREDICTION == A * Pj * T(A) + Q, sizes=["l", "p", "n"], over={**CLASSICAL, Pb: positive_semidefinite(n)}, where=STEP_J,
      by=[example({"l": 1, "p": 1, "n": 1, A: [[1]], E: [[1]], C: [[1]], Q: [[1]], R: [[1]], Pb: [[1]]}), instances(**WB_SIZES)],
      repair=repair("index", "the prediction of E x(j) is made from the estimate of x(j-1), so that P_(j-1) belongs to Sigma_j",
                    PREDICTION == A * Pb * T(A) + Q, sizes=["l", "n"],
                    over={A: matrix(l, n), Q: positive_semidefinite(l), Pb: positive_semidefinite(n)},
                    by=[identity(l=(1, 2), n=(1, 2)), instances(l=(1, 2), n=(1, 2))]),
      note=("Pb is the error covariance of the estimate of x(j-1), Pj that of x(j), one step of the filter later. The prediction A xh(j-1) "
            "of E x(j) = A x(j-1) + u(j-1) has the error A nu - u. If Sigma_j is to mean the prediction of E x(j+1), (3.8) stands, and "
            "that is how it is used from (3.9) on."))

claim("NWL92-E3.9", "recursion for Sigma through the 3-block matrix",
      A * ERROR_WIDE * T(A) + Q == -(hstack(Zero(l, p), Zero(l, l), A) * inv(WIDE) * vstack(Zero(p, l), Zero(l, l), T(A))) + Q,
      sizes=["l", "p", "n"], over=PREDICTED, by=[identity(l=(1, 2), p=1, n=(1, 2)), instances(**WB_SIZES)],
      note="The left side is APA' + Q with the error covariance of the estimate whose gain stands in the inverse of the 3-block matrix.")

claim("NWL92-E3.10", "elimination of the measurement",
      -(hstack(Zero(l, p), Zero(l, l), A) * inv(WIDE) * vstack(Zero(p, l), Zero(l, l), T(A))) + Q == SHORT,
      sizes=["l", "p", "n"], over=PREDICTED, where=[M_J], by=[identity(l=(1, 2), p=1, n=(1, 2)), instances(**WB_SIZES)])

claim("NWL92-E3.11", "the right sides of (3.6) and (3.10) agree",
      X == SHORT, sizes=["l", "p", "n"], over=PREDICTED, where=[M_J],
      by=[identity(l=(1, 2), p=1, n=(1, 2)), instances(**WB_SIZES)],
      note="First and last member of the chain; the members between have entries of their own.")

MIDDLE_SIGN = "diag(Sigma, C'R^-1 C) is M less [0, E; E', -2C'R^-1 C], so that the sign of the last block is wrong"
claim("NWL92-E3.11.1", "second member of (3.11)",
      ROW_A * inv(Mj) * (Mj - block([[Zero(l, l), E], [T(E), 2 * INFORMATION]])) * inv(Mj) * COLUMN_A + Q == X,
      sizes=["l", "p", "n"], over=PREDICTED, where=[M_J], by=[example(ONES), instances(**WB_SIZES)],
      repair=repair("sign", MIDDLE_SIGN,
                    ROW_A * inv(Mj) * (Mj - block([[Zero(l, l), E], [T(E), -2 * INFORMATION]])) * inv(Mj) * COLUMN_A + Q == X,
                    sizes=["l", "p", "n"], over=PREDICTED, where=[M_J],
                    by=[identity(l=(1, 2), p=1, n=(1, 2)), instances(**WB_SIZES)]))


def third_member(sign, last):
    """Third member of (3.11), with the sign of C'R^-1 C and what is added at the end."""
    ends = [ROW_A * inv(Mj) * part * inv(Mj) * COLUMN_A
            for part in (block([[Zero(l, l), E], [Zero(n, l), sign * INFORMATION]]), block([[Zero(l, l), Zero(l, n)], [T(E), sign * INFORMATION]]))]
    found = ROW_A * inv(Mj) * COLUMN_A - ends[0] - ends[1]
    return found if last is None else found + last


claim("NWL92-E3.11.2", "third member of (3.11)",
      third_member(1, None) == X,
      sizes=["l", "p", "n"], over=PREDICTED, where=[M_J], by=[example(ONES), instances(**WB_SIZES)],
      repair=repair("sign", MIDDLE_SIGN + " here too, and Q is left out", third_member(-1, Q) == X,
                    sizes=["l", "p", "n"], over=PREDICTED, where=[M_J],
                    by=[identity(l=(1, 2), p=1, n=(1, 2)), instances(**WB_SIZES)]))

CORNER = block([[Zero(l, l), Zero(l, n)], [Zero(n, l), Identity(n)]])
claim("NWL92-E3.11.3", "fourth member of (3.11)",
      ROW_A * inv(Mj) * COLUMN_A - ROW_A * CORNER * inv(Mj) * COLUMN_A - ROW_A * inv(Mj) * CORNER * COLUMN_A + Q == X,
      sizes=["l", "p", "n"], over=PREDICTED, where=[M_J],
      by=[identity(l=(1, 2), p=1, n=(1, 2)), instances(**WB_SIZES)])

claim("NWL92-E3.11.4", "last member of (3.11)",
      SHORT == X, sizes=["l", "p", "n"], over=PREDICTED, where=[M_J],
      by=[identity(l=(1, 2), p=1, n=(1, 2)), instances(**WB_SIZES)])

DEFINITE = {**CLASSICAL, Sig: positive_definite(l)}
claim("NWL92-E3.12", "the Riccati equation if Sigma is invertible",
      SHORT == A * inv(T(E) * inv(Sig) * E + INFORMATION) * T(A) + Q,
      sizes=["l", "p", "n"], over=DEFINITE, where=[M_J],
      by=[identity(l=(1, 2), p=1, n=(1, 2)), instances(**WB_SIZES)],
      note="The left side is (3.10). Full column rank of (E; C) is the denominator.")

NORMAL = {A: matrix(n, n), C: matrix(p, n), Q: positive_semidefinite(n), R: positive_definite(p), Sig: positive_definite(n)}
INFO_N = block([[Sig, Identity(n)], [Identity(n), -INFORMATION]])
claim("NWL92-E3.13", "the standard Riccati equation for E = I",
      -(hstack(Zero(n, n), A) * inv(INFO_N) * vstack(Zero(n, n), T(A))) + Q == A * inv(inv(Sig) + INFORMATION) * T(A) + Q,
      sizes=["p", "n"], over=NORMAL,
      by=[identity(p=1, n=(1, 2)), instances(p=(1, 2), n=(1, 2))],
      note="The left side is (3.10) with E = I.")
