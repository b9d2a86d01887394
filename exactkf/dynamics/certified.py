# SPDX-License-Identifier: MIT
r"""What certificates of answers have besides the decision, and the hints with which the checker replays it.

Main definitions
----------------
``parts``            the speed and the structure of an answer
``certify_ahead``    a certificate with the state far ahead, exactly or in digits
``with_ahead``       the same for what `exactkf.dynamics.ahead.ahead_data` found

Choice of algorithm
-------------------
A hint is found by trying: the checker's own functions are called with more bits, or another vector, until they accept.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from decimal import Decimal
from fractions import Fraction
from math import lcm
from random import Random
from typing import Any

from exactkf._errors import BadInput, Unsupported
from exactkf.dynamics.ahead import ahead_data, state_ahead
from exactkf.dynamics.answer import Answer
from exactkf.dynamics.enclosed_limit import for_checker
from exactkf.dynamics.every_order import state_of
from exactkf.dynamics.speed import norms_of, rate_ball
from exactkf.dynamics.structure import Structure, structure, structure_json
from exactkf.exact._messages import bad, check_count
from exactkf.exact.numberfield import RealNumber
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.orbit_ahead import state_within
from exactkf.kernel.orbit_answer import pair_of
from exactkf.kernel.orbit_n import is_around, reduce_pair
from exactkf.kernel.orbit_speed import check_rate
from exactkf.kernel.orbit_structure import check_cyclic
from exactkf.kernel.replay import seal

__all__ = ["certify_ahead", "parts", "structure_of", "with_ahead"]

_SMALLEST = 50  # digits after the point, besides those asked for


def parts(answer: Answer, a: Sequence[Any], g: Sequence[Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the entries of the answer that come last, and the evidence for them; those of them that cannot be found are missing."""
    said: dict[str, Any] = {"rate": None}
    evidence: dict[str, Any] = {}
    with suppress(Unsupported):
        said["structure"], evidence["structure"] = structure_of(answer, a, g), _structure_hints(_behind(answer, a, g))
    with suppress(Unsupported):
        rate = answer.rate
        if not answer.region:  # the checker decides order one by itself
            evidence.update(_speed_hints(_behind(answer, a, g), rate))
        said.update(rate=rate, slow=answer.slow)
    return said, evidence


def structure_of(answer: Answer, a: Sequence[Any], g: Sequence[Any]) -> dict[str, Any]:
    """Return the structure behind an answer as plain data."""
    return structure_json(_behind(answer, a, g))


def _behind(answer: Answer, a: Sequence[Any], g: Sequence[Any]) -> Structure:
    """The structure, kept for the certificate."""
    if "_behind" not in answer.__dict__:
        answer.__dict__["_behind"] = structure(a, g)
    return answer.__dict__["_behind"]


def _tried(hints: Iterator[Any], accepts: Callable[[Any], None], what: str) -> Any:
    """The first hint that the checker takes."""
    for hint in hints:
        try:
            accepts(hint)
        except Undefined:
            continue
        return hint
    raise Unsupported(f"no {what} was found that the checker takes")


