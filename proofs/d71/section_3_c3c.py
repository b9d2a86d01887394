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
from exactkf.evidence import example, instances, order, steps
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    charpoly,
    coprime,
    det,
    diag,
    given,
    hstack,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_definite,
    positive_semidefinite,
    psd,
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
TWO = {"n": (2,), "p": (1,)}
HIDDEN = {"using": {E: nonsingular(2), w: scalar(), l: scalar()},
          "made_by": {b: 0, V: rows([[1]]), M: rows([[0, 1]])*inv(E), Phi: E*diag(a, 1)*inv(E), H: E*diag(l**2, H2)*T(E), N: E*rows([[1, 0], [0, 0]]),
                      bv: diag(E, inv(T(E)))*rows([[1 + l**2/a], [w + 1/w - 2], [1/a - a], [2]])}}
#: unobservable: the columns of T at lam, at w, at 1/w and at 1/lam
AT_LAM, AT_W, AT_1W = ([1, 0], [0, 0]), ([0, w - 1], [0, 1]), ([0, 1/w - 1], [0, 1])
AT_1LAM = ([l**2/a, 0], [1/a - a, 0])


def columns(one, two, first, second):
    """F, Gamma and J from two eigenvectors."""
    return {F: E*rows([[one[0][0], two[0][0]], [one[0][1], two[0][1]]]), Gam: inv(T(E))*rows([[one[1][0], two[1][0]], [one[1][1], two[1][1]]]),
            J: rows([[first, 0], [0, second]])}


def family(base, *choice):
    """Instances with the two eigenvectors chosen."""
    return instances(5, **TWO, using=base["using"], made_by={**base["made_by"], **columns(*choice)})


NONDEROGATORY = given("R_p is nonderogatory", invertible(matrix_of(i, j, 2*n, 2*n, (Rp**(j - 1)*bv)[i])))
TRIPLE = {**MODEL, F: matrix(n, n), Gam: matrix(n, n), J: matrix(n, n), a: scalar(), b: scalar(), N: matrix(n, 2)}
HIDES = [given("an unobservable mode", (Phi*N == N*PAIR) & (M*N == Zero(p, 2))), given("its eigenvector is not zero", N != Zero(n, 2))]
SWAP = {"V": [[1]], "M": [[-1, "2/3"]], "Phi": [[2, -1], [0, "1/2"]], "H": [[4, 6], [6, 9]]}
#: Example 3.1: derogatory, with the unobservable mode 1/2 in J and a nonsingular Gamma
DEROGATORY = example({"n": 2, "p": 1, **SWAP, "F": [[8, 0], [12, 0]], "Gam": [[0, 3], [1, -2]], "J": [[2, 0], [0, "1/2"]], "a": "1/2", "b": 0,
                      "N": [[2, 0], [3, 0]], "bv": [1, 2, 3, 4]})
#: one driven and measured mode with the equilibrium P = 1, J = 2
ORDINARY = {"n": 1, "p": 1, "Phi": [[1]], "H": [["1/2"]], "M": [[1]], "V": [[1]], "F": [[1]], "Gam": [[1]], "J": [[2]]}
MODE_NOTE = ("The mode is lambda = a + ib with the eigenvector u + iv, N = [u, v]; for a real one b = 0. A matrix is nonderogatory exactly if some vector "
             "b makes b, Rb, R^2 b, ... a basis.")
ROTATION = {"n": 2, "p": 1, "Phi": [[1, 2], [-2, 1]], "V": [[1]], "a": 1, "b": 2}

