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
from proofs.blz94.lemmas import FOUR, LEMMA_3_3, z
from proofs.blz94.notation import HALF, a, alpha, b, c, i, j, k, m, n, phi, psi, s, t, u

__all__ = ["CONCLUDED", "MATCH", "OPENED_FOR_MATCH", "PARTS"]

pa, pb, first, l = symbols("a_part b_part first l")


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
#: the coefficients of b(z), from the lemmas
CONCLUDED = [use(5, k=n, u=n, s=z), use(6, k=0, z=z), use(first, n - z), use(first, 0), use(11, m=n - z, k=n - z, u=n - z), use(7, k=n, u=n, i=z),
             use(8, k=n, u=n, s=z)]
