# SPDX-License-Identifier: MIT
"""An answer for people: on the screen and in LaTeX, the same entries in both.

Main definitions
----------------
``headline``                            what the orbit does, in one line
``decision_lines``                      that, and the derivation
``number_lines``, ``structure_lines``   what `exactkf.dynamics.shown_entries` makes, as lines
``latex_text``, ``latex_rows``          all of it in LaTeX, and its entries
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from exactkf.dynamics.answer import Answer
from exactkf.dynamics.shown_entries import Entry, ahead_entries, number_entries, structure_entries

__all__ = ["decision_lines", "headline", "latex_rows", "latex_text", "number_lines", "structure_lines"]

_LONGEST = 800  # characters of a line


def decision_lines(answer: Answer) -> list[str]:
    """What the orbit does, and why."""
    return [f"order {answer.order}: {headline(answer)}", "", *(f"  {_short(line)}" for line in answer.words().splitlines())]


def _short(line: str) -> str:
    """The line without its middle, if nobody would read all of it; it is whole in JSON and LaTeX."""
    return line if len(line) <= _LONGEST else f"{line[:_LONGEST // 2]} ... ({len(line) - _LONGEST} characters, see --json) ... {line[-_LONGEST // 2:]}"


def number_lines(answer: Answer, digits: int) -> list[str]:
    """The limit, the rate and the other numbers of the answer."""
    return _lines(number_entries(answer, digits))


def structure_lines(answer: Answer, digits: int) -> list[str]:
    """What is behind the orbit, and that the certificate vouches for all of this."""
    return [*_lines(structure_entries(answer, digits)), "", f"  {vouched(answer)}"]


def _lines(entries: Sequence[Entry]) -> list[str]:
    width = max((len(entry.label) for entry in entries), default=0)
    return ["", *(f"  {entry.label:<{width}}  {_short(entry.words)}" for entry in entries)] if entries else []


def vouched(answer: Answer) -> str:
    """What the certificate vouches for, and what of the speed it takes from the literature."""
    if answer.behaviour == "undecided":
        return "The certificate vouches for the steps searched and for the structure."
    said = "The certificate vouches for every entry of this answer, and for enclosed numbers within the intervals that it gives; the sentences say why."
    known = answer.__dict__
    if answer.order > 1 and known.get("rate") not in (None, "0"):
        said += (" Of the rate it shows that it is the square of the largest modulus of the zeros of D inside the circle; "
                 "that the orbit converges at this rate is cited (Nevai and Totik 1989), not proved.")
    elif answer.order > 1 and known.get("slow") is not None:
        said += (f" Of the {answer.slow} in {answer.slow}/t it shows that it is the sum of squares of half the multiplicities of the zeros of D on the circle; "
                 "that the orbit converges like this is argued in words, not proved.")
    return said


def headline(answer: Answer) -> str:
    """What the orbit does, in one line."""
    match answer.behaviour:
        case "escapes":
            return f"the orbit escapes at step {answer.escape}"
        case "periodic" if answer.period == 1:
            return "the orbit is an equilibrium"
        case "periodic":
            return f"the orbit is periodic with period {answer.period}"
        case "eventually periodic":
            return f"the orbit has the period {answer.period} from step {answer.preperiod} on, and does not come back to its start"
        case "dense":
            return "the orbit never repeats and is dense in its invariant curve"
        case "converges":
            return "the orbit converges"
        case "undecided":
            return "undecided"
        case "not convergent, not periodic" if answer.is_open:
            return "the orbit is not convergent, not periodic; an escape is not excluded"
    return f"the orbit is {answer.behaviour}"


# ---------------------------------------------------------------------- LaTeX
def latex_text(answer: Answer, digits: int, ahead: Mapping[str, Any] | None) -> str:
    """Headline, derivation, numbers and structure, the state far ahead if it is given, and what the certificate vouches for."""
    reason = [f"Undecided: {answer.reason}."] if answer.reason else []
    lists = [[*(fact.latex for fact in answer.facts), *reason], latex_rows(answer, digits), _rows(ahead_entries(ahead, digits)) if ahead else []]
    parts = [f"\\noindent\\textbf{{Order {answer.order}: {headline(answer)}.}}"]
    for rows in lists:
        if rows:
            parts += ["\\begin{itemize}", *(f"  \\item {row}" for row in rows), "\\end{itemize}"]
    return "\n".join([*parts, f"\\noindent {vouched(answer)}"])


def latex_rows(answer: Answer, digits: int) -> list[str]:
    """The entries of numbers and structure in LaTeX."""
    return _rows([*number_entries(answer, digits), *structure_entries(answer, digits)])


def _rows(entries: Sequence[Entry]) -> list[str]:
    return [f"{entry.label_latex}: {entry.latex}" for entry in entries]
