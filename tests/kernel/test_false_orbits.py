# SPDX-License-Identifier: MIT
"""Certificates of orbits with one field edited, and such as ask for too much: what is accepted is true, and nothing takes long to refuse."""

from __future__ import annotations

import copy
import json
import random
import time
from fractions import Fraction

import pytest
from flint import fmpq, fmpq_poly

from exactkf.dynamics import decide_order_one, decide_riccati_one
from exactkf.dynamics.certified import certify_ahead
from exactkf.dynamics.every_order import decide
from exactkf.exact import sqrt_field
from exactkf.exact.balls import precision
from exactkf.kernel.intervals import around
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.orbit_ahead import check_ahead, state_within
from exactkf.kernel.orbit_n import reduce_pair, start_pair, state_at
from exactkf.kernel.orbit_sieve import intersected
from exactkf.kernel.replay import Rejected, digest, replay, seal
from exactkf.kernel.rotation import _Residues
from tests.dynamics.starts import algebraic_start, before, on_hyperbola, rational_start
from tests.dynamics.test_every_order import self_product, start, times, with_spectrum
from tests.kernel.acceptance import is_accepted

BEHAVIOURS = ("converges", "escapes", "periodic", "eventually periodic", "dense", "undecided", "not convergent, not periodic")
WANDERS = "not convergent, not periodic"


def accepted(certificate):
    return is_accepted({**certificate, "digest": digest(certificate)})


# ---------------------------------------------------------------------- one field edited
def leaves(x, path=()):
    """Places of a certificate with what stands there."""
    if isinstance(x, (dict, list)):
        for key, value in x.items() if isinstance(x, dict) else enumerate(x):
            yield from leaves(value, (*path, key))
    if not isinstance(x, dict) and path:
        yield path, x


def others(key, value):
    """What could stand in its place."""
    if key == "behaviour":
        return [b for b in BEHAVIOURS if b != value]
    if key == "region":
        return ["I+", "", "corridor"]
    if key == "sign":
        return [x for x in ("positive", "nonnegative", "zero", "nonpositive", "negative", "indefinite", "") if x != value]
    if key == "system":
        return ["filter", "riccati", ""]
    if value is None or isinstance(value, bool):
        return [not value, 0, 1, 2, 4, "0", {}, None]
    if isinstance(value, int):
        return [value + 1, value - 1, value + 2, 2 * value, 3 * value, 0, 1, -1, -value, None, str(value)]
    if isinstance(value, list):
        return [[], value[:-1], value[1:], [*value, *value[-1:]], value[::-1]]
    x = Fraction(value)
    return [str(y) for y in (x + 1, -x, 2 * x, x / 2, x + Fraction(1, 10**9), x - Fraction(1, 10**20), 0, 1, -1)] + ["1/0", None]


def changed(certificate, path, value):
    made = copy.deepcopy(certificate)
    at = made
    for key in path[:-1]:
        at = at[key]
    at[path[-1]] = value
    return made


def same_number(old, new):
    """An interval that was changed still holds the same zero, and no other; where no polynomial is given it is wider."""
    (a, b), (c, d) = ([fmpq(*map(int, x.split("/"))) for x in named["interval"]] for named in (old, new))
    if "minpoly" not in old:
        return c <= a and b <= d
    with precision(256):
        zeros = [z.real.mid().fmpq() for z, _ in fmpq_poly([fmpq(c) if "/" not in c else fmpq(*map(int, c.split("/"))) for c in old["minpoly"]]).numer()
                 .complex_roots() if z.imag.contains(0)]
    return [x for x in zeros if a < x < b] == [x for x in zeros if c < x < d] and sum(a < x < b for x in zeros) == 1


