# SPDX-License-Identifier: MIT
"""Comparison with the record."""

import json

import pytest

from exactkf import BadInput
from exactkf.record import Record


def result(verdict="holds", strength="proved-sizes", sizes=None, repair=None, reason=None):
    return {"id": "X-1", "verdict": verdict, "strength": strength, "sizes": sizes, "repair": repair, "reason": reason}


def corrected(strength):
    return result("fails", None, repair=result("holds", strength))


def on_record(*args, **kwargs):
    record = Record()
    record.update([result(*args, **kwargs)])
    return record


@pytest.mark.parametrize(("old", "new", "short"), [
    (result(), result(), ""),
    (result(), result(strength="proved"), ""),
    (result(), result(strength="instances"), "on record: holds proved-sizes; now: holds instances"),
    (result(), result("open", None, reason="out of time"), "on record: holds proved-sizes; now: open (out of time)"),
    (result(), result("fails", None), "on record: holds proved-sizes; now: fails"),
    (result("open", None), result(), ""),
    (result("open", None), result("open", None), ""),
    (result(sizes={"n": [1, 2, 3]}), result(sizes={"n": [1]}), "on record: also n = 2, 3"),
    (result(sizes={"n": [1]}), result(sizes={"n": [1, 2]}), ""),
    (result(sizes={"n": [1]}), result(strength="proved"), ""),
    (corrected("proved"), result("fails", None), "the correction on record is missing"),
    (corrected("proved"), corrected("instances"), "correction: on record: holds proved; now: holds instances"),
    (corrected("steps"), corrected("proved"), ""),
])
def test_shortfall(old, new, short):
    record = Record()
    record.update([old])
    assert record.shortfall(new) == short


def test_what_is_not_on_record_falls_short():
    assert "nothing is on record" in Record().shortfall(result())


def test_update_tells_what_changes():
    record = on_record("open", None)
    assert record.update([result()]) == ["X-1: open -> holds proved-sizes"]
    assert record.update([result()]) == []


def test_a_claim_that_is_lost_falls_short(paper):
    """A run of all claims names what is on record and is no claim any more; a run of some does not look; --record drops it."""
    p = paper("ok", engine="exactkf.engine")
    p.run("verify", "--record", engine="exactkf.engine")
    file = p.root / "fake_proofs/verdicts.json"
    record = json.loads(file.read_text())
    record["claims"]["AAA-E9"] = record["claims"]["AAA-E1"]
    file.write_text(json.dumps(record))
    done = p.run("verify", engine="exactkf.engine")
    assert done.exit_code == 1 and "fell short: AAA-E9: is on record, and no module of claims has it" in done.stdout, done.output
    assert "AAA-E9" not in p.run("verify", "AAA", engine="exactkf.engine").stdout
    assert "record: AAA-E9: is no claim any more" in p.run("verify", "--record", engine="exactkf.engine").stdout
    assert "AAA-E9" not in json.loads(file.read_text())["claims"]


def test_unreadable_record(tmp_path, monkeypatch):
    (tmp_path / "odd_proofs").mkdir()
    (tmp_path / "odd_proofs/__init__.py").write_text("")
    (tmp_path / "odd_proofs/verdicts.json").write_text("[1]")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(BadInput, match="unreadable"):
        Record.read("odd_proofs")


def test_list_says_what_is_corrected(paper):
    p = paper("ok", engine="exactkf.engine")
    p.run("verify", "--record", engine="exactkf.engine")
    lines = p.run("list", "AAA", engine="exactkf.engine").stdout.splitlines()
    assert lines[0].split("  ")[1] == "holds, proved" and lines[1].split("  ")[1] == "fails, corrected", lines
