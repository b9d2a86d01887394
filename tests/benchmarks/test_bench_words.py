# SPDX-License-Identifier: MIT
"""Words: expansion against a bare dictionary, replaying against reading JSON, and against finding."""

from __future__ import annotations

import time
from fractions import Fraction

import pytest

from exactkf.claims import load
from exactkf.engine import verify_claim
from exactkf.kernel.replay import replay, seal
from exactkf.kernel.words import multiply
from exactkf.language import Statement, matrix, standing, symbols
from exactkf.record import Record
from tests.benchmarks.alone import seconds_to_replay

pytestmark = pytest.mark.benchmark
KINDS = ("membership", "order", "word induction", "generic index")


def _best(run, times=5):
    spans = []
    for _ in range(times):
        started = time.perf_counter()
        run()
        spans.append(time.perf_counter() - started)
    return min(spans)


def _bare(power):
    out = {(): 1}
    for _ in range(power):
        new = {}
        for u, a in out.items():
            for v in "abc":
                new[u + (v,)] = new.get(u + (v,), 0) + a
        out = new
    return out


def _kernel(power):
    out = {((), ()): 1}
    for _ in range(power):
        out = multiply(out, {((), (v,)): 1 for v in "abc"})
    return out


def test_expansion_against_a_bare_dictionary():
    """(a + b + c)^7 takes at most three times what a dictionary of words alone takes."""
    assert {w: c for (_, w), c in _kernel(7).items()} == _bare(7)
    bare, ours = _best(lambda: _bare(7)), _best(lambda: _kernel(7))
    print(f"\n(a+b+c)^7: bare {1000 * bare:.2f} ms, with scalars and types {1000 * ours:.2f} ms, ratio {ours / bare:.2f}")
    assert ours <= 3 * bare


def test_ten_thousand_words_replay_like_adding_fractions():
    """A proof with 10,000 words replays in the time of 100,000 sums of Fractions, which is well under a second."""
    n, A, B = symbols("n A B")
    words = 5000
    statement = Statement(sizes=["n"], over={"A": matrix(n, n), "B": matrix(n, n)}, given=[standing("ab", A * B == B * A)],
                          says=A * B == B * A).to_json()
    terms = [["1", [], "ab/0/0/0", []]]
    for k in range(words // 2):  # multiples that cancel in pairs
        word = [("A", "B")[k >> i & 1] for i in range(12)]
        terms += [["1", word, "ab/0/0/0", word], ["-1", word, "ab/0/0/0", word]]
    certificate = seal("B", "membership", statement, {"terms": [terms]})

    def baseline():
        total = Fraction(0)
        for k in range(1, 100_001):
            total += Fraction(k, 8)
    ours, fractions = _best(lambda: replay(certificate), 3), _best(baseline, 3)
    print(f"\n{2 * words} words: {1000 * ours:.0f} ms; 100,000 sums of Fractions: {1000 * fractions:.0f} ms, ratio {ours / fractions:.2f}")
    assert ours <= fractions


def test_checking_is_twenty_times_faster_than_verifying(tmp_path):
    """The proofs for every size replay in a twentieth of the time that `verify_claim` takes for the claims that are proved by them: ten minutes.

    `verify_claim` searches for counterexamples, finds the proofs, and judges the mutants: that is what is compared. Without counterexamples
    and mutants the finding is a smaller multiple of the replay, as the proofs at a generic index are given but for their cases. The proofs
    are replayed as in use, by the checker alone in a process of its own, and read from JSON there. Both are measured in processor time.
    """
    verifying, proofs = 0.0, list[dict]()
    claims = load()
    for id, entry in Record.read().entries.items():
        if "proved" not in (entry.get("strength"), (entry.get("repair") or {}).get("strength")):
            continue
        claim = claims[id]
        started = time.process_time()
        own = [c for c in verify_claim(claim)["certificates"] if c["kind"] in KINDS]
        if own:
            verifying += time.process_time() - started
            proofs += own
    checking = seconds_to_replay(proofs, tmp_path / "proofs.jsonl")
    print(f"\n{len(proofs)} proofs; verified in {verifying:.2f} s, checked in {checking:.3f} s, ratio {verifying / checking:.0f}")
    assert proofs and verifying >= 20 * checking
