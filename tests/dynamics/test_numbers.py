# SPDX-License-Identifier: MIT
"""The grammar of exact numbers, and several fields in one."""

import math

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from exactkf._errors import BadInput
from exactkf.dynamics.numbers import number, numbers
from exactkf.exact.compositum import compositum, nth_root, together
from exactkf.exact.numberfield import RealField, cyclotomic_real, sqrt_field


def _float(x):
    return float(x.enclose(17).mid()) if hasattr(x, "enclose") else int(x.p) / int(x.q)


@pytest.mark.parametrize("text, value", [
    ("1/2", fmpq(1, 2)), ("0.1", fmpq(1, 10)), ("-3e-2", fmpq(-3, 100)), ("2*3^2", fmpq(18)), ("-2^2", fmpq(-4)), ("2^-1", fmpq(1, 2)),
    ("sqrt(8)/sqrt(2)", fmpq(2)), ("sqrt(9/4)", fmpq(3, 2)), ("cos(pi/3)", fmpq(1, 2)), ("sin(pi/6)", fmpq(1, 2)), ("sec(pi)", fmpq(-1)),
    ("2*cos(pi/5) - (1 + sqrt(5))/2", fmpq(0)), ("root(x^2 - 2, 1, 2)^2", fmpq(2)), ("root(2*x - 3, 0, 2)", fmpq(3, 2)),
    ("sqrt(3 + 2*sqrt(2)) - sqrt(2)", fmpq(1)), ("cos(2*pi/7) + cos(4*pi/7) + cos(6*pi/7)", fmpq(-1, 2)), ("+(1)", fmpq(1)), ("2^(1/2)/sqrt(2)", fmpq(1)),
    ("8^(1/3)", fmpq(2)), ("1 \N{MINUS SIGN} 3", fmpq(-2)), ("(1/8)^(-2/3)", fmpq(4)), ("0^(1/3)", fmpq(0)), ("2^(1/3) - root(x^3 - 2, 1, 2)", fmpq(0)),
    ("(7 + 5*sqrt(2))^(1/3) - sqrt(2)", fmpq(1)), ("7" * 3000 + "/" + "7" * 3000, fmpq(1)),
    ("sqrt(1 + sqrt(2)/10^200)^2*10^200 - 10^200 - sqrt(2)", fmpq(0)),
])
def test_expressions_have_their_values(text, value):
    """Equal expressions are equal numbers."""
    assert number(text) == value


@pytest.mark.parametrize("text, value", [
    ("sqrt(2) + sqrt(3)", math.sqrt(2) + math.sqrt(3)), ("sqrt(2 + sqrt(3))", math.sqrt(2 + math.sqrt(3))),
    ("root(x^3 - 2, 1, 2)*sqrt(2) + cos(2*pi/5)", 2 ** (1 / 3) * math.sqrt(2) + math.cos(2 * math.pi / 5)),
    ("sec(2*pi/9)/cos(pi/7)", 1 / math.cos(2 * math.pi / 9) / math.cos(math.pi / 7)), ("root(x^5 - x - 1, 1, 2)", 1.1673039782614187),
    ("root(x^2 - 2, -2, -1) - sin(3*pi/7)", -math.sqrt(2) - math.sin(3 * math.pi / 7)),
])
def test_irrational_values(text, value):
    """The real root meant is the one taken."""
    assert _float(number(text)) == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize("text, says", [
    ("foo", "no number of the grammar"), ("", "no number of the grammar"), ("(((", "no number of the grammar"), ("1 if 1 else 2", "no number of the grammar"),
    ("__import__('os')", "no number of the grammar"), ("True", "no number of the grammar"),
    ("1j", "no number of the grammar"), ("x", "no number of the grammar"),
    ("root(x^2 - 2, -2, 2)", "holds 2 real roots"), ("root(x^2 + 1, 0, 1)", "holds no real roots"), ("root(x^2 - 2, 2, 1)", "ends exchanged"),
    ("root(x, sqrt(2), 3)", "not rational"), ("root(3, 0, 1)", "positive degree"), ("root(sqrt(2)*x, 0, 1)", "irrational coefficient"),
    ("sqrt(-1)", "square root of a negative"), ("1/0", "divides by zero"), ("1/(sqrt(2)^2 - 2)", "divides by zero"), ("sec(pi/2)", "divides by zero"),
    ("cos(1)", "rational multiple of pi"),
    ("cos(pi^2)", "rational multiple of pi"), ("cos(pi/99999)", "rational multiple of pi"), ("cos(pi, 1)", "2 arguments"),
    ("2^sqrt(2)", "exponent"), ("2^(1/49)", "exponent"), ("2^(1001/2)", "exponent"), ("(-8)^(1/3)", "root of a negative"),
    ("cos(2*pi/61)^(1/7)", "is of degree 210"), ("10^100000", "exponent"), ("((2^1000)^1000)^1000", "too large a power"), ("1+" * 1500, "longer than"),
    ("1" * 200000, "more than 100000"),
    ("1_000", "not a rational number"), ("0x10", "not a rational number"), ("(" * 900 + "1" + ")" * 900, "no number of the grammar"),
])
def test_what_is_no_number_is_named(text, says):
    """One line: the argument, its value and the remedy."""
    with pytest.raises(BadInput, match="argument 'alpha'") as caught:
        number(text, name="alpha")
    assert says in str(caught.value) and "\n" not in str(caught.value)


