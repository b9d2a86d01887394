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
from exactkf.evidence import evaluation, example, generic_index, identity, induction, instances, restated, steps, use
from exactkf.language import *
from proofs.blm91.lemmas_covariance import (
    BY_COVARIANCE,
    BY_RICCATI_OF_COVARIANCE,
    BY_RICCATI_TRANSPOSED,
    COVARIANCE,
    COVARIANCE_LEMMAS,
    RICCATI_OF_COVARIANCE,
    SYMMETRIC,
    cov,
    moved,
    stays_symmetric,
)
from proofs.blm91.lemmas_estimate import BY_ESTIMATE, CLOSED, ESTIMATE, ESTIMATE_LEMMAS, FILTER_WEIGHTS, KALMAN, PROJECTED, RICCATI_GAIN, SOME, filtered
from proofs.blm91.lemmas_gain import BY_RICCATI, COEFFICIENTS, FORWARD, GAIN, MODELLED, REVERSED, RICCATI_LEMMAS, SOLUTION, SYSTEM, innovation, row, sums_with
from proofs.blm91.lemmas_steady import RICCATI_CONVERGES, RICCATI_CONVERGES_BY, STEADY_MODEL
from proofs.blm91.notation import *
from proofs.blm91.section_2_covariance import AB, MA, MA_NOTE, PHI, PSD_MODEL, SUM, TOEPLITZ, WEAK, Mk, Q, S, Tm, Toep, cc, num, p, sigma
from proofs.blm91.section_2_filtering import FAST, fk, fks

Pi, G2, P2, k2, hit, stay, back, many, special, hits, far, flag, definite, real, poly, bound, pit, qa, growth, alb, gab, alc, gac = symbols(
    "Pi G2 P2 K2 hit predicted back divides special hits far region definite real polynomial bound pi_t q growth alpha_2 gamma_2 alpha_3 gamma_3")
RICCATI = rec(Pi, t, Zero(n, n), F * Pi[t] * T(F) + (g - F * Pi[t] * h) * inv(1 - T(h) * Pi[t] * h) * T(g - F * Pi[t] * h))

# ---------------------------------------------------------------------- model and filter
claim("BLM91-E1.1", "the model is stationary, with E y^2 = 1 and E x_(t+1) y_t = g",
      forall(t, 0, m, (covariance(state(t), state(t)) == P) & (covariance(state(t + 1), output(t)) == g) & (covariance(output(t), output(t)) == 1)), sizes=["n", "m"], over=SYSTEM, where=STATE,
      by=[generic_index(*WRITTEN_OUT), instances(n=(1, 2, 3), m=(1, 2))],
      note="The display is the model; checked is that the noise covariances P - FPF', g - FPh, 1 - h'Ph, white, give it these properties. X_0 and X_v are the coefficients of x_0 and v_s in x_t.")
claim("BLM91-E1.2", "the Kalman filter", always(t, filtered(KALMAN(t))), sizes=["n"], over=SYSTEM, where=[*STATE, *ESTIMATE, *RICCATI_GAIN, *FILTER_WEIGHTS], given=SOME,
      by=[generic_index(*ESTIMATE_LEMMAS, **CLOSED, uses=BY_ESTIMATE), instances(n=(1, 2, 3), horizon=2)], note=PROJECTED + " The gain K_t is (1.3). U serves the proof alone.")
OTHER = {"noise": (P2 - F * P2 * T(F), g - F * P2 * h, 1 - T(h) * P2 * h), "cov": P2}
claim("BLM91-S1", "the gain is the same for all realizations",
      forall(t, 0, m, GAIN == 1 / r[t] * covariance(state(t + 1), innovation(t, t), **OTHER)), sizes=["n", "m"],
      over={**SYSTEM, P2: symmetric_matrix(n)}, where=[*MODELLED, *FORWARD],
      by=[generic_index(REVERSED, *WRITTEN_OUT, sums_with(phi, innovation), sums_with(phi, innovation, 4, **OTHER), supported=[phi, phis],
                        uses=[use(v, i=t, t=t, row=row) for v in (3, 4)]), instances(n=(1, 2, 3), m=(1, 2))],
      note="Two state covariances P and P2 with the same F, g, h, that is with the same covariances of the output. " + COEFFICIENTS)
