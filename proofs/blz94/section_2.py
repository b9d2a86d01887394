# SPDX-License-Identifier: MIT
"""Section 2: the filter, its Riccati equation and the fast algorithm.

A proper rational function v of degree n is written v(z) = 1/2 + h'(zI - F)^-1 g.
In the observer form F = J - ah', h the first unit vector, the numerator of the
second part is g(z) and its denominator a(z), so that v = b/(2a) with
b = a + 2g. On the unit circle v(z) + v(1/z) equals D(z, 1/z) divided by
a(z)a(1/z), D being the symmetric part of a(z)b(1/z). Hence v is positive real
if and only if D is positive on the circle and a has its zeros inside; b may
take the place of a, since 1/v is positive real together with v.

The Riccati recursion started at zero gives the gain k_t of the filter. The
fast algorithm produces the same gain from two vectors a(t), g(t). What makes it
work are three relations that survive each step: P_{t+1} - P_t = r_t g(t)g(t)',
r_t = 1 - h'P_t h, and r_t k_t = g - F P_t h. The polynomials of a(t) and
b(t) = a(t) + 2g(t) have, up to the factor r_t, the same symmetric part D for
all t. For positive real v all of them are stable; without that hypothesis
nothing keeps their zeros inside the unit circle.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, generic_index, identity, induction, instances, lemma, steps, use
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    always,
    charpoly,
    coeff,
    column,
    coprime,
    eq,
    forall,
    function,
    given,
    iff,
    integer,
    inv,
    laurent,
    let,
    loewner,
    matrix,
    matrix_of,
    monic,
    nonneg_on_circle,
    pd,
    pos_on_circle,
    rank,
    rec,
    recip,
    schur,
    sequence_of,
    standing,
    substitute,
    sum_of,
    symbols,
    symmetric,
    symmetric_matrix,
    to_expr,
    vector,
    when,
)
from proofs.blz94.notation import (
    FAST,
    HALF,
    OBSERVER,
    POLYNOMIALS,
    SCALE,
    SHIFT,
    D,
    F,
    J,
    P,
    a,
    a0,
    apoly,
    b,
    bpoly,
    g,
    g0,
    gain,
    h,
    i,
    j,
    k,
    m,
    monic_of,
    n,
    r,
    s,
    strict_of,
    symmetric_part,
    t,
    u,
)

v, q, w, x, y, K, N = symbols("v q w x y K N")
C, O, Tm, c, G, H = symbols("C O T_m c G H")

# ---------------------------------------------------------------------- the rational function
claim("BLZ94-E2.1", "v has degree n exactly when the realization is reachable and observable",
      (T(h) * inv(Z * Identity(n) - F) * g == N / charpoly(F))
      & iff((rank(C) == n) & (rank(O) == n), coprime(charpoly(F), N)),
      sizes=["n"], over={F: matrix(n, n), g: vector(n), h: vector(n)},
      where=[let(N, charpoly(F - g * T(h)) - charpoly(F)),
             let(C, matrix_of(i, j, n, n, (F ** (j - 1) * g)[i])),
             let(O, matrix_of(i, j, n, n, (T(h) * F ** (i - 1))[1, j]))],
      by=[steps(facts=["det(M + gh') = det(M)(1 + h'M^(-1)g)", "Kalman: a realization of a rational function has the degree of the function as its dimension if and only if it "
                       "is reachable and observable"],
                prose="With M = zI - F the first fact is the formula for the numerator; numerator and denominator without a common zero make the degree n."),
          instances(40, n=(1, 2, 3)), example(n=2, F=[[1, 0], [0, 2]], g=[1, 1], h=[1, 0]),
          example(n=2, F=[[1, 0], [0, 2]], g=[1, 0], h=[1, 1])],
      note="A definition; what is checked is that the minimal realizations are those whose numerator and denominator "
           "have no common zero.")

claim("BLZ94-E2.2", "a Riccati step takes symmetric matrices to symmetric matrices",
      symmetric(F * P * T(F) + (g - F * P * h) * inv(1 - T(h) * P * h) * T(g - F * P * h)),
      sizes=["n"], over={F: matrix(n, n), g: vector(n), h: vector(n), P: symmetric_matrix(n)},
      by=[identity(n=range(1, 4)), instances(n=(2, 3))],
      note="A definition; the orbit consists of symmetric matrices as long as 1 - h'Ph is not zero.")

claim("BLZ94-E2.3", "v(z) + v(1/z) is the symmetric part D over a(z)a(1/z), so it is real on the unit circle",
      eq(v + recip(v), D / (a * recip(a)), recip(v + recip(v))), sizes=["n"], over={a: monic(n), b: monic(n)},
      where=[let(v, b / (2 * a)), let(D, symmetric_part(a, b))],
      by=[generic_index(in_values=True), instances(n=(1, 2, 3))],
      note="A definition; what is checked is that the inequality on the circle makes sense and reads D > 0.")

claim("BLZ94-E2.4", "the covariances of a positive real function form positive definite Toeplitz matrices",
      pd(Tm) & nonneg_on_circle(D) & (v + recip(v) == D / (a * recip(a))), sizes=["n"],
      over={a: monic(n), b: monic(n), m: integer(0, 6)},
      where=[let(v, b / (2 * a)), let(D, symmetric_part(a, b)),
             let(Tm, matrix_of(i, j, m + 1, m + 1, when(i == j, 1, laurent(v, abs(i - j)))))],
      given=[given("v is analytic on |z| >= 1", schur(a)), given("v(z) + v(1/z) > 0 on |z| = 1", pos_on_circle(D))],
      by=[steps("BLZ94-E2.3", facts=["the Toeplitz form x'T_m x is the mean of |x(z)|^2 (v(z) + v(1/z)) over the "
                                     "circle"],
                prose="A continuous positive function on the circle is integrable, and its Fourier coefficients are "
                      "those of v."),
          instances(n=(1, 2, 3), made_by={a: substitute(u, 4 * Z) / to_expr(4) ** n,
                                          b: substitute(w, 4 * Z) / to_expr(4) ** n},
                    using={u: monic(n), w: monic(n)})])

claim("BLZ94-E2.8", "the gain (2.8) gives the linear least-squares estimate: its error is orthogonal to past outputs",
      forall(t, 0, m, symmetric(P[t]) & (x[t] == P[t] * H[m - t])) & forall(t, 0, s, y[t] == G[t]), sizes=["n", "m", "s"],
      over={F: matrix(n, n), g: vector(n), h: vector(n), H: sequence_of(vector(n), 0, m)},
      where=[rec(P, t, Zero(n, n), F * P[t] * T(F) + (g - F * P[t] * h) / (1 - T(h) * P[t] * h) * T(g - F * P[t] * h)),
             function(gain, [t], (g - F * P[t] * h) / (1 - T(h) * P[t] * h)), rec(G, t, g, F * G[t]),
             rec(x, t, Zero(n, 1), F * x[t] + gain(t) * (T(H[m - t - 1]) * g - T(h) * x[t])),
             rec(y, t, F * x[m] + gain(m) * (1 - T(h) * x[m]), F * y[t] + gain(m + 1 + t) * (T(h) * G[t] - T(h) * y[t]))],
      given=[given("H_0 = h", H[0] == h), given("H_t is the t-th power of F', times h", forall(t, 0, m - 1, H[t + 1] == T(F) * H[t]))],
      by=[induction(), instances(n=(1, 2, 3), m=(1, 2), s=(0, 1, 2), made_by={H: (k, T(F) ** k * h)})],
      note="A definition; what is checked, through covariances, is that the filter is the one it is said to be. By (2.7) the covariance of "
           "the estimate at t with y_m is x_t up to t = m, and y_{t-m-1} after that: y_t has with y_m the covariance h'F^(|t-m|-1) g, and "
           "the variance one. That of x_t with y_m is F^(t-m-1) g. The estimate has the variance P_t, and m and s are arbitrary.")

# ---------------------------------------------------------------------- positive real functions
q_vec, B, beta, S, Q, a_vec, rr, bb, gg, Pinf, Gam = symbols("q B beta S Q a_vec varrho b g P_inf Gamma")


def _coefficient(vector, index):
    """Entry of a monic polynomial's coefficients, zero outside 0..n."""
    return when(index == 0, 1, vector[index])


