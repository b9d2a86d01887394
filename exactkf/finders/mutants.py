# SPDX-License-Identifier: MIT
"""Judging mutants: refuted on an instance, shown equal to the original, or a survivor.

A mutant whose conclusion has no value on any instance is no statement at all
and is not counted. Two factors that are scalars on every instance commute, so
exchanging them is no mutation either.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from exactkf.evidence import Evidence
from exactkf.finders.draw import Sampler
from exactkf.finders.equal import says_nothing_new
from exactkf.finders.prove import PROOFS, candidates
from exactkf.kernel.linear import Matrix
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.replay import NotACertificate, Rejected, replay
from exactkf.language.mutate import Mutant, mutants, rewritings

__all__ = ["MutantReport", "judge_mutants"]

_MATRIX_CHANGES = ("factors exchanged", "transpose added", "transpose removed")
_BINDERS = ("forall", "exists", "sum", "prod", "always")
_TRIES = 200
_MOST = 48  # mutants looked at per claim, spread evenly over the tree


@dataclass
class MutantReport:
    """Totals and one row for each mutant."""

    rows: list[dict[str, Any]] = field(default_factory=list)
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
    def survivors(self) -> list[str]:
        return [f"{r['kind']}: {r['text']}" for r in self.rows if r["outcome"] == "survived"]


def judge_mutants(data: dict, by: Sequence[Evidence], worlds: list[World], sampler: Sampler | None) -> MutantReport:
    """Make the mutants of a statement and judge each on the statement's own instances."""
    from exactkf.language.latex import latex
    from exactkf.language.statement import as_tuples
    from exactkf.language.text import text

    report = MutantReport()
    if not worlds:
        return report
    every = mutants(data)
    step = max(1, -(-len(every) // _MOST))
    chosen = every[::step] if step > 1 else every
    chosen += [m for m in every if m.drops and m not in chosen]
    order = _informative(worlds)
    for mutant in chosen:
        outcome = _drop(data, mutant, sampler, by, report) if mutant.drops else _judge(data, mutant, order, by, report)
        if outcome != "void":
            says = as_tuples(mutant.says)
            report.rows.append({"kind": mutant.kind, "text": text(says), "latex": latex(says), "outcome": outcome})
    for _kind, new in rewritings(data):
        report.neighbours_made += 1
        report.neighbours_accepted += _accepted(data, new, worlds[:6], report)
    return report


def _informative(worlds: list[World]) -> list[World]:
    """Large instances first: they tell more neighbours apart."""
    def weight(world: World) -> int:
        return -sum(v for v in world.values.values() if isinstance(v, int))
    return sorted(worlds, key=weight)


def _judge(data: dict, mutant: Mutant, worlds: list[World], by: Sequence[Evidence], report: MutantReport) -> str:
    meaningful = False
    for world in worlds:
        report.checks += 1
        try:
            if world.value(mutant.says) is False:
                return "rejected"
            meaningful = True
        except Undefined:
            continue
        except Unknown:
            return "void"
    if not meaningful:
        return "void"
    if mutant.kind in _MATRIX_CHANGES and _only_scalars(data, mutant, worlds[0]):
        return "void"
    return "equal" if says_nothing_new(data, mutant.says, mutant.path, by) or _also_proved(data, mutant, by) else "survived"


def _only_scalars(data: dict, mutant: Mutant, world: World) -> bool:
    """The operands of the changed node are scalars or polynomials on this instance: order and transposes mean nothing."""
    tree, local = data["says"], {}
    try:
        for k in mutant.path:
            if isinstance(tree, list) and tree and tree[0] in _BINDERS:
                local[tree[1]] = 1 if tree[0] == "always" else world.integer(tree[2], local)
            tree = tree[k]
        values = [world.value(x, local) for x in tree[1:]]
    except (Undefined, Unknown, KeyError):
        return False
    return not any(isinstance(v, Matrix) and not v.is_scalar for v in values)


def _also_proved(data: dict, mutant: Mutant, by: Sequence[Evidence]) -> bool:
    """The same proof proves the changed statement: both are theorems."""
    changed = {**data, "says": mutant.says}
    for e in by:
        if e.kind in PROOFS:
            for certificate in candidates("mutant", changed, e):
                try:
                    replay(certificate)
                    return True
                except (Rejected, NotACertificate):
                    continue
    return False


def _drop(data: dict, mutant: Mutant, sampler: Sampler | None, by: Sequence[Evidence], report: MutantReport) -> str:
    """Without the hypothesis there must be an instance on which the conclusion is false."""
    weaker = {**data, "given": [g for g in data["given"] if g[0] != mutant.drops]}
    hints = next((e.hints for e in by if e.kind == "instances"), {"sizes": sampler.sizes if sampler else {}})
    for made_by in ({}, hints.get("made_by", {})):
        fresh = Sampler(weaker, {**hints, "made_by": made_by, "using": hints.get("using", {}) if made_by else {}}, [], 1)
        for _, world in fresh.stream(_TRIES):
            report.checks += 1
            try:
                if world.value(data["says"]) is False:
                    return "rejected"
            except (Undefined, Unknown):
                continue
    return "survived"


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
