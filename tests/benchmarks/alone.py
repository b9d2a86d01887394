# SPDX-License-Identifier: MIT
"""Certificates replayed as in use: by the checker alone, in a process of its own, from JSON."""

from __future__ import annotations

import json
import subprocess
import sys

__all__ = ["seconds_to_replay"]

_REPLAY = """
import json, sys, time
from exactkf.kernel.replay import replay
texts = open(sys.argv[1], encoding="utf-8").read().splitlines()
started = time.process_time()
for text in texts:
    replay(json.loads(text))
print(time.process_time() - started)
"""


def seconds_to_replay(certificates, path):
    """Processor time of reading and replaying certificates, which are written to a file."""
    path.write_text("\n".join(map(json.dumps, certificates)), encoding="utf-8")
    return float(subprocess.run([sys.executable, "-c", _REPLAY, str(path)], check=True, capture_output=True, text=True).stdout)
