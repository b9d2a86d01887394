# SPDX-License-Identifier: MIT
"""Appendix A: blocks of a symmetric (1)-inverse of the 2-block matrix.

Let Z = [R, H; H', 0] with R >= 0 and H of full column rank, and let G with
blocks W, U, U', T be symmetric with ZGZ = Z. Written out in blocks this is

    RWR + RUH' + HU'R + HTH' = R,   RWH + HU'H = H,   H'WH = 0.

Multiply the second equation by H'W on the left: the third one removes every
term but H'WRWH, so H'W R WH = 0, and R >= 0 turns this into RWH = 0. The
second equation is now H U'H = H, so U'H = I. Let Q = HU', a projector onto
the range of H, and M = I - Q. The first equation between M and M' says that W
acts on the range of MR like an inverse of MRM'; as R >= 0, the range of MRQ'
lies in that of MRM', and between Q and M' the first equation leaves
QRM' = 0. Hence RU + HT = 0: together with U'H = I this is Z[U; T] = [0; I],
which fixes T for every choice of G, while U and W may vary along the vectors
that R and H' both annihilate.

The matrix RUH' = -HTH' = HPH' (P the error covariance) equals R - RWR. The
paper writes R + RWR, a misprint that (A.8), (A.9) and (A.10) inherit, and
that (A.14) does not feel because U'RWR = 0.
"""

from __future__ import annotations

from exactkf.claims import claim, repair
from exactkf.evidence import combination, example, identity, instances, order, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    eq,
    iff,
    inv,
    invertible,
    let,
    matrix,
    rank,
    sym,
    symmetric_matrix,
    vstack,
)
from proofs.nwl92.notation import (
    BLOCKS,
    G2,
    GRAM,
    IMPLIED_GRAM,
    ONE_INVERSE,
    OTHER,
    PAIR,
    SECOND,
    SECOND_GIVEN,
    SECOND_INVERSE,
    SETTING,
    SIZES,
    T2,
    U2,
    UNBIASED,
    W2,
    Y2,
    H,
    L,
    R,
    Tb,
    U,
    W,
    X,
    Zd,
    Ze,
    Zm,
    any_rank_identities,
    chained,
    every_size,
    excess,
    excess_term,
    inverses,
    lower,
    made_inverse,
    n,
    p,
    two_inverses,
    upper,
    x,
)

D = sym("D")
PRINTED_D = let(D, R + R * W * R)
RIGHT_D = let(D, R - R * W * R)
SIGN = "(A.7) prints D = R + RWR; the matrix D of (A.8) to (A.10) is R - RWR"
#: p = 2, n = 1, R = [2, 1; 1, 2], H = [1; 0]: Z is invertible, P = 3/2, RWR = [1/2, 1; 1, 2]
SMALL = {"p": 2, "n": 1, R: [[2, 1], [1, 2]], H: [[1], [0]], W: [[0, 0], [0, "1/2"]], U: [[1], ["-1/2"]],
         Tb: [["-3/2"]]}
HH = T(H) * H

claim("NWL92-EA.1", "full column rank means that H'H is invertible",
      iff(rank(H) == n, invertible(HH)), sizes=["p", "n"], over={H: matrix(p, n)},
      by=[order([HH]), instances(p=(1, 2, 3), n=(1, 2, 3))])

claim("NWL92-EA.2", "in blocks, ZGZ = Z is the three equations (A.3), (A.4), (A.5)",
      Zm * Zd * Zm - Zm == block([
          [R * W * R + R * U * T(H) + H * T(U) * R + H * Tb * T(H) - R, R * W * H + H * T(U) * H - H],
          [T(R * W * H + H * T(U) * H - H), T(H) * W * H]]),
      sizes=["p", "n"], over={R: symmetric_matrix(p), H: matrix(p, n), **BLOCKS}, where=PAIR,
      by=[identity(p=(1, 2, 3), n=(1, 2, 3)), instances(**SIZES)],
      note="The blocks (1,1), (1,2), (2,2) of ZGZ - Z are the left minus right sides of (A.3), (A.4), (A.5).")

SYMMETRIC = {**SETTING, R: symmetric_matrix(p)}
#: an R that is not nonnegative: RWH = [1/2; 0] and HU'H = [1/2; 0]
INDEFINITE = {"p": 2, "n": 1, R: [[0, 1], [1, 0]], H: [[1], [0]], W: [[0, "1/2"], ["1/2", 0]], U: [["1/2"], [0]],
              Tb: [[0]]}
