# SPDX-License-Identifier: MIT
"""Section IV, beginning: detectability, stabilizability and the stable observer.

The system is detectable if [sE - tA; C] has full column rank wherever
|s| >= |t|, (s, t) not zero. For t = 0 this is full column rank of (E; C); for
other t it is a condition on s/t, with |s/t| >= 1: for E = I the classical one,
which includes the unit circle. The footnote of the paper leaves the circle out.

For E = I and R > 0 a row (v, w) that annihilates the noise [Q, -S; -S', R] has
w = vSR^-1 and v(Q - SR^-1S') = 0, and then v(sI - tA) + swC =
v(s(I + SR^-1C) - tA). Only for S = 0 is this the classical stabilizability of
(A, B), Q = BB'.

A detectable system has a left inverse (L_e L_c) of (E; C) with stable L_e A: in
coordinates with E = [I, 0; 0, E_22], C = (0 C_2), and C_2 of full column rank,
the pair (A_11, A_21) is detectable; with stable A_11 + DA_21 take
L_e = V[I, D; 0, 0]U and L_c = VF, FC_2 = (-DE_22; I). Then
x(k+1) = L_e A x(k) + L_c y(k+1) + L_e u(k) - L_c r(k), and the observer without
the noises has an error whose covariance tends to the solution P_s of a
Lyapunov equation.

Complex numbers are written by real and imaginary parts, s = s1 + is2, and a
complex matrix X + iY by its real form [X, -Y; Y, X], of twice the rank.
"""

from __future__ import annotations

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import EIGENVALUE, EIGENVECTOR, example, induction, instances, order, restated, steps, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    charpoly,
    diag,
    given,
    hstack,
    inv,
    invertible,
    kernel_basis,
    let,
    loewner,
    matrix,
    nonsingular,
    nonzero,
    outside_roots,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    rec,
    scalar,
    schur,
    standing,
    sym,
    symbols,
    symmetric_matrix,
    trace,
    vector,
    vstack,
)
from proofs.nwl92 import notation_system as system
from proofs.nwl92.notation import lower, real_form, upper

DEFINITION = "a definition: it fixes notation and asserts nothing"
l, p, n, m, q, t = symbols("l p n m q t")
A, Q, S, R, E, C, B, D, K = symbols("A Q S R E C B D K")
Le, Lc = system.Le, system.Lc

not_checked("NWL92-E4.1", "the time-invariant dynamics", DEFINITION)
not_checked("NWL92-E4.2", "the time-invariant measurements", DEFINITION)
not_checked("NWL92-E4.3", "the covariance of the noises", DEFINITION)
not_checked("NWL92-D4.1", "detectable and stabilizable", DEFINITION)

# ------------------------------------------------------------------ the footnote
s1, s2, t1, t2, a, b = symbols("s1 s2 t1 t2 a b")
LL, X0, X1 = symbols("L X0 X1")


POINT = {s1: scalar(), s2: scalar(), t1: scalar(), t2: scalar()}
LARGE = given("|s| >= |t|", s1 * s1 + s2 * s2 >= t1 * t1 + t2 * t2)
NOT_BOTH = given("(s, t) is not zero", s1 * s1 + s2 * s2 + t1 * t1 + t2 * t2 > 0)
RATIO = given("s = t(a + ib)", (s1 == t1 * a - t2 * b) & (s2 == t1 * b + t2 * a))
NORM_S, NORM_T = s1 * s1 + s2 * s2, t1 * t1 + t2 * t2
T_NOT_ZERO = given("t is not zero", NORM_T > 0)
AT_ST = real_form(vstack(s1 * Identity(n) - t1 * A, C), vstack(s2 * Identity(n) - t2 * A, Zero(p, n)))
AT_RATIO = real_form(vstack(a * Identity(n) - A, C), vstack(b * Identity(n), Zero(p, n)))
#: diag(tI, I), in real form, and its inverse
TIMES = block([[t1 * Identity(n), Zero(n, p), -(t2 * Identity(n)), Zero(n, p)], [Zero(p, n), Identity(p), Zero(p, n), Zero(p, p)],
               [t2 * Identity(n), Zero(n, p), t1 * Identity(n), Zero(n, p)], [Zero(p, n), Zero(p, p), Zero(p, n), Identity(p)]])
DIVIDE = block([[t1 / NORM_T * Identity(n), Zero(n, p), t2 / NORM_T * Identity(n), Zero(n, p)], [Zero(p, n), Identity(p), Zero(p, n), Zero(p, p)],
                [-(t2 / NORM_T * Identity(n)), Zero(n, p), t1 / NORM_T * Identity(n), Zero(n, p)], [Zero(p, n), Zero(p, p), Zero(p, n), Identity(p)]])
