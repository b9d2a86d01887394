# SPDX-License-Identifier: MIT
"""Matrices that exist by a classical theorem, whatever the others are.

A printed "there are L, U and D with ..." is stated for all L, U and D with the equations that
the theorem gives: where the theorem applies, the statement for all of them is one for some.
A certificate of kind ``existence`` shows that it does: a list of (theorem, term, names).

============  ==========================  ========================================  ==========================
theorem       of the term                 variables                                 hypotheses that it meets
============  ==========================  ========================================  ==========================
``spectral``  S symmetric                 U a square matrix, D a diagonal one       T(U) U = I and S = U D T(U)
``square``    P positive definite         L nonsingular                             P = L T(L)
============  ==========================  ========================================  ==========================

The term has a value, and is what it has to be, without the hypotheses that mention the
variables or such as are chosen after them; and no other hypothesis mentions them. So
the variables may be chosen in their order, after all others. What the conclusion
says of them has a value whatever they are.

Main definitions
----------------
`THEOREMS`
    Their names, and what they say.
`existence`
    Replays a certificate.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from exactkf.kernel.definite import definiteness, exists
from exactkf.kernel.numbers import Rejected
from exactkf.kernel.reader import Reader, hypotheses
from exactkf.kernel.words import Blocks

__all__ = ["THEOREMS", "existence"]

THEOREMS = {
    "spectral": "a real symmetric matrix is U D U' with an orthogonal U and a diagonal D",
    "square": "a positive definite matrix is L L' with a nonsingular L",
}


def existence(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    """The variables chosen exist, for all values of the others that satisfy the other hypotheses."""
    choices = evidence["choices"]
    _need(bool(choices), "nothing is chosen")
    types = {name: list(kind) for name, kind in statement["over"]}
    names = [name for _, _, chosen in choices for name in chosen]
    _need(all(name in types for name in names) and len(set(names)) == len(names), "variables of the statement are chosen, each once")
    said = [formula for _, formula in hypotheses(statement)]
    for place, (theorem, term, chosen) in enumerate(choices):
        open_ = {name for _, _, later in choices[place:] for name in later}
        _need(not open_ & _mentioned(statement, term), "a term depends on what is chosen by it or after it")
        before = [["", formula, "standing"] for formula in said if not open_ & _mentioned(statement, formula)]
        met = _met(Reader({**statement, "given": before}), theorem, term, chosen, types)
        _need(all(formula in said for formula in met), f"{theorem}: the statement does not say what the theorem gives")
        said = [formula for formula in said if formula not in met]
    _need(not any(set(names) & _mentioned(statement, formula) for formula in said), "more is asked of what is chosen than the theorems give")
    _has_value(statement, statement["says"], set(names))
    return []


def _has_value(statement: Mapping[str, Any], formula: Any, names: set[str]) -> None:
    """The conclusion has a value whatever is chosen: what it inverts is nonsingular by its form, or by a member of it that comes before."""
    for member in formula[1:] if formula[0] == "and" else [formula]:
        _need(not names & _mentioned(statement, member) or exists(Reader(statement), member, []), "the conclusion need not have a value for what is chosen")
        statement = {**statement, "given": [*statement["given"], ["", member, "standing"]]}


def _need(condition: bool, step: str) -> None:
    if not condition:
        raise Rejected(step)


def _met(reader: Reader, theorem: str, term: Any, chosen: Sequence[str], types: Mapping[str, list]) -> list[Any]:
    """The equations that a theorem gives."""
    found = reader.read(term) if exists(reader, term, []) else None
    if not isinstance(found, Blocks) or len(found.rows) != 1 or found.rows != found.cols:
        raise Rejected(f"{theorem}: not of a square matrix in one block that has a value")
    kinds = [types[name] for name in chosen]
    if theorem == "spectral":
        turned = reader.transpose(found)
        _need(turned.grid == found.grid, "spectral: not symmetric by its form")
        _need([k[0] for k in kinds] == ["matrix", "diagonal"] and all(_as_large(reader, found, x) for k in kinds for x in k[1:]),
              "spectral: a square matrix and a diagonal one of this size are chosen")
        u, d = (["sym", name] for name in chosen)
        return [["=", ["*", ["T", u], u], ["I", kinds[0][1]]], ["=", term, ["*", u, d, ["T", u]]]]
    _need(theorem == "square", f"{theorem!r} is no theorem of the list")
    _need(definiteness(reader, term) == 2, "square: not definite by its form")
    _need([k[0] for k in kinds] == ["nonsingular"] and _as_large(reader, found, kinds[0][1]), "square: a nonsingular matrix of this size is chosen")
    root = ["sym", chosen[0]]
    return [["=", term, ["*", root, ["T", root]]]]


def _as_large(reader: Reader, found: Blocks, extent: Any) -> bool:
    return reader.total(found.rows) == reader.size(extent)


def _mentioned(statement: Mapping[str, Any], tree: Any) -> set[str]:
    """Names in a tree, and in what they stand for."""
    found: set[str] = set()
    todo = [tree]
    bodies = {definition[1]: definition[2:] for definition in statement["where"]}
    while todo:
        part = todo.pop()
        if isinstance(part, str):
            if part not in found:
                found.add(part)
                todo.extend(bodies.get(part, ()))
        elif isinstance(part, (list, tuple)):
            todo.extend(part)
    return found
