# SPDX-License-Identifier: MIT
"""Stable matrices, bases of null spaces, ranks by factors, inequations and powers of a size: true neighbours are accepted, false ones are not."""

from __future__ import annotations

import json

import pytest

from exactkf.evidence import EIGENVALUE, EIGENVECTOR, induction, null_vector, order, within
from exactkf.finders.membership import find_induction, find_order
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.order import Leaf, leaves
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import (
    Identity,
    Statement,
    T,
    Zero,
    always,
    det,
    function,
    given,
    inv,
    invertible,
    kernel_basis,
    let,
    matrix,
    nonsingular,
    nonzero,
    pd,
    positive_semidefinite,
    psd,
    rank,
    rec,
    scalar,
    schur,
    size_of,
    standing,
    symbols,
    symmetric_matrix,
    vector,
)

I = Identity
n, m, r, k = symbols("n m r k")
A, B, C, M, N, P, Q, X, Y, S, K, L, x, y, t, s = symbols("A B C M N P Q X Y S K L x y t s")
(v, w), (re, im) = EIGENVECTOR, EIGENVALUE
OUTSIDE = re * re + im * im - 1
SQUARE = {"sizes": ["n"], "over": {M: matrix(n, n), N: matrix(n, n), X: matrix(n, n), Q: positive_semidefinite(n)}}


def statement(says, hypotheses=(), **more):
    parts = {**SQUARE, **more}
    over = {key.tree[1]: kind for key, kind in parts.pop("over").items()}
    labelled = [standing(f"h{number}", formula) for number, formula in enumerate(hypotheses)]
    return Statement(says=says, over=over, given=labelled, **parts).to_json()


def certificate(data, evidence):
    """What the finder makes of the hints, or None."""
    hints = json.loads(json.dumps(evidence.hints))
    parts = find_order(data, hints["sums"], hints["roots"], hints["lemmas"], factors=hints["factors"], inside=hints["inside"], stable=hints["stable"])
    return None if parts is None else seal("T", "order", data, {"parts": parts, "lemmas": hints["lemmas"], "inside": hints["inside"]})


LYAPUNOV = X == M * X * T(M) + Q
TRUE = {
    "a solution of a Stein equation is semidefinite": (statement(psd(X), [schur(M), LYAPUNOV]), order([Q], inside=[within(0, stein=M)])),
    "and definite": (statement(pd(X), [schur(T(M)), LYAPUNOV, pd(Q)]), order([Q], inside=[within(0, stein=M)])),
    "it is the only one": (statement(X == Y, [schur(M), LYAPUNOV, Y == M * Y * T(M) + Q], over={**SQUARE["over"], Y: matrix(n, n)}),
                           order(inside=[within(0, unique=(M, T(M)))])),
    "X = MXN": (statement(X == Zero(n, n), [schur(M), schur(N), X == M * X * N]), order(inside=[within(0, unique=(M, N))])),
    "no eigenvector on the circle": (
        statement((x == Zero(n, 1)) & (y == Zero(n, 1)), [schur(M), M * x == t * x - s * y, M * y == s * x + t * y, t * t + s * s >= 1],
                  over={**SQUARE["over"], x: vector(n), y: vector(n), t: scalar(), s: scalar()}),
        order(*[[T(x) * x, T(y) * y, (t * t + s * s - 1) * T(x) * S * x, (t * t + s * s - 1) * T(y) * S * y]] * 2,
              inside=[within(number, solutions={S: (T(M), I(n))}) for number in (0, 1)])),
    "Lyapunov's criterion": (
        statement(schur(M), [pd(P), P == T(M) * P * M + Q, pd(Q)], over={**SQUARE["over"], P: symmetric_matrix(n)}),
        order([], [T(v) * Q * v, T(w) * Q * w, OUTSIDE * T(v) * P * v, OUTSIDE * T(w) * P * w], [T(v) * Q * v, T(w) * Q * w, OUTSIDE * T(v) * P * v,
                                                                                               OUTSIDE * T(w) * P * w], [inv(Q)],
              inside=[within(0, (T(v) * Q * v + T(w) * Q * w + OUTSIDE * (T(v) * P * v + T(w) * P * w)) * I(1) == Zero(1, 1), Q * v == Zero(n, 1),
                             Q * w == Zero(n, 1), vector="right")])),
    "a transpose is stable": (statement(schur(T(M)), [schur(M)]), order()),
    "rank by factors": (statement(rank(B * C) == r, [rank(B) == r, rank(C) == r], sizes=["n", "m", "r"], over={B: matrix(n, r), C: matrix(r, m)}),
                        order([B, C, inv(T(B) * B) * T(B), T(C) * inv(C * T(C))])),
    "a basis of a null space": (statement((M * K == Zero(n, size_of(T(K)))) & (rank(K) == size_of(T(K))), where=[let(K, kernel_basis(M))]), order()),
    "it spans": (statement(x == K * L * x, [M * x == Zero(n, 1), L * K == I(size_of(T(K)))], where=[let(K, kernel_basis(M)), let(L, inv(T(K) * K) * T(K))],
                           over={**SQUARE["over"], x: vector(n)}), order()),
    "what differs, differs after a nonsingular matrix": (statement(A * x != A * y, [x != y], over={A: nonsingular(n), x: vector(n), y: vector(n)}), order()),
    "a power of a size": (statement(det(t * I(n)) * t ** (k - n) == t**k, sizes=["n", "k"], over={t: nonzero()}), order()),
}


