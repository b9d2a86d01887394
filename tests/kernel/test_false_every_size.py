# SPDX-License-Identifier: MIT
"""False statements for every size, with evidence made by hand: the checker rejects each, and accepts the true neighbour."""

from __future__ import annotations

import pytest

from tests.kernel.test_false_claims import accepted, statement

n, t, k, a, c, g, w = (["sym", name] for name in ("n", "t", "k", "a", "c", "g", "w"))
A, P = ["sym", "A"], ["sym", "P"]
NOTHING = {"sum": [], "terms": []}
COLUMN = [["w", ["matrix", n, 1]]]
ZERO = ["col", "i", n, 0]
PLACE = {"s": 0, "row": ["sym", "row"], "column": ["sym", "column"]}


def at(name, *indices):
    return ["at", name, *indices]


# ---------------------------------------------------------------------- facts about matrices
def test_factors_of_a_rank_fit():
    """I = (1) I has a first factor of one column; the rank of I is no less for that."""
    factors = [["I", 1], ["I", n], ["I", 1], ["I", n]]
    assert not accepted("order", statement(["=", ["rank", ["I", n]], 1], []), {"parts": [{"sum": factors, "blocks": [[]] * 3}]})
    assert accepted("order", statement(["=", ["rank", ["I", n]], n], []), {"parts": [{"sum": [["I", n]] * 4, "blocks": [[]] * 3}]})


def test_factors_of_a_bound_of_a_rank_fit():
    """I = (1) I again; I = I I bounds the rank of I by n; and of three factors none is counted."""
    def bounded(rank, *factors):
        return accepted("order", statement(["<=", ["rank", ["I", n]], rank], []), {"parts": [{"sum": list(factors), "blocks": [[]]}]})

    assert bounded(n, ["I", n], ["I", n])
    assert not bounded(1, ["I", 1], ["I", n]) and not bounded(1, ["I", n], ["I", 1]) and not bounded(1, ["I", n], ["I", n]) and not bounded(1, 1, ["I", n])
    assert not bounded(n, ["I", n]) and not bounded(n, ["I", n], ["I", n], ["I", n]) and not bounded(n, ["I", n], ["neg", ["I", n]])
    assert not accepted("order", statement(["<=", n, ["rank", ["I", n]]], []), {"parts": [{"sum": [["I", n], ["I", n]], "blocks": [[]]}]})


def test_a_lemma_by_contradiction_has_a_value():
    """1/a != 0 where it has a value, which does not make a != 0."""
    over, given = [["a", ["scalar"]], ["b", ["scalar"]]], [["h", ["!=", ["sym", "b"], 0], "standing"]]
    absurd = [["1", [], "assumed 1/0/0/0", [], [["a", 1], ["b", 1]]]]
    proof = {"lemmas": [["!=", ["/", 1, a], 0]],
             "parts": [{"sum": [], "terms": absurd}, {"sum": [], "terms": [["1", [], "assumed 2/0/0/0", [], [["a", -2]]]]}]}
    made = statement(["!=", a, 0], over, given, sizes=[])
    assert not accepted("order", made, proof)
    assert not accepted("order", made, {**proof, "lemmas": [], "inside": [[0, "", proof["lemmas"]]]})
    assert accepted("order", {**made, "says": ["!=", ["/", 1, a], 0]}, {"parts": proof["parts"][:1]})


@pytest.mark.parametrize("where", ["lemmas", "inside"])
def test_a_lemma_is_shown_as_it_is_used(where):
    """A second argument of psd would be in what is used and not in what is shown."""
    lemma = ["psd", P, A]
    evidence = {"lemmas": [lemma]} if where == "lemmas" else {"inside": [[0, "", [lemma]]]}
    label = "lemma 0" if where == "lemmas" else "inner lemma 0"
    made = statement(["symmetric", A], [["P", ["psd", n]], ["A", ["matrix", n, n]]])
    parts = [{"sum": [P], "terms": []}, {"sum": [], "terms": [["-1", [], f"{label}/0/0/0", []]]}]
    assert not accepted("order", made, {**evidence, "parts": parts})


