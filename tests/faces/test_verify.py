# SPDX-License-Identifier: MIT
"""``exactkf verify``: runs, resumes, limits, compares, writes."""

import json
import os
import signal
import subprocess
import sys
import time

import pytest

import exactkf.commands
from exactkf import __version__
from exactkf.claims import load
from exactkf.store import Store, claim_key
from exactkf.workers import unfinished

FIELDS = {"id", "verdict", "strength", "sizes", "reason", "repair", "statement_latex", "certificates", "mutants",
          "checks", "seconds"}


def test_a_run_writes_what_the_contract_says(paper):
    p = paper("ok")
    done = p.run("verify", "--jobs", "1", "--json", "out.json", "--certificates", "certs", "--record")
    assert done.exit_code == 0, done.output
    data = json.loads((p.root / "out.json").read_text())
    assert list(data) == ["version", "claims", "totals"] and data["version"] == __version__
    assert [c["id"] for c in data["claims"]] == ["AAA-E1", "AAA-E2", "AAA-E3", "BBB-ok"]
    assert all(set(c) == FIELDS for c in data["claims"])
    first = data["claims"][0]
    assert first["sizes"] == {"n": [1, 2, 3]} and first["repair"] is None and first["reason"] is None
    assert first["mutants"] == {"made": 4, "rejected": 4}
    assert first["certificates"] == ["certs/AAA/AAA-E1-1-instances.json"]
    assert (p.root / first["certificates"][0]).is_file()
    assert r"\text{if}\ a > 0" in data["claims"][3]["statement_latex"]
    assert data["totals"] == {
        "claims": 4, "by_source": {"AAA": 3, "BBB": 1}, "by_verdict": {"holds": 4}, "by_strength": {"proved-sizes": 4},
        "checks": 28}

    record = json.loads((p.root / "fake_proofs/verdicts.json").read_text())
    assert list(record["claims"]) == sorted(record["claims"])
    assert record["claims"]["AAA-E1"]["strength"] == "proved-sizes"
    table = (p.root / "fake_proofs/VERDICTS.md").read_text()
    assert "| AAA-E1 | sums commute | holds | proved-sizes | n = 1, 2, 3 |" in table

    # everything is kept: nothing runs again, and the record is reached
    again = p.run("verify", "AAA", "--jobs", "1", "--json", "again.json")
    assert again.exit_code == 0 and "3 of 3 claims reached" in again.stdout
    assert len(p.calls()) == 4
    kept = json.loads((p.root / "again.json").read_text())["claims"][0]
    assert {**kept, "certificates": 0} == {**first, "certificates": 0}
    assert kept["certificates"][0].startswith(".exactkf/certificates/") and (p.root / kept["certificates"][0]).is_file()


def test_limits_and_crashes_are_open_and_run_again(paper):
    p = paper("exit", "memory", "raise", "sleep", "ok")
    done = p.run("verify", "BBB", "--jobs", "2", "--time-limit", "2", "--json", "out.json")
    assert done.exit_code == 1, done.output
    claims = json.loads((p.root / "out.json").read_text())["claims"]
    reasons = {c["id"][4:]: (c["verdict"], c["reason"]) for c in claims}
    assert reasons.pop("exit")[1].startswith("crashed: the worker ended")
    assert reasons == {
        "memory": ("open", "out of memory"), "ok": ("holds", None),
        "raise": ("open", "crashed: ValueError: no way"), "sleep": ("open", "out of time after 2 s")}
    assert "fell short: BBB-ok: nothing is on record" in done.stdout
    registry = load("fake_proofs")
    store = Store(p.root / ".exactkf")
    keys = {id: claim_key(c, registry) for id, c in registry.items()}
    assert store.get(keys["BBB-sleep"]) is None and store.get(keys["BBB-ok"])
    assert store.get(keys["BBB-sleep"], unfinished=True)["reason"] == "out of time after 2 s"


def test_memory_limit_is_set_in_the_worker(paper):
    resource = pytest.importorskip("resource")
    p = paper("hungry", "ok")
    done = p.run("verify", "BBB", "--memory-limit", "8000", "--json", "out.json", "--jobs", "1")
    assert done.exit_code == 1, done.output
    hungry, ok = json.loads((p.root / "out.json").read_text())["claims"]
    assert hungry["reason"] == "out of memory (8000 MB)" and ok["verdict"] == "holds"
    assert resource.getrlimit(resource.RLIMIT_AS)[0] != 8000 * 2**20


