# SPDX-License-Identifier: MIT
"""``exactkf analyze``: words, files, pictures and refusals."""

import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from exactkf.cli import main
from exactkf.dynamics.analyze import analyze
from exactkf.dynamics.files import split_list
from exactkf.dynamics.filter import Filter
from exactkf.kernel.replay import replay


def run(*args):
    return CliRunner().invoke(main, ["analyze", *map(str, args)])


def test_an_answer_is_printed_and_written(tmp_path):
    """Words on the screen; JSON, certificate, LaTeX and pictures in files; the certificate replays."""
    files = {name: tmp_path / name for name in ("a.json", "c.json", "a.tex", "p.png", "g.svg", "s.svg")}
    done = run("--alpha", 3, "--gamma", "1/2", "--digits", 12, "--json", files["a.json"], "--certificate", files["c.json"], "--latex", files["a.tex"],
               "--picture", f"plane={files['p.png']}", "--picture", f"gamma={files['g.svg']}", "--picture", f"spectrum={files['s.svg']}")
    assert done.exit_code == 0, done.output
    assert done.stdout.startswith("order 1: the orbit converges\n") and "0.344131154255" in done.stdout
    answer = json.loads(files["a.json"].read_text())
    assert answer["behaviour"] == "converges" and answer["limit"]["gamma"] == "0"
    replay(json.loads(files["c.json"].read_text()))
    assert files["a.tex"].read_text().startswith("\\noindent\\textbf{Order 1: the orbit converges.}")
    assert files["p.png"].read_bytes()[:4] == b"\x89PNG" and "<svg" in files["g.svg"].read_text() and "<svg" in files["s.svg"].read_text()


@pytest.mark.parametrize("args, head", [
    (("--alpha", "0", "--gamma", "sqrt(2)"), "order 1: the orbit converges"),
    (("--alpha", "-2", "--gamma", "sqrt(3)"), "order 1: the orbit is periodic with period 6"),
    (("--alpha", "1", "--gamma", "6/5"), "order 1: the orbit never repeats"), (("--alpha", "2", "--gamma", "0"), "order 1: the orbit"),
    (("--b", "1,3/4", "--a", "1,1/4"), "order 1: the orbit converges"), (("--covariances", "1,1/2,1/4"), "order 1: the orbit"),
])
def test_headlines(args, head):
    """The first line says what the gain does."""
    done = run(*args)
    assert done.exit_code == 0 and done.stdout.startswith(head), done.output


def test_a_file_says_the_same_as_options(tmp_path):
    """A TOML file with the same numbers gives the same answer."""
    (tmp_path / "f.toml").write_text('alpha = [3]\ngamma = ["1/2"]\n')
    whole, line = tmp_path / "a.json", tmp_path / "a.jsonl"
    assert run(tmp_path / "f.toml", "--json", whole).stdout == run("--alpha", 3, "--gamma", 0.5, "--json", line).stdout
    assert json.loads(whole.read_text()) == json.loads(line.read_text()) and line.read_text().count("\n") == 1


@pytest.mark.parametrize("args, says", [
    ((), "argument FILE is missing"), (("--alpha", "2"), "'gamma' is missing"), (("--gamm", "2"), "'--gamma'"),
    (("--alpha", "2", "--gamma", "1"), "'gamma[0]' is 1 or -1"),
    (("--alpha", "1,,2", "--gamma", "1"), "'--alpha' has an empty entry"),
    (("none.toml",), "cannot be read"), (("none.toml", "--alpha", "1"), "comes beside FILE"),
    (("--alpha", "2", "--gamma", "1/2", "--picture", "p.png"), "is not KIND=FILE"),
    (("--alpha", "2", "--gamma", "1/2", "--picture", "plane=p.gif"), "neither .png nor .svg"),
    (("--alpha", "2", "--gamma", "1/2", "--picture", "alpha=p.png"), "of order 1"), (("--alpha", "2", "--gamma", "1/2", "--json", "/"), "is a folder"),
    (("--alpha", "2", "--gamma", "1/2", "--digits", "0"), "--digits"), (("--a", "1,2", "--g", "0,1/2", "--pi0", "1"), "'pi0' comes with a filter of order 2"),
    (("--alpha", "root(x^2-2,-2,2)", "--gamma", "0"), "holds 2 real roots"),
    *((("--alpha", "2", "--gamma", "1/2", "--after", T), f"'{T}' is not a number of steps") for T in ("-1", "1.5", "2^9999", "x")),
    (("--covariances", "1,1/2"), "too few for order 1"),
])
def test_wrong_calls_are_one_line(args, says):
    """Exit code 2 and one line that names the argument."""
    done = run(*args)
    assert done.exit_code == 2 and done.stdout == "", done.output
    assert says in done.stderr and done.stderr.startswith("exactkf: ") and done.stderr.count("\n") == 1


