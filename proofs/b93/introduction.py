# SPDX-License-Identifier: MIT
"""The linear system, its filter and the Riccati map (lines 17 to 46).

The state X_n = A_n X_{n-1} + F_n eps_n is seen through Y_n = C_n X_n + eta_n. The pairs
(eps_n, eta_n) are independent standard Gaussian vectors, X_0 is Gaussian with mean x0
and covariance P_0. Everything is jointly Gaussian, so that conditional means and
covariances are algebra. Write the centred initial state as L xi + G w, where w collects
all the noises, xi is standard and independent of w. Then LL* + GG* = P_0, and G is the
covariance of X_0 with the noises. Every centred variable is a row of coefficients times
(xi, w): U_k for X_k, V for the observations up to time k. The conditional mean is
the projection with gain U V*(VV*)^{-1}, and the conditional covariance is
UU* - UV*(VV*)^{-1}VU*, whatever was observed.

The display of the set-up does not say that X_0 is independent of the noises, that is
G = 0. The recursions (5) and (6) need it: with G = 0 the noise at time n is independent
of X_{n-1} and of the past observations, the prediction covariance is
A P_{n-1} A* + S, and one step of conditioning turns it into Phi_n(P_{n-1}).

The Riccati map Phi(P) = W(I + RW)^{-1}, W = APA* + S, needs only that I + RW is
invertible, which Lemma 1.2 gives.
"""

from proofs.b93.notation import d, i, j, k, n, p, piece, q

from exactkf.claims import claim, repair
from exactkf.evidence import example, identity, instances, steps
from exactkf.language import (
    Identity,
    T,
    Zero,
    eq,
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
    positive_semidefinite,
    psd,
    sum_of,
    symbols,
    vector,
    vstack,
    when,
)

As, Fs, Cs, L, G, x0, ys, eps = symbols("As Fs Cs L G x0 ys eps")
A, F, C, S, R, P, Phi, X = symbols("A F C S R P Phi X")
U, V, Vs, E, N, m, y, ms, Xhat, Gain, K, w = symbols("U V Vs E N m y ms Xhat Gain K w")

PARAMETERS = {As: matrix(d, d * n), Fs: matrix(d, p * n), Cs: matrix(q, d * n)}
SYSTEM = (
    function(A, [k], piece(As, d, d)),
    function(F, [k], piece(Fs, d, p)),
    function(C, [k], piece(Cs, q, d)),
    function(S, [k], F(k) * T(F(k))),
    function(R, [k], T(C(k)) * C(k)),
)
REGULAR = given("every A_k is nonsingular", forall(k, 1, n, invertible(A(k))))

# coefficients of X_k and of Y_1 .. Y_k in terms of (xi, eps_1 .. eps_n, eta_1 .. eta_n)
JOINT = {L: matrix(d, d), G: matrix(d, (p + q) * n)}
GAUSSIAN = (
    let(w, d + (p + q) * n),
    function(E, [k], matrix_of(i, j, p, w, when(j == d + (k - 1) * p + i, 1, 0))),
    function(N, [k], matrix_of(i, j, q, w, when(j == d + n * p + (k - 1) * q + i, 1, 0))),
    function(U, [k], when(k == 0, hstack(L, G), A(k) * U(k - 1) + F(k) * E(k))),
    function(V, [k], C(k) * U(k) + N(k)),
    function(Vs, [k], when(k == 1, V(k), vstack(Vs(k - 1), V(k)))),
    function(Gain, [k], U(k) * T(Vs(k)) * inv(Vs(k) * T(Vs(k)))),
    function(P, [k], when(k == 0, U(k) * T(U(k)), U(k) * T(U(k)) - Gain(k) * Vs(k) * T(U(k)))),
)
MEANS = (
    function(m, [k], when(k == 0, x0, A(k) * m(k - 1))),
    function(ms, [k], when(k == 1, C(k) * m(k), vstack(ms(k - 1), C(k) * m(k)))),
    function(y, [k], matrix_of(i, j, q, 1, ys[i + (k - 1) * q, j])),
    function(Xhat, [k], when(k == 0, x0, m(k) + Gain(k) * (matrix_of(i, j, q * k, 1, ys[i, j]) - ms(k)))),
)
RICCATI = function(Phi, [k, X], (A(k) * X * T(A(k)) + S(k)) * inv(Identity(d) + R(k) * S(k) + R(k) * A(k) * X * T(A(k))))
INDEPENDENT = given("X_0 is independent of the noises", G == Zero(d, (p + q) * n))
SIZES = ["d", "p", "q", "n"]
SMALL = {"d": (1, 2, 3), "p": (1, 2), "q": (1, 2), "n": (1, 2, 3)}

