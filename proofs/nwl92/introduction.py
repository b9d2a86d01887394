# SPDX-License-Identifier: MIT
"""Section I: the model, and what future dynamics may add.

E_(k+1) x(k+1) = A_k x(k) + u(k) with measurements y(k+1) = C_(k+1) x(k+1) + r(k),
where equations, states and measurements may change in number with k. An
estimate of x(k) from data up to k, xh = x(k) + nu, may be corrected by the
equation 0 = E x(k+1) - A x(k) - u(k), in which x(k+1) is unknown. If E = I, or
has full row rank, it does not change; if E = 0, the equation is a measurement
of Ax(k), and it does unless A or the covariance of nu is zero.
"""

from __future__ import annotations

from exactkf.claims import claim, not_checked
from exactkf.evidence import example, instances, order, part
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    given,
    inv,
    matrix,
    positive_definite,
    positive_semidefinite,
    sym,
    symbols,
    vector,
    vstack,
)

DEFINITION = "a definition: it fixes notation and asserts nothing"
not_checked("NWL92-E1.1", "the descriptor dynamics", DEFINITION)
not_checked("NWL92-E1.2", "the measurements", DEFINITION)
not_checked("NWL92-E1.3", "the covariance of the noises", DEFINITION)

n = sym("n")
A, P, Q, xh, xa, xb, la, lb, y1, y2 = symbols("A P Q xh xa xb la lb y1 y2")
#: conditions (2.9) for xh = xa + nu and 0 = E xb - A xa - u, with E = I and with E = 0
WITH_I = block([[P, Zero(n, n), Identity(n), Zero(n, n)], [Zero(n, n), Q, -A, Identity(n)], [Identity(n), -T(A), Zero(n, n), Zero(n, n)],
                [Zero(n, n), Identity(n), Zero(n, n), Zero(n, n)]])
WITH_0 = block([[P, Zero(n, n), Identity(n)], [Zero(n, n), Q, -A], [Identity(n), -T(A), Zero(n, n)]])
claim("NWL92-S1", "with E = I an equation of the future does not change the estimate, with E = 0 it does",
      (xa == xh) & (xh - y1 == P * T(A) * inv(A * P * T(A) + Q) * A * xh), sizes=["n"],
      over={A: matrix(n, n), P: positive_semidefinite(n), Q: positive_definite(n), xh: vector(n), xa: vector(n), xb: vector(n), la: vector(n), lb: vector(n), y1: vector(n),
            y2: vector(n), sym("l1"): vector(n)},
      given=[given("E = I", WITH_I * vstack(la, lb, xa, xb) == vstack(xh, Zero(n, 1), Zero(n, 1), Zero(n, 1))),
             given("E = 0", WITH_0 * vstack(sym("l1"), y2, y1) == vstack(xh, Zero(n, 1), Zero(n, 1)))],
      by=[part("one equation of the future, with E = I and with E = 0, and nonsingular Q"), order([], [], lemmas=[y2 == inv(A * P * T(A) + Q) * A * xh]),
          example({"n": 1, A: [[1]], P: [[1]], Q: [[1]], xh: [2], xa: [0], xb: [0], la: [0], lb: [0], sym("l1"): [1], y2: [1], y1: [1]}),
          example({"n": 1, A: [[1]], P: [[1]], Q: [[1]], xh: [2], xa: [2], xb: [2], la: [0], lb: [0], sym("l1"): [1], y2: [1], y1: [0]}),
          instances(made_by={xa: xh, xb: A * xh, la: Zero(n, 1), lb: Zero(n, 1), y2: inv(A * P * T(A) + Q) * A * xh, sym("l1"): T(A) * y2, y1: xh - P * T(A) * y2},
                    n=(1, 2))],
      note=("One future equation and square A. xh is the estimate from data up to k, xa that with the equation where E = I, y1 where E = 0; xb, la, lb, l1, y2 are the "
            "unknown next state and multipliers. The correction on the right is zero only in special cases, as for PA' = 0. More equations: NWL92-S51."))
