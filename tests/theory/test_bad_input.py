# SPDX-License-Identifier: MIT
"""Every public function refuses what it cannot use: `BadInput`, in one line that names the argument and says what to pass."""

from __future__ import annotations

import inspect
import re
from fractions import Fraction
from types import SimpleNamespace

import pytest
from flint import arb, fmpq, fmpz_poly
from mpmath import mpf

import exactkf.dynamics
import exactkf.exact
import exactkf.theory
from exactkf._errors import BadInput, Unsupported
from exactkf.dynamics import Filter, decide, digits_ahead, limit_digits, rate_digits, state_ahead
from exactkf.dynamics.examples import verdict_of_doubles
from exactkf.dynamics.pictures import draw_gamma, draw_plane
from exactkf.theory import (
    act,
    covariance_step,
    duven_matrix,
    equilibria,
    equilibrium_from_basis,
    estimate,
    exact_orbit,
    filter_map,
    first_escape,
    from_factors,
    hamiltonian_matrix,
    laurent_covariances,
    likelihood_matrix,
    moebius,
    observer_form,
    orbit,
    posterior_covariance,
    power_modulo,
    projective_invariants,
    pseudo_polynomial_from_q,
    riccati_gain,
    riccati_step,
    schur_parameters,
    stabilizing_equilibrium,
    state_after,
    step_ag,
    step_polynomials,
    symplectic_matrix,
)

from .strategies import mat

NAN, HALF, THIRD = float("nan"), Fraction(1, 2), Fraction(1, 3)
EYE = [[1, 0], [0, 1]]

# never a value of any argument, whatever the function
WRONG = [NAN, 0.5, 1j, b"x", {}, {1: 2}, {1, 2}, object(), (1.5, 2), (NAN, 1), (None, 1), [[None]], [[object()]], [[0.5, 0], [0, 1]], [[1, 2], [3]]]
# right for some arguments and wrong for others: what counts is that nothing but `BadInput` or an answer comes out
DOUBTFUL = [None, True, -1, 3, "x", "1/0", "3", "1e999999999", [], [[]], (1,), (1, 1), [[0]], EYE, [[1, 2], [3, 4]], [[1, 2], [2, 1]], [[1, 2, 3], [4, 5, 6]],
            [[1, 2], [5, 1]], [mpf(1)], [Fraction(1, 2), arb(1)], range(2), lambda: 1]

