# SPDX-License-Identifier: MIT
"""Appendix B: the difference of two solutions of the algebraic Riccati equation.

Let P1, P2 >= 0 solve the Riccati equation, Om_i their 3-block matrices, e the
last block column of the identity. For any symmetric (1)-inverses the last
columns of Om_i^+ satisfy Om_i Om_i^+ e = e, and, transposed,
e'Om_i^+ Om_i = e'. So

    P1 - P2 = e'(Om_2^+ - Om_1^+)e = e'Om_2^+ (Om_1 - Om_2) Om_1^+ e,

and Om_1 - Om_2 has A(P1 - P2)A' in its first block alone. The first block of
Om_1^+ e is L1', the first block of e'Om_2^+ is L2; hence

    P1 - P2 = (L2 A)(P1 - P2)(L1 A)'.

The paper writes e'Om_1 Om_1^+ = e' for the second identity, which fails if
Om_1 is singular, transposes the factor L1' once more, and has L1 A' for
(L1 A)' in the last line.
"""

from __future__ import annotations

from exactkf.claims import claim, repair
from exactkf.evidence import example, instances
from exactkf.language import Identity, T, Zero, block, eq, given, matrix, sym, symbols, symmetric_matrix, vstack
from proofs.nwl92.notation_system import (
    BOTTOM,
    IMPLIED_RANK,
    INVERSE,
    LAST,
    NOISE,
    OMEGA,
    OMEGA_INVERSE,
    ONE_INVERSE,
    OTHER_INVERSE,
    RANK,
    STEP,
    SYSTEM,
    TWO_DRAWN,
    TWO_FOILS,
    TWO_GAINS,
    TWO_IDENTITIES,
    TWO_INVERSES,
    TWO_LETS,
    TWO_OVER,
    U1,
    U2,
    A,
    C,
    E,
    Ka,
    Kb,
    La,
    Lb,
    Oi,
    Oia,
    Oib,
    Om,
    Oma,
    Omb,
    P,
    Pa,
    Pb,
    Q,
    R,
    S,
    Tb,
    drawn,
    filter_identities,
    l,
    n,
    p,
    riccati,
    three_block,
    two_solutions,
)

ONE = [OMEGA, OMEGA_INVERSE]
ONE_GIVEN = [ONE_INVERSE, NOISE, RANK]
SOLVED = [given("P1 solves (4.31)", riccati(Pa, La, Ka)), given("P2 solves (4.31)", riccati(Pb, Lb, Kb))]
TWO_GIVEN = [*TWO_INVERSES, *SOLVED, NOISE, IMPLIED_RANK]
TWO = [*TWO_LETS, *TWO_GAINS]
BOTH = filter_identities(of=TWO_IDENTITIES)
DIFFERENCE = Pa - Pb
FIRST = vstack(Identity(l), Zero(p, l), Zero(n, l))
#: n = l = p = 1, E = A = C = Q = R = 1, S = P = 0; not admissible if a block of the inverse is changed
SMALL = {"l": 1, "p": 1, "n": 1, A: [[1]], P: [[0]], Q: [[1]], S: [[0]], R: [[1]], E: [[1]], C: [[0]], sym("W1"): [[0]], sym("W2"): [[0]],
         sym("W3"): [[1]], U1: [[1]], U2: [[0]], Tb: [[-1]]}
NO_INVERSE = example({**SMALL, U1: [[2]]})

claim("NWL92-EB.1", "the 3-block matrices of two solutions",
      (Oma * BOTTOM == vstack(E, C, Zero(n, n))) & (Oma - Omb == three_block(Pa - Pb) - three_block(0 * Pa)),
      sizes=["l", "n", "p"], over={**SYSTEM, Pa: symmetric_matrix(n), Pb: symmetric_matrix(n)}, where=[TWO_LETS[0], TWO_LETS[2]],
      by=[instances(l=(1, 2), n=(1, 2), p=(1, 2))],
      note="A definition; what is checked is that the matrix depends on P by the block APA' alone and has (E; C; 0) as last column.")

claim("NWL92-EB.2", "difference of two solutions through the (1)-inverses",
      DIFFERENCE == LAST * (Oib - Oia) * BOTTOM, sizes=["l", "n", "p"], over=TWO_OVER, where=TWO, given=TWO_GIVEN,
      by=[BOTH, *TWO_FOILS, *TWO_DRAWN])

claim("NWL92-EB.3", "the last columns of the identity lie in the range of the 3-block matrix",
      Om * vstack(U1, U2, Tb) == BOTTOM, sizes=["l", "n", "p"], over=STEP, where=ONE, given=ONE_GIVEN,
      by=[filter_identities(), NO_INVERSE, drawn()],
      note="Delta is the last block column of the (1)-inverse.")

D1, D2, D3 = symbols("D1 D2 D3")
claim("NWL92-EB.4", "(B.3) times the 3-block matrix and its (1)-inverse",
      Om * Oi * BOTTOM == Om * Oi * Om * vstack(D1, D2, D3), sizes=["l", "n", "p"],
      over={**STEP, D1: matrix(l, n), D2: matrix(p, n), D3: matrix(n, n)}, where=ONE,
      given=[given("(B.3)", BOTTOM == Om * vstack(D1, D2, D3))],
      by=[example({**SMALL, D1: [[0]], D2: [[0]], D3: [[0]]}), drawn(made_by={D1: U1, D2: U2, D3: Tb})],
      note="Delta is any solution of (B.3).")

