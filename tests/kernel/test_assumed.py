# SPDX-License-Identifier: MIT
"""Hypotheses at a generic index: what follows from them is proved, and nothing by a division that they do not allow."""

from __future__ import annotations

import pytest

from exactkf.evidence import fact, generic_index, lemma, use
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import (
    Statement,
    Zero,
    always,
    block,
    eq,
    forall,
    given,
    inv,
    let,
    matrix,
    matrix_of,
    nonzero,
    prod,
    rec,
    scalar,
    sequence,
    signal,
    standing,
    sym,
    symbols,
    vector,
    when,
)
from tests.kernel.acceptance import is_accepted

n, m, k, j, i, t, u, a, b, c, d, x, y, X, Y, v = symbols("n m k j i t u a b c d x y X Y v")
SCALARS = {"a": scalar(), "b": scalar(), "c": scalar(), "d": scalar()}


def accepts(says, *hypotheses, over, lemmas=(), where=(), sizes=("n",), **hints):
    statement = Statement(says=says, sizes=sizes, over=over, where=where, given=hypotheses)
    return is_accepted(seal("test", "generic index", statement.to_json(), generic_index(*lemmas, **hints).hints))


def test_an_equation_at_every_index_of_its_range():
    """x_(k+1) = x_k for k < n makes x_n = x_0, and says nothing about x_(n+1)."""
    steps = given("steps", forall(k, 0, n - 1, x[k + 1] == x[k]))
    to = lemma(t, forall(u, t, n, x[t] == x[0]), uses=[use(0, t=t, u=u), use("steps", k=t)])
    over = {"x": sequence(0, n + 1)}
    assert accepts(x[n] == x[0], steps, over=over, lemmas=[to], uses=[use(0, t=n, u=n)])
    assert not accepts(x[n] == x[0], over=over, lemmas=[to], uses=[use(0, t=n, u=n)])  # without the hypothesis
    assert not accepts(x[n] == x[0], given("steps", forall(k, 0, n - 2, x[k + 1] == x[k])), over=over, lemmas=[to], uses=[use(0, t=n, u=n)])
    assert not accepts(x[n + 1] == x[n], steps, over=over, uses=[use("steps", k=n)])
    assert not accepts(x[n] == x[0], steps, over=over, lemmas=[lemma(t, x[t] == x[0], uses=[use("steps", k=t)])], uses=[use(0, t=n)])
    assert not accepts(x[n] == x[0], given("steps", forall(k, 0, n - 1, x[k + 1] <= x[k])), over=over, lemmas=[to], uses=[use(0, t=n, u=n)])


def test_what_holds_as_long_as_it_has_a_value():
    """With y_t = 1, 1, .., and none from t = 2 on, x_t = y_t for all t is true of an instance, and so is z_t = y_t; x_5 = z_5 is not."""
    where = [rec(y, t, 1, y[t] / when(t < 1, 1, b))]
    both = [given("first", forall(t, 0, n, x[t] == y[t])), given("second", forall(t, 0, n, v[t] == y[t]))]  # all of these have a value
    over = {"x": signal(0), "v": signal(0), "b": scalar()}
    uses = [use("first", t=n), use("second", t=n)]
    assert accepts(x[n] == v[n], *both, over=over, where=where, uses=uses)
    data = Statement(says=x[n] == v[n], sizes=["n"], over=over, where=where, given=both).to_json()
    data["given"] = [[label, ["always", "t", formula[4]], kind] for label, formula, kind in data["given"]]
    with pytest.raises(Rejected, match="about all t"):
        replay(seal("test", "generic index", data, generic_index(uses=uses).hints))


def test_no_division_that_is_not_allowed():
    """b c = b d gives c = d if b is not zero, by a hypothesis or by its type; b = 0 gives nothing by dividing by b."""
    equal, other = given("equal", b * c == b * d), given("b is not zero", b != 0)
    by = {"uses": [use("equal", times=1 / b)], "over": SCALARS}
    assert accepts(c == d, equal, other, **by) and accepts(c == d, equal, **{**by, "over": {**SCALARS, "b": nonzero()}})
    assert not accepts(c == d, equal, **by)
    assert not accepts(c == d, equal, given("another", a != 0), **by) and not accepts(c == d, equal, given("a sum", a + b != 0), **by)
    assert accepts(c == d, given("equal", (a - b) * c == (a - b) * d), given("differ", b != a), uses=[use("equal", times=1 / (a - b))], over=SCALARS)
    null = given("null", b == 0)
    assert not accepts(c == d, null, uses=[use("null", times=(c - d) / b)], over=SCALARS)
    assert not accepts(c == 0, null, uses=[use("null", times=c / b)], over=SCALARS)


