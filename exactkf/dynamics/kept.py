# SPDX-License-Identifier: MIT
r"""The answers about many filters in a file, which a run that was stopped goes on from.

Main definitions
----------------
``Kept``         the file: what an earlier run left there, and what comes now
``record_of``    an answer as the file has it
``outcome_of``   the answer back from there

Notation
--------
A record has a ``key``: a digest of what the answer depends on and one of the answer.  It is taken from the file if the first is that of a filter
asked about now, with this code, and the second is right, so that a line that was cut short or edited is not believed.  What is left open may
depend on the time limit, so that its key does.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields
from pathlib import Path
from typing import IO, Any

from exactkf._errors import BadInput
from exactkf.digest import code_digest
from exactkf.dynamics.answer import Answer, Fact
from exactkf.dynamics.many import Outcome
from exactkf.files import dump_json, reaching, write_text

__all__ = ["Kept", "key_of", "outcome_of", "record_of"]

_CODE = ("_errors.py", "dynamics", "exact", "kernel", "theory")
_HALF = 32  # characters of each digest in a key


def key_of(data: Mapping[str, Any], certificate: str | None, time_limit: float | None = None) -> str:
    """Digest of a filter, of the certificate that a folder has for it, and of the code; with the time limit for what is left open."""
    return _digest([code_digest(_CODE), data, certificate, time_limit])


def record_of(label: str, outcome: Outcome) -> dict[str, Any]:
    """An answer without certificate and structure, or why a filter is refused."""
    if not isinstance(outcome, Answer):
        return {"filter": label, "error": str(outcome)}
    data = {**outcome.without_certificate(), "limit": outcome.limit, "rate": outcome.rate, "slow": outcome.slow}
    del data["certificate"], data["structure"]
    return {"filter": label, **data}


def outcome_of(record: Mapping[str, Any]) -> Outcome:
    """The answer, or the refusal, that `record_of` wrote."""
    if "error" in record:
        return BadInput(record["error"])
    entries = {f.name: record[f.name] for f in fields(Answer) if f.name in record}
    entries["facts"] = tuple(Fact(**fact) for fact in entries["facts"])
    return Answer(**{**entries, "beside": tuple(entries["beside"])})


class Kept:
    """A file of records, one a line if it ends in .jsonl, else a list.

    Lines are written as they come, a list at the end.  A device or a pipe is written at the end, and not read.

    Parameters
    ----------
    path : Path, optional
        Without it nothing is kept.
    fresh : bool
        Believe nothing that is there.
    """

    def __init__(self, path: Path | None, *, fresh: bool = False) -> None:
        self.path = path
        self._lines = path is not None and path.suffix.lower() == ".jsonl"
        self._stream: IO[str] | None = None
        self._there = {} if fresh or path is None or not path.is_file() else {r["key"][:_HALF]: r for r in _read(path, self._lines) if _is_whole(r)}

    def found(self, keys: Iterable[str]) -> dict[str, Any] | None:
        """What the file has under one of the keys."""
        return next((self._there[key] for key in keys if key in self._there), None)

    def begin(self, records: Iterable[Mapping[str, Any]]) -> None:
        """Begin the lines anew with some records; more are added as they come."""
        if self._lines and self.path is not None and (self.path.is_file() or not self.path.exists()):
            with reaching("--json", self.path):
                self.end(records)
                self._stream = open(self.path, "a", encoding="utf-8", newline="\n")  # noqa: SIM115  `end` closes it

    def add(self, key: str, record: dict[str, Any]) -> dict[str, Any]:
        """Give a record its key, and write it if there are lines."""
        record = {**record, "key": key + _content(record)}
        if self._stream and self.path is not None:
            with reaching("--json", self.path):
                self._stream.write(dump_json(record, indent=None))
                self._stream.flush()
        return record

    def end(self, records: Iterable[Mapping[str, Any]]) -> None:
        """Write the records, in place of all that is there."""
        if self.path is None:
            return
        with reaching("--json", self.path):
            if self._stream:
                with contextlib.suppress(OSError):  # a line that did not fit; it is written again now, or that is refused
                    self._stream.close()
                self._stream = None
            write_text(self.path, "".join(dump_json(r, indent=None) for r in records) if self._lines else dump_json(list(records)))


def _read(path: Path, lines: bool) -> Iterator[Any]:
    """Whatever JSON there is."""
    with contextlib.suppress(OSError):  # it may be written and not read
        text = path.read_text(encoding="utf-8", errors="replace")
        for part in text.splitlines() if lines else [text]:
            with contextlib.suppress(ValueError, RecursionError):
                found = json.loads(part)
                yield from [found] if lines else found if isinstance(found, list) else []


def _is_whole(record: Any) -> bool:
    """Whether a record is as it was written."""
    return isinstance(record, dict) and isinstance(record.get("key"), str) and record["key"][_HALF:] == _content(record)


def _content(record: Mapping[str, Any]) -> str:
    """Digest of a record but for its key, and for the label, which may have changed."""
    return _digest({name: value for name, value in record.items() if name not in ("filter", "key")})


def _digest(data: Any) -> str:
    return hashlib.sha256(json.dumps(data, sort_keys=True, default=str).encode()).hexdigest()[:_HALF]
