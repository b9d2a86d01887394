# SPDX-License-Identifier: MIT
"""Noncommutative polynomials in typed letters, beside commuting scalars.

Main definitions
----------------
`Poly`
    {(scalars, word): coefficient}; scalars are powers ((name, exponent), ...) and
    commute, a word is a tuple of letters. Coefficients are ints or Fractions.
`Blocks`
    Block matrix of polynomials with the sizes of its block rows and columns.
`Relation`
    A polynomial that vanishes, with its sizes; without sizes it is a scalar one
    and stands for a multiple of the identity of any size.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

from exactkf.kernel.limits import WORDS
from exactkf.kernel.numbers import Undefined, Unknown

__all__ = ["ONE", "Blocks", "Poly", "Relation", "Size", "Word", "add", "multiply", "number", "shape", "size_tree", "text", "times_scalars"]

Word = tuple[str, ...]
Scalars = tuple[tuple[str, int], ...]
Poly = dict[tuple[Scalars, Word], Any]
Size = tuple  # canonical linear form: sorted ((name, coefficient), ...), '' for the constant

ONE: Poly = {((), ()): 1}


def number(x: Any) -> Any:
    """A rational number as int where it is one."""
    x = Fraction(x)
    return x.numerator if x.denominator == 1 else x


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
    if len(p) * len(q) > WORDS:
        raise Unknown(f"a product of polynomials with more than {WORDS} words")
    out: Poly = {}
    get = out.get
    for (s, u), a in p.items():
        for (t, v), b in q.items():
            key = (times_scalars(s, t) if s and t else s or t, u + v)
            out[key] = get(key, 0) + a * b
    return {key: c for key, c in out.items() if c}


def times_scalars(s: Scalars, t: Scalars) -> Scalars:
    """Product of two monomials in the scalars."""
    powers = dict(s)
    for name, e in t:
        powers[name] = powers.get(name, 0) + e
    return tuple(sorted((n, e) for n, e in powers.items() if e))


class Relation(NamedTuple):
    """A polynomial that vanishes; ``rows`` and ``cols`` are None for a scalar one."""

    poly: Poly
    rows: Size | None
    cols: Size | None


class Blocks:
    """Block matrix; ``rows`` and ``cols`` are the sizes of its block rows and columns."""

    def __init__(self, rows: tuple[Size, ...], cols: tuple[Size, ...], grid: list[list[Poly]]) -> None:
        self.rows, self.cols, self.grid = rows, cols, grid

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Blocks) and (self.rows, self.cols, self.grid) == (other.rows, other.cols, other.grid)

    __hash__ = None  # type: ignore[assignment]

    @classmethod
    def unit(cls, sizes: tuple[Size, ...]) -> Blocks:
        """Identity with these block rows."""
        return cls(sizes, sizes, [[dict(ONE) if i == j else {} for j in range(len(sizes))] for i in range(len(sizes))])

    def map(self, f: Any) -> Blocks:
        return Blocks(self.rows, self.cols, [[f(p) for p in r] for r in self.grid])

    def plus(self, other: Blocks, factor: int = 1) -> Blocks:
        if (self.rows, self.cols) != (other.rows, other.cols):
            raise Undefined(f"sizes {shape(self)} and {shape(other)} do not fit in a sum")
        return Blocks(self.rows, self.cols, [[add(p, q, factor) for p, q in zip(r, s, strict=True)] for r, s in zip(self.grid, other.grid, strict=True)])

    def times(self, other: Blocks) -> Blocks:
        if self.cols != other.rows:
            raise Undefined(f"sizes {shape(self)} and {shape(other)} do not fit in a product")
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

    def cells(self) -> list[tuple[Poly, Size, Size]]:
        """The blocks, row by row, with their sizes."""
        return [(p, self.rows[i], self.cols[j]) for i, row in enumerate(self.grid) for j, p in enumerate(row)]


def shape(b: Blocks) -> str:
    """Sizes for people."""
    return f"{'+'.join(map(_size_text, b.rows))} x {'+'.join(map(_size_text, b.cols))}"


def _size_text(size: Size) -> str:
    return "+".join(str(c) if not n else n if c == 1 else f"{c}{n}" for n, c in size) or "0"


def size_tree(size: Size) -> Any:
    """A size, as the reader has it, as a term."""
    parts = [c if not n else ["sym", n] if c == 1 else ["*", c, ["sym", n]] for n, c in size]
    return parts[0] if len(parts) == 1 else ["+", *parts] if parts else 0


def text(p: Poly, unit: str = "I") -> str:
    """A polynomial for people."""
    terms = []
    for (scalars, word), c in sorted(p.items(), key=lambda item: (len(item[0][1]), item[0])):
        factors = [n if e == 1 else f"{n}^{e}" for n, e in scalars] + list(word)
        body = "*".join(factors) or unit
        terms.append(body if c == 1 else f"-{body}" if c == -1 else f"{c}*{body}")
    return " + ".join(terms).replace("+ -", "- ") or "0"
