# SPDX-License-Identifier: MIT
"""A formula is no term: where one stands as a number, its truth for symbols would be taken for its truth on every instance."""

from __future__ import annotations

import pytest

from tests.kernel.test_false_claims import accepted, statement

x, y, k, t, A = (["sym", name] for name in "xyktA")
NUMBERS = [["x", ["scalar"]], ["y", ["scalar"]]]
SAME, TRUE = ["=", x, y], ["=", 1, 1]
ITSELF = [["let", "f", ["p"], ["sym", "p"]]]
NAMED, CHOSEN = [["let", "same", [], SAME]], [["let", "one", [], ["if", TRUE, ["sym", "same"], TRUE]], ["let", "same", [], SAME]]


@pytest.mark.parametrize(("says", "where"), [
    (["=", ["*", SAME, 1], 0], []), (["=", ["+", SAME, 1], 1], []), (["=", ["sum", "k", 1, 2, SAME], 0], []), (["=", ["^", 2, SAME], 1], []),
    (["=", ["det", ["rows", [SAME]]], 0], []), (["=", ["mat", "i", "j", 1, 1, SAME], ["O", 1, 1]], []), (["=", ["neg", ["block", [SAME]]], ["O", 1, 1]], []),
    (["forall", "k", 1, SAME, ["=", 0, 1]], []), (["=", ["entry", ["rows", [5, 7]], 1, ["+", 1, SAME]], 5], []),
    (["=", ["if", TRUE, ["*", SAME, 2], 1], 0], []),
    (["=", ["*", 1, ["if", TRUE, SAME, 1]], 0], []), (["=", ["*", 1, ["at", "f", SAME]], 0], ITSELF),
    (["=", ["*", ["sym", "same"], 1], 0], NAMED),
    (["=", ["*", ["sym", "one"], 1], 0], CHOSEN), (["=", ["*", ["at", "X", 0], 1], 0], [["rec", "X", "t", 0, [SAME], ["at", "X", t]]]),
])
def test_a_formula_is_no_number(says, where):
    """It would be zero of two symbols, and one of two numbers that are equal; neither the proof nor the instance against it is read."""
    made = statement(says, NUMBERS, (), where, sizes=[])
    assert not accepted("identity", made, {"cases": [{}]})
    assert not accepted("counterexample", made, {"instance": {"sizes": {}, "values": {"x": 1, "y": 1}}})


def test_symmetry_is_no_number():
    """A matrix of symbols is not symmetric; that it never is does not follow."""
    made = statement(["=", ["*", ["symmetric", A], 1], 0], [["A", ["matrix", 2, 2]]], sizes=[])
    assert not accepted("identity", made, {"cases": [{}]})


@pytest.mark.parametrize("kind", [["integer", 0, SAME], ["matrix", SAME, 1], ["sequence", 0, SAME], ["sequence_of", 0, SAME, ["matrix", 1, 1]]])
def test_a_formula_is_no_size(kind):
    """Nor an end of a range."""
    made = statement(["=", 1, 1], [*NUMBERS, ["z0", kind]], sizes=[])
    assert not accepted("identity", made, {"cases": [{}]})
    assert accepted("identity", statement(["=", 1, 1], [*NUMBERS, ["z0", ["integer", 0, 1]]], sizes=[]), {"cases": [{}]})


def test_a_formula_has_a_name():
    """Where a formula may stand its name may, too, and a choice between formulas."""
    some = ["if", ["=", k, 1], ["sym", "same"], TRUE]
    made = statement(["=>", ["and", ["not", some], ["=", k, 2]], some], [["k", ["integer", 1, 2]]], (), [["let", "same", [], ["=", 2, 2]]], sizes=[])
    assert accepted("evaluation", made, {"cases": [{}]})


def test_the_value_at_a_truth_is_not_that_at_one():
    """f(1 = 1) is true and f(1) is one: what is remembered of the one is not taken for the other, so that f(1) = 1 has no value."""
    undefined = ["not", ["defined", ["=", ["at", "f", 1], 1]]]
    assert not accepted("evaluation", statement(["and", ["at", "f", TRUE], undefined], [], (), ITSELF, sizes=[]), {"cases": [{}]})
    assert not accepted("evaluation", statement(undefined, [], (), ITSELF, sizes=[]), {"cases": [{}]})
    assert accepted("evaluation", statement(["=", ["at", "f", 1], 1], [], (), ITSELF, sizes=[]), {"cases": [{}]})


def test_what_is_carried_along_is_a_formula_of_terms():
    """X = 0 for all t, beside what X = Y is as a number; an equation of terms may go along."""
    where = [["rec", "X", "t", 0, [0], ["at", "X", t]], ["rec", "Y", "t", 0, [1], ["at", "Y", t]]]
    made = statement(["always", "t", ["=", ["at", "X", t], 0]], [], (), where, sizes=[])
    alike = ["=", ["*", ["=", ["at", "X", t], ["at", "Y", t]], 1], 0]
    assert not accepted("induction", made, {"cases": [{}], "also": [alike], "cofactors": [[[1, 0, 1]], []]})
    assert accepted("induction", made, {"cases": [{}], "cofactors": [[[1, 0, 1]]]})
    assert accepted("induction", made, {"cases": [{}], "also": [["=", ["at", "Y", t], 1]], "cofactors": [[[1, 0, 1]], [[1, 1, 1]]]})


def test_a_root_that_is_not_rational_has_a_value():
    """It is not said to have none, and what holds always does not end at it."""
    root = [["rec", "X", "t", 0, [1, 1], ["+", ["at", "X", t], 1]]]
    made = statement(["always", "t", ["<=", ["sqrt", ["at", "X", t]], 1]], [], (), root, sizes=[])
    assert not accepted("evaluation", statement(["not", ["defined", ["sqrt", 2]]], [], sizes=[]), {"cases": [{}]})
    assert not accepted("counterexample", statement(["defined", ["sqrt", 2]], [], sizes=[]), {"instance": {"sizes": {}, "values": {}}})
    assert not accepted("instances", made, {"instances": [{"sizes": {"horizon": 30}, "values": {}}]})
    assert accepted("instances", made, {"instances": [{"sizes": {"horizon": 1}, "values": {}}]})
    assert accepted("evaluation", statement(["and", ["=", ["sqrt", 4], 2], ["not", ["defined", ["sqrt", ["neg", 4]]]]], [], sizes=[]), {"cases": [{}]})
