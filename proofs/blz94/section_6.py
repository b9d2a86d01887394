# SPDX-License-Identifier: MIT
"""Section 6: the Riccati equation as powers of a symplectic matrix.

With A = F - gh' the Riccati step from P to the next matrix is
gg' + A P (I - hh'P)^(-1) A', and I - hh'P is inverted by a rank-one formula.
Writing gg' over the common denominator (I - hh'P)^(-1)A' turns the step into
a linear fractional one, with the blocks of the symplectic matrix S, so that
P_t = Y_t X_t^(-1) for the solution of a linear system with matrix S.

Equilibria are S-invariant subspaces U = Im(X; Y) of dimension n. If U is
Lagrangian it meets Im(I; 0) in an S-invariant subspace: for z in the null space of Y
the number (g'Xz)(g'A'^(-1)Xz) vanishes, so that one of its factors is zero for all such
z, and then that null space is invariant under R or its inverse, R being the matrix
of S on U. The same holds for the intersection with Im(0; I), which observability
forbids and so makes X nonsingular; in the same way reachability of (A, g), that is a, b
coprime, forbids the first intersection.

At an invariant U the closed loop F - k h' is the transposed inverse of S on U: hence
the roots of the limit polynomial are the inverses of the eigenvalues of S on U.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, fact, generic_index, identity, induction, instances, order, restated, use
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    always,
    block,
    charpoly,
    coeff,
    column,
    eq,
    forall,
    given,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonneg_on_circle,
    nonsingular,
    nonzero,
    pos_on_circle,
    rec,
    recip,
    scalar,
    schur,
    sequence,
    standing,
    sum_of,
    sym,
    symbols,
    symmetric_matrix,
    symplectic,
    to_expr,
    vector,
    vstack,
    when,
)
from proofs.blz94.notation import (
    HALF,
    SHIFT,
    D,
    F,
    J,
    P,
    a0,
    alpha,
    b0,
    g,
    g0,
    h,
    i,
    j,
    k,
    m,
    monic_of,
    n,
    s,
    symmetric_part,
    t,
    u,
)

A, B, S, S11, S12, S21, S22, sigma, X, Y, R, U, V, K, L, N, Q, W = symbols("A B S S11 S12 S21 S22 sigma X Y R U V K L N Q W")
c, d, e, f, l, o, p, q, v, w, x, y, z, Lambda, Gamma, M, E = symbols("c d e f l o p q v w x y z Lambda Gamma M E")

#: A of Proposition 6.4 and the blocks (6.14) of S
CLOSED = (let(A, F - g * T(h)),)
#: sigma and the blocks (6.8), read off the transposed display
SIGMA = (let(sigma, 1 - T(h) * inv(F) * g),)
BLOCKS = (
    *SIGMA,
    let(S11, T(inv(F) + inv(F) * g * T(h) * inv(F) / sigma)), let(S12, T(-(h * T(h) * inv(F)) / sigma)),
    let(S21, T(inv(F) * g * T(g) / sigma)), let(S22, T(T(F) - h * T(g) / sigma)),
)
DATA = {F: nonsingular(n), g: vector(n), h: vector(n)}
SYMMETRIC = {**DATA, P: symmetric_matrix(n)}
ANY_F = {F: matrix(n, n), g: vector(n), h: vector(n), P: symmetric_matrix(n)}
#: one step of (2.2)
STEP_OF_P = F * P * T(F) + (g - F * P * h) / (1 - T(h) * P * h) * T(g - F * P * h)
#: inverse of S11 + S12 P, q being that of 1 - h'Ph
_MINV = T(F) - h * T(g - F * P * h) * q
SIZES = instances(n=(1, 2, 3))
#: n = 2: A, g, h, P with P = E diag(0, f^2) E' a solution of (6.13), from points of the circle with parameters s, v
PAIR_USING = {s: scalar(), v: scalar(), f: nonzero(), u: nonzero(), o: scalar(), d: scalar(), E: nonsingular(n)}
_COS_S, _COS_V = (1 - s**2) / (1 + s**2), (1 - v**2) / (1 + v**2)
PAIR_A = E * matrix_of(i, j, n, n, when(i < n, when(i == j, u, 0), when(j == n, _COS_S * _COS_V, o))) * inv(E)
PAIR_G = E * column(i, n, when(i == n, 2 * s * f / (1 + s**2), 0))
PAIR_H = inv(T(E)) * column(i, n, when(i == n, 2 * v / ((1 + v**2) * f), d))
PAIR_P = E * matrix_of(i, j, n, n, when(i == n, when(j == n, f**2, 0), 0)) * T(E)
#: sigma is not zero, q is its inverse, and then that of A
_Q = given("q sigma = 1", q * sigma == 1)
_AINV = inv(F) + inv(F) * g * T(h) * inv(F) * q

# ---------------------------------------------------------------------- Proposition 6.4
claim("BLZ94-E6.9", "the Riccati operator in terms of A = F - gh'",
      STEP_OF_P - P == A * P * T(A) - P + A * P * h / (1 - T(h) * P * h) * T(h) * P * T(A) + g * T(g), sizes=["n"],
      over=ANY_F, where=CLOSED, by=[order(), SIZES])

claim("BLZ94-E6.10", "A is invertible, with inverse",
      invertible(A) & (inv(A) == inv(F) + inv(F) * g * T(h) * inv(F) * q), sizes=["n"], over={**DATA, q: scalar()},
      where=[*CLOSED, *SIGMA], given=[_Q], by=[order([_AINV], []), instances(n=(1, 2, 3), made_by={q: 1 / (1 - T(h) * inv(F) * g)})],
      note="The text says that A is invertible since F is; this needs sigma != 0 too, which the text asks for before the proposition. q is 1/sigma.")

claim("BLZ94-E6.11", "the inverse of I - hh'P",
      inv(Identity(n) - h * T(h) * P) == Identity(n) + h * T(h) * P / (1 - T(h) * P * h), sizes=["n"],
      over={h: vector(n), P: symmetric_matrix(n)}, by=[order(), SIZES])

_BETWEEN = inv(Identity(n) - h * T(h) * P) * T(A)
claim("BLZ94-S44", "the Riccati step over a common denominator, and the blocks of S",
      eq(STEP_OF_P, g * T(g) + A * P * _BETWEEN, (g * T(g) * inv(T(A)) * (Identity(n) - h * T(h) * P) + A * P) * _BETWEEN)
      & (S11 == inv(T(A))) & (S12 == -(inv(T(A)) * h * T(h))) & (S21 == g * T(g) * inv(T(A)))
      & (S22 == A + (1 - 1 / sigma) * g * T(h)),
      sizes=["n"], over=SYMMETRIC, where=[*CLOSED, *BLOCKS], by=[order(), SIZES])

claim("BLZ94-P6.4", "the Riccati step is linear fractional, with the blocks of a symplectic matrix",
      ((F * P * T(F) + (g - F * P * h) * q * T(g - F * P * h)) * (S11 + S12 * P) == S21 + S22 * P) & invertible(S11 + S12 * P)
      & symplectic(block([[S11, S12], [S21, S22]])), sizes=["n"], over={**SYMMETRIC, q: scalar()}, where=BLOCKS,
      given=[given("q is the inverse of 1 - h'Ph", q * (1 - T(h) * P * h) == 1), standing("sigma != 0", sigma != 0)],
      by=[order([], [_MINV]),
          instances(n=(1, 2, 3), made_by={q: 1 / (1 - T(h) * P * h)})],
      note="The text takes F invertible and sigma not zero. h may be any vector here. The Riccati step, with q for the "
           "inverse of 1 - h'Ph, is multiplied by S11 + S12 P from the right; that this is invertible is shown too, so the "
           "quotient (6.6) exists and equals the step.")

_HAT = block([[Zero(n, n), Identity(n)], [-Identity(n), Zero(n, n)]])
claim("BLZ94-E6.12", "S is symplectic", T(S) * _HAT * S == _HAT, sizes=["n"], over=DATA,
      where=[*BLOCKS, let(S, block([[S11, S12], [S21, S22]]))], by=[order(), SIZES])

claim("BLZ94-C6.5", "the algebraic Riccati equation and the symplectic matrix in terms of A",
      (STEP_OF_P - P == A * P * T(A) + A * P * h / (1 - T(h) * P * h) * T(h) * P * T(A) + g * T(g) - P) & invertible(A)
      & (block([[S11, S12], [S21, S22]]) == block([[inv(T(A)), -(inv(T(A)) * h * T(h))],
                                                   [g * T(g) * inv(T(A)), A + (1 - q) * g * T(h)]])),
      sizes=["n"], over={**SYMMETRIC, q: scalar()}, where=[*CLOSED, *BLOCKS], given=[_Q],
      by=[order([], [_AINV], []), instances(n=(1, 2, 3), made_by={q: 1 / (1 - T(h) * inv(F) * g)})],
      note="The two forms of the equation have the same residual, for every P. q is 1/sigma.")

claim("BLZ94-E6.16", "the Riccati recursion is the linear system with matrix S",
      forall(t, 0, m, (P[t] * X[t] == Y[t]) & invertible(X[t])), sizes=["n", "m"],
      over={**DATA, Q: symmetric_matrix(n), q: sequence(0, m - 1)},
      where=[*BLOCKS, rec(P, t, Q, F * P[t] * T(F) + (g - F * P[t] * h) * q[t] * T(g - F * P[t] * h)),
             rec(X, t, Identity(n), S11 * X[t] + S12 * Y[t]), rec(Y, t, Q, S21 * X[t] + S22 * Y[t])],
      given=[given("q_k is the inverse of 1 - h'P_kh", forall(k, 0, m - 1, q[k] * (1 - T(h) * P[k] * h) == 1)),
             standing("sigma != 0", sigma != 0)],
      by=[induction(also=[P[t] == T(P[t])],
                    step=order([], [], [inv(X[t]) * (T(F) - h * T(g - F * P[t] * h) * q[t])])),
          example(n=1, m=0, F=[[2]], g=[1], h=[1], Q=[[1]], q=[]),
          instances(n=(1, 2), m=(1, 2, 3), made_by={q: (k, 1 / (1 - T(h) * Y[k] * inv(X[k]) * h))})],
      note="Q is P_0; the fast algorithm has Q = 0. As long as the Riccati recursion does not divide by zero, X_t is "
           "invertible, so that P_t is its quotient with Y_t.")

# ---------------------------------------------------------------------- Lemma 6.2
#: n = 1: the orbit that tends to v, through the point with gamma = u (alpha - v)
_ALPHA1 = (1 / v - u**2 * v) / (1 - u**2)
_ORDER_ONE = {P: matrix_of(i, j, n, n, 1 - _ALPHA1 / v), a0: column(i, n, _ALPHA1 - u * (_ALPHA1 - v)),
              g0: column(i, n, u * (_ALPHA1 - v))}
Pa, Pb = symbols("Pa Pb")


def _step(F, g, P):
    """The Riccati recursion (2.2)."""
    return F * P * T(F) + (g - F * P * h) / (1 - T(h) * P * h) * T(g - F * P * h)


_NEXT_B = _step(B, -g, P)
_OTHER_D = symmetric_part(monic_of(b0), monic_of(b0 + 2 * g0))
claim("BLZ94-L6.2.1", "Lemma 6.1 with J - bh' in place of F = J - ah' and nothing else changed",
      nonneg_on_circle(D) | nonneg_on_circle(-D), sizes=["n"], over={a0: vector(n), g0: vector(n)},
      where=[let(b0, a0 + 2 * g0), let(D, symmetric_part(monic_of(a0), monic_of(b0)))],
      given=[given("(b, b + 2g) stable", schur(monic_of(b0))), given("(b, b + 2g) positive", pos_on_circle(_OTHER_D)), standing("alpha_n != 0", a0[n] + g0[n] != 0)],
      by=[example(n=1, abar=[2], gbar=["-9/16"]), instances(n=(1, 2), made_by={a0: column(i, n, w[i] / to_expr(4) ** i), g0: 0 * a0}, using={w: vector(n)})],
      note="A consequence: if the recursion with J - bh' and g converges from zero, so does (4.4), and then D is sign definite (Corollary 5.3). It converges if J - bh' "
           "and g belong to a positive real function, that of b and b + 2g. In the example, n = 1, a = 2, b = 7/8, this is so, but D is not sign definite. "
           "The proof exchanges a and b, which is more than the lemma says: g = (b - a)/2 changes its sign.",
      repair=repair("sign", "With J - bh' in place of F also -g has to take the place of g, and b that of a in (6.2); then the solution from zero is the same for "
                            "every t, P_b = P_a, so are the equilibria, and so is (6.2) at each of them.",
                    always(t, Pb[t] == Pa[t]) & (_NEXT_B == STEP_OF_P) & ((-g - B * P * h) / (1 - T(h) * P * h) + b0 == (g - F * P * h) / (1 - T(h) * P * h) + a0),
                    sizes=["n"], over={J: matrix(n, n), a0: vector(n), g: vector(n), h: vector(n), P: symmetric_matrix(n)},
                    where=[let(b0, a0 + 2 * g), let(F, J - a0 * T(h)), let(B, J - b0 * T(h)),
                           rec(Pa, t, Zero(n, n), _step(F, g, Pa[t])), rec(Pb, t, Zero(n, n), _step(B, -g, Pb[t]))],
                    by=[induction(also=[[Pa[t] == T(Pa[t])], [], []]), SIZES]))

# ---------------------------------------------------------------------- the closed loop, (6.27)-(6.33)
claim("BLZ94-E6.27", "(6.2) written with J in place of F",
      (g - F * P * h) / (1 - T(h) * P * h) + a0 == (a0 + g - J * P * h) / (1 - T(h) * P * h), sizes=["n"],
      over={J: matrix(n, n), a0: vector(n), g: vector(n), h: vector(n), P: symmetric_matrix(n)},
      where=[let(F, J - a0 * T(h))], by=[order(), SIZES])

_INVARIANT = given("(6.28)", block([[S11, S12], [S21, S22]]) * vstack(X, Y) == vstack(X, Y) * Lambda)
claim("BLZ94-E6.29", "the matrix of S on an invariant subspace",
      S11 + S12 * P == X * Lambda * inv(X), sizes=["n"],
      over={S11: matrix(n, n), S12: matrix(n, n), S21: matrix(n, n), S22: matrix(n, n), X: nonsingular(n), Y: matrix(n, n),
            Lambda: matrix(n, n)},
      where=[let(P, Y * inv(X))], given=[_INVARIANT],
      by=[order(), instances(n=(1, 2, 3), made_by={S11: (X * Lambda - S12 * Y) * inv(X), S21: (Y * Lambda - S22 * Y) * inv(X)})])

claim("BLZ94-E6.30", "the inverse of S11' + PS12'",
      inv(T(S11) + P * T(S12)) == F * inv(F + 1 / sigma * (g - F * P * h) * T(h)) * F, sizes=["n"], over=SYMMETRIC, where=BLOCKS,
      by=[order(), identity(n=(1, 2)), SIZES])

claim("BLZ94-E6.31", "the matrix inversion lemma",
      inv(A + B * inv(E) * M) == inv(A) - inv(A) * B * inv(E + M * inv(A) * B) * M * inv(A), sizes=["n", "k"],
      over={A: nonsingular(n), B: matrix(n, k), M: matrix(k, n), E: nonsingular(k)}, by=[order(), instances(n=(1, 2, 3), k=(1, 2))],
      note="E is the D of the text. The first parenthesis of the display is lost.")

claim("BLZ94-E6.32", "S11' + PS12' is the inverse of the closed loop",
      eq(inv(T(S11) + P * T(S12)), F - (g - F * P * h) / (1 - T(h) * P * h) * T(h), J - alpha * T(h)), sizes=["n"],
      over={J: matrix(n, n), a0: vector(n), g: vector(n), h: vector(n), P: symmetric_matrix(n)},
      where=[let(F, J - a0 * T(h)), *BLOCKS, let(alpha, (g - F * P * h) / (1 - T(h) * P * h) + a0)],
      by=[order(), identity(n=(1, 2)), SIZES])

#: the characteristic polynomial of J - vh', coefficient by coefficient
_COMPANION = generic_index(fact(t, "charpoly", charpoly(J - alpha * T(h)) == monic_of(alpha), (j, Z ** (n - j))), uses=[use(0, t=0, z=sym("z"))])
claim("BLZ94-E6.33", "the closed loop on the invariant subspace, and its characteristic polynomial",
      (inv(T(J - alpha * T(h))) * X == X * Lambda) & (charpoly(J - alpha * T(h)) == monic_of(alpha)), sizes=["n"],
      over={alpha: vector(n), a0: vector(n), g: vector(n), X: nonsingular(n), Lambda: matrix(n, n), P: symmetric_matrix(n)},
      where=[*SHIFT, let(F, J - a0 * T(h)), *BLOCKS],
      given=[given("(6.2)", alpha == (g - F * P * h) / (1 - T(h) * P * h) + a0), given("(6.29)", S11 + S12 * P == X * Lambda * inv(X)),
             standing("n >= 1", n >= 1)],
      by=[_COMPANION, instances(n=(1, 2, 3), made_by={alpha: (g - F * P * h) / (1 - T(h) * P * h) + a0, Lambda: inv(X) * (S11 + S12 * P) * X})],
      note="(6.29) follows from (6.28). The matrix is Gamma, and alpha(z) its characteristic polynomial.")

claim("BLZ94-X.5", "the characteristic polynomial of J - vh'", charpoly(J - alpha * T(h)) == monic_of(alpha), sizes=["n"], over={alpha: vector(n)}, where=SHIFT,
      given=[standing("n >= 1", n >= 1)], by=[_COMPANION, instances(n=(1, 2, 3))],
      note="Used for (6.25): the zeros of the limit polynomial are the eigenvalues of the closed loop.")

#: rows x, y that are (z^(n-1), ..., 1) at z and at w = 1/z, and c = z^n, l = w^n
_ROW = (given("x'J = zx' - ch'", T(x) * J == z * T(x) - c * T(h)), given("y'J = wy' - lh'", T(y) * J == w * T(y) - l * T(h)),
        given("w = 1/z", z * w == 1), standing("l = 1/c", c * l == 1))
_XA, _YA = c + T(x) * a0, l + T(y) * a0
_XG, _YG = T(x) * g0 - z * T(x) * P * h + _XA * T(h) * P * h, T(y) * g0 - w * T(y) * P * h + _YA * T(h) * P * h
_AT_1_Z = {w: 1 / z, l: 1 / c}
claim("BLZ94-E8.8", "a solution of (6.1) factors D",
      (1 - T(h) * P * h) * (c + T(x) * alpha) * (l + T(y) * alpha) == HALF * ((c + T(x) * a0) * (l + T(y) * b0) + (l + T(y) * a0) * (c + T(x) * b0)),
      sizes=["n"],
      over={J: matrix(n, n), h: vector(n), a0: vector(n), g0: vector(n), P: symmetric_matrix(n), x: vector(n), y: vector(n),
            z: scalar(), w: scalar(), c: scalar(), l: scalar(), q: scalar()},
      where=[let(b0, a0 + 2 * g0), let(F, J - a0 * T(h)), let(alpha, q * (g0 - F * P * h) + a0)],
      given=[given("q is the inverse of 1 - h'Ph", q * (1 - T(h) * P * h) == 1),
             given("(6.1)", F * P * T(F) - P + q * (g0 - F * P * h) * T(g0 - F * P * h) == Zero(n, n)), *_ROW],
      by=[order(lemmas=[T(x) * F == z * T(x) - _XA * T(h), T(y) * F == w * T(y) - _YA * T(h),
                        T(x) * (g0 - F * P * h) == _XG, T(y) * (g0 - F * P * h) == _YG,
                        T(x) * P * y == T(x) * F * P * T(F) * y + q * _XG * _YG,
                        (1 - T(h) * P * h) * (c + T(x) * alpha) == (1 - T(h) * P * h) * _XA + _XG,
                        (1 - T(h) * P * h) * (l + T(y) * alpha) == (1 - T(h) * P * h) * _YA + _YG]),
          example({J: [[0]], h: [1], a0: [1], g0: [1], P: [[0]], q: 0, z: 2, w: "1/2", c: 2, l: "1/2", x: [1], y: [1]}, n=1),
          instances(n=(1,), using={u: scalar(), v: nonzero()},
                    made_by={**_ORDER_ONE, q: 1 / (1 - P[1, 1]), J: 0 * P, h: column(i, n, 1), x: column(i, n, c / z), y: column(i, n, z / c), **_AT_1_Z}),
          instances(n=(2,), using=PAIR_USING,
                    made_by={h: PAIR_H, g0: PAIR_G, P: PAIR_P, q: 1 / (1 - T(h) * P * h), J: PAIR_A + (g0 + a0) * T(h), **_AT_1_Z,
                             x: -c * T(inv(J - z * Identity(n))) * h, y: -l * T(inv(J - w * Identity(n))) * h}),
          restated("limits: the limit of P_t solves (6.1), and 1 - h'P_th tends to r_infinity", "Proposition 6.6: the eigenvalues of S are the zeros of D")],
      note="x' is the row (z^(n-1), ..., 1), y' the same at w = 1/z, c = z^n and l = w^n; with J of (2.10) they are as the hypotheses say. c + x'v is v(z) for "
           "v = a, b, alpha, and the right side is D(z, 1/z). r = 1 - h'Ph is the limit of r_t. That the roots are the eigenvalues of S is (6.18).")


def factored(shift, first):
    """Data a0, g0 and the solution P of (6.1), with q = 1/(1 - h'Ph), for a given a and a factor of D.

    ``shift`` and ``first`` are J and h of (2.10). b and r with D = r l(z)l(1/z) solve n + 1 linear equations; (6.2) gives o = Ph, and
    then (6.1) is an equation for P - JPJ', whose solution is a finite sum.
    """
    have, want = monic_of(a0), monic_of(l)
    solved = (inv(matrix_of(i, j, n + 1, n + 1, when(j <= n, coeff(symmetric_part(have, Z ** (n - j)), i - 1), -coeff(want * recip(want), i - 1))))
              * column(i, n + 1, -coeff(symmetric_part(have, Z**n), i - 1)))
    gain = g0 - (shift - a0 * T(first)) * o
    known = -a0 * T(o) * T(shift) - shift * o * T(a0) + a0 * T(first) * o * T(a0) + gain * T(gain) / c[n + 1]
    return {"using": {e: vector(n), l: vector(n), c: vector(n + 1), o: vector(n)},
            "made_by": {l: column(i, n, e[i] / to_expr(3) ** i), c: solved, g0: column(i, n, HALF * (c[i] - a0[i])),
                        o: column(i, n, when(i == 1, 1 - c[n + 1], a0[i - 1] + g0[i - 1] - c[n + 1] * l[i - 1])),
                        P: sum_of(k, 0, n - 1, shift**k * known * T(shift) ** k), q: 1 / c[n + 1]}}
