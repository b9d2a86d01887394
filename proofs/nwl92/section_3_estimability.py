# SPDX-License-Identifier: MIT
"""Section III, beginning: when x(j) is estimable, and the filter as one measurement at a time.

The prior is a measurement of x(0). x(j) is estimable from it and from dynamics
and measurements up to j if no other choice of the states satisfies the
noise-free equations with the same data, that is if in every sequence with

    x_0 = 0,    E_k x_k = A_(k-1) x_(k-1),    C_k x_k = 0,    k = 1, ..., j,

x_j is zero. If (E_k; C_k) has full column rank for k < j, then x_k = 0 for
these k, and x_j is any null vector of (E_j; C_j). Without the earlier ranks full
column rank of (E_j; C_j) is necessary and not sufficient.

The estimate of x(j) is a measurement xh = x(j) + nu, and with the dynamics and
the measurement at j + 1 this is one measurement of x(j+1) (Lemmas 2.3, 2.4).
"""

from __future__ import annotations

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, induction, instances, order, restated
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    forall,
    given,
    hstack,
    iff,
    inv,
    invertible,
    kernel_basis,
    let,
    matrix,
    positive_semidefinite,
    rank,
    sequence_of,
    symbols,
    vector,
    vstack,
)
from proofs.nwl92.notation_filter import (
    ERROR,
    FILTER,
    FILTER_DRAWN,
    FILTERED,
    FOILS,
    OBSERVED,
    ONES,
    RANDOM_FILTER,
    ROOT,
    UNLIKE,
    e0,
    e1,
    f0,
    f1,
    filter_proof,
    filtered_with,
    la,
    lb,
    q,
    s,
    wh,
    z,
    z0,
    z1,
)
from proofs.nwl92.notation_system import (
    F_BLOCK,
    GRAM,
    NOISE,
    RANDOM_NOISE,
    RANDOM_NOISE_FREE,
    RANK,
    VARYING,
    A,
    C,
    E,
    P,
    Q,
    R,
    S,
    l,
    m,
    n,
    noise,
    p,
)

DEFINITION = "a definition: it fixes notation and asserts nothing"
k, N_STEPS = symbols("k J")
x, x0, nu, xh, u, b, c = symbols("x x0 nu xh u b c")

claim("NWL92-E3.1", "the prior makes x(0) estimable, with the prior mean as estimate and the prior covariance as that of its error",
      (xh - x0 == nu) & (block([[P, Identity(n)], [Identity(n), Zero(n, n)]]) * vstack(Zero(n, 1), xh) == vstack(xh, Zero(n, 1)))
      & (block([[P, Identity(n)], [Identity(n), Zero(n, n)]]) * block([[Zero(n, n), Identity(n)], [Identity(n), -P]]) == Identity(n + n)), sizes=["n"],
      over={P: positive_semidefinite(n), x0: vector(n), nu: vector(n), xh: vector(n)}, given=[given("(3.1)", xh == x0 + nu)],
      by=[order(), example({"n": 1, P: [[1]], x0: [0], nu: [0], xh: [1]}), instances(made_by={xh: x0 + nu}, n=(1, 2))],
      note="xh is the prior mean. The second and third part are (2.9) and the inverse of the matrix of NWL92-E2.10 for H = I and R = P: the estimate is xh.")

# ------------------------------------------------------------------ estimability
Es, Cs, As, xs = symbols("Es Cs As xs")
E1, E2, C1, C2, A0, A1 = symbols("E1 E2 C1 C2 A0 A1")
#: prior and two steps, in x(0) and x(1), and the columns of x(2)
KNOWN = block([[Identity(n), Zero(n, n)], [-A0, E1], [Zero(p, n), C1], [Zero(l, n), -A1], [Zero(p, n), Zero(p, n)]])
NEW = vstack(Zero(n, n), Zero(l, n), Zero(p, n), E2, C2)
NULL = [given("null sequence", forall(k, 1, N_STEPS + 1, Es[k] * xs[k] == As[k] * xs[k - 1])), given("no measurement", forall(k, 1, N_STEPS, Cs[k] * xs[k] == Zero(p, 1))),
        given("prior", xs[0] == Zero(n, 1))]
