# SPDX-License-Identifier: MIT
r"""The state of the fast filter far ahead: exactly, or to any number of digits.

Main definitions
----------------
``state_ahead``    the exact state after `T` steps, as `exactkf.theory.power_method.state_after`
``digits_ahead``   the same state to a number of digits, for `T` as large as :math:`10^{12}`
``ahead_data``     the same as plain data, exact or in digits
``ahead_lines``    and as text
``DigitsAhead``    its result

Main statements
---------------
With :math:`A = J - qh'`, :math:`u = P_T h` and the columns of :math:`S^T(I; 0)` as :math:`(X; Y)`,

.. math:: X'(u, w) = (Y'h, g), \qquad r_T = 1 - u_1, \qquad
          q(T) = a + (g - Fu)/r_T, \qquad g(T) = w / r_T

(see `exactkf.theory.power_method`).  The columns of :math:`S^T` become parallel where the orbit
converges, so the balls are around :math:`X^{-1}`, :math:`X^{-1}B` and :math:`P = YX^{-1}`, B the upper
right block: these compose by the star product, with
:math:`X = X_2(I + G_2P_1)X_1`, and stay bounded.  The working precision doubles until the balls are small
enough.  They exist only if no X at the times composed is singular; an escape in between is what `decide` excludes.

Notation
--------
As in `exactkf.theory.fast_filter`.

References
----------
BLZ94 (2.2), (2.8), (2.17), (6.4)-(6.17).  R. Redheffer, On a certain linear fractional transformation,
J. Math. and Phys. 39 (1960).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal
from fractions import Fraction
from typing import Any, NamedTuple

from flint import arb, arb_mat, ctx, fmpq

from exactkf._errors import Unsupported
from exactkf.dynamics.answer import Answer
from exactkf.dynamics.every_order import decide
from exactkf.exact._messages import MOST_DIGITS, bad, check_count
from exactkf.exact.balls import precision
from exactkf.exact.numberfield import RealNumber
from exactkf.kernel.orbit_n import reduce_pair
from exactkf.theory._scalars import Scalar, unify_pair
from exactkf.theory.fast_filter import step_ag
from exactkf.theory.orbits import exact_orbit, orbit
from exactkf.theory.power_method import Arrival, state_after

__all__ = ["DigitsAhead", "ahead_data", "ahead_lines", "digits_ahead", "rounded", "state_ahead"]

_BOUND = 1 << 17
_SHORT = 50  # steps
_FARTHEST = 10**100
_LONGEST = 60  # characters of a fraction


class DigitsAhead(NamedTuple):
    """Balls around the state after `T` steps, or the step of escape before `T`.

    `never_escapes` says that an escape before `T` is excluded; otherwise it is excluded in the
    steps that `decide` searched.
    """

    a: tuple[arb, ...]
    g: tuple[arb, ...]
    escape: int | None
    never_escapes: bool


def state_ahead(a: Sequence[Scalar], g: Sequence[Scalar], T: int) -> Arrival:
    """Return the exact state after `T` steps, without stepping; see `exactkf.theory.power_method.state_after`."""
    return state_after(a, g, T)


def digits_ahead(a: Sequence[Scalar], g: Sequence[Scalar], T: int, digits: int = 15, *, answer: Answer | None = None) -> DigitsAhead:
    r"""Return the state after `T` steps to a number of digits.

    Parameters
    ----------
    a, g : sequences of rationals or of elements of one `RealField`, length n
    T : int
        Number of steps, nonnegative.
    digits : int
        The absolute error of each entry is less than ``10**-digits``.
    answer : Answer, optional
        What `decide` says, if it is known already.

    Returns
    -------
    DigitsAhead

    Raises
    ------
    BadInput
        If the entries are not in one field, the lengths differ, `T` is negative or above 10**100, or `digits` is not between 1 and 100,000.
    Unsupported
        If the precision needed is above 2**17 bits and 32 times the digits, as for a state at or next to an escape.

    Examples
    --------
    >>> digits_ahead([0], [2], 2, 5).g[0].str(5, radius=False)
    '-1.1429'
    """
    check_count("T", T, 0, _FARTHEST, "pass T <= 10**100")
    check_count("digits", digits, 1, MOST_DIGITS)
    if answer is not None and not isinstance(answer, Answer):
        raise bad("answer", "is not an Answer", answer, "pass what decide returns, or None")
    a, g = unify_pair(a=a, g=g)
    a, g = (tuple(fmpq(x.numerator, x.denominator) if isinstance(x, Fraction) else x for x in v) for v in (a, g))
    if not (all(isinstance(x, fmpq) for x in (*a, *g)) or all(isinstance(x, RealNumber) for x in (*a, *g))):
        raise bad("(a, g)", "is not in one field", (a, g), "pass rationals, or elements of one RealField")
    answer = decide(a, g) if answer is None else answer
    if answer.escape is not None and answer.escape < T:
        return DigitsAhead((), (), answer.escape, False)
    one = a[0] - a[0] + 1
    Q = [x + y for x, y in zip(a, g, strict=True)][::-1] + [one]
    S = [*g[::-1], one - one]
    reduced = reduce_pair(Q, S)
    start, m = min(reduced.start, T), len(reduced.Q) - 1
    bits = 64 + 4 * digits
    bound = max(_BOUND, 8 * bits)
    while bits <= bound:
        with precision(bits):
            found = _at(a, g, start) if T <= start else _power(reduced.Q, reduced.S, reduced.removed, T - start) if m else _rest(reduced.removed)
        if found is not None and all(x.rad() < arb(10) ** -digits for x in (*found[0], *found[1])):
            return DigitsAhead(*found, None, answer.never_escapes or answer.escape is not None)
        bits *= 2
    raise Unsupported(f"the state after {T} steps needs more than {bound} bits; it is next to an escape, or is one")


def ahead_data(a: Sequence[Scalar], g: Sequence[Scalar], T: int, digits: int = 15) -> dict[str, Any]:
    """Return the state after `T` steps as plain data; arguments and errors as `digits_ahead`.

    Returns
    -------
    dict
        ``steps``; ``escape``, the step of an escape before, or None; ``never_escapes``, whether one is excluded for certain; ``a`` and ``g``, lists of
        "p/q" as long as that is short, and otherwise of ``{"digits", "radius"}``: the number is within the radius of the decimal number.

    Examples
    --------
    >>> ahead_data([0], [2], 1)["g"], ahead_data([0], [2], 99)["g"][0]["digits"][:8]
    (['4/3'], '-1.04598')
    """
    found = digits_ahead(a, g, T, digits)
    data: dict[str, Any] = {"steps": T, "escape": found.escape, "never_escapes": found.never_escapes, "a": None, "g": None}
    if found.escape is not None:
        return data
    exact = state_ahead(a, g, T).state if T <= _SHORT and not any(isinstance(x, RealNumber) for x in (*a, *g)) else None
    for k, (name, balls) in enumerate((("a", found.a), ("g", found.g))):
        texts = [str(x) for x in exact[k]] if exact else [""] * len(balls)
        data[name] = [text if 0 < len(text) <= _LONGEST else _decimal(x, digits) for text, x in zip(texts, balls, strict=True)]
    return data


def _decimal(x: arb, digits: int) -> dict[str, str]:
    """A ball as a decimal number and a radius that holds, rounding included."""
    middle, radius, exponent = (int(v) for v in x.mid_rad_10exp(digits))
    return {"digits": _scaled(middle, exponent), "radius": f"{radius}e{exponent}"}


def _scaled(middle: int, exponent: int) -> str:
    """The decimal number middle * 10^exponent, exactly."""
    return str(Decimal(middle).scaleb(exponent, Context(prec=len(str(middle)) + 1, Emin=MIN_EMIN, Emax=MAX_EMAX)))


def ahead_lines(data: Mapping[str, Any], digits: int = 15) -> list[str]:
    """Return what `ahead_data` found as lines of text."""
    T = data["steps"]
    if data["escape"] is not None:
        return [f"no state after {T} steps: the orbit escapes at step {data['escape']}"]
    lines = [f"{name}_{i}({T}) = {rounded(x, digits)}" for name in "ag" for i, x in enumerate(data[name], 1)]
    return lines if data["never_escapes"] else [*lines, "(an escape before that step is not excluded)"]


def rounded(x: Any, digits: int) -> str:
    """Return a number of `ahead_data` as text, digits as far as they are certain."""
    if isinstance(x, str):
        return x
    with precision(64 + 5 * digits):
        ball = arb(x["digits"], x["radius"])
        return "0" if ball == 0 else f"0 to {digits} digits" if ball.contains(0) else ball.str(digits, radius=False)


def _ball(x: Any) -> arb:
    """A ball of about the precision in force around a rational number or an element of a field."""
    return x.enclose(3 * ctx.prec // 10) if isinstance(x, RealNumber) else arb(fmpq(x))


def _at(a: Sequence[Any], g: Sequence[Any], T: int) -> tuple[tuple[arb, ...], tuple[arb, ...]]:
    state = (orbit(step_ag, (tuple(a), tuple(g)), T) if isinstance(a[0], RealNumber) else exact_orbit(a, g, T)).states[-1]
    return tuple(map(_ball, state[0])), tuple(map(_ball, state[1]))


def _rest(removed: list) -> tuple[tuple[arb, ...], tuple[arb, ...]]:
    """The equilibrium with the polynomial `removed`."""
    return tuple(map(_ball, reversed(removed[:-1]))), tuple(arb(0) for _ in removed[:-1])


def _first(q: list[arb], g: list[arb]) -> _Scattering:
    """S itself: with X = A'^-1 they are A', -hh', gg'."""
    m, column = len(q), arb_mat([[x] for x in g])
    A = arb_mat([[arb(int(j == i + 1)) - (q[i] if j == 0 else 0) for j in range(m)] for i in range(m)])
    hh = arb_mat([[int(i == j == 0) for j in range(m)] for i in range(m)])
    return _Scattering(A.transpose(), -hh, column * column.transpose())


def _power(Q: list, S: list, removed: list, T: int) -> tuple[tuple[arb, ...], tuple[arb, ...]] | None:
    """Return balls around the state `T` steps after a reduced pair, times the common factor; None if they are not finite."""
    g = [_ball(x) for x in S[-2::-1]]
    q = [_ball(x) for x in Q[-2::-1]]
    a = [x - y for x, y in zip(q, g, strict=True)]
    try:
        total = _repeated(_first(q, g), T)
    except ZeroDivisionError:
        return None
    u = [row[0] for row in total.P.tolist()]
    w = [row[0] for row in (total.phi.transpose() * arb_mat([[arb(x)] for x in g])).tolist()]
    r = 1 - u[0]
    if r.contains(0) or not all(x.is_finite() for x in (*u, *w)):
        return None
    g_T = [x / r for x in w]
    # F u = J u - a u_1, so q(T) r_T = a r_T + g - F u = a + g - J u
    q_T = [(x + y - z) / r for x, y, z in zip(a, g, [*u[1:], arb(0)], strict=True)]
    return _with_factor([x - y for x, y in zip(q_T, g_T, strict=True)], g_T, removed)


class _Scattering(NamedTuple):
    """A power of S with blocks X, B, Y, D as X^-1, X^-1 B and Y X^-1, which stay bounded where the orbit converges."""

    phi: arb_mat
    G: arb_mat
    P: arb_mat


def _after(second: _Scattering, first: _Scattering) -> _Scattering:
    """Return the product of two powers, by Redheffer's star product: X = X2 (I + G2 P1) X1."""
    m = first.P.nrows()
    eye = arb_mat([[int(i == j) for j in range(m)] for i in range(m)])
    middle = (eye + second.G * first.P).inv()
    return _Scattering(first.phi * middle * second.phi,
                       first.G + first.phi * middle * second.G * first.phi.transpose(),
                       second.P + second.phi.transpose() * first.P * middle * second.phi)


def _repeated(one: _Scattering, T: int) -> _Scattering:
    total = one
    for bit in bin(T)[3:]:
        total = _after(total, total)
        if bit == "1":
            total = _after(one, total)
    return total


def _with_factor(a: list[arb], g: list[arb], removed: list[Any]) -> tuple[tuple[arb, ...], tuple[arb, ...]]:
    """Multiply the polynomials by a monic factor."""
    factor = [_ball(x) for x in reversed(removed)]

    def times(p: list[arb]) -> list[arb]:
        out = [arb(0)] * (len(p) + len(factor) - 1)
        for i, x in enumerate(p):
            for j, y in enumerate(factor):
                out[i + j] += x * y
        return out

    return tuple(times([arb(1), *a])[1:]), tuple(times(list(g)))
