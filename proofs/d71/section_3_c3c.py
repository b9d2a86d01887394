# SPDX-License-Identifier: MIT
"""Existence and definiteness of equilibria (Chapter III, section C.3.c).

An equilibrium is P = F Gamma^{-1} with R_p[F; Gamma] = [F; Gamma]J. When does Gamma have an
inverse, and when is P singular? Multiply by a left eigenvector of R_p: an unobservable mode
gives [0, n*], so n*Gamma(J - 1/lambda*) = 0, and Gamma is singular if 1/lambda* is not in J.
If J has lambda itself, the column of T that belongs to it is [n; 0], provided that R_p has
no other eigenvector there. An undriven mode gives [n*, 0] and [0; n] and says the same of F.

For a Hermitian P put Q = Gamma*P Gamma. Then J*QJ - Q is [F*, Gamma*]G[F; Gamma] with a
nonnegative definite G, which ties the sign of P to the eigenvalues of J.

Two nonnegative equilibria whose matrices J differ in one eigenvalue only, psi and 1/psi*
with |psi| > 1: then Gamma_a*(P_a - P_b)Gamma_a has a single entry d, and (|psi|^2 - 1)d is
a square. An undriven mode inside the circle makes every nonnegative equilibrium singular,
because n*Pn = |lambda|^2 n*Qn <= |lambda|^2 n*Pn.

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
    eq,
    given,
    hstack,
    inv,
    invertible,
    let,
    loewner,
    matrix,
    matrix_of,
    nonsingular,
    pd,
    positive_definite,
    positive_semidefinite,
    psd,
    rows,
    scalar,
    standing,
    substitute,
    symbols,
    symmetric_matrix,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import H, M, P, Phi, V, gram, i, j, n, p, step, update

q, F, Gam, J, N, Lam, S, Rp, E, K, x = symbols("q F Gam J N Lam S Rp E K x")
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
