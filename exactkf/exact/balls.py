# SPDX-License-Identifier: MIT
"""Rigorous comparison of balls.

A ball is a midpoint and a radius that together enclose a real (`arb`) or
complex (`acb`) number.  Two balls that overlap leave a comparison undecided,
so the comparisons here have three answers: True, False and None (undecided).
`decide` repeats an undecided question at doubled precision, up to a bound.

Notation
--------
Precision is counted in bits and is python-flint's global setting
``flint.ctx.prec``: `precision` changes it for the length of a ``with`` block.
It is shared by the threads of a process.

References
----------
F. Johansson, Arb: efficient arbitrary-precision midpoint-radius interval
arithmetic, IEEE Transactions on Computers 66 (2017), 1281-1292.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

import flint
from flint import arb, fmpq

from exactkf._errors import Unsupported
from exactkf.exact._messages import bad, check_count
from exactkf.exact.rationals import rational

__all__ = ["ball", "contains", "decide", "equal", "less", "precision", "sign"]

T = TypeVar("T")


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Work at `bits` bits inside the ``with`` block and restore the old precision after it.

    Raises
    ------
    BadInput
        If `bits` is not an integer of at least 2.
    """
    check_count("bits", bits, 2)
    old = flint.ctx.prec
    flint.ctx.prec = bits
    try:
        yield
    finally:
        flint.ctx.prec = old


def ball(x: Any) -> arb:
    """Return a ball at the current precision that encloses the rational number (or ball) `x`."""
    return x if isinstance(x, arb) else arb(rational(x))


def contains(b: arb, x: Any) -> bool:
    """Return whether the ball `b` contains the rational number `x`, decided exactly.

    ``arb.contains`` first rounds a rational number to a ball, so it may answer
    False for a number that is inside; this compares rational numbers.
    """
    if not b.is_finite():
        return not b.is_nan() and b.rad() == arb.pos_inf()
    return abs(rational(x) - b.mid().fmpq()) <= b.rad().fmpq()


def sign(x: arb) -> int | None:
    """Return -1, 0 or 1, the sign of every number in the ball, or None if they differ."""
    if x > 0:
        return 1
    if x < 0:
        return -1
    return 0 if x.is_zero() else None


def less(a: arb | fmpq | int, b: arb | fmpq | int) -> bool | None:
    """Return True if ``a < b`` for sure, False if ``a >= b`` for sure, None if undecided."""
    a, b = ball(a), ball(b)
    if a < b:
        return True
    return False if a >= b else None


def equal(a: Any, b: Any) -> bool | None:
    """Return False if the balls (arb or acb) are disjoint, True if both are the same point, None otherwise."""
    if not a.overlaps(b):
        return False
    return True if a.is_exact() and b.is_exact() else None


def decide(question: Callable[[], T | None], *, start: int = 64, bound: int = 1 << 14) -> T:
    """Ask `question` at doubling precision until its answer is not None.

    Parameters
    ----------
    question : callable
        Takes no argument, computes at the current precision, returns None when undecided.
    start, bound : int
        First and largest precision, in bits.

    Returns
    -------
    object
        The first answer that is not None.

    Raises
    ------
    BadInput
        If `question` is not callable, `start` is not an integer of at least 2, or `bound` less.
    Unsupported
        If the question is still undecided at `bound` bits.

    Examples
    --------
    >>> decide(lambda: less(arb(2).sqrt(), 1))
    False
    """
    if not callable(question):
        raise bad("question", "is not a function", question, "pass a function without arguments")
    check_count("start", start, 2)
    check_count("bound", bound, start)
    bits = start
    while True:
        with precision(bits):
            answer = question()
        if answer is not None:
            return answer
        if bits >= bound:
            raise Unsupported(f"undecided at the largest precision of {bound} bits; the two sides may be equal")
        bits = min(2 * bits, bound)
