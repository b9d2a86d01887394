# SPDX-License-Identifier: MIT
"""Section 6: dominant subspaces and the powers of S.

Let MV = VR and MW = WQ. If Z_0 = V + WK_0, then M^t Z_0 = (V + WK_t)R^t with K_t = Q^t K_0 R^(-t). The second factor does not change
the subspace, and K_t tends to zero if the eigenvalues of Q are smaller in modulus than those of R: so powers of M take a subspace that is
complementary to Im W to Im V.

The eigenvalues of S come in pairs. If those on the circle have even multiplicity and S has one Jordan block for each, half of
each block is dominant. Two Lagrangian invariant subspaces with all eigenvalues outside the open disc have solutions P, Q of the Riccati
equation with the same closed loop G; then E = P - Q has Eh = 0 and E = GEG', so that E vanishes on h, G'h, G'^2 h, ....
"""

from exactkf.claims import claim, repair
from exactkf.evidence import evaluation, example, identity, induction, instances, part, restated, steps
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    always,
    block,
    charpoly,
    column,
    forall,
    function,
    given,
    hstack,
    iff,
    inside_roots,
    integer,
    inv,
    kernel_basis,
    let,
    matrix,
    matrix_of,
    monic,
    nonneg_on_circle,
    nonsingular,
    nonzero,
    positive,
    prod,
    rank,
    rational,
    real_roots,
    rec,
    recip,
    rev,
    rows,
    scalar,
    schur,
    standing,
    sum_of,
    symbols,
    symmetric_matrix,
    trace,
    vector,
    vstack,
    when,
)
from proofs.blz94.notation import D, F, J, P, a0, g, h, i, j, k, m, n, t, u
from proofs.blz94.section_6 import BLOCKS, PAIR_A, PAIR_G, PAIR_H, PAIR_P, PAIR_USING, S11, S12, S21, S22, A, S
from proofs.blz94.section_6_subspaces import LOOP, S_OF_LOOP

X, Y, R, U, V, K, L, N, Q, W, M, E, B, H, Gamma, Lambda, Phi = symbols("X Y R U V K L N Q W M E B H Gamma Lambda Phi")
K0, p, q, r, s, v, w, x, y, z, c, l = symbols("K0 p q r s v w x y z c l")

# ---------------------------------------------------------------------- powers of a matrix, (6.26) and Lemma 6.9
_POWERS = {"sizes": ["l", "k", "m"],
           "over": {M: matrix(l, l), V: matrix(l, k), W: matrix(l, m), R: nonsingular(k), Q: matrix(m, m), K0: matrix(m, k)},
           "where": [rec(H, t, V + W * K0, M * H[t]), rec(K, t, K0, Q * K[t] * inv(R)), rec(Phi, t, Identity(k), R * Phi[t])],
           "given": [given("MV = VR", M * V == V * R), given("MW = WQ", M * W == W * Q)]}
_SPLIT = instances(l=(2, 3), k=(1, 2), m=(1,), using={B: nonsingular(l), L: matrix(l, l)},
                   made_by={V: B * matrix_of(i, j, l, k, when(i == j, 1, 0)), W: B * matrix_of(i, j, l, m, when(i == k + j, 1, 0)),
                            M: B * matrix_of(i, j, l, l, when(j <= k, when(i <= k, R[i, j], 0), when(j <= k + m, when((i > k) & (i <= k + m), Q[i - k, j - k], 0), L[i, j])))
                            * inv(B)})
_MOVED = always(t, H[t] == (V + W * K[t]) * Phi[t])
claim("BLZ94-X.6", "powers of a matrix on a subspace, in terms of two invariant ones", _MOVED, **_POWERS, by=[induction(), _SPLIT],
      note="K_t is Q^t K_0 R^(-t), Phi_t is R^t and H_t is M^t H_0. Not printed: the power method on which Lemma 6.9 rests.")

