# SPDX-License-Identifier: MIT
"""Proofs for every matrix size: equations, order, and induction.

Each search proposes the evidence of a certificate that `exactkf.kernel.every_size`
replays, and proves nothing by itself.

Main definitions
----------------
`search_membership`, `find_membership`
    Equations as multiples of the assumptions; the first says how far it got.
`find_order`
    Order, invertibility and equations, leaf by leaf.
`part_of_order`, `own_part_of_order`
    One leaf of an order.
`find_induction`
    Base and step.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from exactkf.finders.completion import Stuck, system_of
from exactkf.finders.effort import clock
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.order import Leaf, leaves
from exactkf.kernel.reader import Reader, relations, residual_blocks
from exactkf.kernel.recursion import Induction, along, before, inductions
from exactkf.kernel.words import Blocks, size_tree

__all__ = ["Membership", "find_induction", "find_membership", "find_order", "own_part_of_order", "part_of_order", "search_membership"]


_DEGREE_WITH_LEMMAS = 12
_LONG_LETTER = 40


@dataclass(frozen=True)
class Membership:
    """Evidence of a ``membership``: for each block of the conclusion its terms [c, left, relation, right, scalars]."""

    terms: list[list]


def search_membership(statement: dict, degree: int = 8, seconds: float = 5.0) -> Membership | Stuck:
    """The conclusion as multiples of the assumptions, or how far the search for them got.

    Parameters
    ----------
    statement : dict
        JSON of the statement.
    degree : int
        Longest word of two completed relations that overlap.
    seconds : float
        Time after which to give up.
    """
    deadline = clock() + seconds
    try:
        reader = Reader(statement)
        goals = [cell for b in residual_blocks(reader, statement["says"]) for cell in b.cells()]
        assumed = relations(reader)
    except (Unknown, Undefined) as error:
        return Stuck(str(error))
    system, out = system_of(reader, assumed, degree), []
    for goal, _, _ in goals:
        found = system.express(goal, deadline)
        if isinstance(found, Stuck):
            return found
        out.append(found)
    return Membership(out)


def find_membership(statement: dict, degree: int = 8, seconds: float = 5.0) -> list[list] | None:
    """Terms for every block of the conclusion, or None."""
    found = search_membership(statement, degree, seconds)
    return found.terms if isinstance(found, Membership) else None


def find_order(statement: dict, sums: Any = (), roots: Any = (), lemmas: Any = (), degree: int = 8, seconds: float = 5.0,
               factors: Any = (), inside: Any = (), stable: Any = ()) -> list[dict] | None:
    """For every leaf of the lemmas and the conclusion the terms of a proof, or None.

    Parameters
    ----------
    sums : sequence of lists of terms
        For each leaf the terms to try, see `exactkf.kernel.order.Leaf`. An empty list, or none, leaves it to the finder.
    roots : sequence of (name, term)
        Names for symmetric square roots that the terms use.
    lemmas : sequence of formulas
        Shown first, used after.
    degree : int
        As in `search_membership`; where lemmas lead the way it is larger.
    factors : sequence of (matrix, its factors)
        For determinants.
    inside : sequence of [number, vector, lemmas]
        See `exactkf.kernel.order.leaves`.
    stable : sequence of [number, {"solutions", "stein", "unique", "kept", "pencil", "inertia"}]
        What the proof of a leaf, counted as the sums are, makes of stable matrices.
    """
    out = []
    degree = max(degree, _DEGREE_WITH_LEMMAS) if lemmas or inside else degree
    helped = {number: help_ for number, help_ in stable}
    for k, (case, formula) in enumerate(leaves(statement, lemmas, inside)):
        asked = [sums[k]] if k < len(sums) and sums[k] else []
        for terms in asked or _own_terms(case, formula):
            more = {"roots": roots, "factors": factors, **helped.get(k, {})}
            found = _complete(case, formula, terms, more, bool(asked), degree, seconds)
            if found is not None:
                break
        else:
            return None
        out.append(found)
    return out


def find_induction(statement: dict, hints: Any = None, seconds: float = 5.0) -> dict | None:
    """Evidence of a ``word induction``, or None.

    Parameters
    ----------
    hints : mapping
        Of `exactkf.evidence.induction`: what is carried along, shapes of the state, terms for base and step.
    """
    hints = hints or {}
    for shapes in [hints["shapes"]] if hints.get("shapes") else _shapes(statement):
        first, rest = [], statement
        for lemma in hints.get("before", ()):
            alone, formula, rest = before(rest, lemma["says"])
            also = list(lemma.get("also", ()))
            first.append({"says": lemma["says"], "also": also, "proofs": _prove_part(alone, [formula, *also], shapes, lemma, 0, seconds)})
            if first[-1]["proofs"] is None:
                break
        else:
            conjuncts = []
            for number, part in enumerate(inductions(rest)):
                conjuncts.append(_prove_part(part, along(hints.get("also", ()), number), shapes, hints, number, seconds))
                if conjuncts[-1] is None:
                    break
            else:
                lemmas = {"before": first} if first else {}
                return {"conjuncts": conjuncts, "also": list(hints.get("also", ())), "shapes": shapes, **lemmas}
    return None


def _prove_part(part: dict, also: Any, shapes: Any, hints: Any, number: int, seconds: float) -> list | None:
    try:
        return _prove_cases(Induction(part, also, shapes), hints, number, seconds)
    except (Unknown, Undefined, KeyError, TypeError, IndexError):
        return None


def _prove_cases(made: Induction, hints: Any, number: int, seconds: float) -> list | None:
    """A proof for each base and for the step of one conjunct."""
    proofs = []
    for case, lemmas in zip([*made.bases, *([made.step] if made.step else [])], made.lemmas, strict=True):
        asked = hints.get("step" if case is made.step else "base") or [{}]
        given = asked[min(number, len(asked) - 1)]
        sums = [[made.at(t, case) for t in terms] for terms in given.get("sums", ())]
        roots = [[name, made.at(t, case)] for name, t in given.get("roots", ())]
        own = [made.at(t, case) for t in given.get("lemmas", ())]
        factors = [[made.at(t, case), [made.at(x, case) for x in parts]] for t, parts in given.get("factors", ())]
        inside = [[k, vector, [made.at(t, case) for t in inner]] for k, vector, inner in given.get("inside", ())]
        stable = [[k, _help_at(made, case, help_)] for k, help_ in given.get("stable", ())]
        found = find_order(case, sums, roots, [*own, *lemmas], seconds=seconds, factors=factors, inside=inside, stable=stable)
        if found is None:
            return None
        proofs.append({"parts": found, "lemmas": own, **({"inside": inside} if inside else {})})
    return proofs


def _help_at(made: Induction, case: dict, help_: dict) -> dict:
    """What the proof of a leaf makes of stable matrices, in the index of one of the bases or of the step."""
    out: dict[str, Any] = {}
    if "stein" in help_:
        out["stein"] = made.at(help_["stein"], case)
    for key in ("unique", "kept", "pencil", "inertia"):
        if key in help_:
            out[key] = [made.at(m, case) for m in help_[key]]
    if "solutions" in help_:
        out["solutions"] = [[name, made.at(m, case), made.at(q, case)] for name, m, q in help_["solutions"]]
    return out


def _shapes(statement: dict) -> Iterator[dict]:
    """Shapes to try for the values of recursions: those of their initial values, then even ones in two halves."""
    yield {}
    halves = {}
    for d in statement["where"]:
        first = d[4][0] if d[0] == "rec" else 0
        size = first[1] if isinstance(first, list) and first[0] == "I" else 0
        if isinstance(size, list) and size[0] == "*" and size[1] == 2 and len(size) == 3:
            halves[d[1]] = [[size[2]] * 2] * 2
    if halves:
        yield halves


def _own_terms(case: dict, formula: Any) -> list[list]:
    """Terms to try: the matrix of the conclusion as it stands, with definitions left in, and those of the hypotheses."""
    op, args = formula[0], formula[1:]
    inverses = [["inv", x] for x in _nonsingular(case)]
    if op in ("=", "symmetric", "symplectic"):
        return [[], inverses] if inverses else [[]]
    if op in ("schur", "observable"):
        return [[]]
    if op in ("similar", "cospectral"):
        return [*([x[1], x] for x in inverses), *([x, x[1]] for x in inverses)]
    if op == "invertible":
        return [[["inv", args[0]]], []]
    given = [[f[1]] for _, f, _kind in case["given"] if f[0] in ("psd", "pd")]
    if op in ("psd", "pd"):
        return [[args[0]], *given]
    if op in ("loewner", "<", "<=", ">", ">=") and len(args) == 2:
        big, small = reversed(args) if op in ("<", "<=") else args
        return [[big]] if small == 0 else [[["-", big, small]], [big, ["neg", small]], [_without(big, small)], *given, []]
    return []


def _without(big: Any, small: Any) -> Any:
    """big - small where small is a summand of big."""
    if isinstance(big, list) and big[0] == "+" and small in big[1:]:
        rest = [x for x in big[1:]]
        rest.remove(small)
        return rest[0] if len(rest) == 1 else ["+", *rest]
    return ["-", big, small]


def _nonsingular(case: dict) -> list:
    """Variables and terms that type or hypothesis make nonsingular."""
    typed = [["sym", name] for name, kind in case["over"] if kind[0] in ("nonsingular", "pd")]
    return typed + [f[1] for _, f, _kind in case["given"] if f[0] in ("invertible", "pd") and f[1] not in typed]


def _complete(case: dict, formula: Any, terms: list, more: dict, asked: bool, degree: int, seconds: float) -> dict | None:
    """The terms, with the multiples of assumptions that make up for the rest."""
    more = {key: value if key == "stein" else [list(x) if isinstance(x, (list, tuple)) else x for x in value] for key, value in more.items() if value}
    for way in _ways(case, formula, terms if asked else []):
        if (found := part_of_order(case, formula, terms, {**more, **way}, degree, seconds)) is not None:
            return found
    return None


def part_of_order(case: dict, formula: Any, terms: list, more: dict, degree: int, seconds: float) -> dict | None:
    """The part of an ``order`` for one leaf, from its terms and what else its proof brings in, or None."""
    try:
        leaf = Leaf(case, formula, terms, **more)
        blocks = [_terms_for(leaf, k, degree, seconds) for k in range(len(leaf.goals))]
    except (Unknown, Undefined, TypeError, AttributeError):  # such as a definition that is no matrix where one is needed
        return None
    return None if None in blocks else {"sum": terms, **_spelled(blocks), **more}


def own_part_of_order(case: dict, formula: Any, degree: int, seconds: float) -> dict | None:
    """The same from the terms that the leaf itself suggests."""
    tries = (_complete(case, formula, terms, {}, False, degree, seconds) for terms in _own_terms(case, formula))
    return next((found for found in tries if found is not None), None)


def _spelled(blocks: list) -> dict:
    """The terms of each block; long letters, such as inverses of sums, are listed once, and stand in words by their numbers."""
    letters: dict[str, int] = {}

    def short(word: list) -> list:
        return [letters.setdefault(a, len(letters)) if len(a) > _LONG_LETTER else a for a in word]

    made = [[[c, short(left), name, short(right), *more] for c, left, name, right, *more in terms] for terms in blocks]
    return {"blocks": made, **({"letters": list(letters)} if letters else {})}


def _ways(case: dict, formula: Any, terms: list) -> Iterator[dict]:
    """Where null vectors of semidefinite terms may come from; and invertibility, or rank, by null vectors."""
    op = formula[0]
    rank = op == "=" and isinstance(formula[1], list) and formula[1][0] == "rank"
    labels = [label for label, f, _ in reversed(case["given"]) if f[0] == "="]
    if terms and all(isinstance(t, list) and t[0] in ("inv", "/") for t in terms):  # an inverse to be brought in, most likely
        yield {}
    if op in ("=", "symmetric", "symplectic") and not rank:
        if terms:
            units = [{"null": ["I", size]} for size in _size_of(case, terms[0])]
            yield from (way for way in units if way["null"][1] == 1)
            yield from ({"null": label} for label in labels)
            yield from ({"null": ["sym", name]} for name, kind in case["over"] if kind[0] == "matrix")
            yield from (way for way in units if way["null"][1] != 1)
            yield from ({"null": ["sym", d[1]]} for d in case["where"] if d[0] == "let" and not d[2])
        yield {}
        return
    if not rank or len(terms) == 4:
        yield {}
    if rank or op == "invertible":
        yield {"vector": True}
        if terms:
            yield {"vector": True, "null": "null vector"}
            yield from ({"vector": True, "null": ["sym", f"v.{k}"]} for k in range(3))


def _size_of(case: dict, term: Any) -> Iterator[Any]:
    """Number of rows of a term, if that can be said."""
    with suppress(Unknown, Undefined):
        reader = Reader(case)
        found = reader.read(term)
        if isinstance(found, Blocks):
            yield size_tree(reader.total(found.rows))


#: lemmas of the leaf, and what its proof brings in: these are tried before all assumptions are
_NEAREST = ("inner lemma", "solution", "eigenv", "null ", "root", "inverse", "quotient")

def _terms_for(leaf: Leaf, k: int, degree: int, seconds: float) -> list | None:
    goal, assumed = leaf.goals[k][0], leaf.assumed(k)
    tries = [assumed]
    if any(name.startswith(("inner lemma", "solution")) for name in assumed):
        tries.insert(0, {name: relation for name, relation in assumed.items() if name.startswith(_NEAREST)})
    for number, some in enumerate(tries, 1):
        found = system_of(leaf.reader, some, degree).express(goal, clock() + (seconds if number == len(tries) else min(seconds, 2.0)))
        if not isinstance(found, Stuck):
            return found
    return None
