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
from exactkf.evidence import example, first, induction, instances, order, restated, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    given,
    hstack,
    inv,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_definite,
    positive_semidefinite,
    rec,
    rows,
    scalar,
    schur,
    standing,
    symbols,
    symmetric_matrix,
    vector,
    when,
)
from proofs.d71.notation import H, K, M, P, Phi, V, gain, gram, i, j, n, p, step, update

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
      Pae == P,
      sizes=["n", "p"], over={**SYSTEM, Pae: symmetric_matrix(n)}, where=[*AT_EQUILIBRIUM, let(Acl, B - P*D)],
      given=[EQUILIBRIUM, given("B - PD is inside the circle", schur(Acl)), given("(3.246)", Pae - Acl*Pae*T(Acl) == Phi*K*V*T(K)*T(Phi) + H)],
      by=[order(inside=[within(0, unique=(Acl, T(Acl)))]),
          example(n=1, p=1, Phi=[[1]], H=[["1/2"]], M=[[1]], V=[[1]], P=[[1]], Pae=[[2]]),
          example(n=1, p=1, Phi=[[1]], H=[["1/2"]], M=[[1]], V=[[1]], P=[["-1/2"]], Pae=[["-1/2"]]),
          example(n=1, p=1, Phi=[[1]], H=[[0]], M=[[1]], V=[[1]], P=[[0]], Pae=[[2]]),
          example(n=1, p=1, Phi=[["1/2"]], H=[[3]], M=[[0]], V=[[1]], P=[[5]], Pae=[[4]]),
          instances(8, n=(1, 2), p=(1, 2), using={E: nonsingular(n), a: vector(n), e: vector(n)},
                    made_by={Phi: E*matrix_of(i, j, n, n, when(i == j, 1/(2 + a[i]**2), 0))*inv(E), P: E*matrix_of(i, j, n, n, when(i == j, e[i]**2, 0))*T(E),
                             M: matrix_of(i, j, p, n, when(i == j, 1, 0))*inv(E), V: Identity(p), **SOLVED, Pae: P})],
      note="(3.246) for H_a = H and V_a = V has the solution P, and no other if B - PD is inside the unit circle.")

al, be, g1, g2, y1, y2 = symbols("alpha beta g1 g2 y1 y2")
NOISE = Phi*K*Va*T(K)*T(Phi) + Ha
PAIR = rows([[al, be], [-be, al]])
#: eigenvectors g of DP - C = inv(Phi')(SP + I), and the terms of (1 - |psi|^2) g*Pg + g*Rg = 0
ONE = {"n": 1, "p": 1, "Phi": [[1]], "H": [[0]], "M": [[1]], "V": [[1]], "P": [[0]], "Ha": [[0]], "Va": [[0]], "Pa0": [[1]], "Pae": [[0]],
       "alpha": 1, "beta": 0, "g1": [1], "g2": [0], "y1": [1], "y2": [0]}
CLOSED = D*P + PhiT
PSI_G = {y1: al*g1 - be*g2, y2: be*g1 + al*g2}
REST = 1 - (al**2 + be**2)
SPREAD = [term for g, y_ in ((g1, y1), (g2, y2)) for term in (REST*T(g)*P*g, T(g)*P*T(M)*inv(V)*M*P*g, T(y_)*H*y_)]
TOTAL = SPREAD[0] + SPREAD[1] + SPREAD[2] + SPREAD[3] + SPREAD[4] + SPREAD[5]
#: what is shown first, and the terms that vanish with their sum
TOWARDS = [
    (P*CLOSED == Phi*P + H*CLOSED, []),
    ((P*y1 == Phi*P*g1 + H*y1) & (P*y2 == Phi*P*g2 + H*y2), []),
    ((T(Phi)*y1 == S*P*g1 + g1) & (T(Phi)*y2 == S*P*g2 + g2), []),
    *((T(y_)*P*y_ == T(g)*P*g + T(g)*P*S*P*g + T(y_)*H*y_, []) for g, y_ in ((g1, y1), (g2, y2))),
    (T(y1)*P*y1 + T(y2)*P*y2 == (al**2 + be**2)*(T(g1)*P*g1 + T(g2)*P*g2), []), (TOTAL*Identity(1) == Zero(1, 1), []),
    *((S*P*g == Zero(n, 1), SPREAD) for g in (g1, g2)), *((H*y_ == Zero(n, 1), SPREAD) for y_ in (y1, y2))]

