# SPDX-License-Identifier: MIT
"""Orbits on a hyperbola with a rational angle, for every fraction: hints for proofs with numbers.

Let 1/kappa = lambda = cos(theta), theta = pi n/d in lowest terms, and s_k = sin(k theta) = cos(pi (2kn - d)/(2d)), so that s_(k+1) + s_(k-1) = 2 lambda s_k,
lambda^2 + s_1^2 = 1, and s_k = 0 exactly for the multiples k of d. With K_j = (1 - pi_0) s_(j+1) - alpha_0 s_j the solution of the Riccati equation has

    (1 - pi_j) K_(j-1) = alpha_0 K_j:

it is back at time t when s_t ((1 - pi_0)^2 - 2 lambda alpha_0 (1 - pi_0) + alpha_0^2) = 0, and the second factor is positive. A line through (v_1, v_2)' is moved to
that through (v_1 s_(j+1) - v_2 s_j, v_1 s_j - v_2 s_(j-1))'.

For (3.10) let 1/kappa = -cos(2 pi q/p), S_k = sin(2 pi k q/p) = cos(pi (4kq - p)/(2p)), C_k = cos(2 pi k q/p) and E_j = S_(j+1) + alpha_0 S_j. Then

    alpha_j E_j = -(S_j + alpha_0 S_(j-1)),      gamma_j E_j = gamma_0 S_1,

and a return at time t makes E_t = S_1, as gamma_0 is not 0, and (1 + alpha_0^2 - 2 lambda alpha_0) S_t = gamma_0^2 S_t = 0, hence C_t = 1: p divides t q, and so t.

For q = 1 nothing that starts with alpha_0 > 1 ends. With c = C_1, S_j^2 + S_(j+1)^2 - 2c S_j S_(j+1) = S_1^2 = 1 - c^2, and 2 S_j^2 = 1 - cos(4 pi j/p) is 0 or at least 1 - c, as

    c - cos(4 pi j/p) = 2 sin((2j + 1) pi/p) sin((2j - 1) pi/p).

E_j = 0 makes S_j^2 (alpha_0^2 + 2c alpha_0 + 1) = 1 - c^2, hence (1 - c)(alpha_0 - 1)(alpha_0 + 1 + 2c) <= 0. And alpha_(j+1) does not exist only for alpha_j = 2 lambda, where E_(j+1) = 0.

For a slope x let M_j = U_j - x U_(j-1). Then b_j M_j = M_(j-1), whatever the angle is.
"""

from exactkf.evidence import angles, at_index, by_cases, by_induction, cleared, existing, multiplied, shown_first, square_of, unfolded
from exactkf.language import *
from proofs.blm91.consequences_angles import BEZOUT, BY_EUCLID, BY_INVERSE, EUCLID, LAST, NOT_ZERO, SMALLER, coprime_, d, gk, gu, gv, gx, gy, n, turns, x, y, z
from proofs.blm91.consequences_angles import s as sine
from proofs.blm91.notation import *

__all__ = [
    "LINES_BACK", "LINES_TURN", "LOWEST_PQ", "OF_ENDLESS", "OF_FORMS", "OF_KAPPA", "OF_LINES", "OF_POINTS", "OF_SOLUTIONS", "RISING",
    "SINES_1", "SINES_D", "U_", "U_FALLS", "W_", "X1", "X2", "by_ends", "ends_at", "not_before", "of_last", "of_slope", "pit", "v1", "v2",
    "w",
]

p, q, h_, c, before, pit, w, v1, v2, X1, X2 = symbols("p q h c before pi_t w v1 v2 V1 V2")


def three(k):
    """s_(k+1) + s_(k-1) = 2 lambda s_k."""
    return angles("product", 2 * n, 2 * k * n - d, 2 * d)