FULL = given("(E_k; C_k) has full column rank for k <= J", forall(k, 1, N_STEPS, invertible(T(Es[k]) * Es[k] + T(Cs[k]) * Cs[k])))
SEQUENCES = {Es: sequence_of(matrix(l, n), 1, N_STEPS + 1), Cs: sequence_of(matrix(p, n), 1, N_STEPS + 1), As: sequence_of(matrix(l, n), 1, N_STEPS + 1),
             xs: sequence_of(matrix(n, 1), 0, N_STEPS + 1)}
claim("NWL92-S19", "full column rank of (E_j; C_j) is necessary and sufficient for x(j) to be estimable, as printed",
      iff(rank(hstack(KNOWN, NEW)) == rank(KNOWN) + n, rank(vstack(E2, C2)) == n), sizes=["n", "l", "p"],
      over={E1: matrix(l, n), E2: matrix(l, n), C1: matrix(p, n), C2: matrix(p, n), A0: matrix(l, n), A1: matrix(l, n)},
      by=[example({"n": 1, "l": 1, "p": 1, E1: [[0]], C1: [[0]], A0: [[0]], E2: [[1]], C2: [[0]], A1: [[1]]}), instances(n=(1, 2), l=(1, 2), p=1)],
      repair=repair("missing hypothesis", ("the matrices (E_i; C_i) for i < j must have full column rank too: an earlier state that is not estimable leaves x(j) unknown where the "
                                           "dynamics lead from it to x(j)"),
                    forall(k, 0, N_STEPS, (xs[k] == Zero(n, 1)) & (Es[k + 1] * xs[k + 1] == Zero(l, 1))), sizes=["n", "l", "p", "J"],
                    over=SEQUENCES, given=[*NULL, FULL],
                    by=[restated("what is unknown is estimable exactly if it is zero in every solution for zero data"), induction(step=order([inv(T(Es[k + 1]) * Es[k + 1] + T(Cs[k + 1]) * Cs[k + 1])])), example({"n": 1, "l": 1, "p": 1, "J": 1, Es: [[[0]], [[1]]], Cs: [[[0]], [[0]]], As: [[[1]], [[1]]], xs: [[[0]], [[1]], [[1]]]}),
                        example({"n": 1, "l": 1, "p": 1, "J": 1, Es: [[[1]], [[1]]], Cs: [[[0]], [[0]]], As: [[[1]], [[1]]], xs: [[[1]], [[1]], [[1]]]}),
                        example({"n": 1, "l": 1, "p": 1, "J": 1, Es: [[[0]], [[1]]], Cs: [[[1]], [[0]]], As: [[[1]], [[1]]], xs: [[[0]], [[1]], [[1]]]}),
                        example({"n": 1, "l": 1, "p": 1, "J": 1, Es: [[[1]], [[1]]], Cs: [[[0]], [[0]]], As: [[[1]], [[1]]], xs: [[[0]], [[1]], [[1]]]}),
                        example({"n": 1, "l": 1, "p": 1, "J": 1, Es: [[[1]], [[1]]], Cs: [[[0]], [[0]]], As: [[[1]], [[1]]], xs: [[[0]], [[0]], [[1]]]}),
                        instances(8, made_by={xs: (k, Zero(n, 1))}, n=(1, 2), l=(1, 2), p=(1, 2), J=(1, 2))]),
      note=("In the print j = 2, all sizes constant: x(2) is estimable if its columns of the measurement matrix raise the rank by n. In the corrected statement j = J + 1, x_k is a "
            "sequence that satisfies the equations with zero data: all but the last are zero, and the last is a null vector of (E_j; C_j) and any of them; A_k stands for the "
            "paper's A_(k-1)."))

# ------------------------------------------------------------------ one measurement at a time
not_checked("NWL92-E3.2", "the measurement at j + 1", DEFINITION)

