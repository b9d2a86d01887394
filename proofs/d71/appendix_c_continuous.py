# SPDX-License-Identifier: MIT
"""Driven modes in continuous time, and bases of what is undriven and unobservable (Appendix C).

The range of R_c, the covariance of what the noise adds to the state, is that of the sum of the
A^k H (A')^k for k < n: a vector is a null vector of either exactly if H(A')^k annihilates it for
every k. The null space is invariant under A', so that it is the sum of its parts in the spaces
sigma_i; a mode is driven if its part is zero.
"""

from exactkf.claims import claim
from exactkf.evidence import example, induction, instances, part, restated
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    given,
    hstack,
    iff,
    inv,
    kernel_basis,
    let,
    matrix,
    nonsingular,
    positive_semidefinite,
    rank,
    rec,
    scalar,
    standing,
    symbols,
    vector,
)
from proofs.d71.notation import H, M, Phi, k, n, p
from proofs.d71.section_2_b import DIAGONAL, UNSTABLE, A, E, lam, unit

Pw, Rd, Rc, mu, v, nd, mode, seen, DRIVEN, Wd, Nd, N0, Ld, L0, UNDRIVEN, UNSEEN, m = symbols("Pw Rd Rc mu v nd mode seen DRIVEN Wd Nd N0 Ld L0 UNDRIVEN "
                                                                                             "UNSEEN m")
I = Identity(n)
SUM = [rec(Pw, k, I, A*Pw[k]), rec(Rd, k, Zero(n, n), Rd[k] + Pw[k]*H*T(Pw[k])), let(Rc, Rd[n])]
DIFFERENT = {"sizes": ["n", "m"], "over": {E: nonsingular(n), lam: vector(n), H: positive_semidefinite(n)}}
MODES = [let(A, E*DIAGONAL*inv(E)), *SUM, let(mode, E*unit(m)), let(seen, inv(T(E))*unit(m)), let(DRIVEN, rank(hstack(Rc, mode)) == rank(Rc))]
NUMBER = standing("m is the number of a mode", (m >= 1) & (m <= n))
CASES = [example(n=2, m=1, E=[[1, 1], [0, 1]], lam=[1, 2], H=[[1, 0], [0, 0]]), example(n=2, m=2, E=[[1, 1], [0, 1]], lam=[1, 2], H=[[1, 0], [0, 0]]),
         example(n=2, m=1, E=[[1, 0], [0, 1]], lam=[1, 1], H=[[1, 1], [1, 1]]), example(n=2, m=2, E=[[1, 0], [1, 1]], lam=[3, 2], H=[[1, 1], [1, 1]]),
         example(n=2, m=1, E=[[1, 0], [1, 1]], lam=[3, 2], H=[[0, 0], [0, 1]]), example(n=1, m=1, E=[[1]], lam=[2], H=[[0]]),
         instances(8, n=(1, 2, 3), m=(1, 2))]
REAL = ("For n different real eigenvalues: A = E diag(lambda)E^{-1}, the mode m is the m-th column of E, and sigma_m is spanned by the m-th column of the "
        "inverse of E'. R_c is replaced by the sum of the A^k H A'^k for k < n, which has the same range. ")

claim("D71-T9.1", "driven modes in continuous time",
      iff(DRIVEN, H*seen != Zero(n, 1)), **DIFFERENT, where=MODES, given=[NUMBER, *UNSTABLE], by=[part("different real eigenvalues"), *CASES],
      note=REAL + "DRIVEN says that the mode lies in the range.")

claim("D71-S78", "driven modes and null vectors of R_c",
      iff(DRIVEN, Rc*seen != Zero(n, 1)), **DIFFERENT, where=MODES, given=[NUMBER, *UNSTABLE], by=[part("different real eigenvalues"), *CASES],
      note=REAL + "The null space of R_c is invariant under A', which is why it is inside the sum of the other sigma_j if it meets sigma_i in 0 only; for "
                  "another nonnegative matrix that would not follow.")

