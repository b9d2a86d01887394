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

from exactkf.claims import claim, repair
from exactkf.evidence import EIGENVALUE, EIGENVECTOR, combination, example, identity, instances, null_vector, order, steps, within
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    block,
    defined,
    det,
    detectable,
    diagonal,
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
    observable,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    scalar,
    schur,
    standing,
    sym,
    symbols,
    symmetric_matrix,
    trace,
    vector,
    vstack,
)
from proofs.nwl92.notation import lower, one_inverse, real_form, upper

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

W, U, Tb, Zr, Gi = symbols("W U Tb Zr Gi")
L, N1, N2, X0, X1, X2, M0 = symbols("L N1 N2 X0 X1 X2 M0")
B0, G0, V0 = symbols("B0 G0 V0")
INNER_NOISE = K * P * T(K) + G
RICCATI_Z = let(Zr, block([[INNER_NOISE, F], [T(F), Zero(n, n)]]))
INVERSE = let(Gi, block([[W, U], [T(U), Tb]]))
FULL_ROW = given("[F G] has full row rank", F * N1 + G * N2 == Identity(k))
FULL_COLUMN = given("F has full column rank", L * F == Identity(n))
ROW_INVERSE = {N1: matrix(n, k), N2: matrix(k, k)}
LAST_ROWS, LAST_COLUMNS = hstack(Zero(n, k), Identity(n)), vstack(Zero(k, n), Identity(n))
#: the columns of I - Gi Zr, which lie in the kernel of Zr, are zero
KERNEL_A = hstack(Identity(k) - W * INNER_NOISE - U * T(F), -(W * F))
KERNEL_B = hstack(-(T(U) * INNER_NOISE + Tb * T(F)), Identity(n) - T(U) * F)
ENERGIES = [T(KERNEL_A) * G * KERNEL_A, T(KERNEL_A) * K * P * T(K) * KERNEL_A]
ZERO_A, ZERO_B = Zero(k, k + n), Zero(n, k + n)
RICCATI_MADE = {L: inv(T(F) * F) * T(F), N1: L, N2: one_inverse(G) * (Identity(k) - F * L), X1: T(upper(k, n)) * inv(Zr) * lower(k, n),
                X2: T(lower(k, n)) * inv(Zr) * lower(k, n), W: T(upper(k, n)) * inv(Zr) * upper(k, n), U: X1, Tb: X2}
OFF_RANGE = Identity(k) - F * (inv(T(F) * F) * T(F))
claim("NWL92-E5.4", "the algebraic Riccati equation in the notation (5.2)",
      (Zr * Gi == Identity(k + n)) & iff(P == -(LAST_ROWS * Gi * LAST_COLUMNS), P == -X2),
      sizes=["k", "n"],
      over={**PENCIL, P: positive_semidefinite(n), W: symmetric_matrix(k), U: matrix(k, n), Tb: symmetric_matrix(n), L: matrix(n, k), **ROW_INVERSE,
            X1: matrix(k, n), X2: matrix(n, n)},
      where=[RICCATI_Z, INVERSE],
      given=[given("(2.20)", Zr * Gi * Zr == Zr), given("(X1; X2) are the last columns of the inverse", Zr * vstack(X1, X2) == LAST_COLUMNS),
             FULL_ROW, FULL_COLUMN],
      by=[order([], [], ENERGIES, [], [], [], lemmas=[vstack(INNER_NOISE * KERNEL_A + F * KERNEL_B, T(F) * KERNEL_A) == Zero(k + n, k + n),
                                                     T(KERNEL_A) * INNER_NOISE * KERNEL_A * Identity(k + n) == Zero(k + n, k + n),
                                                     G * KERNEL_A == ZERO_A, KERNEL_A == ZERO_A, F * KERNEL_B == ZERO_A, KERNEL_B == ZERO_B]),
          example(k=2, n=1, F=[[1], [0]], K=[[0], [0]], G=[[0, 0], [0, 0]], P=[[0]], W=[[0, 0], [0, 0]], U=[[1], [0]], Tb=[[0]], L=[[1, 0]], N1=[[0, 0]],
                  N2=[[0, 0], [0, 0]], X1=[[1], [0]], X2=[[0]]),
          instances(12, made_by={F: V0 * vstack(Identity(n), Zero(k - n, n)), **RICCATI_MADE},
                    using={V0: nonsingular(k)}, k=(2, 3), n=(1, 2)),
          instances(made_by={F: V0 * vstack(Identity(n), Zero(k - n, n)), P: B0 * T(B0), K: F * B0 * X0 * (1 / (1 + trace(X0 * T(X0)))) * inv(B0),
                             G: F * P * T(F) - K * P * T(K) + OFF_RANGE * G0 * OFF_RANGE, **RICCATI_MADE},
                    using={V0: nonsingular(k), X0: matrix(n, n), B0: nonsingular(n), G0: positive_definite(k)}, k=(2, 3), n=(1, 2))],
      note=("The left side is (4.19), read with any (1)-inverse Gi, which is shown to be the inverse; X2 is the last block of the inverse in (5.4). Full rank, "
            "which detectability and stabilizability give, is said through a left and a right inverse."))

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
ON_THE_CIRCLE = {"k": 2, "n": 1, F: [[1], [0]], K: [[1], [1]], G: [[0, 0], [0, 1]], L: [[1, -1]], N1: [[0, 0]], N2: [[0, 0], [0, 0]]}
FOILS = [example(NOT_DETECTABLE), example(NOT_STABILIZABLE), example(ON_THE_CIRCLE)]
CHARACTERISTIC = sym("chi")
CHI = let(CHARACTERISTIC, det(M_PENCIL - Z * N_PENCIL))
Zz = sym("Mz")
AT_Z = real_form(block([[F + a * K, -G], [Zero(n, n), T(K) + a * T(F)]]), block([[b * K, Zero(k, k)], [Zero(n, n), b * T(F)]]))
Le, Lc, s1, s2, t1, t2 = symbols("Le Lc s1 s2 t1 t2")


def pencil_at(below):
    """Real form of [sE - tA; below], below = C or sC."""
    return real_form(vstack(s1 * E - t1 * A, below[0]), vstack(s2 * E - t2 * A, below[1]))


