# SPDX-License-Identifier: MIT
"""Section V: the pencil of the algebraic Riccati equation.

With F = (E; C), K = (A; 0), G = [Q, -S; -S', R] >= 0 the Riccati equation is
P = -(0 I)[KPK' + G, F; F', 0]^-1 (0; I), and it belongs to the pencil
M - zN, M = [F, -G; 0, K'], N = [K, 0; 0, F'].

On the unit circle M + zN is invertible. With Gam = F + zK its second block
row is z Gam*, as 1/z is the conjugate of z. From Gam u = Gv and Gam* v = 0 follows
v*Gv = v*Gam u = 0, so Gv = 0; Gam has full column rank, so u = 0; and
v*[Gam, G] = 0 with full row rank of [Gam, G] gives v = 0.

The determinant p(s, t) of sM + tN satisfies t^(k-n) p(s, t) = s^(k-n) p(t, s),
k the number of rows of F, so that eigenmodes come in pairs z, 1/z, except for
k - n more at infinity than at zero: exactly n of them are stable.

If the columns of (X; Y) span the stable eigenspace, M(X; Y) = N(X; Y)J, then
Y'FX = Y'GY + J'Y'FXJ is positive semidefinite. F'Y is invertible: F'Yw = 0
gives GYw = 0 and with it w'Y'[F, G] = 0, so Yw = 0; the null space of F'Y is
J-invariant; on an eigenvector w in it (F - lam K)Xw = 0, so Xw = 0 and w = 0.
With J = (F'Y)^-1 K'Y the first block row is the Riccati equation for
P = X(F'Y)^-1, which is a congruence of Y'FX.

In the claims F, K are any matrices of one size, K = (A; 0) among them. Complex
numbers are written by real and imaginary parts. Full column rank of a matrix
is said through a left inverse, full row rank through a right inverse.
"""

from __future__ import annotations

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import combination, example, identity, instances, order, steps
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    block,
    circle_roots,
    det,
    eq,
    given,
    hstack,
    iff,
    inside_roots,
    inv,
    invertible,
    kernel_basis,
    let,
    matrix,
    nonsingular,
    nonzero,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    scalar,
    schur,
    size_of,
    standing,
    sym,
    symbols,
    symmetric_matrix,
    trace,
    vector,
    vstack,
)
from proofs.nwl92.notation import lower, one_inverse, upper

l, p, n, k = symbols("l p n k")
A, Q, S, R, E, C = symbols("A Q S R E C")
F, K, G, P, X, Y, J = symbols("F K G P X Y J")
PENCIL = {F: matrix(k, n), K: matrix(k, n), G: positive_semidefinite(k)}
SIZES = {"k": (1, 2, 3), "n": (1, 2)}
M_PENCIL = block([[F, -G], [Zero(n, n), T(K)]])
N_PENCIL = block([[K, Zero(k, k)], [Zero(n, n), T(F)]])

# ------------------------------------------------------------------ (5.3) and (5.4)
F_B, K_B, G_B = symbols("Fb Kb Gb")
NOTATION = [let(F_B, vstack(E, C)), let(K_B, vstack(A, Zero(p, n))), let(G_B, block([[Q, -S], [-T(S), R]]))]
DATA = {A: matrix(l, n), E: matrix(l, n), C: matrix(p, n), Q: symmetric_matrix(l), S: matrix(l, p), R: symmetric_matrix(p)}
claim("NWL92-E5.3", "the pencil in the notation (5.2)",
      (block([[E, -Q, S], [C, T(S), -R], [Zero(n, n), T(A), Zero(n, p)]])
       == block([[F_B, -G_B], [Zero(n, n), T(K_B)]]))
      & (block([[A, Zero(l, l), Zero(l, p)], [Zero(p, n), Zero(p, l), Zero(p, p)], [Zero(n, n), T(E), T(C)]])
         == block([[K_B, block([[Zero(l, l), Zero(l, p)], [Zero(p, l), Zero(p, p)]])], [Zero(n, n), T(F_B)]])),
      sizes=["l", "p", "n"], over=DATA, where=NOTATION, by=[instances(l=(1, 2), p=(1, 2), n=(1, 2))])

