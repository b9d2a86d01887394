# SPDX-License-Identifier: MIT
"""Section III, (3.10)-(3.14): the phase plane for n = 1, its hyperbolas, Remark 3.6.

For n = 1 the algorithm is the map (alpha, gamma) -> (alpha, -gamma alpha)/(1 - gamma^2) of
the plane. On the circle D is 1 + alpha^2 - gamma^2 + 2 alpha cos(theta), with extreme values (1 -+
|alpha|)^2 - gamma^2. So D >= 0 on the diamond I (|alpha| + |gamma| <= 1) and on
III, IV (|alpha| >= 1 + |gamma|, with |gamma| > 1 and |gamma| <= 1), D <= 0 on II
(|gamma| >= 1 + |alpha|), and it changes sign on the corridors that remain.

The invariant has two coefficients, and their quotient gives 1 + alpha^2 - gamma^2
= (2/kappa) alpha along an orbit with alpha_0 not 0: a hyperbola, in the sign definite regions for kappa^2 < 1 and in the
corridors for kappa^2 > 1, apart from the points (0, 1), (0, -1) where all these
curves meet and D is zero. It carries the fixed points (alpha_+, 0), (alpha_-, 0), the roots of alpha^2 - (2/kappa) alpha + 1.

A point is also a function v = (z + b)/(2(z + a)), a = alpha - gamma, b = alpha +
gamma; v(z) + v(1/z) = D/((z + a)(1/z + a)), and D has the two factorizations
(alpha_0/alpha_+)(z + alpha_+)(1/z + alpha_+) and the same with alpha_-. Points of the
diamond are the positive real v, points of III and IV those with v(1/z) positive real.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import (
    angles,
    arithmetic,
    at_index,
    by_cases,
    by_induction,
    cleared,
    combination,
    evaluation,
    example,
    identity,
    induction,
    instances,
    multiplied,
    shown_first,
    steps,
    valued,
)
from exactkf.language import *
from proofs.blm91.lemmas_limits import CONVERGES, CONVERGES_BY, LIMIT_WORDS
from proofs.blm91.notation import *

kap, vz, b, x, y, D0, Dm, ah, gh, bal, bga, numv, now = symbols("kappa v b x y D D_m alpha_hat gamma_hat alpha_back gamma_back N now")
PLANE = {al0: scalar(), ga0: scalar()}
eps, na, ng = symbols("ratio alpha_next gamma_next")


RT = rec(r, t, 1, (1 - ga[t] ** 2) * r[t])


def d_of(alpha, gamma):
    """D of a point, as a pseudo-polynomial."""
    return 1 + alpha**2 - gamma**2 + alpha * (Z + recip(Z))


one_, two_, three_ = abs(al0) + abs(ga0) <= 1, abs(ga0) >= 1 + abs(al0), abs(al0) >= 1 + abs(ga0)
CROSSES = [example(alpha0=0, gamma0=1), example(alpha0=0, gamma0=-1), example(alpha0="1/2", gamma0="1/2"), example(alpha0=3, gamma0=2),
           example(alpha0=-1, gamma0=2), example(alpha0=1, gamma0=0), example(alpha0="3/2", gamma0=1), example(alpha0=1, gamma0="-1/2")]

# ---------------------------------------------------------------------- the map
claim("BLM91-E3.10", "the algorithm for n = 1",
      always(t, (al[t] == q[t][1]) & (ga1[t] == qs[t][1])),
      over={a: vector(1), g: vector(1)}, where=[let(n, 1), *stripped(a, g), *scalar_orbit(a[1], g[1], ga1)], by=[induction(), instances()],
      note="The system is (2.25); the print refers to it as (3.25), a number that no display has.")
claim("BLM91-E3.11", "the invariant for n = 1",
      always(t, r[t] * ((Z + al[t]) * (recip(Z) + al[t]) - ga[t] ** 2) == (Z + al0) * (recip(Z) + al0) - ga0**2), over=PLANE, where=[*ORBIT, RT],
      by=[induction(), instances()])
claim("BLM91-E3.12", "the invariant on the circle",
      (Z + al0) * (recip(Z) + al0) - ga0**2 == 1 + al0**2 - ga0**2 + al0 * (Z + recip(Z)), over=PLANE, by=[identity(), instances()],
      note="z + 1/z is 2 cos(theta); the left side is D at t = 0.")

# ---------------------------------------------------------------------- regions
claim("BLM91-F2.1", "sign of the invariant in the regions of the plane",
      iff(nonneg_on_circle(D0), one_ | three_) & iff(nonneg_on_circle(-D0), two_), over=PLANE, where=[let(D0, d_of(al0, ga0))],
      by=[arithmetic(), instances(80), *CROSSES],
      note="Nonnegative exactly on I, III, IV, nonpositive exactly on II, hence of both signs in the corridors. III and IV together are |alpha| >= 1 + |gamma|.")
kfun = function(kap, [t], 2 * al[t] / (1 + al[t] ** 2 - ga[t] ** 2))
REGION = function(D0, [t], d_of(al[t], ga[t]))
claim("BLM91-F2.2", "orbits stay in the regions of their sign",
      (now > 0) & (nonneg_on_circle(Dm) | nonneg_on_circle(-Dm)), sizes=["m"], over=PLANE,
      where=[*ORBIT, kfun, REGION, let(now, kap(0) * kap(m)), let(Dm, D0(m))],
      given=[given("in a region", nonneg_on_circle(D0(0)) | nonneg_on_circle(-D0(0))), standing("marked + or -", al0 != 0)],
      by=[arithmetic(valued(), cleared(), STAYS, *values_at(0), at_index(i, m)),
          instances(60, m=(1, 2, 3)), example(m=3, alpha0=3, gamma0="3/2"), example(m=2, alpha0="1/4", gamma0=2), example(m=2, alpha0=-3, gamma0="1/2")],
      note="The index of a point is the sign of kappa = 2 alpha/(1 + alpha^2 - gamma^2); m is the time.")

# ---------------------------------------------------------------------- hyperbolas
claim("BLM91-E3.13", "the invariant hyperbola through a point",
      always(t, (1 + al[t] ** 2 - ga[t] ** 2) / al[t] == (1 + al0**2 - ga0**2) / al0), over={al0: nonzero(), ga0: scalar()}, where=ORBIT,
      by=[induction(), instances()], note="Either side is 2/kappa, zero for kappa infinite.")
ON = given("on the hyperbola", 1 + al0**2 - ga0**2 == 2 / kap * al0)
#: kappa from the point
FROM_POINT = dict(made_by={kap: 2 * al0 / (1 + al0**2 - ga0**2)})
claim("BLM91-S33", "a hyperbola is invariant",
      always(t, 1 + al[t] ** 2 - ga[t] ** 2 == 2 / kap * al[t]), over={al0: nonzero(), ga0: scalar()}, where=[let(kap, 2 * al0 / (1 + al0**2 - ga0**2)), *ORBIT],
      by=[induction(cofactors=[[(1 / (1 - ga[t] ** 2), 0, 1)]]), instances(40)],
      note="The hyperbola is told by one of its points. alpha_0 = 0 leaves (0, 1) and (0, -1), which have no next point.")
HYP = {al0: scalar(), ga0: scalar(), kap: nonzero()}
SIGNDEF = nonneg_on_circle(D0) | nonneg_on_circle(-D0)
BORDER = (abs(ga0) == abs(1 - abs(al0))) | (abs(ga0) == 1 + abs(al0))
SAYS34 = iff(kap**2 > 1, ~(SIGNDEF)) & iff(kap**2 == 1, BORDER)
MORE = [example(alpha0="1/2", gamma0="1/2", kappa=1), example(alpha0=3, gamma0=2, kappa=1), example(alpha0=-3, gamma0=2, kappa=-1), example(alpha0=-1, gamma0=2, kappa=1),
        example(alpha0=1, gamma0=1, kappa=2), example(alpha0="1/2", gamma0=0, kappa="4/5"), example(alpha0=2, gamma0=0, kappa="4/5")]
CROSSING = "alpha not 0, as (3.13) is derived. The two points (0, 1) and (0, -1), which the text treats apart, satisfy the equation of every hyperbola; D is zero there, so that they are on the boundary of all regions."
claim("BLM91-S34", "hyperbolas and regions", SAYS34, over={**HYP, al0: nonzero()}, where=[let(D0, d_of(al0, ga0))], given=[ON],
      by=[arithmetic(valued("on the hyperbola"), valued(), cleared(), by_cases(kap <= 1), by_cases(kap >= -1), by_cases(kap == 1), by_cases(kap == -1)),
          instances(60, **FROM_POINT), *MORE],
      note="kappa^2 < 1 in the sign definite regions, kappa^2 > 1 in the corridors (where D has both signs), kappa^2 = 1 on the lines |gamma| = |1 - |alpha||, |gamma| = 1 + |alpha|. " + CROSSING)
PAIR = dict(where=[let(kap, when(x == 0, rational("1/2"), 2)), let(D0, d_of(al0, ga0))], given=[ON])
DRAWN = {al0: (2 / kap + 2 * y) / (1 - y**2), ga0: 1 + y * (2 / kap + 2 * y) / (1 - y**2)}
claim("BLM91-F3", "the hyperbolas for kappa = 1/2 and kappa = 2", iff(SIGNDEF, x == 0), over={al0: nonzero(), ga0: scalar(), x: integer(0, 1)}, **PAIR,
      by=[arithmetic(valued("on the hyperbola"), cleared()),
          instances(60, using={y: scalar()}, made_by=DRAWN)],
      note="x = 0 stands for kappa = 1/2, where D has one sign on the circle, and x = 1 for kappa = 2, where it has both: "
           "the sign definite regions and the corridors. " + CROSSING)
claim("BLM91-S35", "the map commutes with gamma -> -gamma",
      always(t, (al[t] == bal[t]) & (ga[t] == -bga[t])), over=PLANE,
      where=[*ORBIT, rec(bal, t, al0, bal[t] / (1 - bga[t] ** 2)), rec(bga, t, -ga0, -bga[t] * bal[t] / (1 - bga[t] ** 2))],
      by=[induction(), instances()])
NIL = scalar_orbit(0, ga0)
claim("BLM91-S36", "alpha_0 = 0 leads to the origin in one step",
      vstack(al[1], ga[1]) == Zero(2, 1), over={ga0: scalar()}, where=NIL, by=[identity(), instances()],
      note="|gamma_0| = 1 is excluded by the denominator. kappa = 2 alpha_0/(1 - gamma_0^2) is zero there.")
claim("BLM91-S37", "alpha_0 = 0 and |gamma_0| = 1: the orbit ends",
      ~defined(al[1]) & ~defined(ga[1]), over={ga0: integer(-1, 1)}, where=NIL, given=[given("|gamma_0| = 1", abs(ga0) == 1)],
      by=[evaluation(), instances()],
      note="Finite escape is read as: the next point is not defined, 1 - gamma_0^2 being zero. The numerators vanish as well: the quotients are 0/0, not infinite.")

# ---------------------------------------------------------------------- convergence in the sign definite regions
ROOT = given("p on the hyperbola", pp * (1 + al0**2 - ga0**2) == (1 + pp**2) * al0)
MOVE = (al[m] - pp) * (pp * al0 - 1) == pp ** (2 * m) * (al0 - pp) * (pp * al[m] - 1)
LINES = {al0: (pp * y**2 - 1 / pp) / (y**2 - 1), ga0: y * (pp - 1 / pp) / (y**2 - 1)}
claim("BLM91-S38", "sign definiteness is sufficient for convergence", CONVERGES, over={al0: scalar(), ga0: scalar(), pp: nonzero()}, where=[*ORBIT, *LIMIT_WORDS], given=[ROOT, standing("0 < |p| <= 1", abs(pp) <= 1)],
      by=[*CONVERGES_BY, instances(40, using={u: nonzero(), y: scalar()}, made_by={pp: SHARE, **LINES}), instances(20, using={y: nonzero()}, made_by={pp: y / abs(y), al0: y + y / abs(y), ga0: y}),
          *(example(alpha0=a_, gamma0=g_, p=p_) for a_, g_, p_ in (("1/2", "1/2", 1), ("-1/2", "1/2", -1), (4, 3, 1), (-4, -3, -1), (1, 0, 1), (3, 0, "1/3"), ("1/3", 0, "1/3")))],
      note="For alpha_0 not 0, D is sign definite exactly when kappa^2 <= 1 (S34), that is when p(1 + alpha_0^2 - gamma_0^2) = (1 + p^2) alpha_0 has a real root p; let |p| <= 1. R_t is p^(2t). For |p| < 1 alpha_t - p falls as R_t, from where this is small enough; "
           "for |p| = 1 it is 2/t at most, for t >= 2/|alpha_0 - p|; gamma_t^2 = (alpha_t - p)(alpha_t - 1/p); and from 1/p alpha_t does not move. All this for as long as the orbit has not ended. "
           "For alpha_0 = 0 see S36. Necessity is Theorem 3.3, 1), for which the print names Theorem 3.2, 1).")

# ---------------------------------------------------------------------- Remark 3.6
VA = (let(a, al0 - ga0), let(b, al0 + ga0), let(vz, rational("1/2") * (Z + b) / (Z + a)), let(D0, d_of(al0, ga0)))
dia, quad, far = symbols("size quadratic bound")
IN = given("diamond", abs(al0) + abs(ga0) < 1)
claim("BLM91-R3.6.1", "points of the diamond are the positive real functions",
      iff(abs(al0) + abs(ga0) < 1, schur(az) & pos_on_circle(numv)), over=PLANE,
      where=[*VA, let(az, Z + a), let(numv, rational("1/2") * ((Z + b) * recip(az) + recip(Z + b) * az))],
      by=[arithmetic(multiplied(al0), *(by_cases(e_ > 0) for e_ in (1 - al0 + ga0, 1 - al0 - ga0, 1 + al0 + ga0, 1 + al0 - ga0))), instances(80), *CROSSES,
          example(alpha0=3, gamma0="1/2"), example(alpha0=-2, gamma0=0)],
      note="v is positive real when |a| < 1 and v(z) + v(1/z) > 0 on the circle, the latter written with the factor |z + a|^2.")
NORM = 1 + al0**2 - ga0**2
#: kappa^2 < 1 in the diamond, and the square root of 1 - kappa^2
IN_DIAMOND = shown_first(kap**2 < 1, [cleared(), by_cases((1 - abs(al0)) ** 2 > ga0**2), by_cases(NORM > 2 * abs(al0)), by_cases(NORM > 0)])
BY_ROOT = [valued(), IN_DIAMOND, shown_first(kap * NORM == 2 * al0, [cleared(), by_cases(NORM > 0)]), angles("root", 1 - kap**2), by_cases(kap == 0), by_cases(1 - kap**2 > 0), multiplied(kap), cleared()]
claim("BLM91-R3.6.2", "the hyperbola of a point of the diamond carries two fixed points",
      (kap**2 < 1) & (x != y) & (1 + x**2 == 2 / kap * x) & (1 + y**2 == 2 / kap * y), over={al0: nonzero(), ga0: scalar()},
      where=[let(kap, 2 * al0 / NORM), let(x, (1 - sqrt(1 - kap**2)) / kap), let(y, (1 + sqrt(1 - kap**2)) / kap)], given=[IN],
      by=[arithmetic(valued(), IN_DIAMOND, member=0), *(arithmetic(*BY_ROOT, member=k_) for k_ in (1, 2, 3)), instances(40, **INSIDE), example(alpha0="4/5", gamma0=0), example(alpha0=1, gamma0=0), example(alpha0=2, gamma0=0)],
      note="x = alpha_+, y = alpha_-; (alpha, 0) is a fixed point of (3.10) for every alpha, and on the hyperbola when 1 + alpha^2 = (2/kappa) alpha. On the instances the square root is rational.")
BACKWARD = (rec(bal, t, al0, (bal[t] ** 2 - bga[t] ** 2) / bal[t]), rec(bga, t, ga0, -bga[t] / bal[t]))
BACK = pp ** (2 * m) * (bal[m] - pp) * (pp * al0 - 1) == (al0 - pp) * (pp * bal[m] - 1)
BOTH = dict(sizes=["m"], over={al0: nonzero(), ga0: scalar(), pp: nonzero()}, where=[*ORBIT, *BACKWARD])
claim("BLM91-R3.6.3", "forward and backward limits in the diamond", defined(bal[m]) & MOVE & BACK, **BOTH,
      given=[IN, ROOT, standing("smaller root", abs(pp) < 1)],
      by=[example(m=2, alpha0="2/5", gamma0="2/5", p="1/2"), instances(m=(1, 2), **INSIDE)],
      repair=repair("missing hypothesis", "the backward orbit need not exist: (2/5, 2/5) has no preimage, the inverse formulas leading to (0, -1), where the map is not defined; "
                    "and (alpha_+, 0) is its own backward orbit; for all others the limits are right", MOVE & (pp ** (2 * m) * (pp * al0 - 1) / (al0 - pp) == (pp * bal[m] - 1) / (bal[m] - pp)), **BOTH, given=[ROOT],
                    by=[steps("BLM91-E5.1", facts=["p^(2m) tends to 0 for |p| < 1"], prose="the quotient (alpha - p)/(p alpha - 1) is multiplied by p^2 at each step and divided by it at each step back"),
                        instances(60, m=(0, 1, 2, 3), using={y: scalar()}, made_by=LINES)]),
      note="p = alpha_+ and 1/p = alpha_-, |p| < 1. The backward step is alpha - gamma^2/alpha, -gamma/alpha. The equations are the limits: alpha_t - p is p^(2t) times "
           "a bounded factor, and so is p alpha_(-t) - 1. m is the time.")
claim("BLM91-R3.6.4", "r_t along an orbit", always(t, r[t] == al0 / al[t]), over={al0: nonzero(), ga0: scalar()}, where=[*ORBIT, RT],
      by=[induction(), instances()])
FACTORS = dict(over={al0: scalar(), ga0: scalar(), pp: nonzero()}, given=[ROOT])
ROOTS = instances(40, using={y: scalar()}, made_by=LINES)
claim("BLM91-R3.6.5", "two factorizations of the invariant",
      (D0 == al0 / pp * (Z + pp) * (recip(Z) + pp)) & (D0 == al0 / (1 / pp) * (Z + 1 / pp) * (recip(Z) + 1 / pp)), **FACTORS, where=VA,
      by=[combination([[(1 / pp, "p on the hyperbola", 1)], [(1 / pp, "p on the hyperbola", 1)]]), ROOTS],
      note="p = alpha_+ and 1/p = alpha_-, the roots of kappa alpha^2 - 2 alpha + kappa = 0.")
claim("BLM91-E3.14a", "the spectral density by alpha_+",
      vz + recip(vz) == al0 / pp * (Z + pp) * (recip(Z) + pp) / ((Z + a) * (recip(Z) + a)), **FACTORS, where=VA,
      by=[combination([(1 / (pp * (Z + a) * (recip(Z) + a)), "p on the hyperbola", 1)]), ROOTS], note="p = alpha_+.")
claim("BLM91-E3.14b", "the spectral density by alpha_-, and two stable spectral factors",
      (vz + recip(vz) == al0 / (1 / pp) * (Z + 1 / pp) * (recip(Z) + 1 / pp) / ((Z + a) * (recip(Z) + a))) & schur(az) & (eps > 0),
      over={al0: nonzero(), ga0: scalar(), pp: nonzero()}, where=[*VA, let(az, Z + a), let(eps, al0 / pp)], given=[ROOT, IN],
      by=[arithmetic(valued(), valued("p on the hyperbola"), cleared(), multiplied((al0 - ga0) ** 2), by_cases(1 + al0**2 - ga0**2 > 0), by_cases(pp**2 > 0)),
          instances(40, **INSIDE)],
      note="p = alpha_+, 1/p = alpha_-. Stable: z + a is a Schur polynomial; the factors are real because alpha_0/alpha_+ > 0, hence alpha_0/alpha_- > 0.")
# a point (x, y) and its image
IMAGE = (*NIL, let(al0, 0), let(D0, d_of(al0, ga0)), let(na, x / (1 - y**2)), let(ng, -x * y / (1 - y**2)))
HIT = (na == 0) & (ng == ga0)
NIL_SAYS = (al[1] == 0) & (ga[1] == 0) & (D0 == 1 - ga0**2)
claim("BLM91-R3.6.6", "alpha_0 = 0: one spectral factor", NIL_SAYS & ~HIT, over={ga0: nonzero(), x: scalar(), y: scalar()}, where=IMAGE,
      by=[arithmetic(*FIRST_STEP),
          instances(), example(gamma0="1/2", x=0, y="1/3"), example(gamma0=2, x=1, y=0), example(gamma0="-2/3", x=1, y="1/2"), example(gamma0="1/2", x="3/4", y="-1/2")],
      note="Escape in backward time: no point (x, y) is mapped to (0, gamma_0). gamma_0 not 0, because the orbit comes to (0, 0) in one step: the origin itself is at rest, the image of every (0, y), and does not escape.")
denb = sym("den")
claim("BLM91-R3.6.7", "points of III, IV and II by v(1/z)",
      iff(abs(al0) > 1 + abs(ga0), pos_on_circle(D0) & (inside_roots(denb) == 1)) & iff(abs(ga0) > 1 + abs(al0), pos_on_circle(-D0) & (inside_roots(denb) == 1)),
      over=PLANE, where=[*VA, let(denb, 1 + a * Z)],
      by=[arithmetic(),
          instances(80), *CROSSES, example(alpha0="3/2", gamma0="-1/2"), example(alpha0="1/2", gamma0="-3/2"), example(alpha0="1/4", gamma0="1/4"), example(alpha0=3, gamma0=1)],
      note="Interiors of the regions. v(1/z) = (1 + bz)/(2(1 + az)) is positive real when its pole -1/a is in the disc and D > 0, negative real when D < 0; as in (2.4) the pole "
           "counts even where it cancels (gamma_0 = 0).")
ADJ = (*VA, let(ah, al0 / (a * b)))
OUT = standing("III or IV", abs(al0) > 1 + abs(ga0))
SAME = recip(vz) == b / a * (rational("1/2") * (Z + (ah + gh)) / (Z + (ah - gh)))
claim("BLM91-R3.6.8", "the point of the diamond that represents v(1/z)", SAME, over=PLANE, where=[*ADJ, let(gh, ga0 / (a * b))], given=[OUT],
      by=[example(alpha0=3, gamma0=1), instances()],
      repair=repair("sign", "with gamma/(ab) the pole of the represented function is -1/b and the zero -1/a, the wrong way round; the second coordinate is -gamma/(ab)",
                    SAME, over=PLANE, where=[*ADJ, let(gh, -ga0 / (a * b))], given=[OUT], by=[identity(), instances(40, using={x: nonzero(), y: scalar()}, made_by={ga0: y, al0: x + x / abs(x) * (1 + abs(y))})]),
      note="v(1/z) has the pole -1/a and the zero -1/b; represented by a point as in the first part of the remark, up to the constant b/a.")
claim("BLM91-R3.6.9", "that point is in the diamond and on the same hyperbola",
      (dia < 1) & ((1 + ah**2 - gh**2) / ah == (1 + al0**2 - ga0**2) / al0), over=PLANE,
      where=[*ADJ, let(gh, ga0 / (a * b)), let(dia, abs(ah) + abs(gh))], given=[given("III or IV", abs(al0) > 1 + abs(ga0))],
      by=[arithmetic(valued(), cleared()),
          instances(40, using={x: nonzero(), y: scalar()}, made_by={ga0: y, al0: x + x / abs(x) * (1 + abs(y))})])
claim("BLM91-R3.6.10", "ab >= 1 in III and IV", (a * b == al0**2 - ga0**2) & (far >= 1), over=PLANE, where=[*VA, let(far, a * b)],
      given=[given("III or IV", abs(al0) >= 1 + abs(ga0))], by=[arithmetic(),
          instances(40, using={x: nonneg(), y: scalar()}, made_by={ga0: y, al0: x + 1 + abs(y)}), *CROSSES[3:4]])
claim("BLM91-R3.6.11", "the spectral density in III and IV, and antistable factors",
      (vz + recip(vz) == al0 / pp * (Z + pp) * (recip(Z) + pp) / ((Z + a) * (recip(Z) + a)))
      & (vz + recip(vz) == al0 / (1 / pp) * (Z + 1 / pp) * (recip(Z) + 1 / pp) / ((Z + a) * (recip(Z) + a))) & (far > 1),
      over={al0: nonzero(), ga0: scalar(), pp: nonzero()}, where=[*VA, let(far, abs(a))], given=[ROOT, given("III or IV", abs(al0) > 1 + abs(ga0))],
      by=[arithmetic(valued(), valued("p on the hyperbola"), cleared(), multiplied((al0 - ga0) ** 2)),
          instances(40, using={y: scalar(), u: nonzero()}, made_by={
              pp: u / (1 + abs(u)), al0: (pp * (y / (1 + abs(y)) * pp) ** 2 - 1 / pp) / ((y / (1 + abs(y)) * pp) ** 2 - 1),
              ga0: (y / (1 + abs(y)) * pp) * (pp - 1 / pp) / ((y / (1 + abs(y)) * pp) ** 2 - 1)})],
      note="Interiors. p = alpha_+, 1/p = alpha_-; antistable: |a| > 1.")
claim("BLM91-R3.6.12", "region II is visited at most once",
      (dia <= 1) & (far > 0), sizes=["m"], over={al0: nonzero(), ga0: scalar()},
      where=[*ORBIT, let(dia, abs(al[m + 1]) + abs(ga[m + 1])), let(far, 1 + abs(al[m + 1]) - abs(ga[m + 1]))],
      given=[given("in II", abs(ga0) >= 1 + abs(al0))],
      by=[arithmetic(valued(), cleared(), by_induction(
          j, 0, defined(al[j + 1]) >> ((abs(al[j + 1]) + abs(ga[j + 1]) <= 1) & (abs(ga[j + 1]) < 1 + abs(al[j + 1])) & (al[j + 1] != 0)),
          base=[cleared(), *values_at(1), *values_at(0)], step=[cleared(), *values_at(j + 2)]), at_index(j, m)),
          instances(40, m=(0, 1, 2), using={x: nonneg(), y: nonzero()}, made_by={al0: y, ga0: 1 + abs(y) + x})],
      note="From a point of II (with alpha_0 not 0, as kappa is not 0) every later point is in I and none in II; m + 1 is the time.")
