# SPDX-License-Identifier: MIT
"""Section V, (5.6)-(5.10): escaping points, the coordinate a = alpha - gamma, periods.

Notation and derivation are those of the module before: 1/kappa = lambda = cos(theta), U_(i-1) = sin(i theta)/sin(theta).
"""

from exactkf.claims import claim, repair
from exactkf.evidence import (
    angles,
    arithmetic,
    at_index,
    by_cases,
    by_induction,
    cleared,
    combination,
    evaluation,
    example,
    identity,
    instances,
    multiplied,
    restated,
    square_of,
    steps,
    valued,
)
from exactkf.language import *
from proofs.blm91.consequences_angles import COPRIME as OF_ANGLES
from proofs.blm91.consequences_angles import LOWEST as OF_LOWEST
from proofs.blm91.lemmas_ends import ALL_ENDS, OF_LIST, OF_POINT, THE_LIST, W_NOT_ZERO, about_lines, not_late, of_list
from proofs.blm91.lemmas_turns import LINES_BACK, OF_ENDLESS, OF_KAPPA, U_, W_, of_last
from proofs.blm91.notation import *
from proofs.blm91.section_5_lemma import COPRIME, coprime_

A, A1, p, q, y, be, v, av, mate = symbols("A A1 p q y b v_i a_t mate")
gcd, d, odd, back, whole, flag, alternative, found, pi, count, time, st, gt, many = symbols("gcd d odd back whole region given_by_p found pi count time alpha_i gamma_i divides")
closes, i1 = symbols("closes i1")
SLOPES = rec(be, t, x, 1 / (2 * lam - be[t]))
A_LAMBDA = let(A, rows([[2 * lam, -1], [1, 0]]))
ONE_LESS_A = let(A1, rows([[1 - 2 * lam, 1], [-1, 1]]))
ON = given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 * lam * al0)
LOWEST = [standing("angle", 2 * q < p), standing("lowest terms", gcd(p, q) == 1)]
FINITE = [standing("|kappa| > 1", abs(lam) < 1)]

# ---------------------------------------------------------------------- escaping slopes
ENDS = (AS_FRACTION, A_LAMBDA, let(v, A**(-m) * rows([[0], [1]])), SLOPES, let(flag, leaves(m, be)))
FRACTIONS = {top: integer(-12, 12), low: integer(1, 13)}
IRRATIONAL = [standing("|kappa| > 1", abs(lam) < 1), standing("irrational angle", ~exists(k, -1, 1, 2 * lam == k)), standing("a step", m >= 1)]
claim("BLM91-E5.6", "the slope that ends at a given step", iff(flag, x == v[1, 1]), sizes=["m"], over={**FRACTIONS, x: scalar()}, where=ENDS, given=IRRATIONAL,
      by=[example(m=1, numerator=1, denominator=3, x=1), instances(m=(1, 2))],
      repair=repair("other", "a slope is v_2/v_1, as in (5.3); v_1 alone is 1 for i = 1, while 2/kappa is the slope that ends there", iff(flag, x * W_[n] == U_[n]) & (W_[n] != 0), sizes=["n"], over={lam: scalar(), x: scalar()},
                    where=[*LINES_BACK, SLOPES, let(flag, leaves(n, be))], given=[standing("|kappa| > 1", lam**2 < 1), standing("a step", n >= 1), given("irrational angle", forall(s, 1, n, W_[s] != 0))],
                    by=[arithmetic(at_index(s, n), *of_last(be, x, n)), instances(24, n=(1, 2, 3, 4), using={u: scalar()}, made_by={lam: SHARE, x: U_[n] / W_[n]}), instances(20, n=(1, 2, 3)),
                        instances(10, n=(2, 3, 4), using={u: scalar()}, made_by={lam: SHARE, x: U_[n - 1] / W_[n - 1]}), example(**{"n": 2, "lambda": 0, "x": 0}), example(**{"n": 3, "lambda": 0, "x": 0})]),
      note="In the correction (W_i, U_i)' is A^(-i) (0, 1)', as A^(-1) takes (v_1, v_2)' to (v_2, 2 lambda v_2 - v_1)', and of an irrational angle no more is used than that the vectors up to the n-th have slopes. "
           "In the print's formula 1/kappa = lambda is a fraction with terms up to 13; its angle is irrational unless lambda is 0, 1/2, -1/2. (5.3), the same statement for 0 < kappa < 1, has v_2/v_1; if v_2 was lost in copying only, and not in print, the statement is right.")
