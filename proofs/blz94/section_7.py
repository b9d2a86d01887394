# SPDX-License-Identifier: MIT
"""Section 7: identities for the convergence theorem.

If an orbit tends to (alpha, 0), D is a multiple of alpha(z)alpha(1/z) and so does not change sign on the circle. Conversely let P be
the solution of the Riccati equation that belongs to the dominant subspace of S, and Gamma its closed loop. A step from Q goes to
P + Gamma (Q - P)(I - hh'(Q - P)/(1 - h'Ph))^(-1) Gamma', which ties the orbit to the powers of Gamma. If D has zeros on the circle, they are
eigenvalues of S with one Jordan block each, of even size for definite D. A common factor of a and b stays in a and b for all times.
"""

from exactkf.claims import claim
from exactkf.evidence import example, generic_index, induction, instances, order, steps
from exactkf.language import (
    Identity,
    T,
    Z,
    coeff,
    column,
    forall,
    given,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    monic,
    nonneg_on_circle,
    nonsingular,
    nonzero,
    outside_roots,
    rec,
    recip,
    scalar,
    sequence,
    standing,
    symbols,
    symmetric_matrix,
    vector,
    vstack,
    when,
)
from proofs.blz94.notation import (
    ORBIT,
    D,
    F,
    P,
    a,
    alpha,
    alpha0,
    b,
    g,
    gamma,
    gamma0,
    h,
    i,
    j,
    k,
    m,
    n,
    symmetric_part,
    t,
    u,
)
from proofs.blz94.section_6_subspaces import S_OF_LOOP

A, E, K, L, N, Q, S, Gamma, Phi, c, p, q, r, s, v, w, x, y, z = symbols("A E K L N Q S Gamma Phi c p q r s v w x y z")

claim("BLZ94-X.2", "the step of the Riccati equation near a solution, on which sufficiency in Theorem 7.1 rests",
      (F * Q * T(F) + (g - F * Q * h) / (1 - T(h) * Q * h) * T(g - F * Q * h))
      == P + Gamma * (Q - P) * inv(Identity(n) - q * h * T(h) * (Q - P)) * T(Gamma), sizes=["n"],
      over={F: matrix(n, n), g: vector(n), h: vector(n), Q: symmetric_matrix(n), L: symmetric_matrix(n), P: symmetric_matrix(n), q: scalar()},
      where=[let(Gamma, F - q * (g - F * P * h) * T(h))],
      given=[given("q is the inverse of 1 - h'Ph", q * (1 - T(h) * P * h) == 1),
             given("(6.1)", F * P * T(F) + q * (g - F * P * h) * T(g - F * P * h) == P)],
      by=[steps("BLZ94-E6.9", "BLZ94-E6.11", facts=["Parlett and Poole: the powers of a matrix take a subspace to the dominant one if it is complementary to the "
                                                   "codominant one"],
                prose="Subtract the equation of P from the step in the form gg' + AQ(I - hh'Q)^(-1)A'. That convergence needs a sign definite D is Corollary 5.3."),
          instances(n=(1,), using={u: scalar(), v: nonzero()},
                    made_by={P: matrix_of(i, j, n, n, 1 - (1 / v - u**2 * v) / (1 - u**2) / v), q: v / ((1 / v - u**2 * v) / (1 - u**2)), h: column(i, n, 1),
                             F: matrix_of(i, j, n, n, u * ((1 / v - u**2 * v) / (1 - u**2) - v) - (1 / v - u**2 * v) / (1 - u**2)),
                             g: column(i, n, u * ((1 / v - u**2 * v) / (1 - u**2) - v))})],
      note="Not printed: one step of the argument for Theorem 7.1.")

