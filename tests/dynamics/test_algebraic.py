# SPDX-License-Identifier: MIT
"""Orbits of order two and more with algebraic data, against exact steps and steps in balls; and orbits that become periodic."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from flint import acb_poly, arb, fmpq, fmpq_poly

from exactkf.dynamics.answer import Answer
from exactkf.dynamics.enclosed_limit import EnclosedLimit
from exactkf.dynamics.every_order import decide, limit_digits
from exactkf.dynamics.exact_json import field_json
from exactkf.dynamics.torus import torus_evidence
from exactkf.exact import RealField, cyclotomic_real, sqrt_field
from exactkf.exact.balls import precision
from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.orbit_n import reduce_pair, spectral_polynomial
from exactkf.kernel.orbit_wandering import check_torus
from exactkf.kernel.replay import Rejected, replay
from exactkf.theory.fast_filter import ag_from_alpha_gamma, step_ag
from tests.dynamics.test_every_order import edited, self_product, start, stepped, times, with_spectrum

FIELDS = [sqrt_field(2), sqrt_field(5), cyclotomic_real(7), cyclotomic_real(16),
          RealField([-2, 0, 0, 1], (1, 2), "r"), RealField([1, 0, -10, 0, 1], (3, 4), "w")]


def algebraic_start(rng, n):
    """A start over a small field: generic, small, with a common factor, or one that a few exact steps lead to an escape."""
    field = rng.choice(FIELDS)

    def element():
        return field([fmpq(rng.randint(-3, 3), rng.randint(1, 3)) for _ in range(rng.choice((1, 2)))])

    kind = rng.randrange(4)
    if kind == 0 and n > 1:
        a, g = algebraic_start(rng, n - 1)
        field = a[0].field
        theta = [field(1), field(rng.randint(-2, 2))]
        return times_in([field(1), *a], theta)[1:], times_in(g, theta)
    if kind == 1:
        return [element() / 5 for _ in range(n)], [element() / 5 for _ in range(n)]
    if kind == 2:
        return [element() for _ in range(n)], [*(element() for _ in range(n - 1)), field(0)]
    return [element() for _ in range(n)], [element() for _ in range(n)]


def times_in(p, q):
    """The product of polynomials over a field."""
    out = [0 * q[0]] * (len(p) + len(q) - 1)
    for i, x in enumerate(p):
        for j, y in enumerate(q):
            out[i + j] = out[i + j] + x * y
    return out


def in_balls(a, g, steps, bits=3000):
    """The state after many steps, in balls; None if a ball of 1 - gamma^2 meets zero."""
    with precision(bits):
        a, g = ([x.enclose(bits // 4) for x in v] for v in (a, g))
        for _ in range(steps):
            r = 1 - g[0] * g[0]
            if r.contains(0):
                return None
            q = [x + y for x, y in zip(a, g, strict=True)]
            new_q = [(x - g[0] * y) / r for x, y in zip(q, [*g[1:], arb(0)], strict=True)]
            g = [(y - g[0] * x) / r for x, y in zip(q, [*g[1:], arb(0)], strict=True)]
            a = [x - y for x, y in zip(new_q, g, strict=True)]
        return a, g


def agrees(a, g, answer):
    """Exact steps meet no escape but the one named, and balls far ahead are at the limit."""
    state = (tuple(a), tuple(g))
    for t in range(6):
        if state[1][0] ** 2 == 1:
            assert (answer.behaviour, answer.escape) == ("escapes", t)
            return
        state = step_ag(*state)
    assert answer.escape is None or answer.escape >= 6
    if answer.behaviour == "converges":
        limit, far = limit_digits(answer, 40).alpha, in_balls(a, g, 400)
        if far is not None and all(x.rad() < arb(2) ** -60 for x in far[0]):
            assert all(abs(x - y) < 0.05 for x, y in zip(far[0], limit, strict=True)) and all(abs(x) < 0.05 for x in far[1])


@pytest.mark.parametrize(("n", "count"), [(2, 20), (3, 12), (4, 10)])
def test_decisions_over_fields_agree_with_steps(n, count):
    """Every decision agrees with exact steps and with balls, and its certificate replays."""
    rng, seen = random.Random(n), set()
    for _ in range(count):
        a, g = algebraic_start(rng, n)
        answer = decide(a, g, max_steps=400)
        agrees(a, g, answer)
        replay(answer.certificate)
        seen.add(answer.behaviour)
    assert {"converges", "not convergent, not periodic"} <= seen


def test_the_step_in_balls_is_the_exact_step():
    """The recursion used here in balls is the filter's."""
    a, g = [FIELDS[0].gen(), FIELDS[0](2)], [FIELDS[0](3), FIELDS[0].gen() / 7]
    exact = step_ag(*step_ag(a, g))
    balls = in_balls(a, g, 2)
    assert all(x.overlaps(y.enclose(50)) for u, v in zip(balls, exact, strict=True) for x, y in zip(u, v, strict=True))


