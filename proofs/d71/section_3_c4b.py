# SPDX-License-Identifier: MIT
"""Convergence to the stable equilibrium (Chapter III, section C.4.b).

Write K = B - PD for an equilibrium P with K inside the unit circle, L = DP - C for the
inverse of K*, and W = M'(MPM' + V)^{-1}M, which is K*D.

From above: for P_0 >= P the deviation U_k = P_k - P >= 0 satisfies U_{k+1} =
K U_k(I + W U_k)^{-1}K*, which is at most K U_k K*. So U_k <= W_k with W_{k+1} = K W_k K*, and
W_k tends to zero with the powers of K.

From zero: for P > 0 and P_0 = 0 put P_k = P - U_k. Then U_k = K^k X_k^{-1}(K^k)* with
X_0 = P^{-1} and X_{k+1} = X_k - (K^k)*W K^k. The X_k decrease, but stay above P^{-1} - S
where S - K*SK = W; and P^{-1} - S is positive definite because
L(P^{-1} - S)L* - (P^{-1} - S) = (P - H)^{-1} - P^{-1} >= 0, with a null vector only if some
mode is undriven. So X_k^{-1} stays bounded and U_k tends to zero.

In closed form, for any start: U_k = K^k U_0 [L^k + S_k U_0]^{-1} with S_{k+1} = L S_k + D K^k;
and S_k = L^k E - E K^k for a solution E of LE - EK = D.
"""

from exactkf.claims import claim
from exactkf.evidence import EIGENVALUE, EIGENVECTOR, example, first, induction, instances, order, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    detectable,
    eq,
    given,
    hstack,
    inv,
    invertible,
    kernel_basis,
    let,
    loewner,
    matrix,
    matrix_of,
    nonsingular,
    pd,
    positive,
    positive_definite,
    positive_semidefinite,
    psd,
    rational,
    rec,
    scalar,
    schur,
    standing,
    stein,
    sym,
    symbols,
    symmetric_matrix,
    trace,
    vstack,
    when,
)
from proofs.d71.fading import Fading, N, R, eigenvalues
from proofs.d71.notation import H, M, P, Phi, V, gram, i, j, n, p, step, update

q, S, A, B, C, D, K, L, U, U0, U1, W, X, t = symbols("q S A B C D K L U U0 U1 W X t")
Pi, Lam, Sk, E, v, mu, Q, a = symbols("Pi Lam Sk E v mu Q a")
I, Zn = Identity(n), Zero(n, n)
PhiT = inv(T(Phi))
GRAM = let(S, gram())
COEFFICIENTS = [GRAM, let(A, H*PhiT), let(B, H*PhiT*S + Phi), let(C, -PhiT), let(D, PhiT*S)]
SYSTEM = {Phi: nonsingular(n), H: symmetric_matrix(n), M: matrix(p, n), V: positive_definite(p), P: symmetric_matrix(n)}
MORE = {"n": (1, 2, 3), "p": (1, 2)}
EQUILIBRIUM = given("P is an equilibrium", P == step())
SOLVED = {H: P - Phi*update()*T(Phi)}
IS_K = given("K = B - PD", K == B - P*D)
INNOVATION = T(M)*inv(M*P*T(M) + V)*M
POWERS = rec(Pi, t, I, K*Pi[t])

# --- from above ---------------------------------------------------------------------------------------------------------

INSIDE = given("the eigenvalues of K are inside the unit circle", schur(K))
LINEAR = Fading(K, U0, W)
CONTRACTING = eigenvalues(E, 1/(2 + a[i]**2), K, U0)
#: too large a K
LARGE = {"n": 1, "K": [[2]], "U0": [[1]]}

claim("D71-E3.179", "the linear bound tends to zero",
      always(t, psd(W[t]) & LINEAR.bound),
      sizes=["n"], over={K: matrix(n, n), U0: positive_semidefinite(n)}, where=[rec(W, t, U0, K*W[t]*T(K)), *LINEAR.where],
      given=[INSIDE],
      by=[induction(also=LINEAR.also, base=LINEAR.begins([], LINEAR.first), step=LINEAR.goes_on([], LINEAR.then)),
          example(LARGE),
          instances(8, n=(1, 2), horizon=3, using={E: nonsingular(n), a: matrix(n, 1)}, made_by=CONTRACTING)],
      note="stein(M, N) is the solution of X = MXM' + N, which there is for an M inside the circle, and no other. So 0 <= W_k <= R/(k + 1), with R the same "
           "for all k: W_k tends to zero.")

