# SPDX-License-Identifier: MIT
"""Section 7: common factors of a and b, and vanishing alphas.

Let Q = r_t(a + b)/2 and Q* = r_t(b - a)/2. In these a step of (2.16) is linear, and gamma_t is the
leading coefficient of Q*/r_t. A factor theta of both passes through each step, and since theta is monic gamma_t is the same
without it. So an orbit with the common factor theta is the orbit of the reduced data times theta, and so is its limit.

If alpha_{k+1}, ..., alpha_n vanish, they vanish for all times; the last k entries of gamma(t) then form with the other alphas an orbit of order k,
and after n - k steps nothing is left of the other n - k entries.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, generic_index, identity, induction, instances, lemma, restated, steps, use
from exactkf.language import (
    Expr,
    Identity,
    Z,
    Zero,
    always,
    bottom,
    coeff,
    column,
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
    polynomial,
    prod,
    rec,
    recip,
    standing,
    substitute,
    symbols,
    vector,
    vstack,
    when,
)
from proofs.blz94.lemmas_orbit import FOUR_ALPHA, NEXT, ONE_STEP, z
from proofs.blz94.notation import (
    FACTORS_T,
    FAST,
    HALF,
    ORBIT,
    PI_T,
    RHO_T,
    SCALE_T,
    VECTORS,
    D,
    a,
    a0,
    a_of,
    alpha,
    alpha0,
    apoly,
    b,
    b_of,
    bpoly,
    g,
    g0,
    gamma,
    gamma0,
    i,
    j,
    k,
    m,
    monic_of,
    n,
    r,
    strict_of,
    symmetric_part,
    t,
)

Q, Qs, l, p, q, s, u, v, w, x, y = symbols("Q Qstar l p q s u v w x y")
aa, aa0, gg, A2, G2 = symbols("beta betabar delta A2 G2")

_ALONG = (*ORBIT, *VECTORS, *RHO_T, *PI_T, *SCALE_T, *FACTORS_T)
claim("BLZ94-E7.4", "the algorithm in the polynomials Q_t and Q_t*",
      always(t, (apoly[t] == 1 / r[t] * (Q[t] - Qs[t])) & (bpoly[t] == 1 / r[t] * (Q[t] + Qs[t]))), sizes=["n"],
      over={alpha0: vector(n), gamma0: vector(n)},
      where=[*_ALONG, rec(Q, t, HALF * (apoly[0] + bpoly[0]), Q[t] - gamma[t][1] * Z * Qs[t]),
             rec(Qs, t, HALF * (bpoly[0] - apoly[0]), Z * Qs[t] - gamma[t][1] * Q[t])],
      given=[standing("n >= 1", n >= 1)],
      by=[generic_index(*ONE_STEP, NEXT, lemma(t, (apoly[t] == 1 / r[t] * (Q[t] - Qs[t])) & (bpoly[t] == 1 / r[t] * (Q[t] + Qs[t])),
                                               uses=[use(8, t=t, z=z), *(use(9, t=t, z=x) for x in (z - 1, z))]),
                        supported=FOUR_ALPHA["supported"], whole=[*FOUR_ALPHA["whole"]], closed=[apoly, bpoly], uses=[use(9, t=t, z=z)]),
          instances(n=(1, 2, 3), horizon=3)],
      note="(7.4) with the initial values that (7.5) gives for t = 0; a_t, b_t are those of (alpha(t), gamma(t)) along (4.4), and r_t is (3.7). Q_t* is a "
           "second sequence, not the reversed polynomial.")

_OF_FACTORS = {"sizes": ["n", "k"], "over": {u: monic(n), v: monic(n), x: monic(k)},
               "where": [let(a, u * x), let(b, v * x), let(D, symmetric_part(a, b)), let(q, symmetric_part(u, v))]}
_SAME_SIGN = (D == q * x * recip(x)) & iff(nonneg_on_circle(D) | nonneg_on_circle(-D), nonneg_on_circle(q) | nonneg_on_circle(-q))
_BY_FACTORS = [steps("BLZ94-X.3", facts=["a number times its conjugate is not negative", "a continuous function is determined by its values off finitely "
                                                                                         "many points"],
                     prose="On the circle x(z)x(1/z) is not negative, and positive but at finitely many points."),
               example(n=1, k=1, u=[2, 1], v=[0, 1], x=[-1, 1]), example(n=1, k=1, u=[0, 1], v=[3, 1], x=[3, 1]),
               example(n=1, k=1, u=[3, 1], v=[-1, 1], x=[-1, 1]),
               instances(20, n=(1, 2), k=(0, 1, 2))]
claim("BLZ94-S55", "a common factor cancels in v, written as a over 2b, and does not change the sign of D",
      eq(HALF + (b - a) / (2 * a), HALF * a / b, HALF * u / v) & _SAME_SIGN, **_OF_FACTORS,
      by=[example(n=1, k=0, u=[1, 1], v=[2, 1], x=[1]), instances(n=(1, 2), k=(0, 1))],
      note="v(z) = 1/2 + g(z)/a(z) by (2.12), and there b = a + 2g. x is theta, u and v the polynomials without it, and q is their D.",
      repair=repair("other", "Numerator and denominator are exchanged: v is b/(2a), as in (2.12).",
                    eq(HALF + (b - a) / (2 * a), HALF * b / a, HALF * v / u) & _SAME_SIGN, **_OF_FACTORS, by=_BY_FACTORS))

def _of_product(p: Expr) -> Expr:
    """The coefficients of p x after z^(n+k)."""
    return column(i, n + k, coeff(p * x, n + k - i))


#: the fast algorithm in dimension n + k
_FULL = (let(G2, matrix_of(i, j, n + k, n + k, when(j == i + 1, 1, 0))),
         rec(aa, t, _of_product(monic_of(a0)), 1 / (1 - gg[t][1]) * (aa[t] + (Identity(n + k) - G2) * gg[t])),
         rec(gg, t, _of_product(strict_of(g0)), 1 / (1 - gg[t][1] ** 2) * (-gg[t][1] * aa[t] + (G2 - gg[t][1] * Identity(n + k)) * gg[t])))
claim("BLZ94-E7.6", "a common factor of a and b stays, and the rest is the orbit of the reduced data",
      always(t, (aa[t] == _of_product(monic_of(a[t]))) & (gg[t] == _of_product(strict_of(g[t])))), sizes=["n", "k"],
      over={a0: vector(n), g0: vector(n), x: monic(k)}, where=[*FAST, *_FULL], given=[standing("n >= 1", n >= 1)],
      by=[induction(n=(1, 2, 3, 4), k=(1, 2, 3)), instances(n=(1, 2, 3), k=(1, 2), horizon=3)],
      note="x is theta; (beta, delta) is the orbit of (2.16) in dimension n + k that starts from the coefficients of a = atilde x and g = gtilde x, and (a, "
           "g) that from atilde, gtilde. With b = a + 2g this is (7.6).")

claim("BLZ94-E7.7", "the limit polynomial has its zeros in the closed disc if and only if the common factor has",
      (outside_roots(w) == outside_roots(x)) & (symmetric_part(u * x, v * x) == q * w * recip(w)), sizes=["n", "k"],
      over={u: monic(n), v: monic(n), y: monic(n), x: monic(k), q: nonzero()}, where=[let(w, y * x)],
      given=[given("(7.1a)", symmetric_part(u, v) == q * y * recip(y)), given("zeros of y in the closed disc", outside_roots(y) == 0)],
      by=[steps("BLZ94-X.3", facts=["the zeros of a product are those of its factors"], prose="The limit of the reduced orbit times the factor is the limit "
                                                                                              "(Theorem 7.1 (iii))."),
          example(n=1, k=1, u=["1/2", 1], v=["1/2", 1], y=["1/2", 1], x=[3, 1], q=1), example(n=1, k=1, u=[2, 1], v=[2, 1], y=[2, 1], x=["1/3", 1], q=1),
          example(n=1, k=1, u=["1/2", 1], v=["1/2", 1], y=["1/3", 1], x=["1/3", 1], q=1),
          example(n=1, k=1, u=[0, 1], v=["4/5", 1], y=["1/2", 1], x=[3, 1], q="4/5"),
          example(n=1, k=2, u=[0, 1], v=["4/5", 1], y=["1/2", 1], x=["1/3", 2, 1], q="4/5"),
          instances(20, n=(1, 2), k=(0, 1, 2), made_by={u: y, v: y, q: 1})],
      note="y is the limit polynomial of the reduced data, w = yx that of the full data; both have as many zeros outside as the factor, so none if it has "
           "none. w satisfies (5.4) with the same factor.")

claim("BLZ94-R7.3", "the stable manifold in the large contains points at which the invariant manifold is singular",
      (symmetric_part(a, b) == symmetric_part(u, v) * x * recip(x)) & (substitute(a * recip(q) + recip(a) * q + b * recip(p) + recip(b) * p, s) == 0),
      sizes=["n"],
      over={u: monic(n), v: monic(n), s: nonzero(), p: polynomial(n + 1), q: polynomial(n + 2)},
      where=[let(x, (Z - s) * (Z - 1 / s)), let(a, u * x), let(b, v * x)],
      by=[identity(n=range(4)), instances(n=(0, 1, 2)),
          restated("Theorem 7.1 (iii): where the orbits tend to", "pseudo-polynomials that vanish at one point are not all")],
      note="For |s| < 1, coprime u and v, and uv(1/z) + u(1/z)v = 2r y(z)y(1/z) with stable y, the orbit tends to yx by Theorem 7.1 (iii), if it does not "
           "escape: it lies on the stable manifold of the equilibrium with stable factor y(z)(z - s) and theta = z - 1/s. The variations (5.17) of D all "
           "vanish at s there, for the pair s, 1/s that a and b have in common (Theorem 5.11), so they do not reach all of the n + 1 dimensions and X_D is "
           "singular. Corollary 7.2 as printed leaves these points out: if the common factor is theta, with all zeros outside, it has no such pair; but see "
           "C7.2.1.")

# ---------------------------------------------------------------------- vanishing alphas
_A2 = matrix_of(i, j, m, m, when(i > j, 0, when(i == j, 1 / (1 - gg[t][m - i + 1] ** 2),
                                                gg[t][m - i + 1] * gg[t][m - j + 1] / prod(k, i, j, 1 - gg[t][m - k + 1] ** 2))))
_REDUCED = (function(A2, [t], _A2), function(G2, [t], matrix_of(i, j, m, m, when(i < m, when(j == i + 1, 1, 0), -aa[t][m - j + 1]))),
            rec(aa, t, aa0, A2[t] * aa[t]), rec(gg, t, bottom(gamma0, m), G2[t + 1] * gg[t]))
claim("BLZ94-S57", "if the last alphas vanish, D has the degree of the others, and after n - k steps the orbit is one of order k",
      always(t, (alpha[t] == vstack(aa[t], Zero(l, 1))) & forall(j, 1, n, gamma[t + l][j] == gg[t + j - 1][1]))
      & forall(i, m + 1, n, coeff(D, i) == 0) & (coeff(D, m) == prod(i, 1, l, 1 - gamma0[i] ** 2) * aa0[m]),
      sizes=["m", "l"], over={aa0: vector(m), gamma0: vector(m + l)},
      where=[let(n, m + l), let(alpha0, vstack(aa0, Zero(l, 1))), *ORBIT, *VECTORS, let(D, symmetric_part(monic_of(a_of[0]), monic_of(b_of[0]))), *_REDUCED],
      given=[standing("k >= 1", m >= 1)],
      by=[steps("BLZ94-S26", "BLZ94-EA.3", prose="By S26 the orbit of order k is that of the other alphas and the last k entries of gamma(t), and D is that "
                                                 "of order k times the product, with leading coefficient alpha_k by (A-3). As gamma(t) is shifted in each "
                                                 "step, its first n - k entries are those that the last k entries had before."),
          instances(m=(1, 2), l=(1, 2), horizon=3), instances(m=(3,), l=(1,), horizon=2)],
      note="m is the k of the text, l = n - k; (beta, delta) is the orbit of order k from (alpha_1..alpha_k; gamma_{n-k}..gamma_{n-1}). D has degree k as "
           "alpha_k is not zero and no gamma_i has modulus one, without which the first step divides by zero. The j-th entry of gamma(t + n - k) is the "
           "first of delta(t + j - 1): from time n - k on nothing else is left, and both orbits converge together, with alpha(z) = z^(n-k) alphahat(z).")
