# SPDX-License-Identifier: MIT
"""Orbits and zeros over real number fields in interval arithmetic.

An interval is a pair of integers (lo, hi) that stands for [lo, hi] / 2^bits; every operation
rounds outwards. What an interval excludes is excluded.
"""

from __future__ import annotations

from fractions import Fraction
from math import ceil, floor, lcm
from typing import Any

from exactkf.kernel.algebraic import Algebraic, AlgebraicField
from exactkf.kernel.numbers import Undefined

__all__ = ["does_not_escape", "enclosed", "generator", "is_schur"]

Interval = tuple[int, int]


def enclosed(x: Algebraic, bits: int) -> Interval:
    """An interval around an element of a real number field, by Horner's rule on an isolating interval."""
    theta = generator(x.field, bits)
    total: Interval = (0, 0)
    for c in reversed(x.c):
        low, high = _times(total, theta, bits)
        total = (low + (c * 2**bits).__floor__(), high + (c * 2**bits).__ceil__())
    return total


def generator(field: AlgebraicField, bits: int) -> Interval:
    """An interval around the generator, by bisection in integers: a change of sign is kept inside."""
    common = lcm(*(c.denominator for c in field.modulus))
    p = [int(c * common) for c in field.modulus]

    def positive(k: int) -> bool | None:
        """The sign of the polynomial at k / 2^bits; None at the root."""
        total, scale = 0, 1
        for c in reversed(p):
            total, scale = total * k + c * scale, scale << bits
        return total > 0 if total else None

    low, high = ceil(field.lo * 2**bits), floor(field.hi * 2**bits)
    if low > high:
        return floor(field.lo * 2**bits), ceil(field.hi * 2**bits)
    at_low, at_high = positive(low), positive(high)
    if at_low is None or at_high is None:
        return (low, low) if at_low is None else (high, high)
    if at_low == at_high:  # the root is between an end of the field's interval and the next dyadic number
        return (floor(field.lo * 2**bits), low) if at_low == (_value_above(field) > 0) else (high, ceil(field.hi * 2**bits))
    while high - low > 1:
        mid = (low + high) // 2
        value = positive(mid)
        if value is None:
            return mid, mid
        low, high = (mid, high) if value == at_low else (low, mid)
    return low, high


def _value_above(field: AlgebraicField) -> Fraction:
    """The value of the polynomial at the upper end of the isolating interval."""
    total = Fraction(0)
    for c in reversed(field.modulus):
        total = total * field.hi + c
    return total


def _times(x: Interval, y: Interval, bits: int) -> Interval:
    products = [a * b for a in x for b in y]
    return min(products) >> bits, -(-max(products) >> bits)


def _minus(x: Interval, y: Interval) -> Interval:
    return x[0] - y[1], x[1] - y[0]


def _inverse(x: Interval, bits: int) -> Interval:
    if x[0] <= 0 <= x[1]:
        raise Undefined("an interval does not exclude zero")
    one = 1 << 2 * bits
    return one // x[1], -(-one // x[0])


def is_schur(p: list) -> bool:
    """Whether all zeros of a monic polynomial over a real number field lie inside the circle; none may lie on it.

    By the recursion of Schur and Cohn: p is one if and only if |p(0)| < 1 and (p - p(0) z^n p(1/z)) / z is one.
    """
    bits = 128
    while bits < 1 << 16:
        one = 1 << bits
        rest = [enclosed(x, bits) if isinstance(x, Algebraic) else _rational(x, bits) for x in p]
        while len(rest) > 1:
            k = rest[0]
            if k[0] > one or k[1] < -one:
                return False
            if not (-one < k[0] and k[1] < one):
                break  # undecided at this precision
            u = _inverse(_minus((one, one), _times(k, k, bits)), bits)
            rest = [_times(_minus(x, _times(k, y, bits)), u, bits) for x, y in zip(rest, rest[::-1], strict=True)][1:]
        else:
            return True
        bits *= 2
    raise Undefined("the zeros of a polynomial could not be separated from the circle")


def _rational(x: Any, bits: int) -> Interval:
    return (x.numerator << bits) // x.denominator, -((-x.numerator << bits) // x.denominator)


def does_not_escape(Q: list, S: list, steps: int, bits: Any) -> bool:
    """Whether 1 - g^2 excludes zero at all steps before the given one, for a monic pair; see `exactkf.kernel.orbit_n`."""
    if type(bits) is not int or not 0 < bits < 10**6:
        raise Undefined("the number of bits is not a positive integer")
    one = 1 << bits

    q, s = ([enclosed(x, bits) if isinstance(x, Algebraic) else _rational(x, bits) for x in p] for p in (Q, S))
    for _ in range(steps):
        g = s[-2]
        r = _minus((one, one), _times(g, g, bits))
        if r[0] <= 0 <= r[1]:
            return False
        u = _inverse(r, bits)
        pairs = list(zip(q, [(0, 0), *s[:-1]], strict=True))
        q, s = ([_times(_minus(x, _times(g, y, bits)), u, bits) for x, y in pairs], [_times(_minus(y, _times(g, x, bits)), u, bits) for x, y in pairs])
    return True
