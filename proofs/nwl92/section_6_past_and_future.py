# SPDX-License-Identifier: MIT
"""Section VI, end: the estimate that takes future dynamics into account.

What past data say about x is the measurement xh = x + nu, where nu has the
error covariance P of the estimate. If future dynamics are equivalent to one
more measurement Fx = w, 0 = Fx - w, with independent w of covariance V, both
together are a measurement of x with the matrix (I; F) and the noise
covariance diag(P, V). The matrix (I; F) has full column rank whatever F is,
so that the last block row of any symmetric (1)-inverse of

    [P, 0, I; 0, V, F; I, F', 0]

gives the adjusted estimate, and minus its last block the error covariance.
"""

from __future__ import annotations

from exactkf.claims import claim, repair
from exactkf.evidence import Evidence, example, instances, order, restated
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    given,
    hstack,
    kernel_basis,
    let,
    loewner,
    matrix,
    positive_semidefinite,
    sym,
    symbols,
    symmetric_matrix,
    vector,
    vstack,
)
from proofs.nwl92 import notation_system as system
from proofs.nwl92.notation import any_one_inverse, block_identities

# ------------------------------------------------------------------ the estimate from past data as a measurement
x, v, r = symbols("x v r")
GAIN = hstack(T(system.U1), T(system.U2))
SMALL = {"l": 1, "p": 1, "n": 1, system.A: [[1]], system.P: [[0]], system.Q: [[1]], system.S: [[0]], system.R: [[1]], system.E: [[1]], system.C: [[0]],
         sym("W1"): [[0]], sym("W2"): [[0]], sym("W3"): [[1]], system.U1: [[1]], system.U2: [[0]], system.Tb: [[-1]], x: [1], v: [0], r: [0]}
claim("NWL92-E6.24", "the estimate from past data is x with an error of covariance P",
      (GAIN * (system.F_BLOCK * x + vstack(v, r)) == x + GAIN * vstack(v, r))
      & (GAIN * system.noise(system.P) * T(GAIN) == -(system.LAST * system.Oi * system.BOTTOM)),
      sizes=["l", "n", "p"], over={**system.STEP, x: vector(system.n), v: vector(system.l), r: vector(system.p)},
      where=[system.OMEGA, system.OMEGA_INVERSE], given=system.STEP_GIVEN,
      by=[system.filter_identities(), example({**SMALL, system.U1: [[2]]}), system.drawn()],
      note="nu is the gain times the noise (v; r) of (3.2) and (3.3); its covariance is the next error covariance of the Riccati recursion.")

# ------------------------------------------------------------------ the adjusted estimate
n, g = symbols("n g")
P, V, F, xh, w, nu = symbols("P V F xh w nu")
PAST, FUTURE = given("(6.24)", xh == x + nu), given("(6.3)", F * x == w)
BOTH = {"sizes": ["n", "g"], "over": {F: matrix(g, n), x: vector(n), xh: vector(n), nu: vector(n), w: vector(g)}}
CONSISTENT = instances(made_by={xh: x + nu, w: F * x}, n=(1, 2), g=(1, 2))
claim("NWL92-E6.25", "past and future as one measurement",
      vstack(xh, Zero(g, 1)) == vstack(Identity(n), F) * x + vstack(nu, w), given=[PAST, FUTURE], **BOTH,
      by=[example({"n": 1, "g": 1, F: [[1]], x: [1], xh: [1], nu: [0], w: [1]}), CONSISTENT],
      repair=repair("sign", "by (6.3) the noise of the second row is -w", vstack(xh, Zero(g, 1)) == vstack(Identity(n), F) * x + vstack(nu, -w),
                    given=[PAST, FUTURE], **BOTH,
                    by=[*[example({"n": 1, "g": 1, F: [[0]], x: [0], nu: [0], **change}) for change in ({xh: [1], w: [0]}, {xh: [0], w: [1]})],
                        CONSISTENT]),
      note="The covariance of -w is that of w, so that (6.26) and (6.27) stand. (3.3) and (6.1) have the sign of u right.")

Zm, Zi, W1, W2, W3, U1, U2, Tb, Y0, M1, M2, X2 = symbols("Zm Zi W1 W2 W3 U1 U2 T Y0 M1 M2 X2")
OVER = {P: positive_semidefinite(n), V: positive_semidefinite(g), F: matrix(g, n), W1: symmetric_matrix(n), W2: matrix(n, g), W3: symmetric_matrix(g),
        U1: matrix(n, n), U2: matrix(g, n), Tb: symmetric_matrix(n)}
