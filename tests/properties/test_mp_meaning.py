# SPDX-License-Identifier: MIT
"""The second evaluator: each operation decides a true and a false case, and agrees with the first one."""

from __future__ import annotations

import pytest

from exactkf.kernel.instances import admissible, read_instance
from exactkf.kernel.meaning import World
from exactkf.language import (
    Identity,
    Statement,
    T,
    Z,
    Zero,
    always,
    block,
    charpoly,
    circle_roots,
    coeff,
    coprime,
    cospectral,
    cospi,
    defined,
    degree,
    det,
    detectable,
    diag,
    exists,
    forall,
    inside_roots,
    inv,
    invertible,
    kernel_basis,
    laurent,
    loewner,
    matrix,
    nonneg_on_circle,
    observable,
    outside_roots,
    pd,
    pos_on_circle,
    prints,
    prod,
    psd,
    rank,
    rational,
    real_roots,
    rec,
    recip,
    rev,
    rows,
    scalar,
    schur,
    similar,
    sqrt,
    stein,
    substitute,
    sum_of,
    symbols,
    symmetric,
    symplectic,
    trace,
    vstack,
    when,
)
from tests.properties.mp_meaning import admissible as admissible_again
from tests.properties.mp_meaning import evaluate

k, t, x, f, A = symbols("k t x f A")
SHEAR, ROTATION, ONES = rows([[1, 1], [0, 1]]), rows([[0, -1], [1, 0]]), rows([[1, 1], [1, 1]])
HALF = rational("1/2")

TRUE = {
    "sum": sum_of(k, 1, 4, k**2) == 30,
    "product": prod(k, 1, 4, k) == 24,
    "for all": forall(k, 1, 3, k * k >= k),
    "exists": exists(k, 1, 3, k * k == 9),
    "cases": when(HALF > 0, 1, 2) == 1,
    "determinant": det(rows([[1, 2], [3, 4]])) == -2,
    "singular": ~invertible(ONES),
    "inverse": SHEAR * inv(SHEAR) == Identity(2),
    "rank": rank(vstack(ONES, ONES)) == 1,
    "trace": trace(SHEAR) == 2,
    "null space": ONES * kernel_basis(ONES) == Zero(2, 1),
    "semidefinite": psd(ONES) & ~pd(ONES),
    "definite": pd(ONES + Identity(2)),
    "order": loewner(2 * Identity(2), ONES),
    "symmetric": symmetric(ONES) & ~symmetric(SHEAR),
    "symplectic": symplectic(SHEAR) & ~symplectic(diag(1, 2)),
    "similar": similar(SHEAR, T(SHEAR)) & ~similar(SHEAR, Identity(2)),
    "cospectral": cospectral(SHEAR, Identity(2)),
    "characteristic polynomial": charpoly(ROTATION) == Z**2 + 1,
    "blocks": det(block([[SHEAR, Zero(2, 1)], [Zero(1, 2), Identity(1)]])) == 1,
    "coefficient": coeff((Z + 1) ** 3, 1) == 3,
    "degree": degree((Z + 1) ** 3 - Z**3) == 2,
    "reversal": rev(Z**2 + 2 * Z + 3, 2) == 3 * Z**2 + 2 * Z + 1,
    "reciprocal": recip(Z + 1) * Z == 1 + Z,
    "substitution": substitute(Z**2 + 1, ROTATION) == Zero(2, 2),
    "expansion": laurent(1 / (Z - 2), 3) == 4,
    "quotients": (Z**2 - 1) / (Z + 1) == Z - 1,
    "roots in": inside_roots((2 * Z - 1) ** 2 * (Z - 3)) == 2,
    "roots on": circle_roots((Z**2 + 1) * (Z - 1) ** 2) == 4,
    "roots out": outside_roots((Z - 3) * Z) == 1,
    "real roots": real_roots(Z**2 * (Z - 1) * (Z**2 + 1), -1, 1) == 2,
    "open end": real_roots(Z * (Z - 1), 0, 1) == 1,
    "Schur": schur(Z - HALF) & ~schur(Z - 1) & schur(HALF * SHEAR),
    "observable": observable(rows([[1, 0]]), SHEAR) & ~observable(rows([[0, 1]]), SHEAR) & observable(rows([[0, 1]]), ROTATION),
    "not observable": ~observable(rows([[0, 0, 1]]), diag(ROTATION, 1)) & ~observable(Zero(0, 2), ROTATION),
    "detectable": detectable(vstack(Identity(2), ROTATION), vstack(HALF * SHEAR, ROTATION))
                  & detectable(vstack(Identity(2), SHEAR), vstack(2 * Identity(2), Identity(2)))
                  & ~detectable(Identity(2), ROTATION) & ~detectable(ONES, Zero(2, 2)) & detectable(diag(1, 1), diag(HALF, HALF))
                  & ~detectable(vstack(diag(1, 1), ONES), vstack(diag(2, HALF), 2 * ONES))
                  & detectable(Zero(2, 0), Zero(2, 0)) & ~detectable(Zero(0, 2), Zero(0, 2)),
    "solution": (stein(HALF * SHEAR, ONES) - HALF * SHEAR * stein(HALF * SHEAR, ONES) * T(HALF * SHEAR) == ONES) & (stein(2 * Identity(1), 3) == -1),
    "coprime": coprime(Z - 1, Z + 1) & ~coprime(Z**2 - 1, Z + 1),
    "positive": pos_on_circle(Z + 3 + Z**-1),
    "nonnegative": nonneg_on_circle(Z + 2 + Z**-1) & ~pos_on_circle(Z + 2 + Z**-1),
    "negative": ~nonneg_on_circle(Z + 1 + Z**-1),
    "root": sqrt(rational("9/4")) == rational("3/2"),
    "cosine": (8 * cospi(1, 7) ** 3 - 4 * cospi(1, 7) ** 2 - 4 * cospi(1, 7) + 1 == 0) & (cospi(3, 7) > 0) & (cospi(4, 7) < 0),
    "rational cosine": cospi(-8, 6) == -HALF,
    "absolute value": abs(-HALF) == HALF,
    "printed": prints(rational("1/3"), "0.333"),
    "not printed": ~prints(rational("1/3"), "0.334"),
    "undefined": ~defined(1 / (x - x)),
    "scalars and 1 x 1": rows([[2]]) * SHEAR == 2 * SHEAR,
    "entry of a column": x[1] == 3,
}
UNDEFINED = {
    "quotient by zero": 1 / (HALF - HALF) == 1,
    "inverse": inv(ONES) == ONES,
    "solution": stein(ROTATION, ONES) == ONES,
    "sizes": SHEAR == Zero(1, 2),
    "entry": x[2] == 3,
    "cosine": cospi(HALF, 3) == 0,
}


