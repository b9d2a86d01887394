# SPDX-License-Identifier: MIT
"""Random walks of certificate steps on exact instances: what is true there stays true in one of the cases.

A statement is drawn at random, with an instance on which its hypotheses are true and its conclusion is false. Its facts have to be
true there, whatever number stands for a value that does not exist, and each step has to leave a case all of whose facts are true.
That is the argument for the soundness of `exactkf.kernel.arithmetic`, asked of each step by itself: no proof needs to be found.
"""

from __future__ import annotations

import random
from fractions import Fraction

import pytest

from exactkf.kernel.arithmetic import Facts
from exactkf.kernel.cosines import cosine
from exactkf.kernel.meaning import World, truth
from exactkf.kernel.numbers import Rejected, Undefined, Unknown, sign
from exactkf.kernel.polynomial_facts import number
from exactkf.kernel.wellformed import check_statement

n, m, x, y, w, k, t = (["sym", name] for name in "nmxywkt")
FREE = ["n", "m", "x", "y", "w", "q"]
REACH = 9  # how far a fact about all integers is looked at
RELATIONS = ("=", "=", "!=", "<", "<=", ">", ">=")


class Draw:
    """Formulas in sizes n and m, an integer x, real y and w, q = x + 1, and in bound names, which may hide all but sizes."""

    def __init__(self, seed: int) -> None:
        self.rng = random.Random(seed)

    def definitions(self):
        c = self.rng.choice
        return [["rec", "U", "t", c((0, -1)), [c((0, 1, y)), 1][:c((1, 2))],
                 ["/", ["at", "U", t], c((["-", t, 2], ["-", 1, ["at", "V", t]], w))]],
                ["rec", "V", "t", 0, [c((1, 2, ["/", 1, x]))],
                 c((["-", ["at", "U", ["-", t, 1]], 1], ["/", y, ["-", t, 1]], ["+", ["*", ["at", "V", t], 2], ["/", x, t]]))],
                ["let", "f", ["k"], ["if", ["=", k, x], n, ["/", x, k]]], ["let", "g", ["k"], ["-", c((k, y)), ["at", "U", c((k, 2))]]],
                ["let", "p", ["k"], ["exists", "x", 0, 2, ["=", k, ["*", x, ["sym", "q"]]]]], ["let", "q", [], ["+", x, 1]],
                ["let", "r", ["y"], ["and", ["<", y, ["/", 1, x]], ["defined", ["at", "V", n]]]],
                ["let", "d", [], ["+", y, ["*", w, ["+", ["z"], ["recip", ["z"]]]]]], ["let", "e", [], ["/", ["+", ["z"], y], ["-", c((w, x)), c((["z"], 0))]]]]

    def term(self, depth, names):
        def inner():
            return self.term(depth - 1, names)

        kind = self.rng.random()
        if depth <= 0 or kind < 0.3:
            return self.rng.choice((["sym", self.rng.choice(names)], ["sym", self.rng.choice(names)],
                                    self.rng.randint(-1, 3), ["rat", self.rng.randint(-2, 4), 2]))
        op = self.rng.choice(("+", "-", "*", "neg", "/", "/", "U", "U", "V", "f", "g", "cospi", "if", "abs", "sqrt", "^", "roots_in"))
        if op == "if":
            return ["if", self.formula(0, names, depth - 1), inner(), inner()]
        if op == "roots_in":
            return [op, self.linear(names)]
        if op == "^":
            return [op, inner(), self.rng.choice((0, 1, 2, 2))]
        if op == "sqrt":
            return [op, self.rng.choice((["^", inner(), 2], inner()))]
        if op in ("neg", "abs"):
            return [op, inner()]
        return ["at", op, inner()] if op in "UVfg" else [op, inner(), inner()]

    def in_z(self, depth, names):
        kind = self.rng.random()
        if depth <= 0 or kind < 0.35:
            return self.rng.choice((["z"], ["recip", ["z"]], ["sym", "d"], ["sym", "e"], self.term(1, names)))
        op = self.rng.choice(("+", "-", "*", "/", "neg", "recip", "^"))
        first = self.in_z(depth - 1, names)
        return [op, first] if op in ("neg", "recip") else [op, first, self.rng.randint(0, 2) if op == "^" else self.in_z(depth - 1, names)]

    def linear(self, names):
        return ["+", self.rng.choice((1, 2, self.term(1, names))), ["*", self.rng.choice((1, -2, self.term(1, names))), ["z"]]]

    def circle(self, names):
        a, b, c = (self.term(1, names) for _ in range(3))
        kind, op = self.rng.random(), self.rng.choice(("pos_circle", "nonneg_circle"))
        if kind < 0.25:
            return ["schur", self.rng.choice((self.linear(names), self.in_z(1, names)))]
        if kind < 0.5:
            return [self.rng.choice(("=", "!=")), self.in_z(3, names), self.in_z(2, names)]
        if kind < 0.7:  # two ways to write one function, or nearly so
            d, e = ["-", ["z"], b], ["+", ["*", c, ["z"]], 1]
            left = ["/", ["+", a, ["/", ["z"], d]], e] if kind < 0.6 else ["recip", ["/", ["+", ["z"], a], d]]
            right = (["/", ["+", ["*", a, d], ["z"]], ["*", d, e]] if kind < 0.6 else
                     ["/", ["+", 1, ["*", self.rng.choice((a, b)), ["z"]]], ["-", 1, ["*", b, ["z"]]]])
            return ["=", left, right]
        if kind < 0.8:
            return [op, ["/", ["+", 1, ["*", a, ["z"]], ["^", ["z"], 2]], ["*", self.rng.choice((2, -1, ["+", b, 1])), ["z"]]]]
        return [op, self.rng.choice((["sym", "d"], ["neg", ["sym", "d"]], a, self.in_z(1, names), ["+", a, ["*", b, ["+", ["z"], ["/", 1, ["z"]]]]]))]

    def formula(self, depth, names, deep=2):
        def inner():
            return self.formula(depth - 1, names)

        kind = self.rng.random()
        if depth <= 0 or kind < 0.3:
            terms = [self.term(min(1, deep), names), self.term(deep, names), *([self.term(1, names)] if self.rng.random() < 0.1 else [])]
            op = self.rng.choice(RELATIONS)
            return [op, *terms[:2 if op == "!=" else 3]]
        if kind < 0.42:
            return ["defined", self.rng.choice((self.term(2, names), ["sqrt", self.term(0, names)], self.term(3, names)))]
        if kind < 0.55:
            return self.circle(names)
        if kind < 0.7:
            return [self.rng.choice(("and", "or", "=>", "<=>")), inner(), inner()]
        if kind < 0.75:
            return ["at", self.rng.choice("pr"), self.term(1, names)]
        if kind < 0.82:
            return ["not", inner()]
        if kind < 0.85:
            return ["if", inner(), inner(), inner()]
        name = self.rng.choice("kjxyUfqt")
        return [self.rng.choice(("forall", "exists")), name, self.term(1, names), self.term(1, names), self.formula(depth - 1, [*names, name])]

    def statement(self):
        given = [[f"h{i}", self.formula(1, FREE), "standing"] for i in range(self.rng.randint(0, 2))]
        return {"sizes": ["n", "m"], "over": [["x", ["integer", -2, 3]], ["y", ["scalar"]],
                         ["w", [self.rng.choice(("scalar", "nonzero", "positive", "nonneg"))]]],
                "where": self.definitions(), "given": given, "says": self.formula(3, FREE)}

    def instance(self):
        def real():
            return Fraction(self.rng.randint(-3, 4), self.rng.choice((1, 1, 2)))

        return {"n": self.rng.randint(0, 3), "m": self.rng.randint(0, 3), "x": self.rng.randint(-2, 3), "y": real(), "w": real(), "horizon": 5}


