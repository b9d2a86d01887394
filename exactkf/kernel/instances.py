# SPDX-License-Identifier: MIT
"""Instances of a statement: read, tested, or made of symbols.

`read_instance` reads the values of an instance from JSON and checks their
shapes; `admissible` says whether types and hypotheses hold; `generic` makes
the world in which every variable consists of independent symbols.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.linear import Matrix
from exactkf.kernel.meaning import Listed, Signal, World, count, indices, is_invertible, is_pd, is_psd, is_symmetric, truth
from exactkf.kernel.numbers import Laurent, Undefined, Unknown, fraction, rational
from exactkf.kernel.symbolic import SymbolicField

__all__ = ["admissible", "computed", "generic", "read_instance", "read_number"]


def read_number(text: Any, field: AlgebraicField | None) -> Any:
    """An int, 'p/q', or a list of coefficients in theta."""
    if isinstance(text, list):
        if field is None:
            raise Undefined("an algebraic number needs the instance's field")
        return field.element([fraction(c) for c in text])
    value = fraction(text)
    return int(value) if value.denominator == 1 else rational(value.numerator, value.denominator)


def read_instance(statement: Mapping[str, Any], data: Mapping[str, Any], number: Callable[[Any], Any] | None = None) -> dict[str, Any]:
    """Values of sizes and variables from JSON; shapes are checked here, the rest of a type in `admissible`."""
    field = AlgebraicField.of(data["field"]) if data.get("field") else None
    read = number or (lambda x: read_number(x, field))
    values: dict[str, Any] = {}
    for name in statement["sizes"]:
        values[name] = data["sizes"][name]
        if type(values[name]) is not int or values[name] < 0:
            raise Undefined(f"size {name} is not a natural number")
    values["horizon"] = data["sizes"].get("horizon", 5)
    if type(values["horizon"]) is not int or values["horizon"] < 0:
        raise Undefined("the horizon is not a natural number")
    indices(0, values["horizon"])
    for name, kind in statement["over"]:
        values[name] = _read_value(World({"where": statement["where"]}, values), kind, data["values"][name], read)
    return values


def _read_value(world: World, kind: Any, data: Any, read: Callable) -> Any:
    if kind[0] in ("sequence_of", "signal_of"):
        first = world.integer(kind[1], {})
        if kind[0] == "sequence_of" and len(data) != max(0, world.integer(kind[2], {}) - first + 1):
            raise Undefined("a sequence lists all its matrices")
        listed = Listed if kind[0] == "signal_of" else dict
        return listed((first + k, _read_value(world, kind[-1], x, read)) for k, x in enumerate(data))
    args = [world.integer(a, {}) for a in kind[1:]]
    match kind[0]:
        case "integer":
            if isinstance(data, bool) or not isinstance(data, int):
                raise Undefined("an integer is needed")
            return data
        case "scalar" | "nonzero" | "positive" | "nonneg":
            return read(data)
        case "sequence":
            return dict(zip(indices(args[0], args[1]), [read(x) for x in data], strict=True))
        case "signal":
            return Listed((args[0] + k, read(x)) for k, x in enumerate(data))
        case "poly" | "monic":
            if len(data) != args[0] + 1:
                raise Undefined("a polynomial lists its coefficients from z^0 to z^n")
            return Laurent({k: read(x) for k, x in enumerate(data)})
    nrows, ncols = args if kind[0] == "matrix" else args * 2
    if len(data) != nrows or any(len(r) != ncols for r in data):
        raise Undefined(f"a {nrows}x{ncols} matrix is needed")
    return Matrix([[read(x) for x in r] for r in data], ncols)


_TYPE_TESTS: dict[str, Callable[..., bool]] = {
    "integer": lambda v, lo, hi: lo <= v <= hi, "nonzero": lambda v: v != 0, "positive": lambda v: v > 0, "nonneg": lambda v: v >= 0,
    "symmetric": lambda v, n: is_symmetric(v), "psd": lambda v, n: is_psd(v), "pd": lambda v, n: is_pd(v),
    "nonsingular": lambda v, n: is_invertible(v), "monic": lambda v, n: v.get(n) == 1,
    "diagonal": lambda v, n: all(v.rows[i][j] == 0 for i in range(n) for j in range(n) if i != j),
}


def admissible(statement: Mapping[str, Any], world: World) -> str:
    """'' if types and hypotheses hold, else what does not."""
    for name, kind in statement["over"]:
        each, one = ([world.values[name]], kind) if kind[0] not in ("sequence_of", "signal_of") else (world.values[name].values(), kind[-1])
        test = _TYPE_TESTS.get(one[0])
        if test and not all(test(value, *(world.integer(a, {}) for a in one[1:])) for value in each):
            return f"{name} is not of type {one[0]}"
    for label, formula, _kind in statement["given"]:
        if not truth(world, formula, {}):
            return f"hypothesis {label!r} does not hold"
    return ""


def generic(statement: Mapping[str, Any], sizes: Mapping[str, int], given_by: Mapping[str, Any] | None = None,
            new: Callable[[str], Any] | None = None) -> tuple[World, Callable[[str], Any]]:
    """A world in which every variable is made of independent symbols, as far as its type is an equation.

    Inequalities of types (positive, psd, nonsingular ...) are ignored, so that what is
    true in this world is true for every value. Variables in ``given_by`` are computed from the others.
    """
    new = new or SymbolicField().variable
    values: dict[str, Any] = {"horizon": None, **sizes}
    given_by = given_by or {}
    for name, kind in statement["over"]:
        if name in values or name in given_by:
            continue
        values[name] = _generic_variable(World({"where": statement["where"]}, values), name, kind, new)
    world = World(statement, values)
    world.symbolic = True
    kinds = dict(statement["over"])
    for name, tree in given_by.items():
        world.values[name] = computed(world, kinds.get(name, ("",)), tree)
    return world, new


def computed(world: World, kind: Any, tree: Any) -> Any:
    """Value of a term; ``["each", k, term]`` is the sequence of the term's values at the indices of a type."""
    if isinstance(tree, int) or tree[0] != "each":
        return world.value(tree)
    if kind[0] == "signal_of":
        return Signal(world.integer(kind[1], {}), lambda k: world.value(tree[2], {tree[1]: k}))
    if kind[0] not in ("sequence", "sequence_of"):
        raise Unknown("a term with an index for a variable without one")
    return {k: world.value(tree[2], {tree[1]: k}) for k in indices(world.integer(kind[1], {}), world.integer(kind[2], {}))}


