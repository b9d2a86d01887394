# SPDX-License-Identifier: MIT
"""Parts of the proof of global stability, and of the reduced equation (Chapter III, section C.4.b).

P_k lies between the solution that starts from 0 and one that starts above P_0 and P_e. For the
upper one U_k = P_k - P_e is below W_k = K^k U_0(K')^k with K = B - PD inside the circle; for the
lower one P_e - P_k is (K')^k-congruent to a bounded matrix.

If Phi L = L Phi_l and H = LGL', the equation lives on the range of L. Left eigenvectors carry
over by L': Phi_l'(L'N) = L'Phi'N.
"""

from exactkf.claims import claim, not_checked
from exactkf.evidence import example, induction, instances, order, part, restated, steps, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    given,
    hstack,
    inv,
    invertible,
    let,
    loewner,
    matrix,
    matrix_of,
    nonneg,
    nonsingular,
    nonzero,
    positive,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    rec,
    scalar,
    schur,
    standing,
    symbols,
    symmetric_matrix,
    vector,
    when,
)
from proofs.d71.notation import H, M, P, Phi, V, gain, gram, i, j, k, kronecker, n, p, step

q, r, K, D, E, c, x, v, l, s, e, nd, G, L, N1, N2, F, S, w, m, p0, Pe, P0, Pa, Pb, X, Y, Wk = symbols("q r K D E c x v l s e nd G L N1 N2 F S w m p0 Pe P0 "
                                                                                                      "Pa Pb X Y Wk")
PhiL, Phi1, Phi2, Rg, Rd, Gl, Pw, Pg = symbols("PhiL Phi1 Phi2 Rg Rd Gl Pw Pg")
I = Identity(n)
MODEL = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}
ALONE = 2 + c[i]**2


def diagonal_of(term):
    """The n x n diagonal matrix with this term in i."""
    return matrix_of(i, j, n, n, when(i == j, term, 0))


#: every state by itself, driven and observable, Phi = I
REGULAR = {Phi: I, H: E*diagonal_of((ALONE - 1)*(1 - 1/ALONE))*T(E), M: inv(E), V: I, Pe: E*diagonal_of(ALONE - 1)*T(E)}
RUNS = [rec(P, k, P0, step(P[k])), rec(Pa, k, Zero(n, n), step(Pa[k])), rec(Pb, k, P0 + Pe, step(Pb[k]))]



def above(larger, smaller):
    """The difference of two next covariances as a sum of nonnegative terms."""
    low, gap = gain(smaller), larger - smaller
    extra = gap*T(M)*inv(M*larger*T(M) + V)
    outer = Phi*(I - low*M)
    return [outer*(I - extra*M)*gap*T(I - extra*M)*T(I - low*M)*T(Phi), outer*extra*(M*smaller*T(M) + V)*T(extra)*T(I - low*M)*T(Phi)]


def alone(at):
    """A next covariance as a sum of nonnegative terms."""
    return [Phi*(I - gain(at)*M)*at*T(I - gain(at)*M)*T(Phi), Phi*gain(at)*V*T(gain(at))*T(Phi), H]


claim("D71-E3.195", "between two solutions",
      always(k, psd(Pa[k]) & psd(P[k]) & loewner(P[k], Pa[k]) & loewner(Pb[k], P[k])), sizes=["n", "p"],
      over={**MODEL, P0: positive_semidefinite(n), Pe: positive_semidefinite(n)}, where=RUNS,
      by=[restated("The powers of a matrix with its eigenvalues inside the unit circle tend to zero."),
          induction(base=order([Zero(n, n)], [P0], [P0], [Pe]), step=order(alone(Pa[k]), alone(P[k]), above(P[k], Pa[k]), above(Pb[k], P[k]))),
          steps("D71-T3.4", prose="0 <= P_0 <= P_0 + P_e, and the order of two solutions is kept."), instances(6, n=(1, 2), p=(1, 2), horizon=3)],
      note="P_b starts from P_0 + P_e. That both bounds tend to P_e is parts (a) to (c) of the proof.")

