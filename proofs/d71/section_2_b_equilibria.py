# SPDX-License-Identifier: MIT
"""Prior work on the continuous-time equation (Chapter II, section B).

With S = M'V^{-1}M the columns of [F; Gamma] span an invariant subspace of R_c = [[A, H], [S, -A']]
if R_c[F; Gamma] = [F; Gamma]J. For a nonsingular Gamma, P = F Gamma^{-1} then solves the quadratic
equation, and each solution P comes from [P; I] with J = SP - A'. The matrix Q = Gamma'F is a
congruence of P, and

    J'Q + QJ = Gamma'H Gamma + F'SF,     J'(Q - Q') + (Q - Q')J = 0.

The first equation makes Q nonnegative if J has its eigenvalues on the right, and the second makes
it symmetric unless two eigenvalues add up to zero. With K = (J - I)(J + I)^{-1}, which is inside
the circle exactly if J is on the right, both become equations of the kind X = K'XK + Y.

One state with the constant data a, h, s can be solved: if e and -q are the roots of the right
side, the solution that is 0 at t_0 is eq(1 - u)/(q + eu) with u = exp(-s(e + q)(t - t_0)).
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, identity, induction, instances, order, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    exists,
    given,
    iff,
    inv,
    invertible,
    let,
    loewner,
    matrix,
    nonneg,
    nonsingular,
    nonzero,
    pd,
    positive,
    positive_definite,
    positive_semidefinite,
    psd,
    rec,
    scalar,
    schur,
    signal_of,
    standing,
    symbols,
    symmetric,
    symmetric_matrix,
    vector,
    vstack,
)
from proofs.d71.notation import H, K, M, P, Phi, Q, V, gain, gram, joseph, k, kronecker, n, p, step

A, S, Rc, F, Gam, J, X, P2, B, G, TWIST = symbols("A S Rc F Gam J X P2 B G TWIST")
I, Zn = Identity(n), Zero(n, n)

UNEXACT = "solutions of a differential equation of matrices that change with time, over an unbounded time; no exact instance decides it"
not_checked("D71-S6", "solutions of the Riccati equation exist", UNEXACT)
not_checked("D71-S7", "solutions of the Riccati equation stay definite", UNEXACT + "; D71-T3.2 is the same in discrete time")
not_checked("D71-S8", "solutions become definite", UNEXACT + "; D71-T3.3 is the same in discrete time")
not_checked("D71-S9", "solutions stay ordered", UNEXACT + "; D71-T3.4 is the same in discrete time")
not_checked("D71-E2.1", "uniformly completely driven and observable processes", UNEXACT)

# --- the moving equilibrium ------------------------------------------------------------------------------------------------

e, q, s, a, h, u, t, t0, N, B0, eps, dP, Pt = symbols("e q s a h u t t0 N B0 eps dP Pt")

claim("D71-E2.3", "the moving equilibrium as a limit of solutions that start from zero",
      exists(N, 0, 8, abs((t - (N + 1))*h - (t - N)*h) < eps),
      over={h: nonneg(), t: nonneg(), eps: positive()},
      by=[example(h=1, t=0, eps="1/2"), instances()],
      repair=repair(
          "sign", "t_0 is before t, and tends to minus infinity, not to infinity",
          (dP == h + 2*a*Pt - s*Pt**2) & (h + 2*a*e - s*e**2 == 0) & (e - Pt == e*(e + q)*u/(q + e*u)),
          over={e: positive(), q: positive(), s: positive(), u: positive()},
          where=[let(h, s*e*q), let(a, s*(e - q)/2), let(Pt, e*q*(1 - u)/(q + e*u)), let(dP, -e*q*(q + e)/(q + e*u)**2*(-s*(e + q)*u))],
          by=[identity(), instances()]),
      note="One state with a = 0, v = 1 and m(t) = 1 for t < 0, m(t) = 0 for t >= 0: for every t there is a t_0 < t with W_b(t, t_0) > 0. For t and t_0 = N "
           "from 0 on, P(t; 0, N) is h(t - N). If it has a limit as N grows, the change from N to N + 1 becomes small; in the counterexample it is -1 for "
           "every N. Eight values of N are stated. Where solutions are only followed forward, t_0 cannot pass t at all. The repair is for one state and "
           "constant data: u = exp(-s(e + q)(t - t_0)) tends to 0 as t_0 tends to minus infinity, and P(t; 0, t_0) to e.")

not_checked("D71-S10", "all solutions approach the moving equilibrium", UNEXACT + "; D71-T3.24 is the case of constant data in discrete time")

# --- equilibria ------------------------------------------------------------------------------------------------------------

MODEL = {A: matrix(n, n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}
R_WHERE = [let(S, gram()), let(Rc, block([[A, H], [S, -T(A)]]))]
R_TJ = given("R_c T = TJ", Rc*vstack(F, Gam) == vstack(F, Gam)*J)
FROM_P = {F: P*Gam, J: inv(Gam)*(gram()*P - T(A))*Gam}

claim("D71-E2.4", "constant solutions",
      A*P + P*T(A) + H - P*T(M)*inv(V)*M*P == H + A*P + P*T(A) - P*T(M)*inv(V)*M*P,
      sizes=["n", "p"], over={**MODEL, P: symmetric_matrix(n)}, by=[order(), instances(6, n=(1, 2), p=(1, 2))],
      note="A constant matrix solves (1.12) exactly if the right side of (1.12), here on the left, is zero at it.")

SOLVES = H + A*P2 + P2*T(A) - P2*S*P2 == Zn
EIGEN = {**MODEL, H: symmetric_matrix(n), F: matrix(n, n), Gam: nonsingular(n), J: matrix(n, n), P2: matrix(n, n)}
claim("D71-E2.6", "equilibria and invariant subspaces",
      (H + A*P + P*T(A) == P*S*P) & (Rc*vstack(P2, I) == vstack(P2, I)*(S*P2 - T(A))),
      sizes=["n", "p"], over=EIGEN, where=[*R_WHERE, let(P, F*inv(Gam))], given=[R_TJ, given("P_2 is an equilibrium", SOLVES)],
      by=[order(), example(n=1, p=1, A=[[1]], H=[[1]], M=[[1]], V=[[1]], F=[[1]], Gam=[[1]], J=[[1]], P2=[[1]]),
          example(n=1, p=1, A=[[0]], H=[[1]], M=[[1]], V=[[1]], F=[[2]], Gam=[[1]], J=[[2]], P2=[[1]]),
          example(n=1, p=1, A=[[0]], H=[[1]], M=[[1]], V=[[1]], F=[[1]], Gam=[[1]], J=[[1]], P2=[[2]]),
          instances(8, n=(1, 2), p=(1, 2), using={X: matrix(n, n)},
                    made_by={P2: X + T(X), H: P2*gram()*P2 - A*P2 - P2*T(A), F: P2*Gam, J: inv(Gam)*(gram()*P2 - T(A))*Gam})],
      note="P is made of an invariant subspace, and P_2 is any equilibrium, which [P_2; I] gives back; if R_c has a diagonal Jordan form its invariant "
           "subspaces are spanned by eigenvectors.")

claim("D71-S11", "eigenvalues mirrored at the imaginary axis",
      block([[Zn, -I], [I, Zn]])*Rc*block([[Zn, I], [-I, Zn]]) == -T(Rc), sizes=["n", "p"], over=MODEL, where=R_WHERE,
      by=[order(), instances(6, n=(1, 2), p=(1, 2))],
      note="The outer factors are inverse to each other, so R_c is similar to -R_c'. R_c is real, so if omega is an eigenvalue so is its conjugate, and by "
           "this the negative of that.")

# --- symmetry and definiteness ---------------------------------------------------------------------------------------------

OVER = {**MODEL, F: matrix(n, n), Gam: nonsingular(n), J: matrix(n, n)}
POSITIVE_P = {"using": {X: positive_definite(n), B: matrix(n, n)},
              "made_by": {A: (X*gram() - H*inv(X))/2 + (B - T(B))*inv(X), F: X*Gam, J: inv(Gam)*(gram()*X - T(A))*Gam}}
#: P = [[0, 1], [-1, 0]] solves the equation with A = 0, H = -S = 0
SKEW = {"n": 2, "p": 1, "A": [[0, 0], [0, 0]], "H": [[0, 0], [0, 0]], "M": [[0, 0]], "V": [[1]], "F": [[0, 1], [-1, 0]], "Gam": [[1, 0], [0, 1]]}

claim("D71-T2.1", "equilibria that are symmetric",
      symmetric(F*inv(Gam)), sizes=["n", "p"], over=OVER, where=[*R_WHERE, let(TWIST, kronecker(T(J), I) + kronecker(I, T(J)))],
      given=[R_TJ, given("no two eigenvalues of J add up to zero", invertible(TWIST))],
      by=[example({**SKEW, "J": [[0, 0], [0, 0]]}), example({**SKEW, "J": [[1, 0], [0, 2]]}), instances(6, n=(1, 2), p=(1, 2), **POSITIVE_P)],
      note="For real J, whose eigenvalues may be complex; omega_i + omega_j* = 0 for some pair says the same as omega_i + omega_j = 0 for some pair then. "
           "Gamma'F - F'Gamma solves J'X + XJ = 0, a linear equation whose matrix is TWIST, with the sums of two eigenvalues of J as its eigenvalues.")

x, y, b, r = symbols("x y b r")
FLOW = T(Gam)*H*Gam + T(F)*S*F
CONGRUENT = T(Gam)*(F*inv(Gam))*Gam
INVERSE = inv(Gam)*inv(F*inv(Gam))*inv(T(Gam))
SMALL = [T(x)*CONGRUENT*x, T(y)*CONGRUENT*y]
ENERGY = T(x)*CONGRUENT*x + T(y)*CONGRUENT*y
FALLING = [T(x)*FLOW*x, T(y)*FLOW*y, 2*r*ENERGY]
claim("D71-T2.2.a", "the eigenvalues of positive equilibria",
      (x == Zero(n, 1)) & (y == Zero(n, 1)),
      sizes=["n", "p"], over={**OVER, x: vector(n), y: vector(n), r: positive(), b: scalar()}, where=[*R_WHERE, let(Q, T(Gam)*F)],
      given=[R_TJ, given("P > 0", pd(F*inv(Gam))), given("x + iy at -r + ib", (J*x == -r*x - b*y) & (J*y == b*x - r*y))],
      by=[order([], FALLING, SMALL, SMALL, [INVERSE], [INVERSE],
                lemmas=[T(Gam)*F == T(F)*Gam, ENERGY == Zero(1, 1), CONGRUENT*x == Zero(n, 1), CONGRUENT*y == Zero(n, 1)]),
          example(n=1, p=1, A=[[1]], H=[[0]], M=[[0]], V=[[1]], F=[[0]], Gam=[[1]], J=[[-1]], x=[1], y=[0], r=1, b=0),
          example(n=1, p=1, A=[[1]], H=[[1]], M=[[1]], V=[[1]], F=[[1]], Gam=[[1]], J=[[-1]], x=[1], y=[0], r=1, b=0),
          example(n=1, p=1, A=[[0]], H=[[1]], M=[[1]], V=[[1]], F=[[1]], Gam=[[1]], J=[[1]], x=[1], y=[1], r=1, b=0),
          instances(6, n=(1, 2), p=(1, 2), using=POSITIVE_P["using"], made_by={**POSITIVE_P["made_by"], x: Zero(n, 1), y: Zero(n, 1)})],
      note="Real and imaginary part of an eigenvector of J left of the imaginary axis vanish.")

OUTSIDE = inv(J + I)
claim("D71-T2.2.b", "equilibria from eigenvalues on the right",
      psd(F*inv(Gam)), sizes=["n", "p"], over=OVER, where=[*R_WHERE, let(K, (J - I)*OUTSIDE), let(Q, T(Gam)*F)],
      given=[R_TJ, given("the eigenvalues of J are on the right", schur(K))],
      by=[order([], [2*T(OUTSIDE)*FLOW*OUTSIDE], [T(inv(Gam))*Q*inv(Gam)], lemmas=[Q == T(Q), psd(Q)],
                inside=[within(0, unique=(T(K), K)), within(1, stein=T(K))]),
          example(n=1, p=1, A=[[0]], H=[[1]], M=[[1]], V=[[1]], F=[[-1]], Gam=[[1]], J=[[-1]]),
          example(n=1, p=1, A=[[0]], H=[[1]], M=[[1]], V=[[1]], F=[[-1]], Gam=[[1]], J=[[1]]),
          instances(6, n=(1, 2), p=(1, 2), **POSITIVE_P)],
      note="The eigenvalues of J are on the right exactly if K = (J - I)(J + I)^{-1} exists and has its eigenvalues inside the circle.")

not_checked("D71-S13", "regular processes in continuous time",
            "that solutions of a differential equation converge exponentially fast; D71-T3.24 is the same in discrete time")

# --- wrong initial covariance ----------------------------------------------------------------------------------------------

Pa, Pc, P0, Pa0, Pc0 = symbols("Pa Pc P0 Pa0 Pc0")
GAIN, GAIN_C = gain(P[k], M[k], V[k]), gain(Pc[k], M[k], V[k])


def congruent(gain_, matrix_):
    """Phi(I - KM)X(I - KM)'Phi'."""
    return Phi[k]*(I - gain_*M[k])*matrix_*T(I - gain_*M[k])*T(Phi[k])


def noise(gain_, matrix_):
    """Phi KXK'Phi'."""
    return Phi[k]*gain_*matrix_*T(gain_)*T(Phi[k])


claim("D71-S14", "optimal, actual and calculated covariance stay ordered",
      always(k, psd(P[k]) & psd(Pc[k]) & loewner(Pa[k], P[k]) & loewner(Pc[k], Pa[k])), sizes=["n", "p"],
      over={Phi: signal_of(matrix(n, n), 0), M: signal_of(matrix(p, n), 0), V: signal_of(positive_definite(p), 0), H: signal_of(positive_semidefinite(n), 0),
            P0: positive_semidefinite(n), Pa0: positive_semidefinite(n), Pc0: positive_semidefinite(n)},
      where=[rec(P, k, P0, step(P[k], Phi[k], M[k], V[k], H[k])), rec(Pc, k, Pc0, step(Pc[k], Phi[k], M[k], V[k], H[k])),
             rec(Pa, k, Pa0, Phi[k]*joseph(gain(Pc[k], M[k], V[k]), Pa[k], M[k], V[k])*T(Phi[k]) + H[k])],
      given=[given("P_a(t_0) >= P_0", loewner(Pa0, P0)), given("P_c(t_0) >= P_a(t_0)", loewner(Pc0, Pa0))],
      by=[induction(base=order([P0], [Pc0], [Pa0 - P0], [Pc0 - Pa0]),
                    step=order([congruent(GAIN, P[k]), noise(GAIN, V[k]), H[k]], [congruent(GAIN_C, Pc[k]), noise(GAIN_C, V[k]), H[k]],
                               [congruent(GAIN_C, Pa[k] - P[k]), noise(GAIN_C - GAIN, M[k]*P[k]*T(M[k]) + V[k])], [congruent(GAIN_C, Pc[k] - Pa[k])])),
          instances(6, n=(1, 2), p=(1,), horizon=2, using={X: matrix(n, n), B: matrix(n, n)}, made_by={Pa0: P0 + X*T(X), Pc0: P0 + X*T(X) + B*T(B)})],
      note="The filter is run with the gains that belong to the calculated covariance P_c; P_a is the actual covariance of its error.")

# --- what the resume says --------------------------------------------------------------------------------------------------

Pf, Pg, Ph, nd, phi, m, v = symbols("Pf Pg Ph nd phi m v")
THREE = {P_: positive_semidefinite(n) for P_ in (Pf, Pg, Ph)}
ONLY_TWO = (Pf == Pg) | (Pg == Ph) | (Pf == Ph)
claim("D71-S17", "two equilibria beside an undriven unstable mode",
      ONLY_TWO, sizes=["n", "p"],
      over={Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p), nd: vector(n), s: scalar(), **THREE},
      given=[standing("an unstable mode", (T(Phi)*nd == s*nd) & (s**2 > 1) & (nd != Zero(n, 1))), standing("which is undriven", H*nd == Zero(n, 1)),
             standing("every state is observed", invertible(T(M)*M)),
             standing("three equilibria", (Pf == step(Pf)) & (Pg == step(Pg)) & (Ph == step(Ph)))],
      by=[example(n=2, p=2, Phi=[[2, 0], [0, 3]], H=[[0, 0], [0, 0]], M=[[1, 0], [0, 1]], V=[[1, 0], [0, 1]], nd=[1, 0], s=2,
                  Pf=[[0, 0], [0, 0]], Pg=[[3, 0], [0, 0]], Ph=[[0, 0], [0, 8]]), instances(n=(1,), p=(1,))],
      repair=repair(
          "missing hypothesis", "it is to be the only such mode; two of them, each with its two values, give four equilibria",
          iff((r == phi**2*r*v/(m**2*r + v)) & (r >= 0), (r == 0) | (r == (phi**2 - 1)*v/m**2)),
          over={phi: scalar(), m: nonzero(), v: positive(), r: scalar()}, given=[given("unstable", phi**2 > 1)],
          by=[example(phi=2, m=1, v=1, r=0), example(phi=2, m=1, v=1, r=3), example(phi="1/2", m=1, v=1, r="-3/4"),
              instances(made_by={r: (phi**2 - 1)*v/m**2}), instances()]),
      note="In the counterexample Phi = diag(2, 3), H = 0, M = V = I: each of the two modes is unstable, undriven and observable, and diag(a, b) is an "
           "equilibrium for a = 0, 3 and b = 0, 8. The repair is for one state, h = 0; the next chapter has more.")
