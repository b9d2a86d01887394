# SPDX-License-Identifier: MIT
"""When an equilibrium is symmetric (Chapter III, section C.3.c).

For R_p[U; L] = [U; L]Omega the matrix W = L'U - U'L satisfies W = Omega'W Omega, because the
same difference made with S and H is symmetric. With [F; Gamma] = [U; L]X the matrix
Gamma'F - F'Gamma is X'WX, and it is Gamma'(P - P')Gamma for P = F Gamma^{-1}. If psi_i* psi_j is not one
for any two eigenvalues of J, X = J'XJ has only the solution 0; so P is Hermitian.

The matrices are real, and the transpose stands for the conjugate transpose; in the theorem J is
complex, and a complex matrix is a real one of twice the size.
"""

from exactkf.claims import claim
from exactkf.evidence import example, instances, order, restated, steps
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    given,
    iff,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_definite,
    positive_semidefinite,
    symbols,
    symmetric,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import H, M, P, Phi, V, gram, i, j, kronecker, n, p

q, r, F, Gam, S, Rp, U, L, Om, X, E, K, c, TWIST = symbols("q r F Gam S Rp U L Om X E K c TWIST")
F1, F2, G1, G2, J1, J2, FR, GR, JR = symbols("F1 F2 G1 G2 J1 J2 FR GR JR")
I = Identity(n)
PhiT = inv(T(Phi))
MODEL = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}
R_WHERE = [let(S, gram()), let(Rp, block([[H*PhiT*S + Phi, H*PhiT], [PhiT*S, PhiT]]))]
BLOCKS = {"using": {E: nonsingular(q)},
          "made_by": {U: matrix_of(i, j, n, q, E[i, j]), L: matrix_of(i, j, n, q, E[i + n, j]),
                      Om: inv(E)*block([[H*PhiT*gram() + Phi, H*PhiT], [PhiT*gram(), PhiT]])*E}}

claim("D71-E3.84", "the difference of Q and its transpose",
      T(Gam)*F - T(F)*Gam == T(X)*(T(L)*U - T(U)*L)*X,
      sizes=["n", "q", "r"], over={U: matrix(n, q), L: matrix(n, q), X: matrix(q, r), F: matrix(n, r), Gam: matrix(n, r)},
      given=[given("(3.82)", vstack(F, Gam) == vstack(U, L)*X)], by=[order(), instances(8, n=(2, 3), q=(2, 3), r=(2,), made_by={F: U*X, Gam: L*X})])

claim("D71-E3.85", "an invariant form",
      T(L)*U - T(U)*L == T(Om)*(T(L)*U - T(U)*L)*Om,
      sizes=["n", "p", "q"], over={**MODEL, U: matrix(n, q), L: matrix(n, q), Om: matrix(q, q)}, where=R_WHERE,
      given=[given("(3.54)", Rp*vstack(U, L) == vstack(U, L)*Om)],
      by=[order(lemmas=[S*U + L == T(Phi)*L*Om, U*Om == H*L*Om + Phi*U, T(U)*S + T(L) == T(Om)*T(L)*Phi]),
          instances(6, n=(1,), p=(1, 2), q=(2,), **BLOCKS), instances(4, n=(2,), p=(1,), q=(4,), **BLOCKS)])

X1, X2, W11, W12, W21, W22, q1, r1 = symbols("X1 X2 W11 W12 W21 W22 q1 r1")
PAIRED = block([[X1, Zero(q, r1)], [Zero(r, q1), X2]])
CUTS = {"q": (1, 2), "r": (1,), "q1": (1, 2), "r1": (1, 2)}

claim("D71-E3.88", "Q and P",
      (T(PAIRED)*block([[W11, W12], [W21, W22]])*PAIRED == block([[T(X1)*W11*X1, T(X1)*W12*X2], [T(X2)*W21*X1, T(X2)*W22*X2]]))
      & (T(Gam)*F == T(Gam)*P*Gam) & iff(symmetric(T(Gam)*F), symmetric(P)),
      sizes=["n", "q", "r", "q1", "r1"],
      over={F: matrix(n, n), Gam: nonsingular(n), P: matrix(n, n), X1: matrix(q, q1), X2: matrix(r, r1), W11: matrix(q, q), W12: matrix(q, r),
            W21: matrix(r, q), W22: matrix(r, r)}, given=[given("(3.11)", P == F*inv(Gam))],
      by=[order(), restated("a matrix cut into more blocks is one cut into two, again and again"),
          instances(4, n=(2, 3), **CUTS, made_by={P: F*inv(Gam)}),
          instances(4, n=(1, 2, 3), **CUTS, using={K: matrix(n, n)}, made_by={F: (K + T(K))*Gam, P: K + T(K)})],
      note="X = diag(X_1, X_2), as (3.87) says; the first equation has the blocks for two groups of eigenvalues. W is L*U - U*L.")

