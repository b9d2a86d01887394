# SPDX-License-Identifier: MIT
"""The factor of D with its zeros in the closed unit disc, enclosed in intervals.

D is given as z^m D, palindromic, and keeps one sign on the circle, so that its zeros there have even multiplicity.

Main definitions
----------------
`check_circle_part`   what is said about the zeros of D on the circle is all of them
`enclosed_factor`     intervals around the monic w with w(z) w(1/z) proportional to D and no zero outside the disc

Main statements
---------------
The zeros on the circle are those of an exact e, with half of their multiplicity, and pairs z, 1/z of zeros of z^2 - xz + 1, each given by
an interval around x and half of the multiplicity, k.  D/e^2 has neither 1 nor -1 as a zero, so its square-free factors f are palindromic, and those
zeros of f that are on the circle are twice as many as the zeros of f in x = z + 1/z between -2 and 2.  As many disjoint intervals at whose ends
f in x has opposite signs hold one each.

What is left of D when e^2 and the (z^2 - xz + 1)^2k are divided out has no zeros on the circle.  Division by a monic polynomial takes no division of
numbers, so it is done in intervals, and `exactkf.kernel.intervals.stable_factor` encloses the stable factor of every polynomial within them.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from exactkf.kernel.intervals import Interval, around, minus, product, stable_factor
from exactkf.kernel.numbers import need, sign
from exactkf.kernel.roots import chebyshev, circle_sign_of, count_circle, divmod_poly, squarefree, times_poly, value_at

__all__ = ["Pair", "check_circle_part", "enclosed_factor"]

#: An interval around x, and half of the multiplicity.
Pair = tuple[Fraction, Fraction, int]


def check_circle_part(D: list, e: list, pairs: Sequence[Pair]) -> None:
    """Accept if e and the pairs are all zeros of D on the circle, with half of their multiplicity."""
    need(e[-1] == 1 and e[0] * e[0] == 1 and all(x == e[0] * y for x, y in zip(e, e[::-1], strict=True)), "a zero of e is not on the circle")
    need(len(e) == 1 or count_circle(e)[1] == len(e) - 1, "a zero of e is not on the circle")
    rest, left = divmod_poly(D, times_poly(e, e))
    need(not left, "e^2 does not divide D")
    if not pairs:
        need(len(rest) == 1 or circle_sign_of(rest) in ("+", "-"), "D has other zeros on the circle than the squares of e")
        return
    need(all(type(k) is int and k > 0 for _, _, k in pairs), "half of a multiplicity is not a positive integer")
    named = 0
    for f, multiplicity in squarefree(rest):
        inside, on, _ = count_circle(f)
        if on:
            paired = f == f[::-1] and len(f) % 2 == 1 and value_at(f, 1) != 0 and value_at(f, -1) != 0
            need(multiplicity % 2 == 0 and paired and inside + on + inside == len(f) - 1,
                  "the zeros on the circle do not come in pairs of even multiplicity")
            mine = sorted((lo, hi) for lo, hi, k in pairs if 2 * k == multiplicity)
            need(2 * len(mine) == on, f"there are {on} zeros of multiplicity {multiplicity} on the circle")
            need(all(-2 <= lo < hi <= 2 for lo, hi in mine) and all(a[1] <= b[0] for a, b in zip(mine, mine[1:], strict=False)), "the intervals overlap")
            in_x = chebyshev(f)
            need(all(sign(value_at(in_x, lo)) * sign(value_at(in_x, hi)) < 0 for lo, hi in mine), "an interval may not hold a zero")
            named += len(mine)
    need(named == len(pairs), "a pair is not on the circle")


def enclosed_factor(D: list, e: list, pairs: Sequence[Pair], center: list[int], bits: int) -> list[Interval]:
    """Intervals around the coefficients of w, for what `check_circle_part` accepts."""
    d = [around(x, bits) for x in divmod_poly(D, times_poly(e, e))[0]]
    circle = [around(x, bits) for x in e]
    for lo, hi, k in pairs:
        low, high = around(lo, bits)[0], around(hi, bits)[1]
        one: Interval = (1 << bits, 1 << bits)
        factor = [one, (-high, -low), one]
        for _ in range(k):
            circle = product(circle, factor, bits)
            d = _quotient(_quotient(d, factor, bits), factor, bits)
    w = stable_factor(d, center, bits) if len(d) > 1 else [(1 << bits, 1 << bits)]
    return product(w, circle, bits)


def _quotient(p: list[Interval], q: list[Interval], bits: int) -> list[Interval]:
    """Of an exact division by a monic polynomial."""
    p, out = list(p), []
    for _ in range(len(p) - len(q) + 1):
        c = p[-1]
        out.append(c)
        shift = len(p) - len(q)
        for i, x in enumerate(product([c], q, bits)):
            p[shift + i] = minus(p[shift + i], x)
        p.pop()
    return out[::-1]
