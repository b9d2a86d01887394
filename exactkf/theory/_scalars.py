# SPDX-License-Identifier: MIT
"""Scalars of an unspecified field.

The functions of this package are written once and run over any exact field
whose elements understand ``+ - * / ==`` and mix with Python integers: FLINT
rationals, :class:`fractions.Fraction`, rational functions, balls.  This module
brings the arguments of one call to a common type.

Main definitions
----------------
``unify``   vectors of one call, converted to a common scalar type
``units``   zero and one of that type

Notation
--------
A *vector* is a tuple of scalars.  Python and FLINT integers are promoted to the
type of the other entries, and to ``fmpq`` when all entries are integers;
Fractions are promoted to ``fmpq`` when they meet one.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any, TypeAlias

from flint import fmpq, fmpz

from exactkf._errors import BadInput

__all__ = ["Scalar", "Vector", "check_length", "shown", "unify", "units"]

Scalar: TypeAlias = Any
Vector: TypeAlias = tuple[Scalar, ...]


def shown(value: object, limit: int = 60) -> str:
    """Return `value` as text of at most `limit` characters, for an error message."""
    text = str(value)
    return text if len(text) <= limit else text[: limit - 3] + "..."


def _checked(name: str, value: Scalar) -> Scalar:
    """Return `value` with integers as Python ``int``; refuse what is not exact."""
    if isinstance(value, (bool, float, complex, str, bytes)) or value is None:
        raise BadInput(f"{name} = {value!r}: not an exact scalar; pass an integer, a Fraction or an fmpq")
    if isinstance(value, (int, fmpz)) or hasattr(value, "__index__"):
        return int(value)
    return value


def _as_fmpq(value: Fraction) -> fmpq:
    return fmpq(value.numerator, value.denominator)


def unify(**named: Iterable[Scalar]) -> list[Vector]:
    """Return the named vectors as tuples over one scalar type.

    Parameters
    ----------
    **named : iterables of scalars
        The keyword is the name of the argument in error messages.

    Returns
    -------
    list of tuple
        One tuple for each argument, in order.

    Raises
    ------
    BadInput
        If an argument is not a sequence of exact scalars.
    """
    vectors = []
    for name, values in named.items():
        if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
            raise BadInput(f"{name} = {shown(values)}: not a sequence; pass a tuple of scalars")
        vectors.append([_checked(f"{name}[{i}]", value) for i, value in enumerate(values)])
    if any(isinstance(v, fmpq) for vector in vectors for v in vector):
        vectors = [[_as_fmpq(v) if isinstance(v, Fraction) else v for v in vector] for vector in vectors]
    sample = next((v for vector in vectors for v in vector if not isinstance(v, int)), fmpq(0))
    zero = sample - sample
    return [tuple(zero + v if isinstance(v, int) else v for v in vector) for vector in vectors]


def units(*vectors: Sequence[Scalar]) -> tuple[Scalar, Scalar]:
    """Return zero and one of the scalar type of `vectors` (``fmpq`` if all are empty)."""
    sample = next((v for vector in vectors for v in vector), fmpq(0))
    zero = sample - sample
    return zero, zero + 1


def check_length(name: str, vector: Sequence[Scalar], length: int, reference: str) -> None:
    """Raise `BadInput` unless `vector` has the given length.

    Raises
    ------
    BadInput
        If the lengths differ; `reference` says what sets the length.
    """
    if len(vector) != length:
        raise BadInput(f"{name} has length {len(vector)}: {reference} asks for {length}; pass vectors that fit")
