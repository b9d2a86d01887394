# SPDX-License-Identifier: MIT
"""Ideal membership in the free algebra: proofs for every matrix size.

Given relations g_i and a goal f, look for f = sum of c l g_i r with words l, r.
The relations are completed by the noncommutative Buchberger algorithm up to a
degree, each new polynomial remembering how it came from the relations; the
goal is reduced along the way. The search is bounded by degree, number of
rules and time, and proves nothing: the checker expands what it returns.

Notation: a word is a tuple of letters; words are ordered by length, then by
letters. Reference: Mora (1986), Groebner bases for non-commutative polynomial
rings.
"""

from __future__ import annotations

import heapq
import time
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.order import Leaf, leaves
from exactkf.kernel.recursion import Induction, inductions
from exactkf.kernel.words import Reader, relations, residual_blocks

__all__ = ["find_induction", "find_membership", "find_order"]

Word = tuple[str, ...]
Poly = dict[Word, Fraction]
Cofactors = dict[tuple[Word, str, Word], Fraction]


@dataclass
class _Rule:
    lead: Word
    poly: Poly  # monic
    origin: Cofactors


def find_membership(statement: dict, degree: int = 8, seconds: float = 5.0) -> list[list] | None:
    """Terms for every block of the conclusion, or None.

    Parameters
    ----------
    statement : dict
        JSON of the statement.
    degree : int
        Longest leading word of a completed relation.
    seconds : float
        Time after which to give up.
    """
    try:
        reader = Reader(statement)
        goals = [p for b in residual_blocks(reader, statement["says"]) for row in b.grid for p in row]
        assumed = {name: _plain(p) for name, p in relations(reader).items()}
        wanted = [_plain(p) for p in goals]
    except (Unknown, Undefined):
        return None
    system = _System(assumed, degree, time.perf_counter() + seconds)
    out = []
    for goal in wanted:
        found = system.express(goal)
        if found is None:
            return None
        out.append([[str(c), list(left), name, list(right)] for (left, name, right), c in found.items()])
    return out


def find_order(statement: dict, sums: Any = (), roots: Any = (), lemmas: Any = (), degree: int = 8, seconds: float = 5.0) -> list[dict] | None:
    """For every leaf of the lemmas and the conclusion the terms of a proof, or None.

    Parameters
    ----------
    sums : sequence of lists of terms
        For each leaf the terms to try, see `exactkf.kernel.order.Leaf`. An empty list, or none, leaves it to the finder.
    roots : sequence of (name, term)
        Names for symmetric square roots that the terms use.
    lemmas : sequence of formulas
        Shown first, used after.
    """
    out = []
    for k, (case, formula) in enumerate(leaves(statement, lemmas)):
        for terms in [sums[k]] if k < len(sums) and sums[k] else _own_terms(case, formula):
            found = _complete(case, formula, terms, roots, degree, seconds)
            if found is not None:
                break
        else:
            return None
        out.append(found)
    return out


def find_induction(statement: dict, hints: Any = None, seconds: float = 5.0) -> dict | None:
    """Evidence of a ``word induction``, or None.

    Parameters
    ----------
    hints : mapping
        Of `exactkf.evidence.induction`: what is carried along, shapes of the state, terms for base and step.
    """
    hints = hints or {}
    for shapes in [hints["shapes"]] if hints.get("shapes") else _shapes(statement):
        conjuncts = []
        for number, part in enumerate(inductions(statement)):
            try:
                made = Induction(part, hints.get("also", ()), shapes)
                proofs = _prove_cases(made, hints, number, seconds)
            except (Unknown, Undefined, KeyError, TypeError):
                proofs = None
            if proofs is None:
                break
            conjuncts.append(proofs)
        else:
            return {"conjuncts": conjuncts, "also": list(hints.get("also", ())), "shapes": shapes}
    return None


