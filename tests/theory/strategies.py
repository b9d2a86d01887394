# SPDX-License-Identifier: MIT
"""Strategies that build valid objects by construction."""

from __future__ import annotations

from flint import fmpq, fmpq_mat
from hypothesis import strategies as st


def rationals(limit: int = 5):
    """Small rationals."""
    return st.builds(fmpq, st.integers(-limit, limit), st.integers(1, 4))


def schur_values():
    """Rationals with square different from one."""
    return rationals().filter(lambda x: x * x != 1)


def vectors(n, entries=None):
    """Tuples of length `n`."""
    return st.lists(rationals() if entries is None else entries, min_size=n, max_size=n).map(tuple)


def matrices(m, n):
    """Rational matrices of shape ``(m, n)`` as tuples of rows."""
    return vectors(m, vectors(n))


@st.composite
def schur_sequences(draw, min_size=0, max_size=6):
    """Schur parameters of random length."""
    return draw(vectors(draw(st.integers(min_size, max_size)), schur_values()))


@st.composite
def parameters(draw, max_n=4):
    """Pairs ``(alpha, gamma)`` in the domain of the Kimura-Georgiou map."""
    n = draw(st.integers(1, max_n))
    return draw(vectors(n)), draw(vectors(n, schur_values()))


@st.composite
def pairs(draw, max_n=4):
    """Pairs of vectors of equal length, with no condition."""
    n = draw(st.integers(1, max_n))
    return draw(vectors(n)), draw(vectors(n))


@st.composite
def invertible(draw, n):
    """Invertible matrices: lower triangular times upper triangular with nonzero diagonal."""
    nonzero = rationals().filter(bool)
    lower = [[draw(rationals(2)) if j < i else fmpq(int(i == j)) for j in range(n)] for i in range(n)]
    upper = [
        [draw(rationals(2)) if j > i else draw(nonzero) if i == j else fmpq(0) for j in range(n)] for i in range(n)
    ]
    return rows(fmpq_mat(lower) * fmpq_mat(upper))


@st.composite
def nonnegative(draw, n, rank=None):
    """Nonnegative definite matrices ``B B^T`` with a factor of `rank` columns."""
    B = mat(draw(matrices(n, draw(st.integers(1, n)) if rank is None else rank)))
    return rows(B * B.transpose())


def mat(table):
    """Return a table as a FLINT matrix."""
    return fmpq_mat([list(row) for row in table])


def rows(matrix):
    """Return a FLINT matrix as a tuple of rows."""
    return tuple(tuple(row) for row in matrix.tolist())
