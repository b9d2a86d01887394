# SPDX-License-Identifier: MIT
"""Speed of decisions and of states far ahead, as ratios to bare FLINT arithmetic or to stepping in the same run."""

from __future__ import annotations

import random
from collections.abc import Callable
from statistics import median
from time import perf_counter

import pytest
from flint import fmpq, fmpq_mat

from exactkf.dynamics.ahead import digits_ahead, state_ahead
from exactkf.dynamics.every_order import decide
from exactkf.theory import exact_orbit, symplectic_matrix_of

pytestmark = pytest.mark.benchmark

A = {2: (fmpq(1, 2), fmpq(1, 3)), 3: (fmpq(1, 2), fmpq(1, 3), fmpq(1, 4)), 4: (fmpq(1, 2), fmpq(1, 3), fmpq(1, 4), fmpq(1, 5))}
G = {2: (fmpq(1, 3), fmpq(1, 5)), 3: (fmpq(1, 3), fmpq(-1, 2), fmpq(1, 4)), 4: (fmpq(1, 3), fmpq(-1, 2), fmpq(1, 4), fmpq(1, 6))}


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


@pytest.mark.parametrize("n", [2, 3, 4])
def test_the_exact_state_far_ahead(n):
    """The exact state at T = 100,000 takes at most twice the time of one bare power of the same matrix."""
    T, S = 100_000, symplectic_matrix_of(A[n], G[n])
    ours = seconds(lambda: state_ahead(A[n], G[n], T))
    bare = seconds(lambda: S**T)
    print(f"\nexact state, n = {n}, T = 100,000: {ours:.2f} s, bare power {bare:.2f} s, ratio {ours / bare:.2f}")
    assert ours <= 2 * bare


def test_far_ahead_against_stepping():
    """The exact state at T = 100,000, n = 2, is at least 100 times faster than stepping, whose time grows with the square of T."""
    few, T = 4_000, 100_000
    stepping = seconds(lambda: exact_orbit(A[2], G[2], few)) * (T / few) ** 2
    ours = seconds(lambda: state_ahead(A[2], G[2], T))
    print(f"\nstate at T = 100,000, n = 2: {ours:.2f} s, stepping {stepping:.0f} s from {few} steps, ratio {stepping / ours:.0f}")
    assert stepping >= 100 * ours


def test_digits_a_trillion_steps_ahead():
    """Thirty digits at T = 10^12 take less time than one bare power to T = 100,000."""
    S = fmpq_mat(symplectic_matrix_of(A[2], G[2]))
    answer = decide(A[2], G[2])
    ours = seconds(lambda: digits_ahead(A[2], G[2], 10**12, 30, answer=answer))
    bare = seconds(lambda: S**100_000)
    print(f"\n30 digits at T = 10^12: {1000 * ours:.1f} ms, bare power {1000 * bare:.1f} ms, ratio {ours / bare:.2f}")
    assert ours <= bare