NOT_ZERO = s1 * s1 + s2 * s2
nv, nw, BOUND = null_vector(0), null_vector(1), sym("Bound")
SAME_KERNEL = within(1, *(NOT_ZERO * (C * v) == Zero(p, 1) for v in (nv, nw)), *(C * v == Zero(p, 1) for v in (nv, nw)), vector="right")
NOTATION_E = [let(F_B, vstack(E, C)), let(K_B, vstack(A, Zero(p, n)))]
claim("NWL92-S43", "detectability in the notation (5.2), and F + zK has full column rank on the unit circle",
      (X2 == real_form(s1 * F_B - t1 * K_B, s2 * F_B - t2 * K_B)) & iff(rank(X1) == 2 * n, rank(X2) == 2 * n)
      & (Zz == real_form(F_B + a * K_B, b * K_B)),
      where=[*NOTATION_E, let(X1, pencil_at((C, Zero(p, n)))), let(X2, pencil_at((s1 * C, s2 * C))),
             let(Zz, real_form(vstack(1 * E - (-a) * A, 1 * C), vstack(0 * E - (-b) * A, 0 * C)))],
      sizes=["l", "p", "n"],
      over={A: matrix(l, n), E: matrix(l, n), C: matrix(p, n), a: scalar(), b: scalar(), s1: scalar(), s2: scalar(), t1: scalar(), t2: scalar()},
      given=[given("s is not zero", NOT_ZERO > 0)],
      by=[order([], [], [], [1 / NOT_ZERO], [1 / NOT_ZERO], inside=[SAME_KERNEL]),
          example({"l": 1, "p": 1, "n": 1, A: [[0]], E: [[0]], C: [[1]], a: 1, b: 0, s1: 0, s2: 0, t1: 1, t2: 0}),
          instances(l=(1, 2), p=(1, 2), n=(1, 2))],
      note=("X1 is [sE - tA; C], X2 is sF - tK = [sE - tA; sC], in real form; s = s1 + is2, t = t1 + it2, z = a + ib. Only that s is not "
            "zero is used, as |s| >= |t| and (s, t) other than (0, 0) give. Mz is sF - tK at (1, -z), where |s| = |t| if |z| = 1, and it is F + zK."))

Gre, Gim = symbols("Gre Gim")
claim("NWL92-E5.7", "with Gam = zK + F the lower right block of (5.6) is z Gam*",
      (T(K) + a * T(F) == a * T(Gre) + b * T(Gim)) & (b * T(F) == b * T(Gre) - a * T(Gim)), sizes=["k", "n"],
      over={F: matrix(k, n), K: matrix(k, n), a: scalar(), b: scalar()}, where=[let(Gre, F + a * K), let(Gim, b * K)], given=[ON_CIRCLE],
      by=[instances(made_by=POINT, using={t0: scalar()}, **SIZES)],
      note="A definition; what is checked is what it is made for, by real and imaginary part: z = a + ib, Gam = Gre + i Gim, and z times z* is one.")

u1, u2, v1, v2 = symbols("u1 u2 v1 v2")
NULL = {u1: vector(n), u2: vector(n), v1: vector(k), v2: vector(k)}
AT_POINT = {**PENCIL, a: scalar(), b: scalar(), **NULL}
REAL_ROWS = [F * u1 + a * (K * u1) - b * (K * u2) - G * v1, T(K) * v1 + a * (T(F) * v1) - b * (T(F) * v2)]
IMAGINARY_ROWS = [F * u2 + a * (K * u2) + b * (K * u1) - G * v2, T(K) * v2 + a * (T(F) * v2) + b * (T(F) * v1)]
claim("NWL92-E5.6", "the matrix (5.5) times (u; v), by real and imaginary part",
      AT_Z * vstack(u1, v1, u2, v2) == vstack(*REAL_ROWS, *IMAGINARY_ROWS), sizes=["k", "n"], over=AT_POINT, by=[instances(**SIZES)],
      note=("The assumption of a proof, that the product is zero for some (u; v) other than zero; what is checked is the real form in which it is assumed from "
            "(5.8) on, for z = a + ib, u = u1 + iu2, v = v1 + iv2."))

EQUATION = given("(5.6)", AT_Z * vstack(u1, v1, u2, v2) == Zero(2 * (k + n), 1))
ROW_U = [hstack(Identity(k), Zero(k, n), Zero(k, k + n)), hstack(Zero(k, k + n), Identity(k), Zero(k, n))]
ROW_V = [hstack(Zero(n, k), Identity(n), Zero(n, k + n)), hstack(Zero(n, k + n), Zero(n, k), Identity(n))]
#: F, K from K + zF = M with v'M = 0, then G with Gv = (F + zK)u
Vv, Mr0, Mi0, r1, r2, Mre, Mim, S0 = symbols("Vv Mr0 Mi0 r1 r2 Mre Mim S0")
LENGTH = 1 / (T(v1) * v1 + T(v2) * v2)
COLUMNS = [(F + a * K) * u1 - b * K * u2, b * K * u1 + (F + a * K) * u2]
V_INVERSE = inv(T(Vv) * Vv) * T(Vv)
NULL_MADE = {Vv: hstack(v1, v2), r1: T(v1) * Mr0 - T(v2) * Mi0, r2: T(v1) * Mi0 + T(v2) * Mr0,
             Mre: Mr0 - (v1 * r1 + v2 * r2) * LENGTH, Mim: Mi0 - (v1 * r2 - v2 * r1) * LENGTH, F: Mim * (1 / b), K: Mre - a * F,
             G: hstack(*COLUMNS) * V_INVERSE + X2 * (Identity(k) - Vv * V_INVERSE)}
NULL_FREE = {Mr0: matrix(k, n), Mi0: matrix(k, n), X2: matrix(k, k)}
NULL_SIZES = {"k": (2, 3), "n": (1, 2)}
AT_POINT = {**AT_POINT, G: matrix(k, k)}
claim("NWL92-E5.8", "first part of (5.6)",
      ((F + a * K) * u1 - b * K * u2 - G * v1 == Zero(k, 1)) & (b * K * u1 + (F + a * K) * u2 - G * v2 == Zero(k, 1)),
      sizes=["k", "n"], over=AT_POINT, given=[EQUATION],
      by=[combination([[(ROW_U[0], "(5.6)", 1)], [(ROW_U[1], "(5.6)", 1)]], k=(1, 2, 3), n=(1, 2)),
          instances(made_by=NULL_MADE, using=NULL_FREE, **NULL_SIZES)],
      note="By real and imaginary part, z = a + ib.")

claim("NWL92-E5.9", "second part of (5.6)",
      (T(F + a * K) * v1 + b * T(K) * v2 == Zero(n, 1)) & (T(F + a * K) * v2 - b * T(K) * v1 == Zero(n, 1)),
      sizes=["k", "n"], over=AT_POINT, given=[EQUATION, ON_CIRCLE],
      by=[combination([[(a * ROW_V[0] + b * ROW_V[1], "(5.6)", 1), (-T(F) * v1, "|z| = 1", 1)],
                       [(a * ROW_V[1] - b * ROW_V[0], "(5.6)", 1), (-T(F) * v2, "|z| = 1", 1)]], k=(1, 2), n=(1, 2)),
          instances(made_by={**POINT, **NULL_MADE}, using={t0: scalar(), **NULL_FREE}, **NULL_SIZES)],
      note="By real and imaginary part, z = a + ib.")

