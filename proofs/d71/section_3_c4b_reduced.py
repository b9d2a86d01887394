# SPDX-License-Identifier: MIT
"""The reduced covariance equation (Chapter III, section C.4.b).

If Phi L = L Phi_l and H = LGL' then one step of the covariance equation takes LXL' to LX+L',
where X+ is one step of the same equation for Phi_l, ML, G and V. So a solution that starts in
the range of L stays there. For an equilibrium P = LL' with independent columns of L the
reduced equation has the equilibrium I.

If N spans null vectors of P >= 0 then N'PN = 0 is the sum of N'Phi(PS + I)^{-1}P Phi'N and
N'HN, so that P Phi'N = 0 and HN = 0.
"""

from exactkf.claims import claim
from exactkf.evidence import example, induction, instances, order, restated, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    given,
    inv,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_definite,
    positive_semidefinite,
    psd,
    rec,
    schur,
    symbols,
    vector,
    when,
)
from proofs.d71.notation import H, M, P, Phi, V, gain, gram, i, j, k, n, p, step, update

q, L, Phil, G, X, X0, Ll, N, E, c, B, Lam, P0 = symbols("q L Phil G X X0 Ll N E c B Lam P0")
I, Iq = Identity(n), Identity(q)


def reduced(x):
    """The covariance equation of the reduced process."""
    return Phil*(x - x*T(L)*T(M)*inv(M*L*x*T(L)*T(M) + V)*M*L*x)*T(Phil) + G


PROCESS = {Phi: matrix(n, n), L: matrix(n, q), Phil: matrix(q, q), G: positive_semidefinite(q), M: matrix(p, n), V: positive_definite(p)}
INVARIANT = given("(3.200)", Phi*L == L*Phil)
CARRY = {"using": {E: nonsingular(n), B: matrix(n, n)},
         "made_by": {L: matrix_of(i, j, n, q, E[i, j]), Phi: E*matrix_of(i, j, n, n, when((i > q) & (j <= q), 0, B[i, j]))*inv(E),
                     Phil: matrix_of(i, j, q, q, B[i, j])}}
OFF = example(n=1, p=1, q=1, Phi=[[2]], L=[[1]], Phil=[[1]], G=[[1]], M=[[1]], V=[[1]], X0=[[1]])

claim("D71-E3.206", "solutions in the range of L",
      always(k, P[k] == L*X[k]*T(L)),
      sizes=["n", "p", "q"], over={**PROCESS, X0: positive_semidefinite(q)},
      where=[let(H, L*G*T(L)), rec(P, k, L*X0*T(L), step(P[k])), rec(X, k, X0, reduced(X[k]))], given=[INVARIANT],
      by=[induction(), OFF, instances(6, n=(1, 2, 3), p=(1, 2), q=(1, 2), horizon=2, **CARRY)],
      note="P_0N_2 = 0 says that P_0 = LX_0L', as the columns of L span the orthogonal complement of those of N_2.")

claim("D71-E3.193", "the equilibrium of the reduced equation",
      reduced(Iq) == Iq,
      sizes=["n", "p", "q"], over={**PROCESS, Ll: matrix(q, n)},
      where=[let(H, L*G*T(L))], given=[INVARIANT, given("P_e = LL' is an equilibrium", step(L*T(L)) == L*T(L)), given("L has independent columns", Ll*L == Iq)],
      by=[restated("Modes of Phi on an invariant subspace are modes of Phi.", "All modes are driven exactly if R_g is nonsingular."),
          order(lemmas=[L*reduced(Iq)*T(L) == L*T(L)]),
          example(n=1, p=1, q=1, Phi=[[2]], L=[[1]], Phil=[[1]], G=[["1/2"]], M=[[1]], V=[[1]], Ll=[[1]]),
          example(n=1, p=1, q=1, Phi=[[2]], L=[[1]], Phil=[[2]], G=[[1]], M=[[1]], V=[[1]], Ll=[[1]]),
          example(n=1, p=1, q=1, Phi=[[2]], L=[[0]], Phil=[[2]], G=[[1]], M=[[1]], V=[[1]], Ll=[[1]]),
          instances(6, n=(1, 2), p=(1, 2), q=(1,), using={E: nonsingular(n), c: vector(n)},
                    made_by={Phi: E*matrix_of(i, j, n, n, when(i == j, 1/(1 + c[i]**2), 0))*inv(E), L: matrix_of(i, j, n, q, E[i, j]),
                             Phil: (1/(1 + c[1]**2))*Iq, Ll: matrix_of(i, j, q, n, inv(E)[i, j]),
                             G: Iq - (1/(1 + c[1]**2))**2*(Iq - T(L)*T(M)*inv(M*L*T(L)*T(M) + V)*M*L)})],
      note="X_e = I. That P_k = LX_kL' from P_0 = 0 is D71-E3.206 with X_0 = 0. That no unstable or random walk mode of the reduced process is unobservable "
           "and that all are driven is not stated here.")

GAIN = gain()
TERMS = [T(N)*Phi*(I - GAIN*M)*P*T(I - GAIN*M)*T(Phi)*N, T(N)*Phi*GAIN*V*T(GAIN)*T(Phi)*N, T(N)*H*N]
GONE = Zero(n, q)
SYSTEM = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p), P: positive_semidefinite(n)}
EQUILIBRIUM = given("P is an equilibrium", P == step())
WAY = [P == Phi*(I - GAIN*M)*P*T(I - GAIN*M)*T(Phi) + Phi*GAIN*V*T(GAIN)*T(Phi) + H, (TERMS[0] + TERMS[1] + TERMS[2])*Identity(q) == Zero(q, q),
       V*T(GAIN)*T(Phi)*N == Zero(p, q), T(GAIN)*T(Phi)*N == Zero(p, q), P*T(I - GAIN*M)*T(Phi)*N == GONE]
