# SPDX-License-Identifier: MIT
"""Statements about numbers, and integers of any size, by refutation.

The statement is denied, and what is known then is a list of facts: ``p = 0``, ``p >= 0``, ``p > 0`` for polynomials p
with rational coefficients, disjunctions of facts, and facts for all or for some k between bounds. A proof is a tree of the steps below; each of
its leaves is a combination of facts that says that a negative number is not negative. If every leaf is one the denied statement has no instance.

==============  =====================================================================================================
step            what it does
==============  =====================================================================================================
``close``       sum of c * (product of facts) * (square) + sum of (any term) * (an equation) < 0: there is no such instance
``split``       one case for each part of a disjunction
``cut``         a formula, and its negation
``forget``      facts that are of no use
``divide``      x = m j + r with a new integer j, one case for each r = 0, .., m - 1
``at``          a fact for all k, at a term that is an integer
``name``        a fact for some k gives a new integer k
``solve``       of an equation x + p = 0, x not in p: -p takes the place of x in all facts
``induct``      a formula in k for all k >= a: false at a, or false at k + 1 where it is true at k, or known
``unfold``      a value of a recursion: initial, made by the step, or before the start
``quotient``    (x/y) y = x, or y = 0
``product``     2 cos(a/n) cos(b/n) = cos((a + b)/n) + cos((a - b)/n), angles in multiples of pi
``cosines``     cos(a/n) = cos(b/n) if and only if a - b or a + b is 2 n j for an integer j; or n <= 0
``right``       cos(n/(2n)) = 0; or n <= 0
``acute``       cos(a/n) > 0 and 2|a| < n, or = 0 and 4a^2 = n^2, or < 0 and 2|a| > n; or |a| > n, or n <= 0
``root``        the square root of x is not negative, and its square is x; or x < 0
``valued``      the conclusion, or a hypothesis, has a truth value, see `exactkf.kernel.values`
``exist``       a value of a recursion exists or not, by its definition, see there
==============  =====================================================================================================

Integers are the sizes, variables of type integer, indices, and polynomials in them with integer coefficients; for those
p > 0 says p - 1 >= 0. Other variables are real numbers, and so are atoms: quotients, square roots, cosines and values of recursions.

Soundness. Let a quotient by zero, the square root of a negative number and a value of a recursion that it does not have be any number, and cos(a/n) be 1
for n = 0. Then each term has a value on every instance, and a fact is true or false there. Where a formula has a truth value without that, it is the same,
as all that decides it has a value. So the denied conclusion is a fact on an instance on which the conclusion is false. ``defined``, which
can tell the difference, is read as what it says, see `exactkf.kernel.values`; ``always``, which is true too where the formula has no value from some t on, is
only denied: then the formula is false at some t >= 0. A definition takes the place of its name; one that leads back to itself
is refused, unless recursions call themselves, or each other, at earlier indices; so are recursions whose values need not be numbers.
Each step goes from facts that are true on an instance, with some integers for the new names, to cases of which at least one is true on it. No leaf is.

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

from exactkf.kernel.explicit_matrices import OF_MATRIX, about_matrices, of_matrix
from exactkf.kernel.facts_on_circle import ON_CIRCLE, equation, in_z, on_circle, zeros_inside
from exactkf.kernel.numbers import Rejected, Unknown, fraction
from exactkf.kernel.polynomial_facts import ONE, Fact, Names, Poly, either, frozen, joined, number, plus, times
from exactkf.kernel.values import evaluated, existence, has_value, root
from exactkf.kernel.wellformed import BINDERS, check_formula

__all__ = ["Facts", "Poly", "arithmetic", "plus", "times"]

_LARGEST_MODULUS = 1000
_OPPOSITE = {"and": "or", "or": "and"}
_QUANTIFIERS = {("forall", True): "all", ("forall", False): "some", ("exists", True): "some", ("exists", False): "all"}
_RELATIONS = {"=", "!=", "<", "<=", ">", ">="}
#: what decides between cases, and is no number of them
_CONDITIONS = {*_RELATIONS, *ON_CIRCLE, "psd", "pd", "not", "and", "or", "=>", "<=>", "forall", "exists", "always", "defined"}


# ---------------------------------------------------------------------- what is known
class Facts:
    """Facts of one case, with the names that terms may have in it."""

    def __init__(self, statement: Mapping[str, Any]) -> None:
        self.statement = statement
        self.definitions = {d[1]: d for d in statement["where"]}
        self.circular = _circular(self.definitions) | _not_numbers(statement, self.definitions)
        self.whole: set[str] = set()  # variables that are integers
        self.solved: dict[Any, Poly] = {}  # atoms that a step has solved for
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
            self.add(self.relation("!=", x))
        elif kind[0] != "scalar":
            self.add(self.relation(">" if kind[0] == "positive" else ">=", x))

    def copy(self) -> Facts:
        """The same, to go on from."""
        new = object.__new__(Facts)
        new.__dict__.update(self.__dict__)
        new.whole, new.names, new.facts, new.solved = set(self.whole), dict(self.names), list(self.facts), dict(self.solved)
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
    def read(self, tree: Any, affirmed: bool, names: Names | None = None, valued: bool = False) -> Fact:
        """A formula, or its negation, as a fact; of a quantifier whose formula is evaluated, that it is so."""
        names = self.names if names is None else names
        op = tree[0] if isinstance(tree, list) else ""
        if op == "not":
            return self.read(tree[1], not affirmed, names)
        if op in ("and", "or"):
            return joined(op if affirmed else _OPPOSITE[op], [self.read(x, affirmed, names) for x in tree[1:]])
        if op == "=>":
            return self.read(["or", ["not", tree[1]], tree[2]], affirmed, names)
        if op == "<=>":
            return joined("or", [joined("and", [self.read(tree[1], x, names), self.read(tree[2], x == affirmed, names)]) for x in (True, False)])
        if op == "if":
            return joined("or", [joined("and", [self.read(tree[1], x, names), self.read(tree[2 if x else 3], affirmed, names)]) for x in (True, False)])
        if op == "defined":
            return has_value(self, tree[1], affirmed, names)
        if op in ON_CIRCLE:
            return on_circle(self, tree, affirmed, names)
        if (of_matrices := about_matrices(self, tree, affirmed, names)) is not None:
            return of_matrices
        if op in ("=", "!=") and any(in_z(self, x, names) for x in tree[1:]):
            if len(tree) != 3:
                raise Unknown("a chain of equations in z")
            return equation(self, tree[1], tree[2], affirmed == (op == "="), names)
        if op in _RELATIONS:
            pairs = list(zip(tree[1:], tree[2:], strict=False))
            return joined("and" if affirmed else "or", [self._comparison(op, x, y, affirmed, names) for x, y in pairs])
        if op in ("forall", "exists"):
            return self._quantified(tree, affirmed, names, valued)
        if op == "always" and not affirmed:  # the formula is false at some t; where it is true for all t, it need not have a value for all t
            return ("some", tree[1], {}, None, tree[2], names, affirmed, valued)
        if op in ("sym", "at"):
            body, inner = self.opened(tree, names)
            return self.read(body, affirmed, inner)
        raise Unknown(f"{op!r} in a statement about integers")

    def _comparison(self, op: str, x: Any, y: Any, affirmed: bool, names: Names) -> Fact:
        cases = [(c + d, self.relation(op if affirmed else _DENIED[op], plus(p, q, -1)))
                 for (c, p), (d, q) in product(self.cases(x, names), self.cases(y, names))]
        return either(cases)

    def relation(self, op: str, p: Poly) -> Fact:
        """p against zero."""
        minus = plus({}, p, -1)
        if op in ("<", "<="):
            return self.relation({"<": ">", "<=": ">="}[op], minus)
        if op == "!=":
            return ("or", [self.relation(">", p), self.relation(">", minus)])
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

    def _quantified(self, tree: list, affirmed: bool, names: Names, valued: bool) -> Fact:
        op, name, low, high, body = tree
        cases = []
        for (c, p), (d, q) in product(self.cases(low, names), self.cases(high, names)):
            if not (self.is_whole(p) and self.is_whole(q)):
                raise Unknown("a bound that need not be an integer")
            cases.append((c + d, (_QUANTIFIERS[op, affirmed], name, p, q, body, names, affirmed, valued)))
        return either(cases)

    def opened(self, tree: list, names: Names) -> tuple[Any, Names]:
        """The body of a definition, and what the names in it stand for."""
        d = self.definitions.get(tree[1])
        if d is None or d[0] != "let" or len(d[2]) != len(tree) - 2 or tree[1] in names:
            raise Unknown(f"{tree[1]!r} in a statement about integers")
        if tree[1] in self.circular:
            raise Unknown(f"{tree[1]!r}, whose definition leads back to itself, or is of no numbers")
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
            if self.definitions.get(tree[1], ("",))[0] == "rec" and len(tree) == 3 and tree[1] not in names:
                return [(c, self.value_of(tree[1], p)) for c, p in self.cases(tree[2], names)]
            body, inner = self.opened(tree, names)
            return self.cases(body, inner)
        if op == "cospi":
            return [(c + d, self.cosine(p, q)) for (c, p), (d, q) in product(self.cases(tree[1], names), self.cases(tree[2], names))]
        if op == "/":
            return [(c + d, self.quotient(p, q)) for (c, p), (d, q) in product(self.cases(tree[1], names), self.cases(tree[2], names))]
        if op == "abs":
            return [((*c, self.relation(sign, p)), q) for c, p in self.cases(tree[1], names) for sign, q in ((">=", p), ("<", plus({}, p, -1)))]
        if op == "sqrt":
            return [(c, self.square_root(p)) for c, p in self.cases(tree[1], names)]
        if op == "roots_in":
            return zeros_inside(self, tree, names)
        if op in OF_MATRIX:
            return [((), of_matrix(self, tree, names))]
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

    # ------------------------------------------------------------------ atoms
    def atom(self, *atom: Any) -> Poly:
        return self.solved.get(atom, {(atom,): 1})

    def value_of(self, name: str, at: Poly) -> Poly:
        """A value of a recursion."""
        if name in self.circular or not self.is_whole(at):
            raise Unknown(f"a value of {name!r}, which leads back to itself or is no number, or not at an integer")
        return self.atom("at", name, frozen(at))

    def quotient(self, x: Poly, y: Poly) -> Poly:
        """x / y."""
        if set(y) == {()}:
            return plus({}, x, Fraction(1) / y[()])
        return self.atom("/", frozen(x), frozen(y))

    def square_root(self, x: Poly) -> Poly:
        """The square root of x, or any number for x < 0."""
        return self.atom("sqrt", frozen(x))

    def cosine(self, a: Poly, n: Poly) -> Poly:
        """cos(pi a/n): the same for c a, c n with c > 0, and for -a, n."""
        if not (self.is_whole(a) and self.is_whole(n)):
            raise Unknown("the cosine of an angle that need not be a rational multiple of pi")
        if not a:
            return ONE
        a, n = ({m: int(v) for m, v in p.items()} for p in (a, n))
        common = gcd(*a.values(), *n.values()) * (1 if min(a.items(), key=repr)[1] > 0 else -1)
        return self.atom("cos", frozen({m: v // common for m, v in a.items()}), frozen({m: v // abs(common) for m, v in n.items()}))

    def put(self, p: Poly, name: Any, by: Poly) -> Poly:
        """A polynomial with another in place of a variable or an atom."""
        out: Poly = {}
        for m, v in p.items():
            kept = tuple(a for a in m if a != name and isinstance(a, str))
            term: Poly = {kept: v}
            for a in m:
                if a == name or not isinstance(a, str):
                    term = times(term, by if a == name else self._inside(a, name, by))
            out = plus(out, term)
        return out

    def _inside(self, atom: tuple, name: Any, by: Poly) -> Poly:
        kind, *parts = atom
        if kind == "at":
            return self.value_of(parts[0], self.put(dict(parts[1]), name, by))
        if kind == "def":
            return self.atom("def", parts[0], frozen(self.put(dict(parts[1]), name, by)))
        if kind == "sqrt":
            return self.square_root(self.put(dict(parts[0]), name, by))
        x, y = (self.put(dict(part), name, by) for part in parts)
        return self.cosine(x, y) if kind == "cos" else self.quotient(x, y)

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

    def _forget(self, step: Mapping[str, Any]) -> list[Facts]:
        new = self.copy()
        for n in step["facts"]:
            new = new.without(n)
        return [new]

    def _divide(self, step: Mapping[str, Any]) -> list[Facts]:
        x, m = self.value(step["term"]), step["by"]
        if not self.is_whole(x) or type(m) is not int or not 1 <= m <= _LARGEST_MODULUS:
            raise Rejected("only an integer has a quotient and a rest, by a positive integer")
        new = self.copy()
        j = new.fresh(step["name"])
        return [new.and_(("=", plus(plus(x, j, -m), number(r), -1))) for r in range(m)]

    def _at(self, step: Mapping[str, Any]) -> list[Facts]:
        _, name, low, high, body, names, affirmed, valued = self.fact(step["fact"], "all")
        x = self.value(step["term"])
        if not self.is_whole(x):
            raise Rejected("an index is an integer")
        return [self.and_(joined("or", [*self._outside(x, low, high), self.body(body, affirmed, {**names, name: x}, valued)]))]

    def body(self, tree: Any, affirmed: bool, names: Names, valued: bool) -> Fact:
        """What a quantifier says at one place."""
        return evaluated(self, tree, affirmed, names) if valued else self.read(tree, affirmed, names)

    def _outside(self, x: Poly, low: Poly | None, high: Poly | None) -> list[Fact]:
        return [self.relation(op, plus(x, bound, -1)) for op, bound in (("<", low), (">", high)) if bound is not None]

    def _name(self, step: Mapping[str, Any]) -> list[Facts]:
        _, name, low, high, body, names, affirmed, valued = self.fact(step["fact"], "some")
        new = self.without(step["fact"])
        k = new.fresh(step["name"])
        for op, bound in ((">=", low), ("<=", high)):
            if bound is not None:
                new.add(new.relation(op, plus(k, bound, -1)))
        new.add(new.body(body, affirmed, {**names, name: k}, valued))
        return [new]

    def _solve(self, step: Mapping[str, Any]) -> list[Facts]:
        _, p = self.fact(step["fact"], "=")
        found = [a for m in p if len(m) == 1 for a in m if a == step["variable"] or repr(a) == step["variable"]]
        if len(found) != 1:
            raise Rejected(f"fact {step['fact']} cannot be solved for {step['variable']!r}")
        x = found[0]
        by = plus({(x,): 1}, p, Fraction(-1) / p[x,])
        if any(_within(x, a) for m in by for a in m) or x in self.whole and not self.is_whole(by):
            raise Rejected(f"fact {step['fact']} cannot be solved for {step['variable']!r}")
        new = self.without(step["fact"])
        new.solved = {} if isinstance(x, str) else {x: by}
        doubled: list[Poly] = []
        for a, q in self.solved.items():  # each is an equation that holds, and so is each with the term in its place
            left, q = self._renamed(a, x, by), new.put(q, x, by)
            if left is not None and new.solved.setdefault(left, q) != q:
                doubled.append(plus(new.solved[left], q, -1))
        new.facts = [None if f is None else new._put(f, x, by) for f in new.facts]
        new.facts += [new.relation("=", p) for p in doubled]
        new.names = {n: new.put(q, x, by) for n, q in new.names.items()}
        return [new]

    def _renamed(self, atom: tuple, x: Any, by: Poly) -> tuple | None:
        """An atom with a term in place of a variable, if that is an atom."""
        plain = self.copy()
        plain.solved = {}
        value = plain._inside(atom, x, by)
        (m, c), *more = value.items() or [((), 0)]
        return m[0] if c == 1 and not more and len(m) == 1 and not isinstance(m[0], str) else None

    def _put(self, fact: Fact, name: Any, by: Poly) -> Fact:
        """The same fact with a term in place of a variable or an atom."""
        op = fact[0]
        if op in ("and", "or"):
            return joined(op, [self._put(f, name, by) for f in fact[1]])
        if op in ("all", "some"):
            low, high = (None if p is None else self.put(p, name, by) for p in fact[2:4])
            return (op, fact[1], low, high, fact[4], {k: self.put(p, name, by) for k, p in fact[5].items()}, *fact[6:])
        return self.relation(op, self.put(fact[1], name, by))

    def _induct(self, step: Mapping[str, Any]) -> list[Facts]:
        name, low, formula = step["name"], self.value(step["from"]), step["formula"]
        inner = self.copy()
        k = inner.fresh(name)
        inner.shown(formula)
        if not self.is_whole(low):
            raise Rejected("an induction starts at an integer")
        base = self.and_(self.read(formula, False, {**self.names, name: low}))
        inner.add(inner.relation(">=", plus(k, low, -1)))
        inner.add(inner.read(formula, True))
        inner.add(inner.read(formula, False, {**inner.names, name: plus(k, ONE)}))
        return [base, inner, self.and_(("all", name, low, None, formula, dict(self.names), True, False))]

    # ------------------------------------------------------------------ what atoms are
    def _unfold(self, step: Mapping[str, Any]) -> list[Facts]:
        d, at = self.definitions.get(step["name"], ("",)), self.value(step["term"])
        if d[0] != "rec":
            raise Rejected(f"{step['name']!r} is no recursion")
        x = self.value_of(d[1], at)
        before, places = self.places(d, at)
        return [self.and_(("or", [before, *(("and", [where, self._equals(x, tree, names)]) for where, tree, names in places)]))]

    def places(self, recursion: Any, at: Poly) -> tuple[Fact, list[tuple[Fact, Any, Names]]]:
        """That an index is before the start of a recursion; and that it is at one of the initial values, or later, with the term of the value there."""
        _, _, index, start, initial, body = recursion
        first = [(self.relation("=", plus(at, number(start + k), -1)), tree, self.own()) for k, tree in enumerate(initial)]
        later = (self.relation(">=", plus(at, number(start + len(initial)), -1)), body, {**self.own(), index: plus(at, ONE, -1)})
        return self.relation("<", plus(at, number(start), -1)), [*first, later]

    def _equals(self, x: Poly, tree: Any, names: Names) -> Fact:
        return either([(c, self.relation("=", plus(x, p, -1))) for c, p in self.cases(tree, names)])

    def _quotient(self, step: Mapping[str, Any]) -> list[Facts]:
        x, y = self.value(step["x"]), self.value(step["y"])
        return [self.and_(("or", [self.relation("=", y), self.relation("=", plus(times(self.quotient(x, y), y), x, -1))]))]

    def _root(self, step: Mapping[str, Any]) -> list[Facts]:
        x = self.value(step["term"])
        return [self.and_(("or", [self.relation("<", x), joined("and", root(self, x))]))]

    def _valued(self, step: Mapping[str, Any]) -> list[Facts]:
        """The hypotheses are true and the conclusion is false: all that tells so has a value."""
        given = [(formula, True) for label, formula, _ in self.statement["given"] if label == step["of"]]
        return [self.and_(*(evaluated(self, formula, x, self.names) for formula, x in given or [(self.statement["says"], False)]))]

    def _exist(self, step: Mapping[str, Any]) -> list[Facts]:
        name, at = step["name"], self.value(step["term"])
        if self.definitions.get(name, ("",))[0] != "rec":
            raise Rejected(f"{name!r} is no recursion")
        return [self.and_(existence(self, name, at))]

    def _acute(self, step: Mapping[str, Any]) -> list[Facts]:
        a, n = self.value(step["a"]), self.value(step["n"])
        x, two = self.cosine(a, n), number(2)
        beyond = [self.relation(">", plus(plus({}, a, c), n, -1)) for c in (1, -1)]
        signs = [joined("and", [self.relation(">", x), *(self.relation("<", plus(plus({}, times(two, a), c), n, -1)) for c in (1, -1))]),
                 joined("and", [self.relation("=", x), self.relation("=", plus(times(times(two, a), times(two, a)), times(n, n), -1))]),
                 *(joined("and", [self.relation("<", x), self.relation(">", plus(plus({}, times(two, a), c), n, -1))]) for c in (1, -1))]
        return [self.and_(("or", [self.relation("<=", n), *beyond, *signs]))]

    def _product(self, step: Mapping[str, Any]) -> list[Facts]:
        a, b, n = (self.value(step[key]) for key in "abn")
        left = times(self.cosine(a, n), self.cosine(b, n))
        return [self.and_(self.relation("=", plus(plus(self.cosine(plus(a, b), n), self.cosine(plus(a, b, -1), n)), left, -2)))]

    def _cosines(self, step: Mapping[str, Any]) -> list[Facts]:
        a, b, n = (self.value(step[key]) for key in "abn")
        gap = plus(self.cosine(a, n), self.cosine(b, n), -1)
        full = ["=", ["sym", "x"], ["*", ["sym", "m"], ["sym", "turns"]]]
        angles = [{"x": plus(a, b, c), "m": times(n, number(2))} for c in (-1, 1)]
        same = ("and", [self.relation("=", gap), ("or", [("some", "turns", None, None, full, x, True, False) for x in angles])])
        other = ("and", [self.relation("!=", gap), *(("all", "turns", None, None, full, x, False, False) for x in angles)])
        return [self.and_(("or", [self.relation("<=", n), same, other]))]

    def _right(self, step: Mapping[str, Any]) -> list[Facts]:
        n = self.value(step["term"])
        return [self.and_(("or", [self.relation("<=", n), self.relation("=", self.cosine(n, times(n, number(2))))]))]


_DENIED = {"=": "!=", "!=": "=", "<": ">=", "<=": ">", ">": "<=", ">=": "<"}
_STEPS = {"close": Facts._close, "split": Facts._split, "cut": Facts._cut, "forget": Facts._forget, "divide": Facts._divide, "at": Facts._at,
          "name": Facts._name,
          "solve": Facts._solve, "induct": Facts._induct, "unfold": Facts._unfold, "quotient": Facts._quotient, "root": Facts._root,
          "valued": Facts._valued, "exist": Facts._exist, "acute": Facts._acute, "product": Facts._product,
          "cosines": Facts._cosines, "right": Facts._right}


def _cleared(p: Poly) -> Poly:
    """A positive multiple with integer coefficients."""
    common = reduce(lcm, (Fraction(v).denominator for v in p.values()), 1)
    return {m: int(v * common) for m, v in p.items()}


def _within(x: Any, atom: Any) -> bool:
    """An atom is x, or has it in an argument."""
    return atom == x or isinstance(atom, tuple) and any(_within(x, part) for part in atom)


def _circular(definitions: Mapping[str, Any]) -> set[str]:
    """Definitions that lead back to themselves, other than from values of recursions at an index + 1 to such at the index or before it alone.

    Where all calls on the way back are of that kind, the values are there by induction on the index.
    """
    recursions = {name for name, d in definitions.items() if d[0] == "rec"}
    every, later = ({name: set(_called([d[4], read(d)] if d[0] == "rec" else d[3])) & set(definitions) for name, d in definitions.items()}
                    for read in (lambda d: d[5], lambda d: _without_earlier(d[5], recursions, d[2])))
    reached = {name: set(below) for name, below in every.items()}
    for _ in definitions:
        for name in reached:
            reached[name] |= {y for x in reached[name] for y in reached[x]}
    wrong = {name for name, below in later.items() if any(x == name or name in reached[x] for x in below)}
    return {name for name in definitions if name in wrong or any(x in reached[name] and name in reached[x] for x in wrong)}


#: what makes numbers of numbers
_NUMBERS = {"rat", "sym", "at", "+", "-", "*", "neg", "/", "^", "if", "cospi", "abs", "sqrt"}
_MATRICES = {"matrix", "symmetric", "psd", "pd", "nonsingular", "diagonal", "sequence_of", "signal_of", "poly", "monic"}


def _not_numbers(statement: Mapping[str, Any], definitions: Mapping[str, Any]) -> set[str]:
    """Recursions whose values may be matrices or polynomials, as anything else than numbers enters: factors need not commute, and a square has no sign."""
    def strange(tree: Any) -> bool:
        if not isinstance(tree, (list, tuple)) or not tree:
            return False
        if tree[0] not in _NUMBERS:
            return tree[0] not in _CONDITIONS
        if tree[0] in ("sym", "at") and tree[1] in other:
            return True
        return any(strange(x) for x in tree[1:])

    other = {name for name, kind in statement["over"] if kind[0] in _MATRICES}
    found = set[str]()
    while True:
        more = {name for name, d in definitions.items() if name not in found and (any(map(strange, [*d[4], d[5]])) if d[0] == "rec" else strange(d[3]))}
        if not more:
            return {name for name in found if definitions[name][0] == "rec"}
        found |= more
        other |= more


def _without_earlier(tree: Any, recursions: set[str], index: str) -> Any:
    """A step without the values of recursions at its index and before it."""
    if not isinstance(tree, (list, tuple)) or tree and tree[0] in BINDERS and index in tree[1:1 + BINDERS[tree[0]]]:
        return tree
    if len(tree) == 3 and tree[0] == "at" and tree[1] in recursions:
        at = tree[2]
        if at == ["sym", index] or isinstance(at, list) and at[:2] == ["-", ["sym", index]] and type(at[2]) is int and at[2] > 0:
            return 0
    return [_without_earlier(x, recursions, index) for x in tree]


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
