# SPDX-License-Identifier: MIT
"""From results to the page."""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Iterable, Mapping, Sequence, Set
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from exactkf import __version__
from exactkf.claims import Claim
from exactkf.describe import instance_lines, not_wrong, wrong_made
from exactkf.display import column_of, describe, heading, ranges
from exactkf.files import write_text
from exactkf.language import Statement
from exactkf.language.latex import given_latex, over_latex, says_lines, statement_latex, where_latex
from exactkf.report.mathml import formula

__all__ = ["render", "write_report"]

_COLUMNS = ("proved", "proved-sizes", "steps", "instances", "enclosed", "corrected", "fails", "open")
_MARKS = {"holds": "✓", "fails": "✗", "open": "○"}


def write_report(results: Sequence[Mapping[str, Any]], claims: Mapping[str, Claim], file: Path,
                 package: str = "proofs") -> None:
    """Render the page and write it whole."""
    write_text(file, render(results, claims, package))


def render(results: Sequence[Mapping[str, Any]], claims: Mapping[str, Claim], package: str = "proofs") -> str:
    """The page as text.

    Parameters
    ----------
    results : sequence of dict
        From the engine, in reading order.
    claims : mapping of id to Claim
        For the statements; every formula is made from the tree that was checked.
    package : str
        Package of the claims: the docstrings of its modules are the headings.
    """
    environment = Environment(
        loader=PackageLoader("exactkf.report"), autoescape=True, trim_blocks=True, lstrip_blocks=True,
        undefined=StrictUndefined)
    environment.filters.update(formula=formula, not_wrong=not_wrong, describe=describe, ranges=ranges)
    shown = {r["id"] for r in results}
    environment.filters["linked"] = lambda line: _linked(line, shown)
    papers = [_paper(key, rows, claims, package) for key, rows in _grouped(results, "paper")]
    return environment.get_template("page.html").render(
        version=__version__, papers=papers, columns=[c for c in _COLUMNS if any(p["counts"][c] for p in papers)],
        totals=_totals(results), marks=_MARKS)


def _linked(line: str, shown: Set[str]) -> Markup:
    """A line with the ids of claims on the page as links to them."""
    return Markup("").join(Markup('<a href="#{0}">{0}</a>').format(part) if part in shown else escape(part)
                           for part in re.split(r"(?<![\w.-])([A-Z]+\d+-[\w.'-]*[\w'])", line))


def _grouped(results: Iterable[Mapping[str, Any]], field: str) -> list[tuple[str, list]]:
    groups: dict[str, list] = {}
    for result in results:
        groups.setdefault(result[field], []).append(result)
    return list(groups.items())


def _totals(results: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    return {
        "claims": len(results), "checks": sum(r["checks"] for r in results), "counts": _counts(results),
        "made": sum(wrong_made(r["mutants"]) for r in results), "rejected": sum(r["mutants"]["rejected"] for r in results),
        "verdicts": {v: sum(r["verdict"] == v for r in results) for v in _MARKS},
    }


def _counts(results: Iterable[Mapping[str, Any]]) -> dict[str, int]:
    columns = [column_of(r) for r in results]
    return {c: columns.count(c) for c in _COLUMNS}


def _paper(key: str, results: Sequence[Mapping[str, Any]], claims: Mapping[str, Claim], package: str) -> dict[str, Any]:
    title, _ = _docstring(f"{package}.{key.lower()}")
    sections = []
    for name, rows in _grouped(results, "section"):
        heading, text = _docstring(f"{package}.{key.lower()}.{name}")
        sections.append({
            "id": f"{key}-{name}", "title": heading or name.replace("_", " "), "text": text,
            "claims": [_claim(r, claims[r["id"]]) for r in rows]})
    return {"key": key, "title": title or key, "sections": sections, "counts": _counts(results), "total": len(results)}


def _docstring(module: str) -> tuple[str, list[str]]:
    """First line and paragraphs of a module's docstring, if it is imported and has one."""
    text = inspect.getdoc(sys.modules[module]) if module in sys.modules else None
    head, *rest = (text or "").strip().split("\n\n")
    return " ".join(head.split()).rstrip("."), [p for p in rest if p.strip()]


def _claim(result: Mapping[str, Any], claim: Claim) -> dict[str, Any]:
    fixed = result["repair"]
    return {
        **result,
        "statement": _statement(claim.statement), "heading": heading(claim.by) if claim.statement else "",
        "standing": _standing(result), "column": column_of(result),
        "fixed": _correction(fixed, claim) if fixed and claim.repair else None,
        "witness": instance_lines(result["witness"]), "counterexample": instance_lines(result["counterexample"]),
        "wrong_made": wrong_made(result["mutants"]), "survivors": result["mutants"].get("survivors", []),
        "words": " ".join([result["id"], result["title"], result["verdict"], _standing(result),
                           (fixed or {}).get("kind") or ""]).lower(),
    }


def _correction(fixed: Mapping[str, Any], claim: Claim) -> dict[str, Any]:
    """The correction; of its setting only what differs from the printed statement."""
    printed, right = _statement(claim.statement), _statement(claim.repair.statement if claim.repair else None)
    names = {"over": "variables", "where": "definitions", "given": "hypotheses"}
    same = [part for part in names if right[part] and right[part] == printed[part]]
    return {**fixed, **right, **{part: [] for part in same}, "same": [names[part] for part in same]}


def _standing(result: Mapping[str, Any]) -> str:
    """What stands after the verdict on the badge."""
    if result["verdict"] == "fails":
        fixed = result["repair"]
        if fixed is None or fixed["verdict"] != "holds":
            return "correction open" if fixed else "no correction"
        return f"corrected: {fixed['strength']}"
    return result["strength"] or ""


def _statement(statement: Statement | None) -> dict[str, Any]:
    if statement is None:
        return {"says": [], "over": [], "where": [], "given": [], "latex": ""}
    return {"says": says_lines(statement), "over": over_latex(statement), "where": where_latex(statement),
            "given": given_latex(statement), "latex": statement_latex(statement)}
