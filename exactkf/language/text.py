# SPDX-License-Identifier: MIT
"""Readable plain text of terms and statements, for terminals and messages.

Names stand as they are written in Python, products have a star, ``P'`` is
the transpose, ``P^-1`` the inverse; all characters are ASCII.
"""

from __future__ import annotations

from typing import Any

from exactkf.language.notation import RANGES, Bind, Form, Notation, fill, rows_of, values_and_trees
from exactkf.language.statement import Statement, as_tuples

__all__ = ["Text", "statement_text", "text"]


class Text(Notation):
    """Plain text notation."""

    forms = {
        "z": Form(Bind.ATOM, "z"),
        "-": Form(Bind.SUM, "#1 - #2", (Bind.SUM, Bind.BIG)),
        "sqrt": Form(Bind.ATOM, "sqrt(#1)"),
        "cospi": Form(Bind.ATOM, "cos(pi*#1/#2)", (Bind.POWER, Bind.POWER)),
        "abs": Form(Bind.ATOM, "|#1|"),
        "T": Form(Bind.POWER, "#1'", (Bind.ATOM,)),
        "inv": Form(Bind.POWER, "#1^-1", (Bind.ATOM,)),
        "det": Form(Bind.ATOM, "det(#1)"),
        "tr": Form(Bind.ATOM, "trace(#1)"),
        "rank": Form(Bind.ATOM, "rank(#1)"),
        "charpoly": Form(Bind.ATOM, "det(z*I - #1)", (Bind.BIG,)),
        "stein": Form(Bind.ATOM, "stein(#1, #2)"),
        "kernel": Form(Bind.ATOM, "null(#1)"),
        "nrows": Form(Bind.ATOM, "rows(#1)"),
        "ncols": Form(Bind.ATOM, "cols(#1)"),
        "I": Form(Bind.ATOM, "I(#1)"),
        "O": Form(Bind.ATOM, "O(#1, #2)"),
        "deg": Form(Bind.ATOM, "deg(#1)"),
        "coeff": Form(Bind.ATOM, "coeff(#1, z^#2)", (Bind.LOOSE, Bind.POWER)),
        "laurent": Form(Bind.ATOM, "coeff_at_inf(#1, z^-#2)", (Bind.LOOSE, Bind.POWER)),
        "rev": Form(Bind.PRODUCT, "z^#2 * #1(1/z)", (Bind.ATOM, Bind.POWER)),
        "recip": Form(Bind.ATOM, "#1(1/z)", (Bind.ATOM,)),
        "subst": Form(Bind.ATOM, "#1(#2)", (Bind.ATOM, Bind.LOOSE)),
        "roots_in": Form(Bind.ATOM, "roots(#1; |z| < 1)"),
        "roots_on": Form(Bind.ATOM, "roots(#1; |z| = 1)"),
        "roots_out": Form(Bind.ATOM, "roots(#1; |z| > 1)"),
        "real_roots": Form(Bind.ATOM, "roots(#1; #2 < z <= #3)"),
        "loewner": Form(Bind.RELATION, "#1 >= #2 (Loewner)", (Bind.SUM,)),
        "psd": Form(Bind.RELATION, "#1 psd", (Bind.SUM,)),
        "pd": Form(Bind.RELATION, "#1 pd", (Bind.SUM,)),
        "symmetric": Form(Bind.RELATION, "#1 symmetric", (Bind.SUM,)),
        "invertible": Form(Bind.RELATION, "#1 invertible", (Bind.SUM,)),
        "symplectic": Form(Bind.RELATION, "#1 symplectic", (Bind.SUM,)),
        "observable": Form(Bind.RELATION, "(#1, #2) observable"),
        "detectable": Form(Bind.RELATION, "(#1, #2) detectable"),
        "schur": Form(Bind.RELATION, "#1 Schur stable", (Bind.SUM,)),
        "defined": Form(Bind.RELATION, "#1 defined", (Bind.SUM,)),
        "similar": Form(Bind.RELATION, "#1 similar to #2", (Bind.SUM,)),
        "cospectral": Form(Bind.RELATION, "#1, #2 cospectral", (Bind.SUM,)),
        "coprime": Form(Bind.RELATION, "#1, #2 coprime", (Bind.SUM,)),
        "pos_circle": Form(Bind.RELATION, "#1 > 0 on |z| = 1", (Bind.SUM,)),
        "nonneg_circle": Form(Bind.RELATION, "#1 >= 0 on |z| = 1", (Bind.SUM,)),
        "not": Form(Bind.NOT, "not #1", (Bind.ATOM,)),
        "<=>": Form(Bind.IMPLIES, "#1 <=> #2", (Bind.OR,)),
    }
    relations = {"=": " = ", "!=": " != ", "<": " < ", "<=": " <= ", ">": " > ", ">=": " >= "}
    joints = {"and": " and ", "or": " or ", "=>": " => "}

    def name(self, name: str) -> tuple[str, int]:
        return name, Bind.ATOM

    def rational(self, over: int, under: int) -> tuple[str, int]:
        return f"{over}/{under}", (Bind.PRODUCT if over >= 0 else Bind.NEGATIVE)

    def at(self, name: str, *args: Any) -> tuple[str, int]:
        left, right = "[]" if self.is_subscripted(name, args) else "()"
        return f"{name}{left}{self.list_of(args)}{right}", Bind.ATOM

    def entry(self, base: Any, *index: Any) -> tuple[str, int]:
        return f"{self.arg(base, Bind.POWER)}[{self.list_of(index)}]", Bind.ATOM

    def times(self, *args: Any) -> tuple[str, int]:
        first, strength = self.signed_first(args[0], Bind.POWER)
        return "*".join([first, *(self.arg(a, Bind.POWER) for a in args[1:])]), strength

    def over(self, left: Any, right: Any) -> tuple[str, int]:
        text, strength = self.signed_first(left, Bind.PRODUCT)
        return f"{text}/{self.arg(right, Bind.POWER)}", strength

    def power(self, base: Any, exponent: Any) -> tuple[str, int]:
        raised = f"-{-exponent}" if isinstance(exponent, int) and exponent < 0 else self.arg(exponent, Bind.POWER)
        return f"{self.arg(base, Bind.ATOM)}^{raised}", Bind.POWER

    def cases(self, condition: Any, then: Any, otherwise: Any) -> tuple[str, int]:
        condition_, otherwise_ = self.arg(condition, Bind.OR), self.arg(otherwise, Bind.CASES)
        return f"{self.arg(then, Bind.SUM)} if {condition_} else {otherwise_}", Bind.CASES

    def sum_of(self, index: str, low: Any, high: Any, body: Any) -> tuple[str, int]:
        return f"sum({index}={self(low)}..{self(high)}: {self(body)})", Bind.ATOM

    def product_of(self, index: str, low: Any, high: Any, body: Any) -> tuple[str, int]:
        return f"prod({index}={self(low)}..{self(high)}: {self(body)})", Bind.ATOM

    def mat(self, i: str, j: str, nrows: Any, ncols: Any, body: Any) -> tuple[str, int]:
        part = rows_of((i, j, nrows, ncols, body))
        if part:
            return f"{part}({self(body[1])}, {self(nrows)})", Bind.ATOM
        return f"[{self(body)} | {i}=1..{self(nrows)}, {j}=1..{self(ncols)}]", Bind.ATOM

    def col(self, i: str, length: Any, body: Any) -> tuple[str, int]:
        return f"[{self(body)} | {i}=1..{self(length)}]", Bind.ATOM

    def block(self, *table: Any) -> tuple[str, int]:
        return "[" + "; ".join(self.list_of(row) for row in table) + "]", Bind.ATOM

    rows = block

    def diag(self, *args: Any) -> tuple[str, int]:
        return f"diag({self.list_of(args)})", Bind.ATOM

    def prints(self, value: Any, printed: Any) -> tuple[str, int]:
        if not isinstance(printed, str):
            printed = "[" + "; ".join(", ".join(row) for row in printed) + "]"
        return f"{self.arg(value, Bind.SUM)} prints {printed}", Bind.RELATION

    def every(self, index: str, low: Any, high: Any, body: Any) -> tuple[str, int]:
        return f"for all {index}={self(low)}..{self(high)}: {self(body)}", Bind.QUANTIFIER

    def some(self, index: str, low: Any, high: Any, body: Any) -> tuple[str, int]:
        return f"for some {index}={self(low)}..{self(high)}: {self(body)}", Bind.QUANTIFIER

    def always(self, index: str, body: Any) -> tuple[str, int]:
        return f"for all {index} >= 0: {self(body)}", Bind.QUANTIFIER


