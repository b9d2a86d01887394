# SPDX-License-Identifier: MIT
"""Statements about integers of any size, by refutation.

The statement is denied, and what is known then is a list of facts: ``p = 0``, ``p >= 0``, ``p > 0`` for polynomials p
with rational coefficients, disjunctions of facts, and facts for all or for some k between bounds. A proof is a tree of the steps below; each of
its leaves is a combination of facts that says that a negative number is not negative. If every leaf is one the denied statement has no instance.

==============  =====================================================================================================
step            what it does
==============  =====================================================================================================
``close``       sum of c * (product of facts) * (square) + sum of (any term) * (an equation) < 0: there is no such instance
``split``       one case for each part of a disjunction
``cut``         a formula, and its negation
``divide``      x = m j + r with a new integer j, one case for each r = 0, .., m - 1
``at``          a fact for all k, at a term that is an integer
``name``        a fact for some k gives a new integer k
``solve``       of an equation x + p = 0, x not in p: -p takes the place of x in all facts
``induct``      a formula in k for all k >= a: false at a, or false at k + 1 where it is true at k, or known
==============  =====================================================================================================

Integers are the sizes, variables of type integer, indices, and polynomials in them with integer coefficients; for those
p > 0 says p - 1 >= 0. Other variables are real numbers.

Soundness. Terms are sums and products, so that each has a value on every instance, and a fact is true or false there. The
conclusion has the truth value that classical logic gives it, and it is denied here on an instance if it is false on
it. A definition takes the place of its name; one that leads back to itself is refused. Each step goes from facts that are
true on an instance, with some integers for the new names, to cases of which at least one is true on it. No leaf is.

Main definitions
----------------
`Facts`
    What is known in one case, and `Facts.step`.
`arithmetic`
    Replay of a certificate.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import reduce
from itertools import product
from math import gcd, lcm
from typing import Any

from exactkf.kernel.numbers import Rejected, Unknown, fraction
from exactkf.kernel.wellformed import check_formula

__all__ = ["Facts", "Poly", "arithmetic", "plus", "times"]

#: products of atoms, sorted, with coefficients that are not zero
Poly = dict[tuple, Any]
#: ("=" or ">=" or ">", p); ("and" or "or", facts); ("all" or "some", name, low, high, body, names, affirmed)
Fact = tuple
Names = dict[str, Poly]

_LARGEST_MODULUS = 1000
_OPPOSITE = {"and": "or", "or": "and"}
_QUANTIFIERS = {("forall", True): "all", ("forall", False): "some", ("exists", True): "some", ("exists", False): "all"}
_RELATIONS = {"=", "!=", "<", "<=", ">", ">="}
ONE: Poly = {(): 1}


# ---------------------------------------------------------------------- polynomials
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
        key = tuple(sorted(m + n))
        out[key] = out.get(key, 0) + v * w
    return {m: v for m, v in out.items() if v}


def number(c: Any) -> Poly:
    """A constant."""
    return {(): c} if c else {}


def _put(p: Poly, name: str, by: Poly) -> Poly:
    """The polynomial with another in place of a variable."""
    out: Poly = {}
    for m, v in p.items():
        term = {tuple(a for a in m if a != name): v}
        for _ in range(m.count(name)):
            term = times(term, by)
        out = plus(out, term)
    return out


# ---------------------------------------------------------------------- what is known
class Facts:
    """Facts of one case, with the names that terms may have in it."""

    def __init__(self, statement: Mapping[str, Any]) -> None:
        self.statement = statement
        self.definitions = {d[1]: d for d in statement["where"]}
        self.circular = _circular(self.definitions)
        self.whole: set[str] = set()  # variables that are integers
        self.names: Names = {}  # of the statement, and those that steps have brought in
        self.facts: list[Fact | None] = []
        for size in statement["sizes"]:
            self._variable(size, True)
            self.add((">=", self.names[size]))
        for name, kind in statement["over"]:
            if kind[0] in ("scalar", "nonzero", "positive", "nonneg", "integer"):
                self._variable(name, kind[0] == "integer")
        for name, kind in statement["over"]:
            self._type(name, kind)
        for _, formula, _ in statement["given"]:
            with suppress(Unknown):  # less is known without it
                self.add(self.read(formula, True))

    def _variable(self, name: str, whole: bool) -> None:
        self.names[name] = {(name,): 1}
        if whole:
            self.whole.add(name)

    def _type(self, name: str, kind: Sequence[Any]) -> None:
        x = self.names.get(name)
        if x is None:
            return
        if kind[0] == "integer":
            self.add(("and", [self.read([">=", ["sym", name], kind[1]], True), self.read(["<=", ["sym", name], kind[2]], True)]))
        elif kind[0] == "nonzero":
            self.add(self._relation("!=", x))
        elif kind[0] != "scalar":
            self.add(self._relation(">" if kind[0] == "positive" else ">=", x))

    def copy(self) -> Facts:
        """The same, to go on from."""
        new = object.__new__(Facts)
        new.__dict__.update(self.__dict__)
        new.whole, new.names, new.facts = set(self.whole), dict(self.names), list(self.facts)
        return new

    def add(self, fact: Fact) -> None:
        """One more fact; the members of a conjunction each for itself."""
        if fact[0] == "and":
            for f in fact[1]:
                self.add(f)
        else:
            self.facts.append(fact)

    def and_(self, *facts: Fact) -> Facts:
        """A case with these facts beside the others."""
        new = self.copy()
        for f in facts:
            new.add(f)
        return new

    # ------------------------------------------------------------------ formulas
    def read(self, tree: Any, affirmed: bool, names: Names | None = None) -> Fact:
        """A formula, or its negation, as a fact."""
        names = self.names if names is None else names
        op = tree[0] if isinstance(tree, list) else ""
        if op == "not":
            return self.read(tree[1], not affirmed, names)
        if op in ("and", "or"):
            return (op if affirmed else _OPPOSITE[op], [self.read(x, affirmed, names) for x in tree[1:]])
        if op == "=>":
            return self.read(["or", ["not", tree[1]], tree[2]], affirmed, names)
        if op == "<=>":
            return ("or", [("and", [self.read(tree[1], x, names), self.read(tree[2], x == affirmed, names)]) for x in (True, False)])
        if op == "if":
            return ("or", [("and", [self.read(tree[1], x, names), self.read(tree[2 if x else 3], affirmed, names)]) for x in (True, False)])
        if op in _RELATIONS:
            pairs = list(zip(tree[1:], tree[2:], strict=False))
            return ("and" if affirmed else "or", [self._comparison(op, x, y, affirmed, names) for x, y in pairs])
        if op in ("forall", "exists"):
            return self._quantified(tree, affirmed, names)
        if op in ("sym", "at"):
            body, inner = self._opened(tree, names)
            return self.read(body, affirmed, inner)
        raise Unknown(f"{op!r} in a statement about integers")

    def _comparison(self, op: str, x: Any, y: Any, affirmed: bool, names: Names) -> Fact:
        cases = [(c + d, self._relation(op if affirmed else _DENIED[op], plus(p, q, -1)))
                 for (c, p), (d, q) in product(self.cases(x, names), self.cases(y, names))]
        return _either(cases)

    def _relation(self, op: str, p: Poly) -> Fact:
        """p against zero."""
        minus = plus({}, p, -1)
        if op in ("<", "<="):
            return self._relation({"<": ">", "<=": ">="}[op], minus)
        if op == "!=":
            return ("or", [self._relation(">", p), self._relation(">", minus)])
        p = _cleared(p)
        if not self.is_whole(p):
            return (op, p)
        if op == ">":
            op, p = ">=", plus(p, ONE, -1)
        common = gcd(*(v for m, v in p.items() if m))  # c q + r >= 0 says q >= -r/c, and q is an integer
        if common > 1:
            if op == "=" and p.get((), 0) % common:
                return (">=", number(-1))
            p = {m: v // common for m, v in p.items()}
        return (op, {m: v for m, v in p.items() if v})

    def is_whole(self, p: Poly) -> bool:
        """An integer on every instance, as its coefficients and variables are."""
        return all(Fraction(v).denominator == 1 and all(a in self.whole for a in m) for m, v in p.items())

    def _quantified(self, tree: list, affirmed: bool, names: Names) -> Fact:
        op, name, low, high, body = tree
        cases = []
        for (c, p), (d, q) in product(self.cases(low, names), self.cases(high, names)):
            if not (self.is_whole(p) and self.is_whole(q)):
                raise Unknown("a bound that need not be an integer")
            cases.append((c + d, (_QUANTIFIERS[op, affirmed], name, p, q, body, names, affirmed)))
        return _either(cases)

    def _opened(self, tree: list, names: Names) -> tuple[Any, Names]:
        """The body of a definition, and what the names in it stand for."""
        d = self.definitions.get(tree[1])
        if d is None or d[0] != "let" or len(d[2]) != len(tree) - 2 or tree[1] in names:
            raise Unknown(f"{tree[1]!r} in a statement about integers")
        if tree[1] in self.circular:
            raise Unknown(f"{tree[1]!r}, whose definition leads back to itself")
        return d[3], {**self.own(), **{p: self.term(a, names) for p, a in zip(d[2], tree[2:], strict=True)}}

    def own(self) -> Names:
        """What the names of the statement stand for."""
        return {n: self.names[n] for n in (*self.statement["sizes"], *(v for v, _ in self.statement["over"])) if n in self.names}

    # ------------------------------------------------------------------ terms
    def term(self, tree: Any, names: Names | None = None) -> Poly:
        """A term without cases."""
        (conditions, p), *more = self.cases(tree, self.names if names is None else names)
        if more or conditions:
            raise Unknown("a term with cases")
        return p

    def cases(self, tree: Any, names: Names) -> list[tuple[tuple[Fact, ...], Poly]]:
        """The values of a term, with the conditions of each; one of them is met."""
        if type(tree) is int:
            return [((), number(tree))]
        op = tree[0]
        if op == "rat":
            return [((), number(Fraction(tree[1], tree[2])))]
        if op == "sym" and tree[1] in names:
            return [((), names[tree[1]])]
        if op in ("sym", "at"):
            body, inner = self._opened(tree, names)
            return self.cases(body, inner)
        if op == "if":
            return [((self.read(tree[1], x, names), *c), p) for x in (True, False) for c, p in self.cases(tree[2 if x else 3], names)]
        if op == "^" and type(tree[2]) is int and 0 <= tree[2] <= 8:
            return [(c, reduce(times, [p] * tree[2], ONE)) for c, p in self.cases(tree[1], names)]
        if op not in ("+", "-", "*", "neg"):
            raise Unknown(f"{op!r} in a statement about integers")
        out = []
        for parts in product(*(self.cases(x, names) for x in tree[1:])):
            values = [p for _, p in parts]
            value = reduce(plus if op == "+" else times, values) if op in "+*" else plus({} if op == "neg" else values[0], values[-1], -1)
            out.append((tuple(f for c, _ in parts for f in c), value))
        return out

    # ------------------------------------------------------------------ steps
    def step(self, step: Mapping[str, Any]) -> list[Facts]:
        """The cases that a step leaves."""
        kind = step["step"]
        if kind not in _STEPS:
            raise Rejected(f"no step is called {kind!r}")
        return _STEPS[kind](self, step)

    def shown(self, tree: Any) -> Any:
        """A formula of the evidence, if it is one."""
        check_formula(self.statement, tree, *(set(self.names) - set(self.own())))
        return tree

    def value(self, tree: Any) -> Poly:
        """A term of the evidence."""
        return self.term(self.shown(["=", tree, 0])[1])

    def fact(self, number: Any, *ops: str) -> Fact:
        """The fact of this number, if it is of this kind."""
        fact = self.facts[number] if type(number) is int and 0 <= number < len(self.facts) else None
        if fact is None or fact[0] not in ops:
            raise Rejected(f"there is no fact {number} for this step")
        return fact

    def fresh(self, name: Any) -> Poly:
        """A new integer."""
        taken = name in self.names or name in self.definitions or any(name == n for n, _ in self.statement["over"])
        if not isinstance(name, str) or not name.isidentifier() or taken:
            raise Rejected(f"{name!r} is no new name")
        self._variable(name, True)
        return self.names[name]

    def without(self, number: int) -> Facts:
        """A copy that lacks a fact."""
        new = self.copy()
        new.facts[number] = None
        return new

    def _close(self, step: Mapping[str, Any]) -> list[Facts]:
        total, strict = dict[tuple, Any](), False
        for c, numbers, *factor in step["terms"]:
            facts = [self.fact(n, "=", ">=", ">") for n in numbers]
            c, term = fraction(c), reduce(times, (f[1] for f in facts), ONE)
            value = self.value(factor[0]) if factor else ONE
            if not any(f[0] == "=" for f in facts):
                if c < 0:
                    raise Rejected("an inequality is taken a negative number of times")
                value = times(value, value)
                strict = strict or c > 0 and bool(facts) and not factor and all(f[0] == ">" for f in facts)
            total = plus(total, times(term, value), c)
        if set(total) - {()} or total.get((), 0) > 0 or not (total or strict):
            raise Rejected("the facts taken do not contradict each other")
        return []

    def _split(self, step: Mapping[str, Any]) -> list[Facts]:
        parts = self.fact(step["fact"], "or")[1]
        rest = self.without(step["fact"])
        return [rest.and_(part) for part in parts]

    def _cut(self, step: Mapping[str, Any]) -> list[Facts]:
        formula = self.shown(step["formula"])
        return [self.and_(self.read(formula, x)) for x in (True, False)]

    def _divide(self, step: Mapping[str, Any]) -> list[Facts]:
        x, m = self.value(step["term"]), step["by"]
        if not self.is_whole(x) or type(m) is not int or not 1 <= m <= _LARGEST_MODULUS:
            raise Rejected("only an integer has a quotient and a rest, by a positive integer")
        new = self.copy()
        j = new.fresh(step["name"])
        return [new.and_(("=", plus(plus(x, j, -m), number(r), -1))) for r in range(m)]

    def _at(self, step: Mapping[str, Any]) -> list[Facts]:
        _, name, low, high, body, names, affirmed = self.fact(step["fact"], "all")
        x = self.value(step["term"])
        if not self.is_whole(x):
            raise Rejected("an index is an integer")
        outside = [self._relation("<", plus(x, low, -1))] + ([] if high is None else [self._relation(">", plus(x, high, -1))])
        return [self.and_(("or", [*outside, self.read(body, affirmed, {**names, name: x})]))]

    def _name(self, step: Mapping[str, Any]) -> list[Facts]:
        _, name, low, high, body, names, affirmed = self.fact(step["fact"], "some")
        new = self.without(step["fact"])
        k = new.fresh(step["name"])
        new.add(("and", [new._relation(">=", plus(k, low, -1)), new._relation("<=", plus(k, high, -1))]))
        new.add(new.read(body, affirmed, {**names, name: k}))
        return [new]

    def _solve(self, step: Mapping[str, Any]) -> list[Facts]:
        _, p = self.fact(step["fact"], "=")
        x = step["variable"]
        c = p.get((x,), 0)
        by = plus({(x,): 1}, p, Fraction(-1) / c) if c else {}
        if not c or any(x in m for m in by) or x in self.whole and not self.is_whole(by):
            raise Rejected(f"fact {step['fact']} cannot be solved for {x!r}")
        new = self.without(step["fact"])
        new.facts = [None if f is None else new._put(f, x, by) for f in new.facts]
        new.names = {n: _put(q, x, by) for n, q in new.names.items()}
        return [new]

    def _put(self, fact: Fact, name: str, by: Poly) -> Fact:
        """The same fact with a term in place of a variable."""
        op = fact[0]
        if op in ("and", "or"):
            return (op, [self._put(f, name, by) for f in fact[1]])
        if op in ("all", "some"):
            low, high = (None if p is None else _put(p, name, by) for p in fact[2:4])
            return (op, fact[1], low, high, fact[4], {k: _put(p, name, by) for k, p in fact[5].items()}, fact[6])
        return self._relation(op, _put(fact[1], name, by))

    def _induct(self, step: Mapping[str, Any]) -> list[Facts]:
        name, low, formula = step["name"], self.value(step["from"]), step["formula"]
        inner = self.copy()
        k = inner.fresh(name)
        inner.shown(formula)
        if not self.is_whole(low):
            raise Rejected("an induction starts at an integer")
        base = self.and_(self.read(formula, False, {**self.names, name: low}))
        inner.add(inner._relation(">=", plus(k, low, -1)))
        inner.add(inner.read(formula, True))
        inner.add(inner.read(formula, False, {**inner.names, name: plus(k, ONE)}))
        return [base, inner, self.and_(("all", name, low, None, formula, dict(self.names), True))]


_DENIED = {"=": "!=", "!=": "=", "<": ">=", "<=": ">", ">": "<=", ">=": "<"}
_STEPS = {"close": Facts._close, "split": Facts._split, "cut": Facts._cut, "divide": Facts._divide, "at": Facts._at, "name": Facts._name,
          "solve": Facts._solve, "induct": Facts._induct}


def _either(cases: list[tuple[tuple[Fact, ...], Fact]]) -> Fact:
    """One of the cases, whose conditions exclude each other and leave nothing out."""
    if len(cases) == 1 and not cases[0][0]:
        return cases[0][1]
    return ("or", [("and", [*conditions, fact]) for conditions, fact in cases])


def _cleared(p: Poly) -> Poly:
    """A positive multiple with integer coefficients."""
    common = reduce(lcm, (Fraction(v).denominator for v in p.values()), 1)
    return {m: int(v * common) for m, v in p.items()}


def _circular(definitions: Mapping[str, Any]) -> set[str]:
    """Definitions that lead back to themselves."""
    calls = {name: set(_called(d[4:] if d[0] == "rec" else d[3])) & set(definitions) for name, d in definitions.items()}
    reached = {name: set(below) for name, below in calls.items()}
    for _ in definitions:
        for name in reached:
            reached[name] |= {y for x in reached[name] for y in reached[x]}
    return {name for name, below in reached.items() if name in below}


def _called(tree: Any) -> Iterator[str]:
    if isinstance(tree, (list, tuple)):
        if tree and tree[0] in ("sym", "at"):
            yield tree[1]
        for x in tree:
            yield from _called(x)


# ---------------------------------------------------------------------- replay
def arithmetic(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    """Replay; nothing is divided by."""
    denied = Facts(statement)
    denied.add(denied.read(statement["says"], False))
    todo = [(denied, evidence["proof"], "")]
    while todo:
        facts, node, place = todo.pop()
        try:
            cases = facts.step(node)
        except (Rejected, Unknown) as error:
            raise Rejected(f"case {place or '0'}, {node.get('step')}: {error}") from error
        then = node.get("then", [])
        if len(then) != len(cases):
            raise Rejected(f"case {place or '0'}, {node['step']}: {len(cases)} cases, and {len(then)} proofs")
        todo.extend((case, proof, f"{place}.{k}" if place else str(k)) for k, (case, proof) in enumerate(zip(cases, then, strict=True)))
    return []
