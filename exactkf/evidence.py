# SPDX-License-Identifier: MIT
"""Kinds of evidence a claim can ask for.

Each function here returns plain data: which finder is to run, and its hints.
A hint never decides anything; what a finder makes of it is replayed by the
checker.

==================  =========================================================  ==========================
evidence            what it shows                                              best strength
==================  =========================================================  ==========================
`identity`          conclusion is an identity in all variables, per size       proved, proved-sizes
`combination`       conclusion = sum of (left)(hypothesis)(right), per size    proved, proved-sizes
`induction`         base and step of ``always(t, ...)``, for every size         proved, proved-sizes
`generic_index`     the same for coefficients, sums and entries, every size      proved
`positivity`        difference = sum of c q^2 (hypotheses), c >= 0             proved, proved-sizes
`order`             order, invertibility and equations for every size          proved
`arithmetic`        statements about integers of any size                        proved
`evaluation`        a closed statement, or every case of a finite one          proved
`steps`             displayed steps proved; glue in prose; instances           steps
`instances`         exact instances, random and degenerate                     instances
`example`           one instance given by hand, tried before all others        instances
`restated`          the formula says what is printed by classical facts        bounds it: steps
`part`              the formula is less than what is printed                   bounds it: instances
`chosen`            variables of the formula exist, by a classical theorem     else it is steps
==================  =========================================================  ==========================
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from exactkf._errors import BadInput
from exactkf.language import Expr, to_expr

__all__ = [
    "EIGENVALUE", "EIGENVECTOR", "Evidence", "angles", "arithmetic", "at_index", "by_cases", "by_induction", "by_rests", "chosen",
    "cleared", "combination", "evaluation", "example", "existing", "fact", "first", "generic_index", "identity", "in_threes", "induction",
    "instances", "lemma", "multiplied", "null_vector", "order", "part", "positivity", "restated", "shown_first", "spectral", "square", "square_of",
    "steps", "unfolded", "use", "valued", "within",
]


@dataclass(frozen=True)
class Evidence:
    """A finder's name with its hints."""

    kind: str
    hints: Mapping[str, Any] = field(default_factory=dict)


def _ranges(sizes: Mapping[str, Any]) -> dict[str, tuple[int, ...]]:
    return {name: _whole_numbers(name, value) for name, value in sizes.items()}


def _whole_numbers(name: str, value: Any) -> tuple[int, ...]:
    values = (value,) if isinstance(value, int) or not isinstance(value, Iterable) else tuple(value)
    if not values or not all(isinstance(v, int) and not isinstance(v, bool) for v in values):
        raise BadInput(f"argument {name!r} = {value!r} is neither a whole number nor a list of them; write {name}=(1, 2, 3)")
    return values


def identity(*, given_by: Mapping[Expr | str, Any] | None = None, covered_by: str = "", using: Mapping[Expr | str, tuple] | None = None,
             where: Sequence[Any] = (), fact: str = "", **sizes: Iterable[int] | int) -> Evidence:
    """The conclusion is an identity of rational functions for each of the sizes.

    Parameters
    ----------
    given_by : mapping of variable to term
        A parametrisation of the variables that hypotheses tie together; the terms may use
        the other variables. It must reach every instance of the hypotheses, which is what
        the claim named in ``covered_by`` says.
    using : mapping of name to type
        Variables that the parametrisation uses and the statement does not have.
    where : sequence of definitions
        Those that the parametrisation uses and the statement does not have, under names of their own.
    **sizes
        Values of each size (and of each integer variable): ``n=range(1, 7)``.
    """
    aux = {_name(k): tuple(v) for k, v in (using or {}).items()}
    return Evidence("identity", {"sizes": _ranges(sizes), "given_by": _named(given_by), "covered_by": covered_by,
                                 "parameters": aux, "where": tuple(where), "fact": fact})


