# SPDX-License-Identifier: MIT
"""Matrix order for every size: sums and congruences are accepted, wrong signs and missing strictness are not."""

from __future__ import annotations

import pytest

from exactkf.finders.membership import find_order
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import (
    Identity, Statement, T, inv, let, loewner, matrix, nonsingular, pd, positive_definite, positive_semidefinite, psd, standing, symbols,
    symmetric_matrix,
)

n, p, P, Q, A, M, V, K, H = symbols("n p P Q A M V K H")
I = Identity
FILTER = {"sizes": ["n", "p"], "over": {"P": positive_semidefinite(n), "H": positive_semidefinite(n), "A": matrix(n, n), "M": matrix(p, n), "V": positive_definite(p)},
          "where": [let(K, P * T(M) * inv(M * P * T(M) + V))]}
JOSEPH = A * ((I(n) - K * M) * P * T(I(n) - K * M) + K * V * T(K)) * T(A) + H
STEP = A * (P - K * M * P) * T(A) + H

TRUE = {
    "a sum of congruences": ({**FILTER, "says": psd(JOSEPH)}, ()),
    "the covariance step": ({**FILTER, "says": psd(STEP)}, [[JOSEPH]]),
    "innovation covariance": ({**FILTER, "says": pd(M * P * T(M) + V)}, ()),
    "an inverse": ({**FILTER, "says": pd(inv(V) + M * P * T(M))}, ()),
    "nonsingular congruence": ({"sizes": ["n"], "over": {"P": positive_definite(n), "A": nonsingular(n)}, "says": pd(T(A) * P * A)}, ()),
    "a Gram matrix": ({"sizes": ["n", "p"], "over": {"M": matrix(p, n)}, "says": psd(T(M) * M)}, ()),
    "order from a hypothesis": ({"sizes": ["n"], "over": {"P": symmetric_matrix(n), "Q": symmetric_matrix(n), "A": matrix(n, n)},
                                "given": [standing("order", loewner(P, Q))], "says": loewner(A * P * T(A), A * Q * T(A))}, [[A * (P - Q) * T(A)]]),
}
FALSE = {
    "minus a Gram matrix": {"sizes": ["n", "p"], "over": {"M": matrix(p, n)}, "says": psd(-T(M) * M)},
    "strict without reason": {"sizes": ["n", "p"], "over": {"M": matrix(p, n)}, "says": pd(T(M) * M)},
    "singular congruence": {"sizes": ["n"], "over": {"P": positive_definite(n), "A": matrix(n, n)}, "says": pd(T(A) * P * A)},
    "symmetric is not semidefinite": {"sizes": ["n"], "over": {"P": symmetric_matrix(n)}, "says": psd(P)},
    "a product of two": {"sizes": ["n"], "over": {"P": positive_semidefinite(n), "Q": positive_semidefinite(n)}, "says": psd(P * Q)},
    "a square that is no Gram matrix": {"sizes": ["n"], "over": {"A": matrix(n, n)}, "says": psd(A * A)},
    "a difference": {"sizes": ["n"], "over": {"P": positive_semidefinite(n), "Q": positive_semidefinite(n)}, "says": loewner(P, Q)},
}


@pytest.mark.parametrize("name", TRUE)
def test_true_order_is_proved(name):
    """A certificate is found and replays."""
    parts, sums = TRUE[name]
    data = Statement(**parts).to_json()
    import json

    found = find_order(data, json.loads(json.dumps([[t.tree for t in terms] for terms in sums])))
    assert found is not None
    replay(seal("T", "order", data, {"parts": found}))


@pytest.mark.parametrize("name", FALSE)
def test_false_order_is_not(name):
    """Nothing is found, and the matrix itself is not accepted as a semidefinite term."""
    data = Statement(**FALSE[name]).to_json()
    assert find_order(data) is None
    goal = data["says"][1] if data["says"][0] != "loewner" else ["-", *data["says"][1:]]
    with pytest.raises(Rejected):
        replay(seal("T", "order", data, {"parts": [{"sum": [goal], "terms": []}]}))
