# SPDX-License-Identifier: MIT
"""Numbers of things in words."""

from __future__ import annotations

__all__ = ["number_of"]


def number_of(count: int, thing: str) -> str:
    """A number with its noun.

    >>> number_of(1, "check"), number_of(2, "check")
    ('1 check', '2 checks')
    """
    return f"{count} {thing}" + "s" * (count != 1)
