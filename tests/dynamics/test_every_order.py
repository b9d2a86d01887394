# SPDX-License-Identifier: MIT
"""Decisions for every order against orbits stepped exactly, the examples of BLZ94 Section 8, and certificates.

The normal run compares some 150 starts; ``python -m pytest tests/dynamics/test_every_order.py -m slow -s`` compares 2,000 of each of the orders 2, 3, 4.
"""

from __future__ import annotations

import copy
import json
import random
from fractions import Fraction

import pytest
from flint import fmpq, fmpq_mat, fmpq_poly

from exactkf._errors import BadInput
from exactkf.dynamics.ahead import digits_ahead
from exactkf.dynamics.answer import Answer
from exactkf.dynamics.every_order import decide, limit_digits
from exactkf.dynamics.order_one import decide_order_one
from exactkf.dynamics.structure import structure
from exactkf.dynamics.torus import torus_evidence
from exactkf.exact import cyclotomic_real, sqrt_field
from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.intervals import is_schur
from exactkf.kernel.replay import Rejected, digest, replay
from exactkf.theory.fast_filter import ag_from_alpha_gamma, step_ag, step_alpha_gamma
from exactkf.theory.invariants import pseudo_polynomial, pseudo_polynomial_from_parameters
from exactkf.theory.orbits import first_escape
from tests.dynamics.starts import DEGENERATE

STEPS = 40
_OPEN = 0.01  # the part of the random starts of which an escape may stay open; it was 0, 0.0035 and 0.0045 of 2,000 of the orders 2, 3, 4
_TESTED = 12  # states of an orbit that are tested for positive realness
#: points of the unit circle with rational coordinates
CIRCLE = [(fmpq(1 - t * t, 1 + t * t), fmpq(2 * t, 1 + t * t)) for t in [fmpq(k, 12) for k in range(0, 13)] + [fmpq(12, k) for k in range(1, 12)]]


# ---------------------------------------------------------------------- starts
def small(rng, top=6, low=4):
    """Return a rational number of few digits."""
    return fmpq(rng.randint(-top, top), rng.randint(1, low))


def times(p, q):
    """Return the product of polynomials, leading coefficient first."""
    out = [fmpq(0)] * (len(p) + len(q) - 1)
    for i, x in enumerate(p):
        for j, y in enumerate(q):
            out[i + j] += x * y
    return out


def with_spectrum(rng, w):
    """Return a and g of the order of the polynomial of d, with d(z) up to a factor, or None: S(a)b = 2 rho D is linear in b and rho."""
    n = len(w) - 1
    a = [fmpq(1)] + [small(rng) for _ in range(n)]
    rows = []
    for i in range(n + 1):  # sum_j a_j b_{j+i} + b_j a_{j+i} = 2 rho w_i
        row = [fmpq(0)] * (n + 2)
        for j in range(n + 1 - i):
            row[j + i] += a[j]
            row[j] += a[j + i]
        row[n + 1] = -2 * fmpq(w[i])
        rows.append(row)
    matrix = fmpq_mat([row[1:] for row in rows])
    if matrix.det() == 0:
        return None
    b = matrix.solve(fmpq_mat([[-row[0]] for row in rows])).tolist()
    return a[1:], [(b[i][0] - a[i + 1]) / 2 for i in range(n)]


def self_product(w):
    """Return d_0, ..., d_n of w(z) w(1/z)."""
    return [sum((w[j] * w[j + i] for j in range(len(w) - i)), fmpq(0)) for i in range(len(w))]


CYCLOTOMIC = {2: [1, 1, 1], 4: [1, 0, 1], 6: [1, -1, 1], 5: [1, 1, 1, 1, 1], 8: [1, 0, 0, 0, 1], 12: [1, 0, -1, 0, 1], 9: [1, 0, 0, 1, 0, 0, 1]}


