# SPDX-License-Identifier: MIT
"""Lemmas on the expansion of the estimate in innovations, for every n and t.

The innovation y~_t has the coefficients of phi_t for weights. With p_t = phi_t*(F) g and the sum Pi_t of q_k q_k'/r_k, as in `lemmas_gain`,

    E{y~_t y_j} = 0  for j < t,      r_t  for j = t,      h'F^(j-t-1) p_t  for j > t,

and E{x_t y~_k} = F^(t-1-k) p_k by (2.1). So the sum of E{x_t y~_k} y~_k / r_k over k < t has with y_j the covariance F^(t-1-j) g for j < t, and
Pi_t F'^(j-t) h for j >= t, by induction on t: it solves the normal equations for x_t. That y_t - h'x^_t is y~_t follows from the normal equations for -phi_t.

Of the two lists, `GAIN_LEMMAS` compares with the filter whose gain is that of the Riccati equation, and `EXPANSION_LEMMAS` goes without it. They begin
alike; the numbers are those of their places.
"""

from __future__ import annotations

from exactkf.evidence import fact, lemma, use
from exactkf.language import Expr, T, Zero, always, coeff, forall, function, inv, matrix_of, sum_of, symbols, when
from exactkf.language import column as column_of
from proofs.blm91.lemmas_covariance import partial_sums, product_fact
from proofs.blm91.lemmas_estimate import (
    BETWEEN,
    ESTIMATE,
    FILTER_WEIGHTS,
    KALMAN_GAIN,
    PAST,
    Gram,
    Past,
    a,
    by_weights,
    column,
    cov_xy,
    cov_y,
    e,
    estimate_lemmas,
    l,
    q,
    row,
    seen_lemmas,
    solved,
    v,
)
from proofs.blm91.lemmas_gain import RICCATI_LEMMAS, SOLUTION, Ps
from proofs.blm91.lemmas_gain import p as phis_g
from proofs.blm91.notation import REALIZED, STATE, F, c, g, gam, h, i, j, k, n, phi, phis, r, s, szego, t

__all__ = [
    "BY_EXPANSION", "BY_GAIN", "BY_NOISE", "BY_OWN_EXPANSION", "EXPANDED", "EXPANSION_LEMMAS", "EXPANSION_WEIGHTS", "GAIN_LEMMAS", "INNOVATION_GAIN",
    "NOISE_LEMMAS", "OPENED", "OWN_EXPANSION_LEMMAS", "VALUES", "WITH_GAIN", "correlation", "inverse_r", "phi_row",
]

xe, inverse_r, phi_row, W = symbols("cov_xe r_inverse phi_row W")
#: E{x_t y~_k} entry by entry, 1/r_k, and the weights of y~_k on y_0 .. y_(t-1)
EXPANDED = (*STATE, REALIZED, *szego(c), *ESTIMATE, function(xe, [t, k, i], sum_of(j, 0, k, coeff(phi[k], j) * cov_xy(t, j, i))),
            function(inverse_r, [k], 1 / r[k]), function(phi_row, [t, k], matrix_of(i, j, 1, t, coeff(phi[k], j - 1))))
#: the vectors p_t and q_t; weight of y_l in the sum of E{x_t y~_k} y~_k / r_k over k < t
VALUES = SOLUTION[1:]
EXPANSION_WEIGHTS = (*VALUES, function(W, [l, t], when(t == 0, Zero(n, 1), when(
    l == t - 1, inverse_r(t - 1) * phis_g[t - 1], F * W(l, t - 1) + inverse_r(t - 1) * coeff(phi[t - 1], l) * phis_g[t - 1]))))
#: for the filter with the gain (2.17)
WITH_GAIN = (*EXPANDED, *SOLUTION, KALMAN_GAIN, *FILTER_WEIGHTS)
OPENED = {"supported": [phi, phis], "closed": [cov_y, cov_xy, gam, xe, inverse_r], "whole": [r]}


def correlation(time: Expr | int, index: Expr | int) -> Expr:
    """E{x_t y~_k}."""
    return column_of(i, n, xe(time, index, i))


INNOVATION_GAIN = 1 / r[t] * correlation(t + 1, t)
_START = (*RICCATI_LEMMAS[:3], PAST, *RICCATI_LEMMAS[4:9])  # 0 .. 8


def _sums(number: int) -> dict:
    """E{x_t y~_k} for t = k + 1 + e by (2.1), term by term."""
    return lemma(s, always(k, always(e, forall(v, s, k, forall(i, 1, n, sum_of(j, 0, s, coeff(phi[k], j) * cov_xy(k + 1 + e, j, i))
                                                               == sum_of(j, 0, s, coeff(phi[k], j) * (F ** (k + e - j) * g)[i, 1]))))),
                 uses=[use(number, s=s, k=k, e=e, v=v, i=i, times=1), use(3, t=k + 1 + e, j=s + 1, i=i)], base=[use(3, t=k + 1 + e, j=0, i=i)])