def is_true(made, original, path, old):
    """What an edited certificate says is known to be true."""
    if path[0] == "evidence":
        return True
    question, answer = made["statement"]["question"], made["statement"]["answer"]
    if path[1] == "answer":
        if path[2] == "torus_dimension":
            return answer["torus_dimension"] is None
        if path[2:] == ("structure", "jordan") and answer["structure"]["jordan"] == old[::-1]:  # the same blocks
            return True
        if path[2:] == ("structure", "field"):  # numbers without the generator need no field
            return answer["structure"]["field"] is None
        if path[2] not in ("limit", "rate", "structure"):
            return False
        if answer["limit"] is None and "a" in question:  # less is said
            return True
        before_, after = original["statement"]["answer"], answer
        for key in path[2:-2]:
            before_, after = before_[key], after[key]
        return path[-2] == "interval" and same_number(before_, after)
    if question.get("field") is not None or answer["behaviour"] == "undecided":
        return True  # looked at elsewhere
    read = [[fmpq(*map(int, x.split("/"))) for x in question[key]] for key in (("a", "g") if "a" in question else ("alpha", "gamma"))]
    if "a" in question:
        found = decide(*read, max_steps=60)
    elif "pi" in question:
        found = decide_riccati_one(*(x for (x,) in read), fmpq(*map(int, question["pi"].split("/"))))
    else:
        found = decide_order_one(*(x for (x,) in read))
    said = json.loads(json.dumps(found.certificate["statement"]["answer"]))
    return {k: v for k, v in said.items() if k not in ("limit", "rate")} == {k: v for k, v in answer.items() if k not in ("limit", "rate")}


def answers(rng, count):
    """Decisions about starts of every kind, of orders one to three, rational and not."""
    field = sqrt_field(3)
    for k in range(count):
        if k % 4 == 0:
            yield decide_order_one(*(rational_start(rng) if rng.random() < 0.6 else algebraic_start(rng)))
        elif k % 4 == 1:
            yield decide_riccati_one(*rational_start(rng), fmpq(rng.randint(-9, 9), rng.randint(1, 5)))
        else:
            a, g = start(rng, rng.choice((1, 2, 2, 3)))
            if k % 8 == 7:
                a = [field(x) + field.gen() * rng.choice((0, 1)) for x in a]
                g = [field(x) for x in g]
            yield decide(a, g, max_steps=40)


@pytest.mark.parametrize("seed", range(3))
def test_one_field_edited(seed):
    """Every number, sign and label of a decision at random: with another in its place the certificate is refused, or says something true all the same."""
    rng, tried, kinds = random.Random(seed), 0, set()
    for answer in answers(rng, 24):
        certificate = json.loads(json.dumps(answer.certificate))
        assert accepted(certificate)
        kinds.add(answer.behaviour)
        edits = [(path, old, new) for path, old in leaves({key: certificate[key] for key in ("statement", "evidence")}) for new in others(path[-1], old)
                 if new != old or type(new) is not type(old)]
        for path, old, new in rng.sample(edits, min(25, len(edits))):
            made, tried = changed(certificate, path, new), tried + 1
            assert not accepted(made) or is_true(made, certificate, path, old), (path, old, new, certificate)
    assert tried > 300 and {"converges", "escapes"} < kinds


# ---------------------------------------------------------------------- nasty starts
def test_a_late_escape_is_not_hidden():
    """An orbit that escapes at step 60 never passes for one that does not, nor for one that escapes a step earlier or later."""
    for alpha in (fmpq(1, 3), fmpq(7, 2), fmpq(-2, 5)):
        answer = decide_order_one(*before(alpha, fmpq(1), 60))
        assert answer.escape == 60
        certificate = json.loads(json.dumps(answer.certificate))
        for new in (59, 61, 62, 120, None):
            assert not accepted(changed(certificate, ("statement", "answer", "escape"), new))
        near = decide_order_one(*(x + fmpq(1, 10**200) for x in before(alpha, fmpq(1), 60)))
        assert near.escape is None
        assert not accepted({**certificate, "statement": {**certificate["statement"], "answer": near.certificate["statement"]["answer"]}})