def start(rng, n):
    """Return a start of order n: generic, positive real, with common factors, with double zeros on the circle, periodic, degenerate."""
    kind = rng.randrange(8)
    if kind == 0 and n > 1:  # a and b with a common factor
        k = rng.randint(1, n - 1)
        theta = [fmpq(1)] + [small(rng, 3, 2) for _ in range(k)]
        a, g = start(rng, n - k)
        full = times([fmpq(1), *a], theta), times(list(g), theta)
        return full[0][1:], full[1]
    if kind == 1:  # D = w(z) w(1/z), often with zeros on the circle
        w = [fmpq(1)]
        while len(w) <= n:
            w = times(w, rng.choice([[1, 1], [1, -1], [1, small(rng)], [1, small(rng)]] + ([CYCLOTOMIC[rng.choice((2, 4, 6))]] if len(w) < n else [])))
        found = with_spectrum(rng, self_product(w[: n + 1]) if len(w) == n + 1 else self_product([fmpq(1)] * (n + 1)))
        if found:
            return found
    if kind == 2:  # zeros of D roots of unity
        chi = [fmpq(1)]
        for _ in range(20):
            factor = CYCLOTOMIC[rng.choice(list(CYCLOTOMIC))]
            if len(chi) + len(factor) - 2 <= 2 * n:
                chi = times(chi, [fmpq(c) for c in factor])
        if len(chi) == 2 * n + 1:
            found = with_spectrum(rng, chi[n:])
            if found:
                return found
    if kind == 3:  # alpha ends in zeros
        alpha = [small(rng) for _ in range(n - 1)] + [fmpq(0)]
        return ag_from_alpha_gamma(alpha, [small(rng) for _ in range(n)])
    if kind == 4:  # Schur parameters below one and alpha small: often positive real
        alpha = [fmpq(rng.randint(-3, 3), rng.randint(4, 9)) for _ in range(n)]
        return ag_from_alpha_gamma(alpha, [fmpq(rng.randint(-4, 4), rng.randint(5, 9)) for _ in range(n)])
    if kind == 5 and rng.random() < 0.3:
        return [small(rng) for _ in range(n)], [fmpq(0)] * n
    if kind == 6:
        return [fmpq(rng.randint(-2, 2)) for _ in range(n)], [fmpq(rng.randint(-2, 2)) for _ in range(n)]
    return [small(rng) for _ in range(n)], [small(rng) for _ in range(n)]


# ---------------------------------------------------------------------- brute force
def stepped(a, g, steps):
    """Return the states up to `steps` and the escape, by BLZ94 (2.16) alone."""
    states = [(tuple(map(fmpq, a)), tuple(map(fmpq, g)))]
    for t in range(steps + 1):
        if states[-1][1][0] ** 2 == 1:
            return states, t
        if t < steps:
            states.append(step_ag(*states[-1]))
    return states, None


def signs_seen(d):
    """Return the signs of D at points of the circle."""
    seen = set()
    for x, y in CIRCLE:
        total, (c, s) = d[0], (x, y)
        for value in d[1:]:
            total += 2 * value * c
            c, s = c * x - s * y, s * x + c * y
        seen.add((total > 0) - (total < 0))
    return seen - {0}


def is_stable(p):
    """Whether all zeros of a monic polynomial, leading coefficient first, are inside the circle: the step-down recursion."""
    while len(p) > 1:
        k = p[-1]
        if k * k >= 1:
            return False
        p = [(x - k * y) / (1 - k * k) for x, y in zip(p[:-1], p[:0:-1], strict=True)]
    return True


def is_positive(d):
    """Whether d_0 + d_1 (z + 1/z) + ... is positive on the circle: as a polynomial in 2 cos it is at a point, and has no root between -2 and 2."""
    total, (before, now) = fmpq_poly([d[0]]), (fmpq_poly([2]), fmpq_poly([0, 1]))
    for value in d[1:]:
        total += value * now
        before, now = now, fmpq_poly([0, 1]) * now - before
    if min(total(fmpq(x)) for x in (-2, 0, 2)) <= 0:
        return False
    roots = [x.real for x, _ in total.numer().complex_roots() if x.imag == 0] if total.degree() > 0 else []
    return not any(-2 < x < 2 for x in roots)


def is_in_region(a, g):
    """BLZ94 (2.13)-(2.15), on the whole polynomials a and b."""
    b = [x + 2 * y for x, y in zip(a, g, strict=True)]
    return is_positive(pseudo_polynomial(a, b)) and is_stable([fmpq(1), *a]) and is_stable([fmpq(1), *b])


