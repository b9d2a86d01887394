# SPDX-License-Identifier: MIT
r"""Polynomials over the rational numbers that are irreducible: what is checked about them.

Main definitions
----------------
`check_irreducible`   the modulus of a field is irreducible
`possible_degrees`    the degrees that factors may have, by what they are modulo primes
`are_within`          all zeros have a modulus less than a number

Main statements
---------------
Let F have integral coefficients without a common factor, and let d be its degree.  If F = GK over the rational numbers, G and K may be taken integral (Gauss).

1. *Modulo primes.*  Let p not divide the leading coefficient. G modulo p has the degree of G and is a product of irreducible factors of F modulo p,
   so its degree is a sum of degrees of these. If no sum but 0 and d is there for all primes named, F is irreducible.
2. *A value.*  Let the zeros have a modulus less than R, and k be the least positive degree that 1 leaves.  Then
   |G(n)|, |K(n)| >= (|n| - R)^k for an integer n, |n| >= R + 1.  So if F(n) is c times a prime and (|n| - R)^k > c, F is irreducible (Murty).
3. *Zeros.*  The zeros of F_j, F_{j+1}(x^2) = F_j(x) F_j(-x), F_0 = F, are the powers 2^j of those of F (Graeffe). If the leading term of F_j outweighs all
   others together at r, it does so for |x| >= r too.
4. *Cosines.*  The polynomial psi of `exactkf.kernel.cosines` is irreducible.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import gcd, isqrt, lcm
from typing import Any

from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.cosines import minimal_polynomial
from exactkf.kernel.limits import STEPS, within
from exactkf.kernel.numbers import fraction, need
from exactkf.kernel.roots import times_poly
from exactkf.kernel.roots_modulo import common_modulo, divided_modulo, monic_modulo, power_modulo

__all__ = ["GRAEFFE", "are_within", "check_irreducible", "integral", "leaves", "possible_degrees"]

GRAEFFE = 4  # how often zeros are squared to bound them
_SMOOTH = 100  # prime factors of the c of statement 2 are below


def check_irreducible(field: AlgebraicField, evidence: Any) -> None:
    """Accept if the modulus of a field is irreducible, and note that it is.

    Parameters
    ----------
    field : AlgebraicField
    evidence : int or mapping
        The n of statement 2, where R is the bound of Cauchy; or with ``at``, n, and ``radius``, R; or ``primes``, those of statement 1, which may go with
        these; or ``cyclotomic``, n, for the minimal polynomial of 2 cos(2 pi/n).
    """
    F = integral(field.modulus)
    how = evidence if isinstance(evidence, Mapping) else {"at": evidence}
    need(set(how) in ({"at"}, {"at", "radius"}, {"at", "radius", "primes"}, {"primes"}, {"cyclotomic"}), "this is no evidence that a polynomial is irreducible")
    if "cyclotomic" in how:
        n = how["cyclotomic"]
        need(type(n) is int and 2 < n <= 1000, "the order of a root of unity is an integer above two")
        need(F == [int(c) for c in minimal_polynomial(n)], f"the modulus of the field is not the polynomial of 2 cos(2 pi/{n})")
    else:
        possible = possible_degrees(F, how.get("primes", ()))
        if "at" in how:
            n, H = how["at"], max(abs(Fraction(x, F[-1])) for x in F)
            R = fraction(how["radius"]) if "radius" in how else H + 1
            need("radius" not in how or are_within(F, R), "a zero may have a larger modulus")
            need(type(n) is int and abs(n) >= R + 1, "the argument is too small")
            rest, _ = leaves(F, n, (abs(n) - R) ** possible[0])
            need(_is_prime(rest), "the modulus of the field is not shown to be irreducible")
        else:
            need(possible[0] == len(F) - 1, "the modulus of the field is not shown to be irreducible")
    field.irreducible = True


def integral(F: Sequence[Any]) -> list[int]:
    """The multiple with integral coefficients without a common factor, the leading one positive."""
    common = lcm(*(Fraction(c).denominator for c in F))
    whole = [int(c * common) for c in F]
    content = gcd(*whole) * (1 if whole[-1] > 0 else -1)
    return [c // content for c in whole]


def leaves(F: Sequence[int], n: int, bound: Fraction) -> tuple[int, int]:
    """|F(n)| without a factor c, a product of small numbers, and c, which is less than the bound."""
    value, c = abs(sum(x * n**k for k, x in enumerate(F))), 1
    need(value > 0, "the modulus of the field has a rational zero")
    for r in range(2, _SMOOTH):
        while value % r == 0 and bound > c * r:
            value, c = value // r, c * r
    return value, c


def are_within(F: Sequence[int], R: Fraction) -> bool:
    """Whether statement 3 shows that all zeros have a modulus less than R."""
    f, r = list(F), R
    for _ in range(GRAEFFE):
        f, r = times_poly(f, [-c if k % 2 else c for k, c in enumerate(f)])[::2], r * r
    d = len(f) - 1
    top, below = r.numerator, r.denominator
    return R > 0 and abs(f[-1]) * top**d > sum(abs(c) * top**k * below ** (d - k) for k, c in enumerate(f[:-1]))


# ---------------------------------------------------------------------- modulo primes
def possible_degrees(F: Sequence[int], primes: Sequence[Any]) -> list[int]:
    """The positive degrees that a factor of F may have, by statement 1."""
    d = len(F) - 1
    possible = (1 << d + 1) - 1
    for p in primes:
        need(type(p) is int and 1 < p < STEPS and all(p % r for r in range(2, isqrt(p) + 1)), "what is to be a prime is none")
        need(F[-1] % p != 0, "a prime divides the leading coefficient")
        within(len(primes) * d**4, 10 * STEPS, "the degree to the fourth power, for each prime")
        sums = 1
        for degree in _degrees(F, p):
            sums |= sums << degree
        possible &= sums
    return [k for k in range(1, d + 1) if possible >> k & 1]


def _degrees(F: Sequence[int], p: int) -> list[int]:
    """The degrees of the irreducible factors modulo a prime of a polynomial that is square-free modulo it."""
    f = monic_modulo([c % p for c in F], p)
    need(len(common_modulo(f, [k * c % p for k, c in enumerate(f)][1:], p)) == 1, "the polynomial is not square-free modulo a prime")
    found: list[int] = []
    power, degree = [0, 1], 0
    while len(f) - 1 >= 2 * (degree + 1):
        degree += 1
        power = power_modulo(power, p, f, p)
        moved = [*power, *[0] * (2 - len(power))]
        moved[1] = (moved[1] - 1) % p
        part = common_modulo(f, moved, p)
        found += [degree] * ((len(part) - 1) // degree)
        if len(part) > 1:
            f = divided_modulo(f, part, p)[0]
            power = divided_modulo(power, f, p)[1]
    return [*found, len(f) - 1] if len(f) > 1 else found


def _is_prime(n: int) -> bool:
    """By the strong test to the bases 2, ..., 41, which is right below 3.3 * 10^24 (Sorenson and Webster)."""
    bases = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41)
    need(n < 3317044064679887385961981, "a value is too large for the test of primality")
    if n < 43:
        return n in bases
    odd, twos = n - 1, 0
    while odd % 2 == 0:
        odd, twos = odd // 2, twos + 1
    for a in bases:
        x = pow(a, odd, n)
        if x not in (1, n - 1) and all((x := x * x % n) != n - 1 for _ in range(twos - 1)):
            return False
    return True
