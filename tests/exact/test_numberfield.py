# SPDX-License-Identifier: MIT
"""Tests of exactkf.exact.numberfield."""

import json
import pickle
from fractions import Fraction

import mpmath
import pytest
from flint import fmpq, fmpq_poly
from hypothesis import given, settings
from hypothesis import strategies as st

from exactkf._errors import BadInput
from exactkf.exact.balls import contains
from exactkf.exact.numberfield import CyclotomicRealField, RealField, cyclotomic_real, sqrt_field
from exactkf.exact.polynomials import isolate_real_roots
from exactkf.exact.rationals import to_fraction

few = settings(max_examples=35, deadline=None)
FIELDS = [
    (sqrt_field(2), lambda: mpmath.sqrt(2)),
    (RealField([-2, 0, 0, 1], (1, 2), "c"), lambda: mpmath.cbrt(2)),
    (RealField([1, -3, 0, 1], (0, 1), "t"), lambda: 2 * mpmath.sin(mpmath.pi / 18)),
    (cyclotomic_real(11), lambda: 2 * mpmath.cos(2 * mpmath.pi / 11)),
    (RealField([-3, 2], (1, 2), "r"), lambda: mpmath.mpf(3) / 2),
]
fields = st.sampled_from(FIELDS)
coefficients = st.lists(st.fractions(-5, 5, max_denominator=4), min_size=0, max_size=6)


def value(coeffs, theta):
    """Return the polynomial at theta, numerically."""
    return mpmath.fsum(mpmath.mpf(c.numerator) / c.denominator * theta**k for k, c in enumerate(coeffs))


@few
@given(fields, coefficients, coefficients, st.integers(-3, 3))
def test_arithmetic_agrees_with_50_digits(field_and_theta, a, b, n):
    """Sums, products, quotients, powers and signs agree with 60 digit arithmetic."""
    field, theta = field_and_theta
    x, y = field(a), field(b)
    with mpmath.workdps(60):
        u, v = value(a, theta()), value(b, theta())
        pairs = [(x + y, u + v), (x - y, u - v), (x * y, u * v), (abs(x), abs(u))]
        if y:
            pairs += [(x / y, u / v), (y**n, v**n), (1 / y, 1 / v)]
        for exact, approximate in pairs:
            ball = exact.enclose(50)
            near = mpmath.mpf(ball.mid().str(55, radius=False))
            assert abs(near - approximate) <= mpmath.mpf(10) ** -45 * (1 + abs(approximate))
            assert exact.sign() == (0 if exact == 0 else int(mpmath.sign(approximate)))


@few
@given(fields, coefficients, coefficients)
def test_field_axioms_and_order(field_and_theta, a, b):
    """Inverses invert, the order is total and compatible, equal elements have equal hashes."""
    field, _ = field_and_theta
    x, y = field(a), field(b)
    assert (x + y) ** 2 == x * x + 2 * x * y + y * y and x - x == 0 and not (x - x)
    if x:
        assert x * x.inverse() == 1 and (y / x) * x == y
        assert (x * x).sign() == 1
    assert (x < y) + (x == y) + (x > y) == 1 and (x <= y) == (not x > y) and (x < y) == (-y < -x)
    assert hash(x + y - y) == hash(x)


@few
@given(fields, coefficients)
def test_minimal_polynomial(field_and_theta, a):
    """The minimal polynomial is irreducible, monic, of degree dividing that of the field, and vanishes."""
    field, _ = field_and_theta
    x = field(a)
    p = x.minimal_polynomial()
    assert sum((x**k * c for k, c in enumerate(p.coeffs())), field(0)) == 0
    assert p.leading_coefficient() == 1 and len(p.factor()[1]) == 1 and field.degree % p.degree() == 0
    assert x.is_rational() == (p.degree() == 1)


@settings(max_examples=30, deadline=None)
@given(st.integers(1, 40), st.integers(-50, 50), st.integers(-50, 50))
def test_two_cos_identities(n, j, k):
    """2cos a 2cos b = 2cos(a+b) + 2cos(a-b), and the values are the cosines."""
    field = cyclotomic_real(n)
    assert field.two_cos(j) * field.two_cos(k) == field.two_cos(j + k) + field.two_cos(j - k)
    assert field.two_cos(0) == 2 and field.two_cos(1) == field.gen() and field.two_cos(n - k) == field.two_cos(k)
    with mpmath.workdps(40):
        ball = field.two_cos(k).enclose(25)
        assert abs(mpmath.mpf(ball.mid().str(30, radius=False)) - 2 * mpmath.cos(2 * mpmath.pi * k / n)) < 1e-24


def test_signs_of_near_zeros():
    """A convergent of sqrt(2) with 200 digits is on the right side of it."""
    r = sqrt_field(2).gen()
    p, q = 1, 1
    for k in range(1, 521):
        p, q = p + 2 * q, p + q
        assert (r - fmpq(p, q)).sign() == (-1 if k % 2 else 1) or k not in (1, 2, 519, 520)
    assert (r - fmpq(p, q)).sign() == 1 and r > fmpq(p, q)
    assert contains((r - fmpq(p, q)).enclose(10), fmpq(p, q)) is False


def test_enclosures_have_the_digits_asked_for():
    """The relative error is at most 10**-digits also for tiny elements, and the ball holds the number."""
    r = sqrt_field(2).gen()
    for digits in (1, 15, 100, 500):
        for x in (r, (r - 1) ** 100, r / 10**50):
            ball = x.enclose(digits)
            assert ball.rad().fmpq() * fmpq(10) ** digits <= abs(ball.mid().fmpq())
    ball = r.enclose(300)
    mid, rad = ball.mid().fmpq(), ball.rad().fmpq()
    assert (mid - rad) ** 2 < 2 < (mid + rad) ** 2
    assert sqrt_field(2)(0).enclose(5).is_zero()
    for digits in (0, -1, 1.5):
        with pytest.raises(BadInput, match="argument 'digits'"):
            r.enclose(digits)


