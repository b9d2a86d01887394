# SPDX-License-Identifier: MIT
"""False statements with evidence made by hand: the checker rejects each, and accepts the true neighbour."""

from __future__ import annotations

import pytest

from exactkf.kernel.replay import replay, seal
from tests.kernel.acceptance import is_accepted

A, B, C, x, y = (["sym", name] for name in "ABCxy")
SQUARE = [[name, ["matrix", ["sym", "n"], ["sym", "n"]]] for name in "ABC"]
CANCEL = [["g", ["=", ["*", A, B], ["*", A, C]], "standing"]]


def statement(says, over=SQUARE, given=(), where=(), sizes=("n",)):
    return {"sizes": list(sizes), "over": list(over), "where": list(where), "given": list(given), "says": says}


def accepted(kind, made, evidence):
    return is_accepted(seal("X", kind, made, evidence))


def equation(*terms):
    return {"sum": [], "terms": list(terms)}


BY_INVERSE = [["1", ["inv(A)"], "g/0/0/0", []], ["-1", [], "inverse 1/left/0/0", ["B"]], ["1", [], "inverse 1/left/0/0", ["C"]]]
EXISTS = ["=", ["*", ["inv", A], A], ["I", ["sym", "n"]]]


# ---------------------------------------------------------------------- names and types
def test_a_variable_named_like_a_transpose_is_refused():
    """A name of a statement is an identifier, so that it cannot be that of a letter which the reader makes."""
    over = [["A", SQUARE[0][1]], ["A'", SQUARE[0][1]]]
    assert not accepted("membership", statement(["=", ["T", A], ["sym", "A'"]], over), {"terms": [[]]})
    assert accepted("membership", statement(["=", ["T", A], ["T", A]], over[:1]), {"terms": [[]]})


def test_a_variable_with_the_name_of_a_size_is_refused():
    """A variable that hides a size would be the size in a proof and itself on an instance."""
    made = statement(["=", ["sym", "n"], 2], [["n", ["scalar"]]])
    assert not accepted("identity", made, {"cases": [{"n": 2}]})


@pytest.mark.parametrize("sizes, over, case", [(["horizon"], [], {"horizon": 1}), ([], [["horizon", ["integer", 1, 1]]], {})])
def test_no_name_cuts_always_short(sizes, over, case):
    """No size and no variable is called horizon, the place of the last t of an instance."""
    made = statement(["always", "t", ["=", ["*", ["sym", "t"], ["-", ["sym", "t"], 1]], 0]], over, sizes=sizes)
    assert not accepted("identity", made, {"cases": [case]})


def test_no_parameter_cuts_always_short():
    """Nor is a parameter of the evidence."""
    made = statement(["always", "t", ["=", ["*", ["sym", "t"], ["-", ["sym", "t"], 1]], 0]], [], sizes=[])
    assert not accepted("identity", made, {"cases": [{}], "parameters": [["horizon", ["integer", 1, 1]]]})


def test_a_type_that_does_not_exist_is_refused():
    """A variable of an unknown type is not taken for a symmetric matrix."""
    says = ["=", A, ["T", A]]
    assert not accepted("identity", statement(says, [["A", ["square", 2]]], sizes=[]), {"cases": [{}]})
    assert accepted("identity", statement(says, [["A", ["symmetric", 2]]], sizes=[]), {"cases": [{}]})


# ---------------------------------------------------------------------- instances
def test_a_horizon_before_zero_shows_nothing():
    """An instance looks at t = 0 at least."""
    made = statement(["always", "t", ["=", 0, 1]], [], sizes=[])
    assert not accepted("instances", made, {"instances": [{"sizes": {"horizon": -1}, "values": {}}]})


GROWS = ["rec", "X", "t", 0, [0], ["+", ["at", "X", ["sym", "t"]], 1]]
SMALL = ["always", "t", ["<=", ["at", "X", ["sym", "t"]], 7]]
NOWHERE = {"sizes": {}, "values": {}}


