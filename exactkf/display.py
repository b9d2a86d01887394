# SPDX-License-Identifier: MIT
"""Verdicts in few words, and the table at the end of a run."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from rich.console import Console
from rich.table import Table

from exactkf.evidence import Evidence
from exactkf.record import STRENGTHS

__all__ = ["column_of", "describe", "heading", "ranges", "summary"]

_COLUMNS = (*STRENGTHS, "corrected", "fails", "open")


def column_of(result: Mapping[str, Any]) -> str:
    """Column of the summary that a result counts in."""
    if result["verdict"] == "holds":
        return result["strength"] or "open"
    if result["verdict"] == "fails":
        return "corrected" if (result["repair"] or {}).get("verdict") == "holds" else "fails"
    return "open"


def summary(results: Sequence[Mapping[str, Any]]) -> None:
    """Print the number of claims by paper, verdict and strength."""
    used = [c for c in _COLUMNS if any(column_of(r) == c for r in results)]
    table = Table(box=None, pad_edge=False, header_style="bold")
    table.add_column("paper", no_wrap=True)
    for name in [*used, "total"]:
        table.add_column(name, justify="right", overflow="fold")
    papers = list(dict.fromkeys(r["paper"] for r in results))
    for paper in papers:
        table.add_row(paper, *_counts([r for r in results if r["paper"] == paper], used))
    if len(papers) > 1:
        table.add_row("all", *_counts(results, used), style="bold")
    console = Console()
    if not console.is_terminal:
        console.width = 120
    console.print(table)


def _counts(results: Sequence[Mapping[str, Any]], columns: Iterable[str]) -> list[str]:
    counts = [sum(column_of(r) == c for r in results) for c in columns]
    return [str(n or "") for n in [*counts, len(results)]]


def describe(result: Mapping[str, Any]) -> str:
    """Verdict, strength and sizes in a few words."""
    words = result["verdict"]
    if result["strength"]:
        words += f", {result['strength']}"
    if result.get("sizes"):
        words += " (" + "; ".join(f"{name} = {ranges(values)}" for name, values in result["sizes"].items()) + ")"
    return words


def heading(by: Iterable[Evidence]) -> str:
    """What the formula with this evidence is to the printed sentence."""
    kinds = {e.kind for e in by}
    if "part" in kinds:
        return "checked: a part of what is printed"
    if kinds & {"restated", "steps"}:
        return "checked: what is printed is this together with the facts named below"
    return "as printed"


def ranges(values: Sequence[int]) -> str:
    """Whole numbers with runs drawn together.

    >>> ranges([1, 2, 3, 5])
    '1..3, 5'
    """
    runs: list[list[int]] = []
    for v in sorted(values):
        if runs and v == runs[-1][1] + 1:
            runs[-1][1] = v
        else:
            runs.append([v, v])
    return ", ".join(f"{a}..{b}" if b > a + 1 else (f"{a}, {b}" if b > a else str(a)) for a, b in runs)
