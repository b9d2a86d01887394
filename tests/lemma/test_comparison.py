# SPDX-License-Identifier: MIT
"""The comparison with other systems asks the question that it says it asks."""

from __future__ import annotations

import importlib.util
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
        assert [] == [title for title in answers if f"| {title} |" not in table]
    finally:
        del sys.modules["compare_words"]
