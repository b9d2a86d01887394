# SPDX-License-Identifier: MIT
r"""Rational functions in several variables over Q, in lowest terms.

A `RatField` fixes the names of the variables; its elements, `RatFunc`, are
quotients of integer polynomials.  Two elements are equal exactly when they are
the same rational function, and then they are the same pair of polynomials.

Notation
--------
An element is a pair (numerator, denominator) in :math:`\mathbb Z[x_1, \dots, x_n]`
with greatest common divisor 1, contents included, and a denominator whose
leading coefficient is positive; zero is 0/1.

The field keeps in `RatField.denominators` every polynomial it was asked to
divide by: an identity between elements holds at each point where none of
these vanishes.

Choice of algorithm
-------------------
Sums and products follow Henrici: the common factors are looked for in the
operands, which are small, rather than in the result, and nowhere when an
operand is a polynomial.  Measured on polynomials in 5 variables with about 180
terms, one gcd takes 100 us, a product 13 us and a sum 2.4 us; a gcd with a
variable takes 0.8 us.  A gcd with nothing smaller to look at (a sum or quotient
over one denominator, as in a Möbius map) is put off: until the element is
compared, printed, hashed, asked for its numerator, or meets another denominator,
and for at most `_PATIENCE` operations.  Five Möbius maps then cost 1.0 to 1.5
times a hand-written pair of polynomials with one gcd at the end, instead of 1.6 to
2.0 times when every gcd is taken at once.  Coefficients in Z (`fmpz_mpoly`) and in Q
(`fmpq_mpoly`) were equally fast (gcd 100 us against 99 us, sum 2.4 us against
3.1 us); Z makes the lowest terms unique by themselves.

References
----------
P. Henrici, A subroutine for computations with rational numbers, Journal of the
ACM 3 (1956), 6-9.  D. E. Knuth, The Art of Computer Programming 2, section 4.5.1.
"""

from __future__ import annotations

import numbers
from collections.abc import Iterable, Mapping, Sequence, Set
from fractions import Fraction
from typing import Any

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpz, fmpz_mpoly, fmpz_mpoly_ctx

from exactkf._errors import BadInput
from exactkf.exact._messages import bad, shown
from exactkf.exact.rationals import rational

__all__ = ["RatField", "RatFunc"]

_ORDER = Ordering.degrevlex
_RECORD_LIMIT = 256
_PATIENCE = 16  # longest chain of operations through which a gcd is put off


