# SPDX-License-Identifier: MIT
"""Nonnegative combinations, exactly.

The columns are sparse vectors over the rationals, such as normal forms of polynomials. Asked for are coefficients c >= 0 with
sum of c_j column_j = target: by the simplex method with Bland's rule, which does not cycle, after columns are left out that
cannot take part, because one of their entries has nothing of the other sign beside it.

Main definitions
----------------
`combination`
    Coefficients that make the target, with one of some columns among them if asked.
`vanishing`
    Combinations of columns that vanish, one after the other.
"""

from __future__ import annotations

from collections.abc import Collection, Hashable, Iterator, Mapping, Sequence
from typing import Any

from flint import fmpq

from exactkf.finders.effort import clock, spend

__all__ = ["combination", "vanishing"]

Column = Mapping[Hashable, Any]
Row = dict[int, fmpq]
_LAST = -1  # place of the right side in a row


def combination(columns: Sequence[Column], target: Column, wanted: Collection[int] = (), deadline: float = float("inf")) -> dict[int, fmpq] | None:
    """Positive coefficients of columns that add up to the target; None if there are none, or time is up.

    Parameters
    ----------
    wanted : collection of int
        If there are any, one of these columns is to have a positive coefficient.

    Examples
    --------
    >>> combination([{"a": 1, "b": -1}, {"b": 1, "c": -1}], {"a": 1, "c": -1})
    {0: 1, 1: 1}
    >>> combination([{"a": 1}], {"a": -1}) is None
    True
    """
    kept = _able(columns, target)
    table = _Table(columns, kept, target, deadline)
    if not table.feasible():
        return None
    if wanted and not any(k in wanted for k in table.solution()):
        ray = table.raise_sum([k for k in kept if k in wanted])
        found = table.solution()
        for k, v in ray.items():
            found[k] = found.get(k, fmpq(0)) + v
        return found if any(k in wanted for k in found) else None
    return table.solution()


def vanishing(columns: Sequence[Column], deadline: float = float("inf")) -> Iterator[dict[int, fmpq]]:
    """Positive coefficients of columns with sum zero, until every column that can take part has done so.

    Examples
    --------
    >>> list(vanishing([{"a": 1}, {"a": -2}, {"b": 1}]))
    [{0: 2, 1: 1}]
    """
    kept = _able(columns, {})
    new = list(kept)
    while new and clock() < deadline:
        table = _Table(columns, kept, {}, deadline)
        found = table.raise_sum(new)
        if not found:
            return
        new = [k for k in new if k not in found]
        least = min(found.values())
        yield {k: v / least for k, v in sorted(found.items())}


def _able(columns: Sequence[Column], target: Column) -> list[int]:
    """Columns with, for each entry that the target does not have, others of the other sign."""
    users: dict[tuple[Hashable, bool], set[int]] = {}  # those that have an entry, by its sign
    for k, column in enumerate(columns):
        for key, v in column.items():
            users.setdefault((key, v > 0), set()).add(k)
    asked = {(key, v < 0) for key, v in target.items()}
    none: set[int] = set()
    alive = set(range(len(columns)))
    todo = [k for (key, up), having in users.items() if (key, not up) not in users and (key, not up) not in asked for k in having]
    while todo:
        if (k := todo.pop()) not in alive:
            continue
        alive.discard(k)
        for key, v in columns[k].items():
            (having := users[key, v > 0]).discard(k)
            if not having and (key, v > 0) not in asked:
                todo.extend(users.get((key, v <= 0), none))
    return sorted(alive)


class _Table:
    """Rows solved for their basic columns; a basic column below zero is an artificial one."""

    def __init__(self, columns: Sequence[Column], kept: Sequence[int], target: Column, deadline: float) -> None:
        keys: dict[Hashable, Row] = {key: {_LAST: _q(v)} for key, v in target.items()}
        for k in kept:
            for key, v in columns[k].items():
                keys.setdefault(key, {})[k] = _q(v)
        self.rows = [row if row.get(_LAST, 0) >= 0 else {k: -v for k, v in row.items()} for row in keys.values()]
        self.basis = [-2 - n for n in range(len(self.rows))]
        self.kept, self.deadline = list(kept), deadline

    def feasible(self) -> bool:
        """Let the sum of what is left over go down to zero."""
        cost: Row = {}
        for row in self.rows:
            _subtract(cost, row, fmpq(-1))
        while cost.get(_LAST, 0) > 0:
            entering = next((k for k in self.kept if cost.get(k, 0) > 0), None)
            if entering is None or clock() > self.deadline:
                return False
            place = self._leaving(entering)
            if place is None:
                return False
            self._pivot(place, entering, cost)
        return True

    def raise_sum(self, chosen: Sequence[int]) -> dict[int, fmpq]:
        """Let the sum of the chosen columns grow; a direction in which it grows without end, if there is one."""
        self._drive_out()
        cost: Row = {k: fmpq(1) for k in chosen}
        for row, b in zip(self.rows, self.basis, strict=True):
            if b in cost:
                _subtract(cost, row, cost[b])
        while clock() < self.deadline:
            entering = next((k for k in self.kept if cost.get(k, 0) > 0), None)
            if entering is None:
                return {}
            place = self._leaving(entering)
            if place is None:
                ray = {b: -row[entering] for row, b in zip(self.rows, self.basis, strict=True) if entering in row and b >= 0}
                return {entering: fmpq(1), **{k: v for k, v in ray.items() if v > 0}}
            self._pivot(place, entering, cost)
        return {}

    def solution(self) -> dict[int, fmpq]:
        return {b: row[_LAST] for row, b in sorted(zip(self.rows, self.basis, strict=True), key=lambda x: x[1]) if b >= 0 and row.get(_LAST, 0) > 0}

    def _drive_out(self) -> None:
        """Artificial columns, which are zero now, make room for others; rows that say nothing go."""
        for place in range(len(self.rows)):
            if self.basis[place] < 0 and (entering := next((k for k in self.rows[place] if k >= 0), None)) is not None:
                self._pivot(place, entering, {})
        keep = [n for n, b in enumerate(self.basis) if b >= 0]
        self.rows, self.basis = [self.rows[n] for n in keep], [self.basis[n] for n in keep]

    def _leaving(self, entering: int) -> int | None:
        above = [(row, b, n) for n, (row, b) in enumerate(zip(self.rows, self.basis, strict=True)) if row.get(entering, 0) > 0]
        ratios = [(row.get(_LAST, fmpq(0)) / row[entering], b, n) for row, b, n in above]
        return min(ratios)[2] if ratios else None

    def _pivot(self, place: int, entering: int, cost: Row) -> None:
        own = self.rows[place]
        by = own[entering]
        own = self.rows[place] = {k: v / by for k, v in own.items()}
        for n, row in enumerate(self.rows):
            if n != place and entering in row:
                _subtract(row, own, row[entering])
        if entering in cost:
            _subtract(cost, own, cost[entering])
        self.basis[place] = entering
        spend(len(own) * len(self.rows))


def _subtract(row: Row, other: Row, by: fmpq) -> None:
    for k, v in other.items():
        old = row.get(k)
        if old is None:
            row[k] = -by * v
        elif rest := old - by * v:
            row[k] = rest
        else:
            del row[k]


def _q(v: Any) -> fmpq:
    return v if isinstance(v, fmpq) else fmpq(int(v.numerator), int(v.denominator))
