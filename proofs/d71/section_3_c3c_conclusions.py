# SPDX-License-Identifier: MIT
"""Which equilibria there are: the general conclusions (Chapter III, end of section C.3.c).

Let psi be an eigenvalue of DP - C with the vector gamma, (I + SP)gamma = psi Phi'gamma. For an
equilibrium P >= 0

    (1 - |psi|^2)gamma*P gamma + gamma*PSP gamma + |psi|^2 gamma*H gamma = 0,

so inside the circle P gamma, H gamma psi are zero and Phi'gamma = gamma/psi: an undriven unstable mode, and P
is singular.

The random walk modes are shown for one state: R_p is then [[1 + hs, h], [s, 1]], up to the sign of
Phi, with s = m^2/v.
"""

from exactkf.claims import claim
from exactkf.evidence import evaluation, example, identity, instances, order, part, restated, within
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    block,
    charpoly,
    circle_roots,
    given,
    hstack,
    inside_roots,
    inv,
    let,
    matrix,
    nonsingular,
    nonzero,
    outside_roots,
    positive,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    rational,
    rows,
    scalar,
    schur,
    symbols,
    symmetric,
    symmetric_matrix,
    vector,
    vstack,
)
from proofs.d71.notation import H, M, P, Phi, V, gram, n, p, step
from proofs.d71.section_3_c3c_order import UNDRIVEN_STABLE, N
from proofs.d71.section_3_c3c_order import q as mode

q, r, F, Gam, J, S, Rp, G1, G2, F1, nd, s, x, m, v, h, psi, g = symbols("q r F Gam J S Rp G1 G2 F1 nd s x m v h psi gamma")
I = Identity(n)
PhiT = inv(T(Phi))
MODEL = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}
R_WHERE = [let(S, gram()), let(Rp, block([[H*PhiT*S + Phi, H*PhiT], [PhiT*S, PhiT]]))]

claim("D71-E3.97", "Q in blocks",
      T(hstack(G1, G2))*P*hstack(G1, G2) == block([[T(G1)*F1, Zero(q, r)], [Zero(r, q), Zero(r, r)]]), sizes=["n", "q", "r"],
      over={P: symmetric_matrix(n), F1: matrix(n, q), G1: matrix(n, q), G2: matrix(n, r)},
      given=[given("P Gamma = F, F_2 = 0", P*hstack(G1, G2) == hstack(F1, Zero(n, r)))],
      by=[order(), example(n=1, q=1, r=1, P=[[1]], F1=[[0]], G1=[[1]], G2=[[1]]),
          example(n=2, q=1, r=1, P=[[1, 0], [0, 0]], F1=[[2], [0]], G1=[[2], [1]], G2=[[0], [1]]),
          example(n=2, q=1, r=1, P=[[1, 2], [2, 4]], F1=[[5], [10]], G1=[[1], [2]], G2=[[2], [-1]]),
          instances(6, n=(1, 2, 3), q=(1, 2), r=(1, 2), made_by={G2: Zero(n, r), F1: P*G1})])

#: the family (3.115) at x = 7
OUT = rows([[rational("16/3") + rational("28/3") - rational("4/27")*49, 8 + 7 - rational("2/9")*49], [8 + 7 - rational("2/9")*49, 12 - rational("49/3")]])
claim("D71-S39", "derogatory R_p",
      (step(P) == P) & symmetric(P) & (charpoly(PhiT*(S*P + Identity(2))) == (Z - 2)*(Z - rational("1/2"))) & (rank(Rp - Identity(4)/2) == 2) & ~psd(P),
      where=[let(Phi, rows([[2, -1], [0, rational("1/2")]])), let(H, rows([[4, 6], [6, 9]])), let(M, rows([[-1, rational("2/3")]])), let(V, rows([[1]])),
             *R_WHERE,
             let(P, OUT)], by=[evaluation(), part("that the conditions do not suffice, by one example")],
      note="Example 3.1, where R_p is derogatory, and its equilibrium (3.115) with x = 7: J has the eigenvalues 2, outside the circle, and 1/2, the "
           "reciprocal of the eigenvalue of the undriven mode 2, as Theorem 3.17 asks; P is not nonnegative definite. So its conditions do not suffice. "
           "That they are necessary, and that eigenvalues outside the circle alone suffice, is D71-S44 and D71-S42.")

claim("D71-S41", "half of the eigenvalues of R_p are outside",
      (inside_roots(charpoly(Rp)) == n) & (outside_roots(charpoly(Rp)) == n), sizes=["n", "p"], over=MODEL, where=R_WHERE,
      given=[given("no undriven or unobservable random walk mode", circle_roots(charpoly(Rp)) == 0)],
      by=[example(n=1, p=1, Phi=[[1]], H=[[0]], M=[[1]], V=[[1]]), example(n=2, p=1, Phi=[[1, 0], [0, 2]], H=[[0, 0], [0, 0]], M=[[1, 1]], V=[[1]]),
          instances(8, n=(1, 2, 3), p=(1, 2))],
      note="By Theorem 3.12 such modes are the eigenvalues of R_p on the circle. A J with the n eigenvalues outside is permitted.")

