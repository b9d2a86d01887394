# SPDX-License-Identifier: MIT
"""Section IV, from Lemma 4.2 on: the Riccati equation, its only solution, and convergence to it.

For a (1)-inverse of [R, H; H', 0] the block T and the gain U' satisfy
T + U'RU = 0 and U'H = I. With R = N and H = (E; C) the error covariance
-T = U'NU is a sum: N = (A; 0)P(A; 0)' + G, G = [Q, -S; -S', R], so

    -T = (LA)P(LA)' + (L K)G(L K)',    (L K) = U',    LE + KC = I.

If P solves the Riccati equation P = -T, a left eigenvector v of LA with
eigenvalue lam satisfies (1 - |lam|^2) vPv* = v(L K)G(L K)'v*. For |lam| >= 1
the left side is not positive and the right side not negative; so
v(L K)G = 0, and v(L K)(lam E - A; lam C) = lam v - lam v = 0. Thus v(L K),
which is not zero, annihilates the rows of the stabilizability matrix. The
paper writes this part with S in the place of -S.

Two solutions differ by P1 - P2 = (L2 A)(P1 - P2)(L1 A)' (appendix B), which
iterates to zero if both LA are stable. The filter with the constant gains of
the solution has an error covariance W that is never smaller than that of the
optimal filter and never smaller than P if it starts so; W - P = (LA)^j (W0 -
P)(LA)'^j tends to zero. The covariance that starts at zero bounds from below.

Complex eigenvalues and eigenvectors are written by their real and imaginary
parts: lam = a + ib, v = v1 + iv2.
"""

from __future__ import annotations

from exactkf.claims import claim, repair
from exactkf.evidence import EIGENVALUE, EIGENVECTOR, combination, example, induction, instances, order, restated, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    given,
    hstack,
    iff,
    inv,
    let,
    loewner,
    matrix,
    nonneg,
    nonsingular,
    positive_semidefinite,
    psd,
    rank,
    rec,
    scalar,
    schur,
    standing,
    stein,
    sym,
    symbols,
    symmetric_matrix,
    trace,
    vector,
    vstack,
)
from proofs.nwl92 import notation as two
from proofs.nwl92.notation_system import (
    BOTTOM,
    COVARIANCE,
    F_BLOCK,
    FIRST_TWO,
    GAINS,
    H0,
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
    STABILIZABLE_PAIR,
    STABILIZABLE_PENCIL,
    STEP,
    STEP_GIVEN,
    TWO_DRAWN,
    TWO_FOILS,
    TWO_GAINS,
    TWO_IDENTITIES,
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
    Ka,
    Kb,
    L,
    La,
    Lb,
    Oi,
    Om,
    Oma,
    Omb,
    P,
    Pa,
    Pb,
    Q,
    R,
    S,
    Tb,
    drawn,
    filter_identities,
    identities_of,
    l,
    made_blocks,
    n,
    noise,
    noise_by_form,
    p,
    riccati,
    solutions,
    solved,
    three_block,
)

FILTER = [OMEGA, OMEGA_INVERSE, *GAINS]
GAIN = hstack(L, K)

# ------------------------------------------------------------------ Lemma 4.2
Zd = two.Zd
BRACKET = T(two.lower(two.p, two.n)) * (Zd + Zd * block([[two.R, Zero(two.p, two.n)], [Zero(two.n, two.p), Zero(two.n, two.n)]]) * Zd) \
    * two.lower(two.p, two.n)
LEFT_INVERSE = T(two.lower(two.p, two.n)) * Zd * vstack(two.H, Zero(two.n, two.n))
TWO_GIVEN = [two.ONE_INVERSE, two.GRAM]
claim("NWL92-L4.2", "last block and gain of a (1)-inverse of a 2-block matrix",
      (BRACKET == Zero(two.n, two.n)) & (LEFT_INVERSE == Identity(two.n)),
      sizes=["p", "n"], over=two.SETTING, where=two.PAIR, given=TWO_GIVEN, by=[two.every_size(), two.inverses()])

claim("NWL92-E4.26", "the last block plus the error covariance is zero",
      BRACKET == Zero(two.n, two.n),
      sizes=["p", "n"], over=two.SETTING, where=two.PAIR, given=TWO_GIVEN, by=[two.every_size(), two.inverses()])

claim("NWL92-E4.27", "the gain is a left inverse of H",
      LEFT_INVERSE == Identity(two.n),
      sizes=["p", "n"], over=two.SETTING, where=two.PAIR, given=TWO_GIVEN, by=[two.every_size(), two.inverses()])

# ------------------------------------------------------------------ the Riccati recursion through the gains
THROUGH_GAINS = (L * A) * P * T(L * A) + GAIN * NOISE_G * vstack(T(L), T(K))
NEXT = -(LAST * Oi * BOTTOM)
#: n = l = p = 1, E = A = Q = R = 1, C = S = P = 0
SMALL = {"l": 1, "p": 1, "n": 1, A: [[1]], P: [[0]], Q: [[1]], S: [[0]], R: [[1]], E: [[1]], C: [[0]], sym("W1"): [[0]], sym("W2"): [[0]],
         sym("W3"): [[1]], U1: [[1]], U2: [[0]], Tb: [[-1]]}
#: not admissible: shows what the hypothesis (2.20) is for
NO_INVERSE = example({**SMALL, U1: [[2]]})
claim("NWL92-E4.28", "the Riccati recursion through the gains",
      NEXT == THROUGH_GAINS, sizes=["l", "n", "p"], over=STEP, where=FILTER, given=STEP_GIVEN,
      by=[filter_identities(), NO_INVERSE, drawn()])

claim("NWL92-E4.29", "the gains of the filter",
      (GAIN == LAST * Oi * FIRST_TWO) & (GAIN * F_BLOCK == Identity(n)),
      sizes=["l", "n", "p"], over=STEP, where=FILTER, given=STEP_GIVEN,
      by=[filter_identities(), NO_INVERSE, drawn()],
      note="A definition; what is checked is that the gains, whichever (1)-inverse is taken, make the estimate unbiased.")

