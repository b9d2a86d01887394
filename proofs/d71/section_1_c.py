# SPDX-License-Identifier: MIT
"""Modes of a linear system (Chapter I, section C).

If AT = T Lambda with a block diagonal Lambda, T is cut into blocks of columns T_i and its
inverse into blocks of rows, which are called S_i'. Then S_i'T_j is the identity or zero, the
T_iS_i' are the projections that belong to the direct sum of the ranges of the T_i, and
A T_iS_i' = T_i Lambda_i S_i'.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, induction, instances, order, restated
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    eq,
    hstack,
    inv,
    let,
    matrix,
    nonsingular,
    positive_semidefinite,
    rec,
    size_of,
    symbols,
    vstack,
)

q, r, TT, L1, L2, T1, T2, S1, S2, x, A = symbols("q r TT L1 L2 T1 T2 S1 S2 x A")
N = q + r
PARTS = [let(TT, hstack(T1, T2)), let(S1, T(hstack(Identity(q), Zero(q, r))*inv(TT))), let(S2, T(hstack(Zero(r, q), Identity(r))*inv(TT)))]
BLOCKS = {T1: matrix(N, q), T2: matrix(N, r)}
SPLIT = {"sizes": ["q", "r"], "over": BLOCKS, "where": PARTS}
SIZES = {"q": (1, 2), "r": (1, 2)}

claim("D71-E1.56", "the parts of the inverse of T",
      (inv(TT) == vstack(T(S1), T(S2))) & (size_of(S1) == q), **SPLIT,
      by=[example(q=1, r=1, T1=[[1], [0]], T2=[[0], [1]]), instances(q=1, r=1)],
      repair=repair("other", "S_i' is the p_i-by-n part of the inverse of T, and S_i is n-by-p_i",
                    (inv(TT) == vstack(T(S1), T(S2))) & (size_of(S1) == N) & (size_of(T(S1)) == q), **SPLIT, by=[order(), instances(**SIZES)]),
      note="Two blocks, of sizes q and r with n = q + r. Read as printed, S_i is called p_i-by-n, while the inverse of T is made of the rows S_i'.")

claim("D71-E1.60", "the state as the sum of its modes",
      eq(x, T1*(T(S1)*x) + T2*(T(S2)*x), T1*T(S1)*x + T2*T(S2)*x),
      sizes=["q", "r"], over={**BLOCKS, x: matrix(N, 1)}, where=PARTS,
      by=[order(), restated("a matrix cut into more blocks is one cut into two, again and again"), instances(**SIZES)],
      note="zeta_i = S_i'x and xi_i = T_i zeta_i, for two blocks.")

claim("D71-E1.62", "a mode gives its coordinates back",
      eq(T(S1)*x, T(S1)*T1*T(S1)*x, T(S1)*(T1*T(S1)*x)),
      sizes=["q", "r"], over={**BLOCKS, x: matrix(N, 1)}, where=PARTS, by=[order(), instances(**SIZES)])

claim("D71-S2", "the projections on the modes",
      (T1*T(S1)*T1 == T1) & (T1*T(S1)*T2 == Zero(N, r)) & (T1*T(S1) + T2*T(S2) == Identity(N)), **SPLIT,
      by=[order(), instances(**SIZES)],
      note="T_1S_1' is the identity on the range of T_1 and zero on that of T_2.")

claim("D71-E1.63", "the equation of a mode",
      (T1*T(S1)*A == T1*L1*T(S1)) & (T1*L1*T(S1)*(T1*T(S1)) == T1*L1*T(S1)),
      sizes=["q", "r"], over={**BLOCKS, L1: matrix(q, q), L2: matrix(r, r)},
      where=[*PARTS, let(A, TT*block([[L1, Zero(q, r)], [Zero(r, q), L2]])*inv(TT))], by=[order(), instances(**SIZES)],
      note="T_iS_i' times dx/dt = Ax + Gu, with xi_i = T_iS_i'x: the right side is T_i Lambda_i S_i' xi_i + T_iS_i'Gu.")

# --- in coordinates, and in discrete time ----------------------------------------------------------------------------------

w, u, G, h, Lam, Phi, H, n, p, k = symbols("w u G h Lam Phi H n p k")
Rd, Pw, Cov = symbols("Rd Pw Cov")

claim("D71-E1.52", "the system in new coordinates",
      inv(TT)*(A*x + G*u) == Lam*w + inv(TT)*G*u,
      sizes=["n", "p"], over={A: matrix(n, n), TT: nonsingular(n), w: matrix(n, 1), G: matrix(n, p), u: matrix(p, 1)},
      where=[let(Lam, inv(TT)*A*TT), let(x, TT*w)], by=[order(), instances(6, n=(1, 2), p=(1, 2))],
      note="The left side is the derivative of w = T^{-1}x; at t_0 it is T^{-1}x(t_0).")

not_checked("D71-E1.54", "the Jordan form", "a classical form of matrices, quoted to fix notation")

JORDAN = let(A, TT*block([[L1, Zero(q, r)], [Zero(r, q), L2]])*inv(TT))
claim("D71-E1.61", "the equation of the coordinates of a mode",
      T(S1)*(A*x + h) == L1*(T(S1)*x) + T(S1)*h,
      sizes=["q", "r"], over={**BLOCKS, L1: matrix(q, q), L2: matrix(r, r), x: matrix(N, 1), h: matrix(N, 1)}, where=[*PARTS, JORDAN],
      by=[order(), instances(6, **SIZES)], note="Two blocks; h stands for Gu.")

not_checked("D71-E1.68", "completely driven and completely observable modes in continuous time", "a definition: it fixes notation and asserts nothing")

claim("D71-E1.70", "modes in discrete time",
      (T(S1)*(A*x + h) == L1*(T(S1)*x) + T(S1)*h) & (T1*T(S1)*(A*x + h) == T1*L1*T(S1)*(T1*T(S1)*x) + T1*T(S1)*h)
      & (inv(TT)*(A*x + h) == block([[L1, Zero(q, r)], [Zero(r, q), L2]])*(inv(TT)*x) + inv(TT)*h),
      sizes=["q", "r"], over={**BLOCKS, L1: matrix(q, q), L2: matrix(r, r), x: matrix(N, 1), h: matrix(N, 1)}, where=[*PARTS, JORDAN],
      by=[order(), instances(6, **SIZES)], note="Two blocks; A stands for Phi. On the left Phi x + h is the next state.")

claim("D71-E1.73", "the covariance due to the inputs",
      always(k, Cov[k] == Rd[k]), sizes=["n"], over={Phi: matrix(n, n), H: positive_semidefinite(n)},
      where=[rec(Pw, k, Identity(n), Phi*Pw[k]), rec(Rd, k, Zero(n, n), Rd[k] + Pw[k]*H*T(Pw[k])), rec(Cov, k, Zero(n, n), Phi*Cov[k]*T(Phi) + H)],
      by=[induction(also=[Phi*Rd[k]*T(Phi) + H == Rd[k] + Pw[k]*H*T(Pw[k])]), instances(6, n=(1, 2, 3), horizon=3)],
      note="R_d is Rd_n. On the left stands the covariance of a state that starts from zero, on the right the sum of the Phi^i H(Phi')^i for i < k.")

not_checked("D71-S3", "completely observable modes in discrete time", "a definition: it fixes notation and asserts nothing")