claim("BLM91-E1.3", "the Kalman gain", forall(t, 0, m, GAIN * (1 - T(h) * Pi[t] * h) == g - F * Pi[t] * h), sizes=["n", "m"], over=SYSTEM, where=[*MODELLED, *FORWARD, *SOLUTION],
      by=[generic_index(*RICCATI_LEMMAS, **BY_RICCATI), instances(n=(1, 2, 3), m=(1, 2))],
      note="The left side is the coefficient of the innovation in the projection, (2.17), multiplied out by the scalar 1 - h'Pi_t h. phi_g, phis_g and Pi_sum serve the proof alone. " + COEFFICIENTS)
_ESTIMATED = {"sizes": ["n"], "over": SYSTEM, "where": [*STATE, *ESTIMATE, *COVARIANCE, *RICCATI_GAIN, *FILTER_WEIGHTS], "given": SOME}
_CLOSED = {"closed": [*CLOSED["closed"], moved]}
claim("BLM91-E1.4", "the Riccati equation of the estimate",
      (cov(0) == Zero(n, n)) & always(t, cov(t + 1) == F * cov(t) * T(F) + (g - F * cov(t) * h) * T(g - F * cov(t) * h) / (1 - T(h) * cov(t) * h)), **_ESTIMATED,
      by=[generic_index(*RICCATI_OF_COVARIANCE, **_CLOSED, uses=BY_RICCATI_OF_COVARIANCE),
          generic_index(*RICCATI_OF_COVARIANCE, stays_symmetric(42), **_CLOSED, uses=BY_RICCATI_TRANSPOSED), instances(n=(1, 2, 3), horizon=2)],  # and its transpose
      note="cov(t) is the covariance of the estimate. " + PROJECTED + " Pi_t, the solution from zero, K, U and F_g serve the proof alone.")
claim("BLM91-S2", "Pi_t is the covariance of the estimate", always(t, Pi[t] == cov(t)), **_ESTIMATED,
      by=[generic_index(*COVARIANCE_LEMMAS, SYMMETRIC, **_CLOSED, uses=BY_COVARIANCE), instances(n=(1, 2, 3), horizon=2)], note=PROJECTED + " K, U and F_g serve the proof alone.")

# ---------------------------------------------------------------------- covariances and spectral density
claim("BLM91-E1.5", "covariances depend on the lag alone", forall(t, 0, m, forall(i, 0, m - t, (covariance(output(t + i), output(t)) == covariance(output(i), output(0))) & (covariance(output(0), output(0)) == 1))),
      sizes=["n", "m"], over=SYSTEM, where=STATE, by=[generic_index(*WRITTEN_OUT), instances(n=(1, 2), m=(2,))], note="The display defines c_i; checked is that it does not depend on t and that c_0 = 1.")
TRANSFER = T(h) * inv(Identity(n) * Z - F)
BACKWARDS = inv(Identity(n) / Z - T(F)) * h
claim("BLM91-S3", "the spectral density", TRANSFER * Q * BACKWARDS + TRANSFER * S + T(S) * BACKWARDS + Tm == p + recip(p), sizes=["n"], over=SYSTEM,
      where=[PHI, let(Q, P - F * P * T(F)), let(S, g - F * P * h), let(Tm, 1 - T(h) * P * h)],
      by=[identity(n=(1, 2)), restated("the coefficients of (zI - F)^(-1) at infinity are the powers of F"), instances(n=(1, 2, 3))],
      note="The display defines the density; checked is that for a model (1.1) the sum is the density of the noise between the transfer function and its value at 1/z. The sum is Phi_+(z) + Phi_+(1/z) by (1.6); T_m is the variance of w.")