#: the matrix at (s, 0), s = c + id, and a left inverse
c, d = symbols("c d")
T_ZERO = real_form(vstack(c * Identity(n), C), vstack(d * Identity(n), Zero(p, n)))
NORM_C = c * c + d * d
AT_INFINITY = real_form(hstack(c / NORM_C * Identity(n), Zero(n, p)), hstack(-(d / NORM_C) * Identity(n), Zero(n, p)))
MADE_RATIO = {s1: t1 * a - t2 * b, s2: t1 * b + t2 * a}
CLASSICAL = {A: matrix(n, n), C: matrix(p, n)}
claim("NWL92-S22", "for E = I full column rank of (sI - A; C) for |s| > 1 is detectability, as printed",
      rank(AT_ST) == 2 * n, sizes=["n", "p"], over={**CLASSICAL, LL: matrix(n, p), **POINT},
      given=[given("full column rank for |s| > 1", outside_roots(charpoly(A + LL * C)) == 0), LARGE, NOT_BOTH],
      by=[example({"n": 1, "p": 1, A: [[1]], C: [[0]], LL: [[0]], s1: 1, s2: 0, t1: 1, t2: 0}), instances(n=(1, 2), p=(1, 2))],
      repair=repair("boundary case", "|s| = |t| belongs to Definition 4.1, so that the condition must hold for |s| >= 1",
                    (AT_ST == TIMES * AT_RATIO) & (NORM_S == NORM_T * (a * a + b * b)) & (TIMES * DIVIDE == Identity(2 * (n + p)))
                    & (AT_INFINITY * T_ZERO == Identity(2 * n)), sizes=["n", "p"],
                    over={**CLASSICAL, **POINT, a: scalar(), b: scalar(), c: nonzero(), d: scalar()}, given=[T_NOT_ZERO, RATIO],
                    by=[order(), *[example({"n": 1, "p": 1, A: [[0]], C: [[0]], s1: 1, s2: 0, t1: x, t2: 0, a: x, b: 0, c: 1, d: 0}) for x in (0, 2)],
                        instances(made_by=MADE_RATIO, n=(1, 2), p=(1, 2))]),
      note=("Full column rank for |s| > 1 is said by an L for which A + LC has no eigenvalue outside the closed disc: (sI - A)x = 0 and Cx = 0 make s an eigenvalue of "
            "A + LC. The corrected statement: for t other than zero the matrix at (s, t) is diag(tI, I), "
            "which is invertible, times that at s/t = a + ib, and |s| >= |t| is |s/t| >= 1. At (s, 0), s = c + id other than zero, it has a left inverse; c is taken other than zero, else s is multiplied by i."))

v1, v2, w1, w2, B0 = symbols("v1 v2 w1 w2 B0")


def stabilizability(Q, S, R):
    """[sI - tA, Q, -S; sC, -S', R] in real form."""
    return real_form(block([[s1 * Identity(n) - t1 * A, Q, -S], [s1 * C, -T(S), R]]),
                     block([[s2 * Identity(n) - t2 * A, Zero(n, n), Zero(n, p)], [s2 * C, Zero(p, n), Zero(p, p)]]))


CLASSICAL_ST = real_form(hstack(s1 * Identity(n) - t1 * A, B), hstack(s2 * Identity(n) - t2 * A, Zero(n, q)))
ROWS = {v1: matrix(1, n), v2: matrix(1, n), w1: matrix(1, p), w2: matrix(1, p)}
r1, r2 = symbols("r1 r2")
BACK_BLOCK = block([[Identity(n), Zero(n, n), Zero(n, p)], [Zero(q, n), T(B), Zero(q, p)]])
BACK = real_form(BACK_BLOCK, 0 * BACK_BLOCK)
STABILIZABILITY_0, NO_COLUMNS = stabilizability(B * T(B), Zero(n, p), R), Zero(1, n + n + p + n + n + p)
ANNIHILATES = given("(v, w) annihilates the stabilizability matrix", hstack(v1, w1, v2, w2) * STABILIZABILITY_0 == NO_COLUMNS)
#: not admissible: v, w other than zero
S23_ONES = {"n": 1, "p": 1, "q": 1, A: [[1]], C: [[1]], B: [[1]], R: [[1]], s1: 1, s2: 0, t1: 1, t2: 0, v1: [[0]], v2: [[0]], w1: [[0]], w2: [[0]], r1: [[0]], r2: [[0]]}
COMPLEX_V = instances(8, made_by={A: B0 * block([[a, -b], [b, a]]) * inv(B0), v1: T(upper(1, 1)) * inv(B0), v2: -(T(lower(1, 1)) * inv(B0)), B: Zero(n, q),
                                  w1: Zero(1, p), w2: Zero(1, p), **MADE_RATIO}, using={B0: nonsingular(2), a: scalar(), b: scalar()}, n=2, p=1, q=1)
ALONG = Identity(n) - T(v1) * v1 * (1 / (v1 * T(v1)))
REAL_V = instances(8, made_by={A: T(v1) * v1 * (a / (v1 * T(v1))) + ALONG * X0, B: ALONG * X1, v2: b * v1,
                               w1: Zero(1, p), w2: Zero(1, p), s1: t1 * a, s2: t2 * a}, using={X0: matrix(n, n), X1: matrix(n, q), a: scalar(), b: scalar()},
                   n=(2, 3), p=1, q=(1, 2))
