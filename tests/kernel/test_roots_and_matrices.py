# SPDX-License-Identifier: MIT
"""Root counts and linear algebra of the checker against objects built from known roots and factors."""

from __future__ import annotations

import random
from fractions import Fraction
from functools import reduce

import pytest
import sympy
from flint import fmpq, fmpq_poly
from hypothesis import given, settings
from hypothesis import strategies as st

from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.linear import Matrix, char_coefficients, echelon, inertia, null_basis, similar
from exactkf.kernel.numbers import Laurent, Ratio, Undefined
from exactkf.kernel.roots import circle_sign, count_circle, count_real
from exactkf.kernel.symbolic import SymbolicField

small = st.fractions(min_value=-3, max_value=3, max_denominator=4)


def times(p, q):
    out = [Fraction(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] += a * b
    return out


#: factors with known location: (coefficients, inside, on, outside)
located = st.one_of(
    small.map(lambda r: ([-r, Fraction(1)], int(abs(r) < 1), int(abs(r) == 1), int(abs(r) > 1))),
    st.fractions(-1, 1, max_denominator=5).map(lambda c: ([Fraction(1), 2 * c, Fraction(1)], 0, 2, 0)),  # on the circle
    st.tuples(small, st.fractions(0, 3, max_denominator=3)).filter(lambda p: p[1]).map(  # a +- bi
        lambda p: ([p[0] ** 2 + p[1] ** 2, -2 * p[0], Fraction(1)], *(2 * int(t) for t in _side(p[0] ** 2 + p[1] ** 2)))),
)


def _side(norm):
    return norm < 1, norm == 1, norm > 1


@given(st.lists(located, min_size=1, max_size=5), st.integers(1, 2))
def test_roots_are_counted_with_multiplicity(factors, power):
    """A product of located factors has the sum of their counts, repeated roots and reciprocal pairs included."""
    p = reduce(times, [f[0] for f in factors] * power)
    expected = tuple(power * sum(f[k] for f in factors) for k in (1, 2, 3))
    assert count_circle(p) == expected


def test_zero_polynomial_has_no_roots_to_count():
    """The zero polynomial is refused."""
    with pytest.raises(Undefined):
        count_circle([0, 0])


@given(st.lists(small, min_size=1, max_size=5), small, small)
def test_distinct_real_roots_in_an_interval(roots, a, b):
    """Sturm counts distinct roots in (lo, hi], those at the ends as stated."""
    lo, hi = min(a, b), max(a, b)
    p = reduce(times, [[-r, Fraction(1)] for r in roots])
    assert count_real(p, lo, hi) == len({r for r in roots if lo < r <= hi})


@given(st.lists(st.fractions(-4, 4, max_denominator=3), min_size=1, max_size=4), st.fractions(-2, 2).filter(bool))
def test_sign_on_the_circle(xs, c):
    """c * prod (z + 1/z - x) on the circle, against sampling of the factors in [-2, 2]."""
    d = Laurent({0: c})
    for x in xs:
        d = d * Laurent({1: 1, 0: -x, -1: 1})
    points = sorted({Fraction(-2), Fraction(2), *(x for x in xs if -2 <= x <= 2)})
    probes = points + [(a + b) / 2 for a, b in zip(points, points[1:], strict=False)]
    values = [c * reduce(lambda u, v: u * v, [t - x for x in xs]) for t in probes]
    low, high = min(values), max(values)
    expected = "+-" if low < 0 < high else "+" if low > 0 else "-" if high < 0 else "0+" if high > 0 else "-0"
    assert circle_sign(d) == expected


def test_sign_of_an_unsymmetric_polynomial_is_refused():
    """z alone is not real on the circle."""
    with pytest.raises(Undefined):
        circle_sign(Laurent({1: 1}))


matrices = st.integers(1, 4).flatmap(lambda n: st.lists(st.lists(st.integers(-3, 3), min_size=n, max_size=n), min_size=n, max_size=n))


@given(matrices)
def test_determinant_inverse_and_characteristic_polynomial(rows):
    """Against sympy's matrices."""
    m, s = Matrix(rows), sympy.Matrix(rows)
    assert m.determinant() == s.det()
    assert char_coefficients(m)[::-1] == s.charpoly().all_coeffs()
    if s.det():
        assert m * m.inverse() == Matrix.identity(m.nrows)
    assert len(echelon(m)[1]) == s.rank()
    null = null_basis(m)
    assert null.ncols == m.ncols - s.rank() and all(x == 0 for r in (m * null).rows for x in r)


@given(matrices, st.data())
def test_inertia_by_congruence(rows, data):
    """L D L' has the signs of D, for any invertible L; zero diagonals included."""
    n = len(rows)
    d = data.draw(st.lists(st.integers(-1, 1), min_size=n, max_size=n))
    lower = Matrix.build(n, n, lambda i, j: 1 if i == j else rows[i][j] if i > j else 0)
    order = data.draw(st.permutations(range(n)))
    shuffle = Matrix.build(n, n, lambda i, j: int(order[i] == j))
    left = shuffle * lower
    m = left * Matrix.build(n, n, lambda i, j: d[i] if i == j else 0) * left.transpose()
    assert inertia(m) == (d.count(1), d.count(-1), d.count(0))


def test_inertia_of_a_hyperbolic_plane():
    """[[0, 1], [1, 0]] has one eigenvalue of each sign."""
    assert inertia(Matrix([[0, 1], [1, 0]])) == (1, 1, 0)


@given(matrices, matrices)
def test_similar_means_same_jordan_form(rows, other):
    """A matrix is similar to its conjugates, and not to one with another Jordan form."""
    m = Matrix(rows)
    n = m.nrows
    change = Matrix.build(n, n, lambda i, j: 1 if i == j else rows[i][j] if i > j else 0)
    assert similar(m, change * m * change.inverse())
    if n > 1:
        assert not similar(Matrix.identity(n), Matrix.build(n, n, lambda i, j: int(i == j or (i, j) == (0, 1))))


@settings(max_examples=20)
@given(st.lists(st.integers(-2, 2), min_size=6, max_size=6), st.integers(-3, 3), st.integers(1, 3))
def test_symbolic_arithmetic_agrees_with_sympy(c, a, b):
    """(sums, products, quotients) of two symbols against sympy's cancel, and against evaluation."""
    field = SymbolicField()
    x, y = field.variable("x"), field.variable("y")
    sx, sy = sympy.symbols("x y")

    def build(u, v):
        p = c[0] * u * u + c[1] * v + c[2] + 7
        q = c[3] * u + c[4] * v * v + c[5] + 11
        return (p / q + u / (v + 5)) * (q - v) - p / (q * q)

    symbolic, reference = build(x, y), build(sx, sy)
    num = sympy.Poly(sum(k * sx ** (e & 4095) * sy ** (e >> 12) for e, k in symbolic.num.items()), sx, sy)
    den = sympy.Integer(symbolic.q)
    for index, e in symbolic.den:
        den *= sum(k * sx ** (m & 4095) * sy ** (m >> 12) for m, k in field.factors[index].items()) ** e
    assert sympy.cancel(num.as_expr() / den - reference) == 0
    assert symbolic - symbolic == 0 and (symbolic == symbolic + 1) is False


def test_algebraic_numbers():
    """The golden ratio and its conjugate are told apart by their intervals."""
    modulus = [Fraction(-1), Fraction(-1), Fraction(1)]
    g = AlgebraicField(modulus, Fraction(1), Fraction(2)).element([Fraction(0), Fraction(1)])
    h = AlgebraicField(modulus, Fraction(-1), Fraction(0)).element([Fraction(0), Fraction(1)])
    assert g * g == g + 1 and g > 1 and 1 / g == g - 1
    assert h * h == h + 1 and h < 0 and 1 / h == h - 1


def test_algebraic_number_with_a_reducible_polynomial():
    """theta = sqrt 2 given by (x^2 - 2)(x^2 - 3): theta^2 - 2 is zero and not invertible."""
    modulus = [Fraction(c) for c in (6, 0, -5, 0, 1)]
    theta = AlgebraicField(modulus, Fraction(14, 10), Fraction(15, 10)).element([Fraction(0), Fraction(1)])
    assert theta * theta - 2 == 0
    with pytest.raises(Undefined):
        1 / (theta * theta - 2)
    assert 1 / (theta * theta - 3) == -1


@given(st.lists(small, min_size=1, max_size=3), st.lists(small, min_size=1, max_size=3), st.integers(0, 4))
def test_expansion_at_infinity(num, den, k):
    """The coefficients of the expansion reproduce the numerator."""
    den = [*den, Fraction(1)]
    f = Ratio(Laurent(dict(enumerate(num))), Laurent(dict(enumerate(den))))
    series = {-j: f.at_infinity(j) for j in range(-4, k + 8)}
    product = Laurent(series) * Laurent(dict(enumerate(den)))
    assert all(product.get(j) == Laurent(dict(enumerate(num))).get(j) for j in range(-k, 4))


def test_sturm_chains_in_integers_count_as_flint_does():
    """Random rational polynomials with repeated and rational roots, some at the ends: distinct roots in (lo, hi]."""
    rng = random.Random(9)
    for _ in range(300):
        p = fmpq_poly([1])
        for _ in range(rng.randint(1, 4)):
            factor = [fmpq(rng.randint(-4, 4), rng.randint(1, 3)) for _ in range(rng.randint(1, 3))] + [fmpq(rng.choice((-2, 1, 3)), 2)]
            p *= fmpq_poly(factor) ** rng.choice((1, 1, 2, 3))
        lo, hi = sorted(rng.sample([Fraction(k, 2) for k in range(-8, 9)], 2))
        count = 0
        for f, _ in p.numer().factor()[1]:
            if f.degree() == 1:
                count += lo < Fraction(-int(f[0]), int(f[1])) <= hi
            else:
                count += sum(z.imag == 0 and fmpq(lo.numerator, lo.denominator) < z.real < fmpq(hi.numerator, hi.denominator) for z, _ in f.complex_roots())
        assert count_real([Fraction(int(c.p), int(c.q)) for c in p.coeffs()], lo, hi) == count