claim("D71-T3.13.a", "Gamma is singular if J has an unobservable mode",
      det(Gam) == 0,
      sizes=["n", "p"], over={**TRIPLE, bv: vector(2*n)}, where=R_WHERE,
      given=[RT_TJ, *HIDES, given("the mode is in J", ~coprime(charpoly(J), charpoly(PAIR))), NONDEROGATORY],
      by=[steps("D71-E3.66", facts=["A nonderogatory matrix has one eigenvector, up to a factor, at each eigenvalue."],
                prose="If Jx = lambda x then Tx is an eigenvector of R_p, or zero; so is [n; 0], hence Tx is a multiple of it and Gamma x = 0."),
          DEROGATORY, example({**ORDINARY, "a": 2, "b": 0, "N": [[1, 0]], "bv": [1, 0]}),
          example({**ORDINARY, "a": 2, "b": 0, "N": [[0, 0]], "bv": [1, 0]}),
          example({**ROTATION, "H": [[1, 0], [0, 2]], "M": [[0, 0]], "N": [[1, 0], [0, 1]], "J": [[1, 2], [-2, 1]], "F": [[1, 0], [0, 1]],
                   "Gam": [[0, 0], [0, 0]], "bv": [1, 0, 1, 0]}),
          family(HIDDEN, AT_LAM, AT_W, a, w), family(HIDDEN, AT_LAM, AT_1W, a, 1/w), family(HIDDEN, AT_1LAM, AT_W, 1/a, w)],
      note=MODE_NOTE)

claim("D71-T3.13.b", "Gamma is singular if the conjugate reciprocal of an unobservable mode is not in J",
      det(Gam) == 0,
      sizes=["n", "p"], over=TRIPLE, where=R_WHERE,
      given=[RT_TJ, *HIDES, given("the conjugate reciprocal is not in J", coprime(charpoly(J), charpoly(inv(T(PAIR)))))],
      by=[steps("D71-E3.77", facts=["A matrix minus a number that is no eigenvalue is nonsingular."],
                prose="n*Gamma is a left eigenvector of J at 1/lambda*, or zero; as J has no such eigenvalue it is zero."),
          example({**ORDINARY, "a": 2, "b": 0, "N": [[1, 0]]}), example({**ORDINARY, "a": 2, "b": 0, "N": [[0, 0]]}),
          example({**ROTATION, "H": [[1, 0], [0, 2]], "M": [[0, 0]], "N": [[1, 0], [0, 1]], "J": [[1, 2], [-2, 1]], "F": [[1, 0], [0, 1]],
                   "Gam": [[0, 0], [0, 0]]}),
          family(HIDDEN, AT_LAM, AT_W, a, w), family(HIDDEN, AT_LAM, AT_1W, a, 1/w), family(HIDDEN, AT_W, AT_1W, w, 1/w),
          family(HIDDEN, AT_1LAM, AT_W, 1/a, w)],
      note="The mode is lambda = a + ib with the eigenvector u + iv, N = [u, v]. J and R_p may be derogatory: that R_p is not is needed for part (a) only.")

# the first coordinate is undriven: h = 0, phi = a, s = 1
TWO_TWO = {"n": (2,), "p": (2,)}
LOUD = {"using": {E: nonsingular(2), w: scalar()},
        "made_by": {b: 0, V: Identity(2), M: inv(E), Phi: E*diag(a, 1)*inv(E), H: E*diag(0, H2)*T(E), N: inv(T(E))*rows([[1, 0], [0, 0]]),
                    bv: diag(E, inv(T(E)))*rows([[a**2 - 1], [w + 1/w - 2], [2], [2]])}}
AT_A, AT_1A = ([a**2 - 1, 0], [1, 0]), ([0, 0], [1, 0])


def loud(*choice):
    """Instances with the two eigenvectors chosen."""
    return instances(5, **TWO_TWO, using=LOUD["using"], made_by={**LOUD["made_by"], **columns(*choice), P: F*inv(Gam)})


DRIVES = [given("an undriven mode", (T(Phi)*N == N*T(PAIR)) & (H*N == Zero(n, 2))), given("its eigenvector is not zero", N != Zero(n, 2))]
IF_EXISTS = standing("P_e = F Gamma^{-1} where that exists", invertible(Gam) >> (P*Gam == F))
#: Gamma is singular and P does not matter
NO_P = {"n": 1, "p": 1, "Phi": [[2]], "H": [[0]], "M": [[1]], "V": [[1]], "F": [[0]], "Gam": [[0]], "J": [["1/2"]], "a": 2, "b": 0, "N": [[1, 0]], "P": [[5]]}

