# SPDX-License-Identifier: MIT
"""Lemmas for the correlations of Schur parameters: (3.10) undoes (3.6), and v comes from u and the first coefficients of v/(2u), for every n.

If the two sequences agree up to index m, their sums against phi_m agree, and (3.6), (3.10) make them agree at m + 1. The induction
carries the sums against all phi_t: the term that is added has the next coefficient, and that is the next sum against phi_m.

They are numbered as they stand in `AGAIN`. ``first`` are the coefficients of v/(2u) at infinity, ``own`` are polynomials and norms by another name.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from exactkf.evidence import fact, lemma, use
from exactkf.language import Expr, always, coeff, forall, function, laurent, sum_of, symbols, when
from proofs.blz94.lemmas import z
from proofs.blz94.notation import HALF, gamma, j, k, m, n, phi, phis, r, t

__all__ = ["CONCLUDED", "FIRST", "again_lemmas", "first"]

first, l = symbols("first l")


def FIRST(p: Expr, q: Expr) -> tuple:
    """Coefficients of q/(2p) at infinity, for monic p and q of degree n."""
    return (function(first, [k], when(k == 0, HALF, HALF * coeff(q, n - k) - sum_of(j, 1, k, coeff(p, n - j) * first(k - j)))),)


def again_lemmas(p: Expr, q: Expr, c: Expr, again: Expr, own: Sequence[Expr], values: Any) -> tuple:
    """The lemmas for q/(2p), whose coefficients are ``values``, and for c and what (3.10) makes of its Schur parameters."""
    f, fs, norm = own
    same = lemma(t, (f[t] == phi[t]) & (fs[t] == phis[t]) & (norm[t] == r[t]), rule=True)
    monic = lemma(t, (coeff(phi[t], t) == 1) & (coeff(phis[t], 0) == 1), uses=[use(1, t=t)])
    sums = lemma(m, always(t, sum_of(j, 0, m - 1, coeff(phi[t], j) * again(j + 1)) == sum_of(j, 0, m - 1, coeff(phi[t], j) * c[j + 1])),
                 uses=[use(2, m=m, t=t), use(2, m=m, t=m), use(again, m + 1), use(gamma, m), use(1, t=m)])
    infinity = fact(t, "laurent", forall(k, 0, n, laurent(HALF * q / p, k) == first(k)), n, uses=[use(first, k)])
    found = lemma(m, forall(k, 0, n, forall(l, m, k, sum_of(j, 1, m, values(j) * coeff(p, n - k + j)) == sum_of(j, 1, m, first(j) * coeff(p, n - k + j)))),
                  uses=[use(4, m=m, k=k, l=l), use(3, t=0, k=m + 1), use(values, m + 1)])
    return same, monic, sums, infinity, found


#: the coefficient of z of q, and the correlation with index k
CONCLUDED = [use(4, m=n - z, k=n - z, l=n - z), use(first, n - z), use(first, 0), use(2, m=k - 1, t=k - 1), use(1, t=k - 1), use(gamma, k - 1)]
