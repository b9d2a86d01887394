# SPDX-License-Identifier: MIT
r"""Polynomials in one variable over Q: real roots, and roots about the unit circle.

Functions on python-flint's ``fmpq_poly``.  Every function also accepts what
`polynomial` accepts: a list of coefficients, lowest degree first.

Notation
--------
The reversal of p in degree n is :math:`p^*(z) = z^n p(1/z)`.  A polynomial is
Schur when all its roots lie inside the unit circle.  For a polynomial of even
degree 2m with :math:`p^* = p`, :math:`p(z) = z^m h(z + 1/z)`, and the points
:math:`e^{\pm i\vartheta}` of the circle become the point
:math:`x = 2 \cos\vartheta` of the interval [-2, 2].

Choice of algorithm
-------------------
`count_roots` splits off :math:`g = \gcd(p, p^*)`, which holds the roots on the
circle and the pairs a, 1/a.  The rest has as many roots inside and outside as its
Schur-Cohn matrix has positive and negative eigenvalues, and this inertia is read
off the characteristic polynomial.  The roots of g on the circle are the roots of
h in [-2, 2], counted by Sturm sequences.  For integer polynomials of degree 16,
32 and 60 the Schur-Cohn inertia takes 0.17, 0.96 and 7.4 ms, a Cauchy index after
z = (1 + w)/(1 - w) takes 0.11, 0.38 and 2.0 ms, and complex root isolation, which
cannot tell a root on the circle from one near it, 1.5, 3.8 and 22 ms.  The
Schur-Cohn matrix was kept: it is one matrix, which a certificate can show.
A Sturm sequence of degree 32 takes 0.45 ms.

References
----------
M. Marden, Geometry of Polynomials, 2nd ed., chapter X.  I. Schur, Über
Potenzreihen, die im Innern des Einheitskreises beschränkt sind, J. reine angew.
Math. 148 (1918), 122-145.  S. Basu, R. Pollack, M.-F. Roy, Algorithms in Real
Algebraic Geometry, 2nd ed., chapters 2, 8 and 10.
"""

from __future__ import annotations

from collections.abc import Mapping, Set
from typing import Any, NamedTuple

from flint import fmpq, fmpq_mat, fmpq_poly, fmpz, fmpz_poly

from exactkf.exact._messages import bad, check_count
from exactkf.exact.matrices import inertia
from exactkf.exact.rationals import rational

__all__ = [
    "RealRoot",
    "RootCount",
    "SturmSequence",
    "count_real_roots",
    "count_roots",
    "gcd",
    "is_schur",
    "isolate_real_roots",
    "palindromic_to_x",
    "polynomial",
    "refine_root",
    "reversal",
    "schur_cohn_matrix",
    "squarefree",
]


class RootCount(NamedTuple):
    """Numbers of roots inside, on and outside the unit circle, with multiplicities."""

    inside: int
    on: int
    outside: int


class RealRoot(NamedTuple):
    """A real root: alone in [lo, hi], and in (lo, hi) unless lo == hi; `factor` is its primitive minimal polynomial."""

    lo: fmpq
    hi: fmpq
    multiplicity: int
    factor: fmpq_poly


def polynomial(coefficients: Any, *, floats: str | int | None = None, name: str = "p") -> fmpq_poly:
    """Return the polynomial with the given coefficients, lowest degree first.

    Parameters
    ----------
    coefficients : sequence of numbers, fmpz_poly or fmpq_poly
        Each coefficient is anything `rational` accepts.
    floats : {None, "exact", "decimal"} or int, optional
        What a float coefficient stands for, as in `rational`.
    name : str, optional
        The argument's name in error messages.

    Raises
    ------
    BadInput
        If it is not a sequence of rational numbers.
    """
    if isinstance(coefficients, fmpq_poly):
        return coefficients
    if isinstance(coefficients, fmpz_poly):
        return fmpq_poly(coefficients)
    if isinstance(coefficients, (str, bytes, Mapping, Set)) or not hasattr(coefficients, "__iter__"):
        raise bad(name, "is not a polynomial", coefficients, "pass a list of coefficients, lowest degree first")
    return fmpq_poly([rational(c, floats=floats, name=f"{name}[{k}]") for k, c in enumerate(coefficients)])


