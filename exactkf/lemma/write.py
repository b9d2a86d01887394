# SPDX-License-Identifier: MIT
"""A statement as the text of a lemma, which `exactkf.lemma.grammar` reads back.

Main definitions
----------------
`write_lemma`
    Statement to text.
"""

from __future__ import annotations

from typing import Any

from exactkf._errors import BadInput
from exactkf.language.notation import Bind
from exactkf.language.statement import Statement
from exactkf.language.text import Text

__all__ = ["write_lemma"]

_KINDS = {"symmetric": "symmetric", "psd": "positive semidefinite", "pd": "positive definite", "nonsingular": "invertible", "diagonal": "diagonal"}
_SCALARS = {"scalar": "", "nonzero": " nonzero", "positive": " positive", "nonneg": " nonnegative"}


class _Grammar(Text):
    """Plain text in the grammar of a lemma."""

    forms = {op: form for op, form in Text.forms.items() if op != "loewner"}
    relations = {**Text.relations, "=": " == ", "loewner": " >= "}

    def signed_first(self, arg: Any, need: int) -> tuple[str, int]:
        """A negative first factor goes in brackets: a sign in front belongs to the whole product."""
        return self.arg(arg, need), Bind.PRODUCT

    def at(self, name: str, *args: Any) -> tuple[str, int]:
        return f"{name}[{self.list_of(args)}]", Bind.ATOM

    def always(self, index: str, body: Any) -> tuple[str, int]:
        return f"for all {index}: {self(body)}", Bind.QUANTIFIER


def write_lemma(statement: Statement) -> str:
    """The text of a lemma.

    Raises
    ------
    BadInput
        If the statement uses what the grammar does not have.

    Examples
    --------
    >>> from exactkf.lemma.grammar import read_lemma
    >>> print(write_lemma(read_lemma("sizes n\\nmatrix A n n\\nassume A*A == I\\nclaim A == A^-1")), end="")
    sizes n
    matrix A n n
    assume A*A == I: A*A == I(n)
    claim A == A^-1
    """
    show = _Grammar()
    lines = [f"sizes {' '.join(statement.sizes)}"] if statement.sizes else []
    lines += [_variable(show, name, kind) for name, kind in tuple(statement.over)]
    lines += [line for definition in statement.where for line in _definition(show, definition)]
    for label, formula, _ in tuple(statement.given):
        written = show(formula)
        lines.append(f"assume {written}" if label == written else f"assume {label}: {written}")
    says = statement.says[1:] if statement.says[0] == "and" else (statement.says,)
    return "".join(f"{line}\n" for line in [*lines, *(f"claim {show(part)}" for part in says)])


def _variable(show: Text, name: str, kind: tuple) -> str:
    if kind[0] in _SCALARS:
        return f"scalar {name}{_SCALARS[kind[0]]}"
    sizes = [show(size).replace(" ", "") for size in kind[1:]]
    if kind[0] == "matrix":
        return f"matrix {name} {' '.join(sizes)}"
    if kind[0] not in _KINDS:
        raise BadInput(f"variable {name!r} has type {kind[0]!r}, which the grammar of lemmas does not have; use a matrix or a scalar")
    return f"matrix {name} {sizes[0]} {sizes[0]} {_KINDS[kind[0]]}"


def _definition(show: Text, definition: tuple) -> list[str]:
    if definition[0] == "let" and not definition[2]:
        return [f"let {definition[1]} = {show(definition[3])}"]
    if definition[0] == "rec" and definition[3] == 0 and len(definition[4]) == 1:
        _, name, index, _, (first,), step = definition
        return [f"let {name}[0] = {show(first)}", f"let {name}[{index}+1] = {show(step)}"]
    raise BadInput(f"definition of {definition[1]!r} is no term and no sequence from 0 on; the grammar of lemmas has only these")
