# SPDX-License-Identifier: MIT
"""Recursions of growing degree, for every index at once: coefficients and sums at a generic index.

A polynomial of degree t, a sum of t terms or a matrix of size n has no fixed shape. What has one
is a coefficient phi_t[m] at a generic place m, and the indefinite sum F of a summand f: the sum
of f(lo), .., f(hi) is F(hi) - F(lo - 1), and F(j + 1) = F(j) + f(j + 1). So an equation becomes
an identity of rational functions in atoms

    gamma[t],  r[t],  phi_t[m],  F[j]        with linear forms in t, m, .. for indices,

in each of finitely many regions of the integer parameters (k < t, k = t, ..). Sequences may be
thought of as continued to all integers in any way: what lies outside cancels.

An index that stands as a number is a linear form in atoms, one for each parameter, of which nothing is known: what is shown holds whatever they are.

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
from exactkf.kernel.generic_matrices import Matrices, first_value
from exactkf.kernel.generic_polynomials import LARGEST_POWER, Polynomials
from exactkf.kernel.indefinite import BOUND, Indefinite
from exactkf.kernel.known import inverts, known
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.packed import BITS
from exactkf.kernel.region import INDEX, Form, Region, form_key, plus
from exactkf.kernel.symbolic import Symbolic, SymbolicField

__all__ = ["Terms"]

_MOST_OPEN = 60  # definitions opened within each other


# ---------------------------------------------------------------------- terms
class Terms(Indefinite, Polynomials, Matrices, Chains):
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
        self.known = known(statement)
        self.definitions, self.sequences, self.scalars = self.known.definitions, self.known.sequences, self.known.scalars
        self.has_z, self.is_matrix = self.known.has_z, self.known.is_matrix
        self.recursive, self.in_z, self.inverting, self.kept = self.known.recursive, self.known.in_z, self.known.inverting, self.known.kept
        self.letters = self.closed and self.known.spread({name for name in self.closed & self.definitions.keys() if self.known.is_matrix_function(name)})
        self.met: set[tuple] = set()  # inverses that what has been read contains, also where they cancel: it has a value where they exist
        self.sure: set[tuple] = set()  # those that are not only in sums which may be empty: where it has a value they exist
        self.ruled = {name for name, rule in self.rules.items() if self.is_matrix(rule[3]) or self.is_matrix(first_value(self.definitions[name]))}
        self.field = SymbolicField()
        self.atoms: list[tuple] = []
        self.places: dict[tuple, int] = {}
        self.nested = self.perhaps = 0
        self.called: dict[tuple, tuple[Symbolic, set[tuple], set[tuple], set[int]]] = {}
        self.shapes = self.known.shapes
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
        return self.known.has_letters(tree) or bool(self.letters) and not self.letters.isdisjoint(self.known.names_in(tree))

    # ------------------------------------------------------------------ indices and conditions
    def index(self, tree: Any, env: Mapping[str, Form]) -> Form:
        if type(tree) is int:
            return {"": tree} if tree else {}
        form = env.get(tree[1]) if tree[0] == "sym" else None
        form, region = self._index(tree, env) if form is None else form, self.region
        return region.reduce(form) if region.solved else form

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
            if abs(tree[2]) > LARGEST_POWER:
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

    def opaque(self, tree: Any, env: Mapping[str, Form], *place: Form) -> Symbolic:
        """The value of a term that is not opened, or its coefficient or entry at a place."""
        text, forms = self.text(tree, env)
        if self.hides(tree, env):
            raise Unknown("a recursion in a term that is not opened, at an index that may not be smaller")
        if self.inverts(tree):
            self._meet(text, forms)
        return self.atom(("opaque", text, *(form_key(self.region.reduce(x)) for x in (*forms, *place))))

    def text(self, tree: Any, env: Mapping[str, Form]) -> tuple[str, list[Form]]:
        """Text and indices of a term that is not opened."""
        text, places, free = self.known.without_indices(tree)
        if not free.isdisjoint(env):
            raise Unknown("an index as a number, or beside one inside, in a term that is not opened")
        return text, [self.index(x, env) for x in places]

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
        nothing = not args and name in self.known.reached.get(name, ())  # it leads back to itself, and need not define anything
        if d is None or name not in self.recursive | self.closed | self.whole or name in self.unused or nothing or not (args or kept):
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
