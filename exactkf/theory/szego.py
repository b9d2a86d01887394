# SPDX-License-Identifier: MIT
r"""Szegö polynomials and Schur parameters.

A sequence :math:`c_1, c_2, \dots` with nonsingular Toeplitz matrices and a
sequence of Schur parameters with :math:`\gamma_k^2 \ne 1` determine each other.
Positivity of the Toeplitz matrices is never used.

Main definitions
----------------
``schur_parameters``, ``levinson``, ``covariances``
    The two directions of the correspondence (Levinson's recursion).
``szego_polynomials``, ``second_kind_polynomials``
    :math:`\varphi_t` and :math:`\psi_t`, the latter with :math:`-\gamma`.
``pi_polynomials``, ``rho_polynomials``
    Half sum :math:`\pi_t` and half difference :math:`\rho_t` of the two.
``prediction_errors``
    :math:`r_t = \prod_{k<t} (1 - \gamma_k^2)`.
``toeplitz``, ``toeplitz_determinants``
    The matrices :math:`T_t` and their determinants.
``szego_matrix``, ``second_kind_matrix``, ``covariance_matrix``
    :math:`\Phi_{n+1}`, :math:`\Psi_{n+1}`, :math:`C_{n+1}`.

Main statements
---------------
* :math:`\det T_t = \prod_{k=0}^t r_k` (BLZ94 Proposition 3.1).
* :math:`T_t (\varphi_{tt}, \dots, \varphi_{t1}, 1)' = (0, \dots, 0, r_t)'`
  (BLZ94 (3.19); the printed matrix lacks its last column).
* :math:`\Psi_{n+1} = C_{n+1} \Phi_{n+1}` (BLZ94 Lemma 3.3).

Notation
--------
A polynomial is the tuple of its coefficients, highest power first:
:math:`\varphi_t(z) = z^t + \varphi_{t1} z^{t-1} + \dots` is
``(1, phi_t1, ..., phi_tt)``.  ``c = (c_1, c_2, ...)`` leaves out ``c_0 = 1``.

References
----------
BLZ94 (3.2)-(3.19); BLM91 (2.5)-(2.10).
"""

from __future__ import annotations

from collections.abc import Sequence

from exactkf.theory._matrices import Matrix
from exactkf.theory._scalars import Scalar, Vector, refused, unify, units

__all__ = [
    "covariance_matrix",
    "covariances",
    "levinson",
    "pi_polynomials",
    "prediction_errors",
    "reversed_polynomial",
    "rho_polynomials",
    "schur_parameters",
    "second_kind_matrix",
    "second_kind_polynomials",
    "szego_matrix",
    "szego_polynomials",
    "toeplitz",
    "toeplitz_determinants",
]


def reversed_polynomial(polynomial: Sequence[Scalar]) -> Vector:
    r"""Return :math:`\varphi^*(z) = z^t \varphi(1/z)`, where `t` is the formal degree (BLZ94 (3.4))."""
    (coefficients,) = unify(polynomial=polynomial)
    return coefficients[::-1]


def _next(phi: Vector, gamma: Scalar) -> Vector:
    r"""Return :math:`z \varphi - \gamma \varphi^*` (BLZ94 (3.5))."""
    zero = gamma - gamma
    return tuple(x - gamma * y for x, y in zip((*phi, zero), (zero, *phi[::-1]), strict=True))


def szego_polynomials(gamma: Sequence[Scalar]) -> list[Vector]:
    r"""Return the Szegö polynomials :math:`\varphi_0, \dots, \varphi_m` of BLZ94 (3.5).

    Parameters
    ----------
    gamma : sequence of scalars, length m
        Schur parameters :math:`\gamma_0, \dots, \gamma_{m-1}`; any values.

    Returns
    -------
    list of tuple
        Entry `t` has the ``t + 1`` coefficients of the monic :math:`\varphi_t`.

    Examples
    --------
    >>> from flint import fmpq
    >>> szego_polynomials([fmpq(1, 2), fmpq(1, 3)])
    [(1,), (1, -1/2), (1, -1/3, -1/3)]
    """
    (gamma,) = unify(gamma=gamma)
    polynomials = [(units(gamma)[1],)]
    for value in gamma:
        polynomials.append(_next(polynomials[-1], value))
    return polynomials


