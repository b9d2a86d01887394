# SPDX-License-Identifier: MIT
"""Convergence on a hyperbola for kappa^2 <= 1, with bounds for every t: hints for proofs with numbers.

Let p (1 + alpha^2 - gamma^2) = (1 + p^2) alpha, |p| <= 1, p not 0: then p = alpha_+, and p (1 + alpha alpha') = (1 + p^2) alpha'. With R_t = p^(2t)

    (alpha_t - p)(p alpha_0 - 1) = R_t (alpha_0 - p)(p alpha_t - 1),

and so (alpha_t - p)((p alpha_0 - 1) - R_t p (alpha_0 - p)) = -R_t (alpha_0 - p)(1 - p^2): where 2 R_t |p||alpha_0 - p| <= |p alpha_0 - 1|, the distance
|alpha_t - p| is 2 R_t |alpha_0 - p|/|p alpha_0 - 1| at most. For p = 1, -1 there is

    (alpha_t - p)(1 - t p (alpha_0 - p)) = alpha_0 - p,

so that |alpha_t - p| <= 2/t where t |alpha_0 - p| >= 2.

The points that end have the slopes U_t/W_t, W_t = U_(t-1), U_0 = 1, W_0 = 0, U_(t+1) = (p + 1/p) U_t - W_t. With H_t = p^t, H_t (U_t - p W_t) = 1 and p U_t - W_t = p H_t, hence
(1 - p^2) H_t W_t = p (1 - H_t^2), which is not 0 for t >= 1, and p U_t/W_t = (1 - p^2 H_t^2)/(1 - H_t^2), which falls to 1.
"""

from exactkf.evidence import angles, arithmetic, at_index, by_cases, by_induction, cleared, existing, multiplied, shown_first, unfolded, valued
from exactkf.language import *
from proofs.blm91.lemmas_turns import U_, W_
from proofs.blm91.notation import *

__all__ = ["BACKWARD_P", "BOUND", "CONVERGES", "CONVERGES_BY", "FROM_P", "IN_TIME", "LIMIT_WORDS", "SLOPES_ABOVE", "SLOPES_END", "SLOPES_FALL", "SQUARED", "power", "slope"]

p, q, squared, on_edge, at = symbols("p q R on_edge at")
#: p^(2t)
SQUARED = rec(squared, t, 1, p**2 * squared[t])
#: the orbit stays on the hyperbola; alpha' = 1/(p + 1/p - alpha); it stays away from 1/p, and (alpha - p)/(p alpha - 1) is multiplied by p^2
FROM_P = [
    by_induction(i, 0, defined(al[i]) >> (p * (1 + al[i] ** 2 - ga[i] ** 2) == (1 + p**2) * al[i]), base=values_at(0),
                 step=[cleared(), *values_at(i + 1), multiplied(ga[i] ** 2)]),
    shown_first(forall(k, 0, t, defined(al[k + 1]) >> (p * (1 + al[k] * al[k + 1]) == (1 + p**2) * al[k + 1])),
                [at_index(i, k), cleared(), existing(al, k + 1), unfolded(al, k + 1)]),
    by_induction(j, 0, ((j <= t) & defined(al[j]) & (p * al0 != 1)) >> ((p * al[j] != 1) & ((al[j] - p) * (p * al0 - 1) == squared[j] * (al0 - p) * (p * al[j] - 1))),
                 base=[unfolded(al, 0), unfolded(squared, 0)],
                 step=[existing(al, j + 1), at_index(k, j), unfolded(squared, j + 1), multiplied(p), multiplied(p**2), multiplied(p * al[j]),
                       multiplied((1 - p**2) * (p * al0 - 1)), multiplied(p**2 * (p * al[j + 1] - 1))])]
POSITIVE_R = by_induction(m, 0, squared[m] > 0, base=[unfolded(squared, 0)], step=[unfolded(squared, m + 1), by_cases(p**2 > 0)])
IN_TIME = [POSITIVE_R, at_index(i, t), at_index(j, t), at_index(m, t), by_cases(p**2 < 1), by_cases(p**2 > 0), by_cases(squared[t] * abs(al0 - p) >= 0),
           by_cases(squared[t] * abs(al0 - p) * (1 - p**2) >= 0), by_cases(squared[t] * abs(al0 - p) * p**2 >= 0)]
BOUND = (2 * squared[t] * abs(p) * abs(al0 - p) <= abs(p * al0 - 1)) >> (abs(al[t] - p) * abs(p * al0 - 1) <= 2 * squared[t] * abs(al0 - p))
#: for p = 1, -1: 1/(alpha' - p) = 1/(alpha - p) - p
BY_STEPS = by_induction(q, 0, ((q <= t) & defined(al[q])) >> ((al[q] - p) * (1 - q * p * (al0 - p)) == al0 - p), base=[unfolded(al, 0)],
                        step=[existing(al, q + 1), at_index(k, q), by_cases(al[q] == p), by_cases(al[q] > p), multiplied(al[q + 1] - p), multiplied(al0 - p)])
