# SPDX-License-Identifier: MIT
"""Recursions at a generic index: that they define something, and that nothing divided by is zero.

Lemmas about what is not there would prove everything. X[t + 1] = X[n] + s[t] has no solution where t + 1 = n, and yet gives
s[n - 1] = 0. X[0] = 1, X[t + 1] = X[t] make 1/(X[t] - 1) a division by zero for all values of the variables: what a
lemma says of it is empty, and two of them may say different things. So two properties are shown beforehand.

*Well-founded.* Each value of a recursion, written out, is made of values at smaller indices, as far as those lead back to
it. Then the recursions have a solution in the field of rational functions in the variables, whatever lies before their
start. A value that is a polynomial is written out coefficient by coefficient, or as a function of z that is divided by nothing but z: then it is a
polynomial in z and 1/z. Of others the definition is not used.

*Not zero.* A polynomial in the atoms is not zero if it is not at one point: all entries of sequences and vectors zero
and the numbers one, or those zero too of which the type does not exclude it. There a recursion has a value if its initial values and its
step, at a generic index and place, divide by nothing but numbers other than zero, and all its values (coefficients,
entries) are one number c if those of its initial value are, and those of its step where they are at the index before. Several
recursions are looked at together: what has been supposed of one is supposed until it is seen not to be so. With these numbers
in place of its atoms the polynomial comes to its value at the point, whatever the indices. An indefinite sum F of what is zero at the point, at
every index, is taken with F(0) = 0, and so is zero there. Functions of z that are not opened are looked at for z = 1, where z^n is one.

Main definitions
----------------
`ill_founded`
    Recursions and functions of which the definition is not used.
`Witness`
    Finds the values at the point, and tells whether a polynomial is not zero.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from math import prod
from typing import Any

from exactkf.kernel.generic import Terms
from exactkf.kernel.indefinite import BOUND
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.opaque import with_names
from exactkf.kernel.packed import Poly, exponents
from exactkf.kernel.region import INDEX, Form, Region, Split, plus
from exactkf.kernel.symbolic import Symbolic

__all__ = ["Witness", "ill_founded"]

_MOST_SPLITS = 8
_Z = Fraction(2)  # the place at which z is looked at, beside no function of it
_IN_Z = ("value", "value at 1/z")

Case = tuple[Any, dict[str, Form], list[Form], Form]  # term, values of its indices, region, largest index it may use


def _cases(d: Any) -> tuple[list[Case], list[Case]]:
    """What gives the first values of a recursion, and the later ones from those before; of a function, all."""
    if d[0] == "let":
        env: dict[str, Form] = {p: {f"@{p}": 1} for p in d[2][:-1]}
        return [], [(d[3], {**env, d[2][-1]: {INDEX: 1}}, [{INDEX: 1}], {INDEX: 1, "": -1})]
    _, _, index, start, initial, step = d
    first: list[Case] = [(tree, {}, [], plus({"": start + k}, {"": 1}, -1)) for k, tree in enumerate(initial)]
    return first, [(step, {index: {INDEX: 1}}, [plus({INDEX: 1}, {"": 1 - start - len(initial)})], {INDEX: 1})]


def _values(make: Callable[[Region], Terms], name: str, case: Case, sizes: list[Form], splits: int = 0,
            in_z: bool = True, at_z: bool = False) -> Iterator[tuple[Terms, Symbolic]]:
    """What a case, its coefficients (if ``in_z``; or ``at_z`` its value as a function of z) or its entries come to, in each part of the region."""
    tree, env, forms, within = case
    region = Region.of(*sizes, *forms)
    if region.empty:
        return
    terms = make(region)
    if region.decide({INDEX: 1}) is not True:  # of a recursion that starts before zero
        terms.always.discard(INDEX)
    terms.within = terms.region.reduce(within), terms.known.connected[name]
    try:
        if terms.is_matrix(tree):
            inside = [form for n, size in zip(("row", "column"), terms.shape(tree, env), strict=True) for form in ({n: 1, "": -1}, plus(size, {n: 1}, -1))]
            terms.region = region.and_(*inside)
            found = terms.entry(tree, terms.region.reduce({"row": 1}), terms.region.reduce({"column": 1}), env)
        elif at_z:
            found = _without_poles(terms, terms.at_z(tree, env))
        else:
            found = terms.coefficient(tree, terms.region.reduce({"z": 1}), env) if in_z and name in terms.in_z else terms.value(tree, env)
    except Split as split:
        if splits > _MOST_SPLITS:
            raise Unknown("too many cases") from None
        for part in (split.form, plus({n: -c for n, c in split.form.items()}, {"": 1}, -1)):
            yield from _values(make, name, (tree, env, [*forms, part], within), sizes, splits + 1, in_z, at_z)
        return
    yield terms, found


def _without_poles(terms: Terms, x: Symbolic) -> Symbolic:
    """A function of z that is divided by no other than z: where those that it is made of have coefficients it has them too."""
    for p in terms.field.factors:
        kinds = {key[:2] for monomial in p for place, e in enumerate(exponents(monomial)) if e for key in [terms.atoms[place]]}
        powers = {kind for kind in kinds if kind in (("at", "z"), ("power", "z"))}
        if powers and (len(p) > 1 or kinds != powers) or any(kind in (*_IN_Z, *BOUND) for kind, _ in kinds):  # z may be in a sum, too
            raise Unknown("a function of z with poles")
    return x


def ill_founded(statement: Mapping[str, Any], sizes: list[Form]) -> set[str]:
    """Recursions, and functions that call themselves, not seen to be made of values at smaller indices."""
    def make(region: Region) -> Terms:
        return Terms(statement, region)

    found = set()
    for name in make(Region.of()).recursive:
        first, later = _cases(next(d for d in statement["where"] if d[1] == name))
        if not any(_ends(make, name, first + later, sizes, at_z) for at_z in (False, True)):
            found.add(name)
    return found


def _ends(make: Callable[[Region], Terms], name: str, cases: list[Case], sizes: list[Form], at_z: bool) -> bool:
    """Whether values are seen to be made of values at smaller indices: coefficient by coefficient, or as functions of z."""
    try:
        for case in cases:
            for _ in _values(make, name, case, sizes, at_z=at_z):
                pass
    except (Unknown, Undefined, RecursionError, KeyError):
        return False
    return True


class _AtPoint(Terms):
    """Terms of a statement at the point; what has a value there that is not known stays an atom."""

    def __init__(self, witness: Witness, region: Region) -> None:
        super().__init__(witness.statement, region)
        self.witness = witness

    def atom(self, key: tuple) -> Symbolic:
        found = self.witness.value(key)
        return super().atom(key) if found is None else self.number(found)


class Witness:
    """The values of recursions at the point, found when they are asked for.

    Parameters
    ----------
    statement
        Its recursions and variables are looked at.
    sizes : list of forms
        What is known not to be negative.
    number : int
        The value of a number that may be zero.
    """

    def __init__(self, statement: Mapping[str, Any], sizes: list[Form], number: int = 1) -> None:
        self.statement, self.sizes = statement, sizes
        self.at = {name: Fraction(1 if kind[0] in ("nonzero", "positive") else number) for name, kind in statement["over"]}
        self.numbers = {name for name, kind in statement["over"] if kind[0] in ("scalar", "nonzero", "positive", "nonneg")}
        self.entries = {name for name, kind in statement["over"] if kind[0] in ("sequence", "signal") or kind[0] == "matrix" and kind[2] == 1}
        self.monic = {name for name, kind in statement["over"] if kind[0] == "monic"}
        self.polynomials = {name for name, kind in statement["over"] if kind[0] in ("poly", "monic")}
        self.recursions = {d[1]: d for d in statement["where"] if d[0] == "rec"}
        self.z = _Z
        self.at_one: dict[tuple[str, str], Fraction] = {}  # functions of z, for z = 1
        self.found: dict[str, Fraction | None] = {}  # None: there is a value, not known

    def is_not_zero(self, terms: Terms, p: Poly) -> bool:
        """The polynomial has one atom, an entry of a variable, is a power of a monic one, or is not zero at the point."""
        atoms = {place for monomial in p for place, e in enumerate(exponents(monomial)) if e}
        if len(atoms) == 1:
            key = terms.atoms[min(atoms)]
            if key[0] == "at" and (key[1] == "z" or key[1] in self.numbers | self.entries):
                return True
            if key[0] in _IN_Z and len(p) == 1 and (key[1] in self.monic or key[1].startswith('["charpoly", ')):  # a power of a polynomial that is not zero
                return True
            if key[0] == "prod" and len(p) == 1:  # no factor is zero, and so the product is not
                variables = len(key[1]) == 1 and all(x[0] == "at" and x[1] in self.numbers | self.entries for x, _ in key[1][0][0])
                return len(p) == 1 and (variables or bool(self._number(key[1])))
        self.z = Fraction(1) if any(_has_functions(terms.atoms[place]) for place in atoms) else _Z
        try:
            values = {place: self.value(terms.atoms[place]) for place in atoms}
        except (Unknown, Undefined):
            return False
        finally:
            self.z = _Z
        total = Fraction(0)
        for monomial, c in p.items():
            powers = [(values[place], e) for place, e in enumerate(exponents(monomial)) if e]
            if any(x == 0 for x, _ in powers):  # whatever the others are: they have values
                continue
            if any(x is None for x, _ in powers):
                return False
            total += c * prod(x**e for x, e in powers if x is not None)
        return total != 0

    def _number(self, body: tuple) -> Fraction | None:
        """The factor of a product at the point, where it is the same number at every index."""
        total = Fraction(0)
        for monomial, c in body:
            term, all_known = Fraction(c), True
            for key, e in monomial:
                try:
                    x = self.value(key)
                except (Unknown, Undefined):
                    return None
                if x is None:
                    all_known = False
                else:
                    term *= x**e
            if term and not all_known:
                return None
            total += term
        return total

    def _opaque(self, key: tuple) -> Fraction | None:
        """One for the determinant of a matrix with ones on and zeros above its diagonal; zero for a product with a column that is zero.

        Square matrices are the identity at the point, so that their powers have values, whatever the exponents. A product of matrices
        that have values has a value, and so it is zero with a column that is, whatever the others are.
        """
        tree, env = with_names(key[1]), dict[str, Form]()
        kinds = [self._factor(x) for x in (tree[1:] if tree[0] == "*" else [tree])]
        if all(kinds):
            return Fraction(0) if "zero" in kinds else None
        if tree[0] != "det":
            raise Unknown("no value of a term that is not opened")
        for number in range(len(key) - 2):
            env[f"@{number}"] = {f"@{number}": 1}
        if _looked_at(self, tree[1], env):
            return Fraction(1)
        raise Unknown("no value of a determinant")

    def value(self, key: tuple) -> Fraction | None:
        """The value of an atom, None if it has one that is not known; Unknown if it may have none."""
        kind, name = key[:2]
        if kind == "prod":  # of factors c at the point: then P is c^j there, one for c = 1; zero divides by itself, and has none
            if not (c := self._number(key[1])):
                raise Unknown("no value of a product")
            return Fraction(1) if c == 1 else None
        if kind in ("opaque", "word"):
            return self._opaque(key)
        if kind == "power":  # of z
            return Fraction(1) if self.z == 1 else None
        if kind == "sum":  # of zeros: then F with F(0) = 0 is zero there, for any index; other sums have values if their atoms have
            found = [self.value(factor) for factor, _ in name]
            return Fraction(0) if Fraction(0) in found else None
        if kind == "at" and name in self.entries or kind == "coeff" and name in self.polynomials:  # but for leading coefficients, which are no atoms
            return Fraction(0)
        if kind == "at" and (name == "z" or name in self.numbers):
            return self.z if name == "z" else self.at[name]
        if kind in _IN_Z:
            if (kind, name) not in self.at_one:
                self.at_one[kind, name] = self._value_at_one(name)
            return self.at_one[kind, name]
        if kind not in ("at", "entry", "coeff") or name not in self.recursions:
            raise Unknown(f"no value of {name} at a point")
        if name not in self.found:
            self._find(name)
        return self.found[name]

    def _value_at_one(self, name: str) -> Fraction:
        """A function of z that is no recursion, where z is one: the same number whatever its indices are."""
        d = next((d for d in self.statement["where"] if d[1] == name), None)
        make: Callable[[Region], Terms] = lambda region: _AtPoint(self, region)
        known = make(Region.of()).known
        if d is None or d[0] != "let" or name in known.recursive:
            raise Unknown(f"no value of {name} at a point")
        case: Case = (_at_one(d[3]), {p: {f"@{p}": 1} for p in d[2]}, [], {INDEX: 1})
        found = set[Fraction]()
        for terms, x in _values(make, name, case, self.sizes, in_z=False):
            if terms.field.factors or any(x.num):
                raise Unknown("no number")
            found.add(Fraction(x.num.get(0, 0), x.q))
        if len(found) != 1:
            raise Unknown("no number")
        return found.pop()

    def _factor(self, tree: Any) -> str:
        """What a factor is at the point: a column of zeros, the identity, a matrix that has a value, or nothing that is known."""
        if isinstance(tree, int):
            return ""
        if tree[0] == "at" and tree[1] in self.recursions:
            if tree[1] not in self.found:
                self._find(tree[1])
            return "value"
        if tree[0] == "T" or tree[0] == "^" and self._factor(tree[1]) == "one":
            return self._factor(tree[1])
        kind = next((kind for name, kind in self.statement["over"] if tree[:1] == ["sym"] and tree[1] == name), None)
        if kind is None or kind[0] != "matrix":
            return ""
        return "zero" if kind[2] == 1 else "one" if kind[1] == kind[2] else ""

    def _find(self, name: str) -> None:
        """One number, or values that are not known."""
        first, later = _cases(self.recursions[name])
        for constant in (True, False):
            known = dict(self.found)
            try:
                if constant:
                    self.found[name] = next(self._at_point(name, first, True))
                    if any(x != self.found[name] for x in self._at_point(name, first + later, True)):
                        raise Unknown(f"{name} does not keep its value")
                else:
                    self.found[name] = None
                    list(self._at_point(name, first + later, False))
                return
            except (Unknown, Undefined, StopIteration):
                self.found = known
        raise Unknown(f"no value of {name} at a point")

    def _at_point(self, name: str, cases: list[Case], constant: bool) -> Iterator[Fraction]:
        """What the cases come to, which are numbers if ``constant``; nothing but numbers is divided by."""
        for case in cases:
            for terms, x in _values(lambda region: _AtPoint(self, region), name, case, self.sizes):
                if terms.field.factors or constant and any(x.num):
                    raise Unknown("no number")
                yield Fraction(x.num.get(0, 0), x.q)


def _has_functions(key: Any) -> bool:
    """Whether an atom is a function of z as it is or a power of z, or a sum or a product of such."""
    return key in (*_IN_Z, "power") if not isinstance(key, tuple) else any(_has_functions(x) for x in key)


def _at_one(tree: Any) -> Any:
    """A term with one in place of z."""
    if not isinstance(tree, list) or tree[:1] in (["coeff"], ["laurent"], ["subst"]):
        return tree
    if tree[:1] == ["z"] or tree[:1] == ["^"] and tree[1] == ["z"]:
        return 1
    return _at_one(tree[1]) if tree[:1] == ["recip"] else [_at_one(x) for x in tree]


def _looked_at(witness: Witness, matrix: Any, env: dict[str, Form]) -> bool:
    """Whether a square matrix has ones on, zeros above and values below its diagonal, at the point and whatever its indices are."""
    def ones(region: Region, wanted: int | None, splits: int = 0) -> bool:
        if region.empty:
            return True
        terms = _AtPoint(witness, region)
        try:
            x = terms.entry(matrix, terms.region.reduce({"row": 1}), terms.region.reduce({"column": 1}), env)
        except Split as split:
            return splits < _MOST_SPLITS and all(ones(part, wanted, splits + 1) for part in region.cases(split.form))
        return not terms.field.factors and (wanted is None or not (x - terms.number(wanted)).num)

    try:
        terms = _AtPoint(witness, Region.of(*witness.sizes))
        rows, cols = terms.shape(matrix, env)
        if not terms.is_matrix(matrix) or plus(rows, cols, -1):
            return False
        gap: Form = {"column": 1, "row": -1}
        square = Region.of(*witness.sizes, {"row": 1, "": -1}, plus(rows, {"row": 1}, -1), {"column": 1, "": -1}, plus(rows, {"column": 1}, -1))
        places = {1: (gap, plus({}, gap, -1)), 0: (plus(gap, {"": 1}, -1),), None: (plus(plus({}, gap, -1), {"": 1}, -1),)}
        return all(ones(square.and_(*forms), wanted) for wanted, forms in places.items())
    except (Unknown, Undefined, KeyError):
        return False
