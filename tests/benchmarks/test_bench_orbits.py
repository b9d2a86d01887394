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


def processor_seconds(call):
    """User and system time of one call, children included."""
    start = os.times()
    call()
    end = os.times()
    return sum(end[:4]) - sum(start[:4])


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
        answers = [decide_order_one(*s) for s in (starts[::2] if child else starts[1::2])]
        if not child:
            os._exit(0)
        os.waitpid(child, 0)
        assert len(answers) == len(starts) // 2
    finally:
        gc.enable()


@pytest.mark.skipif((os.cpu_count() or 1) < 2 or not hasattr(os, "fork"), reason="one processor, or no fork")
def test_ten_thousand_decisions_on_two_processors():
    """10,000 decisions take two processes little longer than two bare ones that are given half each by hand and return nothing.

    Where these two need little more than half the time of one process, so does `decide_many`.  What both processes compute together
    (user and system time, which other work on the machine disturbs less) is little more than what one does.
    """
    random = Random(2)
    starts = [rational_start(random) for _ in range(10_000)]
    calls = (lambda: decide_many(starts), lambda: decide_many(starts, jobs=2), lambda: by_hand(starts))
    times = [tuple(clock(call) for clock in (seconds, processor_seconds) for call in calls) for _ in range(7)]
    one, two, bare = (min(t[k] for t in times) for k in range(3))
    work, shared, halves = (sum(t[k] for t in times) / len(times) for k in range(3, 6))
    print(f"\n10,000 decisions: one process {one:.2f} s; two {two:.2f} s, ratio {one / two:.2f}; two bare ones {bare:.2f} s, ratio {one / bare:.2f}; "
          f"processor time {work:.2f}, {shared:.2f}, {halves:.2f} s")
    assert shared <= 1.2 * work
    assert two <= 1.2 * bare
    assert one >= 1.7 * two or one < 1.9 * bare