claim("NWL92-S23", "for E = I and R > 0 full row rank of (sI - A, B) for |s| > 1 is stabilizability, as printed",
      rank(stabilizability(B * T(B), B * T(D), D * T(D))) == 2 * (n + p), sizes=["n", "p", "q"],
      over={**CLASSICAL, B: matrix(n, q), D: matrix(p, q), K: matrix(q, n), **POINT},
      given=[given("R > 0", invertible(D * T(D))), given("full row rank for |s| > 1", schur(A + B * K)), LARGE, NOT_BOTH],
      by=[example({"n": 1, "p": 1, "q": 1, A: [[2]], C: [[0]], B: [[1]], D: [[1]], K: [[-2]], s1: 2, s2: 0, t1: 1, t2: 0}), instances(n=1, p=1, q=(1, 2))],
      repair=repair("missing hypothesis", ("S must be zero: otherwise what v must annihilate is a factor of Q - SR^-1S', and s(I + SR^-1C) - tA; and the rank must be full for "
                                           "|s| >= 1, as in Definition 4.1"),
                    (hstack(v1, v2) * CLASSICAL_ST == Zero(1, n + q + n + q)) & (w1 == Zero(1, p)) & (w2 == Zero(1, p))
                    & (hstack(r1, Zero(1, p), r2, Zero(1, p)) * STABILIZABILITY_0 == hstack(r1, r2) * CLASSICAL_ST * BACK),
                    sizes=["n", "p", "q"], over={**CLASSICAL, B: matrix(n, q), R: positive_definite(p), **POINT, **ROWS, r1: matrix(1, n), r2: matrix(1, n)},
                    given=[ANNIHILATES],
                    by=[order([], [], [inv(R)], [inv(R)], [v1 * B * T(B) * T(v1)], [v2 * B * T(B) * T(v2)], lemmas=[w1 * R == Zero(1, p), w2 * R == Zero(1, p), w1 == Zero(1, p), w2 == Zero(1, p),
                                                                      v1 * B == Zero(1, q), v2 * B == Zero(1, q)]),
                        *[example({**S23_ONES, **change}) for change in ({v1: [[1]]}, {v2: [[1]]}, {w1: [[1]]}, {w2: [[1]]}, {B: [[0]], A: [[0]], v1: [[1]]},
                                                                         {B: [[0]], A: [[0]], v2: [[1]]})],
                        COMPLEX_V, REAL_V]),
      note=("In the print Q = BB', S = BD', R = DD', and full row rank is said by a K with stable A + BK, which makes it full even for |s| >= 1. The corrected statement is for each "
            "(s, t) and S = 0: a row (v, w) that annihilates the one matrix has w = 0, and v annihilates [sI - tA, B]; by the last equation a row r1 + ir2 that annihilates this gives one with w = 0. For t = 0 that says v = 0; "
            "else the point is s/t (NWL92-S22)."))

# ------------------------------------------------------------------ Lemma 4.1
U, V, E22, C2, C2L, F, A11, A12, A21, A22, r = symbols("U V E22 C2 C2L F A11 A12 A21 A22 r")
#: r coordinates in which E is I, q others; r + m equations
COORDINATES = {E22: matrix(m, q), C2: matrix(p, q), A11: matrix(r, r), A12: matrix(r, q), A21: matrix(m, r), A22: matrix(m, q)}
E_NEW, C_NEW = block([[Identity(r), Zero(r, q)], [Zero(m, r), E22]]), hstack(Zero(p, r), C2)
A_NEW, L_NEW = block([[A11, A12], [A21, A22]]), block([[Identity(r), D], [Zero(q, r), Zero(q, m)]])
AFTER = block([[A11 + D * A21, A12 + D * A22], [Zero(q, r), Zero(q, q)]])
D_STABLE = given("A11 + D A21 stable", schur(A11 + D * A21))
NEW_SIZES = {"r": (1, 2), "m": (1, 2), "q": (1, 2)}
C2_LEFT = inv(T(C2) * C2) * T(C2)


def shrunk(more=None, **sizes):
    """D, A21 random, and a contraction for A11 + D A21."""
    return instances(made_by={A11: X0 * (1 / (1 + trace(X0 * T(X0)))) - D * A21, **(more or {})}, using={X0: matrix(r, r)}, **{**NEW_SIZES, **sizes})


claim("NWL92-S24", "if C has full column rank, L_e = 0 will do",
      (0 * Le * E + C2L * C == Identity(n)) & (0 * Le * A == Zero(n, n)), sizes=["l", "p", "n"],
      over={A: matrix(l, n), E: matrix(l, n), C: matrix(p, n), C2L: matrix(n, p), Le: matrix(n, l)}, given=[given("left inverse of C", C2L * C == Identity(n))],
      by=[order(), instances(made_by={C2L: inv(T(C) * C) * T(C)}, l=(1, 2), p=(1, 2, 3), n=(1, 2)),
          example({"l": 1, "p": 1, "n": 1, A: [[1]], E: [[1]], C: [[1]], C2L: [[2]], Le: [[1]]})],
      note="L_e = 0 is written as zero times a matrix; the zero matrix is stable.")

