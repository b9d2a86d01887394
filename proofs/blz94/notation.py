# SPDX-License-Identifier: MIT
"""Notation shared by the sections of the paper.

Vectors ``a``, ``b``, ``g`` of length n hold the coefficients of z^(n-1), ..., 1
of the polynomials a(z), b(z) (monic of degree n) and g(z) = (b(z) - a(z))/2.
A bar marks initial values.
A time index comes first: ``a[t]`` is the vector at time t, ``a[t][i]`` its i-th
entry; ``phi(t, k)`` is the Szego polynomial of degree k for the Schur
parameters at time t.
"""

from __future__ import annotations

from exactkf.language import (
    Expr,
    Identity,
    T,
    Z,
    coeff,
    column,
    function,
    let,
    matrix_of,
    prod,
    rational,
    rec,
    recip,
    sum_of,
    sym,
    symbols,
    when,
)

n, t, k, m, s, i, j, u = symbols("n t k m s i j u")
HALF = rational("1/2")

# ---------------------------------------------------------------------- polynomials of vectors
a, b, g, h, F, J, P, r = symbols("a b g h F J P r")
a0, b0, g0 = symbols("abar bbar gbar")
apoly, bpoly, D = symbols("a_z b_z D")


def monic_of(vector: Expr) -> Expr:
    """z^n + v_1 z^(n-1) + ... + v_n."""
    return Z**n + sum_of(i, 1, n, vector[i] * Z ** (n - i))


def strict_of(vector: Expr) -> Expr:
    """v_1 z^(n-1) + ... + v_n."""
    return sum_of(i, 1, n, vector[i] * Z ** (n - i))


def symmetric_part(p: Expr, q: Expr) -> Expr:
    """(p(z) q(1/z) + p(1/z) q(z)) / 2, the pseudo-polynomial (2.13)."""
    return HALF * (p * recip(q) + recip(p) * q)


#: the shift with ones above the diagonal, and the first unit vector
SHIFT = (let(J, matrix_of(i, j, n, n, when(j == i + 1, 1, 0))), let(h, column(i, n, when(i == 1, 1, 0))))
#: the observer form (2.10) of the data a0
OBSERVER = (*SHIFT, let(F, J - a0 * T(h)))
#: the fast algorithm (2.16) from a0, g0
FAST = (
    *SHIFT,
    rec(a, t, a0, 1 / (1 - g[t][1]) * (a[t] + (Identity(n) - J) * g[t])),
    rec(g, t, g0, 1 / (1 - g[t][1] ** 2) * (-g[t][1] * a[t] + (J - g[t][1] * Identity(n)) * g[t])),
)
#: the factor r_t = (1 - g_1(0)^2) ... (1 - g_1(t-1)^2) along the fast algorithm
SCALE = (rec(r, t, 1, (1 - g[t][1] ** 2) * r[t]),)
#: a_t(z), b_t(z) along the fast algorithm
POLYNOMIALS = (function(apoly, [t], monic_of(a[t])), function(bpoly, [t], monic_of(a[t] + 2 * g[t])))
#: the Riccati step (2.2) from P_0 = 0
gain = sym("k")
RICCATI = (
    *OBSERVER,
    rec(P, t, 0 * J, F * P[t] * T(F) + (g0 - F * P[t] * h) / (1 - T(h) * P[t] * h) * T(g0 - F * P[t] * h)),
)

# ---------------------------------------------------------------------- Szego polynomials of one sequence
gamma, alpha, beta, c = symbols("gamma alpha beta c")
phi, phis, psi, psis, rho, pi, pis, rhos = symbols("phi phis psi psis rho pi pis rhos")
Toeplitz = sym("T")

PHI = (rec(phi, t, 1, Z * phi[t] - gamma[t] * phis[t]), rec(phis, t, 1, phis[t] - gamma[t] * Z * phi[t]))
PSI = (rec(psi, t, 1, Z * psi[t] + gamma[t] * psis[t]), rec(psis, t, 1, psis[t] + gamma[t] * Z * psi[t]))
#: half difference (3.16) and half sum (3.18)
RHO = (function(rho, [t], HALF * (psi[t] - phi[t])),)
PI = (function(pi, [t], HALF * (psi[t] + phi[t])),)
#: r_t of (3.7)
NORM = (rec(r, t, 1, (1 - gamma[t] ** 2) * r[t]),)


def co(p: Expr, degree: Expr | int, index: Expr | int) -> Expr:
    """p_{degree, index}: the coefficient of z^(degree - index) of the polynomial p_degree."""
    return coeff(p[degree], degree - index if not (isinstance(index, int) and index == 0) else degree)


#: c_1, c_2, ... from the Schur parameters, (3.10), with c_0 = 1
CORRELATIONS = (
    *PHI, *NORM,
    function(c, [k], when(k == 0, 1, r[k - 1] * gamma[k - 1] - sum_of(j, 0, k - 2, coeff(phi[k - 1], j) * c[j + 1]))),
)
#: the Schur parameters from c_1, c_2, ..., (3.6)
SCHUR = (*PHI, *NORM, function(gamma, [t], 1 / r[t] * sum_of(k, 0, t, coeff(phi[t], k) * c[k + 1])))
#: T_t of (3.2)
TOEPLITZ = (function(Toeplitz, [t], matrix_of(i, j, t + 1, t + 1, when(i == j, 1, c[abs(i - j)]))),)

