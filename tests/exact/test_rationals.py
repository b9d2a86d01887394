# SPDX-License-Identifier: MIT
"""Tests of exactkf.exact.rationals."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy
from flint import fmpq, fmpz
from hypothesis import given, settings
from hypothesis import strategies as st

from exactkf._errors import BadInput
from exactkf.exact.rationals import rational, to_fraction

fractions = st.fractions(max_denominator=10**6)
few = settings(max_examples=35, deadline=None)


@few
@given(fractions)
def test_every_exact_type_gives_the_same_number(x):
    """A Fraction, its quotient string, its sympy Rational and its fmpq are one number."""
    q = fmpq(x.numerator, x.denominator)
    assert rational(x) == rational(str(x)) == rational(sympy.Rational(x.numerator, x.denominator)) == rational(q) == q
    assert to_fraction(q) == x


@few
@given(st.integers(), st.integers(-30, 30))
def test_decimal_strings_agree_with_the_fractions_module(mantissa, exponent):
    """A decimal string and a Decimal have the value that Fraction gives them."""
    text = f"{mantissa}e{exponent}"
    assert to_fraction(rational(text)) == Fraction(text) == to_fraction(rational(Decimal(text)))
    text = f"{mantissa}.{abs(exponent)}"
    assert to_fraction(rational(text)) == Fraction(text)


@few
@given(st.floats(-1e9, 1e9, allow_subnormal=False).filter(lambda x: x == 0 or abs(x) > 1e-9))
def test_floats_by_policy(x):
    """The three policies give the dyadic value, the printed decimal and the closest small fraction."""
    assert to_fraction(rational(x, floats="exact")) == Fraction(x)
    assert to_fraction(rational(x, floats="decimal")) == Fraction(str(x))
    assert to_fraction(rational(x, floats=100)) == Fraction(x).limit_denominator(100)


def test_numpy_scalars():
    """Numpy integers are exact and a float32 prints its own shortest decimal."""
    assert rational(np.int64(-7)) == rational(np.uint8(7)) - 14 == -7
    assert rational(np.float32(0.1), floats="decimal") == fmpq(1, 10)
    assert to_fraction(rational(np.float32(0.1), floats="exact")) == Fraction(float(np.float32(0.1)))


@pytest.mark.parametrize(
    "text, value",
    [
        ("3/4", fmpq(3, 4)),
        ("-6 / 4", fmpq(-3, 2)),
        ("1e-3", fmpq(1, 1000)),
        (".5", fmpq(1, 2)),
        ("5.", fmpq(5)),
        (" +2 ", fmpq(2)),
        ("-0.25E1", fmpq(-5, 2)),
    ],
)
def test_strings(text, value):
    """Each accepted spelling has the value it says."""
    assert rational(text) == value


def test_huge_integers_pass():
    """An integer string beyond the interpreter's digit limit is read."""
    assert rational("1" + "0" * 5000) == fmpz(10) ** 5000


@pytest.mark.parametrize(
    "x",
    [
        0.5,
        float("nan"),
        float("inf"),
        np.float64(0.5),
        np.float32(0.5),
        True,
        np.True_,
        None,
        1j,
        "",
        ".",
        "e5",
        "1/0",
        "1e999999",
        "1e-999999",
        "1e99999999999",
        "1_000",
        "٣",
        "1/2/3",
        "0x10",
        "__import__('os')",
        "nan",
        "1" * 200_000,
        Decimal("NaN"),
        Decimal("1e999999"),
        sympy.sqrt(2),
        sympy.Float(0.5),
        [1],
    ],
)
def test_refusals_are_one_line_and_name_the_argument(x):
    """What is not an exact rational number is refused in one line."""
    with pytest.raises(BadInput) as error:
        rational(x, name="gain")
    assert "argument 'gain'" in str(error.value) and "\n" not in str(error.value) and len(str(error.value)) < 300


@pytest.mark.parametrize("policy", ["exact", "decimal", 10])
@pytest.mark.parametrize("x", [float("nan"), float("inf"), -float("inf")])
def test_not_finite_is_always_refused(x, policy):
    """No policy makes a number of nan or infinity."""
    with pytest.raises(BadInput, match="not finite"):
        rational(x, floats=policy)


@pytest.mark.parametrize("policy", ["nearest", 0, -3, True, 1.5])
def test_unknown_policies_are_refused(policy):
    """A policy that does not exist is refused by name."""
    with pytest.raises(BadInput, match="argument 'floats'"):
        rational(0.5, floats=policy)
