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
   zero has an eigenvector of A, which C would annihilate;
5. (C, A) is observable if Ax = ax - by, Ay = bx + ay, Cx = 0 and Cy = 0 give
   x = 0 and y = 0.

And of a pencil (M, N), detectable if sM - tN has full column rank for all complex s and t with |s| >= |t|, not both zero:

6. if (M, N) is detectable, MX = 0 gives X = 0 (s = 1, t = 0); so does MX = NXB with a stable B, as u, u', .. with Bu = tu, Bu' = tu' + u, ..
   give (M - tN)Xu = 0, then (M - tN)Xu' = 0, ..; and X = 0 if it has two columns x, y with MX[[a, b], [-b, a]] = NX and a^2 + b^2 >= 1
   (s = a + ib, t = 1 at x + iy).

Main definitions
----------------
`is_stable`, `is_observable`, `is_detectable`
    A hypothesis says so.
`no_eigenvector`, `none_annihilated`
    Facts 3 and 5, as statements without ``schur`` and ``observable``.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from exactkf.kernel.definite import are_transposed
from exactkf.kernel.numbers import Unknown
from exactkf.kernel.reader import Reader, hypotheses
from exactkf.kernel.words import Blocks, size_tree

__all__ = ["is_detectable", "is_observable", "is_stable", "no_eigenvector", "none_annihilated"]


def is_stable(reader: Reader, tree: Any) -> bool:
    """A hypothesis says that the matrix, or its transpose, is stable."""
    said = [f[1] for _, f in hypotheses(reader.statement) if f[0] == "schur"]
    return any(are_transposed(reader, ["T", tree], x) or are_transposed(reader, tree, x) for x in said)


def is_observable(reader: Reader, c: Any, a: Any) -> bool:
    """A hypothesis says that the pair is observable."""
    said = [f[1:] for _, f in hypotheses(reader.statement) if f[0] == "observable"]
    return any(are_transposed(reader, ["T", c], x) and are_transposed(reader, ["T", a], y) for x, y in said)


def is_detectable(reader: Reader, m: Any, n: Any) -> bool:
    """A hypothesis says that the pencil is detectable."""
    said = [f[1:] for _, f in hypotheses(reader.statement) if f[0] == "detectable"]
    return any(are_transposed(reader, ["T", m], x) and are_transposed(reader, ["T", n], y) for x, y in said)


def no_eigenvector(statement: Mapping[str, Any], tree: Any) -> tuple[dict[str, Any], Any]:
    """An eigenvector (v.0 + i w.0) with an eigenvalue outside the open disc as hypotheses, v.0 = 0 and w.0 = 0 as the conclusion."""
    return _without(statement, tree, ["eigenvalue", [">=", ["-", ["+", ["*", _RE, _RE], ["*", _IM, _IM]], 1], 0], "standing"])


def none_annihilated(statement: Mapping[str, Any], c: Any, a: Any) -> tuple[dict[str, Any], Any]:
    """An eigenvector (v.0 + i w.0) of A that C annihilates as hypotheses, v.0 = 0 and w.0 = 0 as the conclusion."""
    reader = Reader(statement)
    rows, inner = reader.read(c), reader.read(a)
    if not isinstance(rows, Blocks) or not isinstance(inner, Blocks) or reader.total(rows.cols) != reader.total(inner.rows):
        raise Unknown("a pair of matrices that do not fit")
    return _without(statement, a, *([f"annihilated, {part}", ["=", ["*", c, x], 0], "standing"] for part, x in (("real part", _V), ("imaginary part", _W))))


_V, _W, _RE, _IM = (["sym", name] for name in ("v.0", "w.0", "eigen.re", "eigen.im"))  # no statement has such names


def _without(statement: Mapping[str, Any], tree: Any, *more: list) -> tuple[dict[str, Any], Any]:
    """An eigenvector of a matrix as hypotheses, with more of them, and that it is zero as the conclusion."""
    x = Reader(statement).read(tree)
    if not isinstance(x, Blocks) or len(x.rows) != 1 or x.rows != x.cols:
        raise Unknown("eigenvectors of what is no square matrix in one block")
    column = ["matrix", size_tree(x.rows[0]), 1]
    over = [*statement["over"], *([name[1], column] for name in (_V, _W)), *([name[1], ["scalar"]] for name in (_RE, _IM))]
    given = [*statement["given"],
             ["eigenvector, real part", ["=", ["*", tree, _V], ["-", ["*", _RE, _V], ["*", _IM, _W]]], "standing"],
             ["eigenvector, imaginary part", ["=", ["*", tree, _W], ["+", ["*", _IM, _V], ["*", _RE, _W]]], "standing"], *more]
    return {**statement, "over": over, "given": given}, ["=", ["block", [_V], [_W]], 0]
