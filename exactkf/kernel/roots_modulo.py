# SPDX-License-Identifier: MIT
"""Polynomials modulo a prime, as lists of integers from the constant up, without zeros at the end.

Main definitions
----------------
`monic_modulo`, `divided_modulo`, `common_modulo`, `power_modulo`
    Scaling, division by a monic polynomial, the greatest common divisor, and powers modulo a polynomial.
"""

from __future__ import annotations

from collections.abc import Sequence

from exactkf.kernel.roots import times_poly

__all__ = ["common_modulo", "divided_modulo", "monic_modulo", "power_modulo"]


def monic_modulo(f: Sequence[int], p: int) -> list[int]:
    """f over its leading coefficient, of numbers 0 .. p - 1."""
    f = list(f)
    while f and f[-1] == 0:
        f.pop()
    unit = pow(f[-1], -1, p) if f else 1
    return [c * unit % p for c in f]


def divided_modulo(f: Sequence[int], g: Sequence[int], p: int) -> tuple[list[int], list[int]]:
    """Quotient and rest of the division by a monic polynomial."""
    rest, quotient = [c % p for c in f], list[int]()
    while len(rest) >= len(g):
        c = rest.pop()
        quotient.append(c)
        if c:
            for i, x in enumerate(g[:-1], len(rest) - len(g) + 1):
                rest[i] = (rest[i] - c * x) % p
    while rest and rest[-1] == 0:
        rest.pop()
    return quotient[::-1], rest


def common_modulo(f: Sequence[int], g: Sequence[int], p: int) -> list[int]:
    """The greatest common divisor of a polynomial and another, monic unless it is the first."""
    f, g = list(f), monic_modulo(g, p)
    while g:
        f, g = g, monic_modulo(divided_modulo(f, g, p)[1], p)
    return f


def power_modulo(base: Sequence[int], k: int, f: Sequence[int], p: int) -> list[int]:
    """base^k modulo a monic polynomial f."""
    out = [1]
    for bit in bin(k)[2:]:
        out = divided_modulo(times_poly(out, out), f, p)[1]
        if bit == "1":
            out = divided_modulo(times_poly(out, base), f, p)[1]
    return out
