# SPDX-License-Identifier: MIT
"""Speed of the decisions about orbits, as ratios to exact stepping and to one process in the same run."""

from __future__ import annotations

import gc
import os
from random import Random
from statistics import median
from time import perf_counter, process_time

import pytest
from flint import fmpq, fmpq_poly

from exactkf.dynamics import decide, decide_many, decide_order_one
from exactkf.exact.polynomials import reversal
from exactkf.kernel.replay import replay
from tests.dynamics.brute import filter_orbit
from tests.dynamics.starts import rational_start
from tests.dynamics.test_every_order import start, stepped

pytestmark = pytest.mark.benchmark


def seconds(call):
    """Time of one call."""
    start = perf_counter()
    call()
    return perf_counter() - start


def own_seconds(call):
    """Time of this process for one call."""
    start = process_time()
    call()
    return process_time() - start


def test_a_decision_takes_less_than_a_few_hundred_exact_steps():
    """Deciding 300 rational starts for all t, certificates included, takes less time than stepping them 100 steps."""
    random = Random(1)
    starts = [rational_start(random) for _ in range(300)]
    answers = []
    ours = seconds(lambda: answers.extend(decide_order_one(*s) for s in starts)) + seconds(lambda: [a.certificate for a in answers])
    stepping = seconds(lambda: [filter_orbit(*s, 100) for s in starts])
    checking = seconds(lambda: [replay(a.certificate) for a in answers])
    print(f"\n300 rational starts: decided in {1e3 * ours / 300:.2f} ms each, 100 exact steps {1e3 * stepping / 300:.2f} ms, "
          f"ratio {ours / stepping:.2f}; checked in {1e3 * checking / 300:.2f} ms")
    assert ours <= stepping


@pytest.mark.parametrize(("n", "bound"), [(2, 60), (3, 80), (4, 80)])
def test_a_decision_of_higher_order_takes_less_than_a_few_dozen_exact_steps(n, bound):
    """The median decision for all t of 200 starts of order 2, 3, 4 takes as long as BOUND exact steps or less.

    Measured: 0.55, 0.42, 0.46 of that, and 20, 10, 14 times one factorization of D into irreducible factors.
    """
    random = Random(7)
    starts = [start(random, n) for _ in range(200)]
    times: dict[str, list[float]] = {"decided": [], "sealed": [], "stepped": [], "factored": []}
    answers = []
    for a, g in starts:
        times["decided"].append(own_seconds(lambda a=a, g=g: answers.append(decide(a, g, max_steps=400))))
        times["sealed"].append(own_seconds(lambda: answers[-1].certificate))
        times["stepped"].append(own_seconds(lambda a=a, g=g: stepped(a, g, bound)))
        D = self_pairing(a, g)
        times["factored"].append(own_seconds(lambda D=D: D.factor()))
    middle = {k: median(v) for k, v in times.items()}
    undecided = sum(x.behaviour == "undecided" for x in answers)
    print(f"\norder {n}: median decision {1e3 * middle['decided']:.2f} ms, {middle['decided'] / middle['stepped']:.2f} of {bound} exact steps, "
          f"{middle['decided'] / middle['factored']:.0f} factorizations of D; limit and certificate {1e3 * middle['sealed']:.2f} ms; {undecided} undecided")
    assert middle["decided"] <= middle["stepped"]


