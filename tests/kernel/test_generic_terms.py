# SPDX-License-Identifier: MIT
"""Terms at a generic index: numbers, products of sums in z, matrices that are not opened, what is not zero at a point. What is false is not shown."""

from __future__ import annotations

import pytest

from exactkf.evidence import fact, generic_index, lemma, use
from exactkf.kernel.replay import seal
from exactkf.language import (
    Statement,
    T,
    Z,
    always,
    coeff,
    eq,
    forall,
    function,
    laurent,
    let,
    matrix_of,
    rec,
    recip,
    scalar,
    sequence,
    signal,
    standing,
    sum_of,
    symbols,
    vector,
    when,
)
from tests.kernel.acceptance import is_accepted

n, m, t, k, j, i, s, a, b, c, f, g, h, A, B, p, q, x, y = symbols("n m t k j i s a b c f g h A B p q x y")
SOME = [standing("n >= 1", n >= 1)]
HALVES = lemma(s, 2 * sum_of(i, 1, s, i) == s * s + s, uses=[use(0, s=s)])


def accepts(says, evidence, **statement):
    """Whether a certificate of the statement is accepted."""
    return is_accepted(seal("test", "generic index", Statement(says, **statement).to_json(), evidence.hints))


# ---------------------------------------------------------------------- indices as numbers
@pytest.mark.parametrize("says, true", [
    (2 * sum_of(i, 1, n, i) == n * n + n, True),
    (2 * sum_of(i, 1, n, i) == n * n - n, False),
    (2 * sum_of(i, 0, n + 1, i) == n * n + 3 * n + 2, True),
    (sum_of(i, 1, n, 1) == n, True),
    (sum_of(i, 0, n, 1) == n, False),
    (sum_of(i, 3, n, 1) == n - 2, False),  # for n = 0 there are no terms, and not -2
    (sum_of(i, 1, n, sum_of(j, 1, m, 1)) == n * m, True),
    (2 * sum_of(i, 1, n, sum_of(j, i, n, 1)) == n * n + n, True),
    (2 * sum_of(i, 1, n, sum_of(j, i, n, 1)) == n * n, False),
    (sum_of(i, 1, n + 1, i * a[i]) == sum_of(i, 1, n, i * a[i]) + (n + 1) * a[n + 1], True),
    (sum_of(i, 1, n, i * a[i + 1]) == sum_of(i, 2, n + 1, i * a[i]), False),
    (n * 0 == n, False), (n == m, False),
])
def test_an_index_is_a_number(says, true):
    """Sums of powers of an index, by induction; sums that may be empty."""
    assert accepts(says, generic_index(HALVES, uses=[use(0, s=n)]), sizes=["n", "m"], over={a: signal(0)}) is true


@pytest.mark.parametrize("factor", [n, n - m, n * n + 1])
def test_nothing_tells_that_an_index_is_not_zero(factor):
    """Division by one is refused, unless a hypothesis says so."""
    over = {"sizes": ["n", "m"], "over": {x: scalar()}}
    assert not accepts(x / factor * factor == x, generic_index(), **over)
    assert accepts(x / factor * factor == x, generic_index(), **over, given=[standing("not zero", factor != 0)])


def test_multiples_of_indices():
    """a_(2n) is not a_n, and is a_(n + n)."""
    over = {"sizes": ["n"], "over": {a: signal(0)}}
    assert accepts(a[2 * n] == a[n + n], generic_index(), **over)
    assert not accepts(a[2 * n] == a[n], generic_index(), **over)
    assert not accepts(a[-1 * n] == a[n], generic_index(), **over)


# ---------------------------------------------------------------------- products of sums in z
SERIES = (let(p, sum_of(i, 0, n, a[i] * Z**i)), let(q, sum_of(i, 0, n, b[i] * Z**i)))
AB = {"sizes": ["n"], "over": {a: sequence(0, n), b: sequence(0, n)}, "where": SERIES, "given": SOME}