def reversal(p: Any, n: int | None = None) -> fmpq_poly:
    """Return z**n p(1/z), with n the degree of p unless given.

    Raises
    ------
    BadInput
        If n is no integer, or less than the degree of p.
    """
    p = polynomial(p)
    n = max(p.degree(), 0) if n is None else n
    check_count("n", n)
    if n < p.degree():
        raise bad("n", f"is less than the degree {p.degree()} of p", n, "pass at least the degree")
    coeffs = p.coeffs()
    return fmpq_poly([0] * (n + 1 - len(coeffs)) + coeffs[::-1])


def gcd(p: Any, q: Any) -> fmpq_poly:
    """Return the monic greatest common divisor, zero if both are zero."""
    return polynomial(p).gcd(polynomial(q, name="q"))


def squarefree(p: Any) -> list[tuple[fmpq_poly, int]]:
    """Return the square-free decomposition: pairwise coprime square-free factors of degree >= 1 and their exponents.

    Raises
    ------
    BadInput
        If p is the zero polynomial.
    """
    return [(factor, exponent) for factor, exponent in _nonzero(p).factor_squarefree()[1] if factor.degree() > 0]


class SturmSequence:
    """The Sturm sequence of the square-free part of a polynomial, for counting its distinct real roots.

    Parameters
    ----------
    p : polynomial, not zero

    Raises
    ------
    BadInput
        If p is the zero polynomial.
    """

    __slots__ = ("chain",)

    def __init__(self, p: Any) -> None:
        first = _nonzero(p).numer()
        first = first // first.gcd(first.derivative()) if first.degree() > 0 else first
        self.chain = [first]
        following = first.derivative()
        while following != 0:
            self.chain.append(following)
            first, following = following, _negated_remainder(first, following)

    def variations(self, x: fmpq | None, at_infinity: int = 1) -> int:
        """Return the number of sign changes at x; if x is None, at plus or minus infinity."""
        if x is None:
            values = [f.leading_coefficient() * at_infinity ** f.degree() for f in self.chain]
        else:
            values = [f(x) for f in self.chain]
        signs = [v > 0 for v in values if v != 0]
        return sum(a != b for a, b in zip(signs, signs[1:], strict=False))

    def count(self, lo: fmpq | None, hi: fmpq | None) -> int:
        """Return the number of distinct real roots in (lo, hi], where None stands for infinity."""
        return self.variations(lo, -1) - self.variations(hi, 1)


def _negated_remainder(p: fmpz_poly, q: fmpz_poly) -> fmpz_poly:
    """Return a positive multiple of -(p mod q), primitive."""
    lead = q.leading_coefficient()
    scale = lead ** (p.degree() - q.degree() + 1)
    r = -((p * abs(scale)) % q)
    return r // r.content() if r != 0 else r


def count_real_roots(p: Any, lo: Any = None, hi: Any = None) -> int:
    """Return the number of distinct real roots of p in the closed interval [lo, hi].

    Parameters
    ----------
    p : polynomial, not zero
    lo, hi : rational numbers, optional
        The ends; None stands for infinity.

    Raises
    ------
    BadInput
        If p is the zero polynomial, or lo > hi.
    """
    p = _nonzero(p)
    lo = None if lo is None else rational(lo, name="lo")
    hi = None if hi is None else rational(hi, name="hi")
    if lo is not None and hi is not None and lo > hi:
        raise bad("lo", f"is greater than hi = {hi}", lo, "exchange the ends")
    return SturmSequence(p).count(lo, hi) + (lo is not None and p(lo) == 0)


