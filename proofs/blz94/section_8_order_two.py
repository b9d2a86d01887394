# SPDX-License-Identifier: MIT
"""Section 8: order two.

The two constants of the motion are the quotients of the coefficients of D. At an equilibrium D = alpha(z)alpha(1/z), and other
equilibria on the same manifold come from reflecting roots of alpha(z) in the unit circle. The manifold is singular where a(z) and b(z)
have a common root 1 or -1 or a common pair of reciprocal roots.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, identity, instances, restated, steps
from exactkf.language import (
      Identity,
      T,
      Z,
      block,
      circle_roots,
      coeff,
      coprime,
      cospi,
      defined,
      det,
      function,
      given,
      iff,
      inside_roots,
      inv,
      let,
      monic,
      nonneg_on_circle,
      nonzero,
      outside_roots,
      pos_on_circle,
      positive,
      rank,
      rational,
      real_roots,
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
from proofs.blz94.notation import HALF, ORBIT, A, D, F, a, alpha, alpha0, b, g, gamma, gamma0, h, i, j, k, monic_of, n, symmetric_part, t, u
from proofs.blz94.section_7_convergence import ALONG, CONVERGENCE, POWERS_TEND, TENDS
from proofs.blz94.section_8 import CURVE_B, ONE, al, ga

p, q, r, s, v, w, x, y, c, d, e, f, S, X = symbols("p q r s v w x y c d e f S X")
k1, k2 = symbols("kappa1 kappa2")

claim("BLZ94-E8.5", "(8.5) is (4.4) for n = 2",
      (alpha[1][1] == alpha0[1] / (1 - gamma0[2] ** 2) + gamma0[2] / (1 - gamma0[2] ** 2) * gamma0[1] / (1 - gamma0[1] ** 2) * alpha0[2])
      & (alpha[1][2] == alpha0[2] / (1 - gamma0[1] ** 2)) & (gamma[1][1] == gamma0[2])
      & (gamma[1][2] == -alpha[1][1] * gamma0[2] - alpha[1][2] * gamma0[1]), over={alpha0: vector(2), gamma0: vector(2)}, where=[let(n, 2), *ORBIT],
      by=[identity(), instances()],
      note="(8.5c) at t + 1, for t = 0, 1, ...; at t = 0 it would ask for gamma_(-1). gamma_0 and gamma_1 are data.")

al1, al2, ga0, ga1 = symbols("alpha1 alpha2 gamma0 gamma1")
_R1, _R2 = 1 - ga0**2, (1 - ga0**2) * (1 - ga1**2)
_PHI2 = (let(a, Z * (Z - ga0) - ga1 * (1 - ga0 * Z) + al1 * (Z - ga0) + al2), let(b, Z * (Z + ga0) + ga1 * (1 + ga0 * Z) + al1 * (Z + ga0) + al2),
         let(D, symmetric_part(a, b)))
_POINT2 = {al1: scalar(), al2: scalar(), ga0: scalar(), ga1: scalar()}
claim("BLZ94-E8.6", "the coefficients of D for n = 2",
      (coeff(D, 0) == al2**2 + _R1 * al1**2 + _R2) & (coeff(D, 1) == _R1 * al1 + al1 * al2 + ga0 * ga1 * al2) & (coeff(D, 2) == al2),
      over=_POINT2, where=_PHI2, by=[identity(), instances()], note="kappa_i = 2 d_i/d_0, so (8.6) is 2 d_i = kappa_i d_0.")

claim("BLZ94-E8.7", "the constants at an equilibrium for n = 2",
      (2 * coeff(D, 1) / coeff(D, 0) == 2 * al1 * (1 + al2) / (al2**2 + al1**2 + 1)) & (2 * coeff(D, 2) / coeff(D, 0) == 2 * al2 / (al2**2 + al1**2 + 1)),
      over={al1: scalar(), al2: scalar()}, where=[let(ga0, 0), let(ga1, 0), *_PHI2], by=[identity(), instances()])

_W = let(f, Z**2 + al1 * Z + al2)
_AL = {al1: scalar(), al2: scalar()}
_TRIANGLE = (abs(al1) <= 1 + al2) & (al2 <= 1)
_GRID = ((0, -1), (-2, 1), (2, 1), (1, 1), (0, 1), (1, 0), (-1, 0), ("1/2", "-1/2"), ("-1/2", "-1/2"), (3, 2), (-3, 2), (3, 1), (0, 2), (0, "-3/2"),
         (1, "1/4"), (0, "1/2"), (1, "1/2"), ("1/2", 0), (1, "1/5"), ("247/100", "3/2"), (-2, 2), (-1, "1/4"))
_EDGES = [example({al1: x_, al2: y_}) for x_, y_ in _GRID]
claim("BLZ94-F8.3a", "the closed triangle is the set of alpha with all zeros inside the unit circle", iff(_TRIANGLE, schur(f)), over=_AL, where=[_W],
      by=[*_EDGES[:1], instances(20)], note="The text says that all zeros lie inside the unit circle, and speaks of the closed triangle.",
      repair=repair("boundary case", "The closed triangle belongs to zeros in the closed disc; on its boundary zeros lie on the circle.",
                    iff(_TRIANGLE, inside_roots(f) + circle_roots(f) == 2), over=_AL, where=[_W],
                    by=[steps(facts=["Schur and Cohn: all roots of z^2 + uz + v lie in |z| < 1 if and only if |v| < 1 and |u| < 1 + v"],
                              prose="The closed case is its limit."), *_EDGES, instances(20)]))

_INSIDE = (abs(al1) < 1 + al2) & (al2 < 1)
claim("BLZ94-F8.3b", "eigenvalues of S at the points of the triangle",
      iff(_INSIDE, inside_roots(f) == 2) & (circle_roots(f * q) == 2 * circle_roots(f)) & iff(_TRIANGLE & ~_INSIDE, (circle_roots(f) > 0) & (outside_roots(f) < 1))
      & (w * real_roots(f * q, -x, x) == w * when(4 * al2 < al1**2, 4, when(4 * al2 > al1**2, 0, 2))),
      over={al1: scalar(), al2: nonzero()}, where=[_W, let(q, 1 + al1 * Z + al2 * Z**2), let(x, 2 + abs(al1) + abs(al2) + (1 + abs(al1)) / abs(al2)), let(w, when(_INSIDE, 1, 0))],
      by=[steps(facts=["the discriminant of z^2 + uz + v is u^2 - 4v", "Schur and Cohn: all roots of z^2 + uz + v lie in |z| < 1 if and only if |v| < 1 and |u| < 1 + v"],
                prose="z^2 D = f q up to a factor, q having the inverse roots of f. A root of f on the circle comes with its conjugate, which is its inverse, so that q has it as often as f."),
          *[example({al1: x_, al2: y_}) for x_, y_ in _GRID if y_ != 0], instances(20)],
      note="f = alpha_infinity(z), q its reversed polynomial; the eigenvalues of S are the zeros of fq, and real zeros lie between -x and x. Inside the triangle, where w = 1, four of them are real and "
           "different below the parabola, none is above; on the boundary some are on the circle.")

claim("BLZ94-F8.3c", "the other equilibria with the same D",
      (x**2 * q * recip(q) == f * recip(f)) & (x**2 * y**2 * w * recip(w) == f * recip(f)) & (inside_roots(q) == 1) & (outside_roots(q) == 1) & (outside_roots(w) == 2)
      & (c**2 * e * recip(e) == p * recip(p)) & (outside_roots(e) == 2),
      over={x: nonzero(), y: nonzero(), r: scalar(), s: nonzero()},
      where=[let(f, (Z - x) * (Z - y)), let(q, (Z - 1 / x) * (Z - y)), let(w, (Z - 1 / x) * (Z - 1 / y)), let(c, r**2 + s**2), let(p, Z**2 - 2 * r * Z + c), let(e, Z**2 - 2 * r / c * Z + 1 / c)],
      given=[given("x inside", abs(x) < 1), given("y inside", abs(y) < 1), given("the pair inside", r**2 + s**2 < 1)],
      by=[steps(facts=["a polynomial has one factorization into linear ones"],
                prose="Each zero of f may be replaced by its inverse: two saddles from x or y alone, one unstable from both. Of the complex zeros of p one alone cannot be replaced, "
                      "as e has real coefficients."),
          instances(20, using={u: nonzero(), v: nonzero(), k: scalar(), d: nonzero()}, made_by={x: u / 7, y: v / 7, r: k / 7, s: d / 7}), example({x: 2, y: "1/2", r: 0, s: "1/2"}), example({x: "1/3", y: 2, r: 0, s: "1/2"}),
          example({x: "1/3", y: "1/2", r: 0, s: 2}), example({x: "1/3", y: "1/2", r: "-1/3", s: "1/2"})],
      note="f has the real zeros x, y: below the parabola; p the complex zeros r + is, r - is: above it. For x = y, on the parabola, the two saddles are one.")

_ROWS = rows([[1 + al1**2 + al2**2, al1 * (1 + al2), al2], [2 * al1, 1 + al2, 0], [2 * al2, al1, 1]])
#: a and b with their coefficients; D and its derivatives with respect to these, one a row
_AB2 = (let(a, Z**2 + al1 * Z + al2), let(b, Z**2 + ga0 * Z + ga1), let(D, symmetric_part(a, b)),
        let(e, rows([[coeff(D, 0), coeff(D, 1), coeff(D, 2)],
                     [coeff(symmetric_part(Z, b), 0), coeff(symmetric_part(Z, b), 1), coeff(symmetric_part(Z, b), 2)],
                     [coeff(symmetric_part(1, b), 0), coeff(symmetric_part(1, b), 1), coeff(symmetric_part(1, b), 2)],
                     [coeff(symmetric_part(a, Z), 0), coeff(symmetric_part(a, Z), 1), coeff(symmetric_part(a, Z), 2)],
                     [coeff(symmetric_part(a, 1), 0), coeff(symmetric_part(a, 1), 1), coeff(symmetric_part(a, 1), 2)]])))
#: the D of (u, v)
_D_UV = (1 + u**2 + v**2, u * (1 + v), v)
_SAME = given("on the same invariant manifold", (coeff(D, 1) * _D_UV[0] == _D_UV[1] * coeff(D, 0)) & (coeff(D, 2) * _D_UV[0] == _D_UV[2] * coeff(D, 0)))
_INTERIOR = given("interior of the triangle", (abs(u) < 1 + v) & (v < 1))
_SIX = {"over": {**_POINT2, u: scalar(), v: scalar()}, "where": _AB2}
#: b from a and (u, v): three linear equations for the coefficients of b and the factor
_A2 = Z**2 + al1 * Z + al2
_SOLVED = inv(rows([[coeff(symmetric_part(_A2, Z), j_), coeff(symmetric_part(_A2, 1), j_), -_D_UV[j_]] for j_ in range(3)])) * rows(
    [[-coeff(symmetric_part(_A2, Z**2), j_)] for j_ in range(3)])
claim("BLZ94-S65", "the invariant manifold of an interior point has no singular point", rank(e) == 3, **_SIX,
      given=[_INTERIOR, _SAME, standing("D is not zero", coeff(D, 0) != 0)],
      by=[example({al1: "5/2", al2: 1, ga0: "5/2", ga1: 1, u: 1, v: "1/4"}), instances(made_by={al1: u + 0, al2: v + 0, ga0: u + 0, ga1: v + 0})],
      note="a = z^2 + alpha_1 z + alpha_2 and b = z^2 + gamma_0 z + gamma_1 here. The manifold is smooth where the rows, D and its derivatives, span the space of all D. "
           "(u, v) = (1, 1/4) lies on the parabola, and a = b = z^2 + (5/2)z + 1 on its manifold.",
      repair=repair("missing hypothesis", "The points on the parabola have to be excepted: reflecting one of two equal zeros gives an equilibrium with a pair "
                                          "of reciprocal zeros, which is a singular point.",
                    rank(e) == 3, **_SIX, given=[_INTERIOR, _SAME, standing("D is not zero", coeff(D, 0) != 0), given("not on the parabola", u**2 != 4 * v)],
                    by=[steps(facts=["a polynomial has one factorization into linear ones"],
                              prose="Where the rank is smaller, some number or polynomial of degree one other than zero, p, has p(z)b(1/z) + p(1/z)b(z) = 0 or the like, so that a and b "
                                    "have a common zero 1 or -1 or a common pair s, 1/s (Theorem 5.11). Then D has a zero on the circle, which the interior excludes, or a = b = "
                                    "(z - s)(z - 1/s), D is a multiple of (z - s)^2(1/z - s)^2 and (u, v) lies on the parabola."),
                        example({al1: "5/2", al2: 1, ga0: "5/2", ga1: 1, u: 1, v: "1/4"}), example({al1: 0, al2: 1, ga0: 0, ga1: 1, u: 0, v: 0}),
                        example({al1: 3, al2: 2, ga0: 3, ga1: 2, u: 3, v: 2}), example({al1: 0, al2: 1, ga0: 0, ga1: 1, u: 0, v: 1}),
                        instances(16, using={x: nonzero(), y: nonzero(), S: vector(3)},
                                  made_by={u: -x / 7 - y / 7, v: x * y / 49, S: _SOLVED, ga0: S[1, 1], ga1: S[2, 1]}),
                        instances(8, using={x: nonzero(), y: nonzero()}, made_by={u: -x / 7 - y / 7, v: x * y / 49, al1: -7 / x - y / 7, al2: y / x, ga0: al1 + 0, ga1: al2 + 0})]))

claim("BLZ94-S68", "the points on the boundary of the triangle are singular", det(_ROWS) == (1 - al2) * ((1 + al2) ** 2 - al1**2), over=_AL,
      by=[identity(), instances(),
          restated("a level set is singular where the derivatives of D, with D itself, are dependent; those by gamma vanish at gamma = 0")],
      note="The determinant vanishes exactly on the three lines that bound the triangle.")

_VALUES = let(w, rows([[1], [x + 1 / x], [x**2 + x**-2]]))
#: points with a common root 1, with a common root -1, and the equilibria with a pair of reciprocal roots
_AT_ONE = {x: 1 + 0 * u, al1: u + 0, ga1: v + 0, ga0: -v / (1 + u), al2: -1 - u - ga0 * ga1}
_AT_MINUS_ONE = {x: -1 + 0 * u, al1: u + 0, ga0: v + 0, ga1: v * (1 - u), al2: -(1 + ga0) * (1 - ga1 - u)}
_PAIR = {al1: -x - 1 / x, al2: 1 + 0 * x, ga0: 0 * x, ga1: 0 * x}
claim("BLZ94-S64", "a common root 1 or -1, or a common pair of reciprocal roots, makes a point singular; the pair occurs at equilibria only",
      (e * w == rows([[0]] * 5)) & ((x**2 == 1) | ((a == (Z - x) * (Z - 1 / x)) & (ga0 == 0) & (ga1 == 0))), over={**_POINT2, x: nonzero()},
      where=[*_PHI2, _AB2[-1], _VALUES],
      given=[given("common roots of a", (substitute(a, x) == 0) & (substitute(a, 1 / x) == 0)), given("common roots of b", (substitute(b, x) == 0) & (substitute(b, 1 / x) == 0))],
      by=[steps(prose="Where a and b vanish at x and at 1/x, so do D and its derivatives, whose values at x are e times w; then they do not span the space of all D. If x and 1/x are different, a = b "
                      "is the product of z - x and z - 1/x, and b - a = 2 gamma_0 z + 2(gamma_1 + alpha_1 gamma_0) is zero for gamma_0 = gamma_1 = 0 alone."),
          instances(20, using={u: scalar(), v: nonzero()}, made_by=_AT_ONE), instances(20, using={u: scalar(), v: nonzero()}, made_by=_AT_MINUS_ONE), instances(20, made_by=_PAIR),
          example({al1: -1, al2: 0, ga0: 0, ga1: 0, x: 1}), example({al1: 0, al2: -1, ga0: 0, ga1: 0, x: -1}), example({al1: 2, al2: 1, ga0: 0, ga1: 0, x: -1}),
          example({al1: 0, al2: 0, ga0: 1, ga1: 0, x: 1}), example({al1: 0, al2: 2, ga0: 0, ga1: 0, x: 1}), example({al1: "5/2", al2: 1, ga0: 1, ga1: 0, x: "-1/2"})],
      note="e has D and its derivatives with respect to the coefficients of a and b for rows. The points with x = 1 and gamma_1 = -gamma_0 (1 + alpha_1), alpha_2 = -1 - alpha_1 - gamma_0 gamma_1 "
           "are no equilibria for gamma_0 != 0. x stands for -lambda.")

claim("BLZ94-S67", "n = 2: no eigenvalue on the circle off the boundary of the triangle", inside_roots(f) + outside_roots(f) == 2, over=_AL, where=[_W],
      given=[given("not on the boundary of the triangle", ~(_TRIANGLE & ~_INSIDE))],
      by=[example({al1: -4, al2: 3}), example({al1: "1/2", al2: "1/4"}), example({al1: 0, al2: 3})],
      note="f = z^2 + uz + v is the polynomial of the equilibrium (u, v); E is a center manifold of dimension two if f has no zero on the circle. The text names the lines through the corners and "
           "the boundary of the triangle as if they were the same. With the boundary the sentence is false; with the lines it is right but for these words.",
      repair=repair("boundary case", "All of the lines have to be excepted, not the sides of the triangle alone: at (-4, 3), where z^2 - 4z + 3 has the zeros 1 and 3, a center manifold has dimension three.",
                    inside_roots(f) + outside_roots(f) == 2, over=_AL, where=[_W],
                    given=[given("not on the lines through the corners", ((1 + al2) ** 2 != al1**2) & (al2 != 1))],
                    by=[steps(prose="A zero 1 or -1 is 1 + v = -u or u; a pair on the circle is v = 1 with |u| < 2. The other eigenvalues of the derivative at (alpha, 0) are one, twice, so "
                                    "that the center manifold has the dimension of E."), *_EDGES, instances(20)]))

claim("BLZ94-S70", "dimensions of the center manifolds on the boundary of the triangle", x == y, over=_AL,
      where=[_W, let(x, circle_roots(f)), let(y, when(al2 == 1, 2, when((al1 == 0) & (al2 == -1), 2, 1)))],
      given=[standing("boundary", _TRIANGLE & ((abs(al1) == 1 + al2) | (al2 == 1)))],
      by=[steps(prose="The dimension is n + c (Theorem 5.2), c the number of zeros on the circle: v = 1 has two, (0, -1) has 1 and -1, the open edges have one."),
          *_EDGES[:5], instances(10, using={u: scalar()}, made_by={al2: u**2 / (1 + u**2), al1: 1 + u**2 / (1 + u**2)}),
          instances(10, using={u: scalar()}, made_by={al2: -1 + u**2 / (2 + u**2), al1: u**2 / (2 + u**2)})])

claim("BLZ94-S69", "the invariant manifold of a point with v = 1, or of (0, -1), has dimension less than two",
      rank(e) < 3, over={**_POINT2, u: scalar()}, where=_AB2,
      given=[given("on the manifold of (u, 1)", (coeff(D, 0) == coeff(D, 2) * (2 + u**2)) & (coeff(D, 1) == coeff(D, 2) * 2 * u)),
             standing("D is not zero", coeff(D, 2) != 0)],
      by=[example({al1: 0, al2: 0, ga0: 0, ga1: 1, u: 0}), instances(10, made_by={al1: u + 0, al2: 1 + 0 * u, ga0: u + 0, ga1: 1 + 0 * u})],
      note="a = z^2 + alpha_1 z + alpha_2 and b = z^2 + gamma_0 z + gamma_1 here. Where D, up to a factor, is a map of rank two, the manifold is a surface. In "
           "the example a = z^2, b = z^2 + 1, with the D of z^2 + 1.",
      repair=repair("other", "The manifold is a surface at its points whose polynomial a(z) has no pair of reciprocal zeros and no zero 1 or -1.",
                    rank(e) == 3, over={**_POINT2, u: scalar()}, where=_AB2,
                    given=[given("a has no reciprocal zeros", (al2 - 1) * ((1 + al2) ** 2 - al1**2) != 0)],
                    by=[steps(prose="The last two rows and a(z)b(1/z) + a(1/z)b(z) are the values of an invertible linear map at z, 1 and b."),
                        example({al1: 1, al2: 1, ga0: 1, ga1: 1, u: 1}), example({al1: "5/2", al2: 1, ga0: "5/2", ga1: 1, u: 1}), instances(20)]))

_CLOSED = (let(n, 2), let(alpha0, rows([[0], [2]])), let(gamma0, rows([[rational("1/2")], [rational("1/3")]])), *ORBIT,
           function(al1, [t], alpha[t][1]), function(al2, [t], alpha[t][2]), function(ga0, [t], gamma[t][1]), function(ga1, [t], gamma[t][2]),
           function(a, [t], Z * (Z - ga0[t]) - ga1[t] * (1 - ga0[t] * Z) + al1[t] * (Z - ga0[t]) + al2[t]),
           function(b, [t], Z * (Z + ga0[t]) + ga1[t] * (1 + ga0[t] * Z) + al1[t] * (Z + ga0[t]) + al2[t]),
           function(D, [t], symmetric_part(a[t], b[t])))
_CLASSICAL = ["for positive real v the solution of the Riccati equation from zero increases to the stable solution", "Schur: |gamma_t| < 1 for positive real v, and a step keeps v "
              "positive real"]
#: the first step at which the data are positive real
_ENTERS = (function(f, [t], when(schur(a[t]) & pos_on_circle(D[t]), t, f(t + 1))), let(q, f(0)))
claim("BLZ94-X8.1a", "the point (0, 2, 1/2, 1/3): D is positive, v is not positive real, the orbit converges",
      (p == rational("14/3") + (Z + 1 / Z) / 3 + 2 * (Z**2 + Z**(-2))) & pos_on_circle(p) & (q == 5) & coprime(u, v),
      where=[*_CLOSED, *_ENTERS, let(p, D[0]), let(u, a[0]), let(v, b[0])],
      by=[steps(facts=_CLASSICAL, prose="From step five on the data are positive real, and not before."), instances()],
      note="q = 5 is the first step with positive real data; from there the classical theorem gives convergence. alpha_2 = 2 > 1 places the point in an unbounded region.")
claim("BLZ94-X8.1b", "|gamma_t| exceeds one exactly twice", (p == 2) & (q == 5), where=[*_CLOSED, *_ENTERS, let(p, sum_of(k, 0, 12, when(abs(gamma[k][1]) > 1, 1, 0)))],
      by=[steps(facts=_CLASSICAL, prose="From step five on the data are positive real, so that |gamma_t| < 1."), instances()],
      note="p counts up to time 12, and q = 5 is the first step with positive real data.")
claim("BLZ94-X8.1c", "after six steps the data are positive real and remain so", p == 5, where=[*_CLOSED, let(p, sum_of(k, 6, 10, when(schur(a[k]) & pos_on_circle(D[k]), 1, 0)))],
      by=[steps(facts=_CLASSICAL), instances()],
      note="p counts the positive real data among those of steps 6 to 10; those of step 5 are positive real already. Positive realness is kept by the algorithm, as the Schur parameters of v_t are later ones of v.")

claim("BLZ94-E8.9", "2/beta are the values of z + 1/z at the zeros of D",
      (k2 * (x**2 - 2) + k1 * x + 2 == 0) & (k2 * (y**2 - 2) + k1 * y + 2 == 0), over={k1: scalar(), k2: nonzero(), w: scalar()},
      where=[let(x, (-k1 + w) / (2 * k2)), let(y, (-k1 - w) / (2 * k2))], given=[given("w is the root", w**2 == k1**2 - 8 * k2 + 8 * k2**2)],
      by=[steps(prose="2D/d_0 = 2 + kappa_1(z + 1/z) + kappa_2(z^2 + 1/z^2), and z^2 + 1/z^2 = (z + 1/z)^2 - 2; z + 1/z = 2 cos(phi) = 2/beta."),
          instances(20, using={u: nonzero(), v: scalar()}, made_by={k2: 2 / (u * v + 2), k1: -(u + v) * 2 / (u * v + 2), w: 2 * (u - v) / (u * v + 2)})])

#: c = 2 cos(pi/72), x = 2 cos(9 pi/72), y = 2 cos(8 pi/72); a and b with the D of these angles, and S
_TURNS = (let(n, 2), let(c, 2 * cospi(1, 72)), let(p, c**3 - 3 * c), let(x, p**3 - 3 * p), let(y, ((c**2 - 2) ** 2 - 2) ** 2 - 2))
_ON_CURVE = (let(a, rows([[al1], [al2]])),
             let(b, inv(rows([[1 + al2, al1 + x + y], [2 * al1, 2 * al2 - x * y - 2]])) * rows([[-al1 - (x + y) * al2], [(x * y + 2) * al2 - 2]])), let(g, (b - a) / 2))
_S_OF = (let(F, rows([[-a[1], 1], [-a[2], 0]])), let(h, rows([[1], [0]])), let(A, F - g * T(h)),
         let(S, block([[inv(T(A)), -(inv(T(A)) * h * T(h))], [g * T(g) * inv(T(A)), A - g * T(g) * inv(T(A)) * h * T(h)]])))
_FIRST, _LOWER = rows([[1, 0], [0, 1], [0, 0], [0, 0]]), rows([[0, 0, 1, 0], [0, 0, 0, 1]])
_REST = 0 * Identity(2)
claim("BLZ94-X8.2", "every orbit that does not escape has the period 144",
      (Z**2 * symmetric_part(monic_of(a), monic_of(b)) == (a[2] + g[2]) * (Z**2 - x * Z + 1) * (Z**2 - y * Z + 1)) & (r == 144),
      over={al1: scalar(), al2: scalar()},
      where=[*_TURNS, *_ON_CURVE, *_S_OF, let(u, S**24), let(v, u**2), let(w, u**3),
             let(r, when(w * w == Identity(4), when(_LOWER * v * _FIRST == _REST, 48, when(_LOWER * w * _FIRST == _REST, 72, 144)), 0))],
      by=[steps("BLZ94-E6.16", "BLZ94-P6.6", facts=["planes that are invariant under a symplectic matrix and have no eigenvalue in common, nor one inverse to one of the other, are orthogonal"],
                prose="By (6.16) the state at time t is that of (X_t; Y_t) = S^t(I; 0): P_t is Y_tX_t^{-1}, and g(t) is (X_t')^{-1}g/(1 - h'P_th), its sign included. So the orbit is back where S^t = I, and at a divisor t "
                      "of 144 only if the plane of (I; 0) is invariant under S^t. The eigenvalues of S are those of P6.6, simple, of the orders 16 and 18, so that S^144 = I. Their planes E and E* are orthogonal, and the form is not zero on them; it is on the plane of (I; 0), which is none of them. "
                      "S^48 is 1 on E and turns E* by a third, so an invariant plane would be one of them. S^72 is -1 and 1, so an invariant plane would hold an (x; 0) in E and a (y; 0) in E*. The form of (x; 0) and S(y; 0), a "
                      "product of a linear function of x and one of y, is zero, and so one of these is, and the form of (x; 0) and S(x; 0), or that of (y; 0) and S(y; 0): then it is zero on E, or on E*."),
          example({al1: 0, al2: "1/2"}), instances(2)],
      note="(al_1, al_2) = a names any point of X_D at which the linear equations for b have one solution. r is the least period: each proper divisor of 144 divides 48 or 72, and v and w, the powers 48 and 72 of S, do not keep the plane of (I; 0).")


# ---------------------------------------------------------------------- Figures 8.4 to 8.6, sign indefinite D
inward, up, down, right, left = symbols("inward up down right left")
_THIRD = rational("1/3")
_REGIONS = ((0, 0, 0, 1), (0, 5, 1, 0), (0, -5, 1, 0), (9, 0, 1, 0), (-9, 0, 1, 0))
#: a(z) and b(z) at the point (i, j) of the plane of Figure 8.4, and whether D is positive there
_PLANE = (function(a, [i, j], Z * (Z - HALF) - _THIRD * (1 - HALF * Z) + i * (Z - HALF) + j), function(b, [i, j], Z * (Z + HALF) + _THIRD * (1 + HALF * Z) + i * (Z + HALF) + j),
          function(d, [i, j], when(pos_on_circle(symmetric_part(a(i, j), b(i, j))), 1, 0)), let(p, 2 + 3 * x / 2 + y), let(q, 1 - 3 * x / 2 + y))
_BOUNDED = (p > 0) & (q > 0) & (abs(y) < HALF) & schur(f) & (x > rational("-5/3")) & (x < 1) & (inward == 1)
_UNBOUNDED = (((p > 0) & (q > 0) & (y > 1) & (up == 1)) | ((p < 0) & (q < 0) & (down == 1)) | ((p > 0) & (q < 0) & (right == 1)) | ((p < 0) & (q > 0) & (left == 1)))
claim("BLZ94-F8.4a", "one bounded and four unbounded regions in Figure 8.4, v positive real in the bounded one",
      (_BOUNDED | (_UNBOUNDED & ~schur(f))) & (c == 5), over={x: scalar(), y: scalar(), u: scalar(), w: scalar()},
      where=[*_PLANE, let(f, a(x, y)), let(r, u**2), let(s, w**2 / (1 + w**2)), let(inward, d(x * s, y * s)), let(up, d(x, y + r)), let(down, d(x, y - r)),
             let(right, d(x + r, y)), let(left, d(x - r, y)), let(c, d(0, 0) + d(0, 5) + d(0, -5) + d(9, 0) + d(-9, 0))], given=[given("D is positive", d(x, y) == 1)],
      by=[steps("BLZ94-E8.6", facts=["the geometric mean of two positive linear functions is concave", "a polynomial of degree two in c = cos(phi) with values e, f at 1, -1 and leading coefficient "
                                     "4y is positive between if and only if e and f are, and y <= 0 or 4 sqrt(y) < sqrt(e) + sqrt(f)", "zeros of a(z) do not cross the circle where D is not zero"],
                prose="The values of D at z = 1 and -1 are a(1)b(1) and a(-1)b(-1), p = b(1), q = a(-1), and the other two factors have their signs. So no point with p = 0 or q = 0 is in a region, which "
                      "leaves four parts. Let m = sqrt(a(1)b(1)) + sqrt(a(-1)b(-1)), to be compared with 4 sqrt(y) if y > 0. p, q < 0 makes y < -3/2: a convex part. If p and q differ in sign, each "
                      "horizontal line meets the part in a half-line to the same side, as m is concave and grows without bound along it: it is connected. If p, q > 0, then "
                      "20m <= 11(1 + 2y) + (100/11)(3 + 2y) by arithmetic means, which is less than 80 sqrt(y) for 2/3 <= y <= 1; and with the weights sqrt(3) and "
                      "1/sqrt(2) m <= sqrt(8) + 9(y - 1/2)/4 <= 4 sqrt(y) for 1/2 <= y <= 2/3, as the mean falls with x, from p = 0 on. For y > 1 raising y by e raises m by 2e at least and 4 sqrt(y) by less, and horizontal lines meet the part in intervals: it is connected. "
                      "For y < 1/2 it is a star around the origin, as m there is sqrt(8/3) and m is concave. v is positive real at the origin."),
          *[example({x: x_, y: y_, u: u_, w: w_}) for x_, y_, u_, w_ in _REGIONS], instances(24)],
      note="(x, y) = (alpha_1, alpha_2), gamma = (1/2, 1/3), and the regions are those of D > 0: D is never negative, and without their boundaries no two regions meet; with them the bounded one has a corner in common "
           "with the region to the left, (-5/3, 1/2), and with the one to the right, (1/3, -1/2). Each region is closed under the shift by r = u^2 or, the bounded one, under the contraction by s, which lies between 0 and 1.")

claim("BLZ94-F8.4b", "where the points of the regions of Figure 8.4 converge to", TENDS, sizes=["n", "m"], over={alpha0: vector(n), x: positive()},
      where=[let(gamma0, rows([[HALF], [rational("1/3")]])), *ALONG], given=[standing("n = 2", n == 2)],
      by=[steps(*CONVERGENCE, "BLZ94-T4.3.1", facts=[*POWERS_TEND, "Schur: |gamma_t| < 1 for positive real v, and a step keeps v positive real"],
                prose="Theorem 7.1 for gamma = (1/2, 1/3). Positive real data remain so, hence the limit polynomial has its zeros in the closed disc: the triangle."),
          example(n=2, m=3, alphabar=[0, 2], x="1/100"), example(n=2, m=3, alphabar=[0, 3], x="1/50"), example(n=2, m=3, alphabar=[0, 0], x="1/100"),
          example(n=2, m=3, alphabar=[5, 3], x="1/50"), example(n=2, m=3, alphabar=[0, "-3"], x="1/50"),
          instances(12, n=(2,), m=(3,), using={u: scalar()}, made_by={x: u**2 / 8 + rational("1/20")})],
      note="gamma(t) tends to zero where D is sign definite (y = 1): q is the first t at which its square length is at most x. Where it is not, the bound of X.14 keeps (b(t) - a(t))/2 away from zero.")

not_checked("BLZ94-F8.5", "the plot of an orbit", "a picture without printed numbers; what the text says of it is in X8.1a, X8.1b and X8.1c")
not_checked("BLZ94-F8.6", "an orbit from a rounded periodic point",
            "which point was rounded is not printed, and whether an orbit is dense on its manifold depends on the relations between the angles of its own D. Rational data, at least, "
            "never have the period 144: the zeros of their D have degree four at most, and as roots of unity orders up to 12")

claim("BLZ94-S66", "which points of the manifold of an interior point tend to it", ~coprime(w, Z - p), over={u: monic(1), v: monic(1), w: monic(2), s: nonzero(), r: nonzero()},
      where=[let(p, when(abs(s) < 1, s, 1 / s))],
      given=[given("w is Schur", schur(w)), given("(7.1a)", 2 * symmetric_part(u * (Z - s), v * (Z - s)) == r * w * recip(w))],
      by=[steps(*CONVERGENCE, facts=[*POWERS_TEND, "a polynomial has one factorization into linear ones"],
                prose="By Theorem 7.1 a point with coprime a and b tends to w if it does not escape. With a common zero s the limit is (z - s) times the factor of the reduced D: it is w if "
                      "s is inside, and otherwise the unstable equilibrium that has s in place of the zero 1/s of w."),
          instances(20, using={y: scalar()}, made_by={u: Z - y / (1 + y**2), v: u, w: u * (Z - p), r: when(abs(s) < 1, 2, 2 * s**2)}),
          example({u: [0, 1], v: ["4/5", 1], w: ["-1/6", "1/6", 1], s: "1/3", r: "8/5"}), example({u: [0, 1], v: ["4/5", 1], w: ["-1/6", "1/6", 1], s: 3, r: "72/5"}),
          example({u: [0, 1], v: [0, 1], w: ["-1/6", "1/6", 1], s: 3, r: 1}), example({u: [3, 1], v: [3, 1], w: [6, 5, 1], s: "-1/2", r: "1/2"})],
      note="a = u(z)(z - s), b = v(z)(z - s), w the polynomial of the interior point. The text refers to Section 6; Theorem 7.1 is meant. The points that are excepted are those with a common zero outside, the unstable equilibria "
           "and what tends to them, and those that escape.")

claim("BLZ94-S71", "in the white region there are periodic points, dense orbits and finite escape",
      (d == 3) & (q < 1) & (c < 1), over={x: scalar(), y: nonzero()},
      where=[let(e, HALF), let(al, HALF * (x + CURVE_B)), let(ga, HALF * (CURVE_B - x)), *ONE, rec(v, t, y, v[t] / (1 - w[t] ** 2)), rec(w, t, 1, -w[t] * v[t] / (1 - w[t] ** 2)),
             function(f, [k], when(alpha[k] - gamma[k] == x, k, f(k + 1))), let(d, f(1)), let(q, when(defined(v[1]), 1, 0)),
             let(c, when(nonneg_on_circle(symmetric_part(Z + al - ga, Z + al + ga)) | nonneg_on_circle(-symmetric_part(Z + al - ga, Z + al + ga))
                         | nonneg_on_circle(symmetric_part(Z + y - 1, Z + y + 1)) | nonneg_on_circle(-symmetric_part(Z + y - 1, Z + y + 1)), 1, 0))],
      given=[given("|y| < 2", abs(y) < 2)],
      by=[steps("BLZ94-X.9", "BLZ94-S63", facts=["Kronecker: the multiples of an irrational angle are dense in the circle",
                                               "the zeros of a polynomial that is not zero form a set of measure zero"],
                prose="Order one is contained in order two (S63). The curve kappa = 2 has period three; dense orbits are those of X8.B. Escape at a time t and return at a time t are each given "
                      "by equations that are not identities."),
          instances(20, using={u: nonzero()}, made_by={y: u / (1 + u**2)}), example({x: "1/3", y: 3}), example({x: "1/3", y: -3})],
      note="(alpha, gamma) is on the curve kappa = 2 and has period d; (v, w) starts with gamma = 1; c = 0 says that D is indefinite for both, q = 0 that the second escapes.")
