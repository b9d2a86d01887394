# SPDX-License-Identifier: MIT
"""Order of equilibria and singular equilibria (Chapter III, section C.3.c, end).

Two nonnegative equilibria whose matrices J differ in one eigenvalue only, psi and 1/psi* with
|psi| > 1: Gamma_a*(P_a - P_b)Gamma_a has a single entry d, and (|psi|^2 - 1)d is
(f_a - P_b gamma_a)*M'(MP_bM' + V)^{-1}M(f_a - P_b gamma_a), a square if MP_bM' + V > 0. That it is
so at every Hermitian equilibrium follows from the signatures of [[MPM' + V, MP], [PM', P]].

An undriven mode inside the circle makes every nonnegative equilibrium singular, because
n*Pn = |lambda|^2 n*Qn <= |lambda|^2 n*Pn with the covariance Q after the measurement.

Conventions as in section_3_c3c.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, instances, order, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    diag,
    eq,
    given,
    hstack,
    inv,
    invertible,
    let,
    loewner,
    matrix,
    matrix_of,
    nonsingular,
    nonzero,
    pd,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    rows,
    scalar,
    standing,
    sym,
    symbols,
    symmetric_matrix,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import H, M, P, Phi, V, gram, i, j, n, p, step, update

q, N, Lam, S, Rp, E, X = symbols("q N Lam S Rp E X")
c, d, e, l, w, B, D2 = symbols("c d e l w B D2")
I, Zn = Identity(n), Zero(n, n)
PhiT = inv(T(Phi))

MODEL = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}
R_WHERE = [let(S, gram()), let(Rp, block([[H*PhiT*S + Phi, H*PhiT], [PhiT*S, PhiT]]))]
UNDRIVEN = [given("(3.60)", T(Phi)*N == N*T(Lam)), given("(3.61)", H*N == Zero(n, q))]
FIRST = matrix_of(i, j, n, q, when(i == j, 1, 0))
MORE = {"n": (1, 2, 3), "p": (1, 2)}
EQUILIBRIUM = given("(3.46)", P == step())
SOLVED = {H: P - Phi*update()*T(Phi)}

# --- two equilibria that differ in one eigenvalue -------------------------------------------------------------------------

fa, ga, F2, Ga2, Pa, Pb, psi, k, k2 = symbols("fa ga F2 Ga2 Pa Pb psi k k2")
r = sym("r")
DIFFERENCE = {Pa: symmetric_matrix(n), Pb: symmetric_matrix(n), fa: matrix(n, r), ga: matrix(n, r), F2: matrix(n, n - r), Ga2: matrix(n, n - r)}
COLUMNS = [given("(3.124)", (Pa*ga == fa) & (Pa*Ga2 == F2)), given("(3.125)", Pb*Ga2 == F2)]
#: E = [gamma_a, Gamma_2]; the difference has rank r and is seen by gamma_a only
SEEN = {Pa: Pb + T(inv(E))*diag(B, Zero(n - r, n - r))*inv(E), ga: matrix_of(i, j, n, r, E[i, j]), Ga2: matrix_of(i, j, n, n - r, E[i, j + r]),
        fa: Pa*ga, F2: Pb*Ga2}
GAMMA_A = hstack(ga, Ga2)

claim("D71-E3.127", "the difference of two equilibria in the basis of one",
      T(GAMMA_A)*(Pa - Pb)*GAMMA_A == block([[T(ga)*(fa - Pb*ga), Zero(r, n - r)], [Zero(n - r, r), Zero(n - r, n - r)]]),
      sizes=["n", "r"], over=DIFFERENCE, given=COLUMNS,
      by=[instances(n=(2, 3), r=(1,), using={E: nonsingular(n), B: symmetric_matrix(r)}, made_by=SEEN),
          example(n=2, r=1, Pa=[[1, 0], [0, 1]], Pb=[[1, 0], [0, 3]], fa=[1, 0], ga=[1, 0], F2=[0, 1], Ga2=[0, 1])],
      note="gamma_a has one column, or r of them. P_a and P_b are symmetric; their columns are (3.124) and (3.125) multiplied by Gamma_a and Gamma_b.")

claim("D71-E3.128", "the equilibrium equation through M'V^{-1}M",
      P == Phi*P*inv(I + S*P)*T(Phi) + H,
      sizes=["n", "p"], over={Phi: nonsingular(n), H: symmetric_matrix(n), M: matrix(p, n), V: positive_definite(p), P: matrix(n, n)},
      where=[let(S, gram())], given=[EQUILIBRIUM], by=[instances(**MORE, made_by=SOLVED, using={P: symmetric_matrix(n)}), instances(**MORE)])

ONE_PAIR = given("(3.126)", Rp*vstack(fa, ga) == vstack(fa, ga)*psi)
PAIR_OVER = {**MODEL, fa: matrix(n, r), ga: matrix(n, r), psi: matrix(r, r)}
ALL_PAIRS = {"using": {E: nonsingular(r)},
             "made_by": {fa: matrix_of(i, j, n, r, E[i, j]), ga: matrix_of(i, j, n, r, E[i + n, j]),
                         psi: inv(E)*block([[H*PhiT*gram() + Phi, H*PhiT], [PhiT*gram(), PhiT]])*E}}

claim("D71-E3.129", "both halves of the eigenvector equation",
      (ga*psi == PhiT*(T(M)*inv(V)*M*fa + ga)) & (fa*psi == H*ga*psi + Phi*fa),
      sizes=["n", "p", "r"], over=PAIR_OVER, where=R_WHERE, given=[ONE_PAIR],
      by=[instances(n=(1, 2), p=(1, 2), r=(2, 4), **ALL_PAIRS)],
      note="psi_1 stands on the right, as a matrix, so that f and gamma may have several columns.")

GAP = T(ga)*(fa - Pb*ga)
INNOVATION = T(M)*inv(M*Pb*T(M) + V)*M
SQUARED = (T(fa) - T(ga)*Pb)*INNOVATION*(fa - Pb*ga)
EQ_B = given("P_b is an equilibrium", Pb == step(Pb))
SYSTEM_B = {Phi: nonsingular(n), H: symmetric_matrix(n), M: matrix(p, n), V: positive_definite(p), Pb: symmetric_matrix(n),
            fa: matrix(n, r), ga: matrix(n, r), psi: matrix(r, r)}
SOLVED_B = {H: Pb - Phi*update(Pb)*T(Phi)}

claim("D71-E3.131", "the gap times |psi|^2 - 1",
      eq(T(psi)*GAP*psi - GAP,
         (T(fa)*S + T(ga))*(fa - Pb*inv(S*Pb + I)*(S*fa + ga)) - T(ga)*fa + T(ga)*Pb*ga,
         SQUARED),
      sizes=["n", "p", "r"], over=SYSTEM_B, where=R_WHERE, given=[ONE_PAIR, EQ_B],
      by=[instances(n=(1, 2), p=(1, 2), r=(2, 4), using=ALL_PAIRS["using"], made_by={**SOLVED_B, **ALL_PAIRS["made_by"]})],
      note="For a number psi_1 the left side is (psi* psi - 1)d. The primes on M and the index of gamma_1 = gamma_a are read into the scan.")

claim("D71-S49", "the matrix inversion lemma for M'(MPM' + V)^{-1}M",
      T(M)*inv(M*P*T(M) + V)*M == S - S*P*inv(S*P + I)*S,
      sizes=["n", "p"], over={P: matrix(n, n), M: matrix(p, n), V: nonsingular(p)}, where=[let(S, gram())],
      by=[instances(**MORE)])

# the theorem: |psi|^2 - 1 = beta* beta, and all of these numbers commute
beta = sym("beta")
THEOREM = {**DIFFERENCE, **{k_: v_ for k_, v_ in SYSTEM_B.items() if k_.tree[1] not in ("fa", "ga")}, k: matrix(r, n), k2: matrix(n - r, n),
           beta: nonsingular(r)}
ABOVE_ONE = given("|psi_1| > 1", T(psi)*psi == Identity(r) + T(beta)*beta)
COMMUTE = [standing("numbers commute: psi", T(psi)*GAP*psi == GAP*T(psi)*psi), standing("numbers commute: beta", GAP*T(beta)*beta == T(beta)*GAP*beta)]
INVERSE_A = given("Gamma_a is nonsingular", (ga*k + Ga2*k2 == I) & (k*ga == Identity(r)) & (k*Ga2 == Zero(r, n - r))
                  & (k2*ga == Zero(n - r, r)) & (k2*Ga2 == Identity(n - r)))
RAISED = T(k)*inv(T(beta))*(T(fa - Pb*ga)*INNOVATION*(fa - Pb*ga))*inv(beta)*k

PSI = {psi: rows([[(1 + e**2)/(1 - e**2)]]), beta: rows([[2*e/(1 - e**2)]])}

#: undriven, phi = 5/3: the equilibria 16/9 and 0
GROWING = {"n": 1, "p": 1, "r": 1, "Phi": [["5/3"]], "H": [[0]], "M": [[1]], "V": [[1]], "Pa": [["16/9"]], "Pb": [[0]], "fa": [["16/9"]], "ga": [[1]],
           "F2": [[]], "Ga2": [[]], "psi": [["5/3"]], "beta": [["4/3"]], "k": [[1]], "k2": []}

# the theorem as it is printed: each of the two has a basis of its own; a real psi_1
Gla, Glb, psi1, rest, nd = symbols("Gla Glb psi1 rest nd")
OTHERS = matrix_of(i, j, n - 1, n - 1, when(i == j, rest[i], 0))
WITH_PSI = {**MODEL, Pa: positive_semidefinite(n), Pb: positive_semidefinite(n), Gla: nonsingular(n), Glb: nonsingular(n), psi1: scalar(),
            rest: vector(n - 1), nd: vector(n)}
ASSOCIATED = [given("P_a is an equilibrium", Pa == step(Pa)), EQ_B,
              given("P_a belongs to (3.122)", Rp*vstack(Pa*Gla, Gla) == vstack(Pa*Gla, Gla)*diag(psi1, OTHERS)),
              given("P_b belongs to (3.123)", Rp*vstack(Pb*Glb, Glb) == vstack(Pb*Glb, Glb)*diag(1/psi1, OTHERS)),
              given("psi_1 is unstable", psi1**2 > 1),
              given("it is an undriven mode", (T(Phi)*nd == psi1*nd) & (H*nd == Zero(n, 1)) & (nd != Zero(n, 1))),
              given("which is observable", rank(vstack(Phi - psi1*I, M)) == n)]
#: three undriven modes 2: the equilibria are 3 times the orthogonal projections
TRIPLE_MODE = {"n": 3, "p": 3, "Phi": [[2, 0, 0], [0, 2, 0], [0, 0, 2]], "H": [[0, 0, 0], [0, 0, 0], [0, 0, 0]],
               "M": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "V": [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
               "Pa": [[0, 0, 0], [0, 3, 0], [0, 0, 3]], "Pb": [[3, 0, 0], [0, 0, 0], [0, 0, 0]],
               "Gla": [[0, 0, 1], [1, 0, 0], [0, 1, 0]], "Glb": [[0, 1, 0], [1, 0, 0], [0, 0, 1]], "psi1": 2, "rest": [2, "1/2"], "nd": [1, 0, 0]}

claim("D71-T3.19", "the eigenvalue outside the unit circle gives the larger equilibrium",
      loewner(Pa, Pb),
      sizes=["n", "p"], over=WITH_PSI, where=R_WHERE, given=ASSOCIATED,
      by=[example(TRIPLE_MODE), instances(n=(1,), p=(1,))],
      repair=repair(
          "missing hypothesis", "the two must share the eigenvectors of psi_2, ..., psi_n, as they do if R_p is nonderogatory; the proof takes this for granted",
          loewner(Pa, Pb),
          sizes=["n", "p", "r"], over={**THEOREM, Pb: positive_semidefinite(n)}, where=R_WHERE,
          given=[*COLUMNS, ONE_PAIR, EQ_B, ABOVE_ONE, *COMMUTE, INVERSE_A],
          by=[order([], [], [], [RAISED], lemmas=[T(beta)*GAP*beta == SQUARED, Pa - Pb == T(k)*GAP*k, GAP == inv(T(beta))*SQUARED*inv(beta)]),
              example(GROWING), example({**GROWING, "Pa": [[-1]]}), example({**GROWING, "Pa": [[-1]], "fa": [[0]], "ga": [[0]]}),
              example({**GROWING, "Phi": [["3/5"]], "psi": [["3/5"]], "Pa": [["-16/25"]], "fa": [["-16/25"]]}),
              example(n=2, p=2, r=1, Phi=[["5/3", 0], [0, 1]], H=[[0, 0], [0, "1/2"]], M=[[1, 0], [0, 1]], V=[[1, 0], [0, 1]], Pa=[["16/9", 0], [0, -5]],
                      Pb=[[0, 0], [0, 1]], fa=["16/9", 0], ga=[1, 0], F2=[0, -5], Ga2=[0, 1], psi=[["5/3"]], beta=[["4/3"]], k=[[1, 0]], k2=[[0, 1]]),
              instances(8, n=(1,), p=(1, 2), r=(1,), using={e: scalar(), l: nonzero()},
                        made_by={**PSI, Phi: rows([[(1 + e**2)/(1 - e**2)]]), H: Zero(1, 1), V: Identity(p), M: matrix_of(i, j, p, 1, l), Pb: Zero(1, 1),
                                 Pa: rows([[(psi**2 - 1)/(p*l**2)]]), ga: rows([[e]]), fa: Pa*ga, F2: Zero(1, 0), Ga2: Zero(1, 0), k: inv(ga), k2: Zero(0, 1)}),
              instances(8, n=(2,), p=(2,), r=(1,), using={E: nonsingular(2), e: scalar(), w: scalar()},
                        made_by={**PSI, Phi: E*diag((1 + e**2)/(1 - e**2), 1)*inv(E), H: E*diag(0, (w**2)*(1 - 1/(1 + w**2)))*T(E), V: Identity(2), M: inv(E),
                                 Pb: E*diag(0, w**2)*T(E), Pa: E*diag((2*e/(1 - e**2))**2, w**2)*T(E), ga: inv(T(E))*rows([[1], [0]]),
                                 Ga2: inv(T(E))*rows([[0], [1]]), fa: Pa*ga, F2: Pb*Ga2, k: rows([[1, 0]])*T(E), k2: rows([[0, 1]])*T(E)})]),
      note="With Phi = 2I, H = 0, M = V = I and n = 3 every equilibrium is 3 times an orthogonal projection; one on a plane and one on a line outside it are "
           "associated with diag(2, 2, 1/2) and diag(1/2, 2, 1/2), and neither is above the other. The theorem does not ask that R_p be nonderogatory, as "
           "Theorems 3.13, 3.14 and 3.17 do. Of its other hypotheses the repair uses |psi_1| > 1, that P_a and P_b are Hermitian and that P_b is a "
           "nonnegative equilibrium. beta is any number with |beta|^2 = |psi_1|^2 - 1, and k the first rows of the inverse of Gamma_a.")

MODEL_ANY = {**MODEL, P: matrix(n, n)}

INNOVATION = M*P*T(M) + V
GAIN = inv(INNOVATION)*M*P
#: [[MPM' + V, MP], [PM', P]] is congruent to diag(V, P), by [[I, M], [0, I]], and to diag(MPM' + V, Q), by its Schur complement Q; and P is at least Phi Q Phi'
NO_NEGATIVE_EIGENVALUE = order([H], [inv(INNOVATION)], [INNOVATION], lemmas=[psd(INNOVATION), invertible(INNOVATION)], inside=[within(0, inertia=(
    block([[Identity(p), -GAIN], [T(M), Identity(n) - T(M)*GAIN]]), V, P, T(Phi), P - P*T(M)*GAIN))])

claim("D71-Q3", "MPM' + V at every equilibrium",
      pd(M*P*T(M) + V),
      sizes=["n", "p"], over=MODEL_ANY, given=[EQUILIBRIUM],
      by=[example(n=2, p=1, Phi=[[2, 1], [0, -3]], H=[["5/3", 0], [0, 0]], M=[[1, 1]], V=[[1]], P=[[3, -10], [0, 0]]), instances(n=(1,), p=(1,))],
      repair=repair(
          "missing hypothesis", "an equilibrium that is not Hermitian can have MPM' + V < 0; for every Hermitian one MPM' + V is positive definite",
          pd(M*P*T(M) + V),
          sizes=["n", "p"], over={**MODEL, P: symmetric_matrix(n)}, given=[EQUILIBRIUM],
          by=[NO_NEGATIVE_EIGENVALUE,
              example(n=1, p=1, Phi=[[1]], H=[[0]], M=[[1]], V=[[1]], P=[[-2]]),
              instances(n=(1, 2, 3), p=(1, 2, 3), using={E: nonsingular(n), d: vector(n), w: scalar()},
                        made_by={Phi: matrix_of(i, j, n, n, when(i == j, 1, 0)), M: matrix_of(i, j, p, n, when(i == j, 1, 0))*inv(E), V: Identity(p),
                                 P: E*matrix_of(i, j, n, n, when((i == j) & (i <= p), when(d[i] > 0, d[i], 1/(1 - d[i]) - 1), 0))*T(E), **SOLVED})]),
      note="The footnote offers it as a guess from numerical examples. The counterexample has p = 1 and MPM' + V = -6; its J has the eigenvalues 3 and 1/3.")

POSITIVE_B = given("MP_bM' + V > 0", pd(M*Pb*T(M) + V))

claim("D71-Q3.1", "Theorem 3.19 without undriven modes, if MPM' + V > 0",
      loewner(Pa, Pb),
      sizes=["n", "p"], over={name: kind for name, kind in WITH_PSI.items() if name is not nd}, where=R_WHERE, given=[*ASSOCIATED[:-2], POSITIVE_B],
      by=[example({name: value for name, value in TRIPLE_MODE.items() if name != "nd"}), instances(n=(1,), p=(1,))],
      repair=repair(
          "missing hypothesis", "as in D71-T3.19, the two must share the eigenvectors of psi_2, ..., psi_n; then |psi_1| > 1 suffices",
          loewner(Pa, Pb),
          sizes=["n", "p", "r"], over={**THEOREM, V: symmetric_matrix(p)}, where=R_WHERE,
          given=[*COLUMNS, ONE_PAIR, EQ_B, POSITIVE_B, ABOVE_ONE, *COMMUTE, INVERSE_A],
          by=[order([], [], [], [RAISED], lemmas=[T(beta)*GAP*beta == SQUARED, Pa - Pb == T(k)*GAP*k, GAP == inv(T(beta))*SQUARED*inv(beta)]),
              example(GROWING), example({**GROWING, "Pa": [[-1]]}), example({**GROWING, "Pa": [[-1]], "fa": [[0]], "ga": [[0]]}),
              example({**GROWING, "Phi": [["3/5"]], "psi": [["3/5"]], "Pa": [["-16/25"]], "fa": [["-16/25"]]}),
              # the driven pair 2/3 and -2/5, and the same with V < 0
              example({**GROWING, "Phi": [[1]], "H": [["4/15"]], "Pa": [["2/3"]], "Pb": [["-2/5"]], "fa": [["2/3"]]}),
              example({**GROWING, "V": [[-1]], "Pa": [["-16/9"]], "fa": [["-16/9"]]}),
              example(n=2, p=2, r=1, Phi=[["5/3", 0], [0, 1]], H=[[0, 0], [0, "1/2"]], M=[[1, 0], [0, 1]], V=[[1, 0], [0, 1]], Pa=[["16/9", 0], [0, -5]],
                      Pb=[[0, 0], [0, 1]], fa=["16/9", 0], ga=[1, 0], F2=[0, -5], Ga2=[0, 1], psi=[["5/3"]], beta=[["4/3"]], k=[[1, 0]], k2=[[0, 1]]),
              instances(8, n=(1,), p=(1, 2), r=(1,), using={e: scalar(), l: nonzero()},
                        made_by={**PSI, Phi: Identity(1), H: rows([[(psi[1, 1] - 1)*(1 - 1/psi[1, 1])/(p*l**2)]]), V: Identity(p), M: matrix_of(i, j, p, 1, l),
                                 Pb: rows([[(1/psi[1, 1] - 1)/(p*l**2)]]),
                                 Pa: rows([[(psi[1, 1] - 1)/(p*l**2)]]), ga: rows([[e]]), fa: Pa*ga, F2: Zero(1, 0), Ga2: Zero(1, 0), k: inv(ga),
                                 k2: Zero(0, 1)})]),
      note="The footnote's claim, with its premise as a hypothesis on the smaller equilibrium. The counterexample is that of D71-T3.19, where MPM' + V is "
           "positive definite for every Hermitian equilibrium. In the repair P_b need not be nonnegative, and the mode may be driven.")

# --- an undriven stable mode ------------------------------------------------------------------------------------------------

Qe = sym("Qe")
MODE_P = {Phi: nonsingular(n), H: symmetric_matrix(n), M: matrix(p, n), V: positive_definite(p), P: symmetric_matrix(n), N: matrix(n, q),
          Lam: matrix(q, q), Qe: symmetric_matrix(n)}
LOST = P*T(M)*inv(M*P*T(M) + V)*M*P
#: the equilibrium equation in its two steps
TWO_STEPS = [given("(1.24)", Qe == P - LOST), given("(1.25)", P == Phi*Qe*T(Phi) + H)]
#: with a P that does not vanish on N: undriven and unstable, phi = 5/3 and P = 16/9, and a stable one with the negative P = -16/25
UNSTABLE = {"n": 1, "p": 1, "q": 1, "Phi": [["5/3"]], "H": [[0]], "M": [[1]], "V": [[1]], "P": [["16/9"]], "N": [[2]], "Lam": [["5/3"]], "Qe": [["16/25"]]}
NEGATIVE = {**UNSTABLE, "Phi": [["3/5"]], "Lam": [["3/5"]], "P": [["-16/25"]], "Qe": [["-16/9"]]}
#: two coordinates alike, in another basis
DOUBLE = instances(6, n=(1, 2), p=(1, 2), q=(1,), using={E: nonsingular(n), e: scalar(), c: nonzero()},
                   made_by={Phi: E*(e*I)*inv(E), H: Zn, V: c**2*Identity(p), M: matrix_of(i, j, p, n, when((i == 1) & (j == 1), c, 0))*inv(E),
                            P: E*matrix_of(i, j, n, n, when((i == 1) & (j == 1), e**2 - 1, 0))*T(E), N: inv(T(E))*FIRST, Lam: e*Identity(q), Qe: update()})

#: the driven equilibrium 1 = 1/2 + 1/2
DRIVEN_ONE = example({**UNSTABLE, "Phi": [[1]], "H": [["1/2"]], "P": [[1]], "Lam": [[1]], "Qe": [["1/2"]]})
#: a Q that is not the update of P
HALF_DONE = example({**UNSTABLE, "P": [["25/9"]], "Qe": [[1]]})

claim("D71-E3.132", "the equilibrium equation on an undriven mode",
      eq(T(N)*P*N, T(N)*(Phi*(P - LOST)*T(Phi) + H)*N, Lam*T(N)*(P - LOST)*N*T(Lam)),
      sizes=["n", "p", "q"], over=MODE_P, given=[*TWO_STEPS, *UNDRIVEN],
      by=[example(UNSTABLE), example(NEGATIVE), DRIVEN_ONE, HALF_DONE, DOUBLE],
      note="For a number lambda the last term is (lambda* lambda) n*[...]n. The prime on the second Phi is read into the scan.")

claim("D71-E3.133", "its two sides",
      T(N)*P*N - Lam*T(N)*P*N*T(Lam) == -Lam*T(N)*LOST*N*T(Lam),
      sizes=["n", "p", "q"], over=MODE_P,
      given=[given("(3.132)", T(N)*P*N == Lam*T(N)*(P - LOST)*N*T(Lam))],
      by=[example(UNSTABLE), example(NEGATIVE), DOUBLE])

SMALL_MODE = {**MODEL, P: positive_semidefinite(n), N: matrix(n, q), Lam: matrix(q, q), beta: nonsingular(q), Qe: symmetric_matrix(n)}
INSIDE = given("|lambda| < 1", Lam*T(Lam) + beta*T(beta) == Identity(q))
ALIKE = [standing("numbers commute: lambda", Lam*T(N)*P*N*T(Lam) == T(N)*P*N*Lam*T(Lam)),
         standing("numbers commute: beta", beta*T(N)*P*N*T(beta) == T(N)*P*N*beta*T(beta))]
VANISH = [beta*T(N)*P*N*T(beta), Lam*T(N)*P*T(M)*inv(M*P*T(M) + V)*M*P*N*T(Lam)]
#: (3.132), (3.133), the numbers put together, and a sum of two nonnegative matrices that vanishes
DOWN = [T(N)*P*N == Lam*T(N)*Qe*N*T(Lam), T(N)*P*N - Lam*T(N)*P*N*T(Lam) == -Lam*T(N)*LOST*N*T(Lam),
        beta*T(N)*P*N*T(beta) == T(N)*P*N - Lam*T(N)*P*N*T(Lam), (VANISH[0] + VANISH[1])*Identity(q) == Zero(q, q),
        P*N*T(beta) == Zero(n, q)]
INSIDE_MADE = {"using": {E: nonsingular(n), e: scalar(), D2: nonsingular(n - q), X: positive_semidefinite(n - q), c: scalar()},
               "made_by": {Lam: rows([[(1 - e**2)/(1 + e**2)]]), beta: rows([[2*e/(1 + e**2)]]),
                           Phi: E*diag((1 - e**2)/(1 + e**2), (1/(2 + c**2))*Identity(n - q))*inv(E), P: E*diag(Zero(q, q), X)*T(E), N: inv(T(E))*FIRST,
                           Qe: update(), H: P - Phi*update()*T(Phi)}}
#: each breaks one hypothesis
STABLE = {**UNSTABLE, "P": [[1]], "Qe": [["1/2"]], "Lam": [["3/5"]], "beta": [["4/5"]]}
BROKEN = [example({**UNSTABLE, "beta": [[1]]}), example({**UNSTABLE, "Lam": [["3/5"]], "beta": [["4/5"]]}),
          example({**STABLE, "Phi": [["3/5"]], "H": [["41/50"]]}), example({**STABLE, "Phi": [["3/5"]]}),
          example({**STABLE, "Phi": [["3/5"]], "Qe": [["25/9"]]})]

#: a nonnegative equilibrium and an undriven stable mode: P N = 0
UNDRIVEN_STABLE = {"sizes": ["n", "p", "q"], "over": SMALL_MODE, "given": [*TWO_STEPS, *UNDRIVEN, INSIDE, *ALIKE],
                   "by": [order([], [], [], [], VANISH, [inv(T(beta))], lemmas=DOWN), *BROKEN, instances(n=(1, 2, 3), p=(1, 2), q=(1,), **INSIDE_MADE)]}

claim("D71-T3.20", "an undriven stable mode makes a nonnegative equilibrium singular",
      P*N == Zero(n, q), **UNDRIVEN_STABLE,
      note="N is the vector n_d, and beta any number with |beta|^2 = 1 - |lambda|^2. As n_d is not zero, P is singular.")

# --- the cross-reference in the proof ---------------------------------------------------------------------------------------

Gp, Jp = symbols("Gp Jp")
SIDES_142 = [given("(3.142)", (T(M)*inv(V)*M*(Phi*Qe*T(Phi) + H) + I)*Gp == T(Phi)*Gp*Jp), given("P = Phi Q Phi' + H", P == Phi*Qe*T(Phi) + H)]

claim("D71-S50", "the two sides of the equation that is cited are zero",
      T(Phi)*Gp*Jp == Zn,
      sizes=["n", "p"], over={**MODEL, P: positive_semidefinite(n), Qe: positive_semidefinite(n), Gp: nonsingular(n), Jp: matrix(n, n)}, given=SIDES_142,
      by=[example(n=1, p=1, Phi=[["1/2"]], H=[[0]], M=[[1]], V=[[1]], P=[[0]], Qe=[[0]], Gp=[[1]], Jp=[[2]]), instances(n=(1,), p=(1,))],
      repair=repair(
          "cross-reference", "the equation with a nonnegative left and a nonpositive right side is (3.133); (3.142) belongs to the next section",
          (T(N)*P*N - Lam*T(N)*P*N*T(Lam) == Zero(q, q)) & (Lam*T(N)*LOST*N*T(Lam) == Zero(q, q)) & (P*N == Zero(n, q)),
          sizes=["n", "p", "q"], over=SMALL_MODE, given=[*TWO_STEPS, *UNDRIVEN, INSIDE, *ALIKE],
          by=[order([], [], [], [], VANISH, [inv(T(beta))], VANISH, [inv(T(beta))], lemmas=DOWN),
              *BROKEN,
              instances(n=(1, 2, 3), p=(1, 2), q=(1,), **INSIDE_MADE)]),
      note="Read as printed: (3.142) has two sides that are both zero. Its right side is nonsingular if J is. The counterexample has the stable undriven mode "
           "1/2 and the equilibrium 0.")
