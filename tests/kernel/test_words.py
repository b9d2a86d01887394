# SPDX-License-Identifier: MIT
"""Proofs for every size: what is true is proved, what is false is not, and sizes are checked."""

from __future__ import annotations

import copy

import pytest

from exactkf.finders.completion import Stuck, system_of
from exactkf.finders.membership import find_membership, search_membership
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.reader import Reader, relations, residual_blocks
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import (
    Identity,
    Statement,
    T,
    Zero,
    block,
    charpoly,
    inv,
    let,
    matrix,
    nonsingular,
    nonzero,
    rank,
    scalar,
    standing,
    sym,
    symbols,
    symmetric,
    symmetric_matrix,
    symplectic,
    vector,
)

n, m, p, d = symbols("n m p d")
A, B, C, D, P, Q, M, V, K = symbols("A B C D P Q M V K")
I = Identity
SQUARE = {x: matrix(d, d) for x in "ABCD"}
UPDATE = {"sizes": ["n", "p"], "over": {"P": symmetric_matrix(n), "M": matrix(p, n), "V": symmetric_matrix(p)},
          "where": [let(K, P * T(M) * inv(M * P * T(M) + V))]}
FOUR = {"sizes": ["d"], "over": SQUARE, "where": [let(sym("S"), block([[A, B], [C, D]]))], "given": [standing("symplectic", symplectic(sym("S")))]}

TRUE = {
    "push-through": {"sizes": ["n", "m"], "over": {"P": matrix(n, m), "Q": matrix(m, n)}, "says": inv(I(n) + P * Q) * P == P * inv(I(m) + Q * P)},
    "Joseph form": {**UPDATE, "says": (I(n) - K * M) * P * T(I(n) - K * M) + K * V * T(K) == P - K * M * P},
    "information form": {**UPDATE, "says": P - K * M * P == inv(inv(P) + T(M) * inv(V) * M)},
    "blocks of a symplectic matrix": {**FOUR, "says": (A * T(B) == B * T(A)) & (T(A) * D - T(C) * B == I(d))},
    "its transpose": {**FOUR, "says": symplectic(T(sym("S")))},
    "one-sided inverse": {"sizes": ["d"], "over": SQUARE, "given": [standing("inverse", A * B == I(d))], "says": B * A == I(d)},
    "inverse of a product": {"sizes": ["d"], "over": SQUARE, "says": inv(A * B) * inv(inv(B) * inv(A)) == I(d)},
    "symmetric inverse": {"sizes": ["n"], "over": {"P": symmetric_matrix(n)}, "says": symmetric(inv(P))},
    "block inverse": {"sizes": ["n", "m"], "over": {"A": matrix(n, n), "B": matrix(n, m)},
                      "says": block([[A, B], [Zero(m, n), I(m)]]) * block([[inv(A), -inv(A) * B], [Zero(m, n), I(m)]]) == I(n + m)},
}

c, e, R, v, w, x = symbols("c e R v w x")
VECTORS = {"sizes": ["n"], "over": {"A": matrix(n, n), "B": matrix(n, n), "P": symmetric_matrix(n), "v": vector(n), "w": vector(n)}}
SCALARS = {"sizes": ["n"], "over": {"A": matrix(n, n), "B": matrix(n, n), "c": scalar(), "e": scalar()}}
SCHUR = {"sizes": ["n", "m"], "over": {"A": nonsingular(n), "B": matrix(n, m), "C": matrix(m, n), "D": matrix(m, m)},
         "where": [let(R, inv(D - C * inv(A) * B))]}
