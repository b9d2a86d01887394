# SPDX-License-Identifier: MIT
"""The semigroup of Hamiltonian matrices (section 1.1).

A matrix M of order 2d is symplectic when M*JM = J. Multiplying by J on the left and by
inv(M) on the right, with JJ = -I, gives inv(M) = -JM*J, and so MJM* = J: the transpose
is symplectic too. (The printed text has inv(M) = JM*J, which the identity matrix
refutes.) In blocks, M*JM = J reads A*C = C*A, B*D = D*B, A*D - C*B = I, and MJM* = J
reads AB* = BA*, CD* = DC*, AD* - BC* = I.

H consists of the symplectic M with A invertible and BA*, A*C nonnegative. Then
P = inv(A)B and Q = C inv(A) are nonnegative, D = inv(A*) + QAP, and M is the
Hamiltonian matrix of the system with S = BA* and R = Q. H1 asks A*C > 0, H2 asks
BA* > 0, and transposition exchanges them.

For a product M3 = M2 M1 in H, A3 = A2(I + P2 Q1)A1 with P2 = inv(A2)B2 and
Q1 = C1 inv(A1). A product of two nonnegative matrices has real nonnegative eigenvalues,
so I + P2 Q1 is invertible (Lemma 1.2) with eigenvalues at least one; one is reached as
soon as P or Q is singular. The form

    A3*C3 = (A2(I + P2 Q1)A1)* ... = X*(A2*C2)X + A1*C1 + C1*P2 C1,  X = (I + P2 Q1)A1,

shows at once that A3*C3 is nonnegative, that it is positive when A1*C1 or A2*C2 is
(H1 is an ideal; the text says H2 at this place), and that its null space is the
common null space of A1*C1 and A2*C2 A1. Iterating the last remark gives
Proposition 1.3. A system of equations for x is compared with another one through
ranks: they have the same solutions when each has the rank of both together.
"""

from proofs.b93.notation import (
    FORM,
    LOWER,
    UPPER,
    J,
    assumed,
    d,
    hamiltonian,
    i,
    in_h,
    in_h0,
    in_h1,
    in_h2,
    j,
    k,
    member,
    n,
    p,
    part,
    piece,
    preserves_form,
    q,
    r,
)

from exactkf.claims import claim, repair
from exactkf.evidence import combination, example, identity, instances, steps
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    charpoly,
    det,
    diagonal,
    eq,
    forall,
    function,
    given,
    iff,
    inside_roots,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonsingular,
    outside_roots,
    pd,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    standing,
    sum_of,
    symbols,
    symmetric_matrix,
    to_expr,
    trace,
    vstack,
    when,
)

A, B, C, D, M, N, F, P, Q, R, S, U, E, L, W = symbols("A B C D M N F P Q R S U E L W")
A1, B1, C1, D1, M1, P1, Q1 = symbols("A1 B1 C1 D1 M1 P1 Q1")
A2, B2, C2, D2, M2, P2, Q2 = symbols("A2 B2 C2 D2 M2 P2 Q2")
A3, B3, C3, M3 = symbols("A3 B3 C3 M3")
FIRST, LAST = let(M1, block([[A1, B1], [C1, D1]])), let(M2, block([[A2, B2], [C2, D2]]))
PRODUCT = (let(M3, M2 * M1), let(A3, part(M3, 0, 0)), let(B3, part(M3, 0, 1)), let(C3, part(M3, 1, 0)))
BLOCKS = let(M, block([[A, B], [C, D]]))
SYSTEM = (let(R, T(C) * C), let(S, F * T(F)), let(M, hamiltonian(A, S, R)))
UP_TO_6 = (1, 2, 3, 4, 6)

claim("B93-E7", "the Hamiltonian matrix is an observation update after a time update",
      M == block([[Identity(d), Zero(d, d)], [R, Identity(d)]]) * block([[A, S * inv(T(A))], [Zero(d, d), inv(T(A))]]),
      sizes=["d", "p", "q"], over={A: nonsingular(d), F: matrix(d, p), C: matrix(q, d)}, where=SYSTEM,
      by=[identity(d=(1, 2, 3), p=(1, 2), q=(1, 2)), instances(d=UP_TO_6, p=(1, 2, 3), q=(1, 2, 3))],
      note="A definition. What is checked is that the blocks fit, and another form of the matrix.")