def test_lists_split_at_outer_commas():
    """A comma inside parentheses belongs to its number."""
    assert split_list("g", " 1 ,root(x^2-2, 1, 2),(1,2)") == ["1", "root(x^2-2, 1, 2)", "(1,2)"]


def test_missing_matplotlib_is_said_before_any_work(monkeypatch, tmp_path):
    """Without matplotlib a picture is refused in one line, and nothing is printed."""
    monkeypatch.setattr("exactkf.dynamics.pictures.find_spec", lambda name: None)
    done = run("--alpha", 3, "--gamma", "1/2", "--picture", f"plane={tmp_path / 'p.png'}")
    assert (done.exit_code, done.stdout) == (2, "")
    assert done.stderr.startswith("exactkf: pictures need matplotlib") and done.stderr.count("\n") == 1


#: the certificate of nothing, and an order that takes long to decide
LONG = ("--a", ",".join(f"{k % 7 - 3}/{k + 4}" for k in range(400)), "--g", ",".join(f"{k % 5 - 2}/{k + 5}" for k in range(400)))


def test_past_the_time_limit_the_orbit_is_undecided(tmp_path):
    """Exit code 1, the reason on the screen and in the JSON, and no certificate."""
    done = run(*LONG, "--time-limit", 10, "--json", tmp_path / "a.json", "--certificate", tmp_path / "c.json")
    assert done.exit_code == 1, done.output
    assert done.stdout.startswith("order 400: undecided\n") and "Undecided: out of time after 10 s while deciding." in done.stdout
    answer = json.loads((tmp_path / "a.json").read_text())
    assert (answer["behaviour"], answer["order"], answer["certificate"]) == ("undecided", 400, {}) and "out of time after 10 s" in answer["reason"]
    assert not (tmp_path / "c.json").exists() and f"{tmp_path / 'c.json'}: not written, out of time" in done.stderr
    assert set(answer) == set(analyze(alpha=[3], gamma=["1/2"]).to_json())


def test_what_is_found_before_the_time_limit_is_kept(tmp_path):
    """The decision is printed, the exit code is 1, and what is missing is said."""
    picture = tmp_path / "g.png"
    done = run("--a", "1/2,1/3,1/4", "--g", "1/3,-1/2,1/4", "--picture", f"gamma={picture}", "--steps", 10000, "--time-limit", 15,
               "--json", tmp_path / "a.json", "--certificate", tmp_path / "c.json")
    assert done.exit_code == 1, done.output
    assert "  Not finished: out of time after 15 s while drawing the gamma picture." in done.stdout
    assert f"{picture}: not written, out of time" in done.stderr and done.stderr.count("\n") == 1
    answer = json.loads((tmp_path / "a.json").read_text())
    assert answer == analyze(a=["1/2", "1/3", "1/4"], g=["1/3", "-1/2", "1/4"]).to_json()
    replay(json.loads((tmp_path / "c.json").read_text()))


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no such signals")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_stopped_call_is_one_line(number):
    """Ctrl-C, sent to the group as a terminal does, or SIGTERM: exit code 130, one line, and no process is left."""
    call = subprocess.Popen([sys.executable, "-m", "exactkf", "analyze", *LONG], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            start_new_session=True)
    children = Path(f"/proc/{call.pid}/task/{call.pid}/children")
    wait_until(lambda: len(children.read_text().split()) > 1 if children.exists() else False, 8)  # a tracker of resources, and the one that works
    time.sleep(1)
    os.killpg(call.pid, number) if number == signal.SIGINT else call.send_signal(number)
    out, err = call.communicate(timeout=20)
    assert (call.returncode, out, err) == (130, "", "exactkf: stopped\n")
    assert wait_until(lambda: not lives(call.pid), 10)


