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
from proofs.nwl92.notation import any_one_inverse, block_identities, chained, likeliest, root_identities

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
BLOCKS = {F: matrix(g, n), W1: symmetric_matrix(n), W2: matrix(n, g), W3: symmetric_matrix(g), U1: matrix(n, n), U2: matrix(g, n), Tb: symmetric_matrix(n)}
OVER = {P: positive_semidefinite(n), V: positive_semidefinite(g), **BLOCKS}
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
MADE = {KERNEL: kernel_basis(Zm), WHOLE: any_one_inverse(Zm, Y0, KERNEL), **dict(zip((W1, W2, W3, U1, U2, Tb), CORNERS, strict=True)),
        M1: Identity(n) - X2 * F, M2: X2}
FREE = {Y0: matrix(n + g + n, n + g + n), X2: matrix(n, g)}
DRAWN = instances(made_by=MADE, using=FREE, n=(1, 2), g=(1, 2))
UNBIASED = given("M1 xh + M2 0 is unbiased", M1 + M2 * F == Identity(n))
ONES = {"n": 1, "g": 1, F: [[0]], W1: [[0]], W2: [[0]], W3: [[1]], U1: [[1]], U2: [[0]], Tb: [[-1]]}
LARGER = loewner(hstack(M1, M2) * NOISE * vstack(T(M1), T(M2)), BEST * NOISE * T(BEST))
EXCESS = (hstack(M1, M2) - BEST) * BY_FORM * T(hstack(M1, M2) - BEST)
NOTE = ("The identity matrix in the upper right corner is scanned as a small letter. P = RpRp' and V = RvRv' with any square roots; the data are any that (6.25) "
        "allows, with nu = Rp wp and w = Rv wv. Of all (x0, w0) that explain them the adjusted estimate and wh have the smallest w'w, and no other x0 goes with "
        "wh: it is the most likely one. No linear unbiased estimate M1 xh + M2 0 has a smaller error covariance.")
Rp, Rv, p, q, x0, wp, wv, w0, wh, xc, X0 = symbols("Rp Rv p q x0 wp wv w0 wh xc X0")
BOTH_ROWS, ROOT, INNER = vstack(Identity(n), F), block([[Rp, Zero(n, q)], [Zero(g, p), Rv]]), block([[W1, W2], [T(W2), W3]])
DATA = vstack(xh, Zero(g, 1))
ROOTS = root_identities(ROOT * T(ROOT), ROOT, BOTH_ROWS, INNER, vstack(U1, U2), n + g)
SOURCES = [let(P, Rp * T(Rp)), let(V, Rv * T(Rv)), *LETS, let(xh, x0 + Rp * wp), let(w0, vstack(wp, wv)), let(xc, LAST * Zi * vstack(DATA, Zero(n, 1))),
           let(wh, T(ROOT) * INNER * DATA)]
PROVED = chained(block_identities(ROOT * T(ROOT), BOTH_ROWS, INNER, vstack(U1, U2), Tb, n, n + g, Identity(n) + T(F) * F), ROOTS,
                 ([DATA == BOTH_ROWS * xc + ROOT * wh], [[]]), sums=(*([[]] * 5), [EXCESS]))
ONE_DATUM = {**ONES, "p": 1, "q": 1, Rp: [[1]], Rv: [[1]], x0: [1], wp: [0], wv: [0], M1: [[1]], M2: [[0]]}
FOILS = [example({**ONE_DATUM, U1: [[2]]}), example({**ONE_DATUM, M1: [[0]]}), example({**ONE_DATUM, wv: [1]})]
OFF_X0 = 1 / (T(x0) * x0)
DATA_DRAWN = instances(made_by={F: X0 * (Identity(n) - x0 * T(x0) * OFF_X0) - Rv * wv * T(x0) * OFF_X0, **MADE}, using={**FREE, X0: matrix(g, n)},
                       n=(1, 2), g=(1, 2), p=(1, 2), q=(1, 2))
DATA_GIVEN = given("second row of (6.25)", F * x0 + Rv * wv == Zero(g, 1))
claim("NWL92-E6.26", "the adjusted estimate",
      likeliest(xc, wh, DATA, BOTH_ROWS, ROOT, w0) & (x0 - xc == Rp * (T(Rp) * W1 * xh - wp)) & (xc == T(U1) * xh) & (T(U1) + T(U2) * F == Identity(n)) & LARGER,
      sizes=["n", "g", "p", "q"],
      over={Rp: matrix(n, p), Rv: matrix(g, q), **BLOCKS, x0: vector(n), wp: vector(p), wv: vector(q),
            M1: matrix(n, n), M2: matrix(n, g)},
      where=SOURCES, given=[ONE_INVERSE, DATA_GIVEN, UNBIASED],
      by=[restated("past and future together say of x(j) what (6.25) says (NWL92-L2.3, NWL92-E6.3)"), PROVED, *FOILS, DATA_DRAWN], note=NOTE)

claim("NWL92-E6.27", "error covariance of the adjusted estimate",
      BEST * NOISE * T(BEST) == -(LAST * Zi * vstack(Zero(n, n), Zero(g, n), Identity(n))),
      sizes=["n", "g"], over=OVER, where=LETS, given=[ONE_INVERSE], by=[proof(), example({**ONES, P: [[1]], V: [[1]], U1: [[2]]}), DRAWN],
      note="The error of the adjusted estimate is the gain times the noise (nu; w).")