claim("B93-S5", "the symplectic matrices are a group",
      T(M * inv(N)) * J * (M * inv(N)) == J, sizes=["d"], over={M: matrix(2 * d, 2 * d), N: nonsingular(2 * d)}, where=[FORM],
      given=[given("M in Sp", preserves_form(M)), given("N in Sp", preserves_form(N))],
      by=[combination([(T(inv(N)), "M in Sp", inv(N)), (-T(inv(N)), "N in Sp", inv(N))], d=(1, 2)),
          instances(d=(1, 2, 3), using={A: nonsingular(d), P: symmetric_matrix(d), Q: symmetric_matrix(d), A1: nonsingular(d), P1: symmetric_matrix(d), Q1: symmetric_matrix(d)},
                    made_by={M: J * block([[A, A * P], [Q * A, inv(T(A)) + Q * A * P]]), N: block([[A1, A1 * P1], [Q1 * A1, inv(T(A1)) + Q1 * A1 * P1]])})],
      note="A definition. What is checked is that it defines a group: with M and N the matrix M inv(N) is a member.")

claim("B93-S6", "Hamiltonian matrices are symplectic",
      preserves_form(M), sizes=["d", "p", "q"], over={A: nonsingular(d), F: matrix(d, p), C: matrix(q, d)}, where=[FORM, *SYSTEM],
      by=[identity(d=(1, 2, 3), p=(1, 2), q=(1, 2)), instances(d=UP_TO_6, p=(1, 2, 3), q=(1, 2, 3))])

SYMPLECTIC = {"using": {A: nonsingular(d), P: symmetric_matrix(d), Q: symmetric_matrix(d)},
              "made_by": {M: block([[A, A * P], [Q * A, inv(T(A)) + Q * A * P]])}}

claim("B93-S7", "the inverse of a symplectic matrix",
      iff(preserves_form(M), inv(M) == J * T(M) * J), sizes=["d"], over={M: nonsingular(2 * d)}, where=[FORM],
      by=[example(d=1, M=[[1, 0], [0, 1]]), instances(d=(1, 2, 3), **SYMPLECTIC)],
      repair=repair("sign", "JJ = -I, so that solving M*JM = J for the inverse of M gives a minus sign.",
                    iff(preserves_form(M), inv(M) == -(J * T(M) * J)), sizes=["d"], over={M: nonsingular(2 * d)}, where=[FORM],
                    by=[combination([(J, "M in Sp", inv(M))], d=(1, 2, 3)), instances(d=(1, 2, 3), **SYMPLECTIC), instances(d=(1, 2, 3))]))

claim("B93-S8", "the transpose of a symplectic matrix is symplectic",
      M * J * T(M) == J, sizes=["d"], over={M: nonsingular(2 * d)}, where=[FORM], given=[given("M in Sp", preserves_form(M))],
      by=[combination([(-(M * J), "M in Sp", inv(M) * J)], d=(1, 2)), instances(d=(1, 2, 3, 6), **SYMPLECTIC)],
      note="A symplectic matrix is nonsingular. The relation S7, from which the text deduces this, has a wrong sign; the conclusion is right.")

claim("B93-S9", "the relations between the blocks of a symplectic matrix",
      (B * T(A) == A * T(B)) & (T(A) * C == T(C) * A) & (T(A) * D - T(C) * B == Identity(d)), sizes=["d"],
      over={A: matrix(d, d), B: matrix(d, d), C: matrix(d, d), D: matrix(d, d)}, where=[FORM, BLOCKS],
      given=[given("M in Sp", preserves_form(M))],
      by=[combination([[(T(UPPER) * M * J, "M in Sp", inv(M) * J * UPPER)], [(T(UPPER), "M in Sp", UPPER)],
                       [(T(UPPER), "M in Sp", LOWER)]], d=(1, 2)),
          instances(d=(1, 2, 3, 6), using={L: nonsingular(d), P: symmetric_matrix(d), Q: symmetric_matrix(d)},
                    made_by={A: L, B: L * P, C: Q * L, D: inv(T(L)) + Q * L * P}),
          instances(8, d=(1, 2, 3), using={L: nonsingular(d), P: symmetric_matrix(d), Q: symmetric_matrix(d)},
                    made_by={A: L * P, B: -L, C: inv(T(L)) + Q * L * P, D: -(Q * L)})],
      note="In the second family of instances A = LP vanishes or is singular with P.")

claim("B93-S10", "a family of members of H",
      in_h(M, A, A * P, Q * A), sizes=["d"], over={A: nonsingular(d), P: positive_semidefinite(d), Q: positive_semidefinite(d)},
      where=[FORM, let(M, block([[A, A * P], [Q * A, inv(T(A)) + Q * A * P]]))],
      by=[instances(d=UP_TO_6)],
      note="A definition. What is checked is that the set is not empty: each nonsingular A with nonnegative P and Q gives a member. S38 shows that there are no others.")