def isolate_real_roots(p: Any, width: Any = None) -> list[RealRoot]:
    """Return the real roots of p in increasing order, each alone in an interval.

    Parameters
    ----------
    p : polynomial, not zero
    width : rational number, optional
        Largest length of an interval.

    Returns
    -------
    list of RealRoot
        The closed intervals are disjoint.  A rational root has lo == hi.

    Raises
    ------
    BadInput
        If p is the zero polynomial, or the width is not positive.
    """
    width = None if width is None else rational(width, name="width")
    if width is not None and width <= 0:
        raise bad("width", "is not positive", width, "pass a positive width")
    factors = _nonzero(p).factor()[1]
    rationals = [RealRoot(-f[0] / f[1], -f[0] / f[1], m, f) for f, m in factors if f.degree() == 1]
    irrational = [(f, m) for f, m in factors if f.degree() > 1]
    product = fmpq_poly([1])
    for f, _ in irrational:
        product *= f
    found = list(rationals)
    for lo, hi in _isolate(product):
        f, m = next((f, m) for f, m in irrational if (f(lo) > 0) != (f(hi) > 0))
        root = RealRoot(lo, hi, m, f)
        while any(root.lo <= r.lo <= root.hi for r in rationals) or (width is not None and root.hi - root.lo > width):
            root = _halved(root)
        found.append(root)
    found.sort(key=lambda root: root.lo)
    for i in range(len(found) - 1):  # neighbours from the bisection may share an end
        while found[i].hi >= found[i + 1].lo:
            found[i], found[i + 1] = _halved(found[i]), _halved(found[i + 1])
    return found


def refine_root(root: RealRoot, width: Any) -> RealRoot:
    """Return the same root in an interval no longer than `width`.

    Raises
    ------
    BadInput
        If `root` is no `RealRoot` or the width is not positive.
    """
    if not isinstance(root, RealRoot):
        raise bad("root", "is no RealRoot", root, "pass one that isolate_real_roots returned")
    width = rational(width, name="width")
    if width <= 0:
        raise bad("width", "is not positive", width, "pass a positive width")
    while root.hi - root.lo > width:
        root = _halved(root)
    return root


def _halved(root: RealRoot) -> RealRoot:
    """Return the same root in half the interval; an irrational root is never the midpoint."""
    if root.lo == root.hi:
        return root
    mid = (root.lo + root.hi) / 2
    if (root.factor(mid) > 0) == (root.factor(root.lo) > 0):
        return root._replace(lo=mid)
    return root._replace(hi=mid)


def _isolate(f: fmpq_poly) -> list[tuple[fmpq, fmpq]]:
    """Return intervals that hold one root each of a square-free polynomial without rational roots."""
    if f.degree() < 1:
        return []
    sturm = SturmSequence(f)
    bound = fmpq(2)
    lead = abs(f.leading_coefficient())
    while bound < 1 + max(abs(c) for c in f.coeffs()) / lead:  # Cauchy's bound, as a power of two
        bound *= 2
    todo, done = [(-bound, bound, sturm.variations(-bound), sturm.variations(bound))], []
    while todo:
        lo, hi, v_lo, v_hi = todo.pop()
        if v_lo - v_hi == 1:
            done.append((lo, hi))
        elif v_lo - v_hi > 1:
            mid = (lo + hi) / 2
            v_mid = sturm.variations(mid)
            todo += [(lo, mid, v_lo, v_mid), (mid, hi, v_mid, v_hi)]
    return done