def agrees(a, g, answer, steps=STEPS):
    """Assert that nothing in an exact orbit contradicts the answer."""
    if answer.behaviour in ("periodic", "eventually periodic"):
        steps = max(steps, (answer.preperiod or 0) + answer.period + 1)
    states, escape = stepped(a, g, steps)
    if escape is not None or answer.escape is not None and answer.escape <= steps:
        assert (answer.behaviour, answer.escape) == ("escapes", escape)
        return
    d = pseudo_polynomial(a, [x + 2 * y for x, y in zip(a, g, strict=True)])
    if answer.behaviour == "converges":
        assert len(signs_seen(d)) <= 1
        T = answer.enters_positive_real
        outside = [t for t, (_, g_t) in enumerate(states) if g_t[0] ** 2 > 1]
        if T is not None and T <= steps:
            assert max(outside, default=-1) + 1 == T
        inside = next((t for t, state in enumerate(states[:_TESTED]) if is_in_region(*state)), None)
        assert inside == (T if T is not None and T < _TESTED else None)
        assert (answer.period == 1) == all(x == 0 for x in g)
        limit = limit_digits(answer, 20).alpha
        far = digits_ahead(a, g, 10**10, 12, answer=answer)
        assert all(abs(x - y) < fmpq(1, 10**5) for x, y in zip(far.a, limit, strict=True))
        assert all(abs(x) < fmpq(1, 10**5) for x in far.g)
    elif answer.period is not None:
        p, first = answer.period, answer.preperiod or 0
        assert (answer.behaviour == "periodic") == (first == 0)
        assert states[first + p] == states[first]
        assert all(states[first + k] != states[first] for k in range(1, p))
        assert all(state not in states[t + 1:] for t, state in enumerate(states[:first]))
    elif answer.behaviour == "not convergent, not periodic":
        assert len(set(states)) == len(states)


def fmpq_of(x):
    """Return the midpoint of a ball."""
    return x.mid().fmpq()


def run(seed, n, count):
    """Decide `count` starts, compare each with its orbit, replay its certificate, and return how often each behaviour came."""
    rng, seen = random.Random(seed), {}
    for _ in range(count):
        a, g = start(rng, n)
        answer = decide(a, g, max_steps=400)
        try:
            agrees(a, g, answer)
            replay(answer.certificate)
        except (AssertionError, Rejected) as error:
            raise AssertionError(f"a = {a}, g = {g}: {answer.behaviour}: {error}") from error
        seen[answer.behaviour] = seen.get(answer.behaviour, 0) + 1
        seen["open"] = seen.get("open", 0) + answer.is_open
    return seen


@pytest.mark.parametrize(("n", "count"), [(2, 80), (3, 50), (4, 24)])
def test_decisions_agree_with_exact_orbits(n, count):
    """Every decision agrees with the orbit stepped exactly, and its certificate replays."""
    seen = run(7, n, count)
    assert seen["open"] <= 1 and "undecided" not in seen
    assert {"converges", "escapes", "not convergent, not periodic"} <= set(seen)


@pytest.mark.slow
@pytest.mark.parametrize("n", [2, 3, 4])
def test_two_thousand_decisions_agree_with_exact_orbits(n):
    """The same for two thousand starts of each order."""
    seen = run(11, n, 2000)
    print(n, seen)
    assert seen["open"] <= _OPEN * 2000 and "undecided" not in seen
    assert {"converges", "escapes", "periodic", "not convergent, not periodic"} <= set(seen)


def test_order_one_is_decided_alike_by_both_deciders():
    """The decider for every order and the one for order one agree on order one."""
    rng, compared, entered = random.Random(5), set(), set()
    starts = [(small(rng), small(rng)) for _ in range(60)] + [(fmpq(x), fmpq(y)) for x, y in DEGENERATE if y * y != 1]
    for alpha, gamma in starts:
        a, g = ag_from_alpha_gamma([alpha], [gamma])
        mine, theirs = decide(a, g), decide_order_one(alpha, gamma)
        behaviour = {"dense": "not convergent, not periodic"}.get(theirs.behaviour, theirs.behaviour)
        assert (mine.behaviour, mine.escape, mine.period) == (behaviour, theirs.escape, theirs.period)
        assert mine.enters_positive_real == theirs.enters_positive_real, (alpha, gamma)
        entered.add((behaviour, min(mine.enters_positive_real, 1) if mine.enters_positive_real is not None else None))
        if mine.behaviour == "converges":
            assert limit_digits(mine, 30).alpha[0].overlaps(limit_digits(theirs, 30).alpha[0])
        compared.add(behaviour)
    assert {"converges", "escapes", "not convergent, not periodic"} <= compared
    assert {("converges", 0), ("converges", 1), ("converges", None)} <= entered


