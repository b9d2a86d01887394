# SPDX-License-Identifier: MIT
"""Tasks in worker processes that can be killed, yielded as they end.

Main definitions
----------------
`Tasks`
    What is run on each item, and where.
`PoolBroken`
    A worker died before its task was under way and took the pool with it.
"""

from __future__ import annotations

import multiprocessing
import queue
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from typing import Any, Generic, TypeVar

from pebble import ProcessPool

from exactkf.signals import ctrl_c_later, sigterm_as_ctrl_c

__all__ = ["PoolBroken", "Tasks"]

_HEARTBEAT = 0.5  # seconds; a wait without end could not be interrupted on every system

T = TypeVar("T")


class PoolBroken(Exception, Generic[T]):
    """The pool ended; `left` are the items that were running, or the next one, and have no result."""

    def __init__(self, left: list[T]) -> None:
        super().__init__("the worker processes ended")
        self.left = left


@dataclass(frozen=True)
class Tasks(Generic[T]):
    """What is run on each item.

    Parameters
    ----------
    function : callable
        Of a module, so that another process finds it.
    arguments : callable
        From an item to the arguments of the function, plain data.
    prepare, prepared : callable, tuple
        Called in each worker first, with these arguments.
    time_limit : float, optional
        Seconds after which the worker of a task is ended.
    forks : bool
        Copy this process instead of starting an interpreter: quicker, but a process that runs threads (a progress display has one) can hang.
    """

    function: Callable[..., Any]
    arguments: Callable[[T], tuple[Any, ...]]
    prepare: Callable[..., None]
    prepared: tuple[Any, ...]
    time_limit: float | None = None
    forks: bool = False

    def ended(self, waiting: deque[T], jobs: int, idle: Callable[[], None] | None = None) -> Iterator[tuple[T, Future]]:
        """Each item with its finished task, in the order they end; more may be put into the queue meanwhile.

        Parameters
        ----------
        waiting : deque
            Items are taken from its left end.
        jobs : int
            Worker processes.
        idle : callable, optional
            Called when nothing has come for half a second.

        Raises
        ------
        PoolBroken
        """
        finished: queue.SimpleQueue[Future] = queue.SimpleQueue()
        running: dict[Future, T] = {}
        pool = ProcessPool(max_workers=jobs, context=multiprocessing.get_context("fork" if self.forks else "spawn"),
                           initializer=self.prepare, initargs=self.prepared)
        try:
            with ctrl_c_later():
                _ = pool.active  # asking starts it
            with sigterm_as_ctrl_c():
                while pool.active and (waiting or running):
                    self._fill(pool, waiting, running, jobs, finished)
                    try:
                        task = finished.get(timeout=_HEARTBEAT)
                    except queue.Empty:
                        if idle:
                            idle()
                        continue
                    if not isinstance(task.exception(), BrokenProcessPool):
                        yield running.pop(task), task
            # a pool that broke before its first task makes the next item a suspect, so that there is progress
            if left := list(running.values()) or ([waiting.popleft()] if waiting else []):
                raise PoolBroken(left)
        finally:
            pool.stop()
            pool.join()

    def _fill(self, pool: ProcessPool, waiting: deque[T], running: dict[Future, T], jobs: int, finished: queue.SimpleQueue[Future]) -> None:
        """One task more than there are workers, so that none has to wait for its next one."""
        while waiting and len(running) <= jobs:
            item = waiting.popleft()
            try:
                task: Future = pool.schedule(self.function, self.arguments(item), timeout=self.time_limit)
            except RuntimeError:  # it broke just now
                raise PoolBroken([*running.values(), item]) from None
            running[task] = item
            task.add_done_callback(finished.put)
