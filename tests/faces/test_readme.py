# SPDX-License-Identifier: MIT
"""The examples of the README run as they are printed."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from exactkf import claims
from exactkf.engine import verify_claim

README = Path(__file__).parents[2] / "README.md"
BLOCKS = re.findall(r"^```python\n(.*?)^```", README.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)


@pytest.fixture
def registry(monkeypatch):
    """An empty registry, so that an example's claim does not join those of the papers."""
    empty: dict[str, claims.Claim] = {}
    monkeypatch.setattr(claims, "_REGISTRY", empty)
    return empty


def test_there_are_examples():
    """The README shows how a claim and a lemma of one's own are written."""
    assert len(BLOCKS) >= 2


@pytest.mark.parametrize("block", BLOCKS, ids=[str(k) for k in range(1, len(BLOCKS) + 1)])
def test_an_example_runs(block, registry, capsys):
    """An example runs; what it prints says that it holds or is decided, and so does the engine of each claim it registers."""
    exec(compile(block, str(README), "exec"), {"__name__": "readme"})
    printed = capsys.readouterr().out
    assert registry or printed
    assert all(line.startswith(("holds", "proved", "converges")) for line in printed.splitlines())
    for claim in registry.values():
        result = verify_claim(claim)
        assert (result["verdict"], result["reason"]) == ("holds", None)