AFTER = Phi*inv(I + P*S)
#: J'QJ - Q for Q = F'Gamma
FORM = [T(F)*T(M)*inv(V)*M*F, T(S*F + Gam)*inv(Phi)*H*PhiT*(S*F + Gam)]
claim("D71-S42", "the equilibrium with all eigenvalues of J outside",
      psd(F*inv(Gam)) & ((S*F + Gam)*inv(J) == T(Phi)*Gam) & (P == F*inv(Gam)),
      sizes=["n", "p"], over={**MODEL, F: matrix(n, n), Gam: nonsingular(n), J: nonsingular(n), P: matrix(n, n)}, where=R_WHERE,
      given=[given("R_p T = TJ", Rp*vstack(F, Gam) == vstack(F, Gam)*J), given("J is outside the circle", schur(inv(J))),
             given("P is an equilibrium", P == AFTER*P*T(Phi) + H), given("P is stable", schur(AFTER))],
      by=[order([], [], [], [T(inv(J))*term*inv(J) for term in FORM], [], [T(inv(Gam))*(T(F)*Gam)*inv(Gam)], [], [],
                lemmas=[S*F + Gam == T(Phi)*Gam*J, F*J == H*Gam*J + Phi*F, T(F)*Gam - T(Gam)*F == Zero(n, n), psd(T(F)*Gam), F - P*Gam == Zero(n, n)],
                inside=[within(2, unique=(T(inv(J)), inv(J))), within(3, stein=T(inv(J))), within(4, unique=(AFTER, inv(J)))]),
          restated("an equilibrium P is stable exactly if the eigenvalues of Phi(I - KM) are inside the unit circle, where R_p has none on it"),
          *(example({"n": 1, "p": 1, "Phi": [[1]], "H": [["1/2"]], "M": [[1]], "V": [[1]], "F": [[1]], "Gam": [[1]], "J": [[2]], "P": [[1]], **change})
            for change in ({}, {"F": [["-1/2"]], "J": [["1/2"]]}, {"F": [["-1/2"]]}, {"P": [["-1/2"]]}, {"P": [[2]]})),
          instances(8, n=(1, 2), p=(1, 2), using={g: positive_definite(n), x: matrix(n, n)},
                    made_by={H: g - Phi*inv(inv(g) + gram())*T(Phi), F: g*Gam, J: inv(Gam)*PhiT*(gram()*g + I)*Gam, P: g})],
      note="Symmetric and nonnegative definite; Phi(I - KM) is Phi(I + PS)^{-1}, which the second equation shows to be similar to the adjoint of J^{-1} at "
           "F Gamma^{-1}; and any equilibrium P with a stable Phi(I + PS)^{-1} is this one.")

claim("D71-S43", "a stable undriven mode makes the equilibrium singular",
      P*N == Zero(n, mode), **UNDRIVEN_STABLE,
      note="As D71-T3.20: the vector of the mode, which is not zero, is a null vector of every nonnegative equilibrium.")

