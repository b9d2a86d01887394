# SPDX-License-Identifier: MIT
"""False statements at a generic index, with evidence made by hand: the checker rejects each, and accepts the true neighbour."""

from __future__ import annotations

import pytest

from exactkf.kernel.defined import ill_founded
from tests.kernel.test_false_claims import accepted, statement

n, t, k, s, i, j, c, w = (["sym", name] for name in ("n", "t", "k", "s", "i", "j", "c", "w"))
A, B, M = ["sym", "A"], ["sym", "B"], ["sym", "M"]
SCALAR = [["c", ["scalar"]]]


def at(name, *indices):
    return ["at", name, *indices]


def when(relation, x, y, then, other):
    return ["if", [relation, x, y], then, other]


# ---------------------------------------------------------------------- sizes
@pytest.mark.parametrize("kind", [["symmetric", n], ["psd", n], ["nonsingular", n], ["diagonal", n]])
def test_a_matrix_of_another_type_is_no_number(kind):
    """Inverses of symmetric matrices do not commute, and such a matrix has not one row."""
    over = [["A", kind], ["B", kind]]
    commute = ["=", ["*", ["inv", A], ["inv", B]], ["*", ["inv", B], ["inv", A]]]
    assert not accepted("generic index", statement(commute, over), {"lemmas": []})
    assert not accepted("generic index", statement(["=", ["nrows", A], 1], over), {"lemmas": []})
    assert accepted("generic index", statement(["=", ["nrows", A], n], [["A", ["matrix", n, n]]]), {"lemmas": []})


@pytest.mark.parametrize("matrix", [
    ["rows", [1, 2], [3, 4]], ["diag", 1, 2], ["if", ["=", 1, 1], A, A], ["sum", "i", 1, 2, A], at("S", 0), at("f", 1), ["+", at("S", 0), at("S", 1)],
    ["*", ["mat", "i", "j", 1, 1, 2], at("S", 0)], ["recip", at("S", 0)], ["T", at("S", 0)], at("X", 0),
])
def test_a_term_that_may_be_a_matrix_is_no_number(matrix):
    """Nor is a table, a case, a sum, an entry of a sequence of matrices."""
    over = [["A", ["matrix", n, n]], ["S", ["signal_of", 0, ["matrix", n, n]]]]
    where = [["let", "f", ["k"], at("S", k)], ["rec", "X", "t", 0, [at("S", 0)], at("X", t)]]
    inverses = ["inv", matrix], ["inv", ["T", matrix]]
    for says in (["=", ["nrows", matrix], 1], ["=", ["*", *inverses], ["*", *inverses[::-1]]]):
        assert not accepted("generic index", statement(says, over, (), where), {"lemmas": []})


def test_a_polynomial_has_coefficients():
    """The determinant of (p) is p, and its coefficient of z need not vanish."""
    made = statement(["=", ["coeff", ["det", ["sym", "p"]], 1], 0], [["p", ["poly", 2]]], sizes=[])
    assert not accepted("generic index", made, {"lemmas": []})
    assert not accepted("generic index", {**made, "over": [["p", ["monic", 2]]]}, {"lemmas": []})
    assert accepted("generic index", {**made, "over": [["p", ["scalar"]]]}, {"lemmas": []})


@pytest.mark.parametrize("low, sized", [(0, True), (1, False)])
def test_a_sum_without_terms_has_no_size(low, sized):
    """For n = 0 a sum of matrices from 1 to n is the number zero, with one row."""
    total = ["sum", "k", low, n, A]
    made = statement(["=", ["nrows", total], n], [["A", ["matrix", n, n]]])
    assert accepted("generic index", made, {"lemmas": []}) is sized
    assert accepted("counterexample", made, {"instance": {"sizes": {"n": 0}, "values": {"A": []}}}) is not sized


