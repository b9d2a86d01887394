# SPDX-License-Identifier: MIT
"""``exactkf analyze``: words, files, pictures and refusals."""

import json

import numpy as np
import pytest
from click.testing import CliRunner

from exactkf.cli import main
from exactkf.dynamics.command import split_list
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
    assert files["a.tex"].read_text().startswith("\\begin{itemize}")
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
    assert run(tmp_path / "f.toml").stdout == run("--alpha", 3, "--gamma", 0.5).stdout


@pytest.mark.parametrize("args, says", [
    ((), "argument FILE is missing"), (("--alpha", "2"), "no filter"), (("--alpha", "2", "--gamma", "1"), "'gamma[0]' is 1 or -1"),
    (("--alpha", "1,,2", "--gamma", "1"), "'--alpha' has an empty entry"),
    (("none.toml",), "cannot be read"), (("none.toml", "--alpha", "1"), "comes beside FILE"),
    (("--alpha", "2", "--gamma", "1/2", "--picture", "p.png"), "is not KIND=FILE"),
    (("--alpha", "2", "--gamma", "1/2", "--picture", "plane=p.gif"), "neither .png nor .svg"),
    (("--alpha", "2", "--gamma", "1/2", "--picture", "alpha=p.png"), "of order 1"), (("--alpha", "2", "--gamma", "1/2", "--json", "/"), "is a folder"),
    (("--alpha", "2", "--gamma", "1/2", "--digits", "0"), "--digits"), (("--a", "1,2", "--g", "0,1/2", "--pi0", "1"), "'pi0' comes with a filter of order 2"),
    (("--alpha", "root(x^2-2,-2,2)", "--gamma", "0"), "holds 2 real roots"),
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


def test_the_hyperbola_is_drawn_up_to_its_vertices():
    """Both branches meet the axis gamma = 0, where the curve is upright."""
    pytest.importorskip("matplotlib")
    from matplotlib.figure import Figure

    from exactkf.dynamics import pictures

    axes = Figure().subplots()
    pictures._hyperbola(axes, 3.0, 0.5, 3.5)
    upper = axes.lines[0].get_xydata()
    drawn = upper[np.isfinite(upper[:, 1])]
    middle = (1 + 3.0**2 - 0.5**2) / 3.0 / 2
    for vertex in (middle - np.sqrt(middle**2 - 1), middle + np.sqrt(middle**2 - 1)):
        assert drawn[np.abs(drawn[:, 0] - vertex) < 1e-6, 1].min() < 1e-3
