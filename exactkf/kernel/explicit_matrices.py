# SPDX-License-Identifier: MIT
"""Matrices of at most two rows and columns that are written out, for `exactkf.kernel.arithmetic`.

An entry is a number; sums, products, transposes and definitions of such matrices are taken entry by entry. A 1 x 1 matrix may stand for a number elsewhere,
so that none is multiplied, added or compared here. With the trace s and the determinant d of a 2 x 2 matrix its characteristic polynomial is
z^2 - s z + d. A symmetric one is nonnegative definite if and only if both diagonal entries and d are not negative, and positive definite if and only if they
are positive.

Main definitions
----------------
`entries`
    The entries of a term, if it is such a matrix.
`of_matrix`
    A determinant, a trace, an entry.
`characteristic`
    Coefficients of a characteristic polynomial.
`about_matrices`
    An equation of matrices, or that one is (nonnegative) definite.
"""

from __future__ import annotations

from functools import reduce
from typing import TYPE_CHECKING, Any

from exactkf.kernel.numbers import Unknown
from exactkf.kernel.polynomial_facts import ONE, Fact, Names, Poly, joined, number, plus, times

if TYPE_CHECKING:
    from exactkf.kernel.arithmetic import Facts

__all__ = ["OF_MATRIX", "about_matrices", "characteristic", "entries", "of_matrix"]

OF_MATRIX = {"det", "tr", "entry"}
_LARGEST = 2
Grid = list[list[Poly]]


def entries(facts: Facts, tree: Any, names: Names) -> Grid | None:
    """The entries of a matrix that is written out; None for another term."""
    op = tree[0] if isinstance(tree, (list, tuple)) else ""
    if op == "rows":
        return _sized([[facts.term(cell, names) for cell in row] for row in tree[1:]])
    if op in ("I", "O"):
        rows, cols = tree[1], tree[-1]
        if not all(type(k) is int and 0 < k <= _LARGEST for k in (rows, cols)):
            raise Unknown("a matrix of another size")
        return [[number(int(op == "I" and i == j)) for j in range(cols)] for i in range(rows)]
    if op == "T":
        grid = entries(facts, tree[1], names)
        return None if grid is None else [list(column) for column in zip(*grid, strict=True)]
    if op == "sym" and tree[1] not in names and facts.definitions.get(tree[1], ("",))[0] == "let":
        body, inner = facts.opened(tree, names)
        return entries(facts, body, inner)
    if op not in ("+", "-", "neg", "*"):
        return None
    parts = [(x, entries(facts, x, names)) for x in tree[1:]]
    if all(grid is None for _, grid in parts):
        return None
    return _product(facts, parts, names) if op == "*" else _sum([grid for _, grid in parts], 1 if op == "+" else -1)


def _sized(grid: Grid) -> Grid:
    if not all(len(row) == len(grid[0]) and 0 < len(row) <= _LARGEST for row in grid) or len(grid) > _LARGEST:
        raise Unknown("a matrix of more than two rows or columns")
    return grid


def _is_number(grid: Grid) -> bool:
    """A 1 x 1 matrix, which may stand for a number."""
    return len(grid) == len(grid[0]) == 1


def _same(grids: list[Grid | None]) -> list[Grid]:
    found = [grid for grid in grids if grid is not None]
    if len(found) < len(grids) or len({(len(grid), len(grid[0])) for grid in found}) > 1 or _is_number(found[0]):
        raise Unknown("matrices of different sizes, or numbers")
    return found


def _sum(grids: list[Grid | None], sign: int) -> Grid:
    first, *rest = _same(grids)
    if not rest and sign < 0:
        return [[plus({}, p, -1) for p in row] for row in first]
    return reduce(lambda x, y: [[plus(p, q, sign) for p, q in zip(*rows, strict=True)] for rows in zip(x, y, strict=True)], rest, first)


def _product(facts: Facts, parts: list[tuple[Any, Grid | None]], names: Names) -> Grid:
    factor, found = ONE, None
    for tree, grid in parts:
        if grid is None:
            factor = times(factor, facts.term(tree, names))
        elif _is_number(grid) or found is not None and len(found[0]) != len(grid):
            raise Unknown("a product of matrices of these sizes")
        else:
            found = grid if found is None else [[reduce(plus, (times(p, q) for p, q in zip(row, column, strict=True)), {})
                                                 for column in zip(*grid, strict=True)] for row in found]
    assert found is not None
    return [[times(factor, p) for p in row] for row in found]


# ---------------------------------------------------------------------- what is said of them
def _square(facts: Facts, tree: Any, names: Names) -> Grid:
    grid = entries(facts, tree, names)
    if grid is None or len(grid) != len(grid[0]):
        raise Unknown("a matrix that is not written out, or not square")
    return grid


def characteristic(facts: Facts, tree: Any, names: Names) -> dict[int, Poly]:
    """Coefficients of the characteristic polynomial, by exponents."""
    grid = _square(facts, tree, names)
    degree = len(grid)
    found = {degree: ONE, degree - 1: plus({}, _trace(grid), -1), **({0: _determinant(grid)} if degree == _LARGEST else {})}
    return {k: p for k, p in sorted(found.items()) if p}


def _trace(grid: Grid) -> Poly:
    return reduce(plus, (grid[i][i] for i in range(len(grid))), {})


def _determinant(grid: Grid) -> Poly:
    if _is_number(grid):
        return grid[0][0]
    (p, q), (r, s) = grid
    return plus(times(p, s), times(q, r), -1)


def of_matrix(facts: Facts, tree: Any, names: Names) -> Poly:
    """``det``, ``tr`` or ``entry`` of a matrix."""
    if tree[0] != "entry":
        return {"det": _determinant, "tr": _trace}[tree[0]](_square(facts, tree[1], names))
    grid = entries(facts, tree[1], names)
    i, j = tree[2], tree[3] if len(tree) == 4 else 1
    if grid is None or type(i) is not int or type(j) is not int or not (1 <= i <= len(grid) and 1 <= j <= len(grid[0])):
        raise Unknown("no entry of a matrix that is written out")
    return grid[i - 1][j - 1]


def about_matrices(facts: Facts, tree: Any, affirmed: bool, names: Names) -> Fact | None:
    """X = Y, or that X is (nonnegative) definite, or that it is not so; None for another formula."""
    op = tree[0]
    if op in ("psd", "pd"):
        (p, q), (r, s) = _two_by_two(_square(facts, tree[1], names))
        relation = ">" if op == "pd" else ">="
        wanted = [("=", plus(q, r, -1)), *((relation, x) for x in (p, s, plus(times(p, s), times(q, r), -1)))]
    elif op in ("=", "!=") and len(tree) == 3 and any(entries(facts, x, names) is not None for x in tree[1:]):
        affirmed = affirmed == (op == "=")
        first, second = _same([entries(facts, x, names) for x in tree[1:]])
        wanted = [("=", plus(x, y, -1)) for rows in zip(first, second, strict=True) for x, y in zip(*rows, strict=True)]
    else:
        return None
    return joined("and" if affirmed else "or", [facts.relation(relation if affirmed else _DENIED[relation], p) for relation, p in wanted])


_DENIED = {"=": "!=", ">": "<=", ">=": "<"}


def _two_by_two(grid: Grid) -> Grid:
    if _is_number(grid):
        raise Unknown("the order of numbers, as matrices")
    return grid
