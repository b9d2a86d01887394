# SPDX-License-Identifier: MIT
"""Numbers and 1 x 1 matrices that a hypothesis compares: what such a comparison gives, and what it does not; powers that have a value."""

from __future__ import annotations

import pytest

from exactkf.evidence import order
from exactkf.finders.prove import every_size
from exactkf.kernel.definite import exists
from exactkf.kernel.reader import Reader
from exactkf.language import Expr, Statement, T, given, matrix, nonneg, positive, scalar, symbols, symmetric_matrix
from tests.kernel.acceptance import is_accepted

P, Q, a, b, c, n, x, y = symbols("P Q a b c n x y")
OVER = {P: symmetric_matrix(n), Q: symmetric_matrix(n), x: matrix(n, 1), y: matrix(n, 1), a: scalar(), b: nonneg(), c: positive()}
SMALL, LARGE = T(x) * P * x, T(y) * Q * y
COMPARED = given("compared", SMALL <= a * LARGE)
GAP = a * LARGE - SMALL


def statement(says: Expr, *hypotheses) -> dict:
    return Statement(says, sizes=["n"], over=OVER, given=list(hypotheses)).to_json()


def proved(made: dict, *by) -> bool:
    """The finder has a certificate that the checker accepts."""
    return any(map(is_accepted, every_size("X", made, list(by), 5.0)))


def test_a_multiple_of_a_comparison():
    """A nonnegative multiple, and with a strict comparison and a positive multiple a strict one."""
    assert proved(statement(b * SMALL <= b * a * LARGE, COMPARED), order([b * GAP]))
    assert proved(statement(c * SMALL < c * a * LARGE, given("compared", SMALL < a * LARGE)), order([c * GAP]))


@pytest.mark.parametrize(("says", "terms", "compared"), [
    (b * SMALL >= b * a * LARGE, [b * (SMALL - a * LARGE)], SMALL <= a * LARGE), (a * SMALL <= a * a * LARGE, [a * GAP], SMALL <= a * LARGE),
    (b * SMALL < b * a * LARGE, [b * GAP], SMALL < a * LARGE), (c * SMALL < c * a * LARGE, [c * GAP], SMALL <= a * LARGE),
    (b * SMALL <= b * a * LARGE, [b * GAP], SMALL >= a * LARGE), (b * SMALL <= b * a * LARGE, [b * GAP], SMALL <= b * LARGE)])
def test_what_a_comparison_does_not_give(says, terms, compared):
    """Not the reverse, nor a multiple of unknown sign, nor a strict one where the sign or the comparison is not strict."""
    assert not proved(statement(says, given("compared", compared)), order(terms))


@pytest.mark.parametrize(("power", "expected"), [
    (a**2, True), (a**0, True), (c**-1, False), (a**-1, False),
    (1 / c, True), (1 / a, False), ((1 / a)**2, False), ((1 / c)**2, True)])
def test_powers_that_have_a_value(power, expected):
    """A power with an exponent that is not negative divides by nothing but what stands in it; others are not looked into."""
    made = statement(a == a)
    assert expected == exists(Reader(made), _listed(power.tree), [])


def _listed(tree):
    return [_listed(t) for t in tree] if isinstance(tree, tuple) else tree