X12 = sym("X12")
not_checked("NWL92-E4.9", "A in the new coordinates", DEFINITION)
claim("NWL92-E4.10", "there are such F if C_2 has full column rank",
      (vstack(-(D * E22), Identity(q)) * C2_LEFT + vstack(X12, X1) * (Identity(p) - C2 * C2_LEFT)) * C2 == vstack(-(D * E22), Identity(q)), sizes=["r", "m", "q", "p"],
      over={E22: matrix(m, q), C2: matrix(p, q), D: matrix(r, m), X12: matrix(r, p), X1: matrix(q, p)},
      by=[order(), instances(r=(1, 2), m=(1, 2), q=(1, 2), p=(2, 3))],
      note="A definition; what is checked is that it is not empty, for any X12 and X1. Full column rank of C_2 is the denominator.")

claim("NWL92-E4.11", "one such F", vstack(-(D * E22 * C2L), C2L) * C2 == vstack(-(D * E22), Identity(q)), sizes=["r", "m", "q", "p"],
      over={E22: matrix(m, q), C2: matrix(p, q), D: matrix(r, m), C2L: matrix(q, p)}, given=[given("left inverse", C2L * C2 == Identity(q))],
      by=[order(), example({"r": 1, "m": 1, "q": 1, "p": 1, E22: [[1]], C2: [[1]], D: [[1]], C2L: [[2]]}),
          instances(made_by={C2L: C2_LEFT + X12 * (Identity(p) - C2 * C2_LEFT)}, using={X12: matrix(q, p)}, r=(1, 2), m=(1, 2), q=(1, 2), p=(2, 3))])

FA, FB = symbols("FA FB")
F_PARTS = vstack(FA, FB)
F_GIVEN = given("(4.10)", F_PARTS * C2 == vstack(-(D * E22), Identity(q)))
F_OVER = {FA: matrix(r, p), FB: matrix(q, p)}
F_MADE = {FA: -(D * E22 * C2_LEFT), FB: C2_LEFT}
claim("NWL92-E4.12", "the left inverse in the new coordinates", L_NEW * E_NEW + F_PARTS * C_NEW == Identity(r + q), sizes=["r", "m", "q", "p"],
      over={E22: matrix(m, q), C2: matrix(p, q), D: matrix(r, m), **F_OVER}, given=[F_GIVEN],
      by=[order(), example({"r": 1, "m": 1, "q": 1, "p": 1, E22: [[1]], C2: [[1]], D: [[1]], FA: [[1]], FB: [[1]]}),
          instances(made_by=F_MADE, r=(1, 2), m=(1, 2), q=(1, 2), p=(2, 3))])

claim("NWL92-E4.13", "the matrix L_e A in the new coordinates", L_NEW * A_NEW == AFTER, sizes=["r", "m", "q"],
      over={A11: matrix(r, r), A12: matrix(r, q), A21: matrix(m, r), A22: matrix(m, q), D: matrix(r, m)}, by=[order(), instances(r=(1, 2), m=(1, 2), q=(1, 2))])

#: an eigenvector and its eigenvalue outside the open disc
(va, wa), (lr, li) = EIGENVECTOR, EIGENVALUE
BOUND = sym("Bound")
EXCESS = lr * lr + li * li - 1


def vanishes(*vectors, bound):
    """Terms that make the parts of an eigenvector zero whose eigenvalue lies outside the open disc; ``bound`` solves the Stein equation of a stable matrix."""
    return [T(x) * x for x in vectors] + [EXCESS * T(x) * bound * x for x in vectors]


AFTER_OVER = {A11: matrix(r, r), A12: matrix(r, q), A21: matrix(m, r), A22: matrix(m, q), D: matrix(r, m)}
claim("NWL92-S27", "the matrix (4.13) is stable because A_11 + DA_22 is, as printed",
      schur(A11 + D * A22) & schur(AFTER), sizes=["r", "m", "q"], over=AFTER_OVER, given=[D_STABLE],
      by=[example({"r": 1, "m": 1, "q": 1, A11: [[0]], A12: [[0]], A21: [[0]], A22: [[2]], D: [[1]]}), shrunk(r=1, q=1)],
      repair=repair("index", ("the diagonal block of (4.13) is A_11 + DA_21, which D makes stable; A_11 + DA_22 does not occur in it, need not be stable, and its sizes "
                              "do not fit unless both parts of the state have one"),
                    schur(AFTER), sizes=["r", "m", "q"], over=AFTER_OVER, given=[D_STABLE],
                    by=[steps("NWL92-E4.13", facts=["the eigenvalues of a block triangular matrix are those of its diagonal blocks"],
                              prose="The diagonal blocks of (4.13) are A_11 + DA_21 and zero."),
                        example({"r": 1, "m": 1, "q": 1, A11: [[2]], A12: [[0]], A21: [[0]], A22: [[0]], D: [[0]]}), shrunk()]),
      note="D is that of the text before (4.10), for which A_11 + DA_21 is stable.")

