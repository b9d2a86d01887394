# SPDX-License-Identifier: MIT
"""Lemmas for Theorem 4.3: a step of the algorithm in the coordinates (alpha, gamma), for every n and t.

Let x_l = alpha_{n-l}(t), y_l = alpha_{n-l}(t+1), gamma_l = gamma_l(t), and phi_l^(1), psi_l^(1) the Szego
polynomials of gamma(t+1) = (gamma_1, .., gamma_{n-1}, gamma_n). With w_l = gamma_0 y_0 + .. + gamma_l y_l

    w_l = (gamma_0 x_0 r_0 + .. + gamma_l x_l r_l) / r_{l+1},        x_l = y_l - gamma_l w_l,

by induction on l from the entries of A(gamma); the second equation is the inverse of A. By (A-8) a step takes
phi_l^(1) to (pi_{l+1} - z rho_{l+1}) / (z (1 - gamma_0)), and for k + 1 < n the sums of z x_{l+1} phi_l^(1) and of
y_{l+1} phi_{l+1}^(1), l = 0 .. k, differ by w_{k+1} phi_{k+1}^(1)* - gamma_0 y_0: the difference of two such sums is

    z x_{k+1} phi_k^(1) - y_{k+1} phi_{k+1}^(1) = gamma_{k+1} (y_{k+1} phi_k^(1)* - w_{k+1} z phi_k^(1)).

At k = n - 2 the left sum is (1 - gamma_0)^(-1) times (a + g - zg), without its first and its last term, and the right one
a(t+1), so that w_{n-1} = -gamma_n and x_0 = (1 - gamma_0^2) y_0 give a(t+1) = (a + (1-z)g)/(1 - gamma_0). The same
with psi, -gamma and b.

They are numbered as they stand in `ONE_STEP`. The bound k <= u <= n - 1 says that entries of gamma(t+1) are entries of gamma(t).
"""

from __future__ import annotations

from exactkf.evidence import lemma, use
from exactkf.language import Expr, Z, always, coeff, forall, prod, sum_of, symbols
from proofs.blz94.notation import HALF, D, a, a_of, alpha, apoly, b_of, bpoly, g, gamma, i, j, k, n, phi, phis, pi, psi, psis, r, rho, t, u

__all__ = ["ALONG", "COORDINATES", "FOUR_ALPHA", "INVARIANT", "LOWEST", "LOWEST_PHI", "LOWEST_PI", "NEXT", "ONE_STEP", "TOP", "TO_NEXT", "row"]

row, z = symbols("row z")
#: the exponents of all four are known, and alpha(t + 1) is opened where a use says so
FOUR_ALPHA = {"supported": [phi, phis, psi, psis], "whole": [alpha]}


def _g(index: Expr | int) -> Expr:
    """gamma_index at time t."""
    return gamma[t][index + 1]


def _within(low: Expr, body: Expr) -> Expr:
    return always(t, forall(u, low, n - 1, body))


def _r(high: Expr) -> Expr:
    return prod(j, 0, high, 1 - _g(j) ** 2)


def _w(high: Expr) -> Expr:
    return sum_of(i, 0, high, _g(i) * alpha[t + 1][n - i])


_WEIGHTED = lemma(k, _within(k, _w(k) == 1 / _r(k) * sum_of(i, 0, k, _g(i) * alpha[t][n - i] * _r(i - 1))),
                  uses=[use(0, k=k, t=t, u=u), use(alpha, t + 1, row=n - k - 1)], base=[use(alpha, t + 1, row=n - k)])
_BACK = lemma(k, _within(k, alpha[t][n - k] == alpha[t + 1][n - k] - _g(k) * _w(k)), direct=True,
              uses=[use(0, k=k, t=t, u=u), use(alpha, t + 1, row=n - k)])
_PIS, _RHOS = HALF * (psis(t, k + 1) + phis(t, k + 1)), HALF * (psis(t, k + 1) - phis(t, k + 1))
_SHIFT_PHI = lemma(k, _within(k, (phi(t + 1, k) == 1 / (Z * (1 - _g(0))) * (pi(t, k + 1) - Z * rho(t, k + 1)))
                              & (phis(t + 1, k) == 1 / (Z * (1 - _g(0))) * (Z * _PIS - _RHOS))),
                   bare=True, uses=[use(2, k=k, t=t, u=u, z=x) for x in (z - 1, z)])
_SHIFT_PSI = lemma(k, _within(k, (psi(t + 1, k) == 1 / (Z * (1 + _g(0))) * (pi(t, k + 1) + Z * rho(t, k + 1)))
                              & (psis(t + 1, k) == 1 / (Z * (1 + _g(0))) * (Z * _PIS + _RHOS))),
                   bare=True, uses=[use(3, k=k, t=t, u=u, z=x) for x in (z - 1, z)])


