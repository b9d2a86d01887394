# SPDX-License-Identifier: MIT
"""What a statement means, a second time: at high precision, by other methods.

`evaluate` gives the truth of the conclusion of a statement on an instance,
`admissible` whether its types and hypotheses hold there. Nothing of the exact
evaluator is used. Scalars are mpmath numbers; inverses and determinants come
from elimination with full pivoting, ranks from singular values, definiteness from
eigenvalues, root counts from computed roots, similarity from dimensions of
spaces of intertwining matrices.

A number is zero if it is below 10^-(digits/2) times the size of what it came
from, not zero if it is well above; between the two the answer is in doubt. Where a
term has no value, or doubt remains, everything is done again with twice the
digits, and if that stays so the result is None: the instance says nothing.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any

from mpmath import mp, mpf

__all__ = ["admissible", "evaluate"]

_DIGITS = (60, 120, 240)
_DEEPEST = 200


class NoValueError(Exception):
    """A term without a value, such as a quotient by zero."""


class DoubtError(Exception):
    """Neither clearly zero nor clearly not zero at this precision."""


def evaluate(statement: Mapping[str, Any], instance: Mapping[str, Any]) -> bool | None:
    """Truth of the conclusion on an instance; None where it has no value."""
    return _decide(statement, instance, lambda w: w.truth(statement["says"], {}))


def admissible(statement: Mapping[str, Any], instance: Mapping[str, Any]) -> bool | None:
    """Whether the types and the hypotheses hold on an instance; None where one of them has no value."""
    return _decide(statement, instance, lambda w: w.typed() and all(w.truth(g[1], {}) for g in statement["given"]))


def _decide(
    statement: Mapping[str, Any], instance: Mapping[str, Any], question: Callable[[_World], bool]
) -> bool | None:
    deep = sys.getrecursionlimit()
    sys.setrecursionlimit(max(deep, 20000))
    try:
        for digits in _DIGITS:
            with mp.workdps(digits):
                try:
                    return question(_World(statement, instance))
                except (NoValueError, DoubtError, mp.NoConvergence):
                    continue  # a zero may be a small number: look again with more digits
        return None
    finally:
        sys.setrecursionlimit(deep)


# ---------------------------------------------------------------------- scalars
def _vanishes(x: Any, scale: Any = 1) -> bool:
    """Zero, for a quantity that came from quantities of the given size."""
    x, scale = abs(x), max(abs(scale), 1)
    if x <= scale * mpf(10) ** (-mp.dps // 2):
        return True
    if x >= scale * mpf(10) ** (-mp.dps // 4):
        return False
    raise DoubtError


def _sign(x: Any, scale: Any = 1) -> int:
    return 0 if _vanishes(x, scale) else (1 if x > 0 else -1)


class Poly:
    """Laurent polynomial: coefficients by exponent, with the size of what they came from."""

    def __init__(self, c: Mapping[int, Any], size: Any = 0) -> None:
        self.size = max([size, *(abs(x) for x in c.values())], default=mpf(0))
        self.c = {k: x for k, x in c.items() if not _vanishes(x, self.size)}

    def dense(self) -> list:
        """Coefficients from z^0 up."""
        if any(k < 0 for k in self.c):
            raise NoValueError("negative powers")
        return [self.c.get(k, mpf(0)) for k in range(max(self.c, default=-1) + 1)]

    def mirrored(self) -> Poly:
        return Poly({-k: x for k, x in self.c.items()}, self.size)

    def shifted(self, n: int) -> Poly:
        return Poly({k + n: x for k, x in self.c.items()}, self.size)

    def __add__(self, other: Poly) -> Poly:
        return Poly({k: self.c.get(k, 0) + other.c.get(k, 0) for k in {*self.c, *other.c}}, max(self.size, other.size))

    def __neg__(self) -> Poly:
        return Poly({k: -x for k, x in self.c.items()}, self.size)

    def __mul__(self, other: Poly) -> Poly:
        out: dict[int, Any] = {}
        for i, x in self.c.items():
            for j, y in other.c.items():
                out[i + j] = out.get(i + j, mpf(0)) + x * y
        return Poly(out, self.size * other.size)


class Quotient:
    """Quotient of two Laurent polynomials, equal when the cross products are."""

    def __init__(self, num: Poly, den: Poly) -> None:
        if not den.c:
            raise NoValueError("division by zero")
        if len(den.c) == 1:
            (k, x), = den.c.items()
            num, den = Poly({i - k: y / x for i, y in num.c.items()}, num.size / abs(x)), Poly({0: mpf(1)})
        self.num, self.den = num, den


def _poly(x: Any) -> Poly:
    if isinstance(x, Quotient):
        if max(x.den.c) or min(x.den.c):
            raise NoValueError("not a polynomial")
        return x.num
    return x if isinstance(x, Poly) else Poly({0: mpf(x)})


def _quotient(x: Any) -> Quotient:
    return x if isinstance(x, Quotient) else Quotient(_poly(x), Poly({0: mpf(1)}))


def _add(x: Any, y: Any) -> Any:
    if isinstance(x, Quotient) or isinstance(y, Quotient):
        a, b = _quotient(x), _quotient(y)
        return Quotient(a.num * b.den + b.num * a.den, a.den * b.den)
    if isinstance(x, Poly) or isinstance(y, Poly):
        return _poly(x) + _poly(y)
    return x + y


def _mul(x: Any, y: Any) -> Any:
    if isinstance(x, Quotient) or isinstance(y, Quotient):
        a, b = _quotient(x), _quotient(y)
        return Quotient(a.num * b.num, a.den * b.den)
    if isinstance(x, Poly) or isinstance(y, Poly):
        return _poly(x) * _poly(y)
    return x * y


def _div(x: Any, y: Any) -> Any:
    if isinstance(x, (Poly, Quotient)) or isinstance(y, (Poly, Quotient)):
        a, b = _quotient(x), _quotient(y)
        return Quotient(a.num * b.den, a.den * b.num)
    if _vanishes(y):
        raise NoValueError("division by zero")
    return mpf(x) / y


def _same(x: Any, y: Any, scale: Any = 0) -> bool:
    if isinstance(x, Quotient) or isinstance(y, Quotient):
        a, b = _quotient(x), _quotient(y)
        return _same(a.num * b.den, b.num * a.den)
    if isinstance(x, Poly) or isinstance(y, Poly):
        return not (_poly(x) + -_poly(y)).c
    return x == y if isinstance(x, int) and isinstance(y, int) else _vanishes(mpf(x) - y, max(abs(x), abs(y), scale))


# ---------------------------------------------------------------------- matrices
class Table:
    """Rows of entries with the number of columns; entries are numbers, polynomials or quotients."""

    def __init__(self, rows: list[list], ncols: int | None = None) -> None:
        self.rows, self.m = rows, len(rows)
        self.n = len(rows[0]) if rows else ncols or 0

    @property
    def single(self) -> bool:
        return self.m == self.n == 1

    def entries(self) -> list:
        return [x for r in self.rows for x in r]

    def numeric(self) -> bool:
        return not any(isinstance(x, (Poly, Quotient)) for x in self.entries())

    def each(self, f: Callable) -> Table:
        return Table([[f(x) for x in r] for r in self.rows], self.n)

    def turned(self) -> Table:
        return Table([[self.rows[i][j] for i in range(self.m)] for j in range(self.n)], self.m)

    def size(self) -> Any:
        return max([abs(x) for x in self.entries()], default=mpf(0))

    def mp(self) -> Any:
        if not self.numeric():
            raise NoValueError("polynomial entries")
        return mp.matrix([[mpf(x) for x in r] for r in self.rows])


def _table(x: Any) -> Table:
    return x if isinstance(x, Table) else Table([[x]])


def _entry(t: Table, i: int, j: int = 1) -> Any:
    if not (1 <= i <= t.m and 1 <= j <= t.n):
        raise NoValueError("no such entry")
    return t.rows[i - 1][j - 1]


def _square(x: Any) -> Table:
    t = _table(x)
    if t.m != t.n:
        raise NoValueError("not square")
    return t


def _number(x: Any) -> Any:
    """A scalar, also from a 1 x 1 matrix."""
    if isinstance(x, Table):
        if not x.single:
            raise NoValueError("a matrix for a scalar")
        x = x.rows[0][0]
    if isinstance(x, bool):
        raise NoValueError("a formula for a term")
    return x


def _plus(x: Any, y: Any) -> Any:
    if not isinstance(x, Table) and not isinstance(y, Table):
        return _add(x, y)
    a, b = _table(x), _table(y)
    if (a.m, a.n) != (b.m, b.n):
        raise NoValueError("sizes")
    return Table([[_add(p, q) for p, q in zip(r, s, strict=True)] for r, s in zip(a.rows, b.rows, strict=True)], a.n)


def _minus(x: Any) -> Any:
    return x.each(_minus) if isinstance(x, Table) else -x if isinstance(x, (Poly, int, mpf)) else _mul(-1, x)


def _times(x: Any, y: Any) -> Any:
    if isinstance(x, Table) and isinstance(y, Table):
        if x.n == y.m:
            return Table([[_sum(map(_mul, r, column)) for column in y.turned().rows] for r in x.rows], y.n)
        if not (x.single or y.single):
            raise NoValueError("sizes")
        x, y = (x.rows[0][0], y) if x.single else (x, y.rows[0][0])
    if isinstance(x, Table):
        return x.each(lambda e: _mul(e, y))
    return y.each(lambda e: _mul(x, e)) if isinstance(y, Table) else _mul(x, y)


def _sum(terms: Any) -> Any:
    out: Any = 0
    for t in terms:
        out = t if isinstance(out, int) and out == 0 else _add(out, t)
    return out


def _eliminated(t: Table, more: Table | None = None) -> tuple[Any, list[list]]:
    """Determinant, and the solution X of tX = more: full pivoting, every pivot judged against the largest entry."""
    n, k = t.m, more.n if more else 0
    rows = [[mpf(x) for x in r] + ([mpf(x) for x in more.rows[i]] if more else []) for i, r in enumerate(t.rows)]
    order, det, size = list(range(n)), mpf(1), max(t.size(), 1)
    for c in range(n):
        i, j = max(((i, j) for i in range(c, n) for j in range(c, n)), key=lambda ij: abs(rows[ij[0]][ij[1]]))
        if _vanishes(rows[i][j], size):
            return mpf(0), []
        if i != c:
            rows[c], rows[i], det = rows[i], rows[c], -det
        if j != c:
            for r in rows:
                r[c], r[j] = r[j], r[c]
            order[c], order[j], det = order[j], order[c], -det
        det *= rows[c][c]
        rows[c] = [x / rows[c][c] for x in rows[c]]
        for i, r in enumerate(rows):
            if i != c and r[c]:
                rows[i] = [x - r[c] * y for x, y in zip(r, rows[c], strict=True)]
    solution = [[mpf(0)] * k for _ in range(n)]
    for c, place in enumerate(order):
        solution[place] = rows[c][n:]
    return det, solution


def _singular(t: Table) -> bool:
    return t.m > 0 and not _eliminated(t)[0]


def _rank(x: Any) -> int:
    t = _table(x)
    if not t.m or not t.n:
        return 0
    wide = t if t.m >= t.n else t.turned()
    values = _svd(wide, compute_uv=False)
    return sum(not _vanishes(s / max(values[0], 1)) for s in values) if not _vanishes(values[0]) else 0


def _svd(t: Table, **options: bool) -> Any:
    """Singular values (and vectors); for some matrices the iteration comes to an end with more digits only."""
    for more in (0, 10, 30):
        with suppress(RuntimeError), mp.workdps(mp.dps + more):
            return mp.svd_r(t.mp(), **options)
    raise NoValueError("singular values")


def _det(x: Any) -> Any:
    t = _square(x)
    if t.numeric():
        return _eliminated(t)[0]
    return _sum(_mul(_mul((-1) ** j, e), _det(_minor(t, 0, j))) for j, e in enumerate(t.rows[0]))


def _minor(t: Table, i: int, j: int) -> Table:
    return Table([[x for b, x in enumerate(r) if b != j] for a, r in enumerate(t.rows) if a != i], t.n - 1)


def _inverse(x: Any) -> Table:
    t = _square(x)
    if not t.m:
        return t
    if t.numeric():
        det, found = _eliminated(t, _unit(t.m))
        if not det:
            raise NoValueError("singular")
        return Table(found, t.n)
    det = _det(t)
    return Table([[_div(_mul((-1) ** (i + j), _det(_minor(t, j, i))), det) for j in range(t.n)] for i in range(t.m)])


def _power(x: Any, k: Any) -> Any:
    if not isinstance(k, int):
        raise NoValueError("exponent")
    if isinstance(x, Table):
        x = _square(x)
        out: Any = _unit(x.m)
    else:
        out = 1
    if k < 0:
        x = _inverse(x) if isinstance(x, Table) else _div(1, x)
    for _ in range(abs(k)):
        out = _times(out, x)
    return out


def _unit(n: int) -> Table:
    return Table([[int(i == j) for j in range(n)] for i in range(_count(n))], n)


def _count(n: int) -> int:
    if n < 0:
        raise NoValueError("negative size")
    return n


def _stack(rows: list[list]) -> Table:
    parts = [[_table(x) for x in r] for r in rows]
    if any(p.m != r[0].m for r in parts for p in r) or len({sum(p.n for p in r) for r in parts}) > 1:
        raise NoValueError("sizes of blocks")
    return Table([[x for p in r for x in p.rows[i]] for r in parts for i in range(r[0].m)], sum(p.n for p in parts[0]))


def _diagonal(*xs: Any) -> Table:
    parts = [_table(x) for x in xs]
    zero = lambda m, n: Table([[0] * n for _ in range(m)], n)
    return _stack([[p if i == j else zero(p.m, q.n) for j, q in enumerate(parts)] for i, p in enumerate(parts)])


def _charpoly(x: Any) -> Poly:
    """From values det(xI - M) at n + 1 points by interpolation."""
    t = _square(x)
    if not t.numeric():
        raise NoValueError("polynomial entries")
    n, step = t.m, 1 + t.size()
    points = [step * k for k in range(n + 1)]
    values = [_det(_plus(_times(p, _unit(n)), _minus(t))) for p in points]
    vandermonde = mp.matrix([[p**k for k in range(n + 1)] for p in points])
    found = mp.lu_solve(vandermonde, mp.matrix(values))
    return Poly({k: found[k] for k in range(n + 1)})


def _eigenvalues(x: Any) -> list:
    """Of a symmetric matrix, in ascending order."""
    t = _square(x)
    return list(mp.eigsy(t.mp(), eigvals_only=True)) if t.m else []


def _is_symmetric(x: Any) -> bool:
    t = _table(x)
    return t.m == t.n and _equal(t, t.turned())


def _is_definite(x: Any, least: int) -> bool:
    t = _table(x)
    return _is_symmetric(t) and all(_sign(v, t.size()) >= least for v in _eigenvalues(t))


def _equal(x: Any, y: Any) -> bool:
    if isinstance(x, bool) or isinstance(y, bool):
        raise NoValueError("a formula for a term")
    if not isinstance(x, Table) and not isinstance(y, Table):
        return _same(x, y)
    a, b = _table(x), _table(y)
    if (a.m, a.n) != (b.m, b.n):
        raise NoValueError("sizes")
    scale = max(a.size(), b.size()) if a.numeric() and b.numeric() else 0
    return all(_same(p, q, scale) for p, q in zip(a.entries(), b.entries(), strict=True))


def _null_space(x: Any) -> Table:
    """Right singular vectors of the singular value zero."""
    t = _table(x)
    rank = _rank(t)
    if not t.m:
        return _unit(t.n)
    square = _stack([[t], [Table([[0] * t.n for _ in range(max(t.n - t.m, 0))], t.n)]]) if t.m < t.n else t
    _, _, right = _svd(square)
    return Table([[right[k, i] for k in range(rank, t.n)] for i in range(t.n)], t.n - rank)


def _unseen(c: Table, a: Table) -> Table:
    """What C annihilates, cut down to what A leaves in it, again and again; the columns are orthonormal."""
    space = _null_space(c)
    while space.n:
        across = _times(_plus(_unit(a.m), _minus(_times(space, space.turned()))), _times(a, space))
        inner = _null_space(across)
        if inner.n == space.n:
            break
        space = _times(space, inner)
    return space


def _is_observable(x: Any, y: Any) -> bool:
    c, a = _table(x), _square(y)
    if c.n != a.m:
        raise NoValueError("sizes")
    return not _unseen(c, a).n


def _is_detectable(x: Any, y: Any) -> bool:
    """M has a left inverse L, and LN is stable on the largest space that it keeps and on which N is MLN."""
    m, n = _table(x), _table(y)
    if (m.m, m.n) != (n.m, n.n):
        raise NoValueError("sizes")
    if not m.n or _rank(m) < m.n:
        return not m.n
    inner = _times(_times(_inverse(_times(m.turned(), m)), m.turned()), n)
    space = _unseen(_plus(n, _minus(_times(m, inner))), inner)
    return not space.n or _is_schur(_times(_times(space.turned(), inner), space))


def _stein(x: Any, y: Any) -> Table:
    """The coordinates of the solution, from the images of the unit matrices under X -> X - MXM'."""
    m, q = _square(x), _square(y)
    n = m.m
    if q.m != n:
        raise NoValueError("sizes")
    places = [(i, j) for i in range(n) for j in range(n)]
    units = [Table([[int((i, j) == place) for j in range(n)] for i in range(n)], n) for place in places]
    images = [_plus(u, _minus(_times(_times(m, u), m.turned()))) for u in units]
    found = _times(_inverse(Table([[image.rows[i][j] for image in images] for i, j in places], n * n)), Table([[q.rows[i][j]] for i, j in places], 1))
    return Table([[found.rows[i * n + j][0] for j in range(n)] for i in range(n)], n)


