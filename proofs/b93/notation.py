# SPDX-License-Identifier: MIT
"""Notation of the paper: Hamiltonian matrices and the semigroup H.

Matrices of order 2d are written in d x d blocks, M = [[A, B], [C, D]]; T(M) is the
paper's M*. The form J = [[0, I], [-I, 0]] defines the symplectic group, and H is the
part of it in which A is invertible and BA*, A*C are nonnegative. The subsets H1, H2
and H0 ask A*C, BA* or both to be positive. A positive A*C or BA* forces A to be
invertible, so that condition is not repeated in `in_h1` and `in_h2`.

Every member of H is [[A, AP], [QA, inv(A*) + QAP] with P, Q nonnegative (S38), which is
how members are made here: `member` gives the three blocks that A, P and Q determine.
A sequence of n matrices is kept side by side in one wide matrix, and `piece` takes the
k-th of them.
"""

from __future__ import annotations

from exactkf.language import (
    Expr,
    Identity,
    T,
    Zero,
    block,
    given,
    inv,
    invertible,
    let,
    matrix_of,
    pd,
    psd,
    standing,
    sym,
    symbols,
    vstack,
)

d, n, p, q, r = symbols("d n p q r")
i, j, k = symbols("i j k")
J = sym("J")
FORM = let(J, block([[Zero(d, d), Identity(d)], [-Identity(d), Zero(d, d)]]))
#: the columns that pick the first and the second block row
UPPER = vstack(Identity(d), Zero(d, d))
LOWER = vstack(Zero(d, d), Identity(d))


def hamiltonian(A: Expr, S: Expr, R: Expr) -> Expr:
    """The matrix (7) of a system with S = FF* and R = C*C."""
    return block([[A, S * inv(T(A))], [R * A, (Identity(d) + R * S) * inv(T(A))]])


def preserves_form(M: Expr) -> Expr:
    """M*JM = J."""
    return T(M) * J * M == J


def in_h(M: Expr, A: Expr, B: Expr, C: Expr) -> Expr:
    """M = [[A, B], [C, D]] is in H."""
    return preserves_form(M) & invertible(A) & psd(B * T(A)) & psd(T(A) * C)


def in_h1(M: Expr, A: Expr, B: Expr, C: Expr) -> Expr:
    """M is in H1: A*C is positive."""
    return preserves_form(M) & psd(B * T(A)) & pd(T(A) * C)


def in_h2(M: Expr, A: Expr, B: Expr, C: Expr) -> Expr:
    """M is in H2: BA* is positive."""
    return preserves_form(M) & pd(B * T(A)) & psd(T(A) * C)


def in_h0(M: Expr, A: Expr, B: Expr, C: Expr) -> Expr:
    """M is in H1 and in H2."""
    return preserves_form(M) & pd(B * T(A)) & pd(T(A) * C)


def assumed(M: Expr, A: Expr, B: Expr, C: Expr, standing_only: bool = False) -> list[tuple]:
    """Hypotheses that M is in H, for a nonsingular A."""
    name = M.tree[1]
    rule = standing if standing_only else given
    return [given(f"{name} in Sp", preserves_form(M)), rule(f"{name}: BA* >= 0", psd(B * T(A))), rule(f"{name}: A*C >= 0", psd(T(A) * C))]


def member(A: Expr, B: Expr, C: Expr, D: Expr, P: Expr, Q: Expr) -> dict[Expr, Expr]:
    """The blocks B, C, D of the member of H that A, P and Q determine."""
    return {key.tree[1]: value for key, value in ((B, A * P), (C, Q * A), (D, inv(T(A)) + Q * A * P))}


def part(M: Expr, row: int, column: int) -> Expr:
    """Block of a matrix of order 2d, counted from 0."""
    return matrix_of(i, j, d, d, M[i + row * d if row else i, j + column * d if column else j])


def piece(wide: Expr, rows: Expr, columns: Expr) -> Expr:
    """The k-th of the matrices that stand side by side in a wide matrix."""
    return matrix_of(i, j, rows, columns, wide[i, j + (k - 1) * columns])
