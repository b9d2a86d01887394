# SPDX-License-Identifier: MIT
r"""Hamiltonian matrices of the filtering problem and the semigroup they form.

Main definitions
----------------
``hamiltonian_matrix``            the matrix of the system :math:`(A, F, C)` (B93 (7))
``is_symplectic``                 :math:`M^* J M = J`
``membership``                    which of Sp, H, H1, H2, H0 contain `M`, and why not
``from_factors``, ``to_factors``  :math:`(A, P, Q) \leftrightarrow M`
``moebius``                       :math:`\Phi_M(T) = (AT+B)(CT+D)^{-1}` (B93 (12))

Main statements
---------------
* `M` is in H exactly if :math:`M = \begin{pmatrix} I & 0 \\ Q & I \end{pmatrix}
  \begin{pmatrix} A & 0 \\ 0 & A^{*-1} \end{pmatrix} \begin{pmatrix} I & P \\ 0 & I \end{pmatrix}`
  with invertible `A` and nonnegative `P`, `Q` (B93, proof of Theorem 1.7).
* :math:`\Phi_{MN} = \Phi_M \circ \Phi_N` (B93 (13)); H is a semigroup and H1, H2, H0
  are ideals in it (B93 Proposition 1.1).

Notation
--------
H1: :math:`A^*C > 0`.  H2: :math:`BA^* > 0`.  H0 is their intersection.  All matrices are
real, the star is the transpose, and :math:`J = \begin{pmatrix} 0 & I \\ -I & 0 \end{pmatrix}`.
The print has :math:`M^{-1} = JM^*J` for symplectic `M`; the sign must be reversed,
as ``M = I`` shows.  In the proof of Proposition 1.1 the names H1 and H2 are exchanged.

References
----------
B93 (7), (8), (12), (13), (17), Section 1.1.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from flint import fmpq_mat

from exactkf.theory._matrices import (
    Matrix,
    as_fmpq_mat,
    as_matrices,
    blocks,
    check_shape,
    check_square,
    check_symmetric,
    identity,
    inverse,
    minus,
    plus,
    product,
    solved,
    transposed,
    zeros,
)
from exactkf.theory._scalars import refused, units
from exactkf.theory.definiteness import negative_direction, nonpositive_direction

__all__ = [
    "Membership",
    "from_factors",
    "hamiltonian_matrix",
    "is_symplectic",
    "membership",
    "moebius",
    "to_factors",
]

Blocks = tuple[Matrix, Matrix, Matrix, Matrix]


def _blocks_of(M: Matrix) -> Blocks:
    """Return the four blocks ``A, B, C, D`` of a matrix of even order."""
    size = len(M)
    if size != len(M[0]) or size % 2:
        raise refused("M", M, f"has shape {size, len(M[0])} and is not square of even order", "pass a matrix of shape (2d, 2d)")
    d = size // 2
    top, low = M[:d], M[d:]
    left, right = slice(0, d), slice(d, size)
    return (
        tuple(r[left] for r in top),
        tuple(r[right] for r in top),
        tuple(r[left] for r in low),
        tuple(r[right] for r in low),
    )


def hamiltonian_matrix(A: Any, F: Any, C: Any) -> Matrix:
    r"""Return :math:`\begin{pmatrix} A & SA^{*-1} \\ RA & (I+RS)A^{*-1} \end{pmatrix}` (B93 (7)).

    Parameters
    ----------
    A : matrix, shape (d, d), nonsingular
    F : matrix, shape (d, p); :math:`S = FF^*`
    C : matrix, shape (q, d); :math:`R = C^*C`

    Returns
    -------
    Matrix, shape (2d, 2d)

    Raises
    ------
    BadInput
        If `A` is singular or the shapes do not fit.

    Examples
    --------
    >>> hamiltonian_matrix([[2]], [[1]], [[3]])
    ((2, 1/2), (18, 5))
    """
    A, F, C = as_matrices(A=A, F=F, C=C)
    d = check_square("A", A)
    check_shape("F", F, (d, len(F[0])), "A")
    check_shape("C", C, (len(C), d), "A")
    S, R = product(F, transposed(F)), product(transposed(C), C)
    low = inverse(transposed(A), "A")
    eye = identity(len(A), units(A[0])[1])
    return blocks([[A, product(S, low)], [product(R, A), product(plus(eye, product(R, S)), low)]])


def _symplectic_defect(parts: Blocks) -> str | None:
    """Return the first of the three block conditions that fails, in words, or None."""
    A, B, C, D = parts
    for name, value in (("A^T C", product(transposed(A), C)), ("B^T D", product(transposed(B), D))):
        for i, row in enumerate(value):
            for j in range(i):
                if row[j] != value[j][i]:
                    places = f"({i + 1}, {j + 1}) and ({j + 1}, {i + 1})"
                    return f"{name} is not symmetric: its entries {places} are {row[j]} and {value[j][i]}"
    rest = minus(product(transposed(A), D), product(transposed(C), B))
    for i, row in enumerate(rest):
        for j, value in enumerate(row):
            if value != int(i == j):
                return f"A^T D - C^T B is not the identity: its entry ({i + 1}, {j + 1}) is {value}"
    return None


def is_symplectic(M: Any) -> bool:
    r"""Say whether :math:`M^* J M = J`.

    Raises
    ------
    BadInput
        If `M` is not square of even order.
    """
    (M,) = as_matrices(M=M)
    return _symplectic_defect(_blocks_of(M)) is None


@dataclass(frozen=True)
class Membership:
    """Which of the sets Sp, H, H1, H2, H0 contain a matrix.

    Attributes
    ----------
    reasons : mapping of str to str or None
        For each of the names "Sp", "H", "H1", "H2", "H0": None if the matrix belongs to the
        set, otherwise the reason why not.
    """

    reasons: Mapping[str, str | None]

    def __contains__(self, name: str) -> bool:
        """Say whether the matrix belongs to the set of that name."""
        return self.reasons[name] is None


def _sign_defect(name: str, S: Matrix, strict: bool) -> str | None:
    """Return in words why `S` is not nonnegative, or not positive if `strict`, or None."""
    x = nonpositive_direction(S) if strict else negative_direction(S)
    if x is None:
        return None
    vector = tuple((value,) for value in x)
    value = product(transposed(vector), S, vector)[0][0]
    text = ", ".join(str(entry) for entry in x)
    kind = "positive definite" if strict else "positive semidefinite"
    return f"{name} is not {kind}: x = ({text}) gives x^T {name} x = {value}"


def membership(M: Any) -> Membership:
    r"""Say to which of the sets Sp, H, H1, H2, H0 of B93 Section 1.1 a rational matrix belongs.

    Parameters
    ----------
    M : rational matrix, shape (2d, 2d)

    Returns
    -------
    Membership

    Raises
    ------
    BadInput
        If `M` is not rational or not square of even order.

    Examples
    --------
    >>> result = membership([[1, 0], [-2, 1]])
    >>> "Sp" in result, "H" in result
    (True, False)
    >>> result.reasons["H"]
    'A^T C is not positive semidefinite: x = (1) gives x^T A^T C x = -2'
    """
    rational = tuple(tuple(row) for row in as_fmpq_mat("M", M).tolist())
    A, B, C, D = _blocks_of(rational)
    sp = _symplectic_defect((A, B, C, D))
    outer, inner = product(B, transposed(A)), product(transposed(A), C)
    h = sp
    if h is None and fmpq_mat([list(row) for row in A]).rank() < len(A):
        h = "A is singular"
    if h is None:
        h = _sign_defect("B A^T", outer, strict=False) or _sign_defect("A^T C", inner, strict=False)
    h1 = h or _sign_defect("A^T C", inner, strict=True)
    h2 = h or _sign_defect("B A^T", outer, strict=True)
    return Membership(MappingProxyType({"Sp": sp, "H": h, "H1": h1, "H2": h2, "H0": h1 or h2}))


def from_factors(A: Any, P: Any, Q: Any) -> Matrix:
    r"""Return :math:`\begin{pmatrix} A & AP \\ QA & QAP + A^{*-1} \end{pmatrix}` (B93 Section 1.2).

    Parameters
    ----------
    A : matrix, shape (d, d), nonsingular
    P, Q : symmetric matrices, shape (d, d)

    Raises
    ------
    BadInput
        If `A` is singular, `P` or `Q` is not symmetric or the shapes do not fit.
    """
    A, P, Q = as_matrices(A=A, P=P, Q=Q)
    d = check_square("A", A)
    check_symmetric("P", P, d, "A")  # otherwise the product would not be symplectic
    check_symmetric("Q", Q, d, "A")
    one = units(A[0])[1]
    eye, none = identity(len(A), one), zeros(len(A), len(A), one)
    middle = blocks([[A, none], [none, inverse(transposed(A), "A")]])
    return product(blocks([[eye, none], [Q, eye]]), middle, blocks([[eye, P], [none, eye]]))


def to_factors(M: Any) -> tuple[Matrix, Matrix, Matrix]:
    r"""Return :math:`A`, :math:`P = A^{-1}B`, :math:`Q = CA^{-1}`, the inverse of `from_factors`.

    Raises
    ------
    BadInput
        If `M` is not square of even order, not symplectic or its block `A` is singular.
    """
    (M,) = as_matrices(M=M)
    A, B, C, D = _blocks_of(M)
    defect = _symplectic_defect((A, B, C, D))
    if defect is not None:
        raise refused("M", M, f"not symplectic, {defect}", "pass a symplectic matrix")
    return A, solved(A, B, "the block A of M"), transposed(solved(transposed(A), transposed(C), "the block A of M"))


def moebius(M: Any, T: Any) -> Matrix:
    r"""Return :math:`\Phi_M(T) = (AT + B)(CT + D)^{-1}` (B93 (12)).

    Parameters
    ----------
    M : matrix, shape (2d, 2d)
    T : matrix, shape (d, d)

    Raises
    ------
    BadInput
        If the shapes do not fit or :math:`CT + D` is singular, which is impossible for `M` in H and nonnegative `T`.

    Examples
    --------
    >>> moebius([[2, 0], [0, 1]], [[3]])
    ((6,),)
    """
    M, T = as_matrices(M=M, T=T)
    A, B, C, D = _blocks_of(M)
    check_shape("T", T, (len(A), len(A)), "M")
    right = plus(product(C, T), D)
    return transposed(solved(transposed(right), transposed(plus(product(A, T), B)), "CT + D"))