xh, y = symbols("xh y")
claim("NWL92-E4.30", "the filter through the gains",
      LAST * Oi * vstack(A * xh, y, Zero(n, 1)) == L * A * xh + K * y,
      sizes=["l", "n", "p"], over={**STEP, xh: vector(n), y: vector(p)}, where=FILTER, given=[standing("(2.20)", Om * Oi * Om == Om)],
      by=[drawn()], note="The left side is (3.4).")

claim("NWL92-E4.31", "the algebraic Riccati equation through the gains",
      iff(P == NEXT, P == THROUGH_GAINS), sizes=["l", "n", "p"], over=STEP, where=FILTER, given=[ONE_INVERSE, NOISE, IMPLIED_RANK],
      by=[filter_identities(), solutions(), drawn()])

claim("NWL92-E4.32", "the gains that belong to P",
      (GAIN == LAST * Oi * FIRST_TWO) & (GAIN * (F_BLOCK * xh) == xh),
      sizes=["l", "n", "p"], over={**STEP, xh: vector(n)}, where=FILTER, given=STEP_GIVEN,
      by=[filter_identities(), example({**SMALL, U1: [[2]], xh: [1]}), drawn()],
      note="A definition; what is checked is that the gains reproduce x from (E; C)x.")

# ------------------------------------------------------------------ the error of the filter
claim("NWL92-E4.38", "LE = I - KC",
      L * E == Identity(n) - K * C, sizes=["l", "n", "p"], over=STEP, where=FILTER, given=STEP_GIVEN,
      by=[filter_identities(), NO_INVERSE, drawn()])

x0, x1, u, r = symbols("x0 x1 u r")
claim("NWL92-E4.39", "recursion for the error",
      x1 - (L * A * xh + K * y) == L * A * (x0 - xh) + L * u - K * r,
      sizes=["l", "n", "p"],
      over={A: matrix(l, n), E: matrix(l, n), C: matrix(p, n), L: matrix(n, l), K: matrix(n, p), x0: vector(n), x1: vector(n),
            xh: vector(n), y: vector(p), u: vector(l), r: vector(p)},
      given=[given("(4.1)", E * x1 == A * x0 + u), given("(4.2)", y == C * x1 + r), given("(4.38)", L * E == Identity(n) - K * C)],
      by=[instances(made_by={u: E * x1 - A * x0, y: C * x1 + r, sym("H0"): inv(T(E) * E + T(C) * C), L: sym("H0") * T(E), K: sym("H0") * T(C)},
                    l=(1, 2), n=(1, 2), p=(1, 2))],
      note="x0, x1 are x(k), x(k+1); xh the estimate of x(k), that of x(k+1) is (4.37).")

# ------------------------------------------------------------------ LA is stable
a, b, v1, v2 = symbols("a b v1 v2")
RICCATI = given("(4.31)", P == THROUGH_GAINS)
EIGEN = [given("(4.40), real part", v1 * (L * A) == a * v1 - b * v2), given("(4.40), imaginary part", v2 * (L * A) == b * v1 + a * v2)]
VECTOR = {a: scalar(), b: scalar(), v1: matrix(1, n), v2: matrix(1, n)}
PRINTED_G = block([[Q, S], [T(S), R]])
S_SIGN = "S must have the sign it has in (4.31)"
#: E = 2, C = -1, Q = S = R = 1, P = 0: the sum of both equations is free of noise, L = K = 1, LA = A
NOISELESS = {"l": 1, "p": 1, "n": 1, P: [[0]], Q: [[1]], S: [[1]], R: [[1]], E: [[2]], C: [[-1]], sym("W1"): [[1]], sym("W2"): [[2]],
             sym("W3"): [[4]], U1: [[1]], U2: [[1]], Tb: [[0]], b: 0, v1: [[1]], v2: [[0]]}
UNIT = sym("Unit")
UNIT_TERMS = [v * T(v) for v in (v1, v2)] + [(a * a + b * b - 1) * v * UNIT * T(v) for v in (v1, v2)]
X0 = sym("X0")
claim("NWL92-E4.40", "a left eigenvector of LA with |lam| >= 1 is there only if LA is not stable",
      (v1 == Zero(1, n)) & (v2 == Zero(1, n)), sizes=["l", "n"], over={A: matrix(l, n), L: matrix(n, l), **VECTOR},
      given=[given("LA stable", schur(L * A)), *EIGEN, given("|lam| >= 1", a * a + b * b >= 1)],
      by=[order(UNIT_TERMS, UNIT_TERMS, inside=[within(number, solutions={UNIT: (L * A, Identity(n))}) for number in (0, 1)]),
          *[example({"l": 1, "n": 1, A: [[1]], L: [[x]], a: y, b: 0, v1: [[z]], v2: [[1 - z]]}) for x in (0, 1) for y in (0, 1) for z in (0, 1)],
          example({"l": 1, "n": 1, A: [[0]], L: [[0]], a: 1, b: 0, v1: [[1]], v2: [[0]]}), example({"l": 1, "n": 1, A: [[0]], L: [[0]], a: 1, b: 0, v1: [[0]], v2: [[1]]}),
          instances(made_by={L: X0 * (1 / (1 + trace(A * T(A)) + trace(X0 * T(X0)))), v1: Zero(1, n), v2: Zero(1, n)}, using={X0: matrix(n, l)}, l=(1, 2), n=(1, 2))],
      note=("The assumption of a proof. That a matrix which is not stable has such an eigenvector is the definition of stability; what is checked is that a "
            "stable one has none, so that the assumption says no less than that LA is not stable."))


a0, b0, B0 = symbols("a0 b0 B0")
NORM = 1 + a0 * a0 + b0 * b0
DRAWN_VECTOR = {v1: T(two.upper(1, 1)) * inv(B0), v2: T(two.lower(1, 1)) * inv(B0)}


