# SPDX-License-Identifier: MIT
"""The scalar covariance equation (Chapter III, section C.1).

With one state the equation is p+ = F(p) = phi^2 v p / (m^2 p + v) + h. For m != 0
its graph is a rectangular hyperbola: shifted to its centre it reads
(p + v/m^2)(p+ - h - phi^2 v/m^2) = -(phi v/m^2)^2. Equilibria solve
m^2 p^2 - s p - h v = 0 with s = m^2 h + v(phi^2 - 1), so they are
(s +- sqrt(s^2 + 4 m^2 h v)) / 2m^2; their product is -h v/m^2, and for h = 0 they
are 0 and v(phi^2 - 1)/m^2. For m = 0 the graph is a line of slope phi^2 and the
equilibrium is h/(1 - phi^2), if phi^2 != 1; with phi^2 = 1 there is none for h > 0
and every p is one for h = 0.

The slope of F at an equilibrium e is phi^2 v^2/(m^2 e + v)^2, never negative. A
fractional linear map is stable at e if this is below one, and unstable if it is
above one; at slope one (and m != 0) the graph touches the diagonal from below, so
orbits that start under e leave: this is the undriven random walk, h = 0 and
phi^2 = 1, with e = 0. From starting values p >= 0 everything converges, by
|F(p) - e| = phi^2 v^2 |p - e| / ((m^2 p + v)(m^2 e + v)), or in the random walk case
because 1/p grows by m^2/v at each step.

Throughout phi != 0 and v > 0, as assumed for all of section C, and h >= 0.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import combination, example, identity, induction, instances, steps
from exactkf.language import (
    always,
    eq,
    function,
    given,
    iff,
    let,
    nonneg,
    nonzero,
    positive,
    rec,
    scalar,
    standing,
    sym,
    symbols,
    when,
)

phi, m, v, h, p, q = symbols("phi m v h p q")
p0, e, r, k, x, y = symbols("p0 e r k x y")
F, e1, e2 = symbols("F e1 e2")

ANY = {phi: nonzero(), m: scalar(), v: positive(), h: nonneg()}
OBSERVABLE = {phi: nonzero(), m: nonzero(), v: positive(), h: nonneg()}


def image(value):
    """F(p)."""
    return phi**2*v*value/(m**2*value + v) + h


def raw(value):
    """The covariance equation with numbers for matrices."""
    return phi*(value - value*m*(m*value*m + v)**-1*m*value)*phi + h


GRAPH = function(F, [x], image(x))
ORBIT = rec(p, k, p0, image(p[k]))

claim("D71-E3.6", "the covariance equation for one state",
      raw(p) == phi**2*v*p/(m**2*p + v) + h,
      over={phi: scalar(), m: scalar(), v: positive(), h: nonneg(), p: scalar()},
      by=[identity(), instances()])

claim("D71-S22", "the graph is a rectangular hyperbola",
      eq(((p + v/m**2) - (F(p) - h - phi**2*v/m**2))**2 - ((p + v/m**2) + (F(p) - h - phi**2*v/m**2))**2,
         -4*(p + v/m**2)*(F(p) - h - phi**2*v/m**2),
         (2*phi*v/m**2)**2),
      over={**OBSERVABLE, p: scalar()}, where=[GRAPH],
      by=[identity(), instances()],
      note="With X = p + v/m^2 and Y = p+ - h - phi^2 v/m^2 this is (X - Y)^2 - (X + Y)^2 = (2 phi v/m^2)^2 > 0: "
           "asymptotes X = 0 and Y = 0, major axis X + Y = 0, parallel to p+ = -p.")

claim("D71-E3.7", "the equation of an unobservable process is linear",
      (F(p) == phi**2*p + h) & (F(p) - F(q) == phi**2*(p - q)),
      over={phi: nonzero(), v: positive(), h: nonneg(), p: scalar(), q: scalar()}, where=[let(m, 0), GRAPH],
      by=[identity(), instances()])

# --- motion along the graph ------------------------------------------------------------------------------------------

nxt, bp, pole, level = symbols("nxt bp pole level")
ONE = [let(nxt, image(p)), let(pole, -v/m**2), let(level, h + phi**2*v/m**2)]

claim("D71-S23", "points that stay on the lower right branch",
      always(k, p[k] > -v/m**2),
      over={**OBSERVABLE, p0: scalar()}, where=[ORBIT],
      given=[standing("on the branch", p0 > -v/m**2), given("the next point too", p[1] > -v/m**2)],
      by=[example(phi=1, m=1, v=1, h=0, p0="-2/5"), instances()],
      repair=repair(
          "other", "one more step on the branch is not enough; every later point stays there if the first one is at "
                   "or above an equilibrium",
          ((p >= e) >> (nxt >= e)) & (e > pole),
          over={**OBSERVABLE, p: scalar(), e: scalar()}, where=[GRAPH, *ONE],
          given=[given("e is an equilibrium", e == F(e)), standing("on the branch", p > pole)],
          by=[steps("D71-E3.8", prose="F(p) - e = phi^2 v^2 (p - e)/((m^2 p + v)(m^2 e + v)), and the equilibria lie "
                                      "on one side of the pole, "
                                      "as (m^2 e + v)(m^2 f + v) = phi^2 v^2, the side of the nonnegative one."),
              instances(made_by={h: e*(m**2*e + v - phi**2*v)/(m**2*e + v)})]),
      note="From p = -2/5 with phi = m = v = 1 and h = 0 the next values are -2/3 and -2, beyond -v/m^2 = -1. "
           "In the corrected form the set p >= e lies on the branch and is mapped into itself, so the orbit stays in "
           "it.")

b = sym("b")

claim("D71-S24", "points that leave the lower right branch",
      (bp == pole)
      & (nxt - pole == (phi**2*v + m**2*h + v)*(p - b)/(m**2*p + v))
      & (nxt - level == -phi**2*v**2/(m**2*(m**2*p + v))),
      over={**OBSERVABLE, p: scalar()}, where=[*ONE, let(b, -v*(m**2*h + v)/(m**2*(m**2*h + v + phi**2*v))),
                                               let(bp, image(b))],
      by=[identity(), instances()],
      note="b is the value whose successor is the pole -v/m^2. For -v/m^2 < p < b the second difference is negative: "
           "the next point has "
           "p+ below the pole, on the upper left branch. For p < -v/m^2 the third is positive: the next point is "
           "right of h + phi^2 v/m^2.")

claim("D71-S25", "direction of motion",
      always(k, p[k + 1] - p[k] == image(p[k]) - p[k]),
      over={**ANY, p0: scalar()}, where=[rec(p, k, p0, raw(p[k]))],
      by=[induction(), instances()],
      note="The orbit follows the covariance equation, F is its graph: p moves left where F(p) < p and right where "
           "F(p) > p.")

# --- equilibria ------------------------------------------------------------------------------------------------------

s = m**2*h + v*(phi**2 - 1)
ROOTS = [let(e1, (s + r)/(2*m**2)), let(e2, (s - r)/(2*m**2))]
IS_ROOT = given("r is the square root", r**2 == s**2 + 4*m**2*h*v)
#: h and r such that a freely chosen q is an equilibrium
FROM_Q = {h: q*(m**2*q + v - phi**2*v)/(m**2*q + v), r: abs(2*m**2*q - s)}

claim("D71-E3.8", "equilibria of an observable process",
      (F(p) - p)*(m**2*p + v) == -m**2*(p - e1)*(p - e2),
      over={**OBSERVABLE, r: nonneg(), p: scalar()}, where=[GRAPH, *ROOTS], given=[IS_ROOT],
      by=[combination([(1/(4*m**2), "r is the square root", -1)]), instances(made_by=FROM_Q, using={q: scalar()})],
      note="r is the square root in the formula. The identity in p says that p = F(p) exactly for p = e1 and p = e2.")

claim("D71-E3.8.1", "a driven process has one equilibrium of each sign",
      (e1 > 0) & (e2 < 0),
      over={**OBSERVABLE, r: nonneg()}, where=ROOTS, given=[given("h > 0", h > 0), IS_ROOT],
      by=[steps("D71-E3.8", prose="The product of the equilibria is -hv/m^2 < 0 and p_e1 >= p_e2."),
          instances(made_by=FROM_Q, using={q: scalar()})])

UNDRIVEN = {phi: nonzero(), m: nonzero(), v: positive()}

claim("D71-E3.8.2", "equilibria of an undriven process",
      (e1 == 0) & (e2 == v*(phi**2 - 1))
      & iff(e2 > 0, phi**2 > 1) & iff(e2 == 0, phi**2 == 1) & iff(e2 < 0, phi**2 < 1),
      over=UNDRIVEN, where=[let(h, 0), let(r, abs(v*(phi**2 - 1))), *ROOTS],
      by=[example(phi="1/2", m=2, v=1), instances()],
      repair=repair(
          "factor", "the equilibrium that is not zero is v(phi^2 - 1)/m^2; in (3.8) it has the plus sign when it is "
                    "positive, so it is then p_e1",
          ((F(p) - p)*(m**2*p + v) == -m**2*p*(p - e)) & iff(e > 0, phi**2 > 1) & iff(e < 0, phi**2 < 1),
          over={**UNDRIVEN, p: scalar()}, where=[let(h, 0), GRAPH, let(e, v*(phi**2 - 1)/m**2)],
          by=[steps("D71-E3.8", prose="With h = 0 the square root is |v(phi^2 - 1)|; the sign is that of phi^2 - 1."),
              instances()]))

claim("D71-E3.9", "equilibrium of an unobservable process",
      iff(p == phi**2*p + h, p == h*(1 - phi**2)),
      over={phi: nonzero(), h: nonneg(), p: scalar()},
      given=[given("stable or unstable", phi**2 != 1)],
      by=[example(phi="1/2", h=1, p="4/3"), instances()],
      repair=repair(
          "factor", "solving p = phi^2 p + h gives h divided by 1 - phi^2, not multiplied by it",
          phi**2*p + h - p == (phi**2 - 1)*(p - h/(1 - phi**2)),
          over={phi: nonzero(), h: nonneg(), p: scalar()},
          given=[standing("stable or unstable", phi**2 != 1)],
          by=[identity(), instances()]),
      note="The corrected statement is an identity in p: with phi^2 != 1 the only equilibrium is h/(1 - phi^2).")

claim("D71-E3.9.1", "an unobservable random walk has no equilibrium",
      p != phi**2*p + h,
      over={phi: nonzero(), h: nonneg(), p: scalar()}, given=[given("random walk", phi**2 == 1)],
      by=[example(phi=1, h=0, p=1), instances(made_by={phi: when(q > 0, 1, -1)}, using={q: scalar()})],
      repair=repair(
          "boundary case", "without noise, h = 0, every p is an equilibrium; there is none if h > 0, as each step "
                           "then adds h",
          nxt - p == h,
          over={phi: nonzero(), h: positive(), p: scalar()}, where=[let(nxt, phi**2*p + h)],
          given=[given("random walk", phi**2 == 1)],
          by=[combination([(1, "random walk", p)]), instances(made_by={phi: when(q > 0, 1, -1)}, using={q: scalar()})]))

# --- stability -------------------------------------------------------------------------------------------------------

upper = when(m == 0, h/(1 - phi**2), (s + r)/(2*m**2))
EXISTS = given("observable or stable", (m != 0) | (phi**2 < 1))
STABLE = (e >= 0) & (e == F(e)) & (phi**2*v**2 < (m**2*e + v)**2)

claim("D71-S26", "when there is a stable nonnegative equilibrium",
      STABLE,
      over={**ANY, r: nonneg()}, where=[GRAPH, let(e, upper)], given=[EXISTS, IS_ROOT],
      by=[example(phi=1, m=1, v=1, h=0, r=0), instances(made_by=FROM_Q, using={q: scalar()})],
      repair=repair(
          "boundary case", "an undriven observable random walk (h = 0, phi^2 = 1) has only the equilibrium 0, which "
                           "values below it leave",
          STABLE,
          over={**ANY, r: nonneg()}, where=[GRAPH, let(e, upper)],
          given=[EXISTS, given("not an undriven random walk", ~((h == 0) & (phi**2 == 1))), IS_ROOT],
          by=[steps("D71-E3.8", facts=["A differentiable map is stable at a fixed point where its slope is below one "
                                       "in absolute value."],
                    prose="The equilibria have product -hv/m^2 and the larger one has the smaller slope; the slopes "
                          "multiply to one."),
              example(phi=1, m=1, v=1, h=0, r=0), instances(made_by=FROM_Q, using={q: scalar()})]),
      note="e is the larger equilibrium. It is stable in the sense of section I.D exactly if the slope phi^2 v^2/(m^2 "
           "e + v)^2 of F there is "
           "below one: at slope one with m != 0 the graph lies below the diagonal, and for h = 0, phi^2 = 1 the orbit "
           "from -v/(Nm^2) "
           "runs through -v/((N-1)m^2), -v/((N-2)m^2), ... to -v/m^2, however large N.")

f, lam, RATE, CURVE, WALK, LINE, UNSTABLE = symbols("f lam RATE CURVE WALK LINE UNSTABLE")
CASES = [
    let(WALK, (h == 0) & (phi**2 == 1)), let(RATE, ~WALK), let(CURVE, (m != 0) & ~WALK),
    let(LINE, m == 0), let(UNSTABLE, (h == 0) & (phi**2 > 1)),
    let(f, s/m**2 - e), let(lam, phi**2*v**2/(m**2*e + v)**2),
]

claim("D71-S27", "convergence from nonnegative values",
      (RATE >> (lam < 1))
      & (CURVE >> ((f <= 0) & iff(f >= 0, UNSTABLE) & always(k, (p[k] - e)*(p0 - f) == lam**k*(p0 - e)*(p[k] - f))))
      & (WALK >> always(k, p[k]*(v + k*m**2*p0) == p0*v))
      & (LINE >> always(k, p[k] - e == lam**k*(p0 - e)))
      & (UNSTABLE >> (e > 0)),
      over={**ANY, e: nonneg(), p0: nonneg()},
      where=[GRAPH, ORBIT, *CASES],
      given=[standing("observable or stable", (m != 0) | (phi**2 < 1)), given("e is an equilibrium", e == F(e)),
             given("e is the stable one", phi**2*v**2 <= (m**2*e + v)**2)],
      by=[example(phi=1, m=1, v=1, h=0, e=0, p0=1), example(phi=-1, m=2, v=3, h=0, e=0, p0="1/3"),
          example(phi=1, m=1, v=1, h=0, e=0, p0=0),
          example(phi=2, m=1, v=1, h=0, e=3, p0=1), example(phi=2, m=1, v=1, h=0, e=3, p0=0),
          example(phi=2, m=1, v=1, h=0, e=3, p0=7),
          example(phi="1/2", m=1, v=1, h=0, e=0, p0=5), example(phi="1/2", m=0, v=1, h=3, e=4, p0=1),
          example(phi=-3, m=2, v=5, h=0, e=10, p0=2),
          steps("D71-E3.8", facts=["In the coordinate (p - e)/(p - f) a fractional linear map with fixed points e and "
                                   "f is a multiplication."],
                prose="The multiplier is the slope at e; the touching case and the line are summed directly."),
          instances(made_by={h: e*(m**2*e + v - phi**2*v)/(m**2*e + v)}),
          instances(made_by={h: 0, e: when(phi**2 > 1, v*(phi**2 - 1)/m**2, 0)})],
      note="The orbit is given in closed form. In general (p_k - e)/(p_k - f) = lam^k (p_0 - e)/(p_0 - f) with the "
           "other equilibrium f and "
           "lam < 1, so p_k tends to e unless p_0 = f; as f <= 0, for p_0 >= 0 that is p_0 = 0 in the undriven "
           "unstable case, where the equation keeps p_k = 0. "
           "For the undriven random walk p_k = p_0 v/(v + k m^2 p_0), for m = 0 the error is multiplied by phi^2 < 1.")

DOWN, UP, UP_LINE = symbols("DOWN UP UP_LINE")

claim("D71-S28", "what happens to a slightly negative value",
      (DOWN >> (nxt < p)) & (UP >> (nxt > p)) & (UP_LINE >> (nxt > p)),
      over={**ANY, e: scalar(), p: scalar()},
      where=[GRAPH, let(nxt, image(p)),
             let(DOWN, (m != 0) & (h == 0) & (phi**2 >= 1) & (-v < m**2*p) & (p < 0)),
             let(UP, (m != 0) & (e == F(e)) & (e < p) & (p < 0)),
             let(UP_LINE, (m == 0) & (phi**2 < 1) & (p < 0))],
      by=[example(phi=1, m=1, v=1, h=0, e=0, p="-1/2"), example(phi=2, m=1, v=3, h=0, e=9, p=-1),
          example(phi=-1, m=3, v=2, h=0, e=0, p="-1/9"),
          example(phi="1/2", m=0, v=1, h=0, e=0, p=-1), example(phi="2/3", m=0, v=1, h=2, e=0, p="-1/5"),
          steps("D71-E3.8", prose="F(p) - p = -m^2 (p - e)(p - f)/(m^2 p + v) with the two equilibria e and f."),
          instances(),
          instances(made_by={h: e*(m**2*e + v - phi**2*v)/(m**2*e + v), p: e/(1 + q)}, using={q: positive()})],
      note="Slightly negative means above the pole -v/m^2 or, where the value is to return, above the negative "
           "equilibrium e, which exists "
           "exactly if h > 0 or phi^2 < 1. The first part is read for observable processes: what follows it "
           "speaks of the other cases with a stable nonnegative equilibrium. With m = 0, h = 0 and phi^2 = 1 the value "
           "would not move at all.")
