# SPDX-License-Identifier: MIT
r"""Exact real numbers as a user writes them.

A number is an expression of a fixed grammar; nothing is evaluated by Python.

.. code-block:: text

    number   ::= fraction | decimal | number op number | -number | (number) | number ^ integer | positive number ^ fraction
    op       ::= + | - | * | /
    number   ::= sqrt(number)
               | cos(angle) | sin(angle) | sec(angle)            angle: a rational multiple of pi, such as 2*pi/7
               | root(polynomial in x, lo, hi)                   the one real root in [lo, hi]
    decimal  ::= 0.25, 1e-3                                      taken exactly: 0.1 is one tenth

Main definitions
----------------
``number``    one number: an `fmpq`, or a `RealNumber` of some field
``numbers``   several, in one field

Choice of method
----------------
The expression is parsed by `ast.parse`, which runs nothing, and the tree is walked
with a list of allowed nodes; decimals are read from the source text, not from the
float the parser makes of them.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterable, Mapping, Set
from typing import Any

from flint import fmpq, fmpq_poly, fmpz

from exactkf._errors import BadInput
from exactkf.exact._messages import bad, shown
from exactkf.exact.compositum import MAX_DEGREE, nth_root, together
from exactkf.exact.numberfield import RealField, RealNumber, cyclotomic_real
from exactkf.exact.polynomials import isolate_real_roots
from exactkf.exact.rationals import check_floats, rational

__all__ = ["GRAMMAR", "Number", "number", "numbers"]

Number = fmpq | RealNumber

GRAMMAR = "fractions, decimals, + - * / ^, sqrt(x), cos(p*pi/q), sin, sec, root(polynomial in x, lo, hi)"

_LONGEST = 2000  # characters of an expression; a plain number may have more
_PLAIN = re.compile(r"\s*[+-]?\d+(/\d+|\.\d+)?\s*", re.ASCII)
_LARGEST_POWER = 1000
_LARGEST_ANGLE = 2000  # denominator of an angle
_MOST_BITS = 1 << 20  # of a power
_LARGEST_DEGREE = 48  # of one number; deciding an orbit over larger fields takes minutes


def number(value: Any, *, floats: str | int | None = None, name: str = "x") -> Number:
    """Return the exact real number that a value denotes.

    Parameters
    ----------
    value : str, int, Fraction, Decimal, fmpq, RealNumber, sympy number (of the same functions, tan, or a real CRootOf) or float
        A string is an expression of the grammar above.
    floats : {None, "exact", "decimal"} or int, optional
        What a float, of numpy and sympy too, stands for, see `exactkf.exact.rational`; None refuses it.
    name : str
        Name of the argument in messages.

    Raises
    ------
    BadInput
        If the value is outside the grammar, an interval isolates no root or several, or a
        float comes without a rule.

    Examples
    --------
    >>> number("1/2 + 0.25")
    3/4
    >>> number("sqrt(2)") ** 2 == 2
    True
    """
    if floats is not None:
        check_floats(floats)
    if isinstance(value, RealNumber):
        return value.rational_value() if value.is_rational() else value
    if type(value).__module__.split(".")[0] == "sympy" and not (getattr(value, "is_Rational", False) or getattr(value, "is_Float", False)):
        value = _sympy_text(value, name)
        if any(c.isdigit() and "." in value for c in value):
            raise bad(name, "has a sympy float in it", value, "put a sympy Rational there")
    if not isinstance(value, str):
        return rational(value, floats=floats, name=name)
    return _Reader(value, name).read()


def numbers(values: Iterable[Any], *, floats: str | int | None = None, name: str = "x") -> tuple[tuple[Number, ...], RealField | None]:
    """Return the numbers in one field, and the field (None if all are rational).

    Raises
    ------
    BadInput
        As `number`; the message names the entry as ``name[k]``. If the values are no sequence.
    """
    if isinstance(values, (str, bytes, Mapping, Set)) or not isinstance(values, Iterable):
        raise bad(name, "is no sequence of numbers", values, "pass a list of numbers")
    found, field = together([number(v, floats=floats, name=f"{name}[{k}]") for k, v in enumerate(values)])
    return tuple(found), field


def _sympy_text(value: Any, name: str) -> str:
    """A sympy expression in the grammar; each of its roots of polynomials with an interval found here, not by sympy."""
    from sympy import cos
    from sympy.printing.str import StrPrinter

    class Printer(StrPrinter):
        """Writes roots as the grammar has them."""

        def _print_ComplexRootOf(self, root: Any) -> str:
            p = fmpq_poly([rational(c) for c in reversed(root.poly.all_coeffs())])
            real = isolate_real_roots(p)
            if root.index >= len(real):  # sympy numbers the real roots first, in their order
                raise bad(name, "is not a real number", root, "pass a real root")
            terms = " + ".join(f"({c})*x^{k}" for k, c in enumerate(p.coeffs()) if c != 0)
            return f"root({terms}, {real[root.index].lo}, {real[root.index].hi})"

        def _print_GoldenRatio(self, _: Any) -> str:
            return "((1 + sqrt(5))/2)"

        def _print_TribonacciConstant(self, _: Any) -> str:
            return "root(x^3 - x^2 - x - 1, 1, 2)"

        def _print_tan(self, value: Any) -> str:
            return f"({self._print(value.rewrite(cos))})"

        _print_cot = _print_csc = _print_tan

    return Printer().doprint(value).replace("**", "^")


class _Reader:
    """Walks the tree of one expression."""

    def __init__(self, text: str, name: str) -> None:
        self.text, self.name = text, name
        self.source = text.strip().replace("^", "**").replace("\N{MINUS SIGN}", "-")

    def read(self) -> Number:
        if len(self.text) > _LONGEST:
            if _PLAIN.fullmatch(self.text):
                return rational(self.text, name=self.name)
            raise bad(self.name, f"is longer than {_LONGEST} characters", self.text, "pass a shorter expression")
        try:
            tree = ast.parse(self.source, mode="eval").body
            return self._number(tree)
        except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
            if isinstance(error, BadInput):
                raise
            raise self._outside() from None
        except ZeroDivisionError:
            raise bad(self.name, "divides by zero", self.text, "pass a number that exists") from None

    def _outside(self, part: str = "") -> BadInput:
        where = f" at {shown(part.replace('**', '^'))}" if part and part != self.source else ""
        return bad(self.name, f"is no number of the grammar{where}", self.text, f"write it with {GRAMMAR}")

    def _source(self, node: ast.AST) -> str:
        return ast.get_source_segment(self.source, node) or self.source

    def _number(self, node: ast.expr) -> Number:
        match node:
            case ast.Constant():
                return self._literal(node)
            case ast.UnaryOp(op=ast.USub()):
                return -self._number(node.operand)
            case ast.UnaryOp(op=ast.UAdd()):
                return self._number(node.operand)
            case ast.BinOp(op=ast.Pow()):
                return self._power(self._number(node.left), node)
            case ast.BinOp(op=ast.Add() | ast.Sub() | ast.Mult() | ast.Div()):
                return self._combined(node)
            case ast.Call(func=ast.Name(id=called), keywords=[]) if called in _FUNCTIONS:
                return _FUNCTIONS[called](self, node)
        raise self._outside(self._source(node))

    def _literal(self, node: ast.Constant) -> fmpq:
        if isinstance(node.value, bool) or not isinstance(node.value, (int, float)):
            raise self._outside(self._source(node))
        return rational(self._source(node), name=self.name)  # the text, not the float

    def _combined(self, node: ast.BinOp) -> Number:
        (left, right), _ = together([self._number(node.left), self._number(node.right)])
        match node.op:
            case ast.Add():
                return left + right
            case ast.Sub():
                return left - right
            case ast.Mult():
                return left * right
        return left / right

    def _power(self, base: Number, node: ast.BinOp) -> Number:
        exponent = self._number(node.right)
        if isinstance(exponent, RealNumber) or abs(exponent.p) > _LARGEST_POWER or exponent.q > _LARGEST_DEGREE:
            raise bad(self.name, "has an exponent that is no small integer or fraction", self.text,
                      f"use numerators up to {_LARGEST_POWER} and denominators up to {_LARGEST_DEGREE}")
        if exponent.q != 1:
            base = self._root_of(base, int(exponent.q))
        k = int(exponent.p)
        if abs(k) * _bits(base) > _MOST_BITS:
            raise bad(self.name, "has too large a power", self.text, f"use numbers of up to {_MOST_BITS} bits")
        return base**k

    def _root_of(self, x: Number, n: int = 2) -> Number:
        if (x.sign() if isinstance(x, RealNumber) else int(x > 0) - int(x < 0)) < 0:
            raise bad(self.name, f"takes the {'square ' * (n == 2)}root of a negative number", self.text, "pass a real number, or root(x^3 + 2, -2, 0)")
        if isinstance(x, RealNumber) and x.field.degree * n > MAX_DEGREE:
            self._small(x.field.degree * n)
        field = RealField([0, 1], (0, 0))
        return number(nth_root(x if isinstance(x, RealNumber) else field(x), n))

    def _one(self, node: ast.Call) -> ast.expr:
        if len(node.args) != 1:
            raise bad(self.name, f"gives {self._source(node.func)} {len(node.args)} arguments", self.text, "give it one")
        return node.args[0]

    def _sqrt(self, node: ast.Call) -> Number:
        return self._root_of(self._number(self._one(node)))

    def _angle(self, node: ast.expr) -> fmpq:
        """The rational q of an angle q*pi."""
        turned = self._linear(node, "pi")
        if turned is None or turned[0] != 0 or turned[1].q > _LARGEST_ANGLE:
            raise bad(self.name, "has an angle that is no rational multiple of pi", self.text, f"write 2*pi/7, with a denominator up to {_LARGEST_ANGLE}")
        return turned[1]

    def _linear(self, node: ast.expr, letter: str) -> fmpq_poly | None:
        p = self._polynomial(node, letter)
        return p if p.degree() <= 1 else None

    def _cos(self, node: ast.Call) -> Number:
        return self._cosine(self._angle(self._one(node)))

    def _sin(self, node: ast.Call) -> Number:
        return self._cosine(fmpq(1, 2) - self._angle(self._one(node)))

    def _sec(self, node: ast.Call) -> Number:
        return 1 / self._cos(node)

    def _cosine(self, turn: fmpq) -> Number:
        """cos(turn * pi) = cos(2 pi p / (2 q)) for turn = p/q."""
        half = turn / 2
        self._small(int(fmpz(half.q).euler_phi()) // 2)
        return number(cyclotomic_real(int(half.q)).two_cos(int(half.p)) / 2)

    def _root(self, node: ast.Call) -> Number:
        if len(node.args) != 3:
            raise bad(self.name, f"gives root {len(node.args)} arguments", self.text, "write root(x^3 - 2, 1, 2)")
        p = self._polynomial(node.args[0], "x")
        lo, hi = (self._number(n) for n in node.args[1:])
        if isinstance(lo, RealNumber) or isinstance(hi, RealNumber):
            raise bad(self.name, "has an interval whose ends are not rational", self.text, "pass rational ends")
        try:
            field = RealField(p, (lo, hi))
        except BadInput as error:
            raise BadInput(f"argument '{self.name}': in {shown(self._source(node).replace('**', '^'))}: {error}") from None
        self._small(field.degree)
        return number(field.gen())

    def _small(self, degree: int) -> None:
        if degree > _LARGEST_DEGREE:
            raise bad(self.name, f"is of degree {degree}", self.text, f"use numbers of degree up to {_LARGEST_DEGREE}")

    def _polynomial(self, node: ast.expr, letter: str) -> fmpq_poly:
        """A polynomial with rational coefficients in the letter."""
        match node:
            case ast.Name(id=found) if found == letter:
                return fmpq_poly([0, 1])
            case ast.UnaryOp(op=ast.USub()):
                return -self._polynomial(node.operand, letter)
            case ast.BinOp(op=ast.Add()):
                return self._polynomial(node.left, letter) + self._polynomial(node.right, letter)
            case ast.BinOp(op=ast.Sub()):
                return self._polynomial(node.left, letter) - self._polynomial(node.right, letter)
            case ast.BinOp(op=ast.Mult()):
                return self._polynomial(node.left, letter) * self._polynomial(node.right, letter)
            case ast.BinOp(op=ast.Div()):
                below = self._polynomial(node.right, letter)
                if below.degree() > 0:
                    raise self._outside(self._source(node))
                return self._polynomial(node.left, letter) / below[0]
            case ast.BinOp(op=ast.Pow(), right=ast.Constant(value=int(k))) if 0 <= k <= _LARGEST_POWER:
                return self._polynomial(node.left, letter) ** k
        value = self._number(node)
        if isinstance(value, RealNumber):
            raise bad(self.name, f"has an irrational coefficient beside {letter}", self.text, "use rational coefficients")
        return fmpq_poly([value])


def _bits(x: Number) -> int:
    """Size of a number, roughly."""
    parts = x.poly.coeffs() if isinstance(x, RealNumber) else [x]
    return max((int(c.p).bit_length() + int(c.q).bit_length() for c in parts), default=1)


_FUNCTIONS: dict[str, Callable[[_Reader, ast.Call], Number]] = {
    "sqrt": _Reader._sqrt, "cos": _Reader._cos, "sin": _Reader._sin, "sec": _Reader._sec, "root": _Reader._root,
}
