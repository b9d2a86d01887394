# SPDX-License-Identifier: MIT
"""A proof of a formula counts for the print as far as the formula says what is printed."""

import pytest

from exactkf import verify_statement
from exactkf._errors import BadInput
from exactkf.claims import Claim
from exactkf.describe import describe_claim
from exactkf.engine import verify_claim
from exactkf.evidence import identity, instances, part, restated, steps
from exactkf.language import Statement, T, matrix, scalar, symbols

n, P, Q, x = symbols("n P Q x")
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
