# SPDX-License-Identifier: MIT
"""Section II, (2.1)-(2.13): covariances, positive realness, Szego polynomials, prediction.

A stationary model x_(t+1) = F x_t + v_t, y_t = h'x_t + w_t driven by white
noise forgets its past only through F: multiplying the state equation by an
older output shows that E{x_(k+1) y_j} is F^(k-j) g, and one more
multiplication by h' gives c_k = h'F^(k-1) g. So the covariances are the
coefficients at infinity of the rational function Phi_+.

The Toeplitz matrices of c define an inner product of polynomials,
<z^i, z^j> = c_|i-j|. Orthogonalising 1, z, z^2, ... gives the monic Szego
polynomials; because reversing the coefficients is an isometry of that inner
product, each of them comes from the one before by a two-term recursion with a
single new number, the Schur parameter gamma_t, and r_t = <phi_t, phi_t> obeys
r_(t+1) = (1 - gamma_t^2) r_t. The matrix of coefficients of phi_0 .. phi_t
turns the Toeplitz matrix T_t into diag(r_0, .., r_t); hence T_t > 0 exactly
when |gamma_0|, .., |gamma_(t-1)| < 1.

The same isometry sends z^k to y_k: coefficients of phi_t are the weights of
the best linear prediction of y_t from y_0 .. y_(t-1), and the innovations are
orthogonal with variances r_t.

Positive definiteness of every T_t is weaker than strict positivity of the
spectral density: y_t = (e_t + e_(t-1))/sqrt 2 has c_1 = 1/2, every T_t > 0,
gamma_t = (-1)^t/(t + 2), and a spectral density that vanishes at z = -1.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, fact, generic_index, induction, instances, lemma, restated, steps, use
from exactkf.language import *
from proofs.blm91.lemmas_toeplitz import Toep, by_prediction, by_triangles, cc, predicted, triangular, yhat
from proofs.blm91.notation import *

chi, gz, num, Q, S, R, Mk, b, x, y, p = symbols("chi gz num Q S R M b x y p")
ip, Cof, sigma = symbols("pairing x sigma")

# ---------------------------------------------------------------------- covariances of the model
OWN_NOISE = (P - F * P * T(F), S, R)
MODEL_OVER = {F: matrix(n, n), h: vector(n), P: symmetric_matrix(n), S: vector(n)}
FIRST_COVARIANCE = covariance(state(1), output(0), OWN_NOISE)
claim("BLM91-E2.1", "covariance of the state with older outputs",
      forall(j, 0, m, forall(k, j, m, covariance(state(k + 1), output(j), OWN_NOISE) == F ** (k - j) * FIRST_COVARIANCE)),
      sizes=["n", "m"], over=MODEL_OVER, where=STATE,
      by=[generic_index(*WRITTEN_OUT), instances(n=(1, 2, 3), m=(1, 2, 3))],
      note="x_0 has covariance P, the noise (v_t, w_t) is white with covariance [[Q, S], [S', R]] and independent of x_0; "
           "stationarity is Q = P - F P F', and g is E{x_1 y_0}. X_0 and X_v are the coefficients of x_0 and v_s in x_t; the sums are over all noise up to time m.")

claim("BLM91-E2.2", "covariances of the output",
      forall(j, 0, m, forall(k, 1, m - j, covariance(output(j + k), output(j), OWN_NOISE) == T(h) * F ** (k - 1) * FIRST_COVARIANCE)),
      sizes=["n", "m"], over={**MODEL_OVER, R: scalar()}, where=STATE,
      by=[generic_index(*WRITTEN_OUT), instances(n=(1, 2, 3), m=(1, 2, 3))],
      note="c_k is E{y_(t+k) y_t}, the same for every t; model as for (2.1).")

upto, power = symbols("upto power")
PHI = let(p, rational("1/2") + TRANSFER)
claim("BLM91-E2.3", "Phi_+ has the covariances as its coefficients at infinity",
      always(t, Identity(1) / 2 + T(h) * inv(x * Identity(n) - F) * g == upto[t] + T(h) * inv(x * Identity(n) - F) * power[t]),
      sizes=["n"], over={F: matrix(n, n), h: vector(n), g: vector(n), x: nonzero()},
      where=[rec(power, t, g, 1 / x * (F * power[t])), rec(upto, t, Identity(1) / 2, upto[t] + 1 / x * (T(h) * power[t]))],
      by=[induction(), instances(n=(1, 2, 3))],
      note="The display defines Phi_+; what is checked is that it generates the sequence (2.2): upto is 1/2 + h'g x^(-1) + .. + h'F^(t-1)g x^(-t), power is F^t g x^(-t), and the remainder has order x^(-t-1) at infinity. x is z.")

# chi = det(zI - F), gz/chi = h'(zI - F)^(-1) g, num = chi chi* (Phi_+(z) + Phi_+(1/z))
POPOV = (let(chi, charpoly(F)), let(gz, charpoly(F - g * T(h)) - chi),
         let(num, chi * recip(chi) + gz * recip(chi) + recip(gz) * chi))
not_checked("BLM91-E2.4", "the Popov condition, and positive real functions", "a definition: it fixes notation and asserts nothing", note="It is used in the form of X.20.")
claim("BLM91-X.20", "the Popov condition, cleared of denominators",
      (p + recip(p)) * chi * recip(chi) == num, sizes=["n"],
      over={F: matrix(n, n), h: vector(n), g: vector(n)}, where=[PHI, *POPOV],
      by=[generic_index(RESOLVENT, in_values=True, uses=[use(0, t=0)]), instances(n=(1, 2, 3))],
      note="Not printed. As chi(z)chi(1/z) > 0 on the circle for a stability matrix F, the Popov condition says "
           "that the pseudo-polynomial chi(z)chi(1/z)(Phi_+(z) + Phi_+(1/z)) is positive there.")

u = sym("u")
# a bona fide model: F a contraction (or orthogonal), P a multiple of I, S = Q u, R - S'Q^(-1)S >= 0
PSD_MODEL = {P: 1 / (T(h) * h + T(u) * (Identity(n) - F * T(F)) * u + x) * Identity(n), S: (P - F * P * T(F)) * u}
GAIN = (let(Q, P - F * P * T(F)), let(R, 1 - T(h) * P * h), let(g, F * P * h + S))
claim("BLM91-S13", "covariances of a stationary model make Phi_+ positive real",
      schur(chi) & pos_on_circle(num), sizes=["n"],
      over={F: matrix(n, n), h: vector(n), P: positive_definite(n), S: vector(n)}, where=[*GAIN, *POPOV],
      given=[given("white noise", psd(block([[Q, S], [T(S), R]])))],
      by=[example(n=1, F=[[0]], h=[1], P=[["1/2"]], S=["1/2"]), example(n=1, F=[[1]], h=[1], P=[["1/2"]], S=[0]),
          instances(n=(1, 2))],
      repair=repair("boundary case",
                    "a covariance sequence needs the spectral density only nonnegative, and F may have eigenvalues on the circle "
                    "(c = 1, 1/2, 0, 0, ... comes from a model with F = 0 and has a spectral zero at z = -1; "
                    "white noise plus a constant has F = 1)",
                    nonneg_on_circle(num) & (inside_roots(chi) + circle_roots(chi) == n), sizes=["n"],
                    over={F: matrix(n, n), h: vector(n), P: positive_semidefinite(n), S: vector(n)}, where=[*GAIN, *POPOV],
                    given=[given("white noise", psd(block([[Q, S], [T(S), R]]))),
                           given("state covariance nonsingular", invertible(P))],
                    by=[steps("BLM91-X.20", facts=["a pseudo-polynomial that is a form of a semidefinite matrix is nonnegative on the circle"],
                              prose="Phi_+(z) + Phi_+(1/z) is the noise covariance between (h'(zI - F)^(-1), 1) and its value at 1/z; w*Pw (1 - |lambda|^2) = w*Qw >= 0 for a left eigenvector w"),
                        instances(n=(1, 2, 3), using={Mk: matrix(n, n), u: vector(n), x: positive()},
                                  made_by={F: Mk / (1 + trace(Mk * T(Mk))), **PSD_MODEL}),
                        example(n=1, F=[[1]], h=[1], P=[["1/2"]], S=[0]),
                        example(n=2, F=[[0, -1], [1, 0]], h=[1, 1], P=[["1/3", 0], [0, "1/3"]], S=[0, 0])]),
      note="Covariance sequence is read as: of an output of a stationary model (1.1), with nonsingular state covariance.")

# ---------------------------------------------------------------------- Toeplitz matrices and positive realness
TOEPLITZ = function(Toep, [t], matrix_of(i, j, t + 1, t + 1, cc(abs(i - j))))
FREE = function(cc, [k], when(k == 0, 1, c[k]))
MA = (function(cc, [k], sum_of(j, 0, n - k, sigma[j] * sigma[j + k]) / sum_of(j, 0, n, sigma[j] ** 2)),
      let(num, sum_of(k, -n, n, cc(abs(k)) * Z**k)))
AB = (SHIFT, *CANONICAL, *POPOV, function(cc, [k], when(k == 0, 1, (T(h) * F ** (k - 1) * g)[1, 1])))
Tm, gm = symbols("T_m gamma_m")
SUM = sum_of(i, 1, n, abs(x[i]))

MA_NOTE = ("Read on moving averages y_t = sum sigma_j e_(t-j) with E y_t^2 = 1: there F = J is nilpotent, Phi_+(z) + Phi_+(1/z) is the sum of "
           "c_k z^k over all k, and T_t is positive definite for every t, being a Gram matrix of shifted copies of a nonzero vector; "
           "so the right side holds for t <= m exactly if it holds for all t, and what refutes the formula refutes the print. For the counterexample X.21 "
           "shows it for every t. Of the equivalence the formula is the part for moving averages.")
WEAK = ("positive Toeplitz matrices give only a nonnegative spectral density: c = 1, 1/2, 0, 0, ... has T_t > 0 for every t "
        "and a zero at z = -1; necessary as printed, while T_t > 0 for all t gives no more than >= in the Popov condition")
QF, SQ = symbols("form squares")
claim("BLM91-X.21", "the Toeplitz matrices of a moving average with a zero on the circle are positive definite",
      always(t, 2 * QF[t] == SQ[t] + x[t] ** 2), over={x: signal(0)},
      where=[rec(QF, t, x[0] ** 2, QF[t] + x[t + 1] ** 2 + x[t] * x[t + 1]), rec(SQ, t, x[0] ** 2, SQ[t] + (x[t] + x[t + 1]) ** 2)],
      by=[induction(), restated("a sum of squares of real numbers is zero only if each is"), instances()],
      note="Not printed. form is x'T_t x for x = (x_0, .., x_t) and c = 1, 1/2, 0, 0, ..: twice it is x_0^2 + (x_0 + x_1)^2 + .. + (x_(t-1) + x_t)^2 + x_t^2, "
           "zero only for x = 0. So all T_t are positive definite, and the spectral density 1 + (z + 1/z)/2 vanishes at z = -1.")
claim("BLM91-S14", "positive realness is positive definiteness of all Toeplitz matrices",
      iff(pos_on_circle(num), forall(t, 0, m, pd(Toep(t)))), sizes=["n", "m"], over={sigma: sequence(0, n)}, where=[*MA, TOEPLITZ],
      by=[example(n=1, m=6, sigma=[1, 1]), instances(n=(1, 2), m=(3, 4))],
      repair=repair("boundary case", WEAK, nonneg_on_circle(num) >> pd(Tm), sizes=["n", "m"],
                    over={a: vector(n), g: vector(n)}, where=[*AB, TOEPLITZ, let(Tm, Toep(m))], given=[given("F stable", schur(F))],
                    by=[steps("BLM91-E2.3", "BLM91-X.20", facts=["c_k are the Fourier coefficients of the spectral density when F is stable"],
                              prose="x'T_t x is the mean of |x(z)|^2 times a nonnegative density that is not zero"),
                        instances(48, n=(1, 2), m=(0, 1, 2, 3, 4), using={x: vector(n)}, made_by={a: x / (1 + SUM)}),
                        example(n=1, m=6, a=[0], g=["1/2"]), example(n=1, m=6, a=[0], g=["-1/2"])]),
      note=MA_NOTE)
claim("BLM91-S16", "positive realness is |gamma_t| < 1 for all t",
      iff(pos_on_circle(num), forall(t, 0, m, abs(gam(t)) < 1)), sizes=["n", "m"], over={sigma: sequence(0, n)}, where=[*MA, *szego(cc)],
      by=[example(n=1, m=6, sigma=[1, 1]), instances(n=(1, 2), m=(3, 4))],
      repair=repair("boundary case", WEAK.replace("positive Toeplitz matrices give", "Schur parameters inside (-1, 1) give").replace("T_t > 0 for every t", "gamma_t = (-1)^t/(t+2)"),
                    nonneg_on_circle(num) >> (abs(gm) < 1), sizes=["n", "m"],
                    over={a: vector(n), g: vector(n)}, where=[*AB, *szego(cc), let(gm, gam(m))], given=[given("F stable", schur(F))],
                    by=[steps("BLM91-E2.3", "BLM91-X.20", "BLM91-E2.13", facts=["c_k are the Fourier coefficients of the spectral density when F is stable"],
                              prose="x'T_t x is the mean of |x(z)|^2 times a nonnegative density that is not zero; T_t > 0 for all t makes all r_t positive"),
                        instances(48, n=(1, 2), m=(0, 1, 2, 3, 4), using={x: vector(n)}, made_by={a: x / (1 + SUM)}),
                        example(n=1, m=6, a=[0], g=["1/2"]), example(n=1, m=6, a=[0], g=["-1/2"])]),
      note=MA_NOTE)

# ---------------------------------------------------------------------- Szego polynomials
C = {c: sequence(1, n + 1)}
SZEGO = (FREE, *szego(cc))
PAIRING = function(ip, [t, k], sum_of(j, 0, t, coeff(phi[t], j) * cc(abs(j - k))))  # <phi_t, z^k>
REVERSED, MONIC = lemma(t, phis[t] == rev(phi[t], t), rule=True), lemma(t, coeff(phi[t], t) == 1, uses=[use(1, t=t)])
claim("BLM91-E2.5", "Szego polynomials are monic of degree t",
      forall(t, 0, n, phi[t] == Z**t + sum_of(k, 1, t, coeff(phi[t], t - k) * Z ** (t - k))), sizes=["n"], over=C, where=SZEGO,
      by=[generic_index(REVERSED, MONIC, supported=[phi, phis], uses=[use(1, t=t)]), instances(n=range(1, 6))],
      note="The display fixes names for the coefficients; checked is that the polynomials of (2.6) are of this form.")

ORTHOGONAL_TO_POWERS = lemma(t, forall(k, 0, t, sum_of(j, 0, t, coeff(phi[t], j) * cc(abs(j - k))) == when(k == t, r[t], 0)),
                             uses=[use(1, t=t), use(2, t=t, k=k - 1), use(2, t=t, k=t - k)])
claim("BLM91-E2.6", "the recursions produce the monic orthogonal polynomials",
      forall(t, 0, n, forall(k, 0, t, ip(t, k) == when(k == t, r[t], 0))), sizes=["n"], over=C, where=[*SZEGO, PAIRING],
      by=[generic_index(REVERSED, MONIC, lemma(t, forall(k, 0, t, ip(t, k) == when(k == t, r[t], 0)), uses=[use(1, t=t), use(2, t=t, k=k - 1), use(2, t=t, k=t - k)]),
                        supported=[phi, phis], uses=[use(2, t=t, k=k)]), instances(n=range(1, 6))],
      note="Monic and orthogonal to 1, z, .., z^(t-1) in the form <z^i, z^j> = c_|i-j|, which determines phi_t.")

# phi_t by its normal equations, gamma_t by its constant term, r_t by determinants
tau, rr, row, col = symbols("tau r row column")
SOLVED = (FREE, TOEPLITZ, function(tau, [t], matrix_of(i, j, t, 1, cc(t + 1 - i))),
          function(Cof, [t], inv(Toep(t - 1)) * tau(t)),
          function(phi, [t], when(t == 0, 1, Z**t - sum_of(k, 1, t, Cof(t)[k] * Z ** (k - 1)))),
          function(rr, [t], when(t == 0, 1, det(Toep(t)) / det(Toep(t - 1)))))
# the recursion: its polynomials f_t solve the normal equations, and the Toeplitz determinants are products of its w_t
f, fs, w = symbols("f f_star w")
RECURSION = szego(cc, (f, fs, gam, w))
ORTHOGONAL = [use(1, t=t), use(2, t=t, k=k - 1), use(2, t=t, k=t - k)]
NORMAL = (lemma(t, fs[t] == rev(f[t], t), rule=True), lemma(t, coeff(f[t], t) == 1, uses=[use(1, t=t)]),
          lemma(t, forall(k, 0, t, sum_of(j, 0, t, coeff(f[t], j) * cc(abs(j - k))) == when(k == t, w[t], 0)), uses=ORTHOGONAL),
          fact(t, "det", det(Toep(t)) == prod(k, 0, t, w[k]), matrix_of(i, j, t + 1, t + 1, coeff(f[i - 1], j - 1)),
               uses=[use(1, t=row - 1), use(2, t=row - 1, k=col - 1)]),
          fact(t, "solve", inv(Toep(t - 1)) * tau(t) == matrix_of(i, j, t, 1, -coeff(f[t], i - 1)), start=1, uses=[use(1, t=t), use(2, t=t, k=row - 1)]),
          fact(t, "solve", inv(Toep(0)) == Identity(1)),
          lemma(s, always(t, forall(m, s, t - 1, sum_of(k, 0, s, Cof(t)[k + 1] * cc(k + 1)) == -sum_of(k, 0, s, coeff(f[t], k) * cc(k + 1)))),
                uses=[use(6, s=s, t=t, m=m), use(4, t=t, row=s + 2)], base=[use(4, t=t, row=1)]))
BY_NORMAL = generic_index(*NORMAL, supported=[f, fs], uses=[use(5, t=0, row=1), *(use(3, t=x) for x in (t - 1, t, t + 1)), use(4, t=t + 1, row=1),
                                                            use(6, s=t - 1, t=t, m=t - 1), use(1, t=t)])
claim("BLM91-E2.7", "the Schur parameter in terms of covariances",
      forall(t, 0, n, eq(-coeff(phi(t + 1), 0), 1 / rr(t) * sum_of(k, 0, t, coeff(phi(t), k) * cc(k + 1)), gam(t))), sizes=["n"], over=C,
      where=[*SOLVED, *RECURSION], by=[BY_NORMAL, instances(n=range(0, 5))],
      note="phi_t is found by solving its normal equations and r_t as a quotient of Toeplitz determinants; gamma_t is what (2.6) asks for, -phi_(t+1)(0), "
           "and it is that of the recursion (2.6)-(2.8), here for f_t and w_t. The coefficient phi_(t,t-k) belongs to z^k.")
claim("BLM91-E2.8", "recursion of the squared norms",
      (rr(0) == 1) & forall(t, 0, n, eq(rr(t + 1), (1 - coeff(phi(t + 1), 0) ** 2) * rr(t), w[t + 1])), sizes=["n"], over=C,
      where=[*SOLVED, *RECURSION], by=[BY_NORMAL, instances(n=range(0, 5))],
      note="r_t = det T_t / det T_(t-1) and gamma_t = -phi_(t+1)(0), phi_t from its normal equations; w_t belongs to the recursion (2.6)-(2.8).")

# c -> gamma -> c and gamma -> c -> gamma
psi, psis, delta, rho, again, back = symbols("psi psis delta rho again c_back")
THERE_AND_BACK = (
    FREE, *szego(cc), function(again, [t], gam(t - 1) * r[t - 1] - sum_of(k, 0, t - 2, coeff(phi[t - 1], k) * again(k + 1))))
gg = sym("eta")
BACK_AND_THERE = (
    rec(f, t, 1, Z * f[t] - gg[t] * fs[t]), rec(fs, t, 1, fs[t] - gg[t] * Z * f[t]), rec(w, t, 1, (1 - gg[t] ** 2) * w[t]),
    function(back, [t], gg[t - 1] * w[t - 1] - sum_of(k, 0, t - 2, coeff(f[t - 1], k) * back(k + 1))),
    *szego(back, (psi, psis, delta, rho)))
# all covariances up to one are known at once, as they enter the next one in a sum; the other way round both recursions are the same
RECOVERED = (
    REVERSED, MONIC,
    lemma(s, always(t, sum_of(k, 0, s, coeff(phi[t], k) * again(k + 1)) == sum_of(k, 0, s, coeff(phi[t], k) * cc(k + 1))) & (again(s + 1) == cc(s + 1)),
          uses=[use(again, s + 2), use(gam, s + 1), use(2, s=s, t=t), use(2, s=s, t=s + 1), use(1, t=s + 1)], base=[use(again, 1), use(gam, 0)]),
    lemma(t, fs[t] == rev(f[t], t), rule=True), lemma(t, coeff(f[t], t) == 1, uses=[use(4, t=t)]),
    lemma(t, (psi[t] == f[t]) & (psis[t] == fs[t]) & (rho[t] == w[t]), rule=True, uses=[use(delta, t), use(back, t + 1), use(4, t=t)]))
claim("BLM91-S15", "covariances and Schur parameters determine each other",
      forall(t, 1, n, (again(t) == cc(t)) & (delta(t - 1) == gg[t - 1])), sizes=["n"],
      over={c: sequence(1, n), gg: sequence(0, n - 1)}, where=[*THERE_AND_BACK, *BACK_AND_THERE],
      by=[generic_index(*RECOVERED, supported=[phi, phis, f, fs], closed=[gam, delta, again, back], whole=[r], shift=1,
                        uses=[use(2, s=t - 1), use(delta, t - 1), use(back, t), use(4, t=t - 1)]), instances(n=range(1, 6))],
      note="Both compositions are the identity: c to gamma by (2.7) and back by solving (2.7) for its last covariance, and gamma to c and back.")

Low = sym("R_n")
claim("BLM91-E2.9", "positive definite Toeplitz matrix and Schur parameters",
      forall(t, 0, n, iff(pd(Toep(t)), forall(k, 0, t - 1, abs(gam(k)) < 1))), sizes=["n"], over={c: sequence(1, n)},
      where=[*SZEGO, TOEPLITZ],
      by=[steps("BLM91-E2.8", "BLM91-E2.13", facts=["Sylvester's law of inertia"],
                prose="the unit triangular matrix of coefficients of phi_0 .. phi_t is a congruence of T_t with diag(r_0 .. r_t), and r_0 .. r_t are "
                      "positive exactly when all 1 - gamma_k^2 are, k < t"),
          instances(40, n=range(1, 5)), example(n=3, c=["1/2", "1/3", "1/4"]), example(n=2, c=["1/2", "-1/2"]), example(n=2, c=["1/2", "1"])])

X = sum_of(k, 0, n, x[k] * Z**k)
claim("BLM91-E2.10", "the second recursion is the reversal of the first",
      forall(t, 0, n, phis[t] == rev(phi[t], t))
      & (rev(Z * X - y * rev(X, n), n + 1) == rev(X, n) - y * Z * X) & (rev(rev(X, n) - y * Z * X, n + 1) == Z * X - y * rev(X, n)),
      sizes=["n"], over={**C, x: sequence(0, n), y: scalar()}, where=SZEGO,
      by=[generic_index(REVERSED), instances(n=range(1, 6))],
      note="The two last equations say that either recursion, reversed, is the other one, whatever the polynomial x_0 + .. + x_n z^n.")

# ---------------------------------------------------------------------- prediction; y_0 .. y_t have covariance T_t
Coe = sym("Phi_n")
PREDICT = (*SZEGO, TOEPLITZ, let(tau, matrix_of(i, j, n, 1, cc(n + 1 - i))), let(yhat, matrix_of(i, j, n, 1, -coeff(phi[n], i - 1))))


def err(y):
    """E(y_n - y_1 y_0 - .. - y_n y_(n-1))^2."""
    return 1 - 2 * T(y) * tau + T(y) * Toep(n - 1) * y


BY_NORMAL_EQUATIONS = generic_index(
    REVERSED, MONIC, ORTHOGONAL_TO_POWERS, *predicted(Toep(n - 1), x, 3, flipped=False), *predicted(T(Toep(n - 1)), x, 10, flipped=True),
    supported=[phi, phis], closed=[Toep, yhat], uses=[*by_prediction(3), *by_prediction(10)])
claim("BLM91-E2.11", "the linear least-squares prediction",
      err(x) == err(yhat) + T(x - yhat) * Toep(n - 1) * (x - yhat), sizes=["n"], over={c: sequence(1, n), x: vector(n)}, where=PREDICT,
      given=[standing("n >= 1", n >= 1)], by=[BY_NORMAL_EQUATIONS, instances(n=range(1, 6))],
      note="E(y_n - x_1 y_0 - .. - x_n y_(n-1))^2 is written out; it exceeds the value at the coefficients of (2.11) by a square in the "
           "form of T_(n-1), which is positive definite for a purely nondeterministic process. n is the t of the paper.")
claim("BLM91-E2.12", "the innovation has the coefficients of the Szego polynomial",
      vstack(-(inv(Toep(n - 1)) * tau), 1) == matrix_of(i, j, n + 1, 1, coeff(phi[n], i - 1)), sizes=["n"], over={c: sequence(1, n)}, where=PREDICT,
      given=[standing("n >= 1", n >= 1)],
      by=[generic_index(REVERSED, MONIC, ORTHOGONAL_TO_POWERS, fact(t, "solve", inv(Toep(n - 1)) * tau == matrix_of(i, j, n, 1, -coeff(phi[n], i - 1)),
                                                                    uses=[use(1, t=n), use(2, t=n, k=row - 1)]),
                        supported=[phi, phis], uses=[use(3, t=0, row=row, column=1), use(1, t=n)]), instances(n=range(1, 5))],
      note="Left: coefficients of y_0 .. y_n in y_n minus its projection on y_0 .. y_(n-1), by the normal equations; "
           "right: 1, phi_n1, .. phi_nn in the order of (2.12). The isometry z^k to y_k thus takes phi_n to the innovation.")
BY_CONGRUENCE = generic_index(
    REVERSED, MONIC, ORTHOGONAL_TO_POWERS, *triangular(Toep(n), Coe, 3, flipped=False), *triangular(T(Toep(n)), Coe, 8, flipped=True),
    supported=[phi, phis], closed=[Toep, Coe], uses=[*by_triangles(3, row, col), *by_triangles(8, col, row)])
claim("BLM91-E2.13", "innovations are orthogonal with variances r_t",
      Coe * Toep(n) * T(Coe) == Low, sizes=["n"], over={c: sequence(1, n)},
      where=[*SZEGO, TOEPLITZ, let(Coe, matrix_of(i, j, n + 1, n + 1, coeff(phi[i - 1], j - 1))),
             let(Low, matrix_of(i, j, n + 1, n + 1, when(i == j, r[i - 1], 0)))],
      by=[BY_CONGRUENCE, instances(n=range(1, 6))],
      note="Row t of the first factor holds the coefficients of the innovation at time t over y_0 .. y_n.")
