# SPDX-License-Identifier: MIT
"""Section III, Theorem 3.5: the sign definite regions for n = 1, exactly.

Let 0 < kappa^2 < 1 and kappa = 2p/(1 + p^2), 0 < |p| < 1, so that p = alpha_+ and 1/p = alpha_-. On the hyperbola
gamma^2 = (alpha - p)(alpha - 1/p) and (alpha_t - p)/(p alpha_t - 1) = p^(2t) (alpha_0 - p)/(p alpha_0 - 1).

One step of the algorithm divides by 1 - gamma^2, and shows where it leads:

    IV  |alpha'| = |alpha|/(1 - gamma^2) grows, |alpha'| - |gamma'| = |alpha|/(1 + |gamma|) >= 1: to IV or III
    III |gamma'| - |alpha'| = |alpha|/(|gamma| + 1) >= 1: to II
    II  |alpha'| + |gamma'| = |alpha|/(|gamma| - 1) <= 1: to I, with the other sign of alpha
    I   |alpha'| + |gamma'| = |alpha|/(1 - |gamma|) <= 1: to I, |alpha| grows to |p|

From II to I kappa alpha goes up from a negative to a positive number; its modulus grows only when gamma^2 < 2.

Orbits end where |gamma| = 1: at alpha = 2/kappa and at alpha = 0. The first point has the backward orbit alpha^(i) = U_i/U_(i-1),
gamma^(i) = +-1/U_(i-1) in IV. The second, (0, +-1), is on every hyperbola, between I and II; the paper sets it apart before the theorem.

For kappa = 1, -1 put alpha = kappa(1 + x): then alpha_t = kappa(1 + x/(1 - t x)). Orbits with x > 0 first go away, to any distance
however small x is; so (kappa, 0) attracts every orbit that does not end, and is not stable.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import (
    angles,
    arithmetic,
    at_index,
    by_cases,
    by_induction,
    cleared,
    example,
    existing,
    instances,
    multiplied,
    part,
    shown_first,
    steps,
    unfolded,
    valued,
)
from exactkf.language import *
from proofs.blm91.lemmas_limits import (
    BACKWARD_P,
    BOUND,
    CONVERGES,
    CONVERGES_BY,
    FROM_P,
    IN_TIME,
    LIMIT_WORDS,
    SLOPES_ABOVE,
    SLOPES_END,
    SLOPES_FALL,
    SQUARED,
    power,
    slope,
)
from proofs.blm91.lemmas_turns import RISING, U_, W_, c, ends_at, q
from proofs.blm91.notation import *

p, y, fixed, at, near, away, be, four0, three0, two0, one0, four1, three1, two1, one1, bigger, up, grows, kept, flag, next1, count, alj, gaj = symbols(
    "p y fixed at nearer further b IV_0 III_0 II_0 I_0 IV_1 III_1 II_1 I_1 bigger up grows kept ends alpha_before count alpha_j gamma_j")
beside, under = symbols("beside below")
PLANE = {al0: nonzero(), ga0: scalar()}
ROOT = given("p on the hyperbola", p * (1 + al0**2 - ga0**2) == (1 + p**2) * al0)
SMALLER = standing("0 < |p| < 1", abs(p) < 1)
LINE = {al0: (p * y**2 - 1 / p) / (y**2 - 1), ga0: y * (p - 1 / p) / (y**2 - 1)}
DRAW = dict(using={u: nonzero(), y: scalar()}, made_by={p: SHARE, **LINE})
NEXT = (let(four0, four_(0)), let(three0, three_(0)), let(two0, two_(0)), let(one0, one_(0)), let(four1, four_(1)), let(three1, three_(1)), let(two1, two_(1)), let(one1, one_(1)),
        let(bigger, abs(al[1]) > abs(al0)), let(up, kap * al[1] > kap * al0), let(grows, al[1] / al0 > 1), let(kept, kap * al[1] > 0))
REGION = (INSIDE_KAPPA, *ORBIT, *REGIONS, *NEXT)
SMALL_KAPPA = standing("0 < kappa^2 < 1", (kap != 0) & (kap**2 < 1))
SIGNED = "The index of a point is the sign of kappa, which does not change."

ON_ROOT = (angles("root", 1 - kap**2), valued("on the hyperbola"), multiplied(kap), by_cases(1 - kap**2 > 0))

# ---------------------------------------------------------------------- a) equilibria and limits
claim("BLM91-T3.5.a", "the two equilibria of a hyperbola",
      iff(fixed, at) & (p != y) & (1 + p**2 == 2 / kap * p) & (1 + y**2 == 2 / kap * y), over={al0: scalar(), ga0: scalar(), kap: nonzero()},
      where=[let(p, (1 - sqrt(1 - kap**2)) / kap), let(y, (1 + sqrt(1 - kap**2)) / kap), *ORBIT, let(fixed, (al[1] == al0) & (ga[1] == ga0)), let(at, (ga0 == 0) & ((al0 == p) | (al0 == y)))],
      given=[given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 / kap * al0), given("0 < kappa^2 < 1", kap**2 < 1)],
      by=[arithmetic(*FIRST_STEP, *ON_ROOT, by_cases(ga0 == 0), by_cases(al0 == 0), by_cases(ga0**2 > 0), member=0), *(arithmetic(valued(), *ON_ROOT, cleared(), member=k_) for k_ in (1, 2, 3)),
          instances(40, using={u: nonzero(), x: scalar()}, made_by={kap: 2 * SHARE / (1 + SHARE**2), al0: (SHARE * x**2 - 1 / SHARE) / (x**2 - 1), ga0: x * (SHARE - 1 / SHARE) / (x**2 - 1)}),
          *(example(alpha0=a_, gamma0=0, kappa=k_) for a_, k_ in (("1/3", "3/5"), (3, "3/5"), ("-1/2", "-4/5"), (-2, "-4/5"))), example(alpha0=1, gamma0=0, kappa=1)],
      note="p = alpha_+, y = alpha_-; on the instances the square root of 1 - kappa^2 is rational.")
claim("BLM91-T3.5.a.stab", "stability of the two equilibria",
      ((p * al0 < 1) >> near) & (beside >> away) & ((al[1] - p) * (p * al0 - 1) == p**2 * (al0 - p) * (p * al[1] - 1)) & (ga0**2 == (al0 - p) * (al0 - 1 / p)),
      over={al0: scalar(), ga0: scalar(), p: nonzero()}, where=[*ORBIT, let(near, abs(al[1] - p) <= abs(al0 - p)), let(away, abs(al[1] - 1 / p) >= abs(al0 - 1 / p)), let(beside, (1 < p * al0) & (p * al0 < 1 + p**2))], given=[ROOT, SMALLER],
      by=[steps("BLM91-E5.1", prose="the quotient (alpha - p)/(p alpha - 1) is multiplied by p^2 < 1 at each step, and gamma^2 follows alpha"),
          instances(40, **DRAW), instances(40, using={u: nonzero(), w: nonzero()}, made_by={p: SHARE, y: w / (2 + 2 * abs(w)) * p, **LINE}), example(alpha0="1/3", gamma0=0, p="1/3")],
      note="Starting points with p alpha_0 < 1 (one branch and the other side of infinity) come nearer to p at each step; between 1/p and 2/kappa they move away from 1/p.")
claim("BLM91-T3.5.a.alt", "every other orbit converges to the stable equilibrium or ends",
      always(t, (BOUND) & (p * ga[t] ** 2 == (al[t] - p) * (p * al[t] - 1))),
      over={al0: scalar(), ga0: scalar(), p: nonzero()}, where=[*ORBIT, SQUARED], given=[ROOT, SMALLER, standing("not the other equilibrium", p * al0 != 1)],
      by=[arithmetic(valued(), *FROM_P, *IN_TIME),
          instances(30, using={u: nonzero(), y: scalar()}, made_by={p: SHARE, **LINE}), example(alpha0="1/3", gamma0=0, p="1/3"), example(alpha0=0, gamma0=1, p="1/3")],
      note="kappa = 2p/(1 + p^2), p = alpha_+, so that 0 < |p| < 1 is 0 < kappa^2 < 1. R_t is p^(2t): as soon as it is small enough, as it is for all later t, the distance of alpha_t from p is R_t times a constant at most, and gamma_t^2 = (alpha_t - p)(alpha_t - 1/p). "
           "This is for all t at which the orbit has not ended: it converges if it does not end.")

# ---------------------------------------------------------------------- a) 1) from region to region
claim("BLM91-T3.5.a.1.i", "in IV the modulus of alpha grows until III is reached", grows & (four1 | three1) & kept, over={al0: nonzero(), ga0: nonzero()}, where=REGION, given=[given("in IV", four0), SMALL_KAPPA],
      by=[steps("BLM91-E5.1", facts=["a quotient by a positive number keeps the order"], prose="1 - gamma^2 is in (0, 1), |alpha'| - |gamma'| = |alpha|/(1 + |gamma|) >= 1; alpha_t cannot grow to a limit in IV, which would be an equilibrium with "
                "modulus above |alpha_-|, so that III is reached"),
          instances(40, **IN_IV), example(alpha0=2, gamma0="1/2"), example(alpha0="1/2", gamma0="3/2"), example(alpha0=1, gamma0="1/2"), example(alpha0="3/2", gamma0="1/2"), example(alpha0=-1, gamma0="3/2")],
      note="gamma_0 not 0: not the equilibrium. One step from any point of IV with a next point. " + SIGNED)
claim("BLM91-T3.5.a.1.ii", "from III to II", two1 & ~(kept), over=PLANE, where=REGION, given=[given("in III", three0), SMALL_KAPPA],
      by=[arithmetic(*FIRST_STEP), instances(40, **IN_III), example(alpha0="1/2", gamma0="1/4"), example(alpha0=3, gamma0=2)],
      note="kappa alpha becomes negative. " + SIGNED)
TWO = dict(over=PLANE, where=REGION, given=[given("in II", two0), SMALL_KAPPA])
claim("BLM91-T3.5.a.1.iii", "from II to I", one1 & bigger, **TWO, by=[example(alpha0=1, gamma0=3), instances(**IN_II)],
      repair=repair("other", "kappa alpha grows, from a negative to a positive number, not its modulus: |alpha_1| = |alpha_0|/(gamma_0^2 - 1) is larger than |alpha_0| only for gamma_0^2 < 2; (1, 3) goes to (-1/8, 3/8)",
                    one1 & up & kept, **TWO,
                    by=[arithmetic(*FIRST_STEP, by_cases(al0**2 > 0)),
                        instances(40, **IN_II), example(alpha0=1, gamma0=3), example(alpha0="1/4", gamma0="11/8"), example(alpha0=3, gamma0=1), example(alpha0=2, gamma0="1/4"), example(alpha0="1/2", gamma0="1/4")]),
      note=SIGNED)
claim("BLM91-T3.5.a.1.iv", "in I |alpha| grows to |alpha_+|", one1 & grows & under & ((al[1] - p) * (p * al0 - 1) == p**2 * (al0 - p) * (p * al[1] - 1)),
      over={al0: nonzero(), ga0: nonzero(), p: nonzero()}, where=[*REGION, let(under, abs(al[1]) < abs(p))], given=[given("in I", one0), ROOT, standing("0 < |p| < 1", abs(p) < 1)],
      by=[steps("BLM91-E5.1", facts=["a quotient by a positive number keeps the order"], prose="1 - gamma^2 is in (0, 1), |alpha'| + |gamma'| = |alpha|/(1 - |gamma|) <= 1, and the last equation is the convergence"),
          instances(40, using={u: nonzero(), s1: nonzero()}, made_by={p: SHARE, al0: p * ((s1 + SIGN) ** 2 - 1) / ((s1 + SIGN) ** 2 - p**2), ga0: (s1 + SIGN) * (p**2 - 1) / ((s1 + SIGN) ** 2 - p**2)}),
          instances(40, **DRAW), example(alpha0=3, gamma0="1/2", p="1/3")],
      note="gamma_0 not 0: not the equilibrium. p = alpha_+. " + SIGNED)

# ---------------------------------------------------------------------- a) 2) points that end
#: kappa is 1/lambda for side = 1 and -1/lambda for side = 0, lambda > 1; U_n, and U_(n-1) beside it; b is kappa lambda alpha, for the proof alone
side = sym("side")
SIGN_K = 2 * side - 1
PAIR = dict(sizes=["n"], over={al0: nonzero(), ga0: scalar(), lam: scalar(), side: integer(0, 1)}, given=[
    given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 * SIGN_K * lam * al0), standing("0 < kappa^2 < 1", lam > 1), standing("a step", n >= 1)])
ENDS = (*ORBIT, *REGIONS, let(four0, four_(0)), rec(U_, t, 1, 2 * lam * U_[t] - W_[t]), rec(W_, t, 0, U_[t]), rec(be, t, SIGN_K * al0, 1 / (2 * lam - be[t])), let(flag, leaves(n)))
AT_STEP = dict(using={u: nonzero(), y: nonzero()}, made_by={lam: 1 + abs(u), al0: SIGN_K * U_[n] / W_[n], ga0: y / abs(y) / W_[n]})
#: points of the curve by the lines through (0, 1)
ON_CURVE = dict(using={u: nonzero(), y: scalar()}, made_by={lam: 1 + abs(u), al0: 2 * (SIGN_K * lam + y) / (1 - y**2), ga0: 1 + y * al0})
APART = ("alpha_0 not 0, as (3.13) is derived. The points (0, 1) and (0, -1) satisfy the equation of every hyperbola and lie between I and II; the text sets them apart before the theorem, saying that the orbit ends there. "
         "Were they counted here, they would be an exception.")
#: the point is there and on the hyperbola, with the slope b, or neither is there
SAME_END = by_induction(q, 0, (defined(al[q]) & defined(ga[q]) & defined(be[q]) & (be[q] == SIGN_K * al[q]) & (1 + al[q] ** 2 - ga[q] ** 2 == 2 * SIGN_K * lam * al[q]) & (al[q] != 0))
                        | (~defined(al[q]) & ~defined(ga[q]) & ~defined(be[q])), base=values_at(0, al, ga, be),
                        step=[by_cases(side == 0), cleared(), multiplied(ga[q] ** 2), *values_at(q + 1, al, ga, be)])
#: U_p^2 - 2 lambda U_p U_(p-1) + U_(p-1)^2 = 1
CASSINI_2 = by_induction(p, 0, U_[p] ** 2 - 2 * lam * U_[p] * W_[p] + W_[p] ** 2 == 1, base=[unfolded(U_, 0), unfolded(W_, 0)], step=[unfolded(U_, p + 1), unfolded(W_, p + 1)])
#: which points end at step n
OF_U = SIGN_K * al0 * W_[n] == U_[n]
ENDS_AT = shown_first(iff(defined(ga[n - 1]) & ~defined(ga[n]), OF_U),
                      [shown_first(iff(defined(be[n - 1]) & ~defined(be[n]), OF_U), ends_at(be, SIGN_K * al0, n)), SAME_END, at_index(q, n), at_index(q, n - 1)])
#: at these gamma_0 is 1/U_(n-1) up to sign
GAMMA_OF_U = [RISING, CASSINI_2, at_index(h, n), at_index(h, n - 1), at_index(p, n), unfolded(W_, n), by_cases(side == 0), multiplied(W_[n] ** 2)]
claim("BLM91-T3.5.a.2.i", "only points of IV end", flag >> four0, **PAIR, where=ENDS,
      by=[arithmetic(ENDS_AT, *GAMMA_OF_U, *values_at(0), by_cases(ga0**2 * W_[n] ** 2 == 1), by_cases(ga0 * W_[n] == 1, [], [by_cases(ga0 * W_[n] == -1)])), instances(30, n=(1, 2, 3, 4), **AT_STEP), instances(20, n=(1, 2), **ON_CURVE)],
      note="Ends at step n: the point at n - 1 exists, the one at n does not. IV is |alpha| >= 1 + |gamma|, |gamma| <= 1. kappa is 1/lambda for side = 1, -1/lambda for side = 0; U, U_before and b serve the proof alone. " + APART)
claim("BLM91-T3.5.a.2.ii", "the points that end after a given number of steps", iff(flag, at) & (flag >> (ga0**2 * W_[n] ** 2 == 1)), **PAIR, where=[*ENDS, let(at, al0 == SIGN_K * U_[n] / W_[n])],
      by=[arithmetic(ENDS_AT, RISING, at_index(h, n - 1), unfolded(W_, n), by_cases(side == 0), cleared(), member=0), arithmetic(ENDS_AT, *GAMMA_OF_U, member=1),
          instances(30, n=(1, 2, 3, 4), **AT_STEP), instances(30, n=(1, 2, 3), **ON_CURVE),
          instances(20, n=(2, 3), using={u: nonzero()}, made_by={lam: 1 + abs(u), al0: SIGN_K * U_[n - 1] / W_[n - 1], ga0: 1 / W_[n - 1]})],
      note="The pair that ends after n steps is (U_n, 1)/U_(n-1) up to signs: kappa alpha_0 > 0, and gamma_0 of either sign. U_0 = 1, U_1 = 2 lambda, U_(t+1) = 2 lambda U_t - U_(t-1), U_before is U_(t-1), lambda = 1/|kappa|: kappa is 1/lambda for side = 1, -1/lambda for side = 0. "
           "b serves the proof alone. The formula is (5.3); the print names (5.13), a number that no display has. " + APART)
STEP_ = standing("a step", m >= 1)
claim("BLM91-T3.5.a.2.iii", "the escaping points tend to the unstable equilibrium",
      always(t, (t >= 1) >> ((W_[t] != 0) & (power[t] ** 2 < 1) & ((slope(t) - 1 / p) * p * (1 - power[t] ** 2) == power[t] ** 2 * (1 - p**2))))
      & always(t, (t >= 1) >> (1 / W_[t] * p * (1 - power[t] ** 2) == power[t] * (1 - p**2))) & always(t, (t >= 1) >> ((abs(1 / p) < abs(slope(t + 1))) & (abs(slope(t + 1)) < abs(slope(t))))),
      over={p: nonzero()}, where=BACKWARD_P, given=[standing("0 < |p| < 1", abs(p) < 1)],
      by=[arithmetic(*SLOPES_END, *SLOPES_FALL, member=0), arithmetic(*SLOPES_END, at_index(k, t), angles("quotient", 1, W_[t]), multiplied(1 / W_[t]), multiplied(power[t]), multiplied(p**2 * power[t]), member=1),
          arithmetic(*SLOPES_END, *SLOPES_ABOVE, member=2), instances(40, using={u: nonzero()}, made_by={p: SHARE})],
      note="p = alpha_+, 1/p = alpha_-; the points are (U_i, +-1)/U_(i-1), by 2); U_before is U_(i-1), slope alpha^(i), H_i is p^i, and i is t. The first two equations give the distances from alpha_- and from 0, "
           "p^(2i)(1 - p^2)/(p (1 - p^(2i))) and p^i (1 - p^2)/(p (1 - p^(2i))), which tend to zero.")

# ---------------------------------------------------------------------- b) kappa^2 = 1
UNIT = let(kap, 2 * k - 1)
onit, online, definite, touches = symbols("on_hyperbola on_lines definite touches")
claim("BLM91-T3.5.b", "for kappa^2 = 1 the hyperbola is two lines", iff(onit, online) & (1 + al0**2 - ga0**2 - 2 * kap * al0 == (al0 - kap - ga0) * (al0 - kap + ga0)) & (onit >> (definite & touches)), over={al0: scalar(), ga0: scalar(), k: integer(0, 1)},
      where=[UNIT, let(onit, 1 + al0**2 - ga0**2 == 2 / kap * al0), let(online, abs(ga0) == abs(al0 - kap)), let(D, 1 + al0**2 - ga0**2 + al0 * (Z + recip(Z))),
             let(definite, nonneg_on_circle(D) | nonneg_on_circle(-D)), let(touches, ~(pos_on_circle(D) | pos_on_circle(-D)))],
      by=[arithmetic(by_cases(k == 0), cleared()), instances(), instances(made_by={ga0: al0 - kap}), example(alpha0=2, gamma0=1, k=1), example(alpha0=-3, gamma0=2, k=0)],
      note="kappa = 2k - 1. Both lines pass through (kappa, 0); on them D has one sign on the circle and a zero there, so that they bound the sign definite regions.")
NEARBY = (UNIT, function(alj, [j, t], when(t == 0, kap * (1 + 2 / (2 * j + 1)), alj(j, t - 1) / (1 - gaj(j, t - 1) ** 2))),
          function(gaj, [j, t], when(t == 0, 2 / (2 * j + 1), -gaj(j, t - 1) * alj(j, t - 1) / (1 - gaj(j, t - 1) ** 2))))
LINES_ = (UNIT, *scalar_orbit(kap * (1 + x), x), rec(count, t, 0, count[t] + 1), rec(sg, t, 1, -kap * sg[t]))
still, rest = symbols("still at_rest")
claim("BLM91-T3.5.b.eq", "for kappa^2 = 1 the one equilibrium is stable", exists(i, 1, 12, forall(j, i, 24, forall(t, 0, j, abs(alj(j, t) - kap) <= 1))), over={k: integer(0, 1)}, where=NEARBY,
      by=[example(k=1), instances()],
      repair=repair("boundary case", "it attracts every orbit that does not end, but it is not stable: with alpha_0 = kappa(1 + x), x > 0, the distance x/(1 - t x) first grows; for x = 2/(2j + 1) it is 2 at step j",
                    always(t, (al[t] == kap * (1 + x / (1 - count[t] * x))) & (ga[t] == sg[t] * x / (1 - count[t] * x)) & iff(still, rest)), over={x: scalar(), k: integer(0, 1)},
                    where=[*LINES_, let(still, (al[1] == kap * (1 + x)) & (ga[1] == x)), let(rest, x == 0)],
                    by=[steps("BLM91-X.11", prose="the limit is kappa as t grows, and x/(1 - x) = x only for x = 0"), instances(), example(x=0, k=1), example(x=0, k=0), example(x="2/5", k=1)]),
      note="kappa = 2k - 1. Stable: for some distance 2/(2i + 1) all orbits that start closer stay within distance 1; tried on starting points at distances 2/(2j + 1), j <= 24, none of which stays; by X.11, proved for "
           "every t, the start at distance 2/(2j + 1) is at distance 2 at step j for every j. In the correction count is t and s is (-kappa)^t.")
EDGE_ = (UNIT, *scalar_orbit(kap * (1 + x), x), let(al0, kap * (1 + x)), *REGIONS, *NEXT)
OFF = standing("not (0, +-1) and not the equilibrium", (x != 0) & (x != -1))
FLOW = (three0 >> two1) & (four0 >> (grows & (three1 | four1))) & (one0 >> (one1 & grows))
DRAW_X = instances(60, using={y: scalar()}, made_by={x: y})
claim("BLM91-T3.5.b.orb", "orbits for kappa^2 = 1, in the manner of part a) 1)", FLOW & (two0 >> (one1 & bigger)), over={x: scalar(), k: integer(0, 1)}, where=EDGE_, given=[OFF], by=[example(x=-3, k=1), instances()],
      repair=repair("other", "the manner of part a) 1) has the mistake of T3.5.a.1.iii: it is kappa alpha that grows from II to I, not |alpha|; (-2, 3) goes to (1/4, 3/4)", FLOW & (two0 >> (one1 & up)), over={x: scalar(), k: integer(0, 1)}, where=EDGE_, given=[OFF],
                    by=[steps("BLM91-X.11", prose="alpha_t = kappa(1 + x/(1 - t x)) tends to kappa unless 1/x is one of 1, 2, 3, .."), DRAW_X, example(x="1/3", k=1), example(x="1/2", k=0), example(x=2, k=1), example(x=-3, k=1), example(x="-1/2", k=0)]),
      note="alpha_0 = kappa(1 + x), gamma_0 = x; by the mirror symmetry that covers both lines. kappa = 2k - 1. (0, +-1), x = -1, is in II and I and has no next point.")
#: a point of either line, and whether its orbit ends at step m
EITHER = (2 * side - 1) * x
LAST = (UNIT, *scalar_orbit(kap * (1 + x), EITHER), let(al0, kap * (1 + x)), let(ga0, EITHER), *REGIONS, let(four0, four_(0)), let(flag, leaves(m)), let(at, x * m == 1))
UNDER = [by_cases(k == 0), by_cases(side == 0)]
#: (kappa alpha_i - 1)(1 - i x) = x, and gamma_i = +-(alpha_i - kappa)
ON_LINES = by_induction(i, 0, (defined(al[i]) & defined(ga[i])) >> (((kap * al[i] - 1) * (1 - i * x) == x) & (i * x != 1) & (ga[i] ** 2 == (al[i] - kap) ** 2)),
                        base=[*UNDER, *values_at(0)], step=[*UNDER, cleared(), *values_at(i + 1), multiplied(1 - i * x), multiplied(ga[i] ** 2)])
TOGETHER = by_induction(j, 0, iff(defined(al[j]), defined(ga[j])), base=[existing(al, 0), existing(ga, 0)], step=[existing(al, j + 1), existing(ga, j + 1)])
#: gamma_i^2 = 1 only for (i + 1) x = 1 or (i - 1) x = 1
AT_ONE = shown_first(forall(s, 0, m, (defined(al[s]) & (ga[s] ** 2 == 1)) >> (((s + 1) * x == 1) | ((s - 1) * x == 1))),
                     [*UNDER, at_index(i, s), at_index(j, s), by_cases(al[s] == kap + 1), by_cases(al[s] == kap - 1)])
UNTIL = by_induction(c, 0, ((c <= m - 1) & (x * m == 1)) >> defined(ga[c]), base=[existing(ga, 0)], step=[existing(ga, c + 1), at_index(j, c), at_index(s, c), multiplied(m), multiplied(x)])
TO_END = [
    ON_LINES, TOGETHER, AT_ONE,
    shown_first(flag >> at, [existing(ga, m), existing(ga, m - 1), *(at_index(n_, m - 1) for n_ in (j, s)), at_index(i, m - 2), at_index(j, m - 2), by_cases(m == 1, [*UNDER, *values_at(0)])])]
LINES_END = [*TO_END, UNTIL, shown_first(at >> flag, [*UNDER, existing(ga, m), *(at_index(n_, m - 1) for n_ in (c, j, i)), multiplied(x), by_cases(kap * al[m - 1] == 2)])]
claim("BLM91-T3.5.b.esc", "points that end for kappa^2 = 1", iff(flag, at) & (flag >> (four0 & (al0 == kap * (m + 1) / m) & (abs(ga0) * m == 1))) & (abs(kap * (m + 2) / (m + 1)) < abs(kap * (m + 1) / m)), sizes=["m"],
      over={x: scalar(), k: integer(0, 1), side: integer(0, 1)}, where=LAST, given=[STEP_, given("not (0, +-1)", x != -1)],
      by=[arithmetic(*LINES_END, member=0), arithmetic(*TO_END, *UNDER, *values_at(0), cleared(), by_cases(x > 0), multiplied(m), member=1),
          arithmetic(*UNDER, angles("quotient", 1, m), angles("quotient", 1, m + 1), by_cases(1 / (m + 1) > 0), by_cases(1 / (m + 1) < 1 / m), cleared(), member=2),
          instances(30, m=(1, 2, 3, 4), made_by={x: 1 / m}), instances(30, m=(1, 2, 3)), example(m=2, x="1/3", k=1, side=1), example(m=1, x=-1, k=0, side=1)],
      note="alpha_0 = kappa(1 + x), gamma_0 = x or -x, kappa = 2k - 1: the points of both lines. The pair that ends after m steps is kappa(m + 1)/m, +-1/m, in IV; it tends to (kappa, 0), |alpha| falling. " + APART)
claim("BLM91-T3.5", "Theorem 3.5", (two0 >> (one1 & bigger)) & (three0 >> two1) & (one0 >> one1), over=PLANE, where=REGION, given=[SMALL_KAPPA], by=[example(alpha0=1, gamma0=3), instances(**IN_II)],
      repair=repair("other", "T3.5.a.1.iii and, for kappa^2 = 1, T3.5.b.orb fail: from II to I kappa alpha grows, not |alpha|; T3.5.b.eq fails: for kappa^2 = 1 the equilibrium attracts but is not stable; the other parts hold",
                    (two0 >> (one1 & up)) & (three0 >> two1) & (one0 >> one1), over=PLANE, where=REGION, given=[SMALL_KAPPA],
                    by=[part("the steps between regions for kappa^2 < 1"), steps("BLM91-E5.1", "BLM91-X.1", prose="parts by the claims T3.5.a to T3.5.b.esc"), instances(20, **IN_II), instances(20, **IN_III), instances(20, **IN_I), instances(20, **IN_IV)]),
      note="The conjunction of the parts, represented by the steps between regions.")
claim("BLM91-S39", "orbits of the sign definite regions converge unless they end", CONVERGES, over={al0: scalar(), ga0: scalar(), p: nonzero()}, where=[*ORBIT, *LIMIT_WORDS], given=[ROOT, standing("0 < |p| <= 1", abs(p) <= 1)],
      by=[*CONVERGES_BY, instances(40, using={u: nonzero(), y: scalar()}, made_by={p: SHARE, **LINE}), instances(20, using={y: nonzero()}, made_by={p: y / abs(y), al0: y + y / abs(y), ga0: y}),
          *(example(alpha0=a_, gamma0=g_, p=p_) for a_, g_, p_ in (("1/2", "1/2", 1), (4, 3, 1), (-4, -3, -1), (1, 0, 1), (3, 0, "1/3"), ("1/3", 0, "1/3")))],
      note="The sign definite regions are kappa^2 <= 1: p = alpha_+ is real there, |p| <= 1. R_t is p^(2t). For |p| < 1 alpha_t - p falls as R_t, from where this is small enough; for |p| = 1 it is 2/t at most, for t >= 2/|alpha_0 - p|; "
           "gamma_t^2 = (alpha_t - p)(alpha_t - 1/p); and from 1/p, the other equilibrium, alpha_t does not move. All this for as long as the orbit has not ended. alpha_0 = 0 leads to (0, 0) by S36.")
