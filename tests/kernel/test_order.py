# SPDX-License-Identifier: MIT
"""Matrix order for every size: sums and congruences are accepted, wrong signs and missing strictness are not."""

from __future__ import annotations

import json

import pytest

from exactkf._facts import facts_used
from exactkf.evidence import order
from exactkf.finders.membership import find_order
from exactkf.kernel.order import FACTS
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import (
    Identity,
    Statement,
    T,
    Zero,
    block,
    cospectral,
    det,
    function,
    iff,
    inv,
    invertible,
    let,
    loewner,
    matrix,
    nonneg,
    nonsingular,
    pd,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    scalar,
    similar,
    standing,
    symbols,
    symmetric_matrix,
    vector,
)

n, p, P, Q, A, M, V, K, H = symbols("n p P Q A M V K H")
I = Identity
FILTER = {"sizes": ["n", "p"], "over": {"P": positive_semidefinite(n), "H": positive_semidefinite(n), "A": matrix(n, n), "M": matrix(p, n),
                                              "V": positive_definite(p)},
          "where": [let(K, P * T(M) * inv(M * P * T(M) + V))]}
JOSEPH = A * ((I(n) - K * M) * P * T(I(n) - K * M) + K * V * T(K)) * T(A) + H
STEP = A * (P - K * M * P) * T(A) + H

