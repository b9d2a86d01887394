# SPDX-License-Identifier: MIT
"""Section II, second half: estimates in place of measurements, dropping measurements, more noise.

Three facts make maximum likelihood estimation recursive.

First, measurements a = Hx + v of x may be replaced by their estimate. Let
b = Jx + Kz + w with w independent of v. Writing down the stationarity
conditions for (a, b) and those for (xh1, b), where xh1 = x + u is the estimate
of x from a with its error covariance P1, one passes from the second set to
the first by the multiplier lam_a = lam_1a + U1 lam_1: the identities
V U1 = H P1 and H'U1 = I of the first estimation problem do it.

Second, measurements y2 = H2 x1 + H3 x2 + v2 may be dropped as far as x1 is
concerned if H3 has full row rank: the multiplier of y2 satisfies
H3'lam_2 = 0, so it is zero, and what remains are the conditions for y1 alone.

Third, more noise gives more error: the gain that is best for the larger noise
is unbiased for the smaller one as well, does no better there than the best
gain, and no worse than with the larger noise.

In the claims, gains and covariances are blocks of arbitrary symmetric
(1)-inverses, and data lie in the range of [R H], where they lie with
probability one.
"""

from __future__ import annotations

from exactkf.claims import claim
from exactkf.evidence import combination, example, identity, instances, order
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    diag,
    eq,
    given,
    hstack,
    inv,
    invertible,
    kernel_basis,
    let,
    loewner,
    matrix,
    positive_semidefinite,
    psd,
    rank,
    standing,
    sym,
    symbols,
    symmetric_matrix,
    vector,
    vstack,
)
from proofs.nwl92.notation import (
    FULL_COLUMN_RANK,
    GRAM,
    H,
    any_one_inverse,
    any_rank_identities,
    block_identities,
    chained,
    every_size,
    lower,
    made_inverse,
    n,
    p,
    q,
    two_block,
    upper,
)

V, W, J, K, m, a, b, v, w, x, z = symbols("V W J K m a b v w x z")
Z1, Zb, Zs, G1, Gb, Gs, Y1, Yb, Ys = symbols("Z1 Zb Zs G1 Gb Gs Y1 Yb Ys")
W1, U1, T1, P1, xh1 = symbols("W1 U1 T1 P1 xh1")
h, X = symbols("h X")


def some_inverse(G, Z, Y, size):
    """What `instances` needs for a random symmetric (1)-inverse G of Z."""
    name = G.tree[1]
    kernel = sym(f"ker{name}")
    return {kernel: kernel_basis(Z), G: any_one_inverse(Z, Y, kernel)}, {Y: matrix(size, size)}


def together(*parts, count=16, before=None, made_by=None, using=None, **sizes):
    """Instances with several such inverses, in this order."""
    made, free = dict(before or {}), dict(using or {})
    for first, second in parts:
        made.update(first)
        free.update(second)
    return instances(count, made_by={**made, **(made_by or {})}, using=free, **sizes)


def is_inverse(G, Z, of):
    """Hypothesis that G is a symmetric (1)-inverse of Z."""
    return given(f"(1)-inverse, {of}", Z * G * Z == Z)


# ------------------------------------------------------------------ Lemma 2.3
L = sym("L")
claim("NWL92-E2.28", "an unbiased estimate of x from a is x with an error that does not depend on x",
      L * (H * x + v) == x + L * v, sizes=["p", "n"], over={H: matrix(p, n), L: matrix(n, p), x: vector(n), v: vector(p)},
      given=[given("La is unbiased", L * H == Identity(n))],
      by=[order(), instances(made_by={L: inv(T(H) * H) * T(H) + X * (Identity(p) - H * inv(T(H) * H) * T(H))}, using={X: matrix(n, p)}, p=(1, 2, 3), n=(1, 2))],
      note="A definition; what is checked is the form in which estimates of x are measurements of x again, as in (2.30).")

claim("NWL92-E2.29", "a and b together are one measurement of x and z",
      vstack(H * x + v, J * x + K * z + w) == block([[H, Zero(p, m)], [J, K]]) * vstack(x, z) + vstack(v, w),
      sizes=["p", "q", "n", "m"],
      over={H: matrix(p, n), J: matrix(q, n), K: matrix(q, m), x: vector(n), z: vector(m), v: vector(p), w: vector(q)},
      by=[identity(p=(1, 2), q=(1, 2), n=(1, 2), m=(1, 2)), instances(p=(1, 2), q=(1, 2), n=(1, 2), m=(1, 2))],
      note="A definition; what is checked is the form (2.1) that the batch system (2.31) is made from.")

MODEL = {V: positive_semidefinite(p), W: positive_semidefinite(q), H: matrix(p, n), J: matrix(q, n), K: matrix(q, m)}
HB, RB = block([[H, Zero(p, m)], [J, K]]), diag(V, W)
HS = block([[Identity(n), Zero(n, m)], [J, K]])
gains = sym("gains")
SIZES = {"p": (1, 2, 3), "q": (1, 2), "n": (1, 2), "m": (1, 2)}
WAYS = [is_inverse(G1, Z1, "x from a"), is_inverse(Gb, Zb, "x and z from a and b"),
        is_inverse(Gs, Zs, "x and z from the estimate and b")]




#: gains of both ways and the multipliers' part beside them, by blocks
Uax, Uaz, Ubx, Ubz, Txx, Txz, Tzz, Sxx, Sxz, Sbx, Sbz, Qxx, Qxz, Qzz = symbols("Uax Uaz Ubx Ubz Txx Txz Tzz Sxx Sxz Sbx Sbz Qxx Qxz Qzz")
UB, TB = block([[Uax, Uaz], [Ubx, Ubz]]), block([[Txx, Txz], [T(Txz), Tzz]])
US, TS = block([[Sxx, Sxz], [Sbx, Sbz]]), block([[Qxx, Qxz], [T(Qxz), Qzz]])
R_BATCH = block([[V, Zero(p, q)], [Zero(q, p), W]])
R_SUMMARY = block([[P1, Zero(n, q)], [Zero(q, n), W]])
ALL_COLUMNS = block([[Identity(n), Zero(n, m)], [Zero(m, n), Identity(m)]])
GAINS_BY_BLOCKS = {U1: matrix(p, n), T1: symmetric_matrix(n), Uax: matrix(p, n), Uaz: matrix(p, m), Ubx: matrix(q, n), Ubz: matrix(q, m),
                   Txx: symmetric_matrix(n), Txz: matrix(n, m), Tzz: symmetric_matrix(m), Sxx: matrix(n, n), Sxz: matrix(n, m), Sbx: matrix(q, n),
                   Sbz: matrix(q, m), Qxx: symmetric_matrix(n), Qxz: matrix(n, m), Qzz: symmetric_matrix(m)}
