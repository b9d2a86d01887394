# SPDX-License-Identifier: MIT
r"""How fast an orbit that converges comes to its limit, exactly.

Main definitions
----------------
``speed``          what is known of it, for a pair of any order
``Speed``          the result
``rate_ball``      the digits of a rate

Main statements
---------------
The certificate is about the numbers :math:`\rho^2` and `K`, which `exactkf.kernel.orbit_speed` finds from `D` again.  That they are the speed of the orbit is
shown here, in words: statement 1 rests on the theorem of Nevai and Totik, which is cited and not proved, statement 2 on the Jordan blocks of `S`.

Let `Q`, `S` be coprime of order :math:`m \ge 1`, :math:`Q(0) \ne 0`, and let the orbit converge, :math:`Q_t \to w`.  Let :math:`d_m` be the
leading coefficient of :math:`z^m D`, so that :math:`d_m = Q(0)`, and :math:`c_t = \prod_{s < t} (1 - \gamma_s^2)^{-1}`.  `D` of the pair at step `t` is
:math:`c_t D`, hence :math:`Q_t(0) = c_t d_m`, and with :math:`c = \lim c_t`

.. math:: w(0) - Q_t(0) = d_m (c - c_t), \qquad 1 - c_t/c = 1 - \prod_{s \ge t} (1 - \gamma_s^2) .        (1)

1. *No zeros of D on the circle.*  Let :math:`\rho < 1` be the largest modulus of the zeros of `D` inside.  Then

   .. math:: \limsup |\gamma_t|^{1/t} = \rho, \qquad \limsup \|Q_t - w\|^{1/t} = \rho^2 ,

   for every such start, not only a generic one.  From some step on `v` is strictly positive real and the :math:`\gamma_t` are the Schur parameters
   of the weight :math:`D / |a|^2`, whose Szegő function is proportional to :math:`w^* / a^*`, :math:`p^* = z^m p(1/z)`.  By the theorem of Nevai
   and Totik :math:`\limsup |\gamma_t|^{1/t}` is 1/R, with `R` the radius up to which :math:`a^* / w^*` is analytic.  Nothing cancels: a common
   zero :math:`z_0` of `w` and `a`, :math:`|z_0| < 1`, gives :math:`b(z_0) a(1/z_0) = 0` by :math:`2D = a b_* + b a_*`; :math:`b(z_0) \ne 0`, for `a` and
   `b` are coprime, and :math:`a(1/z_0) \ne 0`, for the zeros of `a` are inside.  So :math:`1/R = \rho`.  The last
   product of (1) has the root limit :math:`\rho^2`, so :math:`\|Q_t - w\|` has at least that; and not more, because
   :math:`Q_t Q_{t*} - w w_* = S_t S_{t*} + (c_t - c) D` and the derivative of :math:`p \mapsto p p_*` at the stable `w` is invertible.

2. *Zeros on the circle*, :math:`e^{i\varphi_j}` of multiplicity :math:`2k_j`.  With :math:`K = \sum_j k_j^2`,

   .. math:: \lim_{t \to \infty} t \, (1 - Q_t(0)/w(0)) = K :

   slower than any geometric rate, like 1/t.  For :math:`1/c_t = \det A \det X_{t+1} / \det X_t`, `X` the upper half of
   :math:`S_m^t (I; 0)`, and :math:`\det X_t` is :math:`\mu^t t^K (C + O(1/t))`, `C` not 0, the quotient of two following ones without terms of order 1/t but
   :math:`K/t`: of a block of size 2k the choice of `k` vectors gives the highest power, :math:`t^{k^2}`; other choices lose at least two
   powers together, and :math:`C \ne 0` because the start does not meet the codominant subspace (`exactkf.kernel.orbit_n`, statement 1).

3. A common factor :math:`\theta` multiplies :math:`Q_t` and `w`, and changes neither.  :math:`Q_t = (a_t + b_t)/2` is :math:`\alpha_t` in order one.
   In every order it is an even function of the :math:`\gamma`, so that :math:`\alpha_t` differs from its coefficients by terms that go to zero at
   least as fast as :math:`\gamma^2`, and not at all in the last, :math:`\alpha_n = Q(0)`.  So the rate is that of :math:`\alpha_t` too, if
   :math:`\theta(0) \ne 0`; otherwise :math:`\alpha_t` is at least that fast.

:math:`\rho^2 = z \bar z` for a zero `z` of `D`, so it is real algebraic: a root of the polynomial of all products of two zeros of
the norm of `D`, whose coefficients come from power sums by Newton's identities.  Up to a degree it is given as that root, above it in an interval.

References
----------
BLM91 Theorem 3.5, BLZ94 Theorem 7.1, (2.8), (6.8).  P. Nevai, V. Totik, Orthogonal polynomials and their zeros, Acta Sci. Math. (Szeged) 53 (1989).
A. Böttcher, H. Widom, Szegő via Jacobi, Linear Algebra Appl. 419 (2006), for powers :math:`t^{k^2}`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from flint import arb, fmpq, fmpq_poly, fmpz

from exactkf._errors import BadInput, Unsupported
from exactkf.dynamics.exact_json import isolated
from exactkf.dynamics.zeros import CirclePoint, factors, interval_json, norm, products_of_zeros, zero_balls
from exactkf.exact.balls import precision
from exactkf.exact.numberfield import RealField

__all__ = ["Speed", "norms_of", "rate_ball", "speed"]

_DEGREE = 16  # of the norm, up to which the rate is a root
_LONGEST = 32  # degree up to which a root is written, as for limits
_BOUND = 1 << 14
_DIGITS = 50


class Speed(NamedTuple):
    """How fast the distance from the limit goes to zero: by a rate a step, or like K/t."""

    rate: Any
    slow: int | None


def speed(D: Sequence[Any], circle: Sequence[CirclePoint]) -> Speed:
    r"""Return the speed of an orbit that converges.

    Parameters
    ----------
    D : sequence of rationals or elements of one field
        The coefficients of z^m D of the reduced pair, which keeps one sign on the circle.
    circle : sequence of CirclePoint
        Its zeros on the unit circle, as `exactkf.dynamics.zeros.circle_points` has them.

    Returns
    -------
    Speed
        ``rate`` is :math:`\rho^2` of statement 1 in JSON, "0" if the orbit rests after finitely many steps (m = 0), and None if
        there are zeros on the circle; ``slow`` is then `K` of statement 2.

    Examples
    --------
    >>> speed([fmpq(2), fmpq(5), fmpq(2)], [])
    Speed(rate='1/4', slow=None)
    """
    if len(D) == 1:
        return Speed("0", None)
    if circle:
        return Speed(None, sum((multiplicity // 2) ** 2 * (1 if x in ("2", "-2") else 2) for x, multiplicity in circle))
    parts, norms = [f for f, _ in factors(D)], norms_of(D)
    if max(p.degree() for p in norms) > _DEGREE:
        return Speed(interval_json(_accurate(parts, _DIGITS)), None)
    product = fmpq_poly([1])
    for p in norms:
        product *= products_of_zeros(p)
    found = isolated(product, lambda bits: _square(parts, bits))
    return Speed(found if isinstance(found, str) or len(found["minpoly"]) <= _LONGEST + 1 else interval_json(_accurate(parts, _DIGITS)), None)


def norms_of(D: Sequence[Any]) -> list[fmpq_poly]:
    """Return polynomials over Q whose product vanishes at all zeros of D."""
    return [norm(f) for f, _ in factors(D)]


def rate_ball(rate: Any, D: Sequence[Any], digits: int) -> arb:
    """Return a ball with relative error at most ``10**-digits`` around a rate that `speed` found for `D`.

    Raises
    ------
    BadInput
        If `digits` is not a positive integer.
    """
    if isinstance(digits, bool) or not isinstance(digits, int) or digits < 1:
        raise BadInput(f"digits = {digits!r}: not a number of digits; pass a positive integer")
    if isinstance(rate, str):
        return arb(fmpq(*map(fmpz, rate.split("/"))))
    if "minpoly" in rate:
        return RealField(rate["minpoly"], rate["interval"]).gen().enclose(digits)
    return _accurate([f for f, _ in factors(D)], digits)


def _square(parts: Sequence[list[Any]], bits: int) -> arb:
    """The largest square of a modulus less than one of a zero; no zero is on the circle."""
    while bits <= _BOUND:
        with precision(bits):
            try:
                squares = [z.real * z.real + z.imag * z.imag for f in parts for z in zero_balls(f)]
            except Unsupported:
                squares = []
            if squares and all(x < 1 or x > 1 for x in squares):
                inside = [x for x in squares if x < 1]
                largest = inside[0]
                for x in inside[1:]:
                    largest = largest.max(x)
                return largest
        bits *= 2
    raise Unsupported("the zeros of D are too close to the unit circle to find the rate")


def _accurate(parts: Sequence[list[Any]], digits: int) -> arb:
    bits = 64 + 5 * digits
    while (found := _square(parts, bits)).rel_accuracy_bits() < 10 * digits // 3 + 2:
        bits *= 2
    return found
