# SPDX-License-Identifier: MIT
"""Congruences that exclude an escape: what they say modulo primes is what stepping says, and broken ones are rejected."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import product

import pytest
from flint import fmpq

from exactkf.dynamics.every_order import decide
from exactkf.exact import sqrt_field
from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.linear import Matrix, char_coefficients
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.orbit_n import reduce_pair, start_pair
from exactkf.kernel.orbit_sieve import check_irreducible, check_never_singular, intersected, reading, step_matrix, zeros_modulo
from exactkf.kernel.replay import replay
from tests.dynamics.test_every_order import start, stepped


def times(A, B, p):
    """The product of matrices modulo p."""
    return [[sum(x * y for x, y in zip(row, column, strict=True)) % p for column in zip(*B, strict=True)] for row in A]


def order_and_zeros(q, g, p):
    """The order of S modulo p and the singular X_t, step by step."""
    m = len(q)
    S = step_matrix(q, g, p)
    eye = power = [[int(i == j) for j in range(2 * m)] for i in range(2 * m)]
    found, t = set(), 0
    while t == 0 or power != eye:
        if char_coefficients(Matrix([row[:m] for row in power[:m]]))[0] % p == 0:
            found.add(t)
        power, t = times(power, S, p), t + 1
        if t > 3000:
            return None, found
    return t, found


@pytest.mark.parametrize("m", [1, 2, 3, 4])
def test_zeros_modulo_small_primes(m):
    """The minors of small and giant steps find the singular times that stepping finds; a wrong order is rejected."""
    rng, compared = random.Random(m), 0
    while compared < 6:
        p = rng.choice((2, 3, 5, 7))
        q, g = [rng.randrange(p) for _ in range(m - 1)] + [rng.randrange(1, p)], [rng.randrange(p) for _ in range(m)]
        L, found = order_and_zeros(q, g, p)
        if L is None:
            continue
        compared += 1
        assert zeros_modulo(q, g, p, L) == found
        assert zeros_modulo(q, g, p, 2 * L) == found | {t + L for t in found}
        if L > 1:
            with pytest.raises(Undefined, match="not of order"):
                zeros_modulo(q, g, p, L + 1)


def test_an_escape_is_two_steps_before_a_singular_time():
    """The first singular X_t of an orbit that escapes comes two steps after the escape."""
    rng, seen = random.Random(1), 0
    while seen < 20:
        a, g = start(rng, rng.choice((2, 3)))
        _, escape = stepped(a, g, 12)
        Q = [fmpq(x) + fmpq(y) for x, y in zip(a, g, strict=True)][::-1] + [fmpq(1)]
        reduced = reduce_pair(Q, [fmpq(x) for x in g][::-1] + [fmpq(0)])
        if escape is None or reduced.start or reduced.escape is not None or len(reduced.Q) < 2:
            continue
        p = 2**61 - 1
        values = [int(x.p) * pow(int(x.q), -1, p) % p for x in (*reduced.Q[-2::-1], *reduced.S[-2::-1])]
        m = len(values) // 2
        S, power = step_matrix(values[:m], values[m:], p), [[int(i == j) for j in range(2 * m)] for i in range(2 * m)]
        singular = []
        for _ in range(escape + 3):
            singular.append(char_coefficients(Matrix([row[:m] for row in power[:m]]))[0] % p == 0)
            power = times(S, power, p)
        assert singular.index(True) == escape + 2
        seen += 1


def test_intersections():
    """Periodic sets are intersected as by looking at every integer."""
    rng = random.Random(2)
    for _ in range(200):
        M, L = rng.randint(1, 24), rng.randint(1, 24)
        A, B = ({t for t in range(n) if rng.random() < 0.4} for n in (M, L))
        period, left = intersected(M, A, L, B)
        assert sorted(left) == [t for t in range(period) if t % M in A and t % L in B] and period % M == period % L == 0


WANDERS = decide([fmpq(-1, 2), fmpq(1)], [fmpq(3), fmpq(1, 3)])
BEFORE = decide([fmpq(5, 4), fmpq(-2)], [fmpq(-2, 3), fmpq(1)])
R = sqrt_field(2).gen()
FIELD = decide([R / 2, 1 + R], [R.field(3), R.field(1) / 3])


def parts(answer):
    """The reduced pair and the evidence of a certificate."""
    statement, evidence = answer.certificate["statement"], answer.certificate["evidence"]
    Q, S = start_pair(statement["question"])
    if "irreducible" in evidence:
        check_irreducible(next(x.field for x in Q if hasattr(x, "field")), evidence["irreducible"])
    reduced = reduce_pair(Q, S)
    return reduced.Q, reduced.S, evidence["places"], evidence["before"]


def test_the_examples():
    """Rational data, data that come from an escape and algebraic data."""
    assert {x.behaviour for x in (WANDERS, BEFORE, FIELD)} == {"not convergent, not periodic"}
    assert parts(BEFORE)[3] == [1]
    for answer in (WANDERS, BEFORE, FIELD):
        replay(answer.certificate)
        check_never_singular(*parts(answer))


@pytest.mark.parametrize("answer", [WANDERS, BEFORE, FIELD])
def test_broken_places_are_rejected(answer):
    """A prime, a period or a residue that is another, no place at all, and too much in a place."""
    Q, S, places, before = parts(answer)
    first, rest = places[0], places[1:]
    wrong = [[], [[first[0] + 1, *first[1:]]], [[first[0], first[1] + 1, *first[2:]]], [[first[0], 0, *first[2:]]], [[*first, 1, 1]], [["7", *first[1:]]],
             [[first[0] ** 2, *first[1:]]], [[1, 1, *first[2:]]], [[first[0], float(first[1]), *first[2:]]]]
    if len(first) == 3:
        wrong += [[[*first[:2], first[2] + 1]], [first[:2]], [[*first[:2], str(first[2])]]]
    else:
        wrong += [[[*first, 1]]]
    for some in wrong:
        with pytest.raises((Undefined, TypeError, ValueError)):
            check_never_singular(Q, S, [*some, *(rest if some else [])], before)


def test_times_before_the_start_are_checked():
    """Without the escape before the start, or with another time, nothing excludes the class."""
    Q, S, places, _ = parts(BEFORE)
    for before in ([], [2], [3], [-1], [0]):
        with pytest.raises(Undefined):
            check_never_singular(Q, S, places, before)


def test_an_orbit_that_escapes_is_never_excluded():
    """No place, and no two, accept an orbit that escapes at step 3."""
    rng = random.Random(5)
    while True:
        a, g = start(rng, 2)
        Q = [Fraction(str(fmpq(x) + fmpq(y))) for x, y in zip(a, g, strict=True)][::-1] + [Fraction(1)]
        S = [Fraction(str(fmpq(x))) for x in g][::-1] + [Fraction(0)]
        reduced = reduce_pair(Q, S)
        if stepped(a, g, 5)[1] == 3 and reduced.start == 0 and len(reduced.Q) == 3:
            break
    places = []
    for p in (5, 7, 11, 13, 17, 19, 23):
        try:
            values = reading([*reduced.Q[-2::-1], *reduced.S[-2::-1]], p)
            L, _ = order_and_zeros(values[:2], values[2:], p)
        except Undefined:
            continue
        if L:
            places.append([p, L])
    assert len(places) > 1
    for some in [[x] for x in places] + [[x, y] for x, y in product(places, places)]:
        for before in ([], [1], [2]):
            with pytest.raises(Undefined):
                check_never_singular(reduced.Q, reduced.S, some, before)


# ---------------------------------------------------------------------- fields
def field_of(coefficients, lo, hi):
    """The field of a polynomial."""
    return AlgebraicField([Fraction(c) for c in coefficients], Fraction(lo), Fraction(hi))


@pytest.mark.parametrize(("coefficients", "lo", "hi"), [([-2, 0, -1, 0, 1], 1, 2), ([-4, 0, 9], 0, 1), ([6, -5, 1], 1, "5/2"), ([-35, 0, 12, 0, -1], 2, "5/2")])
def test_reducible_polynomials_are_never_called_irreducible(coefficients, lo, hi):
    """Whatever the argument."""
    field = field_of(coefficients, lo, hi)
    for n in [*range(-3, 400), 10**9, 10**30, True, "5", 5.0]:
        with pytest.raises(Undefined):
            check_irreducible(field, n)
    assert not field.irreducible


@pytest.mark.parametrize(("coefficients", "lo", "hi"), [([-2, 0, 1], 1, 2), ([1, 0, -10, 0, 1], 3, 4), ([-2, 0, 0, 1], 1, 2), ([2, 1, 1, 0, 1, -3], 1, 2)])
def test_irreducible_polynomials_have_an_argument(coefficients, lo, hi):
    """One below two hundred does, also where the polynomial is reducible modulo every prime."""
    def accepted(n):
        field = field_of(coefficients, lo, hi)
        try:
            check_irreducible(field, n)
        except Undefined:
            return False
        return field.irreducible

    assert any(accepted(n) for n in range(200))


def test_a_place_of_a_field_is_checked():
    """A residue must be a zero of the modulus of a field known to be irreducible, and a simple one to be lifted."""
    field = field_of([-2, 0, 1], 1, 2)
    x = field.element([Fraction(1), Fraction(3)])
    with pytest.raises(Undefined, match="irreducible"):
        reading([x], 7, 3)
    check_irreducible(field, next(n for n in range(5, 50) if n * n - 2 in (23, 47, 79, 167)))
    assert reading([x, Fraction(1, 2)], 7, 3) == [3, 4] and reading([x], 7, 4) == [6]
    lifted = reading([x], 7, 3, 2)[0]
    assert (pow((lifted - 1) * pow(3, -1, 49), 2, 49) - 2) % 49 == 0
    for p, root in ((7, 2), (5, 1), (9, 3), (49, 10), (7, None), (7, 3.0)):
        with pytest.raises(Undefined):
            reading([x], p, root)
    with pytest.raises(Undefined, match="simple"):
        reading([x], 2, 0, 2)