TRUE = {
    "a sum of congruences": ({**FILTER, "says": psd(JOSEPH)}, ()),
    "the covariance step": ({**FILTER, "says": psd(STEP)}, [[JOSEPH]]),
    "innovation covariance": ({**FILTER, "says": pd(M * P * T(M) + V)}, ()),
    "an inverse": ({**FILTER, "says": pd(inv(V) + M * P * T(M))}, ()),
    "nonsingular congruence": ({"sizes": ["n"], "over": {"P": positive_definite(n), "A": nonsingular(n)}, "says": pd(T(A) * P * A)}, ()),
    "a Gram matrix": ({"sizes": ["n", "p"], "over": {"M": matrix(p, n)}, "says": psd(T(M) * M)}, ()),
    "order from a hypothesis": ({"sizes": ["n"], "over": {"P": symmetric_matrix(n), "Q": symmetric_matrix(n), "A": matrix(n, n)},
                                "given": [standing("order", loewner(P, Q))], "says": loewner(A * P * T(A), A * Q * T(A))}, [[A * (P - Q) * T(A)]]),
}
B, S, L, X = symbols("B S L X")
SQUARES = {"sizes": ["n"], "over": {"P": positive_semidefinite(n), "Q": positive_semidefinite(n)}}
PAIR = {"sizes": ["n"], "over": {"A": matrix(n, n), "B": matrix(n, n)}}
LEAVES = {
    "a Gram matrix plus I": ({**PAIR, "says": invertible(I(n) + T(A) * A)}, (), {}),
    "I + PQ": ({**SQUARES, "says": invertible(I(n) + P * Q)}, [[I(n) - S * inv(I(n) + S * Q * S) * S * Q]], {S: P}),
    "what follows uses what was shown": ({**SQUARES, "says": invertible(I(n) + P * Q) & pd(I(n) + P * Q * inv(I(n) + P * Q) * P)},
                                         [[I(n) - P * S * inv(I(n) + S * P * S) * S], [I(n), P * S * inv(I(n) + S * P * S) * S * P]], {S: Q}),
    "an implication": ({**PAIR, "says": (A * T(A) == I(n)) >> (T(A) * A == I(n))}, (), {}),
    "an equivalence": ({**PAIR, "given": [standing("symmetric", T(A) == A)], "says": iff(A == B, T(B) == A)}, (), {}),
    "each alternative": ({**SQUARES, "given": [standing("one", invertible(P) | invertible(Q))], "says": pd(P + Q)}, (), {}),
}
x = symbols("x")[0]
VECTOR = {**SQUARES, "over": {**SQUARES["over"], "x": vector(n), "A": matrix(n, n)}}
LEAVES |= {
    "null vectors of a sum": ({**VECTOR, "given": [standing("null", (P + Q) * x == 0)], "says": (P * x == 0) & (Q * x == 0)}, [[P, Q], [P, Q]], {}),
    "null vectors of a congruence": ({**VECTOR, "says": (T(A) * P * A * x == Zero(n, 1)) >> (P * A * x == Zero(n, 1))}, [[T(A) * P * A]], {}),
}
c = symbols("c")[0]
m = symbols("m")[0]
WITH_SCALAR = {**SQUARES, "over": {**SQUARES["over"], "c": nonneg(), "x": vector(n)}}
INFORMATION = I(n) - P * x * T(x) / (1 + T(x) * P * x)
LOWER = block([[I(n), Zero(n, m)], [T(B) * inv(A), I(m)]])
LEAVES |= {
    "a nonnegative number": ({**WITH_SCALAR, "says": psd(c * P + Q)}, (), {}),
    "a square": ({**WITH_SCALAR, "over": {**WITH_SCALAR["over"], "c": scalar()}, "says": psd(P * c**2)}, (), {}),
    "a quadratic form": ({**WITH_SCALAR, "says": T(x) * P * x >= 0}, (), {}),
    "an update by a scalar": ({**WITH_SCALAR, "says": psd(P - P * x * T(x) * P / (1 + T(x) * P * x))},
                              [[INFORMATION * P * T(INFORMATION) + P * x * (1 / (1 + T(x) * P * x) ** 2) * T(x) * P]], {}),
    "full column rank": ({"sizes": ["n", "m"], "over": {"A": matrix(m, n), "P": positive_definite(m)}, "given": [standing("rank", rank(A) == n)],
                          "says": pd(T(A) * P * A)}, (), {}),
    "a block diagonal matrix": ({**SQUARES, "says": psd(block([[P, Zero(n, n)], [Zero(n, n), Q]]))}, (), {}),
    "a Schur complement": ({"sizes": ["n", "m"], "over": {"A": positive_definite(n), "B": matrix(n, m), "P": symmetric_matrix(m)},
                            "given": [standing("complement", psd(P - T(B) * inv(A) * B))], "says": psd(block([[A, B], [T(B), P]]))},
                           [[LOWER * block([[A, Zero(n, m)], [Zero(m, n), P - T(B) * inv(A) * B]]) * T(LOWER)]], {}),
}
R = symbols("R")[0]
RECTANGULAR = {"sizes": ["n", "m"], "over": {"A": matrix(n, m), "B": matrix(m, n)}}
SCHUR = {"sizes": ["n", "m"], "over": {"A": nonsingular(n), "B": matrix(n, m), "L": matrix(m, n), "P": matrix(m, m)}}
WHOLE, REST = block([[A, B], [L, P]]), P - L * inv(A) * B
LEAVES |= {
    "null vectors of a form": ({**VECTOR, "given": [standing("null", T(x) * (P + Q) * x == 0)], "says": P * x == 0}, [[P, Q]], {}),
    "I + PQ by null vectors": ({**SQUARES, "says": invertible(I(n) + P * Q)}, [[Q, Q * P * Q]], {}),
    "a saddle point matrix": ({"sizes": ["n", "p"], "over": {"R": positive_semidefinite(p), "H": matrix(p, n)},
                               "given": [standing("columns", rank(H) == n), standing("rows", rank(block([[R, H]])) == p)],
                               "says": invertible(block([[R, H], [T(H), Zero(n, n)]]))}, [[R]], {}),
    "rank of a product": ({**RECTANGULAR, "over": {**RECTANGULAR["over"], "P": nonsingular(m)}, "given": [standing("rank", rank(B) == n)],
                           "says": rank(P * B) == n}, (), {}),
    "a bound of a rank": ({**RECTANGULAR, "says": rank(A * B) <= m}, [[A, B]], {}),
    "rank of a transpose": ({**RECTANGULAR, "given": [standing("rank", rank(A) == n)], "says": rank(T(A)) == n}, (), {}),
    "similar products": ({**PAIR, "over": {"A": nonsingular(n), "B": matrix(n, n)}, "says": similar(A * B, B * A)}, (), {}),
    "a congruence of both": ({"sizes": ["n"], "over": {"A": nonsingular(n), "P": positive_definite(n), "Q": positive_definite(n)},
                              "says": cospectral(A * P * T(A) * inv(A * Q * T(A)), P * inv(Q))}, (), {}),
    "determinant of a conjugate": ({**PAIR, "over": {"A": nonsingular(n), "B": matrix(n, n)}, "says": det(A * B * inv(A)) == det(B)}, (), {}),
}
DETERMINANTS = {
    "det(I + AB)": ({**RECTANGULAR, "says": det(I(n) + A * B) == det(I(m) + B * A)},
                    [(block([[I(n), -A], [B, I(m)]]), [block([[I(n) + A * B, -A], [Zero(m, n), I(m)]]), block([[I(n), Zero(n, m)], [B, I(m)]])]),
                     (block([[I(n), -A], [B, I(m)]]), [block([[I(n), Zero(n, m)], [B, I(m)]]), block([[I(n), -A], [Zero(m, n), I(m) + B * A]])])]),
    "Schur": ({**SCHUR, "says": det(WHOLE) == det(A) * det(REST)},
              [(WHOLE, [block([[I(n), Zero(n, m)], [L * inv(A), I(m)]]), block([[A, B], [Zero(m, n), REST]])])]),
}
NOT_LEAVES = {
    "rank from the other rank": ({**RECTANGULAR, "given": [standing("rank", rank(A) == n)], "says": rank(A) == m}, (), {}),
    "not square": ({**RECTANGULAR, "given": [standing("rank", rank(A) == n)], "says": invertible(A)}, (), {}),
    "a form that is indefinite": ({**VECTOR, "given": [standing("null", T(x) * (P - Q) * x == 0)], "says": P * x == 0}, [[P, -Q]], {}),
    "similar by a singular matrix": ({**PAIR, "says": similar(A * B, B * A)}, [[A]], {}),
    "a sum of determinants": ({**PAIR, "says": det(A + B) == det(A) + det(B)}, (), {}),
    "twice a matrix": ({**PAIR, "says": det(2 * A) == 2 * det(A)}, (), {}),
    "a number of unknown sign": ({**WITH_SCALAR, "over": {**WITH_SCALAR["over"], "c": scalar()}, "says": psd(c * P)}, [[c * P]], {}),
    "a number that may vanish": ({**WITH_SCALAR, "over": {"P": positive_definite(n), "c": nonneg()}, "says": pd(c * P)}, [[c * P]], {}),
    "a division by what may vanish": ({**WITH_SCALAR, "says": pd(I(n) * c)}, [[I(n) / c * c * c]], {}),
    "rank of the other side": ({"sizes": ["n", "m"], "over": {"A": matrix(m, n), "P": positive_definite(m)}, "given": [standing("rank", rank(A) == m)],
                                "says": pd(T(A) * P * A)}, [[T(A) * P * A]], {}),
    "blocks beside the diagonal": ({**SQUARES, "says": psd(block([[P, Q], [Q, P]]))}, [[block([[P, Q], [Q, P]])]], {}),
    "an inverse hidden in a function, inside another": (
        {**PAIR, "where": [function(K, [B], inv(B))], "says": invertible(A)}, [[inv(I(n) + T(K(A)) * K(A)) * (I(n) + T(K(A)) * K(A)) * K(A)]], {}),
    "an inverse behind a premise": ({**VECTOR, "says": ((P == Q) >> (inv(A) == inv(A))) & ((A * x == Zero(n, 1)) >> (x == Zero(n, 1)))}, (), {}),
    "an inverse of the other alternative": ({**VECTOR, "given": [standing("one", (A == Q) | (inv(A) * P == Q))],
                                             "says": (A * x == Zero(n, 1)) >> (x == Zero(n, 1))}, (), {}),
    "null vectors of a difference": ({**VECTOR, "given": [standing("null", (P - Q) * x == 0)], "says": P * x == 0}, [[P, -Q]], {}),
    "null vectors of one part": ({**VECTOR, "given": [standing("null", (P + Q) * x == 0)], "says": A * x == 0}, [[P, Q]], {}),
    "terms that do not add up": ({**VECTOR, "given": [standing("null", P * x == 0)], "says": Q * x == 0}, [[P, Q]], {}),
    "null vectors of a product": ({**VECTOR, "given": [standing("null", P * Q * x == 0)], "says": Q * x == 0}, [[P * Q]], {}),
    "I - PQ": ({**SQUARES, "says": invertible(I(n) - P * Q)}, [[I(n) + S * inv(I(n) - S * Q * S) * S * Q]], {S: P}),
    "semidefinite through its inverse": ({**SQUARES, "says": pd(P)}, [[inv(inv(P))]], {}),
    "an inverse that is hidden in a function": ({**PAIR, "where": [function(K, [B], inv(B))], "says": invertible(A)}, [[K(A)]], {}),
    "an inverse that is assumed": ({**PAIR, "says": invertible(A)}, [[inv(A)]], {}),
    "one-sided and not square": ({"sizes": ["n", "p"], "over": {"M": matrix(p, n), "X": matrix(n, p)}, "given": [standing("one", X * M == I(n))],
                                  "says": invertible(X)}, [[M]], {}),
    "root of an indefinite matrix": ({"sizes": ["n"], "over": {"P": symmetric_matrix(n)}, "says": psd(P)}, [[S * S]], {S: P}),
    "the other alternative": ({**SQUARES, "given": [standing("one", invertible(P) | invertible(Q))], "says": pd(P)}, (), {}),
    "a converse": ({**PAIR, "says": (A * B == B * A) >> (A == B)}, (), {}),
}
FALSE = {
    "minus a Gram matrix": {"sizes": ["n", "p"], "over": {"M": matrix(p, n)}, "says": psd(-T(M) * M)},
    "strict without reason": {"sizes": ["n", "p"], "over": {"M": matrix(p, n)}, "says": pd(T(M) * M)},
    "singular congruence": {"sizes": ["n"], "over": {"P": positive_definite(n), "A": matrix(n, n)}, "says": pd(T(A) * P * A)},
    "symmetric is not semidefinite": {"sizes": ["n"], "over": {"P": symmetric_matrix(n)}, "says": psd(P)},
    "a product of two": {"sizes": ["n"], "over": {"P": positive_semidefinite(n), "Q": positive_semidefinite(n)}, "says": psd(P * Q)},
    "a square that is no Gram matrix": {"sizes": ["n"], "over": {"A": matrix(n, n)}, "says": psd(A * A)},
    "a difference": {"sizes": ["n"], "over": {"P": positive_semidefinite(n), "Q": positive_semidefinite(n)}, "says": loewner(P, Q)},
}


