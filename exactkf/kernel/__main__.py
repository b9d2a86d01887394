# SPDX-License-Identifier: MIT
"""Replay certificates with the standard library alone: ``python -m exactkf.kernel FILE ...``."""

from __future__ import annotations

import sys

from exactkf.kernel.files import one_line, parsed
from exactkf.kernel.limits import patiently
from exactkf.kernel.replay import NotACertificate, Rejected, replay, rests_on


def main(paths: list[str]) -> int:
    """Exit status 0: all replay; 1: one does not; 2: not a certificate, or unreadable."""
    worst = 0
    for path in paths:
        try:
            with open(path, encoding="utf-8") as file:
                certificate = parsed(file.read())
            with patiently():
                replay(certificate)
            if needed := rests_on(certificate):
                print(one_line(f"{path}: replays assuming {needed} for its parametrisation to reach everything"))
        except Rejected as error:
            print(one_line(f"{path}: rejected: {error}"))
            worst = max(worst, 1)
        except IsADirectoryError:
            print(one_line(f"argument FILE = {path!r} is a folder; pass the files in it, such as {path.rstrip('/')}/*.json"), file=sys.stderr)
            worst = 2
        except OSError as error:
            print(one_line(f"argument FILE = {path!r} cannot be read ({error.strerror or error}); pass a file that you may read"), file=sys.stderr)
            worst = 2
        except (NotACertificate, ValueError, RecursionError) as error:
            print(one_line(f"{path}: {error}"), file=sys.stderr)
            worst = 2
    return worst


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
