# SPDX-License-Identifier: MIT
"""The functions run unchanged on rational functions and then prove identities."""

from __future__ import annotations

import pytest
from flint import fmpz_mpoly_ctx

from exactkf.theory import (
    act,
    ag_from_alpha_gamma,
    alpha_gamma_from_ag,
    from_kimura_georgiou,
    is_symplectic,
    observer_form,
    posterior_covariance,
    projective_invariants,
    pseudo_polynomial,
    pseudo_polynomial_from_parameters,
    riccati_step,
    step_ag,
    step_alpha_gamma,
    symplectic_matrix,
    to_kimura_georgiou,
)


class Quotient:
    """A rational function with integer coefficients, in lowest terms."""

    def __init__(self, top, bottom):
        if bottom == 0:
            raise ZeroDivisionError
        common = top.gcd(bottom)
        self.top, self.bottom = top // common, bottom // common

    def _lift(self, other):
        if isinstance(other, Quotient):
            return other
        context = self.top.context()
        return Quotient(context.constant(other), context.constant(1))

    def __add__(self, other):
        other = self._lift(other)
        return Quotient(self.top * other.bottom + other.top * self.bottom, self.bottom * other.bottom)

    def __mul__(self, other):
        other = self._lift(other)
        return Quotient(self.top * other.top, self.bottom * other.bottom)

    def __truediv__(self, other):
        other = self._lift(other)
        return Quotient(self.top * other.bottom, self.bottom * other.top)

    def __neg__(self):
        return Quotient(-self.top, self.bottom)

    def __sub__(self, other):
        return self + -self._lift(other)

    def __rsub__(self, other):
        return self._lift(other) - self

    def __rtruediv__(self, other):
        return self._lift(other) / self

    __radd__, __rmul__ = __add__, __mul__

    def __eq__(self, other):
        other = self._lift(other)
        return self.top * other.bottom == other.top * self.bottom

    __hash__ = None


def indeterminates(*names):
    """Return the named variables as rational functions."""
    ring = fmpz_mpoly_ctx.get(names, "degrevlex")
    return tuple(Quotient(x, ring.constant(1)) for x in ring.gens())


def parameters(n):
    """Return generic alpha and gamma of length `n`."""
    values = indeterminates(*(f"alpha{i}" for i in range(1, n + 1)), *(f"gamma{i}" for i in range(n)))
    return values[:n], values[n:]


@pytest.mark.parametrize("n", [1, 2, 3])
def test_kimura_georgiou_is_birational(n):
    """The inverse of the Kimura-Georgiou map is its inverse as a rational map."""
    point = parameters(n)
    assert to_kimura_georgiou(*from_kimura_georgiou(*point)) == point


@pytest.mark.parametrize("n", [1, 2])
def test_step_in_both_coordinates(n):
    """BLZ94 Theorem 4.3 for generic parameters, in both directions."""
    point = parameters(n)
    a, g = ag_from_alpha_gamma(*point)
    assert ag_from_alpha_gamma(*step_alpha_gamma(*point)) == step_ag(a, g)
    assert alpha_gamma_from_ag(*step_ag(a, g)) == step_alpha_gamma(*point)


@pytest.mark.parametrize("n", [1, 2, 3])
def test_invariants_are_rational_integrals(n):
    """The quotients kappa_i do not change in one generic step, in either expression for the pseudo-polynomial."""
    alpha, gamma = parameters(n)
    a, g = alpha, gamma
    before = pseudo_polynomial(a, [x + 2 * y for x, y in zip(a, g, strict=True)])
    new_a, new_g = step_ag(a, g)
    after = pseudo_polynomial(new_a, [x + 2 * y for x, y in zip(new_a, new_g, strict=True)])
    assert projective_invariants(before) == projective_invariants(after)
    assert pseudo_polynomial(*from_kimura_georgiou(alpha, gamma)) == pseudo_polynomial_from_parameters(alpha, gamma)


def test_symplectic_matrix_for_two_generic_states():
    """BLZ94 Proposition 6.4 for n = 2 and a generic symmetric P."""
    a1, a2, g1, g2, p, q, r = indeterminates("a1", "a2", "g1", "g2", "p", "q", "r")
    F, g, h = observer_form((a1, a2), (g1, g2))
    S = symplectic_matrix(F, g, h)
    P = ((p, q), (q, r))
    assert is_symplectic(S) and act(S, P) == riccati_step(F, g, h, P)


def test_posterior_covariance_for_two_generic_states():
    """D71 (1.28) for n = 2, one generic measurement and a generic symmetric P."""
    p, q, r, m1, m2, v = indeterminates("p", "q", "r", "m1", "m2", "v")
    P, M, V = ((p, q), (q, r)), ((m1, m2),), ((v,),)
    first = posterior_covariance(P, M, V)
    assert all(posterior_covariance(P, M, V, form) == first for form in "abcdef")
