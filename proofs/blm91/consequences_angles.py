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
from exactkf.evidence import angles, arithmetic, at_index, by_cases, by_induction, by_rests, example, instances, multiplied, shown_first, unfolded
from exactkf.language import *
from proofs.blm91.notation import CHEBYSHEV, ORBIT, Ut, al, al0, ga, ga0, lam

n, d, e, i, i1, h, j, k, x, y, z, b, c, f, g, t, turns = symbols("n d e i i1 h j k x y z b c f g t turns")
divides, coprime_, S = symbols("divides coprime S")
gk, gx, gy, gu, gv = symbols("total one other u v")

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
#: s_z = cos(pi/2) leaves z n = d (1 + 2 turns) or z n = 2 d turns
NOT_ZERO = forall(z, 1, d - 1, s(z) != 0)
BY_EUCLID = [angles("right", d), angles("cosines", 2 * z * n - d, d, 2 * d), at_index(x, z), at_index(y, 1 + 2 * turns), at_index(y, 2 * turns)]
LAST = [angles("right", d), angles("cosines", 2 * d * n - d, d, 2 * d), by_rests(n, 2, h, [[at_index(turns, h)], [at_index(turns, h)]])]
#: 2 s_b^2 = 1 + cos(2b theta - pi)
SQUARES = forall(b, 1, d - 1, iff(s(b) ** 2 == s(1) ** 2, (b == 1) | (b == d - 1)))
BY_SQUARES = [angles("product", 2 * b * n - d, 2 * b * n - d, 2 * d), angles("product", 2 * n - d, 2 * n - d, 2 * d), angles("cosines", 2 * b * n - d, 2 * n - d, d),
              at_index(x, b - 1), at_index(x, b + 1), at_index(y, turns), at_index(y, turns + 1), at_index(turns, n - 1), at_index(turns, 0)]
#: U_t s_1 = s_(t+1), for t and t + 1
SINES = by_induction(t, 0, (Ut[t] * s(1) == s(t + 1)) & (Ut[t + 1] * s(1) == s(t + 2)),
                     base=[unfolded(Ut, 0), unfolded(Ut, 1), angles("right", d), angles("product", 2 * n, 2 * n - d, 2 * d)],
                     step=[unfolded(Ut, t + 2), angles("product", 2 * n, 2 * (t + 2) * n - d, 2 * d)])
none, unit, first, last = symbols("none unit first last")
NAMED = (let(last, d - 1), function(none, [j], Ut[j] == 0), function(unit, [j], (Ut[j] == 1) | (Ut[j] == -1)), function(first, [j], j == 0))
ABOUT_SINES = [shown_first(EUCLID, BY_INVERSE), shown_first(NOT_ZERO, BY_EUCLID), shown_first(s(d) == 0, LAST), shown_first(SQUARES, BY_SQUARES), SINES]
claim("BLM91-X.10", "where U_j is 0, 1 or -1, for every rational angle", forall(j, 0, last, iff(none(j), j == last) & iff(unit(j), (j == last - 1) | first(j))), sizes=["n", "d"],
      where=[*ANGLE, *NAMED], given=LOWEST,
      by=[arithmetic(*ABOUT_SINES, at_index(t, j), at_index(z, j + 1), at_index(b, j + 1), at_index(z, 1), by_cases(s(j + 1) == s(1)), by_cases(s(j + 1) == -s(1))), instances(n=range(1, 10), d=range(2, 12))],
      note="1/kappa = cos(pi n/d), every fraction n/d between 0 and 1 in lowest terms.")

