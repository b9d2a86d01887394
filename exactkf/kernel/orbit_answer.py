# SPDX-License-Identifier: MIT
"""Every part of an answer about an orbit, checked.

The statement of a certificate of kind ``orbit`` is a question and its answer, and it may have the state far ahead.  An answer may do without the
structure, and for orders above one without the speed, which is then not said: with `slow` it is said, with no rate too.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from exactkf.kernel.algebraic import Algebraic, AlgebraicField
from exactkf.kernel.numbers import need
from exactkf.kernel.orbit import check_order_one
from exactkf.kernel.orbit_ahead import check_ahead
from exactkf.kernel.orbit_n import check_orbit, number, spectral_polynomial, start_pair
from exactkf.kernel.orbit_speed import check_speed, slowness
from exactkf.kernel.orbit_structure import check_structure

__all__ = ["check_answer", "pair_of"]

#: what is written as a list, where it is not null; the digits of a number would be taken for a list of numbers
_LISTS = {"a", "g", "gcd", "factor", "d", "kappa", "circle_zeros", "S", "jordan", "polynomial", "dominant", "codominant", "minpoly", "interval", "alpha"}


def check_answer(statement: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
    """Accept the statement if all of it is right.

    Raises
    ------
    Undefined
        With the step that does not follow.
    """
    need({"question", "answer"} <= set(statement) <= {"question", "answer", "ahead"}, "the statement is not a question with an answer")
    need(_has_lists(statement), "a list is written as a number")
    question, answer = statement["question"], statement["answer"]
    core = {k: v for k, v in answer.items() if k not in ("slow", "structure")}
    several, told = "a" in question, "slow" in answer
    if several:
        check_orbit(question, {**core, "rate": None} if told else core, evidence)
    else:
        fault = check_order_one(question, core)
        need(not fault, fault)
    Q, S = pair_of(question)
    if several and told:
        check_speed(Q, S, answer, evidence)
    elif told:
        moves = answer["behaviour"] == "converges" and answer["period"] is None and Q[0] != 0
        K = slowness(spectral_polynomial(Q, S)) if moves else None  # a double zero on the circle: |c| = 1 in `exactkf.kernel.orbit`
        need(answer["slow"] is None if K is None else type(answer["slow"]) is int and answer["slow"] == K, f"the slowness is {K}")
    if "structure" in answer:
        said = answer["structure"]["field"]
        need(said is None or said == question["field"], "the field of the structure is not that of the question")
        own = Q[-1].field if isinstance(Q[-1], Algebraic) else None
        check_structure(Q, S, None if said is None else own, answer["structure"], evidence["structure"])
    if "ahead" in statement:
        need(question.get("system") != "riccati", "the state ahead is one of the filter")
        check_ahead(Q, S, answer, statement["ahead"], evidence)


def _has_lists(data: Any, name: str = "") -> bool:
    """Every list of the statement is one, and so are the rows of S and the modulus of a field."""
    if isinstance(data, Mapping):
        return all(_has_lists(x, key) for key, x in data.items())
    if isinstance(data, list):
        return all(_has_lists(x, "a" if name == "S" or name == "field" and not k else "") for k, x in enumerate(data))
    return data is None or name not in _LISTS


def pair_of(question: Mapping[str, Any]) -> tuple[list, list]:
    """The two polynomials of the filter that a question of any order is about."""
    if "a" in question:
        return start_pair(question)
    field = None if question["field"] is None else AlgebraicField.of(question["field"])
    (alpha,), (gamma,) = ([number(x, field) for x in question[name]] for name in ("alpha", "gamma"))
    return [alpha, 0 * alpha + 1], [gamma, 0 * gamma]
