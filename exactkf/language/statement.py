# SPDX-License-Identifier: MIT
"""Statements: variables with types, definitions, hypotheses, conclusion.

Main definitions
----------------
`Statement`
    One assertion, as printed: sizes, typed variables (``over``), definitions
    (``where``), labelled hypotheses (``given``) and the conclusion (``says``).
`let`, `function`, `rec`
    Definitions: a name for a term; a function of indices (may call itself);
    a sequence given by initial values and a step.
Types
    `scalar`, `integer`, `sequence`, `matrix`, `vector`, `polynomial` ... say
    what a variable ranges over; a type is part of the hypotheses.

A statement is plain data: `Statement.to_json` and `Statement.from_json` are
inverse to each other and run no code.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from exactkf._errors import BadInput
from exactkf.language.tree import OPERATIONS, Expr, to_expr

__all__ = [
    "TYPES", "Statement", "as_lists", "as_tuples", "diagonal", "function", "given", "integer", "let", "matrix", "monic", "nonneg",
    "nonsingular", "nonzero", "polynomial", "positive", "positive_definite", "positive_semidefinite", "rec", "scalar", "sequence",
    "sequence_of", "signal", "signal_of", "standing", "symmetric_matrix", "vector",
]

#: type -> number of arguments
TYPES = {
    "scalar": 0, "nonzero": 0, "positive": 0, "nonneg": 0, "integer": 2, "sequence": 2, "signal": 1, "sequence_of": 3, "signal_of": 2,
    "matrix": 2, "symmetric": 1,
    "psd": 1, "pd": 1, "nonsingular": 1, "diagonal": 1, "poly": 1, "monic": 1,
}


#: types of a single matrix
MATRICES = ("matrix", "symmetric", "psd", "pd", "nonsingular", "diagonal")


def _type(name: str, doc: str):
    def build(*args: Any) -> tuple:
        if len(args) != TYPES[name]:
            raise BadInput(f"type {name} takes {TYPES[name]} arguments, {len(args)} given")
        return (name, *(to_expr(a).tree for a in args))
    build.__doc__ = doc
    return build


scalar = _type("scalar", "A real number.")
nonzero = _type("nonzero", "A real number that is not zero.")
positive = _type("positive", "A real number greater than zero.")
nonneg = _type("nonneg", "A real number, zero or greater.")
integer = _type("integer", "integer(lo, hi): an integer with lo <= k <= hi.")
sequence = _type("sequence", "sequence(lo, hi): scalars s_lo .. s_hi.")
signal = _type("signal", "signal(lo): scalars s_lo, s_lo+1, ... without end; instances list the first few.")
matrix = _type("matrix", "matrix(r, c): any r x c matrix.")
symmetric_matrix = _type("symmetric", "symmetric_matrix(n): any symmetric n x n matrix.")
positive_semidefinite = _type("psd", "positive_semidefinite(n): symmetric, n x n, x'Px >= 0.")
positive_definite = _type("pd", "positive_definite(n): symmetric, n x n, x'Px > 0 for x != 0.")
nonsingular = _type("nonsingular", "nonsingular(n): n x n with nonzero determinant.")
diagonal = _type("diagonal", "diagonal(n): n x n diagonal matrix.")
polynomial = _type("poly", "polynomial(n): polynomial in z of degree at most n.")
monic = _type("monic", "monic(n): z^n + lower terms.")


def sequence_of(type: tuple, lo: Any, hi: Any) -> tuple:
    """sequence_of(matrix(n, p), lo, hi): matrices M_lo .. M_hi, each of a type."""
    return ("sequence_of", to_expr(lo).tree, to_expr(hi).tree, _of_matrices(type))


def signal_of(type: tuple, lo: Any) -> tuple:
    """signal_of(positive_definite(p), lo): matrices R_lo, R_lo+1, ... without end; instances list the first few."""
    return ("signal_of", to_expr(lo).tree, _of_matrices(type))


def _of_matrices(type: tuple) -> tuple:
    if not isinstance(type, tuple) or type[:1] not in [(m,) for m in MATRICES]:
        raise BadInput(f"argument 'type' = {type!r} is no type of a matrix; for scalars use sequence or signal")
    return type


def vector(length: Any) -> tuple:
    """vector(n): a column of n scalars, ``v[i]`` counted from 1."""
    return matrix(length, 1)


def let(name: Expr, body: Any) -> tuple:
    """A name for a term."""
    return ("let", name.tree[1], (), to_expr(body).tree)


def function(name: Expr, params: Sequence[Expr], body: Any) -> tuple:
    """A function of integer indices (or other values); it may call itself."""
    return ("let", name.tree[1], tuple(p.tree[1] for p in params), to_expr(body).tree)


def rec(name: Expr, index: Expr, initial: Any, step: Any, start: int = 0) -> tuple:
    """A sequence: ``initial`` is the value at ``start`` (a list: the first values), ``step`` the value at index + 1."""
    values = initial if isinstance(initial, (list, tuple)) else [initial]
    return ("rec", name.tree[1], index.tree[1], start, tuple(to_expr(v).tree for v in values), to_expr(step).tree)


def given(label: str, formula: Expr) -> tuple:
    """A hypothesis that the statement needs: dropping it must make the statement false."""
    return (label, formula.tree, "needed")


def standing(label: str, formula: Expr) -> tuple:
    """A hypothesis of the setting: not claimed to be necessary."""
    return (label, formula.tree, "standing")


@dataclass(frozen=True)
class Statement:
    """One assertion.

    Parameters
    ----------
    says : Expr
        The conclusion.
    over : mapping of name to type
        The free variables, in order. Here, in ``sizes`` and in ``tex`` a name is a str or the `Expr` of `symbols`.
    sizes : sequence of names
        The sizes (integers >= 0) that types and terms mention.
    where : sequence of definitions
        From `let`, `function`, `rec`; each may use those before it (and itself).
    given : sequence of hypotheses
        From `given` and `standing`; a mapping of label to formula is read as `given`.
    tex : mapping of name to LaTeX
        How names are printed, where that differs from `exactkf.language.names`. It is no part of the JSON: what is
        checked does not depend on it.
    """

    says: Any
    over: Mapping[Any, tuple] | Sequence[Any] = ()
    sizes: Sequence[Any] = ()
    where: Sequence[tuple] = ()
    given: Any = ()
    tex: Mapping[Any, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        set_ = object.__setattr__
        # of a mapping put together from groups of variables, the last type of a name counts
        over = {_name(n): t for n, t in self.over.items()}.items() if isinstance(self.over, Mapping) else self.over
        set_(self, "over", tuple((_name(n), _type_of(n, t)) for n, t in over))
        hyps = self.given.items() if isinstance(self.given, Mapping) else self.given
        set_(self, "given", tuple(h if len(h) == 3 else (h[0], to_expr(h[1]).tree, "needed") for h in hyps))
        set_(self, "sizes", tuple(_name(n) for n in self.sizes))
        set_(self, "where", _flat(self.where))
        set_(self, "tex", {_name(n): latex for n, latex in self.tex.items()})
        set_(self, "says", self.says.tree if isinstance(self.says, Expr) else self.says)
        _check(self)

    def _repr_latex_(self) -> str:
        """The formula, as a notebook shows it."""
        from exactkf.language.latex import statement_latex

        return f"$\\displaystyle {statement_latex(self)}$"

    def to_json(self) -> dict:
        """Plain data, see the module's docstring."""
        return {"sizes": list(self.sizes), "over": as_lists(self.over), "where": as_lists(self.where),
                "given": as_lists(self.given), "says": as_lists(self.says)}

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Statement:
        """Read what `to_json` wrote; anything else raises BadInput."""
        try:
            return cls(says=as_tuples(data["says"]), over=as_tuples(data["over"]), sizes=as_tuples(data["sizes"]),
                       where=as_tuples(data["where"]), given=as_tuples(data["given"]))
        except (KeyError, TypeError, ValueError, IndexError) as error:
            raise BadInput(f"argument 'data' is not a statement: {error!r}; write it with Statement.to_json") from error

    def digest_text(self) -> str:
        """One canonical line, the text that certificates hash."""
        return json.dumps(self.to_json(), separators=(",", ":"), sort_keys=True)


