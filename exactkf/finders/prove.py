# SPDX-License-Identifier: MIT
"""Candidates for proof certificates.

A finder here only proposes: it turns hints into certificates, cheapest first,
and for inductions it tries the usual uses of the induction hypothesis. The
checker decides.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from itertools import chain, combinations, product
from typing import Any

from exactkf.evidence import Evidence
from exactkf.finders.arithmetic import find_arithmetic
from exactkf.finders.membership import find_induction, find_membership, find_order
from exactkf.kernel.continuity import away_from_zero
from exactkf.kernel.every_size import members_of
from exactkf.kernel.numbers import Undefined, Unknown
from exactkf.kernel.replay import NotACertificate, Rejected, replay, seal

__all__ = ["PROOFS", "candidates", "every_size", "replays"]

PROOFS = ("identity", "combination", "induction", "positivity", "evaluation")


def candidates(id: str, statement: Mapping[str, Any], evidence: Evidence) -> Iterator[dict]:
    """Certificates to try for one piece of evidence."""
    cases = _cases(statement, evidence.hints["sizes"])
    match evidence.kind:
        case "identity":
            hints = evidence.hints
            made = {"cases": cases, "given_by": hints["given_by"], "covered_by": hints["covered_by"] or hints.get("fact", "")}
            if hints.get("parameters"):
                made["parameters"] = [[name, kind] for name, kind in hints["parameters"].items()]
            if hints.get("where"):
                made["where"] = hints["where"]
            yield seal(id, "identity", statement, made)
        case "combination":
            yield seal(id, "combination", statement, {"cases": cases, "terms": _per_equation(evidence.hints["terms"])})
        case "positivity":
            yield seal(id, "positivity", statement, {"cases": cases, "terms": evidence.hints["terms"]})
        case "evaluation":
            yield seal(id, "evaluation", statement, {"cases": cases})
        case "induction" if evidence.hints["sizes"] or not statement["sizes"]:
            given = {key: evidence.hints[key] for key in ("also", "cofactors") if evidence.hints.get(key)}
            for use in [{}] if "cofactors" in given else _uses(statement, given.get("also", ())):
                yield seal(id, "induction", statement, {"cases": cases, **given, **use})


def every_size(id: str, statement: dict, by: Sequence[Evidence], seconds: float, degree: int = 8) -> Iterator[dict]:
    """Certificates to try that hold for every size at once."""
    for e in by:
        if e.kind == "generic index":
            yield seal(id, "generic index", statement, e.hints)
        if e.kind == "arithmetic" and "member" not in e.hints and (proof := _refuted(statement, e, seconds)) is not None:
            yield seal(id, "arithmetic", statement, {"proof": proof})
    if not statement["sizes"]:
        yield from _by_members(id, statement, by, seconds, degree)
        return
    hints: dict[str, Any] = {e.kind: json.loads(json.dumps(dict(e.hints), default=dict)) for e in reversed(by) if e.kind in ("order", "induction")}
    asked = hints.get("order", {})
    ways = [_by_membership, _by_order]
    if any(asked.get(key) for key in ("sums", "lemmas", "inside", "factors")):  # hints are for an order
        ways.reverse()
    led = hints.get("induction", {})
    if "order" not in hints and (led.get("base") or led.get("before")):  # hints are for an induction
        ways.insert(0, partial(_by_induction, led=led))
    else:
        ways.append(partial(_by_induction, led=led))
    for way in ways:
        yield from way(id, statement, asked, seconds, degree)
    yield from _by_members(id, statement, by, seconds, degree)


def _refuted(statement: dict, evidence: Evidence, seconds: float) -> dict[str, Any] | None:
    """A refutation of the denied statement, by the hints of an `arithmetic`."""
    return find_arithmetic(statement, json.loads(json.dumps(evidence.hints["proof"])), 10 * seconds)


def _by_induction(id: str, statement: dict, _asked: Mapping[str, Any], seconds: float, _degree: int, led: Mapping[str, Any]) -> Iterator[dict]:
    if (_has_index(statement["says"]) or led.get("before")) and (found := find_induction(statement, led, seconds=seconds)) is not None:
        yield seal(id, "word induction", statement, found)


def _by_membership(id: str, statement: dict, _asked: Mapping[str, Any], seconds: float, degree: int) -> Iterator[dict]:
    if (terms := find_membership(statement, degree, seconds)) is not None:
        yield seal(id, "membership", statement, {"terms": terms})


def _by_order(id: str, statement: dict, asked: Mapping[str, Any], seconds: float, degree: int) -> Iterator[dict]:
    sums, roots, lemmas, factors, inside, stable = (asked.get(key, []) for key in ("sums", "roots", "lemmas", "factors", "inside", "stable"))
    more = {"inside": inside} if inside else {}
    shown = statement
    try:
        if away := asked.get("away"):
            shown, more = away_from_zero(statement, away), {**more, "away from zero": away}
        parts = find_order(shown, sums, roots, lemmas, degree, seconds, factors, inside, stable)
    except (Unknown, Undefined):  # a wrong neighbour may be no statement that the hints are for
        return
    if parts is not None:
        yield seal(id, "order", statement, {"parts": parts, "lemmas": lemmas, **more})


def _by_members(id: str, statement: dict, by: Sequence[Evidence], seconds: float, degree: int) -> Iterator[dict]:
    """Each member of a conjunction in its own way, where some are about entries and some about words."""
    generic = [e for e in by if e.kind == "generic index"]
    numbers = [e for e in by if e.kind == "arithmetic" and "member" in e.hints]
    if statement["says"][0] != "and" or not (generic or numbers):
        return
    parts = []
    for place, member in enumerate(members_of(statement["says"])):
        own = {**statement, "says": member}
        found = (_refuted(own, e, seconds) for e in numbers if e.hints["member"] == place)
        arithmetic = (seal(id, "arithmetic", own, {"proof": proof}) for proof in found if proof is not None)
        words = (way(id, own, {}, seconds, degree) for way in (_by_membership, _by_order))
        tried = chain(arithmetic, (seal(id, "generic index", own, e.hints) for e in generic), *words)
        proof = next((c for c in tried if replays(c)), None)
        if proof is None:
            return
        parts.append([proof["kind"], proof["evidence"]])
    yield seal(id, "conjunction", statement, {"parts": parts})


def replays(certificate: dict) -> bool:
    """Whether the checker accepts a candidate."""
    try:
        replay(certificate)
    except (Rejected, NotACertificate):
        return False
    return True


def _has_index(tree: Any) -> bool:
    return isinstance(tree, list) and (tree[:1] in (["always"], ["forall"]) or any(map(_has_index, tree)))


def _cases(statement: Mapping[str, Any], sizes: Mapping[str, Any]) -> list[dict[str, int]]:
    names = list(statement["sizes"])
    return [dict(zip(names, values, strict=True)) for values in product(*(sizes.get(n, (1,)) for n in names))]


def _per_equation(terms: Any) -> list:
    """A list of terms for one equation, or a list of such lists."""
    if not terms:
        return [[]]
    first = terms[0]
    flat = len(first) == 3 and isinstance(first[1], str)
    return [list(terms)] if flat else [list(t) for t in terms]


def _uses(statement: Mapping[str, Any], also: Sequence[Any] = ()) -> Iterator[dict]:
    """Ways to use the induction hypothesis: not at all, as an invariant, solved for states, both."""
    if statement["says"][0] != "always":
        return
    body = statement["says"][2]
    parts = [*(body[1:] if body[0] == "and" else [body]), *also]
    invariant = [[[1, k, 1]] for k in range(len(parts))]
    solvable = [k for k, p in enumerate(parts) if p[0] == "=" and len(p) == 3 and isinstance(p[1], (list, tuple)) and p[1][0] == "at"]
    for supports in _supports(statement):
        yield {**supports}
        yield {**supports, "cofactors": invariant}
        for size in range(1, len(solvable) + 1):
            for chosen in combinations(solvable, size):
                yield {**supports, "solve": list(chosen)}
                yield {**supports, "solve": list(chosen), "cofactors": [[] if k in chosen else t for k, t in enumerate(invariant)]}


def _supports(statement: Mapping[str, Any]) -> Iterator[dict]:
    """Exponents of z a polynomial state may have: as at t = 0."""
    yield {}