claim("NWL92-EB.5", "the 3-block matrix times its (1)-inverse keeps the last columns of the identity",
      Om * Oi * BOTTOM == BOTTOM, sizes=["l", "n", "p"], over=STEP, where=ONE, given=ONE_GIVEN,
      by=[filter_identities(), NO_INVERSE, drawn()])

#: two equal measurements without noise beside an equation that is redundant too: the 3-block matrix is singular
SINGULAR = {"l": 1, "p": 1, "n": 1, A: [[0]], P: [[0]], Q: [[0]], S: [[0]], R: [[0]], E: [[1]], C: [[1]], sym("W1"): [[1]], sym("W2"): [[0]],
            sym("W3"): [[-1]], U1: [[1]], U2: [[0]], Tb: [[0]]}
claim("NWL92-EB.6", "the same from the left, as printed",
      LAST * Om * Oi == LAST, sizes=["l", "n", "p"], over=STEP, where=ONE, given=ONE_GIVEN,
      by=[example(SINGULAR), drawn()],
      repair=repair("order of factors", ("the transpose of (B.5) has the (1)-inverse first; in the printed order it fails for a singular "
                                         "3-block matrix"),
                    LAST * Oi * Om == LAST, sizes=["l", "n", "p"], over=STEP, where=ONE, given=ONE_GIVEN,
                    by=[filter_identities(), NO_INVERSE, drawn()]),
      note="It stands as printed if the 3-block matrix is invertible. (B.7) needs the other order.")

claim("NWL92-EB.7", "difference of two solutions through the difference of the 3-block matrices",
      DIFFERENCE == LAST * Oib * (Oma - Omb) * Oia * BOTTOM, sizes=["l", "n", "p"], over=TWO_OVER, where=TWO, given=TWO_GIVEN,
      by=[BOTH, *TWO_FOILS, *TWO_DRAWN])

CHANGE = A * DIFFERENCE * T(A)
claim("NWL92-EB.8", "difference of the 3-block matrices",
      eq(Oma - Omb, block([[CHANGE, Zero(l, p), Zero(l, n)], [Zero(p, l), Zero(p, p), Zero(p, n)], [Zero(n, l), Zero(n, p), Zero(n, n)]]),
         FIRST * CHANGE * T(FIRST)),
      sizes=["l", "n", "p"], over={**SYSTEM, Pa: symmetric_matrix(n), Pb: symmetric_matrix(n)}, where=[TWO_LETS[0], TWO_LETS[2]],
      by=[instances(l=(1, 2), n=(1, 2), p=(1, 2))])

#: l = n = p = 2, C = E and A = diag(2, 1)E: the states 2x and x, each measured, in other coordinates
NOT_NORMAL = {"l": 2, "p": 2, "n": 2, E: [[1, -1], [0, 1]], C: [[1, -1], [0, 1]], A: [[2, -2], [0, 1]], Q: [[0, 0], [0, 0]], S: [[0, 0], [0, 0]],
              R: [[1, 0], [0, 1]], Pa: [["3/4", 0], [0, 0]], Pb: [[0, 0], [0, 0]],
              **dict(zip(INVERSE, ([["1/4", 0], [0, 1]], [["-1/4", 0], [0, -1]], [["1/4", 0], [0, 1]], [["1/4", 0], [1, 1]], [["3/4", 0], [0, 0]],
                                   [["-3/4", 0], [0, 0]]), strict=True)),
              **dict(zip(OTHER_INVERSE, ([[1, 0], [0, 1]], [[-1, 0], [0, -1]], [[1, 0], [0, 1]], [[1, 0], [1, 1]], [[0, 0], [0, 0]],
                                         [[0, 0], [0, 0]]), strict=True))}
TWICE = "the second bracket is transposed once too often: (I 0 0) times the (1)-inverse times the last columns is L' already"
claim("NWL92-EB.9.1", "difference of two solutions through blocks of the (1)-inverses",
      DIFFERENCE == LAST * Oib * FIRST * CHANGE * T(T(FIRST) * Oia * BOTTOM),
      sizes=["l", "n", "p"], over=TWO_OVER, where=TWO, given=TWO_GIVEN, by=[example(NOT_NORMAL), two_solutions(l=2, n=2, p=2)],
      repair=repair("other", TWICE, DIFFERENCE == LAST * Oib * FIRST * CHANGE * (T(FIRST) * Oia * BOTTOM),
                    sizes=["l", "n", "p"], over=TWO_OVER, where=TWO, given=TWO_GIVEN, by=[BOTH, *TWO_FOILS, *TWO_DRAWN]))

claim("NWL92-EB.9", "difference of two solutions through the gains",
      DIFFERENCE == (Lb * A) * DIFFERENCE * (La * T(A)),
      sizes=["l", "n", "p"], over=TWO_OVER, where=TWO, given=TWO_GIVEN, by=[example(NOT_NORMAL), two_solutions(l=2, n=2, p=2)],
      repair=repair("other", "the transpose is that of the product L1 A, as in (4.45)",
                    DIFFERENCE == (Lb * A) * DIFFERENCE * T(La * A),
                    sizes=["l", "n", "p"], over=TWO_OVER, where=TWO, given=TWO_GIVEN, by=[BOTH, *TWO_FOILS, *TWO_DRAWN]),
      note="As scanned the T stands on A, inside the bracket, where the sizes do not even fit unless l = n; outside of it this is (4.45).")