def test_a_reversed_number_is_a_polynomial():
    """rev(c, n) = c z^n, though there is no z in it."""
    for tree in (["rev", c, 2], at("f", 2)):
        made = statement(["=", ["coeff", tree, 2], 0], SCALAR, (), [["let", "f", ["k"], ["rev", c, k]]])
        assert not accepted("generic index", made, {"lemmas": []})
        assert accepted("generic index", {**made, "says": ["=", ["coeff", tree, 2], c]}, {"lemmas": []})


def test_blocks_have_all_their_columns():
    """Two matrices with one column in common are not equal for that."""
    first, zero = (["mat", "i", "j", n, n, x] for x in (when("=", j, 1, 0, 1), 0))
    for row in ([], [["mat", "i", "j", 1, n, 0]], [["col", "i", 1, 0]]):
        says = ["=", *(["block", [x], *([row] if row else [])] for x in (first, zero))]
        assert not accepted("generic index", statement(says, []), {"lemmas": []})
    assert not accepted("generic index", statement(["=", ["ncols", ["block", [first], [zero]]], 1], []), {"lemmas": []})
    assert accepted("generic index", statement(["=", ["ncols", ["block", [first], [zero]]], n], []), {"lemmas": []})
    assert accepted("generic index", statement(["=", ["block", [zero], [zero]], ["mat", "i", "j", ["+", n, n], n, 0]], []), {"lemmas": []})


# ---------------------------------------------------------------------- recursions that define nothing
def test_a_recursion_behind_a_determinant_defines_nothing():
    """X[t + 1] = det(X[t + 1]) + 1 has no solution."""
    def matrix(x):
        return ["mat", "i", "j", 2, 2, when("=", i, j, when("=", i, 1, x, 1), 0)]

    def step(index):
        return [["rec", "X", "t", 0, [0], ["+", ["det", matrix(at("X", index))], 1]]]

    fact = {"index": "s", "fact": "det", "by": ["I", 2], "says": ["=", ["det", matrix(at("X", s))], ["prod", "k", 1, 2, when("=", k, 1, at("X", s), 1)]]}
    evidence = {"lemmas": [fact], "uses": [{"lemma": 0, "at": {"s": 1}, "times": ["neg", c]}]}
    made = statement(["=", c, 0], SCALAR, (), step(["+", t, 1]))
    assert not accepted("generic index", made, evidence)
    assert accepted("generic index", {**made, "says": ["=", ["det", matrix(at("X", 1))], at("X", 1)], "where": step(t)}, {"lemmas": [fact], "uses": [
        {"lemma": 0, "at": {"s": 1}}]})


@pytest.mark.parametrize("index, solved", [(["+", t, 1], False), (t, True)])
def test_a_recursion_behind_an_inverse_is_looked_at(index, solved):
    """X[t + 1] = f(X[t + 1]) is not made of smaller values, however f is written."""
    matrix = ["mat", "i", "j", 2, 2, when("=", i, j, 1, at("X", index))]
    for term in (["*", ["inv", matrix], ["col", "i", 2, 1]], ["*", ["^", M, n], matrix, ["col", "i", 2, 1]]):
        where = [["rec", "X", "t", 0, [0], ["entry", term, 1]]]
        assert (not ill_founded(statement(["=", c, c], [["M", ["matrix", 2, 2]]], (), where), [{"n": 1}])) is solved


