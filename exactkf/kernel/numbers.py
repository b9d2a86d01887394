# SPDX-License-Identifier: MIT
"""Exact scalars and polynomials in z.

Main definitions
----------------
`Laurent`
    Polynomials and pseudo-polynomials in z over any scalars: {exponent: coefficient}.
`Ratio`
    Quotients of them, compared by cross-multiplication.

A scalar is an int, a Fraction, a `exactkf.kernel.symbolic.Symbolic`, a
`exactkf.kernel.algebraic.Algebraic`, or any other number type with exact
``+ - * / ==``. A quantity that divides by zero is not defined:
`Undefined` is raised.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

__all__ = ["FieldElement", "Laurent", "Ratio", "Rejected", "Undefined", "Unknown", "added", "divide", "fraction", "need", "rational", "rationals", "sign"]


class Undefined(Exception):
    """The term has no value on this instance (a division by zero)."""


class Unknown(Exception):
    """This evaluator has no exact answer to the question."""


class Rejected(Exception):
    """A step of the certificate does not replay."""


def need(condition: bool, step: str) -> None:
    """Raise `Undefined` with the step that does not follow, unless the condition holds."""
    if not condition:
        raise Undefined(step)


class FieldElement:
    """Subtraction from the left and division, for numbers with ``+``, ``-x``, ``*``, `inverse` and `_coerce`."""

    __slots__ = ()

    def __rsub__(self, other: Any) -> Any:
        return -self + other  # type: ignore[operator]

    def __truediv__(self, other: Any) -> Any:
        y = self._coerce(other)  # type: ignore[attr-defined]
        return NotImplemented if y is None else self * y.inverse()  # type: ignore[operator]

    def __rtruediv__(self, other: Any) -> Any:
        y = self._coerce(other)  # type: ignore[attr-defined]
        return NotImplemented if y is None else y * self.inverse()  # type: ignore[attr-defined]


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


_DIGITS = 600  # the least limit that Python can be given
_EXACT = re.compile(r"[-+]?[0-9]+(/[0-9]+|\.[0-9]+)?")


def fraction(data: Any) -> Fraction:
    """An int, ``"p/q"`` or a decimal of a certificate; powers of ten, whose digits nobody could wait for, are refused."""
    if type(data) is int:
        return Fraction(data)
    if isinstance(data, str) and _EXACT.fullmatch(data):
        p, slash, q = data.partition("/")
        return Fraction(_integer(p), _integer(q)) if slash else Fraction(data) if "." in data else Fraction(_integer(data))
    raise Undefined(f"{str(data)[:40]!r} is no exact number")


def _integer(text: str) -> int:
    """An integer of any length; `int` alone refuses thousands of digits, as it would take a time that grows with their square."""
    if len(text) <= _DIGITS:
        return int(text)
    low = len(text) // 2
    high = _integer(text[:-low])
    rest = _integer(text[-low:])
    return high * 10**low + (-rest if text[0] == "-" else rest)


def divide(x: Any, y: Any) -> Any:
    """x / y, exact also for two ints."""
    if y == 0:
        raise Undefined("division by zero")
    return _rational(x, y) if isinstance(x, int) and isinstance(y, int) else x / y


def added(terms: Sequence[Any]) -> Any:
    """Sum of quantities of any kinds, 0 if there are none."""
    if len(terms) > 2:
        k = next((k for k, x in enumerate(terms) if isinstance(x, FieldElement) and hasattr(x, "plus")), None)
        if k is not None and (found := terms[k].plus([*terms[:k], *terms[k + 1:]])) is not NotImplemented:
            return found
    return sum(terms[1:], terms[0]) if terms else 0


def sign(x: Any) -> int:
    """-1, 0 or 1."""
    if isinstance(x, (Laurent, Ratio)):
        raise Unknown("sign of a quantity with variables")
    return (x > 0) - (x < 0)


def is_matrix(x: Any) -> bool:
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
        if isinstance(other, Ratio) or is_matrix(other):
            return NotImplemented
        out = dict(self.c)
        for k, v in Laurent.of(other).c.items():
            out[k] = out[k] + v if k in out else v
        return Laurent(out)

    __radd__ = __add__

    def __neg__(self) -> Laurent:
        return Laurent({k: -v for k, v in self.c.items()})

    def __sub__(self, other: Any) -> Any:
        return NotImplemented if isinstance(other, Ratio) or is_matrix(other) else self + (-other)

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, Ratio) or is_matrix(other):
            return NotImplemented
        if not isinstance(other, Laurent):
            return Laurent({k: v * other for k, v in self.c.items()})
        out: dict[int, list] = {}
        for i, x in self.c.items():
            for j, y in other.c.items():
                out.setdefault(i + j, []).append(x * y)
        return Laurent({k: added(terms) for k, terms in out.items()})

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        if is_matrix(other):
            return NotImplemented
        if isinstance(other, (Laurent, Ratio)):
            return Ratio.of(self) / other
        return Laurent({k: divide(v, other) for k, v in self.c.items()})

    def __rtruediv__(self, other: Any) -> Any:
        return Ratio.of(other) / self

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Ratio) or is_matrix(other):
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
        if is_matrix(other):
            return NotImplemented
        other = Ratio.of(other)
        if self.den == other.den:
            return Ratio(self.num + other.num, self.den)
        return Ratio(self.num * other.den + other.num * self.den, self.den * other.den)

    __radd__ = __add__

    def __neg__(self) -> Ratio:
        return Ratio(-self.num, self.den)

    def __sub__(self, other: Any) -> Any:
        if is_matrix(other):
            return NotImplemented
        return self + (-Ratio.of(other))

    def __rsub__(self, other: Any) -> Ratio:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        if is_matrix(other):
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
        if is_matrix(other):
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
            known = [-self.den.get(top - j) * series[m - j] for j in range(1, m + 1)]
            series.append(divide(added([self.num.get(self.num.degree - m), *known]), lead))
        return series[first + k] if first + k >= 0 else 0
