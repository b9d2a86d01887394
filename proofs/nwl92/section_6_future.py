# SPDX-License-Identifier: MIT
"""Section VI, beginning: what future dynamics say about the present state.

An equation E x(k+1) = A x(k) + u(k) with an unknown x(k+1) says something about
x(k) only through the rows v with vE = 0: then vA x(k) = -v u(k). If E has full
row rank there are none. If it has not, there may still be nothing: vA can be
zero too. And where vE is not zero, later equations may take x(k+1) away.

In the time-invariant case let T_0, T_1, ... be rows with T_i E = T_(i+1) A. The
sum of T_i times the equation at j + i telescopes:

    sum T_i u(j+i) = -T_0 A x(j),

which with T(z) = T_0 + T_1 z + ... is T(z)(zE - A) = -T_0 A = F. All such F are
found from U(z)(zE - A)S = [N, K; 0, 0], where U is unimodular, S a permutation
and N invertible: (F_1 F_2) = FS must satisfy F_1 N^-1 K = F_2, with F_1 N^-1
polynomial. The noise of Fx(j) = w(j) is w = T_0 u(j) + T_1 u(j+1) + ..., and
its covariance V the sum of T_i Q T_i'. The paper writes K N^-1 in the place of
N^-1 K, and lets the sums begin at i = 1 in place of 0.

Polynomial matrices enter by their values at one real number z: what holds for
matrices of every size holds there, and so for all z.
"""

from __future__ import annotations

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import evaluation, example, induction, instances, order
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    block,
    coeff,
    column,
    defined,
    det,
    diag,
    eq,
    forall,
    given,
    hstack,
    iff,
    integer,
    inv,
    invertible,
    kernel_basis,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_semidefinite,
    rank,
    rec,
    scalar,
    sequence_of,
    standing,
    sum_of,
    sym,
    symbols,
    vector,
    vstack,
    when,
)

DEFINITION = "a definition: it fixes notation and asserts nothing"
l, n, m, N, g, k, t, i = symbols("l n m N g k t i")
E, A, Q, P, B = symbols("E A Q P B")
x0, x1, x2, x3, u, u0, u1, u2, xh = symbols("x0 x1 x2 x3 u u0 u1 u2 xh")
l1, l2, mu, Gb, X0 = symbols("l1 l2 mu Gb X0")

# ------------------------------------------------------------------ one equation
claim("NWL92-E6.1", "the dynamics as a measurement of zero",
      iff(Zero(l, 1) == E * x1 - A * x0 - u, E * x1 == A * x0 + u), sizes=["l", "m", "n"],
      over={E: matrix(l, n), A: matrix(l, m), x0: vector(m), x1: vector(n), u: vector(l)},
      by=[order(), instances(l=(1, 2), m=(1, 2), n=(1, 2)), instances(made_by={u: E * x1 - A * x0}, l=(1, 2), m=(1, 2), n=(1, 2))],
      note="A definition; what is checked is that it is (1.1).")

#: conditions (2.9) for x0 and x1 from xh = x0 + nu and 0 = E x1 - A x0 - u
STATIONARY = [given("first measurement", P * l1 + x0 == xh), given("(6.1)", Q * l2 - A * x0 + E * x1 == Zero(l, 1)),
              given("gradient in x0", l1 - T(A) * l2 == Zero(m, 1)), given("gradient in x1", T(E) * l2 == Zero(n, 1))]
ONE_STEP = {E: matrix(l, n), A: matrix(l, m), P: positive_semidefinite(m), Q: positive_semidefinite(l), l1: vector(m), l2: vector(l), x0: vector(m),
            x1: vector(n), xh: vector(m)}
