# SPDX-License-Identifier: MIT
"""Random starts of order one, rational and algebraic, with the degenerate ones well represented."""

from __future__ import annotations

from flint import fmpq

from exactkf.exact import RealField, cyclotomic_real, sqrt_field

#: (alpha, gamma) on which something is zero, one, or on a line
DEGENERATE = [(fmpq(a), fmpq(g)) for a, g in [
    (0, 0), (0, 1), (0, -1), (0, 2), (0, fmpq(1, 2)), (1, 0), (-1, 0), (2, 0), (fmpq(-1, 2), 0), (1, 1), (-1, 1), (2, 1), (-2, -1),
    (fmpq(1, 2), 1), (3, 2), (-3, 2), (fmpq(1, 2), fmpq(1, 2)), (fmpq(-1, 2), fmpq(1, 2)), (fmpq(3, 4), fmpq(5, 4)),
    (fmpq(-3, 4), fmpq(5, 4)), (fmpq(3, 2), fmpq(1, 2)), (fmpq(4, 3), fmpq(1, 3)), (fmpq(-1, 3), fmpq(4, 3)),
    (fmpq(5, 2), 1), (fmpq(-5, 2), -1), (fmpq(-5, 3), fmpq(-7, 3)), (fmpq(5, 3), fmpq(7, 3)), (1, 2), (1, fmpq(1, 3)),
]]


def small(random, top=12, low=8):
    """A rational number of a few digits."""
    return fmpq(random.randint(-top, top), random.randint(1, low))


def nonzero(random):
    """The same, not zero."""
    return fmpq(random.choice([-1, 1]) * random.randint(1, 12), random.randint(1, 8))


def before(alpha, gamma, steps):
    """The state that many steps before, or None where there is none."""
    for _ in range(steps):
        if alpha == 0:
            return None
        gamma = -gamma / alpha
        alpha = alpha * (1 - gamma * gamma)
    return (alpha, gamma) if alpha != 0 else None


def on_hyperbola(c, u):
    """The second point of the line through (0, 1) of slope u on 1 + alpha^2 - gamma^2 = 2 c alpha, or None."""
    if u * u == 1:
        return None
    alpha = 2 * (c + u) / (1 - u * u)
    return alpha, 1 + u * alpha


def rational_start(random):
    """One of several kinds, by chance."""
    kind = random.randrange(10)
    if kind < 4:
        return small(random), small(random)
    if kind == 4:
        return fmpq(random.randint(-10**9, 10**9), random.randint(1, 10**9)), fmpq(random.randint(-10**9, 10**9), random.randint(1, 10**9))
    if kind == 5:  # a boundary line
        alpha = small(random)
        return alpha, random.choice([1, -1]) * (alpha - random.choice([1, -1]))
    if kind == 6:  # escapes
        return before(nonzero(random), fmpq(random.choice([1, -1])), random.randint(0, 9)) or random.choice(DEGENERATE)
    if kind == 7:  # nearly escapes
        return before(nonzero(random), 1 + fmpq(1, 10 ** random.randint(3, 30)), random.randint(0, 9)) or random.choice(DEGENERATE)
    if kind == 8:  # periodic, or a rotation close to it
        c = random.choice([fmpq(0), fmpq(1, 2), fmpq(-1, 2), fmpq(1, 2) + fmpq(1, 10 ** random.randint(3, 20)), fmpq(3, 5)])
        return on_hyperbola(c, small(random)) or random.choice(DEGENERATE)
    n = 10 ** random.randint(1, 6)  # near the parabolic case
    return random.choice([1, -1]) * (1 + fmpq(random.choice([1, -1]), n)), fmpq(random.randint(-3, 3), n * random.randint(1, n))


FIELDS = [sqrt_field(2), sqrt_field(3), sqrt_field(5), sqrt_field(7), RealField([-2, 0, 0, 1], (1, 2), "r"), RealField([1, -3, 0, 1], (0, 1), "s"),
          RealField([1, 0, -10, 0, 1], (3, 4), "w"), *(cyclotomic_real(n) for n in (5, 7, 8, 9, 11, 12, 15, 16, 20))]


def element(random, field):
    """A small element of a field, not zero."""
    while True:
        x = field([fmpq(random.randint(-3, 3), random.randint(1, 2)) for _ in range(min(field.degree, 3))])
        if x != 0:
            return x


def algebraic_start(random):
    """One of several kinds, by chance."""
    field = random.choice(FIELDS)
    kind = random.randrange(6)
    if kind < 2:
        return element(random, field), element(random, field)
    if kind == 2:
        return before(element(random, field), field(random.choice([1, -1])), random.randint(0, 5)) or (field.gen(), field(0))
    if kind == 3:  # a rational multiple of pi if the field is cyclotomic
        c = field.two_cos(random.randint(1, field.n)) / 2 if hasattr(field, "n") else field.gen() / 4
        return on_hyperbola(c, element(random, field)) or (field.gen(), field(1))
    if kind == 4:
        alpha = element(random, field)
        return alpha, random.choice([1, -1]) * (alpha - random.choice([1, -1]))
    return random.choice([(field(0), element(random, field)), (element(random, field), field(0)), (element(random, field), field(1))])
