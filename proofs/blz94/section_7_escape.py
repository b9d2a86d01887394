# SPDX-License-Identifier: MIT
"""Section 7: the points that escape.

A step of (4.4) divides by the 1 - gamma_k^2, k = 0, ..., n - 1, and by nothing else. In terms of S: det X_{t+1} is r_1 ... r_t,
up to a power of alpha_n, and r_t is the product of the first t of them.

No equilibrium escapes. So on the line from (alpha, 0) to (alpha, gamma) what a step divides by is not zero at first, and the
polynomials that vanish where the orbit escapes at time t are not zero: the points that escape are a set of measure zero. A point with sign
definite D whose orbit enters the open set P_n of positive real data has a neighbourhood in which all do, and there nothing escapes any more. By the
theorem this is so if the limit has all zeros inside: a and b have no common factor, and D has no zero on the circle, which would be a double one.
What is left, for the closure of the definite points that escape, are these points and the zero sets of two polynomials, the resultant of a, b and the
discriminant of D. They are not zero: a - b is constant for alpha = 0, gamma = (0, ..., 0, x), and D has simple zeros for gamma = 0, alpha = (0, ..., 0, x).
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, generic_index, identity, instances, lemma, steps, use
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    coeff,
    column,
    coprime,
    det,
    exists,
    forall,
    function,
    given,
    iff,
    inv,
    let,
    matrix_of,
    monic,
    nonneg_on_circle,
    outside_roots,
    pos_on_circle,
    prod,
    rec,
    recip,
    scalar,
    schur,
    standing,
    substitute,
    sum_of,
    symbols,
    vector,
    when,
)
from proofs.blz94.notation import (
    HALF,
    ORBIT,
    SHIFT,
    VECTORS,
    D,
    F,
    J,
    a,
    a0,
    a_of,
    alpha,
    alpha0,
    b,
    b0,
    b_of,
    g0,
    gamma,
    gamma0,
    h,
    i,
    j,
    k,
    m,
    monic_of,
    n,
    phi,
    phis,
    psi,
    psis,
    symmetric_part,
    t,
)

A, B, S, X, Y, c, d, e, f, p, q, u, v, w, x, y = symbols("A B S X Y c d e f p q u v w x y")

#: a and g of the point (alpha0, gamma0), by (4.1)
_POINT = (
    rec(phi, k, 1, Z * phi[k] - gamma0[k + 1] * phis[k]), rec(phis, k, 1, phis[k] - gamma0[k + 1] * Z * phi[k]),
    rec(psi, k, 1, Z * psi[k] + gamma0[k + 1] * psis[k]), rec(psis, k, 1, psis[k] + gamma0[k + 1] * Z * psi[k]),
    let(a, phi[n] + sum_of(i, 1, n, alpha0[i] * phi[n - i])), let(b, psi[n] + sum_of(i, 1, n, alpha0[i] * psi[n - i])),
)
_POWERS = (*_POINT, let(a0, column(i, n, coeff(a, n - i))), let(g0, column(i, n, HALF * coeff(b - a, n - i))), *SHIFT, let(B, J - (a0 + g0) * T(h)),
           rec(X, t, Identity(n), inv(T(B)) * (X[t] - h * T(h) * Y[t])), rec(Y, t, Zero(n, n), g0 * T(g0) * inv(T(B)) * (X[t] - h * T(h) * Y[t]) + B * Y[t]))
_ESCAPE = {"sizes": ["n"], "over": {alpha0: vector(n), gamma0: vector(n)}, "where": _POWERS}
_SINGULAR = exists(t, 1, n + 1, det(X[t]) == 0)
claim("BLZ94-S54", "escape corresponds to the two hyperplanes on which the last gamma has modulus one",
      iff(_SINGULAR, gamma0[n] ** 2 == 1), **_ESCAPE, given=[standing("alpha_n != 0", alpha0[n] != 0)],
      by=[example(n=2, alphabar=[0, 2], gammabar=[1, 0]), instances(n=(1, 2))],
      note="X_t is the upper half of S^t(I; 0), so that P_0 = 0; for t <= n + 1 it depends on gamma_0, ..., gamma_{n-1} alone. Later steps are those from a later start, and each brings one new "
           "gamma_{n-1}. So the print is right for the points of U_gamma, gamma_0^2, ..., gamma_{n-2}^2 != 1. But the theorem speaks of points of R^{2n}; in the example n = 2, gamma = (1, 0), (2.16) and "
           "(4.4) divide by zero at once, and D = 4 + 2z^2 + 2z^(-2) is even sign definite.",
      repair=repair("boundary case", "The hyperplanes on which one of the other gammas has modulus one belong to the points that escape too, in the first step.",
                    forall(t, 0, n, det(X[t + 1]) * det(B) ** (t + 1) == prod(k, 1, t, (1 - gamma0[k] ** 2) ** (t + 1 - k))), **_ESCAPE,
                    by=[identity(n=(1, 2, 3)), instances(n=(1, 2, 3))]))