def test_always_by_another_name_is_assumed_all_the_same():
    """A hypothesis that holds up to the horizon only, behind a definition, is no reason for a counterexample."""
    made = statement(["=", 0, 1], [], [["h", ["sym", "H"], "standing"]], [GROWS, ["let", "H", [], SMALL]], [])
    assert not accepted("counterexample", made, {"instance": NOWHERE})
    assert accepted("counterexample", statement(["=", 0, 1], [], (), [GROWS], []), {"instance": NOWHERE})


def test_always_in_a_condition_is_assumed_all_the_same():
    """Nor is one in the condition of a term by cases."""
    made = statement(["=", ["if", SMALL, 1, 0], 0], [], (), [GROWS], [])
    assert not accepted("counterexample", made, {"instance": NOWHERE})


def test_a_deep_definition_is_defined():
    """That a definition is deeper than the checker goes does not make it undefined."""
    below = ["if", ["=", ["sym", "k"], 0], 0, ["at", "f", ["-", ["sym", "k"], 1]]]
    made = statement(["defined", ["at", "f", 300]], [], (), [["let", "f", ["k"], below]], [])
    assert not accepted("counterexample", made, {"instance": NOWHERE})
    assert not accepted("instances", {**made, "says": ["not", made["says"]]}, {"instances": [NOWHERE]})
    assert accepted("instances", {**made, "says": ["defined", ["at", "f", 30]]}, {"instances": [NOWHERE]})


def test_a_part_of_a_conjunction_needs_no_inverse_of_a_later_one():
    """Where the first part is false the second need not have a value, so that its inverses show nothing about the first."""
    made = statement(["and", ["=", B, C], EXISTS], given=CANCEL)
    cancel, exists = [*BY_INVERSE], [["1", [], "inverse 1/left/0/0", []]]
    assert not accepted("order", made, {"parts": [equation(*cancel), equation(*exists)]})
    assert not accepted("membership", made, {"terms": [cancel, exists]})
    zero, one = [["0"]], [["1"]]
    assert accepted("counterexample", made, {"instance": {"sizes": {"n": 1}, "values": {"A": zero, "B": zero, "C": one}}})
    turned = {**made, "says": ["and", EXISTS, ["=", B, C]]}
    assert accepted("order", turned, {"parts": [equation(*exists), equation(*cancel)]})
    assert accepted("membership", turned, {"terms": [exists, cancel]})


# ---------------------------------------------------------------------- inverses that need not exist
def test_an_inverse_in_a_block_needs_a_reason():
    """Every entry of a block matrix is looked at, the first of a row too."""
    made = statement(["invertible", A], SQUARE[:1])
    for inverse in (["inv", A], ["block", [["inv", A]]]):
        evidence = {"parts": [{"sum": [inverse], "terms": [["1", [], "inverse 1/right/0/0", []]]}]}
        assert not accepted("order", made, evidence)
        assert accepted("order", {**made, "over": [["A", ["nonsingular", ["sym", "n"]]]]}, evidence)


@pytest.mark.parametrize("beside", [
    ["=", ["if", ["=", 1, 1], 0, ["inv", A]], 0],
    ["forall", "k", 1, 0, EXISTS],
    ["not", ["exists", "k", 1, 0, EXISTS]],
    ["=", ["sum", "k", 1, 0, ["inv", A]], 0],
    ["=", ["prod", "k", 1, 0, ["inv", A]], 1],
    ["not", ["defined", ["inv", A]]],
    ["or", ["=", 0, 0], EXISTS],
    ["=>", ["=", 0, 1], EXISTS],
])
def test_an_inverse_that_is_not_evaluated_need_not_exist(beside):
    """A hypothesis has a value without the inverses behind conditions and in empty ranges."""
    made = statement(["=", B, C], given=[*CANCEL, ["h", beside, "standing"]])
    assert not accepted("order", made, {"parts": [equation(*BY_INVERSE)]})
    assert not accepted("order", made, {"parts": [equation(*BY_INVERSE)] * 2})
    zero, one = [["0"]], [["1"]]
    assert accepted("counterexample", made, {"instance": {"sizes": {"n": 1}, "values": {"A": zero, "B": zero, "C": one}}})
    told = statement(["=", B, C], given=[*CANCEL, ["h", EXISTS, "standing"]])
    assert accepted("order", told, {"parts": [equation(*BY_INVERSE)]})


