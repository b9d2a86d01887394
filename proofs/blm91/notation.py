# SPDX-License-Identifier: MIT
"""Shared notation of BLM91.

Vectors q and q* of the paper are ``q`` and ``qs``; a star is written ``s`` at
the end of a name. Pseudo-polynomials are written in z and 1/z; on the unit
circle z + 1/z is 2 cos(theta).

A stationary process is handled through its covariances. Random variables are
rows of coefficients over the independent variables x_0, v_0, w_0, v_1, ...;
with their covariance matrix ``G`` the product E{xi eta'} is xi G eta'. For a
proof for every n and every time the coefficients of x_0, v_s and w_s are kept
apart, and E{xi eta'} is a sum over s; an estimate is the row of its weights on
the outputs. The covariance of the state is ``P``;
stationarity makes the noise covariances Q = P - F P F', S = g - F P h,
R = 1 - h' P h. The identities need no nonnegativity, so they are checked for
every symmetric P.
"""

from exactkf.evidence import by_induction, cleared, example, existing, fact, lemma, multiplied, unfolded, valued
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    always,
    block,
    charpoly,
    coeff,
    defined,
    exists,
    function,
    given,
    hstack,
    inv,
    let,
    matrix_of,
    nonzero,
    pos_on_circle,
    positive,
    rational,
    rec,
    recip,
    scalar,
    schur,
    standing,
    sum_of,
    symbols,
    trace,
    vector,
    vstack,
    when,
)

n, m, t, k, j, i, s = symbols("n m t k j i s")

# ---------------------------------------------------------------------- the model (1.1)
F, h, g, P, G, X, V, W, Y = symbols("F h g P G X V W Y")
width = n + (m + 2) * (n + 1)

#: rows of x_t, y_t over the variables x_0, (v_0, w_0), (v_1, w_1), ...
ROWS = (
    function(V, [t], matrix_of(i, j, n, width, when(j == n + t * (n + 1) + i, 1, 0))),
    function(W, [t], matrix_of(i, j, 1, width, when(j == n + t * (n + 1) + n + 1, 1, 0))),
    rec(X, t, hstack(Identity(n), Zero(n, (m + 2) * (n + 1))), F * X[t] + V(t)),
    function(Y, [t], T(h) * X[t] + W(t)),
)


def gram(q, s, r):
    """Covariance of the variables when the noise has covariance [[q, s], [s', r]]."""
    noise = vstack(V(k), W(k))
    return let(G, T(X[0]) * P * X[0] + sum_of(k, 0, m + 1, T(noise) * block([[q, s], [T(s), r]]) * noise))


#: the model with E y_t^2 = 1 and E{x_(t+1) y_t} = g
MODEL = (*ROWS, gram(P - F * P * T(F), g - F * P * h, 1 - T(h) * P * h))

# ---------------------------------------------------------------------- the model by its coefficients, for every n and m
XX0, XV = symbols("X_0 X_v")
#: x_t = X_0[t] x_0 + sum of X_v(s, t) v_s
STATE = (rec(XX0, t, Identity(n), F * XX0[t]),
         function(XV, [s, t], when(t == 0, Zero(n, n), F * XV(s, t - 1) + when(s == t - 1, Identity(n), Zero(n, n)))))
#: noise covariances of a stationary model with E y_t^2 = 1 and E{x_(t+1) y_t} = g
NOISE = (P - F * P * T(F), g - F * P * h, 1 - T(h) * P * h)


def state(t):
    """Coefficients of x_0, v_s and w_s in x_t."""
    return XX0[t], XV(s, t), None


def output(t):
    """Those in y_t = h'x_t + w_t."""
    return T(h) * XX0[t], T(h) * XV(s, t), when(s == t, 1, 0)


def covariance(x, y, noise=NOISE, cov=P, last=m):
    """E{x y'} for noise (v_s, w_s) of covariance [[q, r], [r', w]], s <= ``last``, and x_0 of covariance ``cov``."""
    (x0, xv, xw), (y0, yv, yw), (q, sv, w) = x, y, noise
    each = xv * q * T(yv)
    if yw is not None:
        each = each + yw * (xv * sv)
    if xw is not None:
        each = each + xw * (T(sv) * T(yv))
    if xw is not None and yw is not None:
        each = each + xw * yw * w
    return x0 * cov * T(y0) + sum_of(s, 0, last, each)


