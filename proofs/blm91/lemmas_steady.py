# SPDX-License-Identifier: MIT
"""Positive real data along the fast algorithm, for every n and t: what their convergence rests on.

Where D is positive on the circle it has one monic Schur factor, D = d x(z)x(1/z). With A = J - xh', k = x - a and F = J - ah' stable
the series P = d (kk' + F kk'F' + ..) is the covariance of a state with innovation gain k and innovation variance d:

    P = FPF' + d kk',   g = FPh + d k,   1 = h'Ph + d.

Let S_t be the sum of r_s q*_s q*_s' over s < t, which is Pi_t, and E_t = P - S_t. Then r_t = d + h'E_t h, r_t(q_t - x) = A E_t h and

    E_(t+1) = (J - q_t h') E_t (J - q_t h')' + d (x - q_t)(x - q_t)' = A E_t A' - r_t (q_t - x)(q_t - x)'.

By the first form E_t is semidefinite, so that r_t and r_(t+1) = (1 - gamma_t^2) r_t are at least d > 0 and no step divides by zero; by the second
E_t is at most Y_t = A^t P A'^t, which tends to zero. So S_t tends to P, r_t to d, q_t to x, and r_t q*_t q*_t' = E_t - E_(t+1) to zero.

The same for the Riccati equation of any F, h, g: there q_t - a is the gain k_t = (g - F Pi_t h)/(1 - h'Pi_t h), and for another covariance P_2 of a state,
with noise covariance N, P_2 - Pi_t is semidefinite as well, by

    P_2 - Pi_(t+1) = (F - k_t h')(P_2 - Pi_t)(F - k_t h')' + (I, -k_t) N (I, -k_t)'.
"""

from exactkf.evidence import example, induction, instances, order, restated
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    given,
    hstack,
    inv,
    let,
    loewner,
    matrix,
    matrix_of,
    positive,
    positive_semidefinite,
    psd,
    rec,
    schur,
    standing,
    sum_of,
    symbols,
    symmetric,
    vector,
    when,
)
from proofs.blm91.notation import SW, WEIGHTS, XX, F, J, P, a, dd, g, h, i, j, k, n, q, qs, r, t, w, x

__all__ = ["CONVERGES", "CONVERGES_BY", "DRAWN", "FACTOR", "POWERS", "READ", "RICCATI_CONVERGES", "RICCATI_CONVERGES_BY", "STEADY_MODEL", "STEADY_WORDS"]

A, S, Y, gain, Pi, P2, turn = symbols("A S Y k_steady Pi P2 turn")
_SHIFT, _UNIT = matrix_of(i, j, n, n, when(j == i + 1, 1, 0)), matrix_of(i, j, n, 1, when(i == 1, 1, 0))
_ONE = Identity(1)
_MODEL = (P == F * P * T(F) + dd * gain * T(gain)) & (g == F * P * h + dd * gain) & (T(h) * P * h + dd == _ONE) & schur(A)
FACTOR = "a D that is positive on the circle has one monic Schur factor"
POWERS = "the powers of a stable matrix tend to zero at a geometric rate"
#: how the formulas are read
READ = ("Positive real data: x(z) is the Schur factor of D, A = J - xh', and P the covariance that a(z), stable, and the factor give. P - S_t, between 0 and A^t P A'^t, tends to zero; so r_t = d + h'(P - S_t)h "
        "tends to d > 0, r_t(q_t - x) = A(P - S_t)h to zero, and r_t q*_t q*_t', the increment of S_t, as well. Of J and h nothing is used, so that it is for every n.")


# ---------------------------------------------------------------------- the stripped algorithm
_GAMMA, _E = T(h) * qs[t], P - S[t]
#: the stripped algorithm from (g + a, g), the sum of r_s q*_s q*_s', and A^t P A'^t
STEADY_WORDS = {
    "sizes": ["n"],
    "over": {J: matrix(n, n), F: matrix(n, n), h: vector(n), a: vector(n), g: vector(n), x: vector(n), P: positive_semidefinite(n), dd: positive()},
    "where": [let(gain, x - a), let(A, J - x * T(h)),
              rec(q, t, g + a, 1 / (1 - _GAMMA**2) * (q[t] - _GAMMA * (J * qs[t]))), rec(qs, t, g, 1 / (1 - _GAMMA**2) * (J * qs[t] - _GAMMA * q[t])),
              rec(r, t, _ONE, (1 - _GAMMA**2) * r[t]), rec(S, t, Zero(n, n), S[t] + r[t] * qs[t] * T(qs[t])), rec(Y, t, P, A * Y[t] * T(A))],
    "given": [standing("(2.22)", (J == _SHIFT) & (h == _UNIT) & (F == J - a * T(h))), given("positive real data", _MODEL)],
}
_GAP, _ABOVE, _LARGE = r[t] * (q[t] - x) == A * _E * h, loewner(P, S[t]), loewner(r[t], dd * _ONE)
_STAYS = [(J - q[t] * T(h)) * _E * T(J - q[t] * T(h)), dd * (q[t] - x) * T(q[t] - x)]
_IN_H = [T(h) * y * h for y in _STAYS]
_ALONG = [symmetric(S[t]), r[t] == 1 - T(h) * S[t] * h, r[t] * (q[t] - a) == g - F * S[t] * h,
          F * S[t] * T(F) + r[t] * (q[t] - a) * T(q[t] - a) == S[t] + r[t] * qs[t] * T(qs[t])]
