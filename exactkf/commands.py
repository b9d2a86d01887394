# SPDX-License-Identifier: MIT
"""What the commands do that need the claims."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click

from exactkf._errors import BadInput
from exactkf.claims import Claim, find, load
from exactkf.cli import INTERRUPTED, Setup
from exactkf.describe import describe_claim, instance_lines, not_wrong
from exactkf.display import column_of, describe, summary
from exactkf.files import check_folder, check_target, dump_json, reaching, write_text
from exactkf.output import contract, export_certificates
from exactkf.progress import Meter
from exactkf.record import NOT_ON_RECORD, Record, record_files
from exactkf.run import run
from exactkf.store import Store, claim_key, state_folder
from exactkf.workers import Options, default_jobs, unfinished, work

__all__ = ["Session", "list_command", "mutate_command", "report_command", "show_command", "verify_command"]


@dataclass(frozen=True)
class Session:
    """The claims asked for, and how to run them."""

    setup: Setup
    registry: Mapping[str, Claim]
    chosen: Sequence[Claim]
    options: Options
    store: Store

    @classmethod
    def open(cls, setup: Setup, words: Sequence[str], how: Mapping[str, Any]) -> Session:
        """Find the claims and the kept results; refuse what cannot be."""
        registry = load(setup.package)
        options = Options(how["jobs"] or default_jobs(), how["time_limit"], how["memory_limit"], how["seed"],
                          setup.package, setup.engine)
        return cls(setup, registry, find(words, registry), options, Store(state_folder(how["state"])))

    def results(self, *, fresh: bool = False) -> list[dict[str, Any]]:
        """Run what is not kept; results in reading order.

        A stopped run says how to go on.
        """
        results: dict[str, dict[str, Any]] = {}
        try:
            with Meter("verify", len(self.chosen)) as meter:
                for result in run(self.chosen, self.registry, self.options, self.store, fresh=fresh, idle=meter.tick):
                    results[result["id"]] = result
                    meter.step(result["id"])
        except KeyboardInterrupt:
            again = "the same command without --fresh" if fresh else "the same command"
            click.echo(f"exactkf: stopped; {len(results)} of {len(self.chosen)} results are kept in "
                       f"{str(self.store.folder)!r}: {again} goes on from there", err=True)
            raise click.exceptions.Exit(INTERRUPTED) from None
        return [results[c.id] for c in self.chosen]

    def kept(self, claim: Claim) -> dict[str, Any] | None:
        """What an earlier run found for a claim."""
        return self.store.get(claim_key(claim, self.registry, self.options.seed), unfinished=True)


def verify_command(session: Session, json_file: Path | None, certificates: Path | None, fresh: bool,
                   recording: bool) -> int:
    """Run, write what was asked for, and say what fell short."""
    package = session.setup.package
    if json_file:
        check_target(json_file, "--json")
    if certificates:
        check_folder(certificates, "--certificates")
    if recording:
        record_files(package)
    record = Record.read(package)
    results = session.results(fresh=fresh)
    _write(session, results, json_file, certificates)
    summary(results)
    reused = sum(bool(r.get("reused")) for r in results)
    if reused:
        click.echo(f"{reused} of {len(results)} results are from an earlier run; --fresh runs them again")
    if recording:
        for change in [*record.update(results), *(f"{id}: is no claim any more" for id in record.gone(session.registry))]:
            click.echo(f"record: {change}")
        record.write(session.registry, package)
        return 0
    short = [(r["id"], why) for r in results if (why := record.shortfall(r))]
    found = {r["id"]: r for r in results}
    lost = record.gone(session.registry) if len(session.chosen) == len(session.registry) else []
    for id in lost:
        click.echo(f"fell short: {id}: is on record, and no module of claims has it; put it back, or drop it with --record")
    for id, why in short:
        click.echo(f"fell short: {id}: {why}" + (f"; this run: {describe(found[id])}" if why == NOT_ON_RECORD else ""))
    if any(why == NOT_ON_RECORD for _, why in short):
        click.echo("--record enters what a run finds")
    click.echo(f"{len(results) - len(short)} of {len(results)} claims reached what is on record")
    return 1 if short or lost else 0


def _write(session: Session, results: Sequence[dict[str, Any]], json_file: Path | None,
           certificates: Path | None) -> None:
    state = session.store.folder
    files = {r["id"]: [state / c for c in r["certificates"]] for r in results}
    if certificates:
        with reaching("--certificates", certificates):
            files = export_certificates(results, state, certificates)
    if json_file:
        home = json_file.absolute().parent
        names = {id: [Path(os.path.relpath(f, home)).as_posix() for f in paths] for id, paths in files.items()}
        with reaching("--json", json_file):
            write_text(json_file, dump_json(contract(results, session.registry, names)))


def show_command(session: Session) -> int:
    """Show one claim, running it if nothing is kept."""
    if len(session.chosen) != 1:
        raise BadInput(f"argument ID = {session.chosen[0].paper!r} names {len(session.chosen)} claims; "
                       "name one, see 'exactkf list'")
    claim = session.chosen[0]
    click.echo(describe_claim(claim, session.kept(claim) or session.results()[0]))
    return 0


def list_command(setup: Setup, words: Sequence[str]) -> int:
    """One line a claim."""
    record = Record.read(setup.package)
    chosen = find(words, load(setup.package))
    width = max((len(c.id) for c in chosen), default=0)
    for claim in chosen:
        entry = record.entries.get(claim.id)
        standing = describe(entry) + (", corrected" if column_of(entry) == "corrected" else "") if entry else "not on record"
        click.echo(f"{claim.id:{width}}  {standing:24}  {claim.title}")
    return 0


def mutate_command(session: Session) -> int:
    """The mutants of each claim; 1 if one survives."""
    survived = 0
    total: dict[str, int] = {}
    with Meter("mutate", len(session.chosen)) as meter:
        for claim, result in work("mutate_claim", session.chosen, session.options, meter.tick):
            rows = result.get("rows", [])
            click.echo(f"{claim.id}: {_counted(result, rows) if rows else _no_mutants(result)}")
            for row in rows:
                total[row["outcome"]] = total.get(row["outcome"], 0) + 1
                click.echo(f"  {row['outcome']:9} {row['kind']}: {row['text']}")
                if row.get("instance"):
                    click.echo(f"  {'':9}   false at {'; '.join(instance_lines(row['instance']))}")
            survived += sum(row["outcome"] == "survived" for row in rows)
            meter.step(claim.id)
    click.echo(f"in all: {', '.join(f'{n} {outcome}' for outcome, n in sorted(total.items())) or 'no mutants'}")
    return 1 if survived else 0


def _counted(result: Mapping[str, Any], rows: Sequence[Mapping[str, Any]]) -> str:
    rejected = sum(r["outcome"] == "rejected" for r in rows)
    return f"{rejected} of {len(rows)} mutants rejected{not_wrong(result)}"


def _no_mutants(result: Mapping[str, Any]) -> str:
    return f"no mutants, {result['verdict']}" + (f" ({result['reason']})" if result.get("reason") else "")


def report_command(session: Session, output: Path, kept: bool) -> int:
    """Write the page."""
    from exactkf.report import write_report

    check_target(output, "--output")
    if kept:
        results = [session.kept(c) or unfinished(c, "not run; 'exactkf verify' runs it") for c in session.chosen]
    else:
        results = session.results()
    with reaching("--output", output):
        write_report(results, session.registry, output, session.setup.package)
    click.echo(f"wrote {output}")
    return 0