def eigenvalues(drawn_by, unstable, also=None):
    """Instances with a real eigenvalue for n = 1 and a complex one for n = 2; ``drawn_by`` takes the matrix LA is to be similar to."""
    outside = 1 + a0 * a0 if unstable else a0 * (1 / NORM)
    free = {a0: scalar(), b0: scalar()}
    return [drawn_by(Identity(1) * a, made_by=also, before={a: outside, b: 0 * b0}, using=free, count=8, l=(1, 2), n=1),
            drawn_by(block([[a, -b], [b, a]]), made_by={**DRAWN_VECTOR, **(also or {})}, before={a: outside, b: b0 * (1 if unstable else 1 / NORM)},
                     using=free, count=8, l=2, n=2)]


V, M0 = symbols("V M0")


def noiseless(similar, *, made_by=None, before=None, using=None, **sizes):
    """Systems with the solution P = 0 for which LA is similar to the given matrix, with l >= n."""
    frame, gain = V * vstack(Identity(n), Zero(l + p - n, n)), hstack(Identity(n), Zero(n, l + p - n)) * inv(V) * two.upper(l, p)
    whole = V * block([[Zero(n, n), Zero(n, l + p - n)], [Zero(l + p - n, n), M0]]) * T(V)
    made = {P: Zero(n, n), E: T(two.upper(l, p)) * frame, C: T(two.lower(l, p)) * frame, Q: T(two.upper(l, p)) * whole * two.upper(l, p),
            S: -T(two.upper(l, p)) * whole * two.lower(l, p), R: T(two.lower(l, p)) * whole * two.lower(l, p),
            A: T(gain) * inv(gain * T(gain)) * B0 * similar * inv(B0)}
    return drawn(before={**(before or {}), **made}, made_by=made_by, noise=False,
                 using={V: nonsingular(l + p), M0: positive_semidefinite(l + p - n), B0: nonsingular(n), **(using or {})}, **sizes)


def contracting(similar, *, made_by=None, before=None, using=None, **sizes):
    """The systems of `solutions` for which LA is similar to the given matrix."""
    return solutions(similar=similar, made_by=made_by, before=before, using=using, **sizes)


def reproducing(similar, *, made_by=None, before=None, using=None, **sizes):
    """Systems with a left inverse (L K) of (E; C) for which LA is similar to the given matrix, with l >= n."""
    frame, gain = V * vstack(Identity(n), Zero(l + p - n, n)), hstack(Identity(n), Zero(n, l + p - n)) * inv(V)
    made = {E: T(two.upper(l, p)) * frame, C: T(two.lower(l, p)) * frame, L: gain * two.upper(l, p), K: gain * two.lower(l, p),
            A: T(L) * inv(L * T(L)) * B0 * similar * inv(B0)}
    return instances(made_by={**(before or {}), **made, **(made_by or {})}, using={V: nonsingular(l + p), B0: nonsingular(n), **(using or {})},
                     **{"p": (1, 2), **sizes})


def quadratic(middle):
    """v middle v* of a symmetric matrix, for v = v1 + iv2."""
    return v1 * middle * T(v1) + v2 * middle * T(v2)


EIGEN_OVER = {**STEP, **VECTOR}
EIGEN_GIVEN = [ONE_INVERSE, NOISE, IMPLIED_RANK, RICCATI, *EIGEN]
W_1, W_2, Z_1, Z_2 = v1 * (L * A), v2 * (L * A), a * v1 - b * v2, b * v1 + a * v2
REAL, IMAGINARY = "(4.40), real part", "(4.40), imaginary part"
LYAPUNOV = [(v1, "(4.31)", T(v1)), (v2, "(4.31)", T(v2)), (1, REAL, P * T(W_1)), (Z_1 * P, REAL + "'", 1),
            (1, IMAGINARY, P * T(W_2)), (Z_2 * P, IMAGINARY + "'", 1)]
#: not admissible: what (4.31), both parts of (4.40) and |lam| >= 1 are for
ALONE = {**SMALL, A: [[0]], P: [[1]], a: 1, b: 0, v1: [[1]], v2: [[0]]}
FOILS = [example({**SMALL, a: 1, b: 0, v1: [[1]], v2: [[0]]}), example(ALONE), example({**ALONE, v1: [[0]], v2: [[1]]}),
         example({**ALONE, a: 0})]
claim("NWL92-E4.41", "the solution of the Riccati equation along an eigenvector",
      (1 - (a * a + b * b)) * quadratic(P) == quadratic(GAIN * PRINTED_G * vstack(T(L), T(K))),
      sizes=["l", "n", "p"], over=EIGEN_OVER, where=FILTER, given=EIGEN_GIVEN,
      by=[example({**NOISELESS, A: [[1]], a: 1}), example({**NOISELESS, A: [["1/2"]], a: "1/2"}), *eigenvalues(contracting, False)],
      repair=repair("sign", S_SIGN,
                    (1 - (a * a + b * b)) * quadratic(P) == quadratic(GAIN * NOISE_G * vstack(T(L), T(K))),
                    sizes=["l", "n", "p"], over=EIGEN_OVER, where=FILTER,
                    given=[standing("(2.20)", Om * Oi * Om == Om), NOISE, IMPLIED_RANK, RICCATI, *EIGEN],
                    by=[combination(LYAPUNOV, l=(1, 2), n=(1, 2), p=1), *FOILS,
                        *eigenvalues(contracting, False), *eigenvalues(noiseless, True)]))

