# SPDX-License-Identifier: MIT
"""Section 5: the dimension of the tangent space at any point of a level set.

W consists of the pairs (p, q) of degrees n - 1 and n with S(a)q + S(b)p = 0. Those with p = 0 are the kernel of S(a); the p that occur are those with
S(b)p in the range of S(a). In x = z + 1/z symmetric pseudo-polynomials of degree n are polynomials of degree n, and the range of S(a) consists of the
multiples of the polynomial whose roots are the values s + 1/s of the pairs (s, 1/s) of roots of a. Two such ranges meet in the multiples of the least
common multiple, and S(b)a = S(a)b shows that not all p in question are of degree n - 1. So dim W = n + sigma, where sigma is the number of common
pairs.

All this counts a root of multiplicity m at 1 or at -1 as m/2 pairs, rounded up. With m in place of that, as the definition before Lemma 5.5 has it,
the dimensions come out wrong when a, or a and b, have a double root there.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, instances, steps
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    block,
    coeff,
    column,
    coprime,
    forall,
    given,
    hstack,
    iff,
    kernel_basis,
    let,
    matrix_of,
    monic,
    nonzero,
    rank,
    recip,
    rev,
    standing,
    substitute,
    symbols,
    top,
    vector,
)
from proofs.blz94.lemmas_tangent import DIMENSION, PARITY, TANGENT, M, a_, b_, coordinates, d, operator, pairs, shared
from proofs.blz94.notation import a, alpha0, b, gamma0, i, j, k, m, n

p, q, v, w, x, y, l, s, S, chi, C, N = symbols("p q v w x y l s S chi C N")
sigma, rho1, rho2, Sa, Sb, Sp = symbols("sigma rho1 rho2 S_a S_b S_p")

_POINT = {alpha0: vector(n), gamma0: vector(n)}
_REGULAR = [standing("gamma_k^2 != 1", forall(k, 1, n, gamma0[k] ** 2 != 1)), standing("d_0 != 0", d(0, 0) != 0)]
_FACTS = ["rank-nullity theorem", "polynomials in z + 1/z have unique factorization"]
_KERNELS = ("By X.20 the kernel of S(a) has as dimension the number of pairs, so counted, and by X.24 the range of S(a) lies in the multiples of the "
            "polynomial in z + 1/z that has the values of the pairs "
            "as roots; these have the same dimension, so they are the range. ")
_MEET = _KERNELS + "The ranges of S(a) and S(b) meet in the multiples of the least common multiple, of degree rho1 + rho2 - sigma, which is at most n + 1. "
_PROJECT = _MEET + "S(b) maps Z onto that intersection, with kernel of dimension rho2; and S(b)a = S(a)b shows that Z is not contained in V_{n-1}. "
_LAST = _PROJECT + "So W has dimension rho1 + n - rho1 + sigma. "
_PAIR = (Z - s) * (Z - 1 / s)


def _made_point(factor, less, count, order):
    """Instances with a = factor v and b = factor w, in the coordinates (alpha, gamma)."""
    entries = [[coeff(factor * y, order - 1 - l) for l in range(order)] for y in (v, w)]
    return instances(count, n=(order,), using={v: monic(n - less), w: monic(n - less), s: nonzero()}, made_by=coordinates(*entries))


_SHARED_POINTS = [_made_point(f, less, 2, order) for f, less,
    order in ((Z - 1, 1, 2), (Z + 1, 1, 2), ((Z - 1) ** 2, 2, 2), (_PAIR, 2, 2), (_PAIR, 2, 3))]
claim("BLZ94-T5.11", "the points where the tangent space is too large are those with a common pair of reciprocal roots",
      iff(DIMENSION(rank(M)) > n, shared(a_, rev(a_, n), b_, rev(b_, n)) > 0), sizes=["n"], over=_POINT, where=TANGENT, given=_REGULAR,
      by=[steps("BLZ94-X.20", "BLZ94-X.21", "BLZ94-X.24", "BLZ94-L5.7", facts=_FACTS, prose=_LAST), instances(8, n=(1, 2)), *_SHARED_POINTS[:-1]],
      note="A point is singular if the tangent space, the common kernel of the differentials of h_1, ..., h_n, has a dimension larger than n. a and b have a "
           "common pair of reciprocal roots if they and their "
           "reversals have a common root.")

_DOUBLE = example({alpha0: [-2, 1], gamma0: [0, 0]}, n=2)
claim("BLZ94-L5.12", "the dimension of the tangent space is n plus the number of common pairs",
      DIMENSION(rank(M)) == n + sigma, sizes=["n"], over=_POINT, where=[*TANGENT, let(sigma, pairs(a_, b_, printed=True))], given=_REGULAR,
      by=[_DOUBLE, instances(8, n=(1, 2)), *_SHARED_POINTS],
      note="In the example a = b = (z - 1)^2, so sigma = 2 by the definition before Lemma 5.5, but the tangent space has dimension 3 and not 4.",
      repair=repair("factor", "A common root of multiplicity m at 1 or at -1 counts as m/2 pairs, rounded up, and not as m.",
                    DIMENSION(rank(M)) == n + sigma, sizes=["n"], over=_POINT, where=[*TANGENT, *PARITY, let(sigma, pairs(a_, b_))], given=_REGULAR,
                    by=[steps("BLZ94-X.20", "BLZ94-X.21", "BLZ94-X.24", "BLZ94-L5.7", facts=_FACTS, prose=_LAST), instances(8, n=(1, 2)), *_SHARED_POINTS,
                        _DOUBLE]))

# ---------------------------------------------------------------------- proof of Lemma 5.12
_BOTH = {a: monic(n), b: monic(n)}
_OPERATORS = (let(Sa, operator(a, n + 1)), let(Sb, operator(b, n + 1)), let(Sp, operator(b, n)))
#: rows that vanish on the range of S(a), and on that alone
_LEFT = (let(N, T(kernel_basis(T(Sa)))),)
_DIM_W = 2 * n + 1 - rank(hstack(Sp, Sa))
_KERNEL = 2 * n + 1 - rank(block([[Sp, Sa], [Identity(n), Zero(n, n + 1)]]))


def _made(factor, less, *orders, other=None, count=3):
    """Instances with a = factor v, b = other w."""
    return instances(count, n=orders, using={v: monic(n - less), w: monic(n - less), s: nonzero()},
        made_by={a: factor * v, b: (factor if other is None else other) * w})


#: simple and double roots at 1 and -1, one or two pairs, of a, of b, of both
_SOME = (instances(6, n=(1, 2, 3)), _made(Z - 1, 1, 1, 2), _made(Z + 1, 1, 1, 2), _made((Z - 1) ** 2, 2, 2, 3), _made((Z + 1) ** 2, 2, 2, 3, other=Z**2 - 1),
    _made(_PAIR, 2, 2, 3),
         _made(_PAIR, 2, 3, other=(Z - 1) ** 2), _made(_PAIR, 2, 3, other=Z**2), _made((Z - 1) * _PAIR, 3, 3, other=(Z + 1) * _PAIR),
         _made((Z - 1) ** 2, 2, 2, other=Z**2 - 2))


def _counted(says, *names, double, note="", wrong="A root of multiplicity m at 1 or at -1 counts as m/2 pairs, rounded up, and not as m.", where=(),
    prose=_KERNELS):
    """Statement, evidence and repair of a claim about numbers of pairs: as printed, and as they must be counted."""
    of = {rho1: (a,), rho2: (b,), sigma: (a, b)}
    common = {"sizes": ["n"], "over": _BOTH}
    return {**common, "where": [*_OPERATORS, *where, *(let(name, pairs(*of[name], printed=True)) for name in names)], "by": [double, *_SOME], "note": note,
            "repair": repair("factor", wrong, says, **common, where=[*_OPERATORS, *where, *PARITY, *(let(name, pairs(*of[name])) for name in names)],
                             by=[steps("BLZ94-X.20", "BLZ94-X.24", facts=_FACTS, prose=prose), *_SOME])}


_TWICE = example(n=2, a=[1, -2, 1], b=[1, -2, 1])
_ONCE = example(n=2, a=[1, -2, 1], b=[0, 0, 1])
claim("BLZ94-E5.27", "the dimensions of W, of the kernel of the projection, and of its range",
      (_DIM_W == _KERNEL + rank(top(kernel_basis(hstack(Sp, Sa)), n))) & (_KERNEL == n + 1 - rank(Sa))
          & (rank(top(kernel_basis(hstack(Sp, Sa)), n)) == n - rank(N * Sp)),
      sizes=["n"], over=_BOTH, where=[*_OPERATORS, *_LEFT],
      by=[steps(facts=["rank-nullity theorem"], prose="The kernel of the projection consists of the (0, q) with S(a)q = 0."), *_SOME],
      note="S_a, S_b are matrices of S(a), S(b) on V_n, S_p that of S(b) on V_{n-1}; the rows of N vanish on the range of S(a) and on nothing else, so NS_p p "
           "= 0 says that S(b)p lies in it.")

_SAYS = (n + 1 - rank(Sa) == rho1) & (n + 1 - rank(Sb) == rho2) & (_KERNEL == rho1)
claim("BLZ94-E5.32", "the kernels of S(a), S(b) and of the projection have as dimensions the numbers of pairs", _SAYS,
      **_counted(_SAYS, rho1, rho2, double=_ONCE, note="In the example a = (z - 1)^2 has two pairs as printed, but the kernel of S(a) has dimension one."))

_RANGE = standing("roots of x", coeff(x, 0) * substitute(x, 1) * substitute(x, -1) != 0)
_FULL = {"sizes": ["k", "m", "p", "q"], "over": {x: monic(k), w: monic(m)},
         "where": [let(a, (Z - 1) ** p * (Z + 1) ** q * x * rev(x, k) * w), let(l, p + q + 2 * k + m), let(S, operator(a, l + 1, l)),
                   let(chi, ((Z - 1) * recip(Z - 1)) ** p * ((Z + 1) * recip(Z + 1)) ** q * x * recip(x)),
                   let(C, matrix_of(i, j, l + 1, l + 1 - (k + p + q), coeff(chi * (Z ** (j - 1) + recip(Z ** (j - 1))), i - 1)))]}
_NO_MORE = given("no more pairs", coprime(w, rev(w, m)))
_ZEROS = (rank(hstack(S, C)) == rank(S)) & (rank(S) == l + 1 - (k + p + q))
claim("BLZ94-S39", "the range of S(a) consists of the pseudo-polynomials that vanish at the pairs of reciprocal roots", _ZEROS, **_FULL,
      given=[_NO_MORE, _RANGE],
      by=[example(k=0, m=0, p=2, q=0, x=[1], w=[1]), instances(k=(0, 1), m=(0, 1), p=(0, 1, 2), q=(0, 1))],
      note="chi has the zeros s, 1/s for each pair, p times 1 and 1, q times -1 and -1; C has a basis of its symmetric multiples of degree l as columns. If "
           "these lie in the range and "
           "have its dimension, they are the range. For a = (z - 1)^2 the range has dimension 2, and the multiples of (z - 1)^2(1/z - 1)^2 have dimension 1.",
      repair=repair("factor", "A root of multiplicity m at 1 or at -1 counts as m/2 pairs, rounded up, and not as m.", _ZEROS, **_FULL,
                    given=[_NO_MORE, standing("roots of x", coeff(x, 0) != 0), given("simple at 1", p <= 1), given("simple at -1", q <= 1)],
                    by=[steps("BLZ94-X.20", "BLZ94-X.24", facts=_FACTS, prose=_KERNELS), instances(40, k=(0, 1, 2), m=(0, 1, 2), p=(0, 1, 2), q=(0, 1, 2))]))

_SAYS = rank(Sa) + rank(Sb) - rank(hstack(Sa, Sb)) == n + 1 - rho1 - rho2 + sigma
claim("BLZ94-E5.35", "the ranges of S(a) and S(b) meet in a space of codimension rho1 + rho2 - sigma", _SAYS,
      **_counted(_SAYS, rho1, rho2, sigma, double=_TWICE, prose=_MEET,
          note="U is a subspace of D_n, which has the dimension n + 1 of V_n, where the text has V_n.",
                 wrong="A root of multiplicity m at 1 or at -1 counts as m/2 pairs, rounded up, and not as m; and it is D_n, not V_n, that U lies in."))

_SAYS = (n + 1 - rank(N * Sb) == n + 1 - rho1 + sigma) & (n - rank(N * Sp) == n - rho1 + sigma)
claim("BLZ94-E5.37", "the dimensions of Z and of the range of the projection", _SAYS,
      **_counted(_SAYS, rho1, sigma, double=_ONCE, where=_LEFT, prose=_PROJECT,
          note="In the example a = (z - 1)^2 and b = z^2, so rho1 = 2 and sigma = 0 as printed, but Z has dimension 2."))

_SAYS = (Sb * column(i, n + 1, coeff(a, i - 1)) == Sa * column(i, n + 1, coeff(b, i - 1))) & (rank(N * Sb) == rank(N * Sp)) & (_DIM_W == n + sigma)
claim("BLZ94-E5.38", "a lies in Z and not in V_{n-1}, and W has dimension n + sigma", _SAYS,
      **_counted(_SAYS, sigma, double=_TWICE, where=_LEFT, prose=_LAST,
          note="Z is the kernel of NS_b, and its part in V_{n-1} that of NS_p, which has one dimension less. The dimension of W drawn from it is wrong if a "
               "and b have a double root at 1."))
