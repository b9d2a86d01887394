# SPDX-License-Identifier: MIT
"""Products, determinants, inverses, characteristic polynomials and coefficients at infinity of generic size: what is false is not shown."""

from __future__ import annotations

import pytest

from exactkf.evidence import fact, generic_index, lemma, use
from exactkf.kernel.opaque import without_indices
from exactkf.kernel.replay import seal
from exactkf.language import (
    Identity,
    Statement,
    T,
    Z,
    Zero,
    always,
    charpoly,
    coeff,
    column,
    det,
    eq,
    forall,
    function,
    inv,
    laurent,
    let,
    matrix,
    matrix_of,
    prod,
    rec,
    recip,
    scalar,
    sequence,
    signal,
    standing,
    substitute,
    sum_of,
    sym,
    symbols,
    vector,
    when,
)
from tests.kernel.acceptance import is_accepted

n, m, t, k, j, i, s, u, x, y, a, b, c, F, h, g, J, M, p, q = symbols("n m t k j i s u x y a b c F h g J M p q")
row, z = sym("row"), sym("z")
SOME = [standing("n >= 1", n >= 1)]
X = {"sizes": ["n"], "over": {"x": signal(0)}}
#: a companion matrix with ones above the diagonal and first column -v
SHIFT = [let(J, matrix_of(i, j, n, n, when(j == i + 1, 1, 0))), let(h, column(i, n, when(i == 1, 1, 0)))]
COMPANION = {"sizes": ["n"], "over": {"a": vector(n)}, "where": SHIFT}
POLY = Z**n + sum_of(i, 1, n, a[i] * Z ** (n - i))
#: unit lower triangular and upper triangular bidiagonal matrices, with the product M
TRIANGULAR = {"sizes": ["n"], "over": {"x": sequence(1, n), "y": sequence(1, n)}, "given": SOME}
LOWER = matrix_of(i, j, n, n, when(i == j, 1, when(i == j + 1, x[j], 0)))


def accepts(says, evidence, **statement):
    """Whether a certificate of the statement is accepted."""
    data = Statement(says, **statement).to_json()
    return is_accepted(seal("test", "generic index", data, evidence.hints))


# ---------------------------------------------------------------------- products
def test_products_telescope():
    """A factor more, the same factors from behind, and none."""
    assert accepts(prod(k, 1, n, x[k]) * x[n + 1] == prod(k, 1, n + 1, x[k]), generic_index(), **X)
    assert accepts(prod(k, 1, n, x[n + 1 - k]) == prod(k, 1, n, x[k]), generic_index(), **X)
    assert accepts(prod(k, 1, n, 1 - x[k] ** 2) * prod(k, n + 1, 2, 1 - x[k]) == prod(k, 1, n, 1 - x[k] ** 2), generic_index(),
                   **{**X, "given": [standing("n >= 2", n >= 2)]})


@pytest.mark.parametrize("says", [
    prod(k, 1, n, x[k]) == prod(k, 0, n, x[k]),
    prod(k, 1, n, x[k]) * x[n] == prod(k, 1, n + 1, x[k]),
    prod(k, 1, n, x[n - k]) == prod(k, 1, n, x[k]),
    prod(k, 1, n, x[k]) == prod(k, 1, n, 2 * x[k]),
    prod(k, 1, n, x[k]) / x[1] == prod(k, 2, n, x[k]),  # for n = 0 the left side is 1/x_1, the right one is one
    prod(k, 1, n, x[k] + 1) == prod(k, 1, n, x[k]) + 1,
])
def test_false_products(says):
    """Off by one at either end, at n = 0, a factor too many."""
    assert not accepts(says, generic_index(), **X)


def test_the_index_of_a_product_is_its_own():
    """An index bound outside, used in the factor but not as its index, is no index of the product."""
    assert accepts(forall(t, 0, n, prod(k, 1, t, x[k]) * x[t + 1] == prod(k, 1, t + 1, x[k])), generic_index(), **X)
    assert not accepts(forall(t, 0, n, prod(k, 1, t, x[t]) == prod(k, 1, t, x[k])), generic_index(), **X)
    assert not accepts(forall(t, 1, n, sum_of(j, 1, t, x[j] * prod(k, 1, j, x[k])) == sum_of(j, 1, t, x[j]) * prod(k, 1, t, x[k])), generic_index(), **X)


