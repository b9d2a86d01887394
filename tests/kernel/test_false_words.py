# SPDX-License-Identifier: MIT
"""False statements about products, sums and rules at a generic index: the checker rejects each, and accepts the true neighbour."""

from __future__ import annotations

import pytest

from tests.kernel.test_false_claims import accepted, statement

n, m, t, k, s, i, j, c, u = (["sym", name] for name in ("n", "m", "t", "k", "s", "i", "j", "c", "u"))
A, B, F, Q = (["sym", name] for name in "ABFQ")
NUMBER = [["c", ["scalar"]]]
NULL = statement(["=", c, 0], NUMBER)
SOME = [["n >= 1", [">=", n, 1], "standing"]]


def at(name, *indices):
    return ["at", name, *indices]


def rec(name, start, step):
    return ["rec", name, "t", 0, [start], step]


def unit(rows, cols, least):
    """Ones on the diagonal from a place on, as entries."""
    return ["mat", "i", "j", rows, cols, ["if", ["and", ["=", i, j], [">=", i, least]], 1, 0]]


def accepts(made, evidence, kind="generic index"):
    return accepted(kind, made, evidence)


# ---------------------------------------------------------------------- inverses in sums
SINGULAR = ["inv", ["mat", "i", "j", 2, 2, 0]]
OVER = [["F", ["matrix", 2, 2]], ["u", ["matrix", 2, 1]], ["w", ["signal", 0]]]
CANCELLED = {"index": "s", "fact": "solve", "says": ["=", ["*", SINGULAR, u, 0], u]}  # there is no inv(0), and so this is empty
USES = {"lemmas": [CANCELLED], "uses": [{"lemma": 0, "at": {"s": 0, "row": 1, "column": 1}}]}
NOWHERE = {"sizes": {"n": 0}, "values": {"F": [[0, 0], [0, 0]], "w": [0], "u": [[1], [1]]}}


@pytest.mark.parametrize("where, body", [
    ((), ["entry", ["*", SINGULAR, ["^", F, k], u], 1]),
    ([["let", "y", [], ["entry", ["*", SINGULAR, u], 1]]], ["*", ["sym", "y"], at("w", k)]),
], ids=["word", "name"])
@pytest.mark.parametrize("shift", [0, 1, 2])
def test_an_inverse_in_an_empty_sum_is_not_met_when_the_sum_is_read_again(where, body, shift):
    """From 1 + a to t + a there is nothing for t = 0, though terms at 1, .., a and after t are written out to name the sum; nor behind a name."""
    for low, good in ((1 + shift, False), (shift, True)):
        total = ["sum", "k", low, ["+", t, shift], body]
        made = statement(["forall", "t", 0, n, ["=", ["+", total, at("u", 1)], total]], OVER, (), where)
        assert accepts(made, USES) is good  # there is no instance of the second
        assert accepts(made, {"instance": NOWHERE}, "counterexample") is not good


# ---------------------------------------------------------------------- shapes
def test_a_matrix_that_is_not_square_has_no_powers():
    """F^0 of n rows and m columns is no product I of a recursion that starts with ones on a diagonal."""
    product = ["*", at("X", 0), ["T", at("X", 0)]]
    upper = ["mat", "i", "j", n, n, ["if", ["and", ["=", i, j], ["<=", i, m]], 1, 0]]
    lemmas = [{"index": "s", "direct": True, "says": ["=", product, upper]}, {"index": "t", "rule": True, "says": ["=", at("X", t), ["^", F, t]]}]
    evidence = {"lemmas": lemmas, "uses": [{"lemma": 0, "at": {"s": 0, "row": n, "column": n}, "times": c}]}
    made = {**NULL, "over": [["F", ["matrix", n, m]], *NUMBER], "given": [["n > m", [">", n, m], "standing"]], "sizes": ["n", "m"],
            "where": [rec("X", unit(n, m, 1), ["^", F, ["+", t, 1]])]}
    assert not accepts(made, evidence)
    for power in (["^", F, 0], ["^", F, 2], ["subst", at("p", 0), F], ["*", ["^", F, 0], ["I", m]], ["inv", F]):
        square, where = [["F", ["matrix", m, m]]], [rec("p", 1, ["*", ["z"], at("p", t)])]
        for x in (["=", power, power], ["=", ["entry", power, 1, 1], ["entry", power, 1, 1]]):
            told = statement(x, [["F", ["matrix", n, m]]], SOME, where, ["n", "m"])
            assert power[0] == "inv" and x[1][0] == "entry" or not accepts(told, {"lemmas": [], "supported": ["p"]})  # nothing is told of no inverse
            assert accepts({**told, "over": square}, {"lemmas": [], "supported": ["p"]})


@pytest.mark.parametrize("name", ["s", "k"])
def test_a_sum_has_one_shape_whatever_an_index_of_its_name_is_elsewhere(name):
    """A + B has no size if they have two, also where an s is 1 for which the sum would be of matrices A alone."""
    total = ["sum", "s", 1, 2, ["if", ["<=", s, 1], A, B]]

    def sums(top):
        return ["sum", "l", 1, top, at("w", ["sym", "l"])]

    lemma = {"index": "t", "direct": True, "says": ["forall", name, 1, 1, ["=", sums(["nrows", Q]), sums(n)]]}
    over = [["A", ["matrix", n, n]], ["B", ["matrix", m, m]], ["w", ["signal", 0]]]
    made = statement(["forall", "t", 0, 0, ["forall", name, 2, 2, ["=", sums(m), sums(n)]]], over, (), [["let", "Q", [], total]], ["n", "m"])
    evidence = {"lemmas": [lemma], "uses": [{"lemma": 0, "at": {"t": 0, name: 1}}]}
    assert not accepts(made, evidence)
    same = {**made, "over": [over[0], ["B", ["matrix", n, n]], over[2]]}
    assert not accepts(same, evidence) and accepts({**same, "says": ["=", sums(["nrows", Q]), sums(n)]}, evidence)


