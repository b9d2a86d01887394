# SPDX-License-Identifier: MIT
"""Statements made at random: what the checker accepts at a generic index, with no lemma at all, has no counterexample.

The readings of `exactkf.kernel.generic` are those of `exactkf.kernel.meaning`, or none.
"""

from __future__ import annotations

from random import Random

import pytest

from exactkf.finders.draw import Sampler
from exactkf.kernel.numbers import Undefined, Unknown
from tests.kernel.test_false_claims import accepted, statement

n, t = ["sym", "n"], ["sym", "t"]
OVER = [["w", ["matrix", n, 1]], ["v", ["matrix", n, 1]], ["A", ["matrix", n, n]], ["B", ["matrix", n, n]], ["S", ["symmetric", n]], ["M", ["matrix", n, 2]],
        ["c", ["scalar"]], ["d", ["nonzero"]], ["s", ["signal", 0]], ["Z", ["signal_of", 0, ["matrix", n, n]]], ["p", ["poly", 2]], ["q", ["monic", 1]]]
WHERE = [["rec", "X", "t", 0, [1], ["*", 2, ["at", "X", t]]], ["rec", "P", "t", 0, [1], ["+", ["*", ["z"], ["at", "P", t]], ["at", "s", t]]],
         ["rec", "Y", "t", 0, [["sym", "w"]], ["+", ["at", "Y", t], ["sym", "v"]]], ["let", "f", ["k"], ["*", ["sym", "c"], ["at", "s", ["sym", "k"]]]],
         ["let", "D", [], ["mat", "i", "j", n, n, ["if", ["=", ["sym", "i"], ["sym", "j"]], ["at", "w", ["sym", "i"]], 0]]]]


class Maker:
    """Terms of a given kind and depth, with the indices in sight."""

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)
        self.pick = self.random.choice

    def index(self, bound):
        return self.pick([0, 1, 2, -1, n, ["+", n, 1], ["-", n, 1], *(["sym", b] for b in bound), *(["-", ["sym", b], 1] for b in bound)])

    def condition(self, bound):
        return [self.pick(["=", "!=", "<", "<=", ">", ">="]), self.index(bound), self.index(bound)]

    def number(self, depth, bound):
        leaf, inner = "abcdefgh"[len(bound)], depth - 1
        if depth < 1:
            return self.pick([0, 1, ["rat", 1, 2], ["sym", "c"], ["sym", "d"], *(["at", x, self.index(bound)] for x in "sXfw")])
        x, y = self.number(inner, bound), self.number(inner, bound)
        return self.pick([
            [self.pick("+-*"), x, y], ["/", x, ["sym", "d"]], ["^", x, self.pick([0, 2, -1])], ["if", self.condition(bound), x, y],
            [self.pick(["sum", "prod"]), leaf, self.pick([0, 1]), self.index(bound), self.number(inner, [*bound, leaf])],
            ["entry", self.matrix(inner, bound), self.index(bound), 1], ["det", self.matrix(inner, bound)],
            ["coeff", self.polynomial(inner, bound), self.index(bound)], ["*", ["T", self.column(inner, bound)], self.column(inner, bound)]])

    def column(self, depth, bound):
        leaf = "abcdefgh"[len(bound)]
        if depth < 1:
            return self.pick([["sym", "w"], ["sym", "v"], ["at", "Y", self.index(bound)], ["O", n, 1]])
        x, y = self.column(depth - 1, bound), self.column(depth - 1, bound)
        return self.pick([[self.pick("+-"), x, y], ["*", self.number(depth - 1, bound), x], ["*", self.matrix(depth - 1, bound), x],
                          ["col", leaf, n, self.number(depth - 1, [*bound, leaf])]])

    def matrix(self, depth, bound):
        first, second = "abcdefgh"[len(bound)], "ijklmnop"[len(bound)]
        if depth < 1:
            return self.pick([*(["sym", x] for x in "ABSMD"), ["I", n], ["O", n, n], ["at", "Z", 0], ["rows", [1, 0], [2, 1]]])
        x, y = self.matrix(depth - 1, bound), self.matrix(depth - 1, bound)
        return self.pick([
            [self.pick("+-*"), x, y], ["*", self.number(depth - 1, bound), x], ["T", x], ["inv", x], ["^", x, self.pick([2, -1, n])],
            ["mat", first, second, self.pick([n, 2, 1]), self.pick([n, 2, 1]), self.number(depth - 1, [*bound, first, second])],
            ["block", [x], [y]], ["if", self.condition(bound), x, y], ["sum", first, self.pick([0, 1]), self.index(bound), x],
            ["*", self.column(depth - 1, bound), ["T", self.column(0, bound)]], ["diag", self.number(0, bound), self.number(0, bound)]])

    def polynomial(self, depth, bound):
        leaf = "abcdefgh"[len(bound)]
        if depth < 1:
            return self.pick([["z"], ["sym", "p"], ["sym", "q"], ["at", "P", self.index(bound)], ["^", ["z"], self.index(bound)], self.number(0, bound)])
        x, y = self.polynomial(depth - 1, bound), self.polynomial(depth - 1, bound)
        return self.pick([
            [self.pick("+-"), x, y], ["*", self.number(depth - 1, bound), x], ["*", x, ["z"]], ["rev", x, self.index(bound)], ["recip", x],
            ["sum", leaf, 0, self.index(bound), self.polynomial(depth - 1, [*bound, leaf])], ["charpoly", self.matrix(depth - 1, bound)],
            ["if", self.condition(bound), x, y], ["det", ["mat", "i", "j", 1, 1, x]]])

    def claim(self, bound):
        depth = self.pick([0, 1, 2])
        x, y, v = self.matrix(depth, bound), self.matrix(depth, bound), self.number(depth, bound)
        return ["=", *self.pick([
            (["coeff", self.polynomial(depth, bound), self.pick([0, 1, 2, n])], self.pick([0, 1])), ([self.pick(["nrows", "ncols"]), x], self.pick([1, 2, n])),
            (["*", x, y], ["*", y, x]), (["T", x], x), (["det", x], self.pick([0, 1])), (x, y), (v, self.pick([0, 1, ["sym", "c"]])),
            (["block", [x], [y]], ["block", [y], [x]]), (["*", v, x], ["*", x, self.number(depth, bound)])])]


@pytest.mark.parametrize("seed", range(4))
def test_what_is_accepted_has_no_counterexample(seed):
    """Three hundred statements, of which some are accepted; those have a value on a few instances, and it is true."""
    maker, found = Maker(seed), 0
    for _ in range(300):
        bound = maker.pick([[], ["t"]])
        says = maker.claim(bound)
        made = statement(["forall", "t", maker.pick([0, 1]), n, says] if bound else says, OVER, (), WHERE)
        if not accepted("generic index", made, {"lemmas": [], "supported": ["P"]}):
            continue
        for size in (0, 1, 2, 3):
            for instance, world in Sampler(made, {"sizes": {"n": [size]}}, [], seed).stream(3):
                try:
                    value = world.value(made["says"])
                except (Undefined, Unknown):
                    continue
                found += 1
                assert value is True, (made["says"], instance)
    assert found > 20
