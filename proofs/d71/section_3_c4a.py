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
from exactkf.evidence import example, first, induction, instances, order, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    eq,
    given,
    hstack,
    iff,
    inv,
    invertible,
    let,
    loewner,
    matrix,
    matrix_of,
    nonneg,
    nonsingular,
    pd,
    positive_definite,
    psd,
    rec,
    rows,
    scalar,
    schur,
    sym,
    symbols,
    symmetric,
    symmetric_matrix,
    trace,
    vector,
    vstack,
    when,
)
from proofs.d71.fading import Fading, N, Pi, R
from proofs.d71.notation import H, M, P, Phi, V, gram, i, j, n, p, step, update

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

Y, Q, t, g1, g2, al, be, rho, E, a, e = symbols("Y Q t g1 g2 alpha beta rho E a e")
SLOPE = K_
STABLE = sym("L")
LINEAR = Fading(STABLE, Q)
#: Q = I + UU' bounds U: [[Q, U], [U', Q]] is the sum of these
IN_BLOCKS = [vstack(U, I)*hstack(T(U), I), vstack(I, Zn)*hstack(I, Zn), vstack(Zn, U)*hstack(Zn, T(U))]


def _within_bound(s) -> list:
    """The terms of [[R, N U_s], [N U_s', R]], with N = s + 1."""
    now, twice = N[s]*(Pi[s]*Q*T(Pi[s])), block([[Pi[s], Zn], [Zn, Pi[s]]])
    return [block([[R - now, Zn], [Zn, R - now]]), *(N[s]*twice*x*T(twice) for x in IN_BLOCKS)]


def _size(s):
    """g*X_s g for g = g1 + i g2, its real part."""
    return T(g1)*X[s]*g1 + T(g2)*X[s]*g2


QUADRATIC = A + B*P + P*C == P*D*P
NEXT_QUADRATIC = A + B*(P + U) + (P + U1)*C == (P + U1)*D*(P + U)
BOTH_QUADRATIC = [first(QUADRATIC, base=order(inside=[within(0, P == step())])), first(NEXT_QUADRATIC, base=order(inside=[
    within(0, A + B*(P + U) + step(P + U)*C == step(P + U)*D*(P + U), P + U1 == step(P + U))]))]
BY_EQUILIBRIUM = order(inside=[within(0, QUADRATIC, NEXT_QUADRATIC, U1*((D*P - C) + D*U) == (B - P*D)*U)])
BOTH_SIDES = [T(B - P*D)*(D*P - C) == I, (D*P - C)*T(B - P*D) == I]
AT_K = T(SLOPE)*(D*P - C) == I
INVERSE_OF = within(2, AT_K)
GROWTH = within(0, T(g1)*SLOPE == al*T(g1) - be*T(g2), T(g2)*SLOPE == be*T(g1) + al*T(g2), _size(t) == rho[t]*(T(g1)*U*g1 + T(g2)*U*g2))
PAIR = rows([[al, be], [-be, al]])
NOTHING = {g1: Zero(n, 1), g2: Zero(n, 1), al: 1, be: 0}
RATIO = 1/(2 + a[i]**2)
BALL = (1/(1 + trace(y*T(y))))*y


#: the basis in which K is a rotation times |psi|
FRAME = inv(T(E))
#: one dimension: nothing is driven or measured, and K = Phi = 1/2
ONE = {"n": 1, "p": 1, "Phi": [["1/2"]], "H": [[0]], "M": [[0]], "V": [[1]], "P": [[0]], "U": [[1]], "U1": [["1/4"]], "K": [["1/2"]], "L": [["1/2"]],
       "g1": [0], "g2": [0], "alpha": 1, "beta": 0}
#: an equilibrium that is not symmetric
NOT_HERMITIAN = {**SKEW, "U1": [[-3, "27/2"], [1, -3]], "K": [[2, -1], [0, "1/2"]], "L": [[0, 0], [0, 0]], "g1": [0, 0], "g2": [0, 0], "alpha": 1, "beta": 0}
CHANGES = [{"U1": [[1]]}, {"g1": [1]}, {"K": [[0]], "L": [[0]]}, {"Phi": [[2]], "K": [[2]], "U1": [[4]]}, {"Phi": [[2]], "K": [[2]], "L": [[2]], "U1": [[4]]}, {"L": [[0]]},
           {"H": [[1]], "U1": [["5/4"]], "M": [[1]]}]


def _in_basis(entry):
    """E G for the diagonal matrix G of these entries."""
    return E*matrix_of(i, j, n, n, when(i == j, entry, 0))