#: where s_k is zero, in lowest terms; for n = 1
SINES_D = [shown_first(EUCLID, BY_INVERSE), shown_first(NOT_ZERO, BY_EUCLID), shown_first(sine(d) == 0, LAST)]
SINES_1 = [shown_first(EUCLID, [by_cases(y >= 1)]), shown_first(NOT_ZERO, BY_EUCLID),
           shown_first(sine(d) == 0, [angles("right", d), angles("cosines", 2 * d * n - d, d, 2 * d), at_index(turns, 0)])]
PYTHAGORAS = shown_first(lam**2 + sine(1) ** 2 == 1, [angles("product", 2 * n, 2 * n, 2 * d), angles("product", 2 * n - d, 2 * n - d, 2 * d),
                                                    angles("product", 4 * n - d, d, 2 * d), angles("right", d)])
NO_FIXED = [PYTHAGORAS, at_index(z, 1), by_cases(sine(1) ** 2 > 0)]


# ---------------------------------------------------------------------- solutions of the Riccati equation
def K_(k):
    """K_k."""
    return (1 - w) * sine(k + 1) - al0 * sine(k)


SOLUTION = by_induction(
    j, 0, defined(pit[j]) >> (((1 - pit[j]) * K_(j - 1) == al0 * K_(j)) & (K_(j - 1) != 0)),
    base=[cleared(), *values_at(0, pit), three(0), angles("right", d), at_index(z, 1), by_cases(K_(-1) == -al0 * sine(0))],
    step=[cleared(), *values_at(j + 1, pit), three(j), three(j + 1), by_cases(K_(j + 1) == 2 * lam * K_(j) - K_(j - 1)),
          by_cases(pit[j] == 1, [], [by_cases((1 - pit[j + 1]) * (1 - pit[j]) == 2 * lam * al0 * (1 - pit[j]) - al0**2)]),
          *map(multiplied, (K_(j), K_(j - 1), 1 - pit[j], al0, (1 - pit[j]) * K_(j), (1 - pit[j]) ** 2 * K_(j)))])
NOT_AT_REST = shown_first((1 - w) ** 2 - 2 * lam * al0 * (1 - w) + al0**2 > 0, [*NO_FIXED, square_of(1 - w - lam * al0), by_cases(al0**2 > 0), multiplied(al0**2)])
#: when a solution is back
OF_SOLUTIONS = [SOLUTION, NOT_AT_REST, at_index(j, t), at_index(z, t), three(t), by_cases(sine(t) == 0), multiplied(1 - w), multiplied(al0)]

# ---------------------------------------------------------------------- lines
LINES_TURN = (rec(X1, t, v1, 2 * lam * X1[t] - X2[t]), rec(X2, t, v2, X1[t]))
LINE = by_induction(j, 0, (X1[j] * sine(1) == v1 * sine(j + 1) - v2 * sine(j)) & (X2[j] * sine(1) == v1 * sine(j) - v2 * sine(j - 1)),
                    base=[unfolded(X1, 0), unfolded(X2, 0), three(0), angles("right", d)], step=[unfolded(X1, j + 1), unfolded(X2, j + 1), three(j + 1), three(j)])
NO_EIGENVECTOR = shown_first(v1**2 - 2 * lam * v1 * v2 + v2**2 > 0, [
    *NO_FIXED, *(by_cases(v_**2 > 0) for v_ in (v1, v2)), *(multiplied(v_**2) for v_ in (v1, v2)), square_of(v1 - lam * v2), square_of(v2 - lam * v1)])
#: when a line is back, at time k
OF_LINES = [LINE, PYTHAGORAS, NO_EIGENVECTOR, at_index(j, k), at_index(z, k), at_index(z, 1), three(k), by_cases(sine(k) == 0), *map(multiplied, (v1, v2, sine(1))),
            by_cases(X1[k] * v2 * sine(1) == X2[k] * v1 * sine(1))]

# ---------------------------------------------------------------------- points of the plane
LOWEST_PQ = [standing("angle", (q >= 1) & (2 * q < p)), given("lowest terms", coprime_(q, p))]


