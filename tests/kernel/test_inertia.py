# SPDX-License-Identifier: MIT
"""The rule of inertia: diag(W, Q) = X' diag(V, P) X and P >= Y'QY make W semidefinite, and nothing less does."""

from __future__ import annotations

import pytest

from exactkf.evidence import order, within
from exactkf.finders.membership import find_order
from exactkf.finders.prove import every_size
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import (
    Expr,
    Identity,
    Statement,
    T,
    Zero,
    block,
    diag,
    given,
    inv,
    loewner,
    matrix,
    pd,
    positive_semidefinite,
    psd,
    symbols,
    symmetric_matrix,
)
from tests.kernel.acceptance import is_accepted

H, K, P, Q, V, W, X, Y, Z, m, n = symbols("H K P Q V W X Y Z m n")
A, B, C, D = symbols("A B C D")
SIZES = {"sizes": ["m", "n"], "over": {W: symmetric_matrix(m), V: positive_semidefinite(m), P: symmetric_matrix(n), Q: symmetric_matrix(n),
                                       H: positive_semidefinite(n), Y: matrix(n, n), K: matrix(n, n), A: matrix(m, m),
                                       B: matrix(m, n), C: matrix(n, m), D: matrix(n, n)}}
WHOLE = block([[A, B], [C, D]])
AFTER, BEFORE = block([[W, Zero(m, n)], [Zero(n, m), Q]]), block([[V, Zero(m, n)], [Zero(n, m), P]])
CONGRUENT = given("congruent", AFTER == T(WHOLE) * BEFORE * WHOLE)
ABOVE = given("P is larger", P == T(Y) * Q * Y + H)
RULE = order([H], inside=[within(0, inertia=(WHOLE, V, P, Y, Q))])


def statement(says: Expr, *hypotheses, **types) -> dict:
    return Statement(says, sizes=SIZES["sizes"], over={**SIZES["over"], **types.get("over", {})}, given=list(hypotheses)).to_json()


def proved(made: dict, *by) -> bool:
    """The finder has a certificate that the checker accepts."""
    return any(map(is_accepted, every_size("X", made, list(by), 5.0)))


def test_what_follows():
    """W is semidefinite, also as a difference, and with P = Y'QY."""
    assert proved(statement(psd(W), CONGRUENT, ABOVE), RULE)
    assert proved(statement(loewner(W, Zero(m, m)), CONGRUENT, ABOVE), RULE)
    equal = given("equal", P == T(Y) * Q * Y)
    assert proved(statement(psd(W), CONGRUENT, equal), order([0 * H], inside=[within(0, inertia=(WHOLE, V, P, Y, Q))]))


@pytest.mark.parametrize(("hypotheses", "over"), [
    ((CONGRUENT,), {}), ((ABOVE,), {}), ((CONGRUENT, given("P is smaller", P + H == T(Y) * Q * Y)), {}),
    ((CONGRUENT, given("no congruence", P == K * Q * Y + H)), {}),
    ((CONGRUENT, ABOVE), {V: symmetric_matrix(m)}), ((CONGRUENT, ABOVE), {H: symmetric_matrix(n)}), ((CONGRUENT, ABOVE), {P: matrix(n, n)}),
    ((given("no congruence", AFTER == WHOLE * BEFORE * WHOLE), ABOVE), {}),
    ((given("coupled", block([[W, B], [T(B), Q]]) == T(WHOLE) * BEFORE * WHOLE), ABOVE), {}),
    ((given("coupled", AFTER == T(WHOLE) * block([[V, B], [T(B), P]]) * WHOLE), ABOVE), {})],
    ids=lambda some: ", ".join(map(str, some))[:60])
def test_nothing_less_is_enough(hypotheses, over):
    """Without one of the hypotheses W may have a negative eigenvalue."""
    assert not proved(statement(psd(W), *hypotheses, over=over), RULE)


def test_it_is_for_semidefinite_matrices():
    """Not for a definite one, nor for an equation."""
    assert not proved(statement(pd(W), CONGRUENT, ABOVE), RULE)
    assert not proved(statement(W == Zero(m, m), CONGRUENT, ABOVE), RULE)


def test_a_schur_complement():
    """V + MPM' >= 0 does not follow from V >= 0 alone, whatever is chosen."""
    names = {"sizes": ["m", "n"], "over": {V: positive_semidefinite(m), P: symmetric_matrix(n), B: matrix(m, n), Z: matrix(n, n)}}
    made = Statement(psd(V + B * P * T(B)), **names).to_json()
    lower = block([[Identity(m), Zero(m, n)], [T(B), Identity(n)]])
    for turn, q in ((lower, P), (diag(Identity(m), Identity(n)), P), (lower, Zero(n, n))):
        assert not proved(made, order([Zero(n, n)], inside=[within(0, inertia=(turn, V, P, Identity(n), q))]))


def test_a_forged_proof():
    """A proof is none without the five matrices, or with others, or for another statement."""
    made = statement(psd(W), CONGRUENT, ABOVE)
    trees = [x.tree for x in (WHOLE, V, P, Y, Q)]
    parts = find_order(made, [[list(H.tree)]], stable=[[0, {"inertia": _listed(trees)}]])
    replay(seal("X", "order", made, {"parts": parts, "lemmas": []}))
    inverse = [*trees[:3], inv(Y).tree, trees[4]]
    for forged, part in ((statement(psd(W), CONGRUENT), parts[0]), (statement(psd(-W), CONGRUENT, ABOVE), parts[0]),
                         (made, {key: x for key, x in parts[0].items() if key != "inertia"}), (made, {**parts[0], "inertia": _listed(inverse)}),
                         (made, {**parts[0], "sum": []})):
        with pytest.raises(Rejected):
            replay(seal("X", "order", forged, {"parts": [part], "lemmas": []}))


def _listed(tree):
    return [_listed(x) for x in tree] if isinstance(tree, (list, tuple)) else tree
