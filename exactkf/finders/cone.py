# SPDX-License-Identifier: MIT
"""Semidefinite terms for the proof of one leaf of an ``order``, by linear programs over the rationals.

Terms that are semidefinite by their form are made of the hypotheses H: congruences K H K' with K of letters, inverses, products
and differences that occur (`exactkf.finders.multipliers`). An order A >= B is then a nonnegative combination of them that is
A - B in words, up to the relations; a matrix x is a common null vector of all terms of a combination with x'(sum)x = 0, which
shows equations and invertibility. Normal forms make both a linear program. What is found is only proposed; the checker reads
the terms and decides.

Main definitions
----------------
`part_by_cone`
    One leaf.
`helpful_lemmas`
    Lemmas that may be shown before it.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import lcm
from typing import Any

from exactkf.finders.completion import System, system_of
from exactkf.finders.effort import clock
from exactkf.finders.membership import part_of_order
from exactkf.finders.multipliers import Scene
from exactkf.finders.simplex import combination, vanishing
from exactkf.kernel.definite import are_transposed, definiteness
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.order import goal_of, leaves
from exactkf.kernel.reader import relations
from exactkf.kernel.words import Blocks, size_tree

__all__ = ["helpful_lemmas", "part_by_cone"]

_LEVELS = (0, 1, 2, 3)
_MOST_TERMS = 500  # columns of a linear program
_MOST_VECTORS = 8  # null vectors tried


def part_by_cone(case: dict, formula: Any, degree: int, seconds: float) -> dict | None:
    """The part of an ``order`` for one leaf, or None.

    Parameters
    ----------
    case, formula
        From `exactkf.kernel.order.leaves`.
    degree : int
        Longest word of two completed relations that overlap.
    seconds : float
    """
    deadline = clock() + seconds
    op = formula[0]
    try:
        if op in ("psd", "pd", "loewner"):
            return _order(case, formula, degree, deadline)
        if op == "invertible" or _is_rank(formula):
            ((inner, zero),) = leaves({**case, "says": formula}, (), [[0, "right", []]])
            return _null(case, formula, inner, zero, {"vector": True}, degree, deadline)
        if op == "=" and len(formula) == 3:
            return _null(case, formula, case, formula, {}, degree, deadline)
    except (Unknown, Undefined, ValueError):
        return None
    return None


def _is_rank(formula: Any) -> bool:
    return formula[0] == "=" and isinstance(formula[1], list) and formula[1][0] == "rank"


# ---------------------------------------------------------------------- order
def _order(case: dict, formula: Any, degree: int, deadline: float) -> dict | None:
    scene = Scene(case, formula)
    goal, wanted = goal_of(scene.reader, formula)
    tried = 0
    for level in _LEVELS:
        atoms = scene.terms(goal.rows, level)[:_MOST_TERMS]
        if len(atoms) == tried:
            continue
        tried = len(atoms)
        forms = _Forms(scene, degree, clock() + (deadline - clock()) / 4)
        target, *columns = forms.of([goal, *(scene.value(t) for t in atoms)])
        definite = [k for k, t in enumerate(atoms) if definiteness(scene.reader, t) == 2] if wanted == 2 else []
        if wanted == 2 and not definite:
            continue
        found = combination(columns, target, definite, clock() + (deadline - clock()) / 2)
        if found is not None:
            terms = [_times(c, atoms[k]) for k, c in found.items()]
            if (part := part_of_order(case, formula, terms, {}, degree, deadline - clock())) is not None:
                return part
        if clock() > deadline:
            return None
    return None


def _times(c: Any, term: Any) -> Any:
    factors = term[1:] if term[0] == "*" else [term]
    return term if c == 1 else ["*", int(c.p) if c.q == 1 else ["rat", int(c.p), int(c.q)], *factors]


# ---------------------------------------------------------------------- null vectors
def _null(case: dict, formula: Any, inner: dict, zero: Any, more: dict, degree: int, deadline: float) -> dict | None:
    """Terms that all vanish at one x, from combinations with x'(sum)x = 0; then the equation."""
    scene = Scene(inner, zero)
    for sure, (x, term) in enumerate(scene.vectors()[:_MOST_VECTORS]):
        for level in _LEVELS[:3]:
            terms = []
            atoms = scene.terms(term.rows, level)[:_MOST_TERMS]
            share = clock() + (deadline - clock()) / (4 if sure < 2 else 8)
            forms = _Forms(scene, degree, clock() + (share - clock()) / 2)
            turned = scene.reader.transpose(term)
            columns = forms.of([_sandwich(scene, turned, scene.value(t), term) for t in atoms])
            for found in vanishing(columns, share):
                common = lcm(*(int(c.q) for c in found.values()))
                terms += [t for k, c in found.items() if (t := _times(c * common, atoms[k])) not in terms]
                sums = [_times(c * common, atoms[k]) for k, c in found.items()]
                for some in [sums, terms] if terms != sums else [sums]:
                    if (part := part_of_order(case, formula, some, {**more, "null": x}, degree, max(0.1, (share - clock()) / 2))) is not None:
                        return part
            if clock() > deadline:
                return None
    return None


