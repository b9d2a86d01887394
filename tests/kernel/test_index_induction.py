# SPDX-License-Identifier: MIT
"""Induction at a generic index: theorems of every size are proved, false neighbours and broken certificates are not."""

from __future__ import annotations

import copy
from fractions import Fraction
from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exactkf.claims import load
from exactkf.evidence import generic_index, lemma, use
from exactkf.finders.draw import Sampler
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.region import Region, _possible, form_key
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import (
    Statement,
    T,
    Z,
    always,
    coeff,
    forall,
    matrix,
    rec,
    scalar,
    sequence,
    signal,
    standing,
    sum_of,
    symbols,
    vector,
)
from exactkf.language.mutate import mutants
from tests.kernel.acceptance import is_accepted

g, t, k, n, x, y, p = symbols("g t k n x y p")
CLAIMS = ["BLM91-E2.6", "BLM91-E2.7", "BLM91-E2.21", "BLM91-E2.26", "BLM91-E2.27", "BLZ94-P3.1", "BLZ94-L3.3", "BLZ94-S12", "BLZ94-E3.15a", "BLZ94-E3.20",
          "BLZ94-EA.12", "BLZ94-SA3", "BLZ94-L4.2", "BLM91-E2.1", "BLM91-E2.18", "D71-E3.37", "D71-E3.40", "D71-E3.41",
          "BLZ94-EA.17", "BLZ94-SA8", "BLZ94-L4.4.1", "BLZ94-T3.2", "BLZ94-E4.10",
          "BLM91-S15", "BLM91-S18", "BLM91-S21", "BLM91-E2.11", "BLM91-E2.13", "BLM91-E3.4", "BLM91-E3.7"]


def proof(statement, evidence):
    return seal("test", "generic index", statement if isinstance(statement, dict) else statement.to_json(), evidence.hints)


def evidence_of(claim):
    return next(e for e in claim.by if e.kind == "generic index")


@pytest.mark.parametrize("id", CLAIMS)
def test_no_refuted_neighbour_is_proved(id):
    """A mutant that is false on an instance is not accepted with the proof of the original, nor is an empty proof of the original."""
    claim = load()[id]
    data, evidence = claim.statement.to_json(), evidence_of(claim)
    replay(proof(data, evidence))
    hints = next(e.hints for e in claim.by if e.kind == "instances")
    worlds = [world for _, world in zip(range(12), (w for _, w in Sampler(data, hints, [], 0).stream(40)), strict=False)]
    refuted = [m for m in mutants(data) if not m.drops and any(_false(w, m.says) for w in worlds)]
    accepted = [m.kind for m in refuted if is_accepted(proof({**data, "says": m.says}, evidence))]
    assert refuted and accepted == []


def _false(world: World, says) -> bool:
    try:
        return world.value(says) is False
    except (Undefined, Unknown):
        return False


@pytest.mark.parametrize("id", ["BLM91-E2.6", "BLZ94-L3.3", "BLZ94-E3.20"])
def test_every_lemma_is_needed_and_shown(id):
    """Without the uses of a lemma, or with a false lemma, the certificate is rejected."""
    claim = load()[id]
    whole = proof(claim.statement, evidence_of(claim)).copy()
    without = copy.deepcopy(whole["evidence"])
    without["uses"] = []
    with pytest.raises(Rejected):
        replay(seal("test", "generic index", whole["statement"], without))
    wrong = copy.deepcopy(whole["evidence"])
    wrong["lemmas"][1]["says"] = ["=", wrong["lemmas"][1]["says"][1], 2]
    with pytest.raises(Rejected, match="lemma 1, base"):
        replay(seal("test", "generic index", whole["statement"], wrong))


STEP = {"sizes": ["n"], "over": {"g": signal(0)}, "where": [rec(x, t, 1, x[t] + g[t])]}


def test_a_sum_with_a_moving_end_telescopes():
    """x_t = 1 + g_0 + .. + g_(t-1) for every t."""
    claim = Statement(forall(t, 0, n, x[t] == 1 + sum_of(k, 0, t - 1, g[k])), **STEP)
    says = lemma(t, x[t] == 1 + sum_of(k, 0, t - 1, g[k]), uses=[use(0, t=t)])
    assert replay(proof(claim, generic_index(says, uses=[use(0, t=t)]))) == []


@pytest.mark.parametrize("says", [
    forall(t, 0, n, x[t] == 1 + sum_of(k, 0, t, g[k])),
    forall(t, 0, n, x[t] == 1 + sum_of(k, 1, t - 1, g[k])),
    forall(t, 0, n, sum_of(k, 1, t - 1, g[k]) == sum_of(k, 0, t, g[k]) - g[0] - g[t]),  # false for t = 0, where the first sum is empty
    forall(t, 0, n, sum_of(k, 0, t, g[k] * g[k + 1]) == sum_of(k, 1, t, g[k] * g[k + 1])),
    always(t, x[t] == 1),
])
def test_what_is_false_is_rejected(says):
    """False statements about sums fail whatever true lemma they lean on."""
    true = lemma(t, x[t] == 1 + sum_of(k, 0, t - 1, g[k]), uses=[use(0, t=t)])
    with pytest.raises(Rejected):
        replay(proof(Statement(says, **STEP), generic_index(true, uses=[use(0, t=t)])))


def test_the_hypothesis_is_known_at_its_index_alone():
    """A step may not use what it shows at the next index, nor a later lemma."""
    claim = Statement(always(t, x[t] == 0), **STEP)
    for uses in ([use(0, t=t + 1)], [use(1, t=t)], [use(-1, t=t)]):
        with pytest.raises(Rejected):
            replay(proof(claim, generic_index(lemma(t, g[t] == 0, uses=uses), uses=[use(0, t=t)])))


