# SPDX-License-Identifier: MIT
"""Statements with quotients, definedness, roots and signs on the circle, right or nearly so, drawn at random: nothing false is proved."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import pytest

from exactkf.kernel.meaning import World, truth
from tests.kernel.acceptance import is_false, is_proved
from tests.kernel.test_steps_on_instances import FREE, RELATIONS, Draw

z, n, m, x, y, w = ["z"], *(["sym", name] for name in "nmxyw")
REAL = (0, 1, -1, Fraction(1, 2), 2, -3)
SIGNS = {"scalar": lambda v: True, "nonzero": lambda v: v != 0, "positive": lambda v: v > 0, "nonneg": lambda v: v >= 0}


def nearly(draw):
    """A formula that could be right: both sides are about the same terms."""
    rng = draw.rng
    small = ["-", n, 2], n, x, y, w, ["sym", "q"], ["at", "U", n], ["at", "V", m], ["/", y, w], ["/", 1, x], 1, -1, 2, ["rat", 1, 2]
    a, b, c = (rng.choice(small) for _ in range(3))
    said = rng.choice((a, ["/", a, b], ["/", ["+", a, b], c], ["abs", a], ["sqrt", ["^", a, 2]], ["-", ["/", a, b], c], ["at", "U", x], ["at", "g", a]))
    on = ["+", a, ["*", b, ["+", z, ["/", 1, z]]]]
    facts = [
        [rng.choice(RELATIONS), said, rng.choice((c, 0))], ["=", a, ["*", b, c]],
        [rng.choice(RELATIONS), ["*", a, b], 0], [rng.choice(RELATIONS), a, b],
        ["defined", said],
        ["defined", rng.choice((["/", a, b], ["at", "U", rng.choice((n, x, 2, 3))], ["at", "V", rng.choice((n, x, 2, 3))]))], ["!=", b, 0],
        [rng.choice(("pos_circle", "nonneg_circle")), on], [rng.choice(RELATIONS), a, ["*", 2, b]], [rng.choice(RELATIONS), a, ["*", 2, ["abs", b]]],
        ["schur", ["+", a, z]], [rng.choice(RELATIONS), ["^", a, 2], 1], ["=", ["roots_in", ["+", 1, ["*", a, z]]], rng.choice((0, 1))],
        ["=", ["/", a, ["-", z, b]], ["/", c, ["-", z, rng.choice((b, c))]]],
        ["=", ["abs", a], rng.choice((a, ["neg", a]))], [rng.choice(RELATIONS), x, rng.randint(-1, 2)],
        [rng.choice(("forall", "exists")), "k", rng.choice((0, x)), rng.choice((2, n)),
         [rng.choice(RELATIONS), rng.choice((["/", a, ["sym", "k"]], ["*", a, ["sym", "k"]])), b]],
        [rng.choice(RELATIONS), ["cospi", rng.choice((1, x)), rng.choice((n, m, 2))], 0], ["at", "r", a], ["at", "p", x]]
    first, second = rng.sample(facts, 2)
    said = [rng.choice(("=>", "=>", "=>", "<=>", "or", "and")), first, second]
    kind = rng.random()
    return said if kind < 0.6 else ["=>", rng.choice(facts), said] if kind < 0.8 else rng.choice((first, ["not", said], ["=>", said, rng.choice(facts)]))


def hints(draw):
    rng = draw.rng
    more = [[kind, name, at] for kind in ("exist", "unfold") for name in "UV" for at in (n, x, 2, ["-", n, 1])]
    more += [["quotient", y, w], ["quotient", 1, x], ["root", x], ["root", y], ["acute", 1, n], ["acute", x, m], ["at", "k", x], ["at", "k", 1],
             ["cut", ["=", w, 0], [], []],
             ["cut", ["<", x, 0], [], []], ["valued", "h0"]]
    return [*([["valued", ""]] if rng.random() < 0.7 else []), *([["clear"]] if rng.random() < 0.7 else []), *rng.sample(more, 3)]


def refuted(made, rng):
    """An instance on which the statement is false."""
    kind = made["over"][2][1][0]
    every = list(product(range(5), range(4), range(-2, 4), REAL, REAL))
    for found in rng.sample(every, 700):
        if SIGNS[kind](found[-1]) and is_false(made, {**dict(zip("nmxyw", found, strict=True)), "horizon": 5}):
            return found
    return None


def proved(seed, count, seconds=0.3):
    """How many of so many statements are proved; none of them may be false."""
    draw, found = Draw(seed), 0
    for _ in range(count):
        made = draw.statement()
        made["given"] = [["h0", nearly(draw), "standing"]] if draw.rng.random() < 0.3 else []
        made["says"] = nearly(draw) if draw.rng.random() < 0.9 else draw.formula(2, FREE)
        if is_proved(made, hints(draw), seconds):
            found += 1
            assert (wrong := refuted(made, draw.rng)) is None, (made, wrong)
    return found


@pytest.mark.parametrize("seed", range(3))
def test_no_statement_about_quotients_is_proved_and_false(seed):
    assert proved(seed, 120) > 8


# ---------------------------------------------------------------------- what has a value, here and where instances are evaluated
def said(formula, *where):
    return {"sizes": ["n"], "over": [], "where": list(where), "given": [], "says": formula}


def is_true(made, **values):
    return truth(World(made, {"n": 4, "horizon": 5, **values}), made["says"], {})


@pytest.mark.parametrize("below", [-1, 0, ["-", n, 5]])
def test_a_cosine_has_no_value_below_one(below):
    made = said(["defined", ["cospi", 1, below]])
    assert not is_true(made)
    assert not is_proved(made, [])
    assert is_proved({**made, "says": ["not", made["says"]]}, []) == isinstance(below, int)


CONSTANT = ["rec", "U", "t", 0, [7], ["at", "U", ["sym", "t"]]]


@pytest.mark.parametrize("index", [["/", ["*", 2, n], 2], ["rat", 8, 2], ["sqrt", ["rat", 16, 1]],
                                   ["*", 8, ["cospi", 1, 3]], ["*", 8, ["^", ["cospi", 1, 4], 2]]])
def test_an_integer_is_an_index_however_it_was_made(index):
    """Otherwise a value would be missing there of which it is proved that it exists."""
    assert is_true(said(["=", ["at", "U", index], 7], CONSTANT))
    assert is_true(said(["=", ["cospi", index, ["/", index, 1]], -1], CONSTANT))
    assert not is_true(said(["defined", ["at", "U", ["/", index, 3]]], CONSTANT))


def test_a_value_needs_no_earlier_one_that_its_term_does_not_have():
    """1/(t - 2) has no value at one place of a sequence, and has one afterwards."""
    gap = ["rec", "V", "t", 0, [1], ["/", 1, ["-", ["sym", "t"], 2]]]
    for at, there in ((2, True), (3, False), (4, True), (9, True)):
        made = said(["defined", ["at", "V", at]], gap)
        assert is_true(made) == there
        assert is_proved(made, [["exist", "V", at]]) == there
        assert is_proved({**made, "says": ["not", made["says"]]}, [["exist", "V", at]]) != there


def test_a_quotient_by_a_positive_integer_is_no_crash_of_the_search():
    made = {**said(["=>", [">", ["/", ["sym", "y"], ["+", n, 1]], 0], [">", ["sym", "y"], 0]]), "over": [["y", ["scalar"]]]}
    is_proved(made, [["valued", ""], ["clear"]])
