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
from exactkf.kernel.limits import WORK, within
from exactkf.kernel.numbers import Undefined

__all__ = ["Interval", "around", "does_not_escape", "enclosed", "generator", "inverse", "is_schur", "minus", "product", "solved", "stable_factor", "times",
           "total"]

Interval = tuple[int, int]


def enclosed(x: Algebraic, bits: int) -> Interval:
    """An interval around an element of a real number field, by Horner's rule on an isolating interval."""
    theta = generator(x.field, bits)
    total: Interval = (0, 0)
    for c in reversed(x.c):
        low, high = times(total, theta, bits)
        total = (low + (c * 2**bits).__floor__(), high + (c * 2**bits).__ceil__())
    return total


def generator(field: AlgebraicField, bits: int) -> Interval:
    """An interval around the generator, made once for each number of bits: whatever the field computes modulo, its generator stays."""
    if bits not in field.enclosures:
        field.enclosures[bits] = _bisected(field, bits)
    return field.enclosures[bits]


def _bisected(field: AlgebraicField, bits: int) -> Interval:
    """The same, by bisection in integers: a change of sign is kept inside."""
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


def times(x: Interval, y: Interval, bits: int) -> Interval:
    """An interval around all products."""
    products = [a * b for a in x for b in y]
    return min(products) >> bits, -(-max(products) >> bits)


def minus(x: Interval, y: Interval) -> Interval:
    """An interval around all differences."""
    return x[0] - y[1], x[1] - y[0]


def inverse(x: Interval, bits: int) -> Interval:
    """An interval around all inverses; zero is excluded."""
    if x[0] <= 0 <= x[1]:
        raise Undefined("an interval does not exclude zero")
    one = 1 << 2 * bits
    return one // x[1], -(-one // x[0])


def solved(rows: list[list[Interval]], right: list[list[Interval]], bits: int) -> list[list[Interval]]:
    """Intervals around A^-1 B for all A and B within intervals: Gauss and Jordan's elimination, whose pivots exclude zero, so that A is regular."""
    n = len(rows)
    work = [[*row, *more] for row, more in zip(rows, right, strict=True)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: max(work[i][k][0], -work[i][k][1]))  # the one that is furthest from zero
        work[k], work[pivot] = work[pivot], work[k]
        unit = inverse(work[k][k], bits)
        work[k] = [times(x, unit, bits) for x in work[k]]
        for i, row in enumerate(work):
            if i != k and row[k] != (0, 0):
                f = row[k]
                work[i] = [minus(x, times(f, y, bits)) if j > k else x for j, (x, y) in enumerate(zip(row, work[k], strict=True))]
    return [row[n:] for row in work]


def is_schur(p: list) -> bool:
    """Whether all zeros of a monic polynomial over a real number field lie inside the circle; none may lie on it.

    By the recursion of Schur and Cohn: p is one if and only if |p(0)| < 1 and (p - p(0) z^n p(1/z)) / z is one.
    """
    bits = 128
    while bits < 1 << 16:
        found = _all_inside([around(x, bits) for x in p], bits)
        if found is not None:
            return found
        bits *= 2
    raise Undefined("the zeros of a polynomial could not be separated from the circle")


def _all_inside(rest: list[Interval], bits: int) -> bool | None:
    """Whether all monic polynomials with coefficients in the intervals have all zeros inside the circle, or none has, or neither is known."""
    one = 1 << bits
    while len(rest) > 1:
        k = rest[0]
        if k[0] > one or k[1] < -one:
            return False
        if not (-one < k[0] and k[1] < one):
            return None
        u = inverse(minus((one, one), times(k, k, bits)), bits)
        rest = [times(minus(x, times(k, y, bits)), u, bits) for x, y in zip(rest, rest[::-1], strict=True)][1:]
    return True