claim("B93-S11", "Hamiltonian matrices are in H",
      in_h(M, A, S * inv(T(A)), R * A), sizes=["d", "p", "q"], over={A: nonsingular(d), F: matrix(d, p), C: matrix(q, d)}, where=[FORM, *SYSTEM],
      by=[steps("B93-S6", prose="BA* is S = FF* and A*C is A*RA with R = C*C; both are nonnegative."),
          instances(d=UP_TO_6, p=(1, 2, 3), q=(1, 2, 3))])

FA, CA = symbols("FA CA")
claim("B93-S12", "every member of H is the Hamiltonian matrix of a system",
      psd(C * inv(A)) & (((FA * FA == B * T(A)) & (CA * CA == C * inv(A))) >> (M == hamiltonian(A, FA * T(FA), T(CA) * CA))),
      sizes=["d"], over={A: nonsingular(d), B: matrix(d, d), C: matrix(d, d), D: matrix(d, d), FA: positive_semidefinite(d), CA: positive_semidefinite(d)},
      where=[FORM, BLOCKS],
      given=[given("M in Sp", preserves_form(M)), standing("BA* >= 0", psd(B * T(A))), given("A*C >= 0", psd(T(A) * C))],
      by=[steps("B93-S38", "B93-S17", facts=["a nonnegative symmetric matrix has exactly one nonnegative symmetric square root"],
                prose="With S = BA* and R = C inv(A) the factors of S38 multiply to the matrix (7)."),
          instances(d=UP_TO_6, made_by={"B": FA * FA * inv(T(A)), "C": CA * CA * A, "D": inv(T(A)) + CA * CA * FA * FA * inv(T(A))}),
          example(d=1, A=[[1]], B=[[0]], C=[[-1]], D=[[1]], FA=[[0]], CA=[[0]])],
      note="The roots are nonnegative symmetric matrices FA and CA, so that FF* is BA* and C*C is C inv(A).")

claim("B93-S13", "in H, a positive A*C is a positive C inv(A), and a positive BA* a positive inv(A)B",
      iff(pd(T(A) * C), pd(C * inv(A))) & iff(pd(B * T(A)), pd(inv(A) * B)), sizes=["d"],
      over={A: nonsingular(d), B: matrix(d, d), C: matrix(d, d), D: matrix(d, d)}, where=[FORM, BLOCKS],
      given=assumed(M, A, B, C, standing_only=True),
      by=[instances(d=UP_TO_6, using={P: positive_semidefinite(d), Q: positive_semidefinite(d)}, made_by=member(A, B, C, D, P, Q))],
      note="A definition. What is checked is the form in which it is used later: H1 asks Q = C inv(A) > 0 and H2 asks P = inv(A)B > 0.")

claim("B93-S14", "transposition exchanges H1 and H2",
      iff(in_h1(M, A, B, C), in_h2(T(M), T(A), T(C), T(B))), sizes=["d"],
      over={A: matrix(d, d), B: matrix(d, d), C: matrix(d, d), D: matrix(d, d)}, where=[FORM, BLOCKS],
      by=[steps("B93-S8", "B93-S9", prose="The blocks of M* are A*, C*, B*, D*: its BA* is C*A = A*C and its A*C is AB* = BA*."),
          instances(d=UP_TO_6, using={L: nonsingular(d), P: positive_semidefinite(d), Q: positive_semidefinite(d)},
                    made_by={A: L, B: L * P, C: Q * L, D: inv(T(L)) + Q * L * P}),
          instances(d=(1, 2), using={L: nonsingular(d), P: symmetric_matrix(d), Q: symmetric_matrix(d)},
                    made_by={A: L, B: L * P, C: Q * L, D: inv(T(L)) + Q * L * P})],
      note="A positive A*C, or a positive BA*, forces A to be invertible, which is therefore not repeated.")

PAIR = {A1: nonsingular(d), B1: matrix(d, d), C1: matrix(d, d), D1: matrix(d, d), A2: nonsingular(d), B2: matrix(d, d), C2: matrix(d, d), D2: matrix(d, d)}
BOTH = [*assumed(M1, A1, B1, C1), *assumed(M2, A2, B2, C2)]
SETTING = [*assumed(M1, A1, B1, C1, standing_only=True), *assumed(M2, A2, B2, C2, standing_only=True)]
MADE = {"using": {P1: positive_semidefinite(d), Q1: positive_semidefinite(d), P2: positive_semidefinite(d), Q2: positive_semidefinite(d)},
        "made_by": {**member(A1, B1, C1, D1, P1, Q1), **member(A2, B2, C2, D2, P2, Q2)}}