def S_(k):
    """S_k."""
    return cospi(4 * k * q - p, 2 * p)


def E_(k):
    """E_k."""
    return S_(k + 1) + al0 * S_(k)


def three_(k):
    """S_(k+1) + S_(k-1) = 2 C_1 S_k."""
    return angles("product", 4 * q, 4 * k * q - p, 2 * p)


C_H = cospi(2 * h_ * q, p)
IN_LOWEST = shown_first(forall(x, 1, p - 1, forall(y, 0, q, x * q != p * y)),
                        [BEZOUT, at_index(gk, q + p), at_index(gx, q), at_index(gy, p), *SMALLER[:3], by_cases(gu * y - gv * x >= 1)])
POSITIVE = shown_first(S_(1) > 0, [angles("acute", 4 * q - p, 2 * p)])
PYTHAGORAS_ = shown_first(cospi(2 * q, p) ** 2 + S_(1) ** 2 == 1, [angles("product", 4 * q, 4 * q, 2 * p), angles("product", 4 * q - p, 4 * q - p, 2 * p),
                                                                    angles("product", 8 * q - p, p, 2 * p), angles("right", p)])
MOVING = shown_first(ga0**2 > 0, [PYTHAGORAS_, by_cases(S_(1) ** 2 > 0), square_of(al0 - lam)])
ROUND = shown_first(1 + al0**2 - 2 * lam * al0 > 0, [PYTHAGORAS_, by_cases(S_(1) ** 2 > 0), square_of(al0 - lam)])
ON_CURVE = by_induction(i, 0, defined(al[i]) >> ((1 + al[i] ** 2 - ga[i] ** 2 == 2 * lam * al[i]) & (al[i] != 0)),
                        base=[cleared(), *values_at(0)], step=[cleared(), *values_at(i + 1), multiplied(ga[i] ** 2)])


def one_step(k):
    """Hints: alpha_(k+1) (2 lambda - alpha_k) = 1, gamma_(k+1) (2 lambda - alpha_k) = -gamma_k."""
    return [cleared(), at_index(i, k), *values_at(k + 1), by_cases(1 - ga[k] ** 2 == al[k] * (2 * lam - al[k])), multiplied(al[k]), multiplied(ga[k])]


ONE_STEP = by_induction(before, 0, (defined(al[before + 1]) & defined(ga[before + 1])) >> ((al[before + 1] * (2 * lam - al[before]) == 1) & (ga[before + 1] * (2 * lam - al[before]) == -ga[before])),
                        base=one_step(0), step=one_step(before + 1))
CLOSED_FORM = by_induction(
    j, 0, (defined(al[j]) & defined(ga[j])) >> ((al[j] * E_(j) == -(S_(j) + al0 * S_(j - 1))) & (ga[j] * E_(j) == ga0 * S_(1)) & (E_(j) != 0)),
    base=[*values_at(0), three_(0), angles("right", p), POSITIVE],
    step=[at_index(before, j), *(existing(x_, j + 1) for x_ in (al, ga)), three_(j + 1), three_(j), by_cases(E_(j + 1) == -(2 * lam - al[j]) * E_(j)),
          *map(multiplied, (E_(j), al[j + 1] * E_(j), ga[j + 1] * E_(j)))])
FULL_TURN = shown_first(
    forall(h_, 1, p, ((S_(h_ + 1) + al0 * S_(h_) == S_(1)) & (al0 * S_(1) == -(S_(h_) + al0 * S_(h_ - 1)))) >> ((S_(h_) == 0) & (C_H == 1))),
    [three_(h_), angles("product", 4 * h_ * q, 4 * q - p, 2 * p), angles("product", 4 * (h_ - 1) * q, p, 2 * p), angles("right", p), ROUND,
     by_cases((1 + al0**2 - 2 * lam * al0) * S_(h_) == 0), by_cases(S_(h_) == 0), *map(multiplied, (al0, S_(h_), al0 * (S_(1) + S_(h_ - 1)))),
     by_cases((1 - C_H) * S_(1) == 0)])
