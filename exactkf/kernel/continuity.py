# SPDX-License-Identifier: MIT
"""What holds where some scalars are not zero holds where they are, by continuity.

Let the conclusion be made of equations and of inequalities that are not strict, with ``and`` between them, and its terms of
operations that are continuous where they have a value, and have one nearby: sums, products, quotients, powers, determinants,
traces, transposes, inverses, blocks. Let no hypothesis mention the scalars. Take an instance of the statement at which they
vanish, some or all. Change them to numbers close by that are not zero: the hypotheses stay as they are, each part of the
conclusion that has a value keeps one, and what is shown of scalars other than zero says that it is true there. In the limit it
is true at the instance itself: both sides of an equation are continuous, and limits of semidefinite matrices are semidefinite.
The members of a conjunction are looked at in turn: the second counts where the first is true, which has been shown.

An exponent must not mention the scalars; a power has a value nearby, whatever its exponent, and t^0 is one for every t.

Main definitions
----------------
`away_from_zero`
    The statement about scalars other than zero that is enough.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from exactkf.kernel.numbers import Unknown

__all__ = ["away_from_zero"]

#: formulas that stay true in a limit
_CLOSED = ("=", "<=", ">=", "loewner", "psd", "symmetric", "symplectic")
#: operations that are continuous, and defined on open sets
_CONTINUOUS = ("+", "-", "neg", "*", "/", "T", "inv", "det", "tr", "block")


def away_from_zero(statement: Mapping[str, Any], names: Sequence[str]) -> dict[str, Any]:
    """The statement with these scalars of type ``nonzero``.

    Raises
    ------
    Unknown
        Where it need not be enough.
    """
    kinds = {name: kind for name, kind in statement["over"]}
    if not names or not all(isinstance(name, str) and kinds.get(name) == ["scalar"] for name in names):
        raise Unknown("continuity is for scalars that may be zero")
    look = _Look(statement, names)
    if any(look.mentions(formula) for _, formula, _ in statement["given"]):
        raise Unknown("continuity in a scalar that a hypothesis is about")
    look.definitions()
    look.closed(statement["says"])
    return {**statement, "over": [[name, ["nonzero"] if name in names else kind] for name, kind in statement["over"]]}


class _Look:
    """What trees of a statement have to do with the scalars."""

    def __init__(self, statement: Mapping[str, Any], names: Sequence[str]) -> None:
        self.scalars, self.touched = set(names), set(names)
        self.bodies = {d[1]: d for d in statement["where"]}
        while more := {name for name, d in self.bodies.items() if name not in self.touched and self.mentions(list(d[2:]))}:
            self.touched |= more

    def mentions(self, tree: Any) -> bool:
        """A tree, or what a name in it stands for, has one of the scalars in it."""
        return tree in self.touched if isinstance(tree, str) else isinstance(tree, (list, tuple)) and any(map(self.mentions, tree))

    def definitions(self) -> None:
        """Definitions have a value nearby, too."""
        for name in self.touched - self.scalars:
            kind, _, parameters, body, *_ = self.bodies[name]
            if kind != "let" or parameters:
                raise Unknown(f"{name!r} need not be continuous")
            self.continuous(body)

    def closed(self, formula: Any) -> None:
        if formula[0] == "and":
            for part in formula[1:]:
                self.closed(part)
        elif formula[0] in _CLOSED:
            for term in formula[1:]:
                self.continuous(term)
        elif self.mentions(formula):
            raise Unknown(f"{formula[0]!r} need not stay true in a limit")

    def continuous(self, tree: Any) -> None:
        if not self.mentions(tree):
            return
        if not isinstance(tree[0], str):  # a row of a block matrix
            for part in tree:
                self.continuous(part)
            return
        op, *args = tree
        if op == "sym":
            return  # a scalar, or a definition, which is looked at by itself
        elif op == "^" and not self.mentions(args[1]):
            self.continuous(args[0])
        elif op in _CONTINUOUS:
            for part in args:
                self.continuous(part)
        else:
            raise Unknown(f"{op!r} need not be continuous")
