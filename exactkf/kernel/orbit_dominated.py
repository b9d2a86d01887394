# SPDX-License-Identifier: MIT
r"""Orbits of the fast filter with zeros of `D` that are large, p-adically or at all: a time after which they never escape.

Main statements
---------------
Let f(s) = det X_{-(k + Ns)} (see `exactkf.kernel.orbit_sieve`); an escape in the class of -k modulo N is a zero of f at a negative s.

1. *Sums of powers.*  f(s) is an entry of the m-th compound of S_m^{-k-Ns}, so it obeys a recursion of order binomial(2m, m) with constant
   coefficients, the last of them not zero.  For monic rational polynomials M_i, M_i(0) != 0, and C_i(s, y) = sum c_{lb} s^l y^b, 0 <= l < e_i, the sum F(s) of
   y^s C_i(s, y) over all i and all zeros y of M_i obeys one of order sum e_i deg M_i.  If f = F at as many consecutive s as both orders together,
   then at all integers s.  The power sums of the zeros are rational and come from Newton's identities.
2. *Dominance.*  Let v be the valuation of a prime p, continued to the algebraic numbers.  By the Newton polygons one zero y_0 of M_0 has v(y_0) = w, all others
   have v <= u < w, and all have v >= -h, h >= 0.  With beta >= bh - v(c_{lb}) for all coefficients, v(C_i(s, y)) >= -beta at all integers s.
   If f(-t) = 0, t > 0, the term with y_0, of valuation -wt + v(C_0(-t, y_0)), is minus the sum of the others, of valuation -ut - beta at least.  So
   v(C_0(-t, y_0)) >= (w - u)t - beta, and R(t) = prod C_0(-t, y) over the d zeros y of M_0 has v(R(t)) >= (w - u)t - d beta.
3. *Norm.*  R is a rational polynomial in t, of degree at most d(e_0 - 1), the determinant of the multiplication by C_0 modulo M_0.  Let R = (1/c) sum n_j t^j
   with integers c and n_j, of degree g.  From the first t on at which |n_g| t^g is more than all other |n_j| t^j together R(t) is not zero, and p to the power
   v(c R(t)) is at most H t^g, H = sum |n_j|.  As (w - u)t log p - g log t increases for t >= 2g/(w - u), f(-t) is not zero from a t on at which, besides, p to
   the power (w - u)t - d beta + v(c) is more.  This is Liouville's inequality; the numbers need not be known to be irrational.
4. *At the real absolute value.*  One zero y_0 of M_0 has |y_0| <= r_0, all others of all M_i have |y| >= r_1 > r_0.  All are below Y, by Cauchy's bound, and so
   all |C_i(-t, y)| at most B t^e, B the largest sum of |c_{lb}| Y^b and t > 0.  If f(-t) = 0, |C_0(-t, y_0)| is at most n B t^e (r_0 / r_1)^t, n the number of
   zeros, and 1 / c <= |R(t)| <= n B^d t^{ed} (r_0 / r_1)^t where R(t) is not zero.  As log(r_1 / r_0) >= 1 - r_0 / r_1, (r_1 / r_0)^t t^{-ed} increases
   for t >= ed r_1 / (r_1 - r_0).

References: C. Lech, Ark. Mat. 2 (1953); G. Everest et al., Recurrence Sequences (2003), chapter 2.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import ceil, comb, floor, isqrt, lcm
from typing import Any, NamedTuple

from exactkf.kernel.limits import BITS, DEGREE, STEPS, within
from exactkf.kernel.linear import Matrix, char_coefficients
from exactkf.kernel.numbers import fraction, need
from exactkf.kernel.orbit_polynomial import determinants, interpolated
from exactkf.kernel.orbit_sieve import exponent
from exactkf.kernel.roots import count_circle, divmod_poly, times_poly

__all__ = ["Powers", "last_escape", "last_zero", "last_zero_by_size", "power_sums", "sum_of_powers"]


class Powers(NamedTuple):
    """M_i, monic, from x^0 up, and the rows l of coefficients c_{lb} of C_i."""

    M: list[Fraction]
    C: list[list[Fraction]]


def last_escape(Q: list, S: list, evidence: Mapping[str, Any]) -> int:
    """A time from which on no det X_t of a reduced rational pair is zero.

    Parameters
    ----------
    Q, S : lists of Fraction
    evidence : mapping
        ``prime``, or ``radii``, those of statement 4; ``classes``, for k = 0, ..., N - 1 a list of the pairs M_i, C_i, first M_0.
    """
    classes = [[_powers(x) for x in parts] for parts in evidence["classes"]]
    need(bool(classes) and all(classes), "no class of times is named")
    m, N = len(Q) - 1, len(classes)
    orders = [sum((len(x.M) - 1) * len(x.C) for x in parts) for parts in classes]
    within(max(orders) + 2 * m, 2 * DEGREE, "the order of a recursion")
    size = comb(2 * m, m) + max(orders)
    within(N * size * len(Q) ** 3, STEPS, "determinants, times the cube of their size")
    values = determinants(Q, S, N * size)
    for k, (parts, order) in enumerate(zip(classes, orders, strict=True)):
        count = comb(2 * m, m) + order
        need(sum_of_powers(parts, count) == values[k::N][:count], f"the determinants at times {-k} modulo {N} are other sums of powers")
    if "radii" in evidence:
        inner, outer = map(fraction, evidence["radii"])
        return N * max(last_zero_by_size(parts, inner, outer) for parts in classes)
    p = evidence["prime"]
    need(type(p) is int and 1 < p < STEPS and all(p % r for r in range(2, isqrt(p) + 1)), "what is to dominate is not at a prime")
    return N * max(last_zero(parts, p) for parts in classes)


def _powers(data: Any) -> Powers:
    M, C = data
    M, C = [fraction(c) for c in M], [[fraction(c) for c in row] for row in C]
    need(len(M) > 1 and M[-1] == 1 and M[0] != 0, "a polynomial is not monic of positive degree, or vanishes at zero")
    within(len(M) - 1, DEGREE, "the degree of a polynomial")
    need(bool(C) and all(len(row) == len(M) - 1 for row in C), "there are not as many coefficients as zeros")
    return Powers(M, C)


def sum_of_powers(parts: list[Powers], count: int) -> list[Fraction]:
    """F(s) for s = 0, 1, ..., count - 1."""
    total = [Fraction(0)] * count
    for M, C in parts:
        d = len(M) - 1
        sums = power_sums(M, count + d)
        for s in range(count):
            power = 1
            for row in C:
                total[s] += power * sum((c * x for c, x in zip(row, sums[s:s + d], strict=True)), Fraction(0))
                power *= s
    return total


def power_sums(M: list[Fraction], count: int) -> list[Fraction]:
    """The sums of the powers 0, 1, ... of the zeros of a monic polynomial, by Newton's identities."""
    d, sums = len(M) - 1, [Fraction(len(M) - 1)]
    for n in range(1, count):
        known = sum((M[d - i] * sums[n - i] for i in range(1, min(n, d + 1))), Fraction(0))
        sums.append(-known - (n * M[d - n] if n <= d else 0))
        within(sums[-1].numerator.bit_length(), BITS, "bits of a power sum")
    return sums


