# SPDX-License-Identifier: MIT
"""Speed of the theory package, as ratios to bare FLINT arithmetic measured in the same run."""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter

import pytest
from flint import fmpq, fmpz_mpoly_ctx

from exactkf.theory import (
    difference_of_squares,
    exact_orbit,
    integer_orbit,
    state_after,
    step_numerators,
    symplectic_matrix_of,
)

pytestmark = pytest.mark.benchmark

A4 = (fmpq(1, 2), fmpq(1, 3), fmpq(1, 4), fmpq(1, 5))
G4 = (fmpq(1, 3), fmpq(-1, 2), fmpq(1, 4), fmpq(1, 6))
A2, G2 = (fmpq(1, 2), fmpq(1, 3)), (fmpq(1, 3), fmpq(1, 5))


def best(call: Callable[[], object], repeat: int = 3) -> float:
    """Return the shortest of several running times in seconds."""
    times = []
    for _ in range(repeat):
        start = perf_counter()
        call()
        times.append(perf_counter() - start)
    return min(times)


def bare_orbit(a, g, steps):
    """Step BLZ94 (2.16) with rational numbers in a plain loop."""
    n, states = len(a), [(tuple(a), tuple(g))]
    for _ in range(steps):
        first = g[0]
        left, right = 1 / (1 - first), 1 / (1 - first * first)
        shifted = [*g[1:], fmpq(0)]
        total = [a[k] + g[k] for k in range(n)]
        a = [left * (total[k] - shifted[k]) for k in range(n)]
        g = [right * (shifted[k] - first * total[k]) for k in range(n)]
        states.append((tuple(a), tuple(g)))
    return states


def test_two_thousand_exact_steps():
    """2,000 exact steps for n = 4 take at most twice the time of a bare loop over rationals."""
    results = []
    ours = best(lambda: results.append(exact_orbit(A4, G4, 2000).states[-1]), 2)
    bare = best(lambda: results.append(bare_orbit(A4, G4, 2000)[-1]), 1)
    print(f"\n2,000 exact steps, n = 4: {ours:.2f} s, bare loop {bare:.2f} s, ratio {ours / bare:.2f}")
    assert results[0] == results[-1] and ours <= 2 * bare


@pytest.mark.parametrize(("a", "g", "limit"), [(A4, G4, 2), (A2, G2, 3)], ids=["n=4", "n=2"])
def test_a_hundred_thousand_steps_at_once(a, g, limit):
    """The state after 100,000 steps costs about one matrix power and a hundredth of stepping."""
    T, sample = 100_000, 2_000
    ours = best(lambda: state_after(a, g, T), 2)
    S = symplectic_matrix_of(a, g)
    power = best(lambda: S**T, 2)
    # The digits of a state grow linearly with time, so stepping takes at least quadratic time.
    part = best(lambda: [None for _, _ in zip(range(sample), integer_orbit(a, g), strict=False)], 2)
    stepping = part * (T / sample) ** 2
    print(
        f"\nstate after {T} steps, n = {len(a)}: {ours:.2f} s; matrix power {power:.2f} s, ratio {ours / power:.2f}; "
        f"stepping {part:.2f} s for {sample} steps, extrapolated {stepping:.0f} s, ratio {stepping / ours:.0f}"
    )
    assert ours <= limit * power and stepping >= 100 * ours


def hand_written(q, s, one, zero):
    """Expand both sides of BLM91 (2.28) after one step without division, coefficient by coefficient."""
    n = len(s)
    full, star = [one, *q], [zero, *s]
    moved = [*s, zero]
    first = s[0]
    new = [full[k] - first * moved[k] for k in range(n + 1)]
    new_star = [zero] + [moved[k] - first * full[k] for k in range(1, n + 1)]
    factor = one - first * first
    for i in range(n + 1):
        left, right = zero, zero
        for j in range(n + 1 - i):
            left = left + new[j] * new[j + i] - new_star[j] * new_star[j + i]
            right = right + full[j] * full[j + i] - star[j] * star[j + i]
        if left != factor * right:
            return False
    return True


@pytest.mark.parametrize("n", range(2, 9))
def test_symbolic_invariance(n):
    """The invariance (2.18) in all 2n variables costs about as much as a hand-written expansion."""
    ring = fmpz_mpoly_ctx.get([f"a{i}" for i in range(n)] + [f"g{i}" for i in range(n)], "degrevlex")
    variables = ring.gens()
    one, zero = ring.constant(1), ring.constant(0)
    g = variables[n:]
    q = tuple(x + y for x, y in zip(variables[:n], g, strict=True))

    def ours():
        factor = 1 - g[0] * g[0]
        Q = (one, *q)
        new = difference_of_squares(*step_numerators(Q, g))
        assert new == tuple(factor * d for d in difference_of_squares(Q, g))

    def bare():
        assert hand_written(q, g, one, zero)

    mine, theirs = map(min, zip(*((best(ours, 3), best(bare, 3)) for _ in range(12)), strict=True))  # in turn: the clock rate of a processor changes
    print(f"\ninvariance, n = {n}: {1e3 * mine:.2f} ms, by hand {1e3 * theirs:.2f} ms, ratio {mine / theirs:.2f}")
    assert mine <= (3 if n < 4 else 2) * theirs
