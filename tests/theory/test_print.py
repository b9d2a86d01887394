# SPDX-License-Identifier: MIT
"""Exact counterexamples to misprints, each next to the formula that is right."""

from flint import fmpq, fmpq_mat

from exactkf.theory import (
    act,
    duven_matrix,
    equilibria,
    from_kimura_georgiou,
    likelihood_blocks,
    pi_polynomials,
    posterior_covariance,
    pseudo_polynomial,
    rho_polynomials,
    riccati_step,
    second_kind_polynomials,
    symplectic_matrix_of,
    szego_polynomials,
)

from .strategies import mat

GAMMA = (fmpq(1, 2), fmpq(1, 3), fmpq(1, 5), fmpq(-1, 4))


def added(p, q):
    """Return the sum of two polynomials, highest power first."""
    n = max(len(p), len(q))
    p, q = (0,) * (n - len(p)) + tuple(p), (0,) * (n - len(q)) + tuple(q)
    return tuple(x + y for x, y in zip(p, q, strict=True))


def times(p, *q):
    """Return the product of two polynomials, highest power first."""
    result = [fmpq(0)] * (len(p) + len(q) - 1)
    for i, x in enumerate(p):
        for j, y in enumerate(q):
            result[i + j] += x * y
    return tuple(result)


def test_three_term_recursion_for_pi():
    """BLZ94 (4.12) gives the wrong pi_3; the corrected three-term recursion gives all pi_t."""
    pi = pi_polynomials(GAMMA)
    for t in (1, 2, 3):
        g, h = GAMMA[t], GAMMA[t - 1]
        printed = added(times(pi[t], 1, 1), times(pi[t - 1], g * h - 1, 0))
        right = added(times(pi[t], 1, g / h), times(pi[t - 1], g * h - g / h, 0))
        assert right == pi[t + 1] and (printed == pi[t + 1]) == (t == 1)
    # gamma = (1/2, 1/3, 0): the coefficient of z in pi_3 is gamma_2 gamma_0 = 0, in print gamma_1 gamma_0 = 1/6.
    assert pi_polynomials([fmpq(1, 2), fmpq(1, 3), 0])[3] == (1, fmpq(1, 6), 0, 0)


def test_shifted_szego_polynomial():
    """BLZ94 (A-8) must read (pi - z rho) / (z (1 - gamma_0)); for t = 0 the print gives z/2 instead of 1."""
    for t in range(3):
        shifted = szego_polynomials(GAMMA[1:])[t]
        difference = added(pi_polynomials(GAMMA)[t + 1], [-x for x in (*rho_polynomials(GAMMA)[t + 1][1:], 0)])
        assert difference == times([(1 - GAMMA[0]) * x for x in shifted], 1, 0)


def test_coefficients_of_the_shifted_polynomial():
    """BLZ94 (A-13) holds for k < t but not for k = t, where -gamma_t replaces gamma_t gamma_0."""
    pi, rho = pi_polynomials(GAMMA), rho_polynomials(GAMMA)

    def coefficient(p, t, k):
        return p[t][k] if 0 <= k <= t else fmpq(0)

    for t in (1, 2, 3):
        for k in range(1, t + 1):
            value = coefficient(pi, t, k) - coefficient(rho, t, k + 1)
            for j in range(1, k):
                value += GAMMA[t] * GAMMA[t - j] * (coefficient(pi, t - j, k - j) - coefficient(rho, t - j, k - j + 1))
            value = value / (1 - GAMMA[0]) + GAMMA[t] * GAMMA[t - k]
            truth = szego_polynomials(GAMMA[1:])[t][k]
            assert (value == truth) == (k < t)
            assert k < t or truth == -GAMMA[t]


def test_double_sum_for_the_pseudo_polynomial():
    """BLZ94 (A-15) pairs alpha_i alpha_j with sigma_{n-i,n-j}, not sigma_ij: for n = 1 it exchanges 1 and alpha."""
    alpha, gamma = fmpq(1, 5), fmpq(1, 2)
    d = pseudo_polynomial(*from_kimura_georgiou([alpha], [gamma]))
    r = 1 - gamma * gamma
    assert d[0] == r + alpha * alpha == fmpq(79, 100) and d[0] != 1 + alpha * alpha * r


