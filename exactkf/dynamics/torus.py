# SPDX-License-Identifier: MIT
r"""The dimension of the torus that an orbit fills, with evidence for the checker.

Main definitions
----------------
``torus_evidence``  the dimension and the evidence

Main statements
---------------
The dimension is the largest number of multiplicatively independent zeros of `D` among those of odd multiplicity on the upper
half circle.  `exactkf.kernel.torus` gives a bound for the exponents of a relation: below it lattice reduction of
the angles finds a relation, or a basis without short vectors, which shows that there is none.  So the zeros
are taken one after the other, and the question is always decided, up to the size of the numbers.  With algebraic data the
zeros of `D` are zeros of its norm, a rational polynomial.

References
----------
BLZ94 Section 8.  A. K. Lenstra, H. W. Lenstra, L. Lovász, Math. Ann. 261 (1982).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from flint import arb, fmpq, fmpq_mat, fmpq_poly, fmpz, fmpz_mat, fmpz_poly

from exactkf._errors import Unsupported
from exactkf.exact.balls import precision
from exactkf.exact.numberfield import RealNumber
from exactkf.exact.polynomials import count_real_roots, count_roots, palindromic_to_x
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.roots import chebyshev, count_circle, count_real, squarefree, times_poly
from exactkf.kernel.torus import CircleNumbers, bound_of_relations, is_relation

__all__ = ["torus_evidence"]

_MOST_BITS = 1 << 14


def torus_evidence(D: Sequence[Any]) -> tuple[int | None, dict[str, Any], str]:
    """Return the dimension of the torus, evidence for the checker, and a reason if the dimension is not decided.

    Parameters
    ----------
    D : sequence of rationals, or of elements of one `RealField`, length 2m + 1
        The coefficients of z^m D.
    """
    try:
        if isinstance(D[0], RealNumber):
            f, k, zeros, evidence = _over_a_field(D)
        else:
            f, k = _wandering(fmpq_poly([fmpq(c.numerator, c.denominator) for c in D]).numer())
            evidence = {"factor": [str(c) for c in f.coeffs()]}
            zeros = _intervals(palindromic_to_x(f).numer()) if k > 1 else []
        if k <= 1:
            return k, evidence, ""
        numbers = CircleNumbers.of([Fraction(int(c)) for c in f.coeffs()], zeros)
        free, found = [0], {"of": [0], "bits": 1, "basis": []}
        relations: list[tuple[int, list[int]]] = []
        for i in range(1, k):
            chosen = [*free, i]
            exponents, more = _relation_or_basis(numbers, chosen)
            if exponents is None:
                free, found = chosen, more
            else:
                relations.append((i, exponents))
        # a zero left behind early has its relation with fewer zeros
        padded = [[i, [*e[:-1], *[0] * (len(free) + 1 - len(e)), e[-1]]] for i, e in relations]
    except (Undefined, Unsupported) as error:
        return None, {}, f"the wandering roots on the circle or the relations between them are too large for what is done here ({error})"
    return len(free), {**evidence, "zeros": zeros, "independent": found, "relations": padded}, ""


def _over_a_field(D: Sequence[Any]) -> tuple[fmpz_poly, int, list[list[str]], dict[str, Any]]:
    """The wandering factor of a rational multiple of D, the number of wandering zeros of D and their intervals, and evidence."""
    odd = [D[-1] / D[-1]]
    for factor, multiplicity in squarefree(list(D)):
        odd = times_poly(odd, factor) if multiplicity % 2 else odd
    if len(odd) == 1 or count_circle(odd)[1] == 0:
        return fmpz_poly([1]), 0, [], {}
    norm = _norm([x / odd[-1] for x in odd])
    whole = norm // norm.gcd(norm.derivative())
    f = fmpz_poly([1])
    for part, _ in whole.factor()[1]:
        if not part.is_cyclotomic():
            f *= part
    evidence = {"norm": [str(c) for c in whole.coeffs()]}
    in_x, mine = palindromic_to_x(whole).numer(), chebyshev(odd)
    wandering = palindromic_to_x(f).numer()
    zeros = []
    for lo, hi in _intervals(in_x):
        ends = fmpq(*map(fmpz, lo.split("/"))), fmpq(*map(fmpz, hi.split("/")))
        if (wandering(ends[0]) > 0) != (wandering(ends[1]) > 0) and count_real(mine, *ends) == 1:
            zeros.append([lo, hi])
    return f, len(zeros), zeros, evidence


def _norm(p: Sequence[RealNumber]) -> fmpz_poly:
    """The norm of a monic polynomial, as a primitive integer polynomial: interpolated from norms of its values."""
    field = p[0].field
    size = (len(p) - 1) * field.degree + 1
    values = []
    for z in range(size):
        value = field(0)
        for c in reversed(p):
            value = value * z + c
        rows, power = [], value.poly
        for _ in range(field.degree):
            rows.append([power[k] for k in range(field.degree)])
            power = power * fmpq_poly([0, 1]) % field.minpoly
        values.append([fmpq_mat(rows).det()])
    powers = fmpq_mat([[fmpq(z) ** k for k in range(size)] for z in range(size)])
    found = fmpq_poly([row[0] for row in powers.solve(fmpq_mat(values)).tolist()]).numer()
    return found // found.content()


def _wandering(D: fmpz_poly) -> tuple[fmpz_poly, int]:
    """The product of the irreducible factors with zeros that wander, and the number of pairs of these."""
    f, k = fmpz_poly([1]), 0
    for factor, multiplicity in D.factor()[1]:
        if multiplicity % 2 and factor.degree() > 1 and not factor.is_cyclotomic() and (on := count_roots(factor).on):
            f, k = f * factor, k + on // 2
    return f, k


def _intervals(in_x: fmpz_poly) -> list[list[str]]:
    """Isolating intervals of the zeros between -2 and 2, in increasing order."""
    k = count_real_roots(in_x, -2, 2)
    bits = 96
    while bits < _MOST_BITS:
        with precision(bits):
            roots: Any = in_x.complex_roots()
            found = sorted((z.real.mid().fmpq() for z, _ in roots if z.imag.contains(0) and abs(z.real) < 2))
        width = fmpq(1, 1 << bits // 2)
        apart = all(y - x > 4 * width for x, y in zip(found, found[1:], strict=False))
        if len(found) == k and apart and all(abs(x) + width < 2 and (in_x(x - width) > 0) != (in_x(x + width) > 0) for x in found):
            scale = 4 / width  # short ends
            return [[str((x * scale).floor() / scale - width / 2), str((x * scale).floor() / scale + width)] for x in found]
        bits *= 2
    raise Unsupported("zeros next to each other or to 1 or -1")


def _relation_or_basis(numbers: CircleNumbers, chosen: list[int]) -> tuple[list[int] | None, dict[str, Any]]:
    """Exponents of a relation between the chosen numbers, of which all but the last are independent, or a basis without short vectors."""
    s = len(chosen)
    bound = bound_of_relations(numbers, s)
    bits = (s + 1) * (bound.bit_length() + 8)
    while bits < _MOST_BITS:
        angles = _angles(numbers, chosen, bits)
        rows = [[int(i == j) for j in range(s)] + [a] for i, a in enumerate(angles)] + [[0] * s + [1 << bits]]
        reduced = [[int(x) for x in row] for row in fmpz_mat(rows).lll().tolist()]
        first = reduced[0]
        if sum(x * x for x in first) > s * (s + 1) * bound * bound << s + 2:
            return None, {"of": chosen, "bits": bits, "basis": reduced}
        if first[s - 1] and is_relation(numbers, chosen, first[:s]):
            return first[:s], {}
        bits *= 2
    raise Unsupported("the angles are too close to a relation")


def _angles(numbers: CircleNumbers, chosen: list[int], bits: int) -> list[int]:
    """floor(2^bits theta) of the chosen numbers."""
    more = bits + 64
    while True:
        with precision(more):
            found = [(_root(numbers, i, more) / 2).acos() / (2 * arb.pi()) * arb(2) ** bits for i in chosen]
            whole = [x.floor().unique_fmpz() for x in found]
        if None not in whole:
            return [int(x) for x in whole]  # type: ignore[arg-type]
        more *= 2


def _root(numbers: CircleNumbers, i: int, bits: int) -> arb:
    """A ball around the zero of f in x, by Newton's interval method."""
    lo, hi = (fmpq(x.numerator, x.denominator) for x in numbers.zeros[i])
    p = fmpz_poly(numbers.in_x)
    slope = p.derivative()
    x = arb(lo).union(arb(hi))
    while slope(x).contains(0) and (hi - lo) * 2**bits > 1:  # the interval is too wide for Newton's method, or the precision too low
        middle = (lo + hi) / 2
        lo, hi = (lo, middle) if (p(middle) > 0) != (p(lo) > 0) else (middle, hi)
        x = arb(lo).union(arb(hi))
    while x.rel_accuracy_bits() < bits - 32:
        mid = x.mid()
        narrowed = x.intersection(mid - p(mid) / slope(x))
        if not narrowed.rad() < x.rad():
            return x
        x = narrowed
    return x
