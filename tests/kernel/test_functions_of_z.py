# SPDX-License-Identifier: MIT
"""Polynomials as functions of z at a generic index, powers of z, products of polynomials, variables that are polynomials. What is false is not shown."""

from __future__ import annotations

import pytest

from exactkf.evidence import generic_index, lemma, use
from exactkf.kernel.defined import ill_founded
from exactkf.kernel.replay import seal
from exactkf.language import (
    Statement,
    T,
    Z,
    coeff,
    forall,
    function,
    given,
    let,
    matrix_of,
    monic,
    polynomial,
    prod,
    rec,
    recip,
    sequence,
    signal,
    sum_of,
    symbols,
    vector,
    when,
)
from tests.kernel.acceptance import is_accepted

n, m, t, k, j, i, s, a, b, f, g, h, p, q, x, y, A, B = symbols("n m t k j i s a b f g h p q x y A B")
FREE = {a: signal(0), b: signal(0)}
#: f_t of degree t, and its companion
PAIR = [rec(f, t, 1, Z * f[t] + a[t] * g[t]), rec(g, t, 1, g[t] + a[t] * Z * f[t])]


def accepts(says, evidence=None, **statement):
    """Whether a certificate of the statement is accepted."""
    return is_accepted(seal("test", "generic index", Statement(says, **statement).to_json(), (evidence or generic_index(in_values=True)).hints))


# ---------------------------------------------------------------------- powers of z, and sums
@pytest.mark.parametrize("says, true", [
    (Z ** (n + 1) == Z * Z**n, True),
    (Z ** (n - 1) * Z**2 == Z ** (n + 1), True),
    (Z ** (n - m) * Z**m == Z**n, True),
    (Z**n == Z ** (n + 1), False),
    (Z**n == Z**m, False),
    (recip(Z**n) * Z**n == 1, True),
    (recip(Z**n) == Z**n, False),
    (sum_of(i, 1, n, a[i] * Z ** (n - i)) == Z**n * sum_of(i, 1, n, a[i] * recip(Z**i)), True),
    (sum_of(i, 1, n, a[i] * Z ** (n - i)) == Z**n * sum_of(i, 1, n, a[i] * Z**i), False),
    (sum_of(i, 1, n, a[i] * Z ** (i + 1)) == Z * sum_of(i, 1, n, a[i] * Z**i), True),
    (sum_of(i, 1, n, a[i] * Z ** (n - i)) == sum_of(i, 0, n - 1, a[n - i] * Z**i), True),
    (sum_of(i, 1, n, a[i] * Z ** (n - i)) == sum_of(i, 0, n - 1, a[n - i] * Z ** (i + 1)), False),
    (sum_of(i, 1, n, a[i + 1] * Z**i) == sum_of(i, 2, n + 1, a[i] * Z ** (i - 1)), True),
    (sum_of(i, 1, n, a[i + 1] * Z**i) == sum_of(i, 2, n + 1, a[i] * Z**i), False),
    (recip(sum_of(i, 1, n, a[i] * Z**i)) == sum_of(i, 1, n, a[i] * recip(Z**i)), True),
    (recip(sum_of(i, 1, n, a[i] * Z**i)) == sum_of(i, 1, n, a[i] * Z**i), False),
    (sum_of(i, 1, n, Z**i * sum_of(j, 1, m, b[j] * Z**j)) == sum_of(j, 1, m, b[j] * Z**j * sum_of(i, 1, n, Z**i)), True),
    (sum_of(i, 1, n, Z**i * sum_of(j, 1, m, b[j] * Z**j)) == sum_of(j, 1, m, b[j] * Z**j) * sum_of(i, 0, n, Z**i), False),
    (sum_of(i, n + 1, n, a[i] * Z**i) == 0, True),
    (sum_of(i, n, n, a[i] * Z**i) == 0, False),
])
def test_powers_of_z(says, true):
    """Their exponents are linear forms in sizes and in the indices of sums, also of sums without terms."""
    assert accepts(says, sizes=["n", "m"], over=FREE) is true


@pytest.mark.parametrize("high, exponent, true", [(m - 1, m, True), (m, m + 1, True), (m, m, False), (m - 1, m + 1, False)])
def test_a_geometric_sum(high, exponent, true):
    """By induction, from the empty sum."""
    says = (1 - Z) * sum_of(k, 0, high, Z**k) == 1 - Z**exponent
    shown = generic_index(lemma(m, says, in_values=True, uses=[use(0, m=m, times=1)]), in_values=True, uses=[use(0, m=m, times=1)])
    assert accepts(forall(m, 0, n, says), shown, sizes=["n"]) is true