def combination(terms: Sequence[Any], **sizes: Iterable[int] | int) -> Evidence:
    """Left side minus right side of the conclusion = sum of L * (lhs - rhs of the hypothesis so labelled) * R.

    Each term is ``(L, "label", R)``; a label ending in ``'`` names the transposed hypothesis. For a
    conclusion that is a conjunction or a chain, a list of such lists, one for each equation.
    """
    several = bool(terms) and all(isinstance(t, list) for t in terms)
    lists = [_rows(t) for t in terms] if several else _rows(terms)
    return Evidence("combination", {"sizes": _ranges(sizes), "terms": tuple(lists)})


def _rows(terms: Sequence[tuple[Any, str, Any]]) -> tuple:
    return tuple((to_expr(left).tree, label, to_expr(right).tree) for left, label, right in terms)


def induction(*, also: Sequence[Any] = (), cofactors: Sequence[Sequence[tuple[Any, int, Any]]] = (),
              base: Evidence | Sequence[Evidence] = (), step: Evidence | Sequence[Evidence] = (),
              before: Sequence[Mapping[str, Any]] = (),
              shapes: Mapping[Expr | str, tuple[Sequence[Any], Sequence[Any]]] | None = None, **sizes: Iterable[int] | int) -> Evidence:
    """Base and step for a conclusion ``always(t, ...)`` or ``forall(t, a, b, ...)`` along recursions of the statement.

    Without ``**sizes`` it is for every size (see `exactkf.kernel.recursion`), and the conclusion may be made of
    equations, order and invertibility. With sizes it is for each of them and about equations: the induction
    hypothesis is used in the form lhs - rhs at t (times a cofactor that the finder looks for); an invariant
    quantity has cofactor one.

    Parameters
    ----------
    also : sequence of formulas in t, or of such sequences
        What the induction carries along beside the conclusion; for every size, a list for each conjunct where they differ.
    base, step : `order`, or a sequence of them
        Terms for the leaves of base and step, in the values at t, where the engine does not find them; one for each
        conjunct of the conclusion, or one for all. For every size.
    before : sequence of `first`
        Lemmas, each by an induction of its own, that what comes after them may use. For every size.
    shapes : mapping of recursion to (row sizes, column sizes)
        Blocks of its values, where those of the initial value are not fine enough. For every size.
    cofactors : for each equation, of the conclusion and of ``also``, a list of ``(left, number, right)``
        lhs - rhs at t + 1 = sum of left * (lhs - rhs of the equation so numbered, at t) * right.
    """
    rows = tuple(tuple((to_expr(left).tree, number, to_expr(right).tree) for left, number, right in row) for row in cofactors)
    hints: dict[str, Any] = {"sizes": _ranges(sizes), "cofactors": rows,
                             "also": tuple(tuple(to_expr(e).tree for e in some) if isinstance(some, (list, tuple)) else to_expr(some).tree for some in also)}
    hints |= _base_and_step(base, step)
    if before:
        hints["before"] = tuple(before)
    if shapes:
        hints["shapes"] = {_name(k): [[to_expr(x).tree for x in side] for side in v] for k, v in shapes.items()}
    return Evidence("induction", hints)


def first(says: Expr, *, also: Sequence[Any] = (), base: Evidence | Sequence[Evidence] = (), step: Evidence | Sequence[Evidence] = ()) -> dict[str, Any]:
    """A formula, or ``forall`` of one, to be shown before the conclusion of an `induction`; base, step and also as there."""
    return {"says": to_expr(says).tree, "also": tuple(to_expr(e).tree for e in also), **_base_and_step(base, step)}


def _base_and_step(base: Any, step: Any) -> dict[str, Any]:
    return {key: tuple(e.hints for e in ([given] if isinstance(given, Evidence) else given)) for key, given in (("base", base), ("step", step)) if given}