def _correlated(number: int) -> dict:
    """E{x_t y~_k} = F^(t-1-k) p_k, after `_sums`."""
    return lemma(t, forall(k, 0, t - 1, forall(i, 1, n, xe(t, k, i) == (F ** (t - 1 - k) * phis_g[k])[i, 1])), direct=True,
                 uses=[use(xe, t, k, i), use(number - 1, s=k, k=k, e=t - 1 - k, v=k, i=i), use(4, t=k, e=t - 1 - k, row=i)])


def _orthogonal(first: int, between: int) -> tuple[dict, ...]:
    """phi_t is monic and orthogonal, by c_k, and by the covariances of the model; the lemmas from this number on."""
    return (
        lemma(t, coeff(phi[t], t) == 1, uses=[use(first, t=t)]),
        lemma(t, forall(j, 0, t, sum_of(k, 0, t, coeff(phi[t], k) * c(abs(k - j))) == when(j == t, r[t], 0)),
              uses=[use(first, t=t), *(use(first + 1, t=t, j=x) for x in (j - 1, t - j)), use(gam, t), use(r, t + 1)]),
        lemma(s, always(t, forall(v, s, t, always(j, sum_of(k, 0, s, coeff(phi[t], k) * cov_y(j, k)) == sum_of(k, 0, s, coeff(phi[t], k) * c(abs(k - j)))))),
              uses=[use(first + 2, s=s, t=t, v=v, j=j, times=1), use(between, t=s + 1, j=j)], base=[use(between, t=0, j=j)]),
    )


# ---------------------------------------------------------------------- the filter and the gain (2.17)
GAIN_LEMMAS = (*_START, *estimate_lemmas(9, 3), _sums(19), _correlated(20), RICCATI_LEMMAS[9])
BY_GAIN = [*by_weights(16), use(20, t=t + 1, k=t, i=row), use(6, t=t, row=row), use(7, t=t)]

# ---------------------------------------------------------------------- the innovation, and new noise
_AT = {"t": t, "k": k, "i": i}
_ROW_OF_F = lemma(s, always(t, forall(v, s, n, forall(k, 0, t - 1, forall(i, 1, n, sum_of(q, 1, s, F[i, q] * xe(t, k, q))
                                                                          == sum_of(q, 1, s, F[i, q] * (F ** (t - 1 - k) * phis_g[k])[q, 1]))))),
                  uses=[use(18, s=s, v=v, times=1, **_AT), use(17, t=t, k=k, i=s + 1)])
NOISE_LEMMAS = (
    *_START, BETWEEN, *seen_lemmas(10, 3), *_orthogonal(12, 9),
    solved(Past(t) * h, 1, -coeff(phi[t], i - 1), use(13, t=t, j=row - 1), use(12, t=t), use(14, s=t, t=t, v=t, j=row - 1),
           use(10, k=n, v=n, t=t, j=row - 1, i=1), use(11, t=t, e=t - row), use(9, t=t, j=row - 1)),
    _sums(16), _correlated(17), _ROW_OF_F,
    fact(t, "product", always(e, always(k, forall(i, 1, n, sum_of(q, 1, n, F[i, q] * (F**e * phis_g[k])[q, 1]) == (F * (F**e * phis_g[k]))[i, 1])))),
)
BY_NOISE = [use(15, t=t, row=column, column=1), use(12, t=t), use(17, t=t + 1, k=k, i=row), use(18, s=n, v=n, t=t, k=k, i=row), use(19, t=t, e=t - 1 - k, k=k, i=row)]

# ---------------------------------------------------------------------- the expansion
_PAIRED = lemma(t, always(j, sum_of(k, 0, t, coeff(phi[t], k) * cov_y(j, k)) == when(j < t, 0, when(j == t, r[t], (T(h) * F ** (j - t - 1) * phis_g[t])[1, 1]))),
                direct=True, uses=[use(12, s=t, t=t, v=t, j=j), use(11, t=t, j=j), use(4, t=t, e=j - t - 1), use(10, t=t)])
_POWERS = lemma(t, always(e, (F**e * phis_g[t] == F**e * g - F ** (e + 1) * Ps[t] * h)
                          & ((T(h) * F**e * phis_g[t])[1, 1] == (T(h) * F**e * g)[1, 1] - (T(h) * F ** (e + 1) * Ps[t] * h)[1, 1])),
                uses=[use(13, t=t, e=e), use(13, t=t, e=e, row=row), use(5, t=t)])
_STEP = lemma(t, always(a, always(e, F**a * Ps[t + 1] * T(F) ** e * h == F ** (a + 1) * Ps[t] * T(F) ** (e + 1) * h
                                  + 1 / r[t] * (T(h) * F**e * phis_g[t])[1, 1] * (F**a * phis_g[t]))),
              uses=[use(14, t=t, a=a, e=e, row=row), use(r, t + 1)])
