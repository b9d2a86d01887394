# SPDX-License-Identifier: MIT
"""Answers about many filters kept in the file of --json: a stopped call goes on from there, and believes nothing that is about other data."""

import errno
import itertools
import json

import pytest
from click.testing import CliRunner

from exactkf.cli import main
from exactkf.dynamics import analyze, batch, kept
from exactkf.dynamics.answer import Answer
from exactkf.dynamics.kept import outcome_of, record_of

ROWS = ["a,g", "1/2,1/3", "3,1", "-3,1/2", '"1/2,1","1/3,1/4"', "5/2,1/2"]  # the second is refused


@pytest.fixture
def call(tmp_path, monkeypatch):
    """Calls the command on the rows; gives what it says, and which filters it decided. It may be stopped after some of them."""
    decide = batch.outcomes
    monkeypatch.chdir(tmp_path)

    def called(*args, rows=ROWS, stop=None, **how):
        decided = []

        def outcomes(pending, **options):
            for place, outcome in reversed(list(itertools.islice(decide(pending, jobs=1, asked=options["asked"]), stop))):  # not in their order
                decided.append(place)
                yield place, how.get("found", outcome)
            if stop is not None:
                raise KeyboardInterrupt

        monkeypatch.setattr(batch, "outcomes", outcomes)
        (tmp_path / "f.csv").write_text("\n".join(rows) + "\n")
        done = CliRunner().invoke(main, ["analyze", "f.csv", *map(str, args)])
        return done, len(decided)

    return called


@pytest.mark.parametrize("name", ["o.jsonl", "o.json"])
@pytest.mark.parametrize("stop", range(5))
def test_a_stopped_call_goes_on(call, tmp_path, name, stop):
    """Wherever it is stopped, the same call decides the rest, and says and writes what one that was not stopped does; a third decides nothing."""
    expected, _ = call("--json", f"whole{name}")
    whole = (tmp_path / f"whole{name}").read_text()
    stopped, count = call("--json", name, stop=stop)
    assert (stopped.exit_code, count) == (130, stop)
    assert stopped.stderr.endswith(f"exactkf: stopped; {stop} of 5 answers are in '{name}': the same command goes on from there\n")
    assert len(json.loads((tmp_path / name).read_text()) if name == "o.json" else (tmp_path / name).read_text().splitlines()) == stop
    for known in (stop, 5):
        done, count = call("--json", name)
        assert (done.exit_code, done.stdout, count, (tmp_path / name).read_text()) == (2, expected.stdout, 5 - known, whole)
        assert (f"{known} of 5 answers were in '{name}'; --fresh decides them again\n" in done.stderr) == (known > 0)
    done, count = call("--json", name, "--fresh", stop=1)
    assert count == 1 and done.stderr.endswith("1 of 5 answers are in '" + name + "': the same command without --fresh goes on from there\n")


def test_only_the_same_data_and_code_are_believed(call, tmp_path, monkeypatch):
    """Another order of the filters changes nothing, and neither do lines that are no records; another filter, a line that was edited, and other code do."""
    call("--json", "o.jsonl")
    done, count = call("--json", "o.jsonl", rows=[ROWS[0], *reversed(ROWS[1:])])
    assert count == 0 and done.stdout.splitlines()[0] == "f.csv:2: order 1: the orbit converges"
    assert [json.loads(x)["filter"] for x in (tmp_path / "o.jsonl").read_text().splitlines()] == [f"f.csv:{k}" for k in range(2, 7)]
    assert call("--json", "o.jsonl", rows=[*ROWS, "1/7,1/7"])[1] == 1
    assert call("--json", "o.jsonl", "--pi0", "1/2", rows=ROWS[:2])[1] == 1
    call("--json", "o.jsonl")
    text = (tmp_path / "o.jsonl").read_text()
    lines = text.splitlines()
    for wrong in (text.replace('"converges"', '"escapes"', 1), text[:-30], "\n".join([lines[0][:50], *lines[1:]]), '{"key": 3}\n[1]\n' + "\n".join(lines[1:]),
                  text.replace('"rate": ', '"rates": ', 1)):
        (tmp_path / "o.jsonl").write_text(wrong)
        assert call("--json", "o.jsonl")[1] == 1 and (tmp_path / "o.jsonl").read_text() == text
    (tmp_path / "o.jsonl").write_bytes(b"\xff\n" + b"[" * 100000 + b"\n" + text.encode())
    assert call("--json", "o.jsonl")[1] == 0
    monkeypatch.setattr(kept, "code_digest", lambda parts: "another version")
    assert call("--json", "o.jsonl")[1] == 5


