# SPDX-License-Identifier: MIT
"""Section 5: the operator S(a), and the tangent space of a level set.

S(a)v = a(z)v(1/z) + a(1/z)v(z) maps polynomials of degree n to symmetric pseudo-polynomials of degree n. Write a = theta c, with theta the
common factor of a(z) and z^n a(1/z); then theta is its own reversal up to a sign, and S(a)v = 0 exactly if v = c w with w its own reversal up to the
opposite sign. So the dimension of the kernel is the number of pairs (s, 1/s) of roots of a, where a root of multiplicity m at 1 or at -1 gives
m/2 pairs, rounded up: a double root at 1 is one pair and not two.

D is half of r S(a)b. Its derivative at (a, b, 1) in the direction (u, v, e) is S(b)u + S(a)(v + e b): the tangent vectors are
the pairs (p, q) = (u, v + e b), of degrees n - 1 and n, with S(a)q + S(b)p = 0.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import combination, example, generic_index, identity, instances, restated, steps, use
from exactkf.language import (
    Z,
    always,
    coeff,
    column,
    coprime,
    eq,
    forall,
    function,
    given,
    hstack,
    iff,
    invertible,
    laurent,
    let,
    matrix_of,
    monic,
    nonzero,
    polynomial,
    rank,
    recip,
    rev,
    scalar,
    size_of,
    standing,
    substitute,
    symbols,
    vector,
    when,
)
from proofs.blz94.lemmas_orbit import FOUR_ALPHA, INVARIANT, NEXT, ONE_STEP
from proofs.blz94.lemmas_tangent import DIMENSION, LINES, TANGENT, K, M, a_, b_, d, operator
from proofs.blz94.notation import (
    FACTORS_T,
    KIMURA,
    ORBIT,
    PI_T,
    PRODUCT_T,
    RHO_T,
    SCALE_T,
    VECTORS,
    D,
    a,
    alpha,
    alpha0,
    apoly,
    b,
    bpoly,
    gamma,
    gamma0,
    i,
    j,
    k,
    m,
    monic_of,
    n,
    r,
    symmetric_part,
    t,
)

p, q, u, v, w, x, y, c, e, l, s, theta, epsilon, S = symbols("p q u v w x y c e l s theta epsilon S")
_POINT = {alpha0: vector(n), gamma0: vector(n)}


def S_of(f, g):
    """S(f)g."""
    return f * recip(g) + recip(f) * g


# ---------------------------------------------------------------------- the operator
claim("BLZ94-E5.11", "S(a) takes polynomials of degree n to symmetric pseudo-polynomials, linearly, and S(a)b = 2D",
      (recip(S_of(a, v)) == S_of(a, v)) & (S_of(a, v + s * w) == S_of(a, v) + s * S_of(a, w)) & (S_of(a, b) == 2 * D) & (coeff(S_of(a, v), n + k) == 0),
      sizes=["n", "k"],
      over={a: monic(n), b: monic(n), v: polynomial(n), w: polynomial(n), s: scalar()}, where=[let(D, symmetric_part(a, b))],
      given=[standing("k >= 1", k >= 1)], by=[generic_index(in_values=[0, 1, 2]), instances(n=(1, 2, 3), k=(1, 2))])

not_checked("BLZ94-D5.R", "pairs of reciprocal roots", "a definition: it fixes notation and asserts nothing",
            note="That a root of multiplicity m at 1 or -1 counts as m pairs is what makes (5.13) and what rests on it false for m = 2.")

# ---------------------------------------------------------------------- Lemma 5.5
claim("BLZ94-X.20", "a factor that is its own reversal up to a sign, and the kernel of S",
      (S_of(theta * c, c * w) == c * recip(c) * S_of(theta, w)) & (Z**m * S_of(theta, w) == theta * (rev(w, m) + epsilon * w)), sizes=["m", "k"],
      over={theta: monic(m), c: polynomial(k), w: polynomial(m), epsilon: scalar()},
      given=[given("reversal", rev(theta, m) == epsilon * theta)],
      by=[combination([[], [(1, "reversal", w)]], m=(1, 2, 3, 4), k=(1, 2, 3)),
          instances(20, m=(2, 4), k=(1, 2), using={y: scalar()},
                    made_by={epsilon: 1, theta: Z**m + y * Z ** (m - 1) + y * Z + 1 }),
          instances(10, m=(1, 3), k=(1, 2), made_by={epsilon: -1, theta: Z**m - 1})],
      note="Let theta be the common factor of a and its reversal, a = theta c, epsilon = 1 or -1.")

claim("BLZ94-X.24", "what S(a)v is divisible by",
      (S_of(x * rev(x, k) * w, v) == x * recip(x) * (Z**k * w * recip(v) + recip(Z**k * w) * v)) & (substitute(S_of((Z - 1) * w, v), 1) == 0)
      & (substitute(S_of((Z + 1) * w, v), -1) == 0), sizes=["m", "k"],
      over={x: polynomial(k), w: polynomial(m), v: polynomial(m)}, by=[identity(m=(0, 1, 2, 3), k=(0, 1, 2, 3)), instances(m=(1, 2), k=(1, 2))],
      note="S(a)v is divisible by x(z)x(1/z) if a is by x and its reversal; and it vanishes at 1 and at -1 if a does, there doubly, being symmetric.")

#: a polynomial with k pairs, roots at 1 and -1 of multiplicity p and q, and no other reciprocal roots
_ROOTS = (Z - 1) ** p * (Z + 1) ** q * x * rev(x, k) * w
_DEGREE = p + q + 2 * k + m
_NO_MORE = given("no more pairs", coprime(w, rev(w, m)))
_NOT_ZERO = standing("the roots of x are not zero", coeff(x, 0) != 0)
_NOT_ONE = standing("nor 1 or -1", substitute(x, 1) * substitute(x, -1) != 0)
claim("BLZ94-L5.5", "the kernel of S(a) has as dimension the number of pairs of reciprocal roots",
      size_of(S) - rank(S) == k + p + q, sizes=["k", "m", "p", "q"], over={x: monic(k), w: monic(m)},
      where=[let(a, _ROOTS), let(l, _DEGREE), let(S, operator(a, l + 1, l))], given=[_NO_MORE, _NOT_ZERO, _NOT_ONE],
      by=[example(k=0, m=0, p=2, q=0, x=[1], w=[1]), instances(k=(0, 1), m=(0, 1), p=(0, 1, 2), q=(0, 1))],
      note="The roots of x and their inverses are k pairs; 1 and -1 are roots of multiplicity p and q, which by definition determine pairs of multiplicity p "
           "and q. "
           "In the example a = (z - 1)^2, with two such pairs, but the kernel is spanned by z^2 - 1.",
      repair=repair("factor", "A root of multiplicity m at 1 or at -1 contributes m/2, rounded up, and not m.",
                    size_of(S) - rank(S) == k + p + q, sizes=["k", "m", "p", "q"], over={x: monic(k), w: monic(m)},
                    where=[let(a, _ROOTS), let(l, _DEGREE), let(S, operator(a, l + 1, l))],
                    given=[_NO_MORE, _NOT_ZERO, given("simple at 1", p <= 1), given("simple at -1", q <= 1)],
                    by=[steps("BLZ94-X.20", facts=["a polynomial that divides a product and has no root in common with one factor divides the other"],
                              prose="Let theta be the common factor of a and its reversal, a = theta c. If S(a)v = 0, c divides v, for c and its reversal "
                                    "have no common root, and v = cw; "
                                    "then the reversal of w is -epsilon w, and such w have (deg theta)/2 free coefficients if epsilon = 1 and deg theta is "
                                    "even, and so on: "
                                    "one for each pair, and one for a simple root at 1 or at -1."),
                        instances(40, k=(0, 1, 2), m=(0, 1, 2), p=(0, 1, 2), q=(0, 1, 2))]))

# ---------------------------------------------------------------------- the tangent space
#: a point (w, y), and a line through it in the direction (u, v) with parameter 1/z, for e = 1
_LINE = (function(x, [e, i], when(i <= n, w[i], y[i - n]) + e * when(i <= n, u[i], v[i - n]) / Z), *LINES[1:], *TANGENT[-3:-2])
_ALONG = {"sizes": ["n"], "over": {w: vector(n), y: vector(n), u: vector(n), v: vector(n)}}
_FIXED = forall(i, 1, n, coeff(d(1, i), -1) * d(0, 0) == d(0, i) * coeff(d(1, 0), -1))
_ON_LEVEL = standing("d_0 != 0", d(0, 0) != 0)
claim("BLZ94-S35", "the tangent space of the level set is the kernel of the derivative of f",
      iff(_FIXED, forall(i, 1, n, (laurent(alpha[1][i], 1) == 0) & (laurent(gamma[1][i], 1) == 0))), **_ALONG,
      where=[*_LINE, let(alpha0, column(i, n, x(1, i))), let(gamma0, column(i, n, x(1, n + i))), *ORBIT], given=[_ON_LEVEL],
      by=[example(n=1, w=["1/2"], y=[0], u=[0], v=[1]), instances(8, n=(1, 2), made_by={u: 0 * w, v: 0 * w})],
      note="f is the map of (5.1). The direction (u, v) at (w, y) is tangent if D stays the same up to a factor, to first order: d' is the coefficient of 1/z "
           "along the line. In the "
           "example (0, 1) is tangent at (1/2, 0), and f takes it to (0, -1/2).",
      repair=repair("other", "It is the Jacobian of (h_1, ..., h_n), not that of f, which has the tangent space as its kernel; f takes the level set to "
                             "itself.",
                    forall(i, 1, n, laurent(2 * d(1, i) / d(1, 0), 1) == 2 * (coeff(d(1, i), -1) * d(0, 0) - d(0, i) * coeff(d(1, 0), -1)) / d(0, 0) ** 2),
                    **_ALONG, where=_LINE, given=[_ON_LEVEL],
                    by=[identity(n=(1, 2, 3)), instances(10, n=(1, 2)),
                        restated("the tangent space of a level set is the kernel of the derivative of the functions that define it")]))

claim("BLZ94-E5.14", "the invariance of D, written with S", always(t, r[t] * S_of(apoly[t], bpoly[t]) == 2 * D[0]), sizes=["n"], over=_POINT,
      where=[*ORBIT, *VECTORS, *RHO_T, *PI_T, *SCALE_T, *FACTORS_T, *PRODUCT_T], given=[standing("n >= 1", n >= 1)],
      by=[generic_index(*ONE_STEP, NEXT, INVARIANT, supported=FOUR_ALPHA["supported"], whole=[alpha, D], closed=[apoly, bpoly], in_values=True, uses=[use(9, t=t, times=2)]),
          instances(n=(1, 2, 3), horizon=3)],
      note="Along (4.4); a_t and b_t belong to (alpha(t), gamma(t)).")

JA, JB = symbols("J_a J_b")
_JACOBIANS = tuple(let(name, matrix_of(i, j, n, 2 * n, coeff(f(j, n - i + 1), 1))) for name, f in ((JA, a), (JB, b)))
claim("BLZ94-X.21", "the derivative of D in (alpha, gamma) and in (a, b)", 2 * K == operator(b_, n) * JA + operator(a_, n) * JB, sizes=["n"], over=_POINT,
      where=[*TANGENT, *_JACOBIANS],
      by=[identity(n=range(1, 5)), instances(8, n=(1, 2))], note="J_a and J_b have the derivatives of the coefficients of z^0, ..., z^(n-1) of a and b.")

claim("BLZ94-L5.6", "the tangent space has the dimension of that of the level set of phi",
      DIMENSION(rank(M)) == 2 * n + 1 - rank(hstack(operator(b_, n), operator(a_, n), column(i, n + 1, coeff(d(0, i - 1), 0)))), sizes=["n"],
      over=_POINT, where=TANGENT,
      given=[standing("gamma_k^2 != 1", forall(k, 1, n, gamma0[k] ** 2 != 1)), _ON_LEVEL],
      by=[steps("BLZ94-X.21", "BLZ94-P4.1", prose="The Jacobian of (alpha, gamma) to (a, b) is invertible, and D is a column of both matrices."),
          instances(10, n=(1, 2, 3)), instances(4, n=(1, 2), made_by={gamma0: 0 * alpha0}), example({alpha0: [1], gamma0: [0]}, n=1),
          example({alpha0: [-3, 1], gamma0: [0, 0]}, n=2)],
      note="phi(a, b, r) = rS(a)b has the derivative S(b)u + S(a)v + e S(a)b at (a, b, 1) in the direction (u, v, e); S(a)b = 2D, a column of which the rank sees the direction only.")

_DIRECTION = {"sizes": ["n"], "over": {a: monic(n), b: monic(n), u: polynomial(n - 1), v: polynomial(n - 1), s: scalar()},
    "given": [standing("n >= 1", n >= 1)]}
claim("BLZ94-L5.7", "the kernel of the derivative of phi is the space of the pairs (p, q)",
      (S_of(u, b) + S_of(a, v) + s * S_of(a, b) == S_of(a, q) + S_of(b, p)) & (eq(coeff(q, n), s)) & (q - coeff(q, n) * b == v) & (p == u)
      & (S_of(a, q) + S_of(b, p) == a * recip(q) + recip(a) * q + b * recip(p) + recip(b) * p), **_DIRECTION,
      where=[let(p, u), let(q, s * b + v)], by=[generic_index(in_values=[0, 4]), instances(n=(1, 2, 3))],
      note="The left side is the derivative of rS(a)b at (a, b, 1) in the direction (u, v, s), so one vanishes if and only if the other does. u, v and s are "
           "found from p and q; s is q_0.")

claim("BLZ94-E5.20", "the difference quotient of phi and its limit",
      ((1 + c * s) * S_of(a + c * u, b + c * v) - S_of(a, b)) / c == S_of(a, q) + S_of(b, p) + c * (S_of(u, v) + s * (S_of(a, v) + S_of(b, u))) + c**2 * s
          * S_of(u, v),
      sizes=["n"], over={**_DIRECTION["over"], c: nonzero()}, given=_DIRECTION["given"], where=[let(p, u), let(q, s * b + v)],
      by=[generic_index(in_values=True), instances(n=(1, 2, 3))],
      note="phi(a, b) is read as phi(a, b, 1): the printed quotient leaves out the third argument of phi. c is the epsilon of the text, and the limit for c "
           "to zero is the left side of (5.17').")

# ---------------------------------------------------------------------- at an equilibrium
claim("BLZ94-E5.21", "the variational equation at an equilibrium, and its solutions",
      (a == monic_of(alpha0)) & (b == a) & (S_of(a, q) + S_of(b, p) == S_of(a, p + q))
          & iff(S_of(a, p + q) == 0, (p == coeff(q, n) * Z**n - q) & (coeff(q, n) == 0)), sizes=["n"],
      over={alpha0: vector(n), p: polynomial(n - 1), q: polynomial(n)}, where=[function(gamma, [k], 0), function(alpha, [k], alpha0[k]), *KIMURA],
      given=[given("ker S(a) = 0", invertible(operator(a, n + 1))), standing("n >= 1", n >= 1)],
      by=[instances(10, n=(1, 2, 3)), instances(6, n=(1, 2), made_by={q: -p}), example({alpha0: [1], p: [1], q: [0, -1]}, n=1),
          example({alpha0: [1], p: [-1], q: [0, 1]}, n=1)])

claim("BLZ94-L5.8", "at an equilibrium without pairs of reciprocal roots the level set is smooth, of dimension n",
      DIMENSION(rank(M)) == n, sizes=["n"], over={alpha0: vector(n)}, where=[let(gamma0, 0 * alpha0), *TANGENT],
      given=[given("no pair of reciprocal roots", coprime(monic_of(alpha0), rev(monic_of(alpha0), n)))],
      by=[steps("BLZ94-X.21", "BLZ94-L5.7", "BLZ94-X.20", facts=["implicit function theorem"],
          prose="S(a) has no kernel by (5.13), which counts no pair here; p = -q leaves n dimensions. "
                "M has rank n + 1, so the differentials of h_1, ..., h_n are independent."),
          instances(10, n=(1, 2, 3)), example({alpha0: [1]}, n=1), example({alpha0: ["-5/2", 1]}, n=2), example({alpha0: [0, 0]}, n=2)])
