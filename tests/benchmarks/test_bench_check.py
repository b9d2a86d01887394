# SPDX-License-Identifier: MIT
"""Replaying certificates against finding them, over whole sections of the papers in one run."""

from __future__ import annotations

import time

import pytest

from exactkf.claims import find, load
from exactkf.engine import verify_claim
from exactkf.kernel.replay import replay

pytestmark = pytest.mark.benchmark


@pytest.mark.parametrize("key", ["BLZ94", "BLM91", "B93", "D71", "NWL92"])
def test_checking_is_ten_times_faster_than_finding(key):
    """All certificates of a paper replay in a tenth of the time it takes to find them (search, proofs, mutants)."""
    claims = find([key], load())[::5]
    started = time.perf_counter()
    certificates = [c for claim in claims for c in verify_claim(claim)["certificates"]]
    finding = time.perf_counter() - started
    started = time.perf_counter()
    for certificate in certificates:
        replay(certificate)
    checking = time.perf_counter() - started
    print(f"\n{key}: {len(certificates)} certificates, found in {finding:.2f} s, checked in {checking:.2f} s, ratio {finding / checking:.1f}")
    assert finding >= 10 * checking
