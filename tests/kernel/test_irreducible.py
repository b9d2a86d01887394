# SPDX-License-Identifier: MIT
"""Polynomials that are irreducible: evidence is found for those of fields, and none is accepted for a product."""

from __future__ import annotations

import random
from fractions import Fraction
from math import gcd

import pytest
from flint import fmpz_poly, nmod_poly

from exactkf.dynamics.exact_json import field_json
from exactkf.dynamics.irreducible import irreducible_at
from exactkf.exact import RealField, cyclotomic_real, sqrt_field
from exactkf.exact.compositum import nth_root, together
from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.irreducible import are_within, check_irreducible, integral, leaves, possible_degrees
from exactkf.kernel.numbers import Undefined

CUBE = RealField([-2, 0, 0, 1], (1, 2)).gen()
QUINTIC = RealField([-1, -1, 0, 0, 0, 1], (1, 2)).gen()


def root(d):
    """A square root."""
    return sqrt_field(d).gen()


FIELDS = [together(values)[1] for values in (
    [root(2)], [root(2), root(3), root(5)], [root(2), root(3), root(5), root(7)], [cyclotomic_real(22).gen(), root(5)], [CUBE, root(5), root(3)],
    [cyclotomic_real(9).gen(), cyclotomic_real(11).gen()], [nth_root(2 + root(2)), cyclotomic_real(22).gen()], [QUINTIC, cyclotomic_real(14).gen()])]


def checked(field, evidence):
    """Whether the checker takes it."""
    made = AlgebraicField.of(field_json(field))
    check_irreducible(made, evidence)
    return made.irreducible


def test_each_kind_of_evidence_is_found_and_taken():
    """A value, a value with the degrees modulo primes, primes alone, and the polynomial of a cosine."""
    found = [irreducible_at(field) for field in FIELDS]
    kinds = {frozenset(x) if isinstance(x, dict) else frozenset({"n"}) for x in found}
    assert kinds == {frozenset(x) for x in ({"n"}, {"primes"}, {"cyclotomic"}, {"at", "radius", "primes"})}
    assert all(checked(field, evidence) for field, evidence in zip(FIELDS, found, strict=True))


@pytest.mark.parametrize("field", FIELDS, ids=str)
def test_broken_evidence_is_rejected(field):
    """Another value, a radius that is too small, composite numbers for primes, another order, missing or needless entries."""
    evidence = irreducible_at(field)
    whole = evidence if isinstance(evidence, dict) else {"at": evidence}
    wrong: list = [{}, None, "7", [7], {"primes": []}, {"radius": "9"}, {**whole, "at": 0}, {**whole, "more": 1}]
    wrong += [{"primes": x} for x in ([4], [1], ["3"])]
    wrong += [{"cyclotomic": n} for n in (1, 2, 5, 10**6, "9", True)] + [{"at": 10, "radius": "1"}, {"at": 10, "radius": "0"}, {"at": 10, "radius": "-20"}]
    if "radius" in whole:
        wrong += [{k: v for k, v in whole.items() if k != name} for name in ("at", "radius")] + [{**whole, "primes": [10**9 + 7]}]
    for some in wrong:
        made = AlgebraicField.of(field_json(field))
        with pytest.raises((Undefined, TypeError, ValueError)):
            check_irreducible(made, some)
        assert not made.irreducible


def product(rng):
    """A product of two square-free polynomials of small degree, with a real zero in an interval: as data of a field."""
    while True:
        factors = [[rng.randint(-4, 4) for _ in range(rng.randint(1, 3))] + [rng.choice((1, 1, 2, 3))] for _ in range(2)]
        F = fmpz_poly(factors[0]) * fmpz_poly(factors[1])
        if F.gcd(F.derivative()).degree() == 0 and F[0] != 0:
            real = [z.real for z, _ in F.complex_roots() if z.imag == 0]
            if real:
                middle = Fraction(str(real[0].mid().fmpq())).limit_denominator(10**6)
                ends = [str(middle - Fraction(1, 10**5)), str(middle + Fraction(1, 10**5))]
                return [[str(c) for c in F.coeffs()], *ends]


def test_a_product_is_never_accepted():
    """Not with any value near or far, any radius that is right, any primes or any order of a root of unity."""
    rng, primes = random.Random(4), [p for p in range(2, 60) if all(p % r for r in range(2, p))]
    for _ in range(120):
        try:
            made = AlgebraicField.of(product(rng))
        except Undefined:  # another zero near by
            continue
        F = integral(made.modulus)
        good = [p for p in primes if F[-1] % p]
        tries: list = [*range(1, 400, 7), *({"cyclotomic": n} for n in range(3, 30))]
        tries += [{"primes": rng.sample(good, 5)} for _ in range(5)]
        tries += [{"at": n, "radius": str(R), "primes": rng.sample(good, 3)} for n in range(-40, 40) for R in (Fraction(3, 2), 3, 7)]
        for some in tries:
            with pytest.raises(Undefined):
                check_irreducible(made, some)
        assert not made.irreducible


def test_degrees_and_bounds_are_those_of_factors_and_zeros():
    """Degrees modulo primes as `flint` finds them; the radius holds all zeros, and one a little larger than they are is accepted."""
    rng = random.Random(5)
    for _ in range(150):
        F = [rng.randint(-9, 9) for _ in range(rng.randint(1, 9))] + [rng.randint(1, 3)]
        if gcd(*F) > 1 or fmpz_poly(F).gcd(fmpz_poly(F).derivative()).degree() > 0:
            continue
        for p in (2, 3, 5, 7, 11, 101):
            factors = nmod_poly([c % p for c in F], p).factor()[1]
            sums = {0}
            for f, _ in factors:
                sums |= {s + f.degree() for s in sums}
            if F[-1] % p == 0 or any(k > 1 for _, k in factors):
                with pytest.raises(Undefined):
                    possible_degrees(F, [p])
            else:
                assert possible_degrees(F, [p]) == sorted(sums - {0})
        size = max(Fraction(str(abs(z).upper().fmpq())) for z, _ in fmpz_poly(F).complex_roots())
        for R in (size / 3, size * Fraction(99, 100), size * Fraction(4, 3) + Fraction(1, 10**6), Fraction(0), -2 * size - 1):
            assert are_within(F, R) == (R > size)


def test_small_factors_are_taken_out():
    """The rest times the factor is the value, and the factor is below the bound."""
    F = [-2, 0, 0, 1]
    for n in range(2, 60):
        for bound in (Fraction(1), Fraction(5, 2), Fraction(100)):
            rest, c = leaves(F, n, bound)
            assert rest * c == n**3 - 2 and (c == 1 or c < bound)
    with pytest.raises(Undefined):
        leaves([-8, 0, 0, 1], 2, Fraction(5))
