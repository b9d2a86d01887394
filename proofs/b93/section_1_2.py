# SPDX-License-Identifier: MIT
"""Hamiltonian matrices act on positive matrices (section 1.2, the algebra).

A matrix M = [[A, B], [C, D]] of H acts by Phi_M(T) = (AT + B)inv(CT + D). With
P = inv(A)B, Q = C inv(A) and W = A(T + P)A* = ATA* + BA*, the relation
D = inv(A*) + QAP gives CT + D = (I + QW)inv(A*) and AT + B = W inv(A*), so that
Phi_M(T) = W inv(I + QW). With H a symmetric root of W this is H inv(I + HQH) H: it is
defined and nonnegative for every nonnegative T, and for positive W it is
inv(inv(W) + Q). So the action is a shift by P, a congruence with A, an inversion, a
shift by Q, and an inversion. The same decomposition written for matrices is

    M = [[I, 0], [Q, I]] [[A, 0], [0, inv(A*)]] [[I, P], [0, I]].

The Riccati map of a system is the action of its Hamiltonian matrix, and a product of
matrices acts as the composition. The distance of two positive matrices depends only on
the eigenvalues of P inv(Q), up to replacing all of them by their reciprocals;
congruence leaves them alone and inversion inverts them.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, identity, induction, instances, order, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    eq,
    forall,
    function,
    given,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonsingular,
    pd,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    sequence,
    sequence_of,
    sum_of,
    symbols,
    symplectic,
    when,
)
from proofs.b93.introduction import (
    DEPENDENT,
    GAUSSIAN,
    JOINT,
    LOUD,
    P0,
    P1,
    PARAMETERS,
    REGULAR,
    SIZES,
    SMALL,
    STEP,
    STEP_GIVEN,
    STEP_MADE,
    STEP_OVER,
    STEP_SIZES,
)
from proofs.b93.introduction import SYSTEM as EVOLUTION
from proofs.b93.notation import Factor, d, hamiltonian, i, j, k, member, member_of_h, n, numbers, p, part, q

A, B, C, D, M, N, P, Q, R, S, F, W, H, X, Y, Phi, Den = symbols("A B C D M N P Q R S F W H X Y Phi Den")
TT, T0, S0, Q0, W0, L0, R0 = symbols("T T0 S0 Q0 W0 L R0")
A1, B1, C1, D1 = symbols("A1 B1 C1 D1")
BLOCKS = let(M, block([[A, B], [C, D]]))
ACTION = (function(Den, [X, Y], part(X, 1, 0) * Y + part(X, 1, 1)),
          function(Phi, [X, Y], (part(X, 0, 0) * Y + part(X, 0, 1)) * inv(Den(X, Y))))
OVER = {A: nonsingular(d), B: matrix(d, d), C: matrix(d, d), D: matrix(d, d)}
POSITIVE, NONNEGATIVE = {TT: positive_definite(d)}, {TT: positive_semidefinite(d)}
UP_TO_6 = (1, 2, 3, 4, 6)
MADE = instances(d=UP_TO_6, using={P0: positive_semidefinite(d), Q0: positive_semidefinite(d)},
                 made_by=member(A, B, C, D, P0, Q0))
IN_H = member_of_h(M, A, B, C, "Sp", "BA*", "A*C")

# the terms of the proofs: W, its root H, and the two forms of the value
SELF = Factor(A, B, C)
SHIFTED = A * TT * T(A) + B * T(A)
MIDDLE = inv(Identity(d) + H * SELF.Q * H)
INVERSE = T(A) * (Identity(d) - SELF.Q * H * MIDDLE * H)
VALUE = H * MIDDLE * H


def _positive_value(X):
    """inv(inv(W) + Q) for a positive W."""
    return inv(inv(A * X * T(A) + B * T(A)) + SELF.Q)



def _one(M_, T_, **more):
    """An example with d = 1 that shows a hypothesis to be needed."""
    return example(numbers("A B C D T", *M_, T_, **more))


claim("B93-E12", "the action is defined on P0 and keeps it",
      invertible(Den(M, TT)) & pd(Phi(M, TT)), sizes=["d"], over={**OVER, **POSITIVE}, where=[BLOCKS, *ACTION], given=IN_H,
      by=[order([INVERSE], [_positive_value(TT)], roots={H: SHIFTED}),
          *(_one(*x) for x in (((1, -2, 0, 1), 1), ((1, 0, -1, 1), 2), ((1, 0, 0, -1), 1))), MADE],
      note="A definition; that its value is defined and positive is asserted with it.")

BOTH_BLOCKS = {A: matrix(d, d), B: matrix(d, d), C: matrix(d, d), D: matrix(d, d),
               A1: matrix(d, d), B1: matrix(d, d), C1: matrix(d, d), D1: matrix(d, d), TT: matrix(d, d)}
claim("B93-E13", "a product acts as the composition",
      Phi(M * N, TT) == Phi(M, Phi(N, TT)), sizes=["d"], over=BOTH_BLOCKS,
      where=[BLOCKS, let(N, block([[A1, B1], [C1, D1]])), *ACTION],
      by=[identity(d=(1,)), instances(d=(1, 2, 3, 6))],
      note="Stated for all matrices for which both sides are defined; by Proposition 1.5 they are, for members of H "
           "and positive T.")

claim("B93-S28", "the Riccati map is the action of the Hamiltonian matrix",
      eq((A * P * T(A) + S) * inv(Identity(d) + R * S + R * A * P * T(A)),
         (A * P + S * inv(T(A))) * inv(R * A * P + (Identity(d) + R * S) * inv(T(A))),
         Phi(M, P)),
      sizes=["d", "p", "q"],
      over={A: nonsingular(d), F: matrix(d, p), C: matrix(q, d), P: positive_semidefinite(d)},
      where=[let(R, T(C) * C), let(S, F * T(F)), let(M, hamiltonian(A, S, R)), *ACTION],
      by=[identity(d=(1, 2), p=1, q=1), instances(d=UP_TO_6, p=(1, 2, 3), q=(1, 2, 3))])

claim("B93-E14", "the discrete Riccati equation",
      forall(k, 1, n, P(k) == Phi(hamiltonian(A(k), S(k), R(k)), P(k - 1))), sizes=SIZES, over={**PARAMETERS, **JOINT},
      where=[*EVOLUTION, *GAUSSIAN, *ACTION], given=[REGULAR], by=[example(DEPENDENT), instances(**SMALL)],
      repair=repair(
          "missing hypothesis",
          "Like (5), from which it is deduced, it needs that X_0 is independent of the noises, which the set-up of section 1 does "
          "not say.",
          P1 == Phi(hamiltonian(A, S, R), P0), sizes=STEP_SIZES, over={**STEP_OVER, A: nonsingular(d)},
          where=[*STEP, *ACTION], given=STEP_GIVEN, by=[order(), LOUD, STEP_MADE]),
      note="Stated like (5).")

E0, Lam = symbols("E Lam")
claim("B93-S31", "the distance is invariant under congruence and under inversion",
      (A * P * T(A) * inv(A * Q * T(A)) * (A * E0) == A * E0 * Lam) & (inv(P) * inv(inv(Q)) * (inv(Q) * E0) == inv(Q) * E0 * inv(Lam)), sizes=["d"],
      over={A: nonsingular(d), P: positive_definite(d), Q: positive_definite(d), E0: nonsingular(d), Lam: nonsingular(d)},
      given=[given("eigenvalues and eigenvectors of P inv(Q)", P * inv(Q) * E0 == E0 * Lam)],
      by=[instances(d=(1, 2, 3), made_by={Lam: inv(E0) * P * inv(Q) * E0})],
      note="Lam is the diagonal matrix of the eigenvalues lambda_i of P inv(Q), or any matrix that is similar to it, by E. Shown: by AE the matrix of the "
           "distance of APA* and AQA* is similar to Lam, and by inv(Q)E that of inv(P) and inv(Q) to inv(Lam). So the spectra are the same, with "
           "multiplicities, but for reciprocals in the second; and the distance, the root of the sum of the squared logarithms, is by its definition the same.")

claim("B93-P1.5.1", "members of H act on P and on P0",
      invertible(Den(M, TT)) & psd(Phi(M, TT)) & pd(Phi(M, T0)), sizes=["d"],
      over={**OVER, **NONNEGATIVE, T0: positive_definite(d)}, where=[BLOCKS, *ACTION], given=IN_H,
      by=[order([INVERSE], [VALUE], [_positive_value(T0)], roots={H: SHIFTED}), 
          *(_one(*x, T0=1) for x in (((1, -1, 0, 1), 0), ((1, 0, -1, 1), 2), ((1, 0, 0, -1), 1))), MADE])

claim("B93-P1.5.2", "members of H2 act from P into P0",
      pd(Phi(M, TT)), sizes=["d"], over={**OVER, **NONNEGATIVE}, where=[BLOCKS, *ACTION],
      given=[given("M in Sp", symplectic(M)), given("M: BA* > 0", pd(B * T(A))), given("M: A*C >= 0", psd(T(A) * C))],
      by=[order([_positive_value(TT)]), _one((1, 1, -1, 0), 2),
          instances(d=UP_TO_6, using={P0: positive_definite(d), Q0: positive_semidefinite(d)},
                    made_by=member(A, B, C, D, P0, Q0))])

NAMED = [BLOCKS, let(P, inv(A) * B), let(Q, C * inv(A))]
SHIFT = let(W, A * (TT + P) * T(A))

claim("B93-S32", "the denominator of the action",
      psd(P) & psd(Q) & psd(W)
      & eq(C * TT + D, Q * A * TT + Q * A * P + inv(T(A)), (Q * W + Identity(d)) * inv(T(A))), sizes=["d"],
      over={**OVER, **NONNEGATIVE}, where=[*NAMED, SHIFT], given=IN_H,
      by=[order([SELF.P], [SELF.Q], [A * TT * T(A), SELF.BA]), MADE],
      note="W stands for the S of the text.")

claim("B93-S33", "the action in terms of W and Q",
      eq((A * TT + B) * inv(C * TT + D), (A * TT + A * P) * T(A) * inv(Q * W + Identity(d)),
         W * inv(Q * W + Identity(d)))
      & (W0 * inv(Q * W0 + Identity(d)) == inv(inv(W0) + Q)), sizes=["d"],
      over={**OVER, **NONNEGATIVE, T0: positive_semidefinite(d)},
      where=[*NAMED, SHIFT, let(W0, A * (T0 + P) * T(A))], given=member_of_h(M, A, B, C, "Sp"),
      by=[order(), MADE],
      note="W stands for the S of the text, and W0 is a second one, which has an inverse.")

l, e, m, ascends, E_, c = symbols("l e m ascends E c")


def _swapped(at, two) -> list:
    """The eigenvalue as a quotient of positive forms; the difference of two reciprocals."""
    form = T(e[at]) * inv(S0 + P)
    low, high = l[d - two + 1], l[d - two + 2]
    return [order([], [form * (TT + P) * inv(S0 + P) * e[at] / (form * e[at])], [],
                  inside=[within(0, (TT + P) * inv(S0 + P) * e[at] == l[at] * e[at])]), order([1 * ((high - low) / (low * high))])]


def _spectrum(gap: int) -> dict:
    """T + P = E G E* and S + P = EE* with the diagonal matrix G of the l_k, from one on; e_k is the k-th column of E."""
    at = sum_of(j, 1, i, when(j == 1, 1, gap) + c[j] ** 2)
    half = E_ * T(E_) / 2
    return {l: (i, at), e: (k, matrix_of(i, j, d, 1, E_[i, k])), S0: half, P: half, TT: E_ * matrix_of(i, j, d, d, when(i == j, at, 0)) * T(E_) - half}


claim("B93-S37", "exchanging the two matrices inverts the eigenvalues and their order",
      forall(k, 1, d, (l[k] > 0) & ((S0 + P) * inv(TT + P) * e[d - k + 1] == m(k) * e[d - k + 1])) & forall(k, 2, d, ascends(k)), sizes=["d"],
      over={TT: positive_definite(d), S0: positive_definite(d), P: positive_semidefinite(d), l: sequence(1, d), e: sequence_of(matrix(d, 1), 1, d)},
      where=[function(m, [k], 1 / l[d - k + 1]), function(ascends, [k], m(k - 1) <= m(k))],
      given=[given("eigenvalues", forall(k, 1, d, (TT + P) * inv(S0 + P) * e[k] == l[k] * e[k])),
             given("eigenvectors", forall(k, 1, d, rank(e[k]) == 1)), given("ascending order", forall(k, 1, d - 1, l[k] <= l[k + 1]))],
      by=[induction(base=_swapped(1, 2), step=_swapped(k + 1, k + 1)),
          example(d=1, T=[[1]], S0=[[1]], P=[[0]], l=[2], e=[[[1]]]), example(d=1, T=[[1]], S0=[[1]], P=[[0]], l=[-1], e=[[[0]]]),
          example(d=2, T=[[1, 0], [0, 2]], S0=[[1, 0], [0, 1]], P=[[0, 0], [0, 0]], l=[2, 1], e=[[[0], [1]], [[1], [0]]]),
          example(d=2, T=[[1, 0], [0, 2]], S0=[[1, 0], [0, 1]], P=[[1, 0], [0, 1]], l=[1, "3/2"], e=[[[1], [0]], [[0], [1]]]),
          instances(8, d=(2, 3), using={E_: nonsingular(d), c: sequence(1, d)}, made_by=_spectrum(1)),
          instances(8, d=(2, 3), using={E_: nonsingular(d), c: sequence(1, d)}, made_by=_spectrum(0))],
      note="l_1 <= ... <= l_d are the eigenvalues of (T + P) inv(S + P), with eigenvectors e_k; S0 stands for the S of the text. Shown: their "
           "reciprocals m_1 = 1/l_d, ..., m_d = 1/l_1 are the eigenvalues of (S + P) inv(T + P), with the same eigenvectors, and ascend, so that the k-th "
           "of them is m_k. That the eigenvalues are real, with a basis of eigenvectors, is B93-S35; a basis stays one in another order.")

claim("B93-S38", "every member of H is a product of three simple ones",
      psd(P) & psd(Q)
      & (M == block([[Identity(d), Zero(d, d)], [Q, Identity(d)]]) * block([[A, Zero(d, d)], [Zero(d, d), inv(T(A))]])
         * block([[Identity(d), P], [Zero(d, d), Identity(d)]])),
      sizes=["d"], over=OVER, where=NAMED, given=IN_H,
      by=[order([SELF.P], [SELF.Q]), MADE])

claim("B93-E17", "the action as a chain of shifts, inversions and a congruence",
      Phi(M, TT) == inv(inv(A * (TT + P) * T(A)) + Q), sizes=["d"], over={**OVER, **POSITIVE},
      where=[*NAMED, *ACTION], given=member_of_h(M, A, B, C, "Sp"),
      by=[order(), MADE],
      note="From the right: a shift by P, the congruence with A, an inversion, a shift by Q, an inversion.")