# ---------------------------------------------------------------------- facts
def test_a_number_is_similar_to_no_matrix():
    """AT = TB shows similarity of matrices of the size of T only."""
    n = ["sym", "n"]
    proof = {"parts": [{"sum": [["I", n]], "terms": []}]}
    for number in (2, ["*", 2, ["I", 1]]):
        for op in ("similar", "cospectral"):
            assert not accepted("order", statement([op, number, ["*", 2, ["I", n]]], []), proof)
    assert accepted("order", statement(["similar", ["*", 2, ["I", n]], ["*", 2, ["I", n]]], []), proof)


def test_a_zero_that_is_not_square_is_not_semidefinite():
    """Rectangular zeros on a diagonal move what stands between them off it."""
    P = ["sym", "P"]
    shifted = ["block", [["O", 1, 2], 0, 0], [0, P, 0], [0, 0, ["O", 2, 1]]]
    made = statement(["psd", shifted], [["P", ["psd", ["sym", "n"]]]])
    assert not accepted("order", made, {"parts": [{"sum": [shifted], "blocks": [[]] * 9}]})
    within = ["psd", ["-", ["O", ["+", ["sym", "n"], 3], ["+", ["sym", "n"], 3]], ["-", 0, 1]]]
    assert not accepted("order", {**made, "says": within}, {"parts": [{"sum": [shifted], "blocks": [[]] * 9}]})


def test_an_exponent_is_an_integer():
    """With a float for an exponent x y = z would give y = z: 1e300 + 1 = 1e300."""
    over = [["x", ["nonzero"]], ["y", ["scalar"]], ["z", ["scalar"]]]
    z = ["sym", "z"]
    made = statement(["=", y, z], over, [["h", ["=", ["*", x, y], z], "standing"]], sizes=[])
    big = [[1, [["x", 1e300], ["y", 1]]], [-1, [["x", 1e300], ["z", 1]]]]
    step = {"numbers": big, "terms": [[1, [], "h/0/0/0", [], [["x", 1e300]]]]}
    assert not accepted("membership", made, {"terms": [[[1, [], step, [], [["x", -1e300]]]]]})


# ---------------------------------------------------------------------- multipliers
def test_a_multiplier_divides_by_nothing_new():
    """x y = 0 gives x = 0 by the multiplier 1/y, which y = 0 forbids."""
    over = [["x", ["scalar"]], ["y", ["scalar"]]]
    given = [["h", ["=", ["*", x, y], 0], "standing"]]
    proof = {"cases": [{}], "terms": [[[["/", 1, y], "h", 1]]]}
    assert not accepted("combination", statement(["=", x, 0], over, given, sizes=[]), proof)
    assert accepted("combination", statement(["=", x, 0], over, [*given, ["g", ["!=", y, 0], "needed"]], sizes=[]), proof)
    assert accepted("combination", statement(["=", x, 0], [over[0], ["y", ["positive"]]], given, sizes=[]), proof)
    assert accepted("combination", statement(["=", ["/", x, y], 0], over, given, sizes=[]),
                    {"cases": [{}], "terms": [[[["/", 1, ["^", y, 2]], "h", 1]]]})