# ---------------------------------------------------------------------- lemmas for all t
def test_an_index_of_a_lemma_is_not_negative():
    """Y_t = 0 for t > 0 only; used at t - 1 it says nothing about t = 0."""
    over = {"sizes": ["n"], "over": {"g": scalar()}, "where": [rec(y, t, g, 0 * y[t])]}
    later = lemma(k, always(t, y[t + 1] == 0))
    assert accepts(forall(t, 1, n, y[t] == 0), generic_index(later, uses=[use(0, k=0, t=t - 1)]), **over)
    assert not accepts(forall(t, 0, n, y[t] == 0), generic_index(later, uses=[use(0, k=0, t=t - 1)]), **over)
    assert not accepts(always(t, y[t] == 0), generic_index(lemma(k, always(t, y[t] == 0), uses=[use(0, k=k, t=t)])), **over)


def test_a_definition_is_used_from_its_start_on():
    """y_0 = g is no step; y_t = 2 y_(t-1) is, for t > 0."""
    over = {"sizes": ["n"], "over": {"g": scalar()}, "where": [rec(y, t, g, 2 * y[t])]}
    assert accepts(forall(t, 1, n, y[t] == 2 * y[t - 1]), generic_index(whole=[y], uses=[use(y, t)]), **over)
    assert not accepts(forall(t, 0, n, y[t] == 2 * y[t - 1]), generic_index(whole=[y], uses=[use(y, t)]), **over)
    assert not accepts(forall(t, 1, n, y[t] == 3 * y[t - 1]), generic_index(whole=[y], uses=[use(y, t)]), **over)


def test_the_base_does_not_lean_on_the_lemma_itself():
    """Uses of a base are of what was shown before."""
    over = {"sizes": ["n"], "over": {"g": scalar()}, "where": [rec(y, t, g, y[t])]}
    assert not accepts(always(t, y[t] == 0), generic_index(lemma(t, y[t] == 0, base=[use(0, t=0)], uses=[use(0, t=t)]), uses=[use(0, t=t)]), **over)


def test_a_rule_holds_up_to_its_bound():
    """x_0 = .. = x_n = 0 and x_(n+1) = 1: a rule up to n says nothing about n + 1, nor does one of another name."""
    over = {"sizes": ["n"], "over": {"g": scalar()}, "where": [rec(x, k, 0, when(k >= n, 1, x[k])), rec(y, k, 0, x[k + 1] + 0 * y[k])]}
    zero = lemma(k, forall(u, k, n, x[k] == 0), rule=True)
    assert accepts(forall(t, 0, n, x[t] == 0), generic_index(zero), **over)
    assert not accepts(forall(t, 0, n + 1, x[t] == 0), generic_index(zero), **over)
    assert not accepts(always(t, x[t] == 0), generic_index(lemma(k, x[k] == 0, rule=True)), **over)
    assert not accepts(forall(t, 0, n, x[t] == 0), generic_index(lemma(k, forall(u, k, n, x[k] == y[u]), rule=True)), **over)
    second = lemma(k, forall(u, k, n, y[k] == 0), rule=True)  # y_k = x_k for k > 0
    assert accepts(forall(t, 0, n, y[t] == 0), generic_index(zero, second), **over)
    assert not accepts(forall(t, 0, n + 1, y[t] == 0), generic_index(zero, second), **over)


def test_a_rule_for_all_t():
    """A rule X(t, k) = term is one for every t >= 0, shown by induction on k."""
    over = {"sizes": ["n"], "over": {"x": signal(0)}, "where": [function(y, [t, k], when(k == 0, x[t], y(t, k - 1)))]}
    constant = lemma(k, always(t, y(t, k) == x[t]), rule=True)
    assert accepts(forall(t, 0, n, y(t, n) == x[t]), generic_index(constant), **over)
    assert not accepts(forall(t, 0, n, y(t, n) == x[n]), generic_index(constant), **over)
    assert not accepts(forall(t, 0, n, y(t, n) == x[t]), generic_index(lemma(k, always(t, y(t, k) == x[t + 1]), rule=True)), **over)


