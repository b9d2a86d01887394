# SPDX-License-Identifier: MIT
"""The command ``exactkf``.

Each command imports what it needs when it runs: ``exactkf check`` needs the
checker alone.
"""

from __future__ import annotations

import math
import os
import re
import sys
from collections.abc import Callable, Sequence
from contextlib import redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click

from exactkf import __version__
from exactkf._errors import ExactkfError
from exactkf.kernel.limits import SECONDS

__all__ = ["Setup", "main"]

INTERRUPTED = 130  # as a shell has it for Ctrl-C
UNREAD = 141  # and for a reader that went away, `exactkf list | head`: no verdict was reported, so neither 0 nor 1


@dataclass(frozen=True)
class Setup:
    """Packages that claims and engine come from; tests put others here, as ``obj`` of the command."""

    package: str = "proofs"
    engine: str = "exactkf.engine"


class _OneLine(click.Group):
    """A group whose errors are one line on stderr and exit code 2, never a traceback."""

    def main(self, *args: Any, **extra: Any) -> Any:
        with redirect_stdout(_Output(sys.stdout) if sys.stdout is not None else None):
            try:
                code = self._code(*args, **extra)
                click.echo(nl=False)  # flushes: what cannot be written is said now
            except _Unwritten as error:
                _forsake(sys.__stdout__)
                code = UNREAD if error.broken else _fail(f"standard output cannot be written ({error}); choose another place for it")
        sys.exit(code)

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except KeyboardInterrupt:  # click would begin with an empty line
            return _fail("stopped", INTERRUPTED)

    def _code(self, *args: Any, **extra: Any) -> int:
        try:
            return super().main(*args, **{**extra, "standalone_mode": False}) or 0
        except click.exceptions.NoArgsIsHelpError as error:
            click.echo(error.format_message())
            return 0
        except click.Abort:
            return _fail("stopped", INTERRUPTED)
        except click.UsageError as error:
            command = f" {error.ctx.info_name}" if error.ctx and error.ctx.parent else ""
            return _fail(f"{error.format_message().rstrip('.')}; see 'exactkf{command} --help'")
        except (click.ClickException, ExactkfError) as error:
            return _fail(error.format_message() if isinstance(error, click.ClickException) else str(error))


class _Unwritten(Exception):
    """Standard output cannot be written. No OSError: click ends with 1 at a broken pipe, which says that a claim fell short."""

    def __init__(self, error: OSError) -> None:
        super().__init__(error.strerror or str(error))
        self.broken = isinstance(error, BrokenPipeError)


class _Output:
    """Standard output whose failure is told apart from all else that the system refuses."""

    def __init__(self, stream: Any) -> None:
        self._stream = stream

    def write(self, text: str) -> int:
        try:
            return self._stream.write(text)
        except OSError as error:
            raise _Unwritten(error) from error

    def flush(self) -> None:
        try:
            self._stream.flush()
        except OSError as error:
            raise _Unwritten(error) from error

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)


def _fail(message: str, code: int = 2) -> int:
    try:
        click.echo(f"exactkf: {' '.join(message.split())}", err=True)
    except OSError:  # nobody to say it to: the exit status still does
        _forsake(sys.__stderr__)
    return code


def _forsake(stream: Any) -> None:
    """Give up what a stream still holds: the interpreter writes it at its end, and would complain."""
    if stream is not None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


class _Seconds(click.ParamType):
    name = "seconds"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        try:
            seconds = float(value)
        except ValueError:
            seconds = math.nan
        if not (math.isfinite(seconds) and seconds > 0):
            self.fail(f"{value!r} is not a number of seconds; give a finite one above 0", param, ctx)
        return seconds


class _Steps(click.ParamType):
    name = "steps"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> int:
        found = re.fullmatch(r"(\d{1,400})(?:(\^|e\+?)(\d{1,3}))?", str(value).strip().lower())
        if not found:
            self.fail(f"{value!r} is not a number of steps; give a nonnegative integer, such as 1000, 10^12 or 1e12", param, ctx)
        base, sign, power = found.groups()
        return int(base) if sign is None else int(base) ** int(power) if sign == "^" else int(base) * 10 ** int(power)


