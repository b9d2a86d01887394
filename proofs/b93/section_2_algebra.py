# SPDX-License-Identifier: MIT
"""The algebra of section 2: the distance to the identity, one step of the filter, and the Gramians of Lemma 2.8.

The logarithms l_1 <= ... <= l_d of the eigenvalues of a positive Q have log|Q| = l_d and
log|inv(Q)| = -l_1, so that the squared distance of Q to the identity, the sum of the
squares, lies between the larger of l_1^2 and l_d^2 and d times that: between two bounds no
square exceeds the squares of both.

The map Phi of a system sends the identity to T inv(I + RT) = inv(inv(T) + R) with
T = AA* + S, which is at most T, because T - inv(inv(T) + R) = T(inv(R) + T)inv T where R
is invertible, and T H inv(I + HTH) H T for a root H of R in any case.

With P_n = Phi_n(P_{n-1}) and W = A_n P_{n-1} A_n* + S_n, P_n(I + R_n W) = W gives
P_n = (I - P_n R_n) W, and therefore

    P_n = (I - P_n R_n) W (I - P_n R_n)* + P_n R_n P_n = B_n P_{n-1} B_n* + T_n.

Write H_n = I - P_n R_n and K_n = P_n C_n*, so that B_n = H_n A_n = A_n - K_n C_n A_n. The
wide matrices of Lemma 2.8 grow by W_n = (K_n, F_n, A_n W_{n-1}) and
V_n = (K_n, H_n F_n, B_n V_{n-1}). As H_n F_n = F_n - K_n (C_n F_n) and, if V_{n-1} = W_{n-1} U_{n-1},
B_n V_{n-1} = A_n W_{n-1} U_{n-1} - K_n (C_n A_n V_{n-1}), each column of V_n is the same column
of W_n combined with columns to its left: V_n = W_n U_n with

          [ I   -C_n F_n   -C_n A_n V_{n-1} ]
    U_n = [ 0      I              0         ] ,
          [ 0      0           U_{n-1}      ]

upper triangular with unit diagonal. Their Gramians follow recursions in one size d:
V_n V_n* = T_n + B_n (V_{n-1} V_{n-1}*) B_n*, which is that of G_n, and
W_n W_n* = K_n K_n* + S_n + A_n (W_{n-1} W_{n-1}*) A_n*, which stays above that of the right side
of the printed inequality.

For Lemma 2.8 itself, let x be a null vector of G_n = T_n + B_n G_{n-1} B_n*, and x_n = x,
x_{s-1} = B_s* x_s. Each term of a sum of nonnegative matrices has its null vectors: so
C_s P_s x_s = 0 and F_s* H_s* x_s = 0, which make F_s* x_s = 0 and B_s* x_s = A_s* x_s. Hence x is a
null vector of every term of the controllability sum.
"""

from exactkf.claims import claim
from exactkf.evidence import example, first, induction, instances, null_vector, order, restated, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    forall,
    function,
    given,
    hstack,
    inv,
    invertible,
    let,
    loewner,
    matrix,
    nonsingular,
    positive_semidefinite,
    psd,
    rank,
    rec,
    scalar,
    sequence,
    sequence_of,
    signal_of,
    standing,
    sum_of,
    symbols,
    symmetric,
    symmetric_matrix,
    vector,
    when,
)
from proofs.b93.notation import d, k, p, q

A, B, C, F, H, K, P, R, S, W, V, U, X, Y = symbols("A B C F H K P R S W V U X Y")
P0, T0, l, m, t = symbols("P0 T0 l m t")
eps, eta, x, xhat, x1, y1, xhat1 = symbols("eps eta x xhat x1 y1 xhat1")