def ten_thousand_sums():
    """The baseline of a millisecond or so: 10,000 additions of rational numbers."""
    x, y = fmpq(1, 3), fmpq(2, 7)
    for _ in range(10_000):
        x + y


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_a_decision_takes_milliseconds(n):
    """The median decision takes at most twice the time of 10,000 additions of rational numbers, and less than 2 ms where these take a millisecond.

    What the limit and the certificate add, which are found when they are asked for, is measured besides.
    """
    random, times = Random(3), {"decided": [], "limit": [], "sealed": []}
    for _ in range(200):
        kept: list = []
        begun, decider = (rational_start(random), decide_order_one) if n == 1 else (start(random, n), decide)
        times["decided"].append(own_seconds(lambda begun=begun, decider=decider, kept=kept: kept.append(decider(*begun))))
        limit = own_seconds(lambda kept=kept: kept[0].limit)
        times["limit"] += [limit] * (kept[0].behaviour == "converges")
        times["sealed"].append(own_seconds(lambda kept=kept: kept[0].certificate))
    middle = {k: 1e3 * median(v) for k, v in times.items()}
    base = 1e3 * min(own_seconds(ten_thousand_sums) for _ in range(9))
    print(f"\norder {n}: median decision {middle['decided']:.3f} ms, 10,000 sums {base:.3f} ms, ratio {middle['decided'] / base:.2f}; "
          f"the limit, where there is one, adds {middle['limit']:.3f} ms, the certificate {middle['sealed']:.3f} ms")
    assert middle["decided"] <= 2 * base
    assert middle["decided"] <= 2 * max(base, 1)


def self_pairing(a, g):
    """z^n D as an integer polynomial."""
    q = fmpq_poly([*(fmpq(x) + fmpq(y) for x, y in zip(a, g, strict=True))][::-1] + [fmpq(1)])
    s = fmpq_poly([fmpq(y) for y in g][::-1])
    n = len(a)
    return (q * reversal(q, n) - s * reversal(s, n)).numer()


def by_hand(starts):
    """Two bare processes: each decides half of the starts, and nothing is sent back."""
    gc.disable()
    try:
        child = os.fork()
        answers = decide_many(starts[::2] if child else starts[1::2])
        if not child:
            os._exit(0)
        os.waitpid(child, 0)
        assert len(answers) == len(starts[::2])
    finally:
        gc.enable()


def mixed_starts(count):
    """As many starts of each of the orders 1, 2, 3, 4, of all the kinds of the tests."""
    random, starts = Random(2), []
    while len(starts) < count:
        n = len(starts) % 4 + 1
        a, g = start(random, n) if n > 1 else ((), ())
        if n == 1:
            starts.append(rational_start(random))
        elif g[0] * g[0] != 1:
            starts.append({"a": a, "g": g})
    return starts


two_processors = pytest.mark.skipif((os.cpu_count() or 1) < 2 or not hasattr(os, "fork"), reason="one processor, or no fork")


def compared(starts, rounds):
    """One process, two, and two bare ones, in turn: the least wall clock and the mean processor time of each."""
    calls = (lambda: decide_many(starts), lambda: decide_many(starts, jobs=2), lambda: by_hand(starts))
    times = [[clocked(call) for call in calls] for _ in range(rounds)]
    least = [min(t[k][0] for t in times) for k in range(3)]
    work = [sum(t[k][1] for t in times) / rounds for k in range(3)]
    one, two, bare = least
    print(f"\n{len(starts)} decisions: one process {one:.2f} s, {1e3 * one / len(starts):.2f} ms each; two {two:.2f} s, ratio {one / two:.2f}; "
          f"two bare ones {bare:.2f} s, ratio {one / bare:.2f}; processor time {', '.join(f'{x:.2f}' for x in work)} s")
    return least, work


def clocked(call):
    """Wall clock and processor time of one call, children included."""
    started, wall = os.times(), perf_counter()
    call()
    wall, ended = perf_counter() - wall, os.times()
    return wall, sum(ended[:4]) - sum(started[:4])


@two_processors
def test_ten_thousand_decisions_of_orders_one_to_four_on_two_processors():
    """10,000 decisions, a quarter of each order, take two processes a 1.7th of the time of one or less, on a machine with nothing else to do.

    What both compute together (user and system time, which is disturbed less) is little more than what one does.
    """
    (one, two, _), (work, shared, _) = compared(mixed_starts(10_000), 1)
    assert shared <= 1.15 * work
    assert one >= 1.7 * two


@two_processors
def test_ten_thousand_decisions_of_order_one_on_two_processors():
    """A decision of order one takes some 40 microseconds, to hand over its answer almost half of that: a second process gains little or nothing.

    What both compute together is at most twice what one does.
    """
    random = Random(2)
    _, (work, shared, _) = compared([rational_start(random) for _ in range(10_000)], 7)
    assert shared <= 2 * work
