# SPDX-License-Identifier: MIT
"""Periods and escape counts for every rational angle with p <= 60, counted one by one.

What is proved for every q and p (X.3, X.5, X.15, X.16) is counted here in the number fields Q(cos(2 pi q/p)), for every
angle in lowest terms: both signs of kappa, and kappa infinite (p = 4, q = 1). The counts do not use the proofs.

On the hyperbola |gamma| = 1 leaves alpha = 2/kappa and alpha = 0, which are where (3.10) divides by zero. The inverse of (3.10),
alpha = alpha' (1 - gamma^2) with gamma = -gamma'/alpha', leads from (2/kappa, 1) to all points that end there, and stops at alpha = 0,
which nothing moves to. (3.10) is run forwards from each point: its step leads to the point before it in the list, so that the steps
that remain are counted once. Mirror images in gamma end with them, hence the factor two.
"""

from exactkf.claims import claim
from exactkf.evidence import evaluation, instances, part
from exactkf.language import *
from proofs.blm91.notation import *

p, q, gcd = symbols("p q gcd")
GIVEN = dict(sizes=["p"], over={q: integer(1, 29)}, given=[standing("angle", 2 * q < p), standing("lowest terms", gcd(p, q) == 1)])
ANGLE = (GCD, let(lam, -cospi(2 * q, p)))
claim("BLM91-X.22", "the period for every angle with p <= 60, by the closed form", forall(t, 1, p, iff((sg[t] * Mt[t] == 1) & (sg[t] * Nt[t] == al0), t == p)), **GIVEN,
      where=[let(u, rational("1/2")), *ANGLE, let(al0, ALPHA_OF), let(ga0, GAMMA_OF), *PROJECTIVE],
      by=[part("p <= 60, one point of each hyperbola"), evaluation(p=range(3, 61)), instances(12, p=range(3, 9))],
      note="From one point of each hyperbola; by X.2 the point does not matter.")

first, last = symbols("first last")
ends, total, before_al, before_ga, after_al, after_ga, length = symbols("ends total alpha_back gamma_back alpha_on gamma_on steps")
#: the k-th point before the end on the branch through (2/kappa, 1), by the inverse of (3.10), the first of them with alpha = 0, and how many steps of (3.10) it takes
BACKWARDS = (function(before_al, [k], when(k == 1, 2 * lam, before_al(k - 1) * (1 - before_ga(k) ** 2))), function(before_ga, [k], when(k == 1, 1, -before_ga(k - 1) / before_al(k - 1))),
             function(after_al, [k], before_al(k) / (1 - before_ga(k) ** 2)), function(after_ga, [k], -before_ga(k) * after_al(k)),
             function(length, [k], when(before_ga(k) ** 2 == 1, 1, when((after_al(k) == before_al(k - 1)) & (after_ga(k) == before_ga(k - 1)), 1 + length(k - 1), 0))),
             function(first, [k], when(before_al(k) == 0, k, first(k + 1))), let(last, first(1)), function(ends, [t], 2 * sum_of(k, 1, last, when(length(k) == t, 1, 0))),
             function(total, [t], when(t == 1, when(last == 1, 2, 4), when(t < last, 2, 0))))
EVERY_END = (2 * last == when(cospi(p, 1) == -1, 2 * (p - 1), p - 2)) & forall(t, 1, last, ends(t) == total(t))
claim("BLM91-X.23", "all points that end, and after how many steps, for every angle with p <= 48", EVERY_END, **GIVEN, where=[*ANGLE, *BACKWARDS],
      by=[part("p <= 48"), evaluation(p=range(3, 49)), instances(30, p=range(3, 13))])
claim("BLM91-X.24", "all points that end, and after how many steps, for every angle with p = 49, .., 60", EVERY_END, **GIVEN, where=[*ANGLE, *BACKWARDS],
      by=[part("49 <= p <= 60"), evaluation(p=range(49, 61)), instances(30, p=range(3, 13))])
