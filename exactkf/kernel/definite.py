# SPDX-License-Identifier: MIT
"""What the form of a term shows: definite, positive, nonsingular, defined.

The facts are those of `exactkf.kernel.order.FACTS`.

Main definitions
----------------
`definiteness`
    0, 1 (positive semidefinite) or 2 (positive definite), by form and hypotheses.
`sign`
    The same for a scalar: 1 for >= 0, 2 for > 0.
`exists`
    Every inverse in a term is one of the statement, or exists by its form.
"""

from __future__ import annotations

from copy import copy
from typing import Any

from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.reader import Reader, hypotheses
from exactkf.kernel.words import Blocks

__all__ = ["apart", "are_transposed", "definiteness", "exists", "nonsingular", "plain", "sign"]


def exists(reader: Reader, tree: Any, known: list) -> bool:
    """Every inverse in a term is one of the statement or of a matrix that is nonsingular (a number that is positive) by its form."""
    if plain(reader, tree):
        return True
    if tree and not isinstance(tree[0], str):  # a row of a block matrix
        return all(exists(reader, x, known) for x in tree)
    if tree and tree[0] == "at":
        return _brings_nothing(reader, tree)
    if tree and tree[0] in ("/", "^"):
        divides = tree[0] == "/" or not isinstance(tree[2], int) or tree[2] < 0
        positive = tree[0] == "/" and sign(reader, tree[2]) == 2
        return (not divides or positive or _brings_nothing(reader, tree)) and all(exists(reader, x, known) for x in tree[1:])
    if tree and tree[0] == "inv":
        term = reader.read(tree[1])
        if not isinstance(term, Blocks):
            return False
        if not any(p in (term, reader.transpose(term)) for p, _ in known) and not nonsingular(reader, tree[1]):
            return False
    if tree and tree[0] == "sym" and tree[1] not in reader.kinds and tree[1] in reader.lets:
        return exists(reader, reader.lets[tree[1]][3], known)
    return all(exists(reader, x, known) for x in tree[1:])


def plain(reader: Reader, tree: Any) -> bool:
    """No inverse, quotient, power or value of a function in a term, nor in what its names stand for: what readers of the same letters find alike."""
    if not isinstance(tree, (list, tuple)):
        return True
    key = ("plain", id(tree))
    if key not in reader.alike:
        body = reader.lets[tree[1]][3] if tree[0] == "sym" and tree[1] not in reader.kinds and tree[1] in reader.lets else 0
        free = tree[0] not in ("inv", "/", "^", "at", "stein") and plain(reader, body) and all(plain(reader, x) for x in tree)
        reader.alike[key] = tree, free
    return reader.alike[key][1]


def _brings_nothing(reader: Reader, tree: Any) -> bool:
    """The term inverts and divides by nothing but what the statement does."""
    inverses, quotients, units = reader.granted
    probe = apart(reader)
    probe.inverses, probe.quotients, probe.units = list(inverses), list(quotients), set(units)
    try:
        probe.read(tree)
    except Unknown:  # such as an inverse that a proof has brought in before
        return False
    return len(probe.inverses) == len(inverses) and len(probe.quotients) == len(quotients) and probe.units == units


def apart(reader: Reader) -> Reader:
    """A reader that reads on by itself."""
    probe = copy(reader)
    probe.noted, probe.turned = {}, {}
    probe.memory, probe.sizes, probe.transposed = {}, dict(reader.sizes), dict(reader.transposed)
    probe.inverses, probe.quotients, probe.units = list(reader.inverses), list(reader.quotients), set(reader.units)
    probe.kernels, probe.steins = list(reader.kernels), list(reader.steins)
    return probe


