# SPDX-License-Identifier: MIT
"""What ran of the checker, as a reading list."""

from __future__ import annotations

import inspect
import json
import re
import subprocess
import sys

import exactkf.kernel.words as words
from exactkf import prove_lemma
from exactkf.kernel.files import parsed
from exactkf.kernel.replay import replay

LEMMA = "sizes n\nmatrix A, B n n\nassume A invertible\nassume B invertible\nclaim (A*B)^-1 == B^-1*A^-1"


def reading(folder) -> str:
    """What a fresh process says, in which nothing is remembered from an earlier replay."""
    return subprocess.run([sys.executable, "-m", "exactkf", "check", str(folder), "--code"], capture_output=True, text=True, check=True).stdout


def test_what_runs_of_the_checker_is_listed(tmp_path):
    """The lines named are those of the functions, their number is the one given, and the summary comes first."""
    proof, *_ = prove_lemma(LEMMA).certificates
    (tmp_path / "proof.json").write_text(json.dumps(proof))
    replays, whole, *files = reading(tmp_path).splitlines()
    assert replays == "1 of 1 certificates replay"
    count, lines, of = map(int, re.fullmatch(r"what ran of the checker: (\d+) functions, (\d+) of its (\d+) lines", whole).groups())
    spans = {(file, name): (int(first), int(last)) for text in files for file in re.findall(r"kernel/(\w+)\.py", text)
             for name, first, last in re.findall(r"([\w.]+) (\d+)-(\d+)", text)}
    assert (len(spans), sum(last - first + 1 for first, last in spans.values())) == (count, lines) and lines < of / 4
    source, first = inspect.getsourcelines(words.multiply)
    assert spans["words", "multiply"] == (first, first + len(source) - 1)
    assert ("order", "replay_order") not in spans and not any(file == "orbit" for file, _ in spans)


def test_every_function_that_is_entered_is_listed(tmp_path):
    """The interpreter's own record of calls has no function of the checker that the list leaves out."""
    proof, *_ = prove_lemma(LEMMA).certificates
    (tmp_path / "proof.json").write_text(text := json.dumps(proof))
    listed = reading(tmp_path)
    calls = set()
    sys.settrace(lambda frame, event, _: calls.add(frame.f_code) if "/exactkf/kernel/" in frame.f_code.co_filename else None)
    try:
        replay(parsed(text))
    finally:
        sys.settrace(None)
    missing = [c.co_qualname for c in calls if "<" not in c.co_qualname and f" {c.co_qualname} {c.co_firstlineno}-" not in listed]
    assert calls and [] == missing
