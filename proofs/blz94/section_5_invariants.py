# SPDX-License-Identifier: MIT
"""Section 5: the invariants along a convergent orbit.

Since r_t d_i(t) is constant, the quotients h_i = 2 d_i/d_0 are constant along an orbit. If it tends to (w, 0), a_t(z) and b_t(z) both tend to w(z),
and r_t times half of S(a_t)b_t tends to r w(z)w(1/z): this is D, so D does not change sign on the circle, d_0 is r times a sum of squares and not
zero, and r is not zero as D is not. The h_i and d_n = alpha_n, or the last d_k that is not zero, give all of d(z).
"""

from exactkf.claims import claim
from exactkf.evidence import example, generic_index, identity, instances, restated, steps, use
from exactkf.language import (
    Z,
    always,
    coeff,
    column,
    forall,
    function,
    given,
    let,
    monic,
    nonneg_on_circle,
    nonzero,
    polynomial,
    recip,
    scalar,
    sequence,
    standing,
    sum_of,
    symbols,
    vector,
    when,
)
from proofs.blz94.lemmas_orbit import FOUR_ALPHA, INVARIANT, NEXT, ONE_STEP
from proofs.blz94.notation import (
    FACTORS_T,
    HALF,
    KIMURA,
    NORM,
    ORBIT,
    PI_T,
    PRODUCT_T,
    RHO_T,
    SCALE_T,
    VECTORS,
    D,
    a,
    alpha,
    alpha0,
    apoly,
    b,
    bpoly,
    gamma,
    gamma0,
    i,
    k,
    m,
    monic_of,
    n,
    r,
    symmetric_part,
    t,
)

c, d, u, v, w, x, y, kappa, l, beta, delta, E, s = symbols("c d u v w x y kappa l beta delta E s")
_VECTOR_POINT = {alpha0: vector(n), gamma0: vector(n)}
_ALONG = (*ORBIT, *VECTORS, *SCALE_T, *FACTORS_T, *PRODUCT_T)
_POINT = {alpha: sequence(1, n), gamma: sequence(0, n - 1)}
_D = (*KIMURA, let(D, symmetric_part(a, b)))
#: (alpha, 0)
_AT_REST = (function(gamma, [k], 0), function(alpha, [k], alpha0[k]), *_D)
#: n = 1: a point on the level set of (w, 0), and r
_ON_CURVE = {alpha: (k, (u**2 * w[1] ** 2 - 1) / (w[1] * (u**2 - 1))), gamma: (k, u * (alpha[1] - w[1])), c: alpha[1] / w[1]}

claim("BLZ94-E5.4", "in the limit D is a spectral factorization",
      2 * D == c * (2 * w * recip(w) + s * (w * recip(u + v) + recip(w) * (u + v)) + s**2 * (u * recip(v) + recip(u) * v)), sizes=["n"],
      over={w: monic(n), u: polynomial(n), v: polynomial(n), c: scalar(), s: scalar()},
      where=[let(a, w + s * u), let(b, w + s * v), let(D, c * symmetric_part(a, b))],
      by=[generic_index(in_values=True), instances(n=(1, 2, 3)),
          restated("(5.14): r_t S(a_t)b_t = 2D for every t", "sums and products are continuous")],
      note="w is the limit polynomial, to which a_t = w + su and b_t = w + sv tend if (alpha_t, gamma_t) tends to (w, 0); c is r_t, and c S(a_t)b_t = 2D for "
           "every t by (2.18). For s to zero the equation becomes (5.4).")

claim("BLZ94-C5.3", "D is sign definite if the orbit converges", nonneg_on_circle(D) | nonneg_on_circle(-D), sizes=["n"],
      over={**_POINT, w: monic(n), c: scalar()}, where=_D, given=[given("(5.4)", D == c * w * recip(w))],
      by=[steps("BLZ94-E5.4", facts=["a number times its conjugate is not negative"],
          prose="Of a convergent orbit D is r times w(z)w(1/z), w the limit, and w(1/z) is the conjugate on the circle."),
          example({alpha: [2], gamma: [2], w: [2, 1], c: 1}, n=1),
          instances(8, n=(1, 2), made_by={gamma: (k, 0), c: 1, w: Z**n + sum_of(i, 1, n, alpha[i] * Z ** (n - i))}),
          instances(8, n=(1,), using={u: scalar(), v: vector(1)},
                    made_by={alpha: (k, (u**2 * v[1] ** 2 - 1) / (v[1] * (u**2 - 1))), gamma: (k, u * (alpha[1] - v[1])), c: alpha[1] / v[1], w: Z + v[1]})],
      note="Of convergence only (5.4) is used. For n = 1 the instances lie on the level sets of the (w, 0).")

