# SPDX-License-Identifier: MIT
"""Integer polynomials in many variables with packed monomials.

A polynomial is a dict {monomial: coefficient} without zeros. A monomial is
one int, `BITS` bits for each exponent, so that a product of monomials is a
sum of ints. The top bit of each exponent is kept free in every factor of a
product (`mul` refuses others), so that no exponent runs into its neighbour.

Main definitions
----------------
`add`, `mul`
    Sums with integer weights, products.
`Divisor`
    A polynomial prepared for exact division by it.
"""

from __future__ import annotations

from functools import lru_cache, reduce
from operator import or_

from exactkf.kernel.numbers import Unknown

__all__ = ["BITS", "Divisor", "Poly", "add", "exponents", "mul"]

BITS = 12  # bits an exponent takes in a packed monomial
_MASK = (1 << BITS) - 1
_PRIME = (1 << 61) - 1

Poly = dict[int, int]  # packed exponents -> coefficient


@lru_cache(maxsize=256)
def _tops(places: int) -> int:
    """The top bit of every exponent."""
    return sum(1 << (BITS * i + BITS - 1) for i in range(places))


def _places(key: int) -> int:
    return -(-key.bit_length() // BITS)


def _crowded(*polys: Poly) -> bool:
    """Some exponent uses the top bit of its place."""
    used = 0
    for p in polys:
        used = reduce(or_, p, used)
    return bool(used & _tops(_places(used)))


def exponents(key: int) -> list[int]:
    """Exponents of a monomial, as far as the last that is not zero."""
    return [(key >> s) & _MASK for s in range(0, key.bit_length(), BITS)]


def mul(p: Poly, q: Poly) -> Poly:
    """Product.

    Raises
    ------
    Unknown
        If an exponent of a factor is 2048 or more.
    """
    if len(p) > len(q):
        p, q = q, p
    if _crowded(p, q):
        raise Unknown("degree too large for symbolic evaluation")
    if len(p) == 1:
        (i, x), = p.items()
        return {i + j: x * y for j, y in q.items()}
    out: Poly = {}
    get = out.get
    for i, x in p.items():
        for j, y in q.items():
            k = i + j
            out[k] = get(k, 0) + x * y
    return {k: v for k, v in out.items() if v} if 0 in out.values() else out


def add(p: Poly, q: Poly, a: int = 1, b: int = 1) -> Poly:
    """a p + b q, for a and b other than zero."""
    if len(p) < len(q):
        p, q, a, b = q, p, b, a
    out = dict(p) if a == 1 else {k: a * v for k, v in p.items()}
    get = out.get
    for k, v in q.items():
        s = get(k, 0) + b * v
        if s:
            out[k] = s
        else:
            del out[k]
    return out


def _by_exponent(p: Poly, place: int) -> dict[int, Poly]:
    """Coefficients with respect to one variable."""
    out: dict[int, Poly] = {}
    field = _MASK << place
    for k, v in p.items():
        e = k & field
        part = out.get(e)
        if part is None:
            out[e] = {k - e: v}
        else:
            part[k - e] = v
    return {e >> place: part for e, part in out.items()}


def _over_monomial(p: Poly, key: int, c: int) -> Poly | None:
    if key:
        top = _tops(_places(key))
        if any(((k | top) - key) & top != top for k in p):
            return None
    if c in (1, -1):
        return {k - key: c * v for k, v in p.items()}
    if any(v % c for v in p.values()):
        return None
    return {k - key: v // c for k, v in p.items()}


class Divisor:
    """A polynomial to divide by, seen as a polynomial in one variable."""

    __slots__ = ("degree", "first", "last", "lead", "lower", "place", "terms", "univariate")

    def __init__(self, terms: Poly) -> None:
        self.terms, self.first, self.last = terms, max(terms), min(terms)
        used = reduce(or_, terms, 0)
        places = [s for s in range(0, used.bit_length(), BITS) if (used >> s) & _MASK]
        self.place = min(places, default=0, key=lambda s: self._weight(s))
        self.univariate = len(places) < 2
        parts = _by_exponent(terms, self.place)
        self.degree = max(parts)
        lead = parts.pop(self.degree)
        self.lead: Divisor | tuple[int, int] = next(iter(lead.items())) if len(lead) == 1 else Divisor(lead)
        self.lower = sorted(parts.items())

    def _weight(self, place: int) -> tuple[int, int]:
        """Terms of the leading coefficient in one variable, and whether it has variables."""
        field = _MASK << place
        top = max(k & field for k in self.terms)
        lead = [k for k in self.terms if k & field == top]
        return len(lead), lead[0] != top

    def quotient(self, p: Poly) -> Poly | None:
        """p over this polynomial if that is a polynomial with integer coefficients, else None."""
        if not self.lower:
            return self._quotient_by_lead(p, self.degree << self.place)
        if not self._may_divide(p):
            return None
        rest, out = _by_exponent(p, self.place), Poly()
        for e in range(max(rest), self.degree - 1, -1):
            part = rest.pop(e, None)
            if part is not None and 0 in part.values():
                part = {k: v for k, v in part.items() if v}
            if not part:
                continue
            m = self._quotient_by_lead(part, 0)
            if m is None:
                return None
            for i, low in self.lower:
                target = rest.setdefault(e - self.degree + i, {})
                get = target.get
                for j, x in low.items():
                    for k, v in m.items():
                        target[k + j] = get(k + j, 0) - x * v
            shift = (e - self.degree) << self.place
            for k, v in m.items():
                out[k + shift] = v
        if any(v for part in rest.values() for v in part.values()) or _crowded(out):
            return None
        return out

    def _quotient_by_lead(self, p: Poly, power: int) -> Poly | None:
        """p over the leading coefficient times a power of the variable."""
        if isinstance(self.lead, Divisor):
            cut = _over_monomial(p, power, 1) if power else p
            return None if cut is None else self.lead.quotient(cut)
        key, c = self.lead
        return _over_monomial(p, key + power, c)

    def _may_divide(self, p: Poly) -> bool:
        """False only if this polynomial does not divide p.

        First by the first and last terms. Then, if it has one variable, by the terms of p that agree with its
        first (its last) term in all others; else in one variable, the others being given values modulo a prime.
        """
        first, last = max(p), min(p)
        if not (_fits(self.first, first) and _fits(self.last, last)):
            return False
        if not self.univariate:
            return _remainder_vanishes(_univariate(p, self.place), _univariate(self.terms, self.place))
        others = ~(_MASK << self.place)
        for rest in {first & others, last & others}:
            part = {k - rest: c for k, c in p.items() if k & others == rest}
            if not _remainder_vanishes(_univariate(part, self.place), _univariate(self.terms, self.place)):
                return False
        return True


def _fits(small: int, big: int) -> bool:
    """Divisibility of monomials."""
    top = _tops(_places(small))
    return ((big | top) - small) & top == top


@lru_cache(maxsize=1 << 18)
def _reduced_monomial(key: int, main: int) -> tuple[int, int]:
    """Exponent of the main variable, and the value of the rest modulo the prime at a fixed point."""
    exponent, value, place = (key >> main) & _MASK, 1, 3
    key &= ~(_MASK << main)
    while key:
        if key & _MASK:
            value = value * pow(1000003 * place + 97, key & _MASK, _PRIME) % _PRIME
        key >>= BITS
        place += 1
    return exponent, value


def _univariate(p: Poly, main: int) -> list[int]:
    """p modulo the prime, all variables but one being given values."""
    out: dict[int, int] = {}
    for key, c in p.items():
        e, value = _reduced_monomial(key, main)
        out[e] = out.get(e, 0) + c * value
    return [out.get(e, 0) % _PRIME for e in range(max(out, default=0) + 1)]


def _remainder_vanishes(a: list[int], b: list[int]) -> bool:
    """b divides a modulo the prime (also if b has no term left)."""
    while b and b[-1] == 0:
        b.pop()
    if len(b) < 2:
        return True
    inverse = pow(b[-1], -1, _PRIME)
    while len(a) >= len(b):
        f = a[-1] * inverse % _PRIME
        if f:
            for i in range(len(b)):
                a[len(a) - len(b) + i] = (a[len(a) - len(b) + i] - f * b[i]) % _PRIME
        a.pop()
    return not any(a)
