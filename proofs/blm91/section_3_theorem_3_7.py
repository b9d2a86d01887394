# SPDX-License-Identifier: MIT
"""Section III, Theorem 3.7 and its corollaries: the corridors for n = 1.

kappa^2 > 1, kappa = 1/cos(theta), omega = (pi - theta)/2. In closed form alpha_t = M_(t-1)/M_t, gamma_t = (-1)^t gamma_0/M_t with
M_(t+1) = (2/kappa) M_t - M_(t-1), M_0 = 1, M_(-1) = alpha_0: the point is back after t steps exactly when t omega is a multiple of pi. With
omega = pi q/p in lowest terms all points have period p, but those that end; otherwise every orbit that does not end is dense.

The points that end have alpha = U_i/U_(i-1), gamma = +-1/U_(i-1), U_(i-1) = sin(i theta)/sin(theta). For theta = pi n/d they are finitely many, i = 1, .., d - 1.
They end at step i, but for the last two, (0, 1) and (0, -1), where |gamma| = 1 already.

1/kappa = -cos(2 pi q/p) is 0 for p = 4 alone: period 4 is that of kappa infinite, which the theorem includes and both of its formulas give.

In any neighbourhood of a point of the corridors 1/kappa takes an interval of values: rational and irrational angles, and zeros of U_i(1/kappa) = alpha_0
U_(i-1)(1/kappa), lie in it. So periodic, dense (hence unbounded) and ending orbits are all dense there, the two latter uncountably many, and none of the
orbits stays with its neighbours.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import (
    angles,
    arithmetic,
    at_index,
    by_cases,
    by_rests,
    cleared,
    example,
    existing,
    instances,
    multiplied,
    part,
    shown_first,
    steps,
    valued,
)
from exactkf.language import *
from proofs.blm91.consequences_angles import COPRIME as OF_ANGLES
from proofs.blm91.lemmas_ends import ALL_ENDS, OF_LIST, OF_POINT, SINES_EVEN, SINES_ODD, THE_LIST, of_list
from proofs.blm91.lemmas_turns import LOWEST_PQ, OF_ENDLESS, OF_KAPPA, OF_POINTS
from proofs.blm91.notation import *
from proofs.blm91.section_5_lemma import COPRIME, WRITTEN, coprime_

p, q, y, gcd, odd, d, back, time, st, gt, count, flag, hits, far, never, alb, gab = symbols("p q y gcd odd d back time alpha_i gamma_i count found hits far never alpha_near gamma_near")
LOWEST = [standing("angle", 2 * q < p), standing("lowest terms", gcd(p, q) == 1)]
BACK = function(back, [t], (al[t] == al0) & (ga[t] == ga0))
EXISTS = standing("the orbit exists", defined(al[p]) & defined(ga[p]))
KRONECKER = "Kronecker: multiples of an irrational part of a full turn are dense on the circle"

# ---------------------------------------------------------------------- the theorem
claim("BLM91-T3.7.1", "rational angle: every orbit ends or has period p", forall(t, 1, p, iff(back(t), t == p)) & (lam**2 < 1), sizes=["q", "p"], over={al0: nonzero(), ga0: scalar(), lam: scalar()},
      where=[*OF_ANGLES, *ORBIT, BACK],
      given=[*LOWEST_PQ, given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 * lam * al0), EXISTS,
             given("the angle", ((lam < 0) >> (cospi(2 * q, p) == -lam)) & ((lam >= 0) >> (cospi(p - 2 * q, p) == lam)))],
      by=[arithmetic(*OF_KAPPA, valued(), *OF_POINTS),
          instances(12, q=1, p=(3, 4, 6), using={u: scalar()}, made_by={lam: -cospi(2 * q, p), al0: ALPHA_OF, ga0: GAMMA_OF}),
          *(example(**{"q": 1, "p": p_, "alpha0": a_, "gamma0": g_, "lambda": l_}) for p_, a_, g_, l_ in ((3, "-5/3", "-7/3", "1/2"), (4, "-4/3", "-5/3", 0), (6, -1, -1, "-1/2"), (6, "-5/3", "-7/3", "1/2"))),
          example(**{"q": 2, "p": 6, "alpha0": "-5/3", "gamma0": "-7/3", "lambda": "1/2"})],
      note="For every q and p and every point of the hyperbola; (0, 1) and (0, -1) end at once. lambda = 1/kappa; arctan sqrt(kappa^2 - 1) has the cosine 1/|kappa|, and is 2 pi q/p for kappa < -1, pi - 2 pi q/p for kappa > 1. kappa infinite is q = 1, p = 4.")
TIMES = (CHEBYSHEV, function(st, [i, t], when(t == 0, Ut[i] / Ut[i - 1], st(i, t - 1) / (1 - gt(i, t - 1) ** 2))),
         function(gt, [i, t], when(t == 0, 1 / Ut[i - 1], -gt(i, t - 1) * st(i, t - 1) / (1 - gt(i, t - 1) ** 2))),
         let(odd, cospi(p, 1) == -1), let(d, when(odd, p, p - p / 2)), function(time, [i, t], defined(st(i, t - 1)) & ~defined(st(i, t))),
         function(count, [t], 2 * sum_of(i, 1, d - 1, when(time(i, t), 1, 0))))
COUNTED = (GCD, let(lam, -cospi(2 * q, p)), *TIMES)
expected = sym("expected")
RIGHT = forall(t, 1, d, count(t) == expected(t))
ALL = 2 * sum_of(i, 1, d - 1, when(Ut[i - 1] == 0, 0, 1))
CORRECT = (*COUNTED, function(expected, [t], when(t == 1, when(d == 2, 2, 4), when(t < d - 1, 2, 0))))
WHY = "(0, 1) and (0, -1), the last of the escaping points, have |gamma| = 1 and end at step 1: four points end there, two at each of the steps 2, .., d - 2 (d = p for odd p, p/2 for even p), none at step d - 1; the total is as printed"
ODD, EVEN = standing("p odd", odd), standing("p even", ~odd)
LIST_ENDS = ("from the i-th point gamma_t is 1/U_(i-t-1) up to sign, and U_j, j < d, is 0 for j = d - 1 alone and 1 or -1 for j = 0 and j = d - 2 alone (X.10): the orbit ends after i steps, but at step 1 for i = d - 1 (X.18); "
             "a point that ends has alpha = U_i/U_(i-1) for some i, and U_(d-1) = 0 closes the list")
BY_ORDER = steps("BLM91-X.1", "BLM91-X.10", "BLM91-X.18", "BLM91-E5.1'", prose=LIST_ENDS)
LISTED_AS = "The list as printed is that of the slope map (5.1), under which the slope U_i/U_(i-1) goes to infinity at step i, the slope 0 too; (3.10) divides by zero at (0, +-1) at once, and the paper says before Theorem 3.5 that such an orbit ends. They cannot be set apart here: the totals and the case kappa infinite count them. In the correction, for every point: "
OTHER_MAP = "S78 holds, for nearly the same sentence, because its proof speaks of the slope map (5.1), under which (0, 1) and (0, -1) have the slope 0, which ends last; the theorem speaks of (3.10), which ends there at once."
half = sym("half")
ON_IT = [*LOWEST_PQ, *OF_POINT]
HOW_MANY = "The list: slopes U_k/W_k, k = 1, .., d - 1, all different, of two points each: they end with step k (listed), but the last, (0, 1) and (0, -1), at once."
claim("BLM91-T3.7.1odd", "escaping points for odd p", forall(t, 1, p - 1, count(t) == 2) & (ALL == 2 * (p - 1)), sizes=["p"], over={q: integer(1, 4)}, where=COUNTED, given=[*LOWEST, ODD],
      by=[example(p=3, q=1), instances(p=range(3, 9, 2))],
      repair=repair("boundary case", WHY, THE_LIST, sizes=["q", "p", "time"], **OF_LIST, where=[let(d, p), let(n, p - 2 * q), *ALL_ENDS], given=[*ON_IT, standing("p odd", exists(half, 1, p, p == 2 * half + 1))],
                    by=[*of_list(SINES_ODD), instances(12, q=1, p=3, time=(1, 2, 3), using={u: scalar()}, made_by={al0: ALPHA_OF, ga0: GAMMA_OF}),
                        *(example(q=q_, p=p_, time=m_, alpha0=a_, gamma0=g_, gamma_start=1) for q_, p_, m_, a_, g_ in ((1, 3, 1, 1, 1), (1, 3, 1, "-5/3", "-7/3"), (3, 9, 4, 1, 1)))]),
      note=LISTED_AS + "d = p, 1/kappa = cos(pi (p - 2q)/p) = -cos(2 pi q/p). " + HOW_MANY + " " + OTHER_MAP)
claim("BLM91-T3.7.1even", "escaping points for even p", forall(t, 1, d - 1, count(t) == 2) & (ALL == p - 2), sizes=["p"], over={q: integer(1, 5)}, where=COUNTED, given=[*LOWEST, EVEN],
      by=[example(p=6, q=1), instances(p=range(4, 9, 2))],
      repair=repair("boundary case", WHY, THE_LIST, sizes=["q", "d", "time"], **OF_LIST, where=[let(p, 2 * d), let(n, d - q), *ALL_ENDS], given=ON_IT,
                    by=[*of_list(SINES_EVEN), instances(12, q=1, d=(2, 3), time=(1, 2, 3), using={u: scalar()}, made_by={al0: ALPHA_OF, ga0: GAMMA_OF}),
                        *(example(q=q_, d=d_, time=m_, alpha0=a_, gamma0=g_, gamma_start=1) for q_, d_, m_, a_, g_ in ((1, 3, 1, -1, 1), (1, 3, 1, "-5/3", "-5/3"), (4, 6, 4, 1, 1)))]),
      note=LISTED_AS + "p = 2d, 1/kappa = cos(pi (d - q)/d) = -cos(2 pi q/p). " + HOW_MANY + " p = 4, kappa infinite, is right as printed. " + OTHER_MAP)
#: the points at t = 1, .., 5 for kappa infinite, one after the other
TURN_BACK = [shown_first(defined(al[t_]) & defined(ga[t_]) & place, [cleared(), *values_at(t_), *(values_at(0) if t_ == 1 else ()), *map(multiplied, (al0, al0**2, ga0, al0 * ga0))])
             for t_, place in ((1, (al[1] * al0 == -1) & (ga[1] * al0 == ga0)), (2, (al[2] == al0) & (ga[2] == -ga0)), (3, (al[3] == al[1]) & (ga[3] == -ga[1])), (4, (al[4] == al0) & (ga[4] == ga0)), (5, (al[5] == al[1]) & (ga[5] == ga[1])))]
UNLESS_ZERO = by_cases(al0 > 0, TURN_BACK, [by_cases(al0 < 0, TURN_BACK)])
claim("BLM91-T3.7.1inf", "kappa infinite: period four, two points end",
      iff(defined(al[1]), al0 != 0) & ((al0 != 0) >> (defined(al[4]) & defined(ga[4]) & forall(t, 1, 4, iff((al[t] == al0) & (ga[t] == ga0), t == 4)))) & iff(al0 == 0, (ga0 == 1) | (ga0 == -1)),
      over={al0: scalar(), ga0: scalar()}, where=ORBIT, given=[given("kappa infinite", 1 + al0**2 - ga0**2 == 0)],
      by=[arithmetic(UNLESS_ZERO, *values_at(0), existing(al, 2), existing(al, 1), by_cases(ga0**2 > 0), member=0), arithmetic(UNLESS_ZERO, by_cases(t == 4), by_cases(t == 3), by_cases(t == 2), multiplied(al0**2), multiplied(al0 * ga0), by_cases(ga0**2 > 0), member=1), arithmetic(by_cases(ga0 > 0), member=2),
          instances(using={y: nonzero()}, made_by={al0: (y - 1 / y) / 2, ga0: (y + 1 / y) / 2}), example(alpha0=0, gamma0=1), example(alpha0=0, gamma0=-1)],
      note="The points (0, 1) and (0, -1) end in one step; all others have period 4.")
turn = sym("turn")
POINT_OF = (let(lam, turn / 10), let(al0, ALPHA_OF), let(ga0, GAMMA_OF))
DENSE = (*POINT_OF, *ORBIT, BACK, *PROJECTIVE, let(never, forall(t, 1, 12, ~back(t))), let(hits, sum_of(t, 1, 60, when(abs(Nt[t]) > 5 * abs(Mt[t]), 1, 0))))
ANY_POINT = {turn: integer(-8, 8), u: scalar()}
IRRATIONAL = ~exists(k, -1, 1, 2 * lam == k)
goal_al, goal_ga, radius, close, stops, near, comes = symbols("alpha_goal gamma_goal radius close stops near comes_near")
#: does the orbit end with this step, is it near another point of the hyperbola
NEARS = (*POINT_OF, *ORBIT, let(goal_al, 2 * (lam + x) / (1 - x**2)), let(goal_ga, 1 + x * goal_al), let(radius, 1 / (1 + k)),
         function(stops, [t], ~defined(ga[t])), function(close, [t], (abs(al[t] - goal_al) <= radius) & (abs(ga[t] - goal_ga) <= radius)), let(comes, exists(t, 1, 400, stops(t) | close(t))))
claim("BLM91-T3.7.2a", "irrational angle: every orbit ends or is dense", comes & (1 + goal_al**2 - goal_ga**2 == 2 * lam * goal_al), over={**ANY_POINT, x: integer(-4, 4), k: integer(0, 1)}, where=NEARS, given=[given("irrational angle", IRRATIONAL)],
      by=[steps("BLM91-X.1", "BLM91-X.2", "BLM91-E5.7", "BLM91-E5.8", facts=[KRONECKER], prose="in the coordinate a the algorithm is a turn of lines by the angle omega in a suitable basis, and each point of the hyperbola has its own a; the points of the orbit are dense among the lines"),
          instances(30), example(turn=5, u=2, x=-3, k=1), example(turn=0, u=2, x=3, k=1), example(turn=-5, u=3, x=2, k=1), example(turn=-8, u=-2, x=2, k=1), example(turn=6, u=0, x=2, k=1)],
      note="1/kappa = -8/10, .., 8/10, where the angle is irrational unless 1/kappa is 0, 1/2 or -1/2; u runs through all points of the hyperbola. The goal is another point of the hyperbola, on the line of slope x through (0, 1); "
           "close: both coordinates of (3.10) are within 1/(1 + k) of it. Tried for 400 steps.")
pick, double = symbols("pick double")
SOME = when(pick == 1, rational("3/5"), when(pick == 2, rational("-1/3"), when(pick == 3, rational("2/5"), rational("-4/5"))))
TARGET = (CHEBYSHEV, let(hits, sum_of(i, 1, 120, when(2 * abs(Ut[i] - x * Ut[i - 1]) < abs(Ut[i - 1]), 1, 0))), let(far, sum_of(i, 1, 120, when(Ut[i] == 0, 1, 0))))
claim("BLM91-T3.7.2b", "irrational angle: the points that end are countable and dense", (hits >= 1) & never & double, over={x: integer(-2, 2), pick: integer(1, 4)},
      where=[let(lam, SOME), *TARGET, let(never, far == 0), let(double, 1 + x**2 - 2 * lam * x > 0)],
      by=[steps("BLM91-X.1", "BLM91-S71", "BLM91-S79", facts=[KRONECKER], prose="a point ends at step i when alpha = U_i/U_(i-1), the slope of one line turned by -i theta; gamma has two values; all other points, uncountably many near every point, do not end"),
          instances(24)],
      note="1/kappa = 3/5, -1/3, 2/5, -4/5. hits: how many of the first 120 escaping slopes lie within 1/2 of a given one; far: how many of the first 120 numbers U_i vanish, so that the list would close; double: the slope belongs to two points.")
claim("BLM91-T3.7", "Theorem 3.7: the two alternatives", forall(t, 1, d - 1, count(t) == 2), sizes=["p"], over={q: integer(1, 4)}, where=COUNTED, given=LOWEST, by=[example(p=3, q=1), instances(p=range(3, 9))],
      repair=repair("boundary case", "T3.7.1odd and T3.7.1even fail: " + WHY + "; the other parts hold", RIGHT, sizes=["p"], over={q: integer(1, 4)}, where=CORRECT, given=LOWEST,
                    by=[part("the count of points that end, for a rational angle"), BY_ORDER, instances(16, p=range(3, 10)), example(p=3, q=1), example(p=4, q=1), example(p=7, q=2)]),
      note="Either theta is a rational multiple of pi or not; represented by the count of points that end in the first alternative, the part that fails.")

# ---------------------------------------------------------------------- Corollary 3.8
CORRIDOR = standing("corridor", (1 + al0**2 - ga0**2) ** 2 < 4 * al0**2)
IN_CORRIDOR = dict(using={u: scalar(), y: scalar()}, made_by={al0: 2 * (SHARE + y) / (1 - y**2), ga0: 1 + y * al0})
a0, mate, at_p, at_q, per, turned, level = symbols("a0 b divisor_p divisor_q period lambda_pq lambda0")
#: angle q/p whose points with the same a = alpha - gamma has b = alpha + gamma within twice the radius; p is the first that has one
NEAR = (GCD, let(a0, al0 - ga0), let(level, (1 + al0**2 - ga0**2) / (2 * al0)), let(radius, 1 / (1 + k)), function(turned, [p, q], -cospi(2 * q, p)),
        function(near, [p, q], (2 * q < p) & (gcd(p, q) == 1) & (abs((turned(p, q) - level) * (a0**2 - 1)) < 2 * radius * abs((turned(p, q) - a0) * (level - a0)))),
        function(at_p, [p], when(exists(q, 1, p - 1, near(p, q)), p, at_p(p + 1))), function(at_q, [p, q], when(near(p, q), q, at_q(p, q + 1))), let(p, at_p(3)), let(lam, turned(p, at_q(p, 1))), let(mate, (lam * a0 - 1) / (a0 - lam)),
        *scalar_orbit((a0 + mate) / 2, (mate - a0) / 2), function(per, [t], when((al[t] == al[0]) & (ga[t] == ga[0]), t, per(t + 1))), let(d, per(1)))
claim("BLM91-C3.8.1", "periodic points are dense in the corridors", (d == p) & (abs(al[0] - al0) <= radius) & (abs(ga[0] - ga0) <= radius), over={al0: nonzero(), ga0: scalar(), k: integer(0, 1)}, where=NEAR, given=[CORRIDOR],
      by=[steps("BLM91-X.2", facts=["rational multiples of pi are dense, and the cosine is continuous"], prose="1/kappa is a continuous and nowhere locally constant function of the point, and on kappa = -sec(2 pi q/p) all points but finitely many values of alpha are periodic"),
          instances(8, **IN_CORRIDOR), example(alpha0=1, gamma0="1/2", k=1), example(alpha0=-1, gamma0=1, k=1)],
      note="Within 1/(1 + k) of the given point there is one of period p, found with alpha - gamma kept; (3.10) is run from it in the number field and is back first after p steps.")
whole = sym("orbit_exists")
ORDER = (let(lam, -cospi(2, p)), let(al0, ALPHA_OF), let(ga0, GAMMA_OF), *ORBIT, BACK)
claim("BLM91-C3.8.2", "infinitely many points of every period p >= 3", whole & forall(t, 1, p, iff((al[t] == al0) & (ga[t] == ga0), t == p)) & (lam**2 < 1), sizes=["p"],
      over={al0: scalar(), ga0: scalar()}, where=[let(q, 1), let(lam, -cospi(2 * q, p)), *ORBIT, let(whole, defined(al[p]) & defined(ga[p]))],
      given=[standing("p at least 3", p >= 3), given("which points", al0 > 1), given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 * lam * al0)],
      by=[arithmetic(*OF_ENDLESS), instances(12, p=(3, 4, 6), using={u: scalar()}, made_by={al0: ALPHA_OF, ga0: GAMMA_OF}), example(p=3, alpha0="15/8", gamma0="13/8"), example(p=4, alpha0="4/3", gamma0="5/3"),
          example(p=6, alpha0="8/7", gamma0="13/7"), example(p=3, alpha0=1, gamma0=1)],
      note="1/kappa = -cos(2 pi/p), for every p >= 3, and all points of the hyperbola with alpha_0 > 1, infinitely many: gamma_0^2 = 1 + alpha_0^2 - 2 alpha_0/kappa is positive. None of them ends, and each has period p.")
#: a q prime to p for which 1/kappa = cos(pi (p - 2q)/p) has the sign of k
REALIZED = function(flag, [x, k], exists(q, 1, x - 1, coprime_(x, q) & (2 * q < x) & (cospi(x - 2 * q, x) * k > 0)))
below, above = symbols("below above")
WITH = (*COPRIME, REALIZED, function(below, [d], flag(d, -1)), function(above, [d], flag(d, 1)))
WHY_FOUR = "1/kappa = -cos(2 pi q/4) = 0: period 4 is that of kappa infinite alone, and of no kappa "
OF_KAPPA = ("Period p occurs when 1/kappa = cos(pi (p - 2q)/p) for a q prime to p, q < p/2 (X.5). kappa infinite, which Theorem 3.7 admits, is neither below -1 nor above 1; "
            "counted in both cases, as equality in (5.9) and (5.10) would have it, it makes the print right.")
SIGN_OF = angles("acute", p - 2 * q, p)
claim("BLM91-C3.8.3", "periods for kappa < -1", (p >= 4) >> below(p), sizes=["p"], where=WITH, by=[example(p=4), instances(p=(4, 5, 6, 9, 20))],
      repair=repair("boundary case", WHY_FOUR + "below -1; all from 5 on occur, and no others", iff(below(p), p >= 5), sizes=["p"], where=WITH, given=[standing("p at least 3", p >= 3)],
                    by=[arithmetic(by_cases(p >= 5, [at_index(q, 1), angles("acute", p - 2, p)], [SIGN_OF])), instances(p=(*range(3, 10), 20))]),
      note=OF_KAPPA)
FOR_ABOVE = (p != 4) & (p != 6)
claim("BLM91-C3.8.4", "periods for kappa > 1", (p != 6) >> above(p), sizes=["p"], where=WITH, given=[standing("p at least 3", p >= 3)], by=[example(p=4), instances(p=(3, 4, 5, 6, 9, 20))],
      repair=repair("boundary case", WHY_FOUR + "above 1; all others from 3 on but 6 occur", iff(above(p), FOR_ABOVE), sizes=["p"], where=WITH, given=[standing("p at least 3", p >= 3)],
                    by=[arithmetic(by_cases(FOR_ABOVE, [by_rests(p, 8, j, [[at_index(q, q_), angles("acute", p - 2 * q_, p), by_cases(one >= 1)] for q_, one in WRITTEN])],
                                            [SIGN_OF, by_cases(q >= 2, [by_cases(q >= 3), at_index(d, 2), at_index(i, 1), at_index(i, 3)])])),
                        instances(p=(*range(3, 10), 20))]),
      note=OF_KAPPA + " By the q written down in X.12.")
there = sym("lambda_xy")
ALL_FOUR = (*ORDER, *WITH, let(there, (1 + x**2 - y**2) / (2 * x)), let(hits, sum_of(j, 1, 3, when(abs(there + cospi(2 * j, 7)) < rational("1/2"), 1, 0))))
FIRST_TWO = (hits >= 1) & forall(t, 1, p, iff(back(t), t == p)) & (al0 * (1 - u**2) == 2 * (lam + u))
OF_PARTS = dict(sizes=["m"], over={x: nonzero(), y: scalar(), p: integer(3, 7), u: scalar()}, where=ALL_FOUR, given=[standing("corridor", (1 + x**2 - y**2) ** 2 < 4 * x**2), EXISTS])
PARTS = (instances(8, m=(4, 6, 9), using={w: scalar(), s1: scalar()}, made_by={x: 2 * (w / (1 + abs(w)) + s1) / (1 - s1**2), y: 1 + s1 * x}), example(m=6, x=1, y="1/2", p=5, u=2))
claim("BLM91-C3.8", "Corollary 3.8", FIRST_TWO & forall(d, 4, m, below(d)) & forall(d, 3, m, (d != 6) >> above(d)), **OF_PARTS, by=[*PARTS, example(m=4, x=1, y="1/2", p=5, u=2)],
      repair=repair("boundary case", "C3.8.3 and C3.8.4 fail: " + WHY_FOUR + "above 1 or below -1",
                    FIRST_TWO & forall(d, 3, m, iff(below(d), d >= 5) & iff(above(d), (d != 4) & (d != 6))), **OF_PARTS,
                    by=[steps("BLM91-X.2", "BLM91-X.12", facts=["rational multiples of pi are dense, and the cosine is continuous"],
                              prose="the parts, in this order, are C3.8.1, C3.8.2 and the corrected C3.8.3 and C3.8.4, which are proved for every p"), *PARTS]),
      note="(x, y) is a point of the corridors near which a hyperbola of period 7 passes, see C3.8.1; (alpha_0, gamma_0) one of the points of period p, see C3.8.2; the list of periods, up to m, is C3.8.3 and C3.8.4.")

# ---------------------------------------------------------------------- Corollaries 3.9 and 3.10
INTERVAL = (let(lam, SOME), function(Ut, [t], when(t == 0, 1, when(t == 1, 2 * Z, 2 * Z * Ut(t - 1) - Ut(t - 2)))), let(hits, real_roots(Ut(31) - al0 * Ut(30), lam - rational("1/9"), lam + rational("1/9"))))
claim("BLM91-C3.9.1", "points that end are uncountable and dense", (hits >= 1) & flag & (ga[0] ** 2 == 1), over={al0: nonzero(), pick: integer(1, 4)}, where=[*INTERVAL, *scalar_orbit(al0, 1), let(flag, leaves(1))],
      by=[steps("BLM91-X.1", facts=["the zeros of U_i - alpha_0 U_(i-1), i of them, become dense as i grows (interlacing with those of the Chebyshev polynomials)"],
                prose="near a point of the corridors, with alpha_0 kept, 1/kappa takes an interval of values, and in it zeros of U_i(1/kappa) = alpha_0 U_(i-1)(1/kappa); these curves, already the lines |gamma| = 1, are uncountable"), instances(24)],
      note="hits: values of 1/kappa within 1/9 of 3/5, -1/3, 2/5 or -4/5 for which the point with first coordinate alpha_0 ends at step 31. The second part: (alpha_0, 1) ends at step 1.")
claim("BLM91-C3.9.2", "points with unbounded orbit are uncountable and dense", hits >= 1, over=ANY_POINT, where=DENSE, given=[standing("irrational angle", IRRATIONAL)],
      by=[steps("BLM91-X.1", "BLM91-X.2", facts=[KRONECKER], prose="irrational angles are dense and uncountably many, and on their hyperbolas all but countably many orbits are dense, hence unbounded"), instances(30)],
      note="hits: steps t <= 60 with |alpha_t| > 5, for the points of T3.7.2a.")
#: a period-3 point and a point near it on another hyperbola
PAIR = (let(lam, rational("1/2")), let(al0, ALPHA_OF), let(ga0, GAMMA_OF), *ORBIT,
        rec(alb, t, al0 + rational("1/20"), alb[t] / (1 - gab[t] ** 2)), rec(gab, t, ga0, -gab[t] * alb[t] / (1 - gab[t] ** 2)),
        function(far, [t], abs(alb[t] - al[t]) > 20), let(hits, exists(t, 1, 200, far(t))))
SENSITIVE = dict(over={u: integer(2, 9)}, where=PAIR)
APART = "a periodic orbit is bounded and a dense one is not, so that for every bound some iterates are further apart"
claim("BLM91-C3.10", "sensitive dependence on initial data", (al[3] == al0) & (ga[3] == ga0) & hits, **SENSITIVE,
      by=[steps("BLM91-X.2", "BLM91-X.6", facts=[KRONECKER], prose="near every point of the corridors there are periodic points and points with dense orbit; " + APART), instances(8)],
      note="A point of period 3 and the point 1/20 further in alpha: their distance exceeds 20 at some step t <= 200. Points whose orbit ends have no iterates to compare from then on; sensitivity is read for orbits that exist.")
claim("BLM91-S40", "an orbit that is not periodic leaves its periodic neighbours", hits & forall(t, 0, 5, al[t + 3] == al[t]), **SENSITIVE,
      by=[steps("BLM91-X.2", "BLM91-X.6", facts=[KRONECKER], prose="every orbit of the corridors ends, is periodic or is dense (Theorem 3.7); " + APART + "; an orbit that ends is at infinity at that step, its neighbours arbitrarily far out"), instances(8)],
      note="The dense orbit is the neighbour in the sample of C3.10. For an orbit that ends the distance at its last step is read as infinite.")
claim("BLM91-S41", "a periodic orbit is left by neighbours with dense orbit", hits & (abs(alb[0] - al0) * 20 == 1) & (gab[0] == ga0), **SENSITIVE,
      by=[steps("BLM91-X.2", "BLM91-X.6", facts=[KRONECKER], prose="irrational angles are dense; " + APART), instances(8)], note="The sample of C3.10.")
