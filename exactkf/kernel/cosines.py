# SPDX-License-Identifier: MIT
"""Cosines of rational multiples of pi as elements of real number fields.

With q/p in lowest terms, exp(i pi q/p) is a primitive n-th root of unity, n =
2p for odd q and n = p for even q. Hence 2 cos(pi q/p) is a root of the
polynomial psi with z^m psi(z + 1/z) = Phi_n(z), where Phi_n is the cyclotomic
polynomial and m half its degree. psi is irreducible over Q because Phi_n is
(Gauss). Its roots 2 cos(2 pi j/n) are at least 16/n^2 apart: an interval
shorter than that, in which psi changes sign, isolates one root, and an
enclosure of the cosine by its alternating series says which.

Main definitions
----------------
`cosine`
    cos(pi q/p), a rational number or an `exactkf.kernel.algebraic.Algebraic`.
`minimal_polynomial`
    psi, for n >= 3.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from math import gcd
from typing import Any

from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.numbers import Undefined, Unknown, rational
from exactkf.kernel.roots import chebyshev, divmod_poly

__all__ = ["cosine", "minimal_polynomial"]

_PI = (Fraction(31415926535, 10**10), Fraction(31415926536, 10**10))
_LARGEST = 1000
_TERMS = 5  # pairs of terms of the cosine series


@lru_cache(maxsize=256)
def _cyclotomic(n: int) -> tuple[Fraction, ...]:
    """Phi_n: z^n - 1 without the factors Phi_d, d a proper divisor of n."""
    p = [Fraction(-1)] + [Fraction(0)] * (n - 1) + [Fraction(1)]
    for d in range(1, n):
        if n % d == 0:
            p = divmod_poly(p, list(_cyclotomic(d)))[0]
    return tuple(p)


def minimal_polynomial(n: int) -> list[Fraction]:
    """Minimal polynomial of 2 cos(2 pi/n), n >= 3, coefficients from x^0 up."""
    return [Fraction(c) for c in chebyshev(list(_cyclotomic(n)))]


def _series(x: Fraction, terms: int) -> Fraction:
    """Sum of (-1)^k x^(2k)/(2k)! for k < terms: above cos x for odd terms, below for even, when 0 <= x < 2."""
    total, term = Fraction(0), Fraction(1)
    for k in range(terms):
        total += term
        term = -term * x * x / ((2 * k + 1) * (2 * k + 2))
    return total


def _enclosure(q: int, p: int) -> tuple[Fraction, Fraction]:
    """lo < 2 cos(pi q/p) < hi for 0 < 2q <= p; a cosine decreases there."""
    lo, hi = (rate * q / p for rate in _PI)
    return 2 * _series(hi, 2 * _TERMS), 2 * _series(lo, 2 * _TERMS + 1)


@lru_cache(maxsize=4096)
def _generator(q: int, p: int) -> Any:
    """2 cos(pi q/p) as generator of its field, 0 < 2q < p coprime, p > 3."""
    n = 2 * p if q % 2 else p
    lo, hi = _enclosure(q, p)
    width = Fraction(1, 4 * n * n)
    lo, hi = lo - width, hi + width
    if hi - lo >= Fraction(16, n * n):
        raise Undefined(f"cos(pi {q}/{p}): the denominator is too large for the enclosure of pi in use")
    field = AlgebraicField(minimal_polynomial(n), lo, hi, irreducible=True)
    return field.element([Fraction(0), Fraction(1)])


def cosine(q: Any, p: Any) -> Any:
    """cos(pi q/p) for integers q and p > 0.

    Cosines of different angles in (0, pi/2) are generators of different fields, and
    arithmetic between them is refused; write one as a Chebyshev polynomial in the other.

    Raises
    ------
    Undefined
        If q or p is not an integer, or p is not positive.
    Unknown
        If p in lowest terms is larger than 1000.
    """
    if not all(isinstance(k, int) and not isinstance(k, bool) for k in (q, p)) or p <= 0:
        raise Undefined("a cosine of a rational multiple of pi needs integers q and p > 0")
    q %= 2 * p
    q = min(q, 2 * p - q)
    common = gcd(q, p)
    q, p = q // common, p // common
    if 2 * q > p:
        return -cosine(p - q, p)
    if p <= 2:
        return 1 - q
    if p > _LARGEST:
        raise Unknown(f"cos(pi {q}/{p}): denominators up to {_LARGEST} are read")
    if p == 3:
        return rational(1, 2)
    return _generator(q, p) * Fraction(1, 2)