#: x_t written out; for `generic_index`
WRITTEN_OUT = (lemma(t, XX0[t] == F**t, rule=True), lemma(t, always(s, XV(s, t) == when(s < t, F ** (t - 1 - s), Zero(n, n))), rule=True))

#: h'(z - F)^(-1) g, by the matrix determinant lemma
TRANSFER = T(h) * inv(Identity(n) * Z - F) * g
RESOLVENT = fact(t, "resolvent", charpoly(F) * TRANSFER == charpoly(F - g * T(h)) - charpoly(F))

# ---------------------------------------------------------------------- Szego polynomials
c, phi, phis, gam, r = symbols("c phi phis gamma r")


def szego(cov, names=(phi, phis, gam, r)):
    """(2.6)-(2.8) for covariances cov(1), cov(2), ..."""
    f, fs, gamma, norm = names
    return (
        rec(f, t, 1, Z * f[t] - gamma(t) * fs[t]),
        rec(fs, t, 1, fs[t] - gamma(t) * Z * f[t]),
        function(gamma, [t], sum_of(k, 0, t, coeff(f[t], k) * cov(k + 1)) / norm[t]),
        rec(norm, t, 1, (1 - gamma(t) ** 2) * norm[t]),
    )


def combined(p, names):
    """Coefficients in p_(t,0) y_0 + .. + p_(t,i) y_i, added up term by term, and those for `covariance`."""
    of_0, of_v, of_w = names

    def sums(before, place):
        return when(i == 0, coeff(p[t], 0) * output(0)[place], before + coeff(p[t], i) * output(i)[place])

    return (function(of_0, [t, i], sums(of_0(t, i - 1), 0)), function(of_v, [t, s, i], sums(of_v(t, s, i - 1), 1)),
            function(of_w, [t, s, i], sums(of_w(t, s, i - 1), 2))), lambda t, i: (of_0(t, i), of_v(t, s, i), of_w(t, s, i))


#: covariances of the model: c_k = h' F^(k-1) g, c_0 = 1
REALIZED = function(c, [k], when(k == 0, 1, (T(h) * F ** (k - 1) * g)[1, 1]))

# ---------------------------------------------------------------------- canonical form (2.22), shift J, fast algorithm
a, J, e, q, qs, Qp, Qs, D = symbols("a J e q qs Q Qs D")
SHIFT = let(J, matrix_of(i, j, n, n, when(j == i + 1, 1, 0)))
FIRST = let(h, matrix_of(i, j, n, 1, when(i == 1, 1, 0)))
CANONICAL = (FIRST, let(F, matrix_of(i, j, n, n, when(j == 1, -a[i], 0) + when(j == i + 1, 1, 0))))


def stripped(start, start_star):
    """(2.25) and (2.8) from given initial values."""
    return (
        SHIFT,
        function(gam, [t], qs[t][1]),
        rec(q, t, start, 1 / (1 - gam(t) ** 2) * (q[t] - gam(t) * (J * qs[t]))),
        rec(qs, t, start_star, 1 / (1 - gam(t) ** 2) * (J * qs[t] - gam(t) * q[t])),
        rec(r, t, 1, (1 - gam(t) ** 2) * r[t]),
    )


#: (2.26)
POLYNOMIALS = (
    function(Qp, [t], r[t] * (Z**n + sum_of(i, 1, n, q[t][i] * Z ** (n - i)))),
    function(Qs, [t], r[t] * sum_of(i, 1, n, qs[t][i] * Z ** (n - i))),
)
#: left side of (2.28), for t = 0
INVARIANT = let(D, 1 / r[0] * (Qp(0) * recip(Qp(0)) - Qs(0) * recip(Qs(0))))


def polynomial_of(v, lead=1):
    """z^n + v_1 z^(n-1) + ... + v_n, or without the first term for lead 0."""
    tail = sum_of(i, 1, n, v[i] * Z ** (n - i))
    return Z**n + tail if lead else tail