def _is_similar(x: Any, y: Any) -> bool:
    """The spaces {X: AX = XA}, {X: AX = XB}, {X: BX = XB} have one dimension."""
    a, b = _square(x), _square(y)

    def intertwiners(s: Table, t: Table) -> int:
        n, m = s.m, t.m
        rows = [[(s.rows[i][k] if j == l else 0) - (t.rows[l][j] if i == k else 0) for k in range(n) for l in range(m)]
                for i in range(n) for j in range(m)]
        return n * m - _rank(Table(rows, n * m))

    return a.m == b.m and intertwiners(a, a) == intertwiners(a, b) == intertwiners(b, b)


# ---------------------------------------------------------------------- polynomials
def _roots(p: Poly) -> list:
    c = p.dense()
    if not c:
        raise NoValueError("roots of zero")
    low = next(k for k, x in enumerate(c) if x)  # roots at zero are taken out: they are the commonest multiple ones
    c = c[low:][::-1]
    found = [mp.mpc(0)] * low
    if len(c) > 1:
        try:
            found += mp.polyroots(c, maxsteps=400, extraprec=4 * mp.prec)
        except mp.NoConvergence:
            n = len(c) - 1
            companion = Table([[int(j == i - 1) for j in range(n - 1)] + [-c[n - i] / c[0]] for i in range(n)])
            found += list(mp.eig(companion.mp(), left=False, right=False))
    return found


