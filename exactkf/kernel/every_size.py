# SPDX-License-Identifier: MIT
"""Replaying what is proved for every size.

``membership``
    lhs - rhs = sum of c l (assumption) r in words of letters
``order``
    equations, order and invertibility: terms, and multiples of the assumptions
``word induction``
    base and step, each by an ``order``
``generic index``
    recursions of growing degree: lemmas by induction, then the conclusion
``arithmetic``
    integers: the denied statement contradicts itself in every case
``conjunction``
    the members of a conjunction, each by one of these

Main definitions
----------------
`KINDS`
    Kinds of certificates and the functions that replay them.
`members_of`
    The members of a conjunction.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

from exactkf.kernel.arithmetic import arithmetic
from exactkf.kernel.continuity import away_from_zero
from exactkf.kernel.index_induction import generic_index
from exactkf.kernel.numbers import Rejected, Undefined, Unknown, fraction
from exactkf.kernel.order import Leaf, leaves, register_inverses
from exactkf.kernel.reader import Reader, relations, residual_blocks, word_sizes
from exactkf.kernel.recursion import Induction, along, before, inductions
from exactkf.kernel.words import Blocks, Poly, Relation, Size, Word, number, text, times_scalars

__all__ = ["HELP", "KINDS", "members_of"]


def _need(condition: bool, step: str) -> None:
    if not condition:
        raise Rejected(step)


def _membership(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    whole = Reader(statement)
    goals = [(cell, k) for k, part in enumerate(members_of(statement["says"])) for b in residual_blocks(whole, part) for cell in b.cells()]
    assumed = relations(whole)
    _need(len(goals) == len(evidence["terms"]), "as many lists of terms as blocks are needed")
    at, reader, known = -1, whole, assumed
    for place, (((goal, rows, cols), k), terms) in enumerate(zip(goals, evidence["terms"], strict=True), 1):
        if k != at:
            at, (reader, known) = k, _up_to(statement, k, whole, assumed)
        _need(not _less_multiples(reader, known, goal, rows, cols, terms), f"block {place}: the terms do not add up")
    return [f"det({_text(term)})" for term, _ in whole.inverses]


def members_of(formula: Any) -> list[Any]:
    """The members of a conjunction, in order."""
    return [x for part in formula[1:] for x in members_of(part)] if formula[0] == "and" else [formula]


def _up_to(statement: Mapping[str, Any], k: int, whole: Reader, assumed: dict[str, Relation]) -> tuple[Reader, dict[str, Relation]]:
    """What may be assumed for a member of a conjunction: those after it need not have a value where it is false."""
    reader, parts = Reader(statement), members_of(statement["says"])
    for part in parts[:k + 1]:
        residual_blocks(reader, part)
    for part in parts[k + 1:]:
        register_inverses(reader, part, evaluated=False)
    found = list(relations(reader).values())
    if (len(reader.inverses), len(reader.quotients), reader.units) == (len(whole.inverses), len(whole.quotients), whole.units):
        return whole, assumed
    return reader, {name: relation for name, relation in assumed.items() if relation in found}


def _less_multiples(reader: Reader, assumed: Mapping[str, Relation], goal: Poly, rows: Size, cols: Size, terms: list,
                    letters: Sequence[str] = ()) -> Poly:
    """What is left of a polynomial after multiples c s l (assumption) r are taken off; s is a monomial in the scalars.

    A number in a word stands for one of the letters.
    """
    rest = dict(goal)
    sizes: dict[tuple[Word, Size], Size] = {}

    def after(word: Word, start: Size) -> Size:
        found = sizes.get((word, start))
        if found is None:
            found = sizes[word, start] = word_sizes(reader, word, start)
        return found

    for c, left, name, right, *more in terms:
        before = tuple([letters[a] if type(a) is int else a for a in left]) if letters else tuple(left)
        behind = tuple([letters[a] if type(a) is int else a for a in right]) if letters else tuple(right)
        scalars = times_scalars((), tuple((n, e) for n, e in more[0])) if more else ()
        if scalars:
            _need(all(type(e) is int for _, e in scalars), "an exponent is no integer")
            _need(all(e > 0 or n in reader.units for n, e in scalars), "a term is divided by a scalar that may vanish")
        relation = assumed[name] if isinstance(name, str) else _between_numbers(reader, assumed, name)
        start = after(before, rows)
        if relation.rows is not None:
            if start != relation.rows:
                raise Rejected(f"relation {name} has other sizes than the word before it")
            start = relation.cols  # type: ignore[assignment]
        if after(behind, start) != cols:
            raise Rejected(f"a word of relation {name} has other sizes than the block")
        factor = c if type(c) is int else _factor(c)
        for (s, word), value in relation.poly.items():
            key = (times_scalars(s, scalars) if s and scalars else s or scalars, before + word + behind)
            rest[key] = rest.get(key, 0) - factor * value
    return {key: value for key, value in rest.items() if value}


@lru_cache(maxsize=1 << 10)
def _factor(text: str) -> Any:
    return number(fraction(text))


def _between_numbers(reader: Reader, assumed: Mapping[str, Relation], name: Any) -> Relation:
    """A 1 x 1 word and its scalar; or an equation of scalars, with its proof as one of 1 x 1 matrices."""
    if isinstance(name, list):
        return reader.as_scalar(tuple(name))
    one = (("", 1),)
    poly: Poly = {(times_scalars((), tuple((n, e) for n, e in s)), ()): c if type(c) is int else _factor(c) for c, s in name["numbers"]}
    _need(all(type(e) is int for s, _ in poly for _, e in s), "an exponent is no integer")
    _need(not _less_multiples(reader, assumed, poly, one, one, name["terms"]), "an equation of scalars: the terms do not add up")
    return Relation(poly, None, None)


def _text(term: Blocks) -> str:
    rows = [", ".join(text(p) for p in row) for row in term.grid]
    return rows[0] if len(rows) == len(term.grid[0]) == 1 else f"[{'; '.join(rows)}]"


#: what the proof of a leaf may bring in beside its terms
HELP = ("roots", "null", "vector", "factors", "solutions", "stein", "unique", "kept", "pencil", "inertia")


def _order(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    if "away from zero" in evidence:
        statement = away_from_zero(statement, evidence["away from zero"])
    todo = list(leaves(statement, evidence.get("lemmas", ()), evidence.get("inside", ())))
    denominators: list[str] = []
    _need(len(todo) == len(evidence["parts"]), "as many parts as the conclusion has are needed")
    for place, ((case, formula), proof) in enumerate(zip(todo, evidence["parts"], strict=True), 1):
        leaf = Leaf(case, formula, proof["sum"], **{key: proof[key] for key in HELP if key in proof})
        blocks = proof["blocks"] if "blocks" in proof else [proof["terms"]]
        _need(len(blocks) == len(leaf.goals), f"part {place}: as many lists of terms as blocks are needed")
        for k, ((goal, rows, cols), terms) in enumerate(zip(leaf.goals, blocks, strict=True)):
            _need(not _less_multiples(leaf.reader, leaf.assumed(k), goal, rows, cols, terms, proof.get("letters", ())),
                  f"part {place}: the terms do not add up")
        denominators.extend(d for term, _ in leaf.known if (d := f"det({_text(term)})") not in denominators)
    return denominators


def _word_induction(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    denominators: list[str] = []
    for place, lemma in enumerate(evidence.get("before", ()), 1):
        alone, formula, statement = before(statement, lemma["says"])
        made = Induction(alone, [formula, *lemma.get("also", ())], evidence.get("shapes"))
        _by_cases(f"lemma {place}", made, lemma["proofs"], denominators)
    todo = list(inductions(statement))
    _need(len(todo) == len(evidence["conjuncts"]), "as many inductions as the conclusion has conjuncts are needed")
    for place, (part, proofs) in enumerate(zip(todo, evidence["conjuncts"], strict=True), 1):
        made = Induction(part, along(evidence.get("also", ()), place - 1), evidence.get("shapes"))
        _by_cases(f"conjunct {place}", made, proofs, denominators)
    return denominators


def _by_cases(name: str, made: Induction, proofs: list, denominators: list[str]) -> None:
    """Each base and the step by an ``order``."""
    cases = [*((f"base {k}", s) for k, s in enumerate(made.bases)), *([("step", made.step)] if made.step else [])]
    _need(len(proofs) == len(cases), f"{name}: a proof for each base and for the step is needed")
    for (which, case), lemmas, proof in zip(cases, made.lemmas, proofs, strict=True):
        try:
            denominators.extend(d for d in _order(case, {**proof, "lemmas": [*proof.get("lemmas", ()), *lemmas]}) if d not in denominators)
        except (Rejected, Undefined, Unknown) as error:
            raise Rejected(f"{name}, {which}: {error}") from error


def _conjunction(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    """Each member by a proof of its own kind.

    A conjunction is looked at in order: where it is false on an instance, so is one of its members, which has a value there; and
    that member has been shown of all instances of the same hypotheses.
    """
    members, denominators = members_of(statement["says"]), dict[str, None]()
    _need(statement["says"][0] == "and" and len(members) == len(evidence["parts"]), "as many proofs as members of the conjunction are needed")
    for place, (member, (kind, own)) in enumerate(zip(members, evidence["parts"], strict=True), 1):
        _need(kind in KINDS and kind != "conjunction", f"member {place}: a kind of proof for every size is needed")
        try:
            denominators.update(dict.fromkeys(KINDS[kind]({**statement, "says": member}, own)))
        except (Rejected, Undefined, Unknown) as error:
            raise Rejected(f"member {place}: {error}") from error
    return list(denominators)


KINDS = {"membership": _membership, "order": _order, "word induction": _word_induction, "generic index": generic_index,
         "arithmetic": arithmetic, "conjunction": _conjunction}