def test_what_is_left_open_is_believed_with_the_same_time_limit(call):
    """An answer that is not whole may be whole with more time."""
    late = Answer(2, "undecided", reason="out of time after 60 s while deciding")
    assert [call("--json", "o.jsonl", *limit, found=late)[1] for limit in ((), (), ("--time-limit", 61), ("--time-limit", 61))] == [5, 0, 5, 0]


def test_certificates_are_of_their_answers(call, tmp_path):
    """An answer counts if its certificate is the one that was written with it; one of an earlier list goes away."""
    asked = ("--json", "o.jsonl", "--certificate", "certs")
    assert [call(*asked, stop=2)[1], call(*asked)[1], call(*asked)[1]] == [2, 3, 0]
    (tmp_path / "certs" / "3.json").write_text("{}")
    (tmp_path / "certs" / "4.json").unlink()
    assert call(*asked)[1] == 2
    assert CliRunner().invoke(main, ["check", "certs"]).exit_code == 0
    assert call(*asked, rows=[ROWS[0], *reversed(ROWS[1:])])[1] == 4  # the third kept its place
    assert sorted(x.name for x in (tmp_path / "certs").iterdir()) == ["1.json", "2.json", "3.json", "5.json"]
    assert CliRunner().invoke(main, ["check", "certs"]).exit_code == 0


def test_a_full_disk_leaves_the_lines_that_fit(call, tmp_path, monkeypatch):
    """What was written is believed later; what was cut short is not."""
    class Full:
        def __init__(self, *how, **more):
            self.file, self.left = open(*how, **more), 2  # noqa: SIM115

        def write(self, text):
            self.left -= 1
            self.file.write(text if self.left >= 0 else text[:9])
            if self.left < 0:
                raise OSError(errno.ENOSPC, "No space left on device")

        def __getattr__(self, name):
            return getattr(self.file, name)

    monkeypatch.setattr(kept, "open", Full, raising=False)
    done, _ = call("--json", "o.jsonl")
    assert done.exit_code == 2
    assert done.stderr.splitlines()[-1] == "exactkf: argument --json = 'o.jsonl' cannot be written (No space left on device); choose another place"
    assert not (tmp_path / "o.jsonl").read_text().endswith("\n")
    monkeypatch.undo()
    monkeypatch.chdir(tmp_path)
    assert "2 of 5 answers were in 'o.jsonl'" in CliRunner().invoke(main, ["analyze", "f.csv", "--json", "o.jsonl"]).stderr


@pytest.mark.parametrize("option", ["--json", "--certificate", "--latex"])
def test_the_file_of_filters_is_not_written_over(tmp_path, option):
    """A file that is read is not one to write."""
    file = tmp_path / "f.jsonl"
    file.write_text('{"a": [1], "g": [0]}\n')
    done = CliRunner().invoke(main, ["analyze", str(file), option, str(file)])
    assert (done.exit_code, done.stdout, file.read_text()) == (2, "", '{"a": [1], "g": [0]}\n')
    assert done.stderr.startswith(f"exactkf: argument '{option}' is the FILE of filters itself")


def test_an_answer_comes_back_from_its_record():
    """Whole but for what the record leaves out."""
    answer = analyze(alpha=[0, 2], gamma=["1/2", "1/3"])
    record = json.loads(json.dumps(record_of("x", answer)))
    back = outcome_of(record)
    assert record_of("x", back) == record and back.facts == answer.facts and str(outcome_of({"error": "no"})) == "no"