def last_zero(parts: list[Powers], p: int) -> int:
    """A t from which on F(-t) is not zero; see statements 2 and 3."""
    first, d = parts[0], len(parts[0].M) - 1
    a = _valuations(first.M, p)
    need(1 in a, "no zero dominates")
    w = a[0] - a[1]
    others = [Fraction(a[1] - x, j - 1) for j, x in a.items() if j > 1] + [_largest(x.M, p) for x in parts[1:]]
    need(bool(others) and w > max(others), "no zero dominates")
    u = max(others)
    h = max(Fraction(-v, len(x.M) - 1 - j) for x in parts for j, v in _valuations(x.M[:-1], p).items())
    bounds = [b * max(h, Fraction(0)) - v for x in parts for row in x.C for b, v in _valuations(row, p).items()]
    need(bool(bounds), "all coefficients are zero")
    n, c = _norm(first)
    g, H, less = len(n) - 1, sum(map(abs, n)), d * max(bounds) - exponent(c, p)
    t = ceil(max(Fraction(1), 2 * g / (w - u)))
    while True:
        within(t, STEPS, "a time after which there is no escape")
        most = H * t**g
        if _leads(n, t) and p ** min(max(0, floor((w - u) * t - less)), most.bit_length() + 1) > most:
            return t
        t += 1 + t // 8


