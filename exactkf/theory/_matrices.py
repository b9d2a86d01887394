# SPDX-License-Identifier: MIT
"""Matrices over an unspecified field, as tuples of rows.

Main definitions
----------------
``as_matrices``   arguments of one call, checked and brought to one scalar type
``check_shape``, ``check_square``, ``check_symmetric``   what is asked of a matrix
``product``, ``plus``, ``minus``, ``scaled``, ``transposed``, ``identity``, ``blocks``
``solved``, ``inverse``   Gaussian elimination with the first nonzero pivot

Notation
--------
A matrix is a nonempty tuple of rows of equal length.  FLINT matrices are
accepted wherever a matrix is.
"""

from __future__ import annotations

from collections.abc import Sequence
from numbers import Rational
from typing import Any, TypeAlias

from flint import fmpq, fmpq_mat

from exactkf.theory._scalars import Scalar, Vector, one_type, refused, scalar

__all__ = [
    "Matrix",
    "as_fmpq_mat",
    "as_matrices",
    "blocks",
    "check_shape",
    "check_square",
    "check_symmetric",
    "column",
    "identity",
    "inverse",
    "is_symmetric",
    "minus",
    "plus",
    "product",
    "scaled",
    "solved",
    "transposed",
    "zeros",
]

Matrix: TypeAlias = tuple[Vector, ...]


def as_matrices(**named: Any) -> list[Matrix]:
    """Return the named matrices as tuples of rows over one scalar type.

    Raises
    ------
    BadInput
        If an argument is not a nonempty rectangular array of exact scalars.
    """
    widths: list[int] = []
    flat: dict[str, list[Scalar]] = {}
    for name, value in named.items():
        rows = value.tolist() if hasattr(value, "tolist") else value
        if not isinstance(rows, (list, tuple)) or not rows or not all(isinstance(r, (list, tuple)) for r in rows):
            raise refused(name, value, "not a matrix", "pass a nonempty list of rows")
        if not rows[0] or len({len(row) for row in rows}) != 1:
            raise refused(name, value, f"has rows of lengths {[len(row) for row in rows]}", "pass rows of equal length >= 1")
        widths.append(len(rows[0]))
        flat[name] = [scalar(f"{name}[{i}][{j}]", entry) for i, row in enumerate(rows) for j, entry in enumerate(row)]
    return [
        tuple(entries[i : i + width] for i in range(0, len(entries), width))
        for entries, width in zip(one_type(flat), widths, strict=True)
    ]


def as_fmpq_mat(name: str, value: Any) -> fmpq_mat:
    """Return `value` as a FLINT rational matrix.

    Raises
    ------
    BadInput
        If an entry is not a rational number.
    """
    (rows,) = as_matrices(**{name: value})
    for row in rows:
        for x in row:
            if not isinstance(x, (fmpq, Rational)):
                raise refused(name, value, f"has the entry {x}, which is not a rational number", "pass fmpq or Fraction")
    return fmpq_mat([[x if isinstance(x, fmpq) else fmpq(x.numerator, x.denominator) for x in row] for row in rows])


def check_shape(name: str, matrix: Matrix, shape: tuple[int, int], reference: str = "") -> None:
    """Raise `BadInput` unless `matrix` has the given shape.

    Raises
    ------
    BadInput
        If the shapes differ; `reference` names the argument that sets the shape, unless it is a matter of being square.
    """
    if (len(matrix), len(matrix[0])) != shape:
        where = f" where {reference} asks for {shape}" if reference else " and is not square"
        raise refused(name, matrix, f"has shape {len(matrix), len(matrix[0])}{where}", f"pass a matrix of shape {shape}")


def check_square(name: str, matrix: Matrix) -> int:
    """Return the order of `matrix`.

    Raises
    ------
    BadInput
        If it is not square.
    """
    check_shape(name, matrix, (len(matrix), len(matrix)))
    return len(matrix)


def check_symmetric(name: str, matrix: Matrix, n: int | None = None, reference: str = "") -> None:
    """Raise `BadInput` unless `matrix` is symmetric, and of order `n` if that is given.

    Entries that cannot be told apart, such as balls that overlap, count as equal.

    Raises
    ------
    BadInput
        If the shape does not fit, or an entry differs from its mirror image; it is named.
    """
    n = len(matrix) if n is None else n
    check_shape(name, matrix, (n, n), reference)
    for i in range(n):
        for j in range(i):
            if matrix[i][j] != matrix[j][i]:
                places = f"({i + 1}, {j + 1}) and ({j + 1}, {i + 1})"
                raise refused(name, matrix, f"not symmetric, its entries {places} differ", "pass a symmetric matrix")


