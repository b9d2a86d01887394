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
from math import ceil, floor, gcd
from typing import Any

from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.numbers import Undefined, Unknown, rational
from exactkf.kernel.roots import chebyshev

__all__ = ["cosine", "minimal_polynomial"]

_PI = (Fraction(31415926535, 10**10), Fraction(31415926536, 10**10))
_LARGEST = 1000
_TERMS = 5  # pairs of terms of the cosine series
_GRID = 1 << 40


@lru_cache(maxsize=1024)
def _cyclotomic(n: int) -> tuple[int, ...]:
    """Phi_n: z^n - 1 without the factors Phi_d, d a proper divisor of n."""
    p = [-1, *[0] * (n - 1), 1]
    for d in range(1, n):
        if n % d == 0:
            p = _over_monic(p, _cyclotomic(d))
    return tuple(p)


def _over_monic(p: list[int], q: tuple[int, ...]) -> list[int]:
    """p / q for a monic q that divides p."""
    rest, k = list(p), len(q) - 1
    for i in range(len(p) - 1, k - 1, -1):
        for j, c in enumerate(q[:-1], i - k):
            rest[j] -= rest[i] * c
    return rest[k:]


@lru_cache(maxsize=1024)
def _minimal(n: int) -> tuple[int, ...]:
    return tuple(chebyshev(list(_cyclotomic(n))))


def minimal_polynomial(n: int) -> list[Fraction]:
    """Minimal polynomial of 2 cos(2 pi/n), n >= 3, coefficients from x^0 up."""
    return [Fraction(c) for c in _minimal(n)]


def _series(x: Fraction, terms: int) -> Fraction:
    """Sum of (-1)^k x^(2k)/(2k)! for k < terms: above cos x for odd terms, below for even, when 0 <= x < 2."""
    a, b = x.numerator**2, x.denominator**2
    top, below = 1, 1  # 1 - x^2/(1 2) (1 - x^2/(3 4) (1 - ..)), from inside
    for k in range(terms - 1, 0, -1):
        top, below = (2 * k - 1) * (2 * k) * b * below - a * top, (2 * k - 1) * (2 * k) * b * below
    return Fraction(top, below)


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
    lo, hi = (Fraction(round_(x * _GRID), _GRID) for round_, x in ((floor, lo - width), (ceil, hi + width)))  # short numbers from here on
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
