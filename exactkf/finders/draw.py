# SPDX-License-Identifier: MIT
"""Exact instances of a statement, random by construction and degenerate.

Values are drawn so that types hold by construction: a positive semidefinite
matrix is L D L' with unit triangular L and D >= 0, a nonsingular one a product
of triangular factors. Each draw has a *flavour*: small integers, fractions,
or a degenerate shape (zeros, units, repeated rows, low rank).

Main definitions
----------------
`Sampler`
    Admissible instances of one statement, small ones first, at most so many tries.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import product
from random import Random
from typing import Any

from exactkf.evidence import Evidence
from exactkf.finders.solve import Solver
from exactkf.kernel.instances import admissible, computed
from exactkf.kernel.linear import Matrix
from exactkf.kernel.meaning import Signal, World
from exactkf.kernel.numbers import Laurent, Ratio, Undefined, Unknown, rational

__all__ = ["Sampler", "examples_of", "plain"]

_SOLVING = 8  # times the equations of the hypotheses are solved, where the hints do not say
_FLAVOURS = ("small", "small", "fraction", "tiny", "degenerate", "fraction", "wide")


class Sampler:
    """Draws instances of one statement as an `instances` evidence asks for.

    Parameters
    ----------
    statement : dict
        JSON of the statement.
    hints : mapping
        Hints of an `exactkf.evidence.instances`; examples are tried first.
    examples : sequence of mapping
        Values given by hand.
    seed : int or Random
        Same seed, same instances. A `Random` of another kind may be given, such as one that shrinks.
    """

    def __init__(self, statement: Mapping[str, Any], hints: Mapping[str, Any], examples: list[Mapping[str, Any]], seed: int | Random) -> None:
        self.statement, self.examples = statement, examples
        self.sizes = {k: list(v) for k, v in hints.get("sizes", {}).items()}
        self.made_by = hints.get("made_by", {})
        self.using = hints.get("using", {})
        self.horizon = hints.get("horizon", 5)
        self.random = seed if isinstance(seed, Random) else Random(f"{seed}")
        self.rejected: dict[str, int] = {}
        self.solver, self.solving = Solver(statement), hints.get("solving", _SOLVING)
        self.eager = "solving" in hints  # not only where random draws miss
        self.aside = seed if isinstance(seed, Random) else Random(f"{seed}/solved")  # leaves the other draws as they are

    def stream(self, tries: int) -> Iterator[tuple[dict, World]]:
        """Admissible instances with their worlds; the hand-made examples come first.

        Where random draws miss the hypotheses (or the hints ask for it) and nothing says how to make variables, their equations are solved.
        """
        for example in self.examples:
            yield from self._admit(self._from_example(example))
        every = self._every_size()
        most = every[:max(4, 2 * len(every) // 3)]
        solving = self.solving if not self.made_by and self.solver.useful else 0
        admitted = 0
        for k in range(tries):
            sizes = every[k] if k < len(every) else most[k % len(most)]  # the largest sizes once, the others again and again
            flavour = "small" if k < len(every) else self.random.choice(_FLAVOURS)
            found = list(self._try(sizes, flavour))
            admitted += len(found)
            yield from found
            if solving > 0 and (self.eager or (not found and admitted <= k // 8)):
                solving -= 1
                yield from self._solve(sizes)

    def one(self) -> Iterator[tuple[dict, World]]:
        """One draw of any size: an admissible instance with its world, or nothing."""
        yield from self._try(self.random.choice(self._every_size()), self.random.choice(_FLAVOURS))

    def _solve(self, sizes: Mapping[str, int]) -> Iterator[tuple[dict, World]]:
        """One try at solving the equations of the hypotheses."""
        flavour, random = self.aside.choice(_FLAVOURS), self.random
        self.random = self.aside
        try:
            values = self.solver.draw(sizes, lambda kind, args: self._value(kind, args, flavour), self.aside)
        finally:
            self.random = random
        if values is None:
            self._refuse("the equations of the hypotheses were not solved")
            return
        full = {**sizes, "horizon": self.horizon, **values}
        yield from self._admit((self._as_json(full, World(self.statement, full)), full))

    def _every_size(self) -> list[dict[str, int]]:
        every = [dict(zip(self.sizes, c, strict=True)) for c in product(*self.sizes.values())] or [{}]
        return sorted(every, key=lambda s: sum(s.values()))

    def _try(self, sizes: Mapping[str, int], flavour: str) -> Iterator[tuple[dict, World]]:
        try:
            made = self._draw(sizes, flavour)
        except (Undefined, ZeroDivisionError) as error:
            self._refuse(f"construction: {error}")
            return
        yield from self._admit(made)

    def _refuse(self, reason: str) -> None:
        self.rejected[reason] = self.rejected.get(reason, 0) + 1

    def _admit(self, made: tuple[dict, dict]) -> Iterator[tuple[dict, World]]:
        data, values = made
        world = World(self.statement, values)
        try:
            fault = admissible(self.statement, world)
        except Undefined as error:
            fault = str(error)
        if fault:
            self._refuse(fault)
        else:
            yield data, world

    def _from_example(self, example: Mapping[str, Any]) -> tuple[dict, dict]:
        """Complete a hand-made instance (columns as lists, missing horizon) to JSON."""
        from exactkf.kernel.instances import read_instance

        sizes = {n: example[n] for n in self.statement["sizes"]}
        data: dict[str, Any] = {"sizes": {**sizes, "horizon": example.get("horizon", self.horizon)}, "values": {}}
        if "field" in example:
            data["field"] = example["field"]
        for name, kind in self.statement["over"]:
            data["values"][name] = _listed(example[name], kind[0] in _MATRICES) if kind[0] not in ("sequence_of", "signal_of") else [
                _listed(x, True) for x in example[name]]
        return data, read_instance(self.statement, data)

    def _draw(self, sizes: Mapping[str, int], flavour: str) -> tuple[dict, dict]:
        values: dict[str, Any] = {**sizes, "horizon": self.horizon}
        world = World(self.statement, values)
        kinds = dict(self.statement["over"])
        for name, kind in [*self.using.items(), *kinds.items()]:
            if name not in self.made_by and name not in values:
                values[name] = world.values[name] = self._variable(kind, world, flavour)
        for name, tree in self.made_by.items():
            made = computed(world, kinds.get(name) or self.using.get(name, ("",)), tree)
            if isinstance(made, Signal):
                made = {k: made[k] for k in range(made.start, made.start + self.horizon + 3)}
            if kinds.get(name, ("",))[0] in ("sequence", "signal") and isinstance(made, Matrix):  # a column lists the entries
                made = dict(enumerate((row[0] for row in made.rows), world.integer(kinds[name][1], {})))
            values[name] = world.values[name] = made
        return self._as_json(values, world), {k: v for k, v in values.items() if k in kinds or k in sizes or k == "horizon"}

    def _as_json(self, values: Mapping[str, Any], world: World) -> dict:
        return {"sizes": {**{n: values[n] for n in self.statement["sizes"]}, "horizon": self.horizon},
                "values": {name: _padded(plain(values[name]), kind, world) for name, kind in self.statement["over"]}}

    # ------------------------------------------------------------------ values
    def number(self, flavour: str) -> Any:
        r = self.random
        match flavour:
            case "degenerate":
                return r.choice((0, 0, 0, 1, -1, rational(1, 2)))
            case "tiny":
                return r.choice((0, 1, -1, 2))
            case "small":
                return r.choice((0, 1, -1, 2, -2, 3, -3, rational(1, 2), rational(-1, 2)))
            case "wide":
                return _tidy(rational(r.randint(-12, 12), r.randint(1, 7)))
        return _tidy(rational(r.randint(-5, 5), r.randint(1, 5)))

    def _nonzero(self, flavour: str) -> Any:
        for _ in range(8):
            if (x := self.number("small" if flavour == "degenerate" else flavour)) != 0:
                return x
        return 1  # where a source of choices shrinks to zeros

    def _variable(self, kind: Any, world: World, flavour: str) -> Any:
        if kind[0] not in ("sequence_of", "signal_of"):
            return self._value(kind[0], [world.integer(a, {}) for a in kind[1:]], flavour)
        first, args = world.integer(kind[1], {}), [world.integer(a, {}) for a in kind[-1][1:]]
        last = world.integer(kind[2], {}) if kind[0] == "sequence_of" else first + self.horizon + 2
        return {k: self._value(kind[-1][0], args, flavour) for k in range(first, last + 1)}

    def _value(self, kind: str, args: list[int], flavour: str) -> Any:
        if kind in _MATRICES and min(args) < 0:
            raise Undefined("negative size")
        match kind:
            case "scalar":
                return self.number(flavour)
            case "nonzero":
                return self._nonzero(flavour)
            case "positive":
                return abs(self._nonzero(flavour))
            case "nonneg":
                return abs(self.number(flavour))
            case "integer":
                return self.random.randint(args[0], max(args[0], args[1]))
            case "sequence":
                return {k: self.number(flavour) for k in range(args[0], args[1] + 1)}
            case "signal":
                return {k: self.number(flavour) for k in range(args[0], args[0] + self.horizon + 3)}
            case "poly" | "monic":
                top = {args[0]: 1} if kind == "monic" else {args[0]: self.number(flavour)}
                return Laurent({k: self.number(flavour) for k in range(args[0])} | top)
            case "matrix":
                return self._matrix(args[0], args[1], flavour)
        return getattr(self, f"_{kind}")(args[0], flavour)

    def _matrix(self, nrows: int, ncols: int, flavour: str) -> Matrix:
        m = Matrix.build(nrows, ncols, lambda i, j: self.number(flavour))
        if flavour == "degenerate" and nrows > 1 and self.random.random() < 0.4:
            m.rows[-1] = list(m.rows[0])  # dependent rows
        return m

    def _symmetric(self, n: int, flavour: str) -> Matrix:
        m = self._matrix(n, n, flavour)
        return Matrix.build(n, n, lambda i, j: m.rows[max(i, j)][min(i, j)])

    def _unit_lower(self, n: int, flavour: str) -> Matrix:
        return Matrix.build(n, n, lambda i, j: 1 if i == j else self.number(flavour) if i > j else 0)

    def _psd(self, n: int, flavour: str) -> Matrix:
        keep = self.random.choice((0.0, 0.35, 0.7)) if flavour != "degenerate" else 0.8
        pivots = [0 if self.random.random() < keep else abs(self._nonzero(flavour)) for _ in range(n)]
        lower = self._unit_lower(n, flavour)
        return lower * Matrix.build(n, n, lambda i, j: pivots[i] if i == j else 0) * lower.transpose()

    def _pd(self, n: int, flavour: str) -> Matrix:
        if flavour == "degenerate":
            return Matrix.identity(n)
        pivots = [abs(self._nonzero(flavour)) for _ in range(n)]
        lower = self._unit_lower(n, flavour)
        return lower * Matrix.build(n, n, lambda i, j: pivots[i] if i == j else 0) * lower.transpose()

    def _nonsingular(self, n: int, flavour: str) -> Matrix:
        if flavour == "degenerate":
            order = self.random.sample(range(n), n)
            return Matrix.build(n, n, lambda i, j: int(order[i] == j) * self.random.choice((1, -1)))
        pivots = [self._nonzero(flavour) for _ in range(n)]
        upper = self._unit_lower(n, flavour).transpose()
        return self._unit_lower(n, flavour) * Matrix.build(n, n, lambda i, j: pivots[i] if i == j else 0) * upper

    def _diagonal(self, n: int, flavour: str) -> Matrix:
        return Matrix.build(n, n, lambda i, j: self.number(flavour) if i == j else 0)


_MATRICES = {"matrix", "symmetric", "psd", "pd", "nonsingular", "diagonal"}


def _tidy(x: Any) -> Any:
    return int(x) if x.denominator == 1 else x


def _listed(value: Any, is_matrix: bool) -> Any:
    """Hand-made values as JSON: a flat list given for a matrix is a column."""
    if isinstance(value, (list, tuple)):
        if is_matrix and value and not isinstance(value[0], (list, tuple)):
            return [[_listed(x, False)] for x in value]
        return [_listed(x, False) for x in value]
    return str(value) if isinstance(value, Fraction) else value


def _padded(value: Any, kind: Any, world: World) -> Any:
    """Coefficients of a polynomial up to z^n, the zero ones at the top too."""
    if kind[0] not in ("poly", "monic"):
        return value
    value = value if isinstance(value, list) else [value]
    return value + [0] * (world.integer(kind[1], {}) + 1 - len(value))


def plain(value: Any) -> Any:
    """A value as JSON: ints, 'p/q', lists."""
    if isinstance(value, Matrix):
        return [[plain(x) for x in r] for r in value.rows]
    if isinstance(value, Laurent):
        return [plain(x) for x in value.dense()]
    if isinstance(value, dict):
        return [plain(value[k]) for k in sorted(value)]
    if isinstance(value, Ratio):
        raise Unknown("a rational function of z as a drawn value")
    if isinstance(value, int):
        return value
    if hasattr(value, "denominator"):
        return int(value.numerator) if value.denominator == 1 else f"{value.numerator}/{value.denominator}"
    raise Unknown(f"a drawn value of type {type(value).__name__}")


def examples_of(by: tuple[Evidence, ...]) -> list[Mapping[str, Any]]:
    """Instances given by hand among the evidence."""
    return [{"horizon": e.hints["horizon"], **e.hints["values"]} for e in by if e.kind == "example"]