class Instance:
    """Truth of facts on an instance: a number for each atom, and any, but always the same, for what has no value."""

    def __init__(self, statement, values, junk):
        self.facts, self.world, self.junk = Facts({**statement, "given": []}), World(statement, values), junk
        self.env = {name: v for name, v in values.items() if name != "horizon"}
        self.memory = {}

    def term(self, p):
        total = 0
        for monomial, c in p.items():
            product = c
            for a in monomial:
                product = product * (self.env[a] if isinstance(a, str) else self.atom(a))
            total = total + product
        return total

    def rational(self, p):
        if not isinstance(value := self.term(p), (int, Fraction)):
            raise Unknown("a name that stands for no rational number")
        return value

    def atom(self, a):
        kind, *parts = a
        if kind in ("at", "def"):
            at = self.term(dict(parts[1]))
            assert at == int(at)
            return self.entry(kind, parts[0], int(at))
        first, *second = (self.term(dict(part)) for part in parts)
        if kind == "/":
            return first / Fraction(second[0]) if second[0] != 0 and isinstance(second[0], int) else first / second[0] if second[0] != 0 else self.junk + first
        if kind == "sqrt":
            return self.junk - first if sign(first) < 0 else self.world.value(["sqrt", ["sym", "here"]], {"here": first})
        (b,) = second
        return 1 if b == 0 else cosine(int(first), abs(int(b)))

    def entry(self, kind, name, at):
        if (kind, name, at) not in self.memory:
            try:
                value = self.world.call(name, (at,))
            except Undefined:
                value = None
            if kind == "def":
                self.memory[kind, name, at] = int(value is not None)
            else:
                made = self.made(name, at)
                assert value is None or made == value
                self.memory[kind, name, at] = made
        return self.memory[kind, name, at]

    def made(self, name, at):
        """What a definition makes of numbers for what has no value."""
        _, _, index, start, initial, step = self.facts.definitions[name]
        if at < start:
            return self.junk * at
        early = at < start + len(initial)
        names = self.facts.own() if early else {**self.facts.own(), index: number(at - 1)}
        return next(self.term(p) for conditions, p in self.facts.cases(initial[at - start] if early else step, names) if all(map(self.true, conditions)))

    def true(self, fact):
        op = fact[0]
        if op in ("and", "or"):
            return (all if op == "and" else any)(map(self.true, fact[1]))
        if op in ("all", "some"):
            return (all if op == "all" else any)(self.true(self.at(fact, at)) for at in self.range(fact))
        s = sign(self.term(fact[1]))
        return s == 0 if op == "=" else s > 0 if op == ">" else s >= 0

    def range(self, fact):
        low, high = (None if p is None else int(self.term(p)) for p in fact[2:4])
        low = -REACH if low is None else low
        return range(low, (low + 2 * REACH if high is None else high) + 1)

    def at(self, fact, at):
        _, name, _, _, body, names, affirmed, valued = fact
        constants = {key: number(self.rational(p)) for key, p in names.items()}
        return self.facts.body(body, affirmed, {**constants, name: number(at)}, valued)