def definiteness(reader: Reader, tree: Any) -> int:
    """0: not known, 1: positive semidefinite, 2: positive definite."""
    if isinstance(tree, int):
        return 1 if tree >= 0 else 0
    known = max(_by_hypothesis(reader, tree), _sign_by_hypothesis(reader, tree))  # a matrix that is compared has one row and one column
    if known:
        return known
    op, args = tree[0], tree[1:]
    if op == "sym":
        definition = reader.lets.get(args[0])
        if args[0] not in reader.kinds and definition is not None and definition[0] == "let" and not definition[2]:
            return definiteness(reader, definition[3])
        level = {"psd": 1, "pd": 2, "nonneg": 1, "positive": 2}.get(reader.kinds.get(args[0], ("",))[0], 0)
        return 2 if level and _invertible_by_hypothesis(reader, tree) else level
    if op == "I":
        return 2
    if op == "O":
        return int(reader.size(args[0]) == reader.size(args[1]))
    if op == "+":
        found = [definiteness(reader, a) for a in args]
        return 0 if 0 in found else max(found)
    if op == "inv":
        return 2 if definiteness(reader, args[0]) else 0
    if op == "T":
        return definiteness(reader, args[0])
    if op == "stein":
        return definiteness(reader, args[1]) if isinstance(reader.read(tree), Blocks) else 0  # read only where M is stable
    if op == "/":  # what is divided by does not vanish
        return definiteness(reader, args[0]) if sign(reader, args[1]) else 0
    if op == "block":
        return _block_diagonal(reader, args)
    if op == "-" and len(args) == 2:
        return _less_than_trace(reader, *args)
    return _congruence(reader, list(args)) if op == "*" else 0


def _less_than_trace(reader: Reader, bound: Any, tree: Any) -> int:
    """trace(X) I - X for a semidefinite matrix X."""
    of_trace = isinstance(bound, (list, tuple)) and len(bound) == 3 and bound[0] == "*" and bound[1] == ["tr", tree] and _op(bound[2]) == "I"
    return int(of_trace and isinstance(reader.read(tree), Blocks) and definiteness(reader, tree) > 0)


def _op(tree: Any) -> Any:
    return tree[0] if isinstance(tree, (list, tuple)) else ""


def _block_diagonal(reader: Reader, table: Any) -> int:
    zero = all(_is_zero(x) for i, row in enumerate(table) for j, x in enumerate(row) if i != j)
    square = all(len(row) == len(table) for row in table)
    whole = reader.read(["block", *table])  # a zero on the diagonal takes its sizes from those beside it
    square = square and isinstance(whole, Blocks) and whole.rows == whole.cols
    return min(definiteness(reader, row[i]) for i, row in enumerate(table)) if zero and square else 0


def _is_zero(tree: Any) -> bool:
    return tree == 0 or (isinstance(tree, (list, tuple)) and tree[0] == "O")


def _congruence(reader: Reader, factors: list[Any]) -> int:
    """X_1 ... X_k P X_k' ... X_1' (P = I may be left out), with nonnegative numbers anywhere."""
    numbers = [x for x in factors if _is_number(reader, x)]
    strict = True
    if len(numbers) == len(factors):
        return _sign_of_product(reader, factors)
    if numbers:
        factors = [x for x in factors if not _is_number(reader, x)]
        level = _sign_of_product(reader, numbers)
        if level == 0:
            return 0
        strict = level == 2
    while len(factors) > 1:
        first, last = factors.pop(0), factors.pop()
        if not are_transposed(reader, first, last):
            return 0
        strict = strict and (nonsingular(reader, first) or _full_row_rank(reader, first))
    middle = definiteness(reader, factors[0]) if factors else 2
    return middle if strict or middle == 0 else 1


def _is_number(reader: Reader, tree: Any) -> bool:
    return isinstance(tree, int) or not isinstance(reader.read(tree), Blocks)


def sign(reader: Reader, tree: Any) -> int:
    """0: not known, 1: the scalar is >= 0, 2: it is > 0."""
    if isinstance(tree, int):
        return 2 if tree > 0 else int(tree == 0)
    level = _sign_by_hypothesis(reader, tree)
    op, args = tree[0], tree[1:]
    if level == 2:
        return 2
    if op == "rat":
        return 2 if args[0] > 0 else int(args[0] == 0)
    if op == "sym":
        definition = reader.lets.get(args[0])
        if args[0] not in reader.kinds and definition is not None and definition[0] == "let" and not definition[2]:
            return max(level, sign(reader, definition[3]))
        return max(level, {"nonneg": 1, "positive": 2}.get(reader.kinds.get(args[0], ("",))[0], 0))
    if op == "+":
        found = [sign(reader, a) for a in args]
        return level if 0 in found else max(found)
    if op == "/":
        return max(level, sign(reader, args[0]) if sign(reader, args[1]) else 0)
    if op == "^" and isinstance(args[1], int) and args[1] > 0:
        below = sign(reader, args[0])
        return max(level, below, 2 * _never_zero(reader, args[0]) or 1) if args[1] % 2 == 0 else max(level, below)
    if op == "tr" and isinstance(reader.read(args[0]), Blocks):
        return max(level, int(definiteness(reader, args[0]) > 0))
    if op in ("*", "T", "inv"):
        return max(level, _sign_of_product(reader, list(args)) if op == "*" else 0, definiteness(reader, tree) if _is_one_row(reader, tree) else 0)
    return level