def test_floats_need_a_rule():
    """A float is refused unless the caller says what it means."""
    with pytest.raises(BadInput, match="is a float"):
        number(0.1)
    assert number(0.1, floats="decimal") == fmpq(1, 10)
    assert number(0.5, floats="exact") == fmpq(1, 2)


def test_sympy_numbers():
    """Sympy's exact numbers are read, its floats by a rule, and not within expressions."""
    sympy = pytest.importorskip("sympy")
    assert number(sympy.Rational(1, 3)) == fmpq(1, 3)
    assert number(1 / sympy.sqrt(2) + sympy.cos(2 * sympy.pi / 7)) == number("1/sqrt(2) + cos(2*pi/7)")
    assert number(sympy.cbrt(2) + sympy.GoldenRatio + sympy.tan(sympy.pi / 7)) == number("2^(1/3) + (1 + sqrt(5))/2 + sin(pi/7)/cos(pi/7)")
    assert number(sympy.cot(sympy.pi / 7) * sympy.csc(sympy.pi / 7)) == number("cos(pi/7)/sin(pi/7)^2")
    assert number(sympy.TribonacciConstant) == number("root(x^3 - x^2 - x - 1, 1, 2)")
    tenth = [number(sympy.Float("0.1", digits), floats=rule) for digits in (15, 40) for rule in ("decimal", 100)]
    assert tenth == [fmpq(1, 10)] * 4 and number(sympy.Float(0.1), floats="exact") == number(0.1, floats="exact")
    for value, says in ((sympy.Float(0.25), "is a float"), (sympy.sqrt(2) * sympy.Float(0.5), "has a sympy float in it"),
                        (sympy.pi, "no number of the grammar"),
                        (sympy.root(-2, 3), "root of a negative"), (sympy.oo, "no number of the grammar"), (sympy.sqrt(-2), "no number of the grammar")):
        with pytest.raises(BadInput, match=says):
            number(value)


