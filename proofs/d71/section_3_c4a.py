# SPDX-License-Identifier: MIT
"""Deviations from an equilibrium (Chapter III, section C.4.a).

With the inverse cleared, two consecutive covariances satisfy A + B P_k + P_{k+1}C -
P_{k+1}D P_k = 0. Clearing is harmless: I + SP is singular exactly if MPM' + V is, because
(I + SP)M' = M'V^{-1}(MPM' + V) carries null vectors of one to the other.

Put P_k = P + U_k with an equilibrium P. The constant terms cancel and
U_{k+1} = (B - PD)U_k[(DP - C) + DU_k]^{-1}. For small U the bracket is DP - C up to a term of
second order. If P is Hermitian, DP - C and B - PD are conjugate inverses of each other, so
the linear equation is U -> (B - PD)U(B - PD)*: stable if the eigenvalues of DP - C, those of
J, are outside the unit circle.
"""

from exactkf.claims import claim
from exactkf.evidence import example, instances, order, restated
from exactkf.language import (
    Identity,
    T,
    Zero,
    eq,
    given,
    iff,
    inv,
    invertible,
    let,
    loewner,
    matrix,
    nonneg,
    nonsingular,
    pd,
    positive_definite,
    sym,
    symbols,
    symmetric,
    symmetric_matrix,
    trace,
)
from proofs.d71.notation import H, M, P, Phi, V, gram, n, p, step, update

q, S, A, B, C, D, U, U1, P1, x, y, v, W, X = symbols("q S A B C D U U1 P1 x y v W X")
I, Zn = Identity(n), Zero(n, n)
PhiT = inv(T(Phi))
GRAM = let(S, gram())
COEFFICIENTS = [GRAM, let(A, H*PhiT), let(B, H*PhiT*S + Phi), let(C, -PhiT), let(D, PhiT*S)]
SYSTEM = {Phi: nonsingular(n), H: symmetric_matrix(n), M: matrix(p, n), V: positive_definite(p)}
ANY = {**SYSTEM, P: matrix(n, n)}
MORE = {"n": (1, 2, 3), "p": (1, 2)}

# --- from the covariance equation to the quadratic one ------------------------------------------------------------------

claim("D71-E3.146", "two consecutive covariances",
      A + B*P + P1*C - P1*D*P == Zn,
      sizes=["n", "p"], over=ANY, where=[*COEFFICIENTS, let(P1, step())], by=[instances(**MORE)],
      note="P is P_k and P1 is P_{k+1}.")

FREE = {P: matrix(n, n), M: matrix(p, n), V: nonsingular(p)}
INNOVATION = M*P*T(M) + V

claim("D71-T3.21", "MPM' + V and I + M'V^{-1}MP are singular together",
      iff(invertible(INNOVATION), invertible(I + T(M)*inv(V)*M*P)),
      sizes=["n", "p"], over=FREE,
      by=[order([I - T(M)*inv(INNOVATION)*M*P], [inv(V) - inv(V)*M*P*inv(I + T(M)*inv(V)*M*P)*T(M)*inv(V)]),
          example(n=1, p=1, P=[[-1]], M=[[1]], V=[[1]]), example(n=2, p=1, P=[[-1, 1], [1, 0]], M=[[1, 0]], V=[[1]]),
          example(n=1, p=2, P=[[-1]], M=[[1], [2]], V=[[1, 0], [0, 1]]), example(n=1, p=2, P=[["-1/5"]], M=[[1], [2]], V=[[1, 0], [0, 1]]),
          instances(n=(1, 2, 3), p=(1, 2))])

claim("D71-E3.147", "the identity behind it",
      (I + T(M)*inv(V)*M*P)*T(M) == T(M)*inv(V)*INNOVATION,
      sizes=["n", "p"], over=FREE, by=[instances(**MORE)])

