# SPDX-License-Identifier: MIT
r"""Definiteness of rational symmetric matrices, with a witness.

Main definitions
----------------
``negative_direction``      an `x` with :math:`x^* S x < 0`, if there is one
``nonpositive_direction``   an :math:`x \ne 0` with :math:`x^* S x \le 0`, if there is one

Main statements
---------------
`S` is nonnegative exactly if the first returns None, positive definite exactly if the
second does.  The search is symmetric Gaussian elimination; a direction found in a Schur
complement is lifted by minimising over the eliminated variable.

References
----------
B93 Section 1.1 uses both notions for the sets H, H1, H2, H0.
"""

from __future__ import annotations

from typing import Any

from flint import fmpq_mat, fmpz

from exactkf.theory._matrices import Matrix, as_fmpq_mat, check_symmetric
from exactkf.theory._scalars import Scalar, Vector

__all__ = ["negative_direction", "nonpositive_direction"]


def _lifted(y: Vector, row: Vector, pivot: Scalar) -> Vector:
    """Return the vector that minimises the form among those with the remaining entries `y`."""
    value = -sum((row[j] * y[j] for j in range(1, len(y))), row[0] * y[0]) / pivot
    return (value, *y)


def negative_direction(S: Any) -> tuple[fmpz, ...] | None:
    r"""Return an integer vector `x` with :math:`x^* S x < 0`, or None if `S` is nonnegative.

    Parameters
    ----------
    S : symmetric rational matrix, shape (d, d)

    Raises
    ------
    BadInput
        If `S` is not symmetric or not rational.

    Examples
    --------
    >>> negative_direction([[0, 1], [1, 0]]), negative_direction([[1, 1], [1, 1]])
    ((1, -1), None)
    """
    return _direction(S, strict=True)


def nonpositive_direction(S: Any) -> tuple[fmpz, ...] | None:
    r"""Return an integer :math:`x \ne 0` with :math:`x^* S x \le 0`, or None if `S` is positive definite.

    Raises
    ------
    BadInput
        If `S` is not symmetric or not rational.

    Examples
    --------
    >>> nonpositive_direction([[1, 1], [1, 1]]), nonpositive_direction([[2, 1], [1, 2]])
    ((1, -1), None)
    """
    return _direction(S, strict=False)


def _direction(S: Any, strict: bool) -> tuple[fmpz, ...] | None:
    matrix = tuple(tuple(row) for row in as_fmpq_mat("S", S).tolist())
    check_symmetric("S", matrix)
    x = _search(matrix, strict)
    if x is None:
        return None
    (entries,) = fmpq_mat([x]).numer_denom()[0].tolist()
    content = fmpz(0)
    for entry in entries:
        content = content.gcd(entry)
    if next(entry for entry in entries if entry != 0) < 0:
        content = -content
    return tuple(entry // content for entry in entries)


def _search(S: Matrix, strict: bool) -> Vector | None:
    """Return a direction of negative (or, unless `strict`, nonpositive) value, by symmetric elimination."""
    n = len(S)
    zero = S[0][0] - S[0][0]
    pivot, row = S[0][0], S[0][1:]
    if pivot < 0 or (pivot == 0 and not strict):
        return (zero + 1,) + (zero,) * (n - 1)
    if pivot == 0:
        j = next((j for j, value in enumerate(row) if value != 0), None)
        if j is not None:  # x = s e_0 + e_j has value 2 s b + c; take the smallest integer s
            b, c = row[j], S[j + 1][j + 1]
            s = zero if c < 0 else zero + (c / (2 * abs(b))).floor() + 1
            return (s if b < 0 else -s, *(zero + int(k == j) for k in range(n - 1)))
    if n == 1:
        return None
    if pivot == 0:
        y = _search(tuple(r[1:] for r in S[1:]), strict)
        return None if y is None else (zero, *y)
    rest = tuple(tuple(S[i][j] - S[i][0] * S[0][j] / pivot for j in range(1, n)) for i in range(1, n))
    y = _search(rest, strict)
    return None if y is None else _lifted(y, row, pivot)
