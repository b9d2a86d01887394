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
from exactkf.dynamics.ahead import ahead_data, ahead_lines
from exactkf.dynamics.analyze import analyze, filter_from
from exactkf.dynamics.answer import Answer
from exactkf.dynamics.certified import with_ahead
from exactkf.dynamics.filter import Filter
from exactkf.dynamics.shown import decision_lines, number_lines, structure_lines
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
        return 4 + (self.after is not None) + len(self.files) + len(self.pictures)


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
    for name, lines in (("limit", number_lines), ("structure", structure_lines)):
        tell(("stage", f"finding the {name}"))
        try:
            tell(("lines", lines(answer, request.digits)))
        except Unsupported as error:
            tell(("missing", f"{name}: {error}"))
        tell(("decided", answer.without_certificate()))
    ahead = None
    if request.after is not None:
        tell(("stage", f"going {request.after} steps ahead"))
        try:
            ahead = ahead_data(filter.a, filter.g, request.after, request.digits)
        except Unsupported as error:
            tell(("missing", str(error)))
        else:
            said = [*ahead_lines(ahead, request.digits), *([] if start is None else ["(of the filter; the certificate speaks of the Riccati equation only)"])]
            tell(("lines", ["", *(f"  {line}" for line in said)]))
    for name in request.files:
        tell(("stage", f"writing the {name}"))
        try:
            tell(("file", (name, _text(name, answer, request, ahead, start is None))))
        except Unsupported as error:
            tell(("missing", f"{name}: {error}"))
    for kind, path in request.pictures:
        tell(("stage", f"drawing the {kind} picture"))
        try:
            with reaching("--picture", path):
                _draw(kind, path, filter, request.steps)
        except Unsupported as error:
            tell(("missing", f"{kind} picture: {error}"))
        else:
            tell(("drawn", path))


def _text(name: str, answer: Answer, request: Request, ahead: dict[str, Any] | None, of_filter: bool) -> str:
    """What goes into a file; the certificate has the state far ahead, unless the question is about a Riccati equation."""
    if name == "latex":
        return answer.latex(request.digits, ahead) + "\n"
    certificate = answer.certificate if ahead is None or not of_filter else with_ahead(answer, ahead)
    if name == "certificate":
        return dump_json(certificate)
    return dump_json({**answer.to_json(), **({} if request.after is None else {"ahead": ahead}), "certificate": certificate})


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