Gr, Gi2 = symbols("Gr Gi")
GAMMA = {G: positive_semidefinite(k), Gr: matrix(k, n), Gi2: matrix(k, n), **NULL}
E58S = [given("(5.8), real part", Gr * u1 - Gi2 * u2 == G * v1), given("(5.8), imaginary part", Gi2 * u1 + Gr * u2 == G * v2)]
E59S = [given("(5.9), real part", T(Gr) * v1 + T(Gi2) * v2 == Zero(n, 1)), given("(5.9), imaginary part", T(Gr) * v2 - T(Gi2) * v1 == Zero(n, 1))]
#: Gam with v*Gam = 0, any u, and a symmetric G with Gv = Gam u
GAMMA_MADE = {Vv: hstack(v1, v2), r1: T(v1) * Mr0 + T(v2) * Mi0, r2: T(v1) * Mi0 - T(v2) * Mr0,
              Gr: Mr0 - (v1 * r1 - v2 * r2) * LENGTH, Gi2: Mi0 - (v1 * r2 + v2 * r1) * LENGTH,
              Mre: hstack(Gr * u1 - Gi2 * u2, Gi2 * u1 + Gr * u2) * V_INVERSE,
              G: Mre + T(Mre) - T(V_INVERSE) * T(Vv) * Mre + (Identity(k) - Vv * V_INVERSE) * S0 * (Identity(k) - Vv * V_INVERSE)}
GAMMA_DRAWN = instances(made_by=GAMMA_MADE, using={Mr0: matrix(k, n), Mi0: matrix(k, n), S0: symmetric_matrix(k)}, **NULL_SIZES)
ZERO_POINT = {"k": 1, "n": 1, G: [[1]], Gr: [[1]], Gi2: [[0]], u1: [1], u2: [0], v1: [1], v2: [0]}
PRINTED_ENERGY = [v1 * G * T(v1) + v2 * G * T(v2), v2 * G * T(v1) - v1 * G * T(v2)]
NO_FIT = example({"k": 2, "n": 1, G: [[0, 0], [0, 0]], Gr: [[1], [0]], Gi2: [[0], [0]], u1: [0], u2: [0], v1: [0, 1], v2: [0, 0]})
E510 = {"sizes": ["k", "n"], "over": {**GAMMA, G: symmetric_matrix(k)}, "given": [*E58S, *E59S]}
claim("NWL92-E5.10", "vGv* = 0 for the column v, as printed",
      defined(PRINTED_ENERGY[0]) & (PRINTED_ENERGY[0] == Zero(k, k)) & (PRINTED_ENERGY[1] == Zero(k, k)), **E510, by=[NO_FIT, GAMMA_DRAWN],
      repair=repair("order of factors", ("the factors v and v* are exchanged: v is a column, so that the printed product is not even defined unless v has "
                                         "one entry"),
                    T(v1) * G * v1 + T(v2) * G * v2 == 0, **E510,
                    by=[example({**ZERO_POINT, Gr: [[0]], Gi2: [[0]]}), example({**ZERO_POINT, Gr: [[0]], Gi2: [[0]], v1: [0], v2: [1]}), example(ZERO_POINT),
                        example({**ZERO_POINT, u1: [0], u2: [1], v1: [0], v2: [1]}), example({**ZERO_POINT, Gr: [[0]], Gi2: [[1]], u1: [0], u2: [-1]}),
                        GAMMA_DRAWN]),
      note="v = v1 + iv2; in the print by real and imaginary part. The imaginary part of v*Gv is zero for every v.")

Lr, Li, Nr, Ni, Mr, Mi = symbols("Lr Li Nr Ni Mr Mi")
COLUMN_RANK = given("Gam has full column rank", (Lr * Gr - Li * Gi2 == Identity(n)) & (Lr * Gi2 + Li * Gr == Zero(n, n)))
ROW_RANK = given("[Gam, G] has full row rank", (Gr * Nr - Gi2 * Ni + G * Mr == Identity(k)) & (Gr * Ni + Gi2 * Nr + G * Mi == Zero(k, k)))
RANKS = {Lr: matrix(n, k), Li: matrix(n, k), Nr: matrix(n, k), Ni: matrix(n, k), Mr: matrix(k, k), Mi: matrix(k, k)}
ENERGY = [T(v1) * G * v1, T(v2) * G * v2]
ZERO_K, ZERO_N = Zero(k, 1), Zero(n, 1)
ONE_POINT = {"k": 1, "n": 1, G: [[0]], Gr: [[1]], Gi2: [[0]], u1: [0], u2: [0], v1: [0], v2: [0], Lr: [[1]], Li: [[0]], Nr: [[1]], Ni: [[0]],
             Mr: [[0]], Mi: [[0]]}
S44_FOILS = [example({**ONE_POINT, v1: [1]}), example({**ONE_POINT, v2: [1]}), example({**ONE_POINT, u1: [1]}), example({**ONE_POINT, u2: [1]}),
             example({**ONE_POINT, G: [[1]], Gr: [[0]], Nr: [[0]], Mr: [[1]], u1: [1]}),
             example({"k": 2, "n": 1, G: [[0, 0], [0, 0]], Gr: [[1], [0]], Gi2: [[0], [0]], u1: [0], u2: [0], v1: [0, 1], v2: [0, 0], Lr: [[1, 0]],
                      Li: [[0, 0]], Nr: [[0, 0]], Ni: [[0, 0]], Mr: [[0, 0], [0, 0]], Mi: [[0, 0], [0, 0]]})]
claim("NWL92-S44", "the null vector is zero",
      (G * v1 == ZERO_K) & (G * v2 == ZERO_K) & (u1 == ZERO_N) & (u2 == ZERO_N) & (v1 == ZERO_K) & (v2 == ZERO_K),
      sizes=["k", "n"], over={**GAMMA, **RANKS}, given=[*E58S, *E59S, COLUMN_RANK, ROW_RANK],
      by=[order([], ENERGY, ENERGY, lemmas=[(T(v1) * G * v1 + T(v2) * G * v2) * Identity(1) == Zero(1, 1), G * v1 == ZERO_K, G * v2 == ZERO_K]),
          *S44_FOILS,
          instances(made_by={u1: Zero(n, 1), u2: Zero(n, 1), v1: Zero(k, 1), v2: Zero(k, 1), Gi2: Zero(k, n),
                             Lr: inv(T(Gr) * Gr) * T(Gr), Li: Zero(n, k), Nr: Lr, Ni: Zero(n, k), Mr: inv(G) * (Identity(k) - Gr * Nr), Mi: Zero(k, k)}, **SIZES)],
      note="Full rank is said through left and right inverses, complex ones by real and imaginary part.")


