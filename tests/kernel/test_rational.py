# SPDX-License-Identifier: MIT
"""The rational numbers of replaying are those of the standard library."""

from __future__ import annotations

import operator
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exactkf.kernel.rational import Rational, quotient

OPERATIONS = [operator.add, operator.sub, operator.mul, operator.truediv, operator.eq, operator.ne, operator.lt, operator.le, operator.gt, operator.ge]
small = st.integers(-12, 12)


@given(small, small, small, small)
def test_arithmetic_is_that_of_fractions(p, q, r, s):
    """With its like, with ints and with Fractions, from both sides; numerators and denominators are in lowest terms."""
    x, own = Fraction(p, q or 1), quotient(p, q or 1)
    y, like = Fraction(r, s or 1), quotient(r, s or 1)
    assert type(own) is Rational
    assert (own.numerator, own.denominator, hash(own), bool(own), -own) == (x.numerator, x.denominator, hash(x), bool(x), -x)
    for run in OPERATIONS:
        for a, b, c, d in ((x, y, own, like), (x, y, own, y), (x, y, x, like), (x, r, own, r), (r, x, r, own)):
            if run is operator.truediv and not b:
                with pytest.raises(ZeroDivisionError):
                    run(c, d)
                continue
            wanted, found = run(a, b), run(c, d)
            assert found == wanted
            assert not isinstance(wanted, Fraction) or (found.numerator, found.denominator) == (wanted.numerator, wanted.denominator)


def test_nothing_is_divided_by_zero():
    """Neither when a number is made nor by arithmetic."""
    with pytest.raises(ZeroDivisionError):
        quotient(1, 0)
    with pytest.raises(ZeroDivisionError):
        1 / quotient(0, 5)