def test_interrupted_by_the_user(paper, monkeypatch):
    p = paper("ok")

    def interrupted(claims, *_, **__):
        yield {"id": claims[0].id}
        raise KeyboardInterrupt

    monkeypatch.setattr(exactkf.commands, "run", interrupted)
    done = p.run("verify", "--json", "out.json")
    assert done.exit_code == 130
    assert done.stderr == ("exactkf: stopped; 1 of 4 results are kept in '.exactkf': "
                           "the same command goes on from there\n")
    assert not (p.root / "out.json").exists()


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_ctrl_c_ends_the_workers(paper):
    p = paper("ok", "sleep")
    call = "from exactkf.cli import *; main(['verify', 'BBB', '--jobs', '1'], obj=Setup('fake_proofs', 'fake_engine'))"
    process = subprocess.Popen([sys.executable, "-c", call], stderr=subprocess.PIPE, text=True, start_new_session=True,
                               env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))})
    kept = Store(p.root / ".exactkf").file
    deadline = time.monotonic() + 60
    while (len(p.calls()) < 2 or not kept.exists() or not kept.read_text().endswith("\n")) and time.monotonic() < deadline:
        time.sleep(0.05)
    time.sleep(0.5)  # the result is on disk; let the program count it
    os.killpg(process.pid, signal.SIGINT)
    _, err = process.communicate(timeout=20)
    assert process.returncode == 130
    assert err.splitlines()[-1].startswith("exactkf: stopped; 1 of 2 results are kept"), err
    with pytest.raises(ProcessLookupError):
        os.kill(int((p.root / "worker.pid").read_text()), 0)


def test_store_survives_a_line_cut_short(paper):
    p = paper("ok")
    store = Store(p.root / "state")
    registry = load("fake_proofs")
    key = claim_key(registry["AAA-E1"], registry)
    result = unfinished(registry["AAA-E1"], "")
    del result["unfinished"]
    store.put(key, {**result, "certificates": [{"kind": "instances"}]})
    with open(store.file, "a") as file:
        file.write('{"key": "cut sh')
    store = Store(p.root / "state")
    assert store.get(key)["id"] == "AAA-E1"
    store.put("other", {**result, "id": "AAA-E2"})
    assert Store(p.root / "state").get("other")["id"] == "AAA-E2"
    next((p.root / "state/certificates").rglob("*.json")).unlink()
    assert Store(p.root / "state").get(key) is None


def test_key_follows_statement_evidence_and_seed(paper):
    paper("ok")
    before = load("fake_proofs")
    keys = {id: claim_key(c, before) for id, c in before.items()}
    assert len(set(keys.values())) == len(keys)
    assert claim_key(before["AAA-E1"], before, seed=1) != keys["AAA-E1"]
    p = paper("ok", "more")
    section = p.root / "fake_proofs/aaa/section_1.py"
    # of another length, since Python keeps compiled code for a file of the same size and the same second
    section.write_text(section.read_text().replace("instances(6)", "instances(12)"))
    paper_again = load("fake_proofs")
    changed = {id for id in keys if claim_key(paper_again[id], paper_again) != keys[id]}
    assert changed == {"AAA-E1"}


def test_a_real_run_and_its_certificates(paper):
    p = paper(engine="exactkf.engine")
    done = p.run("verify", "AAA", "-j", "1", "--json", "out.json", "--certificates", "certs", engine="exactkf.engine")
    claims = {c["id"]: c for c in json.loads((p.root / "out.json").read_text())["claims"]}
    assert (claims["AAA-E1"]["verdict"], claims["AAA-E1"]["strength"]) == ("holds", "proved"), done.output
    assert claims["AAA-E2"]["verdict"] == "fails" and claims["AAA-E2"]["repair"]["verdict"] == "holds"
    assert set(claims["AAA-E2"]["repair"]) == {"statement_latex", "verdict", "strength", "kind"}
    assert claims["AAA-E3"]["reason"] == "no assertion in it"
    checked = p.run("check", "certs")
    assert checked.exit_code == 0, checked.output
    shown = p.run("show", "AAA-E2", engine="exactkf.engine").output
    assert "the factors change places" in shown and "counterexample" in shown and "(P*Q)' = P'*Q'" in shown
