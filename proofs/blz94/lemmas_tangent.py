# SPDX-License-Identifier: MIT
"""Notation for the tangent spaces of section 5.

`operator` is the matrix of S(a)v = a(z)v(1/z) + a(1/z)v(z) in the coefficients of v and of z^0, ..., z^n. `TANGENT` has the derivatives of d_0, ...,
d_n at (alpha, gamma), as coefficients of z^1 along lines: line e = 1, ..., 2n goes in the direction of the e-th coordinate, alpha_1, ..., alpha_n,
gamma_0, ..., gamma_{n-1}, and has the parameter z; line 0 stays at the point. The level set of the h_i = 2d_i/d_0 has as tangent space the directions
in which the derivative of (d_0, ..., d_n) is a multiple of (d_0, ..., d_n), so its dimension is 2n + 1 less the rank of the matrix M of all
derivatives with (d_0, ..., d_n) as last column.
"""

from __future__ import annotations

from typing import Any

from exactkf.language import Expr, Z, coeff, column, function, hstack, let, matrix_of, rank, recip, rev, rows, sum_of, sym, symbols, vstack, when
from proofs.blz94.notation import HALF, a, alpha0, b, gamma0, i, j, k, n, t

__all__ = ["DIMENSION", "K", "LINES", "M", "PARITY", "TANGENT", "a_", "ab", "b_", "coordinates", "d", "operator", "pairs", "shared"]

e, x, f, q, d, K, M, a_, b_ = symbols("e x f q d K M a_z b_z")


def operator(p: Expr, columns: Expr | int, size: Expr | int = n) -> Expr:
    """Matrix of S(p) on the polynomials with so many coefficients, to the symmetric pseudo-polynomials of degree ``size``."""
    return matrix_of(i, j, size + 1, columns, coeff(p * recip(Z ** (j - 1)) + recip(p) * Z ** (j - 1), i - 1))


#: the point on line e with parameter z, coefficients of phi_t, psi_t, a, b there, and d_i
LINES = (
    function(x, [e, i], when(i <= n, alpha0[i], gamma0[i - n]) + Z * when(e == 0, 0, when(e == i, 1, 0))),
    function(f, [e, t, k], when(k == 0, 1, when(k > t, 0, f(e, t - 1, k) - x(e, n + t) * f(e, t - 1, t - k)))),
    function(q, [e, t, k], when(k == 0, 1, when(k > t, 0, q(e, t - 1, k) + x(e, n + t) * q(e, t - 1, t - k)))),
    function(a, [e, k], f(e, n, k) + sum_of(j, 1, k, x(e, j) * f(e, n - j, k - j))),
    function(b, [e, k], q(e, n, k) + sum_of(j, 1, k, x(e, j) * q(e, n - j, k - j))),
)
#: a(z) and b(z) at the point
ab = (let(a_, sum_of(i, 0, n, coeff(a(0, i), 0) * Z ** (n - i))), let(b_, sum_of(i, 0, n, coeff(b(0, i), 0) * Z ** (n - i))))
TANGENT = (
    *LINES, *ab,
    function(d, [e, i], HALF * sum_of(j, 0, n - i, a(e, j) * b(e, j + i) + a(e, j + i) * b(e, j))),
    let(K, matrix_of(i, j, n + 1, 2 * n, coeff(d(j, i - 1), 1))),
    let(M, hstack(K, column(i, n + 1, coeff(d(0, i - 1), 0)))),
)


def DIMENSION(rank_of_m: Expr) -> Expr:
    """Dimension of the tangent space."""
    return 2 * n + 1 - rank_of_m


def coordinates(p: list, q: list) -> dict:
    """alpha, gamma of a, b with these coefficients after the first, the constants last, by (3.11), (3.6) and (3.12a)."""
    order = len(p)
    c: list = []
    for m in range(order):
        c.append(HALF * (q[m] - p[m]) - sum((p[m - 1 - l] * c[l] for l in range(m)), start=0 * HALF))
    phi: list = [[1]]
    norm: Any = 1
    gammas: list = []
    for m in range(order):
        g = sum((phi[m][l] * c[m - l] for l in range(m + 1)), start=0 * HALF) / norm
        gammas.append(g)
        reverse = phi[m][::-1]
        phi.append([y - g * z for y, z in zip([*phi[m], 0], [0, *reverse], strict=True)])
        norm = norm * (1 - g**2)
    alphas: list = []
    for m in range(1, order + 1):
        known = sum((alphas[l - 1] * phi[order - l][m - l] for l in range(1, m)), start=0 * HALF)
        alphas.append(p[m - 1] - phi[order][m] - known)
    return {alpha0: rows([[y] for y in alphas]), gamma0: rows([[y] for y in gammas])}


parity = sym("parity")
#: 0 for even k, 1 for odd k
PARITY = (function(parity, [k], when(k <= 1, k, parity(k - 2))),)


def shared(*polynomials: Expr, size: Expr | int = n) -> Expr:
    """Degree of the greatest common divisor of polynomials of degree ``size``, one of them monic of that degree.

    Their multiples by 1, ..., z^(size - 1) span the multiples of the divisor among the polynomials of degree less than 2 size.
    """
    return 2 * size - rank(vstack(*(matrix_of(i, j, size, 2 * size, coeff(y * Z ** (i - 1), j - 1)) for y in polynomials)))


def pairs(*polynomials: Expr, printed: bool = False) -> Expr:
    """Number of pairs (s, 1/s) of roots that these monic polynomials of degree n have in common.

    A root of multiplicity m at 1 or -1 gives m pairs as printed, and m/2 rounded up else.
    """
    at = [shared(*polynomials, (Z - s) ** n) for s in (1, -1)]
    more = at if printed else [parity(y) for y in at]
    return HALF * (shared(*polynomials, *(rev(y, n) for y in polynomials)) + more[0] + more[1])