Psi = symbols("Psi")[0]
claim("B93-E1", "the equations determine the state, in closed form",
      eq(X(n), Psi(0) * x0 + sum_of(k, 1, n, Psi(k) * F(k) * piece(eps, p, 1))), sizes=["d", "p", "n"],
      over={As: matrix(d, d * n), Fs: matrix(d, p * n), x0: vector(d), eps: matrix(p, n)},
      where=[*SYSTEM[:2], function(X, [k], when(k == 0, x0, A(k) * X(k - 1) + F(k) * piece(eps, p, 1))),
             function(Psi, [k], when(k == n, Identity(d), Psi(k + 1) * A(k + 1)))],
      by=[identity(d=(1, 2, 3), p=(1, 2), n=(1, 2, 3)), instances(d=(1, 2, 3, 6), p=(1, 2, 3), n=(1, 2, 3, 4))],
      note="The display is a definition. What is checked is that it determines X_n from X_0 and the noises, with fitting sizes.")

claim("B93-E2", "the conditional mean is the best estimate",
      loewner((U(n) - K * Vs(n)) * T(U(n) - K * Vs(n)), P(n)), sizes=SIZES,
      over={**PARAMETERS, **JOINT, K: matrix(d, q * n)}, where=[*SYSTEM, *GAUSSIAN],
      by=[instances(**SMALL)],
      note="A definition, with the remark that goes with it: the error covariance of any other linear estimate "
           "K(Y_1, .., Y_n) is at least that of the conditional mean. Stated in the covariance algebra of Gaussian vectors.")

claim("B93-E3", "the conditional covariance is the covariance of the error of the conditional mean",
      P(n) == (U(n) - Gain(n) * Vs(n)) * T(U(n) - Gain(n) * Vs(n)), sizes=SIZES,
      over={**PARAMETERS, **JOINT}, where=[*SYSTEM, *GAUSSIAN],
      by=[identity(d=(1, 2), p=1, q=1, n=1), identity(d=1, p=1, q=1, n=2), instances(**SMALL)],
      note="The conditional covariance of a Gaussian vector does not depend on what was observed; it is stated in covariance algebra.")

A_, F_, C_, S_, R_, P_, W_ = symbols("A F C S R P W")
ONE_STEP = (let(S_, F_ * T(F_)), let(R_, T(C_) * C_))
claim("B93-E4", "R and S are nonnegative, so that the map is defined through Lemma 1.2",
      psd(R_) & psd(S_) & (Identity(d) + R_ * S_ + R_ * A_ * P_ * T(A_) == Identity(d) + R_ * (A_ * P_ * T(A_) + S_)),
      sizes=["d", "p", "q"], over={A_: matrix(d, d), F_: matrix(d, p), C_: matrix(q, d), P_: positive_semidefinite(d)}, where=ONE_STEP,
      by=[instances(d=(1, 2, 3, 6), p=(1, 2, 3), q=(1, 2, 3))],
      note="A definition. What is checked is that R = C*C and S = FF* are members of P, and that the matrix to be inverted is I + R(APA* + S).")

