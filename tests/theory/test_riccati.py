# SPDX-License-Identifier: MIT
"""Riccati recursions, Duven's matrix and equilibria."""

import pytest
from flint import fmpq, fmpq_mat
from hypothesis import assume, given
from hypothesis import strategies as st
from mpmath import mp, mpf, sqrt

from exactkf._errors import BadInput, Unsupported
from exactkf.theory import (
    act,
    covariance_step,
    duven_matrix,
    equilibria,
    equilibrium_from_basis,
    filter_map,
    hamiltonian_matrix,
    is_symplectic,
    moebius,
    negative_direction,
    nonpositive_direction,
    observer_form,
    posterior_covariance,
    riccati_step,
    stabilizing_equilibrium,
    symplectic_matrix,
    symplectic_matrix_of,
)

from .strategies import invertible, mat, matrices, nonnegative, pairs, rationals, rows

FORMS = ("1.24", "a", "b", "c", "d", "e", "f")
EXAMPLE_3_1 = ([[2, -1], [0, fmpq(1, 2)]], [[4, 6], [6, 9]], [[-1, fmpq(2, 3)]], [[1]])
EXAMPLE_3_3 = ([[fmpq(3, 2), fmpq(-2, 3)], [0, fmpq(1, 2)]], [[4, 6], [6, 9]], [[-1, 1]], [[1]])


@st.composite
def filters(draw, singular_phi=False):
    """Covariance problems Phi, H, M, V with positive definite V."""
    n, m = draw(st.integers(1, 3)), draw(st.integers(1, 2))
    Phi = draw(matrices(n, n)) if singular_phi else draw(invertible(n))
    root = mat(draw(invertible(m)))
    return Phi, draw(nonnegative(n)), draw(matrices(m, n)), rows(root * root.transpose())


@st.composite
def diagonal_problems(draw):
    """Problems whose R_p has a rational spectrum: H or M vanish in each of the modes."""
    n = draw(st.integers(1, 3))
    modes = st.sampled_from([fmpq(2), fmpq(3), fmpq(-3, 2), fmpq(1, 4), fmpq(-2, 5), fmpq(5)])
    eigenvalues = draw(st.lists(modes, min_size=n, max_size=n, unique_by=lambda x: abs(x) + abs(1 / x)))
    driven = [draw(st.booleans()) for _ in range(n)]
    T = mat(draw(invertible(n)))
    inverse = T.inv()
    Phi = T * fmpq_mat([[x if i == j else 0 for j in range(n)] for i, x in enumerate(eigenvalues)]) * inverse
    noise = [draw(rationals()) if d else fmpq(0) for d in driven]
    seen = [fmpq(0) if d else draw(rationals().filter(lambda x: x != 0)) for d in driven]
    b = T * fmpq_mat([[x] for x in noise])
    return rows(Phi), rows(b * b.transpose()), rows(fmpq_mat([seen]) * inverse), ((fmpq(1),),)


def rewritten(P, Phi, H, M, V):
    """The right side of D71 (3.46), as printed, at a solution that need not be symmetric, which `covariance_step` refuses."""
    P, Phi, H, M, V = map(mat, (P, Phi, H, M, V))
    return rows(Phi * (P - P * M.transpose() * (M * P * M.transpose() + V).inv() * M * P) * Phi.transpose() + H)


@given(pairs(max_n=3), st.data())
def test_symplectic_matrix_acts_as_the_riccati_recursion(pair, data):
    """The matrix of BLZ94 (6.8a) is symplectic, acts as one Riccati step, and equals the one of (6.14)."""
    a, g = pair
    assume(a[-1] != 0 and a[-1] + g[-1] != 0)
    F, g_column, h = observer_form(a, g)
    S = symplectic_matrix(F, g_column, h)
    assert is_symplectic(S) and mat(S) == symplectic_matrix_of(a, g)
    P = data.draw(matrices(len(a), len(a)))
    P = rows(mat(P) + mat(P).transpose())
    assume(P[0][0] != 1)
    assert act(S, P) == riccati_step(F, g_column, h, P)


@given(filters(), st.data())
def test_six_forms_of_the_posterior_covariance(problem, data):
    """All seven expressions of D71 (1.24), (1.28) agree for positive definite P."""
    _, H, M, V = problem
    root = mat(data.draw(invertible(len(H))))
    P = rows(root * root.transpose())
    assert len({posterior_covariance(P, M, V, form) for form in FORMS}) == 1


@given(filters(singular_phi=True), st.data())
def test_singular_covariances(problem, data):
    """The forms without the inverse of P agree for nonnegative P, and the step keeps P nonnegative."""
    Phi, H, M, V = problem
    P = data.draw(nonnegative(len(H)))
    assert len({posterior_covariance(P, M, V, form) for form in FORMS if form != "d"}) == 1
    assert negative_direction(covariance_step(P, Phi, H, M, V)) is None


