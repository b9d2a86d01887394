# SPDX-License-Identifier: MIT
r"""What an answer says of the structure behind an orbit, checked: D, its zeros on the circle, S_m with its Jordan blocks and subspaces.

All is recomputed from the pair (Q, S) of the question but what is named here. Notation as in `exactkf.kernel.orbit_n` and `exactkf.kernel.orbit_sieve`.

Main statements
---------------
0. *Which D.*  d, kappa, the sign and the zeros on the circle are those of the pair (Q, S) itself; S_m, its blocks and its subspaces belong to the pair that
   is left when common factors are taken out, D in 2 and 3 to that pair.
1. *Zeros on the circle.*  If D is zero they are not listed.  Else, in x = z + 1/z, they are the zeros of D in [-2, 2], of half the multiplicity if x is
   2 or -2.  Numbers in increasing order, each a zero of the square-free factor of the multiplicity that is named with it, are all if there are as many as
   Sturm's theorem counts.
2. *Jordan blocks.*  If v, Sv, ..., S^{2m-1} v are independent and D(S) v = 0, then D is the characteristic polynomial of S, up to a factor, and there is
   one block for each of its zeros, as large as its multiplicity. Nothing else is used: independent is what interval elimination finds regular.
3. *Subspaces.*  Let D keep one sign on the circle, w be its stable factor, f one of w, w_* = z^m w(1/z)/w(0), and W = ker f_*(S), f_* = z^m f(1/z)/f(0);
   f = w gives the dominant, f = w_* the codominant subspace.  By 2, and since S is symplectic, W is of dimension m and its own complement:
   that of ker f_*(S) is Im f(S), contained in W because f f_* is proportional to D, and of dimension m.  W meets Im(0; I) in zero
   only, for the reason in `exactkf.kernel.orbit_n`, 1, so W = Im(I; P), P symmetric; S (I; P) = (I; P) L, where f_* is the characteristic polynomial
   of L.  The upper half says A'L = I - hu', u = Ph.  Hence det L = (1 - u_1)/det A, or r = 1 - u_1 = Q(0)/f(0); and the transpose of L^-1 = (I + hu'/r) A'
   is J - ph' with p = (q - Ju)/r, so p is what f has below its leading coefficient: u_{i+1} = q_i - r f_i for 0 < i < m.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.intervals import Interval, around, inverse, minus, solved, times
from exactkf.kernel.limits import within
from exactkf.kernel.numbers import divide, fraction, need, sign
from exactkf.kernel.orbit_n import exact_factor, factor_within, is_around, number, reduce_pair, same_number, spectral_polynomial, spectral_sign
from exactkf.kernel.orbit_sieve import symplectic
from exactkf.kernel.roots import chebyshev, count_circle, count_real, gcd_poly, squarefree, times_poly, value_at

__all__ = ["SIGNS", "check_cyclic", "check_structure", "subspace", "subspace_within"]

_MEMBERS = {"field", "order", "start", "gcd", "factor", "d", "kappa", "sign", "circle_zeros", "positive_real", "S", "jordan", "dominant", "codominant"}
#: the sign of D on the circle, in words
SIGNS = {"+": "positive", "0+": "nonnegative", "0": "zero", "-0": "nonpositive", "-": "negative", "+-": "indefinite"}


def check_structure(Q: list, S: list, field: AlgebraicField | None, said: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
    """Accept if the structure is that of a pair.

    Parameters
    ----------
    Q, S : lists of Fraction, or of Algebraic of the field
    field : AlgebraicField or None
        That of the numbers said.
    said : mapping
        As `exactkf.dynamics.structure.structure_json` writes it.
    evidence : mapping
        A vector `cyclic` of integers with the `bits` of the intervals of statement 2, and `factor`, the spectral factor as for a limit.
    """
    need(set(said) == _MEMBERS, "the structure does not have the members of one")
    reduced = reduce_pair(Q, S)
    m, D = len(reduced.Q) - 1, spectral_polynomial(reduced.Q, reduced.S)
    whole = spectral_polynomial(Q, S)
    d, shape = whole[len(Q) - 1:], spectral_sign(whole)

    def are(name: str, values: Sequence | None) -> None:
        mine = said[name]
        same = mine is None if values is None else len(mine) == len(values) and all(number(x, field) == y for x, y in zip(mine, values, strict=True))
        need(same, f"{name} is not as recomputed")

    for name, value in (("order", m), ("start", reduced.start)):
        need(type(said[name]) is int and said[name] == value, f"{name} is not as recomputed")
    are("gcd", gcd_poly(Q, S))
    are("factor", reduced.removed)
    are("d", d)
    are("kappa", [divide(2 * x, d[0]) for x in d[1:]] if d[0] != 0 else None)
    need(said["sign"] == SIGNS[shape], f"D is {SIGNS[shape]} on the circle")
    real = shape == "+" and count_circle(Q)[0] == len(Q) - 1
    need(said["positive_real"] is real, f"that the state is positive real is {real}")
    if shape == "0":
        need(said["circle_zeros"] is None, "D is zero everywhere on the circle")
    else:
        _zeros_on_circle(chebyshev(whole), said["circle_zeros"])
    if m == 0 or reduced.escape is not None:
        need(said["S"] is None and said["jordan"] == [] and said["dominant"] is said["codominant"] is None, "there is no S")
        return
    q, g = reduced.Q[-2::-1], reduced.S[-2::-1]
    rows = symplectic(q, g, divide(1, q[-1]))
    need([len(row) for row in said["S"]] == [2 * m] * 2 * m, "S is of another size")
    need(all(number(x, field) == y for mine, row in zip(said["S"], rows, strict=True) for x, y in zip(mine, row, strict=True)), "S is not as recomputed")
    need(all(set(block) == {"polynomial", "size"} for block in said["jordan"]), "a block is a polynomial with a size")
    _blocks(D, rows, [([number(x, field) for x in block["polynomial"]], block["size"]) for block in said["jordan"]], evidence)
    if spectral_sign(D) == "+-":
        need(said["dominant"] is said["codominant"] is None, "no subspace is dominant where D changes sign on the circle")
    else:
        _subspaces(q, D, said, evidence["factor"])


# ---------------------------------------------------------------------- the circle
def _zeros_on_circle(h: list, zeros: Sequence[Mapping[str, Any]]) -> None:
    """Statement 1; h is D in x = z + 1/z."""
    parts = squarefree(h) if len(h) > 1 else []
    places = []
    for zero in zeros:
        need(set(zero) == {"two_cos", "multiplicity"} and type(zero["multiplicity"]) is int, "a zero on the circle is a number with its multiplicity")
        x, k = zero["two_cos"], zero["multiplicity"]
        at_end = isinstance(x, str) and abs(fraction(x)) == 2
        found = [f for f, n in parts if n * (1 + at_end) == k]
        need(len(found) == 1, f"D has no zeros of multiplicity {k} like that")
        places.append(_place(found[0], x))
    need(all(a[1] <= b[0] and a != b for a, b in pairwise(places)), "the zeros on the circle are not in increasing order")
    count = sum(count_real(f, -2, 2) + (value_at(f, -2) == 0) for f, _ in parts)
    need(count == len(zeros), f"D has {count} zeros on the circle, a pair of conjugates counted once")


def _place(f: list, named: Any) -> tuple[Fraction, Fraction]:
    """An interval in which the number named is, and is a zero of f: itself, or without its ends."""
    if isinstance(named, str):
        x = fraction(named)
        need(abs(x) <= 2 and value_at(f, x) == 0, "a number is no zero of D on the circle")
        return x, x
    lo, hi = map(fraction, named["interval"])
    need(-2 <= lo < hi <= 2, "an interval leaves [-2, 2]")
    if set(named) == {"interval"}:
        need(sign(value_at(f, lo)) * sign(value_at(f, hi)) < 0, "an interval may not hold a zero of D")
        return lo, hi
    p = [fraction(c) for c in named["minpoly"]]
    need(set(named) == {"interval", "minpoly"} and _between(p, lo, hi) == 1, "an interval does not hold exactly one zero of its polynomial")
    need(_between(gcd_poly(f, [f[-1] * 0 + c for c in p]), lo, hi) == 1, "a number is no zero of D")
    return lo, hi


def _between(p: list, lo: Fraction, hi: Fraction) -> int:
    """Distinct zeros with lo < x < hi."""
    return count_real(p, lo, hi) - (value_at(p, hi) == 0) if len(p) > 1 else 0


# ---------------------------------------------------------------------- the symplectic matrix
def _blocks(D: list, rows: list[list], blocks: list[tuple[list, Any]], evidence: Mapping[str, Any]) -> None:
    """Statement 2."""
    distinct: list = [1]
    whole: list = [1]
    for f, size in blocks:
        need(type(size) is int and 0 < size < len(D) and len(f) > 1 and f[-1] == 1, "a block belongs to the zeros of a monic polynomial")
        distinct = times_poly(distinct, f)
        need(len(distinct) <= len(D), "there are more zeros than eigenvalues")
        for _ in range(size):
            whole = times_poly(whole, f)
    need(len(gcd_poly(distinct, [k * c for k, c in enumerate(distinct)][1:])) == 1, "the zeros of the polynomials of the blocks are not distinct")
    need(len(whole) == len(D) and all(x * D[-1] == y for x, y in zip(whole, D, strict=True)), "the polynomials of the blocks do not make D")
    check_cyclic(D, rows, evidence["cyclic"], evidence["bits"])


def check_cyclic(D: list, rows: list[list], v: Any, bits: Any) -> None:
    """Accept a vector for which statement 2 shows that D is the characteristic polynomial of the matrix, with one block for each zero."""
    need(len(v) == len(rows) and all(type(x) is int for x in v) and type(bits) is int and 0 < bits < 1 << 16, "the vector is not one of integers")
    images: list[list] = [[D[-1] * 0 + x for x in v]]
    for _ in rows:
        images.append([_dot(row, images[-1]) for row in rows])
    need(all(_dot(D, column) == 0 for column in zip(*images, strict=True)), "D(S) does not annihilate the vector")
    within(len(rows) ** 3 * bits, 10**8, "bits of an elimination")
    solved([[around(x, bits) for x in image] for image in images[:-1]], [[] for _ in rows], bits)


def _subspaces(q: list, D: list, said: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
    """Statement 3."""
    if "center" in evidence:
        w, bits = factor_within(D, evidence)
        for name in ("dominant", "codominant"):
            u = subspace_within(w, q, bits, name == "dominant")
            need(len(said[name]) == len(u) and all(is_around(x, y, bits) for x, y in zip(said[name], u, strict=True)), f"the {name} subspace is another")
        return
    exact = exact_factor(D, evidence)
    for name in ("dominant", "codominant"):
        u = subspace(exact, q, name == "dominant")
        need(len(said[name]) == len(u) and all(same_number(x, y) for x, y in zip(said[name], u, strict=True)), f"the {name} subspace is another")


def subspace(w: list, q: list, dominant: bool) -> list:
    """The vector u of statement 3 for the stable factor, from z^0 up, or for the other."""
    f = w if dominant else [divide(x, w[0]) for x in reversed(w)]
    r = divide(q[-1], f[0])
    return [1 - r, *(q_i - r * f_i for q_i, f_i in zip(q[:-1], f[-2:0:-1], strict=True))]


def subspace_within(w: list[Interval], q: list, bits: int, dominant: bool) -> list[Interval]:
    """Intervals around the same."""
    one = (1 << bits, 1 << bits)
    unit, near = inverse(w[0], bits), [around(x, bits) for x in q]
    f = w if dominant else [times(x, unit, bits) for x in reversed(w)]
    r = times(near[-1], unit if dominant else w[0], bits)
    return [minus(one, r), *(minus(q_i, times(r, f_i, bits)) for q_i, f_i in zip(near[:-1], f[-2:0:-1], strict=True))]


def _dot(x: Sequence, y: Sequence) -> Any:
    return sum((a * b for a, b in zip(x, y, strict=True)), 0 * x[0])
