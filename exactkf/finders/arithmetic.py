# SPDX-License-Identifier: MIT
"""Search for refutations in `exactkf.kernel.arithmetic`.

Between the steps that hints name, what needs no choice is done by itself: equations are solved for a variable, what
exists gets a name, disjunctions lose the parts that contradict the rest. A leaf is closed by linear programming over products of facts.

Main definitions
----------------
`find_arithmetic`
    A proof as the checker reads it, or None.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations_with_replacement
from typing import Any

from exactkf.finders.effort import clock
from exactkf.finders.simplex import combination
from exactkf.kernel.arithmetic import ONE, Facts, Poly, times
from exactkf.kernel.numbers import Rejected, Unknown

__all__ = ["StuckAt", "find_arithmetic"]

_MOST_PRODUCTS = 600
_MOST_CASES = 400
Proof = dict[str, Any]
Hint = list[Any]


class StuckAt(Exception):
    """No way to go on: the facts of the case are the argument, in words."""


def find_arithmetic(statement: Mapping[str, Any], hints: Sequence[Hint], seconds: float) -> Proof | None:
    """A refutation of the denied statement, by the hints in their order.

    A hint is a list: ``["divide", term, m, name, hints for each rest]``, ``["at", index, term]``, ``["cut", formula]`` or
    ``["induct", name, from, formula]``.
    """
    try:
        return _Search(clock() + seconds).start(statement, hints)
    except (StuckAt, Rejected, Unknown):
        return None


class _Search:
    """One search, with what it may still take."""

    def __init__(self, deadline: float) -> None:
        self.deadline, self.cases = deadline, 0

    def start(self, statement: Mapping[str, Any], hints: Sequence[Hint]) -> Proof:
        denied = Facts(statement)
        denied.add(denied.read(statement["says"], False))
        return self.prove(denied, list(hints))

    def prove(self, facts: Facts, hints: list[Hint]) -> Proof:
        self.cases += 1
        if clock() > self.deadline or self.cases > _MOST_CASES:
            raise StuckAt("out of time")
        if (found := closed(facts, 1, self.deadline)) is not None:
            return found
        if (step := _forced(facts)) is not None:
            return self.after(facts, step, [hints])
        if (step := self.propagated(facts)) is not None:
            return self.after(facts, step, [hints] * len(facts.step(step)))
        if (made := _hinted(facts, hints)) is not None:
            step, rests = made
            return self.after(facts, step, rests)
        if (found := closed(facts, 2, self.deadline)) is not None:
            return found
        parts = [(len(f[1]), n) for n, f in enumerate(facts.facts) if f is not None and f[0] == "or"]
        if parts:
            return self.after(facts, {"step": "split", "fact": min(parts)[1]}, [hints] * min(parts)[0])
        raise StuckAt("; ".join(f"{n}: {_shown(f)}" for n, f in enumerate(facts.facts) if f is not None))

    def after(self, facts: Facts, step: Proof, rests: list[list[Hint]]) -> Proof:
        return {**step, "then": [self.prove(case, rest) for case, rest in zip(facts.step(step), rests, strict=True)]}

    def propagated(self, facts: Facts) -> Proof | None:
        """A disjunction with one part at most that does not contradict the rest at once."""
        for n, fact in enumerate(facts.facts):
            if fact is not None and fact[0] == "or":
                rest = facts.without(n)
                left = [part for part in fact[1] if closed(rest.and_(part), 1, self.deadline) is None]
                if len(left) <= 1:
                    return {"step": "split", "fact": n}
        return None


def _forced(facts: Facts) -> Proof | None:
    """An equation that can be solved, or something that exists."""
    for n, fact in enumerate(facts.facts):
        if fact is not None and fact[0] == "=":
            for m, v in fact[1].items():
                if len(m) == 1 and abs(v) == 1 and isinstance(m[0], str) and sum(m[0] in other for other in fact[1]) == 1:
                    return {"step": "solve", "fact": n, "variable": m[0]}
        if fact is not None and fact[0] == "some":
            return {"step": "name", "fact": n, "name": _free(facts, fact[1])}
    return None


def _free(facts: Facts, name: str) -> str:
    taken = {*facts.names, *facts.definitions, *(n for n, _ in facts.statement["over"])}
    return next(n for n in (name, *(f"{name}{k}" for k in range(1, 1000))) if n not in taken)


def _hinted(facts: Facts, hints: list[Hint]) -> tuple[Proof, list[list[Hint]]] | None:
    """The step of the first hint that can be taken, and the hints for the cases after it."""
    for place, (kind, *args) in enumerate(hints):
        rest = [*hints[:place], *hints[place + 1:]]
        try:
            if kind == "at":
                if (steps := [{"step": "at", "fact": n, "term": args[1]} for n, f in enumerate(facts.facts) if f is not None and f[:2] == ("all", args[0])]):
                    return _taken(facts, steps, rest)
                continue
            step, own = _step(facts, kind, args)
            cases = len(facts.step(step))
        except (Rejected, Unknown):
            continue
        return step, [[*(own[k] if own else []), *rest] for k in range(cases)]
    return None


def _taken(facts: Facts, steps: list[Proof], rest: list[Hint]) -> tuple[Proof, list[list[Hint]]]:
    """The first of several places of one term; the others stay as hints."""
    facts.step(steps[0])
    return steps[0], [[*(["place", s] for s in steps[1:]), *rest]]


def _step(facts: Facts, kind: str, args: Sequence[Any]) -> tuple[Proof, list[list[Hint]] | None]:
    if kind == "place":
        return args[0], None
    if kind == "divide":
        return {"step": "divide", "term": args[0], "by": args[1], "name": args[2]}, args[3] if len(args) > 3 else None
    if kind == "cut":
        return {"step": "cut", "formula": args[0]}, args[1] if len(args) > 1 else None
    return {"step": "induct", "name": args[0], "from": args[1], "formula": args[2]}, args[3] if len(args) > 3 else None


# ---------------------------------------------------------------------- leaves
def closed(facts: Facts, degree: int, deadline: float) -> Proof | None:
    """A combination that contradicts itself: of facts, or of their products two at a time and of equations times variables."""
    columns: list[Poly] = [ONE]
    terms: list[list[Any]] = [[[]]]
    for numbers, p in _products(facts, degree):
        columns.append(p)
        terms.append([list(numbers)])
    multipliers = _multipliers(facts) if degree > 1 else [(1, ONE)]
    for n, fact in enumerate(facts.facts):
        if fact is not None and fact[0] == "=":
            for tree, q in multipliers:
                for c in (1, -1):
                    columns.append({m: c * v for m, v in times(fact[1], q).items()})
                    terms.append([[n], ["neg", tree] if c < 0 else tree])
    found = combination(columns, {(): -1}, deadline=deadline)
    if found is None:
        return None
    return {"step": "close", "terms": [[str(c), *terms[k]] for k, c in found.items()]}


def _products(facts: Facts, degree: int) -> Iterator[tuple[tuple[int, ...], Poly]]:
    known = [(n, f[1]) for n, f in enumerate(facts.facts) if f is not None and f[0] in (">=", ">")]
    yield from (((n,), p) for n, p in known)
    if degree > 1:
        for (n, p), (m, q), _ in zip(*zip(*combinations_with_replacement(known, 2), strict=True), range(_MOST_PRODUCTS), strict=False) if known else ():
            yield (n, m), times(p, q)


def _multipliers(facts: Facts) -> list[tuple[Any, Poly]]:
    """Terms by which an equation is multiplied: variables of the facts, that is names whose value they are, and one."""
    used = {a for f in facts.facts if f is not None and f[0] in ("=", ">=", ">") for m in f[1] for a in m}
    return [(1, ONE), *((["sym", n], p) for n, p in facts.names.items() if len(p) == 1 and p.get((n,)) == 1 and n in used)]


def _shown(fact: Any) -> str:
    if fact[0] in ("and", "or"):
        return f"{fact[0]}({', '.join(map(_shown, fact[1]))})"
    if fact[0] in ("all", "some"):
        return f"{fact[0]} {fact[1]} in {_text(fact[2])} .. {_text(fact[3])}: {fact[4]}"
    return f"{_text(fact[1])} {fact[0]} 0"


def _text(p: Poly | None) -> str:
    return "..." if p is None else " + ".join("*".join([str(v), *map(str, m)]) for m, v in p.items()) or "0"
