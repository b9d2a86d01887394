# SPDX-License-Identifier: MIT
"""Certificates of answers are whole: behaviour, structure, speed and the state far ahead replay."""

from __future__ import annotations

import json
import random

import pytest
from click.testing import CliRunner
from flint import fmpq

from exactkf._errors import BadInput
from exactkf.cli import main
from exactkf.dynamics import certify_ahead, decide, decide_order_one, decide_riccati_one, rate_digits
from exactkf.exact import cyclotomic_real, sqrt_field
from exactkf.kernel.replay import replay
from tests.dynamics.starts import algebraic_start, rational_start
from tests.dynamics.test_every_order import start


def replays(certificate):
    """Read back from JSON it is accepted, and nothing of the answer is missing."""
    read = json.loads(json.dumps(certificate))
    assert replay(read) == [] and {"rate", "slow", "structure"} <= set(read["statement"]["answer"])
    return read["statement"]


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_random_rational_starts(n):
    """Orders one to four, common factors and zeros on the circle included; states after few steps and after a trillion."""
    rng, done = random.Random(n), 0
    while done < 8:
        pair = start(rng, n)
        if pair is None:
            continue
        done += 1
        answer = decide(*pair, max_steps=40)
        statement = replays(certify_ahead(answer, rng.choice((0, 2, 60, 10**12)), 20))
        assert statement["answer"]["structure"] == json.loads(json.dumps(answer.structure))
        assert (statement["answer"]["rate"], statement["answer"]["slow"]) == (answer.rate, answer.slow)


@pytest.mark.parametrize("field", [sqrt_field(2), cyclotomic_real(7)])
def test_random_starts_over_a_field(field):
    """Orders one and two over Q(sqrt 2) and Q(cos(2 pi/7)); the state before the reduction ends, too."""
    rng, x = random.Random(1), field.gen()
    for k in range(6):
        a, g = ([field(rng.randint(-2, 2)) + x * rng.choice((0, 1, -1)) for _ in range(1 + k % 2)] for _ in range(2))
        replays(certify_ahead(decide(a, g, max_steps=40), rng.choice((0, 3, 10**6)), 20))


def test_orders_one_and_the_riccati_equation():
    """Both systems of order one, rational and not; there is no state far ahead of a Riccati equation."""
    rng = random.Random(2)
    for _ in range(20):
        replays(certify_ahead(decide_order_one(*(rational_start(rng) if rng.random() < 0.5 else algebraic_start(rng))), rng.choice((0, 5, 10**9)), 15))
        replays(decide_riccati_one(*rational_start(rng), fmpq(rng.randint(-9, 9), rng.randint(1, 5))).certificate)
    with pytest.raises(BadInput, match="Riccati"):
        certify_ahead(decide_riccati_one("1/2", "1/3", "9/10"), 5)


def test_a_cyclic_vector_is_found_where_both_eigenvalues_are_rational():
    """D proportional to (z^2 - 1)^2: two blocks of size two, and a vector with equal entries is not cyclic."""
    found = replays(decide([fmpq(-3, 4), fmpq(-4, 3)], [fmpq(3, 8), fmpq(1, 6)]).certificate)["answer"]
    assert sorted(block["size"] for block in found["structure"]["jordan"]) == [2, 2] and found["slow"] == 2


def test_the_exact_state_and_what_it_needs():
    """Exact states of rational data, not of others; the numbers of the certificate are those of the state."""
    from exactkf.dynamics import state_ahead

    a, g = [fmpq(1), fmpq(-1)], [fmpq(2), fmpq(0)]
    said = replays(certify_ahead(decide(a, g), 400, exact=True))["ahead"]["exact"]
    state = state_ahead(a, g, 400).state
    assert [[fmpq(int(x, 16), int(said["denominator"], 16)) for x in said[k]] for k in "ag"] == [list(v) for v in state]
    root = sqrt_field(2).gen()
    with pytest.raises(BadInput, match="exact = True"):
        certify_ahead(decide_order_one(root, root / 3), 5, exact=True)
    with pytest.raises(BadInput):
        certify_ahead(decide_order_one(2, 3), -1)


def test_the_command_puts_the_state_into_the_certificate(tmp_path):
    """With --after the certificate, in its file and in the JSON, has the state; an escape before is said there as well."""
    for given, T, escape in ((("--alpha", "0,2", "--gamma", "1/2,1/3"), 10**12, None), (("--alpha", "-3/2", "--gamma", "1/2"), 10, 1)):
        done = CliRunner().invoke(main, ["analyze", *given, "--after", str(T), "--certificate", str(tmp_path / "c.json"), "--json", str(tmp_path / "a.json")])
        assert done.exit_code == 0, done.output
        certificate = json.loads((tmp_path / "c.json").read_text())
        statement = replays(certificate)
        assert (statement["ahead"]["steps"], statement["ahead"]["escape"]) == (T, escape)
        assert json.loads((tmp_path / "a.json").read_text())["certificate"] == certificate
    done = CliRunner().invoke(main, ["analyze", "--alpha", "1/3", "--gamma", "1/2", "--pi0", "1/7", "--after", "5", "--certificate", str(tmp_path / "r.json")])
    assert "speaks of the Riccati equation only" in done.stdout
    assert "ahead" not in replays(json.loads((tmp_path / "r.json").read_text()))


def test_digits_of_a_rate_need_no_certificate():
    """The question is known without one."""
    answer = decide([fmpq(-1, 2), fmpq(1, 3), fmpq(1, 5)], [fmpq(1, 4), fmpq(0), fmpq(1, 7)])
    assert answer.behaviour == "converges" and rate_digits(answer, 40).rel_accuracy_bits() > 130
    assert "certificate" not in answer.__dict__
