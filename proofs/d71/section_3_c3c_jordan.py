# SPDX-License-Identifier: MIT
"""Symmetric equilibria at eigenvalues with product one (Chapter III, section C.3.c, Theorems 3.15 and 3.16).

In the coordinates of the Jordan form, R_p[U; L] = [U; L]Omega, an equilibrium is [F; Gamma] =
[U; L]X with Omega X = XJ, and Gamma'F - F'Gamma = X'WX where W = Omega'W Omega. Both equations are
cut into the blocks of Omega and J. X_ij = 0 unless the two eigenvalues are equal, W_ij = 0 unless
their product is one; blocks of Jordan form leave X upper triangular, pressed into a corner, and
W zero where the row and column numbers add up to at most the larger size. So the products
X'WX vanish if the chains in J are short against those in R_p.

The matrices are real, and the transpose stands for the conjugate transpose.
"""

from exactkf.claims import claim
from exactkf.evidence import example, instances, order, restated
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    column,
    forall,
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
    positive_definite,
    positive_semidefinite,
    rank,
    scalar,
    size_of,
    standing,
    sum_of,
    symbols,
    symmetric,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import H, M, Phi, V, gram, i, j, jordan_block, kronecker, n, p

q, r, F, Gam, J, S, Rp, TT, Om, X, W, a, b, c, x, l, o, w, e = symbols("q r F Gam J S Rp TT Om X W a b c x l o w e")
I = Identity(n)
PhiT = inv(T(Phi))
MODEL = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}
R_WHERE = [let(S, gram()), let(Rp, block([[H*PhiT*S + Phi, H*PhiT], [PhiT*S, PhiT]]))]
N2 = 2*n

claim("D71-E3.82", "an invariant subspace in the coordinates of the Jordan form",
      Om*X == X*J, sizes=["n", "r"], over={Rp: matrix(n, n), TT: nonsingular(n), Om: matrix(n, n), X: matrix(n, r), J: matrix(r, r), F: matrix(n, r)},
      given=[given("(3.54)", Rp*TT == TT*Om), given("(3.81)", Rp*F == F*J), given("(3.82)", F == TT*X)],
      by=[order(lemmas=[TT*(Om*X) == TT*(X*J)]), example(n=1, r=1, Rp=[[2]], TT=[[1]], Om=[[3]], X=[[1]], J=[[2]], F=[[1]]),
          example(n=1, r=1, Rp=[[2]], TT=[[1]], Om=[[2]], X=[[1]], J=[[3]], F=[[1]]),
          example(n=1, r=1, Rp=[[2]], TT=[[1]], Om=[[2]], X=[[1]], J=[[3]], F=[[0]]),
          example(n=2, r=1, Rp=[[2, 0], [0, 3]], TT=[[1, 1], [0, 1]], Om=[[2, -1], [0, 3]], X=[[1], [0]], J=[[2]], F=[[1], [0]]),
          example(n=2, r=2, Rp=[[2, 0], [0, 3]], TT=[[1, 1], [0, 1]], Om=[[2, -1], [0, 3]], X=[[1, 0], [0, 1]], J=[[2, -1], [0, 3]], F=[[1, 1], [0, 1]]),
          instances(4, n=(1, 2), r=(1, 2), made_by={Rp: TT*Om*inv(TT), X: Zero(n, r), F: Zero(n, r)}),
          instances(4, n=(2, 3), r=(2, 3),
                    made_by={Rp: TT*Om*inv(TT), X: matrix_of(i, j, n, r, when(i == j, 1, 0)), F: TT*matrix_of(i, j, n, r, when(i == j, 1, 0)),
                             J: matrix_of(i, j, r, r, Om[i, j])})],
      note="Rp and TT stand for the matrices of order 2n and F for [F; Gamma].")

LEFT, RIGHT = jordan_block(x, q), jordan_block(o, r)
TALL = {"over": {x: nonzero(), o: nonzero(), W: matrix(q, r)}, "sizes": ["q", "r"]}
NONE = example(q=1, r=1, x=2, o="1/2", W=[[1]])