claim("BLM91-S77", "the escaping slopes are countably many, all different",
      forall(i, 1, m, forall(j, 1, m, iff(Ut[i] * Ut[j - 1] == Ut[j] * Ut[i - 1], i == j))), sizes=["m"], over=FRACTIONS, where=[AS_FRACTION, CHEBYSHEV],
      given=[standing("|kappa| > 1", abs(lam) < 1), given("irrational angle", ~exists(k, -1, 1, 2 * lam == k))],
      by=[steps("BLM91-S71", "BLM91-X.6", facts=["Kronecker: multiples of an irrational part of a full turn are dense on the circle"],
                prose="U_i/U_(i-1) is the slope of the line that A^i takes to infinity: one line turned by -i theta, i = 1, 2, .. , in a suitable basis; each slope belongs to two points of the hyperbola"),
          instances(20, m=(2, 3, 5, 8)), example(m=5, numerator=1, denominator=2)],
      note="On fractions 1/kappa with terms up to 13. alpha^(i) = U_i/U_(i-1); dense by Kronecker's theorem.")
slope = sym("slope")
claim("BLM91-S78", "escape times for a rational angle", ((time < d) >> (iff(flag, slope * W_[time] == U_[time]) & (W_[time] != 0))) & ((time >= d) >> ~flag), sizes=["n", "d", "time"], over={slope: scalar()},
      where=[*OF_ANGLES, let(lam, cospi(n, d)), *LINES_BACK, rec(be, t, slope, 1 / (2 * lam - be[t])), let(flag, leaves(time, be))], given=[*OF_LOWEST, standing("a step", time >= 1)],
      by=[arithmetic(*about_lines(), W_NOT_ZERO, by_cases(time < d, [at_index(s, time), *of_last(be, slope, time)]), member=0), arithmetic(*not_late(be, slope, time), member=1),
          instances(24, n=range(1, 6), d=(2, 3), time=range(1, 9), made_by={slope: U_[time] / W_[time]}), instances(24, n=range(1, 4), d=range(2, 6), time=range(1, 6))],
      note="Read on the slope map (5.1), of which the proof of Theorem 4.1 speaks, from any slope: with theta = pi n/d, for each time 1, .., d - 1 there is one slope that ends with this step, that of A^(-time) (0, 1)' = (U_before, U)', and none ends at another time. "
           "T3.7.1odd and T3.7.1even, nearly the same sentence about (3.10), fail: (3.10) divides by zero at (0, 1) and (0, -1) at once, where the slope, 0, ends last.")
bal, bga = symbols("alpha_mirror gamma_mirror")
#: alpha and its mirror image at every j; the curve at every i; alpha by (5.1) at every k
MIRRORED = by_induction(j, 0, ((defined(al[j]) | defined(ga[j])) & (defined(bal[j]) | defined(bga[j]))) >> ((al[j] == bal[j]) & (ga[j] == -bga[j])),
                        base=[*values_at(0, al, ga, bal, bga)], step=[cleared(), *values_at(j + 1, al, ga, bal, bga)])
CURVE = by_induction(i, 0, defined(al[i]) >> (1 + al[i] ** 2 - ga[i] ** 2 == 2 * lam * al[i]), base=[cleared(), *values_at(0)],
                     step=[cleared(), *values_at(i + 1), multiplied(ga[i] ** 2)])
BY_SLOPE = by_induction(k, 0, (defined(al[k]) & defined(be[k])) >> (al[k] == be[k]), base=[cleared(), *values_at(0, al, be)],
                        step=[cleared(), at_index(i, k), *values_at(k + 1, al, ga, be), by_cases(1 - ga[k] ** 2 == al[k] * (2 * lam - al[k]))])
