# SPDX-License-Identifier: MIT
"""Filtering with random parameters (section 2): norms, examples and the stability estimate.

Norms are read through the order: ||M|| <= c says M*M <= c^2 I, and for a nonnegative P that
P <= cI. So each estimate of a norm is an inequality between symmetric matrices, shown for all
bounds.

The sampled system of the second example keeps the controllability of the original one, because
the covariances of its noises add the skipped steps. It does not keep observability: for a
rotation by a right angle seen in one coordinate every second time, A^2 = -I, and the other
coordinate is never seen.

Two of the examples need more than they say. A sequence that keeps for ever the value it begins with is stationary, but
not ergodic, as Hypothesis H asks. For Z_n = (a rho_{n-1} + eps_n) Z_{n-1} + eta_n the second moment grows,
E Z_n^2 = E Z_{n-1}^2 + 1 + a^2 E (rho_{n-1} Z_{n-1})^2, so that the parameters (a, 1, Z_{n-1}) are not stationary with finite
variance for any a.

Stability uses x_n = B_{n+1}* x_{n+1} and V_n = x_n* P_n x_n: by Lemma 2.7,
V_{n+1} - V_n = x_{n+1}* T_{n+1} x_{n+1}, at least lambda |x_{n+1}|^2 >= (lambda/sigma) V_{n+1}
where T_{n+1} >= lambda I and P_{n+1} <= sigma I.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import chosen, combination, example, first, identity, induction, instances, order, part, restated, spectral, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    column,
    cospectral,
    diagonal,
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
    nonneg,
    nonsingular,
    nonzero,
    pd,
    positive,
    positive_definite,
    positive_semidefinite,
    rank,
    rational,
    rec,
    scalar,
    sequence,
    sequence_of,
    signal_of,
    standing,
    sum_of,
    symbols,
    symmetric_matrix,
    vector,
    vstack,
    when,
)
from proofs.b93.introduction import K0, K1, K2, LOUD, ONE_PHI, P1, STEP_GIVEN, STEP_MADE, STEP_OVER, STEP_SIZES, Y1, V
from proofs.b93.introduction import STEP as ONE_TIME
from proofs.b93.notation import BY_NORMS, at_most, d, from_squares, i, j, k, n, p, q, r, root_bound, squared_bound

A, B, C, D, F, G, K, L, P, Q, R, S, U, W, X, Y, E = symbols("A B C D F G K L P Q R S U W X Y E")
P0, T0, Phi, Pbar, x, x0, x1, y, m, t = symbols("P0 T0 Phi Pbar x x0 x1 y m t")
al, be, ga, la, si, c, mu = symbols("alpha beta gamma lambda sigma c mu")
I = Identity(d)
SMALL = {"d": (1, 2, 3), "p": (1, 2), "q": (1, 2)}
LIMITS = "an almost sure statement about a stationary ergodic system; it has no exact instances"
MEASURE = "a statement about sigma-algebras and conditional laws; its covariance algebra is (5) and (6)"

not_checked("B93-S46", "the conditionally Gaussian set-up", "a definition: it fixes notation and asserts nothing")
claim("B93-S47", "the recursions under Hypothesis H",
      (P1 == Phi(P0)) & (K1 * V + K2 * Y1 == (A - P1 * R * A) * (K0 * V) + P1 * T(C) * Y1), sizes=STEP_SIZES, over=STEP_OVER, where=[*ONE_TIME, ONE_PHI],
      given=STEP_GIVEN, by=[order(), LOUD, STEP_MADE,
                            restated("Gaussian vectors: given the parameters, the conditional mean is the projection")],
      note="Conditionally on the past the parameters are constants, by H (i), everything is Gaussian, and the noises of time n have the independence that "
           "H (ii) states: U, V, E, N are the coefficients of X_(n-1), of the past observations and of the noises in a standard Gaussian vector, as in (5) "
           "and (6). The section 1 set-up does not state that independence, this one does.")
not_checked("B93-S48", "independent noises and parameters satisfy H", "a statement about sigma-algebras and conditional laws; H (ii) and (iii) are about X_0 "
            "as well, which the example leaves to the reader: it has to be Gaussian and independent of the noises, given the parameters")
not_checked("B93-S49", "the parameters for all times", "the extension theorem for stationary processes; it has no exact instances")
here, shifted, f_, g_ = symbols("here shifted f g")
claim("B93-X2.1.1", "periodic parameters",
      forall(t, 0, p, (shifted[t] == here[t] + f_[t] - f_[0]) & (g_[t] == g_[0])) & (shifted[p] == here[p]), sizes=["p"],
      over={f_: sequence(0, p), g_: sequence(0, p)},
      where=[rec(here, t, 0, here[t] + f_[t]), rec(shifted, t, 0, shifted[t] + f_[t + 1])],
      given=[given("f is a function on the residues", f_[p] == f_[0]), given("g is one, and invariant", forall(k, 0, p - 1, g_[k + 1] == g_[k]))],
      by=[induction(before=[first(forall(t, 0, p, shifted[t] == here[t] + f_[t] - f_[0]))]),
          example(p=1, f=[1, 2], g=[0, 0]), example(p=2, f=[0, 0, 0], g=[0, 1, 0]),
          instances(p=(1, 2, 3, 4), made_by={f_: (k, when(k == p, y[0], y[k])), g_: (k, m)}, using={m: scalar(), y: sequence(0, p)}),
          restated("a law is invariant if the means of all functions are, and ergodic if invariant functions are constant")],
      note="That the parameters are stationary and ergodic: the sum of a function over the residues is that of its shift, so that the uniform law is "
           "invariant, and an invariant function is constant, so that the shift is ergodic. The noises live on the other factor of the product space and "
           "are independent of the parameters. The display writes B_n for the F_n of (1).")
not_checked("B93-X2.1.2", "random sampling", "an announcement: the assertions are the numbered lines that follow")
not_checked("B93-E18", "the time-invariant system and the sampling times", "a definition: it fixes notation and asserts nothing")

# ---------------------------------------------------------------- random sampling
Z_, w, e = symbols("Z w e")
claim("B93-S50", "the state over several steps",
      forall(t, 0, n, (X[n] == U[t] * X[n - t] + Z_[t]) & (Y(n) - e[n] == C * X[n])), sizes=["d", "p", "q", "n"],
      over={A: matrix(d, d), F: matrix(d, p), C: matrix(q, d), x0: matrix(d, 1), w: sequence_of(matrix(p, 1), 1, n), e: sequence_of(matrix(q, 1), 0, n)},
      where=[rec(X, t, x0, A * X[t] + F * w[t + 1]), function(Y, [k], C * X[k] + e[k]),
             rec(U, t, I, U[t] * A), rec(Z_, t, Zero(d, 1), Z_[t] + U[t] * F * w[n - t])],
      given=[standing("the recursion, counted from the end", forall(k, 0, n - 1, X[k + 1] == A * X[k] + F * w[k + 1]))],
      by=[induction(), instances(**SMALL, n=(1, 2, 3))],
      note="Times are counted from T_(n-1), so that n is the gap T_n - T_(n-1); w and e are the two noises. U_t = A^t, and Z_t is the sum of "
           "A^k F w_(n-k) over k < t; the display is t = n.")

claim("B93-S51", "the sampled noise is F_n times a Gaussian vector of the size of eps_n",
      (F * T(F) == K * K) & (p == d), sizes=["d", "p"], over={F: matrix(d, p), K: symmetric_matrix(d)},
      given=[standing("F_n is a symmetric root of the covariance", K * K == F * T(F))],
      by=[example(d=2, p=1, F=[[1], [0]], K=[[1, 0], [0, 0]]), instances(d=(1, 2), p=(1, 2))],
      repair=repair("other", "F_n is d x d, so that alpha_n has d components, not p.",
                    (E * T(E) == I) & (K * E == F * U), sizes=["d", "p", "r"],
                    over={F: matrix(d, p), U: matrix(p, r), K: symmetric_matrix(d), G: matrix(d, d), W: matrix(d, r), E: matrix(d, r)},
                    where=[let(Z_, I - K * G)], given=[given("F_n is a symmetric root", K * K == F * T(F)), given("G is a generalized inverse", K * G * K == K),
                           standing("which commutes with K and is symmetric", (K * G == G * K) & (G == T(G)) & (G * K * G == G)),
                           given("the noise is standard", U * T(U) == Identity(p)),
                           given("an independent standard vector", (W * T(W) == I) & (W * T(U) == Zero(d, p))),
                           given("alpha_n", E == G * F * U + (I - G * K) * W)],
                    by=[order([F * T(F)], lemmas=[T(F) * Z_ == Zero(p, d)]),
                        instances(d=(1, 2), p=(1, 2), r=(4,), made_by={
                            F: hstack(Identity(d), Zero(d, p)) * vstack(Identity(p), Zero(d, p)),
                            K: hstack(Identity(d), Zero(d, p)) * vstack(Identity(p), Zero(d, p)) * T(hstack(Identity(d), Zero(d, p)) * vstack(Identity(p), Zero(d, p))),
                            G: K, U: hstack(Identity(p), Zero(p, 4 - p)), W: hstack(Zero(d, 4 - d), Identity(d)),
                            E: G * F * U + (I - G * K) * W}),
                        restated("a symmetric matrix has a symmetric generalized inverse that commutes with it",
                                 "Gaussian vectors without correlation are independent")]),
      note="F stands for the coefficients of the noise over the gap. In the correction the rows of U, W, E are coefficients of standard Gaussian "
           "vectors: alpha_n = G F u + (I - GK) w with the generalized inverse G of the text and a vector w independent of the noise.")

not_checked("B93-S52", "the sampled system satisfies H", MEASURE)

O = symbols("O")[0]
claim("B93-S53", "controllability and observability of the system suffice for the sampled one",
      pd(T(A**n) * T(C) * C * A**n + T(A**(2 * n)) * T(C) * C * A**(2 * n)), sizes=["n"],
      over={A: nonsingular(2), C: matrix(1, 2)},
      given=[given("(C, A) is observable", rank(vstack(C, C * A)) == 2)],
      by=[example(n=2, A=[[0, -1], [1, 0]], C=[[1, 0]]), instances(n=(1, 2, 3))],
      repair=repair("missing hypothesis", "The powers of A at the gaps may lose observability; it has to be asked of the sampled system.",
                    pd(T(A) * T(C) * C * A + T(A * A) * T(C) * C * (A * A)), sizes=["d", "q"],
                    over={A: nonsingular(d), C: matrix(q, d)}, where=[let(O, vstack(C, C * A))],
                    given=[given("(C, A) is observable in two steps", rank(O) == d)],
                    by=[order([T(A) * T(O) * O * A]), example(d=2, q=1, A=[[-1, 0], [0, -1]], C=[[1, 0]]), instances(d=(1, 2), q=(1, 2)),
                        part("two steps, equal gaps, observability")]),
      note="For d = 2, q = 1 and all gaps equal to n, where weak observability is that of the pair (C, A^n) and two terms of the sum decide. "
           "The matrix A may be a rotation by a right angle and n = 2. In the repair A is the matrix of the sampled system, A^n here; d and q are any.")
not_checked("B93-S54", "no uniform controllability", "what can be expected is not a mathematical assertion")
not_checked("B93-S55", "the error covariance as a Markov chain", "a statement about transition probabilities and irreducibility; it has no exact instances")
q11, q12, q22, g1, g2 = symbols("q11 q12 q22 g1 g2")
FAILING = {q11: nonneg(), q12: nonneg(), q22: nonneg(), g1: scalar(), g2: scalar()}
FAILING_SETTING = [standing("probabilities", q11 + 2 * q12 + q22 == 1), standing("both states occur", (q11 + q12 > 0) & (q12 + q22 > 0)),
                   given("g is invariant", q11 * g1 + q12 * g2 == (q11 + q12) * g1)]
FOREVER = example(q11="1/2", q12=0, q22="1/2", g1=1, g2=0)
claim("B93-S56", "a stationary sequence of two states is ergodic", g1 == g2, over=FAILING, given=FAILING_SETTING, by=[FOREVER, instances()],
      repair=repair("missing hypothesis", "Hypothesis H asks for an ergodic sequence as well; a plant that stays for ever in the one of two states in which it "
                                          "begins is stationary and not ergodic.",
                    g1 == g2, over=FAILING, given=[*FAILING_SETTING, given("the state changes", q12 > 0)],
                    by=[combination([(-1 / q12, "g is invariant", 1)]), FOREVER, example(q11=0, q12="1/2", q22=0, g1=1, g2=0),
                        instances(using={be: nonneg(), ga: nonneg()},
                                  made_by={q11: be / (be + ga + 2), q22: ga / (be + ga + 2), q12: 1 / (be + ga + 2), g2: g1}),
                        part("Markov sequences, and functions of the state")]),
      note="For Markov sequences: q11, q12, q22 are the probabilities that the states at two times in a row are MM, MN and NN; in a stationary sequence NM is as "
           "probable as MN. A function of the state, g1 at M and g2 at N, is invariant if its mean one time later, given the state M, is g1 again; in an "
           "ergodic sequence only constants are. In section 2.1.2 the paper asks for an ergodic sequence, here for a stationary one. That the noises are "
           "independent of the sequence is taken as said.")
not_checked("B93-S57", "failing observations", "a reference to the results of section 2.2, with no assertion of its own")

z0, z1, rho0, rho1, aa, eps1, eta1 = symbols("z0 z1 rho0 rho1 a eps1 eta1")
claim("B93-X2.1.4", "the autoregressive parameter as the state of a filter",
      (rho1 == A * rho0 + F * eps1) & (z1 == C * rho1 + eta1),
      over={name: scalar() for name in (aa, rho0, eps1, eta1, z0)},
      where=[let(rho1, aa * rho0 + eps1), let(z1, rho1 * z0 + eta1), let(A, aa), let(F, 1), let(C, z0)],
      by=[identity(), instances()],
      note="z0 and z1 are Z_(n-1) and Z_n.")
zz, rr, Mo, now = symbols("zz rr Mo now")
MOMENTS = {aa: scalar(), zz: nonneg(), Mo: positive_semidefinite(3)}
LATER = let(now, vstack(aa, 1, 1))
NOISE_MOMENTS = given("eps_n and eta_n are standard, independent of the past and of each other", Mo == block([[Mo[1, 1], 0, 0], [0, zz, 0], [0, 0, 1]]))
INSIDE = standing("a in (-1, 1)", (aa > -1) & (aa < 1))
MOMENTS_MADE = {aa: c / (1 + c**2), Mo: block([[be**2, 0, 0], [0, zz, 0], [0, 0, 1]])}
claim("B93-X2.1.4.2", "the autoregressive parameters are stationary", T(now) * Mo * now == zz, over=MOMENTS, where=[LATER], given=[NOISE_MOMENTS, INSIDE],
      by=[example(a="99/100", zz=1, Mo=[[1, 0, 0], [0, 1, 0], [0, 0, 1]]), instances(using={be: scalar(), c: scalar()}, made_by=MOMENTS_MADE)],
      repair=repair("missing hypothesis", "rho_n is stationary if it starts with the right variance, but the mean of Z_n^2 grows by at least one at each time: no "
                                          "stationary Z has a finite second moment, and for a near one none exists.",
                    (aa**2 * rr + 1 == rr) & (T(now) * Mo * now == zz + 1 + aa**2 * Mo[1, 1]), over={**MOMENTS, rr: nonneg()}, where=[LATER],
                    given=[NOISE_MOMENTS, INSIDE, given("rho_(n-1) has the variance", rr == 1 / (1 - aa**2))],
                    by=[combination([[(aa**2 - 1, "rho_(n-1) has the variance", 1)], [(T(now), NOISE_MOMENTS[0], now)]]),
                        instances(using={be: scalar(), c: scalar()}, made_by={**MOMENTS_MADE, rr: 1 / (1 - aa**2)}),
                        part("second moments")]),
      note="zz is the mean of Z_(n-1)^2 and Mo the second moments of rho_(n-1) Z_(n-1), eps_n Z_(n-1) and eta_n, of which Z_n is the combination with the "
           "coefficients a, 1, 1; rr is the mean of rho_(n-1)^2. The parameter sequence is (a, 1, Z_(n-1)). A stationary law of Z, with infinite variance, "
           "exists only if the mean of log|rho_n| is negative; for a near one, as in the counterexample, the variance 1/(1 - a^2) of rho_n makes it positive, "
           "and |Z_n| tends to infinity.")

# ---------------------------------------------------------------- weak observability and controllability
Om, Xi, Ob, Co = symbols("Omega Xi Ob Co")
CONSTANT = {A: nonsingular(d), C: matrix(q, d), F: matrix(d, p)}
claim("B93-S58", "the two sums, one term at a time",
      always(t, (Om[t + 1] == T(A[0]) * (R[0] + Ob[t]) * A[0]) & (Xi[t + 1] == A[t + 1] * Xi[t] * T(A[t + 1]) + S[t + 1])), sizes=["d"],
      over={A: signal_of(matrix(d, d), 0), R: signal_of(symmetric_matrix(d), 0), S: signal_of(symmetric_matrix(d), 0)},
      where=[rec(U, t, A[0], A[t + 1] * U[t]), rec(W, t, A[1], A[t + 2] * W[t]),
             rec(Om, t, T(A[0]) * R[0] * A[0], Om[t] + T(U[t + 1]) * R[t + 1] * U[t + 1]),
             rec(Ob, t, T(A[1]) * R[1] * A[1], Ob[t] + T(W[t + 1]) * R[t + 2] * W[t + 1]),
             rec(Xi, t, S[0], A[t + 1] * Xi[t] * T(A[t + 1]) + S[t + 1])],
      by=[induction(also=[U[t + 1] == W[t] * A[0]]), instances(8, d=(1, 2), horizon=2)],
      note="A definition. What is checked is that the sums fit: the first is that of the later times between A_1* and A_1. Times are counted from 0.")
not_checked("B93-D2.1", "weak observability and controllability", "a definition: it fixes notation and asserts nothing")
claim("B93-S59", "for constant parameters, the usual observability sum between A* and A",
      always(t, Om[t] == T(A) * Ob[t] * A), sizes=["d", "q"], over={A: nonsingular(d), C: matrix(q, d)},
      where=[rec(U, t, Identity(d), A * U[t]), rec(Om, t, T(A) * T(C) * C * A, Om[t] + T(A * U[t + 1]) * T(C) * C * (A * U[t + 1])),
             rec(Ob, t, T(C) * C, Ob[t] + T(U[t + 1]) * T(C) * C * U[t + 1])],
      by=[induction(also=[A * U[t] == U[t] * A]), instances(8, d=(1, 2, 3), q=(1, 2), horizon=3)],
      note="A is nonsingular, so that one sum is invertible exactly when the other is; the controllability sum is the usual one as it stands.")
not_checked("B93-L2.2.1", "weakly observable systems enter H1", LIMITS)
not_checked("B93-L2.2.2", "weakly controllable systems enter H2", LIMITS)

# ---------------------------------------------------------------- Theorem 2.4 and Proposition 2.5
BELOW_LARGEST, ABOVE_SMALLEST = la * I - D, D - mu * I
EIGENVALUES = order(
    [T(U)], [T(U) * Q * U], [], [U, T(U)],
    [la * (U * BELOW_LARGEST * T(U)), U * E * BELOW_LARGEST * E * T(U)], [1 / (c + la) * (T(x) * (c**2 * I - T(Q) * Q) * x)],
    [1 / mu * (U * inv(D) * ABOVE_SMALLEST * inv(D) * T(U)), (1 / mu)**2 * (U * inv(D) * E * ABOVE_SMALLEST * E * inv(D) * T(U))],
    [1 / (mu * (mu * c + 1)) * (T(mu * y) * (c**2 * I - T(inv(Q)) * inv(Q)) * (mu * y))],
    lemmas=[invertible(U), pd(D), inv(Q) * (mu * y) == y], roots={E: T(U) * Q * U})
claim("B93-S60", "the smallest and the largest eigenvalue as norms",
      cospectral(Q, D) & (loewner(la * I, D) >> (at_most(Q, la) & (at_most(Q, c) >> (la <= c))))
      & (loewner(D, mu * I) >> (at_most(inv(Q), 1 / mu) & (at_most(inv(Q), c) >> (1 / mu <= c)))), sizes=["d"],
      over={Q: positive_definite(d), D: diagonal(d), U: matrix(d, d), la: positive(), mu: positive(), c: positive(), x: vector(d), y: vector(d)},
      given=[given("U is orthogonal", T(U) * U == I), given("Q = UDU*", Q == U * D * T(U)), given("lambda is an eigenvalue", (Q * x == la * x) & (T(x) * x == 1)),
             given("so is mu", (Q * y == mu * y) & (T(y) * y == 1))],
      by=[EIGENVALUES, chosen(spectral(Q, U, D)),
          example(d=2, Q=[[1, 0], [0, 2]], D=[[1, 0], [0, 2]], U=[[1, 0], [0, 1]], **{"lambda": 2, "mu": 1}, x=[0, 1], y=[1, 0], c=1),
          example(d=1, Q=[[1]], D=[[1]], U=[[1]], **{"lambda": 2, "mu": 1}, x=[1], y=[1], c=1),
          example(d=1, Q=[[1]], D=[[1]], U=[[1]], **{"lambda": 1, "mu": "1/2"}, x=[1], y=[1], c=1),
          example(d=1, Q=[[4]], D=[[1]], U=[[2]], **{"lambda": 4, "mu": 4}, x=[1], y=[1], c=4),
          *(instances(12, d=size, using={L: diagonal(d), S: matrix(d, d)},
                      made_by={U: (I - (S - T(S))) * inv(I + (S - T(S))), D: L * L + I / 2, Q: U * D * T(U), la: D[1, 1], mu: D[d, d],
                               x: U * column(i, d, when(i == 1, 1, 0)), y: U * column(i, d, when(i == d, 1, 0)), c: bound}) for size in (1, 2, 3)
            for bound in (D[1, 1], 1 / D[d, d]))],
      note="By the spectral theorem there are U and D with this Q, and the entries of D are its eigenvalues. D <= lambda I says of a diagonal matrix that none is above "
           "lambda, so that lambda is the largest, and mu is the smallest. Then lambda is a bound as the norm of Q is to be, and not above any other: it is |Q|; and 1/mu "
           "is |inv(Q)|. The distance of Q and I is made of the logarithms of the entries of D by its definition.")
for _id, _title in (
        ("S61", "what the theorem says of the error"), ("T2.4", "the stationary error covariance and convergence to it"),
        ("S67", "a composition contracts with positive probability"),
        ("P2.5", "the rate of convergence in norm"), ("E24", "subexponential growth of the stationary solution"),
        ("R2.5", "nonnegative starts"), ("T2.6", "the filter is exponentially stable"), ("S81", "subexponential growth of the covariance"),
        ("R2.6.1", "the rate as a Lyapunov exponent"), ("R2.6.2", "nonnegative starts of the filter")):
    not_checked(f"B93-{_id}", _title, LIMITS)
not_checked("B93-S66", "the logarithm of the first step is integrable", "the inequalities bound the distance of the first step from above; whether the mean of "
            "its logarithm is finite from below, too, hangs on the negative parts in hypothesis (c), and means of logarithms are beyond exact instances")
not_checked("B93-E23", "the rates of the eigenvalues", "superior limits of logarithms of logarithms along a sequence; all there is to it is that |1 - x| is at "
            "most twice |log x| near x = 1, which is about the logarithm and not about matrices")
not_checked("B93-S62", "condition (C1) as it is checked", "a condition on an expectation, which the proof quotes without the positive part that Theorem 3.1 has")

a0, s0, phi, b0, r0, tau, Phi1 = symbols("a s phi b r tau Phi1")
STEP = (let(S, F * T(F)), let(R, T(C) * C), let(T0, A * T(A) + S), let(Phi1, T0 * inv(I + R * S + R * A * T(A))))
LESS = T0 * T(C) * inv(Identity(q) + C * T0 * T(C)) * C * T0
claim("B93-S64", "a bound for the image of the identity",
      (Phi1 == G) & (at_most(T0, tau) >> at_most(G, tau)) & ((at_most(A * T(A), a0) & at_most(S, s0)) >> at_most(T0, a0 + s0))
      & ((at_most(A, al) & at_most(F, phi, p)) >> (at_most(A * T(A), al**2) & at_most(S, phi**2))), sizes=["d", "p", "q"],
      over={A: nonsingular(d), F: matrix(d, p), C: matrix(q, d), tau: positive(), a0: positive(), s0: positive(), al: positive(), phi: positive()},
      where=[*STEP, let(G, inv(inv(T0) + R))],
      by=[order([], from_squares(T0, tau), [LESS], squared_bound(tau, E, tau * I - T0, T0 - G),
                from_squares(A * T(A), a0), from_squares(S, s0), squared_bound(a0 + s0, K, a0 * I - A * T(A), s0 * I - S),
                *([(x**2 * I - X * T(X)) * (x**2 * I - X * T(X)), 2 * X * (x**2 * Identity(n) - T(X) * X) * T(X)] for X, x, n in ((A, al, d), (F, phi, p))),
                roots={E: G, K: T0},
                inside=[within(1, loewner(tau * I, T0), loewner(T0, G)), within(2, loewner(a0 * I, A * T(A)), loewner(s0 * I, S))]),
          instances(d=1, p=1, q=(1, 2), made_by={A: al * I, F: phi * I, a0: al**2, s0: phi**2, tau: al**2 + phi**2}),
          instances(**SMALL, made_by={A: al * I, a0: al**2, F: Zero(d, p), tau: al**2}), instances(**SMALL)],
      note=BY_NORMS + "The norm of the sum is at most the sum of the norms, as is shown for these two nonnegative matrices.")

claim("B93-S65", "a bound for the inverse of the image of the identity",
      (inv(Phi1) == G) & ((at_most(inv(T0), tau) & at_most(R, r0)) >> at_most(G, tau + r0)) & (at_most(inv(A * T(A)), b0) >> at_most(inv(T0), b0))
      & ((at_most(inv(A), be) & at_most(C, ga)) >> (at_most(inv(A * T(A)), be**2) & at_most(R, ga**2))), sizes=["d", "p", "q"],
      over={A: nonsingular(d), F: matrix(d, p), C: matrix(q, d), tau: positive(), r0: positive(), b0: positive(), be: positive(), ga: positive()},
      where=[*STEP, let(G, inv(T0) + R)],
      by=[order([], from_squares(inv(T0), tau), from_squares(R, r0), squared_bound(tau + r0, E, tau * I - inv(T0), r0 * I - R),
                from_squares(inv(A * T(A)), b0), [inv(A * T(A)) * F * inv(Identity(p) + T(F) * inv(A * T(A)) * F) * T(F) * inv(A * T(A))],
                squared_bound(b0, K, b0 * I - inv(A * T(A)), inv(A * T(A)) - inv(T0)),
                squared_bound(be**2, L, be**2 * I - T(inv(A)) * inv(A)), squared_bound(ga**2, U, ga**2 * I - T(C) * C),
                roots={E: G, K: inv(T0), L: inv(A * T(A)), U: R},
                inside=[within(1, loewner(tau * I, inv(T0)), loewner(r0 * I, R)), within(2, loewner(b0 * I, inv(A * T(A))), loewner(inv(A * T(A)), inv(T0)))]),
          instances(d=1, p=(1, 2), q=1, made_by={A: I / be, F: Zero(d, p), C: ga * I, b0: be**2, r0: ga**2, tau: be**2}),
          instances(**SMALL, made_by={A: I / be, b0: be**2, F: Zero(d, p), tau: be**2}), instances(**SMALL)],
      note=BY_NORMS + "Phi_1(I) = inv(inv(T) + R_1), by S63.")

#: the blocks of the matrix of each time and of the product of the first t, the image of X0 under the maps, and the inverses of the denominators
At, Bt, Ct, Dt, Wt, X0, at, bt, ct, et, Xt = symbols("A B C D W X0 a b c e X")
TIMES = {name: sequence_of(matrix(d, d), 0, n) for name in (At, Bt, Ct, Dt, Wt)}
claim("B93-S68", "the composition of the maps is the map of the product",
      forall(t, 0, n, invertible(ct[t] * X0 + et[t]) & (Xt[t] == (at[t] * X0 + bt[t]) * inv(ct[t] * X0 + et[t]))), sizes=["d", "n"],
      over={**TIMES, X0: matrix(d, d)},
      where=[rec(at, t, I, At[t] * at[t] + Bt[t] * ct[t]), rec(bt, t, Zero(d, d), At[t] * bt[t] + Bt[t] * et[t]),
             rec(ct, t, Zero(d, d), Ct[t] * at[t] + Dt[t] * ct[t]), rec(et, t, I, Ct[t] * bt[t] + Dt[t] * et[t]),
             rec(Xt, t, X0, (At[t] * Xt[t] + Bt[t]) * Wt[t])],
      given=[given("W_k is the inverse of C_kX_k + D_k", forall(k, 0, n - 1, Wt[k] * (Ct[k] * Xt[k] + Dt[k]) == I))],
      by=[induction(also=[Xt[t] * (ct[t] * X0 + et[t]) == at[t] * X0 + bt[t]], step=order([], [inv(ct[t] * X0 + et[t]) * Wt[t]])),
          instances(d=(1, 2), n=(1, 2, 3), using={U: nonsingular(d)}, made_by={Wt: (k, inv(U)), Dt: (k, U - Ct[k] * Xt[k])})],
      note="The matrix of time t, counted from 0, has the blocks A_t, B_t, C_t, D_t, and the product of the first t the blocks a_t, b_t, c_t, e_t; X_t is what "
           "the maps, one after the other, make of X_0. The display that says so is (13); (12), which the text names, defines the action from which it "
           "follows.")

claim("B93-S70", "the norm of K_n x",
      (T(x) * T(K) * K * x == T(x) * Pbar * x) & ((T(K * x) * (K * x))**2 <= T(Pbar * x) * (Pbar * x)), sizes=["d"],
      over={K: matrix(d, d), x: vector(d)}, where=[let(Pbar, T(K) * K)],
      by=[example(d=1, K=[[1]], x=[2]), instances(d=(1, 2))],
      repair=repair("factor", "The norm of x is missing on the right; it is right for unit vectors.",
                    (T(x) * T(K) * K * x == T(x) * Pbar * x) & ((T(K * x) * (K * x))**2 <= T(Pbar * x) * (Pbar * x)), sizes=["d"],
                    over={K: matrix(d, d), x: vector(d)}, where=[let(Pbar, T(K) * K)],
                    given=[given("x is a unit vector", T(x) * x == 1)],
                    by=[order([], [T(Pbar * x - x * (T(x) * Pbar * x)) * (Pbar * x - x * (T(x) * Pbar * x))]),
                        instances(d=(1, 2, 3), using={y: vector(d)}, made_by={x: column(i, d, when(i == 1, 1, 0)) - 2 * y[1] / (T(y) * y) * y})]))

claim("B93-S71", "the norm of K_n",
      loewner(si * I, T(K) * K), sizes=["d"], over={K: matrix(d, d), si: positive()}, where=[let(Pbar, T(K) * K)],
      given=[given("||Pbar|| <= sigma", loewner(si**2 * I, T(Pbar) * Pbar))],
      by=[order([1 / (2 * si) * (si**2 * I - T(Pbar) * Pbar), 1 / (2 * si) * (si * I - Pbar) * (si * I - Pbar)]),
          instances(d=1, using={c: nonzero()}, made_by={K: c * I, si: c**2}), instances(d=(1, 2), made_by={K: I, si: 1}), instances(d=(1, 2))],
      note="||K||^2 is the least c with K*K <= cI, and ||Pbar||^2 the least with Pbar*Pbar <= cI.")

APART = {"over": {K: matrix(d, d), D: diagonal(d), si: positive(), mu: positive(), c: positive()},
         "where": [let(Pbar, T(K) * K), let(P, T(K) * D * K), let(X, P - Pbar)],
         "given": [given("||Pbar|| <= sigma", at_most(Pbar, si)), given("||D - I|| <= mu", at_most(D - I, mu)), given("||K|| <= c", at_most(K, c))]}


def _in_the_middle(bound, side):
    """c^2 I - XX for X = K*YK and c = bound mu, from Y and -Y at most mu I and K*K at most the bound."""
    limit = bound * mu
    less, more = limit * I - X, limit * I + X
    return [1 / (2 * limit) * outer * term * outer for outer, gap in ((more, mu * I - SPREAD), (less, mu * I - -SPREAD)) for term in (mu * side, T(K) * gap * K)]


SPREAD = D - I
MIDDLE = [[1 / (2 * mu) * (mu**2 * I - T(SPREAD) * SPREAD), 1 / (2 * mu) * (mu * I - sign * SPREAD) * (mu * I - sign * SPREAD)] for sign in (1, -1)]
claim("B93-S72", "the difference of two solutions",
      at_most(X, si * si * mu), sizes=["d"], **APART,
      by=[example(d=1, K=[["1/2"]], D=[[2]], sigma="1/4", mu=1, c="1/2"), instances(d=(1, 2))],
      repair=repair("factor", "The norm of Pbar enters once: ||K||^2 is ||Pbar||, not its square.",
                    at_most(X, c**2 * mu) & at_most(X, si * mu), sizes=["d"], **APART,
                    by=[order(from_squares(Pbar, si), *MIDDLE, _in_the_middle(c**2, c**2 * I - T(K) * K), _in_the_middle(si, si * I - Pbar),
                              lemmas=[loewner(si * I, Pbar), loewner(mu * I, SPREAD), loewner(mu * I, -SPREAD)]),
                        instances(d=1, made_by={si: K[1, 1]**2, c: K[1, 1], D: (1 + mu) * I}), instances(d=1, made_by={si: K[1, 1]**2, c: K[1, 1], D: (1 - mu) * I}),
                        instances(d=(1, 2))]),
      note=BY_NORMS + "The norm of the diagonal matrix D - I is the largest |1 - lambda_i|.")

# ---------------------------------------------------------------- Theorem 2.6
ABOVE_LAMBDA, BELOW_SIGMA = X - la * I, si * I - P
FALLS = [[], [T(x1) * ABOVE_LAMBDA * x1], [la / si * (T(x1) * BELOW_SIGMA * x1)], [T(x1) * ABOVE_LAMBDA * x1, la / si * (T(x1) * BELOW_SIGMA * x1)]]
claim("B93-S78", "the Lyapunov function along the backward recursion",
      (T(x1) * P * x1 - T(x0) * P0 * x0 == T(x1) * X * x1) & (T(x1) * X * x1 >= la * T(x1) * x1) & (la * T(x1) * x1 >= la / si * (T(x1) * P * x1))
      & (T(x0) * P0 * x0 <= tau * T(x1) * P * x1), sizes=["d"],
      over={B: matrix(d, d), P0: positive_semidefinite(d), X: positive_semidefinite(d), x1: vector(d), la: nonneg(), si: positive()},
      where=[let(P, B * P0 * T(B) + X), let(x0, T(B) * x1), let(tau, 1 - la / si)],
      given=[given("lambda = 1/|inv(T)|, or 0", (la == 0) | (invertible(X) & (la > 0) & at_most(inv(X), 1 / la))), given("|P| <= sigma", at_most(P, si))],
      by=[order([1 * X], from_squares(P, si), *FALLS,
                root_bound(X, la, 1 / la, E), from_squares(P, si), *FALLS,
                roots={E: X}, lemmas=[loewner(X, la * I), loewner(si * I, P)]),
          instances(d=(1, 2), made_by={B: I, X: la * I, P0: si * I - la * I}), instances(d=(1, 2), made_by={B: Zero(d, d), X: la * I, si: la + 1}),
          instances(d=(1, 2), made_by={la: 0}), instances(d=(1, 2))],
      note=BY_NORMS + "lambda is 0 where T is singular. x0, x1, P0, P stand for x_n, x_(n+1), P_n, P_(n+1) and X for T_(n+1), with P = B P0 B* + X of "
                      "Lemma 2.7. The last line is V_n <= tau V_(n+1).")

G_, Bs_, Ts_, Pi_, rate, p0, pbar, tau1 = symbols("G B T Pi rate p0 pbar tau")
claim("B93-S77", "n steps have the form of one",
      always(t, P[t] == Pi_[t] * P0 * T(Pi_[t]) + G_[t]), sizes=["d"],
      over={Bs_: signal_of(matrix(d, d), 0), Ts_: signal_of(positive_semidefinite(d), 0), P0: positive_semidefinite(d)},
      where=[rec(P, t, P0, Bs_[t] * P[t] * T(Bs_[t]) + Ts_[t]), rec(Pi_, t, I, Bs_[t] * Pi_[t]),
             rec(G_, t, Zero(d, d), Ts_[t] + Bs_[t] * G_[t] * T(Bs_[t]))],
      by=[induction(), instances(12, d=(1, 2), horizon=3),
          part("the recursion over n steps")],
      note="So the sequence P_(nk) follows the recursion of Lemma 2.7 with the product of n matrices B for B and with the G_n of Lemma 2.8 for T, which may be "
           "invertible where T is not. Times are counted from 0. What the text does not say is that blocks of n times need not be an ergodic sequence: for "
           "parameters of period two there are two ways to cut the times into blocks of two, and n has to serve both.")

a_, f0, c0 = symbols("a f c")
QUARTER = matrix_of(i, j, 2, 2, when(i < j, 1, when(i > j, rational("1/4"), 0)))
SCALAR_PHI = function(Phi, [x], (a_**2 * x + f0**2) / (1 + c0**2 * f0**2 + c0**2 * a_**2 * x))
claim("B93-S82", "the ergodic theorem for the rates",
      (a_ - pbar * c0**2 * a_)**2 <= tau1, over={a_: nonzero(), f0: nonzero(), c0: nonzero(), p0: positive(), pbar: positive()},
      where=[SCALAR_PHI, let(x1, Phi(p0)), let(tau1, 1 - (x1 * c0**2 * x1 + (1 - x1 * c0**2)**2 * f0**2) / x1)],
      given=[given("pbar is the limit of the P_n", pbar == Phi(pbar))],
      by=[example({"a": 1, "f": "3/2", "c": 1, "p0": "1/100", "pbar": "3/4"}), instances(made_by={p0: pbar})],
      repair=repair("missing hypothesis", "The rates tau_n are a stationary sequence only for the stationary solution; for another one tau_1 depends on P_0 "
                                          "and the limit does not.",
                    always(t, loewner(rate[t] * Pbar, Pi_[t] * Pbar * T(Pi_[t]))), sizes=["d"],
                    over={B: matrix(d, d), Pbar: positive_semidefinite(d), X: symmetric_matrix(d), la: nonneg(), si: positive()},
                    where=[rec(Pi_, t, I, B * Pi_[t]), rec(rate, t, 1, (1 - la / si) * rate[t])],
                    given=[given("Pbar is stationary", Pbar == B * Pbar * T(B) + X), given("T >= lambda I", loewner(X, la * I)),
                           given("Pbar <= sigma I", loewner(si * I, Pbar)), standing("lambda <= sigma, as T <= Pbar", 1 - la / si >= 0)],
                    by=[induction(also=[rate[t] >= 0], base=order(),
                                  step=order([(1 - la / si) * rate[t]], [B * (rate[t] * Pbar - Pi_[t] * Pbar * T(Pi_[t])) * T(B), rate[t] * (X - la * I),
                                                                        rate[t] * (la / si) * (si * I - Pbar)])),
                        example(d=1, B=[[1]], Pbar=[[1]], X=[["1/2"]], **{"lambda": "1/2", "sigma": 1}),
                        example(d=1, B=[[1]], Pbar=[[1]], X=[[0]], **{"lambda": "1/2", "sigma": 1}),
                        example(d=1, B=[["1/2"]], Pbar=[[4]], X=[[3]], **{"lambda": 3, "sigma": 3}),
                        instances(d=(1, 2), made_by={B: c * I, Pbar: I, X: (1 - c**2) * I, si: 1, la: 1 - c**2}, using={c: scalar()}, horizon=3),
                        instances(d=(2,), using={E: nonsingular(2)}, horizon=3,
                                  made_by={Pbar: E * T(E), B: E * QUARTER * inv(E), X: Pbar - B * Pbar * T(B), la: 0, si: Pbar[1, 1] + Pbar[2, 2]}),
                        part("constant parameters")]),
      note="For constant parameters in one dimension, where P_n tends to the fixed point pbar, so that the left side is the logarithm of the square of a - "
           "pbar c^2 a, and tau_1 is a number. The stationary solution is the constant one. In the repair P_n is that solution, constant parameters of any "
           "size: B^t Pbar B*^t is at most tau^t Pbar, so that the rate is at most log tau.")

claim("B93-S83", "a negative mean rate",
      (la <= si) & (1 - la / si < 1) & (1 - mu / si <= 1), sizes=["d"],
      over={Ts_: positive_definite(d), P0: positive_semidefinite(d), B: matrix(d, d), x: vector(d), la: positive(), mu: nonneg(), si: positive()},
      where=[let(P, B * P0 * T(B) + Ts_)],
      given=[standing("a unit vector", T(x) * x == 1), given("lambda is at most T", loewner(Ts_, la * I)), given("P <= sigma I", loewner(si * I, P))],
      by=[order([T(x) * (si * I - P) * x, T(x) * (Ts_ - la * I) * x, T(x) * B * P0 * T(B) * x], [1 * (la / si)], [1 * (mu / si)]),
          example(d=1, T=[[1]], P0=[[0]], B=[[0]], x=[1], **{"lambda": 2, "mu": 0, "sigma": 1}),
          example(d=1, T=[[2]], P0=[[0]], B=[[0]], x=[1], **{"lambda": 2, "mu": 0, "sigma": 1}),
          instances(d=(1, 2), using={y: vector(d), E: matrix(d, d), c: positive()},
                    made_by={x: column(i, d, when(i == 1, 1, 0)) - 2 * y[1] / (T(y) * y) * y, Ts_: la * I + E * T(E), P0: I, B: c * I,
                             si: la + c**2 + sum_of(i, 1, d, sum_of(j, 1, d, E[i, j]**2))}),
          restated("a variable that is not positive, and negative with positive probability, has a negative mean",
                   "the norm of a nonnegative matrix X is the least c with X <= cI")],
      note="lambda > 0 is the smallest eigenvalue of an invertible T, sigma the norm of P; mu is the smallest eigenvalue of any other T, or 0. So tau is at "
           "most 1 always, and where T is invertible it is less than 1, so that log tau is never positive, and negative with positive probability: then its "
           "mean is negative (it may be minus infinity, as tau may be 0).")