# ---------------------------------------------------------------------- what is not zero
def test_a_determinant_that_vanishes_is_not_divided_by():
    """That of [[1, w], [1/w, 1]] is zero, though there is a zero above the diagonal where w = 0."""
    entry = at("w", 1)

    def matrix(above, below):
        return ["mat", "i", "j", 2, 2, when("=", i, j, 1, when("<", i, j, above, below))]

    by = matrix(0, ["neg", ["/", 1, entry]])
    fact = {"index": "s", "fact": "det", "by": by, "says": ["=", ["det", M], ["prod", "k", 1, 2, when("=", k, 1, 1, 0)]]}
    over, evidence = [*SCALAR, ["w", ["matrix", n, 1]]], {"lemmas": [fact], "uses": [{"lemma": 0, "at": {"s": 0}, "times": ["/", c, ["det", M]]}]}
    made = statement(["=", c, 0], over, (), [["let", "M", [], matrix(entry, ["/", 1, entry])]])
    assert not accepted("generic index", made, evidence)
    told = {**made, "says": ["=", ["/", c, ["det", M]], ["/", c, ["det", M]]]}
    assert not accepted("generic index", told, {"lemmas": []})
    assert accepted("generic index", {**told, "where": [["let", "M", [], matrix(entry, entry)]]}, {"lemmas": []})


def test_what_is_not_zero_at_some_indices_may_be_zero_at_others():
    """X = 1, 2, 2, .. divides by X - 1 from the second on: (X - 1) Z = 0 does not give Z = 0 at the first."""
    X, less = at("X", k), ["-", at("X", k), 1]
    where = [["rec", "X", "t", 0, [1, 2], at("X", t)], ["rec", "Z", "t", 0, [1], 0]]
    two = {"index": "t", "from": 1, "says": ["=", at("X", t), 2], "uses": [{"lemma": 0, "at": {"t": t}}, {"definition": "X", "at": [["+", t, 1]]}]}
    product = {"index": "t", "says": ["=", ["*", ["-", at("X", t), 1], at("Z", t)], 0]}
    divides = {"index": "t", "direct": True, "says": ["forall", "k", 1, n, ["=", ["/", c, less], c]], "uses": [{"lemma": 0, "at": {"t": k}}]}
    evidence = {"lemmas": [two, product, divides], "uses": [{"lemma": 1, "at": {"t": k}, "times": ["/", 1, less]}]}
    made = statement(["forall", "t", 0, 0, ["forall", "k", 0, n, ["=", at("Z", k), 0]]], SCALAR, (), where)
    assert not accepted("generic index", made, evidence)
    assert accepted("generic index", {**made, "says": ["forall", "t", 0, 0, ["forall", "k", 1, n, ["=", X, 2]]]},
                    {"lemmas": [two, product, divides], "uses": [{"lemma": 0, "at": {"t": k}}]})


# ---------------------------------------------------------------------- inverses
def test_an_inverse_in_an_empty_sum_need_not_exist():
    """For t = 0 nothing in a sum from 1 to t has a value; from 0 to t something has."""
    u, singular = ["sym", "u"], ["inv", ["mat", "i", "j", 2, 2, 0]]
    cancelled = {"index": "s", "fact": "solve", "says": ["=", ["*", singular, u, 0], u]}
    evidence = {"lemmas": [cancelled], "uses": [{"lemma": 0, "at": {"s": 0, "row": 1, "column": 1}}]}
    over = [["w", ["signal", 0]], ["u", ["matrix", 2, 1]]]
    for low, good in ((1, False), (0, True)):
        total = ["sum", "k", low, t, ["*", ["entry", ["*", singular, u], 1], at("w", k)]]
        made = statement(["forall", "t", 0, n, ["=", ["+", total, at("u", 1)], total]], over)
        assert accepted("generic index", made, evidence) is good  # there is no instance of the second
        nowhere = {"sizes": {"n": 0}, "values": {"w": [0], "u": [[1], [1]]}}
        assert accepted("counterexample", made, {"instance": nowhere}) is not good


