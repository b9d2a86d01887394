# SPDX-License-Identifier: MIT
"""Results kept between runs.

A run appends each result, as it comes, to ``results.jsonl`` in the state
folder, so that an interrupted run goes on where it stopped. A result is found
again by a digest of what it depends on: statement, evidence, correction, the
claims it leans on, the seed, and the code of this version. An edited claim
therefore runs again, and nothing else does.

Main definitions
----------------
`Store`
    The folder: results and the certificates that belong to them.
`claim_key`
    The digest of a claim.
`state_folder`
    Where the folder is, by option, environment or default.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from exactkf.claims import Claim
from exactkf.digest import code_digest
from exactkf.evidence import Evidence
from exactkf.files import check_folder, dump_json, reaching, write_text

__all__ = ["Store", "claim_key", "state_folder"]

# the parts of the package that can change a result, and those in them that cannot
_ENGINE = ("_errors.py", "_wording.py", "claims.py", "engine.py", "evidence.py", "exact", "finders", "kernel", "language", "theory")
_FIELDS = {"id", "paper", "section", "title", "verdict", "strength", "sizes", "reason", "repair", "certificates", "mutants", "checks", "seconds",
           "evidence", "witness", "counterexample", "denominators", "neighbours", "note"}
_PRINTING = ("latex.py", "latex_notation.py", "names.py", "notation.py", "text.py")


def state_folder(option: str | os.PathLike | None = None) -> Path:
    """The state folder: the option, else EXACTKF_STATE, else ``.exactkf`` in the current folder."""
    return Path(option or os.environ.get("EXACTKF_STATE") or ".exactkf")


def claim_key(claim: Claim, claims: Mapping[str, Claim], seed: int = 0) -> str:
    """Digest of everything that the result of a claim depends on."""
    data = [code_digest(_ENGINE, _PRINTING), seed, _described(claim), [_described(c) for c in _leans_on(claim, claims, {claim.id})]]
    return hashlib.sha256(json.dumps(data, sort_keys=True, default=str).encode()).hexdigest()


def _described(claim: Claim) -> list:
    fixed = claim.repair
    return [
        claim.id, claim.title, claim.section, claim.reason, claim.note,
        claim.statement.digest_text() if claim.statement else None, _evidence(claim.by),
        [fixed.kind, fixed.wrong, fixed.statement.digest_text(), _evidence(fixed.by)] if fixed else None,
    ]


def _evidence(by: tuple[Evidence, ...]) -> list:
    return [[e.kind, dict(e.hints)] for e in by]


def _leans_on(claim: Claim, claims: Mapping[str, Claim], seen: set[str]) -> Iterator[Claim]:
    """Claims that the evidence names, and those that theirs names."""
    every = (*claim.by, *(claim.repair.by if claim.repair else ()))
    for id in [i for e in every for i in (*e.hints.get("ids", ()), e.hints.get("covered_by", ""))]:
        if id in claims and id not in seen:
            seen.add(id)
            yield claims[id]
            yield from _leans_on(claims[id], claims, seen)


class Store:
    """The state folder.

    Parameters
    ----------
    folder : Path
        Made when the first result is kept. To look at what is kept, it need not be writable.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._results: dict[str, dict[str, Any]] = {}
        with reaching("--state", folder, "read"):
            self._read()

    def check_writable(self) -> None:
        """Refuse a folder that results cannot be kept in, before any work is done."""
        check_folder(self.folder, "--state")

    @property
    def file(self) -> Path:
        """The results, one JSON object a line, later lines first in authority."""
        return self.folder / "results.jsonl"

    def _read(self) -> None:
        if self.folder.exists() and not self.folder.is_dir():
            check_folder(self.folder, "--state")
        if not self.file.is_file():
            return
        with open(self.file, encoding="utf-8", errors="replace") as lines:
            for line in lines:
                try:
                    entry = json.loads(line)
                    if _is_result(entry["result"]):
                        self._results[entry["key"]] = entry["result"]
                except (ValueError, KeyError, TypeError):
                    continue  # a line cut short when the run was stopped

    def get(self, key: str, *, unfinished: bool = False) -> dict[str, Any] | None:
        """The result kept under a key, if its certificates are still there.

        A result that was killed or crashed is no result; it is given only if asked for.
        """
        result = self._results.get(key)
        if result is None or (result.get("unfinished") and not unfinished):
            return None
        return result if all((self.folder / c).is_file() for c in result["certificates"]) else None

    def put(self, key: str, result: Mapping[str, Any]) -> dict[str, Any]:
        """Keep a result; its certificates become files, named in the result that is returned."""
        with reaching("--state", self.folder):
            return self._put(key, result)

    def _put(self, key: str, result: Mapping[str, Any]) -> dict[str, Any]:
        names = []
        for number, certificate in enumerate(result["certificates"], 1):
            stem = f"{file_stem(result['id'])}-{number}-{certificate.get('kind', 'certificate').replace(' ', '-')}"
            name = f"certificates/{key[:16]}/{stem}.json"
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            write_text(self.folder / name, dump_json(certificate, indent=None))
            names.append(name)
        kept = {**result, "certificates": names}
        self.folder.mkdir(parents=True, exist_ok=True)
        with open(self.file, "a", encoding="utf-8") as file:
            file.write(self._start_of_line() + json.dumps({"key": key, "result": kept}, separators=(",", ":")) + "\n")
        self._results[key] = kept
        return kept

    def _start_of_line(self) -> str:
        """A newline if the last line was cut short."""
        with open(self.file, "rb") as file:
            if file.seek(0, os.SEEK_END) == 0:
                return ""
            file.seek(-1, os.SEEK_END)
            return "" if file.read(1) == b"\n" else "\n"


def _is_result(data: Any) -> bool:
    """Whether a line of the file has the fields of a result; one that was edited may not, and the claim runs again."""
    return isinstance(data, dict) and _FIELDS <= data.keys() and isinstance(data["certificates"], list) and isinstance(data["mutants"], dict)


def file_stem(id: str) -> str:
    """An id as part of a file name."""
    return "".join(c if c.isalnum() or c in "-_." else "_" for c in id)
