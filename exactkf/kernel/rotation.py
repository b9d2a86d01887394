# SPDX-License-Identifier: MIT
r"""Zeros and period of y_{t+1} = x y_t - y_{t-1}, decided for every t.

Let x and a be real numbers of a field K, a not 0, and y_0 = a, y_1 = 1. Let v + 1/v = x, and v not 1 or -1. The
sequences S_n = (v^{n+1} - v^{-n-1})/(v - 1/v) and C_n = v^n + v^{-n} obey the same recursion; S_0 = 1,
S_{-1} = 0, so that y_t = S_{t-1} - a S_{t-2}.

Main definitions
----------------
`order`        the order of v as a root of unity, or None
`first_zero`   the first t from 2 to a bound with y_t = 0, or None
`zero_bound`   y_t is not 0 for any t beyond it, unless v is a root of unity
`least_height` a height that is not zero, from below, for all numbers of bounded degree
`sign_at`      the sign of y_t for t of any size, if y_t is not 0

Main statements
---------------
1. *Not zero.* An element of Q[X]/(m) whose numerators and denominators can be read modulo a prime q
   that divides neither a denominator nor the leading coefficient of m, and which is a unit modulo q, does
   not vanish at any root of m: a common root makes the resultant zero, over Q and so modulo q. What is
   no unit modulo q is evaluated exactly.
2. *Order.* v has degree at most 2d over Q, d the degree of m. If its order is P then the degree is
   phi(P), and phi(P)^2 >= P/2. So P is in a finite list, and v^P = 1 exactly if C_P = 2.
3. *Bound.* Let h be the absolute logarithmic height, to base 2. If y_t = 0 and v is no root of unity
   then v^{2t-1} (v - a) = 1 - a v, with v different from a, and the height of the quotient
   (1 - a v)/(v - a) is at most 1 + h(a) + h(v). Hence 2 (t - 1) h(v) <= h(a) + 1.
4. *Height from below, K = Q.* v is a root of q z^2 - p z + q with x = p/q in lowest terms. If |x| < 2 then
   2 h(v) = log q, and q >= 2, as the integers -1, 0, 1 make v a root of unity. If |x| > 2 then 2 h(v) = log(q |v|)
   with |v| > 1, and more than 1 if q = 1, as then |x| >= 3. In both cases 2 h(v) >= max(1, floor(log q)).
5. *Height from below, x not integral.* Let x = z/n with z in Z[theta], and let a prime l divide n, exactly k times. If z is a unit modulo l
   (as in 1) then at every place over l both x and the larger of |v|, |1/v| are |n|^{-1}, and 2 h(v) = h(v) + h(1/v) >= k log l. For several
   such primes these numbers add up.
6. *Height from below, in general.* Let v, not 0, have degree D at most and not be a root of unity. If v is no algebraic
   integer its Mahler measure M is at least 2 and h(v) >= 1/D. Else let f be the minimal polynomial, v_1..v_D its
   roots, p >= 4D a prime such that the v_i^p are distinct. Then f(v_i^p) = f(v_i)^p + p g(v_i) = p g(v_i), so
   that the product of the v_i^p - v_j is a multiple of p^D, and it is not 0, as otherwise v would be a root of unity.
   The Vandermonde determinant of v_1..v_D, v_1^p..v_D^p has as its square the product of two
   discriminants, integers different from 0, and of the square of that product; so it is at least p^D. By
   Hadamard's inequality it is at most (2D)^D M^{(2D-1)(p+1)}. Hence log M >= D log(p/2D)/((2D-1)(p+1)) and
   h(v) >= 1/((2D-1)(p+1)).
   At most log D primes fail to keep the v_i^p distinct: if p_1..p_r do, there is a conjugation with v -> w v, w of order
   p_k; it fixes v^{p_1..p_k} but not v^{p_1..p_{k-1}}, so each power generates a smaller field than the one
   before, and 2^r <= D. One of any floor(log D) + 1 primes from 4D on serves, and the largest gives the bound.
7. *Height from above.* If N a = sum n_i theta^i then h(a) <= log max(sum |n_i|, |N|) + deg h(theta), and h(theta) is at
   most the logarithm of the Euclidean norm of an integer polynomial that vanishes at theta (Landau).

References
----------
Kronecker (1857); Landau (1905); E. Dobrowolski, Acta Arith. 34 (1979), for the primes in 6;
M. Waldschmidt, Diophantine Approximation on Linear Algebraic Groups (2000), chapter 3.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from math import gcd, isqrt, lcm
from operator import mul
from typing import Any

from exactkf.kernel.algebraic import Algebraic, AlgebraicField
from exactkf.kernel.limits import WORK, within
from exactkf.kernel.numbers import Undefined

__all__ = ["coefficients", "first_zero", "height", "least_height", "modulus", "order", "sign_at", "value", "zero_bound"]

_MERSENNE = (61, 89, 107, 127, 521, 607)  # 2^k - 1 is prime
_SMALL = [q for q in range(2, 1000) if all(q % k for k in range(2, isqrt(q) + 1))]
_RATIONAL_ORDERS = (1, 2, 3, 4, 6)  # phi(P) <= 2


def _pair(x: Any, n: int, one: Any, check: Callable[[Any], None] | None = None) -> tuple[Any, Any]:
    """S_n and S_{n-1} by doubling: S_{2n} = S_n^2 - S_{n-1}^2, S_{2n-1} = S_{n-1} (2 S_n - x S_{n-1})."""
    s, before = one, one - one
    for bit in bin(n)[2:]:
        s, before = s * s - before * before, before * (s + s - x * before)
        if bit == "1":
            s, before = x * s - before, s
        if check:
            check(s)
    return s, before


def value(x: Any, a: Any, t: int) -> Any:
    """y_t, exact, t >= 1."""
    s, before = _pair(x, t - 1, x - x + 1)
    return s - a * before


# ---------------------------------------------------------------------- modulo a prime
def coefficients(x: Any) -> list[Fraction]:
    """From theta^0 up."""
    return x.field.element(x.c).c if isinstance(x, Algebraic) else [Fraction(x)]


def modulus(field: AlgebraicField | None) -> list[Fraction]:
    """The polynomial of the field; that of theta = 0 for the rational numbers."""
    return field.modulus if field else [Fraction(0), Fraction(1)]


class _Residues:
    """The ring of polynomials over Z/q modulo a monic one; elements are lists of its degree."""

    def __init__(self, modulus: list[Fraction], q: int) -> None:
        self.q = q
        self.tail = self.read([c / modulus[-1] for c in modulus[:-1]], len(modulus) - 1)
        self.d = len(modulus) - 1
        self.width = (2 * q.bit_length() + (2 * self.d).bit_length() + 7) // 8  # bytes for a sum of 2d products
        self.powers, row = list[int](), [-c % q for c in self.tail]  # theta^d, theta^(d + 1), ..., packed
        for _ in range(self.d - 1):
            self.powers.append(self._packed(row))
            row = [(a - row[-1] * c) % q for a, c in zip([0, *row[:-1]], self.tail, strict=True)]

    def read(self, coefficients: list[Fraction], d: int) -> list[int]:
        """Undefined if q divides a denominator."""
        if any(c.denominator % self.q == 0 for c in coefficients):
            raise Undefined("a denominator vanishes modulo the prime")
        out = [c.numerator * pow(c.denominator, -1, self.q) % self.q for c in coefficients]
        return out + [0] * (d - len(out))

    def multiply(self, u: list[int], v: list[int]) -> list[int]:
        if self.d == 1:
            return [u[0] * v[0] % self.q]
        whole, bits = self._packed(u) * self._packed(v), 8 * self.width * self.d
        high = self._unpacked(whole >> bits, self.d - 1)
        return self._unpacked((whole & (1 << bits) - 1) + sum(map(mul, high, self.powers)), self.d)

    def _packed(self, u: list[int]) -> int:
        """One integer, `width` bytes for each: a product of such integers holds the coefficients of the product."""
        return int.from_bytes(b"".join(a.to_bytes(self.width, "little") for a in u), "little")

    def _unpacked(self, n: int, count: int) -> list[int]:
        data, w = n.to_bytes(count * self.width, "little"), self.width
        return [int.from_bytes(data[k:k + w], "little") % self.q for k in range(0, count * w, w)]

    def subtract(self, u: list[int], v: list[int]) -> list[int]:
        return [(a - b) % self.q for a, b in zip(u, v, strict=True)]

    def is_unit(self, u: list[int]) -> bool:
        """Euclid's algorithm with the modulus ends in a constant."""
        q, a, b = self.q, [*self.tail, 1], list(u)
        while b and b[-1] == 0:
            b.pop()
        while len(b) > 1:
            inverse = pow(b[-1], -1, q)
            while len(a) >= len(b):
                f = a[-1] * inverse % q
                for i in range(len(b)):
                    a[len(a) - len(b) + i] = (a[len(a) - len(b) + i] - f * b[i]) % q
                while a and a[-1] == 0:
                    a.pop()
            a, b = b, a
        return bool(b)


