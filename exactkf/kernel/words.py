# SPDX-License-Identifier: MIT
"""Matrices of every size at once: noncommutative polynomials in typed letters.

A statement about matrices with named sizes is read as polynomials in words.
A letter is a variable, its transpose, or the inverse of a term that the
statement inverts; each has a number of rows and of columns, and a product
whose sizes do not fit is refused. Block matrices are opened into blocks.

Main definitions
----------------
`Poly`
    {(scalars, word): coefficient}; scalars commute, a word is a tuple of letters.
`Blocks`
    Block matrix of polynomials with the sizes of its block rows and columns.
`Reader`
    Reads terms; collects letters and the relations of the inverses.
`relations`
    What the statement assumes: its equations, transposed too, and V E = E V = 1
    for each inverse V of E. A term without value is outside the statement, so
    an inverse that is written down exists. A one-sided inverse of a square
    matrix is two-sided: M'JM = J gives MJM' = J, and XY = I gives YX = I.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import count
from typing import Any

from exactkf.kernel.numbers import Undefined, Unknown

__all__ = ["Blocks", "Poly", "Reader", "add", "multiply", "relations", "residual_blocks", "text", "word_sizes"]

Word = tuple[str, ...]
Key = tuple[tuple[tuple[str, int], ...], Word]
Poly = dict[Key, Fraction]
Size = tuple  # canonical linear form: sorted ((name, coefficient), ...), '' for the constant


def add(p: Poly, q: Poly, factor: Any = 1) -> Poly:
    """p + factor q."""
    out = dict(p)
    for key, c in q.items():
        s = out.get(key, 0) + factor * c
        if s:
            out[key] = s
        else:
            out.pop(key, None)
    return out


def multiply(p: Poly, q: Poly) -> Poly:
    """p q, scalars commuting, words concatenated."""
    out: Poly = {}
    for (s, u), a in p.items():
        for (t, v), b in q.items():
            key = (_scalars(s, t), u + v)
            c = out.get(key, 0) + a * b
            if c:
                out[key] = c
            else:
                out.pop(key, None)
    return out


def _scalars(s: tuple, t: tuple) -> tuple:
    if not s or not t:
        return s or t
    powers = dict(s)
    for name, e in t:
        powers[name] = powers.get(name, 0) + e
    return tuple(sorted((n, e) for n, e in powers.items() if e))


ONE: Poly = {((), ()): Fraction(1)}


class Blocks:
    """Block matrix; ``rows`` and ``cols`` are the sizes of its block rows and columns."""

    def __init__(self, rows: tuple[Size, ...], cols: tuple[Size, ...], grid: list[list[Poly]]) -> None:
        self.rows, self.cols, self.grid = rows, cols, grid

    def map(self, f: Any) -> Blocks:
        return Blocks(self.rows, self.cols, [[f(p) for p in r] for r in self.grid])

    def plus(self, other: Blocks, factor: int = 1) -> Blocks:
        if (self.rows, self.cols) != (other.rows, other.cols):
            raise Undefined(f"sizes {_shape(self)} and {_shape(other)} do not fit in a sum")
        return Blocks(self.rows, self.cols, [[add(p, q, factor) for p, q in zip(r, s, strict=True)] for r, s in zip(self.grid, other.grid, strict=True)])

    def times(self, other: Blocks) -> Blocks:
        if self.cols != other.rows:
            raise Undefined(f"sizes {_shape(self)} and {_shape(other)} do not fit in a product")
        grid = []
        for row in self.grid:
            line = []
            for j in range(len(other.cols)):
                acc: Poly = {}
                for k, p in enumerate(row):
                    acc = add(acc, multiply(p, other.grid[k][j]))
                line.append(acc)
            grid.append(line)
        return Blocks(self.rows, other.cols, grid)


def _shape(b: Blocks) -> str:
    return f"{'+'.join(map(_size_text, b.rows))} x {'+'.join(map(_size_text, b.cols))}"


def _size_text(size: Size) -> str:
    return "+".join(str(c) if not n else n if c == 1 else f"{c}{n}" for n, c in size) or "0"


def _hypotheses(statement: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """The hypotheses with their labels, the members of a conjunction apart."""
    todo = [(label, formula) for label, formula, _ in reversed(statement["given"])]
    while todo:
        label, formula = todo.pop()
        if formula[0] == "and":
            todo.extend((f"{label}.{n}", part) for n, part in reversed(list(enumerate(formula[1:]))))
        else:
            yield label, formula


class Reader:
    """Reads the terms of one statement as block matrices of noncommutative polynomials."""

    def __init__(self, statement: Mapping[str, Any]) -> None:
        self.statement = statement
        self.kinds = {name: kind for name, kind in statement["over"]}
        self.lets = {d[1]: d for d in statement["where"]}
        self.sizes: dict[str, tuple[Size, Size]] = {}  # letter -> (rows, columns)
        self.transposed: dict[str, str] = {}  # letter -> letter of its transpose
        self.inverses: list[tuple[Poly, str]] = []  # (term, letter of its inverse)
        symmetric = {f[1][1] for _, f in _hypotheses(statement) if f[0] in ("symmetric", "psd", "pd") and not isinstance(f[1], int) and f[1][0] == "sym"}
        for name, kind in statement["over"]:
            if kind[0] == "matrix":
                self._letter(name, self.size(kind[1]), self.size(kind[2]), name in symmetric and kind[1] == kind[2])
            elif kind[0] in ("symmetric", "psd", "pd"):
                self._letter(name, self.size(kind[1]), self.size(kind[1]), True)
            elif kind[0] in ("nonsingular", "diagonal"):
                self._letter(name, self.size(kind[1]), self.size(kind[1]), kind[0] == "diagonal")

    def _letter(self, name: str, rows: Size, cols: Size, symmetric: bool) -> None:
        self.sizes[name] = (rows, cols)
        other = name if symmetric else f"{name}'"
        self.transposed[name], self.transposed[other] = other, name
        self.sizes[other] = (cols, rows)

    def size(self, tree: Any) -> Size:
        """A size as a linear form in the named sizes."""
        form = self._linear(tree)
        return tuple(sorted((n, c) for n, c in form.items() if c))

    def _linear(self, tree: Any) -> dict[str, int]:
        if isinstance(tree, int):
            return {"": tree}
        op = tree[0]
        if op == "sym" and tree[1] in self.statement["sizes"]:
            return {tree[1]: 1}
        if op in ("+", "-"):
            out: dict[str, int] = {}
            for k, part in enumerate(tree[1:]):
                for n, c in self._linear(part).items():
                    out[n] = out.get(n, 0) + (-c if op == "-" and k else c)
            return out
        if op == "*" and len(tree) == 3 and isinstance(tree[1], int):
            return {n: tree[1] * c for n, c in self._linear(tree[2]).items()}
        raise Unknown(f"size {tree!r} is not linear in the named sizes")

    # ------------------------------------------------------------------ terms
    def read(self, tree: Any, local: Mapping[str, Any] | None = None) -> Any:
        """Blocks, or a Poly without letters for a scalar."""
        local = local or {}
        if isinstance(tree, int):
            return {((), ()): Fraction(tree)} if tree else {}
        method = getattr(self, f"_read_{_METHODS.get(tree[0], '')}", None)
        if method is None:
            raise Unknown(f"{tree[0]!r} in a statement for every size")
        return method(tree, local)

    def _read_rational(self, tree: Any, local: Mapping[str, Any]) -> Any:
        return {((), ()): Fraction(tree[1], tree[2])}

    def _read_name(self, tree: Any, local: Mapping[str, Any]) -> Any:
        name = tree[1]
        if name in local:
            return local[name]
        if name in self.kinds:
            if name in self.sizes:
                rows, cols = self.sizes[name]
                return Blocks((rows,), (cols,), [[{((), (name,)): Fraction(1)}]])
            if self.kinds[name][0] in ("scalar", "nonzero", "positive", "nonneg"):
                return {(((name, 1),), ()): Fraction(1)}
        if name in self.lets and self.lets[name][0] == "let" and not self.lets[name][2]:
            return self.read(self.lets[name][3])
        raise Unknown(f"name {name!r} in a statement for every size")

    def _read_call(self, tree: Any, local: Mapping[str, Any]) -> Any:
        definition = self.lets.get(tree[1])
        if definition is None or definition[0] != "let" or not definition[2]:
            raise Unknown(f"{tree[1]!r} with an index in a statement for every size")
        return self.read(definition[3], dict(zip(definition[2], [self.read(a, local) for a in tree[2:]], strict=True)))

    def _read_sum(self, tree: Any, local: Mapping[str, Any]) -> Any:
        acc = self.read(tree[1], local)
        for part in tree[2:]:
            acc = self._plus(acc, self.read(part, local), 1)
        return acc

    def _read_difference(self, tree: Any, local: Mapping[str, Any]) -> Any:
        return self._plus(self.read(tree[1], local), self.read(tree[2], local), -1)

    def _read_minus(self, tree: Any, local: Mapping[str, Any]) -> Any:
        return self._scale(self.read(tree[1], local), Fraction(-1))

    def _scale(self, x: Any, c: Fraction) -> Any:
        def by(p: Poly) -> Poly:
            return {k: c * v for k, v in p.items()}
        return x.map(by) if isinstance(x, Blocks) else by(x)

    def _plus(self, x: Any, y: Any, factor: int) -> Any:
        if isinstance(x, Blocks) and isinstance(y, Blocks):
            if x.rows != y.rows or x.cols != y.cols:
                x, y = self._split_like(x, y.rows, y.cols), self._split_like(y, x.rows, x.cols)
            return x.plus(y, factor)
        if isinstance(x, Blocks):
            return x.plus(self._scalar_block(y, x), factor)
        if isinstance(y, Blocks):
            return self._scalar_block(x, y).plus(y, factor)
        return add(x, y, factor)

    def _scalar_block(self, p: Poly, like: Blocks) -> Blocks:
        """A scalar beside a 1x1 matrix, or zero beside any matrix."""
        one = (("", 1),)
        if not p:
            return like.map(lambda q: {})
        if like.rows != (one,) or like.cols != (one,):
            raise Undefined("a scalar is added to a matrix")
        return Blocks(like.rows, like.cols, [[p]])

    def _read_product(self, tree: Any, local: Mapping[str, Any]) -> Any:
        acc = self.read(tree[1], local)
        for part in tree[2:]:
            acc = self._times(acc, self.read(part, local))
        return acc

    def _times(self, x: Any, y: Any) -> Any:
        if isinstance(x, Blocks) and isinstance(y, Blocks):
            if x.cols != y.rows:
                x, y = self._split_like(x, x.rows, y.rows), self._split_like(y, x.cols, y.cols)
            return x.times(y)
        if isinstance(x, Blocks):
            return x.map(lambda p: multiply(y, p))
        if isinstance(y, Blocks):
            return y.map(lambda p: multiply(x, p))
        return multiply(x, y)

    def _read_quotient(self, tree: Any, local: Mapping[str, Any]) -> Any:
        return self._times(self.read(tree[1], local), self._inverse(self.read(tree[2], local)))

    def _read_power(self, tree: Any, local: Mapping[str, Any]) -> Any:
        if not isinstance(tree[2], int):
            raise Unknown("an exponent that is no number")
        base = self.read(tree[1], local)
        base = self._inverse(base) if tree[2] < 0 else base
        if tree[2] == 0:
            raise Unknown("power zero")
        acc = base
        for _ in range(abs(tree[2]) - 1):
            acc = self._times(acc, base)
        return acc

    def _read_transpose(self, tree: Any, local: Mapping[str, Any]) -> Any:
        return self.transpose(self.read(tree[1], local))

    def transpose(self, x: Any) -> Any:
        """Transpose of blocks; scalars stay."""
        if not isinstance(x, Blocks):
            return x
        grid = [[self.transpose_poly(x.grid[i][j]) for i in range(len(x.rows))] for j in range(len(x.cols))]
        return Blocks(x.cols, x.rows, grid)

    def transpose_poly(self, p: Poly) -> Poly:
        return {(s, tuple(self.transposed[a] for a in reversed(w))): c for (s, w), c in p.items()}

    def _read_inverse(self, tree: Any, local: Mapping[str, Any]) -> Any:
        return self._inverse(self.read(tree[1], local))

    def _inverse(self, x: Any) -> Any:
        """A scalar monomial is turned over; a matrix gets a letter for its inverse."""
        if not isinstance(x, Blocks):
            if len(x) != 1:
                raise Unknown("quotient by a sum of scalars")
            ((s, _), c), = x.items()
            return {(tuple((n, -e) for n, e in s), ()): 1 / c}
        if len(x.rows) != 1 or len(x.cols) != 1:
            raise Unknown("inverse of a block matrix")
        if x.rows != x.cols:
            raise Undefined(f"a {_shape(x)} matrix is not square")
        p, size = x.grid[0][0], x.rows[0]
        if list(p) == [((), ())]:
            return Blocks(x.rows, x.cols, [[{((), ()): 1 / p[(), ()]}]])
        word = self._inverse_word(p, size)
        return Blocks(x.rows, x.cols, [[{((), word): Fraction(1)}]])

    def _inverse_word(self, p: Poly, size: Size) -> Word:
        for term, letter in self.inverses:
            if term == p:
                return (letter,)
        turned = self.transpose_poly(p)
        for term, letter in self.inverses:
            if term == turned:
                return (self.transposed[letter],)
        name = next(name for k in count(len(self.inverses) + 1) if (name := f"inv{k}") not in {**self.kinds, **self.sizes})
        self._letter(name, size, size, turned == p)
        self.inverses.append((p, name))
        return (name,)

    def _read_identity(self, tree: Any, local: Mapping[str, Any]) -> Any:
        size = self.size(tree[1])
        return Blocks((size,), (size,), [[dict(ONE)]])

    def _read_zero(self, tree: Any, local: Mapping[str, Any]) -> Any:
        return Blocks((self.size(tree[1]),), (self.size(tree[2]),), [[{}]])

    def _split_like(self, x: Blocks, rows: tuple, cols: tuple) -> Blocks:
        """An identity or zero of a total size, opened into blocks."""
        if (x.rows, x.cols) == (rows, cols) or len(x.rows) != 1 or len(x.cols) != 1:
            return x
        p = x.grid[0][0]
        if not p and x.rows[0] == self._total(rows) and x.cols[0] == self._total(cols):
            return Blocks(rows, cols, [[{} for _ in cols] for _ in rows])
        if list(p) == [((), ())] and x.rows[0] == self._total(rows) and rows == cols:
            return Blocks(rows, cols, [[dict(p) if i == j else {} for j in range(len(cols))] for i in range(len(rows))])
        if list(p) == [((), ())] and x.rows[0] == self._total(rows) == self._total(cols):
            finer = rows if len(rows) > len(cols) else cols
            return Blocks(finer, finer, [[dict(p) if i == j else {} for j in range(len(finer))] for i in range(len(finer))])
        return x

    def _total(self, parts: tuple) -> Size:
        out: dict[str, int] = {}
        for part in parts:
            for n, c in part:
                out[n] = out.get(n, 0) + c
        return tuple(sorted((n, c) for n, c in out.items() if c))

    def _read_block(self, tree: Any, local: Mapping[str, Any]) -> Any:
        cells = [[self.read(x, local) for x in row] for row in tree[1:]]
        heights: list[tuple | None] = [next((c.rows for c in row if isinstance(c, Blocks)), None) for row in cells]
        widths: list[tuple | None] = [next((row[j].cols for row in cells if isinstance(row[j], Blocks)), None) for j in range(len(cells[0]))]
        if None in heights or None in widths:
            raise Unknown("a block row or column without sizes")
        grid: list[list[Poly]] = []
        for row, height in zip(cells, heights, strict=True):
            parts = []
            for c, width in zip(row, widths, strict=True):
                if not isinstance(c, Blocks):
                    c = self._scalar_block(c, Blocks(height, width, [[{} for _ in width] for _ in height]))  # type: ignore[arg-type, union-attr]
                c = self._split_like(c, height, width)  # type: ignore[arg-type]
                if (c.rows, c.cols) != (height, width):
                    raise Undefined("blocks of one row or column have different sizes")
                parts.append(c)
            grid.extend([sum((c.grid[i] for c in parts), []) for i in range(len(height))])  # type: ignore[arg-type]
        return Blocks(sum(heights, ()), sum(widths, ()), grid)  # type: ignore[arg-type]


_METHODS = {
    "rat": "rational", "sym": "name", "at": "call", "+": "sum", "-": "difference", "neg": "minus", "*": "product", "/": "quotient",
    "^": "power", "T": "transpose", "inv": "inverse", "I": "identity", "O": "zero", "block": "block",
}


def residual_blocks(reader: Reader, formula: Any) -> list[Blocks]:
    """Left minus right side of the equations of a conjunction."""
    op = formula[0]
    if op == "and":
        return [b for part in formula[1:] for b in residual_blocks(reader, part)]
    if op == "=":
        sides = [reader.read(x) for x in formula[1:]]
        out = [reader._plus(x, y, -1) for x, y in zip(sides, sides[1:], strict=False)]
    elif op == "symmetric":
        x = reader.read(formula[1])
        out = [reader._plus(x, reader.transpose(x), -1)]
    elif op == "symplectic":
        m = _in_halves(reader, reader.read(formula[1]))
        j = Blocks(m.rows, m.cols, [[{}, dict(ONE)], [{((), ()): Fraction(-1)}, {}]])
        out = [reader._times(reader._times(reader.transpose(m), j), m).plus(j, -1)]
    else:
        raise Unknown(f"{op!r} is no equation")
    one = (("", 1),)
    return [x if isinstance(x, Blocks) else Blocks((one,), (one,), [[x]]) for x in out]


def _in_halves(reader: Reader, m: Any) -> Blocks:
    """A matrix as four square blocks of one size."""
    if isinstance(m, Blocks) and len(m.rows) == len(m.cols) == 1 and all(c % 2 == 0 for _, c in m.rows[0]):
        half = (tuple((n, c // 2) for n, c in m.rows[0]),) * 2
        m = reader._split_like(m, half, half)
    if not isinstance(m, Blocks) or len(m.rows) != 2 or m.rows != m.cols or m.rows[0] != m.rows[1]:
        raise Unknown("symplectic matrix that is not given by four blocks")
    return m


def _other_side(reader: Reader, formula: Any) -> list[Blocks]:
    """What the two-sidedness of inverses of square matrices adds to a hypothesis."""
    if formula[0] == "symplectic":
        m = _in_halves(reader, reader.read(formula[1]))
        j = Blocks(m.rows, m.cols, [[{}, dict(ONE)], [{((), ()): Fraction(-1)}, {}]])
        return [reader._times(reader._times(m, j), reader.transpose(m)).plus(j, -1)]
    if formula[0] == "=" and formula[1][0] == "*" and len(formula[1]) == 3 and formula[2][0] == "I":
        x, y = (reader.read(f) for f in formula[1][1:])
        if isinstance(x, Blocks) and isinstance(y, Blocks) and x.rows == x.cols == y.rows == y.cols:
            return [reader._plus(y.times(x), reader.read(formula[2]), -1)]
    return []


def relations(reader: Reader) -> dict[str, Poly]:
    """Named polynomials that vanish under the hypotheses: call after every goal has been read."""
    out: dict[str, Poly] = {}
    for label, formula in _hypotheses(reader.statement):
        try:
            if formula[0] in ("psd", "pd", "loewner"):  # that the matrix is symmetric is part of it
                formula = ["symmetric", formula[1] if len(formula) == 2 else ["-", *formula[1:]]]
            found = residual_blocks(reader, formula) + _other_side(reader, formula)
        except (Unknown, TypeError):
            continue  # an inequality or a rank is not used
        for n, blocks in enumerate(found):
            for i, row in enumerate(blocks.grid):
                for j, p in enumerate(row):
                    if p:
                        out[f"{label}/{n}/{i}/{j}"] = p
                        out[f"{label}/{n}/{i}/{j}'"] = reader.transpose_poly(p)
    for p, letter in reader.inverses:
        v: Poly = {((), (letter,)): Fraction(1)}
        for name, product in ((f"{letter}/right", multiply(p, v)), (f"{letter}/left", multiply(v, p))):
            rel = add(product, ONE, -1)
            out[name], out[f"{name}'"] = rel, reader.transpose_poly(rel)
    return out


def text(p: Poly) -> str:
    """A polynomial for people."""
    terms = []
    for (scalars, word), c in sorted(p.items(), key=lambda item: (len(item[0][1]), item[0])):
        factors = [n if e == 1 else f"{n}^{e}" for n, e in scalars] + list(word)
        body = "*".join(factors) or "I"
        terms.append(body if c == 1 else f"-{body}" if c == -1 else f"{c}*{body}")
    return " + ".join(terms).replace("+ -", "- ") or "0"


def word_sizes(reader: Reader, word: Word, rows: Size) -> Size:
    """Columns of a word that starts with so many rows; a product that does not fit is refused."""
    at = rows
    for letter in word:
        if letter not in reader.sizes or reader.sizes[letter][0] != at:
            raise Undefined(f"letter {letter!r} does not fit in the word {'*'.join(word)}")
        at = reader.sizes[letter][1]
    return at
