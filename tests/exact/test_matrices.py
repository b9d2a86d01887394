# SPDX-License-Identifier: MIT
"""Tests of exactkf.exact.matrices."""

from fractions import Fraction

import numpy as np
import pytest
import sympy
from flint import fmpq, fmpq_mat, fmpz_mat
from hypothesis import given, settings
from hypothesis import strategies as st

from exactkf._errors import BadInput
from exactkf.exact import matrices as m

few = settings(max_examples=35, deadline=None)
entries = st.fractions(-4, 4, max_denominator=3)
small = st.integers(-3, 3)


@st.composite
def mats(draw, rows=st.integers(0, 4), cols=st.integers(0, 4)):
    """Return a matrix of random shape, of low rank half of the time."""
    r, c = draw(rows), draw(cols)
    if draw(st.booleans()):
        return m.matrix([[draw(entries) for _ in range(c)] for _ in range(r)]) if r else m.zero(r, c)
    k = draw(st.integers(0, min(r, c)))
    F = fmpq_mat(r, k, [draw(small) for _ in range(r * k)])
    return F * fmpq_mat(k, c, [draw(small) for _ in range(k * c)])


@st.composite
def invertibles(draw, n):
    """Return an invertible matrix: a product of a unit lower and a unit upper triangular one."""
    L, U = m.identity(n), m.identity(n)
    for i in range(n):
        for j in range(i):
            L[i, j], U[j, i] = draw(small), draw(small)
    return L * U


@st.composite
def with_inertia(draw):
    """Return a symmetric matrix and its inertia, by a congruence of a diagonal one."""
    signs = draw(st.lists(st.sampled_from([-2, -1, 0, 0, 1, 3]), max_size=5))
    n = len(signs)
    S, D = draw(invertibles(n)), m.zero(n)
    for i, s in enumerate(signs):
        D[i, i] = s
    counts = tuple(sum(test(s) for s in signs) for test in (lambda s: s > 0, lambda s: s < 0, lambda s: s == 0))
    return S * D * S.transpose(), counts


def test_constructor_reads_every_kind_of_matrix():
    """Lists, numpy arrays, sympy, fmpz and fmpq matrices give the same matrix."""
    want = fmpq_mat([[1, 2], [3, 4]])
    for rows in (
        [[1, "2"], ["6/2", Fraction(4)]],
        np.array([[1, 2], [3, 4]]),
        sympy.Matrix([[1, 2], [3, 4]]),
        fmpz_mat([[1, 2], [3, 4]]),
        want,
        ((1, 2), (3, 4)),
        np.array([[1, 2], [3, 4]], dtype=object),
    ):
        assert m.matrix(rows) == want
    assert m.matrix(np.array([[0.5, 0.1]]), floats="decimal") == fmpq_mat([[fmpq(1, 2), fmpq(1, 10)]])
    assert m.matrix(np.array([[0.1]], dtype=np.float32), floats="decimal")[0, 0] == fmpq(1, 10)
    assert m.matrix([]).nrows() == 0 and m.matrix(np.zeros((0, 3))).ncols() == 3 and m.matrix([[], []]).nrows() == 2


@pytest.mark.parametrize(
    "rows",
    [
        [[1, 2], [3]],
        [[0.5]],
        [1, 2],
        "12",
        ["12", "34"],
        5,
        None,
        np.zeros(3),
        [[None]],
        np.zeros((2, 2, 2)),
        sympy.Matrix([[sympy.sqrt(2)]]),
    ],
)
def test_constructor_refuses(rows):
    """What is not a matrix of rational numbers is refused by name, in one line."""
    with pytest.raises(BadInput, match="argument 'V") as error:
        m.matrix(rows, name="V")
    assert "\n" not in str(error.value)


def test_the_message_shows_the_matrix():
    """The message about a singular matrix names it, shows it and says what to do."""
    with pytest.raises(BadInput) as error:
        m.inverse([[1, 1], [1, 1]], name="V")
    assert str(error.value) == ("argument 'V' is singular: 2x2 matrix [[1, 1], [1, 1]]; pass an invertible matrix")


def test_blocks():
    """Stacking puts blocks where they belong, also empty ones, and refuses blocks that do not fit."""
    A = m.block([[[[1]], [[2, 3]]], [[[4]], [[5, 6]]]])
    assert fmpq_mat([[1, 2, 3], [4, 5, 6]]) == A and m.transpose(A) == fmpq_mat([[1, 4], [2, 5], [3, 6]])
    assert m.hstack(m.zero(2, 0), m.identity(2)) == m.identity(2) == m.vstack(m.zero(0, 2), m.identity(2))
    assert m.hstack().nrows() == 0 and m.vstack().nrows() == 0 and m.hstack(m.zero(0, 2), m.zero(0, 3)).ncols() == 5
    with pytest.raises(BadInput, match="rows"):
        m.hstack([[1]], [[1], [2]])
    with pytest.raises(BadInput, match="columns"):
        m.vstack([[1]], [[1, 2]])


@few
@given(mats())
def test_null_space_has_the_right_size_and_vanishes(A):
    """The columns are independent, as many as the nullity, and A annihilates them."""
    N = m.null_space(A)
    assert N.nrows() == A.ncols() and N.ncols() == N.rank() == A.ncols() - m.rank(A)
    assert m.zero(A.nrows(), N.ncols()) == A * N


@few
@given(mats(), st.data())
def test_solve_finds_a_solution_where_there_is_one(A, data):
    """A X = B is solved for B in the column space and refused for B outside."""
    X = data.draw(mats(st.just(A.ncols()), st.integers(0, 2)))
    assert A * m.solve(A, A * X) == A * X
    left = m.null_space(A.transpose())
    if left.ncols():
        with pytest.raises(BadInput, match="argument 'B'"):
            m.solve(A, left)


