# SPDX-License-Identifier: MIT
"""The structure behind orbits and the speed of convergence: by hand, against matrices, against orbits far ahead, over fields."""

from __future__ import annotations

import json
import random
import re

import pytest
from flint import arb, fmpq, fmpq_mat, fmpq_poly

from exactkf import analyze
from exactkf._errors import BadInput
from exactkf.dynamics.ahead import digits_ahead
from exactkf.dynamics.every_order import decide, limit_digits, rate_digits
from exactkf.dynamics.order_one import decide_order_one, decide_riccati_one
from exactkf.dynamics.spectral_factor import spectral_factor
from exactkf.dynamics.speed import rate_ball, speed
from exactkf.dynamics.structure import structure, structure_json
from exactkf.dynamics.zeros import circle_points, norm, products_of_zeros
from exactkf.exact import cyclotomic_real, sqrt_field
from exactkf.exact.balls import precision
from exactkf.exact.canonical import elementary_divisors
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.theory.power_method import symplectic_matrix_of
from tests.dynamics.test_every_order import self_product, start, times, with_spectrum


def converging(rng, w):
    """A start that converges with D proportional to w(z) w(1/z)."""
    while True:
        found = with_spectrum(rng, self_product([fmpq(x) for x in w]))
        if found is not None and decide(*found).behaviour == "converges":
            return found


def polynomial_at(p, S, v):
    """p(S) v, p from z^0 up."""
    out = [0 * x for x in v]
    for c in reversed(p):
        out = [sum((a * b for a, b in zip(row, out, strict=True)), 0 * v[0]) + c * x for row, x in zip(S, v, strict=True)]
    return out


# ---------------------------------------------------------------------- structure
@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_the_structure_against_matrices(n):
    """S is that of the theory, its elementary divisors are the zeros of D, and the subspaces are annihilated as they should."""
    rng, subspaces = random.Random(n), 0
    for _ in range(40):
        state = start(rng, n)
        found = structure(*state) if state else None
        if found is None or found.S is None:
            continue
        S = fmpq_mat(found.S.rows)
        assert sorted(([str(c) for c in e.factor.coeffs()], *e.sizes) for e in elementary_divisors(S)) == sorted(
            ([str(c) for c in block.polynomial], block.size) for block in found.jordan)
        D = [*found.reduced[:0:-1], *found.reduced]
        assert S.charpoly() * D[-1] == sum((c * x for c, x in zip(D, powers(len(D)), strict=True)), 0 * powers(1)[0])
        if found.dominant is not None and not isinstance(found.dominant[0], arb):
            w = list(spectral_factor(D).coefficients)
            for u, p in ((found.dominant, w[::-1]), (found.codominant, w)):
                basis = found.subspace(u)
                for column in basis.transpose().rows:
                    assert all(x == 0 for x in polynomial_at(p, found.S.rows, column))
                assert basis.nrows == 2 * basis.ncols == 2 * found.order
            subspaces += 1
    assert subspaces >= 5


def powers(count):
    """1, x, x^2, ..."""
    return [fmpq_poly([0] * k + [1]) for k in range(count)]


def test_the_structure_of_order_one_by_hand():
    """Q = z + 3, S = 1/2: D = 39/4 + 3 (z + 1/z); Q = z + 2, S = 3/2: D = 11/4 + 2 (z + 1/z)."""
    found = structure([fmpq(5, 2)], [fmpq(1, 2)])
    assert (found.d, found.kappa, found.sign, found.circle_zeros) == ((fmpq(39, 4), fmpq(3)), (fmpq(8, 13),), "positive", ())
    assert found.S.rows == symplectic_matrix_of([fmpq(5, 2)], [fmpq(1, 2)]).tolist()
    changing = structure([fmpq(1, 2)], [fmpq(3, 2)])
    assert (changing.d, changing.sign, changing.circle_zeros, changing.dominant) == ((fmpq(11, 4), fmpq(2)), "indefinite", (("-11/8", 1),), None)


