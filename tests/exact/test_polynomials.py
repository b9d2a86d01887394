# SPDX-License-Identifier: MIT
"""Tests of exactkf.exact.polynomials and exactkf.exact.circle."""

import pickle

import mpmath
import pytest
from flint import fmpq, fmpq_mat, fmpq_poly, fmpz_poly
from hypothesis import given, settings
from hypothesis import strategies as st

from exactkf._errors import BadInput
from exactkf.dynamics.zeros import circle_points
from exactkf.exact.circle import PseudoPolynomial, sign_on_circle
from exactkf.exact.matrices import inertia, zero
from exactkf.exact.polynomials import (
    SturmSequence,
    count_real_roots,
    count_roots,
    gcd,
    is_schur,
    isolate_real_roots,
    palindromic_to_x,
    polynomial,
    refine_root,
    reversal,
    schur_cohn_matrix,
    squarefree,
)

few = settings(max_examples=35, deadline=None)
one = fmpq_poly([1])


def place(square, n):
    """Return the numbers of roots inside, on and outside for n roots of the given squared modulus."""
    return n * (square < 1), n * (square == 1), n * (square > 1)


# Factors with known roots: (polynomial, inside, on, outside).
REAL = [
    (fmpq_poly([-fmpq(a, b), 1]), *place(fmpq(a * a, b * b), 1))
    for a, b in [(0, 1), (1, 2), (-1, 2), (2, 1), (-2, 1), (1, 1), (-1, 1), (3, 5), (5, 3), (99, 100), (101, 100)]
]
# z^2 - 2 a z + a^2 + b^2 has the roots a +- bi.
PAIRS = [
    (fmpq_poly([a * a + b * b, -2 * a, 1]), *place(a * a + b * b, 2))
    for a, b in [
        (fmpq(3, 5), fmpq(4, 5)),
        (fmpq(-5, 13), fmpq(12, 13)),
        (fmpq(0), fmpq(1)),
        (fmpq(0), fmpq(1, 2)),
        (fmpq(0), fmpq(2)),
        (fmpq(1, 2), fmpq(1, 3)),
        (fmpq(1), fmpq(1)),
        (fmpq(1, 2), fmpq(1, 2)),
    ]
]
CYCLOTOMIC = [(fmpq_poly(fmpz_poly.cyclotomic(n)), 0, fmpz_poly.cyclotomic(n).degree(), 0) for n in range(1, 13)]
factor_lists = st.lists(st.tuples(st.sampled_from(REAL + PAIRS + CYCLOTOMIC), st.integers(1, 3)), max_size=4)
coefficients = st.lists(st.fractions(-5, 5, max_denominator=4), max_size=6)
roots = st.lists(
    st.tuples(st.fractions(-4, 4, max_denominator=6), st.integers(1, 3)), max_size=5, unique_by=lambda r: r[0]
)


def product(factors):
    """Return the product of powers."""
    p = one
    for f, m in factors:
        p *= f**m
    return p


def q(x):
    """Return a Fraction as fmpq."""
    return fmpq(x.numerator, x.denominator)


@settings(max_examples=80, deadline=None)
@given(factor_lists, st.sampled_from([1, -3, fmpq(2, 7)]))
def test_root_count_of_known_factors(factors, scale):
    """Roots inside, on and outside the circle are counted with multiplicity."""
    p = product([(f[0], m) for f, m in factors]) * scale
    expected = tuple(sum(f[k] * m for f, m in factors) for k in (1, 2, 3))
    assert tuple(count_roots(p)) == expected
    assert is_schur(p) == (expected[1] == expected[2] == 0)
    at_zero = next(k for k, c in enumerate(p.coeffs()) if c != 0)
    assert tuple(count_roots(reversal(p))) == (expected[2], expected[1], expected[0] - at_zero)


@few
@given(coefficients.map(polynomial).filter(lambda p: p != 0))
def test_root_count_agrees_with_numerical_roots(p):
    """Where the numerical roots keep away from the circle, the counts agree."""
    if p.degree() == 0:
        assert tuple(count_roots(p)) == (0, 0, 0)
        return
    found = [(abs(complex(c.real.mid(), c.imag.mid())), m) for c, m in p.complex_roots()]
    if all(abs(r - 1) > 1e-6 for r, _ in found):
        assert tuple(count_roots(p)) == (sum(m for r, m in found if r < 1), 0, sum(m for r, m in found if r > 1))


@few
@given(st.lists(st.sampled_from(REAL[:5] + PAIRS[3:7]), min_size=1, max_size=4))
def test_schur_cohn_inertia(factors):
    """Without common factor with the reversal, the inertia of the matrix counts the roots."""
    p = product([(f[0], 1) for f in factors if f[0][0] != 0])
    if p.gcd(reversal(p)) == 1 and p.degree() > 0:
        found = inertia(schur_cohn_matrix(p))
        assert (found.positive, found.negative, found.zero) == (count_roots(p).inside, count_roots(p).outside, 0)


