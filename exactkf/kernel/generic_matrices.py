# SPDX-License-Identifier: MIT
"""Matrices at a generic index: numbers of rows and columns, and entries.

Sizes are linear forms in the parameters; where two must be the same they are compared in the region. An entry of a product is a sum over an
index, or of words where a factor is not opened (`exactkf.kernel.chains`).

Main definitions
----------------
`Matrices`
    What `exactkf.kernel.generic.Terms` does with matrices.
`first_value`
    A term that shows whether a definition stands for matrices.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from exactkf.kernel.generic_reading import Reading
from exactkf.kernel.known import MATRICES, OF_PARTS
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.region import INDEX, Form, Region, Split, form_key, plus
from exactkf.kernel.symbolic import Symbolic

__all__ = ["Matrices", "first_value"]

_ONE: Form = {"": 1}
_NUMBER = _ONE, _ONE  # rows and columns


class Matrices(Reading):
    """Shapes and entries in a region; the rest of the reading of terms is elsewhere."""

    def _is_power_of_number(self, tree: Any, env: Mapping[str, Form]) -> bool:
        return tree[0] == "^" and isinstance(tree[2], int) and self.shape(tree[1], env) == _NUMBER

    def shape(self, tree: Any, env: Mapping[str, Form]) -> tuple[Form, Form]:
        """Numbers of rows and columns; a scalar is 1 x 1."""
        if not isinstance(tree, int) and tree[0] == "sym" and (shape := self.shapes.get((self.region, tree[1]))) is not None:
            return shape
        key = id(tree), id(env), self.region
        if (found := self.shaped.get(key)) is None:
            found = self.shaped[key] = self._shape(tree, env), tree, env  # which are kept, so that their ids stay their own
        return found[0]

    def _shape(self, tree: Any, env: Mapping[str, Form]) -> tuple[Form, Form]:
        if not self.is_matrix(tree):
            if not self.known.is_number(tree):
                self._need_number(tree, env)
            return _NUMBER
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
            if found != _NUMBER and self.region.decide(plus(self.index(tree[3], env), self.index(tree[2], env), -1)) is not True:
                raise Unknown("a sum of matrices without terms")  # it is the number zero
            return found
        if op == "*":
            chain = self._factors(tree, env)[1]
            return (self.shape(chain[0], env)[0], self.shape(chain[-1], env)[1]) if chain else _NUMBER
        shapes = [self.shape(x, env) for x in tree[1:]]
        if any(x != y and self.region.reduce(plus(x, y, -1)) for s in shapes[1:] for x, y in zip(s, shapes[0], strict=True)):
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

        if any(read(x) != _NUMBER for x in tree[OF_PARTS[tree[0]]]):
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
        self._need_within(i, rows, j, cols)

    def _need_within(self, i: Form, rows: Form, j: Form, cols: Form) -> None:
        """A row and a column that there are."""
        if not all(self.region.holds(plus(x, y, -1)) for x, y in ((i, _ONE), (rows, i), (j, _ONE), (cols, j))):
            raise Undefined("no entry there")

    def _need_first(self, j: Form) -> None:
        """A column of numbers is named by its rows: it has no other column, not even beyond its rows."""
        if self.region.reduce(plus(j, _ONE, -1)):
            raise Undefined("no entry there")

    def _are_matrices(self, scalars: list[list]) -> bool:
        """Whether one of the products of size 1 x 1 is made of matrices."""
        return any(self.is_matrix(x) for part in scalars for x in part)

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
            if self._are_matrices(scalars):  # for another size the same term is no number, and beyond its places another one
                self._need_entry(tree, i, j, env)
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
            self._need_entry(tree, i, j, env)
            return self.value(tree, env)
        if op in ("inv", "^", "subst"):
            return self._chain([tree], i, j, env)
        if op in ("sym", "at"):
            if tree[1] in self.sequences:
                self._need_first(j)
                return self.atom(("at", tree[1], form_key(i)))
            d = self.definitions[tree[1]]
            if d[0] == "rec":
                place = (i, j) if self.shape(d[4][0], {})[1] != {"": 1} else (i,)
                if len(place) == 1:
                    self._need_first(j)
                return self._call(tree[1], (self.index(tree[2], env),), lambda body, inner: self.entry(body, i, j, inner), place=place)
            return self.entry(d[3], i, j, dict(zip(d[2], (self.index(a, env) for a in tree[2:]), strict=True)) if op == "at" else {})
        raise Unknown(f"{op!r} of matrices at a generic index")

    def _factors(self, tree: Any, env: Mapping[str, Form]) -> tuple[list[list], list]:
        """A product as products of size 1 x 1, and what is left; sizes that fit are checked."""
        one = _NUMBER
        scalars, chain, shape = list[list](), list[Any](), one
        todo = list(tree[1:])
        while todo:
            x = todo.pop(0)
            mine = self.shape(x, env)
            if not isinstance(x, int) and x[0] == "*" and mine != one:  # (AB)C = A(BC); a product of size 1 x 1 is a number
                todo = [*x[1:], *todo]
                continue
            if chain and shape != one and mine != one:
                if shape[1] != mine[0] and self.region.reduce(plus(shape[1], mine[0], -1)):
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


def first_value(d: Any) -> Any:
    """A term that is a matrix if the values of a definition are."""
    return d[4][0] if d[0] == "rec" else d[3]


def _branches(d: Any) -> list[tuple[Any, dict[str, Form]]]:
    """Initial values and the step of a recursion; both branches of a function that is given by cases."""
    if d[0] == "rec":
        return [*((x, {}) for x in d[4]), (d[5], {d[2]: {INDEX: 1}})]
    if d[3][0] != "if":
        raise Unknown(f"the shape of {d[1]}")
    return [(x, {p: {f"@{p}": 1} for p in d[2]}) for x in d[3][2:]]
