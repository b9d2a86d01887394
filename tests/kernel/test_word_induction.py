# SPDX-License-Identifier: MIT
"""Induction for every size: what is true for all t is proved, what is not is not, and a broken certificate is noticed."""

from __future__ import annotations

import copy
import json

import pytest

from exactkf import verify_statement
from exactkf._errors import BadInput
from exactkf.evidence import first, induction, instances, order
from exactkf.finders.membership import find_induction
from exactkf.kernel.instances import admissible, read_instance
from exactkf.kernel.meaning import World
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import (
    Identity,
    Statement,
    T,
    Zero,
    always,
    block,
    forall,
    function,
    inv,
    invertible,
    loewner,
    matrix,
    nonsingular,
    positive_definite,
    positive_semidefinite,
    psd,
    rec,
    scalar,
    sequence_of,
    signal_of,
    standing,
    symbols,
    symmetric,
    symmetric_matrix,
    symplectic,
    vector,
)
from tests.properties.mp_meaning import admissible as admissible_again
from tests.properties.mp_meaning import evaluate

d, n, p, t, k = symbols("d n p t k")
A, B, K, M, P, Q, R, S, X, Y, H, Phi, Pi, P0, x = symbols("A B K M P Q R S X Y H Phi Pi P0 x")
I = Identity
SIGNAL = {"sizes": ["d"], "over": {"M": signal_of(matrix(d, d), 0)}}
PRODUCT = rec(Pi, t, I(d), M[t] * Pi[t])
FILTER = {
    "sizes": ["n", "p"],
    "over": {"Phi": matrix(n, n), "H": matrix(p, n), "P0": positive_semidefinite(n),
             "S": signal_of(positive_semidefinite(n), 0), "R": signal_of(positive_definite(p), 0)},
    "where": [function(K, [t], P[t] * T(H) * inv(H * P[t] * T(H) + R[t])),
              rec(P, t, P0, Phi * (P[t] - K(t) * H * P[t]) * T(Phi) + S[t])],
}
JOSEPH = Phi * ((I(n) - K(t) * H) * P[t] * T(I(n) - K(t) * H) + K(t) * R[t] * T(K(t))) * T(Phi)
ORTHOGONAL = {"sizes": ["d", "n"], "over": {"M": sequence_of(matrix(d, d), 1, n)}, "where": [rec(Pi, t, I(d), M[t + 1] * Pi[t])]}