def invertible_at(id, title, sign, note):
    """A null vector of M + sign z N at a point z = a + ib of the circle is zero, given both ranks at this point."""
    re, im = F + sign * a * K, sign * b * K
    matrix_ = real_form(block([[re, -G], [Zero(n, n), T(K) + sign * a * T(F)]]), block([[im, Zero(k, k)], [Zero(n, n), sign * b * T(F)]]))
    ranks = [given("F + zK has full column rank", (Lr * re - Li * im == Identity(n)) & (Lr * im + Li * re == Zero(n, n))),
             given("[F + zK, G] has full row rank", (re * Nr - im * Ni + G * Mr == Identity(k)) & (re * Ni + im * Nr + G * Mi == Zero(k, k)))]
    equation = given("null vector", matrix_ * vstack(u1, v1, u2, v2) == Zero(2 * (k + n), 1))
    lemmas = [T(re) * v1 + T(im) * v2 == ZERO_N, T(re) * v2 - T(im) * v1 == ZERO_N, (T(v1) * G * v1 + T(v2) * G * v2) * Identity(1) == Zero(1, 1),
              G * v1 == ZERO_K, G * v2 == ZERO_K]
    made = {**POINT, K: F * X0, L: inv(T(F) * F) * T(F), u1: Zero(n, 1), u2: Zero(n, 1), v1: Zero(k, 1), v2: Zero(k, 1),
            H1: inv(real_form(Identity(n) + sign * a * X0, sign * b * X0)), Lr: T(upper(n, n)) * H1 * upper(n, n) * L,
            Li: T(lower(n, n)) * H1 * upper(n, n) * L, Nr: Lr, Ni: Li, Mr: inv(G) * (Identity(k) - re * Nr + im * Ni), Mi: -inv(G) * (re * Ni + im * Nr)}
    claim(id, title, (u1 == ZERO_N) & (u2 == ZERO_N) & (v1 == ZERO_K) & (v2 == ZERO_K), sizes=["k", "n"],
          over={**PENCIL, a: scalar(), b: scalar(), **NULL, **RANKS}, given=[*ranks, ON_CIRCLE, equation],
          by=[order([], [], [], ENERGY, ENERGY, lemmas=lemmas), *POINT_FOILS[sign],
              instances(made_by=made, using={X0: matrix(n, n), t0: scalar(), L: matrix(n, k)}, **SIZES)], note=note)


H1 = sym("H1")
#: without full column rank, full row rank, the circle, the equation
POINT_FOILS = {sign: [example({**ONE_POINT, K: [[0]], F: [[1]], a: 1, b: 0, **change}) for change in (
    {F: [[0]], Lr: [[0]], Nr: [[0]], Mr: [[1]], G: [[1]], u1: [1]},
    {"k": 2, F: [[1], [0]], K: [[0], [0]], G: [[0, 0], [0, 0]], v1: [0, 1], v2: [0, 0], Lr: [[1, 0]], Li: [[0, 0]], Nr: [[0, 0]], Ni: [[0, 0]],
     Mr: [[0, 0], [0, 0]], Mi: [[0, 0], [0, 0]]},
    {F: [[1]], K: [[-2 * sign]], a: 2, b: 0, Lr: [["-1/3"]], Nr: [["-1/3"]], G: [[1]], Mr: [[0]], u1: ["-1/3"], v1: [1]},
    {u1: [1]})] for sign in (1, -1)}
CIRCLE_NOTE = ("Invertible is said as: a null vector (u; v) is zero; (u; v) = (u1; v1) + i(u2; v2), z = a + ib, and the matrix is the real form "
               "[X, -Y; Y, X] of X + iY. Detectability and stabilizability enter by the ranks they give at this point.")
invertible_at("NWL92-L5.1", "the pencil is regular and has no eigenmode on the unit circle", -1,
              CIRCLE_NOTE + " A determinant that is not zero on the circle is not the zero polynomial, which is regularity.")
invertible_at("NWL92-E5.5", "the matrix (5.5) is invertible at every point of the unit circle", 1, CIRCLE_NOTE)

# ------------------------------------------------------------------ Lemma 5.2
s, t = symbols("s t")
ANY = {F: matrix(k, n), K: matrix(k, n), G: symmetric_matrix(k)}
NONZERO = {**ANY, s: nonzero(), t: nonzero()}
STEPS_2 = steps("NWL92-L5.1", "NWL92-E5.13", "NWL92-E5.15", facts=["the degree of a determinant in s and t together is its size"],
                prose=("By (5.15) eigenmodes other than zero and infinity come in pairs z, 1/z, and there are k - n more at infinity than at zero; "
                       "none is on the circle (Lemma 5.1), and there are n + k in all."))
claim("NWL92-L5.2", "the pencil has exactly n stable eigenmodes",
      inside_roots(CHARACTERISTIC) == n, sizes=["k", "n"], over={**PENCIL, **CERTIFICATES}, where=[CHI],
      given=[DETECTABLE, STABILIZABLE], by=[STEPS_2, *FOILS, systems()], note=CERTIFIED)


def first(s, t):
    """p(s, t) by its definition, the first member of (5.11)."""
    return det(s * M_PENCIL + t * N_PENCIL)


def rows_exchanged(s, t):
    """The matrix of the second member of (5.11), with block rows exchanged."""
    return (s * block([[Zero(n, n), T(K)], [F, -G]]) + t * block([[Zero(n, n), T(F)], [K, Zero(k, k)]]))


def second(s, t):
    """The second member of (5.11)."""
    return det(rows_exchanged(s, t))


def third(s, t):
    """The third member of (5.11)."""
    return det(block([[Zero(n, n), s * T(K) + t * T(F)], [s * F + t * K, -s * G]]))


#: l = 2, p = 1, n = 1, E = (1; 0), A = C = 0, G = I
ODD = {"k": 3, "n": 1, F: [[1], [0], [0]], K: [[0], [0], [0]], G: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], s: 1, t: 1}
#: exchanges the block rows, and the determinants of the members of (5.11) with it
EXCHANGE = block([[Zero(n, k), Identity(n)], [Identity(k), Zero(k, n)]])
TURN = sym("turn")
TURNED_TWICE = (Identity(n + k), [EXCHANGE, T(EXCHANGE)])
ROWS_SIGN = "exchanging k rows with n rows multiplies the determinant by that of the exchange, which is -1 if k and n are odd"


def with_sign(s, t):
    """(5.11) with the determinant of the exchange, which is 1 or -1."""
    return eq(first(s, t), TURN * second(s, t), TURN * third(s, t)) & (TURN * TURN == 1)


def exchanged(s, t):
    """The determinants of the members of (5.11)."""
    return order(factors=[TURNED_TWICE, (rows_exchanged(s, t), [EXCHANGE, s * M_PENCIL + t * N_PENCIL])])


