# SPDX-License-Identifier: MIT
"""Evidence that shows nothing of what it is for, and files that are no certificates: each is refused, in one line."""

from __future__ import annotations

import json

import pytest

from exactkf.check import check_paths
from exactkf.kernel.__main__ import main
from exactkf.kernel.replay import NotACertificate, replay, seal
from tests.kernel.test_false_claims import accepted, statement

n, t, k, x = (["sym", name] for name in ("n", "t", "k", "x"))
SCALAR = [["x", ["scalar"]]]
TRUE = statement(["=", ["-", x, x], 0], SCALAR, sizes=[])


# ---------------------------------------------------------------------- evidence
def test_a_parameter_has_a_value_in_every_case():
    """A range that is empty for n = 2 leaves nothing to be looked at there."""
    made, cases = statement(["=", n, 1], []), [{"n": 1}, {"n": 2}]
    assert not accepted("identity", made, {"cases": cases, "parameters": [["q", ["integer", 0, ["-", 1, n]]]]})
    true = {**made, "says": ["=", n, n]}
    assert accepted("identity", true, {"cases": cases, "parameters": [["q", ["integer", 0, ["-", 2, n]]]]})


def test_exponents_are_those_of_a_state():
    """f(t) = z X[t] has the exponent one, whatever the evidence says of a function."""
    where = [["rec", "X", "t", 0, [1], ["at", "X", t]], ["let", "f", ["k"], ["*", ["z"], ["at", "X", k]]],
             ["rec", "W", "t", 0, [0], ["coeff", ["at", "f", t], 1]]]
    made = statement(["always", "t", ["=", ["at", "W", t], 0]], [], (), where, [])
    assert not accepted("induction", made, {"cases": [{}], "support": {"f": [0]}})
    assert accepted("counterexample", made, {"instance": {"sizes": {"horizon": 1}, "values": {}}})
    assert accepted("induction", {**made, "says": ["always", "t", ["=", ["coeff", ["at", "X", t], 1], 0]]}, {"cases": [{}], "support": {"X": [0]}})


def test_a_size_is_a_number():
    """True is no size, and a size is no formula."""
    for size, says in ((True, n), (True, ["=", n, 1]), (1, n)):
        assert not accepted("instances", statement(says, []), {"instances": [{"sizes": {"n": size}, "values": {}}]})


@pytest.mark.parametrize("kind, says, over, evidence", [
    ("instances", ["always", "t", ["=", 0, 0]], [], {"instances": [{"sizes": {"horizon": 10**12}, "values": {}}]}),
    ("identity", ["=", ["sym", "A"], ["sym", "A"]], [["A", ["matrix", n, n]]], {"cases": [{"n": 10**9}]}),
    ("identity", ["=", ["at", "s", 0], ["at", "s", 0]], [["s", ["sequence", 0, 10**12]]], {"cases": [{"n": 1}]}),
    ("evaluation", ["=", ["sum", "k", 1, 10**12, 0], 0], [], {"cases": [{"n": 1}]}),
    ("evaluation", ["=", ["sym", "m"], ["sym", "m"]], [["m", ["integer", 0, 10**12]]], {"cases": [{"n": 1}]}),
    ("generic index", ["=", ["sum", "k", 0, 10**9, x], 0], SCALAR, {"lemmas": []}),
    ("generic index", ["=", ["^", x, 10**9], ["^", x, 10**9]], SCALAR, {"lemmas": []}),
    ("membership", ["=", ["^", x, 10**9], ["^", x, 10**9]], SCALAR, {"terms": [[]]}),
])
def test_nobody_waits_for_a_long_range(kind, says, over, evidence):
    """What would take for ever is refused at once."""
    assert not accepted(kind, statement(says, over), evidence)


# ---------------------------------------------------------------------- files
def written(folder, text):
    file = folder / "c.json"
    file.write_text(text, encoding="utf-8")
    return file


def judged(file, capsys):
    """Exit status and lines of both commands that read certificates."""
    status = check_paths([file])
    lines = [x for x in "".join(capsys.readouterr()).splitlines() if not x.endswith("replay")]
    assert main([str(file)]) == status
    return status, [*lines, *"".join(capsys.readouterr()).splitlines()]


def test_a_key_that_stands_twice_is_refused(tmp_path, capsys):
    """People read the first value, and a checker the last."""
    good = json.dumps(seal("X", "identity", TRUE, {"cases": [{}]}))
    assert judged(written(tmp_path, good), capsys) == (0, [])
    twice = good.replace('"says": ', '"says": ["=", 0, 1], "says": ')
    status, lines = judged(written(tmp_path, twice), capsys)
    assert status == 2 and len(lines) == 2 and all("'says' stands twice" in line for line in lines)


@pytest.mark.parametrize("number", ["NaN", "Infinity", "-Infinity", "1.0", "1e999999999"])
def test_a_number_is_an_integer(number, tmp_path, capsys):
    """Certificates have fractions as strings."""
    text = json.dumps(seal("X", "identity", TRUE, {"cases": [{}], "note": 0})).replace('"note": 0', f'"note": {number}')
    status, lines = judged(written(tmp_path, text), capsys)
    assert status == 2 and len(lines) == 2


@pytest.mark.parametrize("name", ["\ud800", "A\n9 of 9 certificates replay", "\x1b[2J"])
def test_a_name_stays_on_its_line(name, tmp_path, capsys):
    """Whatever a certificate rests on is written out, and nothing else is said by it."""
    evidence = {"cases": [{}], "given_by": {"x": 0}, "covered_by": name}
    status, lines = judged(written(tmp_path, json.dumps(seal("X", "identity", TRUE, evidence))), capsys)
    assert status == 0 and all(line.isprintable() and "replays assuming" in line for line in [lines[0], lines[-1]])
    assert len([line for line in lines if "assuming" in line and "of 1" not in line]) == 2


def test_ids_and_what_covers_are_strings():
    """Nothing else is a name."""
    with pytest.raises(NotACertificate):
        replay(seal(["X"], "identity", TRUE, {"cases": [{}]}))
    for cover in ({"a": 1}, ["A"], 1, True, " "):
        assert not accepted("identity", TRUE, {"cases": [{}], "given_by": {"x": 0}, "covered_by": cover})