def _sandwich(scene: Scene, left: Any, middle: Any, right: Any) -> Any:
    times = scene.reader._times
    return times(times(left, middle), right)


# ---------------------------------------------------------------------- normal forms
class _Forms:
    """Normal forms of matrices under the relations of a scene."""

    def __init__(self, scene: Scene, degree: int, deadline: float) -> None:
        self.scene, self.deadline = scene, deadline
        self.system: System = system_of(scene.reader, relations(scene.reader), degree)

    def of(self, values: list) -> list[dict]:
        """Sparse vectors that are equal for equal matrices, as far as the completion got."""
        for _ in range(2):  # reducing may bring in scalars, and with them rules
            made = [self._form(v) for v in values]
        return made

    def _form(self, value: Any) -> dict:
        cells = [p for p, _, _ in value.cells()] if isinstance(value, Blocks) else [value]
        return {(n, key): c for n, p in enumerate(cells) for key, c in self.system.normal_form(p, self.deadline).items()}


# ---------------------------------------------------------------------- lemmas on the way
def helpful_lemmas(case: dict, formula: Any) -> Iterator[list]:
    """Lists of lemmas that may be shown first: what makes a congruence strict; the order of inverses; null vectors of definite matrices."""
    try:
        scene = Scene(case, formula)
        if formula[0] == "pd":
            yield from ([lemma] for lemma in _nonsingular(scene, formula))
        if formula[0] in ("psd", "pd", "loewner"):
            if inverted := list(_of_inverses(scene)):
                yield inverted
            yield from ([lemma] for lemma in _within_congruences(scene, formula))
            yield from ([["psd", t]] for t in scene.subterms() if t[0] == "*" and ["inv"] in [x[:1] for x in t[1:] if isinstance(x, list)]
                        and (value := scene.value(t)) is not None and value.rows == value.cols)
        elif formula[0] == "invertible":
            definite = ["pd", formula[1]]
            yield [definite]
            yield from ([lemma, definite] for lemma in _nonsingular(Scene(case, definite), definite))
        elif formula[0] == "=" and not _is_rank(formula):
            for x, value in scene.vectors()[:_MOST_VECTORS]:
                sizes = size_tree(scene.reader.total(value.cols))
                for h in scene.definite(value.rows):
                    yield [["=", ["*", h, x], ["O", size_tree(scene.reader.total(value.rows)), sizes]]]
    except (Unknown, Undefined):
        return


def _within_congruences(scene: Scene, formula: Any) -> Iterator[Any]:
    """X >= Y for summands FXF' of the greater side and FYF' of the smaller one."""
    big, small = formula[1:] if formula[0] == "loewner" else formula[1][1:] if formula[1][:1] == ["-"] else (0, 0)
    for x, y in product(*(_summands(scene, side) for side in (big, small))):
        taken = 0
        while min(len(x), len(y)) > 2 and x[0] == y[0] and x[-1] == y[-1] and are_transposed(scene.reader, x[0], x[-1]):
            x, y, taken = x[1:-1], y[1:-1], taken + 1
        if taken:
            yield ["loewner", *(t[0] if len(t) == 1 else ["*", *t] for t in (x, y))]


def _summands(scene: Scene, side: Any) -> list[list]:
    """The products of a sum, each by its factors."""
    whole = scene.open(side)
    parts = whole[1:] if isinstance(whole, list) and whole[0] == "+" else [whole]
    return [list(x[1:]) for x in map(scene.open, parts) if isinstance(x, list) and x[0] == "*"]


def _nonsingular(scene: Scene, formula: Any) -> Iterator[Any]:
    """Triangular factors of a goal in blocks, and rows of blocks of full rank, which keep definite matrices definite."""
    goal, _ = goal_of(scene.reader, formula)
    yield from (["invertible", factor] for factor in scene.triangular())
    for k in scene.rows_of_blocks():
        if (value := scene.value(k)) is not None and value.rows == goal.rows:
            yield ["=", ["rank", k], size_tree(scene.reader.total(value.rows))]


def _of_inverses(scene: Scene) -> Iterator[Any]:
    """inv(B) >= inv(A) where A >= B."""
    for h in scene.orders():
        big, small = h[1:]
        if definiteness(scene.reader, big) == definiteness(scene.reader, small) == 2:
            difference = [x[1] if x[0] == "inv" else ["inv", x] for x in (small, big)]
            yield ["pd", ["-", *difference]] if definiteness(scene.reader, h) == 2 else ["loewner", *difference]