LETS = [let(Zm, block([[P, Zero(n, g), Identity(n)], [Zero(g, n), V, F], [Identity(n), T(F), Zero(n, n)]])),
        let(Zi, block([[W1, W2, U1], [T(W2), W3, U2], [T(U1), T(U2), Tb]]))]
ONE_INVERSE = given("(2.20)", Zm * Zi * Zm == Zm)
LAST = hstack(Zero(n, n), Zero(n, g), Identity(n))
NOISE = block([[P, Zero(n, g)], [Zero(g, n), V]])
BEST = hstack(T(U1), T(U2))
FIRST, SECOND = vstack(Identity(n), Zero(g, n)), vstack(Zero(n, g), Identity(g))
BY_FORM = FIRST * P * T(FIRST) + SECOND * V * T(SECOND)


def proof(*sums: list) -> Evidence:
    """The conclusion for every size."""
    lemmas, needs = block_identities(BY_FORM, vstack(Identity(n), F), block([[W1, W2], [T(W2), W3]]), vstack(U1, U2), Tb, n, n + g,
                                     Identity(n) + T(F) * F)
    return order(*needs, *sums, lemmas=lemmas)


KERNEL, WHOLE = symbols("ker all")
PARTS = [vstack(Identity(n), Zero(g + n, n)), vstack(Zero(n, g), Identity(g), Zero(n, g)), vstack(Zero(n + g, n), Identity(n))]
CORNERS = [T(PARTS[i]) * WHOLE * PARTS[j] for i, j in ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2))]
DRAWN = instances(made_by={KERNEL: kernel_basis(Zm), WHOLE: any_one_inverse(Zm, Y0, KERNEL), **dict(zip((W1, W2, W3, U1, U2, Tb), CORNERS, strict=True)),
                           M1: Identity(n) - X2 * F, M2: X2},
                  using={Y0: matrix(n + g + n, n + g + n), X2: matrix(n, g)}, n=(1, 2), g=(1, 2))
UNBIASED = given("M1 xh + M2 0 is unbiased", M1 + M2 * F == Identity(n))
ONES = {"n": 1, "g": 1, P: [[1]], V: [[1]], F: [[0]], xh: [1], W1: [[0]], W2: [[0]], W3: [[1]], U1: [[1]], U2: [[0]], Tb: [[-1]], M1: [[1]], M2: [[0]]}
FOILS = [example({**ONES, U1: [[2]]}), example({**ONES, M1: [[0]]})]
LARGER = loewner(hstack(M1, M2) * NOISE * vstack(T(M1), T(M2)), BEST * NOISE * T(BEST))
EXCESS = (hstack(M1, M2) - BEST) * BY_FORM * T(hstack(M1, M2) - BEST)
NOTE = ("The identity matrix in the upper right corner is scanned as a small letter. No linear unbiased estimate M1 xh + M2 0 has a smaller error "
        "covariance; that (6.3) holds all that future dynamics say is the compatibility assumption (6.20).")
claim("NWL92-E6.26", "the adjusted estimate",
      (LAST * Zi * vstack(xh, Zero(g, 1), Zero(n, 1)) == T(U1) * xh) & (T(U1) + T(U2) * F == Identity(n)) & LARGER,
      sizes=["n", "g"], over={**OVER, xh: vector(n), M1: matrix(n, n), M2: matrix(n, g)}, where=LETS, given=[ONE_INVERSE, UNBIASED],
      by=[restated("the best linear unbiased estimate is the maximum likelihood estimate", "future dynamics say what (6.3) says (NWL92-E6.3)"), proof([], [], [EXCESS]), *FOILS, DRAWN], note=NOTE)

claim("NWL92-E6.27", "error covariance of the adjusted estimate",
      BEST * NOISE * T(BEST) == -(LAST * Zi * vstack(Zero(n, n), Zero(g, n), Identity(n))),
      sizes=["n", "g"], over=OVER, where=LETS, given=[ONE_INVERSE], by=[proof(), example({**ONES, U1: [[2]]}), DRAWN],
      note="The error of the adjusted estimate is the gain times the noise (nu; w).")
