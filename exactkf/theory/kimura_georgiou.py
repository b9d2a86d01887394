# SPDX-License-Identifier: MIT
r"""The Kimura-Georgiou parametrisation of rational functions.

Every pair of monic polynomials `a`, `b` of degree `n` whose quotient has `n`
nonsingular Toeplitz matrices is, in exactly one way,

.. math:: a = \varphi_n + \alpha_1 \varphi_{n-1} + \dots + \alpha_n, \qquad
          b = \psi_n + \alpha_1 \psi_{n-1} + \dots + \alpha_n .

Main definitions
----------------
``from_kimura_georgiou``   :math:`(\alpha, \gamma) \mapsto (a, b)`, polynomial
``to_kimura_georgiou``     :math:`(a, b) \mapsto (\alpha, \gamma)`, rational
``laurent_covariances``    :math:`c_1, c_2, \dots` of :math:`b / 2a`

Main statements
---------------
The two maps are inverse to each other where :math:`\gamma_k^2 \ne 1` for
:math:`k = 0, \dots, n-2` (BLZ94 Theorem 3.2, Proposition 4.1).

Notation
--------
``a = (a_1, ..., a_n)`` stands for the monic polynomial :math:`z^n + a_1 z^{n-1} + \dots + a_n`.

References
----------
BLZ94 (3.9)-(3.12), (3.21), (4.1).
"""

from __future__ import annotations

from collections.abc import Sequence

from exactkf.exact._messages import check_count
from exactkf.theory._scalars import Scalar, Vector, check_length, refused, unify, units
from exactkf.theory.szego import levinson, second_kind_polynomials, szego_polynomials

__all__ = ["from_kimura_georgiou", "laurent_covariances", "to_kimura_georgiou"]

_MOST_COVARIANCES = 10**4


def _combined(alpha: Vector, polynomials: Sequence[Vector]) -> Vector:
    r"""Return the lower `n` coefficients of :math:`p_n + \alpha_1 p_{n-1} + \dots + \alpha_n p_0`."""
    n = len(alpha)
    total = list(polynomials[n][1:])
    for j, weight in enumerate(alpha, start=1):
        for i, coefficient in enumerate(polynomials[n - j]):
            total[j - 1 + i] = total[j - 1 + i] + weight * coefficient
    return tuple(total)


def from_kimura_georgiou(alpha: Sequence[Scalar], gamma: Sequence[Scalar]) -> tuple[Vector, Vector]:
    r"""Return the polynomials `a` and `b` with parameters :math:`(\alpha, \gamma)` (BLZ94 (3.12)).

    Parameters
    ----------
    alpha, gamma : sequences of scalars, length n
        Any values; the map is polynomial.

    Returns
    -------
    a, b : tuples of scalars, length n
        Coefficients below the leading one.

    Raises
    ------
    BadInput
        If the lengths differ.

    Examples
    --------
    >>> from flint import fmpq
    >>> from_kimura_georgiou([fmpq(1, 5)], [fmpq(1, 2)])
    ((-3/10,), (7/10,))
    """
    alpha, gamma = unify(alpha=alpha, gamma=gamma)
    check_length("gamma", gamma, len(alpha), "alpha")
    return _combined(alpha, szego_polynomials(gamma)), _combined(alpha, second_kind_polynomials(gamma))


def laurent_covariances(a: Sequence[Scalar], b: Sequence[Scalar], count: int | None = None) -> Vector:
    r"""Return :math:`c_1, \dots, c_m` from :math:`b(z)/2a(z) = 1/2 + c_1 z^{-1} + c_2 z^{-2} + \dots` (BLZ94 (3.11)).

    Parameters
    ----------
    a, b : sequences of scalars, length n
    count : int, optional
        The number ``m`` of coefficients, by default ``n``.

    Raises
    ------
    BadInput
        If the lengths differ, or `count` is negative or more than 10,000.
    """
    a, b = unify(a=a, b=b)
    check_length("b", b, len(a), "a")
    if count is not None:
        check_count("count", count, 0, _MOST_COVARIANCES)
    zero, one = units(a)
    n = len(a)
    c: list[Scalar] = []
    for k in range(1, (n if count is None else count) + 1):
        numerator = (b[k - 1] - a[k - 1]) / (one + 1) if k <= n else zero
        c.append(numerator - sum((a[j - 1] * c[k - j - 1] for j in range(1, min(k, n + 1))), zero))
    return tuple(c)


def to_kimura_georgiou(a: Sequence[Scalar], b: Sequence[Scalar]) -> tuple[Vector, Vector]:
    r"""Return the parameters :math:`(\alpha, \gamma)` of the pair `a`, `b` (BLZ94 Theorem 3.2).

    Parameters
    ----------
    a, b : sequences of scalars, length n

    Returns
    -------
    alpha, gamma : tuples of scalars, length n

    Raises
    ------
    BadInput
        If the lengths differ, or if a Toeplitz matrix :math:`T_1, \dots, T_{n-1}` of
        :math:`b/2a` is singular: then no parameters exist.

    Examples
    --------
    >>> from flint import fmpq
    >>> to_kimura_georgiou([fmpq(-3, 10)], [fmpq(7, 10)])
    ((1/5,), (1/2,))
    """
    a, b = unify(a=a, b=b)
    gamma, stop = levinson(laurent_covariances(a, b))
    if stop is not None:
        problem = f"the Schur parameter gamma[{stop}] has square 1, so alpha and gamma do not exist"
        raise refused("(a, b)", (a, b), problem, "pass polynomials with nonsingular Toeplitz matrices T_1, ..., T_(n-1)")
    polynomials = szego_polynomials(gamma)
    n = len(a)
    rest = [x - y for x, y in zip(a, polynomials[n][1:], strict=True)]
    alpha: list[Scalar] = []
    for j in range(1, n + 1):
        alpha.append(rest[j - 1])
        for i, coefficient in enumerate(polynomials[n - j]):
            rest[j - 1 + i] = rest[j - 1 + i] - alpha[-1] * coefficient
    return tuple(alpha), gamma
