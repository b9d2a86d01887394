# SPDX-License-Identifier: MIT
"""Which points end on a hyperbola with a rational angle, for every fraction: hints for proofs with numbers.

1/kappa = lambda = cos(theta), theta = pi n/d in lowest terms; (W_k, U_k)' = A^(-k) (0, 1)', so that W_k sin(theta) = sin(k theta) and U_k = W_(k+1). Then W_d = 0,
no W_k before it is 0, W_(d+k) = U_d W_k, and U_j W_(j+k) - U_(j+k) W_j = W_k: the d - 1 slopes U_k/W_k, k = 1, .., d - 1, are different, and the last of them is 0.

Let M_k = U_k - alpha_0 W_k. While the orbit exists, alpha_k M_k = M_(k-1) and M_k is not 0. It ends with step k when alpha_(k-1) = 2 lambda, that is M_k = 0, and then
k <= d - 2: M_(d+k) = U_d M_k, M_d = U_d is not 0, and M_(d-1) = 0 would make alpha_0 = 0. Conversely M_m = 0 makes M_(m-k) W_m = W_k, which is not 0 for k = 1, .., m.
"""

from exactkf.evidence import angles, arithmetic, at_index, by_cases, by_induction, by_rests, existing, multiplied, shown_first, square_of, unfolded
from exactkf.language import *
from proofs.blm91.consequences_angles import COPRIME, EUCLID, d, x, y, z
from proofs.blm91.consequences_angles import s as sine
from proofs.blm91.lemmas_turns import (
    IN_LOWEST,
    LENGTH,
    LINES_BACK,
    ON_CURVE,
    ONE_STEP,
    PYTHAGORAS,
    SINES_D,
    U_,
    W_,
    before,
    by_ends,
    c,
    h_,
    not_before,
    of_slope,
    pit,
    three,
)
from proofs.blm91.notation import *

__all__ = ["ALL_ENDS", "DIFFERENT", "LISTED", "OF_LIST", "OF_POINT", "SINES_EVEN", "SINES_ODD", "THE_LIST", "TWO_EACH", "W_NOT_ZERO", "about_lines", "ends_at", "first_", "not_late", "of_list", "second_"]

first_, second_, k_, m_ = symbols("first second back ahead")

# ---------------------------------------------------------------------- angles
#: x n = d y, n = p - 2q and d = p odd: p divides 2 x q, hence x q; n = d - q and p = 2d: p divides 2x q
SINES_ODD = [IN_LOWEST, shown_first(EUCLID, [by_rests(x - y, 2, h_, [[at_index(x, x), at_index(y, h_)], []])]), *SINES_D[1:]]
SINES_EVEN = [IN_LOWEST, shown_first(EUCLID, [at_index(x, 2 * x), at_index(y, x - y)]), *SINES_D[1:]]

# ---------------------------------------------------------------------- lines
SINES_W = by_induction(t, 0, (W_[t] * sine(1) == sine(t)) & (U_[t] * sine(1) == sine(t + 1)), base=[unfolded(U_, 0), unfolded(W_, 0), angles("right", d)],
                       step=[unfolded(U_, t + 1), unfolded(W_, t + 1), three(t + 1)])
W_NOT_ZERO = shown_first(forall(s, 1, d - 1, W_[s] != 0), [at_index(z, s), at_index(t, s)])
AGAIN = by_induction(h_, 0, (W_[d + h_] == U_[d] * W_[h_]) & (U_[d + h_] == U_[d] * U_[h_]), base=[unfolded(U_, 0), unfolded(W_, 0)],
                     step=[unfolded(x_, k_) for x_ in (U_, W_) for k_ in (h_ + 1, d + h_ + 1)])


def about_lines(sines=SINES_D):
    """Hints: W_k by sines, W_d = 0."""
    return [*sines, SINES_W, at_index(z, 1), shown_first(W_[d] == 0, [at_index(t, d), at_index(z, 1)])]


