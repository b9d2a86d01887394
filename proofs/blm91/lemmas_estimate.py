# SPDX-License-Identifier: MIT
"""Lemmas on the estimate of the state by past outputs, for every n and t.

An element of the span of y_0 .. y_(t-1) is the row of its weights on them. Those of the estimate of x_t are E{x_t Y'} E{YY'}^(-1), Y being the past,
in which by (2.1), (2.2) the covariances are E{x_t y_j} = F^(t-1-j) g and E{y_i y_j} = h'F^(|i-j|-1) g. Let Pi_t be the solution of the Riccati equation
(1.4), K_t the gain (1.3) and U_t the weights of the filter (1.2) with this gain. Along it

    E{(U_t Y) y_j} = F^(t-1-j) g  for j < t,        = Pi_t F'^(j-t) h  for j >= t,

by induction on t. So U_t solves the normal equations: it is the estimate.

They are numbered as they stand in `ESTIMATE_LEMMAS`. A sum over an index of entries of F, or h, and of another matrix is a product by the fact so named.
"""

from __future__ import annotations

from typing import Any

from exactkf.evidence import fact, lemma, use
from exactkf.language import Expr, T, Zero, always, forall, function, hstack, inv, matrix_of, rec, standing, sum_of, symbols, when
from proofs.blm91.notation import WRITTEN_OUT, F, covariance, g, h, i, j, k, n, output, state, t

__all__ = [
    "BY_ESTIMATE", "CLOSED", "ESTIMATE", "ESTIMATE_LEMMAS", "KALMAN", "PROJECTED", "RICCATI_GAIN", "SOME", "FILTER_WEIGHTS",
    "estimate_lemmas", "filtered", "gr", "innovation_weights", "nx", "xh",
]

xh, gr, nx, KALMAN, U, Pi, a, e, l, q, v, row, column = symbols("x_hat cov_y cov_xy K U Pi a e l q v row column")

#: E{y_i y_j} and E{x_t y_j}, with all noise up to their times; weights of the estimate of x_t on y_0 .. y_(t-1)
ESTIMATE = (
    function(gr, [i, j], covariance(output(i), output(j), last=i + j)[1, 1]),
    function(nx, [t, j, i], covariance(state(t), output(j), last=t + j)[i, 1]),
    function(xh, [t], when(t == 0, Zero(n, t), T(inv(matrix_of(i, j, t, t, gr(i - 1, j - 1))) * matrix_of(i, j, t, n, nx(t, i - 1, j))))),
)
#: (1.4), and the gain (1.3)
RICCATI_GAIN = (rec(Pi, t, Zero(n, n), F * Pi[t] * T(F) + (g - F * Pi[t] * h) * T(g - F * Pi[t] * h) / (1 - T(h) * Pi[t] * h)),
           function(KALMAN, [t], (g - F * Pi[t] * h) / (1 - T(h) * Pi[t] * h)))
#: weight of y_l in the filter at time t
FILTER_WEIGHTS = (function(U, [l, t], when(t == 0, Zero(n, 1), when(l == t - 1, KALMAN(t - 1), F * U(l, t - 1) - KALMAN(t - 1) * (T(h) * U(l, t - 1))))),)
CLOSED = {"closed": [gr, nx]}
SOME = [standing("n >= 1", n >= 1)]
PROJECTED = ("x^_t is the row (n x t) of its weights on y_0 .. y_(t-1), by the normal equations for the covariances of the model; weights on y_0 .. y_t are what stands on "
             "either side. X_0 and X_v are the coefficients of x_0 and v_s in x_t; the sums are over all noise up to the times of both factors.")


def innovation_weights() -> Expr:
    """Those of y_t - h'x^_t on y_0 .. y_t."""
    return hstack(Zero(1, t), 1) - hstack(T(h) * xh(t), 0)


def filtered(gain: Expr) -> Expr:
    """The estimate of x_(t+1) by the filter with a gain."""
    return xh(t + 1) == hstack(F * xh(t), Zero(n, 1)) + gain * innovation_weights()


def _gram() -> Expr:
    return matrix_of(i, j, t, t, gr(i - 1, j - 1))


def _with_past() -> Expr:
    return matrix_of(i, j, t, n, nx(t, i - 1, j))


