# SPDX-License-Identifier: MIT
"""Section 8: remarks on order two, and on the shape of the positive real region.

If D vanishes at s = 1 or -1, then a(s)b(s) = 0. One of a and b, but in general not both, has the root s, and this stays so: the system is still of
order two. A common pair s, 1/s of a and b means for n = 2 that a = b = z^2 + alpha_1 z + 1, an equilibrium with alpha_1 = -(s + 1/s): |alpha_1| > 2
if s is real, but |alpha_1| < 2 if s lies on the circle.

For gamma = 0 the positive real region consists of the Schur polynomials. (z - r)^3 with r near to one is one of them, but on the segment to z^3 there
are others with roots outside: the roots of z^3 + s((z - 1)^3 - z^3) have the square modulus 1/(1 - c + c^2), where c^3 = (1 - s)/s.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import evaluation, example, instances, steps
from exactkf.language import (
    Z,
    always,
    circle_roots,
    column,
    function,
    given,
    inside_roots,
    let,
    monic,
    nonzero,
    outside_roots,
    pos_on_circle,
    rational,
    recip,
    rev,
    scalar,
    schur,
    sequence,
    standing,
    substitute,
    symbols,
    vector,
    when,
)
from proofs.blz94.lemmas_tangent import shared
from proofs.blz94.notation import FAST, D, a0, g, g0, gamma, i, k, monic_of, n, symmetric_part, t

c, p, q, s, u, v, w, x, y = symbols("c p q s u v w x y")

# ---------------------------------------------------------------------- order two
_TWO = {"over": {a0: vector(n), g0: vector(n), s: scalar()},
    "where": [let(n, 2), *FAST, function(c, [t], g[t][1]), let(u, monic_of(a0)), let(v, monic_of(a0 + 2 * g0)), let(D, symmetric_part(u, v))]}
_ON_CIRCLE = standing("all eigenvalues on the circle", circle_roots(Z**2 * D) == 4)
_REAL = standing("s is one of them, 1 or -1", (s**2 == 1) & (substitute(D, s) == 0))
_FIRST_ORDER = always(t, c(t) * c(t + 2) * (1 - c(t + 1) ** 2) == c(t + 1) ** 2)
_ROOTS = {"using": {p: scalar(), x: scalar()}, "made_by": {s: when(x > 0, 1, -1), a0: column(i, 2, when(i == 1, -s - p, s * p)),
        g0: column(i, 2, when(i == 1, -x, s * x))}}
claim("BLZ94-S72", "n = 2: if all eigenvalues of S lie on the circle and two are real, the dynamics are those of order one", _FIRST_ORDER, **_TWO,
      given=[_ON_CIRCLE, _REAL],
      by=[example({a0: ["-3/2", "1/2"], g0: ["3/4", 0], s: 1}),
          instances(8, using={x: scalar()}, made_by={s: 1, a0: column(i, 2, when(i == 1, -2, 1)), g0: 0 * a0})],
      note="The eigenvalues of S are the zeros of D, and c(t) = gamma_t is the first entry of g(t). The Schur parameters of an orbit of order one satisfy "
           "gamma_{t-1} gamma_{t+1} (1 - gamma_t^2) = gamma_t^2. In the example a = (z - 1)(z - 1/2) and "
           "b = z^2 + 1/2: the zeros of D are 1, 1 and those of z^2 - z/4 + 1, but a and b are coprime.",
      repair=repair("missing hypothesis", "It is the common root of a and b that reduces the order; a real zero of D on the circle is a root of one of them, "
                                          "in general not of both.",
                    _FIRST_ORDER, **_TWO, given=[given("a and b have a common root", (substitute(u, s) == 0) & (substitute(v, s) == 0))],
                    by=[steps("BLZ94-X.3", prose="A common factor stays, and the orbit is that of the pair without it, of order one."),
                        instances(16, horizon=3, **_ROOTS)]))

_PAIR = {"over": {u: monic(2), v: monic(2)}, "where": [let(n, 2), let(x, substitute(u, 0)), let(y, (substitute(u, 1) - substitute(u, -1)) / 2)]}
_COMMON = given("a common pair", shared(u, rev(u, 2), v, rev(v, 2), size=2) == 2)
_SADDLE = (u == v) & (x == 1) & (abs(y) > 2) & (inside_roots(u) == 1) & (outside_roots(u) == 1)
claim("BLZ94-S73", "n = 2: a common pair of reciprocal roots other than 1 is a saddle point with |alpha_1| > 2", _SADDLE, **_PAIR,
      given=[_COMMON, given("not 1", substitute(u, 1) != 0)],
      by=[example({u: [1, 0, 1], v: [1, 0, 1]}), instances(8, using={s: scalar()}, made_by={u: Z**2 + (3 + s**2) * Z + 1, v: u})],
      note="u and v are a and b; y is alpha_1 = a_1 and x is alpha_2 = a_2 if they are equal, that is if gamma = 0. In the example a = b = z^2 + 1, with the "
           "pair i, 1/i = -i and alpha_1 = 0.",
      repair=repair("missing hypothesis", "The roots must not lie on the circle; a pair on the circle gives the equilibria with |alpha_1| < 2.", _SADDLE,
          **_PAIR,
                    given=[_COMMON, given("not of modulus one", circle_roots(u) == 0)],
                    by=[instances(16, using={s: nonzero()}, made_by={u: (Z - s) * (Z - 1 / s), v: u}), example({u: [1, 0, 1], v: [1, 0, 1]}),
                        example({u: [1, 2, 1], v: [1, 2, 1]}),
                        example({u: ["1/4", 1, 1], v: ["1/4", 1, 1]}), example({u: [2, 3, 1], v: [3, 4, 1]}), example({u: [6, 5, 1], v: [6, 5, 1]}),
                        example({u: [1, "5/2", 1], v: [0, 0, 1]})]))

# ---------------------------------------------------------------------- the positive real region
A1, B1, A2, B2, A3, B3 = symbols("a_x b_x a_y b_y a_s b_s")


def _polynomials(point):
    """a and b of order two for these alphas."""
    return tuple(Z**2 + (gamma[0] * gamma[1] - l * gamma[0] + point[1]) * Z - l * (gamma[1] + gamma[0] * point[1]) + point[2] for l in (1, -1))


_POINTS = tuple(let(name, f) for names, point in (((A1, B1), x), ((A2, B2), y), ((A3, B3), s * x + (1 - s) * y)) for name,
    f in zip(names, _polynomials(point), strict=True))
_SMALL = {"using": {u: scalar(), v: scalar(), p: scalar(), q: scalar(), w: vector(2)},
          "made_by": {gamma: (k, when(k == 0, u / (1 + u**2), v / (1 + v**2))), x: column(i, 2, w[i] / (2 + w[i] ** 2) / 4),
              y: column(i, 2, when(i == 1, p, q) / (2 + p**2 + q**2) / 4),
                      s: u**2 / (1 + u**2)}}
claim("BLZ94-Q1", "n = 2: the positive real region for fixed gamma is convex", schur(A3) & pos_on_circle(symmetric_part(A3, B3)),
      over={gamma: sequence(0, 1), x: vector(2), y: vector(2), s: scalar()}, where=_POINTS,
      given=[standing("|gamma_k| < 1", (gamma[0] ** 2 < 1) & (gamma[1] ** 2 < 1)), given("x lies in it", schur(A1) & pos_on_circle(symmetric_part(A1, B1))),
             given("y lies in it", schur(A2) & pos_on_circle(symmetric_part(A2, B2))), given("between", (s >= 0) & (s <= 1))],
      by=[instances(20, **_SMALL), example({gamma: [0, 0], x: ["19/10", "19/20"], y: ["-19/10", "19/20"], s: "1/2"}),
          example({gamma: [0, 0], x: ["19/10", "19/20"], y: [0, "-9/10"], s: "1/3"}),
          example({gamma: [0, 0], x: [3, 0], y: [0, 0], s: 1}), example({gamma: [0, 0], x: [0, 0], y: [3, 0], s: 0}),
          example({gamma: [0, 0], x: [1, "1/2"], y: [0, 0], s: 3}),
          example({gamma: ["1/2", "1/3"], x: ["1/4", "1/4"], y: ["-1/3", "1/4"], s: "2/3"})],
      note="The text says that it seems to be so. A point of the segment between x and y; a_s and b_s belong to it. Nothing is proved here beyond the "
           "instances.")

claim("BLZ94-Q2", "from order three on the positive real region need not be star-shaped about zero",
      schur(x) & pos_on_circle(x * recip(x)) & (outside_roots(y) == 2), sizes=["n"],
      where=[let(s, rational("8/9")), let(x, Z ** (n - 3) * (Z - rational("9/10")) ** 3), let(y, s * x + (1 - s) * Z**n)], given=[standing("n >= 3", n >= 3)],
      by=[evaluation(n=range(3, 11)), instances(n=(3, 4, 5))],
      note="gamma = 0, where a = b = alpha(z) and D = alpha(z)alpha(1/z): x is the alpha(z) of a point of the region, y that of 8/9 of it. A convex set that "
           "contains zero is star-shaped about it, so the region is not "
           "convex from n = 3 on. For n = 1 it is the interval |alpha| < 1 - |gamma| (BLZ94-F8.1a).")
