# SPDX-License-Identifier: MIT
"""Mutants are judged fast, all of them, and as a plain evaluation judges them."""

from __future__ import annotations

import pytest

from exactkf.claims import load
from exactkf.engine import _find, mutate_claim
from exactkf.evidence import example, instances, order
from exactkf.finders.equal import Original
from exactkf.finders.mutants import MutantReport, _accepted, judge_mutants
from exactkf.finders.remembering import Remembering, nodes_of
from exactkf.kernel.instances import admissible, read_instance
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.language import (
    Statement,
    T,
    always,
    given,
    iff,
    matrix,
    positive,
    positive_semidefinite,
    psd,
    rec,
    scalar,
    standing,
    sum_of,
    symbols,
    symmetric_matrix,
    vector,
)
from exactkf.language.mutate import mutants, rewritings
from exactkf.language.statement import as_tuples
from exactkf.language.text import text

F, P, Q, x, y, v, n, t, k, j = symbols("F P Q x y v n t k j")
SAMPLE = ["B93-E3", "BLM91-E2.15", "BLM91-T3.3.1c", "BLZ94-E2.18", "BLZ94-S29", "BLZ94-E3.20", "D71-E3.40", "D71-S23", "NWL92-E4.20"]


def judged(statement, *by):
    """Outcomes by kind."""
    data = statement.to_json()
    found = _find("test", statement, by, 0)
    report = judge_mutants(data, by, found.drawn, found.sampler)
    outcomes: dict[str, set[str]] = {}
    for row in report.rows:
        outcomes.setdefault(row["kind"], set()).add(row["outcome"])
    return outcomes, report


def value(world, says):
    try:
        return world.value(says)
    except (Undefined, Unknown) as error:
        return type(error), str(error)


