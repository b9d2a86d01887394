# SPDX-License-Identifier: MIT
"""Certificates of orbits of order one: what was decided replays, and nothing else does."""

from __future__ import annotations

import copy
import json
import subprocess
import sys
from fractions import Fraction
from random import Random

import pytest
from flint import fmpq

from exactkf.dynamics import decide_order_one, decide_riccati_one
from exactkf.exact import RealField, cyclotomic_real, sqrt_field
from exactkf.kernel.algebraic import AlgebraicField
from exactkf.kernel.replay import NotACertificate, Rejected, replay, seal
from exactkf.kernel.rotation import first_zero, order, sign_at, value, zero_bound
from tests.dynamics.starts import algebraic_start, before, on_hyperbola, rational_start, small

R2 = sqrt_field(2).gen()
F7, F12 = cyclotomic_real(7), cyclotomic_real(12)
#: a certificate of every kind of answer
KINDS = {
    "inside": decide_order_one("1/5", "1/2"), "outside": decide_order_one(2, "1/2"), "negative": decide_order_one(-2, "1/2"),
    "rational limit": decide_order_one("7/2", "3/2"), "boundary": decide_order_one(3, 2), "boundary far": decide_order_one("11/9", "2/9"),
    "limit of the field": decide_order_one(*on_hyperbola(R2, R2.field(fmpq(1, 3)))), "boundary inside": decide_order_one("1/2", "1/2"),
    "escape": decide_order_one(*before(fmpq(7, 2), fmpq(1), 5)), "escape on a line": decide_order_one("4/3", "1/3"), "vertex": decide_order_one(0, 1),
    "axis": decide_order_one(0, 2), "equilibrium": decide_order_one(3, 0), "origin": decide_order_one(0, 0), "period": decide_order_one("3/4", "5/4"),
    "dense": decide_order_one("1/3", "4/5"), "escape of a rotation": decide_order_one(*before(fmpq(1, 3), fmpq(1), 4)),
    "field": decide_order_one(R2 * 3, R2 / 5), "period in a field": decide_order_one(*on_hyperbola(F7.two_cos(2) / 2, F7(fmpq(1, 3)))),
    "dense in a field": decide_order_one(R2, R2 / 3), "escape in a field": decide_order_one(*before(F12.gen() / 3, F12(1), 3)),
    "limit in a field": decide_order_one(R2 / 2, fmpq(0)), "riccati": decide_riccati_one("1/2", "1/3", "9/10"),
    "riccati between": decide_riccati_one("1/2", "1/3", "1/2"), "riccati equilibrium": decide_riccati_one(2, 1, 3),
    "riccati escape": decide_riccati_one("1/2", "1/3", 1), "riccati period": decide_riccati_one("3/4", "5/4", "1/7"),
    "riccati axis": decide_riccati_one(0, 2, 3), "riccati dense": decide_riccati_one(R2, R2 / 3, "1/2"), "riccati line": decide_riccati_one(3, 2, "1/2"),
}


def resealed(certificate, change):
    """The certificate with its statement changed and a fitting digest."""
    statement = copy.deepcopy(certificate["statement"])
    change(statement)
    return seal(certificate["id"], certificate["kind"], statement, certificate["evidence"])


@pytest.mark.parametrize("name", KINDS)
def test_what_was_decided_replays(name):
    """The certificate of every kind of answer replays, and an altered one without a new digest does not."""
    certificate = KINDS[name].certificate
    assert replay(certificate) == []
    broken = copy.deepcopy(certificate)
    broken["statement"]["question"]["gamma"] = ["1/17"]
    with pytest.raises(Rejected, match="digest"):
        replay(broken)