claim("D71-T3.14.a", "F is singular if J has the conjugate reciprocal of an undriven mode",
      (det(F) == 0) & (invertible(Gam) >> (P*N == Zero(n, 2))),
      sizes=["n", "p"], over={**TRIPLE, P: matrix(n, n), bv: vector(2*n)}, where=R_WHERE,
      given=[RT_TJ, IF_EXISTS, *DRIVES, given("its conjugate reciprocal is in J", ~coprime(charpoly(J), charpoly(inv(T(PAIR))))), NONDEROGATORY],
      by=[steps("D71-E3.64", "D71-E3.78", facts=["A nonderogatory matrix has one eigenvector, up to a factor, at each eigenvalue."],
                prose="If Jx = x/lambda* then Tx is an eigenvector of R_p, or zero; so is [0; n], hence Fx = 0 and Gamma x is a multiple of n, not zero "
                      "if Gamma is nonsingular."),
          example({**ORDINARY, "a": "1/2", "b": 0, "N": [[1, 0]], "P": [[1]], "bv": [1, 0]}), example({**NO_P, "bv": [1, 0]}),
          example({**ORDINARY, "a": "1/2", "b": 0, "N": [[0, 0]], "P": [[1]], "bv": [1, 0]}),
          # Example 3.1: the undriven mode 2, with 1/2 in J
          example({"n": 2, "p": 1, **SWAP, "F": [[8, 25], [12, 24]], "Gam": [[0, 3], [1, 0]], "J": [[2, 0], [0, 2]], "a": 2, "b": 0,
                   "N": [[3, 0], [-2, 0]], "P": [[1, 0], [0, 1]], "bv": [1, 2, 3, 4]}),
          example({"n": 2, "p": 1, **SWAP, "F": [[8, 2], [12, 3]], "Gam": [[1, 3], [1, -2]], "J": [[2, 0], [0, "1/2"]], "a": 2, "b": 0,
                   "N": [[3, 0], [-2, 0]], "P": [[1, 0], [0, 1]], "bv": [1, 2, 3, 4]}),
          example({**ROTATION, "H": [[0, 0], [0, 0]], "M": [[1, 1]], "N": [[1, 0], [0, 1]], "J": [["1/5", "-2/5"], ["2/5", "1/5"]], "F": [[0, 0], [0, 0]],
                   "Gam": [[1, 0], [0, 1]], "P": [[0, 0], [0, 0]], "bv": [1, 0, 0, 1]}),
          loud(AT_1A, AT_W, 1/a, w), loud(AT_1A, AT_1W, 1/a, 1/w), loud(AT_A, AT_W, a, w)],
      note=MODE_NOTE)

claim("D71-T3.14.b", "F is singular if an undriven mode is not in J",
      (det(F) == 0) & (invertible(Gam) >> (T(N)*P == Zero(2, n))),
      sizes=["n", "p"], over={**TRIPLE, P: matrix(n, n)}, where=R_WHERE,
      given=[RT_TJ, IF_EXISTS, *DRIVES, given("the mode is not in J", coprime(charpoly(J), charpoly(PAIR)))],
      by=[steps("D71-E3.80", facts=["A matrix minus a number that is no eigenvalue is nonsingular."],
                prose="n*F is a left eigenvector of J at lambda, or zero; as J has no such eigenvalue it is zero, and so is n*P = n*F Gamma^{-1}."),
          example({**ORDINARY, "a": "1/2", "b": 0, "N": [[1, 0]], "P": [[1]]}), example(NO_P),
          example({**ORDINARY, "a": "1/2", "b": 0, "N": [[0, 0]], "P": [[1]]}),
          example({**ROTATION, "H": [[0, 0], [0, 0]], "M": [[1, 1]], "N": [[1, 0], [0, 1]], "J": [["1/5", "-2/5"], ["2/5", "1/5"]], "F": [[0, 0], [0, 0]],
                   "Gam": [[1, 0], [0, 1]], "P": [[0, 0], [0, 0]]}),
          loud(AT_1A, AT_W, 1/a, w), loud(AT_1A, AT_1W, 1/a, 1/w), loud(AT_A, AT_W, a, w),
          ],
      note="J and R_p may be derogatory. The vector that P takes to zero stands on the left here, n*P = 0, and on the right in part (a).")

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
ONE_EIGEN = example(n=1, p=1, q=1, Phi=[["1/2"]], H=[[0]], M=[[1]], V=[[1]], F=[[3]], Gam=[[-4]], J=[["1/2"]])


