# SPDX-License-Identifier: MIT
"""Many filters: answers in order whatever decides them, files of filters, and ``exactkf analyze`` with many."""

import json
import os
import pickle
import random
import signal
import subprocess
import sys
from collections import deque
from concurrent.futures import Future, TimeoutError

import pytest
from click.testing import CliRunner

from exactkf._errors import BadInput
from exactkf.cli import main
from exactkf.dynamics import Filter, analyze, decide, decide_many, decide_order_one, decide_riccati_one
from exactkf.dynamics.files import read_filters
from exactkf.dynamics.many import _Piece, _taken
from exactkf.exact import sqrt_field
from exactkf.kernel.replay import replay
from tests.dynamics.starts import rational_start
from tests.dynamics.test_every_order import start

#: an order that takes long to decide
LONG = {"a": [f"{k % 7 - 3}/{k + 4}" for k in range(400)], "g": [f"{k % 5 - 2}/{k + 5}" for k in range(400)]}


def mixture(seed, count):
    """Starts of the orders one to four, with the answers of the deciders."""
    rng, starts, answers = random.Random(seed), [], []
    while len(starts) < count:
        n = len(starts) % 4 + 1
        if n == 1:
            starts.append(rational_start(rng))
            answers.append(decide_order_one(*starts[-1]))
            continue
        a, g = start(rng, n)
        if g[0] * g[0] != 1:
            starts.append({"a": a, "g": g})
            answers.append(decide(a, g))
    return starts, answers


# ---------------------------------------------------------------------- from Python
@pytest.mark.parametrize("how", [{}, {"jobs": 2}, {"jobs": 2, "time_limit": 60}])
def test_many_give_what_each_gives_alone(how):
    """Whatever decides a mixture of orders and forms, the answers are those of the deciders, in order, and certificates replay."""
    starts, expected = mixture(4, 40)
    root = sqrt_field(3).gen()
    starts += [(root, 1), ("sqrt(2)", "sqrt(3)"), (1, 2, 3), (["sqrt(2)", "1/2"], [0, "1/3"]), Filter.from_ag(["1/2", "1"], ["1/3", "1/4"])]
    expected += [decide_order_one(root, 1), analyze(alpha=["sqrt(2)"], gamma=["sqrt(3)"]), decide_riccati_one(1, 2, 3),
                 analyze(alpha=["sqrt(2)", "1/2"], gamma=[0, "1/3"]), analyze(a=["1/2", 1], g=["1/3", "1/4"])]
    answers = decide_many(starts, **how)
    assert [x.to_json() for x in answers] == [x.to_json() for x in expected]
    for x in answers[:12]:
        replay(x.certificate)


def test_an_answer_in_another_process_is_the_same():
    """What was not asked for is made there: pickled before or after the limit is found, an answer is equal."""
    for x in (analyze(alpha=[0, 2], gamma=["1/2", "1/3"]), analyze(alpha=["sqrt(2)", 0], gamma=["1/2", "1/3"]), decide_order_one(3, "1/2"),
              analyze(a=["1/2", "1"], g=["1/3", "1/4"])):
        early = pickle.dumps(x)
        full = x.to_json()
        assert pickle.loads(early).to_json() == full == pickle.loads(pickle.dumps(x)).to_json()
        assert str(pickle.loads(early)) == str(x)


@pytest.mark.parametrize("jobs", [1, 2])
@pytest.mark.parametrize(("starts", "words"), [
    ([(1,)], "starts[0] = (1,): not a filter"), ([(1, 2), "ab"], "starts[1] = 'ab': not a filter"), (5, "argument 'starts' is no list of filters: 5"),
    ([(1, 2), (0.5, 1)], "starts[1]: argument 'alpha' is a float"), ([(1, 2), {"alpha": [1]}], "starts[1]: argument 'gamma' is missing"),
    ([(3, 2)] * 7 + [([1, 2], [1])], "starts[7]: argument 'gamma' has length 1"), ([{"a": [1, 2], "g": [0, 1], "pi0": 1}], "starts[0]: argument 'pi0'"),
    ("none.csv", "argument 'FILE' cannot be read"),
])
def test_what_is_no_filter_is_named(starts, words, jobs):
    """The first entry that is refused, in one line."""
    with pytest.raises(BadInput) as caught:
        decide_many(starts, jobs=jobs)
    assert words in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize("limit", [0, -1, True, "1", float("inf"), float("nan")])
def test_a_time_limit_is_a_number_of_seconds(limit):
    """Anything else is refused."""
    with pytest.raises(BadInput, match="time_limit"):
        decide_many([], time_limit=limit)
    assert decide_many([]) == decide_many([], jobs=2) == []