_CROSS = lemma(t, always(j, always(e, forall(i, 1, n, sum_of(l, 0, t - 1, cov_y(j, l) * (F**e * W(l, t))[i, 1])
                                             == when(j < t, (F ** (t - 1 - j + e) * g)[i, 1], (F**e * Ps[t] * T(F) ** (j - t) * h)[i, 1])))),
               uses=[use(16, t=t, j=j, e=e + 1, i=i), use(15, t=t, j=j), use(13, t=t, e=e, row=i), use(14, t=t, a=e, e=j - t - 1, row=i), use(10, t=t),
                     use(inverse_r, t)])
_WRITTEN_OUT = lemma(t, always(e, forall(l, 0, t - 1, forall(i, 1, n, sum_of(k, 0, t - 1, inverse_r(k) * coeff(phi[k], l) * (F ** (t - 1 - k + e) * phis_g[k])[i, 1])
                                                             == (F**e * W(l, t))[i, 1]))),
                     uses=[use(18, t=t, e=e + 1, l=l, i=i), use(10, t=t)])


def _added_up(number: int, left: Expr, right: Expr, *uses: int) -> dict:
    """Two sums over k up to any place s, as the lemma so numbered; with uses of lemmas at each k."""
    return lemma(s, always(t, forall(v, s, t - 1, forall(l, 0, t - 1, forall(i, 1, n, sum_of(k, 0, s, inverse_r(k) * coeff(phi[k], l) * left)
                                                                             == sum_of(k, 0, s, inverse_r(k) * coeff(phi[k], l) * right))))),
                 uses=[use(number, s=s, t=t, v=v, l=l, i=i, times=1), *(use(x, t=t, k=s + 1, i=i) for x in uses)], base=[use(x, t=t, k=0, i=i) for x in uses])


EXPANSION_LEMMAS = (
    *_START, BETWEEN, *_orthogonal(10, 9), _POWERS, _STEP, _PAIRED, _CROSS,
    solved(Past(t), n, W(i - 1, t)[j, 1], use(16, t=t, j=row - 1, e=0, i=column), use(3, t=t, j=row - 1, i=column)),
    _WRITTEN_OUT, _sums(19), _correlated(20), _added_up(21, xe(t, k, i), (F ** (t - 1 - k) * phis_g[k])[i, 1], 20),
)
BY_EXPANSION = [use(17, t=t + 1, row=column, column=row, times=1), use(20, t=t + 1, k=t, i=row), use(10, t=t), use(21, s=t, t=t + 1, v=t, l=column - 1, i=row),
                use(18, t=t + 1, e=0, l=column - 1, i=row)]

# ---------------------------------------------------------------------- the same with E{x^_t y~_k}
_FOUND = inv(Gram(t)) * Past(t)
_OWN = (phi_row(t, k) * (Gram(t) * _FOUND))[1, i]
OWN_EXPANSION_LEMMAS = (
    *EXPANSION_LEMMAS, product_fact(Gram(t), _FOUND, t, t, n, start=1),
    partial_sums(23, cov_y(i - 1, q - 1) * _FOUND[q, k], cov_y(i - 1, q - 1) * W(q - 1, t)[k, 1], t, t, n, use(17, t=t, row=s + 1, column=k)),
    lemma(t, forall(i, 1, t, forall(k, 1, n, (Gram(t) * _FOUND)[i, k] == cov_xy(t, i - 1, k))), start=1, direct=True,
          uses=[use(22, times=-1, **_AT), use(23, s=t, v=t, **_AT), use(16, t=t, j=i - 1, e=0, i=k), use(3, t=t, j=i - 1, i=k)]),
    fact(t, "product", forall(k, 0, t - 1, forall(i, 1, n, sum_of(q, 1, t, phi_row(t, k)[1, q] * (Gram(t) * _FOUND)[q, i]) == _OWN)), start=1),
    lemma(s, always(t, forall(v, s, t, forall(k, 0, t - 1, forall(i, 1, n, sum_of(q, 1, s, phi_row(t, k)[1, q] * (Gram(t) * _FOUND)[q, i])
                                                                 == sum_of(q, 1, s, coeff(phi[k], q - 1) * cov_xy(t, q - 1, i)))))),
          uses=[use(26, s=s, v=v, times=1, **_AT), use(24, t=t, i=s + 1, k=i)]),
    lemma(t, forall(k, 0, t - 1, forall(i, 1, n, xe(t, k, i) == _OWN)), start=1, direct=True,
          uses=[use(25, **_AT), use(26, s=t, v=t, **_AT), use(xe, t, k, i)]),
    _added_up(28, _OWN, xe(t, k, i), 27),
)
BY_OWN_EXPANSION = [use(17, t=t + 1, row=column, column=row, times=1), use(27, t=t + 1, k=t, i=row), use(28, s=t, t=t + 1, v=t, l=column - 1, i=row), *BY_EXPANSION[1:]]
