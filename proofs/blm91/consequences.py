# SPDX-License-Identifier: MIT
"""What follows for n = 1 and is not said in the paper: iterates in closed form, exact periods, rational data.

On the hyperbola 1 + alpha^2 - gamma^2 = 2 lambda alpha, lambda = 1/kappa, the
algorithm is linear in disguise. Let M_(t+1) = 2 lambda M_t - M_(t-1) with M_0 = 1, M_(-1) = alpha_0. Then

    alpha_t = M_(t-1)/M_t,      gamma_t = (-1)^t gamma_0/M_t.

The orbit ends with the first t for which M_t = 0. With lambda = -(w + 1/w)/2 the numbers e_t
= (-1)^t M_t are combinations of w^t and w^(-t). So for gamma_0 not 0 the
orbit is back at its start after t steps exactly when e_t = e_0 and e_(t-1) =
e_(-1), that is, when w^t = 1 (w is not 1 or -1 for kappa^2 > 1). Hence

    all orbits that do not end have period p  <=>  kappa = -sec(2 pi q/p), (q, p) = 1.

This is Theorem 3.7 with one formula for both signs of kappa and for kappa
infinite (p = 4): q/p in (0, 1/4) gives kappa < -1, in (1/4, 1/2) kappa > 1.
For kappa = 1, -1 M_t is linear in t: with alpha_0 = kappa(1 + x) the orbit is kappa(1 + x/(1 - t x)).

2 cos(2 pi q/p) is a zero of a monic polynomial with integer coefficients. If it
is rational it is an integer, one of -2, .., 2 (Niven), and p is 1, 2, 3, 4 or 6. So the
periods of the algorithm for rational (alpha_0, gamma_0) are 1, 3, 4 and 6, with
1/kappa = 1/2, 0, -1/2 for the last three; those of the Riccati equation are 1, 2 and 3. On
every other rational point of the corridors the orbit ends or is dense.
"""

from exactkf.claims import claim
from exactkf.evidence import arithmetic, evaluation, example, induction, instances, part, steps, valued
from exactkf.language import *
from proofs.blm91.consequences_angles import COPRIME, d, n
from proofs.blm91.consequences_angles import LOWEST as OF_FRACTIONS
from proofs.blm91.lemmas_ends import DIFFERENT, LISTED, TWO_EACH, about_lines, ends_at, first_, second_
from proofs.blm91.lemmas_turns import LINES_BACK, LOWEST_PQ, OF_FORMS, OF_POINTS, SINES_D, U_, W_
from proofs.blm91.notation import *

H = 1 + al[t] ** 2 - ga[t] ** 2 == 2 * lam * al[t]
FIRST_ = al[t] / ((1 - ga[t] ** 2) * (2 * lam - Nt[t] / Mt[t]))
SECOND_ = -1 / ((1 - ga[t] ** 2) * (2 * lam - Nt[t] / Mt[t]))
SCALE_ = -sg[t] * ga0 / Mt[t]
claim("BLM91-X.1", "iterates in closed form",
      always(t, (al[t] == Nt[t] / Mt[t]) & (ga[t] == sg[t] * ga0 / Mt[t])), over={al0: nonzero(), ga0: scalar()}, where=[*ORBIT, LAMBDA, *PROJECTIVE],
      by=[induction(also=[H], cofactors=[[(FIRST_, 0, 1), (SECOND_, 2, 1)], [(-al[t + 1], 1, 1), (SCALE_ * FIRST_, 0, 1), (SCALE_ * SECOND_, 2, 1)],
                                         [(1 / (1 - ga[t] ** 2), 2, 1)]]), instances()],
      note="M_(t+1) = 2 lambda M_t - N_t, N_(t+1) = M_t from (1, alpha_0), so that N_t = M_(t-1), and s_t = (-1)^t.")
w, W, p, q, y, gcd, Tn, Sn, back, many, whole = symbols("w W p q y gcd T S back divides whole")
claim("BLM91-X.2", "the closed form by powers of w",
      always(t, (sg[t] * Mt[t] * (w - 1 / w) == w * W[t] - 1 / (w * W[t]) + al0 * (W[t] - 1 / W[t]))
             & (sg[t] * Nt[t] * (w - 1 / w) == 1 / W[t] - W[t] - al0 * (W[t] / w - w / W[t]))), over={al0: nonzero(), w: nonzero()},
      where=[let(lam, -(w + 1 / w) / 2), *PROJECTIVE, rec(W, t, 1, w * W[t])], by=[induction(cofactors=[[(w + 1 / w, 0, 1), (1, 1, 1)], [(-1, 0, 1)]]), instances()],
      note="W_t = w^t. An identity of rational functions of w, so that it holds for w on the unit circle too: there 1/kappa = -cos(arg w).")

