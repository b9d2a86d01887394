# SPDX-License-Identifier: MIT
"""Shared notation of section III: the filtered estimate as the most likely one for all data, and one step of the filter.

All that is known up to time j is a measurement a = F X + V e of the unknowns X of which x(j) = J X is a part (the last
of the states x(0), .., x(j), but J may be any matrix); e has the covariance I, and F full column rank. The filtered
estimate of x(j) is J U0'a with U0 from any symmetric (1)-inverse of [VV', F; F', 0] (Lemma 2.2), the covariance of its
error J U0'V e is P = J U0'VV'U0 J'. Then come E z = A x(j) + u and y = C z + r for z = x(j+1), with (u; r) =
(Nu; Nr) f, where f has the covariance I and is independent of e, so that Q, S, R are Nu Nu', Nu Nr', Nr Nr'.

The filtered estimate of x(j+1) is by definition the z of the most likely (X, z, e, f) among all that satisfy the three
equations, which is the one with the smallest e'e + f'f. The 3-block form gives it: if la, lb, z solve
Om (la; lb; z) = (A xh; y; 0), then

    X = U0'a + T0 J'A'la,    e = V'(W0 a + U0 J'A'la),    f = Nr'lb - Nu'la

satisfy the equations with this z, because xh - P A'la = J X, and for other unknowns X0, z0, e0, f0 that satisfy them

    e'(e0 - e) + f'(f0 - f) = la'A J(X - X0) - la'(E(z0 - z) - A J(X0 - X)) - lb'C(z0 - z) = -(la'E + lb'C)(z0 - z) = 0.

So e0'e0 + f0'f0 = e'e + f'f + |e0 - e|^2 + |f0 - f|^2, and where e0 = e, f0 = f, there X0 = X and z0 = z, as F and (E; C)
have left inverses: X0 - X and z0 - z are combinations of e0 - e and f0 - f.
"""

from __future__ import annotations

from exactkf.evidence import Evidence, example, instances
from exactkf.language import (
    Expr,
    Identity,
    T,
    Zero,
    block,
    given,
    hstack,
    inv,
    invertible,
    kernel_basis,
    let,
    matrix,
    standing,
    symbols,
    symmetric_matrix,
    vector,
    vstack,
)
from proofs.nwl92.notation import any_one_inverse, block_identities, blocks_of, chained, root_identities
from proofs.nwl92.notation_system import (
    BOTTOM,
    F_BLOCK,
    GRAM,
    IMPLIED_RANK,
    INVERSE,
    LAST,
    OMEGA,
    OMEGA_INVERSE,
    ONE_INVERSE,
    U1,
    U2,
    A,
    C,
    E,
    Oi,
    P,
    Q,
    R,
    S,
    Tb,
    block_types,
    l,
    m,
    made_blocks,
    n,
    noise,
    p,
)

# g unknowns and h measurements until j, q and s sources of noise before and after
g, h, q, s = symbols("g h q s")
F, J, V, Nu, Nr, W0, U0, T0, Zp, Zi = symbols("F J V Nu Nr W0 U0 T0 Zp Zi")
#: the true unknowns and noises, the most likely ones, data, multipliers
X0, z0, e0, f0, X, z, e, f, a, xh, y, la, lb, wh, z1, e1, f1 = symbols("X0 z0 e0 f0 X z e f a xh y la lb wh z1 e1 f1")

SIZES = ["l", "m", "n", "p", "g", "h", "q", "s"]
OVER = {F: matrix(h, g), V: matrix(h, q), J: matrix(m, g), W0: symmetric_matrix(h), U0: matrix(h, g), T0: symmetric_matrix(g),
        A: matrix(l, m), E: matrix(l, n), C: matrix(p, n), Nu: matrix(l, s), Nr: matrix(p, s), **block_types(),
        X0: vector(g), z0: vector(n), e0: vector(q), f0: vector(s)}
BEFORE = V * T(V)
DATA = vstack(A * xh, y, Zero(n, 1))
LETS = [let(Zp, block([[BEFORE, F], [T(F), Zero(g, g)]])), let(Zi, block([[W0, U0], [T(U0), T0]])), let(a, F * X0 + V * e0),
        let(xh, J * T(U0) * a), let(P, J * T(U0) * BEFORE * U0 * T(J)), let(Q, Nu * T(Nu)), let(S, Nu * T(Nr)), let(R, Nr * T(Nr)),
        let(y, C * z0 + Nr * f0), OMEGA, OMEGA_INVERSE, let(z, LAST * Oi * DATA)]
MULTIPLIERS = [let(la, hstack(Identity(l), Zero(l, p), Zero(l, n)) * Oi * DATA), let(lb, hstack(Zero(p, l), Identity(p), Zero(p, n)) * Oi * DATA)]
LIKELIEST = [*MULTIPLIERS, let(X, T(U0) * a + T0 * T(J) * T(A) * la), let(e, T(V) * (W0 * a + U0 * T(J) * T(A) * la)),
             let(f, T(Nr) * lb - T(Nu) * la)]
