# SPDX-License-Identifier: MIT
"""Ctrl-C and SIGTERM around processes begun here.

A terminal sends Ctrl-C to the workers too: they leave it to the process that began them, which ends them.

Main definitions
----------------
`ctrl_c_later`
    While processes begin: they never hear of Ctrl-C, and here it waits.
`sigterm_as_ctrl_c`
    While they work.
"""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from multiprocessing import resource_tracker
from typing import Any

__all__ = ["ctrl_c_later", "sigterm_as_ctrl_c"]


@contextmanager
def ctrl_c_later() -> Iterator[None]:
    """Hold Ctrl-C back until the end of the block; processes that begin in it never hear of it."""
    came: list[tuple[Any, ...]] = []
    try:
        with _taken(signal.SIGINT, lambda *how: came.append(how)), _kept_from_processes(signal.SIGINT):
            yield
    finally:
        handler = signal.getsignal(signal.SIGINT)
        if came and callable(handler):
            handler(*came[0])


@contextmanager
def _kept_from_processes(number: int) -> Iterator[None]:
    """Block a signal in this thread, as in the processes that it begins: these inherit it, where they forget a handler.

    Other threads here are still reached, so that this alone holds nothing back.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # begun with the first process, it would undo this
    old = signal.pthread_sigmask(signal.SIG_BLOCK, {number})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, old)


@contextmanager
def sigterm_as_ctrl_c() -> Iterator[None]:
    """Take SIGTERM as Ctrl-C, so that the workers are ended at it."""
    with _taken(signal.SIGTERM, _stop):
        yield


@contextmanager
def _taken(number: int, handler: Callable[..., Any] | signal.Handlers) -> Iterator[None]:
    """Take a signal so; only the main thread can, elsewhere nothing is changed."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    old = signal.signal(number, handler)
    try:
        yield
    finally:
        signal.signal(number, old)


def _stop(*_: object) -> None:
    raise KeyboardInterrupt