# ---------------------------------------------------------------------- sums and indices
@pytest.mark.parametrize("op", ["sum", "prod"])
def test_a_range_of_one_index_or_none(op):
    """For t = 0 and 1 a sum from 0 to t - 1 is not its term at 0 both times."""
    says = ["=", [op, "k", 0, ["-", t, 1], at("g", k)], at("g", 0)]
    made = statement(["forall", "t", 0, 1, says], [["g", ["signal", 0]]], sizes=[])
    assert not accepted("generic index", made, {"lemmas": []})
    assert accepted("generic index", {**made, "says": ["forall", "t", 1, 1, says]}, {"lemmas": []})


def test_an_index_without_a_name_is_refused():
    """Forms have '' for their constant: a lemma for all '' would be shown at 1 alone, or without a step."""
    where = [["rec", "x", "k", 0, [0], 1]]
    made = statement(["forall", "t", 0, n, ["=", at("x", t), 0]], where=where, over=[])
    says = ["forall", "", 0, ["+", n, 1], ["=", at("x", ["-", ["sym", ""], 1]), 0]]
    lemma = {"index": "s", "direct": True, "says": says}
    assert not accepted("generic index", made, {"lemmas": [lemma], "uses": [{"lemma": 0, "at": {"s": 0, "": ["+", t, 1]}}]})
    shown = {"says": ["forall", "", 0, n, ["=", at("x", ["sym", ""]), 0]], "proofs": [{"parts": [NOTHING] * 2}]}
    step = {"sum": [], "terms": [["1", [], "shown 0 at t+1/0/0/0", []]]}
    assert not accepted("word induction", made, {"before": [shown], "conjuncts": [[{"parts": [NOTHING]}, {"parts": [step]}]]})


def test_a_coefficient_at_infinity_at_an_index_without_a_name():
    """1/(z - 1) is 1/z + 1/z^2 + ..; the equations at k = 1 alone do not tell the coefficients after that."""
    def lemma(name):
        value = ["if", ["=", ["sym", name], 0], 0, ["if", ["=", ["sym", name], 1], 1, 7]]
        says = ["forall", name, 0, n, ["=", ["laurent", ["/", 1, ["-", ["z"], 1]], ["sym", name]], value]]
        return {"index": "s", "fact": "laurent", "by": 1, "says": says}

    made = statement(["forall", "t", 2, n, ["=", ["laurent", ["/", 1, ["-", ["z"], 1]], t], 7]], [])
    for name in ("", "k", "z"):
        assert not accepted("generic index", made, {"lemmas": [lemma(name)], "uses": [{"lemma": 0, "at": {"s": 0, name: t}}]})


def test_a_bound_that_needs_cases_is_a_reason_to_reject():
    """No case of a size is looked at by itself, and none goes unnoticed."""
    made = statement(["forall", "t", 0, ["abs", ["-", n, 2]], ["=", c, c]], [["c", ["scalar"]]])
    assert not accepted("generic index", made, {"lemmas": []})


# ---------------------------------------------------------------------- determinants and inverses of generic size
def test_a_triangular_factor_has_the_size_of_the_matrix():
    """L = I of size n shows nothing about a number where n = 0."""
    number = ["mat", "i", "j", 1, 1, ["if", [">=", n, 1], 1, 5]]
    made = statement(["=", ["det", number], ["prod", "k", 1, 1, 1]], [])
    assert not accepted("generic index", made, {"lemmas": [], "triangular": ["I", n]})
    assert accepted("generic index", {**made, "says": ["=", ["det", ["I", n]], ["prod", "k", 1, n, 1]]}, {"lemmas": [], "triangular": ["I", n]})


@pytest.mark.parametrize("right", [["+", 1, 0], ["mat", "i", "j", 1, 1, 1]])
def test_an_inverse_times_a_number_is_no_column(right):
    """One column of Mx = v says nothing about the others of inv(M) times a number."""
    left = ["*", ["inv", ["I", n]], right]
    says = ["=", left, ["mat", "i", "j", n, n, 1]]
    lemma = {"index": "s", "fact": "solve", "says": says}
    assert not accepted("generic index", statement(says, []), {"lemmas": [lemma], "uses": [{"lemma": 0, "at": PLACE}]})