GAINS_GIVEN = [given("(2.25) for x from a", (V * U1 + H * T1 == Zero(p, n)) & (T(H) * U1 == Identity(n))),
               given("(2.25) for x and z from a and b", (R_BATCH * UB + HB * TB == Zero(p + q, n + m)) & (T(HB) * UB == ALL_COLUMNS)),
               given("(2.25) for x and z from the estimate and b",
                     (R_SUMMARY * US + HS * TS == Zero(n + q, n + m)) & (T(HS) * US == ALL_COLUMNS))]
#: both gains on (a, b); R_BATCH as a sum that is semidefinite by its form
COMPOSED = block([[U1 * Sxx, U1 * Sxz], [Sbx, Sbz]])
BETWEEN = UB - COMPOSED
BY_FORM = upper(p, q) * V * T(upper(p, q)) + lower(p, q) * W * T(lower(p, q))
SAME_GAIN = [R_BATCH * COMPOSED + HB * TS == Zero(p + q, n + m), T(HB) * BETWEEN == Zero(n + m, n + m),
             T(BETWEEN) * BY_FORM * BETWEEN * ALL_COLUMNS == Zero(n + m, n + m), BY_FORM * BETWEEN == Zero(p + q, n + m)]


def two_blocks(a, b, c):
    """[a, b; b', c]."""
    return block([[a, b], [T(b), c]])


def corners(G, names, rows, cols):
    """Blocks of G between coordinates: made_by for the names."""
    return {name: T(row) * G * col for name, row, col in zip(names, rows, cols, strict=True)}


def coordinates(*sizes):
    """Columns of the identity for consecutive coordinates of these sizes."""
    return [vstack(*(Identity(size) if i == j else Zero(other, size) for j, other in enumerate(sizes))) for i, size in enumerate(sizes)]


AT_A, AT_B, AT_X, AT_Z = coordinates(p, q, n, m)
AT_1, AT_2, AT_X2, AT_Z2 = coordinates(n, q, n, m)
BATCH_Z, SUMMARY_Z, BATCH_G, SUMMARY_G = symbols("Zbatch Zsummary Gbatch Gsummary")
LEMMA_MADE = {
    Z1: two_block(V, H, n), **some_inverse(G1, Z1, Y1, p + n)[0], U1: T(upper(p, n)) * G1 * lower(p, n), T1: T(lower(p, n)) * G1 * lower(p, n),
    P1: T(U1) * V * U1, BATCH_Z: two_block(RB, HB, n + m), **some_inverse(BATCH_G, BATCH_Z, Yb, p + q + n + m)[0],
    **corners(BATCH_G, (Uax, Uaz, Ubx, Ubz, Txx, Txz, Tzz), (AT_A, AT_A, AT_B, AT_B, AT_X, AT_X, AT_Z), (AT_X, AT_Z, AT_X, AT_Z, AT_X, AT_Z, AT_Z)),
    SUMMARY_Z: two_block(diag(P1, W), HS, n + m), **some_inverse(SUMMARY_G, SUMMARY_Z, Ys, n + q + n + m)[0],
    **corners(SUMMARY_G, (Sxx, Sxz, Sbx, Sbz, Qxx, Qxz, Qzz), (AT_1, AT_1, AT_2, AT_2, AT_X2, AT_X2, AT_Z2),
              (AT_X2, AT_Z2, AT_X2, AT_Z2, AT_X2, AT_Z2, AT_Z2))}
LEMMA_FREE = {Y1: matrix(p + n, p + n), Yb: matrix(p + q + n + m, p + q + n + m), Ys: matrix(n + q + n + m, n + q + n + m)}


#: all sizes one, noises of covariance one, H = J = K = 1; not admissible: what each of the three gains is for
GAIN_ONES = {"p": 1, "q": 1, "n": 1, "m": 1, V: [[1]], W: [[1]], H: [[1]], J: [[1]], K: [[1]], x: [1], z: [1], v: [1], w: [1], U1: [[1]], T1: [[-1]],
             Uax: [[1]], Uaz: [[-1]], Ubx: [[0]], Ubz: [[1]], Txx: [[-1]], Txz: [[1]], Tzz: [[-2]], Sxx: [[1]], Sxz: [[-1]], Sbx: [[0]], Sbz: [[1]],
             Qxx: [[-1]], Qxz: [[1]], Qzz: [[-2]]}
LARGER_P1, OTHER_SUMMARY = {Qxx: [[-4]], Qxz: [[4]], Qzz: [[-5]]}, {Sxx: [[2]], Sxz: [[5]]}
GAIN_FOILS = [example({**GAIN_ONES, **change}) for change in ({U1: [[2]], **LARGER_P1}, {Uax: [[2]], Uaz: [[5]]}, OTHER_SUMMARY)]


def lemma(id, title, columns, note=""):
    """Lemma 2.3 and its parts: estimates and error covariances for these block columns of the gains."""
    batch, summary = UB * columns, US * columns
    claim(id, title,
          (T(batch) * vstack(a, b) == T(summary) * vstack(xh1, b)) & (T(batch) * R_BATCH * batch == T(summary) * R_SUMMARY * summary),
          sizes=["p", "q", "n", "m"], over={**MODEL, x: vector(n), z: vector(m), v: vector(p), w: vector(q), **GAINS_BY_BLOCKS},
          where=[let(a, H * x + V * v), let(b, J * x + K * z + W * w), let(xh1, T(U1) * a), let(P1, T(U1) * V * U1)], given=GAINS_GIVEN,
          by=[order([], [], [], [T(BETWEEN) * BY_FORM * BETWEEN], lemmas=SAME_GAIN), *GAIN_FOILS,
              instances(10, made_by=LEMMA_MADE, using=LEMMA_FREE, p=(1, 2, 3), q=(1, 2), n=(1, 2), m=(1, 2))],
          note=note + ("The gains are any that satisfy (2.25), as every symmetric (1)-inverse does (NWL92-E2.25); that x is estimable from a, and z from "
                       "a and b, is what makes (2.25) solvable."))


lemma("NWL92-L2.3", "measurements a may be replaced by the estimate of x from them", ALL_COLUMNS,
      "Estimates of x and z stacked, and their joint error covariance. ")
lemma("NWL92-L2.3.1", "the estimate of x and its error covariance are the same", upper(n, m))
lemma("NWL92-L2.3.2", "the estimate of z and its error covariance are the same", lower(n, m))

#: the first estimate alone, with blocks of its (1)-inverse
PROBLEM = {V: positive_semidefinite(p), H: matrix(p, n), W1: symmetric_matrix(p), U1: matrix(p, n),
           T1: symmetric_matrix(n)}
PROBLEM_LETS = (let(Z1, two_block(V, H, n)), let(G1, block([[W1, U1], [T(U1), T1]])))
PROBLEM_GIVEN = [is_inverse(G1, Z1, "x from a"), GRAM]
PROVED = every_size(also=((V, H, W1, U1, T1, n, p),))
DRAWN = instances(made_by=made_inverse(Z1, (W1, U1, T1), p, n, Y1, sym("Gm"))[0], using={Y1: matrix(p + n, p + n)},
                  p=(1, 2, 3), n=(1, 2))