claim("D71-E3.246", "the actual error covariance has a limit",
      (T(Phi)*y1 == g1) & (T(Phi)*y2 == g2) & (H*y1 == Zero(n, 1)) & (H*y2 == Zero(n, 1)) & always(t, Pa[t] - Pae == Pi[t]*(Pa0 - Pae)*T(Pi[t])),
      sizes=["n", "p"],
      over={**SYSTEM, **ACTUAL, H: positive_semidefinite(n), P: positive_semidefinite(n), Pa0: positive_semidefinite(n), Pae: symmetric_matrix(n),
            al: scalar(), be: scalar(), g1: vector(n), g2: vector(n), y1: vector(n), y2: vector(n)},
      where=[*AT_EQUILIBRIUM, let(Acl, B - P*D), rec(Pi, t, I, Acl*Pi[t]), rec(Pa, t, Pa0, Acl*Pa[t]*T(Acl) + NOISE)],
      given=[EQUILIBRIUM, standing("psi g", (y1 == al*g1 - be*g2) & (y2 == be*g1 + al*g2)), given("(3.246)", Pae - Acl*Pae*T(Acl) == NOISE),
             given("eigenvector of DP - C", (CLOSED*g1 == y1) & (CLOSED*g2 == y2)),
             given("|psi| <= 1", al**2 + be**2 <= 1)],
      by=[restated("The powers of a matrix with its eigenvalues inside the unit circle tend to zero."),
          induction(before=[first(lemma, base=order(terms)) for lemma, terms in TOWARDS]),
          # a driven mode, and one that is stable
          example({**ONE, "H": [["1/2"]], "P": [[1]], "alpha": 2, "y1": [2]}),
          example({**ONE, "Phi": [["1/2"]], "alpha": 2, "y1": [2], "Ha": [["3/4"]], "Pae": [[1]]}),
          example({**ONE, "alpha": "1/2", "y1": ["1/2"]}), example({**ONE, "H": [["1/2"]]}),
          example({**ONE, "Phi": [[2]], "Pae": [[1]], "alpha": "1/2", "y1": ["1/2"]}),
          instances(8, n=(2,), p=(1, 2), horizon=2, using={e: vector(2), E: nonsingular(2)},
                    made_by={al: e[1]/(1 + T(e)*e), be: e[2]/(1 + T(e)*e), Phi: inv(T(E*PAIR*inv(E))), P: Zn, H: Zn, Ha: Zn, Pae: Zn,
                             g1: E*rows([[1], [0]]), g2: E*rows([[0], [1]]), **PSI_G}),
          instances(8, n=(2,), p=(1, 2), horizon=2, using={e: vector(2), a: vector(2)},
                    made_by={al: e[1]/(1 + T(e)*e), be: e[2]/(1 + T(e)*e), Phi: inv(T(PAIR)), P: Zn, H: Zn, Pae: -a[1]**2*I, Ha: a[1]**2*(Phi*T(Phi) - I),
                             g1: rows([[a[1]], [-a[2]]]), g2: rows([[a[2]], [a[1]]]), **PSI_G}),
          instances(8, n=(1, 2), p=(1, 2), horizon=2, using={E: nonsingular(n), a: vector(n), e: vector(n)},
                    made_by={al: 0, be: 0, g1: Zero(n, 1), g2: Zero(n, 1), **PSI_G,
                             Phi: E*matrix_of(i, j, n, n, when(i == j, 1/(1 + a[i]**2), 0))*inv(E), P: E*matrix_of(i, j, n, n, when(i == j, e[i]**2, 0))*T(E),
                             M: matrix_of(i, j, p, n, when(i == j, 1, 0))*inv(E), V: Identity(p), **SOLVED,
                             Ha: E*matrix_of(i, j, n, n, when(i == j, 1 + e[i]**2, 0))*T(E), Va: Zero(p, p),
                             Pae: E*matrix_of(i, j, n, n, when(i == j, (1 + e[i]**2)/(1 - 1/((1 + a[i]**2)*(1 + when(i <= p, e[i]**2, 0)))**2), 0))*T(E)})],
      note="psi = a + ib and g = g1 + i g2. If B - PD, the conjugate inverse of DP - C, had an eigenvalue on or outside the circle, DP - C would have one "
           "with |psi| <= 1, and then y = psi g would be an eigenvector of Phi' at 1/psi and a null vector of H: an undriven random walk or unstable mode. "
           "P is a computed covariance and so nonnegative definite; at an equilibrium that is not, such as P = -1/2 for Phi = M = V = 1 and H = 1/2, B - PD "
           "may be outside the circle. The last part is the distance from the limit P_ae, of (3.246); with the powers of B - PD it tends to zero.")