# ------------------------------------------------------------------ back to the old coordinates
Ln, En, Cn = symbols("Ln En Cn")
NEW = {E: matrix(l, n), A: matrix(l, n), C: matrix(p, n), U: nonsingular(l), V: nonsingular(n), Ln: matrix(n, l), F: matrix(n, p)}
LEFT_412 = given("(4.12)", Ln * (U * E * V) + F * (C * V) == Identity(n))
STABLE_413 = given("(4.13) stable", schur(Ln * (U * A * V)))
V_ONES = {"l": 1, "n": 1, "p": 1, E: [[1]], A: [[0]], C: [[0]], U: [[1]], V: [[1]], Ln: [[1]], F: [[0]]}
Kx = sym("Kx")
NEW_DRAWN = instances(made_by={En: U * E * V, Cn: C * V, Kx: inv(T(En) * En + T(Cn) * Cn), Ln: Kx * T(En), F: Kx * T(Cn),
                               A: inv(U) * X0 * (1 / ((1 + trace(X0 * T(X0))) * (1 + trace(Ln * T(Ln))))) * inv(V)}, using={X0: matrix(l, n)},
                      l=(1, 2), n=(1, 2), p=(1, 2))
xr, xi = inv(V) * va, inv(V) * wa
CLOSED = Ln * (U * A * V)
BACK_STABLE = order([], [], [], vanishes(xr, xi, bound=BOUND), [],
                    inside=[within(1, CLOSED * xr == lr * xr - li * xi, CLOSED * xi == li * xr + lr * xi, hstack(xr, xi) == Zero(n, 2), vector="right",
                                   solutions={BOUND: (T(CLOSED), Identity(n))}, on=2)])
#: l = n = 2: U does not commute with A
APART = example({"l": 2, "n": 2, "p": 1, U: [[1, 0], [0, 2]], V: [[1, 0], [0, 1]], A: [[0, 1], [0, 0]], Ln: [[1, 0], ["3/4", 1]], E: [[1, 0], ["-3/8", "1/2"]],
                 C: [[0, 0]], F: [[0], [0]]})
BACK_NOTE = "Ln is [I, D; 0, 0], so that L_e = V Ln U; U and V are those of (4.7) and (4.8)."
claim("NWL92-E4.14a", "L_e in the old coordinates makes a stable L_e A",
      (V * Ln * U * E + V * F * C == Identity(n)) & schur(V * Ln * U * A), sizes=["l", "n", "p"], over=NEW, given=[LEFT_412, STABLE_413],
      by=[BACK_STABLE, example({**V_ONES, Ln: [[2]]}), example({**V_ONES, A: [[2]]}), APART, NEW_DRAWN], note=BACK_NOTE)
OLD = {"sizes": ["l", "n", "p"], "over": {x: kind for x, kind in NEW.items() if x is not A}, "given": [LEFT_412]}
OLD_ONES = {"l": 1, "n": 1, "p": 1, E: [[1]], C: [[0]], U: [[1]], V: [[1]], Ln: [[2]], F: [[0]]}
OLD_DRAWN = instances(made_by={En: U * E * V, Cn: C * V, Kx: inv(T(En) * En + T(Cn) * Cn), Ln: Kx * T(En), F: Kx * T(Cn)}, l=(1, 2), n=(1, 2), p=(1, 2))
claim("NWL92-E4.14b", "L_c in the old coordinates", V * F * C == Identity(n) - V * Ln * U * E, **OLD, by=[order(), example(OLD_ONES), OLD_DRAWN], note=BACK_NOTE)
claim("NWL92-E4.6", "(L_e L_c) is a left inverse of (E; C)", V * Ln * U * E + V * F * C == Identity(n), **OLD, by=[order(), example(OLD_ONES), OLD_DRAWN],
      note="With L_e and L_c of (4.14). " + BACK_NOTE)
claim("NWL92-L4.1", "a detectable system has a left inverse (L_e L_c) of (E; C) with stable L_e A",
      (V * Ln * U * E + V * F * C == Identity(n)) & schur(V * Ln * U * A), sizes=["l", "n", "p"], over=NEW, given=[LEFT_412, STABLE_413],
      by=[steps("NWL92-S24", "NWL92-E4.7", "NWL92-S25", "NWL92-E4.11", "NWL92-E4.12", "NWL92-E4.13", "NWL92-E4.14a",
                facts=["a detectable pair (A, C) has a D with stable A + DC"],
                prose=("If C has full column rank, L_e = 0. Else (4.7) and (4.8) give coordinates in which (A_11, A_21) is detectable; D makes A_11 + DA_21 stable, hence (4.13), "
                       "and V[I, D; 0, 0]U with VF are the left inverse.")),
          example({**V_ONES, Ln: [[2]]}), example({**V_ONES, A: [[2]]}), APART, NEW_DRAWN],
      note="What is tested is the left inverse that the proof constructs. " + BACK_NOTE)