def test_an_escape_over_a_field():
    """The state before an escape is found by stepping back, and decided."""
    root = sqrt_field(3).gen()
    a, g = ag_from_alpha_gamma([root, root / 2], [root / 3, root.field(1)])
    answer = decide(a, g)
    assert (answer.behaviour, answer.escape) == ("escapes", 1)
    replay(answer.certificate)


def test_an_orbit_over_a_field_that_comes_from_an_escape():
    """The plane before the start is singular over Q(sqrt 2), and the p-adic argument decides."""
    root = sqrt_field(2).gen()
    found = None
    for k in range(2, 40):
        a, g = [root / k + 1, root.field(-2)], [root.field(fmpq(-2, 3)), root.field(1)]
        answer = decide(a, g)
        if answer.behaviour == "not convergent, not periodic" and answer.certificate["evidence"]["before"]:
            found = answer
            break
    assert found is not None
    replay(found.certificate)
    with pytest.raises(Rejected):
        replay(edited(found.certificate, ("evidence", "before"), []))


# ---------------------------------------------------------------------- limits in intervals
ROOT = sqrt_field(2).gen()
LIMIT = decide([ROOT / 4, ROOT / 8], [ROOT / 16, ROOT - ROOT])


def test_digits_of_an_enclosed_limit():
    """More digits are inside fewer, the interval of the answer is short, and the far state is there."""
    few, many = limit_digits(LIMIT, 20).alpha, limit_digits(LIMIT, 200).alpha
    assert all(x.overlaps(y) and y.rad() < arb(10) ** -200 for x, y in zip(few, many, strict=True))
    for x, y in zip(LIMIT.limit["alpha"], many, strict=True):
        lo, hi = (fmpq(*map(int, end.split("/"))) for end in x["interval"])
        assert 0 < hi - lo < fmpq(1, 10**50) and lo < y.mid().fmpq() < hi
    far = in_balls([ROOT / 4, ROOT / 8], [ROOT / 16, ROOT - ROOT], 1200)
    assert all(abs(x - y) < arb(10) ** -100 for x, y in zip(far[0], many, strict=True))


def test_zeros_on_the_circle_are_split_off():
    """D = |w|^2 with a double zero at -1 and others inside: the limit has the zero -1."""
    field = ROOT.field
    c = ROOT / 5
    w = times_in([field(1), field(1)], [field(1), c])  # leading one first
    answer = decide(*with_spectrum_in([ROOT / 3, field(1) / 4], w))
    assert answer.behaviour == "converges"
    replay(answer.certificate)
    expected = [1 + c, c]
    assert all(x.overlaps(y.enclose(40)) for x, y in zip(limit_digits(answer, 40).alpha, expected, strict=True))
    assert len(answer.certificate["evidence"]["circle"]) == 2
    with pytest.raises(Rejected):
        replay(edited(answer.certificate, ("evidence", "circle"), ["1"]))


