# SPDX-License-Identifier: MIT
"""The actual error covariance of a filter with wrong covariances (Chapter III, section C.4.c).

A filter that is designed for H, V and P_0 runs on a process with H_a, V_a. Its gain K_k comes
from the computed P_k, but its error obeys e_{k+1} = Phi[(I - K_k M)e_k + K_k dy_k] - h_k with
the actual noise, so that the actual covariance follows a linear equation. At an equilibrium P
the matrix Phi(I - KM) is B - PD, and the equation has constant coefficients: its solutions
tend to the one equilibrium P_ae if B - PD is inside the unit circle. That is so if P >= 0 and
no unstable or random walk mode is undriven. With the right H and V the limit is P.
"""

from exactkf.claims import claim
from exactkf.evidence import example, instances, steps
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    given,
    hstack,
    inv,
    kernel_basis,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_definite,
    positive_semidefinite,
    rec,
    schur,
    sum_of,
    symbols,
    symmetric_matrix,
    vector,
    when,
)
from proofs.d71.notation import H, K, M, P, Phi, V, gain, gram, i, j, k, n, p, step, update

S, B, D, Ha, Va, Pa, Pa0, Pae, t, Pi, E, e, a, P1, Acl = symbols("S B D Ha Va Pa Pa0 Pae t Pi E e a P1 Acl")
x, xh, dy, h, y, x1, xh1 = symbols("x xh dy h y x1 xh1")
Rd, Nd, Lamd = symbols("Rd Nd Lamd")
I, Zn = Identity(n), Zero(n, n)
PhiT = inv(T(Phi))
COEFFICIENTS = [let(S, gram()), let(B, H*PhiT*S + Phi), let(D, PhiT*S)]
SYSTEM = {Phi: nonsingular(n), H: symmetric_matrix(n), M: matrix(p, n), V: positive_definite(p), P: symmetric_matrix(n)}
ACTUAL = {Ha: positive_semidefinite(n), Va: positive_semidefinite(p)}
MORE = {"n": (1, 2, 3), "p": (1, 2)}
EQUILIBRIUM = given("P is an equilibrium", P == step())
SOLVED = {H: P - Phi*update()*T(Phi)}

claim("D71-E3.241", "the error of the filter on the actual process",
      xh1 - x1 == Phi*((I - K*M)*(xh - x) + K*dy) - h,
      sizes=["n", "p"], over={Phi: matrix(n, n), M: matrix(p, n), K: matrix(n, p), x: vector(n), xh: vector(n), h: vector(n), dy: vector(p)},
      where=[let(y, M*x + dy), let(x1, Phi*x + h), let(xh1, Phi*(xh + K*(y - M*xh)))], by=[instances(**MORE)])

ERRORS = hstack(Phi*(I - K*M), Phi*K, -I)

claim("D71-E3.242", "the actual error covariance",
      (ERRORS*block([[Pa, Zero(n, p), Zn], [Zero(p, n), Va, Zero(p, n)], [Zn, Zero(n, p), Ha]])*T(ERRORS)
       == Phi*((I - K*M)*Pa*T(I - K*M) + K*Va*T(K))*T(Phi) + Ha),
      sizes=["n", "p"], over={**ACTUAL, Phi: matrix(n, n), M: matrix(p, n), K: matrix(n, p), Pa: positive_semidefinite(n)}, by=[instances(**MORE)],
      note="The left side is the covariance of the right side of (3.241) with uncorrelated e, dy and h; the gain may be any K.")

claim("D71-E3.244", "the matrix of the filter at an equilibrium",
      Phi*(I - K*M) == B - P*D,
      sizes=["n", "p"], over={**SYSTEM, P: matrix(n, n)}, where=[*COEFFICIENTS, let(K, gain())], given=[EQUILIBRIUM],
      by=[instances(**MORE, using={P: symmetric_matrix(n)}, made_by=SOLVED)])

claim("D71-E3.244.1", "the matrix of the filter in general",
      Phi*(I - K*M) == B - P1*D,
      sizes=["n", "p"], over={**SYSTEM, P: matrix(n, n)}, where=[*COEFFICIENTS, let(K, gain()), let(P1, step())], by=[instances(**MORE)],
      note="P is P_k and P1 is P_{k+1}.")

AT_EQUILIBRIUM = [*COEFFICIENTS, let(K, gain())]