ANY_POINT = {"sizes": ["k", "n"], "over": {**ANY, s: scalar(), t: scalar()}}
LET_TURN = [let(TURN, det(EXCHANGE))]
claim("NWL92-E5.11", "three forms of p(s, t)",
      eq(first(s, t), second(s, t), third(s, t)), **ANY_POINT,
      by=[example(ODD), instances(**SIZES)],
      repair=repair("sign", ROWS_SIGN, with_sign(s, t), **ANY_POINT, where=LET_TURN, by=[exchanged(s, t), instances(**SIZES)]))

claim("NWL92-E5.12", "p(t, s)",
      eq(first(t, s), second(t, s), third(t, s)), **ANY_POINT,
      by=[example(ODD), instances(**SIZES)],
      repair=repair("sign", ROWS_SIGN, with_sign(t, s), **ANY_POINT, where=LET_TURN, by=[exchanged(t, s), instances(**SIZES)]),
      note="p(t, s) is that of (5.11): its first member with s and t exchanged.")


def inner(s, t):
    """The matrix of (5.13)."""
    return block([[Zero(n, n), s * T(K) + t * T(F)], [s * F + t * K, -s * G]])


def scaled(first, second):
    """diag(first I, second I)."""
    return block([[first * Identity(n), Zero(n, k)], [Zero(k, n), second * Identity(k)]])


claim("NWL92-E5.13", "the matrices of p(s, t) and p(t, s) are equal up to scaling of rows and columns",
      scaled(1, t) * inner(s, t) * scaled(1 / t, 1) == scaled(1, s) * T(inner(t, s)) * scaled(1 / s, 1),
      sizes=["k", "n"], over=NONZERO, by=[identity(k=(1, 2, 3), n=(1, 2)), instances(**SIZES)])

#: both sides of (5.13) have one determinant, and so have the members of (5.11), up to that of the exchange
SCALED = scaled(1, t) * inner(s, t) * scaled(1 / t, 1)
DETERMINANTS = [(SCALED, [scaled(1, t), inner(s, t), scaled(1 / t, 1)]), (SCALED, [scaled(1, s), T(inner(t, s)), scaled(1 / s, 1)]),
                TURNED_TWICE, (inner(s, t), [EXCHANGE, s * M_PENCIL + t * N_PENCIL]), (inner(t, s), [EXCHANGE, t * M_PENCIL + s * N_PENCIL])]
claim("NWL92-E5.14", "determinants of (5.13)",
      t ** k * first(s, t) * t ** (-n) == s ** k * first(t, s) * s ** (-n), sizes=["k", "n"], over=NONZERO,
      by=[order(factors=DETERMINANTS), instances(**SIZES)], note="The sign in (5.11) is the same on both sides.")

claim("NWL92-E5.15", "p(s, t) and p(t, s)",
      t ** (k - n) * first(s, t) == s ** (k - n) * first(t, s), **ANY_POINT,
      by=[order(factors=DETERMINANTS, away_from_zero=[s, t]), example({"k": 2, "n": 1, F: [[1], [0]], K: [[0], [1]], G: [[1, 0], [0, 1]], s: 1, t: 0}),
          instances(**SIZES)],
      note="For all s and t for which both sides have a value: those other than zero, and for k >= n zero too, where both sides are polynomials.")

# ------------------------------------------------------------------ the stable eigenspace
EIGENSPACE = {**PENCIL, X: matrix(n, n), Y: matrix(k, n), J: matrix(n, n)}
RELATION = given("(5.18)", M_PENCIL * vstack(X, Y) == N_PENCIL * vstack(X, Y) * J)
E25 = given("(5.25)", F * X - G * Y == K * X * J)
E26 = given("(5.26)", T(K) * Y == T(F) * Y * J)
FIRST_RELATIONS = [E25, E26]
B0, V, W0, k1, k2 = symbols("B0 V W0 k1 k2")
#: from a solution P of the Riccati equation in coordinates: F = V[I; 0], N = V diag(P, *)V', K = V[k1; k2]; X = P W0, Y = V'^-1 [W0; 0]
SPACE_MADE = {k1: B0 * X0 * (1 / (1 + trace(X0 * T(X0)))) * inv(B0), P: B0 * T(B0),
              G: V * block([[P - k1 * P * T(k1), -k1 * P * T(k2)],
                            [-k2 * P * T(k1), k2 * P * T(k1) * one_inverse(P - k1 * P * T(k1)) * k1 * P * T(k2) + M0]]) * T(V),
              F: V * vstack(Identity(n), Zero(k - n, n)), K: V * vstack(k1, k2), X: P * W0, Y: T(inv(V)) * vstack(W0, Zero(k - n, n)),
              J: inv(W0) * T(k1) * W0}
SPACE_FREE = {X0: matrix(n, n), B0: nonsingular(n), V: nonsingular(k), k2: matrix(k - n, n), M0: positive_semidefinite(k - n), W0: nonsingular(n),
              P: symmetric_matrix(n)}
SPACE_SIZES = {"k": (2, 3), "n": (1, 2)}


def spaces(made_by=None, using=None, count=16):
    """Stable eigenspaces of the pencil, for k > n."""
    return instances(count, made_by={**SPACE_MADE, **(made_by or {})}, using={**SPACE_FREE, **(using or {})}, **SPACE_SIZES)


claim("NWL92-E5.25", "first block row of the eigenspace relation",
      F * X - G * Y == K * X * J, sizes=["k", "n"], over=EIGENSPACE, given=[RELATION], by=[spaces()],
      note="(5.18) is read with the pencil (5.3) and with the factor J on the right, which it does not print.")

claim("NWL92-E5.26", "second block row of the eigenspace relation",
      T(K) * Y == T(F) * Y * J, sizes=["k", "n"], over=EIGENSPACE, given=[RELATION], by=[spaces()],
      note="(5.18) is read with the pencil (5.3) and with the factor J on the right, which it does not print.")

YFX = T(Y) * F * X
#: n = k = 1; not admissible: what (5.25) and (5.26) are for
UNRELATED = {"k": 1, "n": 1, F: [[1]], K: [[0]], G: [[1]], X: [[1]], Y: [[1]], J: [[0]]}
claim("NWL92-E5.27", "Lyapunov equation of Y'FX",
      YFX == T(Y) * G * Y + T(J) * YFX * J, sizes=["k", "n"], over=EIGENSPACE, given=FIRST_RELATIONS,
      by=[spaces(), instances(k=1, n=1)])

