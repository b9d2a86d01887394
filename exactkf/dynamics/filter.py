# SPDX-License-Identifier: MIT
r"""A filter as a user gives it, made exact.

A filter of order n is the pair of a monic polynomial a(z) of degree n and a vector g, the
parameters of :math:`v(z) = b(z)/(2a(z)) = \tfrac12 + c_1 z^{-1} + c_2 z^{-2} + \dots`
with :math:`b = a + 2g(z)`, :math:`g(z) = g_1 z^{n-1} + \dots + g_n` (BLZ94 (2.3)-(2.10)).  The same
filter has the Kimura-Georgiou coordinates :math:`(\alpha, \gamma)` wherever these exist, the
covariances :math:`1, c_1, c_2, \dots`, and realizations :math:`c_k = h'F^{k-1}g` in any basis.
Nothing makes sure that the data come from a stochastic system.

Main definitions
----------------
``Filter``                    the exact filter, with its other coordinates
``Filter.from_polynomials``   from b and a
``Filter.from_ag``            from a and g
``Filter.from_parameters``    from alpha and gamma
``Filter.from_covariances``   from 1, c_1, c_2, ...
``Filter.from_realization``   from F, g, h in any basis
``Filter.from_state_space``   from an object with matrices A, B, C, D, such as `control.StateSpace`

Notation
--------
Vectors list :math:`a_1, \dots, a_n`; matrices are lists of rows or anything with ``tolist``.  Each
number is what `exactkf.dynamics.number` reads.  All entries are `fmpq`, or elements of one `RealField`.

References
----------
BLZ94 (2.3)-(2.10), (3.12); BLM91 (2.1)-(2.8).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence, Set
from dataclasses import dataclass
from typing import Any

from flint import fmpq

from exactkf._errors import BadInput
from exactkf.dynamics.numbers import Number, number
from exactkf.exact._messages import bad
from exactkf.exact.compositum import together
from exactkf.exact.numberfield import RealField, RealNumber
from exactkf.theory._matrices import solved
from exactkf.theory.fast_filter import ag_from_alpha_gamma, alpha_gamma_from_ag
from exactkf.theory.kimura_georgiou import laurent_covariances

__all__ = ["Filter"]

Vector = tuple[Number, ...]
Floats = str | int | None


@dataclass(frozen=True)
class Filter:
    """An exact filter.

    Parameters
    ----------
    a, g : tuples of n numbers
        Coefficients of a(z) below the leading one, and the vector g.
    field : RealField or None
        The field of all numbers; None for the rationals.
    """

    a: Vector
    g: Vector
    field: RealField | None = None

    def __post_init__(self) -> None:
        """Refuse what is not exact: the ways in below read other numbers."""
        for name, vector in (("a", self.a), ("g", self.g)):
            if not isinstance(vector, tuple) or not all(isinstance(x, (fmpq, RealNumber)) for x in vector):
                raise bad(name, "is no tuple of fmpq or RealNumber", vector, "use Filter.from_ag, which reads other numbers")
        if not self.a or len(self.a) != len(self.g):
            raise bad("g", f"has length {len(self.g)} where a has {len(self.a)}", _plain(self.g), "pass vectors of the same length, at least 1")
        if not (self.field is None or isinstance(self.field, RealField)):
            raise bad("field", "is no RealField", self.field, "pass a RealField or None")

    @property
    def order(self) -> int:
        """The degree n of a(z)."""
        return len(self.a)

    @property
    def b(self) -> Vector:
        """Coefficients of b(z) below the leading one: a + 2 g."""
        return tuple(x + 2 * y for x, y in zip(self.a, self.g, strict=True))

    def parameters(self) -> tuple[Vector, Vector] | None:
        """The coordinates (alpha, gamma), or None where a Toeplitz matrix up to size n is singular."""
        try:
            return alpha_gamma_from_ag(self.a, self.g)
        except BadInput:
            return None

    def covariances(self, count: int) -> Vector:
        """The covariances c_1, ..., c_count."""
        return laurent_covariances(self.a, self.b, count)

    # ------------------------------------------------------------------ ways in
    @classmethod
    def from_ag(cls, a: Iterable[Any], g: Iterable[Any], *, floats: Floats = None) -> Filter:
        """From a_1..a_n and g_1..g_n.

        Raises
        ------
        BadInput
            If the lengths differ or are zero, an entry is no exact number, or g_1^2 = 1.

        Examples
        --------
        >>> Filter.from_ag(["1/2"], ["0.25"]).b
        (1,)
        """
        (a, g), field = _exact(floats, a=a, g=g)
        if len(a) != len(g):
            raise bad("g", f"has length {len(g)} where a has {len(a)}", _plain(g), "pass vectors of the same length")
        return cls._checked(a, g, field)

    @classmethod
    def from_polynomials(cls, b: Iterable[Any], a: Iterable[Any], *, floats: Floats = None) -> Filter:
        """From the coefficients of b(z) and a(z), leading one first, v = b/(2a).

        Raises
        ------
        BadInput
            If a or b is not monic, or the degrees differ.

        Examples
        --------
        >>> Filter.from_polynomials([1, 1], [1, "1/2"]).g
        (1/4,)
        """
        (b, a), field = _exact(floats, b=b, a=a)
        if len(a) != len(b):
            raise bad("b", f"has degree {len(b) - 1} where a has degree {len(a) - 1}", _plain(b), "pass polynomials of the same degree")
        for name, p in (("a", a), ("b", b)):
            if p[0] != 1:
                raise bad(name, "is not monic", _plain(p), "divide by the leading coefficient: v(z) tends to 1/2")
        return cls._checked(a[1:], tuple((x - y) / 2 for x, y in zip(b[1:], a[1:], strict=True)), field)

    @classmethod
    def from_parameters(cls, alpha: Iterable[Any], gamma: Iterable[Any], *, floats: Floats = None) -> Filter:
        """From alpha_1..alpha_n and gamma_0..gamma_{n-1} (BLZ94 (3.12)).

        Raises
        ------
        BadInput
            If the lengths differ or some gamma_k is 1 or -1.

        Examples
        --------
        >>> Filter.from_parameters([2], ["1/2"]).a
        (3/2,)
        """
        (alpha, gamma), field = _exact(floats, alpha=alpha, gamma=gamma)
        if len(alpha) != len(gamma):
            raise bad("gamma", f"has length {len(gamma)} where alpha has {len(alpha)}", _plain(gamma), "pass vectors of the same length")
        for k, x in enumerate(gamma):
            if x * x == 1:
                raise bad(f"gamma[{k}]", "is 1 or -1", str(x), "a Schur parameter of the start must differ from both")
        a, g = ag_from_alpha_gamma(alpha, gamma)
        return cls._checked(a, g, field)

    @classmethod
    def from_covariances(cls, c: Iterable[Any], *, order: int | None = None, floats: Floats = None) -> Filter:
        """From 1, c_1, c_2, ..., c_m: the filter of order n whose first 2n covariances they are.

        Parameters
        ----------
        c : covariances, beginning with 1
        order : int, optional
            n; half the number of covariances after the first by default. Further covariances must agree.

        Raises
        ------
        BadInput
            If the first is not 1, there are too few, the Hankel matrix is singular, or the others disagree.

        Examples
        --------
        >>> Filter.from_covariances([1, "1/2", "1/4"])
        Filter(a=(-1/2,), g=(1/2,), field=None)
        """
        (c,), field = _exact(floats, covariances=c)
        if not c or c[0] != 1:
            raise bad("covariances", "does not begin with 1", _plain(c), "divide by c_0")
        n = (len(c) - 1) // 2 if order is None else order
        if isinstance(n, bool) or not isinstance(n, int) or (order is not None and n < 1):
            raise bad("order", "is no order", order, "pass a positive integer")
        if n < 1 or len(c) <= 2 * n:
            after = f"has {len(c) - 1} covariance{'s' * (len(c) != 2)} after the first"
            raise bad("covariances", f"{after}, too few for order {max(n, 1)}", _plain(c), f"pass at least {max(2 * n, 2)} after the 1")
        hankel = tuple(tuple(c[i + j + 1] for j in range(n)) for i in range(n))
        try:
            reversed_a = solved(hankel, tuple((-c[n + 1 + i],) for i in range(n)), "the Hankel matrix of the covariances")
        except BadInput:
            raise bad("covariances", f"has a singular Hankel matrix of size {n}", _plain(c), "pass a smaller order") from None
        a = tuple(row[0] for row in reversed(reversed_a))
        g = tuple(c[k] + sum((a[i] * c[k - 1 - i] for i in range(k - 1)), 0 * c[k]) for k in range(1, n + 1))
        made = cls._checked(a, g, field)
        if made.covariances(len(c) - 1) != tuple(c[1:]):
            raise bad("covariances", f"is not the covariance sequence of a filter of order {n}", _plain(c),
                      "pass a larger order or the first 2n covariances only")
        return made

    @classmethod
    def from_realization(cls, F: Any, g: Any, h: Any, *, floats: Floats = None) -> Filter:
        """From matrices with c_k = h'F^{k-1}g, in any basis.

        Parameters
        ----------
        F : n x n
        g, h : vectors of length n, or matrices of one column or row

        Raises
        ------
        BadInput
            If the sizes do not fit.

        Examples
        --------
        >>> Filter.from_realization([["1/2"]], [1], ["1/2"]).a
        (-1/2,)
        """
        rows, g, h = _rows("F", F), _vector("g", g), _vector("h", h)
        n = len(rows)
        if any(len(row) != n for row in rows):
            raise bad("F", "is not square", rows, "pass n rows of n numbers")
        for name, v in (("g", g), ("h", h)):
            if len(v) != n:
                raise bad(name, f"has length {len(v)} where F has {n} rows", v, "pass a vector that fits")
        (g, h, *exact), field = _exact(floats, g=g, h=h, **{f"F[{i}]": row for i, row in enumerate(rows)})
        a, numerator = _leverrier(exact, g, h)
        return cls._checked(a, numerator, field)

    @classmethod
    def from_state_space(cls, system: Any, *, floats: Floats = None) -> Filter:
        """From an object with matrices A, B, C, D of one input and one output.

        Its transfer function D + C(zI - A)^{-1}B is divided by 2D, so that it tends to 1/2: with D = 1/2 it is
        taken as it stands.

        Raises
        ------
        BadInput
            If there is more than one input or output, D = 0, an entry is a float without a rule, or the time is continuous (dt = 0).
        """
        A, B, C, D = (getattr(system, name, None) for name in "ABCD")
        if any(x is None for x in (A, B, C, D)):
            raise bad("system", "has no matrices A, B, C, D", system, "pass a state space object")
        if isinstance(dt := getattr(system, "dt", None), (int, float)) and dt == 0:
            raise bad("system", "is of continuous time (dt = 0)", system, "pass one of discrete time, StateSpace(A, B, C, D, True)")
        B, C, D = _vector("B", B), _vector("C", C), _vector("D", D)
        if len(D) != 1 or len(B) != len(C):
            raise bad("D", "belongs to several inputs or outputs", D, "pass a system with one of each")
        d = number(D[0], floats=floats, name="D")
        if d == 0:
            raise bad("D", "is zero", D[0], "pass v(z) with a direct term: v(z) tends to 1/2")
        g = [number(x, floats=floats, name=f"B[{k}]") for k, x in enumerate(B)]
        return cls.from_realization(A, [x / (2 * y) for x, y in (together([x, d])[0] for x in g)], C, floats=floats)

    @classmethod
    def _checked(cls, a: Sequence[Number], g: Sequence[Number], field: RealField | None) -> Filter:
        if not a:
            raise bad("a", "is empty", [], "pass a filter of order at least one")
        if g[0] * g[0] == 1:
            raise bad("g[0]", "is the Schur parameter gamma_0 = 1 or -1", str(g[0]), "the filter has no first step from there")
        return cls(tuple(a), tuple(g), field)


def _exact(floats: Floats, **named: Iterable[Any]) -> tuple[list[Vector], RealField | None]:
    """The named vectors in one field."""
    read: list[Number] = []
    lengths = []
    for name, values in named.items():
        values = _vector(name, values)
        lengths.append(len(values))
        read.extend(number(v, floats=floats, name=f"{name}[{k}]") for k, v in enumerate(values))
    found, field = together(read)
    out, at = [], 0
    for length in lengths:
        out.append(tuple(found[at:at + length]))
        at += length
    return out, field


def _rows(name: str, value: Any) -> list[list[Any]]:
    """A matrix as a list of rows."""
    value = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(value, (str, bytes, dict, Set)) or not isinstance(value, Iterable):
        raise bad(name, "is no matrix", value, "pass a list of rows")
    rows = [list(row) if isinstance(row, Iterable) and not isinstance(row, (str, bytes)) else [row] for row in value]
    if not rows or not all(rows):
        raise bad(name, "is empty", value, "pass a list of rows")
    return rows


def _vector(name: str, value: Any) -> list[Any]:
    """A vector from a sequence, or from a matrix of one row or one column."""
    value = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(value, (str, bytes, dict, Set)) or not isinstance(value, Iterable):
        raise bad(name, "is no vector", value, "pass a list of numbers")
    values = list(value)
    nested = [isinstance(v, (list, tuple)) for v in values]
    if len(values) == 1 and nested[0]:
        return list(values[0])
    if any(nested):
        if not all(isinstance(v, (list, tuple)) and len(v) == 1 for v in values):
            raise bad(name, "is a matrix of several rows and columns", value, "pass a vector")
        return [v[0] for v in values]
    return values


def _leverrier(F: Sequence[Vector], g: Vector, h: Vector) -> tuple[Vector, Vector]:
    """Coefficients of det(zI - F) and of h' adj(zI - F) g, by the Faddeev-LeVerrier recursion."""
    n = len(F)
    power: list[Number] = list(g)  # N_k g with N_1 = I, N_{k+1} = F N_k + a_k I
    N: list[list[Number]] = [[_number(i == j, F) for j in range(n)] for i in range(n)]
    a: list[Number] = []
    out: list[Number] = []
    for k in range(1, n + 1):
        out.append(_dot(h, power))
        FN = [[_dot(row, [N[r][j] for r in range(n)]) for j in range(n)] for row in F]
        a.append(-_dot([FN[i][i] for i in range(n)], [1] * n) / k)
        N = [[x + a[-1] if i == j else x for j, x in enumerate(row)] for i, row in enumerate(FN)]
        power = [_dot(row, g) for row in N]
    return tuple(a), tuple(out)


def _number(one: bool, F: Sequence[Vector]) -> Number:
    return F[0][0] * 0 + int(one)


def _dot(x: Sequence[Number], y: Sequence[Any]) -> Number:
    return sum((u * v for u, v in zip(x, y, strict=True)), x[0] * 0)


def _plain(values: Sequence[Number]) -> list[str]:
    return [str(v) for v in values]
