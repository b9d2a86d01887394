# SPDX-License-Identifier: MIT
"""``python -m exactkf`` is the command ``exactkf``."""

from exactkf.cli import main

if __name__ == "__main__":
    main(prog_name="exactkf")
