# SPDX-License-Identifier: MIT
"""How much a certificate may ask for: a short one must not keep its reader busy for hours, nor fill the memory.

What is beyond is refused in one line. Nothing rests on these numbers but patience: each is well above what the decisions and proofs
of this package ask for.

Main definitions
----------------
`within`
    Refuse an amount that is too large.
`patiently`
    Refuse what takes too long, or too much memory, for other reasons, such as sums within sums.
`collecting_seldom`
    Look for garbage less often.
"""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from time import process_time
from typing import Any

from exactkf.kernel.numbers import Rejected, Undefined

__all__ = ["BITS", "DEGREE", "MINORS", "ORDER", "SECONDS", "STEPS", "WORDS", "WORK", "collecting_seldom", "patiently", "within"]

ORDER = 200  # of a filter
DEGREE = 64  # of a number field
STEPS = 10**6  # of an orbit, or terms of a sum: each is looked at
BITS = 1 << 20  # of one number
WORK = 3 * 10**8  # operations with small numbers, or bits of the numbers of an orbit, all steps together
MINORS = 10**7  # numbers that are kept at a time
WORDS = 2 * 10**5  # of a product of polynomials in letters
SECONDS = 600  # of the processor, for one certificate
MEMORY = 4 << 30  # bytes
_LEAST = 1e-6  # seconds: a timer of none never ends
_OBJECTS = 10_000  # that are made, and kept, before garbage is looked for
_AGAIN = 0.25  # seconds after which a signal comes again: what it raises in a callback of the garbage collector is lost


def within(amount: int, most: int, what: str) -> None:
    """Raise Undefined if the amount is more than that."""
    if amount > most:
        raise Undefined(f"{what}: {f'{amount}' if amount < 10**12 else 'a number of more than 12 digits'}, where {most} is the most that is checked")


@contextmanager
def collecting_seldom() -> Iterator[None]:
    """Look for cycles of garbage after more objects than usual: a replay makes few, and looking for them takes a fifth of its time."""
    first, *others = before = gc.get_threshold()
    gc.set_threshold(max(first, _OBJECTS) if first else first, *others)  # 0 is never
    try:
        yield
    finally:
        gc.set_threshold(*before)


class _Late(BaseException):
    """Nothing in between takes it for something else."""


@contextmanager
def patiently(seconds: float = SECONDS) -> Iterator[None]:
    """Raise Rejected if what is done within takes more time or memory than that, as far as the system can tell."""
    try:
        import resource
        from signal import ITIMER_PROF, SIGPROF, getitimer, setitimer, signal

        def late(*_: Any) -> None:
            if waiting:
                raise _Late

        before, bounds = signal(SIGPROF, late), resource.getrlimit(resource.RLIMIT_AS)
    except (ImportError, ValueError):  # another system, or not the main thread
        yield
        return
    left, began = getitimer(ITIMER_PROF)[0], process_time()  # a timer that runs around this one has so much left, and goes on
    waiting = True
    try:
        try:
            with suppress(ValueError, OSError):
                resource.setrlimit(resource.RLIMIT_AS, (min([MEMORY, *(b for b in bounds if b != resource.RLIM_INFINITY)]), bounds[1]))
            setitimer(ITIMER_PROF, max(_LEAST, min(seconds, left or 10**8)), _AGAIN)
            yield
        finally:
            waiting = False
    except _Late:
        raise Rejected(f"given up after {seconds:g} seconds of work") from None
    except MemoryError:
        raise Rejected(f"given up, as it takes more than {MEMORY >> 30} GB of memory") from None
    finally:
        setitimer(ITIMER_PROF, *((max(left - (process_time() - began), _AGAIN), _AGAIN) if left else (0,)))
        signal(SIGPROF, before)
        with suppress(ValueError, OSError):
            resource.setrlimit(resource.RLIMIT_AS, bounds)