claim("B93-P1.1.1", "H is a semigroup",
      in_h(M3, A3, B3, C3), sizes=["d"], over=PAIR, where=[FORM, FIRST, LAST, *PRODUCT], given=BOTH,
      by=[steps("B93-S5", "B93-S18", "B93-E8", "B93-S20", "B93-L1.2", prose="The product is symplectic, A3 is invertible by S18, and (8) and its dual give the two signs."),
          instances(d=UP_TO_6, **MADE)])

SIDES = (let(M3, M * N), let(L, N * M))
BLOCKS_N = let(N, block([[A1, B1], [C1, D1]]))
WITH_N = {A: nonsingular(d), B: matrix(d, d), C: matrix(d, d), D: matrix(d, d), A1: nonsingular(d), B1: matrix(d, d), C1: matrix(d, d), D1: matrix(d, d)}


def _ideal(ledger_id: str, title: str, test, extra: tuple, p1_type: tuple, q1_type: tuple, *ids: str) -> None:
    """M in H, N in the subset: MN and NM are in the subset."""
    claim(ledger_id, title,
          test(M3, part(M3, 0, 0), part(M3, 0, 1), part(M3, 1, 0)) & test(L, part(L, 0, 0), part(L, 0, 1), part(L, 1, 0)),
          sizes=["d"], over=WITH_N, where=[FORM, BLOCKS, BLOCKS_N, *SIDES], given=[*assumed(M, A, B, C), *extra],
          by=[steps(*ids, prose="One of the two factors makes the sum in (8), or in its dual, positive."),
              instances(d=(1, 2, 3), using={P: positive_semidefinite(d), Q: positive_semidefinite(d), P1: p1_type, Q1: q1_type},
                        made_by={**member(A, B, C, D, P, Q), **member(A1, B1, C1, D1, P1, Q1)})])


IN_SP = given("N in Sp", preserves_form(N))
_ideal("B93-P1.1.2", "H1 is a two-sided ideal", in_h1,
       (IN_SP, given("N: BA* >= 0", psd(B1 * T(A1))), given("N: A*C > 0", pd(T(A1) * C1))),
       positive_semidefinite(d), positive_definite(d), "B93-P1.1.1", "B93-S21", "B93-E8")
_ideal("B93-P1.1.3", "H2 is a two-sided ideal", in_h2,
       (IN_SP, given("N: BA* > 0", pd(B1 * T(A1))), given("N: A*C >= 0", psd(T(A1) * C1))),
       positive_definite(d), positive_semidefinite(d), "B93-P1.1.2", "B93-S14", "B93-S8")
_ideal("B93-P1.1.4", "H0 is a two-sided ideal", in_h0,
       (IN_SP, given("N: BA* > 0", pd(B1 * T(A1))), given("N: A*C > 0", pd(T(A1) * C1))),
       positive_definite(d), positive_definite(d), "B93-P1.1.2", "B93-P1.1.3")

claim("B93-L1.2", "I + PQ is invertible for nonnegative P and Q",
      invertible(Identity(d) + P * Q), sizes=["d"], over={P: positive_semidefinite(d), Q: positive_semidefinite(d)},
      by=[steps("B93-S15", "B93-S16", prose="By S16, as corrected, no eigenvalue of I + PQ is less than one."), instances(d=UP_TO_6)])

claim("B93-S15", "two quadratic forms, one positive, are diagonal in one basis",
      (inv(P) == T(M) * M) & (Q == T(M) * D * M) & psd(D) & (Identity(d) + P * Q == inv(M) * (Identity(d) + D) * M), sizes=["d"],
      over={P: positive_definite(d), Q: positive_semidefinite(d), L: nonsingular(d), U: matrix(d, d), D: diagonal(d)},
      where=[let(M, T(U) * inv(L))],
      given=[given("P = LL*", P == L * T(L)), given("U is orthogonal", T(U) * U == Identity(d)), given("U diagonalises L*QL", T(L) * Q * L == U * D * T(U))],
      by=[steps(facts=["a positive matrix is LL* for some nonsingular L", "a symmetric matrix is UDU* with U orthogonal and D diagonal"],
                prose="M = U*inv(L) is the matrix asked for."),
          instances(d=(1, 2, 3), using={W: matrix(d, d), E: diagonal(d), A: matrix(d, d)},
                    made_by={"P": L * T(L), "U": (Identity(d) - (W - T(W))) * inv(Identity(d) + (W - T(W))), "D": E * E,
                             "Q": inv(T(L)) * U * D * T(U) * inv(L)})],
      note="Existence is stated through the construction M = U*inv(L), where P = LL* and L*QL = UDU*.")