W = 2 + c[i]**2
#: every state by itself, with the eigenvalue w or 1/w in J, in the complex basis K(I + iN) with N^2 = 0
SIGN = matrix_of(i, j, n, n, when(i == j, when(c[i] > 0, W, 1/W), 0))
UPPER = matrix_of(i, j, n, n, when(i < j, c[1], 0))
BENT = inv(K)*SIGN*K
ALONE = {"using": {E: nonsingular(n), K: nonsingular(n), c: vector(n)},
         "made_by": {Phi: I, H: E*matrix_of(i, j, n, n, when(i == j, (W - 1)*(1 - 1/W), 0))*T(E), M: inv(E), V: I,
                     F1: E*(SIGN - I)*K, F2: E*(SIGN - I)*K*UPPER, G1: inv(T(E))*K, G2: inv(T(E))*K*UPPER,
                     J1: BENT + UPPER*BENT*UPPER, J2: BENT*UPPER - UPPER*BENT}}


def complex_matrix(re, im):
    """The real matrix of twice the size that stands for re + i im."""
    return block([[re, im], [-im, re]])


NONE = [[0, 0], [0, 0]]
SPIRAL = {"n": 2, "p": 2, "Phi": [[1, 2], [-2, 1]], "H": NONE, "M": [[1, 0], [0, 1]], "V": [[1, 0], [0, 1]]}
#: the undriven modes 1 + 2i and 1 - 2i: P is four times the projection on the line of (1, i)
COMPLEX = example({**SPIRAL, "F1": [[4, 0], [0, 0]], "F2": [[0, 0], [4, 0]], "G1": [[1, 1], [0, 0]], "G2": [[0, 0], [1, -1]],
                   "J1": [[1, 0], [0, "1/5"]], "J2": [[2, 0], [0, "-2/5"]]})
#: Example 3.1 with J = diag(2, 1/2)
FAMILY = example(n=2, p=1, Phi=[[2, -1], [0, "1/2"]], H=[[4, 6], [6, 9]], M=[[-1, "2/3"]], V=[[1]], F1=[[33, 2], [36, 3]], G1=[[3, 3], [1, -2]],
                 J1=[[2, 0], [0, "1/2"]], F2=NONE, G2=NONE, J2=NONE)
LOOSE = example(n=2, p=1, Phi=[[1, 0], [0, 1]], H=NONE, M=[[0, 0]], V=[[1]], F1=[[0, 1], [0, 0]], G1=[[1, 0], [0, 1]], J1=[[2, 0], [0, 3]],
                F2=NONE, G2=NONE, J2=NONE)
claim("D71-T3.15.a", "equilibria that are Hermitian",
      symmetric(FR*inv(GR)),
      sizes=["n", "p"], over={**MODEL, **{entry: matrix(n, n) for entry in (F1, F2, G1, G2, J1, J2)}},
      where=[*R_WHERE, let(FR, complex_matrix(F1, F2)), let(GR, complex_matrix(G1, G2)), let(JR, complex_matrix(J1, J2)),
             let(TWIST, complex_matrix(kronecker(J1, J1) + kronecker(J2, J2) - Identity(n*n), kronecker(J1, J2) - kronecker(J2, J1)))],
      given=[given("R_p T = TJ", Rp*block([[F1, F2], [G1, G2]]) == block([[F1, F2], [G1, G2]])*JR), given("psi_i* psi_j is never one", invertible(TWIST))],
      by=[steps("D71-E3.84", "D71-E3.85", "D71-E3.88", facts=["The eigenvalues of the Kronecker product of A and B are the products of one of A and one of B."],
                prose="Gamma*F - F*Gamma solves X = J*XJ, a linear equation whose matrix is the transpose of the product of the conjugate of J with J; so it vanishes."),
          COMPLEX, FAMILY, LOOSE,
          instances(4, n=(1,), p=(1,), **ALONE), instances(4, n=(2,), p=(2,), **ALONE)],
      note="F = F1 + iF2, and so on; FR, GR and JR are the real matrices of twice the size that stand for F, Gamma, which is "
           "nonsingular as its inverse presupposes, and J. TWIST stands for the Kronecker product of the conjugate of J with J less I, "
           "and has the eigenvalues psi_i* psi_j - 1. In the first example J has the eigenvalues 1 + 2i and (1 - 2i)/5, whose product is one, and P is Hermitian, but not real.")
