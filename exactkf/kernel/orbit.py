# SPDX-License-Identifier: MIT
r"""Checking the decision about an orbit of order one.

The statement of a certificate of kind ``orbit`` holds a question and an answer. The question has
``order``, ``system`` (``filter`` or ``riccati``), ``field`` (null, or polynomial, lo, hi of theta), ``alpha``, ``gamma``
(lists of one number) and, for a Riccati equation, ``pi``. A number is ``"p/q"`` or a list of coefficients in theta.
The checker decides the question anew and compares every entry of the answer; only the time of
the last change of signs is taken from the answer, and verified.

Notation
--------
Filter: alpha' = alpha/(1 - gamma^2), gamma' = -gamma alpha'. Riccati: pi' = ((alpha^2 - gamma^2) pi + gamma^2)/(1 - pi).
2 c = (1 + alpha^2 - gamma^2)/alpha, which is 2/kappa. The recursion y_{t+1} = 2 c y_t - y_{t-1}, y_1 = 1, starts
with y_0 = a: a = alpha of the filter, a = alpha/(1 - pi) of the Riccati equation.

Main statements
---------------
For alpha not 0. By induction alpha_t = y_t/y_{t+1} and gamma_t = (-1)^t gamma_0/y_{t+1}, as 1 - gamma_t^2 =
alpha_t (2c - alpha_t) is kept; and 1 - pi_t = alpha_0 y_{t+1}/y_t. So the filter escapes at the first t >= 0 with y_{t+2} = 0,
the Riccati equation at the first t >= 1 with y_{t+1} = 0, or at 0 if pi_0 = 1. The form a^2 - 2 c a + 1 is gamma_0^2 and
phi(pi_0)/(1 - pi_0)^2 respectively; it is 0 exactly at equilibria.

Let s be the sign of c and l the root of l^2 - 2 c l + 1 = 0 with |l| <= 1.

* |c| > 1, the form positive: y_t = A l^{-t} (1 - k l^{2t}), k > 0, so y_t s^t changes sign once if k > 1. Let m be the time with
  y_m y_{m+1} s < 0. Then s alpha_t exceeds 1 and grows for t < m, is negative at m, and grows to s l from then on. s a < 0 means m = 0; 0 < s a < 1 means
  that there is no m >= 0. The form negative: a is between the roots, no sign changes, and the orbit is monotone.
* |c| = 1: y_t = c^t (t + tau)/(1 + tau) with tau = a/(c - a), and the same holds, with m between -1 - tau and -tau.
* |c| < 1: the map turns the circle by the angle of -v, v + 1/v = 2 c (filter), or of v^2 (Riccati); the orbit
  has the order of that number as its period, or is dense.

References
----------
BLM91 (3.10), (3.13), (4.7), Theorems 3.5, 3.7, 4.1. Proofs: the header of exactkf/dynamics/order_one.py.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.numbers import Undefined, fraction, sign
from exactkf.kernel.roots import count_real, divmod_poly, value_at
from exactkf.kernel.rotation import coefficients, first_zero, modulus, order, sign_at, zero_bound

__all__ = ["check_order_one"]

_BLANK: dict[str, Any] = {
    "order": 1, "behaviour": "", "escape": None, "never_escapes": True, "limit": None, "rate": None, "monotone_from": None,
    "region": "", "period": None, "preperiod": None, "torus_dimension": None, "enters_positive_real": None,
}


def check_order_one(question: Mapping[str, Any], answer: Mapping[str, Any]) -> str:
    """'' if the answer is right in every entry, else the entry that is not."""
    system = question["system"]
    if set(question) != {"order", "system", "field", "alpha", "gamma"} | ({"pi"} if system == "riccati" else set()) or question["order"] != 1:
        return "the question is not one of order one"
    field = None if question["field"] is None else AlgebraicField.of(question["field"])
    (alpha,), (gamma,) = ([_read(x, field) for x in question[name]] for name in ("alpha", "gamma"))
    if system == "filter":
        found, limits, rate = _filter(alpha, gamma, answer, field)
    elif system == "riccati":
        found, limits, rate = _riccati(alpha, gamma, _read(question["pi"], field), answer, field)
    else:
        return "the question asks about an unknown system"
    if set(answer) != set(_BLANK):
        return "the answer does not have the entries of an answer"
    for name, value in found.items():
        if name not in ("limit", "rate") and json.dumps(answer[name]) != json.dumps(value):
            return f"{name} is not as decided"
    if not _are(answer["limit"], limits):
        return "limit is not as decided"
    if not (rate.is_named_by(answer["rate"]) if rate else answer["rate"] is None):
        return "rate is not as decided"
    return ""


def _read(data: Any, field: AlgebraicField | None) -> Any:
    if isinstance(data, str):
        return fraction(data)
    if field is None:
        raise Undefined("an algebraic number needs the field of the question")
    return field.element([fraction(c) for c in data])


def _are(data: Any, limits: Mapping[str, _Root] | None) -> bool:
    """The numbers named in the answer are the limits."""
    if limits is None or data is None:
        return limits is None and data is None
    flat = {k: v for k, v in data.items() if k != "alpha"}
    if "alpha" in data:
        (flat["alpha"],) = data["alpha"]
    return set(flat) == set(limits) and all(limits[k].is_named_by(flat[k]) for k in flat)


class _Root:
    """The smaller or larger root of z^2 - 2 b z + q over the field; they are real."""

    def __init__(self, b: Any, q: Any, smaller: bool) -> None:
        self.b, self.q, self.smaller = b, q, smaller

    def form(self, z: Any) -> Any:
        return z * z - 2 * self.b * z + self.q

    def is_named_by(self, data: Any) -> bool:
        """The number in JSON, ``"p/q"`` or a polynomial with an interval that holds one of its roots, is this root."""
        if isinstance(data, str):
            z = fraction(data)
            return self.form(z) == 0 and self._on_my_side(z)
        if not isinstance(data, dict) or set(data) != {"minpoly", "interval"}:
            return False
        p, (lo, hi) = [fraction(c) for c in data["minpoly"]], (fraction(x) for x in data["interval"])
        if not lo < hi or value_at(p, lo) == 0 or value_at(p, hi) == 0 or count_real(p, lo, hi) != 1:
            return False
        rest = divmod_poly(p, [self.q, -2 * self.b, Fraction(1)])[1]
        rest = [*rest, Fraction(0), Fraction(0)]
        if rest[1] == 0:
            return rest[0] == 0 and self._between(lo, hi)
        z = -rest[0] / rest[1]  # the only common root of p and the form
        return self.form(z) == 0 and self._on_my_side(z) and z > lo and z < hi

    def _on_my_side(self, z: Any) -> bool:
        return z <= self.b if self.smaller else z >= self.b

    def _between(self, lo: Fraction, hi: Fraction) -> bool:
        """lo < root < hi, for lo and hi that are not roots."""
        if self.smaller:
            return self.form(lo) > 0 and lo < self.b and (self.form(hi) < 0 or hi > self.b)
        return self.form(hi) > 0 and hi > self.b and (self.form(lo) < 0 or lo < self.b)


def _number(x: Any) -> _Root:
    """An element of the field itself."""
    return _Root(x, x * x, True)


_Decision = tuple[dict[str, Any], "dict[str, _Root] | None", "_Root | None"]


# ---------------------------------------------------------------------- the two systems
def _filter(alpha: Any, gamma: Any, answer: Mapping[str, Any], field: AlgebraicField | None) -> _Decision:
    inside = abs_(alpha) + abs_(gamma) < 1
    square = gamma * gamma
    if alpha == 0:
        return _filter_at_zero(gamma, inside)
    c = (1 + alpha * alpha - square) / (2 * alpha)
    if gamma == 0:
        size = sign(alpha * alpha - 1)
        region = {-1: "I", 0: "boundary of I", 1: "IV"}[size] + ("+" if alpha > 0 else "-")
        found = {**_BLANK, "behaviour": "converges", "monotone_from": 0, "period": 1, "region": region, "enters_positive_real": 0 if inside else None}
        return found, {"alpha": _number(alpha), "gamma": _number(Fraction(0))}, None
    if c * c < 1:
        return _turning(c, alpha, answer["escape"], field, "corridor", 2), None, None
    s = sign(c)
    outside = "III" if square > 1 else "IV"
    region = ("boundary of " if c * c == 1 else "") + ("II" if s * alpha < 0 else "I" if s * alpha < 1 else outside) + ("+" if s > 0 else "-")
    hint = answer["escape"] + 2 if answer["escape"] is not None else answer["monotone_from"]
    m, zero = _jump(c, alpha, hint, answer["escape"] is not None, field)
    if zero:
        return {**_BLANK, "behaviour": "escapes", "escape": m - 2, "never_escapes": False, "region": region}, None, None
    found = {**_BLANK, "behaviour": "converges", "monotone_from": max(m, 0), "region": region}
    if c * c == 1:
        return found, {"alpha": _number(Fraction(s)), "gamma": _number(Fraction(0))}, None
    found["enters_positive_real"] = max(m + 1, 0)
    return found, {"alpha": _Root(c, Fraction(1), s > 0), "gamma": _number(Fraction(0))}, _rate(c)


def _filter_at_zero(gamma: Any, inside: bool) -> _Decision:
    if gamma * gamma == 1:
        return {**_BLANK, "behaviour": "escapes", "escape": 0, "never_escapes": False, "region": "vertex"}, None, None
    found = {**_BLANK, "behaviour": "converges", "monotone_from": 0, "region": "I" if inside else "II", "enters_positive_real": 0 if inside else 1}
    if gamma == 0:
        found["period"] = 1
    zero = _number(Fraction(0))
    return found, {"alpha": zero, "gamma": zero}, None if gamma == 0 else zero


def _riccati(alpha: Any, gamma: Any, pi: Any, answer: Mapping[str, Any], field: AlgebraicField | None) -> _Decision:
    square = gamma * gamma
    if alpha == 0:
        return _riccati_at_zero(square, pi)
    c = (1 + alpha * alpha - square) / (2 * alpha)
    form = pi * pi - 2 * (1 - alpha * c) * pi + square
    region = "no equilibria" if c * c < 1 else {0: "equilibrium", 1: "outside the equilibria", -1: "between the equilibria"}[sign(form)]
    if pi == 1:
        return {**_BLANK, "behaviour": "escapes", "escape": 0, "never_escapes": False, "region": region}, None, None
    if form == 0:
        return {**_BLANK, "behaviour": "converges", "monotone_from": 0, "period": 1, "region": region}, {"pi": _number(pi)}, None
    a = alpha / (1 - pi)
    if c * c < 1:
        return _turning(c, a, answer["escape"], field, region, 1), None, None
    s = sign(c)
    m, zero = -1, False
    if form > 0:
        hint = answer["escape"] + 1 if answer["escape"] is not None else answer["monotone_from"] - 1
        m, zero = _jump(c, a, hint, answer["escape"] is not None, field)
    if zero:
        return {**_BLANK, "behaviour": "escapes", "escape": m - 1, "never_escapes": False, "region": region}, None, None
    # 1 - pi tends to alpha times the root of modulus at least 1
    limit = _number(1 - alpha * s) if c * c == 1 else _Root(1 - alpha * c, square, alpha * c > 0)
    return {**_BLANK, "behaviour": "converges", "monotone_from": m + 1, "region": region}, {"pi": limit}, None if c * c == 1 else _rate(c)


def _riccati_at_zero(square: Any, pi: Any) -> _Decision:
    found = {**_BLANK, "region": "alpha = 0"}
    if pi == 1 or square == 1:  # pi_1 is gamma^2
        return {**found, "behaviour": "escapes", "escape": 0 if pi == 1 else 1, "never_escapes": False}, None, None
    found = {**found, "behaviour": "converges", "monotone_from": 0, "period": 1 if pi == square else None}
    return found, {"pi": _number(square)}, None if pi == square else _number(Fraction(0))


def _rate(c: Any) -> _Root:
    """The square of the root of l^2 - 2 c l + 1 of modulus less than 1."""
    return _Root(2 * c * c - 1, Fraction(1), True)


def abs_(x: Any) -> Any:
    return -x if x < 0 else x


# ---------------------------------------------------------------------- the two kinds of maps
def _turning(c: Any, a: Any, escape: Any, field: AlgebraicField | None, region: str, sheets: int) -> dict[str, Any]:
    """|c| < 1. The filter moves on a curve that covers the line of a twice (``sheets``), the Riccati equation on the line."""
    period = order(-2 * c, field)
    halved = period if period is None or period % 2 else period // 2
    stop = zero_bound(coefficients(2 * c), coefficients(a), modulus(field)) if halved is None else halved
    if type(escape) is int:  # nothing beyond the time given need be looked at
        stop = min(stop, escape + sheets)
    zero = first_zero(2 * c, a, stop, field)
    if zero is not None:
        return {**_BLANK, "behaviour": "escapes", "escape": zero - sheets, "never_escapes": False, "region": region}
    if escape is not None:
        raise Undefined("the sequence does not vanish at the time given")
    if period is None:
        return {**_BLANK, "behaviour": "dense", "torus_dimension": 1, "region": region}
    return {**_BLANK, "behaviour": "periodic", "period": period if sheets == 2 else halved, "region": region}


def _jump(c: Any, a: Any, hint: Any, zero: bool, field: AlgebraicField | None) -> tuple[int, bool]:
    """|c| >= 1, the form positive: the m of the header, or -1; True if y_m = 0 instead."""
    s = sign(c)
    if s * a < 0:
        return 0, False
    if s * a < 1:
        return -1, False
    if type(hint) is not int or hint < 1:
        raise Undefined("the answer gives no time for the change of signs")
    if c * c == 1:
        tau = a / (s - a)
        if tau == -hint:
            return hint, True
        if not (-1 - tau < hint and hint < -tau):
            raise Undefined("the sign does not change at the time given")
        return hint, False
    bound = zero_bound(coefficients(2 * c), coefficients(a), modulus(field))
    found = first_zero(2 * c, a, min(bound, hint + 1), field)
    if found is not None or zero:
        if found != hint:
            raise Undefined("the sequence does not vanish at the time given")
        return hint, True
    if sign_at(2 * c, a, hint, field) * sign_at(2 * c, a, hint + 1, field) * s >= 0:
        raise Undefined("the sign does not change at the time given")
    return hint, False
