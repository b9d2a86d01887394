# SPDX-License-Identifier: MIT
"""Matrices over exact scalars or over polynomials and rational functions in z.

Determinants and inverses are found without division (sums of products of
minors, memoised) as long as entries carry variables, by Gaussian elimination
otherwise; inverses of triangular matrices by substitution. Inertia is that of a symmetric LDL' with 1x1 pivots; where the
diagonal is zero a congruence makes it nonzero first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

from exactkf.kernel.numbers import Laurent, Ratio, Undefined, Unknown, added, divide, sign
from exactkf.kernel.symbolic import Symbolic

__all__ = ["Matrix", "block", "char_coefficients", "echelon", "inertia", "null_basis", "similar", "symplectic_form"]


class _Row(Sequence):
    """A row whose entries are found when they are asked for: often a proof needs few of them."""

    __slots__ = ("_find", "_found", "_length")

    def __init__(self, length: int, find: Callable[[int], Any]) -> None:
        self._length, self._find, self._found = length, find, dict[int, Any]()

    def __len__(self) -> int:
        return self._length

    def __getitem__(self, j: Any) -> Any:
        if isinstance(j, slice):
            return list(self)[j]
        if j not in self._found:
            if not 0 <= j < self._length:
                raise IndexError(j)
            self._found[j] = self._find(j)
        return self._found[j]

    def __iter__(self) -> Iterator[Any]:
        return (self[j] for j in range(self._length))

    def __add__(self, other: Any) -> list:
        return [*self, *other]

    def __radd__(self, other: Any) -> list:
        return [*other, *self]


class Matrix:
    """Rows of entries; a matrix may have no rows or no columns."""

    __slots__ = ("ncols", "nrows", "rows")

    def __init__(self, rows: Sequence[Any], ncols: int | None = None) -> None:
        self.rows: Any = rows
        self.nrows = len(rows)
        self.ncols = len(rows[0]) if rows else (ncols or 0)
        if any(len(r) != self.ncols for r in rows):
            raise Undefined("rows of different lengths")

    @classmethod
    def build(cls, nrows: int, ncols: int, entry: Callable[[int, int], Any]) -> Matrix:
        return cls([[entry(i, j) for j in range(ncols)] for i in range(nrows)], ncols)

    @classmethod
    def lazy(cls, nrows: int, ncols: int, entry: Callable[[int, int], Any]) -> Matrix:
        """As `build`, but each entry is found when it is first asked for; so are those of products from the left."""
        return cls([_Row(ncols, partial(entry, i)) for i in range(nrows)], ncols)

    @classmethod
    def identity(cls, n: int) -> Matrix:
        return cls.build(n, n, lambda i, j: int(i == j))

    @property
    def is_scalar(self) -> bool:
        return self.nrows == self.ncols == 1

    def map(self, f: Callable) -> Matrix:
        return Matrix([[f(x) for x in r] for r in self.rows], self.ncols)

    def transpose(self) -> Matrix:
        return Matrix.build(self.ncols, self.nrows, lambda i, j: self.rows[j][i])

    def _same(self, other: Any) -> tuple[Matrix, Matrix]:
        """Both operands of a sum; a 1x1 matrix and a scalar are the same thing."""
        a, b = self, other if isinstance(other, Matrix) else Matrix([[other]])
        if (a.nrows, a.ncols) != (b.nrows, b.ncols):
            raise Undefined(f"sizes {a.nrows}x{a.ncols} and {b.nrows}x{b.ncols} do not fit")
        return a, b

    def __add__(self, other: Any) -> Matrix:
        a, b = self._same(other)
        return Matrix([[x + y for x, y in zip(r, s, strict=True)] for r, s in zip(a.rows, b.rows, strict=True)], a.ncols)

    __radd__ = __add__

    def __neg__(self) -> Matrix:
        return self.map(lambda x: -x)

    def __sub__(self, other: Any) -> Matrix:
        a, b = self._same(other)
        return Matrix([[x - y for x, y in zip(r, s, strict=True)] for r, s in zip(a.rows, b.rows, strict=True)], a.ncols)

    def __rsub__(self, other: Any) -> Matrix:
        return -self + other

    def __mul__(self, other: Any) -> Matrix:
        if not isinstance(other, Matrix):
            return self.map(lambda x: x * other)
        if self.ncols != other.nrows:
            if self.is_scalar:
                return other * self.rows[0][0]
            if other.is_scalar:
                return self * other.rows[0][0]
            raise Undefined(f"sizes {self.nrows}x{self.ncols} and {other.nrows}x{other.ncols} do not multiply")
        if self.nrows and isinstance(self.rows[0], _Row):
            return Matrix.lazy(self.nrows, other.ncols, lambda i, j: _dot(self.rows[i], [r[j] for r in other.rows]))
        columns = list(zip(*other.rows, strict=True)) if other.nrows else [()] * other.ncols
        sparse = [[(k, x) for k, x in enumerate(r) if x or type(x) is not int] for r in self.rows]
        return Matrix([[added([x * y for k, x in r if (y := c[k]) or type(y) is not int]) for c in columns] for r in sparse], other.ncols)

    def __rmul__(self, other: Any) -> Matrix:
        return self.map(lambda x: other * x)

    def __truediv__(self, other: Any) -> Matrix:
        if isinstance(other, Matrix):
            if not other.is_scalar:
                raise Undefined("division by a matrix")
            other = other.rows[0][0]
        return self.map(lambda x: divide(x, other))

    def __rtruediv__(self, other: Any) -> Any:
        if not self.is_scalar:
            raise Undefined("division by a matrix")
        return divide(other, self.rows[0][0])

    def __eq__(self, other: object) -> bool:
        a, b = self._same(other)
        return all(x == y for r, s in zip(a.rows, b.rows, strict=True) for x, y in zip(r, s, strict=True))

    __hash__ = None  # type: ignore[assignment]

    def power(self, k: int) -> Matrix:
        self._square()
        base, out = (self, Matrix.identity(self.nrows)) if k >= 0 else (self.inverse(), Matrix.identity(self.nrows))
        for bit in bin(abs(k))[2:]:
            out = out * out
            if bit == "1":
                out = out * base
        return out

    def _square(self) -> None:
        if self.nrows != self.ncols:
            raise Undefined(f"a {self.nrows}x{self.ncols} matrix is not square")

    def _has_variables(self) -> bool:
        return any(isinstance(x, (Symbolic, Laurent, Ratio)) for r in self.rows for x in r)

    def determinant(self) -> Any:
        self._square()
        if self._has_variables():
            return _Minors(self).minor(tuple(range(self.nrows)), tuple(range(self.nrows)))
        reduced, pivots, det = echelon(self)
        return det if len(pivots) == self.nrows else 0

    def inverse(self) -> Matrix:
        self._square()
        n = self.nrows
        if self._has_variables():
            for turned in (self, self.transpose()):
                if all(x == 0 for i, r in enumerate(turned.rows) for x in r[:i]):
                    upper = turned._inverse_of_upper()
                    return upper if turned is self else upper.transpose()
            minors = _Minors(self)
            every = tuple(range(n))
            det = minors.minor(every, every)
            if det == 0:
                raise Undefined("inverse of a singular matrix")
            without = [every[:i] + every[i + 1:] for i in every]
            unit = divide(1, det)
            return Matrix.build(n, n, lambda i, j: minors.minor(without[j], without[i]) * unit * (-1) ** (i + j))
        wide = Matrix([r + [int(i == j) for j in range(n)] for i, r in enumerate(self.rows)], 2 * n)
        reduced, pivots, _ = echelon(wide, n)
        if len(pivots) < n:
            raise Undefined("inverse of a singular matrix")
        return Matrix([r[n:] for r in reduced.rows], n)


    def _inverse_of_upper(self) -> Matrix:
        """Inverse of an upper triangular matrix, by substitution from the last row up."""
        n, below = self.nrows, list[list]()
        for i in reversed(range(n)):
            if self.rows[i][i] == 0:
                raise Undefined("inverse of a singular matrix")
            unit, row = divide(1, self.rows[i][i]), self.rows[i][i + 1:]
            below.insert(0, [unit * (int(i == j) - _dot(row, [r[j] for r in below])) if j >= i else 0 for j in range(n)])
        return Matrix(below, n)


def _dot(xs: Any, ys: Any) -> Any:
    return added([x * y for x, y in zip(xs, ys, strict=True) if (x or type(x) is not int) and (y or type(y) is not int)])


class _Minors:
    """Memoised expansion of minors along the first row."""

    def __init__(self, matrix: Matrix) -> None:
        self.rows = matrix.rows
        self.known: dict[tuple, Any] = {}

    def minor(self, rows: tuple, cols: tuple) -> Any:
        if not rows:
            return 1
        key = (rows, cols)
        if key not in self.known:
            acc: Any = 0
            for k, j in enumerate(cols):
                x = self.rows[rows[0]][j]
                if not x == 0:
                    term = x * self.minor(rows[1:], cols[:k] + cols[k + 1:])
                    acc = acc - term if k % 2 else acc + term
            self.known[key] = acc
        return self.known[key]


def echelon(matrix: Matrix, width: int | None = None) -> tuple[Matrix, list[int], Any]:
    """Reduced row echelon form in the first ``width`` columns, pivot columns, product of pivots with sign."""
    if matrix._has_variables():
        raise Unknown("elimination with variables")
    rows = [list(r) for r in matrix.rows]
    pivots: list[int] = []
    det: Any = 1
    for col in range(matrix.ncols if width is None else width):
        at = len(pivots)
        pick = next((i for i in range(at, len(rows)) if rows[i][col] != 0), None)
        if pick is None:
            continue
        if pick != at:
            rows[at], rows[pick], det = rows[pick], rows[at], -det
        pivot = rows[at][col]
        det = det * pivot
        rows[at] = [divide(x, pivot) for x in rows[at]]
        for i, row in enumerate(rows):
            if i != at and row[col] != 0:
                f = row[col]
                rows[i] = [x - f * y for x, y in zip(row, rows[at], strict=True)]
        pivots.append(col)
    return Matrix(rows, matrix.ncols), pivots, det


def null_basis(matrix: Matrix) -> Matrix:
    """Columns that span {x : Mx = 0}."""
    reduced, pivots, _ = echelon(matrix)
    free = [j for j in range(matrix.ncols) if j not in pivots]

    def entry(i: int, k: int) -> Any:
        if i in pivots:
            return -reduced.rows[pivots.index(i)][free[k]]
        return int(i == free[k])

    return Matrix.build(matrix.ncols, len(free), entry)


def inertia(matrix: Matrix) -> tuple[int, int, int]:
    """Numbers of positive, negative and zero eigenvalues of a symmetric matrix (Sylvester)."""
    a = [list(r) for r in matrix.rows]
    plus = minus = 0
    while a:
        n = len(a)
        k = next((i for i in range(n) if a[i][i] != 0), None)
        if k is None:
            pair = next(((i, j) for i in range(n) for j in range(i) if a[i][j] != 0), None)
            if pair is None:
                return plus, minus, n
            i, j = pair  # add row and column j to i: the new diagonal entry is 2 a_ij
            a[i] = [x + y for x, y in zip(a[i], a[j], strict=True)]
            for row in a:
                row[i] = row[i] + row[j]
            continue
        pivot = a[k][k]
        if sign(pivot) > 0:
            plus += 1
        else:
            minus += 1
        rest = [i for i in range(n) if i != k]
        a = [[a[i][j] - divide(a[i][k] * a[k][j], pivot) for j in rest] for i in rest]
    return plus, minus, 0


def char_coefficients(matrix: Matrix) -> list:
    """Coefficients of det(zI - M) from z^0 up, by the division-free recursion of Berkowitz."""
    matrix._square()
    a = matrix.rows
    poly: list[Any] = [1]  # from the leading coefficient down
    for k in range(matrix.nrows):
        row, col = [a[k][j] for j in range(k)], [a[i][k] for i in range(k)]
        toeplitz = [1, -a[k][k]]
        v = col
        for _ in range(k):
            toeplitz.append(-_dot(row, v))
            v = [_dot(a[i][:k], v) for i in range(k)]
        poly = [_dot([toeplitz[i - j] for j in range(min(i, k) + 1)], poly[: min(i, k) + 1]) for i in range(k + 2)]
    return poly[::-1]


def block(rows: list[list[Any]]) -> Matrix:
    """Matrix of blocks; scalars are 1x1."""
    out, widths = list[list](), set[int]()
    for row in rows:
        parts = [b if isinstance(b, Matrix) else Matrix([[b]]) for b in row]
        if len({p.nrows for p in parts}) != 1:
            raise Undefined("blocks of one row have different heights")
        out.extend([sum((p.rows[i] for p in parts), []) for i in range(parts[0].nrows)])
        widths.add(sum(p.ncols for p in parts))
    if len(widths) != 1:
        raise Undefined("rows of blocks have different widths")
    return Matrix(out, *widths)


def symplectic_form(d: int) -> Matrix:
    """J = [[0, I], [-I, 0]]."""
    return Matrix.build(2 * d, 2 * d, lambda r, c: int(c == r + d) - int(r == c + d))


def similar(a: Matrix, b: Matrix) -> bool:
    """Similar: the equation AX = XB has as many solutions as AX = XA and BX = XB (Gauger and Byrnes)."""
    if (a.nrows, a.ncols) != (b.nrows, b.ncols) or a.nrows != a.ncols:
        return False

    def solutions(p: Matrix, q: Matrix) -> int:
        n = p.nrows
        entries = [[(p.rows[i][k] if j == m else 0) - (q.rows[m][j] if i == k else 0)
                    for k in range(n) for m in range(n)] for i in range(n) for j in range(n)]
        return n * n - len(echelon(Matrix(entries, n * n))[1])

    return char_coefficients(a) == char_coefficients(b) and solutions(a, b) == solutions(a, a) == solutions(b, b)
