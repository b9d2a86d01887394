# SPDX-License-Identifier: MIT
"""False statements about integers, with proofs made by hand: the checker rejects each, and accepts the true neighbour."""

from __future__ import annotations

import pytest

from exactkf.finders.arithmetic import find_arithmetic
from exactkf.kernel.arithmetic import Facts
from exactkf.kernel.numbers import Rejected, Unknown
from exactkf.kernel.replay import seal
from tests.kernel.acceptance import is_accepted

n, m, x, k, t = (["sym", name] for name in "nmxkt")
NOTHING = {"step": "close", "terms": [["1", []]]}


def statement(says, sizes=("n",), over=(), given=(), where=()):
    return {"sizes": list(sizes), "over": [list(v) for v in over], "where": list(where), "given": [["h", g, "standing"] for g in given], "says": says}


def accepted(made, proof):
    return is_accepted(seal("X", "arithmetic", made, {"proof": proof}))


def found(made, *hints):
    """A proof that the search finds, which the checker has to accept."""
    proof = find_arithmetic(made, hints, 20.0)
    assert proof is None or accepted(made, proof)
    return proof is not None


def close(*terms):
    return {"step": "close", "terms": [list(term) for term in terms]}


# ---------------------------------------------------------------------- leaves
def test_facts_are_taken_with_a_sign_only_if_they_are_equations():
    """n > 0 denied is -n >= 0; taken -1 times it would be n >= 0 once more."""
    assert not accepted(statement([">", n, 0]), close(["-1", [1]], ["1", [0]]))
    assert not accepted(statement([">", n, 0]), close(["1", [0]], ["1", [1]]))  # 0 is no contradiction
    assert accepted(statement([">=", n, 0]), close(["1", [0]], ["1", [1]]))
    assert not accepted(statement([">=", n, 1]), NOTHING)
    assert not accepted(statement([">=", n, 1]), close())


def test_a_multiplier_of_an_inequality_is_squared():
    """x y = -1 with y > 0 does not contradict itself: a factor x of an inequality counts as x^2."""
    made = statement(["!=", ["*", x, ["sym", "y"]], -1], (), [["x", ["scalar"]], ["y", ["positive"]]])
    assert not accepted(made, close(["1", [0], x], ["1", [1]]))


def test_facts_have_numbers_within_the_list():
    for number in (-1, 5, True, "0"):
        assert not accepted(statement([">=", n, 0]), close(["1", [number]], ["1", [1]]))


def test_strict_facts_close_a_leaf_where_they_are_taken():
    """0 < 0 is a contradiction, 0 <= 0 is none; a strict fact times a square may be zero."""
    made = statement([">=", x, 0], (), [["x", ["nonneg"]]])
    assert accepted(made, close(["1", [0]], ["1", [1]]))
    assert not accepted(made, close(["1", [0], x], ["1", [1], x]))
    assert not accepted(statement([">", x, 0], (), [["x", ["nonneg"]]]), close(["1", [0]], ["1", [1]]))


# ---------------------------------------------------------------------- what is an integer
def test_a_real_number_is_no_integer():
    """Between 0 and 1 there are real numbers: neither rounding, nor rests, nor indices are for them."""
    over = [["x", ["scalar"]]]
    between = ["or", ["<=", x, 0], [">=", x, 1]]
    assert not found(statement(between, (), over))
    assert found(statement(["or", ["<=", n, 0], [">=", n, 1]]))
    rests = {"step": "divide", "term": x, "by": 1, "name": "j", "then": [NOTHING]}
    assert not accepted(statement(between, (), over), rests)
    assert not accepted(statement(["or", ["!=", ["*", 2, x], 1], [">=", x, 1]], (), over), close(["1", [0]]))
    assert not found(statement(["!=", ["*", 2, x], 1], (), over))
    assert found(statement(["!=", ["*", 2, n], 1]))


def test_halves_are_no_integers():
    """n/2 >= 1/4 says n >= 1, and n/2 is no index."""
    half = ["/", n, 2]
    assert found(statement(["or", ["<", half, ["rat", 1, 4]], [">=", n, 1]]))
    with pytest.raises(Unknown):
        Facts(statement(["=", n, n])).read(["forall", "k", 0, half, ["=", k, k]], True)
    assert not accepted(statement(["or", ["<", half, 1], [">=", half, 2]]), {"step": "divide", "term": half, "by": 1, "name": "j", "then": [NOTHING]})


