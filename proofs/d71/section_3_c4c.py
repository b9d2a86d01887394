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
from exactkf.evidence import example, induction, instances, order, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    function,
    given,
    hstack,
    inv,
    let,
    loewner,
    matrix,
    matrix_of,
    nonsingular,
    positive_definite,
    positive_semidefinite,
    psd,
    rational,
    rec,
    rows,
    scalar,
    schur,
    stein,
    sym,
    symbols,
    symmetric_matrix,
    vector,
    vstack,
    when,
)
from proofs.d71.fading import Fading, N, Pi, R
from proofs.d71.notation import H, K, M, P, Phi, V, gain, gram, i, j, n, p, step, update

S, B, D, Ha, Va, Pa, Pa0, Pae, t, E, e, a, P1, Acl = symbols("S B D Ha Va Pa Pa0 Pae t E e a P1 Acl")
STABLE = sym("L")
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

al, be, g1, g2 = symbols("alpha beta g1 g2")
NOISE = Phi*K*Va*T(K)*T(Phi) + Ha
PAIR = rows([[al, be], [-be, al]])
ONE = {"n": 1, "p": 1, "Phi": [[1]], "H": [[0]], "M": [[1]], "V": [[1]], "P": [[0]], "Ha": [[0]], "Va": [[0]], "Pa0": [[1]],
       "Acl": [[1]], "L": [["1/2"]], "alpha": 1, "beta": 0, "g1": [1], "g2": [0]}
#: the eigenvector g = g1 + i g2 of (B - PD)' or of Phi' for a + ib
TURNED_1, TURNED_2 = al*g1 - be*g2, be*g1 + al*g2
OUTSIDE = [given("eigenvector of (B - PD)'", (T(Acl)*g1 == TURNED_1) & (T(Acl)*g2 == TURNED_2)), given("|psi| >= 1", al**2 + be**2 >= 1)]
REST = al**2 + be**2 - 1
#: the terms of (|psi|^2 - 1) g*Pg + |psi|^2 g*PSPg + g*Hg = 0
SEEN = T(M)*inv(V)*M
SPREAD = [term for g in (g1, g2) for term in (REST*(T(g)*P*g), REST*(T(g)*P*SEEN*P*g), T(g)*P*T(M)*inv(V)*M*P*g, T(g)*H*g)]
TOTAL = SPREAD[0] + SPREAD[1] + SPREAD[2] + SPREAD[3] + SPREAD[4] + SPREAD[5] + SPREAD[6] + SPREAD[7]
CLOSED = D*P + PhiT
#: a stable filter: B - PD = 1/2
DRIVEN = {"Acl": [["1/2"]], "H": [["1/2"]], "P": [[1]], "alpha": "1/2"}
#: B - PD is not L, but 1, its inverse, a half of it, its transpose
OTHERS = [{"L": [[0]]}, {"Phi": [[2]], "Acl": [[2]]}, {"Phi": [["3/10"]], "Acl": [["3/10"]], "L": [["3/5"]], "Ha": [[1]], "Pa0": [[0]], "horizon": 10},
          {"n": 2, **dict.fromkeys(("H", "P", "Pa0"), [[0, 0], [0, 0]]), **dict.fromkeys(("Phi", "Acl"), [["1/4", 10], [0, "1/4"]]), "M": [[0, 0]],
           "L": [["1/4", 0], [10, "1/4"]], "Ha": [[0, 0], [0, 1]], "g1": [0, 0], "g2": [0, 0]}]
RATIO = 1/(2 + a[i]**2)


def _in_basis(entry):
    """E G for the diagonal matrix G of these entries."""
    return E*matrix_of(i, j, n, n, when(i == j, entry, 0))


#: what is shown first, and the terms that vanish with their sum
TOWARDS = [
    (T(B - P*D)*CLOSED == I, []), (T(Acl)*CLOSED == I, []), (CLOSED*T(Acl) == I, []), (T(Phi) == (I + S*P)*T(Acl), []),
    (P == Phi*P*T(Acl) + H, []), (P == Acl*(P + P*S*P)*T(Acl) + H, []),
    *((P*g == Acl*(P + P*S*P)*turned + H*g, []) for g, turned in ((g1, TURNED_1), (g2, TURNED_2))),
    *((T(g)*P*g == T(turned)*(P + P*S*P)*turned + T(g)*H*g, []) for g, turned in ((g1, TURNED_1), (g2, TURNED_2))),
    (TOTAL*Identity(1) == Zero(1, 1), []),
    *((S*P*g == Zero(n, 1), SPREAD) for g in (g1, g2)), *((H*g == Zero(n, 1), SPREAD) for g in (g1, g2))]
#: that g*P is psi g* times the rest is enough for the two forms
NEAREST = [within(0, P == step()), within(3, CLOSED*T(Acl) == I), within(4, P == step(), T(Phi) == (I + S*P)*T(Acl)),
           within(5, P == Phi*P*T(Acl) + H, T(Phi) == (I + S*P)*T(Acl)),
           *(within(8 + m, T(g)*Acl == T(turned), P*g == Acl*(P + P*S*P)*turned + H*g) for m, (g, turned) in enumerate(
               ((g1, TURNED_1), (g2, TURNED_2))))]