def wait_until(condition, seconds):
    """Whether the condition comes to hold within so many seconds."""
    until = time.monotonic() + seconds
    while not (held := condition()) and time.monotonic() < until:
        time.sleep(0.1)
    return held


def lives(group):
    """Whether a group has a process."""
    try:
        os.killpg(group, 0)
    except ProcessLookupError:
        return False
    return True


@pytest.mark.parametrize("limit", ["0", "-1", "nan", "inf", "x"])
def test_a_time_limit_is_a_number_of_seconds(limit):
    """Nothing else is taken."""
    done = run("--alpha", 3, "--gamma", "1/2", "--time-limit", limit)
    assert done.exit_code == 2 and "is not a number of seconds" in done.stderr and done.stderr.count("\n") == 1


def test_a_limit_of_large_degree_is_enclosed():
    """Order eight: the limit in digits, at once."""
    done = run("--a", "0,1/5,0,0,1/7,0,0,1/9", "--g", "1/10,0,1/11,0,0,1/20,0,1/30")
    enclosed = [line.split("  ")[1][:5] for line in done.stdout.splitlines() if "(enclosed)" in line]
    assert done.exit_code == 0 and enclosed == 8 * ["limit"] + ["rate"], done.output
    many = run("--a", "0,1/5,0,0,1/7,0,0,1/9", "--g", "1/10,0,1/11,0,0,1/20,0,1/30", "--digits", 120).stdout.splitlines()
    first = next(line for line in many if "limit of alpha_1" in line).split()[-2]
    assert len(first) > 120 and next(line for line in done.stdout.splitlines() if "limit of alpha_1" in line).split()[-2][:18] == first[:18]


@pytest.mark.parametrize("args, why", [
    (("--a", "0,-1", "--g", "0,1", "--picture", "spectrum={}"), "spectrum picture: D is zero"),
    (("--alpha", "10^1000", "--gamma", "1/2", "--picture", "plane={}"), "plane picture: a coordinate of the start is beyond 1e+100"),
])
def test_what_cannot_be_drawn_is_said(tmp_path, args, why):
    """The decision is printed, the reason too, and the exit code is 1."""
    done = run(*(x.format(tmp_path / "p.png") for x in args))
    assert done.exit_code == 1 and done.stdout.startswith("order ") and f"Not found: {why}" in done.stdout, done.output
    assert not (tmp_path / "p.png").exists() and "not written" in done.stderr and done.stderr.count("\n") == 1


def test_numbers_of_steps_may_be_powers():
    """10^6, 1e6 and 1000000 are the same; algebraic data go ahead too."""
    ends = [run("--alpha", 3, "--gamma", "sqrt(2)", "--after", T).stdout.splitlines()[-2:] for T in ("10^6", "1e6", 1000000)]
    assert ends[0] == ends[1] == ends[2] and ends[0][0].startswith("  a_1(1000000) = 0.")


def test_the_hyperbola_is_drawn_up_to_its_vertices():
    """Both branches meet the axis gamma = 0, where the curve is upright."""
    pytest.importorskip("matplotlib")
    from matplotlib.figure import Figure

    from exactkf.dynamics import pictures

    axes = Figure().subplots()
    pictures._hyperbola(axes, Filter.from_parameters([3], ["1/2"]), 3.5)
    upper = axes.lines[0].get_xydata()
    drawn = upper[np.isfinite(upper[:, 1])]
    middle = (1 + 3.0**2 - 0.5**2) / 3.0 / 2
    for vertex in (middle - np.sqrt(middle**2 - 1), middle + np.sqrt(middle**2 - 1)):
        assert np.abs(drawn[np.abs(drawn[:, 0] - vertex) < 1e-6, 1]).min() < 1e-3


