# SPDX-License-Identifier: MIT
"""Wrong calls, and the commands that only look."""

import json
import subprocess
import sys

import pytest

from exactkf.display import ranges
from exactkf.kernel.replay import seal

STATEMENT = {"sizes": [], "over": [["a", ["scalar"]]], "where": [], "given": [],
             "says": [">=", ["^", ["sym", "a"], 2], 0]}


@pytest.mark.parametrize(("args", "words"), [
    (["verify", "NOPE-1"], ["ID", "'NOPE-1'", "exactkf list"]),
    (["verify", "AAA-E4"], ["did you mean AAA-E"]),
    (["verify", "--jobs", "0"], ["--jobs", "0"]),
    (["verify", "--jobs", "x"], ["--jobs", "'x'"]),
    (["verify", "--time-limit", "0"], ["--time-limit", "'0'", "above 0"]),
    (["verify", "--time-limit", "nan"], ["--time-limit", "'nan'"]),
    (["verify", "--time-limit", "inf"], ["--time-limit", "'inf'"]),
    (["verify", "--memory-limit", "-1"], ["--memory-limit", "-1"]),
    (["verify", "--seed", "-1"], ["--seed"]),
    (["verify", "--bogus"], ["--bogus", "exactkf verify --help"]),
    (["verify", "--json", "none/out.json"], ["--json", "'none/out.json'", "create"]),
    (["verify", "--json", "."], ["--json", "'.'", "name a file"]),
    (["verify", "--certificates", "fake_engine.py"], ["--certificates", "'fake_engine.py'", "name a folder"]),
    (["verify", "--state", "fake_engine.py"], ["--state", "'fake_engine.py'", "name a folder"]),
    (["report", "-o", "none/page.html"], ["--output", "'none/page.html'"]),
    (["show", "AAA"], ["ID", "'AAA'", "3 claims"]),
    (["show"], ["ID", "exactkf show --help"]),
    (["check"], ["PATH"]),
    (["check", "nowhere"], ["PATH", "'nowhere'", "does not exist"]),
    (["check", "fake_proofs"], ["PATH", "no .json file"]),
    (["frobnicate"], ["frobnicate"]),
])
def test_wrong_calls_are_one_line(paper, args, words):
    p = paper("ok")
    before = sorted(f.name for f in p.root.iterdir())
    done = p.run(*args)
    assert done.exit_code == 2, done.output
    assert done.stdout == "" and done.stderr.count("\n") == 1 and done.stderr.startswith("exactkf: ")
    for word in words:
        assert word in done.stderr
    assert sorted(f.name for f in p.root.iterdir()) == before
    assert p.calls() == []


def test_check_tells_the_three_outcomes_apart(paper):
    p = paper("ok")
    good = seal("X-1", "instances", STATEMENT, {"instances": [{"sizes": {}, "values": {"a": "2"}}], "seed": 0})
    wrong = seal("X-1", "counterexample", STATEMENT, {"instance": {"sizes": {}, "values": {"a": "2"}}})
    for name, data in (("good", good), ("wrong", wrong), ("altered", {**good, "id": "X-2"}), ("none", {"a": 1}),
                       ("old", {**good, "version": 0})):
        (p.root / f"{name}.json").write_text(json.dumps(data))
    (p.root / "cut.json").write_text('{"format": "exa')
    (p.root / "deep.json").write_text("[" * 100_000)
    assert p.run("check", "good.json").exit_code == 0
    assert p.run("check", "good.json").stdout == "1 of 1 certificates replay\n"
    done = p.run("check", "wrong.json", "altered.json", "good.json")
    assert done.exit_code == 1
    assert "wrong.json: does not replay: counterexample: the conclusion holds there" in done.stdout
    assert "altered.json: does not replay: digest" in done.stdout and "1 of 3" in done.stdout
    for name in ("none", "old", "cut", "deep"):
        done = p.run("check", f"{name}.json")
        assert done.exit_code == 2 and done.stderr.count("\n") == 1 and f"'{name}.json'" in done.stderr, done.output
    assert p.run("check", p.root).exit_code == 1


def test_check_needs_the_checker_alone(tmp_path):
    call = ("import sys; from exactkf.cli import main\ntry: main(['check', sys.argv[1]])\nexcept SystemExit: pass\n"
            "print(sorted(m for m in sys.modules if m.split('.')[0] in ('exactkf', 'flint', 'sympy', 'proofs')))")
    out = subprocess.run([sys.executable, "-c", call, tmp_path], capture_output=True, text=True, check=True).stdout
    allowed = {"exactkf", "exactkf._errors", "exactkf.cli", "exactkf.check", "exactkf.progress"}
    assert {m for m in json.loads(out.replace("'", '"')) if not m.startswith("exactkf.kernel")} == allowed


def test_list_and_help(paper):
    p = paper("ok")
    assert p.run("list", "AAA").stdout.splitlines()[0] == "AAA-E1  not on record             sums commute"
    assert p.run("list", "AAA/section_1").stdout.count("\n") == 3
    assert "Commands:" in p.run().output
    for command in ("verify", "check", "show", "list", "mutate", "report"):
        assert p.run(command, "--help").exit_code == 0
    assert p.run("--version").stdout.startswith("exactkf, version ")


def test_mutate(paper):
    p = paper("weak", "ok")
    done = p.run("mutate", "BBB", "--jobs", "1")
    assert done.exit_code == 1
    assert "BBB-ok: 1 of 1 mutants rejected" in done.stdout and "survived  sign: a - b" in done.stdout
    assert "in all: 1 rejected, 1 survived" in done.stdout


def test_ranges():
    assert ranges([3, 1, 2, 6, 8, 9]) == "1..3, 6, 8, 9"