claim("NWL92-E2.30", "the estimate of x is a measurement of x with noise covariance P1",
      (T(U1) * (H * x + v) == x + T(U1) * v) & (T(U1) * V * U1 == -T1),
      sizes=["p", "n"], over={**PROBLEM, x: vector(n), v: vector(p)}, where=PROBLEM_LETS, given=PROBLEM_GIVEN,
      by=[PROVED, DRAWN],
      note="u = U1'v is a function of v, so it is independent of w.")

Ma, Mb, Nb = symbols("Ma Mb Nb")
H_LEFT, K_LEFT = inv(T(H) * H) * T(H), inv(T(K) * K) * T(K)
claim("NWL92-S14", "given that x is estimable from a, z is estimable from a and b exactly if K has full column rank",
      (((Ma * H + Mb * J == Zero(m, n)) & (Mb * K == Identity(m))) >> (rank(K) == m))
      & ((rank(K) == m) >> ((-(K_LEFT * J * H_LEFT) * H + K_LEFT * J == Zero(m, n)) & (K_LEFT * K == Identity(m)))),
      sizes=["p", "q", "n", "m"], over={H: matrix(p, n), J: matrix(q, n), K: matrix(q, m), Ma: matrix(m, p), Mb: matrix(m, q)},
      given=[FULL_COLUMN_RANK],
      by=[order(), instances(p=(1, 2, 3), q=(1, 2), n=(1, 2), m=(1, 2)),
          instances(made_by={Mb: K_LEFT + h * (Identity(q) - K * K_LEFT), Ma: -(Mb * J * H_LEFT)}, using={h: matrix(m, q)}, p=(1, 2, 3), q=(1, 2), n=(1, 2),
                    m=(1, 2)),
          example({"p": 1, "q": 1, "n": 1, "m": 1, H: [[0]], J: [[1]], K: [[1]], Ma: [[0]], Mb: [[0]]})],
      note=("z is estimable if some Ma a + Mb b is an unbiased estimate of it, Ma H + Mb J = 0 and Mb K = I. Then K has full column rank; and if it has, "
            "there is such an estimate. The paper needs one direction here and the other for the filter."))

la, lb, l1, l1a, xh, zh = symbols("la lb l1 l1a xh zh")
N = sym("N")
BATCH_SYSTEM = block([
    [V, Zero(p, q), H, Zero(p, m)],
    [Zero(q, p), W, J, K],
    [T(H), T(J), Zero(n, n), Zero(n, m)],
    [Zero(m, p), T(K), Zero(m, n), Zero(m, m)]])
claim("NWL92-E2.31", "the batch system",
      BATCH_SYSTEM * vstack(la, lb, xh, zh) == vstack(a, b, Zero(n, 1), Zero(m, 1)),
      sizes=["p", "q", "n", "m"],
      over={**MODEL, la: vector(p), lb: vector(q), xh: vector(n), zh: vector(m), a: vector(p), b: vector(q)},
      given=[given("(2.9)", (block([[V, Zero(p, q)], [Zero(q, p), W]]) * vstack(la, lb) + HB * vstack(xh, zh) == vstack(a, b)) & (T(HB) * vstack(la, lb) == Zero(n + m, 1)))],
      by=[instances(made_by={N: kernel_basis(T(HB)), la: T(upper(p, q)) * N * T(N) * h,
                             lb: T(lower(p, q)) * N * T(N) * h,
                             a: V * la + H * xh, b: W * lb + J * xh + K * zh}, using={h: vector(p + q)}, **SIZES)],
      note="The conditions (2.9) for the measurement (a, b) of (x, z) with noise covariance diag(V, W).")

claim("NWL92-E2.32", "the estimate of x from a, its multiplier, its gain and its error covariance",
      block([[V, H], [T(H), Zero(n, n)]]) * block([[W1 * a, U1], [T(U1) * a, -T(U1) * V * U1]])
      == block([[a, Zero(p, n)], [Zero(n, 1), Identity(n)]]),
      sizes=["p", "n"], over={**PROBLEM, x: vector(n), v: vector(p)}, where=[*PROBLEM_LETS, let(a, H * x + V * v)],
      given=PROBLEM_GIVEN,
      by=[PROVED, DRAWN],
      note="The multiplier of the estimate U1'a is W1 a, its error covariance U1'VU1.")

SEQUENTIAL_SYSTEM = block([
    [P1, Zero(n, q), Identity(n), Zero(n, m)],
    [Zero(q, n), W, J, K],
    [Identity(n), T(J), Zero(n, n), Zero(n, m)],
    [Zero(m, n), T(K), Zero(m, n), Zero(m, m)]])
SECOND_STAGE = {P1: positive_semidefinite(n), W: positive_semidefinite(q), J: matrix(q, n), K: matrix(q, m),
                l1: vector(n), lb: vector(q),
                xh: vector(n), zh: vector(m), xh1: vector(n), b: vector(q)}
MULTIPLIERS = {N: kernel_basis(T(K)), lb: N * T(N) * h, l1: -T(J) * lb, xh1: P1 * l1 + xh, b: W * lb + J * xh + K * zh}
claim("NWL92-E2.33", "the sequential system",
      SEQUENTIAL_SYSTEM * vstack(l1, lb, xh, zh) == vstack(xh1, b, Zero(n, 1), Zero(m, 1)),
      sizes=["q", "n", "m"], over=SECOND_STAGE,
      given=[given("(2.9)", (block([[P1, Zero(n, q)], [Zero(q, n), W]]) * vstack(l1, lb) + HS * vstack(xh, zh) == vstack(xh1, b)) & (T(HS) * vstack(l1, lb) == Zero(n + m, 1)))],
      by=[instances(made_by=MULTIPLIERS, using={h: vector(q)}, q=(1, 2), n=(1, 2), m=(1, 2))],
      note="The conditions (2.9) for the measurement (xh1, b) of (x, z) with noise covariance diag(P1, W).")

SYSTEM_33 = given("(2.33)", SEQUENTIAL_SYSTEM * vstack(l1, lb, xh, zh) == vstack(xh1, b, Zero(n, 1), Zero(m, 1)))
ROW_1 = hstack(Identity(n), Zero(n, q), Zero(n, n), Zero(n, m))
ROW_3 = hstack(Zero(n, n), Zero(n, q), Identity(n), Zero(n, m))
claim("NWL92-E2.34", "first row of (2.33) times H",
      H * P1 * l1 + H * xh == H * xh1,
      sizes=["p", "q", "n", "m"], over={H: matrix(p, n), **SECOND_STAGE}, given=[SYSTEM_33],
      by=[combination([(H * ROW_1, "(2.33)", 1)], p=(1, 2), q=(1, 2), n=(1, 2), m=(1, 2)),
          instances(made_by=MULTIPLIERS, using={h: vector(q)}, p=(1, 2), q=(1, 2), n=(1, 2), m=(1, 2))])

