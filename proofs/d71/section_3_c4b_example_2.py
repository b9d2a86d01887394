# SPDX-License-Identifier: MIT
"""Example 3.2: an undriven random walk mode of two dimensions (Chapter III, section C.4.b).

Phi has the single eigenvalue 1 with one Jordan block, nothing is driven, and the measurement
sees the mode. In the coordinates U = TXT' the equation becomes X+ = Lambda X[I + ee'X]^{-1}Lambda'
with e = (1, 1), as MT = e'. Started at X_0 = diag(0, a) the solution has rank one:
X_k = (a/N_k)(k, 1)'(k, 1) with N_k = 1 + a(1 + 4 + ... + k^2). So x_22 = a/N_k falls from the
first step on, while x_11 = a k^2/N_k rises until N_k has grown too large.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import evaluation, example, identity, instances, order, part
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    charpoly,
    forall,
    function,
    iff,
    inv,
    let,
    matrix,
    matrix_of,
    nonneg,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    rational,
    rec,
    rows,
    substitute,
    sym,
    symbols,
    symmetric_matrix,
    vstack,
)
from proofs.d71.notation import H, K, M, P, Phi, V, gain, gram, i, j, k, step

TT, Lam, S, X, U, a = symbols("TT Lam S X U a")
third = rational("1/3")
DATA = [let(Phi, rows([[-1, 4*third], [-3, 3]])), let(TT, rows([[2, -1], [3, 0]])), let(Lam, rows([[1, 1], [0, 1]])), let(H, Zero(2, 2)),
        let(M, rows([[-1, 1]])), let(V, rows([[1]])), let(S, gram())]
I2 = Identity(2)
DIRECTIONS = [rows([[4, 6], [6, 9]]), rows([[-2, 0], [-3, 0]]), rows([[-2, -3], [0, 0]]), rows([[1, 0], [0, 0]])]

claim("D71-E3.220", "the process of the example",
      (Phi == TT*Lam*inv(TT)) & ((Phi - I2)*(Phi - I2) == Zero(2, 2)) & (rank(Phi - I2) == 1) & (M*(TT*rows([[1], [0]])) == 1),
      where=DATA, by=[evaluation()],
      note="The only eigenvector, (2, 3), is no null vector of M, so the mode is observable; with H = 0 it is undriven.")

claim("D71-E3.224", "U in the coordinates X",
      TT*X*T(TT) == X[1, 1]*DIRECTIONS[0] + X[1, 2]*DIRECTIONS[1] + X[2, 1]*DIRECTIONS[2] + X[2, 2]*DIRECTIONS[3],
      over={X: matrix(2, 2)}, where=DATA, by=[identity(), instances()],
      note="The prime on the last T of (3.222) is read into the scan.")

ENTRIES = X[1, 1] + X[1, 2] + X[2, 1] + X[2, 2]

claim("D71-E3.225", "the equation in the coordinates X",
      Lam*X*inv(I2 + T(TT)*S*TT*X)*T(Lam) == (1/(1 + ENTRIES))*rows([[ENTRIES, X[1, 2] + X[2, 2]],
                                                                    [X[2, 1] + X[2, 2], X[2, 2] + (X[1, 1]*X[2, 2] - X[1, 2]*X[2, 1])]]),
      over={X: matrix(2, 2)}, where=DATA, by=[identity(), instances()])

XA, XB = symbols("XA XB")


def run(name, start):
    """X_k from diag(0, start)."""
    return rec(name, k, rows([[0, 0], [0, start]]), Lam*name[k]*inv(I2 + T(TT)*S*TT*name[k])*T(Lam))


BOTH_RUNS = [*DATA, run(XA, rational("1/100")), run(XB, rational("1/10"))]


def grows(name, at, row, column):
    """An entry that is larger one step later."""
    return name[at + 1][row, column] > name[at][row, column]


def all_grow(name):
    """All entries of X, and those of U = TXT', from the first to the fifth sample."""
    later, now = TT*name[k + 1]*T(TT), TT*name[k]*T(TT)
    cells = [(1, 1), (1, 2), (2, 1), (2, 2)]
    each = [grows(name, k, row, column) & (later[row, column] > now[row, column]) for row, column in cells]
    return forall(k, 0, 3, each[0] & each[1] & each[2] & each[3])