def _terms(ring: _Residues, x: Any, start: tuple[Any, Any], shift: Any, wanted: list[int]) -> Iterator[tuple[int, list[int]]]:
    """Residues of the sequence less ``shift`` at the wanted indices, in order; ``start`` holds the values at 0 and 1."""
    x, before, now, off = (ring.read(coefficients(v), ring.d) for v in (x, *start, shift))
    n = 1
    for k in wanted:
        while n < k:
            before, now, n = now, ring.subtract(ring.multiply(x, now), before), n + 1
        yield k, ring.subtract(now, off)


def _first(x: Any, start: tuple[Any, Any], shift: Any, wanted: list[int], field: AlgebraicField | None, exact: Callable[[int], bool]) -> int | None:
    """The first wanted index, in increasing order, at which the sequence equals ``shift``."""
    for k in _MERSENNE:
        try:
            ring = _Residues(modulus(field), (1 << k) - 1)
            product = ring.read([Fraction(1)], ring.d)
            for _, term in _terms(ring, x, start, shift, wanted):
                product = ring.multiply(product, term)
        except Undefined:
            continue
        if ring.is_unit(product):
            return None
        return next((n for n, term in _terms(ring, x, start, shift, wanted) if not ring.is_unit(term) and exact(n)), None)
    raise Undefined("every prime of the checker divides a denominator of the data")


