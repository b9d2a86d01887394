# SPDX-License-Identifier: MIT
"""Claims and statements of one's own: what is wrong with them is said in one line."""

import pytest

import exactkf
from exactkf import BadInput, prove_lemma, verify_claim, verify_statement
from exactkf.claims import checked_evidence, load
from exactkf.engine import mutate_claim
from exactkf.evidence import identity, induction, instances
from exactkf.kernel.instances import read_instance
from exactkf.kernel.meaning import World
from exactkf.language import Statement, T, integer, matrix, symbols

n, k, P, Q = symbols("n k P Q")
SQUARE = {P: matrix(n, n), Q: matrix(n, n)}
TRANSPOSE = Statement(T(P * Q) == T(Q) * T(P), over=SQUARE, sizes=[n])


@pytest.mark.parametrize(("parts", "words"), [
    ({"says": T(P) == Q, "over": SQUARE}, "name 'n' is not declared"),
    ({"says": T(P) == Q, "over": {P: matrix(n, n)}, "sizes": [n]}, "name 'Q' is not declared"),
    ({"says": T(P) == Q, "over": SQUARE, "sizes": [n, n]}, "name 'n' is declared 2 times"),
    ({"says": T(P) == P, "over": {n: integer(0, 3), P: matrix(n, n)}, "sizes": [n]}, "name 'n' is declared 2 times"),
    ({"says": P * Q, "over": SQUARE, "sizes": [n]}, "the conclusion is the term P*Q"),
    ({"says": T(P) == Q, "over": SQUARE, "sizes": [n], "given": {"one": P + Q}}, "hypothesis 'one' is the term P + Q"),
    ({"says": T(P) == Q, "over": {P: "matrix"}, "sizes": [n]}, "'matrix' in place of a type"),
    ({"says": T(P) == Q, "over": {3: matrix(n, n)}, "sizes": [n]}, "3 is no name"),
])
def test_a_statement_that_is_none(parts, words):
    with pytest.raises(BadInput) as caught:
        Statement(**parts)
    assert words in str(caught.value) and "\n" not in str(caught.value)


def test_names_of_a_statement_are_texts_or_symbols():
    """And of variables put together from groups the last type counts."""
    texts = Statement(T(P * Q) == T(Q) * T(P), over={"P": matrix(n, n), "Q": matrix(n, n)}, sizes=["n"], tex={P: "\\Pi"})
    assert texts.to_json() == TRANSPOSE.to_json() and texts.tex == {"P": "\\Pi"}
    (other,) = symbols("P")
    assert Statement(P == P, over={P: matrix(n, 1), other: matrix(n, n)}, sizes=[n]).over == (("P", matrix(n, n)),)


@pytest.mark.parametrize(("by", "words"), [
    ([], "no values of size 'n' for instances"),
    (identity(), "no values of size 'n' for identity"),
    ([identity(n=2), instances(3)], "no values of size 'n' for instances"),
    (instances(m=1), "instances gives values to 'm', which is no size of the statement; its sizes are: n"),
    ("identity", "'identity', which is no evidence"),
    (None, "None, which is no evidence"),
])
def test_evidence_that_does_not_fit(by, words):
    with pytest.raises(BadInput) as caught:
        verify_statement(TRANSPOSE, by)
    assert words in str(caught.value) and "\n" not in str(caught.value)


def test_evidence_that_fits():
    """One piece or several; the values of integer variables; an induction for every size names none."""
    assert verify_statement(TRANSPOSE, identity(n=(1, 2)))["verdict"] == "holds"
    whole = Statement(P == P, over={P: matrix(n, n), k: integer(0, 2)}, sizes=[n])
    assert [e.kind for e in checked_evidence(whole, [identity(n=2, k=(0, 1)), induction()])] == ["identity", "induction"]