def generic_index(*lemmas: Mapping[str, Any], supported: Sequence[Expr] = (), closed: Sequence[Expr] = (), whole: Sequence[Expr] = (),
                  uses: Sequence[Mapping[str, Any]] = (), shift: int = 0, triangular: Any = None,
                  in_values: bool | Sequence[int] = False) -> Evidence:
    """Equations about coefficients, sums and entries at a generic index, for every size (see `exactkf.kernel.index_induction`).

    Parameters
    ----------
    lemmas : `lemma`
        Shown first, in this order, each by induction on its index.
    supported : names of recursions X
        The polynomial X[t] has exponents 0 .. t, which is shown before all else.
    closed : names of functions
        Not replaced by their definition except by a `use` of it; matrices are then multiplied as variables are.
    whole : names of functions in z
        Their coefficients are left as they are; as functions of z and 1/z (``in_values``) they are opened.
    uses : sequence of `use`
        Places at which the conclusion uses the lemmas.
    shift : int
        The outermost index of the conclusion is written as a generic index plus this, so that values
        at the shift's distance before it stay as they are and later ones are opened.
    in_values : bool
        The polynomials of the conclusion are read as functions of z and 1/z, with those of ``closed`` as they are,
        and not coefficient by coefficient: so they may be multiplied. A list: those of its equations of these numbers.
    triangular : matrix term L
        For a conclusion det(M) == prod(k, .., d): LM is upper triangular with diagonal d, and L is lower
        triangular with ones on its diagonal.
    """
    hints: dict[str, Any] = {"lemmas": list(lemmas), "supported": [_name(x) for x in supported], "closed": [_name(x) for x in closed],
                             **({"whole": [_name(x) for x in whole]} if whole else {}),
                             "uses": list(uses), "shift": shift,
                             "in values": in_values if isinstance(in_values, bool) else list(in_values)}
    if triangular is not None:
        hints["triangular"] = to_expr(triangular).tree
    return Evidence("generic index", hints)


def lemma(index: Expr, says: Expr, *, start: int = 0, rule: bool = False, bare: bool = False, direct: bool = False, in_values: bool = False,
          closed: Sequence[Expr] = (), uses: Sequence[Mapping[str, Any]] = (), base: Sequence[Mapping[str, Any]] = ()) -> dict[str, Any]:
    """For all index >= start: ``says``, by induction; an equation X[t] = term may be made a rule, which is used by itself.

    ``uses`` are the places of its step, from t to t + 1, in t and the indices that the formula binds
    (``z`` for the exponent in an equation of polynomials); ``base`` are those of its base. In the step of a ``bare`` lemma exponents are of no account;
    a ``direct`` one is shown at t for any t >= start, without induction; in one with ``closed`` these names are closed too.
    """
    return {"index": _name(index), "says": says.tree, "from": start, "rule": rule, "bare": bare, "direct": direct, "in values": in_values, "uses": list(uses),
            **({"closed": [_name(x) for x in closed]} if closed else {}), **({"base": list(base)} if base else {})}


def fact(index: Expr, kind: str, says: Expr, by: Any = None, *, start: int = 0, uses: Sequence[Mapping[str, Any]] = ()) -> dict[str, Any]:
    """A lemma that turns a determinant, an inverse, a characteristic polynomial, coefficients at infinity or a product into terms that can be opened.

    ======================================  ========================================================  ================================
    kind                                    says                                                      by
    ======================================  ========================================================  ================================
    ``det``                                 det(M) == prod(k, lo, hi, d)                              L, with LM triangular
    ``solve``                               inv(M) * v == x, or inv(M) == x
    ``charpoly``                            charpoly(A) == p                                          (j, v_j), v'(z - A) = (p, 0, ..)
    ``laurent``                             forall(k, 0, K, laurent(N / D, k) == x), or always(k, ..)  degree of D
    ``product``                             sum_of(k, 1, p, A[i, k] * B[k, j]) == (A * B)[i, j], for i, j between bounds
    ``cayley``                              (sum_of(k, 0, n, coeff(charpoly(A), k) * (U * A**k * V)) == Zero(p, q)) &
                                            (coeff(charpoly(A), n) == 1)
    ``resolvent``                           charpoly(A) * (T(h) * inv(Identity(n) * Z - A) * g) ==
                                            charpoly(A - g * T(h)) - charpoly(A)
    ======================================  ========================================================  ================================

    See `exactkf.kernel.generic_facts` for why they hold.
    """
    made: dict[str, Any] = {"index": _name(index), "fact": kind, "says": to_expr(says).tree, "from": start, "uses": list(uses)}
    if by is not None:
        made["by"] = [_name(by[0]), to_expr(by[1]).tree] if isinstance(by, tuple) else to_expr(by).tree
    return made


