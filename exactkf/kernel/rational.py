# SPDX-License-Identifier: MIT
"""Rational numbers as the evaluation of statements needs them: often, and mostly with their like or with integers.

Main definitions
----------------
`Rational`
    A Fraction whose sums, products, quotients and comparisons with its like and with ints take a third of the time; all else is that of Fraction.
`quotient`
    One integer over another.
"""

from __future__ import annotations

from fractions import Fraction
from math import gcd
from typing import Any

__all__ = ["Rational", "quotient"]


class Rational(Fraction):
    """Numerator and denominator without a common divisor, the denominator positive."""

    __slots__ = ()
    _numerator: int  # the places in which Fraction keeps them
    _denominator: int

    def __add__(self, other: Any) -> Any:
        if type(other) is Rational:
            return _lowest(self._numerator * other._denominator + other._numerator * self._denominator, self._denominator * other._denominator)
        if type(other) is int:
            return _made(self._numerator + other * self._denominator, self._denominator)
        return Fraction.__add__(self, other)

    def __sub__(self, other: Any) -> Any:
        if type(other) is Rational:
            return _lowest(self._numerator * other._denominator - other._numerator * self._denominator, self._denominator * other._denominator)
        if type(other) is int:
            return _made(self._numerator - other * self._denominator, self._denominator)
        return Fraction.__sub__(self, other)

    def __mul__(self, other: Any) -> Any:
        if type(other) is Rational:
            return _lowest(self._numerator * other._numerator, self._denominator * other._denominator)
        if type(other) is int:
            return _lowest(self._numerator * other, self._denominator)
        return Fraction.__mul__(self, other)

    def __truediv__(self, other: Any) -> Any:
        if type(other) is Rational:
            return quotient(self._numerator * other._denominator, self._denominator * other._numerator)
        if type(other) is int:
            return quotient(self._numerator, self._denominator * other)
        return Fraction.__truediv__(self, other)

    def __radd__(self, other: Any) -> Any:
        return self + other if type(other) is int else Fraction.__radd__(self, other)

    def __rsub__(self, other: Any) -> Any:
        return _made(other * self._denominator - self._numerator, self._denominator) if type(other) is int else Fraction.__rsub__(self, other)

    def __rmul__(self, other: Any) -> Any:
        return self * other if type(other) is int else Fraction.__rmul__(self, other)

    def __rtruediv__(self, other: Any) -> Any:
        return quotient(other * self._denominator, self._numerator) if type(other) is int else Fraction.__rtruediv__(self, other)

    def __neg__(self) -> Rational:
        return _made(-self._numerator, self._denominator)

    def __eq__(self, other: object) -> bool:
        if type(other) is Rational:
            return self._numerator == other._numerator and self._denominator == other._denominator
        return self._denominator == 1 and self._numerator == other if type(other) is int else Fraction.__eq__(self, other)

    __hash__ = Fraction.__hash__

    def __lt__(self, other: Any) -> bool:
        return self._numerator < other * self._denominator if type(other) is int else Fraction.__lt__(self, other)

    def __gt__(self, other: Any) -> bool:
        return self._numerator > other * self._denominator if type(other) is int else Fraction.__gt__(self, other)


def _made(p: int, q: int) -> Rational:
    """p/q in lowest terms already, q positive."""
    made = object.__new__(Rational)
    made._numerator, made._denominator = p, q
    return made


def _lowest(p: int, q: int) -> Rational:
    """p/q for a positive q."""
    common = gcd(p, q)
    return _made(p, q) if common == 1 else _made(p // common, q // common)


def quotient(p: int, q: int) -> Rational:
    """p/q; ZeroDivisionError for q = 0."""
    if not q:
        raise ZeroDivisionError("division by zero")
    return _lowest(p, q) if q > 0 else _lowest(-p, -q)