# ---------------------------------------------------------------------- structure and speed
def _structure_hints(found: Structure) -> dict[str, Any]:
    """A cyclic vector of S, and the spectral factor."""
    if found.S is None:
        return {}
    D, *rows = for_checker([_spectrum(found), *found.S.rows])
    random = Random(len(rows))
    vectors = (([random.randint(-9, 9) for _ in rows], 128 << k // 2) for k in range(16))
    hint = _tried(vectors, lambda x: check_cyclic(D, rows, *x), "cyclic vector of S")
    return {"cyclic": hint[0], "bits": hint[1], "factor": found.evidence}


def _spectrum(found: Structure) -> list[Any]:
    """z^m D."""
    return [*found.reduced[:0:-1], *found.reduced]


def _speed_hints(found: Structure, rate: Any) -> dict[str, Any]:
    """The bits with which the rate is enclosed and, if it is a zero of a polynomial, a narrow interval and the polynomials that D divides."""
    if rate in (None, "0"):
        return {}
    D = _spectrum(found)
    (mine,) = for_checker([D])
    if isinstance(rate, dict) and "minpoly" not in rate:
        hints: Iterator[dict[str, Any]] = ({"bits": 256 << k} for k in range(8))
    else:
        norms = [[str(c) for c in p.coeffs()] for p in norms_of(D)]
        hints = ({"bits": 4 * bits, "ends": _ends(rate, bits), "norms": norms} for bits in (96 << k for k in range(7)))
    return {"speed": _tried(hints, lambda hint: check_rate(mine, rate, hint), "interval of the rate")}


def _ends(rate: Any, bits: int) -> list[str]:
    """A narrow interval around a rate between 0 and 1; at first the middle of that in which it is given."""
    if bits < 100:
        lo, hi = map(Fraction, rate["interval"]) if isinstance(rate, dict) else (Fraction(rate) - Fraction(1, 1 << 64), Fraction(rate) + Fraction(1, 1 << 64))
        return [str((3 * lo + hi) / 4), str((lo + 3 * hi) / 4)]
    middle = rate_ball(rate, [], bits // 3).mid().fmpq() * 2**bits
    near, width = int(middle.floor()), 1 << bits // 8
    return [str(Fraction(max(near - width, 0), 1 << bits)), str(Fraction(near + width, 1 << bits))]


# ---------------------------------------------------------------------- the state far ahead
def certify_ahead(answer: Answer, T: int, digits: int = 15, *, exact: bool = False) -> dict[str, Any]:
    r"""Return the certificate of an answer with the state after `T` steps in it.

    Parameters
    ----------
    answer : Answer
        About a filter, not about a Riccati equation.
    T : int
        Number of steps, nonnegative.
    digits : int
        As for `exactkf.dynamics.digits_ahead`.
    exact : bool
        The exact state of rational data, of the order of `T` digits, instead of digits.

    Raises
    ------
    BadInput
        If the answer is about a Riccati equation, or `T` or `digits` are not such numbers; for an exact state, if the data are not rational.
    Unsupported
        As `exactkf.dynamics.digits_ahead`.

    Examples
    --------
    >>> from exactkf import analyze
    >>> certify_ahead(analyze(alpha=[2], gamma=["1/2"]), 1)["statement"]["ahead"]["state"]
    {'a': ['10/3'], 'g': ['-4/3']}
    """
    if not isinstance(answer, Answer):
        raise bad("answer", "is not an Answer", answer, "pass what analyze returns")
    if type(exact) is not bool:
        raise bad("exact", "is neither True nor False", exact, "leave it out for digits")
    check_count("T", T)
    a, g = state_of(answer)
    if not exact:
        return with_ahead(answer, ahead_data(a, g, T, digits))
    if any(isinstance(x, RealNumber) for x in (*a, *g)):
        raise BadInput("exact = True: the data are not rational; leave it out for digits")
    arrival = state_ahead(a, g, T)
    if arrival.state is None:
        return with_ahead(answer, {"steps": T, "escape": arrival.escape, "never_escapes": False, "a": None, "g": None})
    d = lcm(*(int(x.q) for v in arrival.state for x in v))
    named = {name: [f"{int(x.p) * (d // int(x.q)):x}" for x in v] for name, v in zip("ag", arrival.state, strict=True)}
    return _extended(answer, {"steps": T, "escape": None, "certain": _certain(answer), "exact": {**named, "denominator": f"{d:x}"}}, {})


def with_ahead(answer: Answer, data: Mapping[str, Any]) -> dict[str, Any]:
    """Return the certificate of an answer with what `exactkf.dynamics.ahead.ahead_data` found."""
    said = {"steps": data["steps"], "escape": data["escape"], "certain": _certain(answer), "state": None}
    if data["escape"] is not None:
        return _extended(answer, said, {})
    claimed = said["state"] = {name: [_shown(x) for x in data[name]] for name in "ag"}
    numbers = [*claimed["a"], *claimed["g"]]
    Q, S = pair_of(answer.certificate["statement"]["question"])
    if any(isinstance(x, str) for x in numbers) or data["steps"] <= reduce_pair(Q, S).start:  # the checker steps
        return _extended(answer, said, {})

    def accepts(bits: int) -> None:
        if not all(is_around(x, y, bits) for x, y in zip(numbers, state_within(Q, S, data["steps"], bits), strict=True)):
            raise Undefined("more bits are needed")

    return _extended(answer, said, {"ahead": {"bits": _tried((128 << k for k in range(10)), accepts, "precision")}})


def _certain(answer: Answer) -> bool:
    """Whether it is decided what escapes there are."""
    return answer.escape is not None or answer.never_escapes


def _shown(x: Any) -> Any:
    """A number of `ahead_data` as "p/q" or in an interval; next to zero it is enclosed to so many digits after the point only."""
    if isinstance(x, str):
        return x
    middle, radius = (Decimal(x[key]) for key in ("digits", "radius"))
    least = _SMALLEST + len(x["digits"].partition("E")[0])
    if radius == 0 or radius.adjusted() < -least:
        middle, radius = Decimal(0) if middle.adjusted() < -least else middle, Decimal(f"1e-{least}")
    return {"interval": [str(Fraction(middle) - Fraction(radius)), str(Fraction(middle) + Fraction(radius))]}


def _extended(answer: Answer, said: Mapping[str, Any], evidence: Mapping[str, Any]) -> dict[str, Any]:
    whole = answer.certificate
    if whole["statement"]["question"].get("system") == "riccati":
        raise bad("answer", "is about a Riccati equation", answer.behaviour, "pass that about the filter")
    return seal(whole["id"], whole["kind"], {**whole["statement"], "ahead": said}, {**whole["evidence"], **evidence})
