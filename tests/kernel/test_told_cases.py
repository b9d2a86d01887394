# SPDX-License-Identifier: MIT
"""Cases told of a proof at a generic index: they save searching, and whatever is told of them proves nothing that is false."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exactkf.claims import load
from exactkf.evidence import generic_index, lemma, use
from exactkf.finders.cases import with_cases
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import Statement, always, forall, rec, signal, sum_of, symbols
from exactkf.language.mutate import mutants
from tests.kernel.acceptance import is_accepted

g, t, k, n, x = symbols("g t k n x")
STEP = {"sizes": ["n"], "over": {"g": signal(0)}, "where": [rec(x, t, 1, x[t] + g[t])]}
TRUE = lemma(t, x[t] == 1 + sum_of(k, 0, t - 1, g[k]), uses=[use(0, t=t)])
FALSE = [
    forall(t, 0, n, x[t] == 1 + sum_of(k, 0, t, g[k])),
    forall(t, 0, n, x[t] == 1 + sum_of(k, 1, t - 1, g[k])),
    forall(t, 0, n, sum_of(k, 1, t - 1, g[k]) == sum_of(k, 0, t, g[k]) - g[0] - g[t]),
    always(t, x[t] == 1),
]


def made(says, cases):
    evidence = {**generic_index(TRUE, uses=[use(0, t=t)]).hints, "cases": cases}
    return seal("test", "generic index", Statement(says, **STEP).to_json(), evidence)


@pytest.mark.parametrize("id", ["BLM91-E2.6", "BLZ94-L3.3", "BLZ94-SA3", "D71-E3.40"])
def test_what_was_noted_replays(id):
    """A proof replays with its cases, which has the same denominators or fewer; neighbours do not, with the cases of the original."""
    claim = load()[id]
    statement, evidence = claim.statement.to_json(), next(e.hints for e in claim.by if e.kind == "generic index")
    plain = seal("test", "generic index", statement, evidence)
    told, denominators = with_cases(plain)
    assert told["evidence"]["cases"] and denominators is not None
    assert set(denominators) <= set(replay(plain))
    for mutant in mutants(statement)[:12]:
        changed = {**statement, "says": mutant.says}
        if not is_accepted(seal("test", "generic index", changed, evidence)):
            assert not is_accepted(seal("test", "generic index", changed, told["evidence"]))


def test_a_false_statement_has_no_cases():
    """A certificate that does not replay is handed back as it was."""
    certificate = made(FALSE[0], [])
    assert with_cases(certificate) == (certificate, None)


def test_cuts_may_be_anywhere():
    """What is shown in all parts is shown: a cut that nobody needs does no harm, nor does a list that ends too soon."""
    says = forall(t, 0, n, x[t] == 1 + sum_of(k, 0, t - 1, g[k]))
    assert is_accepted(made(says, []))
    assert is_accepted(made(says, [{"@": 1, "": -3}]))
    assert is_accepted(made(says, [{"nobody": 1, "": -3}]))


@pytest.mark.parametrize("cases", [
    [{}], [{"": 1}], [{"@": 0}], [{"@": True}], [{"@": "1"}], [{"@": 1.5}],  # no linear forms
    [{"#0": 1}], [{"@": 1, "#0": -1}],  # an index of a sum, of which a region has to know no more than its bounds
    [[7]], ["0"], [3], [[["0"]]],  # no uses
    [{"@": 1, "": -place} for place in range(40)],  # more cuts than there may be
])
def test_what_is_no_case_is_rejected(cases):
    """With one clear line, and no other error."""
    says = forall(t, 0, n, x[t] == 1 + sum_of(k, 0, t - 1, g[k]))
    with pytest.raises(Rejected):
        replay(made(says, cases))


FORMS = st.dictionaries(st.sampled_from(["", "@", "n", "t", "k", "row", "z", "@t", "#0", "#1"]), st.integers(-3, 3), min_size=1, max_size=3)


@given(st.sampled_from(FALSE), st.lists(FORMS | st.lists(st.integers(0, 1), max_size=2), max_size=12))
def test_no_cases_prove_what_is_false(says, cases):
    """Whatever is told."""
    assert not is_accepted(made(says, cases))


@pytest.mark.parametrize("says", FALSE)
@pytest.mark.parametrize("told", [[], [0], [0, 0]])
def test_fewer_equations_prove_no_more(says, told):
    """Uses left out, or listed twice, in every part."""
    assert not is_accepted(made(says, [told] * 30))