HINTED = ("close", "split", "cut", "divide", "at", "name", "solve", "induct", "unfold", "quotient", "root", "valued", "valued", "exist", "exist", "acute",
          "product", "cosines", "right")


def a_step(draw, facts, count):
    """A step with random arguments."""
    rng, names = draw.rng, [*facts.names]
    numbers = {op: [i for i, f in enumerate(facts.facts) if f is not None and f[0] == op] for op in ("or", "all", "some", "=")}
    kind = rng.choice([*HINTED, *(["split"] * 4 if numbers["or"] else []), *(["name"] * 6 if numbers["some"] else []), *(["at"] * 4 if numbers["all"] else [])])
    step = {"step": kind, "name": f"i{count}", "by": rng.randint(1, 4), "of": rng.choice(("", "h0", "h1")), "from": rng.randint(-1, 1)}
    step.update({key: draw.term(1, names) for key in ("x", "y", "term", "a", "b", "n")})
    if kind in ("unfold", "exist"):
        step["name"] = rng.choice("UV")
    if kind in ("acute", "cosines", "product", "right"):
        step.update({key: rng.choice((rng.randint(-2, 3), rng.randint(-2, 3), ["sym", "m"], ["-", n, 2])) for key in ("a", "b", "n", "term")})
    if kind == "cut":
        step["formula"] = draw.formula(1, names)
    if kind == "induct":
        step["formula"] = draw.formula(1, [*names, step["name"]])
    op = {"split": "or", "at": "all", "name": "some", "solve": "="}.get(kind)
    if op:
        if not numbers[op]:
            return None
        step["fact"] = rng.choice(numbers[op])
    if kind == "solve":
        atoms = [a for mono in facts.facts[step["fact"]][1] if len(mono) == 1 for a in mono]
        if not atoms:
            return None
        chosen = rng.choice(atoms)
        step["variable"] = chosen if isinstance(chosen, str) else repr(chosen)
    if kind == "close":
        return {"step": "close", "terms": [["1", [rng.choice([i for i, f in enumerate(facts.facts) if f is not None and f[0] in ("=", ">", ">=")] or [0])]]]}
    return step