ONES = {"l": 1, "m": 1, "n": 1, E: [[1]], A: [[1]], P: [[1]], Q: [[1]], l1: [0], l2: [0], x0: [0], x1: [0], xh: [0], u: [0]}
ROW_RANK = given("E has full row rank", invertible(E * T(E)))
claim("NWL92-S52", "an equation whose E has full row rank does not change the estimate of x(j)",
      (E * (T(E) * inv(E * T(E)) * (A * x0 + u)) == A * x0 + u) & (l2 == Zero(l, 1)) & (x0 == xh), sizes=["l", "m", "n"],
      over={**ONE_STEP, u: vector(l)}, given=[ROW_RANK, *STATIONARY],
      by=[order([], [inv(E * T(E))], [], lemmas=[]),
          example({**ONES, E: [[0]], l2: [1], l1: [1], x0: [1], xh: [2]}), example({**ONES, l1: [0], x0: [0], xh: [1]}),
          example({**ONES, l1: [1], xh: [1]}), example({**ONES, l2: [1], l1: [1], x0: [1], xh: [2]}),
          instances(made_by={l2: Zero(l, 1), l1: Zero(m, 1), x0: xh, x1: T(E) * inv(E * T(E)) * A * x0}, l=(1, 2), m=(1, 2), n=(2, 3))],
      note=("The conditions (2.9) for x0 = x(j) and x1 = x(j+1) from xh = x0 + nu and (6.1), with multipliers l1 and l2: the estimate x0 is xh, as without (6.1). "
            "The first part says that for every x0 and u there is an x1."))

LEFT = kernel_basis(T(E))
INFORMATION = T(LEFT) * A
claim("NWL92-S53", "a singular E gives information about x(j), as printed",
      (rank(E) < n) >> (INFORMATION != Zero(n - rank(E), m)), sizes=["n", "m"], over={E: matrix(n, n), A: matrix(n, m)},
      by=[example({"n": 1, "m": 1, E: [[0]], A: [[0]]}), example({"n": 2, "m": 2, E: [[1, 0], [0, 0]], A: [[2, 1], [0, 0]]}), instances(n=(1, 2), m=(1, 2))],
      repair=repair("missing hypothesis", "where the range of A lies in that of E, as for A = 0, a singular E says nothing; this must be excluded",
                    iff(INFORMATION != Zero(n - rank(E), m), rank(hstack(E, A)) > rank(E)), sizes=["n", "m"], over={E: matrix(n, n), A: matrix(n, m)},
                    by=[instances(n=(1, 2, 3), m=(1, 2)), instances(made_by={E: X0 * B}, using={X0: matrix(n, 1), B: matrix(1, n)}, n=(2, 3), m=(1, 2)),
                        instances(made_by={E: X0 * B, A: X0 * Gb}, using={X0: matrix(n, 1), B: matrix(1, n), Gb: matrix(1, m)}, n=(2, 3), m=(1, 2))]),
      note=("The rows v with vE = 0 are combinations of those of L', whose columns span the null space of E'. Only L'Ax(j) = -L'u(j) speaks of x(j) alone. "
            "If the pencil zE - A is regular, no v has vE = 0 and vA = 0, and the sentence is right."))

# ------------------------------------------------------------------ many equations
claim("NWL92-S51", "with E = I no future dynamics bear on x(j)",
      forall(k, 0, N, mu[k] == Zero(n, 1)), sizes=["n", "N"],
      over={mu: sequence_of(matrix(n, 1), 0, N), B: sequence_of(matrix(n, n), 1, N)},
      given=[given("gradient in the last state", mu[0] == Zero(n, 1)), given("gradient in the states between", forall(k, 1, N, mu[k] == T(B[k]) * mu[k - 1]))],
      by=[induction(), instances(made_by={mu: (k, Zero(n, 1))}, n=(1, 2), N=(1, 2, 3)),
          example({"n": 1, "N": 1, mu: [[[1]], [[1]]], B: [[[1]]]}), example({"n": 1, "N": 1, mu: [[[0]], [[1]]], B: [[[1]]]})],
      note=("mu_k is the multiplier of x(j+N+1-k) - A x(j+N-k) = u(j+N-k), counted from the last equation, and B_k is A at j+N-k+1. As all of them are zero, the "
            "conditions (2.9) for x(j) are those without future dynamics (NWL92-S52 for one equation)."))

