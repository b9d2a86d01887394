# SPDX-License-Identifier: MIT
"""Certificates and their replay.

A certificate is a JSON object: format, version, claim id, kind, the statement,
the evidence, and a digest of all that. `replay` accepts it or raises
`Rejected` with the step that fails. Kinds:

===============  ==================================================================
``instances``    every listed instance satisfies types, hypotheses and conclusion
``counterexample``  the instance satisfies types and hypotheses, not the conclusion
``evaluation``   all values of integer variables and listed sizes, nothing else free
``identity``     the conclusion is true with a symbol in place of every variable
``combination``  lhs - rhs = sum of L (lhs - rhs of a hypothesis) R, with symbols
``induction``    t = 0, and t -> t + 1 with symbols in place of the state at t
``membership``   for every size: lhs - rhs = sum of c l (assumption) r in words of letters
``order``        for every size: semidefinite terms, inverses, and multiples of the assumptions
``word induction``  for every size: base and step, each by an ``order``
``generic index``  for every size: coefficients and sums at a generic index, by induction
``arithmetic``   for numbers and integers of any size: the denied statement contradicts itself in every case
``positivity``   lhs - rhs = sum of c q^2 (products of hypotheses), with symbols
``orbit``        the answer about an orbit follows from the question
===============  ==================================================================

What is proved with symbols holds wherever the recorded denominators are not
zero. `replay` returns them as text. What else a certificate takes for granted `rests_on` tells.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Mapping
from contextlib import suppress
from fractions import Fraction
from typing import Any

from exactkf.kernel.every_size import KINDS
from exactkf.kernel.existence import existence
from exactkf.kernel.instances import admissible, generic, read_instance
from exactkf.kernel.limits import collecting_seldom
from exactkf.kernel.linear import Matrix, symplectic_form
from exactkf.kernel.meaning import Generic, World, indices
from exactkf.kernel.numbers import Laurent, Ratio, Rejected, Undefined, Unknown, rationals
from exactkf.kernel.orbit_answer import check_answer
from exactkf.kernel.rational import quotient
from exactkf.kernel.roots import divmod_poly
from exactkf.kernel.symbolic import Symbolic, SymbolicField
from exactkf.kernel.trials import Trials
from exactkf.kernel.wellformed import check_formula, check_statement

__all__ = ["FORMAT", "VERSION", "NotACertificate", "Rejected", "digest", "replay", "rests_on", "seal"]

FORMAT, VERSION = "exactkf-certificate", 1
_FIELDS = ("format", "version", "id", "kind", "statement", "evidence", "digest")
_GENERIC_T = Generic(Generic.T)  # stands for "some t" in an induction step


class NotACertificate(Exception):
    """The object is no certificate of this version."""


def digest(certificate: Mapping[str, Any]) -> str:
    """SHA-256 of everything but the digest itself, in canonical JSON."""
    body = {k: certificate[k] for k in _FIELDS if k != "digest"}
    return hashlib.sha256(json.dumps(body, sort_keys=True, separators=(",", ":")).encode()).hexdigest()


def seal(id: str, kind: str, statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> dict[str, Any]:
    """A certificate with its digest."""
    made = {"format": FORMAT, "version": VERSION, "id": id, "kind": kind, "statement": statement, "evidence": evidence}
    made = json.loads(json.dumps(made))
    return {**made, "digest": digest(made)}


def replay(certificate: Any, trials: Trials | None = None) -> list[str]:
    """Replay a certificate; return the denominators it assumes nonzero.

    A search hands in `trials` that remember which cancellations were possible; as evidence ``cancelled`` they save the
    next replay the others.

    Raises
    ------
    NotACertificate
        Wrong format, version or fields.
    Rejected
        With the step that fails.
    """
    if not isinstance(certificate, dict) or certificate.get("format") != FORMAT:
        raise NotACertificate("not an exactkf certificate; pass a file that 'exactkf verify --certificates' wrote")
    if certificate.get("version") != VERSION:
        raise NotACertificate(f"version {certificate.get('version')!r} of the certificate format; this checker reads version {VERSION}")
    if set(certificate) != set(_FIELDS) or not isinstance(certificate["kind"], str) or certificate["kind"] not in _KINDS:
        raise NotACertificate("fields or kind of the certificate are not those of version 1")
    try:
        if not isinstance(certificate["id"], str):
            raise NotACertificate("the id of a certificate is a string")
        if digest(certificate) != certificate["digest"]:
            raise Rejected("digest: the certificate was altered after it was written")
        with rationals(quotient), collecting_seldom():
            evidence = certificate["evidence"]
            _well_formed(certificate)
            return _KINDS[certificate["kind"]](certificate["statement"], evidence if trials is None else {**evidence, "cancelled": trials})
    except (Undefined, Unknown) as error:
        raise Rejected(f"{certificate['kind']}: {error}") from error
    except (KeyError, TypeError, ValueError, IndexError, AttributeError, RecursionError, ArithmeticError, AssertionError) as error:
        raise Rejected(f"{certificate['kind']}: malformed data ({type(error).__name__}: {error})") from error


def rests_on(certificate: Mapping[str, Any]) -> str:
    """What a certificate that replays takes for granted, '' for nothing.

    An identity in the parameters of a parametrisation holds for what the parametrisation reaches. That this is
    everything the hypotheses admit is another claim, or a classical fact: it is named in the certificate, and not looked at here.
    """
    statement, evidence = certificate["statement"], certificate["evidence"]
    if certificate["kind"] != "identity" or _is_said(statement, evidence.get("given_by") or {}):
        return ""
    return str(evidence["covered_by"])


def _is_said(statement: Mapping[str, Any], given_by: Mapping[str, Any]) -> bool:
    """A hypothesis x = term covers x by itself."""
    said = [formula for _, formula, _ in statement["given"]]
    return all(["=", ["sym", name], tree] in said for name, tree in given_by.items())


def _well_formed(certificate: Mapping[str, Any]) -> None:
    """The statement is one, together with the parameters of the evidence and its definitions; see `exactkf.kernel.wellformed`."""
    statement, evidence = certificate["statement"], certificate["evidence"]
    if certificate["kind"] == "orbit":  # a question and its answer
        return
    parameters, own = evidence.get("parameters") or [], evidence.get("where") or []
    check_statement(statement, certificate["kind"] != "induction")
    if parameters or own:
        check_statement({**statement, "over": [*statement["over"], *parameters], "where": [*statement["where"], *own]})


# ---------------------------------------------------------------------- evidence on instances
def _world(statement: Mapping[str, Any], instance: Mapping[str, Any]) -> World:
    return World(statement, read_instance(statement, instance))


def _instances(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    listed = evidence["instances"]
    _need(len(listed) > 0, "no instance")
    for number, instance in enumerate(listed, 1):
        world = _world(statement, instance)
        fault = admissible(statement, world)
        _need(not fault, f"instance {number}: {fault}")
        _need(world.value(statement["says"]) is True, f"instance {number}: the conclusion does not hold")
    return []


def _counterexample(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    world = _world(statement, evidence["instance"])
    fault = admissible(statement, world)
    _need(not fault, f"counterexample: {fault}")
    _need(world.value(statement["says"]) is False, "counterexample: the conclusion holds there")
    hidden = any(_assumes_always(d) for d in statement["where"]) or any(_assumes_always(f) for _, f, _ in statement["given"])
    _need(not hidden and not _denies_always(statement["says"]), "counterexample: 'always' is assumed or denied, and an instance shows it up to a horizon only")
    return []


def _assumes_always(tree: Any) -> bool:
    return isinstance(tree, list) and (tree[:1] == ["always"] or any(_assumes_always(x) for x in tree))


def _denies_always(tree: Any) -> bool:
    """An 'always' stands anywhere but in what holds the less, the less often it does."""
    if not isinstance(tree, list):
        return False
    if tree[0] == "=>":
        return _assumes_always(tree[1]) or _denies_always(tree[2])
    if tree[0] in ("and", "or", "forall", "exists", "always"):
        return any(_denies_always(x) for x in tree[1:])
    return _assumes_always(tree)


def _integers(statement: Mapping[str, Any], sizes: Mapping[str, int]) -> Iterator[dict[str, int]]:
    """Every value of the integer variables, for given sizes."""
    def extend(values: dict[str, int], rest: list) -> Iterator[dict[str, int]]:
        if not rest:
            yield values
            return
        (name, (_, low, high)), *later = rest
        world = World(statement, values)
        for k in indices(world.integer(low, {}), world.integer(high, {})):
            yield from extend({**values, name: k}, later)

    yield from extend(dict(sizes), [v for v in statement["over"] if v[1][0] == "integer"])


def _sizes(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[dict[str, int]]:
    cases = [dict(c) for c in evidence["cases"]]
    _need(len(cases) > 0, "no case")
    for case in cases:
        _need(set(case) == set(statement["sizes"]) and all(type(v) is int and v >= 0 for v in case.values()), f"case {case} does not set the sizes")
    return cases


def _evaluation(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    _need(all(kind[0] == "integer" for _, kind in statement["over"]), "a variable is not an integer")
    reached = 0
    for case in _sizes(statement, evidence):
        for values in _integers(statement, case):
            world = World(statement, {**values, "horizon": None})
            if admissible(statement, world):
                continue
            _need(world.value(statement["says"]) is True, f"the conclusion does not hold at {values}")
            reached += 1
    _need(reached > 0, "no admissible case")
    return []


# ---------------------------------------------------------------------- evidence with symbols
def _cases(statement: Mapping[str, Any], evidence: Mapping[str, Any], given_by: Mapping[str, Any] | None = None) -> Iterator[tuple[World, SymbolicField]]:
    told, reached = evidence.get("cancelled"), False
    trials = told if isinstance(told, Trials) else Trials(told)
    for case in _sizes(statement, evidence):
        for values in _integers(statement, case):
            field, reached = SymbolicField(trials), True
            yield generic(statement, values, given_by, field.variable)[0], field
    _need(reached, "no case")


def _denominators(field: SymbolicField) -> list[str]:
    return [field.text(f) for f in field.factors]


def _collect(into: list[str], field: SymbolicField) -> None:
    into.extend(t for t in _denominators(field) if t not in into)


def _nothing_new(statement: Mapping[str, Any], world: World, field: SymbolicField, new: set[int]) -> None:
    """What the evidence divides by, and the statement does not, is something that the statement says not to vanish."""
    if new:
        new -= {index for x in _not_zero(statement, world) if isinstance(x, Symbolic) for index, _ in field.factor(x.num)}
    _need(not new, f"the evidence divides by {', '.join(field.text(field.factors[index]) for index in sorted(new))}, which may vanish")


def _divisors(x: Any, below: Laurent | None = None) -> set[int]:
    """Factors of the denominators in a value; a polynomial in z among them divides ``below``, which the statement divides by."""
    if isinstance(x, Matrix):
        return {index for r in x.rows for y in r for index in _divisors(y, below)}
    if isinstance(x, Ratio):
        if len(x.den.c) > 1:
            _need(below is not None, "the evidence divides by a polynomial in z, which may vanish")
            quotient, rest = divmod_poly(*(p.shift(-p.order).dense() for p in (below, x.den)))  # type: ignore[union-attr]
            _need(not rest, "the evidence divides by a polynomial in z, which may vanish")
            return _divisors(x.num) | _divisors(Laurent(dict(enumerate(quotient))))
        x = x.num
    if isinstance(x, Laurent):
        return {index for y in x.c.values() for index in _divisors(y)}
    return {index for index, _ in x.den} if isinstance(x, Symbolic) else set()


def _coefficient_divisors(x: Any) -> set[int]:
    """Factors of the denominators of coefficients in a value of the statement."""
    if isinstance(x, Matrix):
        return {index for r in x.rows for y in r for index in _coefficient_divisors(y)}
    if isinstance(x, Ratio):
        return _divisors(x.num) | _divisors(x.den)
    return _divisors(x)


def _not_zero(statement: Mapping[str, Any], world: World) -> Iterator[Any]:
    """Numbers that are not zero by the types and the hypotheses."""
    todo: list[Any] = [(["invertible", ["sym", name]], {}) for name, kind in statement["over"] if kind[0] in ("nonzero", "positive", "nonsingular", "pd")]
    todo.extend((formula, {}) for _, formula, _ in statement["given"])
    while todo:
        tree, local = todo.pop()
        op = tree[0]
        if op == "and":
            todo.extend((x, local) for x in tree[1:])
        elif op == "forall":
            low, high = (world.integer(x, local) for x in tree[2:4])
            todo.extend((tree[4], {**local, tree[1]: k}) for k in indices(low, high))
        with suppress(Unknown, Undefined):  # such as an absolute value
            if op in ("!=", "<", ">") and len(tree) == 3:
                yield world.value(["-", *tree[1:]], local)
            elif op in ("invertible", "pd"):
                yield world.value(["det", tree[1]], local)
            elif op == "=" and len(tree) == 3 and isinstance(tree[1], list) and tree[1][0] == "rank":
                m, rank = world.value(tree[1][1], local), world.value(tree[2], local)
                if isinstance(m, Matrix) and rank in (m.nrows, m.ncols):  # then the Gram determinant is positive
                    yield (m * m.transpose() if rank == m.nrows else m.transpose() * m).determinant()


def _identity(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    found: list[str] = []
    given_by = evidence.get("given_by") or {}
    covered_by = evidence.get("covered_by") or ""
    _need(isinstance(covered_by, str) and (covered_by.strip() != "" or _is_said(statement, given_by)),
          "a parametrisation needs the claim that says it reaches everything")
    parameters, own = evidence.get("parameters") or [], evidence.get("where") or []
    taken = {*statement["sizes"], *(d[1] for d in [*statement["where"], *own])}
    _need(not taken & set(given_by), "a parametrisation redefines a name")
    made = {**statement, "over": [*parameters, *statement["over"]], "where": [*statement["where"], *own]}
    for case in _sizes(statement, evidence):
        _need(any(True for _ in _integers({**statement, "over": parameters}, case)), f"a parameter has no value for {case}")
    for world, field in _cases(made, evidence, given_by):
        for d in own:  # definitions for the parametrisation alone: the statement must have a value without them
            del world.definitions[d[1]]
        world.memory = {key: value for key, value in world.memory.items() if key[0] in world.definitions}
        _need(world.value(statement["says"]) is True, f"not an identity for {_ints(world)}")
        _collect(found, field)
    return found


def _ints(world: World) -> dict[str, int]:
    return {k: v for k, v in world.values.items() if isinstance(v, int) and k != "horizon"}


def _residuals(world: World, tree: Any, local: Mapping[str, Any] | None = None) -> Iterator[Any]:
    """Left minus right side of every equation in a conjunction, in order: what comes after need not have a value where one is false."""
    op = tree[0]
    if op == "and":
        for part in tree[1:]:
            yield from _residuals(world, part, local)
    elif op == "forall":
        _, index, low, high, body = tree
        for k in indices(world.integer(low, local or {}), world.integer(high, local or {})):
            yield from _residuals(world, body, {**(local or {}), index: k})
    elif op == "=":
        values = [world.value(x, local) for x in tree[1:]]
        yield from (x - y for x, y in zip(values, values[1:], strict=False))
    elif op == "symmetric":
        m = world.value(tree[1], local)
        yield m - m.transpose()
    elif op == "symplectic":
        m = world.value(tree[1], local)
        _need(m.nrows == m.ncols and m.nrows % 2 == 0, "a symplectic matrix has an even number of rows, and as many columns")
        j = symplectic_form(m.nrows // 2)
        yield m.transpose() * j * m - j
    else:
        raise Unknown(f"{op!r} is not an equation")


def _never_zero(statement: Mapping[str, Any], world: World, field: SymbolicField, known: int, names: list[str]) -> set[int]:
    """Factors of the states that never vanish: not at 0, nor at t + 1 where not at t and all has a value."""
    t = _GENERIC_T
    out: set[int] = set()
    allowed = set(range(known)) | {index for x in _not_zero(statement, world) if isinstance(x, Symbolic) for index, _ in field.factor(x.num)}
    for name in names:
        start, now, then = (world.call(name, (k,)) for k in (0, t, t + 1))
        if not all(isinstance(x, Symbolic) for x in (now, then)) or start == 0:
            continue
        own = {index for index, _ in field.factor(now.num)}
        first = {index for index, _ in field.factor(start.num)} if isinstance(start, Symbolic) else set()
        if first <= allowed and {index for index, _ in field.factor(then.num)} <= allowed | own:
            out |= own
    return out


def _zero(x: Any) -> bool:
    if isinstance(x, Matrix):
        return all(y == 0 for r in x.rows for y in r)
    return x == 0


def _combination(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    found: list[str] = []
    hypotheses = {label: formula for label, formula, _ in statement["given"]}
    for world, field in _cases(statement, evidence):
        goals = [(goal, set(range(len(field.factors)))) for goal in _residuals(world, statement["says"])]  # with what has been divided by until then
        _need(len(goals) == len(evidence["terms"]), "as many lists of terms as equations are needed")
        used = dict.fromkeys(label for terms in evidence["terms"] for _, label, _ in terms)  # in their order, as what is told of cancelling is
        before, new = len(field.factors), set[int]()
        residual = {label: list(_residuals(world, hypotheses[label.removesuffix("'")])) for label in used}
        granted = set(range(before, len(field.factors))) | {index for h in residual.values() for r in h for index in _coefficient_divisors(r)}
        for (goal, known), terms in zip(goals, evidence["terms"], strict=True):
            rest, divisors = goal, set[int]()
            for left, label, right in terms:
                (h,) = residual[label]
                h = h.transpose() if label.endswith("'") else h
                sides = [world.value(x) for x in (left, right)]
                for x in sides:
                    divisors |= _divisors(x, goal.den if isinstance(goal, Ratio) else None)
                rest = rest - sides[0] * h * sides[1]
            _need(_zero(rest), f"the combination does not add up for {_ints(world)}")
            new |= divisors - known - granted
        _nothing_new(statement, world, field, new)
        _collect(found, field)
    return found


def _positivity(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    found: list[str] = []
    op, lhs, rhs = statement["says"]
    _need(op in (">", ">=", "<", "<="), "the conclusion is not an inequality between two terms")
    if op in ("<", "<="):
        lhs, rhs = rhs, lhs
    hypotheses = {label: formula for label, formula, _ in statement["given"]}
    hypotheses.update({name: [">" if kind[0] == "positive" else ">=", ["sym", name], 0]
                       for name, kind in statement["over"] if kind[0] in ("positive", "nonneg")})
    for world, field in _cases(statement, evidence):
        rest, strict = world.value(lhs) - world.value(rhs), False
        used = {label for _, _, labels in evidence["terms"] for label in labels}
        sides = {label: [world.value(x) for x in hypotheses[label][1:]] for label in used}
        known, divisors = len(field.factors), set[int]()
        for c, q, labels in evidence["terms"]:
            c = Fraction(world.value(c))
            _need(c >= 0, "a coefficient is negative")
            term, positive = world.value(q), c > 0
            _need(not isinstance(term, (Laurent, Ratio)), "a square of a polynomial in z has no sign")
            divisors |= _divisors(term)
            positive = positive and isinstance(term, (int, Fraction)) and term != 0
            term = c * (term * term)
            for label in labels:
                relation, (x, y) = hypotheses[label][0], sides[label]
                _need(relation in (">", ">=", "<", "<="), f"hypothesis {label!r} is not an inequality")
                gap = x - y
                term = term * (gap if relation in (">", ">=") else -gap)
                positive = positive and relation in (">", "<")
            strict = strict or positive
            rest = rest - term
        _need(_zero(rest), f"the terms do not add up for {_ints(world)}")
        _need(strict or op in (">=", "<="), "no term is strictly positive")
        _nothing_new(statement, world, field, divisors - set(range(known)))
        _collect(found, field)
    return found


# ---------------------------------------------------------------------- induction
def _fresh(like: Any, name: str, field: SymbolicField) -> Any:
    """A value of the same shape with a new symbol in every place."""
    if isinstance(like, Matrix):
        return Matrix.build(like.nrows, like.ncols, lambda i, j: _fresh(like.rows[i][j], f"{name}_{i + 1}{j + 1}", field))
    if isinstance(like, Laurent):
        return Laurent({k: field.variable(f"{name}_{k}") for k in like.c})
    if isinstance(like, Ratio):
        raise Unknown("a state with quotients in z")
    return field.variable(name)


def _fits(value: Any, like: Any) -> bool:
    """The value is an instance of the shape."""
    if isinstance(like, Matrix):
        return isinstance(value, Matrix) and (value.nrows, value.ncols) == (like.nrows, like.ncols) and all(
            _fits(x, y) for r, s in zip(value.rows, like.rows, strict=True) for x, y in zip(r, s, strict=True))
    if isinstance(like, Laurent):
        return not isinstance(value, (Matrix, Ratio)) and set(Laurent.of(value).c) <= set(like.c)
    return not isinstance(value, (Matrix, Laurent, Ratio))


def _index_only(tree: Any, index: str) -> bool:
    """The index occurs in arguments of sequences and definitions alone."""
    if isinstance(tree, (int, str)):
        return True
    if tree and tree[0] == "sym":
        return tree[1] != index
    if tree and tree[0] == "at":
        return all(not _mentions(a, index) or _is_shift(a, index) for a in tree[2:])
    return all(_index_only(x, index) for x in tree)  # the first too: of a row of a block it is no operation


def _mentions(tree: Any, index: str) -> bool:
    if isinstance(tree, (int, str)):
        return False
    return tree[:2] == ["sym", index] or any(_mentions(x, index) for x in tree)


def _is_shift(tree: Any, index: str) -> bool:
    """t, t + k or t - k for an integer k."""
    return tree == ["sym", index] or (tree[0] in "+-" and len(tree) == 3 and tree[1] == ["sym", index] and isinstance(tree[2], int))


def _called_with_index(statement: Mapping[str, Any], body: Any, index: str) -> list[tuple[list, str]]:
    """Functions with the parameters that may be handed the index, directly or through other functions."""
    functions = {d[1]: d for d in statement["where"] if d[0] == "let" and d[2]}
    reached: dict[str, set[str]] = {}
    todo = [(body, {index}), *((d[5], {d[2]}) for d in statement["where"] if d[0] == "rec")]
    while todo:
        tree, names = todo.pop()
        if isinstance(tree, (int, str)):
            continue
        if tree and tree[0] == "at" and tree[1] in functions:
            d = functions[tree[1]]
            handed = {p for p, a in zip(d[2], tree[2:], strict=False) if any(_mentions(a, n) for n in names)}
            known = reached.setdefault(tree[1], set())
            if not handed <= known:
                known |= handed
                todo.append((d[3], set(known)))
        todo.extend((x, names) for x in tree)
    return [(functions[name], p) for name, handed in reached.items() for p in sorted(handed)]


def _induction(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    found: list[str] = []
    op, index, said = statement["says"]
    _need(op == "always", "the conclusion is not of the form 'for all t'")
    body = said
    if evidence.get("also"):  # a stronger statement, which the induction proves along with the conclusion
        for formula in evidence["also"]:
            check_formula(statement, formula, index)
        body = ["and", *(body[1:] if body[0] == "and" else [body]), *evidence["also"]]
    recursions = [d for d in statement["where"] if d[0] == "rec"]
    _need(bool(recursions), "no recursion")
    _need(_index_only(body, index), "the index is used other than as an index")
    _need(set(evidence.get("support") or {}) <= {d[1] for d in recursions}, "exponents are given of what is no recursion")
    for d in recursions:
        _need(d[3] == 0 and len(d[4]) == 1, f"recursion {d[1]} does not start with one value at 0")
        _need(_index_only(d[5], d[2]), f"recursion {d[1]} uses its index other than as an index")
    for d, parameter in _called_with_index(statement, body, index):
        _need(_index_only(d[3], parameter), f"definition {d[1]} uses an index other than as an index")
    for world, field in _cases(statement, evidence):
        list(_residuals(world, said, {index: 0}))
        known = len(field.factors)
        _need(all(_zero(r) for r in _residuals(world, body, {index: 0})), f"base: t = 0 fails for {_ints(world)}")
        _nothing_new(statement, world, field, set(range(known, len(field.factors))))
        shapes = {d[1]: world.call(d[1], (0,)) for d in recursions}
        for name, support in (evidence.get("support") or {}).items():
            shapes[name] = Laurent({k: 1 for k in support})
        _step(world, field, statement, evidence, index, said, body, recursions, shapes)
        _collect(found, field)
    return found


def _step(world: World, field: SymbolicField, statement: Mapping[str, Any], evidence: Mapping[str, Any], index: str, said: Any,
          body: Any, recursions: list, shapes: Mapping[str, Any]) -> None:
    """From t to t + 1, t generic."""
    t = _GENERIC_T
    for d in recursions:
        _need(_fits(world.call(d[1], (0,)), shapes[d[1]]), f"step: {d[1]} at 0 does not have the shape of the state")
    generic = {(name, (t,)): _fresh(shape, name, field) for name, shape in shapes.items()}
    world.memory = dict(generic)
    parts = body[1:] if body[0] == "and" else [body]
    divisors: set[int] = set()
    for k in evidence.get("solve") or []:
        eq = parts[k]
        _need(eq[0] == "=" and len(eq) == 3 and eq[1][0] == "at" and eq[1][2:] == [["sym", index]] and eq[1][1] in shapes,
              "step: only an equation X[t] = term can be solved for X[t]")
        del world.memory[eq[1][1], (t,)]
        solved = world.value(eq[2], {index: t})
        if isinstance(solved, Matrix):
            solved = solved.map(lambda x: x)  # every entry, before what is remembered changes
        divisors |= set() if k < len(parts) - len(evidence.get("also") or []) else _divisors(solved)
        world.memory = {key: v for key, v in world.memory.items() if key[0] in shapes and key[1] == (t,)}
        world.memory[eq[1][1], (t,)] = solved
    list(_residuals(world, said, {index: t}))
    # for each equation, what has been divided by until then, and the states that have a value: where it is false the next need not have one
    stages = [(len(field.factors), [name for name in shapes if (name, (t + 1,)) in world.memory]) for _ in _residuals(world, said, {index: t + 1})]
    known, _ = stages[-1]
    before = [r for p in parts for r in _residuals(world, p, {index: t})]
    after = [r for p in parts for r in _residuals(world, p, {index: t + 1})]
    divisors |= set(range(known, len(field.factors)))
    stages += stages[-1:] * (len(after) - len(stages))
    cofactors = evidence.get("cofactors") or [[] for _ in after]
    _need(len(cofactors) == len(after), "step: as many lists of cofactors as equations are needed")
    new = list[tuple[set[int], list[str]]]()
    for rest, terms, (until, reached) in zip(after, cofactors, stages, strict=True):
        used = set(divisors)
        for left, k, right in terms:
            sides = [world.value(x, {index: t}) for x in (left, right)]
            used |= _divisors(sides[0]) | _divisors(sides[1])
            rest = rest - sides[0] * before[k] * sides[1]
        _need(_zero(rest), f"step: t -> t + 1 fails for {_ints(world)}")
        new.append((used - set(range(until)), reached))
    if any(used for used, _ in new):  # the states until t are not zero where the conclusion is true and has a value until then
        never = _never_zero(statement, world, field, known, [d[1] for d in recursions])
        new = [(used - never, reached) for used, reached in new]
    if any(used for used, _ in new):  # a state has a value only if all its entries have, those not looked at above too
        kept, world.memory = world.memory, dict(generic)
        below = {name: _divisors(world.call(name, (t + 1,))) for name in stages[-1][1]}
        new = [(used - {index for name in reached for index in below[name]}, reached) for used, reached in new]
        world.memory = kept
    _nothing_new(statement, world, field, set[int]().union(*(used for used, _ in new)))
    for d in recursions:
        _need(_fits(world.call(d[1], (t + 1,)), shapes[d[1]]), f"step: {d[1]} leaves the shape of the state")


# ---------------------------------------------------------------------- orbits
def _orbit(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> list[str]:
    check_answer(statement, evidence)
    return []


def _need(condition: bool, step: str) -> None:
    if not condition:
        raise Rejected(step)


_KINDS = {
    "instances": _instances, "counterexample": _counterexample, "evaluation": _evaluation, "identity": _identity,
    "combination": _combination, "positivity": _positivity, "induction": _induction, "orbit": _orbit, "existence": existence, **KINDS,
}