def test_roots_of_unity_and_their_neighbours():
    """Rotations by 2 pi / n and by angles close to it: one has the period n, the other none, and neither passes for the other."""
    from exactkf.exact import cyclotomic_real

    for n in (11, 30):
        field = cyclotomic_real(n)
        c = field.two_cos(1) / 2
        one, near = (decide_order_one(*on_hyperbola(x, field(fmpq(1, 3)))) for x in (c, c + fmpq(1, 10**30)))
        assert one.period in (n, 2 * n, n // 2) and near.behaviour == "dense"
        certificates = [json.loads(json.dumps(x.certificate)) for x in (one, near)]
        for mine, other in (certificates, certificates[::-1]):
            assert accepted(mine)
            assert not accepted({**mine, "statement": {**mine["statement"], "answer": other["statement"]["answer"]}})


@pytest.mark.parametrize("seed", range(4))
def test_an_orbit_that_escapes_has_no_other_evidence(seed):
    """Convergence, a period and wandering are refused for orbits of order two that escape, whatever evidence of others stands with it."""
    rng = random.Random(seed)
    pool = [decide(*start(rng, 2), max_steps=40) for _ in range(30)]
    lies = [json.loads(json.dumps(x.certificate)) for x in pool if x.behaviour in ("converges", "periodic", WANDERS)]
    tried = 0
    for answer in pool:
        if answer.behaviour == "escapes":
            question = json.loads(json.dumps(answer.certificate))["statement"]["question"]
            for lie in lies:
                tried += 1
                assert not accepted({**lie, "statement": {"question": question, "answer": lie["statement"]["answer"]}})
    assert tried > 20


def test_an_equilibrium_over_a_field_replays():
    """Its factor is a number of the field of the question."""
    r = sqrt_field(5).gen()
    assert accepted(decide([1 - 2 * r], [r.field(0)]).certificate)
    assert accepted(decide([r, r + 1], [r.field(0), r.field(0)]).certificate)


def test_a_quotient_with_a_zero_is_over_the_field():
    """A pair over a field whose common factor leaves a coefficient zero is decided."""
    r = sqrt_field(5).gen()
    a, g = [r.field(fmpq(67, 4)), 2 * r + fmpq(91, 4), r.field(fmpq(-1, 2))], [r.field(-4), r / 2 - 21, r.field(fmpq(1, 2))]
    answer = decide(a, g)
    replay(answer.certificate)
    assert answer.escape == stepped_over(a, g, 40)


def stepped_over(a, g, steps):
    """The escape of an orbit over a field, by stepping."""
    from exactkf.theory.fast_filter import step_ag

    a, g = tuple(a), tuple(g)
    for t in range(steps):
        if g[0] * g[0] == 1:
            return t
        a, g = step_ag(a, g)
    return None


# ---------------------------------------------------------------------- too much
def asked(question, evidence=None, **answer):
    order = len(question.get("a", question.get("alpha")))
    blank = dict.fromkeys(("escape", "limit", "rate", "monotone_from", "period", "preperiod", "torus_dimension", "enters_positive_real"))
    return seal("X", "orbit", {"question": question, "answer": {"order": order, "behaviour": "", "never_escapes": True, "region": "", **blank, **answer}},
                evidence or {})


TWO = {"a": ["-1/2", "1"], "g": ["3", "1/3"]}
TWELVE = {"a": ["1", "1/3"] * 6, "g": ["2", "5"] * 6}
FAR = [["-2", *["0"] * 298, "1"], "1", "2"]
TOO_MUCH = {
    "escape": asked(TWO, behaviour="escapes", never_escapes=False, escape=10**6),
    "escape too far": asked(TWO, behaviour="escapes", never_escapes=False, escape=10**9),
    "steps": asked(TWO, {"searched": 10**9}, behaviour="undecided", never_escapes=False),
    "steps modulo": asked(TWO, {"searched": 10**1000, "modulus": 2**61 - 1}, behaviour="undecided", never_escapes=False),
    "period": asked(TWO, behaviour="periodic", period=10**30), "power": asked(TWO, behaviour="periodic", period=10**6),
    "minors": asked(TWELVE, {"aperiodic": [10**9 + 7], "places": [[101, 1000]], "before": []}, behaviour=WANDERS),
    "powers": asked(TWELVE, {"aperiodic": [10**9 + 7], "dominated": {"prime": 2, "modulus": 3, "classes": [[[["2", "1"], [["1"]]]]]}}, behaviour=WANDERS),
    "many powers": asked(TWO, {"aperiodic": [10**9 + 7],
                               "dominated": {"prime": 2, "modulus": 3, "classes": [[[["2", "1"], [["1"]] * 10**5]]]}}, behaviour=WANDERS),
    "states": asked(TWELVE, {"aperiodic": [10**9 + 7], "modulus": 2**89 - 1}, behaviour=WANDERS),
    "order": asked({"a": ["1"] * 300, "g": ["2"] * 300}, behaviour="converges", enters_positive_real=0),
    "degree": asked({"a": [["0", "1"]], "g": [["0", "3"]], "field": FAR}, behaviour="converges", enters_positive_real=0),
    "degree one": asked({"order": 1, "system": "filter", "field": FAR, "alpha": [["0", "1/3"]], "gamma": [["0", "1"]]}, behaviour="dense", torus_dimension=1),
    "jump": asked({"order": 1, "system": "filter", "field": None, "alpha": ["2"], "gamma": ["1/7"]}, behaviour="converges", monotone_from=10**4000),
    "primality": asked({"a": [["0", "1"]], "g": [["0", "3"]], "field": [["-2", "0", "1"], "1", "2"]}, {"irreducible": 10**4000}, behaviour=WANDERS),
}


@pytest.mark.parametrize("name", TOO_MUCH)
def test_too_much_is_refused_at_once(name):
    """A few hundred bytes do not keep the checker busy, nor fill the memory: one line says why not."""
    from exactkf.kernel.limits import patiently

    if name == "escape":  # the states get longer until they are too long: minutes, if nobody looked
        with pytest.raises(Rejected, match="given up after"), patiently(1):
            replay(TOO_MUCH[name])
        return
    began = time.process_time()
    with pytest.raises(Rejected) as error:
        replay(TOO_MUCH[name])
    assert time.process_time() - began < 20 and "\n" not in str(error.value)


def test_times_left_by_two_primes_are_not_all_listed():
    """Two sets of a hundred thousand residues have ten thousand million in common; so many are not made."""
    period, left = intersected(10**6 + 1, range(10**5), 10**6, range(10**5), 1000)
    assert period == 10**6 * (10**6 + 1) and len(left) == 1000


def test_products_of_residues():
    """Packed as integers they are what they are term by term, also for the largest residues."""
    rng = random.Random(1)
    for _ in range(400):
        d, q = rng.randint(1, 8), rng.choice([2, 3, 997, 2**61 - 1, 2**127 - 1])
        modulus = [rng.choice([0, q - 1, rng.randrange(q)]) for _ in range(d)]
        u, v = ([rng.choice([0, q - 1, rng.randrange(q)]) for _ in range(d)] for _ in range(2))
        out = [sum(u[i] * v[k - i] for i in range(d) if 0 <= k - i < d) for k in range(2 * d - 1)]
        while len(out) > d:
            top = out.pop()
            for j, c in enumerate(modulus):
                out[len(out) - d + j] -= top * c
        assert _Residues([Fraction(c) for c in [*modulus, 1]], q).multiply(u, v) == [c % q for c in out]


# ---------------------------------------------------------------------- structure, speed and the state far ahead
def slowly():
    """An orbit whose D has double zeros on the circle, at -1 and at the sixth roots of unity, and another pair."""
    rng, w = random.Random(5), times(times([fmpq(1), fmpq(1)], [fmpq(1), fmpq(-1), fmpq(1)]), [fmpq(1), fmpq(1, 2)])
    starts = (with_spectrum(rng, self_product(w)) for _ in range(100))
    return next(x for x in (decide(*found) for found in starts if found) if x.behaviour == "converges")


R3 = sqrt_field(3).gen()
#: answers of every kind that have parts to be edited, and the steps after which the state is said
PARTS = {
    "converges": (decide([fmpq(1), fmpq(-1)], [fmpq(2), fmpq(0)]), 1000), "slow": (decide_order_one("5/2", "3/2"), 10**6),
    "double zeros on the circle": (slowly(), 60), "rests": (decide([fmpq(0), fmpq(-1, 2)], [fmpq(0), fmpq(1, 2)]), 77),
    "wanders": (decide([fmpq(1, 2), fmpq(1, 3), fmpq(1, 4)], [fmpq(1, 3), fmpq(-1, 2), fmpq(1, 4)]), 10**12),
    "over a field": (decide([R3 / 4, R3 / 8], [R3 / 16, R3 - R3]), 100), "period over a field": (decide_order_one(-2 + 0 * R3, R3), 10**9 + 1),
    "order one": (decide_order_one(3, "1/2"), 12), "common factor": (decide([fmpq(1, 2), fmpq(-1)], [fmpq(1, 3), fmpq(2, 3)]), 99),
}


def altered(certificate, most):
    """So many edits of the parts of the statement of a certificate, and whether they are accepted."""
    edits = []
    for path, old in leaves(certificate["statement"]):
        if path[0] == "ahead" or path[:2] in (("answer", "structure"), ("answer", "rate"), ("answer", "slow")):
            hexadecimal = path[:2] == ("ahead", "exact") and isinstance(old, str)
            choices = [f"{x:x}" for x in (int(old, 16) + 1, int(old, 16) - 1, -int(old, 16), 2 * int(old, 16), 0)] + ["x", ""] if hexadecimal else \
                others(path[-1], old)
            edits += [(path, old, new) for new in choices if new != old or type(new) is not type(old)]
    for path, old, new in random.Random(most).sample(edits, min(most, len(edits))):
        made = changed(certificate, ("statement", *path), new)
        yield path, old, new, made, accepted(made)


@pytest.mark.parametrize("name", PARTS)
def test_no_entry_of_a_part_can_be_another(name):
    """Each coefficient, multiplicity, size, sign, end of an interval and digit of the structure, the rate and the state far ahead."""
    answer, T = PARTS[name]
    tried = 0
    for exact in (False, True) if name not in ("over a field", "period over a field", "wanders", "slow") else (False,):
        certificate = json.loads(json.dumps(certify_ahead(answer, T, 20, exact=exact)))
        assert accepted(certificate)
        for path, old, new, made, taken in altered(certificate, 120):
            tried += 1
            if taken and name == "rests" and path == ("ahead", "steps"):
                assert new >= 2  # where it comes to rest, at (0, 0)
            elif taken and name == "rests" and path[:2] == ("ahead", "exact"):
                assert path[2] == "denominator" and int(new, 16) != 0
            elif taken and path[0] == "ahead":  # an interval that is wider
                assert path[-2] == "interval", (path, old, new)
                mine, wider = (at(c, path[:-2]) for c in (certificate["statement"], made["statement"]))
                lo, hi = map(Fraction, wider["interval"])
                assert same_number(mine, wider) or name == "rests" and lo <= 0 <= hi, (path, old, new)
            elif taken:
                assert is_true(made, certificate, ("statement", *path), old), (path, old, new)
    assert tried > 100


def at(found, path):
    """What stands at a place."""
    for key in path:
        found = found[key]
    return found


def test_parts_of_other_answers_are_refused():
    """Structure, speed and state of one answer in another; what is left out is not said, and the rest holds."""
    whole = {name: json.loads(json.dumps(certify_ahead(*pair, 20))) for name, pair in PARTS.items()}
    tried = 0
    for mine in whole.values():
        for other in whole.values():
            if mine is other:
                continue
            for part in ("structure", "slow", "rate"):
                if mine["statement"]["answer"][part] != other["statement"]["answer"][part]:
                    tried += 1
                    assert not accepted(changed(mine, ("statement", "answer", part), other["statement"]["answer"][part]))
            foreign = changed(mine, ("statement", "ahead"), other["statement"]["ahead"])
            assert not accepted(foreign)
            assert not accepted({**foreign, "evidence": {**foreign["evidence"], **{k: v for k, v in other["evidence"].items() if k == "ahead"}}})
        for parts in ((("ahead",),), (("answer", "structure"),)):
            less = copy.deepcopy(mine)
            for path in parts:
                del at(less["statement"], path[:-1])[path[-1]]
            assert accepted(less)
        for path, key in ((("answer", "structure"), "jordan"), (("answer", "structure"), "kappa"), (("ahead",), "certain"), (("ahead",), "state")):
            less = copy.deepcopy(mine)
            del at(less["statement"], path)[key]
            assert not accepted(less)
    assert tried > 120


def test_a_rate_is_not_another_zero():
    """Of D with zeros of moduli 1/3, 1/2 and 9/10 the rate is 81/100: neither a rate of another zero nor a product of two moduli passes, whatever the ends."""
    w = times(times([fmpq(1), fmpq(-1, 3)], [fmpq(1), fmpq(1, 2)]), [fmpq(1), fmpq(9, 10)])
    rng = random.Random(3)
    answer = next(x for x in (decide(*found) for found in (with_spectrum(rng, self_product(w)) for _ in range(50)) if found) if x.behaviour == "converges")
    assert answer.rate == "81/100"
    certificate = json.loads(json.dumps(answer.certificate))
    assert accepted(certificate)
    for rate in ("1/9", "1/4", "9/20", "3/10", "9/10", "100/81", "81/1000", "8100001/10000000"):
        lie = changed(certificate, ("statement", "answer", "rate"), rate)
        for width in (Fraction(1, 10**9), Fraction(1, 10)):
            ends = [str(max(Fraction(rate) - width, Fraction(0))), str(Fraction(rate) + width)]
            assert not accepted(lie) and not accepted(changed(lie, ("evidence", "speed", "ends"), ends))
    assert not accepted(changed(certificate, ("evidence", "speed", "norms"), [["-1", "3"]]))
    enclosed = changed(certificate, ("statement", "answer", "rate"), {"interval": ["809/1000", "811/1000"]})
    del enclosed["evidence"]["speed"]["ends"]
    assert accepted(enclosed)
    for lo, hi in (("82/100", "83/100"), ("1/2", "8/10"), ("0", "1/2"), ("81/100", "82/100"), ("-1", "1"), ("0", "2")):
        assert not accepted(changed(enclosed, ("statement", "answer", "rate"), {"interval": [lo, hi]})) or lo == "81/100"


def test_a_state_after_an_escape_is_refused():
    """Behind an escape there is no state, whatever is named; before it there is one."""
    answer = decide_order_one(*before(fmpq(7, 2), fmpq(1), 30))
    for T in (29, 30, 31, 40):
        certificate = json.loads(json.dumps(certify_ahead(answer, T)))
        assert accepted(certificate) and (certificate["statement"]["ahead"]["escape"] is None) == (T <= 30)
        for steps in (0, 29, 30, 31, 32, 40):
            if steps != T:
                taken = accepted(changed(certificate, ("statement", "ahead", "steps"), steps))
                assert not taken or min(T, steps) > 30  # no state in either case
        assert not accepted(changed(certificate, ("statement", "ahead", "state"), {"a": ["1"], "g": ["1/2"]}))


@pytest.mark.parametrize("n", [1, 2, 3])
def test_exact_states_far_ahead(n):
    """The state is accepted after T steps, not after T - 1, nor with a numerator that differs by one, nor with a multiple of one of its rows."""
    rng, tried = random.Random(n), 0
    while tried < 4:
        pair = start(rng, n)
        answer = pair and decide(*pair, max_steps=40)
        if not answer or answer.escape is not None:
            continue
        T = rng.choice((7, 64, 333))
        certificate = json.loads(json.dumps(certify_ahead(answer, T, exact=True)))
        assert accepted(certificate)
        said = certificate["statement"]["ahead"]["exact"]
        moving = answer.period is None or T % answer.period
        for shifted in (T - 1, T + 1):
            later = certify_ahead(answer, shifted, exact=True)["statement"]["ahead"]["exact"]
            if later != said:
                assert not accepted(changed(certificate, ("statement", "ahead", "steps"), shifted)), (pair, T)
        for key in "ag":
            for k in range(n):
                made = changed(certificate, ("statement", "ahead", "exact", key, k), f"{int(said[key][k], 16) + 1:x}")
                assert not accepted(made)
        assert not accepted(changed(certificate, ("statement", "ahead", "exact", "g"), [f"{2 * int(x, 16):x}" for x in said["g"]])) or answer.period == 1 \
            or not any(int(x, 16) for x in said["g"])
        doubled = {"denominator": f"{2 * int(said['denominator'], 16):x}", **{k: [f"{2 * int(x, 16):x}" for x in said[k]] for k in "ag"}}
        assert accepted(changed(certificate, ("statement", "ahead", "exact"), doubled))  # the same numbers
        tried += bool(moving)


def test_a_block_has_a_polynomial_and_a_size_only():
    """Nothing is looked at of a block but these; what else would be said of it would stand there unchecked."""
    certificate = json.loads(json.dumps(PARTS["converges"][0].certificate))
    assert accepted(certificate)
    place = ("statement", "answer", "structure", "jordan", 0)
    assert not accepted(changed(certificate, place, {**at(certificate, place), "geometric": 2}))


@pytest.mark.parametrize("a, g", [(("-1", "0"), ("1", "0")), (("0", "-1"), ("0", "1")), (("1/2", "-1"), ("1", "1")), (("3", "2", "1"), ("-1", "5", "-1"))])
def test_no_state_behind_an_escape_that_was_not_looked_for(a, g):
    """Of orbits that escape before their reduction ends an answer may leave all open; a state later on is not shown for that, in whatever form."""
    n, answer = len(a), json.loads(json.dumps(PARTS["converges"][0].certificate))["statement"]["answer"]
    answer = {**dict.fromkeys(answer), "order": n, "behaviour": "undecided", "never_escapes": False, "region": ""}
    answer.pop("structure")
    question = {"a": list(a), "g": list(g)}
    escape = reduce_pair(*start_pair(question)).escape
    made = {"format": "exactkf-certificate", "version": 1, "id": "orbit", "kind": "orbit", "statement": {"question": question, "answer": answer},
            "evidence": {"searched": 0, "ahead": {"bits": 200}}}
    assert escape is not None and accepted(made)
    wide = [{"interval": ["-1000000", "1000000"]}] * n
    for T in (1, 2, 3, 10, 1000):
        said = {"steps": escape + T, "escape": None, "certain": False}
        for x, y, denominator in ((0, 0, 1), (1, 0, 1), (1, 1, 2)):
            exact = {"a": [f"{x:x}"] * n, "g": [f"{y:x}"] * n, "denominator": str(denominator)}
            assert not accepted(changed(made, ("statement", "ahead"), {**said, "exact": exact}))
        assert not accepted(changed(made, ("statement", "ahead"), {**said, "state": {"a": wide, "g": wide}}))


def test_intervals_of_states_of_all_starts():
    """Starts with Q(0) = 0 once or twice, rational and over a field: intervals hold the state that steps lead to, and one unit less is refused."""
    rng, tried, starts = random.Random(7), 0, set()
    while tried < 40:
        n, over = rng.choice((1, 2, 2, 3)), rng.random() < 0.4
        a, g = ([[str(Fraction(rng.randint(-3, 3), rng.choice((1, 2, 3)))), *(["1/2"] if over and rng.random() < 0.5 else [])] for _ in range(n)] for _ in "ag")
        for k in range(rng.randint(0, min(2, n))):  # q_{n-k} = 0
            a[-1 - k] = [str(-Fraction(x)) for x in g[-1 - k]]
        Q, S = start_pair({"a": a, "g": g, "field": [["-2", "0", "1"], "1", "2"]}) if over else start_pair({"a": [x for x, in a], "g": [x for x, in g]})
        reduced = reduce_pair(Q, S)
        T, bits = reduced.start + rng.randint(1, 9), 300
        try:
            q, s = state_at(Q, S, T)
        except Undefined:  # there is none
            continue
        found = state_within(Q, S, T, bits)
        for k, (lo, hi) in enumerate(found):
            p, r = (q, s) if k < n else (s, [0] * len(s))
            i = n - 1 - k % n
            low, high = around((Fraction(1) * p[i] - r[i]) / q[-1], bits)
            assert lo <= high and low <= hi and hi - lo < 1 << 150
        said = [{"interval": [f"{x}/{1 << bits}" for x in ends]} for ends in found]
        for k in (None, *range(2 * n)):
            mine = [*said]
            if k is not None:
                lo, hi = found[k]
                mine[k] = {"interval": [f"{lo + 1}/{1 << bits}", f"{hi}/{1 << bits}"]}
            ahead = {"steps": T, "escape": None, "certain": True, "state": {"a": mine[:n], "g": mine[n:]}}
            try:
                check_ahead(Q, S, {"escape": None, "never_escapes": True}, ahead, {"ahead": {"bits": bits}})
                assert k is None
            except Undefined:
                assert k is not None
        tried += 1
        starts.add((reduced.start, over))
    assert starts >= {(0, False), (0, True), (1, False), (1, True)}


# ---------------------------------------------------------------------- what is written as another thing
@pytest.mark.parametrize("path, text", [(("question", "a"), "01"), (("question", "g"), "00"), (("answer", "structure", "d"), "401"),
                                        (("answer", "structure", "gcd"), "1"), (("answer", "limit", "alpha"), "00"), (("ahead", "state", "g"), "00")])
def test_digits_are_no_list(path, text):
    """A string is not read as the list of its characters."""
    made = changed(certify_ahead(decide([fmpq(0), fmpq(1)], [fmpq(0), fmpq(0)]), 3, 20), ("statement", *path), text)
    with pytest.raises(Rejected, match="a list is written as a number"):
        replay({**made, "digest": digest(made)})