_FIXED = standing("S(I; 0) = (I; 0)R", S * vstack(Identity(n), Zero(n, n)) == vstack(Identity(n), Zero(n, n)) * R)
claim("BLZ94-E6.26", "convergence of the subspaces as convergence of the matrices",
      S * vstack(Identity(n), Zero(n, n)) == vstack(Identity(n), Zero(n, n)), sizes=["n"], over={**LOOP, R: matrix(n, n)}, where=[S_OF_LOOP],
      given=[_FIXED, standing("Im(I; 0) is dominant", inside_roots(charpoly(R)) == 0)],
      by=[example(n=1, A=[["1/2"]], g=[0], h=[1], R=[[2]]), instances(n=(1,), made_by={A: Identity(n), g: 0 * h, R: Identity(n)})],
      note="A consequence: if Im(I; 0) is the dominant subspace the subspaces do not move, and a limit of the matrices S^t(I; 0) of rank n is "
           "fixed by S. In the example S^t(1; 0) is (2^t; 0).",
      repair=repair("other", "The matrices converge only after multiplication from the right by R^(-t), R the matrix of S on the dominant subspace; Y_tX_t^(-1) does not "
                             "notice that factor.", _MOVED, **_POWERS,
                    by=[induction(), _SPLIT, restated("Q^t K R^(-t) tends to zero if the eigenvalues of Q are smaller in modulus than those of R")]))

_CYCLE = (given("A^4 = I, one real eigenvalue", (M**4 == Identity(3)) & (real_roots(charpoly(M), -2, 2) == 1) & (M * u == u)),
          standing("u is not zero", T(u) * u != 0))
_TURN = rows([[1, 0, 0], [0, 0, -1], [0, 1, 0]])
_SMALL = (function(p, [t], when(trace(T(K[t]) * K[t]) <= x, t, p(t + 1))), let(q, p(0)))
claim("BLZ94-L6.9", "powers of A take complementary subspaces to the dominant one, if it and the codominant one are unique",
      rank(hstack(x, u)) == 1, over={M: matrix(3, 3), u: vector(3), x: vector(3)},
      given=[*_CYCLE, standing("Im x does not meet the plane", (Identity(3) + M + M**2 + M**3) * x != Zero(3, 1))],
      by=[example({M: [[1, 0, 0], [0, 0, -1], [0, 1, 0]], u: [1, 0, 0], x: [1, 1, 0]}),
          instances(made_by={M: _TURN, u: rows([[1], [0], [0]]), x: rows([[1], [0], [0]])})],
      note="A consequence. All eigenvalues have modulus one. The real line spanned by u is the only invariant one, hence the unique dominant subspace of dimension one, and the "
           "plane of i and -i the unique codominant one of dimension two. A sequence of period four converges only if it is constant, so Ax would have to span the line of u.",
      repair=repair("missing hypothesis", "Uniqueness has to be meant for complex subspaces, and A has to be nonsingular. Then there is a gap between the moduli, as here, or "
                                          "else between the exponents (Parlett and Poole). With A = [[0, 1], [0, 0]] both subspaces are the line of (1, 0), but A^2 X = 0.",
                    q >= 0, sizes=["k", "m"],
                    over={R: nonsingular(k), Q: matrix(m, m), K0: matrix(m, k), r: positive(), x: positive()},
                    where=[rec(K, t, K0, Q * K[t] * inv(R)), *_SMALL],
                    given=[standing("moduli above r", schur(r * inv(R))), standing("moduli below r", schur(Q / r))],
                    by=[steps("BLZ94-X.6", facts=["powers of a matrix with all eigenvalues in the open disc tend to zero"],
                              prose="By X.6 the powers take V + WK_0 to the span of V + WK_t, and K_t = (Q/r)^t K_0 (rR^(-1))^t."),
                        instances(20, k=(1, 2), m=(1, 2), using={u: positive()},
                                  made_by={r: 1, x: u / 100, R: matrix_of(i, j, k, k, when(i == j, 3 + i, when(i < j, u, 0))),
                                           Q: matrix_of(i, j, m, m, when(i == j, rational("1/2"), when(i < j, u, 0)))})]))

claim("BLZ94-S47", "intersection of the equimodular parts", 3 - rank(hstack(u, W)) == 1, over={M: matrix(3, 3), u: vector(3), W: matrix(3, 2)},
      given=[*_CYCLE, standing("W spans the plane of i and -i", (M**2 * W == -W) & (rank(W) == 2))],
      by=[example({M: [[1, 0, 0], [0, 0, -1], [0, 1, 0]], u: [1, 0, 0], W: [[0, 0], [1, 0], [0, 1]]})],
      note="The matrix of Lemma 6.9, with q = 1 and r = 2: the unique dominant line and the unique codominant plane meet in zero.",
      repair=repair("missing hypothesis", "It is right where one Jordan block belongs to the modulus: its invariant subspaces of dimension q and r are null spaces of powers.",
                    q + r - rank(hstack(kernel_basis(N**q), kernel_basis(N**r))) == when(q <= r, q, r), sizes=["q", "r"],
                    where=[let(N, matrix_of(i, j, q + r, q + r, when(j == i + 1, 1, 0)))],
                    by=[evaluation(q=range(1, 6), r=range(1, 6)), instances(q=(1, 2, 3), r=(1, 2, 3)),
                        restated("in one Jordan block the invariant subspaces are the null spaces of powers")]))