claim("D71-E3.245", "the actual error covariance at an equilibrium",
      Phi*((I - K*M)*Pa*T(I - K*M) + K*Va*T(K))*T(Phi) + Ha == (B - P*D)*Pa*T(B - P*D) + Phi*K*Va*T(K)*T(Phi) + Ha,
      sizes=["n", "p"], over={**SYSTEM, **ACTUAL, Pa: positive_semidefinite(n)}, where=AT_EQUILIBRIUM, given=[EQUILIBRIUM],
      by=[instances(**MORE, made_by=SOLVED)],
      note="The left side is (3.242) with the gain K of the equilibrium.")

claim("D71-S64", "with the right covariances the limit is P",
      P - (B - P*D)*P*T(B - P*D) == Phi*K*V*T(K)*T(Phi) + H,
      sizes=["n", "p"], over=SYSTEM, where=AT_EQUILIBRIUM, given=[EQUILIBRIUM], by=[instances(**MORE, made_by=SOLVED)],
      note="P solves (3.246) for H_a = H and V_a = V, and the solution of (3.246) is unique if B - PD is inside the unit circle.")

UNDRIVEN_PART = [let(Rd, sum_of(k, 0, n - 1, Phi**k*H*T(Phi**k))), let(Nd, kernel_basis(Rd)), let(Lamd, inv(T(Nd)*Nd)*T(Nd)*T(Phi)*Nd)]
NOISE = Phi*K*Va*T(K)*T(Phi) + Ha

claim("D71-E3.246", "the actual error covariance has a limit",
      schur(B - P*D) & always(t, Pa[t] - Pae == Pi[t]*(Pa0 - Pae)*T(Pi[t])),
      sizes=["n", "p"],
      over={**SYSTEM, **ACTUAL, H: positive_semidefinite(n), P: positive_semidefinite(n), Pa0: positive_semidefinite(n), Pae: symmetric_matrix(n)},
      where=[*AT_EQUILIBRIUM, *UNDRIVEN_PART, let(Acl, B - P*D), rec(Pi, t, I, Acl*Pi[t]), rec(Pa, t, Pa0, Acl*Pa[t]*T(Acl) + NOISE)],
      given=[EQUILIBRIUM, given("undriven modes are stable", schur(Lamd)), given("(3.246)", Pae - Acl*Pae*T(Acl) == NOISE)],
      by=[steps("D71-E3.103", "D71-E3.105", "D71-E3.165", "D71-E3.245",
                facts=["The powers of a matrix whose eigenvalues lie inside the unit circle tend to zero."],
                prose="B - PD is the conjugate inverse of DP - C. If DP - C had an eigenvalue psi with |psi| <= 1 and eigenvector gamma, then (3.103) would "
                      "give gamma*R gamma = 0, hence H gamma = 0 and Phi' gamma = gamma/psi: an undriven mode on or outside the circle. Subtract (3.246) from "
                      "(3.245)."),
          example(n=1, p=1, Phi=[[2]], H=[[0]], M=[[1]], V=[[1]], P=[[0]], Ha=[[1]], Va=[[0]], Pa0=[[1]], Pae=[["-1/3"]]),
          instances(8, n=(1, 2), p=(1, 2), horizon=2, using={E: nonsingular(n), a: vector(n), e: vector(n)},
                    made_by={Phi: E*matrix_of(i, j, n, n, when(i == j, 1/(1 + a[i]**2), 0))*inv(E), P: E*matrix_of(i, j, n, n, when(i == j, e[i]**2, 0))*T(E),
                             M: matrix_of(i, j, p, n, when(i == j, 1, 0))*inv(E), V: Identity(p), **SOLVED,
                             Ha: E*matrix_of(i, j, n, n, when(i == j, 1 + e[i]**2, 0))*T(E), Va: Zero(p, p),
                             Pae: E*matrix_of(i, j, n, n, when(i == j, (1 + e[i]**2)/(1 - 1/((1 + a[i]**2)*(1 + when(i <= p, e[i]**2, 0)))**2), 0))*T(E)})],
      note="P is a computed covariance and so nonnegative definite; at an equilibrium that is not, such as P = -1/2 for Phi = M = V = 1 and H = 1/2, B - PD "
           "may be outside the circle. The second part is the distance from the limit; with the powers of B - PD it tends to zero.")
