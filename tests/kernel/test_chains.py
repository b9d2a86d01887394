# SPDX-License-Identifier: MIT
"""Products of matrix variables at a generic index: what is accepted is true on instances, and what is false is not accepted."""

from __future__ import annotations

from itertools import product
from random import Random

import pytest

from exactkf.evidence import fact, generic_index, lemma, use
from exactkf.kernel.linear import Matrix
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.replay import seal
from exactkf.language import (
    Identity,
    Statement,
    T,
    Z,
    Zero,
    always,
    coeff,
    forall,
    function,
    inv,
    let,
    matrix,
    matrix_of,
    rec,
    scalar,
    signal,
    standing,
    substitute,
    sum_of,
    sym,
    symbols,
    symmetric_matrix,
    vector,
    when,
)
from tests.kernel.acceptance import is_accepted

n, m, t, k, j, i, s, b, F, G, P, Q, X, Y, h, g, p = symbols("n m t k j i s b F G P Q X Y h g p")
SOME = [standing("n >= 1", n >= 1)]
OVER = {"F": matrix(n, n), "G": matrix(n, n), "P": symmetric_matrix(n), "h": vector(n), "g": vector(n), "b": scalar()}
WHERE = [let(Q, P - F * P * T(F)), rec(X, t, Identity(n), F * X[t]),
         function(Y, [s, t], when(t == 0, Zero(n, n), F * Y(s, t - 1) + when(s == t - 1, Identity(n), Zero(n, n))))]
WRITTEN_OUT = (lemma(t, X[t] == F**t, rule=True), lemma(t, always(s, Y(s, t) == when(s < t, F ** (t - 1 - s), Zero(n, n))), rule=True))


def accepts(says, *lemmas, over=OVER, where=WHERE, given=SOME, sizes=("n", "m"), **hints):
    statement = Statement(says=says, sizes=sizes, over=over, where=where, given=given)
    return is_accepted(seal("test", "generic index", statement.to_json(), generic_index(*lemmas, **hints).hints))


def world(seed, size, length):
    """Random matrices of small integers."""
    random = Random(seed)

    def draw(rows, cols):
        return Matrix.build(rows, cols, lambda r, c: random.randint(-3, 3))

    half = draw(size, size)
    values = {"n": size, "m": length, "F": draw(size, size), "G": draw(size, size), "P": half + half.transpose(),
              "h": draw(size, 1), "g": draw(size, 1), "b": 2}
    return World(Statement(says=b == b, sizes=["n", "m"], over=OVER, where=WHERE, given=SOME).to_json(), values)


WORLDS = [world(seed, size, length) for seed, (size, length) in enumerate([(1, 1), (2, 1), (2, 2), (3, 2)])]


def false_somewhere(says) -> bool:
    data = Statement(says=says, sizes=["n", "m"], over=OVER, where=WHERE, given=SOME).to_json()["says"]
    return any(w.value(data) is False for w in WORLDS)


SQUARE = [F * G, G * F, T(F * G), T(G) * T(F), F * T(F), T(F) * F, P * F, T(T(F) * P), T(F) * P, F**2 * G, F * (F * G), F * F**m, F**m * F, F ** (m + 1),
          T(F) ** m * T(F), T(F**m * F), F * Identity(n) * G, b * F * G,
          F * (b * G), (F + G) * F, F * F + G * F, F * (F - G), F**0, Identity(n),
          F * Zero(n, n), Zero(n, n), Q,
          P - F * P * T(F), P - F * (P * T(F)), F * (h * T(g)), (F * h) * T(g), T(h) * g * F, F * (T(g) * h), (T(h) * F * g) * G, (T(g) * T(F) * h) * G,
          F * h * T(g) * h * T(g), (T(g) * h) * (F * h * T(g)), h * T(F * h), T(F * (h * T(h))), (F * h) * T(F * h), F * (h * T(h)) * T(F)]


@pytest.mark.parametrize("left", SQUARE, ids=range(len(SQUARE)))
def test_products_that_are_equal_and_no_others(left):
    """Two products are accepted as equal if and only if they are on random matrices."""
    for right in SQUARE:
        assert accepts(left == right) is not false_somewhere(left == right)


