# SPDX-License-Identifier: MIT
r"""Many filters decided, in several processes.

Main definitions
----------------
``decide_many``  the answers, in the order of the starts
``outcomes``     the same one by one as they come, each an answer or why it was refused

Choice of algorithm
-------------------
Pieces of the list go to worker processes, a new one to each that is ready.  A worker gives a piece back unfinished after a second, so that a few
hard starts do not hold up the easy ones behind them.  Starts of a piece whose worker died or ran out of time are decided again alone.
An answer comes back without what can be made from it (`Answer.of_entries`), unless it was asked for.
"""

from __future__ import annotations

import gc
import multiprocessing
import threading
import time
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence, Set
from concurrent.futures import Future, TimeoutError
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

from flint import fmpq
from pebble import ProcessExpired

from exactkf._errors import BadInput, ExactkfError
from exactkf.bounded import how_it_ended
from exactkf.dynamics.analyze import analyze
from exactkf.dynamics.answer import Answer
from exactkf.dynamics.files import read_filters
from exactkf.dynamics.filter import Filter
from exactkf.dynamics.numbers import number
from exactkf.dynamics.order_one import decide_order_one, decide_riccati_one
from exactkf.exact._messages import bad, check_count, shown
from exactkf.exact.compositum import together
from exactkf.pool import PoolBroken, Tasks

__all__ = ["decide_many", "outcomes"]

_BUDGET, _LONGEST = 1.0, 100  # seconds after which a piece is given back, and its largest number of starts

Start = Filter | Mapping[str, Any] | Sequence[Any]
Outcome = Answer | ExactkfError


def decide_many(starts: Iterable[Start] | str | Path, jobs: int = 1, *, time_limit: float | None = None) -> list[Answer]:
    r"""Decide many filters of any orders.

    Parameters
    ----------
    starts : iterable, or name of a file
        Each a `Filter`; a mapping as `exactkf.analyze` takes it; or numbers :math:`(\alpha, \gamma)`, vectors :math:`(\alpha, \gamma)`, or, for the Riccati
        equation of order one, :math:`(\alpha, \gamma, \pi_0)`.  A file is one that ``exactkf analyze`` reads.
    jobs : int
        The number of processes.
    time_limit : float, optional
        Seconds for one filter; past them its answer is "undecided".  With a limit, and where the system cannot fork, a script keeps the call behind
        ``if __name__ == "__main__":``.

    Returns
    -------
    list of Answer
        In the order of the starts.

    Raises
    ------
    BadInput
        If a start is none of these, or is refused by `exactkf.analyze`; the first such is named.

    Examples
    --------
    >>> [x.behaviour for x in decide_many([(3, "1/2"), ([0, 2], ["1/2", "1/3"]), {"a": [0, 1], "g": [0, 0]}])]
    ['converges', 'converges', 'converges']
    """
    check_count("jobs", jobs, 1)
    if time_limit is not None and (isinstance(time_limit, bool) or not isinstance(time_limit, (int, float)) or not 0 < time_limit < float("inf")):
        raise BadInput(f"time_limit = {time_limit!r}: not a number of seconds; pass a positive one, or None")
    if isinstance(starts, (str, Path)):
        starts = [data for _, data in read_filters(starts)]
    if not isinstance(starts, Iterable) or isinstance(starts, (bytes, Mapping, Set)):
        raise bad("starts", "is no list of filters", starts, "pass a list, or the name of a file")
    listed = [_checked(k, start) for k, start in enumerate(starts)]
    answers = []
    with _no_garbage():
        for k, outcome in enumerate(_in_order(outcomes(listed, jobs=jobs, time_limit=time_limit))):
            if not isinstance(outcome, Answer):
                raise type(outcome)(f"starts[{k}]: {outcome}")
            answers.append(outcome)
    return answers


def outcomes(starts: Sequence[Start], *, jobs: int = 1, time_limit: float | None = None, asked: tuple[str, ...] = (),
             idle: Callable[[], None] | None = None) -> Generator[tuple[int, Outcome], None, None]:
    """Yield, as they come, the places of the starts and their answers or the errors that refuse them.

    Parameters
    ----------
    starts, jobs, time_limit
        As for `decide_many`.
    asked : tuple of str
        What the workers make besides: some of "limit", "rate", "slow", "structure", "facts", "certificate".  What takes too long is
        missing, and `reason` says so.
    idle : callable, optional
        Called when nothing has come for half a second.
    """
    if jobs == 1 and time_limit is None:
        yield from ((k, _outcome(start, asked)) for k, start in enumerate(starts))
    elif starts:
        yield from _shared(starts, min(jobs, len(starts)), time_limit, asked, idle)


def _in_order(pairs: Iterable[tuple[int, Outcome]]) -> Iterator[Outcome]:
    found: dict[int, Outcome] = {}
    k = 0
    for place, outcome in pairs:
        found[place] = outcome
        while k in found:
            yield found.pop(k)
            k += 1


def _checked(k: int, start: Any) -> Start:
    if isinstance(start, (Filter, Mapping)):
        return start
    if isinstance(start, Iterable) and not isinstance(start, (str, bytes)):
        entries = tuple(start)
        if len(entries) in (2, 3):
            return entries
    raise BadInput(f"starts[{k}] = {shown(start)}: not a filter; pass (alpha, gamma), (alpha, gamma, pi0), a mapping such as "
                   "{'a': [...], 'g': [...]}, or a Filter")