# the matrix of tr N^(i+j-1) is nonnegative exactly when all eigenvalues of N are real and nonnegative
claim("B93-S16", "the eigenvalues of I + PQ are greater than one",
      outside_roots(charpoly(Identity(d) + P * Q)) == d, sizes=["d"],
      over={P: positive_semidefinite(d), Q: positive_semidefinite(d)},
      by=[example(d=1, P=[[1]], Q=[[0]]), example(d=2, P=[[1, 0], [0, 1]], Q=[[1, 0], [0, 0]]), instances(d=(1, 2, 3, 4))],
      repair=repair("boundary case", "Each common or single null direction gives an eigenvalue one: they are at least one, and greater than one only if P and Q are both positive.",
                    psd(matrix_of(i, j, d, d, trace((P * Q) ** (i + j - 1)))) & iff(outside_roots(charpoly(Identity(d) + P * Q)) == d, pd(P) & pd(Q)),
                    sizes=["d"], over={P: positive_semidefinite(d), Q: positive_semidefinite(d)},
                    by=[steps("B93-S15", facts=["the Hankel matrix of the power sums of the eigenvalues, weighted by them, is nonnegative exactly when they are real and nonnegative"],
                              prose="The eigenvalues are 1 + D[i, i] for positive P; the others follow by continuity."),
                        instances(d=(1, 2, 3, 4))]),
      note="The eigenvalues are real, so greater than one means outside the unit circle.")

claim("B93-S17", "C1 inv(A1) and inv(A2)B2 are nonnegative",
      eq(Q1, inv(T(A1)) * (T(A1) * C1) * inv(A1)) & psd(Q1) & psd(P2), sizes=["d"], over=PAIR,
      where=[FORM, FIRST, LAST, let(Q1, C1 * inv(A1)), let(P2, inv(A2) * B2)],
      given=[standing("M1 in Sp", preserves_form(M1)), standing("M1: BA* >= 0", psd(B1 * T(A1))), given("M1: A*C >= 0", psd(T(A1) * C1)),
             standing("M2 in Sp", preserves_form(M2)), given("M2: BA* >= 0", psd(B2 * T(A2))), standing("M2: A*C >= 0", psd(T(A2) * C2))],
      by=[instances(d=UP_TO_6, using={P: positive_semidefinite(d), Q: positive_semidefinite(d), P1: positive_semidefinite(d), Q2: positive_semidefinite(d)},
                    made_by={**member(A1, B1, C1, D1, P1, Q), **member(A2, B2, C2, D2, P, Q2)})])

WITH_PQ = {**PAIR, Q1: symmetric_matrix(d), P2: symmetric_matrix(d)}
NAMED = [given("Q1 = C1 inv(A1)", Q1 == C1 * inv(A1)), given("P2 = inv(A2)B2", P2 == inv(A2) * B2)]
REACHED = {**member(A1, B1, C1, D1, P1, Q1), **member(A2, B2, C2, D2, P2, Q2)}
TYPED = {**PAIR, P1: positive_semidefinite(d), Q1: positive_semidefinite(d), P2: positive_semidefinite(d), Q2: positive_semidefinite(d)}

claim("B93-S18", "the first block of a product",
      eq(A3, A2 * A1 + B2 * C1, A2 * (Identity(d) + inv(A2) * B2 * C1 * inv(A1)) * A1, A2 * (Identity(d) + P2 * Q1) * A1) & invertible(A3),
      sizes=["d"], over=PAIR, where=[FORM, FIRST, LAST, *PRODUCT, let(Q1, C1 * inv(A1)), let(P2, inv(A2) * B2)],
      given=[standing("M1 in Sp", preserves_form(M1)), standing("M1: BA* >= 0", psd(B1 * T(A1))), given("M1: A*C >= 0", psd(T(A1) * C1)),
             standing("M2 in Sp", preserves_form(M2)), given("M2: BA* >= 0", psd(B2 * T(A2))), standing("M2: A*C >= 0", psd(T(A2) * C2))],
      by=[steps("B93-S17", "B93-L1.2", prose="The chain is an identity; the factor in the middle is invertible by Lemma 1.2."),
          instances(d=UP_TO_6, using={P: positive_semidefinite(d), Q: positive_semidefinite(d), P1: positive_semidefinite(d), Q2: positive_semidefinite(d)},
                    made_by={**member(A1, B1, C1, D1, P1, Q), **member(A2, B2, C2, D2, P, Q2)})])