def _sign_of_product(reader: Reader, factors: list[Any]) -> int:
    level = 2
    while factors:
        x = factors.pop(0)
        if x in factors and _is_number(reader, x):  # a square
            factors.remove(x)
            level = min(level, 2 if _never_zero(reader, x) else 1)
        else:
            level = min(level, sign(reader, x))
    return level


def _never_zero(reader: Reader, tree: Any) -> bool:
    return sign(reader, tree) == 2 or (isinstance(tree, (list, tuple)) and tree[0] == "sym" and tree[1] in reader.granted[2])


def _is_one_row(reader: Reader, tree: Any) -> bool:
    found = reader.read(tree)
    return isinstance(found, Blocks) and found.rows == found.cols == ((("", 1),),)


def _sign_by_hypothesis(reader: Reader, tree: Any) -> int:
    best = 0
    for _, formula in hypotheses(reader.statement):
        if formula[0] in (">", ">=", "<", "<=") and len(formula) == 3:
            big, small = (formula[1], formula[2]) if formula[0] in (">", ">=") else (formula[2], formula[1])
            if (small == 0 and big == tree) or ["-", big, small] == tree:
                best = max(best, 2 if formula[0] in "<>" else 1)
    return best


def _full_row_rank(reader: Reader, tree: Any) -> bool:
    """A hypothesis says that the rank is the number of rows."""
    x = reader.read(tree)
    for _, formula in hypotheses(reader.statement):
        if formula[0] == "=" and len(formula) == 3 and isinstance(formula[1], list) and formula[1][0] == "rank":
            y = reader.read(formula[1][1])
            if isinstance(x, Blocks) and isinstance(y, Blocks) and reader.total(x.rows) == reader.size(formula[2]) and y in (x, reader.transpose(x)):
                return True
    return False


def are_transposed(reader: Reader, x: Any, y: Any) -> bool:
    try:
        a, b = reader.transpose(reader.read(x)), reader.read(y)
    except (Undefined, Unknown):
        return False
    return isinstance(a, Blocks) and isinstance(b, Blocks) and (a.rows, a.cols, a.grid) == (b.rows, b.cols, b.grid)


def nonsingular(reader: Reader, tree: Any) -> bool:
    """Nonsingular by its form: by type or hypothesis, definite, an inverse, a transpose or product of such matrices."""
    if not isinstance(tree, (list, tuple)):
        return False
    if _invertible_by_hypothesis(reader, tree):
        return True
    if tree[0] == "T":
        return nonsingular(reader, tree[1])
    if tree[0] == "*" and all(nonsingular(reader, x) or (_is_number(reader, x) and sign(reader, x) == 2) for x in tree[1:]):
        return True
    if tree[0] == "sym" and tree[1] in reader.kinds and reader.kinds[tree[1]][0] in ("nonsingular", "pd"):
        return True
    if tree[0] == "sym" and tree[1] not in reader.kinds:
        body = reader.lets.get(tree[1], ("", "", (), None))
        if body[0] == "let" and not body[2]:
            return nonsingular(reader, body[3]) or _invertible_by_hypothesis(reader, tree)
    return tree[0] == "inv" or _invertible_by_hypothesis(reader, tree) or definiteness(reader, tree) == 2


def _invertible_by_hypothesis(reader: Reader, tree: Any) -> bool:
    said = [f[1] for _, f in hypotheses(reader.statement) if f[0] == "invertible"]
    return tree in said or any(are_transposed(reader, t, x) for x in said for t in (tree, ["T", tree]))


def _by_hypothesis(reader: Reader, tree: Any) -> int:
    best = 0
    for _, part in hypotheses(reader.statement):
        if part[0] in ("psd", "pd") and part[1] == tree:
            best = max(best, 2 if part[0] == "pd" or _invertible_by_hypothesis(reader, tree) else 1)
        if part[0] == "loewner" and (["-", part[1], part[2]] == tree or (part[2] == 0 and part[1] == tree)):
            best = max(best, 1)
    return best

