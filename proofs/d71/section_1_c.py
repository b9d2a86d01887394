# SPDX-License-Identifier: MIT
"""Modes of a linear system (Chapter I, section C).

If AT = T Lambda with a block diagonal Lambda, T is cut into blocks of columns T_i and its
inverse into blocks of rows, which are called S_i'. Then S_i'T_j is the identity or zero, the
T_iS_i' are the projections that belong to the direct sum of the ranges of the T_i, and
A T_iS_i' = T_i Lambda_i S_i'.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, instances
from exactkf.language import Identity, T, Zero, diag, eq, inv, let, matrix, matrix_of, nonsingular, size_of, symbols, vstack
from proofs.d71.notation import i, j, n

q, TT, L1, L2, T1, T2, S1, S2, x, A = symbols("q TT L1 L2 T1 T2 S1 S2 x A")
REST = n - q
PARTS = [let(T1, matrix_of(i, j, n, q, TT[i, j])), let(T2, matrix_of(i, j, n, REST, TT[i, j + q])),
         let(S1, matrix_of(i, j, n, q, inv(TT)[j, i])), let(S2, matrix_of(i, j, n, REST, inv(TT)[j + q, i])),
         let(A, TT*diag(L1, L2)*inv(TT))]
WHOLE = {TT: nonsingular(n), L1: matrix(q, q), L2: matrix(REST, REST), x: matrix(n, 1)}

claim("D71-E1.56", "the parts of the inverse of T",
      (inv(TT) == vstack(T(S1), T(S2))) & (size_of(S1) == q),
      sizes=["n", "q"], over={TT: nonsingular(n)}, where=PARTS[:4],
      by=[example(n=2, q=1, TT=[[1, 0], [0, 1]]), instances(n=(1,), q=(1,))],
      repair=repair("other", "S_i' is the p_i-by-n part of the inverse of T, and S_i is n-by-p_i",
                    (inv(TT) == vstack(T(S1), T(S2))) & (size_of(S1) == n) & (size_of(T(S1)) == q),
                    sizes=["n", "q"], over={TT: nonsingular(n)}, where=PARTS[:4], by=[instances(n=(1, 2, 3), q=(1, 2))]),
      note="Two blocks, of sizes q and n - q. Read as printed, S_i is called p_i-by-n, while the inverse of T is made of the rows S_i'.")

claim("D71-E1.60", "the state as the sum of its modes",
      eq(x, T1*(T(S1)*x) + T2*(T(S2)*x), T1*T(S1)*x + T2*T(S2)*x),
      sizes=["n", "q"], over={TT: nonsingular(n), x: matrix(n, 1)}, where=PARTS[:4], by=[instances(n=(2, 3), q=(1, 2))],
      note="zeta_i = S_i'x and xi_i = T_i zeta_i, for two blocks.")

claim("D71-E1.62", "a mode gives its coordinates back",
      eq(T(S1)*x, T(S1)*T1*T(S1)*x, T(S1)*(T1*T(S1)*x)),
      sizes=["n", "q"], over={TT: nonsingular(n), x: matrix(n, 1)}, where=PARTS[:4], by=[instances(n=(2, 3), q=(1, 2))])

claim("D71-S2", "the projections on the modes",
      (T1*T(S1)*T1 == T1) & (T1*T(S1)*T2 == Zero(n, REST)) & (T1*T(S1) + T2*T(S2) == Identity(n)),
      sizes=["n", "q"], over={TT: nonsingular(n)}, where=PARTS[:4], by=[instances(n=(2, 3), q=(1, 2))],
      note="T_1S_1' is the identity on the range of T_1 and zero on that of T_2.")

claim("D71-E1.63", "the equation of a mode",
      (T1*T(S1)*A == T1*L1*T(S1)) & (T1*L1*T(S1)*(T1*T(S1)) == T1*L1*T(S1)),
      sizes=["n", "q"], over=WHOLE, where=PARTS, by=[instances(n=(2, 3), q=(1, 2))],
      note="T_iS_i' times dx/dt = Ax + Gu, with xi_i = T_iS_i'x: the right side is T_i Lambda_i S_i' xi_i + T_iS_i'Gu.")
