# SPDX-License-Identifier: MIT
"""Lemmas for (A-18) and (A-19): the coefficients of D from the double sum (A-15), for every n.

With x_i = alpha_i, x_0 = 1, let w_k be the sum of x_i x_j sigma_{n-i,n-j}, i < j <= k. By induction on k

    (A(z) B(1/z) + A(1/z) B(z)) / 2 = x_0^2 r_n + .. + x_k^2 r_{n-k} + w_k(z) + w_k(1/z)

for the parts A, B of a(z), b(z) with x_0, .., x_k; and w_k has the exponents 1, .., k, as those sigma have.

They are numbered as they stand in `DOUBLE_SUM`, after those on sigma. For the recursion of Lemma 4.4 let d^(k) belong to alpha_1, .., alpha_k and
gamma_{n-k}, .., gamma_{n-1}: by (A-17c) the recursion is that of w_k, and r_{n-k} d_i^(k) is the coefficient of z^i in w_k.
"""

from __future__ import annotations

from exactkf.evidence import lemma, use
from exactkf.language import Expr, Z, always, coeff, forall, function, recip, sum_of, sym, symbols, when
from proofs.blz94.lemmas_sigma import COLUMN, EXPONENTS, OPENED_FOR_SIGMA, SIGMA, chi, tau
from proofs.blz94.notation import D, gamma, i, j, k, n, phi, pi, psi, r, rhos, s, sigma, symmetric_part, t, u, x

__all__ = ["ABOVE", "ABOVE_NEXT", "CONSTANT", "DOUBLE_SUM", "OPENED_FOR_RECURSION", "OPENED_FOR_SUMS", "OTHERS", "RECURSION", "SHIFT", "d", "of_column", "v", "w"]

w, v, d, l = symbols("w v d l")


def of_column(high: Expr, at: Expr, start: int = 0) -> Expr:
    """Sum of x_i sigma_{n-i,n-at}, i = 0 .. high; or of the same in dimension n - 1, for the parameters gamma_1, gamma_2, .."""
    return sum_of(i, 0, high, x[i] * sigma(start, n - start - i, n - start - at))


#: the terms above the diagonal
ABOVE = (function(w, [k], when(k == 0, 0, w(k - 1) + x[k] * of_column(k - 1, k))),)
ABOVE_NEXT = (*ABOVE, function(v, [k], when(k == 0, 0, v(k - 1) + x[k] * of_column(k - 1, k, 1))))


def _part(p: Expr) -> Expr:
    return sum_of(i, 0, k, x[i] * p(0, n - i))


def _up_to(body: Expr) -> Expr:
    return forall(u, k, n, body)


def _split(high: Expr) -> Expr:
    return sum_of(i, 0, high, x[i] ** 2 * r(0, n - i)) + w(high) + recip(w(high))


_PARTS = lemma(k, _up_to(symmetric_part(_part(phi), _part(psi)) == _split(k)), in_values=True,
               uses=[use(4, k=k, u=u, times=1), use(2, j=n - k - 1, s=0, times=x[k + 1] ** 2)], base=[use(2, j=n, s=0, times=1)])
_WHOLE = lemma(k, D == _split(n), direct=True, in_values=True, uses=[use(4, k=n, u=n, times=1)])
_OF_COLUMN = lemma(j, forall(k, 0, n, forall(u, j, k, always(l, (coeff(of_column(j - 1, k), -l) == 0) & (coeff(of_column(j - 1, k), k + 1 + l) == 0)))),
                   uses=[use(6, j=j, k=k, u=u, l=l), *(use(3, m=k - j, s=0, j=n - k, l=x) for x in (l, j + l))])
_OF_ABOVE = lemma(k, _up_to(always(l, (coeff(w(k), -l) == 0) & (coeff(w(k), k + 1 + l) == 0))),
                  uses=[*(use(7, k=k, u=u, l=x) for x in (l, l + 1)), use(6, j=k + 1, k=k + 1, u=k + 1, l=l)])
