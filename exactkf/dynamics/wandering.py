# SPDX-License-Identifier: MIT
r"""Searches for orbits that neither converge nor repeat; what they find, the checker checks.

Main definitions
----------------
``places_without_escape``  primes that together show that the orbit never escapes
``aperiodic_place``        a prime that shows that the zeros of `D` are not distinct roots of unity
``modulus_without_escape``  one small prime that shows it
``convergence_modulo``     a prime modulo which gamma vanishes from some step on
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

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from math import gcd, isqrt, lcm
from typing import Any, NamedTuple

from flint import acb, acb_poly, arb, fmpq, fmpq_poly, fmpz, fmpz_mat, fmpz_poly, nmod_mat, nmod_poly

from exactkf.exact.balls import precision
from exactkf.exact.numberfield import RealField, RealNumber
from exactkf.exact.rationals import to_fraction
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.orbit_n import states
from exactkf.kernel.orbit_sieve import exponent, intersected, step_matrix
from exactkf.kernel.orbit_wandering import common_order, modular, modular_step

__all__ = ["Readings", "aperiodic_place", "apparent_orders", "common_period", "convergence_modulo", "escape_seen", "escapes_before",
           "is_alone", "least", "modulus_without_escape", "no_escape_modulo", "place", "places_without_escape", "primes", "step_matrix_at", "unit",
           "zeros_at"]

_LARGE = 10**15
_SMALL, _PRIME_BOUND, _PRIME_BOUND_ALONE = 100, 30_000, 300
_FEW_STEPS, _SOME = 60, 5
_MOST_ZEROS, _MOST_LEFT, _MOST_STEPS, _SOON = 12, 10_000, 200_000, 10_000
_Taken = tuple[int, int | None, int, set[int]]


@cache
def _small_primes() -> tuple[int, ...]:
    return tuple(p for p in range(2, _PRIME_BOUND + 100) if fmpz(p).is_prime())


def primes(start: int = 2) -> Iterator[int]:
    """Yield the primes from `start` on."""
    p = start
    if p <= _SMALL:
        yield from (q for q in _small_primes() if q >= p)
        p = _small_primes()[-1] + 1
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
    integral : fmpz_poly or None
        A multiple of rational `D`.
    """

    q: Sequence[Any]
    g: Sequence[Any]
    D: Sequence[Any]
    field: RealField | None
    integral: fmpz_poly | None

    @classmethod
    def of(cls, Q: Sequence[Any], S: Sequence[Any], D: Sequence[Any]) -> Readings:
        """From the polynomials of a reduced pair."""
        field = next((x.field for x in Q if isinstance(x, RealNumber)), None)
        return cls(Q[-2::-1], S[-2::-1], D, field, fmpq_poly(list(D)).numer() if field is None else None)

    def roots(self, p: int) -> Sequence[int | None]:
        """The residues of the generator modulo `p`: simple zeros; one None for rational data."""
        if self.field is None:
            return [None]
        f = self.field.minpoly
        if f.denom() % p == 0:
            return []
        factors = nmod_poly([int(c.p) * pow(int(c.q), -1, p) % p for c in f.coeffs()], p).factor()[1]
        return sorted(int(-g[0] / g[1]) for g, k in factors if g.degree() == 1 and k == 1)

    def divisor(self, p: int, root: int | None) -> nmod_poly | None:
        """`D` modulo `p`, up to a factor; None if its degree falls or a denominator is no unit."""
        d = self.read(self.D, p, root) if self.integral is None else self.integral
        f = None if d is None else nmod_poly(d, p)
        return f if f is not None and f.degree() == len(self.D) - 1 else None

    def read(self, values: Sequence[Any], p: int, root: int | None, power: int = 1) -> list[int] | None:
        """The values modulo a power of `p`; None if a denominator is no unit."""
        N = p**power
        if power > 1 and self.field is not None and root is not None:
            f = self.field.minpoly
            slope = f.derivative()(fmpq(root))
            for _ in range(power - 1):
                value = f(fmpq(root))
                root = (root - int(value.p) * pow(int(value.q), -1, N) * pow(int(slope.p) * pow(int(slope.q), -1, p), -1, p)) % N
        out = []
        try:
            for x in values:
                total = 0
                for c in reversed(x.poly.coeffs()) if isinstance(x, RealNumber) else (x,):
                    total = (total * (root or 0) + int(c.numerator) * pow(int(c.denominator), -1, N)) % N
                out.append(total)
        except ValueError:
            return None
        return out