# ---------------------------------------------------------------------- exact periods
LOWEST = [standing("angle", 2 * q < p), standing("lowest terms", gcd(p, q) == 1)]
#: 1/kappa = -cos(2 pi q/p), and a point of the hyperbola
TURN = (GCD, let(lam, -cospi(2 * q, p)), let(al0, ALPHA_OF), let(ga0, GAMMA_OF))
claim("BLM91-X.3", "the period for kappa = -sec(2 pi q/p), by the closed form",
      forall(t, 1, p, iff((sg[t] * Mt[t] == 1) & (sg[t] * Nt[t] == al0), t == p)), sizes=["q", "p"], over={al0: scalar()},
      where=[*COPRIME, let(lam, -cospi(2 * q, p)), *PROJECTIVE], given=LOWEST_PQ,
      by=[arithmetic(*OF_FORMS), instances(24, q=(1, 2, 3), p=range(3, 9)), example(q=5, p=12, alpha0=2), example(q=7, p=30, alpha0="1/2"), example(q=2, p=6, alpha0=3)],
      note="For every q and p, both signs of kappa and kappa infinite (p = 4, q = 1), from every point of the hyperbola: its second coordinate does not enter.")
claim("BLM91-X.4", "the period for kappa = -sec(2 pi q/p), along the orbit itself",
      (1 + al0**2 - ga0**2 == 2 * lam * al0) & forall(t, 1, p, iff((al[t] == al0) & (ga[t] == ga0), t == p)),
      sizes=["p"], over={q: integer(1, 4), u: integer(2, 3)}, where=[*TURN, *ORBIT], given=[*LOWEST, standing("orbit", defined(ga[p]))], by=[part("p <= 10, two points of each hyperbola"), evaluation(p=range(3, 11)), instances(12, p=range(3, 9)), example(p=3, q=1, u=2), example(p=8, q=1, u=3)],
      note="(3.10) run step by step in the number field, from two points of each hyperbola.")
claim("BLM91-X.5", "orbits that do not end have period p exactly when kappa = -sec(2 pi q/p)",
      forall(t, 1, p, iff((al[t] == al0) & (ga[t] == ga0), t == p)), sizes=["q", "p"], over={al0: nonzero(), ga0: scalar()},
      where=[*COPRIME, let(lam, -cospi(2 * q, p)), *ORBIT],
      given=[*LOWEST_PQ, given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 * lam * al0), standing("the orbit exists", defined(al[p]) & defined(ga[p]))],
      by=[arithmetic(valued(), *OF_POINTS), instances(12, q=1, p=(3, 4, 6), using={u: scalar()}, made_by={al0: ALPHA_OF, ga0: 1 + u * ALPHA_OF}),
          example(q=1, p=3, alpha0="-5/3", gamma0="-7/3"), example(q=1, p=4, alpha0="-4/3", gamma0="-5/3"), example(q=1, p=6, alpha0=-1, gamma0=-1), example(q=2, p=6, alpha0="-5/3", gamma0="-7/3")],
      note="For every q and p, and every point of the hyperbola.")

claim("BLM91-X.13", "U_t by powers of w", always(t, (Ut[t] * (w - 1 / w) == w * W[t] - 1 / (w * W[t])) & (Sn[t] * (w - 1 / w) == W[t] - 1 / W[t])), over={w: nonzero()},
      where=[let(lam, (w + 1 / w) / 2), rec(Ut, t, 1, 2 * lam * Ut[t] - Sn[t]), rec(Sn, t, 0, Ut[t]), rec(W, t, 1, w * W[t])], by=[induction(cofactors=[[(w + 1 / w, 0, 1), (-1, 1, 1)], [(1, 0, 1)]]), instances()],
      note="U_t = (w^(t+1) - w^(-t-1))/(w - 1/w) for 1/kappa = (w + 1/w)/2, W_t = w^t and S_t = U_(t-1). As for X.2, it holds on the unit circle too, where 1/kappa = cos(arg w).")

# ---------------------------------------------------------------------- rational data
claim("BLM91-X.6", "twice the cosine of a multiple angle, by a recursion with integer coefficients",
      always(t, (Tn[t] == W[t] + 1 / W[t]) & (Sn[t] == w * W[t] + 1 / (w * W[t]))), over={w: nonzero()},
      where=[rec(Tn, t, 2, Sn[t]), rec(Sn, t, w + 1 / w, (w + 1 / w) * Sn[t] - Tn[t]), rec(W, t, 1, w * W[t])], by=[induction(), instances()],
      note="T_0 = 2, T_1 = x, T_(t+1) = x T_t - T_(t-1) for x = w + 1/w: T_t is a monic polynomial in x with integer coefficients for t >= 1.")