@pytest.mark.parametrize("name", TRUE)
def test_true_order_is_proved(name):
    """A certificate is found and replays."""
    parts, sums = TRUE[name]
    data = Statement(**parts).to_json()
    found = find_order(data, json.loads(json.dumps([[t.tree for t in terms] for terms in sums])))
    assert found is not None
    replay(seal("T", "order", data, {"parts": found}))


@pytest.mark.parametrize("name", FALSE)
def test_false_order_is_not(name):
    """Nothing is found, and the matrix itself is not accepted as a semidefinite term."""
    data = Statement(**FALSE[name]).to_json()
    assert find_order(data) is None
    goal = data["says"][1] if data["says"][0] != "loewner" else ["-", *data["says"][1:]]
    with pytest.raises(Rejected):
        replay(seal("T", "order", data, {"parts": [{"sum": [goal], "terms": []}]}))


def _found(parts, sums, roots):
    hints = order(*sums, roots=roots).hints
    data = Statement(**parts).to_json()
    return data, find_order(data, *json.loads(json.dumps([hints[key] for key in ("sums", "roots", "lemmas")])))


@pytest.mark.parametrize("name", LEAVES)
def test_leaves_are_proved(name):
    """Invertibility, equations, implications and alternatives, each leaf with its own proof."""
    data, found = _found(*LEAVES[name])
    assert found is not None
    replay(seal("T", "order", data, {"parts": found}))


