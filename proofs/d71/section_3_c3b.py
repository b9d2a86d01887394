# SPDX-License-Identifier: MIT
"""Eigenvalues and eigenvectors of R_p (Chapter III, section C.3.b).

Let R = R_p and S = M'V^{-1}M. With W = [[0, I], [-I, 0]] the inverse of R' is W R W^{-1},
because R is a product of three symplectic factors. So if [U; L] takes R to its Jordan form
then [L; -U] takes (R')^{-1} to the same form, and turned over this says that the blocks of R
at an eigenvalue are those at its conjugate reciprocal.

A mode is undriven if an eigenvector of Phi' is a null vector of H, unobservable if an
eigenvector of Phi is one of M. Put below or above a zero, such a vector is an eigenvector of
R, from the right for one of the numbers lambda, 1/lambda* and from the left for the other.

On the unit circle these are the only ways to get an eigenvalue: if R[f; g] = omega [f; g]
with |omega| = 1, the lower rows give f*Sf and the upper ones g*Hg, and the sum of the two
vanishes. Both terms are nonnegative, so Mf = 0 and Hg = 0, and what is left of the equations
says that f and g are eigenvectors of Phi and Phi'.

Complex numbers. The matrices here are real of every size, and the transpose stands for the
conjugate transpose. That loses nothing: a complex matrix is a real one of twice the size,
with the conjugate transpose for transpose. An eigenvalue is written as a matrix on the
right: Phi N = N Lam with N = [u, v] and Lam = [[a, b], [-b, a]] says that u + iv is an
eigenvector at a + ib.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import Evidence, example, first, identity, induction, instances, order, restated
from exactkf.language import (
    Expr,
    Identity,
    T,
    Zero,
    block,
    bottom,
    charpoly,
    coeff,
    cospectral,
    det,
    diag,
    forall,
    given,
    hstack,
    iff,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonsingular,
    nonzero,
    positive_definite,
    positive_semidefinite,
    psd,
    rec,
    rows,
    scalar,
    sequence,
    standing,
    sym,
    symbols,
    top,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import H, M, Phi, V, gram, i, j, k, n, p
from proofs.d71.turned_block import TurnedBlock, mu

q, U, L, Om, X, E = symbols("q U L Om X E")
S, Rp, RpInv, G1, G2 = symbols("S Rp RpInv G1 G2")
I = Identity(n)
I2 = Identity(2*n)
PhiT = inv(T(Phi))

MODEL = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}
R_BLOCKS = block([[H*PhiT*S + Phi, H*PhiT], [PhiT*S, PhiT]])
R_WHERE = [let(S, gram()), let(Rp, R_BLOCKS)]
#: the matrix on the left of (3.55)
R_TURNED = block([[PhiT, -PhiT*S], [-H*PhiT, H*PhiT*S + Phi]])

# --- a symmetry of the eigenvectors -------------------------------------------------------------------------------------

ALL_VECTORS = given("(3.54)", Rp*vstack(U, L) == vstack(U, L)*Om)
MAKE_VECTORS = {"using": {E: nonsingular(2*n)},
                "made_by": {U: top(E, n), L: bottom(E, n), Om: inv(E)*R_BLOCKS*E}}
TURNED_OVER = "the inverse of the adjoint of omega I + N is similar to I/omega* + N, D71-T8.2"
INVERSE = given("[U; L] has an inverse", (vstack(U, L)*hstack(G1, G2) == I2) & (hstack(G1, G2)*vstack(U, L) == I2))

claim("D71-T3.9", "[L; -U] takes the inverse of the adjoint of R_p to the same Jordan form",
      (vstack(L, -U)*hstack(G2, -G1) == I2)
      & (RpInv*T(Rp) == I2)
      & (hstack(G2, -G1)*RpInv*vstack(L, -U) == Om),
      sizes=["n", "p"], over={**MODEL, U: matrix(n, 2*n), L: matrix(n, 2*n), Om: matrix(2*n, 2*n), G1: matrix(2*n, n),
                              G2: matrix(2*n, n)},
      where=[*R_WHERE, let(RpInv, R_TURNED)], given=[ALL_VECTORS, INVERSE],
      by=[instances(n=(1, 2), p=(1, 2), using={E: nonsingular(2*n)},
                    made_by={**MAKE_VECTORS["made_by"],
                             G1: matrix_of(i, j, 2*n, n, inv(E)[i, j]), G2: matrix_of(i, j, 2*n, n, inv(E)[i, j + n])})],
      note="[G1, G2] is the inverse of [U; L]; the first equation is the inverse of [L; -U]. That Omega is a Jordan matrix is not used.")

claim("D71-E3.55", "the equation for [L; -U]",
      (R_TURNED*vstack(L, -U) == vstack(L, -U)*Om) & (R_TURNED*T(Rp) == I2),
      sizes=["n", "p"], over={**MODEL, U: matrix(n, 2*n), L: matrix(n, 2*n), Om: matrix(2*n, 2*n)},
      where=R_WHERE, given=[ALL_VECTORS], by=[instances(n=(1, 2), p=(1, 2), **MAKE_VECTORS)],
      note="The columns need not be independent here.")

# --- the blocks at an eigenvalue and at its conjugate reciprocal --------------------------------------------------------

Ui, Li, Oi, Oj = symbols("Ui Li Oi Oj")

X_T = sym("X_T")
BLOCK = TurnedBlock(q, X_T)

claim("D71-E3.56", "left eigenvectors of R_p from right ones",
      (R_TURNED*vstack(Li, -Ui) == vstack(Li, -Ui)*Oi)
      & (hstack(T(Li), -T(Ui))*Rp == inv(T(Oi))*hstack(T(Li), -T(Ui)))
      & (X*hstack(T(Li), -T(Ui))*Rp == Oj*X*hstack(T(Li), -T(Ui)))
      & BLOCK.carries & BLOCK.diagonal & BLOCK.regular,
      sizes=["n", "p", "q"],
      over={**MODEL, Ui: matrix(n, q), Li: matrix(n, q), Oi: nonsingular(q), Oj: matrix(q, q), X: nonsingular(q), mu: nonzero()},
      where=[*R_WHERE, *BLOCK.where, BLOCK.reverse],
      given=[given("the Jordan vectors", Rp*vstack(Ui, Li) == vstack(Ui, Li)*Oi),
             given("the inverse of the adjoint block is similar to a Jordan block", X*inv(T(Oi)) == Oj*X)],
      by=[BLOCK.by,
          *(instances(12, n=(m,), p=(1, 2), q=(2*m,), using={E: nonsingular(q)},
                      made_by={Ui: top(E, n), Li: bottom(E, n), Oi: inv(E)*R_BLOCKS*E, Oj: X*inv(T(Oi))*inv(X)}) for m in (1, 2))],
      note="In (3.57) and (3.58) the matrix is R_p, as in (3.56); the scan, which mixes up these two letters elsewhere, has R_d, which is n x n. That there is an X for "
           "a Jordan block omega I + N of any size q is the rest: mu is the conjugate of omega, and X_T = (mu I + N')X_T(I/mu + N) is nonsingular, by the determinant of "
           "X_T with its columns in reverse order; so X = X_T^{-1} has X((omega I + N)*)^{-1} = (I/mu + N)X. The identities of X_T are rational in mu, which may be complex.")

a, b, c, d, e, l = symbols("a b c d e l")
y, y1 = symbols("y y1")


def quadratic(real, imaginary):
    """(R - real)^2 + imaginary^2, which is singular exactly if real +- i imaginary are eigenvalues."""
    whole = block([[I, Zero(n, n)], [Zero(n, n), I]])
    shifted = Rp - real*whole
    return shifted*shifted + imaginary**2*whole


#: W = [[0, I], [-I, 0]] with R_p W = W (R_p')^{-1}, and its inverse
TURN, TURN_BACK = block([[Zero(n, n), I], [-I, Zero(n, n)]]), block([[Zero(n, n), -I], [I, Zero(n, n)]])

claim("D71-T3.10", "the blocks at an eigenvalue and at its conjugate reciprocal",
      (Rp*TURN == TURN*inv(T(Rp))) & (TURN*TURN_BACK == I2),
      sizes=["n", "p"], over=MODEL, where=R_WHERE,
      by=[restated("Jordan's theorem: matrices are similar exactly if they have the same Jordan blocks", TURNED_OVER),
          example(n=2, p=1, Phi=[["6/5", "8/5"], ["-8/5", "6/5"]], H=[[0, 0], [0, 0]], M=[[1, 2]], V=[[1]]),
          example(n=2, p=1, Phi=[["3/5", "4/5"], ["-4/5", "3/5"]], H=[[0, 0], [0, 0]], M=[[0, 0]], V=[[1]]),
          example(n=2, p=1, Phi=[[1, 1], [0, 1]], H=[[1, 0], [0, 0]], M=[[1, 2]], V=[[1]]),
          instances(n=(1, 2), p=(1, 2))],
      note="So R_p and the inverse of its adjoint are similar. By Jordan's theorem two matrices are so exactly if they have the same Jordan blocks. If "
           "omega I + N are the blocks of R_p at omega, those of the inverse of its adjoint at 1/omega* are similar to I/omega* + N, by D71-T8.2; that R_p "
           "has the same blocks as that inverse is the theorem.")

claim("D71-S33", "the eigenvalues are symmetric in the unit circle",
      cospectral(Rp, inv(T(Rp))) & (det(Rp) == 1),
      sizes=["n", "p"], over=MODEL, where=R_WHERE,
      by=[order([TURN, TURN_BACK], factors=[(Rp, [block([[I, H], [Zero(n, n), I]]), block([[Phi, Zero(n, n)], [Zero(n, n), PhiT]]),
                                                  block([[I, Zero(n, n)], [S, I]])])]),
          instances(n=(1, 2), p=(1, 2))],
      note="The eigenvalues of the inverse of the adjoint are the conjugate reciprocals of those of R_p, so with omega the number 1/omega* is an eigenvalue "
           "as often.")

# --- the exponential function -------------------------------------------------------------------------------------------

A, EXP, alpha, h, Q = symbols("A EXP alpha h Q")
NILPOTENT = [let(A, rows([[0, alpha], [0, 0]])), let(H, rows([[0, 0], [0, h]])), let(Phi, Identity(2) + A),
             let(Q, block([[A, H], [Zero(2, 2), -T(A)]])),
             let(EXP, Identity(4) + Q + Q**2/2 + Q**3/6), let(Rp, block([[Phi, H*inv(T(Phi))], [Zero(2, 2), inv(T(Phi))]]))]

claim("D71-E3.59", "R_p is not the exponential of [[A, H], [S, -A']]",
      (A**2 == Zero(2, 2)) & (Q**4 == Zero(4, 4))
      & (EXP - Rp == block([[Zero(2, 2), rows([[-alpha**2*h/6, alpha*h/2], [alpha*h/2, 0]])], [Zero(2, 2), Zero(2, 2)]])),
      over={alpha: nonzero(), h: nonzero()}, where=NILPOTENT, by=[identity(), instances()],
      note="The case M = 0 with Phi = I + A = e^A, where A^2 = 0: the exponential series ends with the cube, and its sum differs from R_p unless alpha h = 0.")

P1, P2 = symbols("P1 P2")
IDEMPOTENT = {P1: matrix(n, n), P2: matrix(n, n)}
THREE = [given("P1 is idempotent", P1*P1 == P1), given("P2 is idempotent", P2*P2 == P2),
         given("half their sum is idempotent", (P1 + P2)*(P1 + P2) == 2*(P1 + P2))]

claim("D71-S34", "e^{X+Y} = e^X e^Y for matrices that do not commute",
      ((I + (a**2 - 1)/2*(P1 + P2)) == (I + (a - 1)*P1)*(I + (a - 1)*P2)) >> (P1*P2 == P2*P1),
      sizes=["n"], over={**IDEMPOTENT, a: nonzero()}, given=THREE,
      by=[example(n=2, P1=[[0, 0], [0, 1]], P2=[[0, 1], [0, 1]], a=1), instances(n=(1, 2))],
      repair=repair("missing hypothesis",
                    "for one pair the equation may hold by accident, as e^{2 pi i} = 1; if it holds for tX and tY with every t, then X and Y commute",
                    iff((X + L)*(X + L) == X*X + 2*X*L + L*L, X*L == L*X),
                    sizes=["n"], over={X: matrix(n, n), L: matrix(n, n)},
                    by=[restated("e^{t(X+Y)} and e^{tX}e^{tY} agree for every t exactly if their terms do, and they do if X and Y commute"),
                        instances(n=(1, 2, 3)), instances(n=(2, 3), made_by={L: X*X + X})]),
      note="Read as: the equation fails for every pair that does not commute. Take X = sP1 and Y = sP2 with a number s, so that e^X = I + (e^s - 1)P1 for "
           "an idempotent P1, and a = e^s. The matrices are those of the counterexample with s = 2 pi i and a = 1: all three exponentials are I. The repair "
           "compares the terms of second order in t.")

# --- undriven and unobservable modes ------------------------------------------------------------------------------------

Nd, No, N, Lam, Rd, Pd, G, D1, D2 = symbols("Nd No N Lam Rd Pd G D1 D2")
#: Phi with r undriven and with r unobservable modes: block triangular in the basis E
CORNERED = block([[D1, Zero(q, n - q)], [G, D2]])

AUX = {E: nonsingular(n), D1: matrix(q, q), D2: matrix(n - q, n - q), G: matrix(n - q, q), y: matrix(n - q, n - q), y1: matrix(p, n - q)}
#: the first q coordinates are not driven; the second choice: they are not measured
NOT_DRIVEN = {Phi: E*CORNERED*inv(E), H: E*block([[Zero(q, q), Zero(q, n - q)], [Zero(n - q, q), y*T(y)]])*T(E)}
NOT_MEASURED = {Phi: inv(T(E))*T(CORNERED)*T(E), M: hstack(Zero(p, q), y1)*T(E)}
FIRST = matrix_of(i, j, n, q, when(i == j, 1, 0))
t, ch, Up, Down, CombU, CombD, Ed, Eo, Gd, Go = symbols("t ch Up Down CombU CombD Ed Eo Gd Go")


def powers_vanish(sums: Expr, power: Expr, combined: Expr, turn: Expr, half: Expr, rows_: Expr, null: Expr) -> list:
    """Up to the n-th power, which is a combination of those before it, each takes the null vectors of the sum to ones of ``half``."""
    zero, gone = Zero(n, q), Zero(rows_, q)

    def added(at: Expr) -> Expr:
        return T(power[at])*half*power[at] if half is H else T(power[at])*T(half)*half*power[at]

    def last_terms(at: Expr) -> Evidence:
        return order([sums[at], added(at)], [sums[at], added(at)])

    return [first(forall(k, 0, n, psd(sums[k])), base=order([Zero(n, n)]), step=order([sums[k], added(k)])),
            first(forall(k, 0, n - 1, (sums[n - 1 - k]*null == zero) & (half*power[n - 1 - k]*null == gone)),
                  base=last_terms(n - 1), step=last_terms(n - 2 - k)),
            first(forall(k, 0, n - 1, (sums[n - 1 - k] == sums[n - 1 - k]) & (half*power[k]*null == gone))),
            first(forall(k, 0, n, half*combined[k]*null == gone)),
            first(forall(k, 0, n, half*power[n - k]*null == gone)),
            first(forall(k, 0, n, (sums[n - k] == sums[n - k]) & (half*power[k]*null == gone))),
            first(forall(k, 0, n, sums[k]*(turn*null) == zero), also=[power[k]*turn == turn*power[k]]),
            first(sums[n]*(turn*null) == zero)]


UNDRIVEN_SPACE = powers_vanish(Rd, Up, CombU, T(Phi), H, n, Nd)
UNSEEN_SPACE = powers_vanish(Pd, Down, CombD, Phi, M, p, No)
FULL = {Gd: inv(Rd[n]), Nd: Zero(n, q), Ed: Zero(q, n)}, {Go: inv(Pd[n]), No: Zero(n, q), Eo: Zero(q, n)}
BASIS = inv(T(E))*FIRST
SPANNED = ({Nd: BASIS, Gd: inv(Rd[n] + BASIS*T(BASIS)), Ed: inv(T(BASIS)*BASIS)*T(BASIS)},
           {No: BASIS, Go: inv(Pd[n] + BASIS*T(BASIS)), Eo: inv(T(BASIS)*BASIS)*T(BASIS)})
#: one state, driven and observed
LONELY = {"n": 1, "p": 1, "q": 1, "Phi": [[2]], "H": [[1]], "M": [[1]], "ch": [2], "Nd": [[0]], "No": [[0]], "Gd": [[1]], "Go": [[1]], "Ed": [[0]], "Eo": [[0]]}
HAMILTON = {ch: (k, -coeff(charpoly(Phi), k))}

claim("D71-E3.60", "bases of the undriven and of the unobservable subspace",
      (T(Phi)*Nd == Nd*(Ed*T(Phi)*Nd)) & (H*Nd == Zero(n, q)) & (Phi*No == No*(Eo*Phi*No)) & (M*No == Zero(p, q)),
      sizes=["n", "p", "q"],
      over={Phi: matrix(n, n), H: positive_semidefinite(n), M: matrix(p, n), ch: sequence(0, n - 1), Nd: matrix(n, q), No: matrix(n, q), Gd: matrix(n, n),
            Go: matrix(n, n), Ed: matrix(q, n), Eo: matrix(q, n)},
      where=[rec(Up, t, I, T(Phi)*Up[t]), rec(Down, t, I, Phi*Down[t]), rec(Rd, t, Zero(n, n), Rd[t] + T(Up[t])*H*Up[t]),
             rec(Pd, t, Zero(n, n), Pd[t] + T(Down[t])*(T(M)*M)*Down[t]), rec(CombU, t, Zero(n, n), CombU[t] + ch[t]*Up[t]),
             rec(CombD, t, Zero(n, n), CombD[t] + ch[t]*Down[t])],
      given=[standing("theorem of Cayley and Hamilton", (Up[n] == CombU[n]) & (Down[n] == CombD[n])),
             standing("the sums, counted from the end",
                      forall(k, 0, n - 1, (Rd[k + 1] == Rd[k] + T(Up[k])*H*Up[k]) & (Pd[k + 1] == Pd[k] + T(Down[k])*(T(M)*M)*Down[k]))),
             given("null vectors of R_d", Rd[n]*Nd == Zero(n, q)), given("all of them", I - Gd*Rd[n] == Nd*Ed),
             given("null vectors of P_d", Pd[n]*No == Zero(n, q)), given("all of those", I - Go*Pd[n] == No*Eo)],
      by=[induction(before=[*UNDRIVEN_SPACE, *UNSEEN_SPACE]),
          restated("the theorem of Cayley and Hamilton", "every matrix has a generalized inverse"),
          instances(n=(2,), p=(1,), q=(1,), using=AUX, made_by={**NOT_DRIVEN, **HAMILTON, **SPANNED[0], **FULL[1]}),
          instances(n=(2,), p=(1,), q=(1,), using=AUX, made_by={**NOT_MEASURED, **HAMILTON, **FULL[0], **SPANNED[1]}),
          *(example({**LONELY, **change}) for change in ({"Nd": [[1]]}, {"Nd": [[0]], "Gd": [[0]]}, {"No": [[1]]}, {"Go": [[0]]}))],
      note="The columns of N_d and N_0 span the null spaces of R_d = R_n and P_d' = P_n: I - G R_d, with a generalized inverse G, is N_d times a matrix. "
           "Then Lambda_d* and Lambda_0 are the brackets. The powers and sums are those of section I.E; the numbers ch come from the theorem of Cayley and "
           "Hamilton, that the n-th power of Phi is a combination of those before it.")

UNDRIVEN_GIVEN = [given("(3.60)", T(Phi)*N == N*T(Lam)), given("(3.61)", H*N == Zero(n, q))]
UNOBSERVED_GIVEN = [given("(3.62)", Phi*N == N*Lam), given("(3.63)", M*N == Zero(p, q))]
MODE = {**MODEL, N: matrix(n, q), Lam: nonsingular(q)}
Zq = Zero(n, q)
MADE_UNDRIVEN = {"using": AUX, "made_by": {**NOT_DRIVEN, N: inv(T(E))*FIRST, Lam: D1}}
MADE_UNOBSERVED = {"using": AUX, "made_by": {**NOT_MEASURED, N: inv(T(E))*FIRST, Lam: T(D1)}}
SIZES_Q = {"n": (2, 3), "p": (1, 2), "q": (1, 2)}

claim("D71-E3.64", "an undriven mode: right eigenvectors of R_p",
      Rp*vstack(Zq, N) == vstack(Zq, N)*inv(T(Lam)),
      sizes=["n", "p", "q"], over=MODE, where=R_WHERE, given=UNDRIVEN_GIVEN, by=[instances(**SIZES_Q, **MADE_UNDRIVEN)])

claim("D71-E3.65", "an undriven mode: left eigenvectors of R_p",
      hstack(T(N), Zero(q, n))*Rp == Lam*hstack(T(N), Zero(q, n)),
      sizes=["n", "p", "q"], over=MODE, where=R_WHERE, given=UNDRIVEN_GIVEN, by=[instances(**SIZES_Q, **MADE_UNDRIVEN)])

claim("D71-E3.66", "an unobservable mode: right eigenvectors of R_p",
      Rp*vstack(N, Zq) == vstack(N, Zq)*Lam,
      sizes=["n", "p", "q"], over=MODE, where=R_WHERE, given=UNOBSERVED_GIVEN, by=[instances(**SIZES_Q, **MADE_UNOBSERVED)],
      note="The first equals sign of the scan, between R_p and the columns it multiplies, is not read.")

claim("D71-E3.67", "an unobservable mode: left eigenvectors of R_p",
      hstack(Zero(q, n), T(N))*Rp == inv(T(Lam))*hstack(Zero(q, n), T(N)),
      sizes=["n", "p", "q"], over=MODE, where=R_WHERE, given=UNOBSERVED_GIVEN, by=[instances(**SIZES_Q, **MADE_UNOBSERVED)])

PAIR = rows([[a, b], [-b, a]])
u, v, a1, b1, Q1, Q2 = symbols("u v a1 b1 Q1 Q2")
ZERO = Zero(n, 1)
#: u + iv is an eigenvector of Phi' at a - ib and a null vector of H; of Phi at a + ib, and of M
IS_MODE = (T(Phi)*u == a*u + b*v) & (T(Phi)*v == a*v - b*u) & (H*u == ZERO) & (H*v == ZERO)
IS_HIDDEN = (Phi*u == a*u - b*v) & (Phi*v == a*v + b*u) & (M*u == Zero(p, 1)) & (M*v == Zero(p, 1))
U1, U2 = (matrix_of(i, j, n, 1, when(i == k, 1, 0)) for k in (1, 2))
#: a real mode has v = 0
REAL_MODE = {"using": {E: nonsingular(2), d: scalar(), e: scalar(), l: scalar(), y1: matrix(p, 1)}}
RECIPROCAL = {a1: a/(a**2 + b**2), b1: b/(a**2 + b**2)}
MODES = {"n": (2,), "p": (1,)}
NO_MODE = (u == ZERO) & (v == ZERO)

claim("D71-T3.11", "an undriven or unobservable mode gives two eigenvalues of R_p",
      (invertible(Q1) >> NO_MODE) & (invertible(Q2) >> NO_MODE),
      sizes=["n", "p"], over={**MODEL, a: scalar(), b: scalar(), a1: scalar(), b1: scalar(), u: vector(n), v: vector(n)},
      where=[*R_WHERE, let(Q1, quadratic(a, b)), let(Q2, quadratic(a1, b1))],
      given=[given("the conjugate reciprocal", (a*a1 + b*b1 == 1) & (a*b1 == b*a1)), given("undriven or unobservable", IS_MODE | IS_HIDDEN)],
      by=[order(*(2*[[inv(Q1)], [inv(Q1)], [inv(Q2)], [inv(Q2)]])),
          example(n=2, p=1, Phi=[[1, 2], [-2, 1]], H=[[0, 0], [0, 0]], M=[[1, 3]], V=[[2]], a=1, b=2, a1="1/5", b1="2/5", u=[0, -1], v=[1, 0]),
          example(n=2, p=1, Phi=[[1, 2], [-2, 1]], H=[[2, 1], [1, 3]], M=[[0, 0]], V=[[2]], a=1, b=2, a1="1/5", b1="2/5", u=[1, 0], v=[0, 1]),
          example(n=1, p=1, Phi=[[2]], H=[[1]], M=[[1]], V=[[1]], a=2, b=0, a1="1/2", b1=0, u=[0], v=[0]),
          example(n=3, p=1, Phi=[[1, 0, 2], [0, 2, 1], [0, 0, 3]], H=[[1, 2, 0], [2, 4, 0], [0, 0, 0]], M=[[1, 1, 1]], V=[[1]], a=3, b=0, a1="1/3", b1=0,
                  u=[0, 0, 1], v=[0, 0, 0]),
          example(n=2, p=1, Phi=[[1, 0], [0, 5]], H=[[1, 0], [0, 1]], M=[[1, 1]], V=[[1]], a=2, b=0, a1="1/2", b1=0, u=[0, 0], v=[0, 0]),
          instances(6, **MODES, **REAL_MODE,
                    made_by={b: 0, **RECIPROCAL, Phi: E*rows([[a, 0], [e, d]])*inv(E), H: E*rows([[0, 0], [0, l**2]])*T(E), u: inv(T(E))*U1, v: ZERO}),
          instances(6, **MODES, **REAL_MODE,
                    made_by={b: 0, **RECIPROCAL, Phi: E*rows([[a, e], [0, d]])*inv(E), M: hstack(Zero(p, 1), y1)*inv(E), u: E*U1, v: ZERO}),
          instances(3, **MODES, **REAL_MODE, made_by={**RECIPROCAL, Phi: E*PAIR*inv(E), H: Zero(2, 2), u: inv(T(E))*U1, v: inv(T(E))*U2}),
          instances(3, **MODES, **REAL_MODE, made_by={**RECIPROCAL, Phi: E*PAIR*inv(E), M: Zero(p, 2), u: E*U1, v: E*U2})],
      note="lambda = a + ib, and u + iv is its eigenvector. A number a + ib is an eigenvalue of the real matrix R_p exactly if (R_p - a)^2 + b^2 is "
           "singular: so where the eigenvector is not zero both numbers, lambda and 1/lambda* = a1 + i b1, are. lambda is not 0 as Phi is nonsingular.")

# --- eigenvalues on the unit circle -------------------------------------------------------------------------------------

f, g, W = symbols("f g W")
CIRCLE = [given("eigenvector", Rp*vstack(f, g) == vstack(f, g)*W), given("omega* omega = 1", T(W)*W == Identity(q))]
ON_CIRCLE = {**MODEL, f: matrix(n, q), g: matrix(n, q), W: matrix(q, q)}
#: an orthogonal matrix of order two, by Cayley's formula
CAYLEY = rows([[1 - a**2, 2*a], [-2*a, 1 - a**2]])*(1/(1 + a**2))
ROTATED = {"n": (2,), "p": (1, 2), "q": (2,)}
ROT = {"using": {E: nonsingular(2), Q: nonsingular(2), a: scalar(), c: scalar(), d: scalar()}}
#: both f and g not zero: nothing is driven, nothing is measured
STILL = {Phi: CAYLEY, H: Zero(2, 2), M: Zero(p, 2), W: CAYLEY}
TURNS = matrix_of(i, j, 2, 2, when(i == j, c, when(i < j, d, -d)))
TURNS2 = matrix_of(i, j, 2, 2, when(i == j, Q[1, 1], when(i < j, Q[1, 2], -Q[1, 2])))
WAYS = [instances(8, **ROTATED, **ROT, made_by={**STILL, f: TURNS, g: TURNS2}),
        instances(8, **ROTATED, **ROT, made_by={Phi: E*CAYLEY*inv(E), M: Zero(p, 2), W: CAYLEY, f: E*TURNS, g: Zero(2, 2)}),
        instances(8, **ROTATED, **ROT, made_by={Phi: inv(T(E))*CAYLEY*T(E), H: Zero(2, 2), W: CAYLEY, g: inv(T(E))*TURNS, f: Zero(2, 2)})]
#: one real eigenvector: omega = 1 undriven, omega = -1 unobservable
REAL_WAYS = [example(n=1, p=1, q=1, Phi=[[1]], H=[[0]], M=[[2]], V=[[3]], f=[0], g=[1], W=[[1]]),
             example(n=2, p=1, q=1, Phi=[[-1, 0], [0, 2]], H=[[1, 1], [1, 2]], M=[[0, 1]], V=[[1]], f=[1, 0], g=[0, 0], W=[[-1]])]
#: R_p of any data has such an equation with W off the circle
OFF = instances(6, n=(1, 2), p=(1,), q=(2, 4), using={E: nonsingular(q)}, made_by={f: top(E, n), g: bottom(E, n), W: inv(E)*R_BLOCKS*E})

claim("D71-E3.68", "the two halves of the eigenvector equation",
      (Phi*f == (f - H*g)*W) & (S*f == T(Phi)*g*W - g) & (H*g == f - Phi*f*T(W)),
      sizes=["n", "p", "q"], over=ON_CIRCLE, where=R_WHERE, given=CIRCLE,
      by=[*REAL_WAYS, *WAYS, OFF],
      note="omega stands on the right as the matrix W: for f = f1 + i f2 and omega = a + ib that is [f1, f2] and [[a, b], [-b, a]]. |omega| = 1 says "
           "W'W = I; only the last equation needs it.")

HALVES = [given("(3.69)", S*f == T(Phi)*g*W - g), given("(3.70)", H*g == f - Phi*f*T(W))]
FREE = {**MODEL, f: matrix(n, q), g: matrix(n, q), W: matrix(q, q)}

claim("D71-E3.71", "the quadratic forms of M'V^{-1}M and H",
      (T(f)*S*f == T(f)*T(Phi)*g*W - T(f)*g) & (T(g)*H*g == T(f)*g - W*T(f)*T(Phi)*g),
      sizes=["n", "p", "q"], over=FREE, where=R_WHERE, given=HALVES,
      by=[*REAL_WAYS, *WAYS],
      note="The numbers of the print are q x q matrices here, and omega stands on the left in the second equation after transposing. "
           "The scan of (3.72) has V where the step needs Phi', which (3.71) shows.")

NUMBERS = standing("omega and f* Phi' gamma commute, being numbers", T(f)*T(Phi)*g*W == W*T(f)*T(Phi)*g)

claim("D71-E3.73", "both forms vanish",
      ((T(f)*S*f + T(g)*H*g)*Identity(q) == Zero(q, q)) & (M*f == Zero(p, q)) & (H*g == Zero(n, q)),
      sizes=["n", "p", "q"], over=FREE, where=R_WHERE,
      given=[given("(3.71)", T(f)*S*f == T(f)*T(Phi)*g*W - T(f)*g), given("(3.72)", T(g)*H*g == T(f)*g - W*T(f)*T(Phi)*g), NUMBERS],
      by=[order([], [], [T(f)*T(M)*inv(V)*M*f, T(g)*H*g], [T(f)*T(M)*inv(V)*M*f, T(g)*H*g],
                lemmas=[(T(f)*S*f + T(g)*H*g)*Identity(q) == Zero(q, q)]),
          *REAL_WAYS, *WAYS],
      note="The complex case is that of real matrices of twice the size, in which omega is a matrix that commutes with f* Phi' gamma.")

claim("D71-E3.74", "f and gamma are eigenvectors of Phi and its adjoint",
      (T(Phi)*g == g*T(W)) & (Phi*f == f*W),
      sizes=["n", "p", "q"], over=ON_CIRCLE, where=R_WHERE,
      given=[given("omega* omega = 1", T(W)*W == Identity(q)), *HALVES, standing("Mf = 0", M*f == Zero(p, q)), standing("H gamma = 0", H*g == Zero(n, q))],
      by=[*REAL_WAYS, *WAYS, example(n=1, p=1, q=1, Phi=[["1/2"]], H=[[0]], M=[[0]], V=[[1]], f=[1], g=[1], W=[[2]])])

f1, f2, g1, g2, x1, x2, y2 = symbols("f1 f2 g1 g2 x1 x2 y2")


def eigenvector_of_r(f1, f2, g1, g2):
    """R_p [f; g] = omega [f; g] for f = f1 + i f2, g = g1 + i g2 and omega = a + ib."""
    return (Rp*vstack(f1, g1) == vstack(a*f1 - b*f2, a*g1 - b*g2)) & (Rp*vstack(f2, g2) == vstack(b*f1 + a*f2, b*g1 + a*g2))


def pair_of_modes(f1, f2, g1, g2):
    """Phi f = omega f and Mf = 0; Phi' g = omega* g and Hg = 0."""
    return ((Phi*f1 == a*f1 - b*f2) & (Phi*f2 == b*f1 + a*f2) & (M*f1 == Zero(p, 1)) & (M*f2 == Zero(p, 1))
            & (T(Phi)*g1 == a*g1 + b*g2) & (T(Phi)*g2 == a*g2 - b*g1) & (H*g1 == ZERO) & (H*g2 == ZERO))


