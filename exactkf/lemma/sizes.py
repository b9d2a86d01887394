# SPDX-License-Identifier: MIT
"""Sizes of the terms of a lemma.

A lemma may write I and 0 without a size. `Sizes` finds the size of every
term, puts the sizes of I and 0 in, reads ``>=`` between matrices as the order
of symmetric matrices, and refuses terms whose sizes do not fit, naming the
product, sum or equation at fault.

Main definitions
----------------
`Sizes`
    Shapes of the names of a lemma; `Sizes.formula` and `Sizes.term` complete a tree.
`Misfit`
    What does not fit, with the part of the tree at fault.

Notation
--------
A size is a linear form in the named sizes, ``(("", 1), ("n", 2))`` for 2n + 1.
A shape is `SCALAR`, or (rows, columns) where None is not known yet.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

from exactkf.kernel.numbers import Unknown
from exactkf.kernel.reader import Reader
from exactkf.language.text import text

__all__ = ["IDENTITY", "SCALAR", "Misfit", "Sizes", "size_text", "size_tree"]

Size = tuple
Shape = Any  # SCALAR, ZERO, ANY or (rows, columns)

#: the identity whose size is to be found
IDENTITY = ("I?",)
SCALAR = "a number"
ZERO = "zero"  # a number, or a matrix of any size
ANY = "any"  # an operation whose sizes are not looked at
_ONE: Size = (("", 1),)
_SQUARE = ("psd", "pd", "symmetric", "invertible", "symplectic")
_TURNED = {"<=": ">=", "<": ">"}


class Misfit(Exception):
    """Sizes that do not fit; ``tree`` is the term at fault."""

    def __init__(self, tree: Any, message: str) -> None:
        super().__init__(message)
        self.tree = tree


class Sizes:
    """Shapes of names, and the completion of terms.

    Parameters
    ----------
    sizes : sequence of str
        The named sizes.
    show : callable
        Text of a term, for messages.
    """

    def __init__(self, sizes: Sequence[str], show: Callable[[Any], str] = text) -> None:
        self.names, self.show = list(sizes), show
        self.shapes: dict[str, Shape] = dict.fromkeys(sizes, SCALAR)
        self._reader = Reader({"sizes": self.names, "over": [], "where": [], "given": []})
        self._fitted: dict[tuple, tuple] = {}  # a sum looks at its parts twice, and they at theirs

    def declare(self, name: str, kind: Sequence[Any]) -> None:
        """A variable of a type."""
        self._fitted.clear()
        if kind[0] == "matrix":
            self.shapes[name] = (self.size(kind[1]), self.size(kind[2]))
        elif kind[0] in ("symmetric", "psd", "pd", "nonsingular", "diagonal"):
            self.shapes[name] = (self.size(kind[1]),) * 2
        else:
            self.shapes[name] = SCALAR if kind[0] in ("scalar", "nonzero", "positive", "nonneg", "integer") else ANY

    def define(self, name: str, tree: Any) -> Any:
        """A definition without parameters; its completed term."""
        done, shape = self.term(tree)
        self.shapes[name] = shape
        self._fitted.clear()
        return done

    def size(self, tree: Any) -> Size:
        """A size from its tree."""
        try:
            return self._reader.size(tree)
        except (Unknown, TypeError, IndexError) as error:
            raise Misfit(tree, f"{self.show(tree)} is no size; write a sum of named sizes and whole numbers") from error

    # ------------------------------------------------------------------ formulas
    def formula(self, tree: Any) -> Any:
        """A formula with all sizes in."""
        op = tree[0] if isinstance(tree, tuple) and tree else ""
        if op in ("and", "or", "not", "=>", "<=>"):
            return (op, *(self.formula(part) for part in tree[1:]))
        if op in _SQUARE:
            return (op, self._square(tree[1], f"{self.show(tree)} needs a square matrix"))
        if op in ("=", "!=", "loewner", ">=", "<=", ">", "<"):
            return self._relation(tree)
        if op == "always":
            return (op, tree[1], self.formula(tree[2]))
        if op in ("forall", "exists", "defined", "similar", "cospectral"):
            return _plain(tree)  # not part of the grammar, and their sizes are not looked at
        raise Misfit(tree, f"{self.show(tree)} is a term; write a formula: an equation, an order such as P >= 0, or a property such as 'X invertible'")

    def _relation(self, tree: Any) -> Any:
        op = tree[0]
        parts, shape = self._alike(tree, tree[1:], None)
        if shape not in (SCALAR, ZERO, ANY) and None in shape or _is_open(parts):
            raise Misfit(tree, _undetermined(self.show(tree)))
        if shape in (SCALAR, ZERO, ANY):
            return (op, *parts)
        if op in ("=", "!="):
            return (op, *parts)
        if shape[0] != shape[1]:
            raise Misfit(tree, f"the order {self.show(tree)} compares {_shape_text(shape)} matrices; only symmetric ones have an order")
        if op in _TURNED:
            op, parts = _TURNED[op], parts[::-1]
        pairs = [_ordered(op, big, small) for big, small in zip(parts, parts[1:], strict=False)]
        return pairs[0] if len(pairs) == 1 else ("and", *pairs)

    def _square(self, tree: Any, message: str) -> Any:
        done, shape = self.term(tree)
        if shape not in (SCALAR, ZERO, ANY) and shape[0] != shape[1]:
            raise Misfit(tree, f"{message}; {self.show(tree)} is {_shape_text(shape)}")
        return done

    # ------------------------------------------------------------------ terms
    def term(self, tree: Any) -> tuple[Any, Shape]:
        """A term with all sizes in, and its shape."""
        done, shape = self._fit(tree, None)
        if isinstance(shape, tuple) and None in shape or _is_open(done):
            raise Misfit(tree, _undetermined(self.show(tree)))
        return done, shape

    def _fit(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        """A term completed as far as its own parts and the shape asked for tell."""
        if isinstance(tree, int):
            if tree == 0 and want and None not in want:
                return ("O", *map(size_tree, want)), want
            return tree, ZERO if tree == 0 else SCALAR
        op = tree[0]
        rule = getattr(self, f"_fit_{_RULES.get(op, '')}", None)
        if rule is None:
            return _plain(tree), ANY
        if (key := (id(tree), want)) not in self._fitted:
            self._fitted[key] = tree, rule(tree, want)  # the tree is kept, so that its id stays its own
        return self._fitted[key][1]

    def _fit_number(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        return _plain(tree), SCALAR

    def _fit_name(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        return _plain(tree), self.shapes.get(tree[1], ANY)

    def _fit_step(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        return _plain(tree), self.shapes.get(tree[1], ANY)

    def _fit_unit(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        size = (want[0] or want[1]) if want else None
        return (tree, (None, None)) if size is None else (("I", size_tree(size)), (size, size))

    def _fit_identity(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        return _plain(tree), (self.size(tree[1]),) * 2

    def _fit_zeros(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        return _plain(tree), (self.size(tree[1]), self.size(tree[2]))

    def _fit_minus(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        done, shape = self._fit(tree[1], want)
        return ("neg", done), shape

    def _fit_transpose(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        done, shape = self._fit(tree[1], want[::-1] if want else None)
        return ("T", done), shape[::-1] if isinstance(shape, tuple) else shape

    def _fit_inverse(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        done, shape = self._fit(tree[1], want)
        if isinstance(shape, tuple) and shape[0] != shape[1]:
            raise Misfit(tree, f"the inverse {self.show(tree)} is one of a {_shape_text(shape)} matrix; only square matrices have an inverse")
        return ("inv", done), shape

    def _fit_power(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        done, shape = self._fit(tree[1], want)
        if isinstance(shape, tuple) and shape[0] != shape[1]:
            raise Misfit(tree, f"the power {self.show(tree)} is one of a {_shape_text(shape)} matrix; only square matrices have powers")
        return ("^", done, tree[2]), shape

    def _fit_number_of(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        if tree[0] == "rank":
            return ("rank", self.term(tree[1])[0]), SCALAR
        return (tree[0], self._square(tree[1], f"{self.show(tree)} needs a square matrix")), SCALAR

    def _fit_quotient(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        over, shape = self._fit(tree[1], want)
        under, divisor = self._fit(tree[2], None)
        if isinstance(divisor, tuple) and divisor != (_ONE, _ONE):
            raise Misfit(tree, f"{self.show(tree)} divides by a {_shape_text(divisor)} matrix; multiply by its inverse, inv({self.show(tree[2])})")
        return ("/", over, under), shape

    def _fit_sum(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        parts, shape = self._alike(tree, tree[1:], want)
        return (tree[0], *parts), shape

    def _alike(self, tree: Any, parts: Sequence[Any], want: tuple | None) -> tuple[list[Any], Shape]:
        """Parts of a sum or equation: what is known of one holds for all."""
        first = [self._fit(part, None) for part in parts]
        known = [(part, shape) for part, (_, shape) in zip(parts, first, strict=True) if isinstance(shape, tuple)]
        if not known:
            shapes = [shape for _, shape in first]
            if want and any(s == ZERO for s in shapes) and all(s == ZERO for s in shapes):
                return [self._fit(part, want)[0] for part in parts], want
            return [done for done, _ in first], ANY if ANY in shapes else SCALAR if SCALAR in shapes else ZERO
        shape = self._common(tree, known)
        if want:
            shape = tuple(a or b for a, b in zip(shape, want, strict=True))
            if all(own == (None, None) for _, own in known):  # identities alone
                shape = (shape[0] or shape[1],) * 2
        for part, (_, own) in zip(parts, first, strict=True):
            if own == SCALAR and None not in shape and shape != (_ONE, _ONE):
                raise Misfit(tree, f"in {self.show(tree)} the number {self.show(part)} stands beside {_shape_text(shape)} matrices; "
                                   f"write {'' if part == 1 else self.show(part) + '*'}I for a multiple of the identity")
        if None in shape:
            return [done for done, _ in first], shape
        return [self._fit(part, shape)[0] for part in parts], shape

    def _common(self, tree: Any, known: Sequence[tuple[Any, tuple]]) -> tuple:
        """The shape of all; an identity lets rows and columns be the same."""
        rows = next((s[0] for _, s in known if s[0] is not None), None)
        cols = next((s[1] for _, s in known if s[1] is not None), None)
        if any(s == (None, None) for _, s in known):  # an identity among them
            rows, cols = rows or cols, cols or rows
            if rows != cols:
                part = next(p for p, s in known if None not in s)
                raise Misfit(tree, f"in {self.show(tree)} an identity stands beside {self.show(part)}, which is {_shape_text((rows, cols))} and not square")
        for part, s in known:
            if (s[0] or rows, s[1] or cols) != (rows, cols):
                other = next(p for p, t in known if t[0] == rows or t[1] == cols)
                raise Misfit(tree, f"in {self.show(tree)} the sizes do not fit: {self.show(other)} is {_shape_text((rows, cols))}, "
                                   f"{self.show(part)} is {_shape_text(s)}")
        return rows, cols

    def _fit_product(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        parts = list(tree[1:])
        done = [self._fit(part, None) for part in parts]
        if any(shape == ANY for _, shape in done):
            return ("*", *(d for d, _ in done)), ANY
        places = [k for k, (_, shape) in enumerate(done) if isinstance(shape, tuple)]
        for k, before in [*zip(places[1:], places, strict=False), *zip(places[-2::-1], places[:0:-1], strict=False)]:
            shape = done[k][1]
            if None in shape:  # an identity takes its size from its neighbour
                near = done[before][1][1 if before < k else 0]
                if near is not None:
                    done[k] = self._fit(parts[k], (near, None) if before < k else (None, near))
        if want and places:
            for k, near in ((places[0], (want[0], None)), (places[-1], (None, want[1]))):
                if None in done[k][1]:
                    done[k] = self._fit(parts[k], near)
        for left, right in zip(places, places[1:], strict=False):
            inner = done[left][1][1], done[right][1][0]
            if None not in inner and inner[0] != inner[1]:
                raise Misfit(tree, f"the product {self.show(parts[left])}*{self.show(parts[right])} does not fit: {self.show(parts[left])} is "
                                   f"{_shape_text(done[left][1])}, {self.show(parts[right])} is {_shape_text(done[right][1])}")
        factors = ("*", *(d for d, _ in done))
        if not places:
            return factors, SCALAR
        return factors, (done[places[0]][1][0], done[places[-1]][1][1])

    def _fit_block(self, tree: Any, want: tuple | None) -> tuple[Any, Shape]:
        table = [list(row) for row in tree[1:]]
        if len({len(row) for row in table}) != 1:
            raise Misfit(tree, f"the rows of {self.show(tree)} have different numbers of blocks; write 0 where a block is zero")
        found = [[_as_matrix(self._fit(cell, None)[1]) for cell in row] for row in table]
        heights: list[Size | None] = [None] * len(table)
        widths: list[Size | None] = [None] * len(table[0])
        for _ in range(len(heights) + len(widths)):  # a square block passes a size from its row to its column
            for i, row in enumerate(table):
                for j, cell in enumerate(row):
                    self._pass_on(tree, cell, found[i][j], heights, widths, i, j)
            for parts, whole in zip((heights, widths), want or (), strict=False):
                if whole is not None and parts.count(None) == 1:
                    parts[parts.index(None)] = _total([whole, *([(n, -c) for n, c in p] for p in parts if p is not None)])
        if None in heights or None in widths:
            return tree, (None if None in heights else _total(heights), None if None in widths else _total(widths))
        cells = tuple(tuple(self._fit(cell, (heights[i], widths[j]))[0] for j, cell in enumerate(row)) for i, row in enumerate(table))
        return ("block", *cells), (_total(heights), _total(widths))

    def _pass_on(self, tree: Any, cell: Any, shape: Shape, heights: list, widths: list, i: int, j: int) -> None:
        if not isinstance(shape, tuple):
            return
        rows, cols = shape
        if shape == (None, None):
            rows = cols = heights[i] or widths[j]
        for known, at, size, what in ((heights, i, rows, "row"), (widths, j, cols, "column")):
            if known[at] is None:
                known[at] = size
            elif size is not None and known[at] != size:
                raise Misfit(tree, f"in {self.show(tree)} block {self.show(cell)} does not fit in its {what}: {size_text(size)} is not {size_text(known[at])}")


_RULES = {
    "rat": "number", "sym": "name", "at": "step", "I?": "unit", "I": "identity", "O": "zeros", "neg": "minus", "T": "transpose", "inv": "inverse",
    "^": "power", "det": "number_of", "tr": "number_of", "rank": "number_of", "/": "quotient", "+": "sum", "-": "sum", "*": "product",
    "block": "block",
}


def _ordered(op: str, big: Any, small: Any) -> Any:
    """A >= B as such, A >= 0 as semidefiniteness, A > B as definiteness of the difference."""
    if op in ("loewner", ">="):
        return ("psd", big) if _is_zero(small) else ("loewner", big, small)
    return ("pd", big) if _is_zero(small) else ("pd", ("-", big, small))


def _undetermined(term: str) -> str:
    return f"the size of an identity or zero in {term} is not determined; write I(n) or O(n, m) with sizes in place of n and m"


def _is_open(tree: Any) -> bool:
    """An identity without size is left in a term."""
    return isinstance(tree, (tuple, list)) and (tree[:1] == IDENTITY or any(map(_is_open, tree)))


def _is_zero(tree: Any) -> bool:
    return tree == 0 or (isinstance(tree, tuple) and tree[0] == "O")


def _as_matrix(shape: Shape) -> Shape:
    return (_ONE, _ONE) if shape == SCALAR else shape


def _total(parts: Iterable[Any]) -> Size:
    out: dict[str, int] = {}
    for part in parts:
        for name, c in part:
            out[name] = out.get(name, 0) + c
    return tuple(sorted((n, c) for n, c in out.items() if c))


def size_tree(size: Size) -> Any:
    """The tree of a size."""
    parts = [c if not n else ("sym", n) if c == 1 else ("*", c, ("sym", n)) for n, c in sorted(size, key=lambda part: (not part[0], part))]
    return 0 if not parts else parts[0] if len(parts) == 1 else ("+", *parts)


def size_text(size: Size) -> str:
    """A size for people."""
    return text(size_tree(size)).replace(" ", "")


def _shape_text(shape: tuple) -> str:
    return " x ".join("?" if s is None else size_text(s) for s in shape)


def _plain(tree: Any) -> Any:
    """The same tree of tuples proper."""
    return tuple(_plain(x) for x in tree) if isinstance(tree, tuple) else tree
