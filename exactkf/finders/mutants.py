# SPDX-License-Identifier: MIT
"""Judging mutants: refuted on an instance, shown equal to the original, a stronger statement that may be true, or a survivor.

A mutant whose conclusion has no value on any instance, or whose matrices do
not fit each other or have no such entry on some, is no statement at all and is not counted. Where
one of two factors is a scalar they commute, so exchanging them is no mutation
there either.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain
from typing import Any

from exactkf.evidence import Evidence
from exactkf.finders.draw import Sampler, examples_of
from exactkf.finders.equal import Original, subtree
from exactkf.finders.prove import PROOFS, candidates, every_size, replays
from exactkf.finders.remembering import Remembering, nodes_of
from exactkf.kernel.linear import Matrix
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.language.latex import latex
from exactkf.language.mutate import Mutant, mutants, rewritings
from exactkf.language.statement import as_tuples
from exactkf.language.text import text

__all__ = ["MutantReport", "judge_mutants"]

_MATRIX_CHANGES = ("factors exchanged", "transpose added", "transpose removed", "inverse added")
_BINDERS = ("forall", "exists", "sum", "prod", "always")
_TRIES = 200


@dataclass
class MutantReport:
    """Totals and one row for each mutant that is a statement: ``kind``, ``says``, ``outcome``, and the ``instance`` on which it is false."""

    rows: list[dict[str, Any]] = field(default_factory=list)
    void: int = 0
    neighbours_made: int = 0
    neighbours_accepted: int = 0
    checks: int = 0

    @property
    def made(self) -> int:
        return len(self.rows)

    @property
    def rejected(self) -> int:
        return sum(r["outcome"] == "rejected" for r in self.rows)

    @property
    def equal(self) -> int:
        return sum(r["outcome"] == "equal" for r in self.rows)

    @property
    def stronger(self) -> int:
        return sum(r["outcome"] == "stronger" for r in self.rows)

    @property
    def survivors(self) -> list[str]:
        return [f"{r['kind']}: {text(as_tuples(r['says']))}" for r in self.rows if r["outcome"] == "survived"]

    def printed(self, tex: Mapping[str, str] | None = None) -> list[dict[str, Any]]:
        """The rows as plain text and LaTeX, with ``tex`` names as given."""
        return [{"kind": r["kind"], "text": text(says), "latex": latex(says, tex), "outcome": r["outcome"], "instance": r["instance"]}
                for r in self.rows for says in [as_tuples(r["says"])]]


def judge_mutants(data: dict, by: Sequence[Evidence], drawn: list[tuple[dict, World]], sampler: Sampler | None) -> MutantReport:
    """Make the mutants of a statement and judge each, all of them, on the statement's own instances."""
    report = MutantReport()
    if not drawn:
        return report
    bench = _Bench(data, by, drawn, report)
    for mutant in mutants(data):
        outcome, instance = _drop(data, mutant, sampler, by, report) if mutant.drops else bench.judge(mutant)
        if outcome == "void":
            report.void += 1
        else:
            report.rows.append({"kind": mutant.kind, "says": mutant.says, "outcome": outcome, "instance": instance})
    for _kind, new in rewritings(data):
        report.neighbours_made += 1
        report.neighbours_accepted += _accepted(data, new, [world for _, world in drawn[:6]], report)
    return report


class _Bench:
    """The instances of a statement, on which its mutants are judged one after the other."""

    def __init__(self, data: dict, by: Sequence[Evidence], drawn: list[tuple[dict, World]], report: MutantReport) -> None:
        self.data, self.by, self.report = data, by, report
        nodes = nodes_of(data["says"])
        self.order = [(instance, Remembering(world, nodes)) for instance, world in sorted(drawn, key=_weight)]
        self.original = Original(data, by)

    def judge(self, mutant: Mutant) -> tuple[str, dict | None]:
        """What became of a mutant, and the instance on which it is false."""
        meaningful, fits = False, True
        for k, (instance, world) in enumerate(self.order):
            self.report.checks += 1
            try:
                if world.value(mutant.says) is False:
                    self.order.insert(0, self.order.pop(k))  # what tells one mutant from the original tells others
                    return "rejected", instance
                meaningful = meaningful or mutant.kind not in _MATRIX_CHANGES or not _only_scalars(self.data, mutant, world)
            except Undefined as error:
                fits = fits and not _misfit(str(error))
            except Unknown:
                continue
        if not meaningful or not fits:
            return "void", None
        if mutant.stronger:
            return "stronger", None
        changed = {**self.data, "says": mutant.says}
        return "equal" if self.original.says_as_much(mutant.says, mutant.path) or _proved(changed, self.by) else "survived", None