def test_a_lemma_is_not_used_before_its_start():
    """What is known from t = 1 on says nothing at t = 0."""
    start = {"sizes": ["n"], "over": {"g": scalar()}, "where": [rec(x, t, g, 0 * x[t])]}
    later = lemma(t, x[t] == 0, start=1)
    assert replay(proof(Statement(forall(t, 1, n, x[t] == 0), **start), generic_index(later, uses=[use(0, t=t)]))) == []
    with pytest.raises(Rejected):
        replay(proof(Statement(forall(t, 0, n, x[t] == 0), **start), generic_index(later, uses=[use(0, t=t)])))


def test_exponents_are_shown_before_they_are_used():
    """A recursion that leaves 0 .. t is not taken for one that stays there."""
    wide = {"sizes": ["n"], "over": {"g": sequence(0, n - 1)}, "where": [rec(p, t, 1, Z * Z * p[t])]}
    with pytest.raises(Rejected, match="exponents of p"):
        replay(proof(Statement(forall(t, 0, n, coeff(p[t], t + 1) == 0), **wide), generic_index(supported=[p])))


def test_products_are_read_by_their_sizes():
    """A number times a column is no product of columns, and columns do not multiply."""
    columns = {"sizes": ["n"], "over": {"x": vector(n), "y": vector(n), "p": matrix(n, 1)}, "given": [standing("n >= 1", n >= 1)]}
    assert replay(proof(Statement(T(x) * y * p == p * (T(y) * x), **columns), generic_index())) == []
    with pytest.raises(Rejected, match="sizes do not fit"):
        replay(proof(Statement(x * y == y * x, **columns), generic_index()))
    with pytest.raises(Rejected):
        replay(proof(Statement(T(x) * y * p == T(x) * p * y, **columns), generic_index()))


def test_regions_decide_as_enumeration_does():
    """Of forms in two parameters a region says yes or no only where all its points say so."""
    forms = [{"k": 1}, {"t": 1, "k": -1}, {"t": 1, "": -2}]
    region = Region(forms)
    points = [(t, k) for t, k in product(range(-3, 12), repeat=2) if k >= 0 and t >= k and t >= 2]
    for a, b, c in product(range(-2, 3), repeat=3):
        form = {name: v for name, v in (("t", a), ("k", b), ("", c)) if v}
        values = {a * t + b * k + c >= 0 for t, k in points}
        answer = region.decide(form)
        assert answer is None or values == {answer}
        assert len(values) == 2 or answer is not None or a < 0 or b < 0 or (a, b) == (0, 0)


def test_a_forced_equation_is_solved():
    """k <= t and t <= k make k and t one parameter."""
    region = Region([{"t": 1, "k": -1}, {"t": -1, "k": 1}])
    assert region.reduce({"t": 1, "k": -1}) == {}


@given(st.lists(st.dictionaries(st.sampled_from(["", "t", "k", "n"]), st.integers(-3, 3), max_size=4), min_size=1, max_size=5))
def test_a_region_with_a_point_is_not_empty(forms):
    """Elimination keeps every point: of a grid of rational ones, none satisfies forms that are said to be impossible."""
    forms = [{name: c for name, c in f.items() if c} for f in forms]
    grid = [Fraction(v, 2) for v in (-12, -5, -2, -1, 0, 1, 2, 3, 7, 12)]
    inside = any(all(sum((c * {"": 1, "t": t_, "k": k_, "n": n_}[name] for name, c in f.items()), Fraction(0)) >= 0 for f in forms)
                 for t_, k_, n_ in product(grid, repeat=3))
    assert _possible(frozenset(map(form_key, forms))) or not inside


def test_a_product_that_vanishes_is_no_denominator():
    """x = 0 makes every product zero, so P(hi)/P(lo - 1) is not to be had by division: a value of 5 is refused."""
    from exactkf.language import prod

    m = symbols("m")[0]
    zero = {"sizes": ["n", "m"], "over": {"g": scalar()}, "where": [rec(x, t, 0, g * x[t])],
            "given": [standing("n >= 1", n >= 1), standing("m >= 1", m >= 1)]}
    vanishes = [lemma(t, x[t] == 0, uses=[use(0, t=t)]),
                lemma(t, prod(k, 1, t, x[k]) == 0, start=1, uses=[use(1, t=t), use(0, t=t + 1), use(0, t=t)])]
    with pytest.raises(Rejected):
        replay(proof(Statement(prod(k, n + 1, n + m, x[k]) == 5, **zero), generic_index(*vanishes, uses=[use(1, t=n), use(1, t=n + m)])))


def test_a_denominator_that_is_zero_where_the_numbers_are_one():
    """y_t = c for every t: 1 - y_t and y_t are not zero at one of two points each, so that their product is not zero; y_t - c and y_t - y_(t+1) are at all."""
    c = symbols("c")[0]
    over = {"sizes": ["n"], "over": {"c": scalar()}}
    for factor, fine in ((1 - y[t], True), (y[t], True), (y[t] - c, False), (y[t] - y[t + 1], False), (y[t] * y[t] - y[t], True)):
        where = [rec(y, t, c, y[t]), rec(x, t, 1, x[t] / factor)]
        statement = Statement(says=forall(t, 0, n, x[t + 1] * factor == x[t]), where=where, **over)
        assert is_accepted(proof(statement, generic_index())) is fine, factor
