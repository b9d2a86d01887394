# SPDX-License-Identifier: MIT
"""Running claims in worker processes that can be killed.

Long exact calls cannot be interrupted from inside, so a time limit is a
process that is ended from outside. A task carries an id and a seed and comes
back as plain JSON; the worker imports the claims for itself.

Main definitions
----------------
`Options`
    How to run: workers, limits, seed.
`run`
    Results as they come: those kept from an earlier run first.
`work`
    One function of the engine on many claims, without the store.
"""

from __future__ import annotations

import importlib
import multiprocessing
import os
import queue
import signal
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future, TimeoutError
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from typing import Any

from pebble import ProcessExpired, ProcessPool

from exactkf.claims import Claim, load
from exactkf.store import Store, claim_key

__all__ = ["Options", "default_jobs", "run", "unfinished", "work"]

_HEARTBEAT = 0.5  # seconds; a wait without end could not be interrupted on every system


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


def run(claims: Sequence[Claim], registry: Mapping[str, Claim], options: Options, store: Store, *,
        fresh: bool = False, idle: Callable[[], None] | None = None) -> Iterator[dict[str, Any]]:
    """Results of the claims, in the order in which they come.

    Parameters
    ----------
    claims : sequence of Claim
        What to run.
    registry : mapping of id to Claim
        All claims; a claim may lean on others.
    options : Options
    store : Store
        Results found there are not run again.
    fresh : bool
        Run everything all the same.
    idle : callable, optional
        Called now and then while nothing comes.

    Yields
    ------
    dict
        A result of the engine, its certificates as names of files in the state folder.
    """
    keys = {c.id: claim_key(c, registry, options.seed) for c in claims}
    pending = []
    for claim in claims:
        kept = None if fresh else store.get(keys[claim.id])
        if kept is None:
            pending.append(claim)
        else:
            yield {**kept, "reused": True}
    for claim, result in work("verify_claim", pending, options, idle):
        yield store.put(keys[claim.id], result)


def work(function: str, claims: Sequence[Claim], options: Options,
         idle: Callable[[], None] | None = None) -> Iterator[tuple[Claim, dict[str, Any]]]:
    """Call ``function(claim, seed=...)`` of the engine on each claim, in workers; pairs as they come."""
    if not claims:
        return
    finished: queue.SimpleQueue[Future] = queue.SimpleQueue()
    # a fresh interpreter: forking a process that runs threads (a progress display has one) can hang
    pool = ProcessPool(
        max_workers=min(options.jobs, len(claims)), context=multiprocessing.get_context("spawn"),
        initializer=_prepare, initargs=(options.package, options.engine, options.memory_limit))
    try:
        # a terminal sends Ctrl-C to the workers too: those begun here ignore it, and the pool ends them
        with _signals({signal.SIGINT: signal.SIG_IGN}):
            tasks = {_scheduled(pool, function, c, options, finished): c for c in claims}
        pool.close()
        with _signals({signal.SIGTERM: _stop}):
            while tasks:
                try:
                    future = finished.get(timeout=_HEARTBEAT)
                except queue.Empty:
                    if idle:
                        idle()
                    continue
                claim = tasks.pop(future)
                yield claim, _outcome(claim, future, options)
    finally:
        pool.stop()
        pool.join()


def _scheduled(pool: ProcessPool, function: str, claim: Claim, options: Options, finished: queue.SimpleQueue) -> Future:
    future: Future = pool.schedule(_task, args=(function, claim.id, options), timeout=options.time_limit)
    future.add_done_callback(finished.put)
    return future


@contextmanager
def _signals(changes: Mapping[int, Any]) -> Iterator[None]:
    """Handle signals otherwise for a while; only the main thread can."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    old = {number: signal.signal(number, handler) for number, handler in changes.items()}
    try:
        yield
    finally:
        for number, handler in old.items():
            signal.signal(number, handler)


def _stop(*_: object) -> None:
    raise KeyboardInterrupt


def _outcome(claim: Claim, future: Future, options: Options) -> dict[str, Any]:
    """What a worker returned, or why it did not."""
    try:
        return future.result()
    except TimeoutError:
        return unfinished(claim, f"out of time after {options.time_limit:g} s", options.time_limit or 0.0)
    except MemoryError:
        return unfinished(claim, _out_of_memory(options))
    except ProcessExpired as error:
        # the exact arithmetic ends the process (signal 6) when memory runs out, the system does with signal 9
        if error.exitcode == -9 or (error.exitcode == -6 and options.memory_limit):
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
    if memory_limit:
        try:
            import resource
        except ImportError:
            return  # the system has no such limit
        size = memory_limit * 2**20
        hard = resource.getrlimit(resource.RLIMIT_AS)[1]
        resource.setrlimit(resource.RLIMIT_AS, (size if hard == resource.RLIM_INFINITY else min(size, hard), hard))


@cache
def _claims(package: str) -> dict[str, Claim]:
    return load(package)


def _task(function: str, id: str, options: Options) -> dict[str, Any]:
    claim = _claims(options.package)[id]
    return getattr(importlib.import_module(options.engine), function)(claim, seed=options.seed)
