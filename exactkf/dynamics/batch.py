# SPDX-License-Identifier: MIT
"""What ``exactkf analyze`` does with many filters: a line for each as soon as it is decided, and files."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Sequence
from contextlib import closing
from pathlib import Path
from typing import Any

import click

from exactkf.cli import INTERRUPTED
from exactkf.dynamics.answer import BEHAVIOURS, Answer
from exactkf.dynamics.kept import Kept, key_of, outcome_of, record_of
from exactkf.dynamics.many import Outcome, outcomes
from exactkf.dynamics.shown import headline
from exactkf.files import check_folder, check_target, dump_json, reaching, write_text
from exactkf.progress import Meter

__all__ = ["batch_command"]


def batch_command(filters: Sequence[tuple[str, dict[str, Any]]], *, jobs: int, time_limit: float, json_file: Path | None, certificate: Path | None,
                  fresh: bool) -> int:
    """Decide, print, write; exit status 0, 2 if a filter is refused, else 1 if something is undecided or not all that is asked for was found.

    Parameters
    ----------
    filters : sequence of (label, data)
        As `exactkf.dynamics.files.read_filters` returns them.
    jobs, time_limit
        As `exactkf.dynamics.many.decide_many` has them.
    json_file : Path, optional
        For the answers without their certificates and structures: an object a line if it ends in .jsonl, a list otherwise.  If the call is
        stopped, those that are decided by then; the same call goes on from there.
    certificate : Path, optional
        A folder for the certificates, numbered as the filters are.
    fresh : bool
        Decide also what the file has an answer to.
    """
    if json_file is not None:
        check_target(json_file, "--json")
    if certificate is not None:
        check_folder(certificate, "--certificate")
        with reaching("--certificate", certificate):
            certificate.mkdir(parents=True, exist_ok=True)
    return _Batch(filters, jobs, time_limit, Kept(json_file, fresh=fresh), certificate).carry_out("the same command" + " without --fresh" * fresh)


class _Batch:
    """Filters, what is known of them, and where it goes."""

    def __init__(self, filters: Sequence[tuple[str, dict[str, Any]]], jobs: int, time_limit: float, kept: Kept, certificates: Path | None) -> None:
        self.filters, self.jobs, self.time_limit, self.kept, self.certificates = filters, jobs, time_limit, kept, certificates
        self.records = {k: {**record, "filter": label} for k, (label, _) in enumerate(filters)
                        if (record := kept.found([self._key(k), self._key(k, is_open=True)]))}
        self.reused = len(self.records)
        self._ready = {k: outcome_of(record) for k, record in self.records.items()}  # and not yet said
        self._said, self._seen, self._status = 0, Counter[str](), 0

    def carry_out(self, again: str) -> int:
        """Decide what is not known, print and write all; `again` says which call goes on if this one is stopped."""
        pending = [k for k in range(len(self.filters)) if k not in self.records]
        asked = ("facts", "limit", "rate", "slow") * (self.kept.path is not None) + ("certificate",) * (self.certificates is not None)
        if pending:
            self.kept.begin(self.records.values())
        try:
            with Meter("analyze", len(self.filters)) as meter, closing(outcomes([self.filters[k][1] for k in pending], jobs=self.jobs,
                                                                                time_limit=self.time_limit, asked=asked, idle=meter.tick)) as found:
                self._say(meter)
                for place, outcome in found:
                    self._take(pending[place], outcome)
                    self._say(meter)
        except KeyboardInterrupt:  # what is decided by then is kept
            self._end()
            if self.kept.path is None:
                raise
            click.echo(f"exactkf: stopped; {len(self.records)} of {len(self.filters)} answers are in {str(self.kept.path)!r}: "
                       f"{again} goes on from there", err=True)
            return INTERRUPTED
        self._end()
        if self.reused:
            click.echo(f"{self.reused} of {len(self.filters)} answers were in {str(self.kept.path)!r}; --fresh decides them again", err=True)
        counted = "; ".join(f"{x} {self._seen[x]}" for x in (*BEHAVIOURS, "refused") if self._seen[x])
        click.echo(f"{len(self.filters)} filter{'s' * (len(self.filters) != 1)}: {counted}", err=True)
        return self._status

    def _say(self, meter: Meter) -> None:
        """Print the answers whose turn it is. All is kept before: what is printed is in the file, whenever Ctrl-C comes."""
        while self._said in self._ready:
            label, outcome = self.filters[self._said][0], self._ready.pop(self._said)
            self._said += 1
            self._seen[outcome.behaviour if isinstance(outcome, Answer) else "refused"] += 1
            self._status = max(self._status, _said(label, outcome))
            meter.step(label)

    def _take(self, k: int, outcome: Outcome) -> None:
        """Keep what was found, in whatever order it comes."""
        if self.certificates is not None:
            path = self._certificate(k)
            with reaching("--certificate", path):
                if isinstance(outcome, Answer) and outcome.certificate:
                    write_text(path, dump_json(outcome.certificate))
                else:
                    path.unlink(missing_ok=True)  # one of an earlier list
        if self.kept.path is not None:
            is_open = isinstance(outcome, Answer) and bool(outcome.reason)
            self.records[k] = self.kept.add(self._key(k, is_open=is_open), record_of(self.filters[k][0], outcome))
        self._ready[k] = outcome

    def _end(self) -> None:
        self.kept.end([self.records[k] for k in sorted(self.records)])

    def _certificate(self, k: int) -> Path:
        return self.certificates / f"{k + 1:0{len(str(len(self.filters)))}}.json"  # type: ignore[operator]

    def _key(self, k: int, *, is_open: bool = False) -> str:
        """The first half of the key of a filter's record."""
        written = None
        if self.certificates is not None and (file := self._certificate(k)).is_file():
            with reaching("--certificate", file, "read"):
                written = hashlib.sha256(file.read_bytes()).hexdigest()
        return key_of(self.filters[k][1], written, self.time_limit if is_open else None)


def _said(label: str, outcome: Outcome) -> int:
    """Print one line; return the exit status that it asks for."""
    if not isinstance(outcome, Answer):
        click.echo(f"exactkf: {label}: {outcome}", err=True)
        return 2
    order = f"order {outcome.order}: " if outcome.order else ""
    why = f" ({outcome.reason})" if outcome.is_open else f"; not finished: {outcome.reason}" if outcome.reason else ""
    click.echo(f"{label}: {order}{headline(outcome)}{why}")
    return 1 if why else 0