TRUE = {
    "transposed products": ({**SIGNAL, "where": [PRODUCT, rec(X, t, I(d), X[t] * T(M[t]))], "says": always(t, T(Pi[t]) == X[t])}, {}),
    "products of symplectic matrices": (
        {"sizes": ["d"], "over": {"A": signal_of(nonsingular(d), 0), "P": signal_of(symmetric_matrix(d), 0), "Q": signal_of(symmetric_matrix(d), 0)},
         "where": [function(M, [k], block([[A[k], A[k] * P[k]], [Q[k] * A[k], inv(T(A[k])) + Q[k] * A[k] * P[k]]])), rec(Pi, t, I(2 * d), M(t) * Pi[t])],
         "says": always(t, symplectic(Pi[t]))}, {}),
    "the covariance stays semidefinite": ({**FILTER, "says": always(t, psd(P[t]))}, {"step": order([JOSEPH, S[t]])}),
    "its symmetry": ({**FILTER, "says": always(t, symmetric(P[t]))}, {}),
    "up to n, with a hypothesis for each": (
        {**ORTHOGONAL, "given": [standing("each", forall(k, 1, n, T(M[k]) * M[k] == I(d)))], "says": forall(k, 0, n, Pi[k] * T(Pi[k]) == I(d))}, {}),
    "carried along": ({**SIGNAL, "where": [PRODUCT, rec(X, t, I(d), M[t] * Pi[t] + X[t] - Pi[t])], "says": always(t, X[t + 1] == M[t] * Pi[t])},
                      {"also": [X[t] == Pi[t]]}),
    "two initial values": ({"sizes": ["d"], "over": {"M": matrix(d, d)}, "where": [rec(X, t, [I(d), M], 2 * M * X[t] - M * M * X[t - 1])],
                            "says": always(t, X[t + 1] == M * X[t])}, {}),
    "a sum": ({**SIGNAL, "where": [rec(X, t, M[0], X[t] + M[t + 1]), rec(Y, t, T(M[0]), Y[t] + T(M[t + 1]))], "says": always(t, T(X[t]) == Y[t])}, {}),
    "a premise": ({"sizes": ["d"], "over": {"A": matrix(d, d), "B": matrix(d, d)}, "where": [rec(X, t, I(d), A * X[t])],
                   "says": (A * B == B * A) >> always(t, X[t] * B == B * X[t])}, {}),
    "conjuncts": ({**SIGNAL, "where": [PRODUCT, rec(X, t, I(d), X[t] * T(M[t]))], "says": always(t, T(Pi[t]) == X[t]) & (Pi[1] == M[0])}, {}),
    "invertible": ({"sizes": ["d"], "over": {"A": signal_of(nonsingular(d), 0)}, "where": [rec(X, t, I(d), A[t] * X[t])], "says": always(t, invertible(X[t]))},
                   {"step": order([inv(X[t]) * inv(A[t])])}),
    "order": ({"sizes": ["n"], "over": {"A": matrix(n, n), "S": positive_semidefinite(n)},
               "where": [rec(X, t, S, A * X[t] * T(A)), rec(Y, t, S, A * Y[t] * T(A) + S)],
               "says": always(t, loewner(Y[t], X[t]))}, {"step": order([A * (Y[t] - X[t]) * T(A), S])}),
}
FALSE = {
    "products in the wrong order": ({**SIGNAL, "where": [PRODUCT, rec(X, t, I(d), T(M[t]) * X[t])], "says": always(t, T(Pi[t]) == X[t])}, {}),
    "a wrong start": ({**SIGNAL, "where": [rec(Pi, t, 2 * I(d), M[t] * Pi[t]), rec(X, t, I(d), X[t] * T(M[t]))], "says": always(t, T(Pi[t]) == X[t])}, {}),
    "only the first matrices": (
        {**ORTHOGONAL, "given": [standing("some", forall(k, 1, n - 1, T(M[k]) * M[k] == I(d)))], "says": forall(k, 0, n, Pi[k] * T(Pi[k]) == I(d))}, {}),
    "not the zeroth": (
        {"sizes": ["d", "n"], "over": {"M": sequence_of(matrix(d, d), 0, n)}, "given": [standing("some", forall(k, 1, n, T(M[k]) * M[k] == I(d)))],
         "says": forall(k, 0, n, T(M[k]) * M[k] == I(d))}, {}),
    "an inverse carried along that need not exist": (
        {"sizes": ["d"], "over": {"A": matrix(d, d), "x": vector(d)}, "where": [rec(X, t, I(d), X[t])],
         "says": always(t, (A * x == 0 * x) >> (X[t] * x == 0 * x))},
        {"also": [inv(A) * A * X[t] == X[t]]}),
    "an inverse in a premise carried along": (
        {"sizes": ["d"], "over": {"A": matrix(d, d), "x": vector(d)}, "where": [rec(X, t, Zero(d, d), I(d))],
         "says": always(t, (A * x == 0 * x) >> (X[t] * x == 0 * x))},
        {"also": [(inv(A) * A == I(d)) >> (X[t] == X[t])], "step": order([], [inv(A)])}),
    "a shape that changes": ({"sizes": ["d"], "over": {"A": matrix(d, d)},
                              "where": [rec(X, t, I(d), block([[X[t], A], [A, A]]))], "says": always(t, T(X[t]) == X[t])}, {}),
    "a difference": ({**FILTER, "says": always(t, loewner(P[t + 1], P[t]))}, {}),
}


def _found(name, table):
    parts, hints = table[name]
    data = Statement(**parts).to_json()
    return data, find_induction(data, json.loads(json.dumps(dict(induction(**hints).hints), default=dict)))


@pytest.mark.parametrize("name", TRUE)
def test_true_for_all_t(name):
    """A certificate is found and replays."""
    data, found = _found(name, TRUE)
    assert found is not None
    replay(seal("T", "word induction", data, found))


@pytest.mark.parametrize("name", FALSE)
def test_false_or_without_reason(name):
    """Nothing is found."""
    assert _found(name, FALSE)[1] is None


