# SPDX-License-Identifier: MIT
"""Polynomials in z and 1/z of low degree, for `exactkf.kernel.arithmetic`: equations of them, signs on the circle, a zero in the disc.

A quotient of polynomials in z and 1/z is a pair (N, D) of mappings of exponents to `Poly`. N/D = M/E says that NE - MD is zero, coefficient by coefficient,
as where the terms have values D and E are not zero.

c + d (z + 1/z) is c + 2d cos(theta) on |z| = 1, and takes the values between c - 2d and c + 2d: it is positive, or nonnegative, there if and only if
these two are. A term whose coefficients at z and 1/z are different has no sign on the circle, and the formula no value.

The characteristic polynomial of a matrix that is written out, of size two at most, is such a polynomial, and a matrix is stable as it is.

The zero -a/b of a + b z, b not 0, is in the open unit disc if and only if a^2 < b^2; a + b z has no zero for b = 0, a not 0.

Main definitions
----------------
`in_z`
    Whether z occurs in a term.
`equation`
    An equation of terms with z, or its negation.
`on_circle`
    A sign on the circle, or that the zeros are in the open disc.
`zeros_inside`
    How many zeros are in the open disc.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from typing import TYPE_CHECKING, Any

from exactkf.kernel.explicit_matrices import characteristic, entries
from exactkf.kernel.numbers import Unknown
from exactkf.kernel.polynomial_facts import ONE, Fact, Names, Poly, joined, number, plus, times

if TYPE_CHECKING:
    from exactkf.kernel.arithmetic import Facts

__all__ = ["ON_CIRCLE", "equation", "in_z", "on_circle", "zeros_inside"]

#: coefficients by exponents; those that are zero are left out
InZ = dict[int, Poly]
_LARGEST_EXPONENT = 50
ON_CIRCLE = {"pos_circle": ">", "nonneg_circle": ">=", "schur": ""}


def in_z(facts: Facts, tree: Any, names: Names) -> bool:
    """Whether z occurs in a term, in the definitions of its names too."""
    if not isinstance(tree, list) or not tree:
        return False
    if tree[0] in ("roots_in", *ON_CIRCLE):
        return False
    if tree[0] in ("z", "charpoly"):
        return True
    if tree[0] in ("sym", "at") and tree[1] not in names and tree[1] not in facts.circular and (d := facts.definitions.get(tree[1])) is not None and (
            d[0] == "let" and in_z(facts, d[3], {**facts.own(), **dict.fromkeys(d[2], ONE)})):
        return True
    return any(in_z(facts, x, names) for x in tree[1:])


def equation(facts: Facts, x: Any, y: Any, affirmed: bool, names: Names) -> Fact:
    """x = y, or that it is not so."""
    (n, d), (m, e) = (_fraction(facts, t, names) for t in (x, y))
    gap = _plus(_times(n, e), _times(m, d), -1)
    return joined("and" if affirmed else "or", [facts.relation("=" if affirmed else "!=", p) for p in gap.values()])


def on_circle(facts: Facts, tree: Any, affirmed: bool, names: Names) -> Fact:
    """``pos_circle``, ``nonneg_circle`` or ``schur`` of a term of degree one at most, or that it is not so."""
    matrix = tree[0] == "schur" and entries(facts, tree[1], names) is not None
    p = characteristic(facts, tree[1], names) if matrix else _polynomial(facts, tree[1], names)
    if tree[0] == "schur":
        (a, b), strict = _linear(p), "<" if affirmed else ">="
        if set(b) != {()}:
            raise Unknown("a polynomial whose leading coefficient may be zero")
        return facts.relation(strict, plus(times(a, a), times(b, b), -1))
    if set(p) - {-1, 0, 1} or p.get(1, {}) != p.get(-1, {}):
        raise Unknown("a sign on the circle of a term that is no c + d (z + 1/z)")
    relation = ON_CIRCLE[tree[0]] if affirmed else {">": "<=", ">=": "<"}[ON_CIRCLE[tree[0]]]
    return joined("and" if affirmed else "or", [facts.relation(relation, plus(p.get(0, {}), p.get(1, {}), c)) for c in (2, -2)])


def zeros_inside(facts: Facts, tree: Any, names: Names) -> list[tuple[tuple[Fact, ...], Poly]]:
    """The number of zeros of a + b z in the open unit disc, a a number that is not zero, with the condition for it."""
    a, b = _linear(_polynomial(facts, tree[1], names))
    if set(a) != {()}:
        raise Unknown("zeros of a polynomial that may be zero")
    gap = plus(times(a, a), times(b, b), -1)
    return [((facts.relation("<", gap),), ONE), ((facts.relation(">=", gap),), number(0))]


# ---------------------------------------------------------------------- polynomials in z and 1/z
def _linear(p: InZ) -> tuple[Poly, Poly]:
    if set(p) - {0, 1}:
        raise Unknown("the zeros of a polynomial that is not linear")
    return p.get(0, {}), p.get(1, {})


def _plus(x: InZ, y: InZ, c: Any = 1) -> InZ:
    out = {k: plus(x.get(k, {}), y.get(k, {}), c) for k in {*x, *y}}
    return {k: p for k, p in sorted(out.items()) if p}


def _times(x: InZ, y: InZ) -> InZ:
    out: InZ = {}
    for (k, p), (j, q) in product(x.items(), y.items()):
        out[k + j] = plus(out.get(k + j, {}), times(p, q))
    if any(abs(k) > _LARGEST_EXPONENT for k in out):
        raise Unknown("too high a power of z")
    return {k: p for k, p in sorted(out.items()) if p}


def _polynomial(facts: Facts, tree: Any, names: Names) -> InZ:
    """A term that divides by no more than a number and a power of z."""
    n, d = _fraction(facts, tree, names)
    if len(d) != 1 or set(next(iter(d.values()))) != {()}:
        raise Unknown("a quotient in z")
    ((k, p),) = d.items()
    return {j - k: plus({}, q, Fraction(1) / p[()]) for j, q in n.items()}


def _fraction(facts: Facts, tree: Any, names: Names) -> tuple[InZ, InZ]:
    """Numerator and denominator."""
    one: InZ = {0: ONE}
    if not in_z(facts, tree, names):
        p = facts.term(tree, names)
        return ({0: p} if p else {}), one
    op = tree[0]
    if op == "z":
        return {1: ONE}, one
    if op == "charpoly":
        return characteristic(facts, tree[1], names), one
    if op in ("sym", "at"):
        body, inner = facts.opened(tree, names)
        return _fraction(facts, body, inner)
    if op == "^" and type(tree[2]) is int and 0 <= tree[2] <= 8:
        n, d = _fraction(facts, tree[1], names)
        out = one, one
        for _ in range(tree[2]):
            out = _times(out[0], n), _times(out[1], d)
        return out
    if op not in ("+", "-", "*", "/", "neg", "recip"):
        raise Unknown(f"{op!r} of a term in z")
    (n, d), *rest = (_fraction(facts, x, names) for x in tree[1:])
    if op == "/" and not in_z(facts, tree[2], names):
        part = facts.quotient(ONE, facts.term(tree[2], names))
        return _times(n, {0: part}), d
    if op == "recip":
        return {-k: p for k, p in n.items()}, {-k: p for k, p in d.items()}
    if op == "neg":
        return _plus({}, n, -1), d
    for m, e in rest:
        if op == "*":
            n, d = _times(n, m), _times(d, e)
        elif op == "/":
            n, d = _times(n, e), _times(d, m)
        else:
            n, d = (_plus(n, m, 1 if op == "+" else -1), d) if e == d else (_plus(_times(n, e), _times(m, d), 1 if op == "+" else -1), _times(d, e))
    return n, d
