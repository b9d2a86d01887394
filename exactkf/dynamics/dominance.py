# SPDX-License-Identifier: MIT
r"""An absolute value at which one product of zeros of `D` is larger than all others, so that escapes end.

Main definitions
----------------
``dominating``  what shows that a reduced rational pair never escapes, from steps up to a bound and valuations beyond
``bounds``      the same without the steps

Main statements
---------------
See `exactkf.kernel.orbit_dominated`.

Choice of algorithm
-------------------
:math:`\det X_t` is a sum of :math:`\lambda^t`, :math:`\lambda` the products of `m` zeros of `D`, with polynomials in `t` for coefficients.  If all zeros
of `D` but roots of unity have moduli other than one, and `N` is a common order of those roots, one :math:`\lambda^N` is the largest.  That is so if `p`
divides all coefficients but the middle one of `D` without the factors that have roots of unity; at the real absolute value, if there is no zero on the
circle but roots of unity.  The recursion of the determinants and the
coefficients come from linear equations.

References
----------
BLZ94 Section 8.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import islice
from math import comb, gcd
from typing import Any

from flint import fmpq, fmpq_mat, fmpq_poly, fmpz_poly, nmod_mat

from exactkf.dynamics.wandering import common_period, no_escape_modulo, primes
from exactkf.exact.balls import precision
from exactkf.exact.polynomials import count_roots
from exactkf.exact.rationals import to_fraction
from exactkf.kernel.numbers import Undefined, fraction
from exactkf.kernel.orbit_dominated import Powers, last_escape, last_zero, last_zero_by_size, power_sums
from exactkf.kernel.orbit_polynomial import determinants

__all__ = ["bounds", "dominating"]

_PRIMES, _LARGE, _MOST = 1000, (1 << 61) - 1, 2000
_Parts = list[tuple[list[fmpq], list[list[fmpq]]]]


def dominating(Q: Sequence[Any], S: Sequence[Any], D: fmpz_poly) -> tuple[dict[str, Any], int] | None:
    """Return evidence, and a step before which every escape would be, or None.

    Parameters
    ----------
    Q, S : sequences of rationals
        A reduced pair, in the order of powers of z.
    D : fmpz_poly
        A multiple of its z^m D.
    """
    return next(((evidence, steps) for evidence, steps in bounds(Q, S, D) if no_escape_modulo(Q, S, steps, _LARGE)), None)


def bounds(Q: Sequence[Any], S: Sequence[Any], D: fmpz_poly) -> Iterator[tuple[dict[str, Any], int]]:
    """Yield, for each absolute value at which one dominates, evidence and a step from which on no determinant vanishes, whatever happens before."""
    unity, rest = _split(D)
    common = gcd(*(int(c) for i, c in enumerate(rest.coeffs()) if 2 * i != rest.degree()))
    candidates: list[int | None] = [p for p in islice(primes(), _PRIMES) if rest.degree() > 0 and common % p == 0]
    if rest.degree() > 0 and not count_roots(rest).on:
        candidates.append(None)
    N = common_period(unity.coeffs()) if candidates else None
    size = 2 * comb(2 * len(Q) - 2, len(Q) - 1)
    if N is None or N * size > _MOST:
        return
    q, s = ([fmpq(x.numerator, x.denominator) for x in f] for f in (Q, S))
    values = determinants(q, s, N * size)
    for p in candidates:
        try:
            classes = [_parts([fmpq(x.numerator, x.denominator) for x in values[k::N]]) for k in range(N)]
            at = {"prime": p} if p else {"radii": [str(x) for x in _radii(classes)]}
            chosen = [_first_dominates(parts, at) for parts in classes]
            evidence = {**at, "modulus": _LARGE, "classes": [[[_words(M), [_words(row) for row in C]] for M, C in parts] for parts in chosen]}
            yield evidence, last_escape(list(Q), list(S), evidence)
        except Undefined:
            continue


def _split(D: fmpz_poly) -> tuple[fmpz_poly, fmpz_poly]:
    """The factors with roots of unity, and the primitive rest."""
    unity = rest = fmpz_poly([1])
    for factor, multiplicity in D.factor()[1]:
        if factor.is_cyclotomic():
            unity *= factor**multiplicity
        else:
            rest *= factor**multiplicity
    return unity, rest


def _parts(values: list[fmpq]) -> _Parts:
    """The sums of powers that have the values, of the least recursion."""
    half = len(values) // 2
    if any(x.q % _LARGE == 0 for x in values):
        raise Undefined("a denominator is no unit")
    r = nmod_mat(half, half, [int(x.p) * pow(int(x.q), -1, _LARGE) % _LARGE for i in range(half) for x in values[i:i + half]], _LARGE).rank()
    hankel = fmpq_mat([values[i:i + r] for i in range(r)])
    recursion = hankel.solve(fmpq_mat([[-x] for x in values[r:2 * r]]))
    chi = fmpq_poly([*(recursion[i, 0] for i in range(r)), 1])
    factors = [(fmpq_poly(f) / f.leading_coefficient(), k) for f, k in chi.numer().factor()[1]]
    columns, shape = [], []
    for f, k in factors:
        M, d = f.coeffs(), f.degree()
        sums = [fmpq(x.numerator, x.denominator) for x in power_sums([Fraction(int(c.p), int(c.q)) for c in M], r + d)]
        for power in range(k):
            columns += [[s**power * sums[s + b] for s in range(r)] for b in range(d)]
        shape.append((M, d, k))
    solved = fmpq_mat([list(row) for row in zip(*columns, strict=True)]).solve(fmpq_mat([[x] for x in values[:r]]))
    flat, parts = [solved[i, 0] for i in range(r)], []
    for M, d, k in shape:
        parts.append((M, [flat[d * i:d * (i + 1)] for i in range(k)]))
        flat = flat[d * k:]
    return parts


def _radii(classes: list[_Parts]) -> tuple[Fraction, Fraction]:
    """Numbers between the smallest and the next modulus of a zero."""
    polynomials = {tuple(map(str, M)): fmpq_poly(M).numer() for parts in classes for M, _ in parts}
    with precision(128):
        roots: Any = [z for f in polynomials.values() for z in f.complex_roots()]  # pairs of a ball and a multiplicity
        sizes = sorted(to_fraction(z.abs_lower().mid().fmpq()) for z, _ in roots)
    gap = sizes[1] - sizes[0] if len(sizes) > 1 else Fraction(0)
    if gap * 1000 < sizes[0]:
        raise Undefined("the smallest zero is not alone")
    near = 2 + int(8 / gap)
    return (sizes[0] + gap / 4).limit_denominator(near), (sizes[1] - gap / 4).limit_denominator(near)


def _first_dominates(parts: _Parts, at: dict[str, Any]) -> _Parts:
    """The same with the polynomial first that has the dominating zero, or Undefined."""
    for i in range(len(parts)):
        order = [parts[i], *parts[:i], *parts[i + 1:]]
        read = [Powers(_fractions(M), [_fractions(row) for row in C]) for M, C in order]
        try:
            if "prime" in at:
                last_zero(read, at["prime"])
            else:
                last_zero_by_size(read, *map(fraction, at["radii"]))
        except Undefined:
            continue
        return order
    raise Undefined("no zero dominates")


def _fractions(values: Sequence[fmpq]) -> list[Fraction]:
    return [Fraction(int(x.p), int(x.q)) for x in values]


def _words(values: Sequence[fmpq]) -> list[str]:
    return [str(x) for x in values]
