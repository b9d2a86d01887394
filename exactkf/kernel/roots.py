# SPDX-License-Identifier: MIT
"""Root location for polynomials over an ordered field, exact, with multiplicities.

A polynomial is its list of coefficients from x^0 up.

Roots inside, on and outside the unit circle: zeros at 0 are split off; g =
gcd(p, p*) holds the roots on the circle and those whose reciprocal is a root
too. What is left has neither, so that the Schur-Cohn matrix is nonsingular
and its inertia counts. In g the roots +-1 are split off, the rest is written
in x = z + 1/z and its real roots in (-2, 2) are counted by Sturm chains of
the square-free factors.

References: Schur (1917), Cohn (1922), Sturm (1829), Yun (1976).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import Any

from exactkf.kernel.linear import Matrix, inertia
from exactkf.kernel.numbers import Laurent, Undefined, divide, sign

__all__ = ["chebyshev", "circle_sign", "circle_sign_of", "count_circle", "count_real", "divmod_poly", "gcd_poly", "squarefree", "times_poly", "value_at"]


def _trim(p: list) -> list:
    p = list(p)
    while p and p[-1] == 0:
        p.pop()
    return p


def divmod_poly(p: list, q: list) -> tuple[list, list]:
    """Quotient and remainder."""
    p, q = _trim(p), _trim(q)
    out: list[Any] = [0] * max(0, len(p) - len(q) + 1)
    while len(p) >= len(q):
        out[len(p) - len(q)] = f = divide(p[-1], q[-1])
        for i in range(len(q) - 1):
            p[len(p) - len(q) + i] = p[len(p) - len(q) + i] - f * q[i]
        p.pop()
        p = _trim(p)
    return out, p


def gcd_poly(p: list, q: list) -> list:
    """Greatest common divisor, monic ([] for two zeros)."""
    p, q = _trim(p), _trim(q)
    while q:
        p, q = q, divmod_poly(p, q)[1]
        if q:
            q = [divide(c, q[-1]) for c in q]
    return [divide(c, p[-1]) for c in p]


def _derivative(p: list) -> list:
    return [k * c for k, c in enumerate(p)][1:]


def squarefree(p: list) -> list[tuple[list, int]]:
    """Pairs (factor, multiplicity)."""
    out = []
    g = gcd_poly(p, _derivative(p))
    w, k = divmod_poly(p, g)[0], 1
    while len(w) > 1:
        y = gcd_poly(w, g)
        f = divmod_poly(w, y)[0]
        if len(f) > 1:
            out.append((f, k))
        w, g, k = y, divmod_poly(g, y)[0], k + 1
    return out


def value_at(p: list, x: Any) -> Any:
    """Value of a polynomial, from the constant up."""
    acc: Any = 0
    for c in reversed(p):
        acc = acc * x + c
    return acc


def times_poly(p: Sequence, q: Sequence) -> list:
    """Product of polynomials, from the constant up; of one without coefficients, zeros."""
    out: list[Any] = [0] * max(0, len(p) + len(q) - 1)
    for i, x in enumerate(p):
        for j, y in enumerate(q):
            out[i + j] = out[i + j] + x * y
    return out


def count_real(p: list, lo: Any, hi: Any) -> int:
    """Number of distinct real roots x with lo < x <= hi, by Sturm's theorem."""
    p = _trim(p)
    if not p:
        raise Undefined("the zero polynomial has no root count")
    if hi <= lo:
        return 0
    chain = _sturm_chain(p)
    if len(chain[-1]) > 1:  # multiple roots: the chain divided by the last is one of the square-free part
        chain = [divmod_poly(q, chain[-1])[0] for q in chain]

    def changes(x: Any) -> int:
        signs = [s for s in (sign(value_at(q, x)) for q in chain) if s]
        return sum(a != b for a, b in zip(signs, signs[1:], strict=False))

    return changes(lo) - changes(hi)


def _sturm_chain(p: list) -> list[list]:
    """p, its derivative, and the negative remainders, the last of which is the greatest common divisor; each up to a positive factor."""
    rational = all(isinstance(c, (int, Fraction)) for c in p)
    chain = [_primitive(p), _primitive(_derivative(p))] if rational else [p, _derivative(p)]
    while chain[-1]:
        rest = _integral_remainder(chain[-2], chain[-1]) if rational else divmod_poly(chain[-2], chain[-1])[1]
        chain.append([-c for c in rest])
    chain.pop()
    return chain


