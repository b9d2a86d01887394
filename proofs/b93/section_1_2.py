# SPDX-License-Identifier: MIT
"""Hamiltonian matrices act on positive matrices (section 1.2, the algebra).

A matrix M = [[A, B], [C, D]] of H acts by Phi_M(T) = (AT + B)inv(CT + D). With
P = inv(A)B, Q = C inv(A) and W = A(T + P)A*, the relation D = inv(A*) + QAP gives
CT + D = (I + QW)inv(A*) and AT + B = W inv(A*), so that Phi_M(T) = W inv(I + QW). It is
defined for every nonnegative T by Lemma 1.2, and for positive W it is
inv(inv(W) + Q): the action is a shift by P, a congruence with A, an inversion, a shift
by Q, and an inversion. The same decomposition written for matrices is

    M = [[I, 0], [Q, I]] [[A, 0], [0, inv(A*)]] [[I, P], [0, I]].

The Riccati map of a system is the action of its Hamiltonian matrix, and a product of
matrices acts as the composition. The distance of two positive matrices depends only on
the eigenvalues of P inv(Q), up to replacing all of them by their reciprocals;
congruence leaves them alone and inversion inverts them.
"""

from proofs.b93.introduction import DEPENDENT, GAUSSIAN, INDEPENDENT, JOINT, PARAMETERS, REGULAR, SIZES, SMALL
from proofs.b93.introduction import SYSTEM as EVOLUTION
from proofs.b93.notation import FORM, LOWER, UPPER, assumed, d, hamiltonian, k, member, n, p, part, preserves_form, q

from exactkf.claims import claim, repair
from exactkf.evidence import combination, example, identity, instances, steps
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    charpoly,
    coeff,
    cospectral,
    eq,
    forall,
    function,
    given,
    inv,
    invertible,
    let,
    matrix,
    nonsingular,
    pd,
    positive_definite,
    positive_semidefinite,
    psd,
    rev,
    standing,
    symbols,
    symmetric_matrix,
)

A, B, C, D, M, N, P, Q, R, S, F, W, X, Y, Phi = symbols("A B C D M N P Q R S F W X Y Phi")
TT, S0, P0, Q0, U = symbols("T S0 P0 Q0 U")
A1, B1, C1, D1 = symbols("A1 B1 C1 D1")
BLOCKS = let(M, block([[A, B], [C, D]]))
ACTION = function(Phi, [X, Y], (part(X, 0, 0) * Y + part(X, 0, 1)) * inv(part(X, 1, 0) * Y + part(X, 1, 1)))
OVER = {A: nonsingular(d), B: matrix(d, d), C: matrix(d, d), D: matrix(d, d)}
UP_TO_6 = (1, 2, 3, 4, 6)
MADE = {"using": {P0: positive_semidefinite(d), Q0: positive_semidefinite(d)}, "made_by": member(A, B, C, D, P0, Q0)}

claim("B93-E12", "the action is defined on P0 and keeps it",
      pd(Phi(M, TT)), sizes=["d"], over={**OVER, TT: positive_definite(d)}, where=[FORM, BLOCKS, ACTION], given=assumed(M, A, B, C),
      by=[steps("B93-P1.5.1", prose="Proposition 1.5 (i)."), instances(d=UP_TO_6, **MADE)],
      note="A definition; that its value is defined and positive is asserted with it.")

claim("B93-E13", "a product acts as the composition",
      Phi(M * N, TT) == Phi(M, Phi(N, TT)), sizes=["d"],
      over={M: matrix(2 * d, 2 * d), N: matrix(2 * d, 2 * d), TT: symmetric_matrix(d)}, where=[ACTION],
      by=[identity(d=(1, 2)), instances(d=(1, 2, 3, 6))],
      note="Stated for all matrices for which both sides are defined; by Proposition 1.5 they are, for members of H and positive T.")

claim("B93-S28", "the Riccati map is the action of the Hamiltonian matrix",
      eq((A * P * T(A) + S) * inv(Identity(d) + R * S + R * A * P * T(A)),
         (A * P + S * inv(T(A))) * inv(R * A * P + (Identity(d) + R * S) * inv(T(A))),
         Phi(M, P)),
      sizes=["d", "p", "q"], over={A: nonsingular(d), F: matrix(d, p), C: matrix(q, d), P: positive_semidefinite(d)},
      where=[let(R, T(C) * C), let(S, F * T(F)), let(M, hamiltonian(A, S, R)), ACTION],
      by=[identity(d=(1, 2), p=(1, 2), q=(1, 2)), instances(d=UP_TO_6, p=(1, 2, 3), q=(1, 2, 3))])

Pn, An, Sn, Rn = symbols("P A S R")
RICCATI = forall(k, 1, n, Pn(k) == Phi(hamiltonian(An(k), Sn(k), Rn(k)), Pn(k - 1)))
claim("B93-E14", "the discrete Riccati equation",
      RICCATI, sizes=SIZES, over={**PARAMETERS, **JOINT}, where=[*EVOLUTION, *GAUSSIAN, ACTION], given=[REGULAR],
      by=[example(DEPENDENT), instances(**SMALL)],
      repair=repair(
          "missing hypothesis", "Like (5), from which it is deduced, it needs that X_0 is independent of the noises, which the set-up does not say.",
          RICCATI, sizes=SIZES, over={**PARAMETERS, **JOINT}, where=[*EVOLUTION, *GAUSSIAN, ACTION], given=[REGULAR, INDEPENDENT],
          by=[steps("B93-E5", "B93-S28", prose="(5), as corrected, with S28."),
              instances(made_by={"G": Zero(d, (p + q) * n)}, **SMALL)]))