claim("BLM91-E1.6", "the positive real part", (2 * laurent(p, 0) == 1) & forall(k, 1, m, rows([[laurent(p, k)]]) == Y(k) * G * T(Y(0))), sizes=["n", "m"], over=SYSTEM, where=[*MODEL, PHI],
      by=[steps("BLM91-E2.2", "BLM91-E2.3", prose="(2.2) are the covariances, and the coefficients of Phi_+ at infinity"), instances(n=(1, 2, 3), m=(2, 3))], note="As series: Phi_+(z) + Phi_+(1/z) has the coefficients c_0 = 1 and c_k of z^k and z^(-k).")
claim("BLM91-S4", "positive realness is positive definiteness of all Toeplitz matrices", iff(pos_on_circle(num), forall(t, 0, m, pd(Toep(t)))), sizes=["n", "m"], over={sigma: sequence(0, n)}, where=[*MA, TOEPLITZ],
      by=[example(n=1, m=6, sigma=[1, 1]), instances(n=(1, 2), m=(3, 4))],
      repair=repair("boundary case", WEAK, nonneg_on_circle(num) >> pd(Tm), sizes=["n", "m"], over={a: vector(n), g: vector(n)}, where=[*AB, TOEPLITZ, let(Tm, Toep(m))], given=[given("F stable", schur(F))],
                    by=[steps("BLM91-E2.3", "BLM91-X.20", facts=["c_k are the Fourier coefficients of the spectral density when F is stable"], prose="x'T_t x is the mean of |x(z)|^2 times a nonnegative density that is not zero"),
                        instances(48, n=(1, 2), m=(0, 1, 2, 3, 4), using={x: vector(n)}, made_by={a: x / (1 + SUM)}), example(n=1, m=6, a=[0], g=["1/2"]), example(n=1, m=6, a=[0], g=["-1/2"])]),
      note=MA_NOTE + " Read as an equivalence of three: positive realness, a stochastic system, positive Toeplitz matrices. Between the two latter alone it fails as well: y_t = x_0 has c_k = 1, a stationary model with F = 1, and a singular T_1.")
claim("BLM91-E1.7", "the Toeplitz matrix is the covariance of y_0 .. y_t", matrix_of(i, j, m + 1, m + 1, covariance(output(i - 1), output(j - 1))[1, 1]) == Toep(m), sizes=["n", "m"], over=SYSTEM,
      where=[*STATE, function(cc, [k], when(k == 0, 1, (T(h) * F ** (k - 1) * g)[1, 1])), TOEPLITZ],
      by=[generic_index(*WRITTEN_OUT), instances(n=(1, 2, 3), m=(1, 2, 3))])
kept = sym("positive")
claim("BLM91-S5", "convergence of gain and covariance", RICCATI_CONVERGES[0] & RICCATI_CONVERGES[1] & RICCATI_CONVERGES[2], **STEADY_MODEL, by=RICCATI_CONVERGES_BY,
      note="Positive real data: P solves P = FPF' + (g - FPh)(1 - h'Ph)^(-1)(g - FPh)' with the gain k = (g - FPh)/d and d = 1 - h'Ph > 0, and A = F - kh' is stable; such a P the Schur factor of D gives, P being the sum of d F^j kk'F'^j. "
           "P - Pi_t, between 0 and A^t P A'^t, tends to zero, 1 - h'Pi_t h to d, and the gain to k, the difference being A(P - Pi_t)h/(1 - h'Pi_t h). "
           "P_2 is the covariance of any state, with semidefinite noise covariance: it lies above every Pi_t, hence above their limit P, the P_- of the print.")
