# SPDX-License-Identifier: MIT
"""Rational angles n/d of pi in lowest terms, for every denominator.

On the hyperbola with 1/kappa = cos(theta), theta = pi n/d, (n, d) = 1, everything about orbits that end hangs on the numbers
U_j = sin((j + 1) theta)/sin(theta). With s_k = sin(k theta) = cos(pi (2kn - d)/(2d))

    U_j s_1 = s_(j+1)                  by 2 cos(a) cos(b) = cos(a + b) + cos(a - b),
    s_k = 0  <=>  d divides k n,       cosines are equal if sum or difference of the angles is a full turn,
    s_k^2 = s_1^2  <=>  d divides (k - 1) n or (k + 1) n.

As n has an inverse modulo d (Bezout), d divides k n only if it divides k: multiplication by n permutes the residues modulo d. Hence, for
0 <= j < d, U_j is 0 for j = d - 1 alone, and 1 or -1 for j = 0 and j = d - 2 alone.
"""

from exactkf.claims import claim
from exactkf.evidence import angles, arithmetic, at_index, by_cases, by_induction, by_rests, example, instances, shown_first, unfolded
from exactkf.language import *
from proofs.blm91.notation import CHEBYSHEV, Ut, lam

n, d, e, i, i1, h, j, k, x, y, t, turns = symbols("n d e i i1 h j k x y t turns")
divides, coprime_, S = symbols("divides coprime S")
gk, gx, gy, gu, gv = symbols("total first second u v")

DIVIDES = function(divides, [e, x], exists(i, 1, x, e * i == x))
COPRIME = (DIVIDES, function(coprime_, [x, y], forall(e, 2, y, ~(divides(e, y) & divides(e, x)))))

# ---------------------------------------------------------------------- Bezout
INVERSE = exists(gu, 1, gy, exists(gv, 0, gx, gu * gx == 1 + gv * gy))
#: by induction on x + y: (x, y) -> (x - y, y) or (x, y - x)
SMALLER = [at_index(e, e), at_index(i, i), at_index(i, i1), at_index(i, i + i1)]
EQUAL = [by_cases(gx == 1, [at_index(gu, 1), at_index(gv, 0)], [at_index(e, gx), at_index(i, 1)])]
FIRST_LARGER = [at_index(gx, gx - gy), at_index(gy, gy), *SMALLER, at_index(gu, gu), at_index(gv, gu + gv)]
SECOND_LARGER = [at_index(gx, gx), at_index(gy, gy - gx), *SMALLER, at_index(gu, gu + gv), at_index(gv, gv)]
BEZOUT = by_induction(gk, 0, forall(gx, 1, gk, forall(gy, 1, gk, ((gx + gy <= gk) & coprime_(gx, gy)) >> INVERSE)),
                      step=[by_cases(gx == gy, EQUAL, [by_cases(gx > gy, FIRST_LARGER, SECOND_LARGER)])])
INVERTED = [BEZOUT, at_index(gk, n + d), at_index(gx, n), at_index(gy, d), *SMALLER[:3]]
claim("BLM91-X.17", "numbers without a common divisor have a combination that is 1", exists(gu, 1, d, exists(gv, 0, n, gu * n == 1 + gv * d)), sizes=["n", "d"], where=COPRIME,
      given=[standing("positive", (n >= 1) & (d >= 1)), given("lowest terms", coprime_(n, d))],
      by=[arithmetic(*INVERTED, at_index(gu, gu), at_index(gv, gv), at_index(gu, d), at_index(gv, n)), instances(n=range(1, 8), d=range(1, 8)), example(n=4, d=6), example(n=9, d=5)],
      note="Bezout, in the form that is used below: u n = 1 + v d with 1 <= u <= d and 0 <= v <= n.")

# ---------------------------------------------------------------------- which U_j are 0, 1, -1
LOWEST = [standing("angle", (n >= 1) & (n < d)), given("lowest terms", coprime_(n, d))]
ANGLE = (*COPRIME, let(lam, cospi(n, d)), CHEBYSHEV)


def s(k):
    """sin(k theta)."""
    return cospi(2 * k * n - d, 2 * d)


#: x n is no multiple of d for 0 < x < d: with u n = 1 + v d it would make x = d (u y - v x)
EUCLID = forall(x, 1, d - 1, forall(y, 0, n, x * n != d * y))
BY_INVERSE = [*INVERTED, by_cases(gu * y - gv * x >= 1)]
#: s_x = cos(pi/2) leaves x n = d (1 + 2 turns) or x n = 2 d turns
NOT_ZERO = forall(x, 1, d - 1, s(x) != 0)
BY_EUCLID = [angles("right", d), angles("cosines", 2 * x * n - d, d, 2 * d), at_index(x, x), at_index(y, 1 + 2 * turns), at_index(y, 2 * turns)]
LAST = [angles("right", d), angles("cosines", 2 * d * n - d, d, 2 * d), by_rests(n, 2, h, [[at_index(turns, h)], [at_index(turns, h)]])]
#: 2 s_x^2 = 1 + cos(2x theta - pi)
SQUARES = forall(x, 1, d - 1, iff(s(x) ** 2 == s(1) ** 2, (x == 1) | (x == d - 1)))
BY_SQUARES = [angles("product", 2 * x * n - d, 2 * x * n - d, 2 * d), angles("product", 2 * n - d, 2 * n - d, 2 * d), angles("cosines", 2 * x * n - d, 2 * n - d, d),
              at_index(x, x - 1), at_index(x, x + 1), at_index(y, turns), at_index(y, turns + 1), at_index(turns, n - 1), at_index(turns, 0)]
#: U_t s_1 = s_(t+1), for t and t + 1
SINES = by_induction(t, 0, (Ut[t] * s(1) == s(t + 1)) & (Ut[t + 1] * s(1) == s(t + 2)),
                     base=[unfolded(Ut, 0), unfolded(Ut, 1), angles("right", d), angles("product", 2 * n, 2 * n - d, 2 * d)],
                     step=[unfolded(Ut, t + 2), angles("product", 2 * n, 2 * (t + 2) * n - d, 2 * d)])
claim("BLM91-X.10", "where U_j is 0, 1 or -1, for every rational angle", forall(j, 0, d - 1, iff(Ut[j] == 0, j == d - 1) & iff((Ut[j] == 1) | (Ut[j] == -1), (j == 0) | (j == d - 2))),
      sizes=["n", "d"], where=ANGLE, given=LOWEST,
      by=[arithmetic(shown_first(EUCLID, BY_INVERSE), shown_first(NOT_ZERO, BY_EUCLID), shown_first(s(d) == 0, LAST), shown_first(SQUARES, BY_SQUARES), SINES, at_index(t, j), at_index(x, j + 1),
                     at_index(x, 1), by_cases(s(j + 1) == s(1)), by_cases(s(j + 1) == -s(1))), instances(n=range(1, 10), d=range(2, 12))])
