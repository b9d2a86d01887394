# SPDX-License-Identifier: MIT
"""Section V, (5.1)-(5.3): the linear model, Theorem 3.3, and the proof of Theorem 3.5.

On the hyperbola 1 + alpha^2 - gamma^2 = (2/kappa) alpha the first equation of the
algorithm does not need gamma: alpha' = 1/(2/kappa - alpha). On lines through the origin
of the plane, slope v_2/v_1, this is the matrix A = [[2/kappa, -1], [1, 0]], of determinant
1, with characteristic polynomial s^2 - (2/kappa)s + 1.

For 0 < kappa < 1 write kappa = 2p/(1 + p^2), 0 < p < 1. The eigenvalues of A are 1/p
and p; p = alpha_+ and 1/p = alpha_- are the fixed slopes, and

    (alpha' - p)/(alpha' - 1/p) = p^2 (alpha - p)/(alpha - 1/p):

every other slope tends to p. To the right of 1/p a slope grows until it passes
infinity, comes back on the left of p and grows to p; it ends at infinity
when it is one of alpha^(i) = U_i/U_(i-1), U_0 = 1, U_1 = 2/kappa, which decrease to 1/p.
For kappa = 1, A is a Jordan block and 1/(alpha - 1) decreases by one at each step.

r_(t+1)/r_t = 1 - gamma_t^2 tells where |gamma_t| > 1: D/r_t changes sign there, and the
increment pi_(t+1) - pi_t = r_t gamma_t^2 of the Riccati equation is negative when r_t is, that is in region II.
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
    example,
    existing,
    generic_index,
    identity,
    induction,
    instances,
    lemma,
    multiplied,
    shown_first,
    steps,
    unfolded,
    valued,
)
from exactkf.language import *
from proofs.blm91.lemmas_limits import BACKWARD_P, SLOPES_ABOVE, SLOPES_END, SLOPES_FALL, power, slope
from proofs.blm91.lemmas_steady import CONVERGES, DRAWN, FACTOR, POWERS, READ, STEADY_WORDS
from proofs.blm91.lemmas_turns import U_, W_, ends_at
from proofs.blm91.notation import *

A, V, V1, V2, slow, p, y, f, bp, bm, vp, vm, Lp, Lm, Rt, be, count, sl, v, al1 = symbols("A v V_1 V_2 slow p y f beta_plus beta_minus v_plus v_minus L_plus L_minus R b count slope v_i alpha_i")
E1 = matrix_of(i, j, n, 1, when(i == 1, 1, 0))
A_KAPPA = let(A, rows([[2 / kap, -1], [1, 0]]))
#: 0 < kappa < 1 by the smaller eigenvalue p, and the slope map
BY_P = (let(kap, 2 * p / (1 + p**2)), A_KAPPA, function(f, [x], 1 / (2 / kap - x)))
BELOW_ONE = given("0 < p < 1", (p > 0) & (p < 1))
#: p in (0, 1)
DRAW_P = dict(using={u: nonzero()}, made_by={p: abs(u) / (1 + abs(u))})
ON = given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 / kap * al0)
#: the step from t = 0 exists, and is what the recursion makes of the point
FIRST_STEP = (valued(), cleared(), *(hint(x_, 1) for hint in (existing, unfolded) for x_ in (al, ga)), unfolded(al, 0), unfolded(ga, 0))

# ---------------------------------------------------------------------- Theorem 3.3
claim("BLM91-S53", "the limit of Q_t is a spectral factor",
      Qp(m) * recip(Qp(m)) - r[m] * D == Qs(m) * recip(Qs(m)), sizes=["n", "m"], over={a: vector(n), g: vector(n)}, where=[*stripped(g + a, g), *POLYNOMIALS, INVARIANT],
      by=[steps("BLM91-E2.28", prose="q*_t tends to zero, so r_t q*_t does with r_t bounded, and both sides tend to zero; r_t = D_0/(1 + |q_t|^2 - |q*_t|^2) converges with q_t"),
          instances(n=(1, 2, 3), m=(0, 1, 2, 3))],
      note="The limit has no finite test; checked is the exact difference Q_t Q_t* - r_t D = Q*_t (Q*_t)*, which tends to zero with q*_t. m is the time t.")
claim("BLM91-S54", "positive real data: q*_t tends to zero, Q_t and its limit are stable",
      CONVERGES[0] & always(t, schur(J - q[t] * T(h))), **STEADY_WORDS,
      by=[steps("BLM91-E2.28", "BLM91-E2.27", facts=["Rouche's theorem", "Schwarz's lemma", FACTOR, POWERS],
                prose="the first formula is shown for every n in T3.3.2a; |Q*_t| < |Q_t| on the circle as r_t > 0, so that Q_t has as many zeros in the disc as Q_t - Q*_t, and Q_(t+1) = Q_t - gamma_t z Q*_t as many again"),
          DRAWN, example(n=2, J=[[0, 1], [0, 0]], F=[[0, 1], [0, 0]], h=[1, 0], a=[0, 0], g=["-342/505", "18/101"], x=["-9/5", "9/10"],
                         P=[["81/101", "-162/505"], ["-162/505", "81/505"]], d="20/101")],
      note=READ + " J - q_t h' has the characteristic polynomial Q_t/r_t; the limit x(z) is a Schur polynomial. The print names [14] (Levinson) as its source; whether that source contains it is not judged.")
claim("BLM91-S55", "only first components: the scalar algorithm",
      always(t, (q[t] == al[t] * E1) & (qs[t] == ga1[t] * E1)), sizes=["n"], over={al0: scalar(), ga0: scalar()},
      where=[*stripped(al0 * E1, ga0 * E1), *scalar_orbit(al0, ga0, ga1)], given=[standing("n >= 1", n >= 1)],
      by=[generic_index(lemma(t, (q[t] == al[t] * E1) & (qs[t] == ga1[t] * E1), rule=True)), instances(n=(1, 2, 3))])

# ---------------------------------------------------------------------- kappa infinite
INFINITE = (let(al0, (y - 1 / y) / 2), let(ga0, (y + 1 / y) / 2), *ORBIT)
claim("BLM91-S56", "kappa infinite: alpha_t has period 2",
      (ga0**2 - al0**2 == 1) & (al[1] == -(al0**-1)) & (al[2] == al0), over={y: nonzero()}, where=INFINITE, by=[identity(), instances()],
      note="y = alpha_0 + gamma_0 runs over all nonzero numbers. -1/alpha is not alpha, so that the period is 2. One step from any point of the hyperbola; the next point is on it again.")
claim("BLM91-S57", "kappa infinite: the orbit has period 4",
      eq(ga[2], -al[2] * ga[1], al[2] * al[1] * ga0, -ga0) & (al[4] == al0) & (ga[4] == ga0), over={y: nonzero()}, where=INFINITE, by=[identity(), instances()],
      note="alpha_0 not 0. gamma_2 = -gamma_0 is not gamma_0, and alpha_1, alpha_3 are not alpha_0, so that 4 is the smallest.")

# ---------------------------------------------------------------------- the linear model
claim("BLM91-E5.1", "alpha_t by itself on a hyperbola", al[1] == kap / (2 - kap * al0), over={al0: scalar(), ga0: scalar(), kap: nonzero()}, where=ORBIT, given=[ON],
      by=[combination([(-kap / ((1 - ga0**2) * (2 - kap * al0)), "on the hyperbola", 1)]), instances(made_by={kap: 2 * al0 / (1 + al0**2 - ga0**2)})],
      note="One step from any point; the next point is on the same hyperbola.")
MODEL_V = (A_KAPPA, rec(V, t, rows([[1], [al0]]), A * V[t]), rec(be, t, al0, kap / (2 - kap * be[t])))
claim("BLM91-E5.1'", "the linear model on lines", always(t, (be[t] == V[t][2, 1] / V[t][1, 1]) & symplectic(A)), over={al0: scalar(), kap: nonzero()}, where=MODEL_V,
      by=[induction(cofactors=[[(kap**2 / ((2 - kap * be[t]) * (2 - kap * V[t][2, 1] / V[t][1, 1])), 0, 1)], []]), instances()])
lp, lm, up, bigger, fx, shrinks, away, changes, beyond, below, falls = symbols("lambda_plus lambda_minus up bigger f_x shrinks further changes beyond below falls")
ROOTS_ = (A_KAPPA, let(lp, (1 + sqrt(1 - kap**2)) / kap), let(lm, (1 - sqrt(1 - kap**2)) / kap))
claim("BLM91-F6", "real characteristic roots for kappa^2 < 1",
      (charpoly(A) == (Z - lp) * (Z - lm)) & (lp * lm == 1) & iff(up, bigger), over={kap: nonzero()}, where=[*ROOTS_, let(up, kap > 0), let(bigger, lp > lm)], given=[given("0 < kappa^2 < 1", kap**2 < 1)],
      by=[*(arithmetic(angles("root", 1 - kap**2), valued(), multiplied(kap), cleared(), member=k_) for k_ in (0, 1)),
          arithmetic(angles("root", 1 - kap**2), by_cases(sqrt(1 - kap**2) > 0), cleared(), member=2), instances(40, using={u: nonzero()}, made_by={kap: 2 * SHARE / (1 + SHARE**2)}), example(kappa=1)],
      note="The order of lambda_+ and lambda_- for negative kappa is the reverse of that for positive kappa: this is how 'interchanged' is read. On instances the square root is rational.")
cs, sn, tn, dm, dn, pit, flag = symbols("cos sin tan d_m d_n pi_t region")
claim("BLM91-E5.2a", "roots on the unit circle for |kappa| > 1",
      (charpoly(A) == (Z - cs) ** 2 + sn**2) & (cs**2 + sn**2 == 1) & (sn > 0) & (cs == 1 / kap), over={kap: nonzero()}, where=[A_KAPPA, let(cs, trace(A) / 2), let(sn, sqrt(1 - 1 / kap**2))],
      given=[given("|kappa| > 1", kap**2 > 1)],
      by=[*(arithmetic(angles("root", 1 - 1 / kap**2), valued(), cleared(), multiplied(kap**2), member=k_) for k_ in range(4)),
          instances(40, made_by={kap: (1 + y**2) / (2 * y)}, using={y: nonzero()}), example(kappa=1), example(kappa=-1), example(kappa="1/2")],
      note="The roots are cos + i sin and cos - i sin, on the circle and not real. cos(theta_kappa) = 1/kappa is (5.2b). On the instances the square root is rational.")
claim("BLM91-E5.2b", "the angle of the roots",
      (charpoly(A) == (Z - cs) ** 2 + sn**2) & (cs**2 + sn**2 == 1) & (tn**2 == kap**2 - 1) & (kap * tn > 0) & (sn > 0), over={y: positive()},
      where=[let(cs, (1 - y**2) / (1 + y**2)), let(sn, 2 * y / (1 + y**2)), let(kap, 1 / cs), let(tn, sn / cs), A_KAPPA],
      by=[steps(facts=["an angle in (0, pi) is determined by its cosine", "tan and arctan are inverse on (-pi/2, pi/2)"],
                prose="cos(theta) = 1/kappa with 0 < theta < pi, and y = tan(theta/2) runs over the positive numbers, 1 (kappa infinite) left out; tan(theta) is sqrt(kappa^2 - 1) for kappa > 1 and its negative for kappa < -1, "
                      "so that theta is arctan sqrt(kappa^2 - 1) in the first case and pi less than that in the second"),
          instances(60), example(y="1/2"), example(y=2), example(y="99/100")],
      note="cos, sin, tan of theta_kappa, by y = tan(theta_kappa/2) > 0: every kappa with |kappa| > 1. The roots of A are cos +- i sin.")

# ---------------------------------------------------------------------- proof of Theorem 3.5, 0 < kappa < 1
#: p^(2t) is at most one over this
SLOW = function(slow, [t], 1 + t * (1 - p**2))
#: v = beta_+ v_+ + beta_- v_-, moved by A, in both coordinates; lambda_+^t, lambda_-^t and (lambda_-/lambda_+)^t
EIGEN = (let(kap, 2 * p / (1 + p**2)), rec(V1, t, bp / p + bm * p, 2 / kap * V1[t] - V2[t]), rec(V2, t, bp + bm, V1[t]), rec(Lp, t, 1, 1 / p * Lp[t]), rec(Lm, t, 1, p * Lm[t]),
         rec(Rt, t, 1, p**2 * Rt[t]), SLOW)
BETA = {p: nonzero(), bp: scalar(), bm: scalar()}
P_NOTE = "kappa = 2p/(1 + p^2) with p = lambda_- in (0, 1) and 1/p = lambda_+."
claim("BLM91-S58", "eigenvectors of A", (A * vp == 1 / p * vp) & (A * vm == p * vm), over={p: nonzero()}, where=[*BY_P, let(vp, rows([[1 / p], [1]])), let(vm, rows([[p], [1]]))],
      by=[identity(), instances()], note=P_NOTE)
#: (5.1), kappa/(2 - kappa x) with kappa = 2p/(1 + p^2); its pole 2/kappa is p + 1/p
SLOPE_MAP = function(f, [x], p / (1 + p**2 - p * x))
POLE = p + 1 / p
#: the orbit of a slope, and the powers of a factor
SLOPES = rec(be, t, x, f(be[t]))
to_p = sym("G")


def powers(factor):
    """G_t is the factor to the power t."""
    return rec(to_p, t, 1, factor * to_p[t])


def step_of_slope(k):
    """Hints: b_(k+1) exists, and is f(b_k), where b_k is less than 2/kappa."""
    return [*values_at(k + 1, be), unfolded(to_p, k + 1)]


AT_START = [*values_at(0, be), unfolded(to_p, 0)]
ONE = 1 - p + p**2
claim("BLM91-S59", "stable and unstable fixed points",
      (f(p) == p) & (f(1 / p) == 1 / p) & always(t, (x <= 1) >> (defined(be[t]) & (abs(be[t] - p) <= to_p[t] * abs(x - p)))) & shrinks & (((1 < x) & (x < POLE)) >> away), over={p: scalar(), x: scalar()},
      where=[SLOPE_MAP, SLOPES, powers(p**2 / ONE), let(shrinks, (0 < p**2 / ONE) & (p**2 / ONE < 1)), let(away, ONE * abs(f(x) - 1 / p) >= abs(x - 1 / p))], given=[BELOW_ONE],
      by=[*(arithmetic(valued(), cleared(), member=k_) for k_ in (0, 1)),
          arithmetic(by_induction(j, 0, (x <= 1) >> (defined(be[j]) & (be[j] <= 1) & (to_p[j] >= 0) & (abs(be[j] - p) <= to_p[j] * abs(x - p))), base=AT_START,
                                  step=[by_cases(ONE > 0), by_cases(p**2 > 0), by_cases(p**2 * ONE > 0), by_cases(to_p[j] * p**2 >= 0), by_cases(p**3 > 0), by_cases(p**3 * (1 - be[j]) >= 0),
                                        by_cases(to_p[j] * abs(x - p) >= 0), cleared(), *step_of_slope(j)]), at_index(j, t), member=2),
          arithmetic(by_cases(ONE > 0), by_cases(p**2 > 0), cleared(), member=3), arithmetic(valued(), by_cases(ONE > 0), by_cases(p * (x - 1) > 0), cleared(), member=4),
          instances(60, using={u: nonzero(), y: scalar()}, made_by={p: abs(u) / (1 + abs(u)), x: y}), instances(30, using={u: nonzero(), y: positive()}, made_by={p: abs(u) / (1 + abs(u)), x: 1 / p + y / (1 + y) * p}),
          example(p="1/2", x="9/4"), example(p="1/2", x="7/4"), example(p=2, x=1), example(p=-2, x=1)],
      note=P_NOTE + " alpha_+ = p and alpha_- = 1/p are the slopes of v_+ and v_-. All slopes x <= 1, and p is one of them, tend to p at least as fast as the powers G_t of the factor p^2/(1 - p + p^2), which is less than 1; between 1 and 2/kappa, "
      "where 1/p is, the distance from 1/p grows by the factor 1/(1 - p + p^2) at least in each step.")
LINEAR = by_induction(j, 0, (V1[j] == bp * Lp[j] / p + bm * Lm[j] * p) & (V2[j] == bp * Lp[j] + bm * Lm[j]) & (Lm[j] == Lp[j] * Rt[j]) & (p * Lp[j] * Lm[j] == p) & (Rt[j] > 0),
                      base=[cleared(), *(unfolded(x_, 0) for x_ in (V1, V2, Lp, Lm, Rt))], step=[cleared(), *(unfolded(x_, j + 1) for x_ in (V1, V2, Lp, Lm, Rt)), by_cases(p**2 > 0), multiplied(p), multiplied(p + p**3)])
#: (1 + t(1 - p^2)) p^(2t) <= 1
TO_ZERO = by_induction(i, 0, (Rt[i] >= 0) & (Rt[i] * (1 + i * (1 - p**2)) <= 1), base=[unfolded(Rt, 0)], step=[unfolded(Rt, i + 1), by_cases(p**2 >= 0), by_cases(p**2 < 1), by_cases(Rt[i] * (1 - p**2) >= 0),
                                                                                                 by_cases(Rt[i] * (1 - p**2) ** 2 >= 0), by_cases(i * Rt[i] * (1 - p**2) ** 2 >= 0)])
claim("BLM91-S60", "powers of A in the eigenvectors",
      always(t, (V1[t] == bp * Lp[t] * (1 / p) + bm * Lm[t] * p) & (V2[t] == bp * Lp[t] + bm * Lm[t]) & (V1[t] == Lp[t] * (bp * (1 / p) + bm * Rt[t] * p)) & (V2[t] == Lp[t] * (bp + bm * Rt[t]))
             & (0 < Rt[t]) & (Rt[t + 1] < Rt[t]) & (Rt[t] * slow(t) <= 1)), over={p: scalar(), bp: scalar(), bm: scalar()}, where=EIGEN, given=[BELOW_ONE],
      by=[arithmetic(LINEAR, TO_ZERO, at_index(j, t), at_index(i, t), unfolded(Rt, t + 1), by_cases(p**2 < 1), cleared()), instances(40, **DRAW_P), example(p=2, beta_plus=1, beta_minus=1), example(p=-2, beta_plus=1, beta_minus=1)],
      note=P_NOTE + " (V_1, V_2)' is A^t v; v_+ = (1/p, 1)', v_- = (p, 1)'. L_+ = lambda_+^t, L_- = lambda_-^t, R = (lambda_-/lambda_+)^t = p^(2t), which tends to zero, and with it the line to the span of v_+, if beta_+ is not 0.")
#: beta_-/beta_+ (lambda_-/lambda_+)^t; v is (V_1 - p V_2) v_+ + (V_2/p - V_1) v_-, up to the factor 1/p - p
SLOPE = function(sl, [t], bm / bp * Rt[t])
claim("BLM91-S61", "the slope in the coordinates of the eigenvectors",
      always(t, (V1[t] - p * V2[t] != 0) & (V2[t] * (1 / p) - V1[t] == sl(t) * (V1[t] - p * V2[t])) & (abs(sl(t + 1)) < abs(sl(t))) & (sl(t + 1) * sl(t) > 0) & (abs(sl(t)) * slow(t) <= abs(sl(0)))),
      over={p: scalar(), bp: nonzero(), bm: nonzero()}, where=[*EIGEN, SLOPE], given=[BELOW_ONE],
      by=[arithmetic(LINEAR, TO_ZERO, at_index(j, t), at_index(i, t), unfolded(Rt, 0), unfolded(Rt, t + 1), by_cases(p**2 < 1), by_cases(p**2 > 0), by_cases(Rt[t] * (1 - p**2) > 0), by_cases(p**2 * Rt[t] > 0), by_cases(p**2 * Rt[t] ** 2 > 0), by_cases(bm**2 > 0), by_cases(Lp[t] == 0), by_cases(bp * (1 - p**2) == 0),
                     multiplied(bp + bm * Rt[t]), multiplied(Lp[t]), cleared()), instances(30, **DRAW_P), example(p=2, beta_plus=1, beta_minus=1), example(p=-2, beta_plus=1, beta_minus=1)],
      note=P_NOTE + " (V_1, V_2)' is A^t v, with the coordinates V_1 - p V_2 and V_2/p - V_1 up to a factor; R is p^(2t). Monotone to zero: of one sign, with falling modulus, by the factor p^2. For beta_- = 0 it is zero throughout.")
#: below p: growing, and nearer by the factor p^2 at least
BELOW_P = by_induction(j, 0, (x < p) >> (defined(be[j]) & (be[j] < p) & (to_p[j] >= 0) & (p - be[j] <= to_p[j] * (p - x))), base=AT_START,
                       step=[by_cases(p**2 > 0), by_cases(p * be[j] < p**2), by_cases(to_p[j] * (p - x) >= 0), by_cases(p**2 * (p - be[j]) > 0), by_cases(p**2 * to_p[j] >= 0), by_cases(p**2 * to_p[j] * (p - x) >= 0),
                             by_cases(p**2 * (p - be[j]) <= p**2 * to_p[j] * (p - x)), cleared(), *step_of_slope(j)])


def stays(k):
    """The slopes up to b_k are between 1/p and 2/kappa."""
    return forall(j, 0, k, (1 / p < be[j]) & (be[j] < POLE))


#: between 1/p and 2/kappa: away from 1/p by the factor 1/p^2 at least
AWAY = by_induction(k, 0, stays(k) >> (defined(be[k]) & (p * x > 1) & (slow(k) >= 1) & ((p * x - 1) * slow(k) <= p * be[k] - 1)), base=[at_index(j, 0), cleared(), *AT_START],
                    step=[at_index(j, j), at_index(j, k), by_cases(p**2 < 1), by_cases((1 - p**2) ** 2 >= 0), by_cases((k + 1) * (1 - p**2) ** 2 >= 0), by_cases((k + 1) * (1 - p**2) >= 0),
                          by_cases(p**2 * (p * x - 1) * slow(k + 1) <= (p * x - 1) * slow(k)), by_cases((p * x - 1) * slow(k + 1) >= 0), cleared(), *values_at(k + 1, be)])
claim("BLM91-F7", "the phase portrait of the slope",
      always(t, stays(t) >> ((be[t] < be[t + 1]) & ((p * x - 1) * slow(t) <= p**2))) & ((x > POLE) >> (f(x) < p))
      & always(t, (x < p) >> (defined(be[t]) & (be[t] < be[t + 1]) & (be[t + 1] < p) & (p - be[t] <= to_p[t] * (p - x)))), over={p: scalar(), x: scalar()},
      where=[SLOPE_MAP, SLOPES, powers(p**2), SLOW], given=[BELOW_ONE],
      by=[arithmetic(valued(), AWAY, at_index(k, t), at_index(j, j), at_index(j, t), *values_at(t + 1, be), by_cases(p**2 < 1), by_cases(be[t] > p), cleared(), member=0), arithmetic(valued(), cleared(), member=1),
          arithmetic(BELOW_P, at_index(j, t), at_index(j, t + 1), *values_at(t + 1, be), by_cases(p**2 < 1), by_cases(p * be[t] < p**2), by_cases(p * be[t] < 1), cleared(), member=2),
          instances(60, **DRAW_P), instances(30, using={u: nonzero(), y: positive()}, made_by={p: abs(u) / (1 + abs(u)), x: 1 / p + y / (1 + y) * p}),
          example(p="1/2", x="9/4"), example(p="1/2", x=3), example(p="1/2", x="1/4"), example(p="1/2", x=-1), example(p=2, x=1), example(p=-2, x="1/4")],
      note=P_NOTE + " A slope x between alpha_- = 1/p and 2/kappa = p + 1/p grows as long as it stays there, which is no longer than (p x - 1)(1 + t(1 - p^2)) <= p^2; beyond 2/kappa it jumps to the left of alpha_+ = p, "
           "and 2/kappa itself ends. Below alpha_+ it grows to alpha_+ as fast as G_t = p^(2t) at least.")
#: (5.3), 1/kappa = lambda > 1: (v_1, v_2)' = A^(-i) (0, 1)' is (U_(i-1), U_i)'
BACKWARD = (rec(U_, t, 1, 2 * lam * U_[t] - W_[t]), rec(W_, t, 0, U_[t]))
ABOVE_ONE = given("0 < kappa < 1", lam > 1)
claim("BLM91-E5.3", "the slope that ends at infinity at a given step", iff(flag, x == U_[n] / W_[n]), sizes=["n"], over={lam: scalar(), x: scalar()},
      where=[*BACKWARD, rec(be, t, x, 1 / (2 * lam - be[t])), let(flag, leaves(n, be))], given=[ABOVE_ONE, standing("a step", n >= 1)],
      by=[arithmetic(*ends_at(be, x, n)),
          instances(20, n=(1, 2, 3, 4), using={u: nonzero()}, made_by={lam: 1 + abs(u), x: U_[n] / W_[n]}),
          instances(20, n=(2, 3, 4), using={u: nonzero()}, made_by={lam: 1 + abs(u), x: U_[n - 1] / W_[n - 1]}),
          instances(20, n=(1, 2, 3), using={u: nonzero()}, made_by={lam: 1 + abs(u)})],
      note="lambda = 1/kappa > 1. A = [[2 lambda, -1], [1, 0]] and A^(-1) = [[0, 1], [-1, 2 lambda]], so that (v_1, v_2)' = A^(-i) (0, 1)' is (U_before, U)' at i. Ends at step n: defined up to n - 1 and not at n.")
claim("BLM91-S62", "the escaping slopes decrease to alpha_-",
      always(t, (t >= 1) >> ((W_[t] != 0) & (power[t] ** 2 < 1) & ((slope(t) - 1 / p) * p * (1 - power[t] ** 2) == power[t] ** 2 * (1 - p**2)))) & always(t, (t >= 1) >> ((1 / p < slope(t + 1)) & (slope(t + 1) < slope(t)))),
      over={p: scalar()}, where=BACKWARD_P, given=[BELOW_ONE],
      by=[arithmetic(*SLOPES_END, *SLOPES_FALL, member=0), arithmetic(*SLOPES_END, *SLOPES_ABOVE, member=1), instances(40, **DRAW_P), example(p=2), example(p=-2)],
      note=P_NOTE + " The slope at i is alpha^(i) = U_i/U_(i-1) of (5.3), H_t is p^t. The first equation gives the distance from alpha_- = 1/p, p^(2i)(1 - p^2)/(p (1 - p^(2i))), which is positive and tends to zero.")
IN_BETWEEN, AT_X = (p < x) & (x < 1 / p), 1 + p**2 - p * x
#: between p and 1/p: falling, and nearer to p by the factor p^2/(1 + p^2 - p x) at least
SIGNS = [shown_first(p * x < 1, [cleared()]), by_cases(p**2 > 0), by_cases(AT_X > 0)]
TO_P = [*SIGNS, by_induction(j, 0, defined(be[j]) & (p < be[j]) & (be[j] <= x), base=values_at(0, be), step=[by_cases(p * be[j] <= p * x), by_cases(p * be[j] < 1), cleared(), *values_at(j + 1, be)]),
        by_induction(i, 0, to_p[i] >= 0, base=[unfolded(to_p, 0)], step=[cleared(), by_cases(p**2 * to_p[i] >= 0), unfolded(to_p, i + 1)]),
        shown_first(forall(s, 0, t, AT_X * to_p[s + 1] == p**2 * to_p[s]), [cleared(), unfolded(to_p, s + 1)]),
        shown_first(forall(m, 0, t, AT_X * (be[m + 1] - p) <= p**2 * (be[m] - p)), [at_index(j, m), by_cases(p * be[m] <= p * x), by_cases(p * be[m] < 1), by_cases(p**3 > 0), by_cases((be[m] - p) * (x - be[m]) >= 0), cleared(), *values_at(m + 1, be)]),
        by_induction(k, 0, (k <= t) >> (be[k] - p <= to_p[k] * (x - p)), base=[unfolded(be, 0), unfolded(to_p, 0)],
                     step=[at_index(s, k), at_index(m, k), by_cases(p**2 * (be[k] - p) <= p**2 * to_p[k] * (x - p)), multiplied(x - p)])]
claim("BLM91-S63", "which slopes belong to points of the hyperbola",
      iff((x < p) | (x > 1 / p), 1 + x**2 - POLE * x > 0) & always(t, (IN_BETWEEN) >> (defined(be[t]) & (p < be[t + 1]) & (be[t + 1] < be[t]) & (be[t] - p <= to_p[t] * (x - p)))) & ((IN_BETWEEN) >> shrinks),
      over={p: scalar(), x: scalar()}, where=[SLOPE_MAP, SLOPES, powers(p**2 / AT_X), let(shrinks, (0 < p**2 / AT_X) & (p**2 / AT_X < 1))], given=[BELOW_ONE],
      by=[arithmetic(valued(), cleared(), by_cases(p * x < 1), by_cases(x > p), by_cases(p**2 > 0), member=0), arithmetic(*TO_P, at_index(j, t), at_index(j, t + 1), at_index(k, t), *values_at(t + 1, be), by_cases(p * be[t] <= p * x), by_cases(p * be[t] < 1), cleared(), member=1),
          arithmetic(by_cases(p * x < 1), by_cases(p**2 > 0), by_cases(AT_X > 0), cleared(), member=2),
          instances(60, **DRAW_P), *(example(p="1/2", x=x_) for x_ in (1, "1/2", 2, "3/2", "3/5", "1/4", 3)), example(p=2, x=1), example(p=-2, x=1), example(p=-1, x=1)],
      note=P_NOTE + " gamma^2 = 1 + x^2 - (2/kappa) x: two points for x outside [p, 1/p], none strictly between. There the slopes fall to p, as fast at least as the powers G_t of p^2/(1 + p^2 - p x), which is less than 1.")
D_AT = (*ORBIT, rec(r, t, 1, (1 - ga[t] ** 2) * r[t]), let(D, 1 + al0**2 - ga0**2 + al0 * (Z + recip(Z))), let(dm, D / r[m]), let(dn, D / r[m + 1]))
claim("BLM91-S64", "D/r_t changes sign exactly where |gamma_t| > 1",
      iff(changes, beyond) & (dm == (1 - ga[m] ** 2) * dn), sizes=["m"], over={al0: scalar(), ga0: scalar()},
      where=[*D_AT, let(changes, pos_on_circle(dm) & pos_on_circle(-dn) | pos_on_circle(-dm) & pos_on_circle(dn)), let(beyond, abs(ga[m]) > 1)],
      given=[given("D definite", pos_on_circle(D) | pos_on_circle(-D))], note="changes: the signs differ; beyond: |gamma_t| > 1; m is the time t.",
      by=[arithmetic(valued(), cleared(), existing(r, m + 1), unfolded(r, m + 1), by_cases(ga[m] ** 2 <= 1)), instances(60, m=(0, 1, 2), using={x: nonzero(), y: nonneg()}, made_by={ga0: x, al0: 1 + abs(x) + y}),
          instances(40, m=(0, 1)), example(m=0, alpha0="3/2", gamma0="2"), example(m=0, alpha0="1/2", gamma0="3"), example(m=0, alpha0="1/4", gamma0="1/4")])
RICCATI = (rec(pit, t, 0, ((al0**2 - ga0**2) * pit[t] + ga0**2) / (1 - pit[t])),)
four0, one0, one1 = symbols("IV_0 I_0 I_1")
SMALL = (2 * al0) ** 2 < (1 + al0**2 - ga0**2) ** 2
START = given("starts in III or IV", abs(al0) > 1 + abs(ga0))
NEGATIVE = dict(sizes=["m"], over={al0: scalar(), ga0: scalar()}, given=[START],
                where=[*ORBIT, *RICCATI, *REGIONS[1:2], function(below, [t], (al[t] - al0) / al[t] < 0), function(falls, [t], pit[t + 1] < pit[t])])
DRAW_OUT = dict(using={x: nonzero(), y: positive()}, made_by={ga0: x, al0: y + 1 + abs(x)})
claim("BLM91-S65", "region II and (4.9)", iff(below(m), two_(m)), **NEGATIVE,
      by=[example(m=1, alpha0=4, gamma0=2), instances(m=(1, 2), **DRAW_OUT)],
      repair=repair("cross-reference", "(4.9), that is pi_t, is larger than 1 in region II; what is negative there is (4.19), the increment pi_(t+1) - pi_t = r_t gamma_t^2",
                    iff(falls(m), two_(m)), **NEGATIVE,
                    by=[steps("BLM91-E5.1", "BLM91-E4.11", prose="pi_(t+1) - pi_t = (1 - pi_t) gamma_t^2 with 1 - pi_t = alpha_0/alpha_t, negative exactly while alpha_t has the sign opposite to "
                              "alpha_0, that is in II, after |gamma_t| > 1 has happened once"),
                        instances(40, m=(0, 1, 2, 3), **DRAW_OUT), example(m=1, alpha0=4, gamma0=2), example(m=0, alpha0="1/2", gamma0="3"), example(m=1, alpha0=-5, gamma0="3/2"), example(m=2, alpha0=3, gamma0="3/2")]),
      note="For an orbit that starts in III or IV. pi_t = (alpha_t - alpha_0)/alpha_t is the solution of (4.7) from 0; m is the time.")
claim("BLM91-S66", "no jump from IV to I, and none out of I",
      (four0 >> ~one1) & (one0 >> one1),
      over={al0: nonzero(), ga0: scalar()}, where=[*ORBIT, *REGIONS, let(four0, four_(0)), let(one0, one_(0)), let(one1, one_(1))], given=[standing("0 < kappa^2 < 1", SMALL)],
      by=[arithmetic(*FIRST_STEP, by_cases(abs(al0) > 1 + abs(ga0))),
          instances(30, **IN_IV), instances(30, **IN_I), instances(40), example(alpha0="1/2", gamma0="3/2"), example(alpha0=3, gamma0="3/2"), example(alpha0="3/2", gamma0="3/4")])

# ---------------------------------------------------------------------- kappa^2 = 1
JORDAN = (let(A, rows([[2, -1], [1, 0]])), let(vp, rows([[1], [1]])), let(vm, rows([[y + 1], [y]])), rec(V, t, bp * vp + bm * vm, A * V[t]), rec(count, t, 0, count[t] + 1))
claim("BLM91-S67", "A(1) is a Jordan block",
      always(t, (V[t] == (bp + bm * count[t]) * vp + bm * vm) & (charpoly(A) == (Z - 1) ** 2) & ((A - Identity(2)) * vm == vp) & ((A - Identity(2)) * vp == Zero(2, 1))),
      over={y: scalar(), bp: scalar(), bm: scalar()}, where=JORDAN, by=[induction(cofactors=[[(A, 0, 1)], [], [], []]), instances()],
      note="v_2 = (y + 1, y)' runs over all principal vectors; v_1 is the only direction of eigenvectors because A - I is not zero, being nonzero on v_2. count is t.")
SIGN_K = 2 * k - 1
#: V = A^t v in both coordinates, for A(1); slopes for kappa = 1, -1
EDGE = (rec(V1, t, bp + bm * (y + 1), 2 * V1[t] - V2[t]), rec(V2, t, bp + bm * y, V1[t]), rec(be, t, SIGN_K * (1 + x), 1 / (2 * SIGN_K - be[t])))
LINES_1 = by_induction(j, 0, (V1[j] == bp + bm * j + bm * (y + 1)) & (V2[j] == bp + bm * j + bm * y), base=[unfolded(V1, 0), unfolded(V2, 0)], step=[unfolded(V1, j + 1), unfolded(V2, j + 1)])
#: (kappa b_i - 1)(1 - i x) = x
SLOPES_1 = by_induction(i, 0, defined(be[i]) >> (((SIGN_K * be[i] - 1) * (1 - i * x) == x) & (i * x != 1)), base=[by_cases(k == 0), *values_at(0, be)], step=[by_cases(k == 0), cleared(), multiplied(1 - i * x), *values_at(i + 1, be)])
claim("BLM91-S68", "kappa^2 = 1: convergence to kappa",
      always(t, (V1[t] == bp + bm * t + bm * (y + 1)) & (V2[t] == bp + bm * t + bm * y))
      & always(t, (SIGN_K * be[t] - 1 == x / (1 - t * x)) & ((SIGN_K * be[t] < 1) >> ((SIGN_K * be[t] < SIGN_K * be[t + 1]) & (SIGN_K * be[t + 1] < 1))) & ((t * abs(x) >= 2) >> (t * abs(be[t] - SIGN_K) <= 2))),
      over={y: scalar(), bp: scalar(), bm: nonzero(), x: nonzero(), k: integer(0, 1)}, where=EDGE,
      by=[arithmetic(LINES_1, at_index(j, t), member=0), arithmetic(valued(), SLOPES_1, at_index(i, t), by_cases(k == 0), *values_at(t + 1, be), cleared(), member=1),
          instances(40), example(y=0, beta_plus=1, beta_minus=1, x="-1/2", k=1), example(y=0, beta_plus=1, beta_minus=1, x="2/5", k=0)],
      note="kappa = 2k - 1, (V_1, V_2)' = A^t (beta_+ v_1 + beta_- v_2) for v_1 = (1, 1)', v_2 = (y + 1, y)', which is (beta_+ + beta_- t) v_1 + beta_- v_2, and b is the slope for kappa, from kappa(1 + x): its distance from kappa is 2/t at most for t >= 2/|x|. "
           "Monotone is read as in Theorem 3.5, 1): kappa alpha_t grows to 1 once it is less than 1; an orbit that starts beyond kappa first passes over infinity.")
