# SPDX-License-Identifier: MIT
"""Files that the caller names: refused early where they cannot be, written whole or not at all."""

from __future__ import annotations

import contextlib
import json
import os
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from exactkf._errors import BadInput

__all__ = ["check_folder", "check_target", "dump_json", "reaching", "write_text"]


@contextlib.contextmanager
def reaching(argument: str, path: Path, done: str = "written") -> Iterator[None]:
    """Turn what the system says of a path into one line: the argument, its value, the reason, the remedy.

    Raises
    ------
    BadInput
        In place of an OSError.
    """
    try:
        yield
    except OSError as error:
        raise BadInput(f"argument {argument} = {str(path)!r} cannot be {done} ({error.strerror or error}); choose another place") from error


def check_target(path: Path, argument: str) -> Path:
    """Refuse a file that could not be written, before any work is done.

    Raises
    ------
    BadInput
        Naming ``argument``, the path and the remedy.
    """
    with reaching(argument, path):
        if path.is_dir():
            raise BadInput(f"argument {argument} = {str(path)!r} is a folder; name a file in it")
        folder = path.absolute().parent
        if not folder.is_dir():
            raise BadInput(f"argument {argument} = {str(path)!r} lies in a folder that does not exist; "
                           f"create {str(folder)!r} first")
        if not os.access(path if path.exists() else folder, os.W_OK):
            raise BadInput(f"argument {argument} = {str(path)!r} cannot be written; choose a place you may write to")
    return path


def check_folder(path: Path, argument: str) -> Path:
    """Refuse a folder that cannot be made or written, before any work is done."""
    with reaching(argument, path):
        if path.exists() and not path.is_dir():
            raise BadInput(f"argument {argument} = {str(path)!r} is a file; name a folder")
        above = path.absolute()
        while not above.exists():
            above = above.parent
        if not above.is_dir() or not os.access(above, os.W_OK):
            raise BadInput(f"argument {argument} = {str(path)!r} cannot be written; choose a place you may write to")
    return path


def write_text(path: Path, text: str) -> None:
    """Write a text file: a reader sees the old contents or the new, never a part.

    A link stays a link. A device or a pipe, such as /dev/stdout, is written to: a file in its place would take it away from everyone.
    """
    if path.exists() and not path.is_file():
        path.write_text(text, encoding="utf-8", newline="\n")
        return
    path = Path(os.path.realpath(path))
    handle, temporary = tempfile.mkstemp(dir=path.absolute().parent, prefix=f".{path.name}.", suffix=".part")
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        os.chmod(temporary, 0o666 & ~_umask())  # mkstemp makes private files
        os.replace(temporary, path)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(temporary)
        raise


def dump_json(data: Any, *, indent: int | None = 1) -> str:
    """JSON text with a newline at the end; the order of keys is the writer's."""
    return json.dumps(data, indent=indent, ensure_ascii=False, allow_nan=False) + "\n"


def _umask() -> int:
    mask = os.umask(0o022)
    os.umask(mask)
    return mask