@contextmanager
def _no_garbage() -> Iterator[None]:
    """No search for cycles for a while: answers have none, and thousands of them make the search slow."""
    was = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was:
            gc.enable()


# ---------------------------------------------------------------------- one start
def _outcome(start: Start, asked: tuple[str, ...]) -> Outcome:
    try:
        answer = _answer(start)
        for name in asked:
            getattr(answer, name)
    except ExactkfError as error:
        return error
    except MemoryError:
        return _unfinished(start, "out of memory")
    except Exception as error:
        return _unfinished(start, f"crashed: {type(error).__name__}: {' '.join(str(error).split())}")
    return answer


def _answer(start: Start) -> Answer:
    if isinstance(start, (Filter, Mapping)):
        return analyze(start)
    if not isinstance(start[0], (int, Fraction, fmpq, str)) and isinstance(start[0], Iterable):
        return analyze(**dict(zip(("alpha", "gamma", "pi0"), start, strict=False)))
    if not all(type(x) in (int, Fraction, fmpq) for x in start):
        start = together([number(x, name=name) for x, name in zip(start, ("alpha", "gamma", "pi0"), strict=False)])[0]
    return decide_order_one(*start) if len(start) == 2 else decide_riccati_one(*start)


def _unfinished(start: Start, reason: str) -> Answer:
    return Answer(_order(start), "undecided", reason=reason)


def _order(start: Start) -> int:
    """The order of a filter that is not decided, as far as that is seen at once."""
    if isinstance(start, Filter):
        return start.order
    if not isinstance(start, Mapping):
        start = {"alpha": start[0]} if isinstance(start[0], (list, tuple)) else {"alpha": [start[0]]}
    lengths = [len(start[key]) - less for key, less in (("alpha", 0), ("g", 0), ("F", 0), ("b", 1)) if isinstance(start.get(key), (list, tuple))]
    return lengths[0] if lengths else 0


# ---------------------------------------------------------------------- many
class _Piece(NamedTuple):
    """Consecutive starts, and what is asked of their answers; `late` says why less is asked than at first."""

    start: int
    stop: int
    asked: tuple[str, ...]
    late: str = ""


def _shared(starts: Sequence[Start], jobs: int, time_limit: float | None, asked: tuple[str, ...],
            idle: Callable[[], None] | None) -> Generator[tuple[int, Outcome], None, None]:
    """Outcomes from several processes."""
    size = max(1, min(_LONGEST, len(starts) // (16 * jobs)))
    waiting = deque(_Piece(k, min(k + size, len(starts)), asked) for k in range(0, len(starts), size))
    # forking a process that runs threads can hang, also for the worker that replaces one out of time
    forks = "fork" in multiprocessing.get_all_start_methods() and threading.active_count() == 1 and time_limit is None
    budget = _BUDGET if time_limit is None else min(_BUDGET, time_limit / 2)
    tasks: Tasks[_Piece] = Tasks(_decided, lambda piece: (*piece[:3], budget), _prepare, (starts,), time_limit=time_limit, forks=forks)
    try:
        for piece, task in tasks.ended(waiting, jobs, idle):
            yield from _taken(starts, piece, task, time_limit, waiting)
    except PoolBroken:
        raise ExactkfError("the worker processes ended before they began; in a script, keep the call behind if __name__ == '__main__':, "
                           "or pass jobs=1") from None


def _taken(starts: Sequence[Start], piece: _Piece, task: Future, time_limit: float | None, waiting: deque[_Piece]) -> Iterator[tuple[int, Outcome]]:
    """What came of a piece; what is left of it waits again."""
    why = ""
    try:
        results: list[Outcome] = task.result()
    except TimeoutError:
        why = f"out of time after {time_limit:g} s"
    except ProcessExpired as error:
        why = how_it_ended(error.exitcode)
    if not why:
        for k, outcome in enumerate(results, piece.start):
            yield k, outcome.as_found(piece.late) if piece.late and isinstance(outcome, Answer) else outcome
        if piece.start + len(results) < piece.stop:
            waiting.appendleft(piece._replace(start=piece.start + len(results)))
    elif piece.stop - piece.start > 1:
        waiting.extendleft(piece._replace(start=k, stop=k + 1) for k in reversed(range(piece.start, piece.stop)))
    elif set(piece.asked) - {"facts"}:  # the decision alone may be found
        waiting.appendleft(_Piece(piece.start, piece.stop, ("facts",), f"{why} while finding {' and '.join(x for x in piece.asked if x != 'facts')}"))
    else:
        yield piece.start, _unfinished(starts[piece.start], f"{why} while deciding")


# ---------------------------------------------------------------------- in the worker
_STARTS: Sequence[Start] = ()


def _prepare(starts: Sequence[Start]) -> None:
    global _STARTS
    _STARTS = starts
    gc.freeze()  # what is there stays: the collector need not look at it again


def _decided(start: int, stop: int, asked: tuple[str, ...], budget: float) -> list[Outcome]:
    """The outcomes of a piece, or of its beginning if they take long."""
    until, found = time.monotonic() + budget, list[Outcome]()
    for k in range(start, stop):
        found.append(_outcome(_STARTS[k], asked))
        if time.monotonic() > until:
            break
    return found
