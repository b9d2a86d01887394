# SPDX-License-Identifier: MIT
"""Section II, (2.31)-(2.35): the positive real region and the classical case, in particular n = 1.

Each state (q, q*) of the stripped algorithm is itself a set of data, a = q -
q*, g = q*, and the invariant says that its Phi_+ has real part D r_t / |Q_t -
Q*_t|^2 on the circle: with r_t > 0 the Popov condition is handed on, and so
is stability.

The set of positive real (a, g) is bounded, because a(z) and a(z) + 2 g(z)
are Schur polynomials, whose coefficients are bounded by binomial
coefficients. It contracts to the origin along (rho^i a_i, rho^i g_i): this
replaces Phi_+(z) by Phi_+(z/rho), which for 0 < rho <= 1 has positive real
part outside the disc when Phi_+ has.

For n = 1 everything is explicit. Phi_+ = 1/2 + g/(z + a) has, up to the factor
|z + a|^2, the real part 1 + a^2 + 2ag + 2(a + g) cos(theta); its least value is
(1 - |alpha|)^2 - gamma^2 with alpha = a + g, gamma = g, and together with |a| < 1
this is the diamond |alpha| + |gamma| < 1. The algorithm maps the diamond into
itself, since |alpha'| + |gamma'| = |alpha|/(1 - |gamma|), and on the curve 1 +
alpha^2 - gamma^2 = (p + 1/p) alpha through the point it acts on alpha as a
linear fractional map with fixed points p and 1/p: the quotient (alpha - p)/(alpha -
1/p) is multiplied by p^2 at each step, so alpha_t tends to p.
"""

from exactkf.claims import claim
from exactkf.evidence import (
    arithmetic,
    at_index,
    by_cases,
    by_induction,
    cleared,
    example,
    identity,
    induction,
    instances,
    multiplied,
    shown_first,
    square_of,
    steps,
    unfolded,
)
from exactkf.language import *
from proofs.blm91.lemmas_steady import CONVERGES, CONVERGES_BY, READ, STEADY_WORDS
from proofs.blm91.notation import *

AG = {a: vector(n), g: vector(n)}
POLY = (*stripped(g + a, g), *POLYNOMIALS)
den, pop, rho, d, As, Gs, nums, sg = symbols("a_m N_m rho d a_rho g_rho N_rho sigma")

# ---------------------------------------------------------------------- Popov condition along the algorithm
#: den = Q_t - Q*_t; pop = |den|^2 times the real part (doubled) of 1/2 + Q*_t/den
ALONG = (let(den, Qp(m) - Qs(m)), let(pop, den * recip(den) + Qs(m) * recip(den) + recip(Qs(m)) * den))
POSITIVE_R = given("r_t > 0", forall(t, 0, m, r[t] > 0))
claim("BLM91-E2.31", "the Popov condition is handed on",
      pos_on_circle(pop), sizes=["n", "m"], over=AG, where=[*POLY, *DATA, *ALONG],
      given=[given("Popov condition", pos_on_circle(num)), POSITIVE_R],
      by=[steps("BLM91-E2.28", "BLM91-E2.30", prose="on the circle the real part of 1/2 + Q*_t/(Q_t - Q*_t) times 2|Q_t - Q*_t|^2 is "
                "|Q_t|^2 - |Q*_t|^2 = r_t D, positive for all t or for none as r_t > 0, and then Q_t - Q*_t has no zero there"),
          instances(n=(1, 2, 3), m=(0, 1, 2, 3), **CLASSICAL), *EDGE, example(n=1, m=2, a=["11/4"], g=["1/4"])],
      note="The Popov condition of b/(2a) is written without denominators, as positivity of |a|^2 + g a* + g* a; m is the time t.")