def test_a_square_divides_by_nothing_new():
    """x y^2 >= 0 gives x >= 0 by the square of 1/y, which y = 0 forbids."""
    over = [["x", ["scalar"]], ["y", ["scalar"]]]
    given = [["h", [">=", ["*", x, y, y], 0], "standing"]]
    assert not accepted("positivity", statement([">=", x, 0], over, given, sizes=[]), {"cases": [{}], "terms": [[1, ["/", 1, y], ["h"]]]})


def test_proofs_with_symbols_reach_a_case():
    """An empty range of an integer leaves nothing to add up."""
    over = [["k", ["integer", 1, 0]], ["x", ["scalar"]]]
    for kind, says in (("combination", ["=", x, 0]), ("positivity", [">=", x, 0]), ("identity", ["=", x, 0])):
        assert not accepted(kind, statement(says, over, sizes=[]), {"cases": [{}], "terms": [[]]})


def test_what_is_shown_along_divides_by_nothing_new():
    """X = X_0 is shown along with X = X, and where X_0 = 0 makes that a division by zero nothing is shown."""
    over = [["x", ["scalar"]]]
    keeps = ["rec", "X", "t", 0, [x], ["at", "X", ["sym", "t"]]]
    at = ["at", "X", ["sym", "t"]]
    made = statement(["always", "t", ["=", at, x]], over, (), [keeps], [])
    along = ["=", ["/", at, x], 1]
    assert accepted("induction", made, {"cases": [{}], "solve": [0]})
    assert not accepted("induction", made, {"cases": [{}], "solve": [0], "also": [along]})
    assert accepted("induction", {**made, "over": [["x", ["nonzero"]]]}, {"cases": [{}], "solve": [0], "also": [along]})


# ---------------------------------------------------------------------- what is no statement
@pytest.mark.parametrize("says", [
    ["=", 1], ["="], ["and"], True, 1.5, ["=>", ["=", 0, 0], ["=", 0, 0], ["=", 0, 1]], ["not", ["=", 0, 1], ["=", 0, 0]],
    ["=", ["rat", 0, 1], ["rat", 0, -1]], ["=", ["sym", "free"], ["sym", "free"]], ["forall", 3, 0, 0, ["=", 0, 0]], ["nothing", 0],
    ["prints", ["rat", 4, 5], "1/3"], ["prints", ["rat", 4, 5], "8e-1"], ["prints", ["rat", 4, 5], [["0.8", " 0.8"]]],
])
def test_a_statement_is_made_of_operations_with_their_arguments(says):
    """What has too few or too many arguments, or a number that is none, is read in more than one way or in none."""
    assert not accepted("evaluation", statement(says, [], sizes=[]), {"cases": [{}]})


@pytest.mark.parametrize("says", [["=", ["-", A, A, B], ["O", ["sym", "n"], ["sym", "n"]]], ["=", ["T", A, B], ["T", A]]])
def test_no_argument_is_left_out_of_account(says):
    """A third term of a difference is not dropped where words are read."""
    assert not accepted("membership", statement(says), {"terms": [[]]})


def test_a_type_has_its_arguments():
    """symmetric(n, 1) is no type."""
    made = [statement(["=", ["T", A], A], [["A", kind]]) for kind in (["symmetric", ["sym", "n"], 1], ["symmetric", ["sym", "n"]])]
    assert [accepted("membership", s, {"terms": [[]]}) for s in made] == [False, True]


def test_a_parameter_hides_no_size():
    """In det(2 f(3)) with f(n) = I_n the n of f is 3, not the size."""
    n = ["sym", "n"]
    for parameter, good in (("n", False), ("k", False)):
        made = statement(["=", ["det", ["*", 2, ["I", n]]], ["det", ["*", 2, ["at", "f", 3]]]], [], (), [["let", "f", [parameter], ["I", ["sym", parameter]]]])
        assert accepted("membership", made, {"terms": [[]]}) is good