EQUILIBRIUM = given("P is an equilibrium", P == Phi*P*inv(I + gram()*P)*T(Phi) + H)
g1, g2, a, b = symbols("g1 g2 a b")
#: Re and Im of gamma psi
H1, H2 = a*g1 - b*g2, b*g1 + a*g2
LOSS = [r*T(g1)*P*g1, r*T(g2)*P*g2, T(g1)*P*gram()*P*g1, T(g2)*P*gram()*P*g2, T(H1)*H*H1, T(H2)*H*H2]
#: the form that vanishes for each part of the conclusion
IN_TURN = [T(x)*half*x for half, pair in ((P, (g1, g2)), (H, (H1, H2)), (P, (g1, g2))) for x in pair]
NONE = Zero(n, 1)
REAL = {"n": 1, "p": 1, "Phi": [[2]], "H": [[0]], "M": [[1]], "V": [[1]], "P": [[0]], "g1": [1], "g2": [0], "a": "1/2", "b": 0, "r": "3/4"}
PLANE = {**REAL, "n": 2, "Phi": [[2, 0], [0, 3]], "H": [[0, 0], [0, 0]], "M": [[1, 1]], "P": [[0, 0], [0, 0]], "g1": [1, 0], "g2": [0, 0]}
claim("D71-S44", "other nonnegative equilibria need undriven unstable modes",
      (P*g1 == NONE) & (P*g2 == NONE) & (H*H1 == NONE) & (H*H2 == NONE) & (T(Phi)*H1 == g1) & (T(Phi)*H2 == g2), sizes=["n", "p"],
      over={**MODEL, P: positive_semidefinite(n), g1: vector(n), g2: vector(n), a: scalar(), b: scalar(), r: positive()}, where=[let(S, gram())],
      given=[EQUILIBRIUM, given("gamma at psi", (g1 + S*P*g1 == T(Phi)*H1) & (g2 + S*P*g2 == T(Phi)*H2)),
             given("inside the circle", a**2 + b**2 == 1 - r)],
      by=[order([], [], [], *(terms for form in IN_TURN for terms in (LOSS, [form])),
                lemmas=[T(H1)*P*H1 == T(g1)*(I + P*gram())*P*g1 + T(H1)*H*H1, T(H2)*P*H2 == T(g2)*(I + P*gram())*P*g2 + T(H2)*H*H2,
                        LOSS[0] + LOSS[1] + LOSS[2] + LOSS[3] + LOSS[4] + LOSS[5] == Zero(1, 1)],
                inside=[within(3 + number, form == Zero(1, 1)) for number, form in enumerate(IN_TURN)]),
          restated("another equilibrium has such a psi: by D71-S42 not all are outside the circle, and by D71-T3.12 none is on it"),
          instances(4, n=(1, 2), p=(1,), made_by={Phi: 2*I, H: Zero(n, n), P: Zero(n, n), a: rational("1/2"), b: 0, r: rational("3/4")}),
          *(example({**REAL, **change}) for change in (
              {}, {"P": [[3]], "a": 2}, {"Phi": [["1/2"]], "H": [[1]], "M": [[0]], "P": [[1]]}, {"H": [[3]], "M": [[0]], "P": [[-1]]})),
          *(example({**PLANE, **change}) for change in (
              {}, {"M": [[0, 1]], "P": [[0, 0], [0, 8]]},
              {"p": 2, "Phi": [[2, 1], [0, 3]], "M": [[1, 0], [0, 1]], "V": [[1, 0], [0, 1]], "g1": [1, -1]},
              {"Phi": [[1, 2], [-2, 1]], "g2": [0, 1], "a": "1/5", "b": "2/5", "r": "4/5"},
              {"Phi": [[1, 2], [-2, 1]], "g2": [0, -1], "a": "1/5", "b": "-2/5", "r": "4/5"}))],
      note="gamma = g1 + i g2 is an eigenvector of DP - C at an eigenvalue psi = a + ib of J inside the circle, not zero as J is nonsingular. Then "
           "H gamma psi = 0 and Phi' gamma psi = gamma: psi is the conjugate reciprocal of the eigenvalue of an undriven mode, which is unstable, and "
           "P gamma = 0, so that P is singular. Without such eigenvalues the equilibrium is that of D71-S42.")

# --- one random walk mode --------------------------------------------------------------------------------------------------

ONE = [let(Rp, rows([[1 + h*m**2/v, h], [m**2/v, 1]]))]
REST = Rp - Identity(2)
ONLY_ONE = "For one state, Phi = 1. "
ONE_STATE = part("one state, with Phi = 1")
claim("D71-S45", "an undriven observable random walk mode",
      (charpoly(Rp) == (Z - 1)**2) & (rank(REST) == 1) & (x - x*v/(m**2*x + v) == m**2*x**2/(m**2*x + v)), over={m: nonzero(), v: positive(), x: scalar()},
      where=[let(h, 0), *ONE],
      by=[ONE_STATE, instances(8)],
      note=ONLY_ONE + "R_p has one Jordan block of order two at 1, and x is an equilibrium exactly if m^2x^2 = 0, that is x = 0.")

claim("D71-S46", "a driven unobservable random walk mode",
      (charpoly(Rp) == (Z - 1)**2) & (rank(REST) == 1) & (x + h - x == h), over={h: positive(), v: positive(), x: scalar()}, where=[let(m, 0), *ONE],
      by=[ONE_STATE, instances(8)],
      note=ONLY_ONE + "R_p has one Jordan block of order two at 1, and x, which is x + h at the next instant, is never an equilibrium.")

claim("D71-S47", "a random walk mode that is neither driven nor observable",
      (Rp == Identity(2)) & (step(P) == P), sizes=["n"], over={v: positive(), P: symmetric_matrix(n)},
      where=[let(m, 0), let(h, 0), *ONE, let(Phi, I), let(H, Zero(n, n)), let(M, Zero(1, n)), let(V, Identity(1))],
      by=[identity(n=(1, 2, 3)), ONE_STATE, instances(8, n=(1, 2, 3))],
      note=ONLY_ONE + "R_p is the identity, and every symmetric P is an equilibrium, also for n such states.")