SINGULAR = ["inv", ["mat", "i", "j", n, n, 0]]
CANCELLED = {"index": "s", "fact": "solve", "says": ["=", ["*", SINGULAR, w, 0], w]}  # 0 w = 0, so inv(0) 0 = w


def test_an_inverse_that_cancels_need_not_exist():
    """inv(0) w 0 = w holds where inv(0) exists, that is nowhere; w = 0 does not follow."""
    assert not accepted("generic index", statement(["=", w, ZERO], COLUMN), {"lemmas": [CANCELLED], "uses": [{"lemma": 0, "at": PLACE}]})


NUMBER = ["entry", ["*", SINGULAR, w, 0], 1]  # zero where inv(0) exists
SOME = [["n >= 1", [">=", n, 1], "standing"]]
FIRST = [{"lemma": 0, "at": {"s": 0, "row": 1, "column": 1}}]
FACTORS = ["prod", "k", 1, n, ["+", 1, at("w", k)]]


@pytest.mark.parametrize("where, left, right, how, says", [
    ([["let", "Y", [], ["mat", "i", "j", n, n, NUMBER]]], ["det", ["+", ["I", n], ["sym", "Y"]]], (["prod", "k", 1, n, 1], FACTORS),
     {"fact": "det", "by": ["I", n]}, ["=", FACTORS, 1]),
    ([["rec", "x", "k", 0, [0], NUMBER]], at("x", ["+", ["sym", "s"], 1]), (0, at("w", 1)), {"direct": True}, ["=", at("w", 1), 0]),
])
def test_an_inverse_behind_a_name_need_not_exist(where, left, right, how, says):
    """What is shown where an inverse behind a name exists, w = 0 among it, is not used where it does not, nor when it is read again."""
    place = {"s": 0, "row": ["sym", "row"] if "fact" in how else 1, "column": 1}
    uses = [], [{"lemma": 0, "at": place}]
    lemmas = [CANCELLED, *({"index": "s", "says": ["=", left, x], "uses": used, **how} for x, used in zip(right, uses, strict=True))]
    made = statement(says, COLUMN, SOME, where)
    assert not accepted("generic index", made, {"lemmas": lemmas, "uses": [{"lemma": m, "at": {"s": n}} for m in (1, 2, 1, 2)]})
    assert accepted("generic index", {**made, "says": ["=", c, c], "over": [*COLUMN, ["c", ["scalar"]]]}, {"lemmas": lemmas})


def test_a_rule_brings_no_inverse_in():
    """x = inv(0) w 0 as a rule would make the inverse one of every goal with x."""
    made = statement(["always", "t", ["=", at("x", t), at("w", 1)]], COLUMN, SOME, [["rec", "x", "k", 0, [0], 0]])
    rule = {"index": "s", "rule": True, "says": ["=", at("x", ["sym", "s"]), NUMBER]}
    assert not accepted("generic index", made, {"lemmas": [CANCELLED, rule], "uses": FIRST})


# ---------------------------------------------------------------------- earlier conjuncts
D, X = ["sym", "d"], ["sym", "x"]
LEFT = [["1", [], "inverse 1/left/0/0", []]]


@pytest.mark.parametrize("until, then, true", [
    (n, ["forall", "t", 0, n], True), (["-", n, 1], ["forall", "t", 0, n], False), (n, ["forall", "t", 0, ["+", n, 1]], False),
    (0, ["forall", "t", 0, n], False), (n, ["always", "t"], False),
])
def test_an_earlier_conjunct_is_known_in_its_range(until, then, true):
    """inv(A_k) A_k = I for k up to a bound grants the inverses up to there, also where the range is empty."""
    first = ["forall", "k", 0, until, ["=", ["*", ["inv", at("A", k)], at("A", k)], ["I", D]]]
    second = ["=>", ["=", ["*", at("A", t), X], 0], ["=", X, 0]]
    made = statement(["and", first, [*then, second]], [["A", ["signal_of", 0, ["matrix", D, D]]], ["x", ["matrix", D, 1]]], sizes=["d", "n"])

    def cancel(index, premise, inverse):
        terms = [["-1", [], f"inverse {inverse}/left/0/0", ["x"]], ["1", [f"inv(A[{index}])"], f"assumed {premise}/0/0/0", []]]
        return {"parts": [{"sum": [], "terms": terms}]}

    shown = [{"parts": [{"sum": [], "terms": LEFT}]}] * 2
    proofs = [[cancel("0", i, 1), cancel("t+1", j, m)] for i in range(4) for j in range(4) for m in (1, 2)]
    assert any(accepted("word induction", made, {"conjuncts": [shown, proof]}) for proof in proofs) == true


