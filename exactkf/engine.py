# SPDX-License-Identifier: MIT
"""From a claim to its verdict.

Cheap refutation comes first: exact instances, the small and the hand-made
ones before the random ones. Only what survives is proved. Whatever a finder
proposes becomes a certificate, and counts only after the checker has replayed
it. Then the mutants: each must be refuted on an instance or be shown equal to
the original, or the claim is `open`.

Main definitions
----------------
`verify_claim`
    The result of one claim, plain JSON.
`mutate_claim`
    Its mutants, one row each.
`verify_statement`
    The same for any `exactkf.language.Statement`, such as a user's own lemma.
"""

from __future__ import annotations

import json
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from flint import fmpq

from exactkf._errors import BadInput
from exactkf._wording import proof_in_words
from exactkf.claims import Claim, checked_evidence, find, load
from exactkf.evidence import Evidence
from exactkf.finders.cases import with_cases
from exactkf.finders.draw import Sampler, examples_of
from exactkf.finders.effort import counted
from exactkf.finders.mutants import MutantReport, judge_mutants
from exactkf.finders.prove import PROOFS, candidates, every_size
from exactkf.kernel.existence import THEOREMS
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import Undefined, Unknown, rationals
from exactkf.kernel.replay import NotACertificate, Rejected, replay, seal
from exactkf.kernel.trials import Trials
from exactkf.language import Statement

__all__ = ["STRENGTHS", "mutate_claim", "verify_claim", "verify_statement"]

#: strongest first
STRENGTHS = ("proved", "proved-sizes", "steps", "instances", "enclosed")

_WITNESSES = 3  # instances kept beside a proof
_TRIES = 150  # instances looked at in search of a counterexample
_PATIENCE = 60.0  # seconds after which the search stops once it has what the certificate needs; no claim on record takes as long


@dataclass
class Findings:
    """What is known of one statement."""

    verdict: str = "open"
    strength: str | None = None
    sizes: dict[str, list[int]] | None = None
    reason: str = ""
    certificates: list[dict] = field(default_factory=list)
    witness: dict | None = None
    counterexample: dict | None = None
    evidence: list[str] = field(default_factory=list)
    denominators: list[str] = field(default_factory=list)
    checks: int = 0
    shown: int = 0  # instances at the head of the list that go into the certificate
    drawn: list[tuple[dict, World]] = field(default_factory=list)
    sampler: Sampler | None = None


def verify_claim(claim: Claim | str, *, seed: int = 0) -> dict[str, Any]:
    """Verify one claim.

    Parameters
    ----------
    claim : Claim or str
        A claim, or the id of one of the papers', ``"BLZ94-E2.18"``.
    seed : int
        For random instances.

    Returns
    -------
    dict
        Plain JSON: the fields of the contract and what the report shows beside them.

    Raises
    ------
    BadInput
        If there is no such claim.

    Examples
    --------
    >>> verify_claim("B93-S23")["strength"]
    'proved'
    """
    return _verified(_claim(claim), seed)[0]


def _verified(claim: Claim, seed: int) -> tuple[dict[str, Any], MutantReport]:
    """The result, and each mutant: tens of thousands of them would fill what is kept."""
    _check_seed(seed)
    started = time.perf_counter()
    if claim.statement is None:
        return _result(claim, Findings(reason=claim.reason), None, MutantReport(), None, started), MutantReport()
    with rationals(fmpq), counted():  # the search; replaying goes back to Fraction by itself
        return _verify(claim, claim.statement, seed, started)


def _claim(claim: Claim | str) -> Claim:
    if isinstance(claim, Claim):
        return claim
    if not isinstance(claim, str):
        raise BadInput(f"argument 'claim' = {claim!r} is no claim; pass an id such as 'BLZ94-E2.18', or what exactkf.claims.claim returns")
    found = find([claim], load())
    if found[0].id != claim:
        raise BadInput(f"argument 'claim' = {claim!r} names {len(found)} claims; pass the id of one")
    return found[0]