def first_zero(x: Any, a: Any, stop: int, field: AlgebraicField | None) -> int | None:
    """The first t with 2 <= t <= stop and y_t = 0."""
    within(stop * (len(modulus(field)) - 1), WORK // 4, "terms of the sequence, times the degree")
    return _first(x, (a, Fraction(1)), Fraction(0), list(range(2, stop + 1)), field, lambda t: value(x, a, t) == 0)


def order(x: Any, field: AlgebraicField | None) -> int | None:
    """The order of v, v + 1/v = x, as a root of unity."""
    d = len(modulus(field)) - 1
    wanted = list(_RATIONAL_ORDERS) if d == 1 else _orders(2 * d)
    return _first(x, (Fraction(2), x), Fraction(2), wanted, field, lambda n: _chebyshev(x, n) == 2)


def _chebyshev(x: Any, n: int) -> Any:
    """C_n = 2 S_n - x S_{n-1}."""
    s, before = _pair(x, n, x - x + 1)
    return s + s - x * before


def _orders(bound: int) -> list[int]:
    """Every P with phi(P) <= bound."""
    top = 2 * bound * bound
    phi = list(range(top + 1))
    for p in range(2, top + 1):
        if phi[p] == p:
            for k in range(p, top + 1, p):
                phi[k] -= phi[k] // p
    return [n for n in range(1, top + 1) if phi[n] <= bound]


# ---------------------------------------------------------------------- heights
def height(a: list[Fraction], modulus: list[Fraction]) -> int:
    """An integer not below the height to base 2 of the number with these coefficients (statement 7)."""
    n = lcm(*(x.denominator for x in a))
    bits = max(sum(abs(x.numerator) * (n // x.denominator) for x in a), n).bit_length()
    if len(a) > 1:
        k = lcm(*(x.denominator for x in modulus))
        norm = sum((x.numerator * (k // x.denominator)) ** 2 for x in modulus)
        bits += (len(a) - 1) * ((norm.bit_length() + 1) // 2)
    return bits


def zero_bound(x: list[Fraction], a: list[Fraction], modulus: list[Fraction]) -> int:
    """A number B such that y_t = 0 for no t > B, unless v is a root of unity (statements 3 to 7).

    Numbers and modulus are lists of coefficients from theta^0 up.
    """
    top = height(a, modulus) + 1
    if len(modulus) == 2:
        q = x[0].denominator if x else 1
        return 1 + -(-top // max(1, q.bit_length() - 1))
    part = _unit_denominator(x, modulus)
    if part > 1:
        return 1 + -(-top // (part.bit_length() - 1))
    return 1 + -(-top * least_height(2 * (len(modulus) - 1)) // 2)


def least_height(degree: int) -> int:
    """An N such that numbers of at most this degree, neither 0 nor roots of unity, have a height to base 2 of at least 1/N (statement 6)."""
    within(degree, WORK, "the degree of a number")
    p = 4 * degree - 1
    for _ in range(degree.bit_length()):  # floor(log D) + 1 primes
        p += 1
        while any(p % k == 0 for k in range(2, isqrt(p) + 1)):
            p += 1
    return (2 * degree - 1) * (p + 1)


def _unit_denominator(x: list[Fraction], modulus: list[Fraction]) -> int:
    """The product of the prime powers of statement 5 for primes below 1000."""
    n, part = lcm(*(c.denominator for c in x)), 1
    z = [c * n for c in x]
    for prime in _SMALL:
        power = gcd(n, prime ** n.bit_length())
        if power > 1:
            try:
                ring = _Residues(modulus, prime)
            except Undefined:
                continue
            if ring.is_unit(ring.read(z, ring.d)):
                part *= power
    return part


# ---------------------------------------------------------------------- signs far out
class _Interval:
    """Numbers between lo and hi over 2^bits; products are rounded outwards."""

    __slots__ = ("bits", "hi", "lo")

    def __init__(self, lo: int, hi: int, bits: int) -> None:
        self.lo, self.hi, self.bits = lo, hi, bits

    def __add__(self, other: _Interval) -> _Interval:
        return _Interval(self.lo + other.lo, self.hi + other.hi, self.bits)

    def __sub__(self, other: _Interval) -> _Interval:
        return _Interval(self.lo - other.hi, self.hi - other.lo, self.bits)

    def __mul__(self, other: _Interval) -> _Interval:
        products = (self.lo * other.lo, self.lo * other.hi, self.hi * other.lo, self.hi * other.hi)
        return _Interval(min(products) >> self.bits, -(-max(products) >> self.bits), self.bits)


class _Wide(Exception):
    """The intervals got too wide at this precision."""


def _enclosed(x: Any, bits: int) -> _Interval:
    """An interval around an exact number, about as narrow as the precision allows."""
    if isinstance(x, Algebraic):
        low, high = x.enclosed(Fraction(1, 1 << bits))
    else:
        low = high = Fraction(x)
    return _Interval((low.numerator << bits) // low.denominator, -((-high.numerator << bits) // high.denominator), bits)


def sign_at(x: Any, a: Any, t: int, field: AlgebraicField | None) -> int:
    """The sign of y_t, which must not be 0, for |x| > 2 and a t at or before the last change of signs.

    Until then v^(2t) is at most |(1 - a v)/(1 - a/v)|, a number of bounded height, so that an S_n
    beyond the bound shows that t is too large.
    """
    m = modulus(field)
    largest = t.bit_length() + 2 + 2 * (len(m) - 1) * (height(coefficients(a), m) + 2 * height(coefficients(x), m) + 4)
    bits = 64
    while True:
        limit = 1 << (bits + largest)

        def check(s: _Interval, limit: int = limit) -> None:
            if min(abs(s.lo), abs(s.hi)) > limit and (s.lo > 0) == (s.hi > 0):
                raise Undefined("the time of the jump is too late")
            if max(abs(s.lo), abs(s.hi)) > 2 * limit:
                raise _Wide

        try:
            one = _Interval(1 << bits, 1 << bits, bits)
            s, before = _pair(_enclosed(x, bits), t - 1, one, check)
            y = s - _enclosed(a, bits) * before
            if y.lo > 0 or y.hi < 0:
                return 1 if y.lo > 0 else -1
        except _Wide:
            pass
        bits *= 2
