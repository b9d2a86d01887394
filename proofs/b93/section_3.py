# SPDX-License-Identifier: MIT
"""Iterated Lipschitz maps (section 3): what its proofs use of a metric and of Lipschitz constants.

Distances and Lipschitz constants enter as numbers. rho(phi) <= c says that the distance of two
images is at most c times that of the points, so that each estimate of the section is a chain of
such inequalities and triangle inequalities, and is shown for any numbers that satisfy them. For
compositions of n maps the estimates are proved by induction, one map at a time. The maps of a
block of p in the proof of (27) count as one map.

The remark after Theorem 3.1 speaks of the logarithm of a distance, which is not finite where the
distance is zero: a map may have x as a fixed point and move x0. What its inequality shows is that
the positive part of the logarithm stays integrable, as (C1) asks. Statements about almost sure
limits, stationarity and expectations have no exact instances and are listed with that reason.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, induction, instances, order, positivity
from exactkf.language import forall, given, nonneg, rec, scalar, sequence, symbols

n, t, k = symbols("n t k")
r1, r2, d0, d1, d2, e0, e1, e2, f, g = symbols("r1 r2 d0 d1 d2 e0 e1 e2 f g")
a, b, x, x0 = symbols("a b x x0")
D, S, rho, B, R, F = symbols("D S rho B R F")

not_checked("B93-S84", "Lipschitz constant, contraction, uniform contraction", "a definition: it fixes notation and asserts nothing")

claim("B93-E25", "Lipschitz constants of a composition",
      d2 <= r1 * r2 * d0, over={d0: nonneg(), d1: nonneg(), d2: nonneg(), r1: nonneg(), r2: nonneg()},
      given=[given("the second map", d1 <= r2 * d0), given("the first map", d2 <= r1 * d1)],
      by=[positivity([(1, 1, ["the first map"]), (1, 1, ["the second map", "r1"])]),
          instances(made_by={d1: r2 * d0, d2: r1 * r2 * d0}), instances(made_by={d1: r2 * d0 / 2, d2: r1 * r2 * d0 / 2})],
      note="d0, d1, d2 are the distances of two points, of their images under the inner map and under the composition; r1 and r2 are the constants.")

not_checked("B93-E26", "the stationary sequence of random Lipschitz maps", "a definition: it fixes notation and asserts nothing")
not_checked("B93-S85", "the Lipschitz constant as a countable supremum",
            "a continuity argument about a dense subset of a metric space, with no exact instances")
BEYOND = "an almost sure statement about stationary ergodic sequences; it has no exact instances"
for _id, _title in (
        ("T3.1", "the stationary solution and the rate of convergence to it"), ("E27", "the growth rate of the compositions"),
        ("S86", "the growth rate is constant"), ("S87", "Borel-Cantelli for the constants"), ("S89", "the ergodic theorem for blocks"),
        ("E28", "subexponential growth of the first step"), ("E29", "the stationary solution as a limit"),
        ("C3.2", "the ergodic averages of any solution"), ("E30", "averages along a solution and along the stationary one"),
        ("C3.3", "convergence in law"), ("P3.4", "solutions grow less than linearly"), ("S94", "the ergodic theorem in (31)"),
        ("E32", "the ergodic theorem for k steps"), ("S96", "dominated convergence"), ("R3.4", "independent maps")):
    not_checked(f"B93-{_id}", _title, BEYOND)

claim("B93-S88", "the constant of a composition is at most the product over blocks",
      forall(t, 0, n, rho[t] <= B[t]), sizes=["n"], over={R: sequence(0, n), rho: sequence(0, n)},
      where=[rec(B, t, rho[0], B[t] * R[t + 1])],
      given=[given("constants", forall(k, 0, n, R[k] >= 0)), given("one block more", forall(k, 1, n, rho[k] <= rho[k - 1] * R[k]))],
      by=[induction(step=order([(B[t] - rho[t]) * R[t + 1], 1 * (rho[t] * R[t + 1] - rho[t + 1])])),
          instances(n=(1, 2, 3), using={F: sequence(0, n)}, made_by={R: (k, F[k] ** 2)}),
          instances(n=(1, 2, 3), using={F: sequence(0, n)}, made_by={R: (k, F[k] ** 2), rho: (k, 0 * F[k])})],
      note="rho_t is the constant of the composition of t + 1 blocks, R_k that of the k-th; in logarithms it is the printed inequality.")

claim("B93-S90", "two successive approximations of the stationary solution",
      d1 <= r1 * d0, over={r1: nonneg(), f: nonneg(), d0: nonneg(), d1: nonneg()},
      given=[given("the maps up to k", d1 <= r1 * f), given("one map more", f <= d0)],
      by=[positivity([(1, 1, ["the maps up to k"]), (1, 1, ["one map more", "r1"])]), instances(made_by={f: d0, d1: r1 * d0}), instances(made_by={f: d0, d1: r1 * d0 / 2})],
      note="f and d0 are the distance of x to its image under the last map, d1 that of the images of both under the composition of the others.")

claim("B93-S91", "a solution approaches the stationary one",
      forall(t, 0, n, D[t] <= B[t] * d0), sizes=["n"], over={R: sequence(0, n), D: sequence(0, n), d0: nonneg()},
      where=[rec(B, t, 1, B[t] * R[t + 1])],
      given=[given("at the start", D[0] <= d0), given("constants", forall(k, 0, n, R[k] >= 0)),
             given("one map more", forall(k, 1, n, D[k] <= D[k - 1] * R[k]))],
      by=[induction(base=order([1 * (d0 - D[0])]), step=order([(B[t] * d0 - D[t]) * R[t + 1], 1 * (D[t] * R[t + 1] - D[t + 1])])),
          instances(n=(1, 2, 3), using={F: sequence(0, n), B: sequence(0, n)}, made_by={R: (k, F[k] ** 2), D: (k, 0 * F[k])})],
      note="D_t is the distance of the two solutions at time t. With S88 it is the printed inequality, in which one constant stands for the product.")

claim("B93-R3.1", "if the first step from x0 has a finite logarithm, so has that from x",
      a * x + b != x, over={a: scalar(), b: scalar(), x: scalar(), x0: scalar()},
      given=[given("the distance of x0 to its image has a finite logarithm", a * x0 + b != x0)],
      by=[example(a=0, b=0, x=0, x0=1), instances()],
      repair=repair("other", "A fixed point x of the map makes the logarithm infinite; what stays integrable is its positive part.",
                    g <= f + (r1 + 1) * d0, over={f: nonneg(), g: nonneg(), d0: nonneg(), d1: nonneg(), r1: nonneg()},
                    given=[given("triangle inequality", g <= d1 + f + d0), given("Lipschitz constant", d1 <= r1 * d0)],
                    by=[positivity([(1, 1, ["triangle inequality"]), (1, 1, ["Lipschitz constant"])]),
                        instances(made_by={d1: r1 * d0, g: r1 * d0 + f + d0}), instances(made_by={d1: r1 * d0 / 2, g: f})]),
      note="Stated for the maps x -> ax + b of the line, the same at every time: log|a x + b - x| is finite exactly where the argument is not "
           "zero. In the correction f and g are the distances of x0 and x to their images, d0 that of x and x0, d1 that of their images; the "
           "positive part of log g is then at most a constant plus the positive parts of log f and log r1.")

claim("B93-R3.1.2", "the first step from x and from x0",
      g <= f + (r1 + 1) * d0, over={f: nonneg(), g: nonneg(), e0: nonneg(), d0: nonneg(), d1: nonneg(), r1: nonneg()},
      given=[given("x, phi(x), phi(x0)", g <= d1 + e0), given("phi(x0), x0, x", e0 <= f + d0), given("Lipschitz constant", d1 <= r1 * d0)],
      by=[positivity([(1, 1, ["x, phi(x), phi(x0)"]), (1, 1, ["phi(x0), x0, x"]), (1, 1, ["Lipschitz constant"])]), instances(made_by={d1: r1 * d0, e0: f + d0, g: r1 * d0 + f + d0}),
          instances(made_by={d1: r1 * d0 / 2, e0: f + d0 / 2, g: f})],
      note="g, f, d0, d1, e0 are the distances of phi(x) to x, of phi(x0) to x0, of x to x0, of phi(x) to phi(x0), and of phi(x0) to x.")

claim("B93-S92", "one map less at the inner end",
      g <= f + r1 * e0, over={f: nonneg(), g: nonneg(), e0: nonneg(), e1: nonneg(), r1: nonneg()},
      given=[given("triangle inequality", g <= f + e1), given("Lipschitz constant", e1 <= r1 * e0)],
      by=[positivity([(1, 1, ["triangle inequality"]), (1, 1, ["Lipschitz constant"])]), instances(made_by={e1: r1 * e0, g: f + r1 * e0}), instances(made_by={e1: r1 * e0 / 2, g: f})],
      note="g and f are the distances of x to its images under all the maps and all but the first, e0 that to its image under the first, e1 that "
           "of the images of these two under the others.")

TRIANGLES = given("one map more", forall(k, 1, n, D[k] <= D[k - 1] + R[k] * F[k]))
claim("B93-E31", "the distance of x to its image under many maps",
      forall(t, 0, n, D[t] <= S[t]), sizes=["n"], over={R: sequence(0, n), F: sequence(0, n), D: sequence(0, n)},
      where=[rec(S, t, 0, S[t] + R[t + 1] * F[t + 1])],
      given=[given("no map", D[0] == 0), TRIANGLES],
      by=[induction(step=order([1 * (S[t] - D[t]), 1 * (D[t] + R[t + 1] * F[t + 1] - D[t + 1])])),
          instances(n=(1, 2, 3), made_by={D: (k, 0 * R[k]), F: (k, R[k])})],
      note="Counted from the outer end: F_k is the distance of x to its image under the k-th map, R_k the constant of the k - 1 maps outside "
           "it (one for none), D_k the distance of x to its image under the k outer maps; the hypothesis is the previous inequality.")

claim("B93-S93", "the same for contractions",
      g <= f + r1 * e0, over={f: nonneg(), g: nonneg(), e0: nonneg(), r1: nonneg(), r2: nonneg(), R: nonneg()},
      given=[given("(31)", g <= f + R * e0), given("(25)", R <= r2 * r1), given("a contraction", r2 <= 1)],
      by=[positivity([(1, 1, ["(31)"]), (1, 1, ["(25)", "e0"]), (1, 1, ["a contraction", "r1", "e0"])]),
          instances(made_by={r2: 1, R: r1, g: f + r1 * e0}), instances(made_by={r2: 0, R: 0, g: f})],
      note="For each term of the sum: R is the constant of the maps outside the i-th, r1 that of the next one, r2 that of the rest. f stands for the "
           "other terms.")

claim("B93-S95", "the same for contractions, k maps at a time",
      g <= f + r1 * e0, over={f: nonneg(), g: nonneg(), e0: nonneg(), r1: nonneg(), r2: nonneg(), R: nonneg()},
      given=[given("(31)", g <= f + R * e0), given("(25)", R <= r2 * r1), given("contractions", r2 <= 1)],
      by=[positivity([(1, 1, ["(31)"]), (1, 1, ["(25)", "e0"]), (1, 1, ["contractions", "r1", "e0"])]),
          instances(made_by={r2: 1, R: r1, g: f + r1 * e0}), instances(made_by={r2: 0, R: 0, g: f})],
      note="For each term with i up to n - k: r1 is the constant of the next k maps, r2 that of those outside them. The others stay in f.")

claim("B93-S97", "any other start",
      g <= f + d0, over={f: nonneg(), g: nonneg(), d0: nonneg(), d1: nonneg(), r1: nonneg()},
      given=[given("triangle inequality", g <= f + d1), given("Lipschitz constant", d1 <= r1 * d0), given("contractions", r1 <= 1)],
      by=[positivity([(1, 1, ["triangle inequality"]), (1, 1, ["Lipschitz constant"]), (1, 1, ["contractions", "d0"])]),
          instances(made_by={r1: 1, d1: d0, g: f + d0}), instances(made_by={r1: 0, d1: 0, g: f})])