@pytest.mark.parametrize("says, true", [
    (forall(k, 0, n, coeff(p * q, k) == sum_of(j, 0, k, a[j] * b[k - j])), True),
    (forall(k, 0, n, coeff(p * q, k) == sum_of(j, 0, k, a[j] * b[j])), False),
    (forall(k, 0, n, coeff(q * p, n + k) == sum_of(j, k, n, a[j] * b[n + k - j])), True),
    (forall(k, 1, n, coeff(q * p, n + k) == sum_of(j, k - 1, n, a[j] * b[n + k - j])), False),
    (forall(k, 0, n, coeff(p * recip(q), k) == sum_of(j, 0, n - k, a[j + k] * b[j])), True),
    (forall(k, 0, n, coeff(p * recip(q), k) == sum_of(j, 0, n - k, a[j] * b[j + k])), False),
    (forall(k, 0, n, coeff(Z * p * (q - p), k + 1) == sum_of(j, 0, k, a[j] * (b[k - j] - a[k - j]))), True),
    (forall(k, 0, n, coeff(sum_of(i, 0, n, a[i] * Z**i) * sum_of(i, 0, n, b[i] * Z**i), k) == coeff(p * q, k)), True),
    (forall(i, 0, n, coeff(sum_of(k, 0, n, a[k] * Z**i) * sum_of(i, 0, n, b[i] * Z**i), i) == b[0] * sum_of(k, 0, n, a[k])), True),  # one i is not the other
    (forall(i, 0, n, coeff(sum_of(k, 0, n, a[k] * Z**i) * sum_of(i, 0, n, b[i] * Z**i), i) == a[0] * sum_of(k, 0, n, b[k])), False),
    (coeff(p * q, 2 * n) == a[n] * b[n], True), (coeff(p * q, 2 * n + 1) == 0, True), (coeff(p * q, 2 * n) == 0, False),
])
def test_sums_in_z_are_multiplied_out(says, true):
    """Convolutions of coefficients, with the ends where they are."""
    assert accepts(says, generic_index(), **AB) is true


def test_a_product_with_a_case():
    """The branch that the index takes."""
    where = [function(f, [i], when(i == 0, Z, a[i]))]
    made = {"sizes": ["n"], "over": {a: sequence(0, n)}, "where": where, "given": SOME}
    assert accepts(forall(i, 1, n, coeff(f(0) * f(i), 1) == a[i]) & (coeff(f(0) * f(0), 2) == 1), generic_index(), **made)
    assert not accepts(forall(i, 0, n, coeff(f(0) * f(i), 1) == a[i]), generic_index(), **made)


# ---------------------------------------------------------------------- matrices that are not opened
MATRICES = {"sizes": ["n"], "over": {x: vector(n), a: signal(0)}, "given": SOME,
            "where": [function(A, [t], matrix_of(i, j, n, n, a[i + t] * a[j])), let(B, matrix_of(i, j, n, n, a[i] + j * a[j]))]}


@pytest.mark.parametrize("says, true", [
    (T(x) * A(0) * x == T(x) * T(A(0)) * x, True), (T(x) * A(0) * B * x == T(x) * T(B) * T(A(0)) * x, True),
    (T(x) * A(0) * B * x == T(x) * B * A(0) * x, False), (T(x) * A(0) * x == T(x) * A(1) * x, False), (A(0) == T(A(0)), False),
    (T(x) * (A(1) * (B * x)) == T(x) * A(1) * B * x, True),
])
def test_words_of_matrices_that_are_not_opened(says, true):
    """They are multiplied as letters are, do not commute, and are not symmetric until a place is looked at."""
    assert accepts(says, generic_index(closed=[A, B]), **MATRICES) is true


def test_a_matrix_is_looked_at_place_by_place():
    """The definition holds at the place that is said, within the rows and columns."""
    entry = forall(i, 1, n, A(2)[i, 1] == a[i + 2] * a[1])
    assert accepts(entry, generic_index(closed=[A], uses=[use(A, 2, row=i, column=1)]), **MATRICES)
    for wrong in (use(A, 1, row=i, column=1), use(A, 2, row=1, column=i), use(A, 2, row=i + 1, column=1), use(A, 2, row=i, column=0)):
        assert not accepts(entry, generic_index(closed=[A], uses=[wrong]), **MATRICES)
    assert accepts(entry, generic_index(), **MATRICES)