def new_name(here, step, before):
    """The integers that a new name may stand for: one of them has to do."""
    if step["step"] == "name":
        return list(here.range(before.facts[step["fact"]]))
    if step["step"] == "divide":
        return [int(here.term(before.value(step["term"]))) // step["by"]]
    return list(range(step["from"], step["from"] + REACH)) if step["step"] == "induct" and type(step["from"]) is int else []


def a_true_case(here, step, before, cases):
    """A case all of whose facts are true on the instance, with an integer for a new name."""
    for case in cases:
        for value in new_name(here, step, before) if any(v not in here.env for v in case.whole) else [None]:
            if value is not None:
                here.env[step["name"]] = value
            if all(here.true(f) for f in case.facts if f is not None):
                return case
            here.env.pop(step["name"], None) if value is not None else None
    return None


def started(made, values, junk):
    """The facts of a statement that is false on an instance; what its formulas say is compared with what they are read as."""
    world = World(made, values)
    if {"nonzero": values["w"] == 0, "positive": values["w"] <= 0, "nonneg": values["w"] < 0}.get(made["over"][2][1][0]):
        return None
    here = Instance(made, values, junk)
    for i, (_, formula, _) in enumerate(made["given"]):
        made["given"][i][1] = formula if agreed(here, world, formula) else ["not", formula]
    if agreed(here, world, made["says"]):
        made = {**made, "says": ["not", made["says"]]}
    facts = Facts(made)
    facts.add(facts.read(made["says"], False))
    assert all(here.true(f) for f in facts.facts), (made, values)
    return facts, here


def agreed(here, world, formula):
    """The truth of a formula, read as facts too; Undefined where it has none, but the facts are a case and its opposite then."""
    yes, no = (here.true(here.facts.read(formula, affirmed)) for affirmed in (True, False))
    assert yes != no, formula
    said = truth(world, formula, {})
    assert said == yes, (formula, world.values)
    return said


def walks(seed, count):
    """Numbers of walks and of steps taken."""
    draw, done, steps = Draw(seed), 0, 0
    for _ in range(count):
        made, values = draw.statement(), draw.instance()
        check_statement(made)
        try:
            begun = started(made, values, draw.rng.choice((0, 1, -2, Fraction(5, 3))))
        except (Undefined, Unknown, Rejected):
            continue
        if begun is None:
            continue
        facts, here = begun
        done += 1
        for i in range(8):
            try:
                step = a_step(draw, facts, i)
                if step is None:
                    continue
                cases = facts.step(step)
                after = a_true_case(here, step, facts, cases)
            except (Undefined, Unknown, Rejected):
                continue
            assert after is not None, (facts.statement, values, step, facts.facts)
            facts, steps = after, steps + 1
    return done, steps


@pytest.mark.parametrize("seed", range(4))
def test_a_true_fact_stays_true_in_one_of_the_cases(seed):
    done, steps = walks(seed, 600)
    assert done > 50 and steps > 200
