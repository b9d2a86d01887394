# SPDX-License-Identifier: MIT
"""Existence and definiteness of equilibria (Chapter III, section C.3.c).

An equilibrium is P = F Gamma^{-1} with R_p[F; Gamma] = [F; Gamma]J. When does Gamma have an
inverse, and when is P singular? Multiply by a left eigenvector of R_p: an unobservable mode
gives [0, n*], so n*Gamma(J - 1/lambda*) = 0, and Gamma is singular if 1/lambda* is not in J.
If J has lambda itself, the column of T that belongs to it is [n; 0], provided that R_p has
no other eigenvector there. An undriven mode gives [n*, 0] and [0; n] and says the same of F.

For a Hermitian P put Q = Gamma*P Gamma. Then J*QJ - Q is [F*, Gamma*]G[F; Gamma] with a
nonnegative definite G, which ties the sign of P to the eigenvalues of J.

Matrices are real and the transpose stands for the conjugate transpose; eigenvalues are
written as matrices, see section_3_c3b. What the print says of numbers that commute is asked
of those matrices as a standing hypothesis; for a real eigenvalue it is no condition.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, instances, order, steps, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    charpoly,
    det,
    diag,
    given,
    hstack,
    iff,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonsingular,
    nonzero,
    outside_roots,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    rational,
    rows,
    scalar,
    schur,
    standing,
    sym,
    symbols,
    symmetric_matrix,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import H, M, P, Phi, V, gram, i, j, n, p, step, update

q, F, Gam, J, N, Lam, S, Rp, E, K = symbols("q F Gam J N Lam S Rp E K")
a, b, c, d, e, l, bv, B, X, Y, D1, D2 = symbols("a b c d e l bv B X Y D1 D2")
I = Identity(n)
PhiT = inv(T(Phi))

MODEL = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}
R_WHERE = [let(S, gram()), let(Rp, block([[H*PhiT*S + Phi, H*PhiT], [PhiT*S, PhiT]]))]
TT = vstack(F, Gam)
RT_TJ = given("R_p T = TJ", Rp*TT == TT*J)

# --- when Gamma or F is singular ----------------------------------------------------------------------------------------

MODE = {**MODEL, N: matrix(n, q), Lam: nonsingular(q)}
UNDRIVEN = [given("(3.60)", T(Phi)*N == N*T(Lam)), given("(3.61)", H*N == Zero(n, q))]
UNOBSERVED = [given("(3.62)", Phi*N == N*Lam), given("(3.63)", M*N == Zero(p, q))]
FIRST = matrix_of(i, j, n, q, when(i == j, 1, 0))
AUX = {E: nonsingular(n), D1: nonsingular(q), D2: nonsingular(n - q), X: matrix(n - q, q), Y: matrix(n - q, n - q), B: matrix(p, n - q)}
LOWER = block([[D1, Zero(q, n - q)], [X, D2]])
NOT_DRIVEN = {Phi: E*LOWER*inv(E), H: E*diag(Zero(q, q), Y*T(Y))*T(E), N: inv(T(E))*FIRST, Lam: D1}
NOT_MEASURED = {Phi: inv(T(E))*T(LOWER)*T(E), M: hstack(Zero(p, q), B)*T(E), N: inv(T(E))*FIRST, Lam: T(D1)}
SIZES_Q = {"n": (2, 3), "p": (1, 2), "q": (1, 2)}

claim("D71-E3.77", "a row that Gamma sends to zero",
      hstack(Zero(q, n), T(N))*(TT*J - Rp*TT) == T(N)*Gam*J - inv(T(Lam))*T(N)*Gam,
      sizes=["n", "p", "q"], over={**MODE, F: matrix(n, n), Gam: matrix(n, n), J: matrix(n, n)}, where=R_WHERE, given=UNOBSERVED,
      by=[instances(**SIZES_Q, using=AUX, made_by=NOT_MEASURED)],
      note="(3.76) says that the left side is zero and (3.77) that the right side is; they are equal whatever F, Gamma and J are.")

claim("D71-E3.80", "a row that F sends to zero",
      hstack(T(N), Zero(q, n))*(TT*J - Rp*TT) == T(N)*F*J - Lam*T(N)*F,
      sizes=["n", "p", "q"], over={**MODE, F: matrix(n, n), Gam: matrix(n, n), J: matrix(n, n)}, where=R_WHERE, given=UNDRIVEN,
      by=[instances(**SIZES_Q, using=AUX, made_by=NOT_DRIVEN)],
      note="(3.79) says that the left side is zero and (3.80) that the right side is.")

claim("D71-E3.78", "P takes the null vector to zero",
      (P*N == F*inv(Gam)*N) & (F*inv(Gam)*N == Zero(n, q)),
      sizes=["n", "q"], over={P: matrix(n, n), F: matrix(n, n), Gam: nonsingular(n), N: matrix(n, q), X: matrix(n, q)},
      given=[given("(3.11)", P == F*inv(Gam)), given("a column of F is zero", F*X == Zero(n, q)), given("that column of Gamma", Gam*X == N)],
      by=[instances(n=(2, 3), q=(1, 2), using={Y: matrix(n, n)},
                    made_by={X: FIRST, F: matrix_of(i, j, n, n, when(j <= q, 0, Y[i, j])), N: Gam*FIRST, P: F*inv(Gam)})],
      note="X has a one in the place of the column; with more columns it stands for several of them.")

# --- the same in a basis where the process falls apart ------------------------------------------------------------------
# Instances: two coordinates that do not meet. In each, R_p is 2 x 2 with the eigenvalues w and 1/w, where
# h s = -(phi - w)(phi - 1/w), and the eigenvector at w is [w phi - 1; s]. Then a change of basis E.

w = sym("w")
PAIR = rows([[a, b], [-b, a]])
#: the second coordinate is driven and measured, with phi = s = 1
H2 = (w - 1)*(1 - 1/w)
HIDDEN = {"sizes": {"n": (2,), "p": (1,)}, "using": {E: nonsingular(2), w: scalar(), l: scalar()},
          "made_by": {b: 0, V: rows([[1]]), M: rows([[0, 1]])*inv(E), Phi: E*diag(a, 1)*inv(E), H: E*diag(l**2, H2)*T(E), N: E*rows([[1, 0], [0, 0]]),
                      bv: diag(E, inv(T(E)))*rows([[1 + l**2/a], [w + 1/w - 2], [1/a - a], [2]])}}
#: unobservable: the columns of T at lam, at w, at 1/w and at 1/lam
AT_LAM, AT_W, AT_1W = ([1, 0], [0, 0]), ([0, w - 1], [0, 1]), ([0, 1/w - 1], [0, 1])
AT_1LAM = ([l**2/a, 0], [1/a - a, 0])


def columns(one, two, first, second):
    """F, Gamma and J from two eigenvectors."""
    return {F: E*rows([[one[0][0], two[0][0]], [one[0][1], two[0][1]]]), Gam: inv(T(E))*rows([[one[1][0], two[1][0]], [one[1][1], two[1][1]]]),
            J: rows([[first, 0], [0, second]])}


# F, Gamma and J are complex: F = F1 + iF2 and so on. For vectors u + iv is [u, v]; so is [F1, F2] for F, and J on the right is
# [[J1, J2], [-J2, J1]]. To double R_p as well would make it derogatory.
F1, F2, G1, G2, J1, J2, FR, GR, JR, u, v = symbols("F1 F2 G1 G2 J1 J2 FR GR JR u v")
P1, P2, PR, K1, K2 = symbols("P1 P2 PR K1 K2")


def complex_matrix(re, im):
    """The real matrix of order 2n that stands for re + i im."""
    return block([[re, im], [-im, re]])


COMPLEX = {**MODEL, F1: matrix(n, n), F2: matrix(n, n), G1: matrix(n, n), G2: matrix(n, n), J1: matrix(n, n), J2: matrix(n, n), a: scalar(), b: scalar(),
           u: vector(n), v: vector(n)}
C_WHERE = [*R_WHERE, let(FR, complex_matrix(F1, F2)), let(GR, complex_matrix(G1, G2)), let(JR, complex_matrix(J1, J2))]
C_TT = block([[F1, F2], [G1, G2]])
C_TJ = given("R_p T = TJ", Rp*C_TT == C_TT*JR)
#: J - lambda and lambda* J - 1
AT_MODE = complex_matrix(J1 - a*I, J2 - b*I)
AT_IMAGE = complex_matrix(a*J1 + b*J2 - I, a*J2 - b*J1)
ROW = hstack(T(u), -T(v))
NO_ROW, NO_COLUMN = hstack(Zero(1, n), Zero(1, n)), Zero(n, 1)


def turned(fam):
    """The three matrices in the complex basis T(I + iW), with W = [[0, 1], [1, 0]]."""
    swap = rows([[0, 1], [1, 0]])
    j_there = complex_matrix(Identity(2), -swap)*diag(fam[J], fam[J])*complex_matrix(Identity(2), swap)*rational("1/2")
    return {F1: fam[F], F2: fam[F]*swap, G1: fam[Gam], G2: fam[Gam]*swap, J1: matrix_of(i, j, n, n, j_there[i, j]),
            J2: matrix_of(i, j, n, n, j_there[i, j + n]), u: fam[N]*rows([[1], [0]]), v: Zero(2, 1)}


def family(base, *choice):
    """Instances with the two eigenvectors chosen."""
    made = {**base["made_by"], **columns(*choice)}
    rest = {key: term for key, term in made.items() if key.tree[1] not in ("F", "Gam", "J", "N")}
    return instances(3, **base["sizes"], using=base["using"], made_by={**rest, **turned(made), **base.get("with", {})})


def real(case, **more):
    """An instance with real matrices."""
    size = case["n"]
    zero = [[0]*size for _ in range(size)]
    names = {"F": "F1", "Gam": "G1", "J": "J1", "P": "P1"}
    out = {names.get(key, key): value for key, value in {**case, **more}.items() if key != "N"}
    pair = {**case, **more}["N"]
    extra = {"P2": zero} if "P1" in out else {}
    return example({**out, "F2": zero, "G2": zero, "J2": zero, **extra, "u": [row[0] for row in pair], "v": [row[1] for row in pair]})


NONDEROGATORY = given("R_p is nonderogatory", invertible(matrix_of(i, j, 2*n, 2*n, (Rp**(j - 1)*bv)[i])))
HIDES = given("an unobservable mode", (Phi*u == a*u - b*v) & (Phi*v == b*u + a*v) & (M*u == Zero(p, 1)) & (M*v == Zero(p, 1)))
NOT_ZERO = given("its eigenvector is not zero", (u != NO_COLUMN) | (v != NO_COLUMN))
SWAP = {"V": [[1]], "M": [[-1, "2/3"]], "Phi": [[2, -1], [0, "1/2"]], "H": [[4, 6], [6, 9]]}
#: Example 3.1: derogatory, with the unobservable mode 1/2 in J and a nonsingular Gamma
DEROGATORY = {"n": 2, "p": 1, **SWAP, "F": [[8, 0], [12, 0]], "Gam": [[0, 3], [1, -2]], "J": [[2, 0], [0, "1/2"]], "a": "1/2", "b": 0,
              "N": [[2, 0], [3, 0]], "bv": [1, 2, 3, 4]}
#: one driven and measured mode with the equilibrium P = 1, J = 2
ORDINARY = {"n": 1, "p": 1, "Phi": [[1]], "H": [["1/2"]], "M": [[1]], "V": [[1]], "F": [[1]], "Gam": [[1]], "J": [[2]]}
#: two of them, with the vector 0
TWICE = {"n": 2, "p": 2, "Phi": [[1, 0], [0, 1]], "H": [["1/2", 0], [0, "1/2"]], "M": [[1, 0], [0, 1]], "V": [[1, 0], [0, 1]], "F": [[1, 0], [0, 1]],
         "Gam": [[1, 0], [0, 1]], "J": [[2, 0], [0, 2]], "b": 0, "N": [[0, 0], [0, 0]]}
MODE_NOTE = ("The mode is lambda = a + ib with the eigenvector u + iv; J = J1 + iJ2 is complex, and so are F and Gamma. A matrix is nonderogatory exactly if "
             "some vector b makes b, Rb, R^2 b, ... a basis, a real one for a real matrix.")
#: the modes 1 + 2i and 1 - 2i with the vector (1, i); J = diag(1 + 2i, (1 + 2i)/5)
ROTATION = {"n": 2, "p": 1, "Phi": [[1, 2], [-2, 1]], "V": [[1]], "a": 1, "b": 2, "u": [1, 0], "v": [0, 1], "J1": [[1, 0], [0, "1/5"]],
            "J2": [[2, 0], [0, "2/5"]]}
#: nothing measured: T = [[f, f2], [0, g]] with f = g = (1, i); R_p f2 part solved for H = I
UNMEASURED = {**ROTATION, "H": [[1, 0], [0, 1]], "M": [[0, 0]], "F1": [[1, 1], [0, 0]], "F2": [[0, 0], [1, 1]],
              "G1": [[0, -4], [0, 0]], "G2": [[0, 0], [0, -4]], "bv": [1, 0, 1, 2]}

claim("D71-T3.13.a", "Gamma is singular if J has an unobservable mode",
      det(GR) == 0,
      sizes=["n", "p"], over={**COMPLEX, bv: vector(2*n)}, where=C_WHERE,
      given=[C_TJ, HIDES, NOT_ZERO, given("the mode is in J", det(AT_MODE) == 0), NONDEROGATORY],
      by=[steps("D71-E3.66", facts=["A nonderogatory matrix has one eigenvector, up to a factor, at each eigenvalue."],
                prose="If Jx = lambda x then Tx is an eigenvector of R_p, or zero; so is [n; 0], hence Tx is a multiple of it and Gamma x = 0."),
          real(DEROGATORY), real(ORDINARY, a=2, b=0, N=[[1, 0]], bv=[1, 0]), real(ORDINARY, a=2, b=0, N=[[0, 0]], bv=[1, 0]),
          example(UNMEASURED),
          family(HIDDEN, AT_LAM, AT_W, a, w), family(HIDDEN, AT_1LAM, AT_W, 1/a, w)],
      note=MODE_NOTE)

claim("D71-T3.13.b", "Gamma is singular if the conjugate reciprocal of an unobservable mode is not in J",
      (ROW*GR == NO_ROW) & (invertible(GR) >> (ROW == NO_ROW)),
      sizes=["n", "p"], over=COMPLEX, where=C_WHERE,
      given=[C_TJ, HIDES, given("the conjugate reciprocal is not in J", invertible(AT_IMAGE))],
      by=[order([], [inv(AT_IMAGE)], [], [inv(GR)], lemmas=[ROW*GR*AT_IMAGE == NO_ROW, ROW*GR == NO_ROW]),
          real(ORDINARY, a=2, b=0, N=[[1, 0]]), real(TWICE, a=2),
          family(HIDDEN, AT_LAM, AT_W, a, w), family(HIDDEN, AT_1LAM, AT_W, 1/a, w)],
      note="The mode is lambda = a + ib with the eigenvector n = u + iv; lambda* J - I is nonsingular exactly if 1/lambda* is not in J. Then n*Gamma = 0, and "
           "Gamma is singular unless n = 0. J and R_p may be derogatory: that R_p is not is needed for part (a) only.")

# the first coordinate is undriven: h = 0, phi = a, s = 1
LOUD = {"sizes": {"n": (2,), "p": (2,)}, "using": {E: nonsingular(2), w: scalar()},
        "made_by": {b: 0, V: Identity(2), M: inv(E), Phi: E*diag(a, 1)*inv(E), H: E*diag(0, H2)*T(E), N: inv(T(E))*rows([[1, 0], [0, 0]]),
                    bv: diag(E, inv(T(E)))*rows([[a**2 - 1], [w + 1/w - 2], [2], [2]])}}
AT_A, AT_1A = ([a**2 - 1, 0], [1, 0]), ([0, 0], [1, 0])
DRIVES = given("an undriven mode", (T(Phi)*u == a*u + b*v) & (T(Phi)*v == a*v - b*u) & (H*u == NO_COLUMN) & (H*v == NO_COLUMN))
IF_EXISTS = standing("P_e = F Gamma^{-1} where that exists", invertible(GR) >> (complex_matrix(P1, P2)*GR == FR))
#: Gamma is singular and P does not matter
NO_P = {"n": 1, "p": 1, "Phi": [[2]], "H": [[0]], "M": [[1]], "V": [[1]], "F": [[0]], "Gam": [[0]], "J": [["1/2"]], "a": 2, "b": 0, "N": [[1, 0]], "P": [[5]]}
#: the modes 1 + 2i and 1 - 2i undriven, P = 0
UNDRIVEN_PAIR = {**ROTATION, "H": [[0, 0], [0, 0]], "M": [[1, 1]], "J1": [["1/5", 0], [0, "1/5"]], "J2": [["2/5", 0], [0, "-2/5"]], "F1": [[0, 0], [0, 0]],
                 "F2": [[0, 0], [0, 0]], "G1": [[1, 1], [0, 0]], "G2": [[0, 0], [1, -1]], "P1": [[0, 0], [0, 0]], "P2": [[0, 0], [0, 0]], "bv": [1, 0, 0, 1]}
TO_P = {P1: matrix_of(i, j, n, n, (FR*inv(GR))[i, j]), P2: matrix_of(i, j, n, n, (FR*inv(GR))[i, j + n])}
#: the same with P = F Gamma^{-1}
LOUD_P = {**LOUD, "with": TO_P}


claim("D71-T3.14.a", "F is singular if J has the conjugate reciprocal of an undriven mode",
      (det(FR) == 0) & (invertible(GR) >> ((P1*u == P2*v) & (P1*v == -P2*u))),
      sizes=["n", "p"], over={**COMPLEX, P1: matrix(n, n), P2: matrix(n, n), bv: vector(2*n)}, where=C_WHERE,
      given=[C_TJ, IF_EXISTS, DRIVES, NOT_ZERO, given("its conjugate reciprocal is in J", det(AT_IMAGE) == 0), NONDEROGATORY],
      by=[steps("D71-E3.64", "D71-E3.78", facts=["A nonderogatory matrix has one eigenvector, up to a factor, at each eigenvalue."],
                prose="If Jx = x/lambda* then Tx is an eigenvector of R_p, or zero; so is [0; n], hence Fx = 0 and Gamma x is a multiple of n, not zero "
                      "if Gamma is nonsingular."),
          real(ORDINARY, a="1/2", b=0, N=[[1, 0]], P=[[1]], bv=[1, 0]), real(NO_P, bv=[1, 0]),
          real(ORDINARY, a="1/2", b=0, N=[[0, 0]], P=[[1]], bv=[1, 0]),
          real({**NO_P, "F": [[3]], "Gam": [[1]], "J": [[2]], "P": [[3]]}, bv=[1, 0]),
          # Example 3.1: the undriven mode 2, with 1/2 in J
          real({"n": 2, "p": 1, **SWAP, "F": [[33, 2], [36, 3]], "Gam": [[3, 3], [1, -2]], "J": [[2, 0], [0, "1/2"]], "a": 2, "b": 0,
                "N": [[3, 0], [-2, 0]], "P": [["68/9", "31/3"], ["25/3", 11]], "bv": [1, 2, 3, 4]}),
          example(UNDRIVEN_PAIR),
          family(LOUD_P, AT_1A, AT_W, 1/a, w)],
      note=MODE_NOTE + " P = P1 + iP2.")

claim("D71-T3.14.b", "F is singular if an undriven mode is not in J",
      (ROW*FR == NO_ROW) & (ROW*PR == NO_ROW) & (invertible(FR) >> (ROW == NO_ROW)),
      sizes=["n", "p"], over={**COMPLEX, K1: matrix(n, n), K2: matrix(n, n)}, where=[*C_WHERE, let(PR, FR*complex_matrix(K1, K2))],
      given=[C_TJ, DRIVES, given("the mode is not in J", invertible(AT_MODE))],
      by=[order([], [inv(AT_MODE)], [], [], [inv(FR)], lemmas=[ROW*FR*AT_MODE == NO_ROW, ROW*FR == NO_ROW]),
          real(ORDINARY, a="1/2", b=0, N=[[1, 0]], K1=[[1]], K2=[[0]]),
          real(TWICE, a="1/2", K1=[[1, 0], [0, 1]], K2=[[0, 0], [0, 0]]),
          family(LOUD, AT_1A, AT_W, 1/a, w), family(LOUD, AT_A, AT_W, a, w)],
      note="K1 + iK2 stands for the inverse of Gamma, if there is one, and PR for P. n = u + iv, and the rows are those of n*F and n*P; F is singular "
           "unless n = 0. The scan has n* where the proof has the zero row. J and R_p may be derogatory. The vector that P takes to zero stands on the left "
           "here, n*P = 0, and on the right in part (a).")

# --- the sign of a Hermitian equilibrium ----------------------------------------------------------------------------------

f, g, A, C, D, BB, Rm, Psi = symbols("f g A C D BB Rm Psi")
MIDDLE = inv(Phi)*H*PhiT
Zn = Zero(n, n)


def weight(corner):
    """The matrix G of (3.98) with the upper left block of its last factor."""
    return block([[I, S], [Zn, I]])*block([[S, Zn], [Zn, MIDDLE]])*block([[corner, Zn], [S, I]])


CORNER = "the last factor of G in (3.98) needs I in its upper left corner, as a congruence has it; with 0 there the term F*M'V^{-1}MF is lost"
BOTH = vstack(f, g)

claim("D71-E3.98", "the weight G is nonnegative definite",
      psd(T(BOTH)*weight(Zn)*BOTH),
      sizes=["n", "p", "q"], over={**MODEL, f: matrix(n, q), g: matrix(n, q)}, where=[let(S, gram())],
      by=[order([T(S*f + g)*inv(Phi)*H*inv(T(Phi))*(S*f + g)]), instances(n=(1, 2, 3), p=(1, 2), q=(1, 2))],
      note="G is the printed product, with 0 in the upper left corner of the last factor; [f; gamma] has any number of columns, so that the matrix G itself "
           "is meant. It is nonnegative definite, but not the matrix that (3.99) and (3.102) need: see there.")

EIGEN = {**MODEL, F: matrix(n, q), Gam: matrix(n, q), J: matrix(q, q)}
FORM = T(J)*(T(Gam)*F)*J - T(Gam)*F
EIGEN_MADE = {"using": {E: nonsingular(q)},
              "made_by": {F: matrix_of(i, j, n, q, E[i, j]), Gam: matrix_of(i, j, n, q, E[i + n, j]),
                          J: inv(E)*block([[H*PhiT*gram() + Phi, H*PhiT], [PhiT*gram(), PhiT]])*E}}
#: the equilibrium P = 1 with J = 2
ONE_EIGEN = example(n=1, p=1, q=1, Phi=[[1]], H=[["1/2"]], M=[[1]], V=[[1]], F=[[1]], Gam=[[1]], J=[[2]])


def square(corner):
    """(3.99)."""
    return (FORM == T(TT)*weight(corner)*TT) & psd(FORM)


claim("D71-E3.99", "J*QJ - Q is nonnegative definite",
      square(Zn), sizes=["n", "p", "q"], over=EIGEN, where=R_WHERE, given=[RT_TJ],
      by=[ONE_EIGEN, instances(n=(1, 2), p=(1, 2), q=(2, 4), **EIGEN_MADE)],
      repair=repair("other", CORNER, square(I), sizes=["n", "p", "q"], over=EIGEN, where=R_WHERE, given=[RT_TJ],
                    by=[order([], [T(F)*T(M)*inv(V)*M*F, T(S*F + Gam)*inv(Phi)*H*inv(T(Phi))*(S*F + Gam)]),
                        ONE_EIGEN, instances(n=(1, 2), p=(1, 2), q=(2, 4), **EIGEN_MADE)]),
      note="F, Gamma and J stand for F_1, Gamma_1 and J_1. In the counterexample P = 1, J = 2 is outside the unit circle, the left side is 3 and the right "
           "side 2. The repair asks nothing of the eigenvalues.")

SYSTEM = {Phi: nonsingular(n), H: symmetric_matrix(n), M: matrix(p, n), V: positive_definite(p), P: symmetric_matrix(n)}
MORE = {"n": (1, 2, 3), "p": (1, 2)}
COEFFICIENTS = [let(S, gram()), let(A, H*PhiT), let(BB, H*PhiT*S + Phi), let(C, -PhiT), let(D, PhiT*S)]
EQUILIBRIUM = given("(3.46)", P == step())
SOLVED = {H: P - Phi*update()*T(Phi)}
LEFT = T(D*P - C)*P*(D*P - C) - P

claim("D71-E3.100", "the remainder R",
      LEFT == hstack(T(P), I)*block([[T(D)*BB, T(D)*A], [-T(C)*BB - I, -T(C)*A]])*vstack(P, I),
      sizes=["n"], over={A: matrix(n, n), BB: matrix(n, n), C: matrix(n, n), D: matrix(n, n), P: symmetric_matrix(n)},
      given=[given("(3.10)", A + BB*P + P*C - P*D*P == Zn)],
      by=[instances(n=(1, 2, 3), made_by={A: P*D*P - BB*P - P*C})],
      note="The upper left block is D*B; the scan has lost the star that D*A beside it has. B is called BB here.")

claim("D71-E3.102", "R is nonnegative definite",
      (LEFT == hstack(P, I)*weight(Zn)*vstack(P, I)),
      sizes=["n", "p"], over=SYSTEM, where=COEFFICIENTS, given=[EQUILIBRIUM],
      by=[example(n=1, p=1, Phi=[[1]], H=[["1/2"]], M=[[1]], V=[[1]], P=[[1]]), instances(**MORE, made_by=SOLVED)],
      repair=repair("other", CORNER,
                    (LEFT == hstack(P, I)*weight(I)*vstack(P, I)) & (psd(H) >> psd(LEFT)),
                    sizes=["n", "p"], over=SYSTEM, where=COEFFICIENTS, given=[EQUILIBRIUM],
                    by=[order([], [P*T(M)*inv(V)*M*P, T(S*P + I)*inv(Phi)*H*inv(T(Phi))*(S*P + I)]),
                        example(n=1, p=1, Phi=[[1]], H=[["1/2"]], M=[[1]], V=[[1]], P=[[1]]),
                        example(n=1, p=1, Phi=[["1/2"]], H=[["-1/2"]], M=[[1]], V=[[1]], P=[["-2/3"]]),
                        instances(**MORE, made_by=SOLVED)]),
      note="R is the left side of (3.100). H is any symmetric matrix in the equation and nonnegative definite in the conclusion.")

claim("D71-E3.103", "an eigenvector of DP - C",
      T(Psi)*T(g)*P*g*Psi - T(g)*P*g == T(g)*Rm*g,
      sizes=["n", "q"], over={C: matrix(n, n), D: matrix(n, n), P: symmetric_matrix(n), g: matrix(n, q), Psi: matrix(q, q)},
      where=[let(Rm, LEFT)], given=[given("eigenvector", (D*P - C)*g == g*Psi)],
      by=[instances(n=(2, 3), q=(1, 2), using={E: nonsingular(n), X: matrix(n, n)},
                    made_by={C: D*P - E*block([[Psi, matrix_of(i, j, q, n - q, X[i, j])], [Zero(n - q, q), matrix_of(i, j, n - q, n - q, X[i + q, j + q])]])*inv(E),
                             g: E*FIRST})],
      note="For a number psi the left side is (psi* psi - 1) gamma*P gamma; the factor gamma after P is lost in the scan. R is the left side of (3.100).")

gp, gr = symbols("gp gr")

a_, b_, g1, g2 = symbols("a b g1 g2")
CLOSED = D*P - C
FORM_P, FORM_R = (T(g1)*x*g1 + T(g2)*x*g2 for x in (P, Rm))
FORMS_MADE = {gp: (T(g1)*P*g1 + T(g2)*P*g2)[1, 1], gr: (T(g1)*LEFT*g1 + T(g2)*LEFT*g2)[1, 1]}

claim("D71-E3.104", "both forms positive",
      (a_**2 + b_**2 == 1 + gr/gp) & (a_**2 + b_**2 > 1),
      sizes=["n"], over={C: matrix(n, n), D: matrix(n, n), P: symmetric_matrix(n), g1: vector(n), g2: vector(n), a_: scalar(), b_: scalar(),
                         gp: scalar(), gr: scalar()},
      where=[let(Rm, LEFT)],
      given=[standing("the two forms", (gp == FORM_P) & (gr == FORM_R)), given("eigenvector", (CLOSED*g1 == a_*g1 - b_*g2) & (CLOSED*g2 == b_*g1 + a_*g2)),
             given("gamma*P gamma > 0", gp > 0), given("gamma*R gamma > 0", gr > 0)],
      by=[order([], [], [1*(gr/gp)], lemmas=[(a_**2 + b_**2 - 1)*gp == gr]),
          example(n=1, C=[[-1]], D=[[0]], P=[[1]], g1=[1], g2=[0], a=2, b=0, gp=1, gr=3),
          example(n=1, C=[["-1/2"]], D=[[0]], P=[[1]], g1=[1], g2=[0], a="1/2", b=0, gp=1, gr="-3/4"),
          example(n=1, C=[["-1/2"]], D=[[0]], P=[[-1]], g1=[1], g2=[0], a="1/2", b=0, gp=-1, gr="3/4"),
          instances(n=(1,), made_by={C: D*P - a_*I, b_: 0, **FORMS_MADE}),
          instances(n=(2,), using={E: nonsingular(2), c: scalar(), d: scalar()},
                    made_by={P: T(inv(E))*inv(E), C: D*P - E*rows([[a_, b_], [-b_, a_]])*inv(E), g1: E*rows([[c], [-d]]), g2: E*rows([[d], [c]]),
                              **FORMS_MADE})],
      note="gamma = g1 + i g2 and psi = a + ib; the forms are gamma*P gamma and gamma*R gamma, and psi* psi = a^2 + b^2.")

R_ZERO = given("gamma*R gamma = 0", T(g)*LEFT*g == Zero(q, q))
MODEL_P = {**MODEL, P: symmetric_matrix(n), g: matrix(n, q)}
PARTS = [T(g)*P*T(M)*inv(V)*M*P*g, T(S*P*g + g)*inv(Phi)*H*inv(T(Phi))*(S*P*g + g)]
ZERO_SUM = (PARTS[0] + PARTS[1])*Identity(q) == Zero(q, q)
#: undriven: P vanishes on gamma; unobservable and random walk; driven and measured with R > 0
REST = {"n": 1, "p": 1, "q": 1, "V": [[1]], "g": [1]}
FORMS = [example({**REST, "Phi": [["1/2"]], "H": [[0]], "M": [[1]], "P": [[0]]}), example({**REST, "Phi": [[-1]], "H": [[0]], "M": [[0]], "P": [[3]]}),
         example({**REST, "Phi": [[1]], "H": [["1/2"]], "M": [[1]], "P": [[1]]}),
         example(n=2, p=1, q=1, Phi=[["1/2", 0], [0, 1]], H=[[0, 0], [0, "1/2"]], M=[[0, 1]], V=[[1]], P=[[0, 0], [0, 1]], g=[2, 0]),
         example(n=1, p=1, q=1, Phi=[[1]], H=[["4/3"]], M=[[1]], V=[[1]], P=[["-2/3"]], g=[1])]
QUIET = instances(8, n=(2, 3), p=(1, 2), q=(1,), using={E: nonsingular(n), d: vector(n), X: matrix(n - q, n - q), B: matrix(p, n - q)},
                  made_by={Phi: E*matrix_of(i, j, n, n, when(i == j, 1/(1 + d[i]**2), 0))*inv(E), g: T(inv(E))*FIRST, V: Identity(p),
                           P: E*matrix_of(i, j, n, n, when((i == j) & (i > q), 1 + d[i]**2, 0))*T(E), M: hstack(Zero(p, q), B)*inv(E), **SOLVED})

claim("D71-E3.105", "what a zero of the form R says",
      (S*P*g == Zero(n, q)) & (H*PhiT*g == Zero(n, q)),
      sizes=["n", "p", "q"], over=MODEL_P, where=COEFFICIENTS, given=[EQUILIBRIUM, R_ZERO],
      by=[order([], [], PARTS, PARTS, lemmas=[LEFT == P*S*P + T(S*P + I)*inv(Phi)*H*inv(T(Phi))*(S*P + I), ZERO_SUM, S*P*g == Zero(n, q),
                                       H*PhiT*(S*P*g + g) == Zero(n, q)]), *FORMS, QUIET],
      note="R is the left side of (3.100), which is the form with the weight G put right in D71-E3.102.")

CHAIN = [given("eigenvector", (D*P - C)*g == g*Psi), given("(3.105)", S*P*g == Zero(n, q)), given("(3.106)", H*PhiT*g == Zero(n, q))]
TURN = {"n": 2, "p": 1, "q": 2, "Phi": [["3/5", "4/5"], ["-4/5", "3/5"]], "H": [[0, 0], [0, 0]], "M": [[0, 0]], "V": [[1]], "P": [[1, 0], [0, 1]],
        "g": [[1, 0], [0, 1]], "Psi": [["3/5", "4/5"], ["-4/5", "3/5"]]}
CHAIN_OVER = {**MODEL_P, Psi: nonsingular(q)}
#: the undriven modes 1 + 2i and 1 - 2i, with the equilibrium P = 0 and a nonderogatory R_p
SPIRAL = {**TURN, "Phi": [[1, 2], [-2, 1]], "M": [[1, 1]], "P": [[0, 0], [0, 0]], "Psi": [["1/5", "2/5"], ["-2/5", "1/5"]]}
CHAIN_BY = [example(SPIRAL), example(TURN), example({**REST, "Phi": [[1]], "H": [[0]], "M": [[1]], "P": [[1]], "Psi": [[2]]}),
            example({**REST, "Phi": [[1]], "H": [[1]], "M": [[1]], "P": [[0]], "Psi": [[1]]}),
            example({**REST, "Phi": [[1]], "H": [[0]], "M": [[1]], "P": [[0]], "Psi": [[2]]}),
            instances(8, n=(2, 3), p=(1, 2), q=(1, 2), using={**AUX, K: symmetric_matrix(n - q)},
                      made_by={Phi: E*LOWER*inv(E), H: E*diag(Zero(q, q), Y*T(Y))*T(E), g: inv(T(E))*FIRST, P: E*diag(Zero(q, q), K)*T(E), Psi: inv(T(D1))})]

claim("D71-E3.107", "gamma is an eigenvector of the adjoint of Phi",
      (T(Phi)*g == g*inv(T(Psi))) & (H*g == Zero(n, q)),
      sizes=["n", "p", "q"], over=CHAIN_OVER, where=COEFFICIENTS, given=CHAIN, by=CHAIN_BY,
      repair=repair("factor", "the factor is 1/psi, which is lambda* for the mode lambda = (psi*)^{-1}; the print has lambda",
                    (T(Phi)*g == g*inv(Psi)) & (H*g == Zero(n, q)),
                    sizes=["n", "p", "q"], over=CHAIN_OVER, where=COEFFICIENTS, given=CHAIN, by=CHAIN_BY),
      note="psi stands on the right as a matrix; a complex one is [[a, b], [-b, a]] with gamma = [u, v], and psi* is its transpose. The two agree for real psi. "
           "The counterexample has the undriven modes 1 + 2i and 1 - 2i, P = 0 and psi = (1 + 2i)/5; its R_p has four different eigenvalues.")

claim("D71-S38", "the conjugate reciprocal of psi is an undriven mode",
      (T(Phi)*g == g*T(Lam)) & (H*g == Zero(n, q)),
      sizes=["n", "p", "q"], over={**CHAIN_OVER, Lam: matrix(q, q)}, where=COEFFICIENTS, given=[*CHAIN, given("lambda = (psi*)^{-1}", Lam == inv(T(Psi)))],
      by=[example({**TURN, "Lam": [["3/5", "4/5"], ["-4/5", "3/5"]]}),
          example({**REST, "Phi": [[1]], "H": [[0]], "M": [[1]], "P": [[1]], "Psi": [[2]], "Lam": [["1/2"]]}),
          example({**REST, "Phi": [[1]], "H": [[1]], "M": [[1]], "P": [[0]], "Psi": [[1]], "Lam": [[1]]}),
          example({**REST, "Phi": [[1]], "H": [[0]], "M": [[1]], "P": [[0]], "Psi": [[2]], "Lam": [["1/2"]]}),
          example({**REST, "Phi": [[1]], "H": [[0]], "M": [[1]], "P": [[0]], "Psi": [[1]], "Lam": [[2]]}),
          instances(8, n=(2, 3), p=(1, 2), q=(1, 2), using={**AUX, K: symmetric_matrix(n - q)},
                    made_by={Phi: E*LOWER*inv(E), H: E*diag(Zero(q, q), Y*T(Y))*T(E), g: inv(T(E))*FIRST, P: E*diag(Zero(q, q), K)*T(E), Psi: inv(T(D1)),
                             Lam: D1})],
      note="Phi' gamma = lambda* gamma and H gamma = 0 say that the mode lambda is undriven.")

Q = sym("Q")

claim("D71-S37", "Q is nonnegative definite if J is outside the unit circle",
      psd(Q),
      sizes=["q"], over={Q: symmetric_matrix(q), J: matrix(q, q)},
      given=[given("(3.99)", psd(T(J)*Q*J - Q)), given("|eigenvalues of J| > 1", schur(inv(J)))],
      by=[order([T(inv(J))*(T(J)*Q*J - Q)*inv(J)], inside=[within(0, stein=T(inv(J)))]),
          example(q=1, Q=[[-1]], J=[["1/2"]]), example(q=1, Q=[[-1]], J=[[2]]),
          instances(q=(1, 2, 3), using={E: nonsingular(q), d: vector(q), X: matrix(q, q)},
                    made_by={J: E*matrix_of(i, j, q, q, when(i == j, 2 + d[i]**2, 0))*inv(E),
                             Q: T(inv(E))*matrix_of(i, j, q, q, (X*T(X))[i, j]/((2 + d[i]**2)*(2 + d[j]**2) - 1))*inv(E)})])

# --- the theorem on the sign ------------------------------------------------------------------------------------------------

Gn = sym("Gn")
NO_CIRCLE = given("R_p is nonderogatory", invertible(matrix_of(i, j, 2*n, 2*n, (Rp**(j - 1)*bv)[i])))
WITH_J = {**MODEL, P: symmetric_matrix(n), Gn: nonsingular(n), bv: vector(2*n)}
PARTED = {**MODEL, P: symmetric_matrix(n), G1: matrix(n, q), G2: matrix(n, n - q), J1: nonsingular(q), J2: nonsingular(n - q), bv: vector(2*n)}
J_OF_P = inv(T(Phi))*(S*P + I)
#: driven and undriven parts joined: J = [[1/2, -1/4], [0, 1/2]], and 1/2 is the reciprocal of the undriven mode 2
JOINED = {"n": 2, "p": 1, "Phi": [[2, 0], [1, 1]], "H": [[0, 0], [0, "1/2"]], "M": [[0, 1]], "V": [[1]], "P": [[0, 0], [0, "-1/2"]], "bv": [1, 0, 0, 1]}
APART = {"n": 2, "p": 2, "M": [[1, 0], [0, 1]], "V": [[1, 0], [0, 1]], "Phi": [[2, 0], [0, 1]], "H": [[0, 0], [0, "1/2"]], "bv": [1, 1, 1, 3]}
THREE_WAYS = [example({**JOINED, "q": 0, "G1": [[], []], "G2": [[1, 0], [0, 1]], "J1": [], "J2": [["1/2", "-1/4"], [0, "1/2"]]}),
              example({**APART, "bv": [1, 1, 1, 0], "Phi": [[3, 0], [0, 1]], "q": 1, "G1": [[0], [1]], "G2": [[1], [0]], "J1": [[2]], "J2": [["1/3"]], "P": [[0, 0], [0, 1]]}),
              example({**APART, "bv": [1, 1, 1, 0], "Phi": [[3, 0], [0, 1]], "q": 1, "G1": [[1], [0]], "G2": [[0], [1]], "J1": [[3]], "J2": [["1/2"]],
                       "P": [[8, 0], [0, "-1/2"]]})]

#: one mode, each without one of the hypotheses of the repair
ONE_MODE = {"n": 1, "p": 1, "M": [[1]], "V": [[1]], "bv": [1, 0]}
NO_J1, NO_J2 = {"q": 0, "G1": [[]], "J1": []}, {"q": 1, "G2": [[]], "J2": []}
BROKEN = [example({**ONE_MODE, **NO_J1, "Phi": [[2]], "H": [[0]], "P": [["1/2"]], "G2": [[1]], "J2": [["3/4"]]}),
          example({**ONE_MODE, **NO_J1, "Phi": [[1]], "H": [[0]], "M": [[0]], "P": [[1]], "G2": [[1]], "J2": [[1]]}),
          example({**ONE_MODE, **NO_J1, "Phi": [[1]], "H": [["1/2"]], "P": [["-1/2"]], "G2": [[0]], "J2": [["1/2"]]}),
          example({**ONE_MODE, **NO_J1, "Phi": [[1]], "H": [["1/2"]], "P": [[1]], "G2": [[1]], "J2": [["1/2"]]}),
          example({**ONE_MODE, **NO_J2, "Phi": [[1]], "H": [["1/2"]], "P": [["-1/2"]], "G1": [[1]], "J1": [["1/2"]]})]
#: the columns of T that belong to J_2
FF, GG, JJ = symbols("FF GG JJ")
INNER = {**MODEL, FF: matrix(n, q), GG: matrix(n, q), JJ: matrix(q, q), l: nonzero(), u: vector(n), bv: vector(2*n)}
SECOND_PART = given("(3.95)", Rp*vstack(FF, GG) == vstack(FF, GG)*JJ)
ALSO_UNDRIVEN = given("an undriven mode", (T(Phi)*u == l*u) & (H*u == Zero(n, 1)) & (u != Zero(n, 1)))
INNER_JOINED = {key: value for key, value in JOINED.items() if key != "P"}
INNER_ONE = {"n": 1, "p": 1, "q": 1, "Phi": [[2]], "H": [[0]], "M": [[1]], "V": [[1]], "FF": [[0]], "GG": [[1]], "JJ": [["1/2"]], "l": 2, "u": [1],
             "bv": [1, 1]}

claim("D71-E3.96", "the columns that belong to undriven modes",
      FF == Zero(n, q),
      sizes=["n", "p", "q"], over=INNER, where=R_WHERE,
      given=[SECOND_PART, NO_CIRCLE, ALSO_UNDRIVEN, given("every eigenvalue of J_2 is its reciprocal", (l*JJ - Identity(q))**n == Zero(q, q))],
      by=[example({**INNER_JOINED, "q": 2, "FF": [[0, 0], [0, "-1/2"]], "GG": [[1, 0], [0, 1]], "JJ": [["1/2", "-1/4"], [0, "1/2"]], "l": 2, "u": [1, 0]}),
          instances(n=(1,), p=(1,), q=(1,))],
      repair=repair(
          "missing hypothesis", "(3.64) gives one column of T for each undriven mode; where J_2 has an eigenvalue more often, the other columns have F_2 != 0",
          FF == Zero(n, q),
          sizes=["n", "p", "q"], over=INNER, where=R_WHERE,
          given=[SECOND_PART, NO_CIRCLE, ALSO_UNDRIVEN, given("J_2 has the eigenvectors of its reciprocal only", l*JJ == Identity(q))],
          by=[steps("D71-E3.64", facts=["A nonderogatory matrix has one eigenvector, up to a factor, at each eigenvalue."],
                    prose="The columns of [F_2; Gamma_2] and [0; n] are eigenvectors of R_p at 1/lambda, and so multiples of the latter."),
              example(INNER_ONE), example({**INNER_ONE, "FF": [[3]], "GG": [[1]], "JJ": [["1/2"]]}), example({**INNER_ONE, "FF": [[3]], "JJ": [[2]]}),
              example({**INNER_ONE, "FF": [["-1/2"]], "Phi": [[1]], "H": [["1/2"]], "bv": [1, 0]}),
              # Example 3.1 with the undriven mode 2: two eigenvectors at 1/2
              example(n=2, p=1, q=1, **SWAP, FF=[[2], [3]], GG=[[0], [0]], JJ=[["1/2"]], l=2, u=[3, -2], bv=[1, 2, 3, 4]),
              instances(6, n=(2,), p=(2,), q=(1,), using={E: nonsingular(2), w: scalar(), c: scalar()},
                        made_by={V: Identity(2), M: inv(E), Phi: E*diag(l, 1)*inv(E), H: E*diag(0, H2)*T(E), u: inv(T(E))*rows([[1], [0]]),
                                 bv: diag(E, inv(T(E)))*rows([[l**2 - 1], [w + 1/w - 2], [2], [2]]), FF: Zero(2, 1), GG: c*u, JJ: rows([[1/l]])})]),
      note="For one real undriven mode lambda. The counterexample is that of D71-T3.17, with J_2 = [[1/2, -1/4], [0, 1/2]]; its second column has "
           "F_2 = (0, -1/2).")

_W = 2 + c**2

claim("D71-T3.17", "which equilibria are nonnegative definite",
      psd(P),
      sizes=["n", "p"], over={**WITH_J, l: scalar(), u: vector(n)}, where=R_WHERE,
      given=[EQUILIBRIUM, NO_CIRCLE, given("an undriven mode", (T(Phi)*u == l*u) & (H*u == Zero(n, 1)) & (u != Zero(n, 1))),
             given("every eigenvalue of J is its reciprocal", (l*J_OF_P - I)**n == Zero(n, n))],
      by=[example({**JOINED, "Gn": [[1, 0], [0, 1]], "l": 2, "u": [1, 0]}), instances(n=(1,), p=(1,))],
      repair=repair(
          "missing hypothesis", "an eigenvalue may be in J more often than among the undriven modes; what decides is whether P vanishes on all the vectors "
          "of J that do not belong to eigenvalues outside the circle, which makes them undriven modes",
          iff(psd(P), P*G2 == Zero(n, n - q)),
          sizes=["n", "p", "q"], over=PARTED, where=R_WHERE,
          given=[EQUILIBRIUM, NO_CIRCLE, given("(3.94)", J_OF_P*hstack(G1, G2) == hstack(G1, G2)*diag(J1, J2)),
                 given("Gamma is nonsingular", rank(hstack(G1, G2)) == n), given("J_1 is outside the circle", schur(inv(J1))),
                 given("J_2 is not", outside_roots(charpoly(J2)) == 0)],
          by=[steps("D71-E3.103", "D71-E3.105", "D71-S38", "D71-E3.64", "D71-E8.16",
                    facts=["Jordan's theorem.", "The powers of a matrix whose eigenvalues lie inside the unit circle tend to zero."],
                    prose="If P vanishes on Gamma_2 then Gamma*P Gamma is diag(Q_11, 0), and Q_11 >= 0 as J_1 is outside the circle. If P >= 0, then on the part "
                          "inside the circle Q - J*QJ is -R <= 0, so that Q, the sum of the (J*)^i(-R)J^i, is zero. On the circle gamma*R gamma = 0, and "
                          "[0; gamma] is an eigenvector of R_p beside [P gamma; gamma], so that P gamma = 0; the same holds along a chain."),
              *THREE_WAYS,
              example({**APART, "bv": [1, 1, 1, 0], "Phi": [[3, 0], [0, 1]], "q": 1, "G1": [[1], [0]], "G2": [[0], [1]], "J1": [[3]], "J2": [[2]], "P": [[8, 0], [0, 1]]}),
              *BROKEN,
              instances(4, n=(1,), p=(1,), q=(1,), using={c: scalar()},
                        made_by={Phi: rows([[1]]), M: rows([[1]]), V: rows([[1]]), H: rows([[(_W - 1)*(1 - 1/_W)]]), P: rows([[_W - 1]]), J1: rows([[_W]]),
                                 J2: Zero(0, 0), G2: Zero(1, 0), bv: rows([[1], [0]])})]),
      note="Read from right to left, for the case that J has one real eigenvalue, 1/lambda with an undriven mode lambda. The counterexample has the undriven "
           "mode 2, J = [[1/2, -1/4], [0, 1/2]], P = diag(0, -1/2) and a nonderogatory R_p. In the proof F_2 = 0 is taken from (3.64), which gives one "
           "column of T for each undriven mode and not one for each column of J_2.")