W, U, Tb, Zr, Gi = symbols("W U T Zr Gi")
L, N1, N2, X0, X1, X2, M0 = symbols("L N1 N2 X0 X1 X2 M0")
RICCATI_Z = let(Zr, block([[K * P * T(K) + G, F], [T(F), Zero(n, n)]]))
RIGHT = -(hstack(Zero(n, k), Identity(n)) * inv(Zr) * vstack(Zero(k, n), Identity(n)))
INVERSE = let(Gi, block([[W, U], [T(U), Tb]]))
FULL_ROW = given("[F G] has full row rank", F * N1 + G * N2 == Identity(k))
ROW_INVERSE = {N1: matrix(n, k), N2: matrix(k, k)}
#: a random right inverse of [F G], where there is one
ROWS_MADE = {N1: one_inverse(T(F) * F) * T(F) * X1, N2: one_inverse(G) * (Identity(k) - F * N1)}
claim("NWL92-E5.4", "the algebraic Riccati equation in the notation (5.2)",
      iff(P == -(hstack(Zero(n, k), Identity(n)) * Gi * vstack(Zero(k, n), Identity(n))), P == RIGHT),
      sizes=["k", "n"], over={**PENCIL, P: positive_semidefinite(n), W: symmetric_matrix(k), U: matrix(k, n), Tb: symmetric_matrix(n)},
      where=[RICCATI_Z, INVERSE], given=[given("(2.20)", Zr * Gi * Zr == Zr)],
      by=[instances(made_by={W: T(upper(k, n)) * inv(Zr) * upper(k, n), U: T(upper(k, n)) * inv(Zr) * lower(k, n),
                             Tb: T(lower(k, n)) * inv(Zr) * lower(k, n)}, **SIZES),
          instances(made_by={K: F * X0, G: F * (P - X0 * P * T(X0)) * T(F) + (Identity(k) - F * one_inverse(T(F) * F) * T(F)) * M0
                             * (Identity(k) - F * one_inverse(T(F) * F) * T(F)), W: T(upper(k, n)) * inv(Zr) * upper(k, n),
                             U: T(upper(k, n)) * inv(Zr) * lower(k, n), Tb: T(lower(k, n)) * inv(Zr) * lower(k, n)},
                    using={X0: matrix(n, n), M0: positive_semidefinite(k)}, **SIZES)],
      note=("The left side is (4.19), read with any (1)-inverse. That the 3-block matrix is invertible for a detectable and "
            "stabilizable system is the denominator here."))

# ------------------------------------------------------------------ Lemma 5.1
a, b, t0 = symbols("a b t0")
DETECTABLE = given("detectable", (L * F == Identity(n)) & schur(L * K))
STABILIZABLE = given("stabilizable", (F * N1 + G * N2 == Identity(k)) & schur(K * N1))
CERTIFICATES = {L: matrix(n, k), **ROW_INVERSE}
CERTIFIED = ("Detectability is said as in Lemma 4.1: F has a left inverse L with stable LK; stabilizability is the same for the "
             "transposed matrices, F N1 + G N2 = I with stable K N1.")
GRAM_INVERSE = inv(T(F) * F) * T(F)
REST = Identity(k) - F * L
SYSTEM_MADE = {L: GRAM_INVERSE + X1 * (Identity(k) - F * GRAM_INVERSE), K: F * X0 * (1 / (1 + trace(X0 * T(X0)))) + REST * X2,
               G: REST * M0 * T(REST) + G, N1: L, N2: one_inverse(G) * REST}
G0 = sym("G0")
SYSTEM_MADE = {**SYSTEM_MADE, G: REST * M0 * T(REST) + G0}
SYSTEM_FREE = {X1: matrix(n, k), X0: matrix(n, n), X2: matrix(k, n), M0: positive_definite(k), G0: positive_semidefinite(k)}
POINT = {a: (1 - t0 * t0) / (1 + t0 * t0), b: 2 * t0 / (1 + t0 * t0)}
ON_CIRCLE = given("|z| = 1", a * a + b * b == 1)


def systems(made_by=None, using=None, **sizes):
    """Detectable and stabilizable F, K, G with their certificates."""
    return instances(made_by={**SYSTEM_MADE, **(made_by or {})}, using={**SYSTEM_FREE, **(using or {})}, **{**SIZES, **sizes})


