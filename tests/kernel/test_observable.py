# SPDX-License-Identifier: MIT
"""Observable pairs: what the word means on instances, and that CX = 0, AX = XB give X = 0 under such a hypothesis only."""

from __future__ import annotations

from itertools import combinations

import pytest
import sympy
from hypothesis import given as drawn
from hypothesis import settings
from hypothesis import strategies as st

from exactkf.evidence import EIGENVALUE, EIGENVECTOR, order, within
from exactkf.finders.membership import find_order
from exactkf.finders.prove import every_size
from exactkf.kernel.linear import Matrix
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Unknown
from exactkf.kernel.order import Leaf
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import Expr, Identity, Statement, T, block, given, hstack, invertible, kernel_basis, let, matrix, observable, symbols, vstack
from tests.kernel.acceptance import is_accepted

A, B, C, M, N, X, m, n, p = symbols("A B C M N X m n p")
OVER = {A: matrix(n, n), B: matrix(m, m), C: matrix(p, n), X: matrix(n, m), M: matrix(n, n)}
ANNIHILATED, KEPT, SEEN = given("CX = 0", C * X == 0 * (C * X)), given("AX = XB", A * X == X * B), given("seen", observable(C, A))
BY = (C, A, B)


def statement(says: Expr, *hypotheses, **more) -> dict:
    return Statement(says, **{"sizes": ["n", "m", "p"], "over": OVER, "given": list(hypotheses), **more}).to_json()


def proved(made: dict, *by) -> bool:
    """The finder has a certificate that the checker accepts."""
    return any(map(is_accepted, every_size("X", made, list(by), 5.0)))


# ---------------------------------------------------------------------- what it means
entries = st.integers(-2, 2)
pairs = st.tuples(st.integers(1, 3), st.integers(0, 2)).flatmap(lambda size: st.tuples(
    st.lists(st.lists(entries, min_size=size[0], max_size=size[0]), min_size=size[0], max_size=size[0]),
    st.lists(st.lists(entries, min_size=size[0], max_size=size[0]), min_size=size[1], max_size=size[1])))


@drawn(pairs)
@settings(max_examples=80, deadline=None)
def test_by_common_zeros(pair):
    """Observable exactly if [A - w; C] has full column rank at every complex w: its maximal minors have no zero in common."""
    inner, rows = pair
    size, w = len(inner), sympy.Symbol("w")
    pencil = [[x - w * int(i == j) for j, x in enumerate(row)] for i, row in enumerate(inner)] + rows
    common = sympy.Poly(0, w)
    for chosen in combinations(pencil, size):
        common = sympy.gcd(common, sympy.Poly(sympy.Matrix(chosen).det(), w))
    world = World({"where": []}, {"A": Matrix(inner, size), "C": Matrix(rows, size)})
    assert world.value(["observable", ["sym", "C"], ["sym", "A"]]) == (common.degree() == 0)


# ---------------------------------------------------------------------- the rule
ZERO = X == 0 * X
RULE = order(inside=[within(0, kept=BY)])


def test_what_is_kept_and_annihilated_is_zero():
    """The rule, and an invariant null space of a nonsingular matrix."""
    assert proved(statement(ZERO, ANNIHILATED, KEPT, SEEN), RULE)
    own = {"over": {A: matrix(n, n), C: matrix(p, n)}, "sizes": ["n", "p"], "where": [let(N, kernel_basis(vstack(C, A)))]}
    inner = given("rows", C * A * N == 0 * (C * N))
    assert proved(statement(N == 0 * N, inner, SEEN, **own), order(inside=[within(0, kept=(C, A, 0 * (T(N) * N)))]))


@pytest.mark.parametrize("hypotheses", [
    (ANNIHILATED, KEPT), (ANNIHILATED, SEEN), (KEPT, SEEN), (ANNIHILATED, KEPT, given("seen", observable(C, T(A)))),
    (ANNIHILATED, KEPT, given("seen", observable(T(M) * M, A))), (ANNIHILATED, given("AX = BX", A * X == M * X), SEEN),
], ids=lambda some: ", ".join(str(g) for g in some)[:60])
def test_nothing_less_is_enough(hypotheses):
    """Without one of the three, or with another pair, X need not vanish."""
    assert not proved(statement(ZERO, *hypotheses), RULE)


