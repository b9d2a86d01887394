# SPDX-License-Identifier: MIT
"""Congruences that exclude an escape: what they say modulo primes is what stepping says, and broken ones are rejected."""

from __future__ import annotations

import copy
import random
from contextlib import suppress
from fractions import Fraction
from itertools import islice, product

import pytest
from flint import fmpq, fmpq_poly, fmpz_mat, nmod_mat

from exactkf.dynamics.every_order import decide
from exactkf.dynamics.wandering import convergence_modulo
from exactkf.exact import sqrt_field
from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.irreducible import check_irreducible
from exactkf.kernel.linear import Matrix, char_coefficients
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.orbit_n import reduce_pair, spectral_polynomial, start_pair, states
from exactkf.kernel.orbit_sieve import (
    _alone,
    _deeper,
    _singular_before,
    check_never_singular,
    has_null_vector,
    intersected,
    intertwiner,
    reading,
    step_matrix,
    zeros_modulo,
)
from exactkf.kernel.orbit_wandering import check_never_escapes
from exactkf.kernel.replay import Rejected, digest, replay
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


#: three times in a row before the start at which X is singular, with a kernel of dimension two in the middle
THREE = decide([fmpq(-1), fmpq(0), fmpq(3)], [fmpq(-3), fmpq(0), fmpq(0)])


def test_kernels_of_dimension_two():
    """They are excluded modulo the cube of a prime, and each of the times is needed."""
    Q, S, places, before = parts(THREE)
    assert before == [3, 4, 5] and [r for _, r in _singular_before(Q, S, before)] == [1, 2, 1]
    replay(THREE.certificate)
    for some in ([3, 4], [3, 5], [4, 5], [4], [2, 3, 4]):
        with pytest.raises(Undefined):
            check_never_singular(Q, S, places, some)


def is_singular(power):
    """Whether the first half of the rows and columns is singular."""
    m = power.nrows() // 2
    return nmod_mat([[int(power[i, j]) for j in range(m)] for i in range(m)], power.modulus()).det() == 0


@pytest.mark.parametrize("p", [3, 5, 7])
def test_a_time_that_is_alone_is_so_in_steps(p):
    """No X with a time congruent to it modulo the period is singular, as far as stepping modulo a large prime goes; some are refused."""
    rng, kept, large = random.Random(p), {True: 0, False: 0}, 2**61 - 1
    while min(kept.values()) < 4 and sum(kept.values()) < 400:
        Q, S, T = escaping(rng, rng.choice((1, 2, 3)))
        with suppress(Undefined):
            q, g = Q[-2::-1], S[-2::-1]
            L, _ = order_and_zeros(reading(q, p), reading(g, p), p)
            step = nmod_mat(step_matrix(reading(q, large), reading(g, large), large), large)
            singular = [k for k in range(1, 30) if is_singular(step.inv() ** k)]
            for k, r in _singular_before(Q, S, singular) if L and max(singular, default=L) < L < 200 else ():
                found = _alone(Q, S, k, r, p, L, None)
                kept[found] += 1
                assert not found or not any(is_singular(step ** (L * s - k)) for s in range(1, 40))
                assert not found or (T + 2 + k) % L  # it escapes two steps before X is singular, at a time of another class
    assert kept[True] >= 4


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


# ---------------------------------------------------------------------- zeros of two kinds, powers of primes
#: an order for which no two primes do, and its evidence for either sign
SIGNS = decide([fmpq(1), fmpq(1, 2), fmpq(1), fmpq(1), fmpq(-5, 4)], [fmpq(5, 4), fmpq(-3, 4), fmpq(3), fmpq(-1), fmpq(-3)])
#: D without zeros of 2-adic modulus one
RESTS = decide([fmpq(-1, 4), fmpq(0), fmpq(0)], [fmpq(-2), fmpq(-1), fmpq(-1, 2)])


@pytest.mark.parametrize("m", [1, 2, 3, 4])
def test_reversed_time(m):
    """K is symmetric, AK = KA', and with R: (x; y) -> (K^-1 y; Kx) the step S has S R S = R, modulo powers of primes."""
    rng, seen = random.Random(m), 0
    while seen < 5:
        p = rng.choice((3, 5, 7))
        N = p ** rng.randint(1, 3)
        q, g = [rng.randrange(N) for _ in range(m)], [rng.randrange(N) for _ in range(m)]
        K = intertwiner(q, g, N)
        det = int(fmpz_mat(K).det())
        assert K == [list(row) for row in zip(*K, strict=True)] and K[0] == g
        if q[-1] % p == 0 or det % p == 0:
            continue
        seen += 1
        inverse = [[int(x * det) * pow(det, -1, N) % N for x in row] for row in fmpz_mat(K).inv().tolist()]
        zero = [[0] * m for _ in range(m)]
        R = [[*x, *y] for x, y in zip(zero, inverse, strict=True)] + [[*x, *y] for x, y in zip(K, zero, strict=True)]
        S = step_matrix(q, g, N)
        assert times(times(S, R, N), S, N) == R
        A = [[int(j == i + 1) - (q[i] if j == 0 else 0) for j in range(m)] for i in range(m)]
        assert times(A, K, N) == times(K, [list(row) for row in zip(*A, strict=True)], N)


