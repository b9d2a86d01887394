# SPDX-License-Identifier: MIT
"""Polynomials in z at a generic index: by coefficients, and as functions of z.

As functions of z, polynomials are elements of a field with the automorphism z -> 1/z; there z^(n - k) is z^n/z^k, powers of z to parameters being
atoms. Coefficient by coefficient a product is a sum over the exponents of a factor, where these are known: those of a variable that is a
polynomial are 0 .. d by its type (with leading coefficient one if it is monic), those of X_t are 0 .. t if that has been shown.

Main definitions
----------------
`Polynomials`
    What `exactkf.kernel.generic.Terms` does with polynomials.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from exactkf.kernel.generic_reading import Reading
from exactkf.kernel.numbers import Unknown
from exactkf.kernel.region import Form, form_key, plus
from exactkf.kernel.symbolic import Symbolic

__all__ = ["LARGEST_POWER", "Polynomials"]

#: exponents beyond it are not multiplied out
LARGEST_POWER = 1000


class Polynomials(Reading):
    """Coefficients and functions of z in a region; the rest of the reading of terms is elsewhere."""

    def coefficient(self, tree: Any, m: Form, env: Mapping[str, Form]) -> Symbolic:
        """Coefficient of z^m of a (pseudo-)polynomial."""
        if not self.has_z(tree):
            here = self.region.zero(m)
            value = self.value(tree, env) if here or self.inverts(tree) else None  # an inverse is met whatever the coefficient is
            return self.number(0) if value is None or not here else value
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
                self._need_terms(plus(self.index(x[3], env), self.index(x[2], env), -1), [*rest[:place], *rest[place + 1:]])
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
                self._need_terms(degree, others)
                return self.total({}, degree, lambda _, j, x=x, env=env, flip=flip, others=others: (  # type: ignore[misc]
                    self.coefficient(x, j, env) * self._product(others, self.region.reduce(plus(m, j, 1 if flip else -1)))))
        raise Unknown("a product of polynomials at a generic index")

    def _need_terms(self, length: Form, others: list[tuple[Any, Mapping[str, Form], bool, int]]) -> None:
        """What is multiplied by no term is not read, and the inverses in it are not met, which a function of z needs all the same."""
        if self.region.decide(length) is not True and any(self.inverts(y) for y, *_ in others):
            raise Unknown("an inverse in a product with a sum that may have no terms")

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
        if op == "^" and isinstance(tree[2], int) and 0 <= tree[2] <= LARGEST_POWER:
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
        text, forms = self.text(tree, env)
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
            if abs(c) > LARGEST_POWER:
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