claim("D71-E3.180", "the difference of the bound and the deviation",
      K*W*T(K) - U1 == K*(X + U - U*inv(I + T(K)*D*U))*T(K),
      sizes=["n", "p"],
      over={**SYSTEM, K: matrix(n, n), U: symmetric_matrix(n), U1: matrix(n, n), W: symmetric_matrix(n), X: matrix(n, n)}, where=COEFFICIENTS,
      given=[EQUILIBRIUM, IS_K, given("the next deviation", U1 == step(P + U) - P), given("X = W - U", X == W - U)],
      by=[order(lemmas=[T(K)*(D*P - C) == I, (D*P - C)*T(K) == I, U1*(D*P - C + D*U) == K*U, U1*(D*P - C)*(I + T(K)*D*U) == K*U,
                        U1*(D*P - C) == K*U*inv(I + T(K)*D*U), U1 == K*U*inv(I + T(K)*D*U)*T(K)]),
          instances(**MORE, made_by={**SOLVED, K: B - P*D, U1: step(P + U) - P, X: W - U})])

P1, LESS = symbols("P1 LESS")
LOSS = U*inv(I + S*P1)*(S + S*P1*S)*inv(I + P1*S)*U

claim("D71-E3.181", "what the deviation loses against the bound",
      (LESS == LOSS) & psd(LESS),
      sizes=["n", "p"], over={**SYSTEM, K: matrix(n, n), U: symmetric_matrix(n), P1: symmetric_matrix(n)},
      where=[*COEFFICIENTS, let(LESS, U - U*inv(I + T(K)*D*U))],
      given=[EQUILIBRIUM, IS_K, given("P_k = P + U_k", P1 == P + U), given("P_k >= 0", psd(P1))],
      by=[order([], [], [], [], [], [], [U*inv(I + S*P1)*S*inv(I + P1*S)*U, U*inv(I + S*P1)*S*P1*S*inv(I + P1*S)*U],
                lemmas=[T(K)*(D*P - C) == I, (D*P - C)*T(K) == I, (D*P - C)*(I + T(K)*D*U) == PhiT*(I + S*P1),
                        T(Phi)*(D*P - C)*(I + T(K)*D*U) == I + S*P1, LESS == LOSS]),
          example(n=1, p=1, Phi=[[1]], H=[["1/2"]], M=[[1]], V=[[1]], P=[[1]], K=[["1/2"]], U=[[-3]], P1=[[-2]]),
          instances(8, n=(1, 2), p=(1,), using={Q: positive_semidefinite(n)}, made_by={P1: Q, U: Q - P, **SOLVED, K: B - P*D})],
      note="The left side is lost in the scan; it is the middle of (3.180).")

SQUEEZE = K*(U[t]*inv(I + W*U[t]))*T(K)
BOUND = sym("BOUND")
EXCEEDED = Fading(K, U0, BOUND)
PUSHED = inv(I + U[t]*W)

claim("D71-E3.182", "the deviation lies between zero and the linear bound",
      always(t, psd(U[t]) & loewner(BOUND[t], U[t]) & EXCEEDED.bound),
      sizes=["n"], over={K: matrix(n, n), U0: positive_semidefinite(n), W: positive_semidefinite(n)},
      where=[rec(U, t, U0, SQUEEZE), rec(BOUND, t, U0, K*BOUND[t]*T(K)), *EXCEEDED.where], given=[INSIDE],
      by=[induction(also=EXCEEDED.also, base=EXCEEDED.begins([U0], [Zn], EXCEEDED.first),
                    step=EXCEEDED.goes_on([K*PUSHED*U[t]*T(PUSHED)*T(K), K*PUSHED*U[t]*W*U[t]*T(PUSHED)*T(K)],
                               [K*(BOUND[t] - U[t])*T(K), K*PUSHED*U[t]*W*U[t]*T(PUSHED)*T(K), K*PUSHED*U[t]*W*U[t]*W*U[t]*T(PUSHED)*T(K)],
                               EXCEEDED.then)),
          example({**LARGE, "W": [[1]]}),
          instances(8, n=(1, 2), horizon=2, using={E: nonsingular(n), a: matrix(n, 1)}, made_by=CONTRACTING)],
      note="W = K*D = M'(MPM' + V)^{-1}M >= 0 by D71-S53, which makes (3.178) the recursion of U. The bound is W_k of (3.179) and its excess is X_k. "
           "By its last part, 0 <= U_k <= R/(k + 1), both tend to zero.")

# --- from zero ----------------------------------------------------------------------------------------------------------