# ---------------------------------------------------------------------- sign definite D, exponents
_COUNT = sum_of(j, 1, n, when(x[j] == x[i], 1, 0))
claim("BLZ94-S48", "D is sign definite if and only if it has no zero of odd multiplicity on the circle",
      iff(nonneg_on_circle(D) | nonneg_on_circle(-D), p < 1), sizes=["n", "m"],
      over={x: vector(n), w: monic(m), c: nonzero()}, where=[let(D, c * prod(i, 1, n, Z + 1 / Z - 2 * x[i]) * w * recip(w)),
             let(p, sum_of(i, 1, n, when((abs(x[i]) < 1) & (rational(-1) ** _COUNT == -1), 1, 0)))],
      given=[standing("x_i in [-1, 1]", forall(i, 1, n, abs(x[i]) <= 1))],
      by=[steps(facts=["a polynomial has one factorization into linear ones"],
                prose="With z + 1/z = 2 cos(theta), D is c times the product of 2 cos(theta) - 2x_i times a nonnegative number. cos(theta) - x changes its sign at the "
                      "zero exactly if |x| < 1; z + 1/z - 2x has a double zero if x = 1 or -1."),
          instances(20, n=(1, 2, 3), m=(0, 1), using={u: scalar(), v: scalar()},
                    made_by={x: column(i, n, when(i < 3, u / (1 + u**2), v / (1 + v**2)))}),
          instances(20, n=(1, 2, 3), m=(0, 1), using={y: vector(n)}, made_by={x: column(i, n, y[i] / (1 + y[i] ** 2))}),
          example(n=1, m=0, x=[1], w=[1], c=-2), example(n=2, m=0, x=[1, "1/2"], w=[1], c=1), example(n=2, m=1, x=["1/2", "1/2"], w=[1, 1], c=1),
          example(n=2, m=1, x=["-1", "-1"], w=[2, 1], c=1), example(n=3, m=0, x=["1/2", "1/2", "1/3"], w=[1], c=1), example(n=3, m=0, x=["1/2", "1/2", 1], w=[1], c=1)],
      note="p is the number of zeros x_i of odd multiplicity in (-1, 1), each counted that often. Any D that is not zero: its zeros on the circle are those of z + 1/z - 2x with x in [-1, 1], the others come as w(z)w(1/z) and as z + 1/z - 2x with |x| > 1, "
           "which do not vanish on the circle; the latter may be put into the sign of c and are left out.")

_GRADE = (let(N, matrix_of(i, j, p, p, when(j == i + 1, 1, 0))),
          function(u, [m], rank(matrix_of(i, k, p, p, (N ** (k - 1) * column(s, p, when(s == m, 1, 0)))[i]))))
claim("BLZ94-E6.22", "the exponents of the vectors of a Jordan block", forall(m, 1, p, u(m) - 2 * p + 1 == p - 2 * m + 1), sizes=["p"], where=_GRADE,
      by=[example(p=2), instances(p=(1, 2, 3))],
      note="In one Jordan block of size p the smallest invariant subspace that contains the m-th vector has dimension u(m), the largest cyclic one dimension p. The proof of "
           "Lemma 6.10 uses the exponents p - 2m + 1.",
      repair=repair("other", "m and g are exchanged: m is the dimension of the largest cyclic subspace, g that of the smallest invariant subspace that contains the vector.",
                    forall(m, 1, p, p - 2 * u(m) + 1 == p - 2 * m + 1), sizes=["p"], where=_GRADE, by=[evaluation(p=range(1, 9)), instances(p=(1, 2, 3, 4)),
                                                                                                       part("the basis of one Jordan block")]))

