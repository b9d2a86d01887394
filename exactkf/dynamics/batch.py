# SPDX-License-Identifier: MIT
"""What ``exactkf analyze`` does with many filters: a line for each as soon as it is decided, and files."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from exactkf.dynamics.answer import BEHAVIOURS, Answer
from exactkf.dynamics.many import Outcome, outcomes
from exactkf.dynamics.shown import headline
from exactkf.files import check_folder, check_target, dump_json, reaching, write_text
from exactkf.progress import Meter

__all__ = ["batch_command"]


def batch_command(filters: Sequence[tuple[str, dict[str, Any]]], *, jobs: int, time_limit: float, json_file: Path | None, certificate: Path | None) -> int:
    """Decide, print, write; exit status 0, 2 if a filter is refused, else 1 if something is undecided or not all that is asked for was found.

    Parameters
    ----------
    filters : sequence of (label, data)
        As `exactkf.dynamics.files.read_filters` returns them.
    jobs, time_limit
        As `exactkf.dynamics.many.decide_many` has them.
    json_file : Path, optional
        For the answers without their certificates and structures: an object a line if it ends in .jsonl, a list otherwise.  If the call is
        stopped, those that are decided by then.
    certificate : Path, optional
        A folder for the certificates, numbered as the filters are.
    """
    if json_file is not None:
        check_target(json_file, "--json")
    if certificate is not None:
        check_folder(certificate, "--certificate")
        with reaching("--certificate", certificate):
            certificate.mkdir(parents=True, exist_ok=True)
    asked = ("facts", "limit", "rate", "slow") * (json_file is not None) + ("certificate",) * (certificate is not None)
    records, seen, status = list[dict[str, Any]](), Counter[str](), 0
    with Meter("analyze", len(filters)) as meter:
        found = outcomes([data for _, data in filters], jobs=jobs, time_limit=time_limit, asked=asked, idle=meter.tick)
        try:
            for k, ((label, _), outcome) in enumerate(zip(filters, found, strict=True)):
                if certificate is not None and isinstance(outcome, Answer) and outcome.certificate:
                    path = certificate / f"{k + 1:0{len(str(len(filters)))}}.json"
                    with reaching("--certificate", path):
                        write_text(path, dump_json(outcome.certificate))
                if json_file is not None:
                    records.append(_record(label, outcome))
                seen[outcome.behaviour if isinstance(outcome, Answer) else "refused"] += 1
                status = max(status, _said(label, outcome))  # said last: what is printed is kept, whenever Ctrl-C comes
                meter.step(label)
        except KeyboardInterrupt:  # what is decided by then is kept
            _write(json_file, records)
            raise
    _write(json_file, records)
    click.echo(f"{len(filters)} filter{'s' * (len(filters) != 1)}: " + "; ".join(f"{x} {seen[x]}" for x in (*BEHAVIOURS, "refused") if seen[x]), err=True)
    return status


def _write(json_file: Path | None, records: list[dict[str, Any]]) -> None:
    """The records as lines, or as a list."""
    if json_file is not None:
        lines = json_file.suffix.lower() == ".jsonl"
        with reaching("--json", json_file):
            write_text(json_file, "".join(dump_json(x, indent=None) for x in records) if lines else dump_json(records))


def _said(label: str, outcome: Outcome) -> int:
    """Print one line; return the exit status that it asks for."""
    if not isinstance(outcome, Answer):
        click.echo(f"exactkf: {label}: {outcome}", err=True)
        return 2
    order = f"order {outcome.order}: " if outcome.order else ""
    why = f" ({outcome.reason})" if outcome.is_open else f"; not finished: {outcome.reason}" if outcome.reason else ""
    click.echo(f"{label}: {order}{headline(outcome)}{why}")
    return 1 if why else 0


def _record(label: str, outcome: Outcome) -> dict[str, Any]:
    if not isinstance(outcome, Answer):
        return {"filter": label, "error": str(outcome)}
    data = {**outcome.without_certificate(), "limit": outcome.limit, "rate": outcome.rate, "slow": outcome.slow}
    del data["certificate"], data["structure"]
    return {"filter": label, **data}
