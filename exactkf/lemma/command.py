# SPDX-License-Identifier: MIT
"""The command ``exactkf lemma``."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import click

from exactkf import __version__
from exactkf.bounded import Ended, OutOfTime, bounded
from exactkf.files import check_folder, check_target, dump_json, reaching, write_text
from exactkf.language import Statement
from exactkf.lemma.outcome import Outcome
from exactkf.lemma.prove import prove_lemma, read_file
from exactkf.lemma.show import outcome_lines
from exactkf.progress import Meter

__all__ = ["lemma_command"]

_SOFT = 0.9  # part of the time limit after which no new search is begun; what is left is for those under way


def lemma_command(file: Path, json_file: Path | None, certificates: Path | None, time_limit: float, degree: int, seed: int) -> int:
    """Settle the lemma of a file; exit status 0 if it is proved, 1 if it is refuted or open."""
    statement = read_file(file)
    if json_file:
        check_target(json_file, "--json")
    if certificates:
        check_folder(certificates, "--certificates")
    outcome = _settled(statement, time_limit, degree, seed)
    if certificates:
        _write_certificates(outcome, certificates, file.stem)
    if json_file:
        with reaching("--json", json_file):
            write_text(json_file, dump_json({"version": __version__, **outcome.to_json()}))
    for line in outcome_lines(outcome):
        click.echo(line)
    return 0 if outcome.verdict == "proved" else 1


def _settled(statement: Statement, time_limit: float, degree: int, seed: int) -> Outcome:
    """Run in a process of its own, which ends at the time limit whatever it is doing."""
    found: list[Outcome] = []
    with Meter("lemma", 1) as meter:
        try:
            bounded(_task, (statement, time_limit, degree, seed), time_limit, found.append, meter.tick)
        except OutOfTime:
            return Outcome(statement, reason=f"out of time after {time_limit:g} s; a larger --time-limit may settle it", seconds=time_limit)
        except Ended as error:
            return Outcome(statement, reason=f"{error}; a smaller --degree may settle it" if str(error) == "out of memory" else str(error))
    return found[0]


def _task(request: tuple[Statement, float, int, int], tell: Callable[[Outcome], None]) -> None:
    statement, time_limit, degree, seed = request
    tell(prove_lemma(statement, time_limit=_SOFT * time_limit, degree=degree, seed=seed))


def _write_certificates(outcome: Outcome, folder: Path, stem: str) -> None:
    """One file for each certificate; those of an earlier run of the same lemma go away."""
    with reaching("--certificates", folder):
        folder.mkdir(parents=True, exist_ok=True)
        for old in folder.glob("*.json"):
            if re.fullmatch(rf"{re.escape(stem)}-\d+-[a-z-]+\.json", old.name):
                old.unlink()
        for k, certificate in enumerate(outcome.certificates, 1):
            write_text(folder / f"{stem}-{k}-{certificate['kind'].replace(' ', '-')}.json", dump_json(certificate, indent=None))
