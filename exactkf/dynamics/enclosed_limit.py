# SPDX-License-Identifier: MIT
r"""The limit of an orbit, enclosed to any number of digits.

Main definitions
----------------
``for_checker``      polynomials in the numbers of the checker
``EnclosedLimit``    the stable spectral factor of `D` times the factors in common, in intervals

Choice of algorithm
-------------------
The coefficients of the factor have a large degree over the rational numbers if the data are algebraic or the order is high, so they are
enclosed and not written as roots.  Approximate zeros give a center; `exactkf.kernel.spectral.enclosed_factor` makes intervals
of it, rigorously, and the checker does the same again.  Factors of `D` over the field whose zeros are all on the circle are split off exactly; of
a factor with other zeros besides, those on the circle are isolated as x = z + 1/z.

References
----------
BLZ94 (7.1).  R. Krawczyk, Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken, Computing 4 (1969).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from flint import acb_poly, arb, fmpq, fmpq_poly

from exactkf._errors import Unsupported
from exactkf.dynamics.exact_json import element_json, field_json
from exactkf.exact.balls import precision
from exactkf.exact.numberfield import RealNumber
from exactkf.exact.polynomials import count_roots
from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.intervals import around, product
from exactkf.kernel.numbers import Undefined, fraction
from exactkf.kernel.roots import chebyshev, count_circle, divmod_poly, squarefree, times_poly
from exactkf.kernel.spectral import enclosed_factor

__all__ = ["EnclosedLimit", "for_checker"]

_START, _BOUND = 256, 1 << 15
_DIGITS = 50
_Factors = list[tuple[list[Any], int]]


@dataclass(frozen=True)
class EnclosedLimit:
    """What the limit is made of.

    Attributes
    ----------
    D : list of numbers
        The coefficients of z^m D.
    rest, mixed : lists of pairs
        Square-free factors from z^0 up with their multiplicities in `D`: without zeros on the circle, and with zeros on it (none of them 1 or -1)
        and off it.
    circle, removed : lists of numbers
        Half of the factor of `D` with zeros on the circle only, and the factors in common.
    """

    D: list[Any]
    rest: _Factors
    mixed: _Factors
    circle: list[Any]
    removed: list[Any]

    @classmethod
    def of(cls, D: Sequence[Any], removed: Sequence[Any]) -> EnclosedLimit:
        """From z^m D, which keeps one sign on the circle."""
        one = D[-1] / D[-1]
        circle, rest, mixed = [one], [], []
        for factor, multiplicity, on in _factors(D):
            monic = [x / factor[-1] for x in factor]
            for root in (1, -1):
                if on and on < len(monic) - 1 and sum((x * root**k for k, x in enumerate(monic)), 0 * one) == 0:
                    monic, on = divmod_poly(monic, [-root * one, one])[0], on - 1
                    for _ in range(multiplicity // 2):
                        circle = times_poly(circle, [-root * one, one])
            if not on:
                rest.append((monic, multiplicity))
            elif on < len(monic) - 1:
                mixed.append((monic, multiplicity))
            for _ in range(multiplicity // 2 if on == len(monic) - 1 else 0):
                circle = times_poly(circle, monic)
        return cls(list(D), rest, mixed, circle, list(removed))

    @cached_property
    def shown(self) -> tuple[list[tuple[int, int]], int, list[int], list[tuple[Fraction, Fraction, int]]]:
        """What `enclosed` returns for 50 digits."""
        return self.enclosed(_DIGITS)

    @property
    def limit(self) -> dict[str, Any]:
        """The limit as an answer has it, to 50 digits or more."""
        intervals, bits = self.shown[:2]
        return {"alpha": [{"interval": [str(fmpq(lo, 1 << bits)), str(fmpq(hi, 1 << bits))]} for lo, hi in intervals], "gamma": "0"}

    @property
    def evidence(self) -> dict[str, Any]:
        """The center of the intervals, for the checker."""
        _, bits, center, pairs = self.shown
        return {"circle": [element_json(x) for x in self.circle], "pairs": [[str(lo), str(hi), k] for lo, hi, k in pairs], "center": center, "bits": bits}

    def enclosed(self, digits: int) -> tuple[list[tuple[int, int]], int, list[int], list[tuple[Fraction, Fraction, int]]]:
        """Intervals of integers over 2^bits around the coefficients below the leading one, leading one first; the bits, the center and the pairs."""
        D, circle, removed = for_checker([self.D, self.circle, self.removed])
        bits = max(_START, 5 * digits)
        while bits < _BOUND:
            try:
                center, pairs = self._approximate(bits)
                w = enclosed_factor(D, circle, pairs, center, bits)
                full = product(w, [around(x, bits) for x in removed], bits)[-2::-1]
                if all((hi - lo) * 10**digits <= max(1 << bits, abs(lo)) for lo, hi in full):
                    return full, bits, center, pairs
            except Undefined:
                pass
            bits *= 2
        raise Unsupported("the zeros of D are too close to the unit circle to be enclosed")

    def _approximate(self, bits: int) -> tuple[list[int], list[tuple[Fraction, Fraction, int]]]:
        """2^bits times the coefficients of the stable factor below the leading one, and the constant c, nearly; the pairs on the circle."""
        pairs = [(lo, hi, multiplicity // 2) for factor, multiplicity in self.mixed for lo, hi in _on_circle(factor, bits)]
        with precision(2 * bits):
            w = acb_poly([1])
            for factor, multiplicity in self.rest + self.mixed:
                for z in acb_poly([_ball(x, bits) for x in factor]).roots(tol=arb(2) ** -bits):
                    if abs(z) < 1 - arb(2) ** -(bits // 2):
                        w *= acb_poly([-z, 1]) ** multiplicity
            values = [w[i].real for i in range(w.degree())] + [w[0].real / _ball(self.D[-1], bits)]
            return [int((x * arb(2) ** bits).mid().fmpq().floor()) for x in values], pairs


def _factors(D: Sequence[Any]) -> list[tuple[list[Any], int, int]]:
    """Square-free factors with their multiplicities and the numbers of their zeros on the circle."""
    if isinstance(D[0], RealNumber):
        return [(factor, multiplicity, count_circle(factor)[1]) for factor, multiplicity in squarefree(list(D))]
    return [([fmpq(c) for c in f.coeffs()], multiplicity, count_roots(f).on) for f, multiplicity in fmpq_poly(list(D)).numer().factor()[1]]


def _on_circle(factor: list[Any], bits: int) -> list[tuple[Fraction, Fraction]]:
    """Narrow intervals around x = z + 1/z for the zeros on the circle of a palindromic factor."""
    width = Fraction(1, 1 << bits)
    with precision(4 * bits):
        found = acb_poly([_ball(x, 2 * bits) for x in chebyshev(factor)]).roots(tol=arb(2) ** (-2 * bits))
        real = [z.real.mid().fmpq() for z in found if abs(z.imag) < arb(2) ** -bits and abs(z.real) < 2]
    return [(x - width, x + width) for x in sorted(Fraction(int(v.p), int(v.q)).limit_denominator(1 << 2 * bits) for v in real)]


def _ball(x: Any, bits: int) -> arb:
    return x.enclose(bits // 3).mid() if isinstance(x, RealNumber) else arb(fmpq(x))


def for_checker(polynomials: list[list[Any]]) -> list[list[Any]]:
    """Return the same polynomials in the numbers of the checker."""
    found = next((x.field for p in polynomials for x in p if isinstance(x, RealNumber)), None)
    if found is None:
        return [[Fraction(int(fmpq(x).p), int(fmpq(x).q)) for x in p] for p in polynomials]
    modulus, lo, hi = field_json(found)  # type: ignore[misc]
    field = AlgebraicField([fraction(c) for c in modulus], fraction(lo), fraction(hi))
    return [[field.element([Fraction(int(c.p), int(c.q)) for c in x.poly.coeffs()]) for x in p] for p in polynomials]