# arguments with which a call succeeds: by name, and where a function differs by function
GOOD = {
    "A": EYE, "B": [[1], [2]], "C": EYE, "D": [3, 1, 1], "F": [[1, 0], [0, 1]], "H": EYE, "M": [[1, 0]], "P": [[2, 1], [1, 2]], "Phi": [[1, 1], [0, 1]],
    "Q": EYE, "R": EYE, "S": [[2, 1], [1, 2]], "T": 5, "V": [[1]], "Z": [[2, 1], [1, 2]], "a": (HALF, THIRD), "alpha": (1, 2), "alpha0": 3,
    "a_t": (1, 2), "b": (1, 2), "c": (HALF, THIRD), "coefficients": [1, 2], "d": (3, 1, 1), "exponent": 3, "g": (THIRD, fmpq(1, 5)), "g_t": (THIRD, 1),
    "gamma": (HALF, THIRD), "gamma0": HALF, "modulus": fmpz_poly([-1, -1, 1]), "n": 2, "n_rows": 2, "p": [1, 2, 1], "polynomial": (1, 2, 3),
    "q": (1, 2), "q_star": (HALF, 2), "rows": EYE, "starts": [(3, HALF)], "state": ((1,), (2,)), "step": step_ag, "steps": 3, "value": "1/2", "values": ["1/2"],
    "x": 1, "y": [1, 2], "names": "x", "minpoly": [-2, 0, 1], "interval": (1, 2), "width": 1, "blocks": [[[[1]]]], "question": lambda: 1,
}
OWN = {
    "act": {"S": EYE, "P": [[3]]}, "difference_of_squares": {"Q": (1, 1), "Q_star": (HALF,)}, "step_polynomials": {"Q": (1, 1), "Q_star": (HALF,)},
    "step_numerators": {"Q": (1, 1), "Q_star": (HALF,)}, "estimate": {"H": [[1], [1]]}, "is_symplectic": {"M": EYE}, "to_factors": {"M": EYE},
    "membership": {"M": EYE}, "moebius": {"M": EYE, "T": [[3]]}, "riccati_gain": {"g": [[1], [0]], "h": [[0], [1]]}, "is_estimable": {"c": [1, 0]},
    "riccati_step": {"g": [[1], [0]], "h": [[0], [1]]}, "symplectic_matrix": {"g": [[1], [0]], "h": [[0], [1]]}, "palindromic_to_x": {"p": [1, 2, 1]},
    "equilibrium_from_basis": {"Phi": [[2]], "H": [[0]], "M": [[1]], "V": [[1]], "basis": [[3, 1]]}, "PseudoPolynomial": {"d": [3, 1]}, "sqrt_field": {"d": 2},
    "stabilizing_equilibrium": {"Phi": [[2]], "H": [[0]], "M": [[1]], "V": [[1]]}, "refine_root": {"root": exactkf.exact.isolate_real_roots([-2, 0, 1])[0]},
    **dict.fromkeys(("certify_ahead", "limit_digits", "rate_digits"), {"answer": decide([Fraction(-3, 10)], [HALF]), "digits": 5}),
    "cyclotomic_real": {"n": 7}, "Filter": {"a": (fmpq(1),), "g": (fmpq(1, 2),)},
    "from_polynomials": {"a": [1, 2], "b": [1, 1]}, "from_covariances": {"c": [1, HALF, Fraction(1, 4)]},
    "from_realization": {"F": [[HALF]], "g": [HALF], "h": [1]},
    "from_state_space": {"system": SimpleNamespace(A=[[HALF]], B=[[HALF]], C=[[1]], D=[[1]])}, "solve": {"B": [[1], [2]]},
}
FREE = {"name"}  # it only appears in messages
RIGHT = {("decide_many", "time_limit"): WRONG[1], ("orbit", "step"): DOUBTFUL[-1]}  # seconds; a function, whose errors are its own
NOT_CALLED = {"precision", "Sign"}  # a context manager and a type
CLASSES = {"CyclotomicRealField", "Filter", "PseudoPolynomial", "RatField", "RealField", "SturmSequence"}


def _functions():
    """The public functions, the classes that are made by a call, and the ways into a `Filter`."""
    for package in (exactkf.theory, exactkf.exact, exactkf.dynamics):
        for name in package.__all__:
            thing = getattr(package, name)
            if name not in NOT_CALLED and (inspect.isfunction(thing) or name in CLASSES):
                yield pytest.param(thing, name, id=f"{package.__name__}.{name}")
    for name in ("from_ag", "from_polynomials", "from_parameters", "from_covariances", "from_realization", "from_state_space"):
        yield pytest.param(getattr(Filter, name), name, id=f"Filter.{name}")


def _called(function, arguments):
    """The result; of a generator the first value."""
    result = function(**arguments)
    return next(result) if inspect.isgenerator(result) else result


def _right(function, name):
    """Arguments that are taken, and all parameters."""
    parameters = [p for p in inspect.signature(function).parameters.values() if p.kind not in (p.VAR_POSITIONAL, p.VAR_KEYWORD)]
    good = {**GOOD, **OWN.get(name, {})}
    return {p.name: good[p.name] for p in parameters if p.default is p.empty}, parameters


@pytest.mark.parametrize(("function", "name"), list(_functions()))
def test_what_is_right_is_taken(function, name):
    """The arguments that the next test spoils are good ones: no refusal there comes from another argument."""
    arguments, _ = _right(function, name)
    if name in ("analyze", "hstack", "vstack"):
        return  # all arguments are optional
    _called(function, arguments)


