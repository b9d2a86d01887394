# SPDX-License-Identifier: MIT
"""Shared notation of NWL92: the 2-block matrix of an estimation problem and its symmetric (1)-inverses.

A measurement y = Hx + v with cov v = R >= 0 is described by the symmetric
matrix Z = [R, H; H', 0]. What the paper calls its pseudoinverse is any
symmetric G with ZGZ = Z; its blocks are called W, U, T.

Every symmetric Z has such inverses: with the columns of K spanning the
kernel of Z, the matrix Z + KK' is invertible and its inverse is one of them
(`one_inverse`); all others differ from it by KK'Y + Y'KK' for a free matrix Y
(`any_one_inverse`; claim NWL92-E2.20 says that this reaches them all).
"""

from __future__ import annotations

from typing import Any

from exactkf.evidence import Evidence, instances
from exactkf.language import (
    Expr, Identity, T, Zero, block, given, hstack, inv, kernel_basis, let, matrix,
    positive_semidefinite, rank, sym, symbols, symmetric_matrix, vstack,
)

# sizes
d, g, k, m, n, p, q, r = symbols("d g k m n p q r")
# data of a measurement, blocks of a (1)-inverse, free matrices
R, H, W, U, V, X, Y = symbols("R H W U V X Y")
Tb = sym("T")  # the block T of a (1)-inverse (the name T is the transpose here)
x, y, w, x0, w0, lam = symbols("x y w x0 w0 lam")
Zm, Zd = symbols("Zm Zd")
B, G = symbols("B G")


def two_block(R: Expr, H: Expr, n: Any) -> Expr:
    """[R, H; H', 0], where H has n columns."""
    return block([[R, H], [T(H), Zero(n, n)]])


def upper(p: Any, n: Any) -> Expr:
    """[I; 0]: the first p of p + n coordinates."""
    return vstack(Identity(p), Zero(n, p))


def lower(p: Any, n: Any) -> Expr:
    """[0; I]: the last n of p + n coordinates."""
    return vstack(Zero(p, n), Identity(n))


def one_inverse(Z: Expr) -> Expr:
    """One symmetric (1)-inverse of a symmetric matrix."""
    K = kernel_basis(Z)
    return inv(Z + K * T(K))


def any_one_inverse(Z: Expr, Y: Expr) -> Expr:
    """All symmetric (1)-inverses of a symmetric matrix, one for each matrix Y (of the size of Z)."""
    K = kernel_basis(Z)
    return one_inverse(Z) + K * T(K) * Y + T(Y) * K * T(K)


def blocks_of(G: Expr, p: Any, n: Any) -> tuple[Expr, Expr, Expr]:
    """Blocks W (p x p), U (p x n), T (n x n) of a symmetric matrix."""
    a, b = upper(p, n), lower(p, n)
    return T(a) * G * a, T(a) * G * b, T(b) * G * b


#: Z and a symmetric (1)-inverse of it, with blocks W, U, T
TWO_BLOCK = let(Zm, two_block(R, H, n))
INVERSE = let(Zd, block([[W, U], [T(U), Tb]]))
PAIR = (TWO_BLOCK, INVERSE)
ONE_INVERSE = given("(2.20)", Zm * Zd * Zm == Zm)
FULL_COLUMN_RANK = given("H has full column rank", rank(H) == n)
BLOCKS = {W: symmetric_matrix(p), U: matrix(p, n), Tb: symmetric_matrix(n)}
#: data and one (1)-inverse; where the claim needs no measurement
SETTING = {R: positive_semidefinite(p), H: matrix(p, n), **BLOCKS}
SIZES = {"p": (1, 2, 3), "n": (1, 2)}
#: a second symmetric (1)-inverse of the same Z
W2, U2, T2, Y2, G2, Ze = symbols("W2 U2 T2 Y2 G2 Ze")
SECOND = {W2: symmetric_matrix(p), U2: matrix(p, n), T2: symmetric_matrix(n)}
SECOND_INVERSE = let(Ze, block([[W2, U2], [T(U2), T2]]))
SECOND_GIVEN = given("second (1)-inverse", Zm * Ze * Zm == Zm)
#: another linear estimate Ly that is unbiased, LH = I
L = sym("L")
UNBIASED = given("the other estimate is unbiased", L * H == Identity(n))
OTHER = {L: T(U) + X * (Identity(p) - H * T(U))}


def made_inverse(Z: Expr, names: tuple[Expr, Expr, Expr], p: Any, n: Any, free: Expr = Y, whole: Expr = G) -> tuple[dict, dict]:
    """What `instances` needs so that the named blocks form a random symmetric (1)-inverse of Z: made_by and using."""
    made = {whole: any_one_inverse(Z, free), **dict(zip(names, blocks_of(whole, p, n), strict=True))}
    return made, {free: matrix(p + n, p + n)}


def inverses(count: int = 24, *, made_by: dict | None = None, using: dict | None = None, before: dict | None = None, **sizes: Any) -> Evidence:
    """Instances in which (W, U, T) is a random symmetric (1)-inverse of Z; ``before`` computes R or H first."""
    made, free = made_inverse(Zm, (W, U, Tb), p, n)
    return instances(count, made_by={**(before or {}), **made, **(made_by or {})}, using={**free, **(using or {})}, **(sizes or SIZES))


def two_inverses(count: int = 24, *, made_by: dict | None = None, using: dict | None = None, **sizes: Any) -> Evidence:
    """The same with a second random symmetric (1)-inverse (W2, U2, T2)."""
    made, free = made_inverse(Zm, (W2, U2, T2), p, n, Y2, G2)
    return inverses(count, made_by={**made, **(made_by or {})}, using={**free, **(using or {})}, **sizes)


def excess(L: Expr, U: Expr, R: Expr) -> Expr:
    """Error covariance of Ly as that of U'y plus a positive semidefinite matrix."""
    return L * R * T(L) == T(U) * R * U + (L - T(U)) * R * T(L - T(U))


def likeliest(x: Expr, w: Expr, y: Expr, H: Expr, V: Expr, w0: Expr) -> Expr:
    """(x, w) satisfies y = Hx + Vw, and any other (x0, w0) that does has w0'w0 = w'w + |w0 - w|^2."""
    return (y == H * x + V * w) & (T(w0) * w0 == T(w) * w + T(w0 - w) * (w0 - w))
