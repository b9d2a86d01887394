# SPDX-License-Identifier: MIT
"""Undriven unstable modes: the reduced process, and stacked deviations (Chapter III, section C.4.b, end).

Let the columns of N_2 span the undriven unstable part of the null space of R_d and those of L
its orthogonal complement. As Phi' keeps the former, Phi keeps the latter: Phi L = L Phi_l. As
H annihilates N_2, H = LGL' with G = (L'L)^{-1}L'HL(L'L)^{-1}, which is nonnegative definite
and has a null vector wherever H has one outside the span of N_2. Then Phi^i H (Phi^i)' is
L Phi_l^i G (Phi_l^i)' L' for every i, so that R_d and R_g correspond if both are summed over
as many terms.

The equation U_{k+1} = K U_k Y with K = B - PD and Y = [(DP - C) + DU_k]^{-1}, written for the
columns of U_k one below the other, has the matrix Y' x K: column j of KUY is the sum of
Y_{ij} K u_i.

An equilibrium with B - PD inside the unit circle is positive definite unless a stable mode is
undriven (D71-Q2), and with such a mode it is not (Theorem 3.20), whatever the unstable modes
are.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, identity, induction, instances, order, part
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    given,
    inv,
    let,
    matrix,
    matrix_of,
    nonsingular,
    pd,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    rec,
    scalar,
    schur,
    standing,
    symbols,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import H, M, P, Phi, V, gain, i, j, k, kronecker, n, p, stacked, step

q, L, N2, G, E, c, X = symbols("q L N2 G E c X")
I = Identity(n)

# --- the reduced process --------------------------------------------------------------------------------------------------

LEFT = inv(T(L)*L)*T(L)
REDUCED = {H: positive_semidefinite(n), L: matrix(n, q), N2: matrix(n, n - q)}
SPLIT = [given("HN_2 = 0", H*N2 == Zero(n, n - q)), given("L and N_2 span the space", L*LEFT + N2*inv(T(N2)*N2)*T(N2) == I)]
FIRST = matrix_of(i, j, n, q, E[i, j])
LAST = matrix_of(i, j, n, n - q, E[i, j + q])
#: L from a basis E, N_2 orthogonal to it
MADE = {"using": {E: nonsingular(n), X: matrix(q, q)},
        "made_by": {L: FIRST, N2: matrix_of(i, j, n, n - q, inv(T(E))[i, j + q]), H: L*X*T(X)*T(L)}}
UNDRIVEN_STABLE = {"n": 2, "q": 1, "H": [[0, 0], [0, 0]], "L": [[1], [0]], "N2": [[0], [1]]}

claim("D71-E3.201", "the noise of the reduced process",
      (H == L*G*T(L)) & pd(G),
      sizes=["n", "q"], over=REDUCED, where=[let(G, LEFT*H*T(LEFT))], given=SPLIT,
      by=[example(UNDRIVEN_STABLE), instances(n=(1,), q=(1,))],
      repair=repair("other", "G need not be positive definite: it is singular if a stable mode is undriven, or if H has a null vector outside the span of N_2; "
                    "G >= 0 is what (3.192) has",
                    (H == L*G*T(L)) & psd(G), sizes=["n", "q"], over=REDUCED, where=[let(G, LEFT*H*T(LEFT))], given=SPLIT,
                    by=[order([], [], [], [], [LEFT*H*T(LEFT)], lemmas=[T(N2)*H == Zero(n - q, n), H == L*LEFT*H, H == H*T(LEFT)*T(L)]),
                        example(n=1, q=0, H=[[1]], L=[[]], N2=[[1]]),
                        example({**UNDRIVEN_STABLE, "H": [[1, 0], [0, 2]]}), example({**UNDRIVEN_STABLE, "H": [[1, 1], [1, 1]], "N2": [[1], [-1]]}),
                        instances(6, n=(1, 2, 3), q=(1, 2), **MADE)]),
      note="G is the only matrix with H = LGL'. The projections on the columns of L and of N_2 add up to I, as these are orthogonal complements. The "
           "counterexample is H = 0, where L = (1, 0) may belong to an undriven stable mode, as with Phi = diag(1/2, 2).")

Phil, Rd, Rg, Up, Ul, m = symbols("Phil Rd Rg Up Ul m")
CARRIED = {Phi: matrix(n, n), L: matrix(n, q), Phil: matrix(q, q), G: positive_semidefinite(q)}
SUMS = [rec(Up, k, I, Phi*Up[k]), rec(Ul, k, Identity(q), Phil*Ul[k]), rec(Rd, k, Zero(n, n), Rd[k] + Up[k]*H*T(Up[k])),
        rec(Rg, k, Zero(q, q), Rg[k] + Ul[k]*G*T(Ul[k]))]
INVARIANT = given("(3.200)", Phi*L == L*Phil)
CARRY = {"using": {E: nonsingular(n), X: matrix(n, n)},
         "made_by": {L: FIRST, Phi: E*matrix_of(i, j, n, n, when((i > q) & (j <= q), 0, X[i, j]))*inv(E), Phil: matrix_of(i, j, q, q, X[i, j])}}

claim("D71-E3.202", "the two state covariances",
      Rd[n] == L*Rg[q]*T(L),
      sizes=["n", "q"], over=CARRIED, where=[let(H, L*G*T(L)), *SUMS], given=[INVARIANT, given("L has independent columns", rank(L) == q)],
      by=[example(n=2, q=1, Phi=[["1/2", 0], [0, 2]], L=[[1], [0]], Phil=[["1/2"]], G=[[1]]), instances(n=(1,), q=(1,))],
      repair=repair("index", "both sums need as many terms; with n for m, as in the proof of Theorem 3.24, they agree",
                    always(k, Rd[k] == L*Rg[k]*T(L)), sizes=["n", "q"], over=CARRIED, where=[let(H, L*G*T(L)), *SUMS], given=[INVARIANT],
                    by=[induction(also=[Up[k]*L == L*Ul[k]]), example(n=1, q=1, Phi=[[2]], L=[[1]], Phil=[[1]], G=[[1]]),
                        instances(6, n=(2, 3), q=(1, 2), horizon=3, **CARRY)]),
      note="m is not introduced and is read as the order of the reduced system, which is q here. By the theorem of Cayley and Hamilton q terms are enough for "
           "the ranges to agree, which is all that (3.207) needs. In the counterexample R_d = diag(5/4, 0) and the right side is diag(1, 0).")

# --- deviations as vectors ------------------------------------------------------------------------------------------------

K, Lk, D, U, Y = symbols("K Lk D U Y")
STACK = {K: matrix(n, n), Lk: nonsingular(n), D: matrix(n, n), U: matrix(n, n)}
IS_Y = let(Y, inv(Lk + D*U))
NEXT_U = symbols("NEXT_U VEC_U")
W1, W0, F0 = symbols("W1 W0 F0")


def moved(matrix_):
    return [IS_Y, let(NEXT_U[0], K*U*Y), let(W1, stacked(NEXT_U[0])), let(W0, stacked(U)), let(F0, matrix_)]


claim("D71-E3.215", "the matrix of the stacked deviation",
      W1 == F0*W0,
      sizes=["n"], over=STACK, where=moved(kronecker(K, Y)),
      by=[example(n=2, K=[[1, 1], [0, 1]], Lk=[[1, 0], [0, 1]], D=[[0, 0], [0, 0]], U=[[1, 0], [0, 2]]), instances(n=(1,))],
      repair=repair("order of factors", "for stacked columns the product is Y' x (B - P_e D), with Y transposed and first",
                    W1 == F0*W0, sizes=["n"], over=STACK, where=moved(kronecker(T(Y), K)),
                    by=[identity(n=(1, 2)), instances(8, n=(1, 2))]),
      note="K is B - P_e D, Lk is DP_e - C, D any matrix, Y the inverse of Lk + DU_k, and A x B has the blocks a_{ij}B. The other order, Y x (B - P_e D), "
           "lacks the transpose as well. F(0) is in the same way the product of the conjugate of B - P_e D with B - P_e D; its eigenvalues are those of the "
           "printed one.")

# --- the stable equilibrium -----------------------------------------------------------------------------------------------

u, l, N = symbols("u l N")
CLOSED = Phi*(I - gain()*M)
EQUILIBRIUM = given("P is an equilibrium", P == step())
MODEL = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p), P: positive_semidefinite(n)}
UNDRIVEN = [standing("an undriven unstable mode", (T(Phi)*u == l*u) & (H*u == Zero(n, 1)) & (u != Zero(n, 1)) & (l**2 > 1)),
            standing("which is observable", rank(vstack(Phi - l*I, M)) == n)]
INSIDE = standing("B - PD is inside the circle", schur(CLOSED))
#: modes 2 and 1/2, both undriven
BOTH = example(n=2, p=1, Phi=[[2, 0], [0, "1/2"]], H=[[0, 0], [0, 0]], M=[[1, 1]], V=[[1]], P=[[3, 0], [0, 0]], u=[1, 0], l=2)
WHOLE = ("a stable mode may be undriven beside the unstable one, and then every nonnegative equilibrium is singular (Theorem 3.20); without one P_e1 is "
         "positive definite")
GAIN = gain()
TERMS = [T(N)*Phi*(I - GAIN*M)*P*T(I - GAIN*M)*T(Phi)*N, T(N)*Phi*GAIN*V*T(GAIN)*T(Phi)*N, T(N)*H*N]
GONE = Zero(n, q)
KEPT = [P == Phi*(I - GAIN*M)*P*T(I - GAIN*M)*T(Phi) + Phi*GAIN*V*T(GAIN)*T(Phi) + H, (TERMS[0] + TERMS[1] + TERMS[2])*Identity(q) == Zero(q, q),
        V*T(GAIN)*T(Phi)*N == Zero(p, q), T(GAIN)*T(Phi)*N == Zero(p, q), P*T(I - GAIN*M)*T(Phi)*N == GONE]
QUIET = {Phi: E*matrix_of(i, j, n, n, when(i == j, 1/(1 + c[i]**2), 0))*inv(E), M: matrix_of(i, j, p, n, when(i == j + 1, 1, 0))*inv(E),
         P: E*matrix_of(i, j, n, n, when((i == j) & (i > q), 1 + c[i]**2, 0))*T(E), N: inv(T(E))*matrix_of(i, j, n, q, when(i == j, 1, 0)),
         H: P - Phi*(P - GAIN*M*P)*T(Phi)}


def only_stable_modes():
    """Null vectors of P lie in a space of undriven stable modes."""
    return repair("missing hypothesis", WHOLE,
                  (H*N == GONE) & (P*T(Phi)*N == GONE) & (T(Phi)*N == T(CLOSED)*N),
                  sizes=["n", "p", "q"], over={**MODEL, N: matrix(n, q)}, given=[EQUILIBRIUM, given("null vectors of P", P*N == GONE)],
                  by=[part("the null vectors of P_e1; not the other equilibrium, nor the convergence"),
                      order([], [], TERMS, [inv(V)], TERMS, TERMS, [], [], lemmas=KEPT),
                      example(n=1, p=1, q=1, Phi=[["1/2"]], H=[["7/8"]], M=[[1]], V=[[1]], P=[[1]], N=[[1]]),
                      example(n=1, p=1, q=1, Phi=[[2]], H=[[1]], M=[[1]], V=[[1]], P=[[0]], N=[[1]]),
                      example(n=1, p=1, q=1, Phi=[[2]], H=[[0]], M=[[1]], V=[[1]], P=[[3]], N=[[1]]),
                      instances(8, n=(2, 3), p=(1, 2), q=(1,), using={E: nonsingular(n), c: vector(n)}, made_by=QUIET)])


STABLE_NOTE = ("The part on P_e1, the nonnegative equilibrium with B - PD inside the unit circle. The counterexample is Phi = diag(2, 1/2), H = 0, M = [1, "
               "1], V = 1 with P_e1 = diag(3, 0) and a regular stable mode. The repair says that null vectors of P are null vectors of H in a space on which "
               "Phi' acts like the adjoint of B - PD, as in D71-Q2: undriven stable modes. ")

claim("D71-Q4.b", "the stable equilibrium beside an undriven unstable mode",
      pd(P),
      sizes=["n", "p"], over={**MODEL, u: vector(n), l: scalar()}, given=[EQUILIBRIUM, INSIDE, *UNDRIVEN],
      by=[BOTH, instances(n=(1,), p=(1,))], repair=only_stable_modes(),
      note=STABLE_NOTE + "That there are two nonnegative equilibria and which initial values lead to each is not stated here.")