UNSTABLE = given("|lam| >= 1", a * a + b * b >= 1)
#: |lam| >= 1: all terms of (4.41) on one side, each of them nonnegative
ALL_TERMS = quadratic(GAIN * NOISE_G * vstack(T(L), T(K))) + (a * a + b * b - 1) * quadratic(P)
FLIP = block([[Identity(l), Zero(l, p)], [Zero(p, l), -Identity(p)]])
TERMS = [v * GAIN * FLIP * PRINTED_G * FLIP * T(GAIN) * T(v) for v in (v1, v2)] + [(a * a + b * b - 1) * v * P * T(v) for v in (v1, v2)]
claim("NWL92-E4.42", "v(L K) annihilates the noise",
      (v1 * GAIN * PRINTED_G == Zero(1, l + p)) & (v2 * GAIN * PRINTED_G == Zero(1, l + p)),
      sizes=["l", "n", "p"], over=EIGEN_OVER, where=FILTER, given=[*EIGEN_GIVEN, UNSTABLE],
      by=[example({**NOISELESS, A: [[1]], a: 1}), *eigenvalues(noiseless, True)],
      repair=repair("sign", S_SIGN,
                    (v1 * GAIN * NOISE_G == Zero(1, l + p)) & (v2 * GAIN * NOISE_G == Zero(1, l + p)),
                    sizes=["l", "n", "p"], over=EIGEN_OVER, where=FILTER,
                    given=[standing("(2.20)", Om * Oi * Om == Om), NOISE, IMPLIED_RANK, RICCATI, *EIGEN, UNSTABLE],
                    by=[order([], TERMS, TERMS, lemmas=[ALL_TERMS * Identity(1) == Zero(1, 1)]),
                        *FOILS, *eigenvalues(noiseless, True), *eigenvalues(contracting, False)]),
      note="The scan has hyphens between the blocks of these matrices; they are read as space, as in (4.47).")

claim("NWL92-E4.43", "lam vLE",
      (Z_1 * L * E == v1 * (L * A) - Z_1 * K * C) & (Z_2 * L * E == v2 * (L * A) - Z_2 * K * C),
      sizes=["l", "n", "p"],
      over={A: matrix(l, n), E: matrix(l, n), C: matrix(p, n), L: matrix(n, l), K: matrix(n, p), **VECTOR},
      given=[given("(4.38)", L * E == Identity(n) - K * C), *EIGEN],
      by=[combination([[(Z_1, "(4.38)", 1), (-1, REAL, 1)], [(Z_2, "(4.38)", 1), (-1, IMAGINARY, 1)]], l=(1, 2), n=(1, 2), p=(1, 2)),
          *eigenvalues(reproducing, True), *eigenvalues(reproducing, False)])

REAL_PART, IMAGINARY_PART = vstack(a * E - A, a * C), vstack(b * E, b * C)


def annihilated(noise):
    """v(L K)[lam E - A, noise; lam C] = 0, by real and imaginary part."""
    return ((v1 * GAIN * REAL_PART - v2 * GAIN * IMAGINARY_PART == Zero(1, n)) & (v1 * GAIN * IMAGINARY_PART + v2 * GAIN * REAL_PART == Zero(1, n))
            & (v1 * GAIN * noise == Zero(1, l + p)) & (v2 * GAIN * noise == Zero(1, l + p)))


claim("NWL92-E4.44", "v(L K) annihilates the rows of the stabilizability matrix",
      annihilated(PRINTED_G), sizes=["l", "n", "p"], over=EIGEN_OVER, where=FILTER, given=[*EIGEN_GIVEN, UNSTABLE],
      by=[example({**NOISELESS, A: [[1]], a: 1}), *eigenvalues(noiseless, True)],
      repair=repair("sign", S_SIGN, annihilated(NOISE_G), sizes=["l", "n", "p"], over=EIGEN_OVER, where=FILTER,
                    given=[standing("(2.20)", Om * Oi * Om == Om), NOISE, IMPLIED_RANK, RICCATI, *EIGEN, UNSTABLE],
                    by=[filter_identities([], [], TERMS, TERMS, then=[ALL_TERMS * Identity(1) == Zero(1, 1)]),
                        *FOILS, *eigenvalues(noiseless, True), *eigenvalues(contracting, False)]))

EIGEN_FORMULA = (v1 * (L * A) == Z_1) & (v2 * (L * A) == Z_2)
BOTH_PARTS = Zero(1, l + l)
SQUARES = [v * T(v) for v in (v1, v2)] + [(a * a + b * b - 1) * v * T(v) for v in (v1, v2)]
claim("NWL92-S38", "vL and v(L K) are not zero",
      (hstack(v1 * L, v2 * L) != BOTH_PARTS) & (hstack(v1 * hstack(L, K), v2 * hstack(L, K)) != Zero(1, l + p + l + p)),
      sizes=["l", "n", "p"], over={A: matrix(l, n), L: matrix(n, l), K: matrix(n, p), **VECTOR},
      given=[given("v is not zero", hstack(v1, v2) != Zero(1, n + n)), given("(4.40)", EIGEN_FORMULA), UNSTABLE],
      by=[order(SQUARES, SQUARES),
          example({"l": 1, "n": 1, "p": 1, A: [[0]], L: [[0]], K: [[0]], a: 0, b: 0, v1: [[1]], v2: [[0]]}),
          example({"l": 1, "n": 1, "p": 1, A: [[1]], L: [[0]], K: [[0]], a: 1, b: 0, v1: [[1]], v2: [[0]]}),
          *eigenvalues(reproducing, True)],
      note=("A row vector w other than zero with w[lam E - A, Q, -S; lam C, -S', R] = 0 is what stabilizability rules out for |lam| >= 1. "
            "The sign of S in (4.44) is dealt with there. Real and imaginary part stand side by side."))

#: a left eigenvector (vr + i vi)' of LA with eigenvalue lr + i li outside the open disc
(vr, vi), (lr, li) = EIGENVECTOR, EIGENVALUE
EXCESS = lr * lr + li * li - 1