@pytest.mark.parametrize("monic_one, true", [(Z**n + sum_of(i, 1, n, a[i] * Z ** (n - i)), True), (sum_of(i, 1, n, a[i] * Z ** (n - i)), False),
                                             (Z**n - Z**m, False), (Z**n - 1, False)])
def test_what_is_divided_by_is_not_zero(monic_one, true):
    """A monic polynomial is not zero; z^n - z^m is for m = n, z^n - 1 for n = 0, a sum without terms for n = 0."""
    assert accepts(1 / monic_one * monic_one == 1, sizes=["n", "m"], over=FREE) is true


# ---------------------------------------------------------------------- recursions
@pytest.mark.parametrize("says, true", [
    (f[t + 1] == Z * f[t] + a[t] * g[t], True),
    (recip(f[t + 1]) == recip(f[t]) / Z + a[t] * recip(g[t]), True),
    (recip(f[t + 1]) == Z * recip(f[t]) + a[t] * recip(g[t]), False),
    (f[t + 1] * recip(g[t]) == (Z * f[t] + a[t] * g[t]) * recip(g[t]), True),
    (f[t + 1] * recip(g[t]) == (Z * f[t] + a[t] * g[t]) * g[t], False),
    (f[t] * recip(g[t]) == recip(f[t]) * g[t], False),
    (f[t] * g[t] == g[t] * f[t], True),
    (f[t] == recip(f[t]), False),
])
def test_values_of_recursions(says, true):
    """X_t(z) and X_t(1/z) are different things."""
    assert accepts(forall(t, 0, n, says), sizes=["n"], over=FREE, where=PAIR) is true


@pytest.mark.parametrize("factor, true", [(1 - a[t] ** 2, True), (1 + a[t] ** 2, False), (1 - a[t + 1] ** 2, False)])
def test_an_invariant_of_two_recursions(factor, true):
    """f(z)f(1/z) - g(z)g(1/z) at t + 1 is that at t, times a factor."""
    def form(at):
        return f[at] * recip(f[at]) - g[at] * recip(g[at])
    assert accepts(forall(t, 0, n, form(t + 1) == factor * form(t)), sizes=["n"], over=FREE, where=PAIR) is true


@pytest.mark.parametrize("step, well", [
    (Z + h(t - 1) * recip(h(t - 1)), True), (h(t - 1) / Z, True), (Z + sum_of(i, 0, t - 1, h(i) * recip(h(i))), True),
    (h(t) + Z, False), (Z + h(n) * recip(h(n)), False), (h(t - 1) / (Z - 1), False), (Z / h(t - 1), False), (h(t - 1) / (Z * a[t] + 1), False),
    (Z + sum_of(i, 0, t, h(i) * recip(h(i))), False),
])
def test_functions_of_z_are_made_of_earlier_ones(step, well):
    """Without poles: then they have coefficients too."""
    data = Statement(Z == Z, sizes=["n"], over=FREE, where=[function(h, [t], when(t == 0, 1, step))]).to_json()
    assert (ill_founded(data, [{"n": 1}]) == set()) is well


def test_an_ill_founded_function_is_not_opened():
    """h_t = h_t + 1 would show everything."""
    where = [function(h, [t], when(t == 0, 1, h(t) + Z))]
    assert not accepts(forall(t, 0, n, Z == 0), generic_index(in_values=True, uses=[use(h, t + 1)]), sizes=["n"], where=where)


def test_a_closed_function_is_opened_by_its_definition():
    """At z and at 1/z, and at the place that is named."""
    where = [*PAIR, function(h, [s, t], f[s] * recip(g[t]))]
    says = forall(t, 0, n, h(t, t) * h(t, t + 1) == f[t] ** 2 * recip(g[t]) * recip(g[t + 1]))
    flipped = forall(t, 0, n, recip(h(t, t)) == recip(f[t]) * g[t])
    for places, one, two in (([(t, t), (t, t + 1)], True, True), ([(t, t)], False, True), ([(t, t + 1)], False, False)):
        shown = generic_index(closed=[h], in_values=True, uses=[use(h, *place) for place in places])
        assert accepts(says, shown, sizes=["n"], over=FREE, where=where) is one
        assert accepts(flipped, shown, sizes=["n"], over=FREE, where=where) is two
    assert not accepts(forall(t, 0, n, h(t, t) == h(t + 1, t)), generic_index(closed=[h], in_values=True, uses=[use(h, t, t), use(h, t + 1, t)]),
                       sizes=["n"], over=FREE, where=where)