AFTER_P = shown_first((S_(p) == 0) & (S_(p + 1) == S_(1)) & (S_(p - 1) == -S_(1)),
                      [angles("right", p), angles("cosines", 4 * p * q - p, p, 2 * p), angles("cosines", 4 * (p + 1) * q - p, 4 * q - p, 2 * p),
                       angles("cosines", 4 * (p - 1) * q - p, 4 * q + p, 2 * p), angles("product", 4 * q, p, 2 * p), at_index(turns, q)])
#: s_j M_j S_1 = E_j: the closed form without division
LINEAR_FORM = by_induction(
    j, 0, (sg[j] * Mt[j] * S_(1) == E_(j)) & (sg[j] * Nt[j] * S_(1) == -(S_(j) + al0 * S_(j - 1))),
    base=[*(unfolded(x_, 0) for x_ in (Mt, Nt, sg)), three_(0), angles("right", p)],
    step=[*(unfolded(x_, j + 1) for x_ in (Mt, Nt, sg)), three_(j + 1), three_(j), *map(multiplied, (al0, lam))])
#: when the closed form is that of the start again
OF_FORMS = [IN_LOWEST, POSITIVE, LINEAR_FORM, FULL_TURN, by_cases(t == p, [AFTER_P, at_index(j, p)], [at_index(j, t), at_index(h_, t), angles("cosines", 2 * t * q, 0, p), at_index(x, t), at_index(y, turns)]), multiplied(S_(1))]
#: it is back with E_t = S_1
RETURNS = [FULL_TURN, by_cases(t == p, [AFTER_P, at_index(j, p)],
                               [at_index(j, t), by_cases(E_(t) == S_(1)), multiplied(ga0), at_index(h_, t), angles("cosines", 2 * t * q, 0, p), at_index(x, t), at_index(y, turns)]),
           multiplied(S_(1))]
#: -cos(2 pi q/p) in both of its forms
OF_KAPPA = [shown_first(cospi(p - 2 * q, p) == -cospi(2 * q, p), [angles("product", p, p - 4 * q, 2 * p), angles("right", p)]), shown_first(lam == -cospi(2 * q, p))]
#: when a point is back
OF_POINTS = [IN_LOWEST, POSITIVE, ON_CURVE, ONE_STEP, CLOSED_FORM, PYTHAGORAS_, MOVING, *RETURNS]

# ---------------------------------------------------------------------- points that never end, for q = 1
IN_LOWEST_1 = shown_first(forall(x, 1, p - 1, forall(y, 0, q, x * q != p * y)), [by_cases(y >= 1)])
#: 2 S_k^2 = 1 - cos(4k pi q/p) is 0 or at least 1 - cos(2 pi q/p)
DOUBLED = [angles("product", 4 * h_ * q - p, 4 * h_ * q - p, 2 * p), angles("product", 8 * h_ * q - p, p, 2 * p), angles("right", p),
           angles("product", 4 * h_ + 2 - p, 4 * h_ - 2 - p, 2 * p)]
HALF_TURN = [angles("product", 4 * h_ + 2 - 2 * p, p, 2 * p), angles("product", 4 * h_ - 2 - 2 * p, p, 2 * p), angles("acute", 4 * h_ + 2 - 3 * p, 2 * p), angles("acute", 4 * h_ - 2 - 3 * p, 2 * p)]
NOT_SMALL = shown_first(forall(h_, 1, p, (S_(h_) == 0) | (2 * S_(h_) ** 2 >= 1 - cospi(2 * q, p))),
                        [*DOUBLED, by_cases(2 * h_ < p, [angles("acute", 4 * h_ + 2 - p, 2 * p), angles("acute", 4 * h_ - 2 - p, 2 * p)],
                                            [by_cases(2 * h_ == p, [], [by_cases(h_ == p, [AFTER_P], HALF_TURN)])])])
