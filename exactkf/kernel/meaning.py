# SPDX-License-Identifier: MIT
"""What a statement means: its value on an instance, over any exact scalars.

A statement is the JSON object of `exactkf.language.Statement`: sizes, typed
variables, definitions, labelled hypotheses, conclusion. An instance gives
every size an integer and every variable a value. `World` evaluates trees on
an instance; `exactkf.kernel.instances` reads instances.

Truth follows classical logic with two conventions. A term that divides by
zero has no value (`Undefined`), and an instance on which the conclusion has
no value is outside the statement: denominators are hypotheses. What comes after
a part of a conjunction that is false need not have a value. ``always(t, p)`` looks at t = 0 .. horizon, up to the first t at which p has no value, and
needs at least t = 0 and 1 (t = 0 for horizon 0).
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from itertools import combinations
from math import floor, isqrt
from typing import Any

from exactkf.kernel.algebraic import Algebraic
from exactkf.kernel.cosines import cosine
from exactkf.kernel.limits import BITS
from exactkf.kernel.linear import Matrix, block, char_coefficients, echelon, inertia, null_basis, similar, symplectic_form
from exactkf.kernel.numbers import Laurent, Ratio, Undefined, Unknown, divide, rational, sign
from exactkf.kernel.roots import circle_sign, count_circle, count_real, gcd_poly
from exactkf.kernel.symbolic import Symbolic

__all__ = ["Generic", "Listed", "Signal", "World", "count", "indices", "is_invertible", "is_pd", "is_psd", "is_symmetric", "truth"]

_LARGEST_POWER = 10**5  # an exponent, times the size of an integer
_LARGEST_SIZE = 10**3
_LONGEST_RANGE = 10**5
_DEEPEST = 100  # levels of recursion a definition may take


class _TooDeep(Undefined):
    """A definition that calls itself too often from here; from elsewhere it may have a value."""


class _Ended(Undefined):
    """An entry of a sequence without end that an instance does not list; the sequence has one."""


class Generic(int):
    """An index t, or t + k, of which an induction knows no more than that.

    It is an integer that no recursion reaches from its start, and an entry at an integer of this size written out in the
    statement would be taken for the one at t: so those are refused (`World.at`), and so are values before that at t.
    """

    FAR = 10**5  # the indices of an instance are below this
    T = 10**6

    def _moved(self, k: Any, direction: int) -> Generic:
        if type(k) is not int or abs(k) > 100:
            raise Unknown("a generic index plus anything but a small integer")
        return Generic(int(self) + direction * k)

    def __add__(self, k: Any) -> Generic: return self._moved(k, 1)
    def __sub__(self, k: Any) -> Generic: return self._moved(k, -1)
    def __mul__(self, k: Any) -> Any: raise Unknown("a multiple of a generic index")
    def __neg__(self) -> Any: raise Unknown("a generic index with a sign")
    __radd__ = __add__
    __rsub__ = __rmul__ = __mul__


class Listed(dict):
    """The entries of a sequence without end that an instance lists."""


class Signal(dict):
    """A sequence without end: entries appear when they are asked for."""

    def __init__(self, start: int, entry: Callable[[int], Any]) -> None:
        super().__init__()
        self.start, self.entry = start, entry

    def __contains__(self, k: object) -> bool:
        return isinstance(k, int) and k >= self.start

    def __missing__(self, k: int) -> Any:
        self[k] = value = self.entry(k)
        return value


class World:
    """Values of names, with memory for definitions."""

    def __init__(self, statement: Mapping[str, Any], values: Mapping[str, Any]) -> None:
        self.values = dict(values)
        self.horizon = self.values.pop("horizon", 5)
        self.definitions = {d[1]: d for d in statement["where"]}
        self.memory: dict[tuple, Any] = {}
        self.depth = 0
        self.symbolic = False  # set by `generic`: conditions may then compare indices only

    def value(self, tree: Any, local: Mapping[str, Any] | None = None) -> Any:
        """Value of a term or truth of a formula; `local` binds indices."""
        if isinstance(tree, int):
            return tree
        op = tree[0]
        if op == "sym":
            name = tree[1]
            return local[name] if local and name in local else self.values[name] if name in self.values else self.call(name, ())
        special = _SPECIAL.get(op)
        if special is not None:
            return special(self, tree, local or {})
        if len(tree) == 3 and op in _OF_INTEGERS:
            _, x, y = tree
            if type(x) is not int:  # an index at once: most operands are one
                x = local[x[1]] if local and x[0] == "sym" and x[1] in local else self.value(x, local)
            if type(y) is not int:
                y = local[y[1]] if local and y[0] == "sym" and y[1] in local else self.value(y, local)
            if type(x) is int and type(y) is int:
                return _OF_INTEGERS[op](x, y)
            if self.symbolic and op in _NOT_GENERIC:
                raise Unknown(f"{op!r} of quantities with variables")
            return _PLAIN[op](x, y)
        if self.symbolic and op in _NOT_GENERIC:
            args = [self.value(arg, local) for arg in tree[1:]]
            if not all(isinstance(a, int) and not isinstance(a, bool) for a in args):
                raise Unknown(f"{op!r} of quantities with variables")
            return _PLAIN[op](*args)
        try:
            if len(tree) == 3:
                return _PLAIN[op](self.value(tree[1], local), self.value(tree[2], local))
            return _PLAIN[op](*[self.value(arg, local) for arg in tree[1:]])
        except ZeroDivisionError as error:
            raise Undefined("division by zero") from error

    def integer(self, tree: Any, local: Mapping[str, Any]) -> int:
        """Value of an index."""
        k = _whole(self.value(tree, local))
        if not isinstance(k, int):
            raise Undefined(f"index {tree!r} is not an integer")
        return k

    # ------------------------------------------------------------------ names
    def name(self, tree: Any, local: Mapping[str, Any]) -> Any:
        name = tree[1]
        if name in local:
            return local[name]
        if name in self.values:
            return self.values[name]
        return self.call(name, ())

    def at(self, tree: Any, local: Mapping[str, Any]) -> Any:
        name = tree[1]
        definition = self.definitions.get(name)
        if definition is not None and (definition[0] == "rec" or definition[2]) and name not in self.values and name not in local:
            args = tuple([a if type(a) is int else local[a[1]] if a[0] == "sym" and a[1] in local else self.value(a, local) for a in tree[2:]])
            if definition[0] == "rec" and type(args[0]) is not int:
                args = (_whole(args[0]),)
            if self.symbolic:
                _need_near(args)
            return self.call(name, args)
        sequence = self.name(tree, local)
        if isinstance(sequence, Matrix):
            return _pick(sequence, *(self.integer(a, local) for a in tree[2:]))
        if not isinstance(sequence, dict):
            raise Undefined(f"{name} is not a sequence")
        k = self.integer(tree[2], local)
        if self.symbolic:
            _need_near((k,))
        if k not in sequence:
            ended = isinstance(sequence, Listed) and k > max(sequence, default=k - 1)
            raise (_Ended if ended else Undefined)(f"{name}[{k}] is outside the sequence")
        return sequence[k]

    def call(self, name: str, args: tuple) -> Any:
        """Value of a definition, remembered when its arguments are integers."""
        asked = name, args
        key: tuple | None = asked
        for a in args:
            if type(a) is not int and type(a) is not Generic:  # the truth of a formula is not the number that it is equal to
                key = None
                break
        else:
            found = self.memory.get(asked, self)
            if found is not self:
                if isinstance(found, Undefined):
                    raise found
                return found
        if self.depth > _DEEPEST:
            raise _TooDeep(f"definition of {name} does not end")
        self.depth += 1
        try:
            definition = self.definitions[name]
            if definition[0] == "rec":
                self._climb(definition, args)
            result = self._define(definition, args)
            if isinstance(result, (int, Fraction)) and result.numerator.bit_length() + result.denominator.bit_length() > BITS:
                raise Unknown(f"too large a value of {name}")
        except _TooDeep:
            raise
        except RecursionError:
            raise _TooDeep(f"definition of {name} does not end") from None
        except Undefined as error:
            result = error
        finally:
            self.depth -= 1
        if key is not None:
            self.memory[key] = result
        if isinstance(result, Undefined):
            raise result
        return result

    def _climb(self, definition: Any, args: tuple) -> None:
        """Values of a long recursion from its start on, so that none is deep."""
        name, start = definition[1], definition[3]
        if len(args) == 1 and isinstance(args[0], int) and args[0] - start < 10**4:
            known = args[0] - 1
            while known > start and (name, (known,)) not in self.memory:
                known -= 1
            for k in range(max(known, start + 1), args[0]):
                try:
                    self.call(name, (k,))
                except _TooDeep:
                    raise
                except Undefined:  # a later one may have a value without it
                    pass

    def _define(self, definition: Any, args: tuple) -> Any:
        name = definition[1]
        if definition[0] == "let":
            params, body = definition[2], definition[3]
            if len(params) != len(args):
                raise Undefined(f"{name} takes {len(params)} arguments, not {len(args)}")
            return self.value(body, dict(zip(params, args, strict=True)))
        _, _, index, start, initial, step = definition
        (k,) = args
        if not isinstance(k, int) or k < start:
            raise Undefined(f"{name}[{k}] lies before the start of the recursion")
        if isinstance(k, Generic) and k <= Generic.T:
            raise Unknown(f"a value of {name} before a generic one")
        if k < start + len(initial):
            return self.value(initial[k - start], {})
        return self.value(step, {index: k - 1})


# ---------------------------------------------------------------------- operations that bind, choose or short-cut
def _range(world: World, tree: Any, local: Mapping[str, Any]) -> Iterator[dict]:
    _, index, low, high, _body = tree
    for k in indices(world.integer(low, local), world.integer(high, local)):
        yield {**local, index: k}


def _sum(world: World, tree: Any, local: Mapping[str, Any]) -> Any:
    acc = None
    for inner in _range(world, tree, local):
        term = world.value(tree[4], inner)
        acc = term if acc is None else acc + term
    return 0 if acc is None else acc


def _prod(world: World, tree: Any, local: Mapping[str, Any]) -> Any:
    acc: Any = 1
    for inner in _range(world, tree, local):
        acc = _times(acc, world.value(tree[4], inner))
    return acc


def truth(world: World, tree: Any, local: Mapping[str, Any]) -> bool:
    result = world.value(tree, local)
    if result is True or result is False:
        return result
    raise Undefined("a term stands where a formula is needed")


def _and(world: World, tree: Any, local: Mapping[str, Any]) -> bool:
    for x in tree[1:]:  # noqa: SIM110 - faster than all()
        if not truth(world, x, local):
            return False
    return True


def _or(world: World, tree: Any, local: Mapping[str, Any]) -> bool:
    for x in tree[1:]:  # noqa: SIM110
        if truth(world, x, local):
            return True
    return False


def _every(world: World, tree: Any, local: Mapping[str, Any]) -> bool:
    for inner in _range(world, tree, local):  # noqa: SIM110 - a third faster than all()
        if not truth(world, tree[4], inner):
            return False
    return True


def _some(world: World, tree: Any, local: Mapping[str, Any]) -> bool:
    for inner in _range(world, tree, local):  # noqa: SIM110
        if truth(world, tree[4], inner):
            return True
    return False


def _always(world: World, tree: Any, local: Mapping[str, Any]) -> bool:
    _, index, body = tree
    if world.horizon is None:
        raise Unknown("a statement for all t needs an induction")
    for t in range(world.horizon + 1):
        try:
            if not truth(world, body, {**local, index: t}):
                return False
        except _TooDeep as error:
            raise Unknown(str(error)) from error
        except Undefined:
            if t <= min(1, world.horizon):
                raise
            return True
    return True


def _condition(world: World, tree: Any, local: Mapping[str, Any]) -> bool:
    """Truth of what decides between cases. Where variables are symbols only indices may decide:
    two expressions that differ as rational functions are still equal for some values."""
    if not world.symbolic:
        return truth(world, tree, local)
    if tree[0] in ("and", "or", "not", "<=>"):
        parts = [_condition(world, x, local) for x in tree[1:]]
        return {"and": all, "or": any, "not": lambda p: not p[0], "<=>": lambda p: p[0] == p[1]}[tree[0]](parts)
    if tree[0] not in ("=", "!=", "<", "<=", ">", ">="):
        raise Unknown(f"condition {tree[0]!r} on quantities with variables")
    return _PLAIN[tree[0]](*(world.integer(x, local) for x in tree[1:]))


def _implies(world: World, tree: Any, local: Mapping[str, Any]) -> bool:
    return not _condition(world, tree[1], local) or truth(world, tree[2], local)


def _defined(world: World, tree: Any, local: Mapping[str, Any]) -> bool:
    if world.symbolic:
        raise Unknown("definedness of a quantity with variables")
    try:
        world.value(tree[1], local)
    except (_TooDeep, _Ended) as error:
        raise Unknown(str(error)) from error
    except Undefined:
        return False
    return True


def _mat(world: World, tree: Any, local: Mapping[str, Any]) -> Matrix:
    _, i, j, nrows, ncols, body = tree
    make = Matrix.lazy if world.symbolic else Matrix.build  # an instance is outside if any entry has no value
    return make(count(world.integer(nrows, local)), count(world.integer(ncols, local)),
                lambda r, c: _scalar(world.value(body, {**local, i: r + 1, j: c + 1})))


def _col(world: World, tree: Any, local: Mapping[str, Any]) -> Matrix:
    _, i, length, body = tree
    return Matrix.build(count(world.integer(length, local)), 1, lambda r, c: _scalar(world.value(body, {**local, i: r + 1})))


def _entry(world: World, tree: Any, local: Mapping[str, Any]) -> Any:
    return _pick(_matrix(world.value(tree[1], local)), *(world.integer(a, local) for a in tree[2:]))


def _pick(matrix: Matrix, i: int, j: int = 1) -> Any:
    """Entry (i, j), counted from 1; one index is for a column."""
    if not (1 <= i <= matrix.nrows and 1 <= j <= matrix.ncols):
        raise Undefined(f"no entry ({i}, {j})")
    return matrix.rows[i - 1][j - 1]


def _prints(world: World, tree: Any, local: Mapping[str, Any]) -> bool:
    value, printed = world.value(tree[1], local), tree[2]
    if isinstance(printed, str):
        return _rounds_to(_scalar(value), printed)
    if not isinstance(value, Matrix) or [len(r) for r in printed] != [value.ncols] * value.nrows:
        raise Undefined("printed table has another shape")
    return all(_rounds_to(x, p) for row, prow in zip(value.rows, printed, strict=True) for x, p in zip(row, prow, strict=True))


def _rounds_to(x: Any, printed: str) -> bool:
    """|x - printed| is at most half a unit of the last printed digit."""
    places = len(printed.partition(".")[2])
    half, exact = rational(1, 2 * 10**places), Fraction(printed)
    gap = x - rational(exact.numerator, exact.denominator)
    return not (gap > half or gap < -half)


# ---------------------------------------------------------------------- operations on values
def _need_near(indices: tuple) -> None:
    """No index is an integer that stands for a generic one."""
    if any(type(k) is int and abs(k) >= Generic.FAR for k in indices):
        raise Unknown("an index that is too large for symbols")


def indices(low: int, high: int) -> range:
    """The integers from low to high, unless they are more than anybody could wait for."""
    if high - low >= _LONGEST_RANGE:
        raise Unknown("too long a range")
    return range(low, high + 1)


def _whole(x: Any) -> Any:
    """The integer that a number is, however it was made, as 2n/2; anything else as it stands."""
    if isinstance(x, Algebraic):
        k = floor(x.enclosed(Fraction(1, 2))[1])
        return k if x == k else x
    return int(x) if not isinstance(x, int) and getattr(x, "denominator", 0) == 1 else x


def count(n: int) -> int:
    """A number of rows or columns."""
    if n < 0:
        raise Undefined("negative size")
    if n > _LARGEST_SIZE:
        raise Unknown("too large a matrix")
    return n


def _scalar(x: Any) -> Any:
    if isinstance(x, Matrix):
        if not x.is_scalar:
            raise Undefined("a matrix stands where a scalar is needed")
        return x.rows[0][0]
    return x


def _square(x: Any) -> Matrix:
    m = x if isinstance(x, Matrix) else Matrix([[x]])
    m._square()
    return m


def _matrix(x: Any) -> Matrix:
    return x if isinstance(x, Matrix) else Matrix([[x]])


def _plus(*xs: Any) -> Any:
    acc = xs[0]
    for x in xs[1:]:
        acc = acc + x
    return acc


def _times(*xs: Any) -> Any:
    acc = xs[0]
    for x in xs[1:]:
        acc = acc * x
    return acc


def _over(x: Any, y: Any) -> Any:
    return divide(x, _scalar(y))


def _power(x: Any, k: Any) -> Any:
    if not isinstance(k, int):
        raise Undefined("exponent is not an integer")
    if abs(k) * (x.bit_length() if isinstance(x, int) else 1) > _LARGEST_POWER:
        raise Unknown("too large a power")
    if isinstance(x, Matrix):
        return x.power(k)
    out: Any = 1
    for _ in range(abs(k)):
        out = out * x
    return divide(1, out) if k < 0 else out


def _sqrt(x: Any) -> Any:
    """Square root of a rational square; Undefined where there is none, and Unknown where it is not rational."""
    x = _scalar(x)
    if isinstance(x, (Symbolic, Laurent, Ratio, Algebraic)):
        raise Unknown("square root of a quantity that is not rational")
    p, q = int(x.numerator), int(x.denominator)
    if p < 0:
        raise Undefined("no square root of a negative number")
    if isqrt(p) ** 2 != p or isqrt(q) ** 2 != q:
        raise Unknown("square root that is not rational")
    return isqrt(p) if isinstance(x, int) else rational(isqrt(p), isqrt(q))


def _poly(x: Any) -> Laurent:
    x = _scalar(x)
    if isinstance(x, Ratio):
        if len(x.den.c) == 1:
            return x.num
        raise Undefined("a quotient stands where a polynomial is needed")
    return Laurent.of(x)


def _reciprocal(x: Any) -> Any:
    if isinstance(x, Matrix):
        return x.map(_reciprocal)
    return x.reciprocal() if isinstance(x, (Laurent, Ratio)) else x


def _reverse(x: Any, n: Any) -> Any:
    return _poly(x).reciprocal().shift(n)


def _substitute(p: Any, x: Any) -> Any:
    p = _scalar(p)
    if isinstance(p, Ratio):
        return _over(_substitute(p.num, x), _substitute(p.den, x))
    p = Laurent.of(p)
    matrix = isinstance(x, Matrix)
    acc = x * 0 if matrix else 0
    for k, c in p.c.items():
        acc = acc + _power(x, k) * c
    return acc


def _at_infinity(f: Any, k: Any) -> Any:
    f = Ratio.of(_scalar(f))
    lead = f.den.get(f.den.degree)
    if isinstance(lead, Symbolic) and (any(lead.num) or lead.den):  # where it vanishes the expansion is another
        raise Unknown("an expansion by a leading coefficient with variables")
    return f.at_infinity(k)


def _charpoly(m: Any) -> Laurent:
    return Laurent(dict(enumerate(char_coefficients(_square(m)))))


def is_symmetric(m: Any) -> bool:
    m = _matrix(m)
    return m.nrows == m.ncols and m == m.transpose()


def is_psd(m: Any) -> bool:
    return is_symmetric(m) and inertia(_matrix(m))[1] == 0


def is_pd(m: Any) -> bool:
    return is_symmetric(m) and inertia(_matrix(m))[1:] == (0, 0)


def is_invertible(m: Any) -> bool:
    m = _matrix(m)
    return m.nrows == m.ncols and m.determinant() != 0


def _is_symplectic(m: Any) -> bool:
    m = _square(m)
    d, odd = divmod(m.nrows, 2)
    if odd:
        return False
    j = symplectic_form(d)
    return m.transpose() * j * m == j


def _roots(which: int) -> Callable:
    return lambda p: count_circle(_poly(p).dense())[which]


def _is_schur(x: Any) -> bool:
    p = _charpoly(x) if isinstance(x, Matrix) else _poly(x)
    inside, on, outside = count_circle(p.dense())
    return on == outside == 0


def _is_observable(c: Any, a: Any) -> bool:
    """No eigenvector of A is annihilated by C: the rows C, CA, CA^2, .. span everything, as what they annihilate is the largest subspace
    that A keeps and C annihilates, which has an eigenvector unless it is zero."""
    a, rows = _square(a), _matrix(c)
    if rows.ncols != a.nrows:
        raise Undefined("observability of matrices that do not fit")
    every = rows
    for _ in range(a.nrows - 1):
        rows = rows * a
        every = block([[every], [rows]])
    return _rank(every) == a.nrows


def _is_detectable(m: Any, n: Any) -> bool:
    """sM - tN has full column rank whenever |s| >= |t|, not both zero: no zero of all its minors with s = 1 has modulus 1 or less."""
    m, n = _matrix(m), _matrix(n)
    if (m.nrows, m.ncols) != (n.nrows, n.ncols):
        raise Undefined("a pencil of matrices of different sizes")
    common: list = []
    for rows in combinations(range(m.nrows), m.ncols):
        minor = Matrix([[Laurent({0: m.rows[i][j], 1: -n.rows[i][j]}) for j in range(m.ncols)] for i in rows], m.ncols).determinant()
        common = gcd_poly(common, _poly(minor).dense())
        if len(common) == 1:
            return True
    return bool(common) and count_circle(common)[:2] == (0, 0)


def _coprime(p: Any, q: Any) -> bool:
    return len(gcd_poly(_poly(p).dense(), _poly(q).dense())) == 1


def _rank(m: Any) -> int:
    return len(echelon(_matrix(m))[1])


def _stein(m: Any, q: Any) -> Matrix:
    """The solution X of X = MXM' + Q, if it has exactly one: a system of n^2 equations."""
    m, q = _square(m), _square(q)
    n = m.nrows
    if q.nrows != n:
        raise Undefined("X = MXM' + Q with matrices of different sizes")
    system = Matrix.build(n * n, n * n, lambda r, c: int(r == c) - m.rows[r // n][c // n] * m.rows[r % n][c % n])
    found = system.inverse() * Matrix.build(n * n, 1, lambda r, _: q.rows[r // n][r % n])
    return Matrix.build(n, n, lambda i, j: found.rows[i * n + j][0])


def _diag(*xs: Any) -> Matrix:
    parts = [_matrix(x) for x in xs]
    return block([[p if i == j else Matrix.build(p.nrows, q.ncols, lambda r, c: 0) for j, q in enumerate(parts)]
                  for i, p in enumerate(parts)])


def _chain(test: Callable[[Any, Any], bool]) -> Callable:
    def holds(*xs: Any) -> bool:
        for x in xs:
            if x is True or x is False:
                raise Undefined("a formula stands where a term is needed")
            if isinstance(x, dict):  # those without end would be compared as far as they have been looked at
                raise Undefined("a sequence stands where a term is needed")
        return test(*xs) if len(xs) == 2 else all(test(x, y) for x, y in zip(xs, xs[1:], strict=False))
    return holds


def _ordered(test: Callable[[int], bool]) -> Callable:
    return _chain(lambda x, y: test(sign(_scalar(x) - _scalar(y))))


def _blocks(world: World, tree: Any, local: Mapping[str, Any]) -> Matrix:
    return block([[world.value(x, local) for x in row] for row in tree[1:]])


def _table(world: World, tree: Any, local: Mapping[str, Any]) -> Matrix:
    return Matrix([[_scalar(world.value(x, local)) for x in row] for row in tree[1:]])


_SPECIAL: dict[str, Callable[[World, Any, Mapping[str, Any]], Any]] = {
    "sym": World.name, "at": World.at, "sum": _sum, "prod": _prod, "forall": _every, "exists": _some, "always": _always,
    "=>": _implies, "defined": _defined, "mat": _mat, "col": _col, "entry": _entry, "prints": _prints,
    "block": _blocks, "rows": _table,
    "rat": lambda w, t, loc: rational(t[1], t[2]),
    "if": lambda w, t, loc: w.value(t[2] if _condition(w, t[1], loc) else t[3], loc),
    "and": _and, "or": _or,
    "not": lambda w, t, loc: not _condition(w, t[1], loc),
    "<=>": lambda w, t, loc: _condition(w, t[1], loc) == _condition(w, t[2], loc),
}

_PLAIN: dict[str, Callable] = {
    "z": lambda: Laurent({1: 1}),
    "+": _plus, "-": lambda x, y: x - y, "neg": lambda x: -x, "*": _times, "/": _over, "^": _power,
    "sqrt": _sqrt, "cospi": lambda q, p: cosine(_whole(q), _whole(p)), "abs": lambda x: -_scalar(x) if sign(_scalar(x)) < 0 else _scalar(x),
    "diag": _diag, "I": lambda n: Matrix.identity(count(n)),
    "O": lambda r, c: Matrix.build(count(r), count(c), lambda i, j: 0),
    "T": lambda m: _matrix(m).transpose(), "inv": lambda m: _square(m).inverse(), "det": lambda m: _square(m).determinant(),
    "tr": lambda m: sum((_square(m).rows[i][i] for i in range(_square(m).nrows)), 0),
    "rank": _rank, "charpoly": _charpoly, "kernel": lambda m: null_basis(_matrix(m)), "stein": _stein,
    "nrows": lambda m: _matrix(m).nrows, "ncols": lambda m: _matrix(m).ncols,
    "coeff": lambda p, k: _poly(p).get(k), "deg": lambda p: _poly(p).degree, "rev": _reverse, "recip": _reciprocal,
    "subst": _substitute, "laurent": _at_infinity,
    "roots_in": _roots(0), "roots_on": _roots(1), "roots_out": _roots(2),
    "real_roots": lambda p, lo, hi: count_real(_poly(p).dense(), _scalar(lo), _scalar(hi)),
    "=": _chain(lambda x, y: x == y), "!=": _chain(lambda x, y: not x == y),
    "<": _ordered(lambda s: s < 0), "<=": _ordered(lambda s: s <= 0), ">": _ordered(lambda s: s > 0), ">=": _ordered(lambda s: s >= 0),
    "loewner": lambda a, b: is_psd(_matrix(a - b)), "psd": is_psd, "pd": is_pd, "symmetric": is_symmetric,
    "invertible": is_invertible, "symplectic": _is_symplectic, "similar": lambda a, b: similar(_matrix(a), _matrix(b)),
    "cospectral": lambda a, b: _charpoly(a) == _charpoly(b), "coprime": _coprime, "schur": _is_schur, "observable": _is_observable,
    "detectable": _is_detectable,
    "pos_circle": lambda d: circle_sign(_poly(d)) == "+", "nonneg_circle": lambda d: circle_sign(_poly(d)) in ("+", "0+", "0"),
}

#: operations whose value for symbols does not carry over to every value of the symbols
_NOT_GENERIC = {"!=", "<", "<=", ">", ">=", "abs", "sqrt", "rank", "kernel", "stein", "deg", "roots_in", "roots_on", "roots_out", "real_roots",
                "loewner", "psd", "pd", "invertible", "similar", "coprime", "schur", "observable", "detectable", "pos_circle", "nonneg_circle"}
_OF_INTEGERS = {"+": operator.add, "-": operator.sub, "*": operator.mul, "=": operator.eq, "!=": operator.ne,
                "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge}  # what _PLAIN does to two integers, sooner
