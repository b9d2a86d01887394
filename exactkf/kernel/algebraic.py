# SPDX-License-Identifier: MIT
"""Elements of a real number field Q(theta).

theta is given by a square-free polynomial and an interval that isolates one
of its roots. Zero is decided by a gcd (at sight where the polynomial is known
to be irreducible), every other sign by interval arithmetic on ever smaller
intervals. Numbers of two different fields do not mix.
"""

from __future__ import annotations

from fractions import Fraction
from math import lcm
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
        self.modulus, self.lo, self.hi, self.irreducible = _whole(modulus) if irreducible else modulus, lo, hi, irreducible

    @classmethod
    def of(cls, data: Any) -> AlgebraicField:
        """From a certificate: a list of coefficients and two ends of an interval."""
        modulus, lo, hi = data
        within(len(modulus) - 1, DEGREE, "the degree of a number field")
        return cls([fraction(c) for c in modulus], fraction(lo), fraction(hi))

    def tidy(self, p: list) -> list:
        """Coefficients in the type that arithmetic in this field expects: ints where they are integers and the modulus is known."""
        return _whole(p) if self.irreducible else p

    def element(self, coefficients: list) -> Algebraic:
        return Algebraic(self, _remainder(coefficients, self.modulus))

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


def _whole(p: list) -> list:
    """Coefficients that are integers as ints, with which arithmetic is faster."""
    return [c.numerator if c.denominator == 1 else c for c in p]


def _exact(p: list) -> list[Fraction]:
    """Coefficients that may be divided by each other."""
    return [Fraction(c) for c in p]


def _sign_at(p: list, x: Fraction) -> int:
    """Sign of p(x), in integers."""
    low, _, _ = _enclose(p, x, x)
    return (low > 0) - (low < 0)


def _remainder(p: list, m: list) -> list:
    p = list(p)
    while len(p) >= len(m):
        f = p[-1] if m[-1] == 1 else Fraction(p[-1]) / m[-1]
        if f:
            for i, c in enumerate(m[:-1], len(p) - len(m)):
                if c:
                    p[i] -= f * c
        p.pop()
    while p and p[-1] == 0:
        p.pop()
    return p


class Algebraic(FieldElement):
    """Polynomial in theta, reduced modulo the modulus."""

    __slots__ = ("c", "field")

    def __init__(self, field: AlgebraicField, coefficients: list) -> None:
        self.field, self.c = field, coefficients

    def _coerce(self, x: Any) -> Algebraic | None:
        if isinstance(x, Algebraic):
            if x.field is not self.field:
                raise Unknown("numbers of two different fields in one term")
            return x
        if type(x) is int and self.field.irreducible:
            return Algebraic(self.field, [x] if x else [])
        if hasattr(x, "denominator"):  # int, Fraction, or the faster type of a search
            return Algebraic(self.field, self.field.tidy([Fraction(int(x.numerator), int(x.denominator))]) if x else [])
        return None

    def __add__(self, other: Any) -> Any:
        y = self._coerce(other)
        if y is None:
            return NotImplemented
        long, short = (self.c, y.c) if len(self.c) >= len(y.c) else (y.c, self.c)
        out = [v + short[k] if k < len(short) else v for k, v in enumerate(long)]
        while out and out[-1] == 0:
            out.pop()
        return Algebraic(self.field, out)

    __radd__ = __add__

    def __neg__(self) -> Algebraic:
        return Algebraic(self.field, [-v for v in self.c])

    def __sub__(self, other: Any) -> Any:
        return NotImplemented if isinstance(other, (Laurent, Ratio)) else self + (-other)

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, (int, Fraction)):
            return Algebraic(self.field, self.field.tidy([v * other for v in self.c]) if other else [])
        y = self._coerce(other)
        if y is None:
            return NotImplemented
        out: list = [0 if self.field.irreducible else Fraction(0)] * max(0, len(self.c) + len(y.c) - 1)
        for i, a in enumerate(self.c):
            for j, b in enumerate(y.c if a else ()):
                if b:
                    out[i + j] += a * b
        return self.field.element(out)

    __rmul__ = __mul__

    def inverse(self) -> Algebraic:
        """By the extended Euclidean algorithm in Q[x]; a common factor not vanishing at theta is divided out."""
        if self.sign() == 0:
            raise Undefined("division by zero")
        common = [] if self.field.irreducible else gcd_poly(_exact(self.c), _exact(self.field.modulus))
        if len(common) > 1:
            self.field.modulus = divmod_poly(_exact(self.field.modulus), common)[0]
        a, b = _exact(self.field.modulus), _exact(_remainder(self.c, self.field.modulus))
        s: list[Fraction] = []
        t = [Fraction(1)]
        while len(b) > 1:
            q, r = divmod_poly(a, b)
            new = list(s) + [Fraction(0)] * max(0, len(q) + len(t) - 1 - len(s))
            for i, x in enumerate(q):
                for j, y in enumerate(t):
                    new[i + j] -= x * y
            a, b, s, t = b, r, t, new
        return self.field.element(self.field.tidy([x / b[0] for x in t]))

    def sign(self) -> int:
        """Sign of the real number: zero is decided by a gcd, the rest by interval arithmetic."""
        if not self.c:
            return 0
        common = [] if self.field.irreducible else gcd_poly(_exact(self.c), _exact(self.field.modulus))
        if len(common) > 1 and _sign_at(common, self.field.lo) * _sign_at(common, self.field.hi) < 0:
            return 0
        while True:
            low, high, _ = _enclose(self.c, self.field.lo, self.field.hi)
            if low > 0 or high < 0:
                return 1 if low > 0 else -1
            self.field.refine()

    def enclosed(self, width: Fraction) -> tuple[Fraction, Fraction]:
        """An interval of at most that width around the number."""
        while True:
            low, high, below = _enclose(self.c, self.field.lo, self.field.hi)
            if Fraction(high - low, below) <= width:
                return Fraction(low, below), Fraction(high, below)
            self.field.refine()

    def __eq__(self, other: object) -> bool:
        y = self._coerce(other)
        if y is None:
            return NotImplemented
        return self.c == y.c if self.field.irreducible else (self - y).sign() == 0

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
