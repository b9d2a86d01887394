# SPDX-License-Identifier: MIT
r"""Multiplicative relations among algebraic numbers on the unit circle, checked.

The numbers l = e^{2 pi i theta}, 0 < theta < 1/2, are zeros of a polynomial f with integer
coefficients and zeros in pairs l, 1/l, given by isolating intervals of x = l + 1/l.

Main statements
---------------
Let h be the absolute logarithmic height; h(l) <= log |f|_2 by Landau's inequality, and half of
that, because l is not real.  The field of s of the numbers has degree at most
delta = 2K (2K - 2) ... (2K - 2s + 2), where 2K is the degree of f.

1. *A relation holds* (Liouville).  Let u = prod l_i^{e_i}.  If u is not 1 then |u - 1| >= exp(-delta h(u - 1)), and
   h(u - 1) <= sum |e_i| h(l_i) + log 2.  So a product that comes closer to one than that is one.
2. *No relation holds.*  Suppose prod l_i^{e_i} is a root of unity, e not zero, |e_k| the largest.  The
   function N(e) = h(prod l_i^{e_i}) satisfies the triangle inequality and N(qe) = |q|N(e), so it extends to rational exponents.  For an
   integer R > 1 Dirichlet's theorem gives integers n, 1 <= n_k <= R^{s-1}, with |n_i - n_k e_i/e_k| <= 1/R.  As
   N(e) = 0, N(n) = N(n - (n_k/e_k) e) <= (1/R) sum h(l_i).  Numbers of degree at most delta that are neither 0 nor roots of
   unity have a height of at least 1/M, M as in `exactkf.kernel.rotation.least_height`, which proves it, so
   for R above M sum h(l_i), prod l_i^{n_i} is a root of unity; its order is at most 2 delta^2, and |n_i| <= R^{s-1}.  Hence
   integers x, not all zero, of size at most B = 2 delta^2 R^{s-1} make sum x_i theta_i an integer -m.  With
   a_i = floor(2^b theta_i), the vector (x, sum x_i a_i + 2^b m) of the lattice of the rows
   (unit vector, a_i) and (0, 2^b) has a square length of at most s(s + 1) B^2.  A basis of the lattice
   whose Gram-Schmidt vectors are all longer shows that there is none.

Voutier (Acta Arith. 74, 1996) has larger heights than 1/M, and so fewer bits of the angles would do; M needs no citation.

References: E. Landau, Bull. SMF 33 (1905); J. H. Loxton, A. J. van der Poorten, Acta Arith. 42 (1983);
A. K. Lenstra, H. W. Lenstra, L. Lovász, Math. Ann. 261 (1982).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import isqrt, lcm
from operator import mul
from typing import Any, NamedTuple

from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.intervals import generator
from exactkf.kernel.limits import within
from exactkf.kernel.numbers import Undefined, fraction, need
from exactkf.kernel.roots import chebyshev
from exactkf.kernel.rotation import least_height

__all__ = ["CircleNumbers", "angle", "bound_of_relations", "check_independent", "is_relation"]

_MOST_BITS = 1 << 17


class CircleNumbers(NamedTuple):
    """Numbers on the upper half circle: f as integers, f in x = z + 1/z, and one isolating interval of x for each."""

    f: list[int]
    in_x: list[int]
    zeros: list[tuple[Fraction, Fraction]]

    @classmethod
    def of(cls, f: Sequence[Fraction], zeros: Any) -> CircleNumbers:
        """From a polynomial with zeros in pairs and intervals as pairs of strings, in increasing order and without overlap."""
        common = lcm(*(Fraction(c).denominator for c in f))
        integral = [int(c * common) for c in f]
        need(len(f) % 2 == 1 and integral == integral[::-1], "the zeros do not come in pairs")
        in_x = [int(c) for c in chebyshev(integral)]
        read = [(fraction(lo), fraction(hi)) for lo, hi in zeros]
        for lo, hi in read:
            need(-2 <= lo < hi <= 2, "an interval is not between -2 and 2")
            AlgebraicField([Fraction(c) for c in in_x], lo, hi)  # refused unless there is exactly one zero in it
        need(all(x[1] <= y[0] for x, y in zip(read, read[1:], strict=False)), "two intervals overlap")
        return cls(integral, in_x, read)

    def log_norm(self) -> int:
        """An integer not less than the logarithm to the base 2 of |f|_2."""
        return isqrt(sum(c * c for c in self.f)).bit_length()

    def degree(self, count: int) -> int:
        """A bound for the degree of the field of so many of the numbers."""
        out, k = 1, len(self.f) - 1
        for i in range(count):
            out *= max(k - 2 * i, 1)
        return out


class _Point(NamedTuple):
    """A complex number (c + is) / 2^w of modulus one, to an error of at most e / 2^w."""

    c: int
    s: int
    e: int

    def times(self, other: _Point, w: int) -> _Point:
        c, s = self.c * other.c - self.s * other.s, self.c * other.s + self.s * other.c
        return _Point(c >> w, s >> w, self.e + other.e + (self.e * other.e >> w) + 3)

    def power(self, k: int, w: int) -> _Point:
        base, out = (self if k > 0 else self._replace(s=-self.s)), _Point(1 << w, 0, 0)
        for bit in bin(abs(k))[2:]:
            out = out.times(out, w)
            if bit == "1":
                out = out.times(base, w)
        return out


def _point(numbers: CircleNumbers, i: int, w: int) -> _Point:
    low, high = _root(numbers, i, w)
    near, far = sorted((abs(low), abs(high)))
    near = 0 if low < 0 < high else near
    four = 4 << 2 * w
    s_low, s_high = isqrt(max(0, four - far * far)), isqrt(four - near * near) + 1  # twice the imaginary part
    return _Point((low + high) >> 2, (s_low + s_high) >> 2, high - low + s_high - s_low + 2)


def _root(numbers: CircleNumbers, i: int, w: int) -> tuple[int, int]:
    """Integers below and above 2^w x: Newton's method from a bisection, whose result is tested by signs."""
    p, (lo, hi), start = numbers.in_x, numbers.zeros[i], min(w, 128)
    field = AlgebraicField([Fraction(c) for c in p], lo, hi)
    low, high = generator(field, start)
    if w > start and low < high:
        x, at = (low + high) // 2, start
        while at < w:
            following = min(w, 2 * at - 16)
            x, at = x << following - at, following
            slope = _scaled([k * c for k, c in enumerate(p)][1:], x, at)
            x -= (_scaled(p, x, at) << at) // slope if slope else 0
        below, above = x - 16, x + 16
        inside = low << w - start <= below and above <= high << w - start
        if inside and (_scaled(p, below, w) > 0) != (_scaled(p, above, w) > 0) and _scaled(p, below, w) and _scaled(p, above, w):
            return below, above
        return generator(field, w)
    return low << w - start, high << w - start


