# SPDX-License-Identifier: MIT
"""What stands first in a row of a block matrix is seen, wherever a proof asks what a term is made of; and what takes too long is refused."""

from __future__ import annotations

import gc
import resource
import signal
import time

import pytest

from exactkf.kernel.__main__ import main
from exactkf.kernel.limits import patiently
from exactkf.kernel.replay import Rejected, replay, seal
from tests.kernel.test_false_claims import accepted, statement

t, z, k, i = ["sym", "t"], ["z"], ["sym", "k"], ["sym", "i"]


# ---------------------------------------------------------------------- rows
@pytest.mark.parametrize("matrix", [["block", [z]], ["rows", [z]], ["rows", [z, 0], [0, 1]], ["rows", [1, 0], [z, 1]], ["block", [["rows", [z]]]]])
def test_a_polynomial_in_a_row_is_one(matrix):
    """det [z] has a coefficient of z, and so has its entry."""
    where = [["let", "f", [], matrix]]
    for made in (matrix, ["sym", "f"]):
        for term in (["det", made], ["entry", made, 1, 1]):
            says = ["=", ["coeff", term, 1], 0]
            assert not accepted("generic index", statement(says, [["c", ["scalar"]]], (), where, sizes=[]), {"lemmas": []})


@pytest.mark.parametrize("row", [["entry", ["rows", [t]], 1, 1], ["entry", ["block", [t, 0]], 1, 1], ["det", ["rows", [t, 0], [0, 1]]]])
@pytest.mark.parametrize("called", [False, True])
def test_an_index_in_a_row_is_used(row, called):
    """X[t] = 1 for every t is not X[t] = (2 if t = 5 else 1), though 5 is not looked at."""
    where = [["rec", "X", "t", 0, [1], ["at", "X", t]], ["let", "f", ["k"], ["if", ["=", k, 5], 2, 1]]]
    says = ["always", "t", ["=", ["at", "X", t], ["at", "f", row] if called else ["if", ["=", row, 5], 2, 1]]]
    evidence = {"cases": [{}], "cofactors": [[[1, 0, 1]]]}
    assert not accepted("induction", statement(says, [], (), where, sizes=[]), evidence)
    assert accepted("induction", statement(["always", "t", ["=", ["at", "X", t], 1]], [], (), where, sizes=[]), evidence)


def test_a_bound_index_in_a_row_is_bound():
    """The i of the rows of a matrix is not the i outside: det of the one by one matrix 2^1 is not 2^i."""
    def det(x):
        return ["det", ["mat", "i", "j", 1, 1, ["^", 2, ["nrows", ["block", [["I", x]]]]]]]

    where = [["let", "f", ["k"], det(k)]]
    assert not accepted("generic index", statement(["forall", "i", 1, ["sym", "n"], ["=", det(i), ["at", "f", i]]], [], (), where), {"lemmas": []})


# ---------------------------------------------------------------------- patience
def lets(step, count, first):
    return [["let", "a0", [], first], *(["let", f"a{n + 1}", [], step(["sym", f"a{n}"])] for n in range(count))]


def nested(depth):
    return 1 if depth == 0 else ["sum", f"i{depth}", 1, 99999, nested(depth - 1)]


def doubled(count):
    return [["let", "f0", ["k"], k], *(["let", f"f{n + 1}", ["k"], ["+", *[["at", f"f{n}", k]] * 2]] for n in range(count))]


@pytest.mark.parametrize("where, says", [
    (lets(lambda a: ["*", a, a], 60, 3), ["=", ["sym", "a60"], 0]), (lets(lambda a: ["*", a, a], 60, ["rat", 3, 7]), ["=", ["sym", "a60"], 0]),
    ([["rec", "X", "t", 0, [3], ["*", ["at", "X", t], ["at", "X", t]]]], ["=", ["at", "X", 9999], 1]),
])
def test_large_numbers_are_refused(where, says):
    """3^(2^60) is not looked at."""
    began = time.process_time()
    with pytest.raises(Rejected, match="too large a value"):
        replay(seal("X", "evaluation", statement(says, [], (), where, sizes=[]), {"cases": [{}]}))
    assert time.process_time() - began < 10