FIRST_STAGE = {V: positive_semidefinite(p), H: matrix(p, n), U1: matrix(p, n), P1: symmetric_matrix(n), l1a: vector(p),
               xh1: vector(n), a: vector(p)}
SYSTEM_32 = given("(2.32)", block([[V, H], [T(H), Zero(n, n)]]) * block([[l1a, U1], [xh1, -P1]])
                  == block([[a, Zero(p, n)], [Zero(n, 1), Identity(n)]]))
STAGE_1 = {Z1: two_block(V, H, n), sym("kerG"): kernel_basis(Z1), G1: any_one_inverse(Z1, Y1, sym("kerG")),
           U1: T(upper(p, n)) * G1 * lower(p, n), P1: -T(lower(p, n)) * G1 * lower(p, n), sym("M"): kernel_basis(T(H)),
           l1a: sym("M") * T(sym("M")) * v}
STAGE_1_FREE = {Y1: matrix(p + n, p + n), v: vector(p)}
claim("NWL92-E2.35", "(2.34) through the first row of (2.32)",
      V * U1 * l1 + H * xh == a - V * l1a,
      sizes=["p", "n"], over={**FIRST_STAGE, l1: vector(n), xh: vector(n)},
      given=[SYSTEM_32, given("(2.34)", H * P1 * l1 + H * xh == H * xh1)],
      by=[combination([(T(upper(p, n)), "(2.32)", vstack(1, l1)), (1, "(2.34)", 1)], p=(1, 2, 3), n=(1, 2)),
          instances(made_by={**STAGE_1, xh1: P1 * l1 + xh, a: V * l1a + H * xh1}, using=STAGE_1_FREE, p=(1, 2, 3),
                    n=(1, 2))])

claim("NWL92-E2.36", "lam_a = lam_1a + U1 lam_1 satisfies the first row of the batch system",
      V * la + H * xh == a,
      sizes=["p", "n"],
      over={V: positive_semidefinite(p), H: matrix(p, n), U1: matrix(p, n), l1: vector(n), l1a: vector(p),
            xh: vector(n), a: vector(p)},
      where=[let(la, l1a + U1 * l1)], given=[given("(2.35)", V * U1 * l1 + H * xh == a - V * l1a)],
      by=[combination([(1, "(2.35)", 1)], p=(1, 2, 3), n=(1, 2)),
          instances(made_by={a: V * U1 * l1 + H * xh + V * l1a}, p=(1, 2, 3), n=(1, 2))])

claim("NWL92-E2.37", "third row of (2.33)",
      l1 + T(J) * lb == Zero(n, 1),
      sizes=["q", "n", "m"], over=SECOND_STAGE, given=[SYSTEM_33],
      by=[combination([(ROW_3, "(2.33)", 1)], q=(1, 2), n=(1, 2), m=(1, 2)),
          instances(made_by=MULTIPLIERS, using={h: vector(q)}, q=(1, 2), n=(1, 2), m=(1, 2))])

claim("NWL92-E2.38", "lam_a satisfies the third row of the batch system",
      T(H) * la + T(J) * lb == Zero(n, 1),
      sizes=["p", "q", "n"], over={**FIRST_STAGE, J: matrix(q, n), l1: vector(n), lb: vector(q)},
      where=[let(la, l1a + U1 * l1)],
      given=[SYSTEM_32, given("(2.37)", l1 + T(J) * lb == Zero(n, 1))],
      by=[combination([(T(lower(p, n)), "(2.32)", vstack(1, l1)), (1, "(2.37)", 1)], p=(1, 2, 3), q=(1, 2), n=(1, 2)),
          instances(made_by={**STAGE_1, l1: -T(J) * lb, a: V * l1a + H * xh1}, using=STAGE_1_FREE, p=(1, 2, 3),
                    q=(1, 2), n=(1, 2))],
      note="The text carries a stray subscript on H and J here.")

#: blocks W of the (1)-inverses, from a and b and from the estimate and b
Waa, Wab, Wbb, Vaa, Vab, Vbb = symbols("Waa Wab Wbb Vaa Vab Vbb")
WB, WS = block([[Waa, Wab], [T(Wab), Wbb]]), block([[Vaa, Vab], [T(Vab), Vbb]])
ESTIMABLE = block([[Identity(n), Zero(n, m)], [Zero(q, n), K]])
WITH_INVERSES = {**MODEL, x: vector(n), z: vector(m), v: vector(p), w: vector(q), W1: symmetric_matrix(p), **GAINS_BY_BLOCKS,
                 Waa: symmetric_matrix(p), Wab: matrix(p, q), Wbb: symmetric_matrix(q), Vaa: symmetric_matrix(n), Vab: matrix(n, q), Vbb: symmetric_matrix(q)}
REST = ESTIMABLE * T(BETWEEN)
SAME_ESTIMABLE = ([ESTIMABLE * T(UB) * HB == ESTIMABLE, ESTIMABLE * T(UB) * R_BATCH == -(ESTIMABLE * TB * T(HB)), ESTIMABLE * T(US) * HS == ESTIMABLE,
                   ESTIMABLE * T(US) * R_SUMMARY == -(ESTIMABLE * TS * T(HS)), REST * HB == Zero(n + q, n + m),
                   REST * R_BATCH == ESTIMABLE * (TS - TB) * T(HB), REST * R_BATCH * T(REST) * Identity(n + q) == Zero(n + q, n + q),
                   R_BATCH * T(REST) == Zero(p + q, n + q)],
                  [[], [], [], [], [], [], [], [REST * R_BATCH * T(REST)]])
S15_MADE = {**LEMMA_MADE, W1: T(upper(p, n)) * G1 * upper(p, n), **corners(BATCH_G, (Waa, Wab, Wbb), (AT_A, AT_A, AT_B), (AT_A, AT_B, AT_B)),
            **corners(SUMMARY_G, (Vaa, Vab, Vbb), (AT_1, AT_1, AT_2), (AT_1, AT_2, AT_2))}
#: all sizes one, noises of covariance one; not admissible: what each hypothesis is for
S15_ONES = {"p": 1, "q": 1, "n": 1, "m": 1, V: [[1]], W: [[1]], H: [[1]], J: [[0]], K: [[1]], x: [1], z: [1], v: [1], w: [1], W1: [[0]], U1: [[1]],
            T1: [[-1]], Waa: [[0]], Wab: [[0]], Wbb: [[0]], Uax: [[1]], Uaz: [[0]], Ubx: [[0]], Ubz: [[1]], Txx: [[-1]], Txz: [[0]], Tzz: [[-1]],
            Vaa: [[0]], Vab: [[0]], Vbb: [[0]], Sxx: [[1]], Sxz: [[0]], Sbx: [[0]], Sbz: [[1]], Qxx: [[-1]], Qxz: [[0]], Qzz: [[-1]]}
