# SPDX-License-Identifier: MIT
"""Scalars of an unspecified field.

The functions of this package are written once and run over any exact field
whose elements understand ``+ - * / ==`` and mix with Python integers: FLINT
rationals, :class:`fractions.Fraction`, rational functions, balls.  This module
brings the arguments of one call to a common type.

Main definitions
----------------
``unify``          vectors of one call, converted to a common scalar type
``unify_pair``     two vectors of equal length, at least one
``units``          zero and one of that type
``check_length``   a vector has the length that another argument asks for
``refused``        the error that names argument, value and remedy

Notation
--------
A *vector* is a tuple of scalars.  Python and FLINT integers are promoted to the
type of the other entries, and to ``fmpq`` when all entries are integers;
Fractions are promoted to ``fmpq`` when they meet one.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence, Set
from decimal import Decimal
from fractions import Fraction
from typing import Any, TypeAlias

from flint import fmpq, fmpz

from exactkf._errors import BadInput
from exactkf.exact._messages import shown

__all__ = ["Scalar", "Vector", "check_length", "one_type", "refused", "scalar", "shown", "unify", "unify_pair", "units"]

Scalar: TypeAlias = Any
Vector: TypeAlias = tuple[Scalar, ...]

_INEXACT = (bool, float, complex, str, bytes, Decimal)


def refused(name: str, value: Any, problem: str, remedy: str) -> BadInput:
    """Return the `BadInput` that says in one line: ``name = value: problem; remedy``."""
    return BadInput(f"{name} = {shown(value)}: {problem}; {remedy}")


def scalar(name: str, value: Scalar) -> Scalar:
    """Return `value` with integers as Python ``int``; refuse what is not exact, or not a scalar."""
    if type(value) is fmpq:
        return value
    if isinstance(value, _INEXACT) or value is None:
        raise refused(name, value, "not an exact scalar", "pass an integer, a Fraction or an fmpq")
    if isinstance(value, (int, fmpz)) or hasattr(value, "__index__"):
        return int(value)
    # matrices and arrays have tolist and shall not pass for scalars; lists, sets and mappings lack one of the operations
    if hasattr(value, "tolist") or not all(hasattr(value, operation) for operation in ("__add__", "__sub__", "__mul__")):
        raise refused(name, value, "not a scalar", "pass an integer, a Fraction or another exact number")
    return value


def _as_fmpq(value: Fraction) -> fmpq:
    return fmpq(value.numerator, value.denominator)


def _listed(name: str, values: Any) -> list[Scalar]:
    """Return the entries of a vector; refuse what has none, or has them in no order or from the lowest degree on."""
    if type(values) not in (tuple, list) and (
        isinstance(values, (str, bytes, Mapping, Set)) or not isinstance(values, Iterable) or type(values).__module__.startswith("flint")
    ):
        raise refused(name, values, "not a sequence", "pass a tuple of scalars")
    return [scalar(f"{name}[{i}]", value) for i, value in enumerate(values)]


def _check_mix(named: Mapping[str, Sequence[Scalar]], sample: Scalar) -> None:
    """Refuse scalars of types that do not combine with that of `sample`."""
    seen = {type(sample), int}
    for name, vector in named.items():
        for value in vector:
            if type(value) not in seen:
                seen.add(type(value))
                try:
                    sample + value, sample - value, sample * value
                except (TypeError, ValueError):
                    raise refused(f"an entry of {name}", value, f"does not combine with {shown(sample)}", "pass scalars of one field") from None


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
        If an argument is not a sequence of exact scalars that combine with each other.
    """
    return one_type({name: _listed(name, values) for name, values in named.items()})


def one_type(named: Mapping[str, Sequence[Scalar]]) -> list[Vector]:
    """Return vectors whose entries were passed by `scalar` over one scalar type; errors as `unify`."""
    if any(isinstance(v, fmpq) for vector in named.values() for v in vector):
        named = {name: [_as_fmpq(v) if isinstance(v, Fraction) else v for v in vector] for name, vector in named.items()}
    sample = next((v for vector in named.values() for v in vector if not isinstance(v, int)), fmpq(0))
    _check_mix(named, sample)
    zero = sample - sample
    return [tuple(zero + v if isinstance(v, int) else v for v in vector) for vector in named.values()]


def unify_pair(**named: Iterable[Scalar]) -> tuple[Vector, Vector]:
    """Return the two named vectors over one scalar type.

    Raises
    ------
    BadInput
        As `unify`; if the lengths differ or are zero.
    """
    (first_name, second_name) = named
    first, second = unify(**named)
    if not first:
        raise refused(first_name, first, "empty, and the filter needs n >= 1", "pass at least one coefficient")
    check_length(second_name, second, len(first), first_name)
    return first, second


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
        raise refused(name, vector, f"has length {len(vector)} where {reference} asks for {length}", "pass a vector that fits")
