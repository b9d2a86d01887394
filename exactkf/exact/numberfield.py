# SPDX-License-Identifier: MIT
r"""Real number fields Q(theta).

A `RealField` is given by a polynomial and a rational interval that holds exactly
one of its real roots, theta.  Its elements are polynomials in theta of degree
less than the degree of the field; equality is equality of coefficients, and the
sign is decided exactly.

Notation
--------
`cyclotomic_real` is the field :math:`\mathbb Q(2\cos(2\pi/n))`, the real part of the
n-th cyclotomic field, where :math:`2\cos(2\pi k/n) = C_k(2\cos(2\pi/n))` with
:math:`C_0 = 2`, :math:`C_1 = x`, :math:`C_{k+1} = x C_k - C_{k-1}`.

Choice of algorithm
-------------------
An element is zero exactly when its coefficients are, because the minimal
polynomial is irreducible.  Otherwise its sign is read off a ball: theta is enclosed
by Newton's interval method, and the precision doubles until the ball leaves
zero out, which it must.  In Q(2 cos(2 pi/47)), degree 23, a sign takes about 5 us
this way once theta is known to 64 bits; counting roots with a Sturm sequence
takes 290 us.

References
----------
H. Cohen, A Course in Computational Algebraic Number Theory, section 4.2.
R. E. Moore, R. B. Kearfott, M. J. Cloud, Introduction to Interval Analysis, chapter 8.
"""

from __future__ import annotations

import numbers
from collections.abc import Mapping
from fractions import Fraction
from functools import total_ordering
from typing import Any

from flint import arb, fmpq, fmpq_mat, fmpq_poly, fmpz, fmpz_poly

from exactkf._errors import BadInput
from exactkf.exact._messages import bad, shown
from exactkf.exact.balls import ball, precision
from exactkf.exact.balls import sign as ball_sign
from exactkf.exact.polynomials import RealRoot, count_real_roots, isolate_real_roots, polynomial, refine_root
from exactkf.exact.rationals import rational

__all__ = ["CyclotomicRealField", "RealField", "RealNumber", "cyclotomic_real", "sqrt_field"]

_START_BITS = 64


