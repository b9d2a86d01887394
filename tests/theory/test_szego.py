# SPDX-License-Identifier: MIT
"""Szegö polynomials against the Toeplitz equations they solve."""

from fractions import Fraction

import pytest
from flint import fmpq, fmpq_mat, fmpz_mpoly_ctx
from hypothesis import given
from mpmath import mp, mpf

from exactkf._errors import BadInput
from exactkf.theory import (
    covariance_matrix,
    covariances,
    levinson,
    pi_polynomials,
    prediction_errors,
    reversed_polynomial,
    rho_polynomials,
    schur_parameters,
    second_kind_matrix,
    second_kind_polynomials,
    szego_matrix,
    szego_polynomials,
    toeplitz,
    toeplitz_determinants,
)

from .strategies import mat, schur_sequences


@given(schur_sequences())
def test_covariances_and_schur_parameters_are_inverse(gamma):
    """The two directions of Levinson's recursion are inverse to each other."""
    assert schur_parameters(covariances(gamma)) == gamma


@given(schur_sequences(min_size=1))
def test_polynomials_solve_the_normal_equations(gamma):
    """The coefficients solve the Toeplitz equations, found here by Gaussian elimination."""
    c = covariances(gamma)
    for t in range(1, len(gamma) + 1):
        errors = prediction_errors(gamma[:t])
        T = mat(toeplitz(c, t))
        right = fmpq_mat([[0]] * t + [[errors[t]]])
        solution = T.solve(right) if T.det() != 0 else None
        assert solution is not None
        assert tuple(x for (x,) in reversed(solution.tolist())) == szego_polynomials(gamma)[t]


@given(schur_sequences())
def test_determinants(gamma):
    """The determinant of T_t is the product of r_0, ..., r_t."""
    c = covariances(gamma)
    assert toeplitz_determinants(gamma) == tuple(mat(toeplitz(c, t)).det() for t in range(len(gamma) + 1))


@given(schur_sequences())
def test_second_kind_matrix_is_covariance_times_first_kind(gamma):
    """The matrices of BLZ94 (3.14) satisfy Psi = C Phi."""
    C = mat(covariance_matrix(covariances(gamma)))
    assert mat(second_kind_matrix(gamma)) == C * mat(szego_matrix(gamma))


@given(schur_sequences())
def test_half_sum_and_half_difference(gamma):
    """The polynomials pi and rho are half the sum and half the difference of psi and phi."""
    phi, psi = szego_polynomials(gamma), second_kind_polynomials(gamma)
    for p, r, f, s in zip(pi_polynomials(gamma), rho_polynomials(gamma), phi, psi, strict=True):
        assert [x + y for x, y in zip(p, r, strict=True)] == list(s)
        assert [x - y for x, y in zip(p, r, strict=True)] == list(f)


@given(schur_sequences(min_size=1))
def test_recursion_through_the_reversed_polynomial(gamma):
    """Each polynomial is z times the previous one minus gamma times its reversal."""
    polynomials = szego_polynomials(gamma)
    for value, old, new in zip(gamma, polynomials, polynomials[1:], strict=False):
        assert new[0] == 1 and new[-1] == -value
        assert all(
            new[k] == (old[k] if k < len(old) else 0) - value * (0, *reversed_polynomial(old))[k]
            for k in range(len(new))
        )


def test_last_schur_parameter_may_have_square_one():
    """The recursion accepts a final parameter of modulus one and stops at an earlier one."""
    assert schur_parameters([1]) == (1,)
    assert levinson([1, 1, 1]) == ((fmpq(1),), 0)
    with pytest.raises(BadInput, match=r"^c = .*: gamma\[0\]\^2 = 1, .* pass at most 1 covariances$"):
        schur_parameters([1, 1])


def test_other_scalar_types():
    """The same functions run on Fractions, polynomials and high-precision numbers."""
    exact = covariances([fmpq(1, 2), fmpq(1, 3), fmpq(-1, 5)])
    third = Fraction(1, 3)
    assert covariances([Fraction(1, 2), third, Fraction(-1, 5)]) == (Fraction(1, 2), Fraction(1, 2), Fraction(1, 5))
    assert covariances([fmpq(1, 2), third, Fraction(-1, 5)]) == exact == (fmpq(1, 2), fmpq(1, 2), fmpq(1, 5))
    ring = fmpz_mpoly_ctx.get(["x", "y"], "degrevlex")
    x, y = ring.gens()
    assert covariances([x, y]) == (x, y - x * x * y + x * x)
    with mp.workdps(50):
        values = schur_parameters([mpf(int(c.p)) / int(c.q) for c in exact])
        assert all(
            abs(v - mpf(p) / q) < mpf(10) ** -48 for v, (p, q) in zip(values, [(1, 2), (1, 3), (-1, 5)], strict=True)
        )


@pytest.mark.parametrize("bad", [[0.5], ["1/2"], [None], [True], 3, "ab"])
def test_inexact_input_is_refused(bad):
    """Floats, strings and the like are refused with a message of one line."""
    with pytest.raises(BadInput) as caught:
        schur_parameters(bad)
    assert "\n" not in str(caught.value) and str(caught.value).startswith("c")


@pytest.mark.parametrize("t", [-1, 3])
def test_toeplitz_index(t):
    """The index of a Toeplitz matrix must fit the number of covariances."""
    with pytest.raises(BadInput, match="pass an integer 0 <= t <= 2"):
        toeplitz([1, 2], t)