S15_FOILS = [example({**S15_ONES, **change}) for change in (
    {U1: [[2]], Qxx: [[-4]]}, {Uax: [[2]]}, {Sxx: [[2]]}, {H: [[0]], W1: [[1]], T1: [[0]], Waa: [[1]], Uax: [[0]], Txx: [[0]]})]
claim("NWL92-S15", "without estimability of z the lemma holds for the estimable combinations of z",
      (ESTIMABLE * T(UB) * vstack(a, b) == ESTIMABLE * T(US) * vstack(xh1, b))
      & (ESTIMABLE * T(UB) * R_BATCH * UB * T(ESTIMABLE) == ESTIMABLE * T(US) * R_SUMMARY * US * T(ESTIMABLE)),
      sizes=["p", "q", "n", "m"], over=WITH_INVERSES,
      where=[let(a, H * x + V * v), let(b, J * x + K * z + W * w), let(xh1, T(U1) * a), let(P1, T(U1) * V * U1), let(Z1, two_block(V, H, n)),
             let(G1, two_blocks(W1, U1, T1)), let(Zb, two_blocks(R_BATCH, HB, Zero(n + m, n + m))), let(Gb, two_blocks(WB, UB, TB)),
             let(Zs, two_blocks(R_SUMMARY, HS, Zero(n + m, n + m))), let(Gs, two_blocks(WS, US, TS))],
      given=[*WAYS, FULL_COLUMN_RANK],
      by=[chained(block_identities(V, H, W1, U1, T1, n, p), any_rank_identities(R_BATCH, HB, WB, UB, TB, n + m, p + q),
                  any_rank_identities(R_SUMMARY, HS, WS, US, TS, n + m, n + q), SAME_ESTIMABLE),
          *S15_FOILS, instances(10, made_by=S15_MADE, using=LEMMA_FREE, p=(1, 2), q=(1, 2), n=1, m=(1, 2))],
      note=("K has any rank; as x is estimable, the estimable combinations of z are those of Kz, here stacked below x. The rank of H "
            "enters the proof through the second column of (2.32) alone."))

# ------------------------------------------------------------------ Lemma 2.4
k, g = symbols("k g")
H1, H2, H3, R, R11, R12, R22 = symbols("H1 H2 H3 R R11 R12 R22")
Zj, Gj, Yj, y, y1, y2, x1, x2, l2, x0 = symbols("Zj Gj Yj y y1 y2 x1 x2 l2 x0")
claim("NWL92-E2.39", "the two rows of (2.39)",
      block([[H1, Zero(p, m)], [H2, H3]]) * vstack(x1, x2) + vstack(v, w) == vstack(H1 * x1 + v, H2 * x1 + H3 * x2 + w), sizes=["p", "k", "n", "m"],
      over={H1: matrix(p, n), H2: matrix(k, n), H3: matrix(k, m), x1: vector(n), x2: vector(m), v: vector(p), w: vector(k)},
      by=[instances(p=(1, 2), k=(1, 2), n=(1, 2), m=(1, 2))],
      note="A definition; what is checked is that it is the measurement (2.1), in which x2 enters through H3 alone.")

HJ = block([[H1, Zero(p, m)], [H2, H3]])
R_JOINT = block([[R11, R12], [T(R12), R22]])
#: blocks of the (1)-inverse for x1 and x2 from y1 and y2
WJ, UJ, TJ = block([[Waa, Wab], [T(Wab), Wbb]]), block([[Uax, Uaz], [Ubx, Ubz]]), block([[Txx, Txz], [T(Txz), Tzz]])
DROPPING = {R11: positive_semidefinite(p), R12: matrix(p, k), R22: positive_semidefinite(k), H1: matrix(p, n), H2: matrix(k, n), H3: matrix(k, m),
            x1: vector(n), x2: vector(m), v: vector(p), w: vector(k), W1: symmetric_matrix(p), U1: matrix(p, n), T1: symmetric_matrix(n),
            Waa: symmetric_matrix(p), Wab: matrix(p, k), Wbb: symmetric_matrix(k), Uax: matrix(p, n), Uaz: matrix(p, m), Ubx: matrix(k, n),
            Ubz: matrix(k, m), Txx: symmetric_matrix(n), Txz: matrix(n, m), Tzz: symmetric_matrix(m)}
DROPPING_LETS = (let(y1, H1 * x1 + R11 * v + R12 * w), let(y2, H2 * x1 + H3 * x2 + T(R12) * v + R22 * w),
                 let(Zj, two_blocks(R_JOINT, HJ, Zero(n + m, n + m))), let(Gj, two_blocks(WJ, UJ, TJ)), let(Z1, two_block(R11, H1, n)),
                 let(G1, two_blocks(W1, U1, T1)))
BOTH_WAYS = [standing("joint covariance", psd(R_JOINT)), is_inverse(Gj, Zj, "x1 and x2 from y1 and y2"), is_inverse(G1, Z1, "x1 from y1")]
FROM_BOTH, FROM_FIRST = T(Uax) * y1 + T(Ubx) * y2, T(U1) * y1
FULL_ROW_RANK = given("H3 has full row rank", rank(H3) == k)
H1_RANK = given("H1 has full column rank", rank(H1) == n)
DROP_SIZES = {"p": (1, 2), "k": (1, 2), "n": 1, "m": (1, 2)}
R0, ALL_J, ALL_1 = symbols("R0 Gjoint Gfirst")
AT_1A, AT_1B, AT_1X, AT_1Z = coordinates(p, k, n, m)
DROP_MADE = {R11: T(upper(p, k)) * R0 * upper(p, k), R12: T(upper(p, k)) * R0 * lower(p, k), R22: T(lower(p, k)) * R0 * lower(p, k),
             **some_inverse(ALL_J, Zj, Yj, p + k + n + m)[0],
             **corners(ALL_J, (Waa, Wab, Wbb, Uax, Uaz, Ubx, Ubz, Txx, Txz, Tzz), (AT_1A, AT_1A, AT_1B, AT_1A, AT_1A, AT_1B, AT_1B, AT_1X, AT_1X, AT_1Z),
                       (AT_1A, AT_1B, AT_1B, AT_1X, AT_1Z, AT_1X, AT_1Z, AT_1X, AT_1Z, AT_1Z)),
             **made_inverse(Z1, (W1, U1, T1), p, n, Y1, ALL_1)[0]}
DROP_FREE = {R0: positive_semidefinite(p + k), Yj: matrix(p + k + n + m, p + k + n + m), Y1: matrix(p + n, p + n)}