#: F = K = 1: an eigenmode at 1, not detectable; F = (1; 0), K = G = 0: no full row rank
NOT_DETECTABLE = {"k": 1, "n": 1, F: [[1]], K: [[1]], G: [[1]], L: [[1]], N1: [[0]], N2: [[1]]}
NOT_STABILIZABLE = {"k": 2, "n": 1, F: [[1], [0]], K: [[0], [0]], G: [[0, 0], [0, 0]], L: [[1, 0]], N1: [[0, 0]], N2: [[0, 0], [0, 0]]}
FOILS = [example(NOT_DETECTABLE), example(NOT_STABILIZABLE)]
CHARACTERISTIC = det(M_PENCIL - Z * N_PENCIL)
LEMMA_STEPS = steps("NWL92-E5.10", "NWL92-S44", facts=["a square matrix with trivial null space is invertible"],
                    prose=("A null vector (u; v) at a point of the circle satisfies (5.8) and (5.9); then v*Gv = 0 and u = v = 0. A polynomial "
                           "determinant that is nonzero on the circle is not the zero polynomial."))
claim("NWL92-L5.1", "the pencil is regular and has no eigenmode on the unit circle",
      (CHARACTERISTIC != 0) & (circle_roots(CHARACTERISTIC) == 0), sizes=["k", "n"], over={**PENCIL, **CERTIFICATES},
      given=[DETECTABLE, STABILIZABLE], by=[LEMMA_STEPS, *FOILS, systems()], note=CERTIFIED)


def real_form(real, imaginary):
    """[X, -Y; Y, X] of X + iY."""
    return block([[real, -imaginary], [imaginary, real]])


AT_Z = real_form(block([[F + a * K, -G], [Zero(n, n), T(K) + a * T(F)]]), block([[b * K, Zero(k, k)], [Zero(n, n), b * T(F)]]))
claim("NWL92-E5.5", "the pencil is invertible at every point of the unit circle",
      invertible(AT_Z), sizes=["k", "n"], over={**PENCIL, **CERTIFICATES, a: scalar(), b: scalar()},
      given=[DETECTABLE, STABILIZABLE, ON_CIRCLE],
      by=[LEMMA_STEPS, example({**NOT_DETECTABLE, a: -1, b: 0}), example({**NOT_STABILIZABLE, a: 1, b: 0}),
          example({**NOT_DETECTABLE, L: [[1]], K: [["1/2"]], a: -2, b: 0}), systems(POINT, {t0: scalar()})],
      note=CERTIFIED + " z = a + ib; the matrix is the real form [X, -Y; Y, X] of X + iY.")

Le, Lc, s1, s2, t1, t2 = symbols("Le Lc s1 s2 t1 t2")
FULL_E = vstack(E, C)


def pencil_at(below):
    """Real form of [sE - tA; below], below = C or sC."""
    return real_form(vstack(s1 * E - t1 * A, below[0]), vstack(s2 * E - t2 * A, below[1]))


claim("NWL92-S43", "detectability in the notation (5.2), and F + zK has full column rank on the unit circle",
      (rank(pencil_at((C, Zero(p, n)))) == rank(pencil_at((s1 * C, s2 * C))))
      & (rank(real_form(vstack(E + a * A, C), vstack(b * A, Zero(p, n)))) == 2 * n),
      sizes=["l", "p", "n"],
      over={A: matrix(l, n), E: matrix(l, n), C: matrix(p, n), Le: matrix(n, l), Lc: matrix(n, p), a: scalar(), b: scalar(),
            s1: nonzero(), s2: scalar(), t1: scalar(), t2: scalar()},
      given=[given("detectable", (Le * E + Lc * C == Identity(n)) & schur(Le * A)), standing("|z| = 1", a * a + b * b == 1)],
      by=[example({"l": 1, "p": 1, "n": 1, A: [[1]], E: [[1]], C: [[0]], Le: [[1]], Lc: [[0]], a: -1, b: 0, s1: 1, s2: 0, t1: 0, t2: 0}),
          instances(made_by={Le: inv(T(E) * E + T(C) * C) * T(E), Lc: inv(T(E) * E + T(C) * C) * T(C),
                             A: X0 * (1 / ((1 + trace(X0 * T(X0))) * (1 + trace(Le * T(Le))))), **POINT},
                    using={X0: matrix(l, n), t0: scalar()}, l=(1, 2), p=(1, 2), n=(1, 2))],
      note=("s = s1 + is2 is not zero, as |s| >= |t| and not both are zero; s1 is taken nonzero, which is no loss, as (s, t) may be "
            "multiplied by a complex number. z = a + ib."))

not_checked("NWL92-E5.6", "a null vector of the pencil at a point of the circle",
            "the assumption of a proof: it fixes notation and asserts nothing")