def test_a_rule_with_an_inverse_needs_more_than_an_empty_sum():
    """X = A is X = 2A where a singular matrix has an inverse; a sum from 1 to m with that inverse has a value for m = 0 all the same."""
    m, matrix = ["sym", "m"], ["sym", "A"]
    singular, first = ["inv", ["mat", "i", "j", 2, 2, 0]], ["entry", matrix, 1, 1]
    nothing = {"index": "s", "fact": "solve", "says": ["=", ["*", singular, matrix, 0], matrix]}
    by = [{"lemma": 0, "at": {"s": 0, "row": ["sym", "row"], "column": ["sym", "column"]}}]
    twice = {"index": "t", "rule": True, "base": by, "uses": by, "says": ["=", at("X", t), ["+", ["*", 2, matrix], ["-", singular, singular]]]}
    over, where = [["A", ["matrix", 2, 2]], ["w", ["signal", 0]]], [["rec", "X", "t", 0, [matrix], matrix]]
    for low, good in ((1, False), (0, True)):
        total = ["sum", "k", low, m, ["*", ["entry", singular, 1, 1], at("w", k)]]
        made = statement(["forall", "t", 0, n, ["=", ["+", total, ["entry", at("X", t), 1, 1]], ["+", total, ["*", 2, first]]]], over, (), where, ("n", "m"))
        assert accepted("generic index", made, {"lemmas": [nothing, twice]}) is good  # there is no instance of the second
        instance = {"sizes": {"n": 0, "m": 0}, "values": {"A": [[1, 0], [0, 0]], "w": [0]}}
        assert accepted("counterexample", made, {"instance": instance}) is not good


# ---------------------------------------------------------------------- names
@pytest.mark.parametrize("index, good", [("M", False), ("k", True)])
def test_an_index_hides_no_matrix_in_a_member_of_a_conjunction(index, good):
    """1 + .. + n is not n M for a matrix M of one row and column, whatever the index is called."""
    says = ["=", ["sum", index, 1, n, M], ["*", n, at("M", 1)]]
    made = statement(["and", ["=", 1, 1], says], [["M", ["matrix", 1, 1]]])
    assert accepted("conjunction", made, {"parts": [["generic index", {"lemmas": []}]] * 2}) is good
    assert accepted("counterexample", made, {"instance": {"sizes": {"n": 2}, "values": {"M": [[5]]}}}) is not good


# ---------------------------------------------------------------------- poles
def test_what_has_poles_is_no_polynomial():
    """1/(z^n + 1), or one over a sum of powers of z, has no coefficients; z^-n has."""
    z_n = ["^", ["z"], n]
    for below, founded in ((z_n, True), (["*", ["z"], z_n], True), (["+", z_n, 1], False), (["-", ["z"], 2], False),
                           (["sum", "k", 0, n, ["^", ["z"], k]], False)):
        made = statement(["=", c, c], SCALAR, (), [["rec", "X", "t", 0, [1], ["/", at("X", t), below]]])
        assert (not ill_founded(made, [{"n": 1}])) is founded


# ---------------------------------------------------------------------- places
BEYOND = ["+", n, 1]


@pytest.mark.parametrize("read", [["entry", ["sym", "N"], BEYOND, 1], at("N", BEYOND, 1)])
def test_a_rule_says_nothing_of_places_that_a_matrix_has_not(read):
    """X = O for every t, and the formula for its entries is 1 below the last row: N = X[m] is not both there."""
    zero = ["mat", "i", "j", n, n, when("<=", i, n, 0, 1)]
    where = [["rec", "X", "t", 0, [zero], at("X", t)], ["let", "N", [], at("X", ["sym", "m"])]]
    below = {"index": "t", "says": ["=", ["entry", at("X", t), BEYOND, 1], 1], "uses": [{"lemma": 0, "at": {"t": t}}]}
    there = {"index": "s", "direct": True, "says": ["=", read, 1], "uses": [{"lemma": 0, "at": {"t": ["sym", "m"]}}]}
    rule = {"index": "t", "rule": True, "says": ["=", at("X", t), ["O", n, n]]}
    made = statement(["=", c, 0], SCALAR, (), where, ("n", "m"))
    assert not accepted("generic index", made, {"lemmas": [below, there, rule], "uses": [{"lemma": 1, "at": {"s": 0}, "times": ["neg", c]}]})
    inside = {**made, "says": ["forall", "k", 1, n, ["=", ["at", "N", k, k], 0]]}
    assert accepted("generic index", inside, {"lemmas": [below, there, rule]})


