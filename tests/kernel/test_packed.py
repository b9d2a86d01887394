# SPDX-License-Identifier: MIT
"""Packed polynomials and the fractions made of them, against arithmetic on values."""

from __future__ import annotations

import random
from fractions import Fraction
from operator import add as add_
from operator import mul as mul_
from operator import sub, truediv

import pytest

from exactkf.kernel.linear import Matrix
from exactkf.kernel.numbers import Rejected, Undefined, Unknown
from exactkf.kernel.packed import BITS, Divisor, add, content, exponents, mul
from exactkf.kernel.symbolic import SymbolicField
from exactkf.kernel.trials import Trials


def _random(rng, places=3, terms=4, degree=3):
    out = {}
    while not out:
        for _ in range(terms):
            key = sum(rng.randrange(degree + 1) << (BITS * i) for i in range(places))
            out[key] = rng.choice((-3, -2, -1, 1, 2, 5))
    return out


def _at(p, point):
    total = 0
    for key, c in p.items():
        for x, e in zip(point, exponents(key), strict=False):
            c *= x**e
        total += c
    return total


def _value(x, point):
    """A fraction at a point at which no denominator vanishes."""
    below = Fraction(x.q)
    for index, e in x.den:
        below *= _at(x.field.factors[index], point) ** e
    return Fraction(_at(x.num, point)) / below


def test_sum_and_product_have_the_values_of_sum_and_product():
    """Values at a point are ring homomorphisms."""
    rng = random.Random(1)
    for _ in range(60):
        p, q, point = _random(rng), _random(rng), [rng.randrange(-5, 6) for _ in range(3)]
        assert _at(add(p, q, 3, -2), point) == 3 * _at(p, point) - 2 * _at(q, point)
        assert _at(mul(p, q), point) == _at(p, point) * _at(q, point)
        assert all(mul(p, q).values()) and add(p, p, 1, -1) == {}


def test_a_product_divided_by_a_factor_is_the_other():
    """Exact division undoes multiplication, whichever variables the divisor has."""
    rng = random.Random(2)
    for _ in range(150):
        p, q = _random(rng, terms=6), _random(rng, places=rng.choice((1, 2, 3)), terms=rng.choice((1, 2, 3)))
        assert Divisor(q).quotient(mul(p, q)) == p


def test_what_is_no_multiple_has_no_quotient():
    """A product plus a constant is divisible by its factor only if the constant is."""
    rng = random.Random(3)
    for _ in range(150):
        p, q = _random(rng), _random(rng)
        if any(q) and 0 not in (product := mul(p, q)):
            assert Divisor(q).quotient({**product, 0: 1}) is None
    assert Divisor({0: 2}).quotient({0: 3}) is None


def test_exponents_do_not_run_into_each_other():
    """A product with too large an exponent is refused, and so is division by such a polynomial."""
    half = {1 << (BITS - 1): 1}
    with pytest.raises(Unknown, match="degree"):
        mul(half, {1: 1})
    with pytest.raises(Unknown, match="degree"):
        Divisor({**half, 0: 1})
    x, y = {1: 1}, {1 << BITS: 1}
    assert Divisor(x).quotient(y) is None


def test_factors_in_one_variable():
    """x^2 (x^2 - 1) (2x + 3) is split off from its product with x + y."""
    x, y = {1: 1}, {1 << BITS: 1}
    part = mul(mul(mul(x, x), add(mul(x, x), {0: 1}, 1, -1)), add(x, {0: 3}, 2))
    found = content(mul(part, add(x, y)), 0)
    assert found == [x, x, {1: 1, 0: -1}, {1: 1, 0: 1}, {1: 2, 0: 3}]
    assert content(mul(part, add(x, y)), BITS) == []


def test_fractions_have_the_values_of_fractions():
    """A random calculation with symbols, and the same with rational numbers in their place."""
    for seed in range(40):
        rng = random.Random(seed)
        field = SymbolicField()
        symbols = [field.variable(name) for name in "xyz"]
        point = [Fraction(rng.randrange(11, 99), 7) for _ in symbols]
        known = list(zip(symbols, point, strict=True))
        for _ in range(9):
            (a, u), (b, v) = rng.choice(known), rng.choice(known)
            operation = rng.choice((add_, sub, mul_, truediv, lambda x, y: x / (1 - y * y)))
            try:
                new = operation(a, b), operation(u, v)
            except (Undefined, ZeroDivisionError):
                continue
            assert _value(new[0], point) == new[1]
            if len(new[0].num) < 60:
                known.append(new)


def test_inverse_of_a_triangular_matrix():
    """Substitution gives the inverse on both sides; a zero on the diagonal is refused."""
    field = SymbolicField()
    m = Matrix.build(4, 4, lambda i, j: field.variable(f"x{i}{j}") if j >= i else 0)
    for t in (m, m.transpose()):
        assert t * t.inverse() == Matrix.identity(4) and t.inverse() * t == Matrix.identity(4)
    m.rows[2][2] = 0
    with pytest.raises(Undefined, match="singular"):
        m.inverse()


def _quotients(field):
    """A sum of three fractions whose common factor cancels, and its short form."""
    x, y = field.variable("x"), field.variable("y")
    terms = [x * x / (x - y), -2 * x * y / (x - y), y * y / (x - y)]
    return terms[0].plus(terms[1:]), x - y


def test_a_sum_of_many_terms_is_cancelled_once():
    """x^2/(x - y) - 2xy/(x - y) + y^2/(x - y) is stored as x - y."""
    total, short = _quotients(SymbolicField())
    assert (total.num, total.den) == (short.num, ())


def test_told_cancellations_give_the_same_fractions():
    """What one field tells, another need not try."""
    tried = SymbolicField(Trials())
    expected, _ = _quotients(tried)
    told = SymbolicField(Trials(tried.trials.made))
    actual, _ = _quotients(told)
    assert tried.trials.made and (actual.num, actual.den) == (expected.num, expected.den)


def test_a_fraction_that_is_not_cancelled_has_its_value():
    """If a field is told that nothing cancels, fractions are longer and equal."""
    total, short = _quotients(SymbolicField(Trials([])))
    assert total.den and total == short and not total == short + 1


@pytest.mark.parametrize("times", [0, -1, 2, True, "1", 1.0, None])
def test_a_factor_is_not_cancelled_an_impossible_number_of_times(times):
    """Numbers other than one to the power of the factor are rejected, also if they are told."""
    with pytest.raises(Rejected):
        _quotients(_told_first(times))


def _told_first(times):
    """A field that is told a number for the first cancellation that another has found."""
    tried = SymbolicField(Trials())
    _quotients(tried)
    return SymbolicField(Trials([tried.trials.made[0], times]))


def test_entries_of_a_matrix_are_found_when_they_are_needed():
    """A product of a matrix made entry by entry computes no row that is not asked for."""
    asked = []
    lazy = Matrix.lazy(2, 2, lambda i, j: asked.append(i) or 3 * i + j)
    product = lazy * Matrix([[1], [1]])
    assert (product.rows[1][0], asked) == (7, [1, 1])
    assert (lazy * lazy).transpose() == Matrix([[3, 12], [4, 19]])
