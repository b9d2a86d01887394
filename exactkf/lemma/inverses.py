# SPDX-License-Identifier: MIT
"""The inverses that a lemma takes for granted.

A term with an inverse has a value only where the inverse exists, and a proof
in words of letters is about those values alone. That is honest only if the
lemma says, or implies, that the inverses exist. Here each inverse that the
claim mentions is shown to exist under the assumptions: by a type or an
assumption, because the matrix is definite by its form, or by a term that is
its inverse (such as a letter, or the other side of the claim). Each showing is
a certificate of its own, of the statement "X is invertible".

Main definitions
----------------
`claimed_inverses`
    The matrices and numbers that claim and definitions invert.
`show_inverse`
    A certificate that one of them is invertible, or None.
`square_sequences`
    The sequences of square matrices.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from typing import Any

from exactkf.finders.membership import find_order
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.replay import NotACertificate, Rejected, replay, seal
from exactkf.language.statement import as_lists, as_tuples
from exactkf.lemma.classical import by_classical_facts
from exactkf.lemma.sizes import SCALAR, ZERO, Misfit, Sizes, size_tree

__all__ = ["claimed_inverses", "exists_by_assumption", "invertibility", "show_inverse", "square_sequences"]


def claimed_inverses(data: Mapping[str, Any]) -> list[tuple[Any, dict]]:
    """Terms that the claim inverts, directly or through definitions, innermost first, each with the statement whose assumptions must grant it.

    An assumption that holds has a value, and so have its inverses; the premise of an implication is assumed for what follows from it.
    Inverses in the step of a sequence are left out: a sequence goes as far as it has values.
    """
    found: dict[str, tuple[Any, dict]] = {}
    for part in data["says"][1:] if data["says"][0] == "and" else [data["says"]]:
        context = dict(data)
        while part[0] == "=>":
            _collect(found, part[1], context)
            context, part = {**context, "given": [*context["given"], *_premises(part[1], len(context["given"]))]}, part[2]
        _collect(found, part, context)
    return list(found.values())


def _premises(formula: Any, count: int) -> list:
    parts = formula[1:] if formula[0] == "and" else [formula]
    return [[f"premise {count + k}", part, "standing"] for k, part in enumerate(parts, 1)]


def _collect(found: dict[str, tuple[Any, dict]], formula: Any, context: dict) -> None:
    granted = {repr(x) for _, given, _ in context["given"] for x in _inverted(given, context)}
    for term in _inverted(formula, context):
        if repr(term) not in granted:
            found.setdefault(repr(term), (term, context))


def _inverted(tree: Any, data: Mapping[str, Any]) -> Iterator[Any]:
    if not isinstance(tree, list) or not tree:
        return
    parts = [cell for row in tree[1:] for cell in row] if tree[0] in ("block", "rows") else tree[1:]
    for part in parts:
        yield from _inverted(part, data)
    if tree[0] == "sym":
        for d in data["where"]:
            if d[0] == "let" and d[1] == tree[1] and not d[2]:
                yield from _inverted(d[3], data)
    negative = tree[0] == "^" and isinstance(tree[2], int) and tree[2] < 0
    divisor = tree[1] if tree[0] == "inv" or negative else tree[2] if tree[0] == "/" else 1
    if not isinstance(divisor, int) and divisor[0] not in ("rat", "I"):
        yield divisor


def invertibility(data: Mapping[str, Any], term: Any) -> list:
    """The formula that says that the inverse of a term exists."""
    return ["!=", term, 0] if _shape(data, term) in (SCALAR, ZERO) else ["invertible", term]


def exists_by_assumption(data: Mapping[str, Any], term: Any) -> str:
    """The type or assumption that says so in as many words; empty if none does."""
    kind = dict(data["over"]).get(term[1], ("",))[0] if term[0] == "sym" else ""
    if kind in ("nonsingular", "pd", "nonzero", "positive"):
        return "by its type"
    for label, formula, _ in data["given"]:
        for part in formula[1:] if formula[0] == "and" else [formula]:
            if part[0] in ("invertible", "pd") and part[1] == term or part in (["!=", term, 0], [">", term, 0], ["<", 0, term]):
                return f"by assumption {label!r}"
    return ""


def show_inverse(data: Mapping[str, Any], term: Any, degree: int, seconds: float) -> dict | None:
    """A certificate that a matrix is invertible under the assumptions, or None.

    Parameters
    ----------
    data : dict
        JSON of the statement.
    term : tree
        The matrix.
    degree, seconds
        Bounds of each search.
    """
    goal = {**data, "says": ["invertible", term]}
    for inverse in [None, *_candidates(data, term)]:
        try:
            parts = find_order(goal, [[inverse]] if inverse is not None else (), degree=degree, seconds=seconds)
            if parts is not None:
                certificate = seal("lemma: an inverse exists", "order", goal, {"parts": parts, "lemmas": []})
                replay(certificate)
                return certificate
        except (Rejected, NotACertificate, Undefined, Unknown):
            continue
    for evidence in by_classical_facts(goal, degree, seconds):
        certificate = seal("lemma: an inverse exists", "order", goal, evidence)
        with suppress(Rejected, NotACertificate, Undefined, Unknown):
            replay(certificate)
            return certificate
    return None


def _candidates(data: Mapping[str, Any], term: Any) -> Iterator[Any]:
    """Terms of the right size that may be the inverse: letters, their transposes, sides of the claim and of assumptions."""
    shape = _shape(data, term)
    letters: list[Any] = [["sym", name] for name, _ in data["over"]]
    sides = [side for formula in (data["says"], *(f for _, f, _ in data["given"])) for side in _sides(formula)]
    for tree in [*_pushed_through(data, term), *sides, *letters, *(["T", x] for x in letters)]:
        if tree != term and tree != ["inv", term] and _shape(data, tree) == shape:
            yield tree


def _pushed_through(data: Mapping[str, Any], term: Any) -> Iterator[Any]:
    """For I + AB the term I - A (I + BA)^-1 B, its inverse where the one in the middle exists."""
    if term[0] not in ("+", "-") or len(term) != 3 or term[1][:1] != ["I"] or term[2][:1] != ["*"]:
        return
    factors = term[2][1:]
    for k in range(1, len(factors)):
        inner = _shape(data, _product(factors[:k]))
        if isinstance(inner, tuple):
            middle = ["inv", [term[0], ["I", as_lists(size_tree(inner[1]))], ["*", *factors[k:], *factors[:k]]]]
            yield ["-" if term[0] == "+" else "+", term[1], ["*", *factors[:k], middle, *factors[k:]]]


def _product(factors: list) -> Any:
    return factors[0] if len(factors) == 1 else ["*", *factors]


def _sides(formula: Any) -> Iterator[Any]:
    """Sides of equations, and the other factor where a product is an identity."""
    if formula[0] in ("and", "=>"):
        for part in formula[1:]:
            yield from _sides(part)
    elif formula[0] == "=":
        for side in formula[1:]:
            if isinstance(side, list):
                yield side
                if side[0] == "*" and len(side) > 2:
                    yield from (side[1] if len(side) == 3 else ["*", *side[1:-1]], side[2] if len(side) == 3 else ["*", *side[2:]])


def square_sequences(data: Mapping[str, Any]) -> list[str]:
    """Names of the sequences of square matrices."""
    shapes = {d[1]: _shape(data, ["sym", d[1]]) for d in data["where"] if d[0] == "rec"}
    return [name for name, found in shapes.items() if isinstance(found, tuple) and found[0] == found[1]]


def _shape(data: Mapping[str, Any], term: Any) -> Any:
    sizes = Sizes(data["sizes"])
    try:
        for name, kind in data["over"]:
            sizes.declare(name, as_tuples(kind))
        for d in data["where"]:
            if d[0] == "let" and not d[2]:
                sizes.define(d[1], as_tuples(d[3]))
            elif d[0] == "rec":
                sizes.define(d[1], as_tuples(d[4][0]))
        return sizes.term(as_tuples(term))[1]
    except Misfit:
        return None