def with_spectrum_in(a, w):
    """The state with a and D = w(z)w(1/z), up to a factor: sum_j a_j b_{j+i} + b_j a_{j+i} = 2 rho d_i with b_0 = 1."""
    n, zero = len(a), a[0] - a[0]
    d = [sum((w[j] * w[j + i] for j in range(n + 1 - i)), zero) for i in range(n + 1)]
    full = [zero + 1, *a]
    rows = []
    for i in range(n + 1):
        row = [zero] * (n + 2)
        for j in range(n + 1 - i):
            row[j + i] += full[j]
            row[j] += full[j + i]
        row[n + 1] = -2 * d[i]
        rows.append(row)
    b = solved([row[1:] for row in rows], [-row[0] for row in rows])[:n]
    return a, [(y - x) / 2 for x, y in zip(a, b, strict=True)]


def test_zeros_on_the_circle_that_do_not_split_off_are_isolated():
    """D = |f|^2 with f = z^2(x^2 - cx + 1), x = z + 1/z, irreducible over Q(sqrt 2), with a pair of zeros on the circle and a pair off it.

    The limit has the pair on the circle once, and the zero inside twice.
    """
    c = 2 * ROOT + 1
    field = ROOT.field
    a, g = with_spectrum_in([field(1) / 3, ROOT / 4, field(-1) / 5, field(1) / 7], [field(1), -c, field(3), -c, field(1)])
    answer = decide(a, g)
    assert answer.behaviour == "converges"
    replay(answer.certificate)
    assert len(answer.certificate["evidence"]["pairs"]) == 1
    with precision(400):
        off, on = ((c.enclose(100) + sign * (c.enclose(100) ** 2 - 4).sqrt()) / 2 for sign in (1, -1))
        inside = (off - (off**2 - 4).sqrt()) / 2
        expected = [arb(1)]
        for factor in ([1, -on, 1], [1, -inside], [1, -inside]):
            expected = [sum((expected[i] * factor[k - i] for i in range(len(expected)) if 0 <= k - i < len(factor)), arb(0))
                        for k in range(len(expected) + len(factor) - 1)]
        assert all(x.overlaps(y) and x.rad() < arb(10) ** -60 for x, y in zip(limit_digits(answer, 60).alpha, expected[1:], strict=True))
    lo, hi, k = answer.certificate["evidence"]["pairs"][0]
    above = str(Fraction(hi) + Fraction(1, 10**9))
    for pairs in ([], [[lo, hi, k]] * 2, [[lo, hi, 2 * k]], [[str(Fraction(lo) + 1), str(Fraction(hi) + 1), k]], [[hi, above, k]],
                  [["3", "4", k]], [[lo, hi, 0]], [["-2", "2", k]]):
        with pytest.raises(Rejected):
            replay(edited(answer.certificate, ("evidence", "pairs"), pairs))


