# SPDX-License-Identifier: MIT
"""Recursions of growing degree, for every index at once: coefficients and sums at a generic index.

A polynomial of degree t, a sum of t terms or a matrix of size n has no fixed shape. What has one
is a coefficient phi_t[m] at a generic place m, and the indefinite sum F of a summand f: the sum
of f(lo), .., f(hi) is F(hi) - F(lo - 1), and F(j + 1) = F(j) + f(j + 1). So an equation becomes
an identity of rational functions in atoms

    gamma[t],  r[t],  phi_t[m],  F[j]        with linear forms in t, m, .. for indices,

in each of finitely many regions of the integer parameters (k < t, k = t, ..). Sequences may be
thought of as continued to all integers in any way: what lies outside cancels.

Main definitions
----------------
`Terms`
    Value of a term, coefficient of a polynomial, entry of a matrix in a region.

Notation: a form is {parameter: integer} with '' for the constant; ``#0, #1, ..`` are indices of sums.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from itertools import count
from typing import Any

from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.packed import BITS, exponents
from exactkf.kernel.region import INDEX, Form, Region, Split, form_key, plus
from exactkf.kernel.symbolic import Symbolic, SymbolicField

__all__ = ["Terms"]

_MOST_OPEN = 60  # definitions opened within each other


# ---------------------------------------------------------------------- terms
class Terms:
    """Terms of a statement in a region, as rational functions of atoms.

    Parameters
    ----------
    statement
        Its sequences, recursions and functions may be used.
    region
        The region of the parameters.
    supported : names of recursions X whose value X_t is a polynomial with exponents 0 .. t
    closed : names of functions that are opened at integers alone
    rules : mapping of name to (least index or None for the hypothesis of an induction, index name, term)
        X_t = term, shown before.
    """

    def __init__(self, statement: Mapping[str, Any], region: Region, supported: Any = (), rules: Mapping[str, tuple] | None = None,
                 closed: Any = ()) -> None:
        self.statement, self.region, self.supported, self.rules, self.closed = statement, region, set(supported), dict(rules or {}), set(closed)
        self.definitions = {d[1]: d for d in statement["where"]}
        self.sequences = {name for name, kind in statement["over"] if kind[0] in ("sequence", "signal", "vector") or kind[0] == "matrix" and kind[2] == 1}
        self.scalars = {name for name, kind in statement["over"] if kind[0] in ("scalar", "nonzero", "positive", "nonneg")}
        self.recursive, self.in_z = _classified(statement, self.definitions)
        self.field = SymbolicField()
        self.atoms: list[tuple] = []
        self.places: dict[tuple, int] = {}
        self.fresh = count()
        self.depth = 0
        self.in_values = False  # polynomials are read as functions of z
        self.limited = False  # exponents are known for indices up to that of the induction

    def atom(self, key: tuple) -> Symbolic:
        if key not in self.places:
            self.places[key] = len(self.atoms)
            self.atoms.append(key)
            self.field.variable(_atom_text(key))
        return Symbolic(self.field, {1 << (BITS * self.places[key]): 1}, 1, ())

    def number(self, value: Any) -> Symbolic:
        value = Fraction(value)
        return Symbolic(self.field, {0: value.numerator} if value else {}, value.denominator, ())

    @staticmethod
    def form_text(form: Form) -> str:
        """A form for people."""
        return _form_text(form_key(form))

    # ------------------------------------------------------------------ indices and conditions
    def index(self, tree: Any, env: Mapping[str, Form]) -> Form:
        return self.region.reduce(self._index(tree, env))

    def _index(self, tree: Any, env: Mapping[str, Form]) -> Form:
        if isinstance(tree, int):
            return {"": tree} if tree else {}
        op = tree[0]
        if op == "sym" and tree[1] in env:
            return env[tree[1]]
        if op == "sym" and tree[1] in self.statement["sizes"]:
            return {tree[1]: 1}
        if op in ("+", "-"):
            total = self._index(tree[1], env)
            for part in tree[2:]:
                total = plus(total, self._index(part, env), 1 if op == "+" else -1)
            return total
        if op == "neg":
            return plus({}, self._index(tree[1], env), -1)
        if op == "abs":
            form = self._index(tree[1], env)
            return form if self.region.holds(form) else plus({}, form, -1)
        if op in ("nrows", "ncols"):
            return self.shape(tree[1], env)[op == "ncols"]
        raise Unknown(f"{tree!r} is no index")

    def condition(self, tree: Any, env: Mapping[str, Form]) -> bool:
        op = tree[0]
        if op in ("and", "or"):
            return (all if op == "and" else any)(self.condition(x, env) for x in tree[1:])
        if op == "not":
            return not self.condition(tree[1], env)
        if op not in _GAPS or len(tree) != 3:
            raise Unknown(f"condition {op!r} at a generic index")
        gap = plus(self.index(tree[1], env), self.index(tree[2], env), -1)
        return _GAPS[op](self.region, gap)

    # ------------------------------------------------------------------ values
    def value(self, tree: Any, env: Mapping[str, Form]) -> Symbolic:
        """Value of a term without z."""
        if isinstance(tree, int):
            return self.number(tree)
        op = tree[0]
        if op == "rat":
            return self.number(Fraction(tree[1], tree[2]))
        if self.is_matrix(tree):
            if self.shape(tree, env) != ({"": 1}, {"": 1}):
                raise Undefined("a matrix stands where a scalar is needed")
            return self.entry(tree, {"": 1}, {"": 1}, env)
        if op in ("+", "-", "*", "/"):
            out = self.value(tree[1], env)
            for part in tree[2:]:
                y = self.value(part, env)
                out = out + y if op == "+" else out - y if op == "-" else out * y if op == "*" else out / y
            return out
        if op == "neg":
            return -self.value(tree[1], env)
        if op == "^" and isinstance(tree[2], int):
            out, x = self.number(1), self.value(tree[1], env)
            for _ in range(abs(tree[2])):
                out = out * x
            return out if tree[2] >= 0 else out.inverse()
        if op == "if":
            return self.value(tree[2] if self.condition(tree[1], env) else tree[3], env)
        if op == "coeff":
            return self.coefficient(tree[1], self.index(tree[2], env), env)
        if op == "sum":
            return self._sum(tree, env, self.value)
        if op == "sym":
            if tree[1] in env or tree[1] in self.statement["sizes"]:
                raise Unknown(f"index {tree[1]!r} as a number")
            if tree[1] in self.scalars:
                return self.atom(("at", tree[1]))
            return self._call(tree[1], (), self.value)
        if op == "at":
            return self._call(tree[1], tuple(self.index(a, env) for a in tree[2:]), self.value)
        if op == "entry":
            return self.entry(tree[1], self.index(tree[2], env), self.index(tree[3], env) if len(tree) > 3 else {"": 1}, env)
        raise Unknown(f"{op!r} at a generic index")

    def coefficient(self, tree: Any, m: Form, env: Mapping[str, Form]) -> Symbolic:
        """Coefficient of z^m of a (pseudo-)polynomial."""
        if not self.has_z(tree):
            return self.value(tree, env) if self.region.zero(m) else self.number(0)
        op = tree[0]
        if op == "z":
            return self.number(int(self.region.zero(plus(m, {"": 1}, -1))))
        if op in ("+", "-"):
            out = self.coefficient(tree[1], m, env)
            for part in tree[2:]:
                y = self.coefficient(part, m, env)
                out = out + y if op == "+" else out - y
            return out
        if op == "neg":
            return -self.coefficient(tree[1], m, env)
        if op == "^" and tree[1] == ["z"]:
            return self.number(int(self.region.zero(plus(m, self.index(tree[2], env), -1))))
        if op in ("*", "/"):
            return self._product(tree, m, env)
        if op == "rev":
            return self.coefficient(tree[1], self.region.reduce(plus(self.index(tree[2], env), m, -1)), env)
        if op == "recip":
            return self.coefficient(tree[1], plus({}, m, -1), env)
        if op == "if":
            return self.coefficient(tree[2] if self.condition(tree[1], env) else tree[3], m, env)
        if op == "sum":
            return self._sum(tree, env, lambda body, inner: self.coefficient(body, m, inner))
        if op == "sym":
            return self._call(tree[1], (), lambda body, inner: self.coefficient(body, m, inner), m)
        if op == "at":
            return self._call(tree[1], tuple(self.index(a, env) for a in tree[2:]), lambda body, inner: self.coefficient(body, m, inner), m)
        raise Unknown(f"{op!r} of polynomials at a generic index")

    def _product(self, tree: Any, m: Form, env: Mapping[str, Form]) -> Symbolic:
        """A product in which all factors but one are free of z, powers of z, or sums that are multiplied out."""
        factor, rest = self.number(1), list[Any]()
        parts = [(x, 1) for x in tree[1:]] if tree[0] == "*" else [(tree[1], 1), (tree[2], -1)]
        while parts:
            x, e = parts.pop(0)
            if not self.has_z(x):
                value = self.value(x, env)
                factor = factor * (value if e > 0 else value.inverse())
            elif x[0] == "*":
                parts = [(y, e) for y in x[1:]] + parts
            elif x[0] == "/":
                parts = [(x[1], e), (x[2], -e), *parts]
            elif x == ["z"] or (x[0] == "^" and x[1] == ["z"]):
                m = self.region.reduce(plus(m, self.index(x[2], env) if len(x) > 1 else {"": 1}, -e))
            elif e > 0:
                rest.append(x)
            else:
                raise Unknown("a quotient by a polynomial at a generic index")
        if len(rest) < 2:
            return factor * (self.coefficient(rest[0], m, env) if rest else self.number(int(self.region.zero(m))))
        several = next((x for x in rest if x[0] in ("+", "-", "neg")), None)
        if several is None:
            raise Unknown("a product of polynomials at a generic index")
        others = [x for x in rest if x is not several]
        out = self.number(0)
        for k, x in enumerate(several[1:]):
            term = self.coefficient(["*", x, *others], m, env)
            out = out - term if several[0] == "neg" or (several[0] == "-" and k) else out + term
        return factor * out

    def at_z(self, tree: Any, env: Mapping[str, Form], flip: bool = False) -> Symbolic:
        """A polynomial as a function of z (of 1/z): an element of a field with the automorphism z -> 1/z."""
        if not self.has_z(tree):
            return self.value(tree, env)
        op = tree[0]
        if op == "z":
            return self.atom(("at", "z")).inverse() if flip else self.atom(("at", "z"))
        if op == "recip":
            return self.at_z(tree[1], env, not flip)
        if op == "neg":
            return -self.at_z(tree[1], env, flip)
        if op in ("+", "-", "*", "/"):
            out = self.at_z(tree[1], env, flip)
            for part in tree[2:]:
                y = self.at_z(part, env, flip)
                out = out + y if op == "+" else out - y if op == "-" else out * y if op == "*" else out / y
            return out
        if op in ("sym", "at"):
            args = tuple(self.index(a, env) for a in tree[2:])
            if tree[1] in self.closed:
                return self.atom(("value at 1/z" if flip else "value", tree[1], *map(form_key, args)))
            if tree[1] not in self.recursive and tree[1] in self.definitions:
                return self._open(self.definitions[tree[1]], args, lambda body, inner: self.at_z(body, inner, flip))
        raise Unknown(f"{op!r} as a function of z")

    def has_z(self, tree: Any) -> bool:
        return _mentions_z(tree, self.in_z)

    # ------------------------------------------------------------------ definitions
    def _call(self, name: str, args: tuple[Form, ...], read: Callable, m: Form | None = None, place: tuple[Form, ...] = ()) -> Symbolic:
        """A definition, opened where its arguments allow it; else an atom (its coefficient at m, or its entry at a place)."""
        if name in self.sequences:
            return self.atom(("at", name, *map(form_key, args)))
        d = self.definitions.get(name)
        if d is None:
            raise Unknown(f"{name!r} at a generic index")
        last = args[-1] if args else {}
        if name in self.recursive:
            if (found := self._solved(name, args, read)) is not None:
                return found
            if m is not None and name in self.supported and self._outside(last, m):
                return self.number(0)
            if not self._opens(d, last):
                kind, where = ("coeff", (m,)) if m is not None else ("entry", place) if place else ("at", ())
                return self.atom((kind, name, *map(form_key, args), *(form_key(self.region.reduce(x)) for x in where)))
        self.depth += 1
        try:
            if self.depth > _MOST_OPEN:
                raise Unknown(f"definition of {name} does not end")
            return self._open(d, args, read)
        finally:
            self.depth -= 1

    def _open(self, d: Any, args: tuple[Form, ...], read: Callable) -> Symbolic:
        if d[0] == "let":
            if len(d[2]) != len(args):
                raise Undefined(f"{d[1]} takes {len(d[2])} arguments")
            return read(d[3], dict(zip(d[2], args, strict=True)))
        (k,) = args
        offset = plus(k, {"": d[3]}, -1)
        if set(offset) <= {""} and offset.get("", 0) < len(d[4]):
            return read(d[4][offset.get("", 0)], {})
        return read(d[5], {d[2]: plus(k, {"": 1}, -1)})

    def defining(self, name: str, args: tuple[Form, ...]) -> Symbolic:
        """Value of a function that is kept closed, less what defines it there."""
        d = self.definitions[name]
        if d[0] != "let" or name not in self.recursive or name in self.in_z or not all(self.region.holds(a) for a in args):
            raise Unknown(f"no definition of {name} to be used there")
        return self.atom(("at", name, *map(form_key, args))) - self._open(d, args, self.value)

    def _opens(self, d: Any, last: Form) -> bool:
        """At an integer not before the start, or at the index of the induction plus a positive integer."""
        least = d[3] if d[0] == "rec" else 0
        c = last.get("", 0)
        if set(last) <= {""}:
            return c >= least
        return d[1] not in self.closed and set(last) <= {INDEX, ""} and last[INDEX] == 1 and c >= (max(1, least + len(d[4])) if d[0] == "rec" else 1)

    def _solved(self, name: str, args: tuple[Form, ...], read: Callable) -> Symbolic | None:
        if name not in self.rules or len(args) != 1:
            return None
        least, index, term = self.rules[name]
        if (args[0] == {INDEX: 1}) if least is None else self.region.decide(plus(args[0], {"": least}, -1)):
            return read(term, {index: args[0]})
        return None

    def _outside(self, t: Form, m: Form) -> bool:
        """No coefficient there: t is known to be >= 0, and m < 0 or m > t."""
        if self.region.decide(t) is not True or self.limited and self.region.decide(plus({INDEX: 1}, t, -1)) is not True:
            return False
        return not self.region.holds(m) or not self.region.holds(plus(t, m, -1))

    # ------------------------------------------------------------------ sums
    def _sum(self, tree: Any, env: Mapping[str, Form], read: Callable) -> Symbolic:
        _, name, low, high, body = tree
        return self.total(self.index(low, env), self.index(high, env), lambda inner, j: inner._reread(read, body, {**env, name: j}))

    def _reread(self, read: Callable, body: Any, env: Mapping[str, Form]) -> Symbolic:
        return read(body, env)

    def total(self, low: Form, high: Form, summand: Callable[[Terms, Form], Symbolic]) -> Symbolic:
        """Sum of the summand from low to high, cut where its form changes."""
        if not self.region.holds(plus(plus(high, low, -1), {"": 1})) or self.region.decide(plus(high, low, -1)) is False:
            return self.number(0)
        length = self.region.reduce(plus(high, low, -1))
        if self.region.decide(plus({}, length, -1)) is True:
            length = {}
        if set(length) <= {""}:
            out = self.number(0)
            for k in range(length.get("", 0) + 1):
                out = out + summand(self, self.region.reduce(plus(low, {"": k})))
            return out
        name = f"#{next(self.fresh)}"
        j = {name: 1}
        outer = self.region
        self.region = outer.and_(plus(j, low, -1), plus(high, j, -1))
        try:
            body = summand(self, j)
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
            return self.total(low, cut, summand) + self.total(plus(cut, {"": 1}), high, summand)
        finally:
            self.region = outer
        return self._indefinite(body, name, low, high)

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
        return key == name or isinstance(key, tuple) and any(Terms._moves(x, name) for x in key)

    def _difference(self, moving: list, name: str, low: Form, high: Form) -> Symbolic:
        if not moving:
            raise Unknown("a sum of a term that does not depend on its index")
        best = None
        for key, _ in moving:  # the index is changed so that some place becomes the index itself
            for form in _forms(key):
                s = form.get(name, 0)
                if abs(s) != 1:
                    continue
                offset = {n: -s * c for n, c in form.items() if n != name}  # j = s i + offset
                made = tuple(sorted((_moved(k, name, s, offset), e) for k, e in moving))
                if best is None or made < best[0]:
                    best = made, s, offset
        if best is None:
            raise Unknown("a sum over multiples of its index")
        made, s, offset = best
        if s > 0:
            low, high = plus(low, offset, -1), plus(high, offset, -1)
        else:
            low, high = plus(offset, high, -1), plus(offset, low, -1)
        return self._sum_to(made, high) - self._sum_to(made, plus(low, {"": 1}, -1))

    def _sum_to(self, made: tuple, high: Form) -> Symbolic:
        """The indefinite sum, by its value where the constant is zero and the terms from there."""
        high = self.region.reduce(high)
        c = high.get("", 0)
        base = {n: x for n, x in high.items() if n}
        out = self.atom(("sum", made, form_key(base)))
        for q in range(min(c, 0) + 1, max(c, 0) + 1):
            term = self.number(1 if c > 0 else -1)
            for key, e in made:
                for _ in range(e):
                    term = term * self._again(_moved(key, "#", 0, plus(base, {"": q})))
            out = out + term
        return out

    def _again(self, key: tuple) -> Symbolic:
        """An atom at new places, opened if these allow it."""
        if key[0] == "sum":
            raise Unknown("sums within sums that depend on the outer index")
        forms = [dict(x) for x in key[2:]]
        if key[0] == "entry":
            t, i, *j = (self.region.reduce(x) for x in forms)
            return self.entry(["at", key[1], ["sym", "@t"]], i, j[0] if j else {"": 1}, {"@t": t})
        if key[0] == "coeff":
            *args, m = forms
            return self._call(key[1], tuple(self.region.reduce(a) for a in args), lambda body, inner: self.coefficient(body, m, inner), m)
        return self._call(key[1], tuple(self.region.reduce(a) for a in forms), self.value)

    # ------------------------------------------------------------------ matrices
    def is_matrix(self, tree: Any) -> bool:
        if isinstance(tree, int):
            return False
        if tree[0] in ("mat", "col", "I", "O", "T", "block"):
            return True
        if tree[0] in ("sym", "at"):
            d = self.definitions.get(tree[1])
            kinds = {name: kind[0] for name, kind in self.statement["over"]}
            if tree[0] == "sym" and kinds.get(tree[1]) in ("vector", "matrix"):
                return True
            return d is not None and (self.is_matrix(d[4][0]) if d[0] == "rec" else len(d[2]) == len(tree) - 2 and self.is_matrix(d[3]))
        if tree[0] == "/":
            return self.is_matrix(tree[1])
        return tree[0] in ("+", "-", "*", "neg") and any(self.is_matrix(x) for x in tree[1:])

    def shape(self, tree: Any, env: Mapping[str, Form]) -> tuple[Form, Form]:
        """Numbers of rows and columns; a scalar is 1 x 1."""
        if not self.is_matrix(tree):
            return {"": 1}, {"": 1}
        op = tree[0]
        if op == "mat":
            return self.index(tree[3], env), self.index(tree[4], env)
        if op == "col":
            return self.index(tree[2], env), {"": 1}
        if op in ("I", "O"):
            return self.index(tree[1], env), self.index(tree[-1], env)
        if op == "T":
            return self.shape(tree[1], env)[::-1]
        if op == "block":
            if any(len(row) != 1 for row in tree[1:]):
                raise Unknown("blocks side by side at a generic index")
            heights = [self.shape(row[0], env)[0] if self.is_matrix(row[0]) else {"": 1} for row in tree[1:]]
            total: Form = {}
            for h in heights:
                total = plus(total, h)
            return total, {"": 1}
        if op in ("sym", "at"):
            kinds = dict(self.statement["over"])
            if op == "sym" and tree[1] in kinds:
                kind = kinds[tree[1]]
                return self.index(kind[1], {}), self.index(kind[2], {}) if len(kind) > 2 else {"": 1}
            d = self.definitions[tree[1]]
            if d[0] == "rec":
                return self.shape(d[4][0], {})
            return self.shape(d[3], dict(zip(d[2], (self.index(a, env) for a in tree[2:]), strict=True)) if op == "at" else {})
        if op == "/":
            return self.shape(tree[1], env)
        if op == "*":
            chain = self._factors(tree, env)[1]
            return (self.shape(chain[0], env)[0], self.shape(chain[-1], env)[1]) if chain else ({"": 1}, {"": 1})
        shapes = [self.shape(x, env) for x in tree[1:]]
        if any(self.region.reduce(plus(x, y, -1)) for s in shapes[1:] for x, y in zip(s, shapes[0], strict=True)):
            raise Undefined("sizes do not fit")
        return shapes[0]

    def entry(self, tree: Any, i: Form, j: Form, env: Mapping[str, Form]) -> Symbolic:
        """Entry (i, j) of a matrix, counted from 1."""
        op = tree[0]
        if op == "mat":
            return self.value(tree[5], {**env, tree[1]: i, tree[2]: j})
        if op == "col":
            return self.value(tree[3], {**env, tree[1]: i})
        if op in ("I", "O"):
            return self.number(int(op == "I" and self.region.zero(plus(i, j, -1))))
        if op == "T":
            return self.entry(tree[1], j, i, env)
        if op in ("+", "-", "neg"):
            self.shape(tree, env)
            parts = [self.entry(x, i, j, env) if self.is_matrix(x) else self.value(x, env) for x in tree[1:]]
            out = -parts[0] if op == "neg" else parts[0]
            for x in parts[1:]:
                out = out + x if op == "+" else out - x
            return out
        if op == "*":
            scalars, chain = self._factors(tree, env)
            factor = self.number(1)
            for part in scalars:
                factor = factor * self._chain(part, {"": 1}, {"": 1}, env)
            return factor * (self._chain(chain, i, j, env) if chain else self.number(1))
        if op == "block":
            for row in tree[1:]:
                height = self.shape(row[0], env)[0] if self.is_matrix(row[0]) else {"": 1}
                if self.region.holds(plus(height, i, -1)):
                    return self.entry(row[0], i, j, env) if self.is_matrix(row[0]) else self.value(row[0], env)
                i = self.region.reduce(plus(i, height, -1))
            raise Undefined("no entry there")
        if op == "/":
            return self.entry(tree[1], i, j, env) / self.value(tree[2], env)
        if op in ("sym", "at"):
            if tree[1] in self.sequences:
                return self.atom(("at", tree[1], form_key(i)))
            d = self.definitions[tree[1]]
            if d[0] == "rec":
                place = (i, j) if self.shape(d[4][0], {})[1] != {"": 1} else (i,)
                return self._call(tree[1], (self.index(tree[2], env),), lambda body, inner: self.entry(body, i, j, inner), place=place)
            return self.entry(d[3], i, j, dict(zip(d[2], (self.index(a, env) for a in tree[2:]), strict=True)) if op == "at" else {})
        raise Unknown(f"{op!r} of matrices at a generic index")

    def _factors(self, tree: Any, env: Mapping[str, Form]) -> tuple[list[list], list]:
        """A product as products of size 1 x 1, and what is left; sizes that fit are checked."""
        one: tuple[Form, Form] = ({"": 1}, {"": 1})
        scalars, chain, shape = list[list](), list[Any](), one
        for x in tree[1:]:
            mine = self.shape(x, env)
            if chain and shape != one and mine != one:
                if self.region.reduce(plus(shape[1], mine[0], -1)):
                    raise Undefined("sizes do not fit")
                chain, shape = [*chain, x], (shape[0], mine[1])
            elif mine == one and shape != one:
                scalars.append([x])
            else:
                if chain:
                    scalars.append(chain)
                chain, shape = [x], mine
        return scalars, chain

    def _chain(self, parts: list, i: Form, j: Form, env: Mapping[str, Form]) -> Symbolic:
        if len(parts) == 1:
            return self.entry(parts[0], i, j, env) if self.is_matrix(parts[0]) else self.value(parts[0], env)
        _, width = self.shape(parts[0], env)
        return self.total({"": 1}, width, lambda terms, k: terms.entry(parts[0], i, k, env) * terms._chain(parts[1:], k, j, env))


_GAPS: dict[str, Callable[[Region, Form], bool]] = {
    "=": lambda r, f: r.zero(f), "!=": lambda r, f: not r.zero(f), ">=": lambda r, f: r.holds(f),
    ">": lambda r, f: r.holds(plus(f, {"": 1}, -1)), "<=": lambda r, f: r.holds(plus({}, f, -1)), "<": lambda r, f: not r.holds(f),
}


def _forms(key: Any) -> Iterator[Form]:
    if key[0] == "sum":
        return
    for x in key[2:]:
        yield dict(x)


def _moved(key: tuple, name: str, s: int, offset: Form) -> tuple:
    """The atom with s # + offset in place of the index of the sum; '#' stands for the new index."""
    if key[0] == "sum":
        if Terms._moves(key, name):
            raise Unknown("sums within sums that depend on the outer index")
        return key
    return (*key[:2], *(form_key(plus({n: c for n, c in x if n != name}, plus({"#": s} if s else {}, offset), dict(x).get(name, 0))) for x in key[2:]))


