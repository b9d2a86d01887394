# SPDX-License-Identifier: MIT
"""Section IV, (4.14)-(4.28): Corollary 4.3, stochastic realizations, linear models, the equation of the error covariance.

For any pi_0 put alpha = alpha_0/(1 - pi_0) and gamma^2 = |phi(pi_0)|/(1 - pi_0)^2. If phi(pi_0) >= 0 the point is on the hyperbola of (alpha_0, gamma_0) and
its orbit under the algorithm gives pi_t = 1 - alpha_0/alpha_t; if phi(pi_0) <= 0 the same holds with i gamma for gamma, on the circle-like curve 1 + alpha^2 +
gamma^2 = (2/kappa) alpha, which exists for |kappa| <= 1 only.

For positive real (alpha_0, gamma_0) the states of variance pi have noise covariance [[(1 - a^2) pi, gamma_0 + a pi], [gamma_0 + a pi, 1 - pi]] with determinant
-phi(pi): they are stochastic systems exactly for p_+ <= pi <= p_-. Factoring that matrix with a triangular root gives b_1 and b_2, and
alpha - a = b_1/sqrt(1 - pi), gamma = b_2/sqrt(1 - pi) is the point above. The noise of the state is b u, that of the output d u.

A line through the origin with slope m = y/x is moved by a matrix A to slope (a_21 + a_22 m)/(a_11 + a_12 m), in continuous time at the rate a_21 + (a_22 -
a_11)m - a_12 m^2. (With x/y the indices 1 and 2 change places.)
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import (
    angles,
    arithmetic,
    at_index,
    by_cases,
    by_induction,
    cleared,
    combination,
    example,
    existing,
    generic_index,
    identity,
    induction,
    instances,
    multiplied,
    restated,
    shown_first,
    square_of,
    steps,
    valued,
)
from exactkf.language import *
from proofs.blm91.lemmas_error import (
    BY_ERROR,
    BY_RICCATI_OF_ERROR,
    CLOSED_FOR_ERROR,
    ERROR,
    ERROR_LEMMAS,
    FROM_STATE,
    RICCATI_OF_ERROR,
    SAME_ERROR,
    err,
    next_error,
    rec_p,
)
from proofs.blm91.lemmas_estimate import PROJECTED, SOME, Pi
from proofs.blm91.lemmas_gain import SYSTEM
from proofs.blm91.notation import *

pit, phi_, y, p, b1, b2, root, Qn, Sn, Rn, noise, A, A1, B, okay, inside, first, sec, bal, bga, rest, there, fx, gx, mob, same, whole, infinite, v = symbols(
    "pi_t phi_0 y p b_1 b_2 root Q S R noise A A1 B admissible inside alpha_bar gamma_bar alpha_next gamma_next at_rest there f_x g_x mobius same multiple infinite v")
POINT = {al0: nonzero(), ga0: scalar()}
MAP = (let(a, al0 - ga0), rec(pit, t, x, a**2 * pit[t] + (ga0 + a * pit[t]) ** 2 / (1 - pit[t])))
PHI = let(phi_, x**2 - (1 - al0**2 + ga0**2) * x + ga0**2)
FIRST_BAR = let(first, al0 / (1 - x))


def orbit(sign):
    """(4.14) for sign 1, (4.17) for sign -1, from (alpha_bar, gamma_bar)."""
    return rec(al, t, first, al[t] / (1 - sign * ga[t] ** 2)), rec(ga, t, sec, -al[t] * ga[t] / (1 - sign * ga[t] ** 2))


ROOT_PLUS = given("gamma_bar", sec**2 * (1 - x) ** 2 == phi_)
ROOT_MINUS = given("gamma_bar", sec**2 * (1 - x) ** 2 == -phi_)
#: two points of the hyperbola of lambda; a point of it and one of the other curve
TWO_POINTS = dict(using={u: scalar(), w: scalar(), y: scalar()},
                  made_by={al0: 2 * (y + u) / (1 - u**2), ga0: 1 + u * al0, x: 1 - al0 * (1 - w**2) / (2 * (y + w)), sec: 1 + w * 2 * (y + w) / (1 - w**2)})
LINE_P = {al0: (p * y**2 - 1 / p) / (y**2 - 1), ga0: y * (p - 1 / p) / (y**2 - 1)}
INNER = dict(using={u: nonzero(), w: scalar(), y: scalar(), p: nonzero()}, made_by={
    p: SHARE, **LINE_P, x: 1 - al0 / (p + (1 / p - p) / (1 + w**2)), sec: w * (1 / p - p) / (1 + w**2)})
DATA_BAR = {**POINT, x: scalar(), sec: scalar()}
GIVEN_NOTE = "x = pi_0; gamma_bar is either root of phi(pi_0)/(1 - pi_0)^2 up to sign, so that the sign of the print's square root is included. m is the time."


def curves(sign):
    """Hints: (4.15) or (4.18) at every i, and alpha_j (1 - pi_j) = alpha_0 at every j, where the values exist."""
    on_curve = defined(al[i]) >> (al0 * (1 + al[i] ** 2 - sign * ga[i] ** 2) == (1 + al0**2 - ga0**2) * al[i])
    both = defined(al[j]) & defined(pit[j])
    return [by_induction(i, 0, on_curve, base=[cleared(), *values_at(0)], step=[cleared(), *values_at(i + 1), multiplied(ga[i] ** 2)]),
            by_induction(j, 0, both >> (al[j] * (1 - pit[j]) == al0), base=[cleared(), *values_at(0, al, ga, pit)],
                         step=[cleared(), at_index(i, j), *values_at(j + 1, al, ga, pit), by_cases(al[j] == 0), by_cases(pit[j] == 1 - al0 / al[j]),
                               *map(multiplied, (al0, ga[j] ** 2, al[j] ** 2, al[j] ** 3, al0 * al[j], al0 * al[j] ** 2))])]


def increments(sign):
    """Hints: the increment of the solution at m."""
    phi_at = pit[p] ** 2 - (1 - al0**2 + ga0**2) * pit[p] + ga0**2 == sign * (1 - pit[p]) ** 2 * ga[p] ** 2
    return [valued(), cleared(), *curves(sign),
            shown_first(forall(p, 0, m, (defined(al[p]) & defined(pit[p])) >> phi_at),
                        [cleared(), at_index(i, p), at_index(j, p), by_cases(al[p] == 0), by_cases(pit[p] == 1 - al0 / al[p]), *map(multiplied, (al0, al[p], al0 * al[p]))]),
            existing(ga, m), existing(al, m), at_index(p, m), *values_at(m + 1, pit), multiplied(1 - pit[m])]


# ---------------------------------------------------------------------- Corollary 4.3
claim("BLM91-E4.14", "(4.14) is (3.10)", always(t, (al[t] == bal[t]) & (ga[t] == bga[t])), over={al0: scalar(), ga0: scalar()},
      where=[*ORBIT, rec(bal, t, al0, bal[t] / (1 - bga[t] ** 2)), rec(bga, t, ga0, -bal[t] * bga[t] / (1 - bga[t] ** 2))], by=[induction(), instances()])
UNIT_I = rows([[0, -1], [1, 0]])
claim("BLM91-E4.17", "(4.17) is (3.10) with i gamma for gamma",
      (al0 * inv(Identity(2) - (ga0 * UNIT_I) ** 2) == al0 / (1 + ga0**2) * Identity(2)) & (-al0 * (ga0 * UNIT_I) * inv(Identity(2) - (ga0 * UNIT_I) ** 2) == -al0 * ga0 / (1 + ga0**2) * UNIT_I),
      over={al0: scalar(), ga0: scalar()}, by=[identity(), instances()], note="The display defines the system; i is the matrix with square -1. The step is real: i gamma goes to i gamma'.")
gsq = sym("gamma_0sq")
BAR = {al0: nonzero(), x: scalar(), sec: scalar()}


def squared(sign):
    """gamma_0^2 from gamma_bar, 1/kappa from alpha_0 and gamma_0^2, phi(pi_0)."""
    return (let(gsq, (sign * sec**2 * (1 - x) ** 2 - x**2 + (1 - al0**2) * x) / (1 - x)), FIRST_BAR, let(lam, (1 + al0**2 - gsq) / (2 * al0)), let(phi_, x**2 - (1 - al0**2 + gsq) * x + gsq))


CURVE_P = 1 + al[m] ** 2 - ga[m] ** 2 == 2 * lam * al[m]
CURVE_M = 1 + al[m] ** 2 + ga[m] ** 2 == 2 * lam * al[m]
PLUS_W, MINUS_W = [FIRST_BAR, LAMBDA, PHI, *orbit(1), rec(r, t, 1, (1 - ga[t] ** 2) * r[t])], [FIRST_BAR, LAMBDA, PHI, *orbit(-1), rec(r, t, 1, (1 + ga[t] ** 2) * r[t])]
BY_PLUS = [instances(30, m=(0, 1, 2), **TWO_POINTS)]
BY_MINUS = [instances(30, m=(0, 1, 2), **INNER)]
SQUARED = "x = pi_0. Of gamma_0 only the square enters, written gamma_0sq: the number for which (gamma_bar(1 - pi_0))^2 is phi(pi_0), or its negative."
claim("BLM91-E4.15", "the integral curve for phi >= 0", always(t, (1 + al[t] ** 2 - ga[t] ** 2 == 2 * lam * al[t]) & (phi_ == sec**2 * (1 - x) ** 2)), over=BAR, where=[*squared(1), *orbit(1)],
      by=[induction(cofactors=[[(1 / (1 - ga[t] ** 2), 0, 1)], []]), instances(30)], note=SQUARED)
claim("BLM91-E4.18", "the integral curve for phi <= 0", always(t, (1 + al[t] ** 2 + ga[t] ** 2 == 2 * lam * al[t]) & (phi_ == -(sec**2 * (1 - x) ** 2))), over=BAR, where=[*squared(-1), *orbit(-1)],
      by=[induction(cofactors=[[(1 / (1 + ga[t] ** 2), 0, 1)], []]), instances(30)], note=SQUARED)
SOLVED = pit[m] == 1 - al0 / al[m]
claim("BLM91-C4.3.1", "phi >= 0: the orbit on the hyperbola and the solution", CURVE_P & SOLVED, sizes=["m"], over=DATA_BAR, where=[*PLUS_W, *MAP], given=[ROOT_PLUS],
      by=[arithmetic(valued(), cleared(), *curves(1), at_index(i, m), at_index(j, m)), *BY_PLUS], note=GIVEN_NOTE)
claim("BLM91-C4.3.2", "phi <= 0: the orbit on the other curve and the solution", CURVE_M & SOLVED, sizes=["m"], over=DATA_BAR, where=[*MINUS_W, *MAP], given=[ROOT_MINUS],
      by=[arithmetic(valued(), cleared(), *curves(-1), at_index(i, m), at_index(j, m)), *BY_MINUS], note=GIVEN_NOTE)
claim("BLM91-E4.16", "the solution by either orbit", SOLVED, sizes=["m"], over={**DATA_BAR, k: integer(0, 1)},
      where=[FIRST_BAR, PHI, *MAP, rec(al, t, first, al[t] / (1 - (2 * k - 1) * ga[t] ** 2)), rec(ga, t, sec, -al[t] * ga[t] / (1 - (2 * k - 1) * ga[t] ** 2))],
      given=[given("gamma_bar", sec**2 * (1 - x) ** 2 == (2 * k - 1) * phi_)],
      by=[arithmetic(by_cases(k == 0), valued(), cleared(), *curves(2 * k - 1), at_index(j, m)),
          instances(30, m=(0, 1, 2), using=TWO_POINTS["using"], made_by={**TWO_POINTS["made_by"], k: 1}), instances(30, m=(0, 1, 2), using=INNER["using"], made_by={**INNER["made_by"], k: 0})],
      note="k = 1: (4.14), phi >= 0; k = 0: (4.17), phi <= 0. " + GIVEN_NOTE)
claim("BLM91-C4.3.3", "phi <= 0 only for |kappa| <= 1", kap**2 <= 1, over={**POINT, x: scalar()}, where=[let(kap, 2 * al0 / (1 + al0**2 - ga0**2)), PHI], given=[given("phi <= 0", phi_ <= 0)],
      by=[arithmetic(valued(), cleared(), square_of(2 * x - (1 - al0**2 + ga0**2))),
          instances(40, using={u: nonzero(), y: scalar()}, made_by={al0: (SHARE * y**2 - 1 / SHARE) / (y**2 - 1), ga0: y * (SHARE - 1 / SHARE) / (y**2 - 1), x: (1 - al0**2 + ga0**2) / 2}), instances(20),
          example(alpha0=1, gamma0=1, x=0), example(alpha0="1/2", gamma0="1/2", x="1/2")], note="x = pi_0.")
FX = let(fx, ((al0**2 - ga0**2) * x + ga0**2) / (1 - x))
FACTOR_PHI = (al0 / (1 - pit[t])) ** 2
claim("BLM91-S48", "the sign of phi is kept", always(t, pit[t] ** 2 - (1 - al0**2 + ga0**2) * pit[t] + ga0**2 == r[t] ** 2 * phi_), over={**POINT, x: scalar()}, where=[PHI, *MAP, rec(r, t, 1, al0 / (1 - pit[t]) * r[t])],
      by=[induction(cofactors=[[(FACTOR_PHI, 0, 1)]]), instances()],
      note="phi(pi_t) is phi(pi_0) times the square of a real number, the product of the alpha_0/(1 - pi_s), s < t: it is not negative if phi(pi_0) is not.")
claim("BLM91-E4.19", "the increment for phi >= 0", pit[m + 1] - pit[m] == (1 - pit[m]) * ga[m] ** 2, sizes=["m"], over=DATA_BAR, where=[FIRST_BAR, PHI, *MAP, *orbit(1)], given=[ROOT_PLUS],
      by=[arithmetic(*increments(1)), *BY_PLUS], note=GIVEN_NOTE)
claim("BLM91-S49", "the increment for phi <= 0", pit[m + 1] - pit[m] == -((1 - pit[m]) * ga[m] ** 2), sizes=["m"], over=DATA_BAR, where=[FIRST_BAR, PHI, *MAP, *orbit(-1)], given=[ROOT_MINUS],
      by=[arithmetic(*increments(-1)), *BY_MINUS], note=GIVEN_NOTE)
SQUARES = fx(x) + y**2 == (x - lam) ** 2 + y**2 + (1 - lam**2)
claim("BLM91-F5", "the two families of curves",
      SQUARES & (fx(0) == 1) & ((lam**2 > 1) >> ((fx(lam) < 0) & (root**2 + fx(lam) == 0))) & ((lam**2 < 1) >> ~there),
      over={lam: scalar(), x: scalar(), y: scalar()}, where=[function(fx, [x], 1 + x**2 - 2 * lam * x), let(root, sqrt(lam**2 - 1)), let(there, y**2 == -fx(x))],
      by=[arithmetic(member=0), arithmetic(member=1), arithmetic(angles("root", lam**2 - 1), member=2), arithmetic(square_of(x - lam), square_of(y), member=3),
          instances(40), instances(40, using={w: nonzero()}, made_by={lam: (w + 1 / w) / 2}),
          *(example({"lambda": l_, "x": x_, "y": y_}) for l_, x_, y_ in ((1, 0, 0), (1, 1, 0), ("5/4", "5/4", 0), ("5/4", "5/4", "3/4"), ("-5/4", "-5/4", 1), ("9/10", "9/10", 0), ("3/5", 0, 0), ("5/3", 3, 1)))],
      note="lambda = 1/kappa, (x, y) a point; (4.15) is y^2 = f(x), which (0, 1) is on for every kappa, and (4.18) is y^2 = -f(x), which for |kappa| < 1 has the point with x = lambda and y = sqrt(lambda^2 - 1), and for |kappa| > 1 has none (there: (x, y) is on it). "
           "The print names the curves after Corollary 4.2; they are those of Corollary 4.3. On the instances the square root is rational.")

# ---------------------------------------------------------------------- Remark 4.4
NOISE = (let(a, al0 - ga0), let(Qn, (1 - a**2) * x), let(Sn, ga0 + a * x), let(Rn, 1 - x))
DIAMOND = standing("diamond", abs(al0) + abs(ga0) < 1)
ROOT = given("p on the hyperbola", p * (1 + al0**2 - ga0**2) == (1 + p**2) * al0)
PQ = u / (1 + abs(u))
S3 = s1 + s1 / abs(s1)
IN_D = {p: PQ, al0: p * (S3**2 - 1) / (S3**2 - p**2), ga0: S3 * (p**2 - 1) / (S3**2 - p**2)}
BETWEEN = 1 - al0 / (p + (1 / p - p) / (1 + y**2))
PHI_X = x**2 - (1 - al0**2 + ga0**2) * x + ga0**2
#: p phi = (p - p x - alpha_0)(1 - x - alpha_0 p), p alpha_0 > 0, and R > 0 with QR - S^2 >= 0 makes Q >= 0
BETWEEN_ROOTS = (shown_first(p * al0 > 0, [by_cases(1 + al0**2 - ga0**2 > 0), by_cases(p**2 > 0), by_cases(al0**2 > 0), multiplied(p), multiplied(al0)]),
                 shown_first(p * PHI_X == (p - p * x - al0) * (1 - x - al0 * p)), by_cases(p > 0), by_cases(p**2 < 1), by_cases(x < 1),
                 by_cases(p * (al0 - p**2 * al0) > 0), by_cases(1 - x - al0 * p > 0), by_cases(p - p * x - al0 > 0), by_cases(1 - x - al0 * p < 0), by_cases(p - p * x - al0 < 0), by_cases(PHI_X <= 0), square_of(ga0 + (al0 - ga0) * x), cleared())
claim("BLM91-R4.4.1", "the variances of stochastic systems", iff(okay, inside) & (det(noise) == -phi_), over={**POINT, p: nonzero(), x: scalar()},
      where=[*NOISE, PHI, let(noise, rows([[Qn, Sn], [Sn, Rn]])), let(okay, psd(noise)), let(inside, (1 - al0 / p <= x) & (x <= 1 - al0 * p))], given=[ROOT, DIAMOND, standing("smaller root", abs(p) < 1)],
      by=[arithmetic(member=1), arithmetic(*BETWEEN_ROOTS, member=0),
          instances(40, using={u: nonzero(), s1: nonzero(), y: scalar()}, made_by={**IN_D, x: BETWEEN}), instances(40, using={u: nonzero(), s1: nonzero(), y: scalar()}, made_by={**IN_D, x: y})],
      note="[p_+, p_-] with p_+ = 1 - alpha_0/alpha_+. A system with state variance x exists when the noise covariance [[(1 - a^2)x, gamma_0 + ax], [., 1 - x]] is semidefinite.")
TRIANGLE = (let(x, 1 - root**2), *NOISE, let(b1, Sn / root), let(B, rows([[b1, b2], [root, 0]])))
B2 = given("b_2", b2**2 == Qn - b1**2)
OVER_B = {al0: scalar(), ga0: scalar(), root: nonzero(), b2: scalar()}
#: rational solutions of b_2^2 = Q - b_1^2 in the diamond
FACTORED = [example(alpha0=f, gamma0=g_, root=r_, b_2=b_) for f, g_, r_, b_ in (
    ("1/8", "-3/7", "1/7", "3/14"), ("1/2", "3/7", "5/7", "9/35"), ("-1/8", "3/4", "1/5", "3/20"), ("-1/8", "3/8", "1/2", "-3/4"), ("1/8", "-3/7", "7/8", "3/14"), ("4/7", "1/3", "6/7", "4/21"),
    ("-2/7", "-2/3", "3/7", "2/21"), ("-1/4", "-3/5", "1/2", "9/20"), ("1/2", 0, "1/2", 0))]
ENTRY = (rows([[1], [0]]), rows([[1, 0]]))
claim("BLM91-E4.20", "the noise of a realization by a triangular factor", B * T(B) == rows([[Rn, Sn], [Sn, Qn]]), over=OVER_B, where=TRIANGLE, given=[B2, DIAMOND],
      by=[FACTORED[0], *FACTORED[1:]],
      repair=repair("order of factors", "the vector is (v_t, w_t)', not (w_t, v_t)': the row d = (r_0^(1/2), 0) is that of the output noise, whose variance is 1 - pi_0", B * T(B) == rows([[Qn, Sn], [Sn, Rn]]), over=OVER_B, where=TRIANGLE, given=[B2],
                    by=[combination([(ENTRY[0], "b_2", ENTRY[1])]), restated("a vector with covariance MM' is M times a normalized white noise"), *FACTORED]),
      note="root is r_0^(1/2), pi_0 = 1 - root^2; the covariance of (v, w) is [[Q, S], [S, R]] with Q = (1 - a^2) pi_0, S = gamma_0 + a pi_0, R = 1 - pi_0. b_1 is S/root; b_2 exists when phi(pi_0) <= 0.")
claim("BLM91-E4.21", "the point of Corollary 4.3 from the factor", (b1 / root + a == al0 / (1 - x)) & ((b2 / root) ** 2 == -phi_ / (1 - x) ** 2), over=OVER_B, where=[*TRIANGLE, PHI], given=[B2],
      by=[combination([[], [(1 / root**2, "b_2", 1)]]), *FACTORED], note="The display defines (alpha_bar, gamma_bar) = (b_1/root + a, b_2/root); checked is that it is the point of Corollary 4.3, phi being negative.")
STEP_K = [(al0 * al[t] / (1 - pit[t]), 3, 1), (1, 4, 1)]
NOISE_K = al0 / al[t] * rows([[(al[t] - a) ** 2 + ga[t], al[t] - a], [al[t] - a, 1]])
CURVE_K = al0 * (1 + al[t] ** 2 + ga[t]) / al[t] == 1 + al0**2 - ga0**2
FACTOR_K = (*MAP, PHI, FIRST_BAR, rec(al, t, first, al[t] / (1 + ga[t])), rec(ga, t, -phi_ / (1 - x) ** 2, al[t] ** 2 * ga[t] / (1 + ga[t]) ** 2))
claim("BLM91-E4.22", "the noise of the realization with variance pi_k",
      always(t, (NOISE_K[1, 1] == (1 - a**2) * pit[t]) & (NOISE_K[1, 2] == ga0 + a * pit[t]) & (NOISE_K[2, 2] == 1 - pit[t])), over={**POINT, x: scalar()}, where=FACTOR_K,
      by=[induction(also=[pit[t] == (al[t] - al0) / al[t], CURVE_K],
                    cofactors=[[(-(1 - a**2) * STEP_K[0][0], 3, 1), (a**2, 4, 1)], [(-a * e_, i_, 1) for e_, i_, _ in STEP_K], STEP_K, STEP_K, [(1, 4, 1)]]), instances()],
      note="x = pi_0, t = k; gamma here is the square of gamma_bar_k, moved by (4.17). The matrix is BB' for B as printed, with rows in the order (v, w) and alpha_0/alpha_bar_k for the square of the root.")
claim("BLM91-R4.4.2", "b_2 = 0 at the equilibria", iff(okay, inside) & (b2 == -phi_ / Rn), over={**POINT, p: nonzero(), x: scalar()},
      where=[*NOISE, PHI, let(b2, Qn - Sn**2 / Rn), let(okay, b2 == 0), let(inside, (x == 1 - al0 / p) | (x == 1 - al0 * p))], given=[ROOT, DIAMOND],
      by=[arithmetic(valued(), cleared()),
          instances(30, using={u: nonzero(), s1: nonzero(), y: scalar()}, made_by={**IN_D, x: y}), instances(20, using={u: nonzero(), s1: nonzero()}, made_by={**IN_D, x: 1 - al0 / p}),
          instances(20, using={u: nonzero(), s1: nonzero()}, made_by={**IN_D, x: 1 - al0 * p})], note="admissible: b_2^2 = Q - b_1^2 is zero; inside: x = pi_0 is p_+ or p_-.")

# ---------------------------------------------------------------------- Remark 4.5
STEP_X = let(gx, (al0 - ga0) ** 2 * x + (ga0 + (al0 - ga0) * x) ** 2 / (1 - x))
claim("BLM91-E4.7'", "the Riccati equation as a linear fractional map", gx == ((al0**2 - ga0**2) * x + ga0**2) / (1 - x), over={al0: scalar(), ga0: scalar(), x: scalar()}, where=[STEP_X], by=[identity(), instances()])
not_checked("BLM91-E4.23a", "a linear differential equation in the plane", "a definition: it fixes notation and asserts nothing")
not_checked("BLM91-E4.23b", "a linear difference equation in the plane", "a definition: it fixes notation and asserts nothing")
PLANE_V = {A: matrix(2, 2), x: nonzero(), y: nonzero()}
DX, DY = A[1, 1] * x + A[1, 2] * y, A[2, 1] * x + A[2, 2] * y
mm = sym("m_t")
RATE = A[2, 1] + (A[2, 2] - A[1, 1]) * mm - A[1, 2] * mm**2
WRONG_SLOPE = "the formula is that of the slope y/x; for x/y the indices 1 and 2 change places"
claim("BLM91-S50", "the differential equation of the slope", (DX * y - x * DY) / y**2 == RATE, over=PLANE_V, where=[let(mm, x / y)], by=[example(A=[[0, 1], [0, 0]], x=1, y=1), instances()],
      repair=repair("other", WRONG_SLOPE, (DY * x - y * DX) / x**2 == RATE, over=PLANE_V, where=[let(mm, y / x)], by=[identity(), instances()]),
      note="(x, y)' = A(x, y); the left side is the derivative of the quotient.")
NEXT_M = (A[2, 1] + A[2, 2] * mm) / (A[1, 1] + A[1, 2] * mm)
claim("BLM91-E4.24", "the difference equation of the slope", DX / DY == NEXT_M, over={A: nonsingular(2), x: nonzero(), y: nonzero()}, where=[let(mm, x / y)], by=[example(A=[[1, 0], [0, 2]], x=1, y=1), instances()],
      repair=repair("other", WRONG_SLOPE, DY / DX == NEXT_M, over={A: nonsingular(2), x: nonzero(), y: nonzero()}, where=[let(mm, y / x)], by=[identity(), instances()]),
      note="Slope x/y as defined before the differential equation.")
MOB = function(mob, [k], ((A**k)[2, 1] + (A**k)[2, 2] * Z) / ((A**k)[1, 1] + (A**k)[1, 2] * Z))
OTHER = (A1[2, 1] + A1[2, 2] * Z) / (A1[1, 1] + A1[1, 2] * Z)
claim("BLM91-S51", "linear fractional maps and matrices", iff(same, whole) & (substitute(mob(1), mob(m)) == mob(m + 1)), sizes=["m"], over={A: nonsingular(2), A1: nonsingular(2)},
      where=[MOB, let(same, OTHER == mob(1)), let(whole, rank(rows([[A[1, 1], A[1, 2], A[2, 1], A[2, 2]], [A1[1, 1], A1[1, 2], A1[2, 1], A1[2, 2]]])) == 1)],
      by=[steps("BLM91-E5.1'", facts=["equal rational functions in lowest terms have proportional coefficients"], prose="numerator and denominator have no common zero when the matrix is invertible"),
          instances(20, m=(1, 2, 3), using={x: nonzero()}, made_by={A1: x * A}), instances(20, m=(1, 2))],
      note="mobius(k) is the map of A^k; special: the two matrices are proportional.")
LINE_A = rows([[b1, b2], [p, w]])
claim("BLM91-E4.25", "the action on lines is always defined", iff(okay, inside) & (LINE_A * (u * v) == u * (LINE_A * v)) & iff(infinite, there),
      over={b1: scalar(), b2: scalar(), p: scalar(), w: scalar(), x: scalar(), y: scalar(), u: scalar()}, given=[given("A invertible", det(LINE_A) != 0)],
      where=[let(v, rows([[x], [y]])), let(okay, LINE_A * v == Zero(2, 1)), let(inside, v == Zero(2, 1)), let(infinite, ~defined(y / x)), let(there, x == 0)],
      by=[arithmetic(*map(multiplied, (b1, b2, p, w)), member=0), arithmetic(member=1), arithmetic(member=2), instances(), example({"b_1": 1, "b_2": 2, "p": 3, "w": 4, "x": 0, "y": 1, "u": 2}),
          example({"b_1": 1, "b_2": 2, "p": 3, "w": 4, "x": 0, "y": 0, "u": 2}), example({"b_1": 1, "b_2": 2, "p": 2, "w": 4, "x": 2, "y": -1, "u": 2})],
      note="A = [[b_1, b_2], [p, w]], v = (x, y)'. Av is 0 only for v = 0, and multiples of v go to multiples of Av, so that A maps lines to lines; the slope y/x has no value exactly on the line x = 0.")

# ---------------------------------------------------------------------- Remark 4.6
OUTSIDE = (let(inside, al0 >= abs(ga0)), let(rest, (-(ga0**2) == 0) & (-ga0 * al0 == 0)))
claim("BLM91-R4.6.1", "continuous time: escape whenever the positive real condition is violated", ~inside >> ~rest, over={al0: scalar(), ga0: scalar()}, where=OUTSIDE, by=[example(alpha0=-1, gamma0=0), instances()],
      repair=repair("boundary case", "(alpha, 0) with alpha < 0 violates it and is at rest; for gamma_0 not 0 the statement is right", iff(~inside, there) & (fx == -(ga0**2)), over={al0: scalar(), ga0: nonzero()},
                    where=[*OUTSIDE, let(there, (al0**2 < ga0**2) | (al0 < 0) & (ga0**2 > 0)), let(fx, (al0**2 - ga0**2) - al0**2)],
                    by=[steps("BLM91-R3.11.1", facts=["the solution of d alpha/dt = H - alpha^2 is y'/y with y'' = H y, y(0) = 1, y'(0) = alpha_0"], prose="as in Remark 3.11"), instances(), example(alpha0=-1, gamma0=1)]),
      note="As for Remark 3.11: a solution at rest does not escape. there: the solution y'/y of d alpha/dt = H - alpha^2, H = alpha_0^2 - gamma_0^2, has a pole at a positive time, that is H < 0 or alpha_0 < -sqrt(H).")
CROSS = (x > 0) & (fx < 0) & (fx * (2 * lam - x) == 1)
claim("BLM91-R4.6.2", "crossing the infinite line", CROSS, over={lam: positive(), x: scalar()}, where=[let(fx, 1 / (2 * lam - x))], given=[given("beyond the pole", x > 2 * lam)],
      by=[steps("BLM91-E5.1'", facts=["intermediate value theorem"], prose="exp(At)l moves continuously, A^n l jumps"), instances(using={u: positive()}, made_by={x: 2 * lam + u}), example({"lambda": 1, "x": 1})],
      note="In discrete time a slope beyond 2/kappa goes from positive to negative without being infinite. The state-costate representations are those of Remark 4.5; the print names Remark 4.4.")

# ---------------------------------------------------------------------- the error covariance
_ERROR = {"sizes": ["n"], "over": SYSTEM, "given": SOME}
_EVERY = "For a state of any size; the print is the case n = 1, F = -a, h = 1, bb' = Q, bd' = S and dd' = R being the covariances of the noise bu, du. "
_IT_IS = "p_t is E(x_t - x^_t)(x_t - x^_t)'. " + PROJECTED + " Pi_t, K, U and F_g serve the proof alone."
claim("BLM91-E4.26", "the Riccati equation of the error covariance", always(t, err(t + 1) == next_error(err(t))), where=ERROR, **_ERROR,
      by=[generic_index(*RICCATI_OF_ERROR, **CLOSED_FOR_ERROR, uses=BY_RICCATI_OF_ERROR), instances(n=(1, 2), horizon=2)], note=_EVERY + _IT_IS)
claim("BLM91-E4.27", "p_t is the covariance of the error", always(t, rec_p[t] == err(t)), where=[*ERROR, FROM_STATE], **_ERROR,
      by=[generic_index(*ERROR_LEMMAS, SAME_ERROR, **CLOSED_FOR_ERROR, uses=BY_ERROR), instances(n=(1, 2), horizon=2)],
      note=_EVERY + "p_riccati solves (4.26) from the state covariance P. " + _IT_IS)
claim("BLM91-E4.28", "p_t and pi_t", always(t, err(t) == err(0) - Pi[t]), where=ERROR, **_ERROR,
      by=[generic_index(*ERROR_LEMMAS, **CLOSED_FOR_ERROR, uses=BY_ERROR), instances(n=(1, 2), horizon=2)],
      note=_EVERY + "Pi_t solves (1.4), which for n = 1 is (4.7). " + _IT_IS.replace(" Pi_t, K,", " K,"))
GOF = function(mob, [y], a**2 * y - (a * y - (ga0 + a * p)) ** 2 / (y + (1 - p)) + (1 - a**2) * p)
AF, AG, TT = rows([[1, -1], [ga0**2, (a + ga0) ** 2 - ga0**2]]), symbols("A_g")[0], rows([[1, 0], [p, -1]])
claim("BLM91-S52", "topological conjugacy of the two equations", (p - fx == gx) & ((AG[2, 1] + AG[2, 2] * Z) / (AG[1, 1] + AG[1, 2] * Z) == mob(Z)), over={a: scalar(), ga0: scalar(), p: scalar(), x: scalar()},
      where=[GOF, let(fx, a**2 * x + (ga0 + a * x) ** 2 / (1 - x)), let(gx, mob(p - x)), let(AG, TT * AF * inv(TT))], by=[identity(), instances()],
      note="psi(pi) = p_0 - pi, p = p_0. A_g, similar to the matrix of (4.7'), is a matrix of (4.26) in the sense of (4.24) for slopes y/x.")
