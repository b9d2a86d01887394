# SPDX-License-Identifier: MIT
"""Relations among numbers on the circle: those that hold are accepted, and nothing else is."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from flint import acb, arb, fmpq, fmpz_mat, fmpz_poly

from exactkf.dynamics.torus import torus_evidence
from exactkf.exact.balls import precision
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.orbit_wandering import check_torus
from exactkf.kernel.rotation import least_height
from exactkf.kernel.torus import CircleNumbers, angle, bound_of_relations, check_independent, is_relation
from tests.dynamics.test_every_order import times

#: x = l + 1/l of l = (3 + 4i)/5, (5 + 12i)/13, the inverse of their product, (8 + 15i)/17, (20 + 21i)/29, l^2 of the first
RATIONAL = {"5": fmpq(6, 5), "13": fmpq(10, 13), "product": fmpq(-66, 65), "17": fmpq(16, 17), "29": fmpq(40, 29), "square": fmpq(-14, 25)}


def polynomial(*values):
    """The product of z^2 - xz + 1, as fractions."""
    out = [fmpq(1)]
    for x in values:
        out = times(out, [fmpq(1), -x, fmpq(1)])
    return [Fraction(int(c.p), int(c.q)) for c in out]


def numbers(*values):
    """The numbers with these x, in increasing order, in narrow intervals."""
    width = fmpq(1, 10**40)
    return CircleNumbers.of(polynomial(*values), [[str(x - width), str(x + width)] for x in sorted(values)])


@pytest.mark.parametrize(("names", "dimension"), [
    (("5", "square"), 1), (("5", "13"), 2), (("5", "13", "product"), 2), (("5", "13", "17"), 3), (("5", "13", "17", "29"), 4),
    (("5", "square", "13", "product"), 2), (("5", "square", "17", "29"), 3), (("5",), 1),
])
def test_the_dimension_is_the_number_of_gaussian_primes(names, dimension):
    """Numbers a/b of the Gaussian field have the rank of their prime ideals; any other dimension is rejected."""
    D = polynomial(*(RATIONAL[n] for n in names))
    found, evidence, reason = torus_evidence(D)
    assert (found, reason) == (dimension, "")
    check_torus(D, dimension, evidence)
    for other in {dimension - 1, dimension + 1, 0}:
        with pytest.raises(Undefined):
            check_torus(D, other, evidence)


@pytest.mark.parametrize("seed", range(6))
def test_irreducible_polynomials(seed):
    """The evidence for random reciprocal polynomials of degree 6 and 8 is accepted, for the dimension found only."""
    rng = random.Random(seed)
    half = [rng.randint(2, 9)] + [rng.randint(-4, 4) for _ in range(rng.choice((3, 4)))]
    D = [Fraction(c) for c in [*half, *half[-2::-1]]]
    found, evidence, _ = torus_evidence(D)
    check_torus(D, found, evidence)
    with pytest.raises(Undefined):
        check_torus(D, found + 1, evidence)


def test_a_relation_that_nearly_holds_does_not():
    """The square of l with x changed by 10^-30 is not related to l by (2, -1), though the angles agree to 30 digits."""
    x = fmpq(6, 5)
    good, near = numbers(x, x * x - 2), numbers(x, x * x - 2 + fmpq(1, 10**30))
    assert is_relation(good, [0, 1], [-1, 2]) and not is_relation(near, [0, 1], [-1, 2])
    assert not is_relation(good, [0, 1], [1, 2]) and not is_relation(good, [0, 1], [-1, 3]) and not is_relation(good, [0], [7])


def test_roots_of_unity_in_relations():
    """l and -l: the second powers agree, the first do not."""
    both = numbers(fmpq(6, 5), fmpq(-6, 5))  # -1/l comes first
    assert is_relation(both, [0, 1], [2, 2]) and not is_relation(both, [0, 1], [1, 1])


def test_angles_are_those_of_the_balls():
    """The binary digits agree with arb's argument."""
    three = numbers(*(RATIONAL[n] for n in ("5", "13", "29")))
    for i, x in enumerate(sorted(RATIONAL[n] for n in ("5", "13", "29"))):
        with precision(900):
            turn = (acb(arb(x) / 2, (1 - arb(x) * arb(x) / 4).sqrt()).log().imag / (2 * arb.pi()) * arb(2) ** 700).floor().unique_fmpz()
        assert angle(three, i, 700) == turn


