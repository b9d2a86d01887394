# SPDX-License-Identifier: MIT
"""Proofs for every size: what is true is proved, what is false is not, and sizes are checked."""

from __future__ import annotations

import copy

import pytest

from exactkf.finders.membership import find_membership
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.reader import Reader, residual_blocks
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import (
    Identity,
    Statement,
    T,
    Zero,
    block,
    inv,
    let,
    matrix,
    standing,
    sym,
    symbols,
    symmetric,
    symmetric_matrix,
    symplectic,
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

FALSE = {
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