def test_sums_over_an_index():
    """A telescoping sum, term by term and as a whole; sums without terms, and sums that are cut, are looked at separately."""
    says = sum_of(s, 0, m, F**s * Q * T(F) ** s) == P - F ** (m + 1) * P * T(F) ** (m + 1)
    assert accepts(says) and not false_somewhere(says)
    for wrong in (sum_of(s, 1, m + 1, F**s * Q * T(F) ** s) == P - F ** (m + 1) * P * T(F) ** (m + 1),
                  sum_of(s, 0, m, F**s * Q * F**s) == P - F ** (m + 1) * P * F ** (m + 1),
                  sum_of(s, 0, m, F**s * Q * T(F) ** s) == P - F**m * P * T(F) ** m):
        assert false_somewhere(wrong) and not accepts(wrong)
    assert accepts(sum_of(s, 0, m, when(s < 1, G, F**s)) == G + sum_of(s, 1, m, F**s), given=[*SOME, standing("m >= 1", m >= 1)])
    assert not accepts(sum_of(s, 0, m, when(s < 1, G, F**s)) == sum_of(s, 0, m, F**s), given=[*SOME, standing("m >= 1", m >= 1)])
    assert not accepts(sum_of(s, 1, m, F**s) == Zero(n, n)) and not accepts(sum_of(s, 1, 0, F**s) == Zero(n, n))  # without terms it is the number 0


def test_a_recursion_of_two_indices_written_out():
    """x_(t+1) = F x_t + v_t: its coefficients are powers, its covariance is stationary, and E{x_(t+1) x_j} = F^(t+1-j) P."""
    def cov(t, j):
        return X[t] * P * T(X[j]) + sum_of(s, 0, m, Y(s, t) * Q * T(Y(s, j)))

    stationary = forall(t, 0, m, cov(t, t) == P)
    shifted = forall(j, 0, m, forall(t, j, m, cov(t + 1, j) == F ** (t + 1 - j) * P))
    assert accepts(stationary, *WRITTEN_OUT) and accepts(shifted, *WRITTEN_OUT)
    for wrong in (forall(j, 0, m, forall(t, j, m, cov(t + 1, j) == F ** (t - j) * P)), forall(j, 0, m, forall(t, 0, m, cov(t, j) == F ** abs(t - j) * P)),
                  forall(j, 0, m, forall(t, j, m, cov(t + 1, j) == P * F ** (t + 1 - j))), forall(t, 0, m, cov(t, t) == F * P)):
        assert false_somewhere(wrong) and not accepts(wrong, *WRITTEN_OUT)
    late = lemma(t, always(s, Y(s, t) == when(s <= t, F ** (t - s), Zero(n, n))), rule=True)
    early = lemma(t, always(s, Y(s, t) == F ** (t - 1 - s)), rule=True)
    for rule in (late, early, lemma(t, always(s, Y(s, t) == when(s < t, F ** (t - 1 - s), G)), rule=True)):
        assert not accepts(stationary, WRITTEN_OUT[0], rule)
    assert not accepts(forall(t, 0, m, F ** (t - 1) * F == F**t))  # at t = 0 the left side is inverse


def test_definitions_that_define_nothing():
    """A function that is made of itself at the same index, or of matrices of two shapes, is not used."""
    over = {"F": matrix(n, n)}
    same = [function(Y, [t], when(t == 0, F, Y(t) + F))]
    assert not accepts(forall(t, 0, m, F == Zero(n, n)), lemma(t, always(s, F == Zero(n, n)), direct=True, uses=[use(Y, t)]), over=over, where=same)
    later = [function(Y, [t], when(t == 0, F, Y(t + 1) + F))]
    assert not accepts(forall(t, 0, m, Y(t + 1) == Y(t) - F), over=over, where=later)
    shapes = [function(Y, [t], when(t == 0, F, vector_of_ones() * Y(t - 1)))]
    assert not accepts(forall(t, 0, m, Y(t) == Y(t)), over=over, where=shapes)


def vector_of_ones():
    return matrix_of(i, j, 1, n, 1)


def test_an_inverse_stays_where_it_is_left_out():
    """inv(F - F) 0 is every vector, as (F - F) x = 0: that it is h and g, or that one of them is left over, says nothing about these."""
    none = inv(F - F)
    both = [fact(t, "solve", none * Zero(n, 1) == x) for x in (h, g)]
    uses = [use(x, t=0, row=sym("row")) for x in (0, 1)]
    assert accepts(none * Zero(n, 1) == h, *both, uses=uses)  # a claim about what has no value is empty
    assert not accepts(h == g, *both, uses=uses)
    again = lemma(t, none * Zero(n, 1) + h == none * Zero(n, 1) + g, direct=True, uses=uses)
    assert not accepts(h == g, *both, again, uses=[use(2, t=0, row=sym("row"))])
    assert not accepts(none**0 * h == none * Zero(n, 1), both[0]) and not accepts(h == g, *both, lemma(t, none**0 * h == g, direct=True, uses=uses),
                                                                                 uses=[use(2, t=0, row=sym("row"))])


