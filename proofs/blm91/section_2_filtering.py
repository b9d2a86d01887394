# SPDX-License-Identifier: MIT
"""Section II, (2.14)-(2.30): the Kalman filter, the fast algorithm, and its invariant.

Innovations are an orthogonal basis of the past outputs, so the estimate of
the state is its expansion in them; new noise is orthogonal to the past, hence
each step multiplies the old coefficients by F and adds one new term, and that
is the Kalman filter with gain k_t = E{x_(t+1) y~_t}/r_t. Since E{x_(t+1)
y_(t-j)} is F^j g, the gain is a reversed Szego polynomial of F applied to g.

Szego polynomials come in pairs, and so do gains: k*_t uses phi_t where k_t
uses its reversal. The two-term recursion of the polynomials becomes a
two-term recursion of the vectors, and h'k*_t is the Schur parameter itself:
the fast algorithm (1.9). In coordinates where F is a shift minus a h', adding
the constant vector a to k_t removes F from the recursion altogether; only the
initial values remember the system. Multiplied by r_t and read as
coefficients, the vectors are polynomials Q_t, Q*_t that obey the recursion
of the Szego polynomials again, and

    Q_t(z)Q_t(1/z) - Q*_t(z)Q*_t(1/z) = r_t D(z, 1/z)

with D fixed by the initial values. Q_t/r_t is the characteristic polynomial
of the filter F - k_t h'.

If D > 0 on the circle and a(z) = Q_0 - Q*_0 is a Schur polynomial, then
|Q*_t| < |Q_t| there while r_t > 0; by Rouche's theorem Q_t, Q_t - Q*_t and
Q_(t+1) = Q_t - gamma_t z Q*_t have as many zeros in the disc, all of them.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, fact, generic_index, identity, induction, instances, lemma, steps, use
from exactkf.language import *
from proofs.blm91.lemmas_canonical import BY_CAYLEY, TO_CANONICAL, Fc, Lc, Tm
from proofs.blm91.lemmas_estimate import PROJECTED, SOME, Gram, filtered, innovation_weights, xh
from proofs.blm91.lemmas_gain import (
    BACKWARD,
    BY_RICCATI,
    BY_SUMS,
    COEFFICIENTS,
    FORWARD,
    GAIN,
    MODELLED,
    REVERSED,
    RICCATI_LEMMAS,
    SOLUTION,
    SYSTEM,
    from_the_past,
    innovation,
    sums_with,
)
from proofs.blm91.lemmas_innovations import (
    BY_EXPANSION,
    BY_GAIN,
    BY_NOISE,
    BY_OWN_EXPANSION,
    EXPANDED,
    EXPANSION_LEMMAS,
    EXPANSION_WEIGHTS,
    GAIN_LEMMAS,
    INNOVATION_GAIN,
    NOISE_LEMMAS,
    OPENED,
    OWN_EXPANSION_LEMMAS,
    VALUES,
    WITH_GAIN,
    correlation,
    inverse_r,
    phi_row,
)
from proofs.blm91.notation import *

kk, ks, Pi, fk, fks, x, y, Fm, Qm = symbols("K K_star Pi K_fast K_fast_star x y F_m Q_m")

# ---------------------------------------------------------------------- estimates as projections
_MODEL = {"sizes": ["n"], "over": SYSTEM, "given": SOME}
_BY = instances(n=(1, 2, 3), horizon=2)
_NAMES = {inverse_r: "r^{-1}"}
SAID = PROJECTED + " y~_k is the row phi_row of the coefficients of phi_k, for c_k = h'F^(k-1)g, and cov_xe is E{x_t y~_k}; what comes after phi_row serves the proof alone."
claim("BLM91-E2.14", "the estimate expanded in innovations",
      always(t, xh(t + 1) == sum_of(k, 0, t, inverse_r(k) * (T(phi_row(t + 1, k) * Gram(t + 1) * T(xh(t + 1))) * phi_row(t + 1, k)))), **_MODEL,
      where=[*EXPANDED, *EXPANSION_WEIGHTS], tex=_NAMES, by=[generic_index(*OWN_EXPANSION_LEMMAS, **OPENED, uses=BY_OWN_EXPANSION), _BY],
      note="At t + 1 in place of t. " + SAID)
claim("BLM91-E2.15", "the estimate from covariances of the state itself",
      always(t, xh(t + 1) == sum_of(k, 0, t, inverse_r(k) * (correlation(t + 1, k) * phi_row(t + 1, k)))), **_MODEL,
      where=[*EXPANDED, *EXPANSION_WEIGHTS], tex=_NAMES, by=[generic_index(*EXPANSION_LEMMAS, **OPENED, uses=BY_EXPANSION), _BY], note="At t + 1 in place of t. " + SAID)
claim("BLM91-S17", "new noise is orthogonal to the past",
      always(t, (phi_row(t + 1, t) == innovation_weights()) & forall(k, 0, t - 1, correlation(t + 1, k) == F * correlation(t, k))), **_MODEL,
      where=[*EXPANDED, *VALUES], tex=_NAMES, by=[generic_index(*NOISE_LEMMAS, **OPENED, uses=BY_NOISE), _BY], note=SAID)
claim("BLM91-E2.16", "the Kalman filter", always(t, filtered(INNOVATION_GAIN)), **_MODEL,
      where=WITH_GAIN, tex=_NAMES, by=[generic_index(*GAIN_LEMMAS, **OPENED, uses=BY_GAIN), _BY], note=SAID + " The gain is (2.17), the estimate at time 0 is zero.")
claim("BLM91-E2.29", "the filter driven by the output",
      always(t, xh(t + 1) == hstack((F - INNOVATION_GAIN * T(h)) * xh(t), Zero(n, 1)) + INNOVATION_GAIN * hstack(Zero(1, t), 1)), **_MODEL,
      where=WITH_GAIN, tex=_NAMES, by=[generic_index(*GAIN_LEMMAS, **OPENED, uses=BY_GAIN), _BY], note=SAID)

# ---------------------------------------------------------------------- the gain, for every n and t
claim("BLM91-E2.17", "the gain is that of the Riccati equation",
      forall(t, 0, m, GAIN == (g - F * Pi[t] * h) / (1 - T(h) * Pi[t] * h)), sizes=["n", "m"], over=SYSTEM, where=[*MODELLED, *FORWARD, *SOLUTION],
      by=[generic_index(*RICCATI_LEMMAS, **BY_RICCATI), instances(n=(1, 2, 3), m=(1, 2))],
      note="(2.17) is the coefficient of the innovation in (2.16), which is checked there; here it is compared with (1.3), (1.4), "
           "which the paper says can be derived from it. phi_g, phis_g and Pi_sum serve the proof alone. " + COEFFICIENTS)
claim("BLM91-E2.18", "the gain by a reversed Szego polynomial",
      forall(t, 0, m, GAIN == 1 / r[t] * substitute(phis[t], F) * g), sizes=["n", "m"], over=SYSTEM,
      where=[*MODELLED, *FORWARD], by=[generic_index(REVERSED, *WRITTEN_OUT, sums_with(phi, innovation), **BY_SUMS), instances(n=(1, 2, 3), m=(1, 2))],
      note="k_t is (2.17), E{x_(t+1) y~_t}/r_t. " + COEFFICIENTS)
claim("BLM91-E2.19", "the companion gain, by phi in place of its reversal",
      forall(t, 0, m, 1 / r[t] * substitute(phi[t], F) * g == 1 / r[t] * covariance(state(t + 1), from_the_past(t, t))), sizes=["n", "m"], over=SYSTEM,
      where=[*MODELLED, *BACKWARD], by=[generic_index(REVERSED, *WRITTEN_OUT, sums_with(phis, from_the_past), **BY_SUMS), instances(n=(1, 2, 3), m=(1, 2))],
      note="The left side is k*_t, which the display defines. Checked is that it is to the backward innovation (reversed coefficients: y_0 minus its "
           "prediction from y_1 .. y_t) what k_t is to the innovation. " + COEFFICIENTS.replace("y~_t is a sum with the coefficients of phi_t", "it is a sum with the coefficients of phi_t*").replace("ytilde", "yback"))

# ---------------------------------------------------------------------- the fast algorithm
fp, fps = symbols("phi_F phi_star_F")
PAIR = (rec(fp, t, Identity(n), F * fp[t] - gam[t] * fps[t]), rec(fps, t, Identity(n), fps[t] - gam[t] * F * fp[t]), rec(r, t, 1, (1 - gam[t] ** 2) * r[t]),
        function(kk, [t], 1 / r[t] * (fps[t] * g)), function(ks, [t], 1 / r[t] * (fp[t] * g)))
claim("BLM91-E2.20", "recursion of the two gains",
      (kk(0) == g) & (ks(0) == g) & always(t, (kk(t + 1) == 1 / (1 - gam[t] ** 2) * (kk(t) - gam[t] * F * ks(t)))
                                           & (ks(t + 1) == 1 / (1 - gam[t] ** 2) * (F * ks(t) - gam[t] * kk(t)))),
      sizes=["n"], over={F: matrix(n, n), g: vector(n), gam: signal(0)}, where=PAIR,
      by=[induction(), instances(n=(1, 2, 3))],
      note="For any numbers gamma_t with square other than 1. phi_t(F) and phi*_t(F) are computed by (2.6) with F in place of z: a polynomial's value at "
           "F respects sums, and turns a factor z into a factor F. That these gains are those of the polynomials is also part of the claim on (1.9).")
GAINS = (REALIZED, *szego(c), function(kk, [t], 1 / r[t] * (substitute(phis[t], F) * g)), function(ks, [t], 1 / r[t] * (substitute(phi[t], F) * g)))
FGH = {F: matrix(n, n), h: vector(n), g: vector(n)}
claim("BLM91-E2.21", "the Schur parameter is the first component seen by h",
      forall(t, 0, m, gam(t) == T(h) * (1 / r[t] * (substitute(phi[t], F) * g))), sizes=["n", "m"], over=FGH, where=[REALIZED, *szego(c)],
      by=[generic_index(supported=[phi, phis]), instances(n=(1, 2, 3), m=(1, 2, 3, 4))],
      note="k*_t is written out, as phi_t(F)g/r_t.")
FAST = (rec(fk, t, g, 1 / (1 - (T(h) * fks[t]) ** 2) * (fk[t] - T(h) * fks[t] * (F * fks[t]))),
        rec(fks, t, g, 1 / (1 - (T(h) * fks[t]) ** 2) * (F * fks[t] - T(h) * fks[t] * fk[t])))
claim("BLM91-S18", "eliminating the Schur parameters gives the fast algorithm",
      forall(t, 0, m, (fk[t] == kk(t)) & (fks[t] == ks(t)) & (size_of(vstack(fk[t], fks[t])) == 2 * n))
      & (sum_of(i, 1, n, sum_of(j, i, n, 1)) == rational("1/2") * n * (n + 1)),
      sizes=["n", "m"], over=FGH, where=[*GAINS, *FAST],
      by=[generic_index(lemma(t, (fk[t] == kk(t)) & (fks[t] == ks(t)), rule=True),
                        lemma(s, sum_of(i, 1, s, i) == rational("1/2") * s * (s + 1), uses=[use(1, s=s)]), supported=[phi, phis], uses=[use(1, s=n)]),
          instances(n=(1, 2, 3), m=(1, 2, 3))],
      note="(1.9) is run on its own and compared with the gains by Szego polynomials. The counts of equations, 2n against the n(n+1)/2 "
           "entries on and above the diagonal of a symmetric matrix, are as printed; the first is smaller only for n >= 4.")

# ---------------------------------------------------------------------- canonical form
claim("BLM91-E2.22", "observable pairs can be brought to the canonical form",
      (Tm * F == Fc * Tm) & (T(e) * Tm == T(h)) & (charpoly(Fc) == polynomial_of(a)) & (det(Lc) == 1), sizes=["n"], over={F: matrix(n, n), h: vector(n)},
      where=TO_CANONICAL, given=SOME, by=[BY_CAYLEY, instances(n=(1, 2, 3, 4))],
      note="The display is a choice of coordinates. Checked is that it can be made: with a from the characteristic polynomial of F, the triangular Toeplitz matrix "
           "L_a of 1, a_1, a_2, .. times the observability matrix O_F carries (F, h) to it, and is invertible when (F, h) is observable, as det L_a = 1.")
FORM = (SHIFT, *CANONICAL)
claim("BLM91-E2.23", "canonical form as a shift minus a rank-one matrix", F == J - a * T(h), sizes=["n"], over={a: vector(n)}, where=FORM,
      by=[generic_index(), instances(n=(1, 2, 3, 4))])
FREE = {J: matrix(n, n), h: vector(n), a: vector(n), x: vector(n)}
claim("BLM91-S19", "F on the companion gain", F * x == J * x - a * (T(h) * x), sizes=["n"], over=FREE, where=[let(F, J - a * T(h))],
      by=[identity(n=range(1, 4)), instances(n=(1, 2, 3))], note="For any vector in place of k*_t, gamma_t being h'k*_t by (2.21), and any J, with F = J - a h' as in (2.23).")
claim("BLM91-E2.24", "what the change of variables does: the filter matrix depends on q alone",
      F - x * T(h) == J - (x + a) * T(h), sizes=["n"], over=FREE, where=[let(F, J - a * T(h))],
      by=[identity(n=range(1, 4)), instances(n=(1, 2, 3))],
      note="The display defines q_t = k_t + a, q*_t = k*_t. Checked is that F - k_t h' then is J - q_t h'.")

STRIPPED = stripped(g + a, g)
AG = {a: vector(n), g: vector(n)}
claim("BLM91-E2.25", "the stripped fast algorithm",
      always(t, (q[t] == fk[t] + a) & (qs[t] == fks[t])), sizes=["n"], over=AG, where=[*FORM, *FAST, *STRIPPED], given=SOME,
      by=[generic_index(lemma(t, (q[t] == fk[t] + a) & (qs[t] == fks[t]), rule=True)), instances(n=(1, 2, 3))])

# ---------------------------------------------------------------------- the polynomials
POLY = (*STRIPPED, *POLYNOMIALS)
claim("BLM91-E2.26", "the polynomials carry the state of the algorithm",
      always(t, (Qp(t) == r[t] * charpoly(J - q[t] * T(h))) & (Qs(t) == r[t] * (charpoly(J - qs[t] * T(h)) - Z**n))), sizes=["n"], over=AG,
      where=[FIRST, *POLY], given=SOME,
      by=[generic_index(*(fact(t, "charpoly", charpoly(J - v[t] * T(h)) == polynomial_of(v[t]), (j, Z ** (n - j))) for v in (q, qs)),
                        uses=[use(v, t=t, z=sym("z")) for v in (0, 1)]), instances(n=(1, 2, 3))],
      note="The display defines Q_t and Q*_t. Checked is another form of the same polynomials, by characteristic polynomials of J - q_t h' and J - q*_t h'.")
NEXT = (Qp(t + 1) == Qp(t) - gam(t) * Z * Qs(t)) & (Qs(t + 1) == Z * Qs(t) - gam(t) * Qp(t))
LEFT = 1 / r[t] * (Qp(t) * recip(Qp(t)) - Qs(t) * recip(Qs(t)))
claim("BLM91-E2.27", "the polynomials obey the Szego recursion",
      always(t, NEXT), sizes=["n"], over=AG, where=POLY, given=SOME,
      by=[generic_index(), instances(n=(1, 2, 3))])
claim("BLM91-S20", "degrees of the polynomials",
      forall(t, 0, m, (degree(Qp(t)) == n) & (degree(Qs(t)) == n - 1)), sizes=["n", "m"], over=AG, where=POLY,
      by=[example(n=1, m=1, a=["-1/2"], g=["1/2"]), instances(n=(1, 2), m=(0, 1, 2))],
      repair=repair("boundary case", "Q*_t has degree n - 1 only as long as gamma_t is not zero: for n = 1, a = -1/2, g = 1/2 it is 1/2 at t = 0 "
                    "and 0 at t = 1; n - 1 is a bound",
                    always(t, (Qp(t) == sum_of(i, 0, n, coeff(Qp(t), n - i) * Z ** (n - i))) & (coeff(Qp(t), n) == r[t])
                           & (Qs(t) == sum_of(i, 1, n, coeff(Qs(t), n - i) * Z ** (n - i))) & (coeff(Qs(t), n - 1) == r[t] * gam(t))),
                    sizes=["n"], over=AG, where=POLY, given=SOME, by=[generic_index(), instances(n=(1, 2, 3))]),
      note="The zero polynomial has degree -1 here.")
claim("BLM91-E2.28", "the invariant pseudo-polynomial",
      always(t, LEFT == D), sizes=["n"], over=AG, where=[*POLY, INVARIANT], given=SOME,
      by=[generic_index(lemma(t, NEXT, direct=True), lemma(t, LEFT == D, in_values=True, uses=[use(0, t=t), use(1, t=t, times=1)]),
                        closed=[Qp, Qs], in_values=True, uses=[use(1, t=t, times=1)]), instances(n=(1, 2, 3))], note="D is the left side at t = 0.")
DENOMINATOR = 1 / (Qp(0) - Qs(0))
BY_RESOLVENT = generic_index(
    RESOLVENT, fact(t, "charpoly", charpoly(F) == Qp(0) - Qs(0), (j, Z ** (n - j))), fact(t, "charpoly", charpoly(F - g * T(h)) == Qp(0), (j, Z ** (n - j))),
    closed=[Qp, Qs], in_values=True, uses=[use(0, t=0, times=DENOMINATOR), use(1, t=0, times=-(1 + TRANSFER) * DENOMINATOR), use(2, t=0, times=DENOMINATOR)])
claim("BLM91-E2.30", "Phi_+ by the initial polynomials",
      rational("1/2") + TRANSFER == rational("1/2") + Qs(0) / (Qp(0) - Qs(0)), sizes=["n"], over=AG, where=[*FORM, *POLY], given=SOME,
      by=[BY_RESOLVENT, instances(n=(1, 2, 3))])

# h_i of (3.4) along an orbit; what a step multiplies r_t by it divides the sums by
ht, num, til, one, u, w, oz, tz, sz = symbols("h_t sums zero one u w one_z zero_z sums_z")
ON_ORBIT = (function(one, [t, i], when(i == 0, 1, q[t][i])), function(til, [t, i], when(i == 0, 0, qs[t][i])),
            function(num, [t, i], sum_of(j, 0, n - i, one(t, j) * one(t, j + i) - til(t, j) * til(t, j + i))), function(ht, [t, i], num(t, i) / num(t, 0)))
KEPT = lemma(t, forall(i, 0, n, r[t] * num(t, i) == num(0, i)), uses=[use(0, t=t, i=i)])
SCALED = (function(oz, [i], when(i == 0, 1, u[i] / Z)), function(tz, [i], when(i == 0, 0, w[i] / Z)),
          function(sz, [i], sum_of(j, 0, n - i, oz(j) * oz(j + i) - tz(j) * tz(j + i))))
claim("BLM91-S21", "n independent first integrals",
      always(t, forall(i, 1, n, ht(t, i) == ht(0, i))) & forall(i, 1, n, laurent(sz(i) / sz(0), 1) == u[i]), sizes=["n"],
      over={u: vector(n), w: vector(n)}, where=[*stripped(u, w), *ON_ORBIT, *SCALED], given=SOME,
      by=[generic_index(KEPT, fact(t, "laurent", forall(i, 1, n, forall(k, 0, 1, laurent(sz(i) / sz(0), k) == when(k == 1, u[i], 0))), 0),
                        uses=[use(0, t=t, i=i), use(0, t=t, i=0), use(1, t=0, i=i, k=1)]), instances(n=(1, 2, 3), horizon=2)],
      note="The n quotients of coefficients of (2.28) keep their values along the orbit of any point (u, w). For the point (u/z, w/z) the quotients are "
           "u_i/z + ..., so that their gradients at the origin are independent.")

# ---------------------------------------------------------------------- positive real data
claim("BLM91-S22", "the filter matrix is stable, with characteristic polynomial Q_t/r_t",
      (charpoly(Fm) == Qm) & schur(Fm), sizes=["n", "m"], over=AG,
      where=[*FORM, *FAST, *POLY, *DATA, let(Fm, F - fk[m] * T(h)), let(Qm, 1 / r[m] * Qp(m))],
      given=REAL,
      by=[steps("BLM91-E2.25", "BLM91-E2.26", "BLM91-E2.27", "BLM91-E2.28", facts=["Rouche's theorem", "Schwarz's lemma"],
                prose="on the circle |Q*_t| < |Q_t| while r_t > 0, so the zeros inside are as many for Q_t as for Q_t - s Q*_t, |s| <= 1; "
                      "Q_0 - Q*_0 = a(z) starts, and Q_(t+1) = Q_t - gamma_t z Q*_t continues; |gamma_t| < 1, so r_(t+1) > 0, because z^n Q_t(1/z) has no zero in the closed disc "
                      "and z^n Q*_t(1/z)/(z^n Q_t(1/z)) = gamma_t z + .. is less than 1 in modulus there"),
          instances(n=(1, 2, 3), m=(0, 1, 2, 3), **CLASSICAL), *EDGE],
      note="m is the time t.")