CLOSED = [let(K, Phi*(I - gain(Pe)*M)), rec(Wk, k, P0, K*Wk[k]*T(K))]
claim("D71-T3.24", "global stability of regular processes",
      always(k, loewner(P[k], Pa[k]) & loewner(Pb[k], P[k]) & loewner(Pe + Wk[k], Pb[k]) & loewner(Pb[k], Pe) & loewner(Pe, Pa[k])),
      sizes=["n", "p"], over={**MODEL, P0: positive_semidefinite(n), Pe: positive_semidefinite(n)}, where=[*RUNS, *CLOSED],
      given=[standing("P_e is an equilibrium", Pe == step(Pe)), standing("J is outside the circle, B - P_eD inside", schur(K))],
      by=[steps("D71-T3.4", "D71-E3.182", "D71-E3.190", "D71-E3.193",
                prose="P_k lies between P_a and P_b; P_b - P_e is at most W_k = K^kU_0(K')^k, and P_e - P_a is K^kX_k^{-1}(K')^k with a bounded X_k^{-1}."),
          example(n=1, p=1, Phi=[[2]], H=[[0]], M=[[1]], V=[[1]], P0=[[1]], Pe=[[0]]),
          *(instances(3, n=(size,), p=(size,), horizon=2, using={E: nonsingular(n), c: vector(n)}, made_by=REGULAR) for size in (1, 2))],
      note="Stated: P_k lies between the solutions P_a from 0 and P_b from P_0 + P_e, and P_b between P_e and P_e + K^kP_0(K')^k with a stable K. That such "
           "a P_e exists for the processes of the theorem is Theorem 3.18, and that P_a tends to it is (3.190).")

claim("D71-S16", "regular processes have one equilibrium",
      Pe == X, sizes=["n", "p"], over={**MODEL, Pe: positive_semidefinite(n), X: positive_semidefinite(n)},
      where=[let(K, Phi*(I - gain(Pe)*M)), let(Y, Phi*(I - gain(X)*M))],
      given=[given("P_e is an equilibrium", Pe == step(Pe)), given("X is an equilibrium", X == step(X)), given("B - P_eD is inside the circle", schur(K)),
             given("B - XD is inside the circle", schur(Y))],
      by=[part("uniqueness; the convergence is D71-T3.24"), order(inside=[within(0, unique=(K, T(Y)))]),
          example(n=1, p=1, Phi=[[2]], H=[[0]], M=[[1]], V=[[1]], Pe=[[3]], X=[[0]]),
          example(n=1, p=1, Phi=[[2]], H=[[0]], M=[[1]], V=[[1]], Pe=[[0]], X=[[3]]),
          example(n=1, p=1, Phi=[["1/2"]], H=[[3]], M=[[0]], V=[[1]], Pe=[[4]], X=[[5]]),
          example(n=1, p=1, Phi=[["1/2"]], H=[[3]], M=[[0]], V=[[1]], Pe=[[5]], X=[[4]]),
          *(instances(3, n=(size,), p=(size,), using={E: nonsingular(n), c: vector(n)},
                      made_by={**REGULAR, X: E*diagonal_of(ALONE - 1)*T(E)}) for size in (1, 2))],
      note="For a regular process every nonnegative definite equilibrium has J outside the circle by Theorem 3.17, so B - PD inside: two such equilibria "
           "are equal. Convergence is D71-T3.24.")

# --- ranges ----------------------------------------------------------------------------------------------------------------

