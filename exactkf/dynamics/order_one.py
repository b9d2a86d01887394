# SPDX-License-Identifier: MIT
r"""Orbits of order one, decided completely.

For every real algebraic start of the fast filter

.. math:: \alpha' = \alpha / (1 - \gamma^2), \qquad \gamma' = -\gamma \alpha'

and of the Riccati equation :math:`\pi' = (s \pi + \gamma_0^2) / (1 - \pi)`, :math:`s = \alpha_0^2 - \gamma_0^2`.

Main definitions
----------------
``decide_order_one``     what the filter does
``decide_riccati_one``   what the solution of the Riccati equation does

Main statements
---------------
Let :math:`\alpha_0 \ne 0`, :math:`c = 1/\kappa = (1 + \alpha_0^2 - \gamma_0^2)/(2\alpha_0)`, and let
:math:`y_{t+1} = 2c\,y_t - y_{t-1}` with :math:`y_1 = 1`, :math:`y_0 = a`, where :math:`a = \alpha_0`, or :math:`a = \alpha_0/(1 - \pi_0)`
for the Riccati equation with :math:`\pi_0 \ne 1`.

1. *Linear recursion.*  While the orbit is defined, :math:`\alpha_t = y_t / y_{t+1}` and
   :math:`\gamma_t = (-1)^t \gamma_0 / y_{t+1}`, and :math:`1 - \pi_t = \alpha_0 y_{t+1} / y_t`.

   Proof.  The form :math:`E = y_t^2 - 2c\,y_t y_{t+1} + y_{t+1}^2` is constant, for :math:`y_t` and :math:`y_{t+2}` are the
   roots of :math:`z^2 - 2c\,y_{t+1} z + y_{t+1}^2 - E`.  For the filter it is :math:`\gamma_0^2`, by the definition of `c`.  So
   :math:`1 - \gamma_t^2 = (y_{t+1}^2 - E)/y_{t+1}^2 = y_t y_{t+2} / y_{t+1}^2`, and :math:`\alpha_t/(1 - \gamma_t^2) = y_{t+1} / y_{t+2}`.
   The rest is substitution, with :math:`1 - \pi' = 2c\alpha_0 - \alpha_0^2/(1 - \pi)`.

2. *Escape.*  The filter has no successor at the first :math:`t \ge 0` with :math:`y_{t+2} = 0`, the Riccati equation
   at the first :math:`t \ge 1` with :math:`y_{t+1} = 0`, or at 0 if :math:`\pi_0 = 1`.  (By 1; :math:`y_0, y_1 \ne 0`.)

3. *Equilibria.*  Exactly the starts with `E` = 0.  For the filter that is :math:`\gamma_0 = 0`, for the Riccati equation
   :math:`\varphi(\pi_0) = 0`, where :math:`\varphi(p) = p^2 - 2(1 - \alpha_0 c) p + \gamma_0^2` and :math:`E = \varphi(\pi_0)/(1 - \pi_0)^2`.

4. *Definite*, :math:`|c| > 1`.  Let `l` be the root of :math:`l^2 - 2cl + 1` with :math:`|l| < 1` and `s` its sign, and
   :math:`y_t = A l^{-t} + B l^t`; then :math:`E = -AB (1/l - l)^2`.  For `E` not 0, :math:`y_t = A l^{-t}(1 - k_t)` with :math:`k_t = k l^{2t}`,
   `k > 0` for `E > 0` and `k < 0` for `E < 0`.  Hence :math:`\alpha_t / l = (1 - k_t)/(1 - l^2 k_t)`, a decreasing function of
   :math:`k_t` on each side of its pole, and :math:`k_t` decreases to 0 if `k > 0`.

   For `k > 0` let `m` be the integer with :math:`1 \le k_m < l^{-2}`.  If :math:`k_m = 1` and :math:`m \ge 2` the orbit escapes, by 2.
   Otherwise :math:`s\alpha_t` is more than :math:`1/|l|` and increases for :math:`t < m`; it is negative at `m`, and from `m` on increases
   to :math:`|l|`.  So the orbit is in region IV for :math:`t < m - 1`, in III at `m - 1` (there :math:`\gamma^2 > 1`, as the next
   :math:`\alpha` has the other sign), in II at `m`, and in I from `m + 1` on, where :math:`|\gamma_{t+1}/\gamma_t| = |\alpha_{t+1}| < 1`.
   The distance of :math:`\alpha_t` from `l` shrinks by :math:`l \alpha_{t+1}` in a step, :math:`|\gamma_t|` by :math:`|\alpha_{t+1}|`.

   :math:`1 - \pi_t` tends to :math:`\alpha_0/l`, monotonically from `m + 1` on; from 0 on if `E < 0` or there is no :math:`m \ge 0`.

5. *Parabolic*, :math:`c = \pm 1`.  :math:`y_t = c^t (A + Bt)`, `A = a`, `B = c - a`, and `B = 0` only at the equilibrium.  With
   :math:`\tau = A/B`, :math:`c\,\alpha_t = 1 - 1/(t + 1 + \tau)`.  The orbit escapes exactly if :math:`-\tau` is an integer of at least 2 (filter: at
   :math:`-\tau - 2`); otherwise 4 holds with `l = c` and :math:`-1 - \tau < m < -\tau`, and the distance to the limit is the last fraction.

6. *Elliptic*, :math:`|c| < 1`.  Let :math:`c = \cos\phi`, :math:`y_t = R\cos(t\phi + \psi)`; then :math:`\gamma_0^2 = E = R^2 \sin^2\phi`.  With
   :math:`X_t = (t + 1)\phi + \psi + t\pi`, :math:`\alpha_t = \cos\phi + \sin\phi\tan X_t`, :math:`\gamma_t = \gamma_0 / (R\cos X_t)`.  This is a
   homeomorphism of the circle without :math:`\cos X = 0` onto both branches of the hyperbola (3.13), and :math:`X_{t+1} = X_t + \phi + \pi`.
   So the filter has the order of :math:`v = e^{i(\phi + \pi)}` as its period, and otherwise a dense orbit (Kronecker).
   :math:`\pi_t` depends on `X` modulo :math:`\pi`, so its period is the order of :math:`v^2`, and otherwise the orbit is
   dense on the line.  :math:`v + 1/v = -2c`.

7. *All t.*  If `v` is no root of unity at most one :math:`y_t` vanishes, and none beyond a bound given by heights
   (`exactkf.kernel.rotation`).  If `v` has order `P`, one period is looked through.

8. :math:`\alpha_0 = 0`: the filter is at (0, 0) after one step, or escapes at once if :math:`\gamma_0^2 = 1`; :math:`\pi_1 = \gamma_0^2`
   for every :math:`\pi_0 \ne 1`, and the solution escapes there if :math:`\gamma_0^2 = 1`.

The positive real region (`exactkf.dynamics.every_order`) is the open diamond :math:`|\alpha| + |\gamma| < 1`; orbits of 5 and 6 never
enter it, nor do the equilibria outside.

Notation
--------
Regions as in BLM91, Fig. 2, with the sign of :math:`\kappa` as index: I :math:`|\alpha| + |\gamma| \le 1`; II
:math:`|\gamma| \ge 1 + |\alpha|`; III, IV :math:`|\alpha| \ge 1 + |\gamma|` with :math:`|\gamma| > 1`, :math:`|\gamma| \le 1`; the corridors are the rest.

References
----------
BLM91 (3.10), (3.13), (4.7), (4.11), (5.1), Theorems 3.5, 3.7, 4.1, Corollaries 4.2, 4.3.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from flint import fmpq

from exactkf._errors import BadInput
from exactkf.dynamics import order_one_facts as facts
from exactkf.dynamics.answer import Answer, Fact
from exactkf.dynamics.exact_json import element_json, field_json, field_of, number_json, root_json
from exactkf.dynamics.rotation import rotation_order, sign_change, whole_part, zero_index
from exactkf.exact import RealNumber, rational
from exactkf.kernel.replay import seal
from exactkf.theory._scalars import Scalar

__all__ = ["decide_order_one", "decide_riccati_one"]


class Course(NamedTuple):
    """What :math:`y_t` does.

    Attributes
    ----------
    kind : str
        "elliptic", "parabolic" or "hyperbolic".
    zero : int or None
        The first :math:`t \\ge 2` with :math:`y_t = 0`.
    change : int
        `m` of the header, or -1 if there is none; without meaning in the elliptic case.
    order : int or None
        The order of `v` as a root of unity, in the elliptic case.
    """

    kind: str
    zero: int | None
    change: int
    order: int | None


def course(c: Scalar, a: Scalar, form: int) -> Course:
    """Decide what :math:`y_t` does; `form` is the sign of `E`, not 0."""
    size = _sign(c * c - 1)
    if size < 0:
        order = rotation_order(-2 * c)
        stop = None if order is None else order if order % 2 else order // 2
        return Course("elliptic", zero_index(2 * c, a, stop), -1, order)
    s = _sign(c)
    kind = "hyperbolic" if size else "parabolic"
    if form < 0 or (a > 0) == (s > 0) and s * a < 1:
        return Course(kind, None, -1, None)
    if (a > 0) != (s > 0):
        return Course(kind, None, 0, None)
    if size == 0:
        minus_tau = a / (a - s)
        m = whole_part(minus_tau)
        return Course(kind, m if minus_tau == m else None, m, None)
    m, zero = sign_change(2 * c, a)
    return Course(kind, m if zero else None, m, None)


def decide_order_one(alpha0: Any, gamma0: Any) -> Answer:
    r"""Decide the orbit of the fast filter from :math:`(\alpha_0, \gamma_0)` (BLM91 (3.10)).

    Parameters
    ----------
    alpha0, gamma0 : fmpq, int, Fraction, str such as "3/4", or RealNumber of one field

    Returns
    -------
    Answer
        Decided for all `t`; its certificate replays with the checker.

    Raises
    ------
    BadInput
        If an argument is not an exact real number, or the two belong to different fields.

    Examples
    --------
    >>> decide_order_one("-5/3", "-7/3").period
    3
    >>> decide_order_one(2, "1/2").limit["alpha"]
    [{'minpoly': ['8', '-19', '8'], 'interval': ['0', '1']}]
    """
    alpha, gamma = _one_field(alpha0=alpha0, gamma0=gamma0)
    return _answer((alpha, gamma), _filter(alpha, gamma))


def decide_riccati_one(alpha0: Any, gamma0: Any, pi0: Any = 0) -> Answer:
    r"""Decide the solution of the Riccati equation of :math:`(\alpha_0, \gamma_0)` from :math:`\pi_0` (BLM91 (4.7)).

    Parameters
    ----------
    alpha0, gamma0, pi0 : fmpq, int, Fraction, str such as "3/4", or RealNumber of one field

    Returns
    -------
    Answer
        ``escape`` is the first `t` with :math:`\pi_t = 1`; ``limit`` is ``{"pi": ...}``.

    Raises
    ------
    BadInput
        As `decide_order_one`.

    Examples
    --------
    >>> decide_riccati_one("3/4", "5/4").period
    2
    """
    alpha, gamma, pi = _one_field(alpha0=alpha0, gamma0=gamma0, pi0=pi0)
    return _answer((alpha, gamma, pi), _riccati(alpha, gamma, pi))


class _Decision(NamedTuple):
    """Entries of the answer, and what tells the derivation."""

    entries: dict[str, Any]
    facts: Callable[[], list[Fact]]


def _answer(scalars: tuple[Scalar, ...], decision: _Decision) -> Answer:
    """The answer; its derivation is told and its certificate sealed when they are asked for."""
    return Answer.of_entries(1, decision.entries, _LATER, scalars)


def _told(answer: Answer) -> tuple[Fact, ...]:
    """The derivation; to decide again is quicker than to keep what thousands of answers might be asked."""
    scalars = answer.__dict__["_start"]
    field = field_of(*scalars)
    decision = _filter(*scalars) if len(scalars) == 2 else _riccati(*scalars)
    return (*([] if field is None else [facts.of_field(field)]), *decision.facts())


def _sealed(answer: Answer) -> dict[str, Any]:
    """The certificate of an answer."""
    from exactkf.dynamics.certified import parts

    scalars = answer.__dict__["_start"]
    alpha, gamma, *pi = scalars
    question = {"order": 1, "system": "riccati" if pi else "filter", "field": field_json(field_of(*scalars)),
                "alpha": [element_json(alpha)], "gamma": [element_json(gamma)], **({"pi": element_json(pi[0])} if pi else {})}
    said, evidence = parts(answer, *_state(answer))
    return seal("orbit", "orbit", {"question": question, "answer": {**answer.decided(), **said}}, evidence)


def _structure(answer: Answer) -> dict[str, Any]:
    from exactkf.dynamics.certified import structure_of

    return structure_of(answer, *_state(answer))


def _state(answer: Answer) -> tuple[list[Scalar], list[Scalar]]:
    """The filter, also where the question is about the Riccati equation."""
    alpha, gamma = answer.__dict__["_start"][:2]
    return [alpha - gamma], [gamma + 0 * alpha]  # both in one field


_LATER = {"facts": _told, "certificate": _sealed, "structure": _structure}


def _one_field(**named: Any) -> list[Scalar]:
    """The arguments as rational numbers or as elements of one field."""
    values = {k: x if isinstance(x, RealNumber) else rational(x, name=k) for k, x in named.items()}
    values = {k: x.rational_value() if isinstance(x, RealNumber) and x.is_rational() else x for k, x in values.items()}
    field = field_of(*values.values())
    for name, x in values.items():
        if isinstance(x, RealNumber) and field and x.field != field:
            raise BadInput(f"{name} = {x} is in Q({x.field.name}), another argument in Q({field.name}); pass numbers of one field")
    return list(values.values())


def _sign(x: Scalar) -> int:
    return (x > 0) - (x < 0)


# ---------------------------------------------------------------------- the filter
def _filter(alpha: Scalar, gamma: Scalar) -> _Decision:
    inside = abs(alpha) + abs(gamma) < 1
    if alpha == 0:
        return _filter_at_zero(gamma, inside)
    if gamma == 0:
        region = {-1: "I", 0: "boundary of I", 1: "IV"}[_sign(alpha * alpha - 1)] + ("+" if alpha > 0 else "-")
        entries = dict(behaviour="converges", never_escapes=True, limit={"alpha": [number_json(alpha)], "gamma": "0"}, monotone_from=0, region=region,
                       period=1, enters_positive_real=0 if inside else None)
        return _Decision(entries, lambda: facts.equilibrium(alpha))
    c = (1 + alpha * alpha - gamma * gamma) / (2 * alpha)
    found = course(c, alpha, 1)
    escape = None if found.zero is None else found.zero - 2
    region = "corridor" if found.kind == "elliptic" else _region(alpha, gamma, c, found.kind)
    entries = dict(escape=escape, never_escapes=escape is None, region=region)

    def told() -> list[Fact]:
        return facts.invariant(c, found, region)

    if escape is not None:
        return _Decision({**entries, "behaviour": "escapes"}, lambda: told() + facts.escape(escape, found))
    if found.kind == "elliptic":
        return _Decision({**entries, **_turning(found.order)}, lambda: told() + facts.turning(c, found.order, found.order, "filter"))
    limit = number_json(alpha - alpha + _sign(c)) if found.kind == "parabolic" else root_json(c, fmpq(1), c > 0)
    entries.update(behaviour="converges", limit={"alpha": [limit], "gamma": "0"}, monotone_from=max(found.change, 0))
    if found.kind == "hyperbolic":
        entries.update(rate=root_json(2 * c * c - 1, fmpq(1), True), enters_positive_real=max(found.change + 1, 0))
    else:
        entries.update(slow=1)
    return _Decision(entries, lambda: told() + facts.convergence(c, alpha, found))


def _filter_at_zero(gamma: Scalar, inside: bool) -> _Decision:
    if gamma * gamma == 1:
        return _Decision(dict(behaviour="escapes", escape=0, region="vertex"), lambda: facts.vertex())
    entries = dict(behaviour="converges", never_escapes=True, limit={"alpha": ["0"], "gamma": "0"}, monotone_from=0,
                   region="I" if inside else "II", rate=None if gamma == 0 else "0", period=1 if gamma == 0 else None,
                   enters_positive_real=0 if inside else 1)
    return _Decision(entries, lambda: facts.axis(gamma))


def _region(alpha: Scalar, gamma: Scalar, c: Scalar, kind: str) -> str:
    """The region of a start off the corridors."""
    s = _sign(c)
    name = "II" if s * alpha < 0 else "I" if s * alpha < 1 else "III" if gamma * gamma > 1 else "IV"
    return ("boundary of " if kind == "parabolic" else "") + name + ("+" if s > 0 else "-")


def _turning(period: int | None) -> dict[str, Any]:
    if period is None:
        return dict(behaviour="dense", torus_dimension=1)
    return dict(behaviour="periodic", period=period)


# ---------------------------------------------------------------------- the Riccati equation
def _riccati(alpha: Scalar, gamma: Scalar, pi: Scalar) -> _Decision:
    square = gamma * gamma
    if alpha == 0:
        return _riccati_at_zero(square, pi)
    c = (1 + alpha * alpha - square) / (2 * alpha)
    form = _sign(pi * pi - 2 * (1 - alpha * c) * pi + square)
    region = {0: "equilibrium", 1: "outside the equilibria", -1: "between the equilibria"}[form] if c * c >= 1 else "no equilibria"
    entries: dict[str, Any] = dict(region=region)
    if pi == 1:
        return _Decision({**entries, "behaviour": "escapes", "escape": 0}, lambda: facts.riccati_escape(0, None))
    if form == 0:
        entries.update(behaviour="converges", never_escapes=True, limit={"pi": number_json(pi)}, monotone_from=0, period=1)
        return _Decision(entries, lambda: facts.riccati_equilibrium(alpha, c, square))
    a = alpha / (1 - pi)
    found = course(c, a, form)
    escape = None if found.zero is None else found.zero - 1
    entries.update(escape=escape, never_escapes=escape is None)

    def told() -> list[Fact]:
        return facts.riccati_invariant(alpha, c, square, found, region)

    if escape is not None:
        return _Decision({**entries, "behaviour": "escapes"}, lambda: told() + facts.riccati_escape(escape, found))
    if found.kind == "elliptic":
        halved = found.order if found.order is None or found.order % 2 else found.order // 2
        return _Decision({**entries, **_turning(halved)}, lambda: told() + facts.turning(c, found.order, halved, "riccati"))
    if found.kind == "parabolic":
        limit = number_json(1 - alpha * _sign(c))
        entries.update(slow=1)
    else:  # 1 - pi tends to alpha times the root of larger modulus
        limit = root_json(1 - alpha * c, square, alpha * c > 0)
        entries.update(rate=root_json(2 * c * c - 1, fmpq(1), True))
    entries.update(behaviour="converges", limit={"pi": limit}, monotone_from=found.change + 1)
    return _Decision(entries, lambda: told() + facts.riccati_convergence(alpha, c, found))


def _riccati_at_zero(square: Scalar, pi: Scalar) -> _Decision:
    entries: dict[str, Any] = dict(region="alpha = 0")
    if pi == 1 or square == 1:
        escape = 0 if pi == 1 else 1
        return _Decision({**entries, "behaviour": "escapes", "escape": escape}, lambda: facts.riccati_escape(escape, None))
    entries.update(behaviour="converges", never_escapes=True, limit={"pi": number_json(square)}, monotone_from=0,
                   period=1 if pi == square else None, rate=None if pi == square else "0")
    return _Decision(entries, lambda: facts.riccati_axis(square))
