# SPDX-License-Identifier: MIT
"""Section IV, (4.1)-(4.13), Theorem 4.1, Corollary 4.2: the Riccati equation for n = 1.

The increment of the Riccati equation from Pi_0 = 0 keeps rank one: Lambda(Pi_t) = r_t q*_t q*_t'. For n = 1, F = -a, h = 1, g = gamma_0, the step is

    pi' = ((alpha_0^2 - gamma_0^2) pi + gamma_0^2)/(1 - pi),    pi' - pi = phi(pi)/(1 - pi),

phi(pi) = pi^2 - 2(1 - alpha_0/kappa) pi + gamma_0^2, and alpha = alpha_0/(1 - pi) makes it the slope map alpha' = 1/(2/kappa - alpha). So all is known from
there: fixed points p_+- = 1 - alpha_0/alpha_+-, convergence for |kappa| <= 1, period d when theta = pi n/d, density otherwise.

The attracting fixed point is 1 - alpha_0/alpha_+. The two fixed points differ by alpha_0(1/alpha_+ - 1/alpha_-), which has the sign of alpha_0 kappa, that
is of 1 + alpha_0^2 - gamma_0^2: the limit is the smaller zero of phi in I, III and IV, and the larger one in II.

For alpha_0 = 0 the step is constant, gamma_0^2, except at pi = 1. With |gamma_0| = 1 every solution then ends at the second step. At pi_0 = 1 every equation ends.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import (
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
    order,
    part,
    steps,
    valued,
)
from exactkf.language import *
from proofs.blm91.consequences_angles import ANGLE, LOWEST
from proofs.blm91.lemmas_turns import OF_SOLUTIONS, SINES_1, SINES_D, w
from proofs.blm91.notation import *

p, y, Pi, Lam, Pm, f, pit, phi_, ended, back, many, gcd, d, nn, whole, near, inside = symbols(
    "p y Pi Lambda P f pi_t phi ends back divides gcd d n_angle special near inside")
SYSTEM = {F: matrix(n, n), h: vector(n), g: vector(n)}


def step(P):
    """Right side of (1.4)."""
    return F * P * T(F) + (g - F * P * h) * inv(1 - T(h) * P * h) * T(g - F * P * h)


LAMBDA_OF = function(Lam, [Pm], F * Pm * T(F) - Pm + (g - F * Pm * h) * inv(1 - T(h) * Pm * h) * T(g - F * Pm * h))
claim("BLM91-E4.1", "the increment of the Riccati equation", forall(t, 0, m, Pi[t + 1] - Pi[t] == Lam(Pi[t])), sizes=["n", "m"], over=SYSTEM, where=[rec(Pi, t, Zero(n, n), step(Pi[t])), LAMBDA_OF],
      by=[induction(), instances(n=(1, 2, 3), m=(0, 1, 2))])
claim("BLM91-E4.2", "Lambda is the step minus the identity", Lam(P) == step(P) - P, sizes=["n"], over={**SYSTEM, P: symmetric_matrix(n)}, where=[LAMBDA_OF], by=[identity(n=(1, 2, 3)), instances(n=(1, 2, 3))],
      note="The display defines Lambda; checked is that it is the increment of (1.4) at any symmetric matrix.")
first = sym("first")
claim("BLM91-S42", "the first increment", (Lam(Zero(n, n)) == g * T(g)) & psd(first) & (rank(first) <= 1), sizes=["n"], over=SYSTEM, where=[LAMBDA_OF, let(first, g * T(g))],
      by=[order([], [], [g, T(g)]), instances(n=(1, 2, 3))])
_SHIFT, _UNIT = matrix_of(i, j, n, n, when(j == i + 1, 1, 0)), matrix_of(i, j, n, 1, when(i == 1, 1, 0))
_GAMMA = T(h) * qs[t]
claim("BLM91-E4.3", "increments of rank one", forall(t, 0, m, Lam(Pi[t]) == r[t] * qs[t] * T(qs[t])), sizes=["n", "m"],
      over={J: matrix(n, n), F: matrix(n, n), h: vector(n), a: vector(n), g: vector(n)},
      where=[rec(Pi, t, Zero(n, n), step(Pi[t])), LAMBDA_OF, rec(q, t, g + a, 1 / (1 - _GAMMA**2) * (q[t] - _GAMMA * (J * qs[t]))),
             rec(qs, t, g, 1 / (1 - _GAMMA**2) * (J * qs[t] - _GAMMA * q[t])), rec(r, t, Identity(1), (1 - _GAMMA**2) * r[t])],
      given=[standing("(2.22)", (J == _SHIFT) & (h == _UNIT) & (F == J - a * T(h)))],
      by=[induction(also=[symmetric(Pi[t]), r[t] == 1 - T(h) * Pi[t] * h, r[t] * (q[t] - a) == g - F * Pi[t] * h]),
          instances(n=(1, 2, 3), m=(0, 1, 2, 3), made_by={J: _SHIFT, h: _UNIT, F: _SHIFT - a * T(_UNIT)})],
      note="gamma_t is h'q*_t, the first entry of q*_t. Of J and h nothing is used, so that it is for every n.")

# ---------------------------------------------------------------------- n = 1
claim("BLM91-E4.4", "the scalar system is stationary with E y^2 = 1",
      forall(t, 0, m, (covariance(state(t), state(t)) == P) & (covariance(state(t + 1), output(t)) == g) & (covariance(output(t), output(t)) == 1)), sizes=["n", "m"], over={**SYSTEM, P: symmetric_matrix(n)},
      where=STATE, given=[standing("(4.4)", (n == 1) & (h == _UNIT))], by=[generic_index(*WRITTEN_OUT), instances(n=1, m=(1, 2), made_by={h: _UNIT})],
      note="F is -a, h is 1; the noise covariances are those of Section II, P the covariance of the state.")
SCALAR = {a: scalar(), ga0: scalar()}
PI = rec(pit, t, 0, a**2 * pit[t] + (ga0 + a * pit[t]) ** 2 / (1 - pit[t]))
claim("BLM91-E4.5", "the scalar filter is (1.2) with F = -a, h = 1",
      always(t, (Pi[t] == rows([[pit[t]]])) & (F - (g - F * Pi[t] * h) * inv(1 - T(h) * Pi[t] * h) * T(h) == rows([[-a - (ga0 + a * pit[t]) / (1 - pit[t])]]))), over=SCALAR,
      where=[let(F, rows([[-a]])), let(h, Identity(1)), let(g, rows([[ga0]])), rec(Pi, t, Zero(1, 1), step(Pi[t])), PI], by=[induction(), instances()],
      note="The coefficient of the state in (4.5) is F - k_t h' with the gain of (1.3).")
FILTER1 = [let(F, rows([[-a]])), let(h, Identity(1)), let(g, rows([[ga0]])), rec(Pi, t, Zero(1, 1), step(Pi[t])), PI]
claim("BLM91-E4.6", "the scalar gain", always(t, (Pi[t] == rows([[pit[t]]])) & ((g - F * Pi[t] * h) * inv(1 - T(h) * Pi[t] * h) == rows([[(ga0 + a * pit[t]) / (1 - pit[t])]]))), over=SCALAR, where=FILTER1,
      by=[induction(), instances()], note="(1.3) for F = -a, h = 1, g = gamma_0.")
claim("BLM91-E4.7", "the scalar Riccati equation", always(t, Pi[t][1, 1] == pit[t]), over=SCALAR, where=FILTER1, by=[induction(also=[Pi[t] == rows([[pit[t]]])]), instances()], note="(1.4) for F = -a, h = 1, g = gamma_0.")
claim("BLM91-E4.8", "alpha_0 is the first coordinate of (2.33)", (q[0][1] == al0) & (al0 - ga0 == a[1]) & (qs[0][1] == ga0), over={a: vector(1), g: vector(1)},
      where=[let(n, 1), *stripped(g + a, g), let(ga0, g[1]), let(al0, a[1] + ga0)], by=[identity(), instances()], note="The display defines alpha_0; checked is that it is q_0 of the algorithm.")
#: noise covariance of (4.4) for the state variance pi_0 that makes its determinant -phi(pi_0) largest
okay, noise = symbols("exists noise")
SYSTEM_1 = (let(al0, a + ga0), let(x, (1 - al0**2 + ga0**2) / 2), let(noise, rows([[(1 - a**2) * x, ga0 + a * x], [ga0 + a * x, 1 - x]])), let(okay, (x >= 0) & psd(noise)))
CORRELATED = {a: scalar(), ga0: nonzero()}
DIAMOND_A = [instances(40, using={u: nonzero(), y: scalar()}, made_by={ga0: u / (1 + abs(u) + abs(y)), a: y / (1 + abs(u) + abs(y)) - ga0}),
             instances(30, using={u: nonzero(), s1: nonzero()}, made_by={ga0: SHARE, a: SIGN * (1 - abs(ga0)) - ga0}), instances(40)]
EDGES = [example(a=0, gamma0="1/2"), example(a=3, gamma0=1), example(a="1/2", gamma0="-1/2"), example(a="3/2", gamma0=-1), example(a=-1, gamma0=1), example(a=1, gamma0=1), example(a=-4, gamma0=2), example(a=-2, gamma0=2), example(a="1/4", gamma0="-9/8")]
claim("BLM91-S43", "the parameters of stochastic systems", iff(okay, abs(al0) + abs(ga0) < 1), over=CORRELATED, where=SYSTEM_1, by=[EDGES[0], instances(40)],
      repair=repair("boundary case", "the edges of the diamond come from systems too: y_t = (e_t + e_(t-1))/sqrt 2 has a = 0, gamma_0 = 1/2; systems fill the closed diamond, and the open one adds strictness in the Popov condition",
                    iff(okay, abs(al0) + abs(ga0) <= 1), over=CORRELATED, where=SYSTEM_1,
                    by=[steps("BLM91-E4.12", facts=["a symmetric 2x2 matrix is semidefinite when its determinant and its trace are not negative", "a quadratic polynomial takes its least value at its vertex"],
                              prose="the determinant is -phi(pi_0), at the vertex ((1 - |alpha|)^2 - gamma^2)((1 + |alpha|)^2 - gamma^2)/4: negative in the corridors; elsewhere pi_0 and 1 - pi_0 are both nonnegative, "
                                    "with |a| <= 1, in the closed diamond alone"), *DIAMOND_A, *EDGES]),
      note="A system (4.4) is a state variance pi_0 >= 0 with semidefinite noise covariance; exists: so for pi_0 = (1 - alpha_0^2 + gamma_0^2)/2, and if not for this value, where the determinant is largest, then for none "
           "(for |a| > 1 the variance is 0 and gamma_0 with it; beyond the pole, in II, both zeros of phi are at least 1). gamma_0 not 0: with gamma_0 = 0 the output is white and the state not needed. "
           "Were stochastic system to mean |a| < 1 and the Popov condition (2.4), the statement would be that of Fig. 1, which holds; see S13.")
MAP = (let(a, al0 - ga0), rec(pit, t, x, a**2 * pit[t] + (ga0 + a * pit[t]) ** 2 / (1 - pit[t])))
KAPPA = let(kap, 2 * al0 / (1 + al0**2 - ga0**2))
PHI = function(phi_, [y], y**2 - 2 * (1 - al0 / kap) * y + ga0**2)
ROOT = given("p on the hyperbola", p * (1 + al0**2 - ga0**2) == (1 + p**2) * al0)
#: |p| < 1 and a point of its hyperbola, in any region
LINE = {al0: (p * y**2 - 1 / p) / (y**2 - 1), ga0: y * (p - 1 / p) / (y**2 - 1)}
#: (pi_t - c)(q pi_0 - ..): the quotient of distances to the fixed points 1 - alpha_0/p, 1 - alpha_0 p
LOW_, HIGH_ = 1 - al0 / p, 1 - al0 * p
RATE = (pit[m] - LOW_) * (x - HIGH_) == p ** (2 * m) * (x - LOW_) * (pit[m] - HIGH_)

zlow = sym("zeros")
ZERO_AT = (let(zlow, (phi_(LOW_) == 0) & (phi_(HIGH_) == 0)), let(near, LOW_ <= HIGH_))
claim("BLM91-S44", "convergence to the minimum solution in the diamond", RATE & near & zlow, sizes=["m"], over={al0: nonzero(), ga0: scalar(), p: nonzero()},
      where=[let(x, 0), *MAP, KAPPA, PHI, *ZERO_AT], given=[ROOT, standing("diamond", abs(al0) + abs(ga0) < 1), given("smaller root", abs(p) < 1)],
      by=[steps("BLM91-E5.4", "BLM91-E5.1", prose="the quotient of the distances to the two fixed points has the factor p^2 at each step; in the diamond p alpha_0 > 0, so that 1 - alpha_0/p is the smaller one"), instances(40, m=(1, 2, 3), **INSIDE),
          example(m=1, alpha0="2/5", gamma0="2/5", p=2)],
      note="p_+ = 1 - alpha_0/p with p = alpha_+; pi_m - p_+ is p^(2m) times a bounded factor. For alpha_0 = 0 the limit gamma_0^2 is reached in one step. m is the time.")
E_ = al0 * (1 + al[t] ** 2 - ga[t] ** 2) / al[t] == 1 + al0**2 - ga0**2
PI0 = (let(a, al0 - ga0), rec(pit, t, 0, a**2 * pit[t] + (ga0 + a * pit[t]) ** 2 / (1 - pit[t])), *ORBIT)
ROW = [(al0 * al[t] / (1 - pit[t]), 0, 1), (1, 1, 1)]
POINT = {al0: nonzero(), ga0: scalar()}
claim("BLM91-E4.9", "the solution of the Riccati equation by the fast algorithm", always(t, pit[t] == (al[t] - al0) / al[t]), over=POINT, where=PI0, by=[induction(also=[E_], cofactors=[ROW, [(1, 1, 1)]]), instances()])
SCALE_ = al[t + 1] / (1 - pit[t + 1])
claim("BLM91-E4.10", "the filter by the fast algorithm", always(t, ((ga0 + a * pit[t]) / (1 - pit[t]) == al[t] - al0 + ga0) & (-a - (ga0 + a * pit[t]) / (1 - pit[t]) == -al[t])), over=POINT, where=PI0,
      by=[induction(also=[pit[t] == (al[t] - al0) / al[t], E_],
                    cofactors=[[(SCALE_ * al0 * al[t] / (1 - pit[t]), 2, 1), (SCALE_, 3, 1)], [(-SCALE_ * al0 * al[t] / (1 - pit[t]), 2, 1), (-SCALE_, 3, 1)], [(al0 * al[t] / (1 - pit[t]), 2, 1), (1, 3, 1)], [(1, 3, 1)]]), instances()],
      note="The gain (4.6) and the coefficient -a - k_t of the estimate.")
D0, small_, strict, hitsN = symbols("D smaller definite hits")
claim("BLM91-S45", "|kappa| < 1 is the sign definite region", iff(small_, strict) & (kap * (1 + al0**2 - ga0**2) == 2 * al0), over={al0: scalar(), ga0: scalar()},
      where=[KAPPA, let(D0, 1 + al0**2 - ga0**2 + al0 * (Z + recip(Z))), let(small_, abs(kap) < 1), let(strict, pos_on_circle(D0) | pos_on_circle(-D0))],
      by=[arithmetic(valued(), cleared()), instances(60),
          example(alpha0="1/2", gamma0="1/2"), example(alpha0=3, gamma0=2), example(alpha0=0, gamma0="1/2"), example(alpha0=1, gamma0=3)],
      note="The regions without their boundary lines, which are |kappa| = 1.")
ENTER = (*ORBIT, LAMBDA, let(hitsN, sum_of(t, 0, 40, when(abs(al[t]) + abs(ga[t]) < 1, 1, 0))), let(inside, abs(al[41]) + abs(ga[41]) < 1))
SHADED = [standing("|kappa| < 1", lam**2 > rational("21/20")), standing("no escape", defined(al[42]))]
APART = example(alpha0=2, gamma0=0)
claim("BLM91-S46", "data of the shaded region come to the diamond and stay", (hitsN >= 1) & inside, over=POINT, where=ENTER, given=SHADED, by=[APART, instances(12, **IN_II)],
      repair=repair("boundary case", "(alpha, 0) with |alpha| > 1 is at rest: it does not escape and stays outside the diamond; the unstable equilibria are to be excluded with the points that escape", (hitsN >= 1) & inside, over=POINT, where=ENTER,
                    given=[*SHADED, given("not an unstable equilibrium", (ga0 != 0) | (abs(al0) < 1))],
                    by=[steps("BLM91-E5.1", "BLM91-X.1", prose="alpha_t tends to alpha_+ and gamma_t to 0 by T3.5.a.alt, and (alpha_+, 0) is inside the diamond, which is invariant by S27"),
                        instances(10, **IN_II), instances(8, **IN_III), instances(8, **IN_IV), instances(6, **IN_I), APART, example(alpha0="1/2", gamma0=0), example(alpha0=-3, gamma0=0)]),
      note="The text excludes the points that escape and no others; Theorem 3.5, to which it refers, and Theorem 4.1 name the unstable equilibrium as an exception. "
           "Tried within 40 steps for |kappa| bounded away from 1, inside: still there at step 41. For alpha_0 = 0 the origin is reached in one step.")
claim("BLM91-S47", "no convergence in the corridors", (ga[m] ** 2 == (al[m] - lam) ** 2 + (1 - lam**2)) & (1 > lam**2), sizes=["m"], over=POINT, where=[*ORBIT, LAMBDA], given=[given("corridor", (1 + al0**2 - ga0**2) ** 2 < 4 * al0**2)],
      by=[arithmetic(valued(), cleared(), STAYS, at_index(i, m)), instances(30, m=(0, 1, 2, 3), using={u: scalar(), y: scalar()}, made_by={al0: 2 * (SHARE + y) / (1 - y**2), ga0: 1 + y * al0})],
      note="m is the time.")
fx = sym("f_x")
STEP_X = (KAPPA, PHI, let(fx, (al0 - ga0) ** 2 * x + (ga0 + (al0 - ga0) * x) ** 2 / (1 - x)))
claim("BLM91-E4.11", "the increment by phi", fx - x == phi_(x) / (1 - x), over={**POINT, x: scalar()}, where=STEP_X, by=[identity(), instances()])
claim("BLM91-E4.12", "phi without kappa", phi_(x) == x**2 - (1 - al0**2 + ga0**2) * x + ga0**2, over={**POINT, x: scalar()}, where=STEP_X, by=[identity(), instances()],
      note="The display defines phi; checked is the form that has a meaning for alpha_0 = 0 too.")
NORM = 1 + al0**2 - ga0**2
claim("BLM91-E4.13", "kappa from the point", kap == 2 * al0 / NORM, over={al0: scalar(), ga0: scalar(), kap: nonzero()}, given=[given("on the hyperbola", NORM == 2 / kap * al0)],
      by=[combination([(kap / NORM, "on the hyperbola", 1)]), instances(made_by={kap: 2 * al0 / NORM})])

# ---------------------------------------------------------------------- Theorem 4.1
UM = sym("U_before")


def PHI_X(y):
    """(4.12) without kappa."""
    return y**2 - (1 - al0**2 + ga0**2) * y + ga0**2


ENDING = (*MAP, KAPPA, PHI, LAMBDA, CHEBYSHEV, function(UM, [t], when(t == 0, 0, Ut[t - 1])), let(ended, leaves(m, pit)))
EDGE_X = {x: 1 - al0 * UM(m - 1) / Ut[m - 1]}
A_STEP = standing("a step", m >= 1)
KNOTE = "alpha_0 not 0; x is pi_0. The solution ends at step m: pi_(m-1) exists and is 1."
claim("BLM91-T4.1.0a", "only pi_0 with phi(pi_0) >= 0 ends", ended >> (PHI_X(x) >= 0), sizes=["m"], over={**POINT, x: scalar()}, where=ENDING, given=[A_STEP],
      by=[arithmetic(valued(), cleared(), by_induction(
          j, 0, (defined(pit[j]) & (PHI_X(x) < 0)) >> (PHI_X(pit[j]) < 0), base=[cleared(), *values_at(0, pit)],
          step=[cleared(), by_cases(al0**2 > 0), *values_at(j + 1, pit)]), at_index(j, m - 1), existing(pit, m), by_cases(al0**2 > 0)),
          instances(40, m=(1, 2, 3), made_by=EDGE_X), instances(30, m=(1, 2)), example(m=1, alpha0="1/2", gamma0=0, x="1/2")],
      note=KNOTE + " phi in the form that has a value for kappa infinite too.")
claim("BLM91-T4.1.0b", "one value of pi_0 ends at each step", iff(ended, x == 1 - al0 * UM(m - 1) / Ut[m - 1]), sizes=["m"], over={**POINT, x: scalar()},
      where=ENDING, given=[A_STEP, standing("no earlier one is infinite", forall(j, 0, m - 1, Ut[j] != 0))],
      by=[steps("BLM91-E5.4", "BLM91-E5.1'", facts=["a countable set has measure zero"], prose="1 - alpha_0/alpha is the pole 1 for infinite alpha; an invertible map has one preimage of the pole at each step"),
          instances(40, m=(1, 2, 3, 4), made_by=EDGE_X), instances(30, m=(1, 2)), instances(20, m=(2, 3), made_by={x: 1})],
      note=KNOTE + " For alpha_0 = 0, |gamma_0| = 1, where kappa is not defined, every solution ends.")
RICCATI = (*MAP, KAPPA, PHI)
GAP = ((al0 / (1 - pit[m]) - lam) ** 2 + (1 - lam**2)) * (1 - pit[m])
first, small, rests, least, goal = symbols("first small comes_to_rest least goal")
#: least step for |kappa| > 1; does a step become small: at most 1/50, or half of the least
RESTS = (*RICCATI, LAMBDA, let(whole, phi_(1 - al0 / kap) <= 0), let(least, 2 * abs(al0) * (1 - abs(lam))), let(small, when(least > 0, least / 2, rational("1/50"))),
         function(first, [t], when(abs(pit[t + 1] - pit[t]) <= small, t, when(t >= 80, -1, first(t + 1)))), let(rests, first(0) >= 0))
claim("BLM91-T4.1.1a", "convergence exactly for |kappa| <= 1", iff(rests, kap**2 <= 1) & iff(whole, kap**2 <= 1) & (pit[m + 1] - pit[m] == GAP) & (abs(pit[m + 1] - pit[m]) >= least), sizes=["m"], over={**POINT, x: scalar()}, where=RESTS,
      by=[steps("BLM91-E4.11", "BLM91-E5.4", "BLM91-E5.1", "BLM91-X.2", facts=["a quadratic polynomial takes its least value at its vertex", "|x + 1/x| is at least 2"],
                prose="for |kappa| > 1, 1/kappa = lambda, each step is |alpha_0||alpha + 1/alpha - 2 lambda| with alpha = alpha_0/(1 - pi), hence at least 2|alpha_0|(1 - |lambda|): no convergence. "
                      "For |kappa| <= 1 phi has real zeros, and every solution that does not end converges to one of them (T4.1.1c)"),
          instances(60, m=(0, 1, 2)), example(m=1, alpha0="1/2", gamma0="1/2", x=0), example(m=1, alpha0=2, gamma0=2, x=0), example(m=0, alpha0=2, gamma0=2, x=-1)],
      note="alpha_0 not 0; for alpha_0 = 0, |gamma_0| not 1 the solution is gamma_0^2 after one step. special: phi has real zeros. comes to rest: for |kappa| > 1 a step falls below half of the least one, otherwise below 1/50, tried for t <= 80. m is the time.")
FIXED = (KAPPA, PHI, function(f, [y], (al0 - ga0) ** 2 * y + (ga0 + (al0 - ga0) * y) ** 2 / (1 - y)))
claim("BLM91-T4.1.1b", "the zeros of phi are fixed points", (f(LOW_) == LOW_) & (f(HIGH_) == HIGH_) & ((Z - LOW_) * (Z - HIGH_) == Z**2 - 2 * (1 - al0 / kap) * Z + ga0**2), over={**POINT, p: nonzero()}, where=FIXED, given=[ROOT],
      by=[arithmetic(valued(), valued("p on the hyperbola"), cleared(), *map(multiplied, (al0, ga0, ga0**2)), member=0), *(arithmetic(valued(), cleared(), member=k_) for k_ in (1, 2)), instances(40, using={y: scalar()}, made_by=LINE)],
      note="p is a root of p^2 - (2/kappa) p + 1, real for |kappa| <= 1. For alpha_0 = 0, where kappa = 0 and (4.12) has no meaning, (1 - alpha_0/kappa) read as (1 + gamma_0^2)/2 makes 1 a zero, which is the pole of the map.")
upto = sym("inside_or_double")
LIMIT = dict(sizes=["m"], over={**POINT, x: scalar(), p: nonzero()}, where=[*RICCATI, *ZERO_AT, let(inside, 1 + al0**2 > ga0**2)], given=[ROOT, standing("|kappa| <= 1", abs(p) <= 1)])
DRAW_PI = dict(using={u: nonzero(), y: scalar()}, made_by={p: SHARE, x: (y - u) / 2, **LINE})
claim("BLM91-T4.1.1c", "the limit is the smaller zero of phi", RATE & near, **LIMIT, by=[example(m=1, alpha0="-7/10", gamma0="-9/5", p="1/2", x=0), instances(m=(1, 2), **DRAW_PI)],
      repair=repair("missing hypothesis", "the limit 1 - alpha_0/alpha_+ is the smaller zero only for 1 + alpha_0^2 > gamma_0^2 (regions I, III, IV); for parameters in region II it is the larger one",
                    RATE & iff(near, upto), sizes=["m"], over=LIMIT["over"], where=[*LIMIT["where"], let(upto, inside | (p**2 == 1))], given=LIMIT["given"],
                    by=[steps("BLM91-E5.4", "BLM91-E5.1", prose="the quotient of the distances has the factor p^2 at each step (for |p| = 1 use that 1/(alpha - p) moves by a constant); the zeros differ by alpha_0(1/p - p), which has the sign of alpha_0 kappa"),
                        instances(40, m=(1, 2, 3), **DRAW_PI), example(m=1, alpha0="-7/10", gamma0="-9/5", p="1/2", x=0), example(m=1, alpha0="1/2", gamma0="1/2", p=1, x=0), example(m=1, alpha0=-1, gamma0=2, p=1, x=0)]),
      note="p = alpha_+, near: 1 - alpha_0/p <= 1 - alpha_0 p. pi_m - (1 - alpha_0/p) is p^(2m) times a bounded factor; m is the time. (-7/10, -9/5) is in II, kappa = 4/5.")
#: a point of the hyperbola of a fraction, and the values of the Riccati equation from x
ON_FRACTION = (AS_FRACTION, let(al0, ALPHA_OF), let(ga0, GAMMA_OF), *MAP)
ANY_FRACTION = {top: integer(-13, 13), low: integer(1, 12), u: scalar(), x: scalar()}
BACK = (*ON_FRACTION, MANY, function(back, [t], (4 * lam**2 == 1) & many(3, t) | (lam == 0) & many(2, t)))
REST = given("not an equilibrium", x**2 - (1 - al0**2 + ga0**2) * x + ga0**2 != 0)
claim("BLM91-T4.1.2a", "periodic exactly for rational angles", forall(t, 1, 6, iff(pit[t] == x, back(t))), over=ANY_FRACTION, where=BACK, given=[REST, standing("alpha_0 not 0", al0 != 0)],
      by=[steps("BLM91-E5.4", "BLM91-X.1", "BLM91-X.2", "BLM91-X.6", facts=["a rational zero of a monic polynomial with integer coefficients is an integer"],
                prose="alpha_t = alpha_0 says (w^t - w^(-t)) phi = 0, w + 1/w = -2/kappa; w^(2t) = 1 means that theta is a rational multiple of pi"),
          instances(40), *(example(numerator=k_, denominator=2, u=u_, x=y_) for k_ in (1, 0, -1) for u_ in (2, "1/3") for y_ in (0, 3)), example(numerator=5, denominator=4, u="-1/2", x=0)],
      note="1/kappa is any fraction with terms up to 13; among those with |kappa| > 1 the rational angles are 1/kappa = 1/2, -1/2 (period 3) and 0 (period 2): back(t). u runs through the points of the hyperbola. "
           "The equilibria of part 1), which would have period 1, are not counted as periodic. alpha_0 not 0.")
FROM_W = (let(a, al0 - ga0), rec(pit, t, w, a**2 * pit[t] + (ga0 + a * pit[t]) ** 2 / (1 - pit[t])))
#: a point of the hyperbola, on a line through (0, 1)
ON_LINE = {al0: ALPHA_OF, ga0: 1 + u * ALPHA_OF}
claim("BLM91-T4.1.2b", "the period is d", forall(t, 1, d, iff(pit[t] == w, t == d)), sizes=["n", "d"], over={al0: nonzero(), ga0: scalar(), w: scalar()}, where=[*ANGLE, *FROM_W],
      given=[*LOWEST, given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 * lam * al0), standing("the solution exists", defined(pit[d]))],
      by=[arithmetic(valued(), *SINES_D, *OF_SOLUTIONS), instances(12, n=(1, 2), d=(2, 3), using={u: scalar()}, made_by=ON_LINE),
          *(example(n=n_, d=d_, alpha0=a_, gamma0=g_, w=w_) for n_, d_, a_, g_, w_ in ((1, 2, "4/3", "5/3", 2), (1, 3, "5/3", "7/3", 3), (2, 3, 1, 2, 3), (2, 4, "4/3", "5/3", 2)))],
      note="w is pi_0, any number; 1/kappa = cos(pi n/d), which is arctan sqrt(kappa^2 - 1) = pi n/d or pi (d - n)/d with the same d; d = 2 is kappa infinite. For every n and d.")
claim("BLM91-T4.1.3", "dense exactly for irrational angles and |kappa| > 1", whole & near, over={top: integer(-10, 10), low: integer(11, 12), u: scalar(), x: scalar(), k: integer(-3, 3)},
      where=[*ON_FRACTION, function(goal, [t], abs(1 - pit[t] - k * al0) <= abs(al0)), let(near, exists(t, 1, 700, goal(t))), let(whole, forall(t, 1, 8, pit[t] != x))],
      given=[given("irrational angle", ~exists(k, -1, 1, 2 * lam == k)), standing("alpha_0 not 0", al0 != 0)],
      by=[steps("BLM91-E5.4", "BLM91-S71", "BLM91-X.6", facts=["Kronecker: multiples of an irrational part of a full turn are dense on the circle"],
                prose="the lines turn by an irrational angle in a suitable basis, so that they are dense; otherwise a solution converges (T4.1.1) or is periodic (T4.1.2), and then is not dense"),
          instances(30), example(numerator=3, denominator=12, u=2, x=0, k=-3), example(numerator=0, denominator=11, u=2, x=0, k=2), example(numerator=6, denominator=12, u=3, x=2, k=-3)],
      note="1/kappa is a fraction with |kappa| > 1, whose angle is irrational but for 0, 1/2, -1/2; u runs through the points of the hyperbola. No return within 8 steps, and pi_t comes within |alpha_0| of 1 - k alpha_0, tried for 700 steps.")
GRID = (function(pit, [i, j, t], when(t == 0, x, ((i**2 - j**2) * pit(i, j, t - 1) + j**2) / (1 - pit(i, j, t - 1)))), let(hitsN, sum_of(i, 2, 4, sum_of(j, 1, 4, when(defined(pit(i, j, 3)), 1, 0)))))
claim("BLM91-T4.1.4", "for each pi_0 few parameters escape", hitsN >= 6, over={x: scalar()}, where=GRID, by=[example(x=1), instances()],
      repair=repair("boundary case", "pi_0 = 1 is the pole of every equation, so that all parameters escape; for pi_0 not 1 the statement is right", hitsN >= 6, over={x: scalar()}, where=GRID, given=[given("not the pole", x != 1)],
                    by=[steps("BLM91-E5.4", facts=["the zero set of a polynomial that is not zero has measure zero"],
                              prose="escape at step t is a polynomial equation in (alpha_0, gamma_0), not an identity for pi_0 not 1, since (0, gamma_0) with |gamma_0| not 1 does not escape"), instances(40), example(x=1), example(x=0), example(x=-1)]),
      note="Of the twelve parameter pairs alpha_0 = 2, 3, 4, gamma_0 = 1, .., 4 the number for which pi_3 exists.")
claim("BLM91-T4.1.5", "every period d >= 2 for infinitely many parameters",
      forall(t, 1, d, iff(pit[t] == w, t == d)) & (1 + ALPHA_OF**2 - (1 + u * ALPHA_OF) ** 2 == 2 * lam * ALPHA_OF), sizes=["d"], over={al0: nonzero(), ga0: scalar(), u: scalar(), w: scalar()},
      where=[let(n, 1), let(lam, cospi(n, d)), *FROM_W],
      given=[standing("period", d >= 2), given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 * lam * al0), standing("the solution exists", defined(pit[d]))],
      by=[arithmetic(valued(), *SINES_1, *OF_SOLUTIONS, member=0), arithmetic(valued(), cleared(), member=1), instances(12, d=(2, 3), using={x: scalar()}, made_by={
          al0: 2 * (lam + x) / (1 - x**2), ga0: 1 + x * 2 * (lam + x) / (1 - x**2)}), example(d=2, u=2, alpha0="4/3", gamma0="5/3", w=2), example(d=3, u=2, alpha0="5/3", gamma0="7/3", w=3)],
      note="1/kappa = cos(pi/d) serves for every d, at every point of its hyperbola; the last equation is that there are infinitely many: the line of any slope u through (0, 1) meets it in a point. w is pi_0.")
claim("BLM91-T4.1", "Theorem 4.1", RATE & near, **LIMIT, by=[example(m=1, alpha0="-7/10", gamma0="-9/5", p="1/2", x=0), instances(m=(1, 2), **DRAW_PI)],
      repair=repair("missing hypothesis", "T4.1.1c fails: the limit is the smaller zero of phi only for 1 + alpha_0^2 > gamma_0^2; T4.1.4 fails: pi_0 = 1 is the pole of every equation; the other parts hold",
                    RATE & near, sizes=["m"], over=LIMIT["over"], where=LIMIT["where"], given=[*LIMIT["given"], given("I, III or IV", inside)],
                    by=[part("the limit for |kappa| <= 1"), steps("BLM91-E5.4", "BLM91-E5.1", prose="parts by the claims T4.1.0a to T4.1.5"), instances(40, m=(1, 2, 3), **DRAW_PI), example(m=1, alpha0="-7/10", gamma0="-9/5", p="1/2", x=0)]),
      note="The conjunction of the parts, represented by the limit.")
pd_, dd_ = symbols("p_point d_riccati")
PERIODS = (*ORBIT, MANY, let(a, al0 - ga0), rec(pit, t, x, a**2 * pit[t] + (ga0 + a * pit[t]) ** 2 / (1 - pit[t])),
           function(pd_, [k], when((al[k] == al0) & (ga[k] == ga0), k, pd_(k + 1))), let(dd_, when(exists(k, 1, 3, 2 * k == pd_(1)), pd_(1) / 2, pd_(1))))
RETURN = [standing("periodic", exists(k, 1, 6, (al[k] == al0) & (ga[k] == ga0))), given("not an equilibrium", ga0 != 0)]
claim("BLM91-C4.2", "periods of the Riccati equation", forall(t, 1, 6, iff(pit[t] == x, exists(k, 1, 6, k * dd_ == t))), over={**POINT, x: scalar()}, where=PERIODS, given=RETURN,
      by=[steps("BLM91-E5.4", "BLM91-X.1", "BLM91-X.2", prose="p is the order of w and d that of w^2, w + 1/w = -2/kappa"),
          instances(40, using={k: integer(-1, 1), u: scalar(), y: scalar()}, made_by={al0: (k + 2 * u) / (1 - u**2), ga0: 1 + u * al0, x: y}), example(alpha0="1/2", gamma0=0, x="1/3")],
      note="p_point is the period of the point, d_riccati = p or p/2; on rational data, where p is 3, 4 or 6. All p: the period of alpha is d by S87 and pi = 1 - alpha_0/alpha. Periodic points are those of Theorem 3.7, so that an "
           "equilibrium (alpha_0, 0) is not among them; other solutions of its Riccati equation converge.")