claim("BLM91-S79", "every alpha belongs to two points of the hyperbola",
      (1 + x**2 - 2 * lam * x > 0) & (ga0 != -ga0) & (al[m] == bal[m]) & (ga[m] == -bga[m]) & (al[m] == be[m]), sizes=["m"], over={lam: scalar(), x: scalar(), al0: scalar(), ga0: scalar()},
      where=[*ORBIT, rec(bal, t, al0, bal[t] / (1 - bga[t] ** 2)), rec(bga, t, -ga0, -bga[t] * bal[t] / (1 - bga[t] ** 2)), rec(be, t, al0, 1 / (2 * lam - be[t]))],
      given=[given("|kappa| > 1", lam**2 < 1), given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 * lam * al0)],
      by=[arithmetic(square_of(x - lam), member=0), arithmetic(square_of(al0 - lam), member=1), *(arithmetic(valued(), MIRRORED, at_index(j, m), member=k_) for k_ in (2, 3)),
          arithmetic(valued(), CURVE, BY_SLOPE, at_index(k, m), member=4),
          instances(30, m=(0, 1, 2, 3), using={u: scalar(), y: scalar()}, made_by={lam: u / (1 + abs(u)), al0: 2 * (lam + y) / (1 - y**2), ga0: 1 + y * al0}),
          *(example(**{"m": m_, "lambda": l_, "x": 1, "alpha0": a_, "gamma0": g_}) for m_, l_, a_, g_ in ((0, 1, 1, 0), (1, 2, 0, 1), (1, 1, 2, 1), (1, 0, "3/4", "5/4"), (2, 0, "3/4", "5/4"), (0, 2, 2, 1)))],
      note="gamma^2 = 1 + x^2 - 2 lambda x is positive for every first coordinate x, so that two points have it; the orbits from (alpha_0, gamma_0) and (alpha_0, -gamma_0) are mirror images, with the first coordinate of (5.1). m is the time.")

# ---------------------------------------------------------------------- the coordinate a
claim("BLM91-E5.7", "the step in the coordinate a", al[1] - ga[1] == (al0 - ga0 - 1) / (al0 - ga0 - 2 * lam + 1), over={al0: scalar(), ga0: scalar(), lam: scalar()}, where=ORBIT, given=[ON],
      by=[combination([(1 / ((1 - ga0) * (al0 - ga0 - 2 * lam + 1)), "on the hyperbola", 1)]), instances(made_by={lam: (1 + al0**2 - ga0**2) / (2 * al0)})])
claim("BLM91-F8", "the hyperbola in the coordinates a, b", 1 + av * mate == lam * (av + mate), over={al0: scalar(), ga0: scalar(), lam: scalar()}, where=[let(av, al0 - ga0), let(mate, al0 + ga0)], given=[ON],
      by=[combination([(1, "on the hyperbola", 1)]), instances(made_by={lam: (1 + al0**2 - ga0**2) / (2 * al0)})], note="mate is b.")
claim("BLM91-E5.8", "the matrix of the step in a", (A1 * rows([[1], [x]]))[2, 1] / (A1 * rows([[1], [x]]))[1, 1] == (x - 1) / (x - 2 * lam + 1), over={lam: scalar(), x: scalar()}, where=[ONE_LESS_A],
      by=[identity(), instances()], note="Slope v_2/v_1, as in (4.24).")
claim("BLM91-S80", "characteristic polynomial of A_1", charpoly(A1) == Z**2 - 2 * Z + 2 + lam * (2 * Z - 2), over={lam: scalar()}, where=[ONE_LESS_A], by=[identity(), instances()])
far_ = sym("bound")
right, left, upper = symbols("right left positive")
SIDE = [ONE_LESS_A, let(right, trace(A1) / 2 > 1), let(left, trace(A1) / 2 < 1), let(upper, lam > 0)]
claim("BLM91-F9", "sides of the root locus", iff(right, upper) & (charpoly(A1) == Z**2 - 2 * Z + 2 + lam * (2 * Z - 2)), over={lam: nonzero()}, where=SIDE, given=[standing("complex roots", abs(lam) < 1)],
      by=[example({"lambda": "1/2"}), instances(using={u: nonzero()}, made_by={lam: u / (1 + abs(u))})],
      repair=repair("sign", "the real part of the complex roots is 1 - lambda: positive lambda lies to the left of the roots 1 +- i for lambda = 0, negative lambda to the right",
                    iff(left, upper) & (charpoly(A1) == Z**2 - 2 * Z + 2 + lam * (2 * Z - 2)), over={lam: nonzero()}, where=SIDE, given=[standing("complex roots", abs(lam) < 1)],
                    by=[steps("BLM91-S80", prose="complex roots have half the trace as real part"), instances(using={u: nonzero()}, made_by={lam: u / (1 + abs(u))})]),
      note="Halves with respect to the vertical line through the roots for lambda = 0; the figure itself is not in the text.")
