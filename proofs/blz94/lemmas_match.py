# SPDX-License-Identifier: MIT
"""Lemmas for Theorem 3.2: if b/(2a) has the correlations (3.10) as its first n coefficients, a and b have the same coordinates, for every n.

Let alpha_0 = 1 and alpha_1, .., alpha_n be solved from a(z), and let A_k be the part alpha_n phi_0 + .. + alpha_{n-k} phi_k of a(z), B_k
the same sum of psi_0, .., psi_k. By Lemma 3.3 and induction on k

    B_k has the coefficients  A_{k,i} + 2 (c_1 A_{k,i+1} + .. + c_{k-i} A_{k,k}),

and for k = n, where A_n is a(z), that is what b(z) has, as b = 2a (1/2 + c_1/z + .. + c_n/z^n + ..).

They are numbered as they stand in `MATCH`, after those of Lemma 3.3. ``first`` are the coefficients of b/(2a) at infinity.
"""

from __future__ import annotations

from exactkf.evidence import fact, lemma, use
from exactkf.language import Expr, always, coeff, forall, function, laurent, sum_of, symbols, when
from proofs.blz94.lemmas import FOUR, LEMMA_3_3, row, z
from proofs.blz94.notation import HALF, a, alpha, b, beta, c, i, j, k, m, n, phi, psi, s, t, u

__all__ = ["BY_MATRICES", "CONCLUDED", "MATCH", "MATRICES", "OPENED_FOR_MATCH", "OPENED_FOR_MATRICES", "PARTS", "y"]

pa, pb, first, l, y = symbols("a_part b_part first l y")


def _weight(index: Expr | int) -> Expr:
    """alpha_{n-index}."""
    return when(index == n, 1, alpha[n - index])


#: parts of a(z) and b(z), and the coefficients of b/(2a) at infinity
PARTS = (
    function(pa, [k], when(k == 0, _weight(k), pa(k - 1) + _weight(k) * phi[k])),
    function(pb, [k], when(k == 0, _weight(k), pb(k - 1) + _weight(k) * psi[k])),
    function(first, [k], when(k == 0, HALF, HALF * coeff(b, n - k) - sum_of(j, 1, k, coeff(a, n - j) * first(k - j)))),
)
OPENED_FOR_MATCH = {"supported": [*FOUR["supported"], pa, pb], "closed": [c, alpha, first]}


def _as_sums(number: int, part: Expr, p: Expr) -> dict:
    return lemma(k, forall(u, k, n, always(s, coeff(part(k), s) == sum_of(l, 0, k, _weight(l) * coeff(p[l], s)))), uses=[use(number, k=k, u=u, s=s)])


_WHOLE = lemma(k, a == pa(n), direct=True, uses=[use(5, k=n, u=n, s=z), use(alpha, n - z), use(1, t=z), use(1, t=n)])
_PARTS = lemma(k, forall(u, k, n, forall(i, 0, k, coeff(pb(k), i) == coeff(pa(k), i) + sum_of(j, i + 1, k, 2 * c[j - i] * coeff(pa(k), j)))),
               uses=[use(7, k=k, u=u, i=i), use(4, t=k + 1, k=i)])
_AT_INFINITY = fact(t, "laurent", forall(k, 0, n, laurent(HALF * b / a, k) == first(k)), n, uses=[use(first, k)])
_FIRST = lemma(k, forall(u, k, n - 1, first(k + 1) == c[k + 1]), direct=True, uses=[use("(3.11)", row=k + 1), use(9, t=0, k=k + 1)])
_TIMES_A = lemma(m, forall(k, 0, n, forall(u, m, k, sum_of(j, 1, m, first(j) * coeff(a, n - k + j)) == sum_of(j, 1, m, c[j] * coeff(pa(n), n - k + j)))),
                 uses=[use(11, m=m, k=k, u=u), use(10, k=m, u=m), use(6, k=0, z=n - k + m + 1)])
MATCH = (*LEMMA_3_3, _as_sums(5, pa, phi), _WHOLE, _PARTS, _as_sums(8, pb, psi), _AT_INFINITY, _FIRST, _TIMES_A)
#: for a(z) and b(z) that are given by their coordinates, alpha and beta: what the lemmas on a(z), on its leading coefficient, and on b(z) need
_LEADING = [use(6, k=0, z=n), use(5, k=n, u=n, s=n), use(1, t=n)]
_GIVEN = lemma(k, a == pa(n), direct=True, uses=[use(5, k=n, u=n, s=z), use(a, z=z)])
_GIVEN_AT_INFINITY = {**_AT_INFINITY, "uses": [use(first, k), *_LEADING, use(6, k=0, z=z), use(b, z=z), use(b, z=n), use(4, t=n, k=n)]}
_OF_B = lemma(k, forall(u, k, n, coeff(b, k) == coeff(pb(n), k)), direct=True, uses=[
    use(6, k=0, z=k), use(first, n - k), use(first, 0), use(11, m=n - k, k=n - k, u=n - k), use(7, k=n, u=n, i=k), *_LEADING, use(b, z=n), use(4, t=n, k=n)])


def _each(at: Expr) -> list:
    """Uses for beta_at = alpha_at, as psi_{n-at} is monic and later ones are of a lower degree."""
    return [use(1, t=n - at), use(4, t=n - at, k=n - at), use(12, k=n - at, u=n - at), use(8, k=n, u=n, s=n - at), use(13, k=at - 1, u=at - 1, s=n - at),
            use(b, z=n - at)]


_SAME = lemma(k, forall(u, k, n, always(s, sum_of(i, 1, k, beta[i] * coeff(psi[n - i], s)) == sum_of(i, 1, k, alpha[i] * coeff(psi[n - i], s)))),
              uses=[use(13, k=k, u=u, s=s), *_each(k + 1)])
_ENTRY = lemma(k, forall(u, k, n, y(k + 1) == coeff(pa(n), n - k)), direct=True, uses=[use(y, k + 1), use(5, k=n, u=n, s=n - k)])
_TIMES_C = lemma(m, forall(k, 0, n, forall(u, m, k, sum_of(j, 1, m, c[j] * coeff(pa(n), n - k + j)) == sum_of(j, 1, m, c[j] * y(k + 1 - j)))),
                 uses=[use(15, m=m, k=k, u=u), use(14, k=k - m - 1, u=k - m - 1)])
MATRICES = (*LEMMA_3_3, _as_sums(5, pa, phi), _GIVEN, _PARTS, _as_sums(8, pb, psi), _GIVEN_AT_INFINITY, _FIRST, _TIMES_A, _OF_B, _SAME, _ENTRY, _TIMES_C)
BY_MATRICES = [use(b, z=n + 1 - row), use(12, k=n + 1 - row, u=n), use(7, k=n, u=n, i=n + 1 - row), use(15, m=row - 1, k=row - 1, u=row - 1),
               use(14, k=row - 1, u=row - 1), *_each(row)]
OPENED_FOR_MATRICES = {**OPENED_FOR_MATCH, "closed": [c, first, y], "whole": [a, b]}
#: the coefficients of b(z), from the lemmas
CONCLUDED = [use(5, k=n, u=n, s=z), use(6, k=0, z=z), use(first, n - z), use(first, 0), use(11, m=n - z, k=n - z, u=n - z), use(7, k=n, u=n, i=z),
             use(8, k=n, u=n, s=z)]
