# SPDX-License-Identifier: MIT
"""When the stable equilibrium exists (Chapter III, section C.3.c).

Let R_p[F; Gamma] = [F; Gamma]J with the eigenvalues of J outside the unit circle. An
unobservable vector v, Phi v = lambda v and Mv = 0, gives v*Gamma(J - 1/lambda*) = 0, and so
v*Gamma = 0 if |lambda| > 1. Conversely let Gamma n = 0 and x = J^{-1}n. The lower half says
(SF + Gamma)x = Phi'Gamma n = 0, so that x*F*SFx + x*F*Gamma x = 0; both terms are nonnegative,
because F*Gamma is, and MFx = 0, Gamma x = 0 follow. The upper half then says Phi(Fx) = Fn. So
J^{-1} keeps the null space of Gamma, and F carries an eigenvector of J^{-1} in it to an
eigenvector of Phi that the measurement does not see.

Conventions as in section_3_c3c.
"""

from exactkf.claims import claim
from exactkf.evidence import example, instances, order, restated, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    given,
    inv,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_definite,
    positive_semidefinite,
    psd,
    schur,
    symbols,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import H, M, Phi, V, gram, i, j, n, p

q, r, F, Gam, J, S, Rp, E, K, N, Lam, x, c, v, s = symbols("q r F Gam J S Rp E K N Lam x c v s")
I = Identity(n)
PhiT = inv(T(Phi))
MODEL = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}
R_WHERE = [let(S, gram()), let(Rp, block([[H*PhiT*S + Phi, H*PhiT], [PhiT*S, PhiT]]))]
TT = vstack(F, Gam)
RT_TJ = given("R_p T = TJ", Rp*TT == TT*J)
COLUMNS = {**MODEL, F: matrix(n, q), Gam: matrix(n, q), J: nonsingular(q)}
WIDE = {"using": {E: nonsingular(q)},
        "made_by": {F: matrix_of(i, j, n, q, E[i, j]), Gam: matrix_of(i, j, n, q, E[i + n, j]),
                    J: inv(E)*block([[H*PhiT*gram() + Phi, H*PhiT], [PhiT*gram(), PhiT]])*E}}
ALL = [instances(6, n=(1,), p=(1, 2), q=(2,), **WIDE), instances(4, n=(2,), p=(1,), q=(4,), **WIDE)]

claim("D71-E3.119", "the lower half",
      (T(M)*inv(V)*M*F + Gam)*inv(J) == T(Phi)*Gam,
      sizes=["n", "p", "q"], over=COLUMNS, where=R_WHERE, given=[RT_TJ], by=[order(lemmas=[T(M)*inv(V)*M*F + Gam == T(Phi)*Gam*J]), *ALL])

#: one state that is measured, at the eigenvalue 2; and one that is not
ONE = {"n": 1, "p": 1, "q": 1, "Phi": [[1]], "H": [["1/2"]], "M": [[1]], "V": [[1]], "F": [[1]], "Gam": [[1]], "J": [[2]]}
HIDDEN = {"n": 1, "p": 1, "q": 1, "Phi": [[2]], "H": [[0]], "M": [[0]], "V": [[1]], "F": [[1]], "Gam": [[0]], "J": [[2]]}

claim("D71-E3.118", "an unobservable vector and Gamma",
      T(N)*Gam*J == inv(T(Lam))*T(N)*Gam,
      sizes=["n", "p", "q", "r"], over={**COLUMNS, N: matrix(n, r), Lam: nonsingular(r)}, where=R_WHERE,
      given=[RT_TJ, given("Phi v = lambda v", Phi*N == N*Lam), given("Mv = 0", M*N == Zero(p, r))],
      by=[order(lemmas=[T(M)*inv(V)*M*F + Gam == T(Phi)*Gam*J, T(N)*Gam == T(Lam)*T(N)*Gam*J]),
          example({**ONE, "r": 1, "N": [[1]], "Lam": [[1]]}), example({**ONE, "r": 1, "M": [[0]], "F": [["-1/3"]], "J": [[1]], "N": [[1]], "Lam": [[2]]}),
          example({**HIDDEN, "r": 1, "N": [[1]], "Lam": [[2]], "Gam": [[1]], "J": [[3]]}),
          example({**HIDDEN, "r": 1, "N": [[1]], "Lam": [[2]], "Gam": [[1]], "F": [[0]], "J": [["1/2"]]}),
          instances(6, n=(2,), p=(1,), q=(1,), r=(1,), using={c: vector(1)},
                    made_by={Phi: (1 + c[1]**2)*Identity(2), M: Zero(1, 2), H: Zero(2, 2), F: Zero(2, 1),
                             J: (1/(1 + c[1]**2))*Identity(1), Lam: (1 + c[1]**2)*Identity(1)})],
      note="v has r columns, and lambda stands on the right as a matrix: v*Gamma J = (lambda*)^{-1}v*Gamma.")

