# SPDX-License-Identifier: MIT
"""Factors of the matrices whose determinants a lemma is about.

For blocks [A, B; C, D] with an invertible A or D they are those of the Schur complement; for A + XY with an invertible A
the two factorisations of [A, -X; Y, I] show that its determinant is that of A times that of I + Y inv(A) X.

Main definitions
----------------
`by_factors`
    Evidence of an ``order`` to try.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from exactkf.finders.membership import find_order
from exactkf.kernel.definite import nonsingular
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.reader import Reader
from exactkf.kernel.words import Blocks, size_tree

__all__ = ["by_factors"]

_MOST = 4  # matrices that are factored


def by_factors(data: Mapping[str, Any], degree: int, seconds: float) -> Iterator[dict]:
    """Evidence of an ``order`` for a statement about determinants.

    Parameters
    ----------
    data : dict
        JSON of the statement.
    degree, seconds
        Bounds of the search.
    """
    reader, factors = Reader(data), list[Any]()
    for tree in list(_determined(data, data["says"]))[:_MOST]:
        try:
            factors += _of_blocks(reader, tree) if tree[0] == "block" else _of_sum(reader, tree)
        except (Unknown, Undefined):
            continue
    if factors and (parts := find_order(dict(data), factors=factors, degree=degree, seconds=seconds)) is not None:
        yield {"parts": parts, "lemmas": []}


def _determined(data: Mapping[str, Any], tree: Any) -> Iterator[Any]:
    """What stands in determinants, definitions opened."""
    if not isinstance(tree, list) or not tree:
        return
    if tree[0] == "det":
        inner = tree[1]
        lets = {d[1]: d[3] for d in data["where"] if d[0] == "let" and not d[2]}
        while isinstance(inner, list) and inner[0] == "sym" and inner[1] in lets:
            inner = lets[inner[1]]
        if isinstance(inner, list):
            yield inner
    for part in tree[1:]:
        yield from _determined(data, part)


def _of_blocks(reader: Reader, tree: Any) -> list:
    """[A, B; C, D] by its Schur complements."""
    if len(tree) != 3 or any(len(row) != 2 for row in tree[1:]):
        return []
    (a, b), (c, d) = tree[1:]
    whole = reader.read(tree)
    n, p = (size_tree(s) for s in whole.rows)
    made = []
    if nonsingular(reader, a):
        rest = ["-", d, ["*", c, ["inv", a], b]]
        made.append([tree, [_lower(n, p, ["*", c, ["inv", a]]), _diagonal(n, p, a, rest), _upper(n, p, ["*", ["inv", a], b])]])
    if nonsingular(reader, d):
        rest = ["-", a, ["*", b, ["inv", d], c]]
        made.append([tree, [_upper(n, p, ["*", b, ["inv", d]]), _diagonal(n, p, rest, d), _lower(n, p, ["*", ["inv", d], c])]])
    return made


def _of_sum(reader: Reader, tree: Any) -> list:
    """A + XY: both factorisations of [A, -X; Y, I], for each way to cut the product in two."""
    if tree[0] not in ("+", "-") or len(tree) != 3 or tree[2][:1] != ["*"] or not nonsingular(reader, tree[1]):
        return []
    made: list = []
    a, product = tree[1], tree[2][1:]
    for k in range(1, len(product)):
        x, y = (f[0] if len(f) == 1 else ["*", *f] for f in (product[:k], product[k:]))
        value = reader.read(x)
        if not isinstance(value, Blocks) or len(value.rows) != 1 or len(value.cols) != 1:
            continue
        n, p = (size_tree(s) for s in (value.rows[0], value.cols[0]))
        x = ["neg", x] if tree[0] == "+" else x
        whole = ["block", [a, x], [y, ["I", p]]]
        rest = ["-", ["I", p], ["*", y, ["inv", a], x]]
        made.append([whole, [_lower(n, p, ["*", y, ["inv", a]]), _diagonal(n, p, a, rest), _upper(n, p, ["*", ["inv", a], x])]])
        made.append([whole, [_upper(n, p, x), _diagonal(n, p, ["-", a, ["*", x, y]], ["I", p]), _lower(n, p, y)]])
    return made


def _lower(n: Any, p: Any, x: Any) -> list:
    return ["block", [["I", n], ["O", n, p]], [x, ["I", p]]]


def _upper(n: Any, p: Any, x: Any) -> list:
    return ["block", [["I", n], x], [["O", p, n], ["I", p]]]


def _diagonal(n: Any, p: Any, a: Any, d: Any) -> list:
    return ["block", [a, ["O", n, p]], [["O", p, n], d]]
