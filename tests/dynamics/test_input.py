# SPDX-License-Identifier: MIT
"""The ways in which a filter is given, and what is refused."""

import json
from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest
from flint import fmpq, fmpz
from hypothesis import assume, given
from hypothesis import strategies as st

from exactkf._errors import BadInput
from exactkf.dynamics.analyze import analyze, filter_from, read_data
from exactkf.dynamics.filter import Filter
from exactkf.kernel.numbers import fraction
from exactkf.kernel.replay import replay

small = st.fractions(min_value=-4, max_value=4, max_denominator=6)


@st.composite
def filters(draw):
    """A rational filter of order one to four, from its coordinates."""
    n = draw(st.integers(1, 4))
    alpha, gamma = ([draw(small) for _ in range(n)] for _ in range(2))
    assume(all(x * x != 1 for x in gamma))
    return Filter.from_parameters(alpha, gamma), alpha, gamma


@given(filters())
def test_every_way_in_gives_the_same_filter(made):
    """Coordinates, polynomials, a realization in another basis and covariances agree."""
    f, alpha, gamma = made
    n = f.order
    assert f.parameters() == (tuple(fmpq(x.numerator, x.denominator) for x in alpha), tuple(fmpq(x.numerator, x.denominator) for x in gamma))
    assert Filter.from_ag(f.a, f.g) == f
    assert Filter.from_polynomials([1, *f.b], [1, *f.a]) == f
    F = [[-f.a[i] if j == 0 else fmpq(int(j == i + 1)) for j in range(n)] for i in range(n)]
    assert Filter.from_realization(F, f.g, [1] + [0] * (n - 1)) == f
    if n > 1:  # the basis changed by adding the first row to the second: T F T^-1, T g, h' T^-1
        F[1] = [x + y for x, y in zip(F[1], F[0], strict=True)]
        F = [[row[0] - row[1], *row[1:]] for row in F]
        g = [f.g[0], f.g[0] + f.g[1], *f.g[2:]]
        assert Filter.from_realization(F, [[x] for x in g], [[1] + [0] * (n - 1)]) == f
    try:
        assert Filter.from_covariances([1, *f.covariances(2 * n + 2)], order=n) == f
    except BadInput as error:
        assert "singular Hankel" in str(error)


def test_a_state_space_object_is_normalized():
    """The transfer function is divided by 2D; numpy's floats need a rule."""
    system = SimpleNamespace(A=np.array([[0.5, 0.0], [0.25, -0.25]]), B=np.array([[1.0], [0.5]]), C=np.array([[0.5, 0.25]]), D=np.array([[1.0]]))
    f = Filter.from_state_space(system, floats="exact")
    assert f.a == (fmpq(-1, 4), fmpq(-1, 8))
    assert f.covariances(1) == (fmpq(5, 16),)  # CB / 2D
    with pytest.raises(BadInput, match=r"is a float"):
        Filter.from_state_space(system)
    assert filter_from({"system": system, "floats": "decimal"}) == f


MATRICES = ([[0.5, 0.0], [0.25, -0.25]], [[1.0], [0.5]], [[0.5, 0.25]], [[0.5]])


def decided_alike(system):
    """A state space object alone is decided as its matrices are, with the same rule for floats."""
    A, B, C, _ = MATRICES
    expected = analyze(F=A, g=B, h=C, floats="exact")
    for answer in (analyze(system, floats="exact"), analyze(system=system, floats="exact")):
        assert answer == expected and answer.certificate == expected.certificate
    assert analyze(system, floats=4).behaviour == expected.behaviour == "converges"
    with pytest.raises(BadInput, match=r"argument 'D' is a float"):
        analyze(system)
    with pytest.raises(BadInput, match=r"argument 'system' is given twice"):
        analyze(system, system=system)


def test_a_state_space_object_is_analyzed():
    """Anything with the four matrices is a filter; anything else is refused in one line."""
    decided_alike(SimpleNamespace(**dict(zip("ABCD", map(np.array, MATRICES), strict=True))))
    exact = SimpleNamespace(A=[["1/2"]], B=[[1]], C=[["1/3"]], D=[["1/2"]])
    assert analyze(exact) == analyze(F=[["1/2"]], g=[1], h=["1/3"])
    for other in (object(), 3, SimpleNamespace(A=1, B=2, C=3)):
        with pytest.raises(BadInput, match="argument 'data' is no filter") as caught:
            analyze(other)
        assert "\n" not in str(caught.value)


