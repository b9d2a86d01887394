# SPDX-License-Identifier: MIT
r"""How the name of a variable is printed in LaTeX.

========================  ==============================  ===============================
written                   printed                         rule
========================  ==============================  ===============================
``alpha``, ``Phi``        ``\alpha``, ``\Phi``            Greek names
``A1``, ``x12``           ``A_{1}``, ``x_{12}``           trailing digits are a subscript
``P_inf``, ``Q_ab``       ``P_{\infty}``, ``Q_{ab}``      what follows ``_`` is a subscript
``phi_star``, ``phis``    ``\varphi^{*}``                 star of a polynomial or gain
``x_hat``, ``xhat``       ``\hat{x}``                     also bar, tilde, dot, check
``P_plus``, ``P_minus``   ``P^{+}``, ``P^{-}``
``A_prime``, ``i_``       ``A^{\prime}``, ``i^{\prime}``  a prime that is no transpose
========================  ==============================  ===============================
"""

from __future__ import annotations

import re
from dataclasses import dataclass

__all__ = ["Name", "tex_name"]

_GREEK = {
    **{word: f"\\{word}" for word in (
        "alpha", "beta", "gamma", "delta", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu", "xi", "pi",
        "rho", "sigma", "tau", "upsilon", "chi", "psi", "omega", "ell", "Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi",
        "Sigma", "Upsilon", "Phi", "Psi", "Omega")},
    "epsilon": r"\varepsilon", "eps": r"\varepsilon", "phi": r"\varphi", "lam": r"\lambda", "omicron": "o",
    "Alpha": "A", "Beta": "B", "Epsilon": "E", "Zeta": "Z", "Eta": "H", "Iota": "I", "Kappa": "K", "Mu": "M",
    "Nu": "N", "Omicron": "O", "Rho": "P", "Tau": "T", "Chi": "X",
}
_ACCENTS = {"hat": r"\hat", "bar": r"\bar", "tilde": r"\tilde", "dot": r"\dot", "check": r"\check"}
_RAISED = {"star": "*", "plus": "+", "minus": "-", "prime": r"\prime"}
_WORDS = {"inf": r"\infty", "infty": r"\infty", "infinity": r"\infty"}


#: what a trailing ``s`` puts a star on: polynomials and gains of the fast filter; elsewhere it is a plural
_STARRED = {"phi", "psi", "pi", "rho", "q", "Q", "k"}


@dataclass(frozen=True)
class Name:
    """A printed name in pieces, so that an index can join its subscripts."""

    base: str
    sub: tuple[str, ...] = ()
    sup: str = ""

    def tex(self, *indices: str) -> str:
        """LaTeX of the name with further subscripts."""
        low = [*self.sub, *indices]
        subscript = f"_{{{','.join(low)}}}" if low else ""
        return self.base + subscript + (f"^{{{self.sup}}}" if self.sup else "")


def tex_name(name: str) -> Name:
    r"""Pieces of the LaTeX of a name.

    >>> print(tex_name("phi_star").tex("t"))
    \varphi_{t}^{*}
    >>> print(tex_name("P_inf").tex())
    P_{\infty}
    """
    head, *rest = name.strip("_").split("_") if name.strip("_") else [name]
    stem, digits = _digits(head)
    base, accent, raised = _stem(stem)
    sub = [digits] if digits else []
    for word in filter(None, rest):
        if word in _ACCENTS:
            accent = _ACCENTS[word]
        elif word in _RAISED:
            raised += _RAISED[word]
        else:
            sub.append(_subscript(word))
    raised += r"\prime" * (len(name) - len(name.rstrip("_")))
    return Name(f"{accent}{{{base}}}" if accent else base, tuple(sub), raised)


def _digits(word: str) -> tuple[str, str]:
    match = re.fullmatch(r"(.*?[^\d])(\d*)", word)
    return (match[1], match[2]) if match else (word, "")


def _is_letter(word: str) -> bool:
    return len(word) == 1 or word in _GREEK


def _stem(word: str) -> tuple[str, str, str]:
    """Base, accent and superscript of a word without underscores and trailing digits."""
    if _is_letter(word):
        return _letter(word), "", ""
    for ending, stems in (("star", None), ("s", _STARRED)):
        stem = word.removesuffix(ending)
        if stem != word and (stem in stems if stems is not None else _is_letter(stem)):
            return _letter(stem), "", "*"
    for ending, accent in _ACCENTS.items():
        if word.endswith(ending) and _is_letter(word.removesuffix(ending)):
            return _letter(word.removesuffix(ending)), accent, ""
    return rf"\mathrm{{{word}}}", "", ""


def _letter(word: str) -> str:
    return _GREEK.get(word, word)


def _subscript(word: str) -> str:
    stem, digits = _digits(word)
    if word.isdigit():
        return word
    if word in _WORDS or _is_letter(word):
        return _WORDS.get(word) or _letter(word)
    if _is_letter(stem):
        return f"{_letter(stem)}_{{{digits}}}"
    return word if len(word) == 2 else rf"\mathrm{{{word}}}"