def _verify(claim: Claim, statement: Statement, seed: int, started: float) -> tuple[dict[str, Any], MutantReport]:
    """Verdict on the print, then on the repair where the print fails; then the mutants."""
    found = _find(claim.id, statement, claim.by, seed)
    _bound(claim.by, found)
    repaired, report = None, MutantReport()
    if found.verdict == "fails" and claim.repair is not None:
        repaired = _find(f"{claim.id}#repair", claim.repair.statement, claim.repair.by, seed)
        _bound((*claim.by, *claim.repair.by), repaired)  # the correction of a part is one of that part
        if repaired.verdict == "holds":
            report = judge_mutants(claim.repair.statement.to_json(), claim.repair.by, repaired.drawn, repaired.sampler)
            _count_survivors(repaired, report)
    elif found.verdict == "holds":
        report = judge_mutants(statement.to_json(), claim.by, found.drawn, found.sampler)
        _count_survivors(found, report)
    return _result(claim, found, repaired, report, claim.repair, started), report


def verify_statement(statement: Statement, by: Evidence | Sequence[Evidence], *, id: str = "lemma", title: str = "", seed: int = 0) -> dict[str, Any]:
    """Verify a statement that belongs to no paper.

    Parameters
    ----------
    statement : Statement
        What is asserted, see `exactkf.language.Statement`.
    by : Evidence or sequence of Evidence
        What to look for, strongest first, see `exactkf.evidence`.
    id, title : str
        How the result names it.
    seed : int
        For random instances.

    Returns
    -------
    dict
        Plain JSON: ``verdict``, ``strength``, ``sizes``, ``reason``, ``counterexample``, ``certificates``, ``mutants`` and more.

    Raises
    ------
    BadInput
        If the evidence does not fit the statement.

    Examples
    --------
    >>> from exactkf.evidence import instances
    >>> from exactkf.language import Statement, T, matrix, symbols
    >>> n, P, Q = symbols("n P Q")
    >>> result = verify_statement(Statement(T(P * Q) == T(P) * T(Q), over={P: matrix(n, n), Q: matrix(n, n)}, sizes=[n]), instances(n=(1, 2)))
    >>> result["verdict"], result["counterexample"]["sizes"]["n"]
    ('fails', 2)
    """
    if not isinstance(statement, Statement):
        raise BadInput(f"argument 'statement' = {statement!r} is no statement; pass a Statement, or use prove_lemma for a text")
    return verify_claim(Claim(id, title or id, "", statement, checked_evidence(statement, by)), seed=seed)


def _check_seed(seed: Any) -> None:
    if isinstance(seed, bool) or not isinstance(seed, int) or seed < 0:
        raise BadInput(f"argument 'seed' = {seed!r} is no seed; give a whole number, 0 or more")


def mutate_claim(claim: Claim | str, *, seed: int = 0) -> dict[str, Any]:
    """The mutants of a claim (of its repair, where the print fails), one row each, with the instance on which it is false; see `verify_claim`."""
    claim = _claim(claim)
    result, report = _verified(claim, seed)
    judged = claim.repair.statement if claim.repair and result["repair"] else claim.statement
    return {"id": result["id"], "verdict": result["verdict"], **result["mutants"], "rows": report.printed(judged.tex if judged else None)}


def _count_survivors(found: Findings, report: MutantReport) -> None:
    found.checks += report.checks
    survivors = report.survivors
    if survivors:
        found.verdict, found.strength = "open", None
        found.reason = f"{len(survivors)} of {report.made} mutants survive: {survivors[0]}"
    elif report.neighbours_accepted < report.neighbours_made:
        found.verdict, found.strength, found.reason = "open", None, "an equal rewriting was not accepted"
    elif not report.rejected:
        found.verdict, found.strength, found.reason = "open", None, "no wrong neighbour was there to be rejected"


# ---------------------------------------------------------------------- one statement
def _find(id: str, statement: Statement, by: Sequence[Evidence], seed: int) -> Findings:
    data = statement.to_json()
    found = Findings()
    _search(id, data, by, seed, found)
    if found.verdict == "fails":
        return found
    _prove(id, data, by, found)
    if found.strength is None and not found.reason:
        tried = found.sampler.rejected if found.sampler else {}
        most = max(tried, key=lambda k: tried[k]) if tried else "no evidence of this kind applies"
        found.reason = f"vacuous: no admissible instance in {sum(tried.values())} tries ({most})"
    if found.strength is not None and not found.drawn:
        found.strength, found.certificates = None, []
        found.reason = "vacuous: no instance satisfies the hypotheses"
    found.verdict = "holds" if found.strength is not None else "open"
    return found