@pytest.mark.parametrize("read", [["entry", ["sym", "N"], 1, BEYOND], at("N", 1, BEYOND)])
def test_a_matrix_that_is_closed_in_one_lemma_has_no_more_places_there(read):
    """M I = M is read as a sum over the columns of M where M is opened, and as M where it is not: these differ beyond the last column."""
    where = [["let", "M", ["k"], ["mat", "i", "j", n, n, when("<=", j, n, 0, 1)]], ["let", "N", [], ["*", at("M", 0), ["I", n]]]]
    ones = {"index": "s", "direct": True, "says": ["=", ["entry", at("M", 0), 1, BEYOND], 1]}
    zero = {"index": "s", "direct": True, "says": ["=", read, 0]}
    both = [{"lemma": 0, "at": {"s": 0}, "times": ["neg", c]}, {"lemma": 1, "at": {"s": 0}, "times": c}]
    closed = {"index": "s", "direct": True, "closed": ["M"], "says": ["=", c, 0], "uses": both}
    made = statement(["=", c, 0], SCALAR, (), where)
    assert not accepted("generic index", made, {"lemmas": [ones, zero, closed], "uses": [{"lemma": 2, "at": {"s": 0}}]})
    same = {"index": "s", "direct": True, "closed": ["M"], "says": ["=", ["sym", "N"], at("M", 0)]}
    assert accepted("generic index", {**made, "says": ["=", ["sym", "N"], at("M", 0)]}, {"lemmas": [ones, zero, same]})


# ---------------------------------------------------------------------- places that there are for no size
def nothing_follows(lemma_says, over=(), where=()):
    """Whether a lemma about a place that a matrix has not, whatever n > 0 is, shows c n = 0 for n = 1."""
    made = statement(["forall", "k", n, 1, ["=", ["*", c, n], 0]], [*SCALAR, *over], [["h", [">=", n, 1], "standing"]], where)
    assert accepted("counterexample", made, {"instance": {"sizes": {"n": 1}, "values": {"c": 1, **{name: [[1]] for name, _ in over}}}})
    lemma = {"index": "s", "direct": True, "says": ["=", ["*", c, lemma_says], 0]}
    return not accepted("generic index", made, {"lemmas": [lemma], "uses": [{"lemma": 0, "at": {"s": 0}}]})


IDENTITY, ROWS, COLUMNS = ["I", n], ["mat", "i", "j", n, 2, when("<=", i, n, 0, 1)], ["mat", "i", "j", 2, n, when("<=", j, n, 0, 1)]
PART = ["mat", "i", "j", n, n, when("<=", i, n, when("=", i, j, 1, 0), 0)]


@pytest.mark.parametrize("term", [
    ["entry", ["*", COLUMNS, IDENTITY], 1, BEYOND], ["entry", ["*", IDENTITY, ROWS], BEYOND, 1], ["entry", ["T", ["*", COLUMNS, IDENTITY]], BEYOND, 1],
    ["entry", ["^", A, 0], BEYOND, 1], ["entry", ["*", ["^", PART, 2], ROWS], BEYOND, 1], ["entry", ["*", PART, A], BEYOND, 1],
])
def test_beyond_its_places_a_matrix_of_one_row_is_no_number(term):
    """For n = 1 the identity is a number, and M 1 is M beyond its columns too; for every n together M I is a sum of zeros there."""
    assert nothing_follows(term, [["A", ["matrix", n, n]]] if "A" in str(term) else [])


