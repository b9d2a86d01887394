# SPDX-License-Identifier: MIT
"""Terms that are not opened, named by their tree with the forms of its indices.

A determinant, an inverse or a coefficient at infinity of generic size is an atom: two such terms have the same value
where they are the same tree with the same indices. An index is what stands after a name, as an exponent, a place or a bound;
it is replaced by the number of its form, unless it has to do with an index that the term binds itself, in which case it
must have nothing to do with those outside.

Main definitions
----------------
`without_indices`
    The text of a term without its indices, and these.
`parsed`, `with_names`
    Such a text, read, with its indices numbered on, or with names for them.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import lru_cache
from typing import Any

from exactkf.kernel.numbers import Unknown

__all__ = ["parsed", "with_names", "without_indices"]

#: operation -> positions of its indices; of those that bind, see _BINDS
_INDICES = {"^": (2,), "coeff": (2,), "laurent": (2,), "entry": (2, 3), "rev": (2,), "I": (1,), "O": (1, 2)}
#: operation -> positions of the names that it binds, of its indices, and of its body
_BINDS = {"sum": ((1,), (2, 3), 4), "prod": ((1,), (2, 3), 4), "mat": ((1, 2), (3, 4), 5), "col": ((1,), (2,), 3)}
_COMPARED = ("=", "!=", "<", "<=", ">", ">=")


def without_indices(tree: Any) -> tuple[str, list, set[str]]:
    """Text of a term without its indices, these, and names that must not be those of indices: what stands as a number, or beside an index bound inside."""
    places, free = list[Any](), set[str]()

    def place(x: Any, bound: frozenset[str]) -> Any:
        names = _names(x)
        if names & bound:
            free.update(names - bound)
            return x
        places.append(x)
        return ["#", len(places) - 1]

    def walk(x: Any, bound: frozenset[str]) -> Any:
        if isinstance(x, int):
            return x
        op = x[0]
        if op in ("sym", "z", "rat"):
            if op == "sym" and x[1] not in bound:
                free.add(x[1])
            return x
        if op == "at":
            return [op, x[1], *(place(a, bound) for a in x[2:])]
        if op in _COMPARED:
            return [op, *(place(a, bound) for a in x[1:])]
        if op in _BINDS:
            names, bounds, body = _BINDS[op]
            inner = bound | {x[k] for k in names}
            return [op, *(x[k] for k in names), *(place(x[k], bound) for k in bounds), walk(x[body], inner)]
        if op in ("forall", "exists", "always", "block", "rows", "stein"):
            raise Unknown(f"{op!r} in a term that is not opened")
        return [op, *(place(a, bound) if k in _INDICES.get(op, ()) else walk(a, bound) for k, a in enumerate(x[1:], 1))]

    return json.dumps(walk(tree, frozenset())), places, free


@lru_cache(maxsize=1 << 12)
def parsed(text: str, first: int = 0) -> Any:
    """The tree of a text, its indices numbered from there on; it is given out again, and not to be changed."""
    return _replaced(json.loads(text), lambda n: ["#", n + first])


@lru_cache(maxsize=1 << 12)
def with_names(text: str) -> Any:
    """The tree of a text with ``@0``, ``@1``, .. for its indices; it is given out again, and not to be changed."""
    return _replaced(json.loads(text), lambda n: ["sym", f"@{n}"])


def _replaced(tree: Any, index: Callable[[int], list]) -> Any:
    if not isinstance(tree, list):
        return tree
    return index(tree[1]) if tree[:1] == ["#"] else [_replaced(x, index) for x in tree]


def _names(tree: Any) -> set[str]:
    if not isinstance(tree, list):
        return set()
    return {tree[1]} if tree[:1] == ["sym"] else set().union(*(_names(x) for x in tree))