def others(entry, value):
    """Values that an entry of an answer does not have."""
    numbers = {None, 0, 1, 2, 3, 5, 6, 12, 10**30} | ({value + 1, value - 1, 2 * value} if type(value) is int else set())
    if entry == "behaviour":
        return {"converges", "escapes", "periodic", "dense", "undecided", "not convergent, not periodic"} - {value}
    if entry == "region":
        return {"I+", "I-", "II+", "III+", "IV-", "corridor", "", "boundary of I+"} - {value}
    if entry == "never_escapes":
        return {not value, None, 1 if value else 0}
    return [x for x in numbers if x != value] + ([bool(value)] if value in (0, 1) else []) + [str(value)]


@pytest.mark.parametrize("name", KINDS)
def test_every_other_answer_is_rejected(name):
    """No entry of the answer can have another value: a multiple of the period, a shifted escape, another limit or rate."""
    certificate, tried = KINDS[name].certificate, 0
    answer = certificate["statement"]["answer"]
    for entry in answer:
        if entry in ("limit", "rate"):
            continue
        for wrong in others(entry, answer[entry]):
            with pytest.raises(Rejected):
                replay(resealed(certificate, lambda s, e=entry, w=wrong: s["answer"].__setitem__(e, w)))
            tried += 1
    for wrong in limits(answer):
        with pytest.raises(Rejected):
            replay(resealed(certificate, lambda s, w=wrong: s["answer"].update(w)))
    with pytest.raises(Rejected):
        replay(resealed(certificate, lambda s: s["answer"].pop("order")))
    with pytest.raises(Rejected):
        replay(resealed(certificate, lambda s: s["answer"].update(extra=1)))
    assert tried > 50


def limits(answer):
    """Other limits and rates."""
    root = {"minpoly": ["-2", "0", "1"], "interval": ["1", "2"]}
    yield {"rate": root}
    yield {"rate": "1/3" if answer["rate"] != "1/3" else "1/4"}
    yield {"rate": None if answer["rate"] is not None else "0"}
    if answer["limit"] is None:
        yield {"limit": {"alpha": ["0"], "gamma": "0"}}
        yield {"limit": {}}
        return
    yield {"limit": None}
    yield {"limit": {**answer["limit"], "delta": "0"}}
    for key, named in answer["limit"].items():
        for wrong in (root, "1/7", {"minpoly": ["0", "0"], "interval": ["0", "1"]}, {"minpoly": ["-1", "0", "1"], "interval": ["-3", "3"]}):
            yield {"limit": {**answer["limit"], key: [wrong] if isinstance(named, list) else wrong}}
        number = named[0] if isinstance(named, list) else named
        if isinstance(number, dict):  # the other root of the same polynomial
            far = {**number, "interval": [number["interval"][1], "1000000"]}
            yield {"limit": {**answer["limit"], key: [far] if isinstance(named, list) else far}}
            lo, hi = (Fraction(x) for x in number["interval"])
            if lo * hi > 0:  # the reciprocal, which is the other equilibrium
                inverse = {"minpoly": number["minpoly"][::-1], "interval": [str(1 / hi), str(1 / lo)]}
                yield {"limit": {**answer["limit"], key: [inverse] if isinstance(named, list) else inverse}}


def test_a_whole_other_answer_is_rejected():
    """The consistent answer to another question, put in place of the true one with the region kept, is rejected."""
    for answer in KINDS.values():
        true = answer.certificate["statement"]["answer"]
        for other in KINDS.values():
            lie = {**other.certificate["statement"]["answer"], "region": true["region"]}
            if lie != true:
                with pytest.raises(Rejected):
                    replay(resealed(answer.certificate, lambda s, lie=lie: s.update(answer=lie)))
        if true["escape"] is None:
            for t in range(6):
                lie = {**KINDS["vertex"].certificate["statement"]["answer"], "escape": t, "region": true["region"]}
                with pytest.raises(Rejected):
                    replay(resealed(answer.certificate, lambda s, lie=lie: s.update(answer=lie)))