def schur_cohn_matrix(p: Any) -> fmpq_mat:
    """Return the Schur-Cohn matrix of p.

    When p and its reversal have no common factor, it is nonsingular and has as
    many positive eigenvalues as p has roots inside the unit circle.

    Parameters
    ----------
    p : polynomial of degree n, not zero

    Returns
    -------
    fmpq_mat, shape (n, n)
        A A' - B B', with A and B the lower triangular Toeplitz matrices whose
        first columns are p[n], ..., p[1] and p[0], ..., p[n-1].

    Raises
    ------
    BadInput
        If p is the zero polynomial.
    """
    p = _nonzero(p)
    n, c = p.degree(), p.coeffs()
    A = fmpq_mat(n, n, [c[n - i + j] if i >= j else 0 for i in range(n) for j in range(n)])
    B = fmpq_mat(n, n, [c[i - j] if i >= j else 0 for i in range(n) for j in range(n)])
    return A * A.transpose() - B * B.transpose()


def count_roots(p: Any) -> RootCount:
    """Return the numbers of roots of p inside, on and outside the unit circle, with multiplicities.

    Parameters
    ----------
    p : polynomial, not zero

    Raises
    ------
    BadInput
        If p is the zero polynomial.

    Examples
    --------
    >>> count_roots([0, 2, -5, 2])
    RootCount(inside=2, on=0, outside=1)
    """
    p = _nonzero(p)
    at_zero = next(k for k, c in enumerate(p.coeffs()) if c != 0)
    p = fmpq_poly(p.coeffs()[at_zero:])
    common = p.gcd(reversal(p))
    rest = fmpq_poly((p // common).numer())  # integer coefficients keep the matrix small
    n = rest.degree()
    inside = inertia(schur_cohn_matrix(rest)).positive if n else 0
    on = _count_on_circle(common)
    pairs = (common.degree() - on) // 2
    return RootCount(at_zero + inside + pairs, on, n - inside + pairs)


def is_schur(p: Any) -> bool:
    """Return whether all roots of p lie inside the unit circle; a nonzero constant is Schur.

    Raises
    ------
    BadInput
        If p is the zero polynomial.
    """
    p = _nonzero(p)
    return count_roots(p).inside == p.degree()


def _count_on_circle(g: fmpq_poly) -> int:
    """Return the number of roots on the circle of a polynomial equal to its reversal up to sign."""
    g, at_one = _deflated(g, 1)
    g, at_minus_one = _deflated(g, -1)
    two, count = fmpq(2), at_one + at_minus_one
    for factor, multiplicity in squarefree(palindromic_to_x(g)):
        count += 2 * multiplicity * SturmSequence(factor).count(-two, two)  # the ends are not roots any more
    return count


def _deflated(p: fmpq_poly, a: int) -> tuple[fmpq_poly, int]:
    """Return p without its roots a, and how many there were."""
    linear, count = fmpq_poly([-a, 1]), 0
    while p(fmpz(a)) == 0:
        p, count = p // linear, count + 1
    return p, count


def palindromic_to_x(p: Any) -> fmpq_poly:
    """Return h with p(z) = z**m h(z + 1/z) for a polynomial p of even degree 2m equal to its reversal.

    Raises
    ------
    BadInput
        If p is not of this kind.
    """
    p = polynomial(p)
    if p.degree() % 2 and p != 0 or reversal(p) != p:
        raise bad("p", "is not palindromic of even degree", p, "pass p with z**(2m) p(1/z) = p(z)")
    coeffs = p.coeffs()
    return chebyshev_sum(coeffs[len(coeffs) // 2 :])


def chebyshev_sum(d: list[fmpq]) -> fmpq_poly:
    """Return d[0] + sum of d[k] (z**k + z**-k) as a polynomial in x = z + 1/z, by Clenshaw's rule."""
    x, b1, b2 = fmpq_poly([0, 1]), fmpq_poly(), fmpq_poly()
    for c in reversed(d[1:]):
        b1, b2 = c + x * b1 - b2, b1
    return (d[0] if d else 0) + x * b1 - 2 * b2


def _nonzero(p: Any) -> fmpq_poly:
    """Return p as a polynomial, after checking that it is not zero."""
    p = polynomial(p)
    if p == 0:
        raise bad("p", "is the zero polynomial", p, "pass a nonzero polynomial")
    return p