def test_a_hard_filter_does_not_take_the_others_with_it():
    """The one that runs out of time is undecided and says so; those before and behind it are decided."""
    easy = {"alpha": [3], "gamma": ["1/2"]}
    answers = decide_many([easy, easy, LONG, easy, easy], jobs=2, time_limit=3)
    assert [x.behaviour for x in answers] == ["converges", "converges", "undecided", "converges", "converges"]
    assert (answers[2].order, answers[2].reason) == (400, "out of time after 3 s while deciding")


def test_what_is_decided_is_kept_when_the_limit_takes_too_long():
    """A piece out of time is asked one by one, then for the decision alone, which says what is missing; then it is undecided."""
    starts, piece, waiting = [{"alpha": [3], "gamma": ["1/2"]}] * 2, _Piece(0, 2, ("facts", "limit", "certificate")), deque()
    late, done = Future(), Future()
    late.set_exception(TimeoutError())
    assert not list(_taken(starts, piece, late, 5, waiting)) and [x[:2] for x in waiting] == [(0, 1), (1, 2)]
    piece = waiting.popleft()
    assert not list(_taken(starts, piece, late, 5, waiting)) and len(waiting) == 2
    piece = waiting.popleft()
    done.set_result([pickle.loads(pickle.dumps(analyze(starts[0])))])
    ((k, answer),) = _taken(starts, piece, done, 5, waiting)
    assert (k, answer.behaviour, answer.certificate) == (0, "converges", {})
    assert answer.reason == "out of time after 5 s while finding limit and certificate"
    ((k, answer),) = _taken(starts, piece, late, 5, waiting)
    assert (k, answer.behaviour, answer.reason) == (0, "undecided", "out of time after 5 s while deciding")


# ---------------------------------------------------------------------- files and the command
FILES = {
    "f.jsonl": '{"alpha": ["3"], "gamma": ["1/2"], "name": "x"}\n\n{"alpha": [0, 2], "gamma": [0.1, "1/3"]}\n',
    "f.csv": "name, alpha_1, alpha_2, gamma_0, gamma_1\nx,3,,1/2,\n,0,2,0.1,1/3\n",
    "g.csv": '\ufeffname,alpha,gamma\nx,3,1/2\n,"0, 2","0.1,1/3"\n',
    "f.json": '[{"name": "x", "alpha": [3], "gamma": ["1/2"]}, {"alpha": [0, 2], "gamma": [0.1, "1/3"]}]',
    "f.toml": '[[filter]]\nname = "x"\nalpha = [3]\ngamma = ["1/2"]\n[[filter]]\nalpha = [0, 2]\ngamma = [0.1, "1/3"]\n',
}
PLACES = {"f.jsonl": ":3", "f.csv": ":3", "g.csv": ":3", "f.json": "[1]", "f.toml": "[1]"}


def run(*args):
    return CliRunner().invoke(main, ["analyze", *map(str, args)])


@pytest.mark.parametrize("name", FILES)
def test_files_of_many_filters(tmp_path, name):
    """Every kind of file holds the same two filters, the first of them named; decimals are exact."""
    path = tmp_path / name
    path.write_text(FILES[name], encoding="utf-8")
    assert [label for label, _ in read_filters(path)] == ["x", f"{path}{PLACES[name]}"]
    assert decide_many(path) == [analyze(alpha=[3], gamma=["1/2"]), analyze(alpha=[0, 2], gamma=["1/10", "1/3"])]
    with pytest.raises(BadInput, match="holds 2 filters"):
        analyze(path)


@pytest.mark.parametrize(("name", "text", "says"), [
    ("f.jsonl", '{"alpha": [1]}\n{', "f.jsonl:2"), ("f.jsonl", '{"alpha": [1]}\n[1]', "no table of keys"), ("f.jsonl", "\n", "holds no filter"),
    ("f.csv", "", "holds no filter"), ("f.csv", "alpha,beta\n1,2\n", "unknown column 'beta'"), ("f.csv", "a,g\n1,2,3\n", "has 3 cells where there are 2"),
    ("f.csv", "a_1,a_3,g_1,g_2\n", "does not number the columns of a"), ("f.csv", "a_1,a_1\n", "names a column twice"),
    ("f.csv", "a;g\n1;2\n", "separate columns by commas"), ("f.csv", "a,a_1\n", "does not number"), ("f.csv", 'a,g\n"1,,2",3\n', "a of "),
    ("f.csv", 'a,g\n"1', "is not CSV"),
    ("f.csv", "a_1,a_2,g_1,g_2\n,1,1,1\n", "has an empty entry of a"),
    ("f.toml", "a = [1]\n[[filter]]\na = [1]", "outside its filters"), ("f.json", '[{"a": [1], "g": [0]}, {"beta": 1}]', "unknown key 'beta'"),
])
def test_bad_files_of_many_are_one_line(tmp_path, name, text, says):
    """What is wrong, and on which line, before any work."""
    (tmp_path / name).write_text(text)
    done = run(tmp_path / name)
    assert (done.exit_code, done.stdout) == (2, ""), done.output
    assert says in done.stderr and done.stderr.startswith("exactkf: ") and done.stderr.count("\n") == 1


