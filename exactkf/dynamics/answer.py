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
or whose coordinates would have a degree above 32 or thousands of digits, is in intervals, ``{"interval": [lo, hi]}``, and so are other numbers of large degree.

The certificate vouches for every field but the sentences of the derivation, which `Answer.beside` names, and for the state far ahead
if `exactkf.dynamics.certified.certify_ahead` puts it in.  Of rate and slowness in orders above one it shows how they come from `D`; that the orbit
converges like this is derived in `exactkf.dynamics.speed`, the rate from a theorem that is cited.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from typing import Any

from exactkf._errors import BadInput, Unsupported

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


DIGITS = 20  # of irrational numbers in text


def _none() -> None:
    return None


#: made when they are asked for, so that __getattr__ must be
_NOT_OF_THE_CLASS: dict[str, Callable[[], Any]] = {"limit": _none, "rate": _none, "slow": _none, "structure": _none, "facts": tuple, "certificate": dict}
_NEVER_CERTIFIED = ("facts",)
_APART = (*_NEVER_CERTIFIED, "rate", "slow", "structure", "reason", "certificate", "beside")


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
        The geometric rate of convergence of :math:`\alpha_t` as an exact number in JSON: the ratio of following distances tends to it in
        order one, and :math:`\limsup \|\alpha_t - \alpha_\infty\|^{1/t}` is it in every order (`exactkf.dynamics.speed`, statements 1 and 3).
        "0" if the orbit rests after finitely many steps; None at an equilibrium, without a limit, and if convergence is slower than any rate.
    slow : int or None
        `K`, if convergence is slower: :math:`t (1 - \alpha_n(t)/\alpha_n(\infty))` tends to `K`, where factors that `a` and `b` have
        in common are left out; for a Riccati equation the same of :math:`1 - \pi`.
    monotone_from : int or None
        Order one: the first step from which the orbit approaches its limit monotonically.
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
    structure : dict or None
        `D`, its zeros on the circle, `S` with its Jordan structure and its invariant subspaces, as `exactkf.dynamics.structure.structure_json` has them.
    facts : tuple of Fact
        The derivation, in reading order.
    reason : str
        Why the question is undecided, or what of it is.
    certificate : dict
        Sealed, of kind ``orbit``; ``exactkf check`` replays it.
    beside : tuple of str
        The fields that are not in the certificate: the derivation says why, and the checker finds out for itself.

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
    rate: Any = field(default_factory=_none)
    slow: int | None = field(default_factory=_none)
    monotone_from: int | None = None
    region: str = ""
    period: int | None = None
    preperiod: int | None = None
    torus_dimension: int | None = None
    enters_positive_real: int | None = None
    structure: dict[str, Any] | None = field(default_factory=_none, repr=False)
    facts: tuple[Fact, ...] = field(default_factory=tuple)
    reason: str = ""
    certificate: dict[str, Any] = field(default_factory=dict, repr=False)
    beside: tuple[str, ...] = _NEVER_CERTIFIED

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
        """Return the fields that are decided first; the certificate has the speed and the structure besides (`exactkf.dynamics.certified`)."""
        return {f.name: getattr(self, f.name) for f in fields(self) if f.name not in _APART}

    def to_json(self) -> dict[str, Any]:
        """Return the answer as plain data that `json` writes without help."""
        for name in _NOT_OF_THE_CLASS:
            getattr(self, name)
        return json.loads(json.dumps({**self.without_certificate(), "certificate": self.certificate}))

    def without_certificate(self) -> dict[str, Any]:
        """Return the same without the certificate, and without numbers that may take long to find and were not asked for yet."""
        late = {"limit", "rate", "slow", "structure"} - set(self.__dict__)
        data = {f.name: None if f.name in late else getattr(self, f.name) for f in fields(self) if f.name not in ("facts", "certificate", "beside")}
        return {**data, "facts": [{"words": f.words, "latex": f.latex} for f in self.facts], "beside": list(self.beside), "certificate": {}}

    def __str__(self) -> str:
        """What ``exactkf analyze`` prints."""
        from exactkf.dynamics.shown import decision_lines, number_lines, structure_lines

        lines, missing = decision_lines(self), []
        for name, make in (("limit", number_lines), ("structure", structure_lines)):
            try:
                lines += make(self, DIGITS)
            except Unsupported as error:
                missing.append(f"  Not found: {name}: {error}.")
        return "\n".join([*lines, *missing])

    def _repr_markdown_(self) -> str:
        """Headline, derivation and numbers, as a notebook shows them."""
        from exactkf.dynamics.shown import decision_lines, latex_rows

        return "\n".join([f"**{decision_lines(self)[0]}**", "", *(f"- {line}" for line in [*(f.latex for f in self.facts), *latex_rows(self, DIGITS)])])

    def words(self) -> str:
        """Return the derivation in words, a sentence a line."""
        return "\n".join([f.words for f in self.facts] + ([f"Undecided: {self.reason}."] if self.reason else []))

    def latex(self, digits: int = DIGITS, ahead: Mapping[str, Any] | None = None) -> str:
        """Return in LaTeX what `str` returns in words, and the state far ahead that `exactkf.dynamics.ahead.ahead_data` found."""
        from exactkf.dynamics.shown import latex_text

        return latex_text(self, digits, ahead)
