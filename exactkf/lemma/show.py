# SPDX-License-Identifier: MIT
"""An outcome as text for a terminal.

Main definitions
----------------
`lemma_text`
    The lemma as it was read, in the grammar where that is possible.
`facts_of`
    Classical facts that the proof uses.
`outcome_lines`
    Lemma, verdict, matrices, how far it got.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from exactkf._errors import BadInput
from exactkf._facts import facts_used
from exactkf._wording import number_of
from exactkf.kernel.order import FACTS
from exactkf.language import Statement
from exactkf.language.text import statement_text
from exactkf.lemma.outcome import Outcome
from exactkf.lemma.write import write_lemma

__all__ = ["facts_of", "lemma_text", "matrix_lines", "outcome_lines", "verdict_line"]


def lemma_text(statement: Statement) -> str:
    """The lemma in the grammar; a statement that the grammar does not reach in the text of statements."""
    try:
        return write_lemma(statement)
    except BadInput:
        return statement_text(statement) + "\n"


def verdict_line(outcome: Outcome) -> str:
    """The verdict in one line."""
    if outcome.verdict == "proved":
        sizes = "for every size" if outcome.statement.sizes else "as it stands"
        return f"proved {sizes}" + (f" (assuming {'; '.join(outcome.assuming)})" if outcome.assuming else "")
    return f"{outcome.verdict}: {outcome.reason}"


def facts_of(outcome: Outcome) -> dict[str, str]:
    """The classical facts that the proof uses, by name."""
    if outcome.verdict != "proved":
        return {}
    used = {name for certificate in outcome.certificates for name in facts_used(certificate)}
    return {name: sentence for name, sentence in FACTS.items() if name in used}


def outcome_lines(outcome: Outcome) -> Iterator[str]:
    """Everything there is to say, line by line."""
    yield from lemma_text(outcome.statement).splitlines()
    yield ""
    yield verdict_line(outcome)
    if outcome.counterexample:
        yield from _part("matrices that satisfy every assumption and violate the claim", instance_lines(outcome.counterexample))
    elif outcome.verdict == "open" and outcome.witness:
        yield from _part("matrices that satisfy every assumption", instance_lines(outcome.witness))
    yield from _part("how far it got" if outcome.verdict == "open" else "what was checked", outcome.reached)
    yield from _part("classical facts", (f"{name}: {sentence}" for name, sentence in facts_of(outcome).items()))
    yield from _part("to consider", outcome.warnings)
    yield ""
    yield f"{number_of(outcome.checks, 'check')} in {outcome.seconds:.3g} s, {number_of(len(outcome.certificates), 'certificate')}"


def _part(title: str, lines: Any) -> Iterator[str]:
    lines = list(lines)
    if lines:
        yield ""
        yield title
        yield from (f"  {line}".rstrip() for line in lines)


def instance_lines(instance: Mapping[str, Any]) -> Iterator[str]:
    """Sizes in one line, then each value, matrices row by row."""
    sizes = {name: n for name, n in instance["sizes"].items() if name != "horizon"}
    if sizes:
        yield ", ".join(f"{name} = {n}" for name, n in sizes.items())
    for name, value in instance["values"].items():
        yield from matrix_lines(name, value)


def matrix_lines(name: str, value: Any) -> Iterator[str]:
    """A value with its name, the columns of a matrix aligned.

    >>> print("\\n".join(matrix_lines("P", [[1, "1/2"], [-3, 0]])))
    P = [  1  1/2 ]
        [ -3    0 ]
    """
    if not isinstance(value, list) or not value or not isinstance(value[0], list):
        yield f"{name} = {value}"
        return
    widths = [max(len(str(row[j])) for row in value) for j in range(len(value[0]))]
    for k, row in enumerate(value):
        cells = "  ".join(str(x).rjust(w) for x, w in zip(row, widths, strict=True))
        yield f"{name + ' =' if k == 0 else ' ' * (len(name) + 2)} [ {cells} ]"