def test_values_of_recursions_are_no_integers():
    """U_(t+1) = U_t/2 from 1 is never an integer again."""
    where = [["rec", "U", "t", 0, [1], ["/", ["at", "U", t], 2]]]
    made = statement(["or", ["<=", ["at", "U", n], 0], [">=", ["at", "U", n], 1]], where=where)
    assert not found(made, ["unfold", "U", n], ["unfold", "U", ["-", n, 1]])


# ---------------------------------------------------------------------- names
def test_new_names_are_new():
    """A name that stands for something already would be made to satisfy two things."""
    for name in ("n", "x", "d", "1", "a b", None, ["n"]):
        made = statement([">=", n, 3], where=[["let", "d", [], 3]], over=[["x", ["scalar"]]])
        assert not accepted(made, {"step": "divide", "term": n, "by": 2, "name": name, "then": [NOTHING, NOTHING]})
        assert not accepted(made, {"step": "induct", "name": name, "from": 0, "formula": [">=", n, 0], "then": [NOTHING] * 3})


def test_a_solved_variable_is_an_integer_still():
    """2 j = n is not solved for the integer j, which would be n/2."""
    facts = Facts(statement(["=", n, n], given=[["=", ["*", 2, n], ["+", m, m, 1]]], sizes=("n", "m")))
    assert any(f == (">=", {(): -1}) for f in facts.facts)  # 2n = 2m + 1: no integers
    facts = Facts(statement(["=", n, n], given=[["=", ["*", 2, n], ["*", 3, m]]], sizes=("n", "m")))
    with pytest.raises(Rejected):
        facts.step({"step": "solve", "fact": 2, "variable": "n"})
    facts = Facts(statement(["=", n, n], given=[["=", n, ["*", n, m]]], sizes=("n", "m")))
    with pytest.raises(Rejected):
        facts.step({"step": "solve", "fact": 2, "variable": "n"})


# ---------------------------------------------------------------------- cases
def test_every_case_needs_a_proof():
    """Fewer proofs than cases, or more, are none."""
    made = statement(["or", ["=", n, 0], [">=", n, 1]])
    proof = find_arithmetic(made, [], 5.0)
    assert proof is not None and accepted(made, proof)
    assert not accepted(made, {**proof, "then": proof["then"][:1]}) and not accepted(made, {**proof, "then": [*proof["then"], NOTHING]})
    forgotten = {"step": "forget", "facts": [], "then": [proof]}
    assert accepted(made, forgotten) and not accepted(made, {**forgotten, "facts": [0]}) and not accepted(made, {**forgotten, "then": []})
    assert not accepted(made, {"step": "divide", "term": n, "by": 0, "name": "j", "then": []})
    assert not accepted(made, {"step": "divide", "term": n, "by": -1, "name": "j", "then": []})


def test_a_fact_for_all_is_one_between_its_bounds():
    """What holds for k <= n says nothing at n + 1."""
    squares = ["forall", "k", 0, n, [">=", ["*", x, k], 0]]
    made = statement([">=", ["*", x, ["+", n, 1]], 0], over=[["x", ["scalar"]]], given=[squares])
    assert not found(made, ["at", "k", ["+", n, 1]], ["at", "k", n])
    assert found({**made, "says": [">=", ["*", x, n], 0]}, ["at", "k", n])


def test_nothing_is_known_of_an_empty_range():
    """Some k in 1 .. 0 there is not, and all of them have every property."""
    assert not found(statement(["exists", "k", 1, n, ["=", k, 1]]), ["at", "k", 1])
    assert found(statement(["=>", [">=", n, 1], ["exists", "k", 1, n, ["=", k, 1]]]), ["at", "k", 1])
    assert found(statement(["forall", "k", 1, ["neg", n], ["=", 0, 1]]))


def test_an_induction_needs_base_and_step():
    """n = 0 has a base and no step, n >= 1 a step and no base."""
    for formula in (["=", k, 0], [">=", k, 1]):
        made = statement([formula[0], n, formula[2]])
        assert not found(made, ["induct", "k", 0, formula, [[], [], []]], ["at", "k", n])
    made = statement(["exists", "j", 0, n, ["or", ["=", n, ["*", 2, ["sym", "j"]]], ["=", n, ["+", ["*", 2, ["sym", "j"]], 1]]]])
    assert found(made, ["divide", n, 2, "h", [[["at", "j", ["sym", "h"]]]] * 2])