BOTH_SIGNS = by_cases(p > 0, [shown_first(p == 1)], [shown_first(p == -1)])
#: what is needed beside the orbit
LIMIT_WORDS = (SQUARED, let(on_edge, p**2 == 1), let(at, p * al0 == 1))
CONVERGES = (always(t, BOUND) & always(t, (on_edge & (t * abs(al0 - p) >= 2)) >> (t * abs(al[t] - p) <= 2))
             & always(t, at >> (al[t] == al0)) & always(t, p * ga[t] ** 2 == (al[t] - p) * (p * al[t] - 1)))
#: R_t for p = 1, -1; and alpha_t for p alpha_0 = 1
SAME_R = by_induction(q, 0, (p**2 == 1) >> (squared[q] == 1), base=[unfolded(squared, 0)], step=[unfolded(squared, q + 1)])
AT_REST = by_induction(q, 0, ((q <= t) & defined(al[q])) >> (al[q] == al0), base=[unfolded(al, 0)],
                       step=[existing(al, q + 1), at_index(k, q), multiplied(al[q + 1]), by_cases(p * al[q + 1] == 1)])
CONVERGES_BY = [
    arithmetic(valued(), *FROM_P, SAME_R, at_index(q, t), *IN_TIME, by_cases(p * al0 == 1, [by_cases(al0 == p)]), member=0),
    arithmetic(valued(), BOTH_SIGNS, *FROM_P[:2], BY_STEPS, at_index(q, t), by_cases(al0 > p), by_cases(al[t] > p), member=1),
    arithmetic(valued(), *FROM_P[:2], AT_REST, at_index(q, t), member=2), arithmetic(valued(), FROM_P[0], at_index(i, t), member=3)]

# ---------------------------------------------------------------------- slopes of points that end
power, slope = symbols("H slope")
#: U_t, U_(t-1), and p^t
BACKWARD_P = (let(lam, (p + 1 / p) / 2), rec(U_, t, 1, 2 * lam * U_[t] - W_[t]), rec(W_, t, 0, U_[t]), rec(power, t, 1, p * power[t]), function(slope, [t], U_[t] / W_[t]))
P_SQUARE = [by_cases(p**2 < 1), by_cases(p**2 > 0)]
SLOPES_END = [
    *P_SQUARE,
    by_induction(j, 0, (power[j] * (U_[j] - p * W_[j]) == 1) & (p * U_[j] - W_[j] == p * power[j]), base=[unfolded(x_, 0) for x_ in (U_, W_, power)],
                 step=[cleared(), *(unfolded(x_, j + 1) for x_ in (U_, W_, power)), multiplied(p), multiplied(power[j])]),
    by_induction(i, 0, (0 < power[i] ** 2) & (power[i] ** 2 <= 1) & ((i >= 1) >> (power[i] ** 2 < 1)), base=[unfolded(power, 0)], step=[unfolded(power, i + 1), by_cases(p**2 * power[i] ** 2 <= p**2), by_cases(p**2 * power[i] ** 2 > 0)]),
    shown_first(forall(k, 1, t + 1, ((1 - p**2) * power[k] * W_[k] == p * (1 - power[k] ** 2)) & (W_[k] != 0)), [at_index(j, k), at_index(i, k), multiplied(p), multiplied(power[k]), multiplied(p**2 * power[k]), by_cases(p > 0)]),
    shown_first(forall(s, 1, t + 1, p * U_[s] * (1 - power[s] ** 2) == W_[s] * (1 - p**2 * power[s] ** 2)), [at_index(j, s), at_index(k, s), multiplied(power[s]), multiplied(W_[s])])]
OF_SLOPE = shown_first(forall(m, 1, t + 1, p * slope(m) * (1 - power[m] ** 2) == 1 - p**2 * power[m] ** 2),
                       [at_index(k, m), at_index(s, m), angles("quotient", U_[m], W_[m]), multiplied(p * (1 - power[m] ** 2)), multiplied(slope(m))])
SLOPES_FALL = [OF_SLOPE, *(at_index(k_, t_) for t_ in (t, t + 1) for k_ in (i, k, m)), unfolded(power, t + 1), angles("quotient", 1, p), multiplied(1 - power[t] ** 2)]
#: p U_t/W_t falls, and is larger than 1
SLOPES_ABOVE = [
    OF_SLOPE,
    shown_first((t >= 1) >> (p * slope(t + 1) > 1), [*(at_index(k_, t + 1) for k_ in (i, m)), unfolded(power, t + 1), by_cases((1 - p**2) * power[t + 1] ** 2 > 0)]),
    shown_first((t >= 1) >> (p * slope(t) > p * slope(t + 1)), [*(at_index(k_, t_) for t_ in (t, t + 1) for k_ in (i, m)), unfolded(power, t + 1), by_cases((1 - p**2) * power[t] ** 2 > 0), by_cases((1 - p**2) ** 2 * power[t] ** 2 > 0),
                by_cases((1 - power[t] ** 2) * (1 - p**2 * power[t] ** 2) > 0), multiplied(1 - power[t] ** 2), multiplied(1 - p**2 * power[t] ** 2)]),
    by_cases(p > 0), angles("quotient", 1, p)]