TRUE |= {
    "scalars commute": {**SCALARS, "says": A * (c * B) == c * A * B},
    "resolvent identity": {**SCALARS, "says": inv(c * I(n) - A) - inv(e * I(n) - A) == (e - c) * inv(c * I(n) - A) * inv(e * I(n) - A)},
    "a scalar that does not vanish": {**SCALARS, "over": {**SCALARS["over"], "c": nonzero()}, "given": [standing("x", c * A * B == c * c * B)],
                                      "says": A * B == c * B},
    "quotient by a sum": {**SCALARS, "given": [standing("x", A + c * A == B)], "says": A == B / (1 + c)},
    "a number is its transpose": {**VECTORS, "says": T(v) * A * w == T(w) * T(A) * v},
    "numbers commute": {**VECTORS, "says": v * (T(v) * A * w) * (T(w) * B * v) == v * (T(w) * B * v) * (T(v) * A * w)},
    "a number times a matrix": {**VECTORS, "says": (T(v) * w) * A * v == A * v * T(w) * v},
    "an equation of numbers in any size": {**VECTORS, "given": [standing("x", P * v == w)], "says": (T(v) * P * v) * A == (T(w) * v) * A},
    "rank one update of an inverse": {"sizes": ["n"], "over": {"A": nonsingular(n), "v": vector(n), "w": vector(n)},
                                      "says": inv(A + v * T(w)) == inv(A) - inv(A) * v * T(w) * inv(A) / (1 + T(w) * inv(A) * v)},
    "scalar observation": {**VECTORS, "where": [let(K, P * v / (T(v) * P * v + 1))], "says": P - K * T(v) * P == inv(inv(P) + v * T(v))},
    "inverse by the Schur complement": {**SCHUR, "says": inv(block([[A, B], [C, D]])) == block([[inv(A) + inv(A) * B * R * C * inv(A), -inv(A) * B * R],
                                                                                                   [-R * C * inv(A), R]])},
    "full column rank": {"sizes": ["n", "m"], "over": {"A": matrix(m, n), "x": vector(n)},
                         "given": [standing("rank", rank(A) == n), standing("null", A * x == 0)], "says": x == Zero(n, 1)},
    "full row rank": {"sizes": ["n", "m"], "over": {"A": matrix(m, n), "B": matrix(n, m)},
                      "given": [standing("rank", rank(A) == m), standing("null", B * A == Zero(n, n))], "says": B == Zero(n, m)},
}

FALSE = {
    "dividing by a scalar that may vanish": {**SCALARS, "given": [standing("x", c * A == c * B)], "says": A == B},
    "a number that is no transpose": {**VECTORS, "says": T(v) * A * w == T(v) * T(A) * w},
    "numbers in the wrong order": {**VECTORS, "says": v * T(v) * A * w * T(w) == w * T(w) * A * v * T(v)},
    "the wrong rank": {"sizes": ["n", "m"], "over": {"A": matrix(m, n), "x": vector(n)},
                       "given": [standing("rank", rank(A) == m), standing("null", A * x == 0)], "says": x == Zero(n, 1)},
    "commuting": {"sizes": ["d"], "over": SQUARE, "says": A * B == B * A},
    "inverse in the wrong order": {"sizes": ["d"], "over": SQUARE, "says": inv(A * B) == inv(A) * inv(B)},
    "a sign": {**UPDATE, "says": (I(n) - K * M) * P * T(I(n) - K * M) - K * V * T(K) == P - K * M * P},
    "nothing assumed": {"sizes": ["d"], "over": SQUARE, "says": A * T(B) == B * T(A)},
    "left inverse of a tall matrix": {"sizes": ["n", "m"], "over": {"A": matrix(m, n), "B": matrix(n, m)}, "given": [standing("left", A * B == I(m))],
                                      "says": B * A == I(n)},
}


@pytest.mark.parametrize("name", TRUE)
def test_true_identities_are_proved_for_every_size(name):
    """A certificate is found and replays."""
    data = Statement(**TRUE[name]).to_json()
    terms = find_membership(data)
    assert terms is not None
    replay(seal("T", "membership", data, {"terms": terms}))


@pytest.mark.parametrize("name", FALSE)
def test_false_identities_are_not(name):
    """The search ends without a certificate, and no empty one is accepted."""
    data = Statement(**FALSE[name]).to_json()
    assert find_membership(data, seconds=1.0) is None
    with pytest.raises(Rejected):
        replay(seal("T", "membership", data, {"terms": [[]]}))


