# SPDX-License-Identifier: MIT
r"""The Riccati recursions of the five papers.

Main definitions
----------------
``observer_form``           :math:`F, g, h` in canonical form from :math:`a, g` (BLZ94 (2.10))
``riccati_step``            :math:`P \mapsto FPF' + (g-FPh)(1-h'Ph)^{-1}(g-FPh)'` (BLZ94 (2.2))
``riccati_gain``            :math:`k = (g - FPh)/(1 - h'Ph)` (BLZ94 (2.8))
``symplectic_matrix``       the matrix `S` of BLZ94 (6.8a)
``act``                     :math:`P \mapsto (S_{21} + S_{22}P)(S_{11} + S_{12}P)^{-1}` (BLZ94 (6.6))
``posterior_covariance``    the six forms of D71 (1.24), (1.28)
``covariance_step``         D71 (1.27)
``filter_map``              :math:`\Phi(P)` of B93 (4)
``duven_matrix``            :math:`R_p` of D71 (3.51)

Main statements
---------------
* Started at :math:`P_0 = 0`, BLZ94 (2.2) gives the gains of the fast filter, and
  :math:`P_{t+1} - P_t = r_t g(t) g(t)'` with :math:`r_t = 1 - h'P_th` (BLZ94 (6.4)).
* `S` is symplectic and `act` of it is `riccati_step` (BLZ94 Proposition 6.4).
* The six forms of the posterior covariance agree where all of them exist.
* :math:`P \mapsto (BP + A)(DP - C)^{-1}` with the blocks of :math:`R_p` is `covariance_step`.

References
----------
BLZ94 Section 2 and (6.1)-(6.14); D71 (1.22)-(1.29), (3.46)-(3.53); B93 (1)-(6).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

from exactkf.theory._matrices import (
    Matrix,
    as_matrices,
    blocks,
    check_shape,
    check_square,
    check_symmetric,
    column,
    identity,
    inverse,
    minus,
    plus,
    product,
    scaled,
    solved,
    transposed,
)
from exactkf.theory._scalars import Scalar, Vector, refused, unify_pair, units

__all__ = [
    "act",
    "covariance_step",
    "duven_matrix",
    "filter_map",
    "observer_form",
    "posterior_covariance",
    "riccati_gain",
    "riccati_step",
    "symplectic_matrix",
]


def observer_form(a: Sequence[Scalar], g: Sequence[Scalar]) -> tuple[Matrix, Matrix, Matrix]:
    r"""Return :math:`F = J - ah'`, `g` and `h` in observer canonical form (BLZ94 (2.10)).

    Parameters
    ----------
    a, g : sequences of scalars, length n

    Returns
    -------
    F : Matrix, shape (n, n)
    g, h : Matrix, shape (n, 1)

    Raises
    ------
    BadInput
        If the lengths differ or are zero.
    """
    a, g = unify_pair(a=a, g=g)
    zero, one = units(a)
    n = len(a)
    F = tuple(tuple((one if j == i + 1 else zero) - (a[i] if j == 0 else zero) for j in range(n)) for i in range(n))
    return F, column(g), column([one] + [zero] * (n - 1))


def _system(F: Any, g: Any, h: Any) -> tuple[Matrix, Matrix, Matrix]:
    """Return `F`, `g` and `h` over one scalar type, of fitting shapes."""
    F, g, h = as_matrices(F=F, g=g, h=h)
    n = check_square("F", F)
    check_shape("g", g, (n, 1), "F")
    check_shape("h", h, (n, 1), "F")
    return F, g, h


def _recursion(F: Any, g: Any, h: Any, P: Any) -> tuple[Matrix, Matrix, Matrix, Matrix, Scalar]:
    """Return the arguments of a Riccati step, checked, and ``1 - h'Ph``, which is not zero."""
    F, g, h, P = as_matrices(F=F, g=g, h=h, P=P)
    F, g, h = _system(F, g, h)
    check_symmetric("P", P, len(F), "F")
    value = 1 - product(transposed(h), P, h)[0][0]
    if value == 0:
        raise refused("P", P, "1 - h'Ph = 0, the recursion escapes", "pass P with 1 - h'Ph != 0")
    return F, g, h, P, value


def riccati_gain(F: Any, g: Any, h: Any, P: Any) -> Vector:
    r"""Return :math:`k = (1 - h'Ph)^{-1}(g - FPh)` (BLZ94 (2.8)).

    Parameters
    ----------
    F : matrix, shape (n, n)
    g, h : matrices, shape (n, 1)
    P : symmetric matrix, shape (n, n)

    Raises
    ------
    BadInput
        If :math:`1 - h'Ph = 0`, `P` is not symmetric or the shapes do not fit.
    """
    F, g, h, P, r = _recursion(F, g, h, P)
    return tuple(x / r for (x,) in minus(g, product(F, P, h)))


