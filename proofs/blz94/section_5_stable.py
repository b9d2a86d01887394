# SPDX-License-Identifier: MIT
"""Section 5: the stable manifold of an equilibrium, and what the invariants determine.

At (w, 0) the derivative of D in the directions of gamma vanishes, since the derivatives of a and b in these directions are opposite to each other: p
= -q. If w(z) has no pair of reciprocal roots these directions are the tangent space of the level set of D, and if w(z) is Schur they are the
directions that the derivative of f contracts. So the level set is then the stable manifold. The polynomials (p, -p) are all reached; the derivative
of a with respect to gamma_i is -(z^{n-1-i} + w_1 z^{n-2-i} + ...), of which only the first term belongs to the Szego polynomial phi_n.

D determines w as its Schur factor, that is as a function of h_1, ..., h_n which is analytic and algebraic, but not rational: the reversed factor has
the same h_i.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, generic_index, identity, instances, steps
from exactkf.language import (
    T,
    Z,
    Zero,
    coeff,
    column,
    coprime,
    det,
    function,
    given,
    hstack,
    inv,
    invertible,
    let,
    matrix_of,
    monic,
    nonneg_on_circle,
    nonzero,
    pos_on_circle,
    positive,
    rank,
    rational,
    recip,
    rev,
    scalar,
    schur,
    sequence,
    standing,
    sum_of,
    symbols,
    to_expr,
    vector,
    vstack,
    when,
)
from proofs.blz94.lemmas_tangent import TANGENT, K, M, operator, q, shared
from proofs.blz94.lemmas_tangent import f as phi_line
from proofs.blz94.notation import (
    FAST,
    HALF,
    KIMURA,
    D,
    a,
    a0,
    alpha,
    alpha0,
    b,
    g,
    g0,
    gamma,
    gamma0,
    i,
    j,
    k,
    monic_of,
    n,
    phi,
    psi,
    symmetric_part,
    t,
)

c, l, s, u, v, w, x, y, f, VA, VB, PA, PB = symbols("c l s u v w x y f V_a V_b P_a P_b")
#: the point (alpha0, 0)
_AT_REST = (let(gamma0, 0 * alpha0), *TANGENT)
_EQUILIBRIUM = {"sizes": ["n"], "over": {alpha0: vector(n)}}

# ---------------------------------------------------------------------- Theorem 5.9
_VERTICAL = matrix_of(i, j, n + 1, n, K[i, n + j])
claim("BLZ94-T5.9.1", "at a Schur equilibrium the level set has the tangent space of the stable manifold",
      (rank(M) == n + 1) & (_VERTICAL == Zero(n + 1, n)), **_EQUILIBRIUM, where=_AT_REST, given=[given("Schur", schur(monic_of(alpha0)))],
      by=[steps("BLZ94-X.21", "BLZ94-S37", "BLZ94-X.22", facts=["stable manifold theorem", "implicit function theorem"],
                prose="By M the level set is smooth of dimension n, with the directions of gamma as tangent space; these are the eigenspace of the "
                      "eigenvalues inside. The stable manifold lies "
                      "in the level set, as the h_i are constant along orbits and continuous, and has the same dimension."),
          instances(16, n=(1, 2, 3), using={v: vector(n)}, made_by={alpha0: column(i, n, v[i] / 9)}), example({alpha0: [1]}, n=1),
          example({alpha0: ["-5/2", 1]}, n=2),
          example({alpha0: ["1/2", "-1/2"]}, n=2)],
      note="V is the part of K for the directions of gamma: D does not change along them to first order, and rank n + 1 of M says that dh_1, ..., dh_n are "
           "independent.")


def _data(have, want):
    """The column of b_1, ..., b_n and r with (a b* + a* b)/2 = r w w* for these a and w."""
    return (inv(matrix_of(i, j, n + 1, n + 1, when(j <= n, coeff(symmetric_part(have, Z ** (n - j)), i - 1), -coeff(want * recip(want), i - 1))))
            * column(i, n + 1, -coeff(symmetric_part(have, Z**n), i - 1)))


_POSITIVE = {"using": {u: vector(n), v: vector(n), y: vector(n + 1), s: scalar()},
             "made_by": {a0: column(i, n, u[i] / to_expr(4) ** i), w: column(i, n, v[i] / to_expr(4) ** i), y: _data(monic_of(a0), monic_of(w)),
                 g0: column(i, n, HALF * (y[i] - a0[i])),
                         c: y[n + 1], x: rational("1/200") + s**2 / 500}}
_BOTH = monic_of(a0) + monic_of(a0 + 2 * g0)
_POSITIVE_REAL = [standing("a is Schur", schur(monic_of(a0))), standing("D is positive", pos_on_circle(D))]
_ON_LEVEL = given("(w, 0) lies on the level set", D == c * monic_of(w) * recip(monic_of(w)))
_AWAY = T(a[t] - w) * (a[t] - w) + T(g[t]) * g[t]
claim("BLZ94-T5.9.2", "from positive real data the orbit tends to the Schur factor of D", q >= 0, sizes=["n"],
      over={a0: vector(n), g0: vector(n), w: vector(n), c: scalar(), x: positive()},
      where=[*FAST, let(D, symmetric_part(monic_of(a0), monic_of(a0 + 2 * g0))),
             function(f, [t], when(_AWAY[1, 1] <= x, t, when((t > 0) & (a[t] == a0) & (g[t] == g0), -1, f(t + 1)))), let(q, f(0))],
      given=[*_POSITIVE_REAL, _ON_LEVEL, given("w is Schur", schur(monic_of(w)))],
      by=[steps("BLZ94-E2.18", "BLZ94-X.2", "BLZ94-X.8",
          facts=["for positive real v the Riccati recursion from zero is monotone and bounded", "a polynomial has one factorization into linear ones"],
                prose="The orbit converges, by the classical theory; D is a multiple of the limit polynomial times its reversal, all limits of positive real "
                      "data are stable, so the limit is w."),
          instances(12, n=(1, 2), **_POSITIVE), example(n=1, abar=["1/2"], gbar=[0], w=["1/3"], c=1, x="1/1000"),
          example(n=1, abar=["1/2"], gbar=[0], w=[2], c="1/4", x="1/1000")],
      note="(a(t), g(t)) comes as near to (w, 0) as one asks: q is the first t at which the square of the distance is at most x, or -1 if the orbit is back "
           "at its start before.")

claim("BLZ94-T5.9.3", "the minimum phase spectral factor", (c * w * recip(w) / (a * recip(a)) == HALF * b / a + HALF * recip(b) / recip(a)) & (c > 0),
      sizes=["n"],
      over={a: monic(n), b: monic(n), w: monic(n), c: scalar()}, where=[let(D, symmetric_part(a, b))],
      given=[standing("a is Schur", schur(a)), standing("D is positive", pos_on_circle(D)), standing("w is Schur", schur(w)),
          given("(5.4)", D == c * w * recip(w))],
      by=[steps("BLZ94-E5.4", prose="Divide (2.13) by a(z)a(1/z). D and w(z)w(1/z) are positive on the circle, so c is too."),
          instances(16, n=(1, 2), using={u: vector(n), v: vector(n), y: vector(n + 1)},
                    made_by={a: Z**n + sum_of(i, 1, n, u[i] / to_expr(4) ** i * Z ** (n - i)),
                        w: Z**n + sum_of(i, 1, n, v[i] / to_expr(4) ** i * Z ** (n - i)), y: _data(a, w), c: y[n + 1],
                             b: Z**n + sum_of(i, 1, n, y[i] * Z ** (n - i))}),
          example(n=1, a=["1/2", 1], b=["1/2", 1], w=["1/3", 1], c=1), example(n=0, a=[1], b=[-1], w=[1], c=-1)],
      note="The spectral factor is c^(1/2) w(z)/a(z); c is r_infinity, so its square root is real, and w and a have their zeros inside.")

# ---------------------------------------------------------------------- vertical vectors
claim("BLZ94-E5.24", "a and b for alpha = 0", (a == phi[n]) & (b == psi[n]), sizes=["n"], over={gamma: sequence(0, n - 1)},
      where=[function(alpha, [k], 0), *KIMURA],
      by=[generic_index(), identity(n=range(1, 7)), instances(n=(1, 2, 3))])


def _derivative(of, low):
    """Derivatives at gamma = 0 of n coefficients with respect to gamma_low, gamma_(low + 1), ... as columns."""
    return matrix_of(i, j, n, n, coeff(of(n + low + j, n, n - i + 1), 1))


_VERTICAL_AB = (*_AT_REST, let(VA, matrix_of(i, j, n, n, coeff(a(n + j, n - i + 1), 1))), let(VB, matrix_of(i, j, n, n, coeff(b(n + j, n - i + 1), 1))))
_SPAN = (rank(hstack(vstack(VA, VB), vstack(PA, PB))) == rank(vstack(PA, PB))) & (rank(vstack(VA, VB)) == rank(vstack(PA, PB))) & (PA == -PB)
claim("BLZ94-S36", "the vertical vectors become the derivatives of the Szego polynomials with respect to gamma_1, ..., gamma_n", _SPAN, **_EQUILIBRIUM,
      where=[*_VERTICAL_AB, let(PA, _derivative(phi_line, 1)), let(PB, _derivative(q, 1))], by=[example({alpha0: [0]}, n=1), instances(n=(1, 2))],
      note="V has the images of the n vertical unit vectors at (alpha, 0), P the derivatives of phi_n and psi_n at gamma = 0, which are to span the same "
           "space; gamma_n is no argument of phi_n, so its column is zero.",
      repair=repair("index", "The parameters are gamma_0, ..., gamma_{n-1}, so i runs from 0 to n - 1. And it is the spaces that are the same: the image of "
                             "the i-th unit vector itself also has the term "
                             "of Phi_n(gamma)alpha, which (5.24), at alpha = 0, does not show.",
                    _SPAN & (VA == PA + matrix_of(i, j, n, n,
                        sum_of(k, 1, n - 1, alpha0[k] * coeff(phi_line(n + j, n - k, n - k - i + 1), 1) * when(i <= n - k, 1, 0)))), **_EQUILIBRIUM,
                    where=[*_VERTICAL_AB, let(PA, _derivative(phi_line, 0)), let(PB, _derivative(q, 0))],
                    by=[instances(12, n=(2, 3))]))

claim("BLZ94-S37", "the vertical vectors are the pairs (p, -p)", (VA == -VB) & (det(VA) ** 2 == 1), **_EQUILIBRIUM, where=_VERTICAL_AB,
      by=[identity(n=range(1, 5)), instances(n=(1, 2, 3))],
      note="The columns of V are the images of the vertical unit vectors; they are of the form (p, -p), and the p are a basis.")

# ---------------------------------------------------------------------- Remark 5.10
not_checked("BLZ94-R5.10.1", "the invariants are complete",
            "a statement about all analytic functions, for which there is no formula here. Its exact part is that on the positive real region alpha_infinity, "
            "and with it every continuous "
            "invariant, is determined by the h_i (BLZ94-R5.10.2)")

_SAME = given("same h_i", coeff(v, 0) * u == coeff(u, 0) * v)
_TWO = {"sizes": ["n"], "over": {x: monic(n), y: monic(n)}, "where": [let(u, x * recip(x)), let(v, y * recip(y))]}
claim("BLZ94-R5.10.2", "the limit is a rational function of the invariants", x == y, **_TWO, given=[_SAME],
      by=[example(n=1, x=["1/2", 1], y=[2, 1]), instances(n=(0, 1), made_by={y: x})],
      note="A consequence: if alpha = F(h_1, ..., h_n) at the equilibria (alpha, 0) with alpha(z) Schur, and F is rational, this holds at all (alpha, 0), for "
           "both sides are rational in alpha and agree on an "
           "open set; then alpha is determined by the h_i. But z + 1/2 and z + 2 have the same h_1 = 4/5. For n = 1 the limit is (1 - (1 - h_1^2)^(1/2))/h_1.",
      repair=repair("other", "The limit is an algebraic and analytic function of the invariants, not a rational one: the Schur factor is one of several "
                             "solutions of algebraic equations with the same "
                             "h_i, and the equations can be solved locally as S(alpha) is nonsingular.",
                    (x == y) & invertible(operator(x, n + 1)), **_TWO, given=[_SAME, given("x is Schur", schur(x)), given("y is Schur", schur(y))],
                    by=[steps("BLZ94-X.20", facts=["a polynomial has one factorization into linear ones", "implicit function theorem"],
                              prose="The zeros of x(z)x(1/z) are those of x and their inverses, and those of x lie inside. The derivative of x(z)x(1/z) is "
                                    "S(x), which has no kernel."),
                        instances(16, n=(1, 2, 3), using={s: scalar(), w: monic(n)},
                            made_by={x: Z**n + sum_of(i, 1, n, coeff(w, n - i) / to_expr(4) ** i * Z ** (n - i)), y: x}),
                        example(n=1, x=["1/2", 1], y=[2, 1]), example(n=1, x=[2, 1], y=["1/2", 1]), example(n=1, x=["1/2", 1], y=["1/3", 1]),
                        example(n=1, x=[1, 1], y=[1, 1])]))

# ---------------------------------------------------------------------- singular points and limits
_COMMON = given("a common pair", shared(a, rev(a, n), b, rev(b, n)) > 0)
claim("BLZ94-S38", "the orbits of singular points converge", nonneg_on_circle(D) | nonneg_on_circle(-D), sizes=["n"], over={a: monic(n), b: monic(n)},
      where=[let(D, symmetric_part(a, b))],
      given=[_COMMON],
      by=[example(n=2, a=["-1/2", "-1/2", 1], b=["-3/2", "1/2", 1]), instances(8, n=(2,), using={s: nonzero()}, made_by={a: Z**2 + s * Z + 1, b: a})],
      note="A consequence, by Corollary 5.3. In the example a = (z - 1)(z + 1/2) and b = (z - 1)(z + 3/2) have the root 1 in common, so the point is "
           "singular, but D changes its sign on the circle. The first part of "
           "the sentence, that an orbit can converge to an equilibrium with a stable manifold of lower dimension, is true of that equilibrium itself.",
      repair=repair("missing hypothesis", "Singular points belong to systems that can be reduced, and if their orbits converge, which they need not, the "
                                          "limit has roots on or outside the circle.",
                    ~coprime(a, b) & ~schur(w), sizes=["n"], over={a: monic(n), b: monic(n), w: monic(n)},
                    given=[_COMMON, given("the limit has the common factor", shared(a, b, w) == shared(a, b))],
                    by=[steps("BLZ94-X.3", prose="A common factor stays in a_t and b_t and so belongs to the limit. Of s and 1/s one does not lie inside."),
                        instances(8, n=(2, 3), using={s: nonzero(), u: monic(n - 2), v: monic(n - 2), x: monic(n - 2)},
                                  made_by={a: (Z - s) * (Z - 1 / s) * u, b: (Z - s) * (Z - 1 / s) * v, w: (Z - s) * (Z - 1 / s) * x}),
                        instances(6, n=(1, 2), using={u: monic(n - 1), v: monic(n - 1), x: monic(n - 1)},
                            made_by={a: (Z - 1) * u, b: (Z - 1) * v, w: (Z - 1) * x}),
                        example(n=1, a=["1/2", 1], b=["1/2", 1], w=["1/2", 1]), example(n=1, a=[1, 1], b=[1, 1], w=["1/2", 1]),
                        example(n=1, a=["1/2", 1], b=["1/3", 1], w=["1/2", 1])]))
