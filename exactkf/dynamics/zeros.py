# SPDX-License-Identifier: MIT
"""Zeros of polynomials over Q or a real number field: in balls, and as roots of polynomials over Q.

Main definitions
----------------
``zero_balls``           the zeros of square-free factors, in balls
``norm``                 the polynomial over Q with the zeros of one over a field, and of its conjugates
``products_of_zeros``    the polynomial whose zeros are all products of two zeros
``factors``              monic factors with distinct zeros
``interval_json``        a ball in JSON
``circle_points``        2 cos of the angles of the zeros on the unit circle, with multiplicities

A polynomial is its list of coefficients from z^0 up.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any, NamedTuple

from flint import acb, acb_poly, arb, ctx, fmpq, fmpq_mat, fmpq_poly, fmpz

from exactkf._errors import Unsupported
from exactkf.dynamics.exact_json import isolated
from exactkf.exact.balls import precision
from exactkf.exact.numberfield import RealNumber
from exactkf.kernel.roots import chebyshev, count_real, divmod_poly, squarefree, value_at

__all__ = ["CirclePoint", "circle_points", "factors", "interval_json", "norm", "products_of_zeros", "zero_balls"]

_BOUND = 1 << 14
_DEGREE = 60  # up to which a norm is factored
_DIGITS = 50


class CirclePoint(NamedTuple):
    """2 cos(angle) of a zero as a number in JSON, and its multiplicity."""

    two_cos: Any
    multiplicity: int


def factors(D: Sequence[Any]) -> list[tuple[list[Any], int]]:
    """Monic factors with distinct zeros, and their multiplicities: irreducible over Q, square-free over a field."""
    if isinstance(D[-1], RealNumber):
        found = squarefree(list(D))
    else:
        found = [(list(fmpq_poly(f).coeffs()), k) for f, k in fmpq_poly(list(D)).numer().factor()[1]]
    return [([x / f[-1] for x in f], k) for f, k in found]


def zero_balls(f: Sequence[Any]) -> list[acb]:
    """Return disjoint balls around the zeros of a square-free polynomial, at about the precision in force.

    Raises
    ------
    Unsupported
        If that precision does not separate them.
    """
    if not isinstance(f[-1], RealNumber):
        roots: Any = fmpq_poly(list(f)).numer().complex_roots()
        return [z for z, _ in roots]
    try:
        return acb_poly([_ball(x) for x in f]).roots(tol=arb(2) ** -(ctx.prec // 3), maxprec=ctx.prec)
    except ValueError:
        raise Unsupported("the precision does not separate the zeros of a polynomial") from None


def _ball(x: Any) -> arb:
    return x.enclose(3 * ctx.prec // 10) if isinstance(x, RealNumber) else arb(fmpq(x))


def norm(f: Sequence[Any]) -> fmpq_poly:
    """Return a polynomial over Q that vanishes at the zeros of a monic polynomial; those of its conjugates over Q are the others."""
    if not isinstance(f[-1], RealNumber):
        return fmpq_poly(list(f))
    field, n = f[-1].field, len(f) - 1
    d = field.degree
    rows = [[fmpq(0)] * (n * d) for _ in range(n * d)]  # multiplication by z on polynomials over the field modulo f
    power = field(1)
    for k in range(d):
        for i in range(n - 1):
            rows[i * d + k][(i + 1) * d + k] = fmpq(1)
        for i, c in enumerate(f[:-1]):
            image = -(c * power)
            for j in range(d):
                rows[(n - 1) * d + k][i * d + j] = image.poly[j]
        power = power * field.gen()
    return fmpq_mat(rows).charpoly()


def products_of_zeros(p: fmpq_poly) -> fmpq_poly:
    """Return the polynomial with the zeros :math:`z_i z_j`, i <= j, of the zeros of `p`, by power sums.

    Examples
    --------
    >>> products_of_zeros(fmpq_poly([6, -5, 1])).roots()
    [(9, 1), (6, 1), (4, 1)]
    """
    n = p.degree()
    size = n * (n + 1) // 2
    e = [(-1) ** k * p[n - k] / p[n] for k in range(n + 1)]
    s = [fmpq(n)]
    for k in range(1, 2 * size + 1):
        total = sum(((-1) ** (i - 1) * e[i] * s[k - i] for i in range(1, min(k, n + 1))), fmpq(0))
        s.append(total + ((-1) ** (k - 1) * k * e[k] if k <= n else 0))
    sums = [(s[k] * s[k] + s[2 * k]) / 2 for k in range(size + 1)]
    out = [fmpq(1)]
    for k in range(1, size + 1):
        out.append(sum(((-1) ** (i - 1) * out[k - i] * sums[i] for i in range(1, k + 1)), fmpq(0)) / k)
    return fmpq_poly([(-1) ** (size - k) * out[size - k] for k in range(size + 1)])


def circle_points(D: Sequence[Any]) -> list[CirclePoint]:
    """Return 2 cos(angle) of the zeros on the unit circle of a palindromic polynomial, in increasing order, with multiplicities.

    Between -2 and 2 there are two zeros to each; at the ends one.

    Raises
    ------
    Unsupported
        If zeros are too close to each other to be separated.
    """
    for bits in (64, 256, 1024, 4096):
        found = _points(D, bits)
        if all(-2 <= lo and hi <= 2 for (lo, hi), *_ in found) and all(x[0][1] <= y[0][0] for x, y in pairwise(found)):
            return [CirclePoint(value, multiplicity) for _, value, multiplicity in found]
    raise Unsupported("zeros of D on the unit circle are too close to each other to be put in order")


def _points(D: Sequence[Any], bits: int) -> list[tuple[tuple[fmpq, fmpq], Any, int]]:
    """The same in the order of their intervals, with these."""
    found = []
    for f, multiplicity in factors(D):
        for root in (1, -1):
            if value_at(f, root) == 0:
                f = divmod_poly(f, [-root + 0 * f[-1], f[-1]])[0]
                found.append((str(2 * root), multiplicity))
        if len(f) > 2 and all(x == y for x, y in zip(f, f[::-1], strict=True)):
            found += [(value, multiplicity) for value in _between(chebyshev(f), bits)]
    return sorted(((_interval(value), value, multiplicity) for value, multiplicity in found), key=lambda entry: entry[0])


def _interval(value: Any) -> tuple[fmpq, fmpq]:
    """Where a number in JSON is."""
    lo, hi = (fmpq(*map(fmpz, x.split("/"))) for x in ((value, value) if isinstance(value, str) else value["interval"]))
    return lo, hi


def _between(h: list[Any], bits: int) -> list[Any]:
    """The real zeros between -2 and 2 of a square-free polynomial, which is not zero there, in JSON, from so many bits on."""
    number = count_real(h, -2, 2)
    if not number:
        return []
    over_q = norm([x / h[-1] for x in h])

    def exact(k: int) -> Any:
        if over_q.degree() > _DEGREE:
            return interval_json(_real_zeros(h, number, max(5 * _DIGITS, bits))[k])
        return isolated(over_q, lambda more: _real_zeros(h, number, more)[k], bits)

    return [exact(k) for k in range(number)]


def interval_json(x: arb) -> dict[str, Any]:
    """Return a ball in JSON."""
    mid, rad = x.mid().fmpq(), x.rad().fmpq()
    return {"interval": [str(mid - rad), str(mid + rad)]}


def _real_zeros(h: list[Any], number: int, bits: int) -> list[arb]:
    """So many zeros between -2 and 2, in increasing order: as many balls meet the interval, so each holds one of them."""
    while bits <= _BOUND:
        with precision(bits):
            try:
                meeting = [z.real for z in zero_balls(h) if z.imag.contains(0) and not abs(z.real) > 2]
            except Unsupported:
                meeting = []
        if len(meeting) == number:
            return sorted(meeting, key=lambda x: x.mid().fmpq())
        bits *= 2
    raise Unsupported("zeros of D on the unit circle could not be separated from others")
