# SPDX-License-Identifier: MIT
"""Iterated Lipschitz maps (section 3, the inequalities between distances).

The theorems of the section are about almost every sequence of random maps. What they rest on
are inequalities for one sequence of maps of a metric space, each from the triangle inequality
and Lipschitz constants. They are stated here for the distances that occur: d1 <= r d2 says that
two points at the distance d2 are taken to points at the distance d1.

If e_j is the distance of x from its image under the last j maps, the map before these changes
it by at most rho_j f_j, where f_j is how far that map moves x and rho_j a Lipschitz constant of
the composition of the j maps; so e_n is at most the sum of the rho_j f_j. For contractions rho_j
is at most the constant of any one of the j maps, and of any composition of some that follow
each other.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, induction, instances, order, positivity, restated, steps
from exactkf.language import (
    Zero,
    always,
    forall,
    function,
    given,
    let,
    matrix,
    nonneg,
    positive_semidefinite,
    prod,
    psd,
    rec,
    scalar,
    sequence,
    signal_of,
    standing,
    sum_of,
    symbols,
    when,
)

r, s, d, d1, d2, d3, dxu, dxv, dvu, dxw, k, n, m, i, j = symbols("r s d d1 d2 d3 dxu dxv dvu dxw k n m i j")
STATISTICAL = "a statement about almost every sequence of a stationary ergodic process, beyond exact instances"
DEFINITION = "a definition: it fixes notation and asserts nothing"

not_checked("B93-S84", "Lipschitz maps and contractions", DEFINITION)

claim("B93-E25", "the constant of a composition",
      d1 <= r*s*d3, over={d1: nonneg(), d2: nonneg(), d3: nonneg(), r: nonneg(), s: nonneg()},
      given=[given("the outer map", d1 <= r*d2), given("the inner map", d2 <= s*d3)],
      by=[positivity([(1, 1, ["the outer map"]), (1, 1, ["r", "the inner map"])]), instances(made_by={d2: s*d3, d1: r*s*d3}), instances(),
          restated("the constant of a map is the least r with d(f(x), f(y)) <= r d(x, y)")],
      note="Two points have the distance d3, their images d2, and the images of these d1. As it holds for all pairs of points, rho of the composition, the "
           "least constant, is at most the product.")

not_checked("B93-E26", "the iteration", DEFINITION)
not_checked("B93-S85", "the supremum over a countable dense set", "a supremum over a dense set of a metric space, and measurability")
not_checked("B93-T3.1", "the stationary solution attracts all others", STATISTICAL)
not_checked("B93-E27", "the rate of the backward compositions", STATISTICAL)
not_checked("B93-S86", "the rate is a constant", STATISTICAL)
not_checked("B93-S87", "tails of an integrable variable", STATISTICAL)

#: numbers are written as matrices of order d, d = 1, in what is shown by induction, and what an inequality leaves over is a variable s
ANY, LEFT = signal_of(matrix(d, d), 0), signal_of(positive_semidefinite(d), 0)
t, b, Sum, rest = symbols("t b Sum rest")
NONE = Zero(d, d)
AS_MATRICES = "Numbers are 1 x 1 matrices here, and nothing changes for matrices. "

claim("B93-S88", "the composition in blocks of p maps",
      always(k, psd(Sum[k] + rest - (t[k] + rest))), sizes=["d"], over={b: ANY, s: LEFT, rest: matrix(d, d)},
      where=[rec(Sum, k, NONE, Sum[k] + b[k]), rec(t, k, NONE, t[k] + b[k] - s[k])],
      by=[induction(base=order([NONE]), step=order([Sum[k] + rest - (t[k] + rest), s[k]])), instances(8, d=(1, 2)),
          restated("(25), and the logarithm of a product")],
      note=AS_MATRICES + "b_i is the logarithm of the constant of the block i of p maps and t_k that of the first k blocks together, which by (25) grows by "
                         "at most b_k with one block more: s_k is what is left over. The maps after the last whole block add at most their own, the rest.")

not_checked("B93-S89", "the rate is at most alpha", STATISTICAL)
not_checked("B93-E28", "how far the maps move a point", STATISTICAL)

# --- maps of the plane -----------------------------------------------------------------------------------------------------

a, b, c, g, x, y, x0, y0, X1, X2, Y1, Y2, Psi, xn, yn, K = symbols("a b c g x y x0 y0 X1 X2 Y1 Y2 Psi xn yn K")
PLANE = {name: sequence(1, n) for name in (a, b, c, g)}
POINT, OTHER = {x: scalar(), y: scalar()}, {x0: scalar(), y0: scalar()}


u, v, lo, hi = symbols("u v lo hi")
Max, Rho, Move, Before, After, Total, Last, First = symbols("Max Rho Move Before After Total Last First")
LARGER = function(Max, [u, v], when(u > v, u, v))
#: rho(phi_hi o ... o phi_lo), and how far phi_i moves the point (x, y)
CONSTANT = function(Rho, [hi, lo], Max(prod(j, lo, hi, abs(a[j])), prod(j, lo, hi, abs(c[j]))))
MOVE = function(Move, [i], Max(abs(a[i]*x + b[i] - x), abs(c[i]*y + g[i] - y)))
METRIC = [LARGER, CONSTANT, MOVE]


def distance(p1, q1, p2, q2):
    """In the maximum norm."""
    return Max(abs(p1 - p2), abs(q1 - q2))


def orbit(first, second, start, other):
    """The point (start, other) under phi_1, phi_2, ..."""
    return (rec(first, k, start, a[k + 1]*first[k] + b[k + 1]), rec(second, k, other, c[k + 1]*second[k] + g[k + 1]))


IN_THE_PLANE = ("Max is the larger of two numbers. For the maps phi_i(x, y) = (a_i x + b_i, c_i y + g_i) of the plane with the maximum norm, for which rho "
                "of a composition is the larger of the products of the |a_i| and of the |c_i|. ")
HERE = orbit(X1, X2, x, y)
THERE = orbit(Y1, Y2, x0, y0)
CONTRACTIONS = given("contractions", forall(i, 1, n, (abs(a[i]) <= 1) & (abs(c[i]) <= 1)))
U, W = symbols("U W")
SMALL = {"using": {U: sequence(1, n), W: sequence(1, n)}, "made_by": {a: (i, U[i]/(1 + abs(U[i]))), c: (i, W[i]/(1 + abs(W[i])))}}

claim("B93-S90", "one map more at the beginning",
      After <= Rho(n, 2)*Move(1),
      sizes=["n"], over={**PLANE, **POINT},
      where=[*METRIC, rec(X1, k, x, a[k + 2]*X1[k] + b[k + 2]), rec(X2, k, y, c[k + 2]*X2[k] + g[k + 2]), *orbit(Y1, Y2, x, y),
             let(After, distance(X1[n - 1], X2[n - 1], Y1[n], Y2[n]))],
      by=[instances(n=(2, 3, 4))],
      note=IN_THE_PLANE + "phi_n, ..., phi_1 stand for phi_0, ..., phi_{-k-1}. That the sequence is almost surely a Cauchy sequence is not stated here.")

not_checked("B93-E29", "the stationary solution as a limit", STATISTICAL)

claim("B93-S91", "two solutions come closer",
      After <= Rho(n, 1)*Before,
      sizes=["n"], over={**PLANE, **POINT, **OTHER},
      where=[*METRIC, *HERE, *THERE, let(After, distance(X1[n], X2[n], Y1[n], Y2[n])), let(Before, distance(x, y, x0, y0))],
      by=[instances(n=(1, 2, 3))],
      note=IN_THE_PLANE + "The bound on the rate, which holds almost surely, is not stated here.")

# --- the remark on the choice of the point ---------------------------------------------------------------------------------

D, D0, D1, dd = symbols("D D0 D1 dd")
LIPSCHITZ = [given("triangle", D <= D1 + D0 + dd), given("Lipschitz", D1 <= r*dd)]
DISTANCES = {D: nonneg(), D0: nonneg(), D1: nonneg(), dd: nonneg(), r: nonneg()}

claim("B93-R3.1", "the integrability condition does not depend on the point",
      a*x + b != x, over={a: scalar(), b: scalar(), x0: scalar(), x: scalar()}, given=[given("phi does not fix x_0", a*x0 + b != x0)],
      by=[example(a=0, b=0, x0=1, x=0), instances()],
      repair=repair("boundary case", "it is the positive part of the logarithm that is integrable for every x; the logarithm itself is minus infinity where "
                                     "x is fixed",
                    After <= Before + (r + 1)*dd, over=DISTANCES, where=[LARGER, let(After, Max(D, 1)), let(Before, Max(D0, 1))], given=LIPSCHITZ,
                    by=[example(D=3, D0=1, D1=1, dd="1/2", r=2), instances(made_by={D1: r*dd, D: r*dd + D0 + dd}), instances()]),
      note="For one map phi(x) = ax + b of the line, which is a stationary sequence: log d(phi(x), x) is finite exactly if phi does not fix x. In the "
           "counterexample phi is the constant map to 0, with rho = 0: log d(phi(1), 1) = 0, and d(phi(0), 0) = 0 has no finite logarithm. In the repair D "
           "is d(phi(x), x), D0 the same at x_0, and dd the distance of the two points; with (C1) so read, it is what the theorem needs.")

claim("B93-R3.1.2", "how far a map moves another point",
      D <= D0 + (r + 1)*dd, over=DISTANCES, given=LIPSCHITZ,
      by=[positivity([(1, 1, ["triangle"]), (1, 1, ["Lipschitz"])]), instances(made_by={D1: r*dd, D: r*dd + D0 + dd}), instances(),
          restated("the triangle inequality and what a Lipschitz constant is")],
      note="D is d(phi(x), x), D0 the same at x_0, D1 the distance of the two images and dd that of the points. The first of the two printed inequalities "
           "is the triangle inequality.")

not_checked("B93-C3.2", "averages along a solution", STATISTICAL)
not_checked("B93-E30", "averages along two solutions", STATISTICAL)
not_checked("B93-C3.3", "convergence in law", STATISTICAL)
not_checked("B93-P3.4", "solutions grow slower than any line", STATISTICAL)

# --- contractions ----------------------------------------------------------------------------------------------------------

claim("B93-S92", "one map more at the end of the composition",
      dxu <= dxv + r*dxw, over={dxu: nonneg(), dxv: nonneg(), dvu: nonneg(), dxw: nonneg(), r: nonneg()},
      given=[given("triangle", dxu <= dxv + dvu), given("Lipschitz", dvu <= r*dxw)],
      by=[positivity([(1, 1, ["triangle"]), (1, 1, ["Lipschitz"])]), instances(made_by={dvu: r*dxw, dxu: dxv + r*dxw}), instances(),
          restated("the triangle inequality and what a Lipschitz constant is")],
      note="u, v and w are the images of x under phi_n o ... o phi_1, phi_n o ... o phi_2 and phi_1, and r is rho(phi_n o ... o phi_2), which maps x to v "
           "and w to u. The first of the two printed inequalities is the triangle inequality.")

TOTAL = let(Total, distance(x, y, X1[n], X2[n]))
claim("B93-E31", "how far the composition moves a point",
      Total <= sum_of(i, 1, n, Rho(n, i + 1)*Move(i)), sizes=["n"], over={**PLANE, **POINT}, where=[*METRIC, *HERE, TOTAL],
      by=[steps("B93-S92", prose="S92, applied to phi_n o ... o phi_i for i = 1, 2, ..., n one after the other."), instances(n=(1, 2, 3))],
      note=IN_THE_PLANE + "The empty composition has the constant 1.")

claim("B93-S93", "contractions, one map at a time",
      Total <= Last + First, sizes=["n"], over={**PLANE, **POINT},
      where=[*METRIC, *HERE, TOTAL, let(Last, Move(n)), let(First, sum_of(i, 1, n - 1, Rho(i + 1, i + 1)*Move(i)))],
      given=[CONTRACTIONS],
      by=[steps("B93-S92", "B93-E25", prose="In (31) the constant of phi_n o ... o phi_{i+1} is at most that of phi_{i+1} times that of a contraction."),
          instances(n=(1, 2, 3), **SMALL), instances(n=(2, 3))],
      note=IN_THE_PLANE)

not_checked("B93-S94", "the mean of the distances", STATISTICAL)

claim("B93-S95", "contractions, k maps at a time",
      Total <= Last + First, sizes=["n", "m"], over={**PLANE, **POINT},
      where=[*METRIC, *HERE, TOTAL, let(Last, sum_of(i, n - m + 1, n, Rho(n, i + 1)*Move(i))), let(First, sum_of(i, 1, n - m, Rho(i + m, i + 1)*Move(i)))],
      given=[standing("m < n", m < n), CONTRACTIONS],
      by=[steps("B93-S92", "B93-E25", prose="In (31) the constant of phi_n o ... o phi_{i+1} is at most that of phi_{i+m} o ... o phi_{i+1} times that of a "
                                            "contraction."),
          instances(n=(2, 3, 4), m=(1, 2), **SMALL), instances(n=(3, 4), m=(1, 2))],
      note=IN_THE_PLANE + "m stands for the k of the text.")

not_checked("B93-E32", "the mean of the distances, k maps at a time", STATISTICAL)
not_checked("B93-S96", "the limit for many maps at a time", STATISTICAL)

claim("B93-S97", "solutions from other points",
      After <= Total + Before, sizes=["n"], over={**PLANE, **POINT, **OTHER},
      where=[*METRIC, *HERE, *THERE, TOTAL, let(After, distance(x, y, Y1[n], Y2[n])), let(Before, distance(x, y, x0, y0))],
      given=[CONTRACTIONS], by=[instances(n=(1, 2, 3), **SMALL), instances(n=(2, 3))],
      note=IN_THE_PLANE + "X_n starts from (x0, y0).")

not_checked("B93-R3.4", "independent maps", STATISTICAL)
