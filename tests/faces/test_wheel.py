# SPDX-License-Identifier: MIT
"""The built wheel carries the claims: it verifies them away from the checkout."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_the_wheel_verifies_away_from_the_checkout(tmp_path):
    """Built, unpacked and run elsewhere, with nothing of the checkout on the path."""
    build = [sys.executable, "-m", "build", "--wheel", "--outdir", str(tmp_path), str(ROOT)]
    done = subprocess.run(build, capture_output=True, text=True, timeout=500)
    assert done.returncode == 0, done.stdout + done.stderr
    [wheel] = tmp_path.glob("*.whl")
    place = tmp_path / "unpacked"
    zipfile.ZipFile(wheel).extractall(place)
    assert (place / "exactkf" / "py.typed").is_file() and (place / "proofs" / "verdicts.json").is_file()
    where = "import exactkf, proofs; print(exactkf.__file__); print(proofs.__file__)"
    call = {"cwd": tmp_path, "env": {**os.environ, "PYTHONPATH": str(place)}, "capture_output": True, "text": True, "timeout": 300}
    found = subprocess.run([sys.executable, "-P", "-c", where], **call)
    assert all(line.startswith(str(place)) for line in found.stdout.splitlines()) and found.stdout.count("\n") == 2, found
    run = subprocess.run([sys.executable, "-P", "-m", "exactkf", "verify", "BLZ94-E2.18", "B93-S23", "--jobs", "1"], **call)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "2 of 2 claims reached what is on record" in run.stdout