def _name(name: Any) -> Any:
    return name.tree[1] if isinstance(name, Expr) and isinstance(name.tree, tuple) and name.tree[0] == "sym" else name


def _type_of(name: Any, kind: Any) -> tuple:
    if not isinstance(kind, (tuple, list)):
        raise BadInput(f"variable {name!r} has {kind!r} in place of a type; write matrix(n, n), scalar() or another of exactkf.language.TYPES")
    return tuple(kind)


def _flat(items: Iterable) -> tuple:
    """Allow groups of definitions inside ``where``."""
    out: list = []
    for item in items:
        if isinstance(item[0], str):
            out.append(tuple(item))
        else:
            out.extend(_flat(item))
    names: dict[str, tuple] = {}
    for item in out:
        if names.setdefault(item[1], item) != item:
            raise BadInput(f"definition of {item[1]!r} is given twice with different bodies; rename one")
    return tuple(names.values())


def as_lists(value: Any) -> Any:
    """Trees as JSON lists."""
    return [as_lists(v) for v in value] if isinstance(value, (list, tuple)) else value


def as_tuples(value: Any) -> Any:
    """JSON lists as the tuples of trees."""
    return tuple(as_tuples(v) for v in value) if isinstance(value, (list, tuple)) else value


def _check(statement: Statement) -> None:
    names = [*statement.sizes, *(n for n, _ in tuple(statement.over)), *(d[1] for d in statement.where)]
    known = set(names)
    for name in names:
        if not isinstance(name, str):
            raise BadInput(f"{name!r} is no name; name sizes and variables by a str or by what symbols('...') gives")
        if names.count(name) > 1:
            raise BadInput(f"name {name!r} is declared {names.count(name)} times among sizes, over and where; rename one")
    for name in statement.tex:
        if name not in known:
            raise BadInput(f"argument 'tex' = {dict(statement.tex)!r} prints {name!r}, which the statement does not have; leave it out")
    for name, type_ in tuple(statement.over):
        known_type = type_[0] in TYPES and len(type_) == TYPES[type_[0]] + 1
        if known_type and type_[0] in ("sequence_of", "signal_of"):
            known_type = isinstance(type_[-1], tuple) and type_[-1][:1] in [(m,) for m in MATRICES] and len(type_[-1]) == TYPES[type_[-1][0]] + 1
        if not known_type:
            raise BadInput(f"variable {name!r} has unknown type {type_!r}; see exactkf.language.TYPES")
        for extent in (*type_[1:-1], *type_[-1][1:]) if type_[0] in ("sequence_of", "signal_of") else type_[1:]:
            _check_tree(extent, known)
    for definition in statement.where:
        if definition[0] == "let":
            _check_tree(definition[3], known | set(definition[2]))
        elif definition[0] == "rec":
            _check_tree(definition[5], known | {definition[2]})
        else:
            raise BadInput(f"definition {definition!r} is neither let nor rec")
    for label, formula, _kind in statement.given:
        _check_tree(formula, known)
        _check_formula(formula, f"hypothesis {label!r}")
        _check_always(formula, False, f"hypothesis {label!r}")
    _check_tree(statement.says, known)
    _check_formula(statement.says, "the conclusion")
    _check_always(statement.says, True, "the conclusion")


