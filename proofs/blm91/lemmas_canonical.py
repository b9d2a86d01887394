# SPDX-License-Identifier: MIT
"""Lemmas on the change of coordinates to the canonical form (2.22), for every n.

Let chi(z) = z^n + a_1 z^(n-1) + .. + a_n be the characteristic polynomial of F. Row i of T_c = L_a O_F is h'(F^(i-1) + a_1 F^(i-2) + .. + a_(i-1)), so that
row i of T_c F is row i + 1 less a_i h', for i = n because of chi(F) = 0; and that is row i of F_c T_c.

They are numbered as they stand in `BY_CAYLEY`. O_F is not opened: an entry of O_F F is h'F^k by the facts on products.
"""

from __future__ import annotations

from exactkf.evidence import fact, generic_index, lemma, use
from exactkf.language import Expr, T, Z, Zero, charpoly, coeff, forall, let, matrix_of, sum_of, symbols, when
from proofs.blm91.notation import F, a, e, h, i, j, k, m, n, polynomial_of, s, t

__all__ = ["BY_CAYLEY", "TO_CANONICAL", "Fc", "Lc", "Tm"]

Obs, Lc, Tm, Fc, l, row, column, z = symbols("O_F L_a T_c F_c l row column z")
CHI = charpoly(F)
TO_CANONICAL = (
    let(a, matrix_of(i, j, n, 1, coeff(CHI, n - i))), let(e, matrix_of(i, j, n, 1, when(i == 1, 1, 0))),
    let(Fc, matrix_of(i, j, n, n, when(j == 1, -a[i], 0) + when(j == i + 1, 1, 0))),
    let(Obs, matrix_of(i, j, n, n, (T(h) * F ** (i - 1))[1, j])), let(Lc, matrix_of(i, j, n, n, when(i == j, 1, when(i > j, a[i - j], 0)))), let(Tm, Lc * Obs))


def _places(*indices: Expr, says: Expr) -> Expr:
    """For these indices from 1 to n."""
    return forall(indices[0], 1, n, _places(*indices[1:], says=says)) if indices else says


def _column(k: Expr) -> Expr:
    return T(F) ** k * h


def _weighted(number: int, term: Expr, known: Expr, uses: list) -> dict:
    """The first s terms of a row of L_a times a column of which the entries are known."""
    weight = when(i == k, 1, when(i > k, a[i - k], 0))
    return lemma(s, _places(i, l, says=forall(m, s, n, sum_of(k, 1, s, weight * term) == sum_of(k, 1, s, weight * known))), uses=[use(number, s=s, i=i, l=l, m=m), *uses])


_CAYLEY = fact(t, "cayley", (sum_of(k, 0, n, coeff(CHI, k) * (T(h) * F**k)) == Zero(1, n)) & (coeff(CHI, n) == 1))
_COMPANION = fact(t, "charpoly", charpoly(Fc) == polynomial_of(a), (j, Z ** (n - j)))
_PARTIAL = lemma(s, _places(k, l, says=forall(m, s, n, sum_of(j, 1, s, Obs[k, j] * F[j, l]) == sum_of(j, 1, s, T(F)[l, j] * _column(k - 1)[j, 1]))),
                 uses=[use(2, s=s, k=k, l=l, m=m), use(Obs, row=k, column=s + 1)])
_OBSERVED = fact(t, "product", _places(k, l, says=sum_of(j, 1, n, Obs[k, j] * F[j, l]) == (Obs * F)[k, l]))
_POWER = fact(t, "product", _places(k, l, says=sum_of(j, 1, n, T(F)[l, j] * _column(k - 1)[j, 1]) == (T(F) * _column(k - 1))[l, 1]))
_NEXT = lemma(t, _places(k, l, says=(Obs * F)[k, l] == (T(h) * F**k)[1, l]), direct=True, uses=[use(3, t=t, k=k, l=l), use(2, s=n, k=k, l=l, m=n), use(4, t=t, k=k, l=l)])
BY_CAYLEY = generic_index(
    _CAYLEY, _COMPANION, _PARTIAL, _OBSERVED, _POWER, _NEXT, _weighted(6, (Obs * F)[k, l], (T(h) * F**k)[1, l], [use(5, t=0, k=s + 1, l=l)]),
    _weighted(7, Obs[k, l], (T(h) * F ** (k - 1))[1, l], [use(Obs, row=s + 1, column=l)]), closed=[Obs],
    uses=[use(6, s=n, i=row, l=column, m=n), use(7, s=n, i=row + 1, l=column, m=n), use(Obs, row=1, column=column), use(0, t=0, row=1, column=column), use(1, t=0, z=z)])
