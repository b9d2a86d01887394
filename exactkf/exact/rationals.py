# SPDX-License-Identifier: MIT
"""Exact rational numbers.

The one door through which numbers enter exactkf.  Whatever a user holds, an
`int`, a `fractions.Fraction`, a string such as ``"3/4"`` or ``"1.25"``, a
numpy integer, a sympy ``Rational``, becomes a `flint.fmpq`.  A binary floating
point number is refused unless the caller states which rational number it
stands for.  No string is evaluated: a fixed grammar is matched, with a bounded
exponent, so that no input of a few characters can ask for a number of millions
of digits.

Notation
--------
``fmpq`` is python-flint's rational number: always in lowest terms, with a
positive denominator, hashing like `fractions.Fraction`.  Note that
``fmpq(1, 2) == Fraction(1, 2)`` is False in python-flint: convert first.

References
----------
IEEE Std 754-2019, section 3 (the value of a binary floating point number).
"""

from __future__ import annotations

import math
import numbers
import re
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

from flint import fmpq, fmpz

from exactkf.exact._messages import bad

__all__ = ["MAX_DIGITS", "MAX_EXPONENT", "rational", "to_fraction"]

#: Largest absolute decimal exponent accepted in a string.
MAX_EXPONENT = 10_000
#: Longest string accepted.
MAX_DIGITS = 100_000

_DECIMAL = re.compile(r"([+-]?)([0-9]*)(?:\.([0-9]*))?(?:[eE]([+-]?[0-9]{1,9}))?", re.ASCII)
_QUOTIENT = re.compile(r"([+-]?)([0-9]+)\s*/\s*([0-9]+)", re.ASCII)


def rational(x: Any, *, floats: str | int | None = None, name: str = "x") -> fmpq:
    """Return the exact rational number that `x` denotes.

    Parameters
    ----------
    x : int, Fraction, Decimal, str, fmpz, fmpq, numpy integer, sympy Rational or float (Python's, numpy's, sympy's)
        The number.  Strings are ``"3/4"``, ``"1.25"`` or ``"1e-3"``.
    floats : {None, "exact", "decimal"} or int, optional
        What a binary floating point number stands for.  None refuses it;
        ``"exact"`` takes the dyadic value it stores; ``"decimal"`` takes the
        shortest decimal that prints it; a positive integer ``N`` takes the
        closest fraction with denominator at most ``N``.
    name : str, optional
        The argument's name in error messages.

    Returns
    -------
    fmpq
        The number, in lowest terms.

    Raises
    ------
    BadInput
        If `x` is a float and `floats` is None, is infinite or not a number, is
        a bool, has an exponent beyond `MAX_EXPONENT`, or is not a number at all.

    Examples
    --------
    >>> rational("1.25")
    5/4
    >>> rational(0.1, floats="decimal")
    1/10
    """
    if floats is not None:
        check_floats(floats)
    if isinstance(x, fmpq):
        return x
    if isinstance(x, bool) or type(x).__name__ in ("bool_", "bool"):
        raise bad(name, "is a truth value", x, "pass the number 0 or 1")
    if isinstance(x, (int, fmpz)):
        return fmpq(x)
    if isinstance(x, str):
        return _from_string(x, name)
    if isinstance(x, numbers.Rational):
        return fmpq(int(x.numerator), int(x.denominator))
    if isinstance(x, Decimal):
        return _from_decimal(x, name)
    if isinstance(x, numbers.Real) and hasattr(x, "as_integer_ratio"):
        if not math.isfinite(x):
            raise bad(name, "is not finite", x, "pass a finite number")
        return _from_float(x, lambda: x.as_integer_ratio(), floats, name)
    if getattr(x, "is_Float", False) is True:  # sympy's, which are finite
        return _from_float(x, lambda: _sympy_ratio(x), floats, name)
    if getattr(x, "is_Rational", False) is True:  # sympy, without importing it
        return fmpq(int(x.p), int(x.q))
    raise bad(name, "is not a rational number", x, 'pass an int, a Fraction or a string such as "3/4"')


def to_fraction(x: Any) -> Fraction:
    """Return the `fractions.Fraction` equal to `x`, which is anything `rational` accepts."""
    x = rational(x)
    return Fraction(int(x.p), int(x.q))


def _from_string(text: str, name: str) -> fmpq:
    """Return the value of a quotient of integers or of a decimal."""
    if len(text) > MAX_DIGITS:
        raise bad(name, f"is a string of more than {MAX_DIGITS} characters", text, "pass a shorter number")
    stripped = text.strip()
    match = _QUOTIENT.fullmatch(stripped)
    if match:
        sign, numerator, denominator = match.groups()
        if fmpz(denominator) == 0:
            raise bad(name, "has denominator zero", text, "pass a nonzero denominator")
        value = fmpq(fmpz(numerator), fmpz(denominator))
        return -value if sign == "-" else value
    match = _DECIMAL.fullmatch(stripped)
    if not match or not (match[2] or match[3]):
        raise bad(name, "is not a rational number", text, 'write it like "3/4", "1.25" or "1e-3"')
    sign, whole, fraction, exponent = match[1], match[2], match[3] or "", int(match[4] or 0)
    if abs(exponent) > MAX_EXPONENT:
        raise bad(name, f"has an exponent beyond {MAX_EXPONENT}", text, "pass a number of ordinary size")
    return _scaled(fmpz(whole + fraction), exponent - len(fraction), sign == "-")


def _scaled(mantissa: fmpz, exponent: int, negative: bool) -> fmpq:
    """Return plus or minus ``mantissa * 10**exponent``."""
    value = fmpq(mantissa * fmpz(10) ** exponent) if exponent >= 0 else fmpq(mantissa, fmpz(10) ** -exponent)
    return -value if negative else value


def _from_decimal(x: Decimal, name: str) -> fmpq:
    """Return the value of a finite Decimal of bounded exponent."""
    sign, digits, exponent = x.as_tuple()
    if not isinstance(exponent, int):
        raise bad(name, "is not finite", x, "pass a finite number")
    if abs(exponent) > MAX_EXPONENT:
        raise bad(name, f"has an exponent beyond {MAX_EXPONENT}", x, "pass a number of ordinary size")
    return _scaled(fmpz("".join(map(str, digits)) or "0"), exponent, bool(sign))


def check_floats(floats: Any) -> None:
    """Refuse what is no policy for floats, whether a float comes or not.

    Raises
    ------
    BadInput
        If it is none of None, "exact", "decimal" and an integer of at least one.
    """
    if floats in (None, "exact", "decimal") or isinstance(floats, int) and not isinstance(floats, bool) and floats >= 1:
        return
    raise bad("floats", "is not a policy", floats, 'pass "exact", "decimal" or a largest denominator >= 1')


def _from_float(x: Any, ratio: Callable[[], tuple[int, int]], floats: str | int | None, name: str) -> fmpq:
    """Return the rational number a finite floating point number stands for under the policy `floats`."""
    if floats is None:
        raise bad(name, "is a float", x, f'pass the string "{x}", or say what floats mean with floats="decimal"')
    if floats == "decimal":
        return _from_string(str(x), name)
    exact = Fraction(*ratio())
    if floats != "exact":
        exact = exact.limit_denominator(int(floats))
    return fmpq(exact.numerator, exact.denominator)


def _sympy_ratio(x: Any) -> tuple[int, int]:
    """The quotient of integers that is stored as a float of sympy."""
    from sympy import Rational

    stored = Rational(x)
    return int(stored.p), int(stored.q)