def _check_always(tree: Any, positive: bool, where: str) -> None:
    """A statement for all t is seen up to a horizon only: it may be concluded, never assumed or denied."""
    if not isinstance(tree, tuple):
        return
    if tree and tree[0] == "always" and not positive:
        raise BadInput(f"{where} assumes or denies an 'always'; use forall with a bound, or conclude it")
    for k, part in enumerate(tree[1:], 1):
        _check_always(part, positive and tree[0] in ("and", "or", "forall", "exists", "always", "=>") and not (tree[0] == "=>" and k == 1), where)


_TERMS = ("+", "-", "*", "/", "^", "neg", "abs", "rat", "T", "inv", "I", "O", "block", "rows", "sum", "prod", "entry")


def _check_formula(tree: Any, where: str) -> None:
    if isinstance(tree, int) or (isinstance(tree, tuple) and tree[:1] in [(op,) for op in _TERMS]):
        raise BadInput(f"{where} is the term {Expr(tree)!r}, of which nothing is said; write an equation, an order or a property")


_BINDERS = {"sum": 1, "prod": 1, "forall": 1, "exists": 1, "always": 1, "col": 1, "mat": 2}


def _check_tree(tree: Any, known: set[str]) -> None:
    """Refuse unknown operations, wrong numbers of arguments and undeclared names."""
    if isinstance(tree, bool) or not isinstance(tree, (int, tuple)):
        raise BadInput(f"{tree!r} is not a term; expected an int or an operation")
    if isinstance(tree, int):
        return
    op, args = (tree[0], tree[1:]) if tree else (None, ())
    if op not in OPERATIONS:
        raise BadInput(f"unknown operation {op!r}; see exactkf.language.OPERATIONS")
    least, most = OPERATIONS[op]
    if len(args) < least or (most is not None and len(args) > most):
        raise BadInput(f"operation {op!r} takes {least}..{most} arguments, {len(args)} given")
    if op == "sym" or op == "at":
        if args[0] not in known:
            raise BadInput(f"name {args[0]!r} is not declared; add it to sizes, over or where")
        args = args[1:]
    if op == "rat":
        if not all(isinstance(a, int) for a in args) or args[1] <= 0:
            raise BadInput(f"rational number {tree!r} needs two integers, the second positive")
        return
    if op == "prints":
        args = args[:1]
    if op in ("block", "rows"):
        args = tuple(x for row in args for x in row)
    bound = _BINDERS.get(op, 0)
    for arg in args[bound:]:
        _check_tree(arg, known | set(args[:bound]))