@pytest.mark.parametrize(
    "interval, problem",
    [
        ((3, 4), "no real roots"),
        ((-2, 2), "2 real roots"),
        ((2, 1), "exchanged"),
        (3, "not a pair"),
        ((1, 2, 3), "not a pair"),
        ((0.5, 2), "float"),
    ],
)
def test_intervals_are_checked(interval, problem):
    """An interval with no or several roots is refused in one line."""
    with pytest.raises(BadInput, match=problem) as error:
        RealField([-2, 0, 1], interval)
    assert "\n" not in str(error.value) and "argument 'interval" in str(error.value)


def test_bad_polynomials():
    """Constant polynomials, bad n and negative d are refused."""
    for p in ([], [0], [3]):
        with pytest.raises(BadInput, match="argument 'minpoly'"):
            RealField(p, (0, 1))
    for n in (0, -1, 1.5, True):
        with pytest.raises(BadInput, match="argument 'n'"):
            cyclotomic_real(n)
    with pytest.raises(BadInput, match="argument 'd'"):
        sqrt_field(-2)


@few
@given(
    st.lists(
        st.sampled_from([(-2, 0, 1), (-3, 0, 1), (-1, 1), (-3, 2), (1, 0, 1), (-2, 0, 0, 1), (1, -3, 0, 1)]),
        min_size=1,
        max_size=4,
    )
)
def test_reducible_polynomials_give_the_right_factor(factors):
    """Each real root of a reducible polynomial generates the field of its own factor."""
    p = fmpq_poly([1])
    for f in factors:
        p *= fmpq_poly(list(f))
    for root in isolate_real_roots(p):
        field = RealField(p, (root.lo, root.hi))
        assert field.minpoly == root.factor / root.factor.leading_coefficient()
        assert field.gen().minimal_polynomial() == field.minpoly
        assert root.lo <= field.gen() <= root.hi
        assert field.index == sum(other.factor == root.factor and other.hi < root.lo for other in isolate_real_roots(p))


def test_fields_are_equal_by_their_root():
    """The interval does not matter, the root does; elements of two fields compare as real numbers."""
    a, b = RealField([-2, 0, 1], (0, 5)), RealField([-4, 0, 2], ("1.4", "1.5"))
    c = RealField([-2, 0, 1], (-2, 0))
    assert a == b and hash(a) == hash(b) and a != c and a.gen() + b.gen() == 2 * a.gen()
    assert a.gen() != c.gen() and sqrt_field(8).gen() == 2 * a.gen() and hash(sqrt_field(8).gen()) == hash(2 * a.gen())
    assert sqrt_field(8).gen() != sqrt_field(3).gen() and cyclotomic_real(8).gen() == a.gen()
    assert sqrt_field(2)(3) == sqrt_field(3)(3) == 3 and a.gen() != "x" and a.gen() != 0.5
    with pytest.raises(BadInput, match="argument 'x'"):
        a.gen() + c.gen()


def test_mixed_arithmetic_on_both_sides():
    """int, Fraction and fmpq mix with elements, floats do not."""
    r = sqrt_field(2).gen()
    for half in (Fraction(1, 2), fmpq(1, 2)):
        assert half + r == r + half and half - r == -(r - half) and half * r == r / 2 and half / r == r / 4
        assert r > half and half < r and (r + half) - r == half and hash(r + half - r) == hash(half)
    assert (
        1 < r < 2
        and r != 1
        and (r * r).rational_value() == 2
        and to_fraction((r**-2).rational_value()) == Fraction(1, 2)
    )
    for bad in (0.5, "1", None):
        with pytest.raises(TypeError):
            r + bad
        with pytest.raises(TypeError):
            _ = r < bad
    with pytest.raises(BadInput):
        r.rational_value()
    for divide in (lambda: r / 0, lambda: 1 / (r - r), lambda: (r - r) ** -1):
        with pytest.raises(ZeroDivisionError):
            divide()


def test_degenerate_fields():
    """Squares, zero and n = 1, 2, 3, 4, 6 give Q with a rational generator."""
    assert sqrt_field(9).gen() == 3 and sqrt_field(0).gen() == 0 and sqrt_field(fmpq(1, 4)).degree == 1
    assert [cyclotomic_real(n).gen() for n in (1, 2, 3, 4, 6)] == [2, -2, -1, 0, 1]
    assert sqrt_field(0).gen().sign() == 0 and cyclotomic_real(2).gen().sign() == -1


def test_plain_data_and_pickle():
    """Fields and elements survive JSON and pickle."""
    for field, _ in FIELDS:
        assert RealField.from_data(json.loads(json.dumps(field.to_data()))) == field
        x = field([1, 2, "1/3"])
        copy = pickle.loads(pickle.dumps(x))
        assert copy == x and copy.field == field and type(copy.field) is type(field)
    assert isinstance(pickle.loads(pickle.dumps(cyclotomic_real(7))), CyclotomicRealField)
    for data in (None, {}, {"minpoly": [1]}):
        with pytest.raises(BadInput, match="argument 'data'"):
            RealField.from_data(data)


def test_printing():
    """Elements print in the generator's name."""
    assert repr(RealField([-2, 0, 1], (1, 2), "r")([1, 2])) == "2*r + 1"
    assert "RealField" in repr(sqrt_field(2))
