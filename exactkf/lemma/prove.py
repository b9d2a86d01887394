# SPDX-License-Identifier: MIT
"""Prove or refute a lemma of one's own.

Refutation comes first: exact instances that satisfy the assumptions, by
construction. Then a proof for every size: multiples of the assumptions in
words of letters, the order calculus, or both through an induction. Whatever is
found is a certificate, and counts only after the checker has replayed it.

What is never reported as proved:

- a claim whose assumptions no instance meets (vacuous or contradictory);
- a claim with an inverse of which neither an assumption nor the order calculus
  says that it exists: a term has a value only where its inverses do, and
  a proof is about those values alone;
- a claim whose search ended at a bound.

Changed lemmas that hold as well (mutants that survive) are warnings here, not
faults: a true lemma need not be the sharpest one.

Main definitions
----------------
`prove_lemma`
    From a text, a file, a statement or its parts to an `Outcome`.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import chain
from pathlib import Path
from typing import Any

from flint import fmpq

from exactkf._errors import BadInput
from exactkf._facts import facts_used
from exactkf._wording import multiples_in_words, over_primes
from exactkf.describe import instance_lines
from exactkf.evidence import identity
from exactkf.finders.completion import Stuck
from exactkf.finders.effort import clock
from exactkf.finders.membership import find_order, search_membership
from exactkf.finders.prove import candidates, every_size
from exactkf.kernel.limits import patiently
from exactkf.kernel.numbers import Undefined, Unknown, rationals
from exactkf.kernel.reader import Reader
from exactkf.kernel.replay import NotACertificate, Rejected, replay, seal
from exactkf.kernel.words import size_tree
from exactkf.language import Statement
from exactkf.language.statement import as_tuples
from exactkf.language.text import text
from exactkf.lemma.bounds import why_open
from exactkf.lemma.classical import along_sequences, by_classical_facts
from exactkf.lemma.determinants import by_factors
from exactkf.lemma.grammar import read_lemma
from exactkf.lemma.inverses import claimed_inverses, exists_by_assumption, invertibility, show_inverse, square_sequences
from exactkf.lemma.neighbours import neighbours
from exactkf.lemma.outcome import Outcome
from exactkf.lemma.refute import Search, contradiction, look_for, unmet
from exactkf.lemma.sizes import Misfit, Sizes

__all__ = ["prove_lemma", "read_file"]

_PATIENCE = 5.0  # seconds; with twice the time limit the end of a step that does not look at the time
_MOST_LEAVES = 8  # parts of a claim that one semidefinite term is tried for
_MOST_WARNING = 5.0  # seconds for changed lemmas
_MOST_SEARCH = 20.0  # seconds for the search of a counterexample, where there are that many


def prove_lemma(lemma: Statement | str | Path | None = None, /, *, sizes: Sequence[Any] = (), over: Any = (), where: Sequence[tuple] = (), given: Any = (),
                says: Any = None, time_limit: float = 60.0, degree: int = 8, seed: int = 0, mutants: bool = True,
                progress: Callable[[str], None] | None = None) -> Outcome:
    """Prove a lemma for every size, refute it by explicit matrices, or say how far it got.

    Parameters
    ----------
    lemma : Statement, str or Path, optional
        A statement; the text of a lemma (see `exactkf.lemma.grammar`); or the path of a file with such a text.
    sizes, over, where, given, says
        The parts of an `exactkf.language.Statement`, instead of ``lemma``. ``0`` stands for a zero of the size that fits.
    time_limit : float
        Seconds after which no new search is begun; a step that does not end is given up after more than twice as many.
    degree : int
        Longest word that the completion of the assumptions looks at.
    seed : int
        Of random instances.
    mutants : bool
        Whether to look at changed lemmas too, and to warn of those that are not refuted.
    progress : callable, optional
        Called with a few words on what is being done.

    Returns
    -------
    Outcome

    Raises
    ------
    BadInput
        For a lemma that cannot be read: unknown letters, sizes that do not fit, with the place and the remedy.

    Examples
    --------
    >>> outcome = prove_lemma('''
    ... sizes n m
    ... matrix P n m
    ... matrix Q m n
    ... assume I + P*Q invertible
    ... claim inv(I + P*Q)*P == P*inv(I + Q*P)
    ... ''')
    >>> outcome.verdict
    'proved'
    """
    if not (isinstance(time_limit, (int, float)) and math.isfinite(time_limit) and time_limit > 0):
        raise BadInput(f"argument 'time_limit' = {time_limit!r} is not a number of seconds; give a finite one above 0")
    if isinstance(degree, bool) or not isinstance(degree, int) or degree < 1:
        raise BadInput(f"argument 'degree' = {degree!r} is not a length of words; give a whole number, 1 or more")
    if isinstance(seed, bool) or not isinstance(seed, int) or seed < 0:
        raise BadInput(f"argument 'seed' = {seed!r} is no seed; give a whole number, 0 or more")
    try:
        run = _Run(_statement(lemma, sizes, over, where, given, says), time_limit, degree, seed, progress or (lambda _: None))
        try:
            with rationals(fmpq), patiently(_PATIENCE + 2 * time_limit):  # the search; replaying goes back to Fraction by itself
                return run.outcome(mutants)
        except Rejected as error:
            return run.given_up(str(error))
    except RecursionError:
        raise BadInput("the lemma has more operations inside each other than can be followed; state a step of it by itself") from None


def read_file(path: Path) -> Statement:
    """Read the file of a lemma."""
    try:
        return read_lemma(path.read_text(encoding="utf-8-sig"))
    except OSError as error:
        raise BadInput(f"argument FILE = {str(path)!r} cannot be read ({error.strerror or error}); pass a file that you may read") from error
    except UnicodeDecodeError as error:
        raise BadInput(f"argument FILE = {str(path)!r} is not UTF-8 text; pass a file in the grammar of lemmas") from error
    except BadInput as error:
        raise BadInput(f"{path}: {error}") from error


def _statement(lemma: Any, sizes: Sequence[Any], over: Any, where: Sequence[tuple], given: Any, says: Any) -> Statement:
    parts = {"sizes": sizes, "over": over, "where": where, "given": given}
    if lemma is None:
        if says is None:
            raise BadInput("argument 'says' is missing: the lemma claims nothing; pass a formula, or a Statement, text or Path as first argument")
        return _fitted(Statement(says=says, over=over, sizes=sizes, where=where, given=given))
    used = [name for name, value in parts.items() if value] + ["says"] * (says is not None)
    if used:
        raise BadInput(f"argument {used[0]!r} is given beside a whole lemma; give one or the other")
    if isinstance(lemma, Path):
        return read_file(lemma)
    if isinstance(lemma, str):
        return read_lemma(lemma)
    if not isinstance(lemma, Statement):
        raise BadInput(f"argument 'lemma' = {lemma!r} is no lemma; pass a Statement, the text of a lemma, or the Path of a file")
    return _fitted(lemma)


def _fitted(statement: Statement) -> Statement:
    """The statement with sizes checked and put in, as far as its operations are those of matrices."""
    shapes = Sizes(statement.sizes)
    try:
        for name, kind in tuple(statement.over):
            shapes.declare(name, kind)
        where = []
        for d in statement.where:
            if d[0] == "let" and not d[2]:
                d = (*d[:3], shapes.define(d[1], d[3]))
            elif d[0] == "rec":
                shapes.define(d[1], d[4][0])
            where.append(d)
        given = [(label, shapes.formula(formula), kind) for label, formula, kind in tuple(statement.given)]
        return Statement(says=shapes.formula(statement.says), over=statement.over, sizes=statement.sizes, where=where, given=given)
    except Misfit as error:
        raise BadInput(f"the lemma does not fit together: {error}") from error


class _Run:
    """One lemma on its way to an outcome."""

    def __init__(self, statement: Statement, time_limit: float, degree: int, seed: int, progress: Callable[[str], None]) -> None:
        self.started = time.perf_counter()
        self.deadline = self.started + time_limit
        self.limit, self.degree, self.seed, self.progress = time_limit, degree, seed, progress
        self.data = statement.to_json()
        self.late = False  # a search for a proof ended for lack of time
        self.found = Outcome(statement)
        self.sides = [side for part in _claims(self.data["says"]) if part[0] == "=" for side in part[1:] if isinstance(side, list)]

    def outcome(self, mutants: bool) -> Outcome:
        search = self._search()
        if self.found.verdict == "open" and not self.found.reason:
            self._prove()
            if self.found.verdict == "proved" and mutants and self._left() > 0:
                self._warn(search)
        self.found.seconds = time.perf_counter() - self.started
        return self.found

    def given_up(self, why: str) -> Outcome:
        """What was found until a step that would not end."""
        if self.found.verdict == "open" and not self.found.reason:
            self.found.reason = f"the time limit was reached: {why}; a larger --time-limit (time_limit=), or a smaller lemma on the way, may settle it"
        self.found.seconds = time.perf_counter() - self.started
        return self.found

    def _left(self) -> float:
        return self.deadline - time.perf_counter()

    def _share(self, part: float, most: float) -> float:
        return max(0.05, min(most, part * self._left()))

    def _keep(self, certificate: dict | None) -> bool:
        """Replay what a finder proposes; keep it if it is accepted."""
        if certificate is None:
            return False
        self.found.checks += 1
        try:
            replay(certificate)
        except (Rejected, NotACertificate) as error:
            self.found.reached.append(f"{certificate['kind']}: a candidate was not accepted by the checker: {error}")
            return False
        self.found.certificates.append(certificate)
        return True

    # ------------------------------------------------------------------ refutation
    def _search(self) -> Search:
        self.progress("looking for a counterexample")
        found = self.found
        search = look_for(self.data, time.perf_counter() + self._share(0.3, _MOST_SEARCH), seed=self.seed)
        found.checks += search.checks
        if search.certificate is not None:
            found.verdict, found.counterexample = "refuted", search.counterexample
            found.certificates = [search.certificate]
            found.reason = self._what_fails(search)
        elif search.kept:
            found.witness = min(search.kept, key=lambda instance: sum(instance["sizes"].values()))
            found.reached.append(f"{len(search.kept)} exact instances satisfy the assumptions and the claim (seed {self.seed})")
            self._premises(search)
        elif search.undefined:
            found.reason = f"no value: on none of {search.undefined} instances of the assumptions has the claim a value ({search.why_undefined})"
        elif search.unknown:
            found.reached.append(f"instances: {search.unknown}")
            found.reason = f"the claim was not evaluated on any instance: {search.unknown}"
        else:
            self._vacuous()
        return search

    def _what_fails(self, search: Search) -> str:
        """The conjunct of the claim that the counterexample violates."""
        instance = search.certificate["evidence"]["instance"]  # type: ignore[index]
        for part in _claims(self.data["says"]):
            certificate = seal("lemma", "counterexample", {**self.data, "says": part}, {"instance": instance})
            try:
                replay(certificate)
            except (Rejected, NotACertificate):
                continue
            return f"{_text(part)} does not hold for the matrices below"
        return "the claim does not hold for the matrices below"

    def _premises(self, search: Search) -> None:
        """An implication of which no instance satisfies the premise says nothing."""
        for part in _claims(self.data["says"]):
            if part[0] != "=>":
                continue
            values = []
            for world in search.worlds:
                try:
                    values.append(world.value(part[1]))
                except (Undefined, Unknown):
                    continue
            if True not in values:
                self.found.reason = f"vacuous: no instance was found that satisfies the premise {_text(part[1])}; make sure that it can be met"

    def _vacuous(self) -> None:
        self.progress("looking for a witness of the assumptions")
        found = self.found
        label = unmet(self.data, time.perf_counter() + self._share(0.5, _MOST_SEARCH), self.seed)
        if not label:
            found.reason = "vacuous: no instance of the types was found"
            return
        before = " together with those before it" if label != self.data["given"][0][0] else ""
        contradictory = contradiction(self.data, label, self.degree, self._share(0.3, 3.0))
        if contradictory and self._keep(contradictory[1]):
            size = contradictory[0]
            found.reason = (f"contradictory: assumption {label!r}{before} implies I({size}) = 0, so that it can be met for {size} = 0 alone; "
                            "remove or correct it")
        else:
            found.reason = f"vacuous: no matrices were found that satisfy assumption {label!r}{before}; make sure that it can be met"

    # ------------------------------------------------------------------ proof
    def _prove(self) -> None:
        self.progress("looking for a proof")
        found = self.found
        whole = self._proof_of(self.data, 0.4)
        if whole is None and not self._in_parts():
            return
        found.reached += [whole] if whole else []
        missing = self._inverses()
        if missing:
            found.reason = missing
            return
        found.verdict = "proved"
        found.assuming = [*(label for label, _, _ in self.data["given"]), *found.assuming]

    def _proof_of(self, data: dict, part: float) -> str | None:
        """Keep a certificate of a statement; how it was proved, or None."""
        seconds, began = self._share(part, math.inf) / 2, clock()
        every = every_size("lemma", data, (), seconds / 2, self.degree) if data["sizes"] else candidates("lemma", data, identity())
        facts = (seal("lemma", "order", data, found) for by in (by_factors, by_classical_facts) for found in by(data, self.degree, seconds))
        for certificate in chain(every, _by_sides(data, self.sides, self.degree, seconds / 2), facts, self._along(data)):
            if self._keep(certificate):
                return _how(certificate)
        self.late = self.late or clock() - began > 0.9 * seconds
        return None

    def _along(self, data: dict) -> Iterator[dict]:
        """Last of all, and with most of the time that is left."""
        for found in along_sequences(data, square_sequences(data), self.degree, self._share(0.7, math.inf)):
            yield seal("lemma", "word induction", data, found)

    def _in_parts(self) -> bool:
        """The claims one by one: whether each is proved, and how far it got."""
        parts, open_ = _claims(self.data["says"]), []
        for k, part in enumerate(parts):
            how = self._proof_of({**self.data, "says": part}, 0.8 / (len(parts) - k)) if len(parts) > 1 else None
            if how is None:
                open_.append(part)
            else:
                self.found.reached.append(f"{_text(part)}: {how}")
        for part in open_:
            self.found.reached.append(f"{_text(part)}: neither proved nor refuted; {self._stuck(part)}")
        if open_:
            self.found.reason = why_open(self.data, open_, self.late or self._left() <= 0, self.degree, self._share(0.2, 5.0))
        return not open_

    def _stuck(self, part: Any) -> str:
        """How far the search for multiples of the assumptions got."""
        if part[0] in _CONNECTIVES:
            return "the parts of it were not all proved"
        equation = part[2] if part[0] == "always" else part
        if equation[0] not in ("=", "symmetric", "symplectic"):
            if part[0] == "always":
                return "its base or its step was not proved"
            why = _not_in_words(self.data, equation)
            return f"what is proved for every size does not reach it: {why}" if why else "no sum of terms that are semidefinite by their form was found"
        found = search_membership({**self.data, "says": part}, self.degree, self._share(0.2, 5.0))
        return str(found) if isinstance(found, Stuck) else "its multiples of the assumptions are found, but no certificate of it was accepted"

    def _inverses(self) -> str:
        """Show the inverses of the claim; why one is not granted, or nothing."""
        for term, data in claimed_inverses(self.data):
            name = f"{_text(['inv', term])}"
            why = exists_by_assumption(data, term)
            if why:
                self.found.assuming.append(f"{name} exists {why}")
                continue
            formula = invertibility(data, term)
            certificate = show_inverse(data, term, self.degree, self._share(0.2, 2.0)) if formula[0] == "invertible" else None
            if certificate is not None and self._keep(certificate):
                self.found.assuming.append(f"{name} exists, as is shown")
                continue
            return self._not_granted({**data, "says": formula}, term, name)
        return ""

    def _not_granted(self, data: dict, term: Any, name: str) -> str:
        remedy = f"add 'assume {_text(data['says'])}'"
        search = look_for(data, time.perf_counter() + self._share(0.3, 3.0), seed=self.seed, id="lemma: an inverse that need not exist")
        self.found.checks += search.checks
        claim = f"proved only where {name} exists, which no assumption grants"
        if search.certificate is None:
            return f"{claim}; {remedy}"
        self.found.certificates.append(search.certificate)
        self.found.reached.append(f"{_text(term)} is singular although every assumption holds: {'; '.join(_short(search.counterexample or {}))}")
        return f"{claim}, and it need not exist; {remedy}"

    def _warn(self, search: Search) -> None:
        """Changed lemmas that the instances do not refute."""
        self.progress("looking at changed lemmas")
        until = time.perf_counter() + self._share(0.5, _MOST_WARNING)
        refuted, looked, warnings = neighbours(self.data, search.worlds, self.degree, until, self.seed)
        self.found.reached.append(f"{refuted} of {looked} changed lemmas refuted")
        self.found.warnings += warnings


_CONNECTIVES = ("and", "or", "not", "=>", "<=>")
_HOW = {
    "membership": "{}, expanded in words of letters",
    "order": "by multiples of the assumptions and classical facts: {}",
    "identity": "an identity of rational functions in the entries",
    "word induction": "by induction, base and step in words of letters; classical facts: {}",
}


def _how(certificate: dict) -> str:
    """How a statement was proved: what the certificate uses, and the primes that it divides by."""
    evidence, kind = certificate["evidence"], certificate["kind"]
    used = multiples_in_words(evidence) if kind == "membership" else ", ".join(facts_used(certificate)) or "none"
    return _HOW[kind].format(used) + over_primes(evidence)


def _by_sides(data: dict, sides: Sequence[Any], degree: int, seconds: float) -> Iterator[dict]:
    """Proofs of an order by a term that an equation of the lemma names, or by the form of an update."""
    if data["says"][0] not in ("psd", "pd", "loewner"):
        return
    tried = [*([side] for side in sides), *_squares(data)]
    deadline = time.perf_counter() + seconds
    for terms in tried:
        if (left := deadline - time.perf_counter()) <= 0:
            return
        parts = find_order(data, [terms] * _MOST_LEAVES, degree=degree, seconds=left)
        if parts is not None:
            yield seal("lemma", "order", data, {"parts": parts, "lemmas": []})


def _squares(data: dict) -> Iterator[list]:
    """For a claim A - K M A >= 0, with a semidefinite A: (I - KM)A(I - KM)' and KVK' with each V that is known to be semidefinite; and inverses."""
    big, small = _difference(data)
    left = _factors(data, small)
    own = _factors(data, big)
    if len(left) <= len(own) or left[-len(own):] != own:
        return
    reader, left = Reader(data), left[:-len(own)]
    known = [["sym", name] for name, kind in data["over"] if kind[0] in ("psd", "pd")]
    known += [f[1] for _, f, _ in data["given"] if f[0] in ("psd", "pd") and f[1] not in known]
    for k in range(1, len(left)):
        gain, seen = (part[0] if len(part) == 1 else ["*", *part] for part in (left[:k], left[k:]))
        try:
            size, inner = reader.read(big).rows, reader.read(gain).cols
            rest = ["-", ["I", size_tree(reader.total(size))], ["*", gain, seen]]
            fits = [v for v in known if reader.read(v).rows == inner]
        except (Unknown, Undefined, AttributeError):
            continue
        square = ["*", rest, big, ["T", rest]]
        for weight in fits:
            yield [square, ["*", gain, weight, ["T", gain]]]
            yield [["inv", ["+", ["inv", big], ["*", ["T", seen], ["inv", weight], seen]]]]
        yield [square, ["*", gain, ["T", gain]]]


def _difference(data: dict) -> tuple[Any, Any]:
    """The two sides of an order A >= B, or of A - B >= 0."""
    op, *args = data["says"]
    if op == "loewner" and args[1] != 0 and not (isinstance(args[1], list) and args[1][0] == "O"):
        return args[0], args[1]
    whole = _written_out(data, args[0])
    return (whole[1], whole[2]) if isinstance(whole, list) and whole[0] == "-" else (whole, 0)


def _factors(data: dict, tree: Any) -> list:
    """Factors of a product, opened where they are products; definitions of products are opened too."""
    opened = _written_out(data, tree)
    if not isinstance(opened, list) or opened[0] != "*":
        return [tree]
    return [x for part in opened[1:] for x in _factors(data, part)]


def _written_out(data: dict, tree: Any) -> Any:
    """What a name without parameters stands for."""
    if isinstance(tree, list) and tree[0] == "sym":
        body = next((d[3] for d in data["where"] if d[0] == "let" and d[1] == tree[1] and not d[2]), None)
        return tree if body is None else _written_out(data, body)
    return tree


def _not_in_words(data: dict, tree: Any) -> str:
    """Why a formula is not one about matrices of every size; empty if it is."""
    reader = Reader(data)
    for term in tree[1:]:
        try:
            reader.read(term)
        except (Unknown, Undefined) as error:
            return str(error)
    return ""


def _claims(says: Any) -> list[Any]:
    return list(says[1:]) if says[0] == "and" else [says]


def _text(tree: Any) -> str:
    return text(as_tuples(tree))


def _short(instance: Mapping[str, Any]) -> list[str]:
    return [line for line in instance_lines(instance) if not line.startswith("horizon")]
