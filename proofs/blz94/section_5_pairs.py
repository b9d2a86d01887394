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
from exactkf.evidence import combination, example, identity, instances, steps
from exactkf.language import (
    Z,
    coeff,
    coprime,
    eq,
    forall,
    given,
    hstack,
    iff,
    let,
    matrix_of,
    monic,
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
)
from proofs.blz94.lemmas_tangent import TANGENT, DIMENSION, M, a_, b_, operator, d
from proofs.blz94.notation import D, a, alpha0, b, gamma0, i, j, k, m, monic_of, n, symmetric_part

p, q, u, v, w, x, y, c, e, l, s, theta, epsilon, S = symbols("p q u v w x y c e l s theta epsilon S")


def S_of(f, g):
    """S(f)g."""
    return f * recip(g) + recip(f) * g


# ---------------------------------------------------------------------- the operator
claim("BLZ94-E5.11", "S(a) takes polynomials of degree n to symmetric pseudo-polynomials, linearly, and S(a)b = 2D",
      (recip(S_of(a, v)) == S_of(a, v)) & (S_of(a, v + s * w) == S_of(a, v) + s * S_of(a, w)) & (S_of(a, b) == 2 * D) & (coeff(S_of(a, v), n + 1) == 0), sizes=["n"],
      over={a: monic(n), b: monic(n), v: polynomial(n), w: polynomial(n), s: scalar()}, where=[let(D, symmetric_part(a, b))],
      by=[identity(n=range(1, 7)), instances(n=(1, 2, 3))])

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
      note="The roots of x and their inverses are k pairs; 1 and -1 are roots of multiplicity p and q, which by definition determine pairs of multiplicity p and q. "
           "In the example a = (z - 1)^2, with two such pairs, but the kernel is spanned by z^2 - 1.",
      repair=repair("factor", "A root of multiplicity m at 1 or at -1 contributes m/2, rounded up, and not m.",
                    size_of(S) - rank(S) == k + p + q, sizes=["k", "m", "p", "q"], over={x: monic(k), w: monic(m)},
                    where=[let(a, _ROOTS), let(l, _DEGREE), let(S, operator(a, l + 1, l))], given=[_NO_MORE, _NOT_ZERO, given("simple at 1", p <= 1), given("simple at -1", q <= 1)],
                    by=[steps("BLZ94-X.20", facts=["a polynomial that divides a product and has no root in common with one factor divides the other"],
                              prose="Let theta be the common factor of a and its reversal, a = theta c. If S(a)v = 0, c divides v, for c and its reversal have no common root, and v = cw; "
                                    "then the reversal of w is -epsilon w, and such w have (deg theta)/2 free coefficients if epsilon = 1 and deg theta is even, and so on: "
                                    "one for each pair, and one for a simple root at 1 or at -1."),
                        instances(40, k=(0, 1, 2), m=(0, 1, 2), p=(0, 1, 2), q=(0, 1, 2))]))

# ---------------------------------------------------------------------- the tangent space
claim("BLZ94-S35", "the tangent directions are those that the derivative of f takes to zero",
      iff(rank(hstack(M * vstack(v, -s))) == 0, JAC * v == 0 * v), sizes=["n"], over={**_POINT, v: vector(2 * n), s: scalar()}, where=[*TANGENT, *JACOBIAN],
      by=[])