def test_value_at_zero():
    """In the proof of BLZ94 Lemma 6.3 numerator and denominator of v(0) are exchanged."""
    alpha, gamma = fmpq(1, 5), fmpq(1, 2)
    (a,), (b,) = from_kimura_georgiou([alpha], [gamma])
    assert b / (2 * a) == -(gamma + alpha) / (gamma - alpha) / 2 == fmpq(-7, 6)
    assert -(gamma - alpha) / (gamma + alpha) / 2 == fmpq(-3, 14)


def test_first_coefficient_of_rho():
    """In the proof of BLZ94 Lemma 3.3, rho_tt is -phi_tt and not phi_tt."""
    rho, phi, psi = (f(GAMMA)[2][2] for f in (rho_polynomials, szego_polynomials, second_kind_polynomials))
    assert rho == psi == -phi == GAMMA[1]


def test_transposed_symplectic_matrix():
    """The matrix of BLZ94 (6.8a) acts as the Riccati equation with the printed transposition, not without."""
    S = symplectic_matrix_of([1], [2])
    assert act(S, [[5]]) == riccati_step([[-1]], [[2]], [[1]], [[5]])
    assert act(S.transpose(), [[5]]) != riccati_step([[-1]], [[2]], [[1]], [[5]])


def test_inverse_of_a_symplectic_matrix():
    """B93 prints M^{-1} = J M^* J; M = I shows that the sign is wrong."""
    J = fmpq_mat([[0, 1], [-1, 0]])
    M = fmpq_mat([[2, 3], [1, 2]])
    assert M.inv() == -1 * J * M.transpose() * J
    assert fmpq_mat([[-1, 0], [0, -1]]) == J * J


def test_sign_in_the_block_inverse():
    """NWL92 (A.7) must read R - RWR: for R = I, H = (1, 0)^T the print gives diag(1, 2) instead of diag(1, 0)."""
    H, R = [[1], [0]], [[1, 0], [0, 1]]
    W, _, T = (mat(block) for block in likelihood_blocks(H, R))
    h, r = mat(H), mat(R)
    assert -1 * h * T * h.transpose() == r - r * W * r == fmpq_mat([[1, 0], [0, 0]])
    assert r + r * W * r == fmpq_mat([[1, 0], [0, 2]])


def test_null_vector_of_an_undriven_mode():
    """In D71 Theorem 3.14 (b) the product n_d^* P_e is zero; the print has n_d^* P_e = n_d^*."""
    # Phi = 1/2 is undriven (H = 0); J = 2 leaves out the eigenvalue 1/2 of the mode.
    (found,) = (e for e in equilibria([[fmpq(1, 2)]], [[0]], [[1]], [[1]]).isolated if e.eigenvalues == (2,))
    assert found.P == ((0,),)


def test_middle_factor_of_g():
    """In D71 (3.98) the last factor must have I in its upper left corner for (3.99) to hold."""
    Phi, H, W = fmpq(2), fmpq(3), fmpq(5)
    R = mat(duven_matrix([[Phi]], [[H]], [[1]], [[1 / W]]))
    middle = fmpq_mat([[W, 0], [0, H / Phi**2]])
    outer = fmpq_mat([[1, W], [0, 1]])
    # (3.99) says that G is the part of the form F Gamma that one application of R adds.
    form = fmpq_mat([[0, fmpq(1, 2)], [fmpq(1, 2), 0]])
    added_form = R.transpose() * form * R - form
    assert outer * middle * outer.transpose() == added_form
    assert outer * middle * fmpq_mat([[0, 0], [W, 1]]) != added_form


def test_form_b_of_the_posterior_covariance():
    """D71 (1.28b) as scanned, P - P M K, does not even have fitting shapes for n = 2, m = 1; P - P M' K' is right."""
    P, M, V = [[2, 1], [1, 3]], [[1, 4]], [[1]]
    assert posterior_covariance(P, M, V, "b") == posterior_covariance(P, M, V, "d")
