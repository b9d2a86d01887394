# SPDX-License-Identifier: MIT
"""Cosines of rational multiples of pi in the checker, against known values and against another library."""

from __future__ import annotations

from fractions import Fraction
from math import gcd

import mpmath
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from exactkf.kernel import cosines
from exactkf.kernel.algebraic import Algebraic, AlgebraicField, _enclose, _sign_at
from exactkf.kernel.cosines import cosine, minimal_polynomial
from exactkf.kernel.numbers import Undefined, Unknown


def test_rational_cosines():
    """The cosines that are rational numbers, in every quadrant."""
    expected = {(0, 1): 1, (1, 3): Fraction(1, 2), (1, 2): 0, (2, 3): Fraction(-1, 2), (1, 1): -1, (5, 3): Fraction(1, 2), (-4, 6): Fraction(-1, 2)}
    actual = {angle: cosine(*angle) for angle in expected}
    assert expected == actual


@pytest.mark.parametrize("n", range(3, 61))
def test_minimal_polynomials(n):
    """Coefficients agree with sympy's minimal polynomial of 2 cos(2 pi/n)."""
    if n > 30 and n % 7:
        pytest.skip("one in seven of the long ones is enough")
    x = sympy.Symbol("x")
    expected = sympy.minimal_polynomial(2 * sympy.cos(2 * sympy.pi / n), x, polys=True).all_coeffs()[::-1]
    assert expected == minimal_polynomial(n)


@given(st.integers(1, 60), st.integers(-150, 150))
def test_the_root_is_the_right_one(p, q):
    """The isolating interval holds 2 cos(pi q/p) and no other root, and the number compares as its decimals do."""
    c = cosine(q, p)
    with mpmath.workdps(40):
        near = mpmath.cos(mpmath.pi * q / p)
        if isinstance(c, int | Fraction):
            assert near == pytest.approx(float(c), abs=1e-12)
        else:
            assert c.field.lo < Fraction(str(abs(2 * near))) < c.field.hi
            below = Fraction(int(mpmath.floor(near * 10**9)), 10**9)
            assert below < c < below + Fraction(1, 10**9)
            AlgebraicField(c.field.modulus, c.field.lo, c.field.hi)  # refuses an interval with two roots


@given(st.integers(4, 40), st.integers(1, 39), st.integers(2, 6))
def test_multiple_angles(p, q, k):
    """The Chebyshev recursion in cos(x) gives cos(kx), compared by sign with the other field's number."""
    c, before, now = cosine(q, p), 1, cosine(q, p)
    for _ in range(k - 1):
        before, now = now, 2 * c * now - before
    with mpmath.workdps(30):
        near = mpmath.cos(mpmath.pi * q * k / p)
        low = Fraction(int(mpmath.floor(near * 10**9)) - 1, 10**9)
    assert low < now < low + Fraction(3, 10**9)
    if gcd(q * k, p) == p:
        assert now == (-1) ** (q * k // p)


def test_zero_is_exact():
    """1 + 2 cos(2 pi/5) + 2 cos(4 pi/5) is zero; its neighbour is not."""
    c = cosine(2, 5)
    assert 1 + 2 * c + 2 * (2 * c * c - 1) == 0
    assert 1 + 2 * c + 2 * (2 * c * c - 1) + Fraction(1, 10**40) != 0


def test_fields_do_not_mix():
    """Numbers of different fields are refused, not silently taken for one another."""
    with pytest.raises(Unknown, match="two different fields"):
        cosine(1, 5) + cosine(1, 7)


@pytest.mark.parametrize("angle", [(1, 0), (1, -3), (Fraction(1, 2), 3), (True, 3)])
def test_bad_angles(angle):
    """Only integers over positive integers are angles."""
    with pytest.raises(Undefined, match="needs integers"):
        cosine(*angle)


def test_denominators_beyond_the_enclosure(monkeypatch):
    """Where the enclosure of pi is too wide for the separation of the roots, the answer is refused."""
    monkeypatch.setattr(cosines, "_PI", (Fraction(3), Fraction(4)))
    with pytest.raises(Undefined, match="too large for the enclosure"):
        cosines._generator.__wrapped__(5, 47)


def test_long_fields_are_refused():
    """A denominator beyond the stated limit gets no answer instead of an endless computation."""
    with pytest.raises(Unknown, match="1000"):
        cosine(1, 1001)


FRACTIONS = st.fractions(min_value=-3, max_value=3, max_denominator=40)


@given(st.lists(FRACTIONS, max_size=6), FRACTIONS, FRACTIONS, st.integers(0, 8))
def test_intervals_in_integers_hold_the_values(p, one, other, at):
    """Interval Horner over one denominator encloses the polynomial's values, and is exact at a point."""
    lo, hi = min(one, other), max(one, other)
    x = lo + (hi - lo) * Fraction(at, 8)
    value = sum((c * x**k for k, c in enumerate(p)), Fraction(0))
    low, high, below = _enclose(p, lo, hi)
    assert below > 0 and Fraction(low, below) <= value <= Fraction(high, below)
    assert _sign_at(p, x) == (value > 0) - (value < 0)


@given(st.integers(3, 40), st.integers(1, 30), FRACTIONS, FRACTIONS)
def test_arithmetic_in_the_field_of_a_cosine(p, q, a, b):
    """Whether coefficients are ints or fractions: the values are those of the decimals, and what is divided comes back."""
    x = cosine(q, p)
    y = a * x * x + b
    close = mpmath.mpf(a.numerator) / a.denominator * mpmath.cos(mpmath.pi * q / p) ** 2 + mpmath.mpf(b.numerator) / b.denominator
    if isinstance(y, Algebraic):
        low, high = y.enclosed(Fraction(1, 10**9))
        assert abs(mpmath.mpf(low.numerator) / low.denominator - close) < 1e-8
        assert all(type(c) is int or isinstance(c, Fraction) for c in (y * y - y).c)
        if y != 0:
            assert (x / y) * y == x