def test_root_count_degenerate():
    """Powers of z, constants, reciprocal pairs and the zero polynomial."""
    assert tuple(count_roots([5])) == (0, 0, 0) and tuple(count_roots([0, 0, 3])) == (2, 0, 0)
    assert tuple(count_roots(fmpq_poly([2, -5, 2]) ** 3)) == (3, 0, 3)
    assert tuple(count_roots(fmpq_poly([-1, 1]) ** 3 * fmpq_poly([1, 1]) ** 2)) == (0, 5, 0)
    assert tuple(count_roots(fmpq_poly([-2, 1]) ** 3 * fmpq_poly([-1, 2]))) == (1, 0, 3)
    assert tuple(count_roots([1] + [0] * 29 + [1])) == (0, 30, 0)
    assert tuple(count_roots([1, 3, 1])) == (1, 0, 1)
    assert is_schur([7]) and is_schur([0, 1]) and not is_schur([-1, 1])
    for call in (
        count_roots,
        is_schur,
        squarefree,
        count_real_roots,
        isolate_real_roots,
        schur_cohn_matrix,
        SturmSequence,
    ):
        with pytest.raises(BadInput, match="zero polynomial"):
            call([0, 0])


def test_lehmers_polynomial():
    """Lehmer's polynomial has one root outside, one inside and eight on the circle."""
    assert tuple(count_roots([1, 1, 0, -1, -1, -1, -1, -1, 0, 1, 1])) == (1, 8, 1)


@few
@given(coefficients, st.integers(0, 3))
def test_reversal(coeffs, extra):
    """Reversing twice in one degree gives the polynomial back."""
    p = polynomial(coeffs)
    n = max(p.degree(), 0) + extra
    assert reversal(reversal(p, n), n) == p
    assert reversal(p, n)(fmpq(1, 3)) == p(fmpq(3)) / fmpq(3) ** n
    if p.degree() > 0:
        with pytest.raises(BadInput, match="argument 'n'"):
            reversal(p, p.degree() - 1)


@few
@given(factor_lists)
def test_squarefree_multiplies_back(factors):
    """The factors are square-free and coprime, and their powers give p up to a constant."""
    p = product([(f[0], m) for f, m in factors])
    parts = squarefree(p)
    assert product(parts) * (p.leading_coefficient() / product(parts).leading_coefficient()) == p
    for i, (f, _) in enumerate(parts):
        assert gcd(f, f.derivative()) == 1 and all(gcd(f, g) == 1 for g, _ in parts[:i])


@few
@given(roots, st.fractions(-4, 4, max_denominator=6), st.fractions(0, 5, max_denominator=6))
def test_real_root_count_of_known_roots(known, lo, length):
    """Distinct roots in a closed interval are counted, ends included, complex pairs ignored."""
    p = product([(fmpq_poly([-q(r), 1]), m) for r, m in known]) * fmpq_poly([1, 0, 1]) ** 2 * -2
    hi = lo + length
    assert count_real_roots(p, lo, hi) == sum(lo <= r <= hi for r, _ in known)
    assert count_real_roots(p) == len(known)
    assert count_real_roots(p, lo) == sum(lo <= r for r, _ in known)
    assert count_real_roots(p, None, hi) == sum(r <= hi for r, _ in known)


@few
@given(st.dictionaries(st.integers(0, 8), st.integers(-5, 5).filter(bool), min_size=2, max_size=4))
def test_real_root_count_of_sparse_polynomials(terms):
    """Sturm sequences with gaps in degree count as many real roots as certified complex root isolation."""
    p = fmpz_poly([terms.get(k, 0) for k in range(9)])
    assert count_real_roots(p) == sum(c.imag.is_zero() for c, _ in p.complex_roots())


@pytest.mark.parametrize("a, b, n", [(4, 1, 2), (-4, 1, 2), (1, 1, 0), (4, -1, 2), (4, 3, 1)])
def test_real_root_count_across_a_gap(a, b, n):
    """The sequence of x**4 + a x + b, whose degrees are 4, 3, 1, 0, keeps its signs."""
    assert count_real_roots([b, a, 0, 0, 1]) == n


def test_real_root_count_refuses_an_empty_interval():
    """The ends must be in order."""
    with pytest.raises(BadInput, match="argument 'lo'"):
        count_real_roots([0, 1], 1, 0)
    assert count_real_roots([0, 1], 0, 0) == 1 and count_real_roots([3]) == 0


