# SPDX-License-Identifier: MIT
"""Section 8: order one.

For n = 1 the constant of the motion is 1 + alpha^2 - gamma^2 = (2/kappa) alpha, so that alpha moves by
the fractional linear map alpha -> kappa/(2 - kappa alpha). If lambda + 1/lambda = 2/kappa with |lambda| < 1, the cross ratio
(alpha - lambda)/(alpha - 1/lambda) is multiplied by lambda^2 in each step. With a = alpha - gamma and b = alpha + gamma the curve is
1 + ab = (a + b)/kappa; if 1/kappa = -cos(2 pi q/p) every orbit returns after p steps.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import (
    angles,
    arithmetic,
    by_cases,
    cleared,
    example,
    existing,
    identity,
    induction,
    instances,
    multiplied,
    part,
    restated,
    steps,
    unfolded,
    valued,
)
from exactkf.language import (
    Z,
    always,
    charpoly,
    circle_roots,
    coeff,
    column,
    coprime,
    cospi,
    defined,
    det,
    exists,
    forall,
    function,
    given,
    iff,
    inside_roots,
    integer,
    laurent,
    let,
    nonneg_on_circle,
    nonzero,
    outside_roots,
    pos_on_circle,
    rational,
    rec,
    recip,
    rows,
    scalar,
    schur,
    standing,
    substitute,
    sum_of,
    symbols,
    vector,
    when,
)
from proofs.blm91.consequences_angles import COPRIME
from proofs.blm91.lemmas_turns import LOWEST_PQ, OF_ENDLESS, OF_KAPPA, OF_POINTS
from proofs.blm91.notation import ORBIT as FROM_START
from proofs.blm91.notation import al0, ga0
from proofs.blz94.notation import (
    HALF,
    ORBIT,
    VECTORS,
    D,
    a,
    a_of,
    alpha,
    alpha0,
    b,
    b_of,
    gamma,
    gamma0,
    i,
    j,
    k,
    m,
    monic_of,
    n,
    symmetric_part,
    t,
    u,
)

p, q, v, w, x, y, z, kappa, lam, c, d, e, f, S, X = symbols("p q v w x y z kappa lambda c d e f S X")
k1, k2, al, ga = symbols("kappa1 kappa2 alpha_bar gamma_bar")
s, goal, near = symbols("s goal near")

#: (8.1) from (al, ga)
ONE = (rec(alpha, t, al, alpha[t] / (1 - gamma[t] ** 2)), rec(gamma, t, ga, -gamma[t] * alpha[t] / (1 - gamma[t] ** 2)))
POINT = {al: scalar(), ga: scalar()}
#: D of order one
D_ONE = (let(a, Z + al - ga), let(b, Z + al + ga), let(D, symmetric_part(a, b)))
DEFINITE = nonneg_on_circle(D) | nonneg_on_circle(-D)
#: alpha + gamma of the point of the curve with 1/kappa = e, by x = alpha - gamma
CURVE_B = (e * x - 1) / (x - e)

# ---------------------------------------------------------------------- order one
claim("BLZ94-E8.1", "(8.1)-(8.3) are (4.4) and (3.12) for n = 1",
      (alpha[1][1] == alpha0[1] / (1 - gamma0[1] ** 2)) & (gamma[1][1] == -gamma0[1] * alpha0[1] / (1 - gamma0[1] ** 2))
      & (monic_of(a_of[0]) == Z + alpha0[1] - gamma0[1]) & (monic_of(b_of[0]) == Z + alpha0[1] + gamma0[1]), over={alpha0: vector(1), gamma0: vector(1)},
      where=[let(n, 1), *ORBIT, *VECTORS], by=[identity(), instances()], note="One step of (4.4) from any point, and a(z), b(z) there.")

claim("BLZ94-F8.1a", "the open diamond is the positive real region", iff(abs(al) + abs(ga) < 1, schur(a) & pos_on_circle(D)),
      over=POINT, where=D_ONE,
      by=[arithmetic(by_cases(abs(al) < 1), by_cases(abs(al - ga) < 1)),
          instances(40), instances(20, using={x: scalar()}, made_by={al: x / 4, ga: (1 - x / 4) * HALF}),
          example({al: "1/2", ga: "1/2"}), example({al: 3, ga: 1})])

claim("BLZ94-F8.1b", "D is sign definite exactly in the shaded regions; v(1/z) there",
      iff(DEFINITE, (abs(ga) <= abs(1 - abs(al))) | (abs(ga) >= 1 + abs(al)))
      & iff(abs(ga) < abs(al) - 1, pos_on_circle(D) & (inside_roots(f) == 1))
      & iff(abs(ga) > 1 + abs(al), pos_on_circle(-D)) & (pos_on_circle(-D) >> (inside_roots(f) == 1)), over=POINT,
      where=[*D_ONE, let(f, 1 + (al - ga) * Z)],
      by=[*(arithmetic(member=k_) for k_ in range(3)), arithmetic(by_cases(abs(ga) > 1 + abs(al)), by_cases(abs(al - ga) > 1), member=3),
          instances(40), example({al: 3, ga: 2}), example({al: 3, ga: 1}), example({al: -3, ga: 1}), example({al: 1, ga: 2}), example({al: 1, ga: 3}),
          example({al: -1, ga: -3}), example({al: "1/2", ga: "1/2"}), example({al: 2, ga: 2}), example({al: -2, ga: 2}), example({al: 0, ga: 2}),
          example({al: "5/2", ga: 1})],
      note="Regions with their boundary for definiteness, open ones for positive and negative realness. v(1/z) is positive (negative) real if D > 0 "
           "(D < 0) and its pole lies inside the circle.")

claim("BLZ94-F8.1c", "escape in one step happens on gamma = 1 and gamma = -1", iff(defined(alpha[1]), (ga != 1) & (ga != -1)), over=POINT,
      where=ONE, by=[arithmetic(existing(alpha, 1), existing(alpha, 0), existing(gamma, 0), unfolded(gamma, 0)), example({al: "3/2", ga: "1/2"}), example({al: 2, ga: 1}), example({al: 2, ga: -1}), example({al: 0, ga: 1}), example({al: 2, ga: 2}), example({al: 1, ga: "1/2"}), instances(20)])

#: the orbit of (0, ga)
_AXIS = (rec(v, t, 0, v[t] / (1 - w[t] ** 2)), rec(w, t, ga, -w[t] * v[t] / (1 - w[t] ** 2)))
claim("BLZ94-E8.4", "the invariant curve of order one; the axis alpha = 0",
      always(t, (al * (1 + alpha[t] ** 2 - gamma[t] ** 2) == (1 + al**2 - ga**2) * alpha[t]) & (v[t] == 0) & (w[t + 1] == 0)
             & (coeff(D, 0) == 1 + al**2 - ga**2) & (coeff(D, 1) == al)), over=POINT, where=[*ONE, *_AXIS, *D_ONE],
      by=[induction(cofactors=[[(1 / (1 - gamma[t] ** 2), 0, 1)], [(1 / (1 - w[t] ** 2), 1, 1)], [(-v[t + 1] / (1 - w[t + 1] ** 2), 2, 1)],
                               [(1, 3, 1)], [(1, 4, 1)]]),
          instances(20)],
      note="The level set is d_0 = (2/kappa) d_1. The quotient of 1 + alpha^2 - gamma^2 and alpha stays, which covers kappa infinite "
           "too. (v, w) is the orbit from (0, gamma), at the origin after one step.")

claim("BLZ94-F8.2a", "the curves with kappa^2 < 1 and kappa^2 = 1",
      ((kappa**2 < 1) >> DEFINITE) & ((kappa == 1) >> ((al - 1) ** 2 == ga**2)) & ((kappa == -1) >> ((al + 1) ** 2 == ga**2))
      & (((kappa == 1) | (kappa == -1)) >> (DEFINITE & ~(pos_on_circle(D) | pos_on_circle(-D)))),
      over={**POINT, kappa: nonzero()}, where=D_ONE, given=[given("(8.4)", 1 + al**2 - ga**2 == 2 / kappa * al)],
      by=[*(arithmetic(valued(), valued("(8.4)"), cleared(), by_cases(al > 0), by_cases(abs(kappa) < 1), by_cases(kappa == 1), member=k_) for k_ in range(4)),
          instances(30, using={x: scalar()}, made_by={al: HALF * (x + (x / kappa - 1) / (x - 1 / kappa)), ga: HALF * ((x / kappa - 1) / (x - 1 / kappa) - x)}),
          example({al: 3, ga: 2, kappa: 1}), example({al: 3, ga: 4, kappa: -1}), example({al: 3, ga: -4, kappa: -1}), example({al: 3, ga: -2, kappa: 1}),
          example({al: 1, ga: 1, kappa: 2}), example({al: 1, ga: 2, kappa: 1}), example({al: 1, ga: 3, kappa: -1}), example({al: 0, ga: 1, kappa: -1}),
          example({al: 2, ga: 2, kappa: "1/2"}), example({al: 4, ga: 1, kappa: "1/2"}), example({al: -4, ga: 1, kappa: "-1/2"})],
      note="On the boundary of the region D is definite, and not strictly so.")

_RHO = 1 - gamma[t] ** 2
claim("BLZ94-F8.2b", "every point of the shaded regions converges to the point of its curve with |alpha| <= 1",
      abs(al) <= 1, over=POINT, where=[*D_ONE, *ONE],
      given=[given("D is sign definite", DEFINITE), given("the orbit stays where it is", (alpha[1] == al) & (gamma[1] == ga))],
      by=[example({al: 2, ga: 0}), instances(made_by={ga: 0 * al})],
      note="A consequence for equilibria, whose limit is the point itself: (2, 0) lies in the shaded region and stays there.",
      repair=repair("missing hypothesis", "The equilibria with |alpha| > 1 and the points that escape have to be excepted; otherwise the cross ratio with "
                                          "the two equilibria of the curve is multiplied by lambda^2 in each step, lambda the one inside.",
                    always(t, (alpha[t] - lam) * (al - 1 / lam) == p[t] * (al - lam) * (alpha[t] - 1 / lam)), over={lam: nonzero(), x: scalar()},
                    where=[let(al, HALF * (x + CURVE_B)), let(ga, HALF * (CURVE_B - x)), *ONE, let(e, HALF * (lam + 1 / lam)), rec(p, t, 1, lam**2 * p[t])],
                    by=[induction(also=[1 + alpha[t] ** 2 - gamma[t] ** 2 == 2 * e * alpha[t]],
                                  cofactors=[[(alpha[t] * lam / _RHO, 0, 1), ((p[t] * lam * (al - lam) - lam * al + 1) / _RHO, 1, 1)], [(1 / _RHO, 1, 1)]]),
                        instances(20, horizon=3),
                        restated("a sequence tends to lambda if its cross ratio with lambda and 1/lambda is multiplied by lambda^2 < 1 in each step")]))

_ROWS = [[coeff(x_, i_) for i_ in (0, 1)] for x_ in (D, symmetric_part(1, b), symmetric_part(a, 1))]
claim("BLZ94-X.11", "n = 1: the minors that vanish where the invariant curve is singular",
      (det(rows(_ROWS[1:])) == ga) & (2 * det(rows(_ROWS[:2])) == 1 - (al + ga) ** 2) & (2 * det(rows(_ROWS[::2])) == 1 - (al - ga) ** 2), over=POINT, where=D_ONE,
      by=[identity(), instances()],
      note="Not printed. The curve, the level set of D up to a factor, is smooth where D and its derivatives with respect to the coefficients of a and b, one a row, span the plane of "
           "all D. The minors vanish together exactly for gamma = 0, alpha = 1 or -1.")

#: D and its derivatives with respect to the coefficients of a and b, by their coefficients at 1 and at z + 1/z; they do not span the plane
_SPANNED = [(1 + al**2 - ga**2, al), (al + ga, HALF), (al - ga, HALF)]
_SINGULAR = let(c, (ga == 0) & (_SPANNED[0][0] * HALF == al * (al + ga)) & (_SPANNED[0][0] * HALF == al * (al - ga)))
_AT_ONE = (ga == 0) & ((al == 1) | (al == -1))
claim("BLZ94-S59", "n = 1: a common pair of reciprocal roots, and a singular point, only at (1, 0) and (-1, 0)",
      iff((f(x) == 0) & (e(x) == 0) & (f(w) == 0) & (e(w) == 0), (ga == 0) & (al == -x) & ((x == 1) | (x == -1))) & iff(c, _AT_ONE)
      & (D == _SPANNED[0][0] + _SPANNED[0][1] * (Z + recip(Z))) & (HALF * (b + recip(b)) == _SPANNED[1][0] + HALF * (Z + recip(Z)))
      & (HALF * (a + recip(a)) == _SPANNED[2][0] + HALF * (Z + recip(Z))),
      over={**POINT, x: nonzero()}, where=[*D_ONE, function(f, [z], z + al - ga), function(e, [z], z + al + ga), let(w, 1 / x), _SINGULAR],
      by=[arithmetic(angles("quotient", 1, x), multiplied(x), by_cases(x > 1), by_cases(x < -1), member=0),
          arithmetic(by_cases(ga == 0), by_cases(al > 1), by_cases(al < -1), member=1), *(arithmetic(member=k_) for k_ in (2, 3, 4)),
          example({al: 1, ga: 0, x: -1}), example({al: -1, ga: 0, x: 1}), example({al: 1, ga: 1, x: 1}), example({al: 0, ga: 1, x: 1}),
          example({al: 0, ga: 1, x: -1}), example({al: -2, ga: 0, x: 2}), example({al: -2, ga: 0, x: "1/2"}), example({al: 2, ga: 0, x: 1}),
          example({al: 1, ga: 0, x: 1}), example({al: 1, ga: 2, x: 1}), example({al: 1, ga: -2, x: 1}), example({al: 2, ga: 0, x: 2}), instances(20)],
      note="f and e are a(z) and b(z). Singular (c): D and its derivatives, as vectors with two entries each, have all minors zero (BLZ94-X.11). "
           "The text refers to a Theorem 5.27; there is none, Theorem 5.11 with (5.27) is meant.")

#: S of order one, (6.14)
_S_ONE = (let(c, -al), let(S, rows([[1 / c, -1 / c], [ga**2 / c, c - ga**2 / c]])))
claim("BLZ94-S60", "n = 1: the eigenvalues of S for each kappa",
      (charpoly(S) == Z**2 + 2 / kappa * Z + 1)
      & ((kappa**2 < 1) >> ((inside_roots(charpoly(S)) == 1) & (outside_roots(charpoly(S)) == 1)))
      & ((kappa == 1) >> (charpoly(S) == (Z + 1) ** 2)) & ((kappa == -1) >> (charpoly(S) == (Z - 1) ** 2))
      & ((kappa**2 > 1) >> ((circle_roots(charpoly(S)) == 2) & (substitute(D, 1) * substitute(D, -1) < 0))),
      over={al: nonzero(), ga: scalar(), kappa: nonzero()}, where=[*_S_ONE, *D_ONE], given=[given("(8.4)", 1 + al**2 - ga**2 == 2 / kappa * al)],
      by=[steps("BLZ94-C6.5", prose="A = F - gh' = -alpha. The trace of S is -(1 + alpha^2 - gamma^2)/alpha, its determinant is one; a root is "
                                    "-1/kappa plus or minus the root of 1/kappa^2 - 1."),
          instances(30, using={x: scalar()}, made_by={al: HALF * (x + (x / kappa - 1) / (x - 1 / kappa)), ga: HALF * ((x / kappa - 1) / (x - 1 / kappa) - x)}),
          example({al: 3, ga: 2, kappa: 1}), example({al: 3, ga: 4, kappa: -1}), example({al: 1, ga: 1, kappa: 2}), example({al: 2, ga: 0, kappa: "4/5"}),
          example({al: -1, ga: 1, kappa: -2})],
      note="D is sign indefinite: D(1) and D(-1), its extreme values on the circle, have opposite signs. Nonconvergence is Corollary 5.3; there is no Theorem 5.34. kappa infinite means trace zero, eigenvalues i and -i.")

#: the orbit beside the equilibrium with |alpha| > 1, to first order in 1/z
_BESIDE_IT = (rec(c, t, 1 / lam + u / Z, c[t] / (1 - d[t] ** 2)), rec(d, t, v / Z, -d[t] * c[t] / (1 - d[t] ** 2)))
claim("BLZ94-S61", "0 < kappa^2 < 1: the equilibria on the curve, and how they attract",
      always(t, (alpha[t] - lam) * (al - 1 / lam) == p[t] * (al - lam) * (alpha[t] - 1 / lam))
      & (inside_roots(f) == 1) & (outside_roots(f) == 1) & (substitute(f, lam) == 0) & (substitute(f, 1 / lam) == 0)
      & (laurent(c[1], 1) == u) & (laurent(d[1], 1) == -v / lam) & (laurent(c[1], 0) == 1 / lam),
      over={lam: nonzero(), x: scalar(), u: scalar(), v: scalar()},
      where=[let(al, HALF * (x + CURVE_B)), let(ga, HALF * (CURVE_B - x)), *ONE, let(e, HALF * (lam + 1 / lam)), let(f, Z**2 - 2 * e * Z + 1), rec(p, t, 1, lam**2 * p[t]), *_BESIDE_IT],
      given=[given("lambda is the root inside", abs(lam) < 1)],
      by=[steps("BLZ94-E8.4", facts=["center manifold theorem: an invariant manifold that is tangent to the center space is a center manifold"],
                prose="With gamma = 0, (8.4) is alpha^2 - (2/kappa) alpha + 1 = 0; the product of the roots is one, they are real and differ. alpha moves by 1/(2e - alpha), so that the cross ratio has the factor lambda^2; "
                      "every orbit but that of 1/lambda tends to lambda unless it ends. At (1/lambda, 0) the derivative has the eigenvalues 1 and -1/lambda, the second outside the circle: "
                      "the center manifold has dimension one."),
          instances(20, horizon=3, using={w: nonzero()}, made_by={lam: w / (1 + abs(w))}), example({lam: 2, x: 3, u: 1, v: 1}), example({lam: "1/2", x: 3, u: 1, v: 1})],
      note="1/kappa = e = (lambda + 1/lambda)/2, which for 0 < |lambda| < 1 is every kappa with 0 < kappa^2 < 1; p is lambda^(2t). alpha - gamma = x names the point of the curve. "
           "(c, d) is the orbit from (1/lambda + u/z, v/z).")

_NUM = x**2 - 2 * e * x + 1
_MOBIUS = (rec(d, t, x, d[t] - c[t]), rec(c, t, 1, d[t] + (1 - 2 * e) * c[t]), rec(v, t, 0, (2 - 2 * e) * v[t] - w[t]), rec(w, t, -1, (2 - 2 * e) * v[t]))
claim("BLZ94-X.9", "alpha - gamma moves by a fractional linear map, whose powers are known",
      always(t, ((alpha[t] - gamma[t]) * c[t] == d[t]) & (d[t] - x * c[t] == -v[t] * _NUM)), over={e: scalar(), x: scalar()},
      where=[let(al, HALF * (x + CURVE_B)), let(ga, HALF * (CURVE_B - x)), *ONE, *_MOBIUS],
      by=[induction(also=[1 + alpha[t] ** 2 - gamma[t] ** 2 == 2 * e * alpha[t], c[t] == v[t] * (x + 1 - 2 * e) - w[t],
                          d[t] == (v[t] - w[t]) * x - v[t]],
                    cofactors=[[(1 - alpha[t] * (1 + gamma[t]) / _RHO, 0, 1), (c[t] * (1 + gamma[t]) / _RHO, 2, 1)], [(1, 4, 1), (-1, 3, 1), (-x, 4, 1), (-x * (1 - 2 * e), 3, 1)],
                               [(1 / _RHO, 2, 1)], [(1, 4, 1), (1 - 2 * e, 3, 1)], [(1, 4, 1), (-1, 3, 1)]]),
          instances(20, horizon=3)],
      note="Not printed. (d_t, c_t) is (x, 1) times the t-th power of ((1, -1), (1, 1 - 2e)), and v_t is the entry 2, 1 of it. With e = -cos(2 phi) the rotation is by "
           "phi and v_t a multiple of sin(t phi); for |e| < 1 the factor x^2 - 2ex + 1 is not zero, so that alpha - gamma is back at x exactly if sin(t phi) = 0.")

#: 1/kappa = -cos(2 pi q/p), q and p coprime: then the z^k - 1 have only z - 1 in common
_COS = -cospi(2 * q, p)
_PRIME = standing("q and p coprime, q < p/2", coprime(sum_of(k, 0, p - 1, Z**k), sum_of(k, 0, q - 1, Z**k)) & (2 * q < p))
_RETURNS = forall(t, 1, p, iff((alpha[t] == al0) & (gamma[t] == ga0), t == p))
_ON = given("(8.4)", 1 + al0**2 - ga0**2 == 2 * lam * al0)
_LINES = dict(using={x: scalar()}, made_by={al0: 2 * (lam + x) / (1 - x**2), ga0: 1 + x * 2 * (lam + x) / (1 - x**2)})
claim("BLZ94-X8.A1", "on the curves with angle q pi/p all orbits that do not escape have period p", _RETURNS & (lam**2 < 1), sizes=["q", "p"],
      over={al0: nonzero(), ga0: scalar(), lam: scalar()}, where=[*COPRIME, *FROM_START],
      given=[*LOWEST_PQ, _ON, standing("the orbit exists", defined(alpha[p]) & defined(gamma[p])),
             given("the angle", ((lam < 0) >> (cospi(2 * q, p) == -lam)) & ((lam >= 0) >> (cospi(p - 2 * q, p) == lam)))],
      by=[arithmetic(*OF_KAPPA, valued(), *OF_POINTS), instances(12, q=1, p=(3, 4, 6), using=_LINES["using"], made_by={lam: _COS, **_LINES["made_by"]}),
          *(example(dict(zip((q, p, al0, ga0, lam), one, strict=True))) for one in (
              (1, 3, "-5/3", "-7/3", "1/2"), (1, 4, "-4/3", "-5/3", 0), (1, 6, -1, -1, "-1/2"), (1, 6, "-5/3", "-7/3", "1/2"), (2, 6, "-5/3", "-7/3", "1/2")))],
      note="For every q and p and every point of the curve; lambda = 1/kappa. arctan sqrt(kappa^2 - 1) has the cosine 1/|kappa|, and is 2 pi q/p for kappa < -1, pi - 2 pi q/p for kappa > 1.")

claim("BLZ94-X8.A3", "every period from three on occurs", d & _RETURNS, sizes=["p"], over={al0: scalar(), ga0: scalar()},
      where=[let(q, 1), let(lam, _COS), *FROM_START, let(d, defined(alpha[p]) & defined(gamma[p]))], given=[standing("p > 2", p > 2), given("which points", al0 > 1), _ON],
      by=[arithmetic(*OF_ENDLESS), instances(12, p=(3, 4, 6), **_LINES), example(p=3, alpha0="15/8", gamma0="13/8"), example(p=4, alpha0="4/3", gamma0="5/3"),
          example(p=6, alpha0="8/7", gamma0="13/7"), example(p=3, alpha0=1, gamma0=1)],
      note="q = 1, for any p from three on: the points with alpha_0 > 1 have orbits that exist (d), of period p. Period four needs 1/kappa = 0, the curve d_0 = 0 that (8.4) includes as kappa infinite; no finite kappa has it.")

claim("BLZ94-X8.A2", "the number of points that escape", 2 * f(1) == when(rational(-1) ** p == -1, 2 * (p - 1), p - 2), sizes=["p", "q"],
      where=[let(e, _COS), function(y, [k], when(k == 1, 2 * e, when(y(k - 1) == 0, 0, 2 * e - 1 / y(k - 1)))),
             function(f, [k], when(y(k) == 0, k, f(k + 1)))], given=[_PRIME],
      by=[steps("BLZ94-X.9", facts=["sin(t pi q/p) = 0 for coprime q, p if and only if p divides t"],
                prose="The points that escape are those that go to one of the two points at infinity of the curve, a = infinity and a = e, under a rotation of order p. For odd p the two "
                      "have different orbits of p points each, for even p the same; the points at infinity are not counted."),
          instances(24, p=(3, 4, 5, 6, 7, 8, 9, 10, 11), q=(1, 2, 3, 4, 5))],
      note="alpha = y(k) moves to infinity in k steps; each such alpha belongs to two points, gamma and -gamma. Going back from infinity one comes "
           "to alpha = 0, which nothing moves to, and there the list ends.")

claim("BLZ94-X8.B", "other angles: no orbit returns, and infinitely many points escape",
      (d == 1) & (c == m) & near, sizes=["m"], over={x: scalar(), e: scalar(), s: integer(1, 3)},
      where=[let(al, HALF * (x + CURVE_B)), let(ga, HALF * (CURVE_B - x)), *ONE, rec(v, t, 0, (2 - 2 * e) * v[t] - w[t]), rec(w, t, -1, (2 - 2 * e) * v[t]),
             function(y, [k], when(k == 1, 2 * e, 2 * e - 1 / y(k - 1))),
             let(d, sum_of(k, 0, m, when(alpha[k] - gamma[k] == x, 1, 0))),
             let(c, sum_of(k, 1, m, when((y(k) == 0) | exists(j, 1, k - 1, y(j) == y(k)), 0, 1))), let(goal, HALF * (s + (e * s - 1) / (s - e))),
             let(near, exists(k, 1, 700, (abs(alpha[k] - goal) <= 1) & (abs(gamma[k] - goal + s) <= 1)))],
      given=[standing("indefinite", abs(e) < 1), given("the angle is not k pi/j for j <= 2m + 2", forall(k, 1, 2 * m + 2, v[k] != 0))],
      by=[steps("BLZ94-X.9", facts=["Kronecker: the multiples of an irrational angle are dense in the circle"],
                prose="The curve is a circle on which each step is a rotation by one angle, by X.9; v_k is a multiple of sin(k phi), which never vanishes for an irrational angle. So no orbit "
                      "returns, each is dense, and going back from infinity never ends."),
          example({"m": 3, x: "1/3", e: "1/2", s: 2}), example({"m": 4, x: "1/3", e: 0, s: 2}), example({"m": 6, x: "1/3", e: "-1/2", s: 2}),
          instances(30, m=(3, 5), using={u: scalar()}, made_by={e: u / (1 + u**2)})],
      note="1/kappa = e. d counts the visits at the start within m steps, c the different ones among the alpha y(1), ..., y(m), which escape after as many steps. near: the orbit "
           "comes within 1 of another point of the curve, that with alpha - gamma = s, tried for 700 steps.")

claim("BLZ94-S62", "the degenerate curves kappa = 1, -1",
      always(t, (alpha[t] - c) * w[t] == x - c), sizes=["p"], over={x: scalar()},
      where=[let(c, when(p == 1, 1, -1)), let(al, x), let(ga, x - c), *ONE, rec(w, t, 1, w[t] - c * (x - c))],
      by=[induction(p=(1, 2), also=[gamma[t] ** 2 == (alpha[t] - c) ** 2],
                    cofactors=[[((1 + c * (alpha[t] - c)) / _RHO, 0, 1), ((c * w[t + 1] + x - c) / _RHO, 1, 1)], [(1 / _RHO, 1, 1)]]), instances(p=(1, 2)),
          part("the orbits on the two curves")],
      note="c = kappa, and w_t = 1 - ct(x - c). Hence alpha tends to c; gamma is alpha - c or c - alpha. Escape is w_t = 0 for some t, or x = 0: a countable set. At (c, 0) the "
           "Jacobian is diag(1, -c): both eigenvalues have modulus one. Near (c, 0), (alpha - c)^2 - gamma^2 takes both signs, so curves of all "
           "types come near.")

claim("BLZ94-S63", "kappa_2 = ... = kappa_n = 0 restricts the algorithm to order one",
      (alpha[1] == column(i, n, when(i == 1, x / (1 - gamma0[n] ** 2), 0))) & (gamma[1][n] == -x * gamma0[n] / (1 - gamma0[n] ** 2))
      & (coeff(D, 1) * (1 + x**2 - gamma0[n] ** 2) == coeff(D, 0) * x) & forall(i, 2, n, coeff(D, i) == 0),
      sizes=["n"], over={x: scalar(), gamma0: vector(n)},
      where=[let(alpha0, column(i, n, when(i == 1, x, 0))), *ORBIT, *VECTORS, let(D, symmetric_part(monic_of(a_of[0]), monic_of(b_of[0])))],
      by=[identity(n=range(1, 6)), instances(n=(1, 2, 3)),
          restated("Lemma 4.4: alpha_2 = ... = alpha_n = 0 where d_2 = ... = d_n = 0")],
      note="By Lemma 4.4 d_2 = ... = d_n = 0 means alpha_2 = ... = alpha_n = 0. Then (alpha_1, gamma_{n-1}) moves by (8.1), on the curve with kappa = 2 d_1/d_0 = kappa_1; the other entries of gamma "
           "are earlier values of gamma_{n-1} after n - 1 steps.")

#: a rational s with irrational angle beside e; the orbit of the point of its curve with the same alpha - gamma
_BESIDE = (function(c, [k], when((abs(40 * e - k) < 2) & (k != 0) & (abs(k) != 20), k, c(k + 1))), let(s, c(-39) / 40), let(goal, HALF * (x + (s * x - 1) / (x - s))),
           rec(u, t, goal, u[t] / (1 - v[t] ** 2)), rec(v, t, goal - x, -v[t] * u[t] / (1 - v[t] ** 2)), let(near, exists(t, 1, 700, ~defined(u[t]) | (abs(u[t]) > 5))))
claim("BLZ94-P8.1", "infinitely many points of each period, in dimension two as in dimension one",
      (w == p) & (2 * (goal - al) * (x - e) * (x - s) == (s - e) * (x**2 - 1)) & (20 * abs(s - e) < 1) & near, sizes=["p"], over={x: scalar()},
      where=[let(n, 2), let(e, -cospi(2, p)), let(al, HALF * (x + CURVE_B)), let(ga, HALF * (CURVE_B - x)),
             let(alpha0, rows([[al], [0]])), let(gamma0, rows([[-ga / al], [ga]])), *ORBIT,
             function(f, [k], when(alpha[k][1] - gamma[k][2] == x, when(gamma[k][1] == gamma0[1], k, f(k + 1)), f(k + 1))), let(w, f(1)), *_BESIDE],
      given=[standing("p > 2", p > 2)],
      by=[steps("BLZ94-E8.4", "BLZ94-X.9", "BLZ94-S63", facts=["sin(t pi q/p) = 0 for coprime q, p if and only if p divides t",
                                                              "Kronecker: the multiples of an irrational angle are dense in the circle"],
                prose="On the curves with angle pi/p every x gives another point. Arbitrarily close to any kappa are those with irrational angle, whose orbits are dense in the "
                      "unbounded curve."),
          instances(12, p=(3, 4, 5, 6, 7))],
      note="gamma_0 = -gamma_1/alpha_1 is the earlier value of the parameter. alpha_2 = 0 is the case of S63. The neighbour has the same alpha - gamma = x and the "
           "rational 1/kappa = s, whose angle is irrational; the equation says how far it is, less than any distance as s tends to e. near: its orbit, (u_t, v_t) of order one, has |u_t| > 5 or ends, for some t <= 700.")
