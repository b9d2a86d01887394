# SPDX-License-Identifier: MIT
r"""The limit of an orbit with algebraic data, enclosed to any number of digits.

Main definitions
----------------
``EnclosedLimit``    the stable spectral factor of `D` times the factors in common, in intervals

Choice of algorithm
-------------------
The coefficients of the factor over the field of the data have a large degree over the rational numbers, so they are
enclosed and not written as roots.  Approximate zeros give a center; `exactkf.kernel.intervals.stable_factor` makes intervals
of it, rigorously, and the checker does the same again.  Zeros of `D` on the circle are split off if a factor of its square-free decomposition
over the field has no others.

References
----------
BLZ94 (7.1).  R. Krawczyk, Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken, Computing 4 (1969).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from flint import acb_poly, arb

from exactkf._errors import Unsupported
from exactkf.dynamics.exact_json import element_json, field_json
from exactkf.dynamics.spectral_factor import times
from exactkf.exact.balls import precision
from exactkf.exact.numberfield import RealNumber
from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.intervals import around, product, stable_factor
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.roots import count_circle, squarefree

__all__ = ["EnclosedLimit"]

_START, _BOUND = 256, 1 << 15
_DIGITS = 50


class EnclosedLimit(NamedTuple):
    """What the limit is made of.

    Attributes
    ----------
    rest : list of pairs
        Square-free factors without zeros on the circle, from z^0 up, with their multiplicities in `D`.
    lead : number
        The leading coefficient of z^m D.
    circle, removed : lists of numbers
        Half of the factor of `D` with zeros on the circle, and the factors in common.
    """

    rest: list[tuple[list[Any], int]]
    lead: Any
    circle: list[Any]
    removed: list[Any]

    @classmethod
    def of(cls, D: Sequence[Any], removed: Sequence[Any]) -> EnclosedLimit | None:
        """From z^m D, which keeps one sign on the circle; None if its zeros there do not split off."""
        circle, rest = [D[-1] / D[-1]], []
        for factor, multiplicity in squarefree(list(D)):
            monic = [x / factor[-1] for x in factor]
            on = count_circle(factor)[1]
            if on and on < len(factor) - 1:
                return None
            if not on:
                rest.append((monic, multiplicity))
            for _ in range(multiplicity // 2 if on else 0):
                circle = times(circle, monic)
        return cls(rest, D[-1], circle, list(removed))

    @property
    def limit(self) -> dict[str, Any]:
        """The limit as an answer has it, to 50 digits or more."""
        intervals, bits = self.enclosed(_DIGITS)[:2]
        return {"alpha": [{"interval": [str(Fraction(lo, 1 << bits)), str(Fraction(hi, 1 << bits))]} for lo, hi in intervals], "gamma": "0"}

    @property
    def evidence(self) -> dict[str, Any]:
        """The center of the intervals, for the checker."""
        _, bits, center = self.enclosed(_DIGITS)
        return {"circle": [element_json(x) for x in self.circle], "center": center, "bits": bits}

    def enclosed(self, digits: int) -> tuple[list[tuple[int, int]], int, list[int]]:
        """Intervals of integers over 2^bits around the coefficients below the leading one, leading one first; the bits, and the center."""
        pseudo = [self.lead]
        for factor, multiplicity in self.rest:
            for _ in range(multiplicity):
                pseudo = times(pseudo, factor)
        rest, circle, removed = _for_checker([pseudo, self.circle, self.removed])
        bits = max(_START, 5 * digits)
        while bits < _BOUND:
            center = self._center(bits)
            try:
                w = stable_factor(rest, center, bits) if len(rest) > 1 else [(1 << bits, 1 << bits)]
                full = product(product(w, [around(x, bits) for x in circle], bits), [around(x, bits) for x in removed], bits)[-2::-1]
                if all((hi - lo) * 10**digits <= max(1 << bits, abs(lo)) for lo, hi in full):
                    return full, bits, center
            except Undefined:
                pass
            bits *= 2
        raise Unsupported("the zeros of D are too close to the unit circle to be enclosed")

    def _center(self, bits: int) -> list[int]:
        """2^bits times the coefficients of the stable factor below the leading one, and the constant c, nearly."""
        with precision(2 * bits):
            w = acb_poly([1])
            for factor, multiplicity in self.rest:
                for z in acb_poly([_ball(x, bits) for x in factor]).roots(tol=arb(2) ** -bits):
                    if abs(z) < 1:
                        w *= acb_poly([-z, 1]) ** multiplicity
            values = [w[i].real for i in range(w.degree())] + [w[0].real / _ball(self.lead, bits)]
            return [int((x * arb(2) ** bits).mid().fmpq().floor()) for x in values]


def _ball(x: Any, bits: int) -> arb:
    return x.enclose(bits // 3).mid()


def _for_checker(polynomials: list[list[Any]]) -> list[list[Any]]:
    """The same polynomials in the numbers of the checker."""
    modulus, lo, hi = field_json(next(x.field for p in polynomials for x in p if isinstance(x, RealNumber)))  # type: ignore[misc]
    field = AlgebraicField([Fraction(c) for c in modulus], Fraction(lo), Fraction(hi))
    return [[field.element([Fraction(int(c.p), int(c.q)) for c in x.poly.coeffs()]) for x in p] for p in polynomials]
