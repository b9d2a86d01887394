# SPDX-License-Identifier: MIT
"""Which classical facts a certificate uses, by their names in `exactkf.kernel.order.FACTS`; read off after it has been replayed.

Main definitions
----------------
`facts_used`
    Their names.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from exactkf.kernel.continuity import away_from_zero
from exactkf.kernel.definite import _by_hypothesis, _is_number, definiteness
from exactkf.kernel.every_size import HELP, members_of
from exactkf.kernel.order import FACTS, Leaf, leaves
from exactkf.kernel.reader import Reader
from exactkf.kernel.recursion import Induction, along, before, inductions

__all__ = ["facts_used"]


def facts_used(certificate: Mapping[str, Any]) -> list[str]:
    """Names of the facts, in the order of the list; none for kinds of certificates that are about equations alone.

    Parameters
    ----------
    certificate : dict
        One that has been replayed.
    """
    used = {name for statement, evidence in _orders(certificate) for name in _of_order(statement, evidence)}
    return [name for name in FACTS if name in used]


def _orders(certificate: Mapping[str, Any]) -> Iterator[tuple[Mapping[str, Any], Mapping[str, Any]]]:
    """The statements that are shown by an ``order``: base and step of an induction are."""
    statement, evidence = certificate["statement"], certificate["evidence"]
    if certificate["kind"] == "order":
        yield statement, evidence
    if certificate["kind"] == "conjunction":
        for part, (kind, own) in zip(members_of(statement["says"]), evidence["parts"], strict=True):
            yield from _orders({"kind": kind, "statement": {**statement, "says": part}, "evidence": own})
    if certificate["kind"] != "word induction":
        return
    for lemma in evidence.get("before", ()):
        alone, formula, statement = before(statement, lemma["says"])
        yield from _cases(Induction(alone, [formula, *lemma.get("also", ())], evidence.get("shapes")), lemma["proofs"])
    for place, (part, proofs) in enumerate(zip(inductions(statement), evidence["conjuncts"], strict=True)):
        yield from _cases(Induction(part, along(evidence.get("also", ()), place), evidence.get("shapes")), proofs)


def _cases(made: Induction, proofs: list) -> Iterator[tuple[Mapping[str, Any], Mapping[str, Any]]]:
    cases = [*made.bases, *([made.step] if made.step else [])]
    for case, lemmas, proof in zip(cases, made.lemmas, proofs, strict=True):
        yield case, {**proof, "lemmas": [*proof.get("lemmas", ()), *lemmas]}


def _of_order(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> Iterator[str]:
    if "away from zero" in evidence:
        yield "continuity"
        statement = away_from_zero(statement, evidence["away from zero"])
    todo = leaves(statement, evidence.get("lemmas", ()), evidence.get("inside", ()))
    for (case, formula), proof in zip(todo, evidence["parts"], strict=True):
        yield from _of_leaf(case, formula, proof)


_BY_KEY = {"null": "null vectors", "roots": "square root", "factors": "determinant",
           "solutions": "Stein equation", "stein": "Stein equation", "unique": "Stein equation", "kept": "invariant subspace", "pencil": "detectable pencil",
           "inertia": "inertia"}


def _of_leaf(case: dict, formula: Any, proof: Mapping[str, Any]) -> Iterator[str]:
    yield from (name for key, name in _BY_KEY.items() if proof.get(key))
    op, terms, vector = formula[0], proof["sum"], proof.get("vector")
    if vector:
        yield "null space"
    if case["given"] and any(label.startswith("eigenvector") for label, _, _ in case["given"]):
        yield "eigenvalues"
    if op == "invertible" and not vector:
        yield "right inverse"
    if op in ("similar", "cospectral"):
        yield "similarity"
    if op == "=" and len(terms) == 4 and not vector and isinstance(formula[1], list) and formula[1][0] == "rank":
        yield "rank"
    bound = op == "<=" and isinstance(formula[1], list) and formula[1][0] == "rank"
    if bound:
        yield "rank"
    leaf = Leaf(case, formula, terms, **{key: proof[key] for key in HELP if key in proof})
    if leaf.reader.steins:
        yield "Stein equation"
    for term in (x for tree in terms for x in _inverted(tree)):
        if leaf.reader.read(term) not in (x for x, _ in leaf.known):  # brought in: it exists by its form
            yield "nonsingular"
            yield from _of_form(leaf.reader, term) if definiteness(leaf.reader, term) == 2 else ()
    ordered = op in ("psd", "pd", "loewner", ">=", ">", "<", "<=") and not bound
    if len(terms) > 1 and (ordered or proof.get("null")):
        yield "sum"
    for term in [*(terms if ordered or proof.get("null") else ()), *(tree for _, tree in proof.get("roots", ()))]:
        yield from _of_form(leaf.reader, term)


def _of_form(reader: Reader, tree: Any) -> Iterator[str]:
    """What makes a term semidefinite, as `exactkf.kernel.definite.definiteness` reads it."""
    if not isinstance(tree, (list, tuple)) or not tree or tree[0] == "^" or tree[0] == "rat":
        yield "number"
    elif _by_hypothesis(reader, tree):
        yield "hypothesis"
    elif tree[0] == "sym":
        definition = reader.lets.get(tree[1])
        if tree[1] not in reader.kinds and definition is not None:
            yield from _of_form(reader, definition[3])
        else:
            yield "hypothesis"
    elif tree[0] in ("I", "O"):
        yield "identity"
    elif tree[0] == "block":
        yield "block diagonal"
        for i, row in enumerate(tree[1:]):
            yield from _of_form(reader, row[i])
    elif tree[0] == "-":
        yield "trace"
        yield from _of_form(reader, tree[2])
    elif tree[0] == "*":
        yield from _of_product(reader, tree)
    else:
        if tree[0] in ("+", "inv", "/"):
            yield {"+": "sum", "inv": "inverse", "/": "number"}[tree[0]]
        for part in tree[1:2] if tree[0] == "/" else tree[1:]:
            yield from _of_form(reader, part)


def _inverted(tree: Any) -> Iterator[Any]:
    if isinstance(tree, (list, tuple)):
        if tree and tree[0] == "inv":
            yield tree[1]
        for part in tree:
            yield from _inverted(part)


def _of_product(reader: Reader, tree: Any) -> Iterator[str]:
    matrices = [x for x in tree[1:] if not _is_number(reader, x)]
    if len(matrices) < len(tree) - 1:
        yield "number"
        yield from ("trace" for x in tree[1:] if isinstance(x, (list, tuple)) and x[0] == "tr")
    if len(matrices) > 1:
        yield "congruence"
        if definiteness(reader, tree) == 2:
            yield "nonsingular"
    if len(matrices) % 2:
        yield from _of_form(reader, matrices[len(matrices) // 2])