# ---------------------------------------------------------------------- the orbits that end
tau = sym("tau")
HERE = (*ANGLE, let(al0, Ut[k] / Ut[k - 1]), let(ga0, 1 / Ut[k - 1]), *ORBIT, let(last, when(k == d - 1, 0, k - 1)))
u0, u1, u2 = Ut[k - 2 - tau], Ut[k - 1 - tau], Ut[k - tau]
A, G, A1, G1 = al[tau], ga[tau], al[tau] / (1 - ga[tau] ** 2), -ga[tau] * al[tau] / (1 - ga[tau] ** 2)
CASSINI = by_induction(c, 0, Ut[c + 1] ** 2 - Ut[c] * Ut[c + 2] == 1, base=[unfolded(Ut, 0), unfolded(Ut, 1), unfolded(Ut, 2)], step=[unfolded(Ut, c + 2), unfolded(Ut, c + 3)])
U_NOT_ZERO = shown_first(forall(g, 0, d - 2, Ut[g] != 0), [at_index(t, g), at_index(z, g + 1)])
U_UNIT = shown_first(forall(f, 0, d - 2, iff(Ut[f] ** 2 == 1, (f == 0) | (f == d - 2))),
                     [unfolded(Ut, 0), at_index(t, f), at_index(b, f + 1), at_index(z, 1), by_cases((Ut[f] ** 2 - 1) * s(1) == 0), multiplied(s(1) ** 2), multiplied(Ut[f] * s(1)), multiplied(s(f + 1))])
#: alpha_t = u2/u1 and gamma_t^2 = 1/u1^2, hence 1 - gamma_t^2 = u0 u2/u1^2
ORBIT_OF = by_induction(
    tau, 0, ((tau <= k - 1) & (k <= d - 2)) >> ((A * u1 == u2) & ((G * u1) ** 2 == 1)),
    base=[unfolded(al, 0), unfolded(ga, 0), unfolded(Ut, 0), at_index(g, k - 1), angles("quotient", Ut[k], Ut[k - 1]), angles("quotient", 1, Ut[k - 1]),
          multiplied(Ut[k - 1]), multiplied(ga[0] * Ut[k - 1])],
    step=[at_index(g, k - 2 - tau), at_index(g, k - tau), at_index(c, k - 2 - tau), by_cases(u0 > 0), by_cases(u2 > 0), unfolded(al, tau + 1), unfolded(ga, tau + 1),
          by_cases((1 - G**2) * u1**2 == u0 * u2), by_cases(1 - G**2 == 0, [multiplied(u1**2)]), by_cases(1 - G**2 > 0), angles("quotient", A, 1 - G**2),
          angles("quotient", -G * A, 1 - G**2), by_cases(A1 * u0 * u2 == u1 * u2), by_cases(A1 * u0 == u1), by_cases((G1 + G * A1) * (1 - G**2) == 0),
          by_cases(G1 == -G * A1), *map(multiplied, (G**2 * A1 * u0, G**2 * u1, u1**2, A1, u1))])
LAST_POINT = [unfolded(ga, 0), at_index(f, k - 1), at_index(g, k - 1), angles("quotient", 1, Ut[k - 1]), multiplied(Ut[k - 1]), multiplied(ga[0] * Ut[k - 1])]
claim("BLM91-X.18", "after how many steps the listed points end, for every rational angle", forall(j, 0, last, iff(ga[j] ** 2 == 1, j == last)), sizes=["n", "d", "k"], where=HERE,
      given=[*LOWEST, standing("which point", (k >= 1) & (k < d))],
      by=[arithmetic(*ABOUT_SINES, CASSINI, U_NOT_ZERO, U_UNIT, ORBIT_OF, by_cases(k == d - 1, LAST_POINT, [at_index(tau, j), at_index(f, k - 1 - j)]), multiplied(Ut[k - 1 - j]**2), multiplied(ga[j]**2)),
          instances(n=range(1, 8), d=range(2, 10), k=range(1, 8))],
      note="The points (U_k, +-1)/U_(k-1), k = 1, .., d - 1, of the hyperbola with 1/kappa = cos(pi n/d); (3.10) divides by zero where gamma^2 = 1. So the k-th point ends with step k, but at once for k = d - 1: with mirror images "
           "four points end at step 1 (two for d = 2), two at each of the steps 2, .., d - 2, and none later. That no others end is (5.1'): a slope that ends at step i is U_i/U_(i-1), and U_(d-1) = 0 (X.10) closes the list.")
