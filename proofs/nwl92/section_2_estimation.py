# SPDX-License-Identifier: MIT
"""Section II, first half: maximum likelihood estimation when the noise covariance may be singular.

From y = Hx + v, where v is Gaussian with mean zero and covariance R >= 0, the
unknown x is to be estimated. Write v = Vw with VV' = R and cov w = I. The
likelihood of (x, w) depends on w'w only, so the maximum likelihood estimate
is the x of the pair that minimises w'w under y = Hx + Vw. With a multiplier
lam for the constraint the stationary points satisfy w = V'lam, H'lam = 0 and
y = Hx + Vw; without w this is

    Z [lam; x] = [y; 0],    Z = [R, H; H', 0].

Optimality can be seen directly: if lam, x solve this and (x0, w0) is any
other pair with y = Hx0 + Vw0, then w = V'lam is orthogonal to w0 - w, because
lam'V(w0 - w) = lam'H(x - x0) = 0. So w0'w0 = w'w + |w0 - w|^2. This equation
is how the claims below say "maximum likelihood estimate". The other way to
say it is that U'y is unbiased, U'H = I, and that every unbiased Ly has an
error covariance LRL' that is larger; error covariances are LRL' because the
error of Ly is Lv.

If Z is invertible its inverse gives the estimate and, with a minus sign, its
error covariance. Z is invertible exactly if H has full column rank and [R H]
full row rank. Otherwise any symmetric G with ZGZ = Z does the same work: data
y = Hx0 + Vw0 lie in the range of [R H], on which the gain U' does not depend
on G, and the block -T of G is the error covariance and does not depend on G
either. If H does not have full column rank, H = H1 H2 with full rank factors,
then what can be estimated is z = H2 x.

Data are taken in the range of [R H] throughout, where they lie with
probability one.
"""

from __future__ import annotations

from fractions import Fraction

from exactkf.claims import claim, repair
from exactkf.evidence import combination, example, identity, instances, null_vector, order, restated, steps, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    column,
    eq,
    function,
    given,
    hstack,
    iff,
    inv,
    invertible,
    kernel_basis,
    let,
    loewner,
    matrix,
    nonsingular,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    size_of,
    standing,
    sym,
    symbols,
    symmetric,
    symmetric_matrix,
    vector,
    vstack,
    when,
)
from proofs.nwl92.notation import (
    BLOCKS,
    FULL_COLUMN_RANK,
    GRAM,
    IMPLIED_RANK,
    ONE_INVERSE,
    PAIR,
    SECOND,
    SECOND_GIVEN,
    SECOND_INVERSE,
    SETTING,
    SIZES,
    T2,
    TWO_BLOCK,
    U2,
    W2,
    G,
    H,
    L,
    R,
    Tb,
    U,
    V,
    W,
    X,
    Y,
    Zd,
    Ze,
    Zm,
    any_one_inverse,
    any_rank_identities,
    block_identities,
    chained,
    every_size,
    inverses,
    lam,
    likeliest,
    lower,
    made_inverse,
    n,
    p,
    q,
    r,
    root_identities,
    two_block,
    two_inverses,
    upper,
    w,
    w0,
    x,
    x0,
    y,
)

half = Fraction(1, 2)

v, S = symbols("v S")
claim("NWL92-E2.1", "the measurement y = Hx + v and the error of a linear estimate",
      L * (H * x + v) - x == (L * H - Identity(n)) * x + L * v, sizes=["p", "n"],
      over={H: matrix(p, n), L: matrix(n, p), x: vector(n), v: vector(p)}, by=[identity(p=(1, 2), n=(1, 2)), instances(p=(1, 2), n=(1, 2))],
      note=("A definition; what is checked is what all that follows uses of it: the error of Ly has the mean (LH - I)x and is that plus Lv, so that its covariance "
            "is LRL' if LH = I."))

# ------------------------------------------------------------------ Bayesian estimation is a special case
P, N, C, K, m, z = symbols("P N C K m z")
I_n, UB, K2, Va, Vb, a, b, wa, wb, mu, xh, wh = (Identity(n), *symbols("UB K2 Va Vb a b wa wb mu xh wh"))
BAYES = (let(H, vstack(I_n, C)), let(R, block([[P, Zero(n, p)], [Zero(p, n), N]])))
NOISE_BLOCK = block([[R, Zero(p, n)], [Zero(n, p), Zero(n, n)]])
#: covariance of z, and z less its mean
OF_Z, SURPRISE = C * P * T(C) + N, z - C * m
WH_A, WH_B = -(T(Va) * T(C) * mu), T(Vb) * mu
BAYES_LETS = [let(P, Va * T(Va)), let(N, Vb * T(Vb)), *BAYES, let(V, block([[Va, Zero(n, b)], [Zero(p, a), Vb]])), let(m, x0 + Va * wa),
              let(z, C * x0 + Vb * wb), let(w0, vstack(wa, wb)), let(mu, G * SURPRISE), let(wh, vstack(WH_A, WH_B)), let(xh, m + K * SURPRISE),
              let(UB, T(hstack(I_n - K * C, K)))]
#: rows that annihilate the covariance of z
SEEN = Identity(p) - OF_Z * G
BAYES_PROOF = order([], [SEEN * C * Va * T(Va) * T(C) * T(SEEN), SEEN * Vb * T(Vb) * T(SEEN)], *([[]] * 6), [(K2 - K) * OF_Z * T(K2 - K)],
                    lemmas=[SEEN * OF_Z * T(SEEN) * Identity(p) == Zero(p, p),
                                                                  vstack(T(Va) * T(C) * T(SEEN), T(Vb) * T(SEEN)) == Zero(a + b, p)])
