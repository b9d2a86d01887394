# SPDX-License-Identifier: MIT
"""Numbers of things, and proofs for every size, in words."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

from flint import fmpz

from exactkf._facts import facts_used
from exactkf.kernel.every_size import members_of

__all__ = ["multiples_in_words", "number_of", "over_primes", "proof_in_words"]

_FOR_EVERY_SIZE = {
    "membership": "for every size: {}, expanded in words",
    "order": "for every size: multiples of the assumptions in words; classical facts: {}",
    "word induction": "for every size, by induction: base and step by multiples of the assumptions in words; classical facts: {}",
    "generic index": "for every size, by induction: base and step as identities between coefficients, sums and entries at a generic index",
    "arithmetic": "for all values: the denied statement contradicts itself, case by case",
}


def number_of(count: int, thing: str) -> str:
    """A number with its noun.

    >>> number_of(1, "check"), number_of(2, "check")
    ('1 check', '2 checks')
    """
    return f"{count} {thing}" + "s" * (count != 1)


def proof_in_words(certificate: Mapping[str, Any]) -> str:
    """What the checker has replayed, of a certificate that holds for every size.

    >>> proof_in_words({"kind": "membership", "evidence": {"terms": []}})
    'for every size: without assumptions, expanded in words'
    """
    evidence, kind = certificate["evidence"], certificate["kind"]
    if kind == "conjunction":
        members = zip(members_of(certificate["statement"]["says"]), evidence["parts"], strict=True)
        own = ({"kind": other, "statement": {**certificate["statement"], "says": part}, "evidence": e} for part, (other, e) in members)
        return "; ".join(dict.fromkeys(map(proof_in_words, own)))
    used = multiples_in_words(evidence) if kind == "membership" else ", ".join(facts_used(certificate)) or "none"
    return _FOR_EVERY_SIZE[kind].format(used) + _of_stable(evidence) + over_primes(evidence)


def multiples_in_words(evidence: Mapping[str, Any]) -> str:
    """How many multiples of the assumptions a membership adds up."""
    count = sum(map(len, evidence.get("terms", ())))
    return f"{number_of(count, 'multiple')} of the assumptions" if count else "without assumptions"


def over_primes(evidence: Mapping[str, Any]) -> str:
    """The ring in which the multiples are taken, where that is not the integers."""
    below = {Fraction(c).denominator for c in _coefficients(evidence)}
    primes = sorted({int(p) for d in below for p, _ in fmpz(d).factor()})
    return f", over Z[{', '.join(f'1/{p}' for p in primes)}]" if primes else ""


def _of_stable(evidence: Mapping[str, Any]) -> str:
    """What a proof makes of stable matrices."""
    used = {key for part in evidence.get("parts", ()) for key in part} & {"stein", "unique", "solutions"}
    return ", and Stein equations X = MXM' + Q of stable M, which have one solution, semidefinite for semidefinite Q" if used else ""


def _coefficients(tree: Any, listed: bool = False) -> Iterator[str]:
    """Coefficients of the multiples of assumptions in the evidence of a certificate."""
    if isinstance(tree, dict):
        for key, value in tree.items():
            yield from _coefficients(value, key in ("terms", "blocks"))
    elif isinstance(tree, list):
        if listed and tree and isinstance(tree[0], str):
            yield tree[0]
            tree = [x for x in tree[2:3] if isinstance(x, dict)]  # an equation of numbers with its own proof
        for value in tree:
            yield from _coefficients(value, listed)