def _search(id: str, data: dict, by: Sequence[Evidence], seed: int, found: Findings) -> None:
    """Look for a counterexample; keep the instances on the way."""
    asked = [e.hints for e in by if e.kind == "instances"]
    kept: list[dict] = []
    undefined = ""
    examples = examples_of(tuple(by))
    for hints in asked or [_default_hints(by)]:
        sampler = Sampler(data, hints, examples, seed)
        found.sampler = found.sampler or sampler
        examples = []
        fault = _draw_from(sampler, id, data, hints.get("count", 12), kept, found)
        if found.verdict == "fails":
            return
        undefined = undefined or fault
        if sampler is not found.sampler:
            for reason, times in sampler.rejected.items():
                found.sampler.rejected[reason] = found.sampler.rejected.get(reason, 0) + times
    if not kept:
        found.evidence.append(f"no admissible instance{': ' + undefined if undefined else ''}")
        return
    found.witness = kept[0]
    if asked or not any(e.kind in PROOFS for e in by):
        wanted = sum(h["count"] for h in asked) if asked else 12
        certificate = seal(id, "instances", data, {"instances": kept[:wanted], "seed": seed, "searched": len(kept)})
        if _accept(certificate, found):
            found.strength = "instances"
            found.evidence.append(f"{min(len(kept), wanted)} exact instances replayed, {len(kept)} searched (seed {seed})")


def _draw_from(sampler: Sampler, id: str, data: dict, wanted: int, kept: list[dict], found: Findings) -> str:
    """Instances of one sampler: refute, or keep what is new. The first ``wanted`` of each sampler come before the others."""
    seen = {repr(instance) for instance in kept}
    fresh: list[dict] = []
    undefined = ""
    started = time.perf_counter()
    try:
        for instance, world in sampler.stream(max(_TRIES, 4 * wanted)):
            if len(fresh) >= wanted and time.perf_counter() - started > _PATIENCE:
                break
            if repr(instance) in seen:
                continue
            seen.add(repr(instance))
            try:
                truth = world.value(data["says"])
            except Undefined as error:
                undefined = str(error)
                sampler._refuse(f"conclusion has no value: {error}")
                continue
            found.checks += 1
            if truth is False:
                _refute(id, data, instance, found)
                return undefined
            fresh.append(instance)
            found.drawn.append((instance, world))
    except Unknown as error:
        found.evidence.append(f"instances: {error}")
    kept[found.shown:found.shown] = fresh[:wanted]
    found.shown += len(fresh[:wanted])
    kept.extend(fresh[wanted:])
    return undefined


def _default_hints(by: Sequence[Evidence]) -> dict[str, Any]:
    """Sizes of the proofs asked for, small ones, where no `instances` says more."""
    sizes: dict[str, list[int]] = {}
    for e in by:
        for name, values in e.hints.get("sizes", {}).items():
            sizes.setdefault(name, [v for v in values if v <= 4] or list(values)[:1])
    return {"sizes": sizes}


def _refute(id: str, data: dict, instance: dict, found: Findings) -> None:
    certificate = seal(id, "counterexample", data, {"instance": instance})
    if _accept(certificate, found):
        found.verdict, found.counterexample = "fails", instance
        found.evidence.append("an exact counterexample")


def _accept(certificate: dict, found: Findings) -> bool:
    """Replay a candidate with the checker; keep it, with what saves its replay some searching, if it is accepted."""
    trials, denominators = Trials(), None
    try:
        if certificate["kind"] == "generic index":
            certificate, denominators = with_cases(certificate)
        if denominators is None:
            denominators = replay(certificate, trials)
        if trials:
            certificate = seal(certificate["id"], certificate["kind"], certificate["statement"], {**certificate["evidence"], "cancelled": trials.made})
            denominators = replay(certificate)
    except (Rejected, NotACertificate) as error:
        found.evidence.append(f"{certificate['kind']} not accepted: {error}")
        return False
    found.certificates.append(certificate)
    found.denominators.extend(d for d in denominators if d not in found.denominators)
    found.checks += 1
    return True


