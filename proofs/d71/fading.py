# SPDX-License-Identifier: MIT
"""Powers of a matrix with its eigenvalues inside the unit circle tend to zero: a bound for every k.

Let K be such a matrix, U_0 >= 0 and W_k = K^k U_0 (K^k)'. The equation Z - KZK' = U_0 has
a solution, the sum of all W_k; and R - KRK' = Z has one, the sum of all K^k Z (K^k)', which
is the sum of the (k + 1)W_k. All of them are nonnegative definite, so that

    0 <= (k + 1) W_k <= R,

with an R that is the same for all k: W_k tends to zero. For the proof put Z_k = K^k Z (K^k)'
and R_k = K^k R (K^k)', for which Z_k - Z_{k+1} = W_k and R_k - R_{k+1} = Z_k; then
k Z_k + R_k decreases, from R, by (k + 1) W_k at each step.
"""

from exactkf.evidence import Evidence, first, order, within
from exactkf.language import Expr, Identity, T, Zero, given, inv, loewner, matrix_of, psd, rec, symbols, symmetric_matrix, when
from proofs.d71.notation import i, j, n

__all__ = ["N", "Fading", "Pi", "R", "Z", "eigenvalues"]

Z, R, N, Pi, t = symbols("Z R N Pi t")


class Fading:
    """What a claim needs to bound W_t, a recursion with the values K^t U_0 (K^t)'.

    ``over``, ``given`` and ``where`` are Z, R with their equations, and K^t with the count t + 1; ``bound`` is the formula; ``before`` and
    ``also`` are shown first and along with it, with the terms ``base`` and ``step``; ``bound_base`` and ``bound_step`` are those of the bound.
    """

    def __init__(self, K: Expr, U0: Expr, W: Expr) -> None:
        zero = Zero(n, n)
        self.over = {Z: symmetric_matrix(n), R: symmetric_matrix(n)}
        self.given = [given("Z, the sum of the W_k", Z - K*Z*T(K) == U0), given("R, the sum of the (k + 1)W_k", R - K*R*T(K) == Z)]
        self.where = [rec(Pi, t, Identity(n), K*Pi[t]), rec(N, t, 1, N[t] + 1)]
        self.before = [first(psd(Z), base=_from(U0, K)), first(psd(R), base=_from(Z, K))]
        spent, spent_next = ((N[s] - 1)*(Pi[s]*Z*T(Pi[s])) + Pi[s]*R*T(Pi[s]) for s in (t, t + 1))
        self.also = [K*Pi[t] == Pi[t]*K, W[t] == Pi[t]*U0*T(Pi[t]), psd(W[t]), N[t] >= 0, N[t] - 1 >= 0, loewner(R, spent)]
        self.base = [[], [], [U0], [1], [0], [zero]]
        self.step = [[], [], [K*W[t]*T(K)], [1*N[t], 1], [1*N[t]], [R - spent, N[t]*W[t]]]
        self.bound = loewner(R, N[t]*W[t])
        self.bound_base = [K*Z*T(K), K*R*T(K)]
        left = [(N[t], K*Z*T(K)), (1, K*R*T(K)), (1, K*Z*T(K))]
        self.bound_step = [R - spent_next, *(x*Pi[t + 1]*y*T(Pi[t + 1]) for x, y in left)]


def _from(known: Expr, K: Expr) -> Evidence:
    return order([known], inside=[within(0, stein=K)])


def eigenvalues(E: Expr, ratio: Expr, K: Expr, U0: Expr) -> dict:
    """K = E G E^{-1} for the diagonal matrix G of the ratios, which are given in i, R = EE', and the Z and U_0 that belong to it."""
    def scaled(entry: Expr | int) -> Expr:
        return E*matrix_of(i, j, n, n, when(i == j, entry, 0))

    return {K: scaled(ratio)*inv(E), R: scaled(1)*T(E), Z: scaled(1 - ratio**2)*T(E), U0: scaled((1 - ratio**2)**2)*T(E)}