# ---------------------------------------------------------------------- names
C, Q = ["sym", "C"], ["sym", "Q"]
MATRICES = [["B", ["matrix", D, D]], ["C", ["matrix", D, D]], ["P", ["psd", D]]]


@pytest.mark.parametrize("body, kind", [(["sum", "k", 1, 1, ["sym", "B"]], "needed"), (["if", ["=", 1, 1], ["sym", "B"], P], "standing")])
def test_a_definition_that_cannot_be_read_keeps_its_name(body, kind):
    """A hypothesis Q = C about what the statement calls Q says nothing about a root that a proof would call Q."""
    made = statement(["always", "t", ["=", P, ["*", C, C]]], MATRICES, [["h", ["=", Q, C], kind]], [["let", "Q", [], body]], ["d"])
    terms = [["-1", [], "root Q", []], ["1", ["Q"], "h/0/0/0", []], ["1", [], "h/0/0/0", ["C"]]]
    proof = {"parts": [{"sum": [], "roots": [["Q", P]], "terms": terms}]}
    assert not accepted("word induction", made, {"conjuncts": [[proof, proof]]})
    told = {**made, "where": [], "over": [*MATRICES, ["Q", ["symmetric", D]]], "given": [*made["given"], ["r", ["=", ["*", Q, Q], P], "standing"]]}
    proof = {"parts": [{"sum": [], "terms": [["-1", [], "r/0/0/0", []], *terms[1:]]}]}
    assert accepted("word induction", told, {"conjuncts": [[proof, proof]]})


def test_the_size_of_a_parameter_is_its_own():
    """f(X) = det(c I) with as many rows as its X is not that of the variable X."""
    over = [["A", ["matrix", n, n]], ["X", ["matrix", D, D]], ["c", ["scalar"]]]
    where = [["let", "f", ["X"], ["det", ["*", c, ["I", ["nrows", ["sym", "X"]]]]]]]
    for kind, evidence in (("order", {"parts": [NOTHING]}), ("membership", {"terms": [[]]})):
        assert not accepted(kind, statement(["=", at("f", A), ["^", c, D]], over, (), where, ["d", "n"]), evidence)
        assert accepted(kind, statement(["=", where[0][3], ["^", c, D]], over, (), (), ["d", "n"]), evidence)


def test_the_values_of_a_recursion_have_one_shape():
    """A column to which every step adds an entry is not the column it starts with."""
    start, place = ["col", "i", n, 5], {"t": t, "row": ["sym", "row"], "column": ["sym", "column"]}
    uses = [{"lemma": 0, "at": place}]
    says = ["=", at("x", t), start]
    for step, true in ((["block", [at("x", t)], [["col", "i", 1, 0]]], False), (["+", at("x", t), ["O", n, 1]], True)):
        made = statement(["always", "t", says], [], (), [["rec", "x", "t", 0, [start], step]])
        assert accepted("generic index", made, {"lemmas": [{"index": "t", "says": says, "uses": uses}], "uses": uses}) == true


# ---------------------------------------------------------------------- traces
M, N, S, v = (["sym", name] for name in ("M", "N", "S", "v"))
TRACED = [["M", ["matrix", n, k]], ["N", ["matrix", k, n]], ["A", ["matrix", n, n]], ["S", ["symmetric", n]], ["P", ["psd", n]], ["v", ["matrix", n, 1]]]


def tr(*factors):
    return ["tr", factors[0] if len(factors) == 1 else ["*", *factors]]