claim("D71-S53", "the weight W is symmetric and nonnegative definite",
      (inv(I + S*P)*S == INNOVATION) & psd(W),
      sizes=["n", "p"], over={P: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}, where=[GRAM, let(W, INNOVATION)],
      by=[order([inv(I + T(M)*inv(V)*M*P)], [INNOVATION]), instances(**MORE)])

claim("D71-E3.183", "the equation of the distance from below",
      U1 == (B - P*D)*U*inv((D*P - C) - D*U),
      sizes=["n", "p"], over={**SYSTEM, U: matrix(n, n)}, where=[*COEFFICIENTS, let(U1, P - step(P - U))],
      given=[EQUILIBRIUM], by=[instances(**MORE, made_by=SOLVED)],
      note="U is U_k and U1 is U_{k+1}; P_k = P - U_k, so that P_0 = 0 says U_0 = P.")

IS_W = given("the footnote's form of W", W == INNOVATION)

claim("D71-E3.184", "the weight and the sequence X_k",
      (W == inv(I + S*P)*S) & always(t, loewner(X[t], X[t + 1])),
      sizes=["n", "p"], over={P: positive_definite(n), M: matrix(p, n), V: positive_definite(p), K: matrix(n, n), W: positive_semidefinite(n)},
      where=[GRAM, POWERS, rec(X, t, inv(P), X[t] - T(Pi[t])*W*Pi[t])], given=[IS_W],
      by=[induction(base=[order(), order([W])], step=[order(), order([T(K*Pi[t])*W*(K*Pi[t])])]),
          instances(8, n=(1, 2), p=(1, 2), horizon=2, made_by={W: INNOVATION})],
      note="A definition; the content checked is that W is the matrix of the footnote and that the X_k decrease. Pi_k = K^k. That W >= 0 is D71-S53.")

# S_k sums the weights; S is the limit
SUMS = [POWERS, rec(X, t, inv(P), X[t] - T(Pi[t])*W*Pi[t]), rec(Sk, t, Zn, Sk[t] + T(Pi[t])*W*Pi[t])]
LIMIT = given("(3.187)", S - T(K)*S*K == W)

claim("D71-E3.185", "the sequence X_k stays above P^{-1} - S",
      always(t, (X[t] == inv(P) - Sk[t]) & (Sk[t] - T(K)*Sk[t]*K == W - T(Pi[t])*W*Pi[t]) & (S - Sk[t] == T(Pi[t])*S*Pi[t]))
      & always(t, loewner(X[t], inv(P) - S)),
      sizes=["n"], over={P: positive_definite(n), K: matrix(n, n), W: positive_semidefinite(n), S: symmetric_matrix(n)}, where=SUMS,
      given=[LIMIT, given("K is inside the circle", schur(K))],
      by=[induction(before=[first(psd(S), base=order([W], inside=[within(0, stein=T(K))]))], also=[X[t] == inv(P) - Sk[t], S - Sk[t] == T(Pi[t])*S*Pi[t], K*Pi[t] == Pi[t]*K], base=[order(), order([], [], [], [S])],
                    step=[order(), order([], [], [], [T(K*Pi[t])*S*(K*Pi[t])])]),
          instances(8, n=(1, 2), horizon=3, using={E: nonsingular(n), Q: matrix(n, n), a: matrix(n, 1)},
                    made_by={K: E*matrix_of(i, j, n, n, when(i == j, 1/(2 + a[i]**2), 0))*inv(E),
                             W: T(inv(E))*(Q*T(Q))*inv(E),
                             S: T(inv(E))*matrix_of(i, j, n, n, (Q*T(Q))[i, j]/(1 - 1/((2 + a[i]**2)*(2 + a[j]**2))))*inv(E)})],
      note="S is the solution of (3.187), which is nonnegative definite as K is inside the unit circle; S_k solves (3.186). The last equation "
           "is the distance of S_k from S. Pi_k = K^k.")

Sum, BELOW, LESS_H = symbols("Sum BELOW LESS_H")
FROM_ZERO = {**SYSTEM, P: positive_definite(n)}
LP = D*P - C
TIGHT = PhiT*(inv(P) + S)*inv(Phi)
REMAINING = inv(P) - Sum
INVERSE_K = [T(K)*LP == I, LP*T(K) == I]