claim("B93-S31", "the distance is invariant under congruence and under inversion",
      cospectral(A * P * T(A) * inv(A * Q * T(A)), P * inv(Q)) & cospectral(inv(P) * inv(inv(Q)), inv(P * inv(Q))), sizes=["d"],
      over={A: nonsingular(d), P: positive_definite(d), Q: positive_definite(d)},
      by=[identity(d=(1, 2)), instances(d=UP_TO_6)],
      note="The distance is a function of the squared logarithms of the eigenvalues of P inv(Q): the first relation says that congruence "
           "leaves these eigenvalues alone, the second that inversion replaces them by their reciprocals.")

claim("B93-P1.5.1", "members of H act on P and on P0",
      invertible(C * TT + D) & psd(Phi(M, TT)) & (pd(TT) >> pd(Phi(M, TT))), sizes=["d"], over={**OVER, TT: positive_semidefinite(d)},
      where=[FORM, BLOCKS, ACTION], given=assumed(M, A, B, C),
      by=[steps("B93-S32", "B93-S33", "B93-L1.2",
                prose="W(I + QW)^{-1} = (I + WQ)^{-1}(W + WQW)(I + QW)^{-1} is a congruence of a nonnegative matrix, positive with W."),
          instances(d=UP_TO_6, **MADE)])

claim("B93-P1.5.2", "members of H2 act from P into P0",
      pd(Phi(M, TT)), sizes=["d"], over={**OVER, TT: positive_semidefinite(d)}, where=[FORM, BLOCKS, ACTION],
      given=[given("M in Sp", preserves_form(M)), given("M: BA* > 0", pd(B * T(A))), given("M: A*C >= 0", psd(T(A) * C))],
      by=[steps("B93-S33", prose="P is positive, so is W = A(T + P)A*, and inv(inv(W) + Q) is positive."),
          instances(d=UP_TO_6, using={P0: positive_definite(d), Q0: positive_semidefinite(d)}, made_by=member(A, B, C, D, P0, Q0))])

# P = inv(A)B and Q = C inv(A) as variables, tied to M
TIED = {**OVER, P: positive_semidefinite(d), Q: positive_semidefinite(d)}
NAMED = [given("P = inv(A)B", B == A * P), given("Q = C inv(A)", C == Q * A)]
IN_SP = given("M in Sp", preserves_form(M))
REACHED = member(A, B, C, D, P, Q)
SHIFTED = let(W, A * (TT + P) * T(A))

claim("B93-S32", "the denominator of the action",
      eq(C * TT + D, Q * A * TT + Q * A * P + inv(T(A)), (Q * W + Identity(d)) * inv(T(A))) & psd(W), sizes=["d"],
      over={**TIED, TT: positive_semidefinite(d)}, where=[FORM, BLOCKS, SHIFTED], given=[*NAMED, IN_SP],
      by=[identity(given_by=REACHED, covered_by="B93-S38", d=(1, 2, 3)), instances(d=UP_TO_6, made_by=REACHED)],
      note="W stands for the S of the text. P and Q are nonnegative by S17.")

claim("B93-S33", "the action in terms of W and Q",
      eq((A * TT + B) * inv(C * TT + D), (A * TT + A * P) * T(A) * inv(Q * W + Identity(d)), W * inv(Q * W + Identity(d)))
      & (invertible(W) >> (W * inv(Q * W + Identity(d)) == inv(inv(W) + Q))), sizes=["d"],
      over={**TIED, TT: positive_semidefinite(d)}, where=[FORM, BLOCKS, SHIFTED], given=[*NAMED, IN_SP],
      by=[identity(given_by=REACHED, covered_by="B93-S38", d=(1, 2)), instances(d=UP_TO_6, made_by=REACHED)],
      note="W stands for the S of the text.")

claim("B93-S37", "exchanging the two matrices inverts the eigenvalues",
      coeff(charpoly((TT + P) * inv(S0 + P)), 0) * charpoly((S0 + P) * inv(TT + P)) == rev(charpoly((TT + P) * inv(S0 + P)), d), sizes=["d"],
      over={TT: positive_definite(d), S0: positive_definite(d), P: positive_semidefinite(d)},
      by=[identity(d=(1, 2)), instances(d=UP_TO_6)],
      note="The characteristic polynomials are each other's reversals: the eigenvalues, all positive, are each other's reciprocals, "
           "and taking reciprocals reverses their order. S0 stands for the S of the text.")

claim("B93-S38", "every member of H is a product of three simple ones",
      M == block([[Identity(d), Zero(d, d)], [C * inv(A), Identity(d)]]) * block([[A, Zero(d, d)], [Zero(d, d), inv(T(A))]])
      * block([[Identity(d), inv(A) * B], [Zero(d, d), Identity(d)]]),
      sizes=["d"], over=OVER, where=[FORM, BLOCKS],
      given=[IN_SP, standing("M: BA* >= 0", psd(B * T(A))), standing("M: A*C >= 0", psd(T(A) * C))],
      by=[combination([(LOWER * inv(T(A)) * T(UPPER), "M in Sp", (LOWER - UPPER * inv(A) * B) * T(LOWER))], d=(1, 2, 3)), instances(d=UP_TO_6, **MADE)],
      note="That P = inv(A)B and Q = C inv(A) are nonnegative is S17.")

claim("B93-E17", "the action as a chain of shifts, inversions and a congruence",
      Phi(M, TT) == inv(inv(A * (TT + P) * T(A)) + Q), sizes=["d"],
      over={**TIED, TT: positive_definite(d)}, where=[FORM, BLOCKS, ACTION], given=[*NAMED, IN_SP],
      by=[identity(given_by=REACHED, covered_by="B93-S38", d=(1, 2)), instances(d=UP_TO_6, made_by=REACHED)])