def _primitive(p: list) -> list[int]:
    """The polynomial with coprime integer coefficients that is a positive multiple of a rational one."""
    common = lcm(*(c.denominator for c in p))
    integral = [int(c * common) for c in p]
    content = gcd(*integral) or 1
    return [c // content for c in integral]


def _integral_remainder(p: list[int], q: list[int]) -> list[int]:
    """A positive multiple of the remainder of integer polynomials, in integers."""
    lead, side = abs(q[-1]), 1 if q[-1] > 0 else -1
    while len(p) >= len(q):
        f, shift = side * p[-1], len(p) - len(q)
        p = [lead * c for c in p]
        for i, c in enumerate(q):
            p[shift + i] -= f * c
        p = _trim(p)
    return _primitive(p) if p else []


def _strip(p: list, root: int) -> tuple[list, int]:
    """Divide out (x - root) as often as it goes."""
    times = 0
    while len(p) > 1 and value_at(p, root) == 0:
        p, times = divmod_poly(p, [-root, 1])[0], times + 1
    return p, times


def chebyshev(palindrome: list) -> list:
    """G with z^m G(z + 1/z) = g(z) for a palindromic g of degree 2m."""
    m = (len(palindrome) - 1) // 2
    previous, current = [2], [0, 1]  # z^k + z^-k as polynomials in x
    out = [palindrome[m]] + [0] * m
    for k in range(1, m + 1):
        for i, c in enumerate(current):
            out[i] = out[i] + c * palindrome[m + k]
        following = [0, *current]
        for i, c in enumerate(previous):
            following[i] -= c
        previous, current = current, following
    return _trim(out)


def _schur_cohn_inside(p: list) -> int:
    """Roots in |z| < 1 of a polynomial that shares none with its reversal."""
    n = len(p) - 1
    if n == 0:
        return 0
    top = [[p[n - i + j] if j <= i else 0 for j in range(n)] for i in range(n)]
    low = [[p[i - j] if j <= i else 0 for j in range(n)] for i in range(n)]
    a, b = Matrix(top), Matrix(low)
    plus, _minus, zero = inertia(a * a.transpose() - b * b.transpose())
    if zero:
        raise Undefined("Schur-Cohn matrix of a polynomial that shares a root with its reversal")
    return plus


def count_circle(p: list) -> tuple[int, int, int]:
    """Roots with |z| < 1, = 1, > 1, with multiplicity."""
    p = _trim(p)
    if not p:
        raise Undefined("the zero polynomial has no root count")
    p, inside = _strip(p, 0)
    g = gcd_poly(p, p[::-1])
    rest = divmod_poly(p, g)[0]
    mine = _schur_cohn_inside(rest)
    outside = len(rest) - 1 - mine
    g, ones = _strip(g, 1)
    g, minus_ones = _strip(g, -1)
    on = ones + minus_ones
    pairs = 0
    if len(g) > 1:
        for factor, k in squarefree(chebyshev(g)):
            pairs += 2 * k * count_real(factor, -2, 2)
    half = (len(g) - 1 - pairs) // 2
    return inside + mine + half, on + pairs, outside + half


def circle_sign(d: Laurent) -> str:
    """Sign of a pseudo-polynomial on |z| = 1: '+', '0+', '0', '-0', '-' or '+-'."""
    if any(d.get(k) != d.get(-k) for k in d.c):
        raise Undefined("not symmetric under z -> 1/z, so not real on the circle")
    if not d.c:
        return "0"
    m = d.degree
    g = chebyshev([d.get(k - m) for k in range(2 * m + 1)])
    inside = [(count_real(f, -2, 2) - (value_at(f, 2) == 0), k) for f, k in (squarefree(g) if len(g) > 1 else [])]
    if any(count > 0 and k % 2 for count, k in inside):
        return "+-"
    touches = value_at(g, -2) == 0 or value_at(g, 2) == 0 or any(count > 0 for count, _ in inside)
    # g keeps one sign on (-2, 2): any point that is not a root shows it
    x: Any = 0
    while value_at(g, x) == 0:
        x = divide(x + 2, 3) if x else divide(g[-1] - g[-1] + 1, 7)  # a scalar of the type of the coefficients
    positive = sign(value_at(g, x)) > 0
    return ("0+" if touches else "+") if positive else ("-0" if touches else "-")


def circle_sign_of(D: list) -> str:
    """The sign of D on the circle, from the list of the coefficients of z^m D."""
    m = len(D) // 2
    return circle_sign(Laurent({k - m: c for k, c in enumerate(D)}))
