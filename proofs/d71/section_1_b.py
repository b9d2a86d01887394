# SPDX-License-Identifier: MIT
"""Controllability and observability in discrete time (Chapter I, section B).

With nonsingular Phi_k the state x_{k+1} = Phi_k x_k + G_k u_k, carried back to t_0 by
Psi_k = Phi(t_k, t_0)^{-1}, moves by Psi_{k+1}G_k u_k: the input of the instant k acts on the
state of the next one. So the states that inputs can bring to zero by t_k are the range of
the sum of Psi_{i+1}G_i G_i'Psi_{i+1}' for i < k, and with u_i = -G_i'Psi_{i+1}'c the state
carried back is x_0 less that sum times c.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, induction, instances
from exactkf.language import Identity, T, Zero, always, given, inv, invertible, matrix, nonsingular, pd, rec, sequence_of, signal_of, symbols, vector
from proofs.d71.notation import N, Phi, k, n

q, G, Psi, Wc, Reach, x, xi, c = symbols("q G Psi Wc Reach x xi c")
I, Zn = Identity(n), Zero(n, n)
BACK = rec(Psi, k, I, Psi[k]*inv(Phi[k]))

claim("D71-E1.44", "a Gramian for controllability in discrete time",
      invertible(Reach[N]),
      sizes=["n", "q", "N"], over={Phi: sequence_of(nonsingular(n), 0, N - 1), G: sequence_of(matrix(n, q), 0, N - 1)},
      where=[BACK, rec(Wc, k, Zn, Wc[k] + Psi[k]*G[k]*T(G[k])*T(Psi[k])), rec(Reach, k, Zn, Phi[k]*Reach[k]*T(Phi[k]) + G[k]*T(G[k]))],
      given=[given("W_c(t_N) > 0", pd(Wc[N]))],
      by=[example(n=2, q=1, N=2, Phi=[[[1, 0], [0, 1]], [[0, 1], [1, 0]]], G=[[[1], [0]], [[0], [1]]]), instances(n=(1, 2), q=(1,), N=(1, 2))],
      repair=repair(
          "index", "the input of the instant i acts on the state at t_{i+1}, so that Phi(t_{i+1}, t_0) is to be inverted, not Phi(t_i, t_0)",
          always(k, Psi[k]*x[k] == xi - Wc[k]*c),
          sizes=["n", "q"], over={Phi: signal_of(nonsingular(n), 0), G: signal_of(matrix(n, q), 0), xi: vector(n), c: vector(n)},
          where=[BACK, rec(Wc, k, Zn, Wc[k] + Psi[k + 1]*G[k]*T(G[k])*T(Psi[k + 1])),
                 rec(x, k, xi, Phi[k]*x[k] - G[k]*T(G[k])*T(Psi[k + 1])*c)],
          by=[induction(), instances(6, n=(1, 2), q=(1, 2), horizon=2)]),
      note="Psi_k is the inverse of Phi(t_k, t_0), and the range of Reach_N is what the inputs up to t_N can add to the state; an initial state can be "
           "brought to zero exactly if Phi(t_N, t_0) times it lies there. There are no inputs after t_N. In the counterexample Phi_1 exchanges the two "
           "coordinates, G_0 = e_1 and G_1 = e_2, so that both inputs add to the second coordinate, while W_c = I. In the repair the inputs are u_i = "
           "-G_i'Psi_{i+1}'c; with c = W_c^{-1}xi they bring the initial state xi to zero at t_k. For constant Phi and G both sums have the same rank.")
