# SPDX-License-Identifier: MIT
"""Worker processes that can be killed.

Long exact calls cannot be interrupted from inside, so a time limit is a
process that is ended from outside. A task carries an id and a seed and comes
back as plain JSON; the worker imports the claims for itself.

Main definitions
----------------
`Options`
    How to run: workers, limits, seed.
`work`
    One function of the engine on many claims.
`unfinished`
    The result of a claim that did not come to an end.
"""

from __future__ import annotations

import gc
import importlib
import os
import sys
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, TimeoutError
from dataclasses import dataclass
from functools import cache
from typing import Any

from pebble import ProcessExpired

from exactkf.claims import Claim, load
from exactkf.pool import PoolBroken, Tasks

__all__ = ["Options", "default_jobs", "unfinished", "work"]


def default_jobs() -> int:
    """Number of processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


@dataclass(frozen=True)
class Options:
    """How to run.

    Parameters
    ----------
    jobs : int
        Worker processes.
    time_limit : float, optional
        Seconds for one claim; a claim that takes longer is ended and is `open`.
    memory_limit : int, optional
        Megabytes of address space for one worker, where the system can limit it.
    seed : int
        For random instances.
    package, engine : str
        Modules that the claims and the engine are imported from.
    """

    jobs: int = 1
    time_limit: float | None = None
    memory_limit: int | None = None
    seed: int = 0
    package: str = "proofs"
    engine: str = "exactkf.engine"


def work(function: str, claims: Sequence[Claim], options: Options,
         idle: Callable[[], None] | None = None) -> Iterator[tuple[Claim, dict[str, Any]]]:
    """Call ``function(claim, seed=...)`` of the engine on each claim, in workers; pairs as they come.

    A worker that dies before its task is under way takes the pool with it. Each claim that was
    running then goes into a pool of its own, where it can only hurt itself.
    """
    tasks: Tasks[Claim] = Tasks(_task, lambda claim: (function, claim.id, options), _prepare, (options.package, options.engine, options.memory_limit),
                  time_limit=options.time_limit)

    def outcomes(waiting: deque[Claim]) -> Iterator[tuple[Claim, dict[str, Any]]]:
        for claim, future in tasks.ended(waiting, min(options.jobs, len(waiting)), idle):
            yield claim, _outcome(claim, future, options)

    waiting = deque(claims)
    while waiting:
        try:
            yield from outcomes(waiting)
        except PoolBroken as broken:
            for claim in broken.left:
                try:
                    yield from outcomes(deque([claim]))
                except PoolBroken:
                    yield claim, unfinished(claim, "crashed: the worker ended")


def _outcome(claim: Claim, future: Future, options: Options) -> dict[str, Any]:
    """What a worker returned, or why it did not."""
    try:
        return future.result()
    except TimeoutError:
        return unfinished(claim, f"out of time after {options.time_limit:g} s", options.time_limit or 0.0)
    except MemoryError:
        return unfinished(claim, _out_of_memory(options))
    except ProcessExpired as error:
        # when memory runs out, the exact arithmetic ends the process (signal 6), the interpreter does (1), the system does (signal 9)
        if error.exitcode == -9 or (error.exitcode in (-6, 1) and options.memory_limit):
            return unfinished(claim, _out_of_memory(options))
        return unfinished(claim, f"crashed: the worker ended with exit code {error.exitcode}")
    except Exception as error:
        return unfinished(claim, f"crashed: {type(error).__name__}: {' '.join(str(error).split())}")


def _out_of_memory(options: Options) -> str:
    return "out of memory" + (f" ({options.memory_limit} MB)" if options.memory_limit else "")


def unfinished(claim: Claim, reason: str, seconds: float = 0.0) -> dict[str, Any]:
    """The result of a claim that did not come to an end: `open`, never reused."""
    from exactkf.language.latex import given_latex, over_latex, says_latex, where_latex

    printed = claim.statement
    return {
        "id": claim.id, "paper": claim.paper, "section": claim.section, "title": claim.title, "note": claim.note,
        "verdict": "open", "strength": None, "sizes": None, "reason": reason, "repair": None,
        "statement_latex": says_latex(printed) if printed else "",
        "over_latex": over_latex(printed) if printed else [], "where_latex": where_latex(printed) if printed else [],
        "given_latex": given_latex(printed) if printed else [],
        "certificates": [], "mutants": {"made": 0, "rejected": 0, "equal": 0, "survivors": []},
        "neighbours": {"made": 0, "accepted": 0}, "checks": 0, "seconds": seconds, "witness": None,
        "counterexample": None, "evidence": [], "denominators": [], "unfinished": True,
    }


# ---------------------------------------------------------------------- in the worker
def _prepare(package: str, engine: str, memory_limit: int | None) -> None:
    """Import everything first, so that a task's time is its own."""
    _claims(package)
    importlib.import_module(engine)
    gc.collect()
    gc.freeze()  # what was imported stays: the collector need not look at it again
    gc.set_threshold(100_000)  # and seldom at what a claim makes: a twentieth of a run
    if memory_limit:
        try:
            import resource
        except ImportError:
            return  # the system has no such limit
        size = memory_limit * 2**20
        hard = resource.getrlimit(resource.RLIMIT_AS)[1]
        sys.stderr = open(os.devnull, "w")  # noqa: SIM115  what an interpreter without memory says last; the result says it in one line
        resource.setrlimit(resource.RLIMIT_AS, (size if hard == resource.RLIM_INFINITY else min(size, hard), hard))


@cache
def _claims(package: str) -> dict[str, Claim]:
    return load(package)


def _task(function: str, id: str, options: Options) -> dict[str, Any]:
    claim = _claims(options.package)[id]
    return getattr(importlib.import_module(options.engine), function)(claim, seed=options.seed)