claim("D71-E3.188", "the equation of P^{-1} - S",
      eq(LP*REMAINING*T(LP) - REMAINING, TIGHT - inv(P), inv(P - H) - inv(P)),
      sizes=["n", "p"], over={**FROM_ZERO, K: matrix(n, n), Sum: symmetric_matrix(n)}, where=COEFFICIENTS,
      given=[EQUILIBRIUM, IS_K, given("(3.187)", Sum - T(K)*Sum*K == inv(I + S*P)*S)],
      by=[order(lemmas=[*INVERSE_K, K*T(LP) == I, LP == PhiT*(I + S*P), LP*Sum*T(LP) - Sum == PhiT*S*T(LP),
                        LP*inv(P)*T(LP) == TIGHT + PhiT*S*T(LP), (P - H)*TIGHT == I, TIGHT*(P - H) == I, TIGHT == inv(P - H)]),
          example(n=1, p=1, Phi=[[1]], H=[["1/2"]], M=[[1]], V=[[1]], P=[[1]], K=[[0]], Sum=[["1/2"]]),
          instances(8, n=(1, 2), p=(1, 2), using={E: nonsingular(n), a: matrix(n, 1)},
                    made_by={Phi: E*matrix_of(i, j, n, n, when(i == j, 1 + a[i]**2, 0))*inv(E), P: E*T(E), M: matrix_of(i, j, p, n, when(i == j, 1, 0))*inv(E),
                             V: Identity(p), **SOLVED, K: Phi - (P - H)*PhiT*gram(),
                             Sum: T(inv(E))*matrix_of(i, j, n, n, when((i == j) & (i <= p), rational("1/2")/(1 - (1 + a[i]**2)**2/4), 0))*inv(E)})],
      note="S of (3.187) is called Sum here, beside S = M'V^{-1}M.")

claim("D71-E3.189", "P - H is positive definite and below P",
      (LESS_H == BELOW) & pd(LESS_H) & loewner(P, LESS_H) & loewner(inv(LESS_H), inv(P)),
      sizes=["n", "p"], over={**FROM_ZERO, H: positive_semidefinite(n)},
      where=[GRAM, let(LESS_H, P - H), let(BELOW, Phi*inv(inv(P) + S)*T(Phi))], given=[EQUILIBRIUM],
      by=[order([], [Phi*inv(inv(P) + S)*T(Phi)], [H], [inv(LESS_H)*R*inv(I + R*inv(LESS_H)*R)*R*inv(LESS_H)], roots={R: H}),
          example(n=1, p=1, Phi=[[1]], H=[[1]], M=[[1]], V=[[1]], P=[["1/2"]]), example(n=1, p=1, Phi=[[1]], H=[[2]], M=[[1]], V=[[1]], P=[[1]]),
          instances(8, n=(1, 2), p=(1, 2), using={E: nonsingular(n), a: matrix(n, 1), v: matrix(n, 1)},
                    made_by={Phi: E*matrix_of(i, j, n, n, when(i == j, 1/(1 + a[i]**2), 0))*inv(E),
                             P: E*matrix_of(i, j, n, n, when(i == j, 1 + v[i]**2, 0))*T(E), **SOLVED})])

Seen, Modes, Weight, Rest = symbols("Seen Modes Weight Rest")
DRIVEN = detectable(Seen, Modes)
GAINED = TIGHT - inv(P)
NULL = kernel_basis(Rest)
NULL_GRAM = T(NULL)*NULL
ON_NULL = inv(NULL_GRAM)*T(NULL)*K*NULL
MODES = inv(P)*NULL*ON_NULL
(er, ei), (lr, li) = EIGENVECTOR, EIGENVALUE
NULL_PARTS, BOUNDED = (NULL*er, NULL*ei), sym("Bound")
OUTER = lr*lr + li*li - 1
GONE = 0*NULL
#: K keeps the null space of P^{-1} - S and acts there as ON_NULL; P^{-1} takes it to undriven modes, which are none: lemmas with their terms
VANISHING = [T(NULL)*T(K)*Rest*K*NULL, T(NULL)*T(K)*GAINED*K*NULL]
NO_NULL_VECTOR = [
    (invertible(I + S*P), [I - INNOVATION*P]), *((x, []) for x in (*INVERSE_K, K*T(LP) == I, LP == PhiT*(I + S*P), LP*Sum*T(LP) - Sum == PhiT*S*T(LP), LP*inv(P)*T(LP) == TIGHT + PhiT*S*T(LP))),
    (pd(P - H), [Phi*inv(inv(P) + S)*T(Phi)]), (TIGHT == inv(P - H), []), (psd(GAINED), [inv(P - H)*R*inv(I + R*inv(P - H)*R)*R*inv(P - H)]),
    (LP*Rest*T(LP) - Rest == GAINED, []), (Rest - T(K)*Rest*K == T(K)*GAINED*K, []), (psd(Rest), [T(K)*GAINED*K]),
    (Rest*K*NULL == GONE, VANISHING), (GAINED*K*NULL == GONE, VANISHING), (invertible(NULL_GRAM), [NULL_GRAM]), (K*NULL == NULL*ON_NULL, []),
    (K*NULL_PARTS[0] == lr*NULL_PARTS[0] - li*NULL_PARTS[1], []), (K*NULL_PARTS[1] == li*NULL_PARTS[0] + lr*NULL_PARTS[1], []),
    (hstack(*NULL_PARTS) == Zero(n, 2), [T(x)*x for x in NULL_PARTS] + [OUTER*T(x)*BOUNDED*x for x in NULL_PARTS]), (schur(ON_NULL), []),
    (NULL == T(LP)*NULL*ON_NULL, []), (GAINED*NULL*ON_NULL == GONE, []), (inv(P)*NULL == T(Phi)*inv(P)*NULL*ON_NULL, []), (H*MODES == GONE, []),
    (MODES == GONE, []), (NULL == GONE, []), (invertible(Rest), [])]
