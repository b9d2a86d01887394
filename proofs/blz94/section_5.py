# SPDX-License-Identifier: MIT
"""Section 5: the equilibria of the fast algorithm, and its derivative there.

The last entry of alpha = A(gamma) alpha gives alpha_n gamma_0 = 0, then the one before it alpha_{n-1} gamma_1 = 0, and so on; with these the last row
of gamma = G(alpha) gamma says gamma_{n-1} = 0, and the other rows that all entries are equal. So the equilibria are the points (alpha, 0). A(gamma)
is the identity up to terms of second order. So near (alpha, 0) a step adds nothing to alpha and multiplies gamma by G(alpha), to first order: the
characteristic polynomial of the derivative is (z - 1)^n alpha(z). There are always n eigenvalues at 1, along the equilibria themselves, and no
equilibrium is hyperbolic in the usual sense.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, generic_index, identity, induction, instances, lemma, part, steps, use
from exactkf.language import (
    Identity,
    Z,
    Zero,
    always,
    block,
    charpoly,
    circle_roots,
    column,
    forall,
    function,
    given,
    iff,
    inside_roots,
    laurent,
    let,
    matrix_of,
    nonzero,
    outside_roots,
    positive,
    prod,
    rec,
    scalar,
    schur,
    standing,
    sum_of,
    symbols,
    vector,
    vstack,
    when,
)
from proofs.blz94.notation import COMPANION, ORBIT, A, G, alpha, alpha0, gamma, gamma0, i, j, k, m, monic_of, n, t

c, s, u, v, w, x, y, B, C, mu, f, row = symbols("c s u v w x y B C mu f row")
_POINT = {"sizes": ["n"], "over": {alpha0: vector(n), gamma0: vector(n)}}

#: f of (5.1b) at (alpha0, gamma0)
_F = (function(gamma, [t], gamma0), *COMPANION[:1], let(x, A[0] * alpha0), let(B, matrix_of(i, j, n, n, when(i < n, when(j == i + 1, 1, 0), -x[n - j + 1]))),
    let(y, B * gamma0))

# ---------------------------------------------------------------------- the dynamical system
_MOVED = lemma(k, forall(u, k, n - 1, alpha[1][k + 1] == x(k + 1)), direct=True, uses=[use(x, k + 1), use(alpha, 1, row=k + 1)])
_SUMS = lemma(k, forall(u, k, n, sum_of(j, 1, k, x(n - j + 1) * gamma0[j]) == sum_of(j, 1, k, alpha[1][n - j + 1] * gamma0[j])),
              uses=[use(1, k=k, u=u), use(0, k=n - k - 1, u=n - 1)])
claim("BLZ94-E5.1", "a step of the algorithm is the map f", (alpha[1] == A[0] * alpha0) & (gamma[1] == B * gamma0), **_POINT,
      where=[*ORBIT, function(x, [t], (A[0] * alpha0)[t]), let(B, matrix_of(i, j, n, n, when(i < n, when(j == i + 1, 1, 0), -x(n - j + 1))))],
      by=[generic_index(_MOVED, _SUMS, closed=[x], whole=[alpha], uses=[use(alpha, 1, row=row), use(1, k=n, u=n)]), instances(n=(1, 2, 3))],
      note="B is G(A(gamma) alpha); the left sides are a step of (4.4). The step from t to t + 1 is the same.")

not_checked("BLZ94-S27", "linear stability, and the decomposition into stable, unstable and central subspaces",
            "classical theorems about every dynamical system, quoted from the literature; no formula of the paper enters")
not_checked("BLZ94-S28", "the center manifold theorem",
            "a classical theorem about every dynamical system, quoted from the literature; no formula of the paper enters")

# ---------------------------------------------------------------------- Lemma 5.1
claim("BLZ94-L5.1.1", "the equilibria are the points with gamma = 0", iff(vstack(x, y) == vstack(alpha0, gamma0), gamma0 == 0 * gamma0), **_POINT, where=_F,
      by=[instances(20, n=(1, 2, 3)),
          instances(8, n=(1, 2, 3), made_by={alpha0: 0 * gamma0}), instances(6, n=(1, 2, 3), made_by={gamma0: 0 * alpha0}),
          example({alpha0: [-1], gamma0: [1]}, n=1)], note="(x, y) is f(alpha, gamma).")

claim("BLZ94-S29", "alpha stays if and only if all alpha_{n-i} gamma_i vanish; then gamma stays only if it is zero; A is I to first order",
      iff(alpha[1] == alpha0, v == 0 * v) & (G[0] * gamma0 == column(i, n, when(i < n, gamma0[i + 1], -sum_of(j, 1, n, v[j]))))
      & forall(i, 1, n, forall(j, 1, n, (laurent(x(i, j), 0) == when(i == j, 1, 0)) & (laurent(x(i, j), 1) == 0))), **_POINT,
      where=[*ORBIT, let(v, column(i, n, alpha0[i] * gamma0[n - i + 1])),
          function(x, [i, j], when(i > j, 0, when(i == j, 1 / (1 - (gamma0[n - i + 1] / Z) ** 2), gamma0[n - i + 1] * gamma0[n - j + 1] / Z**2
                                                            / prod(k, i, j, 1 - (gamma0[n - k + 1] / Z) ** 2))))],
      by=[instances(10, n=(1, 2, 3)), instances(6, n=(1, 2, 3), made_by={alpha0: 0 * gamma0}), instances(6, n=(1, 2, 3), made_by={gamma0: 0 * alpha0}),
          instances(6, n=(2, 3), using={u: scalar(), s: scalar()},
              made_by={alpha0: column(i, n, when(i == n, u, 0)), gamma0: column(i, n, when(i == 1, 0, s))})],
      note="x(i, j) are the entries of A(gamma/z): their coefficients of z^0 and 1/z are A(0) and the derivative of A at 0 in the direction gamma. "
           "v has the products alpha_{n-i} gamma_i; if they vanish, gamma = G(alpha) gamma says that gamma_{n-1} is zero and gamma_i = gamma_{i+1}.")

#: a step from the point (w, 0) in the direction (u, v)
_NEAR = {"sizes": ["n"], "over": {w: vector(n), u: vector(n), v: vector(n)}, "where": [let(alpha0, w + u / Z), let(gamma0, v / Z), *ORBIT,
         let(B, matrix_of(i, j, n, n, when(i < n, when(j == i + 1, 1, 0), -w[n - j + 1])))]}
claim("BLZ94-L5.1.2", "the derivative of f at an equilibrium",
      forall(i, 1, n, (laurent(alpha[1][i], 0) == w[i]) & (laurent(alpha[1][i], 1) == u[i]) & (laurent(gamma[1][i], 0) == 0)
          & (laurent(gamma[1][i], 1) == (B * v)[i, 1])), **_NEAR,
      by=[identity(n=range(1, 4)), instances(n=(1, 2, 3))],
      note="A step from (w, 0) + (u, v)/z, in powers of 1/z. B is G(w).")

# ---------------------------------------------------------------------- eigenvalues and invariant manifolds
_JACOBIAN = (let(B, matrix_of(i, j, n, n, when(i < n, when(j == i + 1, 1, 0), -alpha0[n - j + 1]))),
    let(C, block([[Identity(n), Zero(n, n)], [Zero(n, n), B]])),
             let(x, charpoly(C)), let(y, monic_of(alpha0)))
_AT = {"sizes": ["n"], "over": {alpha0: vector(n)}, "where": _JACOBIAN}
_KINDS = (instances(10, n=(1, 2, 3)), instances(6, n=(1, 2, 3), using={v: vector(n)}, made_by={alpha0: column(i, n, v[i] / 9)}),
    example({alpha0: [0, 1]}, n=2), example({alpha0: [0]}, n=1),
          example({alpha0: ["1/2", "-1/2"]}, n=2), example({alpha0: ["-5/2", 1]}, n=2))
claim("BLZ94-X.22", "the characteristic polynomial of the derivative at an equilibrium", x == (Z - 1) ** n * y, **_AT,
      by=[identity(n=range(1, 6)), instances(n=(1, 2, 3))])

_HYPERBOLIC = circle_roots(x) == 0
claim("BLZ94-S30", "for a Schur polynomial n eigenvalues lie inside; an equilibrium is hyperbolic if and only if alpha(z) has no root on the circle",
      (schur(y) >> (inside_roots(x) == n)) & iff(_HYPERBOLIC, inside_roots(y) + outside_roots(y) == n)
          & (inside_roots(y) + outside_roots(y) == n - circle_roots(y)), **_AT,
      by=[example({alpha0: [0]}, n=1), instances(n=(1, 2))],
      note="An equilibrium is hyperbolic if the derivative has no eigenvalue of modulus one; x is its characteristic polynomial, y is alpha(z). "
           "That s + u = n says the same as c = 0 is the last equation. In the example x = z(z - 1).",
      repair=repair("other", "One is an eigenvalue n times over, so no equilibrium is hyperbolic; what alpha(z) decides is whether there are other "
                             "eigenvalues of modulus one than "
                             "those along the equilibria.",
                    (schur(y) >> (inside_roots(x) == n)) & iff(circle_roots(x) == n, inside_roots(y) + outside_roots(y) == n)
                    & (inside_roots(y) + outside_roots(y) == n - circle_roots(y)), **_AT,
                    by=[steps("BLZ94-L5.1.2", "BLZ94-X.22", prose="Count the roots of (z - 1)^n alpha(z)."), *_KINDS]))

claim("BLZ94-T5.2.1", "dimensions of the stable, the unstable and the center manifolds",
      (inside_roots(x) == inside_roots(y)) & (outside_roots(x) == outside_roots(y)) & (circle_roots(x) == n + circle_roots(y)), **_AT,
      by=[steps("BLZ94-L5.1.2", "BLZ94-X.22", facts=["stable manifold theorem", "center manifold theorem"],
                prose="The dimensions are the numbers of eigenvalues inside, outside and on the circle, which are roots of (z - 1)^n alpha(z)."), *_KINDS])

not_checked("BLZ94-T5.2.2", "a center manifold contains the equilibria nearby",
            "a statement about all invariant manifolds, for which there is no formula here. If M is y = 0 in suitable coordinates, y is multiplied in a step "
            "by a matrix without "
            "eigenvalue one, so that an equilibrium has y = 0")

claim("BLZ94-T5.2.3", "without roots on the circle the equilibria are the center manifold, and stability is that alpha(z) is Schur",
      (inside_roots(x) + outside_roots(x) == n) & iff(inside_roots(x) == n, schur(y)), **_AT, given=[given("no root on the circle", circle_roots(y) == 0)],
      by=[steps("BLZ94-X.4", "BLZ94-X.22", facts=["center manifold theorem", "an eigenvalue outside the disc makes an equilibrium unstable"],
                prose="A center manifold has dimension n and contains the equilibria nearby, so it consists of them. If no eigenvalue lies outside, an orbit "
                      "nearby approaches one on the "
                      "center manifold, that is an equilibrium."), *_KINDS],
      note="There is no eigenvalue outside exactly if n lie inside, that is if the stable manifold has dimension n. x is the characteristic polynomial of the "
           "derivative, y is alpha(z).")

# ---------------------------------------------------------------------- the rate
_ORDER_ONE = (rec(alpha, t, x, alpha[t] / (1 - gamma[t] ** 2)), rec(gamma, t, y, -gamma[t] * alpha[t] / (1 - gamma[t] ** 2)))
_ON_CURVE = given("(w, 0) lies on the level set", y**2 * w == (x - w) * (w * x - 1))
claim("BLZ94-S31", "alpha_t is at most a constant times mu^t",
      alpha[m] ** 2 < (c * w**m) ** 2 * (x**2 + y**2), over={w: scalar(), x: scalar(), y: scalar(), c: positive()},
      where=[*_ORDER_ONE, function(f, [t], when(c * abs(w) ** t <= 1, t, f(t + 1))), let(m, f(0))],
      given=[standing("|w| < 1", (abs(w) < 1) & (w != 0)), _ON_CURVE],
      by=[example({w: "1/2", x: "1/2", y: 0, c: 10}), example({w: "1/2", x: "1/2", y: 0, c: 1}),
          instances(made_by={x: (u**2 * w**2 - 1) / (w * (u**2 - 1)), y: u * (x - w)}, using={u: scalar()})],
      note="For n = 1, (w, 0) the limit, so mu = |w|, and (x, y) the initial condition; c is the constant C, and m the first time with C mu^m at most 1. At "
           "the equilibrium (1/2, 0) alpha_t stays 1/2 "
           "and mu^t tends to zero, so the bound is false at m whatever C is. The points of the level set other than (w, 0) are those with y = u(x - w), as in the correction.",
      repair=repair("other", "It is alpha_t - alpha_infinity that tends to zero, and with it gamma_t. For n = 1 it is alpha_0 - alpha_infinity times "
                             "alpha_infinity^t and the product of alpha_1, ..., alpha_t.",
                    always(t, alpha[t] - w == s[t] * (x - w)), over={w: nonzero(), u: scalar()},
                    where=[let(x, (u**2 * w**2 - 1) / (w * (u**2 - 1))), let(y, u * (x - w)), *_ORDER_ONE, rec(s, t, 1, w * alpha[t + 1] * s[t])],
                    by=[induction(also=[gamma[t] ** 2 * w == (alpha[t] - w) * (w * alpha[t] - 1)],
                                  cofactors=[[(w * alpha[t + 1], 0, 1), (1 / (1 - gamma[t] ** 2), 1, 1)], [(1 / (1 - gamma[t] ** 2), 1, 1)]]), instances(16),
                        part("n = 1")]))