def not_late(b, start, last):
    """Hints: no slope ends with a step >= d."""
    return [*about_lines(), AGAIN, LENGTH, of_slope(b, start, j), by_ends(b, start), not_before(b, start), at_index(i, i), at_index(k, last), at_index(m, last - 1), at_index(i, last - d),
            at_index(h_, last - d), at_index(pit, d), unfolded(W_, 0), unfolded(U_, 0), *map(multiplied, (U_[d], U_[last - d], start * W_[last - d]))]


def apart(i, j):
    """Hints for i < j: U_i W_j - U_j W_i = W_(j-i)."""
    places = (h_ + 2, i + h_ + 2, h_ + 1, i + h_ + 1)
    return [by_induction(h_, 0, (U_[i] * W_[i + h_] - U_[i + h_] * W_[i] == W_[h_]) & (U_[i] * W_[i + h_ + 1] - U_[i + h_ + 1] * W_[i] == W_[h_ + 1]),
                         base=[LENGTH, at_index(pit, i), unfolded(W_, 0), unfolded(W_, 1), unfolded(U_, 0), unfolded(W_, i + 1), unfolded(U_, i + 1)],
                         step=[unfolded(x_, k_) for x_ in (U_, W_) for k_ in places]), at_index(h_, j - i), at_index(s, j - i)]


#: the slopes U_k/W_k, k < d, are different; the W_k are not 0; gamma_0^2 is positive
DIFFERENT = [W_NOT_ZERO, by_cases(first_ < second_, apart(first_, second_), [by_cases(second_ < first_, apart(second_, first_))])]
LISTED = [W_NOT_ZERO, at_index(s, s)]
TWO_EACH = [PYTHAGORAS, at_index(z, 1), by_cases(sine(1) ** 2 > 0), square_of(al0 - lam), square_of(al0 + lam)]


# ---------------------------------------------------------------------- orbits
def M(k):
    """M_k."""
    return U_[k] - al0 * W_[k]


ALIKE = by_induction(r, 0, iff(defined(al[r]), defined(ga[r])), base=[existing(al, 0), existing(ga, 0)], step=[existing(al, r + 1), existing(ga, r + 1)])
BY_LINES = by_induction(
    j, 0, (defined(al[j]) & defined(ga[j])) >> ((al[j] * M(j) == W_[j] - al0 * (2 * lam * W_[j] - U_[j])) & (M(j) != 0)), base=[*values_at(0), unfolded(U_, 0), unfolded(W_, 0)],
    step=[at_index(before, j), *(existing(x_, j + 1) for x_ in (al, ga)), unfolded(U_, j + 1), unfolded(W_, j + 1), by_cases(M(j + 1) == (2 * lam - al[j]) * M(j)),
          multiplied(M(j)), multiplied(al[j + 1] * M(j))])
NEVER_ZERO = by_induction(k, 0, defined(ga[k]) >> forall(c, 0, k, M(c) != 0), base=[at_index(j, 0), existing(al, 0)],
                          step=[existing(ga, k + 1), at_index(r, k + 1), at_index(j, k + 1), by_cases(c == k + 1), at_index(c, c)])


def at_end(last):
    """Hints: what the values at last - 1 are, and whether there are any at last."""
    return [*(existing(x_, last) for x_ in (al, ga)), at_index(r, last - 1), at_index(i, last - 1), at_index(j, last - 1), unfolded(U_, last), unfolded(W_, last),
            by_cases(al[last - 1] * (2 * lam - al[last - 1]) == 0), by_cases((2 * lam - al[last - 1]) * M(last - 1) == 0), by_cases(al[last - 1] == 2 * lam), multiplied(M(last - 1))]