def test_matrices_do_not_commute_as_functions_of_z():
    """A product of matrices is not one of numbers, though the whole has one row and one column."""
    where = [function(A, [t], matrix_of(i, j, 2, 2, Z * i + j)), function(B, [t], matrix_of(i, j, 2, 2, Z * i * j + 1 + i))]
    says = T(x) * A(0) * B(0) * y == T(x) * B(0) * A(0) * y
    for closed in ([], [A, B]):
        assert not accepts(says, generic_index(closed=closed, in_values=True), over={x: vector(2), y: vector(2)}, where=where)
        assert not accepts(coeff(T(x) * A(0) * B(0) * y, 1) == coeff(T(x) * B(0) * A(0) * y, 1), generic_index(closed=closed),
                           over={x: vector(2), y: vector(2)}, where=where)


def test_equations_are_read_as_they_are_numbered():
    """The first as functions of z, the second coefficient by coefficient; a number says nothing of another one."""
    says = (f[n] * recip(g[n]) == recip(g[n]) * f[n]) & (coeff(Z**n, n) == 1)
    other = (f[n] * recip(g[n]) == recip(g[n]) * f[n]) & (coeff(Z**n, n) == 2)
    for in_values, true in (([0], True), (True, True), ([1], False), ([7], False)):
        assert accepts(says, generic_index(in_values=in_values), sizes=["n"], over=FREE, where=PAIR) is true
        assert not accepts(other, generic_index(in_values=in_values), sizes=["n"], over=FREE, where=PAIR)
    wrong = (coeff(Z**n, n) == 1) & (f[n] * recip(g[n]) == recip(f[n]) * g[n])
    assert not any(accepts(wrong, generic_index(in_values=numbers), sizes=["n"], over=FREE, where=PAIR) for numbers in ([], [0], [1], [0, 1], True))


def test_a_lemma_may_close_names():
    """They are open after it, and a false lemma is none the better for it."""
    where = [*PAIR, function(h, [t], f[t] * recip(g[t]))]
    for right, true in ((h(t), True), (h(t + 1), False)):
        shown = generic_index(lemma(t, 2 * h(t) == h(t) + right, direct=True, in_values=True, closed=[h]), in_values=True)
        assert accepts(forall(t, 0, n, h(t) == f[t] * recip(g[t])), shown, sizes=["n"], over=FREE, where=where) is true


# ---------------------------------------------------------------------- variables that are polynomials, and their products
@pytest.mark.parametrize("says, in_values, true", [
    (coeff(p, n) == 1, False, True), (coeff(p, 0) == 1, False, False), (coeff(p, 0) == 0, False, False), (coeff(q, n) == 0, False, False),
    (coeff(q, n + 1) == 0, False, True), (coeff(q, -1) == 0, False, True), (p == Z**n, False, False),
    (p == Z**n + sum_of(i, 0, n - 1, coeff(p, i) * Z**i), False, True), (q == sum_of(i, 0, n - 1, coeff(q, i) * Z**i), False, False),
    (coeff(p * q, 2 * n) == coeff(q, n), False, True), (coeff(p * q, 2 * n + 1) == 0, False, True), (coeff(p * q, n) == 0, False, False),
    (coeff(p * recip(q), n) == coeff(q, 0), False, True), (coeff(p * recip(q), -n) == coeff(q, n) * coeff(p, 0), False, True),
    (coeff(p * recip(q), -n) == coeff(q, n), False, False), (coeff(p * recip(q), n + 1) == 0, False, True), (coeff(p * p, 0) == coeff(p, 0) ** 2, False, True),
    (forall(k, 0, n, coeff(p * recip(p), k) == coeff(p * recip(p), -k)), False, True),
    (forall(k, 0, n, coeff(p * recip(q), k) == coeff(p * recip(q), -k)), False, False), (p * recip(q) == q * recip(p), False, False),
    (p * q == q * p, True, True), (p * recip(q) == q * recip(p), True, False), (p == recip(p), True, False),
    (p / p == 1, True, True), (q / q == 1, True, False), (recip(p) / recip(p) == 1, True, True), ((p - 1) / (p - 1) == 1, True, False),
    (p / (p * q) == 1 / q, True, False),
])
def test_polynomials_that_are_variables(says, in_values, true):
    """p is monic of degree n, q of degree n at most; for n = 0 p is one, and q may be zero."""
    assert accepts(says, generic_index(in_values=in_values), sizes=["n"], over={p: monic(n), q: polynomial(n)}) is true