larger, total, rest, count = symbols("larger total rest count")
ENDS = l[1] + l[d]
#: the largest square less that of the next logarithm, if it is the last and if it is the first
LAST_LESS = (l[d] - l[t + 1]) * ((l[t + 1] - l[1]) + ENDS)
FIRST_LESS = (l[t + 1] - l[1]) * ((l[d] - l[t + 1]) + (-ENDS))
KEPT = [[1 * (total[t] - l[t] ** 2), l[t] * l[t]], [1 * (total[t] - l[1] ** 2), l[t + 1] * l[t + 1]], []]
claim("B93-L2.3", "the distance to the identity between two multiples of a logarithm",
      forall(t, 1, d, (l[t] ** 2 <= total[t]) & (l[1] ** 2 <= total[t]) & (total[t] + rest[t] == count[t] * larger) & (rest[t] >= 0)), sizes=["d"],
      over={l: sequence(1, d), larger: scalar()},
      where=[rec(total, t, l[1] ** 2, total[t] + l[t + 1] ** 2, 1), rec(rest, t, larger - l[1] ** 2, rest[t] + larger - l[t + 1] ** 2, 1),
             rec(count, t, 1, count[t] + 1, 1)],
      given=[given("the first is the smallest, the last the largest", forall(k, 1, d, (l[1] <= l[k]) & (l[k] <= l[d]))),
             given("the larger of the two squares", ((ENDS >= 0) & (larger == l[d] ** 2)) | ((-ENDS >= 0) & (larger == l[1] ** 2)))],
      by=[induction(base=order([], [], [], [(l[d] - l[1]) * ENDS], [], [], [], [0]), step=order(*KEPT, [1 * rest[t], LAST_LESS], *KEPT, [1 * rest[t], FIRST_LESS])),
          instances(24, d=range(1, 7), using={m: sequence(1, d)},
                    made_by={l: (k, m[1] + sum_of(t, 2, k, m[t] ** 2)), larger: when(ENDS >= 0, l[d] ** 2, l[1] ** 2)}),
          instances(24, d=range(1, 7), using={m: sequence(1, d)},
                    made_by={l: (k, -m[1] ** 2 - sum_of(t, k + 1, d, m[t] ** 2)), larger: when(ENDS >= 0, l[d] ** 2, l[1] ** 2)}),
          example(d=2, l=[1, 0], larger=0), example(d=3, l=[1, 2, 1], larger=1), example(d=2, l=[0, 2], larger=0),
          instances(8, d=(2, 3)),
          restated("the logarithm is increasing, and log(1/x) = -log(x)")],
      note="l_1, ..., l_d are the logarithms of the eigenvalues of Q in ascending order; log|Q| = l_d and log|inv(Q)| = -l_1 by B93-S60, and the squared distance is "
           "the sum of their squares, total_d. As l_1 <= l_d, the larger of their squares is that of l_d exactly if l_1 + l_d >= 0. The count is t, and the "
           "rest is what is missing to t times that. At t = d the first two inequalities put the larger square below the sum, whichever of the two it is, "
           "and the others are the upper bound.")

SYSTEM = {A: nonsingular(d), F: matrix(d, p), C: matrix(q, d)}
ONE_STEP = (let(S, F * T(F)), let(R, T(C) * C))
SMALL = {"d": (1, 2, 3), "p": (1, 2), "q": (1, 2)}

claim("B93-S63", "the image of the identity",
      ((A * T(A) + S) * inv(Identity(d) + R * S + R * A * T(A)) == T0 * inv(Identity(d) + R * T0))
      & (T0 * inv(Identity(d) + R * T0) == inv(inv(T0) + R)) & loewner(T0, inv(inv(T0) + R)),
      sizes=["d", "p", "q"], over=SYSTEM, where=[*ONE_STEP, let(T0, A * T(A) + S)],
      by=[order([], [], [T0 * T(C) * inv(Identity(q) + C * T0 * T(C)) * C * T0]), instances(**SMALL)],
      note="T_0 stands for the T of the text.")

claim("B93-S73", "the error of the filter follows the closed loop",
      xhat1 - x1 == (A - P * R * A) * (xhat - x) + P * T(C) * eta + (P * R - Identity(d)) * F * eps,
      sizes=["d", "p", "q"],
      over={A: matrix(d, d), F: matrix(d, p), C: matrix(q, d), P: matrix(d, d), x: vector(d), xhat: vector(d), eps: vector(p), eta: vector(q)},
      where=[let(R, T(C) * C), let(x1, A * x + F * eps), let(y1, C * x1 + eta), let(xhat1, (A - P * R * A) * xhat + P * T(C) * y1)],
      by=[instances(**SMALL)],
      note="x, xhat and x1, xhat1 are the state and the estimate before and after; nothing is needed of P.")

