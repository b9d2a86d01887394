# SPDX-License-Identifier: MIT
"""What a statement offers for congruences K H K': semidefinite H and matrices K.

Main definitions
----------------
`Scene`
    One leaf with what occurs in it.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import Any

from exactkf.kernel.definite import definiteness, exists, sign
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.order import register_inverses
from exactkf.kernel.reader import Reader, hypotheses
from exactkf.kernel.words import Blocks, size_tree

__all__ = ["Scene"]

_RELATIONS = ("psd", "pd", "loewner", "=", "symmetric", "symplectic", "invertible", "and", "=>", "!=")
_MOST = 80  # matrices K of one level


def _transposed(tree: Any) -> Any:
    return tree if isinstance(tree, int) else tree[1] if tree[0] == "T" else ["T", tree]


class Scene:
    """What occurs in a leaf of an ``order``.

    Parameters
    ----------
    case, formula
        From `exactkf.kernel.order.leaves`.
    """

    def __init__(self, case: dict, formula: Any) -> None:
        self.case, self.formula = case, formula
        self.reader = reader = Reader(case)
        for tree in case["own"]:
            register_inverses(reader, tree)
        reader.granted = list(reader.inverses), list(reader.quotients), set(reader.units)
        self.known = list(reader.inverses)
        self.lets = {d[1]: d[3] for d in case["where"] if d[0] == "let" and not d[2]}
        self.said = [f for _, f in hypotheses(case)]
        self.bases = self._bases()
        self.levels: dict[int, list] = {}

    # ------------------------------------------------------------------ reading
    def value(self, tree: Any) -> Blocks | None:
        """The matrix of a term all of whose inverses exist, or None."""
        try:
            if not exists(self.reader, tree, self.known):  # asked first: what has been read is in the relations
                return None
            found = self.reader.read(tree)
            return found if isinstance(found, Blocks) else None
        except (Unknown, Undefined, TypeError, AttributeError):
            return None

    def open(self, tree: Any) -> Any:
        """What a name stands for."""
        while isinstance(tree, list) and tree[0] == "sym" and tree[1] in self.lets:
            tree = self.lets[tree[1]]
        return tree

    def unit(self, size: Any) -> Any:
        return ["I", size_tree(size)]

    def _units(self, trees: list) -> list:
        """Identities of as many rows, or columns, as these have."""
        sizes = [s for t in trees if (value := self.value(t)) is not None for s in (*value.rows, *value.cols)]
        return [self.unit(s) for s in dict.fromkeys(sizes)]

    def _distinct(self, trees: Any, most: int = _MOST) -> list:
        """Terms with a value, equal ones once."""
        out: list[tuple[Any, Blocks]] = []
        for tree in trees:
            value = self.value(tree)
            if value is not None and any(p for p, _, _ in value.cells()) and not any(value == v for _, v in out):
                out.append((tree, value))
                if len(out) == most:
                    break
        return [tree for tree, _ in out]

    def subterms(self) -> list:
        """Terms that occur, and parts of products; definitions opened."""
        seen: dict[str, Any] = {}

        def visit(tree: Any) -> None:
            if not isinstance(tree, list) or repr(tree) in seen:
                return
            if tree and not isinstance(tree[0], str):
                for part in tree:
                    visit(part)
                return
            if tree[0] not in _RELATIONS:
                seen[repr(tree)] = tree
            if tree[0] == "*":
                for i, j in product(range(1, len(tree)), range(3, len(tree) + 1)):
                    if i + 1 < j and j - i < len(tree) - 1:
                        visit(["*", *tree[i:j]])
            if tree[0] == "sym" and tree[1] in self.lets:
                visit(self.lets[tree[1]])
            for part in tree[1:]:
                visit(part)

        for formula in (self.formula, *self.said):
            visit(formula)
        return [t for t in seen.values() if t[0] not in ("I", "O", "rat")]

    # ------------------------------------------------------------------ semidefinite matrices
    def orders(self) -> list:
        """A - B for the hypotheses A >= B and A > B."""
        found = [["-", *f[1:]] for f in self.said if f[0] == "loewner"]
        return found + [f[1] for f in self.said if f[0] in ("psd", "pd") and f[1][:1] == ["-"] and len(f[1]) == 3]

    def _bases(self) -> list:
        found = [["sym", name] for name, kind in self.case["over"] if kind[0] in ("psd", "pd")]
        found += [f[1] for f in self.said if f[0] in ("psd", "pd")]
        found += [["-", *f[1:]] for f in self.said if f[0] == "loewner"]
        found += [["inv", t] for t in found if t[0] == "sym" and definiteness(self.reader, t) == 2]
        terms = self.subterms()
        found += [t[1] for t in terms if t[0] == "inv"] + [t for t in terms if t[0] == "inv"]
        found += [["inv", t] for t in terms if t[0] == "+" and self._level(t) == 2]
        found += [["-", ["*", t, self.unit(value.rows[0])], t[1]] for t in terms if t[0] == "tr" and (value := self.value(t[1])) and len(value.rows) == 1]
        found += [t for t in terms if t[0] == "*" and len(t) % 2]  # M'M in I + PM'M is a weight of its own
        return self._distinct(t for t in found if self._level(t))

    def _level(self, tree: Any) -> int:
        try:
            return definiteness(self.reader, tree)
        except (Unknown, Undefined, TypeError, AttributeError):
            return 0

    def definite(self, rows: Any) -> list:
        """Positive definite matrices of this size."""
        return [h for h in self.bases if self._level(h) == 2 and self.value(h).rows == rows]  # type: ignore[union-attr]

    def terms(self, rows: Any, level: int) -> list:
        """Terms of this size that are semidefinite by their form; of level 0 those that occur."""
        found = [h for h in self.bases if self.value(h).rows == rows]  # type: ignore[union-attr]
        if level:
            found += [["*", c, *(h[1:] if h[0] == "*" else [h])] for c in self._numbers() for h in list(found)]
            found += self._paired()
            found += [self._congruence(k, h) for k in self.multipliers(level) for h in [*self.bases, None] if self._fits(k, h, rows)]
        return [t for t in self._distinct(found, 10 * _MOST) if self._level(t)]

    def _numbers(self) -> list:
        """Scalars that occur and are not negative."""
        return [t for t in self.subterms() if t[0] in ("sym", "*", "/", "+", "^", "tr") and not self._is_matrix(t) and self._sign(t)]

    def _is_matrix(self, tree: Any) -> bool:
        try:
            return isinstance(self.reader.read(tree), Blocks)
        except (Unknown, Undefined, TypeError, AttributeError):
            return True

    def _sign(self, tree: Any) -> int:
        try:
            return sign(self.reader, tree)
        except (Unknown, Undefined, TypeError, AttributeError):
            return 0

    def _fits(self, k: Any, h: Any, rows: Any) -> bool:
        value = self.value(k)
        return value is not None and value.rows == rows and (h is None or self.value(h).rows == value.cols)  # type: ignore[union-attr]

    def _congruence(self, k: Any, h: Any) -> Any:
        """K H K', or K K'."""
        first = k[1:] if k[0] == "*" else [k]
        last = [_transposed(x) for x in reversed(first)]
        return ["*", *first, *([] if h is None else [h]), *last]

    # ------------------------------------------------------------------ matrices K
    def multipliers(self, level: int) -> list:
        if level not in self.levels:
            before = self.multipliers(level - 1) if level > 1 else []
            self.levels[level] = self._distinct([*before, *(self._letters, self._occurring, self._made)[level - 1]()], level * _MOST)
        return self.levels[level]

    def _letters(self) -> Iterator[Any]:
        names = [["sym", name] for name, _ in self.case["over"]]
        yield from self._columns_of_blocks()
        yield from self.rows_of_blocks()
        yield from names
        yield from (["T", x] for x in names)
        yield from (["inv", x] for x in names)

    def _occurring(self) -> Iterator[Any]:
        for t in [*self._differences(), *self.subterms()]:
            yield t
            yield _transposed(t)

    def _differences(self) -> list:
        """The matrix of the goal, and those of the hypotheses, as differences."""
        return [["-", *f[1:]] if f[0] == "loewner" else f[1] for f in (self.formula, *self.said) if f[0] in ("loewner", "psd", "pd")]

    def _made(self) -> Iterator[Any]:
        terms = self.subterms()
        names = [["sym", name] for name, _ in self.case["over"]]
        inverses = self._distinct([*([t for t in terms if t[0] == "inv"]), *(["inv", x] for x in names)])
        pool = [*inverses, *self._differences(), *names]
        units, gains = self._units(names), [t for t in terms if t[0] == "*" and t[-1][:1] == ["inv"]]
        yield from self._closed_loops(units, gains)
        yield from self._estimators(names)
        yield from (["-", s, t] for k, s in enumerate(gains) for t in gains[:k] if s[1] == t[1])
        for x, y in product(pool, pool):
            if x != y:
                yield ["*", x, y]
        simple = [*units, *names, *inverses]
        yield from (["-", x, y] for k, x in enumerate(simple) for y in simple[:k])
        yield from (["T", ["-", x, y]] for k, x in enumerate(inverses) for y in units)
        yield from (["+", x, y] for k, x in enumerate(simple) for y in simple[:k])
        slices = [t for t in terms if t[0] == "*"]
        yield from (["-", u, t] for t in slices for u in units)
        yield from (["-", s, t] for k, s in enumerate(slices) for t in slices[:k] if len(s) == len(t))
        yield from (["-", x, t] for t in gains for y in names for x in (y, ["T", y]))  # any gain less the best one
        yield from (["T", ["-", x, ["*", y, z]]] for y in inverses for x, z in product(names, names) if x != z)  # completed squares
        if self.formula[0] in ("psd", "pd") and (found := self._cells(self.formula[1])):
            simple += [["T", x] for x in names]
            yield from (["block", *([x] for x in column)] for column in product(simple, repeat=len(found[1])))

    def _estimators(self, names: list) -> Iterator[Any]:
        """L less the best inv(H'WH) H'W, for every matrix L."""
        for t in self.subterms():
            whole = self.open(t[1]) if t[0] == "inv" else 0
            if isinstance(whole, list) and whole[0] == "*":
                yield from (["-", x, ["*", t, *whole[1:k]]] for k in range(2, len(whole)) for x in names)

    def _closed_loops(self, units: list, gains: list) -> Iterator[Any]:
        """A - KC for a gain K = A P C' inv(S)."""
        for t in gains:
            if len(t) > 3:
                heads = [*units, *(t[1] if k == 2 else ["*", *t[1:k]] for k in range(2, len(t) - 2))]
                yield from (["-", x, [*t, _transposed(t[-2])]] for x in heads)

    # ------------------------------------------------------------------ blocks
    def _table(self, tree: Any) -> list | None:
        whole = self.open(tree)
        return whole[1:] if isinstance(whole, list) and whole[0] == "block" and len(whole) - 1 == len(whole[1]) > 1 else None

    def _cells(self, tree: Any) -> tuple[list, tuple] | None:
        table, value = self._table(tree), self.value(tree)
        return (table, value.rows) if table and value is not None and len(value.rows) == len(table) and value.rows == value.cols else None

    def rows_of_blocks(self) -> Iterator[Any]:
        """For a hypothesis on [A, B; B', C]: the rows [I, 0], [-B' inv(A), I] and the like."""
        for f in self.said:
            if f[0] in ("psd", "pd") and (found := self._cells(f[1])):
                yield from self._rows(*found)

    def _columns_of_blocks(self) -> Iterator[Any]:
        """For a goal in blocks: columns of the same kind."""
        if self.formula[0] in ("psd", "pd") and (found := self._cells(self.formula[1])):
            table, sizes = found
            for i in range(len(sizes)):
                yield ["block", *([self.unit(s) if i == j else ["O", size_tree(s), size_tree(sizes[i])]] for j, s in enumerate(sizes))]
            if len(sizes) == 2:
                yield ["block", [self.unit(sizes[0])], [["*", table[1][0], ["inv", table[0][0]]]]]
                yield ["block", [["*", table[0][1], ["inv", table[1][1]]]], [self.unit(sizes[1])]]

    def _rows(self, table: list, sizes: tuple) -> Iterator[Any]:
        for i, _ in enumerate(sizes):
            yield ["block", [self.unit(s) if i == j else ["O", size_tree(sizes[i]), size_tree(s)] for j, s in enumerate(sizes)]]
        if len(sizes) == 2:
            yield ["block", [["neg", ["*", table[1][0], ["inv", table[0][0]]]], self.unit(sizes[1])]]
            yield ["block", [self.unit(sizes[0]), ["neg", ["*", table[0][1], ["inv", table[1][1]]]]]]

    def triangular(self) -> Iterator[Any]:
        """For a goal [A, B; B', C]: [I, 0; B' inv(A), I] and [I, B inv(C); 0, I]."""
        if self.formula[0] not in ("psd", "pd") or not (found := self._cells(self.formula[1])) or len(found[1]) != 2:
            return
        table, (n, m) = found
        lower = ["block", [self.unit(n), ["O", size_tree(n), size_tree(m)]], [["*", table[1][0], ["inv", table[0][0]]], self.unit(m)]]
        upper = ["block", [self.unit(n), ["*", table[0][1], ["inv", table[1][1]]]], [["O", size_tree(m), size_tree(n)], self.unit(m)]]
        yield from (factor for factor in (lower, upper) if self.value(factor) is not None)

    def _paired(self) -> Iterator[Any]:
        """L diag(D, S) L' with a triangular L and semidefinite D and S."""
        for factor in self.triangular():
            n, m = self.value(factor).rows  # type: ignore[union-attr]
            first, second = ([h for h in self.bases if self.value(h).rows == (s,)] for s in (n, m))  # type: ignore[union-attr]
            for d, s in product(first, second):
                diagonal = ["block", [d, ["O", size_tree(n), size_tree(m)]], [["O", size_tree(m), size_tree(n)], s]]
                yield ["*", factor, diagonal, ["T", factor]]

    # ------------------------------------------------------------------ null vectors
    def vectors(self) -> list[tuple[Any, Blocks]]:
        """Matrices x at which semidefinite terms may vanish: letters, the null vector of an invertibility, I, blocks of I."""
        names = [name for name, kind in self.case["over"] if kind[0] == "matrix"]
        own = sorted(name for name in names if name.startswith("v."))
        rest = [["sym", name] for name in names if name not in own]
        vector = [["sym", own[0]] if len(own) == 1 else ["block", *([["sym", name]] for name in own)]] if own else []
        corners = [_column(k) for k in self.rows_of_blocks() if all(c[0] in ("I", "O") for c in k[1])]
        tried = [*vector, *rest, *self._units([*self.bases, *rest]), *corners]
        return [(x, value) for x in tried if (value := self.value(x)) is not None]


def _column(row: Any) -> Any:
    """A row of identities and zeros as a column."""
    return ["block", *([["O", c[2], c[1]] if c[0] == "O" else c] for c in row[1])]
