# SPDX-License-Identifier: MIT
"""Random statements about integers, with quotients by zero, recursions before their start, cases, empty ranges and hidden names: nothing false is proved."""

from __future__ import annotations

import random
from itertools import product

import pytest

from tests.kernel.acceptance import is_false, is_proved

n, m, x, k, t = (["sym", name] for name in "nmxkt")
HINTS = [["divide", n, 2, "h"], ["divide", n, 3, "h"], ["at", "k", n], ["at", "k", 0], ["at", "j", 1], ["unfold", "U", n], ["unfold", "V", n],
         ["unfold", "U", ["+", n, 1]], ["quotient", n, m], ["quotient", n, n], ["quotient", 1, n], ["cosines", n, m, 3], ["cosines", n, 0, m],
         ["cosines", 1, n, n], ["product", n, 1, m], ["right", n], ["at", "turns", 0], ["induct", "h", 0, [">=", ["at", "U", ["sym", "h"]], 0]],
         ["at", "x", 0], ["at", "x", n], ["cut", ["at", "p", n], [], []], ["cut", ["=", x, 0], [], []]]
FREE = ["n", "m", "x", "q"]


class Draw:
    """Formulas in n, m, an integer x and q = x + 1, and in bound names, which may hide all but sizes."""

    def __init__(self, seed: int) -> None:
        self.rng = random.Random(seed)
        step = ["-", ["*", self.rng.choice((0, 1, 2)), ["at", "U", t]], ["at", "U", ["-", t, 1]]]
        self.where = [["rec", "U", "t", 0, [0, 1], step], ["rec", "V", "t", 1, [2], ["/", ["at", "V", t], ["-", t, 2]]],
                      ["let", "f", ["k"], ["if", ["=", k, x], n, ["/", x, k]]],
                      ["let", "p", ["k"], ["exists", "x", 0, 3, ["=", k, ["*", x, ["sym", "q"]]]]], ["let", "q", [], ["+", x, 1]]]

    def term(self, depth, names, whole=False):
        def inner(whole=whole):
            return self.term(depth - 1, names, whole)

        kind = self.rng.random()
        if depth <= 0 or kind < 0.35:
            return self.rng.choice((["sym", self.rng.choice(names)], self.rng.randint(-1, 4)))
        if kind < 0.75 or whole:
            return [self.rng.choice("+-*"), inner(), inner()]
        op = self.rng.choice(("/", "U", "V", "f", "cospi", "if"))
        if op == "if":
            return ["if", self.formula(0, names, depth - 1), inner(), inner()]
        return ["at", op, inner(True)] if len(op) == 1 and op != "/" else [op, inner(op == "cospi"), inner(True)]

    def formula(self, depth, names, deep=2):
        kind = self.rng.random()
        if depth <= 0 or kind < 0.4:
            return [self.rng.choice(("=", "=", "!=", "<", "<=", ">", ">=")), self.term(min(1, deep), names), self.term(deep, names)]
        if kind < 0.6:
            return [self.rng.choice(("and", "or", "=>", "<=>")), self.formula(depth - 1, names), self.formula(depth - 1, names)]
        if kind < 0.64:
            return ["at", "p", self.term(0, names)]
        if kind < 0.7:
            return ["not", self.formula(depth - 1, names)]
        if kind < 0.76:
            return ["always", "t", self.formula(depth - 1, [*names, "t"])]
        name = self.rng.choice("kjxUfqt")
        return [self.rng.choice(("forall", "exists")), name, self.term(1, names, True), self.term(1, names, True), self.formula(depth - 1, [*names, name])]

    def statement(self):
        given = [["h", self.formula(0, FREE), "standing"]] if self.rng.random() < 0.5 else []
        return {"sizes": ["n", "m"], "over": [["x", ["integer", -1, n]]], "where": self.where, "given": given, "says": self.formula(2, FREE)}


def counterexample(made):
    every = ((a, b, c) for a, b in product(range(6), repeat=2) for c in range(-1, a + 1))
    return next((found for found in every if is_false(made, {**dict(zip("nmx", found, strict=True)), "horizon": 5})), None)


@pytest.mark.parametrize("seed", range(3))
def test_no_random_statement_is_proved_and_false(seed):
    draw, proved = Draw(seed), 0
    for _ in range(400):
        made = draw.statement()
        if is_proved(made, draw.rng.sample(HINTS, 3)):
            proved += 1
            assert counterexample(made) is None, made
    assert proved > 20
