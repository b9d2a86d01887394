# SPDX-License-Identifier: MIT
"""The fast filter: three coordinate systems, orbits, and states far ahead."""

import random
from fractions import Fraction

import pytest
from flint import fmpq, fmpz_poly
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp, mpf

from exactkf._errors import BadInput
from exactkf.theory import (
    ag_from_alpha_gamma,
    ag_from_q,
    alpha_gamma_from_ag,
    exact_orbit,
    first_escape,
    from_kimura_georgiou,
    gain,
    integer_orbit,
    laurent_covariances,
    levinson,
    observer_form,
    orbit,
    power_method,
    power_modulo,
    q_from_ag,
    riccati_gain,
    riccati_step,
    scaling_factor,
    schur_parameters,
    state_after,
    step_ag,
    step_alpha_gamma,
    step_numerators,
    step_polynomials,
    step_q,
    symplectic_matrix_of,
    to_kimura_georgiou,
)

from .strategies import mat, pairs, parameters, rows

START = ((fmpq(1, 2), fmpq(1, 3)), (fmpq(1, 3), fmpq(1, 5)))


@given(parameters())
def test_kimura_georgiou_round_trip(point):
    """The rational inverse recovers the parameters."""
    assert to_kimura_georgiou(*from_kimura_georgiou(*point)) == point


@given(pairs())
def test_kimura_georgiou_round_trip_from_polynomials(pair):
    """Parameters recovered from polynomials reproduce them, or a Schur parameter has square one."""
    _, stop = levinson(laurent_covariances(*pair))
    if stop is None:
        assert from_kimura_georgiou(*to_kimura_georgiou(*pair)) == pair
    else:
        with pytest.raises(BadInput, match=rf"gamma\[{stop}\] has square 1"):
            to_kimura_georgiou(*pair)


@given(parameters())
def test_laurent_series(point):
    """The first n covariances of b / 2a have gamma as Schur parameters, and a times the series is b / 2."""
    a, b = from_kimura_georgiou(*point)
    n = len(a)
    c = laurent_covariances(a, b, 2 * n)
    assert schur_parameters(c[:n]) == point[1]
    series = (fmpq(1, 2), *c)
    for k in range(2 * n + 1):
        value = sum((((1, *a)[j]) * series[k - j] for j in range(min(k, n) + 1)), fmpq(0))
        assert value == ((1, *b)[k] / fmpq(2) if k <= n else 0)


@given(parameters())
def test_three_coordinate_systems_agree(point):
    """One step commutes with the changes of coordinates."""
    a, g = ag_from_alpha_gamma(*point)
    new = step_ag(a, g)
    assert ag_from_alpha_gamma(*step_alpha_gamma(*point)) == new
    assert ag_from_q(*step_q(*q_from_ag(a, g))) == new


@given(pairs(), st.integers(1, 6))
def test_polynomial_step_is_linear_given_gamma(pair, steps):
    """The polynomials Q and Q* are r_t times the monic ones, with and without division."""
    q, q_star = q_from_ag(*pair)
    path = orbit(step_q, (q, q_star), steps)
    Q, Q_star = (fmpq(1), *q), q_star
    for t, (q_t, star_t) in enumerate(path.states):
        r = scaling_factor([star[0] for _, star in path.states[:t]])
        assert (r, *(r * x for x in q_t)) == Q and Q_star == tuple(r * x for x in star_t)
        if r != 0 and (t < len(path.states) - 1 or path.escape is None):
            numerators = step_numerators(Q, Q_star)
            Q, Q_star = step_polynomials(Q, Q_star)
            assert numerators == (tuple(r * x for x in Q), tuple(r * x for x in Q_star))


@given(pairs(max_n=3))
def test_schur_parameters_move_to_the_left(pair):
    """The first entry of g(t) is the Schur parameter gamma_t of the initial pair (BLZ94 (4.2))."""
    a, g = pair
    b = [x + 2 * y for x, y in zip(a, g, strict=True)]
    gamma, _ = levinson(laurent_covariances(a, b, 7))
    path = orbit(step_ag, pair, 6)
    assert tuple(state[1][0] for state in path.states) == gamma[: len(path.states)]
    assert (path.escape is not None) == (len(gamma) < 7)