def test_no_division_elsewhere_in_the_proof():
    """A lemma that divides by b, before or after, is not to be used beside b = 0."""
    null = given("null", b == 0)
    one = lemma(t, b * (1 / b) == 1, direct=True)
    for says in (eq(1, 0), c == d):
        assert not accepts(says, null, lemmas=[one], uses=[use(0, t=0), use("null")], over=SCALARS)
        assert not accepts(says, null, lemmas=[one], uses=[use(0, t=0), use("null", times=1 / b)], over=SCALARS)
    assert accepts(a * b == 0, null, uses=[use("null", times=a)], over=SCALARS)
    assert not accepts(a * b == 0, null, lemmas=[one], uses=[use("null", times=a)], over=SCALARS)  # needless, and refused all the same
    over = {"x": sequence(1, n)}
    empty = given("null", forall(k, 1, n, x[k] == 0))
    assert not accepts(prod(k, 1, n, x[k]) == 1, empty, lemmas=[lemma(t, always(u, prod(k, 1, t, x[k]) == prod(k, 1, t, x[k])), direct=True)],
                       uses=[use("null", k=1, times=prod(k, 2, n, x[k]))], over=over)


def test_entries_of_a_matrix_equation():
    """A shift on both sides makes X constant along diagonals, entry by entry; a shift on one side only does not."""
    shift = matrix_of(i, j, n, n, when(j == i + 1, 1, 0))
    row, col = sym("row"), sym("column")
    both, over = given("both", shift * X == X * shift), {"X": matrix(n, n), "Y": matrix(n, n)}
    down = lemma(t, forall(u, t, n, forall(k, 1, n, X[t, k] == when(k >= t, X[1, k - t + 1], 0))), start=1,
                 uses=[use(0, t=t, u=u, k=k - 1), use("both", row=t, column=k)])
    says = matrix_of(i, j, n, n, when(j >= i, X[1, j - i + 1], 0))
    by = {"lemmas": [down], "uses": [use(0, t=row, u=n, k=col)], "over": over}
    assert accepts(X == says, both, **by)
    for wrong in (given("both", shift * X == Y * shift), given("both", shift * Y == Y * shift), given("other", shift * X == X * shift)):
        assert not accepts(X == says, wrong, **by)
    assert not accepts(X == matrix_of(i, j, n, n, X[1, 1]), both, **by)
    beyond = lemma(t, forall(k, 1, n, X[t, k] == when(k >= t, X[1, k - t + 1], 0)), start=1, uses=[use(0, t=t, k=k - 1), use("both", row=t, column=k)])
    assert not accepts(X == says, both, **{**by, "lemmas": [beyond], "uses": [use(0, t=row, k=col)]})  # row n of the equation is not the next row of X


def test_an_inverse_that_a_hypothesis_takes_away():
    """With Y = 0 the vector inv(Y) 0 is none: what is said of it says nothing about what has a value."""
    null, over = given("null", Y == Zero(n, n)), {"Y": matrix(n, n), "x": vector(n), "y": vector(n)}
    row = sym("row")
    both = [fact(t, "solve", inv(Y) * Zero(n, 1) == z) for z in (x, y)]
    uses = [use("null", row=row, column=sym("column"))]
    assert not accepts(x == y, null, over=over, lemmas=[{**f, "uses": uses} for f in both], uses=[use(z, t=0, row=row) for z in (0, 1)])


def test_blocks_side_by_side():
    """Entries of a block matrix are those of its blocks; blocks that do not fit are refused."""
    over = {"X": matrix(n, m), "Y": matrix(n, n), "x": vector(n)}
    where = [let(v, block([[X, Y], [Zero(1, m), matrix_of(i, j, 1, n, 1)]]))]
    given_sizes = [standing("m >= 1", m >= 1), standing("n >= 1", n >= 1)]
    take = {"over": over, "where": where, "sizes": ("n", "m")}
    right = matrix_of(i, j, n, n, v[i, m + j]) == Y
    assert accepts(right & (v[n + 1, 1] == 0) & (v[n + 1, m + 1] == 1), *given_sizes, **take)
    for wrong in (matrix_of(i, j, n, n, v[i, m + j]) == X, matrix_of(i, j, n, n, v[i + 1, m + j]) == Y, v[n + 1, m] == 1, v[n, m + n] == 1):
        assert not accepts(wrong, *given_sizes, **take)
    for unfit in (block([[X, Y], [Zero(1, n), Zero(1, m)]]), block([[X, Y], [X]]), block([[X, x], [Y, x]])):
        assert not accepts(v[1, 1] == v[1, 1], *given_sizes, **{**take, "where": [let(v, unfit)]})