claim("D71-E3.86", "blocks of W between eigenvalues",
      W == Zero(q, r), **TALL, given=[given("(3.86)", W == T(LEFT)*W*RIGHT), given("the product is not one", x*o != 1)],
      by=[NONE, example(q=2, r=2, x=1, o=1, W=[[0, 1], [-1, 0]]), example(q=1, r=1, x=2, o=2, W=[[1]]), example(q=2, r=3, x=2, o=3, W=[[0, 0, 0], [0, 0, 0]]),
          instances(6, q=(1, 2, 3), r=(1, 2, 3), made_by={W: Zero(q, r)})],
      note="For two Jordan blocks with the eigenvalues x and o. The equation says that W - (Jordan block)'W(Jordan block) = 0, a linear equation with "
           "triangular matrix and 1 - xo on its diagonal.")

claim("D71-E3.87", "blocks of X between eigenvalues",
      X == Zero(q, r), sizes=["q", "r"], over={x: scalar(), o: scalar(), X: matrix(q, r)},
      given=[given("(3.87)", LEFT*X == X*RIGHT), given("the eigenvalues differ", x != o)],
      by=[example(q=1, r=1, x=2, o=2, X=[[1]]), example(q=2, r=2, x=1, o=1, X=[[1, 0], [0, 1]]), example(q=1, r=1, x=2, o=3, X=[[1]]),
          instances(6, q=(1, 2, 3), r=(1, 2, 3), made_by={X: Zero(q, r)})],
      note="For two Jordan blocks with the eigenvalues x and o.")

# --- Jordan blocks at reciprocal eigenvalues, and at the same one ----------------------------------------------------------

larger, least, Ker, Co, Sol, Masked = symbols("larger least Ker Co Sol Masked")
_a, _b, _c, _d = symbols("a1 b1 c1 d1")


def linear_map(entry):
    """The q*r x q*r matrix with this entry for the cells (a1, b1) and (c1, d1) of q x r matrices, stacked by columns."""
    inner = sum_of(_d, 1, r, sum_of(_c, 1, q, when(j == (_d - 1)*q + _c, entry, 0)))
    return matrix_of(i, j, q*r, q*r, sum_of(_b, 1, r, sum_of(_a, 1, q, when(i == (_b - 1)*q + _a, inner, 0))))


def solution(entry):
    """Some matrix in the null space of the map, with all its basis vectors in it."""
    basis = kernel_basis(linear_map(entry))
    stacked_ = basis*column(i, size_of(T(basis)), w + i**2)
    return matrix_of(i, j, q, r, stacked_[(j - 1)*q + i, 1])


SAME = when(_a == _c, 1, 0)*when(_b == _d, 1, 0)
INVARIANT = solution(SAME - LEFT[_c, _a]*RIGHT[_d, _b])
COMMUTING = solution(LEFT[_a, _c]*when(_b == _d, 1, 0) - when(_a == _c, 1, 0)*RIGHT[_d, _b])

claim("D71-E3.90", "where a block of W is zero",
      forall(i, 1, q, forall(j, 1, r, (i + j <= larger) >> (W[i, j] == 0))), sizes=["q", "r"], over={x: nonzero(), o: nonzero(), W: matrix(q, r)},
      where=[let(larger, when(q > r, q, r))], given=[given("(3.89)", W == T(LEFT)*W*RIGHT), standing("reciprocal eigenvalues", x*o == 1)],
      by=[*(example(q=q_, r=r_, x=1, o=1, W=[[int(k_ + l_ == 0) for l_ in range(r_)] for k_ in range(q_)]) for q_, r_ in ((1, 1), (2, 2), (2, 3))),
          instances(10, q=(1, 2, 3), r=(1, 2, 3), using={w: scalar()}, made_by={o: 1/x, W: INVARIANT})],
      note="For two Jordan blocks with the eigenvalues x and o = 1/x.")

claim("D71-E3.91", "the form of a block of X",
      X == matrix_of(i, j, q, r, when((j >= i) & (j - i >= r - q), X[1, j - i + 1], 0)), sizes=["q", "r"], over={x: scalar(), o: scalar(), X: matrix(q, r)},
      given=[given("(3.87)", LEFT*X == X*RIGHT), standing("the same eigenvalue", x == o)],
      by=[example(q=2, r=2, x=1, o=1, X=[[0, 0], [1, 0]]), instances(10, q=(1, 2, 3), r=(1, 2, 3), using={w: scalar()}, made_by={o: x, X: COMMUTING})],
      note="For two Jordan blocks with the same eigenvalue: upper triangular with equal entries along each diagonal, above zeros or right of zeros.")

