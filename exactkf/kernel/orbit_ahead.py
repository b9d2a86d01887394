# SPDX-License-Identifier: MIT
r"""What is said of the state of an orbit after T steps, exactly or in intervals, checked without stepping.

Main statements
---------------
Let T > 0 steps be left for the coprime pair of order m with Q(0) != 0 that `reduce_pair` comes to, (X; Y) = S_m^T (I; 0), P = Y X^-1, u = Ph,
r = 1 - u_1.  Then the pair T steps later has q(T) = (q - Ju)/r below its leading coefficient, and g(T) = X'^-1 g / r (`exactkf.theory.power_method`).

1. *Without an escape before*, X is regular (`exactkf.kernel.orbit_sieve`).  If only the steps searched are known to have none, the state is said for
   the case that there is none.
2. *Exactly.*  X'(u, w) = (Y'h, g) has one solution if X is regular, and (q(T), g(T)) gives r = q_m/q_m(T), u_{i+1} = q_i - r q_i(T), w = r g(T).  So a state
   is right if these solve it: nothing is solved here.  By Cayley and Hamilton's theorem, X and Y come from z^T modulo D, without fractions.
   det X is not zero if it is not modulo a prime.
3. *In intervals.*  Phi = X^-1, G = X^-1 B, B the upper right block, and P, both symmetric, stay bounded where the orbit converges, and those of
   the product of two powers are, as the second power is symplectic (Redheffer), with M = (I + G2 P1)^-1,
   Phi1 M Phi2, G1 + Phi1 M G2 Phi1', P2 + Phi2' P1 M Phi2.  For S_m itself they are A', -hh', gg'.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import lcm
from typing import Any

from exactkf.kernel.algebraic import Algebraic
from exactkf.kernel.intervals import Interval, around, inverse, minus, product, solved, times, total
from exactkf.kernel.limits import STEPS, WORK, within
from exactkf.kernel.numbers import fraction, need
from exactkf.kernel.orbit_n import is_around, reduce_pair, spectral_polynomial, state_at
from exactkf.kernel.orbit_sieve import minors, symplectic
from exactkf.kernel.orbit_wandering import modular
from exactkf.kernel.roots import divmod_poly

__all__ = ["check_ahead", "state_within"]

_PRIME = (1 << 61) - 1
_Rows = list[list[Interval]]


def check_ahead(Q: list, S: list, answer: Mapping[str, Any], said: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
    """Accept a state after `steps` steps, or that there is none, for an answer that has been checked.

    Parameters
    ----------
    said : mapping
        `steps`; `escape`, a step before, or None; `certain`, whether no escape before is excluded; `state`, lists a and g of ``"p/q"`` and of
        ``{"interval": [lo, hi]}``, or `exact`, lists a and g of numerators and their `denominator` in hexadecimal digits; null where there is none.
    evidence : mapping
        The `bits` of intervals.
    """
    T, escape = said["steps"], answer["escape"]
    need(type(T) is int and T >= 0, "the steps are not a number of steps")
    within(T.bit_length(), 1 << 8, "the bits of the number of steps")
    early = escape is not None and escape < T
    need(set(said) == {"steps", "escape", "certain", "exact" if "exact" in said else "state"}, "the state ahead does not have the members of one")
    need(said["certain"] is (escape is not None or answer["never_escapes"]), "whether an escape is excluded is another matter")
    need(said["escape"] is None if not early else type(said["escape"]) is int and said["escape"] == escape, "the escape before is not that of the answer")
    if early:
        need("state" in said and said["state"] is None, f"there is no state after the escape at step {escape}")
    elif "exact" in said:
        _exact(Q, S, T, said["exact"])
    else:
        _shown(Q, S, T, said["state"], evidence)


def _shown(Q: list, S: list, T: int, state: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
    """Numbers of both kinds; rational ones, and states of before the reduction ends, by stepping."""
    claimed = [*state["a"], *state["g"]]
    need(set(state) == {"a", "g"} and len(state["a"]) == len(state["g"]) == len(Q) - 1, "the state is not a pair a, g")
    if any(isinstance(x, str) for x in claimed) or T <= reduce_pair(Q, S).start:
        within(T, STEPS, "the steps")
        q, s = state_at(Q, S, T)
        exact = _state([Fraction(1) * x / q[-1] for x in q], [Fraction(1) * x / q[-1] for x in s])
        for mine, value in zip(claimed, exact, strict=True):
            if isinstance(mine, str):
                need(value == fraction(mine), f"the state after {T} steps is another")
            else:
                lo, hi = map(fraction, mine["interval"])
                need(set(mine) == {"interval"} and value >= lo and value <= hi, f"the state after {T} steps is not within the interval")
        return
    bits = evidence["ahead"]["bits"]
    found = state_within(Q, S, T, bits)
    need(all(is_around(mine, x, bits) for mine, x in zip(claimed, found, strict=True)), f"the state after {T} steps is not within the interval")


def _state(q: list, s: list) -> list:
    """a and g, one after the other, of a monic pair."""
    return [*(x - y for x, y in zip(q[-2::-1], s[-2::-1], strict=True)), *s[-2::-1]]


# ---------------------------------------------------------------------- exactly
def _exact(Q: list, S: list, T: int, said: Mapping[str, Any]) -> None:
    """Statement 2."""
    need(set(said) == {"a", "g", "denominator"} and len(said["a"]) == len(said["g"]) == len(Q) - 1, "the state is not a pair a, g")
    need(not any(isinstance(x, Algebraic) for x in Q), "an exact state far ahead is for rational data")
    d, *entries = (_hexadecimal(x) for x in (said["denominator"], *said["a"], *said["g"]))
    need(d != 0, "the denominator is zero")
    n = len(Q) - 1
    a, g = entries[:n], entries[n:]
    later = [[*(x + y for x, y in zip(a[::-1], g[::-1], strict=True)), d], [*g[::-1], 0]]  # times d
    reduced = reduce_pair(Q, S)
    if T <= reduced.start:
        state = state_at(Q, S, T)
        need(all(x * state[0][-1] == y * d for mine, p in zip(later, state, strict=True) for x, y in zip(mine, p, strict=True)),
              f"the state after {T} steps is another")
        return
    need(reduced.escape is None, "the state is one behind an escape")
    over = [divmod_poly([Fraction(x) for x in p], reduced.removed) for p in later]
    need(not any(rest for _, rest in over), "the factors in common do not divide the state")
    m = len(reduced.Q) - 1
    if m:
        q_T, g_T = ([*p, *[Fraction(0)] * (m + 1 - len(p))][-2::-1] for p, _ in over)
        _solves(reduced.Q, reduced.S, T - reduced.start, d, q_T, g_T)


def _solves(Q: list, S: list, T: int, d: int, q_T: list, g_T: list) -> None:
    """q_T / d and g_T / d solve the equations: those of statement 2 times q_m(T) d."""
    q, g, m = Q[-2::-1], S[-2::-1], len(Q) - 1
    table, weight = _power(spectral_polynomial(Q, S), symplectic(q, g, 1 / q[-1]), T)
    X, top = table[:m], table[m]
    need(minors([modular(row, _PRIME) for row in X], _PRIME)[0] != 0, "the state is not determined")
    last = q_T[-1]
    need(last != 0, "the last coefficient of the state is zero")
    u = [last - q[-1] * d, *(x * last - q[-1] * y for x, y in zip(q[:-1], q_T[:-1], strict=True))]
    for column, y, g_j in zip(zip(*X, strict=True), top, g, strict=True):
        need(sum(x * v for x, v in zip(column, u, strict=True)) == last * y, f"q is not that after {T} steps")
        need(q[-1] * sum(x * v for x, v in zip(column, g_T, strict=True)) == last * weight * g_j, f"g is not that after {T} steps")


def _power(D: list, S: list[list], T: int) -> tuple[list[list[int]], int]:
    """The first m columns of S^T, of them m + 1 rows, as integers, and the number they are to be divided by."""
    m, below = len(D) // 2, lcm(*(x.denominator for x in D))
    modulus = [int(x * below) for x in D]
    lead, value, e = modulus[-1], [1], 0
    within(T * max(x.bit_length() for x in modulus), WORK, "bits of the state")
    for bit in bin(T)[2:]:
        value, e = _square(value), 2 * e
        if bit == "1":
            value = [0, *value]
        while len(value) >= len(modulus):  # lead value - top modulus z^k
            top = value.pop()
            value, e = [lead * x for x in value], e + 1
            for i, c in enumerate(modulus[:-1], len(value) - len(modulus) + 1):
                value[i] -= c * top
    columns = [[Fraction(int(i == j)) for i in range(2 * m)] for j in range(m)]
    powers = []
    for _ in range(2 * m):
        powers.append([[c[i] for c in columns] for i in range(m + 1)])
        columns = [[sum(x * y for x, y in zip(row, c, strict=True)) for row in S] for c in columns]
    common = lcm(*(x.denominator for rows in powers for row in rows for x in row))
    whole = [[[int(x * common) for x in row] for row in rows] for rows in powers]
    summed = [[sum(c * rows[i][j] for c, rows in zip(value, whole, strict=False)) for j in range(m)] for i in range(m + 1)]
    return summed, common * lead**e


def _square(p: list[int]) -> list[int]:
    out = [0] * (2 * len(p) - 1)
    for i, x in enumerate(p):
        out[2 * i] += x * x
        for j in range(i):
            out[i + j] += 2 * x * p[j]
    return out


def _hexadecimal(text: Any) -> int:
    need(isinstance(text, str) and text.isascii() and text.removeprefix("-").isalnum(), "a number is not in hexadecimal digits")
    return int(text, 16)


# ---------------------------------------------------------------------- in intervals
def state_within(Q: list, S: list, T: int, bits: Any) -> list[Interval]:
    """Intervals around a and g after T steps, more than the reduction takes; see statement 3."""
    need(type(bits) is int and 0 < bits < 1 << 18, "the bits are not a positive number")
    reduced = reduce_pair(Q, S)
    need(T > reduced.start and reduced.escape is None, "the state is one of before the reduction ends, or behind an escape")
    m, one = len(reduced.Q) - 1, (1 << bits, 1 << bits)
    q, s = ([*([around(x, bits) for x in p[:-1]]), last] for p, last in ((reduced.Q, one), (reduced.S, (0, 0))))
    within(bits * T.bit_length() * max(m, 1) ** 3, WORK, "bits of the intervals")
    if m:
        q, s = _moved(q[-2::-1], s[-2::-1], T - reduced.start, bits)
    common = [around(x, bits) for x in reduced.removed]
    q, s = product(q, common, bits), product(s, common, bits)
    return [*(minus(x, y) for x, y in zip(q[-2::-1], s[-2::-1], strict=True)), *s[-2::-1]]


def _moved(q: list[Interval], g: list[Interval], T: int, bits: int) -> tuple[list[Interval], list[Interval]]:
    m, one, zero = len(q), (1 << bits, 1 << bits), (0, 0)
    phi = [[minus(zero, x) for x in q], *([one if i == j else zero for j in range(m)] for i in range(m - 1))]  # the transpose of J - qh'
    G = [[(-one[0], -one[0]) if i == j == 0 else zero for j in range(m)] for i in range(m)]
    first = power = phi, G, [[times(x, y, bits) for y in g] for x in g]
    for bit in bin(T)[3:]:
        power = _after(power, power, bits)
        if bit == "1":
            power = _after(first, power, bits)
    phi, _, P = power
    u = [row[0] for row in P]
    unit = inverse(minus(one, u[0]), bits)
    w = [total([times(x, y, bits) for x, y in zip(column, g, strict=True)]) for column in zip(*phi, strict=True)]
    q_T = [times(minus(x, y), unit, bits) for x, y in zip(q, [*u[1:], zero], strict=True)]
    return [*q_T[::-1], one], [*(times(x, unit, bits) for x in reversed(w)), zero]


def _after(second: tuple[_Rows, _Rows, _Rows], first: tuple[_Rows, _Rows, _Rows], bits: int) -> tuple[_Rows, _Rows, _Rows]:
    """Phi, G, P of a product of two powers."""
    (phi1, G1, P1), (phi2, G2, P2) = first, second
    m, one = len(P1), 1 << bits
    near = [[(x[0] + one * (i == j), x[1] + one * (i == j)) for j, x in enumerate(row)] for i, row in enumerate(_times(G2, P1, bits))]
    right = solved(near, [[*x, *y] for x, y in zip(phi2, G2, strict=True)], bits)  # M Phi2, M G2
    phi, G = [row[:m] for row in right], [row[m:] for row in right]
    return (_times(phi1, phi, bits), _plus(G1, _times(phi1, _times(G, _turned(phi1), bits), bits)),
            _plus(P2, _times(_turned(phi2), _times(P1, phi, bits), bits)))


def _times(A: _Rows, B: _Rows, bits: int) -> _Rows:
    columns = _turned(B)
    return [[total([times(x, y, bits) for x, y in zip(row, column, strict=True)]) for column in columns] for row in A]


def _plus(A: _Rows, B: _Rows) -> _Rows:
    return [[(x[0] + y[0], x[1] + y[1]) for x, y in zip(r, s, strict=True)] for r, s in zip(A, B, strict=True)]


def _turned(A: _Rows) -> _Rows:
    return [list(column) for column in zip(*A, strict=True)]