def _close(x: Any, degree: int) -> bool:
    """Zero, for a difference between roots: an m-fold root is known to 1/m of the digits."""
    x, digits = abs(x), mpf(mp.dps) * 8 / (10 * max(degree, 1))
    if x < mpf(10) ** -digits:
        return True
    if x > min(mpf(10) ** (-digits / 2), mpf(10) ** -4):
        return False
    raise DoubtError


def _moduli(p: Any) -> list[int]:
    """-1, 0, 1 for every root in, on, outside the unit circle."""
    found = _roots(_poly(p))
    return [0 if _close(abs(r) - 1, len(found)) else (1 if abs(r) > 1 else -1) for r in found]


def _real_points(p: Poly) -> list:
    """The distinct real roots."""
    out: list = []
    found = _roots(p)
    for r in found:
        if _close(mp.im(r), len(found)) and not any(_close(mp.re(r) - x, len(found)) for x in out):
            out.append(mp.re(r))
    return out


def _count_real(p: Any, low: Any, high: Any) -> int:
    p, low, high = _poly(p), _number(low), _number(high)
    n = len(p.dense())

    def side(x: Any) -> int:
        return 0 if _close(x, n) else 1 if x > 0 else -1

    return sum(side(x - low) > 0 and side(x - high) <= 0 for x in _real_points(p))


