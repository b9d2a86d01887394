# SPDX-License-Identifier: MIT
"""Appendix: the proofs of Theorem 4.3 and of Lemma 4.4.

For Theorem 4.3 the vectors a(t), g(t) are written in the coordinates
(alpha(t), gamma(t)). Since phi_kk + psi_kk = 0, the last entries give alpha_n = a_n + g_n, and the
last equations of the algorithm then give the recursion for the Schur parameters.
For alpha one compares coefficients in the equation for a(1). The Szego polynomials
for the parameters gamma_1, gamma_2, ... follow from those for gamma_0, gamma_1, ... by
phi_t^(1) = (pi_{t+1} - z rho_{t+1}) / (z (1 - gamma_0)), and both pi_{t+1} and rho_{t+1} are sums
of earlier pi_k, rho_k with weights gamma_t gamma_k. Inserting this gives
alpha_j = gamma_{n-j} (gamma_n + gamma_{n-1} alpha_1(1) + ... ) + alpha_j(1), first for j = 1.

For Lemma 4.4, D is a double sum of sigma_ij, the symmetric parts of phi_i(z)psi_j(1/z),
with weights alpha_{n-i} alpha_{n-j}. For i >= j, sigma_ij is r_j times the polynomial pi_{i-j} for the
parameters gamma_j, gamma_{j+1}, ...; it has no constant term unless i = j. This gives d_0 at
once, and the other d_i by splitting off the terms with alpha_n, the rest being the
same sum in one dimension less, with parameters shifted by one.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, fact, generic_index, instances, lemma, use
from exactkf.language import (
    Z,
    Zero,
    always,
    coeff,
    column,
    eq,
    forall,
    given,
    inv,
    let,
    matrix_of,
    prod,
    rec,
    rev,
    sequence,
    standing,
    sum_of,
    symbols,
    vector,
    when,
)
from proofs.blz94.lemmas import FOUR, REVERSED, REVERSED_PSI, SHIFT_BACK, SHIFTED_MONIC, SHIFTED_SECOND, SHIFTED_SUMS, SUMS, z
from proofs.blz94.lemmas import column as col
from proofs.blz94.lemmas_double_sum import ABOVE, ABOVE_NEXT, DOUBLE_SUM, OPENED_FOR_SUMS, SHIFT
from proofs.blz94.lemmas_inverse import COORDINATES_1, INVERSE_LEMMAS, OPENED, SCHUR_0, SCHUR_LEMMAS, alpha1, schur
from proofs.blz94.lemmas_orbit import (
    ALONG,
    COORDINATES,
    FOUR_ALPHA,
    LOWEST,
    LOWEST_PHI,
    LOWEST_PI,
    ONE_STEP,
    TO_NEXT,
    TOP,
    row,
)
from proofs.blz94.lemmas_sigma import COLUMN, ENDS, FORMS, OPENED_FOR_SIGMA, SIGMA
from proofs.blz94.lemmas_vanishing import EACH, HIGHER, INVERSE, NORM, TOGETHER, VANISHING
from proofs.blz94.notation import (
    FAST,
    HALF,
    ORBIT,
    PHI,
    PI,
    PI_T,
    PSI,
    RHO,
    RHO_T,
    SHIFTED,
    SHIFTED_FACTORS,
    VECTORS,
    A,
    D,
    a,
    a0,
    a_of,
    alpha,
    alpha0,
    b_of,
    co,
    cot,
    g,
    g0,
    gamma,
    gamma0,
    i,
    j,
    k,
    m,
    n,
    phi,
    phis,
    pi,
    psi,
    psis,
    r,
    rho,
    rhos,
    s,
    sigma,
    symmetric_part,
    t,
    x,
)

B, l = symbols("B l")
VECTOR_POINT = {alpha0: vector(n), gamma0: vector(n)}
GAMMA = {gamma: sequence(0, n)}

# ---------------------------------------------------------------------- proof of Theorem 4.3
_START = (let(a0, a_of[0]), let(g0, HALF * (b_of[0] - a_of[0])))
_ALONG = {"sizes": ["n"], "over": VECTOR_POINT, "where": [*ORBIT, *VECTORS, *RHO_T, *PI_T, *_START, *FAST]}
_SOME = [standing("n >= 1", n >= 1)]

claim("BLZ94-EA.1", "a(t), b(t), g(t) in the coordinates (alpha(t), gamma(t))",
      always(t, (a[t] == a_of[t]) & (a[t] + 2 * g[t] == b_of[t]) & (g[t] == HALF * (b_of[t] - a_of[t]))), **_ALONG,
      by=[generic_index(*ONE_STEP, COORDINATES(8), **FOUR_ALPHA, uses=[use(8, t=t, i=row)]), instances(n=(2, 3, 4), horizon=3)])

_LEFT = -sum_of(i, 1, n - 1, gamma[t][n - i] * alpha[t + 1][i]) - gamma[t][n] + alpha[t + 1][n]
_RIGHT = -sum_of(i, 1, n - 1, gamma[t + 1][n - i] * alpha[t + 1][i]) - gamma[t][n] + alpha[t + 1][n]
claim("BLZ94-SA1", "the last equation of (A-1a) at t + 1",
      always(t, (a[t + 1][n] == _LEFT) | (a[t + 1][n] == _RIGHT)), **_ALONG,
      by=[example(n=1, alphabar=[1], gammabar=["1/2"]), instances(n=(1, 2, 3), horizon=2)],
      note="gamma_{t+k} is entry k + 1 of gamma(t). The printed sum begins with gamma_{t+n-1}, gamma_{t+n-2} "
           "alpha_1(t+1) and ends with gamma_{t+1} alpha_{n-1}(t+1), which is not one pattern; it is false with the "
           "pattern of its first and with that of its last terms.",
      repair=repair("index", "The constant coefficient of phi_n at t + 1 is -gamma_{t+n}, that of phi_{n-1} is "
                             "-gamma_{t+n-1}, and so on.",
                    always(t, a[t + 1][n] == -gamma[t + 1][n]
                           - sum_of(i, 1, n - 1, gamma[t + 1][n - i] * alpha[t + 1][i]) + alpha[t + 1][n]),
                    **_ALONG, given=_SOME,
                    by=[generic_index(*ONE_STEP, LOWEST_PHI, ALONG, **FOUR_ALPHA, uses=[
                        use(9, t=t + 1, i=n), *LOWEST(t + 1), use(9, t=t, i=1), use(7, k=n, t=t), use(6, k=n - 1, t=t)]),
                        instances(n=(2, 3, 4), horizon=3)]))

claim("BLZ94-EA.2", "the last entry of a(t + 1)", always(t, a[t + 1][n] == (1 + gamma[t][1]) * alpha[t + 1][n]),
      **_ALONG, given=_SOME,
      by=[generic_index(*ONE_STEP, LOWEST_PI, ALONG, **FOUR_ALPHA,
                        uses=[*(use(9, t=t, i=x) for x in (n, 1)), *LOWEST(), use(6, k=n - 1, t=t), use(1, k=0, t=t, u=n - 1)]),
          instances(n=(2, 3, 4), horizon=3)])

claim("BLZ94-EA.3", "the last coordinate alpha_n", always(t, alpha[t][n] == a[t][n] + g[t][n]), **_ALONG, given=_SOME,
      by=[generic_index(*ONE_STEP, LOWEST_PI, ALONG, **FOUR_ALPHA, uses=[use(9, t=t, i=n), *LOWEST()]), instances(n=(2, 3, 4), horizon=3)])

_FOUND = {"sizes": ["n"], "over": VECTOR_POINT, "given": _SOME}
_FROM_POINT = (*_ALONG["where"], *COORDINATES_1)
_ROW_OF_A = lemma(m, forall(s, 1, n - m, sum_of(k, s, s + m, A[0][s, k] * gamma0[n - k + 1]) == gamma0[n - s + 1] / prod(k, s, s + m, 1 - gamma0[n - k + 1] ** 2)),
                  uses=[use(21, m=m, s=s, times=1)])
_ROW_OF_B = lemma(m, forall(s, 1, n - m, sum_of(j, s, s + m, gamma0[n - j + 1] * alpha1(j)) == sum_of(j, s, s + m, gamma0[n - j + 1] * alpha[1][j])),
                  uses=[use(23, m=m, s=s, times=1), use(20, k=s + m + 1, u=n)], base=[use(20, k=s, u=n)])
claim("BLZ94-EA.5", "the inverse of A(gamma), and alpha = A(gamma)^-1 alpha(1)",
      (inv(A[0]) == B) & (alpha0 == B * column(i, n, alpha1(i))), **_FOUND,
      where=[*_FROM_POINT, let(B, matrix_of(i, j, n, n, when(i > j, 0, when(i == j, 1, 0) - gamma0[n - i + 1] * gamma0[n - j + 1])))],
      by=[generic_index(*INVERSE_LEMMAS, _ROW_OF_A, fact(t, "solve", inv(A[0]) == B, uses=[use(21, m=col - row, s=row, times=-gamma0[n - col + 1])]),
                        _ROW_OF_B, **OPENED, uses=[use(22, t=0, row=row, column=col), use(23, m=n - row, s=row), use(20, k=row, u=n),
                                                   use(1, k=n - row, t=0, u=n - 1)]),
          instances(n=(2, 3, 4))],
      note="alpha(1), here alpha1, is found from (a(1), g(1)) by (3.11), (3.6) and (3.12a); A_0 is A(gamma).")

claim("BLZ94-EA.6", "alpha_j in terms of alpha_1(1), ..., alpha_j(1)",
      forall(j, 1, n, alpha0[j] == schur(n - j) * schur(n) + sum_of(i, 1, j - 1, schur(n - j) * schur(n - i) * alpha1(i)) + alpha1(j)), **_FOUND,
      where=[*_FROM_POINT, *SCHUR_0],
      by=[generic_index(*SCHUR_LEMMAS, supported=OPENED["supported"], whole=OPENED["whole"], closed=[*OPENED["closed"], schur], uses=[
          use(24, k=n - j, u=n - 1), use(schur, n), use(25, t=0), use(26, k=j - 1, u=n), use(20, k=j, u=n), use(1, k=n - j, t=0, u=n - 1)]),
          instances(n=(2, 3, 4))],
      note="schur(k) are the Schur parameters of v, found from (a(0), g(0)) by (3.11) and (3.6), so schur(n) is gamma_n; alpha(1), here alpha1, is found "
           "from (a(1), g(1)) in the same way.")

_SEVEN = {"sizes": ["n"], "over": VECTOR_POINT, "where": [*ORBIT, *VECTORS, *RHO_T, *PI_T]}


def _seven(index):
    return (cot(phi, 1, n, index) + sum_of(i, 1, index - 1, cot(phi, 1, n - i, index - i) * alpha[1][i])
            + alpha[1][index]
            == 1 / (1 - gamma0[1]) * (cot(pi, 0, n, index) - cot(rho, 0, n, index + 1) + sum_of(
                i, 1, index - 1, (cot(pi, 0, n - i, index - i) - cot(rho, 0, n - i, index - i + 1)) * alpha0[i]))
                  + alpha0[index])


claim("BLZ94-EA.7", "the k-th equation of (2.16a), k = 1, ..., n", forall(k, 1, n, _seven(k)), **_SEVEN,
      by=[example(n=1, alphabar=[1], gammabar=["1/2"]), instances(n=(1, 2, 3))],
      note="phi(1, .) are the Szego polynomials for gamma(1), phi(0, .), rho(0, .), pi(0, .) those for gamma; "
           "coefficients beyond the degree are zero.",
      repair=repair("boundary case", "For k = n there is no rho_{0,1} = gamma_0 to turn alpha_n/(1 - gamma_0) into "
                                     "alpha_n: the printed equation holds for k < n, and for k = n the last term is "
                                     "alpha_n/(1 - gamma_0).",
                    forall(k, 1, n - 1, _seven(k))
                    & (cot(phi, 1, n, n) + sum_of(i, 1, n - 1, cot(phi, 1, n - i, n - i) * alpha[1][i]) + alpha[1][n]
                       == alpha0[n] / (1 - gamma0[1])),
                    **_SEVEN, given=_SOME,
                    by=[generic_index(*ONE_STEP, LOWEST_PHI, **FOUR_ALPHA, uses=[
                        use(1, k=n - k, t=0, u=n - 1), use(6, k=n - k, t=1), use(7, k=n - k, t=0), *TO_NEXT(n - k, 0), *LOWEST(1)]),
                        instances(n=(3, 4))]))

_ONE_MORE, _ONE_LESS = 1 + gamma[0], 1 - gamma[0]
_INVERSE = HALF * (1 / (Z * (1 - gamma[0] ** 2)))
claim("BLZ94-SA2", "shift identity for the Szego polynomials, and its inverse",
      forall(t, 0, n, (psi(0, t + 1) == HALF * (_ONE_MORE * (Z + 1) * psi(1, t) + _ONE_LESS * (Z - 1) * phi(1, t)))
             & (phi(0, t + 1) == HALF * (_ONE_MORE * (Z - 1) * psi(1, t) + _ONE_LESS * (Z + 1) * phi(1, t)))
             & (psi(1, t) == _INVERSE * (_ONE_LESS * (1 + Z) * psi(0, t + 1) + _ONE_LESS * (1 - Z) * phi(0, t + 1)))
             & (phi(1, t) == _INVERSE * (_ONE_MORE * (1 - Z) * psi(0, t + 1) + _ONE_MORE * (1 + Z) * phi(0, t + 1)))),
      sizes=["n"], over=GAMMA, where=[*SHIFTED],
      by=[generic_index(SHIFT_BACK, uses=[use(0, t=t, z=x) for x in (z - 1, z)]), instances(n=(1, 2, 3))],
      note="The two matrix equations, row by row. phi(s, t), psi(s, t) have degree t and the parameters gamma_s, gamma_{s+1}, ....")

_SHIFT = {"sizes": ["n"], "over": GAMMA, "where": [*SHIFTED]}
claim("BLZ94-EA.8", "phi_t^(1) from pi_{t+1} and rho_{t+1}",
      forall(t, 0, n, phi(1, t) == 1 / (2 * (1 - gamma[0])) * (pi(0, t + 1) - Z * rho(0, t + 1))), **_SHIFT,
      by=[example(n=1, gamma=["1/2", "1/3"]), instances(n=(1, 2, 3))],
      note="The factor is read as 1/(2(1 - gamma_0)). A printed z in the place of the 2 would make it right.",
      repair=repair("factor", "The factor is 1/(z(1 - gamma_0)): already for t = 0 the bracket is z(1 - gamma_0), and "
                              "phi_0^(1) = 1.",
                    forall(t, 0, n, phi(1, t) == 1 / (Z * (1 - gamma[0])) * (pi(0, t + 1) - Z * rho(0, t + 1))),
                    **_SHIFT,
                    by=[generic_index(SHIFT_BACK, uses=[use(0, t=t, z=z)]), instances(n=(1, 2, 3))]))

_TO = {"sizes": ["n"], "over": {gamma: sequence(0, n - 1)}, "where": [*PHI, *PSI, *RHO, *PI]}
claim("BLZ94-EA.9", "phi_{t+1} and psi_{t+1} as sums over earlier polynomials",
      forall(t, 0, n - 1, (phi[t + 1] == Z * phi[t] + sum_of(k, 0, t - 1, gamma[t] * gamma[k] * Z * phi[k]) - gamma[t])
             & (psi[t + 1] == Z * psi[t] + sum_of(k, 0, t - 1, gamma[t] * gamma[k] * Z * psi[k]) + gamma[t])), **_TO,
      by=[generic_index(SUMS, **FOUR, uses=[use(0, t=t, z=z)]), instances(n=(2, 3, 4))])

claim("BLZ94-EA.11", "pi_{t+1} as a sum over earlier polynomials",
      forall(t, 0, n - 1, pi[t + 1] == Z * (pi[t] + sum_of(k, 0, t - 1, gamma[t] * gamma[k] * pi[k]))), **_TO,
      by=[generic_index(SUMS, **FOUR, uses=[use(0, t=t, z=z)]), instances(n=(2, 3, 4))])

claim("BLZ94-EA.12", "rho_{t+1} as a sum over earlier polynomials",
      forall(t, 0, n - 1, rho[t + 1] == Z * rho[t] + sum_of(k, 1, t - 1, gamma[t] * gamma[k] * Z * rho[k])
             + gamma[t]), **_TO,
      by=[generic_index(SUMS, **FOUR, uses=[use(0, t=t, z=z)]), instances(n=(3, 4))])

claim("BLZ94-SA3", "phi_t^(1) as a sum",
      forall(t, 1, n, phi(1, t) == 1 / (1 - gamma[0]) * (pi(0, t) - Z * rho(0, t) + sum_of(
          k, 1, t - 1, gamma[t] * gamma[k] * (pi(0, k) - Z * rho(0, k)))) - gamma[t]), **_SHIFT,
      by=[generic_index(SHIFT_BACK, SHIFTED_SUMS, **FOUR, uses=[use(0, t=t, z=z), use(1, t=t, z=z), use(1, t=t, z=z + 1)]), instances(n=(2, 3, 4))])

claim("BLZ94-SA4", "the leading coefficient of rho_j", forall(j, 1, n, co(rho, j, 1) == gamma[0]), **_TO,
      by=[generic_index(REVERSED, REVERSED_PSI, lemma(
                  t, (coeff(rho[t], t - 1) == gamma[0]) & (coeff(psi[t], 0) == -coeff(phi[t], 0)) & (coeff(psi[t], t) == 1) & (coeff(phi[t], t) == 1),
                  start=1, uses=[use(2, t=t)]), **FOUR, uses=[use(2, t=j)]), instances(n=(2, 3, 4))])


def _thirteen(high):
    def term(shift):
        return cot(pi, 0, t - shift, k - shift) - cot(rho, 0, t - shift, k - shift + 1)
    return forall(k, 1, high, cot(phi, 1, t, k) == 1 / (1 - gamma[0]) * (
        cot(pi, 0, t, k) - cot(rho, 0, t, k + 1) + sum_of(i, 1, k - 1, gamma[t] * gamma[t - i] * term(i)))
          + gamma[t] * gamma[t - k])


claim("BLZ94-EA.13", "coefficients of phi_t^(1), k = 1, ..., t", forall(t, 1, n, _thirteen(t)), **_SHIFT,
      by=[example(n=1, gamma=["1/2", "1/3"]), instances(n=(1, 2, 3))],
      note="Coefficients beyond the degree are zero. The display gives the range k = 1, ..., n; it is used for t = n, "
           "n - 1, ... with k at most t.",
      repair=repair("boundary case", "For k = t the right side is gamma_t gamma_0, but the coefficient is -gamma_t; "
                                     "the range is k = 1, ..., t - 1.",
                    forall(t, 1, n, _thirteen(t - 1) & (cot(phi, 1, t, t) == -gamma[t])), **_SHIFT,
                    by=[generic_index(SHIFT_BACK, SHIFTED_SUMS, SHIFTED_MONIC, SHIFTED_SECOND, **FOUR, uses=[
                        *(use(m, t=t, z=x) for m in (0, 1) for x in (t - k, t - k + 1, 0, 1)), *(use(m, t=x) for m in (2, 3) for x in (t, t - k, t - k - 1))]), instances(n=(2, 3, 4))]))

_FOURTEEN = ((cot(phi, 1, n, 1) + alpha[1][1] == 1 / (1 - gamma0[1]) * (cot(pi, 0, n, 1) - cot(rho, 0, n, 2))
              + alpha0[1])
             & (cot(phi, 1, n, 1) == 1 / (1 - gamma0[1]) * (cot(pi, 0, n, 1) - cot(rho, 0, n, 2))
                + gamma[1][n] * gamma0[n])
             & (alpha0[1] == alpha[1][1] + gamma[1][n] * gamma0[n]))
claim("BLZ94-EA.14", "the case k = 1", _FOURTEEN, **_SEVEN, by=[example(n=1, alphabar=[1], gammabar=["1/2"]),
                                                                instances(n=(1, 2, 3))],
      note="gamma_n is the last entry of gamma(1).",
      repair=repair("boundary case", "For n = 1 the first two equations fail (there k = 1 = n); the conclusion on "
                                     "alpha_1 holds all the same.",
                    _FOURTEEN, **_SEVEN, given=[given("n > 1", n > 1)],
                    by=[generic_index(*ONE_STEP, **FOUR_ALPHA, uses=[
                        use(1, k=n - 1, t=0, u=n - 1), *(use(x, k=n - 1, t=y) for x in (6, 7) for y in (0, 1)), *TOP(n - 1, 0)]),
                        instances(n=(2, 3, 4)), instances(n=(1, 2))]))

# ---------------------------------------------------------------------- proof of Lemma 4.4
_STARRED = (rec(rhos, t, 0, rhos[t] + gamma[t] * Z * pi[t]),)
_TWO = (forall(t, 0, n - 1, pi[t + 1] == Z * pi[t] + gamma[t] * rev(rho[t], t))
        & forall(t, 0, n - 1, rev(rho[t + 1], t + 1) == rev(rho[t], t) + gamma[t] * Z * pi[t]))
claim("BLZ94-SA5", "the coupled recursion for pi_t and rho_t*, and (4.12)",
      _TWO & forall(t, 1, n - 1, pi[t + 1] == (1 + Z) * pi[t] + (gamma[t] * gamma[t - 1] - 1) * Z * pi[t - 1]), **_TO,
      by=[example(n=3, gamma=["1/2", "1/2", 0]), instances(n=(1, 2, 3))],
      note="The coupled recursion is right; (4.12), which is said to follow from it, does not.",
      repair=repair("factor", "Eliminating rho_t* from the coupled recursion gives a three-term recursion with the "
                             "ratio of gamma_t to gamma_{t-1}, not (4.12).",
                    _TWO & forall(t, 1, n - 1, gamma[t - 1] * pi[t + 1] == (gamma[t - 1] * Z + gamma[t]) * pi[t]
                                  + gamma[t] * (gamma[t - 1] ** 2 - 1) * Z * pi[t - 1]), **_TO,
                    by=[generic_index(REVERSED, REVERSED_PSI, **FOUR, shift=1), instances(n=(3, 4))]))

_STAR = {**_TO, "where": [*_TO["where"], *_STARRED]}
claim("BLZ94-SA6", "rho_t* is z^n rho_t(1/z)", forall(t, 0, n, rhos[t] == rev(rho[t], n)), **_STAR,
      by=[example(n=2, gamma=["1/2", "1/3"]), instances(n=(1, 2, 3))],
      note="rho_t* is the solution of the coupled recursion with rho_0* = 0.",
      repair=repair("index", "The reversed polynomial of rho_t is z^t rho_t(1/z).",
                    forall(t, 0, n, rhos[t] == rev(rho[t], t)), **_STAR,
                    by=[generic_index(lemma(t, rhos[t] == HALF * (psis[t] - phis[t]), uses=[use(0, t=t, z=z)]), REVERSED, REVERSED_PSI, **FOUR,
                                      uses=[use(0, t=t, z=z)]), instances(n=(2, 3, 4))]))

_POINT = {alpha: sequence(1, n), gamma: sequence(0, n - 1)}
_SIGMA = {"sizes": ["n"], "over": _POINT, "where": [*SHIFTED, *SHIFTED_FACTORS]}
claim("BLZ94-EA.15", "D as a double sum", D == sum_of(i, 0, n, sum_of(j, 0, n, x[i] * x[j] * sigma(0, i, j))), **_SIGMA,
      by=[example(n=1, alpha=[2], gamma=["1/2"]), instances(n=(1, 2, 3))],
      note="x_i is alpha_i with alpha_0 = 1; sigma(0, i, j) is sigma_ij.",
      repair=repair("index", "a and b are sums of alpha_i phi_{n-i} and alpha_i psi_{n-i}, so the weight alpha_i "
                             "alpha_j belongs to sigma_{n-i,n-j}.",
                    D == sum_of(i, 0, n, sum_of(j, 0, n, x[i] * x[j] * sigma(0, n - i, n - j))), **_SIGMA,
                    by=[generic_index(in_values=True), instances(n=(1, 2, 3))]))

claim("BLZ94-EA.17", "sigma_{i,i-j} is r_{i-j} times a polynomial in z and gamma_{i-j}, ..., gamma_{i-1}",
      forall(i, 1, n, (sigma(0, i, i) == r(0, i)) & (sigma(0, i, i - 1) == r(0, i - 1) * Z)
             & forall(j, 1, i, (sigma(0, i, i - j) == r(0, i - j) * pi(i - j, j))
                      & (pi(i - j, j) == Z**j + sum_of(k, 1, j - 1, coeff(pi(i - j, j), k) * Z**k)))),
      sizes=["n"], over={gamma: sequence(0, n - 1)}, where=[*SHIFTED, *FORMS],
      by=[generic_index(*SIGMA, COLUMN(3), ENDS, **OPENED_FOR_SIGMA, in_values=[0, 1, 2], uses=[
          use(2, j=i, s=0), use(3, m=1, s=0, j=i - 1), use(3, m=j, s=0, j=i - j), use(4, t=j, s=i - j)]), instances(n=(2, 3, 4))],
      note="pi(s, j), the polynomial pi_j for gamma_s, gamma_{s+1}, ..., is made of gamma_s, ..., gamma_{s+j-1} alone.")

claim("BLZ94-EA.19", "d_0, and the other d_i as sums, with the terms of alpha_n split off",
      (coeff(D, 0) == sum_of(i, 0, n - 1, r(0, i) * alpha[n - i] ** 2) + r(0, n))
      & eq(sum_of(i, 1, n, coeff(D, i) * Z**i), sum_of(i, 0, n - 1,
                                                       sum_of(j, i + 1, n, x[i] * x[j] * sigma(0, n - i, n - j))),
           sum_of(i, 0, n - 2, sum_of(j, i + 1, n - 1, x[i] * x[j] * sigma(0, n - i, n - j)))
             + alpha[n] * sum_of(j, 1, n, x[n - j] * pi(0, j)))
      & forall(j, 0, n, sigma(0, j, 0) == pi(0, j)), **{**_SIGMA, "where": [*_SIGMA["where"], *FORMS, *ABOVE]},
      by=[generic_index(*DOUBLE_SUM, **OPENED_FOR_SUMS, in_values=[1, 2, 3], uses=[
          use(5, k=0, z=0), use(7, k=n, u=n, l=0), use(8, k=0), use(9, k=n, u=n)]), instances(n=(2, 3, 4))],
      note="tau, chi and w serve the proof alone.")

claim("BLZ94-SA7", "raising both indices of sigma shifts the lists of the r and of the gammas by one",
      forall(k, 1, n - 1, forall(l, 0, k - 1, sigma(0, k + 1, l + 1) * r(1, l) == r(0, l + 1) * sigma(1, k, l)))
      & (sum_of(i, 0, n - 2, sum_of(j, i + 1, n - 1, x[i] * x[j] * sigma(0, n - i, n - j)))
         == (1 - gamma[0] ** 2) * sum_of(i, 0, n - 2, sum_of(j, i + 1, n - 1,
                                                             x[i] * x[j] * sigma(1, n - 1 - i, n - 1 - j))))
      & (coeff(symmetric_part(phi(0, 1) + alpha[1], psi(0, 1) + alpha[1]), 1) == alpha[1]),
      **{**_SIGMA, "where": [*_SIGMA["where"], *FORMS, *ABOVE_NEXT]},
      by=[generic_index(*SHIFT, supported=OPENED_FOR_SIGMA["supported"], in_values=[0, 1], uses=[
          use(3, m=k - l, s=0, j=l + 1, times=r(1, l)), use(3, m=k - l, s=1, j=l, times=-r(0, l + 1)), *(use(y, k=n - 1, u=n - 1) for y in (4, 5, 8))]),
          instances(n=(2, 3, 4))],
      note="sigma(1, ., .) and r(1, .) belong to gamma_1, gamma_2, .... The print lists the gammas twice; the first "
           "list is read as the r. In the sum the shift of the r is the factor 1 - gamma_0^2. tau, chi, w and v serve the proof alone.")

_HIGHER = given(HIGHER, column(i, n, coeff(D, i)) == Zero(n, 1))
claim("BLZ94-SA8", "if d_1, ..., d_n vanish, alpha is zero and d_0 = r_n",
      (column(i, n, alpha[i]) == Zero(n, 1)) & (coeff(D, 0) == r(0, n)),
      **{**_SIGMA, "where": [*SHIFTED[:6], INVERSE[0], SHIFTED[-1], *SHIFTED_FACTORS, *FORMS, *ABOVE, *INVERSE[1:]]},
      given=[_HIGHER, given(NORM, forall(k, 0, n - 1, gamma[k] ** 2 != 1))],
      by=[generic_index(*VANISHING, **OPENED_FOR_SUMS, uses=[*EACH, *TOGETHER]),
          instances(n=(1, 2, 3), made_by={alpha: column(i, n, 0)})],
      note="d_0 = r_n is a product of the 1 - gamma_k^2, none of which is zero.")