claim("BLZ94-S4", "for positive real v the Riccati orbit from zero increases to the stable equilibrium",
      eq(Pinf, F * Pinf * T(F) + (g - F * Pinf * h) / (1 - T(h) * Pinf * h) * T(g - F * Pinf * h))
      & ((g - F * Pinf * h) / (1 - T(h) * Pinf * h) == q - a) & schur(F - (q - a) * T(h))
      & always(t, loewner(P[t + 1], P[t]) & loewner(Pinf, P[t])
               & loewner((F - (q - a) * T(h)) ** t * Pinf * T(F - (q - a) * T(h)) ** t, Pinf - P[t])),
      sizes=["n"], over={a: vector(n), q: vector(n)},
      where=[*SHIFT, let(F, J - a * T(h)),
             let(B, matrix_of(i, j, n + 1, n + 1, when(j >= i, _coefficient(a, j - i), 0)
                              + when(i + j <= n + 2, _coefficient(a, i + j - 2), 0))),
             let(beta, inv(B) * column(i, n + 1, 2 * coeff(monic_of(q) * recip(monic_of(q)), i - 1))),
             let(g, column(i, n, HALF * (beta[i + 1] / beta[1] - a[i]))),
             let(S, 1 / beta[1] * q * T(q) - (a + g) * T(a + g) + g * T(g)),
             let(Pinf, sum_of(k, 0, n - 1, J**k * S * T(J) ** k)),
             rec(P, t, Zero(n, n), F * P[t] * T(F) + (g - F * P[t] * h) / (1 - T(h) * P[t] * h) * T(g - F * P[t] * h))],
      given=[given("a(z) is stable", schur(monic_of(a))), given("the spectral factor is stable", schur(monic_of(q)))],
      by=[steps("BLZ94-E6.9", "BLZ94-E6.11", "BLZ94-X.2",
                facts=["positive real lemma: P_inf is positive semidefinite and 1 - h'P_inf h positive", "P(I - hh'P)^(-1) increases with P as long as 1 - h'Ph is positive",
                       "powers of a matrix with all eigenvalues in the open disc tend to zero"],
                prose="The step is gg' + AP(I - hh'P)^(-1)A', increasing in P, and P_1 is not below P_0 = 0 nor above P_inf, so the orbit increases and stays below P_inf. By X.2 the distance to "
                      "P_inf shrinks at least as under the closed loop."),
          instances(12, n=(1, 2), made_by={a: column(i, n, x[i] / to_expr(4) ** i),
                                           q: column(i, n, y[i] / to_expr(4) ** i)},
                    using={x: vector(n), y: vector(n)}, horizon=3)],
      note="Every positive real v comes from a stable a(z) and the stable q(z) with D proportional to q(z)q(1/z): b "
           "is the monic multiple of the solution beta of a linear system, and P_inf a finite sum. The bound by "
           "powers of the stable matrix F - k_inf h' is what makes the convergence.")