# ---------------------------------------------------------------------- positive real data (a, g)
u, w, az, gz, num = symbols("u w a_z g_z N")
SU, SW = sum_of(i, 1, n, abs(u[i])), sum_of(i, 1, n, abs(w[i]))
#: sum |a_i| < 1 and sum |g_i| < (1 - sum |a_i|)/2 give a Schur polynomial a(z) with |g/a| < 1/2 on the circle
CLASSICAL = dict(using={u: vector(n), w: vector(n)}, made_by={a: u / (1 + SU), g: w / (2 * (1 + SU) * (1 + SW))})
REAL = [given("a(z) Schur", schur(az)), given("Popov condition", pos_on_circle(num))]
DATA = (let(az, polynomial_of(a)), let(gz, polynomial_of(g, 0)), let(num, az * recip(az) + gz * recip(az) + recip(gz) * az))
EDGE = [example(n=1, m=3, a=["1/2"], g=["-7/10"]), example(n=1, m=3, a=["-9/10"], g=["93/100"]), example(n=2, m=3, a=[0, "9/10"], g=[0, "-1/2"]),
        example(n=2, m=3, a=["-38/25", "9/10"], g=["4/5", "-9/10"]), example(n=3, m=2, a=[0, 0, "7/8"], g=["1/50", 0, "-7/8"])]
EDGE.append(example(n=2, m=2, a=["2/25", "-9/10"], g=["-4/5", "9/10"]))

# ---------------------------------------------------------------------- n = 1: (alpha_t, gamma_t) = (q_t, q*_t)
al, ga, al0, ga0, pp, s1 = symbols("alpha gamma alpha0 gamma0 p s1")


def scalar_orbit(start, start_star, ga=ga):
    """(2.34), the same as (3.10)."""
    return (rec(al, t, start, al[t] / (1 - ga[t] ** 2)), rec(ga, t, start_star, -ga[t] * al[t] / (1 - ga[t] ** 2)))


#: name of gamma_t of the scalar recursion where the vector recursion stands beside it
ga1 = symbols("gamma1")[0]
ORBIT = scalar_orbit(al0, ga0)
#: points of the curve 1 + alpha^2 - gamma^2 = (p + 1/p) alpha, the part inside the diamond
INSIDE = dict(using={u: scalar(), s1: nonzero()}, made_by={
    pp: u / (1 + abs(u)), al0: pp * ((s1 + s1 / abs(s1)) ** 2 - 1) / ((s1 + s1 / abs(s1)) ** 2 - pp**2),
    ga0: (s1 + s1 / abs(s1)) * (pp**2 - 1) / ((s1 + s1 / abs(s1)) ** 2 - pp**2)})

# ---------------------------------------------------------------------- iterates on a hyperbola, n = 1
kap, lam, Mt, Nt, Ut, sg = symbols("kappa lambda M N U s")
#: 1/kappa from the point
LAMBDA = let(lam, (1 + al0**2 - ga0**2) / (2 * al0))
#: alpha_t = N_t/M_t and gamma_t = s_t gamma_0/M_t, a linear recursion
PROJECTIVE = (rec(Mt, t, 1, 2 * lam * Mt[t] - Nt[t]), rec(Nt, t, al0, Mt[t]), rec(sg, t, 1, -sg[t]))
#: U_0 = 1, U_1 = 2/kappa: sin((t + 1) theta)/sin(theta) for 1/kappa = cos(theta)
CHEBYSHEV = rec(Ut, t, [1, 2 * lam], 2 * lam * Ut[t] - Ut[t - 1])
#: 1/kappa a fraction with |kappa| > 1: its angle is a rational part of pi only for 0, 1/2, -1/2
top, low = symbols("numerator denominator")
AS_FRACTION = let(lam, top / low)
#: the other points of the hyperbola, on lines through (0, 1)
ALPHA_OF = 2 * (lam + u) / (1 - u**2)
GAMMA_OF = 1 + u * ALPHA_OF
#: a point drawn inside a region, and a sign
SHARE = u / (1 + abs(u))
SIGN = s1 / abs(s1)


def leaves(i, ga=ga):
    """The orbit ends with step i: the point at i - 1 exists and the next one does not."""
    return defined(ga[i - 1]) & ~defined(ga[i])

