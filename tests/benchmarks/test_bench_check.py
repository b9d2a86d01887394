# SPDX-License-Identifier: MIT
"""Replaying certificates against finding them, over whole sections of the papers in one run.

Both sides are measured in processor time, which other programs on the machine change less than time by the clock, and certificates
are replayed as they are in use: by the checker alone, in a process of its own, from the files that were written.
"""

from __future__ import annotations

import time

import pytest

from exactkf.claims import find, load
from exactkf.engine import verify_claim
from tests.benchmarks.alone import seconds_to_replay

pytestmark = pytest.mark.benchmark

def test_checking_is_ten_times_faster_than_finding(tmp_path):
    """The certificates of every fifth claim replay in a tenth of the time it takes to find them (search, proofs, mutants).

    For each paper by itself. They differ, as the table printed shows. What counts as finding is all that `verify_claim` does before a
    certificate stands: instances, search, proofs, and the mutants that the same evidence must reject. Of a proof at a generic index, whose
    lemmas come with the claim, the search alone, without instances and mutants, is for its cases, and takes about three times a replay.
    """
    spans = {key: _spans(key, tmp_path / f"{key}.json") for key in ("B93", "BLM91", "BLZ94", "D71", "NWL92")}
    for key, (finding, checking) in spans.items():
        print(f"\n{key}: found in {finding:.2f} s, checked in {checking:.2f} s, ratio {finding / checking:.1f}", end="")
    finding, checking = map(sum, zip(*spans.values(), strict=True))
    print(f"\nall: found in {finding:.2f} s, checked in {checking:.2f} s, ratio {finding / checking:.1f}")
    assert [key for key, (finding, checking) in spans.items() if finding < 10 * checking] == []


def _spans(key, path):
    """Processor time of finding the certificates of every fifth claim of a paper, and of checking them."""
    claims = find([key], load())[::5]
    started = time.process_time()
    certificates = [c for claim in claims for c in verify_claim(claim)["certificates"]]
    finding = time.process_time() - started
    return finding, seconds_to_replay(certificates, path)