@given(pairs(max_n=3))
def test_riccati_equation_gives_the_same_gains(pair):
    """Started at zero, the Riccati recursion has the gains and the increments of the fast filter."""
    F, g, h = observer_form(*pair)
    P = tuple((fmpq(0),) * len(F) for _ in F)
    path = orbit(step_ag, pair, 5)
    for t, (a_t, g_t) in enumerate(path.states):
        r = scaling_factor([state[1][0] for state in path.states[:t]])
        assert 1 - P[0][0] == r
        assert riccati_gain(F, g, h, P) == gain(a_t, g_t, pair[0])
        following = riccati_step(F, g, h, P)
        outer = tuple(tuple(r * x * y for y in g_t) for x in g_t)
        assert mat(following) - mat(P) == mat(outer)
        P = following


@given(pairs(max_n=5), st.integers(0, 12))
def test_exact_orbit_is_the_orbit(pair, steps):
    """Integer arithmetic with exact division gives the same states and the same escape."""
    assert exact_orbit(*pair, steps) == orbit(step_ag, pair, steps)


@given(pairs(max_n=3))
def test_integer_orbit_divides_exactly(pair):
    """The leading coefficients are the determinants of Toeplitz matrices times a power of the denominator."""
    a, g = pair
    b = [x + 2 * y for x, y in zip(a, g, strict=True)]
    gamma, _ = levinson(laurent_covariances(a, b, 6))
    d = mat((a, g)).numer_denom()[1]
    determinant = error = fmpq(1)
    for t, (state, value) in enumerate(zip(integer_orbit(a, g), gamma, strict=False)):
        assert state[0][0] == (determinant * d ** (2 * t) if t else d)
        error *= 1 - value * value
        determinant *= error


@given(pairs(max_n=4), st.booleans(), st.integers(0, 30))
def test_state_after_agrees_with_stepping(pair, reduce, steps):
    """The power of the symplectic matrix gives the state that stepping gives, also if alpha_n = 0."""
    a, g = pair
    if reduce:
        a = (*a[:-1], -g[-1])
    path, arrival = orbit(step_ag, (a, g), steps), state_after(a, g, steps)
    assert arrival.escape == path.escape == first_escape(a, g, steps)
    assert arrival.state == (path.states[-1] if path.escape is None else None)


@given(parameters(max_n=4), st.integers(0, 4), st.integers(9, 24))
def test_state_after_with_invariant_directions(point, zeros, steps):
    """Several trailing zeros of alpha reduce the order of the power, and the result does not change."""
    alpha, gamma = point
    zeros = min(zeros, len(alpha))
    a, g = ag_from_alpha_gamma((*alpha[: len(alpha) - zeros], *(fmpq(0),) * zeros), gamma)
    path = orbit(step_ag, (a, g), steps)
    if path.escape is None:
        assert state_after(a, g, steps).state == path.states[-1]


def test_escape_right_after_the_goal():
    """A state exists although its Kimura-Georgiou parameters do not, because the orbit escapes next."""
    alpha, gamma = fmpq(3), fmpq(1)
    for _ in range(7):  # one step of the case n = 1, backwards
        gamma = -gamma / alpha
        alpha = alpha * (1 - gamma * gamma)
    a, g = ag_from_alpha_gamma((alpha, 0), (fmpq(1, 7), gamma))
    assert a[1] + g[1] == 0 and first_escape(a, g, 100) == 8
    for steps in range(5, 9):
        assert state_after(a, g, steps).state == orbit(step_ag, (a, g), steps).states[-1]
    assert state_after(a, g, 9).escape == 8


@given(st.lists(st.integers(-4, 4), min_size=2, max_size=5).filter(lambda c: c[-1] != 0), st.integers(0, 40))
def test_power_modulo(coefficients, exponent):
    """The remainder of a power agrees with rational polynomial division, and its denominator is as small as claimed."""
    modulus = fmpz_poly(coefficients)
    numerator, e = power_modulo(exponent, modulus)
    lead, degree = modulus.leading_coefficient(), modulus.degree()
    assert 0 <= e <= max(0, exponent - degree + 1) and numerator.degree() < degree
    difference = fmpz_poly([0, 1]) ** exponent * lead**e - numerator
    quotient, remainder = divmod(difference * lead ** (exponent + 1), modulus)
    assert remainder == 0 and quotient * modulus == difference * lead ** (exponent + 1)