w, h, h2 = symbols("w h h2")
LYAPUNOV = given("(5.27)", YFX == T(Y) * G * Y + T(J) * YFX * J)
NULL_W = given("F'Yw = 0", T(F) * Y * w == Zero(n, 1))
STABLE = given("J stable", schur(J))
#: Y'FX is nonnegative, as J is stable; w'Y'F = 0, so that w times (5.27) times w leaves 0 = (Yw)'G(Yw) + (Jw)'Y'FX(Jw)
NONNEGATIVE, FORMS = psd(YFX), [T(Y) * G * Y, T(J) * YFX * J]
NULL_ENERGY = order([T(Y) * G * Y], FORMS, lemmas=[NONNEGATIVE], inside=[within(0, stein=T(J))])

#: a system in which F'Y is singular: the second state neither noise nor gain; k = 2, n = 2
d0, d1, d2 = symbols("d0 d1 d2")
HALF = instances(made_by={k1: B0 * X0 * (1 / (1 + trace(X0 * X0))) * inv(B0), P: B0 * T(B0), F: V * Identity(n), K: V * k1,
                          G: V * (P - k1 * P * T(k1)) * T(V), W0: T(inv(B0)) * block([[1, 0], [0, 0]]) * d0, X: P * W0, Y: T(inv(V)) * W0,
                          J: block([[(X0 * (1 / (1 + trace(X0 * X0))))[1, 1], 0], [d1, d2 * d2 / (1 + d2 * d2)]]), w: vstack(0, d1)},
                 using={V: nonsingular(k), X0: diagonal(n), B0: nonsingular(n), d0: scalar(), d1: scalar(), d2: scalar()}, k=2, n=2)
#: no relation to a system at all: Y'FX of either sign, J not stable
ONE = {"k": 1, "n": 1, F: [[0]], K: [[0]], G: [[1]], X: [[0]], Y: [[1]], J: [[0]], w: [1]}
W_FOILS = [example(ONE), example({**ONE, F: [[1]], X: [[1]]}), example({**ONE, F: [[1]], Y: [[1]], X: [[1]], w: [1], J: [[0]]})]
claim("NWL92-E5.28", "F'Yw = 0 gives GYw = 0",
      G * (Y * w) == Zero(k, 1), sizes=["k", "n"], over={**EIGENSPACE, w: vector(n)},
      given=[LYAPUNOV, NULL_W, standing("J stable", schur(J))],
      by=[NULL_ENERGY, *W_FOILS, HALF, spaces({w: Zero(n, 1)})])

claim("NWL92-E5.29", "F'Yw = 0 gives w'Y'[F, G] = 0",
      T(w) * T(Y) * hstack(F, G) == Zero(1, n + k), sizes=["k", "n"], over={**EIGENSPACE, w: vector(n)},
      given=[LYAPUNOV, NULL_W, standing("J stable", schur(J))],
      by=[NULL_ENERGY, *W_FOILS, HALF, spaces({w: Zero(n, 1)})])

claim("NWL92-S47", "stabilizability gives [F, G] full row rank",
      rank(hstack(F, G)) == k, sizes=["k", "n"], over=PENCIL,
      given=[given("stabilizable at (s, t) = (1, 0)", rank(real_form(hstack(1 * F - 0 * K, G), hstack(0 * F - 0 * K, 0 * G))) == 2 * k)],
      by=[order(inside=[within(0, T(null_vector()) * hstack(F, G) == Zero(1, n + k),
                               hstack(T(null_vector()), Zero(1, k)) * real_form(hstack(F, G), 0 * hstack(F, G)) == Zero(1, n + k + n + k),
                               hstack(T(null_vector()), Zero(1, k)) == Zero(1, k + k), vector="left")]),
          example({"k": 1, "n": 1, F: [[0]], K: [[0]], G: [[0]]}), instances(k=(1, 2, 3), n=(1, 2))],
      note="[sF - tK, G] of Definition 4.1 at the point (1, 0), in real form, as at every complex point; the other points are not used.")

claim("NWL92-E5.30", "Yw = 0",
      Y * w == Zero(k, 1), sizes=["k", "n"], over={F: matrix(k, n), G: positive_semidefinite(k), Y: matrix(k, n), w: vector(n), **ROW_INVERSE},
      given=[given("(5.29)", T(w) * T(Y) * hstack(F, G) == Zero(1, n + k)), FULL_ROW],
      by=[example({"k": 1, "n": 1, F: [[0]], G: [[0]], Y: [[1]], w: [1], N1: [[0]], N2: [[0]]}),
          example({"k": 1, "n": 1, F: [[1]], G: [[0]], Y: [[1]], w: [1], N1: [[1]], N2: [[0]]}),
          instances(made_by={N1: GRAM_INVERSE, N2: inv(G) * (Identity(k) - F * N1), w: h - one_inverse(T(Y) * Y) * T(Y) * Y * h},
                    using={h: vector(n)}, k=(1, 2), n=(1, 2, 3))])

claim("NWL92-E5.31", "the null space of F'Y is J-invariant",
      T(F) * Y * J * w == Zero(n, 1), sizes=["k", "n"], over={F: matrix(k, n), K: matrix(k, n), Y: matrix(k, n), J: matrix(n, n), w: vector(n)},
      given=[E26, given("(5.30)", Y * w == Zero(k, 1))],
      by=[example({"k": 1, "n": 1, F: [[1]], K: [[0]], Y: [[1]], J: [[1]], w: [1]}), example({"k": 1, "n": 2, F: [[1, 0]], K: [[0, 0]], Y: [[0, 1]],
                                                                                             J: [[0, 0], [1, 0]], w: [1, 0]}),
          instances(made_by={w: h - one_inverse(T(Y) * Y) * T(Y) * Y * h, K: T(T(F) * Y * J * one_inverse(T(Y) * Y) * T(Y))}, using={h: vector(n)}, k=(1, 2), n=(2, 3))],
      note="By (5.30) a null vector of F'Y is one of Y.")

NULL, Nb, Mb, OFF = symbols("N Nb Mb Off")
FY = T(F) * Y
#: the matrix of J in the columns of N, which span the null space of F'Y
IN_NULL = inv(T(NULL) * NULL) * T(NULL) * J * NULL
claim("NWL92-E5.32", "if F'Y is singular, J has an eigenvector in its null space",
      observable(FY, J) >> invertible(FY), sizes=["k", "n"], over={F: matrix(k, n), Y: matrix(k, n), J: matrix(n, n)},
      where=[let(NULL, kernel_basis(FY))], given=[given("the null space is J-invariant", FY * J * NULL == 0 * (T(F) * Y * NULL))],
      by=[order([T(NULL) * NULL], [IN_NULL], [], lemmas=[invertible(T(NULL) * NULL)], inside=[within(1, NULL == 0 * NULL, vector="right", kept=(FY, J, IN_NULL), on=0)]),
          example({"k": 2, "n": 2, F: [[1, 0], [0, 1]], Y: [[1, 0], [0, 0]], J: [[0, 1], [1, 0]]}),
          instances(k=(1, 2), n=(1, 2)),
          *(instances(made_by={Mb: inv(T(Nb) * Nb) * T(Nb), OFF: Identity(n) - Nb * Mb, Y: X1 * OFF, J: Nb * B0 * Mb + X2 * OFF},
                      using={Nb: matrix(n, q), B0: matrix(q, q), X1: matrix(k, n), X2: matrix(n, n)}, k=(2, 3), n=(2, 3)) for q in (1, 2))],
      note=("Said the other way round: if no eigenvector of J, real or complex, lies in the null space of F'Y, then F'Y is nonsingular. (F'Y, J) observable means "
            "that there is no such w, and the columns of N are a basis of the null space."))

