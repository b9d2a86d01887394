# SPDX-License-Identifier: MIT
"""Lemmas for (4.9): the Riccati recursion from P_0 = 0 along the fast algorithm, for every n and t.

With f = a(t) + g(t) - a, as in (2.17), the induction carries

    FPF' + rff' = P + rgg',    r = 1 - h'Ph,    g_0 - FPh = rf

at time t, entry by entry. So P_{t+1} = FPF' + rff' = P + rgg', and a step of the algorithm does the rest. The first relation goes
from t to t + 1 with the factor 1 at the second, -F at the third and FF' at itself; where n > 1 it tells what P_{i+1,j+1} is,
and where n = 1 this multiple is taken off. The lemmas on the coordinates of a(t), g(t) come before: by them g_1(t) = gamma_0(t),
so that no r_t is zero.
"""

from __future__ import annotations

from exactkf.evidence import lemma, use
from exactkf.language import Expr, T, Zero, column, forall, function, let, rec, symbols
from proofs.blz94.lemmas_orbit import COORDINATES, FOUR_ALPHA, ONE_STEP
from proofs.blz94.notation import HALF, F, J, P, a, a0, a_of, alpha, b_of, g, g0, gamma, h, i, j, n, r, t

__all__ = ["FIRST", "GAIN", "OPENED_FOR_GAIN", "RICCATI_FROM_ZERO", "a_first"]

_LEFT = g0 - F * P[t] * h
a_first, g_first = symbols("x y")


def _gain(index: Expr) -> Expr:
    """An entry of (2.17)."""
    return a[t][index] + g[t][index] - a0[index]


#: (a, g) from its coordinates, entry by entry
FIRST = (function(a_first, [i], a_of[0][i]), function(g_first, [i], HALF * (b_of[0][i] - a_of[0][i])),
         let(a0, column(i, n, a_first(i))), let(g0, column(i, n, g_first(i))))
#: P_t from zero, in the observer form (2.10)
RICCATI_FROM_ZERO = (let(F, J - a0 * T(h)), rec(P, t, Zero(n, n), F * P[t] * T(F) + _LEFT / (1 - T(h) * P[t] * h) * T(_LEFT)))

_PLACES = [(1, 1), (i, j), (i + 1, 1), (1, j + 1), (i + 1, j + 1)]
_FOR_I, _FOR_J = i - i + 1, j - j + 1  # one, where there are such indices: so the multiples add up to 1, x_1 and x_1^2
_SAME = lemma(t, g[t][1] == gamma[t][1], direct=True, uses=[use(8, t=t, i=1), use(7, k=n, t=t), use(6, k=n - 1, t=t)])
_CARRIED = lemma(t, forall(i, 1, n, forall(j, 1, n, (F * P[t] * T(F))[i, j] + r[t] * _gain(i) * _gain(j) == P[t][i, j] + r[t] * g[t][i] * g[t][j]))
                 & (r[t] == 1 - P[t][1, 1]) & forall(i, 1, n, _LEFT[i] == r[t] * _gain(i)),
                 uses=[use(10, t=t, i=1, j=1, times=1), use(10, t=t, i=_FOR_I, j=1, times=a_first(1) - 1),
                       use(10, t=t, i=1, j=_FOR_J, times=a_first(1) * (a_first(1) - 1)), *(use(P, t + 1, row=p, column=q) for p, q in _PLACES),
                       *(use(10, t=t, i=p, j=q) for p, q in _PLACES), *(use(10, t=t, i=p, j=1) for p in (i, j, j + 1)), use(9, t=t)])
GAIN = (*ONE_STEP, {**COORDINATES(8), "base": [use(a_first, i), use(g_first, i)]}, _SAME, _CARRIED)
OPENED_FOR_GAIN = {**FOUR_ALPHA, "whole": [alpha, P], "closed": [a_first, g_first]}
