# SPDX-License-Identifier: MIT
"""Lemmas for the last part of Lemma 4.4: if d_1, .., d_n vanish, so do alpha_1, .., alpha_n, for every n.

By (A-17c) the leading coefficient of sigma_{j+m,j} is r_j, so that alpha_k r_{n-k} is the coefficient of z^k in w_k, and no other term of
w_k - w_{k-1} is free of alpha_k. From w_n = 0 follow alpha_n = 0 and w_{n-1} = 0, and so on; r_{n-k} has an inverse, as no gamma_k^2 is one.

They are numbered as they stand in `VANISHING`, after those on the double sum.
"""

from __future__ import annotations

from exactkf.evidence import lemma, use
from exactkf.language import Expr, always, coeff, forall, function, sum_of, symbols, when
from proofs.blz94.lemmas import row
from proofs.blz94.lemmas_double_sum import DOUBLE_SUM, of_column, w
from proofs.blz94.notation import alpha, gamma, i, j, k, m, n, r, s, sigma, t, u, x

__all__ = ["EACH", "HIGHER", "INVERSE", "NORM", "TOGETHER", "VANISHING"]

inverse, l = symbols("inverse l")
HIGHER, NORM = "d_1 = ... = d_n = 0", "gamma_k^2 != 1"
#: r_t by recursion, and the inverse of r_t for the parameters gamma_0, gamma_1, ..
INVERSE = (function(r, [s, t], when(t == 0, 1, (1 - gamma[s + t - 1] ** 2) * r(s, t - 1))),
           function(inverse, [t], when(t == 0, 1, inverse(t - 1) / (1 - gamma[t - 1] ** 2))))


def _to(k: Expr) -> Expr:
    return of_column(k - 1, k)


_TOP = lemma(m, always(s, always(j, coeff(sigma(s, j + m, j), m) == r(s, j))),
             uses=[use(8, m=m, s=s, j=j), use(0, i=j + m, s=s, j=j, z=m + 1), use(3, m=m, s=s, j=j, l=0)], base=[use(2, j=j, s=s, z=0)])
_TOP_OF_COLUMN = lemma(j, forall(k, 1, n, forall(u, j, k, coeff(of_column(j - 1, k), k) == r(0, n - k))), start=1,
                       uses=[use(9, j=j, k=k, u=u), use(3, m=k - j, s=0, j=n - k, l=j - 1)], base=[use(8, m=k, s=0, j=n - k)])
_INVERSE = lemma(t, forall(u, t, n, r(0, t) * inverse(t) == 1), uses=[use(10, t=t, u=u, times=1), use(r, 0, t + 1), use(NORM, k=t)], base=[use(r, 0, 0)])
_DOWN = lemma(j, forall(u, j, n, forall(i, 1, n, coeff(w(n - j), i) == 0)),
              uses=[use(11, j=j, u=u, i=n - j, times=-coeff(_to(n - j), i) * inverse(j)), use(10, t=j, u=j, times=x(n - j) * coeff(_to(n - j), i)),
                    use(11, j=j, u=u, i=i), *(use(w, n - j, z=y) for y in (n - j, i)), use(7, k=n - j - 1, u=n - j - 1, l=0), use(9, j=n - j, k=n - j, u=n - j)],
              base=[use(5, k=0, z=i), use(7, k=n, u=n, l=i), use(HIGHER, row=i)])


def _each(at: Expr) -> list:
    """Uses for alpha_at = 0."""
    return [use(11, j=n - at, u=n - at, i=at, times=inverse(n - at)), use(10, t=n - at, u=n - at, times=-alpha[at]), use(w, at, z=at),
            use(7, k=at - 1, u=at - 1, l=0), use(9, j=at, k=at, u=at)]


_EACH = lemma(k, forall(u, k, n - 1, alpha[k + 1] == 0), direct=True, uses=_each(k + 1))
_SQUARES = lemma(k, forall(u, k, n, sum_of(i, 0, k, x[i] ** 2 * r(0, n - i)) == r(0, n)), uses=[use(13, k=k, u=u), use(12, k=k, u=k)])
VANISHING = (*DOUBLE_SUM[:8], _TOP, _TOP_OF_COLUMN, _INVERSE, _DOWN, _EACH, _SQUARES)
#: each alpha, and d_0
EACH, TOGETHER = [use(12, k=row - 1, u=row - 1)], [use(5, k=0, z=0), use(7, k=n, u=n, l=0), use(13, k=n, u=n)]