@given(filters(), st.data())
def test_duven_matrix_acts_as_the_covariance_equation(problem, data):
    """The matrix of D71 (3.51) is symplectic, of determinant one, and acts as one step of the covariance equation."""
    Phi, H, M, V = problem
    P = data.draw(nonnegative(len(H)))
    R = duven_matrix(*problem)
    assert is_symplectic(R) and mat(R).det() == 1
    assert moebius(R, P) == covariance_step(P, Phi, H, M, V)


@given(st.data(), st.integers(1, 3))
def test_filter_map_is_prediction_then_update(data, d):
    """B93 (4) is the a posteriori covariance of the predicted one, and the action of the Hamiltonian matrix (7)."""
    A, F, C = data.draw(invertible(d)), data.draw(matrices(d, 2)), data.draw(matrices(2, d))
    P = data.draw(nonnegative(d))
    predicted = mat(A) * mat(P) * mat(A).transpose() + mat(F) * mat(F).transpose()
    expected = posterior_covariance(rows(predicted), C, ((1, 0), (0, 1)))
    assert filter_map(P, A, F, C) == expected == moebius(hamiltonian_matrix(A, F, C), P)


@given(diagonal_problems())
def test_equilibria_solve_the_covariance_equation(problem):
    """Every isolated equilibrium is fixed, and with a complete rational spectrum none is missing."""
    found = equilibria(*problem)
    assert found.irreducible == () and found.families == ()
    for equilibrium in found.isolated:
        assert rewritten(equilibrium.P, *problem) == equilibrium.P
        assert not equilibrium.is_symmetric or covariance_step(equilibrium.P, *problem) == equilibrium.P
        F, Gamma = mat(equilibrium.F), mat(equilibrium.Gamma)
        assert F * Gamma.inv() == mat(equilibrium.P)
        halves = zip(zip(*equilibrium.F, strict=True), zip(*equilibrium.Gamma, strict=True), strict=True)
        basis = [(*upper, *lower) for upper, lower in halves]
        again = equilibrium_from_basis(*problem, basis)
        assert again.P == equilibrium.P and again.eigenvalues == equilibrium.eigenvalues


@given(diagonal_problems())
def test_stabilizing_equilibrium(problem):
    """The stabilising equilibrium is one of the equilibria, nonnegative, and fails as D71 Theorem 3.18 says."""
    Phi, _, M, _ = problem
    observability, power = [], mat(M)
    for _ in Phi:
        observability += power.tolist()
        power = power * mat(Phi)
    try:
        best = stabilizing_equilibrium(*problem)
    except BadInput as error:
        assert "unobservable" in str(error) and fmpq_mat(observability).rank() < len(Phi)
        return
    assert all(abs(x) > 1 for x in best.eigenvalues) and len(best.eigenvalues) == len(Phi)
    assert best.P in [e.P for e in equilibria(*problem).isolated] and best.is_symmetric
    assert negative_direction(best.P) is None


@given(rationals(), rationals())
def test_example_3_1(x, y):
    """The family (3.114) of D71 consists of equilibria and (3.115) are the symmetric ones."""
    P = (
        (fmpq(16, 3) + 2 * (x + y) / 3 - 4 * x * y / 27, 8 + y - 2 * x * y / 9),
        (8 + x - 2 * x * y / 9, 12 - x * y / 3),
    )
    assert rewritten(P, *EXAMPLE_3_1) == P
    assert (P[0][1] == P[1][0]) == (x == y)


@given(rationals().filter(lambda s: s != -2), rationals())
def test_example_3_1_from_subspaces(s, t):
    """The subspaces with one eigenvector for 2 and one for 1/2 give the equilibria of the family (3.114)."""
    found = equilibrium_from_basis(*EXAMPLE_3_1, [[25 + 8 * s, 24 + 12 * s, 3, s], [2 * t, 3 * t, 3, -2]])
    assert found.eigenvalues == (fmpq(1, 2), fmpq(2))
    assert rewritten(found.P, *EXAMPLE_3_1) == found.P
    assert found.is_symmetric == (s * t == 9 - 2 * t)


def test_example_3_1_classification():
    """One isolated equilibrium, one divisor with singular Gamma and one family."""
    found = equilibria(*EXAMPLE_3_1)
    assert [e.P for e in found.isolated] == [((fmpq(25, 3), 8), (8, 12))]
    assert found.isolated[0].eigenvalues == (2, 2) and found.irreducible == ()
    assert [f.coeffs() for f in found.singular] == [[fmpq(1, 4), -1, 1]]
    assert [f.coeffs() for f in found.families] == [[1, fmpq(-5, 2), 1]]