def riccati_step(F: Any, g: Any, h: Any, P: Any) -> Matrix:
    r"""Return the next `P` (BLZ94 (2.2)); arguments and errors as `riccati_gain`.

    Examples
    --------
    >>> riccati_step([[0]], [[2]], [[1]], [[0]])
    ((4,),)
    """
    F, g, h, P, r = _recursion(F, g, h, P)
    rest = minus(g, product(F, P, h))
    return plus(product(F, P, transposed(F)), scaled(1 / r, product(rest, transposed(rest))))


def symplectic_matrix(F: Any, g: Any, h: Any) -> Matrix:
    r"""Return the symplectic matrix `S` of order ``2n`` (BLZ94 (6.8a)).

    Parameters
    ----------
    F : matrix, shape (n, n), nonsingular
    g, h : matrices, shape (n, 1)

    Raises
    ------
    BadInput
        If `F` is singular, :math:`\sigma = 1 - h'F^{-1}g = 0` or the shapes do not fit.
    """
    F, g, h = _system(F, g, h)
    F_inv = inverse(F, "F")
    g_row, h_row = transposed(g), transposed(h)
    sigma = 1 - product(h_row, F_inv, g)[0][0]
    if sigma == 0:
        raise refused("(F, g, h)", (F, g, h), "sigma = 1 - h'F^(-1)g = 0, so F - gh' is singular", "pass data with alpha_n != 0")
    weight = 1 / sigma
    upper = [
        plus(F_inv, scaled(weight, product(F_inv, g, h_row, F_inv))),
        scaled(weight, product(F_inv, g, g_row)),
    ]
    lower = [scaled(-weight, product(h, h_row, F_inv)), minus(transposed(F), scaled(weight, product(h, g_row)))]
    return transposed(blocks([upper, lower]))


def act(S: Any, P: Any) -> Matrix:
    r"""Return :math:`(S_{21} + S_{22}P)(S_{11} + S_{12}P)^{-1}` (BLZ94 (6.6)).

    Parameters
    ----------
    S : matrix, shape (2n, 2n)
    P : matrix, shape (n, n)

    Raises
    ------
    BadInput
        If :math:`S_{11} + S_{12}P` is singular or the shapes do not fit.
    """
    S, P = as_matrices(S=S, P=P)
    n = check_square("P", P)
    check_shape("S", S, (2 * n, 2 * n), "P")
    Z = product(S, (*identity(n, units(P[0])[1]), *P))
    return transposed(solved(transposed(Z[:n]), transposed(Z[n:]), "S11 + S12 P"))


def _gain_d71(P: Matrix, M: Matrix, V: Matrix) -> Matrix:
    """Return ``PM'(MPM' + V)^-1`` (D71 (1.22))."""
    PMt = product(P, transposed(M))
    middle = plus(product(M, PMt), V)
    return transposed(solved(transposed(middle), transposed(PMt), "MPM' + V"))


def _check_measurement(n: int, reference: str, M: Matrix, V: Matrix) -> None:
    """Refuse `M` that has not `n` columns, as `reference` has, and `V` that is not symmetric with the order that `M` sets."""
    check_shape("M", M, (len(M), n), reference)
    check_symmetric("V", V, len(M), "M")


def posterior_covariance(
    P: Any, M: Any, V: Any, form: Literal["1.24", "a", "b", "c", "d", "e", "f"] = "1.24"
) -> Matrix:
    r"""Return the a posteriori covariance `Q` from the a priori covariance `P`.

    Parameters
    ----------
    P : matrix, shape (n, n), symmetric
    M : matrix, shape (m, n)
    V : matrix, shape (m, m), symmetric
    form : {"1.24", "a", "b", "c", "d", "e", "f"}
        Which of the equal expressions D71 (1.24), (1.28a)-(1.28f) to evaluate.  "d", "e", "f"
        need :math:`V^{-1}`, and "d" needs :math:`P^{-1}`.  In "b" the print lacks two
        primes; the correct expression is :math:`P - PM'K'`.

    Raises
    ------
    BadInput
        If a matrix to be inverted is singular, `P` or `V` is not symmetric, the shapes do not fit or `form` is unknown.

    Examples
    --------
    >>> posterior_covariance([[1]], [[1]], [[1]], form="d")
    ((1/2,),)
    """
    P, M, V = as_matrices(P=P, M=M, V=V)
    check_symmetric("P", P)
    _check_measurement(len(P), "P", M, V)
    eye = identity(len(P), units(P[0])[1])
    Mt = transposed(M)
    if form in ("d", "e", "f"):
        info = product(Mt, solved(V, M, "V"))
        if form == "d":
            return inverse(plus(inverse(P, "P"), info), "P^(-1) + M'V^(-1)M")
        if form == "e":
            right = plus(eye, product(info, P))
            return transposed(solved(transposed(right), transposed(P), "I + M'V^(-1)MP"))
        return solved(plus(eye, product(P, info)), P, "I + PM'V^(-1)M")
    if form not in ("1.24", "a", "b", "c"):
        raise refused("form", form, "not a form of D71 (1.28)", "pass '1.24' or one of 'a' to 'f'")
    K = _gain_d71(P, M, V)
    if form == "b":
        return minus(P, product(P, Mt, transposed(K)))
    if form == "c":
        rest = minus(eye, product(K, M))
        return plus(product(rest, P, transposed(rest)), product(K, V, transposed(K)))
    if form == "a":
        return minus(P, product(K, M, P))
    return minus(P, product(P, Mt, inverse(plus(product(M, P, Mt), V), "MPM' + V"), M, P))