def test_an_escape_cannot_be_hidden():
    """Escapes of rotations, periodic and not, and of hyperbolas, near and far, cannot pass for what their neighbours do."""
    hidden = 0
    for alpha in (fmpq(1, 3), fmpq(2, 3), fmpq(1), fmpq(7, 2), fmpq(2), F12.two_cos(5), R2 / 5):
        for t in range(8):
            start = before(alpha, alpha - alpha + 1, t)
            near = start and decide_order_one(start[0], start[1] + fmpq(1, 10**9))
            truth = start and decide_order_one(*start)
            if start and near.escape is None:
                lie = near.certificate["statement"]["answer"]
                with pytest.raises(Rejected):
                    replay(resealed(truth.certificate, lambda s, lie=lie: s.update(answer=lie)))
                assert replay(truth.certificate) == []
                hidden += 1
    assert hidden > 30


def asked(question):
    """The answer to the question of a certificate."""
    field = question["field"] and RealField(question["field"][0], question["field"][1:])
    numbers = [field(x) if isinstance(x, list) else x for x in (*question["alpha"], *question["gamma"], *([question["pi"]] if "pi" in question else []))]
    return (decide_riccati_one if "pi" in question else decide_order_one)(*numbers)


def test_an_answer_to_another_question_is_rejected():
    """With another number in the question the certificate replays if and only if the answer to that question is the same."""
    random, outcomes = Random(3), []
    for answer in KINDS.values():
        for _ in range(12):
            entry = random.choice([k for k in ("alpha", "gamma", "pi") if k in answer.certificate["statement"]["question"]])
            new = str(small(random))
            whole = resealed(answer.certificate, lambda s, e=entry, n=new: s["question"].__setitem__(e, n if e == "pi" else [n]))
            edited = resealed(whole, lambda s: s["answer"].pop("structure"))
            asked_for = asked(edited["statement"]["question"]).certificate["statement"]["answer"]
            if asked_for != whole["statement"]["answer"]:
                with pytest.raises(Rejected):
                    replay(whole)
            same = {k: v for k, v in asked_for.items() if k != "structure"} == edited["statement"]["answer"]
            outcomes.append(same)
            if same:
                assert replay(edited) == []
            else:
                with pytest.raises(Rejected):
                    replay(edited)
    assert 200 < outcomes.count(False) and 10 < outcomes.count(True)


def test_random_starts_replay():
    """Certificates of random rational and algebraic starts replay."""
    random = Random(5)
    for _ in range(150):
        start = rational_start(random)
        assert replay(decide_order_one(*start).certificate) == []
        assert replay(decide_riccati_one(*start, small(random)).certificate) == []
    for _ in range(25):
        assert replay(decide_order_one(*algebraic_start(random)).certificate) == []


@pytest.mark.parametrize("change", [
    lambda q: q.update(order=2), lambda q: q.update(system="other"), lambda q: q.pop("field"), lambda q: q.update(alpha=["1/0"]),
    lambda q: q.update(alpha=["x"]), lambda q: q.update(alpha=[]), lambda q: q.update(alpha=["1", "2"]), lambda q: q.update(gamma=[["0", "1"]]),
    lambda q: q.update(pi="1"), lambda q: q.update(field=[["-2", "0", "1"], "-2", "2"]), lambda q: q.update(field=[["0", "0", "1"], "-1", "1"]),
    lambda q: q.update(alpha=[0.5]), lambda q: q.update(alpha=None),
])
def test_malformed_questions(change):
    """A question that is none is rejected, without another exception."""
    with pytest.raises((Rejected, NotACertificate)):
        replay(resealed(KINDS["inside"].certificate, lambda s: change(s["question"])))