@pytest.mark.parametrize("name", TRUE)
def test_true_statements_are_proved(name):
    """A certificate is found, and replays; without its parts it does not."""
    made = certificate(*TRUE[name])
    assert made is not None
    replay(made)
    with pytest.raises(Rejected):
        replay(seal("T", "order", made["statement"], {**made["evidence"], "parts": made["evidence"]["parts"][1:]}))


FALSE = {
    "no hypothesis says stable": (statement(psd(X), [LYAPUNOV]), order([Q], inside=[within(0, stein=M)])),
    "another matrix is stable": (statement(psd(X), [schur(N), LYAPUNOV]), order([Q], inside=[within(0, stein=M)])),
    "definite without reason": (statement(pd(X), [schur(M), LYAPUNOV]), order([Q], inside=[within(0, stein=M)])),
    "one of two is stable": (statement(X == Zero(n, n), [schur(M), X == M * X * N]), order(inside=[within(0, unique=(M, N))])),
    "the product of two stable matrices": (statement(schur(M * N), [schur(M), schur(N)]), order(inside=[within(0, vector="right")])),
    "two matrices for an order": (statement(psd(X), [schur(M), schur(N), X == M * X * N + Q]), order([Q], inside=[within(0, unique=(M, N))])),
    "the solution of an indefinite equation": (
        statement(psd(X), [schur(M), X == M * X * T(M) + P], over={**SQUARE["over"], P: symmetric_matrix(n)}),
        order([S], inside=[within(0, solutions={S: (M, P)})])),
    "a solution for no stable matrix": (statement(psd(X), [LYAPUNOV]), order([S], inside=[within(0, solutions={S: (M, Q)})])),
    "an eigenvector inside": (
        statement(x == Zero(n, 1), [schur(M), M * x == t * x], over={**SQUARE["over"], x: vector(n), t: scalar()}),
        order([T(x) * x, (t * t - 1) * T(x) * S * x], inside=[within(0, solutions={S: (T(M), I(n))})])),
    "stability by lemma of a matrix that need not exist": (
        statement(M == N, [M * X == N * X], over={M: matrix(n, n), N: matrix(n, n), X: matrix(n, n)}),
        order([], [], lemmas=[schur(0 * inv(X))], inside=[within(0, vector="right")])),
    "rank by factors of another size": (
        statement(rank(B * C) == m, [rank(B) == r, rank(C) == r], sizes=["n", "m", "r"], over={B: matrix(n, r), C: matrix(r, m)}),
        order([B, C, inv(T(B) * B) * T(B), T(C) * inv(C * T(C))])),
    "rank by a factor without full rank": (
        statement(rank(B * C) == r, [rank(B) == r], sizes=["n", "m", "r"], over={B: matrix(n, r), C: matrix(r, m)}),
        order([B, C, inv(T(B) * B) * T(B), T(C) * inv(C * T(C))])),
    "a basis is no orthogonal one": (statement(T(K) * K == I(size_of(T(K))), where=[let(K, kernel_basis(M))]), order()),
    "a null space is not all": (statement(rank(K) == n, where=[let(K, kernel_basis(M))]), order()),
    "what differs, after a singular matrix": (statement(A * x != A * y, [x != y], over={A: matrix(n, n), x: vector(n), y: vector(n)}), order()),
    "differing without reason": (statement(x != y, over={x: vector(n), y: vector(n)}), order()),
    "another power of a size": (statement(det(t * I(n)) == t, over={t: nonzero()}), order()),
    "a power that may be none": (statement(t ** (k - n) * t**n == t**k, sizes=["n", "k"], over={t: scalar()}), order()),
    "the determinant of a negative": (statement(det(-I(n)) == -1, over={}), order()),
}


