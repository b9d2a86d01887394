# SPDX-License-Identifier: MIT
"""Products of matrices made at random and rewritten, rightly or not: what the checker accepts is true on instances."""

from __future__ import annotations

from random import Random

import pytest

from exactkf.kernel.linear import Matrix
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown
from tests.kernel.test_false_claims import accepted, statement

n, m, t, a = (["sym", name] for name in "nmta")
F, G, H, P, D, h, g, r, c, b = (["sym", name] for name in "FGHPDhgrcb")
OVER = [*([x, ["matrix", n, n]] for x in "FG"), ["H", ["matrix", m, n]], ["P", ["symmetric", n]], ["D", ["diagonal", n]],
        *([x, ["matrix", n, 1]] for x in "hg"), ["r", ["matrix", 1, n]], ["c", ["matrix", 1, 1]], ["b", ["scalar"]], ["w", ["signal", 0]]]


def at(name, *indices):
    return ["at", name, *indices]


STEP = ["if", ["=", a, ["-", t, 1]], G, ["O", n, n]]
WHERE = [["rec", "X", "t", 0, [["I", n]], ["*", F, at("X", t)]], ["rec", "V", "t", 0, [h], ["+", ["*", F, at("V", t)], ["*", at("w", t), g]]],
         ["let", "Y", ["a", "t"], ["if", ["=", t, 0], ["O", n, n], ["+", ["*", F, at("Y", a, ["-", t, 1])], STEP]]],
         ["let", "E", ["a"], ["mat", "i", "j", n, n, ["if", ["<=", ["sym", "i"], a], at("h", ["sym", "j"]), 0]]],
         ["let", "Z", ["a"], ["+", ["^", F, a], ["*", h, ["T", g]]]]]
Y_IS = ["if", ["<", a, t], ["*", ["^", F, ["-", ["-", t, 1], a]], G], ["O", n, n]]
RULES = [{"index": "t", "says": ["=", at("X", t), ["^", F, t]], "rule": True},
         {"index": "t", "says": ["always", "a", ["=", at("Y", a, t), Y_IS]], "rule": True}]
SIZES = {"n": n, "m": m, "1": 1}
LEAVES = {"nn": [F, F, G, P, D, ["I", n], ["O", n, n]], "mn": [H], "n1": [h, g, ["O", n, 1]], "1n": [r], "11": [c, b, 2], "mm": [["I", m]],
          "m1": [["O", m, 1]]}


class Maker:
    """Terms of given sizes, and steps from one to another."""

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)
        self.pick = self.random.choice

    def index(self, bound):
        return self.pick([m, ["+", m, 1], 0, 1, 2, *(x for s in bound for x in (["sym", s], ["-", m, ["sym", s]], ["+", ["sym", s], 1]))])

    def term(self, rows, cols, depth, bound=()):
        x = self.random.random()
        if rows + cols == "nn" and x < 0.3:
            base = self.pick([F, G, P, ["T", F]])
            return self.pick([["^", base, self.index(bound)], *(at(name, self.index(bound)) for name in "XZE"), at("Y", self.index(bound), self.index(bound))])
        if rows + cols == "n1" and x < 0.15:
            return at("V", self.index(bound))
        if depth < 1 or x > 0.9:
            return self.pick(LEAVES[rows + cols]) if rows + cols in LEAVES else ["T", self.pick(LEAVES[cols + rows])]
        if x < 0.62:
            inner = self.pick("nnnm1")
            scalar = [self.pick(LEAVES["11"])] if self.random.random() < 0.2 else []
            return ["*", *scalar, self.term(rows, inner, depth - 1, bound), self.term(inner, cols, depth - 1, bound)]
        if x < 0.72:
            return ["T", self.term(cols, rows, depth - 1, bound)]
        if x < 0.82 or len(bound) > 1:
            return [self.pick("+-"), *(self.term(rows, cols, depth - 1, bound) for _ in range(2))]
        name = f"s{len(bound)}"
        high = self.pick([m, ["+", m, 1], ["-", m, 1], 1, 2])
        return ["sum", name, self.pick([0, 0, 1]), high, self.term(rows, cols, depth - 1, (*bound, name))]

    def rewritten(self, tree):
        """One place rewritten: seldom wrongly."""
        places = [p for p in _places(tree) if isinstance(p[1], list)]
        self.random.shuffle(places)
        for path, x in places:
            if (new := self.step(x, self.random.random())) is not None:
                return _put(tree, path, new)
        return tree

    def step(self, x, chance):
        op = x[0]
        if op == "T" and isinstance(x[1], list):
            y = x[1]
            if y[0] in ("*", "+", "-"):
                return [y[0], *(p if isinstance(p, int) else ["T", p] for p in (y[1:] if y[0] != "*" or chance > 0.9 else y[:0:-1]))]
            return {"T": y[-1], "^": ["^", ["T", y[1]], y[-1]], "sum": [*y[:4], ["T", y[-1]]]}.get(y[0], y if y in (P, D) or chance < 0.1 else None)
        if op == "*" and len(x) == 3:
            p, q = x[1:]
            for y, made in ((p, lambda z: ["*", z, q]), (q, lambda z: ["*", p, z])):
                if isinstance(y, list) and y[0] in ("+", "-") and len(y) == 3 and chance < 0.7:
                    return [y[0], made(y[1]), made(y[2])]
                if isinstance(y, list) and y[0] == "sum":
                    return [*y[:4], made(y[4])]
            return ["*", q, p] if chance < 0.1 else ["*", *(p[1:] if isinstance(p, list) and p[0] == "*" else [p]), q]
        if op == "*":
            return ["*", x[1], ["*", *x[2:]]] if chance < 0.5 else ["*", ["*", *x[1:-1]], x[-1]]
        if op == "^":
            less = ["^", x[1], ["-", x[2], 1]]
            return ["*", less, x[1]] if chance < 0.4 else ["*", x[1], less] if chance < 0.9 else ["^", x[1], ["+", x[2], 1]]
        if op == "sum":
            _, name, low, high, body = x
            if chance < 0.5:
                return ["+", ["sum", name, low, ["-", high, 1], body], _with(body, name, high)]
            return ["sum", name, 0, ["-", high, low], _with(body, name, ["-", high, ["sym", name]])]
        return ["^", F, x[2]] if op == "at" and x[1] == "X" else None


