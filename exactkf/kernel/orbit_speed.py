# SPDX-License-Identifier: MIT
r"""What an answer says of the speed of convergence, checked.

Main definitions
----------------
`check_speed`     rate and slowness of an orbit that converges
`slowness`        K, from the zeros of D on the circle
`count_within`    zeros of a real polynomial in a disc, in intervals

Main statements
---------------
What is checked here is a number that D alone gives: the square of the largest modulus rho of the zeros of D inside the circle, if none is on it; otherwise
K, the sum of (k/2)^2 over the zeros on the circle, k their multiplicities.  That the orbit converges at the rate rho^2, or like K/t, is not checked:
`exactkf.dynamics.speed` derives it in words, the rate from a theorem of Nevai and Totik, which is cited.

1. *In an interval.*  With E(z^2) = D(z) D(-z), rho^2 is the largest modulus of the zeros of E inside the circle.  D is palindromic, so if m of the 2m
   zeros of E are in |z| < hi < 1, and fewer in |z| < lo, then lo <= rho^2 < hi, and no zero is on the circle.
2. *As a zero of a polynomial p.*  Let N be rational polynomials whose product D without multiplicities divides.  The zero of modulus rho and its
   conjugate are zeros of one N, so rho^2 is a zero of R, which has the products of two zeros of N, by Newton's identities.  If what is
   left of every R when p is divided out is not zero between lo and hi, rho^2 is a zero of p there.
3. *Counting.*  Let |z| = 1.  If |p_0| < |p_n| then p_n p - p_0 p^*, p^* = z^n p(1/z), has as many zeros inside as p by Rouche's theorem, one of them 0; if
   |p_0| > |p_n| so has p_0 p - p_n p^*, of lower degree.  Neither vanishes on the circle unless p does, and the constant that comes last is not zero.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from exactkf.kernel.intervals import Interval, around, minus, times
from exactkf.kernel.limits import DEGREE, within
from exactkf.kernel.numbers import fraction, need
from exactkf.kernel.orbit_n import reduce_pair, spectral_polynomial
from exactkf.kernel.roots import count_circle, count_real, divmod_poly, gcd_poly, squarefree, times_poly, value_at

__all__ = ["check_rate", "check_speed", "count_within", "slowness"]


def check_speed(Q: list, S: list, answer: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
    """Accept rate and slowness of a pair, for which the rest of the answer has been checked."""
    reduced, rate = reduce_pair(Q, S), answer["rate"]
    D = spectral_polynomial(reduced.Q, reduced.S)
    if answer["behaviour"] != "converges" or answer["period"] is not None:
        need(rate is answer["slow"] is None, "an orbit that does not come nearer to a limit has no speed")
        return
    K = slowness(D) if len(D) > 1 else None
    need(answer["slow"] is None if K is None else type(answer["slow"]) is int and answer["slow"] == K, f"the slowness is {K}")
    if K is not None or len(D) == 1:
        need(rate == (None if K else "0"), "the rate is not as decided")
    else:
        check_rate(D, rate, evidence["speed"])


def slowness(D: list) -> int | None:
    """The sum of (k/2)^2 over the zeros on the circle, k their multiplicities; None if there are none."""
    return sum(count_circle(f)[1] * (k // 2) ** 2 for f, k in squarefree(D)) or None


def check_rate(D: list, rate: Any, evidence: Mapping[str, Any]) -> None:
    """Accept the rate for D without zeros on the circle.

    The evidence has the `bits` of intervals and, for a rate that is a zero of a polynomial, the `ends` of statement 2 and the polynomials `norms`.
    """
    bits = evidence["bits"]
    need(type(bits) is int and 0 < bits < 1 << 16, "the bits are not a positive number")
    lo, hi = map(fraction, rate["interval"] if "ends" not in evidence else evidence["ends"])
    if "ends" not in evidence:
        need(set(rate) == {"interval"}, "the rate is not an interval")
    elif isinstance(rate, str):
        p = [-fraction(rate), Fraction(1)]
    else:
        need(set(rate) == {"minpoly", "interval"}, "the rate is not a zero of a polynomial in an interval")
        p, (left, right) = [fraction(c) for c in rate["minpoly"]], map(fraction, rate["interval"])
        need(len(p) > 1 and left < lo and hi < right and count_real(p, left, right) - (value_at(p, right) == 0) == 1,
              "the interval of the rate does not hold exactly one zero")
    E, m = times_poly(D, [-c if k % 2 else c for k, c in enumerate(D)])[::2], len(D) // 2
    need(0 <= lo <= hi < 1 and count_within(E, hi, bits) == m > (count_within(E, lo, bits) if lo else 0), "the rate is not within the interval")
    if "ends" in evidence:
        _only_product(D, p, lo, hi, [[fraction(c) for c in N] for N in evidence["norms"]])


def _only_product(D: list, p: list, lo: Fraction, hi: Fraction, norms: list[list[Fraction]]) -> None:
    """Statement 2."""
    product: list = [D[-1] * 0 + 1]
    for N in norms:
        product = times_poly(product, N)
    within(len(product), DEGREE * 2, "the degree of a norm")
    simple = divmod_poly(D, gcd_poly(D, [k * c for k, c in enumerate(D)][1:]))[0]
    need(len(product) > 1 and product[-1] != 0 and not divmod_poly(product, simple)[1], "a zero of D is not among those named")
    for N in norms:
        R = _products_of_zeros(N)
        while not (divided := divmod_poly(R, p))[1]:
            R = divided[0]
        low, high = Fraction(0), Fraction(0)
        for c in reversed(R):  # both ends are positive
            ends = [x * y for x in (low, high) for y in (lo, hi)]
            low, high = min(ends) + c, max(ends) + c
        need(low > 0 or high < 0, "the rate may be another product of zeros")


def _products_of_zeros(N: list[Fraction]) -> list[Fraction]:
    """The monic polynomial with the zeros z_i z_j, i <= j: its power sums are (s_k^2 + s_2k)/2."""
    n = len(N) - 1
    size = n * (n + 1) // 2
    s = _power_sums(N, 2 * size)
    sums = [(s[k] * s[k] + s[2 * k]) / 2 for k in range(size + 1)]
    out = [Fraction(1)]  # leading coefficient first
    for k in range(1, size + 1):
        out.append(-sum((out[k - i] * sums[i] for i in range(1, k + 1)), Fraction(0)) / k)
    return out[::-1]


def _power_sums(N: list[Fraction], most: int) -> list[Fraction]:
    """Of the zeros, from the 0th on, by Newton's identities."""
    n = len(N) - 1
    c = [x / N[-1] for x in reversed(N)]
    s = [Fraction(n)]
    for k in range(1, most + 1):
        s.append(-sum((c[i] * s[k - i] for i in range(1, min(k, n + 1))), Fraction(0)) - (k * c[k] if k <= n else 0))
    return s


def count_within(p: list, radius: Fraction, bits: int) -> int:
    """The number of zeros with |z| < radius, for a radius that is not 0; none has that modulus, or Undefined is raised. See statement 3."""
    q: list[Interval] = [around(x * radius**k, bits) for k, x in enumerate(p)]
    inside = 0
    while len(q) > 1:
        spare = max(0, bits - max(abs(x).bit_length() for ends in q for x in ends))  # a positive factor, so that small numbers keep their digits
        q = [(low << spare, high << spare) for low, high in q]
        first, last = (times(x, x, bits) for x in (q[0], q[-1]))
        need(first[1] < last[0] or last[1] < first[0], "a comparison is not decided in so many bits")
        small = first[1] < last[0]
        a, b = (q[-1], q[0]) if small else (q[0], q[-1])
        moved = [minus(times(a, x, bits), times(b, y, bits)) for x, y in zip(q, q[::-1], strict=True)]
        inside += small
        q = moved[1:] if small else moved[:-1]
    return inside