def _weight(one: tuple[dict, World]) -> int:
    """Sum of the sizes: small instances cost little, and what they do not tell apart the others do."""
    return sum(v for v in one[1].values.values() if isinstance(v, int))


def _misfit(reason: str) -> bool:
    """The shapes of matrices do not fit each other, or an entry is named that there is not."""
    return reason.startswith(("sizes ", "blocks ", "no entry ")) or reason.endswith(
        ("is not square", "is outside the sequence", "lies before the start of the recursion"))


def _only_scalars(data: dict, mutant: Mutant, world: World) -> bool:
    """Order and transposes mean nothing on this instance: operands (one of the exchanged factors) are scalars or polynomials."""
    tree, local = data["says"], dict[str, int]()
    try:
        for k in mutant.path:
            if isinstance(tree, list) and tree and tree[0] in _BINDERS:
                local[tree[1]] = 1 if tree[0] == "always" else world.integer(tree[2], local)
            elif isinstance(tree, list) and tree and tree[0] in ("col", "mat"):
                local.update(dict.fromkeys(tree[1:2] if tree[0] == "col" else tree[1:3], 1))
            tree = tree[k]
        values = [world.value(x, local) for x in tree[1:]]
    except Undefined:
        return True  # a case that this instance does not reach
    except (Unknown, KeyError):
        return False
    scalars = [not isinstance(v, Matrix) or v.is_scalar for v in values]
    if mutant.kind == "factors exchanged":
        changed = subtree(mutant.says, mutant.path)[1:]
        return any(one for one, x, y in zip(scalars, tree[1:], changed, strict=True) if x != y)
    return all(scalars)


def _proved(changed: dict, by: Sequence[Evidence]) -> bool:
    """A proof of the same kind proves the changed statement: both are theorems. Of an order there may be several, for what follows from the original."""
    orders = [e for e in by if e.kind == "order"]
    ways = [[e for e in by if e.kind != "order" or e is one] for one in orders or by[:1]]
    tries = chain((c for e in by if e.kind in PROOFS for c in candidates("mutant", changed, e)),
                  *(every_size("mutant", changed, way, 1.0) for way in ways))
    return any(map(replays, tries))


def _drop(data: dict, mutant: Mutant, sampler: Sampler | None, by: Sequence[Evidence], report: MutantReport) -> tuple[str, dict | None]:
    """Without the hypothesis there must be an instance on which the conclusion is false; examples by hand come first."""
    kept = [g if g[0] != mutant.drops else [g[0], mutant.weaker, g[2]] for g in data["given"] if g[0] != mutant.drops or mutant.weaker]
    weaker = {**data, "given": kept}
    asked = [e.hints for e in by if e.kind == "instances"] or [{"sizes": sampler.sizes if sampler else {}}]
    for hints in asked:
        for tries, made_by in _partial(hints.get("made_by", {}), data):
            fresh = Sampler(weaker, {**hints, "made_by": made_by, "using": hints.get("using", {}) if made_by else {}}, examples_of(tuple(by)), 1)
            for instance, world in fresh.stream(tries):
                report.checks += 1
                try:
                    if world.value(data["says"]) is False:
                        return "rejected", instance
                except (Undefined, Unknown):
                    continue
    if mutant.stronger:
        return "stronger", None
    return "equal" if _proved(weaker, by) else "survived", None


def _partial(made_by: Mapping[str, Any], data: dict) -> Iterator[tuple[int, dict]]:
    """Ways to leave variables to chance, with the number of tries: all of them, none, each alone."""
    yield _TRIES, {}
    if made_by:
        yield _TRIES, dict(made_by)
    for name, _ in data["over"]:
        if name in made_by and len(made_by) > 1:
            yield _TRIES // 5, {k: v for k, v in made_by.items() if k != name}


def _accepted(data: dict, new: dict, worlds: list[World], report: MutantReport) -> bool:
    """A rewriting is true on the same instances."""
    names = dict(zip([n for n, _ in data["over"]], [n for n, _ in new["over"]], strict=True))
    for world in worlds:
        values = {names.get(k, k): v for k, v in world.values.items()}
        report.checks += 1
        try:
            if World(new, {**values, "horizon": world.horizon}).value(new["says"]) is not True:
                return False
        except (Undefined, Unknown):
            return False
    return True
