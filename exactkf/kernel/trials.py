# SPDX-License-Identifier: MIT
"""Trial divisions: made and remembered by a search, told to a replay.

Rational functions stay short because recorded factors are cancelled, and most
attempts to cancel one fail. A certificate may tell which attempts succeed, so
that its replay makes no other. Nothing rests on what it tells: a fraction that
is not in lowest terms has the same value, and a division that is told is made
exactly or rejected.
"""

from __future__ import annotations

from collections.abc import Sequence

from exactkf.kernel.numbers import Rejected

__all__ = ["Trials"]


class Trials:
    """Outcomes of trial divisions, in the order in which they come up.

    Parameters
    ----------
    told : sequence of int, optional
        Alternately the number of attempts that fail and how often the division after them succeeds; all that come later
        fail. Without it every division is tried.

    Attributes
    ----------
    known : bool
        The outcomes are told.
    made : list of int
        The outcomes so far, in the form of `told`, where they are not told.
    """

    __slots__ = ("_failures", "_told", "known", "made")

    def __init__(self, told: Sequence[int] | None = None) -> None:
        self.known, self.made = told is not None, list[int]()
        self._told = iter(told or ())
        self._failures = next(self._told, -1) if self.known else 0

    def __bool__(self) -> bool:
        """Some attempt was made."""
        return bool(self.made or self._failures)

    def remember(self, times: int) -> None:
        """One attempt was made, and the division succeeded so many times."""
        if times:
            self.made += self._failures, times
            self._failures = 0
        else:
            self._failures += 1

    def next(self, most: int) -> int:
        """How often the next division succeeds, at most so many times.

        Raises
        ------
        Rejected
            If the number told is none from one to `most`.
        """
        if self._failures:
            self._failures -= 1
            return 0
        times = next(self._told, 0)
        if type(times) is not int or not 1 <= times <= most:
            raise Rejected(f"cancelled: a factor cannot be cancelled {times!r} times")
        self._failures = next(self._told, -1)
        return times