def _both(says, **parts):
    statement = Statement(says=says, over={"x": matrix(1, 1)}, **parts).to_json()
    instance = {"sizes": {"horizon": 4}, "values": {"x": [[3]]}}
    return statement, instance


@pytest.mark.parametrize("name", TRUE)
def test_operations(name):
    """True, its negation false, by both evaluators."""
    for says, expected in ((TRUE[name], True), (~TRUE[name], False)):
        statement, instance = _both(says)
        assert World(statement, read_instance(statement, instance)).value(statement["says"]) is expected
        assert evaluate(statement, instance) is expected


@pytest.mark.parametrize("name", UNDEFINED)
def test_terms_without_value(name):
    """No value, not false."""
    assert evaluate(*_both(UNDEFINED[name])) is None


def test_recursions_stop_where_they_end():
    """x[t + 1] = 1/(x[t] - 1/2) from 9/10: 5/2, 1/2, nothing; from 1: 2, 2/3, 6, 2/11, -22/7."""
    for start, expected in ((rational("9/10"), True), (1, False)):
        statement, instance = _both(always(t, f[t] > 0), where=[rec(f, t, start, 1 / (f[t] - HALF))])
        instance["sizes"]["horizon"] = 5
        assert evaluate(statement, instance) is expected
        assert World(statement, read_instance(statement, instance)).value(statement["says"]) is expected


def test_numbers_of_a_field():
    """The square root of two, given by its polynomial and an interval."""
    statement = Statement(says=x * x == 2, over={"x": scalar()}).to_json()
    instance = {"sizes": {}, "values": {"x": [0, 1]}, "field": [[-2, 0, 1], "1", "2"]}
    assert evaluate(statement, instance) is True
    assert (
        evaluate(
            {
                **statement,
                "says": Statement(says=x == rational("1.41421356237309504880"), over={"x": scalar()}).to_json()["says"],
            },
            instance,
        )
        is False
    )


def test_hypotheses_and_types():
    """An instance that breaks a hypothesis is not admissible for either evaluator."""
    statement = Statement(says=psd(A), over={"A": matrix(2, 2)}, given={"symmetric": symmetric(A)}).to_json()
    for entries, expected in (([[1, 2], [2, 1]], True), ([[1, 2], [3, 1]], False)):
        instance = {"sizes": {}, "values": {"A": entries}}
        assert admissible_again(statement, instance) is expected
        assert (admissible(statement, World(statement, read_instance(statement, instance))) == "") is expected
