# SPDX-License-Identifier: MIT
r"""Orbits of the fast filter that neither converge nor repeat: what is checked about them.

Main definitions
----------------
`check_never_escapes`  the orbit modulo N is finite, and 1 - g^2 is a unit all the way
`has_infinite_order`   the zeros of D are not distinct roots of unity
`check_torus`          the dimension of the torus that the orbit fills

Notation as in `exactkf.kernel.orbit_n`: a polynomial is its list of coefficients from z^0 up,
and D is given as z^m D.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from math import gcd, lcm
from typing import Any

from exactkf.kernel.algebraic import Algebraic
from exactkf.kernel.limits import STEPS, within
from exactkf.kernel.numbers import divide, fraction, need
from exactkf.kernel.roots import chebyshev, count_circle, count_real, divmod_poly, gcd_poly, squarefree, times_poly
from exactkf.kernel.roots_modulo import common_modulo, power_modulo
from exactkf.kernel.torus import CircleNumbers, check_independent, is_relation

__all__ = ["check_never_escapes", "check_torus", "common_order", "has_infinite_order", "modular", "modular_step", "wandering_factor"]


def _residue(x: Any, N: int) -> int:
    x = Fraction(x)
    need(gcd(x.denominator, N) == 1, f"{N} divides a denominator")
    return x.numerator * pow(x.denominator, -1, N) % N


def modular(p: list, N: Any) -> list[int]:
    need(type(N) is int and N > 1, "a modulus is an integer above one")
    return [_residue(x, N) for x in p]


def modular_step(Q: list[int], S: list[int], N: int) -> tuple[list[int], list[int]]:
    g = S[-2]
    u = pow(1 - g * g, -1, N)
    moved = [0, *S[:-1]]
    return [(x - g * y) * u % N for x, y in zip(Q, moved, strict=True)], [(y - g * x) * u % N for x, y in zip(Q, moved, strict=True)]


def check_never_escapes(Q: list, S: list, N: Any) -> None:
    """The orbit modulo N comes back to a state it had, and 1 - g^2 is a unit all the way."""
    state, kept, steps = (modular(Q, N), modular(S, N)), None, 0
    while state != kept:
        if steps & (steps - 1) == 0:  # the last of a power of two is remembered (Brent)
            kept = state
        g, steps = state[1][-2], steps + 1
        within(steps * len(Q), STEPS, "steps of the orbit modulo N, times its order")
        need(gcd(1 - g * g, N) == 1, f"1 - g^2 is no unit modulo {N}")
        state = modular_step(*state, N)


@cache
def _orders(degree: int) -> tuple[int, ...]:
    """The orders of all roots of unity of at most this degree."""
    stop = 2 * degree * degree + 3  # phi(k) >= sqrt(k/2)
    within(stop, 10 * STEPS, "orders of roots of unity")
    totient = list(range(stop))
    for p in range(2, stop):
        if totient[p] == p:
            for k in range(p, stop, p):
                totient[k] -= totient[k] // p
    return tuple(k for k in range(1, stop) if totient[k] <= degree)


@cache
def common_order(degree: int) -> int:
    """A common multiple of the orders of all roots of unity of at most this degree."""
    return lcm(*_orders(degree))


def has_infinite_order(D: list[int], degree: int, p: int) -> bool:
    """The zeros of D are not distinct roots of unity: else z^N = 1 modulo D, also modulo p.

    D is monic and read modulo p, and its zeros have at most the given degree over the rational numbers.
    """
    return power_modulo([0, 1], common_order(degree), D, p) != [1]


# ---------------------------------------------------------------------- the torus
def check_torus(D: list, d: int, evidence: Mapping[str, Any]) -> None:
    r"""The orbit fills a torus of dimension d.

    The closure of the planes S_m^t Im(I; 0) accumulates on an orbit of the closure H of
    (l_1^t, ..., l_k^t), where the l_i are the zeros of D on the upper half circle of odd
    multiplicity; by statement 1 the stabilizer in H is finite.  So d is the largest number of l_i
    between which there is no relation prod l_i^{e_i} = 1: as many are shown to have none, and each of the
    others to have one with them (`exactkf.kernel.torus`).
    """
    f, k = _over_a_field(D, evidence) if any(isinstance(c, Algebraic) for c in D) else _over_the_rationals(D, evidence)
    if k <= 1:
        need(d == k, f"the dimension is {k}")
        return
    numbers = CircleNumbers.of(f, evidence["zeros"])
    need(len(numbers.zeros) == k, f"there are {k} zeros")
    free = evidence["independent"]["of"]
    need(all(type(i) is int and 0 <= i < k for i in free) and len(set(free)) == len(free) == d > 0, f"{d} of the zeros are to be named")
    if d > 1:
        check_independent(numbers, free, evidence["independent"]["bits"], evidence["independent"]["basis"])
    for i in set(range(k)) - set(free):
        exponents: list = next((r[1] for r in evidence["relations"] if r[0] == i), [])
        need(len(exponents) == d + 1 and all(type(e) is int for e in exponents) and exponents[-1] != 0, f"no relation for the zero {i}")
        need(is_relation(numbers, [*free, i], exponents), f"the relation for the zero {i} does not hold")


def _over_the_rationals(D: list, evidence: Mapping[str, Any]) -> tuple[list, int]:
    """A polynomial with the l_i among its zeros, and their number."""
    f, rest = wandering_factor(D), [Fraction(1)]
    if evidence.get("factor") is not None:  # factors without zeros on the circle do not matter
        f, rest = [fraction(c) for c in evidence["factor"]], f
        rest, left = divmod_poly(rest, f)
        need(not left and (len(rest) == 1 or count_circle(rest)[1] == 0), "what is left has a zero on the circle")
    return f, count_circle(f)[1] // 2 if len(f) > 1 else 0


def _over_a_field(D: list, evidence: Mapping[str, Any]) -> tuple[list, int]:
    """The same for algebraic data, from a rational multiple of the part O of D with zeros of odd multiplicity.

    That is square-free; without the roots of unity it is f.  Each interval holds one zero of O and one of the multiple, hence the same, and it is one of f.
    """
    odd: list = [D[-1] / D[-1]]
    for factor, multiplicity in squarefree(D):
        odd = times_poly(odd, factor) if multiplicity % 2 else odd
    if len(odd) == 1 or count_circle(odd)[1] == 0:
        return [Fraction(1)], 0
    whole = [fraction(c) for c in evidence["norm"]]
    need(_coprime_modulo(whole, [i * c for i, c in enumerate(whole)][1:]), "the rational multiple is not square-free")
    need(not divmod_poly([odd[-1] - odd[-1] + c for c in whole], odd)[1], "the rational polynomial is no multiple of D's factor")
    f = wandering_factor(whole)
    of_unity = divmod_poly(whole, f)[0]
    k = (count_circle(odd)[1] - len(gcd_poly(odd, [odd[-1] - odd[-1] + c for c in of_unity])) + 1) // 2
    if k > 1:
        odd = [divide(c, odd[-1]) for c in odd]
        paired = all(x == y for x, y in zip(odd, odd[::-1], strict=True)) and whole == whole[::-1]
        need(paired and len(odd) % 2 == len(whole) % 2 == 1, "the zeros do not come in pairs")  # -1 by itself would be none of x
        for lo, hi in evidence["zeros"]:
            one = [count_real(chebyshev(p), fraction(lo), fraction(hi)) for p in (odd, whole)]
            need(one == [1, 1], "an interval does not hold one zero of D")
    return f, k


def wandering_factor(D: list) -> list:
    """The zeros of D of odd multiplicity that are no roots of unity, once each."""
    D = [Fraction(c) for c in D]
    if _coprime_modulo(D, [i * c for i, c in enumerate(D)][1:]):
        return _without_roots_of_unity([c / D[-1] for c in D])
    odd: list = [Fraction(1)]
    rest, k = D, 1
    derivative = [i * c for i, c in enumerate(D)][1:]
    g = gcd_poly(D, derivative)
    w = divmod_poly(rest, g)[0]
    while len(w) > 1:
        y = gcd_poly(w, g)
        f = divmod_poly(w, y)[0]
        if k % 2 and len(f) > 1:
            odd = times_poly(odd, f)
        w, g, k = y, divmod_poly(g, y)[0], k + 1
    return _without_roots_of_unity(odd)


def _without_roots_of_unity(odd: list) -> list:
    for order in _orders(len(odd) - 1):
        power = [Fraction(-1)] + [Fraction(0)] * (order - 1) + [Fraction(1)]
        if not _coprime_modulo(odd, power) and len(common := gcd_poly(odd, power)) > 1:
            odd = divmod_poly(odd, common)[0]
    return odd


def _coprime_modulo(f: list, g: list, p: int = 2**31 - 1) -> bool:
    """Whether rational polynomials are coprime modulo a prime that does not divide the leading coefficient of the first: then they are coprime."""
    if any(c.denominator % p == 0 for c in [*f, *g]) or f[-1].numerator % p == 0:
        return False
    return len(common_modulo(modular(f, p), modular(g, p), p)) == 1