GIVEN = [given("(2.20) for the data until j", Zp * Zi * Zp == Zp), standing("F has full column rank", invertible(T(F) * F)), ONE_INVERSE, IMPLIED_RANK,
         given("(1.1)", E * z0 == A * (J * X0) + Nu * f0)]

#: (X, z, e, f) satisfy all equations, have the smallest e'e + f'f, and z is the only one
FILTERED = ((a == F * X + V * e) & (E * z == A * (J * X) + Nu * f) & (y == C * z + Nr * f)
            & (T(e) * e0 + T(f) * f0 == T(e) * e + T(f) * f) & (X0 - X == inv(T(F) * F) * T(F) * V * (e - e0))
            & (z0 - z == inv(GRAM) * (T(E) * (A * (J * (X0 - X)) + Nu * (f0 - f)) + T(C) * Nr * (f - f0))))
FILTER = {"sizes": SIZES, "over": OVER, "where": [*LETS, *LIKELIEST], "given": GIVEN}
#: the error is the gain times the noise of (3.3) and (3.2)
GAIN = hstack(T(U1), T(U2))
ERROR = z - z0 == GAIN * vstack(A * (xh - J * X0) - Nu * f0, Nr * f0)


def filtered_with(sign: int) -> Expr:
    """z is the filtered estimate, and the covariance of its error is the printed block of the (1)-inverse with this sign."""
    return FILTERED & ERROR & (GAIN * noise(P) * T(GAIN) == sign * (LAST * Oi * BOTTOM))


#: what multiplies (e; f) in the noise (A(xh - x(j)) - u; r) of (3.3) and (3.2)
ROOT = block([[A * J * T(U0) * V, -Nu], [Zero(p, q), Nr]])
_W = block([[INVERSE[0], INVERSE[1]], [T(INVERSE[1]), INVERSE[2]]])
#: left sides of (3.3) and (3.2)
OBSERVED = vstack(A * xh, y)


def filter_proof(*sums: list) -> Evidence:
    """The conclusion for every size, by Lemma 2.2 for the data until j and for the step."""
    both = [OBSERVED == F_BLOCK * z0 + ROOT * vstack(e0, f0), OBSERVED == F_BLOCK * z + ROOT * T(ROOT) * vstack(la, lb), T(E) * la + T(C) * lb == Zero(n, 1),
            J * T(U0) * BEFORE * U0 * T(J) == -J * T0 * T(J)]
    return chained(block_identities(BEFORE, F, W0, U0, T0, g, h), root_identities(BEFORE, V, F, W0, U0, h),
                   block_identities(ROOT * T(ROOT), F_BLOCK, _W, vstack(U1, U2), Tb, n, l + p, GRAM),
                   root_identities(ROOT * T(ROOT), ROOT, F_BLOCK, _W, vstack(U1, U2), l + p), (both, [[] for _ in both]), sums=sums)


# ------------------------------------------------------------------ instances
E0, Yp, Y0, _kernel, _whole = symbols("E0 Yp Y0 kerp allp")
_STEP, _FREE = made_blocks(block([[noise(P), F_BLOCK], [T(F_BLOCK), Zero(n, n)]]), free=Y0)
_MADE = {E: E0 + (A * J * X0 + Nu * f0 - E0 * z0) * T(z0) * (1 / (T(z0) * z0)), _kernel: kernel_basis(Zp), _whole: any_one_inverse(Zp, Yp, _kernel),
         **dict(zip((W0, U0, T0), blocks_of(_whole, h, g), strict=True)), **_STEP}
#: all sizes one: a = X + e, z = X + f, y = 0
ONES = {**dict.fromkeys(SIZES, 1), F: [[1]], V: [[1]], J: [[1]], W0: [[0]], U0: [[1]], T0: [[-1]], A: [[1]], E: [[1]], C: [[0]], Nu: [[1]], Nr: [[0]],
        **dict(zip(INVERSE, ([[0]], [[0]], [[0]], [[1]], [[0]], [[-2]]), strict=True)), X0: [1], z0: [1], e0: [0], f0: [0]}
#: random data that satisfy (1.1), with random (1)-inverses
RANDOM_FILTER = {"made_by": _MADE, "using": {E0: matrix(l, n), Yp: matrix(h + g, h + g), **_FREE},
                 "l": (1, 2), "m": (1, 2), "n": (1, 2), "p": (1, 2), "g": (1, 2), "h": (2,), "q": (1, 2), "s": (1, 2)}
FILTER_DRAWN = instances(8, **RANDOM_FILTER)
#: not admissible: without a hypothesis they show what it is for
UNLIKE = [{**ONES, **change} for change in ({U0: [[2]]}, {U1: [[2]]}, {z0: [2]})]
FOILS = [example(values) for values in UNLIKE]