def test_powers_are_of_square_matrices():
    """X^0 has no value for a matrix with more rows than columns, and so it is nothing."""
    over = {"X": matrix(n, m), "G": matrix(m, n)}
    for says in (X**0 == X**0, X**1 == X, (X * G) ** 1 == X * G, forall(t, 0, m, X**t == X**t)):
        assert accepts(says, over=over, where=()) is (says.tree[1][1][0] == "*" if says.tree[0] == "=" else False)


def test_a_recursion_behind_a_power_or_an_inverse_defines_nothing():
    """Y(t) made of the square, or the inverse, of Y(t) is not used."""
    over = {"F": matrix(n, n)}
    for step in (F * Y(t) ** 2, Y(t) ** t, F * inv(Y(t)), T(Y(t)), Y(t) * h * T(g)):
        where = [function(Y, [t], when(t == 0, F, step))]
        assert not accepts(Y(1) == F, over={**over, "h": vector(n), "g": vector(n)}, where=where)
        assert not accepts(forall(t, 1, m, Y(t) == step), over={**over, "h": vector(n), "g": vector(n)}, where=where, uses=[use(Y, t)])


def test_a_column_of_a_recursion_that_has_values_is_no_denominator():
    """h'X_t h is zero where h is, so that 1 - h'X_t h is not zero and h'X_t h may be; unless X_t has perhaps no value there."""
    over = {"F": matrix(n, n), "h": vector(n), "g": vector(n), "s": signal(0)}
    value = (T(h) * X[t] * h)[1, 1]
    step = F * X[t] * T(F) + (g - F * X[t] * h) * T(g - F * X[t] * h) / (1 - value)
    cancels = always(t, (1 - value) / (1 - value) == 1)
    assert accepts(cancels, over=over, where=[rec(X, t, Zero(n, n), step)])
    assert accepts(cancels, over=over, where=[rec(X, t, F, F * X[t])])
    assert not accepts(always(t, value / value == 1), over=over, where=[rec(X, t, Zero(n, n), step)])
    assert not accepts(always(t, (1 - (T(h) * inv(X[t]) * h)[1, 1]) / (1 - (T(h) * inv(X[t]) * h)[1, 1]) == 1), over=over, where=[rec(X, t, F, F * X[t])])
    for other in (F * X[t] / value, F * X[t] / (F * X[t] * h)[1], inv(F + X[t]), F * X[t] * inv(F)):  # a division by what is zero there, and inverses
        assert not accepts(cancels, over=over, where=[rec(X, t, F, other)])
    nothing = [rec(X, t, Zero(n, n), F * X[t])]  # the only product with h that there is
    zero = lemma(t, always(k, (T(h) * F**k * X[t] * h)[1, 1] == 0), uses=[use(0, t=t, k=k + 1)])
    assert accepts(always(t, value == 0), zero, over=over, where=nothing, uses=[use(0, t=t, k=0)])
    assert not accepts(always(t, s[t] == 0), zero, over=over, where=nothing, uses=[use(0, t=t, k=0, times=s[t] / value)])


def test_a_polynomial_of_a_matrix_in_a_product():
    """F p(F) g is the sum of p_k F^(k+1) g, and h' p(F) p(F) g is left as one product of two sums."""
    over = {"F": matrix(n, n), "h": vector(n), "g": vector(n), "b": scalar()}
    where = [rec(p, t, 1, Z * p[t] + b)]
    says = forall(t, 0, m, F * substitute(p[t], F) * g == sum_of(k, 0, t, coeff(p[t], k) * (F ** (k + 1) * g)))
    assert accepts(says, over=over, where=where, supported=[p])
    for wrong in (forall(t, 0, m, F * substitute(p[t], F) * g == sum_of(k, 0, t, coeff(p[t], k) * (F**k * g))),
                  forall(t, 0, m, F * substitute(p[t], T(F)) * g == sum_of(k, 0, t, coeff(p[t], k) * (F ** (k + 1) * g)))):
        assert not accepts(wrong, over=over, where=where, supported=[p])
    assert not accepts(says, over=over, where=where)


def test_worlds_have_values():
    """The comparison above is with values, not with their absence."""
    for w, x in product(WORLDS, SQUARE):
        try:
            w.value(Statement(says=x == x, sizes=["n", "m"], over=OVER, where=WHERE, given=SOME).to_json()["says"])
        except (Undefined, Unknown) as error:
            pytest.fail(str(error))
