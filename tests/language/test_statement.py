# SPDX-License-Identifier: MIT
"""Statements are plain data, kept as written, and refuse what they cannot mean."""

from __future__ import annotations

import json

import pytest
from hypothesis import given as given_
from hypothesis import strategies as st

from exactkf import BadInput
from exactkf.language import (
    OPERATIONS,
    Expr,
    Statement,
    Z,
    always,
    block,
    forall,
    given,
    integer,
    let,
    matrix,
    prints,
    rational,
    rec,
    scalar,
    sequence,
    sum_of,
    sym,
    symbols,
    to_expr,
)
from exactkf.language.mutate import mutants, rewritings

n, t, k, x, y, A, phi, gamma = symbols("n t k x y A phi gamma")

leaves = st.sampled_from([x, y, Z, A]) | st.integers(-5, 5).map(Expr)
terms = st.recursive(
    leaves,
    lambda inner: st.tuples(st.sampled_from(["+", "*", "-", "/", "="]), inner, inner).map(lambda p: Expr((p[0], p[1].tree, p[2].tree)))
    | inner.map(lambda e: Expr(("T", e.tree))) | st.tuples(inner, inner).map(lambda p: block([list(p)])) | inner.map(lambda e: sum_of(k, 0, 3, e + k)),
    max_leaves=12,
)


@given_(terms)
def test_json_round_trip(term):
    """What is written as JSON is read back as the same tree."""
    statement = Statement(over={"x": scalar(), "y": scalar(), "A": matrix(2, 2)}, says=term == 0)
    assert Statement.from_json(json.loads(json.dumps(statement.to_json()))).to_json() == statement.to_json()


@given_(terms)
def test_nothing_is_simplified(term):
    """x - x stays x - x: operators add one node each."""
    assert (term - term).tree == ("-", term.tree, term.tree)
    assert (term + 0).tree[-1] == 0


def test_products_keep_their_order():
    """A x A keeps its factors where they were written."""
    assert (A * x * A).tree == ("*", A.tree, x.tree, A.tree)
    assert (A * (x * A)).tree == ("*", A.tree, ("*", x.tree, A.tree))


@pytest.mark.parametrize("bad", [0.5, float("nan"), True, "x", None, 1j])
def test_inexact_things_are_no_terms(bad):
    """Floats, truth values and text are refused with the remedy."""
    with pytest.raises(BadInput, match="not exact|Fraction"):
        to_expr(bad)


def test_a_formula_has_no_truth_value():
    """`if a == b` on terms is a mistake that is caught."""
    with pytest.raises(TypeError, match="no truth value"):
        bool(x == y)


@pytest.mark.parametrize("text", ["1/0", "abc", "", "nan", "1e5e"])
def test_bad_rationals(text):
    """rational() names its argument."""
    with pytest.raises(BadInput, match="argument 'value'"):
        rational(text)


@pytest.mark.parametrize(("data", "message"), [
    ({}, "not a statement"),
    ({"sizes": [], "over": [], "where": [], "given": [], "says": ["frobnicate", 1]}, "unknown operation"),
    ({"sizes": [], "over": [], "where": [], "given": [], "says": ["=", ["sym", "q"], 1]}, "not declared"),
    ({"sizes": [], "over": [["q", ["torus"]]], "where": [], "given": [], "says": ["=", ["sym", "q"], 1]}, "unknown type"),
    ({"sizes": [], "over": [], "where": [], "given": [], "says": ["=", 1]}, "arguments"),
    ({"sizes": [], "over": [], "where": [], "given": [], "says": ["=", 1, 0.5]}, "not a term"),
    ({"sizes": [], "over": [], "where": [], "given": [], "says": ["=", 1, ["rat", 1, 0]]}, "second positive"),
    ({"sizes": [], "over": [], "where": [["eval", "x"]], "given": [], "says": ["=", 1, 1]}, "neither let nor rec"),
])
def test_bad_json_is_refused_in_one_line(data, message):
    """JSON that is no statement says why."""
    with pytest.raises(BadInput, match=message) as caught:
        Statement.from_json(data)
    assert "\n" not in str(caught.value)


def test_a_definition_may_not_change_its_body():
    """Two bodies for one name are refused."""
    with pytest.raises(BadInput, match="given twice"):
        Statement(where=[let(x, 1), let(x, 2)], says=x == 1)


def kinds(statement):
    return {m.kind for m in mutants(statement.to_json())}


def test_mutants_cover_the_ways_papers_go_wrong():
    """Every kind of wrong neighbour is made where the tree has room for it."""
    statement = Statement(
        sizes=["n"], over={"A": matrix(n, n), "x": scalar(), "gamma": sequence(0, n)}, given=[given("small", x < 1)],
        where=[rec(phi, t, 1, x * phi[t])],
        says=forall(k, 0, n, (A * Expr(("T", A.tree)) * x - gamma[k] + Expr(("inv", A.tree)) == phi[k + 1] * 2) & prints(x, "0.12") & (x < 2)))
    assert kinds(statement) >= {
        "sign flipped", "term dropped", "coefficient doubled", "index shifted", "factors exchanged", "transpose removed", "inverse removed",
        "relation reversed", "hypothesis 'small' dropped", "last digit changed", "factor two on one side",
    }


@given_(terms)
def test_no_mutant_is_the_original(term):
    """A mutant differs from the original, and no two are the same."""
    data = Statement(over={"x": scalar(), "y": scalar(), "A": matrix(2, 2)}, says=term == x).to_json()
    made = [json.dumps(m.says) for m in mutants(data)]
    assert len(set(made)) == len(made)
    assert json.dumps(data["says"]) not in made


def test_rewritings_rename_everywhere():
    """Renaming reaches definitions, hypotheses and the conclusion."""
    statement = Statement(over={"x": scalar()}, where=[rec(phi, t, x, phi[t] + x)], given=[given("g", x > 0)], says=always(t, phi[t] >= x))
    renamed = dict(rewritings(statement.to_json()))["symbols renamed"]
    text = json.dumps(renamed)
    assert '"x_renamed"' in text and '"phi_renamed"' in text and '"x"' not in text and '"phi"' not in text
    Statement.from_json(renamed)


def test_operations_have_a_meaning():
    """Every operation of the language is known to the evaluator, and the other way round."""
    from exactkf.kernel.meaning import _PLAIN, _SPECIAL

    assert set(OPERATIONS) == set(_PLAIN) | set(_SPECIAL)


def test_names_are_identifiers():
    """A name with a blank is refused."""
    with pytest.raises(BadInput, match="identifier"):
        sym("a b")


def test_integer_type_takes_two_bounds():
    """A type with the wrong number of arguments is refused."""
    with pytest.raises(BadInput, match="takes 2"):
        integer(3)