claim("BLM91-S24", "each step gives data of another stochastic system",
      schur(den) & pos_on_circle(pop), sizes=["n", "m"], over=AG, where=[*POLY, *DATA, *ALONG], given=REAL,
      by=[steps("BLM91-E2.27", "BLM91-E2.28", facts=["Rouche's theorem", "Schwarz's lemma"],
                prose="r_t > 0 as for the stability of the filter matrix, hence |Q*_t| < |Q_t| on the circle, so Q_t - Q*_t has as many zeros in the disc as Q_t, and Q_(t+1) = Q_t - gamma_t z Q*_t as many again"),
          instances(n=(1, 2, 3), m=(0, 1, 2, 3), **CLASSICAL), *EDGE],
      note="a := q_t - q*_t and g := q*_t are positive real; den is r_t times a(z), m is the time t.")

# ---------------------------------------------------------------------- convergence for positive real data
claim("BLM91-S23", "convergence to the steady-state filter", CONVERGES[0] & CONVERGES[1], **STEADY_WORDS, by=CONVERGES_BY,
      note=READ + " With q_t - a, k_t tends to x - a, the steady-state gain.")

# ---------------------------------------------------------------------- shape of the positive real region
binom = sym("binomial")
claim("BLM91-S25", "the positive real region is bounded and contracts to a point",
      forall(i, 1, n, (abs(a[i]) <= binom(i)) & (abs(a[i] + 2 * g[i]) <= binom(i))) & schur(As) & pos_on_circle(nums),
      sizes=["n"], over={a: vector(n), g: vector(n), rho: positive()},
      where=[*DATA, function(binom, [i], prod(j, 1, i, (n - j + 1) / j)),
             let(As, Z**n + sum_of(i, 1, n, rho**i * a[i] * Z ** (n - i))), let(Gs, sum_of(i, 1, n, rho**i * g[i] * Z ** (n - i))),
             let(nums, As * recip(As) + Gs * recip(As) + recip(Gs) * As)],
      given=[*REAL, given("contraction", rho < 1)],
      by=[steps("BLM91-E2.30", facts=["coefficients of a Schur polynomial are less than binomial coefficients", "b is Schur where b/(2a) is positive real",
                                      "the real part of an analytic function takes its minimum on the boundary"],
                prose="(rho^i a_i, rho^i g_i) belongs to Phi_+(z/rho), analytic with positive real part for |z| >= rho"),
          instances(n=(1, 2, 3), using={u: vector(n), w: vector(n), x: positive()},
                    made_by={a: u / (1 + SU), g: w / (2 * (1 + SU) * (1 + SW)), rho: 1 / (1 + x)}),
          example(n=2, a=["-38/25", "9/10"], g=["4/5", "-9/10"], rho="9/10"), example(n=2, a=["2/25", "-9/10"], g=["-4/5", "9/10"], rho="1/2"),
          example(n=2, a=["38/25", "9/10"], g=["-4/5", "-9/10"], rho="9/10"), example(n=1, a=["-9/10"], g=["93/100"], rho="99/100")],
      note="Simply connected because contractible: (rho^i a_i, rho^i g_i) stays positive real for 0 < rho <= 1 and tends to the origin, which is "
           "positive real; that this homotopy stays in the region is what is tested. Bounds: coefficients of Schur polynomials.")

# ---------------------------------------------------------------------- n = 1
ag = {a: scalar(), g: scalar()}
p1, pos1, kq, dia = symbols("Phi_plus N_1 R size")
PHI1 = let(p1, rational("1/2") + g / (Z + a))
claim("BLM91-S26", "the Popov condition for n = 1",
      (p1 + recip(p1)) * (Z + a) * recip(Z + a) == 1 + a**2 + 2 * a * g + (a + g) * (Z + recip(Z)), over=ag, where=[PHI1],
      by=[identity(), instances()], note="z + 1/z is 2 cos(theta) on the circle.")
