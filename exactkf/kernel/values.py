# SPDX-License-Identifier: MIT
"""What has a value, for `exactkf.kernel.arithmetic`: ``defined``, and what follows from it that a formula has a truth value.

There, a quotient by zero is any number. But on an instance of a statement its hypotheses are true and its conclusion is false,
and so all that is evaluated on the way has a value: both sides of a relation; all members of a conjunction that is true, and
the one of a false conjunction that is false; in the same way disjunctions, implications and quantifiers. `evaluated` says of a formula
that it is true, or false, in that sense: the fact that `Facts.read` makes of it, and with each relation that the denominators
in it are not zero, written (1/y) y = 1 (which is 0 = 1 for y = 0, whatever number 1/0 is) and (x/y) y = x.

A value of a recursion exists or not: the atom ("def", X, k) is the number 1 or 0. `existence` tells which by the definition of X: before its start
there is no value; an initial value, or one made by the step, exists if and only if the term has a value, which `conditions` takes apart:
a term of the operations listed has a value if and only if its parts have, what it divides by is not zero, and the n of cos(a/n) is positive.

Main definitions
----------------
`evaluated`
    A formula as a fact about an instance on which it is evaluated.
`has_value`
    ``defined(x)``, or its negation, as a fact.
`existence`
    What the definition of a recursion tells of the existence of one of its values.
"""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, Any

from exactkf.kernel.facts_on_circle import in_z
from exactkf.kernel.numbers import Unknown
from exactkf.kernel.polynomial_facts import ONE, Fact, Names, Poly, either, frozen, joined, number, plus, times

if TYPE_CHECKING:
    from exactkf.kernel.arithmetic import Facts

__all__ = ["evaluated", "existence", "has_value"]

_OPPOSITE = {"and": "or", "or": "and"}
_RELATIONS = {"=", "!=", "<", "<=", ">", ">=", "pos_circle", "nonneg_circle", "schur"}
#: they have a value if and only if their arguments have
_TOTAL = {"+", "-", "*", "neg", "abs"}


# ---------------------------------------------------------------------- formulas
def evaluated(facts: Facts, tree: Any, affirmed: bool, names: Names) -> Fact:
    """A formula that is true, or false, on an instance on which all that decides it has a value."""
    op = tree[0]
    if op == "not":
        return evaluated(facts, tree[1], not affirmed, names)
    if op in ("and", "or"):
        return joined(op if affirmed else _OPPOSITE[op], [evaluated(facts, x, affirmed, names) for x in tree[1:]])
    if op == "=>":
        return evaluated(facts, ["or", ["not", tree[1]], tree[2]], affirmed, names)
    if op == "<=>":
        return joined("or", [joined("and", [evaluated(facts, tree[1], x, names), evaluated(facts, tree[2], x == affirmed, names)]) for x in (True, False)])
    if op in ("sym", "at"):
        body, inner = facts.opened(tree, names)
        return joined("and", [evaluated(facts, body, affirmed, inner), *(f for x in tree[2:] for f in needed(facts, x, names))])
    fact = facts.read(tree, affirmed, names, True)
    if op in _RELATIONS:
        return joined("and", [fact, *(f for x in tree[1:] for f in needed(facts, x, names))])
    if op in ("forall", "exists"):
        return joined("and", [fact, *(f for x in tree[2:4] for f in needed(facts, x, names))])
    return fact


def needed(facts: Facts, tree: Any, names: Names) -> list[Fact]:
    """Facts without which a term has no value; perhaps not all there are."""
    if type(tree) is int or tree[0] in ("rat", "z"):
        return []
    op = tree[0]
    if op in ("sym", "at"):
        if tree[1] in names or (d := facts.definitions.get(tree[1])) is None:
            return []
        inside = [f for x in tree[2:] for f in needed(facts, x, names)]
        if d[0] == "rec":
            return [*inside, _exists(facts, tree[1], facts.term(tree[2], names), True)]
        body, inner = facts.opened(tree, names)
        return [*inside, *needed(facts, body, inner)]
    if op == "if":
        return []
    found = [f for x in tree[1:] for f in needed(facts, x, names)] if op in _TOTAL or op in ("/", "sqrt", "recip") else (
        needed(facts, tree[1], names) if op == "^" else [])
    if op == "/" and not in_z(facts, tree[2], names):
        found += _divided(facts, [] if in_z(facts, tree[1], names) else facts.cases(tree[1], names), facts.cases(tree[2], names))
    if op == "sqrt":
        found += [either([(c, joined("and", root(facts, p))) for c, p in facts.cases(tree[1], names)])]
    return found


