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
`content`
    The factors of a polynomial that have one variable.
"""

from __future__ import annotations

from functools import cache, reduce
from math import gcd
from operator import or_

from exactkf.kernel.numbers import Unknown

__all__ = ["BITS", "Divisor", "Poly", "add", "content", "exponents", "mul"]

BITS = 12  # bits an exponent takes in a packed monomial
_MASK = (1 << BITS) - 1
_PRIME, _ORDER = 1152921504606538021, 4007  # the order divides the prime less one, and 2^12 has a large order modulo it

Poly = dict[int, int]  # packed exponents -> coefficient


@cache
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
    if not p:
        return {}
    (first, lead), *rest = p.items()
    out = {first + j: lead * y for j, y in q.items()}
    get = out.get
    for i, x in rest:
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

    __slots__ = ("degree", "first", "image", "last", "lead", "lower", "place", "terms", "univariate")

    def __init__(self, terms: Poly) -> None:
        if _crowded(terms):
            raise Unknown("degree too large for symbolic evaluation")
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
        self.image = _image(terms, self.place)

    def _weight(self, place: int) -> tuple[int, int]:
        """Terms of the leading coefficient in one variable, and whether it has variables."""
        field = _MASK << place
        top = max(k & field for k in self.terms)
        lead = [k for k in self.terms if k & field == top]
        return len(lead), lead[0] != top

    def quotient(self, p: Poly, told: bool = False) -> Poly | None:
        """p over this polynomial if that is a polynomial with integer coefficients, else None; if `told` it is likely one."""
        if not self.lower:
            return self._quotient_by_lead(p, self.degree << self.place)
        if not told and not self._may_divide(p):
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
        first term in all others; then in one variable, the others being given values modulo a prime.
        """
        first = max(p)
        if not (_fits(self.first, first) and _fits(self.last, min(p))):
            return False
        if self.univariate:
            others = ~(_MASK << self.place)
            rest = first & others
            if not _remainder_vanishes(_image({k: c for k, c in p.items() if k & others == rest}, self.place), list(self.image)):
                return False
        return _remainder_vanishes(_image(p, self.place), list(self.image))


def _fits(small: int, big: int) -> bool:
    """Divisibility of monomials."""
    top = _tops(_places(small))
    return ((big | top) - small) & top == top


@cache
def _powers() -> list[int]:
    """Powers of an element of order `_ORDER` modulo the prime."""
    root = pow(3, (_PRIME - 1) // _ORDER, _PRIME)
    return [pow(root, k, _PRIME) for k in range(_ORDER)]


def _image(p: Poly, place: int) -> list[int]:
    """p modulo the prime in one variable, the others being powers of one root of unity; coefficients from x^0 up."""
    powers, field, out = _powers(), _MASK << place, dict[int, int]()
    get = out.get
    for k, c in p.items():
        e = k & field
        out[e] = get(e, 0) + c * powers[(k ^ e) % _ORDER]
    return [out.get(e << place, 0) % _PRIME for e in range((max(out) >> place) + 1)]


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


# ---------------------------------------------------------------------- factors in one variable
def content(p: Poly, place: int) -> list[Poly]:
    """Polynomials in one variable whose product is the greatest one that divides p; the roots 0, 1 and -1 are split off."""
    field = _MASK << place
    if not any(k & field for k in p):
        return []
    slices: dict[int, dict[int, int]] = {}
    for k, c in p.items():
        slices.setdefault(k & ~field, {})[(k & field) >> place] = c
    common: list[int] = []
    for part in sorted(slices.values(), key=len):
        common = _gcd(common, [part.get(e, 0) for e in range(max(part) + 1)])
        if len(common) == 1:
            return []
    found = []
    for root in (0, 1, -1):
        while len(common) > 2 and sum(c * root**k for k, c in enumerate(common)) == 0:
            found.append([-root, 1])
            common = _synthetic(common, root)
    return [{e << place: c for e, c in enumerate(u) if c} for u in [*found, common]]


def _synthetic(u: list[int], root: int) -> list[int]:
    """u / (x - root), coefficients from x^0 up."""
    out, carry = [0] * (len(u) - 1), 0
    for k in range(len(u) - 1, 0, -1):
        out[k - 1] = carry = u[k] + root * carry
    return out


def _gcd(a: list[int], b: list[int]) -> list[int]:
    """Greatest common divisor, primitive, by pseudo-remainders."""
    while b:
        b = [c // gcd(*b) for c in b]
        while len(a) >= len(b):
            lead, top = a[-1], b[-1]
            a = [top * c for c in a]
            for i in range(len(b)):
                a[len(a) - len(b) + i] -= lead * b[i]
            while a and a[-1] == 0:
                a.pop()
        a, b = b, a
    return a
