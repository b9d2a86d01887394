# SPDX-License-Identifier: MIT
"""Solution of the quadratic matrix equation A + BP + PC - PDP = 0 (Chapter III, section C.2).

Put R = [[B, A], [D, -C]]. Then [I, -P] R [P; I] = A + BP + PC - PDP, so P solves
the equation exactly if R maps the columns of [P; I] into their own span:
R[P; I] = [P; I](DP - C). In another basis of that span, T = [P; I]Gamma = [F; Gamma],
this reads RT = TJ with J = Gamma^{-1}(DP - C)Gamma and P = F Gamma^{-1}; Gamma may be
chosen so that J is a Jordan matrix. On the left, [I, -P] R = (B - PD)[I, -P] gives
SR = KS with S = Y[I, -P]. Together T and S split R: in the basis
E = [T, [Y^{-1}; 0]] it is block triangular with J and K on the diagonal.

So solutions come from invariant subspaces with nonsingular lower part. How many
there are depends on the Jordan form of R. If T = EX with E^{-1}RE = Omega in Jordan
form, then Omega X = XJ splits into blocks: between different eigenvalues X is zero,
between blocks of one eigenvalue it is upper triangular Toeplitz, pushed to the
upper right. Hence the blocks of J are no larger, one by one, than those of R. When
R has one block for each eigenvalue all T for one J span the same space; when it has
more, X may keep a free parameter, and a solution with nonsingular lower part comes
in a family.

Everything is stated over the reals. The Jordan matrices J and K are the classical
theorem's (over the complex numbers); the equations here hold for every Gamma and Y.
"""