def estimate_lemmas(first: int) -> tuple[dict[str, Any], ...]:
    """The lemmas on the estimate, the first of them with this number."""
    between, past, sym, cross, by_f, with_f, by_h, with_h = range(first, first + 8)
    at_row = [use(past, t=t, j=row - 1, i=column)]

    def solved(right: Expr, weight: Any, *uses: Any) -> dict[str, Any]:
        """The normal equations with this right side, for t > 0."""
        return fact(t, "solve", inv(_gram()) * right == matrix_of(i, j, t, n, weight), start=1, uses=uses)

    def summed(number: int, term: Any) -> dict[str, Any]:
        """Sums of E{x_t y_j}, entry by entry."""
        return lemma(k, forall(v, k, n, always(t, forall(j, 0, t - 1, forall(i, 1, n, sum_of(q, 1, k, term(nx(t, j, q)))
                                                                             == sum_of(q, 1, k, term((F ** (t - 1 - j) * g)[q, 1])))))),
                     uses=[use(number, k=k, v=v, t=t, j=j, i=i, times=1), use(past, t=t, j=j, i=k + 1)])

    return (
        lemma(t, always(j, gr(j, t) == when(j == t, 1, (T(h) * F ** (abs(j - t) - 1) * g)[1, 1])), direct=True, uses=[use(gr, j, t)]),
        lemma(t, forall(j, 0, t - 1, forall(i, 1, n, nx(t, j, i) == (F ** (t - 1 - j) * g)[i, 1])), direct=True, uses=[use(nx, t, j, i)]),
        lemma(t, always(a, always(e, (T(h) * F**a * Pi[t] * T(F) ** e * h)[1, 1] == (T(h) * F**e * Pi[t] * T(F) ** a * h)[1, 1])),
              uses=[use(sym, t=t, a=a + 1, e=e + 1)]),
        lemma(t, always(j, always(e, forall(i, 1, n, sum_of(l, 0, t - 1, gr(j, l) * (F**e * U(l, t))[i, 1])
                                            == when(j < t, (F ** (t - 1 - j + e) * g)[i, 1], (F**e * Pi[t] * T(F) ** (j - t) * h)[i, 1]))
                                  & (sum_of(l, 0, t - 1, gr(j, l) * (T(h) * F**e * U(l, t))[1, 1])
                                     == when(j < t, (T(h) * F ** (t - 1 - j + e) * g)[1, 1], (T(h) * F**e * Pi[t] * T(F) ** (j - t) * h)[1, 1])))),
              uses=[*(use(cross, t=t, j=j, e=x, i=i) for x in (e, e + 1)), *(use(cross, t=t, j=j, e=x) for x in (0, e, e + 1)), use(between, t=t, j=j), *(use(sym, t=t, a=x, e=j - t) for x in (0, e, e + 1))]),
        summed(by_f, lambda x: F[i, q] * x),
        fact(t, "product", always(e, forall(i, 1, n, sum_of(q, 1, n, F[i, q] * (F**e * g)[q, 1]) == (F * (F**e * g))[i, 1]))),
        summed(by_h, lambda x: T(h)[1, q] * x),
        fact(t, "product", always(e, sum_of(q, 1, n, T(h)[1, q] * (F**e * g)[q, 1]) == (T(h) * (F**e * g))[1, 1])),
        solved(_with_past(), U(i - 1, t)[j, 1], use(cross, t=t, j=row - 1, e=0, i=column), *at_row),
        solved(_with_past() * T(F), (F * U(i - 1, t))[j, 1], use(cross, t=t, j=row - 1, e=1, i=column), use(by_f, k=n, v=n, t=t, j=row - 1, i=column),
               use(with_f, t=t, e=t - row, i=column)),
        fact(t, "solve", inv(_gram()) * _with_past() * h == matrix_of(i, j, t, 1, (T(h) * U(i - 1, t))[1, 1]), start=1,
             uses=[use(cross, t=t, j=row - 1, e=0), use(by_h, k=n, v=n, t=t, j=row - 1, i=1), use(with_h, t=t, e=t - row)]),
    )


ESTIMATE_LEMMAS = (*WRITTEN_OUT, *estimate_lemmas(2))
BY_ESTIMATE = [use(10, t=t + 1, row=column, column=row), use(11, t=t, row=column, column=row), use(12, t=t, row=column, column=1)]
