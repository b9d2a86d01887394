# SPDX-License-Identifier: MIT
"""Existence, symmetry, definiteness and ordering of solutions (Chapter III, sections A and B).

The covariance equation divides by MPM' + V at every instant, so the first
question is when that matrix is invertible. For P >= 0 it is at least V, hence
invertible if V > 0; for a singular V >= 0 it may vanish, as P = 0, V = 0 shows.

The symmetric form of the update writes the next covariance as
Phi[(I - KM)P(I - KM)' + KVK']Phi' + H, a sum of terms that are nonnegative when
P, V and H are. That settles symmetry and nonnegativity. It also shows what a
null vector z of the next covariance does when V > 0: each term vanishes on it,
so Hz = 0, K'Phi'z = 0 and then PPhi'z = 0. Carried back to the start, this puts
Phi'(t_m, t_{k+1})z into the null space of every H_k, which a process that is
completely driven by t_m forbids. To stay positive definite afterwards the
covariance needs an invertible Phi or more noise: with Phi_m = 0 and H_m = 0 the
next covariance is zero.

For the order of two solutions the update is shifted into P + eps I, where it is
the inverse of (P + eps I)^{-1} + M'V^{-1}M and visibly monotone; the difference to
the update of P is a multiple of eps.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import Evidence, example, first, identity, induction, instances, order
from exactkf.language import (
    Expr,
    Identity,
    T,
    Zero,
    always,
    defined,
    eq,
    forall,
    function,
    given,
    inv,
    invertible,
    let,
    loewner,
    matrix,
    nonsingular,
    pd,
    positive_definite,
    positive_semidefinite,
    psd,
    rec,
    sequence_of,
    signal_of,
    standing,
    sum_of,
    sym,
    symbols,
    symmetric_matrix,
    vector,
)
from proofs.d71.notation import (
    COVARIANCE,
    P0,
    TRANSITION,
    VARYING,
    H,
    K,
    M,
    N,
    P,
    Phi,
    Tr,
    V,
    annihilating,
    gain,
    gram,
    joseph,
    k,
    n,
    p,
    slices,
    step,
    varying_step,
)

I = Identity(n)
z, m, c = symbols("z m c")
RUN = {"n": (1, 2), "p": (1, 2), "N": (1, 4)}
WHERE = [*VARYING, COVARIANCE]

#: data without end, for statements about every k
ENDLESS = {Phi: signal_of(matrix(n, n), 0), M: signal_of(matrix(p, n), 0), H: signal_of(positive_semidefinite(n), 0),
           V: signal_of(positive_semidefinite(p), 0)}
FOREVER = {"n": (1, 2), "p": (1, 2), "horizon": 2}
V_POSITIVE_EVER = {**ENDLESS, V: signal_of(positive_definite(p), 0)}
GAIN_K = gain(P[k], M[k], V[k])
#: the next covariance as a sum of nonnegative terms
JOSEPH_K = [Phi[k]*(I - GAIN_K*M[k])*P[k]*T(I - GAIN_K*M[k])*T(Phi[k]), Phi[k]*GAIN_K*V[k]*T(GAIN_K)*T(Phi[k]), H[k]]

# --- existence -------------------------------------------------------------------------------------------------------

S = sym("S")
INNOVATION_K = M[k]*P[k]*T(M[k]) + V[k]
step_k = varying_step(P[k], k)
INNOVATION = function(S, [k], M(k)*P[k]*T(M(k)) + V(k))
EXISTS = forall(k, 1, N, invertible(S(k - 1))) & forall(k, 0, N, defined(P[k]))

claim("D71-S18", "a solution up to P_N exists",
      EXISTS, sizes=["n", "p", "N"], over={**slices(N), P0: positive_semidefinite(n)}, where=[*WHERE, INNOVATION],
      by=[example(n=1, p=1, N=1, P0=[[0]], PhiW=[[1]], MW=[[1]], GW=[[1]], WW=[[0]]), instances(**RUN)],
      repair=repair(
          "missing hypothesis", "V_k >= 0 allows P_0 = 0 and V_0 = 0, where MPM' + V is zero; V_k > 0 is needed",
          always(k, psd(P[k]) & pd(INNOVATION_K)),
          sizes=["n", "p"], over={**V_POSITIVE_EVER, P0: positive_semidefinite(n)}, where=[COVARIANCE],
          by=[induction(base=order([P0], [M[k]*P0*T(M[k]), V[k]]), step=order(JOSEPH_K, [M[k + 1]*step_k*T(M[k + 1]), V[k + 1]])),
              instances(8, **FOREVER)]),
      note="H_k = G_k G_k' and V_k = W_k W_k' run over all nonnegative definite matrices. "
           "That the solution is unique while every MPM' + V is invertible is how a recursion is read.")

# --- symmetry and definiteness ---------------------------------------------------------------------------------------

claim("D71-T3.1", "symmetry is kept",
      always(k, T(P[k]) == P[k]),
      sizes=["n", "p"], over={**ENDLESS, P0: symmetric_matrix(n)}, where=[COVARIANCE],
      by=[instances(8, **FOREVER)])

claim("D71-E3.1", "the covariance equation in symmetric form",
      step() == Phi*(joseph(K))*T(Phi) + H,
      sizes=["n", "p"],
      over={P: symmetric_matrix(n), M: matrix(p, n), V: symmetric_matrix(p), Phi: matrix(n, n), H: symmetric_matrix(n)},
      where=[let(K, gain())],
      by=[identity(n=range(1, 4), p=(1,)), instances(n=range(1, 4), p=range(1, 4))])

claim("D71-T3.2", "nonnegative definiteness is kept",
      always(k, psd(P[k])),
      sizes=["n", "p"], over={**ENDLESS, P0: positive_semidefinite(n)}, where=[COVARIANCE],
      by=[induction(base=order([P0]), step=order(JOSEPH_K)),
          instances(8, **FOREVER)],
      note="V_k >= 0 may be singular as long as MPM' + V is not.")

# --- completely driven processes -------------------------------------------------------------------------------------

P1, P2, Y, Y1, Y2, y = symbols("P1 P2 Y Y1 Y2 y")
Phi0, Phi1, M0, M1, V0, V1, H0, H1, K0, K1 = symbols("Phi0 Phi1 M0 M1 V0 V1 H0 H1 K0 K1")
Zn, Zp = Zero(n, 1), Zero(p, 1)
w = T(Phi)*z

TERMS = [T(z)*Phi*(I - K*M)*P*T(I - K*M)*T(Phi)*z, T(z)*Phi*K*V*T(K)*T(Phi)*z, T(z)*H*z]
SUM_ZERO = (TERMS[0] + TERMS[1] + TERMS[2])*Identity(1) == Zero(1, 1)

claim("D71-E3.2", "a null vector of the next covariance, one step back",
      (H*z == Zn) & (T(K)*T(Phi)*z == Zp) & (P*T(Phi)*z == Zn),
      sizes=["n", "p"],
      over={P: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p), Phi: matrix(n, n),
            H: positive_semidefinite(n), z: vector(n)},
      where=[let(K, gain()), let(P1, Phi*(joseph(K))*T(Phi) + H)],
      given=[given("z'P_m z = 0", T(z)*P1*z == 0)],
      by=[order([], TERMS, [inv(V)], TERMS, TERMS,
                lemmas=[SUM_ZERO, V*T(K)*T(Phi)*z == Zp, T(K)*T(Phi)*z == Zp, P*T(I - K*M)*T(Phi)*z == Zn]),
          instances(n=(2, 4), p=(1, 4), using={Y: matrix(n, n), Y1: matrix(n, n)},
                    made_by={P: annihilating(w, Y, Y1), H: annihilating(z, Y1, Y)})],
      note="P_m is written in the symmetric form, so that the hypothesis is the displayed sum of three terms.")

TWO_STEPS = {
    P: positive_semidefinite(n), z: vector(n),
    Phi0: matrix(n, n), M0: matrix(p, n), V0: positive_definite(p), H0: positive_semidefinite(n),
    Phi1: matrix(n, n), M1: matrix(p, n), V1: positive_definite(p), H1: positive_semidefinite(n),
}
FROM_TWO = [let(P1, step(P, Phi0, M0, V0, H0)), let(P2, step(P1, Phi1, M1, V1, H1)), let(K0, gain(P, M0, V0))]
w1, w0 = T(Phi1)*z, T(Phi0)*(T(Phi1)*z)
GAIN_1 = gain(P1, M1, V1)


def two_terms(phi: Expr, kk: Expr, pp: Expr, mm: Expr, vv: Expr, hh: Expr) -> list[Expr]:
    """The next covariance as a sum of nonnegative terms."""
    return [phi*(I - kk*mm)*pp*T(I - kk*mm)*T(phi), phi*kk*vv*T(kk)*T(phi), hh]


LAST, FORMER = two_terms(Phi1, GAIN_1, P1, M1, V1, H1), two_terms(Phi0, K0, P, M0, V0, H0)
#: one step back, P_{m-1} at Phi_{m-1}'z; and another
WAY_BACK = [psd(P1), V1*T(GAIN_1)*w1 == Zp, T(GAIN_1)*w1 == Zp, P1*T(I - GAIN_1*M1)*w1 == Zn, P1*w1 == Zn,
            V0*T(K0)*w0 == Zp, T(K0)*w0 == Zp, P*T(I - K0*M0)*w0 == Zn]

claim("D71-S19", "a null vector carried back two steps",
      (H0*T(Phi1)*z == Zn) & (T(K0)*T(Phi0)*z == Zp) & (P*T(Phi0)*z == Zn),
      sizes=["n", "p"], over=TWO_STEPS, where=FROM_TWO, given=[given("P_m z = 0", P2*z == Zn)],
      by=[example(n=2, p=1, P=[[1, 0], [0, 0]], z=[1, 0], Phi0=[[1, 0], [0, 1]], Phi1=[[0, 1], [1, 0]], M0=[[0, 0]],
                  M1=[[0, 0]],
                  V0=[[1]], V1=[[1]], H0=[[0, 0], [0, 0]], H1=[[0, 0], [0, 0]]),
          instances(n=range(1, 4), p=range(1, 3))],
      repair=repair(
          "factor", "the vector that K_{m-2}' and P_{m-2} annihilate is Phi_{m-2}'Phi_{m-1}'z; the factor Phi_{m-1}' "
                    "is missing",
          (H0*T(Phi1)*z == Zn) & (T(K0)*T(Phi0)*T(Phi1)*z == Zp) & (P*T(Phi0)*T(Phi1)*z == Zn),
          sizes=["n", "p"], over={**TWO_STEPS, P1: matrix(n, n)}, where=FROM_TWO[1:],
          given=[standing("P_{m-1}", P1 == step(P, Phi0, M0, V0, H0)), given("P_m z = 0", P2*z == Zn)],
          by=[order(FORMER, LAST, [inv(V1)], LAST, [], FORMER, [inv(V0)], FORMER, FORMER, lemmas=WAY_BACK),
              instances(n=(2, 4), p=(1, 4), using={Y: matrix(n, n), Y1: matrix(n, n), Y2: matrix(n, n)},
                        made_by={P: annihilating(w0, Y, Y1), H0: annihilating(w1, Y1, Y2),
                                 H1: annihilating(z, Y2, Y), P1: step(P, Phi0, M0, V0, H0)})]),
      note="P is P_{m-2}, with the data of the instants m-2 and m-1 named 0 and 1.")

Rd = sym("Rd")
DRIVEN = let(Rd, sum_of(k, 0, m - 1, Tr(m, k + 1)*H(k)*T(Tr(m, k + 1))))
# the steps back from t_m, counted by k: Back_k is Phi(t_m, t_{m-k}), and R_k is the part of R_d(t_m) that the last k noises make
r, Back, Rk, Qk, Y0, YH, G, Nn = symbols("r Back R q Y0 YH G Nn")
BACK_K = m - 1 - k


def data_to(last: Expr) -> dict:
    """Data of the instants 0 .. last - 1."""
    return {Phi: sequence_of(matrix(n, n), 0, last - 1), M: sequence_of(matrix(p, n), 0, last - 1),
            H: sequence_of(positive_semidefinite(n), 0, last - 1), V: sequence_of(positive_definite(p), 0, last - 1), P0: positive_semidefinite(n)}


BACKWARDS = [COVARIANCE, rec(Back, k, I, Back[k]*Phi[BACK_K])]
DRIVEN_BACK = rec(Rk, k, Zero(n, n), Rk[k] + Back[k]*H[BACK_K]*T(Back[k]))
FROM_THE_END = standing("the covariance equation, counted from the end", forall(k, 0, m - 1, P[k + 1] == varying_step(P[k], k)))
NULL = given("P_m z = 0", P[m]*z == Zn)


def terms_at(at: Expr) -> list[Expr]:
    """The next covariance as a sum of nonnegative terms."""
    gain_at = gain(P[at], M[at], V[at])
    return [Phi[at]*(I - gain_at*M[at])*P[at]*T(I - gain_at*M[at])*T(Phi[at]), Phi[at]*gain_at*V[at]*T(gain_at)*T(Phi[at]), H[at]]


def steps_back(null: Expr, columns: Expr | int) -> list:
    """P_k >= 0, and what becomes of the null vectors of P_m on the way back."""
    zero = Zero(n, columns)

    def back_from(at: Expr, vector_: Expr) -> Evidence:
        """Each of the nonnegative terms vanishes where their sum does, and then so do K' and P."""
        gain_at, carried = gain(P[at], M[at], V[at]), T(Phi[at])*vector_
        lemmas = [V[at]*T(gain_at)*carried == Zero(p, columns), T(gain_at)*carried == Zero(p, columns), P[at]*T(I - gain_at*M[at])*carried == zero]
        return order(terms_at(at), [inv(V[at])], terms_at(at), terms_at(at), [], lemmas=lemmas)

    return [first(forall(k, 0, m, psd(P[k])), base=order([P0]), step=order(JOSEPH_K)),
            first(forall(k, 0, m - 1, (H[BACK_K]*(T(Back[k])*null) == zero) & (P[BACK_K]*(T(Back[k + 1])*null) == zero)),
                  base=back_from(m - 1, T(Back[k])*null), step=back_from(m - 2 - k, T(Back[k + 1])*null))]