claim("NWL92-S2", "the Bayesian least squares estimate is the ML estimate for (2.2), with the same error covariance",
      likeliest(xh, wh, vstack(m, z), H, V, w0) & (x0 - xh == Va * (WH_A - wa)) & (xh == T(UB) * vstack(m, z)) & (T(UB) * H == I_n)
      & (T(UB) * R * UB == P - K * C * P) & loewner((I_n - K2 * C) * P * T(I_n - K2 * C) + K2 * N * T(K2), P - K * C * P),
      sizes=["n", "p", "a", "b"],
      over={Va: matrix(n, a), Vb: matrix(p, b), C: matrix(p, n), K: matrix(n, p), G: symmetric_matrix(p), x0: vector(n), wa: vector(a), wb: vector(b),
            K2: matrix(n, p)},
      where=BAYES_LETS,
      given=[given("gain of least squares", K * OF_Z == P * T(C)), given("(1)-inverse of the covariance of z", OF_Z * G * OF_Z == OF_Z)],
      by=[restated("the error of a Gaussian vector is independent of data with which it is uncorrelated: no function of them does better than a linear one"), BAYES_PROOF,
          instances(made_by={G: any_one_inverse(OF_Z, Y), K: P * T(C) * G + X * (Identity(p) - OF_Z * G)},
                    using={X: matrix(n, p), Y: matrix(p, p)}, n=(1, 2), p=(1, 2), a=(1, 2), b=(1, 2))],
      note=("P = VaVa' and N = VbVb' with any square roots; m = x0 + Va wa, z = Cx0 + Vb wb are any data with (m, z) in the range of [R H]. The least squares "
            "estimate is xh = m + K(z - Cm) with a K that makes its error uncorrelated with z, K(CPC' + N) = PC'; its error covariance is P - KCP, and that "
            "of any other gain K2 is larger. "
            "Of all (x0, w0) that explain the data (xh, wh) has the smallest w'w, and no other x0 goes with wh: xh is the ML estimate for (2.2)."))

claim("NWL92-E2.2", "H and R of the Bayesian problem are a measurement with full column rank and R >= 0",
      (rank(H) == n) & iff(psd(R), psd(P) & psd(N)) & (vstack(m, z) == H * x + vstack(m - x, z - C * x)),
      sizes=["n", "p"],
      over={P: symmetric_matrix(n), N: symmetric_matrix(p), C: matrix(p, n), x: vector(n), m: vector(n), z: vector(p)},
      where=BAYES,
      by=[order([], [T(upper(n, p)) * R * upper(n, p)], [T(lower(n, p)) * R * lower(n, p)],
                [upper(n, p) * P * T(upper(n, p)), lower(n, p) * N * T(lower(n, p))]), instances(n=(1, 2, 3), p=(1, 2))],
      note=("The displayed matrices, read as (2.1): prior mean and measurement are one measurement whose noises m - "
            "x and z - Cx have covariances P and N."))

d, c, K, i = symbols("d c K i")
HH = T(H) * H
claim("NWL92-S3", "all components of x are estimable exactly if H has rank n; in the Bayesian case it has",
      ((L * H == Identity(n)) >> (rank(H) == n)) & ((rank(H) == n) >> (inv(HH) * T(H) * H == Identity(n))) & (rank(vstack(Identity(n), C)) == n),
      sizes=["p", "n"], over={H: matrix(p, n), L: matrix(n, p), C: matrix(p, n)},
      by=[order(), instances(p=(1, 2, 3), n=(1, 2, 3)),
          instances(made_by={L: inv(HH) * T(H) + X * (Identity(p) - H * inv(HH) * T(H))}, using={X: matrix(n, p)}, p=(1, 2, 3), n=(1, 2, 3))],
      note=("Estimable means that there is a linear estimate Ly that is unbiased, LH = I: where there is one, H has rank n, and where H has rank n, "
            "there is one. (I; C) is the H of (2.2)."))

# ------------------------------------------------------------------ R of full rank
Hx = T(H) * inv(R) * H
FULL = inv(Hx) * T(H) * inv(R)
xh = sym("xh")


def misfit(x):
    """(y - Hx)' R^-1 (y - Hx), minus twice the logarithm of the likelihood up to a constant."""
    return T(y - H * x) * inv(R) * (y - H * x)


claim("NWL92-E2.3", "the ML estimate when R is invertible",
      misfit(x) == misfit(xh) + T(x - xh) * Hx * (x - xh),
      sizes=["p", "n"], over={R: positive_definite(p), H: matrix(p, n), x: vector(n), y: vector(p)},
      where=[let(xh, FULL * y)],
      by=[identity(p=(2, 3), n=(1, 2)), instances(p=(1, 2, 3), n=(1, 2))],
      note=("Complete squares of the exponent of the Gaussian density: the last term is zero at xh only, as R is "
            "positive definite and H has full column rank (that rank is the denominator det H'R^-1H)."))

claim("NWL92-E2.4", "error covariance of the ML estimate when R is invertible",
      (FULL * H == Identity(n)) & (FULL * R * T(FULL) == inv(Hx)),
      sizes=["p", "n"], over={R: positive_definite(p), H: matrix(p, n)},
      by=[identity(p=(2, 3), n=(1, 2)), instances(p=(1, 2, 3), n=(1, 2))],
      note="The error of the estimate (2.3) is its gain times v.")

# ------------------------------------------------------------------ the Lagrangian
NOISE = let(R, V * T(V))
claim("NWL92-E2.5", "a full rank square root of R has as many columns as R has rank, and the same range",
      psd(R) & (rank(R) == r) & (rank(hstack(R, V)) == r),
      sizes=["p", "r"], over={V: matrix(p, r)}, where=[NOISE], given=[given("V has full column rank", rank(V) == r)],
      by=[order([], [V, T(V), inv(T(V) * V) * T(V), V * inv(T(V) * V)],
                [V, hstack(T(V), Identity(r)), inv(T(V) * V) * T(V), vstack(Zero(p, r), Identity(r))]), instances(p=(1, 2, 3), r=(1, 2, 3))],
      note="The noise Vw with cov w = I has covariance VV' = R.")