@pytest.mark.parametrize(("a", "g", "step"), [
    ([3], [0], None), ([0], ["1/2"], None), ([0], ["-1/2"], None), (["1/2"], [0], 0), ([1], [0], None), ([0, -5], [0, 0], None), ([0, "-1/5"], [0, 0], 0),
    ([2, 0], ["1/4", "1/2"], None), (["5/8", "1/16"], ["1/4", "1/8"], 0), (["9/8", "1/8"], ["1/4", "1/4"], None), (["1/8", 1, "1/8"], ["1/4", 0, "1/4"], None),
    (["-9/2", 2], ["1/9", "-4/9"], None), (["-3/4", "1/8"], ["1/9", "-1/36"], 0), ([-2, 0], [2, 0], 1),
])
def test_the_step_of_entry_is_that_into_the_region_of_the_paper(a, g, step):
    """Equilibria, D with zeros on the circle, and common factors inside, on and outside it: (2.13)-(2.15) hold from that step on, or never."""
    a, g = ([fmpq(*map(int, str(x).split("/"))) for x in v] for v in (a, g))
    answer = decide(a, g)
    assert (answer.behaviour, answer.enters_positive_real) == ("converges", step)
    assert [is_in_region(*state) for state in stepped(a, g, 6)[0]] == [step is not None and t >= step for t in range(7)]
    assert structure(a, g).positive_real == (step == 0)
    assert ("never is positive real" in answer.words()) == (step is None)
    replay(answer.certificate)
    for other in {None, 0, 1, 2} - {step}:
        with pytest.raises(Rejected):
            replay(edited(answer.certificate, ("statement", "answer", "enters_positive_real"), other))


# ---------------------------------------------------------------------- BLZ94 Section 8
def test_the_point_of_figure_8_5():
    """(0, 2, 1/2, 1/3) converges, violates |gamma| < 1 twice, and is positive real from a step on that is found exactly."""
    a, g = ag_from_alpha_gamma([fmpq(0), fmpq(2)], [fmpq(1, 2), fmpq(1, 3)])
    answer = decide(a, g)
    assert (answer.behaviour, answer.never_escapes) == ("converges", True)
    states, _ = stepped(a, g, 30)
    outside = [t for t, (_, g_t) in enumerate(states) if g_t[0] ** 2 > 1]
    assert len(outside) == 2
    assert answer.enters_positive_real == outside[-1] + 1 <= 6
    assert structure(a, g).kappa == (fmpq(1, 7), fmpq(6, 7))
    agrees(a, g, answer)


def test_the_point_of_period_144():
    """Zeros of D at the angles pi/8 and pi/9 give the period 144, exactly."""
    field = cyclotomic_real(144)
    x1, x2 = field.two_cos(9), field.two_cos(8)
    a2 = field(fmpq(1, 2))
    rho = (1 - a2 * a2) / (x1 * x2 + 2 - 2 * a2)
    b = (-2 * (x1 + x2) * rho / (1 + a2), 2 * rho - a2)
    a = (field(0), a2)
    answer = decide(a, [(y - x) / 2 for x, y in zip(a, b, strict=True)])
    assert (answer.behaviour, answer.period, answer.never_escapes) == ("periodic", 144, True)


@pytest.mark.parametrize(("alpha", "inside"), [((fmpq(1, 2), fmpq(1, 4)), True), ((fmpq(3, 2), fmpq(1, 4)), False), ((fmpq(1, 4), fmpq(-3, 2)), False)])
def test_equilibria_in_and_out_of_the_triangle(alpha, inside):
    """(8.7), (8.8): an equilibrium rests; D has the invariants of (8.7), and its stable factor is the equilibrium inside the triangle only."""
    a1, a2 = alpha
    answer = decide(alpha, (0, 0))
    assert (answer.behaviour, answer.period, answer.limit["alpha"]) == ("converges", 1, [str(a1), str(a2)])
    norm = a2 * a2 + a1 * a1 + 1
    d = pseudo_polynomial(alpha, alpha)
    assert (2 * d[1] / d[0], 2 * d[2] / d[0]) == (2 * a1 * (1 + a2) / norm, 2 * a2 / norm)
    near = decide([a1, a2 + fmpq(1, 1000)], (0, fmpq(-1, 2000)))
    assert near.behaviour == "converges"
    gap = max(abs(float(x - fmpq_of(y))) for x, y in zip(alpha, limit_digits(near, 20).alpha, strict=True))
    assert (gap < 0.01) == inside