_BLOCKS = let(M, matrix_of(i, j, p + q, p + q, when(i == j, when(i <= p, u, v), when((j == i + 1) & (i != p), 1, 0))))
#: exponents of the vectors of two blocks, and the projection onto those that come before a place in the list
_LISTED = (function(w, [i], when(i <= p, p - 2 * i + 1, q - 2 * (i - p) + 1)),
           let(E, matrix_of(i, j, p + q, p + q, when((i == j) & (w(i) > when(i <= p, k, l)), 1, 0))))
claim("BLZ94-S49", "the first vectors span invariant subspaces",
      (M * E == E * M * E) & forall(i, 1, p, w(i) + w(p + 1 - i) == 0) & forall(i, 1, q, w(p + i) + w(p + q + 1 - i) == 0), sizes=["p", "q"],
      over={u: scalar(), v: scalar(), k: integer(-4, 4), l: integer(-4, 4)}, where=[_BLOCKS, *_LISTED],
      by=[steps(prose="The exponents p - 2j + 1 fall along a block, so that v_1, ..., v_k of the list are first vectors of each block. What is left comes later in the list, so its eigenvalues "
                      "are not larger in modulus. More than two blocks are no different."),
          instances(24, p=(1, 2, 3), q=(1, 2, 3))],
      note="Two Jordan blocks, of sizes p and q; w(i) is the exponent of the i-th vector, of (6.22) with m and g exchanged (E6.22), which sum to zero in a block. The first vectors of the list are "
           "those whose exponents exceed a bound: k in the one block and l in the other, equal bounds but for ties if the moduli are equal. The print is over the complex numbers.")

_CHI = charpoly(S)
claim("BLZ94-S50", "eigenvalues of S in pairs; exponents for an eigenvalue of even multiplicity",
      (rev(_CHI, 2 * n) == _CHI) & forall(j, 1, 2 * m, when(j <= m, 2 * m - 2 * j + 1 > 0, 2 * m - 2 * j + 1 < 0)), sizes=["n", "m"], over=LOOP, where=[S_OF_LOOP],
      by=[identity(n=(1, 2), m=range(0, 5)), instances(n=(1, 2, 3), m=(1, 2)),
          restated("in one Jordan block the exponents are those of (6.22) as corrected")],
      note="The characteristic polynomial is its own reversed polynomial, so that eigenvalues come in pairs and their number on the circle is even. 2m is the multiplicity. "
           "The exponents 2m - 2j + 1 are those of E6.22, repaired.")

#: S in a basis of generalized eigenvectors: k eigenvalues u_i outside, a block of size 2q for the eigenvalue x = 1 or -1, the inverses inside
_ORDERED = (let(L, matrix_of(i, j, 2 * q, 2 * q, when(i == j, x, when(j == i + 1, 1, 0)))),
            let(M, matrix_of(i, j, 2 * (k + q), 2 * (k + q), when(i == j, when(i <= k, y[i], when(i <= k + 2 * q, x, 1 / y[i - k - 2 * q])),
                                                                    when((j == i + 1) & (i > k) & (j <= k + 2 * q), 1, 0)))),
            let(E, matrix_of(i, j, 2 * (k + q), k + q, when(j <= q, when(i == k + j, 1, 0), when(i == k + q + j, 1, 0)))),
            let(R, matrix_of(i, j, k + q, k + q, when(i == j, when(i <= q, x, 1 / y[i - q]), when((j == i + 1) & (j <= q), 1, 0)))),
            let(p, prod(i, 1, k, Z - y[i])))
claim("BLZ94-S51", "a basis of the codominant subspace", (M * E == E * R) & (T(E) * E == Identity(k + q)) & (charpoly(M) == charpoly(R) * p * (Z - x) ** q),
      sizes=["k", "q"], over={y: vector(k), x: nonzero()}, where=_ORDERED, given=[standing("y_i is not zero", prod(i, 1, k, y[i]) != 0)],
      by=[identity(k=(0, 1, 2), q=(0, 1, 2)), instances(k=(0, 1, 2), q=(1, 2), made_by={x: 1, y: column(i, k, 2 + i)}),
          part("S in Jordan form, with one real eigenvalue on the circle and simple ones off it")],
      note="n = k + q. The columns of E are v_{n-q+1}, ..., v_n and v_{n+q+1}, ..., v_2n. They span an invariant subspace whose eigenvalues are the 1/y_i and q times x, of "
           "modulus one; those left are the y_i and x, not smaller.")