X1, X2, Y1, Y2, W11, W12, W21, W22 = symbols("X1 X2 Y1 Y2 W11 W12 W21 W22")
q1, q2, r1, r2, p1, p2 = symbols("q1 q2 r1 r2 p1 p2")
claim("D71-E3.92", "a block of Q - Q* as a sum",
      T(vstack(X1, X2))*block([[W11, W12], [W21, W22]])*vstack(Y1, Y2) == T(X1)*W11*Y1 + T(X1)*W12*Y2 + T(X2)*W21*Y1 + T(X2)*W22*Y2,
      sizes=["q1", "q2", "r1", "r2", "p1", "p2"],
      over={X1: matrix(q1, p1), X2: matrix(q2, p1), Y1: matrix(r1, p2), Y2: matrix(r2, p2), W11: matrix(q1, r1), W12: matrix(q1, r2), W21: matrix(q2, r1),
            W22: matrix(q2, r2)},
      by=[order(), restated("a matrix cut into more blocks is one cut into two, again and again"),
          instances(6, q1=(1, 2), q2=(1, 2), r1=(1, 2), r2=(1,), p1=(1, 2), p2=(1, 2))],
      note="Two simple blocks for each of the two eigenvalues. Reciprocal eigenvalues have equally many blocks in R_p, so both sums go to m_i.")

most, Z0 = symbols("most Z0")
XS, YS, WS = symbols("XS YS WS")
PRESSED = [let(larger, when(r1 > r2, r1, r2)), let(XS, matrix_of(i, j, r1, p1, when(i <= p1, X1[i, j], 0))),
           let(YS, matrix_of(i, j, r2, p2, when(i <= p2, Y1[i, j], 0))),
           let(WS, matrix_of(i, j, r1, r2, when(i + j > larger, W[i, j], 0))), let(least, when(p1 < r1, p1, r1)), let(most, when(p2 < r2, p2, r2))]
claim("D71-E3.93", "when a term of the sum is zero",
      T(XS)*WS*YS + Z0 == Z0, sizes=["r1", "r2", "p1", "p2"], over={X1: matrix(r1, p1), Y1: matrix(r2, p2), W: matrix(r1, r2), Z0: matrix(p1, p2)},
      where=PRESSED,
      given=[given("(3.93)", least + most <= larger)],
      by=[example(r1=1, r2=1, p1=1, p2=1, X1=[[1]], Y1=[[1]], W=[[1]], Z0=[[1]]), instances(8, r1=(2, 3), r2=(2, 3), p1=(1, 2), p2=(1, 2)),
          instances(8, r1=(4,), r2=(3, 4), p1=(2,), p2=(2,))],
      note="XS, YS and WS are blocks with zeros where (3.91) and (3.90) have them and anything elsewhere; Z0 is any matrix. p_i1 + p_j1 <= r makes (3.93) "
           "hold for every term.")

# --- the theorems ----------------------------------------------------------------------------------------------------------

K, v, E, TWIST, Fix, Chain = symbols("K v E TWIST Fix Chain")
ALONE = 2 + c[i]**2
#: the first state an undriven observable random walk, the others driven and observable by themselves
DIAGONAL = matrix_of(i, j, n, n, when(i == j, when(i == 1, 1, ALONE), 0))
MADE = {"using": {E: nonsingular(n), K: nonsingular(n), c: vector(n)},
        "made_by": {Phi: I, H: E*matrix_of(i, j, n, n, when(i == j, when(i == 1, 0, (ALONE - 1)*(1 - 1/ALONE)), 0))*T(E), M: inv(E), V: I,
                    F: E*(DIAGONAL - I)*K, Gam: inv(T(E))*K, J: inv(K)*DIAGONAL*K}}
