# SPDX-License-Identifier: MIT
"""Orbits of order one by stepping, exactly, and what they say about an answer; nothing here knows the theory behind the decision."""

from __future__ import annotations

from flint import fmpq, fmpq_poly, fmpz_poly


def filter_orbit(alpha, gamma, steps):
    """States up to `steps`, and the time of escape or None."""
    states = [(alpha, gamma)]
    for t in range(steps + 1):
        alpha, gamma = states[-1]
        rest = 1 - gamma * gamma
        if rest == 0:
            return states, t
        if t < steps:
            alpha = alpha / rest
            states.append((alpha, -gamma * alpha))
    return states, None


def riccati_orbit(alpha, gamma, pi, steps):
    """Values up to `steps`, and the time of escape or None: (4.7) as printed, with a = alpha - gamma."""
    a, values = alpha - gamma, [pi]
    for t in range(steps + 1):
        pi = values[-1]
        if 1 - pi == 0:
            return values, t
        if t < steps:
            values.append(a * a * pi + (gamma + a * pi) * (gamma + a * pi) / (1 - pi))
    return values, None


class Limit:
    """A number of an answer, compared with others exactly."""

    def __init__(self, data):
        if isinstance(data, str):
            p, _, q = data.partition("/")
            self.value = fmpq(int(p), int(q or 1))
            self.poly = fmpq_poly([-self.value, 1])
            self.lo = self.hi = self.value
        else:
            self.value = None
            self.poly = fmpq_poly(fmpz_poly([int(c) for c in data["minpoly"]])) if all("/" not in c for c in data["minpoly"]) else None
            self.lo, self.hi = (fmpq(*(int(v) for v in text.split("/"))) for text in data["interval"])
            assert (self.poly(self.lo) > 0) != (self.poly(self.hi) > 0)

    def side(self, x):
        """The sign of x less the limit."""
        if self.value is not None:
            return (x > self.value) - (x < self.value)
        if x <= self.lo or x >= self.hi:
            return 1 if x >= self.hi else -1
        at = x - x
        for c in reversed(self.poly.coeffs()):
            at = at * x + c
        return 0 if at == 0 else -1 if (at > 0) == (self.poly(self.lo) > 0) else 1


def region(alpha, gamma):
    """The region of BLM91, Fig. 2, without index; on boundaries the first that fits."""
    a, g = abs(alpha), abs(gamma)
    if a + g <= 1:
        return "I"
    if g >= 1 + a:
        return "II"
    if a >= 1 + g:
        return "III" if g > 1 else "IV"
    return "corridor"


def first_return(states):
    """The least p >= 1 with the start at time p, or None."""
    return next((p for p in range(1, len(states)) if states[p] == states[0]), None)


def agrees(answer, states, escape, steps):
    """Assert what both systems share: escape, first return, never both."""
    assert answer.never_escapes == (answer.escape is None)
    assert (answer.behaviour == "escapes") == (answer.escape is not None)
    if answer.escape is not None and answer.escape > steps:
        assert escape is None
    else:
        assert answer.escape == escape
    if answer.period is not None and answer.period <= len(states) - 1:
        assert first_return(states) == answer.period
    elif answer.escape is None:
        assert first_return(states) is None
    assert answer.behaviour != "periodic" or answer.period > 1
    assert (answer.behaviour == "dense") == (answer.torus_dimension == 1)


def approaches(values, limit, start, strictly=True):
    """The values move towards the limit from index `start` on, and not from an index before."""
    sides = [limit.side(x) for x in values]

    def step(t):
        """The move from t to t + 1 goes towards the limit and does not reach or pass it."""
        return sides[t] == sides[t + 1] != 0 and (values[t + 1] < values[t]) == (sides[t] > 0) and values[t + 1] != values[t]

    last = len(values) - 1
    good = all(step(t) for t in range(start, last))
    return good and (start == 0 or start > last or not step(start - 1))


def filter_agrees(answer, alpha, gamma, steps):
    """Assert that the answer about the filter is what stepping shows."""
    states, escape = filter_orbit(alpha, gamma, steps)
    agrees(answer, states, escape, steps)
    inside = next((t for t, (x, y) in enumerate(states) if abs(x) + abs(y) < 1), None)
    if answer.enters_positive_real is None or answer.enters_positive_real <= steps:
        assert answer.enters_positive_real == inside
    else:
        assert inside is None
    if alpha != 0:
        c = (1 + alpha * alpha - gamma * gamma) / (2 * alpha)
        assert all(x * c * 2 == 1 + x * x - y * y for x, y in states)
        assert (answer.behaviour in ("periodic", "dense")) <= (c * c < 1)
        assert answer.region.removeprefix("boundary of ").rstrip("+-") == region(alpha, gamma) or answer.region == "corridor" and c * c < 1
        assert ("boundary" in answer.region) == (c * c == 1)
        assert answer.region == "corridor" or answer.region.endswith("+" if c > 0 else "-")
    if answer.behaviour != "converges":
        assert answer.limit is answer.rate is answer.monotone_from is None
        return
    assert answer.limit["gamma"] == "0"
    limit = Limit(answer.limit["alpha"][0])
    if answer.period == 1 or alpha == 0:
        assert limit.side(states[-1][0]) == 0 and states[-1][1] == 0
        return
    assert fixed(limit, c)
    assert approaches([x for x, _ in states], limit, answer.monotone_from)
    sizes = [abs(y) for _, y in states]
    assert all(sizes[t + 1] < sizes[t] for t in range(answer.monotone_from, len(states) - 1))
    m, names = answer.monotone_from, [region(*s) for s in states]
    if names[0] in ("I", "II"):
        assert names == [names[0]] + ["I"] * (len(names) - 1)
    elif m < len(names):
        assert names == ["IV"] * (m - 1) + ["III", "II"] + ["I"] * (len(names) - m - 1)
    else:
        assert names == ["IV"] * len(names) or names == ["IV"] * (len(names) - 1) + ["III"]


def fixed(limit, c):
    """The limit is a fixed point of alpha -> 1/(2c - alpha), the one of modulus at most one."""
    inside = limit.side(c - c - 1) <= 0 <= limit.side(c - c + 1)
    if limit.value is not None:
        return limit.value * limit.value - 2 * c * limit.value + 1 == 0 and inside
    if isinstance(c, fmpq):
        return limit.poly % fmpq_poly([1, -2 * c, 1]) == 0 and inside
    return inside


def riccati_agrees(answer, alpha, gamma, pi, steps):
    """Assert that the answer about the Riccati equation is what stepping shows."""
    values, escape = riccati_orbit(alpha, gamma, pi, steps)
    agrees(answer, values, escape, steps)
    if answer.behaviour != "converges":
        assert answer.limit is answer.rate is answer.monotone_from is None
        return
    limit = Limit(answer.limit["pi"])
    if answer.period == 1 or alpha == 0:
        assert limit.side(values[-1]) == 0
        return
    assert approaches(values, limit, answer.monotone_from)