def _scaled(p: list[int], x: int, w: int) -> int:
    """p(x / 2^w) 2^(wd), d the degree, divided by 2^(w(d-1)): its sign is exact where it is not zero."""
    total = p[-1]
    for k, c in enumerate(reversed(p[:-1]), 1):
        total = total * x + (c << w * k)
    return total >> w * (len(p) - 2) if len(p) > 1 else total << w


def angle(numbers: CircleNumbers, i: int, bits: int) -> int:
    """floor(2^bits theta): the binary digits of theta are the signs of the imaginary parts of l, l^2, l^4, ..."""
    w = bits + 64
    while w < 2 * _MOST_BITS:
        z, total = _point(numbers, i, w), 0
        for _ in range(bits):
            if abs(z.s) <= z.e:
                break
            total = 2 * total + (z.s < 0)
            z = z.times(z, w)
        else:
            return total
        w *= 2
    raise Undefined("the angle of a zero could not be told from a fraction")


def is_relation(numbers: CircleNumbers, chosen: Sequence[int], exponents: Sequence[int]) -> bool:
    """Whether prod l_i^{e_i} = 1; see statement 1."""
    size, s = sum(map(abs, exponents)), len(chosen)
    close = numbers.degree(s) * (size * numbers.log_norm() + 2) // 2 + 1
    within(close, _MOST_BITS, "bits of a relation")
    w = close + size.bit_length() + 64
    product = _Point(1 << w, 0, 0)
    for i, e in zip(chosen, exponents, strict=True):
        product = product.times(_point(numbers, i, w).power(e, w), w)
    return abs(product.c - (1 << w)) + abs(product.s) + product.e < 1 << w - close


def bound_of_relations(numbers: CircleNumbers, s: int) -> int:
    """B of statement 2."""
    delta = numbers.degree(s)
    R = s * numbers.log_norm() * least_height(delta) // 2 + 1
    return 2 * delta * delta * R ** (s - 1)


def check_independent(numbers: CircleNumbers, chosen: Sequence[int], bits: Any, basis: Any) -> None:
    """Accept if no product of powers of the chosen numbers is a root of unity; see statement 2."""
    s = len(chosen)
    need(type(bits) is int and bits > 0, "the number of bits is not a positive integer")
    within(bits, _MOST_BITS >> 2, "bits of an angle")
    rows = [[_integer(x) for x in row] for row in basis]
    need(len(rows) == s + 1 and all(len(row) == s + 1 for row in rows), "the basis is not square")
    angles = [angle(numbers, i, bits) for i in chosen]
    need(all((row[-1] - sum(map(mul, row, angles))) % (1 << bits) == 0 for row in rows), "a vector is not in the lattice")
    shortest, volume = _gram_schmidt(rows)
    need(volume == 1 << 2 * bits, "the vectors are no basis of the lattice")
    need(shortest > s * (s + 1) * bound_of_relations(numbers, s) ** 2, "the lattice may have a short vector")


def _gram_schmidt(rows: list[list[int]]) -> tuple[Fraction, Fraction]:
    """The least square length of the orthogonalized vectors, and the product of all."""
    found: list[tuple[list[Fraction], Fraction]] = []
    least, volume = None, Fraction(1)
    for row in rows:
        v = [Fraction(x) for x in row]
        for u, size in found:
            c = sum(map(mul, row, u)) / size
            v = [x - c * y for x, y in zip(v, u, strict=True)]
        size = sum((x * x for x in v), Fraction(0))
        need(size > 0, "the vectors are dependent")
        found.append((v, size))
        least, volume = size if least is None else min(least, size), volume * size
    return least or Fraction(0), volume


def _integer(x: Any) -> int:
    need(type(x) is int, "an entry is not an integer")
    return x
