# SPDX-License-Identifier: MIT
"""Statements to sympy and back, for derivation scripts.

The bridge is for people at the edge: no verdict passes through it. Scalar
terms, matrix expressions (as ``MatrixSymbol``), relations and connectives
convert both ways; what the other side cannot say raises
`exactkf.Unsupported`. sympy reorders commutative sums and products when they
are built, so a term that went to sympy and back is equal, not identical, to
what it was. Trees are walked; nothing is parsed or evaluated from text.

>>> from exactkf.language import symbols
>>> x, y = symbols("x y")
>>> to_sympy((x + y) / 2)
x/2 + y/2
>>> from_sympy(to_sympy(x * y - 1))
-1 + x*y
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce
from typing import Any

import sympy

from exactkf._errors import BadInput, Unsupported
from exactkf.language.tree import Expr, Z, sym, to_expr

__all__ = ["from_sympy", "to_sympy"]

_Z = sympy.Symbol("z")

_TO: dict[str, Callable[..., Any]] = {
    "+": lambda *xs: reduce(lambda a, b: a + b, xs), "-": lambda x, y: x - y, "neg": lambda x: -x,
    "*": lambda *xs: reduce(lambda a, b: a * b, xs), "/": lambda x, y: x / y, "^": lambda x, k: x**k,
    "sqrt": sympy.sqrt, "cospi": lambda q, p: sympy.cos(sympy.pi * q / p),
    "abs": sympy.Abs, "T": lambda m: m.T, "inv": lambda m: m.inverse(), "det": sympy.Determinant,
    "tr": sympy.Trace, "I": sympy.Identity, "O": sympy.ZeroMatrix,
    "=": lambda x, y: sympy.Eq(x, y, evaluate=False), "!=": lambda x, y: sympy.Ne(x, y, evaluate=False),
    "<": lambda x, y: sympy.Lt(x, y, evaluate=False), "<=": lambda x, y: sympy.Le(x, y, evaluate=False),
    ">": lambda x, y: sympy.Gt(x, y, evaluate=False), ">=": lambda x, y: sympy.Ge(x, y, evaluate=False),
    "and": sympy.And, "or": sympy.Or, "not": sympy.Not, "=>": sympy.Implies, "<=>": sympy.Equivalent,
}


def to_sympy(term: Expr, shapes: Mapping[str, tuple] | None = None) -> Any:
    """A term or formula as a sympy object.

    Parameters
    ----------
    term : Expr
        The term.
    shapes : mapping of name to (rows, columns), optional
        Names that are matrices; sizes as ints or names. All other names become commuting symbols.

    Raises
    ------
    Unsupported
        For an operation that sympy has no standard object for.
    """
    sizes = {name: tuple(sympy.Symbol(s, integer=True) if isinstance(s, str) else s for s in shape) for name, shape in (shapes or {}).items()}

    def walk(tree: Any) -> Any:
        if isinstance(tree, int):
            return sympy.Integer(tree)
        op, args = tree[0], tree[1:]
        if op == "sym":
            return sympy.MatrixSymbol(args[0], *sizes[args[0]]) if args[0] in sizes else sympy.Symbol(args[0])
        if op == "z":
            return _Z
        if op == "rat":
            return sympy.Rational(*args)
        if op == "at":
            return sympy.IndexedBase(args[0])[tuple(walk(a) for a in args[1:])]
        if op == "entry":
            return walk(args[0])[walk(args[1]) - 1, (walk(args[2]) if len(args) > 2 else sympy.Integer(1)) - 1]
        if op in ("sum", "prod"):
            index = sympy.Symbol(args[0])
            return (sympy.Sum if op == "sum" else sympy.Product)(walk(args[3]), (index, walk(args[1]), walk(args[2])))
        if op == "rows":
            return sympy.ImmutableMatrix([[walk(x) for x in row] for row in args])
        if op not in _TO:
            raise Unsupported(f"operation {op!r} has no counterpart in sympy")
        return _TO[op](*(walk(a) for a in args))

    return walk(to_expr(term).tree)


_RELATIONS = {
    sympy.Eq: "=", sympy.Ne: "!=", sympy.StrictLessThan: "<", sympy.LessThan: "<=", sympy.StrictGreaterThan: ">",
    sympy.GreaterThan: ">=", sympy.And: "and", sympy.Or: "or", sympy.Not: "not", sympy.Implies: "=>", sympy.Equivalent: "<=>",
    sympy.MatMul: "*", sympy.Mul: "*", sympy.MatAdd: "+", sympy.Add: "+", sympy.Transpose: "T", sympy.Inverse: "inv",
    sympy.Determinant: "det", sympy.Trace: "tr", sympy.Identity: "I", sympy.ZeroMatrix: "O", sympy.Abs: "abs",
}


def from_sympy(value: Any) -> Expr:
    """A sympy object as a term or formula.

    Raises
    ------
    BadInput
        For a float: state it as a rational number.
    Unsupported
        For a sympy function that the language has no operation for.
    """
    if isinstance(value, sympy.Float):
        raise BadInput(f"argument 'value' holds the float {value}; use sympy.Rational, or sympy.nsimplify(value, rational=True)")
    if isinstance(value, sympy.Rational):
        return Expr(("rat", int(value.p), int(value.q))) if value.q != 1 else Expr(int(value.p))
    if isinstance(value, (sympy.Symbol, sympy.MatrixSymbol)):
        return Z if value == _Z else sym(value.name)
    if isinstance(value, sympy.Indexed):
        return Expr(("at", value.base.label.name, *(from_sympy(i).tree for i in value.indices)))
    if isinstance(value, sympy.MatrixBase):
        return Expr(("rows", *(tuple(from_sympy(value[i, j]).tree for j in range(value.cols)) for i in range(value.rows))))
    if isinstance(value, (sympy.Pow, sympy.MatPow)) and not isinstance(value, sympy.Inverse):
        base, exponent = from_sympy(value.args[0]), value.args[1]
        if exponent == sympy.Rational(1, 2):
            return Expr(("sqrt", base.tree))
        if exponent.is_Integer and exponent < 0 and not value.is_Matrix:
            return 1 / (base if exponent == -1 else base ** int(-exponent))
        return base ** from_sympy(exponent)
    for kind, op in _RELATIONS.items():
        if isinstance(value, kind):
            args = value.args[:1] if op == "inv" else value.args
            return Expr((op, *(from_sympy(a).tree for a in args)))
    raise Unsupported(f"{type(value).__name__} of sympy has no counterpart in exactkf.language")