def stable_gains(*solved_by, unique=None):
    """LA is stable for each (P, blocks of its (1)-inverse, L, K) that solves (4.31); then the conclusion, an equation perhaps ``unique`` as in `within`.

    For an eigenvector v outside the open disc the Riccati equation makes v(L K)G zero, and v(L K)(lam F - K) = lam v - vLA = 0: so v(L K) = 0 by
    stabilizability, and lam v = vLA = 0.
    """
    identities, needs, inside = identities_of([(solution, blocks) for solution, blocks, *_ in solved_by], n)
    for number, (solution, _, first, second) in enumerate(solved_by, len(identities)):
        gain = hstack(first, second)
        noise = [T(v) * gain * FLIP * PRINTED_G * FLIP * T(gain) * v for v in (vr, vi)] + [EXCESS * T(v) * solution * v for v in (vr, vi)]
        energy = sum((T(v) * gain * NOISE_G * T(gain) * v for v in (vr, vi)), EXCESS * (T(vr) * solution * vr + T(vi) * solution * vi))
        ends = [T(gain) * v for v in (vr, vi)]
        inside.append(within(
            number, energy * Identity(1) == Zero(1, 1), *(T(v) * gain * NOISE_G == Zero(1, l + p) for v in (vr, vi)), hstack(*ends) == Zero(l + p, 2),
            vector="left", pencil=(*STABILIZABLE_PENCIL, lr, li), on=3))
        needs += [[], noise, noise, [], [T(v) * v for v in (vr, vi)] + [EXCESS * T(v) * v for v in (vr, vi)]]
    stable = [schur(first * A) for _, _, first, _ in solved_by]
    if unique is None:
        return order(*needs, lemmas=identities, inside=inside)
    return order(*needs, lemmas=[*identities, *stable], inside=[*inside, within(len(identities) + len(stable), unique=unique)])


#: [lam E - A, Q, -S; lam C, -S', R] in real form, and what v(L K) gives with it
AT_LAM = block([[REAL_PART, NOISE_G, -IMAGINARY_PART, 0 * NOISE_G], [IMAGINARY_PART, 0 * NOISE_G, REAL_PART, NOISE_G]])
BOTH_ENDS = hstack(v1 * GAIN, v2 * GAIN)
POINTWISE = given("stabilizable at (lam, 1)", rank(AT_LAM) == 2 * (l + p))
_lemmas, _needs, _inside = identities_of([(P, INVERSE)], n)
NO_EIGENVECTOR = {
    "says": (v1 == Zero(1, n)) & (v2 == Zero(1, n)), "sizes": ["l", "n", "p"], "over": EIGEN_OVER, "where": FILTER,
    "given": [standing("(2.20)", Om * Oi * Om == Om), NOISE, IMPLIED_RANK, RICCATI, *EIGEN, UNSTABLE, POINTWISE],
    "by": [order(*_needs, [], TERMS, TERMS, [], SQUARES, SQUARES, inside=_inside,
                 lemmas=[*_lemmas, ALL_TERMS * Identity(1) == Zero(1, 1), v1 * GAIN * NOISE_G == Zero(1, l + p), v2 * GAIN * NOISE_G == Zero(1, l + p),
                         BOTH_ENDS == Zero(1, l + p + l + p)]),
           *FOILS, example({**NOISELESS, A: [[1]], a: 1}),
           solutions(8, before={a: 1 + a0 * a0, b: 0 * a0}, made_by={v1: Zero(1, n), v2: Zero(1, n)}, using={a0: scalar()}, l=(1, 2)),
           solutions(8, before={a: 1 - b0, b: 1 + b0}, made_by={v1: Zero(1, n), v2: Zero(1, n)}, using={b0: scalar()}, l=(1, 2))]}
AT_EACH = ("LA is stable if it has no left eigenvector v1 + iv2 other than zero for an eigenvalue lam = a + ib with |lam| >= 1, and stabilizability is full row rank at "
           "each (lam, 1) of these, here in real form.")
claim("NWL92-S37", "LA is stable for every nonnegative solution", **NO_EIGENVECTOR, note=AT_EACH)

# ------------------------------------------------------------------ uniqueness
DIFFERENCE = Pa - Pb
SOLVED = [given("P1 solves (4.31)", riccati(Pa, La, Ka)), given("P2 solves (4.31)", riccati(Pb, Lb, Kb))]
#: E = C = R = 1, A = 2, Q = S = 0: the solutions 3/4 and 0
PAIR_OF_SOLUTIONS = {"l": 1, "p": 1, "n": 1, A: [[2]], E: [[1]], C: [[1]], Q: [[0]], S: [[0]], R: [[1]], Pa: [["3/4"]], Pb: [[0]],
                     **dict(zip(INVERSE, ([["1/4"]], [["-1/4"]], [["1/4"]], [["1/4"]], [["3/4"]], [["-3/4"]]), strict=True)),
                     **dict(zip(OTHER_INVERSE, ([[1]], [[-1]], [[1]], [[1]], [[0]], [[0]]), strict=True))}
#: the same with A = 0, where 0 is the only solution
ONE_SOLUTION = {A: [[0]], **dict(zip(INVERSE, ([[1]], [[-1]], [[1]], [[1]], [[0]], [[0]]), strict=True)), }
MADE_ONCE, FREE_ONCE = solved()
SAME = instances(6, made_by={**MADE_ONCE, Pa: P, Pb: P, **made_blocks(Oma)[0], **made_blocks(Omb, OTHER_INVERSE, Y2)[0]},
                 using={**FREE_ONCE, **made_blocks(Oma)[1], **made_blocks(Omb, OTHER_INVERSE, Y2)[1], H0: matrix(l + p, l + p),
                        P: positive_semidefinite(n)}, l=(1, 2), p=1, n=(1, 2))
