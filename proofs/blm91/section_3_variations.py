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
from exactkf.evidence import combination, evaluation, example, identity, instances, positivity, steps
from exactkf.language import *
from proofs.blm91.notation import *

pi_, y, f, dpi, inside, rest, escapes, H, be, back, many, hits, flag, nn, d, gcd, mult, x1, x2, x3, x4, slope, doubled = symbols(
    "pi y f dpi inside at_rest escapes H b back divides hits found n_angle d gcd multiplier x_1 x_2 x_3 x_4 slope doubled")
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
      by=[steps(facts=["x(1 - x) is between 0 and 1/4 on the unit interval"], prose="kappa/4 <= 1"), instances(60, using={u: scalar(), w: scalar()}, made_by={x: abs(u) / (1 + abs(u)), kap: 4 * abs(w) / (1 + abs(w))}),
          example(kappa=4, x="1/2"), example(kappa=5, x="1/2"), example(kappa=1, x=2), example(kappa=0, x=1)],
      note="The display introduces the map; checked is that it maps [0, 1] into itself for 0 <= kappa <= 4.")
#: four points of an orbit of (3.17), the last returning to the first
CYCLE = (function(f, [x], kap * x - kap * x * x), let(x1, y), let(x2, f(x1)), let(x3, f(x2)), let(x4, f(x3)), let(mult, kap**4 * (1 - 2 * x1) * (1 - 2 * x2) * (1 - 2 * x3) * (1 - 2 * x4)))
