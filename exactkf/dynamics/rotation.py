# SPDX-License-Identifier: MIT
r"""The recursion :math:`y_{t+1} = x y_t - y_{t-1}`: order of its rotation, zeros, last change of signs.

Main definitions
----------------
``rotation_order``     the order of `v`, :math:`v + 1/v = x`, as a root of unity
``rational_periods``   the periods that rational data can have
``zero_index``         the first `t` with :math:`y_t = 0`
``sign_change``        where :math:`y_t` changes its sign, for :math:`|x| > 2`

Main statements
---------------
*Order.*  `v` is a root of unity of order `P` exactly if the minimal polynomial of `x` is that of
:math:`2\cos(2\pi/P)`: all conjugates of a primitive root are primitive (Kronecker, Gauss).
Its degree is :math:`\varphi(P)/2` for :math:`P \ge 3`, and :math:`\varphi(P) \ge \sqrt{P/2}`.

*Zeros.*  What does not vanish modulo a prime does not vanish; what does is evaluated exactly.
Beyond `exactkf.kernel.rotation.zero_bound` there is no zero, by heights.

*Change of signs.*  For :math:`|x| > 2` let `l` be the root of :math:`l^2 - x l + 1` with :math:`|l| > 1`, and
`s` its sign.  Then :math:`y_t` is a multiple of :math:`l^t (1 - k l^{-2t})`, with

.. math:: k = \frac{|l| (|l| s a - 1)}{s a - |l|},

and the sign of :math:`s^t y_t` changes between `m` and `m + 1`, :math:`m = \lfloor \log k / (2 \log |l|) \rfloor`,
unless :math:`y_m = 0`.

Notation
--------
:math:`y_0 = a \ne 0`, :math:`y_1 = 1`; scalars are ``fmpq``, or elements of one `RealField`.

References
----------
L. Kronecker, J. reine angew. Math. 53 (1857); I. Niven, Irrational Numbers (1956), chapter 3.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cache

from flint import arb, fmpq, fmpz, fmpz_poly, nmod_poly

from exactkf.exact import RealNumber
from exactkf.exact.balls import ball, precision
from exactkf.kernel.rotation import value, zero_bound
from exactkf.theory._scalars import Scalar

__all__ = ["rational_periods", "rotation_order", "sign_change", "zero_index"]

_PRIMES = (9223372036854775783, 9223372036854775643, 4611686018427387847)  # the largest below 2^63, and below 2^62
_RATIONAL_ORDERS = {-2: 2, -1: 3, 0: 4, 1: 6, 2: 1}


def rational_periods() -> tuple[tuple[int, ...], tuple[int, ...]]:
    r"""Return the least periods of periodic orbits with rational data: of the filter, of the Riccati equation.

    Returns
    -------
    filter, riccati : tuples of int
        ``(1, 3, 4, 6)`` and ``(1, 2, 3)``.

    Notes
    -----
    *Theorem.*  A periodic orbit of (3.10) with rational :math:`(\alpha_0, \gamma_0)` has period 1, 3, 4 or 6; one of
    (4.7) with rational :math:`(\alpha_0, \gamma_0, \pi_0)` has period 1, 2 or 3.  Each occurs.

    *Proof.*  An orbit that is neither an equilibrium nor on :math:`\alpha = 0` and is periodic has
    :math:`|c| < 1`, :math:`c = 1/\kappa`; its period is the order `P` of `v`, :math:`v + 1/v = -2c`, and that of
    :math:`v^2` for the Riccati equation.  So the rational number `-2c` is :math:`2\cos(2\pi q/P)`, an algebraic integer, hence an
    integer, and of modulus less than 2: `-1`, `0` or `1`, with `P` = 3, 4, 6 (Niven).  The order of
    :math:`v^2` is 3, 2, 3.  On :math:`\alpha = 0` the state is at its limit after one step.
    Examples: :math:`(-5/3, -7/3)`, :math:`(3/4, 5/4)`, :math:`(5/3, 7/3)` have the periods 3, 4, 6, and :math:`(1/2, 0)` is an equilibrium.

    References
    ----------
    BLM91 (3.10), (4.7), Theorems 3.7, 4.1.
    """
    turning = tuple(sorted(P for x, P in _RATIONAL_ORDERS.items() if abs(x) < 2))
    halved = sorted({P if P % 2 else P // 2 for P in turning})
    return (1, *turning), (1, *halved)


def rotation_order(x: Scalar) -> int | None:
    r"""Return the order of `v`, :math:`v + 1/v = x`, as a root of unity, or None if it is none.

    Parameters
    ----------
    x : fmpq or RealNumber

    Examples
    --------
    >>> rotation_order(fmpq(-1)), rotation_order(fmpq(1, 2))
    (3, None)
    """
    if isinstance(x, fmpq):
        return _RATIONAL_ORDERS.get(int(x.p)) if x.q == 1 and abs(x.p) <= 2 else None
    if x.is_rational():
        return rotation_order(x.rational_value())
    p = x.minimal_polynomial()
    if p.denom() != 1:
        return None
    return _cosines(p.degree()).get(tuple(int(c) for c in p.numer().coeffs()))


@cache
def _cosines(degree: int) -> dict[tuple[int, ...], int]:
    """The minimal polynomials of 2 cos(2 pi/P) of the given degree, and P."""
    found = {}
    for P in range(3, 8 * degree * degree + 1):
        if fmpz(P).euler_phi() == 2 * degree:
            found[tuple(int(c) for c in fmpz_poly.cos_minpoly(P).coeffs())] = P
    return found


def _coefficients(x: Scalar) -> list[fmpq]:
    return x.poly.coeffs() if isinstance(x, RealNumber) else [x]


def _fractions(values: list[fmpq]) -> list[Fraction]:
    return [Fraction(int(v.p), int(v.q)) for v in values]


def _modulus(*scalars: Scalar) -> list[fmpq]:
    """The minimal polynomial of the field, or that of zero."""
    return next((x.field.minpoly.coeffs() for x in scalars if isinstance(x, RealNumber)), [fmpq(0), fmpq(1)])


def last_index(x: Scalar, a: Scalar) -> int:
    """No zero has a larger index, unless `v` is a root of unity."""
    return zero_bound(_fractions(_coefficients(x)), _fractions(_coefficients(a)), _fractions(_modulus(x, a)))


def zero_index(x: Scalar, a: Scalar, stop: int | None = None) -> int | None:
    r"""Return the first `t` from 2 on with :math:`y_t = 0`, or None.

    Parameters
    ----------
    x, a : fmpq or RealNumber of one field
    stop : int, optional
        The last `t` to look at.  Needed if `v` is a root of unity; else heights give one.
    """
    if stop is None:
        stop = last_index(x, a)
    for p in _PRIMES:
        if any(c.q % p == 0 for s in (x, a) for c in _coefficients(s)) or any(c.q % p == 0 for c in _modulus(x, a)):
            continue
        scan = _scan if isinstance(x, RealNumber) or isinstance(a, RealNumber) else _scan_rational
        return next((t for t in scan(x, a, stop, p) if value(x, a, t) == 0), None)
    return next((t for t in range(2, stop + 1) if value(x, a, t) == 0), None)


def _scan_rational(x: fmpq, a: fmpq, stop: int, p: int) -> Iterator[int]:
    """Yield the indices at which the sequence vanishes modulo a prime."""
    x0, before, now = (int(s.p) * pow(int(s.q), -1, p) % p for s in (x, a, fmpq(1)))
    for t in range(2, stop + 1):
        before, now = now, (x0 * now - before) % p
        if now == 0:
            yield t


def _scan(x: Scalar, a: Scalar, stop: int, p: int) -> Iterator[int]:
    """The same in the ring of integers of a field modulo a prime; the polynomials are irreducible over Q."""
    def read(coefficients: list[fmpq]) -> nmod_poly:
        return nmod_poly([int(c.p) * pow(int(c.q), -1, p) % p for c in coefficients], p)

    m = read(_modulus(x, a))
    x0, before, now = read(_coefficients(x)), read(_coefficients(a)), nmod_poly([1], p)
    for t in range(2, stop + 1):
        before, now = now, x0 * now % m - before
        if now.degree() < 0:
            yield t


def _enclosed(x: Scalar, bits: int) -> arb:
    """A ball of relative accuracy about `bits`."""
    return x.enclose(bits * 3 // 10 + 1) if isinstance(x, RealNumber) else ball(x)


def sign_change(x: Scalar, a: Scalar) -> tuple[int, bool]:
    r"""Return `m` of the header, and whether :math:`y_m = 0`.

    Parameters
    ----------
    x, a : fmpq or RealNumber of one field
        :math:`|x| > 2` and `a` beyond the root of larger modulus: :math:`s a > |l|`.
    """
    s = 1 if x > 0 else -1
    excess, start, bound = (s * x - 2) / 4, s * a, None
    bits = 64
    while True:
        with precision(bits):
            half = _enclosed(excess, bits).sqrt().asinh()  # |l| = exp(2 half), accurate also for x near 2
            root = (2 * half).exp()
            k = root * (root * _enclosed(start, bits) - 1) / (_enclosed(start, bits) - root)
            quotient = k.log() / (4 * half)
            whole = quotient.floor().unique_fmpz() if quotient.is_finite() else None
            near = quotient.unique_fmpz() if quotient.is_finite() else None
        if whole is not None:
            return int(whole), False
        if near is not None:  # an integer within the error
            bound = last_index(x, a) if bound is None else bound
            if near <= bound and zero_index(x, a, int(near)) == near:
                return int(near), True
        bits *= 2


def whole_part(x: Scalar) -> int:
    """The largest integer not above `x`."""
    if isinstance(x, fmpq):
        return int(x.floor())
    if x.is_rational():
        return int(x.rational_value().floor())
    digits = 15
    while True:
        with precision(digits * 4):
            n = x.enclose(digits).floor().unique_fmpz()
        if n is not None:
            return int(n)
        digits *= 2
