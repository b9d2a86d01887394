# SPDX-License-Identifier: MIT
"""Speed of the decisions about orbits, as ratios to exact stepping and to one process in the same run."""

from __future__ import annotations

import os
from random import Random
from time import perf_counter

import pytest

from exactkf.dynamics import decide_many, decide_order_one
from exactkf.kernel.replay import replay
from tests.dynamics.brute import filter_orbit
from tests.dynamics.starts import rational_start

pytestmark = pytest.mark.benchmark


def seconds(call):
    """Time of one call."""
    start = perf_counter()
    call()
    return perf_counter() - start


def test_a_decision_takes_less_than_a_few_hundred_exact_steps():
    """Deciding 300 rational starts for all t, certificates included, takes less time than stepping them 100 steps."""
    random = Random(1)
    starts = [rational_start(random) for _ in range(300)]
    answers = []
    ours = seconds(lambda: answers.extend(decide_order_one(*s) for s in starts))
    stepping = seconds(lambda: [filter_orbit(*s, 100) for s in starts])
    checking = seconds(lambda: [replay(a.certificate) for a in answers])
    print(f"\n300 rational starts: decided in {1e3 * ours / 300:.2f} ms each, 100 exact steps {1e3 * stepping / 300:.2f} ms, "
          f"ratio {ours / stepping:.2f}; checked in {1e3 * checking / 300:.2f} ms")
    assert ours <= stepping


@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="one processor")
def test_ten_thousand_decisions_on_two_processors():
    """10,000 decisions take two processes little more than half the time of one."""
    random = Random(2)
    starts = [rational_start(random) for _ in range(10_000)]
    times = [(seconds(lambda: decide_many(starts)), seconds(lambda: decide_many(starts, jobs=2))) for _ in range(4)]
    one, two = (min(t[k] for t in times) for k in (0, 1))
    print(f"\n10,000 decisions: one process {one:.2f} s, two {two:.2f} s, ratio {one / two:.2f}")
    assert one >= 1.7 * two