def covariance_step(P: Any, Phi: Any, H: Any, M: Any, V: Any) -> Matrix:
    r"""Return :math:`\Phi[P - PM'(MPM'+V)^{-1}MP]\Phi' + H`, the next a priori covariance (D71 (1.27)).

    Parameters
    ----------
    P, H : symmetric matrices, shape (n, n)
    Phi : matrix, shape (n, n)
    M : matrix, shape (m, n)
    V : symmetric matrix, shape (m, m)

    Raises
    ------
    BadInput
        If :math:`MPM' + V` is singular, `P`, `H` or `V` is not symmetric or the shapes do not fit.
    """
    P, Phi, H, M, V = as_matrices(P=P, Phi=Phi, H=H, M=M, V=V)
    check_symmetric("P", P)
    check_shape("Phi", Phi, (len(P), len(P)), "P")
    check_symmetric("H", H, len(P), "P")
    return plus(product(Phi, posterior_covariance(P, M, V), transposed(Phi)), H)


def filter_map(P: Any, A: Any, F: Any, C: Any) -> Matrix:
    r"""Return :math:`\Phi(P) = (APA^* + S)(I + RS + RAPA^*)^{-1}`, :math:`R = C^*C`, :math:`S = FF^*` (B93 (4)).

    Parameters
    ----------
    P : symmetric matrix, shape (d, d)
    A : matrix, shape (d, d)
    F : matrix, shape (d, p)
    C : matrix, shape (q, d)

    Raises
    ------
    BadInput
        If `P` is not symmetric, the shapes do not fit, or :math:`I + RS + RAPA^*` is singular, which is
        impossible for nonnegative real `P`.
    """
    P, A, F, C = as_matrices(P=P, A=A, F=F, C=C)
    check_symmetric("P", P)
    d = len(P)
    check_shape("A", A, (d, d), "P")
    check_shape("F", F, (d, len(F[0])), "P")
    check_shape("C", C, (len(C), d), "P")
    X = plus(product(A, P, transposed(A)), product(F, transposed(F)))
    right = plus(identity(len(P), units(P[0])[1]), product(transposed(C), C, X))
    return transposed(solved(transposed(right), transposed(X), "I + RS + RAPA*"))


def duven_matrix(Phi: Any, H: Any, M: Any, V: Any) -> Matrix:
    r"""Return :math:`R_p`, of order ``2n``, with the factors of D71 (3.52).

    Parameters
    ----------
    Phi : matrix, shape (n, n), nonsingular
    H : symmetric matrix, shape (n, n)
    M : matrix, shape (m, n)
    V : symmetric matrix, shape (m, m), nonsingular

    Returns
    -------
    Matrix, shape (2n, 2n)
        :math:`\begin{pmatrix} H\Phi'^{-1}W + \Phi & H\Phi'^{-1} \\ \Phi'^{-1}W & \Phi'^{-1} \end{pmatrix}`
        with :math:`W = M'V^{-1}M` (D71 (3.51)).

    Raises
    ------
    BadInput
        If `Phi` or `V` is singular, `H` or `V` is not symmetric or the shapes do not fit.
    """
    Phi, H, M, V = as_matrices(Phi=Phi, H=H, M=M, V=V)
    n = check_square("Phi", Phi)
    check_symmetric("H", H, n, "Phi")
    _check_measurement(n, "Phi", M, V)
    W = product(transposed(M), solved(V, M, "V"))
    low = inverse(transposed(Phi), "Phi")
    return blocks([[plus(product(H, low, W), Phi), product(H, low)], [product(low, W), low]])
