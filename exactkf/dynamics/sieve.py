# SPDX-License-Identifier: MIT
r"""Primes, and their powers, that together show that an orbit never escapes, where two or three primes do not.

Main definitions
----------------
``places_of_signs``  for either kind of zero, the primes that leave no time for it

Main statements
---------------
See `exactkf.kernel.orbit_sieve`, statements 2, 5 and 6.

Choice of algorithm
-------------------
Places with periods :math:`L_i` and a part :math:`q_i` of the residues leave about :math:`\operatorname{lcm}(L_i) \prod q_i` times, as far as chance goes, and
one in :math:`p^a` of them where the common period is a multiple of :math:`L p^a`.  So those are taken whose periods have much in common, also
with the primes, the shorter the better; :math:`q_i` is about :math:`1/p_i` before it is known.

Two ways are tried.  The first takes one place after the other, each the one that is to leave the fewest times, and goes on from what is in fact left:
where `D` has multiple zeros about as many are to be left on the average as were there, and it is by chance that there are none.  It is
soon over, so it is tried with several amounts of patience.  The second chooses all places before.
Algebraic data have several places at a prime, each of which leaves other times.

References
----------
BLZ94 Section 8.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import takewhile
from math import gcd, inf, lcm, prod
from typing import Any

from flint import nmod_mat, nmod_poly

from exactkf.dynamics.wandering import Readings, is_alone, least, place, primes, step_matrix_at, unit, zeros_at
from exactkf.kernel.orbit_sieve import exponent, has_null_vector, intersected, intertwiner

__all__ = ["places_of_signs"]

_PRIME_BOUND, _LONGEST = 3000, (10_000, 30_000, 100_000, 300_000, 999_999)
_PATIENCE, _MOST_PLACES = ((300, 10_000), (1000, 10_000), (3000, 30_000), (1000, 100_000)), 25
_MARGIN, _MOST_LEFT, _MOST_READ, _FEW, _MANY = 2, 5_000, 2_000_000, 10, 60  # with a few times expected, there may be none
_Place = tuple[int, int | None, int]


def places_of_signs(pair: Readings, before: Mapping[int, int]) -> list[list[list[Any]]] | None:
    """Return for either sign places that together leave no time for an escape, or None.

    Parameters
    ----------
    pair : Readings
    before : mapping
        As `exactkf.dynamics.wandering.escapes_before` finds it.
    """
    some = takewhile(lambda p: p < _PRIME_BOUND, primes(3 if before else 2))
    candidates = [(p, root, L) for p in some for root in pair.roots(p) if (L := _order(pair, p, root))]
    zeros: dict[_Place, set[int]] = {}
    found = []
    for sign in (1, -1):
        taken = _Search(pair, before, sign, zeros).places(candidates)
        if taken is None:
            return None
        found.append([place(p, root, L) for p, root, L in taken])
    return found


class _Search:
    """The search for one sign; the zeros of the determinants, read already, serve both."""

    def __init__(self, pair: Readings, before: Mapping[int, int], sign: int, zeros: dict[_Place, set[int]]) -> None:
        self.pair, self.before, self.sign, self.zeros = pair, before, sign, zeros
        self.known: dict[_Place, set[int]] = {}

    def places(self, candidates: list[_Place]) -> list[_Place] | None:
        """Places that leave no time, in an order in which few times are left on the way."""
        with_multiple_zeros = all(L % p == 0 for p, _, L in candidates)
        for one in sorted(candidates, key=lambda x: x[2] // x[0])[:_MANY if with_multiple_zeros else _FEW]:
            if one[2] <= _LONGEST[0] and not self._read(one):  # the times of one place may all be of the other kind
                return [one]
        for most, longest in _PATIENCE:
            if taken := self._one_by_one([c for c in candidates if c[2] <= longest], most):
                return self._needed(taken)
        for most in _LONGEST:
            within = [c for c in candidates if c[2] <= most]
            chosen = self._with_much_in_common(within)
            while self._expected(chosen) < _MARGIN and (unknown := [c for c in chosen if c not in self.known]):
                if sum(c[2] for c in candidates if c in self.zeros) + sum(c[2] for c in unknown if c not in self.zeros) > _MOST_READ:
                    return None
                for one in unknown:
                    self._read(one)
                chosen = self._with_much_in_common(within)
            if self._expected(chosen) < _MARGIN and (taken := self._none_left(chosen)):
                return self._needed(taken)
        return None

    def _one_by_one(self, places: list[_Place], most: int) -> list[_Place] | None:
        """Places taken one after the other until no time is left, or None if so many or more come to be left, or a few after many places."""
        period, left, order, depths = 1, [0], list[_Place](), dict[_Place, int]()
        while left:
            weighed = [(self._weight(x, period, len(left), order, depths, most), x) for x in places] if len(order) < _MOST_PLACES else []
            weight, one = min(weighed, key=lambda x: x[0], default=(inf, None))
            if one is None or weight == inf:
                return None
            places = [x for x in places if x is not one]
            if len(self._read(one)) == one[2]:  # it excludes nothing, or cannot be read
                continue
            period, left = intersected(period, left, one[2], self._read(one), 3 * most)
            if len(left) == 3 * most:
                return None
            order.append(one)
            for other in order:
                a = exponent(period // other[2], other[0])
                if a > depths.get(other, 0):
                    left, depths[other] = self._deeper(left, other, a), a
        return order

    def _weight(self, one: _Place, period: int, left: int, order: list[_Place], depths: dict[_Place, int], most: int) -> float:
        """How many times are to be left with one place more, and what it takes to find them."""
        p, _, L = one
        more = L // gcd(period, L)
        passing = left * more * float(self._part(one))
        if passing > most:
            return inf
        final = passing / p ** exponent(period * more // L, p)
        for other in order:
            final /= other[0] ** (exponent(period * more // other[2], other[0]) - depths.get(other, 0))
        return (final + 0.3) * (1 + passing / 3000 + (0 if one in self.known else L / 30000))

    def _needed(self, taken: list[_Place]) -> list[_Place]:
        """Leave out, from the longest period down, what is not needed."""
        for one in sorted(taken, key=lambda x: -x[2]):
            fewer = [x for x in taken if x is not one]
            if self._expected(fewer) < _MARGIN:
                taken = self._none_left(fewer) or taken
        return taken

    def _read(self, one: _Place) -> set[int]:
        """The times that a place leaves."""
        p, root, L = one
        if one in self.known:
            return self.known[one]
        if one not in self.zeros:
            found = zeros_at(self.pair, p, root, L)
            if found is None:
                found = set(range(L))
            self.zeros[one] = found - {-k % L for k, r in self.before.items() if L > k and -k % L in found and is_alone(self.pair, k, r, p, root, L)}
        self.known[one] = set(self._deeper(sorted(self.zeros[one]), one, 0))
        return self.known[one]

    def _part(self, one: _Place) -> Fraction:
        """The part of the residues that a place leaves, or about that."""
        p, _, L = one
        return Fraction(len(self.known[one]), L) if one in self.known else Fraction(1, p)

    def _expected(self, places: Sequence[_Place]) -> Fraction:
        """How many times are left, as far as chance goes."""
        full = lcm(*(L for _, _, L in places))
        parts = prod((self._part(x) for x in places), start=Fraction(1))
        return full * parts / prod(p ** exponent(full // L, p) for p, _, L in places)

    def _with_much_in_common(self, places: list[_Place]) -> list[_Place]:
        """Leave out, one after the other, places without which fewer times are left."""
        fewest = self._expected(places)
        while len(places) > 1:
            fewer, worst = min(((self._expected([x for x in places if x is not one]), one) for one in places), key=lambda x: x[0])
            if fewer >= fewest:
                return places
            fewest, places = fewer, [x for x in places if x is not worst]
        return places

    def _none_left(self, places: list[_Place]) -> list[_Place] | None:
        """The places in an order in which few times are left on the way to none, or None if some are left."""
        period, left, order, depths = 1, [0], list[_Place](), dict[_Place, int]()
        while places and left:
            one = min(places, key=lambda x: (self._expected([*order, x]), x[2]))
            places = [x for x in places if x is not one]
            found = self.known[one]
            if len(left) * len(found) > _MOST_LEFT * gcd(period, one[2]):
                return None
            period, left = intersected(period, left, one[2], found)
            order.append(one)
            for other in order:
                a = exponent(period // other[2], other[0])
                if a > depths.get(other, 0):
                    left, depths[other] = self._deeper(left, other, a), a
        return None if left else order

    def _deeper(self, left: list[int], one: _Place, a: int) -> list[int]:
        """The times left also modulo p^{a+1}, as `exactkf.kernel.orbit_sieve` finds them."""
        p, root, L = one
        N, m = p ** (a + 1), len(self.pair.q)
        values = self.pair.read([*self.pair.q, *self.pair.g], p, root, a + 1)
        S = step_matrix_at(self.pair, p, root, a + 1) if N < 1 << 63 else None
        if S is None or values is None or not left:
            return left
        K = [[self.sign * x for x in row] for row in intertwiner(values[:m], values[m:], N)]
        table = []
        for _ in range(0, (L * p**a).bit_length(), 5):
            powers = [unit(2 * m, 2 * m, N)]
            for _ in range(32):
                powers.append(S * powers[-1])
            S = powers.pop()
            table.append(powers)
        columns = unit(2 * m, m, N)
        kept = []
        for t in left:
            product, rest = columns, t % (L * p**a)
            for powers in table:
                rest, d = divmod(rest, 32)
                product = powers[d] * product
            entries = [[int(x) for x in row] for row in product.tolist()]
            rows = entries[:m] + [[(y - k) % N for y, k in zip(row, other, strict=True)] for row, other in zip(entries[m:], K, strict=True)]
            if nmod_mat(rows, N).rank() < m if a == 0 else has_null_vector([list(c) for c in zip(*rows, strict=True)], p, N):
                kept.append(t)
        return kept


def _order(pair: Readings, p: int, root: int | None) -> int | None:
    """The order of z modulo `D` at a place, if it is not too large."""
    f = pair.divisor(p, root)
    if f is None:
        return None
    exponent_of, repeated = 1, 1
    for g, k in f.factor()[1]:
        n = g.degree()
        own = n % 2 == 0 and nmod_poly(g.coeffs()[::-1], p) * g[n] == g * g[0]  # with a zero 1/z for each zero z
        exponent_of = lcm(exponent_of, p ** (n // 2) + 1 if own else p**n - 1)
        while repeated < k:
            repeated *= p
        if exponent_of > 100 * _LONGEST[-1]:
            return None
    z = nmod_poly([0, 1], p)
    if z.pow_mod(exponent_of * repeated, f) != 1:
        return None
    order = least(z, f, exponent_of * repeated)
    return order if order <= _LONGEST[-1] else None