def test_the_command_answers_each_filter_in_a_line(tmp_path):
    """Lines in order, JSON lines with limits, numbered certificates that replay; one that is refused is named and stops nothing."""
    (tmp_path / "f.csv").write_text("alpha,gamma\n3,1/2\n2,1\n-2,sqrt(3)\n")
    (tmp_path / "f.toml").write_text('a = ["1/2", 1]\ng = ["1/3", "1/4"]\n')
    files = [tmp_path / "f.csv", tmp_path / "f.toml"]
    done = run(*files, "--jobs", 2, "--json", tmp_path / "o.jsonl", "--certificate", tmp_path / "certs")
    assert done.exit_code == 2, done.output
    assert done.stdout.splitlines() == [
        f"{files[0]}:2: order 1: the orbit converges", f"{files[0]}:4: order 1: the orbit is periodic with period 6",
        f"{files[1]}: order 2: the orbit is not convergent, not periodic"]
    refused, totals = done.stderr.splitlines()
    assert refused.startswith(f"exactkf: {files[0]}:3: argument 'gamma[0]' is 1 or -1")
    assert totals == "4 filters: converges 1; periodic 1; not convergent, not periodic 1; refused 1"
    records = [json.loads(line) for line in (tmp_path / "o.jsonl").read_text().splitlines()]
    expected = analyze(alpha=[3], gamma=["1/2"]).to_json()
    del expected["certificate"], expected["structure"]
    assert records[0] == {"filter": f"{files[0]}:2", **expected, "key": records[0]["key"]} and set(records[1]) == {"filter", "error", "key"}
    assert sorted(x.name for x in (tmp_path / "certs").iterdir()) == ["1.json", "3.json", "4.json"]
    for x in (tmp_path / "certs").iterdir():
        replay(json.loads(x.read_text()))


def test_the_command_keeps_to_the_time_limit(tmp_path):
    """Exit status 1 if one filter runs out of time, a list in JSON, and options of one filter are refused."""
    (tmp_path / "f.json").write_text(json.dumps([LONG, {"alpha": [3], "gamma": ["1/2"]}]))
    done = run(tmp_path / "f.json", "--time-limit", 3, "--json", tmp_path / "o.json")
    assert done.exit_code == 1, done.output
    assert done.stdout.splitlines() == [f"{tmp_path / 'f.json'}[0]: order 400: undecided (out of time after 3 s while deciding)",
                                        f"{tmp_path / 'f.json'}[1]: order 1: the orbit converges"]
    assert [x["behaviour"] for x in json.loads((tmp_path / "o.json").read_text())] == ["undecided", "converges"]
    for option in (("--after", 3), ("--latex", tmp_path / "x"), ("--picture", "plane=p.svg")):
        done = run(tmp_path / "f.json", *option)
        assert (done.exit_code, done.stdout) == (2, "") and f"argument {option[0]} goes with one filter, and there are 2" in done.stderr


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no such signals")
def test_what_is_decided_before_ctrl_c_is_kept(tmp_path):
    """One answer is printed, the next takes long: after Ctrl-C the file has the first."""
    (tmp_path / "f.json").write_text(json.dumps([{"alpha": [3], "gamma": ["1/2"]}, LONG]))
    call = subprocess.Popen([sys.executable, "-m", "exactkf", "analyze", str(tmp_path / "f.json"), "--json", str(tmp_path / "o.jsonl")],
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)
    first = call.stdout.readline()
    os.killpg(call.pid, signal.SIGINT)
    out, err = call.communicate(timeout=20)
    said = f"exactkf: stopped; 1 of 2 answers are in {str(tmp_path / 'o.jsonl')!r}: the same command goes on from there\n"
    assert (call.returncode, first, out, err) == (130, f"{tmp_path / 'f.json'}[0]: order 1: the orbit converges\n", "", said)
    (kept,) = (tmp_path / "o.jsonl").read_text().splitlines()
    assert json.loads(kept)["behaviour"] == "converges"
