# SPDX-License-Identifier: MIT
"""Printing trees: what every notation shares.

`Notation` walks a tree once and puts parentheses where the binding strength
asks for them; `exactkf.language.latex` and `exactkf.language.text` say how
each operation looks. Nothing is simplified or reordered on the way.

An operation that is no more than a pattern is a `Form`: ``#1``, ``#2`` stand
for its arguments, and ``needs`` for how tightly each must bind to go without
parentheses. The others are methods of the same name as in `METHODS`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Any

from exactkf._errors import BadInput
from exactkf.language.tree import OPERATIONS, Expr, bottom, top

__all__ = ["RANGES", "Bind", "Form", "Notation", "fill", "rows_of", "values_and_trees"]

#: types whose arguments are bounds or a degree, not the sides of a matrix
RANGES = ("integer", "sequence", "signal", "poly", "monic")


class Bind(IntEnum):
    """Binding strengths, loosest first; LOOSE takes anything without parentheses."""

    LOOSE = 0
    QUANTIFIER = 1
    IMPLIES = 2
    OR = 3
    AND = 4
    NOT = 5
    RELATION = 6
    CASES = 7
    SUM = 8
    NEGATIVE = 9
    BIG = 10
    PRODUCT = 11
    FRACTION = 12
    POWER = 13
    ATOM = 14


#: operation -> method, where the names differ
METHODS = {
    "+": "add", "*": "times", "/": "over", "^": "power", "if": "cases", "I": "identity", "O": "zero", "sym": "name",
    "rat": "rational", "sum": "sum_of", "prod": "product_of", "forall": "every", "exists": "some", "=>": "implies",
    "and": "conjunction", "or": "disjunction",
}


@dataclass(frozen=True)
class Form:
    """How an operation looks: its own strength, a pattern, and what each argument needs."""

    strength: int
    pattern: str
    needs: tuple[int, ...] = (Bind.LOOSE,)


class Notation:
    """A way to print trees; a call returns the text of one.

    Parameters
    ----------
    values : collection of str
        Names known to stand for numbers, matrices or polynomials rather than indices:
        ``f[x]`` is then a value of a function, not an entry of a sequence.
    functions : collection of str
        Names printed as functions whatever their arguments, see `functions_in`.
    """

    forms: Mapping[str, Form] = {}
    relations: Mapping[str, str] = {}
    joints: Mapping[str, str] = {}

    def __init__(self, values: Collection[str] = (), functions: Collection[str] = ()) -> None:
        self.values = frozenset(values)
        self.functions = frozenset(functions)

    def __call__(self, tree: Any) -> str:
        return self.show(tree)[0]

    def arg(self, tree: Any, need: int = Bind.LOOSE) -> str:
        """Text of an argument, in parentheses if it binds less tightly than needed."""
        text, strength = self.show(tree)
        return text if strength >= need else self.parens(text)

    def show(self, tree: Any) -> tuple[str, int]:
        """Text and strength."""
        if isinstance(tree, bool) or not isinstance(tree, (int, tuple)) or tree == ():
            raise BadInput(f"{tree!r} is not a term; expected an int or an operation")
        if isinstance(tree, int):
            return str(tree), (Bind.ATOM if tree >= 0 else Bind.NEGATIVE)
        op, *args = tree
        if op in self.forms:
            return self._fill(self.forms[op], args)
        if op in self.relations:
            return self.relations[op].join(self.arg(a, Bind.CASES) for a in args), Bind.RELATION
        method: Callable[..., tuple[str, int]] | None = getattr(self, METHODS.get(op, str(op)), None)
        if op not in OPERATIONS or method is None:
            raise BadInput(f"unknown operation {op!r}; see exactkf.language.OPERATIONS")
        return method(*args)

    def parens(self, text: str) -> str:
        """Text in round brackets."""
        return f"({text})"

    def _fill(self, form: Form, args: list) -> tuple[str, int]:
        needs = (*form.needs, *[form.needs[-1]] * len(args))
        texts = [self.arg(arg, need) for arg, need in zip(args, needs, strict=False)]
        return fill(form.pattern, texts), form.strength

    def list_of(self, args: Any, need: int = Bind.LOOSE) -> str:
        """Arguments with commas between."""
        return ", ".join(self.arg(a, need) for a in args)

    def add(self, *args: Any) -> tuple[str, int]:
        first = self.arg(args[0], Bind.SUM if _op(args[0]) != "+" else Bind.NEGATIVE)
        return " + ".join([first, *(self.arg(a, Bind.BIG) for a in args[1:])]), Bind.SUM

    def neg(self, arg: Any) -> tuple[str, int]:
        return "-" + self.arg(arg, Bind.BIG), Bind.NEGATIVE

    def signed_first(self, arg: Any, need: int) -> tuple[str, int]:
        """First factor: a minus sign in front needs no parentheses, but the product then binds like a negative."""
        text, strength = self.show(arg)
        if strength == Bind.NEGATIVE:
            return text, Bind.NEGATIVE
        return (text if strength >= need else self.parens(text)), Bind.PRODUCT

    def conjunction(self, *args: Any) -> tuple[str, int]:
        return self.joints["and"].join(self.arg(a, Bind.NOT) for a in args), Bind.AND

    def disjunction(self, *args: Any) -> tuple[str, int]:
        return self.joints["or"].join(self.arg(a, Bind.AND) for a in args), Bind.OR

    def implies(self, left: Any, right: Any) -> tuple[str, int]:
        """The right side may be a quantifier: it reaches to the end anyway."""
        need = Bind.LOOSE if _op(right) in ("forall", "exists", "always") else Bind.OR
        return self.arg(left, Bind.OR) + self.joints["=>"] + self.arg(right, need), Bind.IMPLIES

    def is_subscripted(self, name: str, args: Any) -> bool:
        """Whether the arguments of a name go below it, as for a sequence."""
        return name not in self.functions and all(self.is_index(a) for a in args)

    def functions_in(self, trees: Any) -> set[str]:
        """Names that some tree applies to what is no index; they are then functions everywhere."""
        return {t[1] for t in _subtrees(trees) if _op(t) == "at" and not all(self.is_index(a) for a in t[2:])}

    def is_index(self, tree: Any) -> bool:
        """Whether a term looks like an index: a sum or product of whole numbers and small letters."""
        if isinstance(tree, int):
            return True
        if _op(tree) == "sym":
            stem = tree[1].split("_")[0].rstrip("0123456789")
            return len(stem) == 1 and stem.islower() and tree[1] not in self.values
        return _op(tree) in ("+", "-", "*", "neg") and all(self.is_index(a) for a in tree[1:])


def values_and_trees(statement: Any) -> tuple[set[str], tuple]:
    """Names that stand for values rather than indices in a statement, and all its trees."""
    values = {name for name, type_ in statement.over if type_[0] != "integer"}
    return values, (statement.where, tuple(g[1] for g in statement.given), statement.says)


def fill(pattern: str, texts: Sequence[str]) -> str:
    """The pattern with ``#1``, ``#2`` ... replaced by the texts."""
    return re.sub(r"#(\d)", lambda match: texts[int(match[1]) - 1], pattern)


def rows_of(mat: tuple) -> str:
    """``top`` or ``bottom`` if one of these built the matrix (arguments of ``mat``), else nothing."""
    i, j, nrows, _, body = mat
    if (i, j) == ("i_", "j_") and _op(body) == "entry":
        for build in (top, bottom):
            if build(Expr(body[1]), Expr(nrows)).tree == ("mat", *mat):
                return build.__name__
    return ""


def _op(tree: Any) -> str:
    return tree[0] if isinstance(tree, tuple) and tree else ""


def _subtrees(tree: Any) -> Iterator[Any]:
    yield tree
    if isinstance(tree, tuple):
        for branch in tree:
            yield from _subtrees(branch)