claim("BLM91-S81", "complex eigenvalues",
      ((lam**2 < 1) >> ((det(x * Identity(2) - A1) != 0) & (det(x * Identity(2) - A) != 0))) & ((lam**2 >= 1) >> ((det(y * Identity(2) - A1) == 0) & (det((1 - y) * Identity(2) - A) == 0))), over={lam: scalar(), x: scalar(), y: scalar()}, where=[ONE_LESS_A, A_LAMBDA], given=[standing("y by a square root", (y - 1 + lam) ** 2 == abs(lam**2 - 1))],
      by=[arithmetic(*(square_of(e_ * x + e_ - lam) for e_ in (1, -1)), *(square_of(x + e_ * lam) for e_ in (1, -1)), *(square_of(x - 1 + e_ * lam) for e_ in (1, -1)), member=0), arithmetic(member=1), instances(40, using={u: nonzero()}, made_by={lam: (u + 1 / u) / 2, y: 1 - lam + (u - 1 / u) / 2}), instances(20, using={u: nonzero()}, made_by={lam: (1 - u**2) / (1 + u**2), y: 1 - lam + 2 * u / (1 + u**2)}),
          *(example({"lambda": l_, "x": x_, "y": y_}) for l_, x_, y_ in ((1, 0, 0), (-1, 2, 2), ("5/4", -1, "1/2"), ("5/4", 2, "-1"), ("3/5", 0, "6/5"), (0, 1, 2)))],
      note="No real number x is an eigenvalue for |lambda| < 1, and for |lambda| >= 1 y = 1 - lambda + sqrt(lambda^2 - 1) is one of A_1, and 1 - y of A. The print names (5.5), which is about the matrix of the Riccati equation, similar to A; "
           "the root locus before it is that of (5.8). The statement is right for both, and both are checked.")
AMAP = rec(av, t, x, (av[t] - 1) / (av[t] - 2 * lam + 1))
claim("BLM91-S82", "in the coordinate a: all periodic or all dense",
      forall(t, 1, 12, iff(av[t] == x, back(t))), over={**FRACTIONS, x: scalar()},
      where=[AS_FRACTION, AMAP, MANY, function(back, [t], (2 * lam == 1) & many(3, t) | (lam == 0) & many(4, t) | (2 * lam == -1) & many(6, t))], given=[standing("|kappa| > 1", abs(lam) < 1)],
      by=[steps("BLM91-E5.8", "BLM91-X.1", "BLM91-X.6", facts=["Kronecker: multiples of an irrational part of a full turn are dense on the circle"],
                prose="the eigenvalues of A_1 are not real, so that its powers turn lines by multiples of one angle in a suitable basis, the same for every point"),
          instances(40), *(example(numerator=k_, denominator=2, x=x_) for k_ in (1, 0, -1) for x_ in (3, "-2/5"))],
      note="Orbits that end are left aside. On fractions lambda with terms up to 13: a return within 12 steps only for lambda = 1/2, 0, -1/2, and there after 3, 4, 6 steps from every point.")
claim("BLM91-S83", "the hyperbola and the a-axis", iff(flag, y * (x - lam) == lam * x - 1) & (flag >> (x != lam)), over={lam: scalar(), x: scalar(), y: scalar()}, where=[let(flag, 1 + x * y == lam * (x + y))], given=FINITE,
      by=[arithmetic(),
          instances(40, using={u: scalar()}, made_by={lam: u / (1 + abs(u)), y: (lam * x - 1) / (x - lam)}), instances(40), example({"lambda": "1/2", "x": 3, "y": "1/5"}), example({"lambda": "1/2", "x": "1/2", "y": 3})],
      note="x = a, y = b; the point is ((a + b)/2, (b - a)/2). Each point of the hyperbola has an a of its own, and every a but 1/kappa is that of a point; a = 1/kappa is the asymptote, where b is infinite.")

# ---------------------------------------------------------------------- periods; omega = pi q/p, theta = pi (p - 2q)/p
#: when alpha is back at m, and gamma up to the sign e, the orbit goes on as from the start, up to that sign; i1 is the time since
SHIFTED = {e_: by_induction(i1, 0, (defined(al[m + i1]) & defined(ga[m + i1])) >> ((al[m + i1] == al[i1]) & (ga[m + i1] == e_ * ga[i1])), base=[unfolded(x_, 0) for x_ in (al, ga)],
                            step=[cleared(), *values_at(m + i1 + 1), *(unfolded(x_, i1 + 1) for x_ in (al, ga))]) for e_ in (1, -1)}