class RealField:
    """The field Q(theta), theta the only root of a polynomial in a closed interval.

    Parameters
    ----------
    minpoly : polynomial over Q
        If it is reducible, the irreducible factor that vanishes at theta is taken.
    interval : pair of rational numbers
        Ends lo <= hi such that the polynomial has exactly one root in [lo, hi].
    name : str, optional
        How theta is printed.

    Attributes
    ----------
    minpoly : fmpq_poly
        The monic minimal polynomial of theta.
    root : RealRoot
        An isolating interval of theta.
    index : int
        The number of real roots of `minpoly` less than theta.

    Raises
    ------
    BadInput
        If the polynomial is zero, or has no root or several roots in the interval.

    Examples
    --------
    >>> field = RealField([-2, 0, 1], (1, 2), "r")
    >>> r = field.gen()
    >>> 1 / (r - 1)
    r + 1
    >>> 7 * r > 10, 5 * r > 8
    (False, False)
    """

    __slots__ = ("_derivative", "_enclosures", "_integral", "_narrow", "index", "minpoly", "name", "root")

    def __init__(self, minpoly: Any, interval: Any, name: str = "theta") -> None:
        p = polynomial(minpoly, name="minpoly")
        if p.degree() < 1:
            raise bad("minpoly", "is constant", p, "pass a polynomial of positive degree")
        lo, hi = _ends(interval)
        found = count_real_roots(p, lo, hi)
        if found != 1:
            raise bad(
                "interval",
                f"holds {found or 'no'} real roots of {shown(p)}",
                (str(lo), str(hi)),
                "pass one that holds 1",
            )
        factor = next(f for f, _ in p.factor()[1] if count_real_roots(f, lo, hi) == 1)
        self.minpoly = factor / factor.leading_coefficient()
        self.root = next(r for r in isolate_real_roots(factor) if _is_inside(r, lo, hi))
        self.index = count_real_roots(factor, None, self.root.lo) - (self.root.lo == self.root.hi)
        self.name = name
        self._integral: fmpz_poly = factor.numer()
        self._derivative: fmpz_poly = self._integral.derivative()
        self._narrow: RealRoot = self.root
        self._enclosures: dict[int, arb] = {}

    @property
    def degree(self) -> int:
        """The degree of the field over Q."""
        return self.minpoly.degree()

    def __repr__(self) -> str:
        return f"RealField({self.minpoly}, ({self.root.lo}, {self.root.hi}), {self.name!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, RealField) and self.index == other.index and self.minpoly == other.minpoly

    def __hash__(self) -> int:
        return hash((self.index, tuple(self.minpoly.coeffs())))

    def __reduce__(self) -> tuple:
        ends = (str(self.root.lo), str(self.root.hi))
        return RealField, ([str(c) for c in self.minpoly.coeffs()], ends, self.name)

    def gen(self) -> RealNumber:
        """Return theta."""
        return self._reduced(fmpq_poly([0, 1]))

    def __call__(self, x: Any) -> RealNumber:
        """Return x as an element.

        Parameters
        ----------
        x : RealNumber of this field, rational number, or polynomial (list of coefficients) in theta

        Raises
        ------
        BadInput
            If x belongs to another field or is not a number.
        """
        if isinstance(x, RealNumber):
            if x.field != self:
                raise bad("x", f"is not in Q({self.name})", x, "pass an element of this field")
            return x
        if isinstance(x, (list, tuple, fmpq_poly, fmpz_poly)):
            return self._reduced(polynomial(x, name="x"))
        return RealNumber(self, fmpq_poly([rational(x)]))

    def enclose_gen(self, bits: int) -> arb:
        """Return a ball around theta of relative accuracy about `bits` bits."""
        if bits not in self._enclosures:
            self._enclosures[bits] = self._newton(bits)
        return self._enclosures[bits]

    def to_data(self) -> dict[str, Any]:
        """Return plain data: strings for the polynomial, the interval and the name."""
        return {
            "minpoly": [str(c) for c in self.minpoly.coeffs()],
            "interval": [str(self.root.lo), str(self.root.hi)],
            "name": self.name,
        }

    @staticmethod
    def from_data(data: Mapping[str, Any]) -> RealField:
        """Return the field that `to_data` wrote; BadInput if the data do not describe one."""
        try:
            return RealField(data["minpoly"], data["interval"], data["name"])
        except (KeyError, TypeError):
            raise bad("data", "is not a real number field", data, "pass what to_data returned") from None

    def _reduced(self, p: fmpq_poly) -> RealNumber:
        """Return the element p(theta)."""
        return RealNumber(self, p % self.minpoly if p.degree() >= self.degree else p)

    def _newton(self, bits: int) -> arb:
        """Return a ball around theta with about `bits` good bits."""
        if self.root.lo == self.root.hi:
            with precision(bits):
                return ball(self.root.lo)
        root = self._narrow
        while True:
            with precision(max(bits + 32, 2 * _fineness(root) + 64)):  # where another root is near, few bits would never tell them apart
                x = ball(root.lo).union(ball(root.hi))
                if not self._derivative(x).contains(0):
                    self._narrow = root
                    return self._nearer(x)
            root = refine_root(root, (root.hi - root.lo) / 4)

    def _nearer(self, x: arb) -> arb:
        """Return a ball around theta that is as small as the precision allows, from one on which the derivative does not vanish."""
        width = x.rad()
        while True:
            mid = x.mid()
            x = x.intersection(mid - self._integral(mid) / self._derivative(x))
            if 2 * x.rad() > width:  # no more progress at this precision
                return x
            width = x.rad()


