# SPDX-License-Identifier: MIT
r"""The derivation of a decision of order one, in words and in LaTeX.

Each function returns sentences of one step of the derivation; the mathematics is
in the header of `exactkf.dynamics.order_one`.  :math:`c = 1/\kappa`.

References
----------
BLM91 (3.10), (3.13), (4.7), Theorems 3.5, 3.7, 4.1.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactkf.dynamics.answer import Fact
from exactkf.dynamics.exact_json import number_latex, number_words, polynomial_latex, polynomial_text, polynomial_words
from exactkf.exact import RealField, RealNumber
from exactkf.exact.balls import ball, precision
from exactkf.theory._scalars import Scalar

if TYPE_CHECKING:
    from exactkf.dynamics.order_one import Course

__all__ = ["axis", "convergence", "equilibrium", "escape", "invariant", "of_field", "riccati_axis", "riccati_convergence", "riccati_equilibrium",
           "riccati_escape", "riccati_invariant", "turning", "vertex"]


def of_field(field: RealField) -> Fact:
    """The generator of the field."""
    p = polynomial_words(field.minpoly, "x")
    near = field.enclose_gen(64).str(12, radius=False)
    return Fact(f"theta = {near}... is the root of {p} in [{field.root.lo}, {field.root.hi}].",
                rf"$\vartheta = {near}\ldots$ is the root of ${polynomial_latex(field.minpoly.coeffs(), 'x')}$ in $[{field.root.lo}, {field.root.hi}]$.")


def _plural(n: int, word: str) -> str:
    return f"{n} {word}" + ("" if n == 1 else "s")


# ---------------------------------------------------------------------- the filter
def vertex() -> list[Fact]:
    """alpha = 0, gamma = 1 or -1."""
    return [Fact("gamma_0^2 = 1: the state has no successor, the orbit escapes at t = 0.",
                 r"$\gamma_0^2 = 1$: the state has no successor, the orbit escapes at $t = 0$.")]


def axis(gamma: Scalar) -> list[Fact]:
    """alpha = 0."""
    if gamma == 0:
        return [Fact("(0, 0) is an equilibrium.", "$(0, 0)$ is an equilibrium.")]
    return [Fact("alpha_0 = 0, so alpha_t = 0 for all t and gamma_t = 0 from t = 1 on: the orbit is at the equilibrium (0, 0) after one step.",
                 r"$\alpha_0 = 0$, so $\alpha_t = 0$ for all $t$ and $\gamma_t = 0$ for $t \ge 1$: the orbit is at the equilibrium $(0, 0)$ after one step.")]


def equilibrium(alpha: Scalar) -> list[Fact]:
    """gamma = 0, alpha not 0."""
    size = {True: "unstable", False: "stable"}[abs(alpha) > 1]
    return [Fact(f"gamma_0 = 0: ({number_words(alpha)}, 0) is an equilibrium, {size} along its hyperbola.",
                 rf"$\gamma_0 = 0$: $({number_latex(alpha)}, 0)$ is an equilibrium, {size} along its hyperbola.")]


def invariant(c: Scalar, found: Course, region: str) -> list[Fact]:
    """kappa, and what its size means."""
    first = Fact(f"1/kappa = (1 + alpha^2 - gamma^2)/(2 alpha) = {number_words(c)} is constant along the orbit; "
                 "alpha_t moves by alpha -> 1/(2/kappa - alpha).",
                 rf"$1/\kappa = (1 + \alpha^2 - \gamma^2)/(2\alpha) = {number_latex(c)}$ is constant along the orbit; "
                 r"$\alpha_t$ moves by $\alpha \mapsto 1/(2/\kappa - \alpha)$.")
    place = {"hyperbolic": f"the orbit starts in region {region}", "elliptic": "the start is in a corridor"}
    return [first, _kind(found, place.get(found.kind, f"the start is on the {region}"))]


def _kind(found: Course, place: str) -> Fact:
    words, tex = {
        "hyperbolic": ("|1/kappa| > 1: D keeps its sign on the circle, and", r"$|1/\kappa| > 1$: $D$ keeps its sign on the circle, and"),
        "parabolic": ("|1/kappa| = 1: D has a double zero on the circle, and", r"$|1/\kappa| = 1$: $D$ has a double zero on the circle, and"),
        "elliptic": ("|1/kappa| < 1: D changes its sign on the circle, so that no orbit with this kappa converges;",
                     r"$|1/\kappa| < 1$: $D$ changes its sign on the circle, so that no orbit with this $\kappa$ converges;"),
    }[found.kind]
    return Fact(f"{words} {place}.", f"{tex} {place}.")


def escape(t: int, found: Course) -> list[Fact]:
    """The orbit ends."""
    told = [Fact(f"gamma_t^2 = 1 for the first time at t = {t}: the state has no successor, the orbit escapes.",
                 rf"$\gamma_t^2 = 1$ for the first time at $t = {t}$: the state has no successor, the orbit escapes.")]
    if found.order is not None:
        told.append(Fact(f"The other orbits on this curve that do not escape have period {found.order}.",
                         f"The other orbits on this curve that do not escape have period ${found.order}$."))
    return told


def convergence(c: Scalar, alpha: Scalar, found: Course) -> list[Fact]:
    """Where to, from where on monotonically, how fast."""
    m, s = found.change, "-" if c < 0 else ""
    told = []
    if m >= 1:
        first = f"The orbit is in region IV for {_plural(m - 1, 'step')}, in" if m > 1 else "The orbit is in"
        told.append(Fact(f"{first} region III at t = {m - 1}, in region II at t = {m}, and in region I from t = {m + 1} on.",
                         f"{first} region III at $t = {m - 1}$, in region II at $t = {m}$, and in region I from $t = {m + 1}$ on."))
    elif m == 0:
        told.append(Fact("The orbit is in region II at t = 0, and in region I from t = 1 on.",
                         "The orbit is in region II at $t = 0$, and in region I from $t = 1$ on."))
    told.append(Fact(f"It never escapes; from t = {max(m, 0)} on alpha_t approaches its limit monotonically, and |gamma_t| decreases.",
                     rf"It never escapes; from $t = {max(m, 0)}$ on $\alpha_t$ approaches its limit monotonically, and $|\gamma_t|$ decreases."))
    if found.kind == "parabolic":
        tau = alpha / (c - alpha)
        told.append(Fact(f"The limit is ({s}1, 0); the distance of alpha_t from it is 1/(t + 1 + tau), tau = {number_words(tau)}: "
                         "slower than any geometric rate.",
                         rf"The limit is $({s}1, 0)$; the distance of $\alpha_t$ from it is $1/(t + 1 + \tau)$, $\tau = {number_latex(tau)}$: "
                         "slower than any geometric rate."))
        return told
    near = _approximate(c)
    sign = "+" if c < 0 else "-"
    told.append(Fact(f"The limit is (alpha_+, 0), alpha_+ = 1/kappa {sign} sqrt(1/kappa^2 - 1) = {near}...; the distance of alpha_t from it shrinks by the "
                     "factor alpha_+^2 a step in the limit, |gamma_t| by |alpha_+|.",
                     rf"The limit is $(\alpha_+, 0)$, $\alpha_+ = 1/\kappa {sign} \sqrt{{1/\kappa^2 - 1}} = {near}\ldots$; the distance of $\alpha_t$ from it "
                     r"shrinks by the factor $\alpha_+^2$ a step in the limit, $|\gamma_t|$ by $|\alpha_+|$."))
    return told


def _approximate(c: Scalar, digits: int = 8) -> str:
    """The root of z^2 - 2cz + 1 of smaller modulus, to some digits."""
    bits = 64
    while True:
        with precision(bits):
            x = c.enclose(bits * 3 // 10) if isinstance(c, RealNumber) else ball(c)
            root = 1 / (abs(x) + (x * x - 1).sqrt())
            if root.is_finite() and root.rel_accuracy_bits() > 4 * digits:
                return (root if c > 0 else -root).str(digits, radius=False)
        bits *= 2


# ---------------------------------------------------------------------- both systems
def turning(c: Scalar, order: int | None, period: int | None, system: str) -> list[Fact]:
    """Periodic, or dense."""
    where, state = ("the hyperbola", "alpha and gamma") if system == "filter" else ("the real line", "pi")
    x, tex = number_words(-2 * c), number_latex(-2 * c)
    if order is None:
        first = Fact(f"-2/kappa = {x} is not 2 cos of a rational multiple of pi: its minimal polynomial is none of those of 2 cos(2 pi/P).",
                     rf"$-2/\kappa = {tex}$ is not $2\cos$ of a rational multiple of $\pi$: its minimal polynomial is none of those of $2\cos(2\pi/P)$.")
        return [first, Fact(f"The map turns by an irrational part of the circle: the orbit is dense on {where}, and neither periodic nor convergent.",
                            f"The map turns by an irrational part of the circle: the orbit is dense on {where}, and neither periodic nor convergent."),
                _never("by heights, no step beyond a computed bound can escape, and no step up to it does")]
    first = Fact(f"-2/kappa = {x} has the minimal polynomial of 2 cos(2 pi/{order}): {state} have the least period {period}.",
                 rf"$-2/\kappa = {tex}$ has the minimal polynomial of $2\cos(2\pi/{order})$: the least period is ${period}$.")
    return [first, _never("no step of one period does")]


def _never(why: str) -> Fact:
    return Fact(f"The orbit never escapes: {why}.", f"The orbit never escapes: {why}.")


# ---------------------------------------------------------------------- the Riccati equation
def riccati_axis(square: Scalar) -> list[Fact]:
    """alpha = 0."""
    return [Fact(f"alpha_0 = 0: pi_t = gamma_0^2 = {number_words(square)} from t = 1 on.",
                 rf"$\alpha_0 = 0$: $\pi_t = \gamma_0^2 = {number_latex(square)}$ for $t \ge 1$.")]


def riccati_escape(t: int, found: Course | None) -> list[Fact]:
    """pi = 1."""
    told = [Fact(f"pi_t = 1 for the first time at t = {t}: the equation gives no successor.",
                 rf"$\pi_t = 1$ for the first time at $t = {t}$: the equation gives no successor.")]
    if found is not None and found.order is not None:
        p = found.order if found.order % 2 else found.order // 2
        told.append(Fact(f"The solutions that do not escape have period {p}.", f"The solutions that do not escape have period ${p}$."))
    return told


def riccati_equilibrium(alpha: Scalar, c: Scalar, square: Scalar) -> list[Fact]:
    """phi(pi) = 0."""
    return [_phi(alpha, c, square), Fact("phi(pi_0) = 0: pi_0 is an equilibrium.", r"$\varphi(\pi_0) = 0$: $\pi_0$ is an equilibrium.")]


def _phi(alpha: Scalar, c: Scalar, square: Scalar) -> Fact:
    b, q = 2 * (1 - alpha * c), square
    phi = [q, -b, b - b + 1]
    return Fact(f"The equilibria are the real zeros of phi(p) = {polynomial_text(phi, 'p')}; 1/kappa = {number_words(c)}.",
                rf"The equilibria are the real zeros of $\varphi(p) = {polynomial_latex(phi, 'p')}$; $1/\kappa = {number_latex(c)}$.")


def riccati_invariant(alpha: Scalar, c: Scalar, square: Scalar, found: Course, region: str) -> list[Fact]:
    """The equilibria, and where the start lies."""
    place = "the equation has no real equilibrium" if found.kind == "elliptic" else f"the start is {region}"
    return [_phi(alpha, c, square), _kind(found, place)]


def riccati_convergence(alpha: Scalar, c: Scalar, found: Course) -> list[Fact]:
    """Where to, from where on monotonically."""
    which = "the double zero" if found.kind == "parabolic" else "the smaller zero" if alpha * c > 0 else "the larger zero"
    m = found.change + 1
    told = [Fact(f"pi_t never is 1 and tends to {which} of phi, monotonically from t = {m} on.",
                 rf"$\pi_t$ never is $1$ and tends to {which} of $\varphi$, monotonically from $t = {m}$ on.")]
    if found.kind == "hyperbolic":
        near = _approximate(c)
        told.append(Fact(f"The distance from the limit shrinks by the factor alpha_+^2 a step in the limit, alpha_+ = {near}....",
                         rf"The distance from the limit shrinks by the factor $\alpha_+^2$ a step in the limit, $\alpha_+ = {near}\ldots$."))
    else:
        told.append(Fact("The distance from the limit goes to zero like 1/t.", "The distance from the limit goes to zero like $1/t$."))
    return told