def identity(n: int, one: Scalar) -> Matrix:
    """Return the identity matrix of order `n` over the type of `one`."""
    zero = one - one
    return tuple(tuple(one if i == j else zero for j in range(n)) for i in range(n))


def zeros(m: int, n: int, one: Scalar) -> Matrix:
    """Return the zero matrix of shape ``(m, n)`` over the type of `one`."""
    zero = one - one
    return ((zero,) * n,) * m


def column(vector: Sequence[Scalar]) -> Matrix:
    """Return `vector` as a matrix with one column."""
    return tuple((x,) for x in vector)


def transposed(matrix: Matrix) -> Matrix:
    """Return the transpose."""
    return tuple(zip(*matrix, strict=True))


def product(first: Matrix, *others: Matrix) -> Matrix:
    """Return the product of the matrices, from left to right."""
    result = first
    for other in others:
        if len(result[0]) != len(other):
            raise refused("factor", other, f"has {len(other)} rows where the factor before it has {len(result[0])} columns", "pass shapes that fit")
        columns = transposed(other)
        result = tuple(tuple(_dot(row, col) for col in columns) for row in result)
    return result


def _dot(x: Vector, y: Vector) -> Scalar:
    total = x[0] * y[0]
    for i in range(1, len(x)):
        total = total + x[i] * y[i]
    return total


def plus(first: Matrix, second: Matrix) -> Matrix:
    """Return the sum."""
    return tuple(tuple(x + y for x, y in zip(r, s, strict=True)) for r, s in zip(first, second, strict=True))


def minus(first: Matrix, second: Matrix) -> Matrix:
    """Return the difference."""
    return tuple(tuple(x - y for x, y in zip(r, s, strict=True)) for r, s in zip(first, second, strict=True))


def scaled(factor: Scalar, matrix: Matrix) -> Matrix:
    """Return `factor` times the matrix."""
    return tuple(tuple(factor * x for x in row) for row in matrix)


def blocks(rows: Sequence[Sequence[Matrix]]) -> Matrix:
    """Return the matrix put together from a rectangular array of blocks."""
    return tuple(sum(parts, ()) for band in rows for parts in zip(*band, strict=True))


def is_symmetric(matrix: Matrix) -> bool:
    """Say whether the matrix equals its transpose."""
    return len(matrix) == len(matrix[0]) and matrix == transposed(matrix)


def solved(matrix: Matrix, right: Matrix, name: str = "matrix") -> Matrix:
    """Return ``X`` with ``matrix @ X == right``.

    Parameters
    ----------
    matrix : Matrix, shape (n, n)
    right : Matrix, shape (n, m)
    name : str
        How to call the matrix in the error message.

    Raises
    ------
    BadInput
        If the matrix is singular.
    """
    n = len(matrix)
    check_shape(name, matrix, (len(right), len(right)), "the right-hand side")
    work = [list(row) + list(extra) for row, extra in zip(matrix, right, strict=True)]
    for k in range(n):
        pivot = next((i for i in range(k, n) if work[i][k] != 0), None)
        if pivot is None:
            dependent = "its first column is zero" if k == 0 else f"its first {k + 1} columns are dependent"
            raise refused(name, matrix, f"singular, {dependent}", "pass data that avoid this")
        work[k], work[pivot] = work[pivot], work[k]
        work[k] = [x / work[k][k] for x in work[k]]
        for i in range(n):
            if i != k and work[i][k] != 0:
                factor = work[i][k]
                work[i] = [x - factor * y for x, y in zip(work[i], work[k], strict=True)]
    return tuple(tuple(row[n:]) for row in work)


def inverse(matrix: Matrix, name: str = "matrix") -> Matrix:
    """Return the inverse.

    Raises
    ------
    BadInput
        If the matrix is not square or singular.
    """
    check_square(name, matrix)
    first = matrix[0][0]
    return solved(matrix, identity(len(matrix), first - first + 1), name)