def square(corner):
    """(3.99)."""
    return (FORM == T(TT)*weight(corner)*TT) & psd(FORM)


claim("D71-E3.99", "J*QJ - Q is nonnegative definite",
      square(Zn), sizes=["n", "p", "q"], over=EIGEN, where=R_WHERE, given=[RT_TJ],
      by=[ONE_EIGEN, instances(n=(1, 2), p=(1, 2), q=(2, 4), **EIGEN_MADE)],
      repair=repair("other", CORNER, square(I), sizes=["n", "p", "q"], over=EIGEN, where=R_WHERE, given=[RT_TJ],
                    by=[order([], [T(F)*T(M)*inv(V)*M*F, T(S*F + Gam)*inv(Phi)*H*inv(T(Phi))*(S*F + Gam)]),
                        ONE_EIGEN, instances(n=(1, 2), p=(1, 2), q=(2, 4), **EIGEN_MADE)]),
      note="F, Gamma and J stand for F_1, Gamma_1 and J_1; nothing is asked of the eigenvalues.")

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

m2, gp, gr = symbols("m2 gp gr")

claim("D71-E3.104", "both forms positive",
      (m2 == 1 + gr/gp) & (m2 > 1),
      over={m2: scalar(), gp: scalar(), gr: scalar()},
      given=[given("(3.103)", (m2 - 1)*gp == gr), given("gamma*P gamma > 0", gp > 0), given("gamma*R gamma > 0", gr > 0)],
      by=[steps("D71-E3.103", prose="Divide by gamma*P gamma."), example(m2="1/2", gp=1, gr="-1/2"), example(m2="1/2", gp=-1, gr="1/2"),
          example(m2=2, gp=1, gr=2), instances(made_by={gr: (m2 - 1)*gp})],
      note="m2 is psi* psi, gp is gamma*P gamma and gr is gamma*R gamma.")

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
CHAIN_BY = [example(TURN), example({**REST, "Phi": [[1]], "H": [[0]], "M": [[1]], "P": [[1]], "Psi": [[2]]}),
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
      note="psi stands on the right as a matrix; a complex one is [[a, b], [-b, a]] with gamma = [u, v], and psi* is its transpose. The two agree for real psi.")

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
      by=[steps("D71-E8.16", facts=["The powers of a matrix whose eigenvalues lie inside the unit circle tend to zero.",
                                    "A limit of nonnegative definite matrices is nonnegative definite."],
                prose="Theorem 8.4: Q is the sum of the nonnegative terms (J^{-i})*(J*QJ - Q)J^{-i}, i >= 1."),
          example(q=1, Q=[[-1]], J=[["1/2"]]), example(q=1, Q=[[-1]], J=[[2]]),
          instances(q=(1, 2, 3), using={E: nonsingular(q), d: vector(q), X: matrix(q, q)},
                    made_by={J: E*matrix_of(i, j, q, q, when(i == j, 2 + d[i]**2, 0))*inv(E),
                             Q: T(inv(E))*matrix_of(i, j, q, q, (X*T(X))[i, j]/((2 + d[i]**2)*(2 + d[j]**2) - 1))*inv(E)})])
