# SPDX-License-Identifier: MIT
"""Lemmas on the covariance of the estimate, for every n and t.

With the weights U_t of `lemmas_estimate`, by induction on t

    E{x_t Y'} U_t' = g U_0' F'^(t-1) + .. = Pi_t,

and E{x^_t x^_t'} is U_t E{YY'} U_t', where E{YY'} U_t' = E{Y x_t'} by the normal equations. They go over to products with it factor by factor, as a
product of matrices is a sum of products of their entries. They are numbered as they stand in `COVARIANCE_LEMMAS` and `RICCATI_OF_COVARIANCE`.
"""

from __future__ import annotations

from typing import Any

from exactkf.evidence import fact, lemma, use
from exactkf.language import Expr, T, always, forall, function, inv, sum_of, symbols
from proofs.blm91.lemmas_estimate import ESTIMATE_LEMMAS, Gram, Past, Pi, U, a, column, cov_xy, cov_y, e, l, q, row, v, xh
from proofs.blm91.notation import F, g, h, i, k, n, s, t

__all__ = [
    "BY_COVARIANCE", "BY_RICCATI_OF_COVARIANCE", "BY_RICCATI_TRANSPOSED", "COVARIANCE", "COVARIANCE_LEMMAS", "RICCATI_OF_COVARIANCE", "SYMMETRIC", "cov",
    "moved", "multiplied", "partial_sums", "product_fact", "stays_symmetric",
]

cov, moved = symbols("cov F_g")
#: E{x^_t x^_t'}; and the entries of F^l g
COVARIANCE = (function(cov, [t], xh(t) * Gram(t) * T(xh(t))), function(moved, [l, k], (F**l * g)[k, 1]))
_FOUND = inv(Gram(t)) * Past(t)


def _places(body: Expr, rows: Any, columns: Any) -> Expr:
    return forall(i, 1, rows, forall(k, 1, columns, body))


def product_fact(x: Expr, y: Expr, rows: Any, inner: Any, columns: Any, *, start: int = 0) -> dict[str, Any]:
    """A product by its entries, at row i and column k."""
    return fact(t, "product", _places(sum_of(q, 1, inner, x[i, q] * y[q, k]) == (x * y)[i, k], rows, columns), start=start)


def partial_sums(number: int, left: Expr, right: Expr, rows: Any, inner: Any, columns: Any, *uses: Any) -> dict[str, Any]:
    """Two sums over q up to any place s, as the lemma so numbered; the uses are at the place after s."""
    return lemma(s, always(t, forall(v, s, inner, _places(sum_of(q, 1, s, left) == sum_of(q, 1, s, right), rows, columns))),
                 uses=[use(number, s=s, t=t, v=v, i=i, k=k, times=1), *uses])


def _moved(before: Expr, x: Any, y: Any) -> Expr:
    """The sum of U_l g'F'^(t-1-l), multiplied by F^a or h'F^a and F'^e."""
    return sum_of(l, 0, t - 1, (before * U(l, t))[x, 1] * moved(t - 1 - l + e, y)) == (before * Pi[t] * T(F) ** e)[x, y]


_AT = {"t": t, "i": i, "k": k}
_SYM = lemma(t, always(a, always(e, forall(k, 1, n, (T(h) * F**a * Pi[t] * T(F) ** e)[1, k] == (F**e * Pi[t] * T(F) ** a * h)[k, 1]))),
             uses=[use(13, t=t, a=a + 1, e=e + 1, k=k)])
_MOVED = lemma(t, always(a, always(e, _places(_moved(F**a, i, k), n, n) & forall(k, 1, n, _moved(T(h) * F**a, 1, k)))),
               uses=[*(use(14, a=x, e=e + 1, **_AT) for x in (a, a + 1)), *(use(14, a=x, e=e + 1, t=t, k=k) for x in (0, a, a + 1)),
                     use(13, t=t, a=0, e=e + 1, k=k), use(moved, e, k)])
_OF_FOUND = product_fact(Gram(t), _FOUND, t, t, n, start=1)
_OF_U = partial_sums(16, cov_y(i - 1, q - 1) * _FOUND[q, k], cov_y(i - 1, q - 1) * U(q - 1, t)[k, 1], t, t, n, use(10, t=t, row=s + 1, column=k))
_NORMAL = lemma(t, _places((Gram(t) * _FOUND)[i, k] == cov_xy(t, i - 1, k), t, n), start=1, direct=True,
                uses=[use(15, times=-1, **_AT), use(16, s=t, v=t, **_AT), use(5, t=t, j=i - 1, e=0, i=k), use(2, t=t, j=i - 1, i=k)])
