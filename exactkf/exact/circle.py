# SPDX-License-Identifier: MIT
r"""Pseudo-polynomials: Laurent polynomials over Q that do not change under z -> 1/z.

Notation
--------
:math:`D(z) = d_0 + \sum_{k=1}^n d_k (z^k + z^{-k})` is real on the unit circle.
With :math:`x = z + 1/z` it is a polynomial h(x) of degree n, and the circle
becomes the interval [-2, 2]: :math:`e^{\pm i\vartheta}` goes to
:math:`2\cos\vartheta`, and a zero of h at x = 2 or x = -2 is a zero of D at z = 1
or z = -1 of twice the multiplicity.

Choice of algorithm
-------------------
The sign of D on the circle is the sign of h on [-2, 2].  It changes exactly at the
zeros of odd multiplicity inside the interval; the square-free decomposition
sorts zeros by multiplicity and Sturm sequences count them, so no zero is computed.
A matrix test (D is nonnegative exactly when it is a quadratic form with a positive
semidefinite matrix) would need a semidefinite program.

References
----------
U. Grenander, G. Szegő, Toeplitz Forms and Their Applications, section 1.12.
"""

from __future__ import annotations

from itertools import count
from typing import Any, Literal

from flint import fmpq, fmpq_poly

from exactkf.exact._messages import bad
from exactkf.exact.polynomials import SturmSequence, chebyshev_sum, polynomial, reversal, squarefree
from exactkf.exact.rationals import rational

__all__ = ["PseudoPolynomial", "Sign", "sign_on_circle"]

Sign = Literal["positive", "nonnegative", "zero", "nonpositive", "negative", "indefinite"]


class PseudoPolynomial:
    """The pseudo-polynomial d[0] + sum of d[k] (z**k + z**-k).

    Arithmetic (``+ - *``) mixes with rational numbers.  Elements are immutable and hashable.

    Parameters
    ----------
    d : sequence of numbers, fmpz_poly or fmpq_poly
        The coefficients d[0], ..., d[n].

    Raises
    ------
    BadInput
        If a coefficient is not a rational number.

    Examples
    --------
    >>> sign_on_circle(PseudoPolynomial([2, 1]))
    'nonnegative'
    """

    __slots__ = ("d",)

    def __init__(self, d: Any) -> None:
        self.d: fmpq_poly = polynomial(d, name="d")

    @classmethod
    def symmetrized(cls, p: Any, q: Any) -> PseudoPolynomial:
        """Return (p(z) q(1/z) + p(1/z) q(z)) / 2 for polynomials p and q."""
        p, q = polynomial(p), polynomial(q, name="q")
        n = max(p.degree(), q.degree(), 0)
        both = p * reversal(q, n) + reversal(p, n) * q  # z**n times twice the result
        return cls([both[n + k] / 2 for k in range(n + 1)])

    @classmethod
    def modulus_squared(cls, p: Any) -> PseudoPolynomial:
        """Return p(z) p(1/z), which is abs(p)**2 on the circle."""
        return cls.symmetrized(p, p)

    @property
    def degree(self) -> int:
        """The largest k with d[k] != 0; -1 for zero."""
        return self.d.degree()

    def __getitem__(self, k: int) -> fmpq:
        return self.d[abs(k)]

    def in_x(self) -> fmpq_poly:
        """Return the polynomial h with D(z) = h(z + 1/z)."""
        return chebyshev_sum(self.d.coeffs())

    def shifted(self) -> fmpq_poly:
        """Return the polynomial z**n D(z), with n the degree."""
        coeffs = self.d.coeffs()
        return fmpq_poly(coeffs[:0:-1] + coeffs)

    def __call__(self, z: Any) -> fmpq:
        """Return the value at a rational number; BadInput if it is zero."""
        z = rational(z, name="z")
        if z == 0:
            raise bad("z", "is zero", z, "pass a nonzero number")
        return self.in_x()(z + 1 / z)

    def __eq__(self, other: object) -> bool:
        return self.d == other.d if isinstance(other, PseudoPolynomial) else NotImplemented

    def __hash__(self) -> int:
        return hash((PseudoPolynomial, tuple(self.d.coeffs())))

    def __repr__(self) -> str:
        return f"PseudoPolynomial([{', '.join(map(str, self.d.coeffs()))}])"

    def __neg__(self) -> PseudoPolynomial:
        return PseudoPolynomial(-self.d)

    def __add__(self, other: Any) -> PseudoPolynomial:
        return PseudoPolynomial(self.d + (other.d if isinstance(other, PseudoPolynomial) else rational(other)))

    __radd__ = __add__

    def __sub__(self, other: Any) -> PseudoPolynomial:
        return self + -(other if isinstance(other, PseudoPolynomial) else rational(other))

    def __rsub__(self, other: Any) -> PseudoPolynomial:
        return -self + other

    def __mul__(self, other: Any) -> PseudoPolynomial:
        if not isinstance(other, PseudoPolynomial):
            return PseudoPolynomial(self.d * rational(other))
        n = max(self.degree, 0) + max(other.degree, 0)
        full = self.shifted() * other.shifted()
        return PseudoPolynomial([full[n + k] for k in range(n + 1)])

    __rmul__ = __mul__

    def __reduce__(self) -> tuple:
        return PseudoPolynomial, ([str(c) for c in self.d.coeffs()],)


def sign_on_circle(D: Any) -> Sign:
    """Return the sign of a pseudo-polynomial on the unit circle, decided exactly.

    Parameters
    ----------
    D : PseudoPolynomial or sequence of its coefficients d[0], ..., d[n]

    Returns
    -------
    {"positive", "nonnegative", "zero", "nonpositive", "negative", "indefinite"}
        "nonnegative" and "nonpositive" mean that there is a zero on the circle
        but D is not identically zero.

    Raises
    ------
    BadInput
        If a coefficient is not a rational number.
    """
    h = _pseudo(D).in_x()
    if h == 0:
        return "zero"
    two, touches = fmpq(2), h(fmpq(2)) == 0 or h(fmpq(-2)) == 0
    for factor, multiplicity in squarefree(h):
        interior = SturmSequence(factor).count(-two, two) - (factor(two) == 0)
        if interior and multiplicity % 2:
            return "indefinite"
        touches = touches or interior > 0
    value = next(v for v in (h(fmpq(1, k)) for k in count(1)) if v != 0)
    if value > 0:
        return "nonnegative" if touches else "positive"
    return "nonpositive" if touches else "negative"


def _pseudo(D: Any) -> PseudoPolynomial:
    """Return D as a pseudo-polynomial."""
    return D if isinstance(D, PseudoPolynomial) else PseudoPolynomial(D)
