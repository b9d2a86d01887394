# SPDX-License-Identifier: MIT
"""Instances that satisfy equations, by solving them.

Random matrices hardly ever satisfy X Z X = X or a Riccati equation. Here the
equations among the hypotheses become polynomials in the entries of the
variables, at given sizes: an inverse is one more matrix V with X V = I, a
semidefinite term one more matrix S with term = S. Then, again and again,

- what is linear is solved, over the rationals;
- an equation that is a product is satisfied by one of its factors, one in a
  single entry by a rational root;
- else a variable is drawn as its type has it, or one entry is guessed.

A guess may be wrong; the caller tries again. Choosing the solution of a
quadratic equation first and solving for another letter, orthogonal matrices,
projections, nilpotent matrices, generalised inverses and symplectic blocks
all come out of this. Nothing here decides anything: types and hypotheses of
what is found are checked again.

Main definitions
----------------
`Solver`
    Values of the variables of one statement.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from random import Random
from typing import Any

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from flint.utils.flint_exceptions import DomainError

from exactkf.kernel.linear import Matrix, symplectic_form
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown, rational, rationals

__all__ = ["Solver"]

Draw = Callable[[str, list[int]], Any]  # kind, its arguments -> a value

_MATRICES = ("matrix", "symmetric", "psd", "pd", "nonsingular", "diagonal")
_SCALARS = ("scalar", "nonzero", "positive", "nonneg")
_LAST = {"nonsingular": 2, "nonzero": 2, "psd": 3, "pd": 3, "positive": 3, "nonneg": 3, "symmetric": 1, "diagonal": 1}
_BINDERS = ("sum", "prod", "forall", "exists", "always", "mat", "col", "at")
_MOST_ENTRIES = 120
_MOST_TERMS = 800
_STEPS = 60


@dataclass
class _Letter:
    """A variable, or a matrix brought in for an inverse or an inequality; place (i, j) holds indeterminate ``at[i, j]``."""

    name: str
    kind: str
    args: list[int]
    at: dict[tuple[int, int], int]
    after: int  # letters with a small number are solved for, those with a large one are drawn


class Solver:
    """Values of the variables of a statement that satisfy its equations.

    Parameters
    ----------
    statement : dict
        JSON of the statement. A premise of its conclusion counts as a hypothesis in every second draw.
    """

    def __init__(self, statement: Mapping[str, Any]) -> None:
        self.statement = statement
        self.systems: dict[tuple, _System | None] = {}
        given = [formula for _, formula, _ in statement["given"]]
        says = statement["says"]
        premises = list(says[1:2]) if says[0] == "=>" else list(says[1:3]) if says[0] == "<=>" else []
        self.choices = [given, *([*given, premise] for premise in premises)]

    @property
    def useful(self) -> bool:
        """Whether there is an equation or inequality to be satisfied."""
        kinds = {kind[0] for _, kind in self.statement["over"]}
        return kinds <= {*_MATRICES, *_SCALARS} and any(_restricts(f) for choice in self.choices for f in choice)

    def draw(self, sizes: Mapping[str, int], draw: Draw, random: Random) -> dict[str, Any] | None:
        """Values of all variables, or None if a guess was wrong.

        Parameters
        ----------
        sizes : mapping of name to int
        draw : callable
            ``draw(kind, args)`` gives a value of a type.
        random : Random
        """
        number = random.randrange(len(self.choices)) if len(self.choices) > 1 else 0
        formulas, ways = [], []
        for formula in self.choices[number]:
            while formula[0] == "or":
                ways.append(random.randrange(1, len(formula)))
                formula = formula[ways[-1]]
            formulas.append(formula)
        key = (tuple(sorted(sizes.items())), number, tuple(ways))
        if key not in self.systems:
            try:
                self.systems[key] = _System(self.statement, sizes, formulas)
            except (Undefined, Unknown, DomainError, ArithmeticError, TypeError, ValueError, AttributeError, KeyError, RecursionError):
                self.systems[key] = None  # an operation on entries that are no polynomials
        system = self.systems[key]
        return system.solve(draw, random) if system else None


def _restricts(formula: Any) -> bool:
    if formula[0] in ("and", "or"):
        return any(_restricts(part) for part in formula[1:])
    return formula[0] in ("=", "symmetric", "symplectic", "psd", "pd", "loewner", ">", ">=", "<", "<=")


class _System:
    """The equations at given sizes, as polynomials in the entries."""

    def __init__(self, statement: Mapping[str, Any], sizes: Mapping[str, int], formulas: Sequence[Any]) -> None:
        self.statement, self.sizes, self.formulas = statement, sizes, formulas
        with rationals(fmpq):
            self._build(_MOST_ENTRIES)
            self._build(self.count)  # the ring has as many indeterminates as there turned out to be

    # ------------------------------------------------------------------ the equations
    def _build(self, size: int) -> None:
        self.ring = fmpq_mpoly_ctx.get([f"x{k}" for k in range(max(size, 1))], Ordering.degrevlex)
        self.gens, self.count = self.ring.gens(), 0
        self.letters: list[_Letter] = []
        self.equations: list[fmpq_mpoly] = []
        where = [[*d[:3], self._hoist(d[3])] if d[0] == "let" and not d[2] else d for d in self.statement["where"]]
        self.world = World({"where": where}, {**self.sizes, "horizon": 0})
        drawn = {f[1][1]: "nonsingular" for f in self.formulas if f[0] == "invertible" and f[1][0] == "sym"}
        for name, kind in self.statement["over"]:
            args = [self.world.integer(a, {}) for a in kind[1:]]
            nonsingular = kind[0] == "matrix" and name in drawn and args[0] == args[1]
            self._letter(name, "nonsingular" if nonsingular else kind[0], args[:1] if nonsingular else args)
        for formula in self.formulas:
            self._read(formula)

    def _letter(self, name: str, kind: str, args: list[int], after: int | None = None) -> Any:
        """A new letter; its value in the world is made of indeterminates."""
        letter = _Letter(name, kind, args, {}, _LAST.get(kind, 0) if after is None else after)
        value: Any
        if kind in _SCALARS:
            value = self._indeterminate(letter, 0, 0)
        else:
            symmetric = kind in ("symmetric", "psd", "pd")

            def entry(i: int, j: int) -> Any:
                if kind == "diagonal" and i != j:
                    return 0
                return self._indeterminate(letter, *((j, i) if symmetric and i > j else (i, j)))

            value = Matrix.build(args[0], args[-1], entry)
        self.letters.append(letter)
        self.world.values[name] = value
        return value

    def _indeterminate(self, letter: _Letter, i: int, j: int) -> fmpq_mpoly:
        if (i, j) not in letter.at:
            if self.count >= _MOST_ENTRIES:
                raise Unknown("more entries than are solved for")
            letter.at[i, j] = self.count
            self.count += 1
        return self.gens[letter.at[i, j]]

    def _hoist(self, tree: Any) -> Any:
        """The tree with a new name in place of each inverse."""
        if not isinstance(tree, list) or not tree or tree[0] in _BINDERS:
            return tree
        if tree[0] in ("block", "rows"):
            return [tree[0], *([self._hoist(x) for x in row] for row in tree[1:])]
        done = [tree[0], *(self._hoist(x) if isinstance(x, list) else x for x in tree[1:])]
        if done[0] == "inv":
            return ["inverse", done[1]]
        if done[0] == "^" and isinstance(done[2], int) and done[2] < 0:
            return ["^", ["inverse", done[1]], -done[2]]
        if done[0] == "/" and isinstance(done[2], list) and done[2][0] != "rat":
            return ["*", done[1], ["inverse", done[2]]]
        return done

    def _value(self, tree: Any) -> Any:
        return self.world.value(self._named(self._hoist(tree)))

    def _named(self, tree: Any) -> Any:
        """Names for the inverses of a tree, with the equations that make them inverses."""
        if not isinstance(tree, list) or not tree:
            return tree
        if tree[0] in ("block", "rows"):
            return [tree[0], *([self._named(x) for x in row] for row in tree[1:])]
        if tree[0] == "sym" and tree[1] in self.world.definitions:
            definition = self.world.definitions[tree[1]]
            return self._named(definition[3]) if definition[0] == "let" and not definition[2] else tree
        done = [tree[0], *(self._named(x) if isinstance(x, list) else x for x in tree[1:])]
        if done[0] != "inverse":
            return done
        name = f"inverse {done[1]!r}"
        if name not in self.world.values:
            term = self.world.value(done[1])
            if isinstance(term, Matrix):
                value = self._letter(name, "matrix", [term.nrows, term.nrows])
                self._vanishes(term * value - Matrix.identity(term.nrows))
            else:
                self._vanishes(term * self._letter(name, "scalar", []) - 1)
        return ["sym", name]

    def _read(self, formula: Any) -> None:
        """Equations for a formula; what is none is left to the test of the hypotheses."""
        op = formula[0]
        if op == "and":
            for part in formula[1:]:
                self._read(part)
        elif op == "=":
            values = [self._value(x) for x in formula[1:]]
            for x, y in zip(values, values[1:], strict=False):
                self._vanishes(x - y)
        elif op == "symmetric":
            m = self._value(formula[1])
            self._vanishes(m - m.transpose())
        elif op == "symplectic":
            m = self._value(formula[1])
            j = symplectic_form(m.nrows // 2)
            self._vanishes(m.transpose() * j * m - j)
        elif op in ("psd", "pd"):
            self._at_least_zero(formula[1], op)
        elif op == "loewner":
            self._at_least_zero(["-", *formula[1:]] if formula[2] != 0 else formula[1], "psd")
        elif op in (">", ">=", "<", "<=") and len(formula) == 3:
            big, small = formula[1:] if op[0] == ">" else formula[:0:-1]
            self._at_least_zero(["-", big, small], "pd" if len(op) == 1 else "psd")

    def _at_least_zero(self, tree: Any, kind: str) -> None:
        """term = S for a new semidefinite S."""
        value = self._value(tree)
        if isinstance(value, Matrix):
            self._vanishes(value - self._letter(f"at least 0: {tree!r}", kind, [value.nrows], 4))
        else:
            self._vanishes(value - self._letter(f"at least 0: {tree!r}", {"psd": "nonneg", "pd": "positive"}[kind], [], 4))

    def _vanishes(self, value: Any) -> None:
        for x in [x for row in value.rows for x in row] if isinstance(value, Matrix) else [value]:
            p = x if isinstance(x, fmpq_mpoly) else self.ring.constant(_fmpq(x))
            if not p.is_zero():
                self.equations.append(p)

    # ------------------------------------------------------------------ solving
    def solve(self, draw: Draw, random: Random) -> dict[str, Any] | None:
        """One try: values of the variables of the statement."""
        self.rest, self.known = list(self.equations), list(self.gens)
        order = [letter for letter in self.letters if letter.at]
        random.shuffle(order)
        order.sort(key=lambda letter: letter.after + 2 * random.random())
        rank = {k: place for place, letter in enumerate(order) for k in letter.at.values()}
        for _ in range(_STEPS):
            self.rest = [p for p in self.rest if not p.is_zero()]
            if any(p.is_constant() for p in self.rest) or sum(len(p) for p in self.rest) > _MOST_TERMS:
                return None
            if not self.rest:
                return self._finish(draw, random)
            affine = [p for p in self.rest if p.total_degree() == 1]
            if affine:
                self._assign(_eliminated(affine, self.gens, rank, self.ring))
            elif random.random() < 0.5 and (explicit := self._explicit(rank, random)):
                self._assign(explicit)
            elif not self._guess(order, draw, random):
                return None
        return None

    def _assign(self, changes: Mapping[int, fmpq_mpoly]) -> None:
        args = [changes.get(k, g) for k, g in enumerate(self.gens)]
        self.rest = [p.compose(*args, ctx=self.ring) for p in self.rest]
        self.known = [p if p.is_constant() else p.compose(*args, ctx=self.ring) for p in self.known]

    def _explicit(self, rank: Mapping[int, int], random: Random) -> dict[int, fmpq_mpoly]:
        """An indeterminate that an equation gives as a polynomial in the others."""
        found = []
        for p in self.rest:
            linear = [m for m in p.monoms() if sum(m) == 1]
            degrees = p.degrees()
            for m in linear:
                k = m.index(1)
                if degrees[k] == 1 and sum(1 for n in p.monoms() if n[k]) == 1:
                    found.append((rank[k] + random.random() * len(rank) / 2, k, p))
        if not found:
            return {}
        _, k, p = min(found, key=lambda entry: entry[0])
        return {k: self.gens[k] - p / p.derivative(k).leading_coefficient()}

    def _guess(self, order: Sequence[_Letter], draw: Draw, random: Random) -> bool:
        """Take a factor, draw a letter that is still free, or guess an entry."""
        shortest = min(len(p) for p in self.rest)
        p = random.choice([p for p in self.rest if len(p) == shortest])
        factors = [f for f, _ in p.factor()[1]]
        if len(factors) > 1 or factors[0].total_degree() < p.total_degree():
            self.rest = [q for q in self.rest if q is not p] + [random.choice(factors)]
            return True
        inside = {k for q in self.rest for k in _support(q)}
        if len(_support(p)) == 1:
            return False  # no rational root
        whole = [letter for letter in order if inside & set(letter.at.values()) and all(self.known[k] == self.gens[k] for k in letter.at.values())]
        if whole and random.random() < (0.85 if len(whole) > 1 else 0.4):
            self._assign(self._drawn(random.choice(whole[len(whole) // 2:]), draw))
        else:
            k = random.choice(sorted(_support(p)))
            self._assign({k: self.ring.constant(random.choice(_GUESSES))})
        return True

    def _drawn(self, letter: _Letter, draw: Draw) -> dict[int, fmpq_mpoly]:
        value = draw(letter.kind, letter.args)
        return {k: self.ring.constant(_fmpq(value.rows[i][j] if isinstance(value, Matrix) else value)) for (i, j), k in letter.at.items()}

    def _finish(self, draw: Draw, random: Random) -> dict[str, Any]:
        """Nothing is asked any more: draw what is still free."""
        free: dict[int, fmpq_mpoly] = {}
        for letter in self.letters:
            if letter.at and all(self.known[k] == self.gens[k] for k in letter.at.values()):
                free.update(self._drawn(letter, draw))
        for k, p in enumerate(self.known):
            if k not in free and p == self.gens[k]:
                free[k] = self.ring.constant(_fmpq(draw("scalar", [])))
        self._assign(free)
        names = {name for name, _ in self.statement["over"]}
        return {letter.name: self._number_of(letter) for letter in self.letters if letter.name in names}

    def _number_of(self, letter: _Letter) -> Any:
        """Value of a letter once all entries are known."""
        numbers = {place: _exact(self.known[k]) for place, k in letter.at.items()}
        if letter.kind in _SCALARS:
            return numbers[0, 0]
        nrows, ncols = letter.args[0], letter.args[-1]
        return Matrix.build(nrows, ncols, lambda i, j: numbers.get((i, j), numbers.get((j, i), 0) if letter.kind != "matrix" else 0))


_GUESSES = [fmpq(*pair) for pair in ((0, 1), (0, 1), (0, 1), (1, 1), (1, 1), (-1, 1), (2, 1), (-2, 1), (1, 2), (3, 5), (4, 5))]


def _support(p: fmpq_mpoly) -> set[int]:
    return {k for k, d in enumerate(p.degrees()) if d > 0}


def _eliminated(affine: Sequence[fmpq_mpoly], gens: Sequence[fmpq_mpoly], rank: Mapping[int, int], ring: Any) -> dict[int, fmpq_mpoly]:
    """Indeterminates of small rank in terms of the others; a contradiction becomes a substitution that shows it."""
    solved: dict[int, fmpq_mpoly] = {}
    for p in affine:
        p = p.compose(*(solved.get(k, g) for k, g in enumerate(gens)), ctx=ring) if solved else p
        support = _support(p)
        if not support:
            continue  # the equation itself stays, and becomes zero or a constant
        pivot = min(support, key=lambda k: rank[k])
        c = next(c for monomial, c in p.terms() if monomial[pivot])
        expression = gens[pivot] - p / c
        swap = [expression if k == pivot else g for k, g in enumerate(gens)]
        solved = {k: q.compose(*swap, ctx=ring) for k, q in solved.items()}
        solved[pivot] = expression
    return solved


def _fmpq(x: Any) -> fmpq:
    return x if isinstance(x, fmpq) else fmpq(int(x.numerator), int(x.denominator))


def _exact(p: fmpq_mpoly) -> Any:
    c = p.leading_coefficient() if not p.is_zero() else fmpq(0)
    return int(c.numerator) if c.denominator == 1 else rational(int(c.numerator), int(c.denominator))
