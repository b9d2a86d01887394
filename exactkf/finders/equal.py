# SPDX-License-Identifier: MIT
"""Showing that a changed statement says nothing new.

Two ways, both with a symbol in place of every variable. The changed term, or
one around it, is the same rational function as before. Or the changed
statement is the original one after a substitution that maps the types of the
variables to themselves: a scaling of a positive semidefinite matrix, two
variables of one type exchanged, a nonsingular matrix transposed; it is then a
special case of the original and no wrong neighbour. Predicates are compared
by their arguments, up to the factors they do not see (a positive factor for
definiteness, any nonzero factor for invertibility).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import combinations, islice
from typing import Any

from exactkf.evidence import Evidence
from exactkf.finders.remembering import Remembering, nodes_of
from exactkf.kernel.instances import generic
from exactkf.kernel.linear import Matrix
from exactkf.kernel.meaning import Generic, World
from exactkf.kernel.numbers import Laurent, Undefined, Unknown
from exactkf.kernel.replay import _integers
from exactkf.kernel.symbolic import Symbolic, SymbolicField
from exactkf.language.statement import as_lists

__all__ = ["Original", "subtree"]

_MOST = 60  # substitutions looked at
_FACTORS: dict[str, tuple] = {
    "psd": (1, 2, Fraction(1, 2)), "pd": (1, 2, Fraction(1, 2)), "invertible": (1, 2, Fraction(1, 2), -1),
    "pos_circle": (1, 2, Fraction(1, 2)), "nonneg_circle": (1, 2, Fraction(1, 2)),
}
_BINDING = {"sum", "prod", "forall", "exists", "always", "col", "mat", "at", "entry"}
_CONNECTIVES = {"and", "or", "not", "=>", "<=>"}


class Original:
    """A statement with a symbol in place of every variable, to which changed ones are compared.

    What is computed for one of them is remembered for the next.

    Parameters
    ----------
    data : dict
        JSON of the statement.
    by : sequence of Evidence
        Its evidence: sizes, and how variables are made from others.
    """

    def __init__(self, data: dict, by: Sequence[Evidence]) -> None:
        self.data, self.by = data, by
        self.nodes = nodes_of(data["says"], *(formula for _, formula, _kind in data["given"]))
        self.made_by: Any = next((e.hints["made_by"] for e in by if e.hints.get("made_by")), {})
        using: Any = next((e.hints["using"] for e in by if e.hints.get("using")), {})
        self._statement = {**data, "over": [*([n, as_lists(t)] for n, t in using.items()), *data["over"]]}
        self._special: list[tuple[list[World], list[World]]] = []
        self._more = self._special_cases()

    def says_as_much(self, says: Any, path: tuple[int, ...]) -> bool:
        """The statement with conclusion ``says``, changed at ``path``, follows from the original by rewriting."""
        if not self.worlds:
            return False
        old, new = _narrowed(self.data["says"], says)
        if _same_term(self.worlds, old, new, {}):
            return True
        for cut in range(len(path), -1, -1):
            old, new, local = subtree(self.data["says"], path[:cut]), subtree(says, path[:cut]), self._any_time(path[:cut])
            if _same_term(self.worlds, old, new, local) or (local and old[0] == "=" and _says_the_same(self.worlds, old, self.worlds, new, local)):
                return True
        return any(_says_the_same(moved, self.data["says"], worlds, says) for moved, worlds in self._cases())

    def _any_time(self, path: tuple[int, ...]) -> dict[str, int]:
        """The indices of "for all t" around a node, standing for any t."""
        around = [subtree(self.data["says"], path[:cut]) for cut in range(len(path))]
        return {node[1]: Generic(Generic.T) for node in around if node[0] == "always"}

    @cached_property
    def worlds(self) -> list[World]:
        """Symbols for every variable; where the evidence computes some from others, so that the hypotheses hold, computed."""
        return self._with(self.made_by) or self.free

    @cached_property
    def free(self) -> list[World]:
        """Symbols for every variable."""
        return self._with({})

    def _with(self, made_by: Mapping[str, Any]) -> list[World]:
        return [Remembering(world, self.nodes) for world in _worlds(self._statement, self.data, self.by, made_by)]

    def _cases(self) -> Iterator[tuple[list[World], list[World]]]:
        """Those found so far, then the others."""
        yield from self._special
        for found in self._more:
            self._special.append(found)
            yield found

    def _special_cases(self) -> Iterator[tuple[list[World], list[World]]]:
        """Worlds after a substitution that respects types and hypotheses, beside those before it."""
        if found := self._moved(self.worlds, lambda values: values):
            yield found, self.worlds
        free = self.free if self.made_by else self.worlds
        for change in islice(_substitutions(self.data), _MOST) if free else ():
            if found := self._moved(free, change):
                yield found, free

    def _moved(self, worlds: list[World], change: Callable[[dict], dict]) -> list[World]:
        """The worlds after a substitution; none if the hypotheses say something else there."""
        moved: list[World] = []
        try:
            for world in worlds:
                after = World(self.data, {**change(world.values), "horizon": None})
                after.symbolic = True
                moved.append(Remembering(after, self.nodes))
        except _FAULTS:
            return []
        return moved if all(_says_the_same(moved, formula, worlds, formula) for _, formula, _kind in self.data["given"]) else []


def _worlds(statement: dict, data: dict, by: Sequence[Evidence], made_by: Mapping[str, Any]) -> Iterator[World]:
    sizes: Any = next((e.hints["sizes"] for e in by if e.hints.get("sizes")), {})
    case = {n: max((v for v in sizes.get(n, (2,)) if v <= 2), default=2) for n in data["sizes"]}
    for integers in _integers(data, case):
        try:
            world, new = generic(statement, integers, made_by, SymbolicField().variable)
        except (Undefined, Unknown):
            return
        _at_any_time(world, new)
        yield world


def _at_any_time(world: World, new: Callable[[str], Any]) -> None:
    """At any t a sequence that a recursion defines may have any value: symbols, whatever the values from which it comes."""
    for name, definition in world.definitions.items():
        if definition[0] != "rec":
            continue
        try:
            first, second = (world.call(name, (definition[3] + k,)) for k in (0, 1))
        except (Undefined, Unknown, ArithmeticError, KeyError, TypeError):
            continue
        for t in (Generic.T + k for k in range(-1, 4)):
            if isinstance(first, Matrix) and isinstance(second, Matrix) and (first.nrows, first.ncols) == (second.nrows, second.ncols):
                world.memory[name, (t,)] = Matrix.build(first.nrows, first.ncols, lambda i, j, at=f"{name}_{t}": new(f"{at}_{i}{j}"))  # type: ignore[misc]
            elif isinstance(first, (int, Fraction, Symbolic)) and isinstance(second, (int, Fraction, Symbolic)):
                world.memory[name, (t,)] = new(f"{name}_{t}")


def _narrowed(old: Any, new: Any) -> tuple[Any, Any]:
    """The smallest pair of subtrees outside of which the two trees agree."""
    while isinstance(old, list) and isinstance(new, list) and old and new and len(old) == len(new) and old[0] == new[0] and old[0] not in _BINDING:
        differ = [k for k in range(len(old)) if old[k] != new[k]]
        if len(differ) != 1 or isinstance(old[differ[0]], str) or isinstance(new[differ[0]], str):
            break
        inner = old[differ[0]], new[differ[0]]
        if old[0] in ("block", "rows"):
            cells = [j for j, (a, b) in enumerate(zip(*inner, strict=False)) if a != b]
            if len(inner[0]) != len(inner[1]) or len(cells) != 1:
                break
            inner = inner[0][cells[0]], inner[1][cells[0]]
        old, new = inner
    return old, new


def _same_term(worlds: list[World], old: Any, new: Any, local: Mapping[str, int]) -> bool:
    try:
        for world in worlds:
            a, b = world.value(old, local), world.value(new, local)
            if isinstance(a, bool):
                if not (a is True and b is True):
                    return False
            elif not _equal(a, b):
                return False
    except (Undefined, Unknown, KeyError, TypeError):
        return False
    return True


def _equal(a: Any, b: Any) -> bool:
    if isinstance(a, Matrix) != isinstance(b, Matrix):
        a, b = (x.rows[0][0] if isinstance(x, Matrix) and x.is_scalar else x for x in (a, b))
        if isinstance(a, Matrix) or isinstance(b, Matrix):
            return False
    try:
        return bool(a == b)
    except Undefined:
        return False


# ---------------------------------------------------------------------- substitutions that respect types
def _maps(kind: str) -> list[tuple[str, Callable[[Any], Any]]]:
    """Maps of a type into itself."""
    scale = [("halved", lambda x: _scaled(x, Fraction(1, 2))), ("doubled", lambda x: _scaled(x, 2))]
    zero = [("zero", lambda x: _scaled(x, 0))]
    minus = [("negated", lambda x: _scaled(x, -1))]
    turn = [("transposed", lambda x: x.transpose())]
    match kind:
        case "scalar" | "sequence" | "poly" | "symmetric" | "diagonal":
            return scale + zero + minus
        case "matrix":
            return scale + zero + minus
        case "psd" | "nonneg":
            return scale + zero
        case "pd" | "positive":
            return scale
        case "nonsingular":
            return scale + minus + turn + [("inverted", lambda x: x.inverse())]
        case "nonzero":
            return scale + minus
    return []


def _scaled(x: Any, c: Any) -> Any:
    return {k: v * c for k, v in x.items()} if isinstance(x, dict) else x * c


def _substitutions(data: dict) -> Iterator[Callable[[dict], dict]]:
    """Changes of the values of variables, singly and two at a time, and exchanges."""
    single = [(name, f) for name, kind in data["over"] for _, f in _maps(kind[0])]

    def change(pairs: tuple) -> Callable[[dict], dict]:
        return lambda values: {**values, **{name: f(values[name]) for name, f in pairs}}

    def exchange(x: str, y: str) -> Callable[[dict], dict]:
        return lambda values: {**values, x: values[y], y: values[x]}

    yield lambda values: values
    yield from (change((s,)) for s in single)
    for (x, s), (y, t) in combinations(data["over"], 2):
        if s == t and s[0] != "integer":
            yield exchange(x, y)
    yield from (change((s, t)) for s, t in combinations(single, 2) if s[0] != t[0])


_FAULTS = (Undefined, Unknown, KeyError, TypeError, AttributeError)


def _says_the_same(moved: list[World], f: Any, worlds: list[World], g: Any, local: Mapping[str, int] | None = None) -> bool:
    """f in the first worlds says the same as g in the others."""
    try:
        return all(_same_formula(w, f, v, g, dict(local or {})) for w, v in zip(moved, worlds, strict=True))
    except _FAULTS:
        return False


def _same_formula(w: World, f: Any, v: World, g: Any, local: dict) -> bool:
    """f in world w says the same as g in world v."""
    if isinstance(f, int) or isinstance(g, int) or f[0] != g[0] or len(f) != len(g):
        return False
    op = f[0]
    if op in _CONNECTIVES:
        return all(_same_formula(w, a, v, b, local) for a, b in zip(f[1:], g[1:], strict=True))
    if op in ("forall", "exists"):
        low, high = (w.integer(f[k], local) for k in (2, 3))
        if f[1] != g[1] or (v.integer(g[2], local), v.integer(g[3], local)) != (low, high):
            return False
        return all(_same_formula(w, f[4], v, g[4], {**local, f[1]: k}) for k in range(low, high + 1))
    if op == "always":
        return False
    a = [w.value(x, local) for x in f[1:]]
    b = [v.value(x, local) for x in g[1:]]
    if op in ("<", "<=", ">", ">=", "loewner"):
        a, b, op = [a[0] - a[1]], [b[0] - b[1]], "psd"
    if op == "=":  # every difference of neighbours says the same, up to a factor and a transpose
        return all(_same_zero(x - y, s - t) for x, y, s, t in zip(a, a[1:], b, b[1:], strict=False))
    return all(any(_equal(x, y * c) if isinstance(y, (Matrix, Laurent)) or not isinstance(y, int) else x == y
                   for c in _FACTORS.get(op, (1,))) for x, y in zip(a, b, strict=True))


def _same_zero(x: Any, y: Any) -> bool:
    """x = 0 says the same as y = 0."""
    turned = [x, x.transpose()] if isinstance(x, Matrix) else [x]
    return any(_equal(t, y * c) for t in turned for c in (1, -1, 2, Fraction(1, 2)))


def subtree(tree: Any, path: tuple[int, ...]) -> Any:
    """What stands at the end of a path."""
    for k in path:
        tree = tree[k]
    return tree