def use(number: int | str | Expr, /, *args: Any, times: Any = None, **places: Any) -> dict[str, Any]:
    """Lemma of this number, counted from 0, at these places: ``use(0, t=t, k=k - 1)``; or a definition: ``use(c, t + 1)``,
    ``use(phi, t, k, z=m)`` for the coefficient of z^m, ``use(alpha, t, row=i)`` for an entry of a column; or the hypothesis
    of this label, in a proof that divides by nothing but what a hypothesis says is not zero; one that says so for all k says it at these places.

    With ``times`` this multiple of its first equation is taken off; without, its equations are solved for an atom.
    """
    if isinstance(number, Expr):
        place = {"place": {name: to_expr(x).tree for name, x in places.items()}} if places else {}
        return {"definition": _name(number), "at": [to_expr(x).tree for x in args], **place}
    more = {} if times is None else {"times": to_expr(times).tree}
    return {"given" if isinstance(number, str) else "lemma": number, "at": {name: to_expr(x).tree for name, x in places.items()}, **more}


def arithmetic(*hints: Sequence[Any], member: int | None = None) -> Evidence:
    """A statement about numbers and integers of any size follows from the rules of arithmetic (see `exactkf.kernel.arithmetic`).

    The statement is denied, and every case of that has to contradict itself. What exists is named like its index (``i``, and ``i1``,
    ``i2`` .. after that), and the hints may use these names. They are taken in their order, each as soon as all its names are there:
    `by_rests`, `at_index`, `by_cases`, `by_induction`, `shown_first`, `unfolded`, `existing`, `valued`, `cleared`, `angles`, `multiplied`,
    `square_of`, `in_threes`.
    With ``member`` it is for that member of a conjunction, counted from 0.
    """
    return Evidence("arithmetic", {"proof": tuple(hints), **({} if member is None else {"member": member})})


def by_rests(x: Any, by: int, name: Expr, hints: Sequence[Sequence[Any]] = ()) -> tuple:
    """x = by * name + r for r = 0, .., by - 1, with hints for each r."""
    return ("divide", to_expr(x).tree, by, _name(name), tuple(map(tuple, hints)))


def at_index(index: Expr, term: Any) -> tuple:
    """What is known for all ``index`` is known at this term."""
    return ("at", _name(index), to_expr(term).tree)


def by_cases(formula: Any, holds: Sequence[Any] = (), fails: Sequence[Any] = ()) -> tuple:
    """A formula holds or does not, with hints for either case."""
    return ("cut", to_expr(formula).tree, (tuple(holds), tuple(fails)))


def shown_first(formula: Any, hints: Sequence[Any] = ()) -> tuple:
    """A lemma, with the hints for its proof."""
    return ("lemma", to_expr(formula).tree, ((), tuple(hints)))


def multiplied(term: Any) -> tuple:
    """Equations may be multiplied by this term."""
    return ("multiply", to_expr(term).tree)


def cleared() -> tuple:
    """Quotients are taken out of all that is known, in cases of the sign of what they divide by (see `exactkf.finders.clearing`)."""
    return ("clear",)


def square_of(term: Any) -> tuple:
    """The square of this term is not negative."""
    return ("square", to_expr(term).tree)


def in_threes() -> tuple:
    """Facts are multiplied three at a time, not two."""
    return ("degree", 3)


def by_induction(name: Expr, start: Any, formula: Any, base: Sequence[Any] = (), step: Sequence[Any] = ()) -> tuple:
    """The formula is shown for all ``name`` >= start, with hints for base and step."""
    return ("induct", _name(name), to_expr(start).tree, to_expr(formula).tree, (tuple(base), tuple(step), ()))


def unfolded(name: Expr, at: Any) -> tuple:
    """The value of a recursion at a term, by its definition."""
    return ("unfold", _name(name), to_expr(at).tree)


def existing(name: Expr, at: Any) -> tuple:
    """Whether the value of a recursion at a term exists, by its definition."""
    return ("exist", _name(name), to_expr(at).tree)


def valued(label: str = "") -> tuple:
    """What the conclusion, or the hypothesis of this label, divides by is not zero, where it is evaluated (see `exactkf.kernel.values`)."""
    return ("valued", label)


