# SPDX-License-Identifier: MIT
"""What is a statement: names, types, numbers of arguments.

A tree that one reader of the checker takes for one thing and another for a second would let a proof about
the one pass for a proof about the other. So a statement is refused before anything is read if an
operation has too few or too many arguments, if a name is not declared or hides another, or if a number is none.
A formula is no term: x = y is false of two symbols, and as the number 0 it would be one on every instance.

Main definitions
----------------
`check_statement`
    Raises `Rejected` with what is wrong.
`check_formula`
    The same for a formula of the evidence.
`check_arguments`
    The same for the operation at the root of a tree of the evidence.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from typing import Any

from exactkf.kernel.numbers import Rejected

__all__ = ["ARGUMENTS", "BINDERS", "TYPES", "check_arguments", "check_formula", "check_statement", "check_variables"]

#: type of a variable -> number of arguments
TYPES = {
    "scalar": 0, "nonzero": 0, "positive": 0, "nonneg": 0, "integer": 2, "sequence": 2, "signal": 1, "sequence_of": 3, "signal_of": 2,
    "matrix": 2, "symmetric": 1, "psd": 1, "pd": 1, "nonsingular": 1, "diagonal": 1, "poly": 1, "monic": 1,
}
_MATRICES = ("matrix", "symmetric", "psd", "pd", "nonsingular", "diagonal")
_MANY = 1 << 30

#: operation -> (least, most) number of arguments
ARGUMENTS: dict[str, tuple[int, int]] = {
    "z": (0, 0), "rat": (2, 2), "sym": (1, 1), "at": (2, _MANY), "entry": (2, 3), "if": (3, 3), "mat": (5, 5), "col": (3, 3), "real_roots": (3, 3),
    **dict.fromkeys(("sum", "prod", "forall", "exists"), (4, 4)),
    **dict.fromkeys(("+", "*", "=", "<", "<=", ">", ">="), (2, _MANY)),
    **dict.fromkeys(("block", "rows", "diag", "and", "or"), (1, _MANY)),
    **dict.fromkeys(("-", "/", "^", "cospi", "O", "coeff", "rev", "subst", "laurent", "stein", "!=", "loewner", "similar", "cospectral", "coprime",
                     "prints", "observable", "detectable", "=>", "<=>", "always"), (2, 2)),
    **dict.fromkeys(("neg", "sqrt", "abs", "I", "T", "inv", "det", "tr", "rank", "charpoly", "kernel", "nrows", "ncols", "deg", "recip",
                     "roots_in", "roots_on", "roots_out", "psd", "pd", "symmetric", "invertible", "symplectic", "schur", "pos_circle",
                     "nonneg_circle", "defined", "not"), (1, 1)),
}
#: operations whose first arguments are names of indices
BINDERS = {"sum": 1, "prod": 1, "forall": 1, "exists": 1, "always": 1, "col": 1, "mat": 2}
#: operations on formulas, and all that make formulas
_CONNECTIVES = {"and", "or", "not", "=>", "<=>", "forall", "exists", "always", "defined"}
_FORMULAS = _CONNECTIVES | {"=", "!=", "<", "<=", ">", ">=", "loewner", "similar", "cospectral", "coprime", "prints", "psd", "pd", "symmetric", "invertible",
                            "symplectic", "schur", "observable", "detectable", "pos_circle", "nonneg_circle"}
_DECIMAL = re.compile(r"-?[0-9]+(\.[0-9]+)?")


def check_statement(statement: Mapping[str, Any], hiding: bool = True) -> None:
    """Refuse what is no statement.

    An index or a parameter never hides a size, as sizes are read without regard to what is bound; where the kind of the
    certificate follows indices through the statement it hides nothing (``hiding`` is false).
    """
    _need(set(statement) == {"sizes", "over", "where", "given", "says"}, "a statement has sizes, over, where, given, says and nothing else")
    declared = check_variables(statement, statement["over"])
    own = {name for name, kind in declared.items() if kind == "size" or not hiding}
    for d in statement["where"]:
        _definition(d, declared, own)
    for label, formula, kind in statement["given"]:
        _need(isinstance(label, str) and isinstance(kind, str), "a hypothesis has a label and a kind")
        _tree(formula, declared, own)
    _tree(statement["says"], declared, own)


def check_formula(statement: Mapping[str, Any], formula: Any, *bound: str) -> None:
    """Refuse what is no formula in the names of a statement and these indices: the evidence shows it, and uses it as it stands."""
    declared = dict([*((name, "size") for name in statement["sizes"]), *statement["over"], *((d[1], d) for d in statement["where"])])
    own = {name for name, kind in declared.items() if kind == "size"}
    _bound(bound, own)
    _tree(formula, declared, own, bound)


def check_variables(statement: Mapping[str, Any], over: Any) -> dict[str, Any]:
    """Names with what they stand for: identifiers, each of one thing, none of it the horizon; types exist."""
    kinds = [*((name, "size") for name in statement["sizes"]), *over, *((d[1], d) for d in statement["where"])]
    for name, _ in kinds:
        _need(isinstance(name, str) and name.isidentifier() and name != "horizon", f"{name!r} is no name for a size, a variable or a definition")
    declared = dict(kinds)
    _need(len(declared) == len(kinds), "two things have one name")
    for name, kind in over:
        one = kind[-1] if kind[0] in ("sequence_of", "signal_of") else kind
        fits = all(TYPES.get(k[0]) == len(k) - 1 for k in (kind, one)) and (one is kind or one[0] in _MATRICES)
        _need(fits, f"{name} is of a type that does not exist")
        for x in (*kind[1:-1], *one[1:]) if one is not kind else kind[1:]:
            _term(x, declared, declared)
    return declared


def _definition(d: Any, declared: Mapping[str, Any], own: Collection[str]) -> None:
    _need(d[0] == "let" and len(d) == 4 or d[0] == "rec" and len(d) == 6, "a definition is a let or a rec")
    names = d[2] if d[0] == "let" else [d[2]]
    _need(isinstance(names, list) and len(set(names)) == len(names), f"{d[1]} has two parameters of one name")
    _bound(names, own)
    (_tree if d[0] == "let" else _term)(d[-1], declared, own, names)
    if d[0] == "rec":
        _need(type(d[3]) is int and isinstance(d[4], list), f"{d[1]} starts at an integer, with a list of values")
        for x in d[4]:
            _term(x, declared, own)


def _bound(names: Any, own: Collection[str]) -> None:
    for name in names:
        _need(isinstance(name, str) and name.isidentifier() and name not in own, f"index {name!r} is no name, or hides another")


def _tree(tree: Any, declared: Mapping[str, Any], own: Collection[str], bound: Collection[str] = ()) -> None:
    if type(tree) is int:
        return
    check_arguments(tree)
    op, args = tree[0], tree[1:]
    if op == "rat":
        _need(type(args[0]) is int and type(args[1]) is int and args[1] > 0, f"{tree} is no rational number")
        return
    if op in ("sym", "at"):
        if not isinstance(args[0], str) or args[0] not in declared and args[0] not in bound:
            raise Rejected(f"name {args[0]!r} is not declared")
        if op == "at":
            least, most = (1, 2) if args[0] in bound else _indices(declared[args[0]])
            if not least <= len(args) - 1 <= most:
                raise Rejected(f"{args[0]!r} with {len(args) - 1} indices")
        args = args[1:]
    if op in BINDERS:
        names, args = args[:BINDERS[op]], args[BINDERS[op]:]
        _bound(names, own)
        bound = {*bound, *names}
    if op == "prints":
        _printed(args[1])
        args = args[:1]
    if op in ("block", "rows"):
        _need(all(isinstance(row, list) and row for row in args), f"a row of {op!r} is empty")
        args = [x for row in args for x in row]
    for x in args:
        (_tree if op == "if" or op in _CONNECTIVES and (op not in BINDERS or x is args[-1]) else _term)(x, declared, own, bound)


def _term(tree: Any, declared: Mapping[str, Any], own: Collection[str], bound: Collection[str] = ()) -> None:
    """No formula, itself or by the names of definitions that are."""
    _tree(tree, declared, own, bound)
    todo: list[tuple[Any, Collection[str]]] = [(tree, bound)]
    seen = set[str]()
    while todo:
        x, hidden = todo.pop()
        op = x[0] if isinstance(x, (list, tuple)) and x else ""
        if op in _FORMULAS:
            raise Rejected(f"a formula stands where a term is needed: {str(tree)[:80]}")
        if op == "if":
            todo.extend((y, hidden) for y in x[2:])
        elif op in ("sym", "at") and x[1] not in hidden and x[1] not in seen and declared[x[1]][0] == "let":
            seen.add(x[1])
            todo.append((declared[x[1]][3], declared[x[1]][2]))


def check_arguments(tree: Any) -> None:
    """The operation exists, and has as many arguments as it takes."""
    least, most = ARGUMENTS.get(tree[0], (1, 0)) if isinstance(tree, (list, tuple)) and tree and isinstance(tree[0], str) else (1, 0)
    if not least <= len(tree) - 1 <= most if isinstance(tree, (list, tuple)) else True:
        raise Rejected(f"{str(tree)[:80]} is no term or formula: an operation that does not exist, or with too few or too many arguments")


def _indices(kind: Any) -> tuple[int, int]:
    """Least and largest number of indices of what is declared."""
    if kind[0] == "let" and kind[2]:
        return len(kind[2]), len(kind[2])
    return (1, 2) if kind[0] in ("let", *_MATRICES) else (1, 1)


def _printed(printed: Any) -> None:
    """A decimal, or a table of them."""
    rows = [[printed]] if isinstance(printed, str) else printed
    _need(all(isinstance(x, str) and _DECIMAL.fullmatch(x) for row in rows for x in row), "what is printed is a decimal, or a table of them")


def _need(condition: bool, step: str) -> None:
    if not condition:
        raise Rejected(step)
