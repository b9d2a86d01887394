# SPDX-License-Identifier: MIT
"""Order and invertibility of matrices of every size, by a few classical facts.

`exactkf.kernel.definite` reads a term and says whether its form alone makes it positive
(semi)definite under the hypotheses. The facts are named and said in `FACTS`. Two more that
are often named need no rule: Schur complements are congruences with a block triangular matrix,
and P >= Q > 0 gives inv(Q) >= inv(P), as inv(Q) - inv(P) = KDK' + KD inv(Q) DK', where
K = inv(P) and D = P - Q.

A conclusion is taken apart by `leaves`: conjunctions, implications,
equivalences and inequations become equations, statements of order and of invertibility, each
with what may be assumed for it. A certificate of kind ``order`` proves each:
an equation by multiples of the assumptions (`exactkf.kernel.words`), an order
by a sum of terms that are semidefinite by their form plus such multiples, an
invertibility by an inverse. An equation may use null vectors for a hypothesis Kx = 0
with terms that add up to K. Lemmas are shown first and then used. An inverse
that the evidence brings in must be one of a matrix that is nonsingular by its
form.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from typing import Any

from exactkf.kernel.definite import apart, are_transposed, definiteness, exists, nonsingular, plain, sign
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.reader import Reader, relations, residual_blocks
from exactkf.kernel.stable import is_detectable, is_observable, is_stable, no_eigenvector, none_annihilated
from exactkf.kernel.wellformed import check_formula
from exactkf.kernel.words import Blocks, Relation, add, multiply, size_tree

__all__ = ["FACTS", "Leaf", "goal_of", "leaves", "register_inverses"]

#: the classical facts that the checker takes for granted, on real matrices of every size; those on stable ones are in `exactkf.kernel.stable`
FACTS = {
    "hypothesis": "a matrix is semidefinite, or definite, if its type or a hypothesis says so; semidefinite and invertible is definite",
    "identity": "the identity is positive definite, and a square zero semidefinite",
    "number": "a nonnegative multiple of a semidefinite matrix is semidefinite; sums and products of nonnegative numbers are nonnegative, and so are squares",
    "sum": "a sum of semidefinite matrices is semidefinite, and definite if one of them is",
    "congruence": "X'PX is semidefinite if P is, and definite if P is and X is nonsingular or has full column rank",
    "block diagonal": "a block diagonal matrix is semidefinite, or definite, if its blocks are",
    "inverse": "the inverse of an invertible semidefinite matrix is definite",
    "trace": "a semidefinite matrix X is at most trace(X) I, and its trace is not negative",
    "inertia": "W is semidefinite if diag(W, Q) = X' diag(V, P) X with semidefinite V and symmetric P, and P is at least Y'QY: by the numbers of negative "
               "eigenvalues W has at most as many as P less those of Q, and P at most as many as Q",
    "square root": "a semidefinite matrix is the square of one",
    "null vectors": "a null vector of a sum of semidefinite matrices is one of each of them, and one of X'PX is one of PX; x'Px = 0 gives Px = 0",
    "nonsingular": "a definite matrix, a transpose, an inverse and a product of nonsingular matrices are nonsingular",
    "right inverse": "a square matrix X with XY = I is nonsingular",
    "null space": "a matrix has full column rank, and a square one is nonsingular, if Xv = 0 only for v = 0",
    "similarity": "AT = TB with a nonsingular T makes A and B similar, and then they have one characteristic polynomial",
    "rank": "the rank of BC is the number of columns of B at most, and is it if B has a left and C a right inverse",
    "determinant": "the determinant of a product of square matrices is the product of theirs, that of a transpose the same, "
                   "of a block triangular matrix that of its diagonal blocks",
    "Stein equation": "X = MXM' + Q with a stable M has one solution, semidefinite, or definite, if Q is; D = MDN with stable M and N has the solution 0 alone",
    "continuity": "equations and inequalities that are not strict, of terms that are continuous where they have a value, hold in the limit",
    "invariant subspace": "a space other than zero that A keeps has an eigenvector of A, real or complex: "
                          "CX = 0 and AX = XB give X = 0 if C annihilates none",
    "detectable pencil": "full column rank of sM - tN for |s| >= |t|, not both zero: MX = 0 gives X = 0, so does MX = NXB with a stable B, "
                         "and MXB = NX with a turn B and a factor of one or more",
    "eigenvalues": "M is stable if it has no eigenvector for an eigenvalue outside the open unit disc",
}

#: operations that need no value of what stands in them, such as a sum over an empty range
_LAZY = ("forall", "exists", "always", "sum", "prod", "mat", "col", "defined")


# ---------------------------------------------------------------------- taking a conclusion apart
def leaves(statement: Mapping[str, Any], lemmas: Any = (), inside: Any = ()) -> Iterator[tuple[dict, Any]]:
    """Statements whose conclusions together are the lemmas and the conclusion, each with its own hypotheses.

    Parameters
    ----------
    lemmas : sequence of formulas
    inside : sequence of [number, vector, lemmas]
        Lemmas that belong to one leaf, counted from 0 without those of other leaves. If ``vector`` is "right" or "left", the leaf
        (stability, observability, invertibility or full rank) is first replaced by: Xv = 0, or an eigenvector v of X outside the open disc, is
        zero, where X is the matrix or its transpose.
    """
    inner = {number: (vector, formulas) for number, vector, formulas in inside}
    for number, (case, formula) in enumerate(_outer_leaves(statement, lemmas)):
        vector, formulas = inner.get(number, ("", ()))
        lemma, said = case.get("lemma", False), [*case.get("said", ()), formula]
        if vector:
            case, formula = _through_vector(case, formula, vector == "left")
        for part in formulas:
            check_formula(case, part)
            yield from _leaves({**case, "lemma": True, "said": []}, part)
            case = {**_assume({**case, "lemma": True}, f"inner lemma {len(case['given'])}", part), "lemma": lemma}
        yield {**case, "said": said}, formula  # the inverses of a lemma must exist, those of what a vector has replaced too


def _outer_leaves(statement: Mapping[str, Any], lemmas: Any) -> Iterator[tuple[dict, Any]]:
    own = [statement["says"]]
    for case in _cases({**statement, "given": [], "own": own, "alike": {}}, [list(g) for g in statement["given"]]):
        for lemma in lemmas:
            check_formula(case, lemma)
            yield from _leaves({**case, "lemma": True}, lemma)
            case = {**_assume({**case, "lemma": True}, f"lemma {len(case['given'])}", lemma), "lemma": False}
        yield from _leaves(case, statement["says"])


def _cases(statement: dict, rest: list) -> Iterator[dict]:
    """One statement for each choice among the hypotheses that are alternatives."""
    for k, (label, formula, kind) in enumerate(rest):
        if formula[0] == "or":
            for n, one in enumerate(formula[1:]):
                yield from _cases(statement, [*rest[:k], [f"{label}.{n}", one, kind], *rest[k + 1:]])
            return
    for label, formula, kind in rest:
        statement = {**_assume({**statement, "lemma": kind == "lemma"}, label, formula), "lemma": False}
    yield statement


def _assume(statement: dict, label: str, formula: Any) -> dict:
    """A formula of the statement that is true has a value, and so have its inverses; those of a lemma need a reason."""
    if formula[0] == "and":
        for n, part in enumerate(formula[1:]):
            statement = _assume(statement, f"{label}.{n}", part)
        return statement
    return _evaluated({**statement, "given": [*statement["given"], [label, formula, "standing"]]}, formula)


def _evaluated(statement: dict, formula: Any) -> dict:
    return statement if statement.get("lemma") else {**statement, "own": [*statement["own"], formula]}


def _leaves(statement: dict, formula: Any) -> Iterator[tuple[dict, Any]]:
    label = f"assumed {len(statement['given'])}"
    if formula[0] == "and":
        for part in formula[1:]:
            statement = _evaluated(statement, part)  # where the parts before are true
            yield from _leaves(statement, part)
            if part[0] in ("psd", "pd", "invertible", "schur", "observable"):  # what is proved may be used for what follows
                statement = _assume(statement, f"shown {len(statement['given'])}", part)
    elif formula[0] == "=>":
        yield from _leaves(_evaluated(_assume(statement, label, formula[1]), formula[2]), formula[2])
    elif formula[0] == "<=>":
        yield from _leaves(_assume(statement, label, formula[1]), formula[2])
        yield from _leaves(_assume(statement, label, formula[2]), formula[1])
    elif formula[0] == "!=" and (differ := [f[1:] for _, f, _ in statement["given"] if f[0] == "!="]):
        # a = b would make equal what a hypothesis, the last of this form, says to differ; in a lemma a and b must have values
        contrary = {**_assume(statement, label, ["=", *formula[1:]]), "said": [*statement.get("said", ()), formula]}
        yield from _leaves(contrary, ["=", *differ[-1]])
    else:
        yield statement, formula


class Leaf:
    """One leaf with what its proof brings in: polynomials to be made of the assumptions.

    Parameters
    ----------
    statement, formula
        From `leaves`.
    terms : sequence of trees
        Semidefinite summands for an order, the inverse for an invertibility; for an equation semidefinite
        summands of the matrix K of a hypothesis Kx = 0, or inverses to be used in the multiples.
    roots : sequence of (name, tree)
        Symmetric matrices whose squares are the given semidefinite terms.
    null : str
        Label of that hypothesis, or the tree of a matrix x: then x'(sum of the terms)x = 0 is to be shown.
    vector : bool
        An invertibility or a full rank is shown by: Xv = 0 only for v = 0. The terms are then those of an equation.
    factors : sequence of (tree, trees)
        A matrix and factors of it: its determinant is the product of theirs.
    solutions : sequence of (name, M, Q)
        Matrices X = MXM' + Q for a stable M and semidefinite Q, see `exactkf.kernel.stable`.
    stein : tree
        A stable matrix M: instead of X the terms add up to X - MXM', for an order.
    unique : pair of trees
        Stable matrices M and N: instead of D = 0 it is shown that D - MDN = 0, for an equation.
    kept : triple of trees
        An observable pair C, A and a matrix B: instead of X = 0 it is shown that CX = 0 and AX = XB, for an equation.
    inertia : five trees
        X, V, P, Y, Q for an order, see `FACTS`; the terms then add up to P - Y'QY.
    pencil : two, three or four trees
        A detectable pencil M, N: instead of X = 0 it is shown that MX = 0, or MX = NXB for a stable B, or for numbers a, b that MX[[a, b], [-b, a]] = NX.

    Attributes
    ----------
    goals : list of (polynomial, rows, columns)
        To be made of the polynomials that `assumed` gives.
    known : list of (term, inverse)
        Inverses of the statement.

    Raises
    ------
    Unknown
        With what is not shown.
    """

    def __init__(self, statement: Mapping[str, Any], formula: Any, terms: Any, roots: Any = (), null: Any = "", vector: bool = False,
                 factors: Any = (), solutions: Any = (), stein: Any = None, unique: Any = (), kept: Any = (), pencil: Any = (), inertia: Any = ()) -> None:
        said = [formula, *statement.get("said", ())]
        if vector:
            statement, formula = _through_vector(statement, formula)
        self.reader = reader = Reader(statement)
        op, found, wanted, self.first = formula[0], [], 0, 0
        self.shown: dict[str, Relation] = {}
        for tree in statement["own"]:
            register_inverses(reader, tree)
        reader.granted = list(reader.inverses), list(reader.quotients), set(reader.units)
        self.known = list(reader.inverses)  # those of the statement: an instance without them is outside it
        if statement.get("lemma") and not all(exists(reader, x, self.known) for f in said for x in f[1:]):
            raise Unknown("a lemma with an inverse that need not exist")
        if op == "invertible":
            found = [reader.read(formula[1])]
            if not isinstance(found[0], Blocks) or reader.total(found[0].rows) != reader.total(found[0].cols):
                raise Unknown("invertibility of scalars or of matrices that are not square")
        elif op == "=" and len(formula) == 3 and isinstance(formula[1], list) and formula[1][0] == "rank":
            found = self._factored_rank(formula, terms)
        elif op == "<=" and len(formula) == 3 and isinstance(formula[1], list) and formula[1][0] == "rank":
            found = self._rank_at_most(formula, terms)
        elif op in ("=", "symmetric", "symplectic"):
            found = residual_blocks(reader, formula)
        elif op in ("similar", "cospectral"):
            found = [reader.read(x) for x in formula[1:]]
        elif op == "schur":
            self._stable(formula[1])
        else:
            goal, wanted = goal_of(reader, formula)
            found = [goal]
        relations(reader)
        self.extra: dict[str, Relation] = {}
        for name, tree in roots:
            self._root(name, tree)
        for name, m, q in solutions:
            self._solution(name, m, q)
        for tree in terms:
            if not exists(reader, tree, self.known):
                raise Unknown("an inverse that need not exist")
        if unique:
            found = self._contracted(found, unique, op == "=")
        if kept:
            found = self._kept(found, kept, op == "=")
        if pencil:
            found = self._in_pencil(found, pencil, op == "=")
        if stein is not None:
            found = self._contracted(found, [stein, ["T", stein]], bool(wanted))
        if inertia:
            found = self._of_inertia(found, inertia, wanted == 1 and stein is None)
        if op == "invertible":
            if len(terms) != 1:
                raise Unknown("an inverse is needed")
            found = [reader._plus(reader._times(found[0], reader.read(terms[0])), Blocks.unit(found[0].rows), -1)]
        elif op in ("similar", "cospectral"):
            found = self._similar(found, terms)
        elif wanted:
            levels = [definiteness(reader, tree) for tree in terms]
            if 0 in levels or wanted > max(levels, default=1):
                raise Unknown("a term is not semidefinite by its form, or none is definite")
            for tree in terms:
                term = reader.read(tree)
                found[-1] = reader._plus(found[-1], term, -1)
        elif terms and null:
            found = [self._null(null, terms) if isinstance(null, str) else self._null_of_form(null, terms), *found]
            self.first = len(found[0].cells())
        else:
            for tree in terms:
                reader.read(tree)
        if factors:
            found = [*self._factored(factors), *found]
        self.goals = [cell for b in found for cell in b.cells()]
        self.always = {**relations(reader), **self.extra}

    def _similar(self, sides: list, terms: Any) -> list[Blocks]:
        """AT = TB with a nonsingular T; its inverse is given, or T is nonsingular by its form."""
        reader = self.reader
        if not all(isinstance(x, Blocks) for x in sides):
            raise Unknown("similarity of numbers")
        if len(terms) not in (1, 2) or (len(terms) == 1 and not nonsingular(reader, terms[0])):
            raise Unknown("a nonsingular T with AT = TB is needed")
        t = reader.read(terms[0])
        if not isinstance(t, Blocks) or reader.total(t.rows) != reader.total(t.cols):
            raise Unknown("a square T with AT = TB is needed")
        if any(reader.total(s) != reader.total(t.rows) for x in sides for s in (x.rows, x.cols)):
            raise Unknown("matrices of another size than T with AT = TB")
        found = [reader._plus(reader._times(sides[0], t), reader._times(t, sides[1]), -1)]
        return [*found, *(reader._plus(reader._times(t, reader.read(s)), Blocks.unit(t.rows), -1) for s in terms[1:])]

    def _factored_rank(self, formula: Any, terms: Any) -> list[Blocks]:
        """X = BC with LB = I and CN = I: the rank is the number of columns of B, as LXN = I of that size."""
        reader = self.reader
        if len(terms) != 4:
            raise Unknown("a rank is shown by X = BC with a left inverse of B and a right inverse of C")
        x, b, c, left, right = (reader.read(tree) for tree in (formula[1][1], *terms))
        if not all(isinstance(m, Blocks) for m in (x, b, c, left, right)):
            raise Unknown("factors that are no matrices")
        rows, cols, rank = reader.total(x.rows), reader.total(x.cols), reader.size(formula[2])
        sides = [(rows, rank), (rank, cols), (rank, rows), (cols, rank)]  # a 1 x 1 matrix is no number here
        if [(reader.total(m.rows), reader.total(m.cols)) for m in (b, c, left, right)] != sides:
            raise Unknown("the first factor has not as many columns, or the second not as many rows, as the rank, or another size does not fit")
        return [reader._plus(x, reader._times(b, c), -1), reader._plus(reader._times(left, b), Blocks.unit(b.cols), -1),
                reader._plus(reader._times(c, right), Blocks.unit(c.rows), -1)]

    def _rank_at_most(self, formula: Any, terms: Any) -> list[Blocks]:
        """X = BC: the rank is the number of columns of B at most."""
        reader = self.reader
        if len(terms) != 2:
            raise Unknown("a bound of a rank is shown by X = BC")
        x, b, c = (reader.read(tree) for tree in (formula[1][1], *terms))
        if not all(isinstance(m, Blocks) for m in (x, b, c)):
            raise Unknown("factors that are no matrices")
        rows, cols, rank = reader.total(x.rows), reader.total(x.cols), reader.size(formula[2])
        if [(reader.total(m.rows), reader.total(m.cols)) for m in (b, c)] != [(rows, rank), (rank, cols)]:  # a 1 x 1 matrix is no number here
            raise Unknown("the first factor has not as many columns, or the second not as many rows, as the bound, or another size does not fit")
        return [reader._plus(x, reader._times(b, c), -1)]

    def _factored(self, factors: Any) -> list[Blocks]:
        """Matrices less the products of their factors; determinants are then products."""
        reader, out = self.reader, []
        for n, (tree, parts) in enumerate(factors):
            if not all(exists(reader, x, self.known) for x in (tree, *parts)):
                raise Unknown("an inverse that need not exist")
            whole, product = reader.read(tree), reader.read(parts[0])
            right = reader.det(product)
            for part in parts[1:]:
                factor = reader.read(part)
                if reader.total(factor.rows) != reader.total(product.rows):  # a 1 x 1 factor of a larger matrix is a number
                    raise Unknown("factors of different sizes")
                product, right = reader._times(product, factor), multiply(right, reader.det(factor))
            out.append(reader._plus(whole, product, -1))
            self.shown[f"det {n}"] = Relation(add(reader.det(whole), right, -1), None, None)
        self.first += sum(len(b.cells()) for b in out)
        return out

    def _root(self, name: str, tree: Any) -> None:
        reader = self.reader
        taken = {*reader.kinds, *reader.lets, *reader.sizes, *reader.statement["sizes"]}
        fits = name.isidentifier() and name not in taken
        if not fits or not definiteness(reader, tree) or not exists(reader, tree, self.known):
            raise Unknown("a root that need not exist")
        square = reader.read(tree)
        reader.kinds[name] = ["psd"]
        reader.alike = dict(reader.alike)  # other readers do not have this letter
        reader._letter(name, square.rows[0], square.rows[0], True)
        self.extra[f"root {name}"] = Relation(add({((), (name, name)): 1}, square.grid[0][0], -1), square.rows[0], square.rows[0])

    def _stable(self, tree: Any) -> Any:
        if not exists(self.reader, tree, self.known) or not is_stable(self.reader, tree):
            raise Unknown("a matrix that no hypothesis says to be stable")
        return self.reader.read(tree)

    def _solution(self, name: str, m: Any, q: Any) -> None:
        """A letter for the solution X of X = MXM' + Q."""
        reader = self.reader
        taken = {*reader.kinds, *reader.lets, *reader.sizes, *reader.statement["sizes"]}
        level = definiteness(reader, q)
        step, free = self._stable(m), reader.read(q)
        if not name.isidentifier() or name in taken or not level or not exists(reader, q, self.known):
            raise Unknown("a solution that need not exist")
        if not isinstance(free, Blocks) or free.rows != step.rows or len(free.rows) != 1:
            raise Unknown("a solution of another size than the stable matrix, or in blocks")
        reader.kinds[name] = ["pd" if level == 2 else "psd"]
        reader.alike = dict(reader.alike)
        reader._letter(name, free.rows[0], free.rows[0], True)
        x = reader.read(["sym", name])
        rest = reader._plus(reader._plus(x, reader._times(reader._times(step, x), reader.transpose(step)), -1), free, -1)
        self.extra[f"solution {name}"] = Relation(rest.grid[0][0], free.rows[0], free.rows[0])

    def _contracted(self, found: list, sides: Any, fits: bool) -> list:
        """X - MXN in the place of X, for stable M and N."""
        if len(sides) != 2 or not fits:
            raise Unknown("two stable matrices are for an equation, one for an order")
        left, right = (self._stable(m) for m in sides)
        return [self.reader._plus(x, self.reader._times(self.reader._times(left, x), right), -1) for x in found]

    def _kept(self, found: list, by: Any, fits: bool) -> list:
        """CX and AX - XB in the place of X, for an observable pair (C, A)."""
        reader, (c, a, _) = self.reader, by
        if not fits or not is_observable(reader, c, a) or not all(exists(reader, x, self.known) for x in by):
            raise Unknown("a pair that no hypothesis says to be observable, or no equation")
        rows, inner, outer = (reader.read(x) for x in by)
        if not all(isinstance(x, Blocks) for x in (rows, inner, outer)):
            raise Unknown("numbers where matrices are needed")
        if any(reader.total(x.rows) != reader.total(inner.rows) or reader.total(x.cols) != reader.total(outer.rows) for x in found):
            raise Unknown("matrices of other sizes")  # a 1 x 1 matrix is no number here
        if reader.total(outer.rows) != reader.total(outer.cols):
            raise Unknown("what acts from the right is not square")
        times = reader._times
        return [y for x in found for y in (times(rows, x), reader._plus(times(inner, x), times(x, outer), -1))]

    def _of_inertia(self, found: list, by: Any, fits: bool) -> list:
        """diag(W, Q) - X' diag(V, P) X and P - Y'QY in the place of W."""
        reader, times = self.reader, self.reader._times
        if not fits or len(by) != 5 or not all(exists(reader, tree, self.known) for tree in by):
            raise Unknown("five matrices are for a semidefinite one")
        x, v, p, y, q = (reader.read(tree) for tree in by)
        if not all(isinstance(m, Blocks) for m in (x, v, p, y, q)) or not all(len(m.rows) == len(m.cols) == 1 for m in (v, p, q, *found)):
            raise Unknown("matrices in one block are needed")
        if not definiteness(reader, by[1]) or reader.transpose(p).grid != p.grid:
            raise Unknown("the first matrix is not semidefinite by its form, or the second not symmetric")
        inner, outer = (self._diagonal(*pair) for pair in ((v, p), (found[0], q)))
        return [reader._plus(outer, times(times(reader.transpose(x), inner), x), -1), reader._plus(p, times(times(reader.transpose(y), q), y), -1)]

    @staticmethod
    def _diagonal(first: Blocks, second: Blocks) -> Blocks:
        rows, cols = (first.rows[0], second.rows[0]), (first.cols[0], second.cols[0])
        return Blocks(rows, cols, [[first.grid[0][0], {}], [{}, second.grid[0][0]]])

    def _in_pencil(self, found: list, by: Any, fits: bool) -> list:
        """MX, or MX - NXB with a stable B, or MXB - NX with a turn B that does not shrink, in the place of X, for a detectable pencil (M, N)."""
        reader, times = self.reader, self.reader._times
        if not fits or len(by) not in (2, 3, 4) or not is_detectable(reader, *by[:2]) or not all(exists(reader, x, self.known) for x in by):
            raise Unknown("a pencil that no hypothesis says to be detectable, or no equation")
        first, second = (reader.read(x) for x in by[:2])
        if not all(isinstance(x, Blocks) for x in (first, second, *found)) or any(reader.total(x.rows) != reader.total(first.cols) for x in found):
            raise Unknown("matrices of other sizes")  # a 1 x 1 matrix is no number here
        if len(by) == 2:
            return [times(first, x) for x in found]
        if len(by) == 3:
            last = self._stable(by[2])
            if not isinstance(last, Blocks) or any(reader.total(x.cols) != reader.total(last.rows) for x in found):
                raise Unknown("a stable matrix of another size")
            return [reader._plus(times(first, x), times(times(second, x), last), -1) for x in found]
        re, im = by[2:]
        if any(isinstance(reader.read(x), Blocks) for x in (re, im)) or not sign(reader, ["-", ["+", ["*", re, re], ["*", im, im]], 1]):
            raise Unknown("numbers of which no hypothesis says that they are not inside the unit circle")
        turn = reader.read(["block", *([["*", x, ["I", 1]] for x in row] for row in ((re, im), (["neg", im], re)))])
        if any(reader.total(x.cols) != reader.total(turn.rows) for x in found):
            raise Unknown("real and imaginary part of a vector are needed")
        return [reader._plus(times(times(first, x), turn), times(second, x), -1) for x in found]

    def _null(self, label: str, terms: Any) -> Blocks:
        """K less the sum of the terms, for the hypothesis Kx = 0; each term is then known to vanish at x."""
        reader = self.reader
        equation: Any = next((f for name, f, _ in reader.statement["given"] if name == label), ["", 0, 0])
        if equation[0] != "=" or len(equation) != 3 or not _is_zero(equation[2]) or equation[1][0] != "*":
            raise Unknown("no hypothesis Kx = 0")
        *factors, x = equation[1][1:]
        rest = reader.read(factors[0] if len(factors) == 1 else ["*", *factors])
        for tree in terms:
            rest = reader._plus(rest, reader.read(tree), -1)
        if not isinstance(rest, Blocks):
            raise Unknown("no matrix K in the hypothesis Kx = 0")
        self._vanish(x, terms)
        return rest

    def _null_of_form(self, x: Any, terms: Any) -> Blocks:
        """x'(sum of the terms)x, which is to vanish; then each term vanishes at x."""
        reader = self.reader
        if not exists(reader, x, self.known):
            raise Unknown("an inverse that need not exist")
        value = reader.read(x)
        form = reader.read(terms[0])
        for tree in terms[1:]:
            form = reader._plus(form, reader.read(tree), 1)
        self._vanish(x, terms)
        return reader._times(reader._times(reader.transpose(value), form), value)

    def _vanish(self, x: Any, terms: Any) -> None:
        """Semidefinite terms, and their halves, vanish at x."""
        reader = self.reader
        for n, tree in enumerate(terms):
            if not definiteness(reader, tree):
                raise Unknown("a term is not semidefinite by its form")
            for m, part in enumerate(_halves(reader, tree)):
                zero = reader._times(reader.read(part), reader.read(x))
                for k, (p, rows, cols) in enumerate(zero.cells()):
                    self.shown[f"null {n}/{m}/{k}"] = Relation(p, rows, cols)
                    self.shown[f"null {n}/{m}/{k}'"] = Relation(reader.transpose_poly(p), cols, rows)

    def assumed(self, goal: int) -> dict[str, Relation]:
        """Named polynomials that vanish, for one of the goals; what null vectors give is not there for their own premise."""
        return {**self.always, **self.shown} if goal >= self.first > 0 else self.always