def test_tables_are_those_of_the_language():
    """The checker has its own list of operations and types, and it is the one that statements are written with."""
    from exactkf.kernel.wellformed import ARGUMENTS, BINDERS, TYPES
    from exactkf.language import statement as written
    from exactkf.language.tree import OPERATIONS

    assert {op: (least, most or max(least, 1 << 30)) if most is None else (least, most) for op, (least, most) in OPERATIONS.items()} == ARGUMENTS
    assert (written.TYPES, written._BINDERS) == (TYPES, BINDERS)


def test_a_lemma_is_used_as_it_was_shown():
    """psd(I, B) would be shown for I, and used for I - B."""
    made = statement(["symmetric", B], SQUARE[1:2])
    shown, used = {"sum": [["I", ["sym", "n"]]], "terms": []}, equation(["-1", [], "lemma 0/0/0/0", []])
    assert not accepted("order", made, {"lemmas": [["psd", ["I", ["sym", "n"]], B]], "parts": [shown, used]})


@pytest.mark.parametrize("text", ["1e999999999", "1E5", "nan", "inf", "1_0", "٣", " 1", "1/0", 0.5, True])
def test_a_number_is_written_out(text):
    """Nothing is made of powers of ten that nobody could wait for, nor of digits of other scripts."""
    made = statement([">=", ["*", x, x], 0], [["x", ["scalar"]]], sizes=[])
    assert not accepted("instances", made, {"instances": [{"sizes": {}, "values": {"x": text}}]})
    assert accepted("instances", made, {"instances": [{"sizes": {}, "values": {"x": "-1.50"}}]})


# ---------------------------------------------------------------------- sequences and expansions
def test_sequences_without_end_are_not_compared():
    """Two of which nothing has been looked at would be equal."""
    made = statement(["=", ["sym", "u"], ["sym", "v"]], [["u", ["signal", 0]], ["v", ["signal", 0]]], sizes=[])
    assert not accepted("identity", made, {"cases": [{}]})


def test_a_sequence_without_end_goes_on():
    """An instance lists a few entries; that the next is not among them does not make it undefined."""
    made = statement(["defined", ["at", "s", 10]], [["s", ["signal", 0]]], sizes=[])
    assert not accepted("counterexample", made, {"instance": {"sizes": {}, "values": {"s": [1, 2]}}})
    assert not accepted("counterexample", made, {"instance": {"sizes": {}, "values": {"s": []}}})
    before = {**made, "says": ["defined", ["at", "s", ["-", 0, 1]]]}
    assert accepted("counterexample", before, {"instance": {"sizes": {}, "values": {"s": [1, 2]}}})


def test_an_expansion_has_a_leading_coefficient():
    """1/(a z + b) has no constant term at infinity unless a = 0, and then it is 1/b."""
    a, b = ["sym", "a"], ["sym", "b"]
    made = statement(["=", ["laurent", ["/", 1, ["+", ["*", a, ["z"]], b]], 0], 0], [["a", ["scalar"]], ["b", ["scalar"]]], sizes=[])
    assert not accepted("identity", made, {"cases": [{}]})
    assert accepted("counterexample", made, {"instance": {"sizes": {}, "values": {"a": 0, "b": 1}}})
    monic = ["=", ["laurent", ["/", a, ["+", ["z"], b]], 2], ["*", -1, a, b]]
    assert accepted("identity", {**made, "says": monic}, {"cases": [{}]})


def test_a_square_of_a_polynomial_has_no_sign():
    """z^2 >= 0 is nonsense."""
    made = statement([">=", ["^", ["z"], 2], 0], [], sizes=[])
    assert not accepted("positivity", made, {"cases": [{}], "terms": [[1, ["z"], []]]})