def test_a_closed_function_is_opened_by_a_use():
    """A function of an index that is kept closed has the value that its definition says, and no other."""
    over = {"sizes": ["n"], "over": {"g": scalar(), "x": signal(0)}, "where": [function(c, [k], 2 * g * x[k])]}
    assert accepts(forall(t, 0, n, c(t) == 2 * g * x[t]), generic_index(closed=[c], uses=[use(c, t)]), **over)
    for says in (forall(t, 0, n, c(t) == 3 * g * x[t]), forall(t, 0, n, c(t) == 2 * g * x[t + 1])):
        assert not accepts(says, generic_index(closed=[c], uses=[use(c, t)]), **over)


# ---------------------------------------------------------------------- determinants
def test_a_determinant_by_triangular_factors():
    """det of a product of a unit lower and an upper triangular matrix."""
    upper = matrix_of(i, j, n, n, when(i == j, y[i], when(j == i + 1, x[i], 0)))
    whole = {**TRIANGULAR, "where": [let(M, upper)]}
    right = fact(t, "det", det(M) == prod(k, 1, n, y[k]), Identity(n))
    assert accepts(det(M) == prod(k, 1, n - 1, y[k]) * y[n], generic_index(right, uses=[use(0, t=0)]), **whole)
    for wrong in (fact(t, "det", det(M) == prod(k, 1, n, x[k]), Identity(n)), fact(t, "det", det(M) == prod(k, 1, n - 1, y[k]), Identity(n)),
                  fact(t, "det", det(M) == prod(k, 0, n, y[k]), Identity(n)), fact(t, "det", det(M) == prod(k, 1, n, 2 * y[k]), 2 * Identity(n)),
                  fact(t, "det", det(M) == prod(k, 1, n, y[k]), matrix_of(i, j, n, n, when(i == j, 1, when(i == j + 1, 1, 0))))):
        assert not accepts(det(M) == det(M), generic_index(wrong), **whole)


# ---------------------------------------------------------------------- inverses
def test_an_inverse_is_found_by_its_product():
    """inv(L) of a unit bidiagonal matrix with equal entries below the diagonal, from LB = 1; a wrong one is not."""
    whole = {"sizes": ["n"], "over": {"x": scalar()}, "where": [let(M, matrix_of(i, j, n, n, when(i == j, 1, when(i == j + 1, 0 * x, 0))))], "given": SOME}
    assert accepts(inv(M) == Identity(n), generic_index(fact(t, "solve", inv(M) == Identity(n)), uses=[use(0, t=0, row=row, column=sym("column"))]), **whole)
    assert not accepts(inv(M) == 2 * Identity(n), generic_index(fact(t, "solve", inv(M) == 2 * Identity(n))), **whole)
    assert not accepts(inv(M) == Identity(n + 1), generic_index(fact(t, "solve", inv(M) == Identity(n + 1))), **whole)


def test_what_an_inverse_says_is_not_used_where_there_is_none():
    """0 x = 0 and 0 y = 0 are solved by every x and y: that inv(0) 0 is both says nothing about x and y."""
    whole = {"sizes": ["n"], "over": {"x": vector(n), "y": vector(n)}, "where": [let(M, matrix_of(i, j, n, n, 0))], "given": SOME}
    both = [fact(t, "solve", inv(M) * Zero(n, 1) == v) for v in (x, y)]
    uses = [use(v, t=0, row=row) for v in (0, 1)]
    assert accepts(inv(M) * Zero(n, 1) == x, generic_index(*both, uses=uses), **whole)  # a claim about what has no value is empty
    assert not accepts(x == y, generic_index(*both, uses=uses), **whole)
    assert not accepts(eq(x[1], y[1]), generic_index(*both, uses=[use(v, t=0, row=1) for v in (0, 1)]), **whole)
    through = lemma(t, x[1] == y[1], direct=True, uses=[use(v, t=0, row=1) for v in (0, 1)])
    assert not accepts(x[1] == y[1], generic_index(*both, through, uses=[use(2, t=0)]), **whole)