def test_a_reducible_field_polynomial_is_no_loophole():
    """theta = sqrt(2) as a root of (x^2 - 2)(x^2 - 3): zeros at other roots do not count, neither as escapes nor as periods."""
    certificate = KINDS["dense in a field"].certificate
    field = [["6", "0", "-5", "0", "1"], "7/5", "3/2"]
    assert replay(resealed(certificate, lambda s: (s["question"].update(field=field), s["answer"]["structure"].update(field=field)))) == []
    # x = theta^2 - 2 vanishes at sqrt(2), a rotation of order 4 there, of none at sqrt(3)
    k = AlgebraicField([Fraction(c) for c in field[0]], Fraction(7, 5), Fraction(3, 2))
    assert order(k.element([Fraction(-2), Fraction(0), Fraction(1)]), k) == 4
    other = AlgebraicField([Fraction(c) for c in field[0]], Fraction(17, 10), Fraction(9, 5))
    assert order(other.element([Fraction(-2), Fraction(0), Fraction(1)]), other) == 6


def test_zero_bound_is_sharp_enough_and_true():
    """y_t = 0 for a = S_{t-1}/S_{t-2}: no such t is beyond the bound, for rational and quadratic x."""
    field = AlgebraicField([Fraction(-2), Fraction(0), Fraction(1)], Fraction(1), Fraction(2))
    r = field.element([Fraction(0), Fraction(1)])
    for x, k in [(Fraction(1, 2), None), (Fraction(3, 5), None), (Fraction(5, 2), None), (Fraction(3), None), (r / 3, field), (r + 1, field), (r * 2, field)]:
        s, old = x, x - x + 1
        for t in range(3, 25):
            s, old = x * s - old, s
            a = s / old
            coefficients = [v.c if hasattr(v, "c") else [v] for v in (x, a)]
            assert t <= zero_bound(*coefficients, k.modulus if k else [Fraction(0), Fraction(1)])
            assert first_zero(x, a, t + 5, k) == t and value(x, a, t) == 0


def test_signs_far_out():
    """The sign of a late y_t by intervals is that of the exact number, and a time too late is refused."""
    x, a = Fraction(5, 2) + Fraction(1, 10**9), Fraction(2) + Fraction(1, 10**12)
    for t in (1, 2, 5, 18, 19, 20):
        assert sign_at(x, a, t, None) == (1 if value(x, a, t) > 0 else -1)
    certificate = KINDS["outside"].certificate
    with pytest.raises(Rejected, match="too late"):
        replay(resealed(certificate, lambda s: s["answer"].update(monotone_from=10**40, enters_positive_real=10**40 + 1)))


def test_the_checker_stands_alone(tmp_path):
    """The certificate replays with the standard library alone."""
    file = tmp_path / "orbit.json"
    file.write_text(json.dumps(KINDS["period in a field"].certificate))
    code = "import sys; sys.modules['flint'] = None; from exactkf.kernel.__main__ import main; sys.exit(main(sys.argv[1:]))"
    assert subprocess.run([sys.executable, "-c", code, str(file)], timeout=60).returncode == 0


def test_denominators_bound_the_zeros_in_any_field():
    """Where 2/kappa has a denominator the bound does not grow with the degree, and is true: a zero made at t is not beyond it."""
    from exactkf.kernel.rotation import _unit_denominator

    assert _unit_denominator([Fraction(0), Fraction(25, 18)], [Fraction(-2), Fraction(0), Fraction(1)]) == 9  # sqrt(2) is no unit modulo 2
    assert _unit_denominator([Fraction(1, 7), Fraction(1, 7)], [Fraction(-2), Fraction(0), Fraction(1)]) == 7  # of norm -1
    assert _unit_denominator([Fraction(3, 7), Fraction(1, 7)], [Fraction(-2), Fraction(0), Fraction(1)]) == 1  # of norm 7
    field = AlgebraicField([Fraction(str(c)) for c in F7.minpoly.coeffs()], Fraction(1), Fraction(2))
    x = field.element([Fraction(1, 6), Fraction(1, 3)])
    s, old = x, x - x + 1
    for t in range(3, 12):
        s, old = x * s - old, s
        bound = zero_bound(x.c, (s / old).c, field.modulus)
        assert t <= bound < 100 * t and first_zero(x, s / old, bound, field) == t