DATA_PI = (*CANONICAL, RICCATI, *stripped(g + a, g), *DATA)
claim("BLM91-E1.8a", "1 - h'Pi h is not negative for positive real data", (1 - (T(h) * Pi[m] * h)[1, 1] == r[m]) & kept, sizes=["n", "m"], over={a: vector(n), g: vector(n)}, where=[*DATA_PI, let(kept, r[m] > 0)], given=REAL,
      by=[steps("BLM91-E2.27", "BLM91-E2.28", facts=["Rouche's theorem", "Schwarz's lemma"], prose="1 - h'Pi_t h is r_t, and |gamma_t| < 1 keeps r_t positive"), instances(n=(1, 2, 3), m=(0, 1, 2), **CLASSICAL), *EDGE],
      note="Even > 0; m is the time t.")
R_ = sym("R")
GAIN = (let(Q, P - F * P * T(F)), let(R_, 1 - T(h) * P * h), let(g, F * P * h + S))
claim("BLM91-E1.8b", "where 1 - h'Pi h = 0 the numerator of the gain vanishes", hit >> (flag & (g == stay)), sizes=["n", "m"], over={F: matrix(n, n), h: vector(n), P: positive_semidefinite(n), S: vector(n)},
      where=[*GAIN, RICCATI, let(hit, (T(h) * Pi[m] * h)[1, 1] == 1), let(stay, F * Pi[m] * h), let(flag, psd(P - Pi[m]))], given=[given("white noise", psd(block([[Q, S], [T(S), R_]])))],
      by=[steps("BLM91-S2", facts=["a semidefinite matrix with a zero on the diagonal has a zero row there"], prose="(g - F Pi h, 1 - h'Pi h) is a column of the covariance of (x_(t+1), y_t) minus its prediction"),
          example(n=1, m=1, F=[[1]], h=[1], P=[[1]], S=[0]), example(n=1, m=1, F=[[-1]], h=[1], P=[[1]], S=[0]), example(n=2, m=2, F=[[0, -1], [1, 0]], h=[1, 0], P=[[1, 0], [0, 1]], S=[0, 0]),
          example(n=1, m=1, F=[[2]], h=[1], P=[[1]], S=[-1]),
          instances(6, n=1, m=(0, 1), using={Mk: matrix(n, n), u: vector(n), x: positive()}, made_by={F: Mk / (1 + trace(Mk * T(Mk))), **PSD_MODEL})],
      note="For every stationary model, degenerate ones included; for strictly positive real data 1 - h'Pi_t h is never 0. m is the time t.")
TOP = (*CANONICAL, RICCATI, function(cc, [k], when(k == 0, 1, (T(h) * F ** (k - 1) * g)[1, 1])), TOEPLITZ, let(az, charpoly(F)), let(hit, forall(t, 0, m, 1 - (T(h) * Pi[t] * h)[1, 1] > 0)), let(flag, pd(Toep(m + 1))), let(Tm, det(Toep(m + 1))),
       let(num, az * recip(az) + (charpoly(F - g * T(h)) - az) * recip(az) + recip(charpoly(F - g * T(h)) - az) * az))
