# SPDX-License-Identifier: MIT
"""Section III, (3.1)-(3.9): dynamics, symmetry, integrals, spectral factorization.

The stripped algorithm is a rational map of R^2n. Changing the sign of q* at
the start changes the sign of q*_t, and nothing else, for all t. The
coefficients of the invariant D, divided by the one of z^0, are rational
functions h_i of the point (q, q*) that do not change along an orbit; so an
orbit that starts where h_1 > 0 never comes to where h_1 < 0, both sets being
open and not empty, and the map is not topologically transitive.

With a = (Q - Q*)/r and b = (Q + Q*)/r the invariant becomes r(a b* + a* b) =
2D, a star meaning 1/z for z; dividing by 2 a a* shows b/(2a) as a function
with real part (doubled) d/(a a*), d = D/r = (a b* + a* b)/2. Where d > 0 and a is a Schur polynomial, b is one too.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, generic_index, instances, lemma, restated, steps, use
from exactkf.language import *
from proofs.blm91.notation import *
from proofs.blm91.section_2_filtering import KEPT, NEXT, ON_ORBIT, SOME, ht, one, til

q0, qs0, qm, qsm, hi, x, y, lev, row = symbols("q0 qs0 q_mirror qs_mirror h_i x y h_m row")
av, bv, dv, pd_, Fa, dm, xt, p = symbols("a_poly b_poly d N F_a d_m x_orbit f")
SX = sum_of(i, 1, n, abs(x[i]))
POINT = {q0: vector(n), qs0: vector(n)}
FROM = (*stripped(q0, qs0), *POLYNOMIALS)

# ---------------------------------------------------------------------- definitions of dynamics
not_checked("BLM91-E3.1", "a continuous map of an open set", "a definition: it fixes notation and asserts nothing")
not_checked("BLM91-E3.1'", "the dynamical system of a map", "a definition: it fixes notation and asserts nothing")
not_checked("BLM91-S28", "the orbit of a point", "a definition: it fixes notation and asserts nothing")
not_checked("BLM91-E3.2", "sensitivity to initial data", "a definition: it fixes notation and asserts nothing")

MAP = (rec(xt, t, x, substitute(p, xt[t])),)
claim("BLM91-S29", "finite orbits and periodic orbits",
      (xt[m] == xt[m + i]) >> exists(k, 1, m + i, xt[k] == x), sizes=["m"], over={p: polynomial(2), x: scalar(), i: integer(1, 3)}, where=MAP,
      given=[standing("time", defined(1 / m))],
      by=[example(m=1, f=[0, 0, 1], x=-1, i=1), instances(60, m=(1, 2))],
      repair=repair("other", "a finite orbit need not return to its start: under x -> x^2 the orbit of -1 is {1}; finite is the same as eventually periodic",
                    (xt[m] == xt[m + i]) >> (forall(k, 0, 4, xt[m + k] == xt[m + i + k])), sizes=["m"],
                    over={p: polynomial(2), x: scalar(), i: integer(1, 3)}, where=MAP,
                    by=[instances(60, m=(0, 1, 2)), example(m=1, f=[0, 0, 1], x=-1, i=1), example(m=1, f=[-1, 0, 1], x=1, i=2), example(m=0, f=[-1, 0, 1], x=0, i=2)]),
      note="Read on quadratic polynomials as maps of the line. A repetition x_m = x_(m+i), m >= 1, makes the orbit {x_1, x_2, ..} finite, and on such an "
           "orbit x_0 returns, if at all, among the first m + i steps.")
CYCLE = [given("periodic", exists(k, 1, 3, xt[k] == x))]
COUNT = let(n, sum_of(i, 1, 4, when(forall(k, 1, i - 1, xt[k] != xt[i]), 1, 0)))
claim("BLM91-S30", "the period is the smallest n with f^n(x_0) = x_0",
      forall(k, 0, n, iff(xt[k] == x, k == n)), over={p: polynomial(2), x: scalar()}, where=[*MAP, COUNT], given=CYCLE,
      by=[example(f=[0, 1, 0], x=0), instances()],
      repair=repair("boundary case", "n must be positive: f^0(x_0) = x_0, so that the smallest nonnegative n is always 0",
                    forall(k, 1, n, iff(xt[k] == x, k == n)), over={p: polynomial(2), x: scalar()}, where=[*MAP, COUNT], given=CYCLE,
                    by=[example(f=[-1, 0, 1], x=0), example(f=[-1, 0, 1], x=-1), example(f=[0, 0, 1], x=1),
                        example(f=[2, -1, 0], x=5), example(f=[1, "5/2", "-3/2"], x=0), example(f=[1, "-1/2", "-3/2"], x=0), instances()]),
      note="The definition is meant to give the number n of points of the periodic orbit through x_0; read on quadratic maps of the line.")

not_checked("BLM91-R3.1.1", "a dense orbit makes a map topologically transitive",
            "a statement of point-set topology about every continuous map of an open set; no exact instance decides it")

# ---------------------------------------------------------------------- symmetry and integrals of (2.25)
MIRROR = (rec(qm, t, q0, 1 / (1 - qsm[t][1] ** 2) * (qm[t] - qsm[t][1] * (J * qsm[t]))),
          rec(qsm, t, -qs0, 1 / (1 - qsm[t][1] ** 2) * (J * qsm[t] - qsm[t][1] * qm[t])))
claim("BLM91-E3.3", "mirror orbits", always(t, (qm[t] == q[t]) & (qsm[t] == -qs[t])), sizes=["n"], over=POINT, where=[*stripped(q0, qs0), *MIRROR],
      by=[generic_index(lemma(t, (qm[t] == q[t]) & (qsm[t] == -qs[t]), rule=True)), instances(n=(1, 2, 3))])


def after(x, y):
    """The two components of the map (2.25) at a point."""
    return 1 / (1 - y[1] ** 2) * (x - y[1] * (J * y)), 1 / (1 - y[1] ** 2) * (J * y - y[1] * x)


NEXT_POINT, NEXT_MIRRORED = after(q0, qs0), after(q0, -qs0)
claim("BLM91-T3.2.2", "the map commutes with (q, q*) -> (q, -q*)",
      (NEXT_MIRRORED[0] == NEXT_POINT[0]) & (NEXT_MIRRORED[1] == -NEXT_POINT[1]), sizes=["n"], over=POINT, where=[SHIFT], given=SOME,
      by=[generic_index(), instances(n=(1, 2, 3))], note="Written out are the two components of the map (2.25), at (q0, -q*0) and at (q0, q*0).")
HI = (function(one, [i, x], when(i == 0, 1, x[i])), function(til, [i, x], when(i == 0, 0, x[i])),
      function(hi, [i, x, y], sum_of(j, 0, n - i, one(j, x) * one(j + i, x) - til(j, y) * til(j + i, y)) / sum_of(j, 0, n, one(j, x) ** 2 - til(j, y) ** 2)))
claim("BLM91-E3.4", "the quotients of coefficients of the invariant",
      forall(t, 0, m, forall(i, 1, n, eq(ht(t, i), coeff(D, i) / coeff(D, 0), ht(0, i)))), sizes=["n", "m"], over=POINT, given=SOME,
      where=[*FROM, INVARIANT, *ON_ORBIT], by=[generic_index(KEPT, uses=[use(0, t=t, i=i), use(0, t=t, i=0)]), instances(n=(1, 2, 3), m=(1, 2, 3))],
      note="n + 1 equations for q_t, q*_t and r_t; the quotient removes r_t.")
claim("BLM91-T3.2.1", "level sets of the integrals are invariant",
      always(t, forall(i, 1, n, ht(t, i) == ht(0, i))), sizes=["n"], over=POINT, where=[*FROM, *ON_ORBIT], given=SOME,
      by=[generic_index(KEPT, uses=[use(0, t=t, i=i), use(0, t=t, i=0)]), instances(n=(1, 2, 3), horizon=2)],
      note="Every h_i keeps its value along the orbit of any point, so a common level set is mapped into itself.")
up, down, first = symbols("h_up h_down h_0")
E1 = matrix_of(i, j, n, 1, when(i == 1, 1, 0))
claim("BLM91-T3.2.3", "the algorithm is not topologically transitive",
      iff(first > 0, lev > 0) & (up > 0) & (down < 0), sizes=["n", "m"], over=POINT,
      where=[*stripped(q0, qs0), *HI, let(first, hi(1, q0, qs0)), let(lev, hi(1, q[m], qs[m])), let(up, hi(1, E1, 0 * E1)), let(down, hi(1, -E1, 0 * E1))],
      by=[steps("BLM91-T3.2.1", prose="h_1 is continuous where its denominator is not zero and keeps its value along orbits, so that the open sets h_1 > 0 "
                "and h_1 < 0, neither of them empty, are never joined by an orbit"),
          instances(40, n=(1, 2, 3), m=(1, 2)), example(n=1, m=1, q0=[0], qs0=["1/2"])],
      note="An orbit from the open set h_1 > 0 never enters the open set h_1 < 0, and each of them has a point. m is the time.")
claim("BLM91-R3.1.3", "the algorithm is not topologically transitive",
      iff(first < 0, lev < 0) & (up > 0) & (down < 0), sizes=["n", "m"], over=POINT,
      where=[*stripped(q0, qs0), *HI, let(first, hi(1, q0, qs0)), let(lev, hi(1, q[m], qs[m])), let(up, hi(1, E1, 0 * E1)), let(down, hi(1, -E1, 0 * E1))],
      by=[steps("BLM91-T3.2.1", prose="as for Theorem 3.2"), instances(40, n=(1, 2, 3), m=(1, 2)), example(n=1, m=1, q0=[0], qs0=["1/2"])])
HVEC = (let(first, matrix_of(i, j, n, 1, ht(0, i))), let(lev, matrix_of(i, j, n, 1, ht(m, i))), let(p, vstack(q0, qs0)))
claim("BLM91-S31", "the vector of integrals separates orbits",
      (size_of(p) == n) & (lev == first), sizes=["n", "m"], over=POINT, where=[*stripped(q0, qs0), *ON_ORBIT, *HVEC],
      by=[example(n=1, m=1, q0=[1], qs0=[0]), instances(n=(1, 2), m=(1, 2))],
      repair=repair("index", "h is a map from R^2n (where its common denominator is not zero) to R^n, not from R^n: its argument is the pair (q, q*)",
                    (size_of(p) == 2 * n) & (lev == first), sizes=["n", "m"], over=POINT, where=[*stripped(q0, qs0), *ON_ORBIT, *HVEC], given=SOME,
                    by=[restated("rational functions are continuous where they have values"), generic_index(KEPT, uses=[use(0, t=m, i=row), use(0, t=m, i=0)]), instances(n=(1, 2, 3), m=(1, 2, 3))]),
      note="As printed h maps R^n to R^n, so that its argument would have n entries. h being constant on orbits, preimages of disjoint sets "
           "are not joined by an orbit; m is the time.")

# ---------------------------------------------------------------------- a_t, b_t
AB = (function(av, [t], 1 / r[t] * (Qp(t) - Qs(t))), function(bv, [t], 1 / r[t] * (Qp(t) + Qs(t))))
ORBITS = (*FROM, INVARIANT, *AB)
claim("BLM91-E3.5", "a_t and b_t are monic of degree n and carry Q_t and Q*_t",
      always(t, (av(t) == Z**n + sum_of(i, 1, n, (q[t][i] - qs[t][i]) * Z ** (n - i)))
             & (rational("1/2") * r[t] * (av(t) + bv(t)) == Qp(t)) & (rational("1/2") * r[t] * (bv(t) - av(t)) == Qs(t))),
      sizes=["n"], over=POINT, where=ORBITS, by=[generic_index(), instances(n=(1, 2, 3))],
      note="The display defines a_t and b_t.")
INVARIANT_AB = r[t] * (av(t) * recip(bv(t)) + recip(av(t)) * bv(t)) == 2 * D


def by_invariant(times):
    """(3.6), shown first, which is taken off this many times."""
    return generic_index(lemma(t, NEXT, direct=True), lemma(t, INVARIANT_AB, in_values=True, uses=[use(0, t=t), use(1, t=t, times=1)]), closed=[Qp, Qs], in_values=True, uses=[use(1, t=t, times=times)])


claim("BLM91-E3.6", "the invariant in terms of a_t and b_t", always(t, INVARIANT_AB), sizes=["n"], over=POINT, where=ORBITS, given=SOME, by=[by_invariant(1), instances(n=(1, 2, 3))])
claim("BLM91-E3.7", "the real part of b_t/(2 a_t)",
      always(t, bv(t) / (2 * av(t)) + recip(bv(t)) / (2 * recip(av(t))) == 1 / r[t] * D / (av(t) * recip(av(t)))), sizes=["n"], over=POINT, where=ORBITS, given=SOME,
      by=[by_invariant(1 / (2 * r[t] * av(t) * recip(av(t)))), instances(n=(1, 2, 3), horizon=2)], note="d_t is written D/r_t.")
claim("BLM91-E3.8", "d_t in terms of a_t and b_t",
      always(t, 1 / r[t] * D == av(t) * recip(bv(t)) + recip(av(t)) * bv(t)), sizes=["n"], over=POINT, where=ORBITS, given=SOME,
      by=[example(n=1, q0=[0], qs0=[0]), instances(n=(1, 2))],
      repair=repair("factor", "a_t b_t* + a_t* b_t is 2 d_t: (3.6) has 2D on the right, and d_t = D/r_t",
                    always(t, 1 / r[t] * D == rational("1/2") * (av(t) * recip(bv(t)) + recip(av(t)) * bv(t))), sizes=["n"], over=POINT, where=ORBITS, given=SOME,
                    by=[by_invariant(-1 / (2 * r[t])), instances(n=(1, 2, 3))]),
      note="d_t is D/r_t, as defined after (3.7).")
claim("BLM91-S32", "sign definiteness along the orbit",
      iff(nonneg_on_circle(D) | nonneg_on_circle(-D), nonneg_on_circle(dm) | nonneg_on_circle(-dm)), sizes=["n", "m"], over=POINT,
      where=[*ORBITS, let(dm, rational("1/2") * (av(m) * recip(bv(m)) + recip(av(m)) * bv(m)))],
      by=[steps("BLM91-E3.6", prose="d_t is D divided by the number r_t"),
          instances(60, n=(1, 2), m=(0, 1, 2), using={x: vector(n), y: vector(n)}, made_by={q0: x, qs0: y}),
          example(n=1, m=2, q0=[3], qs0=["3/2"]), example(n=1, m=2, q0=["1/4"], qs0=[2]), example(n=1, m=1, q0=["1/2"], qs0=["1/2"]),
          example(n=2, m=2, q0=["1/2", "1/3"], qs0=["1/4", "1/5"]), example(n=1, m=1, q0=[0], qs0=[1])],
      note="d_t at time m by a_t and b_t, with the factor 1/2; the printed implication and its converse.")
claim("BLM91-E3.9", "positive realness of b/(2a)",
      iff(pos_on_circle(pd_) & schur(Fa), pos_on_circle(dv) & schur(av)) & ((pos_on_circle(dv) & schur(av)) >> schur(bv)), sizes=["n"], over={a: vector(n), u: vector(n)},
      where=[SHIFT, FIRST, let(av, polynomial_of(a)), let(bv, polynomial_of(u)), let(dv, rational("1/2") * (av * recip(bv) + recip(av) * bv)),
             let(Fa, J - a * T(h)), let(pd_, av * recip(av) + (bv - av) / 2 * recip(av) + recip((bv - av) / 2) * av)],
      by=[steps("BLM91-E3.7", facts=["the real part of an analytic function takes its minimum on the boundary"],
                prose="F_t has the characteristic polynomial a; without zeros of a on the circle the Popov condition is d > 0 by (3.7); then 1/2 b/a "
                      "has positive real part, hence no zero, for |z| >= 1"),
          instances(40, n=(1, 2, 3), using={x: vector(n), w: vector(n)}, made_by={a: x / (1 + SX), u: x / (1 + SX) + w / ((1 + SX) * (1 + SW))}),
          instances(40, n=(1, 2)), example(n=1, a=["1/2"], u=[-1]), example(n=1, a=[2], u=[2])],
      note="At any point of the orbit, a for a_t and u for the coefficients of b_t. Positive real is taken as in (2.3), (2.4): the Popov condition, and "
           "stability of the matrix F_t = J - a_t h' of the realization (1/2, h, F_t, q*_t) of b_t/(2a_t). Were only the rational function looked at, common "
           "zeros of a_t and b_t outside the disc would have to be excluded.")
