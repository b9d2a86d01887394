# SPDX-License-Identifier: MIT
"""The same certificate in every run: the order in which names are met is that of the statement."""

import os
import subprocess
import sys

CALL = """
from exactkf.finders.completion import System
from exactkf.kernel.reader import Reader, relations
from exactkf.language import Statement, T, matrix, symbols, vector
n, F, a, b, c, d = symbols("n F a b c d")
products = (T(a) * F * b) * (T(c) * F * d) * (T(b) * c) * (T(d) * a) * (T(a) * c)
data = Statement(products * F == F * products, over={F: matrix(n, n), a: vector(n), b: vector(n), c: vector(n), d: vector(n)}, sizes=[n]).to_json()
reader = Reader(data)
sides = [reader.read(side) for side in data["says"][1:]]
system = System(reader, relations(reader), 8)
for blocks in sides:
    for row in blocks.grid:
        for poly in row:
            system.encode(poly)
print(len([k for k in system.chars if isinstance(k, tuple)]), list(system.chars))
"""


def test_names_are_encoded_in_one_order():
    """Whatever the interpreter's seed for hashing texts; with a set of names there was one certificate a seed."""
    printed = {subprocess.run([sys.executable, "-c", CALL], env={**os.environ, "PYTHONHASHSEED": seed}, capture_output=True, text=True, check=True).stdout
               for seed in "1234"}
    assert len(printed) == 1 and int(printed.pop().split()[0]) >= 2