claim("B93-S1", "the Riccati map is defined on P and keeps P and P0",
      invertible(Identity(d) + R_ * S_ + R_ * A_ * P_ * T(A_)) & psd(Phi(P_)) & (pd(P_) >> pd(Phi(P_))),
      sizes=["d", "p", "q"], over={A_: nonsingular(d), F_: matrix(d, p), C_: matrix(q, d), P_: positive_semidefinite(d)},
      where=[*ONE_STEP, function(Phi, [X], (A_ * X * T(A_) + S_) * inv(Identity(d) + R_ * S_ + R_ * A_ * X * T(A_)))],
      by=[steps("B93-S28", "B93-S33", "B93-P1.5.1", "B93-L1.2",
                prose="By S28 the map is the one of the Hamiltonian matrix (7), and Proposition 1.5 (i) says the rest."),
          instances(d=(1, 2, 3, 6), p=(1, 2, 3), q=(1, 2, 3))])

# X_0 = eta_1 = the observation noise: P_0 = 1, U_1 = eps + eta, V_1 = eps + 2 eta, P_1 = 2 - 9/5 = 1/5, not 2/3
DEPENDENT = {"d": 1, "p": 1, "q": 1, "n": 1, "As": [["1"]], "Fs": [["1"]], "Cs": [["1"]], "L": [["0"]], "G": [["0", "1"]]}

claim("B93-E5", "the error covariance follows the Riccati map",
      forall(k, 1, n, P(k) == Phi(k, P(k - 1))), sizes=SIZES, over={**PARAMETERS, **JOINT},
      where=[*SYSTEM, *GAUSSIAN, RICCATI], given=[REGULAR],
      by=[example(DEPENDENT), instances(**SMALL)],
      repair=repair(
          "missing hypothesis", "The set-up does not say that X_0 is independent of the noises, and the recursion needs it.",
          forall(k, 1, n, P(k) == Phi(k, P(k - 1))), sizes=SIZES, over={**PARAMETERS, **JOINT},
          where=[*SYSTEM, *GAUSSIAN, RICCATI], given=[INDEPENDENT],
          by=[identity(given_by={G: Zero(d, (p + q) * n)}, d=(1, 2), p=1, q=1, n=1), identity(given_by={G: Zero(d, (p + q) * n)}, d=1, p=1, q=1, n=(2, 3)),
              instances(made_by={G: Zero(d, (p + q) * n)}, **SMALL)]),
      note="G is the covariance of X_0 with the noises. The section speaks of independence of the pairs (eps_n, eta_n) from each other only.")

claim("B93-E6", "the recursion of the filter",
      forall(k, 1, n, Xhat(k) == (A(k) - P(k) * R(k) * A(k)) * Xhat(k - 1) + P(k) * T(C(k)) * y(k)), sizes=SIZES,
      over={**PARAMETERS, **JOINT, x0: vector(d), ys: vector(q * n)}, where=[*SYSTEM, *GAUSSIAN, *MEANS], given=[REGULAR],
      by=[example({**DEPENDENT, "x0": ["0"], "ys": ["1"]}), instances(**SMALL)],
      repair=repair(
          "missing hypothesis", "The set-up does not say that X_0 is independent of the noises, and the recursion needs it.",
          forall(k, 1, n, Xhat(k) == (A(k) - P(k) * R(k) * A(k)) * Xhat(k - 1) + P(k) * T(C(k)) * y(k)), sizes=SIZES,
          over={**PARAMETERS, **JOINT, x0: vector(d), ys: vector(q * n)}, where=[*SYSTEM, *GAUSSIAN, *MEANS], given=[INDEPENDENT],
          by=[identity(given_by={G: Zero(d, (p + q) * n)}, d=(1, 2), p=1, q=1, n=1), identity(given_by={G: Zero(d, (p + q) * n)}, d=1, p=1, q=1, n=(2, 3)),
              instances(made_by={G: Zero(d, (p + q) * n)}, **SMALL)]),
      note="P_n is the covariance (3) itself, not the value of a recursion; ys is an arbitrary record of observations.")