claim("NWL92-E3.3", "the estimate of x(j) and the dynamics as a measurement of x(j+1)",
      A * xh == E * x + A * nu - u, sizes=["l", "m", "n"],
      over={A: matrix(l, m), E: matrix(l, n), x0: vector(m), x: vector(n), xh: vector(m), nu: vector(m), u: vector(l)},
      given=[given("(1.1)", E * x == A * x0 + u), given("estimate", xh == x0 + nu)],
      by=[order(), *[example({"l": 1, "m": 1, "n": 1, A: [[1]], E: [[1]], x0: [0], x: [0], nu: [0], u: [0], xh: [0], **change}) for change in ({xh: [1]}, {x: [1]})],
          instances(made_by={u: E * x - A * x0, xh: x0 + nu}, l=(1, 2), m=(1, 2), n=(1, 2))],
      note="x0, x are x(j), x(j+1).")

#: the noise of others
W1 = vstack(e1, f1)
claim("NWL92-L3.1", "the estimate of x(j+1) is that from (3.2) and (3.3)",
      (OBSERVED == F_BLOCK * z + ROOT * wh) & (T(wh) * W1 == T(wh) * wh) & (z1 - z == inv(GRAM) * T(F_BLOCK) * ROOT * (wh - W1))
      & FILTERED & ERROR & (ROOT * T(ROOT) == noise(P)),
      **{**FILTER, "over": {**FILTER["over"], z1: vector(n), e1: vector(q), f1: vector(s)}, "where": [*FILTER["where"], let(wh, T(ROOT) * vstack(la, lb))],
         "given": [*FILTER["given"], given("(3.2) and (3.3) for others", OBSERVED == F_BLOCK * z1 + ROOT * W1)]},
      by=[filter_proof(), *[example({**foil, z1: [1], e1: [0], f1: [0]}) for foil in UNLIKE], example({**ONES, z1: [2], e1: [0], f1: [0]}),
          instances(8, **{**RANDOM_FILTER, "made_by": {**RANDOM_FILTER["made_by"], c: kernel_basis(hstack(F_BLOCK, ROOT)) * T(kernel_basis(hstack(F_BLOCK, ROOT))) * b,
                                                       z1: z0 + hstack(Identity(n), Zero(n, q), Zero(n, s)) * c,
                                                       e1: e0 + hstack(Zero(q, n), Identity(q), Zero(q, s)) * c, f1: f0 + hstack(Zero(s, n), Zero(s, q), Identity(s)) * c},
                          "using": {**RANDOM_FILTER["using"], b: vector(n + q + s), c: vector(n + q + s)}})],
      note=("x(j) is J X for the unknowns X of all earlier equations, which are a = F X + V e; z0, X0, e0, f0 are the true values. The first three parts say that z "
            "is the estimate of x(j+1) from (3.2) and (3.3), whose noise is a multiple of (e; f) with the covariance of (3.5): of all (z1, e1, f1) that satisfy them, "
            "(z, wh) has the smallest sum of squares, and no other z1 goes with wh. Then z is the estimate from all data up to j + 1: with it (X, e, f) have the smallest "
            "e'e + f'f. Its error is the same, whichever way it is found; nu(j) is a multiple of e and so independent of r(j)."))

claim("NWL92-S20", "the 3-block filter follows from Lemma 2.1, as printed",
      rank(hstack(noise(P), F_BLOCK)) == l + p, sizes=["l", "m", "n", "p"], over={**VARYING, P: positive_semidefinite(m)}, given=[NOISE, RANK],
      by=[example({"l": 1, "m": 1, "n": 1, "p": 1, A: [[0]], P: [[0]], Q: [[0]], S: [[0]], R: [[0]], E: [[1]], C: [[1]]}),
          instances(made_by=RANDOM_NOISE, using=RANDOM_NOISE_FREE, l=(1, 2), m=(1, 2), n=(1, 2), p=(1, 2))],
      repair=repair("cross-reference", ("it is Lemma 2.2: Lemma 2.1 says when the 3-block matrix is invertible, and needs [N, (E; C)] of full row rank, which need not hold; its matrix has a "
                                        "(1)-inverse in any case"),
                    filtered_with(-1), **FILTER, by=[filter_proof(), *FOILS, FILTER_DRAWN]),
      note="The left side is the hypothesis of Lemma 2.1 for the measurement (3.2), (3.3) that the theorem does not make. The corrected statement is Theorem 3.1 with its sign put right.")

not_checked("NWL92-Q1", "a connection of two Riccati equations of other papers", "a conjecture about equations of other papers, which are not written down here")