def _least_on_circle(d: Any) -> tuple[Any, Any]:
    """Least value of a symmetric pseudo-polynomial on |z| = 1, with its size: that of q(cos), at the extrema of q."""
    d = _poly(d)
    if not _same(d, d.mirrored()):
        raise NoValueError("not real on the circle")
    top = max(d.c, default=0)
    q = Poly({0: mpf(0)})
    before, now = Poly({0: mpf(1)}), Poly({1: mpf(1)})
    for k in range(top + 1):
        q = q + Poly({0: d.c.get(k, mpf(0)) * (2 if k else 1)}) * before
        before, now = now, Poly({1: mpf(2)}) * now + -before
    c = q.dense()
    slope = Poly({k - 1: k * x for k, x in enumerate(c) if k})
    points = [mpf(-1), mpf(1)] + ([mp.re(r) for r in _roots(slope) if abs(mp.re(r)) <= 1] if len(slope.c) > 0 else [])
    return min(mp.polyval(c[::-1] or [0], x) for x in points), d.size


def _are_coprime(p: Any, q: Any) -> bool:
    """Sylvester's matrix is nonsingular."""
    a, b = _poly(p).dense(), _poly(q).dense()
    if not a or not b:
        return len(a) + len(b) == 1
    m, n = len(a) - 1, len(b) - 1
    rows = [[0] * i + c[::-1] + [0] * (k - 1 - i) for c, k in ((a, n), (b, m)) for i in range(k)]
    return _rank(Table(rows, m + n)) == m + n