# ---------------------------------------------------------------------- rules
@pytest.mark.parametrize("place, good", [(0, False), (["+", n, 1], False), (1, True)])
def test_a_rule_says_nothing_beyond_the_last_row(place, good):
    """X = I by a rule, and 7 at the place (0, 0), which X does not have; nor has it a place n + 1: nothing follows from either."""
    start = ["mat", "i", "j", n, n, ["if", ["=", i, j], ["if", ["and", [">=", i, 1], ["<=", i, n]], 1, 7], 0]]
    entry = ["entry", at("X", 0), place, place]
    lemmas = [{"index": "s", "direct": True, "says": ["=", entry, 1 if good else 7]}, {"index": "t", "rule": True, "says": ["=", at("X", t), ["I", n]]}]
    times = {"times": ["/", c, -6]}
    made = {**NULL, "given": SOME, "where": [rec("X", start, start)]}
    for lemma, use in ((lemmas, {"lemma": 0, "at": {"s": 0}}), (lemmas[1:], {"definition": "X", "at": [1], "place": {"row": place, "column": place}})):
        assert not accepts(made, {"lemmas": lemma, "uses": [{**use, **times}]})
        assert accepts({**made, "says": ["=", c, c]}, {"lemmas": lemma, "uses": [use]}) is (good or "definition" in use)  # a definition is not used there
    assert accepts({**made, "says": ["=", entry, 1]}, {"lemmas": lemmas[1:]}) is good


# ---------------------------------------------------------------------- what is not zero
def test_two_divisions_by_zero_do_not_excuse_each_other():
    """With X = 1 and Y = 0, X/Y = A and (Y - 1)/(X - 1) = B: by the one X = AY = 0, not 1; by the other Y = B(X - 1) + 1 = 1, not 0."""
    where = [rec("X", 1, at("X", t)), rec("Y", 0, at("Y", t)), rec("A", 0, ["/", at("X", t), at("Y", t)]),
             rec("B", 0, ["/", ["-", at("Y", t), 1], ["-", at("X", t), 1]])]
    lemmas = [{"index": "t", "says": ["=", at(x, t), value], "uses": [{"lemma": q, "at": {"t": t}}]} for q, (x, value) in enumerate((("X", 1), ("Y", 0)))]
    by_a, by_b = ({"definition": x, "at": [["+", t, 1]]} for x in "AB")
    x_is, y_is = ({"lemma": q, "at": {"t": t}} for q in (0, 1))
    take = [{**by_a, "times": ["*", -1, c, at("Y", t)]}, {**x_is, "times": ["neg", c]}, {**y_is, "times": ["*", c, at("A", ["+", t, 1])]}]
    made = statement(["always", "t", NULL["says"]], NUMBER, (), where)
    evidence = {"lemmas": lemmas, "whole": ["A", "B"], "uses": [*take, by_a, by_b, x_is, y_is]}
    assert not accepts(made, evidence)
    assert accepts({**made, "says": ["always", "t", ["=", at("X", t), 1]]}, {**evidence, "uses": [x_is]})


@pytest.mark.parametrize("later", [["^", at("X", ["+", t, 1]), 1], ["*", ["^", at("X", ["+", t, 1]), 1], ["I", n]], at("X", ["+", t, 1])])
def test_a_recursion_made_of_itself_as_a_letter_defines_nothing(later):
    """X_(t+1) = X_(t+1)^1 + I has no solution, and X_t = X_t^1 tells nothing else."""
    lemma = {"index": "t", "direct": True, "says": ["=", at("X", t), ["^", at("X", t), 1]]}
    made = {**NULL, "over": [["F", ["matrix", n, n]], *NUMBER], "given": SOME, "where": [rec("X", F, ["+", later, ["I", n]])]}
    evidence = {"lemmas": [lemma], "uses": [{"lemma": 0, "at": {"t": 1, "row": 1, "column": 1}, "times": c}]}
    assert not accepts(made, evidence)
    assert accepts({**made, "says": ["=", at("X", 1), ["+", ["^", at("X", 0), 1], ["I", n]]], "where": [rec("X", F, ["+", ["^", at("X", t), 1], ["I", n]])]},
                   {"lemmas": [lemma]})


def test_a_chain_of_denominators_is_looked_at_in_order():
    """1/U and 1/V are allowed, as V = U + 1 and U = 1 by lemmas, one of which divides by the other."""
    where = [rec("U", 1, at("U", t)), rec("V", 2, ["/", at("V", t), at("U", t)])]
    lemmas = [{"index": "t", "says": ["=", at("U", t), 1], "uses": [{"lemma": 0, "at": {"t": t}}]},
              {"index": "t", "says": ["=", at("V", t), 2], "uses": [{"lemma": q, "at": {"t": t}} for q in (0, 1)]}]
    uses = [{"definition": "V", "at": [["+", t, 1]]}, *lemmas[1]["uses"]]
    says = ["always", "t", ["=", ["/", c, at("V", ["+", t, 1])], ["/", c, 2]]]
    assert accepts(statement(says, NUMBER, (), where), {"lemmas": lemmas, "uses": uses})
    for wrong in (3, 1):
        assert not accepts(statement(["always", "t", ["=", says[2][1], ["/", c, wrong]]], NUMBER, (), where), {"lemmas": lemmas, "uses": uses})