#: E = 1 at the first N - 1 steps and 0 at the last, A = 1; rows: equations, columns: x(j+1), x(j+2), ...
AHEAD = matrix_of(i, k, m, m, when((i == k) & (i < N), 1, when(i == k + 1, -1, 0)))
LAST_STEP = matrix_of(i, k, N, N, when((i == k) & (i < N), 1, when(i == k + 1, -1, 0)))
FIRST_COLUMN = column(i, N, when(i == 1, -1, 0))
SUM_OF_ROWS = T(column(i, N, 1))
claim("NWL92-S54", "an equation arbitrarily far ahead can be the first to constrain x(j)",
      forall(m, 1, N - 1, rank(AHEAD) == m) & (SUM_OF_ROWS * LAST_STEP == Zero(1, N)) & (SUM_OF_ROWS * FIRST_COLUMN == -1), sizes=["N"],
      by=[evaluation(N=range(1, 13))],
      note=("x(j+i) = x(j+i-1) + u(j+i-1) for i < N and 0 = x(j+N-1) + u(j+N-1), all of one dimension. The first m < N equations have full row rank in the "
            "future states, so that they do not bear on x(j) (NWL92-S52); the sum of all N is -x(j) = u(j) + ... + u(j+N-1). This is for each N of the list."))

not_checked("NWL92-E6.2", "future dynamics", DEFINITION)

# ------------------------------------------------------------------ elimination of the future states
H2, H3, K, ka, w, y2 = symbols("H2 H3 K ka w y2")
F, V, R = symbols("F V R")
claim("NWL92-E6.3", "future dynamics act as one measurement Fx(j) = w(j)",
      (x0 - P * T(F) * ka == xh) & (V * ka + F * x0 == Zero(g, 1)), sizes=["n", "m", "k", "g"],
      over={P: positive_semidefinite(n), R: positive_semidefinite(k), H2: matrix(k, n), H3: matrix(k, m), K: matrix(g, k), l2: vector(k), ka: vector(g),
            x0: vector(n), x1: vector(m), xh: vector(n)},
      where=[let(F, K * H2), let(V, K * R * T(K))],
      given=[given("first measurement", x0 - P * T(H2) * l2 == xh), given("future dynamics", R * l2 + H2 * x0 + H3 * x1 == Zero(k, 1)),
             given("rows without future states", K * H3 == Zero(g, m)), given("gradient in the future states", l2 == T(K) * ka)],
      by=[order(),
          *[example({"n": 1, "m": 1, "k": 1, "g": 1, P: [[1]], R: [[1]], H2: [[1]], H3: [[0]], K: [[1]], l2: [0], ka: [0], x0: [0], x1: [0], xh: [0], **change})
            for change in ({xh: [1]}, {l2: [1], xh: [-1]}, {H3: [[1]], x0: [1], xh: [1], x1: [-1]}, {R: [[0]], x0: [1], xh: [1]},
                           {l2: [1], x0: [-1], xh: [-2]})],
          instances(made_by={H3: (Identity(k) - T(K) * inv(K * T(K)) * K) * X0, l2: T(K) * ka,
                             H2: -((R * l2 + H3 * x1) * T(x0) * (1 / (T(x0) * x0))) + B * (Identity(n) - x0 * T(x0) * (1 / (T(x0) * x0))), xh: x0 - P * T(H2) * l2},
                    using={X0: matrix(k, m), B: matrix(k, n)}, n=(1, 2), m=(1, 2), k=(2, 3), g=(1, 2))],
      note=("The rows of K span those that annihilate the columns H3 of the future states in (6.4), so that H3'l2 = 0 says l2 = K'ka; H2 is the column of x(j). "
            "The conditions (2.9) for the whole of (6.4), with multipliers l2 and -H2'l2, are then those for 0 = Fx + w, F = KH2, with w of covariance V = KRK'. "
            "Neither depends on j, as (6.4) does not."))