def test_roots_of_sympy():
    """Real roots of polynomials are the right ones of several, alone and in expressions; others are refused."""
    sympy = pytest.importorskip("sympy")
    x = sympy.Symbol("x")
    cube, three = sympy.CRootOf(x**3 - 2, 0), [sympy.CRootOf(x**3 - 3 * x + 1, k) for k in range(3)]
    assert number(cube) == number("root(x^3 - 2, 1, 2)")
    assert [number(r) for r in three] == [number(f"2*cos({k}*pi/9)") for k in (8, 4, 2)]
    assert number((1 + cube) ** 2 / 3 - sympy.sqrt(2)) == number("(1 + root(x^3 - 2, 1, 2))^2/3 - sqrt(2)")
    lehmer = [1, 1, 0, -1, -1, -1, -1, -1, 0, 1, 1]
    roots = [sympy.CRootOf(sympy.Poly(lehmer, x), k) for k in range(2)]
    assert [_float(number(r)) for r in roots] == pytest.approx([float(r.evalf(20)) for r in roots], rel=1e-14)
    close = sympy.CRootOf(sympy.Poly((1000 * x**3 - 1) ** 2 - 2 * x**12, x), 1)  # two roots near 1/10
    assert _float(number(close)) == pytest.approx(float(close.evalf(30)), rel=1e-14)
    assert number(sympy.CRootOf((x - 3) * (x**3 - 2), 1)) == 3
    for expression in (sympy.CRootOf(x**3 - 2, 1), 1 + sympy.CRootOf(x**5 - x - 1, 4)):
        with pytest.raises(BadInput, match="argument 'alpha' is not a real number") as caught:
            number(expression, name="alpha")
        assert "\n" not in str(caught.value)


def test_several_numbers_share_one_field():
    """All come out in one field, rationals as rationals where nothing else is there."""
    found, field = numbers(["sqrt(2)", "1/3", "sqrt(3)", "cos(2*pi/5)"])
    assert field.degree == 8 and all(x.field is field for x in found)
    assert [_float(x) for x in found] == pytest.approx([math.sqrt(2), 1 / 3, math.sqrt(3), math.cos(2 * math.pi / 5)])
    assert numbers(["1/2", "sqrt(4)"]) == ((fmpq(1, 2), fmpq(2)), None)
    with pytest.raises(BadInput, match=r"alpha\[1\]"):
        numbers(["1", "oops"], name="alpha")


def test_cyclotomic_fields_meet_in_the_common_one():
    """Q(2cos(2pi/5)) and Q(2cos(2pi/7)) lie in the field of 35."""
    (x, y), field = together([cyclotomic_real(5).two_cos(1), cyclotomic_real(7).two_cos(2)])
    assert field == cyclotomic_real(35) and field.degree == 12
    assert _float(x * y) == pytest.approx(4 * math.cos(2 * math.pi / 5) * math.cos(4 * math.pi / 7))


@given(st.sampled_from([2, 3, 5, 6, 8, 12]), st.sampled_from([2, 3, 5, 7]), st.integers(1, 4))
def test_compositum_embeds_both(d, e, k):
    """Both generators keep their polynomial, their place and their sign."""
    first, second = sqrt_field(d), RealField([-e, 0, 0, 1], (0, e))
    field, x, y = compositum(first, second)
    assert field.degree == 6
    assert x * x == d and y**3 == e and x.sign() == y.sign() == 1
    assert _float(x + k * y) == pytest.approx(math.sqrt(d) + k * e ** (1 / 3))


def test_compositum_of_fields_that_meet():
    """Fields with a common part give a field of the right degree."""
    field, x, y = compositum(cyclotomic_real(16), sqrt_field(2))
    assert field.degree == 4 and y == x * x - 2


@given(st.integers(1, 40), st.integers(1, 6))
def test_square_root_squares_back(p, q):
    """sqrt(x)^2 = x for x = p/q + sqrt(2)."""
    x = sqrt_field(2).gen() + fmpq(p, q)
    root = nth_root(x)
    assert root**2 == x and root.sign() == 1


def test_numbers_with_conjugates_near_by_are_told_apart():
    """Two roots that agree in 200 digits: enclosed to few digits and to many, and compared."""
    x, y = (number(f"sqrt(1 {sign} sqrt(2)/10^200)") for sign in "+-")
    assert x.field.minpoly == y.field.minpoly and [float(v.enclose(3).mid()) for v in (x, y)] == [1.0, 1.0]
    assert numbers([x, y])[0][0] > 1 > numbers([x, y])[0][1]


def test_too_large_a_field_is_refused():
    """The degree of a common field is bounded."""
    with pytest.raises(BadInput, match="number field"):
        numbers(["root(x^13 - 2, 1, 2)", "root(x^11 - 3, 1, 2)"])