def entries(high, left, right, product):
    """A fact about products, for the first column."""
    return forall(i, 1, high, sum_of(k, 1, n, left[i, k] * right[k, 1]) == product[i, 1])


def test_a_product_by_its_entries():
    """A sum over all entries is that of the product; one that is not over all, or of other entries, is not, nor is a multiple by a number."""
    over = {"sizes": ["n"], "over": {"F": matrix(n, n), "g": vector(n), "h": vector(n)}, "given": SOME}
    says, at_i = entries(n, F, g, F * g), {"uses": [use(0, t=0, i=i, j=j)]}
    assert accepts(forall(i, 1, n, sum_of(k, 1, n, F[i, k] * g[k]) == (F * g)[i]), generic_index(fact(t, "product", says), uses=[use(0, t=0, i=i)]), **over)
    assert not accepts(says, generic_index(), **over)
    for wrong in (forall(i, 1, n, sum_of(k, 1, n - 1, F[i, k] * g[k, 1]) == (F * g)[i, 1]),
                  forall(i, 1, n, sum_of(k, 2, n, F[i, k] * g[k, 1]) == (F * g)[i, 1]),
                  forall(i, 1, n, sum_of(k, 1, n, F[k, i] * g[k, 1]) == (F * g)[i, 1]), entries(n, F, h, F * g), entries(n, F, g, T(F) * g),
                  entries(n + 1, F, g, F * g), forall(i, 0, n, sum_of(k, 1, n, F[i, k] * g[k, 1]) == (F * g)[i, 1]),
                  forall(i, 1, n, forall(j, 1, 1, sum_of(k, 1, 1, (T(g) * h)[1, k] * F[k, j]) == ((T(g) * h) * F)[1, j])),
                  forall(i, 1, n, sum_of(k, 1, n, F[i, k] * (F**k * g)[k, 1]) == (F * (F**i * g))[i, 1]),
                  always(i, sum_of(k, 1, n, F[i, k] * g[k, 1]) == (F * g)[i, 1])):
        assert not accepts(wrong, generic_index(fact(t, "product", wrong), **at_i), **over)
    unlike = {"sizes": ["n", "m"], "over": {"F": matrix(m, n), "g": vector(n)}, "given": SOME}
    for wrong in (entries(n, F, g, F * g), forall(i, 1, n, sum_of(k, 1, m, T(F)[i, k] * g[k, 1]) == (T(F) * g)[i, 1])):
        assert not accepts(wrong, generic_index(fact(t, "product", wrong), uses=[use(0, t=0, i=i)]), **unlike)
    assert accepts(entries(m, F, g, F * g), generic_index(fact(t, "product", entries(m, F, g, F * g)), uses=[use(0, t=0, i=i)]), **unlike)


def test_a_rectangular_matrix_has_no_inverse():
    """M x = v does not give inv(M) v = x for other shapes."""
    whole = {"sizes": ["n", "m"], "over": {"x": vector(n)}, "where": [let(M, matrix_of(i, j, m, n, 0))], "given": SOME}
    assert not accepts(inv(M) * Zero(m, 1) == x, generic_index(fact(t, "solve", inv(M) * Zero(m, 1) == x), uses=[use(0, t=0, row=row)]), **whole)


# ---------------------------------------------------------------------- characteristic polynomials
def test_characteristic_polynomial_of_a_companion_matrix():
    """The certificate of the right one, and of wrong ones."""
    matrix_, good = J - a * T(h), (j, Z ** (n - j))
    says = charpoly(matrix_) == POLY
    uses = [use(0, t=0, z=z)]
    assert accepts(says, generic_index(fact(t, "charpoly", says, good), uses=uses), **COMPANION, given=SOME)
    assert not accepts(says, generic_index(fact(t, "charpoly", says, good), uses=uses), **COMPANION)  # n = 0
    for wrong, row_ in ((charpoly(J + a * T(h)) == POLY, good), (charpoly(matrix_) == POLY + 1, good), (charpoly(matrix_) == 2 * POLY, (j, 2 * Z ** (n - j))),
                        (charpoly(2 * J - a * T(h)) == POLY, good), (says, (j, Z ** (n + 1 - j))), (charpoly(J - a * T(h) + T(J) * T(J)) == POLY, good),
                        (charpoly(T(matrix_)) == POLY, good)):
        assert not accepts(says, generic_index(fact(t, "charpoly", wrong, row_), uses=uses), **COMPANION, given=SOME)


