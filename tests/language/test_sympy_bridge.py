# SPDX-License-Identifier: MIT
"""Statements go to sympy and come back meaning the same."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from exactkf import BadInput, Unsupported
from exactkf.kernel.meaning import World
from exactkf.language import Expr, T, inv, rank, rational, sum_of, symbols
from exactkf.language.sympy_bridge import from_sympy, to_sympy

x, y, k, A, B = symbols("x y k A B")

terms = st.recursive(
    st.sampled_from([x, y]) | st.integers(-3, 3).map(Expr) | st.just(rational("2/3")),
    lambda inner: st.tuples(st.sampled_from("+-*"), inner, inner).map(lambda t: Expr((t[0], t[1].tree, t[2].tree))),
    max_leaves=8,
)


@given(terms, st.integers(-4, 4), st.integers(-4, 4))
def test_there_and_back_has_the_same_value(term, a, b):
    """A scalar term keeps its value on every instance."""
    world = World({"where": []}, {"x": Fraction(a), "y": Fraction(b)})
    assert world.value(from_sympy(to_sympy(term)).tree) == world.value(term.tree)


@given(terms, st.integers(-4, 4), st.integers(-4, 4))
def test_sympy_gives_the_same_value(term, a, b):
    """sympy evaluates the converted term to what the checker evaluates."""
    value = World({"where": []}, {"x": Fraction(a), "y": Fraction(b)}).value(term.tree)
    assert sympy.sympify(to_sympy(term)).subs({"x": a, "y": b}) == sympy.Rational(Fraction(value).numerator, Fraction(value).denominator)


def test_matrix_expressions_keep_their_order():
    """A B' inv(A) becomes a product of matrix symbols in the same order."""
    shapes = {"A": ("n", "n"), "B": ("n", "n")}
    n = sympy.Symbol("n", integer=True)
    a, b = sympy.MatrixSymbol("A", n, n), sympy.MatrixSymbol("B", n, n)
    assert to_sympy(A * T(B) * inv(A), shapes) == a * b.T * a.inverse()
    assert from_sympy(a * b.T * a.inverse()).tree == (A * T(B) * inv(A)).tree


def test_sums_and_relations():
    """Bounded sums and relations convert."""
    index = sympy.Symbol("k")
    assert to_sympy(sum_of(k, 1, 3, k * x)) == sympy.Sum(index * sympy.Symbol("x"), (index, 1, 3))
    assert from_sympy(sympy.Symbol("x") < 2).tree == (x < 2).tree


def test_floats_are_refused_in_one_line():
    """A float is named with the remedy."""
    with pytest.raises(BadInput, match="float 0.5.*Rational"):
        from_sympy(sympy.Float(0.5) * sympy.Symbol("x"))


def test_what_sympy_cannot_say_is_refused():
    """Operations without counterpart are named."""
    with pytest.raises(Unsupported, match="rank"):
        to_sympy(rank(A))
    with pytest.raises(Unsupported, match="sin"):
        from_sympy(sympy.sin(sympy.Symbol("x")))