claim("B93-L2.7", "the covariance as a sum along the closed loop",
      P == B * P0 * T(B) + P * R * P + (Identity(d) - P * R) * S * T(Identity(d) - P * R),
      sizes=["d", "p", "q"], over={A: matrix(d, d), F: matrix(d, p), C: matrix(q, d), P0: positive_semidefinite(d), P: matrix(d, d)},
      where=[*ONE_STEP, let(W, A * P0 * T(A) + S), let(B, A - P * R * A)],
      given=[given("P = Phi(P_0)", P == W * inv(Identity(d) + R * W))],
      by=[order(lemmas=[symmetric(P), P + P * R * W == W]), instances(**SMALL, made_by={P: W * inv(Identity(d) + R * W)})],
      note="P_0 stands for P_{n-1}, and P for P_n.")

# ---------------------------------------------------------------- Lemma 2.8
Wm, Um, Gs, Vv, y, z, v, w = symbols("Wm Um G VV y z v w")
LOOPS = {A: signal_of(matrix(d, d), 0), F: signal_of(matrix(d, p), 0), C: signal_of(matrix(q, d), 0), P: signal_of(symmetric_matrix(d), 0)}
PIECES = (function(R, [t], T(C[t]) * C[t]), function(S, [t], F[t] * T(F[t])), function(K, [t], P[t] * T(C[t])),
          function(H, [t], Identity(d) - P[t] * R(t)), function(B, [t], A[t] - P[t] * R(t) * A[t]))

#: V_n and W_n applied to vectors; those of U_n are (K_n)-part ENTERS, (F_n)-part z_n
ENTERS = y[t + 1] - C[t + 1] * F[t + 1] * z[t + 1] - C[t + 1] * A[t + 1] * v[t]
APPLIED = (rec(v, t, K(0) * y[0] + H(0) * F[0] * z[0], K(t + 1) * y[t + 1] + H(t + 1) * F[t + 1] * z[t + 1] + B(t + 1) * v[t]),
           rec(w, t, K(0) * (y[0] - C[0] * F[0] * z[0]) + F[0] * z[0], K(t + 1) * ENTERS + F[t + 1] * z[t + 1] + A[t + 1] * w[t]))

claim("B93-S74", "the wide matrix of the closed loop is that of the open loop times a triangular one",
      always(t, v[t] == w[t])
      & (hstack(K(0), H(0) * F[0]) == hstack(K(0), F[0]) * block([[Identity(q), -C[0] * F[0]], [Zero(p, q), Identity(p)]]))
      & (hstack(K(1), H(1) * F[1], B(1) * (Wm * Um))
         == hstack(K(1), F[1], A[1] * Wm) * block([[Identity(q), -C[1] * F[1], -C[1] * A[1] * Wm * Um], [Zero(p, q), Identity(p), Zero(p, m)],
                                                   [Zero(m, q), Zero(m, p), Um]])),
      sizes=["d", "p", "q", "m"],
      over={**LOOPS, Wm: matrix(d, m), Um: matrix(m, m), y: signal_of(vector(q), 0), z: signal_of(vector(p), 0)}, where=[*PIECES, *APPLIED],
      by=[induction(), instances(**SMALL, m=(1, 2, 3), horizon=3)],
      note="Times are counted from 0. The last two equations are the first step and, for any V_{n-1} = W_{n-1} U_{n-1} with m columns, the one from n - 1 to n; by them "
           "U_n is upper triangular with unit diagonal, as U_{n-1} is, and takes a vector with the parts y_n, z_n, y_{n-1}, z_{n-1}, .. to the one with "
           "y_n - C_n F_n z_n - C_n A_n v_{n-1} and z_n first. v is V_n and w is W_n U_n applied to such a vector: they agree for every n and every vector.")

