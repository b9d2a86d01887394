# SPDX-License-Identifier: MIT
"""Speed of decisions and of states far ahead, as ratios to bare FLINT arithmetic or to stepping in the same run."""

from __future__ import annotations

import random
from collections.abc import Callable
from statistics import median
from time import perf_counter, process_time

import pytest
from flint import fmpq, fmpq_mat

from exactkf.dynamics.ahead import digits_ahead, state_ahead
from exactkf.dynamics.every_order import decide
from exactkf.theory import exact_orbit, symplectic_matrix_of
from exactkf.theory.orbits import integer_orbit

pytestmark = pytest.mark.benchmark

A = {1: (fmpq(1, 2),), 2: (fmpq(1, 2), fmpq(1, 3)), 3: (fmpq(1, 2), fmpq(1, 3), fmpq(1, 4)), 4: (fmpq(1, 2), fmpq(1, 3), fmpq(1, 4), fmpq(1, 5))}
G = {1: (fmpq(1, 3),), 2: (fmpq(1, 3), fmpq(1, 5)), 3: (fmpq(1, 3), fmpq(-1, 2), fmpq(1, 4)), 4: (fmpq(1, 3), fmpq(-1, 2), fmpq(1, 4), fmpq(1, 6))}


def seconds(call: Callable[[], object]) -> float:
    """Return the running time."""
    start = perf_counter()
    call()
    return perf_counter() - start


@pytest.mark.parametrize(("n", "ratio"), [(2, fmpq(1, 40)), (3, fmpq(1, 10)), (4, fmpq(1, 5))])
def test_a_decision_costs_little(n, ratio):
    """The median decision for rational data, certificate included, takes at most the named multiple of one thousand exact steps of order two."""
    rng = random.Random(n)
    starts = [[[fmpq(rng.randint(-6, 6), rng.randint(1, 4)) for _ in range(n)] for _ in range(2)] for _ in range(40)]
    ours = median(seconds(lambda a=a, g=g: decide(a, g).certificate) for a, g in starts)
    steps = min(seconds(lambda: exact_orbit(A[2], G[2], 1000)) for _ in range(3))
    print(f"\ndecision, n = {n}: {1000 * ours:.1f} ms, 1,000 steps {1000 * steps:.1f} ms, ratio {ours / steps:.2f}")
    assert ours <= float(ratio) * steps


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_the_exact_state_far_ahead(n):
    """The exact state at T = 100,000 takes at most twice the time of one bare power of the same matrix."""
    T, S = 100_000, symplectic_matrix_of(A[n], G[n])
    ours = seconds(lambda: state_ahead(A[n], G[n], T))
    bare = seconds(lambda: S**T)
    print(f"\nexact state, n = {n}, T = 100,000: {ours:.2f} s, bare power {bare:.2f} s, ratio {ours / bare:.2f}")
    assert ours <= 2 * bare


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_far_ahead_against_stepping(n):
    """The exact state at T = 100,000 is at least 100 times faster than stepping in integers: fewer than 25,000 of the steps take 100 times as long already.

    Nothing is extrapolated; what the other steps take comes on top. At T = 10,000 both times are measured.
    """
    T, near = 100_000, 10_000
    ours, ours_near = (min(own_seconds(lambda t=t: state_ahead(A[n], G[n], t)) for _ in range(3)) for t in (T, near))
    start, at_near, reached = process_time(), 0.0, None
    for t, _ in enumerate(integer_orbit(A[n], G[n])):
        passed = process_time() - start
        at_near = passed if t == near else at_near
        reached = t if reached is None and passed >= 100 * ours else reached
        if reached is not None and t >= near or t >= 25_000:
            break
    print(f"\nn = {n}: state at T = 100,000 in {ours:.2f} s, 100 times that is reached in {reached} steps; "
          f"at T = 10,000 the state takes {1000 * ours_near:.1f} ms, stepping {at_near:.2f} s, ratio {at_near / ours_near:.0f}")
    assert reached is not None
    assert at_near >= 50 * ours_near


def own_seconds(call: Callable[[], object]) -> float:
    """Return the processor time, which other work on the machine disturbs less."""
    start = process_time()
    call()
    return process_time() - start


def test_digits_a_trillion_steps_ahead():
    """Thirty digits at T = 10^12 take less time than one bare power to T = 100,000."""
    S = fmpq_mat(symplectic_matrix_of(A[2], G[2]))
    answer = decide(A[2], G[2])
    ours = seconds(lambda: digits_ahead(A[2], G[2], 10**12, 30, answer=answer))
    bare = seconds(lambda: S**100_000)
    print(f"\n30 digits at T = 10^12: {1000 * ours:.1f} ms, bare power {1000 * bare:.1f} ms, ratio {ours / bare:.2f}")
    assert ours <= bare
