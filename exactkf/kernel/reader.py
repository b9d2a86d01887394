# SPDX-License-Identifier: MIT
"""Terms of a statement about matrices of every size, read as polynomials in words.

A letter is a variable, its transpose, or (a block of) the inverse of a term
that the statement inverts; each has a number of rows and of columns, and a
product whose sizes do not fit is refused. Block matrices are opened into
blocks. A 1 x 1 word is a number too: ``<v'*P*v>`` is the scalar of the word
v'*P*v and of its transpose, and stands for it where sizes ask for a scalar.

Main definitions
----------------
`Reader`
    Reads terms; collects letters and the relations of the inverses.
`residual_blocks`
    Left minus right side of equations.
`relations`
    What the statement assumes: its equations, transposed too; V E = 1 and E V = 1
    for each inverse V of E; V A = 1 or A V = 1 for a matrix A of which a hypothesis
    says that its rank is its number of columns or rows; of a basis N of a null space
    what `Reader` says of it, and of a solution of X = MXM' + Q this equation. A term without value is
    outside the statement, so an inverse that is written down exists. A one-sided
    inverse of a square matrix is two-sided: M'JM = J gives MJM' = J, and XY = I
    gives YX = I.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.wellformed import check_arguments
from exactkf.kernel.words import ONE, Blocks, Poly, Relation, Size, Word, add, multiply, number, shape, text

__all__ = ["Reader", "hypotheses", "relations", "residual_blocks", "word_sizes"]

_ONE_ROW: Size = (("", 1),)
_LARGEST_POWER = 1000
_NULLITY = "nullity of "  # begins the name of a size that is no size of the statement


def hypotheses(statement: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """The hypotheses with their labels, the members of a conjunction apart."""
    todo = [(label, formula) for label, formula, _ in reversed(statement["given"])]
    while todo:
        label, formula = todo.pop()
        if formula[0] == "and":
            todo.extend((f"{label}.{n}", part) for n, part in reversed(list(enumerate(formula[1:]))))
        else:
            yield label, formula


class Reader:
    """Reads the terms of one statement as block matrices of noncommutative polynomials."""

    def __init__(self, statement: Mapping[str, Any]) -> None:
        self.statement = statement
        names = [*statement["sizes"], *(name for name, _ in statement["over"]), *(d[1] for d in statement["where"])]
        if len(set(names)) < len(names):
            raise Unknown("two things of one name")
        self.kinds = {name: kind for name, kind in statement["over"]}
        self.lets = {d[1]: d for d in statement["where"]}
        self.sizes: dict[str, tuple[Size, Size]] = {}  # letter -> (rows, columns)
        self.transposed: dict[str, str] = {}  # letter -> letter of its transpose
        self.inverses: list[tuple[Blocks, Blocks]] = []  # (term, its inverse)
        self.sides: list[tuple[Blocks, Blocks]] = []  # (term, its left or right inverse)
        self.kernels: list[tuple[Blocks, Blocks, Blocks, Blocks]] = []  # (X, N, M, Y): XN = 0, MN = I, YX + NM = I
        self.steins: list[tuple[Blocks, Blocks, Blocks]] = []  # (M, Q, X): X = MXM' + Q
        self.asking = False  # what hypotheses say to be stable is being read
        self.numbers: dict[str, Word] = {}  # scalar -> 1 x 1 word it stands for
        self.memory: dict[int, tuple[Any, Any]] = {}  # trees that have been read
        self.marks = 0  # counts what depends on what this reader has met: inverses, determinants, null spaces, scalars of words
        self.turned: dict[Word, Word] = {}  # words and their transposes
        self.noted: dict[int, dict[str, Relation]] = {}  # what hypotheses say, by their number, see `relations`
        self.dets: dict[str, Blocks] = {}
        self.quotients: list[tuple[Poly, str]] = []  # (scalar, name of its inverse)
        self.units = {name for name, kind in self.kinds.items() if kind[0] in ("nonzero", "positive")}
        symmetric = {f[1][1] for _, f in hypotheses(statement) if f[0] in ("symmetric", "psd", "pd") and not isinstance(f[1], int) and f[1][0] == "sym"}
        self.alike = _alike(statement, frozenset(symmetric))  # what all readers of these letters read alike
        self.granted: tuple[list, list, set] = ([], [], set())  # inverses, quotients and units of the statement, see exactkf.kernel.definite
        for name, kind in statement["over"]:
            if kind[0] == "matrix":
                self._letter(name, self.size(kind[1]), self.size(kind[2]), name in symmetric and kind[1] == kind[2])
            elif kind[0] in ("symmetric", "psd", "pd"):
                self._letter(name, self.size(kind[1]), self.size(kind[1]), True)
            elif kind[0] in ("nonsingular", "diagonal"):
                self._letter(name, self.size(kind[1]), self.size(kind[1]), kind[0] == "diagonal")

    def _letter(self, name: str, rows: Size, cols: Size, symmetric: bool) -> None:
        self.sizes[name] = (rows, cols)
        other = name if symmetric else f"{name}'"
        self.transposed[name], self.transposed[other] = other, name
        self.sizes[other] = (cols, rows)

    def size(self, tree: Any, local: Mapping[str, Any] | None = None) -> Size:
        """A size as a linear form in the named sizes."""
        form = self._linear(tree, local or {})
        return tuple(sorted((n, c) for n, c in form.items() if c))

    def _linear(self, tree: Any, local: Mapping[str, Any]) -> dict[str, int]:
        if isinstance(tree, int):
            return {"": tree}
        op = tree[0]
        if op == "sym" and tree[1] in self.statement["sizes"]:
            return {tree[1]: 1}
        if op in ("+", "-", "neg"):
            out: dict[str, int] = {}
            for k, part in enumerate(tree[1:]):
                for n, c in self._linear(part, local).items():
                    out[n] = out.get(n, 0) + (-c if op == "neg" or (op == "-" and k) else c)
            return out
        if op == "*" and len(tree) == 3 and isinstance(tree[1], int):
            return {n: tree[1] * c for n, c in self._linear(tree[2], local).items()}
        if op == "sym" and tree[1].startswith(_NULLITY):
            return {tree[1]: 1}
        if op in ("nrows", "ncols") and isinstance(x := self.read(tree[1], local), Blocks):
            return dict(self.total(x.rows if op == "nrows" else x.cols))
        raise Unknown(f"size {tree!r} is not linear in the named sizes")

    # ------------------------------------------------------------------ terms
    def read(self, tree: Any, local: Mapping[str, Any] | None = None) -> Any:
        """Blocks, or a Poly without letters for a scalar."""
        local = local or {}
        if isinstance(tree, int):
            return {((), ()): tree} if tree else {}
        if not local:
            if (found := self.alike.get(id(tree))) is not None:
                return found[1]
            if (found := self.memory.get(id(tree))) is not None:
                self.marks += 1
                return found[1]
        check_arguments(tree)
        method = getattr(self, f"_read_{_METHODS.get(tree[0], '')}", None)
        if method is None:
            raise Unknown(f"{tree[0]!r} in a statement for every size")
        marks = self.marks
        value = method(tree, local)
        if not local:
            (self.alike if self.marks == marks else self.memory)[id(tree)] = tree, value  # the tree is kept, so that its id stays its own
        return value

    def _read_rational(self, tree: Any, local: Mapping[str, Any]) -> Any:
        return {((), ()): number(Fraction(tree[1], tree[2]))} if tree[1] else {}

    def _read_name(self, tree: Any, local: Mapping[str, Any]) -> Any:
        name = tree[1]
        if name in local:
            return local[name]
        if name in self.kinds:
            if name in self.sizes:
                rows, cols = self.sizes[name]
                return Blocks((rows,), (cols,), [[{((), (name,)): 1}]])
            if self.kinds[name][0] in ("scalar", "nonzero", "positive", "nonneg"):
                return {(((name, 1),), ()): 1}
        if name in self.statement["sizes"]:
            return {(((name, 1),), ()): 1}
        if name in self.lets and self.lets[name][0] == "let" and not self.lets[name][2]:
            body = self.lets[name][3]
            return self._entries(name, body) if isinstance(body, (list, tuple)) and body[0] in ("mat", "col") else self.read(body)
        raise Unknown(f"name {name!r} in a statement for every size")

    def _entries(self, name: str, body: Any) -> Blocks:
        """A matrix that is given by its entries is a letter: what holds for every matrix of its sizes holds for it."""
        self.marks += 1
        if name not in self.sizes:
            rows, cols = (self.size(body[3]), self.size(body[4])) if body[0] == "mat" else (self.size(body[2]), _ONE_ROW)
            self._letter(name, rows, cols, False)
        return Blocks((self.sizes[name][0],), (self.sizes[name][1],), [[{((), (name,)): 1}]])

    def _read_call(self, tree: Any, local: Mapping[str, Any]) -> Any:
        definition = self.lets.get(tree[1]) if tree[1] not in local else None
        if definition is None or definition[0] != "let" or not definition[2]:
            raise Unknown(f"{tree[1]!r} with an index in a statement for every size")
        return self.read(definition[3], dict(zip(definition[2], [self.read(a, local) for a in tree[2:]], strict=True)))

    def _read_sum(self, tree: Any, local: Mapping[str, Any]) -> Any:
        acc = self.read(tree[1], local)
        for part in tree[2:]:
            acc = self._plus(acc, self.read(part, local), 1)
        return acc

    def _read_difference(self, tree: Any, local: Mapping[str, Any]) -> Any:
        return self._plus(self.read(tree[1], local), self.read(tree[2], local), -1)

    def _read_minus(self, tree: Any, local: Mapping[str, Any]) -> Any:
        return self._scale(self.read(tree[1], local), -1)

    def _scale(self, x: Any, c: Any) -> Any:
        def by(p: Poly) -> Poly:
            return {k: c * v for k, v in p.items()}
        return x.map(by) if isinstance(x, Blocks) else by(x)

    def _plus(self, x: Any, y: Any, factor: int) -> Any:
        if isinstance(x, Blocks) and isinstance(y, Blocks):
            if x.rows != y.rows or x.cols != y.cols:
                x, y = self._split_like(x, y.rows, y.cols), self._split_like(y, x.rows, x.cols)
            return x.plus(y, factor)
        if isinstance(x, Blocks):
            return x.plus(self._scalar_block(y, x), factor)
        if isinstance(y, Blocks):
            return self._scalar_block(x, y).plus(y, factor)
        return add(x, y, factor)

    def _scalar_block(self, p: Poly, like: Blocks) -> Blocks:
        """A scalar beside a 1x1 matrix, or zero beside any matrix."""
        if not p:
            return like.map(lambda q: {})
        if like.rows != (_ONE_ROW,) or like.cols != (_ONE_ROW,):
            raise Undefined("a scalar is added to a matrix")
        return Blocks(like.rows, like.cols, [[p]])

    def _read_product(self, tree: Any, local: Mapping[str, Any]) -> Any:
        acc = self.read(tree[1], local)
        for part in tree[2:]:
            acc = self._times(acc, self.read(part, local))
        return acc

    def _times(self, x: Any, y: Any) -> Any:
        if isinstance(x, Blocks) and isinstance(y, Blocks):
            if x.cols != y.rows:
                x, y = self._split_like(x, x.rows, y.rows), self._split_like(y, x.cols, y.cols)
            if x.cols != y.rows and _is_number(x):
                return self._times(self.scalar(x), y)
            if x.cols != y.rows and _is_number(y):
                return self._times(x, self.scalar(y))
            return x.times(y)
        if isinstance(x, Blocks):
            return x.map(lambda p: multiply(y, p))
        if isinstance(y, Blocks):
            return y.map(lambda p: multiply(x, p))
        return multiply(x, y)

    def _read_quotient(self, tree: Any, local: Mapping[str, Any]) -> Any:
        below = self.read(tree[2], local)
        return self._times(self.read(tree[1], local), self._inverse(self.scalar(below) if _is_number(below) else below))

    def scalar(self, x: Blocks) -> Poly:
        """The number in a 1 x 1 matrix."""
        out: Poly = {}
        for (scalars, word), c in x.grid[0][0].items():
            own: Poly = {(scalars, ()): c}
            name: Poly = {(((self.scalar_name(word), 1),), ()): 1} if word else ONE
            out = add(out, multiply(own, name))
        return out

    def scalar_name(self, word: Word) -> str:
        """Name of the scalar of a 1 x 1 word; a number is its own transpose."""
        self.marks += 1
        name = f"<{'*'.join(min(word, self._transpose_word(word)))}>"
        self.numbers[name] = word
        return name

    def as_scalar(self, word: Word) -> Relation:
        """A 1 x 1 word less its scalar."""
        if word_sizes(self, word, _ONE_ROW) != _ONE_ROW:
            raise Undefined(f"the word {'*'.join(word)} is not 1 x 1")
        return Relation({((), word): 1, (((self.scalar_name(word), 1),), ()): -1}, _ONE_ROW, _ONE_ROW)

    def _read_power(self, tree: Any, local: Mapping[str, Any]) -> Any:
        base = self.read(tree[1], local)
        if not isinstance(tree[2], int):
            if isinstance(base, Blocks) or list(base.values()) != [1] or any(word for _, word in base):
                raise Unknown("a power, with a size in the exponent, of what is no product of scalars")
            ((scalars, _),) = base
            return self._to_size(scalars, self.size(tree[2], local))
        base = self._inverse(base) if tree[2] < 0 else base
        if abs(tree[2]) > _LARGEST_POWER:
            raise Unknown(f"power {tree[2]}")
        if tree[2] == 0:
            if isinstance(base, Blocks) and self.total(base.rows) != self.total(base.cols):
                raise Undefined(f"a {shape(base)} matrix is not square")
            return Blocks.unit(base.rows) if isinstance(base, Blocks) else dict(ONE)
        acc = base
        for _ in range(abs(tree[2]) - 1):
            acc = self._times(acc, base)
        return acc

    def _to_size(self, scalars: Any, size: Size) -> Poly:
        """A product of scalars to the power of a size: t^(2k - n + 1) is (t^k)^2 (t^n)^-1 t, where t^k is a scalar of its own.

        A size is not negative, so that t^k has a value; to divide by it t must not vanish.
        """
        self.marks += 1
        out: dict[str, int] = {}
        for name, e in scalars:
            for n, c in size:
                if e * c < 0 and name not in self.units:
                    raise Unknown(f"{name} is divided by, and may vanish")
                power = f"{name}^{n}" if n else name
                out[power] = out.get(power, 0) + e * c
                if name in self.units:
                    self.units.add(power)
        return {(tuple(sorted((n, e) for n, e in out.items() if e)), ()): 1}

    def _read_transpose(self, tree: Any, local: Mapping[str, Any]) -> Any:
        return self.transpose(self.read(tree[1], local))

    def transpose(self, x: Any) -> Any:
        """Transpose of blocks; scalars stay."""
        if not isinstance(x, Blocks):
            return x
        grid = [[self.transpose_poly(x.grid[i][j]) for i in range(len(x.rows))] for j in range(len(x.cols))]
        return Blocks(x.cols, x.rows, grid)

    def transpose_poly(self, p: Poly) -> Poly:
        return {(s, self._transpose_word(w)): c for (s, w), c in p.items()}

    def _transpose_word(self, word: Word) -> Word:
        if word not in self.turned:
            self.turned[word] = tuple([self.transposed[a] for a in reversed(word)])
        return self.turned[word]

    def _read_inverse(self, tree: Any, local: Mapping[str, Any]) -> Any:
        return self._inverse(self.read(tree[1], local))

    def _inverse(self, x: Any) -> Any:
        """A scalar monomial is turned over; a matrix gets letters for its inverse, a sum of scalars a name."""
        self.marks += 1
        if not isinstance(x, Blocks):
            return self._quotient(x)
        if self.total(x.rows) != self.total(x.cols):
            raise Undefined(f"a {shape(x)} matrix is not square")
        if len(x.rows) == len(x.cols) == 1 and list(x.grid[0][0]) == [((), ())]:
            return x.map(lambda p: {((), ()): number(Fraction(1, p[(), ()]))})
        for term, inverse in self.inverses:
            if term == x:
                return inverse
        turned = self.transpose(x)
        for term, inverse in self.inverses:
            if term == turned:
                return self.transpose(inverse)
        self.inverses.append((x, self._letters(x, turned == x)))
        return self.inverses[-1][1]

    def _letters(self, x: Blocks, symmetric: bool, kind: str = "inv") -> Blocks:
        """A letter, or a block of letters, for the inverse of x."""
        if len(x.rows) == len(x.cols) == 1:
            name = self._fresh(f"{kind}({text(x.grid[0][0], '1')})")
            self._letter(name, x.cols[0], x.rows[0], symmetric)
            return Blocks(x.cols, x.rows, [[{((), (name,)): 1}]])
        stem = f"{kind}[{'; '.join(', '.join(text(p, '1') for p in row) for row in x.grid)}]"
        names = [[self._fresh(f"{stem}.{i}.{j}") for j in range(len(x.rows))] for i in range(len(x.cols))]
        for i, row in enumerate(names):
            for j, name in enumerate(row):
                self._letter(name, x.cols[i], x.rows[j], symmetric and i == j)
        if symmetric:
            for i, row in enumerate(names):
                for j, name in enumerate(row):
                    self.transposed[name] = names[j][i]
        return Blocks(x.cols, x.rows, [[{((), (name,)): 1} for name in row] for row in names])

    def _read_stein(self, tree: Any, local: Mapping[str, Any]) -> Any:
        """A letter for the solution X of X = MXM' + Q.

        It is read only where a hypothesis says that M, or M', is stable: then there is one, and no other (`exactkf.kernel.stable`), wherever
        the term stands. So it is symmetric if Q is, and X' belongs to Q'.
        """
        self.marks += 1
        if self.asking:
            raise Unknown("a solution X = MXM' + Q in what is said to be stable")
        m, q = (self.read(x, local) for x in tree[1:])
        if not isinstance(m, Blocks) or not isinstance(q, Blocks) or len(m.rows) != 1 or not m.rows == m.cols == q.rows == q.cols:
            raise Unknown("X = MXM' + Q with matrices that are not square, of different sizes, or in blocks")
        if not any(x in (m, self.transpose(m)) for x in self._stable_ones()):
            raise Unknown("X = MXM' + Q where no hypothesis says that M is stable")
        turned = self.transpose(q)
        for other, free, solution in self.steins:
            if other == m and free in (q, turned):
                return solution if free == q else self.transpose(solution)
        name = self._fresh(f"stein({text(m.grid[0][0], '1')}; {text(q.grid[0][0], '1')})")
        self._letter(name, m.rows[0], m.rows[0], q == turned)
        self.steins.append((m, q, Blocks(m.rows, m.cols, [[{((), (name,)): 1}]])))
        return self.steins[-1][2]

    def _stable_ones(self) -> Iterator[Any]:
        """The matrices of which hypotheses say that they are stable."""
        for _, formula in hypotheses(self.statement):
            if formula[0] == "schur":
                self.asking = True
                try:
                    found = self.read(formula[1])
                except (Unknown, Undefined):  # such as a polynomial
                    continue
                finally:
                    self.asking = False
                yield found

    def _read_kernel(self, tree: Any, local: Mapping[str, Any]) -> Any:
        """A basis N of the null space of X, with as many columns as it takes.

        It has a left inverse, and for any (1)-inverse Y of X the columns of I - YX lie in the null space, so that I - YX = NM
        with M = L(I - YX) for a left inverse L of N; then MN = LN = I. So there are M and Y with the relations that `relations` notes.
        """
        self.marks += 1
        x = self.read(tree[1], local)
        if not isinstance(x, Blocks):
            raise Unknown("the null space of a scalar")
        for known, basis, _, _ in self.kernels:
            if known == x:
                return basis
        name = f"{shape(x)}: {'; '.join(', '.join(text(p, '1') for p in row) for row in x.grid)}"  # of this matrix alone
        nullity: Size = ((f"{_NULLITY}[{name}]", 1),)
        made: list[Blocks] = []
        for kind, rows, cols in (("ker", x.cols, (nullity,)), ("coker", (nullity,), x.cols), ("part", x.cols, x.rows)):
            grid: list[list[Poly]] = []
            for i, height in enumerate(rows):
                names = [self._fresh(f"{kind}[{name}].{i}.{j}") for j in range(len(cols))]
                for letter, width in zip(names, cols, strict=True):
                    self._letter(letter, height, width, False)
                grid.append([{((), (letter,)): 1} for letter in names])
            made.append(Blocks(rows, cols, grid))
        basis, left, part = made
        self.kernels.append((x, basis, left, part))
        return basis

    def _fresh(self, name: str) -> str:
        if name in self.sizes or name in self.kinds:
            raise Unknown(f"two meanings of {name}")
        return name

    def _quotient(self, p: Poly) -> Poly:
        if not p:
            raise Undefined("division by zero")
        if len(p) == 1:
            ((s, _), c), = p.items()
            self.units.update(n for n, _ in s)
            return {(tuple((n, -e) for n, e in s), ()): number(Fraction(1, c))}
        name = f"inv({text(p, '1')})"
        if (p, name) not in self.quotients:
            self.quotients.append((p, self._fresh(name)))
            self.units.add(name)
        return {(((name, 1),), ()): 1}

    def _read_det(self, tree: Any, local: Mapping[str, Any]) -> Poly:
        x = self.read(tree[1], local)
        return self.det(x) if isinstance(x, Blocks) else x

    def det(self, x: Blocks) -> Poly:
        """Determinant: of a block triangular matrix, of a product of square letters; of another matrix, and of a letter, a scalar."""
        self.marks += 1
        if x.rows != x.cols:
            if self.total(x.rows) != self.total(x.cols):
                raise Undefined(f"a {shape(x)} matrix is not square")
            return self._det_name(x)
        n = len(x.rows)
        if n > 1 and any(not any(x.grid[i][j] for i in range(n) for j in range(n) if (i - j) * side > 0) for side in (1, -1)):
            out = dict(ONE)
            for i in range(n):
                out = multiply(out, self.det(Blocks((x.rows[i],), (x.cols[i],), [[x.grid[i][i]]])))
            return out
        p = x.grid[0][0]
        if n == 1 and len(p) == 1 and all(self.sizes[a] == (x.rows[0], x.rows[0]) for (_, word) in p for a in word):
            ((scalars, word), c), = p.items()
            if c == 1 and scalars and not word:
                return self._to_size(scalars, x.rows[0])
            if c == 1 and not scalars and len(word) != 1:
                out = dict(ONE)
                for a in word:
                    out = multiply(out, self.det(Blocks(x.rows, x.cols, [[{((), (a,)): 1}]])))
                return out
        for term, inverse in self.inverses:
            if x in (inverse, self.transpose(inverse)):
                return self._quotient(self.det(term))
        return self.scalar(x) if _is_number(x) else self._det_name(x)

    def _det_name(self, x: Blocks) -> Poly:
        name = min("; ".join(", ".join(text(p, "1") for p in row) for row in y.grid) for y in (x, self.transpose(x)))
        known = self.dets.setdefault(f"det({name})", x)
        if known not in (x, self.transpose(x)):
            raise Unknown(f"two meanings of det({name})")
        return {(((f"det({name})", 1),), ()): 1}

    def _read_trace(self, tree: Any, local: Mapping[str, Any]) -> Poly:
        x = self.read(tree[1], local)
        return self.trace(x) if isinstance(x, Blocks) else x

    def trace(self, x: Blocks) -> Poly:
        """Trace: that of an identity is its size; of a word a scalar, the same for words that a turn of the circle or a transpose takes to each other."""
        if self.total(x.rows) != self.total(x.cols):
            raise Undefined(f"a {shape(x)} matrix is not square")
        if x.rows != x.cols:
            raise Unknown("the trace of a matrix whose rows and columns are in different blocks")
        out: Poly = {}
        for i, rows in enumerate(x.rows):
            for (scalars, word), c in x.grid[i][i].items():
                own: Poly = {(scalars, ()): c}
                value: Poly = self._trace_of_word(word) if word else {(((n, 1),) if n else (), ()): k for n, k in rows}
                out = add(out, multiply(own, value))
        return out

    def _trace_of_word(self, word: Word) -> Poly:
        """tr(AB) = tr(BA), and tr(X') = tr(X); a word that starts with one row is a number."""
        turns = [word[k:] + word[:k] for k in range(len(word))]
        numbers = [w for w in turns if self.sizes[w[0]][0] == _ONE_ROW]
        same = [v for w in numbers or turns for v in (w, self._transpose_word(w))]
        name = self.scalar_name(min(same)) if numbers else f"tr({'*'.join(min(same))})"
        return {(((name, 1),), ()): 1}

    def _read_identity(self, tree: Any, local: Mapping[str, Any]) -> Any:
        size = self.size(tree[1], local)
        return Blocks((size,), (size,), [[dict(ONE)]])

    def _read_zero(self, tree: Any, local: Mapping[str, Any]) -> Any:
        return Blocks((self.size(tree[1], local),), (self.size(tree[2], local),), [[{}]])

    def _split_like(self, x: Blocks, rows: tuple, cols: tuple) -> Blocks:
        """An identity or zero of a total size, opened into blocks."""
        if (x.rows, x.cols) == (rows, cols) or len(x.rows) != 1 or len(x.cols) != 1:
            return x
        p = x.grid[0][0]
        if not p and x.rows[0] == self.total(rows) and x.cols[0] == self.total(cols):
            return Blocks(rows, cols, [[{} for _ in cols] for _ in rows])
        if list(p) == [((), ())] and x.rows[0] == self.total(rows) and rows == cols:
            return Blocks(rows, cols, [[dict(p) if i == j else {} for j in range(len(cols))] for i in range(len(rows))])
        if list(p) == [((), ())] and x.rows[0] == self.total(rows) == self.total(cols):
            finer = rows if len(rows) > len(cols) else cols
            return Blocks(finer, finer, [[dict(p) if i == j else {} for j in range(len(finer))] for i in range(len(finer))])
        return x

    def total(self, parts: tuple) -> Size:
        out: dict[str, int] = {}
        for part in parts:
            for n, c in part:
                out[n] = out.get(n, 0) + c
        return tuple(sorted((n, c) for n, c in out.items() if c))

    def _read_block(self, tree: Any, local: Mapping[str, Any]) -> Any:
        cells = [[self.read(x, local) for x in row] for row in tree[1:]]
        heights: list[tuple | None] = [next((c.rows for c in row if isinstance(c, Blocks)), None) for row in cells]
        widths: list[tuple | None] = [next((row[j].cols for row in cells if isinstance(row[j], Blocks)), None) for j in range(len(cells[0]))]
        if None in heights or None in widths:
            raise Unknown("a block row or column without sizes")
        grid: list[list[Poly]] = []
        for row, height in zip(cells, heights, strict=True):
            parts = []
            for c, width in zip(row, widths, strict=True):
                if not isinstance(c, Blocks):
                    c = self._scalar_block(c, Blocks(height, width, [[{} for _ in width] for _ in height]))  # type: ignore[arg-type, union-attr]
                c = self._split_like(c, height, width)  # type: ignore[arg-type]
                if (c.rows, c.cols) != (height, width):
                    raise Undefined("blocks of one row or column have different sizes")
                parts.append(c)
            grid.extend([sum((c.grid[i] for c in parts), []) for i in range(len(height))])  # type: ignore[arg-type]
        return Blocks(sum(heights, ()), sum(widths, ()), grid)  # type: ignore[arg-type]


def _alike(statement: Mapping[str, Any], symmetric: frozenset[str]) -> dict[Any, tuple[Any, Any]]:
    """What has been read by readers of the same letters in statements that one statement was taken apart into.

    Trees are known by their identity, and so are the parts of a statement on which letters depend; all of them are kept.
    """
    parts = [statement[x] for x in ("sizes", "over", "where")]
    return statement.get("alike", {}).setdefault((*map(id, parts), symmetric), (parts, {}))[1]


def _is_number(x: Any) -> bool:
    return isinstance(x, Blocks) and x.rows == x.cols == (_ONE_ROW,)


_METHODS = {
    "rat": "rational", "sym": "name", "at": "call", "+": "sum", "-": "difference", "neg": "minus", "*": "product", "/": "quotient",
    "^": "power", "T": "transpose", "inv": "inverse", "I": "identity", "O": "zero", "block": "block", "det": "det", "tr": "trace",
    "kernel": "kernel", "stein": "stein",
}


def residual_blocks(reader: Reader, formula: Any) -> list[Blocks]:
    """Left minus right side of the equations of a conjunction."""
    op = formula[0]
    if op == "and":
        return [b for part in formula[1:] for b in residual_blocks(reader, part)]
    if op == "=":
        sides = [reader.read(x) for x in formula[1:]]
        out = [reader._plus(x, y, -1) for x, y in zip(sides, sides[1:], strict=False)]
    elif op == "symmetric":
        x = reader.read(formula[1])
        out = [reader._plus(x, reader.transpose(x), -1)]
    elif op == "symplectic":
        m = _in_halves(reader, reader.read(formula[1]))
        j = _form(m.rows)
        out = [reader._times(reader._times(reader.transpose(m), j), m).plus(j, -1)]
    else:
        raise Unknown(f"{op!r} is no equation")
    return [x if isinstance(x, Blocks) else Blocks((_ONE_ROW,), (_ONE_ROW,), [[x]]) for x in out]


def _form(sizes: tuple[Size, ...]) -> Blocks:
    """J = [[0, I], [-I, 0]]."""
    return Blocks(sizes, sizes, [[{}, dict(ONE)], [{((), ()): -1}, {}]])


def _in_halves(reader: Reader, m: Any) -> Blocks:
    """A matrix as four square blocks of one size."""
    if isinstance(m, Blocks) and len(m.rows) == len(m.cols) == 1 and all(c % 2 == 0 for _, c in m.rows[0]):
        half = (tuple((n, c // 2) for n, c in m.rows[0]),) * 2
        m = reader._split_like(m, half, half)
    if not isinstance(m, Blocks) or len(m.rows) != 2 or m.rows != m.cols or m.rows[0] != m.rows[1]:
        raise Unknown("symplectic matrix that is not given by four blocks")
    return m


def _op(tree: Any) -> str:
    return tree[0] if isinstance(tree, (list, tuple)) and tree else ""


def _other_side(reader: Reader, formula: Any) -> list[Blocks]:
    """What the two-sidedness of inverses of square matrices adds to a hypothesis."""
    if formula[0] == "symplectic":
        m = _in_halves(reader, reader.read(formula[1]))
        j = _form(m.rows)
        return [reader._times(reader._times(m, j), reader.transpose(m)).plus(j, -1)]
    if formula[0] == "=" and [_op(x) for x in formula[1:]] == ["*", "I"] and len(formula[1]) == 3:
        x, y = (reader.read(f) for f in formula[1][1:])
        if isinstance(x, Blocks) and isinstance(y, Blocks) and x.rows == x.cols == y.rows == y.cols:
            return [reader._plus(y.times(x), reader.read(formula[2]), -1)]
    return []


def relations(reader: Reader) -> dict[str, Relation]:
    """Named polynomials that vanish under the hypotheses: call after every goal has been read."""
    out: dict[str, Relation] = {}
    for place, (label, whole) in enumerate(hypotheses(reader.statement)):
        formula = whole
        key, marks = (label, id(formula)), reader.marks
        if place in reader.noted or key in reader.alike:
            out.update(reader.noted[place] if place in reader.noted else reader.alike[key][1])
            continue
        try:
            if formula[0] in ("psd", "pd", "loewner"):  # that the matrix is symmetric is part of it
                formula = ["symmetric", formula[1] if len(formula) == 2 else ["-", *formula[1:]]]
            if formula[0] == "=" and len(formula) == 3 and _op(formula[1]) == "rank":
                found = _one_sided(reader, formula[1][1], formula[2])
            else:
                found = residual_blocks(reader, formula) + _other_side(reader, formula)
        except (Unknown, TypeError):
            continue  # an inequality is not used
        noted: dict[str, Relation] = {}
        for n, blocks in enumerate(found):
            _note(noted, reader, f"{label}/{n}", blocks)
        if reader.marks == marks:
            reader.alike[key] = whole, noted
        else:
            reader.noted[place] = noted  # what has been read once reads the same again
        out.update(noted)
    for n, (term, inverse) in enumerate(reader.inverses, 1):
        _note(out, reader, f"inverse {n}/right", term.times(inverse).plus(Blocks.unit(term.rows), -1))
        _note(out, reader, f"inverse {n}/left", inverse.times(term).plus(Blocks.unit(term.cols), -1))
    for n, (x, basis, left, part) in enumerate(reader.kernels, 1):
        _note(out, reader, f"null space {n}/zero", x.times(basis))
        _note(out, reader, f"null space {n}/left", left.times(basis).plus(Blocks.unit(basis.cols), -1))
        _note(out, reader, f"null space {n}/all", part.times(x).plus(basis.times(left)).plus(Blocks.unit(x.cols), -1))
    for n, (m, q, x) in enumerate(reader.steins, 1):
        step = x.plus(m.times(x).times(reader.transpose(m)), -1)
        _note(out, reader, f"stein {n}", step.plus(q, -1))
    for n, (p, name) in enumerate(reader.quotients, 1):
        out[f"quotient {n}"] = Relation(add(multiply(p, {(((name, 1),), ()): 1}), ONE, -1), None, None)
    return out


def _note(out: dict[str, Relation], reader: Reader, name: str, blocks: Blocks) -> None:
    for i, row in enumerate(blocks.grid):
        for j, p in enumerate(row):
            if p and not any(word for _, word in p) and (blocks.rows[i], blocks.cols[j]) == (_ONE_ROW, _ONE_ROW):
                out[f"{name}/{i}/{j}"] = Relation(p, None, None)
            elif p:
                out[f"{name}/{i}/{j}"] = Relation(p, blocks.rows[i], blocks.cols[j])
                out[f"{name}/{i}/{j}'"] = Relation(reader.transpose_poly(p), blocks.cols[j], blocks.rows[i])


def _one_sided(reader: Reader, tree: Any, rank: Any) -> list[Blocks]:
    """A matrix whose rank is its number of columns has a left inverse, one whose rank is its number of rows a right one."""
    reader.marks += 1
    x, r = reader.read(tree), reader.size(rank)
    out = []
    if isinstance(x, Blocks) and r in (reader.total(x.rows), reader.total(x.cols)):
        v = next((v for y, v in reader.sides if y == x), None) or reader._letters(x, False, "side")
        reader.sides.append((x, v))
        if r == reader.total(x.cols):
            out.append(v.times(x).plus(Blocks.unit(x.cols), -1))
        if r == reader.total(x.rows):
            out.append(x.times(v).plus(Blocks.unit(x.rows), -1))
    return out


def word_sizes(reader: Reader, word: Word, rows: Size) -> Size:
    """Columns of a word that starts with so many rows; a product that does not fit is refused."""
    at = rows
    for letter in word:
        if letter not in reader.sizes or reader.sizes[letter][0] != at:
            raise Undefined(f"letter {letter!r} does not fit in the word {'*'.join(word)}")
        at = reader.sizes[letter][1]
    return at