def _through_vector(statement: Mapping[str, Any], formula: Any, left: bool = False) -> tuple[dict[str, Any], Any]:
    """Xv = 0 as a hypothesis and v = 0 as the conclusion, for a square X or one of full column rank; X' for full row rank.

    Stability is said in the same way through eigenvectors; ``left`` takes the transpose of a square X.
    """
    if formula[0] == "schur":
        return no_eigenvector(statement, ["T", formula[1]] if left else formula[1])
    if formula[0] == "observable" and not left:
        return none_annihilated(statement, *formula[1:])
    reader = Reader(statement)
    rank = formula[0] == "=" and len(formula) == 3 and isinstance(formula[1], list) and formula[1][0] == "rank"
    if not rank and formula[0] != "invertible":
        raise Unknown("a vector is for an invertibility or a full rank")
    tree = formula[1][1] if rank else formula[1]
    tree = ["T", tree] if left and not rank else tree
    x = reader.read(tree)
    if not isinstance(x, Blocks):
        raise Unknown("the rank of a scalar")
    wanted = reader.size(formula[2]) if rank else reader.total(x.rows)
    if rank and wanted != reader.total(x.cols):
        tree, x = ["T", tree], reader.transpose(x)
    if wanted != reader.total(x.cols):
        raise Unknown("the rank is not the number of rows or of columns, or the matrix is not square")
    names = [f"v.{k}" for k in range(len(x.cols))]
    parts = [["sym", name] for name in names]
    v = parts[0] if len(parts) == 1 else ["block", *([p] for p in parts)]
    over = [*statement["over"], *([name, ["matrix", size_tree(s), 1]] for name, s in zip(names, x.cols, strict=True))]
    given = [*statement["given"], ["null vector", ["=", ["*", tree, v], 0], "standing"]]
    return {**statement, "over": over, "given": given}, ["=", v, 0]