flat, pair, same, turned = symbols("alpha_back both_back a_back gamma_turned")
claim("BLM91-S84", "periods of alpha, of a and of the point",
      (flat(m) >> (pair(m) | turned(m))) & (flat(m) >> pair(2 * m)) & iff(same(m), pair(m)), sizes=["m"], over={lam: scalar(), al0: scalar(), ga0: scalar()},
      where=[*ORBIT, function(flat, [t], al[t] == al0), function(pair, [t], flat(t) & (ga[t] == ga0)), function(turned, [t], ga[t] == -ga0), function(same, [t], al[t] - ga[t] == al0 - ga0)],
      given=[given("|kappa| > 1", lam**2 < 1), given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 * lam * al0), standing("the orbit exists", defined(al[2 * m]) & defined(ga[2 * m]))],
      by=[arithmetic(valued(), CURVE, at_index(i, m), by_cases(ga[m] > ga0), by_cases(ga0 > ga[m]), by_cases(ga[m] + ga0 > 0), by_cases(ga[m] + ga0 < 0), member=0),
          arithmetic(valued(), CURVE, at_index(i, m), unfolded(al, 0), unfolded(ga, 0), by_cases(al[m] == al0, [by_cases(ga[m] == ga0, [SHIFTED[1]], [by_cases(ga[m] == -ga0, [SHIFTED[-1]])]), at_index(i1, m)]),
                     member=1),
          arithmetic(valued(), CURVE, at_index(i, m), by_cases(al[m] > al0), by_cases(al0 > al[m]), by_cases(al0 - ga0 == lam), member=2),
          instances(20, m=(1, 2, 3), using={u: scalar(), y: scalar()}, made_by={lam: SHARE, al0: 2 * (lam + y) / (1 - y**2), ga0: 1 + y * al0}),
          *(example(**{"m": m_, "lambda": l_, "alpha0": a_, "gamma0": g_}) for m_, l_, a_, g_ in (
              (3, "1/2", "-5/3", "-7/3"), (2, 0, "-4/3", "-5/3"), (4, 0, "-4/3", "-5/3"), (3, "-1/2", "-5/3", "-5/3"), (6, "-1/2", -1, -1), (3, "-1/2", -1, -1)))],
      note="At any time m: if alpha is back, gamma is back up to sign and the point is back at 2m at the latest; a is back with the point. So a point whose alpha has period d has period d or 2d, and that is the period of a.")
claim("BLM91-S85", "A_1 = I - A", (A1 == Identity(2) - A) & (charpoly(A1) == substitute(charpoly(A), 1 - Z)), over={lam: scalar()}, where=[A_LAMBDA, ONE_LESS_A], by=[identity(), instances()],
      note="s is an eigenvalue of A_1 when 1 - s is one of A: mirrored in the imaginary axis and moved one step to the right.")
claim("BLM91-S86", "the angles theta and omega", charpoly(A1) == (Z - 2 * st * st) ** 2 + (2 * st * gt) ** 2, over={y: scalar()},
      where=[let(st, 2 * y / (1 + y**2)), let(gt, (1 - y**2) / (1 + y**2)), let(lam, gt**2 - st**2), ONE_LESS_A],
      by=[identity(), restated("an angle in (0, pi) is determined by its cosine", "sin(x) = cos(pi/2 - x)"), instances()],
      note="alpha_i = sin(theta/2), gamma_i = cos(theta/2), lambda = cos(theta). The zeros are 2 sin(theta/2)(sin(theta/2) +- i cos(theta/2)), the upper one with argument pi/2 - theta/2.")
D_OF = (let(odd, cospi(p, 1) == -1), function(alternative, [t], when(odd, t == p, 2 * t == p)))
claim("BLM91-S87", "theta from omega, and the period of alpha",
      (gcd(p, p - 2 * q) == when(odd, 1, 2)) & forall(t, 1, count, iff(closes(t), alternative(t))), sizes=["p"], over={q: integer(1, 19)},
      where=[GCD, *D_OF, let(lam, cospi(p - 2 * q, p)), CHEBYSHEV, let(count, when(odd, p, p - 1)), function(closes, [t], Ut[t - 1] == 0)], given=LOWEST,
      by=[steps("BLM91-X.13", facts=["exp(2 pi i n/d), (n, d) = 1, is a root of unity of order d"], prose="a common divisor of p and p - 2q divides 2q, hence 2; U_(t-1) = 0 says that t theta is a multiple of pi"), instances(20, p=range(3, 21)), example(p=9, q=2), example(p=10, q=3), example(p=12, q=5)],
      note="theta = pi (p - 2q)/p; a slope returns after t steps when U_(t-1) = sin(t theta)/sin(theta) is 0, first for t = p (p odd) or p/2 (p even).")