def _prove(id: str, data: dict, by: Sequence[Evidence], found: Findings) -> None:
    """Try the proofs asked for, in order, until one is accepted; then the weaker kinds."""
    _every_size(id, data, by, found)  # the strongest there is
    for e in by:
        if e.kind in PROOFS and found.strength != "proved":
            before = len(found.evidence)
            for certificate in candidates(id, data, e):
                if _accept(certificate, found):
                    del found.evidence[before:]  # what was tried on the way to a proof shows nothing
                    _credit(data, e, found)
                    break
    if found.strength in ("proved", "proved-sizes"):
        _keep_witnesses(id, data, found)
    for e in by:
        if e.kind == "steps":
            _steps(e, found)
        elif e.kind == "chosen":
            _chosen(id, data, e, found)


def _keep_witnesses(id: str, data: dict, found: Findings) -> None:
    """Beside a proof a few instances do: they show that the hypotheses can be met."""
    for k, certificate in enumerate(found.certificates):
        if certificate["kind"] == "instances":
            few = certificate["evidence"]["instances"][:_WITNESSES]
            found.certificates[k] = seal(id, "instances", data, {**certificate["evidence"], "instances": few})
            replay(found.certificates[k])


def _every_size(id: str, data: dict, by: Sequence[Evidence], found: Findings) -> None:
    """A proof in words of letters holds for every size at once."""
    seconds = 5.0 if any(e.kind in ("identity", "combination", "order", "induction", "generic index", "arithmetic") for e in by) else 2.0
    for certificate in every_size(id, data, by, seconds):
        if _accept(certificate, found):
            found.strength, found.sizes = "proved", None
            found.evidence.append(proof_in_words(certificate))
            return
    for kind in dict.fromkeys(e.kind for e in by if e.kind == "order" and e.hints["sums"]):
        found.evidence.append(f"{kind}: the terms given do not prove it")


def _better(found: Findings, strength: str) -> bool:
    return found.strength is None or STRENGTHS.index(strength) < STRENGTHS.index(found.strength)


def _credit(data: dict, e: Evidence, found: Findings) -> None:
    """Strength of an accepted proof; a parametrisation is worth no more than the claim that covers it."""
    strength = "proved-sizes" if data["sizes"] else "proved"
    cover, fact = e.hints.get("covered_by"), e.hints.get("fact")
    if fact:
        strength = "steps"
        if found.strength is None:
            found.evidence.append("identity: a parametrisation that rests on a classical fact needs instances beside it")
            return
        found.evidence.append(f"identity in suitable coordinates; classical fact: {fact}")
    elif cover:
        other, sizes = _standing_of(cover)
        beyond = [name for name, values in sizes.items() if name not in e.hints["sizes"] or not {*e.hints["sizes"][name]} <= {*values}]
        if other not in ("proved", "proved-sizes") or beyond:
            less = f"{other} for fewer values of {', '.join(beyond)}" if beyond else other or "open"
            found.evidence.append(f"{e.kind}: the parametrisation rests on {cover}, which is {less}")
            found.certificates.pop()
            return
        found.evidence.append(f"parametrisation reaches everything by {cover}")
    if _better(found, strength):
        found.strength = strength
        found.sizes = {k: list(v) for k, v in e.hints["sizes"].items() if k in data["sizes"]} or None
        found.evidence.append(_PHRASES[e.kind])


_PHRASES = {
    "identity": "identity of rational functions, with a symbol in place of every variable",
    "combination": "consequence of the hypotheses by an explicit combination of them",
    "induction": "induction on t: base and step as identities",
    "positivity": "difference of both sides as a sum of squares times hypotheses",
    "evaluation": "evaluated exactly, every case",
}


