# SPDX-License-Identifier: MIT
"""An answer as lines for people."""

from __future__ import annotations

from typing import Any

from exactkf.dynamics.answer import Answer
from exactkf.dynamics.every_order import limit_digits
from exactkf.dynamics.exact_json import polynomial_words
from exactkf.exact.numberfield import RealField

__all__ = ["decision_lines", "headline", "number_lines", "shown_number"]

_LONGEST = 800  # characters of a line


def decision_lines(answer: Answer) -> list[str]:
    """What the orbit does, and why."""
    return [f"order {answer.order}: {headline(answer)}", "", *(f"  {_short(line)}" for line in answer.words().splitlines())]


def _short(line: str) -> str:
    """The line without its middle, if nobody would read all of it; it is whole in JSON and LaTeX."""
    return line if len(line) <= _LONGEST else f"{line[:_LONGEST // 2]} ... ({len(line) - _LONGEST} characters, see --json) ... {line[-_LONGEST // 2:]}"


def number_lines(answer: Answer, digits: int) -> list[str]:
    """The limit and the other numbers of the answer."""
    rows: list[tuple[str, str]] = []
    for name, values in (answer.limit or {}).items():
        several = isinstance(values, list)
        if several and isinstance(values[0], dict) and "minpoly" not in values[0]:
            shown = [f"{f'0 to {digits} digits' if x.contains(0) else x.str(digits, radius=False)}  (enclosed)" for x in limit_digits(answer, digits).alpha]
        else:
            shown = [shown_number(value, digits) for value in (values if several else [values])]
        rows += [(f"limit of {name}" + f"_{k}" * (len(shown) > 1), text) for k, text in enumerate(shown, 1)]
    if answer.rate is not None:
        rows.append(("rate", shown_number(answer.rate, digits)))
    if answer.region:
        rows.append(("start", answer.region))
    for label, value in (("monotone from step", answer.monotone_from), ("positive real from step", answer.enters_positive_real),
                         ("dimension of the torus", answer.torus_dimension)):
        if value is not None:
            rows.append((label, str(value)))
    width = max((len(label) for label, _ in rows), default=0)
    return ["", *(f"  {label:<{width}}  {value}" for label, value in rows)] if rows else []


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


def shown_number(value: Any, digits: int) -> str:
    """An exact number of an answer, with its decimal digits; it is rational, or the root of a polynomial.

    Examples
    --------
    >>> shown_number("1/3", 5)
    '1/3'
    """
    if not isinstance(value, dict):
        return str(value)
    field = RealField(value["minpoly"], value["interval"])
    digits_of = field.gen().enclose(digits).str(digits, radius=False)
    return f"{digits_of}  (root {field.index + 1} of {polynomial_words(field.minpoly, 'x')}, from the left)"
