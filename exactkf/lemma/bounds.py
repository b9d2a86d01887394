# SPDX-License-Identifier: MIT
"""At which bound a search for a proof ended.

Main definitions
----------------
`why_open`
    In words, with what may help.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from typing import Any

from exactkf._errors import BadInput
from exactkf.finders.completion import COMPLETE, NO_MORE, OUT_OF_TIME, TOO_MANY, system_of
from exactkf.finders.effort import clock
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.order import leaves, register_inverses
from exactkf.kernel.reader import Reader, relations

__all__ = ["why_open"]

_SAID = {
    OUT_OF_TIME: ("the time limit was reached: no proof was found with words of up to {} letters", "a larger --time-limit (time_limit=), or "),
    TOO_MANY: ("the bound on rules was reached: no proof with words of up to {} letters", "a smaller --degree (degree=), or "),
    NO_MORE: ("the degree bound was reached: no proof with words of up to {} letters", "a larger --degree (degree=), or "),
    COMPLETE: ("no proof, although neither the degree nor the time limit was reached", ""),
}


def why_open(data: Mapping[str, Any], parts: list, late: bool, degree: int, seconds: float) -> str:
    """Which bound was reached, and what may settle the claim.

    Parameters
    ----------
    data : dict
        JSON of the statement.
    parts : list of formulas
        Conclusions that were not proved.
    late : bool
        A search ended for lack of time.
    degree, seconds
        Bounds of the search; the seconds for this question alone.
    """
    found = {OUT_OF_TIME} if late else set()
    for part in parts:
        found |= _ends({**data, "says": part}, degree, clock() + seconds / len(parts))
    said, remedy = next(_SAID[end] for end in (*_SAID, COMPLETE) if end in found or end == COMPLETE)
    return f"{said.format(degree)}, and no counterexample; {remedy}a further assumption or claim on the way" + ("," if remedy else "") + " may settle it"


def _ends(data: dict, degree: int, deadline: float) -> set[str]:
    """What the completion of the assumptions of each leaf ends at."""
    found: set[str] = set()
    with suppress(Unknown, Undefined, BadInput, TypeError, AttributeError):  # no statement about words
        for case, _ in leaves(data):
            reader = Reader(case)
            for tree in case["own"]:
                register_inverses(reader, tree)
            found.add(system_of(reader, relations(reader), degree).bound(deadline))
    return found
