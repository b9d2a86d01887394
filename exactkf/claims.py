# SPDX-License-Identifier: MIT
"""Claims: numbered statements of papers, each one short literal.

A module under ``proofs/`` calls `claim` once per statement; importing the
module registers it. Everything else (row of the table, formula in the report,
instances, mutants, property test, certificate) follows from the literal.

Main definitions
----------------
`claim`
    Register a statement of a paper with the evidence to look for.
`repair`
    The corrected statement of a claim that is expected to fail. The engine,
    not the literal, decides whether the printed statement fails.
`not_checked`
    A claim without a checkable statement yet; its verdict is `open`.
`load`, `find`
    The registry: claims in reading order, by id, paper or section.
`checked_evidence`
    Evidence that fits a statement; refused if it speaks of other sizes.
"""

from __future__ import annotations

import importlib
import pkgutil
import sys
import traceback
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from exactkf._errors import BadInput
from exactkf.evidence import Evidence
from exactkf.language import Expr, Statement

__all__ = ["REPAIR_KINDS", "Claim", "Repair", "checked_evidence", "claim", "find", "load", "not_checked", "repair"]

REPAIR_KINDS = (
    "sign", "factor", "index", "order of factors", "missing hypothesis", "boundary case", "cross-reference", "other",
)


@dataclass(frozen=True)
class Repair:
    """The nearest correct statement: what was wrong, in one sentence, and the evidence for the correction."""

    kind: str
    wrong: str
    statement: Statement
    by: tuple[Evidence, ...]


@dataclass(frozen=True)
class Claim:
    """A statement of a paper with the evidence asked for."""

    id: str
    title: str
    section: str
    statement: Statement | None
    by: tuple[Evidence, ...] = ()
    repair: Repair | None = None
    reason: str = ""
    note: str = ""

    @property
    def paper(self) -> str:
        """Key of the paper: what stands before the first hyphen of the id."""
        return self.id.split("-", 1)[0]


_REGISTRY: dict[str, Claim] = {}
_SPECS: dict[str, Any] = {}


def claim(id: str, title: str, says: Expr, *, by: Evidence | Sequence[Evidence], sizes: Sequence[Any] = (),
          over: Mapping[Any, tuple] | None = None, where: Sequence[tuple] = (), given: Any = (),
          tex: Mapping[Any, str] | None = None, repair: Repair | None = None, note: str = "") -> Claim:
    """Register one printed statement.

    Parameters
    ----------
    id : str
        Id in the claims ledger, ``"BLZ94-E2.18"``.
    title : str
        A few words of our own.
    says, sizes, over, where, given
        The statement, see `exactkf.language.Statement`; ``over`` may have names or `Expr` keys.
    by : Evidence or sequence of Evidence
        What to look for, strongest first; see `exactkf.evidence`.
    repair : Repair, optional
        The corrected statement, where the printed one fails.
    tex : mapping of name to LaTeX, optional
        How the paper prints a name, where that differs from `exactkf.language.names`; keys may be names or `Expr`.
        A name that is used nowhere in the statement is refused.
    note : str
        One or two sentences for the reader, e.g. how a phrase was read.
    """
    with _named(f"claim {id!r}"):
        statement = Statement(says=says, over=over or {}, sizes=sizes, where=where, given=given, tex=tex or {})
        return _register(Claim(id, title, _section(), statement, checked_evidence(statement, by), repair, "", note))


def repair(kind: str, wrong: str, says: Expr, *, by: Evidence | Sequence[Evidence], sizes: Sequence[Any] = (),
           over: Mapping[Any, tuple] | None = None, where: Sequence[tuple] = (), given: Any = (),
           tex: Mapping[Any, str] | None = None) -> Repair:
    """The corrected statement; ``kind`` is one of `REPAIR_KINDS`, ``wrong`` one sentence on what was wrong; see `claim`."""
    if kind not in REPAIR_KINDS:
        raise BadInput(f"argument 'kind' = {kind!r} is not a kind of repair; use one of {', '.join(REPAIR_KINDS)}")
    statement = Statement(says=says, over=over or {}, sizes=sizes, where=where, given=given, tex=tex or {})
    return Repair(kind, wrong, statement, checked_evidence(statement, by))


def not_checked(id: str, title: str, reason: str, note: str = "") -> Claim:
    """Register a claim whose verdict is `open`, with the reason a reader is to accept."""
    return _register(Claim(id, title, _section(), None, reason=reason, note=note))