def _atom_text(key: tuple) -> str:
    if key[0] == "sum":
        return f"sum({'*'.join(_atom_text(k) for k, _ in key[1])}, {_form_text(key[2])})"
    return f"{key[1]}[{', '.join(_form_text(x) for x in key[2:])}]" if len(key) > 2 else key[1]


def _form_text(form: tuple) -> str:
    parts = [n.replace(INDEX, "t") if c == 1 else f"{c}{n.replace(INDEX, 't')}" for n, c in form if n]
    constant = dict(form).get("", 0)
    return "+".join([*parts, *([str(constant)] if constant or not parts else [])]).replace("+-", "-")


def _names(tree: Any) -> Iterator[str]:
    if isinstance(tree, list):
        if tree[:1] in (["sym"], ["at"]):
            yield tree[1]
        for x in tree:
            yield from _names(x)


_last: list[Any] = [None, set(), set()]  # a statement with what `_classified` says of it: many are asked for in a row


def _classified(statement: Mapping[str, Any], definitions: Mapping[str, Any]) -> tuple[set[str], set[str]]:
    """Recursive definitions, and those whose value depends on z."""
    if _last[0] is not statement:
        _last[:] = statement, _recursive(definitions), _in_z(definitions)
    return _last[1], _last[2]


def _recursive(definitions: Mapping[str, Any]) -> set[str]:
    """Recursions, and functions that lead back to themselves without passing a recursion."""
    calls = {name: set(_names(d[3])) & set(definitions) for name, d in definitions.items() if d[0] == "let"}
    found = {name for name, d in definitions.items() if d[0] == "rec"}
    for name in calls:
        todo, seen = list(calls[name]), set[str]()
        while todo:
            x = todo.pop()
            if x in calls and x not in seen:
                seen.add(x)
                todo.extend(calls[x])
        if name in seen and definitions[name][2]:
            found.add(name)
    return found


def _mentions_z(tree: Any, in_z: set[str]) -> bool:
    if not isinstance(tree, list) or not tree:
        return False
    if tree[0] in ("coeff", "laurent"):
        return False
    if tree == ["z"] or (tree[0] in ("sym", "at") and tree[1] in in_z):
        return True
    return any(_mentions_z(x, in_z) for x in tree[1:])


def _in_z(definitions: Mapping[str, Any]) -> set[str]:
    """Definitions whose value depends on z."""
    found: set[str] = set()
    while True:
        more = {name for name, d in definitions.items() if name not in found
                and any(_mentions_z(x, found) for x in ([d[3]] if d[0] == "let" else [*d[4], d[5]]))}
        if not more:
            return found
        found |= more
