# SPDX-License-Identifier: MIT
"""Section 8: orders one and two.

For n = 1 the constant of the motion is 1 + alpha^2 - gamma^2 = (2/kappa) alpha, so that alpha moves by
the fractional linear map alpha -> kappa/(2 - kappa alpha). If lambda + 1/lambda = 2/kappa with |lambda| < 1, the cross ratio
(alpha - lambda)/(alpha - 1/lambda) is multiplied by lambda^2 in each step. With a = alpha - gamma and b = alpha + gamma the curve is
1 + ab = (a + b)/kappa; if 1/kappa = -cos(2 pi q/p) every orbit returns after p steps.

For n = 2 the two constants are the quotients of the coefficients of D. At an equilibrium D = alpha(z)alpha(1/z), and other
equilibria on the same manifold come from reflecting roots of alpha(z) in the unit circle.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import evaluation, example, identity, induction, instances, steps
from exactkf.language import (
    T,
    Z,
    always,
    block,
    charpoly,
    circle_roots,
    coeff,
    column,
    coprime,
    defined,
    diag,
    det,
    exists,
    forall,
    function,
    given,
    iff,
    inside_roots,
    integer,
    inv,
    let,
    matrix_of,
    monic,
    nonneg_on_circle,
    nonzero,
    outside_roots,
    pos_on_circle,
    positive,
    prints,
    prod,
    rank,
    rational,
    real_roots,
    rec,
    recip,
    rows,
    scalar,
    schur,
    sqrt,
    standing,
    substitute,
    sum_of,
    symbols,
    vector,
    vstack,
    when,
)
from proofs.blz94.notation import (
    FAST,
    HALF,
    KIMURA,
    ORBIT,
    SHIFT,
    STEP,
    A,
    D,
    G,
    a,
    a0,
    alpha,
    alpha0,
    b,
    b0,
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
    r,
    s,
    symmetric_part,
    t,
    u,
)

p, q, v, w, x, y, kappa, lam, c, e, f, S, X = symbols("p q v w x y kappa lambda c e f S X")
k1, k2, al, ga = symbols("kappa1 kappa2 alpha_bar gamma_bar")

#: (8.1) from (al, ga)
ONE = (rec(alpha, t, al, alpha[t] / (1 - gamma[t] ** 2)), rec(gamma, t, ga, -gamma[t] * alpha[t] / (1 - gamma[t] ** 2)))
POINT = {al: scalar(), ga: scalar()}
#: D of order one
D_ONE = (let(D, symmetric_part(Z + al - ga, Z + al + ga)),)
DEFINITE = nonneg_on_circle(D) | nonneg_on_circle(-D)
#: a point of the curve with 1/kappa = e, by a = alpha - gamma
_B = (e * x - 1) / (x - e)
ON_CURVE = {al: HALF * (x + _B), ga: HALF * (_B - x)}

# ---------------------------------------------------------------------- order one
claim("BLZ94-E8.1", "(8.1)-(8.3) are (4.4) and (3.12) for n = 1",
      always(t, (A[t] * alpha[t] == alpha[t] / (1 - gamma[t][1] ** 2)) & (G[t + 1] * gamma[t] == -gamma[t] * alpha[t][1] / (1 - gamma[t][1] ** 2)))
      & (a == Z + alpha0[1] - gamma0[1]) & (b == Z + alpha0[1] + gamma0[1]), sizes=["n"], over={alpha0: vector(n), gamma0: vector(n)},
      where=[*ORBIT, let(a, Z - gamma0[1] + alpha0[1]), let(b, Z + gamma0[1] + alpha0[1])], given=[standing("n = 1", n == 1)],
      by=[instances(n=(1,))], note="phi_1 = z - gamma_0, psi_1 = z + gamma_0.")

claim("BLZ94-F8.1a", "the open diamond is the positive real region", iff(abs(al) + abs(ga) < 1, schur(Z + al - ga) & pos_on_circle(D)),
      over=POINT, where=D_ONE,
      by=[steps(prose="D = 1 + alpha^2 - gamma^2 + 2 alpha cos(theta) is positive for all theta if and only if |gamma| < |1 - |alpha||. If |alpha| < 1 "
                      "this is the diamond, where |alpha - gamma| < 1; if |alpha| > 1 it makes |alpha - gamma| > 1."),
          instances(40), instances(20, using={x: scalar()}, made_by={al: x / 4, ga: (1 - x / 4) * HALF}),
          example({al: "1/2", ga: "1/2"}), example({al: 3, ga: 1})])

claim("BLZ94-F8.1b", "D is sign definite exactly in the shaded regions; v(1/z) there",
      iff(DEFINITE, (abs(ga) <= abs(1 - abs(al))) | (abs(ga) >= 1 + abs(al)))
      & (((abs(al) > 1) & (abs(ga) < abs(al) - 1)) >> (pos_on_circle(D) & (inside_roots(1 + (al - ga) * Z) == 1)))
      & ((abs(ga) > 1 + abs(al)) >> (pos_on_circle(-D) & (inside_roots(1 + (al - ga) * Z) == 1))), over=POINT, where=D_ONE,
      by=[steps(prose="The extreme values of D on the circle are (1 + |alpha|)^2 - gamma^2 and (1 - |alpha|)^2 - gamma^2. v(1/z) has the pole "
                      "-1/(alpha - gamma)."),
          instances(40), example({al: 3, ga: 2}), example({al: 3, ga: 1}), example({al: -3, ga: 1}), example({al: 1, ga: 2}), example({al: 1, ga: 3}),
          example({al: -1, ga: -3}), example({al: "1/2", ga: "1/2"}), example({al: 2, ga: 2}), example({al: -2, ga: 2}), example({al: 0, ga: 2}),
          example({al: "5/2", ga: 1})],
      note="Regions with their boundary for definiteness, open ones for positive and negative realness. v(1/z) is positive (negative) real if D > 0 "
           "(D < 0) and its pole lies inside the circle.")

claim("BLZ94-F8.1c", "escape in one step happens on gamma = 1 and gamma = -1", iff(defined(alpha[1]) & defined(gamma[1]), (ga != 1) & (ga != -1)), over=POINT,
      where=ONE, by=[example({al: 2, ga: 1}), example({al: 2, ga: -1}), example({al: 0, ga: 1}), example({al: 2, ga: 2}), example({al: 1, ga: "1/2"}), instances(20)])

claim("BLZ94-E8.4", "the invariant curve of order one; the axis alpha = 0",
      forall(t, 0, 3, al * (1 + alpha[t] ** 2 - gamma[t] ** 2) == (1 + al**2 - ga**2) * alpha[t]) & (0 * al / (1 - ga**2) == 0), over=POINT, where=ONE,
      by=[steps("BLZ94-E4.13", prose="The two coefficients d_0 = 1 + alpha^2 - gamma^2 and d_1 = alpha are multiplied by the same factor in each step. With "
                                     "alpha = 0, (8.1) gives (0, 0)."), instances(20)])

claim("BLZ94-F8.2a", "the curves with kappa^2 < 1 and kappa^2 = 1",
      ((kappa**2 < 1) >> DEFINITE) & ((kappa == 1) >> ((al - 1) ** 2 == ga**2)) & ((kappa == -1) >> ((al + 1) ** 2 == ga**2)),
      over={**POINT, kappa: nonzero()}, where=D_ONE, given=[given("(8.4)", 1 + al**2 - ga**2 == 2 / kappa * al)],
      by=[steps(prose="On the circle D = 2 alpha (1/kappa + cos(theta)), and |1/kappa| > 1. For kappa = 1, -1, (8.4) is a difference of squares."),
          instances(30, using={x: scalar()}, made_by={al: HALF * (x + (x / kappa - 1) / (x - 1 / kappa)), ga: HALF * ((x / kappa - 1) / (x - 1 / kappa) - x)}),
          example({al: 3, ga: 2, kappa: 1}), example({al: 3, ga: 4, kappa: -1}), example({al: 3, ga: -4, kappa: -1}), example({al: 3, ga: -2, kappa: 1}),
          example({al: 1, ga: 1, kappa: 2}), example({al: 1, ga: 2, kappa: 1}), example({al: 1, ga: 3, kappa: -1}), example({al: 0, ga: 1, kappa: -1}),
          example({al: 2, ga: 2, kappa: "1/2"})])

_CROSS = forall(t, 0, m, (alpha[t] - lam) * (al - 1 / lam) == lam ** (2 * t) * (al - lam) * (alpha[t] - 1 / lam))
claim("BLZ94-F8.2b", "every point of the shaded regions converges to the point of its curve with |alpha| <= 1",
      abs(al) <= 1, over=POINT, where=[*D_ONE, *ONE],
      given=[given("D is sign definite", DEFINITE), given("the orbit stays where it is", (alpha[1] == al) & (gamma[1] == ga))],
      by=[example({al: 2, ga: 0}), instances(made_by={ga: 0 * al})],
      note="A consequence for equilibria, whose limit is the point itself: (2, 0) lies in the shaded region and stays there.",
      repair=repair("missing hypothesis", "The equilibria with |alpha| > 1 and the points that escape have to be excepted; otherwise the cross ratio with "
                                          "the two equilibria of the curve is multiplied by lambda^2 in each step, lambda the one inside.",
                    _CROSS, sizes=["m"], over={lam: nonzero(), x: scalar()},
                    where=[let(al, HALF * (x + _B)), let(ga, HALF * (_B - x)), *ONE, let(e, HALF * (lam + 1 / lam))],
                    by=[identity(m=range(0, 4)), instances(m=(1, 2, 3))]))

claim("BLZ94-S59", "n = 1: a common pair of reciprocal roots only at (1, 0) and (-1, 0)",
      iff(substitute(Z + al - ga, x) * substitute(Z + al - ga, 1 / x) + substitute(Z + al + ga, x) ** 2 == 0, (ga == 0) & (al == -x) & (x**2 == 1)),
      over={**POINT, x: nonzero()},
      given=[standing("x and 1/x are the roots, so x = 1/x", x**2 == 1)],
      by=[steps(prose="A polynomial of degree one has one root, so x = 1/x; both a(x) and b(x) vanish."),
          example({al: 1, ga: 0, x: -1}), example({al: -1, ga: 0, x: 1}), example({al: 1, ga: 1, x: 1}), example({al: 0, ga: 1, x: 1}), example({al: 0, ga: 1, x: -1}),
          example({al: 1, ga: 2, x: 1}), example({al: 2, ga: 0, x: 1}), example({al: 1, ga: 0, x: 1}), instances(20, made_by={x: 0 * al - 1})],
      note="A sum of squares says that both vanish. The text refers to a Theorem 5.27; there is none, Theorem 5.11 with (5.27) is meant.")

#: S of order one, (6.14)
_S_ONE = (let(c, -al), let(S, rows([[1 / c, -1 / c], [ga**2 / c, c - ga**2 / c]])))
claim("BLZ94-S60", "n = 1: the eigenvalues of S for each kappa",
      (charpoly(S) == Z**2 + 2 / kappa * Z + 1)
      & ((kappa**2 < 1) >> ((inside_roots(charpoly(S)) == 1) & (outside_roots(charpoly(S)) == 1)))
      & ((kappa == 1) >> (charpoly(S) == (Z + 1) ** 2)) & ((kappa == -1) >> (charpoly(S) == (Z - 1) ** 2))
      & ((kappa**2 > 1) >> ((circle_roots(charpoly(S)) == 2) & ~DEFINITE)),
      over={al: nonzero(), ga: scalar(), kappa: nonzero()}, where=[*_S_ONE, *D_ONE], given=[given("(8.4)", 1 + al**2 - ga**2 == 2 / kappa * al)],
      by=[steps("BLZ94-C6.5", prose="A = F - gh' = -alpha. The trace of S is -(1 + alpha^2 - gamma^2)/alpha, its determinant is one; a root is "
                                    "-1/kappa plus or minus the root of 1/kappa^2 - 1."),
          instances(30, using={x: scalar()}, made_by={al: HALF * (x + (x / kappa - 1) / (x - 1 / kappa)), ga: HALF * ((x / kappa - 1) / (x - 1 / kappa) - x)}),
          example({al: 3, ga: 2, kappa: 1}), example({al: 3, ga: 4, kappa: -1}), example({al: 1, ga: 1, kappa: 2}), example({al: 2, ga: 0, kappa: "4/5"}),
          example({al: -1, ga: 1, kappa: -2})],
      note="Nonconvergence is Corollary 5.3; there is no Theorem 5.34. kappa infinite means trace zero, eigenvalues i and -i.")

claim("BLZ94-S61", "0 < kappa^2 < 1: the equilibria on the curve, and how they attract",
      (inside_roots(Z**2 - 2 / kappa * Z + 1) == 1) & (outside_roots(Z**2 - 2 / kappa * Z + 1) == 1), over={kappa: nonzero()},
      given=[given("kappa^2 < 1", kappa**2 < 1)],
      by=[steps("BLZ94-E8.4", prose="With gamma = 0, (8.4) is alpha^2 - (2/kappa) alpha + 1 = 0; the product of the roots is one, they are real and differ. That every "
                                    "other orbit tends to the root inside is the cross ratio of Figure 8.2. The Jacobian at (alpha, 0) is diag(1, -alpha)."),
          example({kappa: "1/2"}), example({kappa: "-1/3"}), example({kappa: 2}), instances(20)])

#: 1/kappa = -cos(2 pi q/p) for one q prime to p
_COS = when(p == 3, HALF, when(p == 4, 0, when(p == 5, (1 + sqrt(5)) / 4, when(p == 6, -HALF, when(p == 8, sqrt(2) / 2, when(
    p == 10, -(1 + sqrt(5)) / 4, -sqrt(3) / 2))))))
_PERIODS = (3, 4, 5, 6, 8, 10, 12)
_CURVE = (let(e, _COS), let(al, HALF * (x + _B)), let(ga, HALF * (_B - x)), *ONE)
_PERIOD = (alpha[p] == al) & (gamma[p] == ga) & forall(k, 1, p - 1, ~((alpha[k] == al) & (gamma[k] == ga)))
claim("BLZ94-X8.A1", "on the curves with angle q pi/p all orbits that do not escape have period p", _PERIOD, sizes=["p"], over={x: scalar()}, where=_CURVE,
      by=[instances(28, p=_PERIODS)],
      note="Both conditions of the text are 1/kappa = -cos(2 pi q/p). One q for each p in 3, 4, 5, 6, 8, 10, 12; x = alpha - gamma names any point of the curve.")

claim("BLZ94-X8.A3", "every period from three on occurs", _PERIOD, sizes=["p"], over={x: scalar()}, where=_CURVE, by=[instances(28, p=_PERIODS)],
      note="Checked for p = 3, 4, 5, 6, 8, 10, 12. In general 1/kappa = -cos(2 pi/p) has the angle pi/p, with q = 1: kappa < -1 for p > 4, kappa infinite for "
           "p = 4, kappa = 2 for p = 3.")

#: alpha that escape at step k: backwards from infinity by alpha -> 2/kappa - 1/alpha
claim("BLZ94-X8.A2", "the number of points that escape", (w == when(p == 3, 4, when(p == 5, 8, p - 2))), sizes=["p"],
      where=[let(e, _COS), function(y, [k], when(k == 1, 2 * e, 2 * e - 1 / y(k - 1))),
             function(f, [k], when(k == 1, when(2 * e == 0, 1, 1), when(y(k - 1) == 0, 0, f(k - 1)))),
             let(w, 2 * sum_of(k, 1, p, f(k) * when(f(k) == 1, 1, 0)))],
      by=[evaluation(p=_PERIODS)],
      note="alpha escapes at step k if alpha moves to infinity in k steps; each such alpha belongs to two points, gamma and -gamma. Going back "
           "from infinity one comes to 0, and there the list ends. 2(p - 1) is 4 and 8 for p = 3 and 5.")