claim("D71-F3.6a", "how long the elements grow",
      all_grow(XA) & all_grow(XB), where=BOTH_RUNS, by=[evaluation()],
      repair=repair(
          "other", "x_22 falls from the first step on; x_11, and with it the largest element 9x_11 of U_k, grows up to the sample k = 8 for a = 0.01 and k = "
                   "4 for a = 0.1",
          forall(k, 0, 7, grows(XA, k, 1, 1)) & (XA[9][1, 1] < XA[8][1, 1]) & forall(k, 0, 3, grows(XB, k, 1, 1)) & (XB[5][1, 1] < XB[4][1, 1])
          & forall(k, 0, 9, (XA[k + 1][2, 2] < XA[k][2, 2]) & (XB[k + 1][2, 2] < XB[k][2, 2])),
          where=BOTH_RUNS, by=[evaluation()]),
      note="XA and XB are the solutions for a = 0.01 and a = 0.1. Already between the first two samples x_22 falls from a to a/(1 + a), whatever a is.")

# --- the equation and its solution ---------------------------------------------------------------------------------------

QUIET = [let(P, Zero(2, 2)), let(U, TT*X*T(TT))]

claim("D71-E3.221", "the deviation, and its coordinates",
      (step(P + U) == Phi*U*inv(I2 + S*U)*T(Phi)) & (step(P + U) == TT*(Lam*X*inv(I2 + T(TT)*S*TT*X)*T(Lam))*T(TT)),
      over={X: matrix(2, 2)}, where=[*DATA, *QUIET], by=[identity(), instances()],
      note="With P_e = 0. The primes on the last Phi of (3.221) and on the last T of (3.222) are read into the scan; without the latter U_k would not be "
           "symmetric.")

claim("D71-S60", "the equilibrium of the example",
      (step(P) == P) & (Phi*(I2 - gain(P)*M) == Phi),
      where=[*DATA, let(P, Zero(2, 2))], by=[part("0 is an equilibrium; not that it is the only one"), evaluation()],
      note="B - PD is Phi at P = 0, and DP - C its inverse transposed. That there is no other equilibrium is not stated here.")

FOUR = sym("FOUR")

claim("D71-S62", "when U is nonnegative definite",
      iff(psd(TT*X*T(TT)), FOUR),
      over={X: symmetric_matrix(2)},
      where=[*DATA, let(FOUR, (X[1, 1] >= 0) & (X[2, 2] >= 0) & (ENTRIES >= 0) & (X[1, 1]*X[2, 2] - X[1, 2]*X[2, 1] >= 0))],
      by=[example(X=[[-1, 0], [0, 0]]), example(X=[[0, 0], [0, -1]]), example(X=[[1, 2], [2, 1]]), example(X=[[0, 0], [0, 0]]), example(X=[[1, -1], [-1, 1]]),
          example(X=[[1, -2], [-2, 4]]), example(X=[[1, -2], [-2, 3]]), example(X=[[-1, 0], [0, -1]]), instances()],
      note="FOUR stands for the four conditions; the third follows from the others.")

Ns = sym("N")

claim("D71-E3.227", "the solution from diag(0, a)",
      always(k, (Ns[k]*X[k][1, 1] == a*k**2) & (Ns[k]*X[k][1, 2] == a*k) & (Ns[k]*X[k][2, 1] == a*k) & (Ns[k]*X[k][2, 2] == a)),
      over={a: nonneg()}, where=[*DATA, rec(Ns, k, 1, Ns[k] + a*(k + 1)**2), rec(X, k, rows([[0, 0], [0, a]]), Lam*X[k]*inv(I2 + T(TT)*S*TT*X[k])*T(Lam))],
      by=[instances(12, horizon=5)],
      note="N_k = 1 + a(1 + 4 + ... + k^2), so that x_11 = ak^2/N_k, x_12 = x_21 = ak/N_k and x_22 = a/N_k.")

