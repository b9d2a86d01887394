# SPDX-License-Identifier: MIT
"""Example 3.1: a derogatory R_p with a two-parameter family of equilibria (Chapter III, section C.3.c).

The process has the eigenvalues 2 and 1/2. The eigenvector (3, -2) of Phi' at 2 is a
null vector of H, so the unstable mode is undriven; the eigenvector (2, 3) of Phi at
1/2 is a null vector of M, so the stable mode is unobservable. Since 2 and 1/2 are
reciprocal, R_p has each of them twice, in blocks of size one: it is derogatory.

Write c1, c2 for the eigenvectors of R_p at 2 and c3, c4 for those at 1/2. With
J = diag(2, 2) the columns of T span the eigenspace at 2, and there is one
equilibrium. With J = diag(2, 1/2) the columns are s c1 + t c2 and u c3 + w c4; the
lower part is nonsingular if u(s + 2t) != 0, and P depends on x = w/u and
y = 9t/(s + 2t): a family. It is symmetric exactly for x = y. With J = diag(1/2, 1/2)
the lower part is singular.
"""

from exactkf.claims import claim
from exactkf.evidence import evaluation, identity, instances
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    bottom,
    charpoly,
    det,
    diag,
    inv,
    invertible,
    let,
    nonzero,
    psd,
    rank,
    rational,
    rows,
    scalar,
    similar,
    symbols,
    top,
    trace,
)
from proofs.d71.notation import H, M, P, Phi, V, gram, r_matrix, step

S, Rp, E, TT, F, Gam, Q = symbols("S Rp E TT F Gam Q")
x, y, s, t, u, w = symbols("x y s t u w")
half, third = rational("1/2"), rational("1/3")

DATA = [
    let(Phi, rows([[2, -1], [0, half]])), let(H, rows([[4, 6], [6, 9]])), let(M, rows([[-1, rational("2/3")]])),
    let(V, rows([[1]])),
    let(S, gram()),
]
R_PRINTED = rows([[2, -1, 8, 12], [0, half, 12, 18], [half, -third, half, 0], [-third, rational("2/9"), 1, 2]])
E_PRINTED = rows([[8, 25, 0, 2], [12, 24, 0, 3], [0, 3, 3, 0], [1, 0, -2, 0]])
R_AND_E = [let(Rp, R_PRINTED), let(E, E_PRINTED)]
PARTS = [let(F, top(TT, 2)), let(Gam, bottom(TT, 2)), let(P, F*inv(Gam))]
I4 = Identity(4)

claim("D71-X3.1", "modes of the process",
      (charpoly(Phi) == (Z - 2)*(Z - half))
      & (T(Phi)*rows([[3], [-2]]) == 2*rows([[3], [-2]])) & (H*rows([[3], [-2]]) == Zero(2, 1))
      & (Phi*rows([[1], [0]]) == 2*rows([[1], [0]])) & (M*rows([[1], [0]]) == -1)
      & (Phi*rows([[2], [3]]) == half*rows([[2], [3]])) & (M*rows([[2], [3]]) == 0)
      & (T(Phi)*rows([[0], [1]]) == half*rows([[0], [1]])) & (H*rows([[0], [1]]) == rows([[6], [9]])),
      where=DATA, by=[evaluation()],
      note="By the tests of Appendix C: a mode is undriven if an eigenvector of Phi' is a null vector of H, "
           "unobservable if one of Phi is a null vector of M.")

claim("D71-E3.110", "the matrix R_p of the example",
      r_matrix(H*inv(T(Phi)), H*inv(T(Phi))*S + Phi, -inv(T(Phi)), inv(T(Phi))*S) == R_PRINTED,
      where=DATA, by=[evaluation()])

claim("D71-E3.111", "its Jordan form",
      similar(Rp, diag(2, 2, half, half)) & ((Rp - 2*I4)*(Rp - half*I4) == Zero(4, 4)) & (trace(Rp) == 5),
      where=R_AND_E, by=[evaluation()])