@pytest.mark.parametrize("left, right, true", [
    (tr(M, N), tr(N, M), True), (tr(M, N), tr(["T", M], ["T", N]), True), (tr(A, M, N), tr(N, A, M), True), (tr(A, S, P), tr(["T", A], P, S), True),
    (tr(A, S, P), tr(A, P, S), False), (tr(A, A), tr(A, ["T", A]), False), (tr(A, S, P), ["*", tr(A), tr(S, P)], False),
    (tr(v, ["T", v], A), tr(["T", v], A, v), True), (tr(v, ["T", v], A), tr(["T", v], ["+", A, ["I", n]], v), False),
    (tr(["I", ["+", n, 2]]), ["+", n, 2], True), (tr(["I", n]), 1, False), (tr(["I", n]), k, False), (tr(["*", n, ["I", n]]), ["^", n, 2], True),
    (tr(["block", [A, M], [N, ["*", N, M]]]), ["+", tr(A), tr(M, N)], True), (tr(["block", [A, M], [N, ["*", N, M]]]), ["+", tr(A), tr(M, ["T", M])], False),
])
def test_the_trace_of_a_product(left, right, true):
    """Factors may be moved around the circle, and all turned; no more than that."""
    assert accepted("membership", statement(["=", left, right], TRACED, sizes=["n", "k"]), {"terms": [[]]}) == true


def test_the_trace_of_what_is_not_square():
    """[M, N'] has no trace, and a matrix whose blocks are cut differently in rows and columns is not read."""
    over = [["X", ["matrix", n, k]], ["Y", ["matrix", n, n]], ["Z", ["matrix", k, k]], ["W", ["matrix", k, n]]]
    cut = ["block", [["sym", "X"], ["sym", "Y"]], [["sym", "Z"], ["sym", "W"]]]
    for term in (M, cut):
        assert not accepted("membership", statement(["=", ["tr", term], ["tr", term]], [*TRACED, *over], sizes=["n", "k"]), {"terms": [[]]})


@pytest.mark.parametrize("bound, term, true", [
    (P, P, True), (["+", P, ["I", n]], ["+", P, ["I", n]], True), (S, S, False), (["T", A], A, False), (P, ["I", n], False), (["neg", P], ["neg", P], False)])
def test_semidefinite_matrices_are_below_their_traces(bound, term, true):
    """trace(X) I - X is semidefinite for a semidefinite X, and for that X alone."""
    below = ["-", ["*", ["tr", bound], ["I", n]], term]
    made = statement(["psd", below], TRACED, sizes=["n", "k"])
    assert accepted("order", made, {"parts": [{"sum": [below], "terms": []}]}) == true
    strict = statement(["pd", below], TRACED, sizes=["n", "k"])
    assert not accepted("order", strict, {"parts": [{"sum": [below], "terms": []}]})


@pytest.mark.parametrize("term, op, true", [
    (P, ">=", True), (S, ">=", False), (["neg", P], ">=", False),
    (["+", P, ["I", n]], ">", False), (["*", A, P], ">=", False), (["*", A, P, ["T", A]], ">=", True)])
def test_the_sign_of_a_trace(term, op, true):
    """The trace of a definite matrix without rows is zero."""
    made = statement([op, ["tr", term], 0], TRACED, sizes=["n", "k"])
    assert accepted("order", made, {"parts": [{"sum": [["*", ["tr", term], ["I", 1]]], "terms": []}]}) == true
    assert not accepted("order", made, {"parts": [{"sum": [], "terms": []}]})


@pytest.mark.parametrize("says, true", [(["=", ["^", A, 0], ["I", n]], True), (["=", ["^", A, 0], A], False), (["=", ["^", M, 0], ["^", M, 0]], False),
                                        (["=", ["^", ["tr", A], 0], 1], True)])
def test_the_power_zero(says, true):
    """It is the identity, of a square matrix."""
    assert accepted("membership", statement(says, TRACED, sizes=["n", "k"]), {"terms": [[]]}) == true


@pytest.mark.parametrize("term, value, true", [
    (["*", ["T", v], A, v], ["*", ["T", v], A, v], True), (["*", ["T", v], A, v], ["*", ["T", v], ["T", A], v], True),
    (["*", ["T", v], A, v], ["*", ["T", v], v], False), (["*", 2, ["*", ["T", v], v]], ["*", ["T", v], v], False)])
def test_the_determinant_of_a_number(term, value, true):
    """That of a matrix with one row is its entry."""
    assert accepted("membership", statement(["=", ["det", term], ["tr", value]], TRACED, sizes=["n", "k"]), {"terms": [[]]}) == true