# ---------------------------------------------------------------------- coefficients at infinity
def test_coefficients_at_infinity():
    """1/(z - b): b^(k-1); a wrong denominator, degree, range or coefficient is refused."""
    over = {"sizes": ["n"], "over": {"b": scalar()}, "where": [rec(x, k, 1, b * x[k]), function(c, [k], when(k == 0, 0, x[k - 1]))]}
    says = forall(k, 0, n, laurent(1 / (Z - b), k) == c(k))
    right = fact(t, "laurent", says, 1, uses=[use(x, k - 1)])
    assert accepts(forall(k, 0, n, laurent(1 / (Z - b), k) == c(k)), generic_index(right, uses=[use(0, t=0, k=k)]), **over)
    assert not accepts(forall(k, 0, n + 1, laurent(1 / (Z - b), k) == c(k)), generic_index(right, uses=[use(0, t=0, k=k)]), **over)
    for wrong in (fact(t, "laurent", forall(k, 0, n, laurent(1 / (2 * Z - b), k) == c(k)), 1), fact(t, "laurent", says, 2),
                  fact(t, "laurent", says, 0),
                  fact(t, "laurent", forall(k, 0, n, laurent(Z / (Z - b), k) == c(k)), 1),
                  fact(t, "laurent", forall(k, 0, n, laurent(1 / (Z - b), k) == x[k]), 1),
                  fact(t, "laurent", forall(k, 1, n, laurent(1 / (Z - b), k) == c(k)), 1)):
        assert not accepts(says, generic_index({**wrong, "uses": right["uses"]}, uses=[use(0, t=0, k=k)]), **over)


def test_all_coefficients_at_infinity():
    """1/(z - b) at every k, without a bound; a wrong denominator, degree or first index, or other coefficients from some k on, are refused."""
    over = {"sizes": ["n"], "over": {"b": scalar()}, "where": [
        rec(x, k, 1, b * x[k]), function(c, [k], when(k == 0, 0, x[k - 1])), function(a, [k], when(k > 5, 2, 1) * c(k))]}
    says = always(k, laurent(1 / (Z - b), k) == c(k))
    right = fact(t, "laurent", says, 1, uses=[use(x, k - 1)])
    at_k = {"uses": [use(0, t=0, k=k)]}
    assert accepts(says, generic_index(right, **at_k), **over)
    assert accepts(forall(k, 0, n + 1, laurent(1 / (Z - b), k) == c(k)), generic_index(right, **at_k), **over)
    assert not accepts(says, generic_index(fact(t, "laurent", forall(k, 0, n, laurent(1 / (Z - b), k) == c(k)), 1, uses=[use(x, k - 1)]), **at_k), **over)
    for wrong in (fact(t, "laurent", always(k, laurent(1 / (2 * Z - b), k) == c(k)), 1), fact(t, "laurent", says, 2), fact(t, "laurent", says, 0),
                  fact(t, "laurent", always(k, laurent(1 / (Z - b), k) == x[k]), 1), fact(t, "laurent", always(k, laurent(1 / (Z - b), k) == a(k)), 1),
                  fact(t, "laurent", always(k, laurent(1 / (Z - b), k + 1) == x[k]), 1), fact(t, "laurent", always(t, laurent(1 / (Z - b), t) == c(t)), 1)):
        assert not accepts(wrong["says"], generic_index({**wrong, "uses": right["uses"]}, **at_k), **over)
        assert not accepts(says, generic_index({**wrong, "uses": right["uses"]}, **at_k), **over)