def lattice(nums, chosen, bits):
    """A reduced basis of the lattice of the angles."""
    s = len(chosen)
    rows = [[int(i == j) for j in range(s)] + [angle(nums, k, bits)] for i, k in enumerate(chosen)] + [[0] * s + [1 << bits]]
    return [[int(x) for x in row] for row in fmpz_mat(rows).lll().tolist()]


def test_dependent_numbers_are_never_independent():
    """However many bits are taken, the reduced basis of related numbers has a short vector, and is rejected."""
    related = numbers(RATIONAL["5"], RATIONAL["13"], RATIONAL["product"])
    for bits in (100, 400, 1600):
        with pytest.raises(Undefined, match="short vector"):
            check_independent(related, [0, 1, 2], bits, lattice(related, [0, 1, 2], bits))


def test_a_basis_is_checked():
    """Too few bits, a vector outside the lattice, vectors of a part of it, and vectors that are dependent are rejected."""
    free = numbers(RATIONAL["5"], RATIONAL["13"])
    bits = 3 * (bound_of_relations(free, 2).bit_length() + 8)
    basis = lattice(free, [0, 1], bits)
    check_independent(free, [0, 1], bits, basis)
    with pytest.raises(Undefined, match="short vector"):
        check_independent(free, [0, 1], 40, lattice(free, [0, 1], 40))
    moved = [basis[0][:-1] + [basis[0][-1] + 1], *basis[1:]]
    doubled = [[2 * x for x in basis[0]], *basis[1:]]
    for wrong, words in ((moved, "not in the lattice"), (doubled, "no basis"), ([basis[0], basis[0], basis[2]], "dependent"), (basis[:2], "square"),
                         ([[float(x) for x in row] for row in basis], "integer")):
        with pytest.raises(Undefined, match=words):
            check_independent(free, [0, 1], bits, wrong)


def test_intervals_are_checked():
    """Intervals without a zero, with two, that overlap or leave the circle are rejected."""
    f = polynomial(RATIONAL["5"], RATIONAL["17"])
    for zeros in ([["0", "1/2"]], [["0", "3/2"]], [["1", "13/10"], ["11/10", "13/10"]], [["1", "5/2"]], [["6/5", "6/5"]]):
        with pytest.raises(Undefined):
            CircleNumbers.of(f, zeros)
    with pytest.raises(Undefined, match="pairs"):
        CircleNumbers.of([Fraction(1), Fraction(0), Fraction(2)], [])


def test_evidence_of_the_torus_is_checked():
    """A relation left out, changed, or with exponent zero for the number it is about, and a root named twice are rejected."""
    D = polynomial(RATIONAL["5"], RATIONAL["13"], RATIONAL["product"])
    dimension, evidence, _ = torus_evidence(D)
    (index, exponents), = evidence["relations"]
    for relations in ([], [[index, [x + 1 for x in exponents]]], [[index, [0, 0, 0]]], [[index, [*exponents[:-1], 0]]], [[0, exponents]]):
        with pytest.raises(Undefined):
            check_torus(D, dimension, {**evidence, "relations": relations})
    free = evidence["independent"]
    for of in ([0, 0], [0, 5], [0]):
        with pytest.raises(Undefined):
            check_torus(D, dimension, {**evidence, "independent": {**free, "of": of}})
    with pytest.raises(Undefined):  # a factor left out
        check_torus(D, 1, {"factor": [str(c) for c in polynomial(RATIONAL["5"])]})


@pytest.mark.parametrize("coefficients", [
    [1, 1, 0, -1, -1, -1, -1, -1, 0, 1, 1], [1, -1, -1], [1, 0, -1, -1], [2, -3, 2], [1, -3, 1], [1, 0, 0, -1, -1, -1, 0, 0, 1], [3, -1],
])
def test_heights_are_above_the_least(coefficients):
    """Lehmer's number, the smallest Pisot and other numbers of small height: log M / d to base 2 is at least 1/N; N grows like d squared."""
    degree = len(coefficients) - 1
    with precision(128):
        measure = arb(abs(coefficients[0]))
        roots = fmpz_poly(coefficients[::-1]).complex_roots()
        for z, multiplicity in roots:
            assert multiplicity == 1
            measure *= abs(z) if abs(z) > 1 else 1
        height = measure.log() / arb(2).log() / degree
    N = least_height(degree)
    assert height * N > 1
    assert N < 8 * degree * (4 * degree + 30 * degree.bit_length())