claim("NWL92-S39", "there is at most one nonnegative solution",
      Pa == Pb, sizes=["l", "n", "p"], over=TWO_OVER, where=[*TWO_LETS, *TWO_GAINS],
      given=[*TWO_STANDING, *SOLVED, NOISE, IMPLIED_RANK, STABILIZABLE_PAIR],
      by=[stable_gains((Pa, INVERSE, La, Ka), (Pb, OTHER_INVERSE, Lb, Kb), unique=(Lb * A, T(La * A))),
          example(PAIR_OF_SOLUTIONS),
          *[example({**PAIR_OF_SOLUTIONS, **ONE_SOLUTION, Pa: [[c]], Pb: [[1 - c]]}) for c in (1, 0)], SAME],
      note="Full column rank of (E; C) is what is needed of detectability.")

claim("NWL92-E4.45", "difference of two solutions",
      DIFFERENCE == (Lb * A) * DIFFERENCE * T(La * A), sizes=["l", "n", "p"], over=TWO_OVER, where=[*TWO_LETS, *TWO_GAINS],
      given=[*TWO_INVERSES, *SOLVED, NOISE, IMPLIED_RANK], by=[filter_identities(of=TWO_IDENTITIES), *TWO_FOILS, *TWO_DRAWN])

M1, M2, D, D0, X, t, X0, X1, e0 = symbols("M1 M2 D D0 X t X0 X1 e0")
BOTH_STABLE = [given("L1 A stable", schur(M1)), given("L2 A stable", schur(M2))]
Pow1, Pow2 = symbols("Pow1 Pow2")
claim("NWL92-E4.46", "iterating (4.45)",
      always(t, D[t] == Pow2[t] * D0 * T(Pow1[t])) & (X == Zero(n, n)), sizes=["n"],
      over={M1: matrix(n, n), M2: matrix(n, n), D0: matrix(n, n), X: matrix(n, n)},
      where=[rec(D, t, D0, M2 * D[t] * T(M1)), rec(Pow1, t, Identity(n), M1 * Pow1[t]), rec(Pow2, t, Identity(n), M2 * Pow2[t])],
      given=[*BOTH_STABLE, given("(4.45)", X == M2 * X * T(M1))],
      by=[induction(base=[order(), order(inside=[within(0, unique=(M2, T(M1)))])], step=order()),
          example({"n": 1, M1: [[2]], M2: [["1/2"]], D0: [[1]], X: [[1]]}), example({"n": 1, M1: [["1/2"]], M2: [[2]], D0: [[1]], X: [[1]]}),
          instances(made_by={M1: X0 * (1 / (1 + trace(X0 * T(X0)))), M2: X1 * (1 / (1 + trace(X1 * T(X1)))), X: Zero(n, n)},
                    using={X0: matrix(n, n), X1: matrix(n, n)}, horizon=3, n=(1, 2))],
      note=("M1 and M2 stand for L1 A and L2 A, Pow1 and Pow2 for their powers; D[t] is what iterating X -> M2 X M1' makes of D0, for any D0. "
            "X stands for P1 - P2: by (4.45) iterating leaves it as it is, so that it is its own limit, and this is zero."))

# ------------------------------------------------------------------ convergence
Pt, Pz, Wt, P0, Wn = symbols("Pt Pz Wt P0 Wn")


def next_covariance(P):
    """One step of the Riccati recursion."""
    return -(LAST * inv(three_block(P)) * BOTTOM)


OPTIMAL = rec(Pt, t, P0, next_covariance(Pt[t]))
FROM_ZERO = rec(Pz, t, Zero(n, n), next_covariance(Pz[t]))
Py = sym("Py")
LG = {A: matrix(l, n), E: matrix(l, n), C: matrix(p, n), Q: symmetric_matrix(l), S: matrix(l, p), R: symmetric_matrix(p), L: matrix(n, l),
      K: matrix(n, p)}
UNBIASED = given("(4.38)", L * E + K * C == Identity(n))


def constant_gain(W):
    """Error covariance one step later with constant gains."""
    return (L * A) * W * T(L * A) + hstack(L, K) * NOISE_G * vstack(T(L), T(K))


def best(P):
    """Gains (L K) of the filter, as one factor."""
    return T(T(LAST * inv(three_block(P)) * FIRST_TWO))


def error_of(gain, P):
    """Error covariance with these gains."""
    return gain * noise_by_form(P, n) * T(gain)


def later(P, smaller):
    """By how much the next covariance is larger, in terms that are semidefinite by their form."""
    through = T(T(best(P) * vstack(A, Zero(p, n))))
    return [through * (P - smaller) * T(through), error_of(best(P) - best(smaller), smaller)]


def own_error(P):
    """The next covariance as that of the filter's own error, in a list of terms."""
    return [error_of(best(P[t]), P[t])]


ERROR_1 = [error_of(best(Zero(n, n)), Zero(n, n))]
CLOSED = T(T(L * A))
#: systems with the solution P and the gains that belong to it
SOLVED_GAINS = {**solved()[0], L: hstack(Identity(n), Zero(n, l + p - n)) * inv(sym("V")) * two.upper(l, p),
                K: hstack(Identity(n), Zero(n, l + p - n)) * inv(sym("V")) * two.lower(l, p)}
claim("NWL92-S40", "the covariance from zero is increasing, below the solution, and below that from any start",
      always(t, loewner(Pt[t], Pz[t])) & always(t, loewner(P, Pz[t])) & always(t, loewner(Py[t], Pz[t])), sizes=["l", "n", "p"],
      over={**LG, P: positive_semidefinite(n), P0: positive_semidefinite(n)},
      where=[OPTIMAL, FROM_ZERO, rec(Py, t, next_covariance(Zero(n, n)), next_covariance(Py[t]))],
      given=[NOISE, UNBIASED, given("(4.31)", P == constant_gain(P))],
      by=[restated("an increasing bounded sequence of symmetric matrices converges", "its limit solves the Riccati equation (NWL92-S29), which has one solution (NWL92-S39)"), induction(also=[[psd(Pz[t]), psd(Pt[t])], [psd(Pz[t])], [psd(Pz[t]), psd(Py[t])]],
                    base=[order([], [], [P0]), order([], [P]), order([], ERROR_1, ERROR_1)],
                    step=[order(own_error(Pz), own_error(Pt), later(Pt[t], Pz[t])),
                          order(own_error(Pz), [CLOSED * (P - Pz[t]) * T(CLOSED), error_of(hstack(L, K) - best(Pz[t]), Pz[t])]),
                          order(own_error(Pz), own_error(Py), later(Py[t], Pz[t]))]),
          instances(8, made_by=SOLVED_GAINS, using=solved()[1], horizon=3, l=(1, 2), p=(1, 2), n=(1, 2))],
      note=("Pz is the covariance from P_0 = 0, Py the same one step later, Pt that from any P_0; L, K are gains with LE + KC = I, those of the solution "
            "among them. Increasing and bounded by P, Pz converges; its limit is a solution, and P is the only one (NWL92-S39)."))

