# SPDX-License-Identifier: MIT
"""Search for refutations in `exactkf.kernel.arithmetic`.

Between the steps that hints name, what needs no choice is done by itself: equations are solved for a variable, what
exists gets a name, disjunctions lose the parts that contradict the rest. A leaf is closed by linear programming over products of facts.

Main definitions
----------------
`find_arithmetic`
    A proof as the checker reads it, or None.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import reduce
from itertools import chain, combinations_with_replacement, islice
from typing import Any

from exactkf.finders.clearing import clear
from exactkf.finders.effort import clock
from exactkf.finders.simplex import combination
from exactkf.kernel.arithmetic import ONE, Facts, Poly, plus, times
from exactkf.kernel.numbers import Rejected, Unknown

__all__ = ["StuckAt", "find_arithmetic"]

_MOST_PRODUCTS = 600
_MOST_CASES = 5000
Proof = dict[str, Any]
Hint = list[Any]


class StuckAt(Exception):
    """No way to go on: the facts of the case are the argument, in words."""


def find_arithmetic(statement: Mapping[str, Any], hints: Sequence[Hint], seconds: float) -> Proof | None:
    """A refutation of the denied statement, by the hints in their order.

    A hint is a list: ``["divide", term, m, name, hints for each rest]``, ``["at", index, term]``, ``["cut", formula, hints for either case]``,
    ``["lemma", formula, [], hints]``,
    ``["induct", name, from, formula, hints for base, step and afterwards]``, ``["unfold", name, term]``, ``["quotient", x, y]``,
    ``["product", a, b, n]``, ``["cosines", a, b, n]``, ``["right", n]``, ``["acute", a, n]``, ``["root", x]``, ``["exist", name, term]`` or
    ``["valued", label]``; that the conclusion is evaluated takes the place of its denial.
    By the term of ``["multiply", term]`` equations are multiplied too; with ``["clear"]`` quotients are taken out of the facts. The square of the term of
    ``["square", term]`` is not negative; with ``["degree", 3]`` facts are multiplied three at a time.
    """
    try:
        return _Search(clock() + seconds).start(statement, hints)
    except (StuckAt, Rejected, Unknown, RecursionError):
        return None


class _Search:
    """One search, with what it may still take."""

    def __init__(self, deadline: float) -> None:
        self.deadline, self.cases = deadline, 0

    def start(self, statement: Mapping[str, Any], hints: Sequence[Hint]) -> Proof:
        denied = Facts(statement)
        self.hypotheses = len(denied.facts)
        denied.add(denied.read(statement["says"], False))
        self.denied = len(denied.facts)
        if ["valued", ""] in hints:
            return self.evaluated(denied, [h for h in hints if h != ["valued", ""]])
        return self.prove(denied, list(hints))

    def evaluated(self, facts: Facts, hints: list[Hint]) -> Proof:
        """The conclusion has a truth value; its denial is among what that says."""
        step = {"step": "valued", "of": ""}
        (valued,) = facts.step(step)
        forget = {"step": "forget", "facts": list(range(self.hypotheses, self.denied))}
        self.hypotheses, self.denied = self.denied, len(valued.facts)
        return {**step, "then": [{**forget, "then": [self.prove(valued.step(forget)[0], hints)]}]}

    def prove(self, facts: Facts, hints: list[Hint]) -> Proof:
        self.cases += 1
        if clock() > self.deadline or self.cases > _MOST_CASES:
            raise StuckAt("out of time")
        if (found := closed(facts, 1, self.deadline)) is not None:
            return found
        if (step := _forced(facts)) is not None:
            return self.after(facts, step, [hints])  # always one case
        if (step := self.propagated(facts) or _pinned(facts)) is not None:
            return self.after(facts, step, [hints] * len(facts.step(step)))
        if (made := _hinted(facts, hints)) is not None:
            step, rests, lemmas = made
            return {**step, "then": [self.prove_lemma(case, len(facts.facts), rest) if k in lemmas else self.prove(case, rest)
                                     for k, (case, rest) in enumerate(zip(facts.step(step), rests, strict=True))]}
        if ["clear"] in hints and (proof := self.cleared(facts, hints)) is not None:
            return proof
        more, squares = ([h[1] for h in hints if h[0] == kind] for kind in ("multiply", "square"))
        if (found := closed(facts, 3 if ["degree", 3] in hints else 2, self.deadline, more, squares)) is not None:
            return found
        parts = [(len(f[1]), n) for n, f in enumerate(facts.facts) if f is not None and f[0] == "or"]
        if parts:
            return self.after(facts, {"step": "split", "fact": min(parts)[1]}, [hints] * min(parts)[0])
        raise StuckAt("; ".join(f"{n}: {_shown(f)}" for n, f in enumerate(facts.facts) if f is not None))

    def cleared(self, facts: Facts, hints: list[Hint]) -> Proof | None:
        def zero(case: Facts) -> Proof:
            return closed(case, 1, self.deadline) or closed(case, 2, self.deadline) or self.prove(case, [h for h in hints if h != ["clear"]])

        return clear(facts, lambda case: self.prove(case, hints), zero, tree_of)

    def prove_lemma(self, facts: Facts, denied: int, hints: list[Hint]) -> Proof:
        """A lemma is denied, or base or step of an induction: what else is denied does not matter."""
        idle = [n for n in range(self.hypotheses, denied) if (f := facts.facts[n]) is not None and (n < self.denied or f[0] in ("or", "some"))]
        step = {"step": "forget", "facts": idle}
        return {**step, "then": [self.prove(facts.step(step)[0], hints)]}

    def after(self, facts: Facts, step: Proof, rests: list[list[Hint]]) -> Proof:
        return {**step, "then": [self.prove(case, rest) for case, rest in zip(facts.step(step), rests, strict=True)]}

    def propagated(self, facts: Facts) -> Proof | None:
        """A disjunction with one part at most that does not contradict the rest at once."""
        for n, fact in enumerate(facts.facts):
            if fact is not None and fact[0] == "or":
                rest = facts.without(n)
                left = [part for part in fact[1] if closed(rest.and_(part), 1, self.deadline) is None]
                if len(left) <= 1:
                    return {"step": "split", "fact": n}
        return None


def _forced(facts: Facts) -> Proof | None:
    """An equation that can be solved, or something that exists, or disjunctions that are true anyway."""
    if idle := [n for n, f in enumerate(facts.facts) if f is not None and f[0] == "or" and any(map(_is_true, f[1]))]:
        return {"step": "forget", "facts": idle}
    for n, fact in enumerate(facts.facts):
        if fact is not None and fact[0] == "=":
            able = [m[0] for m, v in fact[1].items() if len(m) == 1 and (abs(v) == 1 or not isinstance(m[0], str) or m[0] not in facts.whole)]
            for x in sorted(able, key=lambda x: (not isinstance(x, str), -_place(x), repr(x))):
                step = {"step": "solve", "fact": n, "variable": x if isinstance(x, str) else repr(x)}
                with suppress(Rejected):
                    facts.step(step)
                    return step if isinstance(x, str) or x[0] != "/" or _is_told(facts, x) else {
                        "step": "quotient", "x": tree_of(dict(x[1])), "y": tree_of(dict(x[2]))}
        if fact is not None and fact[0] == "some":
            return {"step": "name", "fact": n, "name": _free(facts, fact[1])}
    return None


def _is_told(facts: Facts, q: Any) -> bool:
    """Whether (x/y) y = x is known, or one of two cases; it would be lost with q = x/y."""
    x, y = dict(q[1]), dict(q[2])
    equation = facts.relation("=", plus(times({(q,): 1}, y), x, -1))
    return any(f == equation or f is not None and f[0] == "or" and equation in f[1] for f in facts.facts)


def _pinned(facts: Facts) -> Proof | None:
    """What is neither more nor less than zero is zero."""
    known = [f[1] for f in facts.facts if f is not None and f[0] == ">=" and set(f[1]) - {()} and not any(_is_existence(a) for m in f[1] for a in m)]
    equations = [f[1] for f in facts.facts if f is not None and f[0] == "="]
    equal = next((p for p in known if plus({}, p, -1) in known and p not in equations and plus({}, p, -1) not in equations), None)
    return None if equal is None else {"step": "cut", "formula": ["=", tree_of(equal), 0]}


def _place(x: Any) -> Any:
    """Of values of recursions the latest is solved for."""
    return sum(v for m, v in x[2] if not m) if isinstance(x, tuple) and x[0] == "at" else 0


def _free(facts: Facts, name: str) -> str:
    taken = {*facts.names, *facts.definitions, *(n for n, _ in facts.statement["over"])}
    return next(n for n in (name, *(f"{name}{k}" for k in range(1, 1000))) if n not in taken)


def _hinted(facts: Facts, hints: list[Hint]) -> tuple[Proof, list[list[Hint]], tuple[int, ...]] | None:
    """The step of the first hint that can be taken, the hints for the cases after it, and which of these are proofs of a lemma."""
    for place, (kind, *args) in enumerate(hints):
        rest = [*hints[:place], *hints[place + 1:]]
        try:
            if kind in ("multiply", "square", "degree", "clear"):
                continue
            if kind == "at":  # at every fact for all indices of that name, also those that come later
                name, term, *used = args
                places = [n for n, f in enumerate(facts.facts) if f is not None and f[:2] == ("all", name) and n not in used]
                if places:
                    step = {"step": "at", "fact": places[0], "term": term}
                    facts.step(step)
                    return step, [[*hints[:place], [kind, name, term, *used, places[0]], *hints[place + 1:]]], ()
                continue
            step, own = _step(kind, args)
            cases = len(facts.step(step))
        except (Rejected, Unknown):
            continue
        lemmas = {"induct": (0, 1), "lemma": (1,)}.get(kind, ())
        return step, [[*(own[k] if own else []), *([] if k in lemmas else rest)] for k in range(cases)], lemmas
    return None


_PARTS = {"divide": ("term", "by", "name"), "cut": ("formula",), "lemma": ("formula",), "induct": ("name", "from", "formula"), "unfold": ("name", "term"),
          "quotient": ("x", "y"), "product": ("a", "b", "n"), "cosines": ("a", "b", "n"), "right": ("term",), "acute": ("a", "n"), "root": ("term",),
          "exist": ("name", "term"), "valued": ("of",)}


def _step(kind: str, args: Sequence[Any]) -> tuple[Proof, list[list[Hint]] | None]:
    names = _PARTS[kind]
    return {"step": "cut" if kind == "lemma" else kind, **dict(zip(names, args, strict=False))}, args[len(names)] if len(args) > len(names) else None


# ---------------------------------------------------------------------- leaves
def closed(facts: Facts, degree: int, deadline: float, more: Sequence[Any] = (), squares: Sequence[Any] = ()) -> Proof | None:
    """A combination that contradicts itself: of facts, or of their products two or three at a time, of squares and of equations times variables."""
    strict = "strict"  # a row beside those of the monomials: one of the facts taken is strict, or 1 > 0 is
    columns: list[dict[Any, Any]] = [{**ONE, strict: 1}]
    terms: list[list[Any]] = [[[]]]
    for numbers, p in _products(facts, degree):
        columns.append({**p, strict: 1} if all(_known(facts, n)[0] == ">" for n in numbers) else p)
        terms.append([list(numbers)])
    for tree, q in _readable(facts, squares):
        columns.append(times(q, q))
        terms.append([[], tree])
    multipliers = [*_multipliers(facts), *_readable(facts, more)] if degree > 1 else [(1, ONE)]
    for n, equation in _once(facts, "="):
        for tree, q in multipliers:
            p = times(equation, q)
            columns += [p, {m: -v for m, v in p.items()}]
            terms += [[[n], tree], [[n], ["neg", tree]]]
    found = combination(columns, {strict: 1}, deadline=deadline)
    return None if found is None else {"step": "close", "terms": [[str(c), *terms[k]] for k, c in found.items() if k]}


def _once(facts: Facts, *relations: str) -> list[tuple[int, Poly]]:
    """Numbers and polynomials of facts, each polynomial once, strict ones first; without those that say nothing."""
    found: dict[frozenset, tuple[int, Poly]] = {}
    for relation in relations:
        for n, f in enumerate(facts.facts):
            if f is not None and f[0] == relation and not (relation == ">=" and _is_trivial(f[1])) and (f[1] or relation == ">"):
                found.setdefault(frozenset(f[1].items()), (n, f[1]))
    return list(found.values())


def _known(facts: Facts, number: int) -> Any:
    return facts.facts[number]


def _products(facts: Facts, degree: int) -> Iterator[tuple[tuple[int, ...], Poly]]:
    known = _once(facts, ">", ">=")
    yield from (((n,), p) for n, p in known)
    if degree > 1:
        for several in islice(chain.from_iterable(combinations_with_replacement(known, d) for d in range(2, degree + 1)), _MOST_PRODUCTS):
            yield tuple(n for n, _ in several), reduce(times, (p for _, p in several))


def _multipliers(facts: Facts) -> list[tuple[Any, Poly]]:
    """Terms by which an equation is multiplied: one, and atoms of the facts."""
    used = {a for f in facts.facts if f is not None and f[0] in ("=", ">=", ">") for m in f[1] for a in m if not _is_existence(a)}
    return [(1, ONE), *((tree_of({(a,): 1}), {(a,): 1}) for a in sorted(used, key=repr))]


def _is_true(fact: Any) -> bool:
    """A relation between numbers that holds."""
    return fact[0] == "=" and not fact[1] or fact[0] == ">=" and _is_trivial(fact[1])


def _is_trivial(p: Poly) -> bool:
    return not set(p) - {()} and p.get((), 0) >= 0


def _readable(facts: Facts, trees: Sequence[Any]) -> Iterator[tuple[Any, Poly]]:
    for tree in trees:
        with suppress(Rejected, Unknown):
            yield tree, facts.value(tree)


def tree_of(p: Poly) -> Any:
    """A polynomial as a term."""
    return _sum([["*", _constant(c), *map(_atom_tree, m)] if m else _constant(c) for m, c in p.items()])


def _constant(c: Any) -> Any:
    c = Fraction(c)
    return int(c) if c.denominator == 1 else ["rat", c.numerator, c.denominator]


def _sum(terms: list[Any]) -> Any:
    return 0 if not terms else terms[0] if len(terms) == 1 else ["+", *terms]


def _is_existence(a: Any) -> bool:
    """Whether a value exists: a number that no term stands for."""
    return isinstance(a, tuple) and (a[0] == "def" or any(_is_existence(b) for part in a[1:] if isinstance(part, tuple) for m, _ in part for b in m))


def _atom_tree(a: Any) -> Any:
    if isinstance(a, str):
        return ["sym", a]
    if a[0] == "at":
        return ["at", a[1], tree_of(dict(a[2]))]
    return [{"cos": "cospi"}.get(a[0], a[0]), *(tree_of(dict(part)) for part in a[1:])]


def _shown(fact: Any) -> str:
    if fact[0] in ("and", "or"):
        return f"{fact[0]}({', '.join(map(_shown, fact[1]))})"
    if fact[0] in ("all", "some"):
        return f"{fact[0]} {fact[1]} in {_text(fact[2])} .. {_text(fact[3])}: {fact[4]}"
    return f"{_text(fact[1])} {fact[0]} 0"


def _text(p: Poly | None) -> str:
    return "..." if p is None else " + ".join("*".join([str(v), *map(str, m)]) for m, v in p.items()) or "0"
