# SPDX-License-Identifier: MIT
"""Section III, Remarks 3.11 and 3.12: continuous time, and a family of maps with one parameter.

In continuous time alpha = a + g - pi and gamma^2 = d pi/dt turn the scalar Riccati equation d pi/dt = -2a pi + (g - pi)^2 into d alpha/dt = -gamma^2,
d gamma/dt = -gamma alpha. H = alpha^2 - gamma^2 is constant, so that d alpha/dt = H - alpha^2 and alpha = y'/y with y'' = H y, y(0) = 1, y'(0) = alpha_0. A
solution escapes at the first positive zero of y. There is one when H < 0, and for H >= 0 when alpha_0 < -sqrt(H); for gamma_0 not 0 that is every
point outside alpha >= |gamma|. But (alpha, 0) is at rest, also for alpha < 0.

The slope map f(kappa, alpha) = kappa/(2 - kappa alpha) takes 1/kappa = cos(pi n/d) to a map of period d, all other kappa^2 > 1 to one with dense
orbits. In the quadratic family kappa x(1 - x) the period doubles at 3, 1 + sqrt 6 = 3.449.., 3.544.., 3.564.., .. up to 3.5699..: beyond 3.45 the
doubling goes on.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import (
    arithmetic,
    at_index,
    by_cases,
    by_induction,
    combination,
    example,
    identity,
    instances,
    multiplied,
    square_of,
    steps,
    unfolded,
    valued,
)
from exactkf.language import *
from proofs.blm91.lemmas_turns import by_ends, not_before, of_slope
from proofs.blm91.notation import *

pi_, y, f, dpi, inside, rest, escapes, H, be, back, hits, flag, nn, d, gcd, mult, x1, x2, x3, x4, slope, above, Us = symbols(
    "pi y f dpi inside at_rest escapes H b back hits found n_angle d gcd multiplier x_1 x_2 x_3 x_4 slope above U_before")
p = sym("p")
fixed = sym("multiple")
RATE = (let(dpi, -2 * a * pi_ + (g - pi_) ** 2), let(al0, a + g - pi_))
claim("BLM91-E3.15", "the continuous-time system from the Riccati equation",
      (coeff(y, 1) == -2 * al0 * dpi) & (al0 - (a + g - (pi_ + dpi)) == dpi), over={a: scalar(), g: scalar(), pi_: scalar()},
      where=[*RATE, let(y, -2 * a * (pi_ + dpi * Z) + (g - pi_ - dpi * Z) ** 2)], by=[identity(), instances()],
      note="d pi/dt = -2a pi + (g - pi)^2, alpha = a + g - pi, gamma^2 = d pi/dt. Moving pi by dpi lowers alpha by dpi = gamma^2, which is the first equation; the rate dpi itself changes, to first order, "
           "by -2 alpha gamma^2, so that 2 gamma d gamma/dt = -2 alpha gamma^2, the second.")
claim("BLM91-R3.11.1", "the integral of the continuous-time system", coeff((al0 - ga0**2 * Z) ** 2 - (ga0 - ga0 * al0 * Z) ** 2, 1) + al0**2 - ga0**2 == coeff((al0 - ga0**2 * Z) ** 2 - (ga0 - ga0 * al0 * Z) ** 2, 0),
      over={al0: scalar(), ga0: scalar()}, by=[identity(), instances()], note="alpha^2 - gamma^2 along (alpha, gamma) + z (-gamma^2, -gamma alpha): the coefficient of z is its rate of change.")
INSIDE = let(inside, al0 >= abs(ga0))
CONT = (INSIDE, let(rest, (-(ga0**2) == 0) & (-ga0 * al0 == 0)), let(H, al0**2 - ga0**2), let(escapes, (H < 0) | (al0 < 0) & (al0**2 > H)))
claim("BLM91-R3.11.2", "continuous time: escape outside the positive real region", ~inside >> ~rest, over={al0: scalar(), ga0: scalar()}, where=CONT, by=[example(alpha0=-1, gamma0=0), instances()],
      repair=repair("boundary case", "(alpha, 0) is at rest for every alpha, also for alpha < 0, outside the region; every solution with gamma_0 not 0 outside the region escapes",
                    iff(~inside, escapes) & ~rest & (H - al0**2 == -(ga0**2)), over={al0: scalar(), ga0: nonzero()}, where=CONT,
                    by=[steps("BLM91-R3.11.1", facts=["the solution of d alpha/dt = H - alpha^2 is y'/y with y'' = H y, y(0) = 1, y'(0) = alpha_0"],
                              prose="y has a positive zero for H < 0, and for H >= 0 exactly when alpha_0 < -sqrt(H)"), instances(60), example(alpha0=1, gamma0=1), example(alpha0=-1, gamma0=1), example(alpha0=-2, gamma0=1), example(alpha0=2, gamma0=1)]),
      note="As printed no solution that starts outside alpha >= |gamma| stays for ever; a point at rest stays. escapes: y, with H = alpha_0^2 - gamma_0^2, has a positive zero.")

# ---------------------------------------------------------------------- one parameter
claim("BLM91-E3.16", "the slope map", al[1] == kap / (2 - kap * al0), over={al0: scalar(), ga0: scalar(), kap: nonzero()}, where=ORBIT, given=[given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 / kap * al0)],
      by=[combination([(-kap / ((1 - ga0**2) * (2 - kap * al0)), "on the hyperbola", 1)]), instances(made_by={kap: 2 * al0 / (1 + al0**2 - ga0**2)})],
      note="f(kappa, alpha) = kappa/(2 - kappa alpha), as in (5.1).")
claim("BLM91-E3.17", "the quadratic map of the unit interval", (y >= 0) & (y <= 1), over={kap: scalar(), x: scalar()}, where=[let(y, kap * x - kap * x**2)],
      given=[standing("0 <= kappa", kap >= 0), given("kappa <= 4", kap <= 4), given("unit interval", (x >= 0) & (x <= 1))],
      by=[arithmetic(by_cases(x * (1 - x) >= 0), square_of(1 - 2 * x)), instances(60, using={u: scalar(), w: scalar()}, made_by={x: abs(u) / (1 + abs(u)), kap: 4 * abs(w) / (1 + abs(w))}),
          example(kappa=4, x="1/2"), example(kappa=5, x="1/2"), example(kappa=1, x=2), example(kappa=0, x=1)],
      note="The display introduces the map; checked is that it maps [0, 1] into itself for 0 <= kappa <= 4.")
#: Q(y), y on the real 4-cycle for kappa = 7/2 and for kappa = 71/20
STABLE = example(kappa="7/2", y=[0, 1], field=[["54272/13841287201", "-61056/282475249", "203520/40353607", "-2520680/40353607", "383772/823543", "-263610/117649", "849283/117649", "-38154/2401",
                                                "8217/343", "-8338/343", "111/7", -6, 1], "19/50", "2/5"])
DOUBLED = example(kappa="71/20", y=[0, 1], field=[
    ["55715840000000000/16409682740640811134241", "-633767680000000/3255243551009881201", "214192582400000/45848500718449031", "-2710495568008000/45848500718449031", "4077611901200/9095120158391",
     "-279590565860/128100283921", "909138688421/128100283921", "-399685486/25411681", "8526465/357911", "-8678520/357911", "1125/71", -6, 1], "9/25", "37/100"])
FOUR = [standing("a cycle of period 4", (f(x4) == x1) & (f(x2) != x1)), standing("3.45 < kappa < 3.57", (kap > rational("69/20")) & (kap < rational("357/100")))]
CYCLES = (function(f, [x], kap * x - kap * x * x), let(x1, y), let(x2, f(x1)), let(x3, f(x2)), let(x4, f(x3)), let(mult, kap**4 * (1 - 2 * x1) * (1 - 2 * x2) * (1 - 2 * x3) * (1 - 2 * x4)))
FAMILY = dict(over={kap: scalar(), y: scalar()}, where=CYCLES, given=FOUR)
claim("BLM91-R3.12.1", "period doubling in the quadratic family", abs(mult) < 1, **FAMILY, by=[DOUBLED],
      repair=repair("other", "3.449.. = 1 + sqrt 6 is where the period doubles from 2 to 4, not where doubling ends: the 4-cycle is stable at 7/2, stays so to 3.544.., and at 71/20 it has lost its stability by a multiplier below -1, to a cycle of period 8",
                    ((kap <= rational("3544/1000")) >> above) & ((kap >= rational("3545/1000")) >> ~(above)) & (mult < 1), over=FAMILY["over"], where=[*CYCLES, let(above, mult > -1)], given=FOUR, by=[STABLE, DOUBLED]),
      note="Had doubling subsided for kappa > 3.45, the 4-cycle that is stable there would stay so up to the onset of chaos at 3.5699... The real 4-cycle is taken at kappa = 7/2 and 71/20, in its number field. That stable cycles of "
           "arbitrarily high period 2^k exist in the range is right because doubling goes on; that (3.17) maps [0, 1] into itself is E3.17.")
LOW = [standing("angle", nn < d), standing("lowest terms", gcd(d, nn) == 1)]
Am = sym("A")
CIRCLE = (GCD, let(lam, cospi(nn, d)), CHEBYSHEV, rec(Am, t, Identity(2), rows([[2 * lam, -1], [1, 0]]) * Am[t]), function(fixed, [t], Am[t] == Am[t][1, 1] * Identity(2)))
claim("BLM91-R3.12.2", "finitely many slopes end, all others are periodic",
      (forall(i, 1, p, Ut[i] != y * Us[i]) >> (be[p] == y)) & forall(t, 1, p, iff(defined(be[t]), forall(i, 1, t, Ut[i] != y * Us[i]))) & forall(i, 1, p, (Ut[i] != 0) | (Us[i] != 0)), sizes=["p"],
      over={lam: scalar(), x: scalar(), y: scalar()},
      where=[rec(Ut, t, 1, 2 * lam * Ut[t] - Us[t]), rec(Us, t, 0, Ut[t]), rec(x1, t, x, 1 / (2 * lam - x1[t])), rec(be, t, y, 1 / (2 * lam - be[t]))],
      given=[given("|kappa| > 1", lam**2 < 1), standing("a step", p >= 1), given("a periodic point", x1[p] == x)],
      by=[arithmetic(valued(), valued("a periodic point"), of_slope(x1, x, s), of_slope(be, y, j), at_index(s, p), at_index(j, p), by_cases(Us[p] == 0), square_of(x - lam),
                     by_cases(1 + x**2 - 2 * lam * x > 0), multiplied(Us[p]), member=0),
          arithmetic(of_slope(be, y, j), by_ends(be, y), not_before(be, y), at_index(k, t), at_index(m, t), at_index(i, i), member=1),
          arithmetic(by_induction(j, 0, Ut[j] ** 2 - 2 * lam * Ut[j] * Us[j] + Us[j] ** 2 == 1, base=[unfolded(Ut, 0), unfolded(Us, 0)], step=[unfolded(Ut, j + 1), unfolded(Us, j + 1)]),
                     at_index(j, i), member=2),
          instances(30, p=(2, 3, 4, 6), made_by={lam: when(p == 3, rational("1/2"), 0)}), *(example(**{"p": m_, "lambda": l_, "x": "1/3", "y": y_}) for m_, l_, y_ in (
              (3, "1/2", 0), (3, "1/2", 1), (2, 0, 0), (2, 0, 5), (3, "-1/2", -1), (6, "1/2", 0), (4, 0, "1/2"))), example(**{"p": 2, "lambda": 1, "x": 1, "y": 2})],
      note="1/kappa is lambda. If one slope x is back after p steps, then every slope y is back after p steps, but those with y U_(i-1) = U_i for some i <= p, which end with the first such i: "
           "one slope at most for each i, as U_i and U_(i-1) are not both 0. No angle is needed.")
beside, at_k, stops, close, comes = symbols("lambda_near at_k stops close comes_near")
#: a rational number with irrational angle beside lambda; does the orbit of its slope map end with this step, is it near j
BESIDE = (function(at_k, [k], when((abs(20 * lam - k) < 2) & (k != 0) & (abs(k) != 10), k, at_k(k + 1))), let(beside, at_k(-19) / 20), rec(be, t, x, 1 / (2 * beside - be[t])),
          function(stops, [t], ~defined(be[t])), function(close, [t], abs(be[t] - j) <= 1), let(comes, exists(t, 1, 600, stops(t) | close(t))))
claim("BLM91-R3.12.3", "irrational angles are near", (abs(beside - lam) * 10 < 1) & (beside**2 < 1) & comes, over={d: integer(2, 16), nn: integer(1, 15), x: scalar(), j: integer(-3, 3)},
      where=[GCD, let(lam, cospi(nn, d)), *BESIDE], given=LOW,
      by=[steps("BLM91-X.6", facts=["a rational zero of a monic polynomial with integer coefficients is an integer", "Kronecker: multiples of an irrational part of a full turn are dense on the circle"],
                prose="rational values of 1/kappa other than 0, 1/2, -1/2 have irrational angles and are dense; there every orbit is dense or ends"), instances(20), example(d=2, n_angle=1, x=0, j=2), example(d=3, n_angle=1, x=2, j=-3),
          example(d=4, n_angle=1, x="7/5", j=3)],
      note="lambda_near is a rational number k/20 with irrational angle within 1/10 of 1/kappa = cos(pi n/d); (3.16) is run with it from x, until it ends or is within 1 of j, tried for 600 steps.")
claim("BLM91-R3.12.4", "periodic or dense, nothing else", forall(t, 1, 6, iff(be[t] == x, back(t))) & (slope * (1 - 2 * lam * x + x**2) == 1 - 2 * lam * be[1] + be[1] ** 2), over={d: integer(-11, 11), x: scalar()},
      where=[let(lam, d / 12), rec(be, t, x, 1 / (2 * lam - be[t])), let(slope, be[1] ** 2), function(back, [t], (lam == 0) & exists(k, 1, 3, 2 * k == t) | (4 * lam**2 == 1) & exists(k, 1, 2, 3 * k == t))],
      by=[steps("BLM91-S71", "BLM91-X.6", facts=["Kronecker: multiples of an irrational part of a full turn are dense on the circle"],
                prose="A is a turn in a suitable basis; the derivative f' = f^2 satisfies the second equation, so that f multiplies lengths d alpha/(1 - 2 lambda alpha + alpha^2) by one: neither attraction nor repulsion"),
          instances(40), *(example(d=d_, x=x_) for d_ in (6, 0, -6, 5) for x_ in (2, "-1/3"))],
      note="|kappa| > 1. For 1/kappa = d/12: returns within 6 steps exactly for 0 (period 2) and +-1/2 (period 3). slope is f'(alpha); critically stable means that f keeps a length.")