claim("BLZ94-X.8", "the solution of the Riccati equation near another one, in closed form",
      forall(t, 0, m, invertible(N[t]) & (K[t] == Phi[t] * inv(N[t]) * T(Phi[t]))), sizes=["n", "m"],
      over={Gamma: matrix(n, n), h: vector(n), E: nonsingular(n), q: scalar(), c: sequence(0, m - 1)},
      where=[rec(K, t, E, Gamma * K[t] * (Identity(n) + c[t] * h * T(h) * K[t]) * T(Gamma)), rec(Phi, t, Identity(n), Gamma * Phi[t]),
             rec(N, t, inv(E), N[t] - q * T(Phi[t]) * h * T(h) * Phi[t])],
      given=[standing("E is symmetric", E == T(E)), given("c_k (1 - q h'K_kh) = q", forall(k, 0, m - 1, c[k] * (1 - q * T(h) * K[k] * h) == q))],
      by=[example({Gamma: [[2]], h: [1], E: [[1]], q: 1, c: []}, n=1, m=0), induction(step=order([inv(N[t]) + c[t] * inv(N[t]) * T(Phi[t]) * h * T(h) * Phi[t] * inv(N[t])], [])),
          instances(n=(1, 2), m=(1, 2, 3), using={L: symmetric_matrix(n)}, made_by={E: L + 10 * Identity(n), c: (k, q / (1 - q * T(h) * Phi[k] * inv(N[k]) * T(Phi[k]) * h))})],
      note="Not printed. K_t is P_t - P, as its step by X.2 is K(I - qhh'K)^(-1) between Gamma and Gamma', and I + chh'K is that inverse. Phi_t is Gamma^t and N_t is "
           "the inverse of P_0 - P less q times the sum of the Gamma'^k hh' Gamma^k, k < t.")

_ROTATION = matrix_of(i, j, n, n, when(i == j, (1 - p**2) / (1 + p**2), when(i < j, 2 * p / (1 + p**2), -2 * p / (1 + p**2))))
_SIMILARITY = matrix_of(i, j, n, n, when(i == j, q, when(i < j, r, -r)))
#: n = 2, with (u, v) = M = qI + rJ for (x, y) = I, and g and A from h; and n = 1, lambda = 1
_PAIR = {"using": {p: scalar(), q: scalar(), r: scalar()},
         "made_by": {c: (1 - p**2) / (1 + p**2), s: 2 * p / (1 + p**2), x: column(i, n, when(i == 1, 1, 0)), y: column(i, n, when(i == 1, 0, 1)),
                     u: column(i, n, when(i == 1, q, -r)), v: column(i, n, when(i == 1, r, q)), g: _ROTATION * T(_SIMILARITY) * h,
                     A: _ROTATION * (Identity(n) - T(_SIMILARITY) * h * T(h))}}
_REAL = {"using": {p: nonzero(), q: scalar()},
         "made_by": {c: 1, s: 0, x: column(i, n, p), u: column(i, n, p * q), y: 0 * h, v: 0 * h, g: q * h, A: Identity(n) - q * h * T(h)}}
claim("BLZ94-X.13", "an eigenvector of S to an eigenvalue on the circle is seen by h as much as by g",
      T(u) * h * T(h) * u + T(v) * h * T(h) * v == T(x) * g * T(g) * x + T(y) * g * T(g) * y, sizes=["n"],
      over={A: nonsingular(n), g: vector(n), h: vector(n), x: vector(n), y: vector(n), u: vector(n), v: vector(n), c: scalar(), s: scalar()},
      where=[S_OF_LOOP],
      given=[given("real part of S(x + iy; u + iv) = lambda(x + iy; u + iv)", S * vstack(x, u) == c * vstack(x, u) - s * vstack(y, v)),
             given("imaginary part", S * vstack(y, v) == s * vstack(x, u) + c * vstack(y, v)), given("lambda is on the circle", c**2 + s**2 == 1)],
      by=[order(), instances(16, n=(2,), **_PAIR), instances(8, n=(1,), **_REAL),
          example(n=1, A=[["5/2"]], g=[1], h=[1], x=[1], y=[0], u=[-4], v=[0], c=2, s=0),
          example(n=1, A=[[1]], g=[1], h=[2], x=[1], y=[0], u=[1], v=[0], c=1, s=0), example(n=1, A=[[1]], g=[1], h=[2], x=[0], y=[1], u=[0], v=[1], c=1, s=0)],
      note="Not printed. lambda = c + is. If h'(u + iv) = 0, then g'(x + iy) = 0 as well, hence A(u + iv) = lambda(u + iv) and A'(x + iy) = (x + iy)/lambda, "
           "and both vectors are zero if (h, A) is observable and (A, g) reachable. So an eigenvalue on the circle has one eigenvector only, up to factors, "
           "and one Jordan block of the size of its multiplicity, "
           "as the proof of Lemma 6.10 assumes.")