_Z = sym("z")
_OF_D = lemma(k, sum_of(i, 1, n, coeff(D, i) * Z**i) == w(n), direct=True,
              uses=[use(5, k=k, z=_Z), *(use(7, k=n, u=n, l=x) for x in (-_Z, _Z, _Z - n - 1, -_Z - n - 1))])


def _as_printed(number: int, above: Expr, start: int = 0) -> dict:
    """The double sum, as the lemma so numbered."""
    terms = sum_of(i, 0, k - 1, sum_of(j, i + 1, k, x[i] * x[j] * sigma(start, n - start - i, n - start - j)))
    return lemma(k, forall(u, k, n - start, above(k) == terms), in_values=True, uses=[use(number, k=k, u=u)])


DOUBLE_SUM = (*SIGMA, EXPONENTS, _PARTS, _WHOLE, _OF_COLUMN, _OF_ABOVE, _OF_D, _as_printed(9, w))
#: uses for the coefficient of z^i of D, for i = 0 and for 1 <= i <= n
CONSTANT, OTHERS = [use(5, k=0, z=0), use(7, k=n, u=n, l=0)], [use(5, k=0, z=i), use(7, k=n, u=n, l=i)]
OPENED_FOR_SUMS = {"supported": OPENED_FOR_SIGMA["supported"], "closed": [r], "whole": [sigma, tau, chi, D]}

_TOP = lemma(t, always(s, coeff(pi(s, t), t) == 1), uses=[use(9, t=t, s=s)])
_BY_PI = lemma(j, forall(k, 1, n, forall(u, j, k, of_column(j - 1, k) == r(0, n - k) * sum_of(i, 0, j - 1, x[i] * pi(n - k, k - i)))), in_values=True,
               closed=[sigma], uses=[use(10, j=j, k=k, u=u), use(8, m=k - j, s=0, j=n - k)])
_BY_RECURSION = lemma(k, _up_to(forall(i, 1, k, r(0, n - k) * d(n - k, i, k) == coeff(w(k), i))),
                      uses=[use(11, k=k, u=u, i=i), use(r, 0, n - k), use(r, 0, n - k - 1), use(10, j=k + 1, k=k + 1, u=k + 1, z=i), use(7, k=k, u=u, l=0),
                            use(9, t=k + 1, s=n - k - 1)])
#: for d(s, i, k), the d_i^(k) of gamma_s, gamma_{s+1}, .., with recursions for pi and its companion
RECURSION = (*DOUBLE_SUM[:8], COLUMN(8, rhos), _TOP, _BY_PI, _BY_RECURSION)
OPENED_FOR_RECURSION = {**OPENED_FOR_SUMS, "supported": [*OPENED_FOR_SUMS["supported"], pi, rhos]}

_ONCE = 1 - gamma[0] ** 2
_NEXT_NORM = lemma(j, r(0, j + 1) == _ONCE * r(1, j), uses=[use(6, j=j)])
_NEXT_COLUMN = lemma(j, forall(k, 0, n - 1, forall(u, j, k, of_column(j - 1, k) == _ONCE * of_column(j - 1, k, 1))), in_values=True, closed=[sigma],
                     uses=[use(7, j=j, k=k, u=u), *(use(3, m=k - j, s=y, j=n - k - y) for y in (0, 1)), use(6, j=n - k - 1)])
_NEXT = lemma(k, forall(u, k, n - 1, w(k) == _ONCE * v(k)), in_values=True, closed=[sigma], uses=[use(8, k=k, u=u), use(7, j=k + 1, k=k + 1, u=k + 1)])
#: the double sum without alpha_n, and that for gamma_1, gamma_2, ..
SHIFT = (*SIGMA, COLUMN(3), _as_printed(4, w), _as_printed(5, v, 1), _NEXT_NORM, _NEXT_COLUMN, _NEXT)
