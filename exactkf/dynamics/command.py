# SPDX-License-Identifier: MIT
"""What ``exactkf analyze`` does: options in, words, files and pictures out."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import click

from exactkf._errors import BadInput
from exactkf.bounded import Ended, OutOfTime, bounded
from exactkf.dynamics.answer import Answer
from exactkf.dynamics.files import is_of_many, read_filters, split_list
from exactkf.dynamics.stages import Request, Told, carry_out
from exactkf.exact._messages import bad
from exactkf.files import check_target, dump_json, reaching, write_text
from exactkf.progress import Meter

__all__ = ["analyze_command"]

_PICTURES = ("plane", "gamma", "alpha", "spectrum")


def analyze_command(given: Sequence[Path], *, pi0: str | None, after: int | None, digits: int, json_file: Path | None, certificate: Path | None,
                    latex_file: Path | None, pictures: Sequence[str], steps: int, time_limit: float, jobs: int | None, fresh: bool,
                    **vectors: str | None) -> int:
    """Decide, print, write; exit status 0, or 1 if something is undecided or not all that is asked for was found; `batch_command` if there are many."""
    for name, path in (("--json", json_file), ("--certificate", certificate), ("--latex", latex_file)):
        if path is not None and path.is_file() and any(file.is_file() and file.samefile(path) for file in given):
            raise bad(name, "is the FILE of filters itself, which would be lost", str(path), "name another")
    filters = _filters(given, vectors)
    if pi0 is not None:
        for _, data in filters:
            data["pi0"] = pi0
    if len(filters) > 1 or any(map(is_of_many, given)):
        from exactkf.dynamics.batch import batch_command
        from exactkf.workers import default_jobs

        for name, value in (("--after", after), ("--latex", latex_file), ("--picture", pictures or None)):
            if value is not None:
                raise BadInput(f"argument {name} goes with one filter, and there are {len(filters)}; leave it out, or name a file with one")
        return batch_command(filters, jobs=jobs or default_jobs(), time_limit=time_limit, json_file=json_file, certificate=certificate,
                             fresh=fresh)
    targets = {"json": json_file, "certificate": certificate, "latex": latex_file}
    files = {name: check_target(path, f"--{name}") for name, path in targets.items() if path is not None}
    drawings = tuple(_picture(text) for text in pictures)
    if drawings:
        from exactkf.dynamics.pictures import require_matplotlib

        require_matplotlib()
    found = _carried_out(Request(filters[0][1], after, digits, steps, tuple(files), drawings), time_limit)
    click.echo("\n".join(found.shown()))
    for name, text in found.texts().items():
        if name in files:
            with reaching(f"--{name}", files[name]):
                one_line = name == "json" and files[name].suffix.lower() == ".jsonl"
                write_text(files[name], dump_json(json.loads(text), indent=None) if one_line else text)
    missing = [path for name, path in files.items() if name not in found.texts()] + [path for _, path in drawings if path not in found.drawn]
    for path in missing:
        click.echo(f"exactkf: {path}: not written, {found.why or 'see above'}", err=True)
    for path in found.drawn:
        click.echo(f"{path}: picture written", err=True)
    return 1 if found.why or found.missing or found.data["reason"] else 0


@dataclass
class _Found:
    """What the stages told, and why they stopped early, if they did."""

    stage: str = "starting"
    order: int | None = None
    data: dict[str, Any] = field(default_factory=dict)
    lines: list[str] = field(default_factory=list)
    files: dict[str, str] = field(default_factory=dict)
    drawn: list[Path] = field(default_factory=list)
    missing: list[str] = field(default_factory=list)
    why: str = ""

    def hear(self, told: Told) -> None:
        """Take up one message."""
        kind, value = told
        match kind:
            case "stage":
                self.stage = value
            case "order":
                self.order = value
            case "decided":
                self.data = value
            case "lines":
                self.lines += value
            case "missing":
                self.missing.append(value)
            case "file":
                self.files[value[0]] = value[1]
            case _:
                self.drawn.append(value)

    def stop(self, why: str) -> None:
        """Keep what there is, and say what is missing."""
        self.why = f"{why} while {self.stage}"
        if not self.data:
            self.data = {**Answer(self.order or 0, "undecided", reason=self.why).to_json(), "order": self.order}
        self.data["reason"] = self.why

    def shown(self) -> list[str]:
        """The lines to print."""
        if not self.why:
            return [*self.lines, *(f"  Not found: {why}." for why in self.missing)]
        if not self.lines:
            return [f"{f'order {self.order}: ' if self.order else ''}undecided", "", f"  Undecided: {self.why}."]
        return [*self.lines, "", f"  Not finished: {self.why}."]

    def texts(self) -> Mapping[str, str]:
        """The texts of files: whole, but for the answer as data, which says what is missing."""
        return {"json": dump_json(self.data), **self.files} if self.why else self.files


def _carried_out(request: Request, time_limit: float) -> _Found:
    """Run in a process of its own, which ends at the time limit whatever it is doing."""
    found = _Found()
    with Meter("analyze", request.stages() + 1) as meter:
        def heard(told: Told) -> None:
            if told[0] == "stage":
                meter.step(found.stage)
            found.hear(told)

        try:
            bounded(carry_out, request, time_limit, heard, meter.tick)
        except OutOfTime:
            found.stop(f"out of time after {time_limit:g} s")
        except Ended as error:
            found.stop(str(error))
    return found


def _filters(files: Sequence[Path], vectors: dict[str, str | None]) -> list[tuple[str, dict[str, Any]]]:
    """The filters, from files or from options, with labels."""
    options: dict[str, Any] = {key: split_list(f"--{key}", text) for key, text in vectors.items() if text is not None}
    if files and options:
        raise BadInput(f"argument --{min(options)} comes beside FILE = {str(files[0])!r}; give the filter once")
    if not files and not options:
        raise BadInput("argument FILE is missing; name a .toml, .json, .jsonl or .csv file, or give --alpha and --gamma, --a and --g, --b and --a, "
                       "or --covariances")
    return [x for file in files for x in read_filters(file)] if files else [("", options)]


def _picture(text: str) -> tuple[str, Path]:
    """KIND=FILE, checked before any work."""
    kind, sign, name = text.partition("=")
    if not sign or kind not in _PICTURES or not name:
        raise bad("--picture", "is not KIND=FILE", text, f"write one of {', '.join(_PICTURES)}, such as plane=orbit.svg")
    path = check_target(Path(name), "--picture")
    if path.suffix.lower() not in (".png", ".svg"):
        raise bad("--picture", "names a file that ends in neither .png nor .svg", name, "pass one that does")
    return kind, path