claim("BLM91-E2.32a", "positivity in closed form",
      iff(pos_on_circle(pos1), (1 - abs(a + g)) ** 2 > g**2), over=ag, where=[let(pos1, 1 + a**2 + 2 * a * g + (a + g) * (Z + recip(Z)))],
      by=[arithmetic(), instances(60), example(a=0, g="1/2"), example(a=0, g="-1/2"), example(a=3, g=1), example(a=-2, g=0), example(a=0, g=1), example(a=1, g=-1)],
      note="For all real a and g, stable or not.")
claim("BLM91-E2.32b", "the stability condition for n = 1", iff(schur(F), abs(a) < 1), over={a: scalar()}, where=[let(F, rows([[-a]]))],
      by=[arithmetic(), instances(), example(a=1), example(a=-1), example(a="99/100")], note="F is the 1x1 matrix -a.")
claim("BLM91-E2.33", "the new coordinates are those of the algorithm at t = 0",
      (q[0][1] == al0) & (qs[0][1] == ga0) & (al0 - ga0 == a[1]), over={a: vector(1), g: vector(1)},
      where=[let(n, 1), *stripped(g + a, g), let(al0, a[1] + g[1]), let(ga0, g[1])], by=[identity(), instances()],
      note="The display defines alpha = a + g, gamma = g; checked is that they are q_0 and q*_0 for n = 1.")
claim("BLM91-F1", "the positive real region is the diamond",
      iff(((1 - abs(al0)) ** 2 > ga0**2) & schur(az), abs(al0) + abs(ga0) < 1), over={al0: scalar(), ga0: scalar()},
      where=[let(a, al0 - ga0), let(az, Z + a)],
      by=[arithmetic(*(by_cases(e_ > 0) for e_ in (1 - al0 + ga0, 1 - al0 - ga0, 1 + al0 + ga0, 1 + al0 - ga0))), instances(60), example(alpha0="1/2", gamma0="1/2"), example(alpha0=2, gamma0=0), example(alpha0=-2, gamma0="1/2"), example(alpha0=0, gamma0=1)])
claim("BLM91-E2.34", "the fast algorithm for n = 1", always(t, (al[t] == q[t][1]) & (ga1[t] == qs[t][1])),
      over={a: vector(1), g: vector(1)}, where=[let(n, 1), *stripped(g + a, g), *scalar_orbit(a[1] + g[1], g[1], ga1)], by=[induction(), instances()])

#: p^(2t)
SQUARED = rec(kq, t, 1, pp**2 * kq[t])
LIMIT = [given("diamond", abs(al0) + abs(ga0) < 1), given("limit", pp * (1 + al0**2 - ga0**2) == (1 + pp**2) * al0), standing("smaller root", abs(pp) < 1)]
#: the point at j is there and in the diamond; that at i is on the hyperbola; alpha_k is between 0 and p; gamma falls by the factor |p| at each step
WITHIN = [by_cases(1 + al[k] ** 2 - ga[k] ** 2 > 0), by_cases(pp**2 >= 0), by_cases(pp * al[k] >= 0), square_of(ga[k]), by_cases(ga[k] ** 2 >= 0), by_cases(pp * al[k] < 1), multiplied(pp), multiplied(al[k])]
FALLS = (by_induction(j, 0, defined(al[j]) & defined(ga[j]) & (al[j] + ga[j] < 1) & (al[j] - ga[j] < 1) & (ga[j] - al[j] < 1) & (-al[j] - ga[j] < 1), base=values_at(0),
                      step=[cleared(), by_cases(ga[j] < 1), by_cases(-ga[j] < 1), *values_at(j + 1)]),
         by_induction(i, 0, pp * (1 + al[i] ** 2 - ga[i] ** 2) == (1 + pp**2) * al[i], base=values_at(0), step=[at_index(j, i), cleared(), *values_at(i + 1), multiplied(ga[i] ** 2)]),
         shown_first(forall(k, 0, m, al[k] ** 2 <= pp * al[k]), [at_index(j, k), at_index(i, k), *WITHIN]),
         shown_first(forall(s, 0, m, ga[s + 1] == -(ga[s] * al[s + 1])), [at_index(j, s), cleared(), *values_at(s + 1)]),
         by_induction(t, 0, (t <= m) >> (ga[t] ** 2 <= kq[t] * ga0**2), base=[*values_at(0), unfolded(kq, 0)],
                      step=[at_index(s, t), at_index(k, t + 1), unfolded(kq, t + 1), by_cases(pp**2 >= 0), by_cases(al[t + 1] ** 2 <= pp**2), square_of(ga[t]), by_cases(ga[t] ** 2 >= 0),
                            by_cases(ga[t] ** 2 * al[t + 1] ** 2 <= pp**2 * ga[t] ** 2)]))