# ---------------------------------------------------------------------- values of polynomials at a matrix
def test_a_polynomial_of_a_matrix():
    """h'p(F)g is the sum of p_k h'F^k g for a polynomial whose degree is known, and for no other."""
    over = {"sizes": ["n"], "over": {"F": matrix(n, n), "h": vector(n), "g": vector(n), "x": signal(0)}, "given": SOME,
            "where": [rec(p, t, 1, Z * p[t] + x[t])]}
    says = forall(t, 0, n, T(h) * substitute(p[t], F) * g == sum_of(k, 0, t, coeff(p[t], k) * (T(h) * F**k * g)))
    assert accepts(says, generic_index(supported=[p]), **over)
    assert not accepts(says, generic_index(), **over)
    for wrong in (forall(t, 0, n, T(h) * substitute(p[t], F) * g == sum_of(k, 0, t, coeff(p[t], k) * (T(h) * F ** (k + 1) * g))),
                  forall(t, 0, n, T(h) * substitute(p[t], F) * g == sum_of(k, 1, t, coeff(p[t], k) * (T(h) * F**k * g))),
                  forall(t, 0, n, T(h) * substitute(p[t], F) * g == sum_of(k, 0, t, coeff(p[t], k) * (T(g) * F**k * h)))):
        assert not accepts(wrong, generic_index(supported=[p]), **over)


def test_terms_are_told_apart_by_their_indices():
    """det(M_t) and det(M_(t+1)) are two numbers; an index bound inside is not that outside."""
    over = {"sizes": ["n"], "over": {"x": signal(0)}, "where": [function(M, [t], matrix_of(i, j, t, t, x[i + j]))]}
    assert accepts(forall(t, 0, n, det(M(t)) == det(M(t + 1 - 1))), generic_index(), **over)
    assert not accepts(forall(t, 0, n, det(M(t)) == det(M(t + 1))), generic_index(), **over)
    inside = sum_of(i, 0, 3, det(matrix_of(j, k, n, n, x[i]))).tree
    _, places, free = without_indices(_lists(inside))
    assert ["sym", "i"] not in places and ["sym", "n"] in places and not free
    _, _, free = without_indices(_lists(det(matrix_of(j, k, n, n, x[i + j] * a)).tree))
    assert free == {"i", "a"}  # nothing outside may bind these


def _lists(tree):
    return [_lists(v) for v in tree] if isinstance(tree, tuple) else tree


# ---------------------------------------------------------------------- the theorem of Cayley and Hamilton
def test_a_matrix_is_a_zero_of_its_characteristic_polynomial():
    """h'chi(F) g = 0 gives h'F^n g; nothing else of the same look is granted."""
    made = {"sizes": ["n"], "over": {F: matrix(n, n), M: matrix(n, n), h: vector(n), g: vector(n)}, "given": SOME}

    def seen(A, last, power):
        return sum_of(k, 0, last, coeff(charpoly(F), k) * (T(h) * A**power * g))

    def said(total, zero, leading):
        return fact(t, "cayley", (total == zero) & (leading == 1))

    goal = (T(h) * F**n * g)[1, 1] == -sum_of(k, 0, n - 1, coeff(charpoly(F), k) * (T(h) * F**k * g)[1, 1])
    one, leading, uses = Zero(1, 1), coeff(charpoly(F), n), [use(0, t=0, row=1, column=1)]
    assert accepts(goal, generic_index(said(seen(F, n, k), one, leading), uses=uses), **made)
    wrong = [said(seen(F, n + 1, k), one, coeff(charpoly(F), n + 1)), said(seen(M, n, k), one, leading), said(seen(F, n, k + 1), one, leading),
             said(seen(F, n, k), Zero(1, n), leading), said(seen(F, n, k), one, coeff(charpoly(F), n - 1)), said(seen(F, n, k), one, coeff(charpoly(M), n)),
             said(sum_of(k, 1, n, coeff(charpoly(F), k) * (T(h) * F**k * g)), one, leading),
             said(sum_of(k, 0, n, coeff(charpoly(F), k) * (T(h) * F**k * M**k * g)), one, leading),
             said(sum_of(k, 0, n, coeff(charpoly(F), k) * (T(h) * F**k * F**k * g)), one, leading),
             said(sum_of(k, 0, n, coeff(charpoly(F), k) * (k * F**k)), Zero(n, n), leading), said(sum_of(k, 0, n, 1), one, leading),
             fact(t, "cayley", (seen(F, n, k) == one) & (leading == 2)), fact(t, "cayley", seen(F, n, k) == one)]
    for lemma_ in wrong:
        assert not accepts(goal, generic_index(lemma_, uses=uses), **made), lemma_
    assert not accepts(leading == 0, generic_index(said(seen(F, n, k), one, leading), uses=uses), **made)