class RatField:
    """The field Q(names) of rational functions.

    Parameters
    ----------
    names : iterable of str, or str
        The variables: distinct identifiers; a string is split at spaces and commas.

    Raises
    ------
    BadInput
        If a name is repeated or is not an identifier.

    Examples
    --------
    >>> field = RatField("x y")
    >>> x, y = field.gens()
    >>> (x**2 - y**2) / (x - y)
    x + y
    >>> field.denominators
    [x - y]
    """

    __slots__ = ("_divided", "_one", "_qctx", "_seen", "_zero", "ctx", "names")

    def __init__(self, names: Iterable[str] | str) -> None:
        if isinstance(names, (bytes, Mapping, Set)) or not isinstance(names, Iterable):
            raise bad("names", "is no list of names", names, 'pass names such as ("x", "y")')
        names = tuple(names.replace(",", " ").split() if isinstance(names, str) else names)
        if not all(isinstance(name, str) and name.isidentifier() for name in names):
            raise bad("names", "holds a name that is not an identifier", names, 'pass names such as ("x", "y")')
        if len(set(names)) != len(names):
            raise bad("names", "repeats a name", names, "pass distinct names")
        self.names: tuple[str, ...] = names
        self.ctx = fmpz_mpoly_ctx.get(names, _ORDER)
        self._qctx = fmpq_mpoly_ctx.get(names, _ORDER)
        self._zero = self.ctx.constant(0)
        self._one = self.ctx.constant(1)
        self._divided: list[RatFunc] = []
        self._seen: dict[str, fmpz_mpoly] = {}

    def __repr__(self) -> str:
        return f"RatField({self.names!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, RatField) and self.names == other.names

    def __hash__(self) -> int:
        return hash((RatField, self.names))

    def __reduce__(self) -> tuple:
        return RatField, (self.names,)

    def gens(self) -> tuple[RatFunc, ...]:
        """Return the variables, in the order of `names`."""
        return tuple(_make(self, g, self._one) for g in self.ctx.gens())

    def gen(self, name: str) -> RatFunc:
        """Return the variable called `name`.

        Raises
        ------
        BadInput
            If there is no such variable.
        """
        return _make(self, self.ctx.gens()[self._index(name)], self._one)

    def __call__(self, x: Any, denominator: Any = 1) -> RatFunc:
        """Return ``x / denominator`` as an element.

        Parameters
        ----------
        x, denominator : RatFunc, fmpz_mpoly, fmpq_mpoly or anything `rational` accepts

        Raises
        ------
        BadInput
            If an argument belongs to another field.
        ZeroDivisionError
            If the denominator is zero.
        """
        top = self._element(x, "x")
        return top if _is_plain_one(denominator) else top / self._element(denominator, "denominator")

    @property
    def denominators(self) -> list[fmpz_mpoly]:
        """The distinct polynomials divided by so far, in order: primitive, positive leading coefficient."""
        self._settle()
        return list(self._seen.values())

    def forget_denominators(self) -> None:
        """Start the record of denominators afresh."""
        self._divided.clear()
        self._seen.clear()

    def from_data(self, data: Mapping[str, Any]) -> RatFunc:
        """Return the element that `RatFunc.to_data` wrote; see `RatFunc.from_data`."""
        return RatFunc.from_data(data, self)

    def _settle(self) -> None:
        """Move what was divided by since the last call into the record of distinct polynomials."""
        divided, self._divided = self._divided, []
        for element in divided:
            _, poly = element.numerator().primitive()
            if not poly.is_constant():
                if poly.leading_coefficient() < 0:
                    poly = -poly
                self._seen.setdefault(str(poly), poly)

    def _record(self, poly: fmpz_mpoly) -> None:
        """Note that the polynomial `poly` was divided by."""
        self._divided.append(_make(self, poly, self._one))
        if len(self._divided) >= _RECORD_LIMIT:
            self._settle()

    def _index(self, name: str) -> int:
        try:
            return self.names.index(name)
        except ValueError:
            raise bad("name", "is no variable of this field", name, f"pass one of {', '.join(self.names)}") from None

    def _check_context(self, fits: bool, x: Any, name: str) -> None:
        if not fits:
            raise bad(name, f"is a polynomial of another context than {self!r}", x, "rebuild it with from_data")

    def _element(self, x: Any, name: str) -> RatFunc:
        """Return the element denoted by `x`, which is called `name` in error messages."""
        if isinstance(x, RatFunc):
            if x.field != self:
                raise bad(name, f"is not in {self!r}", x, f"it is in {x.field!r}; use subs to change variables")
            if x.field is self:
                return x
            num, den = x._lowest()
            return _make(self, num, self._one if den.is_one() else den)
        if isinstance(x, fmpz_mpoly):
            self._check_context(x.context() is self.ctx, x, name)
            return _make(self, x, self._one)
        if isinstance(x, fmpq_mpoly):
            self._check_context(x.context() is self._qctx, x, name)
            top, bottom = _clear_denominators(x, self.ctx)
            return _reduced(self, top, self.ctx.constant(bottom))
        q = rational(x, name=name)
        return _make(self, self.ctx.constant(q.p), self._one if q.q == 1 else self.ctx.constant(q.q))