FORM = T(F)*Gam
NULL = given("Gamma n = 0", Gam*N == Zero(n, r))
X = inv(J)*N

claim("D71-E3.120", "the two forms on J^{-1}n",
      T(X)*T(F)*(T(M)*inv(V)*M)*F*X + T(X)*(T(F)*Gam)*X == Zero(r, r),
      sizes=["n", "p", "q", "r"], over={**COLUMNS, N: matrix(q, r)}, where=R_WHERE, given=[RT_TJ, NULL],
      by=[order(lemmas=[(T(M)*inv(V)*M*F + Gam)*inv(J) == T(Phi)*Gam]), example({**ONE, "r": 1, "N": [[1]]}),
          example({**ONE, "r": 1, "Gam": [[0]], "N": [[1]]}),
          instances(6, n=(1, 2), p=(1, 2), q=(1,), r=(1, 2), using={c: vector(n), E: nonsingular(n)},
                    made_by={M: Zero(p, n), Gam: Zero(n, 1), H: Zero(n, n), Phi: E*matrix_of(i, j, n, n, when(i == j, 1 + c[i]**2, 0))*inv(E),
                             F: E*matrix_of(i, j, n, 1, when(i == 1, 1, 0)), J: (1 + c[1]**2)*Identity(1)})])

claim("D71-E3.121", "the eigenvector that is not seen",
      Phi*(F*v) == (F*v)*inv(Lam),
      sizes=["n", "p", "q", "r"], over={**COLUMNS, v: matrix(q, r), Lam: nonsingular(r)}, where=R_WHERE,
      given=[RT_TJ, given("J^{-1}v = lambda v", inv(J)*v == v*Lam), given("Gamma v = 0", Gam*v == Zero(n, r)), given("MFv = 0", M*F*v == Zero(p, r))],
      by=[order(lemmas=[v == J*v*Lam, F*J == H*Gam*J + Phi*F, F*v == Phi*F*v*Lam]),
          example({**HIDDEN, "r": 1, "v": [[1]], "Lam": [["1/2"]]}), example({**HIDDEN, "r": 1, "v": [[1]], "Lam": [["1/3"]]}),
          example({**HIDDEN, "r": 1, "v": [[1]], "J": [[3]], "Lam": [["1/3"]]}), example({**ONE, "r": 1, "v": [[1]], "Lam": [["1/2"]]}),
          example({**HIDDEN, "r": 1, "H": [[1]], "F": [[-1]], "Gam": [[3]], "J": [["1/2"]], "v": [[1]], "Lam": [[2]]}),
          instances(6, n=(1, 2), p=(1, 2), q=(1,), r=(1, 2), using={c: vector(n), E: nonsingular(n)},
                    made_by={M: Zero(p, n), Gam: Zero(n, 1), H: Zero(n, n), Phi: E*matrix_of(i, j, n, n, when(i == j, 1 + c[i]**2, 0))*inv(E),
                        F: E*matrix_of(i, j, n, 1, when(i == 1, 1, 0)), J: (1 + c[1]**2)*Identity(1), Lam: (1/(1 + c[1]**2))*Identity(r)})],
      note="lambda stands on the right as a matrix.")

OUTSIDE = given("the eigenvalues of J are outside the circle", schur(inv(J)))
GONE = Zero(n, r)
BOTH = [T(X)*T(F)*T(M)*inv(V)*M*F*X, T(X)*FORM*X]
ON_THE_WAY = [
    (T(F)*Gam - T(Gam)*F == Zero(q, q), []),
    (psd(FORM), [T(inv(J))*T(F)*T(M)*inv(V)*M*F*inv(J), T(inv(J))*T(S*F + Gam)*inv(Phi)*H*PhiT*(S*F + Gam)*inv(J)]),
    (T(M)*inv(V)*M*F + Gam == T(Phi)*Gam*J, []), ((BOTH[0] + BOTH[1])*Identity(r) == Zero(r, r), []), (M*F*X == Zero(p, r), BOTH),
    (F*J == H*Gam*J + Phi*F, [])]