# ---------------------------------------------------------------------- the matrix determinant lemma
def test_a_transfer_function_is_a_quotient_of_characteristic_polynomials():
    """For matrices without z, of fitting sizes; nothing else of the same look is granted."""
    made = {"sizes": ["n"], "over": {F: matrix(n, n), M: matrix(n, n), h: vector(n), g: vector(n)}, "given": SOME}

    def transfer(A, u=h, v=g):
        return T(u) * inv(Identity(n) * Z - A) * v

    def said(left, right):
        return fact(t, "resolvent", left == right)

    right = charpoly(F - g * T(h)) - charpoly(F)
    goal = transfer(F) == right / charpoly(F)
    by = {"in_values": True, "uses": [use(0, t=0)]}
    true = said(charpoly(F) * transfer(F), right)
    assert accepts(goal, generic_index(true, **by), **made)
    assert not accepts(transfer(F) == right / charpoly(M), generic_index(true, **by), **made)
    assert not accepts(transfer(F) == -right / charpoly(F), generic_index(true, **by), **made)
    row_ = T(h) * inv(Identity(n) * Z + F) * g
    wrong = [said(charpoly(M) * transfer(F), right), said(charpoly(F) * transfer(M), right), said(charpoly(F) * transfer(F, g, h), right),
             said(charpoly(F) * row_, right), said(charpoly(F) * transfer(F), charpoly(F + g * T(h)) - charpoly(F)),
             said(charpoly(F) * transfer(F), charpoly(F - h * T(g)) - charpoly(F)), said(charpoly(F) * transfer(F), charpoly(F) - charpoly(F - g * T(h))),
             said(charpoly(F) * transfer(F), charpoly(F - g * T(h)) - charpoly(M)), said(transfer(F), right), said(charpoly(F), right),
             said(charpoly(F) * transfer(Z * F), right), said(charpoly(F) * (T(h) * inv(Identity(n + 1) * Z - F) * g), right),
             said(charpoly(F) * (T(h) * inv(Identity(n) - F) * g), right), said(Z, Z), said(charpoly(F) * transfer(F), 0 * Z)]
    for lemma_ in wrong:
        assert not accepts(goal, generic_index(lemma_, **by), **made), lemma_
    z_inside = said(charpoly(Z * F) * transfer(Z * F), charpoly(Z * F - g * T(h)) - charpoly(Z * F))
    assert not accepts(transfer(Z * F) == charpoly(Z * F - g * T(h)) / charpoly(Z * F) - 1, generic_index(z_inside, **by), **made)
    wide = {"sizes": ["n"], "over": {F: matrix(n, n), h: matrix(n, 2), g: matrix(n, 2)}, "given": SOME}  # then it is no number
    assert not accepts(charpoly(F) * transfer(F) == right, generic_index(true, **by), **wide)


def test_functions_of_z_that_are_not_opened():
    """At 1/z they have other values; a characteristic polynomial is not zero, a transfer function may be."""
    made = {"sizes": ["n"], "over": {F: matrix(n, n), h: vector(n), g: vector(n), c: scalar()}, "given": SOME}
    transfer = T(h) * inv(Identity(n) * Z - F) * g
    assert accepts(c * transfer == transfer * c, generic_index(in_values=True), **made)
    for says in (transfer == recip(transfer), charpoly(F) == recip(charpoly(F)), charpoly(F) == charpoly(T(F)),
                 transfer == T(g) * inv(Identity(n) * Z - F) * h):
        assert not accepts(says, generic_index(in_values=True), **made)
    assert accepts(c / charpoly(F) * charpoly(F) == c, generic_index(in_values=True), **made)
    assert not accepts(c / transfer * transfer == c, generic_index(in_values=True), **made)
    assert not accepts(c / (charpoly(F) - 1) * (charpoly(F) - 1) == c, generic_index(in_values=True), **made)