CASSINI = by_induction(k, 0, S_(k + 1) ** 2 - 2 * cospi(2 * q, p) * S_(k) * S_(k + 1) + S_(k) ** 2 == S_(1) ** 2,
                       base=[angles("right", p)], step=[three_(k + 1), multiplied(S_(k + 1)), multiplied(S_(k)), multiplied(S_(k + 2))])
BEYOND_ONE = shown_first(forall(z, 1, p, E_(z) != 0), [
    PYTHAGORAS_, NOT_SMALL, CASSINI, at_index(h_, z), at_index(k, z), by_cases(S_(z) == 0), multiplied(S_(z)), multiplied(S_(z + 1)), multiplied(al0),
    by_cases(cospi(2 * q, p) < 1), by_cases(cospi(2 * q, p) > -1), by_cases(S_(z) ** 2 * (al0**2 + 2 * al0 * cospi(2 * q, p) + 1) == S_(1) ** 2),
    by_cases((al0 - 1) * (al0 + 1 + 2 * cospi(2 * q, p)) > 0), by_cases(al0**2 + 2 * al0 * cospi(2 * q, p) + 1 > 0),
    by_cases((1 - cospi(2 * q, p)) * (al0 - 1) * (al0 + 1 + 2 * cospi(2 * q, p)) > 0)])

#: the orbit exists up to time p, as E_k is not 0
ENDLESS = by_induction(c, 0, (c <= p) >> (defined(al[c]) & defined(ga[c])), base=[*values_at(0)],
                       step=[at_index(i, c), at_index(j, c), at_index(z, c + 1), *(existing(x_, c + 1) for x_ in (al, ga)), three_(c), three_(c + 1), by_cases(al[c] * (2 * lam - al[c]) == 0),
                             by_cases(al[c] == 2 * lam), *map(multiplied, (al0, E_(c)))])
#: from alpha_0 > 1, for q = 1: the orbit exists, and when it is back
OF_ENDLESS = [IN_LOWEST_1, POSITIVE, BEYOND_ONE, ON_CURVE, ONE_STEP, CLOSED_FORM, PYTHAGORAS_, MOVING, ENDLESS, at_index(c, p), at_index(c, t), *RETURNS]

# ---------------------------------------------------------------------- slopes, for any angle
U_, W_ = symbols("U U_before")


#: for lambda > 1: U_h > U_(h-1) >= 0; U_s U_s - U_(s+1) U_(s-1) = 1; U_i/U_(i-1) falls
RISING = by_induction(h, 0, (W_[h] >= 0) & (U_[h] >= W_[h] + 1), base=[unfolded(U_, 0), unfolded(W_, 0)],
                      step=[by_cases((lam - 1) * U_[h] >= 0), unfolded(U_, h + 1), unfolded(W_, h + 1)])
CASSINI = by_induction(s, 0, U_[s] * W_[s + 1] - U_[s + 1] * W_[s] == 1, base=[unfolded(U_, 0), unfolded(W_, 0), unfolded(U_, 1), unfolded(W_, 1)],
                       step=[*(unfolded(x_, s + k_) for k_ in (1, 2) for x_ in (U_, W_))])
FALLING = by_induction(t, 1, forall(i, 1, t, U_[i] * W_[t] >= U_[t] * W_[i]) & forall(i, 1, t - 1, U_[i] * W_[t] > U_[t] * W_[i]), base=[at_index(i, i)],
                       step=[at_index(i, i), at_index(h, t - 1), at_index(h, i - 1), at_index(s, t), at_index(h, t), unfolded(W_, t), unfolded(W_, t + 1), unfolded(W_, i), by_cases(i == t + 1),
                             multiplied(U_[i - 1])])
U_FALLS = [RISING, CASSINI, FALLING]


