# SPDX-License-Identifier: MIT
r"""The invariants of the fast filter.

The pseudo-polynomial :math:`D(z, z^{-1}) = \frac12 [a(z) b(1/z) + a(1/z) b(z)]
= d_0 + \sum_{i=1}^n d_i (z^i + z^{-i})` is multiplied by a scalar at every step.

Main definitions
----------------
``pseudo_polynomial``                   :math:`(d_0, \dots, d_n)` from `a` and `b`
``pseudo_polynomial_from_q``            the same from :math:`q` and :math:`q^*`
``pseudo_polynomial_from_parameters``   the same from :math:`\alpha` and :math:`\gamma`
``projective_invariants``               :math:`\kappa_i = 2 d_i / d_0`
``difference_of_squares``               :math:`Q(z)Q(1/z) - Q^*(z)Q^*(1/z)` over a ring

Main statements
---------------
* The three expressions agree, and :math:`d_n = \alpha_n`.
* :math:`r_t D_t = D_0` along every orbit (BLZ94 (2.18)), where
  :math:`r_t = \prod_{k<t} (1 - \gamma_k^2)`; so the :math:`\kappa_i` are constant.
* One step without division multiplies `difference_of_squares` by
  :math:`q_0^2 - (q_1^*)^2`, an identity of polynomials.

Notation
--------
``d = (d_0, ..., d_n)``; the coefficient of :math:`z^i` and of :math:`z^{-i}` is ``d[i]``.

References
----------
BLZ94 (2.13), (2.18), (4.10)-(4.13), (5.5), Lemma 4.4; BLM91 (2.28), (3.4).
"""

from __future__ import annotations

from collections.abc import Sequence

from exactkf.theory._scalars import Scalar, Vector, check_length, refused, unify, units
from exactkf.theory.szego import pi_polynomials, prediction_errors

__all__ = [
    "difference_of_squares",
    "projective_invariants",
    "pseudo_polynomial",
    "pseudo_polynomial_from_parameters",
    "pseudo_polynomial_from_q",
    "scaling_factor",
]


def _correlation(x: Vector, y: Vector, lag: int) -> Scalar:
    """Return the sum of ``x[j] * y[j + lag]``."""
    return sum((x[j] * y[j + lag] for j in range(1, len(x) - lag)), x[0] * y[lag])


def pseudo_polynomial(a: Sequence[Scalar], b: Sequence[Scalar]) -> Vector:
    r"""Return :math:`d_0, \dots, d_n` of the pair `a`, `b` (BLZ94 (2.13), (4.10)).

    Parameters
    ----------
    a, b : sequences of scalars, length n
        Lower coefficients of two monic polynomials.

    Returns
    -------
    tuple of scalars, length n + 1

    Raises
    ------
    BadInput
        If the lengths differ.

    Examples
    --------
    >>> from flint import fmpq
    >>> pseudo_polynomial([fmpq(-3, 10)], [fmpq(7, 10)])
    (79/100, 1/5)
    """
    a, b = unify(a=a, b=b)
    check_length("b", b, len(a), "a")
    one = units(a)[1]
    x, y = (one, *a), (one, *b)
    return tuple((_correlation(x, y, i) + _correlation(y, x, i)) / (one + 1) for i in range(len(x)))


def difference_of_squares(Q: Sequence[Scalar], Q_star: Sequence[Scalar]) -> Vector:
    r"""Return the coefficients of :math:`Q(z)Q(1/z) - Q^*(z)Q^*(1/z)` (BLM91 (2.28)).

    Parameters
    ----------
    Q : sequence of ring elements, length n + 1
    Q_star : sequence of ring elements, length n

    Returns
    -------
    tuple of ring elements, length n + 1
        The coefficient of :math:`z^i + z^{-i}` at index `i`.  No division is used.

    Raises
    ------
    BadInput
        If the lengths do not fit.
    """
    Q, Q_star = unify(Q=Q, Q_star=Q_star)
    if not Q:
        raise refused("Q", Q, "empty", "pass n + 1 coefficients")
    check_length("Q_star", Q_star, len(Q) - 1, "Q")
    star = (Q[0] - Q[0], *Q_star)
    return tuple(_correlation(Q, Q, i) - _correlation(star, star, i) for i in range(len(Q)))


