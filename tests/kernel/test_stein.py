# SPDX-License-Identifier: MIT
"""The solution of X = MXM' + Q as a term: its value, what is known of it for a stable M, and that nothing is where M need not be."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import assume, settings
from hypothesis import given as drawn
from hypothesis import strategies as st

from exactkf.evidence import fact, generic_index, induction, order
from exactkf.finders.membership import find_order
from exactkf.finders.prove import every_size
from exactkf.kernel.linear import Matrix
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.reader import Reader, relations
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import (
    Expr,
    Identity,
    Statement,
    T,
    always,
    given,
    inv,
    let,
    loewner,
    matrix,
    pd,
    positive_definite,
    positive_semidefinite,
    psd,
    rec,
    schur,
    stein,
    symbols,
    symmetric_matrix,
)
from tests.kernel.acceptance import is_accepted

F, M, N, P, Q, R, W, X, Z_, n, t = symbols("F M N P Q R W X Z_ n t")
OVER = {M: matrix(n, n), N: matrix(n, n), F: matrix(n, n), Q: positive_semidefinite(n), P: positive_definite(n), R: symmetric_matrix(n), X: symmetric_matrix(n)}
STABLE = given("stable", schur(M))


def statement(says: Expr, *hypotheses, **more) -> dict:
    return Statement(says, **{"sizes": ["n"], "over": OVER, "given": list(hypotheses), **more}).to_json()


def proved(made: dict, *by) -> bool:
    return any(map(is_accepted, every_size("X", made, list(by) or [order()], 5.0)))


# ---------------------------------------------------------------------- its value
entries = st.fractions(-2, 2, max_denominator=3)


@drawn(st.integers(0, 3).flatmap(lambda size: st.tuples(*[st.lists(st.lists(entries, min_size=size, max_size=size), min_size=size, max_size=size)] * 2)))
@settings(max_examples=60, deadline=None)
def test_the_value_solves_the_equation(pair):
    """X = MXM' + Q, on instances of every kind."""
    m, q = (Matrix(rows, len(rows)) for rows in pair)
    world = World({"where": []}, {"M": m, "Q": q})
    try:
        found = world.value(stein(M, Q).tree)
    except Undefined:
        assume(False)
    assert [list(row) for row in (found - m * found * m.transpose() - q).rows] == [[0] * len(pair[0])] * len(pair[0])


@pytest.mark.parametrize("m", [[[1]], [[-1]], [[2, 0], [0, "1/2"]], [[0, 1], [-1, 0]]])
def test_no_value_without_a_single_solution(m):
    """Where eigenvalues have product one there is none, or more than one."""
    rows = [[Fraction(x) for x in row] for row in m]
    world = World({"where": []}, {"M": Matrix(rows), "Q": Matrix.identity(len(rows))})
    with pytest.raises(Undefined):
        world.value(stein(M, Q).tree)


# ---------------------------------------------------------------------- what is known of it
@pytest.mark.parametrize("says", [
    stein(M, Q) == M * stein(M, Q) * T(M) + Q,
    psd(stein(M, Q)),
    pd(stein(M, P)),
    loewner(stein(M, Q), Q),
    T(stein(M, F)) == stein(M, T(F)),
    T(stein(M, R)) == stein(M, R),
    stein(T(M), Q) - T(M) * stein(T(M), Q) * M == Q,
    stein(M, Identity(n)) * inv(stein(M, Identity(n))) == Identity(n),
    psd(F * stein(M, F * Q * T(F)) * T(F)),
], ids=str)
def test_of_a_stable_matrix(says):
    """The equation, symmetry, definiteness."""
    sums = {"loewner": [[M * stein(M, Q) * T(M)]]}.get(says.tree[0], [])
    assert proved(statement(says, STABLE), order(*sums))


@pytest.mark.parametrize("says", [
    stein(M, Q) == M * stein(M, Q) * T(M) + Q,
    psd(stein(M, Q)),
    stein(M, Q) == stein(M, Q),
], ids=str)
@pytest.mark.parametrize("hypotheses", [(), (given("another", schur(N)),), (given("a product", schur(M * N)),), (given("twice", schur(2 * M)),)], ids=str)
def test_of_another_matrix_nothing_is_known(says, hypotheses):
    """Without a hypothesis that says so of M itself the term is not read."""
    with pytest.raises(Unknown):
        Reader(statement(says, *hypotheses)).read(statement(says)["says"][1])
    assert not proved(statement(says, *hypotheses))


@pytest.mark.parametrize("says", [
    pd(stein(M, Q)), psd(stein(M, R)), stein(M, Q) == stein(T(M), Q), stein(M, Q) == M * stein(M, Q) * M + Q, T(stein(M, F)) == stein(M, F),
    stein(M, Q) == stein(M, P), loewner(Q, stein(M, Q)),
], ids=str)
def test_false_of_a_stable_matrix(says):
    """Wrong neighbours are not proved."""
    assert not proved(statement(says, STABLE), order([stein(M, Q)]), order([Q]))


def test_what_is_said_to_be_stable_has_no_solution_in_it():
    """A hypothesis of stability that stands on itself is not read."""
    for said in (schur(stein(M, Q)), schur(W)):
        made = statement(psd(stein(W, Q)), given("g", said), where=[let(W, stein(M, Q))])
        with pytest.raises(Unknown):
            Reader(made).read(made["says"][1])


def test_a_solution_brought_in_by_a_proof():
    """A term of the evidence is read on the same condition, and so is a lemma."""
    made = statement(psd(Q + P), given("another", schur(N)))
    for evidence in ({"parts": [{"sum": [["+", Q.tree, ["-", ["+", stein(M, Q).tree, P.tree], stein(M, Q).tree]]], "blocks": [[]]}], "lemmas": []},
                     {"parts": [{"sum": [], "blocks": [[]]}] * 2, "lemmas": [["=", list(stein(M, Q).tree), list(stein(M, Q).tree)]]}):
        with pytest.raises(Rejected):
            replay(seal("X", "order", made, evidence))


def test_relations_do_not_leak():
    """The relation of a solution is that of its own M and Q."""
    made = statement(stein(M, Q) == stein(M, P), STABLE)
    reader = Reader(made)
    first, second = (reader.read(x) for x in made["says"][1:])
    assert first != second
    assert sum(name.startswith("stein") for name in relations(reader)) in (2, 4)
    assert find_order(made) is None


# ---------------------------------------------------------------------- in an induction
def test_along_a_recursion():
    """From a start below the solution the covariances stay below it; without stability this is not shown."""
    where = [rec(W, t, 0 * Q, M * W[t] * T(M) + Q), let(Z_, stein(M, Q))]
    by = induction(base=order([stein(M, Q)]), step=order([M * (Z_ - W[t]) * T(M)]))
    assert proved(statement(always(t, loewner(Z_, W[t])), STABLE, where=where), by)
    assert not proved(statement(always(t, loewner(Z_, W[t])), where=where), by)
    assert not proved(statement(always(t, loewner(W[t], Z_)), STABLE, where=where), by)


def test_not_at_a_generic_index():
    """Proofs in coefficients and entries do not know what it is."""
    made = statement(stein(M, Q) == stein(M, Q), STABLE)
    with pytest.raises(Rejected):
        replay(seal("X", "generic index", made, generic_index(fact(t, "solve", stein(M, Q) == stein(M, Q))).hints))
