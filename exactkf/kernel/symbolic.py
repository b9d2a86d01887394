# SPDX-License-Identifier: MIT
"""Rational functions in named variables.

An element is an integer polynomial over a product of powers of recorded
factors. Every factor ever divided by is kept in the field, so that the
denominators of an identity are known. No gcd is taken: recorded factors are
cancelled by exact division, after a quick test modulo a prime.

Monomials are packed into one int, so many bits an exponent; a product of
monomials is a sum of ints.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from math import gcd
from typing import Any

from exactkf.kernel.numbers import Laurent, Ratio, Undefined, Unknown, is_matrix

__all__ = ["Symbolic", "SymbolicField"]


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


@lru_cache(maxsize=1 << 18)
def _reduced_monomial(key: int, main: int) -> tuple[int, int]:
    """Exponent of the main variable, and the value of the rest modulo the prime at a fixed point."""
    mask = (1 << _BITS) - 1
    exponent, value, place = (key >> main) & mask, 1, 3
    key &= ~(mask << main)
    while key:
        if key & mask:
            value = value * pow(1000003 * place + 97, key & mask, _PRIME) % _PRIME
        key >>= _BITS
        place += 1
    return exponent, value


def _univariate(p: Poly, main: int) -> list[int]:
    out: dict[int, int] = {}
    for key, c in p.items():
        e, value = _reduced_monomial(key, main)
        out[e] = (out.get(e, 0) + c * value) % _PRIME
    return [out.get(e, 0) for e in range(max(out, default=0) + 1)]


def _divides(small: int, big: int) -> bool:
    """Divisibility of packed monomials."""
    mask = (1 << _BITS) - 1
    while small:
        if (small & mask) > (big & mask):
            return False
        small >>= _BITS
        big >>= _BITS
    return True


def _remainder_vanishes(a: list[int], b: list[int]) -> bool:
    """b divides a modulo the prime (also if b has no term left)."""
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


def _may_divide(q: Poly, p: Poly, width: int) -> bool:
    """False only if q does not divide p.

    First by the first and last terms. Then, if q has one variable, by the terms of p that agree with its
    first (its last) term in all others; else in one variable, the others being given values modulo a prime.
    """
    first, last = max(p), min(p)
    if not (_divides(max(q), first) and _divides(min(q), last)):
        return False
    mask = (1 << _BITS) - 1
    main = next(s for s in range(0, width * _BITS, _BITS) if any((k >> s) & mask for k in q))
    others = ~(mask << main)
    if any(k & others for k in q):
        return _remainder_vanishes(_univariate(p, main), _univariate(q, main))
    for rest in {first & others, last & others}:
        part = {k - rest: c for k, c in p.items() if k & others == rest}
        if not _remainder_vanishes(_univariate(part, main), _univariate(q, main)):
            return False
    return True


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
        if isinstance(other, (Laurent, Ratio)) or is_matrix(other):
            return other == self
        return not (self - other).num

    __hash__ = None  # type: ignore[assignment]

    def __lt__(self, other: Any) -> bool:
        raise Unknown("order of quantities with variables")

    __gt__ = __le__ = __ge__ = __lt__
