# SPDX-License-Identifier: MIT
r"""Equilibria of the covariance equation over the rationals.

An equilibrium :math:`P_e` of D71 (3.46) is :math:`F\Gamma^{-1}`, where the columns of
:math:`\binom{F}{\Gamma}` span an `n`-dimensional invariant subspace of the matrix
:math:`R_p` of order `2n`.  Rational equilibria belong to rational subspaces, and these
to divisors of degree `n` of the characteristic polynomial.

Main definitions
----------------
``equilibria``                all rational equilibria
``equilibrium_from_basis``    the equilibrium of one invariant subspace
``stabilizing_equilibrium``   the one whose `J` has its eigenvalues outside the unit circle
``Equilibrium``, ``EquilibriumSet``   the results

Main statements
---------------
* Every divisor `f` of degree `n` of the characteristic polynomial with
  :math:`\dim\ker f(R_p) = n` gives one subspace, :math:`\ker f(R_p)`; if :math:`R_p` is
  nonderogatory this holds for every `f` and these are all rational subspaces.
* If all eigenvalues are rational and :math:`R_p` is nonderogatory, there are no other
  equilibria, real or complex.
* If :math:`\dim\ker f(R_p) > n`, the subspaces with this `f` form a continuous family.

Notation
--------
:math:`F`, :math:`\Gamma`, `J`, :math:`R_p` as in D71; `f` is the characteristic polynomial of `J`.

References
----------
D71 (3.46)-(3.52), Theorems 3.13-3.18, Examples 3.1 and 3.3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product as cartesian
from typing import Any

from flint import ctx, fmpq, fmpq_mat, fmpq_poly, fmpz_poly

from exactkf._errors import Unsupported
from exactkf.theory._matrices import Matrix, as_fmpq_mat, as_matrices, check_shape, is_symmetric
from exactkf.theory._scalars import Scalar, refused
from exactkf.theory.riccati import duven_matrix

__all__ = ["Equilibrium", "EquilibriumSet", "equilibria", "equilibrium_from_basis", "stabilizing_equilibrium"]


@dataclass(frozen=True)
class Equilibrium:
    r"""One equilibrium of the covariance equation.

    Attributes
    ----------
    P : Matrix, shape (n, n)
        :math:`F \Gamma^{-1}`.
    divisor : fmpq_poly
        Characteristic polynomial of `J`, that is of :math:`R_p` on the subspace.
    F, Gamma : Matrix, shape (n, n)
        Upper and lower half of a basis of the subspace.
    """

    P: Matrix
    divisor: fmpq_poly
    F: Matrix
    Gamma: Matrix

    @property
    def is_symmetric(self) -> bool:
        """Whether `P` equals its transpose."""
        return is_symmetric(self.P)

    @property
    def eigenvalues(self) -> tuple[fmpq, ...]:
        """The rational eigenvalues of `J` in ascending order, with multiplicity."""
        return _rational_roots(self.divisor)


@dataclass(frozen=True)
class EquilibriumSet:
    r"""All rational equilibria of the covariance equation.

    Attributes
    ----------
    isolated : tuple of Equilibrium
        One for each divisor whose subspace is unique and has invertible :math:`\Gamma`.
    singular : tuple of fmpq_poly
        Divisors whose subspace is unique but has singular :math:`\Gamma`: no equilibrium.
    families : tuple of fmpq_poly
        Divisors with a continuous family of subspaces; see `equilibrium_from_basis`.
    irreducible : tuple of fmpq_poly
        The irreducible factors of degree two or more of the characteristic polynomial.
        If there are none, no equilibrium outside `families` is missing.
    """

    isolated: tuple[Equilibrium, ...]
    singular: tuple[fmpq_poly, ...]
    families: tuple[fmpq_poly, ...]
    irreducible: tuple[fmpq_poly, ...]


def _rational_roots(f: fmpq_poly) -> tuple[fmpq, ...]:
    roots = [(-p[0] / p[1], m) for p, m in f.factor()[1] if p.degree() == 1]
    return tuple(root for root, m in sorted(roots) for _ in range(m))


def _problem(Phi: Any, H: Any, M: Any, V: Any) -> fmpq_mat:
    """Return the rational matrix ``R_p``."""
    return as_fmpq_mat("R_p", duven_matrix(Phi, H, M, V))


def _of_matrix(f: fmpq_poly, R: fmpq_mat) -> fmpq_mat:
    """Return ``f(R)`` by Horner's rule."""
    eye = fmpq_mat([[int(i == j) for j in range(R.nrows())] for i in range(R.nrows())])
    value = 0 * eye
    for coefficient in reversed(f.coeffs()):
        value = value * R + coefficient * eye
    return value


