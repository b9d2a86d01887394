# SPDX-License-Identifier: MIT
"""The linear system, its filter and the Riccati map (lines 17 to 46).

The state X_n = A_n X_{n-1} + F_n eps_n is seen through Y_n = C_n X_n + eta_n. The pairs
(eps_n, eta_n) are independent standard Gaussian vectors, X_0 is Gaussian with mean x0
and covariance P_0. Everything is jointly Gaussian, so that conditional means and
covariances are algebra. Centred variables are rows of coefficients times a standard
Gaussian vector: U for a state, V for the observations. The conditional mean has the gain
K = U V* inv(V V*) and the error covariance is U U* - K V U*, whatever was observed.

One step: if the noises of time n are independent of X_{n-1} and of the past, the error
of the prediction has covariance W = A P_{n-1} A* + S. With the conditional mean
K1 V + K2 Y and its error e, P_n C* = -e N* = K2, and P_n = W - K2 C W, so that
P_n (I + RW) = W, which is (5); the mean is K1 V + K2 Y = (I - K2 C) A K0 V + K2 Y, which
is (6).

For the system write the centred initial state as L xi + G w, where w collects all the
noises, xi is standard and independent of w. Then LL* + GG* = P_0, and G is the
covariance of X_0 with the noises: every joint law that the set-up allows has this form.
The display of the set-up does not say that X_0 is independent of the noises, that is
G = 0. The recursions (5) and (6) need it: with G = 0 the noise at time n is independent
of X_{n-1} and of the past observations, the prediction covariance is
A P_{n-1} A* + S, and one step of conditioning turns it into Phi_n(P_{n-1}). With
X_0 = eta_1 in one dimension, all coefficients one, P_1 is 1/5 and Phi(P_0) is 2/3.

The Riccati map Phi(P) = W inv(I + RW), W = APA* + S, needs only that I + RW is
invertible. With H a symmetric root of W, its inverse is I - RH inv(I + HRH) H, and
Phi(P) = H inv(I + HRH) H is nonnegative; for positive W it is inv(inv(W) + R).
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, identity, induction, instances, order
from exactkf.language import (
    Identity,
    T,
    Zero,
    forall,
    function,
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
    rec,
    sequence_of,
    standing,
    symbols,
    vector,
    vstack,
    when,
)
from proofs.b93.notation import d, i, j, k, n, p, piece, q, r

As, Fs, Cs, L, G, x0, ys = symbols("As Fs Cs L G x0 ys")
A, F, C, S, R, P, Phi, X, Psi = symbols("A F C S R P Phi X Psi")
U, V, Vs, E, N, m, y, ms, Xhat, K, K0, w, W, H, t = symbols("U V Vs E N m y ms Xhat K K0 w W H t")

# ---------------------------------------------------------------- the system, time by time
PARAMETERS = {As: matrix(d, d * n), Fs: matrix(d, p * n), Cs: matrix(q, d * n)}
SYSTEM = (
    function(A, [k], piece(As, d, d)),
    function(F, [k], piece(Fs, d, p)),
    function(C, [k], piece(Cs, q, d)),
    function(S, [k], F(k) * T(F(k))),
    function(R, [k], T(C(k)) * C(k)),
)
REGULAR = standing("every A_k is nonsingular", forall(k, 1, n, invertible(A(k))))

# coefficients of X_k and of Y_1 .. Y_k in terms of (xi, eps_1 .. eps_n, eta_1 .. eta_n)
JOINT = {L: matrix(d, d), G: matrix(d, (p + q) * n)}
GAUSSIAN = (
    let(w, d + (p + q) * n),
    function(E, [k], matrix_of(i, j, p, w, when(j == d + (k - 1) * p + i, 1, 0))),
    function(N, [k], matrix_of(i, j, q, w, when(j == d + n * p + (k - 1) * q + i, 1, 0))),
    function(U, [k], when(k == 0, hstack(L, G), A(k) * U(k - 1) + F(k) * E(k))),
    function(V, [k], C(k) * U(k) + N(k)),
    function(Vs, [k], when(k == 1, V(k), vstack(Vs(k - 1), V(k)))),
    function(K, [k], U(k) * T(Vs(k)) * inv(Vs(k) * T(Vs(k)))),
    function(P, [k], when(k == 0, U(k) * T(U(k)), U(k) * T(U(k)) - K(k) * Vs(k) * T(U(k)))),
)
MEANS = (
    function(m, [k], when(k == 0, x0, A(k) * m(k - 1))),
    function(ms, [k], when(k == 1, C(k) * m(k), vstack(ms(k - 1), C(k) * m(k)))),
    function(y, [k], matrix_of(i, j, q, 1, ys[i + (k - 1) * q, j])),
    function(Xhat, [k], when(k == 0, x0, m(k) + K(k) * (matrix_of(i, j, q * k, 1, ys[i, j]) - ms(k)))),
)
RICCATI = function(
    Phi, [k, X], (A(k) * X * T(A(k)) + S(k)) * inv(Identity(d) + R(k) * S(k) + R(k) * A(k) * X * T(A(k))))
UNSAID = ("The set-up does not say that X_0 is independent of the noises, as Hypothesis H (ii) of section 2 does, and the "
          "recursion needs it.")
SIZES = ["d", "p", "q", "n"]
SMALL = {"d": (1, 2, 3), "p": (1, 2), "q": (1, 2), "n": (1, 2, 3)}

A_, F_, eps_, X0, Done = symbols("A F eps X0 sum")
claim("B93-E1", "the equations determine the state, in closed form",
      forall(t, 0, n, X[n] == Psi[t] * X[n - t] + Done[t]), sizes=["d", "p", "n"],
      over={A_: sequence_of(matrix(d, d), 1, n), F_: sequence_of(matrix(d, p), 1, n), X0: matrix(d, 1), eps_: sequence_of(matrix(p, 1), 1, n)},
      where=[rec(X, t, X0, A_[t + 1] * X[t] + F_[t + 1] * eps_[t + 1]),
             rec(Psi, t, Identity(d), Psi[t] * A_[n - t]), rec(Done, t, Zero(d, 1), Done[t] + Psi[t] * F_[n - t] * eps_[n - t])],
      given=[standing("the recursion, counted from the end", forall(k, 0, n - 1, X[k + 1] == A_[k + 1] * X[k] + F_[k + 1] * eps_[k + 1]))],
      by=[induction(), instances(d=(1, 2, 3), p=(1, 2), n=(1, 2, 3))],
      note="The display is a definition. What is checked is that it determines X_n from X_0 and the noises, with fitting sizes: at t = n the first term is "
           "A_n ... A_1 X_0 and the second the sum of A_n ... A_(k+1) F_k eps_k. Psi_t is A_n ... A_(n-t+1).")

GAIN = (let(K, U * T(V) * inv(V * T(V))), let(P, U * T(U) - K * V * T(U)))
claim("B93-E2", "the conditional mean is the best estimate",
      loewner((U - K0 * V) * T(U - K0 * V), P), sizes=["d", "r", "w"],
      over={U: matrix(d, w), V: matrix(r, w), K0: matrix(d, r)}, where=GAIN,
      by=[order([(K0 - K) * (V * T(V)) * T(K0 - K)]), instances(d=(1, 2, 3), r=(1, 2, 3), w=(2, 3, 5))],
      note="A definition, with the remark that goes with it. For jointly Gaussian centred vectors U e of the state and "
           "V e of the observations, e standard, the error covariance of any linear estimate K0 V e is at least that of "
           "the conditional mean K V e.")

claim("B93-E3", "the conditional covariance is the covariance of the error of the conditional mean",
      (U - K * V) * T(U - K * V) == P, sizes=["d", "r", "w"], over={U: matrix(d, w), V: matrix(r, w)}, where=GAIN,
      by=[identity(d=(1, 2), r=1, w=2), instances(d=(1, 2, 3), r=(1, 2, 3), w=(2, 3, 5))],
      note="Stated in the covariance algebra of Gaussian vectors, whose conditional covariance "
           "does not depend on what was observed.")

ONE_STEP = (let(S, F * T(F)), let(R, T(C) * C))
claim("B93-E4", "R and S are nonnegative, and the matrix to be inverted is I + R(APA* + S)",
      psd(R) & psd(S)
      & (Identity(d) + R * S + R * A * P * T(A) == Identity(d) + R * (A * P * T(A) + S)),
      sizes=["d", "p", "q"],
      over={A: matrix(d, d), F: matrix(d, p), C: matrix(q, d), P: positive_semidefinite(d)}, where=ONE_STEP,
      by=[order(), instances(d=(1, 2, 3, 6), p=(1, 2, 3), q=(1, 2, 3))],
      note="A definition; these are the two facts that it takes for granted.")

P0, Den = symbols("P0 Den")
POSTERIOR = inv(Identity(d) + H * R * H)
claim("B93-S1", "the Riccati map is defined on P and keeps P and P0",
      invertible(Den(P)) & psd(Phi(P)) & pd(Phi(P0)), sizes=["d", "p", "q"],
      over={A: nonsingular(d), F: matrix(d, p), C: matrix(q, d), P: positive_semidefinite(d), P0: positive_definite(d)},
      where=[*ONE_STEP, function(Den, [X], Identity(d) + R * S + R * A * X * T(A)),
             function(Phi, [X], (A * X * T(A) + S) * inv(Den(X)))],
      by=[order([Identity(d) - R * H * POSTERIOR * H], [H * POSTERIOR * H], [inv(inv(A * P0 * T(A) + S) + R)],
                roots={H: A * P * T(A) + S}),
          instances(d=(1, 2, 3, 6), p=(1, 2, 3), q=(1, 2, 3))])

# X_0 = eta_1 = the observation noise: P_0 = 1, U_1 = eps + eta, V_1 = eps + 2 eta, P_1 = 2 - 9/5 = 1/5, not 2/3
DEPENDENT = {"d": 1, "p": 1, "q": 1, "n": 1, "As": [["1"]], "Fs": [["1"]], "Cs": [["1"]], "L": [["0"]],
             "G": [["0", "1"]]}

# ---------------------------------------------------------------- one step, for every size
# coefficients in a standard Gaussian vector of length w: U of X_{n-1}, V of the past observations, E and N of the noises
K1, K2, X1, Y1, P1 = symbols("K1 K2 X1 Y1 P1")
BEFORE, AFTER = symbols("e0 e1")
STEP_SIZES = ["d", "p", "q", "r", "w"]
STEP_OVER = {A: matrix(d, d), F: matrix(d, p), C: matrix(q, d), U: matrix(d, w), V: matrix(r, w), E: matrix(p, w),
             N: matrix(q, w), K1: matrix(d, r), K2: matrix(d, q), P0: positive_semidefinite(d), P1: positive_semidefinite(d)}
STEP = (
    *ONE_STEP, let(X1, A * U + F * E), let(Y1, C * X1 + N), let(K0, U * T(V) * inv(V * T(V))),
    let(BEFORE, U - K0 * V), let(AFTER, X1 - K1 * V - K2 * Y1),
)
STEP_GIVEN = [
    given("the noises are standard and independent of each other",
          (E * T(E) == Identity(p)) & (N * T(N) == Identity(q)) & (E * T(N) == Zero(p, q))),
    given("the noises are independent of X_{n-1} and the past observations",
          (U * T(E) == Zero(d, p)) & (U * T(N) == Zero(d, q)) & (V * T(E) == Zero(r, p)) & (V * T(N) == Zero(r, q))),
    given("K1 V + K2 Y is the conditional mean",
          (AFTER * T(V) == Zero(d, r)) & (AFTER * T(Y1) == Zero(d, q))),
    given("P0 is the error covariance before", P0 == BEFORE * T(BEFORE)),
    given("P1 is the error covariance after", P1 == AFTER * T(AFTER)),
]
U0, V0 = symbols("U0 V0")
_SEEN = vstack(V, C * (A * U + F * E) + N)
_GAINS = (A * U + F * E) * T(_SEEN) * inv(_SEEN * T(_SEEN))
STEP_MADE = instances(
    d=(1, 2, 3), p=(1, 2), q=(1, 2), r=(1, 2), w=(5, 6), using={U0: matrix(d, w - p - q), V0: matrix(r, w - p - q)},
    made_by={U: hstack(U0, Zero(d, p), Zero(d, q)), V: hstack(V0, Zero(r, p), Zero(r, q)),
             E: hstack(Zero(p, w - p - q), Identity(p), Zero(p, q)), N: hstack(Zero(q, w - p - q), Zero(q, p), Identity(q)),
             K1: matrix_of(i, j, d, r, _GAINS[i, j]), K2: matrix_of(i, j, d, q, _GAINS[i, j + r]),
             P0: BEFORE * T(BEFORE), P1: AFTER * T(AFTER)})
# a noise of variance four
LOUD = example(d=1, p=1, q=1, r=1, w=4, A=[[1]], F=[[1]], C=[[1]], U=[[1, 0, 0, 0]], V=[[1, 1, 0, 0]], E=[[0, 0, 1, 0]],
               N=[[0, 0, 0, 2]], K1=[["4/11"]], K2=[["3/11"]], P0=[["1/2"]], P1=[["12/11"]])
ONE_PHI = function(Phi, [X], (A * X * T(A) + S) * inv(Identity(d) + R * S + R * A * X * T(A)))
AS_ONE_STEP = ("In the correction U, V, E, N are the coefficients of X_{n-1}, of the past observations and of the noises of time n "
               "in a standard Gaussian vector, so that it is the assertion for every n.")

claim("B93-E5", "the error covariance follows the Riccati map",
      forall(k, 1, n, P(k) == Phi(k, P(k - 1))), sizes=SIZES, over={**PARAMETERS, **JOINT},
      where=[*SYSTEM, *GAUSSIAN, RICCATI], given=[REGULAR],
      by=[example(DEPENDENT), instances(**SMALL)],
      repair=repair("missing hypothesis", UNSAID, P1 == Phi(P0), sizes=STEP_SIZES, over=STEP_OVER, where=[*STEP, ONE_PHI],
                    given=STEP_GIVEN, by=[order(), LOUD, STEP_MADE]),
      note="G is the covariance of X_0 with the noises; section 1 speaks of the independence of the pairs "
           f"(eps_n, eta_n) from each other only. P_n is the conditional covariance (3) itself. {AS_ONE_STEP}")

claim("B93-E6", "the recursion of the filter",
      forall(k, 1, n, Xhat(k) == (A(k) - P(k) * R(k) * A(k)) * Xhat(k - 1) + P(k) * T(C(k)) * y(k)), sizes=SIZES,
      over={**PARAMETERS, **JOINT, x0: vector(d), ys: vector(q * n)}, where=[*SYSTEM, *GAUSSIAN, *MEANS], given=[REGULAR],
      by=[example({**DEPENDENT, "x0": ["0"], "ys": ["1"]}), instances(**SMALL)],
      repair=repair("missing hypothesis", UNSAID,
                    K1 * V + K2 * Y1 == (A - P1 * R * A) * (K0 * V) + P1 * T(C) * Y1, sizes=STEP_SIZES,
                    over={name: kind for name, kind in STEP_OVER.items() if name is not P0}, where=STEP,
                    given=[h for h in STEP_GIVEN if h[0] != "P0 is the error covariance before"], by=[order(), LOUD, STEP_MADE]),
      note="P_n is the conditional covariance (3) itself, not the value of a recursion; ys is an arbitrary record of "
           f"observations. {AS_ONE_STEP} The means follow the same recursion, because P C*C A - PRA = 0.")

# ---------------------------------------------------------------- the two steps of the textbook
Pm, xm, x1, y1 = symbols("Pm xm x1 y1")
claim("B93-X0", "prediction and correction give the Riccati map and the recursion of the filter",
      (P1 == Phi(P0)) & (K == P1 * T(C)) & (x1 == (A - P1 * R * A) * x0 + P1 * T(C) * y1), sizes=["d", "p", "q"],
      over={A: matrix(d, d), F: matrix(d, p), C: matrix(q, d), P0: positive_semidefinite(d), x0: vector(d), y1: vector(q)},
      where=[*ONE_STEP, ONE_PHI, let(Pm, A * P0 * T(A) + S), let(xm, A * x0), let(K, Pm * T(C) * inv(C * Pm * T(C) + Identity(q))),
             let(P1, Pm - K * C * Pm), let(x1, xm + K * (y1 - C * xm))],
      by=[order(), instances(d=(1, 2, 3), p=(1, 2), q=(1, 2))],
      note="Not in the paper, which writes (5) and (6) down without the usual form of the filter: prediction xm, Pm, gain K, correction by the innovation.")