claim("BLM91-S88", "every period p >= 3 occurs", whole & forall(t, 1, p, iff((al[t] == al0) & (ga[t] == ga0), t == p)) & (lam < 1) & (lam > -1), sizes=["p"], over={al0: scalar(), ga0: scalar()},
      where=[let(q, 1), let(lam, cospi(p - 2 * q, p)), *ORBIT, let(whole, defined(al[p]) & defined(ga[p]))],
      given=[standing("p at least 3", p >= 3), given("which points", al0 > 1), given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 * lam * al0)],
      by=[arithmetic(*OF_KAPPA, *OF_ENDLESS),
          instances(12, p=(3, 4, 6), using={u: scalar()}, made_by={al0: ALPHA_OF, ga0: GAMMA_OF}), example(p=3, alpha0="15/8", gamma0="13/8"), example(p=4, alpha0="4/3", gamma0="5/3"),
          example(p=6, alpha0="8/7", gamma0="13/7"), example(p=3, alpha0=1, gamma0=1)],
      note="omega = pi/p gives period p, from the points of its hyperbola with alpha_0 > 1, none of which ends. Any omega in (0, pi/2) has theta = pi - 2 omega in (0, pi), hence a kappa = 1/cos(theta), |kappa| > 1.")
claim("BLM91-S89", "periods 3 and 6 fix the sign of kappa", iff(flag, found) & (2 * abs(lam) == 1), over={p: integer(3, 6), q: integer(1, 2)},
      where=[GCD, let(lam, cospi(p - 2 * q, p)), let(flag, p == 3), let(found, lam > 0)], given=[*LOWEST, standing("period 3 or 6", (p == 3) | (p == 6))],
      by=[evaluation(), restated("exp(2 pi i q/p), (q, p) = 1, is a root of unity of order p, so that (X.5) gives the periods")],
      note="omega = pi q/p; for p = 3 and 6 only q = 1 is possible, kappa = 2 and kappa = -2.")
#: how many of the points with alpha = U_i/U_(i-1), i < d, and one sign of gamma end at step t
TIMES = (CHEBYSHEV, function(st, [i, t], when(t == 0, Ut[i] / Ut[i - 1], st(i, t - 1) / (1 - gt(i, t - 1) ** 2))),
         function(gt, [i, t], when(t == 0, 1 / Ut[i - 1], -gt(i, t - 1) * st(i, t - 1) / (1 - gt(i, t - 1) ** 2))),
         let(d, when(odd, p, (p - p / 2))), function(time, [i, t], defined(st(i, t - 1)) & ~defined(st(i, t))),
         function(count, [t], 2 * sum_of(i, 1, d - 1, when(time(i, t), 1, 0))))
COUNTED = (GCD, D_OF[0], let(lam, cospi(p - 2 * q, p)), *TIMES)
TWO_EACH = forall(t, 1, d - 1, count(t) == 2)
WHY = ("alpha^(d-1) is 0, and the points (0, 1), (0, -1) of every hyperbola have |gamma| = 1, so that they end at step 1 and not at step d - 1; for d > 2 four points end at step 1, two at "
       "each of the steps 2, .., d - 2, and none later")
claim("BLM91-S90", "points that end, two each", TWO_EACH & (2 * sum_of(i, 1, d - 1, 1) == 2 * (d - 1)), sizes=["p"], over={q: integer(1, 4)}, where=COUNTED, given=LOWEST,
      by=[example(p=3, q=1), instances(p=range(3, 9))],
      repair=repair("boundary case", WHY + "; and d = p/2 when p is even", THE_LIST, sizes=["n", "d", "time"], **OF_LIST, where=ALL_ENDS, given=[*OF_LOWEST, *OF_POINT],
                    by=[*of_list(), instances(12, n=(1, 2), d=(2, 3), time=(1, 2, 3), using={u: scalar()}, made_by={al0: ALPHA_OF, ga0: GAMMA_OF}),
                        *(example(n=n_, d=d_, time=m_, alpha0=a_, gamma0=g_, gamma_start=1) for n_, d_, m_, a_, g_ in ((1, 3, 1, 1, 1), (2, 3, 1, -1, 1), (1, 3, 1, "-5/3", "-7/3"), (2, 6, 4, 1, 1)))]),
      note="The points are (U_i, +-1)/U_(i-1), i = 1, .., d - 1, and (3.10) is run from each until it ends. In the correction, for every fraction n/d: the slopes U_k/W_k, k = 1, .., d - 1, all different, of two points each, end with step k (listed), but the last, 0, at once. 'p = 2k when p is even' is read as d = p/2.")

