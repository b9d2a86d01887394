# SPDX-License-Identifier: MIT
"""Section 5: the equilibria of the fast algorithm, and its derivative there.

The last entry of alpha = A(gamma) alpha gives alpha_n gamma_0 = 0, then the one before it alpha_{n-1} gamma_1 = 0, and so on; with these the last row of
gamma = G(alpha) gamma says gamma_{n-1} = 0, and the other rows that all entries are equal. So the equilibria are the points (alpha, 0).
A(gamma) is the identity up to terms of second order. So near (alpha, 0) a step adds nothing to alpha and multiplies gamma by G(alpha), to first order:
the characteristic polynomial of the derivative is (z - 1)^n alpha(z). There are always n eigenvalues at 1, along the equilibria themselves, and
no equilibrium is hyperbolic in the usual sense.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, identity, induction, instances, steps
from exactkf.language import (
    Identity,
    Z,
    Zero,
    always,
    block,
    charpoly,
    circle_roots,
    column,
    eq,
    forall,
    function,
    given,
    iff,
    inside_roots,
    laurent,
    let,
    matrix,
    matrix_of,
    nonzero,
    outside_roots,
    positive,
    prod,
    rational,
    rec,
    scalar,
    schur,
    standing,
    symbols,
    vector,
    when,
)
from proofs.blz94.notation import COMPANION, ORBIT, A, G, alpha, alpha0, gamma, gamma0, i, j, k, m, monic_of, n, t

c, s, u, v, w, x, y, B, C, mu, f = symbols("c s u v w x y B C mu f")
_POINT = {"sizes": ["n"], "over": {alpha0: vector(n), gamma0: vector(n)}}

# ---------------------------------------------------------------------- the dynamical system
claim("BLZ94-E5.1", "the algorithm is the iteration of f", always(t, (alpha[t + 1] == u(alpha[t], gamma[t])) & (gamma[t + 1] == v(alpha[t], gamma[t]))), **_POINT,
      where=[], by=[])
