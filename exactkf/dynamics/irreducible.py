# SPDX-License-Identifier: MIT
"""Evidence that the polynomial of a field is irreducible; the checker is `exactkf.kernel.irreducible`.

Main definitions
----------------
``irreducible_at``  the evidence

Choice of algorithm
-------------------
First a prime value, which is there for most small fields.  Where the Galois group has an element of the order of the degree a prime modulo which the
polynomial is irreducible is soon found, and elsewhere the degrees modulo several primes often leave none for a factor.  What they leave allows larger
factors in a value, whose argument need only be larger than the zeros.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import islice
from typing import Any, cast

from flint import arb, fmpz, fmpz_poly, nmod_poly

from exactkf.dynamics.wandering import primes
from exactkf.exact.balls import precision
from exactkf.exact.numberfield import CyclotomicRealField, RealField
from exactkf.exact.rationals import to_fraction
from exactkf.kernel.irreducible import are_within, leaves

__all__ = ["irreducible_at"]

_ARGUMENTS, _PRIMES, _MOST_BITS, _PATIENCE = 5000, 60, 80, 20


def irreducible_at(field: RealField) -> Any:
    """Return what shows the checker that the polynomial of the field is irreducible, or None if nothing was found."""
    F = [int(c) for c in field.minpoly.numer().coeffs()]
    largest = max(abs(c) for c in field.minpoly.coeffs())
    bound = Fraction(int(largest.p), int(largest.q)) + 1
    n = _prime_value(F, bound, 1, signs=(1,))
    if n is not None:
        return n
    if isinstance(field, CyclotomicRealField):
        return {"cyclotomic": field.n}
    least, chosen = _least_degree(F)
    if least == len(F) - 1:
        return {"primes": chosen}
    R = _radius(F)
    n = None if R is None else _prime_value(F, R, least, signs=(1, -1))
    return None if n is None else {"at": n, "radius": str(R), **({"primes": chosen} if chosen else {})}


def _prime_value(F: list[int], R: Fraction, k: int, signs: tuple[int, ...]) -> int | None:
    """An n as in statement 2 of the checker, where the zeros have a modulus less than R."""
    first = int(R) + 2
    for size in range(first, first + _ARGUMENTS):
        for n in (sign * size for sign in signs):
            value, bound = abs(sum(c * n**i for i, c in enumerate(F))), (size - R) ** k
            if value.bit_length() > _MOST_BITS + int(bound).bit_length():
                return None
            if value == 0:
                continue
            rest = leaves(F, n, bound)[0]
            if rest.bit_length() <= _MOST_BITS and fmpz(rest).is_prime():
                return n
    return None


def _least_degree(F: list[int]) -> tuple[int, list[int]]:
    """The least positive degree that a factor may have, and the primes that show it."""
    d, chosen = len(F) - 1, list[int]()
    possible, idle = (1 << d + 1) - 1, 0
    for p in islice((p for p in primes(3) if F[-1] % p), _PRIMES):
        factors = nmod_poly([c % p for c in F], p).factor()[1]
        if any(k > 1 for _, k in factors):
            continue
        sums = 1
        for f, _ in factors:
            sums |= sums << f.degree()
        idle += 1
        if possible & sums != possible:
            possible, idle = possible & sums, 0
            chosen.append(p)
        if possible == 1 | 1 << d or idle > _PATIENCE:
            break
    return next(k for k in range(1, d + 1) if possible >> k & 1), chosen


def _radius(F: list[int]) -> Fraction | None:
    """A number that the checker finds larger than all zeros in size, not much larger than needed."""
    with precision(64):
        size, roots = arb(0), fmpz_poly(F).complex_roots()
        for z, _ in cast(Any, roots):
            size = size.max(abs(z))
        near = to_fraction(size.upper().fmpq())
    for percent in (101, 103, 106, 110, 120, 140, 200):
        R = (near * percent / 100).limit_denominator(100)
        if are_within(F, R):
            return R
    return None
