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

from collections.abc import Mapping, Sequence

from exactkf.evidence import Evidence, order, within
from exactkf.language import Expr, Identity, T, Zero, inv, let, loewner, matrix_of, psd, rec, stein, symbols, when
from proofs.d71.notation import i, j, n

__all__ = ["N", "Fading", "Pi", "R", "Z", "eigenvalues"]

Z, R, N, Pi, t = symbols("Z R N Pi t")


class Fading:
    """What a claim needs to bound W_t = K^t U_0 (K^t)', for a stable K and a nonnegative definite U_0.

    ``where`` are Z and R, as the solutions of their equations, which there are if a hypothesis says that K is stable, and K^t with the count t + 1;
    ``bound`` is the formula. ``also`` is carried
    along by an `induction`, with the orders that `begins` and `goes_on` make; ``first`` and ``then`` are the terms for the bound;
    ``now`` is what it bounds, and ``later`` that at t + 1.
    """

    def __init__(self, K: Expr, U0: Expr, W: Expr | None = None) -> None:
        at = Pi[t]*U0*T(Pi[t]) if W is None else W[t]
        self.where = [let(Z, stein(K, U0)), let(R, stein(K, Z)), rec(Pi, t, Identity(n), K*Pi[t]), rec(N, t, 1, N[t] + 1)]
        spent, spent_next = ((N[s] - 1)*(Pi[s]*Z*T(Pi[s])) + Pi[s]*R*T(Pi[s]) for s in (t, t + 1))
        self.now = N[t]*at
        self.bound = loewner(R, self.now)
        self.later = N[t + 1]*(Pi[t + 1]*U0*T(Pi[t + 1])) if W is None else N[t + 1]*W[t + 1]
        self.also = [K*Pi[t] == Pi[t]*K, at == Pi[t]*U0*T(Pi[t]), psd(at), N[t] >= 0, N[t] - 1 >= 0, loewner(R, spent)]
        self.first = [K*Z*T(K), K*R*T(K)]
        self.then = [R - spent_next, *(x*Pi[t + 1]*y*T(Pi[t + 1]) for x, y in ((N[t], K*Z*T(K)), (1, K*R*T(K)), (1, K*Z*T(K))))]
        self._sums = [[U0], [Z]]
        self._base, self._step = [[], [], [U0], [1], [0], [Zero(n, n)]], [[], [], [K*at*T(K)], [1*N[t], 1], [1*N[t]], [R - spent, N[t]*at]]
        self._stable = K

    def begins(self, *terms: list, before: Sequence[tuple] = ()) -> Evidence:
        """The order at t = 0: terms for what comes after ``also``; lemmas with their terms and `within` that come before all."""
        return self._order(before, [*self._base, *terms])

    def goes_on(self, *terms: list, before: Sequence[tuple] = (), inside: Sequence[Mapping] = ()) -> Evidence:
        """The order from t to t + 1; ``inside`` is for equations among the lemmas before, whose own lemmas need no terms."""
        k = sum(len(w["lemmas"]) for w in inside)
        return self._order([*before[:-1], *k*[(None, [])], *before[-1:]] if k else before, [*self._step, *terms], inside)

    def _order(self, before: Sequence[tuple], terms: list, inside: Sequence[Mapping] = ()) -> Evidence:
        lemmas = [*(formula for formula, _ in before if formula is not None), psd(Z), psd(R)]
        return order(*(t for _, t in before), *self._sums, *terms, lemmas=lemmas,
                     inside=[*inside, *(within(m, stein=self._stable) for m, formula in enumerate(lemmas) if formula.tree[0] == "psd")])


def eigenvalues(E: Expr, ratio: Expr, K: Expr, U0: Expr) -> dict:
    """K = E G E^{-1} for the diagonal matrix G of the ratios, which are given in i, and the U_0 for which R = EE'."""
    def scaled(entry: Expr | int) -> Expr:
        return E*matrix_of(i, j, n, n, when(i == j, entry, 0))

    return {K: scaled(ratio)*inv(E), U0: scaled((1 - ratio**2)**2)*T(E)}