Nc, Mc2, Gl, Kl, Un, Vn = symbols("Nc Mc Gl Kl Un Vn")
claim("NWL92-E4.7", "coordinates in which E is block diagonal and C has the columns (0 C_2)",
      invertible(Un) & invertible(Vn) & (Un * E * Vn == diag(Identity(n - rank(C)), T(Kl) * E * Mc2))
      & (C * Vn == C * Mc2 * hstack(Zero(rank(C), n - rank(C)), Identity(rank(C)))) & (rank(C * Mc2) == rank(C)), sizes=["l", "p", "n"],
      over={E: matrix(l, n), C: matrix(p, n)},
      where=[let(Nc, kernel_basis(C)), let(Mc2, kernel_basis(T(Nc))), let(Gl, inv(T(E * Nc) * E * Nc) * T(E * Nc)), let(Kl, kernel_basis(T(E * Nc))),
             let(Un, vstack(Gl, T(Kl))), let(Vn, hstack(Nc, Mc2 - Nc * Gl * E * Mc2))],
      given=[standing("C does not have full column rank", rank(C) < n)],
      by=[instances(l=(2, 3), p=1, n=(2, 3)), instances(made_by={C: X0 * X1}, using={X0: matrix(p, 1), X1: matrix(1, n)}, l=(2, 3), p=2, n=(2, 3))],
      note=("Nc is a basis of the null space of C, Mc one of its complement, Gl a left inverse of E Nc and the columns of Kl those that annihilate E Nc: U = (Gl; Kl'), "
            "V = (Nc, Mc - Nc Gl E Mc), C_2 = C Mc. That E Nc has full column rank, the denominator, is full column rank of (E; C)."))

x1_, x2_ = symbols("x1 x2")
AT_NEW = real_form(vstack(a * E_NEW - A_NEW, C_NEW), vstack(b * E_NEW, Zero(p, r + q)))
claim("NWL92-S25", "(A_11, -A_21) is detectable at every point where the system is",
      (x1_ == Zero(r, 1)) & (x2_ == Zero(r, 1)), sizes=["r", "m", "q", "p"],
      over={**COORDINATES, a: scalar(), b: scalar(), x1_: vector(r), x2_: vector(r)},
      given=[given("full column rank at s/t", rank(AT_NEW) == 2 * (r + q)),
             given("null vector", real_form(vstack(a * Identity(r) - A11, -A21), vstack(b * Identity(r), Zero(m, r))) * vstack(x1_, x2_) == Zero(r + m + r + m, 1))],
      by=[order(lemmas=[AT_NEW * vstack(x1_, Zero(q, 1), x2_, Zero(q, 1)) == Zero(r + m + p + r + m + p, 1)]),
          *[example({"r": 1, "m": 1, "q": 1, "p": 1, E22: [[0]], C2: [[1]], A11: [[0]], A12: [[0]], A21: [[0]], A22: [[0]], a: x, b: 0, x1_: [y], x2_: [z]})
            for x, y, z in ((0, 1, 0), (0, 0, 1), (1, 1, 0), (1, 0, 1))],
          instances(made_by={x1_: Zero(r, 1), x2_: Zero(r, 1)}, r=(1, 2), m=(1, 2), q=1, p=(1, 2))],
      note="At s/t = a + ib, in the coordinates of (4.7) to (4.9), which change no rank; x1 + ix2 is a null vector. Detectability gives the rank for |s/t| >= 1.")

not_checked("NWL92-S26", "there is a D with stable A_11 + DA_21",
            "the classical theorem on output injection, quoted in the words of detectability; such a D has no formula that this language has")