@pytest.mark.parametrize("id", SAMPLE)
def test_what_is_remembered_changes_no_value(id):
    """Every mutant has the value that a plain world gives it, or fails as it does there."""
    claim = load()[id]
    statement, by = (claim.repair.statement, claim.repair.by) if claim.repair else (claim.statement, claim.by)
    data = statement.to_json()
    nodes = nodes_of(data["says"])
    drawn = _find(id, statement, by, 0).drawn
    for _, world in drawn[::max(1, len(drawn) // 4)]:
        fast = Remembering(world, nodes)
        for mutant in mutants(data):
            assert value(fast, mutant.says) == value(world, mutant.says), mutant.kind


@pytest.mark.parametrize("id", SAMPLE)
def test_each_rejection_replays_from_its_instance(id):
    """Read again from what is shown: types and hypotheses hold, the original is true or has no value, and the mutant is false."""
    claim = load()[id]
    statement = claim.repair.statement if claim.repair else claim.statement
    data = statement.to_json()
    made = [m for m in mutants(data) if not m.drops]
    shown = mutate_claim(claim)
    assert len(made) == sum(not row["kind"].startswith("hypothesis '") for row in shown["rows"]) + shown["void"], "all mutants are judged"
    says = {(row["kind"], row["text"]): row for row in shown["rows"] if row["outcome"] == "rejected"}
    again = 0
    for mutant in made:
        row = says.get((mutant.kind, text(as_tuples(mutant.says))))
        if row is not None:
            world = World(data, read_instance(data, row["instance"]))
            assert admissible(data, world) == "" and value(world, data["says"]) is not False and world.value(mutant.says) is False
            again += 1
    assert again > 0 and not shown["survivors"]


@pytest.mark.parametrize("id", SAMPLE)
def test_equal_rewritings_are_accepted(id):
    """Sums reversed, sides exchanged, zero added, symbols renamed: all true on the instances; a mutant is not accepted so."""
    claim = load()[id]
    statement, by = (claim.repair.statement, claim.repair.by) if claim.repair else (claim.statement, claim.by)
    data = statement.to_json()
    drawn = _find(id, statement, by, 0).drawn
    worlds = [world for _, world in drawn]
    made = rewritings(data)
    assert "symbols renamed" in dict(made) and all(_accepted(data, new, worlds[:6], MutantReport()) for _, new in made)
    wrong = next(m for m in mutants(data) if not m.drops and any(value(w, m.says) is False for w in worlds))
    assert not _accepted(data, {**data, "says": wrong.says}, worlds, MutantReport())


def test_a_long_formula_has_all_its_mutants_judged():
    """More than there is room for in a sample, and none left out."""
    says = sum((x**e for e in range(1, 30)), x**0) * (x - 1) == x**30 - 1
    statement = Statement(says, over={x: scalar()})
    _, report = judged(statement, instances(4))
    assert report.made + report.void == len(mutants(statement.to_json())) > 90 and not report.survivors


def test_an_inner_index_is_told_apart():
    """A node under a sum has another value for each index; equal nodes under different indices are not mixed up."""
    data = Statement((sum_of(k, 1, n, sum_of(j, 1, k, v[j] * v[k])) == 0) & (sum_of(j, 1, n, sum_of(k, 1, j, v[j] * v[k])) == x),
                     sizes=["n"], over={v: vector(n), x: scalar()}).to_json()
    plain = World(data, read_instance(data, {"sizes": {"n": 3}, "values": {"v": [[1], [2], [5]], "x": 3}}))
    fast = Remembering(plain, nodes_of(data["says"]))
    for mutant in mutants(data):
        assert value(fast, mutant.says) == value(plain, mutant.says)
    first = data["says"][1][1]
    assert fast.value(first) == plain.value(first) == 1 + 2 * 3 + 5 * 8


def test_an_entry_that_there_is_not_makes_no_statement():
    """The sum of v_1 .. v_n up to v_(n+1), or from v_0 on, is none; nor is an index before the start of a recursion."""
    statement = Statement(sum_of(k, 1, n, v[k]) - sum_of(k, 1, n, v[k]) == 0, sizes=["n"], over={v: vector(n)})
    outcomes, report = judged(statement, instances(4, n=(1, 2)))
    assert report.void >= 4 and not report.survivors and "rejected" in outcomes["index shifted"]


def test_the_transpose_of_a_symmetric_side_is_the_same_at_any_t():
    """P' = y_t FQF' + vv' says the same as P = y_t FQF' + vv', whatever the value of y_t."""
    step = y[t] * F * Q * T(F) + v * T(v)
    statement = Statement(always(t, P[t + 1] == step), sizes=["n"], over={F: matrix(n, n), Q: symmetric_matrix(n), v: vector(n), x: scalar()},
                          where=[rec(y, t, 1, x * y[t]), rec(P, t, Q, step)])
    data = statement.to_json()
    [turned] = [m for m in mutants(data) if m.kind == "transpose added"]
    assert Original(data, (instances(n=(1, 2)),)).says_as_much(turned.says, turned.path)


def test_powers_that_commute_for_a_reason_are_not_taken_for_equal():
    """F P_t = P_t F needs that P_t is a power of F: for any value of P_t it is false, so that it is not shown by symbols for P_t."""
    data = Statement(always(t, P[t + 1] == F * P[t]), sizes=["n"], over={F: matrix(n, n)}, where=[rec(P, t, F, F * P[t])]).to_json()
    [exchanged] = [m for m in mutants(data) if m.kind == "factors exchanged"]
    assert not Original(data, (instances(n=(1, 2)),)).says_as_much(exchanged.says, exchanged.path)


def test_a_stronger_statement_is_refuted_or_said():
    """A strict relation for a weak one: false for semidefinite matrices, true for a square plus one, which the claim does not deny."""
    outcomes, _ = judged(Statement(psd(P), sizes=["n"], over={P: positive_semidefinite(n)}), order(), instances(n=(1, 2)))
    assert outcomes["more claimed"] == {"rejected"}
    outcomes, report = judged(Statement((x**2 + 1 >= 0) & (x * x >= 0), over={x: scalar()}), instances(), example({x: 0}))
    assert outcomes["more claimed"] == {"rejected", "stronger"} and report.stronger == 1 and not report.survivors


def test_relations_in_an_equivalence_are_changed_both_ways():
    """Neither direction of strictness may be a matter of taste there."""
    data = Statement(iff(x > 0, y >= 0), over={x: scalar(), y: scalar()}).to_json()
    kinds = [m.kind for m in mutants(data)]
    assert "relation weakened" in kinds and "relation strengthened" in kinds and "more claimed" not in kinds


def test_a_hypothesis_is_weakened():
    """x > 0 becomes x >= 0; a standing one stays as it is."""
    data = Statement(1 / x > 0, over={x: scalar(), y: scalar()}, given=[given("x", x > 0), standing("y", y > 0)]).to_json()
    made = [(m.kind, m.weaker) for m in mutants(data) if m.drops]
    assert made == [("hypothesis 'x' dropped", None), ("hypothesis 'x' weakened", [">=", ["sym", "x"], 0])]


def test_an_order_for_a_neighbour_proves_it():
    """P + Q - P is semidefinite, and so is P + Q + P: a second order among the evidence shows the latter, which else survives."""
    statement = Statement(psd(P + Q - P), sizes=["n"], over={P: positive_semidefinite(n), Q: positive_semidefinite(n)})
    _, alone = judged(statement, order([Q]), instances(n=(1, 2)))
    _, helped = judged(statement, order([Q]), order([2 * P, Q]), instances(n=(1, 2)))
    assert len(alone.survivors) == 1 and alone.survivors[0].startswith("sign flipped") and not helped.survivors


def test_an_instance_that_fails_a_hypothesis_refutes_nothing():
    """All instances of a mutant are the original's: with x > 0 the sign of x^2 = x|x| is not wrong by a negative x."""
    statement = Statement(x * x == x * abs(x), over={x: positive()})
    _, report = judged(statement, instances())
    assert all(row["instance"] is None or not str(row["instance"]["values"]["x"]).startswith("-") for row in report.rows)
    assert {row["outcome"] for row in report.rows} >= {"rejected"}