def test_the_printed_recursion_and_invariants_of_order_two():
    """(8.5) is the step of the filter, and (8.6) its invariants, as printed, at random points."""
    rng = random.Random(8)
    for _ in range(20):
        (a1, a2), (g0, g1) = ([fmpq(rng.randint(-9, 9), rng.randint(2, 7)) for _ in range(2)] for _ in range(2))
        if g0 * g0 == 1 or g1 * g1 == 1:
            continue
        r1, r2 = 1 - g0 * g0, (1 - g0 * g0) * (1 - g1 * g1)
        new_a1, new_a2 = a1 / (1 - g1 * g1) + g1 / (1 - g1 * g1) * g0 / (1 - g0 * g0) * a2, a2 / (1 - g0 * g0)
        assert step_alpha_gamma([a1, a2], [g0, g1]) == ((new_a1, new_a2), (g1, -new_a1 * g1 - new_a2 * g0))
        d0, d1, d2 = pseudo_polynomial_from_parameters([a1, a2], [g0, g1])
        assert (d0, d1, d2) == (a2 * a2 + r1 * a1 * a1 + r2, r1 * a1 + a1 * a2 + g0 * g1 * a2, a2)


def test_order_two_falls_back_to_order_one_when_kappa_2_is_zero():
    """Proposition 8.1: with alpha_2 = 0 an orbit of order two becomes one of order one, with its period."""
    a, g = [fmpq(1, 2), fmpq(0)], [fmpq(0), fmpq(3, 7)]
    found = structure(*ag_from_alpha_gamma([fmpq(2), fmpq(0)], [fmpq(1, 3), fmpq(5, 2)]))
    assert (found.order, found.start) == (1, 1)
    agrees(a, g, decide(a, g))


# ---------------------------------------------------------------------- special cases
def test_an_orbit_that_comes_from_an_escape_is_decided():
    """A state whose past is an escape meets it again modulo every prime; the p-adic argument decides."""
    answer = decide([fmpq(5, 4), fmpq(-2)], [fmpq(-2, 3), fmpq(1)])
    assert (answer.behaviour, answer.never_escapes) == ("not convergent, not periodic", True)
    assert answer.certificate["evidence"]["before"] == [1]
    replay(answer.certificate)


def test_many_primes_exclude_an_escape_of_order_five():
    """Where no two primes do, some do for each kind of zero, and all of them are needed; stepping meets no escape."""
    a, g = ([fmpq(*map(int, x.split("/"))) if "/" in x else fmpq(int(x)) for x in text.split()] for text in ("1/2 -3/4 1/4 -1 6", "1/2 -3 0 5 -5/4"))
    answer = decide(a, g)
    assert (answer.behaviour, answer.torus_dimension) == ("not convergent, not periodic", 2)
    replay(answer.certificate)
    assert first_escape(a, g, 500) is None
    signs = answer.certificate["evidence"]["signs"]
    assert sum(map(len, signs)) > 3
    for sign, places in enumerate(signs):
        for k in range(len(places)):
            with pytest.raises(Rejected):
                replay(edited(answer.certificate, ("evidence", "signs", sign), places[:k] + places[k + 1:]))


def test_undecided_orbits_say_what_is_in_the_way():
    """The behaviour is decided and vouched for; the reason names what is open, an escape later than the steps searched."""
    answer = decide([fmpq(1), fmpq(-2), fmpq(0)], [fmpq(2), fmpq(1), fmpq(2)], max_steps=300)
    assert (answer.behaviour, answer.never_escapes, answer.escape, answer.is_open) == ("not convergent, not periodic", False, None, True)
    assert answer.reason.startswith("whether the orbit ever escapes; it does not before step 300,") and answer.torus_dimension is not None
    replay(answer.certificate)
    for path, value in ((("statement", "answer", "never_escapes"), True), (("evidence", "searched"), 10**9), (("evidence", "aperiodic"), [3]),
                        (("statement", "answer", "behaviour"), "undecided"), (("statement", "answer", "torus_dimension"), answer.torus_dimension + 1)):
        with pytest.raises(Rejected):
            replay(edited(answer.certificate, path, value))