# ---------------------------------------------------------------------- Lemma 6.10
_GAIN = g - F * P * h
#: a solution of order one, with the limit v, beside a part that h does not see
_ONE = (1 / v - u**2 * v) / (1 - u**2)


def _pair(first, second):
    return matrix_of(i, j, n, n, when(i == j, when(i == 1, first, second), 0))


claim("BLZ94-X.7", "two solutions of the Riccati equation with the same closed loop differ by nothing that h can see",
      always(t, (P - Q) * w[t] == Zero(n, 1)), sizes=["n"],
      over={F: nonsingular(n), g: matrix(n, 1), h: matrix(n, 1), P: symmetric_matrix(n), Q: symmetric_matrix(n), Gamma: nonsingular(n), q: scalar()},
      where=[rec(w, t, h, T(Gamma) * w[t])],
      given=[given("closed loop", Gamma == F - q * _GAIN * T(h)), given("the same gain", F * P * h == F * Q * h),
             given("(6.1) for P", F * P * T(F) - P + q * _GAIN * T(_GAIN) == Zero(n, n)), given("(6.1) for Q", F * Q * T(F) - Q + q * _GAIN * T(_GAIN) == Zero(n, n))],
      by=[induction(),
          instances(n=(2,), using={B: nonsingular(n), u: scalar(), v: nonzero(), x: scalar(), y: scalar()},
                    made_by={F: B * _pair(1, u * (_ONE - v) - _ONE) * inv(B), g: B * column(i, n, when(i == 1, 0, u * (_ONE - v))),
                             h: inv(T(B)) * column(i, n, when(i == 1, 0, 1)), P: B * _pair(x, 1 - _ONE / v) * T(B), Q: B * _pair(y, 1 - _ONE / v) * T(B),
                             q: v / _ONE, Gamma: F - q * _GAIN * T(h)})],
      note="Not printed. If (h, F) is observable, so is the closed loop, h, G'h, G'^2 h, ... span the space and P = Q.")

_OBSERVED = rank(matrix_of(i, j, n, n, (T(h) * A ** (i - 1))[1, j])) == n
_TWO = [given("X is invariant", S * X == X * R), given("Y is invariant", S * Y == Y * Q), standing("dimension of X", rank(X) == n), standing("dimension of Y", rank(Y) == n),
        given("X is dominant", inside_roots(charpoly(R)) == 0), given("Y is dominant", inside_roots(charpoly(Q)) == 0),
        standing("(h, A) is observable", _OBSERVED)]
_EVEN = standing("no eigenvalue of odd multiplicity on the circle",
                 nonneg_on_circle(Z ** (-n) * charpoly(S)) | nonneg_on_circle(-(Z ** (-n) * charpoly(S))))
_DOMINANT = {**LOOP, X: matrix(2 * n, n), R: matrix(n, n), Y: matrix(2 * n, n), Q: matrix(n, n)}
_LOOP_OF_PAIR = inv(T(A)) - inv(T(A)) * h * T(h) * PAIR_P
_SAME = instances(12, n=(2,), using={**PAIR_USING, B: nonsingular(n), N: nonsingular(n)},
                  made_by={A: PAIR_A, g: PAIR_G, h: PAIR_H, X: vstack(inv(T(E)) * B, PAIR_P * inv(T(E)) * B), R: inv(B) * T(E) * _LOOP_OF_PAIR * inv(T(E)) * B,
                           Y: X * N, Q: inv(N) * R * N})
_REST = instances(8, n=(1, 2), using={B: nonsingular(n), N: nonsingular(n), u: scalar()},
                  made_by={A: matrix_of(i, j, n, n, when(i == j, 1 / (1 + i + u**2), 0)), g: 0 * h, X: vstack(B, Zero(n, n)), R: inv(B) * inv(T(A)) * B,
                           Y: vstack(N, Zero(n, n)), Q: inv(N) * inv(T(A)) * N})
