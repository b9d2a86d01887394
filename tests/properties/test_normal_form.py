# SPDX-License-Identifier: MIT
"""The normal form that the coordinates of NWL92 rest on, built for random singular problems.

For R >= 0 and H of full column rank the rows of S are a left inverse of H that
is uncorrelated with the rest, a complement, and the vectors that R and H' both
annihilate. A symmetric (1)-inverse then has the blocks that the claims assume.
"""

from __future__ import annotations

import random
from fractions import Fraction

import pytest

from exactkf.kernel.linear import Matrix, block, inertia, null_basis


def _zeros(rows, cols):
    return Matrix.build(rows, cols, lambda i, j: Fraction(0))


def _random(rng, rows, cols):
    return Matrix.build(rows, cols, lambda i, j: Fraction(rng.choice((-2, -1, 0, 0, 1, 2, 3)), rng.choice((1, 1, 2))))


def _problem(rng, p, n, rank):
    """R >= 0 of a given rank, H of full column rank, any symmetric (1)-inverse of the 2-block matrix."""
    while True:
        H, V = _random(rng, p, n), _random(rng, p, rank)
        if null_basis(H).ncols == 0:
            break
    R = V * V.transpose() if rank else _zeros(p, p)
    Z = block([[R, H], [H.transpose(), _zeros(n, n)]])
    K = null_basis(Z)
    KK = K * K.transpose() if K.ncols else _zeros(p + n, p + n)
    Y = _random(rng, p + n, p + n)
    G = (Z + KK).inverse() + KK * Y + Y.transpose() * KK
    assert Z * G * Z == Z
    return R, H, G


def _part(M, rows, cols):
    return Matrix([[M.rows[i][j] for j in cols] for i in rows], len(cols))


@pytest.mark.parametrize(("p", "n", "rank"), [
    (2, 1, 0), (2, 1, 1), (2, 2, 1), (3, 1, 0), (3, 1, 1), (3, 1, 2), (3, 2, 1), (4, 2, 1), (4, 1, 2), (5, 2, 2)])
def test_normal_form_reaches_everything(p, n, rank):
    """S brings R, H and every (1)-inverse to the form that `proofs.nwl92.notation.NORMAL_FORM` states."""
    rng = random.Random(f"{p} {n} {rank}")
    for _ in range(5):
        R, H, G = _problem(rng, p, n, rank)
        Ht = H.transpose()
        N = null_basis(Ht)
        c = N.transpose() * R * N if N.ncols else _zeros(0, 0)
        kernel = null_basis(c)
        M1 = N * null_basis(kernel.transpose()) if N.ncols else _zeros(p, 0)
        M2 = N * kernel if N.ncols else _zeros(p, 0)
        left = (Ht * H).inverse() * Ht
        if M1.ncols:
            left = left - left * R * M1 * (M1.transpose() * R * M1).inverse() * M1.transpose()
        S = Matrix([*left.rows, *M1.transpose().rows, *M2.transpose().rows], p)
        F = S.inverse()
        r = M1.ncols
        assert len(S.rows) == p and r == (p + n - null_basis(block([[R, H]])).ncols) - n
        assert S * H == Matrix([[Fraction(int(i == j)) for j in range(n)] for i in range(p)], n)
        turned = S * R * S.transpose()
        first, middle, last = range(n), range(n, n + r), range(n + r, p)
        rest = [*middle, *last]
        for a, b in ((first, middle), (first, last), (middle, last), (last, last)):
            assert _part(turned, a, b) == _zeros(len(a), len(b))
        P, Q = _part(turned, first, first), _part(turned, middle, middle)
        assert inertia(P)[1] == 0 and inertia(Q)[1:] == (0, 0)
        above, below = range(p), range(p, p + n)
        W, U, T = _part(G, above, above), _part(G, above, below), _part(G, below, below)
        W, U = F.transpose() * W * F, F.transpose() * U
        assert _part(W, first, first) == _zeros(n, n)
        assert _part(W, middle, first) == _zeros(r, n)
        M = _part(W, rest, rest)
        E = _part(turned, rest, rest)
        assert E * M * E == E
        assert _part(U, first, range(n)) == Matrix.identity(n)
        assert _part(U, middle, range(n)) == _zeros(r, n)
        assert T == -P
