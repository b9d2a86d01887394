# SPDX-License-Identifier: MIT
"""Terms and formulas as trees.

A statement is data: nested tuples whose first entry names an operation. What
is printed, evaluated, mutated and stored in a certificate is this one tree;
nothing is simplified or reordered when it is built.

Main definitions
----------------
`Expr`
    A tree with Python operators on it: ``Phi * P * T(Phi) + H`` builds a
    product and a sum, ``==`` builds an equation, ``>>`` an implication.
    A comparison is a formula, never a truth value: ``bool(a == b)`` raises.
`sym`, `symbols`
    Names of variables, definitions and indices.
`Z`
    The indeterminate z of polynomials and pseudo-polynomials.

Notation
--------
==================  ============================================================
``gamma[t]``        entry t of a sequence, or value at t of a definition
``M[i, j]``         entry of a matrix, counted from 1 (``v[i]`` for a column)
``M ** -1``         power; `inv` prints the same
``T(M)``            transpose
``cospi(q, p)``     cos(pi q/p) for integers q, p: a closed algebraic constant
``a == b``          equation; `eq` takes a chain a = b = c
``p >> q``          implication; `iff` is equivalence, ``& | ~`` and, or, not
``A >= B``          order of scalars; `loewner` is the order of symmetric matrices
==================  ============================================================
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any

from exactkf._errors import BadInput

__all__ = [
    "OPERATIONS", "Expr", "Identity", "T", "Z", "Zero", "always", "block", "bottom", "charpoly", "circle_roots",
    "coeff", "column", "coprime", "cospectral", "cospi", "defined", "degree", "det", "detectable", "diag", "eq", "exists", "forall",
    "hstack", "iff", "inside_roots", "inv", "invertible", "kernel_basis", "laurent", "loewner", "matrix_of", "nonneg_on_circle",
    "observable", "outside_roots", "pd", "pos_on_circle", "prints", "prod", "psd", "rank", "rational", "real_roots", "recip", "rev", "rows",
    "schur", "similar", "size_of", "sqrt", "stein", "substitute", "sum_of", "sym", "symbols", "symmetric", "symplectic", "top",
    "to_expr", "trace", "vstack", "when",
]

# operation -> (least, most) number of arguments; the meaning of each stands in exactkf.kernel.meaning
OPERATIONS: dict[str, tuple[int, int | None]] = {
    "rat": (2, 2), "sym": (1, 1), "z": (0, 0),
    "+": (2, None), "-": (2, 2), "neg": (1, 1), "*": (2, None), "/": (2, 2), "^": (2, 2), "sqrt": (1, 1), "cospi": (2, 2), "abs": (1, 1),
    "at": (2, None), "entry": (2, 3), "sum": (4, 4), "prod": (4, 4), "if": (3, 3),
    "mat": (5, 5), "col": (3, 3), "block": (1, None), "rows": (1, None), "diag": (1, None), "I": (1, 1), "O": (2, 2),
    "T": (1, 1), "inv": (1, 1), "det": (1, 1), "tr": (1, 1), "rank": (1, 1), "charpoly": (1, 1), "kernel": (1, 1), "stein": (2, 2),
    "nrows": (1, 1), "ncols": (1, 1),
    "coeff": (2, 2), "deg": (1, 1), "rev": (2, 2), "recip": (1, 1), "subst": (2, 2), "laurent": (2, 2),
    "roots_in": (1, 1), "roots_on": (1, 1), "roots_out": (1, 1), "real_roots": (3, 3),
    "=": (2, None), "!=": (2, 2), "<": (2, None), "<=": (2, None), ">": (2, None), ">=": (2, None),
    "loewner": (2, 2), "psd": (1, 1), "pd": (1, 1), "symmetric": (1, 1), "invertible": (1, 1), "symplectic": (1, 1),
    "similar": (2, 2), "cospectral": (2, 2), "coprime": (2, 2), "schur": (1, 1), "observable": (2, 2), "detectable": (2, 2),
    "pos_circle": (1, 1), "nonneg_circle": (1, 1),
    "prints": (2, 2), "defined": (1, 1),
    "and": (1, None), "or": (1, None), "not": (1, 1), "=>": (2, 2), "<=>": (2, 2),
    "forall": (4, 4), "exists": (4, 4), "always": (2, 2),
}


class Expr:
    """A term or formula: the tree is in ``.tree``, nested tuples of strings and integers."""

    __slots__ = ("tree",)

    def __init__(self, tree: Any) -> None:
        self.tree = tree

    def __repr__(self) -> str:
        from exactkf.language.text import text

        return text(self.tree)

    def __bool__(self) -> bool:
        raise TypeError("a formula is data and has no truth value; write & for 'and', | for 'or', (a < b) & (b < c) for a chain, and compare .tree")

    __hash__ = object.__hash__  # names are keys of mappings
    __iter__ = None  # an index is an entry of a term, and a loop over the entries would not end

    def _nary(self, op: str, other: Any) -> Expr:
        left = self.tree
        head = left if isinstance(left, tuple) and left[0] == op else (op, left)
        return Expr((*head, to_expr(other).tree))

    def __add__(self, other: Any) -> Expr: return self._nary("+", other)
    def __radd__(self, other: Any) -> Expr: return to_expr(other) + self
    def __mul__(self, other: Any) -> Expr: return self._nary("*", other)
    def __rmul__(self, other: Any) -> Expr: return to_expr(other) * self
    def __sub__(self, other: Any) -> Expr: return _node("-", self, other)
    def __rsub__(self, other: Any) -> Expr: return _node("-", other, self)
    def __truediv__(self, other: Any) -> Expr: return _node("/", self, other)
    def __rtruediv__(self, other: Any) -> Expr: return _node("/", other, self)
    def __pow__(self, other: Any) -> Expr: return _node("^", self, other)
    def __neg__(self) -> Expr: return _node("neg", self)
    def __abs__(self) -> Expr: return _node("abs", self)
    def __eq__(self, other: object) -> Expr: return _node("=", self, other)  # type: ignore[override]
    def __ne__(self, other: object) -> Expr: return _node("!=", self, other)  # type: ignore[override]
    def __lt__(self, other: Any) -> Expr: return _node("<", self, other)
    def __le__(self, other: Any) -> Expr: return _node("<=", self, other)
    def __gt__(self, other: Any) -> Expr: return _node(">", self, other)
    def __ge__(self, other: Any) -> Expr: return _node(">=", self, other)
    def __rshift__(self, other: Any) -> Expr: return _node("=>", self, other)
    def __and__(self, other: Any) -> Expr: return self._nary("and", other)
    def __or__(self, other: Any) -> Expr: return self._nary("or", other)
    def __invert__(self) -> Expr: return _node("not", self)

    def __getitem__(self, index: Any) -> Expr:
        """``gamma[t]`` for a name of a sequence or definition; ``M[i, j]`` for a matrix, counted from 1."""
        if isinstance(index, tuple) and len(index) == 2:
            return _node("entry", self, *index)
        if not (isinstance(self.tree, tuple) and self.tree[0] == "sym"):
            return _node("entry", self, index)
        return _node("at", Expr(self.tree[1]), index)

    def __call__(self, *args: Any) -> Expr:
        """Value of a definition that has parameters: ``d(i, k)``."""
        if not (isinstance(self.tree, tuple) and self.tree[0] == "sym"):
            raise BadInput(f"{self!r} is not a name: only a named definition takes arguments")
        return _node("at", Expr(self.tree[1]), *args)


def to_expr(value: Any) -> Expr:
    """Read an int, Fraction or Expr as an Expr; floats are refused.

    >>> to_expr(Fraction(1, 2)).tree
    ('rat', 1, 2)
    """
    if isinstance(value, Expr):
        return value
    if isinstance(value, bool) or not isinstance(value, (int, Fraction)):
        raise BadInput(f"{' '.join(repr(value).split())} is not exact: write an int, a Fraction or rational('1/3')")
    if isinstance(value, int):
        return Expr(value)
    return Expr(("rat", value.numerator, value.denominator)) if value.denominator != 1 else Expr(value.numerator)


def _node(op: str, *args: Any) -> Expr:
    return Expr((op, *(to_expr(a).tree if not isinstance(a, Expr) else a.tree for a in args)))


def rational(value: str | int | Fraction) -> Expr:
    """An exact rational number, ``rational("22/7")`` or ``rational("1.25")``."""
    try:
        return to_expr(Fraction(value))
    except (ValueError, ZeroDivisionError) as error:
        raise BadInput(f"argument 'value' = {value!r} is not a rational number; write '22/7' or '1.25'") from error


def sym(name: str) -> Expr:
    """A name: variable, definition, size or index."""
    if not name.isidentifier():
        raise BadInput(f"argument 'name' = {name!r} is not an identifier; use letters, digits and underscores")
    return Expr(("sym", name))


def symbols(names: str) -> tuple[Expr, ...]:
    """Several names at once: ``a, b = symbols("a b")``."""
    return tuple(sym(name) for name in names.split())


#: the indeterminate z
Z = Expr(("z",))


def _sequence(op: str):
    def build(index: Expr, low: Any, high: Any, body: Any) -> Expr:
        return Expr((op, index.tree[1], to_expr(low).tree, to_expr(high).tree, to_expr(body).tree))
    build.__name__ = op
    build.__doc__ = f"``{op}`` over an integer index from low to high, both included."
    return build


sum_of = _sequence("sum")
prod = _sequence("prod")
forall = _sequence("forall")
exists = _sequence("exists")


def always(index: Expr, body: Expr) -> Expr:
    """For every integer t >= 0 (on an instance: for t = 0 .. horizon, as far as the orbit is defined)."""
    return Expr(("always", index.tree[1], body.tree))


def when(condition: Expr, then: Any, otherwise: Any) -> Expr:
    """``then`` if the condition holds, else ``otherwise``."""
    return _node("if", condition, then, otherwise)


def matrix_of(i: Expr, j: Expr, nrows: Any, ncols: Any, body: Any) -> Expr:
    """The matrix whose (i, j) entry, counted from 1, is ``body``."""
    return Expr(("mat", i.tree[1], j.tree[1], to_expr(nrows).tree, to_expr(ncols).tree, to_expr(body).tree))


def column(i: Expr, length: Any, body: Any) -> Expr:
    """The column whose i-th entry, counted from 1, is ``body``."""
    return Expr(("col", i.tree[1], to_expr(length).tree, to_expr(body).tree))


def _rows_of(op: str, table: Iterable[Sequence[Any]]) -> Expr:
    return Expr((op, *(tuple(to_expr(x).tree for x in row) for row in table)))


def block(table: Iterable[Sequence[Any]]) -> Expr:
    """Block matrix from rows of blocks; a scalar block is a 1x1 matrix."""
    return _rows_of("block", table)


def rows(table: Iterable[Sequence[Any]]) -> Expr:
    """Matrix from rows of scalars."""
    return _rows_of("rows", table)


def hstack(*parts: Any) -> Expr:
    """Blocks side by side."""
    return block([parts])


def vstack(*parts: Any) -> Expr:
    """Blocks one under the other."""
    return block([[p] for p in parts])


def top(matrix: Any, count: Any) -> Expr:
    """First ``count`` rows."""
    i, j = sym("i_"), sym("j_")
    return matrix_of(i, j, count, _node("ncols", matrix), to_expr(matrix)[i, j])


def bottom(matrix: Any, count: Any) -> Expr:
    """Last ``count`` rows."""
    i, j = sym("i_"), sym("j_")
    shift = _node("nrows", matrix) - count
    return matrix_of(i, j, count, _node("ncols", matrix), to_expr(matrix)[i + shift, j])


def size_of(matrix: Any) -> Expr:
    """Number of rows."""
    return _node("nrows", matrix)


def _function(op: str, doc: str):
    def build(*args: Any) -> Expr:
        return _node(op, *args)
    build.__name__ = op
    build.__doc__ = doc
    return build


diag = _function("diag", "Diagonal matrix of the given scalars, or block diagonal of the given matrices.")
Identity = _function("I", "Identity matrix of a size.")
Zero = _function("O", "Zero matrix with so many rows and columns.")
T = _function("T", "Transpose.")
inv = _function("inv", "Inverse of a square matrix.")
det = _function("det", "Determinant.")
trace = _function("tr", "Trace.")
rank = _function("rank", "Rank.")
charpoly = _function("charpoly", "det(zI - M), monic in z.")
stein = _function("stein", "``stein(M, Q)``: the solution X of X = MXM' + Q, where there is one and no other.")
kernel_basis = _function("kernel", "Matrix whose columns are a basis of the null space.")
sqrt = _function("sqrt", "Square root, of squares of rational numbers; an instance with another says nothing.")
coeff = _function("coeff", "coeff(p, k): coefficient of z^k of a (pseudo-)polynomial.")
degree = _function("deg", "Degree of a polynomial in z; -1 for zero.")
cospi = _function("cospi", "cospi(q, p) = cos(pi q/p) for integers q and p > 0, an algebraic number in a field of its own.")
rev = _function("rev", "rev(p, n) = z^n p(1/z).")
recip = _function("recip", "p(1/z).")
substitute = _function("subst", "substitute(p, x) = p(x) for a scalar or a square matrix x.")
laurent = _function("laurent", "laurent(f, k): coefficient of z^-k in the expansion of f at infinity.")
inside_roots = _function("roots_in", "Number of roots with |z| < 1, with multiplicity.")
circle_roots = _function("roots_on", "Number of roots with |z| = 1, with multiplicity.")
outside_roots = _function("roots_out", "Number of roots with |z| > 1, with multiplicity.")
real_roots = _function("real_roots", "real_roots(p, lo, hi): number of distinct real roots with lo < x <= hi.")
eq = _function("=", "Chain of equations a = b = c.")
iff = _function("<=>", "Equivalence.")
loewner = _function("loewner", "loewner(A, B): A >= B, that is A - B is positive semidefinite.")
psd = _function("psd", "Symmetric and positive semidefinite.")
pd = _function("pd", "Symmetric and positive definite.")
symmetric = _function("symmetric", "Equal to its transpose.")
invertible = _function("invertible", "Square with nonzero determinant.")
symplectic = _function("symplectic", "M'JM = J with J = [[0, I], [-I, 0]].")
similar = _function("similar", "Similar over the complex numbers.")
cospectral = _function("cospectral", "Same characteristic polynomial.")
coprime = _function("coprime", "No common root.")
observable = _function("observable", "``observable(C, A)``: C annihilates no eigenvector of A, real or complex.")
detectable = _function("detectable", "``detectable(M, N)``: sM - tN has full column rank for all complex s, t with |s| >= |t|, not both zero.")
schur = _function("schur", "All roots (of a polynomial) or eigenvalues (of a matrix) in |z| < 1.")
pos_on_circle = _function("pos_circle", "D(z, 1/z) > 0 for every |z| = 1.")
nonneg_on_circle = _function("nonneg_circle", "D(z, 1/z) >= 0 for every |z| = 1.")
defined = _function("defined", "Evaluates without division by zero.")


def prints(value: Any, printed: Any) -> Expr:
    """The value agrees with a printed decimal, or table of them, to half a unit of its last digit."""
    table = printed if isinstance(printed, str) else tuple(tuple(row) for row in printed)
    return Expr(("prints", to_expr(value).tree, table))