@few
@given(st.integers(0, 4).flatmap(invertibles), st.integers(-4, 6))
def test_inverse_and_power(A, n):
    """The inverse inverts and the power is the repeated product."""
    eye = m.identity(A.nrows())
    assert A * m.inverse(A) == eye
    naive = eye
    for _ in range(abs(n)):
        naive = naive * (A if n > 0 else m.inverse(A))
    assert m.power(A, n) == naive


def test_square_matrices_are_asked_for():
    """Functions of square matrices refuse others, singular ones have no inverse."""
    for call in (m.inverse, m.ldlt, m.inertia, m.is_pd, m.one_inverse, lambda A: m.power(A, 2)):
        with pytest.raises(BadInput, match="not square"):
            call([[1, 2]])
    with pytest.raises(BadInput, match="singular"):
        m.power([[0]], -1)
    with pytest.raises(BadInput, match="rows"):
        m.solve([[1]], [[1], [2]])


@few
@given(with_inertia())
def test_inertia_is_known_by_sylvesters_law(made):
    """A congruence keeps the inertia, and the semidefiniteness tests follow it."""
    A, counts = made
    assert tuple(m.inertia(A)) == counts
    assert m.is_psd(A) == (counts[1] == 0) and m.is_pd(A) == (counts[1] == counts[2] == 0)
    assert m.is_symmetric(A)


@few
@given(mats(st.just(4), st.just(4)))
def test_ldlt_multiplies_back(A):
    """L is unit lower triangular, D has blocks of size at most 2, and their product is A reordered."""
    A = A + A.transpose()
    p, L, D = m.ldlt(A)
    n = A.nrows()
    assert sorted(p) == list(range(n))
    assert L * D * L.transpose() == fmpq_mat(n, n, [A[i, j] for i in p for j in p])
    assert all(L[i, j] == (i == j) for i in range(n) for j in range(i, n))
    assert all(D[i, j] == 0 for i in range(n) for j in range(n) if abs(i - j) > 1)
    assert all(D[i, i] == D[i + 1, i + 1] == 0 for i in range(n - 1) if D[i, i + 1] != 0)
    assert m.inertia(D) == m.inertia(A)


@pytest.mark.parametrize(
    "A, counts",
    [
        ([], (0, 0, 0)),
        ([[0]], (0, 0, 1)),
        ([[0, 0], [0, 0]], (0, 0, 2)),
        ([[0, 1], [1, 0]], (1, 1, 0)),
        ([[0, 1, 0], [1, 0, 0], [0, 0, 0]], (1, 1, 1)),
        ([[0, 0, 1], [0, 5, 0], [1, 0, 0]], (2, 1, 0)),
        ([["1/3"]], (1, 0, 0)),
    ],
)
def test_degenerate_symmetric_matrices(A, counts):
    """Zero diagonals, zero matrices and the empty matrix have the right inertia and factors."""
    assert tuple(m.inertia(A)) == counts
    p, L, D = m.ldlt(A)
    A = m.matrix(A)
    assert L * D * L.transpose() == fmpq_mat(A.nrows(), A.nrows(), [A[i, j] for i in p for j in p])


def test_semidefinite_means_diagonal_factors():
    """The factor D of a semidefinite matrix is diagonal."""
    F = m.matrix([[0, 1], [0, 2], [1, 1]])
    D = m.ldlt(F * F.transpose()).D
    assert all(D[i, j] == 0 for i in range(3) for j in range(3) if i != j)


def test_not_symmetric_is_refused():
    """Inertia, factors and (1)-inverses are for symmetric matrices."""
    for call in (m.inertia, m.is_psd, m.is_pd, m.ldlt, m.one_inverse):
        with pytest.raises(BadInput, match="not symmetric"):
            call([[1, 2], [3, 4]])
    assert not m.is_symmetric([[1, 2], [3, 4]]) and not m.is_symmetric([[1, 2]]) and m.is_symmetric([])


@few
@given(mats())
def test_moore_penrose_equations(A):
    """The four Penrose equations hold, and the full rank factors multiply to A."""
    G = m.moore_penrose(A)
    AG, GA = A * G, G * A
    assert A * G * A == A and G * A * G == G and AG.transpose() == AG and GA.transpose() == GA
    F, H = m.full_rank_factorization(A)
    assert F * H == A and F.ncols() == H.nrows() == F.rank() == H.rank() == A.rank()


@few
@given(with_inertia(), st.data())
def test_one_inverses_are_parametrised(made, data):
    """Each parameter gives a symmetric (1)-inverse, and the stated parameter gives back a given one."""
    Z, _ = made
    n = Z.nrows()
    G = m.one_inverse(Z, data.draw(mats(st.just(n), st.just(n))))
    assert G.transpose() == G and Z * G * Z == Z
    base = m.one_inverse(Z)
    X, Q = G - base, m.identity(n) - base * Z
    assert m.one_inverse(Z, X * (m.identity(n) - Q / 2)) == G
    with pytest.raises(BadInput, match="argument 'W'"):
        m.one_inverse(Z, m.zero(n + 1))


def test_arguments_are_left_alone():
    """No function changes the matrix it is given."""
    rows = [[2, 1, 0], [1, 2, 1], [0, 1, 2]]
    A = m.matrix(rows)
    for call in (m.ldlt, m.inertia, m.inverse, m.null_space, m.moore_penrose, m.one_inverse, lambda A: m.power(A, 3)):
        call(A)
    assert m.matrix(rows) == A
