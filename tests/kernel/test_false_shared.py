# SPDX-License-Identifier: MIT
"""What leaves of one conclusion share: readings, and letters that a proof lists once. None of it carries over where it is false."""

from __future__ import annotations

import pytest

from exactkf.kernel.reader import Reader
from tests.kernel.test_false_claims import accepted, statement

n, A, B, P = (["sym", name] for name in ("n", "A", "B", "P"))
SQUARE = [["A", ["matrix", n, n]], ["B", ["matrix", n, n]]]
COMMUTE = [["h", ["=", ["*", A, B], ["*", B, A]], "standing"]]
ITSELF = [["1", [], "h/0/0/0", []]]
TURNED = [["1", [], "h/0/0/0'", []]]


def test_a_symmetry_that_one_leaf_assumes_is_no_other_leafs():
    """AB = BA gives B'A = AB' for a symmetric A, whichever leaf has read the hypothesis first."""
    commute, turned = COMMUTE[0][1], ["=", ["*", ["T", B], A], ["*", A, ["T", B]]]
    given_first = ["and", ["=>", ["symmetric", A], turned], commute]
    given_last = ["and", commute, ["=>", ["symmetric", A], turned]]
    parts = [{"sum": [], "terms": TURNED}, {"sum": [], "terms": ITSELF}]
    assert accepted("order", statement(given_first, SQUARE, COMMUTE), {"parts": parts})
    assert accepted("order", statement(given_last, SQUARE, COMMUTE), {"parts": parts[::-1]})
    for says in (["and", ["=>", ["symmetric", A], turned], turned], ["and", ["=>", ["symmetric", B], turned], turned]):
        assert not accepted("order", statement(says, SQUARE, COMMUTE), {"parts": [parts[0]] * 2})


def test_a_root_of_one_leaf_is_no_letter_of_another():
    """RR = P is told where R is the root of P, not in the leaf after it."""
    over = [["P", ["psd", n]]]
    says = ["and", ["=", P, P], ["=", P, P]]
    own, other = {"sum": [["sym", "R"]], "terms": [], "roots": [["R", P]]}, {"sum": [["sym", "R"]], "terms": []}
    made = statement(says, over)
    assert accepted("order", made, {"parts": [own, own]})
    assert not accepted("order", made, {"parts": [own, other]})


def test_readers_of_other_letters_share_nothing():
    """A tree that was read where A is symmetric is read again where it is not; inverses are each reader's own."""
    told = [["s", ["symmetric", A], "standing"]]
    made = {**statement(["=", A, A], SQUARE), "alike": {}}
    tree, inverse = ["T", A], ["inv", ["+", A, B]]
    first, second, third = Reader({**made, "given": told}), Reader(made), Reader(made)
    assert first.read(tree) == first.read(A)
    assert second.read(tree) != second.read(A)
    assert third.read(tree) is second.read(tree) is not first.read(tree)
    assert second.read(inverse) == second.read(["*", inverse, 1])
    assert not third.inverses
    third.read(inverse)
    assert len(second.inverses) == len(third.inverses) == 1
    third.read(["neg", inverse])
    assert len(Reader(made).inverses) == 0


@pytest.mark.parametrize("letters, word, good", [(["A"], 0, True), (["B"], 0, False), (["A"], 1, False), ([["A"]], 0, False), ({"0": "A"}, 0, False)])
def test_letters_that_are_listed_stand_for_themselves(letters, word, good):
    """A(AB - BA) = 0 with a number for A; another letter, or none, does not do."""
    says = ["=", ["*", A, A, B], ["*", A, B, A]]
    part = {"sum": [], "terms": [["1", [word], "h/0/0/0", []]], "letters": letters}
    assert accepted("order", statement(says, SQUARE, COMMUTE), {"parts": [part]}) is good
    assert accepted("order", statement(says, SQUARE, COMMUTE), {"parts": [{**part, "terms": [["1", ["A"], "h/0/0/0", []]]}]})
