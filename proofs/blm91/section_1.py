# SPDX-License-Identifier: MIT
"""Section I: the model, the Riccati equation, the fast algorithm, and the results announced.

A stationary model x_(t+1) = F x_t + v_t, y_t = h'x_t + w_t with E y_t^2 = 1 enters the Kalman filter through F, h and g = E{x_(t+1) y_t} alone: the
covariance Pi_t of the estimate obeys

    Pi_(t+1) = F Pi_t F' + k_t (1 - h'Pi_t h) k_t',      k_t = (g - F Pi_t h)/(1 - h'Pi_t h),      Pi_0 = 0,

in which the covariance of the state, and with it that of the noise, does not occur. 1 - h'Pi_t h is r_t, the variance of the innovation; the condition that it
stays positive is that all Toeplitz matrices of the covariances are positive definite, a little less than a positive spectral density.

For n = 1 what is announced is proved in Sections III and V: convergence where the pseudo-polynomial D has one sign, periodic or dense orbits elsewhere.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import evaluation, example, identity, instances, steps
from exactkf.language import *
from proofs.blm91.notation import *
from proofs.blm91.section_2_covariance import AB, MA, MA_NOTE, PHI, PSD_MODEL, SUM, TOEPLITZ, WEAK, Mk, Q, S, Tm, Toep, cc, num, p, sigma
from proofs.blm91.section_2_filtering import FAST, FILTER, fk, kk, xh, yt

Pi, G2, P2, k2, hit, cov, stay, y, back, many, special, hits, far, flag, definite, real, poly, bound, pit, qa, Lam, growth, alb, gab, alc, gac = symbols(
    "Pi G2 P2 K2 hit cov remainder y back divides special hits far region definite real polynomial bound pi_t q Lambda growth alpha_2 gamma_2 alpha_3 gamma_3")
SYSTEM = {F: matrix(n, n), h: vector(n), g: vector(n), P: symmetric_matrix(n)}
RICCATI = rec(Pi, t, Zero(n, n), F * Pi[t] * T(F) + (g - F * Pi[t] * h) * inv(1 - T(h) * Pi[t] * h) * T(g - F * Pi[t] * h))
BY = [identity(n=(1, 2), m=(1, 2)), instances(n=(1, 2, 3), m=(1, 2))]
SAID = "Estimates are projections on y_0 .. y_(t-1) in the covariance form of the model."

# ---------------------------------------------------------------------- model and filter
claim("BLM91-E1.1", "the model is stationary, with E y^2 = 1 and E x_(t+1) y_t = g",
      forall(t, 0, m, (X[t] * G * T(X[t]) == P) & (X[t + 1] * G * T(Y(t)) == g) & (Y(t) * G * T(Y(t)) == Identity(1))), sizes=["n", "m"], over=SYSTEM, where=MODEL,
      by=[identity(n=(1, 2, 3), m=(0, 1, 2)), instances(n=(1, 2, 3), m=(1, 2))], note="The display is the model; checked is that the noise covariances P - FPF', g - FPh, 1 - h'Ph, white, give it these properties.")
claim("BLM91-E1.2", "the Kalman filter", forall(t, 0, m, xh(t + 1) == F * xh(t) + (g - F * Pi[t] * h) * inv(1 - T(h) * Pi[t] * h) * (Y(t) - T(h) * xh(t))), sizes=["n", "m"], over=SYSTEM, where=[*FILTER, RICCATI],
      by=[identity(n=(1, 2), m=(0, 1)), instances(n=(1, 2, 3), m=(1, 2))], note=SAID + " The gain is (1.3).")
OTHER = let(G2, T(X[0]) * P2 * X[0] + sum_of(k, 0, m + 1, T(vstack(V(k), W(k))) * block([[P2 - F * P2 * T(F), g - F * P2 * h], [T(g - F * P2 * h), 1 - T(h) * P2 * h]]) * vstack(V(k), W(k))))
claim("BLM91-S1", "the gain is the same for all realizations", forall(t, 0, m, kk(t) == k2(t)), sizes=["n", "m"], over={**SYSTEM, P2: symmetric_matrix(n)},
      where=[*FILTER, OTHER, function(k2, [t], 1 / r[t] * X[t + 1] * G2 * T(yt(t)))], by=BY, note="Two state covariances P and P2 with the same F, g, h, that is with the same covariances of the output.")
claim("BLM91-E1.3", "the Kalman gain", forall(t, 0, m, kk(t) * (1 - T(h) * Pi[t] * h) == g - F * Pi[t] * h), sizes=["n", "m"], over=SYSTEM,
      where=[*FILTER, RICCATI], by=BY, note="kk is the coefficient of the innovation in the projection, multiplied out by the scalar 1 - h'Pi_t h.")
COV = function(cov, [t], xh(t) * G * T(xh(t)))
claim("BLM91-E1.4", "the Riccati equation of the estimate", (cov(0) == Zero(n, n)) & forall(t, 0, m, cov(t + 1) == F * cov(t) * T(F) + (g - F * cov(t) * h) * inv(1 - T(h) * cov(t) * h) * T(g - F * cov(t) * h)),
      sizes=["n", "m"], over=SYSTEM, where=[*FILTER, COV], by=BY, note="cov(t) is the covariance of the projection of x_t on y_0 .. y_(t-1).")
claim("BLM91-S2", "Pi_t is the covariance of the estimate", forall(t, 0, m, Pi[t] == cov(t)), sizes=["n", "m"], over=SYSTEM, where=[*FILTER, COV, RICCATI], by=BY, note=SAID)

# ---------------------------------------------------------------------- covariances and spectral density
claim("BLM91-E1.5", "covariances depend on the lag alone", forall(t, 0, m, forall(i, 0, m - t, (Y(t + i) * G * T(Y(t)) == Y(i) * G * T(Y(0))) & (Y(0) * G * T(Y(0)) == Identity(1)))), sizes=["n", "m"], over=SYSTEM, where=MODEL,
      by=[identity(n=(1, 2), m=(1, 2, 3)), instances(n=(1, 2, 3), m=(2, 3))], note="The display defines c_i; checked is that it does not depend on t and that c_0 = 1.")
claim("BLM91-S3", "the spectral density", num == poly * recip(poly) / sum_of(j, 0, n, sigma[j] ** 2), sizes=["n"], over={sigma: sequence(0, n)}, where=[*MA, let(poly, sum_of(j, 0, n, sigma[j] * Z**j))],
      by=[identity(n=range(0, 5)), instances(n=range(0, 5))], note="The display defines the density; checked is that for moving averages sum sigma_j e_(t-j), E y^2 = 1, it is the squared modulus of the transfer function. num is the sum of c_k z^k.")
claim("BLM91-E1.6", "the positive real part", (2 * laurent(p, 0) == 1) & forall(k, 1, m, rows([[laurent(p, k)]]) == Y(k) * G * T(Y(0))), sizes=["n", "m"], over=SYSTEM, where=[*MODEL, PHI],
      by=[identity(n=(1, 2), m=(1, 2, 3)), instances(n=(1, 2, 3), m=(2, 3))], note="As series: Phi_+(z) + Phi_+(1/z) has the coefficients c_0 = 1 and c_k of z^k and z^(-k).")
claim("BLM91-S4", "positive realness is positive definiteness of all Toeplitz matrices", iff(pos_on_circle(num), forall(t, 0, m, pd(Toep(t)))), sizes=["n", "m"], over={sigma: sequence(0, n)}, where=[*MA, TOEPLITZ],
      by=[example(n=1, m=6, sigma=[1, 1]), instances(n=(1, 2), m=(3, 4))],
      repair=repair("boundary case", WEAK, nonneg_on_circle(num) >> pd(Tm), sizes=["n", "m"], over={a: vector(n), g: vector(n)}, where=[*AB, TOEPLITZ, let(Tm, Toep(m))], given=[given("F stable", schur(F))],
                    by=[steps("BLM91-E2.3", "BLM91-E2.4", facts=["c_k are the Fourier coefficients of the spectral density when F is stable"], prose="x'T_t x is the mean of |x(z)|^2 times a nonnegative density that is not zero"),
                        instances(48, n=(1, 2), m=(0, 1, 2, 3, 4), using={x: vector(n)}, made_by={a: x / (1 + SUM)}), example(n=1, m=6, a=[0], g=["1/2"]), example(n=1, m=6, a=[0], g=["-1/2"])]),
      note=MA_NOTE)
claim("BLM91-E1.7", "the Toeplitz matrix is the covariance of y_0 .. y_t", matrix_of(i, j, m + 1, m + 1, (Y(i - 1) * G * T(Y(j - 1)))[1, 1]) == Toep(m), sizes=["n", "m"], over=SYSTEM,
      where=[*MODEL, function(cc, [k], when(k == 0, 1, (T(h) * F ** (k - 1) * g)[1, 1])), TOEPLITZ], by=[identity(n=(1, 2), m=(0, 1, 2)), instances(n=(1, 2, 3), m=(1, 2, 3))])
CLASSIC = ["Rouche's theorem", "r_t is bounded below by the minimum of the spectral density", "a positive D has one monic Schur spectral factor", "a monotone bounded sequence of symmetric matrices converges"]
near_, grows_ = symbols("increment monotone")
claim("BLM91-S5", "convergence of gain and covariance", (dist < rational("1/1000")) & (near_ < rational("1/1000")) & grows_, sizes=["n", "m"], over=STEADY_OVER,
      where=[*STEADY, *CANONICAL, RICCATI, let(near_, trace(Pi[20] - Pi[19])), let(grows_, loewner(Pi[m + 1], Pi[m]))], given=STEADY_GIVEN,
      by=[steps("BLM91-E2.25", "BLM91-E2.28", "BLM91-E4.3", facts=CLASSIC, prose="Pi_(t+1) - Pi_t = r_t q*_t q*_t' with r_t > 0: Pi_t grows, and P - Pi_t is an error covariance for every state covariance P, so that the limit is the smallest; "
                "k_t = q_t - a converges with q_t"),
          instances(n=(1, 2), m=(0, 1, 2), **STEADY_DRAW), example(n=1, m=1, a=[0], g=["2/5"], x=["1/2"]), example(n=2, m=2, a=[0, 0], g=[0, "2/5"], x=[0, "1/2"])],
      note="On data with known spectral factor, as for the steady-state filter in Section II: at t = 20 the gain is within 1/1000 (squared) of x - a and the increment of Pi below 1/1000; at time m Pi grows.")
DATA_PI = (*CANONICAL, RICCATI, *stripped(g + a, g), *DATA)
claim("BLM91-E1.8a", "1 - h'Pi h is not negative for positive real data", (1 - (T(h) * Pi[m] * h)[1, 1] == r[m]) & (r[m] > 0), sizes=["n", "m"], over={a: vector(n), g: vector(n)}, where=DATA_PI, given=REAL,
      by=[steps("BLM91-E2.27", "BLM91-E2.28", facts=["Rouche's theorem", "Schwarz's lemma"], prose="1 - h'Pi_t h is r_t, and |gamma_t| < 1 keeps r_t positive"), instances(n=(1, 2, 3), m=(0, 1, 2), **CLASSICAL), *EDGE],
      note="Even > 0; m is the time t.")
R_ = sym("R")
GAIN = (let(Q, P - F * P * T(F)), let(R_, 1 - T(h) * P * h), let(g, F * P * h + S))
claim("BLM91-E1.8b", "where 1 - h'Pi h = 0 the numerator of the gain vanishes", hit >> (flag & (stay == Zero(n, 1))), sizes=["n", "m"], over={F: matrix(n, n), h: vector(n), P: positive_semidefinite(n), S: vector(n)},
      where=[*GAIN, RICCATI, let(hit, (T(h) * Pi[m] * h)[1, 1] == 1), let(stay, g - F * Pi[m] * h), let(flag, psd(P - Pi[m]))], given=[given("white noise", psd(block([[Q, S], [T(S), R_]])))],
      by=[steps("BLM91-S2", facts=["a semidefinite matrix with a zero on the diagonal has a zero row there"], prose="(g - F Pi h, 1 - h'Pi h) is a column of the covariance of (x_(t+1), y_t) minus its prediction"),
          example(n=1, m=1, F=[[1]], h=[1], P=[[1]], S=[0]), example(n=1, m=1, F=[[-1]], h=[1], P=[[1]], S=[0]), example(n=2, m=2, F=[[0, -1], [1, 0]], h=[1, 0], P=[[1, 0], [0, 1]], S=[0, 0]),
          example(n=1, m=1, F=[[2]], h=[1], P=[[1]], S=[-1]),
          instances(n=(1, 2), m=(0, 1, 2), using={Mk: matrix(n, n), u: vector(n), x: positive()}, made_by={F: Mk / (1 + trace(Mk * T(Mk))), **PSD_MODEL})],
      note="For every stationary model, degenerate ones included; for strictly positive real data 1 - h'Pi_t h is never 0. m is the time t.")
CONDITION = forall(t, 0, m, 1 - (T(h) * Pi[t] * h)[1, 1] > 0)