# ---------------------------------------------------------------------- one equation after the other
def test_a_multiplier_divides_by_nothing_of_a_later_equation():
    """x y = 0 gives x = 0 and 1/y = 1/y only if the second is looked at first."""
    over, given = [["x", ["scalar"]], ["y", ["scalar"]]], [["h", ["=", ["*", x, y], 0], "standing"]]
    parts, terms = [["=", x, 0], ["=", ["/", 1, y], ["/", 1, y]]], [[[["/", 1, y], "h", 1]], []]
    made = statement(["and", *parts], over, given, sizes=[])
    assert not accepted("combination", made, {"cases": [{}], "terms": terms})
    assert accepted("counterexample", made, {"instance": {"sizes": {}, "values": {"x": 1, "y": 0}}})
    assert accepted("combination", {**made, "says": ["and", *parts[::-1]]}, {"cases": [{}], "terms": terms[::-1]})


def test_a_cofactor_divides_by_nothing_of_a_later_equation():
    """(X - X_0) X = 0 at t, divided by the X of the next equation, gives X = X_0 at t + 1."""
    over, X = [["c", ["scalar"]]], ["at", "X", ["sym", "t"]]
    keeps, unit = ["rec", "X", "t", 0, [["sym", "c"]], X], ["rec", "Y", "t", 0, [1], ["*", ["at", "Y", ["sym", "t"]], ["at", "X", ["sym", "t"]]]]
    first, second = ["=", ["*", X, ["-", ["at", "Y", ["sym", "t"]], 1]], 0], ["=", ["/", 1, X], ["/", 1, X]]
    made = statement(["always", "t", ["and", first, second]], over, (), [keeps, unit], [])
    evidence = {"cases": [{}], "cofactors": [[[["/", ["*", X, X], X], 0, 1]], []]}
    assert not accepted("induction", made, evidence)


# ---------------------------------------------------------------------- indices of which nothing is known
def test_an_index_written_out_is_not_the_one_of_an_induction():
    """X[t + 1] = s[t] - s[1000000] is not zero at t = 0, though it is at t = 1000000."""
    for far in (10**6, 10**6 - 1, 10**5):
        falls = ["rec", "X", "t", 0, [0], ["-", ["at", "s", ["sym", "t"]], ["at", "s", far]]]
        made = statement(["always", "t", ["=", ["at", "X", ["sym", "t"]], 0]], [["s", ["signal", 0]]], (), [falls], [])
        assert not accepted("induction", made, {"cases": [{}]})


def test_a_state_is_solved_for_at_its_own_index():
    """X[t] = X[t] is no value of X[t]: by the step from t - 1 it would be one for t > 1 only."""
    X, Y = (["at", name, ["sym", "t"]] for name in "XY")
    where = [["rec", "Y", "t", 0, [7], 5], ["rec", "X", "t", 0, [5], Y]]
    made = statement(["always", "t", ["=", X, 5]], [], (), where, [])
    assert not accepted("induction", made, {"cases": [{}], "solve": [1, 2], "also": [["=", X, X], ["=", Y, Y]]})
    assert accepted("counterexample", made, {"instance": NOWHERE})


# ---------------------------------------------------------------------- determinants
def test_a_number_is_no_factor_of_a_determinant():
    """det(cA) = c^n det(A)."""
    over = [["C", ["matrix", 1, 1]], SQUARE[0]]
    for factors in ([C, A], [A, C]):
        made = statement(["=", ["det", ["*", *factors]], ["*", ["det", C], ["det", A]]], over)
        evidence = {"parts": [{"sum": [], "blocks": [[], [["1", [], "det 0", []]]], "factors": [[["*", *factors], factors]]}]}
        assert not accepted("order", made, evidence)
        square = {**made, "over": [["C", SQUARE[0][1]], SQUARE[0]]}
        assert accepted("order", square, evidence)


# ---------------------------------------------------------------------- at a generic index
def lemma(says, **more):
    return {"index": "t", "says": says, "from": 0, "rule": False, "bare": False, "direct": False, "in values": False, "uses": [], **more}


def use(number, place, **more):
    return {"lemma": number, "at": {"t": place}, **more}