#: noise and initial covariance that annihilate what z becomes on its way back
PREPARED = {"using": {Y0: matrix(n, n), Y: matrix(n, n), YH: sequence_of(matrix(n, n), 0, m)},
            "made_by": {H: (k, annihilating(T(Back[BACK_K])*z, YH[k], YH[k + 1])), P0: annihilating(T(Back[m])*z, Y0, Y)}}
RUN_BACK = [instances(n=(2, 4), p=(1, 2), m=(1, 2), **PREPARED),
            example(n=1, p=1, m=1, Phi=[[[1]]], M=[[[1]]], H=[[[1]]], V=[[[1]]], P0=[[0]], z=[1])]

claim("D71-S20", "a null vector of P_m annihilates every H_k",
      forall(k, 0, m - 1, H[BACK_K]*T(Back[k])*z == Zn),
      sizes=["n", "p", "m"], over={**data_to(m), z: vector(n)}, where=BACKWARDS, given=[FROM_THE_END, NULL],
      by=[induction(before=steps_back(z, 1)), *RUN_BACK],
      note="Counted from the end: with k here for m - 1 - k there, Back is Phi(t_m, t_{k+1}).")

claim("D71-E3.3", "a null vector of P_m is one of R_d(t_m)",
      forall(k, 0, m, eq(T(z)*Rk[k]*z, Qk[k], Zero(1, 1))),
      sizes=["n", "p", "m"], over={**data_to(m), z: vector(n)},
      where=[*BACKWARDS, DRIVEN_BACK, rec(Qk, k, Zero(1, 1), Qk[k] + T(z)*Back[k]*H[BACK_K]*T(Back[k])*z)],
      given=[FROM_THE_END, NULL], by=[induction(before=steps_back(z, 1)), *RUN_BACK],
      note="R_d(t_m) is the sum R_m, and q_m the sum in the middle, both counted from the end.")