def pseudo_polynomial_from_q(q: Sequence[Scalar], q_star: Sequence[Scalar]) -> Vector:
    r"""Return :math:`d_0, \dots, d_n` of :math:`a = q - q^*`, :math:`b = q + q^*` (BLM91 (2.28)).

    Parameters
    ----------
    q, q_star : sequences of ring elements, length n

    Raises
    ------
    BadInput
        If the lengths differ.
    """
    q, q_star = unify(q=q, q_star=q_star)
    check_length("q_star", q_star, len(q), "q")
    return difference_of_squares((units(q)[1], *q), q_star)


def pseudo_polynomial_from_parameters(alpha: Sequence[Scalar], gamma: Sequence[Scalar]) -> Vector:
    r"""Return :math:`d_0, \dots, d_n` from Kimura-Georgiou parameters (BLZ94 Lemma 4.4).

    Parameters
    ----------
    alpha, gamma : sequences of ring elements, length n

    Returns
    -------
    tuple of ring elements, length n + 1

    Raises
    ------
    BadInput
        If the lengths differ.

    Notes
    -----
    With :math:`d^{(0)} = 0`, :math:`\alpha_0 = 1` and `k` from 1 to `n`,

    .. math:: d_i^{(k)}(\alpha_1..\alpha_k, \gamma_0..\gamma_{k-1}) = (1 - \gamma_0^2)
        d_i^{(k-1)}(\alpha_1..\alpha_{k-1}, \gamma_1..\gamma_{k-1})
        + \alpha_k \sum_{j=i}^{k} \alpha_{k-j} \pi_{j,j-i}.

    The polynomials :math:`\pi_j` are those of `szego.pi_polynomials`, not of the
    misprinted recursion BLZ94 (4.12).

    Examples
    --------
    >>> from flint import fmpq
    >>> pseudo_polynomial_from_parameters([fmpq(1, 5)], [fmpq(1, 2)])
    (79/100, 1/5)
    """
    alpha, gamma = unify(alpha=alpha, gamma=gamma)
    check_length("gamma", gamma, len(alpha), "alpha")
    n = len(alpha)
    zero, one = units(alpha, gamma)
    weights = (one, *alpha)
    d = [zero] * (n + 1)
    for k in range(1, n + 1):  # alpha_1..alpha_k goes with gamma_{n-k}..gamma_{n-1}
        window = gamma[n - k :]
        pi = pi_polynomials(window)
        for i in range(1, k + 1):
            extra = sum((weights[k - j] * pi[j][j - i] for j in range(i, k + 1)), zero)
            d[i] = (1 - window[0] * window[0]) * d[i] + alpha[k - 1] * extra
    errors = prediction_errors(gamma)
    d[0] = sum((errors[n - j] * weights[j] * weights[j] for j in range(n + 1)), zero)
    return tuple(d)


def scaling_factor(gamma: Sequence[Scalar]) -> Scalar:
    r"""Return :math:`r_t = \prod_{k<t}(1 - \gamma_k^2)`, which restores `D` after `t` steps (BLZ94 (2.18)).

    Parameters
    ----------
    gamma : sequence of scalars, length t
        The Schur parameters of the steps taken.
    """
    return prediction_errors(gamma)[-1]


def projective_invariants(d: Sequence[Scalar]) -> Vector:
    r"""Return :math:`\kappa_i = 2 d_i / d_0` for ``i = 1, ..., n`` (BLZ94 (5.5), (5.6)).

    Parameters
    ----------
    d : sequence of scalars, length n + 1

    Raises
    ------
    BadInput
        If `d` is empty or :math:`d_0 = 0`; then no equilibrium has this pseudo-polynomial.

    Examples
    --------
    >>> from flint import fmpq
    >>> projective_invariants([fmpq(79, 100), fmpq(1, 5)])
    (40/79,)
    """
    (d,) = unify(d=d)
    if not d:
        raise refused("d", d, "empty, and d_0 is needed", "pass d_0, ..., d_n")
    if d[0] == 0:
        raise refused("d[0]", d[0], "the quotients 2 d_i / d_0 do not exist", "compare the vectors d up to a factor instead")
    return tuple(2 * value / d[0] for value in d[1:])