from exactkf.claims import claim
from exactkf.evidence import combination, example, first, generic_index, identity, induction, instances, lemma, order, restated, steps, use
from exactkf.language import (
    Identity,
    Zero,
    block,
    bottom,
    det,
    eq,
    forall,
    function,
    given,
    hstack,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonsingular,
    prod,
    rank,
    rec,
    rows,
    scalar,
    sym,
    symbols,
    top,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import jordan_block, r_matrix, superdiagonal

n, m, q, s = symbols("n m q s")
i, j, k = symbols("i j k")
A, B, C, D, P, F, J, K, R, X, Y = symbols("A B C D P F J K R X Y")
Gam, Zm, TT, SS, E, Einv = symbols("Gam Zm TT SS E Einv")
x, mu, w, G = symbols("x mu w G")
In, Im = Identity(n), Identity(m)

NM = {"n": (1, 2), "m": (1, 2)}
MORE = {"n": (1, 2, 3), "m": (1, 2, 3)}
COEFFICIENTS = {A: matrix(n, m), B: matrix(n, n), C: matrix(m, m), D: matrix(m, n)}
QUADRATIC = A + B*P + P*C - P*D*P
SOLVES = given("(3.10)", QUADRATIC == Zero(n, m))
SOLVED = {A: P*D*P - B*P - P*C}
BLOCKS = let(R, r_matrix(A, B, C, D))

RIGHT = [let(F, P*Gam), let(TT, vstack(F, Gam)), let(J, inv(Gam)*(D*P - C)*Gam)]
LEFT = [let(Zm, -Y*P), let(SS, hstack(Y, Zm)), let(K, Y*(B - P*D)*inv(Y))]
SOLUTION = {**COEFFICIENTS, P: matrix(n, m)}
JORDAN = restated("Jordan's theorem: every square matrix is similar to a Jordan matrix over the complex numbers")

claim("D71-E3.10", "the quadratic equation in block form",
      hstack(In, -P)*R*vstack(P, Im) == QUADRATIC,
      sizes=["n", "m"], over=SOLUTION, where=[BLOCKS],
      by=[identity(**NM), instances(**MORE)],
      note="The equation is a definition; the content checked is that it says what the block matrix R does to [P; I].")

claim("D71-T3.5.a", "a solution gives an invariant subspace",
      (P == F*inv(Gam)) & (R*TT == TT*J),
      sizes=["n", "m"], over={**SOLUTION, Gam: nonsingular(m)}, where=[BLOCKS, *RIGHT], given=[SOLVES],
      by=[combination([[], [(vstack(In, Zero(m, n)), "(3.10)", Gam)]], **NM), JORDAN, instances(**MORE, made_by=SOLVED)],
      note="J = Gamma^{-1}(DP - C)Gamma for any nonsingular Gamma; by Jordan's theorem some Gamma makes it a Jordan "
           "matrix.")

claim("D71-T3.5.b", "a solution gives a left invariant subspace",
      (P == -inv(Y)*Zm) & (SS*R == K*SS),
      sizes=["n", "m"], over={**SOLUTION, Y: nonsingular(n)}, where=[BLOCKS, *LEFT], given=[SOLVES],
      by=[combination([[], [(Y, "(3.10)", hstack(Zero(m, n), Im))]], **NM), JORDAN, instances(**MORE, made_by=SOLVED)],
      note="K = Y(B - PD)Y^{-1} for any nonsingular Y; by Jordan's theorem some Y makes it a Jordan matrix.")

PAIR = {P: matrix(n, m), F: matrix(n, m), Gam: nonsingular(m), Y: nonsingular(n), Zm: matrix(n, m)}
PAIRED = [given("(3.11)", P == F*inv(Gam)), given("(3.15)", P == -inv(Y)*Zm)]
MAKE_PAIR = {F: P*Gam, Zm: -Y*P}

claim("D71-T3.5.c", "left and right subspaces annihilate each other",
      Y*F + Zm*Gam == Zero(n, m),
      sizes=["n", "m"], over=PAIR, given=PAIRED,
      by=[combination([(-Y, "(3.11)", Gam), (Y, "(3.15)", Gam)], **NM), instances(**MORE, made_by=MAKE_PAIR)])

BASIS = [let(E, block([[F, inv(Y)], [Gam, Zero(m, n)]])), let(Einv, block([[Zero(m, n), inv(Gam)], [Y, Zm]]))]

lam = sym("lam")
#: the identity of order n + m, cut as R is and as E^{-1}RE is
WHOLE, WHOLE_TURNED = block([[In, Zero(n, m)], [Zero(m, n), Im]]), block([[Im, Zero(m, n)], [Zero(n, m), In]])
#: lambda I - R = U diag(lambda I - (B - PD), lambda I - (DP - C)) U^{-1}, up to the corner -D, with U = [[I, P], [0, I]]
SPLIT = [(lam*WHOLE - R, [block([[In, P], [Zero(m, n), Im]]), block([[lam*In - (B - P*D), Zero(n, m)], [-D, lam*Im - (D*P - C)]]),
                          block([[In, -P], [Zero(m, n), Im]])]),
         (lam*Im - J, [inv(Gam), lam*Im - (D*P - C), Gam]), (lam*In - K, [Y, lam*In - (B - P*D), inv(Y)])]

claim("D71-T3.5.d", "J and K share out the eigenvalues of R",
      det(lam*WHOLE - R) == det(lam*Im - J)*det(lam*In - K),
      sizes=["n", "m"], over={**SOLUTION, Gam: nonsingular(m), Y: nonsingular(n), lam: scalar()}, where=[BLOCKS, *RIGHT, *LEFT], given=[SOLVES],
      by=[order(factors=SPLIT), instances(n=(1, 2), m=(1, 2), made_by=SOLVED)],
      note="For every number lambda, so that the characteristic polynomials are equal.")

J1, Y1 = symbols("J1 Y1")
FROM_RIGHT = {**COEFFICIENTS, F: matrix(n, m), Gam: nonsingular(m), J: matrix(m, m)}
RIGHT_GIVEN = given("RT = TJ", R*vstack(F, Gam) == vstack(F, Gam)*J)
MAKE_RIGHT = {C: (D*F - Gam*J)*inv(Gam), A: (F*J - B*F)*inv(Gam)}
Q = sym("Q")

claim("D71-T3.6", "an invariant subspace with nonsingular lower part gives a solution",
      (QUADRATIC == Zero(n, m)) & (A + B*Q + Q*C - Q*D*Q == Zero(n, m)),
      sizes=["n", "m"], over={**FROM_RIGHT, Y: nonsingular(n), Zm: matrix(n, m), K: matrix(n, n)},
      where=[BLOCKS, let(P, F*inv(Gam)), let(Q, -inv(Y)*Zm)],
      given=[RIGHT_GIVEN, given("SR = KS", hstack(Y, Zm)*R == K*hstack(Y, Zm))],
      by=[combination([[(hstack(In, -P), "RT = TJ", inv(Gam))], [(inv(Y), "SR = KS", vstack(Q, Im))]], **NM),
          instances(**MORE, made_by={**MAKE_RIGHT, Zm: -Y*F*inv(Gam), K: Y*(B - F*inv(Gam)*D)*inv(Y)}),
          instances(**MORE, made_by={B: inv(Y)*(K*Y - Zm*D), A: inv(Y)*(K*Zm + Zm*C), F: -inv(Y)*Zm*Gam,
                                     J: inv(Gam)*(D*F - C*Gam)})])

# --- steps of the proof ----------------------------------------------------------------------------------------------

claim("D71-E3.20", "J and F give P and DP - C back",
      (P == F*inv(Gam)) & (Gam*J*inv(Gam) == D*P - C),
      sizes=["n", "m"], over={C: matrix(m, m), D: matrix(m, n), P: matrix(n, m), Gam: nonsingular(m)}, where=RIGHT,
      by=[identity(**NM), instances(**MORE)],
      note="J and F are definitions; the content checked is that they determine P and the similarity class of DP - C.")

claim("D71-E3.22", "upper half of RT = TJ",
      (A*Gam + B*P*Gam == P*Gam*inv(Gam)*(D*P - C)*Gam) & (A*Gam + B*F == F*J),
      sizes=["n", "m"], over={**SOLUTION, Gam: nonsingular(m)}, where=RIGHT, given=[SOLVES],
      by=[combination([[(1, "(3.10)", Gam)], [(1, "(3.10)", Gam)]], **NM), instances(**MORE, made_by=SOLVED)])

claim("D71-E3.24", "lower half of RT = TJ", D*F - C*Gam == Gam*J,
      sizes=["n", "m"], over={C: matrix(m, m), D: matrix(m, n), P: matrix(n, m), Gam: nonsingular(m)}, where=RIGHT,
      by=[identity(**NM), instances(**MORE)])

claim("D71-E3.25", "K and Z give P and B - PD back",
      (P == -inv(Y)*Zm) & (inv(Y)*K*Y == B - P*D),
      sizes=["n", "m"], over={B: matrix(n, n), D: matrix(m, n), P: matrix(n, m), Y: nonsingular(n)}, where=LEFT,
      by=[identity(**NM), instances(**MORE)],
      note="K and Z are definitions; the content checked is that they determine P and the similarity class of B - PD.")

claim("D71-E3.27", "left half of SR = KS", Y*B + Zm*D == K*Y,
      sizes=["n", "m"], over={B: matrix(n, n), D: matrix(m, n), P: matrix(n, m), Y: nonsingular(n)}, where=LEFT,
      by=[identity(**NM), instances(**MORE)])

claim("D71-E3.28", "right half of SR = KS",
      (Y*A + Y*P*C == -Y*(B - P*D)*inv(Y)*Y*P) & (Y*A - Zm*C == K*Zm),
      sizes=["n", "m"], over={**SOLUTION, Y: nonsingular(n)}, where=LEFT, given=[SOLVES],
      by=[combination([[(Y, "(3.10)", 1)], [(Y, "(3.10)", 1)]], **NM), instances(**MORE, made_by=SOLVED)])

claim("D71-E3.30", "why YF + Z Gamma vanishes",
      eq(Y*F + Zm*Gam, Y*(F*inv(Gam) + inv(Y)*Zm)*Gam, Y*(P - P)*Gam, Zero(n, m)),
      sizes=["n", "m"], over=PAIR, given=PAIRED,
      by=[combination([[], [(-Y, "(3.11)", Gam), (Y, "(3.15)", Gam)], []], **NM), instances(**MORE, made_by=MAKE_PAIR)])

claim("D71-E3.32", "inverse of the new basis",
      (Einv*E == Identity(n + m)) & (E*Einv == Identity(n + m)),
      sizes=["n", "m"], over={F: matrix(n, m), Gam: nonsingular(m), Y: nonsingular(n), Zm: matrix(n, m)}, where=BASIS,
      given=[given("(3.18)", Y*F + Zm*Gam == Zero(n, m))],
      by=[instances(**MORE, made_by={Zm: -Y*F*inv(Gam)})])

claim("D71-E3.33", "R in the new basis",
      Einv*R*E == block([[J, inv(Gam)*D*inv(Y)], [Zero(n, m), K]]),
      sizes=["n", "m"], over={**SOLUTION, Gam: nonsingular(m), Y: nonsingular(n)},
      where=[BLOCKS, *RIGHT, *LEFT, *BASIS],
      given=[SOLVES],
      by=[combination([(vstack(Zero(m, n), Y), "(3.10)", hstack(Gam, Zero(m, n)))], **NM),
          instances(**MORE, made_by=SOLVED)])

claim("D71-E3.34", "characteristic polynomials",
      eq(det(lam*WHOLE - R), det(lam*WHOLE_TURNED - Einv*R*E), det(lam*Im - J)*det(lam*In - K)),
      sizes=["n", "m"], over={**SOLUTION, Gam: nonsingular(m), Y: nonsingular(n), lam: scalar()}, where=[BLOCKS, *RIGHT, *LEFT, *BASIS], given=[SOLVES],
      by=[order(factors=[*SPLIT, (lam*WHOLE_TURNED - Einv*R*E, [block([[lam*Im - J, -inv(Gam)*D*inv(Y)], [Zero(n, m), lam*In - K]])])]),
          instances(n=(1, 2), m=(1, 2), made_by=SOLVED)],
      note="For every number lambda. That E^{-1} is the inverse of E is D71-E3.32.")

claim("D71-E3.35", "from RT = TJ to the quadratic equation",
      (B*P + A == F*J*inv(Gam)) & (P*D*P - P*C == F*J*inv(Gam)) & ((B*P + A) - (P*D*P - P*C) == QUADRATIC)
      & (QUADRATIC == Zero(n, m)),
      sizes=["n", "m"], over=FROM_RIGHT, where=[BLOCKS, let(P, F*inv(Gam))], given=[RIGHT_GIVEN],
      by=[combination([[(hstack(In, Zero(n, m)), "RT = TJ", inv(Gam))], [(hstack(Zero(n, n), P), "RT = TJ", inv(Gam))],
                       [],
                       [(hstack(In, -P), "RT = TJ", inv(Gam))]], **NM),
          instances(**MORE, made_by=MAKE_RIGHT)])

# --- Jordan structure ------------------------------------------------------------------------------------------------

U, W1 = symbols("U W1")


Rt, Jt, r = symbols("Rt Jt r")
Iq = Identity(q)
FIRST = matrix_of(i, j, q, m, E[i, j])
NILPOTENT = superdiagonal(m)
#: w times the columns of T is W_q T, and w times their coordinates is W_m: for a complex w and matrices of twice the size these are not w I
Wq, Wm = symbols("Wq Wm")
A_NUMBER = given("w is a number", Wq*TT == TT*Wm)
#: w is an eigenvalue of a Jordan block J, in another basis, and of R with more; the eigenvector ends a chain of length r + 1
CHAINED = {"using": {E: nonsingular(q), G: nonsingular(m), U: matrix(q, q), w: scalar()},
           "made_by": {Wq: w*Iq, Wm: w*Im, J: G*(w*Im + NILPOTENT)*inv(G), TT: FIRST*inv(G),
                       R: E*matrix_of(i, j, q, q, when(j <= m, when(i == j, w, when((j == i + 1) & (i <= m), 1, 0)), when(i <= j, U[i, j], 0)))*inv(E),
                       Y: G*matrix_of(i, j, m, s, when(i == r + j, 1, 0)), X: G*matrix_of(i, j, m, s, when(i == j, 1, 0))}}

claim("D71-T3.7", "the blocks of J fit into those of R",
      (TT*X == Rt[r]*(TT*Y)) & ((R - Wq)*(TT*X) == Zero(q, s)) & (rank(TT*X) == s),
      sizes=["q", "m", "s", "r"],
      over={Wq: matrix(q, q), Wm: matrix(m, m), TT: matrix(q, m), J: matrix(m, m), R: matrix(q, q), X: matrix(m, s), Y: matrix(m, s)},
      where=[rec(Rt, k, Iq, (R - Wq)*Rt[k]), rec(Jt, k, Im, (J - Wm)*Jt[k])],
      given=[given("RT = TJ", R*TT == TT*J), A_NUMBER, given("T has independent columns", rank(TT) == m), given("JX = wX", J*X == Wm*X),
             given("X has independent columns", rank(X) == s), given("X = (J - w)^r Y", X == Jt[r]*Y)],
      by=[induction(before=[first(forall(k, 0, r, Rt[k]*TT == TT*Jt[k]))]),
          restated("A has as many Jordan blocks of size r + 1 or more at w as there are independent eigenvectors at w in the range of (A - w)^r"),
          *(example({"q": 1, "m": 1, "s": 1, "r": 0, "Wq": [[1]], "Wm": [[1]], "TT": [[1]], "J": [[1]], "R": [[1]], "X": [[1]], "Y": [[1]], **change})
            for change in ({"R": [[2]]}, {"TT": [[0]], "R": [[2]]}, {"J": [[2]], "R": [[2]]}, {"X": [[0]], "Y": [[0]]}, {"r": 1}, {"Wq": [[2]]})),
          example(q=2, m=2, s=2, r=0, Wq=[[1, 2], [-2, 1]], Wm=[[1, 2], [-2, 1]], TT=[[3, 1], [-1, 3]], J=[[1, 2], [-2, 1]], R=[[1, 2], [-2, 1]],
                  X=[[1, 0], [0, 1]], Y=[[1, 0], [0, 1]]),
          instances(q=(2, 3), m=(1, 2), s=(1,), r=(0, 1), **CHAINED), instances(4, q=(3,), m=(3,), s=(1,), r=(2,), **CHAINED)],
      note="The blocks of size r + 1 or more at w are as many as there are independent eigenvectors in the range of (J - w)^r, which is how elementary "
           "divisors are counted. Any s of them, the columns of X, go under T to s such vectors of R. So R has at least as many blocks of size r + 1 or "
           "more as J, for every r: the j-th largest block of J is no larger than that of R. T = [F; Gamma] has independent columns, as Gamma is "
           "nonsingular. W_q and W_m multiply by w; they are w times the identity, or, where complex matrices are real ones of twice the size, a matrix of "
           "blocks [[a, b], [-b, a]].")

leading = matrix_of(i, j, m, m, U[i, j])
UPPER = matrix_of(i, j, q, q, when(i <= j, U[i, j], 0))
UPPER_LEADING = matrix_of(i, j, m, m, when(i <= j, U[i, j], 0))

claim("D71-S29", "an eigenvalue of J that R does not have",
      ((R - Wq)*TT*x == Zero(q, 1)) & (invertible(R - Wq) >> (TT*x == Zero(q, 1))),
      sizes=["q", "m"], over={R: matrix(q, q), TT: matrix(q, m), J: matrix(m, m), Wq: matrix(q, q), Wm: matrix(m, m), x: vector(m)},
      given=[given("RT = TJ", R*TT == TT*J), given("mu is a number", Wq*TT == TT*Wm), given("Jx = mu x", J*x == Wm*x)],
      by=[order([], [inv(R - Wq)]),
          example(q=1, m=1, R=[[2]], TT=[[1]], J=[[2]], Wq=[[1]], Wm=[[2]], x=[1]),
          example(q=2, m=2, R=[[1, 2], [-2, 1]], TT=[[3, 1], [-1, 3]], J=[[1, 2], [-2, 1]], Wq=[[1, 2], [-2, 1]], Wm=[[1, 2], [-2, 1]], x=[1, 1]),
          instances(q=(2, 4), m=(2, 4), using={E: nonsingular(q), U: matrix(q, q), G: nonsingular(m), W1: matrix(1, m),
                                               s: scalar(), mu: scalar()},
                    made_by={Wq: mu*Iq, Wm: mu*Im, R: E*UPPER*inv(E),
                             TT: matrix_of(i, j, q, m, when(j == 1, 0, E[i, j - 1]))*inv(G),
                             J: G*matrix_of(i, j, m, m,
                                            when(j == 1, when(i == 1, mu, 0),
                                                 when(i == 1, W1[1, j], when(i <= j, U[i - 1, j - 1], 0))))
                             * inv(G),
                             x: s*G*matrix_of(i, j, m, 1, when(i == 1, 1, 0))}),
          instances(q=(2, 4), m=(2, 4), using={E: nonsingular(q), U: matrix(q, q), G: nonsingular(m), s: scalar()},
                    made_by={Wq: U[1, 1]*Iq, Wm: U[1, 1]*Im, R: E*UPPER*inv(E), TT: FIRST*inv(G), J: G*UPPER_LEADING*inv(G),
                             x: s*G*matrix_of(i, j, m, 1, when(i == 1, 1, 0))})],
      note="If mu is no eigenvalue of R the matrix R - mu I is invertible and Tx = 0, which independent columns of T "
           "forbid; so every eigenvalue of J is one of R. W_q and W_m multiply by mu, as in D71-T3.7.")

claim("D71-S30", "no more blocks of J than of R at one eigenvalue",
      ((R - Wq)*TT*X == Zero(q, s)) & (rank(TT*X) == s),
      sizes=["q", "m", "s"],
      over={R: matrix(q, q), TT: matrix(q, m), J: matrix(m, m), Wq: matrix(q, q), Wm: matrix(m, m), X: matrix(m, s)},
      given=[given("RT = TJ", R*TT == TT*J), A_NUMBER, given("T has independent columns", rank(TT) == m),
             given("JX = wX", J*X == Wm*X), given("X has independent columns", rank(X) == s)],
      by=[order(),
          example(q=2, m=2, s=1, R=[[1, 0], [0, 3]], TT=[[0, 0], [0, 0]], J=[[1, 0], [0, 2]], X=[1, 0], Wq=[[1, 0], [0, 1]], Wm=[[1, 0], [0, 1]]),
          example(q=1, m=1, s=1, R=[[1]], TT=[[1]], J=[[1]], X=[1], Wq=[[2]], Wm=[[1]]),
          instances(q=(2, 3), m=(2, 3), s=(1, 2),
                    using={E: nonsingular(q), U: matrix(q, q), G: nonsingular(m), Y: nonsingular(s), w: scalar()},
                    made_by={Wq: w*Iq, Wm: w*Im, R: E*matrix_of(i, j, q, q,
                                            when(j <= s, when(i == j, w, 0), when(i <= j, U[i, j], 0)))*inv(E),
                             TT: FIRST*inv(G),
                             J: G*matrix_of(i, j, m, m,
                                            when(j <= s, when(i == j, w, 0), when(i <= j, U[i, j], 0)))*inv(G),
                             X: G*matrix_of(i, j, m, s, when(i == j, 1, 0))*Y})],
      note="The columns of X are independent eigenvectors of J, one for each of its blocks at w or of any s of them; TX has as many of R, so that R has at "
           "least s blocks at w. W_q and W_m multiply by w, as in D71-T3.7.")

r, pp, c, w1, w2, first_row, last_column = symbols("r pp c w1 w2 first_row last_column")


def toeplitz(entries, height, width):
    """Upper triangular Toeplitz, pushed to the upper right."""
    return matrix_of(i, j, height, width, when((j >= i) & (i + width - j <= height), entries[j - i + 1], 0))


u, row, col = symbols("u row column")
#: entry by entry: the first row by steps down, the last column by steps to the left, zeros by steps from the corner below


def _down(rows, label):
    """X is constant along diagonals, and zero below the first."""
    return lemma(s, forall(u, s, rows, forall(j, 1, pp, X[s, j] == when(j >= s, X[1, j - s + 1], 0))), start=1,
                 uses=[use(0, s=s, u=u, j=j - 1), use(label, row=s, column=j)])


_LEFT = lemma(s, forall(u, s, pp - 1, forall(i, 1, r, X[i, pp - s] == last_column(i + s))),
              uses=[use(1, s=s, u=u, i=i + 1), use("one eigenvalue", row=i, column=pp - s)])
_CORNER = lemma(s, forall(j, 1, pp, when((r + j - 1 - s >= 1) & (j - 1 <= s), Y[r + j - 1 - s, j], 0) == 0),
                uses=[use("two eigenvalues", row=r + j - 2 - s, column=j, times=1/(w1 - w2)), use(2, s=s, j=j - 1), use(2, s=s, j=j)],
                base=[use("two eigenvalues", row=r, column=1, times=1/(w1 - w2))])
claim("D71-E3.37", "solutions of Omega X = XJ between two Jordan blocks",
      (X == matrix_of(i, j, r, pp, first_row(j - i + 1))) & (X == matrix_of(i, j, r, pp, last_column(i + pp - j)))
      & (Y == Zero(r, pp)),
      sizes=["r", "pp"], over={w: scalar(), w1: scalar(), w2: scalar(), X: matrix(r, pp), Y: matrix(r, pp)},
      where=[function(first_row, [k], when(k >= 1, X[1, k], 0)), function(last_column, [k], when(k <= r, X[k, pp], 0))],
      given=[given("one eigenvalue", jordan_block(w, r)*X == X*jordan_block(w, pp)),
             given("two eigenvalues", jordan_block(w1, r)*Y == Y*jordan_block(w2, pp)),
             given("which differ", w1 != w2)],
      by=[generic_index(_down(r, "one eigenvalue"), _LEFT, _CORNER, uses=[use(0, s=row, u=r, j=col), use(1, s=pp - col, u=pp - 1, i=row), use(2, s=r - row + col - 1, j=col)]),
          restated("for complex eigenvalues: the determinant of Y -> Omega Y - YJ is a power of w1 - w2, over the complex numbers as over the real ones"),
          instances(r=(1, 2, 3), pp=(1, 2, 3), using={c: vector(pp)}, made_by={X: toeplitz(c, r, pp), Y: Zero(r, pp)})],
      note="X between blocks of one eigenvalue, Y between blocks of two. The first equation says upper triangular "
           "Toeplitz (zero rows below "
           "when r >= p), the second that it is pushed to the right (zero columns on the left when r <= p).")

d, c2 = symbols("d c2")

claim("D71-E3.40", "when X must have dependent columns",
      (matrix_of(i, j, r, 1, toeplitz(c, r, r + 1 + d)[i, 1]) == Zero(r, 1))
      & (matrix_of(i, j, pp + d - 1, 1, toeplitz(c2, pp + d, pp)[i + 1, 1]) == Zero(pp + d - 1, 1)),
      sizes=["r", "pp", "d"], over={c: vector(r + 1 + d), c2: vector(pp)},
      by=[generic_index(), restated("j vectors of j - 1 entries are dependent"), instances(r=(1, 2, 3), pp=(1, 2), d=(0, 1, 2))],
      note="The first column of a block of X is zero if the block has fewer rows than columns, and else has no entry but the first. As p_1 >= ... >= p_j > "
           "r_j >= r_{j+1} >= ..., the first columns of the first j column sets are zero in the block rows j, j+1, ..., and in the j - 1 others only their "
           "first entries remain.")

# --- how many solutions ----------------------------------------------------------------------------------------------

F1, F2, G1, G2, J2, T1, T2 = symbols("F1 F2 G1 G2 J2 T1 T2")
TWO = {**COEFFICIENTS, F1: matrix(n, m), F2: matrix(n, m), G1: nonsingular(m), G2: nonsingular(m), J1: matrix(m, m),
       J2: matrix(m, m)}
TWO_GIVEN = [given("RT1 = T1 J1", R*T1 == T1*J1), given("RT2 = T2 J2", R*T2 == T2*J2)]
TWO_LET = [BLOCKS, let(T1, vstack(F1, G1)), let(T2, vstack(F2, G2))]
W, dd = symbols("W dd")
MAKE_FIRST = {C: (D*F1 - G1*J1)*inv(G1), A: (F1*J1 - B*F1)*inv(G1), F2: F1*W, G2: G1*W, J2: inv(W)*J1*W}
MAKE_SECOND = {C: (D*F2 - G2*J2)*inv(G2), A: (F2*J2 - B*F2)*inv(G2), F1: F2*inv(W), G1: G2*inv(W), J1: W*J2*inv(W)}


def spectral(matrix_, height, width, down, right):
    """A block of E diag(d) E^{-1}, or of E."""
    return matrix_of(i, j, height, width, matrix_[i + down, j + right])


def diagonal_from(start):
    """m of the numbers d on a diagonal."""
    return matrix_of(i, j, m, m, when(i == j, dd[i + start], 0))


WHOLE = E*matrix_of(i, j, n + m, n + m, when(i == j, dd[i], 0))*inv(E)
#: two solutions that differ, from different eigenvectors
MAKE_DIFFERENT = {
    B: spectral(WHOLE, n, n, 0, 0), A: spectral(WHOLE, n, m, 0, n), D: spectral(WHOLE, m, n, n, 0),
    C: -spectral(WHOLE, m, m, n, n),
    F1: spectral(E, n, m, 0, 0), G1: spectral(E, m, m, n, 0), F2: spectral(E, n, m, 0, 1), G2: spectral(E, m, m, n, 1),
    J1: diagonal_from(0), J2: diagonal_from(1),
}

claim("D71-T3.8.a", "column equivalent T give one P",
      (J1 == X*J2*inv(X)) & (F1*inv(G1) == F2*inv(G2)),
      sizes=["n", "m"], over={**TWO, X: nonsingular(m)}, where=TWO_LET,
      given=[*TWO_GIVEN, given("column equivalent", T2 == T1*X)],
      by=[instances(**MORE, using={W: nonsingular(m)}, made_by={**MAKE_FIRST, X: W}),
          instances(**MORE, using={W: nonsingular(m)}, made_by={**MAKE_SECOND, X: W})],
      note="The lower parts are nonsingular, as F Gamma^{-1} presupposes; without that T1 = T2 = 0 would go with any "
           "J1 and J2.")

claim("D71-T3.8.b", "matrices J that are not similar give different P",
      (T2 == T1*X) & (J1 == X*J2*inv(X)),
      sizes=["n", "m"], over=TWO, where=[*TWO_LET, let(X, inv(G1)*G2)],
      given=[*TWO_GIVEN, given("P1 = P2", F1*inv(G1) == F2*inv(G2))],
      by=[instances(**MORE, using={W: nonsingular(m)}, made_by=MAKE_FIRST),
          instances(**MORE, using={W: nonsingular(m)}, made_by=MAKE_SECOND),
          instances(**MORE, using={E: nonsingular(n + m), dd: vector(n + m)}, made_by=MAKE_DIFFERENT)],
      note="In contrapositive form: if P1 = P2 then T1 and T2 are column equivalent, by X = Gamma_1^{-1} Gamma_2, and "
           "J1 and J2 are similar. "
           "That column equivalence makes J1 and J2 similar is part (a).")

bv = sym("bv")

claim("D71-S31", "one Jordan block for each eigenvalue: T is unique",
      rank(hstack(T1, T2)) == m,
      sizes=["q", "m"], over={R: matrix(q, q), J: matrix(m, m), T1: matrix(q, m), T2: matrix(q, m), bv: vector(q)},
      given=[given("RT1 = T1 J", R*T1 == T1*J), given("RT2 = T2 J", R*T2 == T2*J),
             given("independent columns", (rank(T1) == m) & (rank(T2) == m)),
             given("R is nonderogatory", invertible(matrix_of(i, j, q, q, (R**(j - 1)*bv)[i])))],
      by=[example(q=2, m=1, R=[[1, 0], [0, 1]], J=[[1]], T1=[1, 0], T2=[0, 1], bv=[1, 1]),
          steps("D71-E3.37", "D71-E3.41", facts=["Jordan's theorem."],
                prose="With T = EX each block of X is U times a Toeplitz matrix, so T has the column space of E "
                      "diag(U)."),
          instances(q=(1, 2, 3, 4), m=(1, 2),
                    using={E: nonsingular(q), c: vector(q), w1: scalar(), w2: scalar(), mu: scalar(), w: scalar()},
                    made_by={R: E*(matrix_of(i, j, q, q, when(i == j, c[i], 0)) + superdiagonal(q))*inv(E),
                             J: matrix_of(i, j, m, m, when(i == j, c[i], 0)) + superdiagonal(m),
                             T1: FIRST*(w1*Im + w2*J), T2: FIRST*(mu*Im + w*J),
                             bv: E*matrix_of(i, j, q, 1, when(i == q, 1, 0))})],
      note="T1 and T2 have the same column space. A matrix is nonderogatory exactly if some vector b makes b, Rb, R^2 "
           "b, ... a basis.")

Ud = vstack(Identity(pp), Zero(d, pp))

claim("D71-E3.41", "the block of X for one eigenvalue of a nonderogatory R",
      (X == Ud*top(X, pp)) & (det(top(X, pp)) == prod(k, 1, pp, X[k, k])) & forall(k, 1, pp, X[k, k] == X[1, 1])
      & (jordan_block(w, pp + d)*Ud == Ud*jordan_block(w, pp)),
      sizes=["pp", "d"], over={w: scalar(), X: matrix(pp + d, pp)},
      given=[given("Omega X = XJ", jordan_block(w, pp + d)*X == X*jordan_block(w, pp))],
      by=[generic_index(_down(pp + d, "Omega X = XJ"), triangular=Identity(pp), uses=[use(0, s=row, u=pp + d, j=col), use(0, s=k, u=pp + d, j=k)]),
          instances(pp=(1, 2, 3), d=(0, 1, 2), using={c: vector(pp)}, made_by={X: toeplitz(c, pp + d, pp)})],
      note="X = U times its upper part, which is nonsingular exactly if the diagonal entry a is not zero; U itself is "
           "a solution. "
           "With several eigenvalues X is block diagonal and each block is treated so.")

Ua, Ub, Ga, Gb, Gm, al, be = symbols("Ua Ub Ga Gb Gm al be")
OMEGA = block([[jordan_block(w, 2), Zero(2, 1)], [Zero(1, 2), rows([[w]])]])


def canonical(alpha):
    """The matrix U with its parameter."""
    return rows([[1, 0], [0, 1], [0, alpha]])


FAMILY = [let(Ua, canonical(al)), let(Ub, canonical(be)), let(Ga, bottom(E*Ua, 2)), let(Gb, bottom(E*Ub, 2))]
MANY_SOLUTIONS = (
    (X == rows([[X[1, 1], X[1, 2]], [0, X[1, 1]], [0, X[3, 2]]]))
    & (X == canonical(X[3, 2]/X[1, 1])*rows([[X[1, 1], X[1, 2]], [0, X[1, 1]]]))
    & (OMEGA*Ua == Ua*jordan_block(w, 2)) & (rank(hstack(Ua, Ub)) == 3)
    & (invertible(Ga) | invertible(Gb)))
MANY = {w: scalar(), X: matrix(3, 2), E: nonsingular(3), al: scalar(), be: scalar()}
MAKE_X = {X: rows([[c[1], c[2]], [0, c[1]], [0, c[3]]])}
X_GIVEN = [given("Omega X = XJ", OMEGA*X == X*jordan_block(w, 2)), given("two values of the parameter", al != be)]
NO_SOLUTION = {"w": 0, "X": [[1, 0], [0, 1], [0, 0]], "E": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "al": 0, "be": 1}

claim("D71-E3.44", "a derogatory R with a family of solutions",
      MANY_SOLUTIONS, over={**MANY, mu: scalar()}, where=[*FAMILY, let(Gm, bottom(E*canonical(mu), 2))],
      given=[*X_GIVEN, given("one lower part is nonsingular", invertible(Gm))],
      by=[steps("D71-E3.37", "D71-T3.6", "D71-T3.8.b",
                prose="The determinant of the lower part is a polynomial of degree at most one in the parameter, "
                      "not zero by hypothesis; different spaces give different P."),
          example({**NO_SOLUTION, "mu": 0}), instances(using={c: vector(3)}, made_by=MAKE_X)],
      note="R has the blocks 2 and 1 at one eigenvalue and J the block 2; n = 1, m = 2, the smallest case. The solutions that are counted are those with a "
           "nonsingular lower part, and it is understood that J has one. Of any two values of the parameter at least one then gives a solution, so that "
           "infinitely many do; different values give different column spaces, hence different P. Without that proviso there may be none: for E = I the lower "
           "part is singular for every value, and with w = 0 the quadratic equation is A = 0 with A = [1, 0].")