AFTER = {**slices(N), P0: positive_semidefinite(n)}
V_POSITIVE_AFTER = given("V_k > 0", forall(k, 0, N - 1, pd(V(k))))
AFTER_SIZES = {"n": (1, 2), "p": (1, 2), "m": (1, 2), "N": (1, 2, 4)}
IN_TIME = standing("m <= N", m <= N)
SINGULAR_PHI = example(n=1, p=1, m=1, N=2, P0=[[0]], PhiW=[[1, 0]], MW=[[1, 1]], GW=[[1, 0]], WW=[[1, 1]])
NEEDS_PHI = "a singular Phi_k with k >= m can make P_{k+1} singular again; with Phi_m = 0 and H_m = 0 it is zero"

claim("D71-S21", "once positive definite, always positive definite",
      forall(k, m, N, pd(P[k])),
      sizes=["n", "p", "m", "N"], over=AFTER, where=[*VARYING, COVARIANCE],
      given=[IN_TIME, V_POSITIVE_AFTER, given("P_m > 0", pd(P[m]))],
      by=[SINGULAR_PHI, instances(**AFTER_SIZES)],
      repair=repair("missing hypothesis", NEEDS_PHI, always(k, pd(P[k])),
                    sizes=["n", "p"], over={**V_POSITIVE_EVER, Phi: signal_of(nonsingular(n), 0), P0: positive_definite(n)}, where=[COVARIANCE],
                    by=[induction(base=order([P0]), step=order([Phi[k]*inv(inv(P[k]) + T(M[k])*inv(V[k])*M[k])*T(Phi[k]), H[k]])),
                        instances(8, **FOREVER)]),
      note="A nonsingular Phi is assumed from section C on, and in Chapter I for sampled continuous-time processes, "
           "but not here. The repair counts time from t_m.")