# ------------------------------------------------------------------ Theorem 4.1
xa, xb, sa, u, w, y = symbols("xa xb sa u w y")
W, W0, Ps, Pt, Pow, M = symbols("W W0 Ps Pt Pow M")
LEFT_INVERSE = given("(4.6)", Le * E + Lc * C == Identity(n))
MADE_LEFT = {Kx: inv(T(E) * E + T(C) * C), Le: Kx * T(E) + X0 * (Identity(l) - E * Kx * T(E)), Lc: Kx * T(C) - X0 * E * Kx * T(C)}
STEP = {A: matrix(l, n), E: matrix(l, n), C: matrix(p, n), Le: matrix(n, l), Lc: matrix(n, p), xa: vector(n), xb: vector(n), u: vector(l), w: vector(p)}
STEP_SIZES = {"l": (1, 2), "p": (1, 2), "n": (1, 2)}
DYNAMICS = [given("(4.1)", E * xb == A * xa + u), given("(4.2)", y == C * xb + w)]
STEP_DRAWN = instances(made_by={**MADE_LEFT, u: E * xb - A * xa, y: C * xb + w}, using={X0: matrix(n, l)}, **STEP_SIZES)
STEP_ONES = {"l": 1, "p": 1, "n": 1, A: [[0]], E: [[1]], C: [[1]], Le: [[1]], Lc: [[0]], xa: [0], xb: [1], u: [1], w: [0], y: [1]}
STEP_FOILS = [{Lc: [[1]]}, {u: [0]}, {y: [0], Le: [[0]], Lc: [[1]]}]
claim("NWL92-E4.15", "the next state through the left inverse",
      xb == Le * A * xa + Lc * y + Le * u - Lc * w, sizes=["l", "p", "n"], over={**STEP, y: vector(p)}, given=[LEFT_INVERSE, *DYNAMICS],
      by=[order(), *[example({**STEP_ONES, **change}) for change in STEP_FOILS], STEP_DRAWN], note="xa, xb are x(k), x(k+1); w stands for r(k).")

not_checked("NWL92-E4.4", "the form of the stable filter", DEFINITION)
claim("NWL92-E4.16", "error of the stable filter",
      xb - (Le * A * sa + Lc * y) == Le * A * (xa - sa) + Le * u - Lc * w, sizes=["l", "p", "n"], over={**STEP, y: vector(p), sa: vector(n)}, given=[LEFT_INVERSE, *DYNAMICS],
      by=[order(), *[example({**STEP_ONES, sa: [0], **change}) for change in STEP_FOILS], STEP_DRAWN],
      note="A definition; what is checked is what it does to the error, sa being x_s(k).")

ERROR_NOISE = hstack(Le, Lc) * system.NOISE_G * vstack(T(Le), T(Lc))
FLIP = block([[Identity(l), Zero(l, p)], [Zero(p, l), -Identity(p)]])
NOISE_FORM = hstack(Le, Lc) * FLIP * system.COVARIANCE * FLIP * T(hstack(Le, Lc))
OBSERVER = {A: matrix(l, n), Q: symmetric_matrix(l), S: matrix(l, p), R: symmetric_matrix(p), Le: matrix(n, l), Lc: matrix(n, p)}
STABLE = given("Le A stable", schur(Le * A))


def one_step(X):
    """Error covariance of the stable filter one step later."""
    return (Le * A) * X * T(Le * A) + ERROR_NOISE


LYAPUNOV, LYAPUNOV_2 = (given(f"(4.18){which}", X - (Le * A) * X * T(Le * A) == ERROR_NOISE) for which, X in (("", Ps), (" again", Pt)))
#: Le A is zero
NO_MEMORY = instances(made_by={**system.RANDOM_NOISE, A: kernel_basis(Le) * X1, Ps: ERROR_NOISE, Pt: ERROR_NOISE},
                      using={**system.RANDOM_NOISE_FREE, X1: matrix(1, n)}, l=2, p=(1, 2), n=1)
#: l = n: Le A = N with N^2 = 0, so that the solution is a sum of two terms
MEMORY = instances(made_by={**system.RANDOM_NOISE, M: X0 * block([[0, 1], [0, 0]]) * inv(X0) * a, A: inv(Le) * M, Ps: ERROR_NOISE + M * ERROR_NOISE * T(M),
                            Pt: ERROR_NOISE + M * ERROR_NOISE * T(M)}, using={**system.RANDOM_NOISE_FREE, X0: nonsingular(2), a: scalar()}, l=2, p=(1, 2), n=2)
SCALAR = {"l": 1, "p": 1, "n": 1, A: [[2]], Q: [[0]], S: [[0]], R: [[0]], Le: [[1]], Lc: [[0]]}
claim("NWL92-E4.18", "the Lyapunov equation has at most one solution, which is nonnegative",
      (Ps == Pt) & psd(Ps), sizes=["l", "p", "n"], over={**OBSERVER, Ps: symmetric_matrix(n), Pt: symmetric_matrix(n)},
      given=[system.NOISE, STABLE, LYAPUNOV, LYAPUNOV_2],
      by=[restated("a linear map of matrices that is one to one is onto"), order([], [NOISE_FORM], inside=[within(0, unique=(Le * A, T(Le * A))), within(1, stein=Le * A)]),
          *[example({**SCALAR, A: [[x]], Q: [[q_]], Ps: [[y]], Pt: [[z]]}) for x, q_, y, z in ((1, 0, 1, 0), (2, 3, -1, -1), (0, 0, 0, 1), (0, 0, 1, 0), (1, 0, -1, -1))],
          MEMORY, NO_MEMORY],
      note="The map X -> X - (Le A)X(Le A)' is linear; as it takes different X to different values, there is a solution.")

