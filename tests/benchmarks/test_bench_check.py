# SPDX-License-Identifier: MIT
"""Replaying certificates against finding them, over whole sections of the papers in one run.

Both sides are measured in processor time, which other programs on the machine change less than time by the clock, and certificates
are replayed as they are in use: by the checker alone, in a process of its own, from the files that were written.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time

import pytest

from exactkf.claims import find, load
from exactkf.engine import verify_claim

pytestmark = pytest.mark.benchmark

_REPLAY = """
import json, sys, time
from exactkf.kernel.replay import replay
certificates = json.load(open(sys.argv[1]))
started = time.process_time()
for certificate in certificates:
    replay(certificate)
print(time.process_time() - started)
"""


@pytest.mark.parametrize("key", ["BLZ94", "BLM91", "B93", "D71", "NWL92"])
def test_checking_is_ten_times_faster_than_finding(key, tmp_path):
    """All certificates of a paper replay in a tenth of the time it takes to find them (search, proofs, mutants)."""
    claims = find([key], load())[::5]
    started = time.process_time()
    certificates = [c for claim in claims for c in verify_claim(claim)["certificates"]]
    finding = time.process_time() - started
    path = tmp_path / "certificates.json"
    path.write_text(json.dumps(certificates), encoding="utf-8")
    checking = float(subprocess.run([sys.executable, "-c", _REPLAY, str(path)], check=True, capture_output=True, text=True).stdout)
    print(f"\n{key}: {len(certificates)} certificates, found in {finding:.2f} s, checked in {checking:.2f} s, ratio {finding / checking:.1f}")
    assert finding >= 10 * checking