def test_common_factors_of_a_and_b():
    """(z - 2)(z + 1/3) is common to both from the start; a factor z comes in a step where Q(0) = 0."""
    common = times([fmpq(1), fmpq(-2)], [fmpq(1), fmpq(1, 3)])
    a, b = times(common, [fmpq(1), fmpq(1, 2)]), times(common, [fmpq(1), fmpq(3, 4)])
    found = structure(a[1:], [(y - x) / 2 for x, y in zip(a, b, strict=True)][1:])
    assert (found.order, found.start, found.gcd, found.factor) == (1, 0, tuple(common[::-1]), tuple(common[::-1]))
    late = structure([fmpq(0), fmpq(-1, 2)], [fmpq(0), fmpq(1, 2)])
    assert (late.order, late.start, late.gcd, late.factor, late.S) == (0, 2, (1,), (0, 0, 1), None)
    assert (late.d, late.kappa, late.sign, late.circle_zeros) == ((fmpq(3, 4), 0, 0), (0, 0), "positive", ())  # Q = z^2, S = 1/2
    still = structure([fmpq(3)], [fmpq(0)])
    assert (still.order, still.gcd, still.S) == (0, (3, 1), None)


@pytest.mark.parametrize(("data", "d", "sign", "zeros", "reduced"), [
    # (z + 1)(z - 1/2) and (z + 1)(z + 1/3): D has a double zero at -1, that of the pair without z + 1 has none
    ({"b": [1, "4/3", "1/3"], "a": [1, "1/2", "-1/2"]}, ["3/2", "2/3", "-1/12"], "nonnegative", [{"two_cos": "-2", "multiplicity": 2}], ["5/6", "-1/12"]),
    ({"alpha": [0], "gamma": ["3/2"]}, ["-5/4", "0"], "negative", [], ["1"]),  # one step on it is positive
    ({"a": [0, -1], "g": [0, 1]}, ["0", "0", "0"], "zero", None, ["0", "0"]),  # Q = z^2, S = 1
    ({"a": ["1/2", 1], "g": [0, 0]}, ["9/4", "1", "1"], "nonnegative", [{"two_cos": "-1/2", "multiplicity": 2}], ["1"]),
])
def test_d_is_that_of_the_filter_whatever_a_and_b_have_in_common(data, d, sign, zeros, reduced):
    """By hand: sign, zeros and projective point are of D = Q(z) Q(1/z) - S(z) S(1/z) as it is given; those of the reduced pair are refused."""
    answer = analyze(**data)
    found = answer.structure
    assert (found["d"], found["sign"], found["circle_zeros"]) == (d, sign, zeros)
    assert f"({' : '.join(d)})" in str(answer) and f"D on the circle      {sign}" in str(answer)
    replay(answer.certificate)
    whole = answer.certificate
    for change in ({"sign": "positive"}, {"circle_zeros": []}, {"d": reduced}):
        if all(found[key] == value for key, value in change.items()):
            continue
        said = {**whole["statement"]["answer"], "structure": {**found, **change}}
        with pytest.raises(Rejected):
            replay(seal(whole["id"], whole["kind"], {**whole["statement"], "answer": said}, whole["evidence"]))


def test_zeros_on_the_circle_with_multiplicities():
    """D with (z + 1)^4 (z^2 - z + 1)^2: multiplicities at -1 and at 2 cos = 1; Jordan blocks of these sizes."""
    w = times(times([1, 1], [1, 1]), [1, -1, 1])
    found = structure(*converging(random.Random(1), w))
    assert found.circle_zeros == (("-2", 4), ("1", 2))
    assert sorted((tuple(map(int, block.polynomial)), block.size) for block in found.jordan) == [((1, -1, 1), 2), ((1, 1), 4)]
    assert found.sign in ("nonnegative", "nonpositive") and found.dominant == found.codominant