NUMBERS = {
    "an exponent": lambda t: t[4][0].__setitem__(1, 2),
    "a division": lambda t: t.__setitem__(4, [["c", -1]]),
    "an equation of numbers": lambda t: t[2]["numbers"][0].__setitem__(0, "2"),
    "its proof": lambda t: t[2]["terms"].pop(),
    "a word that is no number": lambda t: t.__setitem__(2, ["P", "v"]),
}


@pytest.mark.parametrize("name", NUMBERS)
def test_scalars_of_a_certificate_matter(name):
    """A changed exponent, a division by what may vanish, a changed equation of numbers are noticed."""
    equation = "equation" in name or "proof" in name or "number" in name
    statement = TRUE["an equation of numbers in any size" if equation else "quotient by a sum"]
    data = Statement(**statement).to_json()
    terms = find_membership(data)
    replay(seal("T", "membership", data, {"terms": terms}))
    NUMBERS[name](next(t for t in terms[0] if len(t) > 4 or isinstance(t[2], dict)))
    with pytest.raises(Rejected):
        replay(seal("T", "membership", data, {"terms": terms}))


def test_how_far_a_search_got():
    """Rules, degree and what is left are told; so is a term that cannot be read."""
    stuck = search_membership(Statement(**FALSE["the wrong rank"]).to_json())
    assert isinstance(stuck, Stuck) and (stuck.rules, stuck.remainder) == (4, "x") and "4 rules" in str(stuck)
    assert "'charpoly'" in str(search_membership(Statement(sizes=["n"], over={"A": matrix(n, n)}, says=charpoly(A) == 0).to_json()))


def test_goals_with_one_set_of_assumptions_share_their_rules():
    """The second goal starts with the rules that the first has made."""
    data = Statement(**FOUR, says=A * T(B) == B * T(A)).to_json()
    assumed = relations(reader := Reader(data))
    first = system_of(reader, assumed, 8)
    assert find_membership(data) is not None
    assert system_of(Reader(data), relations(Reader(data)), 8) is first
    assert first.made > 0


def test_a_certificate_of_something_else_is_rejected():
    """Terms that prove one statement do not prove its neighbour; a changed coefficient or word is noticed."""
    data = Statement(**TRUE["Joseph form"]).to_json()
    terms = find_membership(data)
    with pytest.raises(Rejected):
        replay(seal("T", "membership", Statement(**FALSE["a sign"]).to_json(), {"terms": terms}))
    for change in (lambda t: t[0][0].__setitem__(0, "2"), lambda t: t[0][0][1].append("V"), lambda t: t[0].pop(), lambda t: t.append([])):
        edited = copy.deepcopy(terms)
        change(edited)
        with pytest.raises(Rejected):
            replay(seal("T", "membership", data, {"terms": edited}))


@pytest.mark.parametrize("says", [A * B == A, A + B == A, block([[A, A], [B, B]]) == Zero(n, n), inv(B) == B])
def test_sizes_that_do_not_fit_are_refused(says):
    """Products and sums of the wrong sizes are named."""
    data = Statement(sizes=["n", "m"], over={"A": matrix(n, n), "B": matrix(m, n)}, says=says).to_json()
    with pytest.raises((Undefined, Unknown), match="siz|square"):
        residual_blocks(Reader(data), data["says"])


def test_very_long_products_are_refused(monkeypatch):
    """Powers of sums have words without end; the reader says so before it fills the memory."""
    says = ["=", ["^", ["+", ["sym", "A"], ["sym", "B"]], 8], 0]
    data = {"sizes": ["n"], "over": [[name, ["matrix", ["sym", "n"], ["sym", "n"]]] for name in "AB"], "where": [], "given": [], "says": says}
    assert len(residual_blocks(Reader(data), says)[0].grid[0][0]) == 256
    monkeypatch.setattr("exactkf.kernel.words.WORDS", 100)
    with pytest.raises(Unknown, match="more than 100 words"):
        residual_blocks(Reader(data), says)