claim("BLZ94-L6.10", "the dominant invariant subspace of dimension n is unique", rank(hstack(X, Y)) == n, sizes=["n"], over=_DOMINANT, where=[S_OF_LOOP],
      given=[*_TWO, _EVEN],
      by=[example(n=2, A=[[0, 1], [1, 0]], g=[0, 0], h=[1, 0], X=[[1, 0], [1, "-1/2"], [0, 1], [0, 1]], R=[[1, "-1/2"], [0, 1]],
                  Y=[[1, 0], [-1, "1/2"], [0, 1], [0, -1]], Q=[[-1, "1/2"], [0, -1]]), _REST],
      note="Dominance is that of Lemma 6.9, by moduli. In the example S has the double eigenvalues 1 and -1; the generalized eigenspaces of both are dominant.",
      repair=repair("missing hypothesis", "By moduli alone the subspace is unique only among the Lagrangian ones; otherwise dominance has to be meant in the sense of exponents.",
                    rank(hstack(X, Y)) == n, sizes=["n"], over=_DOMINANT, where=[S_OF_LOOP, let(W, block([[Zero(n, n), Identity(n)], [-Identity(n), Zero(n, n)]]))],
                    given=[*_TWO, standing("X is Lagrangian", T(X) * W * X == Zero(n, n)), standing("Y is Lagrangian", T(Y) * W * Y == Zero(n, n)), _EVEN],
                    by=[steps("BLZ94-E8.8", "BLZ94-E6.33", "BLZ94-X.5", "BLZ94-X.7",
                              facts=["a polynomial has one factorization into linear ones"],
                              prose="By Lemma 6.7 both are graphs, of solutions P and Q of (6.1). By (8.8) and (6.33) their limit polynomials are factors of D with all zeros in the "
                                    "closed disc, hence equal, and so are 1 - h'Ph and 1 - h'Qh and the closed loops; Fh and h see no difference, and X.7 gives P = Q."),
                        _SAME, _REST, example(n=1, A=[["1/2"]], g=[0], h=[1], X=[[1], [0]], R=[[2]], Y=[["4/3"], [1]], Q=[["1/2"]]),
                        example(n=1, A=[["1/2"]], g=[0], h=[1], Y=[[1], [0]], Q=[[2]], X=[["4/3"], [1]], R=[["1/2"]]),
                        example(n=1, A=[["1/2"]], g=[0], h=[1], Y=[[1], [0]], Q=[[2]], X=[[1], [1]], R=[[2]]),
                        example(n=1, A=[["1/2"]], g=[0], h=[1], X=[[1], [0]], R=[[2]], Y=[[1], [1]], Q=[[2]])]))

# ---------------------------------------------------------------------- Lemma 6.11
_GAMMA = J - ((g - F * P * h) / (1 - T(h) * P * h) + a0) * T(h)
claim("BLZ94-L6.11", "the limit of the orbit in terms of the dominant subspace", charpoly(Gamma) == charpoly(inv(Lambda)), sizes=["n"],
      over={J: matrix(n, n), a0: vector(n), g: vector(n), h: vector(n), P: symmetric_matrix(n), X: nonsingular(n), Y: matrix(n, n), Lambda: nonsingular(n)},
      where=[let(F, J - a0 * T(h)), *BLOCKS, let(Gamma, _GAMMA)],
      given=[given("(6.28)", block([[S11, S12], [S21, S22]]) * vstack(X, Y) == vstack(X, Y) * Lambda), given("(6.20)", P * X == Y)],
      by=[steps("BLZ94-E6.16", "BLZ94-E6.29", "BLZ94-E6.33", "BLZ94-X.5", "BLZ94-X.6",
                prose="If no X_t is singular, P_t = Y_tX_t^(-1) by (6.16), which tends to P = YX^(-1) as X is nonsingular by Lemma 6.7; by Lemma 6.1 the orbit tends to the v of "
                      "(6.2). Its polynomial is the characteristic polynomial of J - vh', which by (6.33) has the inverse eigenvalues."),
          instances(n=(2,), using={**PAIR_USING, B: nonsingular(n)},
                    made_by={g: PAIR_G, h: PAIR_H, P: PAIR_P, J: PAIR_A + (g + a0) * T(h), X: inv(T(E)) * B, Y: P * X, Lambda: inv(X) * (S11 + S12 * P) * X}),
          instances(8, n=(1, 2), using={B: nonsingular(n)}, made_by={g: 0 * h, P: 0 * J, X: B, Y: 0 * B, Lambda: inv(X) * S11 * X})],
      note="(6.25): the zeros of the limit polynomial are the inverses of the eigenvalues of S on the dominant subspace Im(X; Y), which are not smaller than one in modulus.")