claim("BLZ94-E2.10", "the observer form is the shift minus ah'",
      matrix_of(i, j, n, n, when(j == 1, -a[i], 0) + when(j == i + 1, 1, 0)) == J - a * T(h), sizes=["n"],
      over={a: vector(n)},
      where=[*SHIFT], by=[generic_index(), instances(n=range(2, 5))])

claim("BLZ94-E2.11", "the transfer function of the observer form",
      T(h) * inv(Z * Identity(n) - F) * g == strict_of(g) / monic_of(a0), sizes=["n"],
      over={a0: vector(n), g: vector(n)},
      where=[*OBSERVER], by=[identity(n=range(1, 7)), instances(n=(1, 2, 3))])

claim("BLZ94-E2.12", "v = b/(2a) with b = a + 2g monic",
      (HALF + strict_of(g) / monic_of(a) == HALF * ((monic_of(a) + 2 * strict_of(g)) / monic_of(a)))
      & (monic_of(a) + 2 * strict_of(g) == monic_of(a + 2 * g)),
      sizes=["n"], over={a: vector(n), g: vector(n)}, by=[generic_index(in_values=[0]), instances(n=(1, 2, 3))])

a1, b1, d = symbols("a1 b1 d")
claim("BLZ94-E2.13", "for positive real v of degree n, D is positive on the circle and a and b are stable",
      pos_on_circle(symmetric_part(a, b)) & schur(a) & schur(b), sizes=["n", "m"],
      over={a1: monic(n), b1: monic(n), d: monic(m)}, where=[let(a, a1 * d), let(b, b1 * d)],
      given=[given("v is analytic on |z| >= 1", schur(a1)), given("v(z) + v(1/z) > 0 on |z| = 1",
                                                                  pos_on_circle(symmetric_part(a1, b1))),
             given("v has degree n", coprime(a, b)), standing("v in lowest terms", coprime(a1, b1))],
      by=[steps("BLZ94-E2.3", facts=["maximum principle: v has positive real part on |z| >= 1, so b has no zero there"],
                prose="In lowest terms the poles of v are the zeros of a, and D = a(z)a(1/z)(v(z) + v(1/z))."),
          instances(n=(1, 2, 3), m=(0, 1), made_by={a1: substitute(u, 4 * Z) / to_expr(4) ** n,
                                                    b1: substitute(w, 4 * Z) / to_expr(4) ** n},
                    using={u: monic(n), w: monic(n)}),
          example(n=1, m=0, a1=["1/2", 1], b1=["-1/2", 1], d=[1])],
      note="v is b1/(2 a1) in lowest terms; the common factor d is there to show what the degree is needed for.")

