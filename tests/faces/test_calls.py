# SPDX-License-Identifier: MIT
"""Wrong calls, and the commands that only look."""

import errno
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import pytest

import exactkf.check
import exactkf.files
from exactkf._errors import BadInput
from exactkf.display import ranges
from exactkf.files import write_text
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
    allowed = {"exactkf", "exactkf._errors", "exactkf.cli", "exactkf.check", "exactkf.entered", "exactkf.files", "exactkf.progress"}
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


def test_what_can_never_be_written_is_one_line(paper, monkeypatch):
    """A disk that fills up while a file is written: nothing half written stays, and what was run is kept."""
    p = paper("ok")
    assert p.run("verify", "BBB").exit_code == 1
    before = sorted(f.name for f in p.root.iterdir())

    def full(*_, **__):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(exactkf.files.os, "replace", full)
    for args, argument in ((["verify", "BBB", "--json", "out.json"], "--json"), (["report", "BBB", "-o", "page.html"], "--output"),
                           (["verify", "BBB", "--certificates", "certs"], "--certificates"), (["verify", "BBB", "--record"], "--record")):
        done = p.run(*args)
        assert done.exit_code == 2 and done.stderr.count("\n") == 1 and argument in done.stderr and "No space left" in done.stderr, done.output
    assert [f.name for f in p.root.iterdir() if f.suffix in (".json", ".html") or f.name.endswith(".part")] == []
    assert sorted(f.name for f in p.root.iterdir() if f.name != "certs") == before
    assert p.calls() == ["BBB-ok"]


def test_a_link_stays_a_link_and_a_pipe_is_written_to(tmp_path):
    (tmp_path / "there.txt").write_text("old")
    (tmp_path / "link.txt").symlink_to("there.txt")
    write_text(tmp_path / "link.txt", "new")
    assert (tmp_path / "link.txt").is_symlink() and (tmp_path / "there.txt").read_text() == "new"
    os.mkfifo(tmp_path / "pipe")
    with ThreadPoolExecutor(1) as pool:
        heard = pool.submit((tmp_path / "pipe").read_text)
        write_text(tmp_path / "pipe", "through")
        assert heard.result(timeout=20) == "through"
    assert (tmp_path / "pipe").is_fifo()


@pytest.mark.parametrize("unbuffered", ["", "1"])
@pytest.mark.parametrize("args", [["list"], ["--help"], []], ids=" ".join)
def test_output_that_cannot_be_written(args, unbuffered):
    """A reader that went away has its own exit status, neither 0 nor 1; a full device is one line."""
    environment = {**os.environ, "PYTHONUNBUFFERED": unbuffered}
    call = [sys.executable, "-m", "exactkf", *args]
    read, write = os.pipe()
    os.close(read)
    done = subprocess.run(call, stdout=write, stderr=subprocess.PIPE, text=True, env=environment)
    os.close(write)
    assert (done.returncode, done.stderr) == (141, "")
    if os.path.exists("/dev/full"):
        with open("/dev/full", "w") as full:
            done = subprocess.run(call, stdout=full, stderr=subprocess.PIPE, text=True, env=environment)
        assert done.returncode == 2 and done.stderr.count("\n") == 1 and "standard output cannot be written" in done.stderr


def test_kept_results_that_are_no_text_are_passed_over(paper):
    p = paper("ok")
    p.run("verify", "BBB")
    with open(p.root / ".exactkf" / "results.jsonl", "ab") as file:
        file.write(b"\xff\xfe no text\n")
    assert "1 of 1 results are from an earlier run" in p.run("verify", "BBB").stdout


@pytest.mark.parametrize("edit", [lambda r: 5, lambda r: {"id": r["id"]}, lambda r: {**r, "certificates": 5}, lambda r: {**r, "mutants": None}])
def test_kept_results_that_were_edited_run_again(paper, edit):
    p = paper("ok")
    p.run("verify", "BBB")
    kept = p.root / ".exactkf" / "results.jsonl"
    entry = json.loads(kept.read_text())
    kept.write_text(json.dumps({**entry, "result": edit(entry["result"])}) + "\n")
    assert "earlier run" not in p.run("verify", "BBB").stdout and p.calls() == ["BBB-ok"] * 2


def test_a_folder_that_cannot_be_written_still_shows_what_it_keeps(paper, monkeypatch):
    p = paper("ok", "other")
    p.run("verify", "BBB-ok")
    monkeypatch.setattr(exactkf.files.os, "access", lambda *_: False)
    assert p.run("verify", "BBB-ok").exit_code == 1 and p.run("show", "BBB-ok").exit_code == 0
    done = p.run("verify", "BBB")
    assert done.exit_code == 2 and "--state" in done.stderr and p.calls() == ["BBB-ok"]


def test_a_file_without_end_is_no_certificate(tmp_path, monkeypatch):
    monkeypatch.setattr(exactkf.check, "_MOST_BYTES", 1 << 20)
    (tmp_path / "long.json").write_text("[" + "1," * (1 << 20))
    with pytest.raises(BadInput, match="longer than 1 MB"):
        exactkf.check.read_certificate(tmp_path / "long.json")
