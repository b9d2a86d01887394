# SPDX-License-Identifier: MIT
"""Detectable pencils: what the word means on instances, and what such a hypothesis gives, which nothing less does."""

from __future__ import annotations

from fractions import Fraction

import pytest

from exactkf.evidence import EIGENVALUE, EIGENVECTOR, order, within
from exactkf.finders.membership import find_order
from exactkf.finders.prove import every_size
from exactkf.kernel.linear import Matrix
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.order import Leaf
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import Expr, Identity, Statement, T, Zero, detectable, given, hstack, invertible, let, matrix, rank, scalar, schur, symbols
from tests.kernel.acceptance import is_accepted

A, B, F, K, L, X, x, y, a, b, k, m, n = symbols("A B F K L X x y a b k m n")
OVER = {F: matrix(k, n), K: matrix(k, n), X: matrix(n, m), B: matrix(m, m)}
PAIR = given("detectable", detectable(F, K))
GONE, CARRIED, STABLE = given("FX = 0", F * X == 0 * (F * X)), given("FX = KXB", F * X == K * X * B), given("B stable", schur(B))
ZERO = X == 0 * X
HALF = Fraction(1, 2)


def statement(says: Expr, *hypotheses, **more) -> dict:
    return Statement(says, **{"sizes": ["k", "n", "m"], "over": OVER, "given": list(hypotheses), **more}).to_json()


def proved(made: dict, *by) -> bool:
    """The finder has a certificate that the checker accepts."""
    return any(map(is_accepted, every_size("X", made, list(by), 5.0)))


def meant(first: list, second: list, columns: int) -> bool:
    world = World({"where": []}, {"F": Matrix(first, columns), "K": Matrix(second, columns)})
    return world.value(["detectable", ["sym", "F"], ["sym", "K"]])


# ---------------------------------------------------------------------- what it means
@pytest.mark.parametrize(("first", "second", "columns", "expected"), [
    ([[1]], [[HALF]], 1, True), ([[1]], [[1]], 1, False), ([[1]], [[-1]], 1, False),
    ([[1]], [[2]], 1, False), ([[0]], [[1]], 1, False), ([[0]], [[0]], 1, False),
    ([[1], [1]], [[2], [0]], 1, True), ([[1], [1]], [[2], [2]], 1, False),
    ([], [], 1, False), ([], [], 0, True), ([[], []], [[], []], 0, True),
    ([[1, 0]], [[0, 0]], 2, False), ([[1, 0], [0, 1]], [[0, -1], [1, 0]], 2, False), ([[1, 0], [0, 1]], [[0, -HALF], [HALF, 0]], 2, True),
    ([[1, 0], [0, 1]], [[0, 5], [0, 0]], 2, True), ([[1, 0], [0, 1], [0, 1]], [[2, 0], [0, 3], [0, 0]], 2, False)])
def test_the_word_on_small_pencils(first, second, columns, expected):
    """F - zK has full column rank at every complex z of modulus one or less, or has not."""
    assert meant(first, second, columns) == expected


def test_matrices_of_different_sizes():
    """They make no pencil."""
    with pytest.raises(Undefined):
        meant([[1]], [[1], [2]], 1)


# ---------------------------------------------------------------------- the rule
def test_what_follows():
    """FX = 0, or FX = KXB with a stable B, gives X = 0; and full column rank of F."""
    assert proved(statement(ZERO, PAIR, GONE), order(inside=[within(0, pencil=(F, K))]))
    assert proved(statement(ZERO, PAIR, CARRIED, STABLE), order(inside=[within(0, pencil=(F, K, B))]))
    assert proved(statement(ZERO, PAIR, given("X'F' = 0", T(X) * T(F) == 0 * (T(X) * T(F)))), order(inside=[within(0, pencil=(F, K))]))
    assert proved(statement(rank(F) == n, PAIR), order(inside=[within(0, vector="right", pencil=(F, K))]))


@pytest.mark.parametrize(("hypotheses", "by"), [
    ((GONE,), (F, K)), ((PAIR,), (F, K)), ((PAIR, given("KX = 0", K * X == 0 * (K * X))), (F, K)), ((PAIR, given("KX = 0", K * X == 0 * (K * X))), (K, F)),
    ((PAIR, CARRIED), (F, K, B)), ((CARRIED, STABLE), (F, K, B)), ((PAIR, STABLE), (F, K, B)),
    ((PAIR, given("FXB = KX", F * X * B == K * X), STABLE), (F, K, B)), ((given("detectable", detectable(K, F)), CARRIED, STABLE), (F, K, B)),
    ((given("detectable", detectable(T(F), T(K))), GONE), (F, K)), ((PAIR, GONE), (F,)), ((PAIR, GONE), (F, K, B, B, B))],
    ids=lambda some: ", ".join(map(str, some))[:60])
