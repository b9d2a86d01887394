# SPDX-License-Identifier: MIT
"""What ``exactkf analyze`` does: options in, words, files and pictures out."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click
from flint import arb, fmpq

from exactkf._errors import BadInput
from exactkf.dynamics.analyze import analyze, filter_from, read_data
from exactkf.dynamics.answer import Answer
from exactkf.dynamics.exact_json import polynomial_words
from exactkf.dynamics.filter import Filter
from exactkf.exact._messages import bad
from exactkf.exact.balls import precision
from exactkf.exact.numberfield import RealField
from exactkf.files import check_target, dump_json, reaching, write_text

__all__ = ["analyze_command", "shown_number", "split_list"]

_PICTURES = ("plane", "gamma", "alpha", "spectrum")


def analyze_command(file: Path | None, *, pi0: str | None, after: int | None, digits: int, json_file: Path | None, certificate: Path | None,
                    latex_file: Path | None, pictures: Sequence[str], steps: int, **vectors: str | None) -> int:
    """Decide, print, write; exit status 0, or 1 if the orbit is undecided."""
    targets = [("--json", json_file), ("--certificate", certificate), ("--latex", latex_file)]
    for argument, path in targets:
        if path is not None:
            check_target(path, argument)
    drawings = [_picture(text) for text in pictures]
    if drawings:
        from exactkf.dynamics.pictures import require_matplotlib

        require_matplotlib()
    data = _data(file, vectors)
    start = data.pop("pi0", None) if pi0 is None else pi0
    filter = filter_from(data)
    for kind, order in (("plane", 1), ("alpha", 2)):
        if kind in dict(drawings) and filter.order != order:
            raise bad("--picture", f"asks for the {kind} picture of a filter of order {filter.order}", kind, f"it is drawn for order {order}")
    answer = analyze(filter, pi0=start)
    click.echo("\n".join(_lines(answer, digits)))
    if after is not None:
        click.echo("\n".join(_ahead(filter, after, digits)))
    texts = (lambda: dump_json(answer.to_json()), lambda: dump_json(answer.certificate), lambda: answer.latex() + "\n")
    for (argument, path), text in zip(targets, texts, strict=True):
        if path is not None:
            with reaching(argument, path):
                write_text(path, text())
    for kind, path in drawings:
        with reaching("--picture", path):
            _draw(kind, path, filter, steps)
    return 1 if answer.behaviour == "undecided" else 0


def _data(file: Path | None, vectors: dict[str, str | None]) -> dict[str, Any]:
    """The mapping that describes the filter, from a file or from options."""
    given: dict[str, Any] = {key: split_list(key, text) for key, text in vectors.items() if text is not None}
    if file is not None:
        if given:
            raise BadInput(f"argument --{min(given)} comes beside FILE = {str(file)!r}; give the filter once")
        return read_data(file)
    if not given:
        raise BadInput("argument FILE is missing; name a .toml or .json file, or give --alpha and --gamma, --a and --g, --b and --a, or --covariances")
    return given


def split_list(name: str, text: str) -> list[str]:
    """Split at the commas outside parentheses.

    Raises
    ------
    BadInput
        If an entry is empty.

    Examples
    --------
    >>> split_list("alpha", "1/2, root(x^2 - 2, 1, 2)")
    ['1/2', 'root(x^2 - 2, 1, 2)']
    """
    parts, depth = [""], 0
    for c in text:
        depth += (c == "(") - (c == ")")
        if c == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += c
    parts = [p.strip() for p in parts]
    if not all(parts):
        raise bad(f"--{name}", "has an empty entry", text, "separate numbers by single commas")
    return parts


def _lines(answer: Answer, digits: int) -> list[str]:
    """The answer for people."""
    head = f"order {answer.order}: {_headline(answer)}"
    lines = [head, "", *(f"  {line}" for line in answer.words().splitlines())]
    rows: list[tuple[str, str]] = []
    for name, values in (answer.limit or {}).items():
        for k, value in enumerate(values if isinstance(values, list) else [values]):
            index = f"_{k + 1}" if isinstance(values, list) and len(values) > 1 else ""
            rows.append((f"limit of {name}{index}", shown_number(value, digits)))
    if answer.rate is not None:
        rows.append(("rate", shown_number(answer.rate, digits)))
    if answer.region:
        rows.append(("start", answer.region))
    for label, value in (("monotone from step", answer.monotone_from), ("positive real from step", answer.enters_positive_real),
                         ("dimension of the torus", answer.torus_dimension)):
        if value is not None:
            rows.append((label, str(value)))
    if rows:
        width = max(len(label) for label, _ in rows)
        lines += ["", *(f"  {label:<{width}}  {value}" for label, value in rows)]
    return lines


def _headline(answer: Answer) -> str:
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
    return f"the orbit is {answer.behaviour}"


def shown_number(value: Any, digits: int) -> str:
    """An exact number of an answer, with its decimal digits.

    Examples
    --------
    >>> shown_number("1/3", 5)
    '1/3'
    """
    if not isinstance(value, dict):
        return str(value)
    if "minpoly" not in value:
        lo, hi = (fmpq(*map(int, end.split("/"))) for end in value["interval"])
        with precision(4 * digits + 64):
            return f"{arb(lo).union(arb(hi)).str(digits, radius=False)}  (enclosed)"
    field = RealField(value["minpoly"], value["interval"])
    digits_of = field.gen().enclose(digits).str(digits, radius=False)
    return f"{digits_of}  (root {field.index + 1} of {polynomial_words(field.minpoly, 'x')}, from the left)"


def _ahead(filter: Filter, steps: int, digits: int) -> list[str]:
    """The state after so many steps, exact as long as it is short, in digits in any case."""
    from exactkf.dynamics.ahead import ahead_lines

    return ahead_lines(filter.a, filter.g, steps, digits)


def _picture(text: str) -> tuple[str, Path]:
    """KIND=FILE, checked before any work."""
    kind, sign, name = text.partition("=")
    if not sign or kind not in _PICTURES or not name:
        raise bad("--picture", "is not KIND=FILE", text, f"write one of {', '.join(_PICTURES)}, such as plane=orbit.svg")
    path = check_target(Path(name), "--picture")
    if path.suffix.lower() not in (".png", ".svg"):
        raise bad("--picture", "names a file that ends in neither .png nor .svg", name, "pass one that does")
    return kind, path


def _draw(kind: str, path: Path, filter: Filter, steps: int) -> None:
    from exactkf.dynamics import pictures

    match kind:
        case "plane":
            figure = pictures.draw_plane(filter, steps)
        case "gamma":
            figure = pictures.draw_gamma(filter, steps)
        case "alpha":
            figure = pictures.draw_alpha_plane(filter)
        case _:
            figure = pictures.draw_spectrum(filter)
    pictures.save(figure, path)
    click.echo(f"{path}: picture written", err=True)
