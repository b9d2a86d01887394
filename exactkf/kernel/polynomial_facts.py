# SPDX-License-Identifier: MIT
"""Polynomials in atoms, and facts about them, as `exactkf.kernel.arithmetic` has them.

Main definitions
----------------
`plus`, `times`, `number`, `frozen`
    Polynomials as mappings of products of atoms to coefficients.
`joined`, `either`
    Conjunctions and disjunctions of facts.
"""

from __future__ import annotations

from itertools import product
from typing import Any

__all__ = ["ONE", "Fact", "Names", "Poly", "either", "frozen", "joined", "number", "plus", "times"]

#: products of atoms, sorted, with coefficients that are not zero
Poly = dict[tuple, Any]
#: ("=" or ">=" or ">", p); ("and" or "or", facts); ("all" or "some", name, low, high, body, names, affirmed, valued)
Fact = tuple
Names = dict[str, Poly]

ONE: Poly = {(): 1}


def plus(x: Poly, y: Poly, c: Any = 1) -> Poly:
    """x + c y."""
    out = dict(x)
    for m, v in y.items():
        out[m] = out.get(m, 0) + c * v
    return {m: v for m, v in out.items() if v}


def times(x: Poly, y: Poly) -> Poly:
    """x y."""
    out: Poly = {}
    for (m, v), (n, w) in product(x.items(), y.items()):
        key = tuple(sorted(m + n, key=repr))
        out[key] = out.get(key, 0) + v * w
    return {m: v for m, v in out.items() if v}


def number(c: Any) -> Poly:
    """A constant."""
    return {(): c} if c else {}


def frozen(p: Poly) -> tuple:
    """As an argument of an atom: written in one way, as atoms are put in order by how they are written."""
    return tuple(sorted(((m, int(v) if v.denominator == 1 else v) for m, v in p.items()), key=repr))


def either(cases: list[tuple[tuple[Fact, ...], Fact]]) -> Fact:
    """One of the cases, whose conditions exclude each other and leave nothing out."""
    return joined("or", [joined("and", [*conditions, fact]) for conditions, fact in cases])


def joined(op: str, facts: list[Fact]) -> Fact:
    """A conjunction or disjunction, those of the same kind in it taken apart; of one fact it is that fact."""
    flat = [f for fact in facts for f in (fact[1] if fact[0] == op else [fact])]
    return flat[0] if len(flat) == 1 else (op, flat)