BROKEN = {
    "a coefficient": lambda e: e["conjuncts"][0][1]["parts"][0]["blocks"][0][0].__setitem__(0, "2"),
    "a word": lambda e: e["conjuncts"][0][1]["parts"][0]["blocks"][0][0][1].append("M[t]"),
    "a relation": lambda e: e["conjuncts"][0][1]["parts"][0]["blocks"][0][0].__setitem__(2, "hypothesis of induction 1/0/0/0"),
    "base and step exchanged": lambda e: e["conjuncts"][0].reverse(),
    "no step": lambda e: e["conjuncts"][0].pop(),
    "no base": lambda e: e["conjuncts"][0].pop(0),
    "no conjunct": lambda e: e.update(conjuncts=[]),
    "other sizes": lambda e: e.update(shapes={"Pi": [[1], [["sym", "d"]]]}),
    "scalars": lambda e: e.update(shapes={"Pi": None, "X": None}),
    "something shown along without proof": lambda e: e.update(also=[["=", ["at", "X", ["sym", "t"]], 0]]),
}


@pytest.mark.parametrize("name", BROKEN)
def test_broken_certificates_are_rejected(name):
    """Each part of a certificate matters."""
    data, found = _found("transposed products", TRUE)
    edited = copy.deepcopy(found)
    BROKEN[name](edited)
    with pytest.raises(Rejected):
        replay(seal("T", "word induction", data, edited))


@pytest.mark.parametrize("other", ["products in the wrong order", "a wrong start"])
def test_a_certificate_of_something_else_is_rejected(other):
    """The proof of one statement does not prove its neighbour."""
    _, found = _found("transposed products", TRUE)
    with pytest.raises(Rejected):
        replay(seal("T", "word induction", Statement(**FALSE[other][0]).to_json(), found))


#: X_k in the null space of what comes after it: from the end back to every k, and then forwards
CHAIN = {"sizes": ["d", "n"], "over": {"A": matrix(d, d), "X": sequence_of(matrix(d, d), 0, n)},
         "given": [standing("chain", forall(k, 0, n - 1, X[k] == A * X[k + 1])), standing("end", X[n] == Zero(d, d))]}
BACKWARDS = first(forall(k, 0, n, X[n - k] == Zero(d, d)))
FORWARDS = first(forall(k, 0, n, (X[n - k] == X[n - k]) & (X[k] == Zero(d, d))))


def _chain(says, *lemmas):
    data = Statement(**CHAIN, says=says).to_json()
    hints = json.loads(json.dumps(dict(induction(before=lemmas).hints), default=dict))
    return data, find_induction(data, hints)


def test_lemmas_with_an_index_of_their_own():
    """One induction backwards, which the next uses at every index of its range; without it there is no proof."""
    data, found = _chain(forall(k, 0, n, X[k] == Zero(d, d)), BACKWARDS, FORWARDS)
    replay(seal("T", "word induction", data, found))
    assert _chain(forall(k, 0, n, X[k] == Zero(d, d)))[1] is None
    for keep in (0, 1):
        with pytest.raises(Rejected):
            replay(seal("T", "word induction", data, {**found, "before": [found["before"][keep]]}))


def test_a_lemma_is_not_used_out_of_its_range():
    """Shown for k < n, it says nothing about X_n."""
    part = first(forall(k, 0, n - 1, X[n - 1 - k] == A * X[n - k]))
    free = {**CHAIN, "given": CHAIN["given"][:1]}
    hints = json.loads(json.dumps(dict(induction(before=[part]).hints), default=dict))
    good, bad = (Statement(**free, says=forall(k, 0, n - b, (X[n - b - k] == X[n - b - k]) & (X[n - 1 - k] == A * X[n - k]))).to_json() for b in (1, 0))
    assert find_induction(good, hints) is not None
    assert find_induction(bad, hints) is None


@pytest.mark.parametrize("lemma", [inv(X[k]) * X[k] == I(d), X[k] == Zero(d, d), A == Zero(d, d)])
def test_a_lemma_is_shown(lemma):
    """A false lemma, or one that inverts what need not be invertible, proves nothing."""
    data, found = _chain(forall(k, 0, n, X[k] == X[k]), BACKWARDS)
    false = Statement(sizes=["d", "n"], over=CHAIN["over"], says=forall(k, 0, n, A == Zero(d, d))).to_json()
    replay(seal("T", "word induction", data, found))
    made = first(forall(k, 0, n, lemma))
    hints = json.loads(json.dumps(dict(induction(before=[made]).hints), default=dict))
    assert find_induction(false, hints) is None
    proofs = [[{"sum": [], "blocks": [[]]}] * 2] * 2
    parts = [{"parts": part, "lemmas": []} for part in proofs]
    with pytest.raises(Rejected):
        replay(seal("T", "word induction", false, {**found, "before": [{"says": hints["before"][0]["says"], "also": [], "proofs": parts}]}))


