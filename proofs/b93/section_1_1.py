# SPDX-License-Identifier: MIT
"""The semigroup of Hamiltonian matrices (section 1.1).

A matrix M of order 2d is symplectic when M*JM = J. If N is its inverse, multiplying by J
on the left and by N on the right gives N = -JM*J, because
JJ = -I, and then MJM* = J: the transpose is symplectic too. (The printed text has
N = JM*J, which the identity matrix refutes.) In blocks, M*JM = J reads A*C = C*A,
B*D = D*B, A*D - C*B = I, and MJM* = J reads AB* = BA*, CD* = DC*, AD* - BC* = I.

H consists of the symplectic M with A invertible and BA*, A*C nonnegative. Then
P = inv(A)B and Q = C inv(A) are nonnegative, D = inv(A*) + QAP, and M is the
Hamiltonian matrix of the system with S = BA* and R = Q. H1 asks A*C > 0, H2 asks
BA* > 0, and transposition exchanges them.

For a product M3 = M2 M1 in H, A3 = A2(I + P2 Q1)A1 with P2 = inv(A2)B2 and
Q1 = C1 inv(A1). With H a symmetric root of P2 the inverse of I + P2 Q1 is
I - H inv(I + H Q1 H) H Q1 (Lemma 1.2). The eigenvalues of I + P2 Q1 are those of the
symmetric I + H Q1 H: at least one, and not all greater than one if P2 or Q1 is
singular. With X = (I + P2 Q1)A1 = inv(A2)A3,

    A3*C3 = X*(A2*C2)X + A1*C1 + C1*P2 C1,

which shows at once that A3*C3 is nonnegative, that it is positive when A1*C1 or A2*C2 is
(H1 is an ideal; the text says H2 at this place), and that its null space is the
common null space of A1*C1 and A2*C2 A1. Iterating the last remark gives
Proposition 1.3, by induction on n: the null vectors of A*C of a product are those of the sum,
and on them the upper left block of the product agrees with the product of the A.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import chosen, example, first, identity, induction, instances, null_vector, order, spectral, square, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    charpoly,
    diagonal,
    eq,
    forall,
    function,
    given,
    iff,
    inv,
    invertible,
    kernel_basis,
    let,
    matrix,
    matrix_of,
    nonneg,
    nonsingular,
    outside_roots,
    pd,
    positive_definite,
    positive_semidefinite,
    psd,
    rec,
    scalar,
    sequence_of,
    standing,
    sym,
    symbols,
    symmetric_matrix,
    symplectic,
    trace,
    vector,
    vstack,
)
from proofs.b93.notation import (
    FORM,
    Factor,
    J,
    Product,
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
    member_of_h,
    n,
    numbers,
    p,
    part,
    q,
    r,
)

A, B, C, D, M, N, F, P, Q, R, S, U, E, H, L, W, x = symbols("A B C D M N F P Q R S U E H L W x")
A1, B1, C1, D1, M1, P1, Q1 = symbols("A1 B1 C1 D1 M1 P1 Q1")
A2, B2, C2, D2, M2, P2, Q2 = symbols("A2 B2 C2 D2 M2 P2 Q2")
A3, B3, C3, M3, A4, B4, C4, M4 = symbols("A3 B3 C3 M3 A4 B4 C4 M4")
FIRST, LAST = let(M1, block([[A1, B1], [C1, D1]])), let(M2, block([[A2, B2], [C2, D2]]))
PRODUCT = (let(M3, M2 * M1), let(A3, part(M3, 0, 0)), let(B3, part(M3, 0, 1)), let(C3, part(M3, 1, 0)))
BLOCKS = let(M, block([[A, B], [C, D]]))
ANY_BLOCKS = {A: matrix(d, d), B: matrix(d, d), C: matrix(d, d), D: matrix(d, d)}
SYSTEM = (let(R, T(C) * C), let(S, F * T(F)), let(M, hamiltonian(A, S, R)))
PARAMETERS = {A: nonsingular(d), F: matrix(d, p), C: matrix(q, d)}
UP_TO_6 = (1, 2, 3, 4, 6)
SYSTEM_SIZES = {"d": UP_TO_6, "p": (1, 2, 3), "q": (1, 2, 3)}


def _symplectic(lower: bool = False) -> dict:
    """Blocks of a symplectic matrix; with ``lower`` one whose A = LP vanishes or is singular with P."""
    made = (L * P, -L, inv(T(L)) + Q * L * P, -(Q * L)) if lower else (L, L * P, Q * L, inv(T(L)) + Q * L * P)
    return {"using": {L: nonsingular(d), P: symmetric_matrix(d), Q: symmetric_matrix(d)},
            "made_by": dict(zip((A, B, C, D), made, strict=True))}


claim("B93-E7", "the Hamiltonian matrix is an observation update after a time update",
      M == block([[Identity(d), Zero(d, d)], [R, Identity(d)]])
      * block([[A, S * inv(T(A))], [Zero(d, d), inv(T(A))]]),
      sizes=["d", "p", "q"], over=PARAMETERS, where=SYSTEM,
      by=[identity(d=(1, 2), p=(1, 2), q=(1, 2)), instances(**SYSTEM_SIZES)],
      note="A definition. What is checked is that the blocks fit, and another form of the matrix.")

claim("B93-S5", "the symplectic matrices are closed under products",
      T(M * N) * J * (M * N) == J, sizes=["d"],
      over={**ANY_BLOCKS, A1: matrix(d, d), B1: matrix(d, d), C1: matrix(d, d), D1: matrix(d, d)},
      where=[FORM, BLOCKS, let(N, block([[A1, B1], [C1, D1]]))],
      given=[given("M in Sp", T(M) * J * M == J), given("N in Sp", T(N) * J * N == J)],
      by=[order(),
          instances(d=(1, 2, 3, 6), using={**_symplectic()["using"], P1: symmetric_matrix(d), Q1: symmetric_matrix(d)},
                    made_by={**_symplectic(lower=True)["made_by"], A1: L, B1: L * P1, C1: Q1 * L,
                             D1: inv(T(L)) + Q1 * L * P1})],
      note="A definition. What is checked is that it defines something closed under products; the inverse is S7.")

claim("B93-S6", "Hamiltonian matrices are symplectic",
      T(M) * J * M == J, sizes=["d", "p", "q"], over=PARAMETERS, where=[FORM, *SYSTEM],
      by=[identity(d=(1, 2), p=(1, 2), q=(1, 2)), instances(**SYSTEM_SIZES)])

INVERSE = {**ANY_BLOCKS, A1: matrix(d, d), B1: matrix(d, d), C1: matrix(d, d), D1: matrix(d, d)}
IS_INVERSE = given("N is the inverse of M", (M * N == Identity(2 * d)) & (N * M == Identity(2 * d)))
INVERSE_MADE = {A1: part(inv(M), 0, 0), B1: part(inv(M), 0, 1), C1: part(inv(M), 1, 0), D1: part(inv(M), 1, 1)}
BOTH_BLOCKS = [FORM, BLOCKS, let(N, block([[A1, B1], [C1, D1]]))]

claim("B93-S7", "the inverse of a symplectic matrix",
      iff(T(M) * J * M == J, N == J * T(M) * J), sizes=["d"], over=INVERSE, where=BOTH_BLOCKS, given=[IS_INVERSE],
      by=[example(d=1, A=[[1]], B=[[0]], C=[[0]], D=[[1]], A1=[[1]], B1=[[0]], C1=[[0]], D1=[[1]]),
          instances(d=(1, 2, 3), made_by=INVERSE_MADE)],
      repair=repair("sign", "JJ = -I, so that solving M*JM = J for the inverse of M gives a minus sign.",
                    iff(T(M) * J * M == J, N == -(J * T(M) * J)), sizes=["d"], over=INVERSE, where=BOTH_BLOCKS,
                    given=[IS_INVERSE],
                    by=[order(),
                        instances(d=(1, 2, 3, 6), using=_symplectic()["using"],
                                  made_by={**_symplectic()["made_by"], **INVERSE_MADE}),
                        instances(8, d=(1, 2), made_by=INVERSE_MADE)]))

claim("B93-S8", "the transpose of a symplectic matrix is symplectic",
      symplectic(T(M)), sizes=["d"], over=ANY_BLOCKS, where=[BLOCKS], given=[given("M in Sp", symplectic(M))],
      by=[order(), instances(d=(1, 2, 3, 6), **_symplectic()), instances(8, d=(1, 2, 3), **_symplectic(lower=True))],
      note="The relation S7, from which the text deduces this, has a wrong sign; the conclusion is right.")

claim("B93-S9", "the relations between the blocks of a symplectic matrix",
      (B * T(A) == A * T(B)) & (T(A) * C == T(C) * A) & (T(A) * D - T(C) * B == Identity(d)), sizes=["d"],
      over=ANY_BLOCKS, where=[BLOCKS], given=[given("M in Sp", symplectic(M))],
      by=[order(), instances(d=(1, 2, 3, 6), **_symplectic()), instances(8, d=(1, 2, 3), **_symplectic(lower=True))])

not_checked("B93-S10", "the set H of Hamiltonian matrices", "a definition: it fixes notation and asserts nothing",
            note="That H is not empty, S11 shows; S12 that it holds nothing else.")

claim("B93-S11", "Hamiltonian matrices are in H",
      in_h(M, A, S * inv(T(A)), R * A), sizes=["d", "p", "q"], over=PARAMETERS, where=SYSTEM,
      by=[order([], [], [F * T(F)], [T(A) * T(C) * C * A]), instances(**SYSTEM_SIZES)])

GENERAL = {A: nonsingular(d), B: matrix(d, d), C: matrix(d, d), D: matrix(d, d)}
MADE = {"using": {P: positive_semidefinite(d), Q: positive_semidefinite(d)}, "made_by": member(A, B, C, D, P, Q)}
SELF = Factor(A, B, C)

claim("B93-S12", "every member of H is the Hamiltonian matrix of a system",
      psd(C * inv(A)) & (M == hamiltonian(A, B * T(A), C * inv(A))), sizes=["d"], over=GENERAL, where=[BLOCKS],
      given=member_of_h(M, A, B, C, "Sp", "A*C"),
      by=[order([SELF.Q]), example(d=1, A=[[1]], B=[[0]], C=[[-1]], D=[[1]]), instances(d=UP_TO_6, **MADE)],
      note="With F and C_n the nonnegative symmetric roots of BA*, nonnegative by hypothesis, and of C inv(A), "
           "nonnegative as shown, FF* = BA* and C_n*C_n = C inv(A) are the S and R of (7).")

claim("B93-S13", "a positive A*C is a positive C inv(A), and a positive BA* a positive inv(A)B",
      iff(pd(T(A) * C), pd(C * inv(A))) & iff(pd(B * T(A)), pd(inv(A) * B)), sizes=["d"],
      over={A: nonsingular(d), B: matrix(d, d), C: matrix(d, d)},
      by=[order([SELF.Q], [T(A) * (C * inv(A)) * A], [SELF.P], [A * (inv(A) * B) * T(A)]),
          instances(d=UP_TO_6, using=MADE["using"], made_by={B: A * P, C: Q * A})],
      note="A definition. What is checked is the form in which it is used later: H1 asks C inv(A) > 0 and H2 asks "
           "inv(A)B > 0.")

DUAL = (let(N, T(M)), let(A1, T(A)), let(B1, T(C)), let(C1, T(B)))
claim("B93-S14", "transposition exchanges H1 and H2",
      iff(in_h1(M, A, B, C), in_h2(N, A1, B1, C1)), sizes=["d"], over=ANY_BLOCKS, where=[BLOCKS, *DUAL],
      by=[order(),
          instances(d=UP_TO_6, using={**MADE["using"], L: nonsingular(d)},
                    made_by={A: L, B: L * P, C: Q * L, D: inv(T(L)) + Q * L * P}),
          instances(d=(1, 2), **_symplectic()), instances(8, d=(1, 2), **_symplectic(lower=True))])

PAIR = {A1: nonsingular(d), B1: matrix(d, d), C1: matrix(d, d), D1: matrix(d, d),
        A2: nonsingular(d), B2: matrix(d, d), C2: matrix(d, d), D2: matrix(d, d)}
SETTING = [FORM, FIRST, LAST, *PRODUCT]
USING = {P1: positive_semidefinite(d), Q1: positive_semidefinite(d), P2: positive_semidefinite(d), Q2: positive_semidefinite(d)}
MADE_PAIR = {**member(A1, B1, C1, D1, P1, Q1), **member(A2, B2, C2, D2, P2, Q2)}
PAIRS = instances(d=(1, 2, 3, 6), using=USING, made_by=MADE_PAIR)
ONE, TWO = Factor(A1, B1, C1), Factor(A2, B2, C2)
BOTH = Product(TWO, ONE, A3, H)
ALL = ("Sp", "BA*", "A*C")
PAIR_IN_H = [*member_of_h(M1, A1, B1, C1, *ALL), *member_of_h(M2, A2, B2, C2, *ALL)]


def _pair(first: tuple, last: tuple, **more: int):
    """An example with d = 1, mostly one that shows a hypothesis to be needed."""
    return example(numbers("A1 B1 C1 D1 A2 B2 C2 D2", *first, *last, **more))


ID, UP, DOWN = (1, 0, 0, 1), (1, 1, 0, 1), (1, 0, 1, 1)  # members of H
NOT_UP, NOT_DOWN = (1, -1, 0, 1), (1, 0, -1, 1)  # symplectic, with BA* or A*C negative
NEEDED = [_pair(NOT_UP, ID), _pair(NOT_DOWN, ID), _pair(ID, NOT_UP), _pair(ID, NOT_DOWN), _pair((1, 0, 1, -5), UP),
          _pair(DOWN, (1, 0, 0, -1))]

claim("B93-P1.1.1", "H is a semigroup",
      in_h(M3, A3, B3, C3), sizes=["d"], over=PAIR, where=SETTING, given=PAIR_IN_H,
      by=[order([], BOTH.inverse, BOTH.upper, BOTH.lower, roots=BOTH.roots), *NEEDED, PAIRS])

SIDES = (let(M3, M * N), let(A3, part(M3, 0, 0)), let(B3, part(M3, 0, 1)), let(C3, part(M3, 1, 0)),
         let(M4, N * M), let(A4, part(M4, 0, 0)), let(B4, part(M4, 0, 1)), let(C4, part(M4, 1, 0)))
WITH_N = {**GENERAL, A1: nonsingular(d), B1: matrix(d, d), C1: matrix(d, d), D1: matrix(d, d)}
K = symbols("K")[0]
LEFT, RIGHT = Product(SELF, ONE, A3, H), Product(ONE, SELF, A4, K)


def _ideal(ledger_id: str, title: str, test, signs: tuple, p_type: tuple, q_type: tuple, in_it: tuple, *not_in_it: tuple) -> None:
    """M in H, N in the subset: MN and NM are in the subset."""
    claim(ledger_id, title, test(M3, A3, B3, C3) & test(M4, A4, B4, C4),
          sizes=["d"], over=WITH_N, where=[BLOCKS, let(N, block([[A1, B1], [C1, D1]])), *SIDES],
          given=[*member_of_h(M, A, B, C, *ALL), given("N in Sp", symplectic(N)), *signs],
          by=[order([], LEFT.inverse, LEFT.upper, LEFT.lower, [], RIGHT.inverse, RIGHT.upper, RIGHT.lower,
                    roots={**LEFT.roots, **RIGHT.roots}),
              *(example(numbers("A B C D A1 B1 C1 D1", *x, *in_it)) for x in (NOT_UP, NOT_DOWN, (1, 0, 0, 2))),
              *(example(numbers("A B C D A1 B1 C1 D1", *ID, *x)) for x in (*not_in_it, (1, 1, 1, 5))),
              instances(d=(1, 2, 3, 6), using={**MADE["using"], P1: p_type, Q1: q_type},
                        made_by={**member(A, B, C, D, P, Q), **member(A1, B1, C1, D1, P1, Q1)})])


_ideal("B93-P1.1.2", "H1 is a two-sided ideal", in_h1,
       (given("N: BA* >= 0", psd(B1 * T(A1))), given("N: A*C > 0", pd(T(A1) * C1))),
       positive_semidefinite(d), positive_definite(d), DOWN, ID, (1, -1, 1, 0))
_ideal("B93-P1.1.3", "H2 is a two-sided ideal", in_h2,
       (given("N: BA* > 0", pd(B1 * T(A1))), given("N: A*C >= 0", psd(T(A1) * C1))),
       positive_definite(d), positive_semidefinite(d), UP, ID, (1, 1, -1, 0))
_ideal("B93-P1.1.4", "H0 is a two-sided ideal", in_h0,
       (given("N: BA* > 0", pd(B1 * T(A1))), given("N: A*C > 0", pd(T(A1) * C1))),
       positive_definite(d), positive_definite(d), (1, 1, 1, 2), UP, DOWN)

ZERO = Zero(d, d)
NONNEGATIVE_PAIR = {P: positive_semidefinite(d), Q: positive_semidefinite(d)}
claim("B93-L1.2", "I + PQ is invertible for nonnegative P and Q",
      invertible(Identity(d) + P * Q), sizes=["d"], over=NONNEGATIVE_PAIR,
      by=[order([Identity(d) - H * inv(Identity(d) + H * Q * H) * H * Q], roots={H: P}), instances(d=UP_TO_6)])

claim("B93-S15", "two quadratic forms, one positive, are diagonal in one basis",
      invertible(M) & (inv(P) == T(M) * M) & (Q == T(M) * D * M) & psd(D)
      & (Identity(d) + P * Q == inv(M) * (Identity(d) + D) * M), sizes=["d"],
      over={P: positive_definite(d), Q: positive_semidefinite(d), L: nonsingular(d), U: matrix(d, d), D: diagonal(d)},
      where=[let(M, T(U) * inv(L))],
      given=[given("P = LL*", P == L * T(L)), given("U is orthogonal", T(U) * U == Identity(d)),
             given("U diagonalises L*QL", T(L) * Q * L == U * D * T(U))],
      by=[order([L * U], [], [], [T(U) * (T(L) * Q * L) * U]), chosen(square(P, L), spectral(T(L) * Q * L, U, D)),
          instances(d=(1, 2, 3), using={W: matrix(d, d), E: diagonal(d)},
                    made_by={P: L * T(L), U: (Identity(d) - (W - T(W))) * inv(Identity(d) + (W - T(W))), D: E * E,
                             Q: inv(T(L)) * U * D * T(U) * inv(L)})],
      note="The matrix M asked for is M = U*inv(L); there are such L, U and D for all P and Q. A nonnegative diagonal matrix has nonnegative entries.")

a, b, y, w = symbols("a b y w")
#: 1 - a: how far a is below one
LACK = 1 - a


def _vanishing():
    """Terms with a sum that vanishes at an eigenvector x + iy for a < 1: so PQx and PQy do."""
    return [LACK * T(x) * Q * x, LACK * T(y) * Q * y, T(x) * Q * P * Q * x, T(y) * Q * P * Q * y]


IMAGINARY = [T(b * x) * Q * (b * x), T(b * y) * Q * (b * y)]


def _eigenvalues_of_one_and_more():
    """For a < 1 the eigenvector x + iy is zero, and bx and by are in any case."""
    below = [within(k, P * Q * x == Zero(d, 1), P * Q * y == Zero(d, 1)) for k in (0, 1)]
    real = [within(k, Q * (b * x) == Zero(d, 1), Q * (b * y) == Zero(d, 1), b**2 * z == Zero(d, 1)) for k, z in ((2, x), (3, y))]
    over = [_vanishing(), _vanishing(), [1 / (LACK**2 + b**2)]]
    return order(*over, *over, *([*[IMAGINARY] * 2, [T(b**2 * z) * (b**2 * z), T(b * LACK * z) * (b * LACK * z)], [T(b * z) * (b * z)]][k] for z in (x, y) for k in range(4)),
                 inside=[*below, *real])


claim("B93-S16", "the eigenvalues of I + PQ are greater than one",
      outside_roots(charpoly(Identity(d) + P * Q)) == d, sizes=["d"], over=NONNEGATIVE_PAIR,
      by=[example(d=1, P=[[1]], Q=[[0]]), example(d=2, P=[[1, 0], [0, 1]], Q=[[1, 0], [0, 0]]), instances(d=(1, 2, 3))],
      repair=repair(
          "boundary case",
          "Every null vector of P or of Q gives the eigenvalue one: the eigenvalues are at least one, and greater than "
          "one only if both matrices are positive.",
          ((a < 1) >> ((x == Zero(d, 1)) & (y == Zero(d, 1)))) & (b * x == Zero(d, 1)) & (b * y == Zero(d, 1)),
          sizes=["d"], over={P: positive_semidefinite(d), Q: positive_semidefinite(d), x: vector(d), y: vector(d), a: scalar(), b: scalar()},
          given=[given("real part", (Identity(d) + P * Q) * x == a * x - b * y), given("imaginary part", (Identity(d) + P * Q) * y == b * x + a * y)],
          by=[_eigenvalues_of_one_and_more(),
              instances(8, d=(1, 2, 3), using={w: vector(d)}, made_by={P: w * T(w), x: w, y: 0 * w, a: 1 + trace(T(w) * Q * w), b: 0}),
              instances(8, d=(1, 2, 3), using={w: vector(d)}, made_by={P: w * T(w), x: 0 * w, y: w, a: 1 + trace(T(w) * Q * w), b: 0}),
              instances(8, d=(1, 2), using={w: vector(d)}, made_by={x: 0 * w, y: 0 * w})]),
      note="The eigenvalues are real, so greater than one means outside the unit circle. In the correction x + iy is an eigenvector, if it is not zero, "
           "for the eigenvalue a + ib of I + PQ: then b is zero, and a is at least one.")

claim("B93-S17", "C1 inv(A1) and inv(A2)B2 are nonnegative",
      (Q1 == inv(T(A1)) * (T(A1) * C1) * inv(A1)) & psd(Q1) & psd(P2), sizes=["d"], over=PAIR,
      where=[FIRST, LAST, let(Q1, C1 * inv(A1)), let(P2, inv(A2) * B2)],
      given=[*member_of_h(M1, A1, B1, C1, "A*C"), *member_of_h(M2, A2, B2, C2, "BA*")],
      by=[order([], [ONE.Q], [TWO.P]), _pair(NOT_DOWN, ID), _pair(ID, NOT_UP),
          instances(d=UP_TO_6, using={P: positive_semidefinite(d), Q: positive_semidefinite(d), U: positive_semidefinite(d), W: positive_semidefinite(d)},
                    made_by={**member(A1, B1, C1, D1, P, Q), **member(A2, B2, C2, D2, U, W)})])

NAMED = (let(Q1, C1 * inv(A1)), let(P2, inv(A2) * B2))
PAIRS_PQ = instances(d=(1, 2, 3, 6), using={P: positive_semidefinite(d), Q: positive_semidefinite(d), U: positive_semidefinite(d), W: positive_semidefinite(d)},
                     made_by={**member(A1, B1, C1, D1, P, Q), **member(A2, B2, C2, D2, U, W)})

claim("B93-S18", "the first block of a product",
      eq(A3, A2 * A1 + B2 * C1, A2 * (Identity(d) + inv(A2) * B2 * C1 * inv(A1)) * A1, A2 * (Identity(d) + P2 * Q1) * A1)
      & invertible(A3),
      sizes=["d"], over=PAIR, where=[*SETTING, *NAMED],
      given=[*member_of_h(M1, A1, B1, C1, "A*C"), *member_of_h(M2, A2, B2, C2, "BA*")],
      by=[order([], BOTH.inverse, roots=BOTH.roots), _pair(NOT_DOWN, UP), _pair(DOWN, NOT_UP), PAIRS_PQ])

claim("B93-S19", "two relations for the computation of C3",
      eq(T(A2) * D2, T(C2) * B2 + Identity(d), T(C2) * A2 * P2 + Identity(d), T(A2) * C2 * P2 + Identity(d))
      & (C3 == C2 * A1 + D2 * C1),
      sizes=["d"], over=PAIR, where=[*SETTING, *NAMED],
      given=[*member_of_h(M1, A1, B1, C1), *member_of_h(M2, A2, B2, C2, "Sp")],
      by=[order(), PAIRS_PQ])

SQUEEZED = (Identity(d) + P2 * Q1) * A1
TERM = T(A1) * (Identity(d) + Q1 * P2) * T(A2) * C2 * (Identity(d) + P2 * Q1) * A1
claim("B93-E8", "A3*C3 is a sum of three nonnegative matrices",
      eq(T(A3) * C3, T(A1) * (Identity(d) + Q1 * P2) * T(A2) * (C2 * A1 + D2 * C1),
         T(A1) * (Identity(d) + Q1 * P2) * (T(A2) * C2 * A1 + T(A2) * C2 * P2 * C1 + C1),
         T(A1) * (Identity(d) + Q1 * P2) * T(A2) * C2 * (A1 + P2 * C1) + T(A1) * C1 + T(C1) * P2 * C1,
         TERM + T(A1) * C1 + T(C1) * P2 * C1),
      sizes=["d"], over=PAIR, where=[*SETTING, *NAMED],
      given=[*member_of_h(M1, A1, B1, C1), *member_of_h(M2, A2, B2, C2, "Sp")],
      by=[order(), PAIRS_PQ])

claim("B93-S20", "the two blocks of a product that have to be nonnegative",
      psd(T(A3) * C3) & psd(A3 * T(B3)), sizes=["d"], over=PAIR, where=SETTING, given=PAIR_IN_H,
      by=[order(BOTH.lower, BOTH.upper), *NEEDED, PAIRS])

ONE_INVERTIBLE = given("one of the A*C is invertible", invertible(T(A2) * C2) | invertible(T(A1) * C1))
HALF = instances(d=(1, 2, 3, 6), using={**USING, Q1: positive_definite(d)}, made_by=MADE_PAIR)
OTHER_HALF = instances(d=(1, 2, 3, 6), using={**USING, Q2: positive_definite(d)}, made_by=MADE_PAIR)

claim("B93-S21", "when A3*C3 is positive",
      pd(T(A3) * C3), sizes=["d"], over=PAIR, where=SETTING,
      given=[*member_of_h(M1, A1, B1, C1, "A*C"), *member_of_h(M2, A2, B2, C2, *ALL), ONE_INVERTIBLE],
      by=[order(BOTH.inverse, BOTH.lower, BOTH.inverse, BOTH.lower, roots=BOTH.roots, lemmas=[invertible(A3)]),
          *NEEDED[1:], _pair(ID, ID), _pair(DOWN, NOT_UP), HALF, OTHER_HALF])

IN_H1 = (*[[], BOTH.inverse, BOTH.upper, BOTH.lower],) * 2
claim("B93-S22", "the ideal that this gives",
      in_h2(M3, A3, B3, C3), sizes=["d"], over=PAIR, where=SETTING, given=[*PAIR_IN_H, ONE_INVERTIBLE],
      by=[example(d=1, A1=[[1]], B1=[[0]], C1=[[1]], D1=[[1]], A2=[[1]], B2=[[0]], C2=[[1]], D2=[[1]]), HALF],
      repair=repair("index", "A positive A*C is the definition of H1: the two ideals are exchanged.",
                    in_h1(M3, A3, B3, C3), sizes=["d"], over=PAIR, where=SETTING, given=[*PAIR_IN_H, ONE_INVERTIBLE],
                    by=[order(*IN_H1, roots=BOTH.roots), *NEEDED, _pair(ID, ID), _pair(DOWN, NOT_UP), _pair((1, -1, 1, 0), ID),
                        HALF, OTHER_HALF]))

# ---------------------------------------------------------------- n members of H
Xi, X = symbols("xi X")
XI = function(Xi, [X], T(part(X, 0, 0)) * part(X, 1, 0))


def _null_vector(matrix_) -> object:
    """The first of a basis of the null space, where it is not zero alone."""
    return matrix_of(i, j, d, 1, kernel_basis(matrix_)[i, 1])


claim("B93-S23", "the null vectors of A*C of a product of two",
      iff(Xi(M3) * x == Zero(d, 1), (Xi(M1) * x == Zero(d, 1)) & (Xi(M2) * A1 * x == Zero(d, 1))), sizes=["d"],
      over={**PAIR, x: vector(d)}, where=[*SETTING, XI],
      given=[*member_of_h(M1, A1, B1, C1, "A*C"), *member_of_h(M2, A2, B2, C2, *ALL)],
      by=[order(BOTH.lower, BOTH.lower, [inv(A1), inv(A2)]),
          _pair(NOT_DOWN, UP, x=1), _pair(DOWN, NOT_UP, x=1), _pair(DOWN, NOT_DOWN, x=1), _pair(DOWN, (1, 0, 0, 0), x=1),
          instances(d=(1, 2, 3), using=USING, made_by={**MADE_PAIR, x: _null_vector(T(A3) * C3)}),
          instances(8, d=(1, 2, 3), using=USING, made_by={**MADE_PAIR, x: _null_vector(T(A1) * C1)}),
          instances(8, d=(1, 2, 3), using=USING, made_by={**MADE_PAIR, x: _null_vector(T(A2) * C2 * A1)}),
          instances(8, d=(1, 2, 3), using=USING, made_by=MADE_PAIR)])

claim("B93-S24", "a null vector of a sum of nonnegative matrices is one of each",
      (P * x == Zero(d, 1)) & (Q * x == Zero(d, 1)), sizes=["d"], over={**NONNEGATIVE_PAIR, x: vector(d)},
      given=[given("(P + Q)x = 0", (P + Q) * x == Zero(d, 1))],
      by=[order([P, Q], [P, Q]), instances(d=UP_TO_6, made_by={x: _null_vector(P + Q)}), instances(8, d=(1, 2, 3))])

claim("B93-S25", "a null vector of M*PM is one of PM",
      (T(M) * P * M * x == Zero(r, 1)) >> (P * M * x == Zero(d, 1)), sizes=["d", "r"],
      over={P: positive_semidefinite(d), M: matrix(d, r), x: vector(r)},
      by=[order([T(M) * P * M]),
          instances(d=(1, 2, 3, 4), r=(1, 2, 3, 4), made_by={x: matrix_of(i, j, r, 1, kernel_basis(T(M) * P * M)[i, 1])}),
          instances(8, d=(1, 2, 3), r=(1, 2, 3))],
      note="M need not be square.")

claim("B93-E11", "A*C of a product as a sum of nonnegative matrices",
      (Xi(M3) == TERM + T(A1) * C1 + T(C1) * P2 * C1) & psd(TERM) & psd(T(A1) * C1) & psd(T(C1) * P2 * C1),
      sizes=["d"], over=PAIR, where=[FIRST, LAST, let(M3, M2 * M1), XI, *NAMED],
      given=[*member_of_h(M1, A1, B1, C1, "A*C"), *member_of_h(M2, A2, B2, C2, *ALL)],
      by=[_pair(NOT_DOWN, ID), _pair(DOWN, NOT_UP), _pair(ID, NOT_DOWN), _pair(DOWN, (1, 0, 0, -1)),
          order([], [T(SQUEEZED) * TWO.AC * SQUEEZED], [], BOTH.lower[2:]), PAIRS_PQ])

# The product of the first t matrices is [[a, b], [c, e]]; alpha is the product of their A; O and K are the two sums.
t, a, b, c, e, alpha, O, K_, Z_, Y_, N_, W_, Ps, Qs = symbols("t a b c e alpha O K Z Y N W Ps Qs")
As, Bs, Cs, Ds = symbols("A B C D")
Mk, Pi, Both = symbols("M Pi both")
MEMBERS = {As: sequence_of(nonsingular(d), 1, n), Bs: sequence_of(matrix(d, d), 1, n), Cs: sequence_of(matrix(d, d), 1, n),
           Ds: sequence_of(matrix(d, d), 1, n)}
PRODUCTS = (
    function(Mk, [k], block([[As[k], Bs[k]], [Cs[k], Ds[k]]])),
    rec(a, t, Identity(d), As[t + 1] * a[t] + Bs[t + 1] * c[t]), rec(b, t, ZERO, As[t + 1] * b[t] + Bs[t + 1] * e[t]),
    rec(c, t, ZERO, Cs[t + 1] * a[t] + Ds[t + 1] * c[t]), rec(e, t, Identity(d), Cs[t + 1] * b[t] + Ds[t + 1] * e[t]),
    function(Pi, [k], block([[a[k], b[k]], [c[k], e[k]]])),
)
ALPHA = rec(alpha, t, Identity(d), As[t + 1] * alpha[t])
OBSERVABILITY = rec(O, t, ZERO, O[t] + T(alpha[t]) * (T(As[t + 1]) * Cs[t + 1]) * alpha[t])
CONTROLLABILITY = rec(K_, t, ZERO, As[t + 1] * K_[t] * T(As[t + 1]) + Bs[t + 1] * T(As[t + 1]))
ALL_IN_H = given("every M_k is in H", forall(k, 1, n, in_h(Mk(k), As[k], Bs[k], Cs[k])))
COMPLEMENTS = {name: sequence_of(matrix(d, d), 0, n) for name in (N_, Z_, W_, Y_)}


def _complement(label: str, of, projection, inverse_) -> tuple:
    """The columns of the projection are the null vectors of the matrix: it is I less a generalized inverse times the matrix."""
    return standing(label, forall(k, 0, n, (of(k) * projection[k] == ZERO) & (projection[k] == Identity(d) - inverse_[k] * of(k))))


def _generalized(of) -> tuple:
    """A generalized inverse of a symmetric matrix, from a basis of its null space."""
    return (k, inv(of(k) + kernel_basis(of(k)) * T(kernel_basis(of(k)))))


def _made(*pairs) -> dict:
    made = {Bs: (k, As[k] * Ps[k]), Cs: (k, Qs[k] * As[k]), Ds: (k, inv(T(As[k])) + Qs[k] * As[k] * Ps[k])}
    for of, projection, inverse_ in pairs:
        made |= {inverse_: _generalized(of), projection: (k, Identity(d) - inverse_[k] * of(k))}
    return made


def _lower(s): return T(a[s]) * c[s]
def _upper(s): return b[s] * T(a[s])
def _observed(s): return O[s]
def _controlled(s): return K_[s]


BOTH_LOWER = ((_lower, N_, Z_), (_observed, W_, Y_))
BOTH_UPPER = ((_upper, N_, Z_), (_controlled, W_, Y_))
A_t, B_t, C_t = As[t + 1], Bs[t + 1], Cs[t + 1]
NEW, OLD = Factor(A_t, B_t, C_t), Factor(a[t], b[t], c[t])
NEXT = Product(NEW, OLD, A_t * a[t] + B_t * c[t], H)
IN_H_t = [symplectic(Pi(t)), invertible(a[t]), psd(_upper(t)), psd(_lower(t))]
NULL_SQUARE = ZERO * T(ZERO)
SUM_O = [O[t], T(alpha[t]) * NEW.AC * alpha[t]]
SUM_K = [A_t * K_[t] * T(A_t), NEW.BA]
NULL_SUMS = ([], [], [NULL_SQUARE], [NULL_SQUARE], [NULL_SQUARE])
START = order(*NULL_SUMS)
RANK_ONE = {Ps: sequence_of(positive_semidefinite(d), 1, n), Qs: sequence_of(positive_semidefinite(d), 1, n)}


def _many(*pairs, **more) -> object:
    return instances(10, d=(1, 2), n=(1, 2, 3), using=RANK_ONE, made_by={**_made(*pairs), **more})


def _null_at(matrix_) -> object:
    return matrix_of(i, j, d, 1, kernel_basis(matrix_)[i, 1])


def _both_positive(half, xi, total, number):
    """A null vector of the sum is one of xi, and one of xi is one of the sum: both are invertible or none."""
    v = null_vector()
    return [within(number, half * v == Zero(d, 1), inv(xi) * xi * v == v, vector="right"),
            within(number + 1, inv(total) * total == Identity(d), invertible(xi))]


SERVING = ("A determinant is not zero exactly where the matrix is invertible; the product is that of the first t matrices. N, W are I - Z xi, I - Y O "
           "with generalized inverses Z, Y, which every matrix has: the proof uses them to name all null vectors at once.")
claim("B93-P1.3.1", "a product is in H, and in H1 if and only if the sum is invertible",
      forall(t, 0, n, in_h(Pi(t), a[t], b[t], c[t]) & iff(pd(_lower(t)), invertible(O[t]))), sizes=["d", "n"],
      over={**MEMBERS, **COMPLEMENTS}, where=[*PRODUCTS, ALPHA, OBSERVABILITY],
      given=[ALL_IN_H, *(_complement(f"null vectors {m}", *pair) for m, pair in enumerate(BOTH_LOWER))],
      by=[induction(also=[*IN_H_t, psd(O[t]), (alpha[t] - a[t]) * N_[t] == ZERO, O[t] * N_[t] == ZERO, c[t] * W_[t] == ZERO,
                          (alpha[t] - a[t]) * W_[t] == ZERO],
                    base=order(*NULL_SUMS, inside=_both_positive(c[t], _lower(t), O[t], 13)),
                    step=order([], NEXT.inverse, NEXT.upper, NEXT.lower, SUM_O, NEXT.lower, NEXT.lower, SUM_O, SUM_O,
                               [], NEXT.inverse, NEXT.upper, NEXT.lower, *[[]] * 5, [_lower(t + 1)], roots=NEXT.roots,
                               inside=_both_positive(c[t + 1], _lower(t + 1), O[t + 1], 13))),
          _many(*BOTH_LOWER)],
      note=SERVING)

claim("B93-P1.3.2", "a product is in H, and in H2 if and only if the sum is invertible",
      forall(t, 0, n, in_h(Pi(t), a[t], b[t], c[t]) & iff(pd(_upper(t)), invertible(K_[t]))), sizes=["d", "n"],
      over={**MEMBERS, **COMPLEMENTS}, where=[*PRODUCTS, CONTROLLABILITY],
      given=[ALL_IN_H, *(_complement(f"null vectors {m}", *pair) for m, pair in enumerate(BOTH_UPPER))],
      by=[induction(also=[*IN_H_t, psd(K_[t]), K_[t] * N_[t] == ZERO, T(b[t]) * W_[t] == ZERO],
                    base=order(*NULL_SUMS, inside=_both_positive(T(b[t]), _upper(t), K_[t], 11)),
                    step=order([], NEXT.inverse, NEXT.upper, NEXT.lower, SUM_K, NEXT.upper, SUM_K,
                               [], NEXT.inverse, NEXT.upper, NEXT.lower, *[[]] * 5, [_upper(t + 1)], roots=NEXT.roots,
                               inside=_both_positive(T(b[t + 1]), _upper(t + 1), K_[t + 1], 11))),
          _many(*BOTH_UPPER)],
      note=SERVING)

def _tail(left, right) -> tuple:
    """A row of blocks of M_n ... M_(n-t), from the same row with t factors."""
    return left * As[n - t] + right * Cs[n - t], left * Bs[n - t] + right * Ds[n - t]


#: the product of the last t matrices is [[a, b], [c, e]] here
TAIL_STEPS = {name: value for row in ((a, b), (c, e)) for name, value in zip(row, _tail(row[0][t], row[1][t]), strict=True)}
TAILS = (function(Mk, [k], block([[As[k], Bs[k]], [Cs[k], Ds[k]]])), function(Pi, [k], block([[a[k], b[k]], [c[k], e[k]]])),
         *(rec(name, t, start, TAIL_STEPS[name]) for name, start in ((a, Identity(d)), (b, ZERO), (c, ZERO), (e, Identity(d)))))
y, z = symbols("y z")
FROM_END = standing("the recursions, counted from the end", forall(t, 0, n - 1, (alpha[t + 1] == As[t + 1] * alpha[t]) & (
    a[t + 1] == TAIL_STEPS[a]) & (b[t + 1] == TAIL_STEPS[b]) & (c[t + 1] == TAIL_STEPS[c]) & (e[t + 1] == TAIL_STEPS[e])))


def _xi(s): return T(As[s]) * Cs[s]


def _peeled(s, count, root=H) -> Product:
    """The product of the last ``count`` matrices, times M_s."""
    return Product(Factor(a[count], b[count], c[count]), Factor(As[s], Bs[s], Cs[s]), a[count] * As[s] + b[count] * Cs[s], root)


def _forms(s, count) -> list:
    """The summands of xi of that product as quadratic forms at alpha_(s-1) x."""
    new, v = inv(a[count]) * (a[count] * As[s] + b[count] * Cs[s]), alpha[s - 1] * x
    behind = T(inv(a[count]))
    return [T(v) * T(new) * _lower(count) * new * v, T(v) * _xi(s) * v, T(v) * T(Cs[s]) * (inv(a[count]) * _upper(count) * behind) * Cs[s] * v]


NEXT_TAIL = _peeled(n - t, t)
FIRST_PEELED, THEN_PEELED = _forms(t, n - t), _forms(t + 1, n - t - 1)
IN_H_BY = {"base": order([], [], [NULL_SQUARE], [NULL_SQUARE]),
           "step": order([], NEXT_TAIL.inverse, NEXT_TAIL.upper, NEXT_TAIL.lower, roots=NEXT_TAIL.roots)}
W_Y = alpha[k] * y
Q_Y = (Identity(d) - W_Y * T(W_Y) / (T(W_Y) * W_Y)[1, 1]) * (r + k)
SINGLE = {"d": 1, "n": 1, "A": [[[1]]], "B": [[[0]]], "C": [[[1]]], "D": [[[1]]], "x": [0], "y": [0], "z": [[[0]]]}
claim("B93-S26", "the null vectors of A*C of a product, one factor at a time",
      forall(t, 0, n, in_h(Pi(t), a[t], b[t], c[t]))
      & forall(t, 1, n, vstack(_xi(t) * alpha[t - 1], _lower(n - t) * alpha[t]) * x == Zero(2 * d, 1))
      & forall(t, 1, n, _lower(t) * z[t] == Zero(d, 1)) & (_lower(n) * y == Zero(d, 1)),
      sizes=["d", "n"], over={**MEMBERS, x: vector(d), y: vector(d), z: sequence_of(matrix(d, 1), 1, n)},
      where=[*TAILS, ALPHA],
      given=[ALL_IN_H, FROM_END, given("xi(M_n ... M_1) x = 0", _lower(n) * x == Zero(d, 1)),
             given("the last factor and the product of those before it at z", forall(k, 1, n, (_xi(n - k + 1) * z[k] == Zero(d, 1)) & (
                 _lower(k - 1) * As[n - k + 1] * z[k] == Zero(d, 1)))),
             given("y satisfies all the conditions", forall(k, 1, n, _xi(k) * alpha[k - 1] * y == Zero(d, 1)))],
      by=[induction(before=[first(forall(t, 0, n, in_h(Pi(t), a[t], b[t], c[t])), **IN_H_BY),
                            first(forall(t, 0, n, _lower(t) * alpha[n - t] * y == Zero(d, 1)))],
                    also=[[], [_lower(n - t) * alpha[t] * x == Zero(d, 1)], [], []],
                    base=[IN_H_BY["base"], order(FIRST_PEELED, FIRST_PEELED), order(), order()],
                    step=[IN_H_BY["step"], order(THEN_PEELED, THEN_PEELED), order()]),
          example({**SINGLE, "x": [1]}), example({**SINGLE, "y": [1]}), example({**SINGLE, "z": [[[1]]]}),
          example({**SINGLE, "n": 2, "A": [[[1]], [[1]]], "B": [[[0]], [[0]]], "C": [[[1]], [[-1]]], "D": [[[1]], [[1]]], "x": [1], "z": [[[0]], [[0]]]}),
          instances(12, d=(1, 2), n=(1, 2, 3), using={**RANK_ONE, r: nonneg()},
                    made_by={Qs: (k, Q_Y), **_made(), x: r * y, z: (k, alpha[n - k] * y)})],
      note="The product of the last t matrices is M_n ... M_(n-t+1) here, and in H, by Proposition 1.1. From the left to the right: an x with "
           "xi(M_n ... M_1)x = 0 has xi(M_t) alpha x = 0 and xi(M_n ... M_(t+1)) alpha(M_t) alpha x = 0 for every t, with alpha the product of the alpha of "
           "the earlier factors: for t = 1 that is the first line, and the first parts together are the last. Back: the two conditions for z, for k = n "
           "those of the first line, give xi(M_n ... M_1)z = 0; and so do all the conditions together, for y.")

Xs = sym("Xi")
SUMS_FROM_END = standing("the recursions, counted from the end",
                         forall(k, 0, n - 1, (O[k + 1] == O[k] + T(alpha[k]) * Xs[k + 1] * alpha[k]) & (alpha[k + 1] == As[k + 1] * alpha[k])))
#: the two summands of the last sum, and of the one before it
LAST_TWO, ONE_BEFORE = ([O[s], T(alpha[s]) * Xs[s + 1] * alpha[s]] for s in (n - t, n - t - 1))
NEXT_TERM = T(alpha[t]) * Xs[t + 1] * alpha[t]
AT_END = given("x is a null vector of the sum", O[n] * x == Zero(d, 1))
FROM_Y = T(inv(alpha[k - 1])) * (Identity(d) - y * T(y) / (T(y) * y)[1, 1]) * inv(alpha[k - 1]) * (r + k)
claim("B93-S27", "one symmetric matrix for all the conditions",
      forall(t, 0, n, psd(O[t])) & forall(t, 1, n, Xs[n - t + 1] * alpha[n - t] * x == Zero(d, 1)) & (O[n] * y == Zero(d, 1)), sizes=["d", "n"],
      over={As: sequence_of(nonsingular(d), 1, n), Xs: sequence_of(positive_semidefinite(d), 1, n), x: vector(d), y: vector(d)},
      where=[ALPHA, rec(O, t, ZERO, O[t] + NEXT_TERM)],
      given=[SUMS_FROM_END, AT_END, given("y satisfies all the conditions", forall(k, 1, n, Xs[k] * alpha[k - 1] * y == Zero(d, 1)))],
      by=[induction(before=[first(forall(t, 0, n, O[t] * y == Zero(d, 1)))], also=[[], [O[n - t] * x == Zero(d, 1)], []],
                    base=[order(), order(LAST_TWO, LAST_TWO), order()], step=[order([O[t], NEXT_TERM]), order(ONE_BEFORE, ONE_BEFORE)]),
          example(d=1, n=1, A=[[[1]]], Xi=[[[1]]], x=[1], y=[0]), example(d=1, n=1, A=[[[1]]], Xi=[[[1]]], x=[0], y=[1]),
          instances(12, d=(1, 2, 3), n=(1, 2, 3), using={r: nonneg()}, made_by={x: r * y, Xs: (k, FROM_Y)}),
          instances(4, d=(2, 3), n=(1,), made_by={x: _null_at(O[n]), y: x})],
      note="Xi_k is xi(M_k) and alpha_k the product alpha(M_k) ... alpha(M_1); O_n is the matrix in braces. Any x that it takes to zero satisfies all the "
           "conditions, here for k = n - t + 1, and it takes to zero any y that satisfies them.")