# ---------------------------------------------------------------------- what is not zero
def test_sums_that_vanish_where_all_entries_do():
    """1 + sum of squares is not zero; sums that are the same are, whatever they are called."""
    made = {"sizes": ["n"], "over": {a: signal(0), c: scalar()}, "where": [rec(y, t, 0, y[t] + a[t])]}
    squares, total = sum_of(k, 0, n, a[k] ** 2), sum_of(k, 0, n, a[k])
    for factor, fine in ((1 + squares, True), (2 - total * squares, True), (1 + squares + y[n], True), (c + c * squares, True), (squares, False),
                         (squares - total, False), (y[n + 1] - total, False), (sum_of(k, 0, n, a[n - k]) - total, False),
                         (1 + total - sum_of(k, 0, n, a[k]) - sum_of(k, 0, 0, 1), False)):
        equal = lemma(t, y[t] == sum_of(k, 0, t - 1, a[k]), uses=[use(0, t=t)])
        assert accepts(c / factor * factor == c, generic_index(equal, uses=[use(0, t=n), use(0, t=n + 1)]), **made) is fine, factor


def test_functions_that_do_not_vanish_at_one():
    """z^n + .. is not zero; the difference of two that are the same is, and of a function that vanishes at z = 1 nothing is said."""
    w = symbols("w")[0]
    tail = sum_of(i, 1, n, y[t][i] * Z ** (n - i))
    where = [function(f, [t], Z**n + tail), function(g, [t], tail), function(w, [t], Z**n + tail),
             function(h, [t], when(t == 0, 0 * Z, Z)), function(p, [t], Z * (Z - 1) * y[t][1]),
             rec(y, t, x, y[t])]
    made = {"sizes": ["n"], "over": {x: vector(n), c: scalar(), a: signal(0)}, "where": where, "given": SOME}
    for factor, fine in ((f(t), True), (f(t) - g(t), True), (recip(f(t)), True), (f(t) * recip(f(t)), True), (f(t) + g(t + 1), True), (g(t), False),
                         (f(t) - w(t), False), (h(t), False),
                         (Z + sum_of(k, 0, n, p(t) * a[k]) - 1, False), (Z + sum_of(k, 0, n, p(t) * a[k]), True),
                         (p(t), False), (f(t) - recip(f(t)), False)):
        assert accepts(always(t, c / factor * factor == c), generic_index(closed=[f, g, h, p, w], in_values=True), **made) is fine, factor


# ---------------------------------------------------------------------- coefficients at infinity, for indices between bounds
def test_coefficients_at_infinity_between_bounds():
    """(x_i z + 1)/(z + x_n) = x_i + (1 - x_i x_n)/z + ..; beyond the bounds nothing is known."""
    D = Z + x[n]

    def says(low, first):
        return forall(i, low, n, forall(k, 0, 1, laurent((x[i] * Z + 1) / D, k) == when(k == 0, first, 1 - x[i] * x[n])))

    made = {"sizes": ["n"], "over": {x: vector(n)}, "given": SOME}
    goal = forall(i, 1, n, laurent((x[i] * Z + 1) / D, 0) == x[i])
    used = [use(0, t=0, i=i, k=0)]
    assert accepts(goal, generic_index(fact(t, "laurent", says(1, x[i]), 1), uses=used), **made)
    assert not accepts(goal, generic_index(fact(t, "laurent", says(2, x[i]), 1), uses=used), **made)  # n = 1 is left
    assert not accepts(goal, generic_index(fact(t, "laurent", says(1, x[1]), 1), uses=used), **made)
    assert not accepts(eq(x[1], x[n]), generic_index(fact(t, "laurent", says(1, x[i]), 1), uses=used), **made)
    twice = forall(k, 1, n, forall(k, 0, 1, laurent((x[n] * Z + 1) / D, k) == when(k == 0, x[n], 1 - x[n] * x[n])))
    assert not accepts(goal, generic_index(fact(t, "laurent", twice, 1), uses=used), **made)


def test_a_symmetric_matrix_has_symmetric_entries():
    """By its type, and F P F' with it; another matrix has not."""
    from exactkf.language import matrix, positive_semidefinite, symmetric_matrix

    def equal(M):
        return forall(i, 1, n, forall(k, 1, n, M[i, k] == M[k, i]))

    for kind, fine in ((symmetric_matrix(n), True), (positive_semidefinite(n), True), (matrix(n, n), False)):
        made = {"sizes": ["n"], "over": {A: kind, B: matrix(n, n)}, "given": SOME}
        assert accepts(equal(A), generic_index(), **made) is fine
        assert accepts(equal(B * A * T(B)), generic_index(), **made) is fine
        assert not accepts(equal(B * A), generic_index(), **made)
