# SPDX-License-Identifier: MIT
r"""Searches for orbits that neither converge nor repeat; what they find, the checker checks.

Main definitions
----------------
``places_without_escape``  primes that together show that the orbit never escapes
``aperiodic_place``        a prime that shows that the zeros of `D` are not distinct roots of unity
``modulus_without_escape``  one small prime that shows it
``escapes_before``         the times before the start at which the orbit would have escaped
``Readings``               a pair and its `D` modulo primes

Main statements
---------------
See `exactkf.kernel.orbit_n` and `exactkf.kernel.orbit_sieve`.

Choice of algorithm
-------------------
Modulo a prime `p` that divides no denominator :math:`S_m` has a finite order `L`, and of the `L` determinants
:math:`\det X_t` about one in `p` vanishes.  Where `L` is about `p`, which is so if the zeros of `D` modulo `p` have orders
that divide p - 1 or p + 1, few times are left, and two or three such primes whose orders have a large common
divisor leave none.  Small steps and giant steps: :math:`S^{i + jB}` is a product of two of :math:`2\sqrt L` matrices.

References
----------
BLZ94 Section 8.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import isqrt, lcm
from typing import Any, NamedTuple

from flint import acb, acb_poly, arb, fmpq, fmpz, fmpz_mat, nmod_mat, nmod_poly

from exactkf.exact.balls import precision
from exactkf.exact.numberfield import RealField, RealNumber
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.orbit_sieve import intersected, step_matrix
from exactkf.kernel.orbit_wandering import common_order, modular, modular_step

__all__ = ["Readings", "aperiodic_place", "apparent_orders", "escapes_before", "modulus_without_escape", "no_escape_modulo", "places_without_escape", "primes"]

_LARGE = 10**15
_SMALL, _PRIME_BOUND, _PRIME_BOUND_ALONE = 100, 30_000, 300
_LONGEST, _MOST_ZEROS, _MOST_LEFT, _MOST_STEPS, _SOON = 5000, 12, 10_000, 200_000, 10_000


def primes(start: int = 2) -> Iterator[int]:
    """Yield the primes from `start` on."""
    p = start
    while True:
        if fmpz(p).is_prime():
            yield p
        p += 1


class Readings(NamedTuple):
    """A reduced pair and its `D`, to be read modulo primes.

    Attributes
    ----------
    q, g : sequences of rationals or of elements of one field
        The vectors of the pair.
    D : sequence of the same
        The coefficients of z^m D.
    field : RealField or None
    """

    q: Sequence[Any]
    g: Sequence[Any]
    D: Sequence[Any]
    field: RealField | None

    @classmethod
    def of(cls, Q: Sequence[Any], S: Sequence[Any], D: Sequence[Any]) -> Readings:
        """From the polynomials of a reduced pair."""
        return cls(Q[-2::-1], S[-2::-1], D, next((x.field for x in Q if isinstance(x, RealNumber)), None))

    def roots(self, p: int) -> list[int] | None:
        """The residues of the generator modulo `p`, if there are as many as the degree of the field; none for rational data."""
        if self.field is None:
            return []
        f = [int(c.p) * pow(int(c.q), -1, p) % p for c in self.field.minpoly.coeffs()] if self.field.minpoly.denom() % p else []
        factors = nmod_poly(f, p).factor()[1] if f else []
        found = sorted(int(-g[0] / g[1]) for g, k in factors if g.degree() == 1 and k == 1)
        return found if len(found) == self.field.degree else None

    def all(self, values: Sequence[Any], p: int, power: int = 1) -> list[list[int]] | None:
        """The values modulo `p` or its square, in each of the ways to read them; None if a denominator is no unit or the field is not read."""
        roots = self.roots(p)
        if roots is None:
            return None
        try:
            return [_read(values, p**power, self._lifted(r, p) if power > 1 else r) for r in (roots or [0])]
        except (ValueError, ZeroDivisionError):
            return None

    def _lifted(self, r: int, p: int) -> int:
        """The zero modulo p^2 that a zero modulo `p` becomes."""
        if self.field is None:
            return 0
        f = self.field.minpoly * self.field.minpoly.denom()
        value, slope = f(fmpq(r)), f.derivative()(fmpq(r))
        return (r - int(value.p) * pow(int(slope.p), -1, p)) % (p * p)

    def place(self, p: int, *entries: int) -> list[Any]:
        """A place as evidence names it."""
        return [p, *entries] if self.field is None else [p, *entries, self.roots(p)]


def _read(values: Sequence[Any], p: int, r: int) -> list[int]:
    out = []
    for x in values:
        total = 0
        for c in reversed(x.poly.coeffs() if isinstance(x, RealNumber) else [x]):
            total = (total * r + int(c.numerator) * pow(int(c.denominator), -1, p)) % p
        out.append(total)
    return out


# ---------------------------------------------------------------------- no escape
def modulus_without_escape(Q: Sequence[Fraction], S: Sequence[Fraction], bound: int = _PRIME_BOUND_ALONE) -> int | None:
    """Return a prime modulo which the orbit of a rational pair comes back without an escape, or None if none below `bound` does."""
    for p in primes():
        if p > bound:
            return None
        try:
            if _comes_back(modular(list(Q), p), modular(list(S), p), p):
                return p
        except Undefined:
            continue
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


def places_without_escape(pair: Readings, before: list[int]) -> list[list[Any]] | None:
    """Return places that together leave no time for an escape, or None.

    Parameters
    ----------
    pair : Readings
    before : list of int
        The `k` with a singular plane `k` steps before the start.
    """
    period, left, taken, steps = 1, [0], [], 0
    for p in primes(5 if before else 2):
        if p > _PRIME_BOUND or steps > _MOST_STEPS:
            return None
        L = _common_order_modulo(pair, p)
        if L is None:
            continue
        steps += L
        found = _zeros_modulo(pair, p, L)
        if found is None:
            continue
        found -= {-k % L for k in before if L > k and -k % L in found and _is_alone(pair, k, p, L)}
        if len(found) > _MOST_ZEROS:
            continue
        one = (p, L, found)
        few = next((some for some in ([one], *([one, other] for other in taken)) if not _left(some)), None)
        period, left = intersected(period, left, L, found)
        taken.append(one)
        if few or not left:
            return [pair.place(p, L) for p, L, _ in _needed(few or taken)]
        if len(left) > _MOST_LEFT or period > 1 << 60 and min(left) < _SOON:  # an escape, it seems
            return None
    return None


def _needed(taken: list[tuple[int, int, set[int]]]) -> list[tuple[int, int, set[int]]]:
    """Leave out, from the longest period down, what is not needed to leave no time."""
    for one in sorted(taken, key=lambda x: -x[1]):
        fewer = [x for x in taken if x is not one]
        if fewer and not _left(fewer):
            taken = fewer
    return taken


def _left(taken: list[tuple[int, int, set[int]]]) -> bool:
    period, left = 1, [0]
    for _, L, found in sorted(taken, key=lambda x: len(x[2])):
        period, left = intersected(period, left, L, found)
        if not left:
            return False
        if len(left) > _MOST_LEFT:
            return True
    return bool(left)


def _common_order_modulo(pair: Readings, p: int) -> int | None:
    """The order of z modulo `D` and `p`, common to all readings, if it is known to be short."""
    roots = pair.roots(p)
    if roots is None:
        return None
    read = pair.all(pair.D, p)
    if read is None:
        return None
    order = 1
    for d in read:
        if d[-1] == 0:
            return None
        found = _order_modulo(nmod_poly(d, p), p)
        if found is None or (order := lcm(order, found)) > max(_LONGEST, p + 1):
            return None
    return order


def _order_modulo(f: nmod_poly, p: int) -> int | None:
    """The order of z modulo `f`, if it divides p - 1 or p + 1, or is small."""
    z = nmod_poly([0, 1], p)
    power = z.pow_mod(p - 1, f)
    if power == 1:
        return _least(z, f, p - 1)
    if power * z % f * z % f == 1:
        return _least(z, f, p + 1)
    if p > _SMALL:
        return None
    exponent = lcm(*(p ** g.degree() - 1 for g, _ in f.factor()[1]))
    if z.pow_mod(exponent, f) != 1:  # a multiple zero
        exponent *= p
        if z.pow_mod(exponent, f) != 1:
            return None
    order = _least(z, f, exponent)
    return order if order <= _LONGEST else None


def _least(z: nmod_poly, f: nmod_poly, order: int) -> int:
    for q, _ in fmpz(order).factor():
        while order % int(q) == 0 and z.pow_mod(order // int(q), f) == 1:
            order //= int(q)
    return order


def _zeros_modulo(pair: Readings, p: int, L: int) -> set[int] | None:
    """The t below `L` with a singular X_t in some reading, as `exactkf.kernel.orbit_sieve.zeros_modulo`, or None."""
    found: set[int] = set()
    for values in pair.all([*pair.q, *pair.g], p) or []:
        m = len(values) // 2
        try:
            S = nmod_mat(2 * m, 2 * m, [x for row in step_matrix(values[:m], values[m:], p) for x in row], p)
        except Undefined:
            return None
        one = nmod_mat(2 * m, 2 * m, [int(i == j) for i in range(2 * m) for j in range(2 * m)], p)
        if S ** L != one:
            return None
        size = isqrt(L) + 1
        tops, power = [], nmod_mat(m, 2 * m, [int(i == j) for i in range(m) for j in range(2 * m)], p)
        for _ in range(size):
            tops.append(power)
            power = power * S
        leap, columns = S**size, nmod_mat(2 * m, m, [int(i == j) for i in range(2 * m) for j in range(m)], p)
        for start in range(0, L, size):
            found.update(start + i for i, top in enumerate(tops) if not (top * columns).det())
            columns = leap * columns
    return {t for t in found if t < L}


def _is_alone(pair: Readings, k: int, p: int, L: int) -> bool:
    """Whether det X_{L - k} is not zero modulo p^2 in any reading; see `exactkf.kernel.orbit_sieve`, statement 3."""
    N = p * p
    for values in pair.all([*pair.q, *pair.g], p, 2) or []:
        m = len(values) // 2
        power = nmod_mat(2 * m, 2 * m, [x for row in step_matrix(values[:m], values[m:], N) for x in row], N) ** (L - k)
        if int(fmpz_mat(m, m, [int(power[i, j]) for i in range(m) for j in range(m)]).det()) % N == 0:
            return False
    return True


def no_escape_modulo(Q: Sequence[Fraction], S: Sequence[Fraction], steps: int, p: int) -> bool:
    """Return whether no 1 - gamma^2 of the first `steps` steps vanishes modulo the prime `p`."""
    try:
        q, s = modular(list(Q), p), modular(list(S), p)
    except Undefined:
        return False
    for _ in range(steps):
        if (1 - s[-2] * s[-2]) % p == 0:
            return False
        q, s = modular_step(q, s, p)
    return True


def escapes_before(pair: Readings, steps: int = 40) -> list[int]:
    """Return the `k` up to `steps` for which the plane `k` steps before the start seems to be singular, as it is modulo a large prime."""
    for p in primes(_LARGE):
        read = pair.all([*pair.q, *pair.g], p)
        if read is None:
            continue
        found: list[int] = []
        for values in read:
            m = len(values) // 2
            S = nmod_mat(2 * m, 2 * m, [x for row in step_matrix(values[:m], values[m:], p) for x in row], p).inv()
            top, columns = (nmod_mat(*shape, [int(i == j) for i in range(shape[0]) for j in range(shape[1])], p) for shape in ((m, 2 * m), (2 * m, m)))
            for k in range(1, steps + 1):
                columns = S * columns
                if not (top * columns).det():
                    found.append(k)
        return found
    return []


# ---------------------------------------------------------------------- no period
def aperiodic_place(pair: Readings) -> list[Any] | None:
    """Return a place that shows that the zeros of `D` are not distinct roots of unity, or None if they seem to be."""
    degree = 1 if pair.field is None else pair.field.degree
    N, tried = common_order((len(pair.D) - 1) * degree), 0
    for p in primes(10**9 + 7):
        read = pair.all([c / pair.D[-1] for c in pair.D], p)
        if read is None:
            continue
        if all(nmod_poly([0, 1], p).pow_mod(N, nmod_poly(d, p)) != 1 for d in read):
            return pair.place(p)
        tried += 1
        if tried == 3:
            return None
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
