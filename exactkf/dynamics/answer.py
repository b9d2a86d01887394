# SPDX-License-Identifier: MIT
r"""What is known about an orbit, with its derivation and its certificate.

Main definitions
----------------
``Fact``     one sentence of the derivation, in words and in LaTeX
``Answer``   the decision about one orbit

Notation
--------
An exact number in JSON is a string ``"p/q"``, or, if it is irrational, an object
``{"minpoly": [c_0, ..., c_d], "interval": [lo, hi]}``: the only root of the polynomial
(coefficients from :math:`x^0` up) in the open interval.  The limit of an orbit of order two or more with irrational data,
or whose coordinates would have a degree above 32, is in intervals, ``{"interval": [lo, hi]}``.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from typing import Any

from exactkf._errors import BadInput

__all__ = ["BEHAVIOURS", "Answer", "Fact"]

#: What an orbit can do.  ``eventually periodic``: it repeats, but never comes back to its start.  ``dense`` (order one): it fills its hyperbola,
#: or the line, densely.
BEHAVIOURS = ("converges", "escapes", "periodic", "eventually periodic", "dense", "not convergent, not periodic", "undecided")


@dataclass(frozen=True)
class Fact:
    """One sentence of a derivation.

    Attributes
    ----------
    words : str
        Plain text.
    latex : str
        The same sentence in LaTeX, formulas between dollar signs.
    """

    words: str
    latex: str


def _none() -> None:
    return None


_NOT_OF_THE_CLASS: dict[str, Callable[[], Any]] = {"limit": _none, "facts": tuple, "certificate": dict}  # so that __getattr__ is asked for them


@dataclass(frozen=True)
class Answer:
    r"""The decision about one orbit.

    Attributes
    ----------
    order : int
        The order `n` of the filter.
    behaviour : str
        One of `BEHAVIOURS`.
    escape : int or None
        The first `t` at which the state has no successor.
    never_escapes : bool
        It is decided that there is no such `t`.  An orbit that is "not convergent, not periodic" with neither this nor `escape`
        does neither as long as it goes on, and whether it ever escapes is open.
    limit : dict or None
        Exact numbers in JSON: ``{"alpha": [...], "gamma": ...}``, or ``{"pi": ...}`` of a Riccati equation.
    rate : object
        The geometric rate of convergence of :math:`\alpha_t` as an exact number in JSON, or None.
    monotone_from : int or None
        The first step from which the orbit approaches its limit monotonically.
    region : str
        Where the orbit starts.
    period : int or None
        The least period; one at an equilibrium.
    preperiod : int or None
        The first step to which an orbit that is eventually periodic comes back.
    torus_dimension : int or None
        The dimension of the torus that the orbit fills.
    enters_positive_real : int or None
        The first step in the positive real region, in which `D` is positive on the circle and `a` and `b` have all zeros inside
        (BLZ94 (2.13)-(2.15)); None if there is none.
    facts : tuple of Fact
        The derivation, in reading order.
    reason : str
        Why the question is undecided, or what of it is.
    certificate : dict
        Sealed, of kind ``orbit``; ``exactkf check`` replays it.

    Raises
    ------
    BadInput
        If `behaviour` is not one of `BEHAVIOURS`.
    """

    order: int
    behaviour: str
    escape: int | None = None
    never_escapes: bool = False
    limit: dict[str, Any] | None = field(default_factory=_none)
    rate: Any = None
    monotone_from: int | None = None
    region: str = ""
    period: int | None = None
    preperiod: int | None = None
    torus_dimension: int | None = None
    enters_positive_real: int | None = None
    facts: tuple[Fact, ...] = field(default_factory=tuple)
    reason: str = ""
    certificate: dict[str, Any] = field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        if self.behaviour not in BEHAVIOURS:
            raise BadInput(f"behaviour = {self.behaviour!r} is not a behaviour of orbits; pass one of {', '.join(BEHAVIOURS)}")

    @property
    def is_open(self) -> bool:
        """Whether it is undecided what the orbit does, or whether it ever escapes."""
        return self.behaviour == "undecided" or self.behaviour == "not convergent, not periodic" and not self.never_escapes

    @classmethod
    def of_entries(cls, order: int, entries: Mapping[str, Any], later: Mapping[str, Callable[[Answer], Any]], start: Any) -> Answer:
        """An answer with some entries, the rest as by default; quicker than the constructor.

        Limit, facts and certificate may be left for later: functions of a module make them when they are asked for, and
        `start` is what these need to know of this answer. Another process gets it without what was not asked for.
        """
        made = object.__new__(cls)
        made.__dict__.update(entries, order=order, _later=later, _start=start)  # other defaults are those of the class
        for name, default in _NOT_OF_THE_CLASS.items():
            if name not in later:
                made.__dict__.setdefault(name, default())
        return made

    def __getattr__(self, name: str) -> Any:
        """Compute what was left for later; no other attribute is missing."""
        make = self.__dict__.get("_later", {}).get(name)
        if make is None:
            raise AttributeError(f"an Answer has no attribute {name!r}")
        self.__dict__[name] = value = make(self)
        return value

    def __reduce__(self) -> tuple[Any, ...]:
        if "_later" not in self.__dict__:
            return Answer, tuple(getattr(self, f.name) for f in fields(self))
        entries = {k: v for k, v in self.__dict__.items() if k != "order" and not k.startswith("_")}
        return Answer.of_entries, (self.order, entries, self.__dict__["_later"], self.__dict__["_start"])

    def as_found(self, reason: str = "") -> Answer:
        """Return the same with nothing left for later: what was not asked for is missing, and `reason` says why."""
        known = {k: v for k, v in self.__dict__.items() if k != "order" and not k.startswith("_")}
        return Answer.of_entries(self.order, {**known, "reason": reason or self.reason}, {}, None)

    def decided(self) -> dict[str, Any]:
        """Return the fields that the certificate vouches for: all but the facts, the reason and the certificate."""
        return {f.name: getattr(self, f.name) for f in fields(self) if f.name not in ("facts", "reason", "certificate")}

    def to_json(self) -> dict[str, Any]:
        """Return the answer as plain data that `json` writes without help."""
        return json.loads(json.dumps({**self.without_certificate(), "limit": self.limit, "certificate": self.certificate}))

    def without_certificate(self) -> dict[str, Any]:
        """Return the same without limit and certificate, which may take long to find."""
        names = [f.name for f in fields(self) if f.name not in ("facts", "reason", "certificate")]
        data = {name: None if name == "limit" else getattr(self, name) for name in names}
        return {**data, "facts": [{"words": f.words, "latex": f.latex} for f in self.facts], "reason": self.reason, "certificate": {}}

    def __str__(self) -> str:
        """What ``exactkf analyze`` prints."""
        from exactkf.dynamics.shown import decision_lines, number_lines

        return "\n".join([*decision_lines(self), *number_lines(self, 20)])

    def _repr_markdown_(self) -> str:
        """Headline and derivation, as a notebook shows them."""
        from exactkf.dynamics.shown import decision_lines

        return "\n".join([f"**{decision_lines(self)[0]}**", "", *(f"- {fact.latex}" for fact in self.facts)])

    def words(self) -> str:
        """Return the derivation in words, a sentence a line."""
        return "\n".join([f.words for f in self.facts] + ([f"Undecided: {self.reason}."] if self.reason else []))

    def latex(self) -> str:
        """Return the derivation as a LaTeX list."""
        items = [f.latex for f in self.facts] + ([f"Undecided: {self.reason}."] if self.reason else [])
        return "\n".join(["\\begin{itemize}", *(f"  \\item {item}" for item in items), "\\end{itemize}"])
