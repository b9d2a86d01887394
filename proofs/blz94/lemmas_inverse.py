# SPDX-License-Identifier: MIT
"""Lemmas for Theorem 4.3: the coordinates found from (a(1), g(1)) are those of the orbit, for every n.

Let C_1, C_2, .. be the correlations (3.10) of gamma(t). As in Lemma 3.3 the coefficients of psi_k are those of phi_k and sums of
C_{j-i} phi_{k,j}; so for the part A_k = alpha_n phi_0 + .. + alpha_{n-k} phi_k of a(z), and B_k with psi,

    (B_k - A_k)/2 has the coefficients  sum of C_{j-i} A_{k,j},  j = i+1 .. k,

by induction on k, which for a(z) = A_{n-1} + phi_n is the system that the coefficients of g/a at infinity solve: they are C_1, .., C_n.
From them (3.6) gives gamma(t) back, polynomial by polynomial, and (3.12a) gives alpha(t), entry by entry.

They are numbered as they stand in `INVERSE_LEMMAS`, after those of `ONE_STEP`. What is found at time 1 has the names
``c1, f1, f1s, r1, gamma1, alpha1``; the bound k <= u <= n says that no more than n of the C_k are coefficients of g/a.

The next coefficient is -(a_1 C_n + .. + a_n C_1). By orthogonality phi_n against it comes to -(alpha_n r_0 gamma_0 + .. + alpha_1 r_{n-1} gamma_{n-1}),
and that is -r_n w_{n-1}: the Schur parameter gamma_n of v is the last entry of gamma(1) (`SCHUR_LEMMAS`).
"""

from __future__ import annotations

from typing import Any

from exactkf.evidence import fact, lemma, use
from exactkf.language import Expr, Z, always, coeff, forall, function, laurent, prod, rec, rev, sum_of, symbols, when
from proofs.blz94.lemmas_orbit import COORDINATES, FOUR_ALPHA, ONE_STEP
from proofs.blz94.notation import (
    HALF,
    a,
    alpha,
    g,
    gamma,
    gamma0,
    i,
    j,
    k,
    m,
    monic_of,
    n,
    phi,
    phis,
    psi,
    psis,
    s,
    strict_of,
    t,
    u,
)

__all__ = ["COORDINATES_1", "INVERSE_LEMMAS", "ON_THE_LAST", "OPENED", "SCHUR_0", "SCHUR_LEMMAS", "alpha1", "cor", "gamma1", "schur"]

cor, pa, pb, l = symbols("correlation a_part b_part l")
c1, f1, f1s, r1, gamma1, alpha1 = symbols("c1 f1 f1s r1 gamma1 alpha1")
c_of, f0, f0s, r0, schur = symbols("c_of f0 f0s r0 schur")


def _r(high: Any, at: Any = t) -> Expr:
    """r_high of gamma(t)."""
    return prod(j, 0, high - 1, 1 - gamma[at][j + 1] ** 2)


#: c, gamma and alpha from (a(1), g(1)) by (3.11), (3.6) and (3.12a); correlations (3.10) of gamma(t), and parts of a(z) and b(z)
COORDINATES_1 = (
    function(c1, [k], laurent(strict_of(g[1]) / monic_of(a[1]), k)),
    rec(f1, k, 1, Z * f1[k] - gamma1(k) * f1s[k]), rec(f1s, k, 1, f1s[k] - gamma1(k) * Z * f1[k]), rec(r1, k, 1, (1 - gamma1(k) ** 2) * r1[k]),
    function(gamma1, [k], 1 / r1[k] * sum_of(j, 0, k, coeff(f1[k], j) * c1(j + 1))),
    function(alpha1, [k], a[1][k] - coeff(f1[n], n - k) - sum_of(j, 1, k - 1, alpha1(j) * coeff(f1[n - j], n - k))),
    function(cor, [t, k], when(k == 0, 1, _r(k - 1) * gamma[t][k] - sum_of(j, 0, k - 2, coeff(phi(t, k - 1), j) * cor(t, j + 1)))),
    function(pa, [t, k], when(k == 0, alpha[t][n], pa(t, k - 1) + alpha[t][n - k] * phi(t, k))),
    function(pb, [t, k], when(k == 0, alpha[t][n], pb(t, k - 1) + alpha[t][n - k] * psi(t, k))),
)
#: the Schur parameters of v, without end
SCHUR_0 = (
    function(c_of, [t, k], laurent(strict_of(g[t]) / monic_of(a[t]), k)),
    rec(f0, k, 1, Z * f0[k] - schur(k) * f0s[k]), rec(f0s, k, 1, f0s[k] - schur(k) * Z * f0[k]), rec(r0, k, 1, (1 - schur(k) ** 2) * r0[k]),
    function(schur, [k], 1 / r0[k] * sum_of(j, 0, k, coeff(f0[k], j) * c_of(0, j + 1))),
)
OPENED = {"supported": [*FOUR_ALPHA["supported"], pa, pb], "whole": [alpha, a, g], "closed": [cor]}

