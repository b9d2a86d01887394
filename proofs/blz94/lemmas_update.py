# SPDX-License-Identifier: MIT
"""Lemmas for (4.8): the Schur parameter gamma_{t+n} from the n before it, for every n and t.

Let a, g, c, phi_k, gamma_k', alpha be what belongs to v at time t + 1, so that gamma_k' = gamma_{t+1+k} by Lemma 4.2. The sums of the
coefficients of a polynomial against c_0 = 1, c_1, c_2, .. are zero for phi_k, k > 0, and one for phi_0; for
a(z) = phi_n + alpha_1 phi_{n-1} + .. + alpha_n phi_0 they come to alpha_n. On the other hand they are the coefficient of z^0
in a(1 + g/a) = a + g, so that alpha_n = a_n + g_n, and a step of the fast algorithm gives a_n = (1 + gamma_t)(a_n + g_n). As phi_k
has the constant coefficient -gamma_{k-1}', the last entry of a(z) is

    (1 + gamma_t) alpha_n = a_n = -gamma_{t+n} - alpha_1 gamma_{t+n-1} - .. - alpha_{n-1} gamma_{t+1} + alpha_n.

They are numbered as they stand in `UPDATE`, after the first lemmas of `DELETION`. ``below`` are the parts
alpha_n phi_0 + .. + alpha_{n-k} phi_k of a(z); the bound k <= u says up to where entries of vectors are meant.
"""

from __future__ import annotations

from exactkf.evidence import lemma, use
from exactkf.language import Expr, coeff, forall, function, sum_of, symbols, when
from proofs.blz94.lemmas_deletion import DELETION, NAMES_1, OPENED_AT_BOTH, e_of, later, pairing, parameters, part, schur
from proofs.blz94.notation import a, g, i, j, k, m, n, s, u

__all__ = ["ALPHA_NEXT", "CONCLUDED", "OPENED_FOR_UPDATE", "PARTS", "UPDATE", "alpha_next"]

alpha_next, below, l = symbols("alpha1 below l")
_c, _f, _fs, _r, _ = NAMES_1
_NEXT = m + 1


def _correlation(index: Expr) -> Expr:
    """c_index, with c_0 = 1."""
    return when(index == 0, 1, _c(index))


def _up_to(high: Expr, body: Expr) -> Expr:
    """For the index of the lemma no greater than that."""
    return forall(u, k, high, body)


def _paired(p: Expr, high: Expr) -> Expr:
    return sum_of(j, 0, high, coeff(p, j) * _correlation(j))


#: what belongs to v at time m + 1, its coordinates alpha by (3.12a), and the parts of a(z)
ALPHA_NEXT = (*parameters(_NEXT, NAMES_1),
              function(alpha_next, [k], a[_NEXT][k] - coeff(_f[n], n - k) - sum_of(j, 1, k - 1, alpha_next(j) * coeff(_f[n - j], n - k))))
PARTS = (function(below, [k], when(k == 0, alpha_next(n), below(k - 1) + alpha_next(n - k) * _f[k])),)

_SCHUR = lemma(k, schur(k) == g[k][1], direct=True, uses=[use(schur, k), use(4, k=k, l=0), use(e_of, 0, k, 1)])
_LATER = lemma(k, later(k) == schur(_NEXT + k), direct=True, uses=[use(later, k), use(5, k=k, l=0), use(6, k=_NEXT + k), use(e_of, _NEXT, _NEXT + k, 1)])
_ORTHOGONAL = lemma(k, (_paired(_f[k], k) == when(k == 0, 1, 0)) & (_paired(_fs[k], k) == _r[k]), uses=[use(later, k), use(8, k=k), use(5, k=k, l=0)])
_ENDS = lemma(k, (coeff(_f[k], k) == 1) & (coeff(_fs[k], 0) == 1), uses=[use(9, k=k)])
_LOWEST = lemma(k, coeff(_f[k + 1], 0) == -later(k), direct=True, uses=[use(9, k=k)])
_PAIRED_PARTS = lemma(k, _paired(below(k), k) == alpha_next(n), uses=[use(11, k=k), use(8, k=k + 1)])
_AS_SUMS = lemma(k, forall(s, 0, k, coeff(below(k), s) == sum_of(l, 0, k, alpha_next(n - l) * coeff(_f[l], s))), uses=[use(12, k=k, s=s)])
_ENTRY = lemma(k, _up_to(n - 1, a[_NEXT][n - k] == coeff(below(n - 1), k) + coeff(_f[n], k)), direct=True,
               uses=[use(12, k=n - 1, s=k), use(alpha_next, n - k), use(9, k=k)])
_CONVOLVED = lemma(k, _up_to(n - 1, sum_of(j, 0, k, a[_NEXT][n - j] * _correlation(j)) == _paired(below(n - 1) + _f[n], k)),
                   uses=[use(14, k=k, u=u), use(13, k=k + 1, u=u)], base=[use(13, k=0, u=u)])
_AT_INFINITY = lemma(k, _up_to(n - 1, sum_of(j, 1, k, a[_NEXT][n - j] * _c(j)) == sum_of(j, 1, k, a[_NEXT][n - j] * part(_NEXT, j, n))),
                     uses=[use(15, k=k, u=u, times=1), use(2, t=_NEXT, k=k + 1)])
_LAST = lemma(k, a[_NEXT][n] + g[_NEXT][n] == alpha_next(n), direct=True,
              uses=[use(15, k=n - 1, u=n - 1), use(2, t=_NEXT, k=n), use(1, i=n, u=_NEXT, k=n, v=n), use(0, i=n, u=_NEXT, l=0, v=n),
                    use(14, k=n - 1, u=n - 1), use(11, k=n - 1), use(8, k=n), use(9, k=n)])
_STEP = lemma(k, a[_NEXT][n] == (1 + g[m][1]) * (a[_NEXT][n] + g[_NEXT][n]), direct=True, uses=[use(x, _NEXT, row=n) for x in (a, g)])
_SUM = lemma(k, _up_to(n - 1, sum_of(i, 1, k, alpha_next(i) * coeff(_f[n - i], 0)) == -sum_of(i, 1, k, alpha_next(i) * schur(m + n - i))),
             uses=[use(18, k=k, u=u, times=1), use(10, k=n - k - 2), use(7, k=n - k - 2)])
UPDATE = (*DELETION[:5], pairing(5, _NEXT, NAMES_1), _SCHUR, _LATER, _ORTHOGONAL, _ENDS, _LOWEST, _PAIRED_PARTS, _AS_SUMS, _ENTRY, _CONVOLVED,
          _AT_INFINITY, _LAST, _STEP, _SUM)
#: the lowest coefficient of a(z), from the lemmas
CONCLUDED = [use(alpha_next, n), use(10, k=n - 1), use(7, k=n - 1), use(18, k=n - 1, u=n - 1), use(16, k=0), use(17, k=0), use(6, k=m)]
OPENED_FOR_UPDATE = {"supported": [*OPENED_AT_BOTH["supported"], below], "closed": [*OPENED_AT_BOTH["closed"], alpha_next]}