def test_a_state_space_of_the_control_package_is_analyzed():
    """The same for `control.StateSpace`, unless its time is continuous."""
    control = pytest.importorskip("control")
    decided_alike(control.StateSpace(*MATRICES, True))
    decided_alike(control.StateSpace(*MATRICES, None))
    with pytest.raises(BadInput, match="argument 'system' is of continuous time"):
        analyze(control.StateSpace(*MATRICES), floats="exact")


def test_irrational_entries_share_a_field():
    """All numbers of a filter lie in one field."""
    f = Filter.from_parameters(["sqrt(2)", "1/2"], ["0", "sqrt(3)"])
    assert f.field.degree == 4 and all(x.field is f.field for x in (*f.a, *f.g))
    assert f.parameters()[0][0] ** 2 == 2


@pytest.mark.parametrize("data, says", [
    ({"alpha": [1], "gamma": [1]}, "argument 'gamma[0]' is 1 or -1"), ({"alpha": [1, 2], "gamma": [0, -1]}, "argument 'gamma[1]' is 1 or -1"),
    ({"alpha": [1], "gamma": [0, 0]}, "argument 'gamma' has length 2 where alpha has 1"), ({"a": [1], "g": ["-1"]}, "argument 'g[0]'"),
    ({"a": [1], "g": [0, 0]}, "argument 'g' has length 2"), ({"b": [2, 1], "a": [1, 1]}, "argument 'b' is not monic"),
    ({"b": [1, 1], "a": [2, 1]}, "argument 'a' is not monic"), ({"b": [1, 1, 1], "a": [1, 1]}, "argument 'b' has degree 2 where a has degree 1"),
    ({"covariances": [1, "1/2"]}, "argument 'covariances' has 1 covariance after the first, too few"), ({"covariances": [2, 1, 1]}, "does not begin with 1"),
    ({"covariances": [1, "1/2", "1/4", "1/3"]}, "not the covariance sequence"), ({"covariances": [1, 0, 0]}, "singular Hankel"),
    ({"covariances": [1, "1/2", "1/4"], "order": 2}, "too few for order 2"), ({"covariances": [1, "1/2", "1/4"], "order": "x"}, "argument 'order' is no order"),
    ({"F": [[1, 2]], "g": [1], "h": [1]}, "argument 'F' is not square"), ({"F": [[1]], "g": [1, 2], "h": [1]}, "argument 'g' has length 2"),
    ({"F": [], "g": [1], "h": [1]}, "argument 'F' is empty"), ({"F": [[1, 2], [3, 4]], "g": [[1, 2], [3, 4]], "h": [1, 0]}, "argument 'g' is a matrix"),
    ({"a": [], "g": []}, "argument 'a' is empty"), ({"a": "ab", "g": [1]}, "argument 'a' is no vector"), ({"a": 1, "g": [1]}, "argument 'a' is no vector"),
    ({"a": [0.5], "g": [0]}, "argument 'a[0]' is a float"), ({"a": [float("nan")], "g": [0], "floats": "exact"}, "not finite"),
    ({"a": ["1e99999"], "g": [0]}, "exponent beyond"), ({"a": [None], "g": [0]}, "argument 'a[0]'"),
    ({"alpha": [1]}, "argument 'gamma' is missing: 'alpha' alone is no filter"), ({"gamma": [1]}, "'alpha' is missing"),
    ({"a": [1]}, "argument 'g', or 'b' is missing"), ({"g": [1]}, "argument 'a', or 'F' and 'h' is missing"),
    ({"F": [[1]]}, "'g' and 'h' is missing"), ({"gamm": [1], "alpha": [1]}, "argument 'gamm' is unknown; did you mean 'gamma'?"),
    ({"gamm": [1]}, "did you mean 'gamma'?"), ({"covariance": [1, 0, 0]}, "did you mean 'covariances'?"),
    ({"f": [[1]], "g": [1], "h": [1]}, "did you mean 'F'?"),
    ({"x": [1]}, "no filter is described by 'x'; give one of: alpha, gamma; a, g"),
    ({}, "no filter"), ({"alpha": [1], "gamma": [0], "b": [1]}, "no filter"),
    ({"alpha": [1], "gamma": [0], "order": 1}, "argument 'order' goes with covariances"), ({"alpha": ["root(x^2, -1, 1, 2)"], "gamma": [0]}, "4 arguments"),
    ({"system": object()}, "has no matrices"), ({"alpha": [1], "gamma": [0], "floats": "near"}, "argument 'floats' is no meaning of floats"),
    ({"alpha": [1], "gamma": [0], "floats": True}, "argument 'floats'"), ({"alpha": [True], "gamma": [0]}, "truth value"),
])
def test_bad_input_is_one_line(data, says):
    """The message names the argument and what is wrong with it."""
    with pytest.raises(BadInput) as caught:
        filter_from(data)
    assert says in str(caught.value) and "\n" not in str(caught.value)


