# SPDX-License-Identifier: MIT
"""Lemmas for Lemma 4.2: the Schur parameters of v_u are g_1(u), g_1(u + 1), .., for every n.

Let w be the coefficients of z^n/a_u(z) at infinity. Those of g_t/a_u and (a_t + g_t)/a_u are sums of w, as both have the
denominator of time u: call them e_l and h_l, for any t. A step of the fast algorithm says, with x = g_1(t),

    e_(l+1)(t) = e_l(t + 1) + x h_l(t + 1),        h_l(t) = h_l(t + 1) + x e_l(t + 1),

and the Szego recursion undoes this in the sums of phi_k and phi_k* against c_l, c_(l+1), .., the coefficients at t = u, but for 1 - x^2: they are
r_k e_l(u + k) and r_k h_l(u + k). As e_1(t) = g_1(t), the k-th Schur parameter is g_1(u + k).

They are numbered as they stand in `DELETION`. ``part`` is the sum e_l(u) cut off after some terms, for the product with a_u.
"""

from __future__ import annotations

from typing import Any

from exactkf.evidence import fact, lemma, use
from exactkf.language import Expr, Z, always, coeff, forall, function, laurent, prod, rec, sum_of, symbols, when
from proofs.blz94.notation import a, g, i, j, k, monic_of, n, s, strict_of, t, u

__all__ = [
    "AT_START", "AT_TIME", "DELETION", "NAMES_0", "NAMES_1", "OPENED_AT_BOTH", "OPENED_AT_START", "QUOTIENTS", "e_of", "later", "pairing", "parameters", "part", "schur",
    "step",
]

w, part, e_of, h_of, l, v = symbols("w part e_of h_of l v")
c0, f0, f0s, r0, schur = symbols("c0 f0 f0s r0 schur")
c1, f1, f1s, r1, later = symbols("c1 f1 f1s r1 later")


def parameters(at: Any, names: tuple[Expr, ...]) -> tuple:
    """(3.11) for v at a time, and its Schur parameters by (3.6)."""
    c, f, fs, r, gamma = names
    return (function(c, [k], laurent(strict_of(g[at]) / monic_of(a[at]), k)),
            rec(f, k, 1, Z * f[k] - gamma(k) * fs[k]), rec(fs, k, 1, fs[k] - gamma(k) * Z * f[k]), rec(r, k, 1, (1 - gamma(k) ** 2) * r[k]),
            function(gamma, [k], 1 / r[k] * sum_of(j, 0, k, coeff(f[k], j) * c(j + 1))))


NAMES_0, NAMES_1 = (c0, f0, f0s, r0, schur), (c1, f1, f1s, r1, later)
#: Schur parameters of v, and of v_s
AT_START, AT_TIME = parameters(0, NAMES_0), parameters(s, NAMES_1)


def _sum(high: Expr, term: Expr) -> Expr:
    """Sum of term_j w_(l-j), j = 1 .. high."""
    return sum_of(j, 1, high, when(j <= l, term * w(u, l - j), 0))


#: what the lemmas speak of
QUOTIENTS = (
    function(w, [u, k], when(k == 0, 1, -sum_of(j, 1, k, when(j <= n, a[u][j], 0) * w(u, k - j)))),
    function(part, [u, l, i], when(i == 0, 0, part(u, l, i - 1) + when(i <= l, g[u][i] * w(u, l - i), 0))),
    function(e_of, [u, t, l], _sum(n, g[t][j])),
    function(h_of, [u, t, l], w(u, l) + _sum(n, a[t][j] + g[t][j])),
)
OPENED_AT_START = {"supported": [f0, f0s], "closed": [w, e_of, h_of, schur]}
OPENED_AT_BOTH = {"supported": [f0, f0s, f1, f1s], "closed": [w, e_of, h_of, schur, later]}

_AS_SUM = lemma(i, always(u, always(l, forall(v, i, n, part(u, l, i) == _sum(i, g[u][j])))), uses=[use(0, i=i, u=u, l=l, v=v)])
_TIMES_A = lemma(i, always(u, always(k, forall(v, i, n, sum_of(j, 0, k, when(j == 0, 1, when(j <= n, a[u][j], 0)) * part(u, k - j, i))
                                               == when(k <= i, when(k >= 1, g[u][k], 0), 0)))),
                 uses=[use(1, i=i, u=u, k=k, v=v), use(w, u, k - i - 1)])
_AT_INFINITY = fact(t, "laurent", always(k, laurent(strict_of(g[t]) / monic_of(a[t]), k) == part(t, k, n)), n, uses=[use(1, i=n, u=t, k=k, v=n)])
_OPEN = [*(use(x, u, y, z) for x in (e_of, h_of) for y, z in ((t + 1, l), (t, l), (t, l + 1)))]


def step(first: Expr = g) -> dict:
    """A step of the algorithm, solved for what it starts from; with the first entries of g(t), or of what agrees there."""
    return lemma(t, always(u, always(l, (e_of(u, t, l + 1) == e_of(u, t + 1, l) + first[t][1] * h_of(u, t + 1, l))
                                     & (h_of(u, t, l) == h_of(u, t + 1, l) + first[t][1] * e_of(u, t + 1, l)))), direct=True, uses=_OPEN)


def pairing(number: int, at: Any, names: tuple[Expr, ...], first: Expr = g) -> dict:
    """The sums of phi_k and its companion against the coefficients at infinity, as the lemma so numbered; with the first entries of g(t), or of what agrees there."""
    c, f, fs, r, gamma = names
    scale = prod(j, 0, k - 1, 1 - first[at + j][1] ** 2)
    start = [use(2, t=at, k=l + 1), use(0, i=n, u=at, l=l + 1, v=n), use(e_of, at, at, l + 1), use(h_of, at, at, l + 1), use(w, at, l + 1)]
    return lemma(k, (r[k] == scale) & always(l, (sum_of(j, 0, k, coeff(f[k], j) * c(l + 1 + j)) == scale * e_of(at, at + k, l + 1))
                                             & (sum_of(j, 0, k, coeff(fs[k], j) * c(l + 1 + j)) == scale * h_of(at, at + k, l + 1))),
                 uses=[use(gamma, k), *(use(number, k=k, l=x) for x in (0, l, l + 1)), use(3, t=at + k, u=at, l=l + 1), use(e_of, at, at + k, 1)], base=start)


DELETION = (_AS_SUM, _TIMES_A, _AT_INFINITY, step(), pairing(4, 0, NAMES_0), pairing(5, s, NAMES_1))