def until(last):
    """Hints: the orbit exists until last - 1, if M_last = 0."""
    places = (k_ + 2, k_ + 1, last - k_, last - k_ - 1)
    backwards = by_induction(
        k_, 0, (k_ <= last - 1) >> ((M(last - k_) * W_[last] == W_[k_]) & (M(last - k_ - 1) * W_[last] == W_[k_ + 1])),
        base=[LENGTH, at_index(pit, last - 1), unfolded(W_, 0), unfolded(W_, 1), *(unfolded(x_, at) for x_ in (U_, W_) for at in (0, last)), multiplied(W_[last]), multiplied(U_[last - 1])],
        step=[*(unfolded(x_, at) for x_ in (U_, W_) for at in places), *map(multiplied, (W_[last], al0, al0 * W_[last], lam))])
    there = by_induction(
        m_, 0, (m_ <= last - 1) >> (defined(al[m_]) & defined(ga[m_])), base=[existing(al, 0), existing(ga, 0)],
        step=[at_index(i, m_), at_index(j, m_), at_index(m, m_ + 1), *(existing(x_, m_ + 1) for x_ in (al, ga)), unfolded(U_, m_ + 1), unfolded(W_, m_ + 1),
              by_cases(al[m_] * (2 * lam - al[m_]) == 0), by_cases(al[m_] == 2 * lam), multiplied(M(m_))])
    return [at_index(s, last), backwards, shown_first(forall(m, 1, last - 1, M(m) != 0), [at_index(k_, last - m), at_index(s, last - m)]), there, at_index(m_, last - 1)]


def ends_at(last, sines=SINES_D):
    """Hints: an orbit ends with step last if and only if M_last = 0 and last <= d - 2."""
    late = [at_index(k, last - 1), at_index(c, last - d), at_index(h_, last - d), at_index(pit, d), shown_first(U_[d - 1] == 0, [at_index(t, d - 1), at_index(z, 1)]), at_index(s, d - 1),
            unfolded(W_, 0), unfolded(U_, 0), existing(ga, last), by_cases(last == d - 1), by_cases(last == d), *map(multiplied, (U_[d], U_[last - d], al0, al0 * W_[d], al0 * W_[last - d]))]
    return [*about_lines(sines), W_NOT_ZERO, ON_CURVE, ONE_STEP, BY_LINES, ALIKE, AGAIN, LENGTH, NEVER_ZERO,
            by_cases(M(last) == 0, [by_cases(last <= d - 2, [*until(last), *at_end(last)], late)], at_end(last))]


# ---------------------------------------------------------------------- the list, as a statement
ends, listed, same, at_once, at_time, last = symbols("ends listed same_slope ends_at_once time last")
al_zero, ga_zero, ga_start = symbols("alpha_zero gamma_zero gamma_start")
#: theta = pi n/d; the points that end, by the slopes U_k/W_k of A^(-k) (0, 1)'; the points with alpha_0 = 0
ALL_ENDS = (*COPRIME, let(lam, cospi(n, d)), *LINES_BACK, *ORBIT, let(ends, leaves(at_time)), let(listed, (at_time <= d - 2) & (al0 * W_[at_time] == U_[at_time])),
            function(same, [i, j], U_[i] * W_[j] == U_[j] * W_[i]), let(last, d - 1),
            rec(al_zero, t, 0, al_zero[t] / (1 - ga_zero[t] ** 2)), rec(ga_zero, t, ga_start, -ga_zero[t] * al_zero[t] / (1 - ga_zero[t] ** 2)), let(at_once, leaves(1, ga_zero)))
THE_LIST = (iff(ends, listed) & iff(at_once, ga_start**2 == 1) & forall(first_, 1, last, forall(second_, 1, last, iff(same(first_, second_), first_ == second_)))
            & forall(s, 1, last, W_[s] != 0) & (ga0 != 0))
OF_LIST = dict(over={al0: nonzero(), ga0: scalar(), ga_start: scalar()})
OF_POINT = [standing("a step", at_time >= 1), given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 * lam * al0)]


def of_list(sines=SINES_D):
    """The evidence for the list, member by member."""
    return [arithmetic(*ends_at(at_time, sines), member=0), arithmetic(*(hint for k in (1, 0) for hint in values_at(k, al_zero, ga_zero)), member=1),
            arithmetic(*about_lines(sines), *DIFFERENT, member=2), arithmetic(*about_lines(sines), *LISTED, member=3), arithmetic(*sines, *TWO_EACH, member=4)]
