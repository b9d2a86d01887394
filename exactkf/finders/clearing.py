# SPDX-License-Identifier: MIT
"""Quotients taken out of facts, for `exactkf.finders.arithmetic`.

Let q = x/y and y > 0 (or -y > 0). A fact f >= 0 with f = a q + b gives a x + b y >= 0: the negation contradicts y f >= 0 and q y = x. So one
quotient after the other, outermost first, leaves the facts, and what remains are polynomials.

Main definitions
----------------
`clear`
    The next step of that.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import reduce
from typing import Any

from exactkf.kernel.arithmetic import ONE, Facts, Poly, plus, times

__all__ = ["clear"]

Proof = dict[str, Any]
Prove = Callable[[Facts], Proof]
_RELATIONS = ("=", ">=", ">")


def clear(facts: Facts, prove: Prove, zero: Prove, tree_of: Callable[[Poly], Any]) -> Proof | None:
    """A proof that begins with taking a quotient out of a fact, or what that needs; None if there is none to be taken.

    ``prove`` goes on with other facts, ``zero`` with the fact that something divided by is zero.
    """
    if idle := _idle(facts):
        step = {"step": "forget", "facts": idle}
        return {**step, "then": [prove(facts.step(step)[0])]}
    for q in _outermost(facts):
        x, y = dict(q[1]), dict(q[2])
        known = _sign(facts, y)
        told = plus(times({(q,): 1}, y), x, -1)
        equation = _told(facts, told)
        target = next((n for n, f in enumerate(facts.facts) if n != equation and f is not None and f[0] in _RELATIONS and _degree(f[1], q)), None)
        if target is None:
            continue
        if x != ONE:
            return _as_inverse(facts, q, prove, zero, tree_of)
        if known is None:
            return _signed(facts, y, prove, zero, tree_of)
        if equation is None:
            step = {"step": "quotient", "x": tree_of(x), "y": tree_of(y)}
            return {**step, "then": [prove(facts.step(step)[0])]}
        if _ratio(facts.facts[known[0]][1], plus({}, y, known[1])) is not None:  # type: ignore[index]
            return _taken(facts, target, q, known, equation, prove, tree_of)  # that an integer is positive is known as y - 1 >= 0
    return None


def _outermost(facts: Facts) -> list[Any]:
    """Quotients that are in no other atom of the facts."""
    atoms = {a for f in facts.facts if f is not None and f[0] in _RELATIONS for m in f[1] for a in m if isinstance(a, tuple)}
    below = {b for a in atoms for b in _inside(a)}
    return sorted((a for a in atoms - below if a[0] == "/"), key=repr)


def _inside(atom: tuple) -> Iterator[Any]:
    for part in atom[1:]:
        for m, _ in part if isinstance(part, tuple) else ():
            for a in m:
                if isinstance(a, tuple):
                    yield a
                    yield from _inside(a)


def _degree(p: Poly, q: Any) -> int:
    return max((m.count(q) for m in p), default=0)


def _ratio(p: Poly, q: Poly) -> Any:
    """c with p = c q, if there is one."""
    if set(p) != set(q) or not p:
        return None
    m = next(iter(p))
    c = Fraction(p[m]) / q[m]
    return c if all(p[k] == c * q[k] for k in p) else None


def _told(facts: Facts, p: Poly) -> int | None:
    """The number of the fact that p = 0."""
    return next((n for n, f in enumerate(facts.facts) if f is not None and f[0] == "=" and _ratio(f[1], p) is not None), None)


def _as_inverse(facts: Facts, q: Any, prove: Prove, at_zero: Prove, tree_of: Callable[[Poly], Any]) -> Proof:
    """q = x (1/y) by q y = x and (1/y) y = 1; it is solved for q then."""
    x, y = dict(q[1]), dict(q[2])
    inverse, found = facts.quotient(ONE, y), []
    for over, quotient in ((x, {(q,): 1}), (ONE, inverse)):
        equation = plus(times(quotient, y), over, -1)
        number = _told(facts, equation)
        if number is None:
            step = {"step": "quotient", "x": tree_of(over), "y": tree_of(y)}
            case = facts.step(step)[0]
            split = {"step": "split", "fact": len(case.facts) - 1}
            zero, other = case.step(split)
            return {**step, "then": [{**split, "then": [at_zero(zero), prove(other)]}]}
        found.append((number, _ratio(facts.facts[number][1], equation)))  # type: ignore[index]
    gap = plus({(q,): 1}, times(x, inverse), -1)
    step = {"step": "cut", "formula": ["=", tree_of(gap), 0]}
    after, denied = facts.step(step)
    split = {"step": "split", "fact": len(denied.facts) - 1}
    proofs = []
    for case in denied.step(split):
        c = _ratio(case.facts[-1][1], gap)  # type: ignore[index]
        sign = -1 if c > 0 else 1  # gap = inverse (q y - x) - q (inverse y - 1)
        factors = [(found[0], inverse), (found[1], plus({}, {(q,): 1}, -1))]
        terms = [[str(1 / abs(c)), [len(case.facts) - 1]], *([str(Fraction(sign) / scale), [number], tree_of(p)] for (number, scale), p in factors)]
        proofs.append({"step": "close", "terms": terms})
    solve = {"step": "solve", "fact": len(after.facts) - 1, "variable": repr(next(a for m in after.facts[-1][1] for a in m if a == q))}  # type: ignore[index]
    return {**step, "then": [{**solve, "then": [prove(after.step(solve)[0])]}, {**split, "then": proofs}]}


def _sign(facts: Facts, y: Poly) -> tuple[int, int] | None:
    """The number of the fact that y, or -y, is positive, and the sign."""
    return next(((n, s) for n, f in enumerate(facts.facts) for s in (1, -1) if f == facts.relation(">", plus({}, y, s))), None)


def _idle(facts: Facts) -> list[int]:
    """Equations q y = x of quotients that occur nowhere else, where the sign of y is known."""
    where: dict[Any, set[int]] = {}
    for n, f in enumerate(facts.facts):
        for a in {a for m in f[1] for a in m} if f is not None and f[0] in _RELATIONS else ():
            for b in (a, *_inside(a)) if isinstance(a, tuple) else ():
                where.setdefault(b, set()).add(n)
    found = set[int]()
    for q, places in where.items():
        if q[0] == "/" and all(_ratio(facts.facts[n][1], plus(times({(q,): 1}, dict(q[2])), dict(q[1]), -1)) is not None for n in places):  # type: ignore[index]
            others = any(b[0] == "/" and b[2] == q[2] and b != q for b in where if isinstance(b, tuple))
            found |= places if _sign(facts, dict(q[2])) and not others else set()
    return sorted(found)


def _signed(facts: Facts, y: Poly, prove: Prove, at_zero: Prove, tree_of: Callable[[Poly], Any]) -> Proof:
    """Cases: what is divided by is zero, positive or negative."""
    step = {"step": "cut", "formula": ["=", tree_of(y), 0]}
    zero, other = facts.step(step)
    if other.facts[-1] is None or other.facts[-1][0] != "or":  # a number, or an integer of one sign
        return {**step, "then": [at_zero(zero), prove(other)]}
    split = {"step": "split", "fact": len(other.facts) - 1}
    return {**step, "then": [at_zero(zero), {**split, "then": [prove(case) for case in other.step(split)]}]}


def _taken(facts: Facts, target: int, q: Any, known: tuple[int, int], equation: int, prove: Prove, tree_of: Callable[[Poly], Any]) -> Proof:
    """The fact times a power of y, with x in place of q y, instead of the fact."""
    (place, s), (op, f) = known, facts.facts[target]  # type: ignore[misc]
    x, y, d = dict(q[1]), plus({}, dict(q[2]), s), _degree(f, q)  # y is positive, and q y = s x
    x = plus({}, x, s)
    powers = [_product([y] * k) for k in range(d + 1)]
    parts: list[Poly] = [{} for _ in range(d + 1)]
    for m, c in f.items():
        k = m.count(q)
        parts[k] = plus(parts[k], {tuple(a for a in m if a != q): c})
    made: Poly = {}
    factor: Poly = {}  # (q y - s x) times this is what the replacement takes off
    for k, a in enumerate(parts):
        made = plus(made, times(times(a, _product([x] * k)), powers[d - k]))
        inner: Poly = {}
        for i in range(k):
            inner = plus(inner, times(_product([times({(q,): 1}, y)] * i), _product([x] * (k - 1 - i))))
        factor = plus(factor, times(times(a, powers[d - k]), inner))
    scale = _ratio(facts.facts[equation][1], plus(times({(q,): 1}, y), x, -1))  # type: ignore[index]
    scale_y = _ratio(facts.facts[place][1], y)  # type: ignore[index]
    step = {"step": "cut", "formula": [op, tree_of(made), 0]}
    after, denied = facts.step(step)
    forget = {"step": "forget", "facts": [target]}
    rest = {**forget, "then": [prove(after.step(forget)[0])]}

    def closing(case: Facts) -> Proof:
        negated, number = case.facts[-1], len(case.facts) - 1
        if op != "=" and set(made) <= {()} and (made.get((), 0) < 0 or op == ">" and not made):  # the fact contradicts itself
            return {"step": "close", "terms": [[str(1 / scale_y**d), [target, *[place] * d]], [str(-1 / scale), [equation], tree_of(factor)]]}
        c = _ratio(negated[1], made) if negated is not None and set(made) - {()} else None
        if c is None:  # the formula was a number
            return prove(case)
        sign = -1 if c < 0 else 1
        if op == "=":  # sign f y^d
            terms = [[str(-sign), [target], tree_of(powers[d])], [str(1 / abs(c)), [number]], [str(Fraction(sign) / scale), [equation], tree_of(factor)]]
        else:
            terms = [[str(1 / scale_y**d), [target, *[place] * d]], [str(1 / abs(c)), [number]], [str(-1 / scale), [equation], tree_of(factor)]]
        return {"step": "close", "terms": terms}

    if denied.facts[-1] is not None and denied.facts[-1][0] == "or":
        split = {"step": "split", "fact": len(denied.facts) - 1}
        return {**step, "then": [rest, {**split, "then": [closing(case) for case in denied.step(split)]}]}
    return {**step, "then": [rest, closing(denied)]}


def _product(factors: list[Poly]) -> Poly:
    return reduce(times, factors, ONE)