def _sums(number: int, sign: int, p: Expr, ps: Expr) -> dict:
    """The two sums for p = phi (sign 1) or psi (sign -1)."""
    shift = [use(number - 2, k=k, t=t, u=u, z=x) for x in (z - 2, z - 1, z)]
    right = sum_of(i, 0, k, alpha[t + 1][n - 1 - i] * p(t + 1, i + 1)) - sign * _g(0) * alpha[t + 1][n] + sign * _w(k + 1) * ps(t + 1, k + 1)
    return lemma(k, _within(k + 1, sum_of(i, 0, k, alpha[t][n - 1 - i] * (pi(t, i + 1) - sign * Z * rho(t, i + 1))) == (1 - sign * _g(0)) * right),
                 uses=[use(number, k=k, t=t, u=u, z=z, times=1), use(1, k=k + 2, t=t, u=u), *shift],
                 base=[*(use(1, k=x, t=t, u=u) for x in (0, 1)), *shift])


_MONIC = lemma(k, always(t, (coeff(phi(t, k), k) == 1) & (coeff(psi(t, k), k) == 1)), uses=[use(6, k=k, t=t)])
_SECOND = lemma(k, always(t, (coeff(rho(t, k), k - 1) == _g(0)) & (coeff(phis(t, k), k) == -gamma[t][k]) & (coeff(psis(t, k), k) == gamma[t][k])
                          & (coeff(psi(t, k), 0) == -coeff(phi(t, k), 0)) & (coeff(phi(t, k), 0) == -gamma[t][k])
                          & (coeff(phis(t, k), 0) == 1) & (coeff(psis(t, k), 0) == 1)),
                start=1, uses=[use(6, k=k, t=t), use(7, k=k, t=t)])
ONE_STEP = (_WEIGHTED, _BACK, _SHIFT_PHI, _SHIFT_PSI, _sums(4, 1, phi, phis), _sums(5, -1, psi, psis), _MONIC, _SECOND)
_EIGHT = [use(7, k=x, t=t) for x in (k, k + 1)]
#: ninth of a list: the terms with pi_j, j > 0, have no constant coefficient; and those with phi_j have -gamma_{j-1}
LOWEST_PI = lemma(k, always(t, sum_of(i, 1, k, alpha[t][n - i] * coeff(pi(t, i), 0)) == 0), uses=[use(8, k=k, t=t), *_EIGHT])
LOWEST_PHI = lemma(k, always(t, sum_of(i, 1, k, alpha[t][n - i] * (coeff(phi(t, i), 0) + gamma[t][i])) == 0), uses=[use(8, k=k, t=t), *_EIGHT])


def LOWEST(at: Expr | int = t) -> list:
    """Uses of the lemma so numbered, for the last entries of a and g at a time."""
    return [use(8, k=n - 1, t=at), use(7, k=n, t=at)]



def TOP(m: Expr, at: Expr | int = t) -> list:
    """Uses for the coefficient of z^m of phi_n^(1) and psi_n^(1), by phi_n and psi_n."""
    return [*(use(p, at + 1, n, z=m) for p in (phi, psi)), *(use(x, k=n - 1, t=at, u=n - 1, z=m - y) for x in (2, 3) for y in (0, 1))]


def TO_NEXT(m: Expr, at: Expr | int = t) -> list:
    """Uses of `ONE_STEP` for the coefficient of z^m in the step of a(z) and b(z)."""
    return [*(use(7, k=n - x, t=at + x) for x in (0, 1)), use(6, k=n - 1, t=at), *(use(6, k=m - x, t=at) for x in (0, 1)),
            *(use(x, k=n - 2, t=at, u=n - 1, z=m) for x in (4, 5)), *TOP(m, at), use(1, k=0, t=at, u=n - 1)]


def COORDINATES(number: int) -> dict:
    """a(t), g(t) in the coordinates, as the lemma so numbered, after `ONE_STEP`."""
    return lemma(t, forall(i, 1, n, (a[t][i] == a_of[t][i]) & (g[t][i] == HALF * (b_of[t][i] - a_of[t][i]))),
                 uses=[*(use(number, t=t, i=x) for x in (1, i, i + 1)), *TO_NEXT(n - i)])


#: (A-1), as the lemma after `ONE_STEP` and one of those on the lowest coefficients
ALONG = COORDINATES(9)

_SUM, _GAP = HALF * (apoly[t] + bpoly[t]), HALF * (bpoly[t] - apoly[t])
#: after `ONE_STEP`: a step of a(z) and b(z), and what it leaves of D
NEXT = lemma(t, (apoly[t + 1] == 1 / (1 - gamma[t][1]) * (_SUM - Z * _GAP)) & (bpoly[t + 1] == 1 / (1 + gamma[t][1]) * (_SUM + Z * _GAP)),
             direct=True, uses=TO_NEXT(z))
INVARIANT = lemma(t, r[t] * D[t] == D[0], in_values=True, uses=[use(8, t=t), use(9, t=t, times=1)])