def _places(tree, path=()):
    yield path, tree
    if isinstance(tree, list) and tree[0] not in ("I", "O"):
        for k, x in enumerate(tree):
            if k and isinstance(x, (list, int)):
                yield from _places(x, (*path, k))


def _put(tree, path, new):
    return [*tree[:path[0]], _put(tree[path[0]], path[1:], new), *tree[path[0] + 1:]] if path else new


def _with(tree, name, index):
    if not isinstance(tree, list):
        return tree
    if tree[0] == "sum" and tree[1] == name:
        return [*tree[:2], *(_with(x, name, index) for x in tree[2:4]), tree[4]]
    return index if tree == ["sym", name] else [_with(x, name, index) for x in tree]


def world(made, seed, size, length):
    """Random matrices of small integers, of sizes zero too."""
    random = Random(seed)

    def draw(rows, cols):
        return Matrix.build(rows, cols, lambda i, j: random.randint(-3, 3))

    half, full = draw(size, size), draw(size, size)
    values = {"F": draw(size, size), "G": draw(size, size), "H": draw(length, size), "P": half + half.transpose(), "h": draw(size, 1), "g": draw(size, 1),
              "D": Matrix.build(size, size, lambda i, j: full.rows[i][i] if i == j else 0), "r": draw(1, size), "c": draw(1, 1), "b": 2}
    return World(made, {"n": size, "m": length, "horizon": 3, "w": {k: random.randint(-3, 3) for k in range(9)}, **values})


PLACES = [(0, 0), (0, 2), (1, 0), (1, 1), (1, 3), (2, 0), (2, 1), (2, 2), (3, 2), (2, 3)]


@pytest.mark.parametrize("seed", range(8))
def test_what_is_accepted_is_true(seed):
    """Forty statements, each rewritten in a few places; many are accepted, and no instance is against one of them."""
    maker, kept = Maker(seed), 0
    for number in range(40):
        left = right = maker.term(*maker.pick(["nn", "nn", "n1", "11", "mn", "mm", "1n"]), maker.random.randint(1, 3))
        for _ in range(maker.random.randint(1, 5)):
            right = maker.rewritten(right)
        given = [[str(s), [">=", s, 1], "standing"] for s in (n, m) if maker.random.random() < 0.4]
        made = statement(["=", left, right], OVER, given, WHERE, ["n", "m"])
        if left == right or not accepted("generic index", made, {"lemmas": RULES if number % 3 == 0 else []}):
            continue
        for size, length in PLACES:
            if all((size, length)[x == str(m)] >= 1 for x, _, _ in given):
                try:
                    value = world(made, number, size, length).value(made["says"])
                except (Undefined, Unknown):
                    continue
                kept += 1
                assert value, (size, length, left, right)
    assert kept > 20