@cache
def _standing_of(id: str, aside: str = "") -> tuple[str | None, Mapping[str, Sequence[int]]]:
    """Strength of another claim, its mutants and the bounds of one kind left aside, and the sizes; None if it does not hold."""
    other = load().get(id)
    if other is None or other.statement is None:
        return None, {}
    found = _find(id, other.statement, other.by, 0)
    _bound([e for e in other.by if e.kind != aside], found)
    return found.strength if found.verdict == "holds" else None, found.sizes or {}


def _steps(e: Evidence, found: Findings) -> None:
    standings = {id: _standing_of(id, "restated")[0] for id in e.hints["ids"]}
    weak = [id for id, s in standings.items() if s not in ("proved", "proved-sizes")]
    if weak:
        found.evidence.append(f"steps not proved: {', '.join(weak)}")
    elif found.strength == "instances":
        found.strength = "steps"
        shown = f"displayed steps {', '.join(standings)} proved; " if standings else ""
        facts = [*e.hints["facts"], *(fact for id in standings for x in load()[id].by if x.kind == "restated" for fact in x.hints["facts"])]
        found.evidence.append(f"{shown}classical facts: {'; '.join(dict.fromkeys(facts)) or 'none'}")
        if e.hints["prose"]:
            found.evidence.append(f"between the steps: {e.hints['prose']}")


def _chosen(id: str, data: dict, e: Evidence, found: Findings) -> None:
    """What is shown of all variables is said of some if they exist."""
    choices = json.loads(json.dumps(e.hints["choices"]))
    if _accept(seal(id, "existence", data, {"choices": choices}), found):
        found.evidence.append("; ".join(f"{', '.join(names)} exist: {THEOREMS[theorem]}" for theorem, _, names in choices))
    else:
        _at_most(found, "steps")


def _bound(by: Sequence[Evidence], found: Findings) -> None:
    """What is shown of a formula counts for the print as far as the formula says what is printed."""
    for e in by if found.verdict == "holds" else ():
        if e.kind == "restated":
            found.evidence.append(f"the formula says what is printed by classical facts: {'; '.join(e.hints['facts'])}")
            _at_most(found, "steps")
        elif e.kind == "part":
            found.evidence.append(f"the formula is a part of what is printed: {e.hints['covers']}")
            _at_most(found, "instances")


def _at_most(found: Findings, strength: str) -> None:
    if STRENGTHS.index(found.strength or strength) < STRENGTHS.index(strength):
        found.strength, found.sizes = strength, None


# ---------------------------------------------------------------------- the result as plain data
def _result(claim: Claim, found: Findings, repaired: Findings | None, report: MutantReport, repair: Any, started: float) -> dict[str, Any]:
    from exactkf.language.latex import given_latex, over_latex, says_latex, where_latex

    printed = claim.statement
    fixed = None
    if found.verdict == "fails" and repair is not None and repaired is not None:
        fixed = {"statement_latex": says_latex(repair.statement), "verdict": repaired.verdict, "strength": repaired.strength,
                 "kind": repair.kind, "wrong": repair.wrong, "reason": repaired.reason, "evidence": repaired.evidence,
                 "sizes": repaired.sizes, "witness": repaired.witness}
    certificates = found.certificates + (repaired.certificates if repaired else [])
    return {
        "id": claim.id, "paper": claim.paper, "section": claim.section, "title": claim.title, "note": claim.note,
        "verdict": found.verdict, "strength": found.strength, "sizes": found.sizes, "reason": found.reason or None, "repair": fixed,
        "statement_latex": says_latex(printed) if printed else "",
        "over_latex": over_latex(printed) if printed else [],
        "where_latex": where_latex(printed) if printed else [],
        "given_latex": given_latex(printed) if printed else [],
        "certificates": certificates,
        "mutants": {"made": report.made, "rejected": report.rejected, "equal": report.equal, "survivors": report.survivors,
                    "void": report.void, "stronger": report.stronger},
        "neighbours": {"made": report.neighbours_made, "accepted": report.neighbours_accepted},
        "checks": found.checks + (repaired.checks if repaired else 0), "seconds": round(time.perf_counter() - started, 3),
        "witness": found.witness, "counterexample": found.counterexample, "evidence": found.evidence,
        "denominators": found.denominators,
    }
