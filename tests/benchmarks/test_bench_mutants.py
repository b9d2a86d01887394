# SPDX-License-Identifier: MIT
"""Judging all mutants of a formula, against evaluating each from scratch."""

from __future__ import annotations

from time import process_time

import pytest
from flint import fmpq

from exactkf.claims import load
from exactkf.engine import _find
from exactkf.finders.effort import counted
from exactkf.finders.remembering import Remembering, nodes_of
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown, rationals
from exactkf.language.mutate import mutants

pytestmark = pytest.mark.benchmark

LONG = ("BLM91-E2.2", "BLZ94-E5.20", "B93-E8")


def outcomes(made, worlds):
    """For each mutant, whether it is false on some instance, and the time that takes."""
    found, started = [], process_time()
    for mutant in made:
        found.append(False)
        for k, world in enumerate(worlds):
            try:
                if world.value(mutant.says) is False:
                    found[-1] = True
                    worlds.insert(0, worlds.pop(k))
                    break
            except (Undefined, Unknown):
                continue
    return found, process_time() - started


def test_judging_all_mutants():
    """Values of what a mutant shares with the original are remembered: on long formulas at most a third of the time, and the same outcomes."""
    ours = bare = 0.0
    with rationals(fmpq), counted():
        for id in LONG:
            claim = load()[id]
            data = claim.statement.to_json()
            made = [m for m in mutants(data) if not m.drops]
            drawn = [World(data, {**world.values, "horizon": world.horizon}) for _, world in _find(id, claim.statement, claim.by, 0).drawn]
            for world in drawn:
                world.value(data["says"])  # definitions are remembered either way
            plain, seconds = outcomes(made, list(drawn))
            nodes = nodes_of(data["says"])
            fast, fewer = outcomes(made, [Remembering(world, nodes) for world in drawn])
            assert fast == plain
            print(f"\n{id}: {len(made)} mutants, {seconds:.2f} s from scratch, {fewer:.2f} s remembered, ratio {seconds / fewer:.1f}", end="")
            ours, bare = ours + fewer, bare + seconds
    print(f"\nin all: ratio {bare / ours:.1f}")
    assert 3 * ours <= bare
