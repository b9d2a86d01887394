# SPDX-License-Identifier: MIT
"""Section 4: the fast algorithm in the coordinates (alpha, gamma), and its invariants.

The map from (alpha, gamma) to the coefficient vectors (a, b) is polynomial. On
the set where gamma_0, ..., gamma_{n-2} have not modulus one it can be undone: the
first n coefficients of b/(2a) at infinity are polynomials in (a, b), they give
gamma, and alpha follows from a by solving a unit triangular system. The image
is the set where T_1, ..., T_{n-1} are nonsingular.

In these coordinates a step of the fast algorithm deletes the first Schur
parameter: (gamma_0, ..., gamma_{n-1}) becomes (gamma_1, ..., gamma_n), with
gamma_n = -alpha_1(1) gamma_{n-1} - ... - alpha_n(1) gamma_0, and alpha is multiplied by an
upper triangular matrix A(gamma) whose inverse has the entries -gamma_{n-i} gamma_{n-j}
above the diagonal and 1 - gamma_{n-i}^2 on it.

The symmetric part D of a(z)b(1/z) is kept up to the factor r_t. Its coefficients
d_0, ..., d_n are polynomials in (alpha, gamma): d_0 is the sum of alpha_i^2 r_{n-i}, and
d_1, ..., d_n follow from a recursion on n in which the coefficients of the
polynomials pi_j = (phi_j + psi_j)/2 appear. These obey
gamma_{t-1} pi_{t+1} = (gamma_{t-1} z + gamma_t) pi_t + gamma_t (gamma_{t-1}^2 - 1) z pi_{t-1}.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import evaluation, example, generic_index, identity, induction, instances, lemma, restated, steps, use
from exactkf.language import (
    T,
    Z,
    Zero,
    always,
    bottom,
    coeff,
    column,
    det,
    exists,
    forall,
    function,
    given,
    hstack,
    iff,
    integer,
    laurent,
    let,
    matrix,
    matrix_of,
    monic,
    prod,
    rank,
    rec,
    recip,
    scalar,
    sequence,
    size_of,
    standing,
    substitute,
    sum_of,
    sym,
    symbols,
    vector,
    vstack,
    when,
)
from proofs.blz94.lemmas import REVERSED, REVERSED_PSI
from proofs.blz94.lemmas_deletion import AT_START, AT_TIME, DELETION, OPENED_AT_BOTH, OPENED_AT_START, QUOTIENTS, e_of, later, schur
from proofs.blz94.lemmas_double_sum import ABOVE, CONSTANT, DOUBLE_SUM, OPENED_FOR_RECURSION, OPENED_FOR_SUMS, OTHERS, RECURSION, d
from proofs.blz94.lemmas_gain import FIRST, GAIN, OPENED_FOR_GAIN, RICCATI_FROM_ZERO, a_first
from proofs.blz94.lemmas_inverse import COORDINATES_1, INVERSE_LEMMAS, ON_THE_LAST, OPENED, alpha1, cor, gamma1
from proofs.blz94.lemmas_orbit import FOUR_ALPHA, INVARIANT, NEXT, ONE_STEP, row
from proofs.blz94.lemmas_schur import CONCLUDED as AGAIN_CONCLUDED
from proofs.blz94.lemmas_schur import FIRST as FIRST_COEFFICIENTS
from proofs.blz94.lemmas_schur import again_lemmas, first
from proofs.blz94.lemmas_shift import OPENED_FOR_SHIFT, SHIFT_LEMMAS
from proofs.blz94.lemmas_sigma import FORMS
from proofs.blz94.lemmas_update import ALPHA_NEXT, CONCLUDED, OPENED_FOR_UPDATE, PARTS, UPDATE, alpha_next
from proofs.blz94.notation import (
    FACTORS_T,
    FAST,
    HALF,
    KIMURA,
    NORM,
    ORBIT,
    PHI,
    PI,
    PI_T,
    PRODUCT_T,
    PSI,
    RHO_T,
    SCALE_T,
    SHIFTED,
    SHIFTED_FACTORS,
    VECTORS,
    A,
    D,
    F,
    P,
    Toeplitz,
    a,
    a0,
    a_of,
    alpha,
    alpha0,
    apoly,
    b,
    b_of,
    bpoly,
    c,
    cot,
    g,
    g0,
    gamma,
    gamma0,
    h,
    i,
    j,
    k,
    m,
    monic_of,
    n,
    phi,
    phis,
    pi,
    psi,
    r,
    rhos,
    s,
    symmetric_part,
    t,
    u,
)

v, w, ws, x, y, q, l, eta, xi, G1 = symbols("v w ws x y q l eta xi G1")
Phi, Psi, Pi, T_line = symbols("Phi Psi Pi T_line")
TOEPLITZ = (function(Toeplitz, [t], matrix_of(i, j, t + 1, t + 1, when(i == j, 1, c[abs(i - j)]))),)
POINT = {alpha: sequence(1, n), gamma: sequence(0, n - 1)}
VECTOR_POINT = {alpha0: vector(n), gamma0: vector(n)}

# ---------------------------------------------------------------------- the change of coordinates
claim("BLZ94-D4.U", "the map takes U_gamma, and nothing else, into V_c",
      iff(prod(k, 0, n - 2, 1 - gamma[k] ** 2) != 0, prod(k, 1, n - 1, det(Toeplitz[k])) != 0), sizes=["n"], over=POINT,
      where=[*KIMURA, function(c, [k], laurent(b / (2 * a), k)), *TOEPLITZ],
      by=[steps("BLZ94-P3.1", "BLZ94-L3.3", prose="By Lemma 3.3 the c_k of (a, b) are those of gamma; det T_k is the "
                                                  "product of r_0, ..., r_k."),
          instances(40, n=(2, 3)), example(n=2, alpha=[1, 1], gamma=["1/2", 1]),
          example(n=2, alpha=[1, 1], gamma=[1, "1/2"])],
      note="A definition; what is checked is that the two sets correspond. The display of V_c prints T_t for i = 1, "
           "..., n-1; T_i is meant. gamma_{n-1} may have modulus one.")

claim("BLZ94-S22", "V_c is the complement of the zero set of a polynomial that is not zero",
      forall(k, 1, n, substitute(c[k], 1) == laurent(monic_of(b) / (2 * monic_of(a)), k))
      & forall(i, 1, n - 1, coeff(det(Toeplitz[i]), 0) == 1), sizes=["n"], over={a: vector(n), b: vector(n)},
      where=[function(c, [k], HALF * (Z * b[k] - Z * a[k]) - sum_of(j, 1, k - 1, c[j] * (Z * a[k - j]))), *TOEPLITZ],
      by=[identity(n=range(1, 7), fact="the zero set of a polynomial in one variable that is not zero is finite"), instances(n=(2, 3))],
      note="c_k and det T_i are polynomials in (a, b); here they are followed along the line from (0, 0), at z = 0, "
           "to (a, b), at z = 1. They are polynomials in z, det T_i is one at z = 0, hence not zero at points "
           "arbitrarily near to z = 1.")



def _from_coefficients(p, coefficients):
    """The monic q of degree n for which q/(2p) begins with the given coefficients of 1/z, ..., z^-n."""
    return Z**n + sum_of(k, 1, n, Z ** (n - k) * (coeff(p, n - k) + 2 * sum_of(j, 1, k, coefficients[j] * coeff(p, n - k + j))))


_f, _fs, _q, _c, _again = symbols("f_own f_star_own r_own c_own c_again")


def _correlations(parameters, f, f_star, norm, name):
    """(3.10) for these Schur parameters, under names of their own."""
    return (rec(f, t, 1, Z * f[t] - parameters[t] * f_star[t]), rec(f_star, t, 1, f_star[t] - parameters[t] * Z * f[t]), rec(norm, t, 1, (1 - parameters[t] ** 2) * norm[t]),
            function(name, [k], norm[k - 1] * parameters[k - 1] - sum_of(j, 0, k - 2, coeff(f[k - 1], j) * name[j + 1])))


claim("BLZ94-X.10", "every point of V_c is given by u and Schur parameters",
      (v == _from_coefficients(u, y)) & forall(k, 1, n, _again[k] == c[k]), sizes=["n"], over={u: monic(n), v: monic(n), c: sequence(1, n)},
      where=[function(y, [k], laurent(HALF * v / u, k)), *PHI, *NORM, function(gamma, [t], 1 / r[t] * sum_of(k, 0, t, coeff(phi[t], k) * c[k + 1])),
             *_correlations(gamma, _f, _fs, _q, _again), *FIRST_COEFFICIENTS(u, v)],
      by=[generic_index(*again_lemmas(u, v, c, _again, (_f, _fs, _q), y), supported=[phi, phis], closed=[gamma, _again, y, first], uses=[
          *AGAIN_CONCLUDED, use(_again, k)]), instances(n=(1, 2, 3))],
      note="v comes from u and the first n coefficients c_k of v/(2u), and these come by (3.10) from the Schur parameters (3.6), which exist where T_1, ..., T_{n-1} are nonsingular. "
           "The coefficients called first serve the proof alone.")

#: gamma and alpha recovered from polynomials p, q
f, fs, e, theta, tau, o, aa0 = symbols("f fs e theta tau o betabar")
claim("BLZ94-P4.1", "the map is polynomial, given by (4.1), and a bijection from U_gamma onto V_c with rational "
                    "inverse",
      (column(i, n, coeff(a, n - i)) == column(i, n, coeff(phi[n], n - i)) + Phi * column(i, n, alpha[i]))
      & (column(i, n, coeff(b, n - i)) == column(i, n, coeff(psi[n], n - i)) + Psi * column(i, n, alpha[i]))
      & forall(k, 0, n - 1, eta[k] == gamma[k]) & forall(k, 1, n, xi[k] == alpha[k])
      & (u == f[n] + sum_of(i, 1, n, tau[i] * f[n - i])) & (v == e[n] + sum_of(i, 1, n, tau[i] * e[n - i])),
      sizes=["n"], over={**POINT, u: monic(n), v: monic(n)},
      where=[*KIMURA, let(Phi, matrix_of(i, j, n, n, coeff(phi[n - j], n - i))),
             let(Psi, matrix_of(i, j, n, n, coeff(psi[n - j], n - i))),
             function(c, [k], laurent(b / (2 * a), k)),
             rec(w, t, 1, Z * w[t] - eta[t] * ws[t]), rec(ws, t, 1, ws[t] - eta[t] * Z * w[t]),
             rec(r, t, 1, (1 - eta[t] ** 2) * r[t]),
             function(eta, [t], 1 / r[t] * sum_of(k, 0, t, coeff(w[t], k) * c[k + 1])),
             function(xi, [k], coeff(a, n - k) - coeff(w[n], n - k)
                      - sum_of(j, 1, k - 1, xi[j] * coeff(w[n - j], n - k))),
             rec(f, t, 1, Z * f[t] - theta[t] * fs[t]), rec(fs, t, 1, fs[t] - theta[t] * Z * f[t]),
             rec(q, t, 1, (1 - theta[t] ** 2) * q[t]),
             function(theta, [t], 1 / q[t] * sum_of(k, 0, t, coeff(f[t], k) * laurent(v / (2 * u), k + 1))),
             rec(e, t, 1, Z * e[t] + theta[t] * o[t]), rec(o, t, 1, o[t] + theta[t] * Z * e[t]),
             function(tau, [k], coeff(u, n - k) - coeff(f[n], n - k)
                      - sum_of(j, 1, k - 1, tau[j] * coeff(f[n - j], n - k)))],
      given=[standing("(alpha, gamma) lies in U", prod(k, 0, n - 2, 1 - gamma[k] ** 2) != 0),
             standing("(u, v) lies in V", prod(k, 1, n - 1, det(matrix_of(
                 i, j, k + 1, k + 1, when(i == j, 1, laurent(v / (2 * u), abs(i - j)))))) != 0)],
      by=[identity(using={y: sequence(0, n - 1)}, where=_correlations(y, _f, _fs, _q, _c), given_by={v: _from_coefficients(u, _c)}, covered_by="BLZ94-X.10",
                   n=range(1, 7)), instances(n=(1, 2, 3)),
          restated("Proposition 3.1: det T_k = r_0 ... r_k, so that U_gamma goes to V_c and V_c to U_gamma")],
      note="(alpha, gamma) is recovered as (xi, eta) from its image (a, b); and a pair (u, v) of V_c is the image of "
           "the (tau, theta) found from it. That the first lies in V_c and the second in U_gamma is said where these "
           "sets are defined. gamma_{n-1} = 1 and -1 are allowed.")

# ---------------------------------------------------------------------- the algorithm in the new coordinates
_DELETED = {"over": {a0: vector(n), g0: vector(n)}, "given": [standing("n >= 1", n >= 1)]}
claim("BLZ94-L4.2", "v_s has the Schur parameters of v less the first s",
      always(k, later(k) == schur(s + k)), sizes=["n", "s"], **_DELETED, where=[*FAST, *AT_START, *AT_TIME, *QUOTIENTS],
      by=[generic_index(*DELETION, **OPENED_AT_BOTH, uses=[
          use(later, k), use(schur, s + k), use(5, k=k, l=0), use(4, k=s + k, l=0), use(e_of, s, s + k, 1), use(e_of, 0, s + k, 1)]),
          instances(n=(1, 2, 3), s=(1, 2, 3), horizon=3)],
      note="later(k) are the Schur parameters (3.6) of v_s, schur(k) those of v, at every time s that the algorithm reaches. "
           "The coefficients w and the sums after it serve the proof alone.")

claim("BLZ94-E4.2", "the Schur parameters of v are the first entries of g(t)",
      always(t, schur(t) == g[t][1]), sizes=["n"], **_DELETED, where=[*FAST, *AT_START, *QUOTIENTS],
      by=[generic_index(*DELETION[:5], **OPENED_AT_START, uses=[use(schur, t), use(4, k=t, l=0), use(e_of, 0, t, 1)]), instances(n=(1, 2, 3, 4))],
      note="schur(t) are the Schur parameters (3.6) of v. The coefficients w and the sums after it serve the proof alone.")

_START = (let(a0, a_of[0]), let(g0, HALF * (b_of[0] - a_of[0])))
_FOUND = {"sizes": ["n"], "over": VECTOR_POINT, "given": [standing("n >= 1", n >= 1)]}
_FROM_POINT = (*ORBIT, *VECTORS, *RHO_T, *PI_T, *_START, *FAST, *COORDINATES_1)
claim("BLZ94-T4.3.1", "alpha(t + 1) = A(gamma(t)) alpha(t)", column(i, n, alpha1(i)) == A[0] * alpha0, **_FOUND,
      where=[*_FROM_POINT],
      by=[generic_index(*INVERSE_LEMMAS, **OPENED, uses=[use(20, k=row, u=n), use(alpha, 1, row=row)]), instances(n=(2, 3, 4))],
      note="For an arbitrary point (alpha, gamma) of the orbit: alpha(1), here alpha1, is found from (a(1), g(1)) by (3.11), (3.6) "
           "and (3.12a). The algorithm does not depend on t otherwise. The orbit (4.4) and the sums after it serve the proof alone, but for A_0 = A(gamma).")

claim("BLZ94-T4.3.2", "gamma(t + 1) = G(alpha(t + 1)) gamma(t)",
      column(i, n, gamma1(i - 1)) == G1 * gamma0, **_FOUND,
      where=[*_FROM_POINT, let(G1, matrix_of(i, j, n, n, when(i < n, when(j == i + 1, 1, 0), -alpha1(n - j + 1))))],
      by=[generic_index(*INVERSE_LEMMAS, ON_THE_LAST, **OPENED, uses=[
          use(17, s=row - 1, m=row - 1, u=n - 1), use(cor, 1, row), use(6, k=row - 1, t=1), use(21, k=n, u=n), use(20, k=n, u=n)]),
          instances(n=(2, 3, 4))],
      note="For an arbitrary point of the orbit; gamma(1), here gamma1, and alpha(1) are found from (a(1), g(1)) as before; G1 is G(alpha(1)).")

claim("BLZ94-T4.3.3", "(alpha(t), gamma(t)) are the parameters of v_t, and gamma_k(t) is gamma_{t+k}",
      always(t, (a[t] == a_of[t]) & (g[t] == HALF * (b_of[t] - a_of[t])) & (gamma[t] == column(k, n, schur(t + k - 1)))), **_FOUND,
      where=[*ORBIT, *VECTORS, *RHO_T, *PI_T, *FIRST, *FAST, *AT_START, *QUOTIENTS],
      by=[generic_index(*SHIFT_LEMMAS, **OPENED_FOR_SHIFT, uses=[use(8, t=t, i=row), use(16, k=row - 1, t=t, u=row - 1), use(15, t=t + row - 1)]),
          instances(n=(2, 3, 4), horizon=3)],
      note="Entry k of the vector gamma(t) is gamma_{k-1}(t); schur(k) is gamma_k, the Schur parameter (3.6) of v. That (3.9) determines its parameters is "
           "Proposition 4.1. rho, pi_k, the coefficients w and the sums after it serve the proof alone.")

claim("BLZ94-T4.3.4", "the recursion for the Schur parameters of v",
      schur(m + n) == -sum_of(i, 1, n, alpha_next(i) * schur(m + n - i)), sizes=["n", "m"], **_DELETED,
      where=[*FAST, *AT_START, *ALPHA_NEXT, *QUOTIENTS, *PARTS],
      by=[generic_index(*UPDATE, **OPENED_FOR_UPDATE, uses=CONCLUDED), instances(n=(1, 2, 3), m=(0, 1, 2))],
      note="t is the size m, so that it is arbitrary; schur(k) are the Schur parameters (3.6) of v, and alpha(i), by (3.12a), the coordinates of v_{m+1}, "
           "whose own Schur parameters are later(k). The coefficients w and what comes after them serve the proof alone.")

phi_n, pi_n = symbols("phi_n pi_n")
claim("BLZ94-T4.3.5", "the gain in the new coordinates",
      always(t, (g0 - F * P[t] * h) / (1 - T(h) * P[t] * h) == Pi[t] * alpha[t] + pi_n[t] - Phi * alpha0 - phi_n),
      sizes=["n"], over=VECTOR_POINT, given=[standing("n >= 1", n >= 1)],
      where=[*ORBIT, *VECTORS, *RHO_T, *PI_T, *FIRST, *FAST, *RICCATI_FROM_ZERO,
             let(phi_n, column(i, n, cot(phi, 0, n, i))), let(Phi, matrix_of(i, j, n, n, coeff(phi(0, n - j), n - i))),
             function(pi_n, [t], column(i, n, HALF * (cot(phi, t, n, i) + cot(psi, t, n, i)))),
             function(Pi, [t], matrix_of(i, j, n, n, HALF * (coeff(phi(t, n - j), n - i) + coeff(psi(t, n - j), n - i)))), *SCALE_T],
      by=[generic_index(*GAIN, **OPENED_FOR_GAIN, uses=[use(10, t=t, i=row), use(8, t=t, i=row), use(9, t=t), use(a_first, row)]),
          instances(n=(2, 3, 4), horizon=3)],
      note="The gain on the left is that of the Riccati recursion from P_0 = 0, in the observer form of the vectors (a, g), here x and y, that have the "
           "coordinates (alpha, gamma). The fast algorithm, rho, pi_k and r serve the proof alone.")

# ---------------------------------------------------------------------- the invariants
_r = sym("varrho")
claim("BLZ94-E4.10", "D is d(z) + d(1/z)", D == d + recip(d), sizes=["n"], over={a: monic(n), b: monic(n)},
      where=[let(D, symmetric_part(a, b)), let(d, HALF * coeff(D, 0) + sum_of(i, 1, n, coeff(D, i) * Z**i))],
      by=[generic_index(), instances(n=(1, 2, 3))])

_D = (*KIMURA, let(D, symmetric_part(a, b)))
claim("BLZ94-L4.4.1", "d_0 is a sum of squares times the r_i",
      coeff(D, 0) == sum_of(i, 0, n - 1, _r[i] * alpha[n - i] ** 2) + _r[n], sizes=["n"], over=POINT,
      where=[*SHIFTED, *SHIFTED_FACTORS, rec(_r, t, 1, (1 - gamma[t] ** 2) * _r[t]), *FORMS, *ABOVE],
      by=[generic_index(*DOUBLE_SUM[:8], lemma(t, _r[t] == r(0, t), uses=[use(8, t=t), use(r, 0, t), use(r, 0, t + 1)], base=[use(r, 0, 0)]),
                        lemma(k, sum_of(i, 0, k, _r[i] * alpha[n - i] ** 2) == sum_of(i, 0, k, r(0, i) * alpha[n - i] ** 2), uses=[use(9, k=k, times=1), use(8, t=k + 1)],
                              base=[use(8, t=0)]),
                        **OPENED_FOR_SUMS, uses=[*CONSTANT, use(9, k=n - 1), use(8, t=n)]), instances(n=(1, 2, 3, 4))],
      note="varrho_i is r_i; x, r(s, i), tau, chi and w serve the proof alone.")


def _recursion(polynomials):
    """d(s, i, k) = d_i^(k) for the parameters gamma_s, gamma_{s+1}, ...; pi(s, j) the polynomials for these."""
    return (*polynomials,
            function(d, [s, i, k], when(i == k, alpha[k], (1 - gamma[s] ** 2) * d(s + 1, i, k - 1)
                                        + alpha[k] * sum_of(j, 1, k,
                                                            when(j == k, 1, alpha[k - j]) * coeff(pi(s, j), i)))))


_PRINTED_PI = (function(pi, [s, t], when(t == 0, 1, when(t == 1, Z, (1 + Z) * pi(s, t - 1) + (
    gamma[s + t - 1] * gamma[s + t - 2] - 1) * Z * pi(s, t - 2)))),)
_RIGHT_PI = (function(pi, [s, t], when(t == 0, 1, Z * pi(s, t - 1) + gamma[s + t - 1] * rhos(s, t - 1))),
             function(rhos, [s, t], when(t == 0, 0, rhos(s, t - 1) + gamma[s + t - 1] * Z * pi(s, t - 1))))
claim("BLZ94-L4.4.2", "d_1, ..., d_n by recursion on n, with the polynomials of (4.12)",
      forall(i, 1, n, coeff(D, i) == d(0, i, n)), sizes=["n"], over=POINT, where=[*_D, *_recursion(_PRINTED_PI)],
      by=[example(n=3, alpha=[0, 0, 1], gamma=["1/2", "1/2", 0]), instances(n=(1, 2, 3))],
      note="pi_{j,j-i} is the coefficient of z^i in pi_j, zero for i > j.",
      repair=repair("factor", "The recursion (4.12) does not give the polynomials (phi_j + psi_j)/2 for j >= 3; with "
                              "these the recursion for d_i holds.",
                    forall(i, 1, n, coeff(D, i) == d(0, i, n)), sizes=["n"], over=POINT,
                    where=[*SHIFTED[:4], *SHIFTED[6:], *SHIFTED_FACTORS, *FORMS, *ABOVE, *_recursion(_RIGHT_PI)],
                    by=[generic_index(*RECURSION, **OPENED_FOR_RECURSION, uses=[*OTHERS, use(11, k=n, u=n, i=i), use(r, 0, 0)]), instances(n=(2, 3, 4))]))

claim("BLZ94-E4.12", "three-term recursion for pi_t",
      forall(t, 1, n - 1, pi[t + 1] == (1 + Z) * pi[t] + (gamma[t] * gamma[t - 1] - 1) * Z * pi[t - 1])
        & (pi[0] == 1) & (pi[1] == Z),
      sizes=["n"], over={gamma: sequence(0, n - 1)}, where=[*PHI, *PSI, *PI],
      by=[example(n=3, gamma=["1/2", "1/2", 0]), instances(n=(1, 2, 3))],
      repair=repair("factor", "The ratio of gamma_t to gamma_{t-1} is missing: (4.12) holds for t = 1, and for t >= 2 "
                              "only in special cases.",
                    forall(t, 1, n - 1, gamma[t - 1] * pi[t + 1] == (gamma[t - 1] * Z + gamma[t]) * pi[t]
                           + gamma[t] * (gamma[t - 1] ** 2 - 1) * Z * pi[t - 1]) & (pi[0] == 1) & (pi[1] == Z),
                    sizes=["n"], over={gamma: sequence(0, n - 1)}, where=[*PHI, *PSI, *PI],
                    by=[generic_index(REVERSED, REVERSED_PSI, shift=1), instances(n=(2, 3, 4))]))

claim("BLZ94-S23", "the convention pi_{ji} = 0 for i > j completes the recursion for d_i",
      ((j - i < 0) | (j - i > j)) >> (j - i > j), sizes=["n"], over={i: integer(1, n - 1), j: integer(1, n)},
      by=[example(n=3, i=2, j=1), instances(n=(2, 3))],
      note="The recursion needs pi_{j,l} for l = j - i, where i = 1..n-1 and j = 1..n. Each l that is no index of a "
           "coefficient, 0..j, must be covered by the convention l > j.",
      repair=repair("index", "The indices l = j - i that need a convention are the negative ones: pi_{j,j-i} = 0 for "
                             "i > j.",
                    iff((j - i < 0) | (j - i > j), i > j), sizes=["n"], over={i: integer(1, n - 1), j: integer(1, n)},
                    by=[evaluation(n=range(2, 9)), instances(n=(2, 3, 4))]))

claim("BLZ94-L4.4.3", "at least one of d_0, ..., d_n is not zero",
      exists(i, 0, n, coeff(D, i) != 0), sizes=["n"], over=POINT, where=_D,
      given=[given("gamma_k^2 != 1", forall(k, 0, n - 1, gamma[k] ** 2 != 1))],
      by=[steps("BLZ94-SA8", prose="If d_1, ..., d_n vanish, d_0 = r_n, which does not."), instances(40, n=(1, 2, 3)),
          example(n=2, alpha=[0, "3/4"], gamma=[0, "5/4"]), example(n=2, alpha=[0, 0], gamma=["1/2", "1/2"])])

_ORBIT_D = (*ORBIT, *VECTORS, *RHO_T, *PI_T, *SCALE_T, *FACTORS_T, *PRODUCT_T)
_PROJECTIVE = generic_index(*ONE_STEP, NEXT, INVARIANT, supported=FOUR_ALPHA["supported"], whole=[alpha, D], closed=[apoly, bpoly], uses=[use(9, t=t, z=row - 1)])
claim("BLZ94-E4.13", "r_t d_i is invariant, i = 0, ..., n",
      always(t, column(i, n + 1, r[t] * coeff(D[t], i - 1)) == column(i, n + 1, coeff(D[0], i - 1))), sizes=["n"],
      over=VECTOR_POINT, where=_ORBIT_D, given=[standing("n >= 1", n >= 1)],
      by=[_PROJECTIVE, instances(n=(1, 2, 3), horizon=3)],
      note="For t >= 0; the equation for negative t, where the orbit can be continued backwards, is that of a later "
           "start.")



def _functions(number, at):
    """d_0, d_1, .. at a time."""
    return column(i, number, coeff(D[at], i - 1))


claim("BLZ94-S24", "the n + 1 functions d_0, ..., d_{n-1} are invariant up to a common factor",
      always(t, (size_of(_functions(n, t)) == n + 1) & (column(i, n, r[t] * coeff(D[t], i - 1)) == _functions(n, 0))),
      sizes=["n"], over=VECTOR_POINT, where=_ORBIT_D, by=[example(n=1, alphabar=[1], gammabar=["1/2"]),
                                                          instances(n=(1, 2), horizon=2)],
      note="The first equation counts the functions.",
      repair=repair("index", "The n + 1 functions are d_0, ..., d_n; d_n = alpha_n is left out by the printed range.",
                    always(t, (size_of(_functions(n + 1, t)) == n + 1) & (column(i, n + 1, r[t] * coeff(D[t], i - 1)) == _functions(n + 1, 0))),
                    sizes=["n"], over=VECTOR_POINT, where=_ORBIT_D, given=[standing("n >= 1", n >= 1)],
                    by=[_PROJECTIVE, instances(n=(1, 2, 3), horizon=3)]))

# ---------------------------------------------------------------------- the level sets
V, K, M = symbols("V K M")
#: on line number e through (alpha0, gamma0), with parameter z: the point, coefficients of phi_t, psi_t, a, b, and d_i.
#: Lines 1..n+1 have the columns of V as directions, line n+1+i the i-th unit vector; line 0 stays at the point.
_LINES = (
    function(x, [e, i], when(i <= n, alpha0[i], gamma0[i - n])
             + Z * when(e == 0, 0, when(e <= n + 1, V[i, e], when(e == n + 1 + i, 1, 0)))),
    function(f, [e, t, k], when(k == 0, 1, when(k > t, 0, f(e, t - 1, k) - x(e, n + t) * f(e, t - 1, t - k)))),
    function(q, [e, t, k], when(k == 0, 1, when(k > t, 0, q(e, t - 1, k) + x(e, n + t) * q(e, t - 1, t - k)))),
    function(a, [e, k], f(e, n, k) + sum_of(j, 1, k, x(e, j) * f(e, n - j, k - j))),
    function(b, [e, k], q(e, n, k) + sum_of(j, 1, k, x(e, j) * q(e, n - j, k - j))),
    function(d, [e, i], HALF * sum_of(j, 0, n - i, a(e, j) * b(e, j + i) + a(e, j + i) * b(e, j))),
    let(K, matrix_of(i, j, n + 1, 2 * n, coeff(d(n + 1 + j, i - 1), 1))),
    let(M, hstack(K, column(i, n + 1, coeff(d(0, i - 1), 0)))),
)
_ON = given("the lines lie on the level set", forall(e, 1, n + 1,
                                                     forall(i, 0, n,
                                                            forall(j, 0, i - 1,
                                                                   d(e, i) * d(0, j) == d(e, j) * d(0, i)))))
_POINT_LINES = {**VECTOR_POINT, V: matrix(2 * n, n + 1)}
_BY_LINES = instances(n=(1, 2), using={u: scalar(), v: scalar()}, made_by={
    alpha0: column(i, n, when(i == 1, 1 + gamma0[n], 0)),
    V: matrix_of(i, j, 2 * n, n + 1, when(j < n, when(i == n + j, 1, 0), when(j == n, u, v) * when(i == 1, 1, when(
        i == 2 * n, when(j == n, 1, -1), 0))))})
claim("BLZ94-S25", "the level set is a smooth n-manifold where the Jacobian of T has an n-dimensional kernel",
      rank(V) <= n, sizes=["n"], over=_POINT_LINES, where=_LINES,
      given=[given("n-dimensional kernel", rank(K) == n), _ON, standing("d_0 != 0", d(0, 0) != 0)],
      by=[example(n=1, alphabar=[1], gammabar=[0], V=[[1, 1], [1, -1]]), _BY_LINES],
      note="What is stated is a consequence: straight lines through the point that lie on the level set of D up to a "
           "factor have directions in the tangent space, so no n + 1 of them are independent. For n = 1 the level set "
           "through (1, 0) is the pair of lines (alpha - 1)^2 = gamma^2.",
      repair=repair("missing hypothesis", "The kernel of the Jacobian of the projective map has to have dimension n: "
                                          "the vector T itself must not lie in the image of the Jacobian of T (at "
                                          "alpha = 1, gamma = 0, n = 1 it does).",
                    rank(V) <= n, sizes=["n"], over=_POINT_LINES, where=_LINES,
                    given=[given("the projective map is a submersion", rank(M) == n + 1), _ON,
                           standing("d_0 != 0", d(0, 0) != 0)],
                    by=[_BY_LINES]))

aa, gg, A2, G2, a2, b2 = symbols("beta delta A2 G2 a2 b2")
claim("BLZ94-S26", "if the last alphas vanish, the algorithm is that of smaller dimension",
      always(t, (alpha[t] == vstack(aa[t], Zero(l, 1))) & (gg[t] == bottom(gamma[t], m))
             & (D[t] == prod(i, 1, l, 1 - gamma[t][i] ** 2) * symmetric_part(a2[t], b2[t]))),
      sizes=["m", "l"], over={aa0: vector(m), gamma0: vector(m + l)},
      where=[let(n, m + l), let(alpha0, vstack(aa0, Zero(l, 1))), *ORBIT, *VECTORS,
             function(D, [t], symmetric_part(monic_of(a_of[t]), monic_of(b_of[t]))),
             function(A2, [t], matrix_of(i, j, m, m, when(i > j, 0,
                                                          when(i == j, 1 / (1 - gg[t][m - i + 1] ** 2), gg[t][m - i + 1]
                                                     * gg[t][m - j + 1] / prod(k, i, j, 1 - gg[t][m - k + 1] ** 2))))),
             function(G2, [t], matrix_of(i, j, m, m, when(i < m, when(j == i + 1, 1, 0), -aa[t][m - j + 1]))),
             rec(aa, t, aa0, A2[t] * aa[t]), rec(gg, t, bottom(gamma0, m), G2[t + 1] * gg[t]),
             function(f, [t, k], when(k == 0, 1, Z * f(t, k - 1) - gg[t][k] * fs(t, k - 1))),
             function(fs, [t, k], when(k == 0, 1, fs(t, k - 1) - gg[t][k] * Z * f(t, k - 1))),
             function(e, [t, k], when(k == 0, 1, Z * e(t, k - 1) + gg[t][k] * o(t, k - 1))),
             function(o, [t, k], when(k == 0, 1, o(t, k - 1) + gg[t][k] * Z * e(t, k - 1))),
             function(a2, [t], f(t, m) + sum_of(i, 1, m, aa[t][i] * f(t, m - i))),
             function(b2, [t], e(t, m) + sum_of(i, 1, m, aa[t][i] * e(t, m - i)))],
      by=[induction(m=(1, 2, 3), l=(1, 2, 3)), instances(m=(1, 2), l=(1, 2), horizon=3),
          instances(m=(2,), l=(1,), horizon=3)],
      note="m is the k of the text, l = n - k; (beta, delta) is the orbit of (alpha_1..alpha_k; "
           "gamma_{n-k}..gamma_{n-1}) in dimension k. The last equation reduces the level set.")