# ---------------------------------------------------------------------- definitions
def test_definitions_that_lead_back_to_themselves_are_refused():
    """f = 1 + f and X_t = 1 + X_t have no value, and would prove everything."""
    loop = ["let", "f", [], ["+", ["sym", "f"], 1]]
    for where, term in (([loop], ["sym", "f"]), ([["let", "f", ["k"], ["+", ["at", "f", k], 1]]], ["at", "f", n]),
                        ([["let", "g", [], ["sym", "f"]], ["let", "f", [], ["+", ["sym", "g"], 1]]], ["sym", "g"])):
        assert not accepted(statement(["=", term, term], where=where), close(["1", [0]]))
    for step in (["+", ["at", "X", ["+", t, 1]], 1], ["+", ["at", "X", ["+", t, 2]], 1], ["sum", "t", 0, 9, ["at", "X", t]], ["at", "X", ["*", 2, t]],
                 ["if", ["forall", "t", 0, 9, ["=", ["at", "X", t], 0]], 1, 0], ["+", ["at", "X", ["-", t, -1]], 1]):
        facts = Facts(statement(["=", n, n], where=[["rec", "X", "t", 0, [0], step]]))
        with pytest.raises(Unknown):
            facts.step({"step": "unfold", "name": "X", "term": ["+", n, 1]})


def test_recursions_that_need_each_other_at_once_are_refused():
    """X_(t+1) = Y_t is fine with Y_(t+1) = X_t, not with Y_0 = X_5, nor by a function in between."""
    def facts(first, step, *more):
        where = [["rec", "X", "t", 0, [0], ["at", "Y", t]], ["rec", "Y", "t", 0, [first], step], *more]
        return Facts(statement(["=", n, n], where=where))

    unfold = {"step": "unfold", "name": "X", "term": ["+", n, 1]}
    assert facts(1, ["at", "X", t]).step(unfold)
    for bad in (facts(["at", "X", 5], 1), facts(1, ["at", "X", ["+", t, 1]]), facts(1, ["at", "f", t], ["let", "f", ["k"], ["at", "X", ["+", k, 1]]])):
        with pytest.raises(Unknown):
            bad.step(unfold)


def test_values_before_the_start_are_not_known():
    """U_(n-1) = U_n - 1 for U_t = t holds from n = 1 on only."""
    where = [["rec", "U", "t", 0, [0], ["+", ["at", "U", t], 1]]]
    says = ["=", ["at", "U", n], ["+", ["at", "U", ["-", n, 1]], 1]]
    assert not found(statement(says, where=where), ["unfold", "U", n])
    assert found(statement(says, where=where, given=[[">=", n, 1]]), ["unfold", "U", n])


# ---------------------------------------------------------------------- quotients and cosines
def test_a_quotient_is_one_if_the_divisor_is_not_zero():
    """(x/y) y = x leaves y = 0 aside; the statement does where it divides, and a lemma about another quotient does not."""
    over = [["x", ["scalar"]], ["y", ["scalar"]]]
    y = ["sym", "y"]
    quotient = ["quotient", x, y]
    assert not found(statement(["=", ["*", ["/", x, y], y], x], (), over), quotient)
    assert found(statement(["=", ["*", ["/", x, y], y], x], (), over, [["!=", y, 0]]), quotient)
    assert not found(statement(["exists", "k", 0, n, ["=", ["/", x, x], 1]], over=over), ["quotient", x, x], ["at", "k", 0])


def test_cosines_are_equal_for_the_angles_that_they_are_for():
    """cos(pi/3) is not cos(2 pi/3); cos(5 pi/3) is cos(pi/3); with a denominator that may be zero nothing is said."""
    def cos(a, b):
        return ["cospi", a, b]

    def equal(a, b):
        return ["cosines", a, b, 3]
    assert found(statement(["!=", cos(1, 3), cos(2, 3)]), equal(1, 2))
    assert not found(statement(["=", cos(1, 3), cos(2, 3)]), equal(1, 2), ["at", "turns", 0], ["at", "turns", 1])
    assert found(statement(["=", cos(5, 3), cos(1, 3)]), equal(5, 1), ["at", "turns", 1])
    assert found(statement(["=", cos(["neg", n], 3), cos(n, 3)]))
    assert not found(statement(["=", cos(["+", n, 1], 3), cos(n, 3)]), ["cosines", ["+", n, 1], n, 3])
    assert found(statement(["=", cos(["*", 2, n], 6), cos(n, 3)])) and not found(statement(["=", cos(n, 6), cos(n, 3)]), ["cosines", n, ["*", 2, n], 6])
    assert not found(statement(["=", cos(n, ["*", 2, n]), 0]), ["right", n])
    assert found(statement(["=", cos(n, ["*", 2, n]), 0], given=[[">=", n, 1]]), ["right", n])
    twice = ["=", ["*", 2, cos(n, 3), cos(n, 3)], ["+", cos(["*", 2, n], 3), 1]]
    assert found(statement(twice), ["product", n, n, 3]) and not found(statement([*twice[:2], cos(["*", 2, n], 3)]), ["product", n, n, 3])
    with pytest.raises(Unknown):
        Facts(statement(["=", x, x], over=[["x", ["scalar"]]])).term(cos(x, 3))