claim("NWL92-E2.6", "the exponent of the density of v is w'w/2",
      half * T(y - H * x) * G * (y - H * x) == half * T(w) * w,
      sizes=["p", "n", "r"],
      over={V: matrix(p, r), H: matrix(p, n), x: vector(n), w: vector(r), G: symmetric_matrix(p)},
      where=[NOISE, let(y, H * x + V * w)],
      given=[given("V has full column rank", rank(V) == r), given("generalized inverse of R", R * G * R == R)],
      by=[combination([(half * T(w) * inv(T(V) * V) * T(V), "generalized inverse of R", V * inv(T(V) * V) * w)],
                      p=(2, 3), n=(1, 2), r=(1, 2)),
          instances(made_by={G: any_one_inverse(R, Y)}, using={Y: matrix(p, p)}, p=(1, 2, 3), n=(1, 2), r=(1, 2, 3))],
      note=("The density of a Gaussian v of covariance R, on the range of R, is proportional to exp(-v'Gv/2) for any "
            "(1)-inverse G of R; so to maximise the likelihood is to minimise w'w/2 under y = Hx + Vw."))

Lg, h = symbols("Lg h")
w1, x1, lam1 = symbols("w1 x1 lam1")
LAGRANGIAN = function(Lg, [w1, x1, lam1], half * T(w1) * w1 + T(lam1) * (y - H * x1 - V * w1))
DATA = {V: matrix(p, r), H: matrix(p, n), y: vector(p), w: vector(r), x: vector(n), lam: vector(p)}
ALL = {"p": (1, 2, 3), "n": (1, 2), "r": (1, 2)}

claim("NWL92-E2.7", "on the constraint the Lagrangian is the cost",
      Lg(w, x, lam) == half * T(w) * w,
      sizes=["p", "n", "r"], over=DATA, where=[LAGRANGIAN], given=[given("(2.5)", y == H * x + V * w)],
      by=[combination([(T(lam), "(2.5)", 1)], **ALL), instances(made_by={y: H * x + V * w}, **ALL)])

claim("NWL92-E2.8a", "gradient of the Lagrangian in w",
      Lg(w + h, x, lam) - Lg(w, x, lam) == T(h) * (w - T(V) * lam) + half * T(h) * h,
      sizes=["p", "n", "r"], over={**DATA, h: vector(r)}, where=[LAGRANGIAN], by=[identity(**ALL), instances(**ALL)],
      note=("The part of first order in h is h' times the partial derivative, so this vanishes exactly if w - V'lam "
            "= 0."))

claim("NWL92-E2.8b", "gradient of the Lagrangian in x",
      Lg(w, x + h, lam) - Lg(w, x, lam) == -T(h) * (T(H) * lam),
      sizes=["p", "n", "r"], over={**DATA, h: vector(n)}, where=[LAGRANGIAN], by=[identity(**ALL), instances(**ALL)],
      note="The partial derivative is -H'lam; it vanishes exactly if H'lam = 0.")

claim("NWL92-E2.8c", "gradient of the Lagrangian in the multiplier",
      Lg(w, x, lam + h) - Lg(w, x, lam) == T(h) * (y - H * x - V * w),
      sizes=["p", "n", "r"], over={**DATA, h: vector(p)}, where=[LAGRANGIAN], by=[identity(**ALL), instances(**ALL)],
      note="The partial derivative vanishes exactly if y - Hx - Vw = 0.")

claim("NWL92-E2.9", "the stationarity conditions without w",
      Zm * vstack(lam, x) == vstack(y, Zero(n, 1)),
      sizes=["p", "n", "r"], over=DATA, where=[NOISE, TWO_BLOCK],
      given=[given("(2.8a)", w - T(V) * lam == Zero(r, 1)), given("(2.8b)", T(H) * lam == Zero(n, 1)),
             given("(2.8c)", y - H * x - V * w == Zero(p, 1))],
      by=[combination([(-upper(p, n) * V, "(2.8a)", 1), (lower(p, n), "(2.8b)", 1), (-upper(p, n), "(2.8c)", 1)],
                      **ALL),
          instances(made_by={"K": kernel_basis(T(H)), lam: sym("K") * T(sym("K")) * h, w: T(V) * lam, y: H * x + V * w},
                    using={h: vector(p)}, **ALL)])

# ------------------------------------------------------------------ when Z is invertible
RH = hstack(R, H)
ANY = {R: positive_semidefinite(p), H: matrix(p, n)}
FULL_ROW_RANK = given("[R H] has full row rank", rank(RH) == p)
claim("NWL92-S4", "Z is invertible exactly if H has full column rank and [R H] full row rank",
      iff(invertible(Zm), (rank(H) == n) & (rank(RH) == p)), sizes=["p", "n"], over=ANY, where=[TWO_BLOCK],
      by=[order([], [], [R]), steps("NWL92-E2.12", "NWL92-E2.13", "NWL92-E2.14", "NWL92-E2.15",
                facts=["x'Rx = 0 implies Rx = 0 for R >= 0"],
                prose=("Necessity: the last n columns [H; 0] and the first p rows [R H] of an invertible matrix are "
                       "independent. Sufficiency is Lemma 2.1.")),
          instances(p=(1, 2, 3), n=(1, 2, 3))])