claim("BLZ94-X.1", "a multiple of w(z)w(1/z) does not change sign on the circle", nonneg_on_circle(D) | nonneg_on_circle(-D), sizes=["n"],
      over={a: monic(n), b: monic(n), w: monic(n), c: scalar()}, where=[let(D, symmetric_part(a, b))],
      given=[given("D = c w(z)w(1/z)", D == c * w * recip(w))],
      by=[steps(facts=["a number times its conjugate is not negative"], prose="On the circle w(1/z) is the conjugate of w(z)."),
          example(n=1, a=[2, 1], b=[-2, 1], w=[0, 1], c=-3), example(n=1, a=[2, 1], b=[2, 1], w=[1, 1], c=1),
          instances(n=(1, 2), made_by={a: w, b: w, c: 1}), instances(n=(1, 2))])

claim("BLZ94-X.3", "a common factor of a and b goes through a step",
      (symmetric_part(u * w, v * w) == symmetric_part(u, v) * w * recip(w))
      & ((u * w + v * w) - x * Z * (v * w - u * w) == ((u + v) - x * Z * (v - u)) * w)
      & (Z * (v * w - u * w) - x * (u * w + v * w) == (Z * (v - u) - x * (u + v)) * w)
      & (coeff(v * w - u * w, n + k - 1) == coeff(v - u, n - 1)), sizes=["n", "k"], over={u: monic(n), v: monic(n), w: monic(k), x: scalar()},
      by=[generic_index(in_values=True), instances(n=(1, 2), k=(1, 2))],
      note="Q = a + b and Q* = b - a move by (7.4) with the same gamma_t for (a, b) and for the pair without the factor, as the last equation says; so a_t "
           "and b_t keep it, and the limit is that of the reduced orbit times the factor.")

claim("BLZ94-E7.1", "(7.1) determines the factor with zeros in the closed disc", u == w, sizes=["n"], over={u: monic(n), w: monic(n), r: nonzero()},
      given=[given("same product", u * recip(u) == r * w * recip(w)), given("u has no zero outside", outside_roots(u) == 0),
             given("w has no zero outside", outside_roots(w) == 0)],
      by=[steps(facts=["a polynomial has one factorization into linear ones"], prose="The zeros of w(z)w(1/z)z^n are those of w and their inverses; those inside belong to w, those on "
                                                                                  "the circle have even multiplicity and belong to w half."),
          example(n=1, u=[2, 1], w=["1/2", 1], r=4), example(n=1, w=[2, 1], u=["1/2", 1], r="1/4"), example(n=1, u=["1/2", 1], w=["1/3", 1], r=1),
          instances(n=(1, 2), made_by={u: w, r: 1})],
      note="r_infinity is read as what the theorem calls it, a factor left undetermined. It is not the limit of r_t, which has the same letter in (5.4) and (8.8): "
           "with that, a factor of two is missing on the right of (7.1a). The marks over b, which (7.1b) explains, are lost in (7.1a).")

claim("BLZ94-X.4", "every (alpha, 0) is a fixed point", (alpha[1] == alpha0) & (gamma[1] == 0 * alpha0), sizes=["n"], over={alpha0: vector(n)},
      where=[let(gamma0, 0 * alpha0), *ORBIT], by=[generic_index(), instances(n=(1, 2, 3))],
      note="Not printed: the part of Corollary 7.2 that no limit enters.")