def _generic_variable(world: World, name: str, kind: Any, new: Callable[[str], Any]) -> Any:
    if kind[0] not in ("sequence_of", "signal_of"):
        return _generic_value(name, kind[0], [world.integer(a, {}) for a in kind[1:]], new)
    first, args = world.integer(kind[1], {}), [world.integer(a, {}) for a in kind[-1][1:]]

    def entry(k: int) -> Any:
        return _generic_value(f"{name}_{k}", kind[-1][0], args, new)
    if kind[0] == "signal_of":
        return Signal(first, entry)
    return {k: entry(k) for k in indices(first, world.integer(kind[2], {}))}


def _generic_value(name: str, kind: str, args: list[int], new: Callable[[str], Any]) -> Any:
    if kind in ("matrix", "nonsingular", "diagonal", "symmetric", "psd", "pd"):
        args = [count(n) for n in args]
    match kind:
        case "integer":
            raise Unknown(f"integer variable {name} needs a value")
        case "scalar" | "nonzero" | "positive" | "nonneg":
            return new(name)
        case "sequence":
            return {k: new(f"{name}_{k}") for k in indices(args[0], args[1])}
        case "signal":
            return Signal(args[0], lambda k: new(f"{name}_{k}"))
        case "poly":
            return Laurent({k: new(f"{name}_{k}") for k in indices(0, args[0])})
        case "monic":
            return Laurent({k: new(f"{name}_{k}") if k < args[0] else 1 for k in indices(0, args[0])})
        case "matrix" | "nonsingular":
            return Matrix.build(args[0], args[-1], lambda i, j: new(f"{name}_{i + 1}{j + 1}"))
        case "diagonal":
            return Matrix.build(args[0], args[0], lambda i, j: new(f"{name}_{i + 1}") if i == j else 0)
    upper = {(i, j): new(f"{name}_{i + 1}{j + 1}") for i in range(args[0]) for j in range(i, args[0])}
    return Matrix.build(args[0], args[0], lambda i, j: upper[min(i, j), max(i, j)])
