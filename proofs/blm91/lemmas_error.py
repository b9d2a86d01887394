# SPDX-License-Identifier: MIT
"""Lemmas on the covariance of the error of the estimate, for every n and t.

E{(x - x^)(x - x^)'} is E{xx'} - E{x^x'} - E{xx^'} + E{x^x^'}. By the normal equations E{x^x'} is E{x^x^'}, which is the solution Pi_t of the Riccati
equation (1.4), and E{xx'} = P. So the error has the covariance P - Pi_t; with the noise of the model written out, (1.4) for it is another Riccati equation.

They are numbered as they stand in `ERROR_LEMMAS`, and after these in `RICCATI_OF_ERROR`.
"""

from __future__ import annotations

from exactkf.evidence import lemma, use
from exactkf.language import Expr, T, forall, function, inv, rec, symbols
from proofs.blm91.lemmas_covariance import COVARIANCE, COVARIANCE_LEMMAS, SYMMETRIC, cov, moved, multiplied, partial_sums, product_fact
from proofs.blm91.lemmas_estimate import CLOSED, ESTIMATE, FILTER_WEIGHTS, RICCATI_GAIN, Gram, Past, Pi, U, column, q, row, xh
from proofs.blm91.notation import NOISE, STATE, F, P, covariance, h, i, k, n, s, state, t

__all__ = ["BY_ERROR", "BY_RICCATI_OF_ERROR", "CLOSED_FOR_ERROR", "ERROR", "ERROR_LEMMAS", "FROM_STATE", "RICCATI_OF_ERROR", "SAME_ERROR", "err", "next_error", "rec_p"]

err, rec_p = symbols("p_t p_riccati")
#: E{(x_t - x^_t)(x_t - x^_t)'}
ERROR = (*STATE, *ESTIMATE, *COVARIANCE, *RICCATI_GAIN, *FILTER_WEIGHTS,
         function(err, [t], covariance(state(t), state(t), last=t) - xh(t) * Past(t) - T(xh(t) * Past(t)) + cov(t)))
CLOSED_FOR_ERROR = {"closed": [*CLOSED["closed"], moved]}


def next_error(p: Expr) -> Expr:
    """(4.26) for a state of any size."""
    Q, S, R = NOISE
    return F * p * T(F) - (F * p * h + S) * T(F * p * h + S) / (T(h) * p * h + R) + Q


#: its solution from the covariance of the state
FROM_STATE = rec(rec_p, t, P, next_error(rec_p[t]))

_FIRST = len(COVARIANCE_LEMMAS) + 1
_LAST = _FIRST + 3
_AT = {"t": t, "i": i, "k": k}


def _places(body: Expr) -> Expr:
    return forall(i, 1, n, forall(k, 1, n, body))


def _is_error(i: Expr, k: Expr) -> list:
    """What is known of the parts of the covariance at a place."""
    return [*(use(number, t=t, i=x, k=y) for number in (20, _FIRST + 2) for x, y in ((i, k), (k, i))), use(21, t=t, a=0, e=0, i=i, k=k)]


def _normal_equations() -> tuple:
    """E{x^_t x_t'} is Pi_t."""
    found = inv(Gram(t)) * Past(t)
    return (
        product_fact(T(found), Past(t), n, t, n, start=1),
        partial_sums(_FIRST + 1, T(found)[i, q] * Past(t)[q, k], U(q - 1, t)[i, 1] * moved(t - q, k), n, t, n,
                     use(10, t=t, row=s + 1, column=i), use(2, t=t, j=s, i=k), use(moved, t - 1 - s, k)),
        lemma(t, _places((T(found) * Past(t))[i, k] == Pi[t][i, k]), start=1, direct=True,
              uses=[use(_FIRST, times=-1, **_AT), use(_FIRST + 1, s=t, v=t, **_AT), use(14, a=0, e=0, **_AT)]))


ERROR_LEMMAS = (*COVARIANCE_LEMMAS, SYMMETRIC, *_normal_equations(),
                lemma(t, _places(err(t)[i, k] == (P - Pi[t])[i, k]), direct=True, uses=_is_error(i, k)),
                lemma(t, _places(err(t)[i, k] == err(t)[k, i]), direct=True,
                      uses=[use(_LAST, t=t, i=i, k=k, times=1), use(_LAST, t=t, i=k, k=i, times=-1), use(21, t=t, a=0, e=0, i=i, k=k)]))
BY_ERROR = [use(_LAST, t=t, i=row, k=column), use(_LAST + 1, t=t, i=row, k=column), use(21, t=t, a=0, e=0, i=row, k=column)]
#: next of a list: the solution of (4.26) from P is P - Pi_t
SAME_ERROR = lemma(t, rec_p[t] == P - Pi[t], rule=True, uses=[use(21, t=t, a=x, e=x, i=row, k=column) for x in (0, 1)])

_BOTH = err(t), P - Pi[t]
_WITH_F, _WITH_H = (tuple(y * z for y in _BOTH) for z in (T(F), h))
RICCATI_OF_ERROR = (
    *ERROR_LEMMAS, *multiplied(_LAST + 2, None, _BOTH, T(F), _LAST, n, n), *multiplied(_LAST + 6, F, _WITH_F, None, _LAST + 5, n, n),
    *multiplied(_LAST + 10, None, _BOTH, h, _LAST, n, 1), *multiplied(_LAST + 14, F, _WITH_H, None, _LAST + 13, n, 1),
    *multiplied(_LAST + 18, T(h), _WITH_H, None, _LAST + 13, 1, 1))
BY_RICCATI_OF_ERROR = [
    use(_LAST, t=t + 1, i=row, k=column, times=1), use(_LAST + 9, t=t, i=row, k=column), use(_LAST + 17, t=t, i=row, k=1), use(_LAST + 17, t=t, i=column, k=1),
    use(_LAST + 21, t=t, i=1, k=1), use(21, t=t, a=1, e=1, i=row, k=column), use(_LAST + 1, t=t + 1, i=row, k=column)]