def test_the_structure_over_a_field():
    """Over Q(sqrt 2): zeros of D on the circle exactly, S with the characteristic polynomial z^m D / d_m, subspaces in balls."""
    field = cyclotomic_real(16)
    x = field.two_cos(3)
    assert circle_points([field(1), -x, field(1)])[0].two_cos["minpoly"] == [str(c) for c in x.minimal_polynomial().numer().coeffs()]
    assert circle_points([field(1), -2 * x, x * x + 2, -2 * x, field(1)]) == [(circle_points([field(1), -x, field(1)])[0].two_cos, 2)]
    root = sqrt_field(2).gen()
    found = structure([root / 4, root / 8], [root / 16, root - root])
    assert (found.order, found.sign, found.circle_zeros, len(found.jordan)) == (2, "positive", (), 1)
    p, S = found.jordan[0].polynomial, found.S.rows
    for k in range(4):
        assert all(x == 0 for x in polynomial_at(p, S, [root - root + int(i == k) for i in range(4)]))  # Cayley and Hamilton
    w = limit_digits(decide([root / 4, root / 8], [root / 16, root - root]), 60).alpha
    with precision(200):
        near = [[v.enclose(60) for v in row] for row in S]
        stable = [w[1], w[0], arb(1)]
        for u, q in ((found.dominant, stable[::-1]), (found.codominant, stable)):
            residue = polynomial_at(q, near, [arb(1), arb(0), *u])
            assert all(r.contains(0) and r.rad() < arb(10) ** -40 for r in residue)
            assert not all(r.contains(0) for r in polynomial_at(q[::-1], near, [arb(1), arb(0), *u]))
    assert json.loads(json.dumps(structure_json(found)))["field"] == [["-2", "0", "1"], "1", "2"]


def test_an_escape_before_the_reduction_ends():
    """No S, and D may be zero; the answer has a structure all the same."""
    answer = analyze(a=["0", "-1"], g=["0", "1"])
    assert answer.behaviour == "escapes" and answer.structure["S"] is None and str(answer) and answer.latex()


# ---------------------------------------------------------------------- speed
@pytest.mark.parametrize("alpha", ["3", "-3/2", "1/7", "5/2"])
def test_the_rate_is_that_of_order_one(alpha):
    """Both deciders name the same number."""
    one = decide_order_one(alpha, "1/3")
    a = fmpq(*map(int, alpha.split("/"))) - fmpq(1, 3)
    general = decide([a], [fmpq(1, 3)])
    assert one.rate["minpoly"] == general.rate["minpoly"] if isinstance(one.rate, dict) else one.rate == general.rate
    for answer in (one, general):
        replay(answer.certificate)
        assert answer.certificate["statement"]["answer"]["rate"] == answer.rate


@pytest.mark.parametrize(("w", "rate"), [
    ([1, fmpq(1, 2)], "1/4"), ([1, 0, fmpq(1, 2)], "1/2"), ([1, fmpq(1, 2), fmpq(1, 3)], "1/3"),
    ([1, fmpq(1, 6), fmpq(-1, 6)], "1/4"),  # zeros 1/3, -1/2
    (times([1, fmpq(1, 2)], [1, 0, fmpq(4, 9)]), "4/9"),
])
def test_rates_by_hand(w, rate):
    """The square of the largest modulus inside, for zeros real, complex, and both."""
    answer = decide(*converging(random.Random(2), w))
    assert (answer.rate, answer.slow) == (rate, None)


@pytest.mark.parametrize("w", [[1, fmpq(1, 2), fmpq(1, 3)], [1, fmpq(-1, 3), fmpq(1, 2), fmpq(1, 4)], [1, 0, 0, fmpq(1, 5)]])
def test_the_rate_against_the_orbit(w):
    """The t-th root of the distance nears the rate, that of |gamma| its square root, and no faster rate would do."""
    a, g = converging(random.Random(4), w)
    answer = decide(a, g)
    rho, limit = rate_digits(answer, 30), limit_digits(answer, 700).alpha
    roots = []
    with precision(2600):
        for t in range(300, 330):
            far = digits_ahead(a, g, t, 700, answer=answer)
            distance = max((abs(x + y - z) for x, y, z in zip(far.a, far.g, limit, strict=True)), key=lambda x: x.mid())
            roots.append((distance.log() / t).exp() / rho)
            assert distance < 1000 * (rho * arb("1.02")) ** t
    assert max(roots, key=lambda x: x.mid()) > arb("0.97")