#: a(z) and b(z) of (3.12)
KIMURA = (*PHI, *PSI, let(a, phi[n] + sum_of(i, 1, n, alpha[i] * phi[n - i])),
          let(b, psi[n] + sum_of(i, 1, n, alpha[i] * psi[n - i])))

# ---------------------------------------------------------------------- Szego polynomials along a trajectory
alpha0, gamma0, A, G = symbols("alphabar gammabar A G")

#: polynomials for the Schur parameters gamma(t), entries gamma_0(t) = gamma[t][1], ...
PHI_T = (
    function(phi, [t, k], when(k == 0, 1, Z * phi(t, k - 1) - gamma[t][k] * phis(t, k - 1))),
    function(phis, [t, k], when(k == 0, 1, phis(t, k - 1) - gamma[t][k] * Z * phi(t, k - 1))),
)
PSI_T = (
    function(psi, [t, k], when(k == 0, 1, Z * psi(t, k - 1) + gamma[t][k] * psis(t, k - 1))),
    function(psis, [t, k], when(k == 0, 1, psis(t, k - 1) + gamma[t][k] * Z * psi(t, k - 1))),
)
RHO_T = (function(rho, [t, k], HALF * (psi(t, k) - phi(t, k))),)
PI_T = (function(pi, [t, k], HALF * (psi(t, k) + phi(t, k))),)


def cot(p: Expr, time: Expr | int, degree: Expr | int, index: Expr | int) -> Expr:
    """Coefficient of z^(degree - index) of p(time, degree)."""
    return coeff(p(time, degree), degree - index)


#: A(gamma(t)) and G(alpha(t)) of (4.5), (4.6), and the algorithm (4.4)
COMPANION = (
    function(A, [t], matrix_of(i, j, n, n, when(i > j, 0, when(
        i == j, 1 / (1 - gamma[t][n - i + 1] ** 2),
        gamma[t][n - i + 1] * gamma[t][n - j + 1] / prod(k, i, j, 1 - gamma[t][n - k + 1] ** 2))))),
    function(G, [t], matrix_of(i, j, n, n, when(i < n, when(j == i + 1, 1, 0), -alpha[t][n - j + 1]))),
)
ORBIT = (*COMPANION, rec(alpha, t, alpha0, A[t] * alpha[t]), rec(gamma, t, gamma0, G[t + 1] * gamma[t]))
#: phi_n(gamma(t)) + Phi_n(gamma(t)) alpha(t), and the same for psi: the vectors of (4.1)
a_of, b_of = symbols("a_F b_F")
VECTORS = (
    *PHI_T, *PSI_T,
    function(a_of, [t], column(i, n, cot(phi, t, n, i) + sum_of(j, 1, i, alpha[t][j] * cot(phi, t, n - j, i - j)))),
    function(b_of, [t], column(i, n, cot(psi, t, n, i) + sum_of(j, 1, i, alpha[t][j] * cot(psi, t, n - j, i - j)))),
)
#: r_t of (4.13), by gamma(t)
SCALE_T = (rec(r, t, 1, (1 - gamma[t][1] ** 2) * r[t]),)
#: a_t(z), b_t(z), and D for them, along the algorithm
FACTORS_T = (function(apoly, [t], monic_of(a_of[t])), function(bpoly, [t], monic_of(b_of[t])))
PRODUCT_T = (function(D, [t], symmetric_part(apoly[t], bpoly[t])),)

# ---------------------------------------------------------------------- shifted parameters
sigma = sym("sigma")
#: Szego polynomials phi(s, t), psi(s, t) of degree t for the parameters gamma_s, gamma_{s+1}, ...
SHIFTED = (
    function(phi, [s, t], when(t == 0, 1, Z * phi(s, t - 1) - gamma[s + t - 1] * phis(s, t - 1))),
    function(phis, [s, t], when(t == 0, 1, phis(s, t - 1) - gamma[s + t - 1] * Z * phi(s, t - 1))),
    function(psi, [s, t], when(t == 0, 1, Z * psi(s, t - 1) + gamma[s + t - 1] * psis(s, t - 1))),
    function(psis, [s, t], when(t == 0, 1, psis(s, t - 1) + gamma[s + t - 1] * Z * psi(s, t - 1))),
    function(pi, [s, t], HALF * (psi(s, t) + phi(s, t))), function(rho, [s, t], HALF * (psi(s, t) - phi(s, t))),
    function(r, [s, t], prod(j, 0, t - 1, 1 - gamma[s + j] ** 2)),
    function(sigma, [s, i, j], HALF * (phi(s, i) * recip(psi(s, j)) + psi(s, i) * recip(phi(s, j)))),
)
#: alpha_i, with alpha_0 = 1; a(z), b(z) of (3.12) and their symmetric part
x = sym("x")
SHIFTED_FACTORS = (
    let(a, phi(0, n) + sum_of(i, 1, n, alpha[i] * phi(0, n - i))), let(b, psi(0, n) + sum_of(i, 1, n, alpha[i] * psi(0, n - i))),
    let(D, symmetric_part(a, b)), function(x, [i], when(i == 0, 1, alpha[i])),
)
