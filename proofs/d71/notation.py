# SPDX-License-Identifier: MIT
"""Names and terms shared by the sections of the thesis.

The process is x+ = Phi x + h, y = M x + dy with white h and dy of covariance
H >= 0 and V >= 0. `update` is the covariance after a measurement, `step` the
covariance one instant later, `gram` the matrix M'V^{-1}M through which the
measurement enters, and `r_matrix` the 2 x 2 block matrix whose invariant
subspaces solve A + BP + PC - PDP = 0.

Data that change with time are cut out of wide matrices: `slices` names
Phi_0, Phi_1, ... as the square blocks of one matrix, and writes H_k = G_k G_k'
and V_k = W_k W_k', which is every nonnegative definite matrix.
"""

from exactkf.language import (
    Expr,
    Identity,
    T,
    block,
    function,
    inv,
    matrix,
    matrix_of,
    rec,
    sum_of,
    sym,
    symbols,
    to_expr,
    when,
)

n, p, N = symbols("n p N")
i, j, k = symbols("i j k")
Phi, H, M, V, P, K, Q = symbols("Phi H M V P K Q")


def gram(m: Expr = M, v: Expr = V) -> Expr:
    """M'V^{-1}M."""
    return T(m) * inv(v) * m


def gain(pp: Expr = P, m: Expr = M, v: Expr = V) -> Expr:
    """The gain PM'(MPM' + V)^{-1}."""
    return pp * T(m) * inv(m * pp * T(m) + v)


def update(pp: Expr = P, m: Expr = M, v: Expr = V) -> Expr:
    """Covariance after the measurement, P - PM'(MPM' + V)^{-1}MP."""
    return pp - pp * T(m) * inv(m * pp * T(m) + v) * m * pp


def joseph(kk: Expr, pp: Expr = P, m: Expr = M, v: Expr = V) -> Expr:
    """(I - KM)P(I - KM)' + KVK' for any gain K."""
    return (Identity(n) - kk * m) * pp * T(Identity(n) - kk * m) + kk * v * T(kk)


def step(pp: Expr = P, phi: Expr = Phi, m: Expr = M, v: Expr = V, h: Expr = H) -> Expr:
    """Covariance one instant later."""
    return phi * (update(pp, m, v)) * T(phi) + h


def across(vector: Expr, turn: Expr) -> Expr:
    """A vector at right angles to ``vector``: (U - U')v for any square U."""
    return (turn - T(turn)) * vector


def annihilating(vector: Expr, turn: Expr, other: Expr) -> Expr:
    """A nonnegative definite matrix that has ``vector`` as a null vector."""
    a, b = across(vector, turn), across(vector, other)
    return a * T(a) + b * T(b)


def r_matrix(a: Expr, b: Expr, c: Expr, d: Expr) -> Expr:
    """[[B, A], [D, -C]]."""
    return block([[b, a], [d, -c]])


# data that change with time, cut out of wide matrices
PhiW, MW, GW, WW = symbols("PhiW MW GW WW")
P0 = sym("P0")


def slices(length: Expr) -> dict:
    """Types of the wide matrices that hold ``length`` instants."""
    return {PhiW: matrix(n, n * length), MW: matrix(p, n * length), GW: matrix(n, n * length),
            WW: matrix(p, p * length)}


def cut(wide: Expr, height: Expr, width: Expr, at: Expr) -> Expr:
    return matrix_of(i, j, height, width, wide[i, width * at + j])


#: Phi_k, M_k, H_k = G_k G_k', V_k = W_k W_k'
VARYING = (
    function(Phi, [k], cut(PhiW, n, n, k)),
    function(M, [k], cut(MW, p, n, k)),
    function(H, [k], cut(GW, n, n, k) * T(cut(GW, n, n, k))),
    function(V, [k], cut(WW, p, p, k) * T(cut(WW, p, p, k))),
)


def varying_step(pp: Expr, at: Expr) -> Expr:
    """The covariance equation with the data of one instant."""
    return step(pp, Phi(at), M(at), V(at), H(at))


#: P_0, P_1, ... from the covariance equation
COVARIANCE = rec(P, k, P0, varying_step(P[k], k))

#: Phi(t_a, t_b) = Phi_{a-1} ... Phi_b
_a, _b = symbols("a b")
Tr = sym("Tr")
TRANSITION = function(Tr, [_a, _b], when(_a == _b, Identity(n), Phi(_a - 1) * Tr(_a - 1, _b)))


def superdiagonal(size: Expr) -> Expr:
    """The matrix N with ones next to the diagonal."""
    return matrix_of(i, j, size, size, when(j == i + 1, 1, 0))


def jordan_block(value: Expr, size: Expr) -> Expr:
    """value I + N."""
    return to_expr(value) * Identity(size) + superdiagonal(size)


_a1, _b1 = symbols("a1 b1")


def stacked(square: Expr) -> Expr:
    """The columns of an n x n matrix, one below the other."""
    return matrix_of(i, j, n*n, 1, sum_of(_a, 1, n, sum_of(_b, 1, n, when(i == (_b - 1)*n + _a, square[_a, _b], 0))))


def kronecker(left: Expr, right: Expr) -> Expr:
    """The Kronecker product of two n x n matrices, with the blocks left_{ab} right."""
    return matrix_of(i, j, n*n, n*n, sum_of(_a, 1, n, sum_of(_a1, 1, n, when(i == (_a - 1)*n + _a1, sum_of(_b, 1, n, sum_of(_b1, 1, n, when(
        j == (_b - 1)*n + _b1, left[_a, _b]*right[_a1, _b1], 0))), 0))))
