# SPDX-License-Identifier: MIT
"""Section III, Theorem 3.3 and the remarks around it: equilibria, convergence, periodic points in any dimension.

(q, q*) is fixed by the stripped algorithm exactly when q* = 0: gamma J q* = gamma^2 q and J q* - gamma q = (1 - gamma^2) q*
give (1 - gamma^2) q* = 0 if gamma is not zero, and J q* = q* with a nilpotent J if it is. Near (q, 0) the map is, up to second order, the
identity on q and J - q h' on q*, whose characteristic polynomial is Q(z).

r_t D + |Q*_t|^2 is |Q_t|^2 on the circle, so never negative; where q*_t tends to zero D has one sign, and Q_infinity Q_infinity* = r_infinity D.

If q and q* have only first components, the algorithm is the scalar one: each order contains the plane of n = 1 with
its periodic points of every period p >= 3.
"""

from exactkf.claims import claim, not_checked
from exactkf.evidence import example, instances, part, steps
from exactkf.language import *
from proofs.blm91.lemmas_steady import CONVERGES, CONVERGES_BY, DRAWN, FACTOR, POWERS, READ, STEADY_WORDS
from proofs.blm91.notation import *

un, wn, p, y, rest, Qm, fixed, flat = symbols("u_next w_next p y remainder Q_m fixed flat")
q0, qs0 = symbols("q0 qs0")
E1 = matrix_of(i, j, n, 1, when(i == 1, 1, 0))
STEP = (SHIFT, FIRST, let(un, 1 / (1 - qs0[1] ** 2) * (q0 - qs0[1] * (J * qs0))), let(wn, 1 / (1 - qs0[1] ** 2) * (J * qs0 - qs0[1] * q0)))
POINT = {q0: vector(n), qs0: vector(n)}
ORBIT_N = (*stripped(q0, qs0), *POLYNOMIALS, INVARIANT)

claim("BLM91-T3.3.1a", "the equilibria are the points (q, 0)", iff(fixed, flat) & (wn * (1 - qs0[1] ** 2) == J * qs0 - qs0[1] * q0), sizes=["n"], over=POINT,
      where=[*STEP, let(fixed, (un == q0) & (wn == qs0)), let(flat, qs0 == Zero(n, 1))],
      by=[steps(facts=["a nilpotent matrix has no eigenvalue but 0"], prose="gamma J q* = gamma^2 q and J q* - gamma q = (1 - gamma^2) q*: for gamma not 0 the first gives J q* = gamma q, so (1 - gamma^2) q* = 0; for gamma = 0 the second is J q* = q*"),
          instances(40, n=(1, 2, 3)), example(n=1, q0=[2], qs0=[0]), example(n=2, q0=[1, 2], qs0=[0, 0]), example(n=2, q0=[1, 2], qs0=[0, 1]), example(n=3, q0=[0, 0, 0], qs0=[0, 0, 1])])
SEMI = (nonneg_on_circle(rest), r[m] * (1 + (T(q[m]) * q[m])[1, 1] - (T(qs[m]) * qs[m])[1, 1]) == coeff(D, 0))
REST = let(rest, r[m] * D + Qs(m) * recip(Qs(m)))
claim("BLM91-T3.3.1b", "convergence needs a sign definite D", SEMI[0] & SEMI[1], sizes=["n", "m"], over=POINT, where=[*ORBIT_N, REST],
      by=[steps("BLM91-E2.28", prose="r_t D + |Q*_t|^2 = |Q_t|^2 on the circle; if q_t converges and q*_t tends to 0, then r_t tends to D_0/(1 + |q|^2), not 0 unless D is 0, and r_infinity D >= 0"),
          instances(40, n=(1, 2, 3), m=(0, 1, 2))],
      note="Checked at every time m: r_t D + |Q*_t|^2 >= 0 on the circle, and the formula for r_t from which its limit is read off. D is that of (2.28), which the print calls (3.28).")
claim("BLM91-T3.3.1c", "the limit is a spectral factor", Qp(m) * recip(Qp(m)) == r[m] * D + Qs(m) * recip(Qs(m)), sizes=["n", "m"], over=POINT, where=ORBIT_N,
      by=[steps("BLM91-E2.28", prose="the last term tends to zero with q*_t, r_t and Q_t converge"), instances(n=(1, 2, 3), m=(0, 1, 2, 3))],
      note="Q_infinity Q_infinity* = r_infinity D is the limit of this identity for an orbit that converges; m is the time t.")