@pytest.mark.parametrize(("function", "name"), list(_functions()))
def test_what_is_wrong_is_refused(function, name):
    """One argument is spoiled at a time: no other exception comes out, every message is one line with a remedy, and no nonsense is taken."""
    good, parameters = _right(function, name)
    for parameter in parameters:
        if parameter.name in FREE:
            continue
        for value in WRONG + DOUBTFUL:
            if value is RIGHT.get((name, parameter.name), parameter.default):
                continue
            try:
                _called(function, {**good, parameter.name: value})
            except BadInput as error:
                text = str(error)
                assert "\n" not in text and "; " in text and len(text) < 500, text
                if function.__module__.startswith("exactkf.theory") and any(value is x for x in WRONG):  # elsewhere the caller may choose the name
                    assert re.search(rf"\b{parameter.name}\b", text), (parameter.name, text)
            except Unsupported:
                assert any(value is x for x in DOUBTFUL)
            else:
                assert any(value is x for x in DOUBTFUL), f"{parameter.name} = {value!r} is taken"


NO, SKEW = [[0, 0], [0, 0]], [[1, 2], [3, 4]]
LINE = ([[1, 1], [0, 1]], EYE, [[1, 0]], [[1]])  # Phi, H, M, V


@pytest.mark.parametrize(("call", "text"), [
    (lambda: posterior_covariance(SKEW, [[1, 0]], [[1]]), "P = ((1, 2), (3, 4)): not symmetric, its entries (2, 1) and (1, 2) differ; pass a symmetric matrix"),
    (lambda: posterior_covariance(EYE, EYE, [[1, 0], [5, 1]]), "V = ((1, 0), (5, 1)): not symmetric"),
    (lambda: posterior_covariance([[2, 1], [1, 2]], SKEW, [[1]]), "V = ((1,),): has shape (1, 1) where M asks for (2, 2)"),
    (lambda: posterior_covariance([[1]], [[1, 2]], [[1]]), "M = ((1, 2),): has shape (1, 2) where P asks for (1, 1)"),
    (lambda: posterior_covariance([[1, 2]], [[1]], [[1]]), "P = ((1, 2),): has shape (1, 2) and is not square"),
    (lambda: covariance_step([[1]], [[1]], [[1]], [[1]], [[1, 2, 3], [4, 5, 6]]), "V = ((1, 2, 3), (4, 5, 6)): has shape (2, 3) where M asks for (1, 1)"),
    (lambda: covariance_step(SKEW, *LINE), "P = ((1, 2), (3, 4)): not symmetric"),
    (lambda: covariance_step(EYE, LINE[0], SKEW, *LINE[2:]), "H = ((1, 2), (3, 4)): not symmetric"),
    (lambda: covariance_step(EYE, [[1]], *LINE[1:]), "Phi = ((1,),): has shape (1, 1) where P asks for (2, 2)"),
    (lambda: duven_matrix(EYE, EYE, EYE, [[1, 0], [5, 1]]), "V = ((1, 0), (5, 1)): not symmetric"),
    (lambda: duven_matrix(EYE, [[1]], EYE, EYE), "H = ((1,),): has shape (1, 1) where Phi asks for (2, 2)"),
    (lambda: duven_matrix([[1]], [[1]], [[1]], [[0]]), "V = ((0,),): singular, its first column is zero; pass"),
    (lambda: duven_matrix(EYE, EYE, EYE, [[1, 1], [1, 1]]), "V = ((1, 1), (1, 1)): singular, its first 2 columns are dependent; pass"),
    (lambda: equilibria(LINE[0], [[1, 2], [0, 1]], *LINE[2:]), "H = ((1, 2), (0, 1)): not symmetric"),
    (lambda: stabilizing_equilibrium(LINE[0], [[1, 2], [0, 1]], *LINE[2:]), "H = ((1, 2), (0, 1)): not symmetric"),
    (lambda: equilibrium_from_basis(LINE[0], [[1, 2], [0, 1]], *LINE[2:], EYE), "H = ((1, 2), (0, 1)): not symmetric"),
    (lambda: filter_map(SKEW, EYE, EYE, EYE), "P = ((1, 2), (3, 4)): not symmetric"),
    (lambda: filter_map(EYE, EYE, [[0]], EYE), "F = ((0,),): has shape (1, 1) where P asks for (2, 1)"),
    (lambda: filter_map(EYE, EYE, EYE, [[0]]), "C = ((0,),): has shape (1, 1) where P asks for (1, 2)"),
    (lambda: filter_map(EYE, [[1]], EYE, EYE), "A = ((1,),): has shape (1, 1) where P asks for (2, 2)"),
    (lambda: riccati_step(NO, [[1], [0]], [[0], [1]], SKEW), "P = ((1, 2), (3, 4)): not symmetric"),
    (lambda: riccati_gain(NO, [[1], [0]], [[0, 1]], EYE), "h = ((0, 1),): has shape (1, 2) where F asks for (2, 1)"),
    (lambda: symplectic_matrix([[1, 2]], [[1]], [[1]]), "F = ((1, 2),): has shape (1, 2) and is not square"),
    (lambda: symplectic_matrix(EYE, [[1]], [[1], [0]]), "g = ((1,),): has shape (1, 1) where F asks for (2, 1)"),
    (lambda: act([[1]], [[1]]), "S = ((1,),): has shape (1, 1) where P asks for (2, 2)"),
    (lambda: act(EYE, [[1, 2]]), "P = ((1, 2),): has shape (1, 2) and is not square"),
    (lambda: moebius(EYE, EYE), "T = ((1, 0), (0, 1)): has shape (2, 2) where M asks for (1, 1)"),
    (lambda: from_factors(EYE, EYE, [[0]]), "Q = ((0,),): has shape (1, 1) where A asks for (2, 2)"),
    (lambda: from_factors([[1, 2]], EYE, EYE), "A = ((1, 2),): has shape (1, 2) and is not square"),
    (lambda: hamiltonian_matrix(EYE, [[1]], EYE), "F = ((1,),): has shape (1, 1) where A asks for (2, 1)"),
    (lambda: hamiltonian_matrix(EYE, EYE, [[1]]), "C = ((1,),): has shape (1, 1) where A asks for (1, 2)"),
    (lambda: likelihood_matrix(EYE, SKEW), "R = ((1, 2), (3, 4)): not symmetric"),
    (lambda: estimate([[1]], [[1]], [[1]]), "y[0] = [1]: not a scalar"),
    (lambda: exact_orbit(NAN, [1], 3), "a = nan: not a sequence"),
    (lambda: exact_orbit([], [], 3), "a = (): empty, and the filter needs n >= 1"),
    (lambda: orbit(step_ag, [(1,)], 3), "state = [(1,)]: not a pair of vectors"),
    (lambda: observer_form([], []), "a = (): empty"),
    (lambda: projective_invariants([]), "d = (): empty, and d_0 is needed"),
    (lambda: pseudo_polynomial_from_q([1], [1, 2]), "q_star = (1, 2): has length 2 where q asks for 1"),
    (lambda: step_polynomials([1], []), "Q = (1,): has fewer than two coefficients"),
    (lambda: schur_parameters({1, 2}), "c = {1, 2}: not a sequence"),
    (lambda: schur_parameters(fmpz_poly([1, 2])), "c = 2*x + 1: not a sequence"),
    (lambda: schur_parameters([mat(EYE)]), "c[0] = 2x2 matrix [[1, 0], [0, 1]]: not a scalar"),
    (lambda: schur_parameters([HALF, mpf(1)]), "an entry of c = mpf('1.0'): does not combine with Fraction(1, 2)"),
    (lambda: exactkf.exact.zero(-1), "argument 'n_rows' is not an integer of at least 0: -1"),
    (lambda: exactkf.exact.identity(True), "argument 'n' is not an integer of at least 0: True"),
    (lambda: exactkf.exact.power(EYE, 0.5), "argument 'n' is not an integer: 0.5"),
    (lambda: exactkf.exact.matrix({1: 2}), "argument 'rows' is not a matrix: {1: 2}"),
    (lambda: exactkf.exact.rational(1, floats="near"), "argument 'floats' is not a policy: 'near'"),
    (lambda: Filter((1.5,), (1,)), "argument 'a' is no tuple of fmpq or RealNumber: (1.5,)"),
    (lambda: digits_ahead([1], [2], 3, answer="x"), "argument 'answer' is not an Answer: 'x'"),
])
def test_shapes_symmetry_and_kinds(call, text):
    """What was taken silently, or came out as an exception of Python, is refused by name, with the value."""
    with pytest.raises(BadInput) as caught:
        call()
    assert str(caught.value).startswith(text) and "\n" not in str(caught.value)


