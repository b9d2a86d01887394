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

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import combination, example, identity, induction, instances, order, steps
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    eq,
    given,
    hstack,
    iff,
    inv,
    let,
    loewner,
    matrix,
    nonsingular,
    positive_semidefinite,
    psd,
    rec,
    scalar,
    schur,
    standing,
    sym,
    symbols,
    symmetric_matrix,
    vector,
    vstack,
)
from proofs.nwl92 import notation as two
from proofs.nwl92.notation_system import (
    BOTTOM,
    CERTIFICATES,
    CERTIFIED,
    DETECTABLE,
    DETECTOR,
    F_BLOCK,
    FIRST_TWO,
    GAINS,
    IMPLIED_RANK,
    LAST,
    NOISE,
    NOISE_G,
    OMEGA,
    OMEGA_INVERSE,
    ONE_INVERSE,
    OTHER_INVERSE,
    RANK,
    STABILIZABLE,
    STABILIZER,
    STEP,
    STEP_GIVEN,
    SYSTEM,
    U1,
    U2,
    A,
    C,
    E,
    K,
    L,
    Oi,
    Om,
    P,
    Q,
    R,
    S,
    Tb,
    block_types,
    drawn,
    filter_identities,
    inverse_blocks,
    k,
    l,
    made_blocks,
    n,
    p,
    solutions,
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
not_checked("NWL92-E4.40", "a left eigenvector of LA with |lam| >= 1", "the assumption of a proof: it fixes notation and asserts nothing")


a0, b0, B0 = symbols("a0 b0 B0")
NORM = 1 + a0 * a0 + b0 * b0
EIGENVECTOR = {v1: T(two.upper(1, 1)) * inv(B0), v2: T(two.lower(1, 1)) * inv(B0)}


def eigenvalues(drawn_by, unstable, also=None):
    """Instances with a real eigenvalue for n = 1 and a complex one for n = 2; ``drawn_by`` takes the matrix LA is to be similar to."""
    outside = 1 + a0 * a0 if unstable else a0 * (1 / NORM)
    free = {a0: scalar(), b0: scalar()}
    return [drawn_by(Identity(1) * a, made_by=also, before={a: outside, b: 0 * b0}, using=free, l=(1, 2), n=1),
            drawn_by(block([[a, -b], [b, a]]), made_by={**EIGENVECTOR, **(also or {})}, before={a: outside, b: b0 * (1 if unstable else 1 / NORM)},
                     using=free, l=2, n=2)]


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
      by=[example({**NOISELESS, A: [["1/2"]], a: "1/2"}), *eigenvalues(contracting, False)],
      repair=repair("sign", S_SIGN,
                    (1 - (a * a + b * b)) * quadratic(P) == quadratic(GAIN * NOISE_G * vstack(T(L), T(K))),
                    sizes=["l", "n", "p"], over=EIGEN_OVER, where=FILTER,
                    given=[standing("(2.20)", Om * Oi * Om == Om), NOISE, IMPLIED_RANK, RICCATI, *EIGEN],
                    by=[combination(LYAPUNOV, l=(1, 2), n=(1, 2), p=1), *FOILS,
                        *eigenvalues(contracting, False), *eigenvalues(noiseless, True)]))

UNSTABLE = given("|lam| >= 1", a * a + b * b >= 1)
claim("NWL92-E4.42", "v(L K) annihilates the noise",
      (v1 * GAIN * PRINTED_G == Zero(1, l + p)) & (v2 * GAIN * PRINTED_G == Zero(1, l + p)),
      sizes=["l", "n", "p"], over=EIGEN_OVER, where=FILTER, given=[*EIGEN_GIVEN, UNSTABLE],
      by=[example({**NOISELESS, A: [[1]], a: 1}), *eigenvalues(noiseless, True)],
      repair=repair("sign", S_SIGN,
                    (v1 * GAIN * NOISE_G == Zero(1, l + p)) & (v2 * GAIN * NOISE_G == Zero(1, l + p)),
                    sizes=["l", "n", "p"], over=EIGEN_OVER, where=FILTER,
                    given=[standing("(2.20)", Om * Oi * Om == Om), NOISE, IMPLIED_RANK, RICCATI, *EIGEN, UNSTABLE],
                    by=[*FOILS, *eigenvalues(noiseless, True), *eigenvalues(contracting, False)]),
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
                    by=[*FOILS, *eigenvalues(noiseless, True), *eigenvalues(contracting, False)]))

EIGEN_FORMULA = (v1 * (L * A) == Z_1) & (v2 * (L * A) == Z_2)
NOT_ZERO = (v1 != Zero(1, n)) | (v2 != Zero(1, n))
claim("NWL92-S38", "vL and v(L K) are not zero",
      ((v1 * L != Zero(1, l)) | (v2 * L != Zero(1, l))) & ((v1 * hstack(L, K) != Zero(1, l + p)) | (v2 * hstack(L, K) != Zero(1, l + p))),
      sizes=["l", "n", "p"], over={A: matrix(l, n), L: matrix(n, l), K: matrix(n, p), **VECTOR},
      given=[given("v is not zero", NOT_ZERO), given("(4.40)", EIGEN_FORMULA), UNSTABLE],
      by=[example({"l": 1, "n": 1, "p": 1, A: [[0]], L: [[0]], K: [[0]], a: 0, b: 0, v1: [[1]], v2: [[0]]}),
          example({"l": 1, "n": 1, "p": 1, A: [[1]], L: [[0]], K: [[0]], a: 1, b: 0, v1: [[1]], v2: [[0]]}),
          *eigenvalues(reproducing, True)],
      note=("A row vector w other than zero with w[lam E - A, Q, -S; lam C, -S', R] = 0 is what stabilizability rules out for |lam| >= 1. "
            "The sign of S in (4.44) is dealt with there."))