claim("BLZ94-S5", "D > 0 on the circle and one of a, b stable: then v is positive real",
      schur(a) & schur(b) & (v + recip(v) == D / (a * recip(a))), sizes=["n"], over={a: monic(n), b: monic(n)},
      where=[let(v, b / (2 * a)), let(D, symmetric_part(a, b))],
      given=[given("D > 0 on the circle", pos_on_circle(D)), given("a or b is stable", schur(a) | schur(b))],
      by=[steps("BLZ94-E2.3", facts=["maximum principle, for v or for 1/v"],
                prose="If b is stable, a/b has positive real part on the circle, hence outside, where it has no zero; "
                      "a is stable."),
          instances(n=(1, 2, 3), made_by={a: substitute(u, 3 * Z) / to_expr(3) ** n,
                                          b: substitute(w, 3 * Z) / to_expr(3) ** n},
                    using={u: monic(n), w: monic(n)})],
      note="That a is stable says that v is analytic on |z| >= 1; D > 0 then says v(z) + v(1/z) > 0 on the circle.")

# ---------------------------------------------------------------------- the fast algorithm
claim("BLZ94-E2.16", "the fast algorithm in terms of polynomials",
      (monic_of(a[1]) == (monic_of(a0) + (1 - Z) * strict_of(g0)) / (1 - g0[1]))
      & (strict_of(g[1]) == ((Z - g0[1]) * strict_of(g0) - g0[1] * monic_of(a0)) / (1 - g0[1] ** 2)),
      sizes=["n"], over={a0: vector(n), g0: vector(n)}, where=[*FAST], given=[standing("n >= 1", n >= 1)],
      by=[generic_index(), instances(n=(1, 2, 3))],
      note="A definition; what is checked is that a step of the vectors is a step of polynomials: a(z) stays monic of "
           "degree n, and the leading terms of (z - g_1)g(z) - g_1 a(z) cancel.")

_g1, _f = T(h) * g[t], a[t] + g[t] - a0  # the first entry of g(t), h being the first unit vector; the gain of the fast algorithm
_SHIFT, _UNIT = matrix_of(i, j, n, n, when(j == i + 1, 1, 0)), column(i, n, when(i == 1, 1, 0))
claim("BLZ94-E2.17", "the fast algorithm gives the gain of the Riccati recursion from zero",
      always(t, (g0 - F * P[t] * h) / (1 - T(h) * P[t] * h) == _f), sizes=["n"],
      over={J: matrix(n, n), F: matrix(n, n), h: vector(n), a0: vector(n), g0: vector(n)},
      where=[rec(P, t, Zero(n, n), F * P[t] * T(F) + (g0 - F * P[t] * h) / (1 - T(h) * P[t] * h) * T(g0 - F * P[t] * h)),
             rec(a, t, a0, 1 / (1 - _g1) * (a[t] + (Identity(n) - J) * g[t])),
             rec(g, t, g0, 1 / (1 - _g1 ** 2) * (-_g1 * a[t] + (J - _g1 * Identity(n)) * g[t])),
             rec(r, t, Identity(1), (1 - _g1 ** 2) * r[t])],
      given=[standing("(2.10)", (J == _SHIFT) & (h == _UNIT) & (F == J - a0 * T(h)))],
      by=[induction(also=[P[t] == T(P[t]), r[t] == 1 - T(h) * P[t] * h,
                          F * P[t] * T(F) + r[t] * _f * T(_f) == P[t] + r[t] * g[t] * T(g[t])]),
          instances(n=(2, 3, 4), horizon=4, made_by={J: _SHIFT, h: _UNIT, F: _SHIFT - a0 * T(_UNIT)})],
      note="The induction carries two more relations: P_{t+1} - P_t = r_t g(t)g(t)' and r_t = 1 - h'P_t h. Of J and h it uses nothing, "
           "so it is for every n.")