def _fineness(root: RealRoot) -> int:
    """The number of bits after which the ends of an interval differ, roughly."""
    ratio = (abs(root.lo) + abs(root.hi)) / (root.hi - root.lo)
    return int(ratio.p // ratio.q).bit_length()


@total_ordering
class RealNumber:
    """An element of a `RealField`; make one from the field's generator by arithmetic.

    Arithmetic (``+ - * / **``) and comparison mix with `int`, `Fraction` and
    `fmpq`.  Elements are immutable and hashable.

    Attributes
    ----------
    field : RealField
    poly : fmpq_poly
        The polynomial in theta, of degree less than that of the field.
    """

    __slots__ = ("field", "poly")

    def __init__(self, field: RealField, poly: fmpq_poly) -> None:
        self.field = field
        self.poly = poly

    def __repr__(self) -> str:
        return self.poly.str().replace("x", self.field.name)

    def __reduce__(self) -> tuple:
        return _rebuilt, (self.field, [str(c) for c in self.poly.coeffs()])

    def is_rational(self) -> bool:
        """Return whether the element is a rational number."""
        return self.poly.degree() <= 0

    def rational_value(self) -> fmpq:
        """Return the rational number this is; BadInput if it is irrational."""
        if not self.is_rational():
            raise BadInput(f"the number {shown(self)} is irrational; use enclose for its digits")
        return self.poly[0]

    def sign(self) -> int:
        """Return -1, 0 or 1."""
        if self.is_rational():
            value = self.poly[0]
            return (value > 0) - (value < 0)
        bits, numerator = _START_BITS, self.poly.numer()
        while True:
            with precision(bits):
                found = ball_sign(numerator(self.field.enclose_gen(bits)))
            if found:
                return found
            bits *= 2

    def enclose(self, digits: int = 15) -> arb:
        """Return a ball around the number with relative error at most ``10**-digits``.

        Raises
        ------
        BadInput
            If `digits` is not a positive integer.
        """
        if not isinstance(digits, int) or digits < 1:
            raise bad("digits", "is not a number of digits", digits, "pass a positive integer")
        wanted = digits * 10 // 3 + 2
        bits = max(_START_BITS, wanted + 32)
        while True:
            with precision(bits):
                value = self.poly.numer()(self.field.enclose_gen(bits)) / self.poly.denom()
                if self.poly == 0 or value.rel_accuracy_bits() > wanted:
                    return value
            bits *= 2

    def minimal_polynomial(self) -> fmpq_poly:
        """Return the monic minimal polynomial over Q."""
        n = self.field.degree
        rows, power = [], self.poly
        for _ in range(n):
            rows.append([power[k] for k in range(n)])
            power = (power * fmpq_poly([0, 1])) % self.field.minpoly
        p = fmpq_mat(rows).charpoly()  # a power of the minimal polynomial
        p = p // p.gcd(p.derivative())
        return p / p.leading_coefficient()

    def __bool__(self) -> bool:
        return self.poly != 0

    def __eq__(self, other: object) -> bool:
        if isinstance(other, RealNumber):
            return self.poly == other.poly if other.field == self.field else self._equals(other)
        return self.poly == rational(other) if _is_scalar(other) else NotImplemented

    def _equals(self, other: RealNumber) -> bool:
        """Return whether an element of another field is the same real number."""
        p = self.minimal_polynomial()
        if p != other.minimal_polynomial():
            return False
        return _root_index(p, self) == _root_index(p, other)

    def __hash__(self) -> int:
        if self.is_rational():
            return hash(self.poly[0])
        return hash(tuple(self.minimal_polynomial().coeffs()))

    def __lt__(self, other: Any) -> bool:
        other = self._coerced(other)
        return other if other is NotImplemented else (self - other).sign() < 0

    def __neg__(self) -> RealNumber:
        return RealNumber(self.field, -self.poly)

    def __pos__(self) -> RealNumber:
        return self

    def __abs__(self) -> RealNumber:
        return -self if self.sign() < 0 else self

    def __add__(self, other: Any) -> RealNumber:
        other = self._coerced(other)
        return other if other is NotImplemented else RealNumber(self.field, self.poly + other.poly)

    __radd__ = __add__

    def __sub__(self, other: Any) -> RealNumber:
        other = self._coerced(other)
        return other if other is NotImplemented else RealNumber(self.field, self.poly - other.poly)

    def __rsub__(self, other: Any) -> RealNumber:
        return -self + other

    def __mul__(self, other: Any) -> RealNumber:
        other = self._coerced(other)
        return other if other is NotImplemented else self.field._reduced(self.poly * other.poly)

    __rmul__ = __mul__

    def inverse(self) -> RealNumber:
        """Return 1/x; ZeroDivisionError if the element is zero."""
        if self.poly == 0:
            raise ZeroDivisionError(f"division by zero in Q({self.field.name})")
        _, s, _ = self.poly.xgcd(self.field.minpoly)  # the gcd is 1: the minimal polynomial is irreducible
        return self.field._reduced(s)

    def __truediv__(self, other: Any) -> RealNumber:
        other = self._coerced(other)
        return other if other is NotImplemented else self * other.inverse()

    def __rtruediv__(self, other: Any) -> RealNumber:
        return self.inverse() * other

    def __pow__(self, n: int) -> RealNumber:
        if not isinstance(n, int):
            return NotImplemented
        base = self if n >= 0 else self.inverse()
        result = self.field(1)
        for bit in bin(abs(n))[2:]:
            result = result * result
            if bit == "1":
                result = result * base
        return result

    def _coerced(self, x: Any) -> Any:
        """Return x as an element of the same field, or NotImplemented."""
        if isinstance(x, RealNumber):
            return x if x.field is self.field else self.field(x)
        return self.field(x) if _is_scalar(x) else NotImplemented


class CyclotomicRealField(RealField):
    """The field Q(2 cos(2 pi/n)); see `cyclotomic_real`."""

    __slots__ = ("n",)

    def __init__(self, n: int) -> None:
        if not isinstance(n, int) or isinstance(n, bool) or n < 1:
            raise bad("n", "is not a positive integer", n, "pass n >= 1")
        p = fmpz_poly.cos_minpoly(n)
        self.n = n
        # every root is 2 cos(2 pi k/n) with k prime to n; the generator is the largest
        largest = isolate_real_roots(p)[-1]
        super().__init__(p, (largest.lo, largest.hi), f"2cos(2pi/{n})")

    def __reduce__(self) -> tuple:
        return CyclotomicRealField, (self.n,)

    def two_cos(self, k: int) -> RealNumber:
        """Return 2 cos(2 pi k/n)."""
        k = k % self.n
        k = min(k, self.n - k)
        x, before, now = fmpq_poly([0, 1]), fmpq_poly([0, 1]), fmpq_poly([2])  # C_{-1} = C_1 = x, C_0 = 2
        for _ in range(k):
            before, now = now, (x * now - before) % self.minpoly
        return self._reduced(now)


def cyclotomic_real(n: int) -> CyclotomicRealField:
    """Return the field Q(2 cos(2 pi/n)), whose generator is 2 cos(2 pi/n).

    For sines, 2 sin(2 pi k/n) = 2 cos(2 pi (n - 4 k)/(4 n)) is in the field of 4 n.

    Raises
    ------
    BadInput
        If n is not a positive integer.

    Examples
    --------
    >>> field = cyclotomic_real(5)
    >>> field.two_cos(1) * field.two_cos(2) == -1
    True
    """
    return CyclotomicRealField(n)


def sqrt_field(d: Any) -> RealField:
    """Return the field Q(sqrt(d)), whose generator is the nonnegative square root of d.

    It is Q itself, with a rational generator, if d is a square.

    Raises
    ------
    BadInput
        If d is not a nonnegative rational number.
    """
    d = rational(d, name="d")
    if d < 0:
        raise bad("d", "is negative", d, "pass d >= 0")
    return RealField([-d, 0, 1], (0, d + 1), f"sqrt({d})")


def _ends(interval: Any) -> tuple[fmpq, fmpq]:
    """Return the ends of an interval as rational numbers."""
    if not isinstance(interval, (tuple, list)) or len(interval) != 2:
        raise bad("interval", "is not a pair of ends", interval, "pass (lo, hi)")
    lo, hi = interval
    lo, hi = rational(lo, name="interval[0]"), rational(hi, name="interval[1]")
    if lo > hi:
        raise bad("interval", "has its ends exchanged", (str(lo), str(hi)), "pass (lo, hi) with lo <= hi")
    return lo, hi


def _is_inside(root: RealRoot, lo: fmpq, hi: fmpq) -> bool:
    """Return whether the root lies in [lo, hi], whose irrational roots are not its ends."""
    if root.lo == root.hi:
        return lo <= root.lo <= hi
    left, right = max(lo, root.lo), min(hi, root.hi)
    return left < right and count_real_roots(root.factor, left, right) == 1


def _root_index(p: fmpq_poly, x: RealNumber) -> int:
    """Return which of the real roots of its minimal polynomial p the number x is."""
    return sum((x - root.lo).sign() > 0 for root in isolate_real_roots(p)) - 1


def _rebuilt(field: RealField, coefficients: list[str]) -> RealNumber:
    """Return the element with the given coefficients, for pickling."""
    return field([rational(c) for c in coefficients])


def _is_scalar(x: Any) -> bool:
    """Return whether `x` is a number that arithmetic accepts without being told so."""
    return isinstance(x, (int, fmpq, fmpz, Fraction, numbers.Rational)) and not isinstance(x, bool)
