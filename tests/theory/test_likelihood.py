# SPDX-License-Identifier: MIT
"""Maximum-likelihood estimation against weighted least squares and the normal equations."""

import pytest
from flint import fmpq, fmpq_mat
from hypothesis import given
from hypothesis import strategies as st

from exactkf._errors import BadInput
from exactkf.theory import (
    error_covariance,
    estimable_part,
    estimate,
    full_rank_factors,
    is_estimable,
    likelihood_blocks,
    likelihood_matrix,
    negative_direction,
    symmetric_inverse,
)

from .strategies import invertible, mat, matrices, nonnegative, rationals, rows, vectors


@st.composite
def measurements(draw, singular=True):
    """Pairs H, R with H of full column rank and R nonnegative, positive definite unless `singular`."""
    p = draw(st.integers(1, 4))
    n = draw(st.integers(1, p))
    H = tuple(row[:n] for row in draw(invertible(p)))
    if singular:
        return H, draw(nonnegative(p))
    root = mat(draw(invertible(p)))
    return H, rows(root * root.transpose())


@given(measurements(), st.data())
def test_any_symmetric_inverse(measurement, data):
    """The identities of NWL92 Appendix A hold for every symmetric inverse, and T does not depend on it."""
    H, R = measurement
    Z = likelihood_matrix(H, R)
    size = len(Z)
    choice = data.draw(matrices(size, size))
    G = mat(symmetric_inverse(Z, choice))
    assert G.transpose() == G and mat(Z) * G * mat(Z) == mat(Z)
    W, U, T = (mat(block) for block in likelihood_blocks(H, R, choice))
    h, r = mat(H), mat(R)
    eye = fmpq_mat([[int(i == j) for j in range(len(H[0]))] for i in range(len(H[0]))])
    delta = r - r * W * r
    assert U.transpose() * h == eye and r * U + h * T == 0 * (r * U)
    assert h.transpose() * W * h == 0 * eye and r * W * h == 0 * h
    assert h * T * h.transpose() == -1 * delta and r * U * h.transpose() == delta
    assert mat(likelihood_blocks(H, R)[2]) == T
    assert error_covariance(H, R, choice) == rows(U.transpose() * r * U)
    y = h * fmpq_mat([[x] for x in data.draw(vectors(len(H[0])))]) + r * fmpq_mat(
        [[x] for x in data.draw(vectors(len(H)))]
    )
    y = [x for (x,) in y.tolist()]
    assert estimate(H, R, y, choice) == estimate(H, R, y)


@given(measurements(singular=False), st.data())
def test_regular_covariance_is_least_squares(measurement, data):
    """For positive definite R the estimate is (H^T R^-1 H)^-1 H^T R^-1 y (NWL92 (2.3), (2.4))."""
    H, R = measurement
    y = data.draw(vectors(len(H)))
    weight = mat(H).transpose() * mat(R).inv()
    P = (weight * mat(H)).inv()
    assert mat(error_covariance(H, R)) == P
    assert estimate(H, R, y) == tuple(x for (x,) in (P * weight * fmpq_mat([[v] for v in y])).tolist())


@given(measurements(), st.data())
def test_minimal_variance(measurement, data):
    """No other unbiased linear estimate has a smaller covariance (Gauss-Markov)."""
    H, R = measurement
    U = mat(likelihood_blocks(H, R)[1])
    other = data.draw(matrices(len(H), len(H[0])))
    # Subtract the part that would make the estimate biased: L^T H = I.
    change = mat(other) - mat(H) * (mat(H).transpose() * mat(H)).inv() * (mat(H).transpose() * mat(other))
    L = U + change
    gap = L.transpose() * mat(R) * L - U.transpose() * mat(R) * U
    assert negative_direction(rows(gap)) is None


@given(st.integers(1, 4).flatmap(lambda p: st.integers(1, 4).flatmap(lambda n: matrices(p, n))), st.data())
def test_estimable_combinations(H, data):
    """Combinations of rows of H are estimable, and the full rank factors multiply to H."""
    weights = fmpq_mat([data.draw(vectors(len(H)))])
    assert is_estimable(H, (weights * mat(H)).tolist()[0])
    c = data.draw(vectors(len(H[0])))
    assert is_estimable(H, c) == (fmpq_mat([*map(list, H), list(c)]).rank() == mat(H).rank())
    if mat(H).rank():
        first, second = full_rank_factors(H)
        assert mat(first) * mat(second) == mat(H) and len(second) == mat(H).rank()


@given(st.data(), st.integers(2, 4))
def test_dependent_columns(data, p):
    """The estimable part can be read off any symmetric inverse of the singular matrix (NWL92 (2.26), (2.27))."""
    H1 = data.draw(matrices(p, 2).filter(lambda t: mat(t).rank() == 2))
    H = rows(mat(H1) * fmpq_mat([[1, 0, fmpq(1, 2)], [0, 1, -3]]))
    R = data.draw(nonnegative(p))
    y = [x for (x,) in (mat(R) * fmpq_mat([[v] for v in data.draw(vectors(p))])).tolist()]
    second, z, P = estimable_part(H, R, y)
    Z = likelihood_matrix(H, R)
    G = mat(symmetric_inverse(Z, data.draw(matrices(len(Z), len(Z))))).tolist()
    U, T = fmpq_mat([r[p:] for r in G[:p]]), fmpq_mat([r[p:] for r in G[p:]])
    assert mat(P) == -1 * mat(second) * T * mat(second).transpose()
    assert fmpq_mat([[x] for x in z]) == mat(second) * U.transpose() * fmpq_mat([[x] for x in y])


@given(rationals().filter(lambda m: m != 0))
def test_perfect_measurement(m):
    """A measurement without noise is believed."""
    assert estimate([[m], [1]], [[0, 0], [0, 1]], [2 * m, 5]) == (2,)
    assert error_covariance([[m], [1]], [[0, 0], [0, 1]]) == ((0,),)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: estimate([[1, 1]], [[1]], [1]), "H = ((1, 1),): has rank 1 < 2, so x is not estimable"),
        (lambda: likelihood_matrix([[1]], [[-1]]), "R = ((-1,),): not a covariance, x = (1) gives"),
        (lambda: likelihood_matrix([[1]], [[1, 0], [0, 1]]), "R = ((1, 0), (0, 1)): has shape (2, 2) where H asks for (1, 1)"),
        (lambda: full_rank_factors([[0]]), "H = ((0,),): zero"),
        (lambda: is_estimable([[1, 1]], [1]), "c = (1,): has length 1 where H asks for 2"),
        (lambda: symmetric_inverse([[0, 1], [0, 0]]), "Z = ((0, 1), (0, 0)): not symmetric"),
        (lambda: symmetric_inverse([[1]], [[1, 1]]), "choice = ((1, 1),): has shape (1, 2) where Z asks for (1, 1)"),
        (lambda: estimate([[1], [1]], [[1, 0], [0, 1]], [1]), "y = (1,): has length 1 where R asks for 2"),
    ],
)
def test_messages(call, text):
    """Every refusal names the argument in one line."""
    with pytest.raises(BadInput) as caught:
        call()
    assert str(caught.value).startswith(text) and "\n" not in str(caught.value)