def angles(kind: str, *terms: Any) -> tuple:
    """About cos(pi a/n), or a quotient.

    ===============  ===========  ===============================================
    kind             terms        says
    ===============  ===========  ===============================================
    ``product``      a, b, n      2 cos(pi a/n) cos(pi b/n) as a sum of two cosines
    ``cosines``      a, b, n      when cos(pi a/n) and cos(pi b/n) are equal
    ``right``        n            cos(pi n/(2n)) = 0
    ``quotient``     x, y         (x/y) y = x
    ``acute``        a, n         the sign of cos(pi a/n), for abs(a) <= n
    ``root``         x            the square root of x
    ===============  ===========  ===============================================
    """
    return (kind, *(to_expr(x).tree for x in terms))


def positivity(terms: Sequence[tuple[Any, Any, Sequence[str]]], **sizes: Iterable[int] | int) -> Evidence:
    """For a conclusion lhs >= rhs (or >): lhs - rhs = sum of c * q^2 * product of hypotheses.

    Each term is ``(c, q, labels)``: a rational c >= 0, a scalar q, labels of hypotheses of the
    form ``x > y`` or ``x >= y`` (their difference enters). For ``>`` one term with q = 1, c > 0
    and only strict hypotheses must be there.
    """
    rows = tuple((to_expr(c).tree, to_expr(q).tree, tuple(labels)) for c, q, labels in terms)
    return Evidence("positivity", {"sizes": _ranges(sizes), "terms": rows})


def order(*sums: Sequence[Any], roots: Mapping[Expr | str, Any] | None = None, lemmas: Sequence[Expr] = (),
          factors: Sequence[tuple[Any, Sequence[Any]]] = (), inside: Sequence[Mapping[str, Any]] = (),
          away_from_zero: Sequence[Expr] = ()) -> Evidence:
    """A conclusion about matrices of every size made of equations, order (psd, pd, loewner), invertibility, rank, stability and similarity.

    For each leaf of the lemmas and the conclusion, in reading order (see `exactkf.kernel.order`), a list of terms.
    Where the list is empty the engine tries the matrix itself, those of the hypotheses, and inverses of nonsingular variables.

    ================================  ==========================================================================================
    leaf                              terms
    ================================  ==========================================================================================
    psd, pd, loewner, >=, >           semidefinite by their form; they add up to the matrix under the hypotheses
    invertible(X)                     its inverse; or none, or semidefinite ones, as for the equation v = 0 under Xv = 0
    rank(X) == its rows or columns    none, or semidefinite ones, in the same way
    rank(X) == r                      B, C, L, N with X = BC, LB = I, CN = I of size r
    rank(X) <= r                      B, C with X = BC, and r columns of B
    equation                          none; or semidefinite ones whose sum K has Kx = 0 or x'Kx = 0, so that each vanishes at x;
                                      or inverses that the statement does not write down
    schur(M), observable(C, A)        see `within`: as the equation v = 0 for eigenvectors
    similar(A, B), cospectral(A, B)   a nonsingular T with AT = TB, and its inverse
    ================================  ==========================================================================================

    Parameters
    ----------
    roots : mapping of name to term
        Names for symmetric square roots of semidefinite terms that the lists use.
    lemmas : sequence of formulas
        Shown first, and assumed for what follows.
    factors : sequence of (matrix, its factors)
        For determinants: that of the matrix is the product of theirs.
    inside : sequence of `within`
        What belongs to the proof of one leaf.
    away_from_zero : scalars of the statement
        It is shown where they are not zero, and holds everywhere by continuity (see `exactkf.kernel.continuity`).
    """
    inner = [[w["number"], w["vector"], w["lemmas"]] for w in inside if w["vector"] or w["lemmas"]]
    stable: list[list] = []
    passed = 0
    for w in sorted(inside, key=lambda w: w["number"]):
        stable.extend([w["number"] + passed + n, help_] for n, help_ in w["help"])
        passed += len(w["lemmas"])
    return Evidence("order", {"sums": tuple(tuple(to_expr(t).tree for t in terms) for terms in sums),
                              "roots": tuple(_named(roots).items()), "lemmas": tuple(f.tree for f in lemmas),
                              "factors": tuple((to_expr(x).tree, tuple(to_expr(f).tree for f in parts)) for x, parts in factors),
                              "inside": inner, "stable": stable, "away": tuple(_name(x) for x in away_from_zero)})