REDUCED = {L: matrix(n, q), PhiL: matrix(q, q), Gl: positive_semidefinite(q)}
LIFTED = given("Phi L = L Phi_l", Phi*L == L*PhiL)
claim("D71-S55", "the covariance due to the inputs of the reduced process",
      always(k, Rd[k] == L*Rg[k]*T(L)), sizes=["n", "q"], over={Phi: matrix(n, n), **REDUCED},
      where=[let(H, L*Gl*T(L)), rec(Pw, k, I, Phi*Pw[k]), rec(Rd, k, Zero(n, n), Rd[k] + Pw[k]*H*T(Pw[k])), rec(Pg, k, Identity(q), PhiL*Pg[k]),
             rec(Rg, k, Zero(q, q), Rg[k] + Pg[k]*Gl*T(Pg[k]))], given=[LIFTED],
      by=[part("the equation, not the ranges"), induction(also=[Pw[k]*L == L*Pg[k]]), example(n=1, q=1, Phi=[[2]], L=[[1]], PhiL=[[1]], Gl=[[1]]),
          instances(6, n=(1, 2, 3), q=(1,), horizon=2, using={w: scalar()}, made_by={Phi: w*I, PhiL: w*Identity(q)})],
      note="R_d is Rd_n and R_g is Rg_n, the sum to k = n in place of the size of the reduced process, which has the same range. If R(R_d) contains R(P_e) "
           "= R(L), R_g is nonsingular.")

claim("D71-E3.207", "undriven modes of the reduced process",
      (T(PhiL)*(T(L)*N1) == (T(L)*N1)*Phi1) & (Gl*(T(L)*N1) == Zero(q, r)), sizes=["n", "q", "r"],
      over={Phi: matrix(n, n), **REDUCED, N1: matrix(n, r), Phi1: matrix(r, r)},
      given=[LIFTED, given("Phi'N_1 = N_1 Phi_1", T(Phi)*N1 == N1*Phi1), given("HN_1 = 0", (L*Gl*T(L))*N1 == Zero(n, r)),
             given("independent columns", rank(L) == q)],
      by=[part("the two equations, not the dimensions"), order([], [T(N1)*L*Gl*T(L)*N1]),
          example(n=2, q=1, r=1, Phi=[[1, 0], [0, 2]], L=[[1], [0]], PhiL=[[1]], Gl=[[1]], N1=[[1], [0]], Phi1=[[1]]),
          example(n=2, q=1, r=1, Phi=[[1, 0], [0, 2]], L=[[1], [0]], PhiL=[[1]], Gl=[[0]], N1=[[1], [0]], Phi1=[[2]]),
          example(n=2, q=1, r=1, Phi=[[1, 0], [0, 2]], L=[[1], [0]], PhiL=[[3]], Gl=[[0]], N1=[[1], [0]], Phi1=[[1]]),
          example(n=2, q=1, r=1, Phi=[[1, 0], [0, 2]], L=[[1], [0]], PhiL=[[1]], Gl=[[0]], N1=[[1], [0]], Phi1=[[1]]),
          example(n=2, q=2, r=1, Phi=[[1, 1], [0, 2]], L=[[1, 0], [0, 1]], PhiL=[[1, 1], [0, 2]], Gl=[[1, 1], [1, 1]], N1=[[1], [-1]], Phi1=[[1]]),
          example(n=1, q=2, r=1, Phi=[[1]], L=[[1, -1]], PhiL=[[2, -1], [1, 0]], Gl=[[1, 1], [1, 1]], N1=[[1]], Phi1=[[1]]),
          example(n=1, q=2, r=1, Phi=[[1]], L=[[1, 0]], PhiL=[[1, 0], [0, 2]], Gl=[[0, 0], [0, 1]], N1=[[1]], Phi1=[[1]]),
          example(n=1, q=2, r=1, Phi=[[1]], L=[[1, 1]], PhiL=[[1, 0], [0, 1]], Gl=[[1, -1], [-1, 1]], N1=[[1]], Phi1=[[1]]),
          example(n=2, q=1, r=2, Phi=[[1, 1], [0, 1]], L=[[1], [0]], PhiL=[[1]], Gl=[[0]], N1=[[1, 0], [0, 1]], Phi1=[[1, 0], [1, 1]]),
          example(n=3, q=2, r=1, Phi=[[1, 2, 0], [0, 3, 0], [0, 0, 2]], L=[[1, 0], [0, 1], [0, 0]], PhiL=[[1, 2], [0, 3]], Gl=[[1, 1], [1, 1]],
                  N1=[[1], [-1], [0]], Phi1=[[1]]),
          instances(4, n=(2, 3), q=(1, 2), r=(1,), made_by={Phi: 2*I, PhiL: 2*Identity(q), Phi1: 2*Identity(r), Gl: Zero(q, q)})],
      note="The columns of L'N_1 are independent because those of [N_1, N_2] are and L'N_2 = 0; the count of dimensions that follows is not stated here.")