def test_symplectic_power_with_mpmath():
    """After 200 steps the state agrees to 40 digits with stepping at 80 digits."""
    a, g = START
    with mp.workdps(80):
        state = tuple(tuple(mpf(int(x.p)) / int(x.q) for x in v) for v in (a, g))
        for _ in range(200):
            state = step_ag(*state)
        exact = state_after(a, g, 200).state
        for x, y in zip(sum(exact, ()), sum(state, ()), strict=True):
            assert abs(mpf(int(x.p)) / int(x.q) - y) < mpf(10) ** -40 * (1 + abs(y))


def test_symplectic_matrix_needs_alpha():
    """The matrix S does not exist for alpha_n = 0."""
    assert mat(rows(symplectic_matrix_of(*START))).det() == 1
    with pytest.raises(BadInput, match=r"a\[0\] \+ g\[0\] = 0"):
        symplectic_matrix_of([1], [-1])


def test_false_alarm_modulo_a_prime():
    """Denominators divisible by the primes used for the quick test are no escape."""
    unlucky = fmpq(1, ((1 << 61) - 1) * ((1 << 89) - 1))
    assert first_escape([unlucky], [fmpq(1, 3)], 5) is None
    assert state_after([unlucky], [fmpq(1, 3)], 5).state == orbit(step_ag, ([unlucky], [fmpq(1, 3)]), 5).states[-1]


def test_escape_is_returned_by_orbits_and_raised_by_steps():
    """Orbits end with the time of escape, a single step raises."""
    assert orbit(step_ag, ([-2], [Fraction(1, 2)]), 9).escape == 1
    assert exact_orbit([-2], [fmpq(1, 2)], 9).escape == 1
    assert state_after([-2], [fmpq(1, 2)], 10**6).escape == 1
    assert orbit(step_alpha_gamma, ([1, 1], [0, 1]), 3).escape == 0
    with pytest.raises(BadInput, match=r"^g\[0\] = 1: "):
        step_ag([0], [1])
    with pytest.raises(BadInput, match=r"^gamma\[1\] = -1: "):
        step_alpha_gamma([0, 0], [0, -1])
    with pytest.raises(BadInput, match=r"^Q\[0\] = 0: "):
        step_polynomials([0, 1], [1])


@pytest.mark.parametrize(
    ("call", "start"),
    [
        (lambda: step_ag([1], [1, 2]), "g = (1, 2): has length 2 where a asks for 1"),
        (lambda: step_q([], []), "q = ()"),
        (lambda: orbit(step_ag, ([1], [2]), -1), "argument 'steps' is not an integer of at least 0: -1"),
        (lambda: exact_orbit([1], [2, 3], 1), "g = (2, 3): has length 2 where a asks for 1"),
        (lambda: state_after([1.5], [2], 1), "a[0] = 1.5: not an exact scalar"),
        (lambda: state_after([mpf(1)], [2], 1), "(a, g) = ((mpf('1.0'),), (mpf('2.0'),)): has the entry 1.0"),
        (lambda: laurent_covariances([1], []), "b = (): has length 0"),
        (lambda: gain([1], [1], [1, 2]), "a = (1, 2): has length 2"),
        (lambda: alpha_gamma_from_ag([1, 1], [1, 1]), "(a, b) = ((1, 1), (3, 3)): the Schur parameter gamma[0]"),
    ],
)
def test_messages(call, start):
    """Every refusal names the argument and its value in one line."""
    with pytest.raises(BadInput) as caught:
        call()
    assert str(caught.value).startswith(start) and "\n" not in str(caught.value)


def test_a_prime_excludes_escapes_where_there_are_none(monkeypatch):
    """The determinants modulo a large prime say what stepping says, and the state is that of stepping, with and without an escape."""
    monkeypatch.setattr(power_method, "_MANY", 0)
    rng, seen = random.Random(4), set()
    for _ in range(200):
        n, T = rng.randint(1, 4), rng.randint(1, 40)
        a, g = ([fmpq(rng.randint(-3, 3), rng.randint(1, 2)) for _ in range(n)] for _ in range(2))
        orbit = exact_orbit(a, g, T)
        found = state_after(a, g, T)
        escape = orbit.escape if orbit.escape is not None and orbit.escape < T else None
        assert found.escape == escape and (escape is not None or found.state == orbit.states[-1])
        if a[-1] + g[-1] != 0:
            assert power_method._escape_excluded(tuple(a), tuple(g), T) == (escape is None)
            seen.add(escape is None)
    assert seen == {True, False}