@pytest.mark.parametrize(("alpha", "gamma", "label"), [
    ("1/2", "sqrt(5)/2", r"\\kappa = \\infty"), ("2/3 + sqrt(1/3)", "1/3 - sqrt(1/3)", r"\\kappa = 1\$"), ("0", "3/2", r"\\kappa = 0"),
    ("3", "1/2", r"\\kappa = 8/13\$"),
    ("10^6", "999999.5", r"\\kappa = 1.9999985")])
def test_the_label_of_the_hyperbola_is_that_of_the_exact_kappa(alpha, gamma, label):
    """Coordinates that are rounded first would turn infinity into 10^15 and one into what is next to it."""
    pytest.importorskip("matplotlib")
    from exactkf.dynamics.pictures import draw_plane

    figure = draw_plane(Filter.from_parameters([alpha], [gamma]), 20)
    assert any(re.search(label, text.get_text()) for text in figure.legends[0].get_texts())


@pytest.mark.parametrize("args", [("1829/574", "-8/287"), ("3", "1/2"), ("0", "3/2"), ("10^6", "999999.5")])
def test_the_legend_of_the_plane_is_whole(args):
    """It lies below the axes and within the figure, with the escape and without."""
    pytest.importorskip("matplotlib")
    from exactkf.dynamics.pictures import draw_plane

    figure = draw_plane(Filter.from_parameters([args[0]], [args[1]]), 20)
    figure.canvas.draw()
    box, axes = figure.legends[0].get_window_extent(), figure.axes[0].get_window_extent()
    assert 0 <= box.x0 and box.x1 <= figure.bbox.x1 and 0 <= box.y0 and box.y1 <= axes.y0
    for text in figure.axes[0].texts:
        place = text.get_window_extent()
        assert axes.x0 <= place.x0 and place.x1 <= axes.x1, text.get_text()


@pytest.mark.parametrize(("args", "exact"), [(("--alpha", "0,2", "--gamma", "1/2,1/3", "--after", "3"), True),
                                             (("--alpha", "3", "--gamma", "sqrt(2)", "--after", "10^9"), False)])
def test_the_state_far_ahead_is_in_every_form(tmp_path, args, exact):
    """Exact numbers, or decimal ones with a radius that holds: on the screen, in JSON and in LaTeX."""
    done = run(*args, "--digits", 15, "--json", tmp_path / "a.json", "--latex", tmp_path / "a.tex")
    assert done.exit_code == 0, done.output
    ahead, latex = json.loads((tmp_path / "a.json").read_text())["ahead"], (tmp_path / "a.tex").read_text()
    assert (ahead["escape"], ahead["never_escapes"]) == (None, True)
    for name in "ag":
        for i, x in enumerate(ahead[name], 1):
            shown = done.stdout.split(f"  {name}_{i}({ahead['steps']}) = ")[1].splitlines()[0]
            formula = latex.split(f"${name}_{{{i}}}({ahead['steps']}) = ")[1].split("$")[0]
            if exact:
                assert x == shown and formula.replace("\\frac{", "").replace("}{", "/").replace("}", "") == x
            else:
                assert float(x["radius"]) <= 1e-15 and shown.split("e")[0] == x["digits"][:len(shown.split("e")[0]) - 1] + shown.split("e")[0][-1]
                assert formula.startswith(shown.split("e")[0])


def test_an_escape_on_the_way_is_in_every_form(tmp_path):
    """No state behind it."""
    done = run("--a=-2", "--g", "1/2", "--after", 10, "--json", tmp_path / "a.json", "--latex", tmp_path / "a.tex")
    assert "no state after 10 steps: the orbit escapes at step 1" in done.stdout
    assert json.loads((tmp_path / "a.json").read_text())["ahead"] == {"steps": 10, "escape": 1, "never_escapes": False, "a": None, "g": None}
    assert "State after $10$ steps: none, the orbit escapes at step $1$" in (tmp_path / "a.tex").read_text()
