# SPDX-License-Identifier: MIT
"""A proof of a formula counts for the print as far as the formula says what is printed."""

import pytest

from exactkf import verify_statement
from exactkf._errors import BadInput
from exactkf.claims import Claim, Repair
from exactkf.describe import describe_claim
from exactkf.engine import _standing_of, verify_claim
from exactkf.evidence import combination, evaluation, example, identity, instances, part, restated, steps
from exactkf.language import Identity, Statement, T, det, eq, matrix, scalar, standing, sum_of, symbols

n, m, k, P, Q, x = symbols("n m k P Q x")
REVERSED = Statement(T(P * Q) == T(Q) * T(P), over={P: matrix(n, n), Q: matrix(n, n)}, sizes=[n])
IN_ORDER = Statement(T(P * Q) == T(P) * T(Q), over={P: matrix(n, n), Q: matrix(n, n)}, sizes=[n])


@pytest.mark.parametrize(("bounds", "strength"), [([], "proved"), ([restated("a fact")], "steps"), ([part("two matrices")], "instances"),
                                                  ([part("two matrices"), restated("a fact")], "instances")])
def test_the_bound_holds_whatever_is_proved(bounds, strength):
    """A restatement is worth its steps, a part its instances."""
    result = verify_statement(REVERSED, [*bounds, identity(n=(1, 2)), instances(n=(1, 2))])
    assert (result["verdict"], result["strength"]) == ("holds", strength)
    assert all(any(text in line for line in result["evidence"]) for e in bounds for text in e.hints.get("facts", (e.hints.get("covers"),)))


def test_a_part_that_is_false_refutes_the_whole():
    """The bound is one of strength, not of the verdict."""
    assert verify_statement(IN_ORDER, [part("two matrices"), instances(n=(1, 2))])["verdict"] == "fails"


def test_no_steps_rest_on_a_part(monkeypatch):
    """A claim of a part is no displayed step that is proved."""
    some = instances(n=(1, 2))
    claims = {"X-1": Claim("X-1", "", "", REVERSED, (part("two matrices"), some)), "X-2": Claim("X-2", "", "", REVERSED, (some,))}
    monkeypatch.setattr("exactkf.engine.load", lambda: claims)
    unproved = Statement(x**4 - x + 1 > 0, over={x: scalar()})
    found = {id: verify_claim(Claim("X-3", "", "", unproved, (steps(id), instances())))["strength"] for id in claims}
    assert found == {"X-1": "instances", "X-2": "steps"}


@pytest.mark.parametrize("make", [lambda: part(""), lambda: part(3), lambda: restated(), lambda: restated("a fact", " ")])
def test_a_bound_without_words_is_refused(make):
    """The reader is told which part, or which fact."""
    with pytest.raises(BadInput, match="say it in words"):
        make()


@pytest.mark.parametrize(("bounds", "first"), [([], "as printed"), ([restated("a fact")], "checked: what"), ([steps(facts=["a fact"])], "checked: what"),
                                               ([part("two matrices"), restated("a fact")], "checked: a part")])
def test_the_formula_is_headed_as_what_it_is(bounds, first):
    """Only what needs no fact to be read as the print is shown as printed."""
    claim = Claim("X-1", "", "", REVERSED, (*bounds, instances(n=(1, 2))))
    assert describe_claim(claim, verify_claim(claim)).splitlines()[3].startswith(first)


@pytest.fixture
def registry(monkeypatch):
    """Claims by id, in the place of those of the papers."""
    claims: dict[str, Claim] = {}
    monkeypatch.setattr("exactkf.engine.load", lambda: claims)
    _standing_of.cache_clear()
    yield claims
    _standing_of.cache_clear()


#: x^n = 1 for the only real number with x^3 = 1
POWERS = Statement(x**n == 1, over={x: scalar()}, sizes=[n], given=[standing("x is a cube root of one", x**3 == 1)])
THE_ROOT = (identity(given_by={x: 1}, covered_by="X-1", n=(1, 2, 3, 4)), example({"x": "1", "n": 1}), instances(n=(1, 2)))


@pytest.mark.parametrize(("statement", "by", "strength"), [
    (Statement((x - 1)**2 == x**2 - 2*x + 1, over={x: scalar()}), (identity(),), "proved-sizes"),
    (Statement((x - 1)**2 == x**2 - 2*x + 1, over={x: scalar()}), (identity(), part("one")), "instances"),
    (Statement((x - 1)**2 == x**2 - 2*x + 1, over={x: scalar()}), (identity(), restated("a fact")), "instances"),
    (Statement(x**n == x * x**(n - 1), over={x: scalar()}, sizes=[n]), (identity(n=(1, 2, 3, 4)),), "proved-sizes"),
    (Statement(x**n == x * x**(n - 1), over={x: scalar()}, sizes=[n]), (identity(n=(1, 2, 3)),), "instances"),
    (Statement(x**m == x * x**(m - 1), over={x: scalar()}, sizes=[m]), (identity(m=(1,)),), "instances"),
])
def test_a_parametrisation_is_worth_no_more_than_what_covers_it(registry, statement, by, strength):
    """What covers it is proved as printed, for all the sizes, also if it calls them by other names."""
    registry["X-1"] = Claim("X-1", "", "", statement, by)
    result = verify_claim(Claim("X-2", "", "", POWERS, THE_ROOT))
    assert (result["verdict"], result["strength"]) == ("holds", strength), result["evidence"]


def test_steps_name_the_facts_that_they_rest_on(registry):
    """Those by which a step says what is printed, too."""
    registry["X-1"] = Claim("X-1", "", "", REVERSED, (restated("the first fact", "the second"), instances(n=(1, 2))))
    unproved = Statement(x**4 - x + 1 > 0, over={x: scalar()})
    result = verify_claim(Claim("X-3", "", "", unproved, (steps("X-1", facts=["the second", "the third"]), instances())))
    assert result["strength"] == "steps"
    assert "displayed steps X-1 proved; classical facts: the second; the third; the first fact" in result["evidence"]


def test_the_correction_of_a_part_is_one_of_a_part():
    """The rest of what is printed has not been looked at."""
    right = Repair("order of factors", "they are turned round", REVERSED, (instances(n=(1, 2)),))
    for by, strength in (((part("two matrices"),), "instances"), ((restated("a fact"),), "steps"), ((), "proved")):
        result = verify_claim(Claim("X-4", "", "", IN_ORDER, (*by, instances(n=(1, 2))), right))
        assert (result["verdict"], result["repair"]["verdict"], result["repair"]["strength"]) == ("fails", "holds", strength)


def test_what_nothing_satisfies_is_vacuous(registry):
    """Also without variables: it is open, and no step."""
    false = Statement(det(Identity(2)) == 2, given=[standing("h", det(Identity(2)) == 2)])
    true = Statement(eq(sum_of(k, 1, 3, k), 6))
    registry |= {"X-1": Claim("X-1", "", "", false, (combination([(1, "h", 1)]),)), "X-2": Claim("X-2", "", "", true, (evaluation(),))}
    result = verify_claim(registry["X-1"])
    assert (result["verdict"], result["reason"]) == ("open", "vacuous: no instance satisfies the hypotheses")
    assert [_standing_of(id)[0] for id in registry] == [None, "proved"]
