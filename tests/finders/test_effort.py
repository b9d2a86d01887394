# SPDX-License-Identifier: MIT
"""A search that counts its steps ends at the same place on every machine."""

import time

from exactkf.finders import effort
from exactkf.finders.completion import _KEPT
from exactkf.finders.membership import search_membership
from exactkf.language import Statement, matrix, symbols

A, B, n = symbols("A B n")
OUT_OF_REACH = Statement(A**2 * B == B * A**2, sizes=["n"], over={"A": matrix(n, n), "B": matrix(n, n)},
                         given={"cubes": A**3 == B**3, "words": A * B * A == B * A * B, "mixed": A * B**2 * A == B}).to_json()


def how_far(seconds):
    _KEPT.clear()
    started = effort._steps
    with effort.counted():
        found = search_membership(OUT_OF_REACH, degree=14, seconds=seconds)
    return str(found), effort._steps - started


def test_counted_steps_do_not_depend_on_the_clock(monkeypatch):
    """With a wall clock that leaps by an hour at each look, a counted search goes exactly as far."""
    before = how_far(0.05)
    monkeypatch.setattr(time, "perf_counter", iter(range(0, 10**9, 3600)).__next__)
    assert how_far(0.05) == before
    assert before[1] > 0


def test_a_search_ends_when_its_steps_are_spent():
    """Ten times the steps go further, and the search says that time ran out."""
    few, many = how_far(0.01), how_far(0.1)
    assert "out of time" in few[0] and few[1] < many[1]
