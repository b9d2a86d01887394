# SPDX-License-Identifier: MIT
"""Lemmas for (4.7): entry k of gamma(t) is the Schur parameter gamma_{t+k} of v, for every n, t and k < n.

By (4.2) gamma_t is g_1(t), which the coordinates make the first entry of gamma(t). As G moves the entries up by one,
entry k of gamma(t) is the first of gamma(t + k), by induction on k for all t at once.

They are numbered as they stand in `SHIFT_LEMMAS`: ten on the orbit, five of `DELETION`, and those here. The bound k <= u says that
entries of gamma(t) are meant.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from exactkf.evidence import lemma, use
from exactkf.language import always, forall
from proofs.blz94.lemmas_deletion import DELETION, NAMES_0, OPENED_AT_START, e_of, pairing, schur, step
from proofs.blz94.lemmas_gain import GAIN, OPENED_FOR_GAIN
from proofs.blz94.lemmas_orbit import FOUR_ALPHA
from proofs.blz94.notation import gamma, k, n, t, u

__all__ = ["OPENED_FOR_SHIFT", "SHIFT_LEMMAS"]

_ORBIT = GAIN[:10]


def _after_orbit(item: Mapping[str, Any], *more: dict[str, Any]) -> dict[str, Any]:
    """The lemma of `DELETION` with the numbers it has here, and more uses."""
    moved = {key: [{**x, "lemma": x["lemma"] + len(_ORBIT)} if "lemma" in x else x for x in item[key]] for key in ("uses", "base") if key in item}
    return {**item, **moved, "uses": [*more, *moved["uses"]]}


_DELETION = (*map(_after_orbit, DELETION[:3]), _after_orbit(step(gamma), use(9, t=t)), _after_orbit(pairing(4, 0, NAMES_0, gamma), use(9, t=k)))
_SCHUR = lemma(t, schur(t) == gamma[t][1], direct=True, uses=[use(schur, t), use(14, k=t, l=0), use(e_of, 0, t, 1), use(9, t=t)])
_MOVED = lemma(k, always(t, forall(u, k, n - 1, gamma[t + k][1] == gamma[t][k + 1])), uses=[use(16, k=k, t=t + 1, u=u), use(gamma, t + 1, row=k + 1)])
SHIFT_LEMMAS = (*_ORBIT, *_DELETION, _SCHUR, _MOVED)
OPENED_FOR_SHIFT = {
    **FOUR_ALPHA, "supported": [*FOUR_ALPHA["supported"], *OPENED_AT_START["supported"]], "closed": [*OPENED_AT_START["closed"], *OPENED_FOR_GAIN["closed"]],
}
