# SPDX-License-Identifier: MIT
"""What is shown away from zero: where it holds at zero too, and false statements for which it need not."""

from __future__ import annotations

import pytest

from exactkf.evidence import order
from exactkf.finders.membership import find_order
from exactkf.finders.prove import every_size
from exactkf.kernel.continuity import away_from_zero
from exactkf.kernel.numbers import Unknown
from exactkf.kernel.replay import seal
from exactkf.language import (
    Expr,
    Identity,
    Statement,
    T,
    det,
    given,
    inv,
    let,
    loewner,
    matrix,
    nonneg,
    pd,
    positive_semidefinite,
    psd,
    scalar,
    sqrt,
    standing,
    symbols,
    symmetric_matrix,
    when,
)
from tests.kernel.acceptance import is_accepted

A, P, a, b, n, s, t, u, x = symbols("A P a b n s t u x")
OVER = {A: matrix(n, n), P: positive_semidefinite(n), s: scalar(), t: scalar(), u: scalar()}


def statement(says: Expr, **more) -> dict:
    return Statement(says, **{"sizes": ["n"], "over": OVER, **more}).to_json()


def accepted(made: dict, evidence: dict) -> bool:
    return is_accepted(seal("X", "order", made, evidence))


def shown(says: Expr, names: tuple, *sums: list, **more) -> bool:
    """Proved away from zero, and accepted at zero."""
    made = statement(says)
    found = every_size("X", made, [order(*sums, away_from_zero=names, **more)], 5.0)
    return any(accepted(made, c["evidence"]) for c in found if c["evidence"].get("away from zero"))


@pytest.mark.parametrize("says, sums", [
    (s * inv(s * Identity(n)) * A == A, []),
    (psd(P / s * s), [[P]]),
    (loewner(P * s * s / s + P, P * s) & (T(s * A / s) == T(A)), [[P]]),
], ids=str)
def test_closed_statements(says, sums):
    """Equations and orders that are not strict."""
    assert shown(says, (s,), *sums)


def forged(says: Expr, away: list[str], **more) -> bool:
    """Whether the checker accepts a proof of the statement with nonzero scalars as one of the statement itself."""
    made = statement(says, **more)
    there = {**made, "over": [[name, ["nonzero"] if name in away else kind] for name, kind in made["over"]]}
    parts = find_order(there)
    assert parts is not None, "the forgery needs a proof away from zero"
    assert accepted(there, {"parts": parts, "lemmas": []})
    return accepted(made, {"parts": parts, "lemmas": [], "away from zero": away})


@pytest.mark.parametrize("says, more", [
    (s != 0, {}),
    ((s * A == 0 * A) >> (A == 0 * A), {}),
    (A == 0 * A, {"given": [given("g", s * A == 0 * A)]}),
    (A == 0 * A, {"where": [let(x, s * A)], "given": [given("g", x == 0 * A)]}),
    (pd(s * s * P + 0 * A * T(A)), {"given": [given("P > 0", pd(P))]}),
    (s * s > 0, {}),
], ids=str)
def test_false_at_zero(says, more):
    """Strict statements, implications, and hypotheses about the scalar: true away from zero, false at zero."""
    made = statement(says, **more)
    with pytest.raises(Unknown):
        away_from_zero(made, ["s"])
    there = {**made, "over": [[name, ["nonzero"] if name == "s" else kind] for name, kind in made["over"]]}
    if (parts := find_order(there)) is not None:
        assert not accepted(made, {"parts": parts, "lemmas": [], "away from zero": ["s"]})


def test_an_implication_that_is_proved_away_from_zero():
    """sA = 0 gives A = 0 for s other than zero, and the checker knows; that is no proof for s = 0."""
    assert not forged((s * A == 0 * A) >> (A == 0 * A), ["s"])
    assert not forged(A == 0 * A, ["s"], given=[given("g", s * A == 0 * A)])
    assert not forged(A == 0 * A, ["s"], where=[let(x, s * A)], given=[given("g", x == 0 * A)])


def test_names_are_scalars_that_may_be_zero():
    """No matrix, no size, no number that the type makes nonzero or of one sign, no unknown name, and at least one."""
    made = statement(s * A == A * s, over={**OVER, a: nonneg(), b: symmetric_matrix(n)})
    for names in (["A"], ["n"], ["a"], ["b"], ["z"], [], "s t", [["s"]], [0]):
        with pytest.raises(Unknown):
            away_from_zero(made, names)
    assert ["s", ["nonzero"]] in away_from_zero(made, ["s"])["over"]


@pytest.mark.parametrize("says, where", [
    (when(s == 0, 1, 0) * A == 0 * A, ()),
    (x * A == 0 * A, [let(x, when(s == 0, 1, 0))]),
    (x * A == 0 * A, [let(u, when(s == 0, 1, 0)), let(x, u + 1 - 1)]),
    (abs(s) * A == s * A, ()),
    (A == A, [let(x, sqrt(s))]),
    (t ** s * A == A, ()),
], ids=str)
def test_terms_that_jump(says, where):
    """Only operations that are continuous where they have a value."""
    over = {name: kind for name, kind in OVER.items() if name is not u}
    with pytest.raises(Unknown):
        away_from_zero(statement(says, where=list(where), over=over), ["s"])


def test_what_does_not_mention_the_scalar_is_free():
    """Hypotheses and strict conclusions about other variables."""
    made = statement(pd(P) & (s * A == A * s), given=[given("P > 0", pd(P)), standing("t", t > 0)])
    assert away_from_zero(made, ["s"])["says"] == made["says"]
    with pytest.raises(Unknown):
        away_from_zero(made, ["s", "t"])


def test_powers_of_a_size():
    """t^n det(sA) = s^n det(tA) for all s and t, by determinants that divide by them; not with another exponent."""
    factors = [(s * A, [s * Identity(n), A]), (t * A, [t * Identity(n), A])]
    assert shown(t ** n * det(s * A) / s ** n * s ** n == s ** n * det(t * A), (s, t), factors=factors)
    assert not shown(t ** (n + 1) * det(s * A) == s ** n * det(t * A), (s, t), factors=factors)