claim("D71-E3.148", "a null vector of MPM' + V gives one of I + M'V^{-1}MP",
      eq((I + T(M)*inv(V)*M*P)*y, T(M)*inv(V)*INNOVATION*x, Zero(n, q)) & (M*P*y + V*x == Zero(p, q)) & ((y == Zero(n, q)) >> (x == Zero(p, q))),
      sizes=["n", "p", "q"], over={**FREE, x: matrix(p, q), y: matrix(n, q)},
      given=[given("x is a null vector", INNOVATION*x == Zero(p, q)), given("y = M'x", y == T(M)*x)],
      by=[order([], [], [], [inv(V)]),
          example(n=1, p=1, q=1, P=[[-1]], M=[[1]], V=[[1]], x=[2], y=[2]),
          example(n=1, p=2, q=1, P=[["-1/5"]], M=[[1], [2]], V=[[1, 0], [0, 1]], x=[1, 2], y=[5]),
          example(n=1, p=1, q=1, P=[[-1]], M=[[1]], V=[[1]], x=[2], y=[0]), example(n=1, p=1, q=1, P=[[0]], M=[[0]], V=[[1]], x=[2], y=[0]),
          instances(8, n=(2, 3), p=(1,), q=(1, 2), made_by={V: -M*P*T(M), y: T(M)*x})],
      note="y is not zero: it could be so only for x = 0.")

claim("D71-E3.149", "a null row of I + M'V^{-1}MP gives one of MPM' + V",
      eq(T(x)*INNOVATION, T(v)*(I + T(M)*inv(V)*M*P)*T(M), Zero(q, p)) & (T(v) + T(x)*M*P == Zero(q, n)) & ((x == Zero(p, q)) >> (v == Zero(n, q))),
      sizes=["n", "p", "q"], over={**FREE, v: matrix(n, q), x: matrix(p, q)},
      given=[given("v' is a null row", T(v)*(I + T(M)*inv(V)*M*P) == Zero(q, n)), given("w' = v'M'V^{-1}", T(x) == T(v)*T(M)*inv(V))],
      by=[example(n=1, p=1, q=1, P=[[-1]], M=[[1]], V=[[1]], v=[2], x=[2]), example(n=2, p=1, q=1, P=[[-1, 1], [1, 0]], M=[[1, 0]], V=[[1]], v=[1, -1], x=[1]),
          example(n=1, p=1, q=1, P=[[-1]], M=[[1]], V=[[1]], v=[2], x=[0]), example(n=1, p=1, q=1, P=[[1]], M=[[1]], V=[[1]], v=[1], x=[1]),
          example(n=1, p=1, q=1, P=[[-1]], M=[[1]], V=[[1]], v=[2], x=[1]), example(n=1, p=1, q=1, P=[[1]], M=[[0]], V=[[1]], v=[1], x=[0]),
          instances(8, n=(2, 3), p=(1,), q=(1, 2), using={X: matrix(p, q)}, made_by={V: -M*P*T(M), x: X, v: -T(P)*T(M)*X})],
      note="x is called w in the print; it is not zero: it could be so only for v = 0.")

# --- deviations ---------------------------------------------------------------------------------------------------------

EQUILIBRIUM = given("P is an equilibrium", P == step())
SOLVED = {H: P - Phi*update()*T(Phi)}
NEXT = let(U1, step(P + U) - P)
DEVIATION = {**ANY, U: matrix(n, n)}
SOLVING = instances(**MORE, using={P: symmetric_matrix(n)}, made_by=SOLVED)
#: a family of equilibria that are not symmetric, from Example 3.1
SKEW = {"n": 2, "p": 1, "Phi": [[2, -1], [0, "1/2"]], "H": [[4, 6], [6, 9]], "M": [[-1, "2/3"]], "V": [[1]], "P": [[6, 9], [8, 12]], "U": [[1, 2], [0, -1]]}

HERE, NEAR = symbols("HERE NEAR")
GROWN = 4*I + 4*X + 4*T(X) + 4*X*T(X)
far, near = symbols("far near")

