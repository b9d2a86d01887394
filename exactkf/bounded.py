# SPDX-License-Identifier: MIT
"""One long computation in a process of its own, which reports as it goes and can be ended.

Main definitions
----------------
`bounded`
    Run a function to its end, or to a time limit, or to Ctrl-C.
`OutOfTime`, `Ended`
    What it raises if there is no end.
`how_it_ended`
    An exit code in words.
"""

from __future__ import annotations

import contextlib
import math
import multiprocessing
import signal
import time
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any

from exactkf._errors import ExactkfError
from exactkf.signals import ctrl_c_later, sigterm_as_ctrl_c

__all__ = ["Ended", "OutOfTime", "bounded", "how_it_ended"]

_HEARTBEAT = 0.5
_STARTING = 60  # seconds that an interpreter may take to begin
_GRACE = 5  # seconds after which an abandoned process ends itself


class OutOfTime(Exception):
    """The time limit has passed."""


class Ended(Exception):
    """The process ended without a result; the message says how."""


def bounded(function: Callable[[Any, Callable[[Any], None]], None], request: Any, seconds: float,
            heard: Callable[[Any], None], idle: Callable[[], None]) -> None:
    """Call ``function(request, tell)`` in a fresh interpreter; what it tells is heard here, in order.

    Parameters
    ----------
    function : callable
        Of a module, so that the other process finds it.
    request : object
        Plain data.
    seconds : float
        So many after the function has begun the process is ended, whatever it is doing.
    heard, idle : callables
        Called with each message, and when nothing has come for half a second.

    Raises
    ------
    OutOfTime, Ended
    ExactkfError
        What the function raised.
    KeyboardInterrupt
        The process is ended first; so it is at SIGTERM.
    """
    until = time.monotonic() + seconds + _STARTING
    # a fresh interpreter: forking a process that runs threads (a progress display has one) can hang
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=_run, args=(function, request, theirs, seconds), daemon=True)
    try:
        with ctrl_c_later():
            process.start()
        theirs.close()
        with sigterm_as_ctrl_c():
            while True:
                left = until - time.monotonic()
                if left <= 0:
                    raise OutOfTime
                if not ours.poll(min(left, _HEARTBEAT)):
                    idle()
                    continue
                kind, value = ours.recv()
                if kind == "begun":
                    until = time.monotonic() + seconds
                elif kind == "told":
                    heard(value)
                elif kind == "raised":
                    raise value
                else:
                    return
    except EOFError:
        process.join()
        raise Ended(how_it_ended(process.exitcode)) from None
    finally:
        if process.pid is not None:  # it began
            process.kill()
            process.join()
        ours.close()


def how_it_ended(code: int | None) -> str:
    """What an exit code says of a process that did not return."""
    # the system ends a process with signal 9 when memory runs out, exact arithmetic itself with signal 6
    return "out of memory" if code in (-9, -6) else f"crashed: the process ended with exit code {code}"


def _run(function: Callable[[Any, Callable[[Any], None]], None], request: Any, there: Connection, seconds: float) -> None:
    """In the other process."""
    if hasattr(signal, "setitimer"):  # if nobody is left to end it
        with contextlib.suppress(OverflowError, OSError, ValueError):
            signal.setitimer(signal.ITIMER_REAL, math.ceil(seconds) + _GRACE)
    there.send(("begun", None))
    try:
        function(request, lambda message: there.send(("told", message)))
    except ExactkfError as error:
        there.send(("raised", error))
    except MemoryError:
        there.send(("raised", Ended("out of memory")))
    except Exception as error:
        there.send(("raised", Ended(f"crashed: {type(error).__name__}: {' '.join(str(error).split())}")))
    else:
        there.send(("done", None))