def null_vector(block: int = 0) -> Expr:
    """The vector v of `within`, or a block of it."""
    return Expr(("sym", f"v.{block}"))


#: real and imaginary part of the eigenvector of `within`, and of its eigenvalue
EIGENVECTOR = (null_vector(), Expr(("sym", "w.0")))
EIGENVALUE = (Expr(("sym", "eigen.re")), Expr(("sym", "eigen.im")))


def within(number: int, *lemmas: Expr, vector: str = "", stein: Any = None, unique: tuple[Any, Any] | None = None, kept: tuple[Any, Any, Any] | None = None,
           pencil: tuple[Any, ...] | None = None, inertia: tuple[Any, Any, Any, Any, Any] | None = None,
           solutions: Mapping[Expr | str, tuple[Any, Any]] | None = None, on: int | None = None) -> dict[str, Any]:
    """Lemmas and other help for one leaf of an `order`, counted from 0 without lemmas that belong to leaves.

    Parameters
    ----------
    lemmas : formulas
        Shown before the leaf and assumed for it alone, each one leaf. Their terms stand before those of the leaf.
    vector : "right" or "left"
        Instead of invertible(X), rank(X) == number of columns, schur(X), observable(C, X) it is shown that a vector v with Xv = 0, an
        eigenvector v of X outside the open unit disc, or one with Cv = 0, is zero; X' instead of X for "left". See `null_vector`, `EIGENVECTOR`, `EIGENVALUE`.
    stein : term
        A stable matrix M, as a hypothesis or a lemma says: the terms of an order then add up to X - MXM'.
    unique : pair of terms
        Stable matrices M and N: for an equation D = 0 it is shown that D - MDN = 0.
    kept : triple of terms
        C, A and B with an observable pair (C, A), as a hypothesis says: for an equation X = 0 it is shown that CX = 0 and AX = XB.
    pencil : two, three or four terms
        M and N of a detectable pencil, as a hypothesis says: for an equation X = 0 it is shown that MX = 0; or with a stable B that MX = NXB; or with
        numbers a and b, a^2 + b^2 >= 1 by a hypothesis, for X with two columns that MX[[a, b], [-b, a]] = NX.
    inertia : five terms
        X, V, P, Y, Q: for W >= 0 it is shown that diag(W, Q) = X' diag(V, P) X for a semidefinite V and a symmetric P, and the terms add up to P - Y'QY.
    solutions : mapping of name to (M, Q)
        Names for the solutions of X = MXM' + Q, for stable M and semidefinite Q, that the terms use.
    on : int, optional
        The lemma, counted from 0, that ``stein``, ``unique``, ``kept``, ``pencil``, ``solutions`` are for; else they are for the leaf.
    """
    help_: dict[str, Any] = {}
    if stein is not None:
        help_["stein"] = to_expr(stein).tree
    if unique:
        help_["unique"] = [to_expr(m).tree for m in unique]
    if kept:
        help_["kept"] = [to_expr(m).tree for m in kept]
    for key, terms in (("pencil", pencil), ("inertia", inertia)):
        if terms:
            help_[key] = [to_expr(m).tree for m in terms]
    if solutions:
        help_["solutions"] = [[_name(x), to_expr(m).tree, to_expr(q).tree] for x, (m, q) in solutions.items()]
    return {"number": number, "vector": vector, "lemmas": [f.tree for f in lemmas], "help": [[len(lemmas) if on is None else on, help_]] if help_ else []}


def evaluation(**ranges: Iterable[int] | int) -> Evidence:
    """A statement without free variables, or with integer variables of which every value is evaluated."""
    return Evidence("evaluation", {"sizes": _ranges(ranges)})


