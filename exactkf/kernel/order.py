# SPDX-License-Identifier: MIT
"""Order on symmetric matrices of every size, by a few classical facts.

`definiteness` reads a term and says whether its form alone makes it positive
(semi)definite under the hypotheses. The facts it uses:

1. a variable of type psd, pd, and a hypothesis that says so;
2. the identity and I are positive definite; a nonnegative number times a
   semidefinite matrix is semidefinite;
3. a sum of semidefinite matrices is semidefinite, definite if one of them is;
4. a congruence X'PX of a semidefinite matrix is semidefinite, and of a definite
   one definite if X is nonsingular;
5. the inverse of an invertible semidefinite matrix is definite.

A certificate of kind ``order`` writes the matrix of the conclusion as a sum of
such terms plus multiples of the assumptions (`exactkf.kernel.words`).
"""

from __future__ import annotations

from typing import Any

from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.words import Blocks, Reader

__all__ = ["definiteness", "goal_of"]


def goal_of(reader: Reader, formula: Any) -> tuple[Blocks, int]:
    """Matrix that is to be semidefinite (1) or definite (2)."""
    op = formula[0]
    if op in ("psd", "pd"):
        found = reader.read(formula[1])
    elif op == "loewner":
        found = reader._plus(reader.read(formula[1]), reader.read(formula[2]), -1)
    elif op in ("<=", "<", ">=", ">") and len(formula) == 3:
        big, small = (formula[1], formula[2]) if op in (">=", ">") else (formula[2], formula[1])
        found = reader._plus(reader.read(big), reader.read(small), -1)
    else:
        raise Unknown(f"{op!r} is no statement of order")
    if not isinstance(found, Blocks) or len(found.rows) != 1 or found.rows != found.cols:
        raise Unknown("the order of block matrices or scalars")
    return found, 2 if op in ("pd", "<", ">") else 1


def definiteness(reader: Reader, tree: Any) -> int:
    """0: not known, 1: positive semidefinite, 2: positive definite."""
    known = _by_hypothesis(reader, tree)
    if known:
        return known
    if isinstance(tree, int):
        return 1 if tree >= 0 else 0
    op, args = tree[0], tree[1:]
    if op == "sym":
        definition = reader.lets.get(args[0])
        if args[0] not in reader.kinds and definition is not None and definition[0] == "let" and not definition[2]:
            return definiteness(reader, definition[3])
        return {"psd": 1, "pd": 2, "nonneg": 1, "positive": 2}.get(reader.kinds.get(args[0], ("",))[0], 0)
    if op == "I":
        return 2
    if op == "O":
        return 1
    if op == "+":
        found = [definiteness(reader, a) for a in args]
        return 0 if 0 in found else max(found)
    if op == "inv":
        return 2 if definiteness(reader, args[0]) else 0
    if op == "T":
        return definiteness(reader, args[0])
    return _congruence(reader, list(args)) if op == "*" else 0


def _congruence(reader: Reader, factors: list[Any]) -> int:
    """X_1 ... X_k P X_k' ... X_1' (P = I may be left out), with nonnegative numbers in front."""
    strict = True
    while factors and isinstance(factors[0], int):
        number = factors.pop(0)
        if number < 0:
            return 0
        strict = strict and number > 0
    while len(factors) > 1:
        first, last = factors.pop(0), factors.pop()
        if not _transposed(reader, first, last):
            return 0
        strict = strict and _nonsingular(reader, first)
    middle = definiteness(reader, factors[0]) if factors else 2
    return middle if strict or middle == 0 else 1


def _transposed(reader: Reader, x: Any, y: Any) -> bool:
    try:
        a, b = reader.transpose(reader.read(x)), reader.read(y)
    except (Undefined, Unknown):
        return False
    return isinstance(a, Blocks) and isinstance(b, Blocks) and (a.rows, a.cols, a.grid) == (b.rows, b.cols, b.grid)


def _nonsingular(reader: Reader, tree: Any) -> bool:
    """A variable of type nonsingular or pd, its transpose, an inverse."""
    if not isinstance(tree, (list, tuple)):
        return False
    if tree[0] in ("T",):
        return _nonsingular(reader, tree[1])
    return tree[0] == "inv" or (tree[0] == "sym" and reader.kinds.get(tree[1], ("",))[0] in ("nonsingular", "pd"))


def _by_hypothesis(reader: Reader, tree: Any) -> int:
    for _, formula, _kind in reader.statement["given"]:
        for part in formula[1:] if formula[0] == "and" else [formula]:
            if part[0] in ("psd", "pd") and part[1] == tree:
                return 2 if part[0] == "pd" else 1
            if part[0] == "loewner" and (["-", part[1], part[2]] == tree or (part[2] == 0 and part[1] == tree)):
                return 1
    return 0