# ---------------------------------------------------------------------- positive real data whose spectral factor is known
x = symbols("x")[0]
dist, r20, dd = symbols("dist r_last d")
SX, XX = sum_of(i, 1, n, abs(x[i])), 1 + sum_of(i, 1, n, x[i] ** 2)
#: c_1 .. c_n of a moving average with weights 1, x_1 .. x_n
WEIGHTS = matrix_of(i, j, n, 1, (x[i] + sum_of(k, 1, n - i, x[k] * x[k + i])) / XX)
#: last squared distance to (x, 0) and last r_t, at t = 20
STEADY = (*stripped(g + a, g), *POLYNOMIALS, *DATA, INVARIANT, let(sg, polynomial_of(x)), let(dd, coeff(D, 0) / coeff(sg * recip(sg), 0)),
          let(dist, trace(T(q[20] - x) * (q[20] - x)) + trace(T(qs[20]) * qs[20])), let(r20, r[20]))
STEADY_GIVEN = [standing("few states", n <= 2), standing("a(z) Schur", schur(az)), given("spectral factor", D == dd * sg * recip(sg)),
                standing("factor well inside", SX <= rational("1/2")), standing("data well inside", dd >= rational("1/4"))]
STEADY_DRAW = dict(using={w: vector(n)}, made_by={
    x: w / (2 * (1 + SW)), a: (WEIGHTS - J * WEIGHTS) / (1 - WEIGHTS[1]), g: (J * WEIGHTS - WEIGHTS[1] * WEIGHTS) / (1 - WEIGHTS[1] ** 2)})
STEADY_OVER = {a: vector(n), g: vector(n), x: vector(n)}

# ---------------------------------------------------------------------- regions of Fig. 2, n = 1
one_, two_, three_, four_ = symbols("I_t II_t III_t IV_t")
#: is the point at time t in region I (|alpha| + |gamma| <= 1), II (|gamma| >= 1 + |alpha|), III, IV (|alpha| >= 1 + |gamma|, |gamma| > 1 or <= 1)
REGIONS = (function(one_, [t], abs(al[t]) + abs(ga[t]) <= 1), function(two_, [t], abs(ga[t]) >= 1 + abs(al[t])),
           function(three_, [t], (abs(al[t]) >= 1 + abs(ga[t])) & (abs(ga[t]) > 1)), function(four_, [t], (abs(al[t]) >= 1 + abs(ga[t])) & (abs(ga[t]) <= 1)))
s2 = symbols("s2")[0]
#: points of the interior of each region, drawn by u (and v > 0, and a sign)
IN_I = dict(using={u: scalar(), s1: nonzero()}, made_by={ga0: u / (1 + abs(u)), al0: s1 / (1 + abs(s1)) * (1 - abs(ga0))})
IN_II = dict(using={u: nonzero(), s1: nonzero()}, made_by={al0: u, ga0: s1 + SIGN * (1 + abs(u))})
IN_III = dict(using={u: positive(), s1: nonzero(), s2: nonzero()}, made_by={ga0: s2 / abs(s2) * (1 + u), al0: s1 + SIGN * (1 + abs(ga0))})
IN_IV = dict(using={u: nonzero(), s1: nonzero()}, made_by={ga0: SHARE, al0: s1 + SIGN * (1 + abs(ga0))})
#: kappa from the point
INSIDE_KAPPA = let(kap, 2 * al0 / (1 + al0**2 - ga0**2))

# ---------------------------------------------------------------------- proofs about orbits for n = 1, as numbers
def values_at(t, *names):
    """The values of recursions at t exist, and are what these say; hints of an `arithmetic`."""
    return [hint(x_, t) for hint in (existing, unfolded) for x_ in names or (al, ga)]


#: the point at t = 1 exists, and comes from that at t = 0
FIRST_STEP = (valued(), cleared(), *values_at(1), *values_at(0))
#: while it exists, an orbit stays on its curve, and alpha_t is not 0 unless alpha_0 is; i is t
STAYS = by_induction(i, 0, defined(al[i]) >> ((al0 * (1 + al[i] ** 2 - ga[i] ** 2) == (1 + al0**2 - ga0**2) * al[i]) & ((al0 != 0) >> (al[i] != 0))),
                     base=[cleared(), *values_at(0)], step=[cleared(), multiplied(ga[i] ** 2), *values_at(i + 1)])

# ---------------------------------------------------------------------- integers
gcd, many = symbols("gcd divides")
#: greatest common divisor of positive integers; k divides t
GCD = function(gcd, [i, j], when(i == j, i, when(i > j, gcd(i - j, j), gcd(i, j - i))))
MANY = function(many, [k, t], exists(i, 1, t, k * i == t))
