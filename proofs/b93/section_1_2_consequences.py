# SPDX-License-Identifier: MIT
"""What follows from the contraction (sections 1.2, 2.1 to 2.3), and the flow behind it.

A family N_t of Hamiltonian matrices with dN/dt = [[A, S], [R, -A*]]N acts on P_0 through
U = N_11P_0 + N_12 and V = N_21P_0 + N_22: then P = U inv(V) solves dP/dt = AP + PA* - PRP + S.

For constant controllable and observable (A, F, C) the power M^d is in H0 by Proposition 1.3.
If P is a fixed point of the action of a member of H0, the distance from P falls by a fixed
factor at every step.

The last inequalities bound the product of the matrices of the filter by a function V that
falls along the backward recursion.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import chosen, example, first, induction, instances, order, restated, spectral, square
from exactkf.evidence import part as only
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    cospectral,
    diagonal,
    forall,
    function,
    given,
    integer,
    inv,
    invertible,
    let,
    loewner,
    matrix,
    nonneg,
    nonsingular,
    pd,
    positive,
    positive_definite,
    positive_semidefinite,
    rec,
    sequence,
    sequence_of,
    signal_of,
    standing,
    sum_of,
    symbols,
    symmetric_matrix,
    vector,
)
from proofs.b93.notation import BY_NORMS, at_most, d, from_squares, hamiltonian, k, n, p, part, q, root_bound
from proofs.b93.section_1_2 import A, C, F, P, R, S
from proofs.b93.section_1_2_distance import LARGER, Max, eps, m, u, zeta

I, Zd = Identity(d), Zero(d, d)
(t,) = symbols("t")
STATISTICAL = "a statement about almost every sequence of a stationary ergodic process, beyond exact instances"

not_checked("B93-S3", "the main result, as announced", STATISTICAL)
not_checked("B93-S4", "continuous time", "a remark that results carry over, without a statement")

# --- the flow --------------------------------------------------------------------------------------------------------------

N11, N12, N21, N22, P0, U, V, dU, dV = symbols("N11 N12 N21 N22 P0 U V dU dV")
claim("B93-S29", "the continuous Riccati equation as an action",
      dU*inv(V) - U*inv(V)*dV*inv(V) == A*P + P*T(A) - P*R*P + S, sizes=["d"],
      over={A: matrix(d, d), R: symmetric_matrix(d), S: symmetric_matrix(d), N11: matrix(d, d), N12: matrix(d, d), N21: matrix(d, d), N22: matrix(d, d),
            P0: symmetric_matrix(d)},
      where=[let(U, N11*P0 + N12), let(V, N21*P0 + N22), let(P, U*inv(V)), let(dU, (A*N11 + S*N21)*P0 + A*N12 + S*N22),
             let(dV, (R*N11 - T(A)*N21)*P0 + R*N12 - T(A)*N22)],
      given=[standing("P is symmetric", T(U)*V == T(V)*U)],
      by=[order(), instances(6, d=(1, 2), made_by={N11: I, N12: Zd, N21: Zd, N22: I}), instances(6, d=(1,)),
          only("what equation P_t solves, not that N_t stays in H")],
      note="The left side is the derivative of P_t = U inv(V), where dN/dt = [[A, S], [R, -A*]]N; N_0 = I gives P_0. That N_t stays in H is a theorem on "
           "differential equations and not stated here.")

# --- the derivation of (iii) -----------------------------------------------------------------------------------------------

y1, y2, g1, g2, t1, t2, Goal, Known = symbols("y1 y2 g1 g2 t1 t2 Goal Known")


def apart(one, other):
    """The exponential of the distance of two positive numbers."""
    return Max(one/other, other/one)


ONE_STATE = {name: positive() for name in (y1, y2, g1, g2, t1, t2, q)} | {zeta: integer(1, 3), eps: integer(1, 3)}
STEP = [LARGER, let(Goal, apart(y1, y2)**(zeta + eps)), let(Known, apart(t1, t2)**zeta)]
SHOWN = given("the inequality before", apart(g1 + q, g2 + q)**(zeta + eps) <= Known)
claim("B93-S42", "what part (iii) is deduced from",
      Goal <= Known, over=ONE_STATE, where=STEP, given=[SHOWN],
      by=[example(y1=2, y2=1, g1=1, g2=1, t1=1, t2=1, q=1, zeta=1, eps=1), instances()],
      repair=repair("cross-reference", "it is (17), the decomposition of the action, that is needed besides, not (16)",
                    Goal <= Known, over=ONE_STATE, where=STEP,
                    given=[SHOWN, given("(17)", (y1 == 1/(g1 + q)) & (y2 == 1/(g2 + q)))],
                    by=[example(y1=2, y2=1, g1=1, g2=1, t1=1, t2=1, q=1, zeta=1, eps=1),
                        example(y1="1/2", y2="1/5", g1=1, g2=4, t1=1, t2=1, q=1, zeta=1, eps=1),
                        example(y1="1/2", y2="1/5", g1=1, g2=4, t1=25, t2=1, q=1, zeta=1, eps=3),
                        example(y1="1/3", y2="1/6", g1=2, g2=5, t1=4, t2=1, q=1, zeta=1, eps=1),
                        example(y1="1/6", y2="1/3", g1=5, g2=2, t1=1, t2=4, q=1, zeta=1, eps=1),
                        example(y1="1/3", y2="1/6", g1=2, g2=5, t1=5, t2=1, q=1, zeta=1, eps=1),
                        instances(made_by={y1: 1/(g1 + q), y2: 1/(g2 + q), t1: t2*apart(g1 + q, g2 + q)**4})]),
      note="For d = 1, where the distance of two numbers is the logarithm of Max(a/b, b/a); y_i is the image of T_i under the action of M and g_i that "
           "under the first maps of the chain, so that the inequality before is about g_i + q. (16) says nothing of the y_i: it is about shifts of two "
           "numbers, and holds for all of them. In the counterexample T_1 = T_2 and g_1 = g_2.")

# --- constant parameters ---------------------------------------------------------------------------------------------------

M, Pw, Om, Xi, Au, UL, UR, LL = symbols("M Pw Om Xi Au UL UR LL")
claim("B93-S44", "a power of the Hamiltonian matrix is in H0",
      invertible(UL) & pd(T(UL)*LL) & pd(UR*T(UL)), sizes=["d", "p", "q"],
      over={A: nonsingular(d), F: matrix(d, p), C: matrix(q, d)},
      where=[let(M, hamiltonian(A, F*T(F), T(C)*C)), rec(Pw, k, Identity(2*d), M*Pw[k]), rec(Au, k, I, A*Au[k]),
             rec(Om, k, Zd, Om[k] + T(Au[k + 1])*T(C)*C*Au[k + 1]), rec(Xi, k, Zd, A*Xi[k]*T(A) + F*T(F)),
             let(UL, part(Pw[d], 0, 0)), let(UR, part(Pw[d], 0, 1)), let(LL, part(Pw[d], 1, 0))],
      given=[given("observable", invertible(Om[d])), given("controllable", invertible(Xi[d]))],
      by=[example(d=1, p=1, q=1, A=[[1]], F=[[0]], C=[[1]]), example(d=1, p=1, q=1, A=[[1]], F=[[1]], C=[[0]]),
          example(d=2, p=1, q=1, A=[[1, 1], [0, 1]], F=[[0], [1]], C=[[1, 0]]), example(d=2, p=1, q=1, A=[[1, 1], [1, 0]], F=[[1], [0]], C=[[0, 1]]),
          instances(8, d=(1, 2, 3), p=(1, 2), q=(1, 2))],
      note="The power d serves. Observable and controllable are read as the Gramians of d instants being nonsingular.")

not_checked("B93-S45", "solutions of a constant system converge",
            "a limit in a complete metric space, by the fixed point theorem, from B93-S44 and B93-T1.7.3; an instance is no more than what these say")

# --- the sampled system ----------------------------------------------------------------------------------------------------

Cov, Sum, Au_ = symbols("Cov Sum Au_")
claim("B93-E19", "the sampled system",
      always(t, Cov[t] == Au[t]*P0*T(Au[t]) + Sum[t]), sizes=["d", "p"], over={A: matrix(d, d), F: matrix(d, p), P0: positive_semidefinite(d)},
      where=[rec(Au, t, I, A*Au[t]), rec(Sum, t, Zd, Sum[t] + Au[t]*F*T(F)*T(Au[t])), rec(Cov, t, P0, A*Cov[t]*T(A) + F*T(F))],
      by=[induction(also=[A*Au[t] == Au[t]*A, A*Sum[t]*T(A) + F*T(F) == Sum[t] + Au[t]*F*T(F)*T(Au[t])]), instances(6, d=(1, 2), p=(1, 2), horizon=3),
          only("the covariance of the state")],
      note="Over a gap of t instants the covariance of the state of (18) changes as by one step of (19), with A^t and with the sum that F_n^2 is. How F_n "
           "alpha_n is made is B93-S51, the rest B93-S50.")

# --- the stability of the filter -------------------------------------------------------------------------------------------

K, L, W, Dg, Pb, al, tau, si, xp, Bs, x, Pi, Vv, Cov, Ts, la, sg, c = symbols("K L W Dg Pb al tau si xp Bs x Pi VV Cov T lambda sg c")
claim("B93-S69", "two positive matrices in common coordinates",
      invertible(K) & (Pb == T(K)*K) & (P == T(K)*Dg*K) & pd(Dg) & cospectral(P*inv(Pb), Dg), sizes=["d"],
      over={P: positive_definite(d), Pb: positive_definite(d), L: nonsingular(d), W: matrix(d, d), Dg: diagonal(d)}, where=[let(K, T(W)*T(L))],
      given=[given("a square of Pbar", Pb == L*T(L)), given("W is orthogonal", T(W)*W == I), given("its columns are eigenvectors", inv(L)*P*T(inv(L)) == W*Dg*T(W))],
      by=[order([T(W)], [inv(T(L))*W], [], [], [T(W)*inv(L)*P*T(inv(L))*W], [T(K), inv(T(K))], lemmas=[invertible(W)]),
          chosen(square(Pb, L), spectral(inv(L)*P*T(inv(L)), W, Dg)),
          *(instances(6, d=size, using={V: matrix(d, d), U: diagonal(d)},
                      made_by={W: (I - (V - T(V)))*inv(I + (V - T(V))), Dg: U*U + I, Pb: L*T(L), P: L*W*Dg*T(W)*T(L)}) for size in (1, 2, 3))],
      note="There are such L, W and D for all P and Pbar. P inv(Pbar) and D have one characteristic polynomial, so that the eigenvalues, of which the distance is "
           "made, are the entries of D, which are positive.")

ENERGY = function(Vv, [t], T(x[t])*Cov[t]*x[t])
STEP_DOWN = [(1 - la[t]/sg[t])*(Pi[t]*Vv(0) - Vv(t)), T(x[t])*(Ts[t] - la[t]*I)*x[t], la[t]/sg[t]*(T(x[t])*(sg[t]*I - Cov[t])*x[t])]
FROM_START = Cov[n] - 1/al*I
claim("B93-S79", "the norm at the beginning by that at the end",
      forall(t, 0, n, Vv(t) <= Pi[t]*Vv(0)) & (T(x[n])*x[n] <= al*Vv(n)) & (al*Vv(n) <= al*Pi[n]*Vv(0)) & (al*Pi[n]*Vv(0) <= al*Pi[n]*si*(T(xp)*xp)),
      sizes=["d", "n"],
      over={Bs: sequence_of(matrix(d, d), 0, n), Cov: sequence_of(positive_semidefinite(d), 0, n), Ts: sequence_of(positive_semidefinite(d), 0, n),
            la: sequence(0, n), sg: sequence(0, n), xp: vector(d), al: positive(), si: positive()},
      where=[rec(x, t, xp, T(Bs[t])*x[t]), ENERGY, rec(Pi, t, 1, (1 - la[t]/sg[t])*Pi[t])],
      given=[given("Lemma 2.7", forall(k, 0, n - 1, Cov[k] == Bs[k]*Cov[k + 1]*T(Bs[k]) + Ts[k])), standing("P_0 > 0", invertible(Cov[n])),
             given("T >= lambda I, P <= sigma I", forall(k, 0, n - 1, loewner(Ts[k], la[k]*I) & loewner(sg[k]*I, Cov[k]) & (la[k] >= 0) & (sg[k] > 0))),
             standing("lambda <= sigma, as T <= P", forall(k, 0, n - 1, 1 - la[k]/sg[k] >= 0)),
             given("|inv(P_0)| <= alpha", at_most(inv(Cov[n]), al)), given("|P_p| <= sigma", at_most(Cov[0], si))],
      by=[induction(before=[first(forall(t, 0, n, (Vv(t) <= Pi[t]*Vv(0)) & (Pi[t] >= 0)), step=order(STEP_DOWN, [(1 - la[t]/sg[t])*Pi[t]]))],
                    base=[order(), order(root_bound(Cov[n], 1/al, al, K), [al*(T(x[n])*FROM_START*x[n])], roots={K: Cov[n]}, lemmas=[loewner(Cov[n], 1/al*I)]),
                          order([al*(Pi[n]*Vv(0) - Vv(n))]),
                          order(from_squares(Cov[0], si), [al*Pi[n]*(T(xp)*(si*I - Cov[0])*xp)], lemmas=[loewner(si*I, Cov[0])])],
                    step=[order(STEP_DOWN)]),
          example(d=1, n=1, Bs=[[[1]], [[0]]], Cov=[[[1]], [[1]]], T=[[[0]], [[0]]], **{"lambda": [1, 0]}, sg=[1, 1], xp=[1], al=1, si=1),
          example(d=1, n=0, Bs=[[[5]]], Cov=[[[1]]], T=[[[0]]], **{"lambda": [-1]}, sg=[1], xp=[1], al=1, si=1),
          instances(8, d=(1, 2), n=(0, 1, 2), using={c: sequence(0, n), u: nonneg()},
                    made_by={Cov: (k, I), Bs: (k, c[k]/(1 + c[k]**2)*I), Ts: (k, (1 - (c[k]/(1 + c[k]**2))**2)*I), la: (k, 1 - (c[k]/(1 + c[k]**2))**2 - 1/(4 + u)),
                             sg: (k, 1 + u), al: 1 + u, si: 1 + u}),
          instances(8, d=(1, 2), n=(0, 1, 2), using={c: sequence(0, n)}, made_by={
              Cov: (k, I), Bs: (k, c[k]/(1 + c[k]**2)*I), Ts: (k, (1 - (c[k]/(1 + c[k]**2))**2)*I), la: (k, 0), sg: (k, 1), al: 1, si: 1})],
      note=BY_NORMS + "Counted from the end: x_t, P_t, T_t here are x_{p-t}, P_{p-t}, T_{p-t}, B_t is B_{p-t}, n is p, and Pi_t is the product of t factors tau. "
           "That T >= lambda I and P <= sigma I is what the norms in B93-S78 say, and is shown there.")

claim("B93-S80", "the product of the matrices of the filter",
      always(t, (x[t] == T(Pi[t])*xp) & (T(x[t])*x[t] == T(xp)*(Pi[t]*T(Pi[t]))*xp)), sizes=["d"], over={Bs: signal_of(matrix(d, d), 0), xp: vector(d)},
      where=[rec(x, t, xp, T(Bs[t])*x[t]), rec(Pi, t, I, Pi[t]*Bs[t])],
      by=[induction(), instances(6, d=(1, 2), horizon=3),
          restated("S79 for every vector x_p", "the norm of M is the largest of |M*x| for |x| = 1", "the logarithm is increasing")],
      note="Counted from the end: Bs_t is B_{p-t}, so that x_t here is x_{p-t} and Pi_p = B_p ... B_1. With S79, |Pi*x|^2 <= alpha tau_1 ... tau_p sigma_p "
           "|x|^2 for every x, which is the bound of the norm.")

l, larger, total, ends = symbols("l larger total ends")
claim("B93-E21", "the distance of the image of the identity",
      total <= d*larger, sizes=["d"], over={l: sequence(1, d)},
      where=[LARGER, let(total, sum_of(k, 1, d, l[k]**2)), let(larger, Max(l[1]**2, l[d]**2))],
      given=[given("ascending", forall(k, 1, d - 1, l[k] <= l[k + 1]))],
      by=[example(d=3, l=[0, 5, 0]), example(d=3, l=[-1, 0, 1]),
          instances(12, d=(1, 2, 3, 4), using={m: sequence(1, d)}, made_by={l: (k, m[1] + sum_of(t, 2, k, m[t]**2))}),
          instances(8, d=(2, 3))],
      note="The upper bound of Lemma 2.3 for Phi_1(I): l_1, ..., l_d are the logarithms of its eigenvalues in ascending order, so that l_d is that of the "
           "norm and -l_1 that of the norm of the inverse.")