ERROR_REC = [rec(W, t, W0, one_step(W[t])), rec(Pow, t, Identity(n), (Le * A) * Pow[t])]
LIMIT_OVER = {**OBSERVER, Ps: symmetric_matrix(n), W0: positive_semidefinite(n)}
ERROR_IS = W[t] - Ps == Pow[t] * (W0 - Ps) * T(Pow[t])
claim("NWL92-E4.17", "the error covariance of the stable filter tends to the solution of the Lyapunov equation",
      always(t, ERROR_IS), sizes=["l", "p", "n"], over=LIMIT_OVER, where=ERROR_REC, given=[LYAPUNOV],
      by=[restated("the powers of a stable matrix tend to zero", "a linear map of matrices that is one to one is onto"), induction(), example({**SCALAR, Ps: [[1]], W0: [[0]]}), MEMORY, NO_MEMORY],
      note=("W[t] is the error covariance at t from any W0, by (4.16) and as u(k), r(k) are independent of the error at k; Pow[t] is the power of Le A, which tends "
            "to zero as Le A is stable."))

BOUND_W = Pow[t] * W0 * T(Pow[t])
CLOSED_LA = T(T(Le * A))
claim("NWL92-E4.5", "the error covariance of the stable filter stays bounded and has a limit",
      always(t, ERROR_IS) & always(t, psd(W[t])) & always(t, loewner(Ps + BOUND_W, W[t])), sizes=["l", "p", "n"],
      over={**LIMIT_OVER, Ps: positive_semidefinite(n)}, where=ERROR_REC, given=[system.NOISE, LYAPUNOV],
      by=[restated("the powers of a stable matrix tend to zero", "a linear map of matrices that is one to one is onto"), induction(base=[order(), order([W0]), order([Ps])],
                    step=[order(), order([CLOSED_LA * W[t] * T(CLOSED_LA), NOISE_FORM]), order([CLOSED_LA * (Ps + BOUND_W - W[t]) * T(CLOSED_LA)])]),
          example({**SCALAR, Ps: [[1]], W0: [[0]]}), MEMORY, NO_MEMORY],
      note="Ps is nonnegative by NWL92-E4.18. The limit is Ps, as the powers Pow[t] of the stable Le A tend to zero (NWL92-E4.17); it is finite.")

As, Gs = symbols("As Gs")
OLD_NOISE = Gs * system.NOISE_G * T(Gs)
FILTER_REC = [let(As, V * Ln * U * A), let(Gs, hstack(V * Ln * U, V * F)), rec(W, t, W0, As * W[t] * T(As) + OLD_NOISE), rec(Pow, t, Identity(n), As * Pow[t])]
#: A with Ln U A V = N, N^2 = 0, for l = n = 2, in which the solution is a sum of two terms
FILTER_MADE = {**system.RANDOM_NOISE, M: X0 * block([[0, 1], [0, 0]]) * inv(X0) * a, Ln: inv(U * E * V), F: Zero(n, p), A: inv(U) * inv(Ln) * M * inv(V),
               Ps: OLD_NOISE + As * OLD_NOISE * T(As)}
T41_ONES = {"l": 1, "n": 1, "p": 1, E: [[1]], A: [["1/2"]], C: [[0]], U: [[1]], V: [[1]], Ln: [[1]], F: [[0]], Q: [[3]], S: [[0]], R: [[0]], Ps: [[4]], W0: [[0]]}
claim("NWL92-T4.1", "a detectable system has a stable filter with finite limit of the error covariance",
      schur(As) & (Gs * vstack(E, C) == Identity(n)) & always(t, W[t] - Ps == Pow[t] * (W0 - Ps) * T(Pow[t])), sizes=["l", "n", "p"],
      over={**NEW, Q: symmetric_matrix(l), S: matrix(l, p), R: symmetric_matrix(p), Ps: symmetric_matrix(n), W0: positive_semidefinite(n)}, where=FILTER_REC,
      given=[LEFT_412, STABLE_413, given("(4.18)", Ps - As * Ps * T(As) == OLD_NOISE)],
      by=[steps("NWL92-L4.1", "NWL92-E4.14a", "NWL92-E4.15", "NWL92-E4.16", "NWL92-E4.17", "NWL92-E4.18",
                facts=["the powers of a stable matrix tend to zero", "a detectable pair (A, C) has a D with stable A + DC"],
                prose=("Lemma 4.1 gives L_e, L_c; the filter (4.16) has the error recursion of NWL92-E4.16, and its covariance differs from the solution of (4.18) by "
                       "powers of L_e A on both sides.")),
          *[example({**T41_ONES, **change}) for change in ({Ln: [[2]], A: [["1/4"]]}, {A: [[2]], Ps: [[-1]]}, {Ps: [[3]]})],
          instances(8, made_by=FILTER_MADE, using={**system.RANDOM_NOISE_FREE, X0: nonsingular(2), a: scalar()}, l=2, n=2, p=(1, 2))],
      note="A_s = L_e A and K_s = L_c, (L_e L_c) = Gs, from the left inverse and the D of the proof of Lemma 4.1. " + BACK_NOTE)