#: the forms of S and H at f and gamma, whose sum vanishes
BOTH_FORMS = [T(x)*T(M)*inv(V)*M*x for x in (f1, f2)] + [T(x)*H*x for x in (g1, g2)]
HALF_WAY = [S*f1 == T(Phi)*(a*g1 - b*g2) - g1, S*f2 == T(Phi)*(b*g1 + a*g2) - g2,
            H*(a*g1 - b*g2) == a*f1 - b*f2 - Phi*f1, H*(b*g1 + a*g2) == b*f1 + a*f2 - Phi*f2,
            H*g1 == f1 - Phi*(a*f1 + b*f2), H*g2 == f2 - Phi*(a*f2 - b*f1),
            (BOTH_FORMS[0] + BOTH_FORMS[1] + BOTH_FORMS[2] + BOTH_FORMS[3])*Identity(1) == Zero(1, 1),
            M*f1 == Zero(p, 1), M*f2 == Zero(p, 1), H*g1 == ZERO, H*g2 == ZERO]
SPUN = {a: (1 - e**2)/(1 + e**2), b: 2*e/(1 + e**2), Phi: E*PAIR*inv(E)}
F_SPUN, G_SPUN = {f1: E*(c*U1 - d*U2), f2: E*(d*U1 + c*U2)}, {g1: inv(T(E))*(c*U1 - d*U2), g2: inv(T(E))*(d*U1 + c*U2)}
X_SPUN, Y_SPUN = {x1: E*U2, x2: -E*U1}, {y: inv(T(E))*U1, y2: inv(T(E))*U2}
NO_F, NO_G, NO_X, NO_Y = {f1: ZERO, f2: ZERO}, {g1: ZERO, g2: ZERO}, {x1: ZERO, x2: ZERO}, {y: ZERO, y2: ZERO}
SPIN = {"n": (2,), "p": (1, 2), "using": {E: nonsingular(2), c: scalar(), d: scalar(), e: scalar()}}
NOTHING = {"n": 1, "p": 1, "b": 0, **dict.fromkeys(("f1", "f2", "g1", "g2", "x1", "x2", "y", "y2"), [0])}