def _running(command: Callable) -> Callable:
    """Options of the commands that run claims."""
    for option in reversed([
        click.option("--jobs", "-j", type=click.IntRange(min=1), help="Worker processes [default: one per processor]."),
        click.option("--time-limit", type=_Seconds(), default=600, show_default=True, metavar="S",
                     help="Seconds for one claim; past them it is open."),
        click.option("--memory-limit", type=click.IntRange(min=1), metavar="MB", help="Address space of one worker."),
        click.option("--state", type=click.Path(path_type=Path), metavar="DIR",
                     help="Folder of results kept between runs [default: $EXACTKF_STATE or .exactkf]."),
        click.option("--seed", type=click.IntRange(min=0), default=0, show_default=True,
                     help="Seed of random instances."),
    ]):
        command = option(command)
    return command


@click.group(cls=_OneLine, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(__version__, prog_name="exactkf")
@click.pass_context
def main(ctx: click.Context) -> None:
    """Exact verification of the mathematics of Kalman filter dynamics, with certificates."""
    ctx.obj = ctx.obj or Setup()


@main.command(short_help="Verify claims and compare with the verdicts on record.")
@click.argument("words", metavar="[ID|KEY|KEY/section]...", nargs=-1)
@_running
@click.option("--json", "json_file", type=click.Path(path_type=Path), metavar="FILE", help="Write the results as JSON.")
@click.option("--certificates", type=click.Path(path_type=Path), metavar="DIR", help="Put the certificates there.")
@click.option("--fresh", is_flag=True, help="Run everything again, whatever is kept.")
@click.option("--record", "recording", is_flag=True, help="Enter the results in the record of verdicts.")
@click.pass_obj
def verify(setup: Setup, words: Sequence[str], json_file: Path | None, certificates: Path | None, fresh: bool,
           recording: bool, **how: Any) -> int:
    """Verify claims, all of them by default, and compare with the verdicts on record.

    Exit status: 0 if each reaches its record, 1 if one falls short, 2 if the call is wrong.
    """
    from exactkf.commands import Session, verify_command

    return verify_command(Session.open(setup, words, how), json_file, certificates, fresh, recording)


@main.command(short_help="Replay certificates, with the checker alone.")
@click.argument("paths", metavar="PATH...", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--time-limit", type=_Seconds(), default=SECONDS, show_default=True, metavar="S", help="Seconds for one certificate; past them it is refused.")
@click.option("--code", is_flag=True, help="List the functions of the checker that ran: what to read to trust the replay.")
def check(paths: Sequence[Path], time_limit: float, code: bool) -> int:
    """Replay certificates: files, or all .json files of folders.

    Exit status: 0 if every one replays, 1 if one does not, 2 if one is no certificate.
    """
    from exactkf.check import check_paths

    return check_paths(paths, time_limit, code=code)


@main.command(short_help="Show a claim: statement, verdict, what was checked.")
@click.argument("id")
@_running
@click.pass_obj
def show(setup: Setup, id: str, **how: Any) -> int:
    """Show a claim: statement, verdict, what was checked, and the correction where it fails."""
    from exactkf.commands import Session, show_command

    return show_command(Session.open(setup, [id], how))


@main.command(short_help="Prove a lemma for every matrix size, or refute it.")
@click.argument("file", metavar="FILE", type=click.Path(path_type=Path))
@click.option("--json", "json_file", type=click.Path(path_type=Path), metavar="FILE", help="Write the outcome as JSON.")
@click.option("--certificates", type=click.Path(path_type=Path), metavar="DIR", help="Put the certificates there.")
@click.option("--time-limit", type=_Seconds(), default=60, show_default=True, metavar="S", help="Seconds; past them the lemma is open.")
@click.option("--degree", type=click.IntRange(min=1), default=8, show_default=True, metavar="N",
              help="Longest word that the completion of the assumptions looks at.")
@click.option("--seed", type=click.IntRange(min=0), default=0, show_default=True, help="Seed of random instances.")
def lemma(file: Path, json_file: Path | None, certificates: Path | None, time_limit: float, degree: int, seed: int) -> int:
    """Prove a lemma of your own for every matrix size, or refute it by explicit matrices.

    FILE is a text in the grammar that 'python -m pydoc exactkf.lemma.grammar' shows.

    Exit status: 0 if it is proved, 1 if it is refuted or open, 2 if the call or the file is wrong.
    """
    from exactkf.lemma.command import lemma_command

    return lemma_command(file, json_file, certificates, time_limit, degree, seed)


@main.command("list")
@click.argument("words", metavar="[ID|KEY|KEY/section]...", nargs=-1)
@click.pass_obj
def list_(setup: Setup, words: Sequence[str]) -> int:
    """List claims with their verdicts on record."""
    from exactkf.commands import list_command

    return list_command(setup, words)


@main.command(short_help="Show wrong neighbours of claims and how each was caught.")
@click.argument("words", metavar="[ID|KEY|KEY/section]...", nargs=-1)
@_running
@click.pass_obj
def mutate(setup: Setup, words: Sequence[str], **how: Any) -> int:
    """Show the wrong neighbours of claims and whether the evidence rejects each."""
    from exactkf.commands import Session, mutate_command

    return mutate_command(Session.open(setup, words, how))


@main.command(short_help="Write one HTML page with every claim.")
@click.argument("words", metavar="[ID|KEY|KEY/section]...", nargs=-1)
@_running
@click.option("-o", "--output", type=click.Path(path_type=Path), default=Path("exactkf-report.html"), show_default=True,
              metavar="FILE", help="Where to write the page.")
@click.option("--kept", is_flag=True, help="Run nothing: show what is kept, the rest as open.")
@click.pass_obj
def report(setup: Setup, words: Sequence[str], output: Path, kept: bool, **how: Any) -> int:
    """Write one HTML page with every claim; what is not kept from an earlier run is run."""
    from exactkf.commands import Session, report_command

    return report_command(Session.open(setup, words, how), output, kept)


@main.command(short_help="Decide what the gain of a filter does, or of many.")
@click.argument("files", metavar="[FILE]...", nargs=-1, type=click.Path(path_type=Path))
@click.option("--alpha", help="Coordinates alpha_1, ..., alpha_n, separated by commas.")
@click.option("--gamma", help="Schur parameters gamma_0, ..., gamma_{n-1}.")
@click.option("--a", help="With --g: a_1, ..., a_n. With --b: all coefficients of a(z), leading one first.")
@click.option("--g", help="The vector g_1, ..., g_n.")
@click.option("--b", help="All coefficients of b(z), leading one first; v = b/(2a).")
@click.option("--covariances", help="1, c_1, c_2, ...")
@click.option("--pi0", help="Order one: decide the Riccati equation started there.")
@click.option("--after", type=_Steps(), metavar="T", help="Also the state after T steps, such as 10^12, without stepping.")
@click.option("--digits", type=click.IntRange(min=1, max=100000), default=20, show_default=True, help="Decimal digits of numbers shown.")
@click.option("--json", "json_file", type=click.Path(path_type=Path), metavar="FILE", help="Write the answer as JSON.")
@click.option("--certificate", type=click.Path(path_type=Path), metavar="FILE",
              help="Write the certificate, for 'exactkf check'; many filters: a folder.")
@click.option("--latex", "latex_file", type=click.Path(path_type=Path), metavar="FILE", help="Write the derivation as LaTeX.")
@click.option("--picture", "pictures", multiple=True, metavar="KIND=FILE",
              help="Draw plane, gamma, alpha or spectrum as .png or .svg; may be repeated.")
@click.option("--steps", type=click.IntRange(min=1, max=10000), default=60, show_default=True, help="Steps of the orbit in pictures.")
@click.option("--time-limit", type=_Seconds(), default=60, show_default=True, metavar="S",
              help="Seconds for a filter; what is not found by then is said to be open.")
@click.option("--jobs", "-j", type=click.IntRange(min=1), help="Many filters: worker processes [default: one per processor].")
def analyze(files: Sequence[Path], **how: Any) -> int:
    """Decide what the gain of a filter does: converge, escape, repeat or wander.

    The filter comes in a .toml or .json FILE or in options. Numbers are fractions, decimals taken exactly,
    sqrt(2), cos(2*pi/7), root(x^3 - 2, 1, 2) and what + - * / ^ make of them.

    Many filters come in several files, or in one: .jsonl with an object a line, .csv with columns such as alpha_1, alpha_2, gamma_0,
    gamma_1, a list in .json, or [[filter]] in .toml. Each is answered in a line; --json FILE.jsonl writes an object a line.

    Exit status: 0 if every orbit is decided and all that was asked for is found, 1 if not, 2 if the call is wrong or a filter is refused.
    """
    from exactkf.dynamics.command import analyze_command

    return analyze_command(files, **how)