def dropped(M, rows, *more):
    """M times the gain for x1 from y1 and y2 is M times that from y1, for M H1 = H1 or M = I and H1 of full column rank.

    The gain takes nothing from y2, as H3 has full row rank. The difference of both, times the joint covariance, is a multiple of H1', which it annihilates.
    """
    apart = M * T(Uax - U1)
    padded = vstack(T(apart), Zero(k, rows))
    return chained(any_rank_identities(R11, H1, W1, U1, T1, n, p), any_rank_identities(R_JOINT, HJ, WJ, UJ, TJ, n + m, p + k),
                   ([H1 * T(Ubx) == Zero(p, k), M * T(Ubx) == Zero(rows, k), H1 * T(Uax) * H1 == H1, H1 * T(U1) * H1 == H1, M * T(Uax) * H1 == M * T(U1) * H1,
                     apart * R11 == -(M * (Txx - T1) * T(H1)), T(padded) * R_JOINT * padded * Identity(rows) == Zero(rows, rows),
                     R_JOINT * padded == Zero(p + k, rows)], [[], [], [], [], [], [], [], [T(padded) * R_JOINT * padded]]))


#: all sizes one; not admissible: what each hypothesis is for
DROP_ONES = {"p": 1, "k": 1, "n": 1, "m": 1, R11: [[1]], R12: [[0]], R22: [[1]], H1: [[1]], H2: [[0]], H3: [[1]], x1: [1], x2: [1], v: [1], w: [0],
             W1: [[0]], U1: [[1]], T1: [[-1]], Waa: [[0]], Wab: [[0]], Wbb: [[0]], Uax: [[1]], Uaz: [[0]], Ubx: [[0]], Ubz: [[1]], Txx: [[-1]],
             Txz: [[0]], Tzz: [[-1]]}
HALF = [["1/2"]]
DROP_FOILS = [example({**DROP_ONES, **change}) for change in (
    {U1: [[2]]}, {Uax: [[2]]},
    {H2: [[1]], H3: [[0]], Waa: HALF, Wab: [["-1/2"]], Wbb: HALF, Uax: HALF, Ubx: HALF, Ubz: [[0]], Txx: [["-1/2"]], Tzz: [[0]]},
    {H1: [[0]], H2: [[1]], x1: [0], x2: [0], W1: [[1]], T1: [[0]], Waa: [[1]], Uax: [[0]], Ubx: HALF, Ubz: HALF, Txx: [["-1/4"]], Txz: [["-1/4"]],
     Tzz: [["-1/4"]]})]
DROP_DRAWN = instances(10, made_by=DROP_MADE, using=DROP_FREE, **DROP_SIZES)
claim("NWL92-L2.4", "measurements with a variable of their own in every direction do not help",
      FROM_BOTH == FROM_FIRST,
      sizes=["p", "k", "n", "m"], over=DROPPING, where=DROPPING_LETS, given=[*BOTH_WAYS, FULL_ROW_RANK, H1_RANK],
      by=[dropped(Identity(n), n), *DROP_FOILS, DROP_DRAWN],
      note="The noises of y1 and y2 may be correlated; (y1; y2) lies in the range of [R H], v and w say where.")

claim("NWL92-S16", "the same for estimable combinations if H1 does not have full column rank",
      H1 * FROM_BOTH == H1 * FROM_FIRST,
      sizes=["p", "k", "n", "m"], over=DROPPING, where=DROPPING_LETS, given=[*BOTH_WAYS, FULL_ROW_RANK],
      by=[dropped(H1, p), *DROP_FOILS, DROP_DRAWN],
      note="The estimable combinations of x1 are those of H1 x1.")

SYSTEM = block([
    [R11, R12, H1, Zero(p, m)],
    [T(R12), R22, H2, H3],
    [T(H1), T(H2), Zero(n, n), Zero(n, m)],
    [Zero(m, p), T(H3), Zero(m, n), Zero(m, m)]])
JOINT = {R11: positive_semidefinite(p), R12: matrix(p, k), R22: positive_semidefinite(k), H1: matrix(p, n),
         H2: matrix(k, n), H3: matrix(k, m),
         l1: vector(p), l2: vector(k), x1: vector(n), x2: vector(m), y1: vector(p), y2: vector(k)}
JOINT_MADE = {N: kernel_basis(T(HJ)), l1: T(upper(p, k)) * N * T(N) * h, l2: T(lower(p, k)) * N * T(N) * h,
              y1: R11 * l1 + R12 * l2 + H1 * x1, y2: T(R12) * l1 + R22 * l2 + H2 * x1 + H3 * x2}
claim("NWL92-E2.40", "stationarity conditions for x1 and x2",
      SYSTEM * vstack(l1, l2, x1, x2) == vstack(y1, y2, Zero(n, 1), Zero(m, 1)),
      sizes=["p", "k", "n", "m"], over=JOINT,
      given=[given("(2.9)", (block([[R11, R12], [T(R12), R22]]) * vstack(l1, l2) + HJ * vstack(x1, x2) == vstack(y1, y2))
                   & (T(HJ) * vstack(l1, l2) == Zero(n + m, 1)))],
      by=[instances(made_by=JOINT_MADE, using={h: vector(p + k)}, **DROP_SIZES)])

claim("NWL92-S17", "the multiplier of y2 is zero",
      l2 == Zero(k, 1), sizes=["k", "m"], over={H3: matrix(k, m), l2: vector(k)},
      given=[given("H3'lam2 = 0", T(H3) * l2 == Zero(m, 1)), given("H3 has full row rank", invertible(H3 * T(H3)))],
      by=[order([], [inv(H3 * T(H3))], lemmas=[inv(H3 * T(H3)) * H3 * (T(H3) * l2) == Zero(k, 1)]),
          combination([(inv(H3 * T(H3)) * H3, "H3'lam2 = 0", 1)], k=(1, 2), m=(2, 3)),
          instances(made_by={N: kernel_basis(T(H3)), l2: N * T(N) * h}, using={h: vector(k)}, k=(1, 2, 3),
                    m=(1, 2, 3))],
      note=("That rows and columns 2 and 4 of (2.40) can then be deleted is NWL92-E2.41. Full row rank of H3 is "
            "said through H3H3'."))

claim("NWL92-E2.41", "what remains are the conditions for x1 from y1 alone",
      block([[R11, H1], [T(H1), Zero(n, n)]]) * vstack(l1, x1) == vstack(y1, Zero(n, 1)),
      sizes=["p", "k", "n", "m"], over=JOINT,
      given=[given("(2.40)", SYSTEM * vstack(l1, l2, x1, x2) == vstack(y1, y2, Zero(n, 1), Zero(m, 1))), FULL_ROW_RANK],
      by=[combination([
          (block([[Identity(p), Zero(p, k), Zero(p, n), -R12 * inv(H3 * T(H3)) * H3],
                  [Zero(n, p), Zero(n, k), Identity(n), -T(H2) * inv(H3 * T(H3)) * H3]]), "(2.40)", 1)], p=(1, 2),
                  k=(1, 2), n=(1, 2), m=2),
          instances(made_by=JOINT_MADE, using={h: vector(p + k)}, **DROP_SIZES)])

