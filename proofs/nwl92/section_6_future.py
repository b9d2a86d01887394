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

from functools import reduce
from operator import and_

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import evaluation, example, induction, instances, order, part, restated
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    block,
    column,
    defined,
    forall,
    given,
    hstack,
    iff,
    inv,
    invertible,
    kernel_basis,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_semidefinite,
    psd,
    rank,
    rational,
    rec,
    scalar,
    schur,
    sequence_of,
    standing,
    symbols,
    symmetric_matrix,
    to_expr,
    vector,
    vstack,
    when,
)
from proofs.nwl92 import notation_system as system
from proofs.nwl92.notation import lower, upper

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
      by=[restated("what no finite number of equations changes, all of them together do not change"), induction(), instances(made_by={mu: (k, Zero(n, 1))}, n=(1, 2), N=(1, 2, 3)),
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
H2, H3, K, ka = symbols("H2 H3 K ka")
F, V, R = symbols("F V R")
claim("NWL92-E6.3", "future dynamics act as one measurement Fx(j) = w(j)",
      (x0 - P * T(F) * ka == xh) & (V * ka + F * x0 == Zero(g, 1)), sizes=["n", "m", "k", "g"],
      over={P: positive_semidefinite(n), R: positive_semidefinite(k), H2: matrix(k, n), H3: matrix(k, m), K: matrix(g, k), l2: vector(k), ka: vector(g),
            x0: vector(n), x1: vector(m), xh: vector(n)},
      where=[let(F, K * H2), let(V, K * R * T(K))],
      given=[given("first measurement", x0 - P * T(H2) * l2 == xh), given("future dynamics", R * l2 + H2 * x0 + H3 * x1 == Zero(k, 1)),
             given("rows without future states", K * H3 == Zero(g, m)), given("gradient in the future states", l2 == T(K) * ka)],
      by=[part("finitely many equations of the future"), order(),
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
T0, T1, T2, z, Tt, W = symbols("T0 T1 T2 z Tt W")
PENCIL = {E: matrix(l, n), A: matrix(l, n)}
ROWS = {T0: matrix(g, l), T1: matrix(g, l), T2: matrix(g, l)}
STATES = {x0: vector(n), x1: vector(n), x2: vector(n), x3: vector(n)}
BAND = block([[-A, E, Zero(l, n), Zero(l, n)], [Zero(l, n), -A, E, Zero(l, n)], [Zero(l, n), Zero(l, n), -A, E]])
claim("NWL92-E6.4", "three steps of the dynamics in matrix form",
      iff(BAND * vstack(x0, x1, x2, x3) == vstack(u0, u1, u2), (E * x1 == A * x0 + u0) & (E * x2 == A * x1 + u1) & (E * x3 == A * x2 + u2)), sizes=["l", "n"],
      over={**PENCIL, **STATES, u0: vector(l), u1: vector(l), u2: vector(l)},
      by=[part("three block rows"), order(), instances(l=(1, 2), n=(1, 2)), instances(made_by={u0: E * x1 - A * x0, u1: E * x2 - A * x1, u2: E * x3 - A * x2}, l=(1, 2), n=(1, 2))],
      note="The matrix goes on without end; three block rows of it show its form.")

TELESCOPE = (T0 * E == T1 * A) & (T1 * E == T2 * A) & (T2 * E == Zero(g, n))
claim("NWL92-E6.5", "rows that leave x(j) alone",
      hstack(T0, T1, T2) * BAND == hstack(-(T0 * A), T0 * E - T1 * A, T1 * E - T2 * A, T2 * E), sizes=["l", "n", "g"], over={**PENCIL, **ROWS},
      by=[part("T(z) of degree two"), order(), instances(l=(1, 2), n=(1, 2), g=(1, 2))],
      note=("A definition; what is checked is what it says of T_0, T_1, T_2 if the others are zero. The columns of x(j+1), x(j+2), ... vanish exactly if "
            "T_i E = T_(i+1) A for all i."))

M, Y, G, R0, S0 = symbols("M Y G R0 S0")
Xs, Us = symbols("x u")
#: zE - A = M(I + zY)R, for which T(z) = G(I + zY)^-1 M^-1; a polynomial if Y is nilpotent
MADE_ROWS = {E: M * Y * R0, A: -M * R0}
FREE_ROWS = {M: nonsingular(l), Y: matrix(l, l), R0: matrix(l, n), G: matrix(g, l)}
NILPOTENT = {Y: S0 * matrix_of(i, k, l, l, when(i < k, X0[i, k], 0)) * inv(S0)}
FREE_NILPOTENT = {M: nonsingular(l), S0: nonsingular(l), X0: matrix(l, l), R0: matrix(l, n), G: matrix(g, l)}


def row(number):
    """T_number of this family."""
    power = G
    for _ in range(number):
        power = power * (-Y)
    return power * inv(M)


SEQUENCES = {Us: (k, E * Xs[k + 1] - A * Xs[k]), Tt: (k, G * (-Y) ** k * inv(M))}
DYNAMICS = given("(6.4)", forall(k, 1, N, Us[k - 1] == E * Xs[k] - A * Xs[k - 1]))
ROWS_65 = given("(6.5)", forall(k, 1, N, Tt[k - 1] * E == Tt[k] * A))
LONG = {"sizes": ["l", "n", "g", "N"],
        "over": {**PENCIL, Tt: sequence_of(matrix(g, l), 0, N), Xs: sequence_of(matrix(n, 1), 0, N), Us: sequence_of(matrix(l, 1), 0, N - 1)}}
SUM_W = rec(W, t, Zero(g, 1), W[t] + Tt[t] * Us[t])
#: x = 1, 1, u = 0 and T_0 = 1, T_1 = 0: not admissible
LONG_ONES = {"l": 1, "n": 1, "g": 1, "N": 1, E: [[1]], A: [[1]], Tt: [[[1]], [[0]]], Xs: [[[1]], [[1]]], Us: [[[0]]]}
LONG_FOILS = [example(LONG_ONES), example({**LONG_ONES, Tt: [[[1]], [[1]]], Us: [[[1]]]})]
LONG_DRAWN = [instances(12, made_by={**MADE_ROWS, **SEQUENCES}, using=FREE_ROWS, l=(1, 2), n=(1, 2), g=(1, 2), N=(1, 2, 3)),
              instances(12, made_by={**NILPOTENT, **MADE_ROWS, **SEQUENCES}, using=FREE_NILPOTENT, l=2, n=(1, 2), g=(1, 2), N=(2, 3))]
claim("NWL92-E6.6", "the sum of the rows T_i of the dynamics at j + i",
      forall(t, 0, N, W[t] == -(Tt[0] * A * Xs[0]) + Tt[t] * A * Xs[t]), **LONG, where=[SUM_W], given=[DYNAMICS, ROWS_65],
      by=[induction(), *LONG_FOILS, *LONG_DRAWN],
      note=("W_t is the sum of the T_i u(j+i) with i < t, and x_i stands for x(j+i). Where T_N = 0 and so on, W_N is the whole sum, and what it is equal to "
            "is -T_0 A x(j), which is of the form (6.3)."))

Tz, Dz, Zp = symbols("Tz Dz Zp")
claim("NWL92-E6.7", "(6.5) as an equation of polynomials",
      forall(t, 0, N, Tz[t] * (z * E - A) == -(Tt[0] * A) + Dz[t] + Zp[t] * (Tt[t] * A)), sizes=["l", "n", "g", "N"],
      over={**PENCIL, Tt: sequence_of(matrix(g, l), 0, N), z: scalar()},
      where=[rec(Zp, t, 1, z * Zp[t]), rec(Tz, t, Zero(g, l), Tz[t] + Zp[t] * Tt[t]),
             rec(Dz, t, Zero(g, n), Dz[t] + z * Zp[t] * (Tt[t] * E - Tt[t + 1] * A))],
      by=[restated("a polynomial is zero exactly if its coefficients are"), induction(), instances(8, l=(1, 2), n=(1, 2), g=(1, 2), N=(1, 2, 3))],
      note=("Zp_t is z^t, Tz_t the sum of the z^i T_i with i < t, and Dz_t that of the z^(i+1) (T_i E - T_(i+1) A). Where T_t is zero, Tz_t is T(z), and T(z)(zE - A) is "
            "-T_0 A + Dz_t, whose coefficients are zero exactly if (6.5) holds."))

POLYNOMIAL = T0 + Z * T1 + Z ** 2 * T2
DRAWN_ROWS = instances(made_by={**NILPOTENT, **MADE_ROWS, T0: row(0), T1: row(1), T2: row(2), F: G * R0},
                       using=FREE_NILPOTENT, l=(2, 3), n=(1, 2), g=(1, 2))
#: E = 0, A = 1, T = 1, F = -1, and what is not constant
ZERO_E = {"l": 1, "n": 1, "g": 1, E: [[0]], A: [[1]], T0: [[1]], T1: [[0]], T2: [[0]], F: [[-1]]}
POLYNOMIAL_FOILS = [example({**ZERO_E, F: [[1]]}), example({**ZERO_E, E: [[1]]}), example({**ZERO_E, E: [[1]], T1: [[1]]}), example({**ZERO_E, T1: [[1]]})]
claim("NWL92-E6.8", "if T(z)(zE - A) is a constant matrix, it is -T_0 A, and it is what future dynamics say about x(j)",
      (F == -(T0 * A)) & (F * x0 == T0 * (E * x1 - A * x0) + T1 * (E * x2 - A * x1) + T2 * (E * x3 - A * x2)), sizes=["l", "n", "g"],
      over={**PENCIL, **ROWS, F: matrix(g, n), **STATES}, given=[given("(6.8)", POLYNOMIAL * (Z * E - A) == F)],
      by=[part("T(z) of degree two"), DRAWN_ROWS, *[example({**foil.hints["values"], **{x: [1] for x in ("x0", "x1", "x2", "x3")}}) for foil in POLYNOMIAL_FOILS]],
      note=("The statement of a problem; what is checked is that its solutions are what is looked for. For T(z) of degree two; u(k) = E x(k+1) - A x(k)."))

not_checked("NWL92-E6.9", "a unimodular matrix and a permutation bring zE - A to the form [N, K; 0, 0]",
            "the Hermite form of a polynomial matrix, whose existence is classical; the matrices that exist here are polynomial matrices of unbounded degree")

# ------------------------------------------------------------------ all of them
r, q, s, p = symbols("r q s p")
S, Kz, Nz, Ta, Tb, F1, F2 = symbols("S Kz Nz Ta Tb F1 F2")
U11, U12, U21, U22, L11, L12, L21, L22, S11, S12, S21, S22, Tc, Td, Fa, Fb = symbols("U11 U12 U21 U22 L11 L12 L21 L22 S11 S12 S21 S22 Tc Td Fa Fb")
SHAPE = block([[Nz, Kz], [Zero(s, r), Zero(s, q)]])
#: zE - A, U(z) and S with rows r + s and columns r + q; T(z) and F
U_Z, L_Z, S_Z = block([[U11, U12], [U21, U22]]), block([[L11, L12], [L21, L22]]), block([[S11, S12], [S21, S22]])
T_Z, F_Z = hstack(Tc, Td), hstack(Fa, Fb)
FORM = given("(6.9)", U_Z * L_Z * S_Z == SHAPE)
HERMITE = {U11: matrix(r, r), U12: matrix(r, s), U21: matrix(s, r), U22: matrix(s, s), L11: matrix(r, r), L12: matrix(r, q), L21: matrix(s, r), L22: matrix(s, q),
           S11: matrix(r, r), S12: matrix(r, q), S21: matrix(q, r), S22: matrix(q, q), Nz: nonsingular(r), Kz: matrix(r, q)}
U_ALL, L_ALL, S_ALL, T_ALL, F_ALL = symbols("U0 L0 S00 Tall Fall")


def parts(whole, names, first, second):
    """Blocks of a matrix with rows of the sizes ``first`` and columns of the sizes ``second``."""
    up, left = ([vstack(Identity(a), Zero(b, a)), vstack(Zero(a, b), Identity(b))] for a, b in (first, second))
    return dict(zip(names, (T(x) * whole * y for x in up for y in left), strict=True))


MADE_L = {L_ALL: inv(U_ALL) * SHAPE * inv(S_ALL), **parts(U_ALL, (U11, U12, U21, U22), (r, s), (r, s)), **parts(S_ALL, (S11, S12, S21, S22), (r, q), (r, q)),
          **parts(L_ALL, (L11, L12, L21, L22), (r, s), (r, q))}
FREE_L = {U_ALL: nonsingular(r + s), S_ALL: nonsingular(r + q)}
POINT_SIZES = {"s": (1, 2), "r": (1, 2), "q": (1, 2), "g": (1, 2)}
POINT_NOTE = "At one z: [L11, L12; L21, L22] is zE - A, [U11, U12; U21, U22] is U(z), Nz and Kz are N(z) and K(z), [Tc, Td] is T(z) and [Fa, Fb] is F. "
SPLIT = given("(6.10b)", T_Z == hstack(Ta, Tb) * U_Z)
EQUATION = given("(6.8)", T_Z * L_Z == F_Z)
F_SPLIT = given("(6.10a)", F_Z * S_Z == hstack(F1, F2))
SPLIT_OVER = {**HERMITE, Nz: matrix(r, r), Tc: matrix(g, r), Td: matrix(g, s), Ta: matrix(g, r), Tb: matrix(g, s), Fa: matrix(g, r), Fb: matrix(g, q), F1: matrix(g, r),
              F2: matrix(g, q)}
SPLIT_GIVEN = [FORM, SPLIT, EQUATION, F_SPLIT]
SPLIT_DRAWN = instances(12, made_by={**MADE_L, T_ALL: hstack(Ta, Tb) * U_Z, Tc: T_ALL * vstack(Identity(r), Zero(s, r)), Td: T_ALL * vstack(Zero(r, s), Identity(s)),
                                     F_ALL: T_ALL * L_ALL, Fa: F_ALL * vstack(Identity(r), Zero(q, r)), Fb: F_ALL * vstack(Zero(r, q), Identity(q)),
                                     F1: Ta * Nz, F2: Ta * Kz}, using=FREE_L, **POINT_SIZES)
IDENTITY = {"s": 1, "r": 1, "q": 1, "g": 1, U11: [[1]], U12: [[0]], U21: [[0]], U22: [[1]], S11: [[1]], S12: [[0]], S21: [[0]], S22: [[1]]}
SPLIT_ONES = {**IDENTITY, L11: [[1]], L12: [[1]], L21: [[0]], L22: [[0]], Nz: [[1]], Kz: [[1]], Tc: [[1]], Td: [[1]], Ta: [[1]], Tb: [[1]], Fa: [[1]], Fb: [[1]],
              F1: [[1]], F2: [[1]]}
SPLIT_FOILS = [example({**SPLIT_ONES, **change}) for change in (
    {L11: [[2]], L12: [[2]], Fa: [[2]], Fb: [[2]], F1: [[2]], F2: [[2]]}, {Ta: [[2]]}, {Fa: [[2]], Fb: [[2]], F1: [[2]], F2: [[2]]}, {F1: [[2]], F2: [[2]]})]
SPLIT_NEEDS = order(lemmas=[hstack(Ta, Tb) * SHAPE == hstack(F1, F2)])
claim("NWL92-E6.10", "what (6.8) says in the parts of (6.10)",
      hstack(Ta, Tb) * SHAPE == hstack(F1, F2), sizes=["s", "r", "q", "g"], over=SPLIT_OVER, given=SPLIT_GIVEN,
      by=[order(), *SPLIT_FOILS, SPLIT_DRAWN], note=POINT_NOTE + "A definition; what is checked is that it turns (6.8) into an equation for the form (6.9).")
claim("NWL92-E6.11a", "first part of (6.8)", Ta * Nz == F1, sizes=["s", "r", "q", "g"], over=SPLIT_OVER, given=SPLIT_GIVEN,
      by=[SPLIT_NEEDS, *SPLIT_FOILS, SPLIT_DRAWN], note=POINT_NOTE)
claim("NWL92-E6.11b", "second part of (6.8)", Ta * Kz == F2, sizes=["s", "r", "q", "g"], over=SPLIT_OVER, given=SPLIT_GIVEN,
      by=[SPLIT_NEEDS, *SPLIT_FOILS, SPLIT_DRAWN], note=POINT_NOTE)

PARTS = {Nz: nonsingular(r), Kz: matrix(r, q), Ta: matrix(g, r), F1: matrix(g, r), F2: matrix(g, q)}
PARTS_GIVEN = [given("(6.11a)", Ta * Nz == F1), given("(6.11b)", Ta * Kz == F2)]
#: r = q = g = 2, where the printed product has a size
TWO = {"r": 2, "q": 2, "g": 2, Nz: [[1, 0], [0, 1]], Kz: [[0, 1], [0, 0]], Ta: [[1, 0], [0, 0]], F1: [[1, 0], [0, 0]], F2: [[0, 1], [0, 0]]}
PARTS_ONES = {"r": 1, "q": 1, "g": 1, Nz: [[1]], Kz: [[1]], Ta: [[1]], F1: [[1]], F2: [[2]]}
PARTS_DRAWN = instances(made_by={F1: Ta * Nz, F2: Ta * Kz}, r=(1, 2), q=(1, 2), g=(1, 2))
WRONG_ORDER = "the factors stand in the wrong order, so that the sizes do not even fit unless {}: by (6.11) N^-1 K stands on the right of F_1"
claim("NWL92-E6.12", "F_1 and F_2 through N and K, as printed",
      Kz * inv(Nz) * F1 == F2, sizes=["r", "q", "g"], over=PARTS, given=PARTS_GIVEN, by=[example(TWO), PARTS_DRAWN],
      repair=repair("order of factors", WRONG_ORDER.format("r = q = g"), F1 * inv(Nz) * Kz == F2, sizes=["r", "q", "g"], over=PARTS, given=PARTS_GIVEN,
                    by=[order(), example(PARTS_ONES), example({**PARTS_ONES, F2: [[1]], F1: [[2]]}), PARTS_DRAWN]))

BOTH = {Nz: nonsingular(r), Kz: matrix(r, q), F1: matrix(g, r), F2: matrix(g, q)}
claim("NWL92-E6.13", "(6.12) as a linear equation for (F_1 F_2), as printed",
      hstack(F1, F2) * vstack(Kz * inv(Nz), -Identity(q)) == Zero(g, q), sizes=["r", "q", "g"], over=PARTS, given=PARTS_GIVEN,
      by=[example({**TWO, Nz: [[1, 1], [0, 1]], Ta: [[1, 0], [0, 0]], F1: [[1, 1], [0, 0]], Kz: [[1, 0], [1, 1]], F2: [[1, 0], [0, 0]]}), PARTS_DRAWN],
      repair=repair("order of factors", WRONG_ORDER.format("r = q"),
                    iff(F1 * inv(Nz) * Kz == F2, hstack(F1, F2) * vstack(inv(Nz) * Kz, -Identity(q)) == Zero(g, q)), sizes=["r", "q", "g"], over=BOTH,
                    by=[order(), instances(made_by={F2: F1 * inv(Nz) * Kz}, r=(1, 2), q=(1, 2), g=(1, 2)), instances(r=(1, 2), q=(1, 2), g=(1, 2))]),
      note="Under (6.11). The corrected statement is the equivalence with (6.12), itself corrected.")

# ------------------------------------------------------------------ constant solutions
K0, K1, B0, B1, p0, p1, p2 = symbols("K0 K1 B0 B1 p0 p1 p2")
half = rational("1/2")
P_Z = p0 + z * p1 + z * z * p2
COEFFICIENTS = [vstack(B0 * K0, -(p0 * Identity(q))), vstack(B0 * K1 + B1 * K0, -(p1 * Identity(q))), vstack(B1 * K1, -(p2 * Identity(q)))]
K_Z = K0 + z * K1
ADJUGATE = [given("N(z) times its adjugate", Nz * (B0 + z * B1) == P_Z * Identity(r)), standing("p(z) is not zero", P_Z != 0)]
OVER_Z = {Nz: nonsingular(r), K0: matrix(r, q), K1: matrix(r, q), B0: matrix(r, r), B1: matrix(r, r), p0: scalar(), p1: scalar(), p2: scalar(), z: scalar()}
ADJUGATE_DRAWN = instances(made_by={B0: P_Z * inv(Nz) - z * B1}, r=(1, 2), q=(1, 2))
ADJUGATE_FOIL = {"q": 1, z: 1, p0: 1, p1: 0, p2: 0}
claim("NWL92-E6.14", "a common denominator, as printed",
      defined(K_Z * inv(Nz)) & (vstack(K_Z * inv(Nz), -Identity(q)) == 1 / P_Z * (z * COEFFICIENTS[1] + z * z * COEFFICIENTS[2])), sizes=["r", "q"], over=OVER_Z,
      given=[*ADJUGATE, given("p = z(p1 + z p2) and B = z B1", (p0 == 0) & (B0 == Zero(r, r)))],
      by=[example({**ADJUGATE_FOIL, "r": 2, p0: 0, p1: 1, Nz: [[1, 0], [0, 1]], K0: [[1], [0]], K1: [[0], [1]], B0: [[0, 0], [0, 0]], B1: [[1, 0], [0, 1]]}),
          instances(made_by={p0: 0 * p1, B0: Zero(r, r), B1: 1 / z * P_Z * inv(Nz)}, r=(1, 2), q=(1, 2))],
      repair=repair("order of factors", WRONG_ORDER.format("r = q") + "; and the sum must begin at i = 0, where (6.15) has it begin, unless p has the factor z",
                    vstack(inv(Nz) * K_Z, -Identity(q)) == 1 / P_Z * (COEFFICIENTS[0] + z * COEFFICIENTS[1] + z * z * COEFFICIENTS[2]), sizes=["r", "q"],
                    over=OVER_Z, given=ADJUGATE,
                    by=[part("K(z) and the adjugate of degree one"), order(), example({**ADJUGATE_FOIL, "r": 1, Nz: [[1]], K0: [[1]], K1: [[0]], B0: [[2]], B1: [[0]]}), ADJUGATE_DRAWN]),
      note=("At one z, for K and the adjugate B of N of degree one and m = 2; p is det N or a multiple of it. In the print p and B are taken with a factor z, so "
            "that a sum from i = 1 is possible; the product K N^-1 has no size for r other than q."))

L0, L1, L2 = symbols("L0 L1 L2")
AT, AT_0, AT_1, AT_MINUS = (F * (L0 + x * L1 + x * x * L2) for x in (z, to_expr(0), to_expr(1), to_expr(-1)))
ALL_L = hstack(L0, L1, L2)
claim("NWL92-E6.15", "a constant matrix annihilates a polynomial matrix exactly if it annihilates its coefficients",
      (AT == F * ALL_L * vstack(Identity(q), z * Identity(q), z * z * Identity(q)))
      & (F * ALL_L == hstack(AT_0, half * (AT_1 - AT_MINUS), half * (AT_1 + AT_MINUS) - AT_0)), sizes=["k", "q", "g"],
      over={F: matrix(g, k), L0: matrix(k, q), L1: matrix(k, q), L2: matrix(k, q), z: scalar()},
      by=[part("m = 2"), order(), instances(k=(1, 2), q=(1, 2), g=(1, 2))],
      note=("For m = 2, F for (F_1 F_2): the polynomial through the coefficients, and the coefficients through its values at 0, 1, -1; so one is zero exactly if the "
            "other is. L_0 is the coefficient of z^0, which the sum in (6.14) leaves out. The displays (6.13) and (6.14) are dealt with there."))

# ------------------------------------------------------------------ the largest of them
Fw, Ft1, Ft2, Wt, Gm, Xt = symbols("Fw Ft1 Ft2 Wt Gm Xt")
not_checked("NWL92-E6.16", "the largest constant solution, and the largest part of it that N divides", DEFINITION)

claim("NWL92-E6.17", "W (F_1~ F_2~) is admissible, and every admissible matrix is a multiple of it",
      (Wt * Ft1 * inv(Nz) * Kz == Wt * Ft2) & (F_Z == Xt * hstack(Wt * Ft1, Wt * Ft2)), sizes=["r", "q", "g", "k", "m"],
      over={Nz: nonsingular(r), Kz: matrix(r, q), Ft1: matrix(k, r), Ft2: matrix(k, q), Wt: matrix(m, k), Fa: matrix(g, r), Fb: matrix(g, q), Gm: matrix(g, k), Xt: matrix(g, m)},
      given=[given("(F_1~ F_2~) solves (6.13)", Ft1 * inv(Nz) * Kz == Ft2), given("of highest rank", F_Z == Gm * hstack(Ft1, Ft2)),
             given("W of highest rank", Gm == Xt * Wt)],
      by=[part("the consequence of highest rank, which is said by factors"), order(), *[example({**{"r": 1, "q": 1, "g": 1, "k": 1, "m": 1, Nz: [[1]], Kz: [[1]], Ft1: [[1]], Ft2: [[1]], Wt: [[1]], Fa: [[1]], Fb: [[1]], Gm: [[1]], Xt: [[1]]},
                              **change}) for change in ({Ft2: [[2]], Fb: [[2]]}, {Fa: [[2]], Fb: [[2]]}, {Gm: [[2]], Fa: [[2]], Fb: [[2]]})],
          instances(made_by={Ft2: Ft1 * inv(Nz) * Kz, Gm: Xt * Wt, Fa: Gm * Ft1, Fb: Gm * Ft2}, r=(1, 2), q=(1, 2), g=(1, 2), k=(1, 2), m=(1, 2))],
      note=("At one z. Any solution [Fa, Fb] of (6.15) is a combination Gm of the rows of (F_1~ F_2~), whose rank is highest; if N divides its first part, the rows of Gm are "
            "combinations Xt of those of W. So no admissible matrix has a higher rank than the multiple."))

claim("NWL92-E6.18", "F from (F_1 F_2)", iff(Fw * S == Gm, Fw == Gm * inv(S)), sizes=["g", "k"],
      over={Fw: matrix(g, k), Gm: matrix(g, k), S: nonsingular(k)},
      by=[order(), instances(g=(1, 2), k=(1, 2)), instances(made_by={Gm: Fw * S}, g=(1, 2), k=(1, 2, 3))], note="(6.10a) solved for F.")

#: what is said at one z is meant for all
AT_EVERY_POINT = restated("polynomials that agree at all but finitely many points agree")
PERMUTATION = given("S S' = I", S_Z * T(S_Z) == Identity(r + q))
#: rotations in the place of permutations
TURN = {S_ALL: inv(Identity(r + q) + X0 - T(X0)) * (Identity(r + q) - X0 + T(X0)), L_ALL: inv(U_ALL) * SHAPE * T(S_ALL),
        **parts(U_ALL, (U11, U12, U21, U22), (r, s), (r, s)), **parts(S_ALL, (S11, S12, S21, S22), (r, q), (r, q)),
        **parts(L_ALL, (L11, L12, L21, L22), (r, s), (r, q))}
FREE_TURN = {U_ALL: nonsingular(r + s), X0: matrix(r + q, r + q)}
POINT_ONES = {**IDENTITY, L11: [[1]], L12: [[1]], L21: [[0]], L22: [[0]], Nz: [[1]], Kz: [[1]]}
FOUND = {**HERMITE, F1: matrix(g, r), F2: matrix(g, q), Tb: matrix(g, s)}
claim("NWL92-E6.19", "T(z) from (F_1 F_2), whatever T_2(z) is",
      hstack(F1 * inv(Nz), Tb) * U_Z * L_Z == hstack(F1, F2) * T(S_Z), sizes=["s", "r", "q", "g"], over=FOUND,
      given=[FORM, PERMUTATION, given("(6.12), corrected", F1 * inv(Nz) * Kz == F2)],
      by=[AT_EVERY_POINT, order(lemmas=[U_Z * L_Z == SHAPE * T(S_Z)]),
          *[example({**POINT_ONES, F1: [[1]], F2: [[1]], Tb: [[1]], **change}) for change in (
              {L11: [[2]]}, {S11: [[2]], S22: [[2]], L11: [["1/2"]], L12: [["1/2"]]}, {F2: [[2]]})],
          instances(12, made_by={**TURN, F2: F1 * inv(Nz) * Kz}, using=FREE_TURN, s=(1, 2), r=(1, 2), q=(1, 2), g=(1, 2))],
      note=POINT_NOTE + "F is (F_1 F_2)S^-1 of (6.18), with S' for the inverse of the permutation S; T_2(z) is Tb. (6.16) makes T(z) polynomial.")

# ------------------------------------------------------------------ compatibility
Q11, Q12, Q22, Y11, Y12, Y21, Y22 = symbols("Q11 Q12 Q22 Y11 Y12 Y21 Y22")
v0, v1 = symbols("v0 v1")
ANSWERS = [symbols(f"{name}0 {name}1 {name}2 {name}3") for name in ("Xa", "Xb", "Xc")]


def answers(states, place):
    """The dynamics with input Q at this step and none at the others."""
    return [E * states[step + 1] - A * states[step] == (Q if step == place else Zero(l, l)) for step in range(3)]


PULSES = [answers(states, place) for place, states in enumerate(ANSWERS)]
CONSISTENT = given("consistent for the inputs that Q has", reduce(and_, (equation for some in PULSES for equation in some)))
LEFT_KERNEL = given("T(z)(zE - A) = 0", (T0 * A == Zero(g, n)) & TELESCOPE)
STATE_LIST = {state: matrix(n, l) for states in ANSWERS for state in states}
#: l = 2: one equation with a right inverse of E, and one without states and noise, in other coordinates
EA, AA, QA, TA, TB_, TC, EI = symbols("EA AA QA TA TB TC EI")
TOP_ROW, BOTTOM_ROW = vstack(1, 0), hstack(0, 1)
TWO_ROWS = {M: nonsingular(2), EA: matrix(1, n), AA: matrix(1, n), QA: scalar(), TA: matrix(g, 1), TB_: matrix(g, 1), TC: matrix(g, 1)}
MADE_TWO = {E: M * TOP_ROW * EA, A: M * TOP_ROW * AA, Q: M * TOP_ROW * (QA * QA) * T(TOP_ROW) * T(M), EI: T(EA) * inv(EA * T(EA)),
            T0: TA * BOTTOM_ROW * inv(M), T1: TB_ * BOTTOM_ROW * inv(M), T2: TC * BOTTOM_ROW * inv(M),
            **{states[step]: (Zero(n, 1) if step <= place else (EI, EI * AA * EI, EI * AA * EI * AA * EI)[step - place - 1]) * (T(TOP_ROW) * inv(M) * Q)
               for place, states in enumerate(ANSWERS) for step in range(4)}}
PULSE_ONES = {"l": 1, "n": 1, "g": 1, E: [[0]], A: [[0]], Q: [[1]], T0: [[1]], T1: [[0]], T2: [[0]], **{state: [[0]] for state in STATE_LIST}}
claim("NWL92-E6.20", "consistency for all inputs requires the compatibility condition",
      (T0 * Q == Zero(g, l)) & (T1 * Q == Zero(g, l)) & (T2 * Q == Zero(g, l)), sizes=["l", "n", "g"],
      over={**PENCIL, Q: positive_semidefinite(l), **ROWS, **STATE_LIST}, given=[LEFT_KERNEL, CONSISTENT],
      by=[part("T(z) of degree two"), order(), *[example({**PULSE_ONES, T0: [[0]], **change}) for change in ({T0: [[1]]}, {T1: [[1]]}, {T2: [[1]]})],
          example({**PULSE_ONES, E: [[1]], T0: [[1]], **{states[place + 1]: [[1]] for place, states in enumerate(ANSWERS)}}),
          instances(8, made_by=MADE_TWO, using=TWO_ROWS, l=2, n=(1, 2), g=(1, 2))],
      note=("For T(z) of degree two: T(z)(zE - A) = 0 gives T(z)Q = 0 if the dynamics have solutions (Xa0, ..., Xa3), Xb, Xc for the inputs Q at one of three steps, as columns. "
            "Inputs with covariance Q lie in its range."))

COMPATIBLE = given("(6.20)", block([[Q11, Q12], [T(Q12), Q22]]) == L_Z * block([[Y11, Y12], [Y21, Y22]]))
COMPATIBLE_OVER = {**FOUND, Q11: symmetric_matrix(r), Q12: matrix(r, s), Q22: symmetric_matrix(s), Y11: matrix(r, r), Y12: matrix(r, s), Y21: matrix(q, r),
                   Y22: matrix(q, s)}
Q_ALL, Y_ALL, Yf, Y0 = symbols("Qall Yall Yf Y0")
MADE_COMPATIBLE = {**TURN, Y_ALL: Yf * T(L_ALL), Q_ALL: L_ALL * Y_ALL, Q11: T(vstack(Identity(r), Zero(s, r))) * Q_ALL * vstack(Identity(r), Zero(s, r)),
                   Q12: T(vstack(Identity(r), Zero(s, r))) * Q_ALL * vstack(Zero(r, s), Identity(s)),
                   Q22: T(vstack(Zero(r, s), Identity(s))) * Q_ALL * vstack(Zero(r, s), Identity(s)), **parts(Y_ALL, (Y11, Y12, Y21, Y22), (r, q), (r, s))}
FREE_COMPATIBLE = {**FREE_TURN, Yf: positive_semidefinite(r + q)}
COMPATIBLE_ONES = {**POINT_ONES, F1: [[1]], F2: [[1]], Tb: [[1]], Q11: [[0]], Q12: [[0]], Q22: [[0]], Y11: [[0]], Y12: [[0]], Y21: [[0]], Y22: [[0]]}
COMPATIBLE_FOILS = [example({**COMPATIBLE_ONES, L21: [[1]], Q11: [[1]], Q12: [[1]], Q22: [[1]], Y11: [[1]], Y12: [[1]]}), example({**COMPATIBLE_ONES, Q22: [[1]]}),
                    example({**COMPATIBLE_ONES, S11: [[0]], S22: [[0]], L21: [[1]], Q11: [[1]], Q12: [[1]], Q22: [[1]], Y11: [[1]], Y12: [[1]]})]
COMPATIBLE_DRAWN = instances(12, made_by=MADE_COMPATIBLE, using=FREE_COMPATIBLE, s=(1, 2), r=(1, 2), q=(1, 2), g=(1, 2))
COMPATIBLE_NOTE = (POINT_NOTE + "(6.20) says that the range of Q lies in that of zE - A, here by Q = (zE - A)Y; T_2(z) is Tb. S is taken with S S' = I.")
NOISE_Q = block([[Q11, Q12], [T(Q12), Q22]])
ONLY_T2, WITH_T2, WITHOUT = hstack(Zero(g, r), Tb), hstack(F1 * inv(Nz), Tb), hstack(F1 * inv(Nz), Zero(g, s))
COMPATIBLE_GIVEN = [FORM, PERMUTATION, COMPATIBLE]
FROM_FORM = order(lemmas=[U_Z * L_Z == SHAPE * T(S_Z)])
#: U = [I, 0; U21, I] and S = I
PLAIN = {U11: Identity(r), U12: Zero(r, s), U22: Identity(s), S11: Identity(r), S12: Zero(r, q), S21: Zero(q, r), S22: Identity(q), L11: Nz, L12: Kz,
         L21: -U21 * Nz, L22: -U21 * Kz, Y11: Y0 * T(Nz), Y12: -Y0 * T(Nz) * T(U21), Y21: Zero(q, r), Y22: Zero(q, s), Q11: Nz * Y11, Q12: Nz * Y12, Q22: L21 * Y12}
claim("NWL92-E6.21", "what T_2(z) adds annihilates the noise",
      ONLY_T2 * U_Z * NOISE_Q == Zero(g, r + s), sizes=["s", "r", "q", "g"], over=COMPATIBLE_OVER, given=COMPATIBLE_GIVEN,
      by=[AT_EVERY_POINT, FROM_FORM, *COMPATIBLE_FOILS, instances(12, made_by=PLAIN, using={Y0: symmetric_matrix(r)}, s=(1, 2), r=(1, 2), q=1, g=(1, 2))], note=COMPATIBLE_NOTE)

claim("NWL92-S56", "neither F nor the noise depends on T_2(z)",
      (WITH_T2 * U_Z * L_Z == WITHOUT * U_Z * L_Z) & (WITH_T2 * U_Z * NOISE_Q == WITHOUT * U_Z * NOISE_Q), sizes=["s", "r", "q", "g"],
      over=COMPATIBLE_OVER, given=COMPATIBLE_GIVEN, by=[AT_EVERY_POINT, FROM_FORM, *COMPATIBLE_FOILS, COMPATIBLE_DRAWN], note=COMPATIBLE_NOTE)

DETECTABLE = given("detectable", (system.Le * system.E + system.Lc * system.C == Identity(n)) & schur(system.Le * system.A))
S55_OVER = {**system.SYSTEM, system.Le: matrix(n, l), system.Lc: matrix(n, p), **system.STABILIZER, v0: matrix(1, l), v1: matrix(1, l)}
#: E = (1; 0), A = 0, C = 0, Q and R identities: the second equation is 0 = u_2
OVERDETERMINED = {"l": 2, "p": 1, "n": 1, E: [[1], [0]], A: [[0], [0]], "C": [[0]], Q: [[1, 0], [0, 1]], "S": [[0], [0]], R: [[1]], "Le": [[1, 0]], "Lc": [[0]],
                  "Na": [[0, 0]], "Nb": [[0]], "Ma": [[1, 0], [0, 1]], "Mb": [[0], [0]], "Mc": [[0, 0]], "Md": [[1]], v0: [[0, 1]], v1: [[0, 0]]}
claim("NWL92-S55", "detectable and stabilizable systems satisfy the compatibility condition, as the sentence implies",
      (v0 + Z * v1) * Q == Zero(1, l), sizes=["l", "p", "n"], over=S55_OVER,
      given=[system.NOISE, DETECTABLE, system.STABILIZABLE, given("v(z)(zE - A) = 0", (v0 + Z * v1) * (Z * E - A) == Zero(1, n))],
      by=[example(OVERDETERMINED), instances(8, made_by=system.RANDOM_NOISE, using=system.RANDOM_NOISE_FREE, l=(1, 2), p=1, n=1)],
      repair=repair("missing hypothesis", ("sections III to V allow more equations than unknowns, with noise in all of them, and neither detectability nor stabilizability "
                                           "excludes a row that annihilates zE - A and not Q; (6.20) is an assumption of its own, which holds if zE - A has full row rank"),
                    v0 * Q == Zero(1, l), sizes=["l", "n"], over={Gb: matrix(l, n), Q: positive_semidefinite(l), v0: matrix(1, l)},
                    given=[given("full row rank", rank(Gb) == l), given("v(zE - A) = 0", v0 * Gb == Zero(1, n))],
                    by=[restated("a polynomial with infinitely many zeros is zero"), order(), example({"l": 1, "n": 1, Gb: [[0]], Q: [[1]], v0: [[1]]}), example({"l": 1, "n": 1, Gb: [[1]], Q: [[1]], v0: [[1]]}),
                        instances(made_by={v0: Zero(1, l)}, l=(1, 2), n=(2, 3))]),
      note=("Read as: what sections IV and V assume implies (6.20), v(z) of degree one. No result of these sections uses it: an equation 0 = u is a measurement "
            "of nothing there. In the corrected statement Gb is zE - A at a z where it has full row rank. " + system.CERTIFICATES))

# ------------------------------------------------------------------ the equivalent measurement
INDEX = "the sum must begin at i = 0: T(z) has a constant term, without which F = -T_0 A would be zero"
FINITE = {**PENCIL, **ROWS}
#: E = 0, A = -1: x = u, T = 1, F = 1
NOW = {"l": 1, "n": 1, "g": 1, E: [[0]], A: [[-1]], T0: [[1]], T1: [[0]], T2: [[0]]}
TELESCOPED = given("(6.8)", TELESCOPE)
INPUTS = [E * x1 - A * x0, E * x2 - A * x1, E * x3 - A * x2]
MADE_T = {**NILPOTENT, **MADE_ROWS, T0: row(0), T1: row(1), T2: row(2)}
T_DRAWN = instances(12, made_by=MADE_T, using=FREE_NILPOTENT, l=(2, 3), n=(1, 2), g=(1, 2))
SUM_FROM_1, V_FROM_1 = T1 * INPUTS[1] + T2 * INPUTS[2], T1 * Q * T(T1) + T2 * Q * T(T2)
claim("NWL92-E6.22", "the measurement that future dynamics amount to, as printed with a sum from i = 1",
      -(T0 * A) * x0 == SUM_FROM_1, sizes=["l", "n", "g"], over={**FINITE, **STATES}, given=[TELESCOPED],
      by=[example({**NOW, x0: [1], x1: [0], x2: [0], x3: [0]}), T_DRAWN],
      repair=repair("index", INDEX, forall(t, 0, N, W[t] == -(Tt[0] * A * Xs[0]) + Tt[t] * A * Xs[t]), **LONG, where=[SUM_W], given=[DYNAMICS, ROWS_65],
                    by=[induction(), *LONG_FOILS, *LONG_DRAWN]),
      note=("F = -T_0 A; u(j+i) = E x(j+i+1) - A x(j+i). In the print p = 2. In the corrected statement W_t is the sum of the T_i u(j+i) with i < t, for any degree of T(z): "
            "at t = p + 1, where T_t is zero, it is F x(j). The letter p is the number of measurements before, and the degree of T(z) here."))

ALL_T = hstack(T0, T1, T2)
NOISE_3 = block([[Q, Zero(l, l), Zero(l, l)], [Zero(l, l), Q, Zero(l, l)], [Zero(l, l), Zero(l, l), Q]])
claim("NWL92-E6.23", "the covariance of w, as printed with a sum from i = 1",
      ALL_T * NOISE_3 * T(ALL_T) == V_FROM_1, sizes=["l", "n", "g"], over={**FINITE, Q: positive_semidefinite(l)}, given=[standing("(6.8)", TELESCOPE)],
      by=[example({**NOW, Q: [[1]]}), T_DRAWN],
      repair=repair("index", INDEX, ALL_T * NOISE_3 * T(ALL_T) == T0 * Q * T(T0) + V_FROM_1, sizes=["l", "g"],
                    over={**ROWS, Q: positive_semidefinite(l)}, by=[part("T(z) of degree two"), order(), instances(l=(1, 2), g=(1, 2))]),
      note="w is the sum of the T_i u(j+i), with white u of covariance Q; p = 2.")

# ------------------------------------------------------------------ the conclusions
C, lam1, lam2, Qs = symbols("C lam1 lam2 Qs")
LAM, HI = vstack(lam1, lam2), vstack(Identity(n), C)
FLIP, AHEAD_A = block([[Identity(n), Zero(n, p)], [Zero(p, n), -Identity(p)]]), vstack(A, Zero(p, n))
BY_FORM = FLIP * block([[Q, S], [T(S), R]]) * FLIP + AHEAD_A * P * T(AHEAD_A)
ENERGY_57 = T(LAM) * BY_FORM * LAM
claim("NWL92-S57", "for E = I ordinary inverses suffice where perfect information is not redundant",
      (lam1 == Zero(n, 1)) & (lam2 == Zero(p, 1)) & (x0 == Zero(n, 1)), sizes=["n", "p"],
      over={A: matrix(n, n), P: positive_semidefinite(n), Q: symmetric_matrix(n), S: matrix(n, p), R: symmetric_matrix(p), C: matrix(p, n), lam1: vector(n),
            lam2: vector(p), x0: vector(n)},
      given=[standing("(4.3)", psd(block([[Q, S], [T(S), R]]))),
             given("full row rank", rank(block([[A * P * T(A) + Q, -S, Identity(n)], [-T(S), R, C]])) == n + p),
             given("null vector", block([[A * P * T(A) + Q, -S, Identity(n)], [-T(S), R, C], [Identity(n), T(C), Zero(n, n)]]) * vstack(lam1, lam2, x0)
                   == Zero(n + p + n, 1))],
      by=[order([], [], [ENERGY_57], [], [], lemmas=[T(HI) * LAM == Zero(n, 1), ENERGY_57 * Identity(1) == Zero(1, 1), BY_FORM * LAM == Zero(n + p, 1),
                                                     x0 == Zero(n, 1), LAM == Zero(n + p, 1)]),
          *[example({"n": 1, "p": 1, A: [[0]], P: [[0]], Q: [[0]], S: [[0]], R: [[0]], C: [[0]], lam1: [0], lam2: [0], x0: [0], **change})
            for change in ({lam2: [1]}, {R: [[1]], lam1: [1]}, {R: [[1]], x0: [1]}, {R: [[1]], lam2: [1]})],
          instances(made_by={Q: T(upper(n, p)) * Qs * upper(n, p), S: T(upper(n, p)) * Qs * lower(n, p), R: T(lower(n, p)) * Qs * lower(n, p), lam1: Zero(n, 1),
                             lam2: Zero(p, 1), x0: Zero(n, 1)}, using={Qs: positive_semidefinite(n + p)}, n=(1, 2), p=(1, 2))],
      note=("The 3-block matrix of Theorem 3.1 with E = I has no null vector (lam1; lam2; x0) but zero if past and present do not supply redundant perfect information; the "
            "condition has the sign of S that the matrix has (NWL92-T3.1.1). What others' solutions require is not decided."))