claim("D71-E3.151", "the linear equation",
      (U1 - (B - P*D)*U*inv(D*P - C) == -U1*D*U*inv(D*P - C))
      & (symmetric(P) >> ((T(SLOPE)*(D*P - C) == I) & (inv(D*P - C) == T(SLOPE))))
      & always(t, psd(block([[R, N[t]*Y[t]], [N[t]*T(Y[t]), R]])))
      & always(t, _size(t) == rho[t]*(T(g1)*U*g1 + T(g2)*U*g2)),
      sizes=["n", "p"],
      over={**ANY, U: matrix(n, n), U1: matrix(n, n), g1: vector(n), g2: vector(n), al: scalar(), be: scalar(),
            SLOPE: matrix(n, n), STABLE: matrix(n, n)},
      where=[*COEFFICIENTS, rec(Y, t, U, STABLE*Y[t]*T(STABLE)), rec(X, t, U, SLOPE*X[t]*T(SLOPE)), rec(rho, t, 1, (al**2 + be**2)*rho[t]),
             let(Q, I + U*T(U)), *LINEAR.where],
      given=[EQUILIBRIUM, given("the next deviation", U1 == step(P + U) - P), given("K = B - PD", SLOPE == B - P*D),
             given("L is inside the unit circle", schur(STABLE)), given("eigenvector of K'", (T(SLOPE)*g1 == al*g1 - be*g2) & (T(SLOPE)*g2 == be*g1 + al*g2))],
      by=[induction(before=BOTH_QUADRATIC, also=[[], [], [], [*LINEAR.also, LINEAR.bound, Y[t] == Pi[t]*U*T(Pi[t])], []],
                    base=[BY_EQUILIBRIUM, order(lemmas=BOTH_SIDES), order(lemmas=BOTH_SIDES, inside=[INVERSE_OF]),
                          LINEAR.begins(LINEAR.first, [], _within_bound(t)), order()],
                    step=[order(), order(), order(), LINEAR.goes_on(LINEAR.then, [], _within_bound(t + 1)),
                          order(inside=[GROWTH])]),
          instances(8, n=(1, 2), p=(1, 2), horizon=2, using={E: nonsingular(n), a: vector(n), e: vector(n), y: matrix(n, n)},
                    made_by={**NOTHING, Phi: _in_basis(RATIO*(1 + when(i <= p, e[i]**2, 0)))*inv(E), P: _in_basis(e[i]**2)*T(E),
                             M: matrix_of(i, j, p, n, when(i == j, 1, 0))*inv(E), V: Identity(p), **SOLVED, SLOPE: B - P*D, STABLE: B - P*D,
                             U: _in_basis(1 - RATIO**2)*BALL*T(_in_basis(1 - RATIO**2)), U1: step(P + U) - P}),
          instances(8, n=(2,), p=(1, 2), horizon=2, using={E: nonsingular(2), e: vector(2), y: matrix(2, 2)},
                    made_by={al: 1 + e[1]**2, be: e[2], Phi: T(E*PAIR*inv(E)), P: Zn, H: Zn, g1: E*rows([[1], [0]]), g2: E*rows([[0], [1]]),
                             SLOPE: B - P*D, STABLE: Zn, U: FRAME*y*T(FRAME), U1: step(P + U) - P}),
          *(example({**ONE, **change}) for change in CHANGES), example(NOT_HERMITIAN)],
      note="K is B - PD. The deviation differs from (3.151) by a term of second order in U, at any equilibrium. For a Hermitian P, DP - C is the inverse of "
           "K', so that the eigenvalues of K are the conjugate reciprocals of those of J. So (3.151) is U -> KUK' for a Hermitian P. If L is inside the unit circle, the "
           "solution Y_k of U -> LUL' from any start U is at most R/(k + 1) in absolute value, in the sense of the block matrix, with R the same for all k: it tends to zero; "
           "take K for L where it is stable, with J outside the circle. stein(M, N) is the solution of X = MXM' + N. Last, if psi = alpha + i beta is an eigenvalue of K', with the eigenvector g = g1 + i g2, then g*X_k g is |psi|^(2k) g*Ug: it grows beyond all "
           "bounds where psi is outside the circle, and so an eigenvalue of J inside. g = 0 is allowed, so that nothing is assumed by this for the rest.")


CLOSED = K_*U*T(K_)*inv(I + D*U*T(K_))

claim("D71-E3.166", "the equation of the deviation from a Hermitian equilibrium",
      U1 == CLOSED,
      sizes=["n", "p"], over={**HERMITIAN, U: matrix(n, n), U1: matrix(n, n), K_: matrix(n, n)}, where=COEFFICIENTS,
      given=[EQUILIBRIUM, given("the next deviation", U1 == step(P + U) - P), given("K = B - PD", K_ == B - P*D)],
      by=[order(lemmas=[T(K_)*(D*P - C) == I, (D*P - C)*T(K_) == I, U1*(D*P - C + D*U) == K_*U, U1*(I + D*U*T(K_)) == K_*U*T(K_)]),
          instances(**MORE, made_by={**SOLVED, U1: step(P + U) - P, K_: B - P*D})],
      note="K is B - PD. P is Hermitian, as in (3.165).")
