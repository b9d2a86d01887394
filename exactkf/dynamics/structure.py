# SPDX-License-Identifier: MIT
r"""The linear algebra behind an orbit: `D`, the invariants, `S` and its invariant subspaces.

Main definitions
----------------
``structure``   everything that BLZ94 Sections 5 and 6 attach to a rational state
``Structure``   the result

Main statements
---------------
For the coprime pair of order `m` that is left after reduction, with :math:`Q(0) \ne 0`, `S` has order
`2m`, characteristic polynomial :math:`z^m D / d_m`, and one Jordan block for each eigenvalue, of the
multiplicity of the zero of `D` (`exactkf.kernel.orbit_n`, statement 1).  If `D` keeps one sign on the
circle and `w` is its stable spectral factor, the dominant and codominant `m`-dimensional invariant
subspaces are the kernels of :math:`z^m w(1/z)` and of `w` at `S` (BLZ94 Lemma 6.10).

References
----------
BLZ94 (5.5)-(5.9), (6.8), Proposition 6.6, Lemmas 6.7-6.12.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flint import fmpq, fmpq_mat

from exactkf._errors import BadInput
from exactkf.dynamics.spectral_factor import spectral_factor
from exactkf.exact.canonical import ElementaryDivisors, elementary_divisors
from exactkf.exact.circle import CircleZero, circle_zeros, sign_on_circle
from exactkf.kernel.linear import Matrix, null_basis
from exactkf.kernel.orbit_n import reduce_pair, spectral_polynomial, spectral_sign
from exactkf.kernel.roots import count_circle
from exactkf.theory._scalars import Scalar, check_length, unify
from exactkf.theory.power_method import symplectic_matrix_of

__all__ = ["Structure", "structure"]


@dataclass(frozen=True)
class Structure:
    r"""What belongs to a rational state.

    Attributes
    ----------
    order : int
        The order `m` of the reduced pair.
    start, factor : int, tuple of fmpq
        The steps that the reduction takes, and the factor taken out of `a` and `b`, from z^0 up.
    d : tuple of fmpq, length m + 1
        :math:`d_0, \dots, d_m` of the reduced pair: a point of projective space.
    kappa : tuple of fmpq or None
        :math:`2 d_i / d_0`; None if :math:`d_0 = 0`.
    sign : str
        As `exactkf.exact.circle.sign_on_circle`.
    circle_zeros : tuple of CircleZero
        The zeros of `D` on the circle with their multiplicities.
    positive_real : bool
        Whether the state is in the positive real region: `D` is positive on the circle, and `a` and `b`, with what they have in common, are Schur.
    S : fmpq_mat or None, shape (2m, 2m)
        None if ``m = 0``.
    elementary_divisors : tuple of ElementaryDivisors
        The Jordan structure of `S`.
    dominant, codominant : Matrix or None, shape (2m, m)
        Bases in columns; None if `D` changes sign on the circle or ``m = 0``.
    """

    order: int
    start: int
    factor: tuple[fmpq, ...]
    d: tuple[fmpq, ...]
    kappa: tuple[fmpq, ...] | None
    sign: str
    circle_zeros: tuple[CircleZero, ...]
    positive_real: bool
    S: fmpq_mat | None
    elementary_divisors: tuple[ElementaryDivisors, ...]
    dominant: Matrix | None
    codominant: Matrix | None


def structure(a: Sequence[Scalar], g: Sequence[Scalar]) -> Structure:
    """Return the structure behind the orbit of a rational state.

    Parameters
    ----------
    a, g : sequences of rationals, length n

    Raises
    ------
    BadInput
        If the entries are not rational, the lengths differ, or the orbit escapes before the
        reduction ends, in which case `D` is zero or the state next to an escape.

    Examples
    --------
    >>> found = structure([fmpq(-3, 10)], [fmpq(1, 2)])
    >>> found.kappa, found.sign, found.positive_real
    ((40/79,), 'positive', True)
    """
    a, g = unify(a=a, g=g)
    check_length("g", g, len(a), "a")
    if not a or not all(isinstance(x, fmpq) for x in (*a, *g)):
        raise BadInput("(a, g): not rational, or empty; pass rationals")
    Q, star = [x + y for x, y in zip(a, g, strict=True)][::-1] + [fmpq(1)], [*g[::-1], fmpq(0)]
    reduced = reduce_pair(Q, star)
    if reduced.escape is not None:
        raise BadInput(f"(a, g): the orbit escapes at step {reduced.escape}, before a pair with S is reached; pass another state")
    m, inside = len(reduced.Q) - 1, spectral_sign(spectral_polynomial(Q, star)) == "+" and count_circle(Q)[0] == len(a)
    D = spectral_polynomial(reduced.Q, reduced.S)
    d = tuple(fmpq(x) for x in D[m:])
    kappa = tuple(2 * x / d[0] for x in d[1:]) if d[0] != 0 else None
    sign = sign_on_circle(list(d))
    zeros = tuple(circle_zeros(list(d)))
    factor = tuple(fmpq(x) for x in reduced.removed)
    if m == 0:
        return Structure(0, reduced.start, factor, d, kappa, sign, zeros, inside, None, (), None, None)
    g_m = [fmpq(x) for x in reduced.S[-2::-1]]
    S = symplectic_matrix_of([x - y for x, y in zip(reduced.Q[-2::-1], g_m, strict=True)], g_m)
    dominant = codominant = None
    if sign != "indefinite":
        w = list(spectral_factor(D).coefficients)
        dominant, codominant = _kernel(w[::-1], S), _kernel(w, S)
    return Structure(m, reduced.start, factor, d, kappa, sign, zeros, inside, S,
                     tuple(elementary_divisors(S)), dominant, codominant)


def _kernel(p: list[Any], S: fmpq_mat) -> Matrix:
    """Return a basis of the kernel of p(S), p from z^0 up."""
    rows = [[x + 0 * p[0] for x in row] for row in S.tolist()]
    matrix, eye = Matrix(rows), Matrix.identity(len(rows))
    value = eye * p[-1]
    for c in reversed(p[:-1]):
        value = value * matrix + eye * c
    return null_basis(value)
