# SPDX-License-Identifier: MIT
"""Replaying certificate files; of the package, only the checker and what reads files are imported."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import nullcontext
from pathlib import Path
from typing import Any

import click

from exactkf._errors import BadInput
from exactkf.entered import entered, reading_list
from exactkf.files import reaching
from exactkf.kernel.files import one_line, parsed
from exactkf.kernel.limits import SECONDS, patiently
from exactkf.kernel.replay import NotACertificate, Rejected, replay, rests_on
from exactkf.progress import Meter

__all__ = ["check_paths", "read_certificate"]

_MOST_BYTES = 256 << 20
_PROOFS = ("evaluation", "identity", "combination", "induction", "membership", "order", "word induction", "generic index", "arithmetic", "conjunction",
           "positivity")


def check_paths(paths: Iterable[Path], seconds: float = SECONDS, *, code: bool = False) -> int:
    """Replay every certificate; exit status 0, 1 or 2 as the command has it. What one takes for granted is said, and what ran if `code`."""
    files = _files(paths)
    rejected, strange = 0, 0
    granted, proved = dict[Path, str](), set[str]()
    with Meter("check", len(files)) as meter, entered() if code else nullcontext() as ran:
        for file in files:
            try:
                certificate = read_certificate(file)
                with patiently(seconds):
                    replay(certificate)
                if needed := rests_on(certificate):
                    granted[file] = needed
                elif certificate["kind"] in _PROOFS:
                    proved.add(certificate["id"])
            except Rejected as error:
                rejected += 1
                click.echo(one_line(f"{file}: does not replay: {error}"))
            except (NotACertificate, BadInput) as error:
                strange += 1
                click.echo(one_line(f"exactkf: argument PATH = {str(file)!r}: {error}"), err=True)
            meter.step(file.name)
    for file, needed in granted.items():
        shown = " (a proof by that name replays here)" if needed in proved else ""
        click.echo(one_line(f"{file}: replays assuming {needed}{shown} for its parametrisation to reach everything"))
    assuming = f", {len(granted)} of them assuming what is named above" if granted else ""
    click.echo(f"{len(files) - rejected - strange} of {len(files)} certificates replay{assuming}")
    if ran is not None:
        click.echo("\n".join(reading_list(ran)))
    return 1 if rejected else 2 if strange else 0


def read_certificate(file: Path) -> Any:
    """Read a JSON file; what is no JSON raises BadInput, what is read in two ways NotACertificate."""
    try:
        with open(file, "rb") as stream:
            data = stream.read(_MOST_BYTES + 1)  # a device such as /dev/zero has no end
        if len(data) > _MOST_BYTES:
            raise BadInput(f"is longer than {_MOST_BYTES >> 20} MB; pass a file that 'exactkf verify --certificates' wrote")
        return parsed(data.decode("utf-8"))
    except BadInput:
        raise
    except OSError as error:
        raise BadInput(f"cannot be read ({error.strerror or error}); pass a file that you may read") from error
    except (ValueError, RecursionError) as error:
        raise BadInput(f"is not JSON ({error}); pass a file that 'exactkf verify --certificates' wrote") from error


def _files(paths: Iterable[Path]) -> list[Path]:
    """Files named, and the .json files of folders named, each once."""
    files: dict[Path, None] = {}
    for path in paths:
        with reaching("PATH", path, "read"):
            if path.is_dir():
                found = sorted(p for p in path.rglob("*.json") if p.is_file())
                if not found:
                    raise BadInput(f"argument PATH = {str(path)!r} holds no .json file; "
                                   "write some with 'exactkf verify --certificates'")
                files.update(dict.fromkeys(found))
            elif path.exists():
                files[path] = None
            else:
                raise BadInput(f"argument PATH = {str(path)!r} does not exist; pass certificate files or folders")
    return list(files)