claim("NWL92-EA.3", "block (1,1) of ZGZ = Z",
      R * W * R + R * U * T(H) + H * T(U) * R + H * Tb * T(H) == R,
      sizes=["p", "n"], over=SYMMETRIC, where=PAIR, given=[ONE_INVERSE],
      by=[combination([(T(upper(p, n)), "(2.20)", upper(p, n))], p=(1, 2, 3), n=(1, 2)), inverses()],
      note="Neither the rank of H nor R >= 0 is needed.")

claim("NWL92-EA.4", "block (1,2) of ZGZ = Z",
      R * W * H + H * T(U) * H == H,
      sizes=["p", "n"], over=SYMMETRIC, where=PAIR, given=[ONE_INVERSE],
      by=[combination([(T(upper(p, n)), "(2.20)", lower(p, n))], p=(1, 2, 3), n=(1, 2)), example(INDEFINITE), inverses()],
      note="Neither the rank of H nor R >= 0 is needed.")

claim("NWL92-EA.5", "block (2,2) of ZGZ = Z",
      T(H) * W * H == Zero(n, n),
      sizes=["p", "n"], over=SYMMETRIC, where=PAIR, given=[ONE_INVERSE],
      by=[combination([(T(lower(p, n)), "(2.20)", lower(p, n))], p=(1, 2, 3), n=(1, 2)), inverses()],
      note="Neither the rank of H nor R >= 0 is needed.")

claim("NWL92-EA.6", "RWH = 0",
      R * W * H == Zero(p, n),
      sizes=["p", "n"], over=SETTING, where=PAIR, given=[ONE_INVERSE, IMPLIED_GRAM],
      by=[every_size(), inverses()],
      note="R >= 0 is needed, the rank of H is not.")

SMALL_TWICE = {**SMALL, W2: SMALL[W], U2: SMALL[U], T2: SMALL[Tb]}
claim("NWL92-EA.7", "D = R + RWR does not depend on the (1)-inverse and is the D of (A.8), (A.9)",
      (D == R + R * W2 * R) & (H * Tb * T(H) == -D) & (R * U * T(H) == D),
      sizes=["p", "n"], over={**SETTING, **SECOND}, where=[*PAIR, SECOND_INVERSE, PRINTED_D],
      given=[ONE_INVERSE, SECOND_GIVEN, GRAM],
      by=[example(SMALL_TWICE), two_inverses()],
      repair=repair("sign", SIGN + ", and only that one equals RUH' = -HTH'",
                    (D == R - R * W2 * R) & (H * Tb * T(H) == -D) & (R * U * T(H) == D),
                    sizes=["p", "n"], over={**SETTING, **SECOND}, where=[*PAIR, SECOND_INVERSE, RIGHT_D],
                    given=[ONE_INVERSE, SECOND_GIVEN, IMPLIED_GRAM], by=[every_size(second=True), two_inverses()]),
      note="RWR is the same for all (1)-inverses, so that R + RWR is unique too; it is not the matrix of (A.8), (A.9).")

claim("NWL92-EA.8", "HTH' = -D with the D of (A.7)",
      H * Tb * T(H) == -D,
      sizes=["p", "n"], over=SETTING, where=[*PAIR, PRINTED_D], given=[ONE_INVERSE, GRAM],
      by=[example(SMALL), inverses()],
      repair=repair("sign", SIGN, H * Tb * T(H) == -D, sizes=["p", "n"], over=SETTING, where=[*PAIR, RIGHT_D],
                    given=[ONE_INVERSE, IMPLIED_GRAM], by=[every_size(), inverses()]),
      note="Right as it stands once the sign in (A.7) is put right; the rank of H is not needed.")

claim("NWL92-EA.9", "RUH' = D with the D of (A.7)",
      R * U * T(H) == D,
      sizes=["p", "n"], over=SETTING, where=[*PAIR, PRINTED_D], given=[ONE_INVERSE, GRAM],
      by=[example(SMALL), inverses()],
      repair=repair("sign", SIGN, R * U * T(H) == D, sizes=["p", "n"], over=SETTING, where=[*PAIR, RIGHT_D],
                    given=[ONE_INVERSE, IMPLIED_GRAM], by=[every_size(), inverses()]),
      note="Right as it stands once the sign in (A.7) is put right; the rank of H is not needed.")

claim("NWL92-EA.10", "T through the D of (A.7), hence unique",
      Tb == -inv(HH) * T(H) * D * H * inv(HH),
      sizes=["p", "n"], over=SETTING, where=[*PAIR, PRINTED_D], given=[ONE_INVERSE, GRAM],
      by=[example(SMALL), inverses()],
      repair=repair("sign", SIGN, eq(Tb, -inv(HH) * T(H) * D * H * inv(HH), T2), sizes=["p", "n"],
                    over={**SETTING, **SECOND}, where=[*PAIR, SECOND_INVERSE, RIGHT_D],
                    given=[ONE_INVERSE, SECOND_GIVEN], by=[every_size(second=True), two_inverses()]),
      note="T is unique in any case; the formula needs the D of (A.8), which is R - RWR.")