BETWEEN = Fading(STABLE, Pa0 + Pae)
gap, DISTANCE = sym("gap"), Pa[t] - Pae
APART = [2*N[t + 1]*(Pi[t + 1]*x*T(Pi[t + 1])) for x in (Pae, Pa0)]
#: the distance is at most R/(t + 1), and at least -R/(t + 1)
BELOW = [loewner(R, N[t]*gap(t)), loewner(R, -(N[t]*gap(t)))]


def _between(s):
    """The two as one block matrix."""
    return [rational("1/2")*vstack(I, -I)*(R - N[s]*gap(s))*hstack(I, -I), rational("1/2")*vstack(I, I)*(R - (-(N[s]*gap(s))))*hstack(I, I)]


ACTUAL_SUM = [(psd(Pae), [Phi*K*Va*T(K)*T(Phi), Ha])]

claim("D71-E3.246", "the actual error covariance has a limit",
      (vstack(T(Phi), H)*hstack(g1, g2) == block([[TURNED_1, TURNED_2], [Zero(n, 1), Zero(n, 1)]]))
      & ((Acl == STABLE) >> always(t, psd(block([[R, N[t]*gap(t)], [N[t]*gap(t), R]])))),
      sizes=["n", "p"],
      over={**SYSTEM, **ACTUAL, H: positive_semidefinite(n), P: positive_semidefinite(n), Pa0: positive_semidefinite(n),
            al: scalar(), be: scalar(), g1: vector(n), g2: vector(n), Acl: matrix(n, n), STABLE: matrix(n, n)},
      where=[*AT_EQUILIBRIUM, let(Pae, stein(STABLE, NOISE)), rec(Pa, t, Pa0, Acl*Pa[t]*T(Acl) + NOISE), function(gap, [t], DISTANCE), *BETWEEN.where],
      given=[EQUILIBRIUM, given("K = B - PD", Acl == B - P*D), *OUTSIDE, given("L is inside the unit circle", schur(STABLE))],
      by=[induction(also=[[], [*BETWEEN.also, DISTANCE == Pi[t]*(Pa0 - Pae)*T(Pi[t]), BETWEEN.bound, *BELOW]],
                    base=[order(*[[]]*20, *(terms for _, terms in TOWARDS[10:]), lemmas=[lemma for lemma, _ in TOWARDS], inside=NEAREST),
                          BETWEEN.begins([], BETWEEN.first, [R - BETWEEN.now, 2*Pae], [R - BETWEEN.now, 2*Pa0], _between(t), before=ACTUAL_SUM)],
                    step=[order(), BETWEEN.goes_on([], BETWEEN.then, *([R - BETWEEN.later, apart] for apart in APART), _between(t + 1),
                                                   before=ACTUAL_SUM)]),
          # P is no equilibrium; a driven mode, and one that is stable; what is not L
          example({**ONE, "H": [["1/2"]], "alpha": "3/2", "Acl": [["3/2"]]}), example({**ONE, "alpha": 2, "Acl": [[2]]}), example({**ONE, **DRIVEN}),
          example({**ONE, **DRIVEN, "L": [[0]], "g1": [0]}), example({**ONE, **DRIVEN, "g1": [0], "Ha": [[1]]}),
          example({**ONE, "Phi": [["1/2"]], "Acl": [["1/2"]], "g1": [0]}),
          example({**ONE, "Phi": [[2]], "Acl": [[2]], "L": [[2]], "g1": [0]}), *(example({**ONE, "g1": [0], **change}) for change in OTHERS),
          instances(8, n=(2,), p=(1, 2), horizon=2, using={e: vector(2), E: nonsingular(2)},
                    made_by={al: 1 + e[1]**2, be: e[2], Phi: T(E*PAIR*inv(E)), P: Zn, H: Zn, Ha: Zn, Pa0: Zn, Acl: B - P*D, STABLE: Zn,
                             g1: E*rows([[1], [0]]), g2: E*rows([[0], [1]])}),
          instances(8, n=(1, 2), p=(1, 2), horizon=2, using={E: nonsingular(n), a: vector(n), e: vector(n), x: vector(n)},
                    made_by={al: 1, be: 0, g1: Zero(n, 1), g2: Zero(n, 1),
                             Phi: _in_basis(RATIO*(1 + when(i <= p, e[i]**2, 0)))*inv(E), P: _in_basis(e[i]**2)*T(E),
                             M: matrix_of(i, j, p, n, when(i == j, 1, 0))*inv(E), V: Identity(p), **SOLVED, Acl: B - P*D, STABLE: B - P*D, Va: Zero(p, p),
                             Ha: _in_basis((1 - RATIO**2)**3)*T(E), Pa0: _in_basis(x[i]**2*(1 - RATIO**2)**2)*T(E)})],
      note="The first part: an eigenvector g1 + i g2 of (B - PD)' for a + ib on or outside the unit circle is an eigenvector of Phi' for the same number and a "
           "null vector of H, so that an unstable or random walk mode is undriven. Where there is no such mode, B - PD is inside the circle; g = 0 is allowed, "
           "so that nothing is assumed by this for the second part. "
           "P is a computed covariance and so nonnegative definite; at an equilibrium that is not, such as P = -1/2 for Phi = M = V = 1 and H = 1/2, B - PD "
           "may be outside the circle. The second part: L is any stable matrix; where B - PD is one, take it for L. stein(M, N) "
           "is the solution of X = MXM' + N, for M = L that of (3.246); the distance of P_a(t_k) from P_ae is between -R/(k + 1) and R/(k + 1), which the block matrix says, with R the "
           "same for all k: it tends to zero.")
