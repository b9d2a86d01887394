# SPDX-License-Identifier: MIT
r"""Orbits of the fast filter that never escape, by congruences: what is checked about them.

Main definitions
----------------
`check_never_singular`  no X_t, t >= 0, is singular
`zeros_modulo`          the t at which det X_t vanishes modulo a prime
`intersected`           what two periodic sets of integers have in common
`readings`              numbers modulo N, in every way in which their field can be read modulo N

Main statements
---------------
(X_t; Y_t) are the powers of S_m applied to (I; 0).  With r_t = 1 - h'P_t h, P_t = Y_t X_t^-1, X_{t+1} = A'^-1 (X_t - hh'Y_t) has
the determinant det X_t r_t / det A', and r_t is the product of the first t of the 1 - g^2: the orbit escapes
exactly if some det X_t, t >= 0, is zero, two steps before the first of them.

1. *One prime.*  If p divides no denominator and S_m^L = I modulo p, det X_t modulo p depends on t modulo L only.  Where it is
   not zero modulo p it is not zero.
2. *Several primes.*  A t with det X_t = 0 is in the periodic set of every prime, and so in their intersection.
3. *Orbits that come from an escape.*  If det X_{-k} = 0, k > 0, then -k is in all these sets.  Let p >= 5, M = S_m^L = I + pB over the
   p-adic integers.  det X_{-k + Ls} is p s (f + p u(s)), u a power series with integral coefficients, because
   p^j binomial(s, j) has the coefficients of p^j / j!, divisible by p for j = 1 and by p^2 for j > 1.  If that is
   not zero modulo p^2 at s = 1, p does not divide f, and there is no other zero of the form -k + Ls.
4. *Algebraic data.*  theta is a zero of a monic polynomial F with zeros r_1, ..., r_d modulo p, as many as its degree and all
   different.  The minimal polynomial of theta divides F, so some r_i is a zero of it modulo p, and theta -> r_i
   defines a homomorphism of the p-integral polynomials in theta.  Which r_i it is need not be known: what
   is required is required of all; the set of the prime is the union of their sets.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import gcd, isqrt
from operator import mul
from typing import Any

from exactkf.kernel.algebraic import Algebraic, AlgebraicField
from exactkf.kernel.linear import Matrix, char_coefficients
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.orbit_wandering import modular

__all__ = ["backward", "check_never_singular", "intersected", "readings", "step_matrix", "zeros_modulo"]

_LONGEST, _MOST = 10**6, 10**5


def check_never_singular(Q: list, S: list, places: Any, before: Any) -> None:
    """Accept if no det X_t, t >= 0, of a reduced pair is zero.

    Parameters
    ----------
    Q, S : lists of Fraction or Algebraic
    places : list
        ``[p, L]`` or, for algebraic data, ``[p, L, [r_1, ..., r_d]]``.
    before : list
        The k of statement 3.
    """
    _need(bool(places), "no prime is named")
    m, period, left = len(Q) - 1, 1, [0]
    for p, L, *roots in places:
        _need(type(p) is int and 1 < p < _LONGEST and all(p % r for r in range(2, isqrt(p) + 1)), "a place is not a prime")
        _need(type(L) is int and 0 < L < _LONGEST, "a period is not a positive integer")
        found: set[int] = set()
        for values in readings([*Q[-2::-1], *S[-2::-1]], p, *roots):
            found |= zeros_modulo(values[:m], values[m:], p, L)
        period, left = intersected(period, left, L, found)
        _need(len(left) < _MOST, "too many times are left")
    if left:
        singular = _singular_before(Q, S, before)
        alone = [(k, L) for k in singular for p, L, *roots in places if p > 3 and L > k and _alone(Q, S, k, p, L, roots)]
        _need(all(any((t + k) % L == 0 for k, L in alone) for t in left), f"nothing excludes an escape at times {left[0]} modulo {period}")


def intersected(M: int, first: Iterable[int], L: int, second: Iterable[int]) -> tuple[int, list[int]]:
    """The integers congruent to one of the first modulo M and to one of the second modulo L: a period and residues."""
    common = gcd(M, L)
    by_rest: dict[int, list[int]] = {}
    for t in second:
        by_rest.setdefault(t % common, []).append(t)
    u = pow(M // common, -1, L // common) if L > common else 0
    return M // common * L, [s + M * ((t - s) // common * u % (L // common)) for s in first for t in by_rest.get(s % common, ())]


# ---------------------------------------------------------------------- modulo N
def readings(values: list, p: int, roots: list | None = None, power: int = 1) -> list[list[int]]:
    """Numbers modulo p or p^2: in one way if they are rational, in one for every residue of theta if they are algebraic."""
    field = next((x.field for x in values if isinstance(x, Algebraic)), None)
    if field is None:
        _need(roots is None, "rational data have no generator")
        return [modular(values, p**power)]
    _need(type(roots) is list, "the residues of the generator are missing")
    return [[_value(x, r, p**power) for x in values] for r in _all_roots(field, p, roots, power)]  # type: ignore[arg-type]


def _all_roots(field: AlgebraicField, p: int, roots: list, power: int) -> list[int]:
    """The named zeros of the monic modulus modulo a prime, as many as the degree, or what they become modulo its square."""
    _need(all(p % r for r in range(2, isqrt(p) + 1)), "a place is not a prime")
    modulus = modular([Fraction(c) / field.modulus[-1] for c in field.modulus], p**power)
    slope = [k * c for k, c in enumerate(modulus)][1:]
    _need(all(type(r) is int and 0 <= r < p and _horner(modulus, r, p) == 0 for r in roots), f"a residue of the generator is no zero modulo {p}")
    _need(len(set(roots)) == len(roots) == len(modulus) - 1, f"modulo {p} there are not enough zeros")
    if power == 1:
        return roots
    return [(r - _horner(modulus, r, p * p) * pow(_horner(slope, r, p), -1, p)) % (p * p) for r in roots]  # Hensel's lemma


def _horner(f: list[int], x: int, N: int) -> int:
    acc = 0
    for c in reversed(f):
        acc = (acc * x + c) % N
    return acc


def _value(x: Any, r: int, N: int) -> int:
    return _horner(modular(x.c, N), r, N) if isinstance(x, Algebraic) else modular([x], N)[0]


# ---------------------------------------------------------------------- powers of the symplectic matrix
def zeros_modulo(q: list[int], g: list[int], p: int, L: int) -> set[int]:
    """The t from 0 to L - 1 with det X_t = 0 modulo p, where S_m^L = I modulo p.

    With S^{i + jB} in two parts, det X is a sum of products of minors (Cauchy and Binet).
    """
    S, size = step_matrix(q, g, p), isqrt(L) + 1
    m, eye = len(q), [[int(i == j) for j in range(2 * len(q))] for i in range(2 * len(q))]
    top, rows = [_minors(eye[:m], p)], [list(row) for row in zip(*S, strict=True)]
    power = eye[:m]
    for _ in range(size - 1):
        power = _product(power, rows, p)
        top.append(_minors(power, p))
    leap = _power(S, size, p)
    _need(_product(_power(leap, L // size, p), [list(c) for c in zip(*_power(S, L % size, p), strict=True)], p) == eye, f"S is not of order {L} modulo {p}")
    columns, found = eye[:m], set()  # the first m columns of S^{jB}, as rows
    for start in range(0, L, size):
        minors = _minors(columns, p)
        found |= {start + i for i, row in enumerate(top) if sum(map(mul, row, minors)) % p == 0}
        columns = _product(columns, leap, p)
    return {t for t in found if t < L}


def _minors(rows: list[list[int]], p: int) -> list[int]:
    """The minors of all rows modulo p, in an order that depends on the shape only."""
    found = {0: 1}
    for row in rows:
        following: dict[int, int] = {}
        for chosen, value in found.items():
            for j, x in enumerate(row):
                if not chosen >> j & 1:
                    sign = -1 if (chosen >> j).bit_count() & 1 else 1
                    following[chosen | 1 << j] = following.get(chosen | 1 << j, 0) + sign * value * x
        found = {k: v % p for k, v in following.items()}
    return [found[k] for k in sorted(found)]


def _product(A: list[list[int]], columns: list[list[int]], p: int) -> list[list[int]]:
    """A B modulo p, B given by its columns."""
    return [[sum(map(mul, row, column)) % p for column in columns] for row in A]


def _power(A: list[list[int]], k: int, p: int) -> list[list[int]]:
    out = [[int(i == j) for j in range(len(A))] for i in range(len(A))]
    columns = [list(c) for c in zip(*A, strict=True)]
    for bit in bin(k)[2:]:
        out = _product(out, [list(c) for c in zip(*out, strict=True)], p)
        if bit == "1":
            out = _product(out, columns, p)
    return out


def step_matrix(q: list[int], g: list[int], N: int) -> list[list[int]]:
    """S_m modulo N: (X; Y) -> (A'^-1 (X - hh'Y); gg'X' + AY), A = J - qh', X' the new X."""
    m = len(q)
    _need(gcd(q[-1], N) == 1, f"S is singular modulo {N}")
    inverse = pow(q[-1], -1, N)
    X = [[int(i == j) for j in range(2 * m)] for i in range(m)]
    Y = [[int(i + m == j) for j in range(2 * m)] for i in range(m)]
    W = [[x - y for x, y in zip(X[0], Y[0], strict=True)], *X[1:]]
    last = [-x * inverse for x in W[0]]  # row i of A'V is row i - 1 of V; row 0 is -q'V
    for i in range(m - 1):
        last = [x - q[i] * inverse * y for x, y in zip(last, W[i + 1], strict=True)]
    new_x = [[x % N for x in row] for row in [*W[1:], last]]
    along = [sum(map(mul, g, column)) for column in zip(*new_x, strict=True)]
    new_y = [[(g[i] * s - q[i] * y + (Y[i + 1][j] if i + 1 < m else 0)) % N for j, (s, y) in enumerate(zip(along, Y[0], strict=True))] for i in range(m)]
    return new_x + new_y


# ---------------------------------------------------------------------- times before the start
def backward(X: list, Y: list, q: list, g: list) -> tuple[list, list]:
    """The plane before: Y = A^-1 (Y' - gg'X'), X = A'X' + hh'Y."""
    m = len(q)
    along = [_dot(g, column) for column in zip(*X, strict=True)]
    R = [[y - g[i] * s for y, s in zip(Y[i], along, strict=True)] for i in range(m)]
    top = [-r / q[-1] for r in R[-1]]  # A v = r: v_{i+1} = r_i + q_i v_1
    new_y = [top, *([r + q[i] * t for r, t in zip(R[i], top, strict=True)] for i in range(m - 1))]
    new_x = [[-_dot(q, column) for column in zip(*X, strict=True)], *X[:-1]]
    new_x[0] = [x + y for x, y in zip(new_x[0], new_y[0], strict=True)]
    return new_x, new_y


def _dot(x: Iterable, y: Iterable) -> Any:
    first, *rest = map(mul, x, y)
    return sum(rest, first)


def _singular_before(Q: list, S: list, before: Any) -> list[int]:
    """The k of those named with det X_{-k} = 0, checked exactly."""
    _need(all(type(k) is int and 0 < k < 1000 for k in before), "times before the start are positive numbers")
    q, g, zero = Q[-2::-1], S[-2::-1], Q[-1] - Q[-1]
    X: list = [[zero + int(i == j) for j in range(len(q))] for i in range(len(q))]
    Y: list = [[zero] * len(q) for _ in q]
    found = []
    for k in range(1, max(before, default=0) + 1):
        X, Y = backward(X, Y, q, g)
        if k in before and char_coefficients(Matrix(X))[0] == 0:
            found.append(k)
    return found


def _alone(Q: list, S: list, k: int, p: int, L: int, roots: list) -> bool:
    """Whether det X_{L-k} is not zero modulo p^2; see statement 3, where det X_{-k} = 0 and S^L = I modulo p are known."""
    N, m = p * p, len(Q) - 1
    for values in readings([*Q[-2::-1], *S[-2::-1]], p, *(roots or [None]), 2):
        X = [row[:m] for row in _power(step_matrix(values[:m], values[m:], N), L - k, N)[:m]]
        if char_coefficients(Matrix(X))[0] % N == 0:
            return False
    return True


def _need(condition: bool, step: str) -> None:
    if not condition:
        raise Undefined(step)