SYMMETRIC = {"sizes": ["n", "p"], "over": {**MODEL, F: matrix(n, n), Gam: nonsingular(n), J: matrix(n, n)},
             "where": [*R_WHERE, let(TWIST, kronecker(J, J) - Identity(n*n)), let(Fix, kernel_basis(Rp - Identity(N2))), let(Chain, Rp - Identity(N2))],
             "given": [given("R_p T = TJ", Rp*vstack(F, Gam) == vstack(F, Gam)*J),
                       given("only 1 times 1 is one in J", rank(TWIST) == n*n - (n - rank(J - I))**2),
                       standing("blocks of J at 1 have order one", rank((J - I)*(J - I)) == rank(J - I)),
                       given("blocks of R_p at 1 have order two or more", rank(hstack(Chain, Fix)) == rank(Chain))]}
EVIDENCE = [example(n=2, p=1, Phi=[[2, -1], [0, "1/2"]], H=[[4, 6], [6, 9]], M=[[-1, "2/3"]], V=[[1]], F=[[33, 2], [36, 3]], Gam=[[3, 3], [1, -2]],
                    J=[[2, 0], [0, "1/2"]]),
            example(n=2, p=1, Phi=[[1, 0], [0, 1]], H=[[0, 0], [0, 0]], M=[[0, 0]], V=[[1]], F=[[0, 1], [-1, 0]], Gam=[[1, 0], [0, 1]], J=[[1, 0], [0, 1]]),
            example(n=2, p=1, Phi=[[2, 0], [0, 3]], H=[[0, 0], [0, 0]], M=[[0, 0]], V=[[1]], F=[[0, 1], [0, 0]], Gam=[[1, 0], [0, 1]], J=[[2, 0], [0, 3]]),
            instances(3, n=(2,), p=(2,), **MADE), instances(2, n=(1,), p=(1,), **MADE)]
REAL = ("For real J in which (b) is needed for the pair 1, 1 alone, with p_11 = 1: the blocks of J at 1 have order one and those of R_p at least two, and "
        "no other two eigenvalues of J have the product one. Without an eigenvalue 1 it is (a). ")
for id_, title, more in (("D71-T3.15.b", "equilibria that are symmetric in spite of eigenvalues with product one",
                          "The steps for any blocks are (3.82) to (3.93)."),
                         ("D71-T3.16", "symmetric equilibria", "For real matrices the proof is that of Theorem 3.15."),
                         ("D71-S36", "real and symmetric equilibria", "P is real, as J is.")):
    claim(id_, title, symmetric(F*inv(Gam)), by=EVIDENCE, note=REAL + more, **SYMMETRIC)

# --- when R_p is nonderogatory ---------------------------------------------------------------------------------------------

T1, T2, VANISHES = symbols("T1 T2 VANISHES")
CORNER = matrix_of(i, j, r, r, when(i + j > r, W[i, j], 0))
claim("D71-Q1.c", "the conditions for symmetry are necessary when R_p is nonderogatory",
      iff(VANISHES, p1 + p2 <= r), sizes=["r", "p1", "p2"], over={T1: nonsingular(p1), T2: nonsingular(p2), W: matrix(r, r)},
      where=[let(WS, CORNER), let(VANISHES, T(vstack(T1, Zero(r - p1, p1)))*WS*vstack(T2, Zero(r - p2, p2)) == Zero(p1, p2))],
      given=[standing("the chains of J are no longer", (p1 <= r) & (p2 <= r) & (p1 >= 1) & (p2 >= 1)), given("W is nonsingular", invertible(WS))],
      by=[example(r=2, p1=1, p2=2, T1=[[1]], T2=[[1, 0], [0, 1]], W=[[0, 0], [0, 0]]), example(r=2, p1=1, p2=1, T1=[[1]], T2=[[1]], W=[[0, 1], [1, 0]]),
          example(r=3, p1=1, p2=2, T1=[[1]], T2=[[1, 0], [0, 1]], W=[[0, 0, 1], [0, 1, 0], [1, 0, 0]]),
          example(r=1, p1=1, p2=1, T1=[[1]], T2=[[1]], W=[[1]]), instances(8, r=(2, 3, 4), p1=(1, 2), p2=(1, 2))],
      note="A nonderogatory R_p has one block of order r at each eigenvalue. Then X_i is a nonsingular T_i above zeros, and W, which is nonsingular as a "
           "whole, has the nonsingular blocks W_ij = WS between reciprocal eigenvalues, zero where (3.90) says. The equilibrium is symmetric exactly if all "
           "X_i'W_ijX_j vanish: that is (b), or (a) where no eigenvalues of J are reciprocal. For real eigenvalues.")