not_checked("NWL92-E5.7", "Gam = zK + F", "a definition: it fixes notation and asserts nothing")

u1, u2, v1, v2 = symbols("u1 u2 v1 v2")
NULL = {u1: vector(n), u2: vector(n), v1: vector(k), v2: vector(k)}
AT_POINT = {**PENCIL, a: scalar(), b: scalar(), **NULL}
EQUATION = given("(5.6)", AT_Z * vstack(u1, v1, u2, v2) == Zero(2 * (k + n), 1))
ROW_U = [hstack(Identity(k), Zero(k, n), Zero(k, k + n)), hstack(Zero(k, k + n), Identity(k), Zero(k, n))]
ROW_V = [hstack(Zero(n, k), Identity(n), Zero(n, k + n)), hstack(Zero(n, k + n), Zero(n, k), Identity(n))]
#: null vectors at z: v1, v2 with (K' + zF')v = 0 and Gv in the range of F + zK
KERNEL = sym("kn")
NULL_MADE = {KERNEL: kernel_basis(AT_Z) * T(kernel_basis(AT_Z)) * vstack(u1, v1, u2, v2)}
h1, h2 = symbols("h1 h2")
h = sym("h")
PARTS = {KERNEL: kernel_basis(AT_Z) * (T(kernel_basis(AT_Z)) * h), u1: hstack(Identity(n), Zero(n, k + n + k)) * KERNEL,
         v1: hstack(Zero(k, n), Identity(k), Zero(k, n + k)) * KERNEL, u2: hstack(Zero(n, n + k), Identity(n), Zero(n, k)) * KERNEL,
         v2: hstack(Zero(k, n + k + n), Identity(k)) * KERNEL}
#: systems that have null vectors: K = -F turned by the point, with G of low rank
SINGULAR = [instances(made_by={**POINT, K: -a * F, G: X2 * T(X2), **PARTS}, using={t0: scalar(), X2: matrix(k, 1), h: vector(2 * (k + n))}, **SIZES),
            instances(made_by={a: 1 - 2 * (t0 * t0 / (1 + t0 * t0)) * 0, b: 0 * t0, K: -F + X1 * T(X0), **PARTS},
                      using={t0: scalar(), X1: matrix(k, 1), X0: matrix(n, 1), h: vector(2 * (k + n))}, **SIZES)]
claim("NWL92-E5.8", "first part of (5.6)",
      ((F + a * K) * u1 - b * K * u2 - G * v1 == Zero(k, 1)) & (b * K * u1 + (F + a * K) * u2 - G * v2 == Zero(k, 1)),
      sizes=["k", "n"], over=AT_POINT, given=[EQUATION],
      by=[combination([[(ROW_U[0], "(5.6)", 1)], [(ROW_U[1], "(5.6)", 1)]], k=(1, 2, 3), n=(1, 2)), *SINGULAR],
      note="By real and imaginary part, z = a + ib.")

claim("NWL92-E5.9", "second part of (5.6)",
      (T(F + a * K) * v1 + b * T(K) * v2 == Zero(n, 1)) & (T(F + a * K) * v2 - b * T(K) * v1 == Zero(n, 1)),
      sizes=["k", "n"], over=AT_POINT, given=[EQUATION, ON_CIRCLE],
      by=[combination([[(a * ROW_V[0] + b * ROW_V[1], "(5.6)", 1), (-T(F) * v1, "|z| = 1", 1)],
                       [(a * ROW_V[1] - b * ROW_V[0], "(5.6)", 1), (-T(F) * v2, "|z| = 1", 1)]], k=(1, 2, 3), n=(1, 2)), *SINGULAR],
      note="By real and imaginary part, z = a + ib.")