claim("NWL92-L2.1", "two rank conditions make Z invertible",
      invertible(Zm), sizes=["p", "n"], over=ANY, where=[TWO_BLOCK], given=[FULL_COLUMN_RANK, FULL_ROW_RANK],
      by=[order([R]), steps("NWL92-E2.12", "NWL92-E2.13", "NWL92-E2.14", "NWL92-E2.15",
                facts=["x'Rx = 0 implies Rx = 0 for R >= 0"],
                prose=("A left null vector (x', y') of Z satisfies (2.12) and (2.13); then x'Rx = 0, hence x'R = 0 and "
                       "x'[R H] = 0, so x = 0 as [R H] has full row rank; then y'H' = 0, so y = 0 as H has full column "
                       "rank.")),
          instances(p=(1, 2, 3), n=(1, 2, 3))])

claim("NWL92-E2.10", "the matrix Z is symmetric of size p + n",
      symmetric(Zm) & (T(Zm) * Identity(p + n) == Zm), sizes=["p", "n"], over=ANY, where=[TWO_BLOCK],
      by=[order(), instances(p=(1, 2, 3), n=(1, 2, 3))])

claim("NWL92-E2.11", "a row (x' y') with (x' y')Z = 0 is a null vector of Z, and zero if Z is invertible",
      (hstack(T(x), T(y)) * Zm == T(Zm * vstack(x, y))) & ((invertible(Zm) & (hstack(T(x), T(y)) * Zm == Zero(1, p + n))) >> ((x == Zero(p, 1)) & (y == Zero(n, 1)))),
      sizes=["p", "n"], over={R: symmetric_matrix(p), H: matrix(p, n), x: vector(p), y: vector(n)}, where=[TWO_BLOCK],
      by=[order(), instances(p=(1, 2), n=(1, 2)), example({"p": 1, "n": 1, R: [[0]], H: [[0]], x: [1], y: [1]}),
          instances(made_by={"K": kernel_basis(Zm), x: T(upper(p, n)) * sym("K") * T(sym("K")) * h, y: T(lower(p, n)) * sym("K") * T(sym("K")) * h},
                    using={h: vector(p + n)}, p=(1, 2, 3), n=(1, 2))],
      note="The assumption of a proof; what is checked is that nothing but zero satisfies it once Z is invertible, so that it is what the proof has to refute.")

NULL = given("(2.11)", hstack(T(x), T(y)) * Zm == Zero(1, p + n))
NULL_VECTORS = {R: symmetric_matrix(p), H: matrix(p, n), x: vector(p), y: vector(n)}


def null_vectors(more=None):
    """Instances with a random left null vector of Z."""
    return instances(made_by={**(more or {}), "K": kernel_basis(Zm), x: T(upper(p, n)) * sym("K") * T(sym("K")) * h,
                              y: T(lower(p, n)) * sym("K") * T(sym("K")) * h},
                              using={h: vector(p + n), sym("b"): vector(p)},
                     p=(1, 2, 3), n=(1, 2, 3))


LOW = {R: sym("b") * T(sym("b"))}
#: x'R = [1, 0] = -y'H'; R is not nonnegative, otherwise both would be zero
NOT_NONNEGATIVE = {"p": 2, "n": 1, R: [[0, 1], [1, 0]], H: [[1], [0]], x: [0, 1], y: [-1]}
claim("NWL92-E2.12", "first block of the null vector equation",
      T(x) * R + T(y) * T(H) == Zero(1, p), sizes=["p", "n"], over=NULL_VECTORS, where=[TWO_BLOCK], given=[NULL],
      by=[combination([(1, "(2.11)", upper(p, n))], p=(1, 2, 3), n=(1, 2)), example(NOT_NONNEGATIVE), null_vectors(), null_vectors(LOW)])

claim("NWL92-E2.13", "second block of the null vector equation",
      T(x) * H == Zero(1, n), sizes=["p", "n"], over=NULL_VECTORS, where=[TWO_BLOCK], given=[NULL],
      by=[combination([(1, "(2.11)", lower(p, n))], p=(1, 2, 3), n=(1, 2)), null_vectors(), null_vectors(LOW)])

claim("NWL92-E2.14", "(2.13) transposed and multiplied by y'",
      T(y) * T(H) * x == 0, sizes=["p", "n"], over={H: matrix(p, n), x: vector(p), y: vector(n)},
      given=[given("(2.13)", T(x) * H == Zero(1, n))],
      by=[combination([(T(y), "(2.13)'", 1)], p=(1, 2, 3), n=(1, 2)),
          instances(made_by={"K": kernel_basis(T(H)), x: sym("K") * T(sym("K")) * h}, using={h: vector(p)}, p=(2, 3),
                    n=(1, 2))])

claim("NWL92-E2.15", "(2.12) multiplied by x, with (2.14)",
      T(x) * R * x == 0, sizes=["p", "n"], over={R: symmetric_matrix(p), H: matrix(p, n), x: vector(p), y: vector(n)},
      given=[given("(2.12)", T(x) * R + T(y) * T(H) == Zero(1, p)), given("(2.14)", T(y) * T(H) * x == 0)],
      by=[combination([(1, "(2.12)", x), (-1, "(2.14)", 1)], p=(1, 2, 3), n=(1, 2)),
          instances(made_by={"K": kernel_basis(T(H)), x: sym("K") * T(sym("K")) * h,
                             "M": T(x) * x * Identity(p) - x * T(x),
                             R: sym("M") * S * sym("M") - (H * y * T(x) + x * T(y) * T(H)) / (T(x) * x)
                             + x * (T(x) * H * y) * T(x) / (T(x) * x) ** 2},
                    using={h: vector(p), S: symmetric_matrix(p)}, p=(2, 3), n=(1, 2))],
      note="R >= 0 is not needed here.")