@pytest.mark.parametrize(("w", "K"), [([1, 1], 1), ([1, 2, 1], 4), ([1, -1, 1], 2), ([1, 0, 2, 0, 1], 8), ([1, 0, -1], 2), ([1, 1, 1, 1], 3),
                                      (times([1, 1], [1, fmpq(1, 2)]), 1)])
def test_double_zeros_on_the_circle_are_slow(w, K):
    """t (1 - alpha_n(t)/alpha_n) tends to the sum of the squares of half the multiplicities."""
    a, g = converging(random.Random(5), w)
    answer = decide(a, g)
    assert (answer.rate, answer.slow) == (None, K)
    last = limit_digits(answer, 60).alpha[-1]
    for t, near in ((1000, "0.02"), (4000, "0.005")):
        far = digits_ahead(a, g, t, 60, answer=answer)
        assert abs(t * (1 - (far.a[-1] + far.g[-1]) / last) - K) < K * arb(near)
    with pytest.raises(BadInput):
        rate_digits(answer, 5)


def test_rates_at_rest_and_at_equilibria():
    """An orbit that rests after some steps has the rate zero; an equilibrium, a periodic orbit none."""
    assert decide([0, fmpq(-1, 2)], [0, fmpq(1, 2)]).rate == "0" == decide_order_one(0, 2).rate
    for answer in (decide([0, fmpq(1, 2)], [0, 0]), decide_order_one(3, 0), decide_order_one(1, 1), decide([fmpq(0)], [fmpq(1)])):
        assert (answer.rate, answer.slow) == (None, None)
    assert (decide_order_one("5/2", "3/2").slow, decide_riccati_one("5/2", "3/2", "1/10").slow) == (1, 1)


def test_rates_over_a_field():
    """z + sqrt(2)/2 has the rate 1/2; a rate of large degree is enclosed, to any number of digits."""
    root = sqrt_field(2).gen()
    D = [root / 2, fmpq(3, 2) + 0 * root, root / 2]
    assert speed(D, []).rate == "1/2"
    state = [root / 4, root / 8, root / 7, root / 9], [root / 16, root - root, root / 12, root / 20]
    answer = decide(*state)
    assert set(answer.rate) == {"interval"}
    lo, hi = (fmpq(*map(int, x.split("/"))) for x in answer.rate["interval"])
    assert 0 < lo < hi < 1 and hi - lo < fmpq(1, 10**49)
    more = rate_digits(answer, 120)
    assert more.rel_accuracy_bits() > 390
    with precision(500):
        assert lo < more < hi
    assert "(enclosed)" in next(line for line in str(answer).splitlines() if line.startswith("  rate"))
    with pytest.raises(BadInput, match="digits = 0"):
        rate_ball("1/2", D, 0)


def test_products_of_zeros_and_norms():
    """The products of 1, 2, 5; the norm of z - theta."""
    found = products_of_zeros(fmpq_poly([-10, 17, -8, 1]))
    assert sorted((int(x), k) for x, k in found.roots()) == [(1, 1), (2, 1), (4, 1), (5, 1), (10, 1), (25, 1)]
    x = cyclotomic_real(7).gen()
    assert norm([-x, x.field(1)]) == x.field.minpoly