@pytest.mark.parametrize(("p", "power"), [(2, 1), (2, 3), (3, 1), (3, 2)])
def test_null_vectors_modulo_powers(p, power):
    """Found exactly where one of all vectors is one."""
    rng, seen, N = random.Random(p * power), set(), p**power
    for _ in range(150):
        columns = [[rng.choice((1, 1, p)) * rng.randrange(N) % N for _ in range(3)] for _ in range(rng.choice((1, 2)))]
        some = any(all(sum(u * c[i] for u, c in zip(vector, columns, strict=True)) % N == 0 for i in range(3))
                   for vector in product(range(N), repeat=len(columns)) if any(u % p for u in vector))
        assert has_null_vector(columns, p, N) == some
        seen.add(some)
    assert seen == {True, False}


def test_evidence_for_both_signs_is_needed():
    """It replays; without a place, with the signs exchanged for one of them, or with one sign only, it does not."""
    replay(SIGNS.certificate)
    signs = SIGNS.certificate["evidence"]["signs"]
    Q, S = parts_of_question(SIGNS)
    for sign, places in zip((1, -1), signs, strict=True):
        check_never_singular(Q, S, places, [], sign)
        for k in range(len(places)):
            with pytest.raises(Undefined):
                check_never_singular(Q, S, places[:k] + places[k + 1:], [], sign)
    assert any(refused(Q, S, places, -sign) for sign, places in zip((1, -1), signs, strict=True))
    for broken in ([signs[0]], [signs[0], []], [*signs, signs[0]], None):
        changed = copy.deepcopy(SIGNS.certificate)
        changed["evidence"]["signs"] = broken
        changed["digest"] = digest(changed)
        with pytest.raises(Rejected):
            replay(changed)


def refused(Q, S, places, sign):
    """Whether the places leave a time for that sign."""
    try:
        check_never_singular(Q, S, places, [], sign)
    except Undefined:
        return True
    return False


def parts_of_question(answer):
    """The reduced pair of the question."""
    reduced = reduce_pair(*start_pair(answer.certificate["statement"]["question"]))
    return reduced.Q, reduced.S


@pytest.mark.parametrize("n", [2, 3])
def test_an_escape_stays_modulo_every_power(n):
    """The time of an escape is left, for one of the signs and always the same, modulo every power of every prime, and modulo powers the left are fewer."""
    rng, compared = random.Random(n), 0
    while compared < 6:
        a, g = start(rng, n)
        escape = stepped(a, g, 6)[1]
        Q = [Fraction(str(fmpq(x) + fmpq(y))) for x, y in zip(a, g, strict=True)][::-1] + [Fraction(1)]
        reduced = reduce_pair(Q, [Fraction(str(fmpq(x))) for x in g][::-1] + [Fraction(0)])
        if not escape or reduced.start or len(reduced.Q) < n + 1 or reduced.escape is not None:
            continue
        kinds = {1, -1}
        for p in (2, 3, 5, 7, 11):
            try:
                values = reading([*reduced.Q[-2::-1], *reduced.S[-2::-1]], p)
                L, found = order_and_zeros(values[:n], values[n:], p)
            except Undefined:
                continue
            if L is None:
                continue
            both = {sign: set(_deeper(reduced.Q, reduced.S, found, p, L, None, 0, sign)) for sign in (1, -1)}
            assert both[1] | both[-1] == found
            for depth in (0, 1, 2):
                kinds &= {sign for sign in (1, -1) if _deeper(reduced.Q, reduced.S, [escape + 2], p, L, None, depth, sign)}
                assert _deeper(reduced.Q, reduced.S, [escape + 2], p, L, None, depth, 0)
            compared += 1
        assert kinds


def escaping(rng, n):
    """A reduced pair whose orbit escapes at a step, the pair of which is stepped back from, and that step."""
    while True:
        T, S = rng.randint(0, 15), [*(Fraction(rng.randint(-3, 3), rng.choice((1, 1, 2))) for _ in range(n - 1)), Fraction(rng.choice((1, -1))), Fraction(0)]
        Q = [*(Fraction(rng.randint(-3, 3), rng.choice((1, 1, 2))) for _ in range(n)), Fraction(1)]
        for _ in range(T):
            g = -S[0] / Q[0] if Q[0] else Fraction(1)
            if g * g == 1:
                break
            Q, S = [x + g * y for x, y in zip(Q, S, strict=True)], [*(y + g * x for x, y in zip(Q, S, strict=True))][1:] + [Fraction(0)]
        else:
            reduced = reduce_pair(Q, S)
            if reduced[0] == 0 and len(reduced.Q) == n + 1 and reduced.escape is None:
                return Q, S, T


