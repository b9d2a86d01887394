# SPDX-License-Identifier: MIT
"""MathML from the LaTeX of statements, as browsers like it."""

from __future__ import annotations

import re
from functools import lru_cache

from latex2mathml.converter import convert
from markupsafe import Markup, escape

__all__ = ["formula"]

# relations and signs that the converter takes for identifiers, which would leave them without space
_SIGNS = "⪰|≻|⟹|⟺|¬|:|→|∼"
_REPAIRS = (
    (re.compile(r' xmlns="[^"]*"'), ""),  # HTML knows MathML
    # math fonts disagree on the size and height of a prime, text fonts do not
    (re.compile(r"<mi>′</mi>"), '<mpadded class="prime" voffset="-0.4em" height="0.5em"><mtext>′</mtext></mpadded>'),
    (re.compile(r"<mi>:</mi>\s*<mo>=</mo>"), "<mo>≔</mo>"),
    (re.compile("<mi>[\u2216\u29f5]</mi>"), r"<mo>\\</mo>"),  # set minus, which common fonts lack
    (re.compile(r"<mo>/</mo>"), '<mo lspace="0" rspace="0">/</mo>'),
    # det, rank: an operator would stand apart from its argument
    (re.compile(r"<mo[^>]*>([a-z]{2,})</mo>"), r"<mi>\1</mi>"),
    (re.compile(rf"<mi>({_SIGNS})</mi>"), r"<mo>\1</mo>"),
    (re.compile(r"<mtext>([^<]*)</mtext><mtext>(\s*)</mtext>"), r"<mtext>\1\2</mtext>"),
)


@lru_cache(maxsize=4096)
def formula(latex: str, block: bool = False) -> Markup:
    r"""MathML of a formula; its source, escaped, if the converter has no answer.

    >>> "<msup>" in formula("x^{2}")
    True
    """
    try:
        text = convert(latex, display="block" if block else "inline")
    except Exception:  # the converter raises what it likes, and a page with one source in it is still a page
        return Markup("<code>{}</code>").format(escape(latex))
    text = re.sub(r"&#x([0-9A-F]+);", _character, text)
    for pattern, better in _REPAIRS:
        text = pattern.sub(better, text)
    return Markup(text)


def _character(match: re.Match) -> str:
    character = chr(int(match[1], 16))
    return match[0] if character in "<>&\"" else character