_SUM, _GAP = HALF * (apoly[t] + bpoly[t]), HALF * (bpoly[t] - apoly[t])
#: (2.16) for the polynomials
_STEP_OF_FACTORS = lemma(t, (apoly[t + 1] == 1 / (1 - g[t][1]) * (_SUM - Z * _GAP)) & (bpoly[t + 1] == 1 / (1 + g[t][1]) * (_SUM + Z * _GAP)), direct=True)
claim("BLZ94-E2.18", "the symmetric part of a_t(z)b_t(1/z) is preserved up to the factor r_t",
      always(t, r[t] * (apoly[t] * recip(bpoly[t]) + recip(apoly[t]) * bpoly[t]) == 2 * D), sizes=["n"],
      over={a0: vector(n), g0: vector(n)},
      where=[*FAST, *SCALE, *POLYNOMIALS, let(D, symmetric_part(apoly[0], bpoly[0]))], given=[standing("n >= 1", n >= 1)],
      by=[generic_index(_STEP_OF_FACTORS, lemma(t, r[t] * (apoly[t] * recip(bpoly[t]) + recip(apoly[t]) * bpoly[t]) == 2 * D, in_values=True,
                                                uses=[use(0, t=t), use(1, t=t, times=1)]),
                        closed=[apoly, bpoly], in_values=True, uses=[use(1, t=t, times=1)]), instances(n=(1, 2, 3, 4))])

_PR = [given("v is analytic on |z| >= 1", schur(monic_of(a0))), given("v(z) + v(1/z) > 0 on |z| = 1", pos_on_circle(D))]
_PR_INSTANCES = instances(n=(1, 2, 3), made_by={a0: column(i, n, x[i] / to_expr(4) ** i),
                                                g0: column(i, n, y[i] / to_expr(4) ** i)},
                          using={x: vector(n), y: vector(n)}, horizon=4)
_ALONG = [*FAST, *POLYNOMIALS, let(D, symmetric_part(monic_of(a0), monic_of(a0 + 2 * g0)))]
claim("BLZ94-S6", "a_t(z) and b_t(z) are stable",
      always(t, schur(apoly[t]) & schur(bpoly[t])), sizes=["n"], over={a0: vector(n), g0: vector(n)}, where=_ALONG,
      by=[example(n=1, abar=[2], gbar=[1]), instances(n=(1, 2))],
      note="The sentence has no hypothesis: the section gives up positive realness just before the observer form, and names it again in each sentence that "
           "uses it, also in the one that follows. The algorithm starts from any a_0 = a and b_0 = b.",
      repair=repair("missing hypothesis", "a_t and b_t are stable if v is positive real; without that already a_0 = z + 2 is not.",
                    always(t, schur(apoly[t]) & schur(bpoly[t])), sizes=["n"], over={a0: vector(n), g0: vector(n)}, where=_ALONG, given=_PR,
                    by=[steps("BLZ94-E2.18", facts=["for positive real v all |g_1(t)| < 1 (Schur), and a step of (2.16) is a step of Schur's algorithm"],
                              prose="All r_t are positive, so D stays positive on the circle, and each step keeps v_t positive real."),
                        _PR_INSTANCES]))

claim("BLZ94-S7", "if v is positive real, so is every v_t",
      always(t, schur(apoly[t]) & pos_on_circle(symmetric_part(apoly[t], bpoly[t]))), sizes=["n"],
      over={a0: vector(n), g0: vector(n)},
      where=_ALONG, given=_PR,
      by=[steps("BLZ94-E2.18", facts=["for positive real v all |g_1(t)| < 1 (Schur), and a step of (2.16) is a step "
                                      "of Schur's algorithm"],
                prose="All r_t are positive, so D stays positive on the circle, and each step keeps v_t positive "
                      "real."),
          _PR_INSTANCES])
