# SPDX-License-Identifier: MIT
"""What becomes of a lemma.

Main definitions
----------------
`Outcome`
    Verdict, reason, certificates, matrices of a refutation, and how far it got.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from exactkf.language import Statement

__all__ = ["Outcome"]


@dataclass
class Outcome:
    """The verdict on a lemma with what stands behind it.

    Attributes
    ----------
    statement : Statement
        The lemma as read, with the sizes of identities and zeros put in.
    verdict : str
        ``proved`` (for every size), ``refuted`` (by explicit matrices) or ``open``.
    reason : str
        For ``open`` why, in one line; for ``refuted`` what fails.
    certificates : list of dict
        Certificates that `exactkf.kernel.replay.replay` (and ``exactkf check``) accepts: of the proof and of the inverses
        it takes for granted, or of the refutation. For ``open`` those of what was shown on the way.
    counterexample : dict or None
        Matrices that satisfy every assumption and violate the claim.
    witness : dict or None
        Matrices that satisfy every assumption.
    assuming : list of str
        The labels of the assumptions, and for each inverse of the lemma why it exists.
    reached : list of str
        How far the search got.
    warnings : list of str
        Changed lemmas that also hold or that could not be told apart: no fault of the lemma, but a hint that it may say less than meant.
    checks : int
        Instances evaluated and certificates replayed.
    seconds : float
    """

    statement: Statement
    verdict: str = "open"
    reason: str = ""
    certificates: list[dict[str, Any]] = field(default_factory=list)
    counterexample: Mapping[str, Any] | None = None
    witness: Mapping[str, Any] | None = None
    assuming: list[str] = field(default_factory=list)
    reached: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)
    checks: int = 0
    seconds: float = 0.0

    def __str__(self) -> str:
        """What ``exactkf lemma`` prints."""
        from exactkf.lemma.show import outcome_lines

        return "\n".join(outcome_lines(self))

    def to_json(self) -> dict[str, Any]:
        """Plain data, with the lemma as text of the grammar and as LaTeX."""
        from exactkf.language.latex import given_latex, over_latex, says_latex, statement_latex, where_latex
        from exactkf.lemma.show import facts_of, lemma_text

        return {
            "verdict": self.verdict, "reason": self.reason or None, "text": lemma_text(self.statement), "statement": self.statement.to_json(),
            "statement_latex": statement_latex(self.statement), "over_latex": over_latex(self.statement), "where_latex": where_latex(self.statement),
            "given_latex": given_latex(self.statement), "says_latex": says_latex(self.statement),
            "assuming": self.assuming, "counterexample": self.counterexample, "witness": self.witness,
            "facts": facts_of(self), "reached": self.reached, "warnings": self.warnings, "checks": self.checks, "seconds": round(self.seconds, 3),
            "certificates": self.certificates,
        }