Gr, Gi2 = symbols("Gr Gi")
GAMMA = {G: positive_semidefinite(k), Gr: matrix(k, n), Gi2: matrix(k, n), **NULL}
E58 = given("(5.8)", (Gr * u1 - Gi2 * u2 == G * v1) & (Gi2 * u1 + Gr * u2 == G * v2))
E59 = given("(5.9)", (T(Gr) * v1 + T(Gi2) * v2 == Zero(n, 1)) & (T(Gr) * v2 - T(Gi2) * v1 == Zero(n, 1)))
E58S = [given("(5.8), real part", Gr * u1 - Gi2 * u2 == G * v1), given("(5.8), imaginary part", Gi2 * u1 + Gr * u2 == G * v2)]
E59S = [given("(5.9), real part", T(Gr) * v1 + T(Gi2) * v2 == Zero(n, 1)), given("(5.9), imaginary part", T(Gr) * v2 - T(Gi2) * v1 == Zero(n, 1))]
NULL_GAMMA = sym("kg")
STACKED = real_form(Gr, Gi2)
#: (v1; v2) in the left null space of Gam, G annihilating both; (u1; u2) in the null space of Gam
GAMMA_MADE = {NULL_GAMMA: kernel_basis(T(STACKED)) * T(kernel_basis(T(STACKED))) * vstack(h1, h2),
              v1: T(upper(k, k)) * NULL_GAMMA, v2: T(lower(k, k)) * NULL_GAMMA,
              sym("kv"): kernel_basis(T(hstack(v1, v2))), G: sym("kv") * T(sym("kv")) * M0 * sym("kv") * T(sym("kv")),
              sym("ku"): kernel_basis(STACKED) * T(kernel_basis(STACKED)) * vstack(X1, X2),
              u1: T(upper(n, n)) * sym("ku"), u2: T(lower(n, n)) * sym("ku")}
GAMMA_DRAWN = instances(made_by=GAMMA_MADE, using={h1: vector(k), h2: vector(k), M0: positive_semidefinite(k), X1: vector(n), X2: vector(n)}, **SIZES)
ZERO_POINT = {"k": 1, "n": 1, G: [[1]], Gr: [[1]], Gi2: [[0]], u1: [1], u2: [0], v1: [1], v2: [0]}
claim("NWL92-E5.10", "v*Gv = 0",
      T(v1) * G * v1 + T(v2) * G * v2 == 0, sizes=["k", "n"], over=GAMMA, given=[*E58S, *E59S],
      by=[example({**ZERO_POINT, Gr: [[0]], Gi2: [[0]]}), example({**ZERO_POINT, Gr: [[0]], Gi2: [[0]], v1: [0], v2: [1]}), example(ZERO_POINT),
          example({**ZERO_POINT, u1: [0], u2: [1], v1: [0], v2: [1]}), example({**ZERO_POINT, Gr: [[0]], Gi2: [[1]], u1: [0], u2: [-1]}), GAMMA_DRAWN],
      note=("The print has vGv*, which has no meaning for the column v of (5.6) unless it has one entry; it is read as v*Gv. v = v1 + iv2; the "
            "imaginary part of v*Gv is zero for every v."))

Lr, Li, Nr, Ni, Mr, Mi = symbols("Lr Li Nr Ni Mr Mi")
COLUMN_RANK = given("Gam has full column rank", (Lr * Gr - Li * Gi2 == Identity(n)) & (Lr * Gi2 + Li * Gr == Zero(n, n)))
ROW_RANK = given("[Gam, G] has full row rank", (Gr * Nr - Gi2 * Ni + G * Mr == Identity(k)) & (Gr * Ni + Gi2 * Nr + G * Mi == Zero(k, k)))
RANKS = {Lr: matrix(n, k), Li: matrix(n, k), Nr: matrix(n, k), Ni: matrix(n, k), Mr: matrix(k, k), Mi: matrix(k, k)}
ENERGY = [T(v1) * G * v1, T(v2) * G * v2]
ZERO_K, ZERO_N = Zero(k, 1), Zero(n, 1)
claim("NWL92-S44", "the null vector is zero",
      (G * v1 == ZERO_K) & (G * v2 == ZERO_K) & (u1 == ZERO_N) & (u2 == ZERO_N) & (v1 == ZERO_K) & (v2 == ZERO_K),
      sizes=["k", "n"], over={**GAMMA, **RANKS}, given=[*E58S, *E59S, COLUMN_RANK, ROW_RANK],
      by=[order([], ENERGY, ENERGY, lemmas=[(T(v1) * G * v1 + T(v2) * G * v2) * Identity(1) == Zero(1, 1), G * v1 == ZERO_K, G * v2 == ZERO_K]),
          instances(made_by={u1: Zero(n, 1), u2: Zero(n, 1), v1: Zero(k, 1), v2: Zero(k, 1), Gi2: Zero(k, n),
                             Lr: inv(T(Gr) * Gr) * T(Gr), Li: Zero(n, k), Nr: Lr, Ni: Zero(n, k), Mr: inv(G) * (Identity(k) - Gr * Nr), Mi: Zero(k, k)}, **SIZES)],
      note="Full rank is said through left and right inverses, complex ones by real and imaginary part.")
