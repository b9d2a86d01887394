# SPDX-License-Identifier: MIT
"""A claim with its result as plain text."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

from exactkf._wording import number_of
from exactkf.claims import Claim
from exactkf.display import describe, heading
from exactkf.language import Statement
from exactkf.language.latex import statement_latex
from exactkf.language.text import statement_text

__all__ = ["describe_claim", "instance_lines", "not_wrong", "wrong_made"]


def describe_claim(claim: Claim, result: Mapping[str, Any]) -> str:
    """Everything there is to say about a claim, as lines of text."""
    return "\n".join(_lines(claim, result))


def _lines(claim: Claim, result: Mapping[str, Any]) -> Iterator[str]:
    yield f"{claim.id}  {claim.title}"
    yield f"{claim.paper}, {claim.section}"
    yield from _paragraph(heading(claim.by) if claim.statement else "as printed", _statement(claim.statement))
    yield from _paragraph("note", [claim.note] if claim.note else [])
    yield from _paragraph("verdict", [describe(result), *([result["reason"]] if result["reason"] else [])])
    yield from _paragraph("what was checked", result["evidence"])
    yield from _paragraph("divides by", result["denominators"])
    yield from _paragraph("witness of the hypotheses", instance_lines(result["witness"]))
    yield from _paragraph("counterexample", instance_lines(result["counterexample"]))
    yield from _paragraph("correction", list(_correction(claim, result)))
    mutants, neighbours = result["mutants"], result["neighbours"]
    if mutants["made"]:
        yield from _paragraph("wrong neighbours", [
            f"{mutants['made']} made, {mutants['rejected']} rejected, {mutants.get('equal', 0)} equal to the original, "
            f"{len(mutants.get('survivors', ()))} survived{not_wrong(mutants)}", *mutants.get("survivors", ()),
            f"{neighbours['accepted']} of {neighbours['made']} equal rewritings accepted"])
    yield f"\n{number_of(result['checks'], 'check')} in {result['seconds']:.3g} s, {number_of(len(result['certificates']), 'certificate')}"


def _paragraph(title: str, lines: Any) -> Iterator[str]:
    if lines:
        yield f"\n{title}"
        for line in lines:
            yield f"  {line}".rstrip()


def _statement(statement: Statement | None) -> list[str]:
    if statement is None:
        return ["no checkable statement yet"]
    return [*statement_text(statement).splitlines(), "", f"LaTeX: {statement_latex(statement)}"]


def _correction(claim: Claim, result: Mapping[str, Any]) -> Iterator[str]:
    fixed = result["repair"]
    if not fixed:
        return
    yield f"{fixed['kind']}: {fixed.get('wrong', '')}"
    if claim.repair:
        yield from _statement(claim.repair.statement)
    yield f"the correction {describe(fixed)}"
    if fixed.get("reason"):
        yield fixed["reason"]
    yield from fixed.get("evidence", ())


def wrong_made(mutants: Mapping[str, Any]) -> int:
    """Mutants that are wrong neighbours: they neither say the same as the original nor more, which may be true.

    >>> wrong_made({"made": 25, "rejected": 21, "equal": 3, "stronger": 1})
    21
    """
    return mutants["made"] - mutants.get("equal", 0) - mutants.get("stronger", 0)


def not_wrong(mutants: Mapping[str, Any]) -> str:
    """The mutants that are not wrong: stronger statements that may be true, and what is no statement, such as a sum of matrices that do not fit.

    >>> not_wrong({"made": 25, "stronger": 1, "void": 13})
    '; 1 says more and is not refuted; 13 more are no statement'
    """
    stronger, void = mutants.get("stronger", 0), mutants.get("void", 0)
    return ((f"; {stronger} {'says' if stronger == 1 else 'say'} more and {'is' if stronger == 1 else 'are'} not refuted" if stronger else "")
            + (f"; {void} more {'is' if void == 1 else 'are'} no statement" if void else ""))


def instance_lines(instance: Mapping[str, Any] | None) -> list[str]:
    """An exact instance, one name a line.

    >>> instance_lines({"sizes": {"n": 2}, "values": {"P": [["1", "0"], ["0", "1/2"]]}})
    ['n = 2', 'P = [1, 0; 0, 1/2]']
    """
    instance = instance or {}
    parts = [instance.get("sizes", {}), instance.get("values", {}),
             {k: v for k, v in instance.items() if k not in ("sizes", "values")}]
    return [f"{name} = {_value(value)}" for part in parts for name, value in part.items()]


def _value(value: Any) -> str:
    if isinstance(value, list) and value and all(isinstance(row, list) for row in value):
        return "[" + "; ".join(", ".join(_value(x) for x in row) for row in value) + "]"
    if isinstance(value, list):
        return "[" + ", ".join(_value(x) for x in value) + "]"
    return value if isinstance(value, str) else json.dumps(value)