e, f, Mx, Mz, Pj, Pzj, Wj = symbols("e f Mx Mz Pj Pzj Wj")
SANDWICH = [given("P_j^0 <= P_j", loewner(Pj, Pzj)), given("P_j <= W_j", loewner(Wj, Pj)), given("W_j near P", loewner(P + e * Mx, Wj)),
            given("P_j^0 near P", loewner(Pzj, P - f * Mz))]
OPTIMAL_GAINS = given("(2.25) for P", noise(P) * vstack(T(L), T(K)) == F_BLOCK * P)
claim("NWL92-S41", "what lies between two sequences that tend to P tends to P, and how the lower one does",
      (P - next_covariance(Pzj) == (L * A) * (P - Pzj) * T(best(Pzj) * vstack(A, Zero(p, n)))) & loewner(P + e * Mx, Pj) & loewner(Pj, P - f * Mz),
      sizes=["l", "n", "p"],
      over={**LG, P: symmetric_matrix(n), Pj: symmetric_matrix(n), Pzj: symmetric_matrix(n), Wj: symmetric_matrix(n), Mx: positive_semidefinite(n),
            Mz: positive_semidefinite(n), e: nonneg(), f: nonneg()},
      given=[UNBIASED, OPTIMAL_GAINS, *SANDWICH],
      by=[restated("a sequence converges if it lies within bounds that do", "a product of matrices that tend to a stable one tends to zero exponentially fast"), order([], [P + e * Mx - Wj, Wj - Pj], [Pj - Pzj, Pzj - (P - f * Mz)]),
          instances(12, made_by={**SOLVED_GAINS, Wj: P + e * Mx - X1 * T(X1), Pzj: Wj - H0, Pj: Pzj + H0 * (1 / (1 + e0 * e0))},
                    using={**solved()[1], P: positive_semidefinite(n), X1: matrix(n, 1), H0: positive_semidefinite(n), e0: scalar()},
                    l=(1, 2), p=(1, 2), n=(1, 2)),
          instances(8, made_by={**SOLVED_GAINS, Wj: P + e * Mx, Pzj: P - f * Mz, Pj: P}, using=solved()[1], l=2, p=(1, 2), n=2)],
      note=("At each j, Pzj for P_j^0: e stands for c rho^j, f for what tends to zero as P_j^0 tends to P. So P_j tends to P, and from above as fast as W_j. "
            "From below it is as fast as P_j^0, of which the paper says no more than that it tends to P. The first equation, by the argument of appendix B, "
            "gives a rate: P - P_j^0 is (LA)^j P times the transposed product of the matrices L_i A, and these tend to the stable LA as P_i^0 tends to P."))

CONSTANT = rec(Wt, t, P0, constant_gain(Wt[t]))
CLOSED_W = CLOSED * (Wt[t] - Pt[t]) * T(CLOSED)
claim("NWL92-S42", "the filter with constant gains is never better than the optimal one",
      always(t, loewner(Wt[t], Pt[t])), sizes=["l", "n", "p"],
      over={**LG, P0: positive_semidefinite(n)}, where=[OPTIMAL, CONSTANT],
      given=[NOISE, UNBIASED],
      by=[induction(also=[psd(Pt[t])], step=order([error_of(best(Pt[t]), Pt[t])], [CLOSED_W, error_of(hstack(L, K) - best(Pt[t]), Pt[t])])),
          instances(8, made_by={**RANDOM_NOISE, sym("Hi"): inv(T(E) * E + T(C) * C), L: sym("Hi") * T(E) + X0 * (Identity(l) - E * sym("Hi") * T(E)),
                                K: sym("Hi") * T(C) - X0 * E * sym("Hi") * T(C)},
                    using={X0: matrix(n, l), **RANDOM_NOISE_FREE}, horizon=3, l=(1, 2), p=(1, 2), n=(1, 2))],
      note="L and K are any gains with LE + KC = I, those of the steady-state filter among them (NWL92-E4.38).")

W = sym("W")
MISSING = "the last factor is (L'; K'); the transposes are missing, and without them the sizes do not even fit unless n = l = p"
#: C = R-free coordinates of two states 2x, x/2: the steady gains are L, K
STEADY = {"l": 2, "p": 2, "n": 2, A: [[2, -2], [0, "1/2"]], Q: [[0, 0], [0, 0]], S: [[0, 0], [0, 0]], R: [[2, 1], [1, 1]], L: [["1/4", 1], [0, 1]],
          K: [["3/4", "-3/4"], [0, 0]], W: [[0, 0], [0, 0]], Wn: [["3/4", 0], [0, 0]], P: [["3/4", 0], [0, 0]]}
ERROR_MAP = hstack(L * A, L, -K)
ERROR_NOISE = block([[W, Zero(n, l), Zero(n, p)], [Zero(l, n), Q, S], [Zero(p, n), T(S), R]])
ERROR_NEXT = ERROR_MAP * ERROR_NOISE * T(ERROR_MAP)
ERROR_OVER = {A: matrix(l, n), Q: symmetric_matrix(l), S: matrix(l, p), R: symmetric_matrix(p), L: matrix(n, l), K: matrix(n, p), W: positive_semidefinite(n)}