claim("D71-E3.112", "its eigenvectors",
      (Rp*E == E*diag(2, 2, half, half)) & invertible(E) & (rank(Rp - 2*I4) == 2) & (rank(Rp - half*I4) == 2),
      where=R_AND_E, by=[evaluation()],
      note="Both eigenspaces have dimension two, so R_p is derogatory. A J that belongs to independent columns has, "
           "by Theorem 3.7, blocks of "
           "size one at 2 and 1/2: diag(2, 2), diag(2, 1/2) or diag(1/2, 1/2).")

claim("D71-E3.113", "the equilibrium of J = diag(2, 2)",
      (Rp*TT == TT*diag(2, 2)) & (rank(TT) == 2) & (rank(Rp - 2*I4) == 2)
      & (P == rows([[rational("25/3"), 8], [8, 12]])) & (P == step()) & psd(P),
      where=[*DATA, *R_AND_E, let(TT, E*rows([[1, 0], [0, 1], [0, 0], [0, 0]])), *PARTS], by=[evaluation()],
      note="The eigenspace at 2 has dimension two, so the columns of every T span it: one equilibrium.")

FAMILY = (rows([[rational("16/3"), 8], [8, 12]]) + x*rows([[rational("2/3"), 0],
                                                           [1, 0]]) + y*rows([[rational("2/3"), 1], [0, 0]])
          - rational("1/9")*x*y*rows([[rational("4/3"), 2], [2, 3]]))

claim("D71-E3.114", "the family of J = diag(2, 1/2)",
      (Rp*TT == TT*diag(2, half)) & (P == FAMILY) & (P == step()),
      over={s: scalar(), t: scalar(), u: nonzero(), w: scalar()},
      where=[*DATA, *R_AND_E, let(TT, E*rows([[s, 0], [t, 0], [0, u], [0, w]])), *PARTS, let(x, w/u),
             let(y, 9*t/(s + 2*t))],
      by=[identity(), instances()],
      note="The columns of T are the general eigenvectors s c1 + t c2 and u c3 + w c4, so this is every solution; x "
           "and y take all values.")

SYMMETRIC = rows([[rational("16/3") + rational("4/3")*x - rational("4/27")*x**2, 8 + x - rational("2/9")*x**2],
                  [8 + x - rational("2/9")*x**2, 12 - third*x**2]])

claim("D71-E3.115", "its symmetric members",
      (P - T(P) == (y - x)*rows([[0, 1], [-1, 0]]))
      & (P - SYMMETRIC == (y - x)*rows([[rational("2/3") - rational("4/27")*x, 1 - rational("2/9")*x],
                                                                                       [-rational("2/9")*x,
                                                                                        -third*x]])),
      over={x: scalar(), y: scalar()}, where=[let(P, FAMILY)],
      by=[identity(), instances()],
      note="Symmetric exactly for y = x, and then the printed matrix. The condition of Theorems 3.15 and 3.16 fails: "
           "2 * 1/2 = 1 while the "
           "blocks of J and R_p all have size one.")

claim("D71-E3.116", "the matrix Q of the symmetric members",
      (Rp*TT == TT*diag(2, half)) & (F*inv(Gam) == SYMMETRIC) & (T(Gam)*F == rows([[27*(36 + x**2), 27*x], [27*x, 0]])),
      over={x: scalar()},
      where=[*R_AND_E, let(TT, E*rows([[9 - 2*x, 0], [x, 0], [0, 1], [0, x]])), let(F, top(TT, 2)),
             let(Gam, bottom(TT, 2))],
      by=[identity(), instances()],
      note="Q = Gamma'F depends on the lengths of the columns of T; these are (9 - 2x)c1 + x c2 and c3 + x c4.")

claim("D71-S40", "no equilibrium for J = diag(1/2, 1/2)",
      (Rp*TT == TT*diag(half, half)) & (rank(TT) == 2) & (rank(Rp - half*I4) == 2) & (det(bottom(TT, 2)) == 0),
      where=[*R_AND_E, let(TT, E*rows([[0, 0], [0, 0], [1, 0], [0, 1]]))], by=[evaluation()],
      note="The eigenspace at 1/2 has dimension two, so the columns of every T span it, and the lower part is "
           "singular.")
