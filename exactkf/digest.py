# SPDX-License-Identifier: MIT
"""What a result that is kept between runs depends on besides its data: the code that found it."""

from __future__ import annotations

import hashlib
from functools import cache
from pathlib import Path

import exactkf

__all__ = ["code_digest"]


@cache
def code_digest(parts: tuple[str, ...], without: tuple[str, ...] = ()) -> str:
    """SHA-256 of the version and the source of parts of the package.

    Parameters
    ----------
    parts : tuple of str
        Modules, ``"claims.py"``, and folders, ``"kernel"``.
    without : tuple of str
        Names of modules that cannot change a result.
    """
    root = Path(exactkf.__file__).parent
    total = hashlib.sha256(exactkf.__version__.encode())
    for part in parts:
        for file in [root / part] if part.endswith(".py") else sorted((root / part).rglob("*.py")):
            if file.is_file() and file.name not in without:
                total.update(f"{file.relative_to(root).as_posix()}\0".encode() + file.read_bytes())
    return total.hexdigest()
