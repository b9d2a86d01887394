# SPDX-License-Identifier: MIT
r"""Orbits of the fast filter whose `D` has roots of unity as its only zeros, some of them multiple: that they never escape.

Main statement
--------------
Let z^N = 1 for every zero of D, and let mu be the largest multiplicity.  D divides (z^N - 1)^mu, so S_m^N - I is nilpotent of
index mu at most, and the entries of S_m^{k + Ns} are polynomials in s of degree at most mu - 1.  So det X_{-(k + Ns)} is a polynomial in s of
degree at most m (mu - 1), known from that many values and one more, and the orbit never escapes if none
of these polynomials, k = 0, ..., N - 1, vanishes at a negative integer (see `exactkf.kernel.orbit_sieve`; X_0 = I).
"""

from __future__ import annotations

from fractions import Fraction
from math import ceil
from typing import Any

from exactkf.kernel.limits import STEPS, within
from exactkf.kernel.linear import Matrix, char_coefficients
from exactkf.kernel.numbers import need
from exactkf.kernel.orbit_sieve import backward
from exactkf.kernel.roots import count_real, divmod_poly, squarefree

__all__ = ["check_by_polynomials", "determinants", "interpolated"]


def check_by_polynomials(Q: list, S: list, D: list, N: Any) -> None:
    """Accept if no det X_t, t >= 0, of a reduced rational pair is zero, N being a common order of the zeros of D."""
    parts = squarefree(D)
    size = (len(Q) - 1) * (max(k for _, k in parts) - 1) + 1
    need(type(N) is int and N > 0, "an order is a positive integer")
    within(N * size * len(Q) ** 3, STEPS, "determinants, times the cube of their size")
    one = D[-1] / D[-1]
    unity = [-one, *[one - one] * (N - 1), one]
    need(all(not divmod_poly(unity, f)[1] for f, _ in parts), f"a zero of D is no root of unity of order {N}")
    values = determinants(Q, S, N * size)
    for k in range(N):
        p = interpolated(values[k::N])
        need(bool(p) and not _has_positive_integer([c * (-1) ** i for i, c in enumerate(p)]), f"a determinant vanishes at a time {-k} modulo {N}")


def determinants(Q: list, S: list, count: int) -> list[Fraction]:
    """det X_t for t = 0, -1, -2, ..."""
    q, g, zero = Q[-2::-1], S[-2::-1], Q[-1] - Q[-1]
    X: list = [[zero + int(i == j) for j in range(len(q))] for i in range(len(q))]
    Y: list = [[zero] * len(q) for _ in q]
    out = []
    for _ in range(count):
        value = char_coefficients(Matrix(X))[0] * (-1) ** len(q)
        out.append(Fraction(int(value.numerator), int(value.denominator)))  # from here on as fractions, also in a search with a faster type
        X, Y = backward(X, Y, q, g)
    return out


def interpolated(values: list[Fraction]) -> list[Fraction]:
    """The coefficients of the polynomial with these values at 0, 1, 2, ..., by Newton's formula."""
    total: list[Fraction] = [Fraction(0)] * len(values)
    base, differences = [Fraction(1)], list(values)
    for j in range(len(values)):
        for i, c in enumerate(base):
            total[i] += differences[0] * c
        base = [(b - j * a) / (j + 1) for a, b in zip([*base, Fraction(0)], [Fraction(0), *base], strict=True)]
        differences = [y - x for x, y in zip(differences, differences[1:], strict=False)]
    while total and total[-1] == 0:
        total.pop()
    return total


def _has_positive_integer(p: list[Fraction]) -> bool:
    """Whether a polynomial, not zero, vanishes at a positive integer."""
    todo = [(0, 1 + ceil(max(abs(c / p[-1]) for c in p)))]
    while todo:
        lo, hi = todo.pop()
        if count_real(p, Fraction(lo), Fraction(hi)) == 0:
            continue
        if hi - lo == 1:
            total = Fraction(0)
            for c in reversed(p):
                total = total * hi + c
            if total == 0:
                return True
            continue
        todo += [(lo, (lo + hi) // 2), ((lo + hi) // 2, hi)]
    return False
