# SPDX-License-Identifier: MIT
"""The comparison with other systems asks the question that it says it asks."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from pathlib import Path

FILE = Path(__file__).parents[1] / "benchmarks" / "compare_words.py"


def test_the_comparison_asks_what_exactkf_answers():
    """Each claim of the table is proved by exactkf, the false one is not, and every system gets letters for all words."""
    spec = importlib.util.spec_from_file_location("compare_words", FILE)
    compare = importlib.util.module_from_spec(spec)
    sys.modules["compare_words"] = compare
    try:
        spec.loader.exec_module(compare)
        answers = {q.title: compare.exactkf_(q)[0] for q in compare.questions()}
        assert {"the same with a wrong sign"} == {title for title, answer in answers.items() if answer != "proved"}
        joseph = next(q for q in compare.questions() if q.title.startswith("D71 Joseph"))
        assert joseph.letters == 1 + max(k for p in (*joseph.goals, *joseph.assumed) for word in p for k in word)
        table = (FILE.parent / "COMPARISON.md").read_text(encoding="utf-8")
        assert table.startswith(compare.HEAD)
        assert [] == [title for title in answers if f"| {title} |" not in table]
    finally:
        del sys.modules["compare_words"]


def test_the_comparison_runs_from_a_clone(tmp_path):
    """As its first lines say, with nothing installed: the packages of the clone are found from any folder."""
    program = f"import runpy; runpy.run_path({str(FILE)!r}); import exactkf, proofs; print(exactkf.__file__, proofs.__file__)"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, cwd=tmp_path, check=False)
    assert "" == done.stderr
    assert [str(FILE.parents[2] / name / "__init__.py") for name in ("exactkf", "proofs")] == done.stdout.split()