claim("BLZ94-S32", "d_0 is not zero if the level set contains an equilibrium",
      (coeff(D, 0) == c * (1 + sum_of(i, 1, n, w[i] ** 2))) & (coeff(D, 0) ** 2 > 0), sizes=["n"], over={w: vector(n), c: nonzero()},
      where=[let(D, c * monic_of(w) * recip(monic_of(w)))], by=[instances(n=(1, 2, 3))],
      note="If (w, 0) belongs to the level set of D, D is a multiple of w(z)w(1/z), and c is not zero as D is not.")

_H = function(kappa, [i], 2 * coeff(D, i) / coeff(D, 0))
claim("BLZ94-E5.5", "the functions h_i, and D from them", 2 * D == coeff(D, 0) * (2 + sum_of(i, 1, n, kappa(i) * (Z**i + recip(Z**i)))), sizes=["n"],
      over=_POINT, where=[*_D, _H],
      by=[identity(n=range(1, 6)), instances(n=(1, 2, 3))], note="A definition; what is checked is that the h_i determine D up to the factor d_0.")

_IN_GENERAL = (*ORBIT, *VECTORS, *RHO_T, *PI_T, *SCALE_T, *FACTORS_T, *PRODUCT_T)
_GENERIC = {"supported": FOUR_ALPHA["supported"], "whole": [alpha, D], "closed": [apoly, bpoly]}
claim("BLZ94-T5.4.1", "the h_i are constant along an orbit", always(t, forall(i, 1, n, coeff(D[t], i) * coeff(D[0], 0) == coeff(D[0], i) * coeff(D[t], 0))),
      sizes=["n"], over=_VECTOR_POINT, where=_IN_GENERAL, given=[standing("n >= 1", n >= 1)],
      by=[generic_index(*ONE_STEP, NEXT, INVARIANT, **_GENERIC, uses=[use(9, t=t, z=i), use(9, t=t, z=0)]), instances(n=(1, 2, 3), horizon=3)],
      note="h_i(t) = h_i(0), multiplied by d_0(t)d_0(0)/2. Along a convergent orbit d_0 is not zero (BLZ94-S33), so the quotients exist; the constants kappa_i are the h_i(0). "
           "Nothing else of convergence is used.")

_HALF_D = let(d, HALF * coeff(D, 0) + sum_of(i, 1, n, coeff(D, i) * Z**i))
claim("BLZ94-T5.4.2", "d(z) from the h_i if alpha_n is not zero",
      (x != 0) & (d == alpha[n] * (Z**n + sum_of(i, 1, n - 1, kappa(i) / x * Z**i) + 1 / x)), sizes=["n"], over=_POINT,
      where=[*_D, _HALF_D, _H, let(x, kappa(n))],
      given=[given("alpha_n != 0", alpha[n] != 0)],
      by=[steps("BLZ94-S34", prose="Divide d_i = d_0 kappa_i/2 by d_n = alpha_n."), instances(20, n=(1, 2, 3)), example({alpha: [0], gamma: [0]}, n=1)])

#: alpha_1, ..., alpha_k, and zeros
_SHORT = {"sizes": ["k", "l"], "over": {beta: sequence(1, k), gamma: sequence(0, k + l - 1)}}
_PADDED = (let(n, k + l), function(alpha, [i], when(i <= k, beta[i], 0)), *_D, *NORM)
claim("BLZ94-T5.4.3", "d(z) from the h_i if the last alphas vanish",
      forall(i, k + 1, n, kappa(i) == 0) & (x != 0)
      & (d == r[n - k] * alpha(k) * (Z**k + sum_of(i, 1, k - 1, kappa(i) / x * Z**i) + 1 / x)), **_SHORT, where=[*_PADDED, _HALF_D, _H, let(x, kappa(k))],
      given=[given("alpha_k != 0", beta[k] != 0), standing("gamma_k^2 != 1", forall(i, 0, n - 1, gamma[i] ** 2 != 1))],
      by=[steps("BLZ94-S34", prose="Divide d_i = d_0 kappa_i/2 by d_k = r_{n-k} alpha_k."), instances(20, k=(1, 2), l=(0, 1, 2)),
          example({beta: [0], gamma: [0, 0]}, k=1, l=1),
          example({beta: [1], gamma: [1, 2]}, k=1, l=1), example({beta: [1, 1], gamma: [1, 2, 3]}, k=2, l=1)])

