# SPDX-License-Identifier: MIT
r"""From a user's data to the decision about the orbit.

Main definitions
----------------
``analyze``       the decision about the filter in a mapping, a file or keyword arguments
``filter_from``   the filter that a mapping describes
``read_data``     a file with one filter as such a mapping

Notation
--------
A mapping describes a filter by one of these sets of keys:

==================  ============================================================
keys                meaning
==================  ============================================================
``alpha, gamma``    Kimura-Georgiou coordinates
``a, g``            lower coefficients of a(z), and the vector g
``b, a``            coefficients of b(z) and a(z), leading one first, v = b/(2a)
``covariances``     1, c_1, c_2, ...; ``order`` may be given
``F, g, h``         a realization c_k = h'F^{k-1}g in any basis
``system``          an object with matrices A, B, C, D (from Python only; `analyze` takes it alone too)
==================  ============================================================

``floats`` says what floats mean ("exact", "decimal" or a largest denominator), and ``pi0``, in order
one, asks about the Riccati equation started there.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import NoneType
from typing import Any

from exactkf._errors import BadInput
from exactkf.dynamics.answer import Answer
from exactkf.dynamics.files import FORMS, OPTIONS, meant, read_filters
from exactkf.dynamics.filter import Filter
from exactkf.dynamics.numbers import number
from exactkf.exact._messages import bad
from exactkf.exact.compositum import together

__all__ = ["analyze", "filter_from", "read_data"]

def filter_from(data: Mapping[str, Any]) -> Filter:
    """Return the filter that the keys of a mapping describe.

    Raises
    ------
    BadInput
        If the keys are none of `FORMS`, or the values are refused by `Filter`.

    Examples
    --------
    >>> filter_from({"alpha": ["1/2"], "gamma": ["1/3"]}).a
    (1/6,)
    """
    keys = set(data) - set(OPTIONS)
    if keys not in map(set, FORMS):
        raise _incomplete(keys)
    if "order" in data and "covariances" not in data:
        raise bad("order", "goes with covariances only", data["order"], "leave it out")
    floats = data.get("floats")
    if floats not in (None, "exact", "decimal") and (isinstance(floats, bool) or not isinstance(floats, int) or floats < 1):
        raise bad("floats", "is no meaning of floats", floats, 'pass "exact", "decimal" or a largest denominator')
    if "alpha" in keys:
        return Filter.from_parameters(data["alpha"], data["gamma"], floats=floats)
    if "covariances" in keys:
        return Filter.from_covariances(data["covariances"], order=data.get("order"), floats=floats)
    if "F" in keys:
        return Filter.from_realization(data["F"], data["g"], data["h"], floats=floats)
    if "system" in keys:
        return Filter.from_state_space(data["system"], floats=floats)
    if "b" in keys:
        return Filter.from_polynomials(data["b"], data["a"], floats=floats)
    return Filter.from_ag(data["a"], data["g"], floats=floats)


def _incomplete(keys: set[str]) -> BadInput:
    """What is wrong with keys that describe no filter: an unknown one, or one that is missing."""
    for key in sorted(keys - {key for form in FORMS for key in form}):
        if near := meant(key):
            return BadInput(f"argument {key!r} is unknown; {near}")
    missing = [" and ".join(repr(k) for k in form if k not in keys) for form in FORMS if keys < set(form)] if keys else []
    given = " and ".join(map(repr, sorted(keys)))
    if missing:
        return BadInput(f"argument {', or '.join(missing)} is missing: {given} alone is no filter; give it besides")
    return BadInput(f"no filter is {f'described by {given}' if keys else 'given'}; give one of: {'; '.join(', '.join(form) for form in FORMS)}")


def read_data(path: str | Path) -> dict[str, Any]:
    """Return the mapping in a file with one filter; see `exactkf.dynamics.files`.

    Floats in the file are kept as the decimals that are written there.

    Raises
    ------
    BadInput
        If the file cannot be read, is not of its kind, or holds no filter or several.
    """
    filters = read_filters(path)
    if len(filters) > 1:
        raise bad("FILE", f"holds {len(filters)} filters", str(path), "pass it to decide_many, or to the command exactkf analyze")
    return filters[0][1]


def analyze(data: Any = None, /, **given: Any) -> Answer:
    """Decide what the gain of a filter does.

    Parameters
    ----------
    data : mapping, Filter, file name, or object with matrices A, B, C, D such as `control.StateSpace`, optional
        The filter; keyword arguments of the same names do as well. Where the matrices are of floats, pass ``floats`` besides.
    **given
        The filter, by ``alpha, gamma``, by ``a, g``, by ``b, a`` (leading coefficients first), by ``covariances``
        (and ``order``), by ``F, g, h`` or by ``system``. Besides, ``floats`` ("exact", "decimal" or a largest
        denominator) says what floats mean, which are refused without it; ``pi0``, for order one, asks about the
        Riccati equation started there. Numbers are int, Fraction, Decimal, sympy numbers, or text such as "1/3" and "sqrt(2)".

    Returns
    -------
    Answer

    Raises
    ------
    BadInput
        If the data are no filter, or ``pi0`` comes with an order above one.

    Examples
    --------
    >>> analyze(alpha=[0], gamma=["1/2"]).behaviour
    'converges'
    """
    if isinstance(data, Filter):
        filter = data
        unknown = set(given) - {"pi0", "floats"}
        if unknown:
            raise bad(min(unknown), "comes with a Filter", given[min(unknown)], "pass either a filter or its numbers")
    else:
        if not isinstance(data, (Mapping, str, Path, NoneType)):
            if not all(hasattr(data, name) for name in "ABCD"):
                raise bad("data", "is no filter", data, "pass a mapping, a Filter, the name of a file or a state space object, "
                          "or keywords such as alpha=[...], gamma=[...]")
            data = {"system": data}
        found = read_data(data) if isinstance(data, (str, Path)) else dict(data or {})
        twice = set(found) & set(given)
        if twice:
            raise bad(min(twice), "is given twice", given[min(twice)], "give it once")
        given = {**found, **given}
        filter = filter_from({k: v for k, v in given.items() if k != "pi0"})
    if given.get("pi0") is not None:
        return _riccati(filter, number(given["pi0"], floats=given.get("floats"), name="pi0"))
    if filter.order == 1:
        from exactkf.dynamics.order_one import decide_order_one

        return decide_order_one(filter.a[0] + filter.g[0], filter.g[0])
    from exactkf.dynamics.every_order import decide

    return decide(filter.a, filter.g)


def _riccati(filter: Filter, pi0: Any) -> Answer:
    """The Riccati equation of order one."""
    if filter.order != 1:
        raise BadInput(f"argument 'pi0' comes with a filter of order {filter.order}; the Riccati equation is decided for order one, leave it out")
    from exactkf.dynamics.order_one import decide_riccati_one

    (alpha, gamma, start), _ = together([filter.a[0] + filter.g[0], filter.g[0], pi0])
    return decide_riccati_one(alpha, gamma, start)