def test_the_pair_is_one_of_the_statement():
    """Only a hypothesis makes a pair observable, and the one named in the proof is that pair."""
    made = statement(ZERO, ANNIHILATED, KEPT, SEEN)
    zero = made["says"]
    Leaf(made | {"own": [zero], "alike": {}}, zero, [], kept=[x.tree for x in BY])
    for by in ((C, T(A), B), (A, A, B), (C, A, C), (C, A, A), (C, A, X)):
        with pytest.raises(Unknown):
            Leaf(made | {"own": [zero], "alike": {}}, zero, [], kept=[list(x.tree) for x in by])


def test_it_is_for_equations():
    """Not for an order, and not for invertibility."""
    square = {"over": {**OVER, X: matrix(n, n), B: matrix(n, n)}}
    for says in (invertible(X), Expr(("psd", X.tree))):
        assert not proved(statement(says, ANNIHILATED, KEPT, SEEN, **square), RULE)


def test_a_forged_proof():
    """A proof for CX = 0 and AX = XB is none without the hypothesis, nor with another matrix in the place of B."""
    made = statement(ZERO, ANNIHILATED, KEPT, SEEN)
    parts = find_order(made, stable=[[0, {"kept": [list(x.tree) for x in BY]}]])
    replay(seal("X", "order", made, {"parts": parts, "lemmas": []}))
    without = statement(ZERO, ANNIHILATED, KEPT)
    for forged, part in ((without, parts[0]), (made, {key: x for key, x in parts[0].items() if key != "kept"}), (made, {**parts[0], "kept": []})):
        with pytest.raises(Rejected):
            replay(seal("X", "order", forged, {"parts": [part], "lemmas": []}))


# ---------------------------------------------------------------------- what makes a pair observable
L = symbols("L")[0]
(v, w), (re, im) = EIGENVECTOR, EIGENVALUE
TURN = block([[re * Identity(1), im * Identity(1)], [-im * Identity(1), re * Identity(1)]])
INJECTED = {"sizes": ["n", "p"], "over": {A: matrix(n, n), C: matrix(p, n), L: matrix(n, p), M: matrix(n, n)}}


def injection(inner: Expr, rows: Expr = C) -> bool:
    """(C, A) is observable if (rows, inner) is, by an eigenvector of A."""
    both = hstack(v, w) == 0 * hstack(v, w)
    made = statement(observable(C, A), given("seen", observable(rows, inner)), **INJECTED)
    return proved(made, order(inside=[within(0, both, vector="right", kept=(rows, inner, TURN), on=0)]))


def test_output_injection():
    """A + LC in the place of A; not any other matrix, and no other rows."""
    assert injection(A + L * C)
    assert injection(A - L * C, C)
    assert not injection(A + M)
    assert not injection(A + L * C, C * M)
    assert injection(A, C * A) and not injection(M, C)


def test_an_eigenvector_is_not_taken_for_granted():
    """Without a reason, and through the transpose, nothing is observable."""
    for vector in ("", "right", "left"):
        assert not proved(statement(observable(C, A), **INJECTED), order(inside=[within(0, vector=vector)]))
        assert not proved(statement(observable(C, A), given("seen", observable(C, T(A))), **INJECTED), order(inside=[within(0, vector=vector)]))
    seen = given("an inverse", T(C) * C == Identity(n))
    assert proved(statement(observable(C, A), seen, **INJECTED), order(inside=[within(0, vector="right")]))


def test_a_pair_that_does_not_fit():
    """Rows of another length than A are refused, and so is a matrix that is not square."""
    for pair in ((T(C), A), (C, C)):
        assert not proved(statement(observable(*pair), **INJECTED), order(inside=[within(0, vector="right")]))