@few
@given(roots, st.lists(st.tuples(st.integers(2, 7), st.integers(1, 2)), max_size=3, unique_by=lambda r: r[0]))
def test_isolation_of_known_roots(known, squares):
    """Every root is in one interval, with its multiplicity and its minimal polynomial; rational roots are points."""
    p = product([(fmpq_poly([-q(r), 1]), m) for r, m in known])
    for d, m in squares:
        p *= fmpq_poly([-d, 0, 1]) ** m
    exact = [(mpmath.mpf(r.numerator) / r.denominator, m) for r, m in known]
    for d, m in squares:
        s = mpmath.sqrt(d)
        if s == int(s):  # rational: add its multiplicity to a root that may be there
            for t in (s, -s):
                old = sum(k for r, k in exact if r == t)
                exact = [(r, k) for r, k in exact if r != t] + [(t, m + old)]
        else:
            exact += [(s, m), (-s, m)]
    exact.sort()
    found = isolate_real_roots(p)
    assert [r.multiplicity for r in found] == [m for _, m in exact]
    for root, (x, _) in zip(found, exact, strict=True):
        fine = refine_root(root, fmpq(1, 10**9))
        assert abs(mpmath.mpf(int(fine.lo.p)) / int(fine.lo.q) - x) < 1e-8 and fine.hi - fine.lo <= fmpq(1, 10**9)
        assert (root.lo == root.hi) == (root.factor.degree() == 1)
        assert root.lo == root.hi or root.factor(root.lo) * root.factor(root.hi) < 0
    assert all(a.hi < b.lo for a, b in zip(found, found[1:], strict=False))


def test_isolation_of_close_roots_and_widths():
    """Mignotte's polynomial has two roots very close together; a width is kept."""
    p = fmpq_poly([-1, 50]) ** 2 * -2 + fmpq_poly([0] * 9 + [1])
    assert len(isolate_real_roots(p)) == count_real_roots(p) == 3
    assert all(r.hi - r.lo <= fmpq(1, 1000) for r in isolate_real_roots([-2, 0, 1], fmpq(1, 1000)))
    near = fmpq_poly([-2, 0, 1]) * fmpq_poly([-fmpq(141421356, 10**8), 1])
    (_, a, b) = isolate_real_roots(near)
    assert (a.lo == a.hi) and b.lo != b.hi and a.hi < b.lo
    for call in (lambda: isolate_real_roots([0, 1], 0), lambda: refine_root(isolate_real_roots([0, 1])[0], -1)):
        with pytest.raises(BadInput, match="argument 'width'"):
            call()


def test_constructor():
    """Lists, fmpz_poly and fmpq_poly are polynomials, other things are refused."""
    assert polynomial(["1/2", 1]) == fmpq_poly([fmpq(1, 2), 1]) == polynomial(polynomial([fmpq(1, 2), 1]))
    assert polynomial(fmpz_poly([1, 2])) == polynomial((1, 2)) and polynomial([0.5], floats="exact")[0] == fmpq(1, 2)
    for value in ("12", 5, None, [0.5], [None]):
        with pytest.raises(BadInput, match="argument 'w"):
            polynomial(value, name="w")


@few
@given(coefficients, st.fractions(1, 4, max_denominator=5))
def test_clenshaw_agrees_with_evaluation(d, z):
    """D(z) summed by powers is h(z + 1/z), and z**n D(z) is palindromic."""
    d = [q(c) for c in d]
    D, z = PseudoPolynomial(d), q(z)
    by_powers = sum((c * (z**k + z**-k if k else 1) for k, c in enumerate(d)), fmpq(0))
    assert D(z) == D.in_x()(z + 1 / z) == by_powers
    assert palindromic_to_x(D.shifted()) == D.in_x() or D.d == 0
    assert D(1 / z) == D(z) and D[1] == D[-1]


@few
@given(coefficients, coefficients, st.fractions(1, 4, max_denominator=5))
def test_pseudo_polynomial_arithmetic(c, d, z):
    """Values add and multiply, products of polynomials symmetrise, pickling keeps the value."""
    C, D, z = PseudoPolynomial(c), PseudoPolynomial(d), q(z)
    assert (C + D)(z) == C(z) + D(z) and (C * D)(z) == C(z) * D(z) and (C - D)(z) == C(z) - D(z)
    assert (2 * C - 1)(z) == 2 * C(z) - 1 and (1 - C)(z) == 1 - C(z)
    p, r = C.d, D.d
    assert PseudoPolynomial.symmetrized(p, r)(z) == (p(z) * r(1 / z) + p(1 / z) * r(z)) / 2
    assert PseudoPolynomial.modulus_squared(p)(z) == p(z) * p(1 / z)
    assert pickle.loads(pickle.dumps(C)) == C and hash(pickle.loads(pickle.dumps(C))) == hash(C)


