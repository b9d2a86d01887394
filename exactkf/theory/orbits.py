# SPDX-License-Identifier: MIT
r"""Orbits of the fast filter and where they escape.

Main definitions
----------------
``orbit``            repeated steps over any field, in any coordinates
``integer_orbit``    the orbit of a rational state in homogeneous integer coordinates
``exact_orbit``      the same orbit as rationals
``first_escape``     the first ``t`` with :math:`\gamma_t^2 = 1`, exactly

Main statements
---------------
Let `d` be a common denominator, :math:`\hat Q_0 = (d, d q_1, \dots, d q_n)`,
:math:`\hat Q^*_0 = (d q^*_1, \dots, d q^*_n)` and :math:`D_t` the leading
coefficient of :math:`\hat Q_t`.  Then

.. math:: \hat Q_{t+1} = (D_t \hat Q_t - \hat Q^*_{t,1} z \hat Q^*_t) / D_{t-1}, \qquad
          \hat Q^*_{t+1} = (D_t z \hat Q^*_t - \hat Q^*_{t,1} \hat Q_t) / D_{t-1}

are integers for all `t` (with the divisor one in the first two steps), as in Bareiss'
elimination: :math:`\hat Q_t = d^{2t} \det(T_{t-1}) Q_t` for :math:`t \ge 1` in the
notation of BLM91 (2.26), and likewise with stars.  The leading coefficient is
:math:`d^{2t} \det T_t`; the first one to vanish marks the escape.

Proof of integrality.  By Cramer's rule :math:`\det(T_{t-1}) \varphi_t` is an integer
polynomial in the :math:`c_k = h'F^{k-1}g`, so with BLM91 (2.18), (2.19) the coefficients of
:math:`\bar Q_t = \det(T_{t-1}) Q_t` and :math:`\bar Q^*_t` are integer polynomials in `a`, `g`.
Their degree is at most `2t`: by induction, since the recursion with `d = 1` divides a
polynomial of degree at most `4t` by :math:`\det T_{t-1}`, whose degree is exactly `2(t - 1)`
(already for `n = 1` the leading form of :math:`\det T_t`, :math:`t \ge 1`, is plus or minus
:math:`\gamma^2 (\gamma^2 - \alpha^2)^{t-1}`).

Notation
--------
As in `fast_filter`.  A *state* is a pair of vectors of length `n`.

References
----------
BLM91 (2.25)-(2.27); BLZ94 (2.16), Proposition 3.1.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from flint import fmpq, fmpz

from exactkf.exact._messages import check_count
from exactkf.theory._matrices import as_fmpq_mat
from exactkf.theory._scalars import Scalar, Vector, refused, unify_pair
from exactkf.theory.fast_filter import State, step_alpha_gamma

__all__ = ["IntegerState", "Orbit", "exact_orbit", "first_escape", "integer_orbit", "orbit"]

IntegerState = tuple[tuple[fmpz, ...], tuple[fmpz, ...]]

_MOST_STATES = 10**5  # that are kept at once
_MOST_STEPS = 10**7  # modulo a prime
_MOST_BITS = 1 << 32  # in all states together
_FAR = "state_after and digits_ahead go far without stepping, integer_orbit gives one state after the other"
_PRIMES = ((1 << 61) - 1, (1 << 89) - 1)


@dataclass(frozen=True)
class Orbit:
    """The states with index ``0, 1, ..., len(states) - 1`` and the time of escape.

    Attributes
    ----------
    states : tuple of State
    escape : int or None
        The index of the last state, if it has no successor.
    """

    states: tuple[State, ...]
    escape: int | None


def orbit(step: Callable[[Vector, Vector], State], state: State, steps: int) -> Orbit:
    r"""Return the orbit of `state` over at most `steps` steps.

    Parameters
    ----------
    step : callable
        `step_ag`, `step_q` or `step_alpha_gamma`.
    state : pair of sequences of scalars, length n
    steps : int
        Number of steps, nonnegative.

    Returns
    -------
    Orbit
        An escape ends the orbit; it is reported, not raised.  In the coordinates
        :math:`(\alpha, \gamma)` the orbit ends as soon as one of the `n` visible Schur
        parameters has square one, up to ``n - 1`` steps before the others.

    Raises
    ------
    BadInput
        If `steps` is negative or more than 100,000, or `state` does not consist of two vectors of equal length.

    Examples
    --------
    >>> from exactkf.theory.fast_filter import step_ag
    >>> orbit(step_ag, ([1], [1]), 5).escape
    0
    """
    check_count("steps", steps, 0, _MOST_STATES, _FAR)
    if not callable(step):
        raise refused("step", step, "not a function", "pass step_ag, step_q or step_alpha_gamma")
    if not isinstance(state, (tuple, list)) or len(state) != 2:
        raise refused("state", state, "not a pair of vectors", "pass a pair such as (a, g)")
    first, second = unify_pair(**{"state[0]": state[0], "state[1]": state[1]})
    states: list[State] = [(first, second)]
    watched = slice(None) if step is step_alpha_gamma else slice(1)
    for _ in range(steps):
        if any(1 - value * value == 0 for value in states[-1][1][watched]):
            return Orbit(tuple(states), len(states) - 1)
        states.append(step(*states[-1]))
    return Orbit(tuple(states), None)


def _integer_start(a: Sequence[Scalar], g: Sequence[Scalar]) -> IntegerState:
    """Return ``d``-fold ``(1, q)`` and ``q_star`` with the least common denominator ``d``."""
    numerators, d = as_fmpq_mat("(a, g)", unify_pair(a=a, g=g)).numer_denom()
    a_row, g_row = numerators.tolist()
    return (d, *(x + y for x, y in zip(a_row, g_row, strict=True))), tuple(g_row)


def integer_orbit(a: Sequence[Scalar], g: Sequence[Scalar]) -> Iterator[IntegerState]:
    r"""Yield the orbit of a rational state in homogeneous integer coordinates.

    Parameters
    ----------
    a, g : sequences of rationals, length n

    Yields
    ------
    Q, Q_star : tuples of fmpz, lengths n + 1 and n
        With :math:`q_t = Q_{1..n} / Q_0`, :math:`q_t^* = Q^* / Q_0`.  The iteration ends
        after the last state if the orbit escapes, and never ends otherwise.

    Raises
    ------
    BadInput
        If the entries are not rational or the lengths differ.

    Examples
    --------
    >>> states = integer_orbit([0], [2])
    >>> next(states), next(states), next(states)
    (((1, 2), (2,)), ((-3, 2), (-4,)), ((-7, -6), (8,)))
    """
    Q, Q_star = _integer_start(a, g)
    divisor, following = fmpz(1), fmpz(1)
    while Q[0] != 0:
        yield Q, Q_star
        lead, first = Q[0], Q_star[0]
        shifted = (*Q_star, fmpz(0))
        Q_star = tuple((lead * y - first * x) // divisor for x, y in zip(Q[1:], shifted[1:], strict=True))
        Q = tuple((lead * x - first * y) // divisor for x, y in zip(Q, shifted, strict=True))
        divisor, following = following, Q[0]


def exact_orbit(a: Sequence[Scalar], g: Sequence[Scalar], steps: int) -> Orbit:
    r"""Return the orbit of a rational state :math:`(a, g)`, faster than repeated `step_ag`.

    Parameters
    ----------
    a, g : sequences of rationals, length n
    steps : int
        Number of steps, nonnegative.

    Returns
    -------
    Orbit
        States ``(a, g)`` with entries of type ``fmpq``; an escape is reported.

    Raises
    ------
    BadInput
        If the entries are not rational, the lengths differ, `steps` is negative or more than 100,000, or the states fill the memory.

    Examples
    --------
    >>> exact_orbit([0], [2], 2).states[2]
    ((2,), (-8/7,))
    """
    check_count("steps", steps, 0, _MOST_STATES, _FAR)
    states: list[State] = []
    bits = 0
    for (lead, *rest), star in integer_orbit(a, g):
        a_t = tuple(fmpq(x - y, lead) for x, y in zip(rest, star, strict=True))
        states.append((a_t, tuple(fmpq(y, lead) for y in star)))
        bits += sum(x.p.bit_length() + x.q.bit_length() for x in (*a_t, *states[-1][1]))
        if bits > _MOST_BITS:
            raise refused("steps", steps, f"the first {len(states)} states have more than {_MOST_BITS >> 3} bytes", _FAR)
        if len(states) > steps:
            return Orbit(tuple(states), None)
    return Orbit(tuple(states), len(states) - 1)


def _may_escape(state: IntegerState, steps: int, p: int) -> bool:
    """Say whether a leading coefficient vanishes modulo `p` at the start or after one of the `steps` steps."""
    Q, star = ([int(x % p) for x in part] for part in state)
    for _ in range(steps):
        if Q[0] == 0:
            return True
        lead, first = Q[0], star[0]
        shifted = [*star, 0]
        star = [(lead * y - first * x) % p for x, y in zip(Q[1:], shifted[1:], strict=True)]
        Q = [(lead * x - first * y) % p for x, y in zip(Q, shifted, strict=True)]
    return Q[0] == 0


def first_escape(a: Sequence[Scalar], g: Sequence[Scalar], steps: int) -> int | None:
    r"""Return the first ``t < steps`` with :math:`\gamma_t^2 = 1`, or None.

    Parameters
    ----------
    a, g : sequences of rationals, length n
    steps : int

    Returns
    -------
    int or None
        Exact.  A leading coefficient that does not vanish modulo a prime does not
        vanish; one that does is settled by the exact orbit.

    Raises
    ------
    BadInput
        If the entries are not rational, the lengths differ, or `steps` is negative or more than 10,000,000.

    Examples
    --------
    >>> first_escape([-2], [fmpq(1, 2)], 1000)
    1
    """
    check_count("steps", steps, 0, _MOST_STEPS, "exactkf.dynamics.decide settles escapes at every step")
    return escape_before(a, g, steps)


def escape_before(a: Sequence[Scalar], g: Sequence[Scalar], steps: int) -> int | None:
    """The same for any number of steps."""
    start = _integer_start(a, g)
    if not all(_may_escape(start, steps, p) for p in _PRIMES):
        return None
    last = max(t for t, _ in zip(range(steps + 1), integer_orbit(a, g), strict=False))
    return last if last < steps else None