def printed_gain(W):
    """Right side of (4.47) as printed."""
    return (L * A) * W * T(L * A) + hstack(L, K) * NOISE_G * vstack(L, K)


UNIT, RATE, BOUND, c, d, D_ = symbols("Dn rate B c d D")
#: covariance of (L -K)(u; r)
DRIVEN = hstack(L, -K) * COVARIANCE * T(hstack(L, -K))
#: terms that show how far W_0 and UNIT are below multiples of the identity
ABOVE_START = [trace(W + Wn) * Identity(n) - (W + Wn), c * (L * A) * UNIT * T(L * A)]
ABOVE_UNIT = trace(UNIT) * Identity(n) - UNIT
DECAY = RATE * BOUND[t] - (L * A) * BOUND[t] * T(L * A)
KEPT_WITHIN = [[L * A * excess * T(A) * T(L), DECAY] for excess in (BOUND[t] - (Wt[t] - Wn), BOUND[t] - (Wn - Wt[t]))]
E447_PROOF = induction(
    also=[[], [], [], [psd(DECAY)], [], []],
    base=[order(), order(), order(inside=[within(0, unique=(L * A, T(L * A)))]),
          order([c / (1 + d) * ABOVE_UNIT, c / (1 + d) * Identity(n)], [*ABOVE_START, 2 * Wn], [*ABOVE_START, 2 * W]), order([ABOVE_UNIT]), order([1 / (1 + d) * Identity(1)])],
    step=[order(), order(), order(), order([RATE * DECAY], *KEPT_WITHIN), order(), order()])
SLOW = X0 * (1 / (1 + trace(T(L) * L) * trace(T(X0) * X0)))
claim("NWL92-E4.47", "error covariance with constant gains, as printed without transposes",
      ERROR_NEXT == printed_gain(W), sizes=["l", "n", "p"], over=ERROR_OVER, given=[NOISE],
      by=[example(STEADY), instances(made_by=RANDOM_NOISE, using=RANDOM_NOISE_FREE, l=2, n=2, p=2)],
      repair=repair("other", MISSING,
                    (ERROR_NEXT == constant_gain(W)) & psd(Wn) & iff(D_ == constant_gain(D_), D_ == Wn)
                    & always(t, loewner(BOUND[t], Wt[t] - Wn) & loewner(BOUND[t], Wn - Wt[t])) & loewner(d * Identity(n), UNIT) & (RATE < 1),
                    sizes=["l", "n", "p"], over={**ERROR_OVER, D_: symmetric_matrix(n)},
                    where=[let(UNIT, stein(L * A, Identity(n))), let(Wn, stein(L * A, DRIVEN)), let(c, trace(W + Wn)), let(d, trace(UNIT)), let(RATE, d / (1 + d)),
                           rec(Wt, t, W, constant_gain(Wt[t])), rec(BOUND, t, c * UNIT, RATE * BOUND[t])],
                    given=[NOISE, standing("LA stable", schur(L * A))],
                    by=[E447_PROOF, example({**STEADY, W: [[1, 0], [0, 2]], D_: [[0, 0], [0, 0]]}), example({**STEADY, W: [[1, 0], [0, 2]], D_: [[1, 0], [0, 0]]}),
                        instances(16, made_by={**RANDOM_NOISE, A: SLOW}, using={**RANDOM_NOISE_FREE, X0: matrix(l, n)}, horizon=3, l=(1, 2), n=(1, 2), p=(1, 2)),
                        instances(8, made_by={**RANDOM_NOISE, A: SLOW, D_: Wn}, using={**RANDOM_NOISE_FREE, X0: matrix(l, n)},
                                  horizon=3, l=(1, 2), n=(1, 2), p=(1, 2))]),
      note=("The left side is the covariance of the error (4.39). The second part of the corrected statement is the convergence: stein(M, N) is the solution of "
            "X = MXM' + N. D is that for N = I, c and d are traces, and the distance of W_t from the solution Wn of (4.48), the only one, which is nonnegative, is "
            "at most c(d/(1 + d))^t D, which is at most cd(d/(1 + d))^t I."))

claim("NWL92-E4.48", "the limit of the error covariance with constant gains, as printed without transposes",
      iff(W == printed_gain(W), W == P), sizes=["l", "n", "p"], over={**ERROR_OVER, P: positive_semidefinite(n)},
      given=[given("(4.31)", P == constant_gain(P)), given("LA stable", schur(L * A))],
      by=[example({**STEADY, W: [["3/4", 0], [0, 0]]}), instances(l=2, n=2, p=2)],
      repair=repair("other", MISSING, iff(W == constant_gain(W), W == P), sizes=["l", "n", "p"], over={**ERROR_OVER, P: positive_semidefinite(n)},
                    given=[given("(4.31)", P == constant_gain(P)), given("LA stable", schur(L * A))],
                    by=[order(inside=[within(number, unique=(L * A, T(L * A))) for number in (0, 1)]),
                        example({**STEADY, A: [[0, 0], [0, 0]], W: [[0, 0], [0, 0]], P: [[1, 0], [0, 1]]}),
                        example({"l": 1, "n": 1, "p": 1, A: [[1]], Q: [[0]], S: [[0]], R: [[0]], L: [[1]], K: [[0]], W: [[1]], P: [[0]]}),
                        example({**STEADY, W: [["3/4", 0], [0, 0]]}), example({**STEADY, W: [["3/4", 0], [0, 1]]}),
                        instances(made_by={**RANDOM_NOISE, A: Zero(l, n), P: constant_gain(W)}, using=RANDOM_NOISE_FREE, l=(1, 2), n=(1, 2), p=(1, 2)),
                        instances(made_by={**RANDOM_NOISE, A: Zero(l, n), P: constant_gain(Zero(n, n)), W: P}, using=RANDOM_NOISE_FREE, l=(1, 2), n=(1, 2), p=(1, 2))]))
