# SPDX-License-Identifier: MIT
"""A small paper and an engine that does as it is told, both importable by worker processes."""

import sys
from types import SimpleNamespace

import pytest
from click.testing import CliRunner

import exactkf.claims
from exactkf.cli import Setup, main

NOTE = '# SPDX-License-Identifier: MIT\n"""{}"""\n'

CLAIMS = NOTE.format("The first section.\n\nIts mathematics, in a paragraph.") + '''
from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import identity, instances
from exactkf.language import given, matrix, scalar, standing, symbols, T

a, b, n, P, Q = symbols("a b n P Q")

claim("AAA-E1", "sums commute", a + b == b + a, over={a: scalar(), b: scalar()}, by=[identity(), instances(6)])
claim("AAA-E2", "transpose of a product", T(P * Q) == T(P) * T(Q), sizes=["n"], over={P: matrix(n, n), Q: matrix(n, n)},
      by=[identity(n=(1, 2)), instances(6, n=(1, 2))],
      repair=repair("order of factors", "the factors change places", T(P * Q) == T(Q) * T(P), sizes=["n"],
                    over={P: matrix(n, n), Q: matrix(n, n)}, by=[identity(n=(1, 2)), instances(6, n=(1, 2))]))
not_checked("AAA-E3", "a remark", "no assertion in it")
'''
MORE = NOTE.format("The second section.") + '''
from exactkf.claims import claim
from exactkf.evidence import instances
from exactkf.language import given, scalar, standing, symbols

a, = symbols("a")
for name in {names!r}:
    claim("BBB-" + name, name, a * a >= 0, over={{a: scalar()}}, by=instances(4),
          given=[given("positive <a>", a > 0), standing("small", a < 9)])
'''
ENGINE = NOTE.format("An engine that does what the title of a claim says.") + '''
import os
import time
from pathlib import Path

from exactkf.kernel.replay import seal
from exactkf.workers import unfinished


def verify_claim(claim, *, seed=0):
    with open(Path(__file__).with_name("calls.txt"), "a") as file:
        file.write(claim.id + "\\n")
    Path(__file__).with_name("worker.pid").write_text(str(os.getpid()))
    match claim.title:
        case "sleep": time.sleep(60)
        case "exit": os._exit(3)
        case "memory": raise MemoryError
        case "hungry": bytearray(16 * 2**30)
        case "raise": raise ValueError("no\\nway")
    statement = claim.statement.to_json() if claim.statement else {}
    made = seal(claim.id, "instances", statement, {"instances": [], "seed": seed})
    result = {**unfinished(claim, None), "verdict": "holds", "strength": "proved-sizes", "sizes": {"n": [1, 2, 3]},
              "certificates": [made], "checks": 7, "seconds": 0.25, "evidence": ["an identity"],
              "mutants": {"made": 5, "rejected": 4, "equal": 1, "survivors": []},
              "witness": {"sizes": {"n": 1}, "values": {"a": "1/2", "P": [["1", "<2>"]]}}}
    del result["unfinished"]
    return result


def mutate_claim(claim, *, seed=0):
    outcome = "survived" if claim.title == "weak" else "rejected"
    row = {"kind": "sign", "text": "a - b", "latex": "a-b", "outcome": outcome}
    return {"id": claim.id, "verdict": "holds", "rows": [row]}
'''


@pytest.fixture
def paper(tmp_path, monkeypatch):
    """Make a package of claims: ``paper("ok", "sleep")`` has one claim of each title beside the first three."""
    def make(*names, engine="fake_engine"):
        for key, section, text in (("aaa", "section_1", CLAIMS), ("bbb", "section_2", MORE.format(names=names))):
            folder = tmp_path / "fake_proofs" / key
            folder.mkdir(parents=True, exist_ok=True)
            (folder / "__init__.py").write_text(NOTE.format(f"Paper {key}, 1991."))
            (folder / f"{section}.py").write_text(text)
        (tmp_path / "fake_proofs" / "__init__.py").write_text("")
        (tmp_path / "fake_engine.py").write_text(ENGINE)
        forget()
        return SimpleNamespace(root=tmp_path, run=run, setup=Setup("fake_proofs", engine), calls=calls)

    def forget():
        monkeypatch.setattr(exactkf.claims, "_REGISTRY", {})
        for name in [m for m in sys.modules if m.split(".")[0] in ("fake_proofs", "fake_engine")]:
            del sys.modules[name]

    def run(*args, engine="fake_engine"):
        return CliRunner().invoke(main, [str(a) for a in args], obj=Setup("fake_proofs", engine))

    def calls():
        file = tmp_path / "calls.txt"
        return file.read_text().split() if file.exists() else []

    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("EXACTKF_STATE", raising=False)
    yield make
    forget()