@pytest.mark.parametrize("where, says", [
    (lets(lambda a: ["*", a, a], 60, ["+", z, 1]), ["=", ["sym", "a60"], 0]), ([], ["=", nested(4), 0]),
    (doubled(40), ["=", ["at", "f40", ["rat", 1, 3]], 0]), ([], ["=", ["^", ["mat", "i", "j", 100, 100, i], 99999], 0]),
])
def test_patience_ends(where, says):
    """Squares of squares, sums within sums and calls within calls end in one line, and the next certificate has its own time."""
    for _ in range(2):
        began = time.process_time()
        with pytest.raises(Rejected, match="given up after 0.3 seconds"), patiently(0.3):
            replay(seal("X", "evaluation", statement(says, [], (), where, sizes=[]), {"cases": [{}]}))
        assert 0.2 < time.process_time() - began < 10
    with patiently(0.3):
        pass


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
def test_patience_ends_though_a_signal_is_lost():
    """An exception does not get out of a callback of the garbage collector: the signal comes again."""
    ended = time.process_time() + 30

    def busy(*_):
        for _ in range(10**8):
            pass

    gc.callbacks.append(busy)
    with pytest.raises(Rejected, match="given up after 0.1 seconds"), patiently(0.1):
        gc.collect()
        gc.callbacks.remove(busy)
        while time.process_time() < ended:
            pass
    assert time.process_time() < ended


def spend(seconds):
    """Use the processor for so long."""
    ended = time.process_time() + seconds
    while time.process_time() < ended:
        pass


def standing():
    """What a certificate may leave behind with the system."""
    return signal.getsignal(signal.SIGPROF), signal.getitimer(signal.ITIMER_PROF), resource.getrlimit(resource.RLIMIT_AS)


def test_patience_within_patience():
    """The one around goes on after the one within, which has no more time than is left; none leaves anything behind."""
    before = standing()
    with pytest.raises(Rejected, match="given up after 0.5 seconds"), patiently(0.5):
        with patiently(60):
            spend(0.1)
        spend(30)
    began = time.process_time()
    with pytest.raises(Rejected), patiently(0.3), patiently(60):
        spend(30)
    assert time.process_time() - began < 10
    for seconds in (0, -1, float("nan"), 1e-300):
        with pytest.raises(Rejected), patiently(seconds):
            spend(30)
    assert standing() == before


@pytest.mark.parametrize("fault", [KeyError, MemoryError, KeyboardInterrupt, Rejected, RecursionError])
def test_what_ends_a_replay_leaves_nothing_behind(fault):
    """Whatever is raised comes out as it is, but for a lack of memory; one that was caught in between does not matter."""
    before = standing()
    with pytest.raises(Rejected if fault is MemoryError else fault), patiently(5), patiently(5):
        with pytest.raises(MemoryError):
            bytearray(1 << 40)
        raise fault("told")
    assert standing() == before


def test_no_more_memory_than_was_allowed():
    """A bound that stands already is not raised."""
    before = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (3 << 30, before[1]))
    try:
        with patiently():
            assert resource.getrlimit(resource.RLIMIT_AS)[0] == 3 << 30
    finally:
        resource.setrlimit(resource.RLIMIT_AS, before)


def test_memory_ends():
    """What would fill the memory is refused in one line, too."""
    with pytest.raises(Rejected, match="GB of memory"), patiently():
        bytearray(1 << 40)


def test_deep_nesting_is_no_certificate(tmp_path, capsys):
    """Five thousand brackets are too many for the reader, which says so in one line."""
    file = tmp_path / "deep.json"
    file.write_text('{"format": "exactkf-certificate", "says": ' + "[" * 5000 + "]" * 5000 + "}")
    assert main([str(file)]) == 2
    assert capsys.readouterr().err.count("\n") == 1


# ---------------------------------------------------------------------- values that are none
@pytest.mark.parametrize("says", [
    ["=", ["real_roots", z, 1, ["neg", 1]], ["neg", 1]], ["=", ["ncols", ["block", [["O", 0, 5]], [["I", 2]]]], 2],
    ["=", ["ncols", ["block", [["I", 2]], [["O", 0, 5]]]], 2],
])
def test_degenerate_values(says):
    """No interval has a negative number of roots; rows of blocks are of one width, also where one has no height."""
    assert not accepted("evaluation", statement(says, [], sizes=[]), {"cases": [{}]})
    assert accepted("evaluation", statement(["=", ["real_roots", z, 1, ["neg", 1]], 0], [], sizes=[]), {"cases": [{}]})
    assert accepted("evaluation", statement(["=", ["ncols", ["block", [["O", 0, 2]], [["I", 2]]]], 2], [], sizes=[]), {"cases": [{}]})