def of_slope(b, start, index):
    """Hints: b_j M_j = M_(j-1), and M_j is not 0, while the slope exists."""
    M, before = U_[index] - start * W_[index], W_[index] - start * (2 * lam * W_[index] - U_[index])
    return by_induction(index, 0, defined(b[index]) >> ((b[index] * M == before) & (M != 0)),
                        base=[cleared(), *values_at(0, b), unfolded(U_, 0), unfolded(W_, 0)],
                        step=[cleared(), *values_at(index + 1, b), unfolded(U_, index + 1), unfolded(W_, index + 1), multiplied(M), by_cases(b[index] * M == before),
                              by_cases(b[index] == 2 * lam)])


def by_ends(b, start):
    """Hints: a slope that ends within k steps is U_i/U_(i-1) for some i <= k."""
    return by_induction(k, 0, (~exists(i, 1, k, U_[i] == start * W_[i])) >> defined(b[k]), base=[cleared(), *values_at(0, b)],
                        step=[cleared(), existing(b, k + 1), at_index(j, k), unfolded(U_, k + 1), unfolded(W_, k + 1), at_index(i, k + 1), at_index(i, i)])


def not_before(b, start):
    """Hints: a slope that exists after m steps is U_i/U_(i-1) for no i <= m."""
    return by_induction(m, 0, defined(b[m]) >> forall(i, 1, m, U_[i] != start * W_[i]), base=[cleared(), *values_at(0, b)],
                        step=[cleared(), existing(b, m + 1), at_index(j, m + 1), at_index(i, i), by_cases(i == m + 1)])


# v_k = A^(-k) (0, 1)' = (W_k, U_k)'
LINES_BACK = (rec(U_, t, 1, 2 * lam * U_[t] - W_[t]), rec(W_, t, 0, U_[t]))
LENGTH = by_induction(pit, 0, U_[pit] ** 2 - 2 * lam * U_[pit] * W_[pit] + W_[pit] ** 2 == 1, base=[unfolded(U_, 0), unfolded(W_, 0)], step=[unfolded(U_, pit + 1), unfolded(W_, pit + 1)])


def of_last(b, start, last):
    """Hints: with M_last = 0, M_(last-k) W_last = W_k, so that the slope exists until then; and the slope ends with the first k for which M_k = 0."""
    def M(k):
        return U_[k] - start * W_[k]

    backwards = by_induction(
        c, 0, (c <= last - 1) >> ((M(last - c) * W_[last] == W_[c]) & (M(last - c - 1) * W_[last] == W_[c + 1])),
        base=[LENGTH, at_index(pit, last - 1), unfolded(W_, 0), unfolded(W_, 1), *(unfolded(x_, k_) for x_ in (U_, W_) for k_ in (0, last)), multiplied(W_[last]), multiplied(U_[last - 1])],
        step=[*(unfolded(x_, k_) for x_ in (U_, W_) for k_ in (c + 2, c + 1, last - c, last - c - 1)), *map(multiplied, (W_[last], start, start * W_[last], lam))])
    slopes = [of_slope(b, start, j), by_ends(b, start), not_before(b, start), at_index(i, i)]
    return [by_cases(M(last) == 0, [backwards, *slopes, at_index(k, last - 1), at_index(m, last), at_index(i, last), at_index(c, last - i), at_index(s, last - i)],
                     [*slopes, at_index(k, last), at_index(m, last - 1), at_index(s, last)]), multiplied(W_[last]), multiplied(start)]


def ends_at(b, start, n):
    """Hints: a slope ends at step n >= 1 exactly for start = U_n/U_(n-1), for lambda > 1."""
    return [*U_FALLS, of_slope(b, start, j), by_ends(b, start), not_before(b, start), existing(b, n), at_index(h, n - 1), *(at_index(i_, n - 1) for i_ in (j, k)),
            *(at_index(i_, n) for i_ in (t, m, i)), at_index(i, i), unfolded(U_, n), unfolded(W_, n), multiplied(W_[i]), multiplied(U_[n - 1]), cleared()]
