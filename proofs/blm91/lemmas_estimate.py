# SPDX-License-Identifier: MIT
"""Lemmas on the estimate of the state by past outputs, for every n and t.

An element of the span of y_0 .. y_(t-1) is the row of its weights on them. Those of the estimate of x_t are E{x_t Y'} E{YY'}^(-1), Y being the past,
in which by (2.1), (2.2) the covariances are E{x_t y_j} = F^(t-1-j) g and E{y_i y_j} = h'F^(|i-j|-1) g. Let Pi_t be the solution of the Riccati equation
(1.4), K_t the gain (1.3) and U_t the weights of the filter (1.2) with this gain. Along it

    E{(U_t Y) y_j} = F^(t-1-j) g  for j < t,        = Pi_t F'^(j-t) h  for j >= t,

by induction on t. So U_t solves the normal equations: it is the estimate. Its covariance is E{x_t Y'} U_t', and that is Pi_t, by induction on t again.

They are numbered as they stand in `ESTIMATE_LEMMAS`. A sum over an index of entries of F, or h, and of another matrix is a product by the fact so named.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from exactkf.evidence import fact, lemma, use
from exactkf.language import Expr, T, Zero, always, forall, function, hstack, inv, matrix_of, rec, standing, sum_of, symbols, when
from proofs.blm91.notation import WRITTEN_OUT, F, covariance, g, h, i, j, k, n, output, state, t

__all__ = [
    "BETWEEN", "BY_ESTIMATE", "CLOSED", "ESTIMATE", "ESTIMATE_LEMMAS", "FILTER_WEIGHTS", "KALMAN", "KALMAN_GAIN", "PAST", "PROJECTED", "RICCATI_GAIN", "SOME",
    "Gram", "Past", "by_weights", "column", "cov_xy", "cov_y", "e", "estimate_lemmas", "filtered", "innovation_weights", "l", "q", "row", "seen_lemmas", "solved", "v", "xh",
]

xh, cov_y, cov_xy, Gram, Past, KALMAN, U, Pi = symbols("x_hat cov_y cov_xy Gram Past K U Pi")
a, e, l, q, v, row, column = symbols("a e l q v row column")

#: E{y_i y_j} and E{x_t y_j}, with all noise up to their times; weights of the estimate of x_t on y_0 .. y_(t-1)
ESTIMATE = (
    function(cov_y, [i, j], covariance(output(i), output(j), last=i + j)[1, 1]),
    function(cov_xy, [t, j, i], covariance(state(t), output(j), last=t + j)[i, 1]),
    function(Gram, [t], matrix_of(i, j, t, t, cov_y(i - 1, j - 1))),
    function(Past, [t], matrix_of(i, j, t, n, cov_xy(t, i - 1, j))),
    function(xh, [t], when(t == 0, Zero(n, t), T(inv(Gram(t)) * Past(t)))),
)
KALMAN_GAIN = function(KALMAN, [t], (g - F * Pi[t] * h) / (1 - T(h) * Pi[t] * h))
#: (1.4), and the gain (1.3)
RICCATI_GAIN = (rec(Pi, t, Zero(n, n), F * Pi[t] * T(F) + (g - F * Pi[t] * h) * T(g - F * Pi[t] * h) / (1 - T(h) * Pi[t] * h)), KALMAN_GAIN)
#: weight of y_l in the filter at time t
FILTER_WEIGHTS = (function(U, [l, t], when(t == 0, Zero(n, 1), when(l == t - 1, KALMAN(t - 1), F * U(l, t - 1) - KALMAN(t - 1) * (T(h) * U(l, t - 1))))),)
CLOSED = {"closed": [cov_y, cov_xy]}
SOME = [standing("n >= 1", n >= 1)]
PROJECTED = ("x^_t is the row (n x t) of its weights on y_0 .. y_(t-1), by the normal equations for the covariances Gram and Past of the model; what stands on either side "
             "are weights. X_0 and X_v are the coefficients of x_0 and v_s in x_t; the sums are over all noise up to the times of both factors.")


def innovation_weights() -> Expr:
    """Those of y_t - h'x^_t on y_0 .. y_t."""
    return hstack(Zero(1, t), 1) - hstack(T(h) * xh(t), 0)


def filtered(gain: Expr) -> Expr:
    """The estimate of x_(t+1) by the filter with a gain."""
    return xh(t + 1) == hstack(F * xh(t), Zero(n, 1)) + gain * innovation_weights()


#: (2.1), for the covariances of the model
PAST = lemma(t, forall(j, 0, t - 1, forall(i, 1, n, cov_xy(t, j, i) == (F ** (t - 1 - j) * g)[i, 1])), direct=True, uses=[use(cov_xy, t, j, i)])