claim("D71-T3.3", "a completely driven process makes the covariance positive definite",
      forall(k, m, N, pd(P[k])),
      sizes=["n", "p", "m", "N"], over=AFTER, where=[*VARYING, COVARIANCE, TRANSITION, DRIVEN],
      given=[IN_TIME, V_POSITIVE_AFTER, given("completely driven at t_m", pd(Rd))],
      by=[SINGULAR_PHI, instances(**AFTER_SIZES)],
      repair=repair("missing hypothesis", NEEDS_PHI, forall(k, 0, r, pd(P[m + k])),
                    sizes=["n", "p", "m", "r"], over={**data_to(m + r), Nn: matrix(n, n), G: matrix(n, n)}, where=[*BACKWARDS, DRIVEN_BACK],
                    given=[standing("the covariance equation, at every instant", forall(k, 0, m + r - 1, P[k + 1] == varying_step(P[k], k))),
                           given("Phi_k is nonsingular from m on", forall(k, m, m + r - 1, invertible(Phi[k]))),
                           given("completely driven at t_m", pd(Rk[m])),
                           standing("null vectors of P_m, by a generalized inverse", (P[m]*Nn == Zero(n, n)) & (Nn == I - G*P[m]))],
                    by=[induction(before=[*steps_back(Nn, n), first(forall(k, 0, m, Rk[k]*Nn == Zero(n, n))),
                                          first((Rk[m]*Nn == Zero(n, n)) & (Nn == Zero(n, n)), base=order([], [inv(Rk[m])])),
                                          first(invertible(P[m]), base=order([T(G)]))],
                                  base=order([P[m]]), step=order([Phi[m + k]*inv(inv(P[m + k]) + T(M[m + k])*inv(V[m + k])*M[m + k])*T(Phi[m + k]), H[m + k]])),
                        example(n=1, p=1, m=1, r=1, P0=[[0]], Phi=[[[1]], [[0]]], M=[[[1]], [[1]]], H=[[[1]], [[0]]], V=[[[1]], [[1]]], Nn=[[0]], G=[[1]]),
                        example(n=1, p=1, m=1, r=0, P0=[[0]], Phi=[[[1]]], M=[[[1]]], H=[[[0]]], V=[[[1]]], Nn=[[1]], G=[[0]]),
                        instances(n=(1, 2), p=(1, 2), m=(1, 2), r=(0, 1, 2), made_by={G: inv(P[m]), Nn: Zero(n, n)})]),
      note="A nonsingular Phi is assumed from section C on, and in Chapter I for sampled continuous-time processes, "
           "but not here.")