def test_files_keep_decimals_exact(tmp_path):
    """A decimal in TOML or JSON is the number that is written there."""
    (tmp_path / "f.toml").write_text('alpha = [0.1, "sqrt(2)"]\ngamma = [1e-1, 0]\n')
    (tmp_path / "f.json").write_text(json.dumps({"alpha": [0.1, "sqrt(2)"], "gamma": [0.1, 0]}))
    read = [read_data(tmp_path / name) for name in ("f.toml", "f.json")]
    assert [filter_from(r).parameters()[1][0] for r in read] == [fmpq(1, 10)] * 2


@pytest.mark.parametrize("name, text, says", [
    ("f.txt", "", "neither .toml nor .json"), ("f.toml", "alpha = [", "is not TOML"), ("f.json", "[1]", "no table"), ("f.json", "{", "is not JSON"),
    ("f.toml", "beta = 1", "unknown key 'beta'"), ("f.toml", "alpha = [1]\ngamm = [2]", "unknown key 'gamm': '"),
    ("f.json", '{"gamm": [1]}', "did you mean 'gamma'?"), ("f.csv", "alpha,gamm\n1,2\n", "did you mean 'gamma'?"),
    ("f.csv", "alpha_1,gama_0\n1,2\n", "did you mean 'gamma'?"), ("f.toml", "alpha = [1]", "argument 'gamma' is missing"),
    ("f.json", '{"a": [NaN], "g": [0]}', "argument 'a[0]'"), ("f.json", f'{{"a": [{"7" * 4301}], "g": [0]}}', "put it in quotes"),
    ("f.toml", f'a = [{"7" * 4301}]', "an integer of more than 4300 digits"), ("f.json", "[" * 100000, "is not JSON"),
    ("f.json", '{"alpha": [1], "gamma": [2], "alpha": [3]}', "the key 'alpha' comes twice"), ("f.toml", "a = [1]\na = [2]\ng = [0]", "is not TOML"),
])
def test_bad_files_are_one_line(tmp_path, name, text, says):
    """A file that is none of ours is named with what is wrong."""
    (tmp_path / name).write_text(text)
    with pytest.raises(BadInput, match="argument") as caught:
        filter_from(read_data(tmp_path / name))
    assert says in str(caught.value) and "\n" not in str(caught.value)
    with pytest.raises(BadInput, match="cannot be read"):
        read_data(tmp_path / "missing.toml")


def test_analyze_refuses_mixtures():
    """A filter is given once, and pi0 goes with order one."""
    f = Filter.from_ag(["1/2"], ["1/4"])
    with pytest.raises(BadInput, match="'alpha' comes with a Filter"):
        analyze(f, alpha=[1])
    with pytest.raises(BadInput, match="'a' is given twice"):
        analyze({"a": [1], "g": [0]}, a=[1])
    with pytest.raises(BadInput, match="'pi0' comes with a filter of order 2"):
        analyze(a=["1/2", 0], g=[0, "1/3"], pi0="1/2")


def test_numbers_of_thousands_of_digits_are_decided_and_replayed():
    """No step stops at the digits that Python reads at once."""
    answer = analyze(alpha=["1e1100"], gamma=["1/2"])
    replay(answer.certificate)
    assert answer.behaviour == "converges" and "limit of alpha" in str(answer) and "Not found" not in str(answer)


def test_a_limit_of_thousands_of_digits_is_enclosed():
    """That of exact floats of order four has its degree times their digits."""
    F = [[0.3 / (1 + i + 2 * j) for j in range(4)] for i in range(4)]
    answer = analyze(F=F, g=[0.1 / (k + 3) for k in range(4)], h=[0.7 / (k + 1) for k in range(4)], floats="exact")
    assert answer.behaviour == "converges" and [set(x) for x in answer.limit["alpha"]] == [{"interval"}] * 4


def test_integers_of_certificates_have_any_length():
    """They are read in pieces, to the same value."""
    for text in ("7" * 700, "-" + "1234567890" * 500, "+" + "9" * 1201, "-" + "0" * 2000 + "3", "0" * 5000):
        expected = Fraction(int(fmpz(text.lstrip("+"))))
        assert fraction(text) == expected and fraction(f"{text}/{'3' * 4400}") == expected / int(fmpz("3" * 4400))