claim("D71-T3.12", "eigenvalues of R_p on the unit circle",
      pair_of_modes(f1, f2, g1, g2) & eigenvector_of_r(x1, x2, y, y2),
      sizes=["n", "p"],
      over={**MODEL, a: scalar(), b: scalar(), **{vector_: vector(n) for vector_ in (f1, f2, g1, g2, x1, x2, y, y2)}}, where=R_WHERE,
      given=[given("|omega| = 1", a**2 + b**2 == 1), given("an eigenvector of R_p", eigenvector_of_r(f1, f2, g1, g2)),
             given("two modes", pair_of_modes(x1, x2, y, y2))],
      by=[order(*[[] for _ in HALF_WAY[:7]], BOTH_FORMS, BOTH_FORMS, BOTH_FORMS, BOTH_FORMS, lemmas=HALF_WAY),
          example({**NOTHING, "Phi": [["1/2"]], "H": [[0]], "M": [[0]], "V": [[1]], "a": 1, "f1": [1]}),
          example({**NOTHING, "Phi": [["1/2"]], "H": [[0]], "M": [[0]], "V": [[1]], "a": 1, "x1": [1]}),
          example({**NOTHING, "Phi": [[1]], "H": [["1/2"]], "M": [[1]], "V": [[1]], "a": 2, "f1": [1], "g1": [1]}),
          instances(8, **SPIN, made_by={**SPUN, H: Zero(2, 2), M: Zero(p, 2), **F_SPUN, **G_SPUN, **X_SPUN, **Y_SPUN}),
          instances(8, **SPIN, made_by={**SPUN, M: Zero(p, 2), **F_SPUN, **NO_G, **X_SPUN, **NO_Y}),
          instances(8, **SPIN, made_by={**SPUN, H: Zero(2, 2), **NO_F, **G_SPUN, **NO_X, **Y_SPUN})],
      note="Both directions at once, for one omega = a + ib on the circle: every eigenvector [f; gamma] of R_p at omega consists of an unobservable mode f "
           "and an undriven mode gamma (or zero), and any two such modes [x; y] make an eigenvector of R_p. A mode of modulus one is a random walk mode; "
           "Phi' gamma = omega* gamma says that it has the eigenvalue omega*, and omega beside it, as Phi is real.")

