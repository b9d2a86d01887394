# SPDX-License-Identifier: MIT
"""Changed lemmas, as a hint that a proved lemma may say less than it was meant to.

A claim of the papers must reject its mutants, or its evidence counts for
nothing. A lemma of one's own has a proof and needs none of this; but where a
sign may be flipped or an assumption left out without an instance noticing, its
author may want to know. So it is a warning, within the time that is left, and
by instances and words alone.

Main definitions
----------------
`neighbours`
    How many changed lemmas are refuted, and a warning for each that is not.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from fractions import Fraction
from itertools import repeat
from typing import Any

from exactkf.finders.prove import every_size
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.order import goal_of
from exactkf.kernel.reader import Reader, residual_blocks
from exactkf.language.mutate import Mutant, mutants
from exactkf.language.statement import as_tuples
from exactkf.language.text import text
from exactkf.lemma.refute import look_for

__all__ = ["neighbours"]

_MOST = 48  # changed conclusions looked at, spread evenly
_GRANTS = ("invertible", "pd", "!=", ">")  # without one of these the lemma would speak of fewer matrices, not of more
_SECONDS, _FEW_SECONDS = 1.0, 0.2  # for one assumption left out, for the proof of a changed conclusion
_WORLDS = 40  # instances a changed conclusion is tried on, large ones first
_ORDERS = ("psd", "pd", "loewner")
_SHOWN = 4  # changed conclusions named


def neighbours(data: dict, worlds: Sequence[World], degree: int, deadline: float, seed: int) -> tuple[int, int, list[str]]:
    """Numbers of changed lemmas refuted and looked at, and warnings."""
    refuted, looked, warnings, unsettled = 0, 0, [], []
    large = sorted(worlds, key=lambda world: -sum(world.values[name] for name in data["sizes"]))[:_WORLDS]
    every = [m for m in mutants(data) if not (m.drops or m.stronger)]  # a stronger lemma may well be true
    for mutant in every[::max(1, -(-len(every) // _MOST))]:
        if time.perf_counter() > deadline:
            break
        outcome = _judged(data, mutant, large)
        if outcome is False and next(every_size("lemma", {**data, "says": mutant.says}, (), _FEW_SECONDS, degree), None):
            continue  # another theorem, most often the same one in other words
        looked += outcome is not None
        refuted += outcome is True
        if outcome is False:
            unsettled.append(f"{mutant.kind}: {text(as_tuples(mutant.says))}")
    warnings += [f"a changed lemma is neither proved nor refuted: {changed}" for changed in unsettled[:_SHOWN]]
    warnings += [f"so are {len(unsettled) - _SHOWN} more"] if len(unsettled) > _SHOWN else []
    for label, formula, _ in data["given"]:
        if formula[0] not in _GRANTS and time.perf_counter() < deadline:
            looked += 1
            needed, warning = _left_out(data, label, degree, min(deadline, time.perf_counter() + _SECONDS), seed)
            refuted += needed
            warnings += [warning] if warning else []
    return refuted, looked, warnings


def _judged(data: dict, mutant: Mutant, worlds: Sequence[World]) -> bool | None:
    """Refuted or not; None for what is no statement, or the same polynomials in words as before."""
    meaningful = False
    for world in worlds:
        try:
            if world.value(mutant.says) is False:
                return True
            meaningful = True
        except Undefined:
            continue
        except Unknown:
            return None
    return False if meaningful and not _same(data, mutant.says) else None


def _same(data: dict, says: Any) -> bool:
    """The changed conclusion says the same in each place: a multiple, or the transpose."""
    try:
        return _alike(Reader(data), data["says"], says)
    except (Unknown, Undefined, TypeError, AttributeError):
        return False


def _alike(reader: Reader, old: Any, new: Any) -> bool:
    if old == new:
        return True
    if old[0] in ("and", "or", "=>", "<=>", "not"):
        return new[0] == old[0] and len(new) == len(old) and all(map(_alike, repeat(reader), old[1:], new[1:]))
    if old[0] in _ORDERS:
        (a, level), (b, other) = goal_of(reader, old), goal_of(reader, new)
        return level == other and any(_ratio(x.cells(), b.cells()) > 0 for x in (a, reader.transpose(a)))
    if old[0] == "invertible":
        a, b = reader.read(old[1]), reader.read(new[1])
        return new[0] == old[0] and any(_ratio(x.cells(), b.cells()) for x in (a, reader.transpose(a)))
    equations, changed = ([p for b in residual_blocks(reader, f) for p, _, _ in b.cells() if p] for f in (old, new))
    return len(equations) == len(changed) and all(_multiple(reader, p, q) for p, q in zip(equations, changed, strict=True))


def _multiple(reader: Reader, p: Any, q: Any) -> bool:
    return any(_ratio([(x, None, None)], [(q, None, None)]) for x in (p, reader.transpose_poly(p)))


def _ratio(cells: list, others: list) -> Any:
    """The number by which these blocks are multiples of those, 0 if they are none."""
    if [(set(p), *sizes) for p, *sizes in cells] != [(set(p), *sizes) for p, *sizes in others]:
        return 0
    found = {Fraction(str(q[key])) / Fraction(str(c)) for (p, *_), (q, *_) in zip(cells, others, strict=True) for key, c in p.items()}
    return found.pop() if len(found) == 1 else 0


def _left_out(data: dict, label: str, degree: int, deadline: float, seed: int) -> tuple[bool, str]:
    """Whether an assumption is needed; a warning if that is not seen."""
    weaker = {**data, "given": [g for g in data["given"] if g[0] != label]}
    search = look_for(weaker, deadline, seed=seed)
    if search.certificate is not None:
        return True, ""
    if next(every_size("lemma", weaker, (), max(0.1, deadline - time.perf_counter()), degree), None):
        return False, f"it also holds without assumption {label!r}"
    return False, f"no counterexample was found that shows assumption {label!r} to be needed"