_ORBIT = COORDINATES(8)
_ORBIT["uses"] = [*(use(v, t + 1, row=i) for v in (a, g)), *_ORBIT["uses"]]
_REVERSED = (lemma(k, always(t, phis(t, k) == rev(phi(t, k), k)), rule=True), lemma(k, always(t, psis(t, k) == rev(psi(t, k), k)), rule=True))
_AT = [use(6, k=k, t=t), *(use(11, k=k, t=t, s=x) for x in (s - 1, k - s)), use(cor, t, k + 1)]
_ORTHOGONAL = lemma(k, always(t, forall(s, 0, k, sum_of(j, 0, k, coeff(phi(t, k), j) * cor(t, abs(j - s))) == when(s == k, _r(k), 0))), uses=_AT)
_FROM_PHI = lemma(k, always(t, forall(s, 0, k, coeff(psi(t, k), s) == coeff(phi(t, k), s) + sum_of(j, s + 1, k, 2 * cor(t, j - s) * coeff(phi(t, k), j)))),
                  uses=[*_AT, *(use(12, k=k, t=t, s=x) for x in (s - 1, k - s))])
_PARTS = lemma(k, always(t, forall(s, 0, k, HALF * (coeff(pb(t, k), s) - coeff(pa(t, k), s)) == sum_of(j, s + 1, k, cor(t, j - s) * coeff(pa(t, k), j)))),
               uses=[use(13, k=k, t=t, s=s), *_AT, use(11, k=k, t=t, s=s), *(use(12, k=k, t=t, s=x) for x in (s - 1, k - s, s))])
_AS_SUMS = lemma(k, always(t, forall(s, 0, k, (coeff(pa(t, k), s) == sum_of(l, 0, k, alpha[t][n - l] * coeff(phi(t, l), s)))
                                     & (coeff(pb(t, k), s) == sum_of(l, 0, k, alpha[t][n - l] * coeff(psi(t, l), s))))), uses=[use(14, k=k, t=t, s=s)])
_CONVOLVED = lemma(s, always(t, forall(k, s + 1, n + 1, sum_of(j, 1, s, a[t][j] * cor(t, k - j))
                                       == sum_of(j, 1, s, (coeff(pa(t, n - 1), n - j) + coeff(phi(t, n), n - j)) * cor(t, k - j)))),
                   uses=[use(15, s=s, t=t, k=k), use(8, t=t, i=s + 1), use(14, k=n - 1, t=t, s=n - s - 1)])
_NEXT = -sum_of(j, 1, n, a[t][j] * cor(t, n + 1 - j))  # the coefficient after those that gamma(t) determines
_AT_INFINITY = fact(t, "laurent", forall(k, 0, n + 1, laurent(strict_of(g[t]) / monic_of(a[t]), k) == when(k == 0, 0, when(k <= n, cor(t, k), _NEXT))), n,
                    uses=[use(15, s=k - 1, t=t, k=k), use(8, t=t, i=k), use(12, k=n, t=t, s=n - k), use(13, k=n - 1, t=t, s=n - k),
                          use(14, k=n - 1, t=t, s=n - k), use(6, k=n, t=t)])
_PAIRED = lemma(s, always(m, forall(u, s, n - 1, sum_of(j, 0, s, coeff(phi(1, m), j) * c1(j + 1)) == sum_of(j, 0, s, coeff(phi(1, m), j) * cor(1, j + 1)))),
                uses=[use(17, s=s, m=m, u=u, times=1), use(16, t=1, k=s + 2)], base=[use(16, t=1, k=1)])