AG = {a: vector(n), g: vector(n)}
claim("BLM91-S6", "(1.8) for all t makes Phi_+ positive real", hit >> (schur(az) & pos_on_circle(num)), sizes=["n", "m"], over=AG, where=TOP, by=[example(n=1, m=6, a=[0], g=["1/2"]), instances(n=1, m=(0, 1))],
      repair=repair("boundary case", "F = 0, g = 1/2, h = 1 has Pi_t = t/(2(t + 1)), so that 1 - Pi_t > 0 for all t, but the spectral density is 0 at z = -1; what (1.8) for all t says is that all Toeplitz matrices are positive definite "
                    "(or become singular once and for all), hence that the density is nonnegative",
                    iff(growth, flag) & (far == Tm), sizes=["n", "m"], over=AG, where=[*TOP, let(far, prod(k, 0, m + 1, 1 - (T(h) * Pi[k] * h)[1, 1])), let(growth, forall(t, 0, m + 1, 1 - (T(h) * Pi[t] * h)[1, 1] > 0))],
                    given=[standing("solution exists", defined(Pi[m + 1]))],
                    by=[steps("BLM91-E2.17", "BLM91-E2.13", facts=["Sylvester's law of inertia", "Herglotz: a sequence with positive definite Toeplitz matrices is the Fourier sequence of a nonnegative measure"],
                              prose="1 - h'Pi_t h is r_t, and T_t is congruent to diag(r_0, .., r_t)"),
                        instances(30, n=1, m=(0, 1, 2)), example(n=1, m=3, a=[0], g=["1/2"]), example(n=2, m=1, a=[0, "1/2"], g=["1/4", "1/4"]), example(n=1, m=1, a=[0], g=["2/3"])]),
      note="(1.8) is tested for t <= m; on the counterexample it holds for all t: X.11 with x = -1/2 gives alpha_t = (t + 1)/(t + 2), and Pi_t = 1 - alpha_0/alpha_t = t/(2(t + 1)). Positive real is taken as defined in (2.3), (2.4); were it to mean no more than a nonnegative real part outside the disc, the statement would be right.")
claim("BLM91-E1.9", "the fast algorithm gives the Kalman gain", forall(t, 0, m, fk[t] * (1 - T(h) * Pi[t] * h) == g - F * Pi[t] * h), sizes=["n", "m"], over={F: matrix(n, n), h: vector(n), g: vector(n)},
      where=[*FAST, RICCATI, rec(r, t, Identity(1), (1 - (T(h) * fks[t]) ** 2) * r[t])],
      by=[induction(also=[symmetric(Pi[t]), r[t] == 1 - T(h) * Pi[t] * h, F * Pi[t] * T(F) + r[t] * fk[t] * T(fk[t]) == Pi[t] + r[t] * fks[t] * T(fks[t])]), instances(12, n=(1, 2), m=(1, 2))],
      note="(1.9) and (1.4) are run on their own. The induction carries that Pi_(t+1) - Pi_t = r_t k*_t k*_t' and r_t = 1 - h'Pi_t h.")
ESCAPE1 = (let(al0, 2), let(ga0, 1), let(qa, al0 - ga0), rec(pit, t, 0, qa**2 * pit[t] + (ga0 + qa * pit[t]) ** 2 / (1 - pit[t])))
claim("BLM91-S7", "the Riccati equation can escape", (pit[1] == 1) & (ga0 + qa * pit[1] == 2) & ~defined(pit[2]), where=ESCAPE1, by=[evaluation()],
      note="F = -1, h = 1, g = 1: 1 - h'Pi_1 h = 0 and g - F Pi_1 h = 2.")

