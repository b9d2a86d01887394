# SPDX-License-Identifier: MIT
"""Exact scalars and polynomials in z.

Main definitions
----------------
`Laurent`
    Polynomials and pseudo-polynomials in z over any scalars: {exponent: coefficient}.
`Ratio`
    Quotients of them, compared by cross-multiplication.
`Symbolic`
    Rational functions in named variables: an integer polynomial over a product
    of powers of recorded factors. Every factor ever divided by is kept in the
    field, so that the denominators of an identity are known.
`Algebraic`
    Elements of a real number field Q(theta), theta given by a polynomial and an
    interval that isolates one root.

A scalar is an int, a Fraction, a Symbolic, an Algebraic, or any other number
type with exact ``+ - * / ==``. A quantity that divides by zero is not defined:
`Undefined` is raised.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

__all__ = [
    "Algebraic", "AlgebraicField", "Laurent", "Ratio", "Symbolic", "SymbolicField", "Undefined", "Unknown", "divide", "rational",
    "rationals", "sign",
]


class Undefined(Exception):
    """The term has no value on this instance (a division by zero)."""


class Unknown(Exception):
    """This evaluator has no exact answer to the question."""


_rational: Callable[[int, int], Any] = Fraction


@contextmanager
def rationals(make: Callable[[int, int], Any]) -> Iterator[None]:
    """Another type for quotients of integers, such as a faster one for a search; replaying uses Fraction."""
    global _rational
    before, _rational = _rational, make
    try:
        yield
    finally:
        _rational = before


def rational(p: int, q: int) -> Any:
    """p / q in the type of quotients in force."""
    return _rational(p, q)


def divide(x: Any, y: Any) -> Any:
    """x / y, exact also for two ints."""
    if y == 0:
        raise Undefined("division by zero")
    return _rational(x, y) if isinstance(x, int) and isinstance(y, int) else x / y


def sign(x: Any) -> int:
    """-1, 0 or 1."""
    if isinstance(x, (Symbolic, Laurent, Ratio)):
        raise Unknown("sign of a quantity with variables")
    return (x > 0) - (x < 0)


def _is_matrix(x: Any) -> bool:
    """A matrix (of exactkf.kernel.linear, which imports this module): its own operators apply."""
    return hasattr(x, "nrows")


class Laurent:
    """Sum of c_k z^k over finitely many integers k."""

    __slots__ = ("c",)

    def __init__(self, coefficients: dict[int, Any]) -> None:
        self.c = {k: v for k, v in coefficients.items() if v != 0}

    @classmethod
    def of(cls, x: Any) -> Laurent:
        return x if isinstance(x, Laurent) else cls({0: x})

    @property
    def degree(self) -> int:
        return max(self.c, default=-1)

    @property
    def order(self) -> int:
        return min(self.c, default=0)

    def get(self, k: int) -> Any:
        return self.c.get(k, 0)

    def shift(self, n: int) -> Laurent:
        return Laurent({k + n: v for k, v in self.c.items()})

    def reciprocal(self) -> Laurent:
        """p(1/z)."""
        return Laurent({-k: v for k, v in self.c.items()})

    def dense(self) -> list:
        """Coefficients from z^0 up; refused for negative powers of z."""
        if self.order < 0:
            raise Undefined("negative power of z where a polynomial is needed")
        return [self.get(k) for k in range(self.degree + 1)]

    def __add__(self, other: Any) -> Any:
        if isinstance(other, Ratio) or _is_matrix(other):
            return NotImplemented
        out = dict(self.c)
        for k, v in Laurent.of(other).c.items():
            out[k] = out[k] + v if k in out else v
        return Laurent(out)

    __radd__ = __add__

    def __neg__(self) -> Laurent:
        return Laurent({k: -v for k, v in self.c.items()})

    def __sub__(self, other: Any) -> Any:
        return NotImplemented if isinstance(other, Ratio) or _is_matrix(other) else self + (-other)

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, Ratio) or _is_matrix(other):
            return NotImplemented
        if not isinstance(other, Laurent):
            return Laurent({k: v * other for k, v in self.c.items()})
        out: dict[int, Any] = {}
        for i, x in self.c.items():
            for j, y in other.c.items():
                out[i + j] = out[i + j] + x * y if i + j in out else x * y
        return Laurent(out)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        if _is_matrix(other):
            return NotImplemented
        if isinstance(other, (Laurent, Ratio)):
            return Ratio.of(self) / other
        return Laurent({k: divide(v, other) for k, v in self.c.items()})

    def __rtruediv__(self, other: Any) -> Any:
        return Ratio.of(other) / self

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Ratio) or _is_matrix(other):
            return other == self
        mine, theirs = self.c, Laurent.of(other).c
        return mine.keys() == theirs.keys() and all(v == theirs[k] for k, v in mine.items())

    __hash__ = None  # type: ignore[assignment]


class Ratio:
    """Quotient of two Laurent polynomials; no common factors are removed."""

    __slots__ = ("den", "num")

    def __init__(self, num: Laurent, den: Laurent) -> None:
        if not den.c:
            raise Undefined("division by the zero polynomial")
        if len(den.c) == 1:  # a monomial is a unit
            (k, v), = den.c.items()
            num, den = Laurent({i - k: divide(x, v) for i, x in num.c.items()}), Laurent({0: 1})
        self.num, self.den = num, den

    @classmethod
    def of(cls, x: Any) -> Ratio:
        return x if isinstance(x, Ratio) else cls(Laurent.of(x), Laurent({0: 1}))

    def __add__(self, other: Any) -> Any:
        if _is_matrix(other):
            return NotImplemented
        other = Ratio.of(other)
        if self.den == other.den:
            return Ratio(self.num + other.num, self.den)
        return Ratio(self.num * other.den + other.num * self.den, self.den * other.den)

    __radd__ = __add__

    def __neg__(self) -> Ratio:
        return Ratio(-self.num, self.den)

    def __sub__(self, other: Any) -> Any:
        if _is_matrix(other):
            return NotImplemented
        return self + (-Ratio.of(other))

    def __rsub__(self, other: Any) -> Ratio:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        if _is_matrix(other):
            return NotImplemented
        other = Ratio.of(other)
        return Ratio(self.num * other.num, self.den * other.den)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Ratio:
        other = Ratio.of(other)
        return Ratio(self.num * other.den, self.den * other.num)

    def __rtruediv__(self, other: Any) -> Ratio:
        return Ratio.of(other) / self

    def __eq__(self, other: object) -> bool:
        if _is_matrix(other):
            return other == self
        other = Ratio.of(other)
        return self.num * other.den == other.num * self.den

    __hash__ = None  # type: ignore[assignment]

    def reciprocal(self) -> Ratio:
        """f(1/z)."""
        return Ratio(self.num.reciprocal(), self.den.reciprocal())

    def at_infinity(self, k: int) -> Any:
        """Coefficient of z^-k in the expansion in powers of 1/z."""
        top, lead = self.den.degree, self.den.get(self.den.degree)
        first = self.num.degree - top
        series: list[Any] = []
        for m in range(first + k + 1):
            acc = self.num.get(self.num.degree - m)
            for j in range(1, m + 1):
                acc = acc - self.den.get(top - j) * series[m - j]
            series.append(divide(acc, lead))
        return series[first + k] if first + k >= 0 else 0


# ------------------------------------------------------------------ symbols
_BITS = 12  # bits an exponent takes in a packed monomial
_LIMIT = (1 << (_BITS - 1)) - 1

Poly = dict[int, int]  # packed exponents -> coefficient


def _poly_mul(p: Poly, q: Poly) -> Poly:
    out: Poly = {}
    if len(p) > len(q):
        p, q = q, p
    get = out.get
    for i, x in p.items():
        for j, y in q.items():
            out[i + j] = get(i + j, 0) + x * y
    return {k: v for k, v in out.items() if v}


def _poly_add(p: Poly, q: Poly, a: int = 1, b: int = 1) -> Poly:
    out = {k: a * v for k, v in p.items()} if a != 1 else dict(p)
    for k, v in q.items():
        s = out.get(k, 0) + b * v
        if s:
            out[k] = s
        else:
            del out[k]
    return out


def _degree(p: Poly) -> int:
    """Largest exponent of any variable."""
    mask = (1 << _BITS) - 1
    best = 0
    for k in p:
        while k:
            best = max(best, k & mask)
            k >>= _BITS
    return best


def _exact_quotient(p: Poly, q: Poly) -> Poly | None:
    """p / q if q divides p over the rationals with integer coefficients, else None."""
    lead = max(q)
    c = q[lead]
    rest, out = dict(p), {}
    while rest:
        top = max(rest)
        shift = top - lead
        if shift < 0 or rest[top] % c or any(((top >> s) & ((1 << _BITS) - 1)) < ((lead >> s) & ((1 << _BITS) - 1))
                                             for s in range(0, top.bit_length(), _BITS)):
            return None
        out[shift] = m = rest[top] // c
        for k, v in q.items():
            s = rest.get(k + shift, 0) - m * v
            if s:
                rest[k + shift] = s
            else:
                rest.pop(k + shift, None)
    return out


_PRIME = (1 << 61) - 1


def _may_divide(q: Poly, p: Poly, width: int) -> bool:
    """False only if q does not divide p: both are reduced to one variable modulo a prime."""
    mask = (1 << _BITS) - 1
    main = next(s for s in range(0, width * _BITS, _BITS) if any((k >> s) & mask for k in q))

    def univariate(poly: Poly) -> list[int]:
        out: dict[int, int] = {}
        for k, v in poly.items():
            e, acc, s, i = (k >> main) & mask, v, 0, 3
            k &= ~(mask << main)
            while k:
                if k & mask:
                    acc = acc * pow(1000003 * i + 97, k & mask, _PRIME) % _PRIME
                k >>= _BITS
                i += 1
                s += _BITS
            out[e] = (out.get(e, 0) + acc) % _PRIME
        return [out.get(e, 0) for e in range(max(out, default=0) + 1)]

    a, b = univariate(p), univariate(q)
    while b and b[-1] == 0:
        b.pop()
    if len(b) < 2:
        return True
    inverse = pow(b[-1], -1, _PRIME)
    while len(a) >= len(b):
        f = a[-1] * inverse % _PRIME
        if f:
            for i in range(len(b)):
                a[len(a) - len(b) + i] = (a[len(a) - len(b) + i] - f * b[i]) % _PRIME
        a.pop()
    return not any(a)


class SymbolicField:
    """Rational functions over Q in the variables that `variable` has made.

    ``factors`` lists the polynomials divided by so far.
    """

    def __init__(self) -> None:
        self.names: list[str] = []
        self.factors: list[Poly] = []

    def variable(self, name: str) -> Symbolic:
        self.names.append(name)
        return Symbolic(self, {1 << (_BITS * (len(self.names) - 1)): 1}, 1, ())

    def factor(self, p: Poly) -> list[tuple[int, int]]:
        """Write a polynomial (up to a unit) as a product of recorded factors, recording a new one if need be."""
        powers: list[tuple[int, int]] = []
        for index, f in enumerate(self.factors):
            times = 0
            while len(p) > 1 and _may_divide(f, p, len(self.names)) and (q := _exact_quotient(p, f)) is not None:
                p, times = q, times + 1
            if times:
                powers.append((index, times))
        if len(p) == 1:  # a monomial splits into variables
            (key, _), = p.items()
            for i in range(len(self.names)):
                e = (key >> (_BITS * i)) & ((1 << _BITS) - 1)
                if e:
                    powers.append((self._record({1 << (_BITS * i): 1}), e))
        else:
            powers.append((self._record(p), 1))
        merged: dict[int, int] = {}
        for index, e in powers:
            merged[index] = merged.get(index, 0) + e
        return sorted(merged.items())

    def _record(self, p: Poly) -> int:
        if p in self.factors:
            return self.factors.index(p)
        self.factors.append(p)
        return len(self.factors) - 1

    def text(self, p: Poly) -> str:
        """A polynomial for people."""
        terms = []
        for key in sorted(p, reverse=True):
            powers = [(n, (key >> (_BITS * i)) & ((1 << _BITS) - 1)) for i, n in enumerate(self.names)]
            word = "*".join(n if e == 1 else f"{n}^{e}" for n, e in powers if e)
            c = p[key]
            terms.append(str(c) if not word else word if c == 1 else f"-{word}" if c == -1 else f"{c}*{word}")
        return " + ".join(terms).replace("+ -", "- ") or "0"


class Symbolic:
    """num / (q * product of factor^e): num an integer polynomial, q a positive integer."""

    __slots__ = ("den", "field", "num", "q")

    def __init__(self, field: SymbolicField, num: Poly, q: int, den: tuple) -> None:
        if _LIMIT < 4 * _degree(num):
            raise Unknown("degree too large for symbolic evaluation")
        self.field, self.num, self.q, self.den = field, num, q, den if num else ()

    def _reduced(self) -> Symbolic:
        """Cancel recorded factors from the numerator."""
        if not self.den:
            return self
        num, den = self.num, []
        for index, e in self.den:
            f = self.field.factors[index]
            while e and len(num) >= len(f) // 2 and _may_divide(f, num, len(self.field.names)) \
                    and (r := _exact_quotient(num, f)) is not None:
                num, e = r, e - 1
            if e:
                den.append((index, e))
        return Symbolic(self.field, num, self.q, tuple(den))

    def _coerce(self, x: Any) -> Symbolic | None:
        if isinstance(x, Symbolic):
            return x
        if isinstance(x, int):
            return Symbolic(self.field, {0: x} if x else {}, 1, ())
        if hasattr(x, "denominator"):  # Fraction, or the faster type of a search
            return Symbolic(self.field, {0: int(x.numerator)} if x else {}, int(x.denominator), ())
        return None

    def _lift(self, den: dict[int, int]) -> Poly:
        """Numerator over the larger denominator."""
        num, mine = self.num, dict(self.den)
        for index, e in den.items():
            for _ in range(e - mine.get(index, 0)):
                num = _poly_mul(num, self.field.factors[index])
        return num

    def __add__(self, other: Any) -> Any:
        y = self._coerce(other)
        if y is None:
            return NotImplemented
        if self.den == y.den:
            p, q, den = self.num, y.num, self.den
        else:
            both = dict(self.den)
            for index, e in y.den:
                both[index] = max(e, both.get(index, 0))
            p, q, den = self._lift(both), y._lift(both), tuple(sorted(both.items()))
        if self.q == y.q:
            return Symbolic(self.field, _poly_add(p, q), self.q, den)._reduced()
        return Symbolic(self.field, _poly_add(p, q, y.q, self.q), self.q * y.q, den)._reduced()

    __radd__ = __add__

    def __neg__(self) -> Symbolic:
        return Symbolic(self.field, {k: -v for k, v in self.num.items()}, self.q, self.den)

    def __sub__(self, other: Any) -> Any:
        return NotImplemented if isinstance(other, (Laurent, Ratio)) else self + (-other)

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        y = self._coerce(other)
        if y is None:
            return NotImplemented
        den = dict(self.den)
        for index, e in y.den:
            den[index] = den.get(index, 0) + e
        out = Symbolic(self.field, _poly_mul(self.num, y.num), self.q * y.q, tuple(sorted(den.items())))
        return out._reduced() if self.den or y.den else out

    __rmul__ = __mul__

    def inverse(self) -> Symbolic:
        if not self.num:
            raise Undefined("division by zero")
        num = {0: self.q}
        for index, e in self.den:
            for _ in range(e):
                num = _poly_mul(num, self.field.factors[index])
        if len(self.num) == 1 and 0 in self.num:
            c = self.num[0]
            return Symbolic(self.field, {k: v if c > 0 else -v for k, v in num.items()}, abs(c), ())
        from math import gcd

        content = gcd(*self.num.values())
        if self.num[max(self.num)] < 0:
            content = -content
        powers = self.field.factor({k: v // content for k, v in self.num.items()})
        # factor() drops signs and contents of cofactors only when they are units: restore them exactly
        product: Poly = {0: 1}
        for index, e in powers:
            for _ in range(e):
                product = _poly_mul(product, self.field.factors[index])
        key = max(product)
        unit = Fraction(self.num[key], product[key])
        num = {k: v * unit.denominator * (1 if unit > 0 else -1) for k, v in num.items()}
        return Symbolic(self.field, num, abs(unit.numerator), tuple(powers))._reduced()

    def __truediv__(self, other: Any) -> Any:
        y = self._coerce(other)
        return NotImplemented if y is None else self * y.inverse()

    def __rtruediv__(self, other: Any) -> Any:
        y = self._coerce(other)
        return NotImplemented if y is None else y * self.inverse()

    def __eq__(self, other: object) -> bool:
        if isinstance(other, (int, Fraction)) and other == 0:
            return not self.num
        if isinstance(other, (Laurent, Ratio)) or _is_matrix(other):
            return other == self
        return not (self - other).num

    __hash__ = None  # type: ignore[assignment]

    def __lt__(self, other: Any) -> bool:
        raise Unknown("order of quantities with variables")

    __gt__ = __le__ = __ge__ = __lt__


# ------------------------------------------------------------------ real algebraic numbers
class AlgebraicField:
    """Q(theta): ``modulus`` lists coefficients from x^0 up, ``lo < theta < hi`` isolates one root."""

    def __init__(self, modulus: list[Fraction], lo: Fraction, hi: Fraction) -> None:
        from exactkf.kernel.roots import count_real, gcd_poly

        if len(modulus) < 2 or modulus[-1] == 0 or len(gcd_poly(modulus, [k * c for k, c in enumerate(modulus)][1:])) > 1:
            raise Undefined("the polynomial of a number field must be square-free of positive degree")
        if not lo < hi or _eval(modulus, lo) * _eval(modulus, hi) >= 0 or count_real(modulus, lo, hi) != 1:
            raise Undefined("the interval of a number field must isolate one root")
        self.modulus, self.lo, self.hi = modulus, lo, hi

    def element(self, coefficients: list[Fraction]) -> Algebraic:
        return Algebraic(self, _remainder(coefficients, self.modulus))

    def refine(self) -> None:
        """Halve the isolating interval."""
        mid = (self.lo + self.hi) / 2
        value = _eval(self.modulus, mid)
        if value == 0:
            width = (self.hi - self.lo) / 8
            self.lo, self.hi = mid - width, mid + width
        elif (value > 0) == (_eval(self.modulus, self.hi) > 0):
            self.hi = mid
        else:
            self.lo = mid


def _eval(p: list, x: Any) -> Any:
    acc = Fraction(0)
    for c in reversed(p):
        acc = acc * x + c
    return acc


def _remainder(p: list, m: list) -> list:
    p = list(p)
    while len(p) >= len(m):
        f = Fraction(p[-1]) / m[-1]
        for i in range(len(m)):
            p[len(p) - len(m) + i] -= f * m[i]
        p.pop()
    while p and p[-1] == 0:
        p.pop()
    return p


class Algebraic:
    """Polynomial in theta, reduced modulo the modulus."""

    __slots__ = ("c", "field")

    def __init__(self, field: AlgebraicField, coefficients: list) -> None:
        self.field, self.c = field, coefficients

    def _coerce(self, x: Any) -> Algebraic | None:
        if isinstance(x, Algebraic):
            return x
        if hasattr(x, "denominator"):  # int, Fraction, or the faster type of a search
            return Algebraic(self.field, [Fraction(int(x.numerator), int(x.denominator))] if x else [])
        return None

    def __add__(self, other: Any) -> Any:
        y = self._coerce(other)
        if y is None:
            return NotImplemented
        long, short = (self.c, y.c) if len(self.c) >= len(y.c) else (y.c, self.c)
        return self.field.element([v + (short[k] if k < len(short) else 0) for k, v in enumerate(long)])

    __radd__ = __add__

    def __neg__(self) -> Algebraic:
        return Algebraic(self.field, [-v for v in self.c])

    def __sub__(self, other: Any) -> Any:
        return NotImplemented if isinstance(other, (Laurent, Ratio)) else self + (-other)

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        y = self._coerce(other)
        if y is None:
            return NotImplemented
        out = [Fraction(0)] * max(0, len(self.c) + len(y.c) - 1)
        for i, a in enumerate(self.c):
            for j, b in enumerate(y.c):
                out[i + j] += a * b
        return self.field.element(out)

    __rmul__ = __mul__

    def inverse(self) -> Algebraic:
        """By the extended Euclidean algorithm in Q[x]; a common factor not vanishing at theta is divided out."""
        if self.sign() == 0:
            raise Undefined("division by zero")
        from exactkf.kernel.roots import divmod_poly, gcd_poly

        common = gcd_poly(self.c, self.field.modulus)
        if len(common) > 1:
            self.field.modulus = divmod_poly(self.field.modulus, common)[0]
        a, b = self.field.modulus, _remainder(self.c, self.field.modulus)
        s, t = [], [Fraction(1)]
        while len(b) > 1:
            q, r = divmod_poly(a, b)
            new = list(s) + [Fraction(0)] * max(0, len(q) + len(t) - 1 - len(s))
            for i, x in enumerate(q):
                for j, y in enumerate(t):
                    new[i + j] -= x * y
            a, b, s, t = b, r, t, new
        return self.field.element([x / b[0] for x in t])

    def __truediv__(self, other: Any) -> Any:
        y = self._coerce(other)
        return NotImplemented if y is None else self * y.inverse()

    def __rtruediv__(self, other: Any) -> Any:
        y = self._coerce(other)
        return NotImplemented if y is None else y * self.inverse()

    def sign(self) -> int:
        """Sign of the real number: zero is decided by a gcd, the rest by interval arithmetic."""
        if not self.c:
            return 0
        from exactkf.kernel.roots import gcd_poly

        common = gcd_poly(self.c, self.field.modulus)
        if len(common) > 1 and _eval(common, self.field.lo) * _eval(common, self.field.hi) < 0:
            return 0
        while True:
            low, high = _enclose(self.c, self.field.lo, self.field.hi)
            if low > 0 or high < 0:
                return 1 if low > 0 else -1
            self.field.refine()

    def __eq__(self, other: object) -> bool:
        y = self._coerce(other)
        return NotImplemented if y is None else (self - y).sign() == 0

    __hash__ = None  # type: ignore[assignment]

    def __lt__(self, other: Any) -> bool: return (self - other).sign() < 0
    def __gt__(self, other: Any) -> bool: return (self - other).sign() > 0
    def __le__(self, other: Any) -> bool: return (self - other).sign() <= 0
    def __ge__(self, other: Any) -> bool: return (self - other).sign() >= 0


def _enclose(p: list, lo: Fraction, hi: Fraction) -> tuple[Fraction, Fraction]:
    """Interval Horner."""
    a = b = Fraction(0)
    for c in reversed(p):
        products = (a * lo, a * hi, b * lo, b * hi)
        a, b = min(products) + c, max(products) + c
    return a, b
