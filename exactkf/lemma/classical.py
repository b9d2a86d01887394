# SPDX-License-Identifier: MIT
"""Proofs of orders, invertibility and equations by classical facts on semidefinite matrices, leaf by leaf.

Main definitions
----------------
`by_classical_facts`
    Evidence of an ``order`` to try.
`along_sequences`
    Evidence of a ``word induction`` to try, base and step by such orders.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from typing import Any

from exactkf._errors import BadInput
from exactkf.finders.cone import helpful_lemmas, part_by_cone
from exactkf.finders.effort import clock
from exactkf.finders.membership import own_part_of_order
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.order import leaves
from exactkf.kernel.recursion import Induction, inductions

__all__ = ["along_sequences", "by_classical_facts"]

_FIRST = 1.0  # seconds for the terms that a leaf itself suggests
_MOST_LEMMAS = 6  # lists of lemmas tried for one leaf


def by_classical_facts(data: Mapping[str, Any], degree: int, seconds: float, lemmas: Sequence[Any] = ()) -> Iterator[dict]:
    """Evidence of an ``order`` for a statement, if every leaf of it is reached.

    Parameters
    ----------
    data : dict
        JSON of the statement.
    degree, seconds
        Bounds of the search.
    lemmas : sequence of formulas
        Shown first; they are not part of the evidence.
    """
    deadline = clock() + seconds
    parts: list[dict] = []
    inside: list[list] = []
    try:
        todo = list(leaves(data, lemmas))
        for number, (case, formula) in enumerate(todo):
            share = clock() + (deadline - clock()) / (len(todo) - number)
            if (part := _part(case, formula, degree, (share - clock()) / 2)) is not None:
                parts.append(part)
                continue
            for helpful in islice(helpful_lemmas(case, formula), _MOST_LEMMAS):
                asked = [*inside, [number, "", helpful]]
                if (found := _with_lemmas(data, lemmas, asked, len(parts), len(todo) - number - 1, degree, (share - clock()) / 2)) is not None:
                    parts += found
                    inside = asked
                    break
            else:
                return
    except (Unknown, Undefined, BadInput):
        return
    yield {"parts": parts, "lemmas": [], **({"inside": inside} if inside else {})}


def _with_lemmas(data: Mapping[str, Any], lemmas: Sequence[Any], inside: list, done: int, behind: int, degree: int, seconds: float) -> list[dict] | None:
    """Parts for the lemmas of a leaf, and for the leaf."""
    every = list(leaves(data, lemmas, inside))
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


def along_sequences(data: Mapping[str, Any], square: Sequence[str], degree: int, seconds: float) -> Iterator[dict]:
    """Evidence of a ``word induction``; beside the conclusion the sequences are symmetric, or semidefinite.

    Parameters
    ----------
    data : dict
        JSON of the statement.
    square : sequence of str
        Names of the sequences of square matrices.
    degree, seconds
        Bounds of the search.
    """
    parts = list(inductions(data))
    if not any(part["says"][0] == "always" for part in parts):
        return
    deadline = clock() + seconds
    for op, part_of_time in (("", 0.2), ("psd", 0.8), ("symmetric", 1)):
        share = clock() + (deadline - clock()) * part_of_time
        also = [[[op, ["at", name, ["sym", part["says"][1]]]] for name in square] if op and part["says"][0] == "always" else [] for part in parts]
        proofs: list[list[dict]] = []
        for part, carried in zip(parts, also, strict=True):
            found = _base_and_step(part, carried, degree, (share - clock()) / (len(parts) - len(proofs)))
            if found is None:
                break
            proofs.append(found)
        else:
            yield {"conjuncts": proofs, "also": also, "shapes": {}}
            return


def _base_and_step(part: dict, also: list, degree: int, seconds: float) -> list[dict] | None:
    try:
        made = Induction(part, also)
    except (Unknown, Undefined):
        return None
    cases = [*made.bases, *([made.step] if made.step else [])]
    proofs: list[dict] = []
    deadline = clock() + seconds
    for case, lemmas in zip(cases, made.lemmas, strict=True):
        found = next(by_classical_facts(case, degree, (deadline - clock()) / (len(cases) - len(proofs)), lemmas), None)
        if found is None:
            return None
        proofs.append(found)
    return proofs
