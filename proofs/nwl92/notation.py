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

from exactkf.evidence import Evidence, instances, order
from exactkf.language import (
    Expr,
    Identity,
    T,
    Zero,
    block,
    given,
    hstack,
    inv,
    invertible,
    kernel_basis,
    let,
    loewner,
    matrix,
    positive_semidefinite,
    rank,
    standing,
    sym,
    symbols,
    symmetric_matrix,
    vstack,
)

# sizes
k, m, n, p, q, r = symbols("k m n p q r")
# data of a measurement, blocks of a (1)-inverse, free matrices
R, H, W, U, V, X, Y = symbols("R H W U V X Y")
Tb = sym("T")  # the block T of a (1)-inverse (the name T is the transpose here)
x, y, w, x0, w0, lam = symbols("x y w x0 w0 lam")
Zm, Zd = symbols("Zm Zd")
G = sym("G")


def two_block(R: Expr, H: Expr, n: Any) -> Expr:
    """[R, H; H', 0], where H has n columns."""
    return block([[R, H], [T(H), Zero(n, n)]])


def upper(p: Any, n: Any) -> Expr:
    """[I; 0]: the first p of p + n coordinates."""
    return vstack(Identity(p), Zero(n, p))


def lower(p: Any, n: Any) -> Expr:
    """[0; I]: the last n of p + n coordinates."""
    return vstack(Zero(p, n), Identity(n))


def real_form(real: Expr, imaginary: Expr) -> Expr:
    """[X, -Y; Y, X] of X + iY."""
    return block([[real, -imaginary], [imaginary, real]])


def one_inverse(Z: Expr) -> Expr:
    """One symmetric (1)-inverse of a symmetric matrix."""
    K = kernel_basis(Z)
    return inv(Z + K * T(K))


def any_one_inverse(Z: Expr, Y: Expr, K: Expr | None = None) -> Expr:
    """All symmetric (1)-inverses of a symmetric matrix, one for each Y of its size; K spans the kernel."""
    K = kernel_basis(Z) if K is None else K
    return inv(Z + K * T(K)) + K * (T(K) * Y) + T(Y) * K * T(K)


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
#: another linear estimate Ly that is unbiased, LH = I; there is one only if H has full column rank
L, L0 = symbols("L L0")
UNBIASED = given("Ly is unbiased", L * H == Identity(n))
IMPLIED_RANK = standing("H has full column rank", rank(H) == n)
OTHER = {L0: inv(T(H) * H) * T(H), L: L0 + X * (Identity(p) - H * L0)}


def made_inverse(Z: Expr, names: tuple[Expr, Expr, Expr], p: Any, n: Any, free: Expr = Y,
                 whole: Expr = G) -> tuple[dict, dict]:
    """What `instances` needs so that the named blocks form a random symmetric (1)-inverse of Z: made_by and using."""
    kernel = sym(f"ker{whole.tree[1]}")
    made = {kernel: kernel_basis(Z), whole: any_one_inverse(Z, free, kernel),
            **dict(zip(names, blocks_of(whole, p, n), strict=True))}
    return made, {free: matrix(p + n, p + n)}


def inverses(count: int = 24, *, made_by: dict | None = None, using: dict | None = None, before: dict | None = None,
             **sizes: Any) -> Evidence:
    """Instances in which (W, U, T) is a random symmetric (1)-inverse of Z; ``before`` computes R or H first."""
    made, free = made_inverse(Zm, (W, U, Tb), p, n)
    return instances(count, made_by={**(before or {}), **made, **(made_by or {})}, using={**free, **(using or {})},
                     **(sizes or SIZES))


def two_inverses(count: int = 24, *, made_by: dict | None = None, using: dict | None = None, **sizes: Any) -> Evidence:
    """The same with a second random symmetric (1)-inverse (W2, U2, T2)."""
    made, free = made_inverse(Zm, (W2, U2, T2), p, n, Y2, G2)
    return inverses(count, made_by={**made, **(made_by or {})}, using={**free, **(using or {})}, **sizes)


def excess(L: Expr, U: Expr, R: Expr) -> Expr:
    """The error covariance of Ly is at least that of U'y."""
    return loewner(L * R * T(L), T(U) * R * U)


def excess_term(L: Expr, U: Expr, R: Expr) -> Expr:
    """By how much it is larger, if LH = U'H and RU is a multiple of H."""
    return (L - T(U)) * R * T(L - T(U))


def likeliest(x: Expr, w: Expr, y: Expr, H: Expr, V: Expr, w0: Expr) -> Expr:
    """(x, w) satisfies y = Hx + Vw with w orthogonal to w0 - w, so that w0'w0 = w'w + |w0 - w|^2."""
    return (y == H * x + V * w) & (T(w) * w0 == T(w) * w)


