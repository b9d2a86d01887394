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
from exactkf.evidence import combination, example, identity, induction, instances, order, steps
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    block,
    charpoly,
    column,
    eq,
    forall,
    given,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonsingular,
    nonzero,
    rec,
    recip,
    scalar,
    sequence,
    standing,
    symbols,
    symmetric_matrix,
    symplectic,
    vector,
    vstack,
)
from proofs.blz94.notation import (
    SHIFT,
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
    symmetric_part,
    t,
    u,
)

A, B, S, S11, S12, S21, S22, sigma, X, Y, R, U, V, K, L, N, Q, W = symbols("A B S S11 S12 S21 S22 sigma X Y R U V K L N Q W")
f, p, q, v, w, x, y, z, Lambda, Gamma, M, H, E = symbols("f p q v w x y z Lambda Gamma M H E")

#: A of Proposition 6.4 and the blocks (6.14) of S
CLOSED = (let(A, F - g * T(h)),)
S_OF_A = (let(S, block([[inv(T(A)), -(inv(T(A)) * h * T(h))],
                        [g * T(g) * inv(T(A)), A - g * T(g) * inv(T(A)) * h * T(h)]])),)
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

# ---------------------------------------------------------------------- Proposition 6.4
claim("BLZ94-E6.9", "the Riccati operator in terms of A = F - gh'",
      STEP_OF_P - P == A * P * T(A) - P + A * P * h / (1 - T(h) * P * h) * T(h) * P * T(A) + g * T(g), sizes=["n"],
      over=ANY_F, where=CLOSED, by=[order(), SIZES])

claim("BLZ94-E6.10", "A is invertible, with inverse",
      invertible(A) & (inv(A) == inv(F) + inv(F) * g * T(h) * inv(F) / sigma), sizes=["n"], over=DATA,
      where=[*CLOSED, *SIGMA], given=[given("sigma != 0", sigma != 0)], by=[order(), SIZES],
      note="The text says that A is invertible since F is; this needs sigma != 0 too, which the text asks for before "
           "the proposition.")

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
                                                   [g * T(g) * inv(T(A)), A + (1 - 1 / sigma) * g * T(h)]])),
      sizes=["n"], over=SYMMETRIC, where=[*CLOSED, *BLOCKS], given=[given("sigma != 0", sigma != 0)], by=[order(), SIZES],
      note="The two forms of the equation have the same residual, for every P.")

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
#: alpha_infinity of (6.2) from a solution P, and the row vector (z^(n-1), ..., 1)
_POWERS = column(j, n, Z ** (n - j))
#: n = 1: the orbit that tends to v, through the point with gamma = u (alpha - v)
_ALPHA1 = (1 / v - u**2 * v) / (1 - u**2)
_ORDER_ONE = {P: matrix_of(i, j, n, n, 1 - _ALPHA1 / v), a0: column(i, n, _ALPHA1 - u * (_ALPHA1 - v)),
              g0: column(i, n, u * (_ALPHA1 - v))}
claim("BLZ94-L6.2.1", "Lemma 6.1 with F = J - bh' in place of J - ah', everything else as it stands",
      (1 - T(h) * P * h) * monic_of(alpha) * recip(monic_of(alpha)) == symmetric_part(monic_of(a0), monic_of(b0)), sizes=["n"],
      over={a0: vector(n), g0: vector(n), P: symmetric_matrix(n)},
      where=[*SHIFT, let(b0, a0 + 2 * g0), let(F, J - b0 * T(h)),
             let(alpha, 1 / (1 - T(h) * P * h) * (g0 - F * P * h) + a0)],
      given=[given("(6.1)", F * P * T(F) - P + (g0 - F * P * h) / (1 - T(h) * P * h) * T(g0 - F * P * h) == Zero(n, n))],
      by=[example(n=1, abar=[2], gbar=["-9/16"], P=[["3/8"]]), instances(n=(1,), using={u: scalar(), v: nonzero()}, made_by=_ORDER_ONE)],
      note="If P_t tends to P, Lemma 6.1 makes (4.4) converge to the alpha of (6.2), and then r alpha(z)alpha(1/z) = D. In the example, "
           "n = 1, a = 2, g = -9/16, b = 7/8, the recursion with F = -b converges: (-b, g) are the data of a positive real "
           "function. The limit is 3/8, and (6.2) gives no factor of D.",
      repair=repair("sign", "Exchanging a and b turns g into -g and the a of (6.2) into b; with F alone replaced the Riccati equation is "
                            "that of another function v.",
                    (1 - T(h) * P * h) * monic_of(alpha) * recip(monic_of(alpha)) == symmetric_part(monic_of(a0), monic_of(b0)),
                    sizes=["n"], over={a0: vector(n), g0: vector(n), P: symmetric_matrix(n)},
                    where=[*SHIFT, let(b0, a0 + 2 * g0), let(F, J - b0 * T(h)),
                           let(alpha, 1 / (1 - T(h) * P * h) * (-g0 - F * P * h) + b0)],
                    given=[given("(6.1)", F * P * T(F) - P + (-g0 - F * P * h) / (1 - T(h) * P * h) * T(-g0 - F * P * h) == Zero(n, n))],
                    by=[combination([(-T(_POWERS), "(6.1)", recip(_POWERS))], n=range(1, 5)),
                        example(n=1, abar=["7/8"], gbar=["-9/16"], P=[["3/8"]]),
                        instances(n=(1,), using={u: scalar(), v: nonzero()}, made_by=_ORDER_ONE)]))

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

_SOLVED = {"using": {Lambda: matrix(n, n)}}
claim("BLZ94-E6.33", "the closed loop on the invariant subspace; its characteristic polynomial",
      (inv(T(J - alpha * T(h))) * X == X * Lambda) & (charpoly(J - alpha * T(h)) == monic_of(alpha)), sizes=["n"],
      over={a0: vector(n), g: vector(n), X: nonsingular(n), P: symmetric_matrix(n)},
      where=[*SHIFT, let(F, J - a0 * T(h)), *BLOCKS, let(alpha, (g - F * P * h) / (1 - T(h) * P * h) + a0),
             let(Lambda, inv(X) * (S11 + S12 * P) * X)],
      by=[identity(n=(1, 2)), steps("BLZ94-E6.29", "BLZ94-E6.32", prose="Insert (6.32), transposed, into (6.29). J - v h' is a companion matrix."),
          instances(n=(1, 2, 3))],
      note="X Lambda inv(X) = S11 + S12 P by (6.29), which defines Lambda here.")

claim("BLZ94-E8.8", "a solution of (6.1) factors D",
      (1 - T(h) * P * h) * monic_of(alpha) * recip(monic_of(alpha)) == symmetric_part(monic_of(a0), monic_of(b0)), sizes=["n"],
      over={a0: vector(n), g0: vector(n), P: symmetric_matrix(n)},
      where=[*SHIFT, let(b0, a0 + 2 * g0), let(F, J - a0 * T(h)), let(alpha, 1 / (1 - T(h) * P * h) * (g0 - F * P * h) + a0)],
      given=[given("(6.1)", F * P * T(F) - P + (g0 - F * P * h) / (1 - T(h) * P * h) * T(g0 - F * P * h) == Zero(n, n))],
      by=[combination([(-T(_POWERS), "(6.1)", recip(_POWERS))], n=range(1, 5)),
          instances(n=(1,), using={u: scalar(), v: nonzero()}, made_by=_ORDER_ONE)],
      note="r = 1 - h'Ph, the limit of r_t. That the roots are the eigenvalues of S is (6.18).")
