# SPDX-License-Identifier: MIT
"""The state far ahead against stepping, and its digits."""

from __future__ import annotations

import random

import pytest
from flint import arb, fmpq

from exactkf._errors import BadInput
from exactkf.dynamics.ahead import ahead_data, ahead_lines, digits_ahead, state_ahead
from exactkf.dynamics.every_order import decide
from exactkf.exact import sqrt_field
from exactkf.exact.balls import contains
from exactkf.theory.fast_filter import step_ag
from exactkf.theory.orbits import exact_orbit, orbit
from tests.dynamics.test_algebraic import times_in
from tests.dynamics.test_every_order import start


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_digits_and_exact_states_agree_with_stepping(n):
    """The balls contain the state that stepping reaches, the exact state is that state, and escapes are the same."""
    rng, reached = random.Random(n), 0
    for _ in range(15):
        a, g = start(rng, n)
        T = rng.choice((0, 1, 2, 7, 40))
        orbit, far = exact_orbit(a, g, T), digits_ahead(a, g, T, 20)
        exact = state_ahead(a, g, T)
        if len(orbit.states) <= T:
            assert orbit.escape == far.escape == exact.escape
            continue
        assert exact.state == orbit.states[-1]
        assert all(contains(x, y) for x, y in zip((*far.a, *far.g), (*exact.state[0], *exact.state[1]), strict=True))
        reached += 1
    assert reached > 3


def stepped_modulo(a, g, steps, p):
    """The state reached by steps of homogeneous coordinates modulo p."""
    a, g = ([residue(x, p) for x in v] for v in (a, g))
    Q, star = [1, *((x + y) % p for x, y in zip(a, g, strict=True))], g
    for _ in range(steps):
        lead, first, moved = Q[0], star[0], [*star, 0]
        star = [(lead * y - first * x) % p for x, y in zip(Q[1:], moved[1:], strict=True)]
        Q = [(lead * x - first * y) % p for x, y in zip(Q, moved, strict=True)]
    unit = pow(Q[0], -1, p)
    return [(x - y) * unit % p for x, y in zip(Q[1:], star, strict=True)], [y * unit % p for y in star]


def residue(x, p):
    """A rational number modulo a prime."""
    return int(x.p % p) * pow(int(x.q % p), -1, p) % p


FAR = {1: ([2], ["1/2"]), 2: ([1, -1], [2, 0]), 3: ([1, 0, "1/2"], [2, 0, "1/2"]), 4: ([1, 0, 0, 2], [2, 0, 1, -1])}


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_the_exact_state_after_a_million_steps(n):
    """Millions of bits: modulo a prime the state is the one that a million steps reach, and it is in balls found by another composition of powers.

    After 1,200 steps, for which the same method is used, it is the state that exact stepping reaches.
    """
    a, g = ([fmpq(*map(int, str(x).split("/"))) for x in v] for v in FAR[n])
    assert state_ahead(a, g, 1200).state == exact_orbit(a, g, 1200).states[-1]
    T, p = 10**6, 10**18 + 9
    state, far = state_ahead(a, g, T).state, digits_ahead(a, g, T, 20)
    assert max(int(x.p).bit_length() for v in state for x in v) > 10**6
    assert tuple([residue(x, p) for x in v] for v in state) == stepped_modulo(a, g, T, p)
    assert all(contains(x, y) for x, y in zip((*far.a, *far.g), (*state[0], *state[1]), strict=True))


def test_a_periodic_orbit_a_trillion_steps_ahead():
    """Where the orbit is periodic the digits at T = 10^12 are those of the state at T modulo the period."""
    rng = random.Random(2)
    a, g, period = next((a, g, answer.period) for a, g in (start(rng, 2) for _ in range(200)) if (answer := decide(a, g)).behaviour == "periodic")
    far, near = digits_ahead(a, g, 10**12, 25), exact_orbit(a, g, 10**12 % period).states[-1]
    assert all(contains(x, y) for x, y in zip((*far.a, *far.g), (*near[0], *near[1]), strict=True))


@pytest.mark.parametrize("n", [1, 2, 3])
def test_digits_of_algebraic_states_agree_with_stepping(n):
    """Over Q(sqrt 2) the balls overlap those of exact steps, also where a factor is in common; a periodic orbit is itself after 10^12 periods."""
    field, rng = sqrt_field(2), random.Random(n)
    for _ in range(8):
        a, g = ([field([fmpq(rng.randint(-3, 3), 2), fmpq(rng.randint(-3, 3), 4)]) for _ in range(n)] for _ in range(2))
        if rng.random() < 0.5:
            a, g = times_in([field(1), *a], [field(1), field(2)])[1:], times_in(g, [field(1), field(2)])
        T = rng.choice((0, 1, 2, 5, 9))
        exact = orbit(step_ag, (a, g), T)
        far = digits_ahead(a, g, T, 30)
        if far.escape is not None:
            assert far.escape == exact.escape
            continue
        last = (*exact.states[-1][0], *exact.states[-1][1])
        assert all(x.overlaps(y.enclose(60)) and x.rad() < arb(10) ** -30 for x, y in zip((*far.a, *far.g), last, strict=True))
    root = sqrt_field(3).gen()
    a, g = [-2 - root], [root]
    assert decide(a, g).period == 6
    far = digits_ahead(a, g, 6 * 10**12, 25)
    assert all(x.overlaps(y.enclose(40)) for x, y in zip((*far.a, *far.g), (*a, *g), strict=True))


def test_the_text_names_an_escape():
    """The lines say that there is no state behind an escape."""
    assert ahead_lines(ahead_data([-2], [fmpq(1, 2)], 10)) == ["no state after 10 steps: the orbit escapes at step 1"]
    assert ahead_lines(ahead_data([0], [2], 2)) == ["a_1(2) = 2", "g_1(2) = -8/7"]


@pytest.mark.parametrize(("T", "digits"), [(-1, 5), (3, 0), (True, 5)])
def test_bad_input(T, digits):
    """Steps and digits that are no numbers of steps and digits are refused."""
    with pytest.raises(BadInput):
        digits_ahead([fmpq(0)], [fmpq(2)], T, digits)