T, N, K = ["sym", "t"], ["sym", "n"], ["sym", "k"]
ENTRIES = [["s", ["signal", 0]]]
CONSTANT = ["rec", "X", "t", 0, [1], ["at", "X", T]]
IS_ONE = lemma(["=", ["at", "X", T], 1], uses=[use(0, T)])


def test_a_multiple_of_a_lemma_divides_by_no_zero():
    """s = s/(X - 1) (X - 1) where X is one."""
    made = statement(["always", "t", ["=", ["at", "s", T], 0]], ENTRIES, (), [CONSTANT], ["n"])
    by_zero = use(0, T, times=["/", ["at", "s", T], ["-", ["at", "X", T], 1]])
    assert not accepted("generic index", made, {"lemmas": [IS_ONE], "uses": [by_zero]})
    assert accepted("generic index", {**made, "says": ["always", "t", ["=", ["at", "X", T], 1]]}, {"lemmas": [IS_ONE], "uses": [use(0, T)]})


def test_a_recursion_that_divides_by_zero_says_nothing():
    """F[t + 1] = s[t] R[t]/(X[t] - 1) is s[t] and also 2 s[t] where R = 0 and X = 1."""
    at = ["at", "F", ["+", T, 1]]
    quotient = ["rec", "F", "t", 0, [0], ["/", ["*", ["at", "s", T], ["at", "R", T]], ["-", ["at", "X", T], 1]]]
    before = ["at", "s", ["-", K, 1]]
    where = [CONSTANT, ["rec", "R", "t", 0, [0], ["at", "R", T]], quotient]
    made = statement(["forall", "i", 0, N, ["forall", "k", 1, N, ["=", before, 0]]], ENTRIES, (), where)


    zero = ["rec", "R", "t", 0, [0], ["at", "R", T]]
    made = statement(["forall", "i", 0, N, ["forall", "k", 1, N, ["=", before, 0]]], ENTRIES, (), [CONSTANT, zero, quotient])
    lemmas = [IS_ONE, lemma(["=", ["at", "R", T], 0], uses=[use(1, T)])]
    lemmas += [lemma(["=", at, ["*", c, ["at", "s", T]]], direct=True, uses=[use(0, T), use(1, T)]) for c in (1, 2)]
    assert not accepted("generic index", made, {"lemmas": lemmas, "uses": [use(k, ["-", K, 1]) for k in (2, 3)]})


def test_a_recursion_that_leads_to_later_values_says_nothing():
    """X[t + 1] = X[n] + s[t] has no value for t < n, and gives s[n - 1] = 0."""
    ahead = ["rec", "X", "t", 0, [0], ["+", ["at", "X", N], ["at", "s", T]]]
    made = statement(["=", ["at", "s", ["-", N, 1]], 0], ENTRIES, [["n", [">=", N, 1], "standing"]], [ahead])
    shown = lemma(["=", ["at", "X", ["+", T, 1]], ["+", ["at", "X", N], ["at", "s", T]]], direct=True)
    assert not accepted("generic index", made, {"lemmas": [shown], "uses": [use(0, ["-", N, 1])]})
    behind = {**made, "where": [["rec", "X", "t", 0, [0], ["+", ["at", "X", T], ["at", "s", T]]]],
              "says": ["=", ["at", "X", N], ["+", ["at", "X", ["-", N, 1]], ["at", "s", ["-", N, 1]]]]}
    shown = lemma(["=", ["at", "X", ["+", T, 1]], ["+", ["at", "X", T], ["at", "s", T]]], direct=True)
    assert accepted("generic index", behind, {"lemmas": [shown], "uses": [use(0, ["-", N, 1])]})


def test_a_variable_is_not_the_indeterminate():
    """A number called z is not z."""
    assert not accepted("generic index", statement(["=", ["sym", "z"], ["z"]], [["z", ["scalar"]]], sizes=[]), {"lemmas": [], "in values": True})


