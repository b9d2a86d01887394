# SPDX-License-Identifier: MIT
"""The pseudo-polynomial and its invariance."""

import pytest
from flint import fmpq, fmpz_mpoly_ctx
from hypothesis import given
from hypothesis import strategies as st

from exactkf._errors import BadInput
from exactkf.theory import (
    difference_of_squares,
    from_kimura_georgiou,
    orbit,
    projective_invariants,
    pseudo_polynomial,
    pseudo_polynomial_from_parameters,
    pseudo_polynomial_from_q,
    scaling_factor,
    state_after,
    step_ag,
    step_numerators,
    symplectic_matrix_of,
)

from .strategies import pairs, parameters, rationals


def values(d, z):
    """Return D(z, 1/z)."""
    return sum((c * (z**i + z**-i) for i, c in enumerate(d) if i), d[0])


def evaluated(coefficients, z):
    """Return the value of a monic polynomial given by its lower coefficients."""
    result = fmpq(1)
    for c in coefficients:
        result = result * z + c
    return result


@given(pairs(), rationals().filter(lambda z: z != 0))
def test_definition_at_a_point(pair, z):
    """The coefficients give half of a(z) b(1/z) + a(1/z) b(z)."""
    a, b = pair
    product = evaluated(a, z) * evaluated(b, 1 / z) + evaluated(a, 1 / z) * evaluated(b, z)
    assert 2 * values(pseudo_polynomial(a, b), z) == product


@given(parameters(max_n=5))
def test_three_expressions_agree(point):
    """The recursion of BLZ94 Lemma 4.4 and the difference of squares give the same coefficients."""
    a, b = from_kimura_georgiou(*point)
    d = pseudo_polynomial(a, b)
    assert d == pseudo_polynomial_from_parameters(*point)
    q = [(x + y) / 2 for x, y in zip(a, b, strict=True)]
    q_star = [(y - x) / 2 for x, y in zip(a, b, strict=True)]
    assert d == pseudo_polynomial_from_q(q, q_star) and d[-1] == point[0][-1]


@given(pairs(), st.integers(0, 6))
def test_invariance_along_the_orbit(pair, steps):
    """The product of r_t and the pseudo-polynomial is constant, hence so are the quotients."""
    path = orbit(step_ag, pair, steps)
    start = [pseudo_polynomial(a, [x + 2 * y for x, y in zip(a, g, strict=True)]) for a, g in path.states]
    for t, d in enumerate(start):
        r = scaling_factor([state[1][0] for state in path.states[:t]])
        assert tuple(r * x for x in d) == start[0]
    if start[0][0] != 0:
        assert {projective_invariants(d) for d in start} == {projective_invariants(start[0])}


@pytest.mark.parametrize("n", range(1, 6))
def test_invariance_as_a_polynomial_identity(n):
    """One step without division multiplies the difference of squares by q_0^2 - (q_1^*)^2, for all q."""
    ring = fmpz_mpoly_ctx.get([f"q{i}" for i in range(n + 1)] + [f"s{i}" for i in range(1, n + 1)], "degrevlex")
    variables = ring.gens()
    Q, star = variables[: n + 1], variables[n + 1 :]
    factor = Q[0] * Q[0] - star[0] * star[0]
    assert difference_of_squares(*step_numerators(Q, star)) == tuple(factor * d for d in difference_of_squares(Q, star))


@given(pairs(max_n=3))
def test_characteristic_polynomial_of_the_symplectic_matrix(pair):
    """The characteristic polynomial of S is z^n D / alpha_n (BLZ94 (6.18))."""
    a, g = pair
    if a[-1] + g[-1] == 0:
        return
    d = pseudo_polynomial(a, [x + 2 * y for x, y in zip(a, g, strict=True)])
    coefficients = symplectic_matrix_of(a, g).charpoly().coeffs()
    assert [c * d[-1] for c in coefficients] == [*reversed(d), *d[1:]]


def test_invariants_far_ahead():
    """The invariants after 500 steps are those of the initial state."""
    a, g = (fmpq(1, 2), fmpq(1, 3)), (fmpq(1, 3), fmpq(1, 5))
    far = state_after(a, g, 500).state
    both = [
        projective_invariants(pseudo_polynomial(x, [u + 2 * v for u, v in zip(x, y, strict=True)]))
        for x, y in ((a, g), far)
    ]
    assert both[0] == both[1]


def test_vanishing_first_coefficient():
    """Quotients by d_0 = 0 are refused."""
    with pytest.raises(BadInput, match=r"^d\[0\] = 0: "):
        projective_invariants([0, 1])