claim("D71-T3.18", "when the stable equilibrium exists",
      (T(v)*Gam == Zero(s, q)) & (Gam*X == GONE) & (M*F*X == Zero(p, r)) & (Phi*F*X == F*N),
      sizes=["n", "p", "q", "r", "s"], over={**COLUMNS, N: matrix(q, r), v: matrix(n, s), Lam: nonsingular(s)}, where=R_WHERE,
      given=[RT_TJ, OUTSIDE, NULL, given("an unobservable mode", (Phi*v == v*Lam) & (M*v == Zero(p, s))), given("it is unstable", schur(inv(Lam)))],
      by=[order(*[terms for _, terms in ON_THE_WAY], [], [], [], [], lemmas=[lemma for lemma, _ in ON_THE_WAY],
                inside=[within(0, unique=(T(inv(J)), inv(J))), within(1, stein=T(inv(J))), within(len(ON_THE_WAY), unique=(T(inv(Lam)), inv(J)))]),
          restated("a space other than zero that a matrix keeps has an eigenvector of it"),
          example({**ONE, "r": 1, "s": 1, "N": [[0]], "v": [[1]], "Lam": [[2]]}), example({**ONE, "r": 1, "s": 1, "N": [[1]], "v": [[0]], "Lam": [[2]]}),
          example({**ONE, "r": 1, "s": 1, "F": [["-1/2"]], "J": [["1/2"]], "N": [[0]], "v": [[0]], "Lam": [[2]]}),
          example(n=2, p=1, q=2, r=2, s=2, Phi=[[1, 2], [-2, 1]], H=[[0, 0], [0, 0]], M=[[0, 0]], V=[[1]], F=[[1, 0], [0, 1]], Gam=[[0, 0], [0, 0]],
                  J=[[1, 2], [-2, 1]], N=[[1, 0], [0, 1]], v=[[1, 0], [0, 1]], Lam=[[1, 2], [-2, 1]]),
          # two states that do not meet, J = diag(2, 1/2) from the first
          example(n=2, p=2, q=2, r=1, Phi=[[1, 0], [0, 1]], H=[["1/2", 0], [0, "4/3"]], M=[[1, 0], [0, 1]], V=[[1, 0], [0, 1]], F=[[1, "-1/2"], [0, 0]],
                  Gam=[[1, 1], [0, 0]], J=[[2, 0], [0, "1/2"]], N=[[1], [-1]], s=1, v=[[0], [0]], Lam=[[2]]),
          example({**ONE, "r": 1, "s": 1, "Gam": [[0]], "N": [[1]], "v": [[0]], "Lam": [[2]]}),
          example({**HIDDEN, "r": 1, "s": 1, "H": [[1]], "Phi": [["1/2"]], "F": [["4/3"]], "Gam": [[1]], "J": [[2]], "N": [[0]], "v": [[1]], "Lam": [["1/2"]]}),
          instances(6, n=(1, 2), p=(1, 2), q=(1,), r=(1, 2), s=(1,), using={c: vector(n), E: nonsingular(n)},
                    made_by={M: Zero(p, n), Gam: Zero(n, 1), H: Zero(n, n), Phi: E*matrix_of(i, j, n, n, when(i == j, 2 + c[i]**2, 0))*inv(E),
                             F: E*matrix_of(i, j, n, 1, when(i == 1, 1, 0)), J: (2 + c[1]**2)*Identity(1), Lam: (2 + c[1]**2)*Identity(s),
                             v: E*matrix_of(i, j, n, s, when(i == j, 1, 0))})],
      note="An unobservable vector v with |lambda| > 1 is a null row of Gamma; lambda stands on the right as a matrix, and v has s columns. If "
           "Gamma N = 0 then J^{-1} keeps the space of such N, and F takes it to a space that Phi^{-1} keeps and M does not see; F is one-to-one there, as T "
           "has independent columns, so an eigenvector of J^{-1} in it gives an unobservable mode with an eigenvalue of J, outside the circle.")