OF_EIGENVECTOR = [says for says, _ in NO_NULL_VECTOR[17:20]]
LEMMAS = [says for says, _ in NO_NULL_VECTOR[:17] + NO_NULL_VECTOR[20:]]


def _positive(*more, inside=()):
    """P^{-1} - S is positive definite, and what follows it in the same proof."""
    return order(*(terms for _, terms in NO_NULL_VECTOR), [Rest], *more, roots={R: H}, lemmas=LEMMAS, inside=[
        within(12, stein=T(K)), within(17, *OF_EIGENVECTOR, vector="right", solutions={BOUNDED: (T(K), I)}, on=2),
        within(22, pencil=(Seen, Modes, ON_NULL)), *inside])


UNDRIVEN_MODE = order(lemmas=[LP == PhiT*(I + S*P), (P - H)*TIGHT == I, TIGHT*(P - H) == I, TIGHT == inv(P - H), TIGHT*v == inv(P)*v,
                              P*T(Phi)*inv(P)*v == P*inv(P)*v*mu])
#: with a weight that is nonnegative definite, X_k is P^{-1} - S and a congruence of S
STAYS = [pd(Rest), Weight == INNOVATION, psd(Sum), X[t] - Rest == T(Pi[t])*Sum*Pi[t], K*Pi[t] == Pi[t]*K, pd(X[t])]


