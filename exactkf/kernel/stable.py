# SPDX-License-Identifier: MIT
"""Stable matrices: what a hypothesis ``schur(M)`` gives, and how one is shown.

M is stable if its eigenvalues have absolute value less than one; then so is M'.
The facts, for real square matrices of every size:

1. if M is stable and Q semidefinite, X = MXM' + Q has a solution, the sum of
   M^k Q M'^k; it is semidefinite, and definite if Q is;
2. if M and N are stable, D = MDN has the solution zero alone: D = M^k D N^k for
   every k. So the solution in 1 is the only one;
3. M is stable if no x + iy other than zero is an eigenvector of M for an
   eigenvalue a + ib with a^2 + b^2 >= 1; in real terms, if Mx = ax - by,
   My = bx + ay and a^2 + b^2 >= 1 give x = 0 and y = 0.

And of a pair (C, A), observable if C annihilates no eigenvector of A, real or complex:

4. if (C, A) is observable, CX = 0 and AX = XB give X = 0: the columns of X span
   a space that A keeps, and over the complex numbers such a space other than
   zero has an eigenvector of A, which C would annihilate.

Main definitions
----------------
`is_stable`, `is_observable`
    A hypothesis says so.
`no_eigenvector`
    Fact 3, as a statement without ``schur``.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from exactkf.kernel.definite import are_transposed
from exactkf.kernel.numbers import Unknown
from exactkf.kernel.reader import Reader, hypotheses
from exactkf.kernel.words import Blocks, size_tree

__all__ = ["is_observable", "is_stable", "no_eigenvector"]


def is_stable(reader: Reader, tree: Any) -> bool:
    """A hypothesis says that the matrix, or its transpose, is stable."""
    said = [f[1] for _, f in hypotheses(reader.statement) if f[0] == "schur"]
    return any(are_transposed(reader, ["T", tree], x) or are_transposed(reader, tree, x) for x in said)


def is_observable(reader: Reader, c: Any, a: Any) -> bool:
    """A hypothesis says that the pair is observable."""
    said = [f[1:] for _, f in hypotheses(reader.statement) if f[0] == "observable"]
    return any(are_transposed(reader, ["T", c], x) and are_transposed(reader, ["T", a], y) for x, y in said)


def no_eigenvector(statement: Mapping[str, Any], tree: Any) -> tuple[dict[str, Any], Any]:
    """An eigenvector (v.0 + i w.0) with an eigenvalue outside the open disc as hypotheses, v.0 = 0 and w.0 = 0 as the conclusion."""
    x = Reader(statement).read(tree)
    if not isinstance(x, Blocks) or len(x.rows) != 1 or x.rows != x.cols:
        raise Unknown("stability of what is no square matrix in one block")
    v, w, a, b = (["sym", name] for name in ("v.0", "w.0", "eigen.re", "eigen.im"))  # no statement has such names
    column = ["matrix", size_tree(x.rows[0]), 1]
    over = [*statement["over"], *([name[1], column] for name in (v, w)), *([name[1], ["scalar"]] for name in (a, b))]
    given = [*statement["given"],
             ["eigenvector, real part", ["=", ["*", tree, v], ["-", ["*", a, v], ["*", b, w]]], "standing"],
             ["eigenvector, imaginary part", ["=", ["*", tree, w], ["+", ["*", b, v], ["*", a, w]]], "standing"],
             ["eigenvalue", [">=", ["-", ["+", ["*", a, a], ["*", b, b]], 1], 0], "standing"]]
    return {**statement, "over": over, "given": given}, ["=", ["block", [v], [w]], 0]