# ------------------------------------------------------------------ rows T_0, T_1, ... with constant T(z)(zE - A)
T0, T1, T2, z, Tt, X, U, W = symbols("T0 T1 T2 z Tt X U W")
PENCIL = {E: matrix(l, n), A: matrix(l, n)}
ROWS = {T0: matrix(g, l), T1: matrix(g, l), T2: matrix(g, l)}
STATES = {x0: vector(n), x1: vector(n), x2: vector(n), x3: vector(n)}
BAND = block([[-A, E, Zero(l, n), Zero(l, n)], [Zero(l, n), -A, E, Zero(l, n)], [Zero(l, n), Zero(l, n), -A, E]])
claim("NWL92-E6.4", "three steps of the dynamics in matrix form",
      iff(BAND * vstack(x0, x1, x2, x3) == vstack(u0, u1, u2), (E * x1 == A * x0 + u0) & (E * x2 == A * x1 + u1) & (E * x3 == A * x2 + u2)), sizes=["l", "n"],
      over={**PENCIL, **STATES, u0: vector(l), u1: vector(l), u2: vector(l)},
      by=[order(), instances(l=(1, 2), n=(1, 2)), instances(made_by={u0: E * x1 - A * x0, u1: E * x2 - A * x1, u2: E * x3 - A * x2}, l=(1, 2), n=(1, 2))],
      note="The matrix goes on without end; three block rows of it show its form.")

TELESCOPE = (T0 * E == T1 * A) & (T1 * E == T2 * A) & (T2 * E == Zero(g, n))
claim("NWL92-E6.5", "rows that leave x(j) alone",
      iff(hstack(T0, T1, T2) * BAND == hstack(-(T0 * A), Zero(g, n), Zero(g, n), Zero(g, n)), TELESCOPE), sizes=["l", "n", "g"], over={**PENCIL, **ROWS},
      by=[order(), instances(l=(1, 2), n=(1, 2), g=(1, 2)),
          *[example({"l": 1, "n": 1, "g": 1, E: [[e]], A: [[a]], T0: [[b]], T1: [[c]], T2: [[d]]})
            for e, a, b, c, d in ((0, 1, 1, 0, 0), (1, 1, 1, 1, 1), (1, 1, 1, 1, 0), (1, 1, 1, 0, 0), (1, 0, 0, 0, 1), (0, 1, 1, 1, 0), (0, 1, 1, 0, 1))]],
      note="A definition; what is checked is what it says of T_0, T_1, T_2 if the others are zero: T_i E = T_(i+1) A.")

Xs, Us = symbols("x u")
claim("NWL92-E6.6", "the sum of the rows T_i of the dynamics at j + i",
      forall(t, 0, N, W[t] == -(Tt[0] * A * Xs[0]) + Tt[t] * A * Xs[t]) & ((Tt[N] == Zero(g, l)) >> (W[N] == -(Tt[0] * A * Xs[0]))), sizes=["l", "n", "g", "N"],
      over={**PENCIL, Tt: sequence_of(matrix(g, l), 0, N), Xs: sequence_of(matrix(n, 1), 0, N), Us: sequence_of(matrix(l, 1), 0, N)},
      where=[rec(W, t, Zero(g, 1), W[t] + Tt[t] * Us[t])],
      given=[given("(6.4)", forall(k, 1, N, Us[k - 1] == E * Xs[k] - A * Xs[k - 1])), given("(6.5)", forall(k, 1, N, Tt[k - 1] * E == Tt[k] * A))],
      by=[induction(), instances(made_by={Us: (k, E * Xs[k + 1] - A * Xs[k]), E: Zero(l, n), Tt: (k, when(k == 0, X, Zero(g, l)))}, using={X: matrix(g, l)},
                                 l=(1, 2), n=(1, 2), g=(1, 2), N=(1, 2, 3))],
      note="W is the sum of the T_i u(j+i) with i < t, and x_i stands for x(j+i). T_N = 0 where T_0, T_1, ... ends.")