BY_HAMILTON = {"given_by": REACHED, "covered_by": "B93-S38"}
TIED = [given("Q1 = C1 inv(A1)", C1 == Q1 * A1), given("P2 = inv(A2)B2", B2 == A2 * P2), standing("P1 = inv(A1)B1", B1 == A1 * P1), given("Q2 = C2 inv(A2)", C2 == Q2 * A2)]
SYMPLECTIC_PAIR = [standing("M1 in Sp", preserves_form(M1)), given("M2 in Sp", preserves_form(M2))]

claim("B93-S19", "two relations for the computation of C3",
      eq(T(A2) * D2, T(C2) * B2 + Identity(d), T(C2) * A2 * P2 + Identity(d), T(A2) * C2 * P2 + Identity(d)) & (C3 == C2 * A1 + D2 * C1),
      sizes=["d"], over=TYPED, where=[FORM, FIRST, LAST, *PRODUCT], given=[*TIED[1:2], *TIED[3:], *SYMPLECTIC_PAIR[1:]],
      by=[identity(**BY_HAMILTON, d=(1, 2, 3)), instances(d=UP_TO_6, made_by=REACHED)],
      note="Q2 = C2 inv(A2) is nonnegative by S17, as P2 is.")

SUM = T(A1) * (Identity(d) + Q1 * P2) * T(A2) * C2 * (Identity(d) + P2 * Q1) * A1 + T(A1) * C1 + T(C1) * P2 * C1
claim("B93-E8", "A3*C3 is a sum of three nonnegative matrices",
      eq(T(A3) * C3, T(A1) * (Identity(d) + Q1 * P2) * T(A2) * (C2 * A1 + D2 * C1),
         T(A1) * (Identity(d) + Q1 * P2) * (T(A2) * C2 * A1 + T(A2) * C2 * P2 * C1 + C1),
         T(A1) * (Identity(d) + Q1 * P2) * T(A2) * C2 * (A1 + P2 * C1) + T(A1) * C1 + T(C1) * P2 * C1,
         SUM),
      sizes=["d"], over=TYPED, where=[FORM, FIRST, LAST, *PRODUCT], given=[TIED[0], TIED[1], TIED[3], SYMPLECTIC_PAIR[1]],
      by=[identity(**BY_HAMILTON, d=(1, 2)), instances(d=UP_TO_6, made_by=REACHED)],
      note="Q1, P2 and Q2 are the matrices C inv(A) and inv(A)B of the two factors, nonnegative by S17.")

claim("B93-S20", "the two blocks of a product that have to be nonnegative",
      psd(T(A3) * C3) & psd(A3 * T(B3)), sizes=["d"], over=PAIR, where=[FORM, FIRST, LAST, *PRODUCT], given=BOTH,
      by=[steps("B93-E8", "B93-S17", "B93-S14", prose="Each summand of (8) is nonnegative; the other block follows by transposition."), instances(d=UP_TO_6, **MADE)])

ONE_INVERTIBLE = given("one of the A*C is invertible", invertible(T(A2) * C2) | invertible(T(A1) * C1))
HALF = {"using": {P1: positive_semidefinite(d), Q1: positive_definite(d), P2: positive_semidefinite(d), Q2: positive_semidefinite(d)}, "made_by": MADE["made_by"]}
OTHER_HALF = {"using": {P1: positive_semidefinite(d), Q1: positive_semidefinite(d), P2: positive_semidefinite(d), Q2: positive_definite(d)}, "made_by": MADE["made_by"]}

claim("B93-S21", "when A3*C3 is positive",
      pd(T(A3) * C3), sizes=["d"], over=PAIR, where=[FORM, FIRST, LAST, *PRODUCT], given=[*BOTH, ONE_INVERTIBLE],
      by=[steps("B93-E8", "B93-S18", prose="The summand with the invertible factor is positive, the others nonnegative."),
          instances(d=UP_TO_6, **HALF), instances(d=UP_TO_6, **OTHER_HALF)])

claim("B93-S22", "the ideal that this gives",
      in_h2(M3, A3, B3, C3), sizes=["d"], over=PAIR, where=[FORM, FIRST, LAST, *PRODUCT], given=[*BOTH, ONE_INVERTIBLE],
      by=[example(d=1, A1=[[1]], B1=[[0]], C1=[[1]], D1=[[1]], A2=[[1]], B2=[[0]], C2=[[1]], D2=[[1]]), instances(d=(1, 2, 3), **HALF)],
      repair=repair("index", "A positive A*C is the definition of H1: the two ideals are exchanged.",
                    in_h1(M3, A3, B3, C3), sizes=["d"], over=PAIR, where=[FORM, FIRST, LAST, *PRODUCT], given=[*BOTH, ONE_INVERTIBLE],
                    by=[steps("B93-P1.1.1", "B93-S21", prose="The product is in H, and its A*C is positive."),
                        instances(d=UP_TO_6, **HALF), instances(d=UP_TO_6, **OTHER_HALF)]))

