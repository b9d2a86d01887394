# SPDX-License-Identifier: MIT
"""The command `exactkf lemma`."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from exactkf.check import check_paths
from exactkf.cli import main
from exactkf.kernel.replay import replay

FALSE = "sizes n m\nmatrix A n m\nmatrix L m n\nassume L*A == I\nclaim A*L == I\n"


def run(*args: object):
    return CliRunner().invoke(main, ["lemma", *map(str, args)])


def test_a_proof(tmp_path):
    """Lemma, verdict and assumptions on the terminal, certificates and JSON in files, exit code 0."""
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "joseph-9-order.json").write_text("{}")  # of an earlier run
    (tmp_path / "out" / "joseph-notes.json").write_text("{}")
    done = run(Path(__file__).with_name("joseph.lemma"), "--json", tmp_path / "joseph.json", "--certificates", tmp_path / "out")
    assert 0 == done.exit_code, done.output
    assert "proved for every size (assuming innovation; S^-1 exists by assumption 'innovation')" in done.stdout
    assert "claim (I(n) - K*M)*P*(I(n) - K*M)' + K*V*K' == P - K*M*P" in done.stdout
    assert ["joseph-1-membership.json", "joseph-notes.json"] == sorted(f.name for f in (tmp_path / "out").iterdir())
    assert 0 == check_paths([tmp_path / "out" / "joseph-1-membership.json"])
    data = json.loads((tmp_path / "joseph.json").read_text())
    assert "proved" == data["verdict"]
    replay(data["certificates"][0])


def test_a_refutation(tmp_path):
    """The matrices are shown row by row, exit code 1."""
    (tmp_path / "false.lemma").write_text(FALSE)
    done = run(tmp_path / "false.lemma")
    assert 1 == done.exit_code, done.output
    assert "refuted: A*L = I(n) does not hold for the matrices below" in done.stdout
    assert "n = 2, m = 1" in done.stdout and "L = [ " in done.stdout


def test_the_time_limit_ends_it(tmp_path):
    """Past the time limit the lemma is open, whatever was under way, and exit code 1."""
    (tmp_path / "long.lemma").write_text("matrix A, B 8 8\nclaim det(A*B) == det(A)*det(B)\n")
    done = run(tmp_path / "long.lemma", "--time-limit", "0.7")
    assert 1 == done.exit_code, done.output
    assert "open: out of time after 0.7 s" in done.stdout


@pytest.mark.parametrize(("args", "words"), [
    (["nowhere.lemma"], ["FILE", "'nowhere.lemma'", "cannot be read"]),
    (["bad.lemma"], ["bad.lemma: line 3, column 7: the product A*A does not fit"]),
    (["binary.lemma"], ["'binary.lemma'", "UTF-8"]),
    (["false.lemma", "--degree", "0"], ["--degree", "0"]),
    (["false.lemma", "--time-limit", "nan"], ["--time-limit", "'nan'"]),
    (["false.lemma", "--json", "none/out.json"], ["--json", "'none/out.json'", "create"]),
    (["false.lemma", "--certificates", "false.lemma"], ["--certificates", "name a folder"]),
    ([], ["FILE", "exactkf lemma --help"]),
])
def test_wrong_calls_are_one_line(tmp_path, monkeypatch, args, words):
    """Exit code 2, one line on stderr, no traceback, nothing written."""
    monkeypatch.chdir(tmp_path)
    Path("false.lemma").write_text(FALSE)
    Path("bad.lemma").write_text("sizes n m\nmatrix A n m\nclaim A*A == 0\n")
    Path("binary.lemma").write_bytes(b"\xff\xfe\x00")
    done = run(*args)
    assert 2 == done.exit_code, done.output
    assert "" == done.stdout
    assert 1 == done.stderr.count("\n")
    assert done.stderr.startswith("exactkf: ")
    for word in words:
        assert word in done.stderr
    assert ["bad.lemma", "binary.lemma", "false.lemma"] == sorted(f.name for f in tmp_path.iterdir())
