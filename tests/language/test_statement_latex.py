# SPDX-License-Identifier: MIT
"""LaTeX and plain text of whole statements."""

from latex2mathml.converter import convert

from exactkf.language import (
    TYPES,
    Statement,
    function,
    given,
    integer,
    let,
    matrix,
    positive_semidefinite,
    rec,
    sequence,
    standing,
    symbols,
    vector,
)
from exactkf.language.latex import (
    definition_latex,
    given_latex,
    latex,
    over_latex,
    says_latex,
    statement_latex,
    type_latex,
    where_latex,
)
from exactkf.language.text import statement_text

n, m, t, i, k, x, A, B, P, R, W, d, f, gamma, v = symbols("n m t i k x A B P R W d f gamma v")

SEQUENCES = ("sequence", "signal", "sequence_of", "signal_of")
STATEMENT = Statement(
    sizes=["n", "m"],
    over={"A": matrix(n, m), "B": matrix(n, m), "P": positive_semidefinite(2 * n), "gamma": sequence(0, n - 1),
          "k": integer(1, n), "v": vector(n)},
    where=[let(W, P * P), function(d, [i, t], gamma[i] * t), function(f, [x], x * x), rec(R, t, P, R[t] + f(P))],
    given=[given("bounded", gamma[0] < 1), standing("rank", W == P)],
    says=d(1, 2) == 0,
)


def test_variables_of_one_type_stand_together():
    assert over_latex(STATEMENT) == [
        r"n, m\in\mathbb{N}_{0}", r"A, B\in\mathbb{R}^{n\times m}", r"P\in\mathbb{R}^{2 n\times 2 n},\ P\succeq 0",
        r"\gamma_{0},\dots,\gamma_{n - 1}\in\mathbb{R}", r"k\in\{1,\dots,n\}", r"v\in\mathbb{R}^{n}"]


def test_definitions():
    assert where_latex(STATEMENT) == [
        "W := P P", r"d_{i,t} := \gamma_{i} t", r"f\left(x\right) := x x",
        r"R_{0} := P,\quad R_{t + 1} := R_{t} + f\left(P\right)"]


def test_hypotheses_keep_label_and_kind():
    assert given_latex(STATEMENT) == [["bounded", r"\gamma_{0} < 1", "needed"], ["rank", "W = P", "standing"]]


def test_whole_statement():
    whole = statement_latex(STATEMENT)
    for part in [*over_latex(STATEMENT), *where_latex(STATEMENT), says_latex(STATEMENT)]:
        assert part in whole
    assert convert(whole).startswith("<math")
    assert statement_latex(Statement(sizes=(), says=(t == t).tree, over={"t": ("scalar",)})).count(r"\\") == 1


def test_every_type_prints():
    for kind, count in TYPES.items():
        args = [3] * (count - 1) + [("pd", 3)] if kind.endswith("_of") else [3] * count
        statement = Statement(over={"x": (kind, *args)}, says=x[3] == x[3] if kind in SEQUENCES else x == x)
        assert convert(statement_latex(statement)).startswith("<math")
        assert statement_text(statement).startswith("for   x")
        assert type_latex("x", ["matrix", 3, 3]) == r"x\in\mathbb{R}^{3\times 3}"
        assert type_latex("x", [kind, *args]) == over_latex(statement)[0]


def test_data_as_json_has_it():
    data = STATEMENT.to_json()
    assert [definition_latex(d) for d in data["where"]][:2] == where_latex(STATEMENT)[:2]
    assert latex(data["says"]) == latex(STATEMENT.says)


def test_names_overridden_by_the_statement():
    statement = Statement(over={"x": ("scalar",)}, says=x == 1, tex={"x": r"\bar{\xi}"})
    assert says_latex(statement) == r"\bar{\xi} = 1"


def test_text():
    assert statement_text(STATEMENT).splitlines() == [
        "for   n = 0, 1, 2, ...", "for   m = 0, 1, 2, ...", "for   A n x m", "for   B n x m",
        "for   P (2*n) x (2*n) psd", "for   gamma[0..n - 1] real", "for   k in 1..n", "for   v n x 1",
        "with  W := P*P", "with  d[i, t] := gamma[i]*t", "with  f(x) := x*x", "with  R[0] := P",
        "with  R[t + 1] := R[t] + f(P)", "given gamma[0] < 1    (bounded)", "given W = P    (rank)",
        "then  d[1, 2] = 0"]