# ---------------------------------------------------------------------- which periods for which sign of kappa
#: period p occurs for kappa > 1, or for kappa < -1: 1/kappa = cos(pi (p - 2q)/p) for a q prime to p
ABOVE, BELOW = (function(flag, [x], exists(q, 1, x - 1, coprime_(x, q) & (2 * q < x) & sign(cospi(x - 2 * q, x)))) for sign in (lambda y: y > 0, lambda y: y < 0))
FOR_PERIODS = dict(sizes=["p"], given=[standing("p at least 3", p >= 3)])
SIGN_OF = angles("acute", p - 2 * q, p)
#: what a q is coprime to for one side of an equivalence it is for the other
SAME = [at_index(q, q), at_index(d, d), at_index(i, i), at_index(i, i1)]
OF_FOUR = "kappa infinite (1/kappa = 0, q/p = 1/4, period 4), which Theorem 3.7 admits, is neither above 1 nor below -1"
claim("BLM91-E5.9", "periods for kappa > 1", iff(flag(p), exists(q, 1, p - 1, coprime_(p, q) & (rational("1/4") <= q / p * pi) & (q / p * pi < rational("1/2") * pi))),
      over={p: integer(3, 12), pi: scalar()}, where=[*COPRIME, ABOVE], given=[standing("pi", (pi > rational("3.141592")) & (pi < rational("3.141593")))],
      by=[example(p=6, pi="3.1415926"), instances(using={x: positive()}, made_by={pi: rational("3.141592") + rational("1/1000000") / (1 + x)})],
      repair=repair("factor", "the lower bound is pi/4, not 1/4: p = 6, q = 1 has pi/6 > 1/4, and period 6 does not occur for kappa > 1; it is not attained, as " + OF_FOUR,
                    iff(flag(p), exists(q, 1, p - 1, coprime_(p, q) & (p < 4 * q) & (2 * q < p))), **FOR_PERIODS, where=[*COPRIME, ABOVE],
                    by=[arithmetic(SIGN_OF, *SAME, by_cases(2 * q == p, [by_cases(q >= 2), at_index(d, q), at_index(i, 1), at_index(i, 2)])), instances(p=(*range(3, 9), 20))]),
      note="(5.9) is divided by pi in the correction. Lemma 5.1 and (5.10) show that pi/4 is meant.")
claim("BLM91-E5.10", "periods for kappa < -1", iff(flag(p), exists(q, 1, p - 1, coprime_(p, q) & (0 <= q) & (4 * q <= p))), **FOR_PERIODS, where=[*COPRIME, BELOW],
      by=[example(p=4), instances(p=(3, 4, 5, 8, 20))],
      repair=repair("boundary case", OF_FOUR + ": < has to take the place of the second <=",
                    iff(flag(p), exists(q, 1, p - 1, coprime_(p, q) & (0 <= q) & (4 * q < p))), **FOR_PERIODS, where=[*COPRIME, BELOW],
                    by=[arithmetic(by_cases(p >= 5, [at_index(q, 1), angles("acute", p - 2, p)], [SIGN_OF])), instances(p=(*range(3, 9), 20))]),
      note="(5.10) is divided by pi.")
claim("BLM91-S91", "(5.10) by q = 1", iff(exists(q, 1, p - 1, coprime_(p, q) & (4 * q <= p)), p >= 4) & ((p >= 4) >> (coprime_(p, 1) & (4 * 1 <= p))), sizes=["p"], where=COPRIME,
      given=[standing("positive", p >= 1)], by=[arithmetic(at_index(q, 1)), instances(p=range(1, 13)), example(p=20)],
      note="(5.10) is divided by pi. Some q satisfies it exactly for p >= 4, and q = 1 does.")
