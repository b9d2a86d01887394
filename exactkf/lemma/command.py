# SPDX-License-Identifier: MIT
"""The command ``exactkf lemma``."""

from __future__ import annotations

import multiprocessing
import queue
import re
from concurrent.futures import Future, TimeoutError
from pathlib import Path

import click
from pebble import ProcessExpired, ProcessPool

from exactkf import __version__
from exactkf.cli import INTERRUPTED
from exactkf.files import check_folder, check_target, dump_json, reaching, write_text
from exactkf.language import Statement
from exactkf.lemma.outcome import Outcome
from exactkf.lemma.prove import prove_lemma, read_file
from exactkf.lemma.show import outcome_lines
from exactkf.progress import Meter

__all__ = ["lemma_command"]

_HEARTBEAT = 0.5
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
    done: queue.SimpleQueue[Future] = queue.SimpleQueue()
    # a fresh interpreter: forking a process that runs threads (a progress display has one) can hang
    with Meter("lemma", 1) as meter, ProcessPool(max_workers=1, context=multiprocessing.get_context("spawn")) as pool:
        task: Future = pool.schedule(_task, (statement, time_limit, degree, seed), timeout=time_limit)
        task.add_done_callback(done.put)
        try:
            while True:
                try:
                    done.get(timeout=_HEARTBEAT)
                    break
                except queue.Empty:
                    meter.tick()
        except KeyboardInterrupt:
            pool.stop()
            click.echo("exactkf: stopped", err=True)
            raise click.exceptions.Exit(INTERRUPTED) from None
    try:
        return task.result()
    except TimeoutError:
        return Outcome(statement, reason=f"out of time after {time_limit:g} s; a larger --time-limit may settle it", seconds=time_limit)
    except MemoryError:
        return Outcome(statement, reason="out of memory; a smaller --degree may settle it")
    except ProcessExpired as error:
        return Outcome(statement, reason=f"crashed: the process ended with exit code {error.exitcode}")


def _task(statement: Statement, time_limit: float, degree: int, seed: int) -> Outcome:
    return prove_lemma(statement, time_limit=_SOFT * time_limit, degree=degree, seed=seed)


def _write_certificates(outcome: Outcome, folder: Path, stem: str) -> None:
    """One file for each certificate; those of an earlier run of the same lemma go away."""
    with reaching("--certificates", folder):
        folder.mkdir(parents=True, exist_ok=True)
        for old in folder.glob("*.json"):
            if re.fullmatch(rf"{re.escape(stem)}-\d+-[a-z-]+\.json", old.name):
                old.unlink()
        for k, certificate in enumerate(outcome.certificates, 1):
            write_text(folder / f"{stem}-{k}-{certificate['kind'].replace(' ', '-')}.json", dump_json(certificate, indent=None))
