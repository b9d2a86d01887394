# SPDX-License-Identifier: MIT
"""One-line error messages: how a value is shown, the error every module raises, and the check of counts."""

from __future__ import annotations

from typing import Any

from exactkf._errors import BadInput

__all__ = ["bad", "check_count", "shown"]

_LIMIT = 120


def shown(value: Any) -> str:
    """Return a one-line picture of `value`, at most about 120 characters long."""
    if hasattr(value, "nrows") and hasattr(value, "tolist"):
        rows = "[" + ", ".join("[" + ", ".join(map(str, row)) + "]" for row in value.tolist()) + "]"
        text = f"{value.nrows()}x{value.ncols()} matrix {rows}"
    elif type(value).__module__.startswith("flint"):
        text = str(value)
    else:
        try:
            text = repr(value)
        except ValueError:  # an int beyond the interpreter's digit limit
            text = f"a {type(value).__name__} too long to print"
    text = " ".join(text.split())
    return text if len(text) <= _LIMIT else text[: _LIMIT - 4] + " ..."


def bad(name: str, problem: str, value: Any, remedy: str) -> BadInput:
    """Return the `BadInput` saying: argument `name` `problem`: `value`; `remedy`."""
    return BadInput(f"argument '{name}' {problem}: {shown(value)}; {remedy}")


#: decimal digits that may be asked for
MOST_DIGITS = 10**5


def check_count(name: str, value: Any, least: int = 0, most: int | None = None, remedy: str = "") -> None:
    """Refuse `value` unless it is an integer and at least `least`: a number of steps, a size, an exponent.

    With ``most`` it is at most that, as nobody could wait for more, or no memory would hold it; ``remedy`` says what to do instead.

    Raises
    ------
    BadInput
        If it is less, more, or anything else, a truth value included.
    """
    if most is not None and isinstance(value, int) and value > most:
        raise bad(name, f"is more than {most}, which takes too long or fills the memory", value, remedy or f"pass {name} <= {most}")
    if isinstance(value, bool) or not isinstance(value, int) or value < least:
        raise bad(name, f"is not an integer of at least {least}", value, f"pass {name} >= {least}")
