# SPDX-License-Identifier: MIT
"""Determinants, inverses, characteristic polynomials, coefficients at infinity and products of generic size.

Each fact turns such a term into one that can be opened; a certificate says why:

=============  ==========================================================================================================
fact           follows from
=============  ==========================================================================================================
``det``        det M = d_1 ... d_n, if LM is upper triangular with the diagonal d_1, .., d_n and L is lower triangular
               with ones on its diagonal, for then det L = 1
``solve``      inv(M) v = x, or inv(M) = x, if M is square and Mx = v, or Mx = 1; that the inverse exists is up to the
               statement, in which it stands
``charpoly``   charpoly(A) = p for n > 0, if A has ones right above the diagonal and zeros above these, and there are polynomials
               v_1, .., v_n with v_n = 1 and v'(z - A) = (p, 0, .., 0)
``laurent``    N/D = x_0 + x_1/z + .. + x_K/z^K + .. at infinity, if D is monic of degree d, N of degree d at most, and
               D_d x_k + .. + D_(d-k) x_0 = N_(d-k) for k = 0, .., K: these equations have one solution, as D_d = 1;
               the same for all k >= 0
``product``    A_i1 B_1j + .. + A_ip B_pj = (AB)_ij, if A has p columns and B as many rows, at places that AB has
``cayley``     c_0 U V + c_1 U A V + .. + c_n U A^n V = 0 and c_n = 1 for c_k = coeff(charpoly(A), k) and A of size n: the theorem of Cayley
               and Hamilton, and charpoly(A) is monic
``resolvent``  charpoly(A) h'(z - A)^(-1) g = charpoly(A - gh') - charpoly(A), for A, g, h without z: det(z - A + gh') is
               det(z - A) times det(1 + (z - A)^(-1) gh'), which is 1 + h'(z - A)^(-1) g; z - A has an inverse, as charpoly(A) is monic
=============  ==========================================================================================================

For ``charpoly`` let B be z - A with its last row replaced by (p, 0, .., 0): that adds multiples of rows above to the last
row, so that det B = det(z - A). Move the first column of B behind the last one: the sign is (-1)^(n-1), and what stands on the
diagonal of the lower triangular matrix is -1, .., -1, p.

Main definitions
----------------
`FACTS`
    How each is shown.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from exactkf.kernel.generic import Terms
from exactkf.kernel.numbers import Rejected
from exactkf.kernel.region import Form, Region, plus
from exactkf.kernel.symbolic import Symbolic

__all__ = ["FACTS", "determinant", "unit_triangular"]

_ONE: Form = {"": 1}
_ROW, _COLUMN = {"row": 1}, {"column": 1}
_PLACE: dict[str, Form] = {"row": _ROW, "column": _COLUMN}


def _minus(form: Form) -> Form:
    return plus({}, form, -1)


def _entry(terms: Terms, matrix: Any, env: Mapping[str, Form]) -> Symbolic:
    return terms.entry(matrix, terms.region.reduce(_ROW), terms.region.reduce(_COLUMN), env)


def _order(proof: Any, matrix: Any, env: Mapping[str, Form], region: Region, name: str) -> Form:
    """Number of rows of a square matrix."""
    terms = Terms(proof.statement, region)
    if not terms.is_matrix(matrix):
        raise Rejected(f"{name}: no matrix")
    rows, cols = terms.shape(matrix, env)
    if region.reduce(plus(rows, cols, -1)):
        raise Rejected(f"{name}: the matrix is not square")
    return rows


def _square(region: Region, rows: Form) -> Region:
    return region.and_(plus(_ROW, _ONE, -1), plus(rows, _ROW, -1), plus(_COLUMN, _ONE, -1), plus(rows, _COLUMN, -1))


def _without_inverses(proof: Any, tree: Any, name: str) -> None:
    """What the evidence brings in exists on every instance on which the fact has a value: nothing else says that an inverse in it does."""
    if Terms(proof.statement, Region.of()).inverts(tree):
        raise Rejected(f"{name}: an inverse in the evidence, which need not exist")


def _triangles(proof: Any, matrix: Any, env: Mapping[str, Form], region: Region, name: str) -> list[Region]:
    """Places on, above and below the diagonal of a square matrix."""
    square = _square(region, _order(proof, matrix, env, region, name))
    gap = plus(_COLUMN, _ROW, -1)
    return [square.and_(gap, _minus(gap)), square.and_(plus(gap, _ONE, -1)), square.and_(plus(_minus(gap), _ONE, -1))]


def unit_triangular(proof: Any, matrix: Any, env: Mapping[str, Form], region: Region, uses: Any, name: str) -> None:
    """Lower triangular with ones on the diagonal, hence of determinant one."""
    on, above, _ = _triangles(proof, matrix, env, region, name)
    names = {**env, **_PLACE}
    proof.close(on, lambda t: [_entry(t, matrix, env) - t.number(1)], uses, names, f"{name}: diagonal")
    proof.close(above, lambda t: [_entry(t, matrix, env)], uses, names, f"{name}: lower triangular")


def determinant(proof: Any, says: Any, triangular: Any, env: Mapping[str, Form], region: Region, uses: Any, name: str) -> None:
    """det M = product of d_k: LM is upper triangular with diagonal d, L is unit lower triangular."""
    _, k, low, high, body = says[2]
    matrix = says[1][1]
    _without_inverses(proof, triangular, name)
    terms = Terms(proof.statement, region)
    rows = _order(proof, matrix, env, region, name)
    first, last = terms.index(low, env), terms.index(high, env)
    if region.reduce(plus(plus(rows, last, -1), plus(first, _ONE, -1))):
        raise Rejected(f"{name}: as many factors as the matrix has rows are needed")
    if region.reduce(plus(rows, _order(proof, triangular, env, region, name), -1)):
        raise Rejected(f"{name}: L and M are of different sizes")
    unit_triangular(proof, triangular, env, region, uses, f"{name}, L")
    product = ["*", triangular, matrix]
    on, _, below = _triangles(proof, product, env, region, name)
    names = {**env, **_PLACE}

    def diagonal(t: Terms) -> list[Symbolic]:
        return [_entry(t, product, env) - t.value(body, {**env, k: t.region.reduce(plus(plus(first, _ROW), _ONE, -1))})]

    proof.close(on, diagonal, uses, names, f"{name}: diagonal of LM")
    proof.close(below, lambda t: [_entry(t, product, env)], uses, names, f"{name}: LM is upper triangular")


def _det(proof: Any, lemma: Mapping[str, Any], env: dict[str, Form], region: Region, name: str) -> None:
    says = lemma["says"]
    if says[0] != "=" or len(says) != 3 or says[1][0] != "det" or says[2][0] != "prod" or says[2][1] in env:
        raise Rejected(f"{name}: the fact is det(M) == prod(k, .., d)")
    determinant(proof, says, lemma["by"], env, region, lemma.get("uses", ()), name)


def _solve(proof: Any, lemma: Mapping[str, Any], env: dict[str, Form], region: Region, name: str) -> None:
    says = lemma["says"]
    left = says[1]
    factors = list(left[1:]) if left[0] == "*" else [left]
    if says[0] != "=" or len(says) != 3 or factors[0][0] != "inv":
        raise Rejected(f"{name}: the fact is inv(M) == x or inv(M)*v == x")
    matrix, rest = factors[0][1], factors[1:]
    rows = _order(proof, matrix, env, region, name)
    terms = Terms(proof.statement, region)
    if any(region.reduce(plus(x, y, -1)) for x, y in zip(terms.shape(left, env), terms.shape(says[2], env), strict=True)):
        raise Rejected(f"{name}: matrices of different sizes")
    if not rest and not terms.is_matrix(matrix[1] if matrix[0] == "T" else matrix):
        raise Rejected(f"{name}: no matrix")
    right: Any = ["*", *rest] if len(rest) > 1 else rest[0] if rest else None
    square = _square(region, rows)
    if right is None:  # the identity of the same size
        def goal(t: Terms) -> list[Symbolic]:
            place = int(t.region.zero(plus(_ROW, _COLUMN, -1)))
            return [_entry(t, ["*", matrix, says[2]], env) - t.number(place)]
    else:
        height, width = terms.shape(right, env)
        if region.reduce(plus(height, rows, -1)):
            raise Rejected(f"{name}: v has not as many rows as M")
        square = region.and_(plus(_ROW, _ONE, -1), plus(rows, _ROW, -1), plus(_COLUMN, _ONE, -1), plus(width, _COLUMN, -1))

        def goal(t: Terms) -> list[Symbolic]:
            return [_entry(t, ["*", matrix, says[2]], env) - _entry(t, right, env)]
    proof.close(square, goal, lemma.get("uses", ()), {**env, **_PLACE}, name)


def _charpoly(proof: Any, lemma: Mapping[str, Any], env: dict[str, Form], region: Region, name: str) -> None:
    says = lemma["says"]
    if says[0] != "=" or len(says) != 3 or says[1][0] != "charpoly":
        raise Rejected(f"{name}: the fact is charpoly(A) == p")
    matrix, p, (index, row) = says[1][1], says[2], lemma["by"]
    if proof.is_bound(index, env):
        raise Rejected(f"{name}: index {index!r} bound twice")
    _without_inverses(proof, row, name)
    rows, uses, names = _order(proof, matrix, env, region, name), lemma.get("uses", ()), {**env, **_PLACE, "z": {"z": 1}}
    if not region.and_(_minus(rows)).empty:
        raise Rejected(f"{name}: the matrix may have no rows")
    square, gap = _square(region, rows), plus(_COLUMN, _ROW, -1)
    right = square.and_(plus(gap, _ONE, -1), plus(_ONE, gap, -1))
    proof.close(right, lambda t: [_entry(t, matrix, env) - t.number(1)], uses, names, f"{name}: right above the diagonal")
    proof.close(square.and_(plus(gap, {"": 2}, -1)), lambda t: [_entry(t, matrix, env)], uses, names, f"{name}: above")

    def at(t: Terms, place: Form, m: Form) -> Symbolic:
        return t.coefficient(row, t.region.reduce(m), {**env, index: t.region.reduce(place)})

    def last(t: Terms) -> list[Symbolic]:
        return [at(t, rows, {"z": 1}) - t.number(int(t.region.zero({"z": 1})))]

    def product(t: Terms) -> list[Symbolic]:
        column = t.region.reduce(_COLUMN)
        out = at(t, column, {"z": 1, "": -1})
        out = out - t.total(_ONE, rows, lambda u, k: at(u, k, {"z": 1}) * u.entry(matrix, u.region.reduce(k), u.region.reduce(_COLUMN), env))
        return [out - t.coefficient(p, t.region.reduce({"z": 1}), env) if t.region.zero(plus(column, _ONE, -1)) else out]

    proof.close(region, last, uses, names, f"{name}: last polynomial")
    proof.close(region.and_(plus(_COLUMN, _ONE, -1), plus(rows, _COLUMN, -1)), product, uses, names, f"{name}: product")


def _laurent(proof: Any, lemma: Mapping[str, Any], env: dict[str, Form], region: Region, name: str) -> None:
    says, env, region = _for_all(proof, lemma["says"], env, region, name, 1)
    if not (says[0] == "always" or says[0] == "forall" and says[2] == 0) or says[-1][0] != "=" or len(says[-1]) != 3:
        raise Rejected(f"{name}: the fact is laurent(N/D, k) == x for k = 0, .., K, or for all k")
    k, (_, left, x) = says[1], says[-1]
    if left[0] != "laurent" or left[1][0] != "/" or left[2] != ["sym", k] or proof.is_bound(k, env):
        raise Rejected(f"{name}: the fact is laurent(N/D, k) == x for k = 0, .., K, or for all k")
    _, above, below = left[1]
    if k in _mentioned([above, below]):
        raise Rejected(f"{name}: N and D have nothing to do with k")
    terms, uses = Terms(proof.statement, region), lemma.get("uses", ())
    degree, names = terms.index(lemma["by"], env), {**env, "z": {"z": 1}}

    def top(t: Terms) -> list[Symbolic]:
        d = t.region.reduce(degree)
        return [t.coefficient(below, d, env) - t.number(1)]

    def beyond(t: Terms) -> list[Symbolic]:
        return [t.coefficient(q, t.region.reduce({"z": 1}), env) for q in (above, below)]

    def equation(t: Terms) -> list[Symbolic]:
        here = t.region.reduce({k: 1})

        def term(u: Terms, j: Form) -> Symbolic:
            return u.coefficient(below, u.region.reduce(plus(degree, j, -1)), env) * u.value(x, {**env, k: u.region.reduce(plus(here, j, -1))})

        return [t.total({}, here, term) - t.coefficient(above, t.region.reduce(plus(degree, here, -1)), env)]

    proof.close(region, top, uses, names, f"{name}: D is monic")
    proof.close(region.and_(plus(plus({"z": 1}, degree, -1), _ONE, -1)), beyond, uses, names, f"{name}: degrees")
    least = [plus(terms.index(says[3], env), {k: 1}, -1)] if says[0] == "forall" else []
    proof.close(region.and_({k: 1}, *least), equation, uses, {**env, k: {k: 1}}, f"{name}: equations")


def _for_all(proof: Any, says: Any, env: dict[str, Form], region: Region, name: str, inner: int) -> tuple[Any, dict[str, Form], Region]:
    """What is said for all indices between bounds, these indices and their region; so many of the inner quantifiers are left."""
    bound, left = dict(env), says
    depth = -inner
    while left[0] in ("forall", "always"):
        left, depth = left[-1], depth + 1
    for _ in range(depth):
        if proof.is_bound(says[1], bound):
            raise Rejected(f"{name}: index {says[1]!r} bound twice")
        index: Form = {says[1]: 1}
        terms = Terms(proof.statement, region)
        ends = [plus(index, terms.index(says[2], bound), -1), plus(terms.index(says[3], bound), index, -1)] if says[0] == "forall" else [index]
        region, bound, says = region.and_(*ends), {**bound, says[1]: index}, says[-1]
    return says, bound, region


def _product(proof: Any, lemma: Mapping[str, Any], env: dict[str, Form], region: Region, name: str) -> None:
    """What a product of matrices is: it needs no proof, but for the sum to be that of all products of entries, at places that there are."""
    says, bound, region = _for_all(proof, lemma["says"], env, region, name, 0)
    left, right = says[1], says[2]
    if says[0] != "=" or len(says) != 3 or left[0] != "sum" or right[0] != "entry" or len(right) != 4 or right[1][0] != "*" or len(right[1]) != 3:
        raise Rejected(f"{name}: the fact is sum(k, 1, p, A[i, k]*B[k, j]) == (A*B)[i, j]")
    _, k, low, high, body = left
    (_, a, b), i, j = right[1:]
    if body != ["*", ["entry", a, i, ["sym", k]], ["entry", b, ["sym", k], j]] or k in _mentioned([a, b, i, j]) or proof.is_bound(k, bound):
        raise Rejected(f"{name}: the fact is sum(k, 1, p, A[i, k]*B[k, j]) == (A*B)[i, j]")
    terms = Terms(proof.statement, region)
    (rows, width), (height, cols) = terms.shape(a, bound), terms.shape(b, bound)
    if low != 1 or region.reduce(plus(terms.index(high, bound), width, -1)) or region.reduce(plus(width, height, -1)):
        raise Rejected(f"{name}: the sum is not over all columns of A, or B has another number of rows")
    for place, last in ((terms.index(i, bound), rows), (terms.index(j, bound), cols)):
        if not region.empty and not all(region.decide(x) is True for x in (plus(place, _ONE, -1), plus(last, place, -1))):
            raise Rejected(f"{name}: perhaps AB has no entry there")


def _cayley(proof: Any, lemma: Mapping[str, Any], env: dict[str, Form], region: Region, name: str) -> None:
    """A theorem: what is looked at is that it says no more."""
    match lemma["says"]:
        case ["and", ["=", ["sum", k, low, high, ["*", ["coeff", ["charpoly", matrix], index], *rest]], ["O", *_] as zero],
              ["=", ["coeff", ["charpoly", same], last], one]] if rest:
            factors = rest[0][1:] if len(rest) == 1 and isinstance(rest[0], list) and rest[0][0] == "*" else rest
        case _:
            raise Rejected(f"{name}: the fact is sum(k, 0, n, coeff(charpoly(A), k)*(U*A^k*V)) == O, and coeff(charpoly(A), n) == 1")
    others = [x for x in factors if x != ["^", matrix, ["sym", k]]]
    if (type(low), low, type(one), one, index, same, high) != (int, 0, int, 1, ["sym", k], matrix, last) or len(others) + 1 != len(factors):
        raise Rejected(f"{name}: not the theorem of Cayley and Hamilton")
    if proof.is_bound(k, env) or k in _mentioned([matrix, last, others, zero]):
        raise Rejected(f"{name}: index {k!r} bound twice")
    rows, terms = _order(proof, matrix, env, region, name), Terms(proof.statement, region)
    if region.reduce(plus(rows, terms.index(last, env), -1)) or any(terms.has_z(x) or not terms.is_matrix(x) for x in (matrix, *others)):
        raise Rejected(f"{name}: a matrix with z, a number, or another size")
    for x, y in zip(terms.shape(["*", *factors] if others else matrix, {**env, k: {}}), terms.shape(zero, env), strict=True):
        if region.reduce(plus(x, y, -1)):
            raise Rejected(f"{name}: the zero is of another size")


def _resolvent(proof: Any, lemma: Mapping[str, Any], env: dict[str, Form], region: Region, name: str) -> None:
    """A theorem: what is looked at is that it says no more."""
    fault = Rejected(f"{name}: the fact is charpoly(A)*(T(h)*inv(Identity(n)*Z - A)*g) == charpoly(A - g*T(h)) - charpoly(A)")
    match lemma["says"]:
        case ["=", ["*", ["charpoly", matrix], ["*", _, ["inv", ["-", ["*", ["I", *_] as one, ["z"]], _]], _]],
              ["-", ["charpoly", ["-", _, ["*", g, ["T", h]]]], _]]:
            pass
        case _:
            raise fault
    if lemma["says"] != ["=", ["*", ["charpoly", matrix], ["*", ["T", h], ["inv", ["-", ["*", one, ["z"]], matrix]], g]],
                         ["-", ["charpoly", ["-", matrix, ["*", g, ["T", h]]]], ["charpoly", matrix]]]:
        raise fault
    rows, terms = _order(proof, matrix, env, region, name), Terms(proof.statement, region)
    if any(terms.has_z(x) or not terms.is_matrix(x) for x in (matrix, g, h)):
        raise Rejected(f"{name}: a matrix with z, or a number")
    for x, size in ((one, (rows, rows)), (g, (rows, _ONE)), (h, (rows, _ONE))):
        if any(region.reduce(plus(a, b, -1)) for a, b in zip(terms.shape(x, env), size, strict=True)):
            raise Rejected(f"{name}: sizes do not fit")


def _mentioned(tree: Any) -> set[str]:
    if not isinstance(tree, list):
        return {tree} if isinstance(tree, str) else set()
    return set().union(*map(_mentioned, tree)) if tree else set()


#: name of a fact -> how it is shown for every index in the region
FACTS: dict[str, Callable[[Any, Mapping[str, Any], dict[str, Form], Region, str], None]] = {
    "det": _det, "solve": _solve, "charpoly": _charpoly, "laurent": _laurent, "product": _product, "cayley": _cayley,
    "resolvent": _resolvent,
}
