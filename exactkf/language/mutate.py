# SPDX-License-Identifier: MIT
"""Wrong neighbours and equal rewritings of a statement, made from its tree.

A mutant changes the conclusion in one place, in the ways papers go wrong: a
sign, a term, a factor, an index, the order of two factors, a transpose or an
inverse, a relation, the last printed digit; or it drops a hypothesis that is
needed. Inside a predicate such as "is invertible" or "is at most", outside of
equivalences, a factor two or a missing term mostly gives another true
statement; there only signs, indices, orders, transposes and relations are
changed, and under "for all t" not the indices either, nor in an equation that
names t once: what holds for every t holds for t + 1.

A relation is weakened or strengthened both ways in an equivalence and in the
condition of a case. Elsewhere a weaker conclusion is a true one, and a stronger
statement (a strict relation concluded, a weak one assumed, an implication made
an equivalence) may be true too without the print's denying it: such a mutant
is ``stronger``, and shows, where it is rejected, that the print is sharp.

An equal rewriting (sums reversed, sides exchanged, names renamed) must change
nothing.

Main definitions
----------------
`Mutant`
    What was changed, where, and the changed conclusion (or dropped hypothesis).
`mutants`, `rewritings`
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

__all__ = ["Mutant", "mutants", "rewritings"]


@dataclass(frozen=True)
class Mutant:
    """One wrong neighbour.

    ``path`` leads to the changed node of the conclusion; ``drops`` is the label of a dropped hypothesis, or '', and ``weaker`` what stands in
    its place, if anything. One that is ``stronger`` says more than the original, which may be true.
    """

    kind: str
    says: Any
    path: tuple[int, ...] = ()
    drops: str = ""
    weaker: Any = None
    stronger: bool = False


_TERM_RELATIONS = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}
_WEAKER = {"<": "<=", ">": ">=", "pd": "psd", "pos_circle": "nonneg_circle"}
_STRONGER_KIND = "more claimed"
_STRONGER = {weak: strict for strict, weak in _WEAKER.items()}
_INDEX_ARGUMENTS = {"at": (2, 3, 4), "entry": (2, 3), "coeff": (2,), "laurent": (2,), "rev": (2,), "sum": (2, 3), "prod": (2, 3)}
_BINDERS = {"sum": 1, "prod": 1, "forall": 1, "exists": 1, "always": 1, "col": 1, "mat": 2}
_NOT_TERMS = {"rat", "sym", "z", "prints"}


def mutants(statement: dict) -> list[Mutant]:
    """Every mutant of the conclusion, and of each hypothesis that the statement says it needs: without it, and with a weaker relation in it."""
    made: list[Mutant] = []
    seen = {_key(statement["says"])}
    for kind, says, path in _changes(statement["says"], _Place()):
        if _key(says) not in seen:
            seen.add(_key(says))
            made.append(Mutant(kind, says, path, stronger=kind == _STRONGER_KIND))
    for label, formula, kind in statement["given"]:
        if kind == "needed":
            made.append(Mutant(f"hypothesis {label!r} dropped", statement["says"], (), label))
            made.extend(Mutant(f"hypothesis {label!r} weakened", statement["says"], (), label, weaker, True) for weaker in _weaker(formula))
    return made


def _key(tree: Any) -> str:
    return repr(tree)


def _weaker(formula: Any) -> Iterator[Any]:
    """A hypothesis with one strict relation weakened."""
    for kind, new, _path in _changes(formula, _Place(side=-1)):
        if kind == _STRONGER_KIND:
            yield new


@dataclass(frozen=True)
class _Place:
    """Where a node stands. ``side`` is 1 for what is concluded, -1 for what is assumed, 0 for what is both, as in an equivalence."""

    in_equivalence: bool = False
    always: str = ""  # the index of a "for all t" around it
    side: int = 1

    def below(self, tree: list, k: int) -> _Place:
        """The place of part ``k`` of a node."""
        op = tree[0]
        side = {"not": -self.side, "<=>": 0, "if": 0 if k == 1 else self.side, "=>": -self.side if k == 1 else self.side}.get(op, self.side)
        return _Place(self.in_equivalence or op == "<=>", tree[1] if op == "always" else self.always, side)


_PREDICATES = {"<", "<=", ">", ">=", "loewner", "psd", "pd", "invertible", "schur", "observable", "detectable", "coprime",
               "pos_circle", "nonneg_circle", "defined", "!="}
_SIZE_CHANGES = ("coefficient doubled", "term dropped", "exponent shifted")


def _changes(tree: Any, place: _Place) -> Iterator[tuple[str, Any, tuple[int, ...]]]:
    """Changed copies of a tree with the path to the change."""
    if isinstance(tree, list) and tree[0] in _PREDICATES and (place.always or not place.in_equivalence):
        idle = (*(() if place.in_equivalence else _SIZE_CHANGES), *(("index shifted",) if place.always else ()))
        yield from (c for c in _every_change(tree, place) if c[0] not in idle)
    elif isinstance(tree, list) and tree[0] == "=" and place.always and repr(tree).count(repr(["sym", place.always])) == 1:
        yield from (c for c in _every_change(tree, place) if c[0] != "index shifted")
    else:
        yield from _every_change(tree, place)


def _every_change(tree: Any, place: _Place) -> Iterator[tuple[str, Any, tuple[int, ...]]]:
    if isinstance(tree, (int, str)):
        return
    for kind, new in _here(tree, place):
        yield kind, new, ()
    op = tree[0]
    if op in _NOT_TERMS:
        return
    for k in range(1, len(tree)):
        part = tree[k]
        if isinstance(part, str):
            continue
        if op in ("block", "rows"):
            for j, cell in enumerate(part):
                for kind, new, path in _changes(cell, place):
                    row = [*part[:j], new, *part[j + 1:]]
                    yield kind, [*tree[:k], row, *tree[k + 1:]], (k, j, *path)
            continue
        if k in _INDEX_ARGUMENTS.get(op, ()):
            for shift in (1, -1):
                yield "index shifted", [*tree[:k], _shifted(part, shift), *tree[k + 1:]], ()
            continue
        if isinstance(part, int):
            if op in ("+", "-", "*", "/", "=", "<", "<=", ">", ">=", "!="):
                yield "coefficient doubled", [*tree[:k], 2 * part if part else 1, *tree[k + 1:]], ()
            elif op == "^":
                yield "exponent shifted", [*tree[:k], part + 1, *tree[k + 1:]], ()
            continue
        for kind, new, path in _changes(part, place.below(tree, k)):
            yield kind, [*tree[:k], new, *tree[k + 1:]], (k, *path)


def _shifted(index: Any, by: int) -> Any:
    if isinstance(index, int):
        return index + by
    if index[0] in "+-" and len(index) == 3 and isinstance(index[2], int):
        k = index[2] + (by if index[0] == "+" else -by)
        return index[1] if k == 0 else [index[0], index[1], k]
    return ["+" if by > 0 else "-", index, 1]


def _here(tree: list, place: _Place) -> Iterator[tuple[str, Any]]:
    """Changes at the root of a tree."""
    op, args = tree[0], tree[1:]
    if op == "+":
        for k in range(len(args)):
            rest = [*args[:k], *args[k + 1:]]
            dropped = rest[0] if len(rest) == 1 else ["+", *rest]
            yield "term dropped", dropped
            yield "sign flipped", ["-", dropped, args[k]]
            if not isinstance(args[k], int):
                yield "coefficient doubled", ["+", *args[:k], ["*", 2, args[k]], *args[k + 1:]]
    elif op == "-":
        yield "sign flipped", ["+", *args]
        yield "term dropped", args[0]
        for k in (0, 1):
            if not isinstance(args[k], int):
                yield "coefficient doubled", ["-", *args[:k], ["*", 2, args[k]], *args[k + 1:]]
    elif op == "neg":
        yield "sign flipped", args[0]
    elif op == "*":
        for k in range(len(args) - 1):
            yield "factors exchanged", ["*", *args[:k], args[k + 1], args[k], *args[k + 2:]]
    elif op == "T":
        yield "transpose removed", args[0]
    elif op == "inv":
        yield "inverse removed", args[0]
    elif op == "=":
        for k, side in enumerate(args):
            if not isinstance(side, int):
                yield "factor two on one side", ["=", *args[:k], ["*", 2, side], *args[k + 1:]]
                yield "sign of one side", ["=", *args[:k], ["neg", side], *args[k + 1:]]
                if side[0] in ("sym", "at") or (side[0] == "*" and len(side) == 3):
                    yield "transpose added", ["=", *args[:k], ["T", side], *args[k + 1:]]
                    yield "inverse added", ["=", *args[:k], ["inv", side], *args[k + 1:]]
    elif op in _TERM_RELATIONS:
        yield "relation reversed", [_TERM_RELATIONS[op], *args]
    elif op == "loewner":
        yield "relation reversed", ["loewner", args[1], args[0]]
    elif op in ("psd", "pd"):
        yield "sign flipped", [op, ["neg", args[0]]]
    elif op == "=>":
        yield "hypothesis dropped", args[1]
    elif op == "prints":
        yield from _digits(tree)
    yield from _relations(op, args, place.side)


def _relations(op: str, args: list, side: int) -> Iterator[tuple[str, Any]]:
    """One relation for another that says more or less."""
    if side <= 0 and op in _WEAKER:
        yield _STRONGER_KIND if side else "relation weakened", [_WEAKER[op], *args]
    if side >= 0 and op in _STRONGER:
        yield _STRONGER_KIND if side else "relation strengthened", [_STRONGER[op], *args]
    elif side >= 0 and op == "loewner":
        yield _STRONGER_KIND if side else "relation strengthened", ["pd", ["-", *args]]
    elif side > 0 and op == "=>" and "'always'" not in repr(args):  # that something is so for all t cannot be assumed: it is seen up to a horizon
        yield _STRONGER_KIND, ["<=>", *args]


def _digits(tree: list) -> Iterator[tuple[str, Any]]:
    """The last digit of one printed number one up and one down."""
    from decimal import Decimal

    printed = tree[2]

    def changed(text: str) -> Iterator[str]:
        unit = Decimal(1).scaleb(-len(text.partition(".")[2]))
        for step in (unit, -unit):
            yield f"{Decimal(text) + step:f}"

    if isinstance(printed, str):
        for new in changed(printed):
            yield "last digit changed", ["prints", tree[1], new]
        return
    for i, row in enumerate(printed):
        for j, text in enumerate(row):
            for new in changed(text):
                table = [list(r) for r in printed]
                table[i][j] = new
                yield "last digit changed", ["prints", tree[1], table]


def rewritings(statement: dict) -> list[tuple[str, dict]]:
    """Equal rewritings of a whole statement: each must be accepted."""
    out = [("sums reversed", {**statement, "says": _reordered(statement["says"])}),
           ("sides exchanged", {**statement, "says": _exchanged(statement["says"])}),
           ("zero added", {**statement, "says": _padded(statement["says"])})]
    renamed = _renamed(statement)
    out.append(("symbols renamed", renamed))
    return [(kind, new) for kind, new in out if new != statement]


def _reordered(tree: Any) -> Any:
    if isinstance(tree, (int, str)) or tree[0] in _NOT_TERMS:
        return tree
    args = [_reordered(x) for x in tree[1:]] if tree[0] not in ("block", "rows") else [[_reordered(c) for c in r] for r in tree[1:]]
    return [tree[0], *(args[::-1] if tree[0] == "+" else args)]


def _exchanged(tree: Any) -> Any:
    if isinstance(tree, (int, str)) or tree[0] in _NOT_TERMS:
        return tree
    if tree[0] == "=":
        return ["=", *tree[1:][::-1]]
    if tree[0] in ("and", "or", "<=>", "=>", "not", "forall", "exists", "always"):
        return [tree[0], *(_exchanged(x) for x in tree[1:])]
    return tree


def _padded(tree: Any) -> Any:
    """x = y becomes 3 x = x + 2 y."""
    if isinstance(tree, (int, str)) or tree[0] in _NOT_TERMS:
        return tree
    if tree[0] == "=" and len(tree) == 3:
        return ["=", ["*", 3, tree[1]], ["+", tree[1], ["*", 2, tree[2]]]]
    if tree[0] in ("and", "or", "<=>", "=>", "not", "forall", "exists", "always"):
        return [tree[0], *(_padded(x) for x in tree[1:])]
    return tree


def _renamed(statement: dict) -> dict:
    """Every variable and definition gets another name."""
    names = {n: f"{n}_renamed" for n, _ in statement["over"]} | {d[1]: f"{d[1]}_renamed" for d in statement["where"]}

    def rename(tree: Any, bound: tuple = ()) -> Any:
        if isinstance(tree, (int, str)):
            return tree
        if tree and isinstance(tree[0], str) and tree[0] in ("sym", "at") and tree[1] in names and tree[1] not in bound:
            return [tree[0], names[tree[1]], *(rename(x, bound) for x in tree[2:])]
        if tree and isinstance(tree[0], str) and tree[0] in _BINDERS:
            bound = (*bound, *tree[1:1 + _BINDERS[tree[0]]])
        return [rename(x, bound) for x in tree]

    where = []
    for d in statement["where"]:
        if d[0] == "let":
            where.append(["let", names[d[1]], d[2], rename(d[3], tuple(d[2]))])
        else:
            where.append(["rec", names[d[1]], d[2], d[3], rename(d[4]), rename(d[5], (d[2],))])
    return {**statement, "over": [[names[n], rename(t)] for n, t in statement["over"]], "where": where,
            "given": [[label, rename(f), kind] for label, f, kind in statement["given"]], "says": rename(statement["says"])}