def _substitute(p: Any, x: Any) -> Any:
    p = _number(p)
    if isinstance(p, Quotient):
        return _over(_substitute(p.num, x), _substitute(p.den, x))
    zero = _times(0, x)
    terms = [_times(_power(x, k), c) for k, c in _poly(p).c.items()]
    for t in terms:
        zero = _plus(zero, t)
    return zero


def _over(x: Any, y: Any) -> Any:
    y = _number(y)
    return x.each(lambda e: _div(e, y)) if isinstance(x, Table) else _div(x, y)


def _at_infinity(f: Any, k: int) -> Any:
    """Coefficient of z^-k, by long division in 1/z."""
    f = _quotient(_number(f))
    top = max(f.den.c)
    rest, quotient = dict(f.num.c), {}
    for e in range(max(rest, default=0), -k + top - 1, -1):
        c = quotient[e - top] = rest.get(e, mpf(0)) / f.den.c[top]
        for i, x in f.den.c.items():
            rest[e - top + i] = rest.get(e - top + i, mpf(0)) - c * x
    return quotient.get(-k, mpf(0))


def _mirror(x: Any) -> Any:
    if isinstance(x, Table):
        return x.each(_mirror)
    if isinstance(x, Quotient):
        return Quotient(x.num.mirrored(), x.den.mirrored())
    return x.mirrored() if isinstance(x, Poly) else x


