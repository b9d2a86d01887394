# SPDX-License-Identifier: MIT
"""Progress on stderr."""

from __future__ import annotations

import sys
import time

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

__all__ = ["Meter"]

_EVERY = 30.0  # seconds between lines where there is no terminal


class Meter:
    """Progress on stderr: a bar on a terminal, else a line now and then.

    Parameters
    ----------
    what : str
        What is being done, ``"verify"``.
    total : int
        Number of steps.
    """

    def __init__(self, what: str, total: int) -> None:
        self.what, self.total, self.done, self.last = what, total, 0, ""
        self._spoke = time.monotonic()
        self._bar: Progress | None = None
        if sys.stderr.isatty():
            self._bar = Progress(
                TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(),
                TextColumn("{task.fields[last]}"), console=Console(stderr=True), transient=True,
                redirect_stdout=sys.stdout.isatty())  # lines go above the bar, but never into it what is kept in a file
            self._task = self._bar.add_task(what, total=total, last="")

    def __enter__(self) -> Meter:
        if self._bar:
            self._bar.start()
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar:
            self._bar.stop()

    def step(self, last: str) -> None:
        """One more is done, the one named."""
        self.done, self.last = self.done + 1, last
        if self._bar:
            self._bar.update(self._task, advance=1, last=last)
        else:
            self.tick()

    def tick(self) -> None:
        """Speak if there is no terminal and nothing was said for a while."""
        if self._bar is None and time.monotonic() - self._spoke >= _EVERY:
            self._spoke = time.monotonic()
            last = f", last {self.last}" if self.last else ""
            print(f"{self.what}: {self.done} of {self.total} done{last}", file=sys.stderr, flush=True)