claim("D71-E3.200", "the range of L is invariant",
      Phi*L == L*(inv(T(L)*L)*T(L)*Phi*L), sizes=["n", "q", "r"], over={Phi: matrix(n, n), L: matrix(n, q), N2: matrix(n, r), Phi2: matrix(r, r)},
      given=[standing("L and N_2 span the space", invertible(hstack(L, N2)) & (n == q + r)), given("orthogonal", T(L)*N2 == Zero(q, r)),
             given("Phi'N_2 = N_2 Phi_2", T(Phi)*N2 == N2*Phi2)],
      by=[example(n=2, q=1, r=1, Phi=[[1, 0], [1, 2]], L=[[1], [1]], N2=[[0], [1]], Phi2=[[2]]),
          example(n=2, q=1, r=1, Phi=[[1, 0], [1, 2]], L=[[1], [0]], N2=[[0], [1]], Phi2=[[2]]),
          example(n=2, q=1, r=1, Phi=[[1, 1], [0, 2]], L=[[1], [1]], N2=[[0], [1]], Phi2=[[2]]),
          example(n=2, q=1, r=1, Phi=[[1, 1], [0, 2]], L=[[1], [0]], N2=[[0], [1]], Phi2=[[2]]),
          example(n=2, q=1, r=1, Phi=[[2, -1], [-1, 2]], L=[[1], [1]], N2=[[1], [-1]], Phi2=[[3]]),
          example(n=2, q=1, r=1, Phi=[[4, -2], [-1, 3]], L=[[1], [1]], N2=[[1], [-1]], Phi2=[[5]]),
          example(n=3, q=2, r=1, Phi=[[1, 2, 0], [3, 4, 0], [5, 6, 7]], L=[[1, 0], [0, 1], [0, 0]], N2=[[0], [0], [1]], Phi2=[[7]]),
          example(n=3, q=2, r=1, Phi=[[1, 2, 3], [3, 4, 5], [0, 0, 7]], L=[[1, 1], [0, 1], [0, 0]], N2=[[0], [0], [1]], Phi2=[[7]]),
          instances(4, n=(2, 3), q=(1, 2), r=(1,), made_by={Phi: 2*I, Phi2: 2*Identity(r)})],
      note="The matrix in brackets is Phi_l, which is printed as some matrix.")

claim("D71-E3.198", "undriven modes of R_d",
      always(k, T(N1)*Pw[k]*H == Zero(r, n)), sizes=["n", "r"], over={Phi: matrix(n, n), H: positive_semidefinite(n), N1: matrix(n, r), Phi1: matrix(r, r)},
      where=[rec(Pw, k, I, Phi*Pw[k])], given=[given("HN = 0", H*N1 == Zero(n, r)), given("Phi'N = N Phi_1", T(Phi)*N1 == N1*Phi1)],
      by=[part("bases of this form annihilate; not that there are such"), induction(), example(n=1, r=1, Phi=[[2]], H=[[1]], N1=[[1]], Phi1=[[2]]),
          example(n=2, r=1, Phi=[[1, 0], [1, 1]], H=[[1, 0], [0, 0]], N1=[[0], [1]], Phi1=[[1]]),
          instances(4, n=(1, 2), r=(1,), made_by={Phi: 2*I, Phi1: 2*Identity(r), H: Zero(n, n)})],
      note="The columns of N_1 and N_2 are in the null space of R_d if H and the products say so: then N'Phi^kH = 0 for every k. That bases of the null "
           "space have this form is Theorem 9.5.")