def _rounds(x: Any, printed: str) -> bool:
    half = mpf(10) ** -len(printed.partition(".")[2]) / 2
    return _sign(abs(_number(x) - mpf(printed)) - half) <= 0


def _root(x: Any) -> Any:
    x = _number(x)
    if _sign(x) < 0:
        raise NoValueError("root of a negative number")
    return mp.sqrt(abs(x))


def _is_schur(x: Any) -> bool:
    return all(s < 0 for s in _moduli(_charpoly(x) if isinstance(x, Table) else x))


def _is_symplectic(x: Any) -> bool:
    t = _square(x)
    half, odd = divmod(t.m, 2)
    j = Table([[int(b == a + half) - int(a == b + half) for b in range(t.m)] for a in range(t.m)], t.m)
    return not odd and _equal(_times(_times(t.turned(), j), t), j)


def _compare(x: Any, y: Any) -> int:
    x, y = _number(x), _number(y)
    return _sign(mpf(x) - y, max(abs(x), abs(y)))


def _chain(test: Callable[[Any, Any], bool]) -> Callable:
    return lambda *xs: all(test(x, y) for x, y in zip(xs, xs[1:], strict=False))


def _cosine(q: Any, p: Any) -> Any:
    q, p = _number(q), _number(p)
    if q != int(q) or p != int(p) or p <= 0:
        raise NoValueError("a cosine without integers")
    return mp.cos(mp.pi * q / p)


_PLAIN: dict[str, Callable] = {
    "rat": lambda p, q: mpf(p) / q, "z": lambda: Poly({1: mpf(1)}),
    "neg": _minus, "-": lambda x, y: _plus(x, _minus(y)),
    "/": _over, "^": _power, "sqrt": _root, "cospi": _cosine, "abs": lambda x: abs(_number(x)), "diag": _diagonal,
    "I": _unit, "O": lambda m, n: Table([[0] * _count(n) for _ in range(_count(m))], n),
    "T": lambda x: _table(x).turned(),
    "inv": _inverse, "det": _det, "rank": _rank,
    "tr": lambda x: _sum(_square(x).rows[i][i] for i in range(_square(x).m)),
    "charpoly": _charpoly, "kernel": _null_space, "stein": _stein, "nrows": lambda x: _table(x).m, "ncols": lambda x: _table(x).n,
    "coeff": lambda p, k: _poly(_number(p)).c.get(k, mpf(0)), "deg": lambda p: max(_poly(_number(p)).c, default=-1),
    "rev": lambda p, n: _poly(_number(p)).mirrored().shifted(n), "recip": _mirror, "subst": _substitute,
    "laurent": _at_infinity,
    "roots_in": lambda p: _moduli(_number(p)).count(-1), "roots_on": lambda p: _moduli(_number(p)).count(0),
    "roots_out": lambda p: _moduli(_number(p)).count(1),
    "real_roots": lambda p, lo, hi: _count_real(_number(p), lo, hi),
    "=": _chain(_equal), "!=": _chain(lambda x, y: not _equal(x, y)), "<": _chain(lambda x, y: _compare(x, y) < 0),
    "<=": _chain(lambda x, y: _compare(x, y) <= 0), ">": _chain(lambda x, y: _compare(x, y) > 0),
    ">=": _chain(lambda x, y: _compare(x, y) >= 0), "loewner": lambda x, y: _is_definite(_plus(x, _minus(y)), 0),
    "psd": lambda x: _is_definite(x, 0), "pd": lambda x: _is_definite(x, 1), "symmetric": _is_symmetric,
    "invertible": lambda x: _table(x).m == _table(x).n and not _singular(_table(x)), "symplectic": _is_symplectic,
    "similar": _is_similar, "cospectral": lambda x, y: _equal(_charpoly(x), _charpoly(y)),
    "coprime": lambda p, q: _are_coprime(_number(p), _number(q)),
    "schur": _is_schur, "observable": _is_observable, "detectable": _is_detectable,
    "pos_circle": lambda d: _sign(*_least_on_circle(_number(d))) > 0,
    "nonneg_circle": lambda d: _sign(*_least_on_circle(_number(d))) >= 0,
}


