# SPDX-License-Identifier: MIT
"""What was guessed from numerical examples, and a slip on the way (Chapter III, section C.3.c).

If the process falls apart into two that do not meet, two eigenvectors of R_p that belong to
one of the parts have upper and lower halves in that part only. With the eigenvalues w and 1/w
of a part of one state, T = [F; Gamma] has F and Gamma of rank one, although every mode may be
driven and measured and R_p have four different eigenvalues. So a singular Gamma or F need not
come from the modes. It does if all eigenvalues of J are outside the unit circle.

In that case F*Gamma is Hermitian and nonnegative definite, because J*(F*Gamma)J - F*Gamma is
nonnegative definite. It is real if T is.

Conventions as in section_3_c3c.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, instances, order, restated, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    given,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    rec,
    schur,
    symbols,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import H, M, P, Phi, V, gram, i, j, k, n, p, step

q, F, Gam, J, S, Rp, E, K, bv, c, N, B, D = symbols("q F Gam J S Rp E K bv c N B D")
I, Zn = Identity(n), Zero(n, n)
PhiT = inv(T(Phi))
MODEL = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}
R_WHERE = [let(S, gram()), let(Rp, block([[H*PhiT*S + Phi, H*PhiT], [PhiT*S, PhiT]]))]
TT = vstack(F, Gam)
RT_TJ = given("R_p T = TJ", Rp*TT == TT*J)
INDEPENDENT = given("T has independent columns", rank(TT) == n)
NONDEROGATORY = given("R_p is nonderogatory", invertible(matrix_of(i, j, 2*n, 2*n, (Rp**(j - 1)*bv)[i])))
OUTSIDE = given("the eigenvalues of J are outside the circle", schur(inv(J)))
Up, Rd, Down, Pd = symbols("Up Rd Down Pd")
R_SUM = [rec(Up, k, I, Phi*Up[k]), rec(Rd, k, Zn, Rd[k] + Up[k]*H*T(Up[k]))]
P_SUM = [rec(Down, k, I, Phi*Down[k]), rec(Pd, k, Zn, Pd[k] + T(Down[k])*T(M)*M*Down[k])]
OBSERVED = given("every mode is observable", invertible(Pd[n]))
DRIVEN = given("every mode is driven", invertible(Rd[n]))

# --- are the conditions of Theorems 3.13 and 3.14 necessary? ----------------------------------------------------------------

#: two states that do not meet, R_p with the eigenvalues 2, 1/2 and 3, 1/3; T belongs to the first state
APART = {"n": 2, "p": 2, "Phi": [[1, 0], [0, 1]], "H": [["1/2", 0], [0, "4/3"]], "M": [[1, 0], [0, 1]], "V": [[1, 0], [0, 1]],
         "F": [[1, "-1/2"], [0, 0]], "Gam": [[1, 1], [0, 0]], "J": [[2, 0], [0, "1/2"]]}
CYCLIC = {"bv": [0, 0, 1, 1]}
ANY_J = {**MODEL, F: matrix(n, n), Gam: matrix(n, n), J: nonsingular(n)}
W = 2 + c[i]**2
#: in the basis E every state is by itself, with phi = s = 1 and the eigenvalues w and 1/w; K mixes the columns of T
ALONE = {"using": {E: nonsingular(n), K: nonsingular(n), c: vector(n)},
         "made_by": {Phi: I, H: E*matrix_of(i, j, n, n, when(i == j, (W - 1)*(1 - 1/W), 0))*T(E), M: inv(E), V: I,
                     F: E*matrix_of(i, j, n, n, when(i == j, W - 1, 0))*K, Gam: inv(T(E))*K, J: inv(K)*matrix_of(i, j, n, n, when(i == j, W, 0))*K}}
BY_ITSELF = [instances(4, n=(1,), p=(1,), **ALONE), instances(4, n=(2,), p=(2,), **ALONE)]
ONE = {"n": 1, "p": 1, "Phi": [[1]], "H": [["1/2"]], "M": [[1]], "V": [[1]]}
#: undriven and unobservable: R_p = diag(2, 1/2); and T = 0, and a T that is no solution
UNSEEN = {**ONE, "Phi": [[2]], "M": [[0]], "F": [[1]], "Gam": [[0]], "J": [[2]]}
UNMOVED = {**ONE, "Phi": [["1/2"]], "H": [[0]], "F": [[0]], "Gam": [[1]], "J": [[2]]}
NOTHING = {**ONE, "F": [[0]], "Gam": [[0]], "J": [[2]]}

claim("D71-Q1.a", "does a singular Gamma come from an unobservable mode?",
      invertible(Gam),
      sizes=["n", "p"], over={**ANY_J, bv: vector(2*n)}, where=[*R_WHERE, *P_SUM], given=[RT_TJ, INDEPENDENT, NONDEROGATORY, OBSERVED],
      by=[example({**APART, **CYCLIC}), instances(n=(1,), p=(1,))],
      repair=repair(
          "missing hypothesis", "J may have w and 1/w of a part of the process that does not meet the rest; if all eigenvalues of J are outside the circle the "
          "conditions are necessary (Theorem 3.18)",
          invertible(Gam),
          sizes=["n", "p"], over=ANY_J, where=[*R_WHERE, *P_SUM], given=[RT_TJ, INDEPENDENT, OUTSIDE, OBSERVED],
          by=[example(APART), example({**UNSEEN, "H": [[0]]}), example(NOTHING), example({**NOTHING, "F": [[1]]}), *BY_ITSELF]),
      note="Read for a process without unobservable modes, where neither (a) nor (b) of Theorem 3.13 can be and Gamma would always be nonsingular. In the "
           "counterexample Phi = M = V = I and H = diag(1/2, 4/3), R_p has the eigenvalues 2, 1/2, 3 and 1/3, and J = diag(2, 1/2).")

claim("D71-Q1.b", "does a singular F come from an undriven mode?",
      invertible(F),
      sizes=["n", "p"], over={**ANY_J, bv: vector(2*n)}, where=[*R_WHERE, *R_SUM], given=[RT_TJ, INDEPENDENT, NONDEROGATORY, DRIVEN],
      by=[example({**APART, **CYCLIC}), instances(n=(1,), p=(1,))],
      repair=repair(
          "missing hypothesis", "J may have w and 1/w of a part of the process that does not meet the rest; with all eigenvalues of J outside the circle F is "
          "nonsingular if every mode is driven",
          invertible(F),
          sizes=["n", "p"], over=ANY_J, where=[*R_WHERE, *R_SUM], given=[RT_TJ, INDEPENDENT, OUTSIDE, DRIVEN],
          by=[example(APART), example(UNMOVED), example(NOTHING), example({**NOTHING, "Gam": [[1]]}), *BY_ITSELF]),
      note="Read for a process without undriven modes, where neither (a) nor (b) of Theorem 3.14 can be and F would always be nonsingular. The counterexample "
           "is that of D71-Q1.a: F has the columns (1, 0) and (-1/2, 0).")

# --- singular equilibria ------------------------------------------------------------------------------------------------------

EQUILIBRIUM = given("P is an equilibrium", P == step())
AFTER = P - P*T(M)*inv(M*P*T(M) + V)*M*P
GAIN = P*T(M)*inv(M*P*T(M) + V)
CLOSED = Phi*(I - GAIN*M)
#: P = Phi Q Phi' + H on a null vector, with Q in symmetric form
TERMS = [T(N)*Phi*(I - GAIN*M)*P*T(I - GAIN*M)*T(Phi)*N, T(N)*Phi*GAIN*V*T(GAIN)*T(Phi)*N, T(N)*H*N]
GONE = Zero(n, q)
SUM_GONE = (TERMS[0] + TERMS[1] + TERMS[2])*Identity(q) == Zero(q, q)
KEPT = [P == Phi*(I - GAIN*M)*P*T(I - GAIN*M)*T(Phi) + Phi*GAIN*V*T(GAIN)*T(Phi) + H, SUM_GONE,
        V*T(GAIN)*T(Phi)*N == Zero(p, q), T(GAIN)*T(Phi)*N == Zero(p, q), P*T(I - GAIN*M)*T(Phi)*N == GONE]
#: in the basis E, the first coordinate undriven and stable, the others driven or not
QUIET = {Phi: E*matrix_of(i, j, n, n, when(i == j, 1/(1 + c[i]**2), 0))*inv(E), M: matrix_of(i, j, p, n, when(i == j + 1, 1, 0))*inv(E),
         P: E*matrix_of(i, j, n, n, when((i == j) & (i > q), 1 + c[i]**2, 0))*T(E), N: inv(T(E))*matrix_of(i, j, n, q, when(i == j, 1, 0)),
         H: P - Phi*AFTER*T(Phi)}

claim("D71-Q2", "null vectors of the stable equilibrium",
      (H*N == GONE) & (P*T(Phi)*N == GONE) & (T(Phi)*N == T(CLOSED)*N),
      sizes=["n", "p", "q"], over={**MODEL, P: positive_semidefinite(n), N: matrix(n, q)}, given=[EQUILIBRIUM, given("null vectors of P", P*N == GONE)],
      by=[order([], [], TERMS, [inv(V)], TERMS, TERMS, [], [], lemmas=KEPT),
          restated("a space other than zero that a matrix keeps has an eigenvector of it", "J is similar to the inverse of the adjoint of B - PD"),
          example(n=1, p=1, q=1, Phi=[["1/2"]], H=[["7/8"]], M=[[1]], V=[[1]], P=[[1]], N=[[1]]),
          example(n=1, p=1, q=1, Phi=[[2]], H=[[1]], M=[[1]], V=[[1]], P=[[0]], N=[[1]]),
          example(n=1, p=1, q=1, Phi=[[2]], H=[[0]], M=[[1]], V=[[1]], P=[[3]], N=[[1]]),
          instances(8, n=(2, 3), p=(1, 2), q=(1,), using={E: nonsingular(n), c: vector(n)}, made_by=QUIET)],
      note="The null vectors of P are null vectors of H, and Phi' keeps their space and acts there like the adjoint of B - PD = Phi(I - K_e M). If J is "
           "outside the unit circle the eigenvalues of B - PD are inside, so an eigenvector of Phi' in that space is an undriven stable mode; an invariant "
           "space other than zero has one. So what the examples indicate is right: without such a mode P is positive definite.")

# --- the form F*Gamma -------------------------------------------------------------------------------------------------------

F1, F2, G1, G2, J1, J2, FR, GR, JR, Q = symbols("F1 F2 G1 G2 J1 J2 FR GR JR Q")


def complex_matrix(re, im):
    """The real matrix of order 2n that stands for re + i im."""
    return block([[re, im], [-im, re]])


COMPLEX = {**MODEL, F1: matrix(n, n), F2: matrix(n, n), G1: matrix(n, n), G2: matrix(n, n), J1: matrix(n, n), J2: matrix(n, n)}
C_WHERE = [*R_WHERE, let(FR, complex_matrix(F1, F2)), let(GR, complex_matrix(G1, G2)), let(JR, complex_matrix(J1, J2))]
FORM = T(F)*Gam
GAIN_OF_FORM = [T(F)*T(M)*inv(V)*M*F, T(S*F + Gam)*inv(Phi)*H*PhiT*(S*F + Gam)]
OF_P = {**MODEL, F: matrix(n, q), Gam: matrix(n, q), J: nonsingular(q)}
#: the undriven modes 1 + 2i and 1 - 2i, P = [[24, 8], [8, 8]]
SPIRAL = {"n": 2, "p": 1, "Phi": [[1, 2], [-2, 1]], "H": [[0, 0], [0, 0]], "M": [[1, 0]], "V": [[1]], "F1": [[-8, -8], [24, 24]], "F2": [[-24, 24], [-8, 8]],
          "G1": [[-2, -2], [5, 5]], "G2": [[-1, 1], [0, 0]], "J1": [[1, 0], [0, 1]], "J2": [[2, 0], [0, -2]]}
INSIDE = {"n": 1, "p": 1, "q": 1, "Phi": [[1]], "H": [["1/2"]], "M": [[1]], "V": [[1]]}

claim("D71-S48", "the form F*Gamma",
      (T(F1)*G2 - T(F2)*G1 == Zn) & psd(T(F1)*G1 + T(F2)*G2),
      sizes=["n", "p"], over=COMPLEX, where=C_WHERE,
      given=[given("R_p T = TJ", Rp*block([[F1, F2], [G1, G2]]) == block([[F1, F2], [G1, G2]])*JR), given("J is outside the circle", schur(inv(JR)))],
      by=[example(SPIRAL), instances(n=(1,), p=(1,))],
      repair=repair(
          "other", "it is real if T is; for complex eigenvalues of J it is Hermitian and nonnegative definite, which is all that the proof uses",
          psd(FORM),
          sizes=["n", "p", "q"], over=OF_P, where=R_WHERE, given=[RT_TJ, given("J is outside the circle", schur(inv(J)))],
          by=[order([], [T(inv(J))*term*inv(J) for term in GAIN_OF_FORM], lemmas=[T(F)*Gam - T(Gam)*F == Zero(q, q)],
                    inside=[within(0, unique=(T(inv(J)), inv(J))), within(1, stein=T(inv(J)))]),
              example({**INSIDE, "F": [["-1/2"]], "Gam": [[1]], "J": [["1/2"]]}), example({**INSIDE, "F": [[-1]], "Gam": [[1]], "J": [[2]]}),
              instances(4, n=(1,), p=(1,), q=(1,), **ALONE), instances(4, n=(2,), p=(2,), q=(2,), **ALONE)]),
      note="F = F1 + iF2 and so on; the imaginary part of F*Gamma is F1'G2 - F2'G1. The counterexample has the undriven modes 1 + 2i and 1 - 2i in J and "
           "conjugate columns in T. In the repair the transpose stands for the conjugate transpose, and the matrices are real of every size.")