# ------------------------------------------------------------------ every size at once
#: H has full column rank, said through H'H (NWL92-EA.1)
GRAM = given("H has full column rank", invertible(T(H) * H))
IMPLIED_GRAM = standing("H has full column rank", invertible(T(H) * H))


def block_identities(R: Expr, H: Expr, W: Expr, U: Expr, Tb: Expr, n: Any, p: Any, gram: Expr | None = None) -> tuple[list, list]:
    """From ZGZ = Z with R >= 0 and invertible H'H to U'H = I and RU + HT = 0, with what each step needs.

    The columns [a; b] of I - GZ lie in the kernel of Z: Ra + Hb = 0 and H'a = 0. So a'Ra = -a'Hb = 0, hence Ra = 0
    and Hb = 0, that is b = 0.
    """
    gram = T(H) * H if gram is None else gram
    a, b = hstack(Identity(p) - W * R - U * T(H), -(W * H)), hstack(-(T(U) * R + Tb * T(H)), Identity(n) - T(U) * H)
    steps = [
        (vstack(R * a + H * b, T(H) * a) == Zero(p + n, p + n), []),
        (T(a) * R * a * Identity(p + n) == Zero(p + n, p + n), []),
        (R * a == Zero(p, p + n), [T(a) * R * a]),
        (H * b == Zero(p, p + n), []),
        (inv(gram) * T(H) * (H * b) == Zero(n, p + n), []),
        (T(U) * H == Identity(n), [inv(gram)]),
        (R * U + H * Tb == Zero(p, n), [inv(gram)]),
    ]
    return [lemma for lemma, _ in steps], [needs for _, needs in steps]


def identities_at_once(R: Expr, H: Expr, W: Expr, U: Expr, Tb: Expr, n: Any, p: Any, gram: Expr) -> tuple[Expr, list, list]:
    """Z(U; T) = (0; I) as one lemma, with `block_identities` as lemmas that belong to it, and what these and it need."""
    lemmas, needs = block_identities(R, H, W, U, Tb, n, p, gram)
    return vstack(R * U + H * Tb, T(H) * U) == vstack(0 * (R * U), Identity(n)), lemmas[:-1], needs


def any_rank_identities(R: Expr, H: Expr, W: Expr, U: Expr, Tb: Expr, n: Any, p: Any) -> tuple[list, list]:
    """What ZGZ = Z with R >= 0 gives for H of any rank: with the columns [a; b] of I - GZ as in `block_identities`, Ra = 0 and Hb = 0."""
    a, b = hstack(Identity(p) - W * R - U * T(H), -(W * H)), hstack(-(T(U) * R + Tb * T(H)), Identity(n) - T(U) * H)
    steps = [
        (vstack(R * a + H * b, T(H) * a) == Zero(p + n, p + n), []),
        (T(a) * R * a * Identity(p + n) == Zero(p + n, p + n), []),
        (R * a == Zero(p, p + n), [T(a) * R * a]),
        (H * b == Zero(p, p + n), []),
    ]
    return [lemma for lemma, _ in steps], [needs for _, needs in steps]


def root_identities(R: Expr, V: Expr, H: Expr, W: Expr, U: Expr, p: Any) -> tuple[list, list]:
    """From RU + HT = 0, U'H = I, RWH = 0 and the first block of ZGZ = Z, for R = VV': V'(WR + UH' - I) = 0 and V'WH = 0."""
    rest = W * R + U * T(H) - Identity(p)
    steps = [(V * T(V) * rest == 0 * R, []), (T(V) * rest == 0 * T(V), [V * T(V)]),
             (V * T(V) * (W * H) == 0 * H, []), (T(V) * (W * H) == 0 * (T(V) * H), [V * T(V)])]
    return [lemma for lemma, _ in steps], [needs for _, needs in steps]


def chained(*steps: tuple[list, list], sums: tuple = (), inside: list | tuple = ()) -> Evidence:
    """Lemmas with what each needs, one list after the other, then what the leaves of the conclusion need."""
    return order(*(needs for _, several in steps for needs in several), *sums, lemmas=[lemma for lemmas, _ in steps for lemma in lemmas],
                 inside=inside)


def every_size(*sums: list, second: bool = False, also: tuple = ()) -> Evidence:
    """The conclusion for every size by `block_identities` for (W, U, T), or the blocks ``also`` lists."""
    lemmas, needs = [], []
    for problem in also or ((R, H, W, U, Tb, n, p), *(((R, H, W2, U2, T2, n, p),) if second else ())):
        more, most = block_identities(*problem)
        lemmas, needs = lemmas + more, needs + most
    return order(*needs, *sums, lemmas=lemmas)