def test_related_roots_give_a_smaller_torus():
    """Roots l and l^2, or l and -1/l, leave a torus of dimension one; independent ones two."""
    x = fmpq(6, 5)  # l = (3 + 4i)/5
    def quadratic(y): return [fmpq(1), -y, fmpq(1)]
    related = times(quadratic(x), quadratic(x * x - 2))
    opposite = times(quadratic(x), quadratic(-x))
    free = times(quadratic(x), quadratic(fmpq(10, 13)))
    found = [torus_evidence([Fraction(int(c.p), int(c.q)) for c in D])[0] for D in (related, opposite, free)]
    assert found == [1, 1, 2]


def test_a_common_factor_stays_and_the_limit_may_be_unstable():
    """Theorem 7.1 (iii): the limit is the stable factor times the common factor, wherever that has its zeros."""
    theta, a, g = [fmpq(1), fmpq(3)], [fmpq(1, 4)], [fmpq(1, 3)]
    full = decide(times([fmpq(1), *a], theta)[1:], times(g, theta))
    small_answer = decide(a, g)
    (inner,) = limit_digits(small_answer, 30).alpha
    first, second = limit_digits(full, 30).alpha
    assert (full.behaviour, small_answer.behaviour) == ("converges", "converges")
    assert first.overlaps(inner + 3) and second.overlaps(3 * inner)


def test_double_zeros_on_the_circle_converge():
    """D with a double zero at each of two conjugate points keeps one sign, and the limit has simple zeros there."""
    found = with_spectrum(random.Random(3), self_product([fmpq(1), fmpq(1), fmpq(1)]))
    answer = decide(*found)
    assert answer.behaviour in ("converges", "escapes")
    if answer.behaviour == "converges":
        assert answer.limit["alpha"] == ["1", "1"]
    assert structure(*found).circle_zeros[0].multiplicity == 2


def test_algebraic_data_converge():
    """Over Q(sqrt 2) convergence and the entry are decided, and the certificate replays."""
    root = sqrt_field(2).gen()
    answer = decide([root / 4, root / 8], [root / 16, root - root])
    assert (answer.behaviour, answer.enters_positive_real) == ("converges", 0)
    replay(answer.certificate)


@pytest.mark.parametrize(("a", "g"), [([], []), ([1], [1, 2]), ([0.5], [1]), ([sqrt_field(2).gen()], [sqrt_field(3).gen()])])
def test_bad_input(a, g):
    """What is no exact state is refused in one line."""
    with pytest.raises(BadInput) as error:
        decide(a, g)
    assert "\n" not in str(error.value)


# ---------------------------------------------------------------------- certificates
def edited(certificate, path, value):
    """Return the certificate with one entry changed and a right digest."""
    changed = copy.deepcopy(certificate)
    at = changed
    for key in path[:-1]:
        at = at[key]
    assert at[path[-1]] != value
    at[path[-1]] = value
    return {**changed, "digest": digest(changed)}


CONVERGES = decide(*ag_from_alpha_gamma([fmpq(0), fmpq(2)], [fmpq(1, 2), fmpq(1, 3)]))
ESCAPES = decide(*ag_from_alpha_gamma([fmpq(1, 2), fmpq(3)], [fmpq(2), fmpq(1)]))
PERIODIC = decide(*with_spectrum(random.Random(1), [0, 0, 1]))
OUTSIDE = decide([fmpq(0)], [fmpq(1, 2)])  # D has a zero on the circle
LATE = decide([fmpq(-1, 2), fmpq(-3)], [fmpq(2), fmpq(-4)])  # the second zero of a and b is 2, and gamma_0 = 2
WANDERS = decide([fmpq(-1, 2), fmpq(1)], [fmpq(3), fmpq(1, 3)])


def test_the_examples_behave_as_named():
    """The four certificates that are edited below are of four kinds; two more converge and never are positive real. All replay."""
    assert [x.behaviour for x in (CONVERGES, ESCAPES, PERIODIC, WANDERS)] == ["converges", "escapes", "periodic", "not convergent, not periodic"]
    assert [(x.behaviour, x.enters_positive_real, x.certificate["evidence"]["bounded"]) for x in (OUTSIDE, LATE)] == [
        ("converges", None, 0), ("converges", None, 2)]
    for answer in (CONVERGES, ESCAPES, PERIODIC, WANDERS, OUTSIDE, LATE):
        replay(answer.certificate)
        assert json.loads(json.dumps(answer.to_json()))["behaviour"] == answer.behaviour


