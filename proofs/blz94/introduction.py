# SPDX-License-Identifier: MIT
"""Abstract and introduction: what is announced about orders one and n.

The Riccati recursion moves a symmetric matrix, with n(n + 1)/2 entries, the fast algorithm two vectors, with 2n. For n = 1 the points that do not
converge lie on the curves 1 + alpha^2 - gamma^2 = (2/kappa) alpha with kappa^2 > 1, where a step is a rotation: by a rational angle all orbits that
do not escape have one period, by another angle they are dense.
"""

from exactkf.claims import claim
from exactkf.evidence import evaluation, instances, steps
from exactkf.language import cospi, function, let, scalar, standing, sum_of, symbols, when
from proofs.blz94.notation import HALF, alpha, gamma, i, j, k, n
from proofs.blz94.section_8 import CURVE_B, D_ONE, DEFINITE, ONE, al, e, ga

f, p, w, x, y = symbols("f p w x y")

claim("BLZ94-S3", "numbers of variables of the Riccati recursion and of the fast algorithm",
      (sum_of(i, 1, n, sum_of(j, i, n, 1)) == n * (n + 1) / 2) & (sum_of(i, 1, n, 1) + sum_of(i, 1, n, 1) == 2 * n), sizes=["n"],
      by=[evaluation(n=range(1, 21)), instances(n=range(1, 9))],
      note="The entries i <= j of a symmetric matrix, and those of two vectors of length n. That P_t stays symmetric is a part of E6.4.")

#: n = 1: the point with alpha - gamma = x on the curve with angle pi/p, and the first time at which the orbit is back there
_RETURN = (let(e, -cospi(2, p)), let(al, HALF * (x + CURVE_B)), let(ga, HALF * (CURVE_B - x)), *ONE, *D_ONE,
           function(f, [k], when(alpha[k] - gamma[k] == x, k, f(k + 1))), let(w, f(1)), let(y, when(DEFINITE, 0, 1)))
_BY = steps("BLZ94-E8.4", "BLZ94-X.9", facts=["sin(t pi q/p) = 0 for coprime q, p if and only if p divides t",
        "Kronecker: the multiples of an irrational angle are dense in the circle"],
            prose="By X.9 the orbit is back at time t exactly if sin(t phi) = 0, with phi = pi/p; every x gives another point. Arbitrarily near are curves "
                  "with irrational angle, whose orbits escape or are "
                  "dense in the curve, and so are unbounded.")
claim("BLZ94-S1", "periodic points of every period beyond three, where there is no convergence", (w == p) & (y == 1), sizes=["p"], over={x: scalar()},
      where=_RETURN,
      given=[standing("p > 3", p > 3)], by=[_BY, instances(16, p=(4, 5, 6, 7, 8))],
      note="Period three occurs too. y = 1 says that D is not sign definite, so the orbits do not converge.")

claim("BLZ94-S2", "n = 1: infinitely many points of each period from three on among those that do not converge", (w == p) & (y == 1), sizes=["p"],
      over={x: scalar()}, where=_RETURN,
      given=[standing("p > 2", p > 2)], by=[_BY, instances(16, p=(3, 4, 5, 6, 7))],
      note="y = 1 says that D is not sign definite. x is free, so there are infinitely many points of each period.")
