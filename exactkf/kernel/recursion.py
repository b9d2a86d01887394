# SPDX-License-Identifier: MIT
"""Induction for every size: base and step of a statement as statements without an index.

A conclusion ``for all t: p(t)`` or ``for t = a .. b: p(t)`` follows from
p(a), ..., p(m) and from p(t) => p(t + 1) for a generic t >= m. In each of these
the values of recursions and sequences are named: ``X[t]`` is a matrix letter,
or a block of letters; X[t + 1] is replaced by the step of its recursion and
X[0] by the initial value. What comes out are statements about matrices of
named sizes, which `exactkf.kernel.order` proves.

Main definitions
----------------
`inductions`
    The conclusion taken apart: conjuncts, with or without an index.
`before`
    A lemma with an index of its own, shown first.
`Induction`
    Base statements and step statement of one conjunct.

Notation: an index is a linear form in t and the sizes, {name: coefficient},
with '' for the constant. Terms are strict: where p(t + 1) has a value, so have
the terms of the recursions it is made of, and an orbit ends where p has none.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.reader import Reader
from exactkf.kernel.wellformed import check_formula
from exactkf.kernel.words import Blocks, size_tree

__all__ = ["FAMILIES", "Induction", "along", "before", "inductions"]

#: types of variables that take an index
FAMILIES = {"sequence": "scalar", "signal": "scalar", "sequence_of": "", "signal_of": ""}

Form = dict[str, int]
_T = "t"  # the generic index
_UNREADABLE = ["sym", ""]
_DEEPEST, _MOST_NODES = 60, 30000


def inductions(statement: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """One statement for each conjunct of the conclusion; the premise of an implication becomes a hypothesis.

    A conjunct that has no value puts the instance outside the statement, so each may be shown by itself; and what
    a conjunct says at every index of a range may be used for those after it, which are of account where it is true.
    """
    says = statement["says"]
    if says[0] == "and":
        given = list(statement["given"])
        for n, part in enumerate(says[1:]):
            yield from inductions({**statement, "given": list(given), "says": part})
            if part[0] == "forall":
                given.append([f"conjunct {n} of {len(given)}", part, "standing"])
    elif says[0] == "=>":
        premise = [f"premise {len(statement['given'])}", says[1], "standing"]
        yield from inductions({**statement, "given": [*statement["given"], premise], "says": says[2]})
    else:
        yield {**statement}


def along(also: Any, conjunct: int) -> Any:
    """What an induction shows along with a conjunct: formulas for all conjuncts, or a list of formulas for each of them."""
    each = bool(also) and all(not some or not isinstance(some[0], str) for some in also)
    return also[conjunct] if each else also


def before(statement: Mapping[str, Any], says: Any) -> tuple[dict[str, Any], Any, dict[str, Any]]:
    """A formula, or ``forall`` of one, that is shown first: a statement to show it along with, the formula, the statement that has it.

    It is shown along with 0 = 0, so that no inverse in it is taken for granted, and is a lemma in what follows. Values of a
    recursion that do not exist may be chosen at will here: what is used of them is the step, where it has a value, and
    hypotheses, which give them one.
    """
    check_formula(statement, says)
    nothing = ["=", 0, 0]
    indexed = says[0] == "forall"
    alone = [*says[:4], nothing] if indexed else nothing
    after = {**statement, "given": [*statement["given"], [f"shown {len(statement['given'])}", says, "lemma"]]}
    return {**statement, "says": alone}, says[4] if indexed else says, after


class Induction:
    """Base and step of a conclusion ``always`` or ``forall``; of another conclusion, that alone.

    Parameters
    ----------
    statement
        One of `inductions`.
    also : sequence of formulas in the index
        Shown along with the conclusion, as lemmas.
    shapes : mapping of name to [row sizes, column sizes]
        Blocks in which the values of a recursion are named, where not those of its initial value.

    Attributes
    ----------
    bases : list of statements
        One for each of the first indices.
    step : statement or None
        From t to t + 1; None where the conclusion has no index.
    lemmas : list of lists of formulas
        What is shown along, for each base and for the step.

    Raises
    ------
    Unknown, Undefined
        With what does not fit.
    """

    def __init__(self, statement: Mapping[str, Any], also: Any = (), shapes: Mapping[str, Any] | None = None) -> None:
        names = [*statement["sizes"], *(name for name, _ in statement["over"]), *(d[1] for d in statement["where"])]
        if _T in statement["sizes"] or len(set(names)) < len(names):
            raise Unknown("a size called t, or two things of one name")
        says, low, high = statement["says"], 0, None
        self.index, body = "", says
        if says[0] == "always":
            self.index, body = says[1:]
        elif says[0] == "forall" and isinstance(says[2], int):
            self.index, low, _, body = says[1:]
            high = _linear(statement, says[3], {})
        self.statement, self.body, self.low, self.high = statement, body, low, high
        self.recursions = {d[1]: d for d in statement["where"] if d[0] == "rec"}
        self.functions = {d[1]: d for d in statement["where"] if d[0] == "let" and d[2]}
        self.families = {name: kind for name, kind in statement["over"] if kind[0] in FAMILIES}
        self.shapes: dict[str, Any] = dict(shapes or {})
        self.named: list[str] = []  # recursions with a value that is named
        self.busy: set[str] = set()
        self.nodes = 0
        self.first = max([low, *(d[3] + len(d[4]) - 1 for d in self.recursions.values())]) if self.index else low
        self.also, self.lemmas = also, list[Any]()
        for formula in also:
            check_formula(statement, formula, *([self.index] if self.index else []))
        self.bases = [self._base(k) for k in range(low, self.first + 1)]
        self.step = self._step() if self.index else None
        for made in [*self.bases, self.step]:
            self._keep_shapes(made)

    # ------------------------------------------------------------------ the statements
    def _base(self, k: int) -> dict[str, Any]:
        letters: dict[str, Any] = {}
        says = self._at_index({"": k} if k else {}, letters)
        return self._made(says, [], letters, k)

    def _step(self) -> dict[str, Any]:
        letters: dict[str, Any] = {}
        before = [(self.tree(p, {self.index: _plus({_T: 1}, {"": k}, -1)}, letters), "standing" if p is self.body else "lemma")
                  for k in range(self.first - self.low + 1) for p in [self.body, *self.also]]
        after = self._at_index({_T: 1, "": 1}, letters)
        return self._made(after, [[f"hypothesis of induction {k}", p, kind] for k, (p, kind) in enumerate(before)], letters, None)

    def _at_index(self, form: Form, letters: dict[str, Any]) -> Any:
        """The conclusion at an index; the lemmas there are kept."""
        self.lemmas.append([self.tree(p, {self.index: form}, letters) for p in self.also])
        return self.tree(self.body, {self.index: form}, letters)

    def _made(self, says: Any, given: list, letters: dict[str, Any], k: int | None) -> dict[str, Any]:
        """The statement with hypotheses at every index that occurs."""
        where = self._where(letters)
        generic = [{_T: 1}, {_T: 1, "": 1}] if k is None else [{"": k}]
        forms = [dict(f) for f in dict.fromkeys(tuple(sorted(f.items())) for f in [*generic, *(f for f, _ in letters.values())])]
        hypotheses = [[name, formula, "lemma" if kind == "lemma" else "standing"] for label, formula, kind in self.statement["given"]
                      for name, formula in self._hypotheses(label, formula, forms, letters, k)]
        return {**self._frame(letters, where), "given": hypotheses + given, "says": says}

    def _where(self, letters: dict[str, Any]) -> list:
        """The definitions without parameters; the others are written out where they are used.

        What cannot be read keeps its name, so that a proof gives it to nothing else: the statement may speak of it.
        """
        out = [["let", name, [], _UNREADABLE] for name in (*self.recursions, *self.families, *self.functions)]
        for d in self.statement["where"]:
            if d[0] == "let" and not d[2]:
                try:
                    out.append([*d[:3], self.tree(d[3], {}, letters)])
                except (Unknown, Undefined):
                    out.append([*d[:3], _UNREADABLE])
        return out

    def _frame(self, letters: Mapping[str, Any], where: list) -> dict[str, Any]:
        over = [[name, kind] for name, kind in self.statement["over"] if kind[0] not in FAMILIES]
        over += [[name, kind] for name, (_, kind) in letters.items()]
        stable = [list(g) for g in self.statement["given"] if g[1][0] == "schur"]  # which solutions of equations need; those with an index are not read
        return {"sizes": self.statement["sizes"], "over": over, "where": where, "given": stable}

    def _hypotheses(self, label: str, formula: Any, forms: list[Form], letters: dict[str, Any], k: int | None) -> Iterator[tuple[str, Any]]:
        if formula[0] == "and":
            for n, part in enumerate(formula[1:]):
                yield from self._hypotheses(f"{label}.{n}", part, forms, letters, k)
            return
        try:
            if formula[0] != "forall":
                yield label, self.tree(formula, {}, letters)
                return
            low, high = (_linear(self.statement, x, {}) for x in formula[2:4])
        except (Unknown, Undefined):
            return  # not used
        for form in forms:
            if self._nonnegative(_plus(form, low, -1), k) and self._nonnegative(_plus(high, form, -1), k):
                try:
                    yield f"{label} at {_text(form)}", self.tree(formula[4], {formula[1]: form}, letters)
                except (Unknown, Undefined):
                    continue

    def _nonnegative(self, form: Form, k: int | None) -> bool:
        """A linear form is >= 0 for first <= t < high (at t = k, for k <= high); sizes are."""
        t = form.get(_T, 0)
        rest = {n: c for n, c in form.items() if n != _T}
        at = self.first if k is None else k
        last = None if self.high is None else _plus(self.high, {"": 1}, -1) if k is None else self.high
        if t >= 0:
            rest = _plus(rest, {"": at}, t)
        elif last is None:
            return False
        else:
            rest = _plus(rest, last, t)
        slack = [] if last is None else [_plus(rest, _plus(last, {"": at}, -1), -1)]
        return any(all(c >= 0 for c in f.values()) for f in [rest, *slack])

    # ------------------------------------------------------------------ terms
    def tree(self, tree: Any, env: Mapping[str, Any], letters: dict[str, Any], depth: int = 0) -> Any:
        """A term or formula without indices; letters that it brings in are noted with their index and type."""
        if isinstance(tree, int):
            return tree
        self.nodes += 1
        if depth > _DEEPEST or self.nodes > _MOST_NODES:
            raise Unknown("a definition that does not end, or that is very large when written out")
        op = tree[0]
        if op == "rat":
            return list(tree)
        if op == "sym":
            return self._name(tree, env)
        if op == "at":
            return self._at(tree, env, letters, depth)
        if op in ("block", "rows"):
            return [op, *([self.tree(x, env, letters, depth) for x in row] for row in tree[1:])]
        if any(isinstance(x, str) for x in tree[1:]):
            raise Unknown(f"{op!r} over an index, or in z, in an induction for every size")
        return [op, *(self.tree(x, env, letters, depth) for x in tree[1:])]

    def _name(self, tree: Any, env: Mapping[str, Any]) -> Any:
        found = env.get(tree[1], tree)
        if not isinstance(found, dict):
            return found
        if _T in found:
            raise Unknown(f"index {tree[1]!r} is used other than as an index")
        return size_tree(tuple((n.removeprefix("size "), c) for n, c in sorted(found.items())))

    def _at(self, tree: Any, env: Mapping[str, Any], letters: dict[str, Any], depth: int) -> Any:
        name, args = tree[1], tree[2:]
        if name in env:
            raise Unknown(f"{name!r} is a parameter and takes no index")
        if name in self.functions:
            _, _, params, body = self.functions[name]
            if len(params) != len(args):
                raise Undefined(f"{name} takes {len(params)} arguments")
            return self.tree(body, {p: self._argument(a, env, letters, depth) for p, a in zip(params, args, strict=True)}, letters, depth + 1)
        if len(args) != 1 or not (name in self.recursions or name in self.families):
            raise Unknown(f"{name!r} with an index in a statement for every size")
        form = _linear(self.statement, args[0], env)
        return self._value(name, form, letters, depth) if name in self.recursions else self._member(name, form, letters)

    def _argument(self, tree: Any, env: Mapping[str, Any], letters: dict[str, Any], depth: int) -> Any:
        """An index, or a term without indices."""
        try:
            return _linear(self.statement, tree, env)
        except Unknown:
            return self.tree(tree, env, letters, depth)

    def _value(self, name: str, form: Form, letters: dict[str, Any], depth: int) -> Any:
        """Value of a recursion: initial value, step, or letters."""
        _, _, index, start, initial, step = self.recursions[name]
        constant = form.get("", 0)
        if set(form) <= {""}:
            if constant < start:
                raise Undefined(f"{name}[{constant}] lies before the start of the recursion")
            if constant < start + len(initial):
                return self.tree(initial[constant - start], {}, letters, depth + 1)
        if set(form) <= {""} or (form.get(_T) == 1 and set(form) <= {_T, ""} and constant > 0):
            return self.tree(step, {index: _plus(form, {"": 1}, -1)}, letters, depth + 1)
        shape = self._shape(name)
        if shape is None:
            return self._letter(f"{name}[{_text(form)}]", ["scalar"], form, letters)
        rows, cols = shape
        if len(rows) == len(cols) == 1:
            return self._letter(f"{name}[{_text(form)}]", ["matrix", rows[0], cols[0]], form, letters)
        return ["block", *([self._letter(f"{name}[{_text(form)}].{i}.{j}", ["matrix", r, c], form, letters) for j, c in enumerate(cols)]
                           for i, r in enumerate(rows))]

    def _member(self, name: str, form: Form, letters: dict[str, Any]) -> Any:
        kind = self.families[name]
        least = _plus(form, _linear(self.statement, kind[1], {}), -1)
        if set(least) <= {""} and least.get("", 0) < 0:
            raise Undefined(f"{name}[{_text(form)}] is outside the sequence")
        return self._letter(f"{name}[{_text(form)}]", kind[-1] if kind[0] in ("sequence_of", "signal_of") else ["scalar"], form, letters)

    def _letter(self, name: str, kind: Any, form: Form, letters: dict[str, Any]) -> Any:
        letters[name] = (form, kind)
        return ["sym", name]

    def at(self, tree: Any, case: Mapping[str, Any]) -> Any:
        """A term or formula in the index, for one of the bases or for the step."""
        form = {_T: 1} if case is self.step else {"": self.low + next(k for k, s in enumerate(self.bases) if s is case)}
        return self.tree(tree, {self.index: {n: c for n, c in form.items() if c}}, {})

    # ------------------------------------------------------------------ shapes
    def _shape(self, name: str) -> Any:
        """[row sizes, column sizes] in which the values of a recursion are named, None for scalars."""
        if name not in self.named:
            self.named.append(name)
        if name not in self.shapes:
            if name in self.busy:
                raise Unknown(f"the shape of recursion {name} depends on itself")
            self.busy.add(name)
            letters: dict[str, Any] = {}
            first, where = self.tree(self.recursions[name][4][0], {}, letters), self._where(letters)
            value = Reader(self._frame(letters, where)).read(first)
            self.shapes[name] = [[size_tree(s) for s in value.rows], [size_tree(s) for s in value.cols]] if isinstance(value, Blocks) else None
        return self.shapes[name]

    def _keep_shapes(self, made: Any) -> None:
        """The initial values have the shapes named, and a step leads from them to them."""
        done = 0
        while made is not None and done < len(self.named):
            name = self.named[done]
            _, _, index, _start, initial, after = self.recursions[name]
            letters: dict[str, Any] = {}
            values = [self.tree(x, {}, letters) for x in initial] + [self.tree(after, {index: {_T: 1}}, letters)]
            reader = Reader(self._frame({**letters, **{n: ({}, kind) for n, kind in made["over"] if not n.isidentifier()}}, made["where"]))
            if not all(self._has_shape(reader, reader.read(tree), self.shapes[name]) for tree in values):
                raise Unknown(f"recursion {name} does not keep the shape of its initial value")
            done += 1

    def _has_shape(self, reader: Reader, value: Any, shape: Any) -> bool:
        if shape is None or not isinstance(value, Blocks):
            return shape is None and not isinstance(value, Blocks)
        rows, cols = (tuple(reader.size(s) for s in side) for side in shape)
        split = reader._split_like(value, rows, cols)
        return (split.rows, split.cols) == (rows, cols)


# ---------------------------------------------------------------------- linear forms
def _linear(statement: Mapping[str, Any], tree: Any, env: Mapping[str, Any]) -> Form:
    """An index as a linear form in t and the sizes."""
    if isinstance(tree, int):
        return {"": tree} if tree else {}
    op = tree[0]
    if op == "sym":
        if isinstance(env.get(tree[1]), dict):
            return env[tree[1]]
        if tree[1] in statement["sizes"] and tree[1] not in env:
            return {f"size {tree[1]}": 1}
    elif op in ("+", "-"):
        total = _linear(statement, tree[1], env)
        for part in tree[2:]:
            total = _plus(total, _linear(statement, part, env), 1 if op == "+" else -1)
        return total
    raise Unknown(f"{tree!r} is no index")


def _plus(x: Form, y: Form, factor: int) -> Form:
    out = dict(x)
    for n, c in y.items():
        out[n] = out.get(n, 0) + factor * c
    return {n: c for n, c in out.items() if c}


def _text(form: Form) -> str:
    parts = [n.removeprefix("size ") if c == 1 else f"{c}{n.removeprefix('size ')}" for n, c in sorted(form.items()) if n]
    if form.get("") or not parts:
        parts.append(str(form.get("", 0)))
    return "+".join(parts).replace("+-", "-")