u = sym("u")
claim("NWL92-S5", "end of the proof of Lemma 2.1",
      (T(x) * R == Zero(1, p)) & (u == Zero(p, 1)) & (y == Zero(n, 1)),
      sizes=["p", "n"], over={R: positive_semidefinite(p), H: matrix(p, n), x: vector(p), u: vector(p), y: vector(n)},
      given=[given("x'Rx = 0", T(x) * R * x == 0), given("u'[R H] = 0", T(u) * RH == Zero(1, p + n)),
             given("[R H] has full row rank", invertible(R * R + H * T(H))), given("y'H' = 0", T(y) * T(H) == Zero(1, p)), GRAM],
      by=[order([], [], [T(x) * R * x], [inv(R * R + H * T(H))], [inv(HH)],
                lemmas=[T(x) * R * x * Identity(1) == Zero(1, 1), inv(HH) * T(H) * (H * y) == Zero(n, 1)]),
          instances(made_by={"K": kernel_basis(R), x: sym("K") * T(sym("K")) * h, "M": kernel_basis(H),
                             y: sym("M") * T(sym("M")) * c,
                             "N": kernel_basis(T(RH)), u: sym("N") * T(sym("N")) * h},
                    using={h: vector(p), c: vector(n)}, p=(1, 2, 3), n=(1, 2))],
      note=("The three conclusions in a row: x'Rx = 0 gives x'R = 0; a vector u with u'[R H] = 0 is zero (in the "
            "proof u is x); y'H' = 0 gives y = 0."))

Zi, GAIN = symbols("Zi gain")
REGULAR = (TWO_BLOCK, let(Zi, inv(Zm)), let(GAIN, T(lower(p, n)) * Zi * upper(p, n)))
INVERTIBLE = standing("Z is invertible", invertible(Zm))
wh = sym("wh")
MEASURED = {V: matrix(p, q), H: matrix(p, n), x0: vector(n), w0: vector(q)}
claim("NWL92-E2.16", "the ML estimate when Z is invertible",
      likeliest(xh, wh, y, H, V, w0),
      sizes=["p", "n", "q"], over=MEASURED,
      where=[NOISE, *REGULAR, let(y, H * x0 + V * w0), let(xh, T(lower(p, n)) * Zi * upper(p, n) * y),
             let(wh, T(V) * T(upper(p, n)) * Zi * upper(p, n) * y)],
      given=[INVERTIBLE],
      by=[identity(p=2, n=(1, 2), q=(1, 2)), instances(p=(1, 2, 3), n=(1, 2), q=(1, 2, 3))],
      note=("xh and wh solve y = Hx + Vw, and for any other solution (x0, w0) wh is orthogonal to w0 - wh, so that "
            "w0'w0 = wh'wh + |w0 - wh|^2; xh is determined by wh because H has full column rank."))

claim("NWL92-S6", "the estimate (2.16) is unbiased",
      GAIN * H == Identity(n), sizes=["p", "n"], over=ANY, where=REGULAR, given=[INVERTIBLE],
      by=[identity(p=(2, 3), n=(1, 2)), instances(p=(1, 2, 3), n=(1, 2))])

claim("NWL92-E2.17", "error covariance of (2.16)",
      GAIN * R * T(GAIN) == T(lower(p, n)) * Zi * NOISE_BLOCK * Zi * lower(p, n),
      sizes=["p", "n"], over=ANY, where=REGULAR, given=[INVERTIBLE],
      by=[identity(p=(2, 3), n=(1, 2)), instances(p=(1, 2, 3), n=(1, 2))])

claim("NWL92-E2.18", "splitting diag(R, 0)",
      NOISE_BLOCK == block([[R, Zero(p, n)], [T(H), Zero(n, n)]]) - block([[Zero(p, p), Zero(p, n)],
                                                                                   [T(H), Zero(n, n)]]),
      sizes=["p", "n"], over=ANY, by=[identity(p=(1, 2, 3), n=(1, 2)), instances(**SIZES)])

claim("NWL92-E2.19", "the error covariance is minus a block of the inverse of Z",
      eq(GAIN * R * T(GAIN), T(lower(p, n)) * Zi * NOISE_BLOCK * Zi * lower(p, n),
         -T(lower(p, n)) * Zi * lower(p, n)),
      sizes=["p", "n"], over=ANY, where=REGULAR, given=[INVERTIBLE],
      by=[identity(p=(2, 3), n=(1, 2)), instances(p=(1, 2, 3), n=(1, 2))])

# ------------------------------------------------------------------ redundant perfect measurements
FREE = let(N, kernel_basis(R))
NOISE_FREE = T(N)  # rows: a basis of the combinations d'y with d'R = 0
claim("NWL92-S7", ("[R H] has full row rank exactly if no two independent noise-free combinations measure the same "
                   "thing"),
      iff(rank(RH) == p, ~((size_of(NOISE_FREE) >= 2) & (rank(NOISE_FREE * H) < size_of(NOISE_FREE)))),
      sizes=["p", "n"], over=ANY, where=[FREE],
      by=[example({"p": 2, "n": 1, R: [[1, 0], [0, 0]], H: [[1], [0]]}), instances(p=(1, 2, 3), n=(1, 2))],
      repair=repair("boundary case", ("a single noise-free combination that measures nothing, 0 = 0, already spoils "
                                      "the row rank, and then two independent ones need not exist; the combinations "
                                      "must be called different, not independent"),
                    iff(rank(RH) == p, rank(NOISE_FREE * H) == size_of(NOISE_FREE)),
                    sizes=["p", "n"], over=ANY, where=[FREE], by=[order(), instances(p=(1, 2, 3), n=(1, 2, 3))]),
      note=("The rows of N' are a basis of the combinations d'y without noise, d'R = 0. Two independent ones that "
            "measure the same combination of x exist exactly if there are at least two rows and N'H has dependent "
            "rows. Two different ones exist exactly if N'H has dependent rows."))

