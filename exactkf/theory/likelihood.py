# SPDX-License-Identifier: MIT
r"""Maximum-likelihood estimation with possibly perfect measurements.

The measurement is :math:`y = Hx + v` with a Gaussian `v` of covariance `R`, which may
be singular.

Main definitions
----------------
``likelihood_matrix``      :math:`Z = \begin{pmatrix} R & H \\ H^T & 0 \end{pmatrix}`
``symmetric_inverse``      any symmetric `G` with :math:`ZGZ = Z`
``likelihood_blocks``      the blocks `W`, `U`, `T` of such a `G`
``estimate``, ``error_covariance``    :math:`U^T y` and :math:`-T`
``is_estimable``, ``full_rank_factors``, ``estimable_part``   the case of dependent columns

Main statements
---------------
If `H` has independent columns and `R` is nonnegative definite, then for every choice
of `G`: :math:`U^T H = I`, :math:`RU + HT = 0`, :math:`H^T W H = 0`, :math:`RWH = 0`,
and with :math:`\Delta = R - RWR`: :math:`HTH^T = -\Delta`, :math:`RUH^T = \Delta`.
The block `T` and the matrix :math:`\Delta` do not depend on the choice.

The print defines :math:`\Delta` in NWL92 (A.7) as `R + RWR`.  For :math:`R = I` and
:math:`H = (1, 0)^T` that is diag(1, 2), whereas :math:`-HTH^T` is diag(1, 0).

References
----------
NWL92 (2.1)-(2.27), Lemmas 2.1 and 2.2, Appendix A.
"""

from __future__ import annotations

from collections.abc import Sequence
from numbers import Rational
from typing import Any

from flint import fmpq

from exactkf.theory._matrices import (
    Matrix,
    as_matrices,
    blocks,
    check_shape,
    check_symmetric,
    column,
    identity,
    inverse,
    minus,
    plus,
    product,
    scaled,
    transposed,
    zeros,
)
from exactkf.theory._scalars import Scalar, Vector, check_length, refused, unify, units
from exactkf.theory.definiteness import negative_direction

__all__ = [
    "error_covariance",
    "estimable_part",
    "estimate",
    "full_rank_factors",
    "is_estimable",
    "likelihood_blocks",
    "likelihood_matrix",
    "symmetric_inverse",
]


def _reduced(matrix: Matrix) -> tuple[Matrix, tuple[int, ...]]:
    """Return the nonzero rows of the reduced row echelon form, and the pivot columns."""
    work = [list(row) for row in matrix]
    pivots: list[int] = []
    for j in range(len(matrix[0])):
        k = len(pivots)
        i = next((i for i in range(k, len(work)) if work[i][j] != 0), None)
        if i is None:
            continue
        work[k], work[i] = work[i], work[k]
        work[k] = [x / work[k][j] for x in work[k]]
        for m, row in enumerate(work):
            if m != k and row[j] != 0:
                work[m] = [x - row[j] * y for x, y in zip(row, work[k], strict=True)]
        pivots.append(j)
    return tuple(tuple(row) for row in work[: len(pivots)]), tuple(pivots)


def _measurement(H: Any, R: Any) -> tuple[Matrix, Matrix]:
    """Return `H` and `R`, with `R` symmetric of fitting order and, if rational, nonnegative definite."""
    H, R = as_matrices(H=H, R=R)
    check_symmetric("R", R, len(H), "H")
    if all(isinstance(x, (fmpq, Rational)) for row in R for x in row):
        x = negative_direction(R)
        if x is not None:
            text = ", ".join(map(str, x))
            raise refused("R", R, f"not a covariance, x = ({text}) gives x^T R x < 0", "pass a nonnegative definite matrix")
    return H, R


def likelihood_matrix(H: Any, R: Any) -> Matrix:
    r"""Return :math:`Z = \begin{pmatrix} R & H \\ H^T & 0 \end{pmatrix}` (NWL92 (2.10)).

    Parameters
    ----------
    H : matrix, shape (p, n)
    R : nonnegative definite matrix, shape (p, p)
        Rational entries are checked; entries of other types are trusted.

    Returns
    -------
    Matrix, shape (p + n, p + n)

    Raises
    ------
    BadInput
        If `R` is not symmetric of order `p`, or is rational and not nonnegative definite.
    """
    H, R = _measurement(H, R)
    n = len(H[0])
    return blocks([[R, H], [transposed(H), zeros(n, n, units(H[0])[1])]])


def symmetric_inverse(Z: Any, choice: Any = None) -> Matrix:
    r"""Return a symmetric matrix `G` with :math:`ZGZ = Z` (NWL92 (2.20)).

    Parameters
    ----------
    Z : symmetric matrix, shape (m, m)
    choice : matrix, shape (m, m), optional
        Any matrix `K`; the result is :math:`G_0 + (I - G_0 Z)K + K^T(I - Z G_0)`, where
        :math:`G_0` is the inverse of a nonsingular principal submatrix of full rank.

    Raises
    ------
    BadInput
        If `Z` is not symmetric or the shape of `choice` differs.

    Examples
    --------
    >>> symmetric_inverse([[1, 1], [1, 1]])
    ((1, 0), (0, 0))
    """
    Z, K = as_matrices(Z=Z, choice=Z if choice is None else choice)
    check_symmetric("Z", Z)
    check_shape("choice", K, (len(Z), len(Z)), "Z")
    m, (zero, one) = len(Z), units(Z[0])
    # Rows that form a basis of the row space of a symmetric matrix give a nonsingular principal submatrix.
    _, basis = _reduced(Z)
    G = [[zero] * m for _ in range(m)]
    if basis:
        core = inverse(tuple(tuple(Z[i][j] for j in basis) for i in basis))
        for row, i in zip(core, basis, strict=True):
            for value, j in zip(row, basis, strict=True):
                G[i][j] = value
    base = tuple(tuple(row) for row in G)
    if choice is None:
        return base
    change = product(minus(identity(m, one), product(base, Z)), K)
    return plus(base, plus(change, transposed(change)))


