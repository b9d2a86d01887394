# SPDX-License-Identifier: MIT
"""What the process behind ``exactkf analyze`` does, stage after stage, telling what it has as soon as it has it.

Main definitions
----------------
``Request``   what is asked
``carry_out`` the stages
``Told``      what is told: of a stage that begins, of lines to print, of the answer as data, of texts for files,
              of what cannot be found
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from exactkf._errors import Unsupported
from exactkf.dynamics.analyze import analyze, filter_from
from exactkf.dynamics.answer import Answer
from exactkf.dynamics.filter import Filter
from exactkf.dynamics.shown import decision_lines, number_lines
from exactkf.exact._messages import bad
from exactkf.files import dump_json, reaching

__all__ = ["Request", "Told", "carry_out"]

Told = tuple[str, Any]


@dataclass(frozen=True)
class Request:
    """A filter as a mapping, and what to tell of it.

    Parameters
    ----------
    data : dict
        As `exactkf.dynamics.analyze` reads it.
    after : int, optional
        Also the state after so many steps.
    digits, steps : int
        Of numbers shown, and of orbits in pictures.
    files : tuple of str
        Those of "json", "certificate" and "latex" that are asked for.
    pictures : tuple of (kind, path)
    """

    data: dict[str, Any]
    after: int | None
    digits: int
    steps: int
    files: tuple[str, ...]
    pictures: tuple[tuple[str, Path], ...]

    def stages(self) -> int:
        """How many stages there are."""
        return 3 + (self.after is not None) + len(self.files) + len(self.pictures)


def carry_out(request: Request, tell: Callable[[Told], None]) -> None:
    """Tell of each stage that begins, and of what comes of it."""
    tell(("stage", "reading the filter"))
    data = dict(request.data)
    start = data.pop("pi0", None)
    filter = filter_from(data)
    tell(("order", filter.order))
    for kind, order in (("plane", 1), ("alpha", 2)):
        if kind in dict(request.pictures) and filter.order != order:
            raise bad("--picture", f"asks for the {kind} picture of a filter of order {filter.order}", kind, f"it is drawn for order {order}")
    tell(("stage", "deciding"))
    answer = analyze(filter, pi0=start, floats=data.get("floats"))
    tell(("decided", answer.without_certificate()))
    tell(("lines", decision_lines(answer)))
    tell(("stage", "finding the limit"))
    try:
        tell(("lines", number_lines(answer, request.digits)))
    except Unsupported as error:
        tell(("missing", f"limit: {error}"))
    if request.after is not None:
        tell(("stage", f"going {request.after} steps ahead"))
        tell(_ahead(filter, request.after, request.digits))
    for name in request.files:
        tell(("stage", f"writing the {name}"))
        tell(("file", (name, _TEXTS[name](answer))))
    for kind, path in request.pictures:
        tell(("stage", f"drawing the {kind} picture"))
        try:
            with reaching("--picture", path):
                _draw(kind, path, filter, request.steps)
        except Unsupported as error:
            tell(("missing", f"{kind} picture: {error}"))
        else:
            tell(("drawn", path))


_TEXTS: dict[str, Callable[[Answer], str]] = {
    "json": lambda answer: dump_json(answer.to_json()),
    "certificate": lambda answer: dump_json(answer.certificate),
    "latex": lambda answer: answer.latex() + "\n",
}


def _ahead(filter: Filter, steps: int, digits: int) -> Told:
    """The state after so many steps, exact as long as it is short, in digits in any case."""
    from exactkf.dynamics.ahead import ahead_lines

    try:
        return "lines", ahead_lines(filter.a, filter.g, steps, digits)
    except Unsupported as error:
        return "missing", str(error)


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