@pytest.mark.parametrize("says, true", [
    (coeff(f[t] * recip(f[t]), t + 1) == 0, True), (coeff(f[t] * recip(f[t]), t) == coeff(f[t], t) * coeff(f[t], 0), True),
    (coeff(f[t] * recip(f[t]), t) == coeff(f[t], t), False), (coeff(f[t] * g[t], 2 * t) == coeff(f[t], t) * coeff(g[t], t), True),
    (coeff(f[t] * g[t], 2 * t) == 0, False), (coeff(f[t] * g[t], -1) == 0, True),
    (coeff((f[t] + 1) * (g[t] - Z), 0) == (coeff(f[t], 0) + 1) * coeff(g[t], 0), True),
    (coeff((f[t] + 1) * (g[t] - Z), 0) == coeff(f[t], 0) * coeff(g[t], 0), False),
    (coeff(f[t] * sum_of(i, 0, t, b[i] * Z**i), 0) == b[0] * coeff(f[t], 0), True), (coeff(f[2] * recip(g[2]), 2) == coeff(g[2], 0), True),
    (coeff(f[2] * recip(g[2]), 1) == coeff(g[2], 0), False),
])
def test_products_of_polynomials_with_known_exponents(says, true):
    """f_t and g_t have the exponents 0 .. t."""
    assert accepts(forall(t, 0, n, says), generic_index(supported=[f, g]), sizes=["n"], over=FREE, where=PAIR) is true


def test_a_hypothesis_about_coefficients():
    """Of variables that are polynomials."""
    over, zero = {p: monic(n), q: polynomial(n)}, given("sum", coeff(p, 0) + coeff(q, 0) == 0)
    for says, true in ((coeff(p + q, 0) == 0, True), (coeff(p - q, 0) == 0, False), (coeff(p + q, 1) == 0, False)):
        assert accepts(says, generic_index(uses=[use("sum")]), sizes=["n"], over=over, given=[zero]) is true


@pytest.mark.parametrize("place, right, true", [(0, b[0], True), (1, b[1], True), (1, b[0], False), (0, b[0] + 1, False), (n + 1, 0, True), (n, 0, False)])
def test_a_polynomial_without_indices_that_is_not_opened(place, right, true):
    """Its coefficients are opened where a use says so."""
    where = [let(h, sum_of(i, 0, n, b[i] * Z**i))]
    for uses in ([use(h, z=place)], []):
        shown = generic_index(whole=[h], uses=uses)
        assert accepts(coeff(h, place) == right, shown, sizes=["n"], over=FREE, where=where, given=[given("some", n >= 1)]) is (true and bool(uses))


# ---------------------------------------------------------------------- products within sums
@pytest.mark.parametrize("last, right, true", [(i - 1, prod(k, 1, m, b[k]), True), (i, prod(k, 1, m, b[k]), False), (i - 1, prod(k, 1, m + 1, b[k]), False),
                                               (i - 2, prod(k, 1, m, b[k]), False)])
def test_a_sum_of_products_that_end_before_its_index(last, right, true):
    """The sum of (1 - b_i) b_1 ... b_(i-1) telescopes."""
    says = sum_of(i, 1, m, (1 - b[i]) * prod(k, 1, last, b[k])) == 1 - right
    shown = generic_index(lemma(m, says, uses=[use(0, m=m, times=1)]), uses=[use(0, m=m, times=1)])
    assert accepts(forall(m, 0, n, says), shown, sizes=["n"], over={b: sequence(1, n)}) is true


# ---------------------------------------------------------------------- what a hypothesis says is not zero
@pytest.mark.parametrize("place, bound, kept, true", [
    (m, n, "!=", True), (m + 1, n, "!=", False), (m, n + 1, "!=", False), (m - 1, n, "!=", False), (m, n, "=", False)])
def test_a_hypothesis_about_all_grants_a_division(place, bound, kept, true):
    """h_m is the inverse of b_0 ... b_(m-1) as long as m <= n, if none of b_0, .., b_(n-1) is zero; not one further, nor without the hypothesis."""
    where = [function(f, [m], when(m == 0, 1, b[m - 1] * f(m - 1))), function(h, [m], when(m == 0, 1, h(m - 1) / b[m - 1]))]
    says = f(m) * h(m) * a[0] == a[1]
    label = given("not zero", forall(k, 0, n - 1, b[k] != 0 if kept == "!=" else b[k] == b[k]))
    equal = given("equal", a[0] == a[1])
    shown = generic_index(lemma(m, forall(s, m, bound, f(m) * h(m) == 1), uses=[use(0, m=m, s=s, times=1), use("not zero", k=place)]),
                          uses=[use(0, m=m, s=n, times=a[0]), use("equal")])
    assert accepts(forall(m, 0, n, says), shown, sizes=["n"], over=FREE, where=where, given=[label, equal]) is true


def test_a_factor_of_what_is_not_zero_is_not_zero():
    """b - 1 divides b^2 - 1, and b does not."""
    squares, equal = given("squares", b[0] ** 2 != 1), given("equal", a[0] == a[1])
    for divisor, true in ((b[0] - 1, True), (b[0] + 1, True), (b[0], False), (b[0] - 2, False), (b[1] - 1, False)):
        shown = generic_index(uses=[use("squares"), use("equal")])
        assert accepts(a[0] / divisor * divisor == a[1], shown, sizes=["n"], over=FREE, given=[squares, equal]) is true