def checked_evidence(statement: Statement, by: Evidence | Sequence[Evidence]) -> tuple[Evidence, ...]:
    """The evidence as a tuple.

    Raises
    ------
    BadInput
        If a part of it is none, gives values to what is no size of the statement, or leaves a size without values.
    """
    every = (by,) if isinstance(by, Evidence) else tuple(by) if isinstance(by, (list, tuple)) else (by,)
    allowed = {*statement.sizes, *(name for name, kind in tuple(statement.over) if kind[0] == "integer")}
    drawn: set[str] = set()
    for e in every:
        if not isinstance(e, Evidence):
            raise BadInput(f"argument 'by' has {e!r}, which is no evidence; write identity(...), instances(...) or others of exactkf.evidence")
        values = e.hints.get("sizes")
        if values is None:
            continue
        if strange := sorted(set(values) - allowed):
            raise BadInput(f"argument 'by': {e.kind} gives values to {strange[0]!r}, which is no size of the statement; "
                           f"its sizes are: {', '.join(statement.sizes) or 'none'}")
        if values or e.kind != "induction":  # without sizes, an induction is for every size
            _complete(statement, e.kind, values)
        drawn.update(values)
    if not any(e.kind == "instances" for e in every):  # it is the proofs that say which sizes instances are drawn from
        _complete(statement, "instances", drawn)
    return every


def _complete(statement: Statement, kind: str, sizes: Iterable[str]) -> None:
    for name in statement.sizes:
        if name not in sizes:
            raise BadInput(f"argument 'by' has no values of size {name!r} for {kind}; write {kind}(..., {name}=(1, 2, 3))")


def load(package: str = "proofs") -> dict[str, Claim]:
    """Import every module of the package and return the claims in reading order, by id.

    Raises
    ------
    BadInput
        Naming module, line and fault, if a module cannot be imported.
    """
    module = importlib.import_module(package)
    names = [package]
    try:
        for name in sorted(info.name for info in pkgutil.walk_packages(module.__path__, f"{package}.")):
            names.append(name)
            importlib.import_module(name)
    except Exception as error:  # a module of claims is Python, and can fail in any way Python has
        raise BadInput(f"module {names[-1]!r} cannot be imported: {_fault(error)}; mend it") from error
    return dict(sorted(_REGISTRY.items(), key=lambda item: _place(item[1])))


def _fault(error: Exception) -> str:
    """What went wrong, and at which line of which module of claims."""
    if isinstance(error, SyntaxError):
        return f"line {error.lineno}: {error.msg}"
    lines = [f.lineno for f in traceback.extract_tb(error.__traceback__) if f.name == "<module>"]
    where = f"line {lines[-1]}: " if lines else ""
    return where + (str(error) if isinstance(error, BadInput) else f"{type(error).__name__}: {error}")


def _place(item: Claim) -> tuple[str, int, str]:
    """Where a reader expects a claim: introduction and sections come before appendices and what the paper does not say."""
    rank = 0 if item.section.startswith("introduction") else 1 if item.section.startswith("section") else 2
    return item.paper, rank, item.section


def find(words: Sequence[str], claims: Mapping[str, Claim]) -> list[Claim]:
    """Claims named by ids, paper keys or sections (``BLZ94/section_3``); all claims for no words.

    Raises
    ------
    BadInput
        For a word that names nothing; the message offers the nearest ids.
    """
    if not words:
        return list(claims.values())
    chosen: dict[str, Claim] = {}
    for word in words:
        hits = [c for c in claims.values() if word == c.id or word == c.paper or word == f"{c.paper}/{c.section}"]
        if not hits:
            import difflib

            sections = dict.fromkeys(f"{c.paper}/{c.section}" for c in claims.values())
            names = sections if "/" in word else [*claims, *dict.fromkeys(c.paper for c in claims.values())]
            near = difflib.get_close_matches(word, names, 3, 0.4 if "/" in word else 0.6)
            hint = f"did you mean {', '.join(near)}?" if near else "see 'exactkf list'"
            raise BadInput(f"argument ID = {word!r} names no claim, paper or section; {hint}")
        chosen.update((c.id, c) for c in hits)
    return list(chosen.values())


def _register(item: Claim) -> Claim:
    old = _REGISTRY.get(item.id)
    spec = _caller().get("__spec__")  # another one each time that a module runs: a module may be loaded again, a claim may not be written twice
    if old is not None and (old.section != item.section or (spec is not None and spec is _SPECS.get(item.id))):
        raise BadInput(f"claim id {item.id!r} is registered twice, in {' and '.join(dict.fromkeys((old.section, item.section)))}; give one another id")
    _REGISTRY[item.id], _SPECS[item.id] = item, spec
    return item


def _section() -> str:
    """Name of the module that calls `claim`, without its package."""
    return _caller().get("__name__", "").rsplit(".", 1)[-1]


def _caller() -> dict[str, Any]:
    """Names of the module that calls `claim` or `not_checked`."""
    frame = sys._getframe(3)
    return frame.f_globals


@contextmanager
def _named(what: str) -> Iterator[None]:
    """Say of which claim a refusal speaks."""
    try:
        yield
    except BadInput as error:
        raise BadInput(f"{what}: {error}") from error
