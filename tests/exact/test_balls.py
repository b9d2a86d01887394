# SPDX-License-Identifier: MIT
"""Tests of exactkf.exact.balls."""

import flint
import pytest
from flint import acb, arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactkf._errors import BadInput, Unsupported
from exactkf.exact.balls import ball, contains, decide, equal, less, precision, sign

rationals = st.builds(fmpq, st.integers(-(10**9), 10**9), st.integers(1, 10**9))
few = settings(max_examples=35, deadline=None)


def test_precision_is_restored_after_an_error():
    """The old precision comes back even when the block raises."""
    old = flint.ctx.prec
    with pytest.raises(RuntimeError), precision(200):
        assert flint.ctx.prec == 200
        raise RuntimeError
    assert flint.ctx.prec == old


@pytest.mark.parametrize("bits", [0, 1, -5, 1.5, True])
def test_bad_precision(bits):
    """A precision that is no integer of at least 2 is refused."""
    with pytest.raises(BadInput), precision(bits):
        pass


@few
@given(rationals, st.integers(2, 80))
def test_ball_contains_its_number(q, bits):
    """The ball around a rational number contains it at every precision."""
    with precision(bits):
        assert contains(ball(q), q)
        assert not contains(ball(q), q + abs(q) + 1)


def test_contains_edges():
    """The ends of a ball belong to it, points beyond do not, and infinite balls hold everything."""
    assert contains(arb(1, 0.5), "3/2") and contains(arb(1, 0.5), "1/2")
    assert not contains(arb(1), fmpq(10**30 + 1, 10**30))
    assert contains(arb(0, "inf"), 5) and not contains(arb("nan"), 0)


@few
@given(rationals, rationals)
def test_less_agrees_with_rationals(p, q):
    """A decided comparison of enclosures agrees with the comparison of the numbers."""
    with precision(12):
        assert less(p, q) in (None, p < q)
        assert sign(ball(p)) in (None, (p > 0) - (p < 0))
    assert decide(lambda: less(p, q) if p != q else False) == (p < q)


def test_three_answers():
    """Overlapping balls leave comparison and equality undecided."""
    wide = arb(0, 1)
    assert less(wide, wide) is None and equal(wide, wide) is None and sign(wide) is None
    assert equal(arb(1), arb(1)) is True and equal(arb(1), arb(2)) is False
    assert equal(acb(1, 2), acb(1, 2)) is True and equal(acb(1, 2), acb(1, 3)) is False
    assert sign(arb(0)) == 0 and less(arb(1), arb(1)) is False


def test_decide_needs_and_gets_precision():
    """A difference of 1e-60 is decided by doubling, an equality is given up at the bound."""
    close = fmpq(10**60 + 1, 10**60)
    assert decide(lambda: less(arb(1), ball(close))) is True
    with pytest.raises(Unsupported, match="512 bits"):
        decide(lambda: less(arb(2).sqrt() ** 2, 2), bound=512)