_SQUARE = product_fact(T(_FOUND), Gram(t) * _FOUND, n, t, n, start=1)
_SUMS = partial_sums(19, T(_FOUND)[i, q] * (Gram(t) * _FOUND)[q, k], U(q - 1, t)[i, 1] * moved(t - q, k), n, t, n,
                     use(10, t=t, row=s + 1, column=i), use(17, t=t, i=s + 1, k=k), use(2, t=t, j=s, i=k), use(moved, t - 1 - s, k))
_COVARIANCE = lemma(t, _places(cov(t)[i, k] == Pi[t][i, k], n, n), start=1, direct=True,
                    uses=[use(18, times=-1, **_AT), use(19, s=t, v=t, **_AT), use(14, a=0, e=0, **_AT)])
COVARIANCE_LEMMAS = (*ESTIMATE_LEMMAS, _SYM, _MOVED, _OF_FOUND, _OF_U, _NORMAL, _SQUARE, _SUMS, _COVARIANCE)


def stays_symmetric(number: int) -> dict[str, Any]:
    """Pi_t is symmetric, as the lemma so numbered."""
    return lemma(t, always(a, always(e, _places((F**a * Pi[t] * T(F) ** e)[i, k] == (F**e * Pi[t] * T(F) ** a)[k, i], n, n))),
                 uses=[use(number, a=a + 1, e=e + 1, **_AT)])


#: next of `COVARIANCE_LEMMAS`
SYMMETRIC = stays_symmetric(21)
BY_COVARIANCE = [use(20, t=t, i=row, k=column), use(21, t=t, a=0, e=0, i=row, k=column), use(20, t=t, i=column, k=row)]


def multiplied(number: int, x: Expr | None, y: tuple[Expr, Expr], z: Expr | None, before: int, rows: Any, columns: Any) -> tuple[dict[str, Any], ...]:
    """From y = y', which is the lemma ``before``: xy = xy', or yz = y'z; the last of four lemmas, of which the first has this number."""
    left, right = ((x * p, x, p) if z is None else (p * z, p, z) for p in y)
    return (
        product_fact(left[1], left[2], rows, n, columns), product_fact(right[1], right[2], rows, n, columns),
        partial_sums(number + 2, left[1][i, q] * left[2][q, k], right[1][i, q] * right[2][q, k], rows, n, columns,
                     use(before, t=t, i=s + 1, k=k) if z is None else use(before, t=t, i=i, k=s + 1)),
        lemma(t, _places(left[0][i, k] == right[0][i, k], rows, columns), direct=True,
              uses=[use(number, times=-1, **_AT), use(number + 1, **_AT), use(number + 2, s=n, v=n, **_AT)]),
    )


_BOTH = cov(t), Pi[t]
_WITH_F, _WITH_H = (tuple(y * z for y in _BOTH) for z in (T(F), h))
RICCATI_OF_COVARIANCE = (
    *COVARIANCE_LEMMAS, lemma(t, _places(cov(t)[i, k] == Pi[t][i, k], n, n), direct=True, uses=[use(20, **_AT)]),
    *multiplied(22, None, _BOTH, T(F), 21, n, n), *multiplied(26, F, _WITH_F, None, 25, n, n),
    *multiplied(30, None, _BOTH, h, 21, n, 1), *multiplied(34, F, _WITH_H, None, 33, n, 1), *multiplied(38, T(h), _WITH_H, None, 33, 1, 1),
)
BY_RICCATI_OF_COVARIANCE = [use(21, t=t + 1, i=row, k=column, times=1), use(29, t=t, i=row, k=column), use(37, t=t, i=row, k=1), use(37, t=t, i=column, k=1), use(41, t=t, i=1, k=1)]
#: of the transposed equation: the lemma after `RICCATI_OF_COVARIANCE` is that Pi_t is symmetric
BY_RICCATI_TRANSPOSED = [use(21, t=t + 1, i=column, k=row, times=1), *BY_RICCATI_OF_COVARIANCE[1:], use(42, t=t, a=1, e=1, i=row, k=column)]