# --- the solution near zero, and the function of (3.218) -------------------------------------------------------------------

Lin, Y, left, f, gg, v, entries, factored = symbols("Lin Y left f g v entries factored")
WALK = rec(X, k, rows([[0, 0], [0, a]]), Lam*X[k]*inv(I2 + T(TT)*S*TT*X[k])*T(Lam))

claim("D71-X3.2", "the mode of the example",
      (substitute(charpoly(Phi), 1) == 0) & (rank(Phi - I2) == 1) & (rank(vstack(M, M*Phi)) == 2) & (Phi*H*T(Phi) + H == Zero(2, 2)) & (T(Phi)*left == left),
      where=[*DATA, let(left, rows([[3], [-2]]))], by=[evaluation()],
      note="One Jordan block of order two at the eigenvalue 1; observable, as M and M Phi have rank 2; undriven, as H is zero, and (3, -2), the eigenvector "
           "of Phi', is "
           "a null vector of it.")

claim("D71-S61", "the linearized equation is unstable, and yet the solutions come back",
      always(k, (Lin[k]*left == TT*rows([[a*k**2, a*k], [a*k, a]])*T(TT)*left) & (Ns[k]*(TT*X[k]*T(TT))*left == Lin[k]*left)),
      over={a: nonneg(), left: matrix(2, 1)},
      where=[*DATA, WALK, rec(Ns, k, 1, Ns[k] + a*(k + 1)**2), rec(Lin, k, TT*rows([[0, 0], [0, a]])*T(TT), Phi*Lin[k]*T(Phi))],
      by=[part("the solutions from diag(0, a)"), instances(12, horizon=6)],
      note="For the solution from diag(0, a). The linearized one grows like k^2; the solution is that divided by N_k = 1 + a(1 + 4 + ... + k^2), which grows "
           "like k^3, "
           "so it tends to zero. The two matrices are compared by their products with any vector.")

claim("D71-S63", "slightly negative values diverge",
      forall(k, 0, 5, (X[k][1, 1] <= Y[k][1, 1]) & (Y[k][1, 1] <= 0)) & (2*X[6][1, 1] < 3*Y[6][1, 1]),
      where=[*DATA, let(a, rational("-1/200")), WALK, rec(Y, k, rows([[0, 0], [0, a]]), Lam*Y[k]*T(Lam))],
      by=[part("a = -1/200, the first six samples"), evaluation()],
      note="For a = -1/200; Y is the solution of the linearized equation, -k^2/200 in its first entry. The divisor N_k falls from 1 to 109/200 at k = 6.")


claim("D71-E3.233", "the elements of the next covariance",
      (entries == Phi*(I2 - gain()*M)*P*T(Phi*(I2 - gain()*M)) + Phi*gain()*V*T(Phi*gain()) + H) & (factored == entries),
      over={Phi: matrix(2, 2), H: symmetric_matrix(2), M: matrix(1, 2), V: matrix(1, 1), P: symmetric_matrix(2)},
      where=[let(f, Phi*(I2 - gain()*M)), let(gg, Phi*gain()), let(v, V[1, 1]),
             let(entries, matrix_of(i, j, 2, 2, f[i, 1]*P[1, 1]*f[j, 1] + f[i, 1]*P[1, 2]*f[j, 2] + f[i, 2]*P[2, 1]*f[j, 1] + f[i, 2]*P[2, 2]*f[j, 2]
                                    + gg[i]*v*gg[j] + H[i, j])),
             let(factored,
                 matrix_of(i, j, 2, 2, f[i, 1]*(P[1, 1]*f[j, 1] + P[1, 2]*f[j, 2]) + f[i, 2]*(P[2, 1]*f[j, 1] + P[2, 2]*f[j, 2]) + gg[i]*v*gg[j] + H[i, j]))],
      by=[identity(), instances()],
      note="The f_12 in the last product of (3.233) is read as f_i2. Two states and one measurement.")