# ---------------------------------------------------------------------- announced for n = 1
BACK = function(back, [t], (al[t] == al0) & (ga[t] == ga0))
D1 = let(D, 1 + al0**2 - ga0**2 + al0 * (Z + recip(Z)))
claim("BLM91-S8", "excursions, periods, and returns to the classical region",
      forall(t, 1, k, iff(back(t), t == k)) & forall(t, 1, i, iff(pit[t] == -u, t == i)) & (hits >= 1) & flag, over={k: integer(3, 7), i: integer(2, 5), u: integer(2, 3)},
      where=[let(growth, cospi(1, i)), let(stay, 2 * (growth + u) / (1 - u**2)), let(far, 1 + u * stay), rec(pit, t, -u, ((stay**2 - far**2) * pit[t] + far**2) / (1 - pit[t])),
             let(lam, -cospi(2, k)), let(al0, ALPHA_OF), let(ga0, GAMMA_OF), *ORBIT, BACK, rec(alb, t, 2, alb[t] / (1 - gab[t] ** 2)), rec(gab, t, 2, -gab[t] * alb[t] / (1 - gab[t] ** 2)),
             let(hits, sum_of(t, 1, 60, when(abs(alb[t]) > 5, 1, 0))), rec(alc, t, 1, alc[t] / (1 - gac[t] ** 2)), rec(gac, t, 3, -gac[t] * alc[t] / (1 - gac[t] ** 2)), let(flag, abs(alc[1]) + abs(gac[1]) < 1)],
      by=[steps("BLM91-X.1", "BLM91-X.2", facts=["Kronecker: multiples of an irrational part of a full turn are dense on the circle"], prose="the orbit of (2, 2), 1/kappa = 1/4, is dense; every period p >= 3 occurs, for alpha and hence the Riccati equation "
                "every period p >= 2; (1, 3) enters the diamond, where orbits converge"), instances(5), example(k=3, i=2, u=2), example(k=4, i=3, u=2), example(k=6, i=5, u=3)],
      note="Period k for 1/kappa = -cos(2 pi/k), and period i of the Riccati equation (4.7) from -u for 1/kappa = cos(pi/i); an excursion |alpha_t| > 5 from (2, 2) within 60 steps; (1, 3) is in the positive real region after one step.")
LISTED = [example(alpha0="1/2", gamma0="1/2"), example(alpha0=3, gamma0=2), example(alpha0=-1, gamma0=2), example(alpha0=1, gamma0=0), example(alpha0=2, gamma0=2), example(alpha0="1/4", gamma0="1/4"), example(alpha0=1, gamma0=3)]
ROOTS = (D1, let(poly, al0 * Z**2 + (1 + al0**2 - ga0**2) * Z + al0), let(bound, 2 + abs((1 + al0**2 - ga0**2) / al0)), let(definite, nonneg_on_circle(D) | nonneg_on_circle(-D)), let(real, real_roots(poly, -bound, bound) >= 1))
first, small, rests = symbols("first small comes_to_rest")
#: does gamma_t become small: at most 1/100 if D has one sign, at most half of its lower bound on the hyperbola if not
RESTS = (LAMBDA, let(far, 1 - lam**2), let(small, when(far > 0, far / 2, rational("1/100"))), function(first, [t], when(ga[t] ** 2 <= small, t, when(t >= 60, -1, first(t + 1)))), let(rests, first(0) >= 0))
claim("BLM91-S9", "convergence exactly for sign definite D", iff(definite, rests) & iff(real, far <= 0) & (ga[2] ** 2 == (al[2] - lam) ** 2 + far), over={al0: nonzero(), ga0: scalar()}, where=[*ROOTS, *ORBIT, *RESTS],
      by=[steps("BLM91-E3.13", "BLM91-E5.1", "BLM91-X.1", facts=["a quadratic polynomial has real zeros exactly when its discriminant is not negative", "p^(2m) tends to 0 for |p| < 1"],
                prose="along an orbit gamma^2 = (alpha - lambda)^2 + 1 - lambda^2, lambda = 1/kappa: where D changes sign gamma_t^2 >= 1 - lambda^2 > 0 for all t, and nothing converges, since equilibria have gamma = 0; "
                      "where D has one sign every orbit that does not end converges (S39)"), instances(60), *LISTED],
      note="alpha_0 not 0; for alpha_0 = 0 D is constant and the orbit is at (0, 0) after one step. An orbit comes to rest if gamma_t^2 falls below 1/100 or, where D changes sign, below half of 1 - 1/kappa^2, tried for t <= 60; orbits that "
           "end before are left aside. real: z D has real zeros; the identity for gamma^2 is taken at t = 2.")
claim("BLM91-S10", "sign definite is the same as real roots", iff(definite, real) & (poly == Z * D), over={al0: nonzero(), ga0: scalar()}, where=ROOTS,
      by=[steps("BLM91-E3.12", facts=["a quadratic polynomial has real zeros exactly when its discriminant is not negative", "an affine function of cos(theta) has its extremes at cos(theta) = 1 and -1"],
                prose="both say |1 + alpha^2 - gamma^2| >= 2|alpha|"), instances(60), *LISTED])