# ------------------------------------------------------------------ both together
G, u, Hg, Zg, Gg, Yg = symbols("G u Hg Zg Gg Yg")
claim("NWL92-E2.42", "a is one measurement of x1 and x2",
      H * x1 + G * x2 + v == hstack(H, G) * vstack(x1, x2) + v, sizes=["p", "n", "g"],
      over={H: matrix(p, n), G: matrix(p, g), x1: vector(n), x2: vector(g), v: vector(p)}, by=[instances(p=(1, 2), n=(1, 2), g=(1, 2))],
      note="A definition; what is checked is the form (2.1) of the measurement, with [H G] for H.")

claim("NWL92-E2.43", "a and b together are one measurement of x1, x2 and z",
      vstack(H * x1 + G * x2 + v, J * x1 + K * z + w)
      == block([[H, G, Zero(p, m)], [J, Zero(q, g), K]]) * vstack(x1, x2, z) + vstack(v, w),
      sizes=["p", "q", "n", "g", "m"],
      over={H: matrix(p, n), G: matrix(p, g), J: matrix(q, n), K: matrix(q, m), x1: vector(n), x2: vector(g),
            z: vector(m), v: vector(p), w: vector(q)},
      by=[identity(p=(1, 2), q=(1, 2), n=(1, 2), g=(1, 2), m=(1, 2)),
          instances(p=(1, 2), q=(1, 2), n=(1, 2), g=(1, 2), m=(1, 2))],
      note="A definition; what is checked is the form (2.1) of both measurements together.")

HG = hstack(H, G)
U2, T12, T22 = symbols("U2 T12 T22")
#: blocks of the (1)-inverse for x1 and x2 from a
UG, TG = hstack(U1, U2), block([[T1, T12], [T(T12), T22]])
SPLIT = {V: positive_semidefinite(p), H: matrix(p, n), G: matrix(p, g), W1: symmetric_matrix(p), U1: matrix(p, n), U2: matrix(p, g),
         T1: symmetric_matrix(n), T12: matrix(n, g), T22: symmetric_matrix(g)}
SPLIT_LETS = (let(Zg, two_blocks(V, HG, Zero(n + g, n + g))), let(Gg, two_blocks(W1, UG, TG)))
SPLIT_GIVEN = [is_inverse(Gg, Zg, "x1 and x2 from a"), given("[H G] has full column rank", rank(HG) == n + g)]
AT_AG, AT_XG, AT_GG = coordinates(p, n, g)
SPLIT_DRAWN = instances(made_by={**some_inverse(sym("Gall"), Zg, Yg, p + n + g)[0],
                                 **corners(sym("Gall"), (W1, U1, U2, T1, T12, T22), (AT_AG, AT_AG, AT_AG, AT_XG, AT_XG, AT_GG),
                                           (AT_AG, AT_XG, AT_GG, AT_XG, AT_GG, AT_GG))},
                        using={Yg: matrix(p + n + g, p + n + g)}, p=(2, 3, 4), n=(1, 2), g=(1, 2))
SPLIT_PROVED = chained(block_identities(V, HG, W1, UG, TG, n + g, p))
claim("NWL92-E2.44a", "the estimate of x1 from a is a measurement of x1 alone",
      T(U1) * HG == hstack(Identity(n), Zero(n, g)),
      sizes=["p", "n", "g"], over=SPLIT, where=SPLIT_LETS, given=SPLIT_GIVEN, by=[SPLIT_PROVED, SPLIT_DRAWN],
      note="So the estimate of x1 is x1 + u1, where u1 is the gain times v, and x2 does not enter.")

claim("NWL92-E2.44b", "so is the estimate of x2; the noises have the joint error covariance of the estimates",
      (T(U2) * HG == hstack(Zero(g, n), Identity(g))) & (T(UG) * V * UG == -TG),
      sizes=["p", "n", "g"], over=SPLIT, where=SPLIT_LETS, given=SPLIT_GIVEN, by=[SPLIT_PROVED, SPLIT_DRAWN],
      note="The noises u1 and u2 together are the gain times v.")

HT = block([[H, G, Zero(p, m)], [J, Zero(q, g), K]])
#: columns of x1 and z of the gain from a and b, of x1 of the gain from a, and what stands beside them in (2.25)
T21, Tgx, Tgz, Tzx = symbols("T21 Tgx Tgz Tzx")
TB3 = block([[Txx, Txz], [Tgx, Tgz], [Tzx, Tzz]])
COLUMNS_3 = block([[Identity(n), Zero(n, m)], [Zero(g, n), Zero(g, m)], [Zero(m, n), Identity(m)]])
BEST_TWO = [given("(2.25) for x1 from a", (V * U1 + H * T1 + G * T21 == Zero(p, n)) & (T(H) * U1 == Identity(n)) & (T(G) * U1 == Zero(g, n))),
            given("(2.25) for x1 and z from a and b", (R_BATCH * UB + HT * TB3 == Zero(p + q, n + m)) & (T(HT) * UB == COLUMNS_3)), GAINS_GIVEN[2]]
SAME_GAIN_3 = [R_BATCH * COMPOSED + HT * block([[Qxx, Qxz], [T21 * Sxx, T21 * Sxz], [T(Qxz), Qzz]]) == Zero(p + q, n + m),
               T(HT) * BETWEEN == Zero(n + g + m, n + m), *SAME_GAIN[2:]]
AT_A3, AT_B3, AT_X3, AT_G3, AT_Z3 = coordinates(p, q, n, g, m)
S18_MADE = {
    **LEMMA_MADE, Z1: two_block(V, HG, n + g), U1: T(upper(p, n + g)) * G1 * vstack(Zero(p, n), Identity(n), Zero(g, n)),
    T1: T(vstack(Zero(p, n), Identity(n), Zero(g, n))) * G1 * vstack(Zero(p, n), Identity(n), Zero(g, n)),
    T21: hstack(Zero(g, p), Zero(g, n), Identity(g)) * G1 * vstack(Zero(p, n), Identity(n), Zero(g, n)), BATCH_Z: two_block(RB, HT, n + g + m),
    **corners(BATCH_G, (Uax, Uaz, Ubx, Ubz, Txx, Txz, Tgx, Tgz, Tzx, Tzz), (AT_A3, AT_A3, AT_B3, AT_B3, AT_X3, AT_X3, AT_G3, AT_G3, AT_Z3, AT_Z3),
              (AT_X3, AT_Z3) * 5)}
#: the same with a second measurement, of x2
TWO_ONES = {**GAIN_ONES, "p": 2, "g": 1, V: [[1, 0], [0, 1]], H: [[1], [0]], G: [[0], [1]], x1: [1], x2: [0], v: [1, 0], U1: [[1], [0]], T21: [[0]],
            Uax: [[1], [0]], Uaz: [[-1], [0]], Tgx: [[0]], Tgz: [[0]], Tzx: [[1]]}