def _divided(facts: Facts, over: list, under: list) -> list[Fact]:
    """x/y has a value: y is not zero."""
    cases = []
    for (c, x), (d, y) in product(over or [((), ONE)], under):
        equations = [facts.relation("=", plus(times(facts.quotient(z, y), y), z, -1)) for z in (x, ONE)]
        cases.append(((*c, *d), joined("and", [f for f in equations if f[1]])))
    return [either(cases)]


def root(facts: Facts, x: Poly) -> list[Fact]:
    """x >= 0, and what the square root of it is then."""
    s = facts.atom("sqrt", frozen(x))
    return [facts.relation(">=", x), facts.relation(">=", s), facts.relation("=", plus(times(s, s), x, -1))]


# ---------------------------------------------------------------------- terms
def has_value(facts: Facts, tree: Any, affirmed: bool, names: Names) -> Fact:
    """Whether a term has a value."""
    pairs = conditions(facts, tree, names)
    return joined("and", [yes for yes, _ in pairs]) if affirmed else joined("or", [no for _, no in pairs])


def conditions(facts: Facts, tree: Any, names: Names) -> list[tuple[Fact, Fact]]:
    """Facts, with their negations, that are all true if and only if a term has a value."""
    if type(tree) is int or tree[0] == "rat":
        return []
    op = tree[0]
    if op in ("sym", "at"):
        if tree[1] in names:
            if len(tree) > 2:
                raise Unknown("a variable with an index")
            return []
        inside = [pair for x in tree[2:] for pair in conditions(facts, x, names)]
        if facts.definitions.get(tree[1], ("",))[0] == "rec" and len(tree) == 3:
            at = facts.term(tree[2], names)
            return [*inside, (_exists(facts, tree[1], at, True), _exists(facts, tree[1], at, False))]
        body, inner = facts.opened(tree, names)
        return [*inside, *conditions(facts, body, inner)]
    if op in _TOTAL:
        return [pair for x in tree[1:] for pair in conditions(facts, x, names)]
    if op == "^" and type(tree[2]) is int and tree[2] >= 0:
        return conditions(facts, tree[1], names)
    if op in ("/", "cospi"):
        under = facts.cases(tree[2], names)
        no, yes = (either([(c, facts.relation(sign, y)) for c, y in under]) for sign in (("=", "!=") if op == "/" else ("<=", ">")))
        if op == "cospi" and not all(facts.is_whole(p) for x in tree[1:] for _, p in facts.cases(x, names)):
            raise Unknown("the cosine of an angle that need not be a rational multiple of pi")
        return [*(pair for x in tree[1:] for pair in conditions(facts, x, names)), (yes, no)]
    raise Unknown(f"whether {op!r} has a value")


def _exists(facts: Facts, name: str, at: Poly, affirmed: bool) -> Fact:
    if name in facts.circular or not facts.is_whole(at):
        raise Unknown(f"a value of {name!r}, which leads back to itself, or not at an integer")
    return facts.relation("=", plus(facts.atom("def", name, frozen(at)), number(int(affirmed)), -1))


def existence(facts: Facts, name: str, at: Poly) -> Fact:
    """Before the start of a recursion there is no value; each other exists if and only if its term has a value."""
    before, places = facts.places(facts.definitions[name], at)
    cases = [joined("and", [where, _exists(facts, name, at, x), has_value(facts, tree, x, inner)]) for where, tree, inner in places for x in (True, False)]
    return ("or", [joined("and", [before, _exists(facts, name, at, False)]), *cases])
