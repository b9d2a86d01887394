# SPDX-License-Identifier: MIT
"""Ctrl-C and SIGTERM around processes begun here."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager

__all__ = ["terminal_signals"]


@contextmanager
def terminal_signals(*, ignored: bool) -> Iterator[None]:
    """Ignore Ctrl-C while processes begin, which inherit it; or, afterwards, take SIGTERM as Ctrl-C.

    A terminal sends Ctrl-C to the workers too: they leave it to the process that began them, which ends them.
    Only the main thread can change how signals are taken; elsewhere nothing is changed.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    number, handler = (signal.SIGINT, signal.SIG_IGN) if ignored else (signal.SIGTERM, _stop)
    old = signal.signal(number, handler)
    try:
        yield
    finally:
        signal.signal(number, old)


def _stop(*_: object) -> None:
    raise KeyboardInterrupt
