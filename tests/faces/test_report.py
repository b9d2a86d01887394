# SPDX-License-Identifier: MIT
"""The page: self-contained, complete, escaped."""

from html.parser import HTMLParser

from exactkf.claims import load
from exactkf.language.latex import given_latex, over_latex, says_lines, where_latex
from exactkf.report.mathml import formula
from exactkf.report.page import _linked

VOID = {"meta", "link", "input", "br", "mspace"}


class Checker(HTMLParser):
    """Collects ids and references; complains about elements that are not closed in order."""

    def __init__(self):
        super().__init__()
        self.open, self.ids, self.links = [], [], []

    def handle_starttag(self, tag, attrs):
        if tag not in VOID:
            self.open.append(tag)
        for name, value in attrs:
            if name == "id":
                self.ids.append(value)
            if name in ("href", "src"):
                self.links.append(value)

    def handle_startendtag(self, tag, attrs):
        pass

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


def test_page(paper):
    p = paper("ok", "raise")
    done = p.run("report", "-o", "page.html", "--jobs", "1")
    assert done.exit_code == 0, done.output
    page = (p.root / "page.html").read_text(encoding="utf-8")
    checker = Checker()
    checker.feed(page)
    assert checker.open == [] and len(set(checker.ids)) == len(checker.ids)
    assert "http" not in page
    assert all(link.startswith("#") or link == "data:," for link in checker.links)
    assert {link[1:] for link in checker.links if link != "data:,"} <= set(checker.ids)
    assert {"AAA-E1", "AAA-E2", "AAA-E3", "BBB-ok", "BBB-raise"} <= set(checker.ids)
    assert "The first section" in page and "Its mathematics, in a paragraph." in page and "Paper aaa, 1991" in page
    assert "positive &lt;a&gt;" in page and "&lt;2&gt;" in page
    assert "crashed: ValueError: no way" in page
    assert page.index('id="AAA-E1"') < page.index('id="AAA-E2"') < page.index('id="BBB-ok"')

    # nothing ran twice, and what is kept can be shown without running
    kept = p.run("report", "-o", "kept.html", "--kept")
    assert kept.exit_code == 0 and (p.root / "kept.html").read_text(encoding="utf-8") == page
    assert len(p.calls()) == 5


def test_what_was_not_run_is_open(paper):
    p = paper("ok")
    assert p.run("report", "--kept", "-o", "page.html").exit_code == 0
    page = (p.root / "page.html").read_text(encoding="utf-8")
    assert page.count("not run; ") == 4 and 'data-verdict="holds"' not in page
    assert p.calls() == []


def test_formula():
    assert "xmlns" not in formula("x") and "<mo>⪰</mo>" in formula(r"P \succeq 0")
    assert "′" in formula("P'") and "<mo>≔</mo>" in formula("a := b")
    assert formula(r"\frac{<}") == formula(r"\frac{<}")
    assert "<mi><" not in formula("a < b")
    assert "<mo>\\</mo>" in formula(r"x\in\mathbb{R}\setminus\{0\}")


def test_every_formula_of_the_papers_is_drawn():
    """None is left as its source, which the converter would do to what it cannot read."""
    sources = [(c.id, line) for c in load().values() for s in (c.statement, c.repair and c.repair.statement) if s is not None
               for line in (*says_lines(s), *over_latex(s), *where_latex(s), *(formula for _, formula, _ in given_latex(s)))]
    assert len(sources) > 1000
    assert [(id, source) for id, source in sources if not formula(source).startswith("<math")] == []


def test_claims_that_are_named_are_links():
    """Where they are on the page; all else is escaped."""
    shown = {"BLZ94-E2.18", "BLM91-E3.1'", "BLM91-S6"}
    assert _linked("steps BLZ94-E2.18, BLZ94-E2.1 & BLM91-E3.1'; see BLM91-S6.", shown) == (
        "steps <a href=\"#BLZ94-E2.18\">BLZ94-E2.18</a>, BLZ94-E2.1 &amp; <a href=\"#BLM91-E3.1&#39;\">BLM91-E3.1&#39;</a>; "
        "see <a href=\"#BLM91-S6\">BLM91-S6</a>.")