def test_nothing_less_is_enough(hypotheses, by):
    """Without one of the hypotheses, or with another pencil, X need not vanish."""
    assert not proved(statement(ZERO, *hypotheses), order(inside=[within(0, pencil=by)]))


def test_it_is_for_equations():
    """Not for an order, and not for invertibility."""
    square = {"over": {**OVER, F: matrix(n, n), K: matrix(n, n), X: matrix(n, n), B: matrix(n, n)}}
    for says in (invertible(X), Expr(("psd", X.tree))):
        assert not proved(statement(says, PAIR, GONE, **square), order(inside=[within(0, pencil=(F, K))]))


# ---------------------------------------------------------------------- vectors of two parts
POINT = {"sizes": ["k", "n"], "over": {F: matrix(k, n), K: matrix(k, n), x: matrix(n, 1), y: matrix(n, 1), a: scalar(), b: scalar()}}
REAL, IMAGINARY = given("real part", F * (a * x - b * y) == K * x), given("imaginary part", F * (b * x + a * y) == K * y)
OUTSIDE = given("outside", a * a + b * b - 1 >= 0)
BOTH = hstack(x, y) == 0 * hstack(x, y)


def test_a_complex_vector():
    """lam F z = K z for z = x + iy and lam = a + ib gives z = 0 if lam is not inside the unit circle."""
    by = order(inside=[within(0, pencil=(F, K, a, b))])
    assert proved(statement(BOTH, PAIR, REAL, IMAGINARY, OUTSIDE, **POINT), by)
    for hypotheses in ((REAL, IMAGINARY, OUTSIDE), (PAIR, REAL, OUTSIDE), (PAIR, REAL, IMAGINARY),
                       (PAIR, REAL, IMAGINARY, given("inside", 1 - a * a - b * b >= 0)),
                       (PAIR, REAL, given("another", F * (a * y - b * x) == K * y), OUTSIDE), (PAIR, REAL, IMAGINARY, given("not inside", a >= 1))):
        assert not proved(statement(BOTH, *hypotheses, **POINT), by)
    assert not proved(statement(x == 0 * x, PAIR, REAL, given("no imaginary part", y == 0 * y), OUTSIDE, **POINT), by)  # one column alone


def test_a_matrix_with_an_output_injection():
    """F = I: the pencil (I, A) is detectable where A is stable, seen through an eigenvector; M = LF with another L is not."""
    (v, w), (re, im) = EIGENVECTOR, EIGENVALUE
    sizes = {"sizes": ["k", "n"], "over": {F: matrix(k, n), K: matrix(k, n), L: matrix(n, k)}}
    left_inverse = given("LF = I", L * F == Identity(n))
    both = hstack(v, w) == Zero(n, 2)
    by = order(inside=[within(0, both, vector="right", pencil=(F, K, re, im), on=0)])
    assert not proved(statement(schur(L * K), PAIR, left_inverse, **sizes), by)  # LK may have more eigenvalues than the pencil
    kept = given("K = FLK", K == F * L * K)
    assert proved(statement(schur(L * K), PAIR, left_inverse, kept, **sizes), by)


# ---------------------------------------------------------------------- forgeries
def test_a_forged_proof():
    """A proof is none without the hypothesis, without the pencil, or with another one."""
    made = statement(ZERO, PAIR, GONE)
    parts = find_order(made, stable=[[0, {"pencil": [list(F.tree), list(K.tree)]}]])
    replay(seal("X", "order", made, {"parts": parts, "lemmas": []}))
    without = statement(ZERO, GONE)
    for forged, part in ((without, parts[0]), (made, {key: t for key, t in parts[0].items() if key != "pencil"}), (made, {**parts[0], "pencil": []}),
                         (made, {**parts[0], "pencil": [list(K.tree), list(F.tree)]})):
        with pytest.raises(Rejected):
            replay(seal("X", "order", forged, {"parts": [part], "lemmas": []}))


def test_trees_that_do_not_fit():
    """Pencils and numbers of other sizes are refused by the leaf itself."""
    made = statement(ZERO, PAIR, CARRIED, STABLE, where=[let(A, B * B)])
    zero = made["says"]
    Leaf(made | {"own": [zero], "alike": {}}, zero, [], pencil=[list(t.tree) for t in (F, K, B)])
    for by in ((F, K, A), (F, K, F), (F, K, T(X)), (F, K, B, B), (X, K)):
        with pytest.raises(Unknown):
            Leaf(made | {"own": [zero], "alike": {}}, zero, [], pencil=[list(t.tree) for t in by])