@pytest.mark.parametrize(("answer", "path", "value"), [
    (CONVERGES, ("answer", "enters_positive_real"), CONVERGES.enters_positive_real + 1),
    (CONVERGES, ("answer", "enters_positive_real"), CONVERGES.enters_positive_real - 1),
    (CONVERGES, ("answer", "limit", "alpha", 0), "1/17"),
    (CONVERGES, ("answer", "limit", "alpha"), CONVERGES.limit["alpha"][::-1]),
    (CONVERGES, ("answer", "never_escapes"), False),
    (CONVERGES, ("answer", "behaviour"), "periodic"),
    (CONVERGES, ("answer", "period"), 1),
    (CONVERGES, ("answer", "rate"), "1/2"),
    (CONVERGES, ("question", "a", 0), "5/7"),
    (CONVERGES, ("question", "g", 1), "5/7"),
    (ESCAPES, ("answer", "escape"), (ESCAPES.escape or 0) + 1),
    (ESCAPES, ("question", "g", 0), "1/3"),
    (PERIODIC, ("answer", "period"), 2 * (PERIODIC.period or 1)),
    (PERIODIC, ("answer", "period"), (PERIODIC.period or 2) // 2),
    (PERIODIC, ("question", "a", 1), "9/11"),
    (WANDERS, ("answer", "torus_dimension"), (WANDERS.torus_dimension or 0) + 1),
    (WANDERS, ("answer", "torus_dimension"), 0),
    (WANDERS, ("answer", "behaviour"), "converges"),
    (WANDERS, ("answer", "order"), 3),
])
def test_edits_are_rejected(answer: Answer, path, value):
    """A certificate with another question or answer does not replay."""
    with pytest.raises(Rejected):
        replay(edited(answer.certificate, ("statement", *path), value))


@pytest.mark.parametrize(("answer", "path", "value"), [
    (WANDERS, ("places", 0, 0), 4), (WANDERS, ("places", 0, 1), 1), (WANDERS, ("places",), []), (WANDERS, ("aperiodic",), [1]),
    (CONVERGES, ("factor", 0), "1"), (CONVERGES, ("field",), None),
    (OUTSIDE, ("bounded",), 1), (OUTSIDE, ("bounded",), None), (OUTSIDE, ("bounded",), "0"), (LATE, ("bounded",), 1), (LATE, ("bounded",), 3),
])
def test_broken_evidence_is_rejected(answer: Answer, path, value):
    """Evidence that does not do is rejected, also where the answer is right."""
    with pytest.raises(Rejected):
        replay(edited(answer.certificate, ("evidence", *path), value))


@pytest.mark.parametrize("preperiod", [0, False, 1])
def test_what_comes_back_to_its_start_is_not_eventually_periodic(preperiod):
    """A step to which an orbit first comes back goes with the behaviour that has one, and is after the start."""
    changed = edited(PERIODIC.certificate, ("statement", "answer", "behaviour"), "eventually periodic")
    with pytest.raises(Rejected):
        replay(edited(changed, ("statement", "answer", "preperiod"), preperiod))


def test_the_unstable_spectral_factor_is_rejected():
    """The factor of D with its zero outside the circle is no limit, though its product with its reversal is right."""
    starts = (with_spectrum(random.Random(seed), self_product([fmpq(1), fmpq(1, 2)])) for seed in range(50))
    answer = next(x for found in starts if found and (x := decide(*found)).behaviour == "converges" and x.period is None)
    assert (answer.behaviour, answer.limit["alpha"]) == ("converges", ["1/2"])
    changed = edited(answer.certificate, ("statement", "answer", "limit", "alpha"), ["2"])
    changed = edited(changed, ("evidence", "factor"), ["2", "1"])
    with pytest.raises(Rejected, match="outside the closed disc"):
        replay(changed)


def test_schur_polynomials_over_a_field_by_intervals():
    """z - (sqrt 2 - 1) z^0 is Schur and z - sqrt 2 is not, also when they multiply."""
    field = AlgebraicField([Fraction(-2), Fraction(0), Fraction(1)], Fraction(1), Fraction(2))
    root, one = field.element([Fraction(0), Fraction(1)]), field.element([Fraction(1)])
    assert is_schur([1 - root, one])
    assert not is_schur([-root, one])
    assert not is_schur([root * (root - 1), 1 - 2 * root, one])
    assert is_schur([(root - 1) * (root - 1), 2 - 2 * root, one])
