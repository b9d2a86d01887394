# SPDX-License-Identifier: MIT
"""Driven and observable modes (Appendix C).

From AT = T Lambda follow Lambda*T* = T*A' and, multiplied by the inverse of T* on both sides,
A'(T*)^{-1} = (T*)^{-1}Lambda*. The columns of the inverse of T* are biorthogonal to those of T:
S_i*T_j is the identity for i = j and zero otherwise. If A'n = mu n and Hn = 0 then every term
A^k H (A')^k takes n to mu^k A^k H n = 0. Conversely, if the sum of such terms with k < n
annihilates v then H(A')^k v = 0 for each, because they are nonnegative definite.

The matrices are real; the transpose stands for the conjugate transpose.
"""

from exactkf.claims import claim
from exactkf.evidence import example, induction, instances, order, part
from exactkf.language import (
    Identity,
    T,
    Zero,
    forall,
    given,
    hstack,
    iff,
    inv,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_semidefinite,
    rank,
    rec,
    scalar,
    sym,
    symbols,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import H, N, Phi, i, j, k, n, p

q, A, TT, Lam, S1, S2, T1, T2, v, mu, Up, Rd, E, c, X, D = symbols("q A TT Lam S1 S2 T1 T2 v mu Up Rd E c X D")
I, Zn = Identity(n), Zero(n, 1)
JORDAN = given("the Jordan decomposition", A*TT == TT*Lam)
ONE = {"n": 1, "A": [[2]], "TT": [[3]], "Lam": [[2]]}

for id_, title in (("D71-E9.6", "the decomposition of the transpose"), ("D71-E9.15", "the same in discrete time")):
    claim(id_, title,
          T(A)*T(inv(TT)) == T(inv(TT))*T(Lam),
          sizes=["n"], over={A: matrix(n, n), TT: nonsingular(n), Lam: matrix(n, n)}, given=[JORDAN],
          by=[order(lemmas=[inv(TT)*A == Lam*inv(TT)]), example({**ONE, "Lam": [[1]]}), instances(8, n=(1, 2, 3), made_by={A: TT*Lam*inv(TT)})],
          note="A stands for Phi in discrete time. The prime on A in the sentence before (9.6) is read into the scan.")

m = sym("m")
PARTS = [let(S1, T(hstack(Identity(q), Zero(q, m))*inv(hstack(T1, T2)))), let(S2, T(hstack(Zero(m, q), Identity(m))*inv(hstack(T1, T2))))]

claim("D71-E9.8", "two direct sums that are biorthogonal",
      (T(S1)*T2 == Zero(q, m)) & (T(S2)*T1 == Zero(m, q)) & (T1*T(S1) + T2*T(S2) == Identity(q + m)) & (S1*T(T1) + S2*T(T2) == Identity(q + m)),
      sizes=["q", "m"], over={T1: matrix(q + m, q), T2: matrix(q + m, m)}, where=PARTS, by=[order(), instances(q=(1, 2), m=(1, 2))],
      note="Two blocks, of sizes q and m: every vector is a sum of one in the range of T_1 and one in that of T_2, and the same for S_1 and S_2. Of several "
           "blocks T_1 is any one, and T_2 all others.")

SUM = [rec(Up, k, I, T(Phi)*Up[k]), rec(Rd, k, Zero(n, n), Rd[k] + T(Up[k])*H*Up[k])]
MODE = {Phi: matrix(n, n), H: positive_semidefinite(n)}
CORNERED = {"using": {E: nonsingular(n), X: matrix(n, n), D: matrix(n, n)},
            "made_by": {Phi: E*matrix_of(i, j, n, n, when(i == 1, when(j == 1, X[1, 1], 0), X[i, j]))*inv(E),
                        H: E*matrix_of(i, j, n, n, when((i == 1) | (j == 1), 0, (D*T(D))[i, j]))*T(E), v: inv(T(E))*matrix_of(i, j, n, 1, when(i == 1, 1, 0))}}

claim("D71-E9.18", "null vectors of R_d",
      forall(k, 0, N, Rd[k]*v == Zn),
      sizes=["n", "N"], over={**MODE, v: vector(n), mu: matrix(1, 1)}, where=SUM,
      given=[given("an eigenvector of Phi'", T(Phi)*v == v*mu), given("a null vector of H", H*v == Zn)],
      by=[part("the first half"), induction(also=[H*(Up[k]*v) == Zn, T(Phi)*(Up[k]*v) == Up[k]*v*mu]),
          example(n=1, N=1, Phi=[[1]], H=[[1]], v=[1], mu=[[1]]), example(n=2, N=2, Phi=[[1, 0], [1, 1]], H=[[0, 0], [0, 1]], v=[1, 0], mu=[[1]]),
          example(n=2, N=2, Phi=[[1, 1], [0, 1]], H=[[0, 0], [0, 1]], v=[1, 0], mu=[[1]]),
          instances(6, n=(2, 3), N=(1, 2), using=CORNERED["using"], made_by={**CORNERED["made_by"], mu: matrix_of(i, j, 1, 1, X[1, 1])})],
      note="The first half: R_d v = 0 for an eigenvector v that H annihilates. The other half, with H(Phi')^j v = 0 for a null vector v of R_d, is part of "
           "D71-E3.60.")

# --- the tests for a mode -------------------------------------------------------------------------------------------------

lam, Pd, Down, RANGE, Cm = symbols("lam Pd Down RANGE Cm")
#: Phi = T diag(lam I + N, D) T^{-1} with the mode of lam in the first q coordinates, and lam no eigenvalue of D
CHAIN = matrix_of(i, j, n, n, when((i <= q) & (j <= q), when(i == j, lam, when(j == i + 1, c[i], 0)), when(i == j, lam + i, 0)))
WITH_MODE = {TT: nonsingular(n), lam: scalar(), c: vector(n)}
MODE_OF = [let(Phi, TT*CHAIN*inv(TT)), let(T1, matrix_of(i, j, n, q, TT[i, j]))]
EYE = [[1, 0], [0, 1]]
#: c = 0: two eigenvectors; c != 0: a Jordan block
SHAPES = [{"n": 2, "q": 2, "TT": EYE, "lam": 3, "c": [chain, 0]} for chain in (0, 1)] + [{"n": 2, "q": 1, "TT": [[1, 1], [0, 1]], "lam": 1, "c": [0, 0]}]
NOISES = ([[0, 0], [0, 0]], [[1, 0], [0, 0]], [[0, 0], [0, 1]], [[1, 1], [1, 1]], [[1, -1], [-1, 1]])

claim("D71-T9.3", "when a mode is completely driven",
      iff(rank(hstack(RANGE, T1)) == rank(RANGE), rank(vstack(T(Phi) - lam*I, H)) == n),
      sizes=["n", "q"], over={**WITH_MODE, H: positive_semidefinite(n)}, where=[*MODE_OF, *SUM, let(RANGE, Rd[n])],
      by=[*(example({**shape, "H": noise}) for shape in SHAPES for noise in NOISES), instances(8, n=(2, 3), q=(1, 2)),
          instances(8, n=(2, 3), q=(1, 2), using={X: vector(n)}, made_by={H: X*T(X)})],
      note="Real lambda. The mode is in the range of R_d exactly if it adds nothing to its rank, and no eigenvector of Phi' at lambda is a null vector of H "
           "exactly if the two matrices together have rank n. c_i are the numbers next to the diagonal of Lambda_1.")

OBSERVED = [rec(Down, k, I, Phi*Down[k]), rec(Pd, k, Zero(n, n), Pd[k] + T(Down[k])*T(Cm)*Cm*Down[k]), let(RANGE, Pd[n])]
ROWS = ([[0, 0]], [[1, 0]], [[0, 1]], [[1, 1]], [[1, -1]])

for id_, title in (("D71-T9.4", "when a mode is completely observable"), ("D71-T9.2", "the same in continuous time")):
    claim(id_, title,
          iff(rank(RANGE*T1) == q, rank(vstack(Phi - lam*I, Cm)) == n),
          sizes=["n", "q", "p"], over={**WITH_MODE, Cm: matrix(p, n)}, where=[*MODE_OF, *OBSERVED],
          by=[*(example({**shape, "p": 1, "Cm": row}) for shape in SHAPES for row in ROWS), instances(8, n=(2, 3), q=(1, 2), p=(1, 2))],
          note="Real lambda; Cm is M, and Phi is A in continuous time. P_d and P_dP_d' have the same range, so that P_d' and the sum here have the same null "
               "vectors; the mode meets that null space in 0 only exactly if the sum takes its basis T_1 to independent vectors.")
