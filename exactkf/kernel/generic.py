# SPDX-License-Identifier: MIT
"""Recursions of growing degree, for every index at once: coefficients and sums at a generic index.

A polynomial of degree t, a sum of t terms or a matrix of size n has no fixed shape. What has one
is a coefficient phi_t[m] at a generic place m, and the indefinite sum F of a summand f: the sum
of f(lo), .., f(hi) is F(hi) - F(lo - 1), and F(j + 1) = F(j) + f(j + 1). So an equation becomes
an identity of rational functions in atoms

    gamma[t],  r[t],  phi_t[m],  F[j]        with linear forms in t, m, .. for indices,

in each of finitely many regions of the integer parameters (k < t, k = t, ..). Sequences may be
thought of as continued to all integers in any way: what lies outside cancels.

As functions of z, polynomials are elements of a field with the automorphism z -> 1/z; there z^(n - k) is z^n/z^k, powers of z to parameters being
atoms. Coefficient by coefficient a product is a sum over the exponents of a factor, where these are known: those of a variable that is a
polynomial are 0 .. d by its type (with leading coefficient one if it is monic), those of X_t are 0 .. t if that has been shown.

Main definitions
----------------
`Terms`
    Value of a term, coefficient of a polynomial, entry of a matrix in a region.

Notation: a form is {parameter: integer} with '' for the constant; ``#0, #1, ..`` are indices of sums.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any

from exactkf.kernel.chains import Chains
from exactkf.kernel.indefinite import BOUND, Indefinite
from exactkf.kernel.known import MATRICES, OF_PARTS, inverts, known, names
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.opaque import opaque
from exactkf.kernel.packed import BITS
from exactkf.kernel.region import INDEX, Form, Region, Split, form_key, plus
from exactkf.kernel.symbolic import Symbolic, SymbolicField

__all__ = ["Terms"]

_LARGEST_POWER = 1000
_MOST_OPEN = 60  # definitions opened within each other


# ---------------------------------------------------------------------- terms
class Terms(Indefinite, Chains):
    """Terms of a statement in a region, as rational functions of atoms.

    Parameters
    ----------
    statement
        Its sequences, recursions and functions may be used.
    region
        The region of the parameters.
    supported : names of recursions X whose value X_t is a polynomial with exponents 0 .. t
    closed : names of functions that are opened at integers alone
    whole : names of recursions that are opened at their initial values alone, and of functions in z whose coefficients are not computed
    rules : mapping of name to (least index or None for the hypothesis of an induction, index names, greatest index or None, term)
        X_t = term, shown before.
    """

    def __init__(self, statement: Mapping[str, Any], region: Region, supported: Any = (), rules: Mapping[str, tuple] | None = None,
                 closed: Any = (), whole: Any = ()) -> None:
        self.statement, self.region, self.supported, self.rules, self.closed = statement, region, set(supported), dict(rules or {}), set(closed)
        self.whole = set(whole)
        self.definitions = {d[1]: d for d in statement["where"]}
        self.sequences = {name for name, kind in statement["over"] if kind[0] in ("sequence", "signal", "vector") or kind[0] == "matrix" and kind[2] == 1}
        self.scalars = {name for name, kind in statement["over"] if kind[0] in ("scalar", "nonzero", "positive", "nonneg")}
        self.known = known(statement, self.definitions)
        self.has_z, self.is_matrix, self.others = self.known.has_z, self.known.is_matrix, self.known.others
        self.recursive, self.in_z, self.inverting, self.kept = self.known.recursive, self.known.in_z, self.known.inverting, self.known.kept
        self.letters = self.known.spread({name for name in self.closed & set(self.definitions) if self.known.is_matrix_function(name)})
        self.met: set[tuple] = set()  # inverses that what has been read contains, also where they cancel: it has a value where they exist
        self.sure: set[tuple] = set()  # those that are not only in sums which may be empty: where it has a value they exist
        self.ruled = {name for name, rule in self.rules.items() if self.is_matrix(rule[3]) or self.is_matrix(_first(self.definitions[name]))}
        self.field = SymbolicField()
        self.atoms: list[tuple] = []
        self.places: dict[tuple, int] = {}
        self.nested = self.perhaps = 0
        self.called: dict[tuple, tuple[Symbolic, set[tuple], set[tuple], set[int]]] = {}
        self.shapes: dict[tuple[Region, str], tuple[Form, Form]] = {}
        self.shaped: dict[tuple[int, int, Region], tuple[tuple[Form, Form], Any, Any]] = {}
        self.depth = 0
        self.in_values = False  # polynomials are read as functions of z
        self.always: set[str] = {INDEX}  # indices that are >= 0 everywhere in the region; definitions are opened after them
        self.limited = False  # exponents are known for indices up to that of the induction
        self.unused: set[str] = set()  # recursions that are not opened
        self.not_zero: list[Symbolic] = []  # polynomials that a hypothesis says are not zero
        self.within: tuple[Form, set[str]] | None = None  # the largest index at which recursions of these names may be used

    def atom(self, key: tuple) -> Symbolic:
        if key not in self.places:
            self.places[key] = len(self.atoms)
            self.atoms.append(key)
            self.field.variable(_atom_text(key))
        return Symbolic(self.field, {1 << (BITS * self.places[key]): 1}, 1, ())

    def number(self, value: Any) -> Symbolic:
        if type(value) is int:
            return Symbolic(self.field, {0: value} if value else {}, 1, ())
        value = Fraction(value)
        return Symbolic(self.field, {0: value.numerator} if value else {}, value.denominator, ())

    def linear(self, form: Form) -> Symbolic:
        """An index as a number: one atom for each parameter, about which nothing is known."""
        out = self.number(form.get("", 0))
        for name, c in form.items():
            if name:
                out = out + self.number(c) * self.atom(("number", "", ((name, 1),)))
        return out

    @staticmethod
    def form_text(form: Form) -> str:
        """A form for people."""
        return _form_text(form_key(form))

    def has_letters(self, tree: Any) -> bool:
        """Whether a term contains a matrix that is not opened: a variable, or what is closed."""
        return self.known.has_letters(tree) or bool(self.letters) and not self.letters.isdisjoint(names(tree))

    # ------------------------------------------------------------------ indices and conditions
    def index(self, tree: Any, env: Mapping[str, Form]) -> Form:
        if type(tree) is int:
            return {"": tree} if tree else {}
        form = env.get(tree[1]) if tree[0] == "sym" else None
        return self.region.reduce(self._index(tree, env) if form is None else form)

    def _index(self, tree: Any, env: Mapping[str, Form]) -> Form:
        if isinstance(tree, int):
            return {"": tree} if tree else {}
        op = tree[0]
        if op == "sym" and tree[1] in env:
            return env[tree[1]]
        if op == "sym" and tree[1] in self.statement["sizes"]:
            return {tree[1]: 1}
        if op == "sym" and (d := self.definitions.get(tree[1])) and d[0] == "let" and not d[2]:
            return self._index(d[3], {})
        if op in ("+", "-"):
            total = self._index(tree[1], env)
            for part in tree[2:]:
                total = plus(total, self._index(part, env), 1 if op == "+" else -1)
            return total
        if op == "neg":
            return plus({}, self._index(tree[1], env), -1)
        if op == "*" and len(tree) == 3 and type(tree[1]) is int:
            return plus({}, self._index(tree[2], env), tree[1])
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
        if self.is_matrix(tree) and not self._is_power_of_number(tree, env):
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
            if abs(tree[2]) > _LARGEST_POWER:
                raise Unknown("too large a power")
            out, x = self.number(1), self.value(tree[1], env)
            for _ in range(abs(tree[2])):
                out = out * x
            return out if tree[2] >= 0 else out.inverse()
        if op == "if":
            return self.value(tree[2] if self.condition(tree[1], env) else tree[3], env)
        if op == "coeff":
            return self.coefficient(tree[1], self.index(tree[2], env), env)
        if op in ("det", "laurent"):
            return self.opaque(tree, env)
        if op == "sum":
            return self._sum(tree, env, self.value)
        if op == "prod":
            _, name, low, high, body = tree
            return self.product(self.index(low, env), self.index(high, env), lambda inner, j: inner._reread(inner.value, body, {**env, name: j}))
        if op == "sym":
            if tree[1] in env or tree[1] in self.statement["sizes"]:
                return self.linear(self.index(tree, env))
            if tree[1] in self.scalars:
                return self.atom(("at", tree[1]))
            return self._call(tree[1], (), self.value)
        if op == "at" and self.known.is_named_matrix(tree[1]):
            i, j = (*(self.index(a, env) for a in tree[2:]), {"": 1})[:2]
            self._need_place(["sym", tree[1]], i, j, {})
            return self.entry(["sym", tree[1]], i, j, {})
        if op == "at":
            return self._call(tree[1], tuple(self.index(a, env) for a in tree[2:]), self.value)
        if op == "entry":
            i, j = self.index(tree[2], env), self.index(tree[3], env) if len(tree) > 3 else {"": 1}
            self._need_place(tree[1], i, j, env)
            return self.entry(tree[1], i, j, env)
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
            return self._product([(tree, env, False, 1)], m)
        if op == "rev":
            return self.coefficient(tree[1], self.region.reduce(plus(self.index(tree[2], env), m, -1)), env)
        if op == "recip":
            return self.coefficient(tree[1], plus({}, m, -1), env)
        if op == "charpoly" and not self.has_z(tree[1]):
            return self.opaque(tree, env, m)
        if op == "if":
            return self.coefficient(tree[2] if self.condition(tree[1], env) else tree[3], m, env)
        if op == "sum":
            return self._sum(tree, env, lambda body, inner: self.coefficient(body, m, inner))
        if op == "sym" and self.known.kinds.get(tree[1], ("",))[0] in ("poly", "monic"):
            return self._variable(tree[1], m)
        if op == "sym":
            return self._call(tree[1], (), lambda body, inner: self.coefficient(body, m, inner), m)
        if op == "at":
            return self._call(tree[1], tuple(self.index(a, env) for a in tree[2:]), lambda body, inner: self.coefficient(body, m, inner), m)
        raise Unknown(f"{op!r} of polynomials at a generic index")

    def _product(self, parts: list[tuple[Any, Mapping[str, Form], bool, int]], m: Form) -> Symbolic:
        """Coefficient of a product of terms, each with its indices, whether 1/z stands for z, and an exponent 1 or -1.

        All but one are free of z or powers of z, once sums are multiplied out and names replaced by what they stand for.
        """
        factor, rest, parts = self.number(1), list[tuple[Any, Mapping[str, Form], bool, int]](), list(parts)
        while parts:
            x, env, flip, e = parts.pop(0)
            if not self.has_z(x):
                value = self.value(x, env)
                factor = factor * (value if e > 0 else value.inverse())
            elif self.is_matrix(x) and self.shape(x, env) != ({"": 1}, {"": 1}):
                raise Unknown("a matrix in a product of polynomials")
            elif x[0] in ("*", "/"):
                parts = [(y, env, flip, -e if k and x[0] == "/" else e) for k, y in enumerate(x[1:])] + parts
            elif x[0] == "recip":
                parts.insert(0, (x[1], env, not flip, e))
            elif x == ["z"] or (x[0] == "^" and x[1] == ["z"]):
                m = self.region.reduce(plus(m, self.index(x[2], env) if len(x) > 1 else {"": 1}, e if flip else -e))
            elif e > 0:
                rest.append((x, env, flip, e))
            else:
                raise Unknown("a quotient by a polynomial at a generic index")
        if not rest:
            return factor * self.number(int(self.region.zero(m)))
        if len(rest) == 1:
            x, env, flip, _ = rest[0]
            return factor * self.coefficient(x, plus({}, m, -1) if flip else m, env)
        return factor * self._several(rest, m)

    def _several(self, rest: list[tuple[Any, Mapping[str, Form], bool, int]], m: Form) -> Symbolic:
        """The same for two factors or more that depend on z: a sum is multiplied out, or a name replaced."""
        for place, (x, env, flip, e) in enumerate(rest):
            def put(body: Any, inner: Mapping[str, Form], k: int = place, flip: bool = flip, e: int = e) -> Symbolic:
                return self._product([*rest[:k], (body, inner, flip, e), *rest[k + 1:]], m)

            if x[0] in ("+", "-", "neg"):
                out = self.number(0)
                for k, y in enumerate(x[1:]):
                    term = put(y, env)
                    out = out - term if x[0] == "neg" or (x[0] == "-" and k) else out + term
                return out
            if x[0] == "if":
                return put(x[2] if self.condition(x[1], env) else x[3], env)
            if x[0] == "sum":
                return self._sum(x, env, put)
            if x[0] in ("sym", "at") and (d := self.definitions.get(x[1])) and x[1] not in self.whole | self.closed:
                args = tuple(self.index(a, env) for a in x[2:])
                if x[1] not in self.recursive or self._opens(d, args[-1]):
                    if x[1] in self.inverting:
                        self._meet(x[1], args)
                    return self.deeper(d, args, put)
        for k, (x, env, flip, _) in enumerate(rest):
            if (degree := self._degree(x, env)) is not None:
                others = [*rest[:k], *rest[k + 1:]]
                return self.total({}, degree, lambda _, j, x=x, env=env, flip=flip, others=others: (  # type: ignore[misc]
                    self.coefficient(x, j, env) * self._product(others, self.region.reduce(plus(m, j, 1 if flip else -1)))))
        raise Unknown("a product of polynomials at a generic index")

    def _degree(self, tree: Any, env: Mapping[str, Form]) -> Form | None:
        """A number d if a name stands for a polynomial with exponents 0 .. d."""
        if tree[0] == "sym" and (kind := self.known.kinds.get(tree[1])) and kind[0] in ("poly", "monic"):
            return self.index(kind[1], {})
        if tree[0] == "at" and tree[1] in self.supported and not self.limited and self.region.holds(last := self.index(tree[-1], env)):
            return last
        return None

    def _variable(self, name: str, m: Form) -> Symbolic:
        """Coefficient of a variable that is a polynomial."""
        kind, degree = self.known.kinds[name][0], self.index(self.known.kinds[name][1], {})
        gap = plus(degree, m, -1)
        if not self.region.holds(m) or not self.region.holds(gap):
            return self.number(0)
        if kind == "monic" and self.region.zero(gap):
            return self.number(1)
        return self.atom(("coeff", name, form_key(self.region.reduce(m))))

    def at_z(self, tree: Any, env: Mapping[str, Form], flip: bool = False) -> Symbolic:
        """A polynomial as a function of z (of 1/z): an element of a field with the automorphism z -> 1/z."""
        if not self.has_z(tree):
            return self.value(tree, env)
        if self.is_matrix(tree) and self.shape(tree, env) != ({"": 1}, {"": 1}):
            raise Unknown("a matrix as a function of z")
        op = tree[0]
        if op == "z":
            return self.atom(("at", "z")).inverse() if flip else self.atom(("at", "z"))
        if op == "recip":
            return self.at_z(tree[1], env, not flip)
        if op == "neg":
            return -self.at_z(tree[1], env, flip)
        if op == "charpoly" and not self.has_z(tree[1]):
            return self._function(tree, env, flip)
        if op == "*" and any(self.shape(x, env) != ({"": 1}, {"": 1}) for x in tree[1:]):
            scalars, chain = self._factors(tree, env)
            out = self.number(1)
            for part in (*scalars, chain):
                x = ["*", *part] if len(part) > 1 else part[0] if part else 1
                out = out * (self._function(x, env, flip) if len(part) > 1 and self.has_z(x) else self.at_z(x, env, flip))
            return out
        if op in ("+", "-", "*", "/"):
            out = self.at_z(tree[1], env, flip)
            for part in tree[2:]:
                y = self.at_z(part, env, flip)
                out = out + y if op == "+" else out - y if op == "-" else out * y if op == "*" else out / y
            return out
        if op == "^" and isinstance(tree[2], int) and 0 <= tree[2] <= _LARGEST_POWER:
            out, x = self.number(1), self.at_z(tree[1], env, flip)
            for _ in range(tree[2]):
                out = out * x
            return out
        if op == "^" and tree[1] == ["z"]:
            form = self.index(tree[2], env)
            return self.power_of_z(plus({}, form, -1) if flip else form)
        if op == "if":
            return self.at_z(tree[2] if self.condition(tree[1], env) else tree[3], env, flip)
        if op == "sum":
            return self._sum(tree, env, lambda body, inner: self.at_z(body, inner, flip))
        if op in ("sym", "at"):
            return self.named_at_z(tree[1], tuple(self.index(a, env) for a in tree[2:]), flip)
        raise Unknown(f"{op!r} as a function of z")

    def _function(self, tree: Any, env: Mapping[str, Form], flip: bool) -> Symbolic:
        """A function of z as it is: a characteristic polynomial, or a product of matrices that is a number."""
        text, forms = opaque(tree, env, self.index)
        if self.within is not None:
            raise Unknown("a recursion made of functions of z that are not opened")
        if self.inverts(tree):
            self._meet(text, forms)
        return self.atom(("value at 1/z" if flip else "value", text, *(form_key(self.region.reduce(x)) for x in forms)))

    def power_of_z(self, form: Form) -> Symbolic:
        """z to an index: a power of z itself for the constant, and for each parameter a power of z^parameter; z^(c j) as it is for the index j of a sum."""
        form = self.region.reduce(form)
        out, z = self.number(1), self.atom(("at", "z"))
        for name, c in form.items():
            if abs(c) > _LARGEST_POWER:
                raise Unknown("too large a power")
            if name.startswith("#"):
                out = out * self.atom(("power", "z", ((name, c),)))
                continue
            x = self.atom(("power", "z", ((name, 1),))) if name else z
            for _ in range(abs(c)):
                out = out * x if c > 0 else out / x
        return out

    def named_at_z(self, name: str, args: tuple[Form, ...], flip: bool) -> Symbolic:
        """What a name stands for as a function of z (of 1/z): a variable and what is closed as it is, a recursion where it is not opened."""
        kind = "value at 1/z" if flip else "value"
        if name in self.closed or self.known.kinds.get(name, ("",))[0] in ("poly", "monic"):
            if name in self.inverting:
                self._meet(name, args)
            return self.atom((kind, name, *map(form_key, args)))
        if name in self.definitions:
            return self._call(name, args, lambda body, inner: self.at_z(body, inner, flip), kind=kind)
        raise Unknown(f"{name!r} as a function of z")

    def opaque(self, tree: Any, env: Mapping[str, Form], *place: Form) -> Symbolic:
        """The value of a term that is not opened, or its coefficient or entry at a place."""
        text, forms = opaque(tree, env, self.index)
        if self.hides(tree, env):
            raise Unknown("a recursion in a term that is not opened, at an index that may not be smaller")
        if self.inverts(tree):
            self._meet(text, forms)
        return self.atom(("opaque", text, *(form_key(self.region.reduce(x)) for x in (*forms, *place))))

    def inverts(self, tree: Any) -> bool:
        """Whether a term contains an inverse."""
        return inverts(tree, self.inverting)

    def _meet(self, name: str, forms: Any) -> None:
        key = (name, *(form_key(self.region.reduce(x)) for x in forms))
        if any(n.startswith("#") for form in key[1:] for n, _ in form):
            raise Unknown("an inverse that depends on the index of a sum")
        self.met.add(key)
        if not self.perhaps:
            self.sure.add(key)

    # ------------------------------------------------------------------ definitions
    def _call(self, name: str, args: tuple[Form, ...], read: Callable, m: Form | None = None, place: tuple[Form, ...] = (), kind: str = "at") -> Symbolic:
        """The value of a name (of the kind of atoms that it is), its coefficient at m, or its entry at a place: once in each region, with the inverses
        met and what is divided by then."""
        if name in self.sequences:
            return self.atom(("at", name, *map(form_key, args)))
        key = (self.region, kind, name, *map(form_key, args), m is not None and form_key(m), *map(form_key, place))
        if key not in self.called:
            before = self.met, self.sure, self.perhaps, self.field.used
            self.met, self.sure, self.perhaps, self.field.used = set(), set(), 0, set()
            try:
                self.called[key] = self._called(name, args, read, m, place, kind), self.met, self.sure, self.field.used
            finally:
                before[0].update(self.met)
                self.met, self.sure, self.perhaps, self.field.used = before
        out, met, sure, used = self.called[key]
        self.met |= met
        self.field.used |= used
        if not self.perhaps:
            self.sure |= sure
        return out

    def _called(self, name: str, args: tuple[Form, ...], read: Callable, m: Form | None, place: tuple[Form, ...], value: str) -> Symbolic:
        """A definition, opened where its arguments allow it; else an atom of the kind of values (its coefficient at m, or its entry at a place)."""
        d = self.definitions.get(name)
        if d is None:
            raise Unknown(f"{name!r} at a generic index")
        last = args[-1] if args else {}
        if d[0] == "rec":
            self._need_one_shape(d)
        if name in self.inverting:
            self._meet(name, args)
        if m is not None and name in self.whole:
            return self.atom(("coeff", name, *map(form_key, args), form_key(self.region.reduce(m))))
        if name in self.closed and args and m is None and not place and name not in self.recursive | self.in_z:
            return self.atom(("at", name, *map(form_key, args)))
        if name in self.recursive:
            if (found := self._solved(name, args, read)) is not None:
                return found
            if m is not None and name in self.supported and self._outside(last, m):
                return self.number(0)
            if not self._opens(d, last):
                if self.not_smaller(name, last):
                    raise Unknown(f"{name} at an index that is not smaller")
                kind, where = ("coeff", (m,)) if m is not None else ("entry", place) if place else (value, ())
                return self.atom((kind, name, *map(form_key, args), *(form_key(self.region.reduce(x)) for x in where)))
        return self.deeper(d, args, read)

    def not_smaller(self, name: str, last: Form) -> bool:
        """A value that may not be used, in a look at what a recursion is made of."""
        return self.within is not None and name in self.within[1] and self.region.decide(plus(self.within[0], last, -1)) is not True

    def hides(self, tree: Any, env: Mapping[str, Form]) -> bool:
        """Whether a term that is not opened may contain such a value."""
        if self.within is None or not isinstance(tree, list):
            return False
        env = {name: form for name, form in env.items() if name not in tree[1:]} if tree and isinstance(tree[0], str) else env  # what is bound here
        if tree[:1] not in (["sym"], ["at"]) or tree[1] not in self.within[1]:
            return any(self.hides(x, env) for x in tree)
        if tree[0] == "sym" or self.definitions[tree[1]][0] != "rec":
            return True
        try:
            return self.not_smaller(tree[1], self.index(tree[2], env))
        except Unknown:
            return True

    def deeper(self, d: Any, args: tuple[Form, ...], read: Callable) -> Symbolic:
        """What a definition says, unless too many are open."""
        self.depth += 1
        try:
            if self.depth > _MOST_OPEN:
                raise Unknown(f"definition of {d[1]} does not end")
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

    def defining(self, name: str, args: tuple[Form, ...], places: Mapping[str, Form]) -> Symbolic:
        """A value of a recursive definition (its coefficient or entry at a place), less what defines it there."""
        d = self.definitions.get(name)
        kept = name in self.letters or name in self.whole & self.in_z  # without indices too
        if d is None or name not in self.recursive | self.closed | self.whole or name in self.unused or not (args or kept):
            raise Unknown(f"no definition of {name} to be used there")
        if not all(self.region.holds(a) for a in args) or d[0] == "rec" and not self.region.holds(plus(args[0], {"": d[3] + len(d[4])}, -1)):
            raise Unknown(f"the definition of {name} says nothing there")
        if name in self.in_z and self.in_values:
            flip = "flip" in places
            return self.named_at_z(name, args, flip) - self._open(d, args, lambda body, inner: self.at_z(body, inner, flip))
        if name in self.in_z:
            m = places["z"]
            read: Callable = lambda body, inner: self.coefficient(body, m, inner)
            return self._call(name, args, read, m) - self._open(d, args, read)
        if name in self.letters:
            i, j = places["row"], places.get("column", {"": 1})
            tree, env = ["at", name, *(["sym", f"@{k}"] for k in range(len(args)))] if args else ["sym", name], {f"@{k}": x for k, x in enumerate(args)}
            self._need_entry(tree, i, j, env)
            return self.entry(tree, i, j, env) - self._open(d, args, lambda body, inner: self.entry(body, i, j, inner))
        if d[0] == "rec" and self.is_matrix(d[4][0]):
            place = (places["row"], *([places["column"]] if self.shape(d[4][0], {})[1] != {"": 1} else []))
            self._need_place(["sym", name], place[0], place[1] if len(place) > 1 else {"": 1}, {})
            read = lambda body, inner: self.entry(body, place[0], place[1] if len(place) > 1 else {"": 1}, inner)
            return self._call(name, args, read, place=place) - self._open(d, args, read)
        return self.atom(("at", name, *map(form_key, args))) - self._open(d, args, self.value)

    def _opens(self, d: Any, last: Form) -> bool:
        """At an integer not before the start, or at an index that is >= 0, as that of the induction, plus a positive integer."""
        least = d[3] if d[0] == "rec" else 0
        c = last.get("", 0)
        if d[1] in self.unused:
            return False
        if set(last) <= {""}:
            return c >= least and (d[0] == "let" or d[1] not in self.whole or c < least + len(d[4]))
        return (d[1] not in self.closed | self.whole and len(last) == 2 and any(last.get(x) == 1 for x in self.always)
                and c >= (max(1, least + len(d[4])) if d[0] == "rec" else 1))

    def _solved(self, name: str, args: tuple[Form, ...], read: Callable) -> Symbolic | None:
        least, names, high, term = self.rules.get(name, (0, (), None, None))
        if not names or len(args) != len(names) or any(self.region.decide(x) is not True for x in args[:-1]):
            return None
        if high is not None and self.region.decide(plus(self.index(high, {}), args[-1], -1)) is not True:
            return None
        if (args[-1] == {INDEX: 1}) if least is None else self.region.decide(plus(args[-1], {"": least}, -1)):
            before, self.met, sure = self.met, set(), set(self.sure)
            found = read(term, dict(zip(names, args, strict=True)))
            if not self.met <= sure:  # one met before in a sum that may be empty need not exist either
                raise Unknown("a rule with an inverse, which need not exist where the rule is used")
            self.met |= before
            return found
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

    # ------------------------------------------------------------------ matrices
    def _is_power_of_number(self, tree: Any, env: Mapping[str, Form]) -> bool:
        return tree[0] == "^" and isinstance(tree[2], int) and self.shape(tree[1], env) == ({"": 1}, {"": 1})

    def shape(self, tree: Any, env: Mapping[str, Form]) -> tuple[Form, Form]:
        """Numbers of rows and columns; a scalar is 1 x 1."""
        key = id(tree), id(env), self.region
        if (found := self.shaped.get(key)) is None:
            found = self.shaped[key] = self._shape(tree, env), tree, env  # which are kept, so that their ids stay their own
        return found[0]

    def _shape(self, tree: Any, env: Mapping[str, Form]) -> tuple[Form, Form]:
        if not self.is_matrix(tree):
            if self.others(tree):
                self._need_number(tree, env)
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
            return self._blocks(tree, env)
        if op in ("sym", "at"):
            d: Any = self.definitions.get(tree[1], ("",))
            if op == "sym" and tree[1] not in self.recursive or d[0] == "rec":  # whatever the indices are
                if d[0] == "rec":
                    self._need_one_shape(d)
                if (self.region, tree[1]) not in self.shapes:
                    self.shapes[self.region, tree[1]] = self._shape_of_name(tree[1], d)
                return self.shapes[self.region, tree[1]]
            inner = dict(zip(d[2], (self.index(a, env) for a in tree[2:]), strict=True)) if op == "at" else {}
            if d[1] in self.recursive:  # what a first branch gives
                self._need_one_shape(d)
                return self.shape(d[3][2], inner)
            return self.shape(d[3], inner)
        if op == "/":
            return self.shape(tree[1], env)
        if op in ("^", "inv", "subst"):
            rows, cols = self.shape(tree[2 if op == "subst" else 1], env)
            if self.region.reduce(plus(rows, cols, -1)):
                raise Undefined("a matrix that is not square has no powers and no inverse")
            return rows, cols
        if op == "if":
            both = [self.shape(x, env) for x in tree[2:]]
            return both[0] if both[0] == both[1] else both[0 if self.condition(tree[1], env) else 1]
        if op == "sum":
            found = self._at_any(tree[1], env, lambda inner: self.shape(tree[4], inner))
            if found != ({"": 1}, {"": 1}) and self.region.decide(plus(self.index(tree[3], env), self.index(tree[2], env), -1)) is not True:
                raise Unknown("a sum of matrices without terms")  # it is the number zero
            return found
        if op == "*":
            chain = self._factors(tree, env)[1]
            return (self.shape(chain[0], env)[0], self.shape(chain[-1], env)[1]) if chain else ({"": 1}, {"": 1})
        shapes = [self.shape(x, env) for x in tree[1:]]
        if any(self.region.reduce(plus(x, y, -1)) for s in shapes[1:] for x, y in zip(s, shapes[0], strict=True)):
            raise Undefined("sizes do not fit")
        return shapes[0]

    def _shape_of_name(self, name: str, d: Any) -> tuple[Form, Form]:
        """Numbers of rows and columns of a variable, a definition without indices, or the values of a recursion."""
        if kind := self.known.kinds.get(name):
            return self.index(kind[1], {}), self.index(kind[-1], {}) if kind[0] in MATRICES else {"": 1}
        return self.shape(d[4][0] if d[0] == "rec" else d[3], {})

    def _need_number(self, tree: Any, env: Mapping[str, Form]) -> None:
        """A term that is not known to be a number is made of matrices of one row and column."""
        if tree[0] not in OF_PARTS:
            raise Unknown("the size of a term that may be a matrix")

        def read(x: Any) -> tuple[Form, Form]:
            return self._at_any(tree[1], env, lambda inner: self.shape(x, inner)) if tree[0] in ("sum", "prod") else self.shape(x, env)

        if any(read(x) != ({"": 1}, {"": 1}) for x in tree[OF_PARTS[tree[0]]]):
            raise Unknown("the size of a term that may be a matrix")

    def _at_any(self, name: str, env: Mapping[str, Form], shape: Callable[[Mapping[str, Form]], tuple[Form, Form]]) -> tuple[Form, Form]:
        """The shape that a term has whatever an index is: nothing is known of a parameter that stands for it, nor decided by cases."""
        free = f"#{self.nested}"
        self.nested += 1
        try:
            found = shape({**env, name: {free: 1}})
        except Split as split:
            if free in split.form:
                raise Unknown("a sum of matrices of different sizes") from None
            raise
        finally:
            self.nested -= 1
        if any(free in form for form in found):
            raise Unknown("a sum of matrices of different sizes")
        return found

    def _blocks(self, tree: Any, env: Mapping[str, Form]) -> tuple[Form, Form]:
        """Size of a block matrix, whose blocks fit."""
        shapes = [[self.shape(x, env) for x in row] for row in tree[1:]]
        if any(self.region.reduce(plus(h, row[0][0], -1)) for row in shapes for h, _ in row) or any(
                len(row) != len(shapes[0]) or any(self.region.reduce(plus(w, v, -1)) for (_, w), (_, v) in zip(row, shapes[0], strict=True)) for row in shapes):
            raise Undefined("sizes of blocks do not fit")
        height, width = Form(), Form()
        for row in shapes:
            height = plus(height, row[0][0])
        for _, w in shapes[0]:
            width = plus(width, w)
        return height, width

    def _need_one_shape(self, d: Any) -> None:
        """All values of a recursion have the shape of the first, or of the first branch: an induction in which those of the values before are supposed."""
        name, region = d[1], self.region
        if name not in self.kept:
            self.kept[name], self.region = True, Region.of()
            try:
                first, *others = (self.shape(tree, env) for tree, env in _branches(d))
                keeps = all(shape == first for shape in others)
            except (Unknown, Undefined, Split, KeyError):
                keeps = False
            finally:
                self.region = region
            if not keeps:  # what has been seen of others may rest on it
                self.kept.clear()
                self.shapes.clear()
                self.shaped.clear()
                self.kept[name] = False
        if not self.kept[name]:
            raise Unknown(f"recursion {name} does not keep the shape of its initial value")

    def _need_place(self, tree: Any, i: Form, j: Form, env: Mapping[str, Form]) -> None:
        """Beyond its rows and columns a matrix has no entry; continued by what defines it, it is neither what a rule says that it is there nor
        what it is where it is not opened."""
        if not (self.ruled or self.letters) or self.known.reached_by(tree).isdisjoint(self.ruled | self.letters):
            return
        self._need_entry(tree, i, j, env)

    def _need_entry(self, tree: Any, i: Form, j: Form, env: Mapping[str, Form]) -> None:
        """Beyond its rows and columns a matrix has no entry."""
        rows, cols = self.shape(tree, env)
        if not all(self.region.holds(plus(x, y, -1)) for x, y in ((i, {"": 1}), (rows, i), (j, {"": 1}), (cols, j))):
            raise Undefined("no entry there")

    def entry(self, tree: Any, i: Form, j: Form, env: Mapping[str, Form]) -> Symbolic:
        """Entry (i, j) of a matrix, counted from 1."""
        op = tree[0]
        if op not in ("mat", "col", "block") and self.has_letters(tree):
            return self.word([(tree, env, False)], i, j)
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
            self._blocks(tree, env)
            for row in tree[1:]:
                height = self.shape(row[0], env)[0]
                if not self.region.holds(plus(height, i, -1)):
                    i = self.region.reduce(plus(i, height, -1))
                    continue
                for x in row:
                    width = self.shape(x, env)[1]
                    if self.region.holds(plus(width, j, -1)):
                        return self.entry(x, i, j, env) if self.is_matrix(x) else self.value(x, env)
                    j = self.region.reduce(plus(j, width, -1))
                break
            raise Undefined("no entry there")
        if op == "/":
            return self.entry(tree[1], i, j, env) / self.value(tree[2], env)
        if op == "if":
            return self.entry(tree[2 if self.condition(tree[1], env) else 3], i, j, env)
        if op == "sum":
            return self.matrix_sum(tree, env, lambda body, inner: self.entry(body, i, j, inner))
        if self._is_power_of_number(tree, env):
            return self.value(tree, env)
        if op in ("inv", "^", "subst"):
            return self._chain([tree], i, j, env)
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
        todo = list(tree[1:])
        while todo:
            x = todo.pop(0)
            mine = self.shape(x, env)
            if not isinstance(x, int) and x[0] == "*" and mine != one:  # (AB)C = A(BC); a product of size 1 x 1 is a number
                todo = [*x[1:], *todo]
                continue
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
        """Entry (i, j) of a product; one with an inverse, a power, p(F) or a matrix variable is a sum of words."""
        if len(parts) == 1 and not self.is_matrix(parts[0]):
            return self.value(parts[0], env)
        if any(not isinstance(x, int) and x[0] in ("inv", "^", "subst") and not self._is_power_of_number(x, env) for x in parts) or (
                any(self.has_letters(x) for x in parts)):
            return self.word([(x, env, False) for x in parts], i, j)
        if len(parts) == 1:
            return self.entry(parts[0], i, j, env)
        _, width = self.shape(parts[0], env)
        return self.total({"": 1}, width, lambda terms, k: terms.entry(parts[0], i, k, env) * terms._chain(parts[1:], k, j, env))


_GAPS: dict[str, Callable[[Region, Form], bool]] = {
    "=": lambda r, f: r.zero(f), "!=": lambda r, f: not r.zero(f), ">=": lambda r, f: r.holds(f),
    ">": lambda r, f: r.holds(plus(f, {"": 1}, -1)), "<=": lambda r, f: r.holds(plus({}, f, -1)), "<": lambda r, f: not r.holds(f),
}


@lru_cache(maxsize=1 << 12)
def _atom_text(key: tuple) -> str:
    if key[0] in ("opaque", "word"):
        return f"<{key[1]}>[{', '.join(_form_text(x) for x in key[2:])}]"
    if key[0] in BOUND:
        monomials = [(key[1], 1)] if key[0] == "sum" else key[1]
        body = " + ".join("*".join([*([str(c)] if c != 1 or not m else []), *(_atom_text(k) for k, e in m for _ in range(e))]) for m, c in monomials)
        return f"{key[0]}({body}, {_form_text(key[2])})"
    if key[0] == "power":
        return f"z^({_form_text(key[2])})"
    name = f"{key[1]}(1/z)" if key[0] == "value at 1/z" else key[1]
    return f"{name}[{', '.join(_form_text(x) for x in key[2:])}]" if len(key) > 2 else name


def _form_text(form: tuple) -> str:
    parts = [n.replace(INDEX, "t") if c == 1 else f"{c}{n.replace(INDEX, 't')}" for n, c in form if n]
    constant = dict(form).get("", 0)
    return "+".join([*parts, *([str(constant)] if constant or not parts else [])]).replace("+-", "-")


def _first(d: Any) -> Any:
    """A term that is a matrix if the values of a definition are."""
    return d[4][0] if d[0] == "rec" else d[3]


def _branches(d: Any) -> list[tuple[Any, dict[str, Form]]]:
    """Initial values and the step of a recursion; both branches of a function that is given by cases."""
    if d[0] == "rec":
        return [*((x, {}) for x in d[4]), (d[5], {d[2]: {INDEX: 1}})]
    if d[3][0] != "if":
        raise Unknown(f"the shape of {d[1]}")
    return [(x, {p: {f"@{p}": 1} for p in d[2]}) for x in d[3][2:]]