# ---------------------------------------------------------------------- what a certificate rests on
def test_a_parametrisation_is_named():
    """x = c^2 reaches no negative x: an identity in c is about the others, and says so."""
    from exactkf.kernel.replay import rests_on

    made = statement(["=", ["*", x, ["-", x, x]], 0], [["x", ["scalar"]]], sizes=[])
    evidence = {"cases": [{}], "given_by": {"x": ["^", ["sym", "c"], 2]}, "parameters": [["c", ["scalar"]]]}
    assert not accepted("identity", made, evidence)
    assert rests_on(seal("X", "identity", made, {**evidence, "covered_by": "MY-1"})) == "MY-1"
    said = {**made, "over": [["x", ["scalar"]], ["y", ["scalar"]]], "given": [["h", ["=", x, ["^", y, 2]], "standing"]]}
    assert rests_on(seal("X", "identity", said, {"cases": [{}], "given_by": {"x": ["^", y, 2]}})) == ""


@pytest.mark.parametrize("says", [["=", ["^", 2, 10**9], 0], ["=", ["I", 10**9], 0], ["=", ["^", 3, ["^", 10, 9]], 0]])
def test_nothing_huge_is_computed(says):
    """A certificate does not keep the checker busy with a power or a matrix that nobody could write down."""
    assert not accepted("evaluation", statement(says, [], sizes=[]), {"cases": [{}]})


def test_a_kind_that_is_no_name_is_no_certificate():
    """What is no certificate is told so, whatever stands in its place."""
    from exactkf.kernel.replay import NotACertificate

    with pytest.raises(NotACertificate):
        replay({**seal("X", "orbit", {}, {}), "kind": ["orbit"]})


# ---------------------------------------------------------------------- powers inside the unit circle
Q = ["sym", "Q"]
OF_TWO = [["A", ["matrix", ["sym", "n"], ["sym", "n"]]], ["Q", ["symmetric", ["sym", "n"]]]]
LESS = ["-", Q, ["*", A, Q, ["T", A]]]
INSIDE, NOT_LESS = ["inside", ["schur", A], "standing"], ["less", ["psd", LESS], "standing"]
#: the sum is the hypothesis itself, so that no multiples are needed
SUMMED = {"parts": [{"sum": [LESS], "terms": [], "stein": A}]}


@pytest.mark.parametrize("given, says, stein, right", [
    ([INSIDE, NOT_LESS], ["psd", Q], A, True),
    ([NOT_LESS], ["psd", Q], A, False),  # A = 2, Q = -1
    ([INSIDE, NOT_LESS], ["psd", Q], ["*", 2, A], False),
    ([INSIDE, NOT_LESS], ["psd", Q], ["T", A], False),  # another equation
    ([INSIDE, NOT_LESS], ["pd", Q], A, False),  # Q = 0
    ([["inside", ["schur", ["inv", A]], "standing"], NOT_LESS], ["psd", Q], A, False),
    ([["inside", ["schur", ["*", A, A]], "standing"], NOT_LESS], ["psd", Q], A, False),
])
def test_a_sum_over_powers(given, says, stein, right):
    """Q - AQA' >= 0 makes Q >= 0 only where the powers of this A tend to zero."""
    assert accepted("order", statement(says, OF_TWO, given), {"parts": [{**SUMMED["parts"][0], "stein": stein}]}) is right


def test_an_order_of_other_matrices_is_no_sum_over_powers():
    """The terms are those of Q - AQA', and not of Q."""
    plain = {"parts": [{"sum": [LESS], "terms": []}]}
    assert not accepted("order", statement(["psd", Q], OF_TWO, [INSIDE, NOT_LESS]), plain)
    negative = statement(["psd", Q], OF_TWO, [INSIDE, ["q", ["psd", ["neg", Q]], "standing"]])
    assert not accepted("order", negative, {"parts": [{"sum": [["neg", Q]], "terms": [], "stein": A}]})