w1, w2 = symbols("w1 w2")
EIGEN = [given("(5.32), real part", J * w1 == a * w1 - b * w2), given("(5.32), imaginary part", J * w2 == b * w1 + a * w2)]
ANNIHILATED = [given("Yw1 = 0", Y * w1 == Zero(k, 1)), given("Yw2 = 0", Y * w2 == Zero(k, 1))]
W_PAIR = {a: scalar(), b: scalar(), w1: vector(n), w2: vector(n)}
#: J w = lam w for n = 2 and J = [a, b; -b, a] in other coordinates, FX = GY + KXJ made by the choice of K's multiple
TURNED = {J: B0 * block([[a, b], [-b, a]]) * inv(B0), w1: B0 * vstack(d1, -d2), w2: B0 * vstack(d2, d1), Y: Zero(k, n),
          F: K * X * J * inv(X)}
claim("NWL92-E5.33", "(F - lam K)Xw = 0",
      (F * X * w1 - K * X * (a * w1 - b * w2) == Zero(k, 1)) & (F * X * w2 - K * X * (b * w1 + a * w2) == Zero(k, 1)),
      sizes=["k", "n"], over={**EIGENSPACE, **W_PAIR}, given=[E25, *ANNIHILATED, *EIGEN],
      by=[combination([[(1, "(5.25)", w1), (G, "Yw1 = 0", 1), (K * X, "(5.32), real part", 1)],
                       [(1, "(5.25)", w2), (G, "Yw2 = 0", 1), (K * X, "(5.32), imaginary part", 1)]], k=(1, 2), n=(1, 2)),
          *[example({"k": 1, "n": 1, F: [[f]], K: [[q]], G: [[g]], X: [[1]], Y: [[y]], J: [[j]], a: 0, b: 0, w1: [e], w2: [1 - e]})
            for f, q, g, y, j, e in ((1, 0, 0, 0, 0, 1), (1, 0, 1, 1, 0, 1), (1, 0, 1, 1, 0, 0), (1, 1, 0, 0, 1, 1), (1, 1, 0, 0, 1, 0))],
          instances(made_by=TURNED, using={B0: nonsingular(n), d1: scalar(), d2: scalar()}, k=(1, 2, 3), n=2)])

LEFT = given("F - lam K has full column rank", (Lr * (F - a * K) + Li * (b * K) == Identity(n)) & (Li * (F - a * K) - Lr * (b * K) == Zero(n, n)))
E33 = [given("(5.33), real part", F * X * w1 - K * X * (a * w1 - b * w2) == Zero(k, 1)),
       given("(5.33), imaginary part", F * X * w2 - K * X * (b * w1 + a * w2) == Zero(k, 1))]
XW = {"k": 1, "n": 1, F: [[1]], K: [[0]], X: [[1]], Lr: [[1]], Li: [[0]], a: 0, b: 0, w1: [0], w2: [0]}
claim("NWL92-E5.34", "Xw = 0",
      (X * w1 == Zero(n, 1)) & (X * w2 == Zero(n, 1)), sizes=["k", "n"],
      over={F: matrix(k, n), K: matrix(k, n), X: matrix(n, n), Lr: matrix(n, k), Li: matrix(n, k), **W_PAIR}, given=[LEFT, *E33],
      by=[example({**XW, w1: [1]}), example({**XW, w2: [1]}), example({**XW, F: [[0]], w1: [1]}),
          instances(made_by={Lr: GRAM_INVERSE, Li: Zero(n, k), b: 0, a: 0, sym("kx"): kernel_basis(X), w1: sym("kx") * T(sym("kx")) * h,
                             w2: sym("kx") * T(sym("kx")) * h2}, using={h: vector(n), h2: vector(n)}, k=(1, 2, 3), n=(1, 2))],
      note="Detectability with |lam| < 1 says that F - lam K has full column rank, here through a left inverse Lr + iLi.")

Z1, Z2 = symbols("Z1 Z2")
claim("NWL92-E5.35", "(X; Y)w = 0 gives w = 0",
      (vstack(X, Y) * w == Zero(n + k, 1)) & (w == Zero(n, 1)), sizes=["k", "n"],
      over={X: matrix(n, n), Y: matrix(k, n), Z1: matrix(n, n), Z2: matrix(n, k), w: vector(n)},
      given=[given("(5.34)", X * w == Zero(n, 1)), given("(5.30)", Y * w == Zero(k, 1)),
             given("(X; Y) has full column rank", Z1 * X + Z2 * Y == Identity(n))],
      by=[example({"k": 1, "n": 1, X: [[1]], Y: [[0]], Z1: [[1]], Z2: [[0]], w: [1]}), example({"k": 1, "n": 1, X: [[0]], Y: [[1]], Z1: [[0]], Z2: [[1]], w: [1]}),
          example({"k": 1, "n": 1, X: [[0]], Y: [[0]], Z1: [[0]], Z2: [[0]], w: [1]}),
          instances(made_by={Z1: inv(T(X) * X + T(Y) * Y) * T(X), Z2: inv(T(X) * X + T(Y) * Y) * T(Y), w: Zero(n, 1)}, k=(1, 2), n=(1, 2))],
      note="Full column rank is said through a left inverse.")

FULL_BASIS = given("(X; Y) has full column rank", rank(vstack(X, Y)) == n)
(er, ei), (lr, li) = EIGENVECTOR, EIGENVALUE


def full_rows(F, K, G):
    """The pencil whose detectability is that (sF - tK, G) has full row rank."""
    return T(hstack(F, G)), T(hstack(K, 0 * G))


