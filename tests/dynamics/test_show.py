# SPDX-License-Identifier: MIT
"""What a person sees of answers, outcomes and statements outside the command line."""

from fractions import Fraction

import pytest
from click.testing import CliRunner

from exactkf import analyze, prove_lemma
from exactkf.cli import main
from exactkf.dynamics.filter import Filter
from exactkf.dynamics.pictures import draw_plane
from exactkf.language import Statement, T, matrix, symbols

FILTERS = [("3", "1/2"), ("-2", "sqrt(3)"), ("0,2", "1/2,1/3"), ("2", "-1/2")]


@pytest.mark.parametrize(("alpha", "gamma"), FILTERS)
def test_an_answer_prints_as_the_command_prints_it(alpha, gamma):
    answer = analyze(alpha=alpha.split(","), gamma=gamma.split(","))
    assert CliRunner().invoke(main, ["analyze", f"--alpha={alpha}", f"--gamma={gamma}"]).output == f"{answer}\n"


def test_an_answer_in_a_notebook():
    """The headline, then the derivation with its formulas, then the numbers."""
    answer = analyze(alpha=[3], gamma=["1/2"])
    first, empty, *facts = answer._repr_markdown_().split("\n")
    assert (first, empty) == ("**order 1: the orbit converges**", "")
    assert facts[:len(answer.facts)] == [f"- {fact.latex}" for fact in answer.facts] and "$" in facts[0]
    assert any(line.startswith("- Rate: $") for line in facts) and all(line.count("$") % 2 == 0 for line in facts)


def test_an_outcome_prints_lemma_and_verdict():
    printed = str(prove_lemma("sizes n\nmatrix A, B n n\nclaim A*B == B*A"))
    assert "claim A*B == B*A\n\nrefuted: " in printed and "A = [" in printed


def test_a_statement_in_a_notebook():
    n, P = symbols("n P")
    shown = Statement(T(T(P)) == P, over={P: matrix(n, n)}, sizes=[n])._repr_latex_()
    assert shown.startswith("$\\displaystyle ") and shown.endswith("$") and "= P" in shown and "n\\times n" in shown


def test_region_two_has_the_index_of_kappa():
    """An orbit stays in the plus or in the minus regions: II+ lies where alpha is negative, as kappa is positive there."""
    pytest.importorskip("matplotlib")
    figure = draw_plane(Filter.from_parameters(["1/3"], ["4/5"]))
    placed = {(t.get_text(), t.get_position()[0] > 0) for t in figure.axes[0].texts}
    assert {(r"$\mathrm{II}_+$", False), (r"$\mathrm{II}_-$", True), (r"$\mathrm{III}_+$", True), (r"$\mathrm{IV}_-$", False)} <= placed
    alpha, gamma = Fraction(-1, 2), Fraction(2)
    assert 2 * alpha / (1 + alpha**2 - gamma**2) > 0
