# SPDX-License-Identifier: MIT
r"""The stable spectral factor of a pseudo-polynomial over Q, exactly.

If `D` keeps one sign on the unit circle there is one monic `w` without zeros outside the
closed disc such that `D` is a multiple of :math:`w(z) w(1/z)`.

Main definitions
----------------
``spectral_factor``   the coefficients of `w` in a real number field
``Factor``            the result
``factor_json``       the same for the checker

Main statements
---------------
Let `I` be the set of the zeros inside the circle of those irreducible factors of `D` that
have zeros both inside and outside.  The product :math:`\rho` of `I` has the least modulus among
the products of as many distinct zeros, and no other set reaches it.  So an automorphism that fixes
:math:`\rho` fixes `I`, and the coefficients of `w` lie in :math:`\mathbb{Q}(\rho)`.

Choice of algorithm
-------------------
With `L` the product of the leading coefficients, :math:`\beta = L\rho` is an algebraic integer.
The polynomial of all :math:`L \prod c`, with `c` any choice of one zero from each of as many reciprocal
pairs, has integer coefficients, read off balls; one irreducible factor vanishes at :math:`\beta`.  A
symmetric function :math:`s(I)` is :math:`\sum_c s(c) M(x)/(x - \beta_c)` over :math:`M'(x)` at
:math:`x = \beta`, again with integer numerators up to a power of `L`.  Whether the
result is right does not rest on this: :math:`w(z)w(1/z)` and the location of the zeros are checked.

References
----------
BLZ94 (5.4), (6.25), (7.1).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import combinations, product
from math import comb
from typing import Any, NamedTuple

from flint import acb, acb_poly, arb, fmpq, fmpq_poly, fmpz, fmpz_poly

from exactkf._errors import Unsupported
from exactkf.dynamics.exact_json import element_json, field_json
from exactkf.exact.balls import precision
from exactkf.exact.numberfield import RealField
from exactkf.exact.polynomials import count_roots
from exactkf.kernel.roots import times_poly

__all__ = ["Factor", "factor_json", "number_of_choices", "spectral_factor", "zeros"]

_BOUND = 1 << 15


class Factor(NamedTuple):
    """Coefficients of the stable factor from z^0 up, in Q (``field`` None) or in a real number field."""

    field: RealField | None
    coefficients: tuple[Any, ...]


def factor_json(factor: Factor) -> dict[str, Any]:
    """Return the factor in its field, for the checker."""
    return {"field": field_json(factor.field), "factor": [element_json(x) for x in factor.coefficients]}


def zeros(f: fmpz_poly) -> tuple[list[acb], list[acb], list[acb]]:
    """Return the distinct zeros of `f` inside, on and outside the unit circle, as balls at the precision in force.

    A ball that meets the circle is of a zero on it: there are as many as exact counting says.

    Raises
    ------
    Unsupported
        If the precision does not separate the zeros off the circle from it.
    """
    on = count_roots(_distinct(f)).on
    found: tuple[list[acb], list[acb], list[acb]] = ([], [], [])
    roots: Any = f.complex_roots()  # pairs of a ball and a multiplicity
    for z, _ in roots:
        modulus = z.abs_upper(), z.abs_lower()
        found[0 if modulus[0] < 1 else 2 if modulus[1] > 1 else 1].append(z)
    if len(found[1]) != on:
        raise Unsupported("the precision does not separate the zeros from the unit circle")
    return found


def _distinct(f: fmpz_poly) -> fmpz_poly:
    return f // f.gcd(f.derivative()) if f.degree() > 0 else f


def number_of_choices(D: Sequence[Any]) -> int:
    """Return a bound for the degree of the field of the coefficients; `spectral_factor` takes a time that grows with its square."""
    inside = pairs = 0
    for f, _ in fmpq_poly(list(D)).numer().factor()[1]:
        count = count_roots(f)
        if count.inside and count.outside:
            inside, pairs = inside + count.inside, pairs + count.inside + count.on // 2
    return comb(pairs, inside) << inside


def spectral_factor(D: Sequence[Any]) -> Factor:
    """Return the stable spectral factor.

    Parameters
    ----------
    D : sequence of rationals, length 2m + 1
        The coefficients of z^m D, which keeps one sign on the circle; the last one is not zero.

    Returns
    -------
    Factor

    Examples
    --------
    >>> spectral_factor([2, 5, 2]).coefficients
    (1/2, 1)
    """
    return _of(tuple(D))


@lru_cache(maxsize=16)
def _of(D: tuple[Any, ...]) -> Factor:
    """The same, kept: a limit and a structure want it one after the other."""
    factors = fmpq_poly(list(D)).numer().factor()[1]
    plain: list[tuple[fmpz_poly, int]] = []
    mixed: list[tuple[fmpz_poly, int]] = []
    for f, multiplicity in factors:
        count = count_roots(f)
        if count.inside and count.outside:
            mixed.append((f, multiplicity))
        elif count.on:
            plain.append((f, multiplicity // 2))
        elif count.inside:
            plain.append((f, multiplicity))
    w = fmpq_poly([1])
    for f, multiplicity in plain:
        w *= (fmpq_poly(f) / f.leading_coefficient()) ** multiplicity
    if not mixed:
        return Factor(None, tuple(w.coeffs()))
    bits, bound = 64, _BOUND + 8 * sum(f.height_bits() for f, _ in mixed)
    while True:
        try:
            with precision(bits):
                return _with_field(w, mixed)
        except Unsupported:
            if bits >= bound:
                raise
            bits *= 2


def _with_field(w: fmpq_poly, mixed: list[tuple[fmpz_poly, int]]) -> Factor:
    """Return the factor, `w` being the rational part of it, at the precision in force."""
    inside, pairs = [], []
    for number, (f, _) in enumerate(mixed):
        z_in, z_on, z_out = zeros(f)
        inside += [(number, z) for z in z_in]
        pairs += [(number, z) for z in z_in] + [(number, z) for z in z_on if z.imag > 0]
    # the partner of a zero z of f is 1/z, a zero of f or of its reversal
    partner = [_number_of_partner(mixed, number) for number, _ in pairs]
    lead = fmpz(1)
    for f, _ in mixed:
        lead *= f.leading_coefficient()
    choices, betas = [], []
    for chosen in combinations(range(len(pairs)), len(inside)):
        for flips in product((False, True), repeat=len(inside)):
            choice = [(partner[i], 1 / pairs[i][1]) if flip else pairs[i] for i, flip in zip(chosen, flips, strict=True)]
            beta = acb(lead)
            for _, z in choice:
                beta *= z
            choices.append(choice)
            betas.append(beta)
    M = _factor_at(_rounded(acb_poly.from_roots(betas)), betas[0])
    orbit = [i for i, beta in enumerate(betas) if M(beta).contains(0)]
    if len(orbit) != M.degree():
        raise Unsupported("the precision does not separate the conjugates")
    theta: Any
    if M.degree() == 1:
        field, theta = None, fmpq(-M[0], M[1])
    else:
        field = RealField(fmpq_poly(M), _ends(betas[0].real), "beta")
        theta = field.gen()
    quotients = [acb_poly(fmpz_poly(M)) // acb_poly([-betas[i], 1]) for i in orbit]
    slope = fmpq_poly(M.derivative())(theta) if field is None else field(fmpq_poly(M.derivative()))
    result = [field(c) if field else c for c in w.coeffs()]
    for number, (f, multiplicity) in enumerate(mixed):
        half = _half(choices, orbit, quotients, number, f.leading_coefficient(), slope, theta, field)
        for _ in range(multiplicity):
            result = times_poly(result, half)
        circle = _circle_part(f, half)
        for _ in range(multiplicity // 2 if len(circle) > 1 else 0):
            result = times_poly(result, circle)
    return Factor(field, tuple(result))


def _number_of_partner(mixed: list[tuple[fmpz_poly, int]], number: int) -> int:
    f = mixed[number][0]
    reverse = fmpz_poly(f.coeffs()[::-1])
    return next(i for i, (other, _) in enumerate(mixed) if other in (reverse, -reverse))


def _rounded(f: acb_poly) -> fmpz_poly:
    """Return the only polynomial with integer coefficients in the balls."""
    found = []
    for c in f.coeffs():
        value = c.real.unique_fmpz()
        if value is None or not c.imag.contains(0):
            raise Unsupported("the precision does not determine an integer")
        found.append(value)
    return fmpz_poly(found)


def _factor_at(f: fmpz_poly, x: acb) -> fmpz_poly:
    """Return the irreducible factor that vanishes in the ball."""
    vanishing = [p for p, _ in f.factor()[1] if p(x).contains(0)]
    if len(vanishing) != 1:
        raise Unsupported("the precision does not separate the factors")
    return vanishing[0]


def _ends(x: arb) -> tuple[fmpq, fmpq]:
    return x.mid().fmpq() - x.rad().fmpq(), x.mid().fmpq() + x.rad().fmpq()


def _half(choices: list, orbit: list[int], quotients: list[acb_poly], number: int, lead: fmpz, slope: Any, theta: Any, field: RealField | None) -> list:
    """Return the monic polynomial of the zeros inside of one factor, in the field."""
    polynomials = [acb_poly.from_roots([z for k, z in choices[i] if k == number]) for i in orbit]
    size = max(p.degree() for p in polynomials)
    if any(p.degree() != polynomials[0].degree() for p in polynomials):
        # choices may move zeros between a factor and its reversal; only the sets of true conjugates occur in the orbit
        raise Unsupported("the conjugates do not keep the numbers of zeros")
    coefficients = []
    for j in range(size + 1):
        total = acb_poly([0])
        for p, quotient in zip(polynomials, quotients, strict=True):
            total += quotient * (lead * p[j])
        numerator = fmpq_poly(_rounded(total)) / lead
        value = numerator(theta) if field is None else field(numerator)
        coefficients.append(value / slope)
    return coefficients


def _circle_part(f: fmpz_poly, half: list) -> list:
    """Return the monic part of `f` with the zeros on the circle, given the part inside."""
    rest = [x * fmpq(1, f.leading_coefficient()) + 0 * half[0] for x in fmpq_poly(f).coeffs()]
    if len(rest) <= 2 * len(half) - 1:
        return [half[-1]]
    divisor = times_poly(half, [x / half[0] for x in reversed(half)])
    out = []
    for _ in range(len(rest) - len(divisor) + 1):
        q = rest[-1]
        out.append(q)
        for i in range(len(divisor)):
            rest[len(rest) - len(divisor) + i] = rest[len(rest) - len(divisor) + i] - q * divisor[i]
        rest.pop()
    return out[::-1]