# ------------------------------------------------------------------ any (1)-inverse
M, E = symbols("M E")
k = sym("k")
Gx = sym("Gx")
KERNEL, V0 = K * T(K), null_vector()
SEMIREGULAR = T(V0) * K * T(K) * K * T(K) * V0
GRAM_INVERSE = inv(T(K) * K)
SPLITS = [M * KERNEL * K == K, Zm * M * K * (T(K) * K) == 0 * K, Zm * M * K == 0 * K]
claim("NWL92-E2.20", "every symmetric matrix has a symmetric (1)-inverse, and all of them are known",
      invertible(Zm + K * T(K)) & symmetric(Gx) & (Zm * Gx * Zm == Zm) & (G == M + K * T(K) * Y + T(Y) * K * T(K)),
      sizes=["k"], over={Zm: symmetric_matrix(k), G: symmetric_matrix(k), X: matrix(k, k)},
      where=[let(K, kernel_basis(Zm)), let(M, inv(Zm + K * T(K))), let(Gx, M + K * T(K) * X + T(X) * K * T(K)),
             let(E, G - M), let(Y, M * (E - half * E * K * T(K) * M))],
      given=[given("(2.20)", Zm * G * Zm == Zm)],
      by=[order([T(K) * K], [], [SEMIREGULAR], [], [], [T(V0) * V0], [], *([[], [], [GRAM_INVERSE], []] * 2), lemmas=[invertible(T(K) * K)],
                inside=[within(1, SEMIREGULAR * Identity(1) == Zero(1, 1), KERNEL * V0 == Zero(k, 1), T(K) * V0 == 0 * (T(K) * V0), Zm * V0 == Zero(k, 1),
                               vector="right"), *(within(number, *SPLITS) for number in (3, 4))]),
          instances(made_by={"N": kernel_basis(Zm), G: any_one_inverse(Zm, L, sym("N"))}, using={L: matrix(k, k)},
                    k=(1, 2, 3, 4))],
      note=("A definition; what is checked is that it is not empty, and the general form from which the instances of "
            "the other claims are drawn: Gx for any X. The columns of K are a basis of the null space of Z."))

XH = let(xh, T(lower(p, n)) * Zd * upper(p, n) * y)
WH = let(wh, T(V) * T(upper(p, n)) * Zd * upper(p, n) * y)
ML_LETS = [NOISE, *PAIR, let(y, H * x0 + V * w0), XH, WH]
ML_PROOF = chained(block_identities(R, H, W, U, Tb, n, p), root_identities(R, V, H, W, U, p), ([y == H * xh + V * wh], [[]]))
ML_DRAWN = inverses(p=(1, 2, 3), n=(1, 2), q=(1, 2, 3))
claim("NWL92-L2.2", "any symmetric (1)-inverse of Z gives the ML estimate and its error covariance",
      likeliest(xh, wh, y, H, V, w0) & (x0 - xh == inv(HH) * T(H) * V * (wh - w0)) & (T(U) * H == Identity(n)) & (T(U) * R * U == -Tb),
      sizes=["p", "n", "q"], over={**MEASURED, **BLOCKS}, where=ML_LETS, given=[ONE_INVERSE, IMPLIED_RANK], by=[ML_PROOF, ML_DRAWN],
      note="xh is (2.21), and the first two parts are NWL92-E2.21; the estimate is unbiased, and U'RU is the covariance of its error U'v.")

claim("NWL92-E2.21", "the ML estimate through any symmetric (1)-inverse",
      likeliest(xh, wh, y, H, V, w0) & (x0 - xh == inv(HH) * T(H) * V * (wh - w0)),
      sizes=["p", "n", "q"], over={**MEASURED, **BLOCKS}, where=ML_LETS,
      given=[ONE_INVERSE, IMPLIED_RANK],
      by=[ML_PROOF, ML_DRAWN],
      note=("Of all (x, w) with y = Hx + Vw, (xh, wh) has the smallest w'w, as w0'w0 = wh'wh + |w0 - wh|^2; the last "
            "equation says that no other x goes with wh. V is any square root of R. Full column rank is the "
            "denominator det H'H."))

claim("NWL92-L2.2.1", "the estimate (2.21) is unbiased",
      T(lower(p, n)) * Zd * upper(p, n) * H == Identity(n),
      sizes=["p", "n"], over=SETTING, where=PAIR, given=[ONE_INVERSE, GRAM],
      by=[every_size(), inverses()])

claim("NWL92-E2.22", "the error covariance is minus a block of any symmetric (1)-inverse",
      T(U) * R * U == -T(lower(p, n)) * Zd * lower(p, n),
      sizes=["p", "n"], over=SETTING, where=PAIR, given=[ONE_INVERSE, GRAM],
      by=[every_size(), inverses()],
      note="The error of the estimate U'y is U'v, as U'H = I.")

claim("NWL92-E2.23", "a matrix in blocks is symmetric exactly if it has the form (2.23)",
      iff(symmetric(block([[W, U], [L, Tb]])), symmetric(W) & symmetric(Tb) & (L == T(U))),
      sizes=["p", "n"], over={W: matrix(p, p), U: matrix(p, n), L: matrix(n, p), Tb: matrix(n, n)},
      by=[instances(p=(1, 2), n=(1, 2)), instances(made_by={L: T(U)}, p=(1, 2), n=(1, 2)),
          instances(made_by={W: X + T(X), Tb: Y + T(Y), L: T(U)}, using={X: matrix(p, p), Y: matrix(n, n)}, p=(1, 2),
                    n=(1, 2)),
          instances(made_by={W: X + T(X), Tb: Y + T(Y)}, using={X: matrix(p, p), Y: matrix(n, n)}, p=(1, 2), n=(1, 2))],
      note="A definition of names; what is checked is that the form is general.")

claim("NWL92-S8", "the block T is the same for all symmetric (1)-inverses",
      Tb == T2, sizes=["p", "n"], over={**SETTING, **SECOND}, where=[*PAIR, SECOND_INVERSE],
      given=[ONE_INVERSE, SECOND_GIVEN, GRAM], by=[every_size(second=True), two_inverses()])

