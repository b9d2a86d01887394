# SPDX-License-Identifier: MIT
"""Replaying what is proved for every size.

``membership``
    lhs - rhs = sum of c l (assumption) r in words of letters
``order``
    equations, order and invertibility: terms, and multiples of the assumptions
``word induction``
    base and step, each by an ``order``

Main definitions
----------------
`KINDS`
    Kinds of certificates and the functions that replay them.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from exactkf.kernel.numbers import Rejected, Undefined, Unknown
from exactkf.kernel.order import Leaf, leaves
from exactkf.kernel.recursion import Induction, inductions
from exactkf.kernel.words import Reader, add, multiply, relations, residual_blocks, text, word_sizes

__all__ = ["KINDS"]


def _need(condition: bool, step: str) -> None:
    if not condition:
        raise Rejected(step)


def _membership(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    reader = Reader(statement)
    goals = [(p, b.rows[i], b.cols[j]) for b in residual_blocks(reader, statement["says"])
             for i, row in enumerate(b.grid) for j, p in enumerate(row)]
    assumed = relations(reader)
    _need(len(goals) == len(evidence["terms"]), "as many lists of terms as blocks are needed")
    for number, ((goal, rows, cols), terms) in enumerate(zip(goals, evidence["terms"], strict=True), 1):
        _need(not _less_multiples(reader, assumed, goal, rows, cols, terms), f"block {number}: the terms do not add up")
    return [f"det({text(p)})" for p, _ in reader.inverses]


def _less_multiples(reader: Reader, assumed: Mapping[str, Any], rest: Any, rows: Any, cols: Any, terms: list) -> Any:
    """What is left of a polynomial after multiples of assumptions are taken off."""
    one = Fraction(1)
    for c, left, name, right in terms:
        product = multiply(multiply({((), tuple(left)): one}, assumed[name]), {((), tuple(right)): one})
        for _, word in product:
            _need(word_sizes(reader, word, rows) == cols, f"a word of relation {name} has other sizes than the block")
        rest = add(rest, product, -Fraction(c))
    return rest


def _order(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    todo = list(leaves(statement, evidence.get("lemmas", ())))
    denominators: list[str] = []
    _need(len(todo) == len(evidence["parts"]), "as many parts as the conclusion has are needed")
    for number, ((case, formula), proof) in enumerate(zip(todo, evidence["parts"], strict=True), 1):
        leaf = Leaf(case, formula, proof["sum"], proof.get("roots", ()), proof.get("null", ""))
        blocks = proof["blocks"] if "blocks" in proof else [proof["terms"]]
        _need(len(blocks) == len(leaf.goals), f"part {number}: as many lists of terms as blocks are needed")
        for k, ((goal, rows, cols), terms) in enumerate(zip(leaf.goals, blocks, strict=True)):
            _need(not _less_multiples(leaf.reader, leaf.assumed(k), goal, rows, cols, terms), f"part {number}: the terms do not add up")
        denominators.extend(f"det({text(p)})" for p, _ in leaf.known if f"det({text(p)})" not in denominators)
    return denominators


def _word_induction(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    todo = list(inductions(statement))
    _need(len(todo) == len(evidence["conjuncts"]), "as many inductions as the conclusion has conjuncts are needed")
    denominators: list[str] = []
    for number, (part, proofs) in enumerate(zip(todo, evidence["conjuncts"], strict=True), 1):
        made = Induction(part, evidence.get("also", ()), evidence.get("shapes"))
        cases = [*((f"base {k}", s) for k, s in enumerate(made.bases)), *([("step", made.step)] if made.step else [])]
        _need(len(proofs) == len(cases), f"conjunct {number}: a proof for each base and for the step is needed")
        for (name, case), lemmas, proof in zip(cases, made.lemmas, proofs, strict=True):
            try:
                denominators.extend(d for d in _order(case, {**proof, "lemmas": [*proof.get("lemmas", ()), *lemmas]}) if d not in denominators)
            except (Rejected, Undefined, Unknown) as error:
                raise Rejected(f"conjunct {number}, {name}: {error}") from error
    return denominators


KINDS = {"membership": _membership, "order": _order, "word induction": _word_induction}
