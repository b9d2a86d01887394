# SPDX-License-Identifier: MIT
"""What a search may cost: seconds of the clock, or steps of its own.

A verdict on record must not depend on how fast or how busy a processor is, so the engine has steps counted, which are as
many everywhere. Who waits for the answer about a lemma names seconds.

Main definitions
----------------
`clock`
    Seconds; within `counted` those that the steps so far would take at `_RATE` steps in a second.
`spend`, `counted`
    Count steps; let them be what `clock` tells.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager

__all__ = ["clock", "counted", "spend"]

_RATE = 500_000  # steps in a second: measured between 200,000 and 1,400,000
_steps = 0
_counting = False


def clock() -> float:
    """Time that has passed, from an arbitrary start."""
    return _steps / _RATE if _counting else time.perf_counter()


def spend(steps: int) -> None:
    """Count steps of a search."""
    global _steps
    _steps += steps


@contextmanager
def counted() -> Iterator[None]:
    """Within this, time is what is spent."""
    global _counting
    before, _counting = _counting, True
    try:
        yield
    finally:
        _counting = before
