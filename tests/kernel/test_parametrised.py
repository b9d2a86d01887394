# SPDX-License-Identifier: MIT
"""Identities in parameters that the statement does not have."""

from __future__ import annotations

import json

import pytest

from exactkf import engine
from exactkf.check import check_paths
from exactkf.engine import verify_statement
from exactkf.evidence import identity, instances
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import Statement, given, integer, let, rational, scalar, sum_of, symbols

x, y, c, s, t, k, pp = symbols("x y c s t k pp")
CIRCLE = {"over": {c: scalar(), s: scalar()}, "given": [given("on the circle", c**2 + s**2 == 1)]}
HALF_ANGLE = {c: (1 - t**2) / (1 + t**2), s: 2 * t / (1 + t**2)}
FACT = "every point of the circle but (-1, 0) has a rational parameter"


def _statement(says, **more):
    over = {key.tree[1]: kind for key, kind in CIRCLE["over"].items()}
    return Statement(says=says, over=over, given=CIRCLE["given"], **more)


def test_a_classical_fact_gives_steps_and_needs_instances():
    """With instances beside it the strength is `steps`, without them the statement stays open."""
    says = (1 - c) * (1 + c) == s**2
    proof = identity(given_by=HALF_ANGLE, using={t: scalar()}, fact=FACT)
    drawn = instances(made_by=HALF_ANGLE, using={t: scalar()})
    found = verify_statement(_statement(says), [proof, drawn])
    assert (found["verdict"], found["strength"]) == ("holds", "steps"), found["reason"]
    assert verify_statement(_statement(says), [proof])["strength"] != "proved"


def test_a_parameter_may_be_an_integer_with_a_range():
    """All its values are looked at."""
    says = (c - 1) * (c + 1) * c * s == 0
    made = {c: k, s: (1 - k) * (1 + k)}
    data = _statement(says).to_json()
    evidence = {"cases": [{}], "given_by": {key.tree[1]: _lists(v.tree) for key, v in made.items()},
                "covered_by": "the three points", "parameters": [["k", _lists(integer(-1, 1))]]}
    assert replay(seal("T-1", "identity", data, evidence)) == []
    with pytest.raises(Rejected):
        replay(seal("T-1", "identity", data, {**evidence, "parameters": [["k", _lists(integer(-1, 2))]]}))


def test_a_parametrisation_cannot_redefine_a_name():
    """Neither a definition of the statement nor one of its variables."""
    data = _statement(x == 0, where=[let(x, c**2 + s**2 - 1)]).to_json()
    evidence = {"cases": [{}], "given_by": {"x": 0}, "covered_by": "nothing"}
    with pytest.raises(Rejected, match="redefines"):
        replay(seal("T-1", "identity", data, evidence))
    with pytest.raises(Rejected, match="two things have one name"):
        replay(seal("T-1", "identity", data, {**evidence, "given_by": {}, "parameters": [["c", ["scalar"]]]}))


def test_a_parametrisation_may_bring_definitions_of_its_own():
    """They are not there for the statement, and take no name of it."""
    says = (1 - c) * (1 + c) == s**2
    made = identity(given_by={c: x, s: y}, using={t: scalar()}, where=[let(x, (1 - t**2) / (1 + t**2)), let(y, 2 * t / (1 + t**2))], fact=FACT)
    drawn = instances(made_by=HALF_ANGLE, using={t: scalar()})
    found = verify_statement(_statement(says), [made, drawn])
    assert (found["verdict"], found["strength"]) == ("holds", "steps"), found["reason"]
    evidence = {"cases": [{}], "given_by": {"c": ["sym", "x"]}, "covered_by": "nothing", "where": [["let", "x", [], 0]]}
    with pytest.raises(Rejected):  # x is no name of the statement
        replay(seal("T-1", "identity", {**_statement(c == 0).to_json(), "says": ["=", ["*", ["sym", "x"], ["sym", "c"]], 0]}, evidence))
    with pytest.raises(Rejected, match="two things have one name"):
        replay(seal("T-1", "identity", _statement(x * c == 0, where=[let(x, c)]).to_json(), evidence))
    with pytest.raises(Rejected, match="two things have one name"):
        replay(seal("T-1", "identity", _statement(s == 0).to_json(), {**evidence, "where": [["let", "s", [], 0]]}))


def test_what_a_parametrisation_rests_on_is_said(tmp_path, capsys):
    """The claim that it reaches everything is named, and that a proof by that name is there, which is all that the checker sees."""
    over = [["c", ["scalar"]], ["s", ["scalar"]]]
    made = {"sizes": [], "over": over, "where": [], "given": [["on the circle", ["=", ["^", ["sym", "c"], 2], 1], "needed"]], "says": ["=", ["sym", "c"], 1]}
    granted = seal("T-1", "identity", made, {"cases": [{}], "given_by": {"c": 1}, "covered_by": "T-2"})
    plain = seal("T-2", "identity", {**made, "given": [], "says": ["=", ["sym", "s"], ["sym", "s"]]}, {"cases": [{}]})
    (tmp_path / "a.json").write_text(json.dumps(granted))
    assert check_paths([tmp_path]) == 0
    assert "replays assuming T-2 for its parametrisation to reach everything\n1 of 1 certificates replay, 1 of them assuming" in capsys.readouterr().out
    (tmp_path / "b.json").write_text(json.dumps(plain))
    assert check_paths([tmp_path]) == 0
    assert "assuming T-2 (a proof by that name replays here) for" in capsys.readouterr().out


def test_a_parametrisation_is_worth_no_more_sizes_than_what_covers_it(monkeypatch):
    """Of a claim proved for p up to three: what rests on it is not proved for p = 4."""
    monkeypatch.setattr(engine, "_standing_of", lambda id: ("proved-sizes", {"pp": [1, 2, 3]}))
    says = sum_of(k, 1, pp, (1 - c) * (1 + c)) == sum_of(k, 1, pp, s**2)
    for sizes, strength in (((1, 2, 3), "proved-sizes"), ((1, 2, 3, 4), "instances")):
        proof = identity(given_by=HALF_ANGLE, using={t: scalar()}, covered_by="T-0", pp=sizes)
        drawn = instances(made_by=HALF_ANGLE, using={t: scalar()}, pp=(1, 2))
        found = verify_statement(_statement(says, sizes=["pp"]), [proof, drawn])
        assert (found["verdict"], found["strength"]) == ("holds", strength), found["evidence"]


def test_every_instances_evidence_is_searched():
    """A counterexample that only the second way of drawing reaches is found."""
    says = (c == 1) | (c != rational("3/5"))
    one = instances(made_by={c: 1 + 0 * t, s: 0 * t}, using={t: scalar()})
    other = instances(made_by={c: rational("3/5") + 0 * t, s: rational("4/5") + 0 * t}, using={t: scalar()})
    assert verify_statement(_statement(says), [one])["verdict"] != "fails"
    assert verify_statement(_statement(says), [one, other])["verdict"] == "fails"


def _lists(tree):
    return [_lists(part) for part in tree] if isinstance(tree, (list, tuple)) else tree
