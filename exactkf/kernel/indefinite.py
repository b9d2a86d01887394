# SPDX-License-Identifier: MIT
"""Sums and products with generic ends, by indefinite ones.

For a summand f(j) let F be any sequence with F(j) = F(j - 1) + f(j): then f(lo) + .. + f(hi) is F(hi) - F(lo - 1),
for hi = lo - 1 too. For a factor f(j) let P be any sequence with P(j) = P(j - 1) f(j) and no zero: then
f(lo) ... f(hi) is P(hi)/P(lo - 1). Such a P exists where no factor between the ends is zero: f outside of them
is of no account and may be taken as one. The division records P among the denominators, which are shown not to be zero
for all values of the variables (`exactkf.kernel.defined`): what is shown where no factor vanishes then holds everywhere.

A body is a polynomial in atoms, and what F and P are named by: the index is replaced by ``#``, shifted or reflected so
that some place of an atom is ``#`` itself; the end is kept without its constant, and the terms from there are written out.
An indefinite sum or product is an atom again, and its end an index as any other, so that it may stand in the body of
another sum.

Main definitions
----------------
`Indefinite`
    What `exactkf.kernel.generic.Terms` does with sums and products.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from exactkf.kernel.generic_reading import Reading
from exactkf.kernel.numbers import Unknown
from exactkf.kernel.packed import exponents
from exactkf.kernel.region import Form, Split, form_key, plus
from exactkf.kernel.symbolic import Symbolic

__all__ = ["BOUND", "Indefinite"]

_LONGEST = 1000  # terms that are written out
BOUND = ("sum", "prod")  # atoms (kind, body, end), in whose body '#' is bound


class Indefinite(Reading):
    """Sums and products in a region; the rest of the reading of terms is elsewhere."""

    def total(self, low: Form, high: Form, summand: Callable[[Any, Form], Symbolic]) -> Symbolic:
        """Sum of the summand from low to high, cut where its form changes."""
        return self._range(low, high, summand, False)

    def product(self, low: Form, high: Form, factor: Callable[[Any, Form], Symbolic]) -> Symbolic:
        """Product of the factor from low to high, cut where its form changes."""
        return self._range(low, high, factor, True)

    def _range(self, low: Form, high: Form, body: Callable[[Any, Form], Symbolic], times: bool) -> Symbolic:
        length = self.region.reduce(plus(high, low, -1))
        if not self.region.holds(plus(length, {"": 1})) or self.region.decide(length) is False:
            return self.number(int(times))
        if self.region.decide(plus({}, length, -1)) is True:  # one term, or none
            if not self.region.holds(length):
                return self.number(int(times))
            length = {}
        if set(length) <= {""}:
            out = self.number(int(times))
            for k in range(_written_out(length.get("", 0)) + 1):
                x = body(self, self.region.reduce(plus(low, {"": k})))
                out = out * x if times else out + x
            return out
        name = f"#{self.nested}"  # sums within this one have other names
        empty = int(self.region.decide(length) is not True)  # then what stands in the body need not have a value
        self.nested += 1
        self.perhaps += empty
        j = {name: 1}
        outer = self.region
        self.region = outer.and_(plus(j, low, -1), plus(high, j, -1))
        try:
            generic = body(self, j)
        except Split as split:
            self.region = outer
            c = split.form.get(name, 0)
            if not c:
                raise
            if abs(c) != 1:
                raise Unknown("a sum is to be cut at a fraction") from None
            # form >= 0 for j >= cut (c = 1) or j <= cut (c = -1); above and below go separately
            rest = {n: -c * x for n, x in split.form.items() if n != name}
            cut = plus(rest, {"": 1}, -1) if c == 1 else rest  # last index of the lower part
            if not outer.holds(plus(plus(cut, low, -1), {"": 1})) or not outer.holds(plus(high, cut, -1)):
                raise Unknown("a sum is cut outside its range") from None
            below, above = self._range(low, cut, body, times), self._range(plus(cut, {"": 1}), high, body, times)
            return below * above if times else below + above
        finally:
            self.region = outer
            self.nested -= 1
            self.perhaps -= empty
        if self.within and any(generic.num):  # only what it is made of is looked at
            return self.atom(("sum", (), ((name, 1),)))
        return self._quotient(generic, name, low, high) if times else self._indefinite(generic, name, low, high)

    def _indefinite(self, body: Symbolic, name: str, low: Form, high: Form) -> Symbolic:
        """F(high) - F(low - 1) for every monomial of the body in the index of the sum."""
        if any(self._moves(k, name) for index, _ in body.den for e in self.field.factors[index] for k, _ in self._atoms_of(e)):
            raise Unknown("a sum of quotients")
        out = self.number(0)
        below = Symbolic(self.field, {0: 1}, body.q, body.den)
        for monomial, c in list(body.num.items()):
            moving, factor = [], below * c
            for key, e in self._atoms_of(monomial):
                if self._moves(key, name):
                    moving.append((key, e))
                else:
                    for _ in range(e):
                        factor = factor * self.atom(key)
            out = out + factor * self._difference(moving, name, low, high)
        return out

    def _atoms_of(self, monomial: int) -> list[tuple[tuple, int]]:
        return [(self.atoms[k], e) for k, e in enumerate(exponents(monomial)) if e]

    @staticmethod
    def _moves(key: Any, name: str) -> bool:
        return key == name or isinstance(key, tuple) and any(Indefinite._moves(x, name) for x in key)

    def _difference(self, moving: list, name: str, low: Form, high: Form) -> Symbolic:
        if not moving:  # as many times one as there are terms
            return self.linear(self.region.reduce(plus(plus(high, low, -1), {"": 1})))
        ((made, _),), low, high = self._renamed([(tuple(moving), 1)], name, low, high)
        factor, made = self._without_powers(made)
        return factor * (self._sum_to(made, high) - self._sum_to(made, plus(low, {"": 1}, -1)))

    def _without_powers(self, monomial: tuple) -> tuple[Symbolic, tuple]:
        """Powers of z outside of a sum: of z^(c # + e) stays z^(c #)."""
        factor, left = self.number(1), dict[tuple, int]()
        for key, e in monomial:
            if key[0] == "power":
                c = dict(key[2]).get("#", 0)
                for _ in range(e):
                    factor = factor * self.power_of_z({n: x for n, x in key[2] if n != "#"})
                key = (*key[:2], (("#", c),))
            left[key] = left.get(key, 0) + e
        return factor, tuple(sorted(left.items()))

    def _quotient(self, body: Symbolic, name: str, low: Form, high: Form) -> Symbolic:
        """P(high)/P(low - 1) for a polynomial in the index of the product."""
        if body.num == {0: 1} and body.q == 1 and not body.den:
            return body
        if body.den or body.q != 1 or not body.num:
            raise Unknown("a product of quotients, or of zeros")
        made, low, high = self._renamed([(tuple(self._atoms_of(monomial)), c) for monomial, c in body.num.items()], name, low, high)
        return self._product_to(made, high) / self._product_to(made, plus(low, {"": 1}, -1))

    @staticmethod
    def _renamed(body: list[tuple[tuple, int]], name: str, low: Form, high: Form) -> tuple[tuple, Form, Form]:
        """A body and its ends after the index is changed so that some place of an atom becomes the index itself."""
        best = None
        keys = [key for monomial, _ in body for key, _ in monomial]
        for form in (form for key in [key for key in keys if key[0] != "power"] or keys for form in _forms(key)):
            s = form.get(name, 0)
            if abs(s) != 1:
                continue
            offset = {n: -s * c for n, c in form.items() if n != name}  # j = s i + offset
            made = tuple(sorted((tuple(sorted((_moved(k, name, s, offset), e) for k, e in monomial)), c) for monomial, c in body))
            if best is None or made < best[0]:
                best = made, s, offset
        if best is None:
            raise Unknown("a sum over multiples of its index")
        made, s, offset = best
        if s > 0:
            return made, plus(low, offset, -1), plus(high, offset, -1)
        return made, plus(offset, high, -1), plus(offset, low, -1)

    def _from_constant(self, form: Form) -> tuple[Form, int]:
        """A form without its constant, and that."""
        form = self.region.reduce(form)
        return {n: x for n, x in form.items() if n}, _written_out(form.get("", 0))

    def _sum_to(self, made: tuple, high: Form) -> Symbolic:
        """The indefinite sum, by its value where the constant is zero and the terms from there."""
        base, c = self._from_constant(high)
        out = self.atom(("sum", made, form_key(base)))
        for q in range(min(c, 0) + 1, max(c, 0) + 1):
            term = self._at(made, plus(base, {"": q}))
            out = out + term if c > 0 else out - term
        return out

    def _product_to(self, made: tuple, high: Form) -> Symbolic:
        """The indefinite product, in the same way."""
        base, c = self._from_constant(high)
        if c < 0 and any(name.startswith("#") for name in base):  # within a sum, where no factor may be divided by
            return self.atom(("prod", made, form_key(self.region.reduce(high))))
        out = self.atom(("prod", made, form_key(base)))
        for q in range(min(c, 0) + 1, max(c, 0) + 1):
            factor = self.number(0)
            for monomial, times in made:
                factor = factor + self.number(times) * self._at(monomial, plus(base, {"": q}))
            out = out * factor if c > 0 else out / factor
        return out

    def _at(self, monomial: tuple, place: Form) -> Symbolic:
        """A monomial in atoms, with the place for its index, which is perhaps no index of the sum: that its inverses exist is not sure."""
        out = self.number(1)
        self.perhaps += 1
        try:
            for key, e in monomial:
                for _ in range(e):
                    out = out * self._again(_moved(key, "#", 0, place))
        finally:
            self.perhaps -= 1
        return out

    def _again(self, key: tuple) -> Symbolic:
        """An atom at new places, opened if these allow it."""
        forms = [dict(x) for x in key[2:]]
        if key[0] in BOUND:
            return (self._sum_to if key[0] == "sum" else self._product_to)(key[1], forms[0])
        if key[0] == "opaque":
            return self.atom((*key[:2], *(form_key(self.region.reduce(x)) for x in forms)))
        if key[0] == "word":
            return self.again(key)
        if key[0] == "power":
            return self.power_of_z(forms[0])
        if key[0] == "number":
            return self.linear(self.region.reduce(forms[0]))
        if key[0] == "entry":
            t, i, *j = (self.region.reduce(x) for x in forms)
            self._need_place(["sym", key[1]], i, j[0] if j else {"": 1}, {})
            return self.entry(["at", key[1], ["sym", "@t"]], i, j[0] if j else {"": 1}, {"@t": t})
        if key[0] == "coeff" and len(forms) == 1:
            return self.coefficient(["sym", key[1]], self.region.reduce(forms[0]), {})
        if key[0] == "coeff":
            *args, m = forms
            return self._call(key[1], tuple(self.region.reduce(a) for a in args), lambda body, inner: self.coefficient(body, m, inner), m)
        if key[0] in ("value", "value at 1/z"):
            return self.named_at_z(key[1], tuple(self.region.reduce(a) for a in forms), key[0] != "value")
        return self._call(key[1], tuple(self.region.reduce(a) for a in forms), self.value)


def _written_out(terms: int) -> int:
    """A number of terms, none that nobody could wait for."""
    if abs(terms) > _LONGEST:
        raise Unknown("too long a sum to be written out")
    return terms


def _forms(key: Any) -> Iterator[Form]:
    for x in key[2:]:
        yield dict(x)


def _moved(key: tuple, name: str, s: int, offset: Form) -> tuple:
    """The atom with s # + offset in place of the index of the sum; '#' stands for the new index."""
    if key[0] in BOUND and name != "#" and Indefinite._moves(key[1], name):  # '#' itself is bound there
        raise Unknown("sums within sums that depend on the outer index")
    moved = plus({"#": s} if s else {}, offset)
    return (*key[:2], *(form_key(plus({n: c for n, c in x if n != name}, moved, c)) if (c := dict(x).get(name, 0)) else x for x in key[2:]))
