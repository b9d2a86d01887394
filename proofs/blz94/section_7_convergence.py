# SPDX-License-Identifier: MIT
"""Section 7: convergence of the fast algorithm, and the manifolds of an equilibrium.

Let P be the solution of (6.1) whose closed loop G has its eigenvalues in the closed unit disc. By X.2 and X.8 the solution from zero is
P_t = P + G^t N_t^(-1) G'^t, where N_t is -P^(-1) less a Gramian of (h, G) that grows with t. So 1 - h'P_th times a(t) + g(t) - v, v the limit
polynomial, is -G^(t+1) N_t^(-1) G'^t h: a closed formula for the orbit, in which only powers of G depend on t. They tend to zero if D has no zero on
the circle; if it has some, the theorem of Parlett and Poole on powers of S is needed.

Convergence as such is decided on instances: of an orbit with sign definite D it is computed that it comes as near to the equilibria as
one asks, of one with indefinite D that it never meets them.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, generic_index, instances, lemma, steps, use
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
            forall,
            function,
            given,
            inv,
            laurent,
            let,
            matrix_of,
            monic,
            nonneg_on_circle,
            nonzero,
            outside_roots,
            positive,
            rational,
            rec,
            recip,
            scalar,
            schur,
            standing,
            substitute,
            sum_of,
            symbols,
            symmetric_matrix,
            to_expr,
            vector,
            when,
)
from proofs.blz94.notation import (
            FAST,
            ORBIT,
            SCALE,
            VECTORS,
            D,
            F,
            J,
            P,
            a,
            a0,
            a_of,
            alpha,
            alpha0,
            b_of,
            g,
            g0,
            gamma,
            gamma0,
            h,
            i,
            j,
            k,
            m,
            monic_of,
            n,
            strict_of,
            symmetric_part,
            t,
)
from proofs.blz94.section_6 import B, factored

N, Gamma, Phi, c, e, f, l, o, p, q, r, s, u, v, w, x, y = symbols("N Gamma Phi c e f l o p q r s u v w x y")

# ---------------------------------------------------------------------- Theorem 7.1
cosine, value, highest, lowest, bound = symbols("cosine value highest lowest bound")
_DEFINITE = let(y, when(nonneg_on_circle(D) | nonneg_on_circle(-D), 1, 0))
#: if D has values of both signs, of modulus s at least, at points with cos(theta) = -1 + k/8, half of the bound of X.14 for the square length of g(t)
_AWAY = (
    function(cosine, [k, j], when(j == 0, 1, when(j == 1, rational("1/8") * k - 1, 2 * cosine(k, 1) * cosine(k, j - 1) - cosine(k, j - 2)))),
    function(value, [k], coeff(D, 0) + sum_of(j, 1, n, 2 * coeff(D, j) * cosine(k, j))),
    function(highest, [k], when(k == 0, value(0), when(value(k) > highest(k - 1), value(k), highest(k - 1)))),
    function(lowest, [k], when(k == 0, value(0), when(value(k) < lowest(k - 1), value(k), lowest(k - 1)))),
    let(s, when((highest(16) > 0) & (lowest(16) < 0), when(highest(16) < -lowest(16), highest(16), -lowest(16)), 0)),
    let(bound, when(s == 0, 0, when(s < n * abs(coeff(D, 0)), s / (4 * n * abs(coeff(D, 0))), rational("1/4")))),
)
TENDS = when(y == 1, q >= 0, p < 1)
#: first t at which the square of the length of g(t) is at most x, or -1 if the orbit is back before
_NEAR = function(f, [t], when((T(g[t]) * g[t])[1, 1] <= x, t, when((t > 0) & (a[t] == a0) & (g[t] == g0), -1, f(t + 1)))), let(q, f(0))
_VECTORS = {"sizes": ["n", "m"], "over": {a0: vector(n), g0: vector(n), x: positive()},
            "where": [*FAST, let(D, symmetric_part(monic_of(a0), monic_of(a0 + 2 * g0))), _DEFINITE, _NEAR,
                      *_AWAY, let(p, sum_of(t, 0, m, when((T(g[t]) * g[t])[1, 1] <= bound, 1, 0)))]}
POWERS_TEND = ["Parlett and Poole: the powers of a matrix take a subspace to the dominant one, in the sense of exponents, if it is complementary to the codominant one",
               "a subspace of half the dimension has a Lagrangian complement", "powers of a matrix with all eigenvalues in the open disc tend to zero"]
CONVERGENCE = ("BLZ94-E6.16", "BLZ94-EA.22", "BLZ94-EA.25", "BLZ94-E6.21", "BLZ94-E6.34", "BLZ94-S53", "BLZ94-E8.8", "BLZ94-E6.33", "BLZ94-X.2", "BLZ94-X.3", "BLZ94-X.5", "BLZ94-X.6",
               "BLZ94-X.7", "BLZ94-X.8", "BLZ94-X.13", "BLZ94-X.14", "BLZ94-P6.6", "BLZ94-E6.12", "BLZ94-E4.13", "BLZ94-E7.4", "BLZ94-S26")
_SIGNS = ["a number times its conjugate is not negative", "a function that does not change sign has zeros of even multiplicity only"]
_GLUE = ("Necessity: in the limit r_tD_t = D (E4.13) makes D a multiple of v(z)v(1/z), which has one sign on the circle; X.14 gives a bound. Sufficiency: if "
         "a and b are coprime, an eigenvalue of S on the circle has one Jordan block (X.13), of even size for definite D, so that half of its exponents are positive and "
         "half negative: the dominant and the codominant subspace are determined, and Lagrangian as limits of Lagrangian subspaces under powers of S and S^(-1). Im(I; 0) does not "
         "meet the codominant one (Lemma 6.12), so its images under powers of S tend to the dominant one and P_t to a solution of (6.1); g(t)g(t)'r_t is the "
         "difference of two P_t. A common factor goes through all steps (X.3, (7.4)), and alpha_n = 0 lowers the order (S26).")
_STEP = lemma(t, (u(t + 1) == (u(t) - g[t][1] * Z * v(t)) / (1 - g[t][1] ** 2)) & (v(t + 1) == (Z * v(t) - g[t][1] * u(t)) / (1 - g[t][1] ** 2)), direct=True)
_DIFFERENCE = r[t] * (u(t) * recip(u(t)) - v(t) * recip(v(t))) == D
claim("BLZ94-X.14", "D_t as a difference of squares, and its mean on the circle",
      always(t, _DIFFERENCE & (r[t] * (1 + (T(a[t] + g[t]) * (a[t] + g[t]))[1, 1] - (T(g[t]) * g[t])[1, 1]) == coeff(D, 0))), sizes=["n"],
      over={a0: vector(n), g0: vector(n)}, given=[standing("n >= 1", n >= 1)],
      where=[*FAST, *SCALE, function(u, [t], monic_of(a[t] + g[t])), function(v, [t], strict_of(g[t])), let(D, symmetric_part(monic_of(a0), monic_of(a0 + 2 * g0)))],
      by=[generic_index(_STEP, lemma(t, _DIFFERENCE, in_values=True, uses=[use(0, t=t), use(1, t=t, times=1)], closed=[u, v], base=[use(u, 0), use(v, 0)]), whole=[D],
                        in_values=[0], uses=[use(1, t=t, times=1), use(1, t=t, z=0)]), instances(n=(1, 2, 3), horizon=3)],
      note="Not printed. Let D have the values d > 0 and -e < 0 on the circle and s = min(d, e). At one of the two points D_t = D/r_t is at most -s/|r_t|, "
           "so |g_t(z)|^2 is at least s/|r_t| there, and n times "
           "the square length of g(t) is. If that length is at most 1/2, 1/|r_t| is at least 1/(2|d_0|) by the second equation; if d_0 = 0, the length is at "
           "least one. So the square length of g(t) "
           "is never less than the smaller of 1/2 and s/(2n|d_0|), and the orbit tends to no equilibrium.")

claim("BLZ94-T7.1.0", "an orbit that does not escape tends to the equilibria if and only if D is sign definite",
      TENDS, **_VECTORS,
      by=[steps(*CONVERGENCE, facts=[*POWERS_TEND, *_SIGNS], prose=_GLUE),
          example({a0: ["1/3"], g0: ["7/3"], x: "1/9"}, n=1, m=4), example({a0: ["-1/3", "5/3"], g0: ["1/2", "1/3"], x: "1/100"}, n=2, m=4),
          example({a0: [2], g0: [0], x: "1/9"}, n=1, m=2), example({a0: [3], g0: ["-1"], x: "1/25"}, n=1, m=2), example({a0: [-3], g0: [2], x: "1/25"}, n=1, m=2),
          instances(10, n=(1, 2), m=(3, 4), using={u: scalar(), v: vector(n)}, made_by={x: u**2 / 8 + rational("1/20")}),
          instances(10, n=(1, 2), m=(3,), using={u: scalar(), v: vector(n), w: vector(n)},
                    made_by={x: u**2 / 8 + rational("1/20"), a0: column(i, n, v[i] / 4), g0: column(i, n, w[i] / 9)})],
      note="g(t) tends to zero: for every x > 0 some g(t) has a square length of at most x, q being the first such t. y = 1 if D is sign definite. If it is "
           "not, X.14 bounds g(t) away from zero: p is the number of the first g(t) with a square "
           "length of at most the bound, which is zero if no value of the grid shows both signs. An orbit that escapes, where a division by zero occurs, is "
           "outside the statement.")

_GAMMA_NEAR = function(f, [t], when((T(gamma[t]) * gamma[t])[1, 1] <= x, t, when((t > 0) & (alpha[t] == alpha0) & (gamma[t] == gamma0), -1, f(t + 1)))), let(q, f(0))
ALONG = (*ORBIT, *VECTORS, let(D, symmetric_part(monic_of(a_of[0]), monic_of(b_of[0]))), _DEFINITE, _GAMMA_NEAR, *_AWAY,
         let(p, sum_of(t, 0, m, when((T(b_of[t] - a_of[t]) * (b_of[t] - a_of[t]))[1, 1] <= 4 * bound, 1, 0))))
claim("BLZ94-T7.1.2", "sign definite D is necessary and sufficient for convergence, away from the escaping points",
      TENDS, sizes=["n", "m"],
      over={alpha0: vector(n), gamma0: vector(n), x: positive()},
      where=ALONG,
      by=[steps(*CONVERGENCE, "BLZ94-T4.3.1", "BLZ94-T4.3.2", facts=[*POWERS_TEND, *_SIGNS], prose=_GLUE),
          example({alpha0: [0, 2], gamma0: ["1/2", "1/3"], x: "1/100"}, n=2, m=4),
          example({alpha0: ["8/3"], gamma0: ["7/3"], x: "1/9"}, n=1, m=3),
          example({alpha0: [2], gamma0: [0], x: "1/9"}, n=1, m=2), example({alpha0: [3], gamma0: [2], x: "1/25"}, n=1, m=2), example({alpha0: [1], gamma0: [3], x: "1/25"}, n=1, m=2),
          instances(10, n=(1, 2), m=(3, 4), using={u: scalar()}, made_by={x: u**2 / 8 + rational("1/20")}),
          instances(10, n=(1, 2), m=(3,), using={u: scalar(), v: vector(n), w: vector(n)},
                    made_by={x: u**2 / 8 + rational("1/20"), alpha0: column(i, n, v[i] / 4), gamma0: column(i, n, w[i] / 9)})],
      note="The statement of Theorem 7.1 once more, in the coordinates (alpha, gamma). gamma(t) tends to zero: q is the first t at which its square length is at most x; "
           "y = 1 for sign definite D, and p counts those of the first (b(t) - a(t))/2 that the bound of X.14 forbids otherwise.")

FACTORED = factored(J, h)
_LIMIT = q * (g0 - F * P * h) + a0
claim("BLZ94-T7.1.3", "the limit: the factor of D with zeros in the closed disc, times the common factor of a and b",
      forall(t, 0, m, (u[t] + v[t] == (monic_of(a[t]) + strict_of(g[t])) * x)
             & (r[t] * (a[t] + g[t] - alpha) == -(Gamma * Phi[t] * inv(N[t]) * T(Phi[t]) * h))), sizes=["n", "k", "m"],
      over={a0: vector(n), g0: vector(n), P: symmetric_matrix(n), q: scalar(), x: monic(k)},
      where=[*FAST, *SCALE, let(F, J - a0 * T(h)), let(alpha, _LIMIT), let(Gamma, J - alpha * T(h)), rec(Phi, t, Identity(n), Gamma * Phi[t]),
             rec(N, t, -inv(P), N[t] - q * T(Phi[t]) * h * T(h) * Phi[t]),
             function(p, [t], coeff(v[t], n + k - 1)),
             rec(u, t, monic_of(a0) * x, (u[t] + (1 - Z) * v[t]) / (1 - p(t))), rec(v, t, strict_of(g0) * x, ((Z - p(t)) * v[t] - p(t) * u[t]) / (1 - p(t) ** 2))],
      given=[standing("(6.1)", F * P * T(F) - P + q * (g0 - F * P * h) * T(g0 - F * P * h) == Zero(n, n)), standing("q is the inverse of 1 - h'Ph", q * (1 - T(h) * P * h) == 1),
             standing("zeros in the closed disc", outside_roots(monic_of(alpha)) == 0), standing("coprime", coprime(monic_of(a0), monic_of(a0 + 2 * g0)))],
      by=[steps(*CONVERGENCE, facts=[*POWERS_TEND, *_SIGNS],
                prose="By X.2, X.8 and (2.17). By X.13 and as D is definite, S has Jordan blocks of even size on the circle. The right side tends to zero "
                      "since the powers of the "
                      "closed loop do; with zeros on the circle by the theorem of Parlett and Poole. The sum of the two polynomials of the orbit tends to "
                      "alpha(z) times the "
                      "common factor, their difference to zero."),
          instances(16, n=(1, 2), k=(0, 1), m=(1, 2, 3), **FACTORED)],
      note="(a, g) are the reduced data and x the common factor theta; u and v are a_t(z) and g_t(z) along (2.16) from the full data. alpha is (6.2) for the P whose closed loop has its "
           "zeros in the closed disc, and r_t goes to 1/q, so that alpha(z)theta(z) is the limit.")

# ---------------------------------------------------------------------- Corollary 7.2
_EQUILIBRIUM = given("the orbit stays at the equilibrium", (u * x == w * x) & (v * x == w * x))
claim("BLZ94-C7.2.1", "for the points of the global stable manifold the reduced polynomials are coprime",
      coprime(u, v), sizes=["n", "k"], over={u: monic(n), v: monic(n), w: monic(n), x: monic(k)},
      given=[standing("w is Schur", schur(w)), standing("zeros of x outside", outside_roots(x) == k), _EQUILIBRIUM],
      by=[example(n=1, k=0, u=["1/2", 1], v=["1/2", 1], w=["1/2", 1], x=[1]), instances(n=(0,), k=(0, 1), made_by={u: w, v: w})],
      note="u, v are the reduced a, b of (7.1b) and w, x the two factors of the limit. A consequence: an equilibrium tends to itself, but a = b is not coprime with itself.",
      repair=repair("missing hypothesis", "Coprimeness must be asked of the zeros outside alone: a common zero s of the reduced a and b does no harm exactly if it lies inside. Then it is a "
                                          "zero of w, and what is left has the limit w(z)/(z - s); otherwise 1/s is one, and the limit is another.",
                    ~coprime(w, Z - p), sizes=["n"], over={u: monic(n), v: monic(n), w: monic(n + 1), s: nonzero(), r: nonzero()},
                    where=[let(p, when(abs(s) < 1, s, 1 / s))],
                    given=[given("w is Schur", schur(w)), given("(7.1a)", 2 * symmetric_part(u * (Z - s), v * (Z - s)) == r * w * recip(w))],
                    by=[steps("BLZ94-X.3", "BLZ94-X.4", facts=["a polynomial has one factorization into linear ones", "Theorem 7.1 (iii)"],
                              prose="At z = s the left side vanishes, so w(s) = 0 or w(1/s) = 0, and all zeros of w lie inside."),
                        instances(20, n=(1, 2), using={y: monic(n)},
                                  made_by={u: substitute(y, 4 * Z) / to_expr(4) ** n, v: u, w: u * (Z - when(abs(s) < 1, s, 1 / s)), r: when(abs(s) < 1, 2, 2 * s**2)}),
                        example(n=1, u=[0, 1], v=["4/5", 1], w=["-1/6", "1/6", 1], s="1/3", r="8/5"), example(n=1, u=[0, 1], v=["4/5", 1], w=["-1/6", "1/6", 1], s=3, r="72/5"),
                        example(n=1, u=[0, 1], v=[0, 1], w=["-1/6", "1/6", 1], s=3, r=1), example(n=0, u=[1], v=[1], w=["1/2", 1], s="1/3", r=1),
                        example(n=0, u=[1], v=[1], w=[-3, 1], s="1/3", r="2/9")]))

claim("BLZ94-C7.2.2", "for the points of the global unstable manifold the reduced polynomials are coprime",
      coprime(u, v), sizes=["n", "k"], over={u: monic(k), v: monic(k), w: monic(n), x: monic(k)},
      given=[standing("w is Schur", schur(w)), standing("zeros of x outside", outside_roots(x) == k), given("the orbit stays at the equilibrium", (u * w == w * x) & (v * w == w * x))],
      by=[example(n=0, k=1, u=[2, 1], v=[2, 1], w=[1], x=[2, 1]), instances(n=(0, 1), k=(0,), made_by={u: x, v: x})],
      note="u, v are a and b without the factor w. The equilibrium belongs to its unstable manifold, but a = b.",
      repair=repair("missing hypothesis", "A common zero s of the reduced a and b does no harm exactly if it lies outside: then it is a zero of the factor with zeros outside.",
                    ~coprime(x, Z - p), sizes=["k"], over={u: monic(k), v: monic(k), x: monic(k + 1), s: nonzero(), r: nonzero()},
                    where=[let(p, when(abs(s) > 1, s, 1 / s))],
                    given=[given("zeros of x outside", outside_roots(x) == k + 1), given("(7.1a)", 2 * symmetric_part(u * (Z - s), v * (Z - s)) == r * x * recip(x))],
                    by=[steps("BLZ94-X.3", "BLZ94-X.4", facts=["a polynomial has one factorization into linear ones", "Theorem 7.1 (iii), with S^(-1) for S"],
                              prose="At z = s the left side vanishes, so x(s) = 0 or x(1/s) = 0, and all zeros of x lie outside."),
                        instances(20, k=(1,), using={y: scalar()},
                                  made_by={u: Z - 4 - y**2, v: u, x: u * (Z - when(abs(s) > 1, s, 1 / s)), r: when(abs(s) > 1, 2, 2 * s**2)}),
                        example(k=0, u=[1], v=[1], x=["-3", 1], s="1/3", r="2/9"), example(k=0, u=[1], v=[1], x=["-3", 1], s=3, r=2),
                        example(k=0, u=[1], v=[1], x=["-3", 1], s=2, r=1), example(k=0, u=[1], v=[1], x=["-3", 1], s="1/2", r=1),
                        example(k=0, u=[1], v=[1], x=["-1/3", 1], s=3, r=18)]))

claim("BLZ94-C7.2.3", "the equilibria as a center manifold",
      forall(i, 1, n, (laurent(alpha[1][i], 0) == w[i]) & (laurent(alpha[1][i], 1) == u[i]) & (laurent(gamma[1][i], 0) == 0)
             & (laurent(gamma[1][i], 1) == (B * v)[i, 1])) & (charpoly(B) == monic_of(w)), sizes=["n"],
      over={w: vector(n), u: vector(n), v: vector(n)},
      where=[let(alpha0, w + u / Z), let(gamma0, v / Z), *ORBIT, let(B, matrix_of(i, j, n, n, when(i < n, when(j == i + 1, 1, 0), -w[n - j + 1])))],
      by=[steps("BLZ94-X.4", facts=["center manifold theorem: an invariant manifold that is tangent to the center space is a center manifold"],
                prose="E consists of fixed points. In the direction (u, v) at (w, 0) the derivative is (u, Bv), so E is tangent to the eigenspace of the eigenvalue one, and the other "
                      "eigenvalues are the zeros of w(z), none of which is on the circle here."),
          instances(20, n=(1, 2, 3))],
      note="The first two terms of a step in powers of 1/z, from (w + u/z, v/z).")
