# SPDX-License-Identifier: MIT
r"""Orbits of order one that double precision gets wrong.

Main definitions
----------------
``EXAMPLES``             starts with exact coordinates, and what is true of them
``verdict_of_doubles``   what one reads off an orbit computed in double precision

Doubles lose these orbits in three ways: a square underflows or is rounded away, so that a point
leaves its hyperbola; a pole is missed or hit by rounding, so that an escape is passed over or made up; and no
precision tells a rotation by a rational part of the circle from one close to it.

References
----------
BLM91 (3.10), Theorems 3.5, 3.7.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from exactkf.exact._messages import check_count

__all__ = ["EXAMPLES", "Example", "verdict_of_doubles"]


@dataclass(frozen=True)
class Example:
    """One start.

    Attributes
    ----------
    name : str
    alpha0, gamma0 : str
        Exact coordinates.
    doubles : str
        What doubles say.
    behaviour : str
        What is true, as `Answer.behaviour`.
    why : str
        One sentence.
    """

    name: str
    alpha0: str
    gamma0: str
    doubles: str
    behaviour: str
    why: str


EXAMPLES = (
    Example("a false equilibrium", "3", f"1/{10**400}", "converges to 3", "converges",
            "gamma is below the smallest double; in truth the orbit leaves 3, changes its sign at step 840 and converges to about 1/3"),
    Example("an escape passed over", "1829/574", "-8/287", "converges to 0.225148", "escapes",
            "1 - gamma^2 is zero at step 3; doubles miss it, land on another hyperbola and converge to a number that is not even an equilibrium of this one"),
    Example("an escape taken for wandering", "341/170", "-8/85", "wanders", "escapes",
            "1 - gamma^2 is zero at step 3; doubles miss it and land in a corridor, on which nothing converges"),
    Example("an escape made up", "5/2", f"{10**20 + 1}/{10**20}", "escapes at 0", "converges",
            "gamma is rounded to one; in truth the orbit jumps over infinity and converges to about 1/2"),
    Example("a rotation that is not periodic", "-250000000000000000001/150000000000000000000", "-175000000000000000001/75000000000000000000",
            "period 3", "dense", "1/kappa is 1/2 + 1e-20: the orbit never returns, and fills the hyperbola"),
    Example("a period lost at a pole", f"{2 * 10**9}/{10**18 - 1}", f"{10**18 + 1}/{10**18 - 1}", "escapes at 0", "periodic",
            "gamma exceeds one by 2e-18; in truth the orbit goes out to 5e8 and is back after four steps"),
    Example("a passage taken for a limit", "1", f"1/{10**9}", "converges to 1", "dense",
            "the orbit takes some 10^9 steps past the place where two equilibria are missing, and then goes round again"),
)


def verdict_of_doubles(alpha0: str, gamma0: str, steps: int = 10_000) -> str:
    r"""Return what an orbit in double precision looks like: an impression, never evidence.

    Parameters
    ----------
    alpha0, gamma0 : str
        Exact coordinates, rounded here.
    steps : int

    Returns
    -------
    str
        ``escapes at t`` where `1 - gamma**2` is zero; ``period p`` for the least p up to 12 after which 100 late states come
        back to ten digits; ``converges to x`` where the last step moves alpha by less than 1e-10; else ``wanders``.
    """
    check_count("steps", steps, 1, 10**6)
    x, y = float(Fraction(alpha0)), float(Fraction(gamma0))
    states = [(x, y)]
    for t in range(steps):
        rest = 1 - y * y
        if rest == 0:
            return f"escapes at {t}"
        x = x / rest
        y = -y * x
        states.append((x, y))
    late = states[-200:]
    if abs(late[-1][0] - late[-2][0]) < 1e-10 and abs(late[-1][1]) < 1e-6:
        return f"converges to {late[-1][0]:.6g}"
    for p in range(1, 13):
        if all(abs(a - c) <= 1e-10 * abs(a) and abs(b - d) <= 1e-10 * abs(b) for (a, b), (c, d) in zip(late[:100], late[p:], strict=False)):
            return f"period {p}"
    return "wanders"