def likelihood_blocks(H: Any, R: Any, choice: Any = None) -> tuple[Matrix, Matrix, Matrix]:
    r"""Return the blocks `W`, `U`, `T` of a symmetric (1)-inverse of `Z` (NWL92 (2.23)).

    Parameters
    ----------
    H, R : as in `likelihood_matrix`
    choice : matrix, shape (p + n, p + n), optional
        Passed to `symmetric_inverse`.

    Returns
    -------
    W, U, T : Matrix, shapes (p, p), (p, n), (n, n)

    Raises
    ------
    BadInput
        As `likelihood_matrix` and `symmetric_inverse`.
    """
    Z = likelihood_matrix(H, R)
    Z, H = as_matrices(Z=Z, H=H)
    p = len(H)
    G = symmetric_inverse(Z, choice)
    return tuple(r[:p] for r in G[:p]), tuple(r[p:] for r in G[:p]), tuple(r[p:] for r in G[p:])


def _require_estimable(H: Any) -> None:
    (H,) = as_matrices(H=H)
    rank = len(_reduced(H)[1])
    if rank < len(H[0]):
        raise refused("H", H, f"has rank {rank} < {len(H[0])}, so x is not estimable", "use estimable_part for what is")


def estimate(H: Any, R: Any, y: Sequence[Scalar], choice: Any = None) -> Vector:
    r"""Return the maximum-likelihood estimate :math:`\hat x = U^T y` (NWL92 (2.21), (2.24)).

    Parameters
    ----------
    H, R : as in `likelihood_matrix`, `H` with independent columns
    y : sequence of scalars, length p
        A possible measurement: in the range of :math:`(R \; H)`.  For others, which have
        probability zero, the result depends on `choice`.
    choice : matrix, optional
        Passed to `symmetric_inverse`.

    Raises
    ------
    BadInput
        If the columns of `H` are dependent, or `R` or the length of `y` does not fit.

    Examples
    --------
    >>> estimate([[1], [1]], [[1, 0], [0, 0]], [5, 7])
    (7,)
    """
    _require_estimable(H)
    U = likelihood_blocks(H, R, choice)[1]
    (y,) = unify(y=y)
    check_length("y", y, len(U), "R")
    U, Y = as_matrices(U=U, y=column(y))
    return tuple(value for (value,) in product(transposed(U), Y))


def error_covariance(H: Any, R: Any, choice: Any = None) -> Matrix:
    r"""Return :math:`P = -T` (NWL92 (2.19), (2.22)); arguments and errors as `estimate`.

    Examples
    --------
    >>> error_covariance([[1], [1]], [[1, 0], [0, 3]])
    ((3/4,),)
    """
    _require_estimable(H)
    return scaled(-1, likelihood_blocks(H, R, choice)[2])


def is_estimable(H: Any, c: Sequence[Scalar]) -> bool:
    r"""Say whether :math:`c^T x` has an unbiased linear estimate, that is `c` is in the range of :math:`H^T`.

    Parameters
    ----------
    H : matrix, shape (p, n)
    c : sequence of scalars, length n

    Raises
    ------
    BadInput
        If the length of `c` is not `n`.

    Examples
    --------
    >>> is_estimable([[1, 1]], [2, 2]), is_estimable([[1, 1]], [1, 0])
    (True, False)
    """
    (c,) = unify(c=c)
    (H,) = as_matrices(H=H)
    check_length("c", c, len(H[0]), "H")
    H, row = as_matrices(H=H, c=[c])
    return len(_reduced((*H, *row))[1]) == len(_reduced(H)[1])


def full_rank_factors(H: Any) -> tuple[Matrix, Matrix]:
    r"""Return :math:`H_1`, :math:`H_2` of full column and row rank with :math:`H = H_1 H_2` (NWL92 before (2.26)).

    Raises
    ------
    BadInput
        If `H` is zero.
    """
    (H,) = as_matrices(H=H)
    rows, pivots = _reduced(H)
    if not pivots:
        raise refused("H", H, "zero, so nothing is estimable", "pass a nonzero matrix")
    return tuple(tuple(row[j] for j in pivots) for row in H), rows


def estimable_part(H: Any, R: Any, y: Sequence[Scalar]) -> tuple[Matrix, Vector, Matrix]:
    r"""Return :math:`H_2`, the estimate of :math:`H_2 x` and its error covariance (NWL92 (2.26), (2.27)).

    The print has a superfluous `y` at the end of (2.27).

    Parameters
    ----------
    H : nonzero matrix, shape (p, n)
    R, y : as in `estimate`

    Returns
    -------
    H2 : Matrix, shape (rank, n)
    z : tuple of scalars, length rank
    P : Matrix, shape (rank, rank)

    Raises
    ------
    BadInput
        If `H` is zero, or `R` or the length of `y` does not fit.

    Examples
    --------
    >>> estimable_part([[1, 1]], [[2]], [3])
    (((1, 1),), (3,), ((2,),))
    """
    first, second = full_rank_factors(H)
    return second, estimate(first, R, y), error_covariance(first, R)
