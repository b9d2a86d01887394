# SPDX-License-Identifier: MIT
"""Section V, proof of Corollary 4.3 (headed Corollary 4.2), and what the conclusion says.

With pi = 1 - alpha_0/alpha the increment pi' - pi = (1 - pi) gamma^2 of the Riccati equation is alpha' =
alpha/(1 - gamma^2). Together with alpha' = kappa/(2 - kappa alpha) it gives the hyperbola, and gamma'^2 = alpha'^2 gamma^2.

phi has the discriminant 4 alpha_0^2 (1/kappa^2 - 1): real zeros for |kappa| <= 1, negative values only for |kappa| < 1.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import combination, example, identity, instances, steps
from exactkf.language import *
from proofs.blm91.notation import *

y, an, pn, phi_, neg, real, small, least, hits, far = symbols("y alpha_next pi_next phi negative real small least hits far")
INSERT = (let(pn, (1 - al0 / x) + (1 - (1 - al0 / x)) * y**2), let(an, al0 / (1 - pn)))
claim("BLM91-S97", "(4.16) into (4.19)", an == x / (1 - y**2), over={al0: nonzero(), x: nonzero(), y: scalar()}, where=INSERT, by=[identity(), instances()],
      note="x = alpha_t, y = gamma_t. (4.16) is (5.4) solved for pi_t; the print names (5.7), which is the step in the coordinate a.")
ALPHA = {x: nonzero(), y: scalar(), an: scalar(), kap: nonzero()}
claim("BLM91-S98", "the integral curve by elimination", 1 + x**2 - y**2 == 2 * x / kap, over=ALPHA, given=[given("first equation", an == x / (1 - y**2)), given("slope map", an == kap / (2 - kap * x))],
      by=[combination([(-(1 - y**2) * (2 - kap * x) / kap, "slope map", 1), ((1 - y**2) * (2 - kap * x) / kap, "first equation", 1)]),
          instances(made_by={kap: 2 * x / (1 + x**2 - y**2), an: x / (1 - y**2)})])
claim("BLM91-S99", "the slope map, multiplied out", 2 * an / kap == 1 + an * x, over={x: scalar(), an: scalar(), kap: nonzero()}, given=[given("slope map", an == kap / (2 - kap * x))],
      by=[combination([((2 - kap * x) / kap, "slope map", 1)]), instances(made_by={an: kap / (2 - kap * x)})])
claim("BLM91-S100", "gamma at the next step", eq(1 + an**2 - 2 * an / kap, an**2 * (1 - x / an), an**2 * (1 + x**2 - 2 * x / kap)), over={x: scalar(), kap: nonzero()},
      where=[let(an, kap / (2 - kap * x))], by=[identity(), instances()], note="gamma_t^2 = 1 + alpha_t^2 - 2 alpha_t/kappa at t and t + 1, x = alpha_t.")
PHI = (let(kap, 2 * al0 / (1 + al0**2 - ga0**2)), function(phi_, [y], y**2 - 2 * (1 - al0 / kap) * y + ga0**2), let(least, phi_(1 - al0 / kap)), let(neg, least < 0), let(real, least <= 0))
EDGES = [example(alpha0="1/2", gamma0="1/2"), example(alpha0="1/2", gamma0=0), example(alpha0=1, gamma0=1), example(alpha0=-2, gamma0=3), example(alpha0=3, gamma0=1)]
claim("BLM91-S101", "negative values and real zeros of phi", iff(neg, real) & iff(real, kap**2 <= 1), over={al0: nonzero(), ga0: scalar()}, where=PHI, by=[*EDGES, instances()],
      repair=repair("boundary case", "for |kappa| = 1 phi has a double zero and no negative value: it takes negative values exactly for |kappa| < 1",
                    iff(neg, small) & iff(real, kap**2 <= 1), over={al0: nonzero(), ga0: scalar()}, where=[*PHI, let(small, kap**2 < 1)],
                    by=[steps(facts=["a quadratic polynomial takes its least value at its vertex"], prose="the least value is alpha_0^2 (1 - 1/kappa^2)"), instances(60), *EDGES]),
      note="phi takes its least value at 1 - alpha_0/kappa; it has real zeros when that is <= 0.")

# ---------------------------------------------------------------------- the conclusion of the paper
CORRIDOR = standing("corridor", (1 + al0**2 - ga0**2) ** 2 < 4 * al0**2)
NEAR = let(hits, sum_of(j, 1, 3, when(abs(lam + cospi(2 * j, 7)) < rational("1/2"), 1, 0)))
IN_CORRIDOR = dict(using={u: scalar(), y: scalar()}, made_by={al0: 2 * (SHARE + y) / (1 - y**2), ga0: 1 + y * al0})
claim("BLM91-S102", "period-3 points are dense in the corridors", 2 * lam == 1, over={al0: nonzero(), ga0: scalar()}, where=[LAMBDA], given=[CORRIDOR],
      by=[example(alpha0=1, gamma0="1/2"), instances(**IN_CORRIDOR)],
      repair=repair("other", "the points of one period p fill finitely many hyperbolas kappa = -sec(2 pi q/p), uncountable but not dense; the periodic points of all periods together are dense",
                    hits >= 1, over={al0: nonzero(), ga0: scalar()}, where=[LAMBDA, NEAR], given=[CORRIDOR],
                    by=[steps("BLM91-X.2", facts=["rational multiples of pi are dense, and the cosine is continuous"], prose="kappa is a continuous function of the point, and all points of the hyperbolas "
                              "kappa = -sec(2 pi q/p) are periodic, finitely many values of alpha aside"), instances(16, **IN_CORRIDOR), example(alpha0=1, gamma0="1/2"), example(alpha0=-1, gamma0=1)]),
      note="Dense points of period p for each p is read for p = 3: these are points of the hyperbola kappa = 2, a closed set in the corridors, so that density would put every point on it. In the correction hits "
           "counts the q for which the hyperbola of period 7 lies within 1/2 of the given one in 1/kappa.")
claim("BLM91-S103", "dense sets of unbounded and of escaping orbits",
      (hits >= 1) & (far >= 1), over={al0: nonzero(), k: integer(1, 4)},
      where=[let(lam, when(k == 1, rational("3/5"), when(k == 2, rational("-1/3"), when(k == 3, rational("1/7"), rational("-4/5"))))),
             function(Ut, [t], when(t == 0, 1, when(t == 1, 2 * Z, 2 * Z * Ut(t - 1) - Ut(t - 2)))),
             let(hits, real_roots(Ut(31) - al0 * Ut(30), lam - rational("1/9"), lam + rational("1/9"))),
             function(Mt, [t], when(t == 0, 1, when(t == 1, 2 * lam - al0, 2 * lam * Mt(t - 1) - Mt(t - 2)))), let(far, sum_of(t, 1, 60, when(abs(Mt(t - 1)) > 5 * abs(Mt(t)), 1, 0)))],
      by=[steps("BLM91-X.1", "BLM91-X.2", "BLM91-X.6", facts=["Kronecker: multiples of an irrational part of a full turn are dense on the circle"],
                prose="(alpha_0, gamma) ends at step i when U_i(lambda) = alpha_0 U_(i-1)(lambda), which has i zeros in lambda, dense as i grows; already the points with |gamma| = 1 are uncountably many; "
                      "where the angle is irrational all but countably many orbits are dense, hence unbounded"), instances(24)],
      note="hits: values of 1/kappa within 1/9 of lambda for which the point with first coordinate alpha_0 ends at step 31. far: steps t <= 60 with |alpha_t| > 5 on the hyperbola of lambda (3/5, -1/3, 1/7, -4/5: "
           "irrational angles).")
E1V = matrix_of(i, j, n, 1, when(i == 1, 1, 0))
claim("BLM91-S104", "the phenomena persist in every dimension",
      always(t, (Qp(t) == Z ** (n - 1) * (r[t] * (Z + al[t]))) & (Qs(t) == Z ** (n - 1) * (r[t] * ga1[t]))), sizes=["n"],
      over={al0: scalar(), ga0: scalar()}, where=[*stripped(al0 * E1V, ga0 * E1V), *POLYNOMIALS, *scalar_orbit(al0, ga0, ga1)],
      by=[steps("BLM91-S55", "BLM91-X.1", "BLM91-X.2", prose="the points with q, q* multiples of the first unit vector form a plane that (2.25) maps into itself as (3.10) does; periods, dense orbits and escape are those of n = 1, and D is the same"),
          instances(n=(1, 2, 3, 4))],
      note="The algorithm of order n on the imbedded plane: Q_t and Q*_t are those of order one times z^(n-1).")
