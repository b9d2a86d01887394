# SPDX-License-Identifier: MIT
"""Orbits with multiple zeros of D beside others: valuations, or sizes, exclude late escapes, and never one that happens."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from flint import fmpq, fmpq_poly

from exactkf.dynamics.dominance import bounds, dominating
from exactkf.dynamics.every_order import _case, _fractions, decide
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.orbit_dominated import Powers, last_escape, last_zero, last_zero_by_size, power_sums, sum_of_powers
from exactkf.kernel.orbit_polynomial import determinants
from exactkf.kernel.replay import Rejected, replay
from exactkf.theory.orbits import first_escape
from tests.dynamics.test_every_order import edited, small, times, with_spectrum

#: factors of z^m D with roots of unity, some of them multiple; a palindrome a z^2 + b z + a stands beside them
UNITY = [[[1, -1], [1, -1]], [[1, 1], [1, 1]], [[1, -1], [1, -1], [1, 1], [1, 1]], [[1, 1, 1], [1, 1, 1]]]
WANDERS = "not convergent, not periodic"


def starts(count, seed=6):
    """Rational starts with such spectra and a zero on the circle that is no root of unity."""
    rng, found = random.Random(seed), []
    while len(found) < count:
        a = rng.randint(2, 9)
        chi = [fmpq(a), fmpq(rng.choice([x for x in range(1 - 2 * a, 2 * a) if x % a]), 1), fmpq(a)]
        for f in UNITY[len(found) % len(UNITY)]:
            chi = times(chi, [fmpq(c) for c in f])
        made = with_spectrum(rng, chi[len(chi) // 2:])
        if made is not None:
            found.append(made)
    return found


def dominated(count, seed=6):
    """Certificates of this kind, with their starts."""
    found = [(a, g, answer.certificate) for a, g in starts(count, seed) if "dominated" in (answer := decide(a, g)).certificate["evidence"]]
    assert 2 * len(found) > count
    return found


def test_they_are_decided_as_stepping_says():
    """All are decided; the certificates replay, and none of the orbits escapes in many steps."""
    for a, g in starts(16):
        answer = decide(a, g)
        assert answer.behaviour in ("escapes", WANDERS) and not answer.is_open
        replay(answer.certificate)
        assert answer.escape == first_escape(a, g, 300)


def test_the_case_that_was_open():
    """D = (z - 1)^2 (6 z^2 - 11 z + 6) up to a factor."""
    answer = decide([fmpq(-7, 3), fmpq(4, 3)], [fmpq(-1, 2), fmpq(1)])
    assert (answer.behaviour, answer.never_escapes, answer.torus_dimension, answer.reason) == (WANDERS, True, 1, "")
    assert answer.certificate["evidence"]["dominated"]["prime"] == 2
    replay(answer.certificate)


def test_evidence_with_an_entry_changed_is_rejected():
    """Other primes, other sums of powers, another order of them, fewer classes, another modulus."""
    for _, _, certificate in dominated(4):
        there = ("evidence", "dominated")
        evidence = certificate["evidence"]["dominated"]
        p, classes = evidence["prime"], evidence["classes"]
        (M, C), *others = classes[0]
        wrong = [(("prime",), x) for x in (1, 4, p * p, 10**9 + 7, -p, str(p), None)]
        wrong += [(("classes",), x) for x in ([], classes[1:], [*classes, classes[0]], [[]] * len(classes))]
        wrong += [(("classes", 0), x) for x in ([*others, [M, C]], [[M, C]], others, [[M, C], *others, [M, C]])]
        wrong += [(("classes", 0, 0, 0), x) for x in (M[:-1], [*M, "0"], [*M[:-1], "2"], ["0", *M[1:]], [str(Fraction(M[0]) + p), *M[1:]])]
        wrong += [(("classes", 0, 0, 1), x) for x in (C[:-1], C[::-1], [row[:-1] for row in C], [["0" for _ in row] for row in C])]
        wrong += [(("classes", 0, 0, 1, 0, 0), str(Fraction(C[0][0]) + 1)), (("modulus",), 2), (("modulus",), 1), (("modulus",), "5")]
        for path, value in wrong:
            with pytest.raises(Rejected):
                replay(edited(certificate, (*there, *path), value))
                pytest.fail(f"accepted: {path}, {value}")


def escaping(rng, n, steps):
    """A pair of order n that escapes at that step, or earlier: Q(1) = S(1) gives D a double zero at 1; then steps back."""
    Q, S = [*(small(rng, 6, 3) for _ in range(n)), fmpq(1)], [*(small(rng, 6, 3) for _ in range(n - 1)), fmpq(rng.choice((1, -1))), fmpq(0)]
    S[0] += sum(Q) - sum(S)
    for _ in range(steps):
        if Q[0] == 0 or S[0] ** 2 == Q[0] ** 2:
            return None
        c = -S[0] / Q[0]
        Q, S = [x + c * y for x, y in zip(Q, S, strict=True)], [*(y + c * x for x, y in zip(Q[1:], S[1:], strict=True)), fmpq(0)]
    return [x - y for x, y in zip(Q, S, strict=True)][-2::-1], S[-2::-1]


def test_the_bound_is_behind_every_escape():
    """Orbits that escape after a while have such sums of powers as well: the determinant that vanishes comes before the bound."""
    rng, tried = random.Random(8), 0
    for k in range(120):
        found = escaping(rng, 2 + k % 2, rng.randint(1, 12))
        if found is None:
            continue
        escape = first_escape(*found, 20)
        case = _case(*found)
        if case.reduced.escape is None and len(case.reduced.Q) > 1:
            pair = _fractions(case.reduced.Q), _fractions(case.reduced.S), fmpq_poly(list(case.D)).numer()
            for _, steps in bounds(*pair):
                tried += 1
                assert steps > escape - case.reduced.start + 2
            assert dominating(*pair) is None and decide(*found).escape == escape
    assert tried > 10


def test_evidence_of_another_orbit_is_rejected():
    """The sums of powers of one orbit are not those of another."""
    for _, _, certificate in dominated(3):
        question = certificate["statement"]["question"]
        for other in [x["statement"]["question"] for _, _, x in dominated(8) if x["statement"]["question"] != question]:
            with pytest.raises(Rejected):
                replay(edited(certificate, ("statement", "question"), other))


def test_a_planted_zero_is_before_the_bound():
    """F(-t) = 0 at a chosen t, as the constant is made to fit: the bound is larger."""
    rng = random.Random(2)
    for _ in range(200):
        p, t = rng.choice((2, 3, 5)), rng.randint(1, 60)
        M = [Fraction(1), Fraction(rng.choice([x for x in range(-9, 10) if x % p]), p ** rng.randint(1, 2)), Fraction(1)]
        C = [[Fraction(rng.randint(-9, 9), rng.randint(1, 4)) for _ in range(2)] for _ in range(rng.randint(1, 3))]
        if not any(map(any, C)):
            continue
        sums = power_sums(M, t + 1)  # 1 / y is a zero with y
        value = sum(c * (-t) ** k * sums[abs(t - b)] for k, row in enumerate(C) for b, c in enumerate(row))
        parts = [Powers(M, C), Powers([Fraction(-1), Fraction(1)], [[-value]])]
        try:
            assert last_zero(parts, p) > t
        except Undefined as error:  # a coefficient that is zero for every t
            assert "zero" in str(error)


#: spectra with no zero on the circle but roots of unity, some double
OFF_CIRCLE = [[[1, 0, 1], [1, -1, -1], [1, 1, -1], [1, -1], [1, -1]],
              [[1, 1, 2], [2, 1, 1], [1, -1, 1], [1, -1], [1, -1]], [[1, -1, 1], [1, 3, 1], [1, 1], [1, 1]]]


def off_circle():
    """Starts with these spectra."""
    rng = random.Random(1)
    for spectrum in OFF_CIRCLE:
        chi = [fmpq(1)]
        for f in spectrum:
            chi = times(chi, [fmpq(c) for c in f])
        yield next(made for _ in range(50) if (made := with_spectrum(rng, chi[len(chi) // 2:])))


def test_a_power_that_is_the_largest_in_size():
    """Such orbits are decided; other radii, and other sums of powers, are rejected."""
    for a, g in off_circle():
        answer = decide(a, g)
        assert (answer.behaviour, answer.never_escapes, answer.torus_dimension) == (WANDERS, True, 0) and first_escape(a, g, 300) is None
        certificate, there = answer.certificate, ("evidence", "dominated")
        replay(certificate)
        if len(a) > 3:
            continue
        evidence = certificate["evidence"]["dominated"]
        lo, hi = evidence["radii"]
        for path, value in ((("radii",), [hi, lo]), (("radii",), [lo, lo]), (("radii",), ["0", hi]), (("radii",), [lo, "5"]), (("radii",), ["1/1000", hi]),
                            (("radii",), [lo]), (("radii",), [f"-{lo}", hi]), (("classes", 0, 0, 1, 0, 0), "7"), (("classes",), evidence["classes"][:-1])):
            with pytest.raises(Rejected):
                replay(edited(certificate, (*there, *path), value))
                pytest.fail(f"accepted: {path}, {value}")


def test_a_planted_zero_is_before_the_bound_in_size():
    """The same at the real absolute value, with two real zeros, of which the smaller one dominates."""
    rng = random.Random(3)
    for _ in range(100):
        t, b = rng.randint(1, 60), rng.randint(3, 9)
        M = [Fraction(1), Fraction(rng.choice((b, -b))), Fraction(1)]
        C = [[Fraction(rng.randint(-9, 9), rng.randint(1, 4)) for _ in range(2)] for _ in range(rng.randint(1, 3))]
        sums = power_sums(M, t + 1)
        value = sum(c * (-t) ** k * sums[abs(t - b)] for k, row in enumerate(C) for b, c in enumerate(row))
        if any(map(any, C)):
            parts = [Powers(M, C), Powers([Fraction(-1), Fraction(1)], [[-value]])]
            assert last_zero_by_size(parts, Fraction(1, 2), Fraction(3, 4)) > t
            for radii in ((Fraction(1, 20), Fraction(3, 4)), (Fraction(1, 2), Fraction(2)), (Fraction(3, 4), Fraction(1, 2))):
                with pytest.raises(Undefined):
                    last_zero_by_size(parts, *radii)


def test_where_no_zero_dominates():
    """Two zeros of the largest valuation, one twice, or the largest one in another polynomial; at the right prime there is a bound."""
    def fraction_poly(*c): return [Fraction(x) for x in c]

    one = Powers(fraction_poly(-1, 1), [[Fraction(1)]])
    half = Powers(fraction_poly(Fraction(-1, 2), 1), [[Fraction(1)]])
    for parts in ([Powers(fraction_poly(12, -8, 1), [[Fraction(1)] * 2])], [Powers(fraction_poly(4, -4, 1), [[Fraction(1)] * 2])],
                  [half, one], [Powers(fraction_poly(1, 1, 1), [[Fraction(1)] * 2]), half], [one, Powers(fraction_poly(-2, 1), [[Fraction(1)]])],
                  [Powers(fraction_poly(2, 0, 1), [[Fraction(1)] * 2]), one], [one, one], [one], [Powers(fraction_poly(-2, 1), [[Fraction(0)]]), one]):
        with pytest.raises(Undefined):
            last_zero(parts, 2)
    two = Powers(fraction_poly(-2, 1), [[Fraction(-64)], [Fraction(1)]])  # (s - 64) 2^s
    nothing = Powers(one.M, [[Fraction(0)]])
    assert last_zero([two, one], 2) < 100 and last_zero([two._replace(C=[[Fraction(64)], [Fraction(1)]]), nothing], 2) > 64


def test_the_parts():
    """Power sums are those of the zeros; sums of powers give the determinants, and one value that differs is noticed."""
    assert power_sums([Fraction(c) for c in (2, -3, 1)], 6) == [2**n + 1 for n in range(6)]
    assert power_sums([Fraction(c) for c in (-1, 0, 0, 1)], 7) == [3, 0, 0, 3, 0, 0, 3]
    assert sum_of_powers([Powers([Fraction(-2), Fraction(1)], [[Fraction(1)], [Fraction(3)]])], 5) == [(1 + 3 * s) * 2**s for s in range(5)]
    a, g, certificate = dominated(1)[0]
    case, evidence = _case(a, g), certificate["evidence"]["dominated"]
    Q, S = _fractions(case.reduced.Q), _fractions(case.reduced.S)
    N = len(evidence["classes"])
    parts = [Powers([Fraction(c) for c in M], [[Fraction(c) for c in row] for row in C]) for M, C in evidence["classes"][0]]
    assert sum_of_powers(parts, 12) == determinants(Q, S, 12 * N)[::N]
    with pytest.raises(Undefined, match="other sums of powers"):
        last_escape([Q[0] + 1, *Q[1:]], S, evidence)
