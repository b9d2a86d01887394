# SPDX-License-Identifier: MIT
"""Section 7: the points that escape.

A step of (4.4) divides by the 1 - gamma_k^2, k = 0, ..., n - 1, and by nothing else. In terms of S: det X_{t+1} is r_1 ... r_t,
up to a power of alpha_n, and r_t is the product of the first t of them.

No equilibrium escapes. So on the line from (alpha, 0) to (alpha, gamma) what a step divides by is not zero at first, and the
polynomials that vanish where the orbit escapes at time t are not zero: the points that escape are a set of measure zero. A point with sign
definite D whose orbit enters the open set P_n of positive real data has a neighbourhood in which all do, and there nothing escapes any more. By the
theorem this is so if the limit has all zeros inside: a and b have no common factor, and D has no zero on the circle, which would be a double one.
What is left, for the closure of the definite points that escape, are these points and the zero sets of two polynomials, the resultant of a, b and the
discriminant of D. They are not zero: a - b is constant for alpha = 0, gamma = (0, ..., 0, x), and D has simple zeros for gamma = 0, alpha = (0, ..., 0, x).
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, identity, instances, restated, steps
from exactkf.language import (
    Expr,
    Identity,
    T,
    Z,
    Zero,
    coeff,
    column,
    coprime,
    det,
    exists,
    forall,
    function,
    given,
    iff,
    inv,
    let,
    matrix_of,
    nonneg_on_circle,
    pos_on_circle,
    prod,
    rec,
    scalar,
    schur,
    standing,
    substitute,
    sum_of,
    symbols,
    to_expr,
    vector,
    when,
)
from proofs.blz94.notation import (
    FAST,
    HALF,
    ORBIT,
    SHIFT,
    VECTORS,
    D,
    J,
    a,
    a0,
    a_of,
    alpha,
    alpha0,
    b,
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
    phi,
    phis,
    psi,
    psis,
    symmetric_part,
    t,
)
from proofs.blz94.section_7_convergence import CONVERGENCE, POWERS_TEND

A, B, S, X, Y, c, d, e, f, p, q, u, v, w, x, x0, y = symbols("A B S X Y c d e f p q u v w x x0 y")

#: a and g of the point (alpha0, gamma0), by (4.1)
_POINT = (
    rec(phi, k, 1, Z * phi[k] - gamma0[k + 1] * phis[k]), rec(phis, k, 1, phis[k] - gamma0[k + 1] * Z * phi[k]),
    rec(psi, k, 1, Z * psi[k] + gamma0[k + 1] * psis[k]), rec(psis, k, 1, psis[k] + gamma0[k + 1] * Z * psi[k]),
    let(a, phi[n] + sum_of(i, 1, n, alpha0[i] * phi[n - i])), let(b, psi[n] + sum_of(i, 1, n, alpha0[i] * psi[n - i])),
)
_POWERS = (*_POINT, let(a0, column(i, n, coeff(a, n - i))), let(g0, column(i, n, HALF * coeff(b - a, n - i))), *SHIFT, let(B, J - (a0 + g0) * T(h)),
           rec(X, t, Identity(n), inv(T(B)) * (X[t] - h * T(h) * Y[t])), rec(Y, t, Zero(n, n), g0 * T(g0) * inv(T(B)) * (X[t] - h * T(h) * Y[t]) + B * Y[t]))
_ESCAPE = {"sizes": ["n"], "over": {alpha0: vector(n), gamma0: vector(n)}, "where": _POWERS}
_SINGULAR = exists(t, 1, n + 1, det(X[t]) == 0)
claim("BLZ94-S54", "escape corresponds to the two hyperplanes on which the last gamma has modulus one",
      iff(_SINGULAR, gamma0[n] ** 2 == 1), **_ESCAPE, given=[standing("alpha_n != 0", alpha0[n] != 0)],
      by=[example(n=2, alphabar=[0, 2], gammabar=[1, 0]), instances(n=(1, 2))],
      note="X_t is the upper half of S^t(I; 0), so that P_0 = 0; for t <= n + 1 it depends on gamma_0, ..., gamma_{n-1} alone. Later steps are those from a "
           "later start, and each brings one new gamma_{n-1}. So the print is right for the points of U_gamma, gamma_0^2, ..., gamma_{n-2}^2 != 1. But the "
           "theorem speaks of points of R^{2n}; in the example n = 2, gamma = (1, 0), (2.16) and (4.4) divide by zero at once, and D = 4 + 2z^2 + 2z^(-2) is "
           "even sign definite.",
      repair=repair("boundary case", "The hyperplanes on which one of the other gammas has modulus one belong to the points that escape too, in the first "
                                     "step.",
                    forall(t, 0, n, det(X[t + 1]) * det(B) ** (t + 1) == prod(k, 1, t, (1 - gamma0[k] ** 2) ** (t + 1 - k))), **_ESCAPE,
                    by=[identity(n=(1, 2, 3)), instances(n=(1, 2, 3))]))

_LAST = column(i, n, when(i == n, x, 0))
claim("BLZ94-X.12", "a and b without common factor, D with simple zeros, and D that is not sign definite, for every n",
      (e - d == 2 * x) & (c == x * Z**n + (1 + x**2) + x * Z ** (-n)) & (q == 1 + x * (Z + 1 / Z)), sizes=["n"], over={x: scalar()},
      where=[let(v, _LAST),
             rec(phi, t, 1, Z * phi[t] - v[t + 1] * phis[t]), rec(phis, t, 1, phis[t] - v[t + 1] * Z * phi[t]),
             rec(psi, t, 1, Z * psi[t] + v[t + 1] * psis[t]), rec(psis, t, 1, psis[t] + v[t + 1] * Z * psi[t]),
             let(d, phi[n]), let(e, psi[n]), rec(f, t, 1, Z * f[t]), let(p, f[n] + sum_of(i, 1, n, v[i] * f[n - i])), let(c, symmetric_part(p, p)),
             let(q, symmetric_part(phi[n] + x * phi[n - 1], psi[n] + x * psi[n - 1]))],
      given=[standing("n >= 1", n >= 1)],
      by=[identity(n=range(1, 7)), instances(n=(1, 2, 3)),
          restated("polynomials that differ by a constant that is not zero are coprime", "z^n + x has simple zeros if x is not zero")],
      note="Not printed. First a and b for alpha = 0, gamma = (0, ..., 0, x): their difference is 2x, so they are coprime if x is not zero. Then D for alpha "
           "= (0, ..., 0, x) and gamma = 0, where all Szego polynomials are powers of z: its zeros are those of z^n + x and of z^n + 1/x, all simple if x is "
           "not 0, 1 or -1. So F_1 and F_2 do not contain all points, and the polynomials that define them are not zero. Last D for alpha = (x, 0, ..., 0), "
           "gamma = (0, ..., 0, x).")

# ---------------------------------------------------------------------- Theorem 7.1 (i)
#: convergence if D has no zero on the circle: then S has n eigenvalues inside and n outside
_GAP = (*CONVERGENCE, "BLZ94-X.4", "BLZ94-X.12")
_POWERS_OF_S = [POWERS_TEND[-1], "a matrix without eigenvalues on the circle is similar to the direct sum of one with all inside and one with all outside"]
_TAME = ["zeros of a polynomial and the least value of D on the circle depend continuously on the coefficients",
         "Schur: |gamma_t| < 1 for positive real v, and a step keeps v positive real"]
_NULL = ["a polynomial that is not zero vanishes on a set of measure zero; countably many such sets have measure zero together"]


def _in_p(p: Expr, q: Expr) -> Expr:
    """(2.13)-(2.15)."""
    return pos_on_circle(symmetric_part(p, q)) & schur(p) & schur(q)


_DOUBLE = (let(p, Z**n * D), let(d, sum_of(k, 1, 2 * n, k * coeff(p, k) * Z ** (k - 1))))
#: q is the first t at which the orbit is in P_n, or -1 if the orbit is back before
_ENTERS = (function(f, [t], when(_in_p(monic_of(a[t]), monic_of(a[t] + 2 * g[t])), t, when((t > 0) & (a[t] == a0) & (g[t] == g0), -1, f(t + 1)))), let(q, f(0)))
#: c(k) is the first l >= k with the point at (v, w)/2^l from (a0, g0) in P_n at time q
_NEAR = (function(x, [k, t], when(t == 0, a0 + v / to_expr(2) ** k, 1 / (1 - y(k, t - 1)[1]) * (x(k, t - 1) + (Identity(n) - J) * y(k, t - 1)))),
         function(y, [k, t], when(t == 0, g0 + w / to_expr(2) ** k,
                                  1 / (1 - y(k, t - 1)[1] ** 2) * (-y(k, t - 1)[1] * x(k, t - 1) + (J - y(k, t - 1)[1] * Identity(n)) * y(k, t - 1)))),
         function(c, [k], when(_in_p(monic_of(x(k, q)), monic_of(x(k, q) + 2 * y(k, q))), k, c(k + 1))), let(e, when(q >= 0, c(0), -1)))
_BESIDE = given("not in F_1", coprime(monic_of(a0), monic_of(a0 + 2 * g0))), standing("not in F_2", coprime(p, d) | (a0[n] + g0[n] == 0))
claim("BLZ94-S56", "the closure of the definite points that escape adds only points with a common factor or a double zero",
      e >= 0, sizes=["n"], over={a0: vector(n), g0: vector(n), v: vector(n), w: vector(n)},
      where=[*FAST, let(D, symmetric_part(monic_of(a0), monic_of(a0 + 2 * g0))), *_ENTERS, *_NEAR, *_DOUBLE],
      given=[given("D is sign definite", nonneg_on_circle(D) | nonneg_on_circle(-D)), *_BESIDE],
      by=[steps(*_GAP, facts=[*_POWERS_OF_S, *_TAME, *_NULL],
                prose="Let a point with sign definite D be in neither set and not escape. By Theorem 7.1 (iii) its orbit tends to a polynomial with D as a "
                      "multiple of its product with the reversed one, so that a zero on the circle would be a double zero of D: all are inside, and the "
                      "orbit enters the open set P_n. What is near enough follows it there, without dividing by zero before, and then stays. F_1 and F_2 are "
                      "zero sets of polynomials, or have alpha_n = 0; by X.12 these polynomials are not zero."),
          example({a0: [2], g0: [0], v: [0], w: [1]}, n=1), example({a0: [3], g0: ["-1/2"], v: [1], w: [1]}, n=1),
          example({a0: ["1/3"], g0: ["7/3"], v: [0], w: [1]}, n=1),
          example({a0: [0, 2], g0: ["1/2", "1/3"], v: [1, -1], w: [-1, 1]}, n=2),
          example({a0: ["9/2", -4], g0: ["1/2", 4], v: [1, 0], w: [0, 1]}, n=2),
          instances(20, n=(1, 2), using={u: vector(n), x0: vector(n)}, made_by={a0: column(i, n, u[i] / 2), g0: column(i, n, x0[i] / 5)})],
      note="The points outside the right side of the inclusion are those here and those with indefinite D, which are an open set: no sequence of definite "
           "points tends to them. The orbit from (a, g) enters P_n at a time q, and then that from (a, g) + (v, w)/2^k is in P_n at time q for some k, the "
           "first of which is e. (alpha, gamma) are coordinates of (a, b) near a point that does not escape (Proposition 4.1). A double zero of D off the "
           "circle, and alpha_n = 0, would do no harm: with D definite it is enough that D has no zero on the circle. "
           "F_2 is not closed for n > 1 (gamma = 0, alpha(z) = (z - s)^n, s to 0), so no algebraic set, but lies in one that is not everything.")

#: along the line from (alpha0, 0) to (alpha0, gamma0), that is from (alpha0, z gamma0)
_LINE = (function(X, [t], matrix_of(i, j, n, n, when(i > j, 0, when(i == j, 1 / (1 - v[t][n - i + 1] ** 2),
                                                                    v[t][n - i + 1] * v[t][n - j + 1] / prod(k, i, j, 1 - v[t][n - k + 1] ** 2))))),
         function(Y, [t], matrix_of(i, j, n, n, when(i < n, when(j == i + 1, 1, 0), -u[t][n - j + 1]))),
         rec(u, t, alpha0, X[t] * u[t]), rec(v, t, Z * gamma0, Y[t + 1] * v[t]), function(y, [t], prod(k, 1, n, 1 - v[t][k] ** 2)))
_RETURNS = (function(f, [t], when(_in_p(monic_of(a_of[t]), monic_of(b_of[t])), t, when((t > 0) & (alpha[t] == alpha0) & (gamma[t] == gamma0), -1, f(t + 1)))),
            let(q, f(0)))
claim("BLZ94-T7.1.1", "the points that escape, and the closure of those among them with sign definite D, have measure zero",
      forall(t, 0, m, substitute(y(t), 0) == 1) & (q >= 0), sizes=["n", "m"], over={alpha0: vector(n), gamma0: vector(n)},
      where=[*ORBIT, *VECTORS, let(D, symmetric_part(monic_of(a_of[0]), monic_of(b_of[0]))), *_RETURNS, *_DOUBLE, *_LINE],
      given=[given("D is sign definite", nonneg_on_circle(D) | nonneg_on_circle(-D)), given("not in F_1", coprime(monic_of(a_of[0]), monic_of(b_of[0]))),
             standing("not in F_2", coprime(p, d) | (alpha0[n] == 0))],
      by=[restated(*_NULL, *_TAME, "a line with infinitely many points in the zero set of a polynomial lies in it"),
          steps(*_GAP, facts=[*_POWERS_OF_S, *_TAME, *_NULL],
                prose="What step t divides by is a rational function of (alpha, gamma), as long as no step before divided by the zero function; it is one at "
                      "equilibria, where nothing moves (X.4), so it is not the zero function. The points that escape at time t are in its zero set. The "
                      "closure lies in the union of the definite points that escape and the two sets of S56, in which the polynomials of X.12 vanish."),
          example({alpha0: [2], gamma0: [0]}, n=1, m=1), example({alpha0: [3], gamma0: ["3/2"]}, n=1, m=2),
          example({alpha0: ["8/3"], gamma0: ["7/3"]}, n=1, m=1),
          example({alpha0: [0, 2], gamma0: ["1/2", "1/3"]}, n=2, m=1),
          example({alpha0: [4, 0], gamma0: ["1/2", 2]}, n=2, m=1),
          instances(14, n=(1, 2), m=(1,)), instances(6, n=(1,), m=(2, 3))],
      note="Measure itself is not computed: it comes in by the named facts. y(t) is what step t divides by along the line through (alpha, 0) at z = 0 and (alpha, gamma) at z = 1: it is one at z = 0, so the points that "
           "escape at time t are finitely many on this line. For the closure: if a point with sign definite D is in neither of the sets F_1 and F_2 of S56, "
           "its orbit enters the positive real region, at a time q; then no point near it escapes. S54 describes the points that escape at first.")

#: y(k) is D of the k-th point near (alpha0, gamma0), y(-1) of that point itself, e of (x, 0, ..), (.., 0, x)
_SZEGO = (function(phi, [k, t], when(t == 0, 1, Z * phi(k, t - 1) - g0(k)[t] * phis(k, t - 1))),
          function(phis, [k, t], when(t == 0, 1, phis(k, t - 1) - g0(k)[t] * Z * phi(k, t - 1))),
          function(psi, [k, t], when(t == 0, 1, Z * psi(k, t - 1) + g0(k)[t] * psis(k, t - 1))),
          function(psis, [k, t], when(t == 0, 1, psis(k, t - 1) + g0(k)[t] * Z * psi(k, t - 1))))
_D_NEAR = (function(y, [k], symmetric_part(phi(k, n) + sum_of(i, 1, n, a0(k)[i] * phi(k, n - i)), psi(k, n) + sum_of(i, 1, n, a0(k)[i] * psi(k, n - i)))),
           function(f, [k], when(nonneg_on_circle(y(k)) | nonneg_on_circle(-y(k)), when(k >= 60, -1, f(k + 1)), k)), let(q, f(0)),
           let(b, Z**n + x * Z ** (n - 1)), let(e, symmetric_part(b - x, b + x)))
_INDEFINITE = ~(nonneg_on_circle(y(-1)) | nonneg_on_circle(-y(-1)))
claim("BLZ94-S58", "the points whose D is not sign definite are an unbounded open set",
      (q >= 0) & (coeff(e, 0) == 1) & iff(abs(x) > HALF, ~nonneg_on_circle(e)), sizes=["n"],
      over={alpha0: vector(n), gamma0: vector(n), v: vector(n), w: vector(n), x: scalar()},
      where=[function(a0, [k], alpha0 + when(k < 0, 0, 1 / to_expr(2) ** k) * v), function(g0, [k], gamma0 + when(k < 0, 0, 1 / to_expr(2) ** k) * w), *_SZEGO,
             *_D_NEAR],
      given=[given("D is not sign definite", _INDEFINITE)],
      by=[steps("BLZ94-X.12", facts=["a polynomial is continuous"],
                prose="D has values of both signs on the circle, and they depend continuously on (alpha, gamma). The points alpha = (x, 0, ..., 0), gamma = "
                      "(0, ..., 0, x) are not bounded, and D = 1 + x(z + 1/z) has the values 1 + 2x and 1 - 2x."),
          example({alpha0: [3], gamma0: [0], v: [1], w: [0], x: 1}, n=1), instances(24, n=(1, 2))],
      note="Open: of the points (alpha, gamma) + (v, w)/2^k, in any direction (v, w), one with k <= 60 has an indefinite D too, the first such k being q. "
           "Unbounded: e is D of alpha = (x, 0, ..., 0), gamma = (0, ..., 0, x), whose length is |x| times the root of two; its mean on the circle is one, "
           "so D has positive values, and negative ones exactly if |x| > 1/2.")