def test_the_engine_tries_it():
    """A conclusion for all t over named sizes is proved without being asked, and its mutants are rejected."""
    parts, _ = TRUE["transposed products"]
    result = verify_statement(Statement(**parts), [instances(8, d=(1, 2), horizon=3)])
    assert (result["verdict"], result["strength"], result["mutants"]["survivors"]) == ("holds", "proved", [])


#: X_t = A^t two ways round; W starts where X ends
POWERS = {"sizes": ["d", "n", "p"], "over": {"A": matrix(d, d)},
          "where": [rec(X, t, I(d), A * X[t]), rec(Y, t, I(d), Y[t] * A), rec(R, t, X[n], A * R[t]), rec(S, t, Y[n], A * S[t])]}
SAME = forall(t, 0, n, (X[t] == Y[t]) & (A * Y[t] == Y[t] * A))
AFTER = forall(t, 0, p, R[t] == S[t])


def test_what_a_conjunct_says_may_be_used_for_those_after_it():
    """At the indices of its range, and the proof of the later one is none without it."""
    data = Statement(says=SAME & AFTER, **POWERS).to_json()
    found = find_induction(data)
    assert found is not None
    replay(seal("T", "word induction", data, found))
    alone = Statement(says=AFTER, **POWERS).to_json()
    assert find_induction(alone) is None
    with pytest.raises(Rejected):
        replay(seal("T", "word induction", alone, {**found, "conjuncts": found["conjuncts"][1:]}))


@pytest.mark.parametrize("says", [AFTER & SAME, forall(t, 0, n - 1, (X[t] == Y[t]) & (A * Y[t] == Y[t] * A)) & AFTER, AFTER & AFTER])
def test_a_conjunct_is_not_used_for_those_before_it_nor_out_of_its_range(says):
    """Not for itself either."""
    assert find_induction(Statement(says=says, **POWERS).to_json()) is None


def test_a_size_called_t_is_not_the_index():
    """The letter X[t] of a size t and that of the index t would be one."""
    says = {"sizes": ["t"], "over": {"A": matrix(t, t)}, "where": [rec(X, k, I(t), A * X[k])], "says": always(k, X[k] == X[k])}
    assert find_induction(Statement(**says).to_json()) is None


def test_two_things_of_one_name_are_refused():
    """A variable and a recursion X: on instances X is the variable, so a proof about the recursion says nothing."""
    statement = Statement(sizes=["d"], over={"A": matrix(d, d)}, where=[rec(X, t, I(d), X[t])], says=always(t, X[t] == I(d))).to_json()
    assert find_induction(statement) is not None
    both = {**statement, "over": [["X", ["signal_of", 0, ["matrix", ["sym", "d"], ["sym", "d"]]]], *statement["over"]]}
    assert find_induction(both) is None


def test_sequences_of_matrices_on_instances():
    """Types of sequences are read and tested by both evaluators."""
    for kind, extra in ((sequence_of(positive_definite(d), 1, n), ()), (signal_of(positive_definite(d), 1), ())):
        statement = Statement(sizes=["d", "n"], over={"R": kind, "x": scalar()}, says=forall(k, 1, n, loewner(R[k], 0 * R[k])), given=extra).to_json()
        for second, expected in (([[2]], True), ([[-2]], False)):
            instance = {"sizes": {"d": 1, "n": 2}, "values": {"R": [[[1]], second], "x": 0}}
            world = World(statement, read_instance(statement, instance))
            assert (admissible(statement, world) == "") is admissible_again(statement, instance) is expected
            assert world.value(statement["says"]) is evaluate(statement, instance) is expected


@pytest.mark.parametrize("kind", [scalar(), "matrix", ("matrices", 1)])
def test_sequences_of_what_is_no_matrix(kind):
    """The message says which types there are for scalars."""
    with pytest.raises(BadInput, match="type"):
        sequence_of(kind, 0, 3)
