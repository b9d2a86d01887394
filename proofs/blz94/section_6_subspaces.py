# SPDX-License-Identifier: MIT
"""Section 6 and the last part of the appendix: invariant Lagrangian subspaces of S.

Let U = Im(X; Y) be invariant under S, of dimension n and Lagrangian, X'Y = Y'X, and
let R be the matrix of S on U. The intersection of U with Im(I; 0) consists of the
(X; Y)z with Yz = 0. For such z the second block of S(X; Y) = (X; Y)R gives
gg'A'^(-1)Xz = YRz, and z'X'Y = 0 gives (g'Xz)(g'A'^(-1)Xz) = 0. A product of two linear
forms that vanishes on a space has a factor that vanishes there. If it is the second,
the null space of Y is invariant under R; if it is the first, under the inverse of R, and
then under R too, since the dimensions are finite.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import EIGENVALUE, EIGENVECTOR, example, identity, induction, instances, order, restated, steps, within
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    always,
    block,
    charpoly,
    column,
    coprime,
    det,
    given,
    hstack,
    iff,
    inv,
    invertible,
    kernel_basis,
    let,
    matrix,
    matrix_of,
    nonsingular,
    nonzero,
    observable,
    prod,
    rank,
    rational,
    rec,
    scalar,
    standing,
    substitute,
    sym,
    symbols,
    vector,
    vstack,
    when,
)
from proofs.blz94.notation import OBSERVER, F, a0, g, g0, h, i, j, k, m, monic_of, n, strict_of, symmetric_part
from proofs.blz94.section_6 import PAIR_A, PAIR_G, PAIR_H, PAIR_P, PAIR_USING, S11, S12, S21, S22, A, P, S, factored

X, Y, R, U, V, K, L, N, Q, W, M, E, B = symbols("X Y R U V K L N Q W M E B")
p, q, s, u, v, w, x, y, z, c, l, T_ = symbols("p q s u v w x y z c l Theta")

LOOP = {A: nonsingular(n), g: vector(n), h: vector(n)}
S_OF_LOOP = let(S, block([[inv(T(A)), -(inv(T(A)) * h * T(h))], [g * T(g) * inv(T(A)), A - g * T(g) * inv(T(A)) * h * T(h)]]))
_UR = given("SU = UR", S * vstack(X, Y) == vstack(X, Y) * R)
_LAGRANGE = given("U is Lagrangian", T(X) * Y == T(Y) * X)

#: the solution of `section_6` for n = 2, and a basis B of its subspace
_SOLUTION = {
    "using": {**PAIR_USING, B: nonsingular(n)},
    "made_by": {A: PAIR_A, g: PAIR_G, h: PAIR_H, X: inv(T(E)) * B, Y: PAIR_P * inv(T(E)) * B,
                R: inv(B) * T(E) * (inv(T(A)) - inv(T(A)) * h * T(h) * PAIR_P) * inv(T(E)) * B},
}
#: any a and factor of D, in the coordinates of (2.10)
_J, _H1 = matrix_of(i, j, n, n, when(j == i + 1, 1, 0)), column(i, n, when(i == 1, 1, 0))
_COMPANION = factored(_J, _H1)
_FACTORED = {"using": {**_COMPANION["using"], a0: vector(n), g0: vector(n), P: matrix(n, n), q: scalar(), B: nonsingular(n)},
             "made_by": {**_COMPANION["made_by"], h: _H1, g: g0, A: _J - (a0 + g0) * T(h), X: B, Y: P * X,
                         R: inv(X) * (inv(T(A)) - inv(T(A)) * h * T(h) * P) * X}}
#: the equilibrium g = 0, U = Im(I; 0)
_AT_REST = {"using": {B: nonsingular(n)}, "made_by": {g: 0 * h, X: B, Y: 0 * B, R: inv(B) * inv(T(A)) * B}}

#: an invariant subspace that is not Lagrangian: one of two subsystems that do not interact
_PAIR = example(n=2, A=[[2, 0], [0, 3]], g=[1, 0], h=[1, 0], X=[[1, 0], [0, 0]], Y=[[0, 1], [0, 0]], R=[["1/2", "-1/2"], ["1/2", "3/2"]],
                z=[1, 0])

# ---------------------------------------------------------------------- (A-20)-(A-28)
_M = block([[S11, S12], [S21, S22]])
_SU = {S11: (X * R - S12 * Y) * inv(X), S21: (Y * R - S22 * Y) * inv(X)}
claim("BLZ94-EA.20", "the intersection of U with Im(I; 0), and when it is invariant",
      iff(vstack(X, Y) * z == vstack(x, Zero(n, 1)), (Y * z == Zero(n, 1)) & (x == X * z))
      & iff(_M * vstack(X, Y) * K == vstack(X, Y) * K * L, R * K == K * L), sizes=["n", "k"],
      over={S11: matrix(n, n), S12: matrix(n, n), S21: matrix(n, n), S22: matrix(n, n), X: matrix(n, n), Y: matrix(n, n), R: matrix(n, n),
            K: matrix(n, k), L: matrix(k, k), z: vector(n), x: vector(n)},
      given=[given("dim U = n", rank(vstack(X, Y)) == n), given("SU = UR", _M * vstack(X, Y) == vstack(X, Y) * R)],
      by=[order(),
          example(n=1, k=1, S11=[[1]], S12=[[0]], S21=[[0]], S22=[[1]], X=[[0]], Y=[[0]], R=[[2]], K=[[1]], L=[[1]], z=[0], x=[0]),
          instances(8, n=(1, 2), k=(1, 2), using={E: nonsingular(n)}, made_by={X: E, **_SU}),
          instances(8, n=(2, 3), k=(1, 2), using={E: nonsingular(n), B: nonsingular(n), Q: matrix(n, n)},
                    made_by={X: E, Y: matrix_of(i, j, n, n, when(j == 1, 0, Q[i, j])), z: column(i, n, when(i == 1, 3, 0)), x: X * z, **_SU}),
          instances(12, n=(2, 3), k=(1, 2), using={E: nonsingular(n), B: nonsingular(n), Q: matrix(n, n)},
                    made_by={X: E, K: B * matrix_of(i, j, n, k, when(i == j, 1, 0)),
                             R: B * matrix_of(i, j, n, n, when(j <= k, when(i <= k, L[i, j], 0), Q[i, j])) * inv(B), **_SU})],
      note="W consists of the (X; Y)z with Yz = 0. The columns of K stand for a basis of ker Y: SW lies in W if S(X; Y)K = (X; Y)KL for some L, and ker Y is "
           "invariant under R if RK = KL; it is the same L. S is any matrix in four blocks.")

claim("BLZ94-EA.22", "what invariance and the Lagrangian property give at z with Yz = 0",
      (g * T(g) * inv(T(A)) * X * z == Y * R * z) & ((T(z) * T(X) * g) * (T(g) * inv(T(A)) * X * z) == 0), sizes=["n"],
      over={**LOOP, X: matrix(n, n), Y: matrix(n, n), R: matrix(n, n), z: vector(n)}, where=[S_OF_LOOP],
      given=[_UR, _LAGRANGE, given("Yz = 0", Y * z == Zero(n, 1))],
      by=[order(), _PAIR,
          instances(n=(2,), using={**_SOLUTION["using"], c: scalar()},
                    made_by={**_SOLUTION["made_by"], z: c * inv(B) * column(i, n, when(i < n, 1, 0))}),
          instances(n=(1, 2), using={**_AT_REST["using"]}, made_by=_AT_REST["made_by"])])

claim("BLZ94-SA9", "a product of two linear forms that vanishes has a factor that vanishes",
      q == Zero(k, 1), sizes=["k"], over={p: vector(k), q: vector(k), c: scalar()},
      given=[given("at z = p", (T(p) * p) * (T(q) * p) == 0), given("at z = p + q", (T(p) * (p + q)) * (T(q) * (p + q)) == 0),
             given("p is not zero", c * (T(p) * p) == 1)],
      by=[order([Identity(k)]), example(k=2, p=[1, 0], q=[0, 1], c=1), example(k=1, p=[1], q=["-1"], c=1), example(k=2, p=[1, 0], q=["-1", 1], c=1),
          example(k=1, p=[0], q=[1], c=0), instances(k=(1, 2, 3), made_by={q: 0 * p, c: 1 / (T(p) * p)})],
      note="z are the coordinates of a vector of ker Y in a basis, p and q the two linear forms in them: if p does not vanish, q does. Of all z in (A-23) "
           "only two are used. c is the inverse of p'p.")

_HAT = block([[Zero(n, n), Identity(n)], [-Identity(n), Zero(n, n)]])
claim("BLZ94-EA.25", "the inverse of S, and invariance under the inverse",
      (inv(S) == inv(_HAT) * T(S) * _HAT) & invertible(R)
      & (inv(S) * vstack(X, Y) == vstack(X, Y) * N) & (T(S) * vstack(-Y, X) == vstack(-Y, X) * N) & (Y * N * z == Zero(n, 1)), sizes=["n"],
      over={**LOOP, X: matrix(n, n), Y: matrix(n, n), R: matrix(n, n), z: vector(n)}, where=[S_OF_LOOP, let(N, inv(R))],
      given=[_UR, given("dim U = n", rank(vstack(X, Y)) == n), given("Yz = 0", Y * z == Zero(n, 1)), given("g'Xz = 0", T(g) * X * z == 0)],
      by=[order(), _PAIR, example(n=1, A=[[2]], g=[1], h=[1], X=[[0]], Y=[[0]], R=[[0]], z=[1]),
          instances(n=(2,), using=_SOLUTION["using"], made_by={**_SOLUTION["made_by"], z: inv(B) * column(i, n, when(i < n, 1, 0))}),
          instances(n=(1, 2), using=_AT_REST["using"], made_by=_AT_REST["made_by"])],
      note="Theorem and proof ask for alpha_n not zero, which is det A not zero.")

claim("BLZ94-EA.28", "invariance under S and under its inverse are the same for Im(U; 0)",
      iff(M * L == L * T_, inv(M) * L == L * inv(T_)), sizes=["l", "k"],
      over={M: nonsingular(l), L: matrix(l, k), T_: nonsingular(k)},
      by=[order(), instances(l=(2, 3), k=(1, 2), using={Q: nonsingular(l), u: nonzero(), E: matrix(l, l)},
                             made_by={L: Q * matrix_of(i, j, l, k, when(i == j, 1, 0)),
                                      M: Q * matrix_of(i, j, l, l, when(j <= k, when(i <= k, T_[i, j], 0), when(i == j, u, E[i, j] * when(i < j, 1, 0))))
                                      * inv(Q)}),
          instances(8, l=(1, 2), k=(1,))],
      note="In the text M = S and L = (U; 0) with U of full rank; S is nonsingular, hence so is Theta. No more is needed of S and L.")

# ---------------------------------------------------------------------- Lemmas 6.7 and 6.8
_OBSERVABLE = standing("(h, A) is observable", rank(matrix_of(i, j, n, n, (T(h) * A ** (i - 1))[1, j])) == n)
_BASIS = {**LOOP, X: matrix(n, n), Y: matrix(n, n), R: matrix(n, n)}
_DIMENSION = standing("dim U = n", rank(vstack(X, Y)) == n)
claim("BLZ94-L6.8", "a Lagrangian invariant subspace meets Im(I; 0) and Im(0; I) in invariant subspaces",
      (rank(hstack(K, R * K)) == rank(K)) & (rank(hstack(L, R * L)) == rank(L)), sizes=["n"], over=_BASIS,
      where=[S_OF_LOOP, let(K, kernel_basis(Y)), let(L, kernel_basis(X))],
      given=[_UR, _LAGRANGE, _DIMENSION],
      by=[steps("BLZ94-EA.22", "BLZ94-EA.25", "BLZ94-EA.28", facts=["a vector space is not the union of two proper subspaces"],
                prose="By (A-23) one of g'A'^(-1)Xz, g'Xz vanishes for all z with Yz = 0. In the first case (A-22) gives YRz = 0, in "
                      "the second (A-25) gives YR^(-1)z = 0; the two are equivalent. For Im(0; I): if Xz = 0, the first block of SU = UR is "
                      "-A'^(-1)h(h'Yz) = XRz, and z'Y'XRz = 0 makes (h'A^(-1)Yz)(h'Yz) vanish."),
          _PAIR, instances(n=(2,), **_SOLUTION), instances(8, n=(1, 2), **_FACTORED), instances(8, n=(1, 2), **_AT_REST),
          example(n=2, A=[[2, 0], [0, 3]], g=[1, 0], h=[1, 0], X=[[0, 1], [0, 0]], Y=[[1, 0], [0, 0]], R=[["3/2", "1/2"], ["-1/2", "1/2"]]),
          example(n=1, A=[[2]], g=[0], h=[0], X=[[0]], Y=[[1]], R=[[2]])],
      note="alpha_n not zero is det A not zero. By (A-20) the intersection is invariant under S exactly if the null space of Y is "
           "invariant under R. K and L are bases of the null spaces of Y and X. By (A-28) invariance under S^(-1) is the same.")

_ROW, _BOTH_PARTS, (_RE, _IM) = sym("row"), hstack(*EIGENVECTOR), EIGENVALUE
#: an eigenvector of A with h'v = 0 is one of F = A + gh'
_SO_IS_A = within(2, _BOTH_PARTS == 0 * _BOTH_PARTS, vector="right", kept=(_ROW, F, block([[_RE * Identity(1), _IM * Identity(1)], [-_IM * Identity(1), _RE * Identity(1)]])), on=0)
claim("BLZ94-E6.21", "what invariance of Im(0; V) means",
      (T(h) * V == Zero(1, k)) & (A * V == V * T_) & (observable(_ROW, F) >> (observable(_ROW, A) & (V == Zero(n, k)))), sizes=["n", "k"], over={**LOOP, V: matrix(n, k), T_: matrix(k, k), q: scalar()},
      where=[S_OF_LOOP, let(F, A + g * T(h)), let(_ROW, T(h))],
      given=[given("S(0; V) = (0; V)T", S * vstack(Zero(n, k), V) == vstack(Zero(n, k), V) * T_), standing("h'h has an inverse q", q * (T(h) * h) == 1)],
      by=[order(inside=[_SO_IS_A, within(3, kept=(_ROW, A, T_))]), example(n=2, k=1, A=[[2, 0], [0, 3]], g=[1, 0], h=[1, 0], V=[[0], [1]], Theta=[[3]], q=1), example(n=1, k=1, A=[[2]], g=[1], h=[0], V=[[1]], Theta=[[2]], q=0),
          instances(n=(2, 3), k=(1, 2), using={E: nonsingular(n), Q: nonsingular(n), c: nonzero()},
                    made_by={A: E * matrix_of(i, j, n, n, when(i < n, when(j < n, when(i == j, c, 0), Q[i, j]), when(j == n, c + 1, 0))) * inv(E),
                             h: inv(T(E)) * column(i, n, when(i == n, 1, 0)), T_: c * Identity(k), q: 1 / (T(h) * h),
                             V: E * matrix_of(i, j, n, k, when(i == n, 0, Q[i, j]))}), instances(8, n=(1, 2), k=(1,), made_by={q: 1 / (T(h) * h)}),
          instances(8, n=(1, 2, 3), k=(1, 2), made_by={V: Zero(n, k), q: 1 / (T(h) * h)})],
      note="(h, F) is observable if no eigenvector of F is annihilated by h'; an observable pair has h != 0. V has full column rank, so that "
           "it has no columns if it is zero.")

claim("BLZ94-L6.7", "X is nonsingular for every Lagrangian invariant subspace Im(X; Y)",
      invertible(X), sizes=["n"], over=_BASIS, where=[S_OF_LOOP],
      given=[_UR, standing("U is Lagrangian", T(X) * Y == T(Y) * X), given("dim U = n", rank(vstack(X, Y)) == n),
             given("(h, A) is observable", rank(matrix_of(i, j, n, n, (T(h) * A ** (i - 1))[1, j])) == n)],
      by=[steps("BLZ94-E6.21", "BLZ94-EA.20", prose="The intersection with Im(0; I) is invariant by Lemma 6.8, so it is zero by (6.21) and observability."),
          example(n=1, A=[[2]], g=[0], h=[0], X=[[0]], Y=[[1]], R=[[2]]),
          example(n=1, A=[[2]], g=[1], h=[1], X=[[0]], Y=[[0]], R=[[2]]),
          example(n=1, A=[[2]], g=[1], h=[1], X=[[0]], Y=[[1]], R=[[2]]),
          instances(n=(2,), **_SOLUTION), instances(12, n=(1, 2), **_FACTORED), instances(8, n=(1, 2), **_AT_REST)],
      note="The subspaces of (6.19) are the S-invariant ones, as the sentence before it says and the proof uses. (h, A) is observable since (h, F) is.")

# ---------------------------------------------------------------------- Lemma 6.12
claim("BLZ94-E6.34", "what invariance of Im(U; 0) means",
      always(m, (inv(T(A)) * U == U * T_) & (g * T(g) * inv(T(A)) * U == Zero(n, k)) & (T(U) * w[m] == Zero(k, 1))),
      sizes=["n", "k"], over={**LOOP, U: matrix(n, k), T_: matrix(k, k), q: scalar()}, where=[S_OF_LOOP, rec(w, m, inv(A) * g, inv(A) * w[m])],
      given=[given("S(U; 0) = (U; 0)T", S * vstack(U, Zero(n, k)) == vstack(U, Zero(n, k)) * T_),
             standing("g is zero, or g'g has an inverse", (g == Zero(n, 1)) | (q * (T(g) * g) == 1))],
      by=[induction(),
          instances(n=(2, 3), k=(1, 2), using={E: nonsingular(n), Q: nonsingular(n), c: nonzero(), u: nonzero()},
                    made_by={A: E * matrix_of(i, j, n, n, when(i < n, when(j < n, when(i == j, c, 0), 0), when(j == n, u, Q[i, j]))) * inv(E),
                             g: E * column(i, n, when(i == n, 1, 0)), T_: 1 / c * Identity(k), q: 1 / (T(g) * g),
                             U: inv(T(E)) * matrix_of(i, j, n, k, when(i == n, 0, Q[i, j]))}), instances(8, n=(1, 2), k=(1,), made_by={g: 0 * h})],
      note="w_m is A^(-m-1)g, and U'A^(-n)(g, Ag, ..., A^(n-1)g) has the columns U'w_m, m = n - 1, ..., 0.")

_CONTROL = matrix_of(i, j, n, n, (F ** (j - 1) * g0)[i])
claim("BLZ94-S53", "(F, g) is reachable if and only if a and b are coprime",
      det(_CONTROL) == det(substitute(strict_of(g0), F)) * prod(k, 1, n, rational(-1) ** (k - 1)), sizes=["n"],
      over={a0: vector(n), g0: vector(n)}, where=OBSERVER,
      by=[identity(n=range(1, 5)), instances(n=(1, 2, 3)),
          restated("det g(F) is the product of the values of g at the zeros of the characteristic polynomial of F")],
      note="The left side vanishes exactly if (F, g) is not reachable. The eigenvalues of F are the roots of a(z), so the right side vanishes "
           "exactly if a root of a(z) is one of g(z) = (b(z) - a(z))/2, that is of b(z).")

_REACHABLE = rank(matrix_of(i, j, n, n, (A ** (j - 1) * g)[i])) == n
_W_ZERO = rank(Y) == n
claim("BLZ94-S52", "U meets Im(I; 0) in zero if and only if (A, g) is reachable",
      iff(_W_ZERO, _REACHABLE) , sizes=["n"],
      over=_BASIS, where=[S_OF_LOOP], given=[_UR, _LAGRANGE, given("dim U = n", rank(vstack(X, Y)) == n)],
      by=[example(n=1, A=[[2]], g=[0], h=[1], X=[["-1/3"]], Y=[[1]], R=[[2]]), instances(n=(1, 2), **_AT_REST)],
      note="(A, g) and (F, g), F = A + gh', are reachable together, as feedback does not change it. In the example n = 1, g = 0, and U is the eigenvector of S to the eigenvalue A = 2.",
      repair=repair("other", "Only one direction holds: W = 0 if (A, g) is reachable. If it is not, some invariant Lagrangian U meet Im(I; 0) "
                             "and others do not.",
                    _W_ZERO, sizes=["n"], over=_BASIS, where=[S_OF_LOOP], given=[_UR, given("(A, g) is reachable", _REACHABLE), standing("U is Lagrangian", T(X) * Y == T(Y) * X),
                                                                 given("dim U = n", rank(vstack(X, Y)) == n)],
                    by=[steps("BLZ94-EA.22", "BLZ94-EA.25", facts=["reachability is not changed by feedback"],
                              prose="W = Im(U; 0) is invariant by Lemma 6.8, and (6.34) makes U'(g, Ag, ...) vanish."),
                        example(n=1, A=[[2]], g=[1], h=[1], X=[[0]], Y=[[0]], R=[[2]]), example(n=1, A=[[2]], g=[1], h=[1], X=[[1]], Y=[[0]], R=[[2]]),
                        instances(12, n=(1, 2), **_FACTORED), instances(n=(1, 2), **_SOLUTION), instances(n=(1, 2), **_AT_REST)]))

claim("BLZ94-L6.12", "for coprime a and b no Lagrangian invariant subspace meets Im(I; 0)",
      _W_ZERO, sizes=["n"], over=_BASIS, where=[S_OF_LOOP, let(F, A + g * T(h))],
      given=[_UR, standing("U is Lagrangian", T(X) * Y == T(Y) * X), given("dim U = n", rank(vstack(X, Y)) == n), _OBSERVABLE,
             given("a and b are coprime", coprime(charpoly(F), charpoly(F - 2 * g * T(h))))],
      by=[steps("BLZ94-EA.22", "BLZ94-EA.25", "BLZ94-S53", prose="W is invariant by Lemma 6.8; (A, g) is reachable as a and b are "
                                                                           "coprime, so W = 0 by (6.34)."),
          example(n=1, A=[[2]], g=[1], h=[1], X=[[0]], Y=[[0]], R=[[2]]), example(n=1, A=[[2]], g=[1], h=[1], X=[[1]], Y=[[0]], R=[[2]]),
          example(n=1, A=[[2]], g=[0], h=[1], X=[[1]], Y=[[0]], R=[["1/2"]]),
          instances(12, n=(1, 2), **_FACTORED), instances(n=(1, 2), **_SOLUTION), instances(8, n=(1, 2), **_AT_REST)],
      note="a(z) and b(z) are the characteristic polynomials of F and of F - 2gh'; in the coordinates of (2.10), J - ah' and J - bh'. The "
           "intersection of U = Im(X; Y) with Im(I; 0) is zero exactly if Y is nonsingular.")

# ---------------------------------------------------------------------- Proposition 6.6
claim("BLZ94-E6.18", "the characteristic polynomial of S is a multiple of D",
      charpoly(S) * (a0[n] + g0[n]) == Z**n * symmetric_part(monic_of(a0), monic_of(a0 + 2 * g0)), sizes=["n"], over={a0: vector(n), g0: vector(n)},
      where=[*OBSERVER, let(A, F - g0 * T(h)), let(S, block([[inv(T(A)), -(inv(T(A)) * h * T(h))],
                                                            [g0 * T(g0) * inv(T(A)), A - g0 * T(g0) * inv(T(A)) * h * T(h)]]))],
      by=[identity(n=(1, 2, 3)), instances(n=(1, 2, 3))],
      note="alpha_n = a_n + g_n. The printed coefficients kappa_i/kappa_n = d_i/d_n are those of D divided by d_n = alpha_n.")

claim("BLZ94-P6.6", "the eigenvalues of S are the zeros of D, with multiplicity",
      Z ** (-n) * charpoly(S) == symmetric_part(monic_of(a0), monic_of(a0 + 2 * g0)) / det(A) * rational(-1) ** n, sizes=["n"],
      over={a0: vector(n), g0: vector(n)},
      where=[*OBSERVER, let(A, F - g0 * T(h)), let(S, block([[inv(T(A)), -(inv(T(A)) * h * T(h))],
                                                            [g0 * T(g0) * inv(T(A)), A - g0 * T(g0) * inv(T(A)) * h * T(h)]]))],
      by=[identity(n=(1, 2, 3)), instances(n=(1, 2, 3))], note="det A = (-1)^n alpha_n, not zero.")
