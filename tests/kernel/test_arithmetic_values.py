# SPDX-License-Identifier: MIT
"""What has a value, signs on the circle, moduli, square roots and signs of cosines in statements about numbers: false neighbours are refused."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest

from exactkf.kernel.arithmetic import Facts
from exactkf.kernel.numbers import Unknown
from tests.kernel.acceptance import is_false, is_proved
from tests.kernel.test_arithmetic import NOTHING, accepted, close, found, k, n, statement, t, x

y, Z = ["sym", "y"], ["z"]
REAL = [["x", ["scalar"]], ["y", ["scalar"]]]
#: X_0 = x, X_(t+1) = 1/(1 - X_t)
ORBIT = [["rec", "X", "t", 0, [x], ["/", 1, ["-", 1, ["at", "X", t]]]]]
VALUED, CLEAR = ["valued", ""], ["clear"]


def real(says, *given, where=(), sizes=()):
    return statement(says, sizes, REAL, given, where)


def values(*indices):
    return [[hint, "X", index] for index in indices for hint in ("exist", "unfold")]


# ---------------------------------------------------------------------- defined
def test_a_quotient_is_defined_where_the_denominator_is_not_zero():
    quotient = ["defined", ["/", 1, x]]
    assert found(real(["<=>", quotient, ["!=", x, 0]])) and not found(real(quotient)) and not found(real(["not", quotient]))
    assert not found(real(["<=>", quotient, ["!=", x, 1]]))
    assert found(real(["<=>", ["defined", ["/", ["/", 1, y], x]], ["and", ["!=", x, 0], ["!=", y, 0]]]))
    assert not found(real(["<=>", ["defined", ["/", ["/", 1, y], x]], ["!=", x, 0]]))


def test_a_definition_has_a_value_where_its_arguments_and_its_body_have():
    """An argument that is not used is evaluated all the same."""
    where = [["let", "f", ["k"], ["/", 1, x]]]
    used = ["defined", ["at", "f", ["/", 1, y]]]
    assert found(real(["=>", used, ["!=", y, 0]], where=where)) and found(real(["=>", used, ["!=", x, 0]], where=where))
    assert not found(real(["=>", ["!=", x, 0], used], where=where))


def test_a_value_of_a_recursion_exists_if_those_before_it_do():
    ends = ["=", x, 1]
    first, second = (["defined", ["at", "X", index]] for index in (1, 2))
    assert found(real(["<=>", first, ["not", ends]], where=ORBIT), *values(0, 1))
    assert not found(real(first, where=ORBIT), *values(0, 1)) and not found(real(["not", first], where=ORBIT), *values(0, 1))
    assert found(real(["=>", second, first], where=ORBIT), *values(0, 1, 2)) and not found(real(["=>", first, second], where=ORBIT), *values(0, 1, 2))


def test_there_is_no_value_before_the_start():
    before = ["defined", ["at", "X", ["-", n, 3]]]
    made = statement(["=>", before, [">=", n, 3]], ("n",), REAL, (), ORBIT)
    assert found(made, ["exist", "X", ["-", n, 3]]) and not found({**made, "says": ["=>", before, [">=", n, 4]]}, ["exist", "X", ["-", n, 3]])


def test_what_is_not_taken_apart_is_refused():
    facts = Facts(real(["=", x, x], where=[["let", "c", [], ["if", ["=", x, 0], 1, 2]]]))
    for term in (["sum", "k", 0, 1, k], ["sym", "c"], ["sqrt", x], ["^", x, -1], ["cospi", x, 3], ["sym", "nothing"]):
        with pytest.raises(Unknown):
            facts.read(["defined", term], True)


# ---------------------------------------------------------------------- what is evaluated
def test_the_conclusion_tells_that_its_denominators_are_not_zero():
    """(1/x) x = 1 where it has a value; 1/x is not 0 there; but a conclusion of another form need not be evaluated there."""
    assert found(real(["=", ["*", x, ["/", 1, x]], 1]), VALUED) and not found(real(["=", ["*", x, ["/", 1, x]], 1]))
    guarded = ["=>", [">", y, 0], ["=", ["*", x, ["/", 1, x]], 1]]
    assert found(real(guarded), VALUED)
    assert not found(real(["or", ["!=", x, 0], ["=", ["/", 1, ["+", x, 1]], 2]]), VALUED)  # false at x = 0
    assert not found(real(["and", ["=", x, y], ["=", ["/", 1, x], ["/", 1, x]]]), VALUED)


def test_a_member_after_a_false_one_need_not_have_a_value():
    """x = 1 and 1/x = 1, denied: the second need not have been evaluated."""
    made = real(["and", ["!=", x, 0], ["=", ["/", x, x], 1]])
    assert not found(made, VALUED) and found({**made, "given": [["h", ["!=", x, 0], "standing"]]}, VALUED)


def test_a_hypothesis_is_true_and_so_evaluated():
    made = real(["!=", x, 0], ["=", ["/", y, x], 2])
    assert found(made, ["valued", "h"]) and not found(made) and not found(made, VALUED)
    assert not found(real(["!=", x, 0], ["or", ["=", y, 1], ["=", ["/", y, x], 2]]), ["valued", "h"])


def test_what_a_quantifier_says_at_one_place_is_evaluated():
    inverse = ["!=", ["/", 1, ["-", n, k]], 0]
    made = statement(["!=", n, 2], given=[["forall", "k", 1, 3, inverse]])
    assert found(made, ["valued", "h"], ["at", "k", 2]) and not found(made, ["at", "k", 2]) and not found(made, ["valued", "h"], ["at", "k", 4])


def test_a_step_of_the_checker_is_of_this_statement():
    made = real(["=", ["*", x, ["/", 1, x]], 1])
    assert not accepted(made, {"step": "valued", "of": "", "then": [NOTHING]}) and not accepted(made, {"step": "valued", "of": "", "then": []})
    assert not accepted(made, {"step": "exist", "name": "X", "term": 1, "then": [NOTHING]})


# ---------------------------------------------------------------------- moduli, square roots, cosines
def test_moduli():
    assert found(real([">=", ["abs", x], x])) and found(real(["<=", ["abs", ["+", x, y]], ["+", ["abs", x], ["abs", y]]]))
    assert not found(real(["=", ["abs", x], x])) and not found(real([">", ["abs", x], 0]))


def test_square_roots():
    root = ["sqrt", x]
    assert found(real(["=", ["*", root, root], x]), VALUED) and found(real([">=", root, 0]), VALUED)
    assert not found(real(["=", ["*", root, root], x])) and not found(real([">", root, 0]), VALUED) and not found(real([">=", root, 0]), ["root", x])
    assert found(real([">=", root, 0], [">=", x, 0]), ["root", x]) and not found(real(["=", ["sqrt", ["*", x, x]], x]), VALUED)
    assert found(real(["=", ["*", ["sqrt", ["*", x, x]], ["sqrt", ["*", x, x]]], ["*", x, x]]), VALUED)


def test_the_sign_of_a_cosine():
    cosine = ["cospi", n, ["sym", "m"]]
    small = [[">=", ["sym", "m"], 1], ["<=", n, ["sym", "m"]]]
    made = statement(["<=>", [">", cosine, 0], ["<", ["*", 2, n], ["sym", "m"]]], ("n", "m"), given=small)
    hint = ["acute", n, ["sym", "m"]]
    assert found(made, hint) and not found({**made, "given": made["given"][:1]}, hint)
    assert not found({**made, "says": ["<=>", [">=", cosine, 0], ["<", ["*", 2, n], ["sym", "m"]]]}, hint)


# ---------------------------------------------------------------------- z
def circle(c, d):
    return ["+", c, ["*", d, ["+", Z, ["recip", Z]]]]


def test_signs_on_the_circle():
    double = ["*", 2, ["abs", y]]
    assert found(real(["<=>", ["pos_circle", circle(x, y)], [">", x, double]])) and found(real(["<=>", ["nonneg_circle", circle(x, y)], [">=", x, double]]))
    assert not found(real(["<=>", ["nonneg_circle", circle(x, y)], [">", x, double]]))
    assert not found(real(["<=>", ["pos_circle", circle(x, y)], [">", x, ["abs", y]]]))
    for term in (["+", x, ["*", y, Z]], ["+", x, ["*", y, ["+", ["*", Z, Z], ["recip", ["*", Z, Z]]]]], ["/", 1, ["+", Z, 1]]):
        with pytest.raises(Unknown):
            Facts(real(["=", x, x])).read(["pos_circle", term], True)


def test_zeros_in_the_disc():
    assert found(real(["<=>", ["schur", ["+", Z, x]], ["<", ["abs", x], 1]])) and not found(real(["<=>", ["schur", ["+", Z, x]], ["<=", ["abs", x], 1]]))
    count = ["=", ["roots_in", ["+", 1, ["*", x, Z]]], 1]
    assert found(real(["<=>", count, [">", ["abs", x], 1]])) and not found(real(["<=>", count, [">=", ["abs", x], 1]]))
    for term in (["+", ["*", x, Z], 1], ["*", Z, Z]):
        with pytest.raises(Unknown):
            Facts(real(["=", x, x])).read(["schur", term], True)
    with pytest.raises(Unknown):
        Facts(real(["=", x, x])).term(["roots_in", ["+", y, ["*", x, Z]]])


def test_equations_of_quotients_in_z():
    left, right = ["/", ["+", Z, x], ["+", Z, y]], ["/", ["*", ["+", Z, x], Z], ["*", ["+", Z, y], Z]]
    assert found(real(["=", left, right])) and not found(real(["=", left, ["/", ["+", Z, y], ["+", Z, x]]])) and not found(real(["!=", left, 1]))
    assert found(real(["=>", ["=", left, 1], ["=", x, y]])) and found(real(["=", ["recip", ["+", Z, x]], ["+", ["/", 1, Z], x]]))
    assert not found(real(["=", ["recip", ["+", Z, x]], ["+", Z, x]]))
    with pytest.raises(Unknown):
        Facts(real(["=", x, x])).read(["<", Z, 1], True)


# ---------------------------------------------------------------------- at random
VALUES = [Fraction(a, b) for a in range(-3, 4) for b in (1, 2)]


def term(rng, depth):
    if depth <= 0 or rng.random() < 0.3:
        return rng.choice((x, y, 0, 1, -1, 2, ["at", "X", 0], ["at", "X", 1]))
    op = rng.choice(("+", "-", "*", "/", "/", "abs"))
    return [op, term(rng, depth - 1)] if op == "abs" else [op, term(rng, depth - 1), term(rng, depth - 1)]


def formula(rng, depth):
    kind = rng.random()
    if depth <= 0 or kind < 0.45:
        if rng.random() < 0.25:
            return ["defined", term(rng, 2)]
        if rng.random() < 0.2:
            return [rng.choice(("pos_circle", "nonneg_circle")), circle(term(rng, 1), term(rng, 1))]
        return [rng.choice(("=", "!=", "<", "<=", ">", ">=")), term(rng, 2), term(rng, 1)]
    if kind < 0.55:
        return ["not", formula(rng, depth - 1)]
    return [rng.choice(("and", "or", "=>", "<=>")), formula(rng, depth - 1), formula(rng, depth - 1)]


def false_somewhere(made):
    return next(((a, b) for a in VALUES for b in VALUES if is_false(made, {"x": a, "y": b, "horizon": 5})), None)


@pytest.mark.parametrize("seed", range(2))
def test_nothing_false_is_proved_where_values_may_be_missing(seed):
    """With every hint that tells what has a value; some true statements are proved."""
    rng, proved = random.Random(seed), 0
    for _ in range(250):
        given = [formula(rng, 1)] if rng.random() < 0.5 else []
        made = real(formula(rng, 2), *given, where=ORBIT)
        hints = [*([VALUED] if rng.random() < 0.7 else []), ["valued", "h"], CLEAR, *values(1, 0)]
        if is_proved(made, hints):
            proved += 1
            assert false_somewhere(made) is None, made
    assert proved > 20


def test_a_product_of_facts_that_are_not_strict_closes_nothing():
    """0 >= 0 is no contradiction, whatever is multiplied."""
    assert not accepted(real([">", ["abs", x], 0]), close(["1", [0]]))


def test_a_fact_that_says_nothing_without_its_quotients_is_left():
    """x/x <= 1 is 0 >= 0 times x, which is no contradiction; x/x < 1 is one."""
    says = ["=", ["+", ["/", y, x], ["/", 1, y]], ["/", ["+", ["*", y, y], x], ["*", x, y]]]
    assert found(real(says, [">", x, 0], [">", y, 0], [">=", 1, ["/", x, x]]), CLEAR)
    assert found(real(["=", x, y], [">", x, 0], [">", 1, ["/", x, x]]), CLEAR)


# ---------------------------------------------------------------------- for all t
def test_what_is_so_for_all_t_is_denied_at_some_t():
    every = [["rec", "U", "t", 0, [1], ["+", ["at", "U", t], ["*", x, x]]]]
    step = ["induct", "j", 0, [">=", ["at", "U", ["sym", "j"]], 1], [[["unfold", "U", 0]], [["unfold", "U", ["+", ["sym", "j"], 1]], ["square", x]], []]]
    hints = step, ["at", "j", t]
    assert found(real(["always", "t", [">=", ["at", "U", t], 1]], where=every), *hints)
    assert not found(real(["always", "t", [">", ["at", "U", t], 1]], where=every), *hints)
    assert not found(real(["always", "t", ["=", ["at", "X", t], x]], where=ORBIT), *values(0, 1))


def test_that_something_is_so_for_all_t_is_not_assumed():
    """X_t may have no value from some t on: then X_t = x for all t says nothing of later values."""
    every = ["always", "t", ["=", ["at", "X", t], x]]
    for formula, affirmed in ((every, True), (["not", every], False), (["=>", every, ["=", x, 0]], False), (["<=>", every, ["=", x, 0]], False)):
        with pytest.raises(Unknown):
            Facts(real(["=", x, x], where=ORBIT)).read(formula, affirmed)
    assert not found(real(["=", x, 2], every, where=ORBIT), *values(0, 1), ["at", "t", 0])