_FALLS = [A * (Y[t] - _E) * T(A), dd * (q[t] - x) * T(q[t] - x), (q[t] - x) * (r[t] - dd * _ONE) * T(q[t] - x)]
_NO = [[]] * len(_ALONG)
_E_NEXT = P - S[t] - r[t] * qs[t] * T(qs[t])
CONVERGES = (always(t, _GAP & loewner(Y[t], _E)), always(t, ((1 - _GAMMA**2) * r[t] == dd + T(h) * _E_NEXT * h) & (_E_NEXT == _STAYS[0] + _STAYS[1]) & _ABOVE))
#: data after one step of a moving average with the weights 1, x_1, .., x_n, and their P
DRAWN = instances(12, n=(1, 2, 3), horizon=3, using={w: vector(n)}, made_by={
    J: _SHIFT, h: _UNIT, x: w / (2 * (1 + SW)), a: (WEIGHTS - J * WEIGHTS) / (1 - WEIGHTS[1]), g: (J * WEIGHTS - WEIGHTS[1] * WEIGHTS) / (1 - WEIGHTS[1] ** 2),
    F: J - a * T(h), P: (sum_of(k, 0, n - 1, J**k * x * T(x) * T(J) ** k) / XX - WEIGHTS * T(WEIGHTS)) / (1 - WEIGHTS[1] ** 2), dd: 1 - (T(h) * P * h)[1, 1]})
CONVERGES_BY = [
    induction(also=[[*_ALONG, _ABOVE, _LARGE], _ALONG],
              base=[order(*_NO, [P], [T(h) * P * h], [], [0]), order(*_NO, [], [], [P])],
              step=[order(*_NO, _STAYS, _IN_H, [], _FALLS), order(*_NO, [], [], _STAYS)]),
    restated(FACTOR, POWERS), DRAWN, example(n=1, J=[[0]], F=[[0]], h=[1], a=[0], g=["2/5"], x=["1/2"], P=[["1/5"]], d="4/5"),
]

# ---------------------------------------------------------------------- the Riccati equation
_R = 1 - T(h) * Pi[t] * h
_K = (g - F * Pi[t] * h) * inv(_R)
_NOISE = block([[P2 - F * P2 * T(F), g - F * P2 * h], [T(g - F * P2 * h), 1 - T(h) * P2 * h]])
STEADY_MODEL = {
    "sizes": ["n"],
    "over": {F: matrix(n, n), h: vector(n), g: vector(n), gain: vector(n), P: positive_semidefinite(n), dd: positive(), P2: positive_semidefinite(n)},
    "where": [let(A, F - gain * T(h)), rec(Pi, t, Zero(n, n), F * Pi[t] * T(F) + (g - F * Pi[t] * h) * inv(_R) * T(g - F * Pi[t] * h)), rec(Y, t, P, A * Y[t] * T(A))],
    "given": [given("positive real data", _MODEL), given("noise of P_2", psd(_NOISE))],
}
_D = P - Pi[t]
_KEPT = [(F - _K * T(h)) * _D * T(F - _K * T(h)), dd * (_K - gain) * T(_K - gain)]
_KEPT_2 = [(F - _K * T(h)) * (P2 - Pi[t]) * T(F - _K * T(h)), hstack(Identity(n), -_K) * _NOISE * T(hstack(Identity(n), -_K))]
_SHRINKS = [A * (Y[t] - _D) * T(A), dd * (_K - gain) * T(_K - gain), (_K - gain) * (_R - dd * _ONE) * T(_K - gain)]
_IN_H_2, _SYM = [T(h) * y * h for y in _KEPT], symmetric(Pi[t])
_BELOW, _LARGE_2 = loewner(P, Pi[t]), loewner(_R, dd * _ONE)
RICCATI_CONVERGES = (always(t, _BELOW & (_R == dd + T(h) * _D * h)), always(t, loewner(Y[t], _D) & (_R * (_K - gain) == A * _D * h)), always(t, loewner(P2, Pi[t])))
#: P is a multiple of I: F is a rotation, halved in the direction of the gain
_W = w / (4 * (1 + SW))
_SKEW = turn - T(turn)
RICCATI_CONVERGES_BY = [
    induction(also=[[_SYM], [_SYM, _BELOW, _LARGE_2], [_SYM]], base=[order([], [P], []), order([], [P], [T(h) * P * h], [0], []), order([], [P2])],
              step=[order([], _KEPT, []), order([], _KEPT, _IN_H_2, _SHRINKS, []), order([], _KEPT_2)]),
    restated(FACTOR, POWERS),
    instances(12, n=(1, 2, 3), horizon=3, using={w: vector(n), turn: matrix(n, n)}, made_by={
        gain: _W, F: (Identity(n) - _W * T(_W) / (2 * (T(_W) * _W)[1, 1])) * (Identity(n) - _SKEW) * inv(Identity(n) + _SKEW),
        P: (T(_W) * _W)[1, 1] / (3 * _ONE[1, 1] / 4 + (T(_W) * _W)[1, 1] * (T(h) * h)[1, 1]) * Identity(n), dd: 1 - (T(h) * P * h)[1, 1], g: F * P * h + dd * gain, P2: P}),
    example(n=1, F=[[0]], h=[1], g=["2/5"], k_steady=["1/2"], P=[["1/5"]], d="4/5", P2=[["1/2"]]),
    example(n=1, F=[["1/2"]], h=[1], g=["-7/31"], k_steady=["-1/3"], P=[["4/31"]], d="27/31", P2=[["1/4"]]),
]