# --- ordering --------------------------------------------------------------------------------------------------------

Pa, Pb, Pa0, Pb0, D0, e = symbols("Pa Pb Pa0 Pb0 D0 e")

KB = gain(Pb[k], M[k], V[k])
DIFF, WB = Pa[k] - Pb[k], M[k]*Pb[k]*T(M[k]) + V[k]
GAIN_D = DIFF*T(M[k])*inv(M[k]*Pa[k]*T(M[k]) + V[k])
OUTER = Phi[k]*(I - KB*M[k])
JOSEPH_B = [OUTER*Pb[k]*T(I - KB*M[k])*T(Phi[k]), Phi[k]*KB*V[k]*T(KB)*T(Phi[k]), H[k]]
JOSEPH_D = [OUTER*(I - GAIN_D*M[k])*DIFF*T(I - GAIN_D*M[k])*T(I - KB*M[k])*T(Phi[k]), OUTER*GAIN_D*WB*T(GAIN_D)*T(I - KB*M[k])*T(Phi[k])]

claim("D71-T3.4", "the order of two solutions is kept",
      always(k, psd(Pb[k]) & loewner(Pa[k], Pb[k])),
      sizes=["n", "p"], over={**V_POSITIVE_EVER, Pa0: positive_semidefinite(n), Pb0: positive_semidefinite(n)},
      where=[rec(Pa, k, Pa0, varying_step(Pa[k], k)), rec(Pb, k, Pb0, varying_step(Pb[k], k))],
      given=[given("P_a(t_0) >= P_b(t_0)", loewner(Pa0, Pb0))],
      by=[induction(base=order([Pb0], [Pa0 - Pb0]), step=order(JOSEPH_B, JOSEPH_D)),
          instances(8, **FOREVER, made_by={Pa0: Pb0 + D0}, using={D0: positive_semidefinite(n)})],
      note="P_b >= 0 is Theorem 3.2 and carried along. The difference of two updates is (I - K_b M)[D - DM'(MP_aM' + V)^{-1}MD](I - K_b M)' with "
           "D = P_a - P_b, and the bracket is the update of D for a measurement error of covariance MP_bM' + V.")

