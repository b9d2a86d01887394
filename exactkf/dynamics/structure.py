# SPDX-License-Identifier: MIT
r"""The linear algebra behind an orbit: `D`, the invariants, `S` and its invariant subspaces.

Main definitions
----------------
``structure``       everything that BLZ94 Sections 5 and 6 attach to a state
``Structure``       the result
``structure_json``  the same as plain data

Main statements
---------------
For the coprime pair of order `m` that is left after reduction, with :math:`Q(0) \ne 0`, `S` has order
`2m`, characteristic polynomial :math:`z^m D / d_m`, and one Jordan block for each eigenvalue, of the
multiplicity of the zero of `D` (`exactkf.kernel.orbit_n`, statement 1).  If `D` keeps one sign on the
circle and `w` is its stable spectral factor, the dominant and codominant `m`-dimensional invariant
subspaces are the kernels of :math:`w_*(z) = z^m w(1/z)/w(0)` and of `w` at `S` (BLZ94 Lemma 6.10).

Each of them is :math:`\operatorname{Im}(I; P)` for one symmetric `P`, and spanned by :math:`v, Sv, \dots, S^{m-1}v` with :math:`v = (h; u)`,
:math:`u = Ph`, which `exactkf.kernel.orbit_structure`, statement 3, derives from `w`.

References
----------
BLZ94 (2.8), (5.5)-(5.9), (6.8), Proposition 6.6, Lemmas 6.7-6.12.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from flint import arb

from exactkf.dynamics.enclosed_limit import EnclosedLimit, for_checker
from exactkf.dynamics.every_order import _case, ball_between
from exactkf.dynamics.exact_json import element_json, field_json, field_of, number_json
from exactkf.dynamics.spectral_factor import factor_json, number_of_choices, spectral_factor
from exactkf.dynamics.zeros import CirclePoint, circle_points, factors, interval_json
from exactkf.exact.numberfield import RealNumber
from exactkf.kernel.linear import Matrix
from exactkf.kernel.orbit_n import spectral_polynomial, spectral_sign
from exactkf.kernel.orbit_structure import SIGNS, subspace, subspace_within
from exactkf.kernel.roots import count_circle, gcd_poly
from exactkf.theory._scalars import Scalar
from exactkf.theory.power_method import symplectic_rows

__all__ = ["JordanBlocks", "Structure", "structure", "structure_json"]

_MOST_CHOICES = 8  # degree up to which the subspaces are written exactly


class JordanBlocks(NamedTuple):
    """`S` has one block of this size for each zero of the polynomial (from z^0 up, monic); these are distinct."""

    polynomial: tuple[Any, ...]
    size: int


@dataclass(frozen=True)
class Structure:
    r"""What belongs to a state.

    Attributes
    ----------
    order : int
        The order `m` of the reduced pair.
    start : int
        The steps that the reduction takes.
    gcd, factor : tuples of numbers
        The greatest common divisor of `a` and `b` at the start, and at that step, from z^0 up.
    d : tuple of numbers, length n + 1
        :math:`d_0, \dots, d_n` of the state itself: a point of projective space.
    kappa : tuple of numbers or None
        :math:`2 d_i / d_0`; None if :math:`d_0 = 0`.
    sign : str
        "positive", "nonnegative", "zero", "nonpositive", "negative" or "indefinite", of `D` of the state itself on the circle.
    circle_zeros : tuple of CirclePoint or None
        The zeros of the same on the circle; those with 2 cos(angle) between -2 and 2 stand for two zeros each. None if it is zero everywhere.
    positive_real : bool
        Whether the state is in the positive real region: `D` is positive on the circle, and `a` and `b`, with what they have in common, are Schur.
    S : Matrix or None, shape (2m, 2m)
        None if ``m = 0``, or if the orbit escapes before the reduction ends.
    jordan : tuple of JordanBlocks
        The Jordan structure of `S`.
    dominant, codominant : tuple of numbers or balls, length m, or None
        The vectors `u` of the header, exact if the data are rational and their field is small; None if there is no `S` or `D` changes sign.
    reduced : tuple of numbers, length m + 1
        What `d` is for the state, of the reduced pair.
    evidence : mapping
        The spectral factor from which they come, for the checker.
    """

    order: int
    start: int
    gcd: tuple[Any, ...]
    factor: tuple[Any, ...]
    d: tuple[Any, ...]
    kappa: tuple[Any, ...] | None
    sign: str
    circle_zeros: tuple[CirclePoint, ...] | None
    positive_real: bool
    S: Matrix | None
    jordan: tuple[JordanBlocks, ...]
    dominant: tuple[Any, ...] | None
    codominant: tuple[Any, ...] | None
    reduced: tuple[Any, ...] = field(default=(), repr=False)
    evidence: Mapping[str, Any] = field(default_factory=dict, repr=False, compare=False)

    def subspace(self, u: Sequence[Any]) -> Matrix:
        """Return :math:`v, Sv, \\dots` in columns for one of the vectors `u`, if it is exact."""
        zero = 0 * u[0]
        columns = [[1 + zero, *[zero] * (self.order - 1), *u]]
        for _ in range(self.order - 1):
            columns.append([sum((x * y for x, y in zip(row, columns[-1], strict=True)), zero) for row in self.S.rows])  # type: ignore[union-attr]
        return Matrix(columns).transpose()


def structure(a: Sequence[Scalar], g: Sequence[Scalar]) -> Structure:
    """Return the structure behind the orbit of a state.

    Parameters
    ----------
    a, g : sequences of rationals or of elements of one `RealField`, length n

    Raises
    ------
    BadInput
        If the lengths differ or an entry is neither rational nor in the field of the others.
    Unsupported
        If zeros of `D` are too close to the circle or to each other.

    Examples
    --------
    >>> found = structure([fmpq(-3, 10)], [fmpq(1, 2)])
    >>> found.kappa, found.sign, found.positive_real
    ((40/79,), 'positive', True)
    """
    case = _case(a, g)
    reduced, D, m = case.reduced, case.D, len(case.reduced.Q) - 1
    whole = spectral_polynomial(case.Q, case.S)
    d, sign = tuple(whole[len(case.a):]), SIGNS[spectral_sign(whole)]
    inside = sign == "positive" and count_circle(case.Q)[0] == len(case.a)
    S: Matrix | None = None
    jordan: tuple[JordanBlocks, ...] = ()
    dominant = codominant = None
    factor: dict[str, Any] = {}
    if m and reduced.escape is None:
        q_m, g_m = reduced.Q[-2::-1], reduced.S[-2::-1]
        S, jordan = Matrix(symplectic_rows(q_m, g_m)), tuple(JordanBlocks(tuple(f), k) for f, k in factors(D))
        if spectral_sign(D) != "+-":
            dominant, codominant, factor = _subspaces(D, q_m)
    return Structure(m, reduced.start, tuple(gcd_poly(case.Q, case.S)), tuple(reduced.removed), d,
                     tuple(2 * x / d[0] for x in d[1:]) if d[0] != 0 else None, sign, None if sign == "zero" else tuple(circle_points(_without_zero(whole))),
                     inside, S, jordan, dominant, codominant, tuple(D[m:]), factor)


def _without_zero(whole: list[Any]) -> list[Any]:
    """A palindrome divided by what powers of z it has."""
    first = next((k for k, c in enumerate(whole) if c != 0), len(whole))
    return whole[first:len(whole) - first]


def _subspaces(D: list[Any], q: list[Any]) -> tuple[tuple[Any, ...], tuple[Any, ...], dict[str, Any]]:
    """The vectors u of the dominant and the codominant subspace, exact or in balls, and the spectral factor for the checker."""
    if not isinstance(D[-1], RealNumber) and number_of_choices(D) <= _MOST_CHOICES:
        factor = spectral_factor(D)
        w = list(factor.coefficients)
        return tuple(subspace(w, q, True)), tuple(subspace(w, q, False)), factor_json(factor)
    enclosed = EnclosedLimit.of(D, [D[-1] / D[-1]])
    found, bits, *_ = enclosed.shown
    (near,) = for_checker([q])
    w = [*reversed(found), (1 << bits, 1 << bits)]
    u, v = (tuple(ball_between(lo, hi, bits) for lo, hi in subspace_within(w, near, bits, dominant)) for dominant in (True, False))
    return u, v, enclosed.evidence


# ---------------------------------------------------------------------- as data
def structure_json(found: Structure) -> dict[str, Any]:
    """Return a structure as plain data.

    Numbers are "p/q" or, over a field, lists of coefficients in its generator; `field` is the field.  In ``circle_zeros`` and the
    subspaces they are as in the limit of an answer.

    Parameters
    ----------
    found : Structure
    """
    over = field_of(*found.d, *found.gcd)

    def listed(values: Sequence[Any] | None) -> list[Any] | None:
        return None if values is None else [element_json(x) for x in values]

    return {
        "field": field_json(over), "order": found.order, "start": found.start, "gcd": listed(found.gcd), "factor": listed(found.factor),
        "d": listed(found.d), "kappa": listed(found.kappa), "sign": found.sign,
        "circle_zeros": None if found.circle_zeros is None else [zero._asdict() for zero in found.circle_zeros], "positive_real": found.positive_real,
        "S": None if found.S is None else [listed(row) for row in found.S.rows],
        "jordan": [{"polynomial": listed(f), "size": k} for f, k in found.jordan],
        "dominant": _numbers(found.dominant), "codominant": _numbers(found.codominant),
    }


def _numbers(u: Sequence[Any] | None) -> list[Any] | None:
    return None if u is None else [interval_json(x) if isinstance(x, arb) else number_json(x) for x in u]