def second_kind_polynomials(gamma: Sequence[Scalar]) -> list[Vector]:
    r"""Return :math:`\psi_0, \dots, \psi_m`, the Szegö polynomials of :math:`-\gamma` (BLZ94 (3.9))."""
    (gamma,) = unify(gamma=gamma)
    return szego_polynomials([-value for value in gamma])


def _half_sums(gamma: Sequence[Scalar]) -> list[tuple[Vector, Vector]]:
    r"""Return the pairs :math:`(\pi_t, \rho_t^*)` for ``t = 0, ..., m``, both of formal degree `t`."""
    (gamma,) = unify(gamma=gamma)
    zero, one = units(gamma)
    pairs: list[tuple[Vector, Vector]] = [((one,), (zero,))]
    for value in gamma:
        shifted, old = (*pairs[-1][0], zero), (zero, *pairs[-1][1])
        pi = tuple(x + value * y for x, y in zip(shifted, old, strict=True))
        pairs.append((pi, tuple(y + value * x for x, y in zip(shifted, old, strict=True))))
    return pairs


def pi_polynomials(gamma: Sequence[Scalar]) -> list[Vector]:
    r"""Return :math:`\pi_t = (\psi_t + \varphi_t)/2` for ``t = 0, ..., m`` (BLZ94 (3.18)).

    Computed from :math:`\pi_{t+1} = z\pi_t + \gamma_t \rho_t^*` and
    :math:`\rho_{t+1}^* = \rho_t^* + \gamma_t z \pi_t`, without division.  The
    three-term recursion printed as BLZ94 (4.12) is right for :math:`\pi_2` and wrong
    from :math:`\pi_3` on; the recursion that follows from the two above is
    :math:`\gamma_{t-1} \pi_{t+1} = (\gamma_{t-1} z + \gamma_t) \pi_t
    + \gamma_t (\gamma_{t-1}^2 - 1) z \pi_{t-1}`.
    """
    return [pi for pi, _ in _half_sums(gamma)]


def rho_polynomials(gamma: Sequence[Scalar]) -> list[Vector]:
    r"""Return :math:`\rho_t = (\psi_t - \varphi_t)/2` for ``t = 0, ..., m`` (BLZ94 (3.16))."""
    return [rho_star[::-1] for _, rho_star in _half_sums(gamma)]


def prediction_errors(gamma: Sequence[Scalar]) -> Vector:
    r"""Return :math:`r_0 = 1, r_1, \dots, r_m` with :math:`r_{t+1} = (1 - \gamma_t^2) r_t` (BLZ94 (3.7))."""
    (gamma,) = unify(gamma=gamma)
    errors = [units(gamma)[1]]
    for value in gamma:
        errors.append((1 - value * value) * errors[-1])
    return tuple(errors)


def schur_parameters(c: Sequence[Scalar]) -> Vector:
    r"""Return the Schur parameters of a covariance sequence (BLZ94 (3.6)).

    Parameters
    ----------
    c : sequence of scalars, length m
        :math:`c_1, \dots, c_m`; :math:`c_0 = 1` is understood.

    Returns
    -------
    tuple of scalars, length m
        :math:`\gamma_0, \dots, \gamma_{m-1}`.

    Raises
    ------
    BadInput
        If :math:`\gamma_k^2 = 1` for some ``k < m - 1``: then the Toeplitz matrix
        :math:`T_{k+1}` is singular and the recursion stops.

    Examples
    --------
    >>> from flint import fmpq
    >>> schur_parameters([fmpq(1, 2), fmpq(1, 2)])
    (1/2, 1/3)
    """
    gamma, stop = levinson(c)
    if stop is not None:
        problem = f"gamma[{stop}]^2 = 1, the Toeplitz matrix T_{stop + 1} is singular and the recursion stops"
        raise refused("c", tuple(c), problem, f"pass at most {stop + 1} covariances")
    return gamma