# n members of H, side by side in wide matrices
As, Bs, Cs, Ds = symbols("As Bs Cs Ds")
Ak, Bk, Ck, Dk, Mk, Xi, Product, Tail, Alpha, Beta, Stack, X = symbols("A B C D M xi Product Tail alpha beta Stack X")
WIDE = {As: matrix(d, d * n), Bs: matrix(d, d * n), Cs: matrix(d, d * n), Ds: matrix(d, d * n)}
SEQUENCE = (
    FORM,
    function(Ak, [k], piece(As, d, d)), function(Bk, [k], piece(Bs, d, d)), function(Ck, [k], piece(Cs, d, d)), function(Dk, [k], piece(Ds, d, d)),
    function(Mk, [k], block([[Ak(k), Bk(k)], [Ck(k), Dk(k)]])),
    function(Product, [k], when(k == 1, Mk(1), Mk(k) * Product(k - 1))),
    function(Xi, [X], T(part(X, 0, 0)) * part(X, 1, 0)),
    function(Alpha, [k], when(k == 0, Identity(d), Ak(k) * Alpha(k - 1))),
)
ALL_IN_H = given("every M_k is in H", forall(k, 1, n, in_h(Mk(k), Ak(k), Bk(k), Ck(k))))
# the block column in which column j of a wide matrix stands, and its place there
NUMBER = 1 + sum_of(k, 1, n, when(j > k * d, 1, 0))


def _wide(term) -> object:
    """The wide matrix whose k-th piece is term(k)."""
    return matrix_of(i, j, d, d * n, to_expr(term(NUMBER))[i, j - (NUMBER - 1) * d])


def _square(wide, number, rank_):
    """F F*, F the piece of so many d x rank_ matrices."""
    F_k = matrix_of(a, b, d, rank_, wide[a, b + (number - 1) * rank_])
    return F_k * T(F_k)


def _members(rank_: int) -> dict:
    """How to make n members of H whose P and Q have no more than the given rank."""
    return {"using": {Us: matrix(d, rank_ * n), Vs: matrix(d, rank_ * n)},
            "made_by": {"Bs": _wide(lambda c: Ak(c) * _square(Us, c, rank_)), "Cs": _wide(lambda c: _square(Vs, c, rank_) * Ak(c)),
                        "Ds": _wide(lambda c: inv(T(Ak(c))) + _square(Vs, c, rank_) * Ak(c) * _square(Us, c, rank_))}}


Us, Vs, a, b = symbols("Us Vs a b")
MANY = (instances(d=(1, 2, 3), n=(1, 2, 3, 4), **_members(1)), instances(8, d=(2, 3), n=(1, 2), **_members(2)))
TWO_OR_MORE = (instances(d=(1, 2, 3), n=(2, 3, 4), **_members(1)), instances(8, d=(2, 3), n=(2, 3), **_members(2)))
OBSERVABILITY = sum_of(k, 1, n, T(Alpha(k - 1)) * (T(Ak(k)) * Ck(k)) * Alpha(k - 1))
CONTROLLABILITY = sum_of(k, 1, n, Beta(k) * (Bk(k) * T(Ak(k))) * T(Beta(k)))
WHOLE = (let(M3, Product(n)), let(A3, part(M3, 0, 0)), let(B3, part(M3, 0, 1)), let(C3, part(M3, 1, 0)))
RANGE = "The matrices M_1, .., M_n stand side by side, block by block, in As, Bs, Cs, Ds."

claim("B93-P1.3.1", "when a product is in H1",
      iff(in_h1(M3, A3, B3, C3), det(OBSERVABILITY) != 0), sizes=["d", "n"], over=WIDE, where=[*SEQUENCE, *WHOLE], given=[ALL_IN_H],
      by=[steps("B93-S26", "B93-S27", "B93-P1.1.1", prose="The product is in H, so it is in H1 exactly when its A*C has no null vector, and S27 names the null vectors."),
          *MANY], note=RANGE)