# ---------------------------------------------------------------------- what is a number
def test_values_of_recursions_of_matrices_or_polynomials_are_no_numbers():
    """Two matrices need not commute, and the square of a polynomial has no sign: such recursions are refused, by whatever way a matrix comes in."""
    matrix = ["rows", [0, 1], [0, 0]]
    for start, over in ((matrix, ()), (["sym", "A"], [["A", ["matrix", 2, 2]]]), (["z"], ()), (["sym", "L"], ()), (["entry", matrix, 1, 1], ())):
        where = [["let", "L", [], matrix], *(["rec", name, "t", 0, [start], ["at", name, t]] for name in "VW")]
        v, w = ["at", "V", n], ["at", "W", n]
        assert not found(statement(["=", ["*", v, w], ["*", w, v]], over=over, where=where))
        assert not found(statement([">=", ["*", v, v], 0], over=over, where=where))
    numbers = [["rec", name, "t", 0, [2], ["at", name, t]] for name in "VW"]
    assert found(statement(["=", ["*", ["at", "V", n], ["at", "W", n]], ["*", ["at", "W", n], ["at", "V", n]]], where=numbers))


def test_a_matrix_enters_through_another_recursion():
    where = [["rec", "V", "t", 0, [["at", "W", t]], ["at", "V", t]], ["rec", "W", "t", 0, [["I", 2]], ["at", "W", t]]]
    where[0][4] = [["at", "W", 0]]
    assert not found(statement([">=", ["*", ["at", "V", n], ["at", "V", n]], 0], where=where))


# ---------------------------------------------------------------------- small statements, against their values
@pytest.mark.parametrize("says", [
    ["or", ["<", n, 2], ["exists", "k", 2, n, ["exists", "j", 1, n, ["=", n, ["*", k, ["sym", "j"]]]]]],
    ["<=>", ["exists", "k", 0, n, ["=", n, ["*", 3, k]]], ["exists", "k", 0, n, ["=", ["+", n, 3], ["*", 3, k]]]],
    ["!=", ["*", n, n], 2], ["!=", ["*", n, n], 4], ["=>", [">=", n, 3], [">", ["*", n, n], ["*", 2, n]]],
    ["=>", [">=", n, 2], [">", ["*", n, n], ["*", 2, n]]],
    ["if", ["=", n, 0], [">=", n, 0], [">=", n, 1]], ["if", ["=", n, 0], [">=", n, 1], [">=", n, 1]],
    [">", ["if", [">=", n, 5], n, 5], 4], [">", ["if", [">=", n, 5], n, 4], 4],
])
def test_nothing_false_is_found(says):
    """What the search proves is true for n = 0 .. 12."""
    from exactkf.kernel.meaning import World
    made = statement(says)
    holds = all(World(made, {"n": value}).value(says) is True for value in range(13))
    assert holds or not found(made, ["at", "k", n], ["at", "j", 1], ["divide", n, 3, "h"])


def test_disjunctions_that_are_true_anyway_do_not_double_the_cases():
    """Thirteen hypotheses that say nothing would make 2^13 cases of each of the three for x."""
    others = [f"y{c}" for c in range(13)]
    given = [["or", *(["=", x, c] for c in (1, 2, 3))], *(["or", ["=", x, ["/", x, 1]], [">", ["sym", y], 0]] for y in others)]
    over = [[y, ["scalar"]] for y in ("x", *others)]
    assert found(statement(["<=", ["*", x, x], 9], (), over, given))
    assert not found(statement(["<=", ["*", x, x], 8], (), over, given))