@pytest.mark.parametrize("name", FALSE)
def test_false_statements_are_not(name):
    """Nothing is found for them."""
    assert certificate(*FALSE[name]) is None


@pytest.mark.parametrize("help_", [{"unique": [M.tree, N.tree]}, {"stein": M.tree, "unique": [M.tree, N.tree]}])
def test_an_order_takes_one_stable_matrix(help_):
    """X = MXN + Q does not make X semidefinite: such help is refused for an order, however the rest is proved."""
    data = statement(psd(X), [schur(M), schur(N), X == M * X * N + Q])
    (case, formula), = leaves(data)
    with pytest.raises(Unknown, match="stable"):
        Leaf(case, formula, [json.loads(json.dumps(Q.tree))], **json.loads(json.dumps(help_)))


def test_an_equation_takes_two():
    """D - MDM' = a semidefinite matrix does not make D zero: ``stein`` is refused for an equation."""
    (case, formula), = leaves(statement(X == Zero(n, n), [schur(M), LYAPUNOV]))
    with pytest.raises(Unknown, match="stable"):
        Leaf(case, formula, [], stein=["sym", "M"])


def test_a_solution_takes_no_name():
    """The letter of a solution is not one that the statement has."""
    (case, formula), = leaves(statement(psd(X), [schur(M), LYAPUNOV]))
    for name in ("X", "Q", "M'", "n"):
        with pytest.raises(Unknown, match="solution"):
            Leaf(case, formula, [["sym", "Q"]], solutions=[[name, ["sym", "M"], ["sym", "Q"]]])


def test_eigenvectors_are_taken_of_a_matrix_that_exists():
    """The inverse in schur(X^-1 ...) as a lemma needs a reason, also where the lemma is said through an eigenvector."""
    data = statement(M == M)
    lemma = json.loads(json.dumps(schur(inv(X) * M).tree))
    case, formula = next(iter(leaves(data, [lemma], [[0, "right", []]])))
    assert formula[0] == "="
    with pytest.raises(Unknown, match="lemma"):
        Leaf(case, formula, [])


def test_a_vector_stands_for_one_leaf():
    """What is assumed of the vector of one leaf is not there for the next."""
    data = statement(invertible(I(n) + Q) & (M == N))
    hints = order([Q], [], inside=[within(0, M * null_vector() == M * null_vector(), vector="right")]).hints
    made = list(leaves(data, [], json.loads(json.dumps(hints["inside"]))))
    assert "v.0" in str(made[1][0]["over"]) and "v.0" not in str(made[2][0]["over"]) and "inner lemma" not in str(made[2][0]["given"])


def test_a_size_is_a_name():
    """A type may not name the size of a null space, which the checker makes."""
    data = statement(x == x, over={x: vector(n)})
    data["over"][0][1][1] = ["sym", "nullity of [n x n: M]"]
    with pytest.raises(Rejected, match="size|name"):
        replay(seal("T", "order", data, {"parts": [{"sum": [], "blocks": [[]]}]}))


def test_the_size_of_an_argument_is_not_that_of_a_variable():
    """I(rows of X) in a function of X is of the size of the argument."""
    f = symbols("f")[0]
    data = statement(f[Y] * B == B, sizes=["n", "m"], over={X: matrix(m, m), Y: matrix(n, n), B: matrix(m, n)}, where=[function(f, [X], I(size_of(X)))])
    assert certificate(data, order()) is None


def test_each_conjunct_has_its_own_induction():
    """What is shown along with one conjunct is not there for another."""
    says = always(t, X[t] == Zero(n, n)) & always(t, Y[t] == Zero(n, n))
    both = [rec(X, t, Zero(n, n), M * X[t]), rec(Y, t, Zero(n, n), X[t])]
    data = Statement(says=says, sizes=["n"], over={"M": matrix(n, n)}, where=both, given=[given("h", M == M)]).to_json()

    def found(*also):
        hints = json.loads(json.dumps(induction(also=also).hints))
        return find_induction(data, hints)

    assert found() is None and found([X[t] == Zero(n, n)], []) is None
    made = found([], [X[t] == Zero(n, n)])
    assert made is not None
    replay(seal("T", "word induction", data, made))
    for also in ([made["also"][1], made["also"][0]], [], [[]]):
        with pytest.raises((Rejected, Undefined)):
            replay(seal("T", "word induction", data, {**made, "also": also}))
