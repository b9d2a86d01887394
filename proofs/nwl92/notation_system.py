# SPDX-License-Identifier: MIT
"""Shared notation of sections III to VI and appendix B: the descriptor system and its 3-block matrix.

The system is E x(k+1) = A x(k) + u(k), y(k+1) = C x(k+1) + r(k), with
covariance [Q, S; S', R] >= 0 of (u, r). An estimate of x(k) with error
covariance P turns both into one measurement of x(k+1) with matrix (E; C) and
noise covariance

    N = [APA' + Q, -S; -S', R] = J [Q, S; S', R] J + (A; 0) P (A; 0)',    J = diag(I, -I),

because the noise of the first part is A nu - u. The 3-block matrix is the
2-block matrix of this measurement. A (1)-inverse of it has the blocks W1, W2,
W3 (in the place of N), U1, U2 (in the place of (E; C)) and T; the gains are
L = U1' and K = U2'.

For every size the two identities that all uses of the 3-block matrix rest on,
LE + KC = I and N(U1; U2) + (E; C)T = 0, follow as in `block_identities`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from exactkf.evidence import Evidence, example, instances, order, within
from exactkf.language import (
    Expr,
    Identity,
    T,
    Zero,
    block,
    detectable,
    given,
    hstack,
    inv,
    invertible,
    kernel_basis,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_semidefinite,
    psd,
    schur,
    sequence,
    standing,
    sym,
    symbols,
    symmetric_matrix,
    trace,
    vstack,
    when,
)
from proofs.nwl92.notation import any_one_inverse, identities_at_once, lower, one_inverse, upper

# sizes: l equations, p measurements, m states before, n states after
l, p, m, n, k = symbols("l p m n k")
A, P, Q, S, R, E, C, L, K = symbols("A P Q S R E C L K")
Om, Oi, G0, Y0, Y2 = symbols("Om Oi G0 Y0 Y2")

Blocks = tuple[Expr, Expr, Expr, Expr, Expr, Expr]
#: blocks W1, W2, W3, U1, U2, T of a (1)-inverse of the 3-block matrix, and of a second one
INVERSE: Blocks = (sym("W1"), sym("W2"), sym("W3"), sym("U1"), sym("U2"), sym("T"))
OTHER_INVERSE: Blocks = (sym("V1"), sym("V2"), sym("V3"), sym("X1"), sym("X2"), sym("T2"))
U1, U2, Tb = INVERSE[3:]

COVARIANCE = block([[Q, S], [T(S), R]])
#: covariance of (-u, r)
NOISE_G = block([[Q, -S], [-T(S), R]])
F_BLOCK = vstack(E, C)
#: the rows (0 0 I) and the columns (I 0; 0 I; 0 0) of the print
LAST = hstack(Zero(n, l), Zero(n, p), Identity(n))
FIRST_TWO = block([[Identity(l), Zero(l, p)], [Zero(p, l), Identity(p)], [Zero(n, l), Zero(n, p)]])
BOTTOM = vstack(Zero(l, n), Zero(p, n), Identity(n))

SYSTEM = {A: matrix(l, n), Q: symmetric_matrix(l), S: matrix(l, p), R: symmetric_matrix(p), E: matrix(l, n), C: matrix(p, n)}
#: the same with m states before
VARYING = {**SYSTEM, A: matrix(l, m)}
NOISE = standing("(4.3)", psd(COVARIANCE))
GRAM = T(E) * E + T(C) * C
RANK = given("(E; C) has full column rank", invertible(GRAM))
IMPLIED_RANK = standing("(E; C) has full column rank", invertible(GRAM))


def noise(P: Expr) -> Expr:
    """Covariance of (A nu - u, r), where nu has covariance P."""
    return block([[A * P * T(A) + Q, -S], [-T(S), R]])


def three_block(P: Expr) -> Expr:
    """The 3-block matrix of the filter, as printed."""
    return block([[A * P * T(A) + Q, -S, E], [-T(S), R, C], [T(E), T(C), Zero(n, n)]])


def inverse_blocks(names: Blocks = INVERSE) -> Expr:
    """The symmetric matrix that these blocks form."""
    W1, W2, W3, U1, U2, T0 = names
    return block([[W1, W2, U1], [T(W2), W3, U2], [T(U1), T(U2), T0]])


def block_types(names: Blocks = INVERSE) -> dict:
    """Types of the blocks."""
    sizes = (symmetric_matrix(l), matrix(l, p), symmetric_matrix(p), matrix(l, n), matrix(p, n), symmetric_matrix(n))
    return dict(zip(names, sizes, strict=True))


OMEGA = let(Om, three_block(P))
OMEGA_INVERSE = let(Oi, inverse_blocks())
ONE_INVERSE = given("(2.20)", Om * Oi * Om == Om)
#: gains of (3.4) written as in (4.29)
GAINS = (let(L, LAST * Oi * vstack(Identity(l), Zero(p, l), Zero(n, l))), let(K, LAST * Oi * vstack(Zero(l, p), Identity(p), Zero(n, p))))
#: one step of the filter from an estimate with error covariance P
STEP = {**SYSTEM, P: positive_semidefinite(n), **block_types()}
STEP_VARYING = {**VARYING, P: positive_semidefinite(m), **block_types()}
STEP_GIVEN = [ONE_INVERSE, NOISE, RANK]


# ------------------------------------------------------------------ every size at once
def noise_by_form(P: Expr, m: Any) -> Expr:
    """`noise` as a sum that is semidefinite by its form."""
    J, before = block([[Identity(l), Zero(l, p)], [Zero(p, l), -Identity(p)]]), vstack(A, Zero(p, m))
    return J * COVARIANCE * J + before * P * T(before)


def filter_identities(*sums: list, of: Sequence[tuple[Expr, Blocks]] = ((P, INVERSE),), before: Any = n, then: Sequence[Expr] = ()) -> Evidence:
    """The conclusion for every size, from LE + KC = I and N(U1; U2) + (E; C)T = 0 for each covariance and (1)-inverse, and equations that follow."""
    lemmas, needs, inside = identities_of(of, before)
    return order(*needs, *([] for _ in then), *sums, lemmas=[*lemmas, *then], inside=inside)


def identities_of(of: Sequence[tuple[Expr, Blocks]], before: Any) -> tuple[list, list, list]:
    """The two identities for each covariance and (1)-inverse: lemmas, what these need, and what belongs to each of them."""
    lemmas, needs, inside = [], [], []
    for number, (covariance, (W1, W2, W3, U1, U2, T0)) in enumerate(of):
        both, inner, most = identities_at_once(noise_by_form(covariance, before), F_BLOCK, block([[W1, W2], [T(W2), W3]]), vstack(U1, U2), T0,
                                               n, l + p, GRAM)
        lemmas.append(both)
        needs += most
        inside.append(within(number, *inner))
    return lemmas, needs, inside


# ------------------------------------------------------------------ instances
#: Q, S, R of a random covariance, possibly singular
RANDOM_NOISE = {Q: T(upper(l, p)) * G0 * upper(l, p), S: T(upper(l, p)) * G0 * lower(l, p), R: T(lower(l, p)) * G0 * lower(l, p)}
RANDOM_NOISE_FREE = {G0: positive_semidefinite(l + p)}
SIZES = {"l": (1, 2), "p": (1, 2), "n": (1, 2)}


def made_blocks(Z: Expr, names: Blocks = INVERSE, free: Expr = Y0) -> tuple[dict, dict]:
    """What `instances` needs so that the named blocks form a random symmetric (1)-inverse of Z: made_by and using."""
    kernel, whole = sym(f"ker{free.tree[1]}"), sym(f"all{free.tree[1]}")
    a, b, c = vstack(Identity(l), Zero(p + n, l)), vstack(Zero(l, p), Identity(p), Zero(n, p)), lower(l + p, n)
    parts = [T(x) * whole * y for x, y in ((a, a), (a, b), (b, b), (a, c), (b, c), (c, c))]
    return ({kernel: kernel_basis(Z), whole: any_one_inverse(Z, free, kernel), **dict(zip(names, parts, strict=True))},
            {free: matrix(l + p + n, l + p + n)})


def drawn(count: int = 16, *, before: dict | None = None, made_by: dict | None = None, using: dict | None = None, noise: bool = True,
          **sizes: Any) -> Evidence:
    """Random systems with a random (1)-inverse of the 3-block matrix; ``before`` computes variables first."""
    made, free = made_blocks(Om)
    return instances(count, made_by={**(RANDOM_NOISE if noise else {}), **(before or {}), **made, **(made_by or {})},
                     using={**(RANDOM_NOISE_FREE if noise else {}), **free, **(using or {})}, **{**SIZES, **sizes})


B0, X0, B1, M0, V0, Y1 = symbols("B0 X0 B1 M0 V0 Y1")
_contraction, _first, _second, _frame, _inner = symbols("k0 k1 k2 V N")


def solved(similar: Expr | None = None) -> tuple[dict, dict]:
    """Systems for which a given P solves the algebraic Riccati equation, with l >= n: made_by and using.

    In coordinates in which (E; C) is [I; 0] and N is diag(P, *), the covariance of the noise is what k P k' leaves,
    k = [k1; k2], where k1 is a contraction in the norm of P. The frame V that leads back is drawn so that its last p
    rows annihilate k; then Vk = [A; 0]. ``similar`` is a contraction that LA is to be similar to.
    """
    r = l + p - n
    k1, k2, V, N = _first, _second, _frame, _inner
    whole = V * N * T(V)
    made = {P: B0 * T(B0), _contraction: X0 * (1 / (1 + trace(X0 * T(X0)))) if similar is None else similar, k1: B0 * _contraction * inv(B0),
            V: vstack(V0, Y1 * T(kernel_basis(T(vstack(k1, k2))))),
            N: block([[P - k1 * P * T(k1), -k1 * P * T(k2)],
                      [-k2 * P * T(k1), k2 * P * T(k1) * one_inverse(P - k1 * P * T(k1)) * k1 * P * T(k2) + M0]]),
            E: T(upper(l, p)) * V * upper(n, r), C: T(lower(l, p)) * V * upper(n, r), A: V0 * vstack(k1, k2),
            Q: T(upper(l, p)) * whole * upper(l, p), S: -T(upper(l, p)) * whole * lower(l, p), R: T(lower(l, p)) * whole * lower(l, p)}
    using = {B0: nonsingular(n), X0: matrix(n, n), k2: matrix(r, n), M0: positive_semidefinite(r), V0: matrix(l, l + p), Y1: matrix(p, r)}
    return made, using


def solutions(count: int = 16, *, similar: Expr | None = None, before: dict | None = None, made_by: dict | None = None,
              using: dict | None = None, **sizes: Any) -> Evidence:
    """Systems with a solution P of the algebraic Riccati equation and a random (1)-inverse of their 3-block matrix."""
    made, free = solved(similar)
    return drawn(count, before={**(before or {}), **made}, made_by=made_by, using={**free, **(using or {})}, noise=False, **{"l": (1, 2, 3), **sizes})


# ------------------------------------------------------------------ detectable and stabilizable systems
Le, Lc, Na, Nb, Ma, Mb, Mc, Md, H0 = symbols("Le Lc Na Nb Ma Mb Mc Md H0")
#: stabilizability, said in the same way for the transposed matrices
STABILIZER = {Na: matrix(n, l), Nb: matrix(n, p), Ma: matrix(l, l), Mb: matrix(l, p), Mc: matrix(p, l), Md: matrix(p, p)}
STABILIZABLE_FORMULA = (F_BLOCK * hstack(Na, Nb) + NOISE_G * block([[Ma, Mb], [Mc, Md]])
                        == block([[Identity(l), Zero(l, p)], [Zero(p, l), Identity(p)]])) & schur(A * Na)
STABILIZABLE = given("stabilizable", STABILIZABLE_FORMULA)
#: Definition 4.1: sF - tK has full column rank, (sF - tK, G) full row rank, for all (s, t) other than (0, 0) with |s| >= |t|
K_BLOCK = vstack(A, Zero(p, n))
DETECTABLE_PENCIL = F_BLOCK, K_BLOCK
STABILIZABLE_PENCIL = T(hstack(F_BLOCK, NOISE_G)), T(hstack(K_BLOCK, 0 * NOISE_G))
STABILIZABLE_PAIR = given("stabilizable", detectable(*STABILIZABLE_PENCIL))
CERTIFICATES = ("Detectability is said as in Lemma 4.1: (E; C) has a left inverse (Le Lc) with stable Le A; the converse is plain, as "
                "(E - tA)x = 0 and Cx = 0 give x = t Le A x. Stabilizability is the same for the transposed matrices.")


# ------------------------------------------------------------------ two solutions of one Riccati equation
Pa, Pb, Oma, Omb, Oia, Oib = symbols("Pa Pb Oma Omb Oia Oib")
La, Ka, Lb, Kb = symbols("La Ka Lb Kb")
_ROW_L, _ROW_K = vstack(Identity(l), Zero(p, l), Zero(n, l)), vstack(Zero(l, p), Identity(p), Zero(n, p))
TWO_OVER = {**SYSTEM, Pa: positive_semidefinite(n), Pb: positive_semidefinite(n), **block_types(), **block_types(OTHER_INVERSE)}
TWO_LETS = [let(Oma, three_block(Pa)), let(Oia, inverse_blocks()), let(Omb, three_block(Pb)), let(Oib, inverse_blocks(OTHER_INVERSE))]
TWO_GAINS = [let(La, LAST * Oia * _ROW_L), let(Ka, LAST * Oia * _ROW_K), let(Lb, LAST * Oib * _ROW_L), let(Kb, LAST * Oib * _ROW_K)]
TWO_INVERSES = [given("(2.20) for P1", Oma * Oia * Oma == Oma), given("(2.20) for P2", Omb * Oib * Omb == Omb)]
TWO_STANDING = [standing("(2.20) for P1", Oma * Oia * Oma == Oma), standing("(2.20) for P2", Omb * Oib * Omb == Omb)]
TWO_IDENTITIES = ((Pa, INVERSE), (Pb, OTHER_INVERSE))


def riccati(P: Expr, L: Expr, K: Expr) -> Expr:
    """P solves (4.31) with the gains L, K."""
    return P == (L * A) * P * T(L * A) + hstack(L, K) * NOISE_G * vstack(T(L), T(K))


_i, _j, _a, _t = symbols("ii jj av tv")
_T1, _T2, _Y, _X = symbols("F1 F2 F3 F4")


def two_solutions(count: int = 16, **sizes: Any) -> Evidence:
    """Systems with two solutions, with random (1)-inverses; l, p >= n.

    Uncoupled states x+ = a x, y = x + r with |a| > 1 have the solutions 0 and 1 - 1/a^2 each; then coordinates of the state
    are changed, rows are combined, and multiples of y are added to the dynamics.
    """
    factor = 1 + _a[_i] * _a[_i]
    both = 1 - 1 / (factor * factor)
    made = {Pa: _X * matrix_of(_i, _j, n, n, when(_i == _j, both, 0)) * T(_X),
            Pb: _X * matrix_of(_i, _j, n, n, when((_i == _j) & (_t[_i] > 0), both, 0)) * T(_X), E: (_T1 + _Y * _T2) * inv(_X), C: _T2 * inv(_X),
            A: _T1 * matrix_of(_i, _j, n, n, when(_i == _j, factor, 0)) * inv(_X), R: _T2 * T(_T2), Q: _Y * R * T(_Y), S: -_Y * R}
    first, free = made_blocks(Oma)
    second, more = made_blocks(Omb, OTHER_INVERSE, Y2)
    return instances(count, made_by={**made, **first, **second},
                     using={_T1: matrix(l, n), _T2: matrix(p, n), _Y: matrix(l, p), _X: nonsingular(n), _a: sequence(1, n),
                            _t: sequence(1, n), **free, **more}, **{"l": (1, 2), "p": (1, 2), "n": 1, **sizes})


#: for n = 1 and n = 2
TWO_DRAWN = (two_solutions(8, l=2, p=2, n=2), two_solutions(12))
#: x+ = x without noise, and a measurement that says nothing: every P is a solution
_IDLE = {"l": 1, "p": 1, "n": 1, A: [[1]], E: [[1]], C: [[0]], Q: [[0]], S: [[0]], R: [[1]], Pa: [[1]], Pb: [[0]],
         **dict(zip(INVERSE, ([[0]], [[0]], [[1]], [[1]], [[0]], [[-1]]), strict=True)),
         **dict(zip(OTHER_INVERSE, ([[0]], [[0]], [[1]], [[1]], [[0]], [[0]]), strict=True))}
#: instances that are not admissible: what (2.20) and (4.31) are for
TWO_FOILS = [example(_IDLE), example({**_IDLE, U1: [[-1]], Tb: [[-5]]}), example({**_IDLE, OTHER_INVERSE[3]: [[-1]], OTHER_INVERSE[5]: [[5]]}),
             example({**_IDLE, A: [[2]], Tb: [[-4]]}),
             example({**_IDLE, A: [[2]], Pa: [[0]], Tb: [[0]], Pb: [[1]], OTHER_INVERSE[5]: [[-4]]})]
