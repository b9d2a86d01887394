# SPDX-License-Identifier: MIT
"""Section 7: remarks on singular points and on the region without convergence.

The set of (alpha, gamma) with an indefinite D is open, since D takes both signs on the circle. It is not bounded: if alpha = (0, ..., 0, c) and gamma
= (g, 0, ..., 0) with g^2 = 1 + c^2, then d_0 = c^2 + 1 - g^2 = 0, while d_n = c; the mean value of D on the circle is zero, so D has both signs.
"""

from exactkf.claims import claim, not_checked
from exactkf.evidence import example, instances
from exactkf.language import coeff, function, given, let, nonneg_on_circle, nonzero, symbols, when
from proofs.blz94.notation import KIMURA, D, a, alpha, b, gamma, i, k, n, symmetric_part

c, s, u = symbols("c s u")

not_checked("BLZ94-R7.3", "the global stable manifold and singular points",
            "the remark says that something is allowed for. What Corollary 7.2 describes has no singular point in the sense of Theorem 5.11: there the common "
            "factor of a and b has its zeros "
            "outside the disc, so a and b have no common pair of reciprocal roots")

claim("BLZ94-S58", "the points with indefinite D are not bounded",
      (s == 1) & (alpha(n) ** 2 + gamma(0) ** 2 >= u**2 / 2) & (coeff(D, 0) == 0) & (coeff(D, n) == (u**2 - 1) / (2 * u)), sizes=["n"], over={u: nonzero()},
      where=[function(alpha, [i], when(i == n, (u**2 - 1) / (2 * u), 0)), function(gamma, [k], when(k == 0, (u**2 + 1) / (2 * u), 0)), *KIMURA,
          let(D, symmetric_part(a, b)), let(s, when(nonneg_on_circle(D) | nonneg_on_circle(-D), 0, 1))],
      given=[given("alpha_n != 0", u**2 != 1)], by=[instances(20, n=(1, 2, 3)), example(n=1, u=1)],
      note="s = 1 says that D is not sign definite. A family of such points that goes to infinity with u. D takes both signs on the circle, and so does every "
           "D near it: the set is open.")