not_checked("D71-F3.7", "the trace by three algorithms", "curves of a program in the floating point arithmetic of an IBM 360/65, which the text does not "
                                                         "determine")

# --- figure 3.6 ------------------------------------------------------------------------------------------------------------

ROWS = (1, 2)


def product(one, other, size):
    """The Kronecker product."""
    return block([[one[r, c]*other for c in range(1, size + 1)] for r in range(1, size + 1)])


def lyapunov(matrix_, column):
    """mu'S mu for the solution S of S - F'SF = I: the trace of the solution of X - FXF' = mu mu'."""
    square = vstack(*(column[r, 1]*column for r in range(1, 5)))
    return T(vstack(*(rows([[1 if r == c else 0] for c in range(4)]) for r in range(4))))*inv(Identity(16) - product(matrix_, matrix_, 4))*square


def value_along(name, run_, exchanged):
    """The function (3.218) along a solution, with the printed product or the one that moves the stacked columns of U."""
    deviation = TT*run_[k]*T(TT)
    turned = inv(I2 + S*deviation)*T(Phi)
    mu = vstack(*(deviation[r, c] for c in ROWS for r in ROWS))
    return function(name, [k], lyapunov(product(T(turned), Phi, 2) if exchanged else product(Phi, turned, 2), mu)[1, 1])


Va, Vb = symbols("Va Vb")
FALL = forall(k, 0, 5, (Va(k + 1) < Va(k)) & (Vb(k + 1) < Vb(k))) & (Va(0) > Vb(0))

claim("D71-F3.6b", "the function falls along two solutions",
      FALL, where=[*BOTH_RUNS, value_along(Va, XA, False), value_along(Vb, XB, False)], by=[evaluation()],
      repair=repair("order of factors", "(3.219) is to have the F that moves the stacked columns of U, the product of [(DP - C) + DU]^{-1} transposed and B "
                                        "- PD, which "
                                        "(3.215) has in another order; with it the function falls",
                    FALL, where=[*BOTH_RUNS, value_along(Va, XA, True), value_along(Vb, XB, True)], by=[part("the first six samples"), evaluation()]),
      note="For the first six steps from X_0 = diag(0, a), a = 0.01 for Va and 0.1 for Vb. With F as printed in (3.215), Vb grows from the second step on, "
           "from 4850 to "
           "6342, and Va from the sixth on. The initial value grows as a decreases for both.")

STARTS = [*DATA, run(XA, rational("1/1000")), run(XB, rational("1/100")), run(X, rational("1/10"))]
Vc = sym("Vc")
claim("D71-E3.230", "the function does not tend to zero with U",
      (Va(0) > 10*Vb(0)) & (Vb(0) > 10*Vc(0)) & (Vc(0) > 10000),
      where=[*STARTS, value_along(Va, XA, True), value_along(Vb, XB, True), value_along(Vc, X, True)],
      by=[part("three values of a"), evaluation()],
      note="For U_0 = T diag(0, a)T', which tends to zero with a, and a = 0.001, 0.01, 0.1; see D71-F3.6b for the F. The function grows instead of falling; "
           "that it does "
           "so for every a is not shown.")

nn, pp = symbols("n p")
claim("D71-E3.231", "the covariance equation as a sum of nonnegative terms",
      (step() == Phi*((Identity(nn) - K*M)*P*T(Identity(nn) - K*M) + K*V*T(K))*T(Phi) + H)
      & psd(left*P*T(left)) & psd(Phi*K*V*T(K)*T(Phi)) & psd(H),
      sizes=["n", "p"], over={Phi: matrix(nn, nn), H: positive_semidefinite(nn), M: matrix(pp, nn), V: positive_definite(pp), P: positive_semidefinite(nn)},
      where=[let(K, gain()), let(left, Phi*(Identity(nn) - K*M))],
      by=[order([], [left*P*T(left)], [Phi*K*V*T(K)*T(Phi)], [H]), instances(6, n=(1, 2), p=(1, 2))])