def _gram(*columns):
    """The Gramian of a matrix in blocks of columns."""
    return hstack(*columns) * T(hstack(*columns)) == sum((x * T(x) for x in columns[1:]), columns[0] * T(columns[0]))


claim("B93-S76", "G is the Gramian of V",
      always(t, Gs[t] == Vv[t])
      & _gram(K(0), H(0) * F[0]) & _gram(K(1), H(1) * F[1], B(1) * Wm), sizes=["d", "p", "q", "m"], over={**LOOPS, Wm: matrix(d, m)},
      where=[*PIECES,
             rec(Gs, t, P[0] * R(0) * P[0] + H(0) * S(0) * T(H(0)),
                 P[t + 1] * R(t + 1) * P[t + 1] + H(t + 1) * S(t + 1) * T(H(t + 1)) + B(t + 1) * Gs[t] * T(B(t + 1))),
             rec(Vv, t, K(0) * T(K(0)) + (H(0) * F[0]) * T(H(0) * F[0]),
                 K(t + 1) * T(K(t + 1)) + (H(t + 1) * F[t + 1]) * T(H(t + 1) * F[t + 1]) + B(t + 1) * Vv[t] * T(B(t + 1)))],
      by=[induction(), instances(12, **SMALL, m=(1, 2), horizon=3)],
      note="Times are counted from 0. VV is V_n V_n*, which for V_n = (K_n, H_n F_n, B_n V_{n-1}) follows the recursion that defines it here: that "
           "is the last equation, for any V_{n-1} = Wm. G follows from T_n + B_n G_{n-1} B_n*.")

Ww, Ss, L, M, n = symbols("WW SS L M n")
FULL = null_vector()
OF_W = [[], [Ww[n] - Ss[n], Ss[n]], [inv(Ss[n])]]
GROWN = [K(t + 1) * T(K(t + 1)), A[t + 1] * (Ww[t] - Ss[t]) * T(A[t + 1])]
#: W_0 and W_1
WIDE = hstack(K(0), F[0]), hstack(K(1), F[1], A[1] * K(0), A[1] * F[0])
claim("B93-S75", "the Gramian of W lies above the controllability sum",
      forall(t, 0, n, loewner(Ww[t], Ss[t])) & (invertible(Ss[n]) >> ((rank(L) == d) & (rank(L * M) == d)))
      & _gram(K(0), F[0]) & _gram(K(1), F[1], A[1] * Wm), sizes=["d", "p", "q", "m", "n"],
      over={**LOOPS, Wm: matrix(d, m), L: matrix(d, m), M: nonsingular(m)},
      where=[*PIECES[1:3], rec(Ww, t, K(0) * T(K(0)) + S(0), K(t + 1) * T(K(t + 1)) + S(t + 1) + A[t + 1] * Ww[t] * T(A[t + 1])),
             rec(Ss, t, S(0), S(t + 1) + A[t + 1] * Ss[t] * T(A[t + 1]))],
      given=[standing("L is W_n", L * T(L) == Ww[n])],
      by=[induction(before=[first(forall(t, 0, n, psd(Ss[t]) & loewner(Ww[t], Ss[t])), base=order([F[0] * T(F[0])], [K(0) * T(K(0))]),
                                  step=order([F[t + 1] * T(F[t + 1]), A[t + 1] * Ss[t] * T(A[t + 1])], GROWN)),
                            first(psd(Ss[n]) & loewner(Ww[n], Ss[n]))],
                    base=[order([K(0) * T(K(0))]),
                          *[order(*OF_W, inside=[within(0, Ww[n] * FULL == Zero(d, 1), Ss[n] * FULL == Zero(d, 1), vector="right")])] * 2, order(), order()],
                    step=[order(GROWN)]),
          instances(8, d=(1, 3), p=1, q=1, m=2, n=0, made_by={L: WIDE[0]}, horizon=3), instances(8, d=(1, 2), p=2, q=1, m=3, n=0, made_by={L: WIDE[0]}, horizon=3),
          instances(8, d=(1, 2), p=1, q=1, m=4, n=1, made_by={L: WIDE[1]}, horizon=3)],
      note="Times are counted from 0. WW is W_n W_n*, for W_n = (K_n, F_n, A_n W_{n-1}), see the last equation; L stands for W_n, as any matrix of m columns with this "
           "Gramian, and M for the invertible U_n: then LM is V_n.")

