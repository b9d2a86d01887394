# SPDX-License-Identifier: MIT
"""What the definitions of a statement are, wherever they are used: recursive, polynomials in z, matrices, made with inverses.

Main definitions
----------------
`Known`
    What a statement alone decides.
`known`
    That of a statement, once for all terms that are read in a row.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from exactkf.kernel.opaque import without_indices
from exactkf.kernel.region import Form, Region

__all__ = ["MATRICES", "OF_PARTS", "Known", "inverts", "known", "names"]

#: types of matrices
MATRICES = ("matrix", "symmetric", "psd", "pd", "nonsingular", "diagonal")
#: types of numbers and polynomials
_NUMBERS = ("scalar", "nonzero", "positive", "nonneg", "integer", "poly", "monic")
_OF_NUMBERS = {"rat", "z", "coeff", "laurent", "det", "tr", "entry", "charpoly", "rev", "cospi", "sqrt", "abs", "rank", "deg", "nrows", "ncols"}
#: operations that are numbers if these arguments are
OF_PARTS = {**dict.fromkeys(("+", "-", "*", "neg", "recip"), slice(1, None)), "/": slice(1, 2), "^": slice(1, 2), "subst": slice(2, 3),
            "if": slice(2, 4), "sum": slice(4, 5), "prod": slice(4, 5)}


def _once(find: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
    """The same answer about a term, looked for once; a term that was looked at is kept, so that no other takes its id."""
    def asked(self: Known, tree: Any) -> Any:
        answers = self.answers[find]
        answer = answers.get(id(tree))
        if answer is None:
            answer = answers[id(tree)] = find(self, tree), tree
        return answer[0]

    asked.__doc__ = find.__doc__
    return asked


class Known:
    """What a statement alone decides.

    Attributes
    ----------
    kinds : types of its variables
    recursive, inverting : definitions that are recursive, that invert matrices
    in_z : names whose value depends on z
    kept : recursions, with whether all their values are of one shape
    shapes : shapes of names in a region, on which nothing else has an effect
    matrices, symmetric : matrix variables that are no columns, and those that are symmetric by their type
    reached, connected : names that a definition leads to, and those that lead back to it
    """

    def __init__(self, statement: Mapping[str, Any]) -> None:
        self.statement, self.definitions = statement, {d[1]: d for d in statement["where"]}
        self.kinds = dict(statement["over"])
        self.sequences = {name for name, kind in self.kinds.items() if kind[0] in ("sequence", "signal", "vector") or kind[0] == "matrix" and kind[2] == 1}
        self.scalars = {name for name, kind in self.kinds.items() if kind[0] in ("scalar", "nonzero", "positive", "nonneg")}
        definitions = self.definitions
        polynomials = {name for name, kind in self.kinds.items() if kind[0] in ("poly", "monic")}
        self.recursive = _recursive(definitions)
        self.in_z = polynomials | _spread(definitions, lambda tree, found: _mentions_z(tree, found | polynomials))
        self.inverting = _spread(definitions, inverts)
        self.kept: dict[str, bool] = {}
        self.shapes: dict[tuple[Region, str], tuple[Form, Form]] = {}
        self.matrices = {name for name, kind in self.kinds.items() if kind[0] in MATRICES and kind[-1] != 1}
        self.symmetric = {name for name, kind in self.kinds.items() if kind[0] in ("symmetric", "psd", "pd", "diagonal")}
        self._letters = self.matrices | _spread(definitions, lambda tree, found: not (self.matrices | found).isdisjoint(names(tree)))
        self.answers: dict[Callable, dict[int, tuple[Any, Any]]] = defaultdict(dict)
        self._named = {name for name, kind in self.kinds.items() if kind[0] not in _NUMBERS}
        self._called = {name for name, kind in self.kinds.items() if kind[0] in ("sequence_of", "signal_of")}  # an entry is a matrix
        self._no_numbers = _spread(definitions, self._other)
        self.calls = {n: set(names(list(d))) & set(definitions) for n, d in definitions.items()}
        self.reached = {n: self._leads_to(n) for n in definitions}
        self.connected = {n: {m for m in found if n in self.reached[m]} for n, found in self.reached.items()}

    @_once
    def has_z(self, tree: Any) -> bool:
        """Whether a term depends on z."""
        return _mentions_z(tree, self.in_z)

    @_once
    def has_letters(self, tree: Any) -> bool:
        """Whether a term contains a matrix variable, itself or by the names of definitions that do."""
        return not self._letters.isdisjoint(self.names_in(tree))

    @_once
    def names_in(self, tree: Any) -> set[str]:
        """Names that occur in a term."""
        return set(names(tree))

    def spread(self, letters: set[str]) -> set[str]:
        """These names, and the definitions that mention one of them, or one that does."""
        return letters and letters | _spread(self.definitions, lambda tree, found: not (letters | found).isdisjoint(names(tree)))

    def is_matrix_function(self, name: str) -> bool:
        """Whether a definition that does not lead back to itself stands for matrices, whatever its indices are."""
        d = self.definitions[name]
        return d[0] == "let" and name not in self.recursive and self.is_matrix(d[3])

    @_once
    def is_matrix(self, tree: Any) -> bool:
        """Whether a term is a matrix, perhaps of one row and one column."""
        if isinstance(tree, int):
            return False
        if tree[0] in ("mat", "col", "I", "O", "T", "block", "inv"):
            return True
        if tree[0] in ("^", "subst"):
            return self.is_matrix(tree[1 if tree[0] == "^" else 2])
        if tree[0] in ("sym", "at"):
            d, kind = self.definitions.get(tree[1]), self.kinds.get(tree[1])
            if tree[0] == "sym" and kind and kind[0] in ("vector", *MATRICES):
                return True
            if d is None or d[0] == "rec":
                return d is not None and self.is_matrix(d[4][0])
            body = d[3] if d[1] not in self.recursive else d[3][2] if d[3][0] == "if" else 0  # a recursion is what its first branch is
            return len(d[2]) == len(tree) - 2 and self.is_matrix(body)
        if tree[0] in ("/", "if", "sum"):
            return self.is_matrix(tree[{"/": 1, "if": 2, "sum": 4}[tree[0]]])
        return tree[0] in ("+", "-", "*", "neg") and any(self.is_matrix(x) for x in tree[1:])

    def is_named_matrix(self, name: str) -> bool:
        """Whether a name without indices stands for a matrix that is no column of numbers."""
        d = self.definitions.get(name)
        return name in self.matrices or d is not None and d[0] == "let" and not d[2] and self.is_matrix(d[3])

    @_once
    def is_number(self, tree: Any) -> bool:
        """Whether a term is surely a number or a polynomial."""
        return not self.is_matrix(tree) and not self._other(tree, self._no_numbers)

    def _other(self, tree: Any, found: set[str]) -> bool:
        if isinstance(tree, int):
            return False
        if tree[0] == "at" and self.is_named_matrix(tree[1]):  # an entry
            return False
        if tree[0] in ("sym", "at"):
            return tree[1] in found | (self._named if tree[0] == "sym" else self._called)
        parts = OF_PARTS.get(tree[0])
        return tree[0] not in _OF_NUMBERS if parts is None else any(self._other(x, found) for x in tree[parts])

    @_once
    def without_indices(self, tree: Any) -> tuple[str, list, set[str]]:
        """See `exactkf.kernel.opaque`."""
        return without_indices(tree)

    @_once
    def reached_by(self, tree: Any) -> set[str]:
        """Names in a term, and those that the definitions of these lead to."""
        own = self.names_in(tree)
        return own.union(*(self.reached[name] for name in own if name in self.definitions))

    def _leads_to(self, start: str) -> set[str]:
        """Names that a definition leads to."""
        todo, seen = [start], set[str]()
        while todo:
            new = self.calls[todo.pop()] - seen
            seen |= new
            todo.extend(new)
        return seen


_last: list[Known] = []  # of one statement: many terms of it are read in a row


def known(statement: Mapping[str, Any]) -> Known:
    """What a statement decides."""
    if not _last or _last[0].statement is not statement:
        _last[:] = [Known(statement)]
    return _last[0]


def names(tree: Any) -> Iterator[str]:
    """Names that occur in a term."""
    if isinstance(tree, list):
        if tree[:1] in (["sym"], ["at"]):
            yield tree[1]
        for x in tree:
            yield from names(x)


def _recursive(definitions: Mapping[str, Any]) -> set[str]:
    """Recursions, and functions that lead back to themselves without passing a recursion."""
    calls = {name: set(names(d[3])) & set(definitions) for name, d in definitions.items() if d[0] == "let"}
    found = {name for name, d in definitions.items() if d[0] == "rec"}
    for name in calls:
        todo, seen = list(calls[name]), set[str]()
        while todo:
            x = todo.pop()
            if x in calls and x not in seen:
                seen.add(x)
                todo.extend(calls[x])
        if name in seen and definitions[name][2]:
            found.add(name)
    return found


def _mentions_z(tree: Any, in_z: set[str]) -> bool:
    if not isinstance(tree, list) or not tree:
        return False
    if tree[0] in ("coeff", "laurent"):
        return False
    if tree[0] == "subst":
        return _mentions_z(tree[2], in_z)
    if tree[0] in ("charpoly", "rev") or tree == ["z"] or (tree[0] in ("sym", "at") and tree[1] in in_z):
        return True
    return any(_mentions_z(x, in_z) for x in tree)  # the first too: of a row of a block it is no operation


def inverts(tree: Any, inverting: set[str]) -> bool:
    """Whether a term contains the inverse of a matrix, itself or by the names of definitions that do."""
    if not isinstance(tree, list) or not tree:
        return False
    return tree[0] == "inv" or (tree[0] in ("sym", "at") and tree[1] in inverting) or any(inverts(x, inverting) for x in tree)


def _spread(definitions: Mapping[str, Any], mentions: Callable[[Any, set[str]], bool]) -> set[str]:
    """Definitions that mention something, or one that does."""
    found: set[str] = set()
    while True:
        more = {name for name, d in definitions.items() if name not in found
                and any(mentions(x, found) for x in ([d[3]] if d[0] == "let" else [*d[4], d[5]]))}
        if not more:
            return found
        found |= more