def _kernel(A: fmpq_mat) -> fmpq_mat | None:
    """Return a matrix whose columns are a basis of the kernel, or None if it is zero."""
    reduced, rank = A.rref()
    n = A.ncols()
    pivots = [next(j for j in range(n) if reduced[i, j] != 0) for i in range(rank)]
    free = [j for j in range(n) if j not in pivots]
    if not free:
        return None
    basis = fmpq_mat(n, len(free))
    for k, j in enumerate(free):
        basis[j, k] = fmpq(1)
        for i, pivot in enumerate(pivots):
            basis[pivot, k] = -reduced[i, j]
    return basis


def _rows(A: fmpq_mat) -> Matrix:
    return tuple(tuple(row) for row in A.tolist())


def _equilibrium(basis: fmpq_mat, divisor: fmpq_poly) -> Equilibrium | None:
    """Return the equilibrium of a subspace, or None if its lower half is singular."""
    n = basis.ncols()
    table = basis.tolist()
    F, Gamma = fmpq_mat(table[:n]), fmpq_mat(table[n:])
    if Gamma.rank() < n:
        return None
    return Equilibrium(_rows(F * Gamma.inv()), divisor, _rows(F), _rows(Gamma))


def equilibria(Phi: Any, H: Any, M: Any, V: Any) -> EquilibriumSet:
    r"""Return all rational equilibria of :math:`P = \Phi[P - PM'(MPM'+V)^{-1}MP]\Phi' + H`.

    Parameters
    ----------
    Phi : rational matrix, shape (n, n), nonsingular
    H : symmetric rational matrix, shape (n, n)
    M : rational matrix, shape (m, n)
    V : symmetric rational matrix, shape (m, m), nonsingular

    Returns
    -------
    EquilibriumSet

    Raises
    ------
    BadInput
        If the data are not rational, `Phi` or `V` is singular, `H` or `V` is not symmetric or the shapes do not fit.

    Examples
    --------
    D71 Example 3.1; the eigenvalues 1/2 and 2 of :math:`R_p` are double and derogatory:

    >>> from flint import fmpq
    >>> found = equilibria([[2, -1], [0, fmpq(1, 2)]], [[4, 6], [6, 9]], [[-1, fmpq(2, 3)]], [[1]])
    >>> [(e.eigenvalues, e.P) for e in found.isolated]
    [((2, 2), ((25/3, 8), (8, 12)))]
    >>> found.singular, found.families
    ((x^2 + (-1)*x + 1/4,), (x^2 + (-5/2)*x + 1,))

    D71 Example 3.3; its two nonnegative definite equilibria are irrational:

    >>> found = equilibria([[fmpq(3, 2), fmpq(-2, 3)], [0, fmpq(1, 2)]], [[4, 6], [6, 9]], [[-1, 1]], [[1]])
    >>> found.irreducible, [e.is_symmetric for e in found.isolated]
    ((x^2 + (-9/2)*x + 1,), [False, False])
    """
    R = _problem(Phi, H, M, V)
    n = R.nrows() // 2
    factors = [(p / p.leading_coefficient(), m) for p, m in R.charpoly().factor()[1]]
    factors.sort(key=lambda pair: (pair[0].degree(), [-c for c in pair[0].coeffs()]))
    isolated, singular, families = [], [], []
    for exponents in cartesian(*(range(m + 1) for _, m in factors)):
        if sum(p.degree() * e for (p, _), e in zip(factors, exponents, strict=True)) != n:
            continue
        divisor = fmpq_poly([1])
        for (p, _), e in zip(factors, exponents, strict=True):
            divisor *= p**e
        basis = _kernel(_of_matrix(divisor, R))
        if basis is None or basis.ncols() != n:
            families.append(divisor)
        elif (found := _equilibrium(basis, divisor)) is None:
            singular.append(divisor)
        else:
            isolated.append(found)
    irreducible = tuple(p for p, _ in factors if p.degree() > 1)
    return EquilibriumSet(tuple(isolated), tuple(singular), tuple(families), irreducible)


