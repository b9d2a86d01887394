# SPDX-License-Identifier: MIT
"""Hamiltonian matrices: membership, factors and action."""

from itertools import product as cartesian

import pytest
from flint import fmpq_mat
from hypothesis import given
from hypothesis import strategies as st

from exactkf._errors import BadInput
from exactkf.theory import (
    from_factors,
    hamiltonian_matrix,
    is_symplectic,
    membership,
    moebius,
    negative_direction,
    nonpositive_direction,
    to_factors,
)

from .strategies import invertible, mat, matrices, nonnegative, rationals, rows


@st.composite
def factors(draw):
    """Triples A, P, Q of equal order with A invertible and P, Q nonnegative."""
    d = draw(st.integers(1, 3))
    return draw(invertible(d)), draw(nonnegative(d)), draw(nonnegative(d))


def minors(S):
    """Return all principal minors of a symmetric table."""
    d = len(S)
    chosen = ([i for i in range(d) if bits[i]] for bits in cartesian((0, 1), repeat=d) if any(bits))
    return [fmpq_mat([[S[i][j] for j in c] for i in c]).det() for c in chosen]


@given(st.integers(1, 4).flatmap(lambda d: matrices(d, d)), st.booleans())
def test_directions_against_principal_minors(table, shift):
    """A witness exists exactly if a principal minor has the wrong sign, and it is a witness."""
    S = mat(table) + mat(table).transpose()
    if shift:
        S += fmpq_mat([[8 if i == j else 0 for j in range(len(table))] for i in range(len(table))])
    table = rows(S)
    for search, good in ((negative_direction, lambda m: m >= 0), (nonpositive_direction, lambda m: m > 0)):
        x = search(table)
        assert (x is None) == all(good(m) for m in minors(table))
        if x is not None:
            column = fmpq_mat([[value] for value in x])
            assert any(x) and not good((column.transpose() * S * column)[0, 0])


@given(factors())
def test_factors_round_trip(triple):
    """The parametrisation by A, P, Q is a bijection onto its image, which lies in H."""
    M = from_factors(*triple)
    result = membership(M)
    assert to_factors(M) == triple and is_symplectic(M) and "H" in result
    assert ("H2" in result) == (mat(triple[1]).det() != 0)
    assert ("H1" in result) == (mat(triple[2]).det() != 0)
    assert ("H0" in result) == ("H1" in result and "H2" in result)


@given(st.data(), st.integers(1, 3))
def test_hamiltonian_matrix_is_in_h(data, d):
    """The matrix (7) of a system with invertible A lies in H and has the factors it should have."""
    A, F, C = data.draw(invertible(d)), data.draw(matrices(d, 2)), data.draw(matrices(1, d))
    M = hamiltonian_matrix(A, F, C)
    assert "H" in membership(M)
    first, P, Q = to_factors(M)
    inverse = mat(A).inv()
    assert first == A and mat(Q) == mat(C).transpose() * mat(C)
    assert mat(P) == inverse * mat(F) * mat(F).transpose() * inverse.transpose()


@given(st.data(), st.integers(1, 3))
def test_action_and_semigroup(data, d):
    """The action respects products, H is closed under products, and H1, H2 are ideals."""

    def element():
        return from_factors(data.draw(invertible(d)), data.draw(nonnegative(d)), data.draw(nonnegative(d)))

    M, N, T = element(), element(), data.draw(nonnegative(d))
    MN = rows(mat(M) * mat(N))
    assert moebius(MN, T) == moebius(M, moebius(N, T))
    sets = membership(MN)
    assert "H" in sets
    for name in ("H1", "H2", "H0"):
        assert name in sets or (name not in membership(M) and name not in membership(N))


@given(st.integers(1, 2).flatmap(lambda d: matrices(2 * d, 2 * d)))
def test_symplectic_against_the_definition(table):
    """The block conditions are equivalent to M^T J M = J."""
    d = len(table) // 2
    J = fmpq_mat([[int(j == i + d) - int(i == j + d) for j in range(2 * d)] for i in range(2 * d)])
    assert is_symplectic(table) == (mat(table).transpose() * J * mat(table) == J)


@given(rationals(), rationals(), rationals().filter(bool))
def test_order_two(b, c, a):
    """For d = 1 the symplectic matrices are those of determinant one."""
    assert is_symplectic([[a, b], [c, (1 + b * c) / a]])


@pytest.mark.parametrize(
    ("M", "name", "reason"),
    [
        ([[1, 0], [0, 2]], "Sp", "A^T D - C^T B is not the identity: its entry (1, 1) is 2"),
        (
            [[1, 0, 0, 0], [0, 1, 0, 0], [0, 1, 1, 0], [0, 0, 0, 1]],
            "Sp",
            "A^T C is not symmetric: its entries (2, 1) and (1, 2) are 0 and 1",
        ),
        ([[0, 1], [-1, 0]], "H", "A is singular"),
        ([[1, -1], [0, 1]], "H", "B A^T is not positive semidefinite: x = (1) gives x^T B A^T x = -1"),
        ([[1, 0], [0, 1]], "H1", "A^T C is not positive definite: x = (1) gives x^T A^T C x = 0"),
        ([[1, 0], [1, 1]], "H2", "B A^T is not positive definite: x = (1) gives x^T B A^T x = 0"),
        ([[1, 0], [1, 1]], "H0", "B A^T is not positive definite: x = (1) gives x^T B A^T x = 0"),
        (
            [[1, 0, 0, 0], [0, 1, 0, 0], [0, 1, 1, 0], [1, 0, 0, 1]],
            "H",
            "A^T C is not positive semidefinite: x = (1, -1) gives x^T A^T C x = -2",
        ),
    ],
)
def test_reasons(M, name, reason):
    """The reason names the condition that fails and a witness."""
    result = membership(M)
    assert name not in result and result.reasons[name] == reason


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: membership([[1]]), "M = ((1,),): has shape (1, 1)"),
        (lambda: hamiltonian_matrix([[0]], [[1]], [[1]]), "A = ((0,),): singular, its first column is zero"),
        (lambda: to_factors([[2, 0], [0, 1]]), "M = ((2, 0), (0, 1)): not symplectic, A^T D - C^T B"),
        (lambda: to_factors([[0, 1], [-1, 0]]), "the block A of M = ((0,),): singular"),
        (lambda: from_factors([[1, 0], [0, 1]], [[0, 1], [0, 0]], [[0, 0], [0, 0]]), "P = ((0, 1), (0, 0)): not symmetric"),
        (lambda: moebius([[1, 0], [1, 1]], [[-1]]), "CT + D = ((0,),): singular"),
        (lambda: negative_direction([[0, 1], [0, 0]]), "S = ((0, 1), (0, 0)): not symmetric"),
        (lambda: membership([[1, 2], [3]]), "M = [[1, 2], [3]]: has rows of lengths [2, 1]"),
        (lambda: membership([]), "M = []: not a matrix"),
        (lambda: membership([[0.5, 0], [0, 2]]), "M[0][0] = 0.5"),
    ],
)
def test_messages(call, text):
    """Every refusal names the argument in one line."""
    with pytest.raises(BadInput) as caught:
        call()
    assert str(caught.value).startswith(text) and "\n" not in str(caught.value)