def last_zero_by_size(parts: list[Powers], inner: Fraction, outer: Fraction) -> int:
    """A t from which on F(-t) is not zero; see statement 4."""
    need(0 < inner < outer, "the radii are not positive and in increasing order")
    first, d = parts[0], len(parts[0].M) - 1
    within(sum(x.bit_length() for r in (inner, outer) for x in (r.numerator, r.denominator)), 512, "bits of the radii")
    need(sum(_zeros_within(first.M, inner)[:2]) == 1 == _zeros_within(first.M, outer)[0], "no zero dominates")
    need(all(_zeros_within(x.M, outer)[0] == 0 for x in parts[1:]), "no zero dominates")
    Y = 1 + max(abs(c) for x in parts for c in x.M)
    B = max(sum((abs(c) * Y**b for row in x.C for b, c in enumerate(row)), Fraction(0)) for x in parts)
    n, c = _norm(first)
    power, factor = d * (max(len(x.C) for x in parts) - 1), c * sum(len(x.M) - 1 for x in parts) * B**d
    t = ceil(max(Fraction(1), power * outer / (outer - inner)))
    while True:
        within(t, STEPS >> 6, "a time after which there is no escape")
        if _leads(n, t) and (outer / inner) ** t > factor * t**power:
            return t
        t += 1 + t // 8


def _zeros_within(M: list[Fraction], r: Fraction) -> tuple[int, int, int]:
    """How many zeros have a modulus less than r, r, or more."""
    return count_circle([c * r**j for j, c in enumerate(M)])


def _leads(n: list[int], t: int) -> bool:
    """Whether the leading term is more than all others together at t, and so from there on."""
    return 2 * abs(n[-1]) * t ** (len(n) - 1) > sum(abs(x) * t**j for j, x in enumerate(n))


def _largest(M: list[Fraction], p: int) -> Fraction:
    """The largest valuation of a zero."""
    a = _valuations(M, p)
    return max(Fraction(a[0] - x, j) for j, x in a.items() if j)


def _valuations(values: list[Fraction], p: int) -> dict[int, int]:
    """The valuations of those that are not zero, by their places."""
    return {j: exponent(x.numerator, p) - exponent(x.denominator, p) for j, x in enumerate(values) if x != 0}


def _norm(part: Powers) -> tuple[list[int], int]:
    """The n_j, the last of them not zero, and c."""
    M, C = part
    d, values = len(M) - 1, []
    for t in range(d * (len(C) - 1) + 1):
        row = [sum((C[k][b] * (-t) ** k for k in range(len(C))), Fraction(0)) for b in range(d)]
        image, rows = row, []
        for _ in range(d):
            rest = divmod_poly(image, M)[1]
            image = [*rest, *[Fraction(0)] * (d - len(rest))]
            rows.append(image)
            image = times_poly([Fraction(0), Fraction(1)], image)
        values.append(char_coefficients(Matrix(rows))[0] * (-1) ** d)
    R = interpolated(values)
    need(bool(R), "the norm of the dominant coefficient is zero")
    c = lcm(*(x.denominator for x in R))
    return [int(x * c) for x in R], c