def test_example_3_1_matrix():
    """The printed matrix (3.110) and the printed eigenvectors (3.112) of D71 are right."""
    R = mat(duven_matrix(*EXAMPLE_3_1))
    half, third = fmpq(1, 2), fmpq(1, 3)
    assert fmpq_mat([[2, -1, 8, 12], [0, half, 12, 18], [half, -third, half, 0], [-third, fmpq(2, 9), 1, 2]]) == R
    E = fmpq_mat([[8, 25, 0, 2], [12, 24, 0, 3], [0, 3, 3, 0], [1, 0, -2, 0]])
    Omega = fmpq_mat([[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, half, 0], [0, 0, 0, half]])
    assert E * Omega == R * E


def test_example_3_3():
    """The irrational equilibria of D71 Example 3.3 are fixed to 45 digits and round to the printed ones."""
    with pytest.raises(Unsupported, match="both sides"):
        stabilizing_equilibrium(*EXAMPLE_3_3)
    with mp.workdps(50):
        tables = [tuple(tuple(mpf(int(fmpq(x).p)) / int(fmpq(x).q) for x in row) for row in t) for t in EXAMPLE_3_3]
        p = (1 + sqrt(mpf(65))) / 8
        second = tuple(tuple(p * x for x in row) for row in tables[1])
        first = ((mpf(64), mpf(0)), (mpf(0), mpf(64)))
        for _ in range(150):
            first = covariance_step(first, *tables)
            first = (first[0], (first[0][1], first[1][1]))  # rounding may leave it a little unsymmetric, which is refused
        for P, printed in ((first, (13.13719, 10.61281, 11.88719)), (second, (4.53113, 6.79669, 10.19504))):
            new = covariance_step(P, *tables)
            assert all(
                abs(x - y) < mpf(10) ** -45 for r, s in zip(new, P, strict=True) for x, y in zip(r, s, strict=True)
            )
            assert all(abs(x - y) < 6e-6 for x, y in zip((P[0][0], P[0][1], P[1][1]), printed, strict=True))


def test_stabilizing_with_irrational_spectrum():
    """Irrational eigenvalues on one side of the unit circle do not prevent a rational stabilising equilibrium."""
    Phi = [[0, 7], [1, 0]]
    best = stabilizing_equilibrium(Phi, [[0, 0], [0, 0]], [[1, 0]], [[1]])
    assert covariance_step(best.P, Phi, [[0, 0], [0, 0]], [[1, 0]], [[1]]) == best.P
    assert nonpositive_direction(best.P) is None and best.eigenvalues == ()


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: riccati_step([[1]], [[0]], [[1]], [[1]]), "P = ((1,),): 1 - h'Ph = 0"),
        (lambda: posterior_covariance([[1]], [[1]], [[-1]]), "MPM' + V = ((0,),): singular"),
        (lambda: posterior_covariance([[0]], [[1]], [[1]], form="d"), "P = ((0,),): singular"),
        (lambda: posterior_covariance([[0]], [[1]], [[1]], form="g"), "form = 'g'"),
        (lambda: symplectic_matrix([[0]], [[1]], [[1]]), "F = ((0,),): singular"),
        (lambda: symplectic_matrix([[1]], [[1]], [[1]]), "(F, g, h) = (((1,),), ((1,),), ((1,),)): sigma"),
        (lambda: duven_matrix([[0]], [[1]], [[1]], [[1]]), "Phi = ((0,),): singular"),
        (lambda: duven_matrix([[1]], [[1]], [[1]], [[0]]), "V = ((0,),): singular, its first column is zero"),
        (lambda: act([[1, 1], [0, 1]], [[-1]]), "S11 + S12 P = ((0,),): singular"),
        (lambda: stabilizing_equilibrium([[1]], [[0]], [[1]], [[1]]), "R_p = 2x2 matrix [[1, 0], [1, 1]]: has the eigenvalue 1 on"),
        (lambda: stabilizing_equilibrium([[2]], [[1]], [[0]], [[1]]), "(Phi, M) = ([[2]], [[0]]): an unstable mode"),
        (lambda: equilibrium_from_basis([[2]], [[1]], [[1]], [[1]], [[1, 1]]), "basis = ((1, 1),): its span"),
        (lambda: equilibrium_from_basis([[2]], [[1]], [[0]], [[1]], [[1, 0]]), "basis = ((1, 0),): the lower half"),
        (lambda: equilibrium_from_basis([[2]], [[1]], [[0]], [[1]], [[0, 0]]), "basis = ((0, 0),): has rank 0"),
        (lambda: equilibrium_from_basis([[2]], [[1]], [[0]], [[1]], [[0]]), "basis = ((0,),): has shape (1, 1)"),
    ],
)
def test_messages(call, text):
    """Every refusal names the argument in one line."""
    with pytest.raises(BadInput) as caught:
        call()
    assert str(caught.value).startswith(text) and "\n" not in str(caught.value)
