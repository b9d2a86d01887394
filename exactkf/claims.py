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
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from exactkf._errors import BadInput
from exactkf.evidence import Evidence
from exactkf.language import Expr, Statement

__all__ = ["REPAIR_KINDS", "Claim", "Repair", "claim", "find", "load", "not_checked", "repair"]

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


def claim(id: str, title: str, says: Expr, *, by: Evidence | Sequence[Evidence], sizes: Sequence[str] = (),
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
    statement = Statement(says=says, over=_names(over), sizes=sizes, where=where, given=given, tex=_names(tex))
    return _register(Claim(id, title, _section(), statement, _tuple(by), repair, "", note))


def repair(kind: str, wrong: str, says: Expr, *, by: Evidence | Sequence[Evidence], sizes: Sequence[str] = (),
           over: Mapping[Any, tuple] | None = None, where: Sequence[tuple] = (), given: Any = (),
           tex: Mapping[Any, str] | None = None) -> Repair:
    """The corrected statement; ``kind`` is one of `REPAIR_KINDS`, ``wrong`` one sentence on what was wrong; see `claim`."""
    if kind not in REPAIR_KINDS:
        raise BadInput(f"argument 'kind' = {kind!r} is not a kind of repair; use one of {', '.join(REPAIR_KINDS)}")
    return Repair(kind, wrong, Statement(says=says, over=_names(over), sizes=sizes, where=where, given=given, tex=_names(tex)), _tuple(by))


def not_checked(id: str, title: str, reason: str, note: str = "") -> Claim:
    """Register a claim whose verdict is `open`, with the reason a reader is to accept."""
    return _register(Claim(id, title, _section(), None, reason=reason, note=note))


def load(package: str = "proofs") -> dict[str, Claim]:
    """Import every module of the package and return the claims in reading order, by id."""
    module = importlib.import_module(package)
    for info in sorted(pkgutil.walk_packages(module.__path__, f"{package}."), key=lambda info: info.name):
        importlib.import_module(info.name)
    return dict(_REGISTRY)


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

            near = difflib.get_close_matches(word, [*claims, *{c.paper for c in claims.values()}], 3)
            hint = f"did you mean {', '.join(near)}?" if near else "see 'exactkf list'"
            raise BadInput(f"argument ID = {word!r} names no claim, paper or section; {hint}")
        chosen.update((c.id, c) for c in hits)
    return list(chosen.values())


def _register(item: Claim) -> Claim:
    old = _REGISTRY.get(item.id)
    if old is not None and old.section != item.section:
        raise BadInput(f"claim id {item.id!r} is registered twice, in {old.section} and {item.section}")
    _REGISTRY[item.id] = item
    return item


def _section() -> str:
    """Name of the module that calls `claim`, without its package."""
    import sys

    return sys._getframe(2).f_globals.get("__name__", "").rsplit(".", 1)[-1]


def _tuple(value: Any) -> tuple:
    return (value,) if isinstance(value, Evidence) else tuple(value)


def _names(of: Mapping[Any, Any] | None) -> dict[str, Any]:
    return {(k.tree[1] if isinstance(k, Expr) else k): v for k, v in (of or {}).items()}