def equilibrium_from_basis(Phi: Any, H: Any, M: Any, V: Any, basis: Sequence[Sequence[Scalar]]) -> Equilibrium:
    r"""Return the equilibrium of the invariant subspace spanned by `basis` (D71 (3.81)).

    Parameters
    ----------
    Phi, H, M, V : as in `equilibria`
    basis : sequence of n rational vectors of length 2n

    Raises
    ------
    BadInput
        As `equilibria`; if the vectors are dependent, their span is not invariant under :math:`R_p`, or
        :math:`\Gamma` is singular.

    Examples
    --------
    A member of the family of D71 Example 3.1, (3.114) with ``x = y = 3``:

    >>> from flint import fmpq
    >>> problem = [[2, -1], [0, fmpq(1, 2)]], [[4, 6], [6, 9]], [[-1, fmpq(2, 3)]], [[1]]
    >>> equilibrium_from_basis(*problem, [[33, 36, 3, 1], [6, 9, 3, -2]]).P
    ((8, 9), (9, 9))
    """
    R = _problem(Phi, H, M, V)
    n = R.nrows() // 2
    (rows,) = as_matrices(basis=basis)
    check_shape("basis", rows, (n, 2 * n), "Phi")
    B = as_fmpq_mat("basis", rows).transpose()
    if B.rank() < n:
        raise refused("basis", rows, f"has rank {B.rank()}", f"pass {n} independent vectors")
    image = R * B
    if fmpq_mat([r + s for r, s in zip(B.tolist(), image.tolist(), strict=True)]).rank() > n:
        raise refused("basis", rows, "its span is not invariant under R_p", "pass eigenvectors or complete Jordan chains")
    gram = B.transpose() * B
    found = _equilibrium(B, gram.solve(B.transpose() * image).charpoly())
    if found is None:
        raise refused("basis", rows, "the lower half Gamma is singular, no equilibrium belongs to it", "pass another subspace")
    return found


def _position(p: fmpq_poly) -> str:
    """Return where the roots of an irreducible polynomial lie: "inside", "outside", "on" (degree one) or "both"."""
    if p.degree() == 1:
        size = abs(p[0] / p[1])
        return "on" if size == 1 else "outside" if size > 1 else "inside"
    coefficients = p.coeffs()
    if coefficients in (coefficients[::-1], [-c for c in reversed(coefficients)]):
        return "both"
    # Not self-reciprocal, so no root has modulus one and fine enough enclosures decide.
    precision = ctx.prec
    try:
        while True:
            roots: Any = fmpz_poly(p.numer().coeffs()).complex_roots()
            sizes = [abs(root) for root, _ in roots]
            if all(size > 1 for size in sizes):
                return "outside"
            if all(size < 1 for size in sizes):
                return "inside"
            if any(size > 1 for size in sizes) and any(size < 1 for size in sizes):
                return "both"
            ctx.prec *= 2
    finally:
        ctx.prec = precision


def stabilizing_equilibrium(Phi: Any, H: Any, M: Any, V: Any) -> Equilibrium:
    r"""Return the equilibrium whose `J` has all eigenvalues outside the unit circle.

    It is nonnegative definite for nonnegative definite data (D71 Theorem 3.17) and the
    only one that can be stable.

    Parameters
    ----------
    Phi, H, M, V : as in `equilibria`

    Raises
    ------
    BadInput
        As `equilibria`; if :math:`R_p` has an eigenvalue on the unit circle, or :math:`\Gamma` is singular.
    Unsupported
        If an irreducible factor has roots on both sides of the unit circle, or is of degree
        two or more with roots on it: then the equilibrium is irrational or does not exist.

    Examples
    --------
    >>> from flint import fmpq
    >>> stabilizing_equilibrium([[2]], [[0]], [[1]], [[1]]).P
    ((3,),)
    """
    R = _problem(Phi, H, M, V)
    divisor = fmpq_poly([1])
    for p, multiplicity in R.charpoly().factor()[1]:
        place = _position(p)
        if place == "on":
            raise refused("R_p", R, f"has the eigenvalue {-p[0] / p[1]} on the unit circle", "pass data without such a mode")
        if place == "both":
            raise Unsupported(
                f"R_p: the factor {p} has roots on both sides of or on the unit circle; no rational result"
            )
        if place == "outside":
            divisor *= (p / p.leading_coefficient()) ** multiplicity
    basis = _kernel(_of_matrix(divisor, R))
    found = None if basis is None else _equilibrium(basis, divisor)
    if found is None:
        raise refused("(Phi, M)", (Phi, M), "an unstable mode is unobservable, so Gamma is singular", "pass detectable data")
    return found
