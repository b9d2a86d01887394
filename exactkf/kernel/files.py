# SPDX-License-Identifier: MIT
"""The text of a certificate: read in one way only, and spoken of on one line.

Of a key that stands twice most readers see the last value, and people the first. A number with a point or
an exponent is no exact one. So a certificate with either is none.

Main definitions
----------------
`parsed`
    The object in a JSON text.
`one_line`
    A message without line breaks, control characters and what cannot be printed.
"""

from __future__ import annotations

import json
from typing import Any

from exactkf.kernel.replay import NotACertificate

__all__ = ["one_line", "parsed"]


def parsed(text: str) -> Any:
    """Read a JSON text; what is no JSON raises ValueError.

    Raises
    ------
    NotACertificate
        If a key stands twice, or a number is not an integer.
    """
    return json.loads(text, object_pairs_hook=_once, parse_float=_exact, parse_constant=_exact)


def one_line(message: object) -> str:
    """The message with everything that is not printed as itself written out, as in ``\\n``."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode("ascii") for c in str(message))


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    out: dict[str, Any] = {}
    for key, value in pairs:
        if key in out:
            raise NotACertificate(f"key {key!r} stands twice in one object; pass a file in which it stands once")
        out[key] = value
    return out


def _exact(number: str) -> Any:
    raise NotACertificate(f"{number} is no exact number; a certificate has integers, and fractions as strings")
