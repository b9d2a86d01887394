# SPDX-License-Identifier: MIT
"""Characteristic and minimal polynomials, elementary divisors and the Jordan form over Q.

Notation
--------
An elementary divisor of A is a power f**k of an irreducible polynomial f.  The
number of those with exponent at least k is ``(rank f(A)**(k-1) - rank f(A)**k) /
deg f``; over Q and for f = x - a they are the Jordan blocks of the eigenvalue a.
A Jordan block of size k has the eigenvalue on the diagonal and ones above it.

Choice of algorithm
-------------------
The characteristic polynomial comes from FLINT; the minimal polynomial does not, for
``fmpq_mat.minpoly`` gives 1 for the zero matrix in python-flint 0.7.  Block sizes
come from ranks, chains of
generalised eigenvectors from one echelon form per chain length; everything is
linear algebra over Q, and no irrational eigenvalue is ever written down.

References
----------
R. A. Horn, C. R. Johnson, Matrix Analysis, 2nd ed., chapter 3.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from flint import fmpq, fmpq_mat, fmpq_poly

from exactkf._errors import Unsupported
from exactkf.exact._messages import shown
from exactkf.exact.matrices import _square, columns, hstack, identity, null_space, pivot_columns, zero
from exactkf.exact.polynomials import polynomial

__all__ = [
    "ElementaryDivisors",
    "JordanBlocks",
    "charpoly",
    "elementary_divisors",
    "jordan_form",
    "jordan_structure",
    "minimal_polynomial",
    "polynomial_at",
]


class ElementaryDivisors(NamedTuple):
    """A monic irreducible polynomial and the exponents of its elementary divisors, largest first."""

    factor: fmpq_poly
    sizes: tuple[int, ...]


class JordanBlocks(NamedTuple):
    """A rational eigenvalue and the sizes of its Jordan blocks, largest first."""

    eigenvalue: fmpq
    sizes: tuple[int, ...]


def charpoly(A: Any) -> fmpq_poly:
    """Return the monic characteristic polynomial det(x I - A); BadInput if A is not square."""
    return _square(A, "A").charpoly()


def minimal_polynomial(A: Any) -> fmpq_poly:
    """Return the monic polynomial of least degree that vanishes at A; BadInput if A is not square."""
    result = fmpq_poly([1])
    for factor, sizes in elementary_divisors(A):
        result *= factor ** sizes[0]
    return result


def polynomial_at(p: Any, A: Any) -> fmpq_mat:
    """Return the matrix p(A), by Horner's rule; BadInput if p is no polynomial or A is not square."""
    p = polynomial(p)
    A = _square(A, "A")
    n = A.nrows()
    one, result = identity(n), zero(n)
    for c in reversed(p.coeffs()):
        result = result * A + one * c
    return result


def elementary_divisors(A: Any) -> list[ElementaryDivisors]:
    """Return the elementary divisors of A over Q, which determine it up to similarity.

    Parameters
    ----------
    A : matrix, shape (n, n)

    Returns
    -------
    list of ElementaryDivisors
        Sorted by degree, then by coefficients from the highest down with linear
        factors in increasing order of their roots.

    Raises
    ------
    BadInput
        If A is not square.
    """
    A = _square(A, "A")
    found = []
    for factor, multiplicity in charpoly(A).factor()[1]:
        factor = factor / factor.leading_coefficient()
        found.append(ElementaryDivisors(factor, _sizes(polynomial_at(factor, A), factor.degree(), multiplicity)))
    return sorted(found, key=lambda e: (e.factor.degree(), [-c for c in reversed(e.factor.coeffs())]))


def jordan_structure(A: Any) -> list[JordanBlocks]:
    """Return the rational eigenvalues of A in increasing order, with the sizes of their Jordan blocks.

    Irrational eigenvalues are passed over; `elementary_divisors` has them too.

    Parameters
    ----------
    A : matrix, shape (n, n)

    Returns
    -------
    list of JordanBlocks

    Raises
    ------
    BadInput
        If A is not square.
    """
    return [JordanBlocks(-f[0], sizes) for f, sizes in elementary_divisors(A) if f.degree() == 1]


def jordan_form(A: Any) -> tuple[fmpq_mat, fmpq_mat]:
    """Return T and J with A T = T J, T invertible and J the Jordan form of A.

    Parameters
    ----------
    A : matrix, shape (n, n)

    Returns
    -------
    T, J : fmpq_mat, shape (n, n)
        Blocks in the order of `jordan_structure`.

    Raises
    ------
    BadInput
        If A is not square.
    Unsupported
        If an eigenvalue is irrational.
    """
    A = _square(A, "A")
    n = A.nrows()
    T, J, at = zero(n, 0), zero(n), 0
    for factor, sizes in elementary_divisors(A):
        if factor.degree() > 1:
            raise Unsupported(f"the matrix has eigenvalues outside Q: {shown(factor)}; use elementary_divisors")
        a = -factor[0]
        T = hstack(T, _chains(A - identity(n) * a, sizes))
        for size in sizes:
            for i in range(at, at + size):
                J[i, i] = a
                if i > at:
                    J[i - 1, i] = 1
            at += size
    return T, J


def _sizes(N: fmpq_mat, degree: int, multiplicity: int) -> tuple[int, ...]:
    """Return the exponents belonging to a factor of the given degree whose value at the matrix is N."""
    n = N.nrows()
    ranks, P = [n], identity(n)
    while n - ranks[-1] < degree * multiplicity:
        P = P * N
        ranks.append(P.rank())
    at_least = [(a - b) // degree for a, b in zip(ranks, ranks[1:], strict=False)]  # blocks of size >= 1, 2, ...
    return tuple(sum(count > i for count in at_least) for i in range(at_least[0]))


def _chains(N: fmpq_mat, sizes: tuple[int, ...]) -> fmpq_mat:
    """Return chains N**(k-1) v, ..., N v, v in columns, one for each k in `sizes`, which decrease."""
    n, longest = N.nrows(), sizes[0]
    kernels, P = [zero(n, 0)], identity(n)
    for _ in range(longest):
        P = P * N
        kernels.append(null_space(P))
    result, level = zero(n, 0), zero(n, 0)  # level: the vectors of the chains found, at the current height
    for k in range(longest, 0, -1):
        known = hstack(kernels[k - 1], N * level)
        pivots = pivot_columns(hstack(known, kernels[k]))[1]
        tops = columns(kernels[k], [j - known.ncols() for j in pivots if j >= known.ncols()])
        for c in range(tops.ncols()):
            chain = columns(tops, [c])
            for _ in range(k - 1):
                chain = hstack(N * columns(chain, [0]), chain)
            result = hstack(result, chain)
        level = hstack(N * level, tops)
    return result