def place(p: int, root: int | None, *entries: int) -> list[Any]:
    """A place as evidence names it."""
    return [p, *entries] if root is None else [p, *entries, root]


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


def convergence_modulo(Q: Sequence[Fraction], S: Sequence[Fraction], D: fmpz_poly, steps: int = _FEW_STEPS) -> tuple[int, int] | None:
    """Return a prime and a step from which on S = 0 modulo the prime and no denominator has it, so that gamma = 0, or None.

    If the prime divides all coefficients of `D` but the middle one, no zero of `D` has the p-adic modulus one, and the orbit tends to a rest in
    the p-adic numbers as it does in the real ones if `D` is positive.
    """
    common = gcd(*(int(D[i] // D.content()) for i in range(D.degree() // 2)))
    wanted = [p for p in _small_primes() if common % p == 0][:_SOME]
    for t, (q, s) in zip(range(steps if wanted else 0), states(list(Q), list(S)), strict=False):
        for p in wanted:
            power = p ** exponent(int(q[-1]), p)
            if all(x % power == 0 for x in q) and all(x % (power * p) == 0 for x in s):
                return p, t
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


def places_without_escape(pair: Readings, before: Mapping[int, int]) -> list[list[Any]] | None:
    """Return places that together leave no time for an escape, or None.

    Parameters
    ----------
    pair : Readings
    before : mapping
        As `escapes_before` finds it.
    """
    taken: list[_Taken] = []
    period, left, steps = 1, [0], 0
    for p in primes(3 if before else 2):
        if p > _PRIME_BOUND or steps > _MOST_STEPS:
            return None
        for root in pair.roots(p):
            L = _short_order(pair, p, root)
            found = None if L is None else zeros_at(pair, p, root, L)
            if found is None or L is None:
                continue
            steps += L
            found -= {-k % L for k, r in before.items() if L > k and -k % L in found and is_alone(pair, k, r, p, root, L)}
            if len(found) > _MOST_ZEROS:
                continue
            one = (p, root, L, found)
            few = next((some for some in ([one], *([one, other] for other in taken)) if not _left(some)), None)
            period, left = intersected(period, left, L, found)
            taken.append(one)
            if few or not left:
                return [place(p, root, L) for p, root, L, _ in _needed(few or taken)]
            if len(left) > _MOST_LEFT or period > 1 << 60 and min(left) < _SOON:  # an escape, it seems
                return None
    return None


def _needed(taken: list[_Taken]) -> list[_Taken]:
    """Leave out, from the longest period down, what is not needed to leave no time."""
    for one in sorted(taken, key=lambda x: -x[2]):
        fewer = [x for x in taken if x is not one]
        if fewer and not _left(fewer):
            taken = fewer
    return taken


def _left(taken: list[_Taken]) -> bool:
    period, left = 1, [0]
    for _, _, L, found in sorted(taken, key=lambda x: len(x[3])):
        period, left = intersected(period, left, L, found)
        if not left:
            return False
        if len(left) > _MOST_LEFT:
            return True
    return bool(left)


def _short_order(pair: Readings, p: int, root: int | None) -> int | None:
    """The order of z modulo `D` at a place, if it divides p - 1 or p + 1, or is small."""
    f = pair.divisor(p, root)
    if f is None:
        return None
    z = nmod_poly([0, 1], p)
    power = z.pow_mod(p - 1, f)
    if power == 1:
        return least(z, f, p - 1)
    if power * z % f * z % f == 1:
        return least(z, f, p + 1)
    if p > _SMALL:
        return None
    exponent = lcm(*(p ** g.degree() - 1 for g, _ in f.factor()[1]))
    if z.pow_mod(exponent, f) != 1:  # a multiple zero
        exponent *= p
        if z.pow_mod(exponent, f) != 1:
            return None
    order = least(z, f, exponent)
    return order if order <= _MOST_ZEROS * p // 2 else None  # about one in p of the determinants vanishes


def least(z: nmod_poly, f: nmod_poly, order: int) -> int:
    """The order of z modulo `f`, which divides the given one."""
    for q, _ in fmpz(order).factor():
        while order % int(q) == 0 and z.pow_mod(order // int(q), f) == 1:
            order //= int(q)
    return order


def zeros_at(pair: Readings, p: int, root: int | None, L: int) -> set[int] | None:
    """The t below `L` with a singular X_t at a place, as `exactkf.kernel.orbit_sieve.zeros_modulo`, or None."""
    S = step_matrix_at(pair, p, root)
    if S is None or S**L != unit(S.nrows(), S.nrows(), p):
        return None
    m, size = S.nrows() // 2, isqrt(L) + 1
    tops, power = [], unit(m, 2 * m, p)
    for _ in range(size):
        tops.append(power)
        power = power * S
    found: set[int] = set()
    leap, columns = S**size, unit(2 * m, m, p)
    for start in range(0, L, size):
        found.update(start + i for i, top in enumerate(tops) if not (top * columns).det())
        columns = leap * columns
    return {t for t in found if t < L}


def step_matrix_at(pair: Readings, p: int, root: int | None, power: int = 1) -> nmod_mat | None:
    """S_m modulo a power of `p`, or None if a denominator is no unit."""
    values = pair.read([*pair.q, *pair.g], p, root, power)
    if values is None:
        return None
    m = len(values) // 2
    try:
        return nmod_mat(2 * m, 2 * m, [x for row in step_matrix(values[:m], values[m:], p**power) for x in row], p**power)
    except Undefined:
        return None


def unit(rows: int, columns: int, p: int) -> nmod_mat:
    """The first columns, or rows, of the identity."""
    return nmod_mat(rows, columns, [int(i == j) for i in range(rows) for j in range(columns)], p)


def is_alone(pair: Readings, k: int, r: int, p: int, root: int | None, L: int) -> bool:
    """Whether det X_{L - k} is not zero modulo p^{r + 1}; see `exactkf.kernel.orbit_sieve`, statement 3."""
    N = p ** (r + 1)
    S = step_matrix_at(pair, p, root, r + 1) if N < 1 << 63 else None
    if S is None:
        return False
    m, power = S.nrows() // 2, S ** (L - k)
    return int(fmpz_mat(m, m, [int(power[i, j]) for i in range(m) for j in range(m)]).det()) % N != 0


def escapes_before(pair: Readings, steps: int = 40) -> dict[int, int]:
    """Return the `k` up to `steps` for which the plane `k` steps before the start is singular modulo a large prime, with the dimension of the kernel."""
    S = _modulo_large_prime(pair)
    return {k: missing for k, missing in enumerate(_missing_ranks(S.inv(), steps), 1) if missing}


def escape_seen(pair: Readings, steps: int) -> int | None:
    """Return the first step up to `steps` at which a reduced pair seems to escape, as it does modulo a large prime."""
    return next((t - 1 for t, missing in enumerate(_missing_ranks(_modulo_large_prime(pair), steps + 2), 1) if missing), None)


def _modulo_large_prime(pair: Readings) -> nmod_mat:
    return next(S for p in primes(_LARGE) for root in pair.roots(p) if (S := step_matrix_at(pair, p, root)) is not None)


def _missing_ranks(S: nmod_mat, steps: int) -> Iterator[int]:
    """The dimension of the kernel of the upper block of S^k (I; 0), k = 1, 2, ..."""
    m, p = S.nrows() // 2, int(S.modulus())
    top, columns = unit(m, 2 * m, p), unit(2 * m, m, p)
    for _ in range(steps):
        columns = S * columns
        yield m - (top * columns).rank()


def no_escape_modulo(Q: Sequence[Fraction | int], S: Sequence[Fraction | int], steps: int, p: int) -> bool:
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


# ---------------------------------------------------------------------- no period
def aperiodic_place(pair: Readings) -> list[Any] | None:
    """Return a place that shows that the zeros of `D` are not distinct roots of unity, or None if they seem to be."""
    degree = 1 if pair.field is None else pair.field.degree
    N, tried = common_order((len(pair.D) - 1) * degree), 0
    for p in primes(10**9 + 7):
        for root in pair.roots(p)[:1]:
            f = pair.divisor(p, root)
            if f is None:
                continue
            if nmod_poly([0, 1], p).pow_mod(N, f) != 1:
                return place(p, root)
            tried += 1
            if tried == 2:
                return None
    return None


def common_period(D: Sequence[Any]) -> int | None:
    """Return the least common multiple of the orders of the zeros of rational `D`, if all are roots of unity."""
    N = 1
    for factor, _ in fmpq_poly(list(D)).numer().factor()[1]:
        order = int(factor.is_cyclotomic())  # zero if it is not
        if not order:
            return None
        N = lcm(N, order)
    return N


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
            turn = to_fraction((z.log().imag / (2 * arb.pi())).mid().fmpq()).limit_denominator(bound)
            difference = abs(acb(2 * arb(fmpq(turn.numerator, turn.denominator))).exp_pi_i() - z)
            if not difference < arb(2) ** -100:
                return None
            orders.append(turn.denominator)
    return orders