def stable_factor(D: list[Interval], center: list[int], bits: int) -> list[Interval]:
    """Intervals around the coefficients of the monic w with all zeros inside the circle and w(z) w(1/z) = c D(z) for some c.

    D is given as intervals around z^m D, palindromic and without zeros on the circle; the center is close to 2^bits (w_0, ..., w_{m-1}, c).
    With F_k = sum_j w_j w_{j+k} - c d_k, k = 0, ..., m, a box X around the center y, and Y near the inverse of the Jacobian at y, F has a zero in
    K = y - Y F(y) + (I - Y F'(X)) (X - y) if K lies in X (Krawczyk), whatever D is within its intervals.  All polynomials in K have their zeros
    inside, and there is one such w only.
    """
    m, one, rho = len(D) // 2, 1 << bits, 1 << bits - 2 * bits // 5
    if len(center) != m + 1:
        raise Undefined("the center has another length than the unknowns")
    d = D[m:]
    y = [(v, v) for v in center]
    w, c = [*y[:m], (one, one)], y[m]
    rest = [minus(total([times(w[j], w[j + k], bits) for j in range(m + 1 - k)]), times(c, d[k], bits)) for k in range(m + 1)]
    at_y = _jacobian(w, d)
    Y = [[(x, x) for x in row] for row in _near_inverse([[x[0] + x[1] >> 1 for x in row] for row in at_y], bits)]
    J = _jacobian([*((v - rho, v + rho) for v in center[:m]), (one, one)], d)
    out = []
    for i, row in enumerate(Y):
        moved = minus(y[i], total([times(a, b, bits) for a, b in zip(row, rest, strict=True)]))
        wrong = [minus((one, one) if i == j else (0, 0), total([times(a, b, bits) for a, b in zip(row, column, strict=True)]))
                 for j, column in enumerate(zip(*J, strict=True))]
        out.append(total([moved, *(times(x, (-rho, rho), bits) for x in wrong)]))
    if not all(v - rho < lo and hi < v + rho for (lo, hi), v in zip(out, center, strict=True)) or out[m][0] <= 0 <= out[m][1]:
        raise Undefined("the spectral factor is not enclosed")
    if _all_inside([*out[:m], (one, one)], bits) is not True:
        raise Undefined("the spectral factor enclosed may have a zero outside the circle")
    return [*out[:m], (one, one)]


def _near_inverse(rows: list[list[int]], bits: int) -> list[list[int]]:
    """Near the inverse of a matrix over 2^bits; nothing rests on how near.  By Gauss and Jordan's elimination with twice the bits."""
    n = len(rows)
    work = [[x << bits for x in row] + [int(i == j) << 2 * bits for j in range(n)] for i, row in enumerate(rows)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(work[i][k]))
        work[k], work[pivot] = work[pivot], work[k]
        lead = work[k][k]
        if lead == 0:
            raise Undefined("a matrix is nearly singular")
        work[k] = [(x << 2 * bits) // lead for x in work[k]]
        for i, row in enumerate(work):
            f = row[k]
            if i != k and f:
                work[i] = [x - (f * y >> 2 * bits) for x, y in zip(row, work[k], strict=True)]
    return [[x >> bits for x in row[n:]] for row in work]


def _jacobian(w: list[Interval], d: list[Interval]) -> list[list[Interval]]:
    """The derivatives of F_0, ..., F_m in `stable_factor` by w_0, ..., w_{m-1} and c."""
    m = len(w) - 1
    zero: Interval = (0, 0)
    return [[*(total([w[i + k] if i + k <= m else zero, w[i - k] if i >= k else zero]) for i in range(m)), (-d[k][1], -d[k][0])] for k in range(m + 1)]


def total(terms: list[Interval]) -> Interval:
    """An interval around all sums."""
    return sum(x[0] for x in terms), sum(x[1] for x in terms)


def product(p: list[Interval], q: list[Interval], bits: int) -> list[Interval]:
    """Intervals around the coefficients of a product of polynomials."""
    return [total([times(p[i], q[k - i], bits) for i in range(len(p)) if 0 <= k - i < len(q)]) for k in range(len(p) + len(q) - 1)]


def around(x: Any, bits: int) -> Interval:
    """An interval around a rational or algebraic number."""
    return enclosed(x, bits) if isinstance(x, Algebraic) else _rational(x, bits)


def _rational(x: Any, bits: int) -> Interval:
    return (x.numerator << bits) // x.denominator, -((-x.numerator << bits) // x.denominator)


def does_not_escape(Q: list, S: list, steps: int, bits: Any) -> bool:
    """Whether 1 - g^2 excludes zero at all steps before the given one, for a monic pair; see `exactkf.kernel.orbit_n`."""
    if type(bits) is not int or bits <= 0:
        raise Undefined("the number of bits is not a positive integer")
    within(bits * steps, WORK, "bits of the intervals of an orbit")
    one = 1 << bits

    q, s = ([around(x, bits) for x in p] for p in (Q, S))
    for _ in range(steps):
        g = s[-2]
        r = minus((one, one), times(g, g, bits))
        if r[0] <= 0 <= r[1]:
            return False
        u = inverse(r, bits)
        pairs = list(zip(q, [(0, 0), *s[:-1]], strict=True))
        q, s = ([times(minus(x, times(g, y, bits)), u, bits) for x, y in pairs], [times(minus(y, times(g, x, bits)), u, bits) for x, y in pairs])
    return True