class RatFunc:
    """An element of a `RatField`, in lowest terms; make one from the field's `gens` by arithmetic.

    Arithmetic (``+ - * / **``) mixes with `int`, `Fraction` and `fmpq` on both
    sides.  Elements are immutable and hashable.  Division by zero raises
    ZeroDivisionError.
    """

    __slots__ = ("_late", "_pair", "field")

    field: RatField
    _pair: tuple[fmpz_mpoly, fmpz_mpoly]  # the denominator 1 is always field._one itself
    _late: int  # how many operations ago a gcd was put off; 0 in lowest terms

    def __init__(self) -> None:
        raise TypeError("make a RatFunc from the generators of a RatField")

    def _lowest(self) -> tuple[fmpz_mpoly, fmpz_mpoly]:
        """Return numerator and denominator in lowest terms, taking the gcd that was put off."""
        if self._late:
            self._pair = _lowest_terms(*self._pair, self.field._one)
            self._late = 0
        return self._pair

    def numerator(self) -> fmpz_mpoly:
        """Return the numerator, an integer polynomial prime to the denominator."""
        return self._lowest()[0]

    def denominator(self) -> fmpz_mpoly:
        """Return the denominator, an integer polynomial with positive leading coefficient."""
        return self._lowest()[1]

    def is_zero(self) -> bool:
        """Return whether this is the zero function."""
        return self._pair[0].is_zero()

    def is_constant(self) -> bool:
        """Return whether this is a rational number."""
        num, den = self._lowest()
        return num.is_constant() and den.is_constant()

    def is_polynomial(self) -> bool:
        """Return whether this is a polynomial with rational coefficients."""
        return self._lowest()[1].is_constant()

    def constant_value(self) -> fmpq:
        """Return the rational number this is.

        Raises
        ------
        BadInput
            If it depends on a variable.
        """
        if not self.is_constant():
            raise BadInput(f"the rational function {shown(self)} is not constant; use evaluate")
        num, den = self._pair
        return fmpq(num.leading_coefficient(), den.leading_coefficient())

    def __bool__(self) -> bool:
        return not self._pair[0].is_zero()

    def __eq__(self, other: object) -> bool:
        if isinstance(other, RatFunc):
            return self.field == other.field and self._lowest() == other._lowest()
        if not _is_scalar(other):
            return NotImplemented
        q = rational(other)
        num, den = self._lowest()
        return den == q.q and num == q.p

    def __hash__(self) -> int:
        if self.is_constant():
            return hash(self.constant_value())
        return hash((self.field.names, *map(str, self._lowest())))

    def __repr__(self) -> str:
        num, den = self._lowest()
        if den is self.field._one:
            return str(num)
        top = f"({num})" if len(num) > 1 else str(num)
        return f"{top}/({den})"

    def __neg__(self) -> RatFunc:
        num, den = self._pair
        return _make(self.field, -num, den, self._late)

    def __pos__(self) -> RatFunc:
        return self

    def __add__(self, other: Any) -> RatFunc:
        field = self.field
        if other.__class__ is not RatFunc or other.field is not field:
            other = _coerced(field, other)
            if other is NotImplemented:
                return other
        one = field._one
        a, b = self._pair
        c, d = other._pair
        if d is one:  # a + c b is prime to b if a is
            return _make(field, a + c if b is one else a + c * b, b, self._late)
        if b is one:
            return _make(field, c + a * d, d, other._late)
        if b is d or b == d:
            return _put_off(field, a + c, b, self._late, other._late)
        return _henrici_sum(field, *self._lowest(), *other._lowest())

    __radd__ = __add__

    def __sub__(self, other: Any) -> RatFunc:
        if other.__class__ is not RatFunc or other.field is not self.field:
            other = _coerced(self.field, other)
            if other is NotImplemented:
                return other
        return self + -other

    def __rsub__(self, other: Any) -> RatFunc:
        return -self + other

    def __mul__(self, other: Any) -> RatFunc:
        field = self.field
        if other.__class__ is not RatFunc or other.field is not field:
            other = _coerced(field, other)
            if other is NotImplemented:
                return other
        one = field._one
        a, b = self._pair
        c, d = other._pair
        if b is one:
            if d is one:
                return _make(field, a * c, one)
            if other._late:
                return _put_off(field, a * c, d, other._late, 0)
        elif d is one and self._late:
            return _put_off(field, a * c, b, self._late, 0)
        return _henrici_product(field, *self._lowest(), *other._lowest())

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> RatFunc:
        field = self.field
        if other.__class__ is not RatFunc or other.field is not field:
            other = _coerced(field, other)
            if other is NotImplemented:
                return other
        a, b = self._pair
        c, d = other._pair
        if c.is_zero():
            raise ZeroDivisionError("division by the zero rational function")
        field._divided.append(other)
        if len(field._divided) >= _RECORD_LIMIT:
            field._settle()
        if b is d or b == d:
            return _put_off(field, a, field._one if c.is_one() else c, self._late, other._late)
        c, d = other._lowest()
        if c.leading_coefficient() < 0:
            c, d = -c, -d
        return _henrici_product(field, *self._lowest(), d, field._one if c.is_one() else c)

    def __rtruediv__(self, other: Any) -> RatFunc:
        other = _coerced(self.field, other)
        return other if other is NotImplemented else other / self

    def __pow__(self, n: int) -> RatFunc:
        if not isinstance(n, int):
            return NotImplemented
        if n < 0:
            return (1 / self) ** -n
        num, den = self._lowest()
        return _make(self.field, num**n, self.field._one if n == 0 or den is self.field._one else den**n)

    def derivative(self, name: str) -> RatFunc:
        """Return the partial derivative with respect to the variable `name`.

        Raises
        ------
        BadInput
            If there is no such variable.
        """
        field, i = self.field, self.field._index(name)
        p, q = self._lowest()
        top, bottom = p.derivative(i), q.derivative(i)
        if bottom.is_zero():
            return _reduced(field, top, q)
        g = q.gcd(bottom)  # (p/q)' = (p' q/g - p q'/g) / (q q/g)
        rest = q // g
        return _reduced(field, top * rest - p * (bottom // g), q * rest)

    def evaluate(self, values: Mapping[str, Any] | Sequence[Any]) -> fmpq:
        """Return the value at a rational point.

        Parameters
        ----------
        values : mapping from names, or sequence in the order of the names
            Rational numbers, one for every variable.

        Raises
        ------
        BadInput
            If a variable has no value, or a value is not rational.
        ZeroDivisionError
            If the denominator vanishes there.
        """
        field = self.field
        if isinstance(values, Mapping):
            missing = [name for name in field.names if name not in values]
            if missing:
                raise bad("values", f"has no value for {', '.join(missing)}", dict(values), "name every variable")
            values = [values[name] for name in field.names]
        if len(values) != len(field.names):
            raise bad("values", f"is not of length {len(field.names)}", values, f"give {', '.join(field.names)}")
        point = [rational(value, name="values") for value in values]
        num, den = self._lowest()
        bottom = fmpq_mpoly(den, field._qctx)(*point)
        if bottom == 0:
            raise ZeroDivisionError(f"the denominator {shown(den)} vanishes at ({', '.join(map(str, point))})")
        return fmpq_mpoly(num, field._qctx)(*point) / bottom

    def __call__(self, *values: Any) -> fmpq:
        """Return the value at rational numbers given in the order of the names; see `evaluate`."""
        return self.evaluate(values)

    def subs(self, values: Mapping[str, Any], field: RatField | None = None) -> RatFunc:
        """Return this function with some variables replaced.

        Parameters
        ----------
        values : mapping from names to RatFunc or rational numbers
            The replacements, all made at once; other variables stay.
        field : RatField, optional
            The field of the result and of the replacements; by default this one.

        Raises
        ------
        BadInput
            If a name is no variable, or a variable that stays is not in `field`.
        ZeroDivisionError
            If the denominator becomes zero.
        """
        target = self.field if field is None else field
        for name in values:
            self.field._index(name)
        images = []
        for name in self.field.names:
            images.append(target._element(values[name], name) if name in values else target.gen(name))
        num, den = self._lowest()
        top, tops = _composed(num, images, target)
        bottom, bottoms = _composed(den, images, target)
        for image, k, m in zip(images, tops, bottoms, strict=True):
            if k < m:
                top *= image.denominator() ** (m - k)
            elif m < k:
                bottom *= image.denominator() ** (k - m)
        if bottom.is_zero():
            raise ZeroDivisionError(f"the denominator {shown(den)} vanishes after the substitution")
        target._record(bottom)
        return _reduced(target, top, bottom)

    def to_data(self) -> dict[str, Any]:
        """Return plain data: the names, and both polynomials as lists of (exponents, decimal string)."""
        return {
            "names": list(self.field.names),
            "numerator": _terms(self.numerator()),
            "denominator": _terms(self.denominator()),
        }

    @staticmethod
    def from_data(data: Mapping[str, Any], field: RatField | None = None) -> RatFunc:
        """Return the element written by `to_data`, reduced to lowest terms again.

        Parameters
        ----------
        data : mapping
            What `to_data` returned.
        field : RatField, optional
            The field to put it in; by default a new one.

        Raises
        ------
        BadInput
            If the data do not describe an element of the field.
        """
        try:
            names, parts = tuple(data["names"]), (data["numerator"], data["denominator"])
        except (KeyError, TypeError):
            raise bad("data", "is not a rational function", data, "pass what to_data returned") from None
        field = RatField(names) if field is None else field
        if field.names != names:
            raise bad("data", f"is not in {field!r}", names, "pass the field with these names")
        top, bottom = (_from_terms(part, field) for part in parts)
        if bottom.is_zero():
            raise bad("data", "has denominator zero", data, "pass what to_data returned")
        field._record(bottom)
        return _reduced(field, top, bottom)

    def __reduce__(self) -> tuple:
        return RatFunc.from_data, (self.to_data(),)


def _make(field: RatField, num: fmpz_mpoly, den: fmpz_mpoly, late: int = 0) -> RatFunc:
    """Return the element num/den; it is in lowest terms unless `late`; a denominator 1 must be ``field._one``."""
    self = object.__new__(RatFunc)
    self.field = field
    self._pair = (num, den)
    self._late = 0 if den is field._one else late
    return self


def _put_off(field: RatField, num: fmpz_mpoly, den: fmpz_mpoly, late: int, other_late: int) -> RatFunc:
    """Return num/den with the gcd left for later, unless it was put off for long enough."""
    late = (late if late > other_late else other_late) + 1
    return _make(field, num, den, late) if late <= _PATIENCE else _reduced(field, num, den)


def _reduced(field: RatField, num: fmpz_mpoly, den: fmpz_mpoly) -> RatFunc:
    """Return the element num/den in lowest terms; `den` is not zero."""
    return _make(field, *_lowest_terms(num, den, field._one))


def _lowest_terms(num: fmpz_mpoly, den: fmpz_mpoly, one: fmpz_mpoly) -> tuple[fmpz_mpoly, fmpz_mpoly]:
    """Return the canonical pair equal to num/den, with the denominator 1 as `one` itself."""
    if den.leading_coefficient() < 0:
        num, den = -num, -den
    return _cancel(num, den, one)


def _cancel(num: fmpz_mpoly, den: fmpz_mpoly, one: fmpz_mpoly) -> tuple[fmpz_mpoly, fmpz_mpoly]:
    """Return num/g and den/g for the greatest common divisor g, the denominator 1 as `one` itself."""
    g = num.gcd(den)
    if not g.is_one():
        num, den = num // g, den // g
    return num, (one if den.is_one() else den)


def _henrici_sum(field: RatField, a: fmpz_mpoly, b: fmpz_mpoly, c: fmpz_mpoly, d: fmpz_mpoly) -> RatFunc:
    """Return a/b + c/d for two pairs in lowest terms."""
    g = b.gcd(d)
    if g.is_one():
        den = b * d
        return _make(field, a * d + c * b, field._one if den.is_one() else den)
    rest = b // g
    num = a * (d // g) + c * rest
    common = num.gcd(g)
    if not common.is_one():
        num, d = num // common, d // common
    den = rest * d
    return _make(field, num, field._one if den.is_one() else den)


def _henrici_product(field: RatField, a: fmpz_mpoly, b: fmpz_mpoly, c: fmpz_mpoly, d: fmpz_mpoly) -> RatFunc:
    """Return (a/b) (c/d) for two pairs in lowest terms."""
    one = field._one
    if d is not one:
        a, d = _cancel(a, d, one)
    if b is not one:
        c, b = _cancel(c, b, one)
    return _make(field, a * c, b if d is one else d if b is one else b * d)


def _is_scalar(x: Any) -> bool:
    """Return whether `x` is a number that arithmetic accepts without being told so."""
    return isinstance(x, (int, fmpq, fmpz, Fraction, numbers.Rational)) and not isinstance(x, bool)


def _is_plain_one(x: Any) -> bool:
    return isinstance(x, int) and x == 1


def _coerced(field: RatField, x: Any) -> Any:
    """Return `x` as an element of `field`, or NotImplemented."""
    if x.__class__ is int:
        return _make(field, field.ctx.constant(x), field._one)
    if isinstance(x, (RatFunc, fmpz_mpoly, fmpq_mpoly)) or _is_scalar(x):
        return field._element(x, "other")
    return NotImplemented


def _clear_denominators(poly: fmpq_mpoly, ctx: fmpz_mpoly_ctx) -> tuple[fmpz_mpoly, fmpz]:
    """Return an integer polynomial and an integer whose quotient is `poly`."""
    terms = poly.to_dict()
    scale = fmpz(1)
    for c in terms.values():
        scale = scale * c.q // scale.gcd(c.q)
    return ctx.from_dict({e: (c * scale).p for e, c in terms.items()}), scale


def _composed(poly: fmpz_mpoly, images: list[RatFunc], field: RatField) -> tuple[fmpz_mpoly, list[int]]:
    """Return Q and degrees k with poly(images) = Q / prod(denominator_i ** k_i)."""
    quotients = [i for i, image in enumerate(images) if image.denominator() is not field._one]
    tops = [image.numerator() for image in images]
    degrees = [0] * len(images)
    if poly.is_constant():
        return field.ctx.constant(poly.leading_coefficient()), degrees
    if not quotients:
        return poly.compose(*tops, ctx=field.ctx), degrees
    found = poly.degrees()
    for i in quotients:
        degrees[i] = found[i]
    names = [f"v{i}" for i in range(len(images) + len(quotients))]
    wide = fmpz_mpoly_ctx.get(tuple(names), _ORDER)
    terms = {e + tuple(degrees[i] - e[i] for i in quotients): c for e, c in poly.to_dict().items()}
    return wide.from_dict(terms).compose(*tops, *(images[i].denominator() for i in quotients), ctx=field.ctx), degrees


def _terms(poly: fmpz_mpoly) -> list[list[Any]]:
    """Return the terms of `poly` as plain data."""
    return [[[int(k) for k in e], str(c)] for e, c in poly.to_dict().items()]


def _from_terms(terms: Any, field: RatField) -> fmpz_mpoly:
    """Return the polynomial with the plain data `terms`."""
    result: dict[tuple[int, ...], fmpz] = {}
    try:
        for exponents, coefficient in terms:
            key = tuple(exponents)
            if len(key) != len(field.names) or any(type(k) is not int or k < 0 for k in key) or key in result:
                raise ValueError
            result[key] = fmpz(coefficient)
    except (TypeError, ValueError):
        raise bad("data", "is not a list of distinct terms", terms, "pass what to_data returned") from None
    return field.ctx.from_dict(result)