def test_pseudo_polynomial_refusals():
    """Zero is no argument, and odd or not palindromic polynomials are refused."""
    with pytest.raises(BadInput):
        PseudoPolynomial([1])(0)
    for p in ([1, 1], [1, 2], [1, 0, 2]):
        with pytest.raises(BadInput, match="palindromic"):
            palindromic_to_x(p)
    assert PseudoPolynomial([1]) != 1 and repr(PseudoPolynomial([1, "1/2"])) == "PseudoPolynomial([1, 1/2])"


x_factors = st.lists(
    st.tuples(
        st.sampled_from(
            [
                (fmpq_poly([0, 1]), "in"),
                (fmpq_poly([-1, 1]), "in"),
                (fmpq_poly([-2, 0, 1]), "in"),
                (fmpq_poly([-2, 1]), "end"),
                (fmpq_poly([2, 1]), "end"),
                (fmpq_poly([-3, 1]), "out"),
                (fmpq_poly([5, 2]), "out"),
                (fmpq_poly([1, 0, 1]), "out"),
                (fmpq_poly([-5, 0, 1]), "out"),
                (fmpq_poly([-fmpq(1999, 1000), 1]), "in"),
            ]
        ),
        st.integers(1, 4),
    ),
    max_size=4,
    unique_by=lambda f: str(f[0][0]),
)


@settings(max_examples=70, deadline=None)
@given(x_factors, st.sampled_from([1, -2]))
def test_sign_of_known_factors(factors, scale):
    """The sign on the circle and the zeros with multiplicity follow from known zeros in x."""
    h = product([(f[0], m) for f, m in factors]) * scale
    D = PseudoPolynomial([0])
    for k, c in enumerate(h.coeffs()):
        D = D + power_of_x(k) * c
    assert D.in_x() == h
    odd = any(f[1] == "in" and m % 2 for f, m in factors)
    touches = any(f[1] != "out" for f, _ in factors)
    inner = h(fmpq(1234567, 10**7))
    words = ("nonnegative", "positive") if inner > 0 else ("nonpositive", "negative")
    expected = "indefinite" if odd else words[not touches]
    assert (
        sign_on_circle(D) == expected
        and sign_on_circle(-D)
        == {
            "indefinite": "indefinite",
            "positive": "negative",
            "negative": "positive",
            "nonnegative": "nonpositive",
            "nonpositive": "nonnegative",
        }[expected]
    )
    zeros = circle_points(D.shifted().coeffs())
    degrees = {"in": 2, "end": 2, "out": 0}
    on = sum(degrees[f[1]] * (f[0].degree() if f[1] == "in" else 1) * m for f, m in factors)
    assert sum(z.multiplicity * (1 if z.two_cos in ("2", "-2") else 2) for z in zeros) == on
    assert count_roots(D.shifted()).on == on


def power_of_x(k):
    """Return (z + 1/z)**k."""
    result = PseudoPolynomial([1])
    for _ in range(k):
        result = result * PseudoPolynomial([0, 1])
    return result


@few
@given(coefficients)
def test_modulus_squared_is_never_negative(coeffs):
    """|p|**2 is positive unless p has a root on the circle, and vanishes to twice its order."""
    p = fmpq_poly([q(c) for c in coeffs])
    D = PseudoPolynomial.modulus_squared(p)
    if p == 0:
        assert sign_on_circle(D) == "zero"
        return
    on = count_roots(p).on
    assert sign_on_circle(D) == ("nonnegative" if on else "positive")
    assert sign_on_circle(D - D[0] - 2 * sum(abs(D[k]) for k in range(1, 9))) in ("negative", "nonpositive", "zero")


def test_sign_degenerate():
    """Zero and constants, a zero at z = 1 of order 2, and the zero list of zero."""
    assert sign_on_circle([0, 0]) == sign_on_circle([]) == "zero"
    assert sign_on_circle([3]) == "positive" and sign_on_circle([-3]) == "negative"
    assert sign_on_circle([2, -1]) == "nonnegative" and sign_on_circle([0, 1]) == "indefinite"
    assert circle_points([fmpq(-1), fmpq(2), fmpq(-1)]) == [("2", 2)]


def test_toeplitz_oracle():
    """A pseudo-polynomial that is positive has positive definite Toeplitz matrices."""
    d = [3, -1, fmpq(1, 2)]
    assert sign_on_circle(d) == "positive"
    toeplitz = fmpq_mat(6, 6, [d[abs(i - j)] if abs(i - j) < 3 else 0 for i in range(6) for j in range(6)])
    assert inertia(toeplitz).positive == 6 and inertia(zero(2)).zero == 2