def _prove_cases(made: Induction, hints: Any, number: int, seconds: float) -> list | None:
    """A proof for each base and for the step of one conjunct."""
    proofs = []
    for case, lemmas in zip([*made.bases, *([made.step] if made.step else [])], made.lemmas, strict=True):
        asked = hints.get("step" if case is made.step else "base") or [{}]
        given = asked[min(number, len(asked) - 1)]
        sums = [[made.at(t, case) for t in terms] for terms in given.get("sums", ())]
        roots = [[name, made.at(t, case)] for name, t in given.get("roots", ())]
        own = [made.at(t, case) for t in given.get("lemmas", ())]
        found = find_order(case, sums, roots, [*own, *lemmas], seconds=seconds)
        if found is None:
            return None
        proofs.append({"parts": found, "lemmas": own})
    return proofs


def _shapes(statement: dict) -> Iterator[dict]:
    """Shapes to try for the values of recursions: those of their initial values, then even ones in two halves."""
    yield {}
    halves = {}
    for d in statement["where"]:
        first = d[4][0] if d[0] == "rec" else 0
        size = first[1] if isinstance(first, list) and first[0] == "I" else 0
        if isinstance(size, list) and size[0] == "*" and size[1] == 2 and len(size) == 3:
            halves[d[1]] = [[size[2]] * 2] * 2
    if halves:
        yield halves


def _own_terms(case: dict, formula: Any) -> list[list]:
    """Terms to try: the matrix of the conclusion as it stands, with definitions left in, and those of the hypotheses."""
    op, args = formula[0], formula[1:]
    if op in ("=", "symmetric", "symplectic"):
        return [[]]
    if op == "invertible":
        return [[["inv", args[0]]]]
    given = [[f[1]] for _, f, _kind in case["given"] if f[0] in ("psd", "pd")]
    if op in ("psd", "pd"):
        return [[args[0]], *given]
    if op == "loewner":
        big, small = args
        return [[big]] if small == 0 else [[["-", big, small]], [big, ["neg", small]], [_without(big, small)], *given, []]
    return []


def _without(big: Any, small: Any) -> Any:
    """big - small where small is a summand of big."""
    if isinstance(big, list) and big[0] == "+" and small in big[1:]:
        rest = [x for x in big[1:]]
        rest.remove(small)
        return rest[0] if len(rest) == 1 else ["+", *rest]
    return ["-", big, small]


def _complete(case: dict, formula: Any, terms: list, roots: Any, degree: int, seconds: float) -> dict | None:
    """The terms, with the multiples of assumptions that make up for the rest."""
    equation = formula[0] in ("=", "symmetric", "symplectic")
    nulls = [label for label, f, _ in reversed(case["given"]) if f[0] == "="] if equation and terms else []
    for null in [*nulls, ""]:
        try:
            leaf = Leaf(case, formula, terms, roots, null)
            blocks = [_terms_for(leaf, k, degree, seconds) for k in range(len(leaf.goals))]
        except (Unknown, Undefined):
            continue
        if None not in blocks:
            return {"sum": terms, "blocks": blocks} | ({"roots": [list(r) for r in roots]} if roots else {}) | ({"null": null} if null else {})
    return None


def _terms_for(leaf: Leaf, k: int, degree: int, seconds: float) -> list | None:
    system = _System({name: _plain(p) for name, p in leaf.assumed(k).items()}, degree, time.perf_counter() + seconds)
    found = system.express(_plain(leaf.goals[k][0]))
    return None if found is None else [[str(c), list(left), name, list(right)] for (left, name, right), c in found.items()]


def _plain(p: dict) -> Poly:
    if any(s for s, _ in p):
        raise Unknown("scalar variables")
    return {w: c for (_, w), c in p.items()}


def _order(word: Word) -> tuple:
    return (len(word), word)


