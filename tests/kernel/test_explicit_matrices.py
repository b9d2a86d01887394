# SPDX-License-Identifier: MIT
"""Matrices that are written out, in statements about numbers: what is false of them on an instance is not proved."""

from __future__ import annotations

import random

import pytest

from exactkf.kernel.arithmetic import Facts
from exactkf.kernel.numbers import Unknown
from tests.kernel.acceptance import is_false, is_proved
from tests.kernel.test_arithmetic import found, statement

Z = ["z"]
x, y, u, v = (["sym", name] for name in "xyuv")
REAL = [[name, ["scalar"]] for name in "xyuv"]
FULL, SYMMETRIC, COLUMN = ["rows", [x, y], [u, v]], ["rows", [x, y], [y, v]], ["rows", [x], [y]]
DET = ["-", ["*", x, v], ["*", y, u]]


def real(says, *given, where=()):
    return statement(says, (), REAL, given, where)


def test_a_determinant_a_trace_and_entries():
    assert found(real(["=", ["det", FULL], DET])) and not found(real(["=", ["det", FULL], ["+", ["*", x, v], ["*", y, u]]]))
    assert found(real(["=", ["tr", FULL], ["+", x, v]])) and not found(real(["=", ["tr", FULL], ["+", x, y]]))
    assert found(real(["=", ["entry", FULL, 1, 2], y]))
    assert not found(real(["=", ["entry", FULL, 2, 1], y])) and not found(real(["=", ["entry", FULL, 1, 3], y]))


def test_a_characteristic_polynomial():
    right = ["+", ["-", ["^", Z, 2], ["*", ["+", x, v], Z]], DET]
    assert found(real(["=", ["charpoly", FULL], right])) and not found(real(["=", ["charpoly", FULL], ["+", right, ["*", y, Z]]]))
    assert found(real(["=", ["charpoly", ["rows", [x]]], ["-", Z, x]])) and not found(real(["=", ["charpoly", ["rows", [x]]], ["+", Z, x]]))


def test_a_matrix_of_size_one_is_stable_as_its_entry_is():
    assert found(real(["<=>", ["schur", ["rows", [x]]], ["<", ["abs", x], 1]])) and not found(real(["<=>", ["schur", ["rows", [x]]], ["<=", ["abs", x], 1]]))


def test_a_nonnegative_definite_matrix_is_symmetric_with_three_signs():
    """No one of the diagonal entries and the determinant is enough, nor two of them."""
    signs = [[">=", x, 0], [">=", v, 0], [">=", ["-", ["*", x, v], ["^", y, 2]], 0]]
    assert found(real(["<=>", ["psd", SYMMETRIC], ["and", *signs]]))
    for k in range(3):
        assert not found(real(["=>", ["and", *(s for j, s in enumerate(signs) if j != k)], ["psd", SYMMETRIC]]))
    assert not found(real(["=>", ["and", [">", x, 0], [">", v, 0], [">", DET, 0]], ["psd", FULL]])) and found(real(["=>", ["psd", FULL], ["=", y, u]]))
    assert found(real(["=>", ["pd", SYMMETRIC], [">", x, 0]])) and not found(real(["=>", ["psd", SYMMETRIC], [">", x, 0]]))


def test_products_are_those_of_matrices():
    square = ["rows", [["+", ["*", x, x], ["*", y, u]], ["*", y, ["+", x, v]]], [["*", u, ["+", x, v]], ["+", ["*", y, u], ["*", v, v]]]]
    assert found(real(["=", ["*", FULL, FULL], square])) and not found(real(["=", ["*", FULL, ["T", FULL]], square]))
    assert not found(real(["=", ["*", FULL, ["T", FULL]], ["*", ["T", FULL], FULL]]))
    assert found(real(["=>", ["=", ["*", FULL, COLUMN], ["O", 2, 1]], ["=", ["+", ["*", x, x], ["*", y, y]], 0]], ["=", ["-", FULL, ["I", 2]], ["O", 2, 2]]))


def test_what_is_no_matrix_written_out_is_refused():
    facts = Facts(statement(["=", x, x], ("n",), [*REAL, ["A", ["matrix", 2, 2]]]))
    wide, one, big = ["rows", [x, y, u]], ["rows", [x]], ["I", 3]
    for term in (["det", COLUMN], ["det", ["sym", "A"]], ["det", wide], ["det", big], ["det", x], ["tr", ["*", COLUMN, COLUMN]], ["det", ["*", one, FULL]],
                 ["det", ["+", FULL, x]], ["det", ["I", ["sym", "n"]]], ["det", ["rows", [Z, x], [x, y]]], ["entry", FULL, x, 1], ["det", ["-", FULL, COLUMN]]):
        with pytest.raises(Unknown):
            facts.read(["=", term, 0], True)
    for formula in (["=", FULL, COLUMN], ["=", FULL, 0], ["=", one, one], ["=", one, x], ["psd", one], ["psd", wide], ["schur", FULL], ["pd", ["sym", "A"]]):
        with pytest.raises(Unknown):
            facts.read(formula, True)


class Draw:
    """Formulas about 2 x 2 matrices of small numbers."""

    def __init__(self, seed: int) -> None:
        self.rng = random.Random(seed)

    def matrix(self, depth=2):
        op = self.rng.choice(("rows", "rows", "+", "-", "*", "T", "I", "neg", "M", "scaled")) if depth else "rows"
        if op == "rows":
            p, q = (self.rng.choice((x, y, 1, -1, 0, 2)) for _ in range(2))
            return ["rows", [self.rng.choice((x, y, 1, 2)), p], [self.rng.choice((p, q)), self.rng.choice((x, y, 1, 2))]]
        if op in ("I", "M"):
            return ["I", 2] if op == "I" else ["sym", "M"]
        if op in ("T", "neg"):
            return [op, self.matrix(depth - 1)]
        return ["*", x, self.matrix(depth - 1)] if op == "scaled" else [op, self.matrix(depth - 1), self.matrix(depth - 1)]

    def formula(self):
        kind = self.rng.choice(("psd", "pd", "det", "tr", "=", "charpoly", "entry"))
        if kind in ("psd", "pd"):
            return [kind, self.matrix()]
        if kind in ("=", "charpoly"):
            sides = [self.matrix(1), self.matrix(1)]
            return ["=", *([kind, s] if kind == "charpoly" else s for s in sides)]
        term = [kind, self.matrix(), *((self.rng.randint(1, 2), self.rng.randint(1, 2)) if kind == "entry" else ())]
        return [self.rng.choice(("=", ">=", ">", "<=")), term, self.rng.choice((0, x, 1))]


@pytest.mark.parametrize("seed", range(3))
def test_no_random_statement_about_matrices_is_proved_and_false(seed):
    draw, proved = Draw(seed), 0
    for _ in range(150):
        says = [draw.rng.choice(("=>", "or", "<=>")), draw.formula(), draw.formula()]
        made = real(says, where=[["let", "M", [], ["rows", [x, 1], [y, 0]]]])
        if is_proved(made, [["square", x]]):
            proved += 1
            assert not any(is_false(made, {"x": p, "y": q, "u": 0, "v": 0}) for p in range(-3, 4) for q in range(-3, 4)), made
    assert proved > 5