CLASSIC = ["Rouche's theorem", "r_t is bounded below by the minimum of the spectral density", "a positive D has one monic Schur spectral factor"]
claim("BLM91-T3.3.2a", "positive real data converge", CONVERGES[0] & CONVERGES[1], **STEADY_WORDS, by=CONVERGES_BY,
      note=READ + " Defined for all t: r_(t+1) = (1 - gamma_t^2) r_t is d + h'(P - S_(t+1))h, not 0. The limit (x, 0) is stable because x(z) is a Schur polynomial.")
claim("BLM91-T3.3.2b", "Q_t is a Schur polynomial", schur(Qm) & pos_on_circle(rest), sizes=["n", "m"], over={a: vector(n), g: vector(n)},
      where=[*stripped(g + a, g), *POLYNOMIALS, *DATA, let(Qm, Qp(m)), let(rest, Qp(m) * recip(Qp(m)) - Qs(m) * recip(Qs(m)))], given=REAL,
      by=[steps("BLM91-E2.27", "BLM91-E2.28", facts=["Rouche's theorem", "Schwarz's lemma"], prose="|Q*_t| < |Q_t| on the circle while r_t > 0; Q_0 - Q*_0 = a(z) is Schur, Q_(t+1) = Q_t - gamma_t z Q*_t, and |gamma_t| < 1 by Schwarz's lemma"),
          instances(n=(1, 2, 3), m=(0, 1, 2, 3), **CLASSICAL), *EDGE],
      note="m is the time t; the second part is r_t D > 0 on the circle, the state at time t.")
claim("BLM91-T3.3.2c", "the limit is the stable spectral factor", CONVERGES[0] & (D == dd * sg * recip(sg)), **{
          **STEADY_WORDS, "where": [*STEADY_WORDS["where"], let(sg, polynomial_of(x)), let(rest, polynomial_of(g, 0)), let(Qm, polynomial_of(g + a)), let(D, Qm * recip(Qm) - rest * recip(rest))]},
      by=[steps("BLM91-E2.28", facts=[FACTOR, POWERS], prose="x(z) is the Schur factor of D; that q_t tends to x and r_t to d is shown for every n in T3.3.2a, by the first formula"), DRAWN],
      note=READ + " D is that of the initial data; with d x(z)x(1/z) = D, the limits Q_infinity = d x(z) and r_infinity = d give Q_infinity Q_infinity* = r_infinity D.")
PERIODIC = (let(lam, -cospi(2, p)), let(al0, ALPHA_OF), let(ga0, GAMMA_OF), let(q0, al0 * E1), let(qs0, ga0 * E1), *stripped(q0, qs0))
back = sym("back")
BACK_N = function(back, [t], (q[t] == q0) & (qs[t] == qs0))
SWEEP = [example(n=2, p=3, u=2), example(n=1, p=4, u=2), example(n=2, p=5, u=3), example(n=2, p=6, u=2)]
claim("BLM91-T3.3.3", "periodic points of every period p >= 3 in every dimension", forall(t, 1, p, iff(back(t), t == p)) & (lam**2 < 1), sizes=["n"], over={p: integer(3, 7), u: integer(2, 3)},
      where=[*PERIODIC, BACK_N],
      by=[steps("BLM91-S55", "BLM91-X.2", facts=["Kronecker: multiples of an irrational part of a full turn are dense on the circle"],
                prose="the plane of points with first components only is invariant; in it every point of the hyperbola kappa = -sec(2 pi/p), |kappa| > 1, that does not end has period p, and arbitrarily close to it there are dense, "
                      "unbounded orbits: sensitivity as in Corollary 3.10"),
          instances(8, n=(1, 2)), *SWEEP],
      note="(2.25) of order n run in the number field from two points of each hyperbola, p <= 7. The submanifolds are the corridors (and hyperbolas) in the plane of the first components, where D is not sign definite.")
q1, qs1, steady, near = symbols("q_plane qs_plane steady near")
#: (2.25) from the point of the scalar algorithm with 1/kappa = -cos(2 pi/p), beside the orbit from (g + a, g)
PLANE = (let(lam, -cospi(2, p)), let(al0, ALPHA_OF), let(ga0, GAMMA_OF),
         rec(q1, t, al0 * E1, 1 / (1 - qs1[t][1] ** 2) * (q1[t] - qs1[t][1] * (J * qs1[t]))),
         rec(qs1, t, ga0 * E1, 1 / (1 - qs1[t][1] ** 2) * (J * qs1[t] - qs1[t][1] * q1[t])),
         function(back, [t], (q1[t] == al0 * E1) & (qs1[t] == ga0 * E1)))
PARTS = (*STEADY, let(q0, g + a), let(qs0, g), *STEP[2:], let(fixed, (un == q0) & (wn == qs0)), let(flat, qs0 == Zero(n, 1)), REST, let(Qm, Qp(m)),
         let(steady, (n <= 2) & schur(az) & (D == dd * sg * recip(sg)) & (SX <= rational("1/2")) & (dd >= rational("1/4"))), let(near, dist < rational("1/1000")))
