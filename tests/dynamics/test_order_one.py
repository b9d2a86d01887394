# SPDX-License-Identifier: MIT
"""Decisions of order one against exact stepping, and against double precision."""

from __future__ import annotations

import json
from math import gcd
from random import Random

import pytest
from flint import arb, fmpq

from exactkf._errors import BadInput
from exactkf.dynamics import decide_many, decide_order_one, decide_riccati_one
from exactkf.dynamics.exact_json import number_latex, number_words
from exactkf.dynamics.examples import EXAMPLES, verdict_of_doubles
from exactkf.dynamics.rotation import rational_periods, rotation_order, zero_index
from exactkf.exact import cyclotomic_real, precision, sqrt_field
from tests.dynamics.brute import Limit, filter_agrees, first_return, riccati_agrees, riccati_orbit
from tests.dynamics.starts import DEGENERATE, algebraic_start, before, element, on_hyperbola, rational_start, small

STEPS = 14  # rational periods are at most 6, the escapes made on purpose at most 9


# ---------------------------------------------------------------------- against stepping
@pytest.mark.parametrize("seed", range(4))
def test_ten_thousand_rational_starts(seed):
    """The decision is what exact stepping shows, on 2,500 rational starts for each of four seeds."""
    random = Random(seed)
    for _ in range(2500):
        start = rational_start(random)
        filter_agrees(decide_order_one(*start), *start, STEPS)


def test_degenerate_starts():
    """Zeros, ones, boundary lines, equilibria and the point at infinity of kappa."""
    for alpha, gamma in DEGENERATE:
        filter_agrees(decide_order_one(alpha, gamma), alpha, gamma, STEPS)
        for pi in {fmpq(0), fmpq(1), gamma * gamma, 1 - alpha, 1 + alpha, fmpq(1, 2)}:
            riccati_agrees(decide_riccati_one(alpha, gamma, pi), alpha, gamma, pi, STEPS)


@pytest.mark.parametrize("seed", range(2))
def test_five_hundred_algebraic_starts(seed):
    """The same on 250 starts in quadratic, cubic, quartic and cyclotomic fields for each of two seeds."""
    random = Random(100 + seed)
    for _ in range(250):
        start = algebraic_start(random)
        filter_agrees(decide_order_one(*start), *start, 24)


def test_two_thousand_riccati_starts():
    """The same for the Riccati equation from any start."""
    random = Random(7)
    for _ in range(2000):
        alpha, gamma = rational_start(random)
        pi = random.choice([fmpq(0), small(random), 1 - alpha / 2, gamma * gamma, 1 - alpha * small(random), fmpq(random.randint(-10**9, 10**9), 10**9)])
        riccati_agrees(decide_riccati_one(alpha, gamma, pi), alpha, gamma, pi, STEPS)


def test_algebraic_riccati_starts():
    """The same in number fields."""
    random = Random(8)
    for _ in range(100):
        alpha, gamma = algebraic_start(random)
        pi = random.choice([alpha.field(0), element(random, alpha.field), gamma * gamma, 1 - alpha * fmpq(2, 3)])
        riccati_agrees(decide_riccati_one(alpha, gamma, pi), alpha, gamma, pi, 24)


def test_riccati_from_zero_is_the_filter():
    """From pi = 0 the Riccati equation escapes one step after the filter (BLM91 (4.9))."""
    random = Random(9)
    for _ in range(300):
        alpha, gamma = rational_start(random)
        if alpha == 0 or gamma == 0:
            continue
        f, r = decide_order_one(alpha, gamma), decide_riccati_one(alpha, gamma, 0)
        assert r.behaviour == f.behaviour
        assert r.escape == (None if f.escape is None else f.escape + 1)
        assert r.rate == f.rate