del TWO_ONES[x]
TWO_FOILS = [example({**TWO_ONES, **change}) for change in ({U1: [[2], [0]], **LARGER_P1}, {Uax: [[2], [0]], Uaz: [[5], [0]]}, OTHER_SUMMARY)]
claim("NWL92-S18", "x1 and z are estimated from b and the estimate of x1 alone",
      (T(UB) * vstack(a, b) == T(US) * vstack(xh1, b)) & (T(UB) * R_BATCH * UB == T(US) * R_SUMMARY * US),
      sizes=["p", "q", "n", "g", "m"],
      over={**MODEL, G: matrix(p, g), x1: vector(n), x2: vector(g), z: vector(m), v: vector(p), w: vector(q), **GAINS_BY_BLOCKS,
            T21: matrix(g, n), Tgx: matrix(g, n), Tgz: matrix(g, m), Tzx: matrix(m, n)},
      where=[let(a, H * x1 + G * x2 + V * v), let(b, J * x1 + K * z + W * w), let(xh1, T(U1) * a), let(P1, T(U1) * V * U1)], given=BEST_TWO,
      by=[order([], [], [], [T(BETWEEN) * BY_FORM * BETWEEN], lemmas=SAME_GAIN_3), *TWO_FOILS,
          instances(10, made_by=S18_MADE, using={Y1: matrix(p + n + g, p + n + g), Yb: matrix(p + q + n + g + m, p + q + n + g + m),
                                                 Ys: matrix(n + q + n + m, n + q + n + m)}, p=(2, 3), q=(1, 2), n=1, g=(1, 2), m=1)],
      note=("Estimates of x1 and z stacked, and their joint error covariance. The gains are any that satisfy (2.25), as every symmetric (1)-inverse does "
            "(NWL92-E2.25); full column rank of [H G] and K is what makes it solvable. The composed gain is unbiased for (a, b), and R times it lies in the "
            "range of the measurement matrix; this is Lemma 2.3 for (x1, x2) with Lemma 2.4 for the estimate of x2, in one step."))

# ------------------------------------------------------------------ Lemma 2.5
V1, V2, W2, U2, T2, Z2, Y2, P2, G2, B, v1 = symbols("V1 V2 W2 U2 T2 Z2 Y2 P2 G2 B v1")
claim("NWL92-E2.45", "one gain for both measurements has errors that differ by their noises alone",
      (L * (H * x + V1 * v) - x) - (L * (H * z + V2 * w) - z) == (L * H - Identity(n)) * (x - z) + L * (V1 * v - V2 * w), sizes=["p", "n"],
      over={V1: positive_semidefinite(p), V2: positive_semidefinite(p), H: matrix(p, n), L: matrix(n, p), x: vector(n), z: vector(n), v: vector(p), w: vector(p)},
      by=[instances(p=(1, 2), n=(1, 2))],
      note=("A definition; what is checked is what Lemma 2.5 uses of it: if LH = I the errors of Ly1 and Ly2 are L times the noises v1 = V1 v and v2 = V2 w, whatever x "
            "and z are."))

NOISES = {V1: positive_semidefinite(p), V2: positive_semidefinite(p), H: matrix(p, n),
          W1: symmetric_matrix(p), U1: matrix(p, n), T1: symmetric_matrix(n),
          W2: symmetric_matrix(p), U2: matrix(p, n), T2: symmetric_matrix(n)}
NOISES_LETS = (let(Z1, two_block(V1, H, n)), let(Z2, two_block(V2, H, n)), let(G1, block([[W1, U1], [T(U1), T1]])),
               let(G2, block([[W2, U2], [T(U2), T2]])), let(P1, -T1), let(P2, -T2))
NOISES_GIVEN = [is_inverse(G1, Z1, "first noise"), is_inverse(G2, Z2, "second noise"), GRAM,
                given("the second noise is larger", loewner(V2, V1))]
FIRST_MADE = made_inverse(Z1, (W1, U1, T1), p, n, Y1, sym("Ga"))
SECOND_MADE = made_inverse(Z2, (W2, U2, T2), p, n, Y2, sym("Gc"))
NOISES_MADE = together(FIRST_MADE, SECOND_MADE, before={V2: V1 + B}, using={B: positive_semidefinite(p)},
                       count=24, p=(1, 2, 3), n=(1, 2))
TWO_PROBLEMS = ((V1, H, W1, U1, T1, n, p), (V2, H, W2, U2, T2, n, p))
MORE_NOISE, OTHER_GAIN = T(U2) * (V2 - V1) * U2, T(U2 - U1) * V1 * (U2 - U1)
claim("NWL92-L2.5", "more noise, more error",
      loewner(P2, P1), sizes=["p", "n"], over=NOISES, where=NOISES_LETS, given=NOISES_GIVEN,
      by=[every_size([MORE_NOISE, OTHER_GAIN], also=TWO_PROBLEMS), NOISES_MADE],
      note=("The error covariances are minus blocks of arbitrary symmetric (1)-inverses (NWL92-E2.22)."))

SECOND_PROBLEM = {V2: positive_semidefinite(p), H: matrix(p, n), W2: symmetric_matrix(p), U2: matrix(p, n),
                  T2: symmetric_matrix(n)}
claim("NWL92-E2.46", "gain and error covariance for the second noise",
      eq(T(U2) * V2 * U2, -T2) & (T(U2) * H == Identity(n)),
      sizes=["p", "n"], over=SECOND_PROBLEM, where=[NOISES_LETS[1], let(G2, block([[W2, U2], [T(U2), T2]]))],
      given=[is_inverse(G2, Z2, "second noise"), GRAM],
      by=[every_size(also=TWO_PROBLEMS[1:]),
          instances(made_by=SECOND_MADE[0], using=SECOND_MADE[1], p=(1, 2, 3), n=(1, 2))],
      note="The estimate is U2'y2 (NWL92-E2.24); its error is U2'v2.")

claim("NWL92-E2.47", "the gain for the second noise is unbiased for the first",
      T(U2) * (H * x + v1) == x + T(U2) * v1,
      sizes=["p", "n"], over={H: matrix(p, n), U2: matrix(p, n), x: vector(n), v1: vector(p)},
      given=[given("(A.11)", T(U2) * H == Identity(n))],
      by=[combination([(1, "(A.11)", x)], p=(1, 2, 3), n=(1, 2)),
          instances(made_by={U2: H * inv(T(H) * H) + X - H * inv(T(H) * H) * (T(H) * X)}, using={X: matrix(p, n)},
                    p=(1, 2, 3), n=(1, 2))],
      note="The error of U2'y1 is U2'v1, which has mean zero.")

claim("NWL92-E2.48", "the chain of inequalities",
      loewner(T(U2) * V1 * U2, P1) & loewner(T(U2) * V2 * U2, T(U2) * V1 * U2) & (T(U2) * V2 * U2 == P2),
      sizes=["p", "n"], over=NOISES, where=NOISES_LETS, given=NOISES_GIVEN,
      by=[every_size([OTHER_GAIN], [MORE_NOISE], [], also=TWO_PROBLEMS), NOISES_MADE],
      note="U2'V1U2 is the error covariance of U2'y1 by NWL92-E2.47. Gains and error covariances as in Lemma 2.5.")
