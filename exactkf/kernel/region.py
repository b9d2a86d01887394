# SPDX-License-Identifier: MIT
"""Regions of integer parameters.

Questions about linear forms in integer parameters (is k <= t - 1? is k = t?) are answered by
Fourier-Motzkin elimination over the rationals, or left open: then the region is cut in two.

Main definitions
----------------
`Region`
    Linear inequalities between integer parameters.
`Split`
    Raised where the answer depends on the sign of a form.

Notation: a form is {parameter: integer} with '' for the constant; ``@`` is the index of an induction.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import lru_cache

__all__ = ["INDEX", "Form", "Region", "Split", "form_key", "plus"]

Form = dict[str, int]
INDEX = "@"  # the index of an induction, or of the outermost quantifier


class Split(Exception):
    """The answer depends on whether this form is >= 0."""

    def __init__(self, form: Form) -> None:
        super().__init__(form)
        self.form = form


def plus(x: Form, y: Form, factor: int = 1) -> Form:
    """x + factor y."""
    if not y:
        return x
    out = dict(x)
    get = out.get
    for name, c in y.items():
        total = get(name, 0) + factor * c
        if total:
            out[name] = total
        else:
            out.pop(name, None)
    return out


def form_key(form: Form) -> tuple:
    return tuple(sorted(form.items())) if len(form) > 1 else tuple(form.items())


def _bounded(forms: list[Form]) -> list[Form]:
    """The forms without those that hold where a parameter is large enough, or small enough: no other form bounds it on that side."""
    while True:
        above, below = set[str](), set[str]()
        for f in forms:
            for n, c in f.items():
                (above if c > 0 else below).add(n)
        free = above ^ below
        free.discard("")
        if not free:
            return forms
        forms = [f for f in forms if free.isdisjoint(f)]


class Region:
    """Integer points with every given form >= 0; forced equations are solved for a parameter."""

    def __init__(self, forms: list[Form], solved: Mapping[str, Form] | None = None) -> None:
        self.solved = dict(solved or {})
        self.forms = [self.reduce(f) for f in forms]
        self.keys = frozenset(map(form_key, self.forms))
        self.greatest: dict[tuple, int] = {}  # of linear forms without a constant
        for key in self.keys:
            rest, constant = tuple((n, -c) for n, c in key if n), dict(key).get("", 0)
            self.greatest[rest] = min(constant, self.greatest.get(rest, constant))
        self.answers: dict[tuple, bool | None] = {}
        self.parts: dict[tuple, Region] = {}
        if _possible(frozenset(form_key(plus(form, {"": 1}, -1)) for form in self.forms if form)):
            return  # no form is zero everywhere
        for form in list(self.forms):
            if form and not self._possible(plus(form, {"": 1}, -1)) and (name := self._unit(form)):
                value = {n: -c * form[name] for n, c in form.items() if n != name}
                self.solved = {n: self._put(f, name, value) for n, f in self.solved.items()} | {name: value}
                self.__init__(self.forms, self.solved)  # type: ignore[misc]
                return

    @staticmethod
    def of(*forms: Form) -> Region:
        """The region of these forms; one that is asked for again is the same, with the answers that it has given."""
        return _made(tuple(map(form_key, forms)), ())

    @staticmethod
    def _unit(form: Form) -> str:
        return max((n for n, c in form.items() if n and abs(c) == 1), key=lambda n: (n != INDEX, n), default="")

    @staticmethod
    def _put(form: Form, name: str, value: Form) -> Form:
        return plus({n: c for n, c in form.items() if n != name}, value, form[name]) if name in form else form

    def reduce(self, form: Form) -> Form:
        """The form with solved parameters inserted."""
        if not self.solved or self.solved.keys().isdisjoint(form):
            return form
        for name in [n for n in form if n in self.solved]:
            form = self._put(form, name, self.solved[name])
        return form

    def _possible(self, extra: Form) -> bool:
        """Some rational point has every form and this one >= 0."""
        return _possible(self.keys | {form_key(extra)})

    @property
    def empty(self) -> bool:
        return not self._possible({})

    def decide(self, form: Form) -> bool | None:
        """form >= 0: True, False, or None where it depends."""
        key = tuple(form.items())  # in whatever order
        if key not in self.answers:
            self.answers[key] = self._decided(self.reduce(form))
        return self.answers[key]

    def _decided(self, form: Form) -> bool | None:
        if not form or len(form) == 1 and "" in form:
            return form.get("", 0) >= 0
        below = plus({n: -c for n, c in form.items()}, {"": 1}, -1)
        answer = self._at_sight(form_key(below), form_key(form))
        return answer if answer is not None else True if not self._possible(below) else None if self._possible(form) else False

    def _at_sight(self, below: tuple, form: tuple) -> bool | None:
        """The answer, where one form of the region and the negative of what is asked for differ by a constant."""
        for negative, answer in ((below, True), (form, False)):
            constant, rest = (negative[0][1], negative[1:]) if negative[0][0] == "" else (0, negative)
            if self.greatest.get(rest, -constant) < -constant:
                return answer
        return None

    def holds(self, form: Form) -> bool:
        """form >= 0; `Split` where it depends."""
        answer = self.decide(form)
        if answer is None:
            raise Split(self.reduce(form))
        return answer

    def zero(self, form: Form) -> bool:
        """form = 0; `Split` where it depends."""
        return self.holds(form) and self.holds({n: -c for n, c in form.items()})

    def and_(self, *forms: Form) -> Region:
        """The part with these forms >= 0; regions do not change, so that one that is asked for again is the same."""
        key = tuple([tuple(form.items()) for form in forms])
        if key not in self.parts:
            self.parts[key] = _made((*map(form_key, self.forms), *map(form_key, forms)), tuple((n, form_key(f)) for n, f in self.solved.items()))
        return self.parts[key]

    def cases(self, form: Form) -> Iterator[Region]:
        for part in (form, plus({n: -c for n, c in form.items()}, {"": 1}, -1)):
            region = self.and_(part)
            if not region.empty:
                yield region


@lru_cache(maxsize=1 << 13)
def _made(keys: tuple[tuple, ...], solved: tuple[tuple[str, tuple], ...]) -> Region:
    return Region([dict(key) for key in keys], {name: dict(key) for name, key in solved})


@lru_cache(maxsize=1 << 16)
def _possible(keys: frozenset[tuple]) -> bool:
    """Some rational point has all these forms >= 0, by Fourier-Motzkin elimination."""
    forms = _bounded([dict(key) for key in sorted(keys)])
    while forms:
        counts: dict[str, int] = {}
        for f in forms:
            for n in f:
                counts[n] = counts.get(n, 0) + 1
        counts.pop("", None)
        if not counts:
            break
        name = min(counts, key=counts.__getitem__)
        low = [f for f in forms if f.get(name, 0) > 0]
        high = [f for f in forms if f.get(name, 0) < 0]
        kept = {frozenset(f.items()): f for f in forms if name not in f}
        for a in low:
            for b in high:
                f = plus({n: -b[name] * c for n, c in a.items()}, b, a[name])
                kept[frozenset(f.items())] = f
        forms = _bounded(list(kept.values()))
    return all(f.get("", 0) >= 0 for f in forms)