class _System:
    """A set of rules under completion."""

    def __init__(self, assumed: dict[str, Poly], degree: int, deadline: float) -> None:
        self.rules: list[_Rule] = []
        self.queue: list[tuple] = []
        self.degree, self.deadline, self.count = degree, deadline, 0
        for name, p in sorted(assumed.items(), key=lambda item: max(map(_order, item[1]), default=(0, ()))):
            self._insert(p, {((), name, ()): Fraction(1)})

    def express(self, goal: Poly) -> Cofactors | None:
        """Reduce the goal to zero, completing as long as that takes."""
        rest, origin = self._reduce(goal, {})
        while rest:
            if time.perf_counter() > self.deadline or not self._grow():
                return None
            rest, origin = self._reduce(rest, origin)
        return {key: -c for key, c in origin.items()}

    def _reduce(self, p: Poly, origin: Cofactors) -> tuple[Poly, Cofactors]:
        """Subtract multiples of rules until no word contains a leading word; origin records what was added."""
        p, origin, done = dict(p), dict(origin), {}
        while p:
            word = max(p, key=_order)
            hit = self._match(word)
            c = p[word]
            if hit is None:
                done[word] = p.pop(word)
                continue
            rule, at = hit
            left, right = word[:at], word[at + len(rule.lead):]
            for w, v in rule.poly.items():
                _bump(p, left + w + right, -c * v)
            for (a, name, b), v in rule.origin.items():
                _bump(origin, (left + a, name, b + right), -c * v)
        return done, origin

    def _match(self, word: Word) -> tuple[_Rule, int] | None:
        for rule in self.rules:
            n = len(rule.lead)
            for at in range(len(word) - n + 1):
                if word[at:at + n] == rule.lead:
                    return rule, at
        return None

    def _insert(self, p: Poly, origin: Cofactors) -> bool:
        p, origin = self._reduce(p, origin)
        if not p:
            return False
        lead = max(p, key=_order)
        c = p[lead]
        rule = _Rule(lead, {w: v / c for w, v in p.items()}, {k: v / c for k, v in origin.items()})
        contained = [r for r in self.rules if _contains(r.lead, lead)]
        self.rules = [r for r in self.rules if not _contains(r.lead, lead)]
        self.rules.append(rule)
        self.rules.sort(key=lambda r: _order(r.lead))
        for other in self.rules:
            for pair in _overlaps(rule, other):
                self._push(pair)
            if other is not rule:
                for pair in _overlaps(other, rule):
                    self._push(pair)
        for old in contained:
            self._insert(old.poly, old.origin)
        return True

    def _push(self, pair: tuple[_Rule, Word, _Rule, Word, Word]) -> None:
        first, right, second, left, whole = pair
        if len(whole) <= self.degree:
            self.count += 1
            heapq.heappush(self.queue, (len(whole), self.count, pair))

    def _grow(self) -> bool:
        """Treat overlaps until one gives a new rule."""
        while self.queue and len(self.rules) < 400:
            if time.perf_counter() > self.deadline:
                return False
            _, _, (first, right, second, left, _whole) = heapq.heappop(self.queue)
            p: Poly = {}
            origin: Cofactors = {}
            for w, v in first.poly.items():
                _bump(p, w + right, v)
            for w, v in second.poly.items():
                _bump(p, left + w, -v)
            for (a, name, b), v in first.origin.items():
                _bump(origin, (a, name, b + right), v)
            for (a, name, b), v in second.origin.items():
                _bump(origin, (left + a, name, b), -v)
            if self._insert(p, origin):
                return True
        return False


def _bump(table: dict[Any, Fraction], key: Any, by: Fraction) -> None:
    s = table.get(key, 0) + by
    if s:
        table[key] = s
    else:
        table.pop(key, None)


def _contains(word: Word, part: Word) -> bool:
    return any(word[i:i + len(part)] == part for i in range(len(word) - len(part) + 1))


def _overlaps(first: _Rule, second: _Rule) -> Iterator[tuple[_Rule, Word, _Rule, Word, Word]]:
    """Words that start with the first leading word and end with the second."""
    u, v = first.lead, second.lead
    for k in range(1, min(len(u), len(v))):
        if u[-k:] == v[:k]:
            yield first, v[k:], second, u[:-k], u + v[k:]