claim("D71-S54", "a null vector of (P - H)^{-1} - P^{-1}",
      (T(Phi)*inv(P)*v == inv(P)*v*mu) & (H*inv(P)*v == Zero(n, q)) & ((DRIVEN & schur(K)) >> (pd(Rest) & always(t, invertible(X[t])))),
      sizes=["n", "p", "q"], over={**FROM_ZERO, H: positive_semidefinite(n), v: matrix(n, q), mu: matrix(q, q), K: matrix(n, n)},
      where=[*COEFFICIENTS, let(Seen, vstack(I, H)), let(Modes, vstack(T(Phi), 0*H)), let(Weight, inv(I + S*P)*S),
             let(Sum, stein(T(K), Weight)), let(Rest, inv(P) - Sum), POWERS, rec(X, t, inv(P), X[t] - T(Pi[t])*Weight*Pi[t])],
      given=[EQUILIBRIUM, standing("K = B - PD", K == B - P*D), given("eigenvector of (DP - C)*", T(LP)*v == v*mu), given("null vector", (inv(P - H) - inv(P))*v == Zero(n, q))],
      by=[induction(also=[[], [], [], STAYS],
                    base=[UNDRIVEN_MODE, UNDRIVEN_MODE, _positive(),
                          _positive([inv(I + S*P)], [INNOVATION], [], [], [inv(P)], [], inside=[within(len(LEMMAS) + 2, stein=T(K))])],
                    step=[order([], [], [], [], [], [T(K*Pi[t])*Sum*(K*Pi[t]), Rest], [])]),
          example(n=1, p=1, q=1, Phi=[[1]], H=[["1/2"]], M=[[1]], V=[[1]], P=[[1]], v=[1], mu=[[2]], K=[["1/2"]]),
          example(n=1, p=1, q=1, Phi=[["5/3"]], H=[[0]], M=[[1]], V=[[1]], P=[["16/9"]], v=[1], mu=[[1]], K=[["3/5"]]),
          example(n=1, p=1, q=1, Phi=[["5/3"]], H=[[0]], M=[[1]], V=[[1]], P=[["16/9"]], v=[1], mu=[["5/3"]], K=[["3/5"]]),
          example(n=1, p=1, q=1, Phi=[["5/3"]], H=[[0]], M=[[1]], V=[[1]], P=[[1]], v=[1], mu=[["6/5"]], K=[["5/6"]]),
          instances(8, n=(1, 2), p=(1, 2), q=(1,), using={E: nonsingular(n), a: scalar(), R: matrix(n, 1)},
                    made_by={mu: Identity(q)*(1 + a**2), Phi: E*matrix_of(i, j, n, n, when(i == j, when(i <= q, 1 + a**2, R[i]), 0))*inv(E),
                             M: matrix_of(i, j, p, n, when(i == j, 1, 0))*inv(E), V: Identity(p),
                             P: E*matrix_of(i, j, n, n, when(i == j, when(i <= q, (1 + a**2)**2 - 1, R[i]**2 + 1), 0))*T(E), **SOLVED, K: B - P*D, v: E*matrix_of(i, j, n, q, when(i == j, 1, 0))}),
          *(instances(8, n=size, p=size, q=(1,), horizon=3, using={E: nonsingular(n), U: matrix(n, 1), R: matrix(n, 1)},
                      made_by={Phi: E*matrix_of(i, j, n, n, when(i == j, 1 + U[i]**2, 0))*inv(E), M: inv(E), V: Identity(p), v: Zero(n, q),
                               P: E*matrix_of(i, j, n, n, when(i == j, (1 + U[i]**2)**2 + R[i]**2, 0))*T(E), **SOLVED, K: B - P*D}) for size in (1, 2))],
      note="mu stands on the right as a matrix. So P^{-1}v is an eigenvector of Phi' and a null vector of H: an undriven mode. S of (3.187) is called Sum: stein(M, N) is the solution of X = MXM' + N. That "
           "all unstable and random walk modes are driven is said by the pencil: (Phi' - w)x = 0 and Hx = 0 with |w| >= 1 give x = 0.")

# --- the solution -------------------------------------------------------------------------------------------------------

START = {P: positive_definite(n), K: nonsingular(n), D: matrix(n, n)}
W_IS = let(W, T(K)*D)
SHRINK = rec(X, t, inv(P), X[t] - T(Pi[t])*W*Pi[t])
LD = inv(T(K))

claim("D71-E3.190", "the solution from zero",
      always(t, U[t] == Pi[t]*inv(X[t])*T(Pi[t])),
      sizes=["n"], over=START, where=[W_IS, POWERS, SHRINK, rec(U, t, P, K*U[t]*inv(LD - D*U[t]))],
      by=[instances(8, n=(1, 2), horizon=3)],
      note="K = B - PD, L = (K*)^{-1} = DP - C by (3.165) and W = K*D by D71-S53. The inverses exist as the X_k are positive definite.")

Zk = sym("Zk")
XI = inv(X)
NEXT_U = K*Zk*inv(X - T(Zk)*W*Zk)*T(K*Zk)

claim("D71-E3.191", "it satisfies the recursion",
      eq(NEXT_U,
         K*Zk*XI*inv(LD - T(Zk)*D*Zk*XI)*T(Zk),
         K*Zk*XI*T(Zk)*inv(LD - D*Zk*XI*T(Zk)),
         K*U*inv(LD - D*U)),
      sizes=["n"], over={K: nonsingular(n), Zk: nonsingular(n), X: symmetric_matrix(n), D: matrix(n, n)}, where=[W_IS, let(U, Zk*XI*T(Zk))],
      given=[given("K^k and K commute", K*Zk == Zk*K)],
      by=[instances(8, n=(1, 2), made_by={Zk: K*K}), instances(4, n=(2,), made_by={Zk: K + I})],
      note="One step at any k: Zk stands for K^k, X for X_k and U for (3.190). L = (K*)^{-1} is DP - C, and W = K*D.")

# --- the solution in closed form ----------------------------------------------------------------------------------------

ANY_KL = {K: matrix(n, n), L: nonsingular(n), D: matrix(n, n)}
POWERS_L = [POWERS, rec(Lam, t, I, L*Lam[t]), rec(Sk, t, Zn, L*Sk[t] + D*Pi[t])]
SYLVESTER = given("(3.210)", L*E - E*K == D)

