# SPDX-License-Identifier: MIT
"""Names printed as the paper prints them, from claim() and repair() to the rows of verdict and mutants."""

from __future__ import annotations

import pytest

from exactkf import claims
from exactkf._errors import BadInput
from exactkf.claims import claim, repair
from exactkf.engine import mutate_claim, verify_claim
from exactkf.evidence import identity, instances
from exactkf.language import scalar, symbols

x, y = symbols("x y")
OVER, TEX = {x: scalar(), y: scalar()}, {x: r"\bar{\xi}"}


@pytest.fixture(autouse=True)
def _no_claim_stays(monkeypatch):
    monkeypatch.setattr(claims, "_REGISTRY", {})


def test_verdict_and_mutants_print_the_name():
    """A claim that holds is printed with the paper's name in its statement and in each mutant that has it."""
    made = claim("T-1", "square of a sum", (x + y)**2 == x**2 + 2*x*y + y**2, over=OVER, tex=TEX, by=[identity(), instances()])
    result, rows = verify_claim(made), mutate_claim(made)["rows"]
    assert result["verdict"] == "holds" and r"\bar{\xi}" in result["statement_latex"]
    assert rows and all(r"\bar{\xi}" in row["latex"] for row in rows if "x" in row["text"])


def test_a_repair_prints_the_name():
    """The corrected statement has names of its own."""
    fixed = repair("sign", "A sign was lost.", (x - y)**2 == x**2 - 2*x*y + y**2, over=OVER, tex={x: r"\hat{x}"}, by=[identity(), instances()])
    made = claim("T-2", "square", (x - y)**2 == x**2 + 2*x*y + y**2, over=OVER, tex=TEX, by=[instances()], repair=fixed)
    result = verify_claim(made)
    assert result["verdict"] == "fails" and r"\bar{\xi}" in result["statement_latex"]
    assert r"\hat{x}" in result["repair"]["statement_latex"] and any(r"\hat{x}" in row["latex"] for row in mutate_claim(made)["rows"])


def test_an_unknown_name_is_refused():
    """LaTeX for a name that the statement does not have is an error in one line."""
    for make in (lambda tex: claim("T-3", "equal", x == x, over={x: scalar()}, tex=tex, by=[identity()]),
                 lambda tex: repair(claims.REPAIR_KINDS[0], "Wrong.", x == x, over={x: scalar()}, tex=tex, by=[identity()])):
        with pytest.raises(BadInput, match="'tex'.*'w'"):
            make({"w": r"\omega"})
