# SPDX-License-Identifier: MIT
"""Which functions of the checker a replay enters: what someone has to read who wants to trust it.

Main definitions
----------------
``entered``        a context in which the functions of the checker that are entered are noted
``reading_list``   the lines that they fill, file by file
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import CodeType, FrameType
from typing import Any

import exactkf.kernel

__all__ = ["entered", "reading_list"]

_HOME = Path(exactkf.kernel.__file__).parent


@contextmanager
def entered() -> Iterator[set[CodeType]]:
    """Note the functions of the checker that are entered meanwhile, in this thread."""
    home, found = f"{_HOME}{os.sep}", set[CodeType]()

    def note(frame: FrameType, event: str, _: Any) -> None:
        if event == "call" and frame.f_code.co_filename.startswith(home):
            found.add(frame.f_code)

    old = sys.getprofile()
    sys.setprofile(note)
    try:
        yield found
    finally:
        sys.setprofile(old)


def reading_list(codes: set[CodeType]) -> list[str]:
    """A line on the whole, then one for each file of the checker: the functions, each with its first and last line.

    A function inside another one is read with it.
    """
    files = dict[str, dict[int, tuple[int, str]]]()
    for code in codes:
        if "<locals>" not in code.co_qualname and not code.co_name.startswith("<"):
            files.setdefault(Path(code.co_filename).name, {})[code.co_firstlineno] = _last_line(code), code.co_qualname
    lines = sum(last - first + 1 for spans in files.values() for first, (last, _) in spans.items())
    whole = sum(len(file.read_text(encoding="utf-8").splitlines()) for file in _HOME.glob("*.py"))
    said = [f"what ran of the checker: {sum(map(len, files.values()))} functions, {lines} of its {whole} lines"]
    for name, spans in sorted(files.items()):
        said.append(f"  kernel/{name}: " + ", ".join(f"{called} {first}-{last}" for first, (last, called) in sorted(spans.items())))
    return said


def _last_line(code: CodeType) -> int:
    inner = [_last_line(c) for c in code.co_consts if isinstance(c, CodeType)]
    return max([line for *_, line in code.co_lines() if line is not None] + inner)