X = sym("X")
CLOSED = Phi*(I - gain()*M)
SHIFTED = CLOSED*inv(inv(X) + T(M)*inv(M*P*T(M) + V)*M)*T(I - gain()*M)*T(Phi)

claim("D71-E3.4", "one step from a shifted covariance",
      (Pa == Phi*inv(inv(P + X) + gram())*T(Phi) + H) & (Pa - Pb == Phi*inv(I + (P + X)*gram())*X*inv(I + gram()*P)*T(Phi))
      & loewner(Pa, Pb) & loewner(Pb + CLOSED*X*T(CLOSED), Pa),
      sizes=["n", "p"],
      over={X: positive_definite(n), P: positive_semidefinite(n), Phi: matrix(n, n), M: matrix(p, n), V: positive_definite(p),
            H: positive_semidefinite(n)}, where=[let(Pa, step(P + X)), let(Pb, step(P))],
      by=[order([], [], [SHIFTED], [Phi*(gain() - gain(P + X))*(M*(P + X)*T(M) + V)*T(gain() - gain(P + X))*T(Phi)]), instances(8, n=(1, 2), p=(1, 2))],
      note="X is the shift e I of the print, or any positive definite matrix. The inequalities are the limit: the shifted step is above the unshifted one "
           "by no more than e times a matrix that does not depend on e.")
