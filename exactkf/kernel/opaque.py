# SPDX-License-Identifier: MIT
"""Terms that are not opened, named by their tree with the forms of its indices.

A determinant, an inverse or a coefficient at infinity of generic size is an atom: two such terms have the same value
where they are the same tree with the same indices. An index is what stands after a name, as an exponent, a place or a bound;
it is replaced by the number of its form, unless it has to do with an index that the term binds itself, in which case it
must have nothing to do with those outside.

Main definitions
----------------
`opaque`
    The text of a term without its indices, and these.
`with_names`
    Such a text, read, with names for the indices.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from typing import Any

from exactkf.kernel.numbers import Unknown
from exactkf.kernel.region import Form

__all__ = ["opaque", "with_names"]

#: operation -> positions of its indices; of those that bind, see _BINDS
_INDICES = {"^": (2,), "coeff": (2,), "laurent": (2,), "entry": (2, 3), "rev": (2,), "I": (1,), "O": (1, 2)}
#: operation -> positions of the names that it binds, of its indices, and of its body
_BINDS = {"sum": ((1,), (2, 3), 4), "prod": ((1,), (2, 3), 4), "mat": ((1, 2), (3, 4), 5), "col": ((1,), (2,), 3)}
_COMPARED = ("=", "!=", "<", "<=", ">", ">=")


def opaque(tree: Any, env: Mapping[str, Form], index: Callable[[Any, Mapping[str, Form]], Form]) -> tuple[str, list[Form]]:
    """Text and indices of a term; ``index`` reads an index in the environment."""
    forms: list[Form] = []

    def place(x: Any, bound: frozenset[str]) -> Any:
        names = _names(x)
        if names & bound:
            if names - bound & env.keys():
                raise Unknown("an index outside and one inside of a term that is not opened")
            return x
        forms.append(index(x, env))
        return ["#", len(forms) - 1]

    def walk(x: Any, bound: frozenset[str]) -> Any:
        if isinstance(x, int):
            return x
        op = x[0]
        if op in ("sym", "z", "rat"):
            if op == "sym" and x[1] in env and x[1] not in bound:
                raise Unknown(f"index {x[1]!r} as a number")
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

    return json.dumps(walk(tree, frozenset())), forms


def with_names(tree: Any) -> Any:
    """The tree of a text with ``@0``, ``@1``, .. for its indices."""
    if not isinstance(tree, list):
        return tree
    return ["sym", f"@{tree[1]}"] if tree[:1] == ["#"] else [with_names(x) for x in tree]


def _names(tree: Any) -> set[str]:
    if not isinstance(tree, list):
        return set()
    return {tree[1]} if tree[:1] == ["sym"] else set().union(*(_names(x) for x in tree))