not_checked("D71-S58", "the reduced equation converges", "Theorem 3.24 for the reduced equation together with (3.206), which are D71-T3.24 and D71-E3.206")

# --- one mode --------------------------------------------------------------------------------------------------------------

NUMBER = T(v)*T(M)*inv(M*P*T(M) + V)*M*v
claim("D71-S56", "the number in the denominator is positive",
      psd(NUMBER) & (M*v == Zero(p, q)) & (Phi*v == v*l), sizes=["n", "p", "q"],
      over={**MODEL, P: positive_semidefinite(n), v: matrix(n, q), l: matrix(q, q)}, where=[let(K, Phi*(I - gain()*M))],
      given=[given("(B - PD)v = mu v", K*v == v*l), given("the number is zero", NUMBER == Zero(q, q))],
      by=[order([NUMBER], [NUMBER], [], [], lemmas=[inv(M*P*T(M) + V)*M*v == Zero(p, q)]),
          example(n=1, p=1, q=1, Phi=[[2]], H=[[0]], M=[[1]], V=[[1]], P=[[1]], v=[[1]], l=[[1]]),
          example(n=1, p=1, q=1, Phi=[[2]], H=[[0]], M=[[0]], V=[[1]], P=[[1]], v=[[1]], l=[[1]]),
          example(n=1, p=1, q=1, Phi=[[2]], H=[[0]], M=[[0]], V=[[1]], P=[[1]], v=[[1]], l=[[2]]),
          instances(4, n=(1, 2), p=(1,), q=(1, 2), using={w: scalar()}, made_by={M: Zero(p, n), Phi: w*I, l: w*Identity(q)})],
      note="The number v*M'(MPM' + V)^{-1}Mv is not negative, and zero only if Mv = 0 and v is an eigenvector of Phi: an unobservable mode. mu stands on the "
           "right as a matrix: a complex v is two real columns.")

STABLE_K = given("B - PD is inside the circle", schur(K))
TWICE = [T(v)*v, w*T(v)*S*v]
claim("D71-S59", "what a stable B - PD excludes",
      (v == Zero(n, 1)) & (nd == Zero(n, 1)), sizes=["n", "p"],
      over={**MODEL, P: positive_semidefinite(n), v: matrix(n, 1), l: scalar(), w: nonneg(), nd: matrix(n, 1), s: scalar()}, where=[let(K, Phi*(I - gain()*M))],
      given=[given("P is an equilibrium", P == step()), STABLE_K, given("v unobservable", (Phi*v == l*v) & (M*v == Zero(p, 1))),
             given("not stable", l**2 == 1 + w),
             given("n undriven", (T(Phi)*nd == s*nd) & (H*nd == Zero(n, 1))), given("random walk", s**2 == 1)],
      by=[part("real eigenvalues; that P >= 0 is D71-S42"),
          order([T(nd)*P*T(M)*inv(M*P*T(M) + V)*M*P*nd], [], [], TWICE, [T(nd)*nd],
                lemmas=[M*P*nd == Zero(p, 1), T(K)*nd == s*nd, K*v == l*v], inside=[within(3, solutions={S: (T(K), I)}), within(4, solutions={Y: (K, I)})]),
          example(n=1, p=1, Phi=[[1]], H=[["1/2"]], M=[[1]], V=[[1]], P=[[1]], v=[[0]], l=2, w=3, nd=[[1]], s=1),
          example(n=1, p=1, Phi=[[1]], H=[[0]], M=[[1]], V=[[1]], P=[[0]], v=[[0]], l=1, w=0, nd=[[1]], s=1),
          example(n=1, p=1, Phi=[["1/2"]], H=[[0]], M=[[1]], V=[[1]], P=[[0]], v=[[0]], l=1, w=0, nd=[[1]], s="1/2"),
          example(n=1, p=1, Phi=[["1/2"]], H=[[0]], M=[[0]], V=[[1]], P=[[0]], v=[[1]], l="1/2", w=0, nd=[[0]], s=1),
          example(n=1, p=1, Phi=[["1/2"]], H=[[0]], M=[[1]], V=[[1]], P=[[0]], v=[[1]], l=1, w=0, nd=[[0]], s=1),
          example(n=1, p=1, Phi=[[1]], H=[[0]], M=[[1]], V=[[1]], P=[[1]], v=[[0]], l=1, w=0, nd=[[1]], s=1),
          example(n=1, p=1, Phi=[["1/2"]], H=[[3]], M=[[0]], V=[[1]], P=[[4]], v=[[0]], l=1, w=0, nd=[[0]], s=1),
          example(n=1, p=1, Phi=[["1/2"]], H=[[0]], M=[[1]], V=[[1]], P=[[0]], v=[[0]], l=1, w=0, nd=[[1]], s=1),
          instances(4, n=(1, 2), p=(1,), made_by={Phi: I/2, H: Zero(n, n), P: Zero(n, n), v: Zero(n, 1), nd: Zero(n, 1), s: 1, l: 1, w: 0})],
      note="For real eigenvalues: no unobservable mode v at l with l^2 >= 1, and no undriven random walk mode n. That P is nonnegative definite is D71-S42.")

