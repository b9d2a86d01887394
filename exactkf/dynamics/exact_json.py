# SPDX-License-Identifier: MIT
r"""Exact real numbers as JSON, and as text.

Main definitions
----------------
``number_json``      a rational or algebraic number in JSON
``root_json``        a root of a quadratic polynomial over a field, in JSON
``isolated``         a root of a polynomial over Q, known by balls, in JSON
``field_json``       the field of some numbers, as certificates have it
``element_json``     a number as an element of that field
``number_words``, ``number_latex``   an element of a field as text
``polynomial_text``, ``polynomial_latex``   a polynomial over a field as text

Notation
--------
A rational number is the string ``"p/q"``.  An irrational one is ``{"minpoly": [c_0, ..., c_d],
"interval": [lo, hi]}``: the only root of its minimal polynomial in the open interval.  An element
of a field is ``"p/q"`` or the list of its coefficients from :math:`\theta^0` up.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import isqrt
from typing import Any

from flint import arb, fmpq, fmpq_mat, fmpq_poly

from exactkf.exact import RealField, RealNumber
from exactkf.exact.balls import ball, precision
from exactkf.exact.polynomials import count_real_roots
from exactkf.theory._scalars import Scalar

__all__ = ["element_json", "field_json", "field_of", "isolated", "number_json", "number_latex", "number_words", "polynomial_latex", "polynomial_text",
           "polynomial_words", "root_json", "square_root"]


def field_of(*scalars: Scalar) -> RealField | None:
    """Return the field of the first number that is not rational, or None."""
    return next((x.field for x in scalars if isinstance(x, RealNumber)), None)


def field_json(field: RealField | None) -> list[Any] | None:
    """Return ``[polynomial, lo, hi]``, or None for the rational numbers."""
    if field is None:
        return None
    return [[str(c) for c in field.minpoly.coeffs()], str(field.root.lo), str(field.root.hi)]


def element_json(x: Scalar) -> Any:
    """Return ``"p/q"`` or the list of coefficients."""
    return [str(c) for c in x.poly.coeffs()] if isinstance(x, RealNumber) and not x.is_rational() else str(_rational(x))


def number_json(x: Scalar) -> Any:
    """Return the JSON form of a number.

    Parameters
    ----------
    x : fmpq or RealNumber

    Examples
    --------
    >>> from exactkf.exact import sqrt_field
    >>> number_json(sqrt_field(2).gen())["minpoly"]
    ['-2', '0', '1']
    """
    if not isinstance(x, RealNumber) or x.is_rational():
        return str(_rational(x))
    return isolated(x.minimal_polynomial(), lambda bits: x.enclose(bits * 3 // 10))


def root_json(b: Scalar, q: Scalar, smaller: bool) -> Any:
    r"""Return the JSON form of a root of :math:`z^2 - 2bz + q`.

    Parameters
    ----------
    b, q : fmpq or RealNumber of one field
        With :math:`b^2 > q`.
    smaller : bool
        The smaller root, or the larger.

    Examples
    --------
    >>> root_json(fmpq(5, 4), fmpq(1), True)
    '1/2'
    """
    disc = b * b - q
    field = field_of(b, q)
    if field is None:
        r = square_root(disc)
        if r is not None:
            return str(b - r if smaller else b + r)
        p = fmpq_poly([q, -2 * b, 1]).numer()
        if q == 1 and smaller == (b > 0):  # of two roots z, 1/z the one of modulus less than one
            ends = (fmpq(0), fmpq(1)) if smaller else (fmpq(-1), fmpq(0))
        else:
            ends = (b - 1 - disc, b) if smaller else (b, b + 1 + disc)
        return {"minpoly": [str(c) for c in p.coeffs()], "interval": [str(e) for e in ends]}

    def enclosed(bits: int) -> arb:
        root, middle = (_enclosed(v, bits) for v in (disc, b))
        return middle - root.sqrt() if smaller else middle + root.sqrt()

    return isolated(_norm(field(b), field(q)), enclosed)


def square_root(x: fmpq) -> fmpq | None:
    """Return the rational square root of a nonnegative rational number, or None."""
    p, q = isqrt(int(x.p)), isqrt(int(x.q))
    return fmpq(p, q) if p * p == x.p and q * q == x.q else None


def _rational(x: Scalar) -> fmpq:
    return x.rational_value() if isinstance(x, RealNumber) else x


def _enclosed(x: Scalar, bits: int) -> arb:
    return x.enclose(bits * 3 // 10) if isinstance(x, RealNumber) else ball(x)


def _norm(b: RealNumber, q: RealNumber) -> fmpq_poly:
    """The polynomial over Q that the companion matrix of z^2 - 2bz + q has."""
    d = b.field.degree
    rows = [[fmpq(0)] * (2 * d) for _ in range(2 * d)]
    power = b.field(1)
    for k in range(d):
        rows[k][d + k] = fmpq(1)  # z
        for j in range(d):
            rows[d + k][j] = -(q * power).poly[j]
            rows[d + k][d + j] = (2 * b * power).poly[j]
        power = power * b.field.gen()
    return fmpq_mat(rows).charpoly()


def isolated(p: fmpq_poly, enclosed: Any, bits: int = 64) -> Any:
    """Return the root of `p` that the balls of growing accuracy ``enclosed(bits)`` hold, in JSON, from so many bits on."""
    factors = [f for f, _ in p.factor()[1]]
    while True:
        with precision(bits):
            around = enclosed(bits)
            mid, rad = around.mid().fmpq(), 2 * around.rad().fmpq()
            lo, hi = mid - rad, mid + rad
        found = [f for f in factors if count_real_roots(f, lo, hi)]
        if len(found) == 1 and count_real_roots(found[0], lo, hi) == 1:
            (f,) = found
            if f.degree() == 1:
                return str(-f[0] / f[1])
            return {"minpoly": [str(c) for c in f.numer().coeffs()], "interval": [str(lo), str(hi)]}
        bits *= 2


# ---------------------------------------------------------------------- text
def number_words(x: Scalar) -> str:
    """Return the number as text; theta is the generator of its field."""
    return str(_rational(x)) if not isinstance(x, RealNumber) or x.is_rational() else polynomial_words(x.poly, "theta")


def polynomial_words(p: fmpq_poly, name: str) -> str:
    """Return a polynomial as text, such as ``3/2*x^2 - x``."""
    text = re.sub(r"\+ \(-([0-9/]+)\)", r"- \1", p.str())
    return re.sub(r"^\((-[0-9/]+)\)", r"\1", text).replace("- 1*", "- ").replace("-1*", "-").replace("x", name)


def number_latex(x: Scalar) -> str:
    r"""Return the number in LaTeX; :math:`\vartheta` is the generator of its field, as :math:`\theta` is what `a` and `b` have in common."""
    terms = ""
    for k, c in reversed(list(enumerate(x.poly.coeffs() if isinstance(x, RealNumber) else [x]))):
        if c == 0:
            continue
        power = "" if k == 0 else r"\vartheta" if k == 1 else rf"\vartheta^{{{k}}}"
        size = str(abs(c)) if c.q == 1 else rf"\frac{{{abs(c.p)}}}{{{c.q}}}"
        sign = "-" if c < 0 else "+" if terms else ""
        terms += sign + (power if power and size == "1" else size + power)
    return terms or "0"


def polynomial_latex(p: Sequence[Scalar], name: str = "z") -> str:
    r"""Return a polynomial over Q or a field in LaTeX, given from the constant up.

    Examples
    --------
    >>> polynomial_latex([fmpq(1), fmpq(-5, 2), fmpq(1)], "z")
    'z^{2}-\\frac{5}{2}z+1'
    """
    return _sum([(number_latex(c), "" if k == 0 else name if k == 1 else f"{name}^{{{k}}}") for k, c in enumerate(p)], "", ("+", "-"))


def polynomial_text(p: Sequence[Scalar], name: str = "z") -> str:
    """Return a polynomial over Q or a field as text, given from the constant up.

    Examples
    --------
    >>> polynomial_text([fmpq(1), fmpq(-5, 2), fmpq(1)], "z")
    'z^2 - 5/2*z + 1'
    """
    return _sum([(number_words(c), "" if k == 0 else name if k == 1 else f"{name}^{k}") for k, c in enumerate(p)], "*", (" + ", " - "))


def _sum(terms: list[tuple[str, str]], times: str, signs: tuple[str, str]) -> str:
    """The terms with coefficients that are not zero, highest power first."""
    out = ""
    for number, power in reversed(terms):
        if number == "0":
            continue
        negative = number.startswith("-")
        if re.search(r".[+-]| [+-] ", number):
            negative, number = False, f"({number})"
        size = number[1:] if negative else number
        apart = times or " " * size[-1].isalpha()  # no longer name of a command
        size = power if power and size == "1" else size + apart * bool(power) + power
        out += (signs[negative] if out else "-" * negative) + size
    return out or "0"