@pytest.mark.parametrize(("make", "words"), [
    (lambda: instances(n=1.5), "'n' = 1.5"), (lambda: instances(n="2"), "'n' = '2'"), (lambda: identity(n=()), "'n' = ()"),
    (lambda: identity(n=(1, True)), "'n' = (1, True)"), (lambda: instances(0, n=1), "'count' = 0"), (lambda: instances(2.5, n=1), "'count' = 2.5"),
    (lambda: instances(n=1, horizon=0), "'horizon' = 0"), (lambda: verify_statement("A == B", instances()), "pass a Statement, or use prove_lemma"),
    (lambda: verify_statement(TRANSPOSE, identity(n=1), seed=-1), "'seed' = -1"), (lambda: prove_lemma(TRANSPOSE, seed=1.5), "'seed' = 1.5"),
    (lambda: verify_claim(None), "'claim' = None"), (lambda: verify_claim("NOPE-1"), "'NOPE-1'"), (lambda: verify_claim("B93"), "names"),
])
def test_calls_that_are_wrong(make, words):
    with pytest.raises(BadInput) as caught:
        make()
    assert words in str(caught.value) and "\n" not in str(caught.value)


def test_a_claim_is_found_by_its_id():
    result = verify_claim("B93-S23")
    assert (result["id"], result["verdict"], result["strength"]) == ("B93-S23", "holds", "proved")


def test_help_knows_what_is_loaded_late():
    assert set(exactkf.__all__) <= set(dir(exactkf))


def test_a_term_is_no_sequence_and_a_formula_no_truth_value():
    """An index is an entry, so that a loop over a term would not end."""
    with pytest.raises(TypeError, match="not iterable"):
        list(P)
    with pytest.raises(TypeError, match="write & for 'and'"):
        bool(P == Q)


CLAIM = "claim('AAA-E9', 'x', a + b == b + {right}, over={{a: scalar(), b: scalar()}}, by=[{by}])\n"


@pytest.mark.parametrize(("text", "words"), [
    (CLAIM.format(right="c", by="instances()"), "line 18: NameError: name 'c' is not defined"),
    (CLAIM.format(right="P", by="instances()"), "line 18: claim 'AAA-E9': name 'P' is not declared"),
    (CLAIM.format(right="a", by="instances(n=1)"), "line 18: claim 'AAA-E9': argument 'by': instances gives values to 'n'"),
    (CLAIM.format(right="a", by="instances()") * 2, "line 19: claim 'AAA-E9': claim id 'AAA-E9' is registered twice, in section_1;"),
    (CLAIM.format(right="a", by="instances()").replace("claim(", "claim(("), "line 18: "),
    ("import nowhere_at_all\n", "line 18: ModuleNotFoundError: No module named 'nowhere_at_all'"),
], ids=["unknown name", "undeclared name", "strange size", "written twice", "syntax", "import"])
def test_a_module_of_claims_with_a_fault(paper, text, words):
    """Module, line and fault; nothing runs."""
    p = paper("ok")
    module = p.root / "fake_proofs" / "aaa" / "section_1.py"
    module.write_text(module.read_text() + text)
    done = p.run("verify")
    assert done.exit_code == 2 and done.stdout == "" and done.stderr.count("\n") == 1, done.output
    assert "module 'fake_proofs.aaa.section_1' cannot be imported: " + words in done.stderr
    assert p.calls() == []


def test_claims_come_in_the_order_of_reading():
    """Introduction and sections by number, then appendices and what the papers do not say, whoever imports whom."""
    places = list(dict.fromkeys((c.paper, c.section) for c in load().values()))
    assert len(places) > 40 and len(set(places)) == len(places), "the claims of a section stand together"
    for paper in dict.fromkeys(p for p, _ in places):
        sections = [section for p, section in places if p == paper]
        numbered = [s for s in sections if s.startswith("section")]
        first = [s for s in sections if s.startswith("introduction")]
        assert sections[:len(first) + len(numbered)] == first + sorted(numbered)
    assert places[0] == ("B93", "introduction") and [s for p, s in places if p == "BLM91"][-1].startswith("consequences")


def test_a_mutant_is_rejected_by_an_instance_that_is_shown():
    """Each row has the instance on which the mutant is false, and the original is true there."""
    claim = load()["BLZ94-E2.12"]
    rows = mutate_claim(claim)["rows"]
    rejected = [row for row in rows if row["outcome"] == "rejected"]
    assert rejected and all(row["instance"]["sizes"] for row in rejected)
    world = World(claim.statement.to_json(), read_instance(claim.statement.to_json(), rejected[0]["instance"]))
    assert world.value(claim.statement.to_json()["says"]) is True
