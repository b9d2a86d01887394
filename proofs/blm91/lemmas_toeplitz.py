# SPDX-License-Identifier: MIT
"""Lemmas on products with a Toeplitz matrix T and coefficients of Szego polynomials, for every n.

phi_t is orthogonal to 1, z, .., z^(t-1) in the form <z^i, z^j> = c_|i-j|. With its coefficients in row t + 1 of Phi, entry (k, i) of T Phi' is therefore
zero for k < i and r_(i-1) for k = i. Row l of Phi has no entry after the l-th, so that the entry (l, i) of Phi T Phi' is what is claimed for l <= i; for
l > i it is the entry (i, l) of Phi T' Phi', of which the same is shown. The prediction y_hat solves T y_hat = tau for the same reason, and
x'T y_hat = x'tau for any x; with T' in place of T that is y_hat'T x = x'tau.

The sums are added up to s, with m >= s for an end that they stay below. T, Phi and y_hat are not opened: entries of a product are words, which a fact
turns into sums, and definitions are used at one place at a time. They are numbered from ``first``; 1 says that phi_t is monic, and 2 that it is orthogonal.
"""

from __future__ import annotations

from typing import Any

from exactkf.evidence import fact, lemma, use
from exactkf.language import Expr, T, coeff, forall, sum_of, symbols, when
from proofs.blm91.notation import i, j, k, m, n, phi, r, s, t

__all__ = ["by_triangles", "by_prediction", "Toep", "cc", "predicted", "triangular", "yhat"]

cc, Toep, yhat, l = symbols("cov T y_hat l")


def _opened(size: Expr, row: Expr, column: Expr, flipped: bool) -> dict[str, Any]:
    """The definition of T, or of T', at a place."""
    return use(Toep, size, row=column, column=row) if flipped else use(Toep, size, row=row, column=column)


def triangular(matrix: Expr, coefficients: Expr, first: int, *, flipped: bool) -> list[dict[str, Any]]:
    """Phi A Phi' is r on its diagonal and zero above it, for A = T or A = T'."""
    partial, whole, seen, again, product = range(first, first + 5)
    right = matrix * T(coefficients)
    return [
        lemma(s, forall(i, 1, n + 1, forall(k, 1, i, forall(m, s, n + 1, sum_of(j, 1, s, matrix[k, j] * T(coefficients)[j, i])
                                                              == sum_of(j, 1, s, cc(abs(k - j)) * coeff(phi[i - 1], j - 1))))),
              uses=[use(partial, s=s, i=i, k=k, m=m), _opened(n, k, s + 1, flipped), use(coefficients, row=i, column=s + 1)]),
        fact(t, "product", forall(i, 1, n + 1, forall(k, 1, n + 1, sum_of(j, 1, n + 1, matrix[k, j] * T(coefficients)[j, i]) == right[k, i]))),
        lemma(t, forall(i, 1, n + 1, forall(k, 1, i, right[k, i] == when(k == i, r[i - 1], 0))), direct=True,
              uses=[use(whole, t=t, i=i, k=k), use(partial, s=n + 1, i=i, k=k, m=n + 1), use(2, t=i - 1, k=k - 1)]),
        lemma(s, forall(i, 1, n + 1, forall(l, 1, i, forall(m, s, n + 1, sum_of(k, 1, s, coefficients[l, k] * right[k, i])
                                                              == when(l == i, when(s >= i, r[i - 1], 0), 0)))),
              uses=[use(again, s=s, i=i, l=l, m=m), use(coefficients, row=l, column=s + 1), use(seen, t=0, i=i, k=s + 1), use(1, t=i - 1)]),
        fact(t, "product", forall(i, 1, n + 1, forall(l, 1, n + 1, sum_of(k, 1, n + 1, coefficients[l, k] * right[k, i]) == (coefficients * right)[l, i])))]


def by_triangles(first: int, row: Expr, column: Expr) -> list[dict[str, Any]]:
    """What `triangular` says at a place with row <= column."""
    return [use(first + 4, t=0, i=column, l=row), use(first + 3, s=n + 1, i=column, l=row, m=n + 1)]


def predicted(matrix: Expr, x: Expr, first: int, *, flipped: bool) -> list[dict[str, Any]]:
    """A y_hat = tau, x'A y_hat = x'tau and y_hat'A y_hat = y_hat'tau, for A = T or A = T'."""
    partial, whole, solved, along_x, _, along_itself, _ = range(first, first + 7)
    right = matrix * yhat

    def along(v: Expr, number: int) -> dict[str, Any]:
        return lemma(s, forall(m, s, n, sum_of(k, 1, s, v[k, 1] * right[k, 1]) == sum_of(k, 1, s, v[k, 1] * cc(n + 1 - k))),
                     uses=[use(number, s=s, m=m), use(solved, t=0, k=s + 1)])

    def product(v: Expr) -> dict[str, Any]:
        return fact(t, "product", sum_of(k, 1, n, T(v)[1, k] * right[k, 1]) == (T(v) * right)[1, 1])

    return [
        lemma(s, forall(k, 1, n, forall(m, s, n, sum_of(j, 1, s, matrix[k, j] * yhat[j, 1]) == -sum_of(j, 1, s, cc(abs(k - j)) * coeff(phi[n], j - 1)))),
              uses=[use(partial, s=s, k=k, m=m), _opened(n - 1, k, s + 1, flipped), use(yhat, row=s + 1)]),
        fact(t, "product", forall(k, 1, n, sum_of(j, 1, n, matrix[k, j] * yhat[j, 1]) == right[k, 1])),
        lemma(t, forall(k, 1, n, right[k, 1] == cc(n + 1 - k)), direct=True,
              uses=[use(whole, t=t, k=k), use(partial, s=n, k=k, m=n), use(2, t=n, k=k - 1), use(1, t=n)]),
        along(x, along_x), product(x), along(yhat, along_itself), product(yhat)]


def by_prediction(first: int) -> list[dict[str, Any]]:
    """What `predicted` says of the two products."""
    return [use(first + 3, s=n, m=n), use(first + 4, t=0), use(first + 5, s=n, m=n), use(first + 6, t=0)]