claim("D71-S52", "I + SP stays nonsingular near an equilibrium",
      invertible(HERE) & invertible(NEAR),
      sizes=["n", "p"], over={P: matrix(n, n), M: matrix(p, n), V: positive_definite(p), U: matrix(n, n), far: nonneg(), near: nonneg()},
      where=[GRAM, let(HERE, I + S*P), let(NEAR, I + S*(P + U)), let(W, T(M)*inv(M*P*T(M) + V)*M), let(X, W*U)],
      given=[given("a bound of W", loewner(far*I, W*T(W))), given("U is small", loewner(near*I, U*T(U))), given("how small", 4*far*near <= 1)],
      by=[order([4*W*(near*I - U*T(U))*T(W), 4*near*(far*I - W*T(W)), (1 - 4*far*near)*I], [2*(I + 2*X)*T(I + 2*X), I - 4*X*T(X), I],
                [I - W*P], [4*T(I + X)*inv(GROWN)*inv(HERE)], lemmas=[loewner(I, 4*X*T(X)), pd(GROWN)]),
          example(n=1, p=1, M=[[1]], V=[[1]], P=[[1]], U=[[-2]], far="1/4", near=4),
          example(n=1, p=1, M=[[1]], V=[[1]], P=[[1]], U=[[-2]], far="1/4", near=1),
          example(n=1, p=1, M=[[1]], V=[[1]], P=[[1]], U=[[-2]], far="1/16", near=4),
          instances(8, n=(1, 2), p=(1,), using={y: matrix(n, n)},
                    made_by={far: trace(T(W)*W), near: 1/(4*far + 1), U: y*(1/(1 + (4*far + 1)*trace(T(y)*y)))})],
      note="The neighbourhood is UU' <= near I, a ball in the spectral norm, with near = 1/(4 far) for any number far with WW' <= far I, such as the trace of "
           "WW'. Of the equilibrium nothing is used but that MPM' + V is nonsingular there, as its equation presupposes.")

claim("D71-E3.150", "the equation of the deviation",
      U1 == (B - P*D)*U*inv((D*P - C) + D*U),
      sizes=["n", "p"], over=DEVIATION, where=[*COEFFICIENTS, NEXT], given=[EQUILIBRIUM],
      by=[example(SKEW), SOLVING],
      note="U is U_k and U1 is U_{k+1}. P and U may be any matrices, symmetric or not, for which the inverses exist.")

K_ = sym("K")
HERMITIAN = {**SYSTEM, P: symmetric_matrix(n)}

claim("D71-E3.165", "DP - C and B - PD are conjugate inverses of each other",
      inv(D*P - C) == T(B - P*D),
      sizes=["n", "p"], over=HERMITIAN, where=COEFFICIENTS, given=[EQUILIBRIUM], by=[instances(**MORE, made_by=SOLVED)],
      note="P is Hermitian, which the theorem does not say of its equilibrium; see the example of D71-E3.166.")

claim("D71-E3.151", "the linear equation",
      (U1 - (B - P*D)*U*inv(D*P - C) == -U1*D*U*inv(D*P - C))
      & (symmetric(P) >> ((T(B - P*D)*(D*P - C) == I) & (inv(D*P - C) == T(B - P*D)))),
      sizes=["n", "p"], over={**ANY, U: matrix(n, n)}, where=[*COEFFICIENTS, NEXT], given=[EQUILIBRIUM],
      by=[restated("U -> KUK' is stable if the eigenvalues of K are inside the unit circle, and unstable if one is outside."), example(SKEW), SOLVING],
      note="The deviation differs from (3.151) by a term of second order in U, at any equilibrium. For a Hermitian P, (3.151) is U -> K U K* with K = "
           "B - PD = (DP - C)^{-*}, whose eigenvalues are the conjugate reciprocals of those of J. Its powers tend to zero if J is outside the circle, and "
           "grow if J has an eigenvalue inside.")

CLOSED = K_*U*T(K_)*inv(I + D*U*T(K_))

claim("D71-E3.166", "the equation of the deviation from a Hermitian equilibrium",
      U1 == CLOSED,
      sizes=["n", "p"], over={**HERMITIAN, U: matrix(n, n), U1: matrix(n, n), K_: matrix(n, n)}, where=COEFFICIENTS,
      given=[EQUILIBRIUM, given("the next deviation", U1 == step(P + U) - P), given("K = B - PD", K_ == B - P*D)],
      by=[order(lemmas=[T(K_)*(D*P - C) == I, (D*P - C)*T(K_) == I, U1*(D*P - C + D*U) == K_*U, U1*(I + D*U*T(K_)) == K_*U*T(K_)]),
          instances(**MORE, made_by={**SOLVED, U1: step(P + U) - P, K_: B - P*D})],
      note="K is B - PD. P is Hermitian, as in (3.165).")