_GAMMA = lemma(k, forall(u, k, n, (f1[k] == phi(1, k)) & (f1s[k] == phis(1, k)) & (r1[k] == _r(k, 1))), rule=True,
               uses=[use(17, s=k, m=k, u=n - 1), use(cor, 1, k + 1), use(6, k=k, t=1)])
_ENTRY = [use(8, t=1, i=k), use(6, k=n - k, t=1)]
_ALPHA_SUMS = lemma(k, forall(u, k, n, forall(s, 0, n, sum_of(j, 1, k, alpha1(j) * coeff(phi(1, n - j), s))
                                              == sum_of(j, 1, k, alpha[1][j] * coeff(phi(1, n - j), s)))),
                    uses=[*(use(19, k=k, u=u, s=x) for x in (s, n - k - 1)), use(8, t=1, i=k + 1), use(6, k=n - k - 1, t=1)])
_ALPHA = lemma(k, forall(u, k, n, alpha1(k) == alpha[1][k]), start=1, direct=True, uses=[use(alpha1, k), use(19, k=k - 1, u=u, s=n - k), *_ENTRY])
INVERSE_LEMMAS = (*ONE_STEP, _ORBIT, *_REVERSED, _ORTHOGONAL, _FROM_PHI, _PARTS, _AS_SUMS, _CONVOLVED, _AT_INFINITY, _PAIRED, _GAMMA, _ALPHA_SUMS, _ALPHA)
#: next of a list: the last row of G(alpha(1))
ON_THE_LAST = lemma(k, forall(u, k, n, sum_of(j, 1, k, alpha1(j) * gamma0[n + 1 - j]) == sum_of(j, 1, k, alpha[1][j] * gamma0[n + 1 - j])),
                    uses=[use(21, k=k, u=u, times=1), use(20, k=k + 1, u=u)])

#: next of a list: the Schur parameter gamma_n of v, by the coefficient of g/a after the first n
_WEIGHTED_PARTS = lemma(k, always(t, sum_of(j, 0, k, coeff(pa(t, k), j) * cor(t, j + 1)) == sum_of(l, 0, k, alpha[t][n - l] * gamma[t][l + 1] * _r(l))),
                        uses=[use(21, k=k, t=t), use(cor, t, k + 2), use(6, k=k, t=t)])
_PAIRED_AT = lemma(s, always(t, always(m, forall(u, s, n - 1, sum_of(j, 0, s, coeff(phi(t, m), j) * c_of(t, j + 1))
                                                 == sum_of(j, 0, s, coeff(phi(t, m), j) * cor(t, j + 1))))),
                   uses=[use(22, s=s, t=t, m=m, u=u, times=1), use(16, t=t, k=s + 2)], base=[use(16, t=t, k=1)])
_SCHUR = lemma(k, forall(u, k, n, (f0[k] == phi(0, k)) & (f0s[k] == phis(0, k)) & (r0[k] == _r(k, 0))), rule=True,
               uses=[use(schur, k), use(22, s=k, t=0, m=k, u=n - 1), use(cor, 0, k + 1), use(6, k=k, t=0)])
_FIRST = lemma(k, forall(u, k, n - 1, schur(k) == gamma0[k + 1]), direct=True,
               uses=[use(schur, k), use(22, s=k, t=0, m=k, u=n - 1), use(cor, 0, k + 1), use(6, k=k, t=0)])
_LAST = lemma(t, sum_of(j, 0, n, coeff(phi(t, n), j) * c_of(t, j + 1)) == -_r(n) * sum_of(l, 0, n - 1, gamma[t][l + 1] * alpha[t + 1][n - l]), direct=True,
              uses=[use(0, k=n - 1, t=t, u=n - 1), use(22, s=n - 1, t=t, m=n, u=n - 1), use(16, t=t, k=n + 1), use(6, k=n, t=t),
                    use(15, s=n, t=t, k=n + 1), use(21, k=n - 1, t=t)])
_PRODUCTS = lemma(k, forall(u, k, n, sum_of(i, 1, k, schur(n - i) * alpha1(i)) == sum_of(i, 1, k, gamma0[n - i + 1] * alpha[1][i])),
                  uses=[use(26, k=k, u=u, times=1), use(24, k=n - k - 1, u=n - 1), use(20, k=k + 1, u=u)])
SCHUR_LEMMAS = (*INVERSE_LEMMAS, _WEIGHTED_PARTS, _PAIRED_AT, _SCHUR, _FIRST, _LAST, _PRODUCTS)
