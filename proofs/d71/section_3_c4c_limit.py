# SPDX-License-Identifier: MIT
"""Convergence of the actual covariance (Chapter III, section C.4.c).

W_k = P_a(t_k) - P_ae follows the same linear equation as P_a, but for what the gain K_k makes
of P_ae: W_{k+1} = A_k W_k A_k' + D_k with A_k = Phi(I - K_k M). So W_m is the product of the
A_k applied to W_0 on both sides, plus the same for each D_i from where it enters.

At an equilibrium with a random walk mode that is undriven, Phi'n = lambda n and Pn = Hn = 0,
the gain does not act on n: n'P_a n grows by n'H_a n at each step.
"""

from exactkf.claims import claim
from exactkf.evidence import example, identity, induction, instances, order, part
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    diag,
    function,
    given,
    inv,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_definite,
    positive_semidefinite,
    rec,
    scalar,
    sequence_of,
    signal_of,
    sum_of,
    symbols,
    symmetric_matrix,
    vector,
    when,
)
from proofs.d71.notation import H, K, M, P, Phi, V, gain, i, j, k, n, p

x, xi, A, Prod, Ha, Va, Pa, Pa0, Pae, Ke, W, W0, D, X, Y, E, B, c, lam, nd, Var = symbols(
    "x xi A Prod Ha Va Pa Pa0 Pae Ke W W0 D X Y E B c lam nd Var")
I, Zn = Identity(n), Zero(n, n)
GAINS = {Phi: matrix(n, n), M: matrix(p, n), K: signal_of(matrix(n, p), 0)}
PRODUCT = rec(Prod, k, I, Phi*(I - K[k]*M)*Prod[k])

claim("D71-E3.250", "the solution of the homogeneous equation",
      always(k, x[k] == Prod[k]*xi),
      sizes=["n", "p"], over={**GAINS, xi: vector(n)}, where=[PRODUCT, rec(x, k, xi, Phi*(I - K[k]*M)*x[k])],
      by=[induction(), instances(6, n=(1, 2), p=(1, 2), horizon=2)], note="Prod_m is Phi_x(t_m, t_0), and xi is x_0.")


def actual(pa, kk):
    """The actual covariance one instant later, with a gain."""
    return Phi*((I - kk*M)*pa*T(I - kk*M) + kk*Va*T(kk))*T(Phi) + Ha


DRIFT = Phi*((I - K*M)*Pae*T(I - K*M) - (I - Ke*M)*Pae*T(I - Ke*M) + K*Va*T(K) - Ke*Va*T(Ke))*T(Phi)

claim("D71-E3.255", "the deviation from the limit",
      actual(Pa, K) - Pae == Phi*(I - K*M)*(Pa - Pae)*T(I - K*M)*T(Phi) + DRIFT,
      sizes=["n", "p"],
      over={Phi: matrix(n, n), M: matrix(p, n), K: matrix(n, p), Ke: matrix(n, p), Ha: symmetric_matrix(n), Va: symmetric_matrix(p), Pa: symmetric_matrix(n),
            Pae: symmetric_matrix(n)},
      given=[given("P_ae is the limit", Pae == actual(Pae, Ke))],
      by=[order(), instances(8, n=(1, 2), p=(1, 2), made_by={Ha: Pae - Phi*((I - Ke*M)*Pae*T(I - Ke*M) + Ke*Va*T(Ke))*T(Phi)})],
      note="K is K_k and Ke is K_e.")

Tr, aa, bb, m = symbols("Tr a b m")
#: Phi_x(t_a, t_b)
TRANSITION = function(Tr, [aa, bb], when(aa == bb, I, A(aa - 1)*Tr(aa - 1, bb)))

claim("D71-E3.257", "the deviation after m steps",
      W[m] == Tr(m, 0)*W0*T(Tr(m, 0)) + sum_of(i, 0, m - 1, Tr(m, i + 1)*D[i]*T(Tr(m, i + 1))),
      sizes=["n", "m"], over={A: sequence_of(matrix(n, n), 0, m - 1), D: sequence_of(symmetric_matrix(n), 0, m - 1), W0: symmetric_matrix(n)},
      where=[TRANSITION, rec(W, k, W0, A[k]*W[k]*T(A[k]) + D[k])],
      by=[identity(n=(1, 2), m=(1, 2, 3)), instances(8, n=(1, 2), m=(1, 2, 3))],
      note="A_k is Phi(I - K_k M), and Tr(a, b) is Phi_x(t_a, t_b) = A_{a-1}...A_b.")

ACTUAL = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p), P: positive_semidefinite(n),
          Ha: positive_semidefinite(n), Va: positive_semidefinite(p), Pa0: positive_semidefinite(n), nd: vector(n), lam: scalar()}
WALK = [given("undriven", T(Phi)*nd == lam*nd), given("a null vector of P", P*nd == Zero(n, 1)), given("random walk", lam**2 == 1)]
RUN = [let(K, gain()), rec(Pa, k, Pa0, actual(Pa[k], K))]
REST = n - 1
CORNERED = instances(6, n=(2,), p=(1, 2), horizon=2, using={E: nonsingular(n), X: matrix(REST, 1), B: nonsingular(REST), Y: matrix(REST, REST), c: scalar()},
                     made_by={lam: when(c > 0, 1, -1), Phi: E*block([[lam*Identity(1), Zero(1, REST)], [X, B]])*inv(E), P: E*diag(Zero(1, 1), Y*T(Y))*T(E),
                              nd: inv(T(E))*matrix_of(i, j, n, 1, when(i == 1, 1, 0))})
ONE = {"n": 1, "p": 1, "Phi": [[1]], "H": [[0]], "M": [[1]], "V": [[1]], "P": [[0]], "Ha": [[1]], "Va": [[1]], "Pa0": [[1]], "nd": [1], "lam": 1}

claim("D71-E3.247", "the component along a random walk mode",
      always(k, T(nd)*Pa[k + 1]*nd == T(nd)*Pa[k]*nd + T(nd)*Ha*nd),
      sizes=["n", "p"], over=ACTUAL, where=RUN, given=WALK,
      by=[part("real lambda, and not that there is such a v"),
          induction(), example({**ONE, "Phi": [[2]]}), example({**ONE, "P": [[1]]}), example({**ONE, "Phi": [[2]], "lam": 2}), CORNERED],
      note="Real lambda, 1 or -1; alpha_k is n'P_a(t_k)n. The existence of v is not stated here.")

claim("D71-S65", "growth along a random walk mode",
      always(k, T(nd)*Pa[k]*nd == T(nd)*Pa0*nd + k*(T(nd)*Ha*nd)),
      sizes=["n", "p"], over=ACTUAL, where=RUN, given=WALK,
      by=[part("real lambda"), induction(), example({**ONE, "Phi": [[2]]}), example({**ONE, "P": [[1]]}), example({**ONE, "Phi": [[2]], "lam": 2}), CORNERED],
      note="So it grows without bound if n'H_a n > 0, and stays where it is if n'H_a n = 0.")