def levinson(c: Sequence[Scalar]) -> tuple[Vector, int | None]:
    r"""Return the Schur parameters that exist, and where the recursion stops.

    Parameters
    ----------
    c : sequence of scalars, length m
        :math:`c_1, \dots, c_m`.

    Returns
    -------
    gamma : tuple of scalars
        All ``m`` Schur parameters, or those up to the first with square one.
    stop : int or None
        The ``k < m - 1`` with :math:`\gamma_k^2 = 1`, if there is one (BLZ94 (3.5)-(3.7)).
    """
    (c,) = unify(c=c)
    phi: Vector = (units(c)[1],)
    error = phi[0]
    gamma: list[Scalar] = []
    for t in range(len(c)):
        if error == 0:
            return tuple(gamma), t - 1
        gamma.append(sum((phi[t - k] * c[k] for k in range(1, t + 1)), phi[t] * c[0]) / error)
        phi = _next(phi, gamma[t])
        error = error * (1 - gamma[t] * gamma[t])
    return tuple(gamma), None


def covariances(gamma: Sequence[Scalar]) -> Vector:
    r"""Return :math:`c_1, \dots, c_m` from Schur parameters (BLZ94 (3.10)).

    Inverse of `schur_parameters` as long as :math:`\gamma_k^2 \ne 1` for ``k < m - 1``;
    the formula itself is polynomial and needs no assumption.
    """
    (gamma,) = unify(gamma=gamma)
    errors, polynomials = prediction_errors(gamma), szego_polynomials(gamma)
    c: list[Scalar] = []
    for k, value in enumerate(gamma):
        c.append(errors[k] * value - sum((polynomials[k][k - j] * c[j] for j in range(k)), value - value))
    return tuple(c)


def toeplitz(c: Sequence[Scalar], t: int | None = None) -> Matrix:
    r"""Return the Toeplitz matrix :math:`T_t` of order ``t + 1`` (BLZ94 (3.2)).

    Parameters
    ----------
    c : sequence of scalars, length m
        :math:`c_1, \dots, c_m`.
    t : int, optional
        Index, at most ``m``, which is the default.

    Raises
    ------
    BadInput
        If `t` is no integer, negative, or exceeds ``m``.
    """
    (c,) = unify(c=c)
    order = len(c) if t is None else t
    if isinstance(order, bool) or not isinstance(order, int) or not 0 <= order <= len(c):
        raise refused("t", t, f"T_t needs c_1, ..., c_t, and c has {len(c)}", f"pass an integer 0 <= t <= {len(c)}")
    full = (units(c)[1], *c)
    return tuple(tuple(full[abs(i - j)] for j in range(order + 1)) for i in range(order + 1))


def toeplitz_determinants(gamma: Sequence[Scalar]) -> Vector:
    r"""Return :math:`\det T_0, \dots, \det T_m`, where :math:`\det T_t = \prod_{k \le t} r_k` (BLZ94 Prop. 3.1)."""
    errors = prediction_errors(gamma)
    determinants = [errors[0]]
    for error in errors[1:]:
        determinants.append(determinants[-1] * error)
    return tuple(determinants)


def _triangle(polynomials: Sequence[Vector]) -> Matrix:
    """Return the lower triangular matrix whose columns are the polynomials, highest degree first."""
    n = len(polynomials) - 1
    zero = polynomials[0][0] - polynomials[0][0]
    columns = [(zero,) * (n - t) + polynomials[t] for t in range(n, -1, -1)]
    return tuple(zip(*columns, strict=True))


def szego_matrix(gamma: Sequence[Scalar]) -> Matrix:
    r"""Return :math:`\Phi_{n+1}(\gamma)`, lower triangular of order ``n + 1`` (BLZ94 (3.14a))."""
    return _triangle(szego_polynomials(gamma))


def second_kind_matrix(gamma: Sequence[Scalar]) -> Matrix:
    r"""Return :math:`\Psi_{n+1}(\gamma) = \Phi_{n+1}(-\gamma)` (BLZ94 (3.14b), Corollary 3.4)."""
    return _triangle(second_kind_polynomials(gamma))


def covariance_matrix(c: Sequence[Scalar]) -> Matrix:
    r"""Return :math:`C_{n+1}`: ones on the diagonal, :math:`2c_k` on the k-th subdiagonal (BLZ94 (3.14c))."""
    (c,) = unify(c=c)
    zero, one = units(c)
    first = (one, *(2 * value for value in c))
    return tuple(tuple(first[i - j] if i >= j else zero for j in range(len(first))) for i in range(len(first)))