claim("BLM91-X.7", "which 1/kappa = -cos(2 pi q/p) are rational",
      iff(whole, (p == 3) | (p == 4) | (p == 6)), sizes=["p"], over={q: integer(1, 29)},
      where=[GCD, let(lam, -cospi(2 * q, p)), let(whole, exists(k, -2, 2, 2 * lam == k))], given=LOWEST, by=[steps("BLM91-X.6", facts=["a rational zero of a monic polynomial with integer coefficients is an integer"],
                prose="2/kappa, a zero of the monic integer polynomial T_p - 2 of (X.6), is rational only as an integer, and then one of -2, .., 2, of which -2 and 2 leave w = 1, -1; "
                      "2/kappa = 1, 0, -1 leaves w^2 + 2w/kappa + 1 = 0 with w of order 3, 4, 6"),
          instances(40, p=range(3, 25)), *(example(p=k_, q=1) for k_ in (3, 4, 5, 6, 8, 12))],
      note="Among the fractions the formula has 2/kappa = -2, .., 2: no others are possible. Tried for p <= 24.")
still, zero, top, low = symbols("still zero numerator denominator")
#: 1/kappa a fraction, and any point of its hyperbola
FRACTION = {top: integer(-12, 12), low: integer(1, 12), u: scalar()}
ON_FRACTION = (let(lam, top / low), let(al0, ALPHA_OF), let(ga0, GAMMA_OF))
HALVES = [example(numerator=i_, denominator=2, u=u_) for i_ in (1, 0, -1) for u_ in (2, "1/3")]
STILL = example(numerator=5, denominator=4, u="-1/2")
FLAT = (let(still, ga0 == 0), let(zero, lam == 0))
BACK = function(back, [t], (al[t] == al0) & (ga[t] == ga0))
claim("BLM91-X.8", "rational data have the periods 1, 3, 4, 6 and no others",
      forall(t, 1, 13, iff(back(t), still | (2 * lam == 1) & many(3, t) | zero & many(4, t) | (2 * lam == -1) & many(6, t))),
      over=FRACTION, where=[*ON_FRACTION, *ORBIT, BACK, MANY, *FLAT],
      by=[steps("BLM91-X.1", "BLM91-X.2", "BLM91-X.6", facts=["a rational zero of a monic polynomial with integer coefficients is an integer"],
                prose="1/kappa is rational with the point. For gamma_0 not 0 a return after t steps means w^t = 1 for w + 1/w = -2/kappa, w not 1 or -1 (for kappa = 1, -1 the "
                      "closed form grows with t), so that -2/kappa is an integer by (X.6)"),
          instances(60), *HALVES, STILL],
      note="1/kappa is any fraction with terms up to 12, and u runs through the points of the hyperbola, rational or not. Orbits that end are left aside. Where none of the cases applies the orbit converges (kappa^2 <= 1) or is dense.")
claim("BLM91-X.9", "rational data of the Riccati equation have the periods 1, 2, 3 and no others",
      forall(t, 1, 7, iff(al[t] == al0, still | (4 * lam**2 == 1) & many(3, t) | zero & many(2, t))),
      over=FRACTION, where=[*ON_FRACTION, *ORBIT, MANY, *FLAT],
      by=[steps("BLM91-X.1", "BLM91-X.2", "BLM91-X.6", facts=["a rational zero of a monic polynomial with integer coefficients is an integer"],
                prose="alpha_t = alpha_0 says N_t = alpha_0 M_t, which is (w^t - w^(-t))(alpha_0^2 - 2 lambda alpha_0 + 1) = 0: gamma_0 = 0 or w^(2t) = 1"),
          instances(60), *HALVES, STILL],
      note="1/kappa and u as in X.8. The Riccati equation in the coordinate alpha = alpha_0/(1 - pi), in which it is the first equation of (3.10) on the hyperbola.")