def _is_zero(tree: Any) -> bool:
    return tree == 0 or (isinstance(tree, (list, tuple)) and tree[0] == "O")


def _halves(reader: Reader, tree: Any) -> Iterator[Any]:
    """A semidefinite term P, and for a congruence X'QX also QX; for X'X also X."""
    yield tree
    factors = list(tree[1:]) if isinstance(tree, (list, tuple)) and tree[0] == "*" else []
    while factors and isinstance(factors[0], int):
        if factors.pop(0) == 0:
            return
    outer: list = []
    while len(factors) > 1 and are_transposed(reader, factors[0], factors[-1]):
        outer.insert(0, factors.pop())
        factors.pop(0)
        if factors and not definiteness(reader, factors[0] if len(factors) == 1 else ["*", *factors]):
            return  # the whole is semidefinite by hypothesis, its middle need not be
        rest = [*factors, *outer]
        yield rest[0] if len(rest) == 1 else ["*", *rest]


def register_inverses(reader: Reader, tree: Any, evaluated: bool = True) -> None:
    """Let the reader meet every inverse that a tree of the statement writes down and that must exist for it to have a value.

    What comes after the first part of a conjunction need not be evaluated; there only inverses that exist by their form are met.
    """
    if plain(reader, tree) or tree[0] in _LAZY:
        return
    if tree[0] in ("=>", "or", "if"):  # what comes after the first part need not have a value
        register_inverses(reader, tree[1], evaluated)
        return
    if tree[0] in ("inv", "/", "^"):
        with suppress(Unknown, Undefined, TypeError):
            if evaluated or exists(apart(reader), tree, list(reader.inverses)):
                reader.read(tree)
    if tree[0] == "sym" and tree[1] not in reader.kinds and tree[1] in reader.lets and not reader.lets[tree[1]][2]:
        register_inverses(reader, reader.lets[tree[1]][3], evaluated)
    for n, part in enumerate(tree[1:]):
        register_inverses(reader, part, evaluated and not (n and tree[0] == "and"))


def goal_of(reader: Reader, formula: Any) -> tuple[Blocks, int]:
    """Matrix that is to be semidefinite (1) or definite (2)."""
    op = formula[0]
    if op in ("psd", "pd"):
        found = reader.read(formula[1])
    elif op == "loewner":
        found = reader._plus(reader.read(formula[1]), reader.read(formula[2]), -1)
    elif op in ("<=", "<", ">=", ">") and len(formula) == 3:
        big, small = (formula[1], formula[2]) if op in (">=", ">") else (formula[2], formula[1])
        found = reader._plus(reader.read(big), reader.read(small), -1)
    else:
        raise Unknown(f"{op!r} is no statement of order")
    if not isinstance(found, Blocks):
        found = Blocks(((("", 1),),), ((("", 1),),), [[found]])
    if found.rows != found.cols:
        raise Unknown("the order of matrices that are not square")
    return found, 2 if op in ("pd", "<", ">") else 1
