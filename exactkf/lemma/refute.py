# SPDX-License-Identifier: MIT
"""Instances of a lemma: a refutation, witnesses, or which assumption cannot be met.

The instances come from `exactkf.finders.draw.Sampler`, which draws values of
the types at random, degenerate ones among them, and solves the equations of
the assumptions (`exactkf.finders.solve`); the smallest sizes come first. The
claim is evaluated exactly. What refutes it becomes a certificate of kind
``counterexample``.

Main definitions
----------------
`look_for`
    Instances of a statement, up to the first on which it is false.
`unmet`
    The assumption that cannot be met together with those before it.
`contradiction`
    A certificate that the assumptions leave room for empty matrices alone.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from exactkf.finders.draw import Sampler
from exactkf.finders.membership import find_membership
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.replay import NotACertificate, Rejected, replay, seal

__all__ = ["Search", "contradiction", "look_for", "unmet"]

_TRIES = 400
_ENOUGH = 120  # instances on which the claim is true, after which the search ends
_MOST_TAKEN = 4  # largest number looked for in differences of sizes
_TRUE = ["=", 0, 0]


@dataclass
class Search:
    """What a search for a counterexample found."""

    sampler: Sampler
    counterexample: dict | None = None
    certificate: dict | None = None
    kept: list[dict] = field(default_factory=list)
    worlds: list[World] = field(default_factory=list)
    undefined: int = 0  # instances on which the claim has no value
    why_undefined: str = ""
    unknown: str = ""
    checks: int = 0


def _sizes_tried(data: Mapping[str, Any]) -> dict[str, list[int]]:
    """Small sizes; fewer of each where there are many, more where some are taken off."""
    most = (3 if len(data["sizes"]) < 3 else 2) + min(_MOST_TAKEN, _taken_off(data["over"]))
    return {name: list(range(1, most + 1)) for name in data["sizes"]}


def _taken_off(tree: Any) -> int:
    """The largest number that is taken off a size, as in a matrix of n - 2 rows."""
    if not isinstance(tree, (list, tuple)):
        return 0
    own = max((x for x in tree[2:] if isinstance(x, int)), default=0) if tree and tree[0] == "-" else 0
    return max(own, *map(_taken_off, tree), 0)


def look_for(data: dict, deadline: float, *, seed: int = 0, tries: int = _TRIES, id: str = "lemma") -> Search:
    """Evaluate a statement on instances until one refutes it, or there are enough, or time is up.

    Parameters
    ----------
    data : dict
        JSON of the statement.
    deadline : float
        Time of `time.perf_counter` at which to end.
    seed, tries : int
        Same seed, same instances; at most so many tries.
    """
    sampler = Sampler(data, {"sizes": _sizes_tried(data), "horizon": 3, "solving": tries}, [], seed)
    search = Search(sampler)
    seen: set[str] = set()
    try:
        for instance, world in sampler.stream(tries):
            if time.perf_counter() > deadline:
                break
            if (key := repr([instance["sizes"], instance["values"]])) in seen:
                continue
            seen.add(key)
            search.checks += 1
            try:
                holds = world.value(data["says"])
            except Undefined as error:
                search.undefined += 1
                search.why_undefined = search.why_undefined or str(error)
                continue
            if holds is False and _refutes(search, id, data, instance):
                break
            search.kept.append(instance)
            search.worlds.append(world)
            if len(search.kept) >= _ENOUGH:
                break
    except Unknown as error:
        search.unknown = str(error)
    return search


def _refutes(search: Search, id: str, data: dict, instance: dict) -> bool:
    certificate = seal(id, "counterexample", data, {"instance": instance})
    try:
        replay(certificate)
    except (Rejected, NotACertificate) as error:
        search.unknown = str(error)
        return False
    search.counterexample, search.certificate = instance, certificate
    return True


def unmet(data: dict, deadline: float, seed: int = 0) -> str:
    """Label of the first assumption that no instance meets together with those before it; empty if none is found."""
    for k in range(1, len(data["given"]) + 1):
        first = {**data, "given": data["given"][:k], "says": _TRUE}
        if not look_for(first, deadline, seed=seed, tries=_TRIES if k == len(data["given"]) else 2 * _TRIES).kept:
            return data["given"][k - 1][0]
    return ""


def contradiction(data: dict, label: str, degree: int, seconds: float) -> tuple[str, dict] | None:
    """A size that the assumptions up to a label force to be zero, with the certificate of I = 0."""
    labels = [g[0] for g in data["given"]]
    given = data["given"][:labels.index(label) + 1]
    for size, goal in _empty_goals(data, given):
        statement = {**data, "given": given, "says": goal}
        terms = find_membership(statement, degree=degree, seconds=seconds)
        if terms is None:
            continue
        certificate = seal("lemma: contradiction", "membership", statement, {"terms": terms})
        try:
            replay(certificate)
        except (Rejected, NotACertificate):
            continue
        return size, certificate
    return None


def _empty_goals(data: dict, given: list) -> list[tuple[str, Any]]:
    """I = 0 for each size, written with an inverse where an assumption or a type grants one."""
    goals: list[tuple[str, Any]] = []
    square = {kind[1][1]: name for name, kind in data["over"] if kind[0] in ("nonsingular", "pd") and kind[1][:1] == ["sym"]}
    for n in data["sizes"]:
        size = ["sym", n]
        inverses = [["sym", square[n]]] if n in square else []
        inverses += [f[1] for _, f, _ in given if f[0] in ("invertible", "pd")]
        goals += [(n, ["=", ["*", x, ["inv", x]], ["O", size, size]]) for x in inverses]
        goals.append((n, ["=", ["I", size], ["O", size, size]]))
    return goals