claim("BLM91-T3.3", "Theorem 3.3", iff(fixed, flat) & SEMI[0] & SEMI[1] & (rest == Qp(m) * recip(Qp(m))) & (steady >> (near & schur(Qm) & schur(sg))) & forall(t, 1, p, iff(back(t), t == p)) & (lam**2 < 1),
      sizes=["n", "m"], over={**STEADY_OVER, p: integer(3, 6), u: integer(2, 3)}, where=[*PARTS, *PLANE],
      by=[part("convergence for n <= 2, as far as 20 steps, where the zeros of the factor are well inside"),
          steps("BLM91-E2.25", "BLM91-E2.27", "BLM91-E2.28", "BLM91-S55", "BLM91-X.2", facts=["a nilpotent matrix has no eigenvalue but 0", *CLASSIC, "Kronecker: multiples of an irrational part of a full turn are dense on the circle"],
                prose="the parts, in this order, are T3.3.1a to T3.3.3, argued there"),
          instances(20, n=(1, 2), m=(0, 1, 2), using={w: vector(n)}, made_by={x: w}), instances(6, n=(1, 2), m=(1, 2), **STEADY_DRAW),
          *(example(n=i_, m=1, a=[1, 2, 3][:i_], g=[0, 0, 0][:i_], x=[0, 0, 0][:i_], p=3, u=2) for i_ in (1, 2)), example(n=2, m=1, a=[0, 0], g=[0, "2/5"], x=[0, "1/2"], p=4, u=2)],
      note="The conjunction of the parts at one point (a, g) with q_0 = g + a, q*_0 = g: equilibria, necessity and spectral factor; convergence for positive real data whose spectral factor x is known (steady), which T3.3.2a has for every n; periodic points of order n. "
           "Part 1) refers to D as that of (3.28); it is that of (2.28).")

# ---------------------------------------------------------------------- remarks
claim("BLM91-R3.1.2", "periods of the algorithm and of the Riccati equation",
      forall(t, 1, p, iff(back(t), t == p)) & forall(t, 1, y, iff(flat(t), t == y)), over={p: integer(3, 9), y: integer(2, 8), u: integer(2, 3)},
      where=[let(lam, -cospi(2, p)), let(al0, ALPHA_OF), let(ga0, GAMMA_OF), *ORBIT, function(back, [t], (al[t] == al0) & (ga[t] == ga0)),
             let(fixed, cospi(1, y)), rec(un, t, u, 1 / (2 * fixed - un[t])), function(flat, [t], un[t] == u)],
      by=[steps("BLM91-X.2", "BLM91-S71", facts=["Kronecker: multiples of an irrational part of a full turn are dense on the circle"],
                prose="q = 1 serves for every p; sensitivity as in Corollary 3.10, with a rational and an irrational angle close to each other"), instances(16), example(p=3, y=2, u=2), example(p=6, y=3, u=2), example(p=5, y=4, u=3)],
      note="Period p of (3.10) for 1/kappa = -cos(2 pi/p), and period y of the Riccati equation, in the coordinate alpha, for 1/kappa = cos(pi/y); the orbits are run in the number fields.")
claim("BLM91-R3.5.1", "the stable directions of an equilibrium",
      forall(i, 1, n, (laurent(un[i], 0) == q0[i]) & (laurent(un[i], 1) == x[i]) & (laurent(wn[i], 1) == ((J - q0 * T(h)) * qs0)[i])) & (charpoly(J - q0 * T(h)) == polynomial_of(q0)), sizes=["n"],
      over={q0: vector(n), qs0: vector(n), x: vector(n)},
      where=[SHIFT, FIRST, let(y, qs0 / Z), let(un, 1 / (1 - y[1] ** 2) * (q0 + x / Z - y[1] * (J * y))), let(wn, 1 / (1 - y[1] ** 2) * (J * y - y[1] * (q0 + x / Z)))],
      by=[steps(facts=["stable manifold theorem"], prose="the linear part at (q, 0) is the identity on q and J - q h' on q*; the contracting directions are as many as the eigenvalues of J - q h' in the open disc, the zeros of Q(z) there"), instances(n=(1, 2, 3))],
      note="The map at (q + eps x, eps q*), eps = 1/z, to first order. The stable manifold is that of directions contracted at an exponential rate: zeros on the circle, as at (1, 0) for n = 1, do not count.")
not_checked("BLM91-Q1", "an invariant open subset, by simulations", "a report on simulations for n > 1; it does not say which subset, so that there is nothing to decide")