# ---------------------------------------------------------------------- shown
@pytest.mark.parametrize("data", [
    {"alpha": [3], "gamma": ["1/2"]}, {"alpha": [0, 2], "gamma": ["1/2", "1/3"]}, {"alpha": ["sqrt(2)", "1/2"], "gamma": [0, "1/3"]},
    {"a": ["0", "-1/2"], "g": ["0", "1/2"]}, {"alpha": ["5/2"], "gamma": ["3/2"]}, {"alpha": [-2], "gamma": ["sqrt(3)"]},
])
def test_words_json_and_latex_say_the_same(data):
    """Behaviour, limit, steps, rate and structure are in all three."""
    answer = analyze(**data)
    words, latex, found = str(answer), answer.latex(), answer.to_json()
    assert latex.count("$") % 2 == 0 and latex.count("{") == latex.count("}")
    assert latex.count("\\begin{itemize}") == latex.count("\\end{itemize}")
    for value, say, tex in ((found["limit"], "  limit of alpha", "Limit: $"), (found["rate"] or found["slow"], "  rate ", "Rate: "),
                            (found["monotone_from"], "  monotone from step", "Monotone from step: $"),
                            (found["enters_positive_real"], "  positive real from step", "Positive real from step: $"),
                            (found["structure"]["S"], "  S, by rows", "$S$: ")):
        assert (value is not None) == (say in words) == (tex in latex), say
    for zero in found["structure"]["circle_zeros"]:
        assert "z + 1/z = " in words and "$z + 1/z = " in latex or zero["two_cos"] in ("2", "-2")
    assert "The certificate vouches for" in words and "The certificate vouches for" in latex
    for said, cited in (("is cited (Nevai and Totik 1989), not proved", found["rate"] not in (None, "0")),
                        ("is argued in words, not proved", found["slow"] is not None)):
        assert (said in words) == (said in latex) == (answer.order > 1 and cited)
    assert found["beside"] == ["facts"]


COMMANDS = set("alpha begin cdot cos dots end equiv frac gamma ge gcd infty item kappa ldots lim limsup mapsto mathbb mid ne neq nmid noindent operatorname pi "
               "pmatrix pmod sqrt text textbf theta tilde varphi vartheta zeta le Phi".split())


@pytest.mark.parametrize("data", [
    {"alpha": ["sqrt(2)", "1/2"], "gamma": [0, "1/3"]}, {"a": [0, "1/2"], "g": ["sqrt(3)/2", "1/3"]}, {"alpha": [-2], "gamma": ["sqrt(3)"]},
    {"alpha": [0, 2], "gamma": ["1/2", "sqrt(2)/3"]},
    {"b": [1, "4/3", "1/3"], "a": [1, "1/2", "-1/2"]}, {"alpha": ["cos(2*pi/23)"], "gamma": ["1/3"]}, {"alpha": ["sqrt(2)"], "gamma": ["1/3"], "pi0": "1/2"},
])
def test_the_commands_in_latex_exist(data):
    """A coefficient that ends with a letter does not run into the variable, exponents of two digits are in braces, and signs do not meet."""
    latex = analyze(**data).latex()
    assert set(re.findall(r"\\([A-Za-z]+)", latex)) <= COMMANDS
    assert not re.search(r"\^\d\d|\+ ?-|- ?-|\+ ?\+", latex)


def test_zeros_next_to_each_other_and_to_one_are_told_apart():
    """Double zeros of D at 2 cos(angle) = 2 - 10^-30, 1 and 1 + 10^-30: three numbers in three intervals in [-2, 2], and a certificate that replays."""
    near = fmpq(1, 10**30)
    quadratic = [[fmpq(1), -x, fmpq(1)] for x in (2 - near, fmpq(1), 1 + near)]
    D = quadratic[0]
    for f in (quadratic[0], quadratic[1], quadratic[1], quadratic[2], quadratic[2]):
        D = times(D, f)
    assert circle_points(D) == [("1", 2), (str(1 + near), 2), (str(2 - near), 2)]
    irrational = [fmpq(1), fmpq(0), -4 + near, fmpq(0), fmpq(1)]  # z + 1/z with the squares 6 - 10^-30 - ..., so two beyond 2
    (found,) = [circle_points(times(irrational, [fmpq(1), fmpq(-1), fmpq(1)]))]
    assert found == [("1", 1)]
    close = times([fmpq(1), fmpq(0), near - 2, fmpq(0), fmpq(1)], [fmpq(1), fmpq(1), fmpq(1)])  # x^2 = 4 - 10^-30
    found = circle_points(close)
    assert len(found) == 3 and found[1] == ("-1", 1)
    for point in (found[0], found[2]):
        lo, hi = (fmpq(*map(int, x.split("/"))) for x in point.two_cos["interval"])
        assert -2 <= lo < hi <= 2