def test_a_place_for_every_size_is_used_at_a_size_of_one():
    """The same for an index of the lemma, which is one where it is used."""
    matrix = ["mat", "i", "j", 2, s, when("<=", j, s, 0, 1)]
    lemma = {"index": "s", "from": 1, "direct": True, "says": ["=", ["*", c, ["entry", ["*", matrix, ["I", s]], 1, ["+", s, 1]]], 0]}
    assert not accepted("generic index", statement(["=", c, 0], SCALAR), {"lemmas": [lemma], "uses": [{"lemma": 0, "at": {"s": 1}}]})


def test_a_column_has_one_column():
    """A value of a recursion of columns is remembered by its rows: what it is in a second column, which there is not, is not what it is in the first."""
    step = ["mat", "i", "j", BEYOND, 1, when("=", j, 1, ["entry", at("X", t), i, 1], 0)]
    second, first = (["entry", at("X", ["+", s, 1]), 1, column] for column in (2, 1))
    lemma = {"index": "s", "direct": True, "says": ["=", ["+", ["*", 0, second], first], 0]}
    made = statement(["forall", "t", 0, n, ["=", ["entry", at("X", ["+", t, 1]), 1, 1], 0]], [["w", ["matrix", BEYOND, 1]]], (),
                     [["rec", "X", "t", 0, [w], step]])
    assert accepted("counterexample", made, {"instance": {"sizes": {"n": 1}, "values": {"w": [[5], [1]]}}})
    assert not accepted("generic index", made, {"lemmas": [lemma], "uses": [{"lemma": 0, "at": {"s": t}}]})
    same = ["=", ["entry", at("X", ["+", t, 1]), 1, 1], ["entry", at("X", t), 1, 1]]
    assert accepted("generic index", {**made, "says": ["forall", "t", 0, n, same]}, {"lemmas": []})


# ---------------------------------------------------------------------- recursions that start before zero
@pytest.mark.parametrize("start, zero", [(-1, True), (0, False)])
def test_a_recursion_that_starts_before_zero_is_looked_at_from_there(start, zero):
    """X_(t+1) = X_t Y_(t+1) with Y = 0, 1, 1, .. is 1, 0, 0, .. from -1 on, and 1, 1, .. from 0 on: X_t is not divided by in the first case."""
    where = [["rec", "Y", "t", 0, [0], 1], ["rec", "X", "t", start, [1], ["*", at("X", t), at("Y", ["+", t, 1])]]]
    value = {"index": "t", "says": ["=", at("X", t), 0 if zero else 1], "uses": [{"lemma": 0, "at": {"t": t}}]}
    made = statement(["forall", "t", 0, n, ["=", c, 0]], SCALAR, (), where)
    divided = [{"lemma": 0, "at": {"t": t}, "times": ["/", c, at("X", t)]}]
    assert not accepted("generic index", made, {"lemmas": [value], "uses": divided})
    told = ["forall", "t", 0, n, ["=", ["/", c, at("X", t)], ["/", c, at("X", t)]]]
    assert accepted("generic index", {**made, "says": told}, {"lemmas": []}) is not zero


# ---------------------------------------------------------------------- names that stand for nothing
@pytest.mark.parametrize("body, second, hints, place", [
    (["+", ["sym", "p"], ["z"]], 0, {"whole": ["p"]}, {"z": 1}),
    (["+", ["sym", "q"], ["z"]], ["sym", "p"], {"whole": ["p", "q"]}, {"z": 1}),
    (["mat", "i", "j", n, n, ["+", ["entry", ["sym", "p"], i, j], 1]], 0, {"closed": ["p"]}, {"row": 1, "column": 1}),
    (["+", ["sym", "q"], ["z"]], ["z"], {"whole": ["p", "q"]}, {"z": 1}),
])
def test_a_definition_that_leads_back_to_itself_defines_nothing(body, second, hints, place):
    """p = p + z, kept as it is, would say z = 0; p = q + z with q = z says that the coefficient of z is two."""
    made = statement(["=", c, 0], SCALAR, [["h", [">=", n, 1], "standing"]], [["let", "p", [], body], ["let", "q", [], second]])
    said = [{"definition": "p", "at": [], "place": place, "times": ["neg", c]}]
    assert accepted("counterexample", made, {"instance": {"sizes": {"n": 1}, "values": {"c": 1}}})
    assert not accepted("generic index", made, {**hints, "lemmas": [], "uses": said})
    if second == ["z"]:
        told = [{"definition": name, "at": [], "place": place} for name in "pq"]
        assert accepted("generic index", {**made, "says": ["=", ["coeff", ["sym", "p"], 1], 2]}, {**hints, "lemmas": [], "uses": told})