# --- the quadratic functions -----------------------------------------------------------------------------------------------

(DPC,) = symbols("DPC")
claim("D71-E3.217", "the matrix of the first function",
      (inv(DPC) == T(K)) & (F == Y), sizes=["n", "p"], over={**MODEL, P: positive_semidefinite(n)},
      where=[let(K, Phi*(I - gain()*M)), let(DPC, inv(T(Phi))*(gram()*P + I)), let(F, kronecker(K, T(K))), let(Y, kronecker(K, inv(DPC)))],
      by=[instances(6, n=(1, 2), p=(1,))],
      note="F(0) as printed is (3.215) at U = 0, because (DP - C)^{-1} = (B - PD)'. The equation for S has a solution S > 0 exactly if F(0) is inside the "
           "circle, by D71-T1.6; its eigenvalues are the products of two of B - PD.")

claim("D71-E3.219", "no solution with an eigenvalue on the circle",
      x == Zero(n, 1), sizes=["n"], over={F: matrix(n, n), S: symmetric_matrix(n), x: matrix(n, 1), s: scalar()},
      given=[given("(3.217)", S - T(F)*S*F == I), given("an eigenvector of F", F*x == s*x), given("on the circle", s**2 == 1)],
      by=[part("real eigenvalues; not that F(0) has one on the circle"),
          order([T(x)*x]), example(n=1, F=[["1/2"]], S=[["4/3"]], x=[[1]], s="1/2"), example(n=1, F=[["1/2"]], S=[["4/3"]], x=[[1]], s=1),
          example(n=1, F=[[1]], S=[[1]], x=[[1]], s=1),
          instances(4, n=(1, 2), made_by={F: Zero(n, n), S: I, x: Zero(n, 1), s: 1})],
      note="F stands for F(0), and n for the length of mu. For an undriven random walk mode with Phi'n = sn, s = 1 or -1, n is an eigenvector of (B - PD)' "
           "at s, and n x n one of the product. What is proposed instead is a definition; see D71-Q5.b.")

# --- a random walk, undriven -----------------------------------------------------------------------------------------------

claim("D71-Q4.a", "an undriven observable random walk mode",
      always(k, x[k]*(v + k*m**2*p0) == p0*v), over={m: nonzero(), v: positive(), p0: scalar()}, where=[rec(x, k, p0, x[k]*v/(m**2*x[k] + v))],
      by=[part("one state"), instances(12, horizon=5)],
      note="For one state, h = 0, Phi = 1 or -1: from p_0 >= 0 the solution tends to the only equilibrium 0; a negative p_0, however near, makes v + "
           "km^2p_0 change its sign, and the solution is below p_0 until then. For more states it is a conjecture of the thesis.")
