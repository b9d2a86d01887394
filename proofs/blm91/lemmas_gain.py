# SPDX-License-Identifier: MIT
"""Lemmas on the gain of the Kalman filter, for every n and t.

By (2.1), E{x_(t+1) y~_t} is a sum of F^(t-k) g with the coefficients of phi_t, that is phi_t*(F) g. The vectors p_t = phi_t*(F) g and
q_t = phi_t(F) g obey the recursion of the polynomials with F in place of z, and h'q_t = r_t gamma_t. Let

    Pi_0 = 0,   Pi_(t+1) = Pi_t + q_t q_t'/r_t.

Then p_t = g - F Pi_t h and r_t = 1 - h' Pi_t h, by induction; and Pi_(t+1) = F Pi_t F' + p_t p_t'/r_t, because
q q' - p p' at t + 1 is 1 - gamma_t^2 times F q q' F' - p p' at t. So Pi_t is the solution of the Riccati equation, and p_t/r_t its gain.

They are numbered as they stand in `RICCATI_LEMMAS`.
"""

from __future__ import annotations

from typing import Any

from exactkf.evidence import lemma, use
from exactkf.language import Expr, Identity, T, Zero, always, coeff, forall, matrix, rec, rev, sum_of, symbols, symmetric_matrix, vector
from proofs.blm91.notation import (
    REALIZED,
    STATE,
    WRITTEN_OUT,
    F,
    P,
    c,
    combined,
    covariance,
    g,
    gam,
    h,
    i,
    k,
    m,
    n,
    phi,
    phis,
    r,
    state,
    szego,
    t,
)

__all__ = [
    "BACKWARD", "BY_RICCATI", "BY_SUMS", "COEFFICIENTS", "FORWARD", "GAIN", "MODELLED", "REVERSED", "RICCATI_LEMMAS", "SOLUTION", "SYSTEM", "from_the_past",
    "innovation", "row", "sums_with",
]

row, column, e, q, p, Pi, Ps = symbols("row column e phi_g phis_g Pi Pi_sum")
SYSTEM = {F: matrix(n, n), h: vector(n), g: vector(n), P: symmetric_matrix(n)}
MODELLED = (*STATE, REALIZED, *szego(c))
FORWARD, innovation = combined(phi, symbols("ytilde_0 ytilde_v ytilde_w"))
BACKWARD, from_the_past = combined(phis, symbols("yback_0 yback_v yback_w"))
COEFFICIENTS = ("X_0 and X_v are the coefficients of x_0 and v_s in x_t; y~_t is a sum with the coefficients of phi_t for c_k = h'F^(k-1)g, and ytilde_0, ytilde_v, "
                "ytilde_w are the coefficients of x_0, v_s, w_s in its first i + 1 terms. The sums are over all noise up to time m.")
#: (2.17)
GAIN = 1 / r[t] * covariance(state(t + 1), innovation(t, t))
REVERSED = lemma(t, phis[t] == rev(phi[t], t), rule=True)


def sums_with(polynomial: Expr, combination: Any, number: int = 3, **realization: Any) -> dict:
    """E{x_(t+1) (p_(t,0) y_0 + .. + p_(t,i) y_i)'} from (2.1), by induction on i, as the lemma so numbered."""
    return lemma(i, forall(t, i, m, covariance(state(t + 1), combination(t, i), **realization)
                           == sum_of(k, 0, i, coeff(polynomial[t], k) * (F ** (t - k) * g))), uses=[use(number, i=i, t=t, row=row)])


BY_SUMS = {"supported": [phi, phis], "uses": [use(3, i=t, t=t, row=row)]}

#: the Riccati equation (1.3), (1.4), and what its solution is compared with
SOLUTION = (rec(Pi, t, Zero(n, n), F * Pi[t] * T(F) + (g - F * Pi[t] * h) * T(g - F * Pi[t] * h) / (1 - T(h) * Pi[t] * h)),
            rec(q, t, g, F * q[t] - gam(t) * p[t]), rec(p, t, g, p[t] - gam(t) * (F * q[t])), rec(Ps, t, 0 * Identity(n), Ps[t] + 1 / r[t] * (q[t] * T(q[t]))))


def _value(polynomial: Expr, of: Expr) -> Expr:
    """F^e times a polynomial of F applied to g; and the same seen by h."""
    seen = sum_of(k, 0, t, coeff(polynomial[t], k) * (T(h) * F ** (k + e) * g)[1, 1]) == (T(h) * F**e * of[t])[1, 1]
    return (sum_of(k, 0, t, coeff(polynomial[t], k) * (F ** (k + e) * g)) == F**e * of[t]) & seen


_VALUES = lemma(t, always(e, _value(phi, q) & _value(phis, p)), uses=[x for s in (e, e + 1) for x in (use(4, t=t, e=s), use(4, t=t, e=s, row=row))])
_SEEN = lemma(t, (T(h) * q[t])[1, 1] == r[t] * gam(t), direct=True, uses=[use(gam, t), use(4, t=t, e=0)])
_GAIN = lemma(t, p[t] == g - F * Ps[t] * h, uses=[use(6, t=t, row=row), use(5, t=t)])
_NORM = lemma(t, (T(h) * Ps[t] * h)[1, 1] == 1 - r[t], uses=[use(7, t=t), use(5, t=t), use(r, t + 1)])
_OTHER_STEP = lemma(t, Ps[t + 1] == F * Ps[t] * T(F) + 1 / r[t] * (p[t] * T(p[t])), uses=[use(8, t=t, row=row, column=column), use(r, t + 1)])
_SOLUTION = lemma(t, Pi[t] == Ps[t], rule=True, uses=[use(8, t=t, row=row, column=column), use(7, t=t), use(6, t=t, row=row), use(6, t=t, row=column)])
RICCATI_LEMMAS = (REVERSED, *WRITTEN_OUT, sums_with(phi, innovation), _VALUES, _SEEN, _GAIN, _NORM, _OTHER_STEP, _SOLUTION)
BY_RICCATI = {"supported": [phi, phis], "closed": [gam], "whole": [r],
              "uses": [use(3, i=t, t=t, row=row), use(4, t=t, e=0, row=row), use(6, t=t, row=row), use(7, t=t)]}
