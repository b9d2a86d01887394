# SPDX-License-Identifier: MIT
"""Lemmas for (A-18) and (A-19): the coefficients of D from the double sum (A-15), for every n.

With x_i = alpha_i, x_0 = 1, let w_k be the sum of x_i x_j sigma_{n-i,n-j}, i < j <= k. By induction on k

    (A(z) B(1/z) + A(1/z) B(z)) / 2 = x_0^2 r_n + .. + x_k^2 r_{n-k} + w_k(z) + w_k(1/z)

for the parts A, B of a(z), b(z) with x_0, .., x_k; and w_k has the exponents 1, .., n, as those sigma have.

They are numbered as they stand in `DOUBLE_SUM`, after `SIGMA` and `EXPONENTS` of lemmas_sigma.
"""

from __future__ import annotations

from exactkf.evidence import lemma, use
from exactkf.language import Expr, Z, always, coeff, forall, function, recip, sum_of, sym, symbols, when
from proofs.blz94.notation import D, i, j, k, n, phi, psi, r, sigma, symmetric_part, u

__all__ = ["ABOVE", "DOUBLE_SUM", "w"]

w, x, l = symbols("w x l")


def _column(high: Expr, at: Expr) -> Expr:
    """Sum of x_i sigma_{n-i,n-at}, i = 0 .. high."""
    return sum_of(i, 0, high, x[i] * sigma(0, n - i, n - at))


#: the terms above the diagonal
ABOVE = (function(w, [k], when(k == 0, 0, w(k - 1) + x[k] * _column(k - 1, k))),)


def _part(p: Expr) -> Expr:
    return sum_of(i, 0, k, x[i] * p(0, n - i))


def _up_to(body: Expr) -> Expr:
    return forall(u, k, n, body)


def _split(high: Expr) -> Expr:
    return sum_of(i, 0, high, x[i] ** 2 * r(0, n - i)) + w(high) + recip(w(high))


_PARTS = lemma(k, _up_to(symmetric_part(_part(phi), _part(psi)) == _split(k)), in_values=True,
               uses=[use(4, k=k, u=u, times=1), use(2, j=n - k - 1, s=0, times=x[k + 1] ** 2)], base=[use(2, j=n, s=0, times=1)])
_WHOLE = lemma(k, D == _split(n), direct=True, in_values=True, uses=[use(4, k=n, u=n, times=1)])
_OF_COLUMN = lemma(j, forall(k, 0, n, forall(u, j, k, always(l, (coeff(_column(j - 1, k), -l) == 0) & (coeff(_column(j - 1, k), n + 1 + l) == 0)))),
                   uses=[use(6, j=j, k=k, u=u, l=l), *(use(3, m=k - j, s=0, j=n - k, l=x) for x in (l, n - k + j + l))])
_OF_ABOVE = lemma(k, _up_to(always(l, (coeff(w(k), -l) == 0) & (coeff(w(k), n + 1 + l) == 0))),
                  uses=[use(7, k=k, u=u, l=l), use(6, j=k + 1, k=k + 1, u=k + 1, l=l)])
_Z = sym("z")
_OF_D = lemma(k, sum_of(i, 1, n, coeff(D, i) * Z**i) == w(n), direct=True,
              uses=[use(5, k=k, z=_Z), *(use(7, k=n, u=n, l=x) for x in (-_Z, _Z, _Z - n - 1, -_Z - n - 1))])
_AS_PRINTED = lemma(k, _up_to(w(k) == sum_of(i, 0, k - 1, sum_of(j, i + 1, k, x[i] * x[j] * sigma(0, n - i, n - j)))), in_values=True, uses=[use(9, k=k, u=u)])
DOUBLE_SUM = (_PARTS, _WHOLE, _OF_COLUMN, _OF_ABOVE, _OF_D, _AS_PRINTED)