# ---------------------------------------------------------------------- periods
def test_every_rational_multiple_of_pi_is_recognised():
    """2 cos(2 pi k/n) has order n for all coprime k and n up to 60, and a sixteenth of it has none unless it is zero."""
    for n in range(1, 61):
        field = cyclotomic_real(n)
        for k in (k for k in range(1, n // 2 + 2) if gcd(k, n) == 1):
            assert rotation_order(field.two_cos(k)) == n
        assert rotation_order(field.gen() / 16) == (4 if field.gen() == 0 else None)


@pytest.mark.parametrize("n", [5, 7, 8, 12, 18, 30])
def test_periods_of_both_equations(n):
    """The filter has period n, the Riccati equation n or n/2, and the one step exactly before does not return."""
    field = cyclotomic_real(n)
    for k in (k for k in range(1, n // 2) if gcd(k, n) == 1):
        alpha, gamma = on_hyperbola(-field.two_cos(k) / 2, field(fmpq(1, 3)))
        assert decide_order_one(alpha, gamma).period == n
        half = n if n % 2 else n // 2
        pi = fmpq(2, 7)
        assert decide_riccati_one(alpha, gamma, pi).period == half
        assert first_return(riccati_orbit(alpha, gamma, field(pi), half)[0]) == half


def test_rational_periods():
    """Rational data have the periods 1, 3, 4, 6 (filter) and 1, 2, 3 (Riccati equation), each of which occurs."""
    starts = [("1/2", "0"), ("-5/3", "-7/3"), ("3/4", "5/4"), ("5/3", "7/3")]
    assert rational_periods() == (tuple(decide_order_one(*s).period for s in starts),
                                  tuple(sorted({decide_riccati_one(*s).period for s in starts})))
    random, seen = Random(11), set()
    for _ in range(400):
        c = fmpq(random.randint(-8, 8), random.randint(1, 8))
        start = on_hyperbola(c, small(random))
        if start and c * c < 1:
            seen.add(decide_order_one(*start).period)
    assert seen == {None, 3, 4, 6}


# ---------------------------------------------------------------------- escapes
@pytest.mark.parametrize("t", [0, 1, 7, 40, 300])
def test_escape_after_many_steps(t):
    """A state that is t steps before gamma^2 = 1 escapes at t; one next to it never does, on every kind of curve."""
    for alpha in (fmpq(7, 2), fmpq(-13, 4), fmpq(2), fmpq(1, 3), sqrt_field(2).gen() / 3 if t < 50 else fmpq(1, 7)):
        start = before(alpha, alpha - alpha + 1, t)
        assert decide_order_one(*start).escape == t
        moved = decide_order_one(start[0], start[1] + fmpq(1, 10**400))
        assert moved.never_escapes


@pytest.mark.parametrize("n", [5, 7, 8, 12, 15, 22])
def test_escapes_on_a_periodic_curve(n):
    """On a hyperbola of period n, with d = n or n/2 that of alpha, two points escape at each of 0, ..., d - 3; one step before is (0, +-1), an escape at 0."""
    field = cyclotomic_real(n)
    c, d = -field.gen() / 2, n if n % 2 else n // 2
    for t in range(d - 2):
        alpha, gamma = before(2 * c, field(1), t)
        assert 1 + alpha * alpha - gamma * gamma == 2 * c * alpha
        assert decide_order_one(alpha, gamma).escape == decide_order_one(alpha, -gamma).escape == t
    assert before(2 * c, field(1), d - 2) is None


def test_zero_indices_of_a_rotation():
    """A zero that the recursion reaches at a given index is found there, and only there."""
    x, field = fmpq(3, 5), sqrt_field(2)
    for x in (fmpq(3, 5), field.gen() / 3):
        s, before_ = x, x - x + 1
        for t in range(3, 40):
            s, before_ = x * s - before_, s  # S_{t-1}, S_{t-2}
            assert zero_index(x, s / before_) == t


def test_last_change_of_signs_far_out():
    """Close to the unstable equilibrium and to kappa = 1 the orbit changes its sign where an enclosure at 600 bits has it."""
    for alpha, gamma in [(1 + fmpq(1, 10**5), fmpq(1, 10**12)), (1 + fmpq(1, 10**25), fmpq(1, 10**60)), (-1 - fmpq(1, 10**15), fmpq(1, 10**16))]:
        m = decide_order_one(alpha, gamma).monotone_from
        assert m > 10**5
        c = (1 + alpha * alpha - gamma * gamma) / (2 * alpha)
        s = 1 if c > 0 else -1
        with precision(600):  # s^(t-1) y_t is proportional to sinh(t h) - s alpha sinh((t - 1) h), cosh(h) = |c|
            h = arb(s * c).acosh()
            signs = [((h * t).sinh() - arb(s * alpha) * (h * (t - 1)).sinh()) > 0 for t in (m - 1, m, m + 1)]
        assert signs == [True, True, False]


# ---------------------------------------------------------------------- double precision
@pytest.mark.parametrize("example", EXAMPLES, ids=lambda e: e.name)
def test_doubles_go_wrong(example):
    """Doubles say what is on record, and it is not what is true."""
    answer = decide_order_one(example.alpha0, example.gamma0)
    assert verdict_of_doubles(example.alpha0, example.gamma0) == example.doubles
    assert answer.behaviour == example.behaviour
    wrong = example.doubles.split()[0]
    if wrong == "converges" and answer.behaviour == "converges":
        assert Limit(answer.limit["alpha"][0]).side(fmpq(2)) > 0
    else:
        assert {"converges": "converges", "escapes": "escapes", "period": "periodic", "wanders": "dense"}[wrong] != answer.behaviour


def test_doubles_are_right_where_nothing_is_delicate():
    """The impression from doubles is right on plain orbits, so that it is a fair opponent."""
    assert verdict_of_doubles("1/5", "1/2") == "converges to 0.271878"
    assert verdict_of_doubles("3/4", "5/4") == "period 4"
    assert verdict_of_doubles("1/3", "4/5") == "wanders"
    assert verdict_of_doubles("2", "1") == "escapes at 0"


# ---------------------------------------------------------------------- the answer
def test_answer_in_words_json_and_latex():
    """Every kind of answer has sentences in both forms, and JSON that reads back to itself."""
    r = sqrt_field(2).gen()
    starts = [("1/5", "1/2"), (2, "1/2"), ("5/2", 1), ("3/4", "5/4"), (0, 2), (0, 1), (3, 0), (3, 2), ("1/3", "4/5"), (r, r / 3),
              ("1/2", "1/3", "9/10"), (0, 2, 3)]
    for start in starts:
        answer = decide_order_one(*start) if len(start) == 2 else decide_riccati_one(*start)
        assert json.loads(json.dumps(answer.to_json())) == answer.to_json()
        assert answer.words().count("\n") == len(answer.facts) - 1 and all(f.words.endswith(".") for f in answer.facts)
        latex = answer.latex()
        assert all(f"\\item {fact.latex}\n" in latex for fact in answer.facts) and latex.count("$") % 2 == 0
        assert all(line.count("$") % 2 == 0 and line.count("{") == line.count("}") for line in latex.splitlines())


def test_numbers_as_text():
    """Elements of a field and polynomials read as one writes them."""
    x = cyclotomic_real(7).gen()
    assert [number_words(v) for v in (-x, 2 - x * x, x * x / 3 - 11 * x / 2, x - 1 - x)] == ["-theta", "-theta^2 + 2", "1/3*theta^2 - 11/2*theta", "-1"]
    assert [number_latex(v) for v in (-x, 2 - x, fmpq(-3, 2))] == [r"-\vartheta", r"-\vartheta+2", r"-\frac{3}{2}"]
    assert "x^3 + x^2 - 2*x - 1 in" in decide_order_one(x, 1).words()


@pytest.mark.parametrize(("call", "words"), [
    (lambda: decide_order_one(0.5, 1), "argument 'alpha0' is a float: 0.5"),
    (lambda: decide_order_one(1, "x"), "argument 'gamma0' is not a rational number: 'x'"),
    (lambda: decide_order_one(sqrt_field(2).gen(), sqrt_field(3).gen()), "gamma0 = sqrt(3) is in Q(sqrt(3))"),
    (lambda: decide_riccati_one(1, 2, None), "argument 'pi0' is not a rational number: None"),
    (lambda: decide_many([(1, 2)], jobs=0), "argument 'jobs' is not an integer of at least 1: 0"),
])
def test_bad_input(call, words):
    """One line that names the argument."""
    with pytest.raises(BadInput) as caught:
        call()
    assert words in str(caught.value) and "\n" not in str(caught.value)