claim("BLM91-S27", "the diamond is invariant, and orbits in it converge",
      always(m, defined(al[m]) & defined(ga[m]) & (dia(m) < 1) & (ga[m] ** 2 <= kq[m] * ga0**2) & (abs(al[m] - pp) * (1 - pp**2) <= abs(pp) * ga[m] ** 2)),
      over={al0: scalar(), ga0: scalar(), pp: scalar()}, where=[*ORBIT, SQUARED, function(dia, [t], abs(al[t]) + abs(ga[t]))], given=LIMIT,
      by=[arithmetic(*FALLS, *(at_index(i_, m) for i_ in (j, i, k, t)), by_cases(al[m] == pp), by_cases(pp * al[m] <= pp**2)),
          instances(40, **INSIDE), example(alpha0=0, gamma0="1/2", p=0), example(alpha0="1/2", gamma0=0, p="1/2"), example(alpha0=2, gamma0=0, p="1/2")],
      note="p = alpha_infinity is the root of p(1 + alpha_0^2 - gamma_0^2) = (1 + p^2) alpha_0 with |p| < 1. R_t is p^(2t): gamma_t tends to 0 as |p|^t, and with it alpha_t to p. m is the time t.")
kf, kfs = symbols("K K_star")
#: gain and second gain are those of the fast algorithm
GAINS = by_induction(s, 0, defined(kf[s]) & defined(kfs[s]) & (kf[s] == al[s] - al0 + ga0) & (kfs[s] == ga[s]), base=[*values_at(0, kf, kfs, al, ga)],
                     step=[cleared(), at_index(j, s), at_index(j, s + 1), *values_at(s + 1, kf, kfs, al, ga)])
claim("BLM91-E2.35", "the steady-state filter for n = 1",
      always(m, (kf[m] == al[m] - a) & (kfs[m] == ga[m]) & (-a - kf[m] == -al[m]) & (abs(kf[m] - (pp - a)) * (1 - pp**2) <= abs(pp) * kq[m] * ga0**2)),
      over={al0: scalar(), ga0: scalar(), pp: scalar()},
      where=[*ORBIT, SQUARED, let(a, al0 - ga0), rec(kf, t, ga0, (kf[t] + kfs[t] * a * kfs[t]) / (1 - kfs[t] ** 2)),
             rec(kfs, t, ga0, (-a * kfs[t] - kfs[t] * kf[t]) / (1 - kfs[t] ** 2))], given=LIMIT,
      by=[arithmetic(*FALLS, GAINS, *(at_index(i_, m) for i_ in (j, i, k, t, s)), by_cases(al[m] == pp), by_cases(pp * al[m] <= pp**2)), instances(40, **INSIDE), example(alpha0=0, gamma0="1/2", p=0), example(alpha0="1/2", gamma0=0, p="1/2"), example(alpha0=2, gamma0=0, p="1/2")],
      note="The filter at time t has the coefficients F - k_t = -alpha_t and k_t = alpha_t - a, with (1.9) for F = -a, h = 1. The steady-state filter is its limit, with gain p - a and coefficient -p: "
           "R_t is p^(2t), and p = alpha_infinity as in the claim before. m is the time t.")