#: type -> text; #1 is the name, #2 and #3 the type's arguments
_TYPES = {
    "scalar": "#1 real", "nonzero": "#1 real, not 0", "positive": "#1 > 0", "nonneg": "#1 >= 0",
    "integer": "#1 in #2..#3", "sequence": "#1[#2..#3] real",
    "signal": "#1[#2], #1[#2 + 1], ... real", "matrix": "#1 #2 x #3",
    "symmetric": "#1 #2 x #2 symmetric", "psd": "#1 #2 x #2 psd", "pd": "#1 #2 x #2 pd",
    "nonsingular": "#1 #2 x #2 invertible", "diagonal": "#1 #2 x #2 diagonal",
    "poly": "#1 polynomial in z, degree <= #2", "monic": "#1 monic polynomial in z of degree #2",
}


def text(tree: Any) -> str:
    """Plain text of a tree.

    >>> from exactkf.language import symbols, T
    >>> Phi, P, H = symbols("Phi P H")
    >>> text((Phi * P * T(Phi) + H).tree)
    "Phi*P*Phi' + H"
    """
    tree = as_tuples(tree)
    return Text(functions=Text().functions_in(tree))(tree)


def statement_text(statement: Statement) -> str:
    """Plain text of a statement, one line for each variable, definition and hypothesis, the conclusion last."""
    values, trees = values_and_trees(statement)
    show = Text(values, Text(values).functions_in(trees))
    lines = [f"for   {name} = 0, 1, 2, ..." for name in statement.sizes]
    lines += [f"for   {_typed(show, name, type_)}" for name, type_ in tuple(statement.over)]
    lines += [f"with  {line}" for definition in statement.where for line in _definition(show, definition)]
    lines += [f"given {show(formula)}    ({label})" for label, formula, _ in statement.given]
    return "\n".join([*lines, f"then  {show(statement.says)}" if lines else show(statement.says)])


def _typed(show: Text, name: str, type_: tuple) -> str:
    if type_[0] in ("sequence_of", "signal_of"):
        first, *last = (show.arg(a, Bind.LOOSE) for a in type_[1:-1])
        return _typed(show, f"{name}[{first}..{last[0]}]" if last else f"{name}[{first}], {name}[{first} + 1], ...", type_[-1])
    need = Bind.LOOSE if type_[0] in RANGES else Bind.POWER
    return fill(_TYPES[type_[0]], [name, *(show.arg(a, need) for a in type_[1:])])


def _definition(show: Text, definition: tuple) -> list[str]:
    if definition[0] == "let":
        _, name, params, body = definition
        left = show(("at", name, *(("sym", p) for p in params))) if params else name
        return [f"{left} := {show(body)}"]
    _, name, index, start, initial, step = definition
    first = [f"{name}[{start + k}] := {show(value)}" for k, value in enumerate(initial)]
    return [*first, f"{name}[{index} + 1] := {show(step)}"]