TENTHS = (let(lam, k2 / 10), let(al0, ALPHA_OF), let(ga0, GAMMA_OF))
RETURNS = (*TENTHS, *ORBIT, BACK, MANY, let(special, (lam == 0) | (4 * lam**2 == 1)), *PROJECTIVE, let(hits, sum_of(t, 1, 60, when(abs(Nt[t]) > 4 * abs(Mt[t]), 1, 0))), let(flag, special | (hits >= 1)),
           let(growth, lam == 0))
claim("BLM91-S11", "periodic or unbounded, by the phase of a root", forall(t, 1, 12, iff(back(t), (2 * lam == 1) & many(3, t) | growth & many(4, t) | (2 * lam == -1) & many(6, t))) & flag, over={k2: integer(-8, 8), u: scalar()}, where=RETURNS,
      by=[steps("BLM91-X.1", "BLM91-X.2", "BLM91-X.6", facts=["Kronecker: multiples of an irrational part of a full turn are dense on the circle", "a rational zero of a monic polynomial with integer coefficients is an integer"],
                prose="the roots of zD are exp(+-i(pi - theta))"),
          instances(30), *(example(K2=k_, u=u_) for k_ in (5, 0, -5) for u_ in (2, -3)), example(K2=3, u=2), example(K2=-8, u=2)],
      note="1/kappa = -8/10, .., 8/10, where the phase is a rational multiple of pi exactly for 1/kappa = 1/2, 0, -1/2; on the others |alpha_t| > 4 within 60 steps. K2 is ten times 1/kappa, u runs through the points.")
GRID = (function(pit, [i, t], when(t == 0, i, ((al0**2 - ga0**2) * pit(i, t - 1) + ga0**2) / (1 - pit(i, t - 1)))), let(hits, sum_of(i, 2, 12, when(defined(pit(i, 3)), 1, 0))),
        *TENTHS, MANY, let(stay, x**2 - 2 * (1 - al0 * lam) * x + ga0**2 == 0), let(flag, lam == 0), let(special, 4 * lam**2 == 1))
claim("BLM91-S12", "few initial values of a scalar Riccati equation escape; the others converge, are periodic, or dense",
      (hits >= 9) & forall(t, 1, 6, iff(pit(x, t) == x, stay | special & many(3, t) | flag & many(2, t))), over={k2: integer(-15, 15), u: scalar(), x: scalar()}, where=GRID, given=[given("alpha_0 not 0", al0 != 0)],
      by=[steps("BLM91-E5.4", "BLM91-X.2", facts=["a countable set has measure zero", "Kronecker: multiples of an irrational part of a full turn are dense on the circle"],
                prose="the map is invertible for alpha_0 not 0, so that one initial value ends at each step; all others converge where D has real roots (S39, in the coordinate alpha = alpha_0/(1 - pi)), and else return or are "
                      "dense by the phase of the roots"),
          instances(40), *(example(K2=k_, u=2, x=x_) for k_ in (5, 0, -5) for x_ in (0, "1/2")), example(K2=10, u="-1/2", x=0), example(K2=0, u=0, x=3)],
      note="alpha_0 not 0: the sentence goes by the roots of D, and for alpha_0 = 0 D is constant (for |gamma_0| not 1 every solution is at gamma_0^2 after one step; for |gamma_0| = 1 D is zero and all end at the pole). "
           "hits: of the initial values 2, .., 12 those for which pi_3 exists, all but at most one for each of pi_2, pi_3. Returns to x within 6 steps: at the zeros x of (4.12), and with the periods 3 and 2. 1/kappa = K2/10, where the phase is a rational multiple of pi for 1/2, 0, -1/2 only; u runs through the points.")
