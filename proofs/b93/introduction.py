# SPDX-License-Identifier: MIT
"""The linear system, its filter and the Riccati map (lines 17 to 46).

The state X_n = A_n X_{n-1} + F_n eps_n is seen through Y_n = C_n X_n + eta_n. The pairs
(eps_n, eta_n) are independent standard Gaussian vectors, X_0 is Gaussian with mean x0
and covariance P_0. Everything is jointly Gaussian, so that conditional means and
covariances are algebra. Centred variables are rows of coefficients times a standard
Gaussian vector: U for a state, V for the observations. The conditional mean has the gain
K = U V* inv(V V*) and the error covariance is U U* - K V U*, whatever was observed.

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
from exactkf.evidence import example, identity, instances, order
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
    positive_semidefinite,
    psd,
    standing,
    sum_of,
    symbols,
    vector,
    vstack,
    when,
)
from proofs.b93.notation import d, i, j, k, n, p, piece, q, r

As, Fs, Cs, L, G, x0, ys, eps = symbols("As Fs Cs L G x0 ys eps")
A, F, C, S, R, P, Phi, X, Psi = symbols("A F C S R P Phi X Psi")
U, V, Vs, E, N, m, y, ms, Xhat, K, K0, w, W, H = symbols("U V Vs E N m y ms Xhat K K0 w W H")

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
NO_COVARIANCE = {G: Zero(d, (p + q) * n)}
INDEPENDENT = given("X_0 is independent of the noises", G == NO_COVARIANCE[G])
UNSAID = "The set-up does not say that X_0 is independent of the noises, and the recursion needs it."
SIZES = ["d", "p", "q", "n"]
SMALL = {"d": (1, 2, 3), "p": (1, 2), "q": (1, 2), "n": (1, 2, 3)}

claim("B93-E1", "the equations determine the state, in closed form",
      X(n) == Psi(0) * x0 + sum_of(k, 1, n, Psi(k) * F(k) * piece(eps, p, 1)), sizes=["d", "p", "n"],
      over={As: matrix(d, d * n), Fs: matrix(d, p * n), x0: vector(d), eps: matrix(p, n)},
      where=[*SYSTEM[:2], function(X, [k], when(k == 0, x0, A(k) * X(k - 1) + F(k) * piece(eps, p, 1))),
             function(Psi, [k], when(k == n, Identity(d), Psi(k + 1) * A(k + 1)))],
      by=[identity(d=(1, 2, 3), p=(1, 2), n=(1, 2, 3)), instances(d=(1, 2, 3, 6), p=(1, 2, 3), n=(1, 2, 3, 4))],
      note="The display is a definition. What is checked is that it determines X_n from X_0 and the noises, "
           "with fitting sizes.")

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

POSTERIOR = inv(Identity(d) + H * R * H)
claim("B93-S1", "the Riccati map is defined on P and keeps P and P0",
      invertible(Identity(d) + R * S + R * A * P * T(A)) & psd(Phi(P)) & (pd(P) >> pd(Phi(P))),
      sizes=["d", "p", "q"],
      over={A: nonsingular(d), F: matrix(d, p), C: matrix(q, d), P: positive_semidefinite(d)},
      where=[*ONE_STEP,
             function(Phi, [X], (A * X * T(A) + S) * inv(Identity(d) + R * S + R * A * X * T(A)))],
      by=[order([Identity(d) - R * H * POSTERIOR * H], [H * POSTERIOR * H], [inv(inv(A * P * T(A) + S) + R)],
                roots={H: A * P * T(A) + S}),
          instances(d=(1, 2, 3, 6), p=(1, 2, 3), q=(1, 2, 3))])

# X_0 = eta_1 = the observation noise: P_0 = 1, U_1 = eps + eta, V_1 = eps + 2 eta, P_1 = 2 - 9/5 = 1/5, not 2/3
DEPENDENT = {"d": 1, "p": 1, "q": 1, "n": 1, "As": [["1"]], "Fs": [["1"]], "Cs": [["1"]], "L": [["0"]],
             "G": [["0", "1"]]}

RECURSION = forall(k, 1, n, P(k) == Phi(k, P(k - 1)))
claim("B93-E5", "the error covariance follows the Riccati map",
      RECURSION, sizes=SIZES, over={**PARAMETERS, **JOINT}, where=[*SYSTEM, *GAUSSIAN, RICCATI], given=[REGULAR],
      by=[example(DEPENDENT), instances(**SMALL)],
      repair=repair(
          "missing hypothesis", UNSAID, RECURSION, sizes=SIZES, over={**PARAMETERS, **JOINT},
          where=[*SYSTEM, *GAUSSIAN, RICCATI], given=[REGULAR, INDEPENDENT],
          by=[identity(given_by=NO_COVARIANCE, d=(1, 2), p=1, q=1, n=1),
              instances(made_by=NO_COVARIANCE, **SMALL)]),
      note="G is the covariance of X_0 with the noises; section 1 speaks of the independence of the pairs "
           "(eps_n, eta_n) from each other only. P_n is the conditional covariance (3) itself.")

FILTER = forall(k, 1, n, Xhat(k) == (A(k) - P(k) * R(k) * A(k)) * Xhat(k - 1) + P(k) * T(C(k)) * y(k))
RECORD = {**PARAMETERS, **JOINT, x0: vector(d), ys: vector(q * n)}
claim("B93-E6", "the recursion of the filter",
      FILTER, sizes=SIZES, over=RECORD, where=[*SYSTEM, *GAUSSIAN, *MEANS], given=[REGULAR],
      by=[example({**DEPENDENT, "x0": ["0"], "ys": ["1"]}), instances(**SMALL)],
      repair=repair(
          "missing hypothesis", UNSAID, FILTER, sizes=SIZES, over=RECORD, where=[*SYSTEM, *GAUSSIAN, *MEANS],
          given=[REGULAR, INDEPENDENT],
          by=[identity(given_by=NO_COVARIANCE, d=(1, 2), p=1, q=1, n=1),
              instances(made_by=NO_COVARIANCE, **SMALL)]),
      note="P_n is the conditional covariance (3) itself, not the value of a recursion; ys is an arbitrary record of "
           "observations.")