# ---------------------------------------------------------------------- inverses that nothing says to exist
U, SINGULAR = ["sym", "u"], ["inv", ["mat", "i", "j", 2, 2, 0]]
COLUMN = [["u", ["matrix", 2, 1]]]
#: u = 0 where a matrix of zeros has an inverse, and what says so of u_1
NOWHERE = {"index": "s", "fact": "solve", "says": ["=", ["*", SINGULAR, U, 0], U]}
BY_NOWHERE = [{"lemma": 0, "at": {"s": 0, "row": 1, "column": 1}}]
NOTHING = ["*", 0, ["entry", SINGULAR, 1, 1]]


@pytest.mark.parametrize("extra, good", [(NOTHING, False), (0, True)])
def test_a_triangular_matrix_of_the_evidence_has_no_inverses(extra, good):
    """det diag(1, 1 + u_1) is not 1, though L is the identity plus zero times an inverse that does not exist."""
    by = ["mat", "i", "j", 2, 2, ["+", when("=", i, j, 1, 0), extra]]
    last = ["+", 1, at("u", 1)]
    matrix = ["mat", "i", "j", 2, 2, when("=", i, j, when("=", i, 2, last, 1), 0)]
    for factor, right in ((1, False), (when("=", k, 2, last, 1), True)):
        made = statement(["=", ["det", matrix], ["prod", "k", 1, 2, factor]], COLUMN)
        fact = {"index": "s", "fact": "det", "by": by, "says": made["says"], "uses": BY_NOWHERE}
        assert accepted("generic index", made, {"lemmas": [NOWHERE], "triangular": by, "uses": BY_NOWHERE}) is (good and right)
        assert accepted("generic index", made, {"lemmas": [NOWHERE, fact], "uses": [{"lemma": 1, "at": {"s": 0}}]}) is (good and right)
        assert accepted("counterexample", made, {"instance": {"sizes": {"n": 1}, "values": {"u": [[5], [1]]}}}) is not right


@pytest.mark.parametrize("in_values", [True, False])
@pytest.mark.parametrize("factor", [0, ["sum", "k", 1, n, ["*", at("w", k), ["^", ["z"], k]]]])
def test_an_inverse_is_met_in_every_coefficient(in_values, factor):
    """z (1 + u_1) + S (z + 0 V) is not z + S z, where V is an inverse that does not exist: not as functions, and then at the coefficient of z neither."""
    term = ["*", ["z"], ["+", 1, at("u", 1)]]
    left = ["+", ["*", factor, ["+", ["z"], NOTHING]], term] if factor else ["+", NOTHING, term]
    equal = {"index": "s", "direct": True, "in values": in_values, "says": ["=", left, ["+", ["*", factor, ["z"]], ["z"]]], "uses": BY_NOWHERE}
    made = statement(["forall", "k", n, 0, ["=", ["coeff", term, 1], 1]], [*COLUMN, ["w", ["signal", 0]]])
    assert accepted("counterexample", made, {"instance": {"sizes": {"n": 0}, "values": {"u": [[5], [1]], "w": [0]}}})
    assert not accepted("generic index", made, {"lemmas": [NOWHERE, equal], "uses": [{"lemma": 1, "at": {"s": 0, "z": 1}}]})
