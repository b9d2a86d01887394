# SPDX-License-Identifier: MIT
"""The continuous-time filter, and processes that are sampled (Chapter I, section A).

With any gain L the error of the filter obeys de/dt = (A - LM)e + L dy - h, and its covariance
dP/dt = (A - LM)P + P(A - LM)' + H + LVL'. Completing the square in L, the right side is least
for L = PM'V^{-1}, which gives the Riccati equation.

Solutions of dx/dt = Ax + h are written with a fundamental matrix F, dF/dt = AF, through which
the transition matrix is Phi(t, s) = F(t)F(s)^{-1}: x = Fc with dc/dt = F^{-1}h, and the covariance
of the part due to h is FCF' with dC/dt = F^{-1}H(F')^{-1}. The derivatives of these products show
that they solve what they should.
"""

from exactkf.claims import claim, not_checked
from exactkf.evidence import instances, order, restated
from exactkf.language import T, inv, let, matrix, nonsingular, positive_definite, symbols, symmetric_matrix, vector
from proofs.d71.notation import H, K, M, P, V, n, p

A, L, F, C, R, c, h, x, dF, dc, dC = symbols("A L F C R c h x dF dc dC")
DEFINITION = "a definition: it fixes notation and asserts nothing"
OF_COVARIANCES = restated("the covariance X of dx/dt = Ax + w with a white w of intensity W changes by dX/dt = AX + XA' + W")
BY_DERIVATIVE = "a function is determined by its derivative and its value at one instant"

not_checked("D71-E1.1", "the process in continuous time", DEFINITION)
not_checked("D71-E1.2", "white noise in continuous time", DEFINITION)
not_checked("D71-E1.4", "the measurements in continuous time", DEFINITION)

FILTER = {"sizes": ["n", "p"], "over": {A: matrix(n, n), P: symmetric_matrix(n), H: symmetric_matrix(n), M: matrix(p, n), V: positive_definite(p)}}


def rate(gain):
    """dP/dt of the filter with this gain."""
    return (A - gain*M)*P + P*T(A - gain*M) + H + gain*V*T(gain)


OPTIMAL = [let(K, P*T(M)*inv(V))]
claim("D71-E1.10", "the gain makes the covariance grow least",
      rate(L) == rate(K) + (L - K)*V*T(L - K), sizes=["n", "p"], over={**FILTER["over"], L: matrix(n, p)}, where=OPTIMAL,
      by=[order(), OF_COVARIANCES, instances(6, n=(1, 2), p=(1, 2))],
      note="The gain is a definition; the content checked is that any other gain L adds a nonnegative term to dP/dt.")

claim("D71-E1.12", "the Riccati equation",
      rate(K) == A*P + P*T(A) + H - P*T(M)*inv(V)*M*P, **FILTER, where=OPTIMAL,
      by=[order(), OF_COVARIANCES, instances(6, n=(1, 2), p=(1, 2))],
      note="The left side is the rate at which the covariance of de/dt = (A - KM)e + K dy - h changes.")

not_checked("D71-E1.13", "the process in discrete time", DEFINITION)

MOVING = {A: matrix(n, n), F: nonsingular(n)}
claim("D71-E1.30", "the state by its transition matrix",
      dF*c + F*dc == A*x + h, sizes=["n"], over={**MOVING, c: vector(n), h: vector(n)}, where=[let(x, F*c), let(dF, A*F), let(dc, inv(F)*h)],
      by=[order(), restated(BY_DERIVATIVE, "a linear differential equation has one solution through a state"), instances(6, n=(1, 2, 3))],
      note="c is F(t_k)^{-1}x(t_k) plus the integral of F^{-1}h, so that x = Fc is the printed right side, and the left side is its derivative. At t_k the "
           "integral is zero and x = x(t_k).")

not_checked("D71-E1.31", "the sampled process", DEFINITION)
not_checked("D71-S1", "transition matrices are nonsingular", "that a solution of dF/dt = AF stays nonsingular is a theorem on differential equations; "
                                                             "nothing of it is an exact computation")

claim("D71-E1.33", "the covariance of the sampled noise",
      dF*C*T(F) + F*dC*T(F) + F*C*T(dF) == A*R + R*T(A) + H, sizes=["n"], over={**MOVING, C: symmetric_matrix(n), H: symmetric_matrix(n)},
      where=[let(R, F*C*T(F)), let(dF, A*F), let(dC, inv(F)*H*inv(T(F)))],
      by=[order(), OF_COVARIANCES, restated(BY_DERIVATIVE), instances(6, n=(1, 2, 3))],
      note="R = FCF' is the printed integral up to t, if C is the integral of F^{-1}H(F')^{-1}. It solves the equation of the covariance of a process that "
           "starts from zero at t_k; the step from the double integral, by the delta function, is not stated here.")