def instances(count: int = 24, *, made_by: Mapping[Expr | str, Any] | None = None, using: Mapping[Expr | str, tuple] | None = None,
              horizon: int = 5, **sizes: Iterable[int] | int) -> Evidence:
    """Exact instances: random by construction, and degenerate ones.

    Parameters
    ----------
    count : int
        How many instances the certificate carries; the search looks at many more.
    made_by : mapping of variable to term
        Variables that are computed from others so that the hypotheses hold; ``(k, term in k)`` for a sequence.
    using : mapping of name to type
        Auxiliary variables that ``made_by`` uses and the statement does not have.
    horizon : int
        Last t tried for ``always(t, ...)``.
    **sizes
        Values of each size to draw from: ``n=(1, 2, 3)``.
    """
    for name, number in (("count", count), ("horizon", horizon)):
        if isinstance(number, bool) or not isinstance(number, int) or number < 1:
            raise BadInput(f"argument {name!r} = {number!r} is no number of {'instances' if name == 'count' else 'steps'}; give a whole number, 1 or more")
    aux = {_name(k): tuple(v) for k, v in (using or {}).items()}
    return Evidence("instances", {"count": count, "sizes": _ranges(sizes), "made_by": _named(made_by), "using": aux, "horizon": horizon})


def example(values: Mapping[Expr | str, Any] | None = None, /, *, horizon: int = 5, **more: Any) -> Evidence:
    """One instance by hand: sizes as ints, scalars as int or 'p/q', sequences and columns as lists, matrices as lists of rows."""
    return Evidence("example", {"values": {**_plain(values or {}), **more}, "horizon": horizon})


def steps(*ids: str, facts: Sequence[str] = (), prose: str = "") -> Evidence:
    """The paper's proof: claims of its displayed steps, classical facts it leans on, the glue in a sentence or two."""
    return Evidence("steps", {"ids": tuple(ids), "facts": tuple(facts), "prose": prose})


def restated(*facts: str) -> Evidence:
    """Beside other evidence: the formula says what is printed only by the classical facts named, so that a proof of it counts as `steps`.

    Raises
    ------
    BadInput
        If no fact is named.
    """
    _sentences("restated", facts)
    return Evidence("restated", {"facts": facts})


def chosen(*choices: tuple[str, Any, tuple[Any, ...]]) -> Evidence:
    """Beside other evidence: variables of the formula exist by a theorem, so that what is said of all of them is said of some; see `exactkf.kernel.existence`.

    Without a certificate that they do, a proof of the formula counts as `steps`. Each choice is `spectral` or `square`.
    """
    return Evidence("chosen", {"choices": tuple((theorem, to_expr(term).tree, tuple(map(_name, names))) for theorem, term, names in choices)})


def spectral(term: Any, turn: Expr, diagonal: Expr) -> tuple[str, Any, tuple[Any, ...]]:
    """A symmetric term is U D T(U), with T(U) U = I and a diagonal D."""
    return "spectral", term, (turn, diagonal)


def square(term: Any, root: Expr) -> tuple[str, Any, tuple[Any, ...]]:
    """A positive definite term is L T(L), with a nonsingular L."""
    return "square", term, (root,)


def part(covers: str) -> Evidence:
    """Beside other evidence: the formula covers only that part of what is printed (one state, some samples), so that a proof of it counts as `instances`.

    Raises
    ------
    BadInput
        If it is not said which part.
    """
    _sentences("part", (covers,))
    return Evidence("part", {"covers": covers})


def _sentences(kind: str, texts: Sequence[str]) -> None:
    if not texts or not all(isinstance(x, str) and x.strip() for x in texts):
        raise BadInput(f"argument of {kind} = {texts!r} is no text; say it in words")


def _name(key: Expr | str) -> str:
    return key.tree[1] if isinstance(key, Expr) else key


def _named(mapping: Mapping[Expr | str, Any] | None) -> dict[str, Any]:
    return {_name(k): ("each", _name(v[0]), to_expr(v[1]).tree) if isinstance(v, tuple) else to_expr(v).tree for k, v in (mapping or {}).items()}


def _plain(mapping: Mapping[Expr | str, Any]) -> dict[str, Any]:
    return {_name(k): v for k, v in mapping.items()}