k, x = symbols("k x")
#: measurements without noise, the second of them of nothing
NULL_DIRECTION = {"p": 2, "n": 1, R: [[0, 0], [0, 0]], H: [[1], [0]], W: [[0, 0], [0, 0]], U: [[1], [0]], Tb: [[0]], k: [0, 1], x: [0], h: [1]}
NOT_UNIQUE = given("null vector of Z", Zm * vstack(k, x) == Zero(p + n, 1))
claim("NWL92-S9", "if Z is singular, neither W nor U is unique; otherwise both are",
      (Zm * Ze * Zm == Zm) & ((vstack(k, x) != Zero(p + n, 1)) >> ((W2 != W) & (U2 != U))) & (invertible(Zm) >> (Zd == inv(Zm))),
      sizes=["p", "n"], over={**SETTING, k: vector(p), x: vector(n), h: vector(n)},
      where=[*PAIR, let(W2, W + k * T(k)), let(U2, U + k * T(h)), let(Ze, block([[W2, U2], [T(U2), Tb]]))],
      given=[ONE_INVERSE, FULL_COLUMN_RANK, NOT_UNIQUE, given("h is a unit vector", T(h) * h == 1)],
      by=[order([], [], [], [T(k) * R * k], [], [k * T(k)], [],
                lemmas=[T(H) * k == Zero(n, 1), T(k) * (R * k + H * x) == 0, T(k) * R * k * Identity(1) == Zero(1, 1), R * k == Zero(p, 1)]),
          example(NULL_DIRECTION), example({**NULL_DIRECTION, h: [0]}), example({**NULL_DIRECTION, H: [[0], [0]], x: [1], k: [0, 0]}),
          inverses(made_by={sym("kz"): kernel_basis(Zm), k: T(upper(p, n)) * sym("kz") * T(sym("kz")) * c, x: Zero(n, 1), h: column(i, n, when(i == 1, 1, 0))},
                   using={c: vector(p + n)})],
      note=("A singular Z has a null vector (k; x) that is not zero. With it another symmetric (1)-inverse Ze is written down, in which both W and U differ. "
            "n >= 1, as h is a unit vector."))

claim("NWL92-E2.24", "the ML estimate is U'y",
      (xh == T(U) * y) & likeliest(T(U) * y, wh, y, H, V, w0) & (x0 - T(U) * y == inv(HH) * T(H) * V * (wh - w0)),
      sizes=["p", "n", "q"], over={**MEASURED, **BLOCKS}, where=ML_LETS, given=[ONE_INVERSE, IMPLIED_RANK], by=[ML_PROOF, ML_DRAWN],
      note="As for NWL92-E2.21.")

claim("NWL92-S10", "the error covariance -T is the same for all symmetric (1)-inverses",
      eq(T(U) * R * U, -Tb, T(U2) * R * U2),
      sizes=["p", "n"], over={**SETTING, **SECOND}, where=[*PAIR, SECOND_INVERSE],
      given=[ONE_INVERSE, SECOND_GIVEN, GRAM], by=[every_size(second=True), two_inverses()])

claim("NWL92-E2.25", "Z times the last block column of a symmetric (1)-inverse",
      Zm * vstack(U, Tb) == vstack(Zero(p, n), Identity(n)),
      sizes=["p", "n"], over=SETTING, where=PAIR, given=[ONE_INVERSE, GRAM],
      by=[every_size(), inverses()])

# ------------------------------------------------------------------ H of any rank
#: H'GHH' - H' for a (1)-inverse G of HH'
RANGE = T(H) * G * H * T(H) - T(H)
claim("NWL92-S11", "c'x is estimable exactly if c lies in the range of H'",
      iff(T(d) * H * X == T(c) * X, T(H) * d == c) & ((T(H) * d == c) >> (T(H) * G * H * c == c)),
      sizes=["p", "n"], over={H: matrix(p, n), c: vector(n), d: vector(p), X: nonsingular(n), G: symmetric_matrix(p)},
      given=[given("(1)-inverse of HH'", H * T(H) * G * H * T(H) == H * T(H))],
      by=[order([], [], [T(RANGE) * RANGE], [], [], [], lemmas=[H * RANGE == Zero(p, p), T(RANGE) * RANGE * Identity(p) == Zero(p, p), RANGE == Zero(n, p)]),
          instances(made_by={G: any_one_inverse(H * T(H), Y)}, using={Y: matrix(p, p)}, p=(1, 2, 3), n=(1, 2, 3)),
          instances(made_by={G: any_one_inverse(H * T(H), Y), c: T(H) * d}, using={Y: matrix(p, p)}, p=(1, 2, 3), n=(1, 2, 3))],
      note=("The mean of d'y is d'Hx. It is c'x for every x, here for the n independent ones that are the columns of X, exactly if H'd = c. The second "
            "statement tests the range: c = H'd for some d exactly if H'G Hc = c."))

H1, H2 = symbols("H1 H2")
FACTORS = [given("H1 has full column rank", rank(H1) == r), given("H2 has full row rank", rank(H2) == r)]
H1_LEFT, H2_RIGHT = inv(T(H1) * H1) * T(H1), T(H2) * inv(H2 * T(H2))
claim("NWL92-S12", "the estimable combinations are those of z = H2 x",
      (rank(H1 * H2) == r) & ((T(H1 * H2) * d == c) >> (T(H2) * (T(H1) * d) == c)) & ((T(H2) * h == c) >> (T(H1 * H2) * (H1 * inv(T(H1) * H1) * h) == c)),
      sizes=["p", "n", "r"], over={H1: matrix(p, r), H2: matrix(r, n), c: vector(n), d: vector(p), h: vector(r)}, given=FACTORS,
      by=[order([H1, H2, H1_LEFT, H2_RIGHT]), instances(made_by={c: T(H1 * H2) * d}, p=(1, 2, 3), n=(1, 2, 3), r=(1, 2)),
          instances(made_by={c: T(H2) * h}, p=(1, 2, 3), n=(1, 2, 3), r=(1, 2))],
      note=("c'x is estimable exactly if c = H'd for some d (NWL92-S11), and a combination of the entries of z exactly if c = H2'h for some h: each of them "
            "gives the other."))