def solved(right: Expr, columns: Any, weight: Any, *uses: Any) -> dict[str, Any]:
    """The normal equations with this right side, for t > 0: ``weight`` is in i and j."""
    return fact(t, "solve", inv(Gram(t)) * right == matrix_of(i, j, t, columns, weight), start=1, uses=uses)


def _summed(number: int, past: int, term: Callable[[Expr], Expr]) -> dict[str, Any]:
    """Sums of E{x_t y_j}, entry by entry."""
    return lemma(k, forall(v, k, n, always(t, forall(j, 0, t - 1, forall(i, 1, n, sum_of(q, 1, k, term(cov_xy(t, j, q)))
                                                                         == sum_of(q, 1, k, term((F ** (t - 1 - j) * g)[q, 1])))))),
                 uses=[use(number, k=k, v=v, t=t, j=j, i=i, times=1), use(past, t=t, j=j, i=k + 1)])


def _crossed(before: Expr, x: Any, y: Any) -> Expr:
    """What the induction on t says, multiplied from the left by F^e or h'F^e."""
    return sum_of(l, 0, t - 1, cov_y(j, l) * (before * U(l, t))[x, y]) == when(j < t, (before * F ** (t - 1 - j) * g)[x, y],
                                                                            (before * Pi[t] * T(F) ** (j - t) * h)[x, y])


#: (2.2)
BETWEEN = lemma(t, always(j, cov_y(j, t) == when(j == t, 1, (T(h) * F ** (abs(j - t) - 1) * g)[1, 1])), direct=True, uses=[use(cov_y, j, t)])


def seen_lemmas(number: int, past: int) -> tuple[dict[str, Any], dict[str, Any]]:
    """Products of h' with E{x_t y_j}, from this number on."""
    return (_summed(number, past, lambda x: T(h)[1, q] * x),
            fact(t, "product", always(e, sum_of(q, 1, n, T(h)[1, q] * (F**e * g)[q, 1]) == (T(h) * (F**e * g))[1, 1])))


def estimate_lemmas(first: int, past: int) -> tuple[dict[str, Any], ...]:
    """The lemmas on the estimate, the first of them with this number; ``past`` is that of `PAST`."""
    between, sym, cross, by_f, with_f, by_h, with_h = range(first, first + 7)
    at = {"t": t, "j": row - 1}
    return (
        BETWEEN,
        lemma(t, always(a, always(e, (T(h) * F**a * Pi[t] * T(F) ** e * h)[1, 1] == (T(h) * F**e * Pi[t] * T(F) ** a * h)[1, 1])),
              uses=[use(sym, t=t, a=a + 1, e=e + 1)]),
        lemma(t, always(j, always(e, forall(i, 1, n, _crossed(F**e, i, 1)) & _crossed(T(h) * F**e, 1, 1))),
              uses=[*(use(cross, t=t, j=j, e=x, i=i) for x in (e, e + 1)), *(use(cross, t=t, j=j, e=x) for x in (0, e, e + 1)),
                    use(between, t=t, j=j), *(use(sym, t=t, a=x, e=j - t) for x in (0, e, e + 1))]),
        _summed(by_f, past, lambda x: F[i, q] * x),
        fact(t, "product", always(e, forall(i, 1, n, sum_of(q, 1, n, F[i, q] * (F**e * g)[q, 1]) == (F * (F**e * g))[i, 1]))),
        *seen_lemmas(by_h, past),
        solved(Past(t), n, U(i - 1, t)[j, 1], use(cross, e=0, i=column, **at), use(past, i=column, **at)),
        solved(Past(t) * T(F), n, (F * U(i - 1, t))[j, 1], use(cross, e=1, i=column, **at), use(by_f, k=n, v=n, i=column, **at),
               use(with_f, t=t, e=t - row, i=column)),
        solved(Past(t) * h, 1, (T(h) * U(i - 1, t))[1, 1], use(cross, e=0, **at), use(by_h, k=n, v=n, i=1, **at), use(with_h, t=t, e=t - row)),
    )


def by_weights(first: int) -> list[dict[str, Any]]:
    """The weights of the estimates at t + 1 and at t, by the normal equations, which are the lemmas from this number on."""
    return [use(first, t=t + 1, row=column, column=row, times=1), use(first + 1, t=t, row=column, column=row), use(first + 2, t=t, row=column, column=1)]


ESTIMATE_LEMMAS = (*WRITTEN_OUT, PAST, *estimate_lemmas(3, 2))
BY_ESTIMATE = by_weights(10)
