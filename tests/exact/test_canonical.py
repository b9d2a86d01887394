# SPDX-License-Identifier: MIT
"""Tests of exactkf.exact.canonical."""

import pytest
from flint import fmpq, fmpq_mat, fmpq_poly
from hypothesis import given, settings
from hypothesis import strategies as st

from exactkf._errors import BadInput, Unsupported
from exactkf.exact.canonical import (
    charpoly,
    elementary_divisors,
    jordan_form,
    jordan_structure,
    minimal_polynomial,
    polynomial_at,
)
from exactkf.exact.matrices import identity, zero

few = settings(max_examples=30, deadline=None)
small = st.integers(-2, 2)


def diagonal_blocks(parts):
    """Return the block diagonal matrix of the given blocks."""
    A, at = zero(sum(p.nrows() for p in parts)), 0
    for p in parts:
        for i in range(p.nrows()):
            for j in range(p.nrows()):
                A[at + i, at + j] = p[i, j]
        at += p.nrows()
    return A


def jordan_block(a, size):
    """Return the Jordan block of an eigenvalue."""
    return fmpq_mat(size, size, [a if i == j else int(j == i + 1) for i in range(size) for j in range(size)])


def companion(f):
    """Return the companion matrix of a monic polynomial."""
    n = f.degree()
    return fmpq_mat(n, n, [-f[i] if j == n - 1 else int(i == j + 1) for i in range(n) for j in range(n)])


@st.composite
def conjugated(draw, parts):
    """Return the block diagonal matrix of the parts in another basis."""
    A = diagonal_blocks(parts)
    n = A.nrows()
    L, U = identity(n), identity(n)
    for i in range(n):
        for j in range(i):
            L[i, j], U[j, i] = draw(small), draw(small)
    S = L * U
    return S * A * S.inv()


eigenvalues = st.sampled_from([fmpq(0), fmpq(1), fmpq(-1), fmpq(1, 2)])
block_lists = st.lists(st.tuples(eigenvalues, st.integers(1, 3)), max_size=4)


@few
@given(block_lists, st.data())
def test_jordan_blocks_are_found_again(blocks, data):
    """A conjugate of a sum of Jordan blocks has these blocks, and the transformation works."""
    A = data.draw(conjugated([jordan_block(a, k) for a, k in blocks]))
    expected = [
        (a, tuple(sorted((k for b, k in blocks if b == a), reverse=True))) for a in sorted({a for a, _ in blocks})
    ]
    assert [(a, sizes) for a, sizes in jordan_structure(A)] == expected
    T, J = jordan_form(A)
    assert A * T == T * J and T.rank() == A.nrows()
    assert diagonal_blocks([jordan_block(a, k) for a, sizes in expected for k in sizes]) == J


@few
@given(
    st.lists(
        st.tuples(st.sampled_from([[1, 0, 1], [-2, 0, 1], [0, 1], [1, 1, 0, 1]]), st.integers(1, 2)),
        min_size=1,
        max_size=3,
    ),
    st.data(),
)
def test_elementary_divisors_of_companions_are_found_again(parts, data):
    """Companions of powers of irreducible polynomials give these powers, the charpoly and the minpoly."""
    A = data.draw(conjugated([companion(fmpq_poly(f) ** k) for f, k in parts]))
    found = {tuple(f.coeffs()): sizes for f, sizes in elementary_divisors(A)}
    keys = {tuple(fmpq_poly(f).coeffs()) for f, _ in parts}
    assert found == {
        key: tuple(sorted((k for f, k in parts if tuple(fmpq_poly(f).coeffs()) == key), reverse=True)) for key in keys
    }
    chi, mu = fmpq_poly([1]), fmpq_poly([1])
    for f, sizes in elementary_divisors(A):
        chi, mu = chi * f ** sum(sizes), mu * f ** sizes[0]
    assert charpoly(A) == chi and minimal_polynomial(A) == mu
    assert polynomial_at(mu, A) == zero(A.nrows())


def test_irrational_eigenvalues():
    """The structure passes over them, the form over Q does not exist."""
    A = diagonal_blocks([companion(fmpq_poly([-2, 0, 1])), jordan_block(3, 2)])
    assert jordan_structure(A) == [(3, (2,))]
    with pytest.raises(Unsupported, match=r"x\^2"):
        jordan_form(A)


def test_degenerate_matrices():
    """The empty matrix and the zero matrix have trivial forms."""
    T, J = jordan_form([])
    assert T.nrows() == J.nrows() == 0 and jordan_structure([]) == [] and charpoly([]) == minimal_polynomial([]) == 1
    assert jordan_structure([[0, 0], [0, 0]]) == [(0, (1, 1))] and minimal_polynomial([[0, 0], [0, 0]]) == fmpq_poly(
        [0, 1]
    )
    T, J = jordan_form([[2, 0], [0, 2]])
    assert identity(2) * 2 == J and T.rank() == 2
    assert polynomial_at(fmpq_poly([5]), [[1]])[0, 0] == 5 and polynomial_at(fmpq_poly([]), [[1]])[0, 0] == 0


def test_square_matrices_are_asked_for():
    """Every function refuses a matrix that is not square."""
    for call in (charpoly, minimal_polynomial, elementary_divisors, jordan_structure, jordan_form):
        with pytest.raises(BadInput, match="not square"):
            call([[1, 2]])