Gam, Pi, Xs = symbols("Gam Pi X")


def _noise(s):
    """T_n of Lemma 2.7."""
    return P[s] * R(s) * P[s] + H(s) * S(s) * T(H(s))


def _sum(s, terms):
    """T + B(T + B(T + ..)B*)B* from the place s on, with so many terms."""
    return _noise(s) if terms == 1 else _noise(s) + when(s < n, B(s) * _sum(s + 1, terms - 1) * T(B(s)), 0)


NULL = Zero(d, 1)
#: what a null vector of the sum from t on is a null vector of
PARTS, NEXT_PARTS = ([P[s] * T(C[s]) * C[s] * P[s], H(s) * F[s] * T(F[s]) * T(H(s)), B(s) * Gam[s + 1] * T(B(s))] for s in (t, t + 1))


def _kept(s):
    """What happens to the vector X_s, and then all of it that is carried on."""
    zero = Gam[s + 1] * T(B(s)) * Xs[s] == NULL
    driven, alike = T(F[s]) * Xs[s] == Zero(p, 1), T(B(s)) * Xs[s] == T(A[s]) * Xs[s]
    return [Gam[s] * Xs[s] == NULL, C[s] * P[s] * Xs[s] == Zero(q, 1), T(F[s]) * T(H(s)) * Xs[s] == Zero(p, 1), driven, zero, alike, Xs[s] == T(Pi[s]) * x,
            zero & alike & (Xs[s] == T(Pi[s]) * x)]


SUMMED = {Gam: (k, when(k > n, Zero(d, d), _sum(k, 3)))}
LENGTHS = {"d": (1, 2), "p": (1, 2), "q": (1, 2), "n": (0, 1, 2)}
claim("B93-L2.8", "where the controllability sum is invertible, so is G",
      x == NULL, sizes=["d", "p", "q", "n"],
      over={**LOOPS, Gam: sequence_of(positive_semidefinite(d), 0, n + 1), x: vector(d)},
      where=[*PIECES, rec(Xs, t, x, T(B(t)) * Xs[t]), rec(Pi, t, Identity(d), Pi[t] * A[t]),
             rec(Ss, t, S(0), Ss[t] + Pi[t + 1] * S(t + 1) * T(Pi[t + 1]))],
      given=[given("G, from each place on", forall(k, 0, n, Gam[k] == _noise(k) + B(k) * Gam[k + 1] * T(B(k)))),
             given("the sum is invertible", invertible(Ss[n])), given("x is a null vector of G", Gam[0] * x == NULL)],
      by=[induction(before=[first(forall(t, 0, n, _kept(t)[-1] & (Ss[t] * x == NULL)),
                                  base=order([], PARTS, PARTS, [], PARTS, lemmas=_kept(t)), step=order([], NEXT_PARTS, NEXT_PARTS, [], NEXT_PARTS, lemmas=_kept(t + 1)))],
                    also=[Ss[n] * x == NULL], base=order([], [inv(Ss[n])])),
          instances(8, **LENGTHS, made_by={**SUMMED, x: NULL}), instances(8, **LENGTHS, made_by=SUMMED), instances(8, **LENGTHS, made_by={Gam: (k, Zero(d, d))}),
          instances(8, **LENGTHS, made_by={Gam: (k, Zero(d, d)), F: (k, Zero(d, p)), C: (k, Zero(q, d))}),
          restated("weak controllability: the sum is invertible with positive probability for some n", "an event that contains another is at least as probable")],
      note="The data are counted backwards here: A_0 is the A_n of the print, A_1 its A_{n-1}, so that both sums read as they are printed. G is Gam_0, and Gam_k the rest "
           "of the sum from its k-th T on, with the products B before it taken off; it may end in any nonnegative matrix, such as zero. By weak controllability the "
           "event that the controllability sum is invertible has positive probability for some n, and on it G is.")