HUGE = 10**9
ONE = Filter.from_ag(["1/2"], ["1/3"])


@pytest.mark.parametrize(("call", "name", "remedy"), [
    (lambda: orbit(step_ag, ([1], [HALF]), HUGE), "steps", "state_after and digits_ahead"),
    (lambda: exact_orbit([0], [2], HUGE), "steps", "state_after and digits_ahead"),
    (lambda: first_escape([1], [HALF], HUGE), "steps", "exactkf.dynamics.decide"),
    (lambda: state_after([1], [HALF], HUGE), "T", "digits_ahead"),
    (lambda: state_ahead([1], [HALF], HUGE), "T", "digits_ahead"),
    (lambda: power_modulo(10 * HUGE, fmpz_poly([-1, -3, 1])), "exponent", "pass a smaller one"),
    (lambda: digits_ahead([1], [HALF], 10**1000), "T", "pass T <= 10**100"),
    (lambda: digits_ahead([1], [HALF], 9, HUGE), "digits", "pass digits <= "),
    (lambda: laurent_covariances([1], [2], HUGE), "count", "pass count <= "),
    (lambda: ONE.covariances(HUGE), "count", "pass count <= "),
    (lambda: decide([1], [HALF], max_steps=HUGE), "max_steps", "seldom"),
    (lambda: limit_digits(decide([HALF], [THIRD]), HUGE), "digits", "pass digits <= "),
    (lambda: rate_digits(decide([HALF], [THIRD]), HUGE), "digits", "pass digits <= "),
    (lambda: draw_gamma(ONE, HUGE), "steps", "state_after and digits_ahead"),
    (lambda: draw_plane(ONE, HUGE), "steps", "state_after and digits_ahead"),
    (lambda: verdict_of_doubles("1/2", "1/3", HUGE), "steps", "pass steps <= "),
])
def test_what_would_never_end_or_fill_the_memory(call, name, remedy):
    """A number that nobody could wait for, or no memory hold, is refused at once, with what to do instead."""
    with pytest.raises(BadInput) as caught:
        call()
    text = str(caught.value)
    assert (text.startswith(f"argument {name!r} is more than") or text.startswith(f"{name} = ")) and remedy in text and "\n" not in text


def test_states_that_fill_the_memory_are_refused_on_the_way(monkeypatch):
    """Fewer steps than are refused at once may still be too many, by the size of the numbers."""
    monkeypatch.setattr("exactkf.theory.orbits._MOST_BITS", 1 << 16)
    with pytest.raises(BadInput, match="the first [0-9]+ states have more than 8192 bytes; state_after"):
        exact_orbit([0], [2], 10**5)
    assert len(exact_orbit([2], [-2], 1000).states) == 1001


def test_balls_that_overlap_are_symmetric():
    """Two enclosures of one number differ as a rule; only entries that are surely different make a matrix unsymmetric."""
    wide = arb(1, 1e-9)
    assert posterior_covariance([[2, wide], [wide, 2]], [[1, 0]], [[1]])[1][1].overlaps(arb(fmpq(5, 3)))
    with pytest.raises(BadInput, match="not symmetric"):
        posterior_covariance([[2, wide], [wide + 1, 2]], [[1, 0]], [[1]])


def test_fractions_are_rationals_everywhere():
    """Fractions and fmpq give one answer."""
    assert digits_ahead([HALF], [THIRD], 9).g[0].overlaps(digits_ahead([fmpq(1, 2)], [fmpq(1, 3)], 9).g[0])
