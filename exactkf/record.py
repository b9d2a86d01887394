# SPDX-License-Identifier: MIT
"""The record: which verdict, with which strength, each claim has reached.

It is a file next to the claims, ``verdicts.json``, with a table to read,
``VERDICTS.md``; both are written from runs and from nothing else. A run falls
short where a claim does not reach what is on record.

Main definitions
----------------
`Record`
    Read, compare, update, write.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from importlib import resources
from pathlib import Path
from typing import Any

from exactkf._errors import BadInput
from exactkf.claims import Claim
from exactkf.files import check_target, dump_json, reaching, write_text

__all__ = ["STRENGTHS", "Record"]

#: strongest first; the vocabulary of the engine, here without importing it
STRENGTHS = ("proved", "proved-sizes", "steps", "instances", "enclosed")
NOT_ON_RECORD = "nothing is on record"
_HEADING = ("| claim | what | verdict | strength | |", "| --- | --- | --- | --- | --- |")
_REMEDY = "restore it, or write a new one with 'exactkf verify --record'"


class Record:
    """Verdicts and strengths on record, by id.

    Parameters
    ----------
    entries : mapping of id to dict
        Each with ``verdict``, ``strength``, ``sizes`` and ``repair`` (its verdict, strength and kind).
    """

    def __init__(self, entries: Mapping[str, dict[str, Any]] | None = None) -> None:
        self.entries = dict(entries or {})

    @classmethod
    def read(cls, package: str = "proofs") -> Record:
        """The record shipped with a package of claims; an empty one if it has none."""
        file = resources.files(package) / "verdicts.json"
        if not file.is_file():
            return cls()
        try:
            return cls(json.loads(file.read_text(encoding="utf-8"))["claims"])
        except (ValueError, KeyError, TypeError) as error:
            raise BadInput(f"record {str(file)!r} is unreadable ({error}); {_REMEDY}") from error

    def shortfall(self, result: Mapping[str, Any]) -> str:
        """In what a result falls short of the record; empty if it does not."""
        entry = self.entries.get(result["id"])
        if entry is None:
            return NOT_ON_RECORD
        worse = _worse(entry, result)
        if worse or entry["verdict"] != "fails" or not entry.get("repair"):
            return worse
        if not result["repair"]:
            return "the correction on record is missing"
        worse = _worse(entry["repair"], result["repair"])
        return f"correction: {worse}" if worse else ""

    def gone(self, claims: Mapping[str, Claim]) -> list[str]:
        """What is on record and is no claim any more, in alphabetical order."""
        return sorted(set(self.entries) - set(claims))

    def update(self, results: Iterable[Mapping[str, Any]]) -> list[str]:
        """Enter the results; one line for each entry that changes."""
        changes = []
        for result in results:
            new, old = _entry(result), self.entries.get(result["id"])
            if old != new:
                changes.append(f"{result['id']}: {_words(old) if old else 'new'} -> {_words(new)}")
                self.entries[result["id"]] = new
        return changes

    def write(self, claims: Mapping[str, Claim], package: str = "proofs") -> None:
        """Write ``verdicts.json`` and ``VERDICTS.md``; claims that are no more drop out."""
        files = record_files(package)
        self.entries = {id: e for id, e in self.entries.items() if id in claims}
        texts = dump_json({"claims": {id: self.entries[id] for id in sorted(self.entries)}}), self.table(claims)
        for file, text in zip(files, texts, strict=True):
            with reaching("--record", file):
                write_text(file, text)

    def table(self, claims: Mapping[str, Claim]) -> str:
        """The record as Markdown, by paper, in reading order."""
        lines = ["# Verdicts on record", "", "Written by `exactkf verify --record`."]
        paper = ""
        for claim in claims.values():
            entry = self.entries.get(claim.id)
            if entry is None:
                continue
            if claim.paper != paper:
                paper = claim.paper
                lines += ["", f"## {paper}", "", *_HEADING]
            cells = (claim.id, claim.title, entry["verdict"], _strength(entry), _remark(entry))
            lines.append("| " + " | ".join(c.replace("|", "\\|").replace("\n", " ") for c in cells) + " |")
        return "\n".join(lines) + "\n"


def record_files(package: str = "proofs") -> tuple[Path, Path]:
    """Where the record and its table are written; refused if that is not possible."""
    folder = Path(str(resources.files(package)))
    first, second = folder / "verdicts.json", folder / "VERDICTS.md"
    return check_target(first, "--record"), check_target(second, "--record")


def _entry(result: Mapping[str, Any]) -> dict[str, Any]:
    fixed = result["repair"]
    return {
        "verdict": result["verdict"], "strength": result["strength"], "sizes": result["sizes"],
        "reason": result["reason"],
        "repair": {k: fixed.get(k) for k in ("verdict", "strength", "sizes", "kind")} if fixed else None,
    }


def _worse(old: Mapping[str, Any], new: Mapping[str, Any]) -> str:
    """Why the new standing does not reach the old one; an open claim that is settled now does."""
    if old["verdict"] == "open":
        return ""
    if new["verdict"] != old["verdict"] or _rank(new["strength"]) > _rank(old["strength"]):
        why = f" ({new['reason']})" if new.get("reason") else ""
        return f"on record: {_words(old)}; now: {_words(new)}{why}"
    if _rank(new["strength"]) == _rank(old["strength"]):
        for name, values in (old.get("sizes") or {}).items():
            missing = set(values) - set((new.get("sizes") or {}).get(name, ()))
            if missing:
                return f"on record: also {name} = {', '.join(map(str, sorted(missing)))}"
    return ""


def _rank(strength: str | None) -> int:
    return STRENGTHS.index(strength) if strength in STRENGTHS else len(STRENGTHS)


def _words(entry: Mapping[str, Any]) -> str:
    return " ".join(filter(None, (entry["verdict"], entry["strength"])))


def _strength(entry: Mapping[str, Any]) -> str:
    fixed = entry.get("repair")
    return entry["strength"] or (f"corrected: {_words(fixed)}" if fixed else "")


def _remark(entry: Mapping[str, Any]) -> str:
    if entry.get("repair"):
        return entry["repair"].get("kind") or ""
    if entry["verdict"] == "open":
        return entry.get("reason") or ""
    return "; ".join(f"{k} = {', '.join(map(str, v))}" for k, v in (entry.get("sizes") or {}).items())