@pytest.mark.parametrize("n", [1, 2])
def test_orbits_made_to_escape_are_never_excluded(n):
    """Not by places for either sign, with multiples of their periods and any times before the start, nor by a modulus after some step."""
    rng, refusals = random.Random(n), 0
    for _ in range(20):
        Q, S, T = escaping(rng, n)
        places = []
        for p in (2, 3, 5, 7, 11, 13):
            with suppress(Undefined):
                values = reading([*Q[-2::-1], *S[-2::-1]], p)
                L, _ = order_and_zeros(values[:n], values[n:], p)
                places += [[p, L * k] for k in (1, 2, p) if L and L < 400]
        for _ in range(4 if places else 0):
            with pytest.raises(Undefined):
                for sign in (1, -1):
                    check_never_singular(Q, S, rng.choices(places, k=rng.randint(1, 4)), rng.choice(([], [1], [1, 2, 3])), sign)
            refusals += 1
        after = rng.randint(0, T)
        state = next(islice(states(Q, S), after, None))
        for N in (2, 3, 5, 7, rng.randint(8, 200)):
            with pytest.raises(Undefined):
                check_never_escapes(*([Fraction(x) / state[0][-1] for x in part] for part in state), N)
    assert refusals > 30


def test_times_modulo_a_power_are_those_of_steps():
    """What is left modulo 25 of all times is what stepping modulo 25 finds."""
    Q, S, *_ = parts(WANDERS)
    values = reading([*Q[-2::-1], *S[-2::-1]], 5, None, 2)
    L, found = order_and_zeros([x % 5 for x in values[:2]], [x % 5 for x in values[2:]], 5)
    M, expected = order_and_zeros(values[:2], values[2:], 25)
    assert 5 * L % M == 0
    every = set(_deeper(Q, S, [t + k * L for t in found for k in range(5)], 5, L, None, 1, 0))
    assert {t % M for t in every} == expected and every


def test_a_rest_modulo_a_prime_is_checked():
    """From the step on gamma vanishes modulo the prime; another step, another prime, or a step after an escape do not do."""
    by_prime, after = convergence_modulo(*parts(RESTS)[:2], fmpq_poly(spectral_polynomial(*([fmpq(str(x)) for x in p] for p in parts(RESTS)[:2]))).numer())
    certificate = copy.deepcopy(RESTS.certificate)
    evidence = certificate["evidence"]
    evidence.update(modulus=by_prime, after=after)
    certificate["digest"] = digest(certificate)
    replay(certificate)
    for name, value in (("after", evidence["after"] - 1), ("after", -1), ("after", "1"), ("modulus", evidence["modulus"] + 1), ("modulus", 1), ("after", None)):
        changed = copy.deepcopy(certificate)
        changed["evidence"][name] = value
        changed["digest"] = digest(changed)
        with pytest.raises(Rejected):
            replay(changed)


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


# ---------------------------------------------------------------------- multiple zeros beside several wandering ones
#: D with a double zero at 1 or -1 and zeros on and off the circle, none of which dominates at a prime
HARD = [([4, 1, -2], [3, -3, fmpq(-5, 2)]), ([-1, -3, 3], [3, 2, 2]), ([1, -2, 0], [-2, 2, -1])]


@pytest.mark.parametrize(("a", "g"), HARD)
def test_multiple_zeros_beside_wandering_ones(a, g):
    """They are decided by primes taken one after the other; the certificate replays, and not without places, or with others."""
    answer = decide([fmpq(x) for x in a], [fmpq(x) for x in g])
    certificate = answer.certificate
    assert answer.never_escapes and "signs" in certificate["evidence"]
    replay(certificate)
    for side, places in enumerate(certificate["evidence"]["signs"]):
        (p, L), *rest = places
        for wrong in ([], [[p, L + 1], *rest], [[p * p, L], *rest], [[p, 1], *rest], [[p + 1, L], *rest]):
            changed = copy.deepcopy(certificate)
            changed["evidence"]["signs"][side] = wrong
            changed["digest"] = digest(changed)
            with pytest.raises(Rejected):
                replay(changed)
    assert stepped([fmpq(x) for x in a], [fmpq(x) for x in g], 60)[1] is None


def test_several_places_at_a_prime():
    """Algebraic data with a multiple zero of D: where two places lie over one prime each excludes other times."""
    R = sqrt_field(3).gen()
    answer = decide([0 * R + 1 / (R - R + 3), -1 + R / 3, R / 3 - 1 / (R - R + 3)], [1 + R / 3, -1 + 2 * R, R / 3 - 2 / (R - R + 3)])
    assert answer.never_escapes
    replay(answer.certificate)
    signs = answer.certificate["evidence"]["signs"]
    assert any(len({tuple(x[:1]) for x in places}) < len(places) for places in signs)
