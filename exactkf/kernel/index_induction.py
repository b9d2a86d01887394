# SPDX-License-Identifier: MIT
"""Induction at a generic index: lemmas in order, then the conclusion from them.

A lemma is shown for every t >= a: at t = a, and from t to t + 1. What it says are equations of
scalars, polynomials (coefficient by coefficient) or matrices (entry by entry), perhaps for all k
between bounds; the hypothesis of the induction and the lemmas before may be used at stated
places. In each region of the parameters the equation then has to follow from them by elimination
of atoms that they contain linearly with a constant factor.

Definitions that the statement makes enter; its hypotheses are needed seldom. Without them everything is said of
elements of the field of rational functions in the variables, and carries over to every instance on which the conclusion
has a value. In that field recursions must have values, and nothing that is divided by may be zero, in a lemma
neither: `exactkf.kernel.defined` sees to that.

A use may be of a hypothesis that says equations. Then everything is said of the numbers of an instance: recursions have values there,
as they are well-founded and nothing is divided by; what is divided by all the same, in any lemma, must be
a difference that a hypothesis says is not zero, or a variable of a type that says so, or a factor of what a hypothesis says is not
zero at the places of a use, within its bounds. A power of z is no number of an instance, and may be divided by.

Polynomials may be multiplied if they are read as functions of z and 1/z: an equation of polynomials in z, 1/z is one of these functions, and the
other way round, so that a lemma that is shown in one way may be used in the other. The functions of recursions are atoms, X_t(z) and X_t(1/z).

The evidence may tell the ``cases``: for each part of a region, in the order in which they are looked at, either the form at
whose sign it is cut, or the numbers of the uses that are needed there. That saves looking for them. Nothing rests on it: what is
shown in both parts is shown, wherever the cut is, and fewer equations tell no more.

Main definitions
----------------
`generic_index`
    Replay of such a certificate.
`Proof`
    The same in steps, for a search that notes the cases.

Determinants, inverses and the like are not opened; what turns them into other terms is in `exactkf.kernel.generic_facts`.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import suppress
from itertools import islice
from typing import Any

from exactkf.kernel.defined import Witness, ill_founded
from exactkf.kernel.generic import Terms
from exactkf.kernel.generic_facts import FACTS, determinant, unit_triangular
from exactkf.kernel.numbers import Rejected, Undefined, Unknown
from exactkf.kernel.packed import BITS, exponents
from exactkf.kernel.region import INDEX, Form, Region, Split, plus
from exactkf.kernel.symbolic import Symbolic
from exactkf.kernel.wellformed import check_formula, check_statement

__all__ = ["Proof", "generic_index"]

#: atoms, in the order in which equations are solved for them
_FIRST = ("opaque", "word", "value", "value at 1/z", "sum", "coeff", "entry", "at", "prod", "power", "number")
_LEAST = {">=": 0, ">": 1}
_MOST_SPLITS = 14
_MASK = (1 << BITS) - 1
_RESERVED = {INDEX, "z", "row", "column"}
_ONE: Form = {"": 1}
Goal = Callable[[Terms], list[Symbolic]]
_Row = tuple[Symbolic, frozenset[int]]  # what is zero, and the numbers of what it divides by


def _has_solutions(tree: Any) -> bool:
    if isinstance(tree, Mapping):
        return _has_solutions(list(tree.values()))
    return isinstance(tree, (list, tuple)) and (tree[:1] in (["stein"], ("stein",)) or any(map(_has_solutions, tree)))


def generic_index(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    """Replay; the denominators met."""
    check_statement(statement, hiding=False)  # a member of a conjunction, where an index may hide a matrix, is followed by names too
    if _has_solutions([statement["says"], [d[2:] for d in statement["where"]], [g[1] for g in statement["given"]], evidence]):
        raise Unknown("solutions X = MXM' + Q, which are for words")
    return Proof(statement, evidence).replay()


class Proof:
    """The lemmas shown so far, of those in the evidence."""

    def __init__(self, statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
        self.statement, self.evidence = statement, evidence
        self.closed, self.whole, self.told = evidence.get("closed") or (), evidence.get("whole") or (), iter(evidence.get("cases") or ())
        self.always = {INDEX}
        self.supported: list[str] = []
        self.rules: dict[str, tuple] = {}
        self.in_values = False  # polynomials are read as functions of z, not by coefficients
        self.some: list[Any] | None = None  # the equations of the conclusion, by their numbers, for which it is so
        self.equations = 0
        self.lemmas: list[Mapping[str, Any]] = []
        self.denominators: list[str] = []
        self.not_zero: set[frozenset] = set()
        self.assumes = False  # a hypothesis has been used
        self.at_point: list[str] = []  # what is not zero because of a point, and perhaps zero on an instance of the hypotheses
        names = _RESERVED & {*statement["sizes"], *(name for name, _ in statement["over"]), *(d[1] for d in statement["where"])}
        if names or any(n.startswith(("#", "@")) for n in statement["sizes"]):
            raise Unknown(f"a name that the induction needs: {', '.join(sorted(names))}")
        self.sizes: list[Form] = [{name: 1} for name in statement["sizes"]]
        terms = Terms(statement, Region.of())
        for _, formula, _ in statement["given"]:  # a hypothesis such as n > 1; the others are not used
            if formula[0] in _LEAST and len(formula) == 3:
                with suppress(Unknown):
                    gap = plus(terms.index(formula[1], {}), terms.index(formula[2], {}), -1)
                    self.sizes.append(plus(gap, {"": 1}, -_LEAST[formula[0]]))
        self.witnesses, self.ill_founded = [Witness(statement, self.sizes, number) for number in (1, 0)], ill_founded(statement, self.sizes)

    def replay(self) -> list[str]:
        """Everything that is listed, in order; the denominators met."""
        evidence = self.evidence
        try:
            self.supported.extend(evidence.get("supported") or [])
            for name in self.supported:
                self.support(name)
            for lemma in evidence["lemmas"]:
                self.lemma(lemma)
            self.conclude(evidence)
            if self.assumes and self.at_point:
                raise Rejected(f"a hypothesis is used, and none says that {self.at_point[0]} is not zero")
        except Split as split:  # of a size or a bound, where there is no term to be looked at in cases
            raise Rejected(f"a size or a bound depends on whether {Terms.form_text(split.form)} >= 0") from None
        return self.denominators

    # ------------------------------------------------------------------ what a certificate lists
    def support(self, name: str) -> None:
        """X_t has exponents 0 .. t; for a function, whatever its other arguments."""
        d: Any = next((d for d in self.statement["where"] if d[1] == name), ("",))
        if d[0] == "let" and d[2]:
            others = {p: {f"@{p}": 1} for p in d[2][:-1]}
            cases = [(d[3], {**others, d[2][-1]: last}, forms, last) for forms, last in (([], {}), ([{INDEX: 1}], {INDEX: 1, "": 1}))]
        elif d[0] == "rec" and d[3] == 0 and len(d[4]) == 1:
            cases = [(d[4][0], {}, [], {}), (d[5], {d[2]: {INDEX: 1}}, [{INDEX: 1}], {INDEX: 1, "": 1})]
        else:
            raise Rejected(f"{name} is no recursion with one value at 0")
        for tree, env, forms, last in cases:
            def goal(terms: Terms, tree: Any = tree, env: dict[str, Form] = env) -> list[Symbolic]:
                return [terms.coefficient(tree, terms.region.reduce({"z": 1}), env)]

            for outside in ({"z": -1, "": -1}, plus({"z": 1, "": -1}, last, -1)):
                self.close(Region.of(*forms, outside), goal, [], {}, f"exponents of {name}", limited=True)

    def lemma(self, lemma: Mapping[str, Any]) -> None:
        """A lemma, in which more names may be closed than elsewhere."""
        closed = self.closed
        self.closed = [*closed, *(lemma.get("closed") or ())]
        self._lemma(lemma)
        self.closed = closed

    def _lemma(self, lemma: Mapping[str, Any]) -> None:
        """Base and step; a rule X[t] = term is used by itself from then on."""
        index, first, says, place = lemma["index"], lemma.get("from", 0), lemma["says"], f"lemma {len(self.lemmas)}"
        if type(first) is not int or first < 0:
            raise Rejected(f"{place}: it starts before zero")
        check_formula(self.statement, says, index)
        rules = list(_rules(says, index, place)) if lemma.get("rule") else []
        self.in_values = bool(lemma.get("in values"))
        generic = Region.of(*self.sizes, plus({INDEX: 1}, {"": first}, -1))
        if "fact" in lemma:
            if lemma["fact"] not in FACTS or index in _RESERVED | set(self.statement["sizes"]):
                raise Rejected(f"{place}: no fact of that name, or an index that is taken")
            FACTS[lemma["fact"]](self, lemma, {index: {INDEX: 1}}, generic, place)
            self.lemmas.append(lemma)
            return
        if lemma.get("direct"):  # no induction: at any index from the first on
            self._show(says, {index: {INDEX: 1}}, generic, lemma.get("uses", ()), place)
            self.lemmas.append(lemma)
            return
        self._show(says, {index: {"": first} if first else {}}, Region.of(*self.sizes), lemma.get("base", ()), f"{place}, base")
        self.lemmas.append(lemma)
        known, self.supported = self.supported, [] if lemma.get("bare") else self.supported
        self.rules.update((name, (None, names, high, term)) for name, names, high, term in rules)
        self._show(says, {index: {INDEX: 1, "": 1}}, generic, lemma.get("uses", ()), f"{place}, step", {index: {INDEX: 1}}, len(self.lemmas) - 1)
        self.rules.update((name, (first, names, high, term)) for name, names, high, term in rules)
        self.supported = known

    def conclude(self, evidence: Mapping[str, Any]) -> None:
        says, uses, some = self.statement["says"], evidence.get("uses", ()), evidence.get("in values")
        self.in_values = bool(some)
        self.some, self.equations = list(some) if isinstance(some, (list, tuple)) else None, 0
        for place, part in enumerate(says[1:] if says[0] == "and" else [says]):
            name = f"conclusion {place}"
            if part[0] == "always" or (part[0] == "forall" and type(part[2]) is int):
                low = part[2] if part[0] == "forall" else 0
                if low < 0 or type(evidence.get("shift", 0)) is not int:
                    raise Rejected(f"{name}: indices are not negative")
                shift = max(0, min(low, evidence.get("shift", 0)))  # t = @ + shift, and every t from low on is reached
                t: Form = plus({INDEX: 1}, {"": shift})
                forms = [*self.sizes, {INDEX: 1}, plus(t, {"": low}, -1)]
                terms = Terms(self.statement, Region.of())
                if part[0] == "forall":
                    forms.append(plus(terms.index(part[3], {}), t, -1))
                self._show(part[-1], {part[1]: t}, Region.of(*forms), uses, name)
            elif _is_determinant(part) and part[2] == 1:
                unit_triangular(self, part[1][1], {}, Region.of(*self.sizes), uses, name)
            elif _is_determinant(part) and "triangular" in evidence:
                if not isinstance(part[2], list) or part[2][0] != "prod":
                    raise Rejected(f"{name}: a determinant at a generic size is one, or a product over the rows")
                determinant(self, part, evidence["triangular"], {}, Region.of(*self.sizes), uses, name)
            else:
                self._show(part, {}, Region.of(*self.sizes), uses, name)

    # ------------------------------------------------------------------ formulas
    def _show(self, says: Any, env: dict[str, Form], region: Region, uses: Any, place: str, names: Mapping[str, Form] | None = None,
              current: int | None = None) -> None:
        """A formula at given indices; ``names`` are what the uses may refer to, ``current`` the lemma under proof."""
        if region.empty:
            return
        names = dict(env if names is None else names)
        op = says[0]
        if op == "and":
            for part in says[1:]:
                self._show(part, env, region, uses, place, names, current)
        elif op == "forall":
            _, name, low, high, body = says
            if self.is_bound(name, env, names):
                raise Unknown(f"index {name!r} bound twice")
            terms = Terms(self.statement, region)
            k: Form = {name: 1}
            inner = region.and_(plus(k, terms.index(low, env), -1), plus(terms.index(high, env), k, -1))
            self._show(body, {**env, name: k}, inner, uses, place, {**names, name: k}, current)
        elif op == "always":
            _, name, body = says
            if self.is_bound(name, env, names):
                raise Unknown(f"index {name!r} bound twice")
            self.always.add(name)
            self._show(body, {**env, name: {name: 1}}, region.and_({name: 1}), uses, place, {**names, name: {name: 1}}, current)
            self.always.discard(name)
        elif op == "=":
            for left, right in zip(says[1:], says[2:], strict=False):
                self._equation(left, right, env, region, uses, place, names, current)
        else:
            raise Unknown(f"{op!r} at a generic index")

    def is_bound(self, name: str, *taken: Mapping[str, Form]) -> bool:
        """A name that an index may not have here, as it is that of another parameter or of none."""
        return any(name in names for names in taken) or name in self.statement["sizes"] or name in _RESERVED or not name.isidentifier()

    def _equation(self, left: Any, right: Any, env: dict[str, Form], region: Region, uses: Any, place: str, names: dict[str, Form],
                  current: int | None) -> None:
        terms = Terms(self.statement, region)
        shapes = [terms.shape(x, env) for x in (left, right)]  # a number has one row and one column
        if shapes != [(_ONE, _ONE)] * 2:
            if any(plus(x, y, -1) for x, y in zip(*shapes, strict=True)):
                raise Rejected(f"{place}: matrices of different sizes")
            i, j = {"row": 1}, {"column": 1}
            region = region.and_(plus(i, _ONE, -1), plus(shapes[0][0], i, -1), plus(j, _ONE, -1), plus(shapes[0][1], j, -1))
            names = {**names, "row": i, "column": j}

            def goal(t: Terms) -> list[Symbolic]:
                x, y = (t.entry(s, t.region.reduce(i), t.region.reduce(j), env) for s in (left, right))
                return [x - y]
        else:
            names = {**names, "z": {"z": 1}}

            def goal(t: Terms) -> list[Symbolic]:
                return [_difference(t, left, right, t.region.reduce({"z": 1}), env)]
        in_values = self.in_values if self.some is None else self.equations in self.some
        self.equations += 1
        self.close(region, goal, uses, names, place, current, in_values=in_values)

    def _granted(self, terms: Terms, use: Mapping[str, Any], names: Mapping[str, Form], current: int | None, granted: set[tuple]) -> Iterator[_Row]:
        """Of the equations that a lemma says at the places given those whose inverses exist, as the goal has them too; with what they divide by."""
        terms.met, terms.field.used = set(), set()
        for x in self._instances(terms, use, names, current):
            if terms.met <= granted:
                yield x, frozenset(terms.field.used)
            terms.met, terms.field.used = set(), set()

    def _instances(self, terms: Terms, use: Mapping[str, Any], names: Mapping[str, Form], current: int | None) -> Iterator[Symbolic]:
        """Equations, as left minus right side, that a lemma says at the places given."""
        if "definition" in use:
            with suppress(Unknown, Undefined):  # it speaks of names of another part, or of places that there are not
                places = {name: terms.index(tree, names) for name, tree in use.get("place", {}).items()}
                at = tuple(terms.index(tree, names) for tree in use["at"])
                yield terms.defining(use["definition"], at, places)
                if terms.in_values and use["definition"] in terms.in_z:
                    yield terms.defining(use["definition"], at, {"flip": {}})
            return
        if "given" in use:
            yield from self._assumed(terms, use, names)
            return
        number = use["lemma"]
        if type(number) is not int or not 0 <= number < len(self.lemmas):
            raise Rejected(f"there is no lemma {number} here")
        lemma = self.lemmas[number]
        try:
            places = {name: terms.index(tree, names) for name, tree in use["at"].items()}
        except Unknown:
            return  # it speaks of names of another part
        t = places[lemma["index"]]
        if number == current:
            if t != terms.region.reduce({INDEX: 1}):
                raise Rejected("the hypothesis of an induction is known at its index alone")
        elif not terms.region.holds(plus(t, {"": lemma.get("from", 0)}, -1)):
            return
        yield from self._said(terms, lemma["says"], {lemma["index"]: t}, places)

    def _assumed(self, terms: Terms, use: Mapping[str, Any], names: Mapping[str, Form]) -> Iterator[Symbolic]:
        """Equations that a hypothesis says at the places given; what is said of all t holds as long as it has a value."""
        formula = next((formula for label, formula, _ in self.statement["given"] if label == use["given"]), None)
        if formula is None or _mentions(formula, "always"):
            raise Rejected(f"there is no hypothesis {use['given']!r}, or it is about all t")
        self.assumes = True
        with suppress(Unknown):  # places of another part
            places = {name: terms.index(tree, names) for name, tree in use["at"].items()}
            yield from self._said(terms, formula, {}, places)

    def _is_granted(self, terms: Terms, p: Mapping[int, int]) -> bool:
        """A hypothesis, or the type of a variable, says that a polynomial is not zero."""
        places = _places(p)
        kinds = dict(self.statement["over"])
        if len(p) == 1 and len(places) == 1 and (key := terms.atoms[min(places)])[0] == "at" and kinds.get(key[1], ("",))[0] in ("nonzero", "positive"):
            return True
        for _, formula, _ in self.statement["given"]:
            if formula[0] == "!=":
                with suppress(Unknown, Undefined, Split):
                    x = terms.value(formula[1], {}) - terms.value(formula[2], {})
                    if not x.den and (x.num == p or x.num == {k: -c for k, c in p.items()}):
                        return True
        return False

    def _is_not_zero(self, terms: Terms, p: dict[int, int]) -> bool:
        """At one of the points a polynomial is not zero."""
        return any(witness.is_not_zero(terms, p) for witness in self.witnesses)

    def _equal_is_not_zero(self, terms: Terms, p: Mapping[int, int], known: _Equations, proven: set[int]) -> bool:
        """What a polynomial is by the equations used here is not zero; they divide by nothing but what is known not to be zero."""
        known.again(_places(p), proven)
        equal = known.reduced(Symbolic(terms.field, dict(p), 1, ())).num
        return bool(equal) and self._is_not_zero(terms, equal)

    def _said(self, terms: Terms, says: Any, env: dict[str, Form], places: Mapping[str, Form]) -> Iterator[Symbolic]:
        if says[0] == "and":
            for part in says[1:]:
                yield from self._said(terms, part, env, places)
        elif says[0] == "always":
            _, name, body = says
            if name in places and terms.region.holds(places[name]):
                yield from self._said(terms, body, {**env, name: places[name]}, places)
        elif says[0] == "forall":
            _, name, low, high, body = says
            if name not in places:
                return
            k = places[name]
            if terms.region.holds(plus(k, terms.index(low, env), -1)) and terms.region.holds(plus(terms.index(high, env), k, -1)):
                yield from self._said(terms, body, {**env, name: k}, places)
        elif says[0] == "=":
            for left, right in zip(says[1:], says[2:], strict=False):
                in_z = terms.has_z(left) or terms.has_z(right)
                if (terms.is_matrix(left) or terms.is_matrix(right)) and not (in_z and terms.in_values):
                    if "row" in places:
                        yield from self._entries(terms, left, right, places["row"], places.get("column", _ONE), env)
                elif in_z:
                    if terms.in_values:
                        yield from (terms.at_z(left, env, flip) - terms.at_z(right, env, flip) for flip in (False, True))
                    elif "z" in places:
                        yield _difference(terms, left, right, places["z"], env)
                else:
                    yield _difference(terms, left, right, {}, env)

    @staticmethod
    def _entries(terms: Terms, left: Any, right: Any, i: Form, j: Form, env: dict[str, Form]) -> Iterator[Symbolic]:
        """An equation of matrices at a place that they have."""
        rows, cols = terms.shape(left, env)
        if all(terms.region.holds(x) for x in (plus(i, _ONE, -1), plus(rows, i, -1), plus(j, _ONE, -1), plus(cols, j, -1))):
            yield terms.entry(left, i, j, env) - terms.entry(right, i, j, env)

    # ------------------------------------------------------------------ one equation
    def close(self, region: Region, goal: Goal, uses: Any, names: Mapping[str, Form], place: str, current: int | None = None,
               splits: int = 0, limited: bool = False, in_values: bool = False) -> None:
        """The goal follows from the uses in every part of the region; see `generic_index` for what the certificate tells of the parts."""
        told = next(self.told, None)
        if isinstance(told, dict):
            cut = _cut(told)
        else:
            try:
                self.part(region, goal, uses if told is None else [uses[k] for k in told], names, place, current, limited, in_values)
                return
            except Split as split:
                if told is not None:
                    raise Rejected(f"{place}: cases: a part is to be cut again") from None
                cut = split.form
        if splits >= _MOST_SPLITS:
            raise Rejected(f"{place}: too many cases")
        for part in region.cases(cut):
            self.close(part, goal, uses, names, place, current, splits + 1, limited, in_values)

    def part(self, region: Region, goal: Goal, uses: Any, names: Mapping[str, Form], place: str, current: int | None, limited: bool,
             in_values: bool) -> set[int]:
        """The goal follows from the uses everywhere in the region alike; the numbers of those that were needed."""
        terms = Terms(self.statement, region, self.supported, self.rules, self.closed, self.whole)
        terms.always |= self.always
        terms.limited, terms.in_values, terms.unused = limited, in_values, self.ill_founded
        return self._follows(terms, goal(terms), uses, names, current, place)

    def _follows(self, terms: Terms, wanted: list[Symbolic], uses: Any, names: Mapping[str, Form], current: int | None, place: str) -> set[int]:
        """Each wanted term is zero by the uses, and nothing divided by on the way is."""
        granted, needed = set(terms.sure), set[int]()
        for number, use in enumerate(uses):
            if "given" in use and (given := list(self._granted_not_zero(terms, use, names))):
                needed.add(number)
                terms.not_zero += given
        if any(x.num for x in wanted):
            for number, use in enumerate(uses):
                if "times" in use:  # a multiple of the first of its equations is taken off
                    needed.add(number)
                    for x, _ in islice(self._granted(terms, use, names, current, granted), 1):
                        times = (terms.at_z if terms.in_values else terms.value)(use["times"], dict(names))
                        wanted = [y - times * x for y in wanted]
        known = _Equations(terms, ((*row, number) for number, use in enumerate(uses) if "times" not in use
                                   for row in self._granted(terms, use, names, current, granted)))
        for x in wanted:
            if (rest := known.reduced(x)).num:
                where = " and ".join(f"{terms.form_text(f)} >= 0" for f in terms.region.forms)
                raise Rejected(f"{place}: left over where {where}: {terms.field.text(rest.num)[:300]}")
        todo, proven, factors = list[int](), set[int](), terms.field.factors
        while True:  # one after the other: an equation that divides by what is zero would tell that anything is not
            while (index := len(todo) + len(proven)) < len(factors):  # they grow while they are looked at
                (proven.add if self._needs_no_equation(terms, factors[index]) else todo.append)(index)
            if not todo:
                break
            found = next((index for index in todo if self._equal_is_not_zero(terms, factors[index], known, proven)), None)
            if found is None and len(todo) + len(proven) == len(factors):
                raise Rejected(f"{place}: nothing tells that {terms.field.text(factors[todo[0]])} is not zero")
            if found is not None:
                todo.remove(found)
                proven.add(found)
        for f in factors:
            if (text := terms.field.text(f)) not in self.denominators:
                self.denominators.append(text)
        return needed | known.needed

    def _granted_not_zero(self, terms: Terms, use: Mapping[str, Any], names: Mapping[str, Form]) -> Iterator[Symbolic]:
        """What a hypothesis at the places given says is not zero; places of another part, or beyond its bounds, say nothing."""
        formula, env = next((formula for label, formula, _ in self.statement["given"] if label == use["given"]), [""]), dict[str, Form]()
        with suppress(Unknown, Undefined):
            places = {name: terms.index(tree, names) for name, tree in use["at"].items()}
            while formula[0] == "forall" and formula[1] in places:
                _, name, low, high, formula = formula
                k = env[name] = places[name]
                if not all(terms.region.decide(x) is True for x in (plus(k, terms.index(low, env), -1), plus(terms.index(high, env), k, -1))):
                    return
            if formula[0] == "!=" and not any(terms.is_matrix(x) or terms.has_z(x) for x in formula[1:]):
                x = terms.value(formula[1], env) - terms.value(formula[2], env)
                if not x.den:
                    yield x

    def _needs_no_equation(self, terms: Terms, f: dict[int, int]) -> bool:
        """Something divided by is not zero at a point, or by a hypothesis; what is known of it is kept."""
        if len(f) == 1 and all(key[0] == "power" or key == ("at", "z") for key in (terms.atoms[place] for place in _places(f))):
            return True  # a power of z, which is no number of an instance
        index = terms.field.factors.index(f)
        if any(terms.field.cancel(x.num, index, 1)[1] for x in terms.not_zero):  # it divides what is not zero
            self.assumes = True
            return True
        key = frozenset((tuple((terms.atoms[k], e) for k, e in enumerate(exponents(monomial)) if e), c) for monomial, c in f.items())
        if key in self.not_zero:
            return True
        given = self._is_granted(terms, f)
        if not given:
            self.at_point.append(terms.field.text(f))
        if self._is_not_zero(terms, f):
            if not given:  # whatever the indices are
                self.not_zero.add(key)
        elif given:  # by a hypothesis, which is used that way
            self.assumes = True
        else:
            return False
        return True


class _Equations:
    """Equations x = 0, each solved for an atom that it contains linearly with a constant factor; read as far as they are needed.

    Parameters
    ----------
    terms : what they are made of
    rows : the x, with what they divide by, and the number of the use that says so
    """

    def __init__(self, terms: Terms, rows: Iterator[tuple[Symbolic, frozenset[int], int]]) -> None:
        self.terms, self.rows = terms, rows
        self.read: list[tuple[Symbolic, frozenset[int], int]] = []
        self.allowed: set[int] | None = None  # what those that are used may divide by
        self.first: Collection[int] = ()
        self.solved: list[tuple[int, Symbolic, set[int]]] = []  # an atom, its value by the equation and those before, and the uses that say these
        self.needed: set[int] = set()  # the uses without which something would not have been reduced as it was

    def reduced(self, goal: Symbolic) -> Symbolic:
        """The goal after one equation and the next has been used, until it is zero."""
        for pivot, value, uses in self._values():
            before, goal = goal, _eliminated(self.terms, goal, value, pivot)
            if goal is not before:
                self.needed |= uses
            if not goal.num:
                break
        return goal

    def again(self, first: Collection[int], allowed: set[int]) -> None:
        """Read all equations that divide by nothing but what is allowed, and choose atoms once more: some come first, those in denominators last."""
        self.rows, self.read, self.solved, self.first, self.allowed = iter([*self.read, *self.rows]), [], [], first, set(allowed)

    def _values(self) -> Iterator[tuple[int, Symbolic, set[int]]]:
        yield from list(self.solved)
        for row, used, number in self.rows:
            self.read.append((row, used, number))
            if self.allowed is not None and not used <= self.allowed:
                continue
            uses = {number}
            for pivot, value, others in self.solved:
                before, row = row, _eliminated(self.terms, row, value, pivot)
                if row is not before:
                    uses |= others
            place = _pivot(self.terms, row, self.first)
            if place is not None:
                parts = _parts(row, place)
                value = -Symbolic(row.field, parts.get(0, {}), 1, ()) * Symbolic(row.field, parts[1], 1, ()).inverse()
                self.solved.append((place, value, uses))
                yield self.solved[-1]


def _cut(told: Mapping[str, Any]) -> Form:
    """The form at which a region is cut: at any there may be, but for those of the indices of sums, of which a region has to know no more than the bounds."""
    if set(told) <= {""} or any(type(c) is not int or not c or name.startswith("#") for name, c in told.items()):
        raise Rejected("cases: a cut is at a linear form in the parameters")
    return dict(told)


def _is_determinant(part: Any) -> bool:
    return part[0] == "=" and len(part) == 3 and isinstance(part[1], list) and part[1][0] == "det"


def _rules(says: Any, index: str, place: str) -> Iterator[tuple[str, list[str], Any, Any]]:
    """Name, indices, greatest index (or None) and term of each equation X[t] = term, or X(s, t) = term for all s >= 0.

    The greatest is b in ``forall(u, t, b, ..)`` where u occurs no more; the terms have none of the names.
    """
    others, high = [], None
    while says[0] == "always":
        others.append(says[1])
        says = says[2]
    if says[0] == "forall" and says[2] == ["sym", index] and not _mentions(says[4], says[1]):
        high, says = says[3], says[4]
    parts = says[1:] if says[0] == "and" else [says]
    if any(p[0] != "=" or len(p) != 3 or p[1][0] != "at" or p[1][2:] != [["sym", x] for x in (*others, index)] for p in parts) or (
            {p[1][1] for p in parts} & {name for p in parts for name in _heads(p[2])}):
        raise Rejected(f"{place}: only equations X[t] = term without X are rules")
    for p in parts:
        yield p[1][1], [*others, index], high, p[2]


def _mentions(tree: Any, name: str) -> bool:
    return tree == name or isinstance(tree, list) and any(_mentions(x, name) for x in tree)


def _heads(tree: Any) -> set[str]:
    if not isinstance(tree, list):
        return set()
    return ({tree[1]} if tree[:1] in (["at"], ["sym"]) else set()).union(*(_heads(x) for x in tree))


def _difference(terms: Terms, left: Any, right: Any, m: Form, env: Mapping[str, Form]) -> Symbolic:
    """Left minus right side, or its coefficient at m."""
    if terms.in_values:
        return terms.at_z(left, env) - terms.at_z(right, env)
    if terms.has_z(left) or terms.has_z(right):
        return terms.coefficient(left, m, env) - terms.coefficient(right, m, env)
    if isinstance(left, list) and left[0] in ("nrows", "ncols"):
        return terms.number(int(not terms.region.zero(plus(terms.index(left, env), terms.index(right, env), -1))))
    return terms.value(left, env) - terms.value(right, env)


def _parts(x: Symbolic, place: int) -> dict[int, dict[int, int]]:
    """Numerator by powers of an atom."""
    out: dict[int, dict[int, int]] = {}
    shift = BITS * place
    for monomial, c in x.num.items():
        e = (monomial >> shift) & _MASK
        out.setdefault(e, {})[monomial - (e << shift)] = c
    return out


def _places(*polys: Mapping[int, int]) -> set[int]:
    """Atoms that occur in polynomials."""
    used = 0
    for p in polys:
        for monomial in p:
            used |= monomial
    return {place for place, e in enumerate(exponents(used)) if e}


def _pivot(terms: Terms, row: Symbolic, first: Collection[int] = ()) -> int | None:
    """An atom that occurs linearly with a constant factor: sums first, and atoms that the row is solved for already."""
    found: list[tuple] = []
    present, below = _places(row.num), _places(*row.field.factors)  # those below would stay there

    def order(place: int, left: int = 0) -> tuple:
        return place not in first, left, place in below, _FIRST.index(terms.atoms[place][0]), place

    for place in sorted(present, key=order):
        if not row.den and (found or 1 << (BITS * place) not in row.num):  # nothing is left to be divided by: the first is the best
            continue
        parts = _parts(row, place)
        if set(parts) <= {0, 1} and 1 in parts:
            lead, left = parts[1], 0
            for index, e in row.den:
                lead, times = row.field.cancel(lead, index, e)
                left += e - times
            if set(lead) == {0}:
                found.append(order(place, left))
    return min(found)[-1] if found else None


def _eliminated(terms: Terms, x: Symbolic, value: Symbolic, place: int) -> Symbolic:
    """x with a value of the atom inserted: the factor of the atom in its row is a number over denominators met already."""
    mask = _MASK << (BITS * place)
    if not any(monomial & mask for monomial in x.num):
        return x
    mine, out, power = _parts(x, place), terms.number(0), terms.number(1)
    for e in range(max(mine) + 1):
        if e in mine:
            out = out + Symbolic(x.field, mine[e], x.q, x.den) * power
        power = power * value
    return out