claim("BLZ94-S34", "the last coefficients of D", forall(i, k + 1, n, coeff(D, i) == 0) & (coeff(D, k) == r[n - k] * alpha(k))
          & forall(i, 1, n, coeff(D, i) == HALF * coeff(D, 0) * kappa(i)),
      **_SHORT, where=[*_PADDED, _H], given=[standing("k >= 1", k >= 1)], by=[identity(k=(1, 2, 3), l=(0, 1, 2)), instances(k=(1, 2), l=(0, 1, 2))],
      note="n = k + l, and l = 0 is the case alpha_n != 0. That half of d_0 is d_k/kappa_k is the last equation for i = k.")

_HV = column(i, n, 2 * coeff(D[0], i) / coeff(D[0], 0))
claim("BLZ94-T5.4.4", "every point with given h_i keeps them, and its D is the given one up to a factor",
      always(t, (column(i, n, 2 * coeff(D[t], i) / coeff(D[t], 0)) == kappa) & (2 * D[t] == coeff(D[t], 0) * E)), sizes=["n"],
      over={**_VECTOR_POINT, kappa: vector(n)},
      where=[*_ALONG, let(E, 2 + sum_of(i, 1, n, kappa[i] * (Z**i + recip(Z**i))))], given=[given("(5.9)", _HV == kappa)],
      by=[steps("BLZ94-T5.4.1", "BLZ94-E5.5", prose="The h_i are invariant, and determine D up to d_0."),
          instances(16, n=(1, 2, 3), horizon=3, made_by={kappa: _HV})],
      note="E has the coefficients that the h_i determine; d_0 is not zero where the h_i exist.")

claim("BLZ94-E5.10", "d_0 along a convergent orbit", always(t, coeff(D[t], 0) == r[t + m] / r[t] * coeff(D[t + m], 0)), sizes=["n", "m"], over=_VECTOR_POINT,
      where=_IN_GENERAL, given=[standing("n >= 1", n >= 1)],
      by=[generic_index(*ONE_STEP, NEXT, INVARIANT, **_GENERIC, uses=[use(9, t=t, z=0, times=1 / r[t]), use(9, t=t + m, z=0, times=-1 / r[t])]),
          instances(20, n=(1, 2, 3), m=(0, 1, 2), horizon=2),
          restated("limits: r_m tends to r_infinity, and d_0 is continuous")],
      note="For any two times t and t + m; (5.10) is the limit for m to infinity: r_m goes to r_infinity, and d_0 is continuous. (A-16), which the text names, has "
           "nothing to do with time: it is (4.13) that gives this.")

claim("BLZ94-S33", "d_0 at an equilibrium, and r_infinity is not zero", (coeff(E, 0) == 1 + sum_of(i, 1, n, w[i] ** 2)) & (coeff(E, 0) > 0) & (c**2 > 0),
      sizes=["n"],
      over={**_POINT, w: vector(n), c: scalar()},
      where=[*_D, function(x, [k], when(k == 0, 1, Z * x(k - 1))),
          let(E, symmetric_part(x(n) + sum_of(i, 1, n, w[i] * x(n - i)), x(n) + sum_of(i, 1, n, w[i] * x(n - i))))],
      given=[given("(5.4)", D == c * monic_of(w) * recip(monic_of(w))), given("gamma_k^2 != 1", forall(k, 0, n - 1, gamma[k] ** 2 != 1))],
      by=[steps("BLZ94-E5.4", "BLZ94-SA8", prose="If c were zero, D would vanish; but if d_1, ..., d_n vanish, d_0 is r_n, which is not zero."),
          instances(10, n=(1, 2, 3), made_by={gamma: (k, 0), w: column(i, n, alpha[i]), c: 1}),
          instances(6, n=(1,), using={u: scalar()}, made_by=_ON_CURVE), example({alpha: [0], gamma: [1], w: [1], c: 0}, n=1),
          example({alpha: [1], gamma: [0], w: [2], c: 0}, n=1)],
      note="c is r_infinity, and (w, 0) the limit; E is D at (w, 0), where the Szego polynomials are the powers of z.")