claim("D71-E3.208", "the deviation after k steps",
      always(t, U[t] == Pi[t]*U0*inv(Lam[t] + Sk[t]*U0)),
      sizes=["n"], over={**ANY_KL, U0: matrix(n, n)}, where=[*POWERS_L, rec(U, t, U0, K*U[t]*inv(L + D*U[t]))],
      by=[instances(8, n=(1, 2), horizon=3)],
      note="K = B - PD, L = DP - C, Pi_k = K^k, Lambda_k = L^k; S_{k+1} = L S_k + D K^k, S_0 = 0 is the sum of L^{k-1-i}D K^i for i < k.")

claim("D71-E3.209", "the sum S_k",
      always(t, Sk[t] == Lam[t]*E - E*Pi[t]),
      sizes=["n"], over={**ANY_KL, E: matrix(n, n)}, where=POWERS_L, given=[SYLVESTER],
      by=[instances(8, n=(1, 2), made_by={D: L*E - E*K})],
      note="Notation as in D71-E3.208.")

claim("D71-E3.210", "the first equation for E gives the second",
      L*E*T(L) - E == D*T(L),
      sizes=["n"], over={K: matrix(n, n), L: nonsingular(n), D: matrix(n, n), E: matrix(n, n)},
      given=[SYLVESTER, given("(3.165)", K*T(L) == I)],
      by=[instances(8, n=(1, 2, 3), made_by={K: inv(T(L)), D: L*E - E*K})],
      note="A definition of E; the content checked is that, multiplied by L* = K^{-1}, it has the form of (3.211), whose right side is D71-E3.211.")

claim("D71-E3.211", "the second equation for E",
      LP*E*T(LP) - E == PhiT*(S + S*P*S)*inv(Phi),
      sizes=["n", "p"], over={**SYSTEM, K: matrix(n, n), E: matrix(n, n)}, where=COEFFICIENTS,
      given=[EQUILIBRIUM, IS_K, given("(3.210)", LP*E - E*K == D)],
      by=[order(lemmas=[*INVERSE_K, K*T(LP) == I, LP == PhiT*(I + S*P), (LP*E - E*K)*T(LP) == D*T(LP)]),
          example(n=1, p=1, Phi=[[1]], H=[["1/2"]], M=[[1]], V=[[1]], P=[[1]], K=[["1/2"]], E=[["2/3"]]),
          example(n=1, p=1, Phi=[[1]], H=[["1/2"]], M=[[1]], V=[[1]], P=[[1]], K=[[0]], E=[["1/2"]]),
          example(n=1, p=1, Phi=[[1]], H=[["1/2"]], M=[[1]], V=[[1]], P=[[1]], K=[["1/2"]], E=[[1]]),
          example(n=1, p=1, Phi=[[1]], H=[[0]], M=[[1]], V=[[1]], P=[[1]], K=[[0]], E=[["1/2"]]),
          instances(8, n=(1, 2), p=(1, 2), using={Q: nonsingular(n), a: matrix(n, 1)},
                    made_by={Phi: Q*matrix_of(i, j, n, n, when(i == j, 1 + a[i]**2, 0))*inv(Q), P: Q*T(Q), M: matrix_of(i, j, p, n, when(i == j, 1, 0))*inv(Q),
                             V: Identity(p), **SOLVED, K: Phi - (P - H)*PhiT*gram(),
                             E: T(inv(Q))*matrix_of(i, j, n, n, when((i == j) & (i <= p), 2/(4 - (1 + a[i]**2)**2), 0))*inv(Q)})])

Y, Y0, V0, c, e = symbols("Y Y0 V0 c e")
#: a K inside the circle with its L and D; K^k V_0 (K^k)* is within K^k Q (K^k)*, and with that all else tends to zero
Ks, Es, Ls, Ds = symbols("K_s E_s L_s D_s")
WITHIN = I + V0*T(V0) + T(V0)*V0
AWAY = Fading(Ks, Q)


def _still(s):
    """K^k V_0 (K^k)*."""
    return Pi[s]*V0*T(Pi[s])


def _square(s):
    """Terms for (k + 1)^2 (W_k)*W_k <= c^2, with W_k as above, from R >= (k + 1) K^k Q (K^k)* and c >= R."""
    less, upper, lower = R - N[s]*(Pi[s]*Q*T(Pi[s])), -(N[s]*(T(Pi[s])*_still(s))), c*T(Pi[s])
    one = T(V0)*upper + lower
    spare = [N[s]*(T(upper)*x*upper)/c for x in (I, T(V0)*V0)] + [N[s]*(T(lower)*x*lower)/c for x in (V0*T(V0), T(V0)*V0)]
    return [N[s]*N[s]*(T(_still(s))*less*_still(s))/c, c*less, N[s]*(T(one)*one)/c, *spare, N[s]*N[s]*(T(_still(s))*(c*I - R)*_still(s))/c, c*(c*I - R)]


