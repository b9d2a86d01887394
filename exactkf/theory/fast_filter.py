# SPDX-License-Identifier: MIT
r"""The fast filtering algorithm in its three coordinate systems.

The algorithm is one dynamical system on pairs of monic polynomials, or of
vectors of length `n`; its first covector is the sequence of Schur parameters.

Main definitions
----------------
``step_ag``            one step in :math:`(a, g)` (BLZ94 (2.16))
``step_alpha_gamma``   one step in :math:`(\alpha, \gamma)` (BLZ94 (4.4)-(4.6))
``step_q``             one step in :math:`(q, q^*)` (BLM91 (2.25))
``step_polynomials``   one step in :math:`(Q, Q^*)` (BLM91 (2.27)), linear given :math:`\gamma_t`
``step_numerators``    one step without division, in homogeneous coordinates
``gain``               the Kalman gain :math:`k_t`

Main statements
---------------
* The four steps commute with the conversions below.
* :math:`r_t (q_t, q_t^*)` satisfies the recursion of the Szegö polynomials.
* A state has no successor exactly if :math:`\gamma_t^2 = 1` (escape).

Notation
--------
:math:`a = q - q^*`, :math:`g = q^*`, :math:`b = a + 2g`,
:math:`\gamma_t = g_1(t) = q^*_1(t)`; :math:`J` is the shift upwards.

References
----------
BLZ94 (2.16)-(2.17), (4.4)-(4.9); BLM91 (2.20)-(2.28).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from exactkf.theory._matrices import Matrix
from exactkf.theory._scalars import Scalar, Vector, check_length, refused, unify, unify_pair, units
from exactkf.theory.kimura_georgiou import from_kimura_georgiou, to_kimura_georgiou

__all__ = [
    "State",
    "ag_from_alpha_gamma",
    "ag_from_q",
    "alpha_gamma_from_ag",
    "alpha_matrix",
    "gain",
    "gamma_matrix",
    "q_from_ag",
    "step_ag",
    "step_alpha_gamma",
    "step_numerators",
    "step_polynomials",
    "step_q",
]

State = tuple[Vector, Vector]


def _coordinates(name: str, values: Sequence[Scalar]) -> Vector:
    """Return the vector over one scalar type, of length at least one."""
    (vector,) = unify(**{name: values})
    if not vector:
        raise refused(name, vector, "empty, and the filter needs n >= 1", "pass at least one coefficient")
    return vector


def _polynomials(Q: Sequence[Scalar], Q_star: Sequence[Scalar]) -> State:
    """Return `Q` and `Q_star` over one scalar type, of lengths ``n + 1`` and ``n >= 1``."""
    Q, Q_star = unify(Q=Q, Q_star=Q_star)
    if len(Q) < 2:
        raise refused("Q", Q, "has fewer than two coefficients, and the filter needs n >= 1", "pass n + 1 coefficients")
    check_length("Q_star", Q_star, len(Q) - 1, "Q")
    return Q, Q_star


def _require_no_escape(name: str, gamma: Scalar) -> Scalar:
    """Return ``1 - gamma^2``; refuse zero."""
    rest = 1 - gamma * gamma
    if rest == 0:
        raise refused(name, gamma, "no next state exists when gamma_t^2 = 1", "pass another value")
    return rest


def step_ag(a: Sequence[Scalar], g: Sequence[Scalar]) -> State:
    r"""Return the next :math:`(a, g)` (BLZ94 (2.16)).

    Parameters
    ----------
    a, g : sequences of scalars, length n

    Returns
    -------
    a, g : tuples of scalars, length n

    Raises
    ------
    BadInput
        If the lengths differ, or if :math:`g_1^2 = 1` (escape).

    Examples
    --------
    >>> from flint import fmpq
    >>> step_ag([fmpq(-3, 10)], [fmpq(1, 2)])
    ((2/5,), (-2/15,))
    """
    a, g = unify_pair(a=a, g=g)
    first = g[0]
    rest = _require_no_escape("g[0]", first)
    shifted = (*g[1:], first - first)
    new_a = tuple((x + y - z) / (1 - first) for x, y, z in zip(a, g, shifted, strict=True))
    new_g = tuple((z - first * (x + y)) / rest for x, y, z in zip(a, g, shifted, strict=True))
    return new_a, new_g


def step_q(q: Sequence[Scalar], q_star: Sequence[Scalar]) -> State:
    r"""Return the next :math:`(q, q^*)` (BLM91 (2.25)); arguments, result and errors as `step_ag`."""
    q, q_star = unify_pair(q=q, q_star=q_star)
    first = q_star[0]
    rest = _require_no_escape("q_star[0]", first)
    shifted = (*q_star[1:], first - first)
    new_q = tuple((x - first * z) / rest for x, z in zip(q, shifted, strict=True))
    new_q_star = tuple((z - first * x) / rest for x, z in zip(q, shifted, strict=True))
    return new_q, new_q_star


def step_polynomials(Q: Sequence[Scalar], Q_star: Sequence[Scalar]) -> State:
    r"""Return the next :math:`(Q, Q^*)` (BLM91 (2.27)).

    Parameters
    ----------
    Q : sequence of scalars, length n + 1
        :math:`Q_t = r_t (z^n + q_1 z^{n-1} + \dots)`, leading coefficient :math:`r_t \ne 0`.
    Q_star : sequence of scalars, length n
        :math:`Q_t^* = r_t (q_1^* z^{n-1} + \dots)`.

    Returns
    -------
    Q, Q_star : tuples of scalars, lengths n + 1 and n

    Raises
    ------
    BadInput
        If the lengths do not fit or ``Q[0] = 0``.  A result with ``Q[0] = 0`` is an escape.
    """
    Q, Q_star = _polynomials(Q, Q_star)
    if Q[0] == 0:
        raise refused("Q[0]", Q[0], "the leading coefficient r_t must not vanish", "pass a state before the escape")
    gamma = Q_star[0] / Q[0]
    shifted = (*Q_star, gamma - gamma)
    new = tuple(x - gamma * y for x, y in zip(Q, shifted, strict=True))
    return new, tuple(y - gamma * x for x, y in zip(Q[1:], shifted[1:], strict=True))


def step_numerators(Q: Sequence[Scalar], Q_star: Sequence[Scalar]) -> State:
    r"""Return the next :math:`(Q, Q^*)` times ``Q[0]``: one step over a ring, without division.

    With :math:`q_0` for ``Q[0]``: :math:`q_0 Q - Q^*_1 z Q^*` and :math:`q_0 z Q^* - Q^*_1 Q`.
    Started at ``(1, q_1, ..., q_n)`` the result is :math:`1 - \gamma^2` times the next state.

    Parameters
    ----------
    Q, Q_star : sequences of ring elements, lengths n + 1 and n

    Returns
    -------
    Q, Q_star : tuples of ring elements, lengths n + 1 and n

    Raises
    ------
    BadInput
        If the lengths do not fit.
    """
    Q, Q_star = _polynomials(Q, Q_star)
    lead, first = Q[0], Q_star[0]
    shifted = (*Q_star, first - first)
    new = tuple(lead * x - first * y for x, y in zip(Q, shifted, strict=True))
    return new, tuple(lead * y - first * x for x, y in zip(Q[1:], shifted[1:], strict=True))


def alpha_matrix(gamma: Sequence[Scalar]) -> Matrix:
    r"""Return :math:`A(\gamma)`, upper triangular of order `n` (BLZ94 (4.5)).

    Raises
    ------
    BadInput
        If `gamma` is empty or :math:`\gamma_k^2 = 1` for some `k`.
    """
    gamma = _coordinates("gamma", gamma)
    rest = [_require_no_escape(f"gamma[{k}]", value) for k, value in enumerate(gamma)]
    zero, one = units(gamma)
    n = len(gamma)
    rows = []
    for i in range(n - 1, -1, -1):
        row = [zero] * (n - 1 - i) + [one / rest[i]]
        scale = gamma[i] / rest[i]
        for j in range(i - 1, -1, -1):
            scale = scale / rest[j]
            row.append(scale * gamma[j])
        rows.append(tuple(row))
    return tuple(rows)


def gamma_matrix(alpha: Sequence[Scalar]) -> Matrix:
    r"""Return :math:`G(\alpha)`, the companion matrix of BLZ94 (4.6).

    Raises
    ------
    BadInput
        If `alpha` is empty.
    """
    alpha = _coordinates("alpha", alpha)
    zero, one = units(alpha)
    n = len(alpha)
    shift = [tuple(one if j == i + 1 else zero for j in range(n)) for i in range(n - 1)]
    return (*shift, tuple(-value for value in reversed(alpha)))


def step_alpha_gamma(alpha: Sequence[Scalar], gamma: Sequence[Scalar]) -> State:
    r"""Return the next :math:`(\alpha, \gamma)`, which is :math:`(A(\gamma)\alpha, G(A(\gamma)\alpha)\gamma)`.

    Parameters
    ----------
    alpha, gamma : sequences of scalars, length n

    Returns
    -------
    alpha, gamma : tuples of scalars, length n
        By BLZ94 (4.4), (4.8); Schur parameters move one place to the left.

    Raises
    ------
    BadInput
        If the lengths differ, or if :math:`\gamma_k^2 = 1` for some `k`.

    Examples
    --------
    >>> from flint import fmpq
    >>> step_alpha_gamma([fmpq(1, 5)], [fmpq(1, 2)])
    ((4/15,), (-2/15,))
    """
    alpha, gamma = unify_pair(alpha=alpha, gamma=gamma)
    rows = alpha_matrix(gamma)
    new_alpha = tuple(_sum(x * y for x, y in zip(row, alpha, strict=True)) for row in rows)
    last = -_sum(x * y for x, y in zip(new_alpha, reversed(gamma), strict=True))
    return new_alpha, (*gamma[1:], last)


def _sum(terms: Iterable[Scalar]) -> Scalar:
    terms = list(terms)
    return sum(terms[1:], terms[0])


def q_from_ag(a: Sequence[Scalar], g: Sequence[Scalar]) -> State:
    r"""Return :math:`(q, q^*) = (a + g, g)` (BLM91 (2.24))."""
    a, g = unify_pair(a=a, g=g)
    return tuple(x + y for x, y in zip(a, g, strict=True)), g


def ag_from_q(q: Sequence[Scalar], q_star: Sequence[Scalar]) -> State:
    r"""Return :math:`(a, g) = (q - q^*, q^*)` (BLM91 after (2.31))."""
    q, q_star = unify_pair(q=q, q_star=q_star)
    return tuple(x - y for x, y in zip(q, q_star, strict=True)), q_star


def ag_from_alpha_gamma(alpha: Sequence[Scalar], gamma: Sequence[Scalar]) -> State:
    r"""Return :math:`(a, g)` with :math:`g = (b - a)/2` from BLZ94 (3.12)."""
    alpha, gamma = unify_pair(alpha=alpha, gamma=gamma)
    a, b = from_kimura_georgiou(alpha, gamma)
    return a, tuple((y - x) / (x - x + 2) for x, y in zip(a, b, strict=True))


def alpha_gamma_from_ag(a: Sequence[Scalar], g: Sequence[Scalar]) -> State:
    r"""Return :math:`(\alpha, \gamma)` of :math:`(a, a + 2g)`; fails where `to_kimura_georgiou` does."""
    a, g = unify_pair(a=a, g=g)
    return to_kimura_georgiou(a, [x + 2 * y for x, y in zip(a, g, strict=True)])


def gain(a_t: Sequence[Scalar], g_t: Sequence[Scalar], a: Sequence[Scalar]) -> Vector:
    r"""Return the Kalman gain :math:`k_t = a(t) + g(t) - a` (BLZ94 (2.17)).

    Parameters
    ----------
    a_t, g_t : sequences of scalars, length n
        The state at time `t`.
    a : sequence of scalars, length n
        The state :math:`a(0)`, which fixes the filter.

    Raises
    ------
    BadInput
        If the lengths differ.
    """
    a_t, g_t, a = unify(a_t=a_t, g_t=g_t, a=a)
    check_length("g_t", g_t, len(a_t), "a_t")
    check_length("a", a, len(a_t), "a_t")
    return tuple(x + y - z for x, y, z in zip(a_t, g_t, a, strict=True))