claim("B93-P1.3.2", "when a product is in H2",
      iff(in_h2(M3, A3, B3, C3), det(CONTROLLABILITY) != 0), sizes=["d", "n"], over=WIDE,
      where=[*SEQUENCE, *WHOLE, function(Beta, [k], when(k == n, Identity(d), Beta(k + 1) * Ak(k + 1)))], given=[ALL_IN_H],
      by=[steps("B93-P1.3.1", "B93-S14", prose="Transposition reverses the product and exchanges the two sums."), *MANY], note=RANGE)

claim("B93-S23", "the null vectors of A*C of a product of two",
      eq(rank(T(A3) * C3), rank(vstack(T(A1) * C1, T(A2) * C2 * A1)), rank(vstack(T(A3) * C3, T(A1) * C1, T(A2) * C2 * A1))),
      sizes=["d"], over=PAIR, where=[FORM, FIRST, LAST, *PRODUCT], given=SETTING,
      by=[steps("B93-E11", "B93-S24", "B93-S25", prose="By (11) a null vector of the sum is one of every summand, and C1 x = 0 makes P2 Q1 A1 x vanish."), instances(d=UP_TO_6, **MADE)],
      note="Two systems have the same solutions x exactly when each has the rank of both together.")

claim("B93-S24", "a null vector of a sum of nonnegative matrices is one of each",
      eq(rank(P + Q), rank(vstack(P, Q)), rank(vstack(P + Q, P, Q))), sizes=["d"],
      over={P: positive_semidefinite(d), Q: positive_semidefinite(d)},
      by=[instances(d=UP_TO_6)],
      note="Two systems have the same solutions x exactly when each has the rank of both together.")

claim("B93-S25", "a null vector of M*PM is one of PM",
      eq(rank(T(M) * P * M), rank(P * M)), sizes=["d", "r"], over={P: positive_semidefinite(d), M: matrix(d, r)},
      by=[instances(d=(1, 2, 3, 4), r=(1, 2, 3, 4))],
      note="The null vectors of PM are null vectors of M*PM, so that there are no others exactly when the ranks agree. M need not be square.")

claim("B93-E11", "A*C of a product as a sum of nonnegative matrices",
      (Xi(M3) == SUM) & psd(T(A1) * (Identity(d) + Q1 * P2) * T(A2) * C2 * (Identity(d) + P2 * Q1) * A1) & psd(T(A1) * C1) & psd(T(C1) * P2 * C1),
      sizes=["d"], over=TYPED, where=[FORM, FIRST, LAST, let(M3, M2 * M1), function(Xi, [X], T(part(X, 0, 0)) * part(X, 1, 0))],
      given=[TIED[0], TIED[1], TIED[3], SYMPLECTIC_PAIR[1]],
      by=[steps("B93-E8", "B93-S17", prose="Each summand is a congruence of a nonnegative matrix."), instances(d=UP_TO_6, made_by=REACHED)],
      note="The equation is (8).")

TAILS = function(Tail, [k], when(k == n, Mk(n), Tail(k + 1) * Mk(k)))
claim("B93-S26", "the null vectors of A*C of a product of n",
      eq(rank(Xi(Product(n))), rank(vstack(Xi(Mk(1)), Xi(Tail(2)) * Alpha(1))), rank(vstack(Xi(Product(n)), Xi(Mk(1)), Xi(Tail(2)) * Alpha(1))))
      & eq(rank(Xi(Product(n))), rank(Stack(n)), rank(vstack(Xi(Product(n)), Stack(n)))),
      sizes=["d", "n"], over=WIDE,
      where=[*SEQUENCE, TAILS, function(Stack, [k], when(k == 1, Xi(Mk(1)), vstack(Stack(k - 1), Xi(Mk(k)) * Alpha(k - 1))))], given=[ALL_IN_H],
      by=[steps("B93-S23", prose="S23 for M_1 and the product of the others, repeated."), *TWO_OR_MORE],
      note="Two systems have the same solutions x exactly when each has the rank of both together. Tail(2) is M_n ... M_2, for n at least two.")

claim("B93-S27", "one symmetric matrix for all the conditions",
      eq(rank(Stack(n)), rank(OBSERVABILITY), rank(vstack(Stack(n), OBSERVABILITY))),
      sizes=["d", "n"], over=WIDE,
      where=[*SEQUENCE, function(Stack, [k], when(k == 1, Xi(Mk(1)), vstack(Stack(k - 1), Xi(Mk(k)) * Alpha(k - 1))))], given=[ALL_IN_H],
      by=[steps("B93-S24", "B93-S25", prose="A sum of the nonnegative matrices X*PX vanishes at x exactly when each PXx does."), *MANY],
      note="Two systems have the same solutions x exactly when each has the rank of both together.")