def _limit(s):
    """Terms for the bound of the deviation, from U_k = W_k(I + EU_k)."""
    plus, minus = I + Es*Y[s], I - Es*Y[s]
    return [T(plus)*(c**2*I - N[s]**2*(T(_still(s))*_still(s)))*plus, c**2*(T(minus)*minus), 2*c**2*(T(Y[s])*(e*I - T(Es)*Es)*Y[s])]


#: n = 1: a start in the closed form, and one Y_0
ONE = {"n": 1, "K": [["1/2"]], "L": [[2]], "D": [[0]], "E": [[0]], "U0": [[1]], "K_s": [["1/2"]], "E_s": [[0]], "Y0": [[1]], "c": 6, "e": 1}
claim("D71-E3.212", "the deviation after k steps from a Hermitian equilibrium, and its limit",
      always(t, U[t] == X[t]*U0*inv(I + E*U0 - T(X[t])*E*X[t]*U0)*T(X[t]))
      & always(t, loewner(2*c**2*(I + e*(T(Y[t])*Y[t])), N[t]**2*(T(Y[t])*Y[t]))),
      sizes=["n"],
      over={**ANY_KL, U0: matrix(n, n), E: matrix(n, n), Ks: nonsingular(n), Es: matrix(n, n), Y0: matrix(n, n), c: positive(), e: positive()},
      where=[let(V0, Y0*inv(I + Es*Y0)), let(Q, WITHIN), *AWAY.where, let(Ls, inv(T(Ks))), let(Ds, Ls*Es - Es*Ks), rec(X, t, I, K*X[t]),
             rec(U, t, U0, K*U[t]*inv(L + D*U[t])), rec(Y, t, Y0, Ks*Y[t]*inv(Ls + Ds*Y[t]))],
      given=[SYLVESTER, given("(3.165)", (T(K)*L == I) & (L*T(K) == I)), given("the eigenvalues of K_s are inside the unit circle", schur(Ks)),
             given("c is large enough", loewner(c*I, R)), given("e is large enough", loewner(e*I, T(Es)*Es))],
      by=[induction(before=[first(psd(Q), base=order([I, V0*T(V0), T(V0)*V0]))],
                    also=[[], [*AWAY.also, Y[t] == _still(t)*(I + Es*Y[t]), AWAY.bound, loewner(c**2*I, N[t]**2*(T(_still(t))*_still(t)))]],
                    base=[order(), AWAY.begins([], AWAY.first, _square(t), _limit(t))],
                    step=[order(), AWAY.goes_on([], AWAY.then, _square(t + 1), _limit(t + 1))]),
          # without one hypothesis each; a large e
          example({**ONE, "D": [[1]]}), example({**ONE, "L": [[1]]}), example({**ONE, "K_s": [[2]], "c": "1/10"}), example({**ONE, "c": "1/10", "e": "1/10"}),
          example({**ONE, "E_s": [["9/10"]], "Y0": [[10]], "e": "1/1000"}), example({**ONE, "e": 100}), example({**ONE, "Y0": [[-3]], "E_s": [["1/4"]], "c": 500}),
          instances(8, n=(1, 2), horizon=3, using={A: nonsingular(n), a: matrix(n, 1)},
                    made_by={Ks: eigenvalues(A, 1/(2 + a[i]**2), Ks, Q)[Ks], K: inv(T(L)), D: L*E - E*K, Y0: inv(I - A*Es)*A, c: 1 + trace(R), e: 1 + trace(T(Es)*Es)}),
          instances(8, n=(1, 2), horizon=3, made_by={K: inv(T(L)), D: L*E - E*K, Ks: I/2, Es: Zn, Y0: E, c: 1 + trace(R), e: 1})],
      note="K = B - PD with the adjoint B* - D*P, and L = DP - C = (K*)^{-1}; X_k is K^k. The second part is the limit, for K_s = B - PD inside the unit circle and a start "
           "Y_0 with I + E_s Y_0 nonsingular: stein(M, N) is the solution of X = MXM' + N. R is the same for all k, and so are the numbers c and e above the matrices named. "
           "So (k + 1)^2 - 2c^2e times the square of the norm of Y_k is at most 2c^2: the deviation tends to zero.")