NAMED = {
    "a sum of congruences": {"hypothesis", "sum", "congruence"}, "innovation covariance": {"hypothesis", "sum", "congruence"},
    "a nonnegative number": {"hypothesis", "number", "sum"}, "a Gram matrix": {"congruence"}, "a block diagonal matrix": {"hypothesis", "block diagonal"},
    "nonsingular congruence": {"hypothesis", "congruence", "nonsingular"}, "an inverse": {"hypothesis", "sum", "congruence", "inverse"},
    "a Gram matrix plus I": {"identity", "sum", "congruence", "nonsingular", "right inverse"}, "an implication": set(),
    "null vectors of a sum": {"hypothesis", "sum", "null vectors"}, "null vectors of a congruence": {"hypothesis", "congruence", "null vectors"},
    "a bound of a rank": {"rank"},
    "rank of a product": {"null space", "nonsingular"}, "similar products": {"similarity", "nonsingular"},  # with inverses that are brought in
}


@pytest.mark.parametrize("name", NAMED)
def test_the_facts_of_a_certificate_are_named(name):
    """Those that it uses, and no others."""
    parts, sums, roots = LEAVES[name] if name in LEAVES else (*TRUE[name], {})
    data, found = _found(parts, sums, roots)
    certificate = seal("T", "order", data, {"parts": found})
    replay(certificate)
    assert NAMED[name] == set(facts_used(certificate))
    assert facts_used(certificate) == [fact for fact in FACTS if fact in NAMED[name]]


