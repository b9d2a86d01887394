# SPDX-License-Identifier: MIT
r"""Searches for orbits that neither converge nor repeat; what they find, the checker checks.

Main definitions
----------------
``modulus_without_escape``  an `N` such that the orbit modulo `N` is finite without an escape
``aperiodic_modulus``       a prime that shows that the zeros of `D` are not distinct roots of unity
``torus_evidence``          the dimension of the torus that an orbit fills, with evidence

Main statements
---------------
See `exactkf.kernel.orbit_n` and `exactkf.kernel.orbit_wandering`.

Choice of algorithm
-------------------
An orbit modulo a prime `p` that divides no denominator either escapes or comes back.  It has
one of about :math:`p^m` planes, but on the average torus of :math:`S_m` modulo `p` an
orbit has a length of the order of `p`, and of its steps about two in `p` escape: a good part of the
primes does.  That two roots of the circle are independent is seen in discrete logarithms; relations
are sought by lattice reduction of the angles, and verified.

References
----------
BLZ94 Section 8.  A. K. Lenstra, H. W. Lenstra, L. Lovász, Factoring polynomials with rational
coefficients, Math. Ann. 261 (1982).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import gcd
from typing import Any

from flint import acb, acb_poly, arb, fmpq, fmpq_mat, fmpq_poly, fmpz, fmpz_mat, fmpz_poly, nmod_poly

from exactkf.dynamics.spectral_factor import zeros
from exactkf.exact.balls import precision
from exactkf.exact.numberfield import RealNumber
from exactkf.exact.polynomials import count_roots
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.orbit_wandering import backward, check_never_singular, has_infinite_order, modular_step

__all__ = ["aperiodic_modulus", "apparent_orders", "escapes_before", "modulus_without_escape", "no_escape_modulo", "prime_without_singularity",
           "primes"]

_SMALL, _PRIME_BOUND = 60, 30_000
_PADIC_BOUND = 2000
_PLACE_BOUND = 2_000_000


def primes(start: int = 2) -> Iterator[int]:
    """Yield the primes from `start` on."""
    p = start
    while True:
        if fmpz(p).is_prime():
            yield p
        p += 1


def _residues(p: Sequence[Any], N: int) -> list[int] | None:
    """Return rational coefficients modulo `N`, or None if a denominator is no unit."""
    if any(gcd(int(c.denominator), N) > 1 for c in p):
        return None
    return [int(c.numerator) * pow(int(c.denominator), -1, N) % N for c in p]


def modulus_without_escape(Q: Sequence[Fraction], S: Sequence[Fraction], D: Sequence[Fraction], bound: int = _PRIME_BOUND) -> int | None:
    """Return a prime modulo which the orbit comes back without an escape, or None if none below `bound` does.

    Parameters
    ----------
    Q, S : sequences of rationals, lengths n + 1
        The pair; see `exactkf.kernel.orbit_n`.
    D : sequence of rationals
        The coefficients of z^m D of the reduced pair.  Above a small bound only primes are tried modulo which
        the order of z modulo z^m D divides p - 1 or p + 1.
    """
    integral = fmpq_poly([fmpq(c.numerator, c.denominator) for c in D]).numer()
    for p in primes():
        if p > bound:
            return None
        if p > _SMALL and not _of_small_order(integral, p):
            continue
        q, s = _residues(Q, p), _residues(S, p)
        if q is not None and s is not None and _comes_back(q, s, p):
            return p
    return None


def _comes_back(q: list[int], s: list[int], p: int) -> bool:
    """Return whether the orbit modulo `p` comes back without an escape, by Brent's method."""
    marked, count = None, 0
    while (1 - s[-2] * s[-2]) % p:
        if (q, s) == marked:
            return True
        if count & (count - 1) == 0:
            marked = (q, s)
        q, s = modular_step(q, s, p)
        count += 1
    return False


def no_escape_modulo(Q: Sequence[Fraction], S: Sequence[Fraction], steps: int, p: int) -> bool:
    """Return whether no 1 - gamma^2 of the first `steps` steps vanishes modulo the prime `p`."""
    q, s = _residues(Q, p), _residues(S, p)
    if q is None or s is None:
        return False
    for _ in range(steps):
        if (1 - s[-2] * s[-2]) % p == 0:
            return False
        q, s = modular_step(q, s, p)
    return True


def _of_small_order(f: fmpz_poly, p: int) -> bool:
    if int(f.leading_coefficient()) % p == 0:
        return False
    modulo = nmod_poly([int(c) % p for c in f.coeffs()], p)
    power = _z_power(p - 1, modulo, p)
    return power == 1 or power * nmod_poly([0, 0, 1], p) % modulo == 1


def _z_power(k: int, f: nmod_poly, p: int) -> nmod_poly:
    x, power = nmod_poly([0, 1], p), nmod_poly([1], p)
    for bit in bin(k)[2:]:
        power = power * power % f
        if bit == "1":
            power = power * x % f
    return power


def escapes_before(Q: Sequence[Fraction], S: Sequence[Fraction], steps: int = 40) -> list[int]:
    """Return the `k` up to `steps` for which the plane `k` steps before the start is singular; the pair is reduced."""
    m, found = len(Q) - 1, []
    q, g = [fmpq(x.numerator, x.denominator) for x in Q[-2::-1]], [fmpq(x.numerator, x.denominator) for x in S[-2::-1]]
    X = [[fmpq(int(i == j)) for j in range(m)] for i in range(m)]
    Y = [[fmpq(0)] * m for _ in range(m)]
    for k in range(1, steps + 1):
        X, Y = backward(X, Y, q, g)
        if fmpq_mat(X).det() == 0:
            found.append(k)
    return found


def prime_without_singularity(Q: Sequence[Fraction], S: Sequence[Fraction], D: Sequence[Fraction], before: list[int]) -> int | None:
    """Return a prime that shows that a reduced pair that comes from escapes at the times `before` never escapes, or None."""
    integral = fmpq_poly([fmpq(c.numerator, c.denominator) for c in D]).numer()
    for p in primes(5):
        if p > _PADIC_BOUND:
            return None
        if p > 13 and not _of_small_order(integral, p):
            continue
        try:
            check_never_singular(list(Q), list(S), p, before)
        except Undefined:
            continue
        return p
    return None


def aperiodic_modulus(D: Sequence[Fraction]) -> int | None:
    """Return a prime that shows that the zeros of `D` are not distinct roots of unity, or None if they seem to be."""
    for p in (10**9 + 7, 10**9 + 9, 998244353):
        try:
            if has_infinite_order(list(D), p):
                return p
        except Undefined:  # the prime divides a denominator
            continue
    return None


def apparent_orders(D: Sequence[Any], bound: int = 10_000) -> list[int] | None:
    """Return the orders that the zeros of `D` seem to have as roots of unity, or None if one seems to be none.

    The coefficients are elements of one real number field.  Nothing rests on the result.
    """
    with precision(300):
        f = acb_poly([acb((x.enclose(80) if isinstance(x, RealNumber) else arb(x)).mid()) for x in D])
        try:
            found = f.roots(tol=arb(2) ** -150)
        except ValueError:  # zeros that the precision does not separate
            return None
        orders = []
        for z in found:
            turn = Fraction(str((z.log().imag / (2 * arb.pi())).mid().fmpq())).limit_denominator(bound)
            difference = abs(acb(2 * arb(fmpq(turn.numerator, turn.denominator))).exp_pi_i() - z)
            if not difference < arb(2) ** -100:
                return None
            orders.append(turn.denominator)
    return orders