claim("D71-E9.11", "an eigenvector that is a null vector of H",
      always(k, Rd[k]*nd == Zero(n, 1)), sizes=["n"], over={A: matrix(n, n), H: positive_semidefinite(n), nd: vector(n), mu: scalar()}, where=SUM,
      given=[given("A'n = mu n", T(A)*nd == mu*nd), given("Hn = 0", H*nd == Zero(n, 1))],
      by=[restated("The integral of e^{At}He^{A't} has the null space of the sum of the A^jHA'^j, j < n."),
          induction(also=[H*T(Pw[k])*nd == Zero(n, 1)]), example(n=1, A=[[2]], H=[[1]], nd=[1], mu=2),
          example(n=2, A=[[1, 0], [1, 2]], H=[[1, 0], [0, 0]], nd=[0, 1], mu=2),
          instances(4, n=(1, 2), made_by={A: mu*I, H: Zero(n, n)})],
      note="For the sums of A^j H (A')^j instead of the integral: each term annihilates n, as each value of the integrand does. The H before n, which the "
           "second line of (9.11) lacks in the scan, is read into it, as (9.18) has it.")

claim("D71-S79", "null vectors of R_c",
      (H*T(Pw[n])*v == Zero(n, 1)) & (Rc*(T(A)*v) == Zero(n, 1)), sizes=["n"], over={A: matrix(n, n), H: positive_semidefinite(n), v: vector(n)}, where=SUM,
      given=[given("R_c v = 0", Rc*v == Zero(n, 1))],
      by=[example(n=2, A=[[1, 0], [1, 2]], H=[[1, 0], [0, 0]], v=[0, 1]), example(n=2, A=[[1, 1], [0, 2]], H=[[1, 0], [0, 0]], v=[0, 1]),
          example(n=1, A=[[2]], H=[[0]], v=[1]),
          example(n=2, A=[[0, 1], [0, 0]], H=[[0, 0], [0, 1]], v=[1, 0]),
          example(n=3, A=[[1, 0, 0], [0, 1, 1], [0, 0, 1]], H=[[1, 0, 0], [0, 0, 0], [0, 0, 0]], v=[0, 1, 2]),
          instances(4, n=(1, 2, 3), made_by={H: Zero(n, n)})],
      note="By Cayley and Hamilton H(A')^n v = 0 too, so that the null space is invariant under A'; the vectors (A')^jv then span an invariant space of "
           "null vectors of H, in which there is an eigenvector.")

FREE = {"sizes": ["n", "p"], "over": {Phi: matrix(n, n), H: positive_semidefinite(n), M: matrix(p, n)}}
BASES = [rec(Pw, k, I, Phi*Pw[k]), rec(Rd, k, Zero(n, n), Rd[k] + Pw[k]*H*T(Pw[k])), rec(Wd, k, Zero(n, n), Wd[k] + T(Pw[k])*T(M)*M*Pw[k]),
         let(Nd, kernel_basis(Rd[n])), let(N0, kernel_basis(Wd[n])),
         let(UNDRIVEN, H*Nd == 0*Nd), let(UNSEEN, M*N0 == 0*(M*N0)), let(Ld, inv(T(Nd)*Nd)*T(Nd)*T(Phi)*Nd), let(L0, inv(T(N0)*N0)*T(N0)*Phi*N0)]
claim("D71-T9.5", "bases of what is undriven and of what is unobservable",
      UNDRIVEN & (T(Phi)*Nd == Nd*Ld) & UNSEEN & (Phi*N0 == N0*L0), **FREE, where=BASES,
      by=[example(n=2, p=1, Phi=[[1, 0], [1, 2]], H=[[0, 0], [0, 0]], M=[[0, 0]]), example(n=2, p=1, Phi=[[1, 1], [0, 2]], H=[[1, 0], [0, 0]], M=[[0, 1]]),
          example(n=3, p=1, Phi=[[1, 2, 0], [0, 3, 0], [1, 1, 2]], H=[[0, 0, 0], [0, 0, 0], [0, 0, 1]], M=[[0, 1, 0]]),
          example(n=3, p=1, Phi=[[1, 2, 3], [0, 3, 1], [0, 1, 2]], H=[[1, 0, 0], [0, 0, 0], [0, 0, 0]], M=[[0, 1, 1]]), instances(6, n=(1, 2, 3), p=(1,))],
      note="N_d and N_0 are bases of the null spaces; Ld and L0 are Lambda_d* and Lambda_0, up to a change of the basis that gives them their Jordan form. "
           "N - N = 0 is written as N + N_0 = N_0.")