def invertible_proof(F, K, G, X, Y, J, start=0, rows=None):
    """F'Y is invertible: terms, lemmas and their help, for leaves counted from ``start``.

    N spans the null space of F'Y, on which J acts as JN = N J N. By (5.28) to (5.30) Y N = 0; by (5.31) the null space is invariant; JN is stable, as its
    eigenvectors are those of J; F X N = K X N JN by (5.33) gives X N = 0.
    """
    N = kernel_basis(T(F) * Y)
    gram, outside = T(N) * N, lr * lr + li * li - 1
    JN, form = inv(gram) * T(N) * J * N, T(Y) * F * X
    parts = N * er, N * ei
    needs = [[T(Y) * G * Y], [T(N) * T(Y) * G * Y * N, T(N) * T(J) * form * J * N], [], [], [gram], [],
             [], [], [T(x) * x for x in parts] + [outside * T(x) * BOUND * x for x in parts], [], []]
    lemmas = [psd(form), G * (Y * N) == 0 * (Y * N), Y * N == 0 * (Y * N), T(F) * Y * J * N == 0 * N, invertible(gram), J * N == N * JN, schur(JN),
              X * N == 0 * (X * N)]
    eigenvector = [J * parts[0] == lr * parts[0] - li * parts[1], J * parts[1] == li * parts[0] + lr * parts[1], hstack(*parts) == Zero(n, 2)]
    inside = [within(start, stein=T(J)), within(start + 2, pencil=rows or full_rows(F, K, G)),
              within(start + 6, *eigenvector, vector="right", solutions={BOUND: (T(J), Identity(n))}, on=2), within(start + 7, pencil=(F, K, JN))]
    return needs, lemmas, inside


_needs, _lemmas, _inside = invertible_proof(F, K, G, X, Y, J)
INVERTIBLE_PROOF = order(*_needs, lemmas=_lemmas, inside=_inside)
#: Definition 4.1
BOTH = [standing("detectable", detectable(F, K)), given("stabilizable", detectable(*full_rows(F, K, G)))]
claim("NWL92-S49", "F'Y is invertible",
      invertible(T(F) * Y), sizes=["k", "n"], over=EIGENSPACE,
      given=[standing("(5.25)", F * X - G * Y == K * X * J), standing("(5.26)", T(K) * Y == T(F) * Y * J), STABLE, FULL_BASIS, *BOTH],
      by=[INVERTIBLE_PROOF,
          example({"k": 1, "n": 1, F: [[1]], K: [["1/2"]], G: [[0]], X: [[1]], Y: [[0]], J: [[2]]}),
          example({"k": 1, "n": 1, F: [[1]], K: [["1/2"]], G: [[0]], X: [[0]], Y: [[0]], J: [[0]]}),
          example({"k": 2, "n": 1, F: [[1], [0]], K: [["1/2"], [0]], G: [[0, 0], [0, 0]], X: [[0]], Y: [[0], [1]], J: [[0]]}), spaces()])

FY = T(F) * Y
INNER = G + K * X * inv(FY) * T(K)
claim("NWL92-E5.36", "the first block row without J",
      F * X == INNER * Y, sizes=["k", "n"], over=EIGENSPACE, given=FIRST_RELATIONS,
      by=[example({**UNRELATED, F: [[2]]}), example({**UNRELATED, K: [[1]]}), spaces(), instances(k=1, n=1)])

claim("NWL92-E5.37", "the Riccati equation in block form",
      block([[INNER, F], [T(F), Zero(n, n)]]) * vstack(Y, -X) == vstack(Zero(k, n), FY), sizes=["k", "n"], over=EIGENSPACE, given=FIRST_RELATIONS,
      by=[example({**UNRELATED, F: [[2]]}), example({**UNRELATED, K: [[1]]}), spaces()])

claim("NWL92-E5.38", "the Riccati equation solved for (Y; -X)",
      vstack(Y, -X) * inv(FY) == inv(block([[INNER, F], [T(F), Zero(n, n)]])) * vstack(Zero(k, n), Identity(n)),
      sizes=["k", "n"], over=EIGENSPACE, given=FIRST_RELATIONS,
      by=[example({**UNRELATED, F: [[2]]}), example({**UNRELATED, K: [[1]]}), spaces()],
      note="The inverse exists as [F, G] has full row rank and F full column rank.")

OWN = X * inv(FY)


def equation_39(P, extra):
    """(5.39) with P in place of X(F'Y)^-1, and a factor after KPK'."""
    inside = K * P * T(K) if extra is None else K * P * T(K) * extra
    return -(hstack(Zero(n, k), Identity(n)) * inv(block([[G + inside, F], [T(F), Zero(n, n)]])) * vstack(Zero(k, n), Identity(n)))


#: F = 2, K = 1, G = 3, Y = 1, X = 2, J = 1/2, P = 1
SCALAR = {"k": 1, "n": 1, F: [[2]], K: [[1]], G: [[3]], X: [[2]], Y: [[1]], J: [["1/2"]]}
claim("NWL92-E5.39", "P = X(F'Y)^-1 satisfies the Riccati equation, as printed",
      OWN == equation_39(OWN, F), sizes=["k", "n"], over=EIGENSPACE, given=FIRST_RELATIONS,
      by=[example(SCALAR), spaces()],
      repair=repair("factor", "a factor F stands after KPK', where its size does not even fit unless F is square",
                    X * Identity(n) * inv(FY) == equation_39(OWN, None), sizes=["k", "n"], over=EIGENSPACE, given=FIRST_RELATIONS,
                    by=[example({**UNRELATED, F: [[2]]}), example({**UNRELATED, K: [[1]]}), spaces()]),
      note="The letter F stands twice at the border of two blocks; with one of them the display is the corrected statement.")

claim("NWL92-S50", "Y'FX solves (5.39) and is nonnegative",
      (YFX == equation_39(YFX, None)) & psd(YFX), sizes=["k", "n"], over=EIGENSPACE, given=[*FIRST_RELATIONS, STABLE],
      by=[example(SCALAR), spaces()],
      repair=repair("cross-reference", "the Lyapunov equation is (5.27); (5.39) is the Riccati equation",
                    (YFX == T(Y) * G * Y + T(J) * YFX * J) & psd(YFX), sizes=["k", "n"], over=EIGENSPACE,
                    given=[standing("(5.25)", F * X - G * Y == K * X * J), standing("(5.26)", T(K) * Y == T(F) * Y * J), STABLE],
                    by=[order([], [T(Y) * G * Y], inside=[within(1, stein=T(J))]), example({**UNRELATED, F: [[2]]}), example({**UNRELATED, J: [[1]]}),
                        example({"k": 1, "n": 1, F: [[1]], K: [[2]], G: [[3]], X: [[-1]], Y: [[1]], J: [[2]]}), spaces()]),
      note="(5.39) is taken without its stray factor F.")

claim("NWL92-E5.40", "P is a congruence of Y'FX and nonnegative",
      (OWN == T(inv(FY)) * YFX * inv(FY)) & psd(OWN), sizes=["k", "n"], over=EIGENSPACE,
      given=[given("Y'FX >= 0", psd(YFX))],
      by=[order([], [T(inv(FY)) * YFX * inv(FY)]), spaces(), example({**UNRELATED, X: [[-1]]})])