@pytest.mark.parametrize("seed", range(4))
def test_limits_of_high_order_are_enclosed(seed):
    """Rational data of order six to nine: the interval limit holds the product over arb's zeros of D, those on the circle half as often."""
    rng = random.Random(seed)
    n = 6 + seed
    w = [fmpq(1)]
    for factor in [[fmpq(1), fmpq(1)], [fmpq(1), fmpq(-2), fmpq(1), fmpq(-2), fmpq(1)]][: seed]:  # a zero -1; Salem's polynomial of degree four
        w = times(w, factor)
    w = times(w, [fmpq(3), *(fmpq(rng.randint(-2, 2)) for _ in range(n - len(w) + 1))])
    found = with_spectrum(rng, self_product(w))
    answer = decide(*found)
    if answer.behaviour == "escapes":
        return
    assert answer.behaviour == "converges"
    replay(answer.certificate)
    assert "interval" in answer.limit["alpha"][0]
    reduced = reduce_pair([x + y for x, y in zip(*found, strict=True)][::-1] + [fmpq(1)], [*found[1][::-1], fmpq(0)])
    enclosed = EnclosedLimit.of(spectral_polynomial(reduced.Q, reduced.S), reduced.removed)
    intervals, bits, *_ = enclosed.enclosed(60)
    with precision(2000):
        expected = acb_poly([fmpq(x) for x in reduced.removed])
        for factor, multiplicity in fmpq_poly(list(enclosed.D)).numer().factor()[1]:
            for z, _ in factor.complex_roots():
                if abs(z) < 1:
                    expected *= acb_poly([-z, 1]) ** multiplicity
                elif not abs(z) > 1:  # on the circle
                    expected *= acb_poly([-z, 1]) ** (multiplicity // 2)
        assert expected.degree() == n
        assert all(arb(fmpq(lo, 1 << bits)).union(arb(fmpq(hi, 1 << bits))).overlaps(expected[n - 1 - k].real) for k, (lo, hi) in enumerate(intervals))


def solved(A, y):
    """The solution of a regular system over a field, by Gaussian elimination."""
    rows = [[*row, value] for row, value in zip(A, y, strict=True)]
    for k in range(len(rows)):
        pivot = next(i for i in range(k, len(rows)) if rows[i][k] != 0)
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        rows = [row if i == k else [x - row[k] * z for x, z in zip(row, rows[k], strict=True)] for i, row in enumerate(rows)]
    return [row[-1] for row in rows]


@pytest.mark.parametrize("change", ["narrow", "shift", "unstable", "scale", "length", "bits"])
def test_broken_enclosures_are_rejected(change):
    """An interval without the limit, and a center that is not near the stable factor."""
    certificate, evidence = LIMIT.certificate, LIMIT.certificate["evidence"]
    first = certificate["statement"]["answer"]["limit"]["alpha"][0]["interval"]
    w, c, one = evidence["center"][:-1], evidence["center"][-1], 1 << evidence["bits"]
    match change:
        case "narrow":
            broken = edited(certificate, ("statement", "answer", "limit", "alpha", 0, "interval"), [first[0], first[0]])
        case "shift":
            broken = edited(certificate, ("statement", "answer", "limit", "alpha", 0, "interval"), [first[1], "1"])
        case "unstable":  # the reversed factor, monic
            broken = edited(certificate, ("evidence", "center"), [one * one // w[0], one * w[1] // w[0], c * one // w[0] * one // w[0]])
        case "scale":
            broken = edited(certificate, ("evidence", "center"), [2 * x for x in evidence["center"]])
        case "length":
            broken = edited(certificate, ("evidence", "center"), evidence["center"][1:])
        case _:
            broken = edited(certificate, ("evidence", "bits"), 64)
    with pytest.raises(Rejected):
        replay(broken)


# ---------------------------------------------------------------------- eventually periodic
def eventual() -> tuple[list, list, Answer]:
    """A rational start of order three that has a period from step one on."""
    rng = random.Random(0)
    while True:
        a, g = start(rng, 2)
        if decide(a, g, max_steps=50).behaviour != "periodic":
            continue
        for _ in range(20):  # one step back to a state with Q(0) = 0: Q = (zQ' + gamma S')/..., here by search among such states
            q, s = [fmpq(rng.randint(-2, 2)), fmpq(rng.randint(-2, 2)), fmpq(0)], [fmpq(rng.randint(-2, 2), rng.randint(1, 2)) for _ in range(3)]
            found = decide([x - y for x, y in zip(q, s, strict=True)], s, max_steps=50)
            if found.behaviour == "eventually periodic":
                return [x - y for x, y in zip(q, s, strict=True)], s, found


def test_an_orbit_that_becomes_periodic():
    """It comes back to the step named and not to one before; its certificate says so, and no other number replays."""
    a, g, answer = eventual()
    first, period = answer.preperiod, answer.period
    assert first > 0 and period > 1 and answer.never_escapes
    states, _ = stepped(a, g, first + 2 * period)
    assert states[first + period] == states[first] and len(set(states)) == first + period
    assert f"from step {first} on" in answer.words()
    replay(answer.certificate)
    for value in (None, 0, first + 1):
        with pytest.raises(Rejected):
            replay(edited(answer.certificate, ("statement", "answer", "preperiod"), value))
    changed = edited(edited(answer.certificate, ("statement", "answer", "preperiod"), None), ("statement", "answer", "behaviour"), "periodic")
    with pytest.raises(Rejected):
        replay(changed)


def test_a_periodic_orbit_is_not_eventually_periodic():
    """An orbit that comes back to its start may not be said to come back to step zero only in the end."""
    rng = random.Random(0)
    answer = next(x for _ in range(500) if (x := decide(*start(rng, 2), max_steps=50)).behaviour == "periodic")
    replay(answer.certificate)
    changed = edited(edited(answer.certificate, ("statement", "answer", "preperiod"), 0), ("statement", "answer", "behaviour"), "eventually periodic")
    with pytest.raises(Rejected):
        replay(changed)


def test_times_is_the_same_over_fields():
    """The helper agrees with the rational one."""
    field = FIELDS[0]
    p, q = [fmpq(1), fmpq(2), fmpq(-3)], [fmpq(4), fmpq(5)]
    assert [x.rational_value() for x in times_in([field(x) for x in p], [field(x) for x in q])] == times(p, q)


# ---------------------------------------------------------------------- tori
def quadratic(x):
    """z^2 - xz + 1."""
    return [x.field(1), -x, x.field(1)]


def in_checker(p):
    """The polynomial in the numbers of the checker."""
    field = p[0].field
    modulus, lo, hi = field_json(field)
    own = AlgebraicField([Fraction(c) for c in modulus], Fraction(lo), Fraction(hi))
    return [own.element([Fraction(int(c.p), int(c.q)) for c in x.poly.coeffs()]) for x in p]


X, Y = 1 + ROOT / 3, ROOT / 5


@pytest.mark.parametrize(("factors", "dimension"), [
    ([X], 1), ([X, X * X - 2], 1), ([X, -X], 1), ([X, Y], 2), ([X, Y, Y * Y - 2], 2), ([X, 2 - ROOT / 3], 2), ([X, ROOT * 2], 1), ([ROOT.field(1), ROOT], 0),
    ([X, ROOT, ROOT.field(fmpq(6, 5))], 2), ([X, X, X, Y], 2), ([X, X, Y], 1),
])
def test_tori_over_a_field(factors, dimension):
    """Zeros and their squares or opposites are related, others not; roots of unity, real zeros and even multiplicities do not count."""
    D = [ROOT.field(1)]
    for x in factors:
        D = times_in(D, quadratic(x))
    found, evidence, reason = torus_evidence(D)
    assert (found, reason) == (dimension, "")
    check_torus(in_checker(D), dimension, evidence)
    for other in {dimension + 1, dimension - 1} - {-1}:
        with pytest.raises(Undefined):
            check_torus(in_checker(D), other, evidence)


def test_the_rational_multiple_is_checked():
    """One that D's factor does not divide, one with a double zero, an interval of a conjugate, and an interval left out are rejected."""
    D = times_in(quadratic(X), quadratic(Y))
    found, evidence, _ = torus_evidence(D)
    norm = [fmpq(*map(int, c.split("/"))) for c in evidence["norm"]]
    opposite = torus_evidence(times_in(quadratic(2 - ROOT / 3), quadratic(-Y)))[1]
    for change in ({"norm": ["1", "1"]}, {"norm": [str(c) for c in times(norm, norm)]}, {"zeros": evidence["zeros"][:1]}, {"zeros": opposite["zeros"]},
                   {"norm": [str(c) for c in times(norm, [fmpq(1), fmpq(1)])]}):
        with pytest.raises(Undefined):
            check_torus(in_checker(D), found, {**evidence, **change})