# ---------------------------------------------------------------------- kappa = 1 and kappa = -1
num_, alm, gam_ = symbols("count alpha_minus gamma_minus")
SHARED = x / (1 - num_[t] * x)
NEXT_ = (1 + SHARED) / (1 - SHARED**2)
PLUS_ = [(1 / (1 - ga[t] ** 2), 0, 1), (NEXT_ * (ga[t] + sg[t] * SHARED) / (1 - ga[t] ** 2), 1, 1), (NEXT_ * SHARED**2 / (1 - ga[t] ** 2), 4, 1)]
MINUS_ = [(1 / (1 - gam_[t] ** 2), 2, 1), (-NEXT_ * (gam_[t] + SHARED) / (1 - gam_[t] ** 2), 3, 1)]
claim("BLM91-X.11", "iterates in closed form for kappa = 1 and kappa = -1",
      always(t, (al[t] == 1 + SHARED) & (ga[t] == sg[t] * SHARED) & (alm[t] == -1 - SHARED) & (gam_[t] == SHARED)), over={x: scalar()},
      where=[*scalar_orbit(1 + x, x), rec(alm, t, -1 - x, alm[t] / (1 - gam_[t] ** 2)), rec(gam_, t, x, -gam_[t] * alm[t] / (1 - gam_[t] ** 2)), rec(num_, t, 0, num_[t] + 1), rec(sg, t, 1, -sg[t])],
      by=[induction(also=[sg[t] ** 2 == 1], cofactors=[PLUS_, [(-al[t + 1], 1, 1), *((-sg[t] * SHARED * e_, i_, 1) for e_, i_, _ in PLUS_)],
                                                     MINUS_, [(-alm[t + 1], 3, 1), *((-SHARED * e_, i_, 1) for e_, i_, _ in MINUS_)], [(1, 4, 1)]]), instances()],
      note="From (1 + x, x) and (-1 - x, x); count is t and s_t = (-1)^t. The distance from the equilibrium is x/(1 - t x): for x = 2/(2j + 1), j >= 1, it is 2 at step j, however small x is.")

# ---------------------------------------------------------------------- all points that end
ends, listed, same, at_once, time, count = symbols("ends listed same_slope ends_at_once time last")
al_zero, ga_zero, ga_start = symbols("alpha_zero gamma_zero gamma_start")
claim("BLM91-X.15", "all points that end, and after how many steps, for every rational angle", iff(ends, listed) & iff(at_once, ga_start**2 == 1), sizes=["n", "d", "time"],
      over={al0: nonzero(), ga0: scalar(), ga_start: scalar()},
      where=[*COPRIME, let(lam, cospi(n, d)), *LINES_BACK, *ORBIT, let(ends, leaves(time)), let(listed, (time <= d - 2) & (al0 * W_[time] == U_[time])),
             rec(al_zero, t, 0, al_zero[t] / (1 - ga_zero[t] ** 2)), rec(ga_zero, t, ga_start, -ga_zero[t] * al_zero[t] / (1 - ga_zero[t] ** 2)), let(at_once, leaves(1, ga_zero))],
      given=[*OF_FRACTIONS, standing("a step", time >= 1), given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 * lam * al0)],
      by=[arithmetic(*ends_at(time), member=0), arithmetic(*(hint for k_ in (1, 0) for hint in values_at(k_, al_zero, ga_zero)), member=1),
          instances(24, n=(1, 2), d=(2, 3), time=(1, 2, 3, 4), using={u: scalar()}, made_by={al0: ALPHA_OF, ga0: GAMMA_OF}),
          *(example(n=n_, d=d_, time=m_, alpha0=a_, gamma0=g_, gamma_start=1) for n_, d_, m_, a_, g_ in (
              (1, 3, 1, 1, 1), (2, 3, 1, -1, 1), (1, 3, 2, 1, 1), (1, 3, 1, "-5/3", "-7/3"), (2, 6, 4, 1, 1)))],
      note="For every fraction n/d, theta = pi n/d. (W_k, U_k)' is A^(-k) (0, 1)', W printed as U_before. The points with alpha_0 not 0 that end are those of slope U_k/W_k, k = 1, .., d - 2, with step k (listed); "
           "(0, 1) and (0, -1), of slope U_(d-1)/W_(d-1) = 0, end at once. How many points these are says X.16.")
claim("BLM91-X.16", "the listed slopes are different, and each belongs to two points",
      forall(first_, 1, count, forall(second_, 1, count, iff(same(first_, second_), first_ == second_))) & forall(s, 1, count, W_[s] != 0) & (1 + al0**2 - 2 * lam * al0 > 0), sizes=["n", "d"], over={al0: scalar()},
      where=[*COPRIME, let(lam, cospi(n, d)), *LINES_BACK, function(same, [i, j], U_[i] * W_[j] == U_[j] * W_[i]), let(count, d - 1)], given=OF_FRACTIONS,
      by=[arithmetic(*about_lines(), *DIFFERENT, member=0), arithmetic(*about_lines(), *LISTED, member=1), arithmetic(*SINES_D, *TWO_EACH, member=2), instances(24, n=range(1, 6), d=range(2, 9)),
          *(example(n=n_, d=d_, alpha0=x_) for n_, d_, x_ in ((2, 4, 0), (1, 1, 1), (0, 3, 1), (1, 4, 1)))],
      note="gamma_0^2 = 1 + alpha_0^2 - 2 lambda alpha_0 is positive for every alpha_0. So with X.15 there are 2(d - 1) points that end: four at step 1 (two for d = 2), two at each of the steps 2, .., d - 2.")
