# SPDX-License-Identifier: MIT
"""Section 7: common factors of a and b, and vanishing alphas.

Let Q = r_t(a + b)/2 and Q* = r_t(b - a)/2. In these a step of (2.16) is linear, and gamma_t is the
leading coefficient of Q*/r_t. A factor theta of both passes through each step, and since theta is monic gamma_t is the same
without it. So an orbit with the common factor theta is the orbit of the reduced data times theta, and so is its limit.

If alpha_{k+1}, ..., alpha_n vanish, they vanish for all times; the last k entries of gamma(t) then form with the other alphas an orbit of order k,
and after n - k steps nothing is left of the other n - k entries.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, generic_index, identity, induction, instances, lemma, steps, use
from exactkf.language import (
    Z,
    Zero,
    always,
    bottom,
    coeff,

    eq,
    forall,
    function,
    given,
    iff,
    let,
    matrix_of,
    monic,
    nonneg_on_circle,
    nonzero,
    outside_roots,
    prod,
    rec,
    recip,
    standing,
    sum_of,
    symbols,
    vector,
    vstack,
    when,
)
from proofs.blz94.lemmas_orbit import FOUR_ALPHA, NEXT, ONE_STEP, z
from proofs.blz94.notation import (
    FAST,
    HALF,
    ORBIT,
    PI_T,
    RHO_T,
    VECTORS,
    D,
    a,
    a0,
    a_of,
    alpha0,
    apoly,
    b,
    b_of,
    bpoly,
    g,
    g0,
    gamma,
    gamma0,
    k,
    monic_of,
    n,
    r,
    strict_of,
    symmetric_part,
    t,
)

Q, Qs, p, q, s, u, v, w, x, y = symbols("Q Qstar p q s u v w x y")

_ALONG = (*ORBIT, *VECTORS, *RHO_T, *PI_T, rec(r, t, 1, (1 - gamma[t][1] ** 2) * r[t]), function(apoly, [t], monic_of(a_of[t])), function(bpoly, [t], monic_of(b_of[t])))
claim("BLZ94-E7.4", "the algorithm in the polynomials Q_t and Q_t*",
      always(t, (apoly[t] == 1 / r[t] * (Q[t] - Qs[t])) & (bpoly[t] == 1 / r[t] * (Q[t] + Qs[t]))), sizes=["n"],
      over={alpha0: vector(n), gamma0: vector(n)},
      where=[*_ALONG, rec(Q, t, HALF * (apoly[0] + bpoly[0]), Q[t] - gamma[t][1] * Z * Qs[t]), rec(Qs, t, HALF * (bpoly[0] - apoly[0]), Z * Qs[t] - gamma[t][1] * Q[t])],
      given=[standing("n >= 1", n >= 1)],
      by=[generic_index(*ONE_STEP, NEXT, lemma(t, (apoly[t] == 1 / r[t] * (Q[t] - Qs[t])) & (bpoly[t] == 1 / r[t] * (Q[t] + Qs[t])),
                                               uses=[use(8, t=t, z=z), *(use(9, t=t, z=x) for x in (z - 1, z))]),
                        supported=FOUR_ALPHA["supported"], whole=[*FOUR_ALPHA["whole"]], closed=[apoly, bpoly], uses=[use(9, t=t, z=z)]),
          instances(n=(1, 2, 3), horizon=3)],
      note="(7.4) with the initial values that (7.5) gives for t = 0; a_t, b_t are those of (alpha(t), gamma(t)) along (4.4), and r_t is (3.7). Q_t* is a second sequence, not the reversed polynomial.")

_OF_FACTORS = {"sizes": ["n", "k"], "over": {u: monic(n), v: monic(n), x: monic(k)}, "where": [let(a, u * x), let(b, v * x), let(D, symmetric_part(a, b)), let(q, symmetric_part(u, v))]}
_SAME_SIGN = (D == q * x * recip(x)) & iff(nonneg_on_circle(D) | nonneg_on_circle(-D), nonneg_on_circle(q) | nonneg_on_circle(-q))
_BY_FACTORS = [steps("BLZ94-X.3", facts=["a number times its conjugate is not negative", "a continuous function is determined by its values off finitely many points"],
                     prose="On the circle x(z)x(1/z) is not negative, and positive but at finitely many points."),
               example(n=1, k=1, u=[2, 1], v=[0, 1], x=[-1, 1]), example(n=1, k=1, u=[0, 1], v=[3, 1], x=[3, 1]), example(n=1, k=1, u=[3, 1], v=[-1, 1], x=[-1, 1]),
               instances(20, n=(1, 2), k=(0, 1, 2))]
claim("BLZ94-S55", "a common factor cancels in v, written as a over 2b, and does not change the sign of D",
      eq(HALF + (b - a) / (2 * a), HALF * a / b, HALF * u / v) & _SAME_SIGN, **_OF_FACTORS,
      by=[example(n=1, k=0, u=[1, 1], v=[2, 1], x=[1]), instances(n=(1, 2), k=(0, 1))],
      note="v(z) = 1/2 + g(z)/a(z) by (2.12), and there b = a + 2g. x is theta, u and v the polynomials without it, and q is their D.",
      repair=repair("other", "Numerator and denominator are exchanged: v is b/(2a), as in (2.12).",
                    eq(HALF + (b - a) / (2 * a), HALF * b / a, HALF * v / u) & _SAME_SIGN, **_OF_FACTORS, by=_BY_FACTORS))

_FULL = (function(p, [t], coeff(Qs[t], n + k - 1) / s[t]), rec(s, t, 1, (1 - p(t) ** 2) * s[t]),
         rec(Q, t, HALF * (monic_of(a0) + monic_of(a0 + 2 * g0)) * x, Q[t] - p(t) * Z * Qs[t]), rec(Qs, t, strict_of(g0) * x, Z * Qs[t] - p(t) * Q[t]))
claim("BLZ94-E7.6", "a common factor of a and b stays, and the rest is the orbit of the reduced data",
      always(t, ((Q[t] - Qs[t]) / s[t] == monic_of(a[t]) * x) & ((Q[t] + Qs[t]) / s[t] == monic_of(a[t] + 2 * g[t]) * x)), sizes=["n", "k"],
      over={a0: vector(n), g0: vector(n), x: monic(k)}, where=[*FAST, *_FULL], given=[standing("n >= 1", n >= 1)],
      by=[steps("BLZ94-X.3", "BLZ94-E7.4", "BLZ94-E2.16", prose="By induction on t: the data at t have the factor, so gamma_t is that of the reduced data and Q_{t+1}, Q_{t+1}* have it."),
          instances(n=(1, 2, 3), k=(1, 2), horizon=3)],
      note="The left sides are a_t(z) and b_t(z) by (7.4) and (7.5) from a = atilde x and b = btilde x; the right sides come from the fast algorithm (2.16) for the reduced data. "
           "p(t) is gamma_t, the leading coefficient of (b_t - a_t)/2, and s_t is r_t, both of the full data.")

claim("BLZ94-E7.7", "the limit polynomial has its zeros in the closed disc if and only if the common factor has",
      (outside_roots(w) == outside_roots(x)) & (symmetric_part(u * x, v * x) == q * w * recip(w)), sizes=["n", "k"],
      over={u: monic(n), v: monic(n), y: monic(n), x: monic(k), q: nonzero()}, where=[let(w, y * x)],
      given=[given("(7.1a)", symmetric_part(u, v) == q * y * recip(y)), given("zeros of y in the closed disc", outside_roots(y) == 0)],
      by=[steps("BLZ94-X.3", facts=["the zeros of a product are those of its factors"], prose="The limit of the reduced orbit times the factor is the limit (Theorem 7.1 (iii))."),
          example(n=1, k=1, u=["1/2", 1], v=["1/2", 1], y=["1/2", 1], x=[3, 1], q=1), example(n=1, k=1, u=[2, 1], v=[2, 1], y=[2, 1], x=["1/3", 1], q=1),
          example(n=1, k=1, u=["1/2", 1], v=["1/2", 1], y=["1/3", 1], x=["1/3", 1], q=1),
          instances(20, n=(1, 2), k=(0, 1, 2), made_by={u: y, v: y, q: 1})],
      note="y is the limit polynomial of the reduced data, w = yx that of the full data; both have as many zeros outside as the factor, so none if it has none. w satisfies (5.4) with the same factor.")
