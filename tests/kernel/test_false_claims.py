# SPDX-License-Identifier: MIT
"""False statements with evidence made by hand: the checker rejects each, and accepts the true neighbour."""

from __future__ import annotations

import pytest

from exactkf.kernel.replay import Rejected, replay, seal

A, B, C, x, y = (["sym", name] for name in "ABCxy")
SQUARE = [[name, ["matrix", ["sym", "n"], ["sym", "n"]]] for name in "ABC"]
CANCEL = [["g", ["=", ["*", A, B], ["*", A, C]], "standing"]]


def statement(says, over=SQUARE, given=(), where=(), sizes=("n",)):
    return {"sizes": list(sizes), "over": list(over), "where": list(where), "given": list(given), "says": says}


def accepted(kind, made, evidence):
    try:
        replay(seal("X", kind, made, evidence))
    except Rejected:
        return False
    return True


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
