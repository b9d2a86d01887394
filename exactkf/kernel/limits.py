# SPDX-License-Identifier: MIT
"""How much a certificate may ask for: a short one must not keep its reader busy for hours, nor fill the memory.

What is beyond is refused in one line. Nothing rests on these numbers but patience: each is well above what the decisions and proofs
of this package ask for.

Main definitions
----------------
`within`
    Refuse an amount that is too large.
"""

from __future__ import annotations

from exactkf.kernel.numbers import Undefined

__all__ = ["BITS", "DEGREE", "MINORS", "ORDER", "STEPS", "WORK", "within"]

ORDER = 200  # of a filter
DEGREE = 64  # of a number field
STEPS = 10**6  # of an orbit, or terms of a sum: each is looked at
BITS = 1 << 20  # of one number
WORK = 3 * 10**8  # operations with small numbers, or bits of the numbers of an orbit, all steps together
MINORS = 10**7  # numbers that are kept at a time


def within(amount: int, most: int, what: str) -> None:
    """Raise Undefined if the amount is more than that."""
    if amount > most:
        raise Undefined(f"{what}: {f'{amount}' if amount < 10**12 else 'a number of more than 12 digits'}, where {most} is the most that is checked")