def test_facts_of_roots_and_factors():
    """A square root, and a product of determinants, are facts of their own."""
    data, found = _found(*LEAVES["I + PQ"])
    assert {"square root", "right inverse"} <= set(facts_used(seal("T", "order", data, {"parts": found})))
    parts, factors = DETERMINANTS["Schur"]
    data = Statement(**parts).to_json()
    found = find_order(data, factors=json.loads(json.dumps(order(factors=factors).hints["factors"])))
    assert ["determinant"] == facts_used(seal("T", "order", data, {"parts": found}))


@pytest.mark.parametrize("name", NOT_LEAVES)
def test_wrong_leaves_are_not(name):
    """Neither found, nor accepted with the terms claimed."""
    data, found = _found(*NOT_LEAVES[name])
    assert found is None
    sums, roots = json.loads(json.dumps([order(*NOT_LEAVES[name][1], roots=NOT_LEAVES[name][2]).hints[k] for k in ("sums", "roots")]))
    proof = [{"sum": terms, "blocks": blocks, "roots": roots, "null": "null"} for terms in sums or [[]] for blocks in ([[]], [[], []])]
    for one in proof:
        with pytest.raises(Rejected):
            replay(seal("T", "order", data, {"parts": [one]}))


@pytest.mark.parametrize("name", DETERMINANTS)
def test_determinants_by_factors(name):
    """Factors that are multiplied out prove it; others, or none, do not."""
    parts, factors = DETERMINANTS[name]
    data = Statement(**parts).to_json()
    hints = json.loads(json.dumps(order(factors=factors).hints["factors"]))
    found = find_order(data, factors=hints)
    assert found is not None and find_order(data) is None
    replay(seal("T", "order", data, {"parts": found}))
    found[0]["factors"][0][1].reverse()
    with pytest.raises(Rejected):
        replay(seal("T", "order", data, {"parts": found}))


def test_a_lemma_is_shown_first():
    """A Gram matrix of an invertible matrix is definite once that is shown."""
    over = {**SQUARES, "says": pd(T(I(n) + P * Q) * (I(n) + P * Q))}
    data = Statement(**over).to_json()
    hints = order([I(n) - S * inv(I(n) + S * Q * S) * S * Q], [], roots={S: P}, lemmas=[invertible(I(n) + P * Q)]).hints
    sums, roots, lemmas = json.loads(json.dumps([hints[key] for key in ("sums", "roots", "lemmas")]))
    found = find_order(data, sums, roots, lemmas)
    assert found is not None
    replay(seal("T", "order", data, {"parts": found, "lemmas": lemmas}))
    with pytest.raises(Rejected):
        replay(seal("T", "order", data, {"parts": found[1:], "lemmas": []}))


def test_the_middle_of_a_congruence_need_not_be_semidefinite():
    """psd(A Q A') by hypothesis and A Q A' x = 0 do not give Q A' x = 0 for an indefinite Q."""
    from exactkf.kernel.order import Leaf, leaves
    from exactkf.language import vector

    x = symbols("x")[0]
    statement = Statement(sizes=["n"], over={"A": matrix(n, n), "Q": symmetric_matrix(n), "x": vector(n)},
                          given=[standing("psd", psd(A * Q * T(A))), standing("null", A * Q * T(A) * x == Zero(n, 1))],
                          says=Q * T(A) * x == Zero(n, 1)).to_json()
    terms = [list(statement["given"][0][1][1])]
    (case, formula), = leaves(statement)
    leaf = Leaf(case, formula, terms, (), "null")
    vanishing = [r for k in range(len(leaf.goals)) for name, r in leaf.assumed(k).items() if name.startswith("null ")]
    assert all(len(word) == 4 for relation in vanishing for _, word in relation.poly)


def test_a_lemma_may_not_bring_in_an_inverse_that_need_not_exist():
    """inv(A) in a lemma alone is not granted by the statement; with A nonsingular it is."""
    from exactkf.kernel.numbers import Unknown
    from exactkf.kernel.order import Leaf, leaves

    lemma = (inv(A) * A * Q == Q).tree
    for kind, granted in ((matrix(n, n), False), (nonsingular(n), True)):
        statement = Statement(sizes=["n"], over={"A": kind, "Q": matrix(n, n)}, says=A * Q == A * Q).to_json()
        case, formula = next(iter(leaves(statement, [lemma])))
        if granted:
            Leaf(case, formula, [])
        else:
            with pytest.raises(Unknown, match="lemma"):
                Leaf(case, formula, [])
