# SPDX-License-Identifier: MIT
"""Elements of a real number field Q(theta).

theta is given by a square-free polynomial and an interval that isolates one
of its roots. Zero is decided by a gcd (at sight where the polynomial is known
to be irreducible), every other sign by interval arithmetic on ever smaller
intervals. Numbers of two different fields do not mix.
"""

from __future__ import annotations

from fractions import Fraction
from math import gcd, lcm
from typing import Any

from exactkf.kernel.limits import DEGREE, within
from exactkf.kernel.numbers import FieldElement, Laurent, Ratio, Undefined, Unknown, fraction
from exactkf.kernel.roots import count_real, divmod_poly, gcd_poly

__all__ = ["Algebraic", "AlgebraicField"]


class AlgebraicField:
    """Q(theta): ``modulus`` lists coefficients from x^0 up, ``lo < theta < hi`` isolates one root.

    ``irreducible`` says that the caller knows the modulus to be irreducible and the roots to be further
    apart than hi - lo, as `exactkf.kernel.cosines` does; a certificate cannot say it.
    """

    def __init__(self, modulus: list[Fraction], lo: Fraction, hi: Fraction, *, irreducible: bool = False) -> None:
        if not irreducible and (len(modulus) < 2 or modulus[-1] == 0 or len(gcd_poly(modulus, [k * c for k, c in enumerate(modulus)][1:])) > 1):
            raise Undefined("the polynomial of a number field must be square-free of positive degree")
        if not lo < hi or _sign_at(modulus, lo) * _sign_at(modulus, hi) >= 0 or not irreducible and count_real(modulus, lo, hi) != 1:
            raise Undefined("the interval of a number field must isolate one root")
        self.lo, self.hi, self.irreducible = lo, hi, irreducible
        self.enclosures: dict[int, tuple[int, int]] = {}  # of the generator, by bits
        self.take(modulus)

    @classmethod
    def of(cls, data: Any) -> AlgebraicField:
        """From a certificate: a list of coefficients and two ends of an interval."""
        modulus, lo, hi = data
        within(len(modulus) - 1, DEGREE, "the degree of a number field")
        return cls([fraction(c) for c in modulus], fraction(lo), fraction(hi))

    def take(self, modulus: list) -> None:
        """Compute modulo this polynomial from now on: in integers, up to a factor."""
        factor = lcm(*(Fraction(c).denominator for c in modulus)) * (1 if modulus[-1] > 0 else -1)
        self.modulus, self.whole = modulus, [int(c * factor) for c in modulus]

    def element(self, coefficients: list) -> Algebraic:
        """A polynomial in theta."""
        below = lcm(*(c.denominator for c in coefficients))
        return self.reduced([c.numerator * (below // c.denominator) for c in coefficients], below)

    def reduced(self, p: list[int], below: int) -> Algebraic:
        """p(theta) over a positive integer; the list is used up."""
        *m, lead = self.whole
        while len(p) > len(m):
            f = p.pop()
            if f and lead != 1:
                p, below = [lead * x for x in p], lead * below
            for i, c in enumerate(m if f else (), len(p) - len(m)):
                if c:
                    p[i] -= f * c
        while p and p[-1] == 0:
            p.pop()
        if below != 1 and (common := gcd(below, *p)) != 1:
            p, below = [x // common for x in p], below // common
        return Algebraic(self, p, below)

    def refine(self) -> None:
        """Halve the isolating interval."""
        mid = (self.lo + self.hi) / 2
        value = _sign_at(self.modulus, mid)
        if value == 0:
            width = (self.hi - self.lo) / 8
            self.lo, self.hi = mid - width, mid + width
        elif value == _sign_at(self.modulus, self.hi):
            self.hi = mid
        else:
            self.lo = mid


def _sign_at(p: list, x: Fraction) -> int:
    """Sign of p(x), in integers."""
    low, _, _ = _enclose(p, x, x)
    return (low > 0) - (low < 0)


class Algebraic(FieldElement):
    """Polynomial in theta, reduced modulo the modulus: integers over a positive one without a common divisor."""

    __slots__ = ("below", "field", "whole")

    def __init__(self, field: AlgebraicField, whole: list[int], below: int = 1) -> None:
        self.field, self.whole, self.below = field, whole, below

    @property
    def c(self) -> list[Fraction]:
        """Coefficients from theta^0 up."""
        return [Fraction(v, self.below) for v in self.whole]

    def _coerce(self, x: Any) -> Algebraic | None:
        if isinstance(x, Algebraic):
            if x.field is not self.field:
                raise Unknown("numbers of two different fields in one term")
            return x
        if hasattr(x, "denominator"):  # int, Fraction, or the faster type of a search
            return Algebraic(self.field, [int(x.numerator)] if x else [], int(x.denominator))
        return None

    def __add__(self, other: Any) -> Any:
        y = self._coerce(other)
        if y is None:
            return NotImplemented
        long, short = (self, y) if len(self.whole) >= len(y.whole) else (y, self)
        common = gcd(long.below, short.below)
        a, b = short.below // common, long.below // common
        out = [a * v for v in long.whole] if a != 1 else list(long.whole)
        for k, v in enumerate(short.whole):
            out[k] += b * v
        return self.field.reduced(out, a * long.below)

    __radd__ = __add__

    def __neg__(self) -> Algebraic:
        return Algebraic(self.field, [-v for v in self.whole], self.below)

    def __sub__(self, other: Any) -> Any:
        return NotImplemented if isinstance(other, (Laurent, Ratio)) else self + (-other)

    def __mul__(self, other: Any) -> Any:
        y = self._coerce(other)
        if y is None:
            return NotImplemented
        out = [0] * max(0, len(self.whole) + len(y.whole) - 1)
        for i, a in enumerate(self.whole):
            for j, b in enumerate(y.whole if a else ()):
                if b:
                    out[i + j] += a * b
        return self.field.reduced(out, self.below * y.below)

    __rmul__ = __mul__

    def inverse(self) -> Algebraic:
        """By the extended Euclidean algorithm in Q[x]; a common factor not vanishing at theta is divided out."""
        if self.sign() == 0:
            raise Undefined("division by zero")
        if len(common := self._common()) > 1:
            self.field.take(divmod_poly([Fraction(c) for c in self.field.modulus], common)[0])
        a, b = [Fraction(c) for c in self.field.modulus], self.field.reduced(list(self.whole), self.below).c
        s: list[Fraction] = []
        t = [Fraction(1)]
        while len(b) > 1:
            q, r = divmod_poly(a, b)
            new = list(s) + [Fraction(0)] * max(0, len(q) + len(t) - 1 - len(s))
            for i, x in enumerate(q):
                for j, y in enumerate(t):
                    new[i + j] -= x * y
            a, b, s, t = b, r, t, new
        return self.field.element([x / b[0] for x in t])

    def _common(self) -> list:
        """Greatest common divisor of this polynomial and the modulus, where it may have a positive degree."""
        return [] if self.field.irreducible else gcd_poly(self.c, [Fraction(c) for c in self.field.modulus])

    def sign(self) -> int:
        """Sign of the real number: zero is decided by a gcd, the rest by interval arithmetic."""
        if not self.whole:
            return 0
        common = self._common()
        if len(common) > 1 and _sign_at(common, self.field.lo) * _sign_at(common, self.field.hi) < 0:
            return 0
        while True:
            low, high, _ = _enclose(self.whole, self.field.lo, self.field.hi)
            if low > 0 or high < 0:
                return 1 if low > 0 else -1
            self.field.refine()

    def enclosed(self, width: Fraction) -> tuple[Fraction, Fraction]:
        """An interval of at most that width around the number."""
        while True:
            low, high, below = _enclose(self.whole, self.field.lo, self.field.hi)
            if Fraction(high - low, below * self.below) <= width:
                return Fraction(low, below * self.below), Fraction(high, below * self.below)
            self.field.refine()

    def __eq__(self, other: object) -> bool:
        y = self._coerce(other)
        if y is None:
            return NotImplemented
        return self.whole == y.whole and self.below == y.below if self.field.irreducible else (self - y).sign() == 0

    __hash__ = None  # type: ignore[assignment]

    def __lt__(self, other: Any) -> bool: return (self - other).sign() < 0
    def __gt__(self, other: Any) -> bool: return (self - other).sign() > 0
    def __le__(self, other: Any) -> bool: return (self - other).sign() <= 0
    def __ge__(self, other: Any) -> bool: return (self - other).sign() >= 0


def _enclose(p: list, lo: Fraction, hi: Fraction) -> tuple[int, int, int]:
    """Interval Horner: numerators of two bounds, and their denominator, which is positive.

    After k steps the denominator is q d^(k - 1), q that of the coefficients and d that of lo and hi.
    """
    q, d = lcm(*(c.denominator for c in p)), lcm(lo.denominator, hi.denominator)
    left, right = (x.numerator * (d // x.denominator) for x in (lo, hi))
    a, b, below = 0, 0, 1
    for k, c in enumerate(reversed(p)):
        below *= d if k else 1
        products = (a * left, a * right, b * left, b * right)
        shift = c.numerator * (q // c.denominator) * below
        a, b = min(products) + shift, max(products) + shift
    return a, b, q * below