# ---------------------------------------------------------------------- statements
class _World:
    """Values of the names of one statement on one instance."""

    def __init__(self, statement: Mapping[str, Any], instance: Mapping[str, Any]) -> None:
        self.statement = statement
        self.where = {d[1]: d for d in statement["where"]}
        self.horizon = instance["sizes"].get("horizon", 5)
        self.names: dict[str, Any] = {n: instance["sizes"][n] for n in statement["sizes"]}
        self.memory: dict[tuple, Any] = {}
        self.depth = 0
        self.theta = self._generator(instance.get("field"))
        for name, kind in statement["over"]:
            self.names[name] = self._read(kind, instance["values"][name])

    # ------------------------------------------------------------------ reading
    def _generator(self, field: Any) -> Any:
        """The root of the field's polynomial in its interval, by bisection."""
        if not field:
            return None
        c = [self._rational(x) for x in field[0]][::-1]
        low, high = (self._rational(x) for x in field[1:])
        if low == high:
            return low
        below = mp.polyval(c, low) < 0
        for _ in range(4 * mp.prec):
            middle = (low + high) / 2
            low, high = (middle, high) if (mp.polyval(c, middle) < 0) == below else (low, middle)
        return (low + high) / 2

    @staticmethod
    def _rational(text: Any) -> Any:
        p, _, q = str(text).partition("/")
        return mpf(p) / mpf(q or 1)

    def _scalar(self, data: Any) -> Any:
        if isinstance(data, list):
            return mp.polyval([self._rational(c) for c in data][::-1], self.theta)
        return self._rational(data)

    def _read(self, kind: Any, data: Any) -> Any:
        if kind[0] in ("sequence_of", "signal_of"):
            return {self.index(kind[1], {}) + k: self._read(kind[-1], x) for k, x in enumerate(data)}
        args = [self.index(a, {}) for a in kind[1:]]
        match kind[0]:
            case "integer":
                return int(data)
            case "scalar" | "nonzero" | "positive" | "nonneg":
                return self._scalar(data)
            case "sequence" | "signal":
                return {args[0] + k: self._scalar(x) for k, x in enumerate(data)}
            case "poly" | "monic":
                return Poly({k: self._scalar(x) for k, x in enumerate(data)})
        return Table([[self._scalar(x) for x in r] for r in data], args[-1])

    def typed(self) -> bool:
        """The values have the types of their variables."""
        return all(self._fits(one[0], value, [self.index(a, {}) for a in one[1:]])
                   for name, kind in self.statement["over"]
                   for one, values in [(kind[-1], self.names[name].values()) if kind[0] in ("sequence_of", "signal_of") else (kind, [self.names[name]])]
                   for value in values)

    @staticmethod
    def _fits(kind: str, v: Any, args: list[int]) -> bool:
        match kind:
            case "integer":
                return args[0] <= v <= args[1]
            case "nonzero":
                return not _vanishes(v)
            case "positive":
                return _sign(v) > 0
            case "nonneg":
                return _sign(v) >= 0
            case "monic":
                return _same(v.c.get(args[0], mpf(0)), 1)
            case "symmetric":
                return _is_symmetric(v)
            case "psd" | "pd":
                return _is_definite(v, int(kind == "pd"))
            case "nonsingular":
                return not _singular(v)
            case "diagonal":
                return all(_vanishes(x) for i, r in enumerate(v.rows) for j, x in enumerate(r) if i != j)
        return True

    # ------------------------------------------------------------------ values
    def index(self, tree: Any, local: Mapping[str, Any]) -> int:
        k = self.value(tree, local)
        k = _number(k)
        if isinstance(k, int):
            return k
        if isinstance(k, mpf) and _vanishes(k - mp.nint(k), k):
            return int(mp.nint(k))
        raise NoValueError("an index that is no integer")

    def truth(self, tree: Any, local: Mapping[str, Any]) -> bool:
        found = self.value(tree, local)
        if not isinstance(found, bool):
            raise NoValueError("a term for a formula")
        return found

    def value(self, tree: Any, local: Mapping[str, Any]) -> Any:
        """Value of a term, truth of a formula."""
        if isinstance(tree, int):
            return tree
        op, args = tree[0], tree[1:]
        match op:
            case "sym":
                known = local if args[0] in local else self.names
                return known[args[0]] if args[0] in known else self.defined(args[0], ())
            case "at":
                return self.at(args[0], args[1:], local)
            case "and":
                return all(self.truth(x, local) for x in args)
            case "or":
                return any(self.truth(x, local) for x in args)
            case "not":
                return not self.truth(args[0], local)
            case "=>":
                return not self.truth(args[0], local) or self.truth(args[1], local)
            case "<=>":
                return self.truth(args[0], local) == self.truth(args[1], local)
            case "if":
                return self.value(args[1] if self.truth(args[0], local) else args[2], local)
            case "forall" | "exists":
                found = (self.truth(args[3], inner) for inner in self.indices(args, local))
                return all(found) if op == "forall" else any(found)
            case "always":
                return self.throughout(args, local)
            case "sum" | "prod":
                terms = [self.value(args[3], inner) for inner in self.indices(args, local)]
                return self.fold(_plus if op == "sum" else _times, terms) if terms else int(op == "prod")
            case "+" | "*":
                return self.fold(_plus if op == "+" else _times, [self.value(x, local) for x in args])
            case "defined":
                try:
                    self.value(args[0], local)
                    return True
                except NoValueError:
                    return False
            case "prints":
                return self.printed(self.value(args[0], local), args[1])
            case "mat" | "col":
                m = self.index(args[-3] if op == "mat" else args[1], local)
                n = self.index(args[-2], local) if op == "mat" else 1
                names = args[:2] if op == "mat" else (args[0], "")
                places = [[{**local, names[0]: i, names[1]: j} for j in range(1, _count(n) + 1)]
                          for i in range(1, _count(m) + 1)]
                return Table([[_number(self.value(args[-1], place)) for place in r] for r in places], n)
            case "entry":
                return _entry(_table(self.value(args[0], local)), *(self.index(a, local) for a in args[1:]))
            case "block" | "rows":
                return _stack([[self.value(x, local) for x in r] for r in args])
            case "rat":
                return _PLAIN["rat"](*args)
        try:
            return _PLAIN[op](*(self.value(x, local) for x in args))
        except ZeroDivisionError as error:
            raise NoValueError("division by zero") from error

    @staticmethod
    def fold(f: Callable, terms: list) -> Any:
        out = terms[0]
        for t in terms[1:]:
            out = f(out, t)
        return out

    def indices(self, args: Any, local: Mapping[str, Any]) -> Any:
        for k in range(self.index(args[1], local), self.index(args[2], local) + 1):
            yield {**local, args[0]: k}

    def throughout(self, args: Any, local: Mapping[str, Any]) -> bool:
        """For t = 0 .. horizon, up to the first t without a value."""
        for t in range(self.horizon + 1):
            try:
                if not self.truth(args[1], {**local, args[0]: t}):
                    return False
            except NoValueError:
                if t <= min(1, self.horizon):
                    raise
                return True
        return True

    def printed(self, x: Any, table: Any) -> bool:
        if isinstance(table, str):
            return _rounds(x, table)
        x = _table(x)
        if [len(r) for r in table] != [x.n] * x.m:
            raise NoValueError("a table of another shape")
        return all(_rounds(e, p) for r, s in zip(x.rows, table, strict=True) for e, p in zip(r, s, strict=True))

    def at(self, name: str, args: Any, local: Mapping[str, Any]) -> Any:
        """Value of a function, entry of a sequence, of a matrix or of a column."""
        definition = self.where.get(name) if name not in self.names and name not in local else None
        if definition is not None and (definition[0] == "rec" or definition[2]):
            return self.defined(name, tuple(self.value(a, local) for a in args))
        row = self.value(["sym", name], local)
        where = [self.index(a, local) for a in args]
        if isinstance(row, Table):
            return _entry(row, *where)
        if not isinstance(row, dict) or where[0] not in row:
            raise NoValueError("outside the sequence")
        return row[where[0]]

    def defined(self, name: str, args: tuple) -> Any:
        """Value of a definition."""
        key = (name, args) if all(isinstance(a, int) for a in args) else None
        if key in self.memory:
            return self.memory[key]
        if self.depth > _DEEPEST:
            raise NoValueError("a definition that does not end")
        self.depth += 1
        try:
            found = self._unfolded(self.where[name], args)
        finally:
            self.depth -= 1
        if key:
            self.memory[key] = found
        return found

    def _unfolded(self, definition: Any, args: tuple) -> Any:
        if definition[0] == "let":
            if len(definition[2]) != len(args):
                raise NoValueError("wrong number of arguments")
            return self.value(definition[3], dict(zip(definition[2], args, strict=True)))
        _, _, index, start, initial, step = definition
        (k,) = args
        if not isinstance(k, int) or k < start:
            raise NoValueError("before the start of the recursion")
        return self.value(initial[k - start], {}) if k < start + len(initial) else self.value(step, {index: k - 1})
