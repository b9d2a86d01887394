# SPDX-License-Identifier: MIT
"""Section 6: the fast algorithm converges if and only if the Riccati recursion from zero does.

Along the orbits P_{t+1} - P_t = r_t g(t)g(t)', r_t = 1 - h'P_t h, and (1 - h'P_t h)(a(t) + g(t) - a) = g - FP_t h. If (alpha(t), gamma(t)) tends to
(w, 0), D = r_t S(a_t)b_t/2 makes r_t tend to a number that is not zero, so the product of the 1 - gamma_t^2 converges and with it the sum of the
gamma_t^2 and that of the increments of P_t. If P_t tends to a limit with r = 1 - h'Ph not zero, g(t) tends to zero; and r = 0 would mean g = FPh,
whose last entry is -a_n, so that alpha_n = a_n + g_n = 0.

The last entry of F is -a_n, so F is nonsingular exactly if a_n is not zero; h'F^(-1)g = -g_n/a_n.
The increments are semidefinite of rank one or zero, but of the sign of r_t, which is that of (1 - gamma_0^2) ... (1 - gamma_{t-1}^2).
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, generic_index, induction, instances, lemma, order, restated, steps, use, within
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    always,
    block,
    coeff,
    column,
    degree,
    det,
    forall,
    function,
    given,
    iff,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonsingular,
    nonzero,
    prod,
    psd,
    rank,
    rec,
    scalar,
    sequence,
    standing,
    substitute,
    sum_of,
    sym,
    symbols,
    symmetric,
    symmetric_matrix,
    vector,
    vstack,
    when,
)
from proofs.blz94.notation import (
    FAST,
    HALF,
    KIMURA,
    OBSERVER,
    RICCATI,
    SCALE,
    A,
    D,
    F,
    J,
    P,
    a,
    a0,
    alpha,
    alpha0,
    b,
    g,
    g0,
    gamma,
    h,
    i,
    j,
    k,
    m,
    n,
    phi,
    phis,
    psi,
    psis,
    r,
    symmetric_part,
    t,
)
from proofs.blz94.section_6 import PAIR_A, PAIR_G, PAIR_H, PAIR_P, PAIR_USING, factored
from proofs.blz94.section_6 import E as PAIR_E

B, b0, X, Y, R, S, Gamma, Lambda, beta, delta, l, u, v, w, x, y = symbols("B b0 X Y R S Gamma Lambda beta delta l u v w x y")

claim("BLZ94-S40", "if the last alphas vanish, D has the degree of the last that does not", degree(Z**n * D) == n + k, sizes=["k", "l"],
      over={beta: sequence(1, k), gamma: sequence(0, k + l - 1)},
      where=[let(n, k + l), function(alpha, [i], when(i <= k, beta[i], 0)), *KIMURA, let(D, symmetric_part(a, b))],
      given=[given("alpha_k != 0", beta[k] != 0), given("gamma_k^2 != 1", forall(i, 0, n - 1, gamma[i] ** 2 != 1))],
      by=[steps("BLZ94-S34", "BLZ94-S26", prose="The coefficients of D beyond the k-th vanish, and the k-th is r_{n-k} alpha_k; the algorithm is that of "
                                                "dimension k, for the last k Schur parameters."),
          instances(20, k=(1, 2), l=(0, 1, 2)), example({beta: [0], gamma: [2, 3]}, k=1, l=1), example({beta: [3], gamma: [1, 3]}, k=1, l=1)],
      note="n = k + l; z^n D is a polynomial. That the smaller algorithm is the same is S26. If all alphas vanish, there is no such k, and gamma is zero "
           "after n steps.")

# ---------------------------------------------------------------------- Lemma 6.1
_g1, _f = T(h) * g[t], a[t] + g[t] - a0
_SHIFTED, _UNIT = matrix_of(i, j, n, n, when(j == i + 1, 1, 0)), column(i, n, when(i == 1, 1, 0))
_GAIN = (g0 - F * P[t] * h) / (1 - T(h) * P[t] * h)
_LAMBDA = F * P[t] * T(F) - P[t] + _GAIN * T(g0 - F * P[t] * h)
#: as in (2.17): of J and h nothing is used, so that what follows is for every n
_WORDS = {"sizes": ["n"], "over": {J: matrix(n, n), F: matrix(n, n), h: vector(n), a0: vector(n), g0: vector(n)},
          "where": [rec(P, t, Zero(n, n), F * P[t] * T(F) + _GAIN * T(g0 - F * P[t] * h)), rec(a, t, a0, 1 / (1 - _g1) * (a[t] + (Identity(n) - J) * g[t])),
                    rec(g, t, g0, 1 / (1 - _g1**2) * (-_g1 * a[t] + (J - _g1 * Identity(n)) * g[t])), rec(r, t, Identity(1), (1 - _g1**2) * r[t])],
          "given": [standing("(2.10)", (J == _SHIFTED) & (h == _UNIT) & (F == J - a0 * T(h)))]}
_SYMMETRIC, _SCALED = P[t] == T(P[t]), r[t] == 1 - T(h) * P[t] * h
_INCREMENT = F * P[t] * T(F) + r[t] * _f * T(_f) == P[t] + r[t] * g[t] * T(g[t])
_IN_WORDS = instances(n=(2, 3, 4), horizon=3, made_by={J: _SHIFTED, h: _UNIT, F: _SHIFTED - a0 * T(_UNIT)})
claim("BLZ94-E6.3", "the increment of P is Lambda(P)", Y - P == F * P * T(F) - P + (g0 - F * P * h) / (1 - T(h) * P * h) * T(g0 - F * P * h), sizes=["n"],
      over={F: matrix(n, n), h: vector(n), g0: vector(n), P: symmetric_matrix(n)},
      where=[let(Y, F * P * T(F) + (g0 - F * P * h) * inv(1 - T(h) * P * h) * T(g0 - F * P * h))],
      by=[order(), instances(n=(1, 2, 3))], note="Y is the value of (2.2) after P, for an arbitrary symmetric P.")

claim("BLZ94-E6.4", "from zero the increment is r_t g(t)g(t)'", always(t, (_GAIN == _f) & (_LAMBDA == r[t] * g[t] * T(g[t]))), **_WORDS,
      by=[induction(also=[_SYMMETRIC, _SCALED, _INCREMENT]), _IN_WORDS],
      note="The first equation is (2.17). r_t is the product of the 1 - g_1(k)^2, k < t, as a 1 x 1 matrix.")

claim("BLZ94-E6.5", "r_t is 1 - h'P_t h", always(t, (_GAIN == _f) & (r[t] == 1 - T(h) * P[t] * h)), **_WORDS,
      by=[induction(also=[_SYMMETRIC, _INCREMENT]), _IN_WORDS],
      note="The first equation is (2.17). r_t is the product of the 1 - gamma_k^2, k < t, with gamma_k = g_1(k).")

_ORBITS = {"sizes": ["n"], "over": {a0: vector(n), g0: vector(n)}}
_BOTH = (*FAST, *SCALE, let(F, J - a0 * T(h)), RICCATI[-1], function(X, [t], F * P[t] * T(F) - P[t] + _GAIN * T(g0 - F * P[t] * h)))
claim("BLZ94-S41", "the increments are nonnegative definite of rank one", always(t, psd(X[t]) & (rank(X[t]) == 1)), **_ORBITS, where=_BOTH,
      given=[given("g != 0", g0 != 0 * g0)],
      by=[example({a0: [0], g0: [2]}, n=1), instances(n=(1, 2))],
      note="X_t is Lambda(P_t). In the example g(0) = 2, so r_1 = 1 - 4, and Lambda(P_1) = -16/3. The sentence has no hypothesis on v; the section allows v "
           "that are not positive real.",
      repair=repair("missing hypothesis", "The sign is that of r_t, so definiteness is kept only if all |gamma_t| < 1, and the rank can fall to zero, where "
                                          "g(t) vanishes.",
                    always(t, psd(X[t] / r[t]) & (rank(X[t]) == rank(g[t]))), **_ORBITS, where=_BOTH,
                    by=[steps("BLZ94-E6.4", prose="Lambda(P_t) is r_t g(t)g(t)'."), instances(12, n=(1, 2, 3), horizon=3),
                        instances(4, n=(1, 2), made_by={g0: -a0}),
                        instances(4, n=(1, 2), made_by={a0: 0 * g0})]))

_LAST = a[t][n] + g[t][n]
claim("BLZ94-L6.1.1", "the orbit of the fast algorithm and that of the Riccati recursion from zero, step by step",
      always(t, ((P[t + 1] - P[t]) * _LAST == (a0[n] + g0[n]) * g[t] * T(g[t])) & ((1 - T(h) * P[t] * h) * (a[t] + g[t] - a0) == g0 - F * P[t] * h)
          & (_LAST * (1 - (T(h) * P[t] * h)[1, 1]) == a0[n] + g0[n])),
      **_ORBITS, where=_BOTH[:-1], given=[standing("alpha_n != 0", a0[n] + g0[n] != 0)],
      by=[steps("BLZ94-E2.17", "BLZ94-E6.4", "BLZ94-E6.5", "BLZ94-EA.3", "BLZ94-E2.18", "BLZ94-S42",
          facts=["an infinite product of factors 1 - c_t, c_t >= 0 from some t on, has a limit that is not zero only if the sum of "
                                                                                                "the c_t converges"],
                prose="If (alpha, gamma) tends to (w, 0), (2.18) gives r_t a limit that is not zero, so the sum of gamma_t^2 converges, and with it that of "
                      "the increments of P, since g(t) is a combination "
                      "of gamma_t, ..., gamma_{t+n-1}. If P_t tends to P, r = 1 - h'Ph is not zero by S42, so g(t)g(t)' tends to zero, and a(t) + g(t) to the "
                      "right side of (6.2)."),
          instances(16, n=(1, 2, 3), horizon=3)],
      note="The last entry of alpha(t) is a_n(t) + g_n(t), and r_t alpha_n(t) = alpha_n. That one side converges if and only if the other does is read off "
           "these equations.")

claim("BLZ94-L6.1.2", "the limit polynomial from the limit of P", always(t, a[t] + g[t] == _GAIN + a0), **_WORDS,
      by=[induction(also=[_SYMMETRIC, _SCALED, _INCREMENT]), _IN_WORDS,
          restated("limits: a(t) tends to the limit polynomial, g(t) to zero, and quotients are continuous")],
      note="At every t. If (alpha(t), gamma(t)) tends to (w, 0), a(t) tends to w and g(t) to zero, and (6.2) is the limit, for the right side is continuous where 1 - h'Ph is "
           "not zero (BLZ94-S42).")

claim("BLZ94-S42", "if g = FPh, then alpha_n is a_n(1 - h'Ph)",
      (a0[n] + v[n] == a0[n] * (1 - (T(h) * P * h)[1, 1])) & (v[n] == -(a0[n] * (T(h) * P * h)[1, 1])), sizes=["n"],
      over={a0: vector(n), P: symmetric_matrix(n)}, where=[*OBSERVER, let(v, F * P * h)], given=[standing("n >= 1", n >= 1)],
      by=[generic_index(), instances(n=(1, 2, 3)),
          restated("limits: if P_t converges, its increments tend to zero, and (2.8) tends to the gain of the limit")],
      note="v is the g of the case r_infinity = 1 - h'Ph = 0, where alpha_n = a_n + v_n is zero. The formula for the gain is (2.8) in the limit, and alpha_n "
           "= a_n + g_n is (A-3).")

# ---------------------------------------------------------------------- Lemmas 6.2 and 6.3
f, fs, q, qs, U, V = symbols("f f_star q q_star U V")


def _next(parameters, moved):
    """alpha, entry by entry, and gamma after a step of (4.4), for these Schur parameters."""
    matrix_a = matrix_of(i, j, n, n, when(i > j, 0, when(i == j, 1 / (1 - parameters[n - i] ** 2),
                                                         parameters[n - i] * parameters[n - j] / prod(k, i, j, 1 - parameters[n - k] ** 2))))
    return (function(moved, [t], (matrix_a * column(i, n, alpha[i]))[t]),
            column(i, n, when(i < n, parameters[i], -sum_of(j, 1, n, moved(j) * parameters[n - j]))))


_PLUS, _MINUS = _next(gamma, x), _next(delta, w)
_POINT = {"sizes": ["n"], "over": {alpha: sequence(1, n), gamma: sequence(0, n - 1)}}
#: gamma_n of both, as a sum of no more than k terms
_MOVED = lemma(k, forall(u, k, n - 1, w(k + 1) == x(k + 1)), direct=True, uses=[use(w, k + 1), use(x, k + 1)])
_SUMS = lemma(k, forall(u, k, n, sum_of(j, 1, k, w(j) * delta(n - j)) == -sum_of(j, 1, k, x(j) * gamma[n - j])), uses=[use(3, k=k, u=u), use(2, k=k, u=k)])
claim("BLZ94-S43", "gamma and -gamma: a and b are exchanged, and the orbits differ by the sign of gamma", (U == b) & (V == a) & forall(i, 1, n, w(i) == x(i)) & (y == -R),
      **_POINT,
      where=[*KIMURA, function(delta, [k], -gamma[k]), rec(f, t, 1, Z * f[t] - delta[t] * fs[t]), rec(fs, t, 1, fs[t] - delta[t] * Z * f[t]),
             rec(q, t, 1, Z * q[t] + delta[t] * qs[t]), rec(qs, t, 1, qs[t] + delta[t] * Z * q[t]), let(U, f[n] + sum_of(i, 1, n, alpha[i] * f[n - i])),
             let(V, q[n] + sum_of(i, 1, n, alpha[i] * q[n - i])), _PLUS[0], let(R, _PLUS[1]), _MINUS[0], let(y, _MINUS[1])],
      by=[generic_index(lemma(t, (f[t] == psi[t]) & (fs[t] == psis[t]), rule=True), lemma(t, (q[t] == phi[t]) & (qs[t] == phis[t]), rule=True), _MOVED, _SUMS,
                        closed=[w, x], uses=[use(w, i), use(x, i), use(3, k=n, u=n)]),
          restated("induction on t"), instances(n=(1, 2, 3))],
      note="delta = -gamma; (U, V) are the a and b of (alpha, delta), (w, y) and (x, R) are (alpha, delta) and (alpha, gamma) after one step. The next steps "
           "are the same, so one orbit tends to (w, 0) if and only if the "
           "other does.")

#: (2.10) in blocks, for n = m + 1: the shift with ones above the diagonal, the first unit vector, a and b with their last entries
_A_LAST, _B_LAST = symbols("a_n b_n")
_SHIFT_BLOCKS = (let(J, block([[Zero(m, 1), Identity(m)], [Zero(1, 1), Zero(1, m)]])), let(h, vstack(Identity(1), Zero(m, 1))))
_BLOCKS = (*_SHIFT_BLOCKS, let(a0, vstack(x, _A_LAST * Identity(1))), let(b0, vstack(y, _B_LAST * Identity(1))), let(g0, HALF * (b0 - a0)), let(F, J - a0 * T(h)), let(B, J - b0 * T(h)))
#: brings J - ah' to the triangular form [I, x; 0, a_n]
_TURN = block([[Zero(1, m), -Identity(1)], [Identity(m), Zero(m, 1)]])
claim("BLZ94-L6.2.2", "J - ah' or J - bh' is nonsingular if alpha_n is not zero",
      (alpha0 == HALF * (_A_LAST + _B_LAST)) & ((det(F) == 0) >> invertible(B)),
      sizes=["m"], over={x: vector(m), y: vector(m), _A_LAST: scalar(), _B_LAST: scalar(), alpha0: nonzero()},
      where=_BLOCKS, given=[given("(A-3)", alpha0 == T(vstack(Zero(m, 1), Identity(1))) * (a0 + g0))],
      by=[order([], [], [block([[Zero(1, m), -1 / (2 * alpha0) * Identity(1)], [Identity(m), -1 / (2 * alpha0) * y]])],
                factors=[(F * _TURN, [F, _TURN]), (Identity(m + 1), [_TURN, T(_TURN)])], inside=[within(1, _A_LAST * Identity(1) == Zero(1, 1))]),
          instances(8, m=(0, 1, 2), made_by={_B_LAST: 2 * alpha0 - _A_LAST}), instances(8, m=(0, 1, 2), made_by={_A_LAST: 0, _B_LAST: 2 * alpha0}),
          example({x: [0], y: [1], _A_LAST: 0, _B_LAST: 0, alpha0: 1}, m=1)],
      note="At least one of two is: if the one is singular, that is if its determinant is zero, the other is not. n = m + 1; F = J - ah' and B = J - bh', and "
           "alphabar is alpha_n, which is not zero; it is the last entry of a + g by (A-3), BLZ94-EA.3, with g = (b - a)/2.")

#: y is the last unit vector, of which nothing is used but that it takes the last row of J, which is zero
_LAST_ROW = {"sizes": ["n"], "over": {J: matrix(n, n), h: vector(n), y: vector(n), a0: vector(n), g0: vector(n)}, "where": [let(F, J - a0 * T(h))]}
_NO_LAST_ROW = given("the last row of J is zero", T(y) * J == Zero(1, n))
_OBSERVED = {J: _SHIFTED, h: _UNIT, y: column(i, n, when(i == n, 1, 0))}
claim("BLZ94-X.23", "the last row of F, and h'F^(-1)g", (T(y) * F == -(T(y) * a0) * T(h)) & (T(y) * a0 * T(h) * inv(F) * g0 == -(T(y) * g0)), **_LAST_ROW,
      given=[_NO_LAST_ROW], by=[order(), instances(n=(1, 2, 3), made_by=_OBSERVED), example({J: [[1]], h: [1], y: [1], a0: [2], g0: [1]}, n=1)],
      note="With y the last unit vector: the last row of F is -a_n h', and a_n times h'F^(-1)g is -g_n.")

_G_LAST = sym("g_n")
claim("BLZ94-L6.3", "h'F^(-1)g = 1 if and only if alpha_n = 0", iff(T(h) * inv(F) * g0 == 1, _A_LAST + _G_LAST == 0), sizes=["m"],
      over={x: vector(m), y: vector(m), _A_LAST: scalar(), _G_LAST: scalar()},
      where=[*_SHIFT_BLOCKS, let(a0, vstack(x, _A_LAST * Identity(1))), let(g0, vstack(y, _G_LAST * Identity(1))), let(F, J - a0 * T(h))],
      by=[order(), instances(12, m=(0, 1, 2)), instances(8, m=(0, 1, 2), made_by={_G_LAST: -_A_LAST})],
      note="n = m + 1; F is nonsingular where its inverse exists. alpha_n is a_n + g_n by (A-3).")

_SUM = gamma[n - 1] + sum_of(i, 1, n - 1, alpha[i] * gamma[n - 1 - i])
_AT_ZERO = (*KIMURA, let(a0, column(i, n, coeff(a, n - i))), let(g0, HALF * (column(i, n, coeff(b, n - i)) - a0)), *OBSERVER,
    let(x, HALF - (T(h) * inv(F) * g0)[1, 1]), let(y, _SUM))
_SZEGO = forall(t, 0, n - 1, (gamma[t] == -coeff(phi[t + 1], 0)) & (gamma[t] == coeff(psi[t + 1], 0)))
_ORDER_TWO = (instances(8, n=(1, 2, 3)), instances(6, n=(1, 2), made_by={alpha: (k, when(k == n, 0, gamma[0] + k))}),
    instances(4, n=(1, 2), made_by={gamma: (k, 0)}))
claim("BLZ94-E6.3v", "v(0) in terms of alpha and gamma",
      (x == HALF * substitute(b, 0) / substitute(a, 0)) & _SZEGO & (x == -HALF * (y - alpha[n]) / (y + alpha[n])) & iff(x == -HALF, alpha[n] == 0), **_POINT,
      where=_AT_ZERO,
      by=[example({alpha: ["1/2"], gamma: ["1/4"]}, n=1), instances(n=(1, 2))],
      note="x is 1/2 - h'F^(-1)g, y = gamma_{n-1} + alpha_1 gamma_{n-2} + ... + alpha_{n-1} gamma_0. In the example a(0) = 1/4 and b(0) = 3/4, so v(0) = 3/2, "
           "but the printed quotient is 1/6.",
      repair=repair("sign", "The signs of alpha_n are exchanged: psi_k(0) = gamma_{k-1} and phi_k(0) = -gamma_{k-1}, so numerator and denominator change "
                            "places. The last sentence holds for both.",
                    (x == HALF * substitute(b, 0) / substitute(a, 0)) & _SZEGO & (x == -HALF * (y + alpha[n]) / (y - alpha[n]))
                        & iff(x == -HALF, alpha[n] == 0), **_POINT, where=_AT_ZERO,
                    given=[standing("n >= 1", n >= 1)],
                    by=[*_ORDER_TWO]))

# ---------------------------------------------------------------------- subspaces
_HAT = block([[Zero(n, n), Identity(n)], [-Identity(n), Zero(n, n)]])
claim("BLZ94-S45", "symmetric P makes the span of the columns Lagrangian", (T(vstack(X, Y)) * _HAT * vstack(X, Y) == Zero(n, n)) & (rank(vstack(X, Y)) == n),
      sizes=["n"],
      over={X: nonsingular(n), P: matrix(n, n)}, where=[let(Y, P * X)], given=[given("P is symmetric", P == T(P))],
      by=[order(), instances(10, n=(1, 2, 3), using={S: symmetric_matrix(n)}, made_by={P: S}), example({X: [[1, 0], [0, 1]], P: [[0, 1], [0, 0]]}, n=2)])

#: a, a factor of D and the solution P of (6.1) that belongs to it, and any basis X of the subspace
_COMPANION = factored(_SHIFTED, _UNIT)
_SOLVED = {"using": {**_COMPANION["using"], a0: vector(n), P: matrix(n, n), q: scalar(), B: nonsingular(n)},
           "made_by": {**_COMPANION["made_by"], h: _UNIT, A: _SHIFTED - (a0 + g0) * T(_UNIT), X: B, Y: P * X,
               R: inv(X) * (inv(T(A)) - inv(T(A)) * h * T(h) * P) * X}}
_FIXED = g0 * T(g0) + A * P * inv(Identity(n) - h * T(h) * P) * T(A) == P
claim("BLZ94-S46", "an invariant Lagrangian subspace with nonsingular X is a solution of (6.1)",
      symmetric(P) & invertible(Identity(n) - h * T(h) * P) & _FIXED, sizes=["n"],
      over={A: nonsingular(n), g0: vector(n), h: vector(n), X: nonsingular(n), Y: matrix(n, n), R: nonsingular(n)},
      where=[let(S, block([[inv(T(A)), -(inv(T(A)) * h * T(h))], [g0 * T(g0) * inv(T(A)), A - g0 * T(g0) * inv(T(A)) * h * T(h)]])), let(P, Y * inv(X))],
      given=[given("SU = UR", S * vstack(X, Y) == vstack(X, Y) * R), given("U is Lagrangian", T(X) * Y == T(Y) * X)],
      by=[order(), instances(10, n=(1, 2, 3), **_SOLVED), instances(8, n=(2,), using={**PAIR_USING, B: nonsingular(n)},
                    made_by={A: PAIR_A, g0: PAIR_G, h: PAIR_H, X: inv(T(PAIR_E)) * B, Y: PAIR_P * inv(T(PAIR_E)) * B,
                             R: inv(B) * T(PAIR_E) * (inv(T(A)) - inv(T(A)) * h * T(h) * PAIR_P) * inv(T(PAIR_E)) * B}),
          example(n=2, A=[[2, 0], [0, "1/2"]], gbar=[0, 0], h=[0, 0], X=[[1, 0], [0, 1]], Y=[[0, 1], [0, 0]], R=[["1/2", 0], [0, 2]])],
      note="P = YX^(-1). (6.1) is written as in (6.13), which by (6.11) is the last equation. R is nonsingular as S is.")