Z1, Zi1, W1, U1, T1, Y1, G1, zh = symbols("Z1 Zi1 W1 U1 T1 Y1 G1 zh")
FACTORED = {H1: matrix(p, r), H2: matrix(r, n)}
BLOCKS_1 = {W1: symmetric_matrix(p), U1: matrix(p, r), T1: symmetric_matrix(r)}
PAIR_1 = (let(H, H1 * H2), let(Z1, two_block(R, H1, r)), let(Zi1, block([[W1, U1], [T(U1), T1]])))
BOTH = [given("(1)-inverse of Z1", Z1 * Zi1 * Z1 == Z1), ONE_INVERSE, *FACTORS]
RANKS_IMPLIED = [*BOTH[:2], standing("H1 has full column rank", rank(H1) == r),
                 given("H2 has full row rank", rank(H2) == r)]
H2_ANY = [*BOTH[:3], standing("H2 has full row rank", rank(H2) == r)]
ANY_RANK = {"p": (1, 2, 3), "n": (1, 2, 3), "r": (1, 2)}


def factored(**sizes):
    """Instances with a full rank factorisation and random (1)-inverses of both 2-block matrices."""
    made, free = made_inverse(Z1, (W1, U1, T1), p, r, Y1, G1)
    return inverses(made_by=made, using=free, **{**ANY_RANK, **sizes})


#: both problems, and H2 U'H1 = I
REDUCED = (block_identities(R, H1, W1, U1, T1, r, p), any_rank_identities(R, H, W, U, Tb, n, p), ([H2 * T(U) * H1 == Identity(r)], [[]]))
#: both gains for z agree on the range of R: their difference annihilates H1, and times R it is a multiple of H1'
APART = T(U1) - H2 * T(U)
SAME_ON_NOISE = ([APART * R == (H2 * Tb * T(H2) - T1) * T(H1), APART * R * T(APART) * Identity(r) == Zero(r, r), R * T(APART) == Zero(p, r)],
                 [[], [], [APART * R * T(APART)]])

claim("NWL92-E2.26", "two forms of the ML estimate of z = H2 x",
      likeliest(zh, wh, y, H1, V, w0) & eq(zh, hstack(Zero(r, p), H2) * Zd * upper(p, n) * y,
                                           H2 * x0 - inv(T(H1) * H1) * T(H1) * V * (wh - w0)),
      sizes=["p", "n", "r", "q"], over={V: matrix(p, q), **FACTORED, x0: vector(n), w0: vector(q), **BLOCKS_1,
                                        **BLOCKS},
      where=[NOISE, *PAIR_1, *PAIR, let(y, H * x0 + V * w0), let(zh, T(lower(p, r)) * Zi1 * upper(p, r) * y),
             let(wh, T(V) * T(upper(p, r)) * Zi1 * upper(p, r) * y)],
      given=RANKS_IMPLIED,
      by=[chained(*REDUCED, root_identities(R, V, H1, W1, U1, p), SAME_ON_NOISE, ([T(V) * T(APART) == Zero(q, r), y == H1 * zh + V * wh],
                                                                                 [[APART * V * T(V) * T(APART)], []])),
          factored(q=(1, 2))],
      note=("For measurements y = Hx + v with v in the range of R, where they lie with probability one; for other y "
            "the two forms may differ. Of all (x, w) with y = Hx + Vw, wh is the smallest w, and H2 x is the same for "
            "all x that go with it."))

claim("NWL92-S13", "both forms of the estimate of z are unbiased",
      (T(U1) * H == H2) & (H2 * T(U) * H == H2),
      sizes=["p", "n", "r"], over={R: positive_semidefinite(p), **FACTORED, **BLOCKS_1, **BLOCKS},
      where=[*PAIR_1, *PAIR],
      given=H2_ANY, by=[chained(*REDUCED), factored()],
      note="z = H2 x and E y = Hx.")

claim("NWL92-E2.27", "two forms of the error covariance of z, as printed with a factor y",
      eq(T(U1) * R * U1, -T(lower(p, r)) * Zi1 * lower(p, r),
         -hstack(Zero(r, p), H2) * Zd * vstack(Zero(p, r), T(H2)) * y),
      sizes=["p", "n", "r"], over={R: positive_semidefinite(p), **FACTORED, **BLOCKS_1, **BLOCKS, y: vector(p)},
      where=[*PAIR_1, *PAIR],
      given=BOTH,
      by=[example({"p": 1, "n": 1, "r": 1, R: [[1]], H1: [[1]], H2: [[1]], W1: [[0]], U1: [[1]], T1: [[-1]], W: [[0]],
                   U: [[1]],
                   Tb: [[-1]], y: [2]}), factored()],
      repair=repair("other", ("a factor y stands at the end of the second form, where its size does not even fit; "
                              "the covariance does not depend on the data"),
                    eq(T(U1) * R * U1, -T(lower(p, r)) * Zi1 * lower(p, r),
                       -hstack(Zero(r, p), H2) * Zd * vstack(Zero(p, r), T(H2))),
                    sizes=["p", "n", "r"], over={R: positive_semidefinite(p), **FACTORED, **BLOCKS_1, **BLOCKS},
                    where=[*PAIR_1, *PAIR],
                    given=BOTH, by=[chained(*REDUCED, SAME_ON_NOISE), factored()]))
