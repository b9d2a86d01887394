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
from exactkf.evidence import example, induction, instances, order
from exactkf.language import (
    Identity,
    T,
    Zero,
    forall,
    given,
    inv,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_semidefinite,
    rec,
    symbols,
    vector,
    when,
)
from proofs.d71.notation import H, N, Phi, i, j, k, n

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

PARTS = [let(T1, matrix_of(i, j, n, q, TT[i, j])), let(T2, matrix_of(i, j, n, n - q, TT[i, j + q])),
         let(S1, matrix_of(i, j, n, q, inv(TT)[j, i])), let(S2, matrix_of(i, j, n, n - q, inv(TT)[j + q, i]))]

claim("D71-E9.8", "two direct sums that are biorthogonal",
      (T(S1)*T2 == Zero(q, n - q)) & (T(S2)*T1 == Zero(n - q, q)) & (T1*T(S1) + T2*T(S2) == I) & (S1*T(T1) + S2*T(T2) == I),
      sizes=["n", "q"], over={TT: nonsingular(n)}, where=PARTS, by=[instances(n=(2, 3), q=(1, 2))],
      note="Two blocks, of sizes q and n - q: every vector is a sum of one in the range of T_1 and one in that of T_2, and the same for S_1 and S_2.")

SUM = [rec(Up, k, I, T(Phi)*Up[k]), rec(Rd, k, Zero(n, n), Rd[k] + T(Up[k])*H*Up[k])]
MODE = {Phi: matrix(n, n), H: positive_semidefinite(n)}
CORNERED = {"using": {E: nonsingular(n), X: matrix(n, n), D: matrix(n, n)},
            "made_by": {Phi: E*matrix_of(i, j, n, n, when(i == 1, when(j == 1, X[1, 1], 0), X[i, j]))*inv(E),
                        H: E*matrix_of(i, j, n, n, when((i == 1) | (j == 1), 0, (D*T(D))[i, j]))*T(E), v: inv(T(E))*matrix_of(i, j, n, 1, when(i == 1, 1, 0))}}

claim("D71-E9.18", "null vectors of R_d",
      forall(k, 0, N, Rd[k]*v == Zn),
      sizes=["n", "N"], over={**MODE, v: vector(n), mu: matrix(1, 1)}, where=SUM,
      given=[given("an eigenvector of Phi'", T(Phi)*v == v*mu), given("a null vector of H", H*v == Zn)],
      by=[induction(also=[H*(Up[k]*v) == Zn, T(Phi)*(Up[k]*v) == Up[k]*v*mu]),
          example(n=1, N=1, Phi=[[1]], H=[[1]], v=[1], mu=[[1]]), example(n=2, N=2, Phi=[[1, 0], [1, 1]], H=[[0, 0], [0, 1]], v=[1, 0], mu=[[1]]),
          example(n=2, N=2, Phi=[[1, 1], [0, 1]], H=[[0, 0], [0, 1]], v=[1, 0], mu=[[1]]),
          instances(6, n=(2, 3), N=(1, 2), using=CORNERED["using"], made_by={**CORNERED["made_by"], mu: matrix_of(i, j, 1, 1, X[1, 1])})],
      note="The first half: R_d v = 0 for an eigenvector v that H annihilates. The other half, with H(Phi')^j v = 0 for a null vector v of R_d, is part of "
           "D71-E3.60.")
