# SPDX-License-Identifier: MIT
"""The cases of a proof at a generic index, noted so that its replay need not look for them.

The replay of such a proof cuts a region where the answer to a question depends on a sign, and starts again in both parts; in each it
reads the equations that may be used until nothing is left. Which cuts and which equations these were is found here, once.

Main definitions
----------------
`with_cases`
    The certificate, with its cases.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from exactkf.kernel.index_induction import Goal, Proof
from exactkf.kernel.numbers import Rejected, Undefined, Unknown, rationals
from exactkf.kernel.rational import quotient
from exactkf.kernel.region import Region, Split
from exactkf.kernel.replay import replay, seal

__all__ = ["with_cases"]


class _Noted(Proof):
    """A proof that notes its cases."""

    def __init__(self, statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
        self.cases: list[Any] = []
        super().__init__(statement, evidence)

    def part(self, region: Region, goal: Goal, uses: Any, *where: Any) -> set[int]:
        """What is needed of the uses, or the cut."""
        place = len(self.cases)
        self.cases.append([])
        try:
            needed = super().part(region, goal, uses, *where)
        except Split as split:
            self.cases[place] = split.form
            raise
        fewer = sorted(needed)
        if len(fewer) < len(uses):  # then the equations may be solved for other atoms
            try:
                super().part(region, goal, [uses[k] for k in fewer], *where)
            except (Rejected, Undefined, Unknown, Split):
                fewer = list(range(len(uses)))
        self.cases[place] = fewer
        return needed


def with_cases(certificate: dict[str, Any]) -> tuple[dict[str, Any], list[str] | None]:
    """A certificate with its cases, and the denominators of its replay; as it was, and None, where that does not replay."""
    statement, evidence = certificate["statement"], {key: value for key, value in certificate["evidence"].items() if key != "cases"}
    try:
        with rationals(quotient):
            proof = _Noted(statement, evidence)
            proof.replay()
        made = seal(certificate["id"], certificate["kind"], statement, {**evidence, "cases": proof.cases})
        return made, replay(made)
    except (Rejected, Undefined, Unknown, LookupError, TypeError, ValueError, AttributeError, ArithmeticError, RecursionError):
        return certificate, None  # what is wrong with it the checker says