QUIET = {Phi: E*matrix_of(i, j, n, n, when(i == j, 1/(1 + c[i]**2), 0))*inv(E), M: matrix_of(i, j, p, n, when(i == j + 1, 1, 0))*inv(E),
         P: E*matrix_of(i, j, n, n, when((i == j) & (i > q), 1 + c[i]**2, 0))*T(E), N: inv(T(E))*matrix_of(i, j, n, q, when(i == j, 1, 0)),
         H: P - Phi*update()*T(Phi)}

claim("D71-E3.192", "null vectors of the equilibrium",
      (T(N)*Phi*inv(P*gram() + I)*P*T(Phi)*N + T(N)*H*N == Zero(q, q)) & (H*N == GONE) & (P*T(Phi)*N == GONE),
      sizes=["n", "p", "q"], over={**SYSTEM, N: matrix(n, q)}, given=[EQUILIBRIUM, given("null vectors of P", P*N == GONE)],
      by=[restated("A matrix that keeps the span of independent columns has a matrix in them, and so has a symmetric one whose range lies in it."),
          order([], [], TERMS, [inv(V)], TERMS, [], TERMS, [], lemmas=WAY),
          example(n=1, p=1, q=1, Phi=[["1/2"]], H=[["7/8"]], M=[[1]], V=[[1]], P=[[1]], N=[[1]]),
          example(n=1, p=1, q=1, Phi=[[2]], H=[[1]], M=[[1]], V=[[1]], P=[[0]], N=[[1]]),
          example(n=1, p=1, q=1, Phi=[[2]], H=[[0]], M=[[1]], V=[[1]], P=[[3]], N=[[1]]),
          instances(8, n=(2, 3), p=(1, 2), q=(1,), using={E: nonsingular(n), c: vector(n)}, made_by=QUIET)],
      note="So Phi' keeps the null space of P and Phi its orthogonal complement, the range, which contains that of H: Phi L = L Phi_l and H = LGL'.")

LOST = P*T(M)*inv(M*P*T(M) + V)*M*P

claim("D71-E3.194", "the covariance equation on undriven modes",
      (T(N)*P*N - T(Lam)*T(N)*P*N*Lam + T(Lam)*T(N)*LOST*N*Lam == Zero(q, q)) & (schur(Lam) >> (P*N == GONE)),
      sizes=["n", "p", "q"], over={**SYSTEM, N: matrix(n, q), Lam: matrix(q, q)},
      given=[EQUILIBRIUM, given("undriven", T(Phi)*N == N*Lam), given("null vectors of H", H*N == GONE)],
      by=[order([], [], [T(Lam)*T(N)*LOST*N*Lam], [T(N)*P*N, -(T(N)*P*N)], [T(N)*P*N], lemmas=[T(N)*P*N == T(N)*Phi*update()*T(Phi)*N + T(N)*H*N],
                inside=[within(2, psd(-(T(N)*P*N)), T(N)*P*N == Zero(q, q), stein=T(Lam), on=0)]),
          example(n=2, p=1, q=1, Phi=[["1/2", 0], [0, 1]], H=[[0, 0], [0, 0]], M=[[1, 1]], V=[[1]], P=[[0, 0], [0, 0]], N=[[1], [0]], Lam=[["1/2"]]),
          example(n=2, p=1, q=1, Phi=[["1/2", 0], [0, 2]], H=[[0, 0], [0, 0]], M=[[1, 1]], V=[[1]], P=[[0, 0], [0, 3]], N=[[1], [0]], Lam=[["1/2"]]),
          example(n=1, p=1, q=1, Phi=[["5/3"]], H=[[0]], M=[[1]], V=[[1]], P=[["16/9"]], N=[[2]], Lam=[["5/3"]]),
          example(n=1, p=1, q=1, Phi=[["5/3"]], H=[[0]], M=[[1]], V=[[1]], P=[[1]], N=[[2]], Lam=[["5/3"]]),
          example(n=1, p=1, q=1, Phi=[["5/3"]], H=[[0]], M=[[1]], V=[[1]], P=[["16/9"]], N=[[2]], Lam=[[1]]),
          example(n=1, p=1, q=1, Phi=[[1]], H=[["1/2"]], M=[[1]], V=[[1]], P=[[1]], N=[[1]], Lam=[[1]]),
          instances(8, n=(1, 2), p=(1, 2), q=(1,), using={E: nonsingular(n), c: vector(n)},
                    made_by={Phi: E*matrix_of(i, j, n, n, when(i == j, 1 + c[i]**2, 0))*inv(E), V: Identity(p),
                             M: matrix_of(i, j, p, n, when(i == j, 1, 0))*inv(E), P: E*matrix_of(i, j, n, n, when(i == j, (1 + c[i]**2)**2 - 1, 0))*T(E),
                             H: P - Phi*update()*T(Phi),
                             N: inv(T(E))*matrix_of(i, j, n, q, when(i == 1, 1, 0)), Lam: (1 + c[1]**2)*Iq})],
      note="Here Lambda_d is not starred, unlike in (3.60).")