K = sym("K")

BOTH_ENDS = block([[K, Zq], [Zq, N]])
MU = inv(T(Lam))
A1, B1, B2 = symbols("A1 B1 B2")
REST = n - 2*q
THIRDS = {"using": {E: nonsingular(n), D1: nonsingular(q), D2: nonsingular(REST), A1: matrix(n - q, n - q), B1: matrix(p, q), B2: matrix(p, REST)},
          "made_by": {Lam: D1, Phi: E*diag(D1, inv(T(D1)), D2)*inv(E), H: E*diag(Zero(q, q), A1*T(A1))*T(E),
                      M: hstack(B1, Zero(p, q), B2)*inv(E),
                      N: inv(T(E))*FIRST, K: E*matrix_of(i, j, n, q, when(i == j + q, 1, 0))}}

claim("D71-S35", "when R_p is derogatory",
      Rp*BOTH_ENDS == BOTH_ENDS*block([[MU, Zero(q, q)], [Zero(q, q), MU]]),
      sizes=["n", "p", "q"], over={**MODE, K: matrix(n, q)}, where=R_WHERE,
      given=[*UNDRIVEN_GIVEN, given("a mode at the conjugate reciprocal", Phi*K == K*inv(T(Lam))), given("it is unobservable", M*K == Zero(p, q))],
      by=[instances(8, n=(2, 3), p=(1, 2), q=(1,), **THIRDS), instances(4, n=(4, 5), p=(1,), q=(2,), **THIRDS)],
      note="The columns [K; 0] and [0; N] are independent eigenvectors at one eigenvalue, so it has two Jordan blocks. With |lambda| = 1 the conjugate "
           "reciprocal is lambda itself. The condition is lambda_i* lambda_j = 1 for the undriven lambda_i; as the modes of a real process come with "
           "their conjugates, lambda_i* lambda_j* = 1 for some pair says the same.")
