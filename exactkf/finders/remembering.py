# SPDX-License-Identifier: MIT
"""Evaluating many statements that differ from one in a single node.

A mutant shares all its nodes with the original but those on the way from the
change to the root. A world that remembers the values of the original's nodes
computes the others only. What is remembered depends on the node, and on the
values of the indices that are bound around it and named in it; equal nodes
are one. Definitions are left to the plain world, which has its own memory.

Main definitions
----------------
`nodes_of`
    The nodes of a formula that are worth remembering.
`Remembering`
    A world that evaluates them once.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown

__all__ = ["Nodes", "Remembering", "nodes_of"]

_BINDERS = {"sum": 1, "prod": 1, "forall": 1, "exists": 1, "always": 1, "col": 1, "mat": 2}
_LEAVES = {"sym", "rat", "z"}

Nodes = Mapping[int, tuple[int, tuple[str, ...]]]


def nodes_of(*formulas: Any) -> Nodes:
    """For each node, by its identity, a number (the same for equal nodes) and the bound indices that it names.

    The formulas must outlive the result.
    """
    numbers: dict[tuple[str, tuple[str, ...]], int] = {}
    found: dict[int, tuple[int, tuple[str, ...]]] = {}

    def visit(tree: Any, bound: tuple[str, ...]) -> set[str]:
        """All names in a node."""
        if not isinstance(tree, list):
            return set()
        op = tree[0]
        names = set(tree[1:2]) if op in ("sym", "at") else set()
        inner = (*bound, *tree[1:1 + _BINDERS.get(op, 0)])
        for part in _parts(tree):
            names |= visit(part, inner)
        if op not in _LEAVES:
            free = tuple(sorted(names.intersection(bound)))
            found[id(tree)] = numbers.setdefault((repr(tree), free), len(numbers)), free
        return names

    for formula in formulas:
        visit(formula, ())
    return found


def _parts(tree: list) -> Iterator[Any]:
    """The nodes just below one."""
    if tree[0] in ("block", "rows"):
        for row in tree[1:]:
            yield from row
    elif tree[0] == "prints":
        yield tree[1]
    else:
        yield from tree[1:]


class Remembering(World):
    """A plain world, with memory for the nodes of one formula.

    Parameters
    ----------
    plain : World
        Where names have their values.
    nodes : Nodes
        What `nodes_of` found in the formula.
    """

    def __init__(self, plain: World, nodes: Nodes) -> None:
        self.plain, self.nodes = plain, nodes
        self.values, self.definitions, self.horizon, self.symbolic = plain.values, plain.definitions, plain.horizon, plain.symbolic
        self.known: dict[Any, Any] = {}

    def value(self, tree: Any, local: Mapping[str, Any] | None = None) -> Any:
        """Value of a term or truth of a formula, as the plain world has it."""
        node = self.nodes.get(id(tree))
        if node is None:
            return super().value(tree, local)
        key = (node[0], *((local or {})[name] for name in node[1])) if node[1] else node[0]
        if key not in self.known:
            try:
                self.known[key] = super().value(tree, local)
            except (Undefined, Unknown) as error:
                self.known[key] = error.with_traceback(None)
        found = self.known[key]
        if isinstance(found, (Undefined, Unknown)):
            raise found
        return found

    def call(self, name: str, args: tuple) -> Any:
        """Value of a definition: the plain world remembers it."""
        return self.plain.call(name, args)
