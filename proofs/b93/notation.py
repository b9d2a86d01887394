# SPDX-License-Identifier: MIT
"""Notation of the paper: Hamiltonian matrices and the semigroup H.

Matrices of order 2d are written in d x d blocks, M = [[A, B], [C, D]]; T(M) is the
paper's M*. The form J = [[0, I], [-I, 0]] defines the symplectic group, and H is the
part of it in which A is invertible and BA*, A*C are nonnegative. The subsets H1, H2
and H0 ask A*C, BA* or both to be positive.

Every member of H is [[A, AP], [QA, inv(A*) + QAP]] with P, Q nonnegative (S38), which is
how members are made here: `member` gives the three blocks that A, P and Q determine.
A sequence of n matrices is kept side by side in one wide matrix, and `piece` takes the
k-th of them.

For a product M3 = M2 M1 the matrices P2 = inv(A2)B2 and Q1 = C1 inv(A1) are written in
`Factor` as congruences of BA* and A*C, which shows that they are nonnegative, and
`Product` has the sums of nonnegative terms and the inverse that every proof of section
1.1 uses.
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
    loewner,
    matrix_of,
    pd,
    psd,
    standing,
    sym,
    symbols,
    symplectic,
    vstack,
)

d, n, p, q, r = symbols("d n p q r")
i, j, k = symbols("i j k")
#: the columns that pick the first and the second block row
UPPER, LOWER = vstack(Identity(d), Zero(d, d)), vstack(Zero(d, d), Identity(d))
J = sym("J")
FORM = let(J, block([[Zero(d, d), Identity(d)], [-Identity(d), Zero(d, d)]]))


def hamiltonian(A: Expr, S: Expr, R: Expr) -> Expr:
    """The matrix (7) of a system with S = FF* and R = C*C."""
    return block([[A, S * inv(T(A))], [R * A, (Identity(d) + R * S) * inv(T(A))]])


def in_h(M: Expr, A: Expr, B: Expr, C: Expr) -> Expr:
    """M = [[A, B], [C, D]] is in H."""
    return symplectic(M) & invertible(A) & psd(B * T(A)) & psd(T(A) * C)


def in_h1(M: Expr, A: Expr, B: Expr, C: Expr) -> Expr:
    """M is in H1: A*C is positive."""
    return symplectic(M) & invertible(A) & psd(B * T(A)) & pd(T(A) * C)


def in_h2(M: Expr, A: Expr, B: Expr, C: Expr) -> Expr:
    """M is in H2: BA* is positive."""
    return symplectic(M) & invertible(A) & pd(B * T(A)) & psd(T(A) * C)


def in_h0(M: Expr, A: Expr, B: Expr, C: Expr) -> Expr:
    """M is in H1 and in H2."""
    return symplectic(M) & invertible(A) & pd(B * T(A)) & pd(T(A) * C)


def member_of_h(M: Expr, A: Expr, B: Expr, C: Expr, *needed: str) -> list[tuple]:
    """Hypotheses that M is in H, for a nonsingular A; those named, of Sp, BA* and A*C, are needed and not just the setting."""
    name = M.tree[1]
    parts = {"Sp": (f"{name} in Sp", symplectic(M)), "BA*": (f"{name}: BA* >= 0", psd(B * T(A))),
             "A*C": (f"{name}: A*C >= 0", psd(T(A) * C))}
    return [(given if key in needed else standing)(*part) for key, part in parts.items()]


def member(A: Expr, B: Expr, C: Expr, D: Expr, P: Expr, Q: Expr) -> dict[str, Expr]:
    """The blocks B, C, D of the member of H that A, P and Q determine."""
    return {B.tree[1]: A * P, C.tree[1]: Q * A, D.tree[1]: inv(T(A)) + Q * A * P}


def part(M: Expr, row: int, column: int) -> Expr:
    """Block of a matrix of order 2d, counted from 0."""
    return T((UPPER, LOWER)[row]) * M * (UPPER, LOWER)[column]


def piece(wide: Expr, rows: Expr, columns: Expr) -> Expr:
    """The k-th of the matrices that stand side by side in a wide matrix."""
    return matrix_of(i, j, rows, columns, wide[i, j + (k - 1) * columns])


def numbers(names: str, *entries: int, **more: int) -> dict:
    """An instance by hand with d = 1: entries for the blocks in the order of their names."""
    return {"d": 1, **{name: [[x]] for name, x in (*zip(names.split(), entries, strict=True), *more.items())}}


class Factor:
    """P = inv(A)B and Q = C inv(A) of a member of H, as congruences of BA* and A*C."""

    def __init__(self, A: Expr, B: Expr, C: Expr) -> None:
        self.A, self.B, self.C = A, B, C
        self.BA, self.AC = B * T(A), T(A) * C
        self.P, self.Q = inv(A) * self.BA * T(inv(A)), T(inv(A)) * self.AC * inv(A)


class Product:
    """The product of ``last`` and ``first``, whose upper left block is A3.

    ``inverse`` is the inverse of A3 = A2(I + P2 Q1)A1, with ``root`` a symmetric square root of P2;
    ``lower`` and ``upper`` are the summands of A*C and BA* of the product.
    """

    def __init__(self, last: Factor, first: Factor, A3: Expr, root: Expr) -> None:
        P, Q, H = last.P, first.Q, root
        middle = Identity(d) - H * inv(Identity(d) + H * Q * H) * H * Q
        self.roots = {root: P}
        self.inverse = [inv(first.A) * middle * inv(last.A)]
        x, y = inv(last.A) * A3, T(inv(first.A)) * T(A3)
        self.lower = [T(x) * last.AC * x, first.AC, T(first.C) * P * first.C]
        self.upper = [T(y) * first.BA * y, last.BA, last.B * Q * T(last.B)]


#: what the estimates of norms say
BY_NORMS = "The norm of X is the least c >= 0 with |Xx| <= c|x| for every x, that is X*X <= c^2 I. What is said of norms is said of all positive bounds of them. "


def at_most(X: Expr, bound: Expr, size: Expr = d) -> Expr:
    """The norm of X, which has so many columns, is at most a number that is not negative."""
    return loewner(bound**2 * Identity(size), T(X) * X)


def from_squares(X: Expr, bound: Expr) -> list:
    """Terms of cI - X for a symmetric X with |X| <= c, where c is positive."""
    below = bound * Identity(d) - X
    return [1 / (2 * bound) * (bound**2 * Identity(d) - T(X) * X), 1 / (2 * bound) * below * below]


def squared_bound(bound: Expr, root: Expr, *terms: Expr) -> list:
    """Terms of c^2 I - XX for a nonnegative X with a root, from terms of cI - X."""
    return [bound * x for x in terms] + [root * x * root for x in terms]


def root_bound(X: Expr, bound: Expr, of_inverse: Expr, root: Expr) -> list:
    """Terms of X - cI for a nonnegative X with a root, if |inv(X)| is at most 1/c, in the form given."""
    shifted, left = inv(X + bound * Identity(d)), X * (of_inverse**2 * Identity(d) - T(inv(X)) * inv(X)) * X
    return [bound**3 * shifted * left * shifted, bound**2 * shifted * root * left * root * shifted]
