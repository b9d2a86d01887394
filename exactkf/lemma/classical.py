# SPDX-License-Identifier: MIT
"""Proofs of orders, invertibility and equations by classical facts on semidefinite matrices, leaf by leaf.

Main definitions
----------------
`by_classical_facts`
    Evidence of an ``order`` to try.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import islice
from typing import Any

from exactkf._errors import BadInput
from exactkf.finders.cone import helpful_lemmas, part_by_cone
from exactkf.finders.effort import clock
from exactkf.finders.membership import own_part_of_order
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.order import leaves

__all__ = ["by_classical_facts"]

_FIRST = 1.0  # seconds for the terms that a leaf itself suggests
_MOST_LEMMAS = 6  # lists of lemmas tried for one leaf


def by_classical_facts(data: Mapping[str, Any], degree: int, seconds: float) -> Iterator[dict]:
    """Evidence of an ``order`` for a statement, if every leaf of it is reached.

    Parameters
    ----------
    data : dict
        JSON of the statement.
    degree, seconds
        Bounds of the search.
    """
    deadline = clock() + seconds
    parts: list[dict] = []
    inside: list[list] = []
    try:
        todo = list(leaves(data))
        for number, (case, formula) in enumerate(todo):
            share = clock() + (deadline - clock()) / (len(todo) - number)
            if (part := _part(case, formula, degree, (share - clock()) / 2)) is not None:
                parts.append(part)
                continue
            for lemmas in islice(helpful_lemmas(case, formula), _MOST_LEMMAS):
                asked = [*inside, [number, "", lemmas]]
                if (found := _with_lemmas(data, asked, len(parts), len(todo) - number - 1, degree, (share - clock()) / 2)) is not None:
                    parts += found
                    inside = asked
                    break
            else:
                return
    except (Unknown, Undefined, BadInput):
        return
    yield {"parts": parts, "lemmas": [], **({"inside": inside} if inside else {})}


def _with_lemmas(data: Mapping[str, Any], inside: list, done: int, behind: int, degree: int, seconds: float) -> list[dict] | None:
    """Parts for the lemmas of a leaf, and for the leaf."""
    every = list(leaves(data, (), inside))
    own = every[done:len(every) - behind]
    found = []
    for case, formula in own:
        part = _part(case, formula, degree, seconds / len(own))
        if part is None:
            return None
        found.append(part)
    return found


def _part(case: dict, formula: Any, degree: int, seconds: float) -> dict | None:
    if seconds <= 0:
        return None
    return own_part_of_order(case, formula, degree, min(_FIRST, seconds / 4)) or part_by_cone(case, formula, degree, seconds)