claim("NWL92-EA.11", "U' is a left inverse of H",
      eq(T(U) * H, inv(HH) * HH, Identity(n)),
      sizes=["p", "n"], over=SETTING, where=PAIR, given=[ONE_INVERSE], by=[every_size(), inverses()],
      note="Full column rank enters as the denominator det H'H.")

claim("NWL92-EA.12", "the mean of the estimate is x",
      T(lower(p, n)) * Zd * vstack(H, Zero(n, n)) * x == x,
      sizes=["p", "n"], over={**SETTING, x: matrix(n, 1)}, where=PAIR, given=[ONE_INVERSE, GRAM],
      by=[every_size(), inverses()],
      note="The mean of y is Hx, and the estimate is linear in y.")

claim("NWL92-EA.13", "error covariance of the ML estimate as a block of G diag(R, 0) G",
      (T(lower(p, n)) * Zd * block([[R, Zero(p, n)], [Zero(n, p), Zero(n, n)]]) * Zd * lower(p, n) == T(U) * R * U) & excess(L, U, R),
      sizes=["p", "n"], over={**SETTING, L: matrix(n, p)}, where=PAIR,
      given=[ONE_INVERSE, IMPLIED_GRAM, UNBIASED],
      by=[every_size([], [excess_term(L, U, R)]),
          inverses(made_by=OTHER, using={X: matrix(n, p)})],
      note=("The error of the estimate U'y is U'v, of covariance U'RU. It is the maximum likelihood estimate: by the "
            "second statement no other unbiased Ly has a smaller error covariance LRL'."))

claim("NWL92-EA.14", "P = U'DH(H'H)^-1 = -U'HTH'H(H'H)^-1 = -T",
      eq(T(U) * R * U, T(U) * D * H * inv(HH), -T(U) * H * Tb * HH * inv(HH), -Tb),
      sizes=["p", "n"], over=SETTING, where=[*PAIR, PRINTED_D], given=[ONE_INVERSE], by=[every_size(), inverses()],
      note="Holds with D = R + RWR as printed in (A.7) and with the right D = R - RWR, because U'RWR = 0.")

claim("NWL92-EA.15", "RU + HT = 0",
      R * U + H * Tb == Zero(p, n),
      sizes=["p", "n"], over=SETTING, where=PAIR, given=[ONE_INVERSE, GRAM],
      by=[every_size(), inverses()])

U_TWICE, FREE_TWICE = made_inverse(Zm, (W2, U2, T2), p, n, Y2, G2)
LEFT_INVERSE = [let(Ze, block([[W, T(L)], [L, Tb]]))]
WHICH = (Zm * Ze * Zm == Zm, R * T(L) * T(H) == D)
LEFT_INVERSES = {**SETTING, L: matrix(n, p)}



#: the (1)-inverse with U, and then with L' in the place of U
WITH_U, WITH_L = (any_rank_identities(R, H, W, u, Tb, n, p) for u in (U, T(L)))
claim("NWL92-SA1", "a left inverse of H that is a block of a symmetric (1)-inverse satisfies (A.9)",
      WHICH[0] >> WHICH[1],
      sizes=["p", "n"], over=LEFT_INVERSES, where=[*PAIR, *LEFT_INVERSE, PRINTED_D],
      given=[ONE_INVERSE, UNBIASED],
      by=[example({**SMALL, L: [[1, "-1/2"]]}), inverses(made_by={**U_TWICE, L: T(U2)}, using=FREE_TWICE)],
      repair=repair("sign", SIGN + "; with that D a left inverse of H is such a block exactly if it satisfies (A.9)",
                    iff(*WHICH), sizes=["p", "n"], over=LEFT_INVERSES, where=[*PAIR, *LEFT_INVERSE, RIGHT_D],
                    given=[ONE_INVERSE, UNBIASED],
                    by=[chained((WITH_U[0], WITH_U[1]), inside=[within(len(WITH_U[0]), *WITH_L[0])], sums=(*WITH_L[1], [], [])),
                        inverses(made_by=OTHER, using={X: matrix(n, p)}),
                        inverses(made_by={**U_TWICE, L: T(U2)}, using=FREE_TWICE)]),
      note=("The footnote itself is right once the sign in (A.7) is put right: among the left inverses L of H only "
            "those with RL'H' = D occur, and all of them do. (A.9) with the printed D excludes even the block U'."))
