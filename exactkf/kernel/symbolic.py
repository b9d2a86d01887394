# SPDX-License-Identifier: MIT
"""Rational functions in named variables.

An element is an integer polynomial over a product of powers of recorded
factors. Every factor ever divided by is kept in the field, so that the
denominators of an identity are known; factors in one variable are split off
when a denominator is recorded. No other gcd is taken: recorded factors are
cancelled by exact division, after a quick test modulo a prime, or where
`exactkf.kernel.trials` tells that it succeeds.

Numerators and factors are polynomials of `exactkf.kernel.packed`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import Any

from exactkf.kernel.numbers import FieldElement, Laurent, Ratio, Rejected, Undefined, Unknown, is_matrix
from exactkf.kernel.packed import BITS, Divisor, Poly, add, content, exponents, mul
from exactkf.kernel.trials import Trials

__all__ = ["Symbolic", "SymbolicField"]


_ONE: Poly = {0: 1}


class SymbolicField:
    """Rational functions over Q in the variables that `variable` has made.

    ``factors`` lists the polynomials divided by so far, ``used`` the numbers of those divided by since somebody emptied it.
    """

    def __init__(self, trials: Trials | None = None) -> None:
        self.names: list[str] = []
        self.factors: list[Poly] = []
        self.used: set[int] = set()
        self.divisors: list[Divisor] = []
        self.trials = Trials() if trials is None else trials
        self._products: dict[tuple, Divisor] = {}

    def variable(self, name: str) -> Symbolic:
        self.names.append(name)
        return Symbolic(self, {1 << (BITS * (len(self.names) - 1)): 1}, 1, ())

    def cancel(self, p: Poly, index: int, most: int) -> tuple[Poly, int]:
        """Divide by a recorded factor as often as possible, at most so many times; what is left, and how often."""
        trials, divisor, times = self.trials, self.divisors[index], 0
        if trials.known:
            times = trials.next(most)
            return self._divided(p, [(index, times)]), times
        while times < most and any(p) and (q := divisor.quotient(p)) is not None:
            p, times = q, times + 1
        trials.remember(times)
        return p, times

    def _divided(self, p: Poly, powers: list[tuple[int, int]]) -> Poly:
        """p over powers of recorded factors, those in the same variable at once."""
        for divisor in self._grouped(powers):
            q = divisor.quotient(p, told=True)
            if q is None:
                raise Rejected("cancelled: a factor does not divide")
            p = q
        return p

    def _grouped(self, powers: Iterable[tuple[int, int]]) -> list[Divisor]:
        """A product of powers of recorded factors as a product of few: those in the same variable are one."""
        groups: dict[int, list[tuple[int, int]]] = {}
        out = []
        for index, e in powers:
            divisor = self.divisors[index]
            if divisor.univariate:
                groups.setdefault(divisor.place, []).append((index, e))
            else:
                out += [divisor] * e
        for group in groups.values():
            key = tuple(group)
            if key not in self._products:
                product = {0: 1}
                for index, e in group:
                    for _ in range(e):
                        product = mul(product, self.factors[index])
                self._products[key] = Divisor(product)
            out.append(self._products[key])
        return out

    def factor(self, p: Poly) -> list[tuple[int, int]]:
        """Write a polynomial (up to a unit) as a product of recorded factors, recording a new one if need be."""
        powers: dict[int, int] = {}
        for index in range(len(self.factors)):
            p, times = self.cancel(p, index, 1 << BITS)
            if times:
                powers[index] = times
        for place in range(0, BITS * len(self.names), BITS):
            for f in self._content(p, place):
                index = self._record(f)
                p = self._divided(p, [(index, 1)])
                powers[index] = powers.get(index, 0) + 1
        if any(p):
            index = self._record(p)
            powers[index] = powers.get(index, 0) + 1
        self.used |= powers.keys()
        return sorted(powers.items())

    def _content(self, p: Poly, place: int) -> list[Poly]:
        """Factors of a polynomial in one variable, unless it is told that it has none."""
        if self.trials.known:
            return content(p, place) if self.trials.next(1) else []
        found = content(p, place)
        self.trials.remember(min(len(found), 1))
        return found

    def _record(self, p: Poly) -> int:
        if p in self.factors:
            return self.factors.index(p)
        self.factors.append(p)
        self.divisors.append(Divisor(p))
        return len(self.factors) - 1

    def times_powers(self, p: Poly, powers: Iterable[tuple[int, int]]) -> Poly:
        """p times a product of powers of recorded factors."""
        for divisor in self._grouped((index, e) for index, e in powers if e):
            p = mul(p, divisor.terms)
        return p

    def text(self, p: Poly) -> str:
        """A polynomial for people."""
        terms = []
        for key in sorted(p, reverse=True):
            word = "*".join(n if e == 1 else f"{n}^{e}" for n, e in zip(self.names, exponents(key), strict=False) if e)
            c = p[key]
            terms.append(str(c) if not word else word if c == 1 else f"-{word}" if c == -1 else f"{c}*{word}")
        return " + ".join(terms).replace("+ -", "- ") or "0"


class Symbolic(FieldElement):
    """num / (q * product of factor^e): num an integer polynomial, q a positive integer."""

    __slots__ = ("den", "field", "num", "q")

    def __init__(self, field: SymbolicField, num: Poly, q: int, den: tuple) -> None:
        self.field, self.num, self.q, self.den = field, num, q, den if num else ()

    def _primitive(self) -> Symbolic:
        """Cancel common factors of q and the numerator."""
        if self.q != 1 and (common := gcd(self.q, *self.num.values())) != 1:
            self.num, self.q = {k: v // common for k, v in self.num.items()}, self.q // common
        return self

    def _cancelled(self, den: dict[int, int], among: Iterable[int]) -> Poly:
        """Numerator, less the factors among those given that it has in common with a denominator, which is changed."""
        field, num = self.field, self.num
        if field.trials.known:
            powers = [(index, times) for index in among if (times := field.trials.next(den[index]))]
            for index, times in powers:
                den[index] -= times
            return field._divided(num, powers)
        for index in among:
            num, times = field.cancel(num, index, den[index])
            den[index] -= times
        return num

    def _over(self, den: dict[int, int], among: Iterable[int]) -> Symbolic:
        """This polynomial over a denominator, less the factors among those given that they have in common."""
        num = self._primitive()._cancelled(den, among)
        return Symbolic(self.field, num, self.q, tuple(sorted((index, e) for index, e in den.items() if e)))

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
        mine = dict(self.den)
        return self.field.times_powers(self.num, ((index, e - mine.get(index, 0)) for index, e in den.items()))

    def __add__(self, other: Any) -> Any:
        y = self._coerce(other)
        if y is None:
            return NotImplemented
        if not self.num or not y.num:
            return self if self.num else y
        common = gcd(self.q, y.q)
        a, b = y.q // common, self.q // common
        if not self.den and not y.den:
            return Symbolic(self.field, add(self.num, y.num, a, b), self.q * a, ())._primitive()
        mine, theirs = dict(self.den), dict(y.den)
        den = {index: max(e, theirs.get(index, 0)) for index, e in (theirs | mine).items()}
        out = Symbolic(self.field, add(self._lift(den), y._lift(den), a, b), self.q * a, ())
        # an irreducible factor of different powers in the two denominators divides one term and not the other
        return out._over(den, [index for index in den if theirs.get(index) == mine.get(index) or not self.field.divisors[index].univariate])

    __radd__ = __add__

    def plus(self, others: Sequence[Any]) -> Any:
        """Sum of this and others over one common denominator: what they have in common is cancelled once.

        NotImplemented if one of them is no element of the field.
        """
        given = [self, *map(self._coerce, others)]
        if any(x is None for x in given):
            return NotImplemented
        terms = [x for x in given if x is not None and x.num]
        if len(terms) < 3:
            return sum(terms[1:], terms[0]) if terms else self
        q, den = lcm(*(x.q for x in terms)), dict[int, int]()
        for x in terms:
            for index, e in x.den:
                den[index] = max(e, den.get(index, 0))
        num: Poly = {}
        for x in sorted(terms, key=lambda x: len(x.num)):
            num = add(x._lift(den), num, q // x.q)
        # an irreducible factor of its highest power in one denominator alone does not divide the sum
        divisors, highest = self.field.divisors, [{*x.den} for x in terms]
        among = [index for index, e in den.items() if not divisors[index].univariate or sum((index, e) in h for h in highest) > 1]
        return Symbolic(self.field, num, q, ())._over(den, among)

    def __neg__(self) -> Symbolic:
        return Symbolic(self.field, {k: -v for k, v in self.num.items()}, self.q, self.den)

    def __sub__(self, other: Any) -> Any:
        return NotImplemented if isinstance(other, (Laurent, Ratio)) else self + (-other)

    def __mul__(self, other: Any) -> Any:
        y = self._coerce(other)
        if y is None:
            return NotImplemented
        if not self.num or not y.num:
            return Symbolic(self.field, {}, 1, ())
        if not self.den and not y.den:
            if y.num == _ONE and y.q == 1:
                return self
            if self.num == _ONE and self.q == 1:
                return y
            return Symbolic(self.field, mul(self.num, y.num), self.q * y.q, ())._primitive()
        mine, theirs = dict(self.den), dict(y.den)
        p = self._cancelled(theirs, sorted(theirs.keys() - mine.keys()))
        q = y._cancelled(mine, sorted(mine.keys() - theirs.keys()))
        den = {index: e for index in mine | theirs if (e := mine.get(index, 0) + theirs.get(index, 0))}
        # an irreducible factor divides neither p nor q now
        return Symbolic(self.field, mul(p, q), self.q * y.q, ())._over(den, [index for index in den if not self.field.divisors[index].univariate])

    __rmul__ = __mul__

    def inverse(self) -> Symbolic:
        """One over this."""
        if not self.num:
            raise Undefined("division by zero")
        num = self.field.times_powers({0: self.q}, self.den)
        if len(self.num) == 1 and 0 in self.num:
            c = self.num[0]
            return Symbolic(self.field, {k: v if c > 0 else -v for k, v in num.items()}, abs(c), ())
        content = gcd(*self.num.values())
        if self.num[max(self.num)] < 0:
            content = -content
        powers = self.field.factor({k: v // content for k, v in self.num.items()})
        # factor() drops signs and contents of cofactors only when they are units: restore them exactly
        product = self.field.times_powers({0: 1}, powers)
        key = max(product)
        unit = Fraction(self.num[key], product[key])
        num = {k: v * unit.denominator * (1 if unit > 0 else -1) for k, v in num.items()}
        return Symbolic(self.field, num, abs(unit.numerator), tuple(powers))._primitive()

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
