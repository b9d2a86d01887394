# SPDX-License-Identifier: MIT
"""Section V: counting eigenmodes, and Theorem 5.1 with the displays that lead to it.

The determinant chi(z) of M - zN has degree n + k less the number of infinite
eigenmodes, and begins with z to the number of zero eigenmodes. The symmetry
(5.15) pairs the others, z with 1/z, and gives k - n more at infinity than at
zero. With none on the unit circle, n are inside.

Let the columns of (X; Y) span the stable eigenspace, FX - GY = KXJ and
K'Y = F'YJ with stable J, and let P >= 0 solve the Riccati equation: there are
gains U with F'U = I and (KPK' + G)U = FP. Then D = X - PF'Y satisfies

    U'(FX - GY - KXJ) = 0,   that is   D = (U'K)DJ,

and as U'K is stable, D = 0: P = X(F'Y)^-1, where F'Y = E'Y1 + C'Y2. The paper
prints E'Y1 + C'Y1 and FY; and (5.18) without J, with the sign of S reversed.

U'K is stable, as in Theorem 4.3: a left eigenvector v with |lam| >= 1 has
v'U'G = 0, hence v'U' = v'N1 for the right inverse F N1 + G N2 = I, and v'N1 is
a left eigenvector of the stable K N1.
"""

from __future__ import annotations

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import EIGENVALUE, EIGENVECTOR, combination, example, instances, order, steps, within
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    block,
    circle_roots,
    degree,
    det,
    detectable,
    given,
    hstack,
    inside_roots,
    inv,
    invertible,
    let,
    matrix,
    nonsingular,
    outside_roots,
    positive_semidefinite,
    psd,
    rank,
    rational,
    rev,
    scalar,
    schur,
    standing,
    sym,
    symbols,
    trace,
    vstack,
)
from proofs.nwl92 import notation_system as system
from proofs.nwl92.notation import lower, upper
from proofs.nwl92.section_5 import (
    BOTH,
    M_PENCIL,
    N_PENCIL,
    PENCIL,
    SPACE_FREE,
    SPACE_MADE,
    F,
    G,
    K,
    V,
    full_rows,
    invertible_proof,
    systems,
)

DEFINITION = "a definition: it fixes notation and asserts nothing"
l, p, n, k = symbols("l p n k")

not_checked("NWL92-E5.1", "the pencil", DEFINITION)
not_checked("NWL92-E5.2", "the notation F, K, G", DEFINITION)

# ------------------------------------------------------------------ eigenmodes
CHI = sym("chi")
LET_CHI = let(CHI, det(M_PENCIL - Z * N_PENCIL))
REGULAR = given("regular", CHI != 0)
AT_ZERO, AT_INFINITY = n + k - degree(rev(CHI, n + k)), n + k - degree(CHI)
INSIDE, OUTSIDE = inside_roots(CHI) - AT_ZERO, outside_roots(CHI)
COUNTED = "chi is det(M - zN): its roots are the finite eigenmodes, what its degree lacks of n + k is the number of infinite ones; k = l + p."
PAIRED = steps("NWL92-E5.15", facts=["the degree of a determinant in s and t together is its size"],
               prose=("p(s, t) is a form of degree n + k in s and t; by (5.15) its factor t^a s^b times others is carried into s^a t^b times those with s and t "
                      "exchanged, up to the factor (s/t)^(k-n)."))
DRAWN = instances(made_by={}, k=(1, 2, 3), n=(1, 2))
#: k = n = 1: F = G = 1, K = 2, an eigenmode at 2 and one at 1/2; K = 0: one at zero and one at infinity; F = G = 0: no regular pencil
SCALAR = {"k": 1, "n": 1, F: [[1]], K: [[2]], G: [[1]]}
CASES = [example(SCALAR), example({**SCALAR, K: [[0]]}), example({**SCALAR, F: [[0]]}), example({**SCALAR, "k": 2, F: [[1], [0]], K: [[0], [1]], G: [[1, 0], [0, 1]]}),
         example({"k": 3, "n": 1, F: [[1], [0], [0]], K: [[3], [0], [0]], G: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]})]
claim("NWL92-E5.16a", "as many stable eigenmodes other than zero as unstable finite ones",
      INSIDE == OUTSIDE, sizes=["k", "n"], over=PENCIL, where=[LET_CHI], given=[standing("regular", CHI != 0)], by=[PAIRED, *CASES, DRAWN, systems()], note=COUNTED)
claim("NWL92-E5.16b", "infinite and zero eigenmodes",
      AT_INFINITY - AT_ZERO == k - n, sizes=["k", "n"], over=PENCIL, where=[LET_CHI], given=[REGULAR],
      by=[PAIRED, *CASES, example({"k": 2, "n": 1, F: [[0], [0]], K: [[0], [0]], G: [[0, 0], [0, 0]]}), DRAWN, systems()], note=COUNTED)
claim("NWL92-E5.17", "the eigenmodes together",
      AT_ZERO + INSIDE + OUTSIDE + AT_INFINITY == n + k, sizes=["k", "n"], over=PENCIL, where=[LET_CHI],
      given=[standing("regular", CHI != 0), given("none on the unit circle", circle_roots(CHI) == 0)],
      by=[steps("NWL92-L5.1", facts=["a polynomial of degree d has d roots, counted with multiplicity"],
                prose="The finite eigenmodes are the roots of chi, the infinite ones what its degree lacks of n + k; none is on the unit circle (Lemma 5.1)."),
          *CASES, example({"k": 1, "n": 1, F: [[1]], K: [[1]], G: [[0]]}), DRAWN, systems()], note=COUNTED)

d0, ds, du, di = symbols("d0 ds du di")
half = rational("1/2")
claim("NWL92-S45", "(5.16) and (5.17) give n stable eigenmodes",
      d0 + ds == n, over={d0: scalar(), ds: scalar(), du: scalar(), di: scalar(), n: scalar(), k: scalar()},
      given=[given("(5.16a)", ds == du), given("(5.16b)", di - d0 == k - n), given("(5.17)", d0 + ds + du + di == n + k)],
      by=[combination([(half, "(5.16a)", 1), (-half, "(5.16b)", 1), (half, "(5.17)", 1)]), *[example({n: 1, k: 1, d0: a, ds: b, du: c, di: d}) for a, b, c, d in ((0, 2, 0, 0), (1, 1, 1, 0), (1, 1, 1, 1))],
          instances(made_by={ds: n - d0, du: ds, di: k - n + d0})],
      note="The numbers of zero, stable, unstable and infinite eigenmodes are d0, ds, du, di; k = l + p.")

# ------------------------------------------------------------------ the theorem
A, Q, S, R, E, C, P, X, Y1, Y2, J, U1, U2, W0 = symbols("A Q S R E C P X Ya Yb J U1 U2 W0")
TEX = {Y1: "Y_1", Y2: "Y_2"}
F_, K_, G_ = vstack(E, C), vstack(A, Zero(p, n)), system.NOISE_G
Y, U = vstack(Y1, Y2), vstack(U1, U2)
FY = T(E) * Y1 + T(C) * Y2
FIRST, SECOND = [given("(5.25)", F_ * X - G_ * Y == K_ * X * J), given("(5.26)", T(K_) * Y == FY * J)]
SPACE = {**system.SYSTEM, X: matrix(n, n), Y1: matrix(l, n), Y2: matrix(p, n), J: matrix(n, n)}
_k1, _V = symbols("k1 V")
MADE, FREE = system.solved()
Y_ALL, U_ALL = inv(T(_V)) * vstack(W0, Zero(l + p - n, n)), inv(T(_V)) * vstack(Identity(n), Zero(l + p - n, n))
MADE = {**MADE, X: P * W0, Y1: T(upper(l, p)) * Y_ALL, Y2: T(lower(l, p)) * Y_ALL, J: inv(W0) * T(_k1) * W0}
FREE = {**FREE, W0: nonsingular(n)}
SIZES = {"l": (1, 2), "p": (1, 2), "n": (1, 2)}
#: E = 2, A = 1, Q = 3, R = 1, C = S = 0: J = 1/2, P = 1
ONE = {"l": 1, "p": 1, "n": 1, E: [[2]], A: [[1]], Q: [[3]], S: [[0]], R: [[1]], C: [[0]], X: [[2]], Y1: [[1]], Y2: [[0]], J: [["1/2"]]}
#: the same with Q = 4, S = 1: with J on the right the printed relation fails by the sign of S
SIGNED = {**ONE, Q: [[4]], S: [[1]], Y2: [[1]]}
PRINTED_M = block([[E, -Q, -S], [C, -T(S), -R], [Zero(n, n), T(A), Zero(n, p)]])
RIGHT_M = block([[E, -Q, S], [C, T(S), -R], [Zero(n, n), T(A), Zero(n, p)]])
RIGHT_N = block([[A, Zero(l, l), Zero(l, p)], [Zero(p, n), Zero(p, l), Zero(p, p)], [Zero(n, n), T(E), T(C)]])
BASIS = vstack(X, Y1, Y2)
J_STABLE = given("J stable", schur(J))
claim("NWL92-E5.18", "the eigenspace relation, as printed without J and with -S",
      PRINTED_M * BASIS == RIGHT_N * BASIS, sizes=["l", "p", "n"], over=SPACE, tex=TEX, given=[FIRST, SECOND, J_STABLE],
      by=[example(SIGNED), instances(made_by=MADE, using=FREE, **SIZES)],
      repair=repair("factor", "the right side lacks the factor J, without which it says that all eigenmodes are one; and S has the sign that it has in (5.1)",
                    RIGHT_M * BASIS == RIGHT_N * BASIS * J, sizes=["l", "p", "n"], over=SPACE, given=[FIRST, SECOND],
                    by=[order(), example({**ONE, X: [[1]]}), example({**ONE, A: [[0]], X: [["3/2"]]}), instances(made_by=MADE, using=FREE, **SIZES)]),
      note="The relation is hypothesised in the form (5.25), (5.26), with F, K, G of (5.2) in blocks.")

# P solves the Riccati equation with the gains U
PSD = {P: positive_semidefinite(n), U1: matrix(l, n), U2: matrix(p, n)}
NOISE_P = K_ * P * T(K_) + G_
SOLVES = given("P solves (4.19)", (NOISE_P * U == F_ * P) & (T(F_) * U == Identity(n)))
GAPS = X - P * FY
THEOREM_NOTE = ("P solves (4.19) if (KPK' + G)(U1; U2) = (E; C)P and (U1' U2')(E; C) = I, as the last block column (U; -P) of the inverse of the 3-block matrix does. ")
#: E = C = R = 1, A = 2, Q = S = 0: the solutions 3/4 and 0, the modes 1/2 and 2
TWO = {"l": 1, "p": 1, "n": 1, E: [[1]], A: [[2]], Q: [[0]], S: [[0]], R: [[1]], C: [[1]], X: [[1]], Y1: [["1/3"]], Y2: [[1]], J: [["1/2"]], P: [["3/4"]],
       U1: [["1/4"]], U2: [["3/4"]]}
MADE_P = {**MADE, U1: T(upper(l, p)) * U_ALL, U2: T(lower(l, p)) * U_ALL}
DRAWN_P = instances(made_by=MADE_P, using=FREE, **SIZES)
(vr, vi), (lr, li) = EIGENVECTOR, EIGENVALUE
EXCESS = lr * lr + li * li - 1


def theorem_proof(F, K, G, X, Y, J, P, U, size):
    """U'K is stable, P F'Y = X, and F'Y is invertible.

    For an eigenvector v of (U'K)' outside the open disc v'U'G = 0 and v'U'(lam F - K) = 0, so that v'U' = 0 by stabilizability.
    """
    energies = [term for v in (vr, vi) for term in (T(v) * T(U) * G * U * v, EXCESS * T(v) * P * v)]
    ends, rows = hstack(U * vr, U * vi), full_rows(F, K, G)
    needs, lemmas, inside = invertible_proof(F, K, G, X, Y, J, start=2)
    unstable = within(0, sum(energies[1:], energies[0]) * Identity(1) == Zero(1, 1), *(T(v) * T(U) * G == Zero(1, size) for v in (vr, vi)), ends == Zero(size, 2),
                      vector="left", pencil=(*rows, lr, li), on=3)
    return order([], energies, energies, [], [T(v) * v for v in (vr, vi)] + [EXCESS * T(v) * v for v in (vr, vi)], [], *needs,
                 lemmas=[schur(T(U) * K), X - P * T(F) * Y == Zero(n, n), *lemmas], inside=[unstable, within(1, unique=(T(U) * K, J)), *inside])


FULL_BASIS = "(X; Y) has full column rank"
DETECTABLE, STABILIZABLE = standing("detectable", detectable(*system.DETECTABLE_PENCIL)), given("stabilizable", detectable(*system.STABILIZABLE_PENCIL))
#: E = C = R = 1, A = 2, Q = 7/2, S = 0: the solution 7/8, the modes 1/4 and 4
NOISY = {"l": 1, "p": 1, "n": 1, E: [[1]], A: [[2]], Q: [["7/2"]], S: [[0]], R: [[1]], C: [[1]], X: [[7]], Y1: [[1]], Y2: [[7]], J: [["1/4"]], P: [["7/8"]],
         U1: [["1/8"]], U2: [["7/8"]]}
#: A = 1, Q = 1, R = 2: both parts of F'Y are 1
EVEN = {**TWO, A: [[1]], Q: [[1]], R: [[2]], X: [[2]], Y1: [[1]], Y2: [[1]], J: [["1/2"]], P: [[1]], U1: [["1/2"]], U2: [["1/2"]]}
P_FOILS = [example({**TWO, P: [[0]], U1: [[1]], U2: [[0]]}), example(EVEN),
           *[example({**NOISY, **change}) for change in ({X: [[1]], Y1: [[-2]], Y2: [[1]], J: [[4]]}, {P: [[5]]}, {X: [[0]], Y1: [[0]], Y2: [[0]]})]]
claim("NWL92-E5.19", "the solution of the Riccati equation, as printed with Y_1 twice",
      P == X * inv(T(E) * Y1 + T(C) * Y1), sizes=["l", "p", "n"], over={**SPACE, **PSD}, tex=TEX,
      given=[FIRST, SECOND, J_STABLE, SOLVES, DETECTABLE, STABILIZABLE], by=[example(TWO), DRAWN_P],
      repair=repair("index", "the second Y_1 must be Y_2, as C' has p columns and F'Y = E'Y_1 + C'Y_2",
                    invertible(FY) & (P == X * inv(FY)), sizes=["l", "p", "n"], over={**SPACE, **PSD}, tex=TEX,
                    given=[standing("(5.25)", F_ * X - G_ * Y == K_ * X * J), standing("(5.26)", T(K_) * Y == FY * J), J_STABLE, SOLVES,
                           given(FULL_BASIS, rank(vstack(X, Y)) == n), standing("G is the covariance of (u, -r)", psd(G_)), DETECTABLE, STABILIZABLE],
                    by=[theorem_proof(F_, K_, G_, X, Y, J, P, U, l + p), *P_FOILS, DRAWN_P]),
      note=THEOREM_NOTE)

not_checked("NWL92-E5.20", "Y stands for (Y_1; Y_2)", DEFINITION)

# the same in the notation (5.2)
Yk, Uk, Xk, Jk, Pk = symbols("Y U X J P")
GENERAL = {**PENCIL, Xk: matrix(n, n), Yk: matrix(k, n), Jk: matrix(n, n), Pk: positive_semidefinite(n), Uk: matrix(k, n)}
GENERAL_GIVEN = [standing("(5.25)", F * Xk - G * Yk == K * Xk * Jk), standing("(5.26)", T(K) * Yk == T(F) * Yk * Jk), J_STABLE,
                 given(FULL_BASIS, rank(vstack(Xk, Yk)) == n), *BOTH, given("P solves (4.19)", ((K * Pk * T(K) + G) * Uk == F * Pk) & (T(Uk) * F == Identity(n)))]
GENERAL_DRAWN = instances(made_by={**SPACE_MADE, Uk: T(inv(V)) * vstack(Identity(n), Zero(k - n, n))}, using=SPACE_FREE, k=(2, 3), n=(1, 2))
#: F = 1 + e_12, K = 0, G = I: X = (F'F)^-1, Y = F'^-1
SQUARE = {"k": 2, "n": 2, F: [[1, 1], [0, 1]], K: [[0, 0], [0, 0]], G: [[1, 0], [0, 1]], Xk: [[2, -1], [-1, 1]], Yk: [[1, 0], [-1, 1]], Jk: [[0, 0], [0, 0]],
          Pk: [[2, -1], [-1, 1]], Uk: [[1, 0], [-1, 1]]}
#: the systems of TWO and NOISY
GENERAL_TWO = {"k": 2, "n": 1, F: [[1], [1]], K: [[2], [0]], G: [[0, 0], [0, 1]], Xk: [[1]], Yk: [["1/3"], [1]], Jk: [["1/2"]], Pk: [["3/4"]], Uk: [["1/4"], ["3/4"]]}
GENERAL_NOISY = {"k": 2, "n": 1, F: [[1], [1]], K: [[2], [0]], G: [["7/2", 0], [0, 1]], Xk: [[7]], Yk: [[1], [7]], Jk: [["1/4"]], Pk: [["7/8"]], Uk: [["1/8"], ["7/8"]]}
GENERAL_FOILS = [example({**GENERAL_TWO, Pk: [[0]], Uk: [[1], [0]]}),
                 *[example({**GENERAL_NOISY, **change}) for change in ({Xk: [[1]], Yk: [[-2], [1]], Jk: [[4]]}, {Pk: [[5]]}, {Xk: [[0]], Yk: [[0], [0]]})]]
GENERAL_PROOF = theorem_proof(F, K, G, Xk, Yk, Jk, Pk, Uk, k)
claim("NWL92-E5.21", "the solution of the Riccati equation in the notation (5.2), as printed with F for F'",
      Pk == Xk * inv(F * Yk), sizes=["k", "n"], over=GENERAL, given=GENERAL_GIVEN, by=[example(SQUARE), GENERAL_DRAWN],
      repair=repair("other", "the transpose of F is missing, without which the product does not exist unless F is square",
                    invertible(T(F) * Yk) & (Pk == Xk * inv(T(F) * Yk)), sizes=["k", "n"], over=GENERAL, given=GENERAL_GIVEN,
                    by=[GENERAL_PROOF, *GENERAL_FOILS, GENERAL_DRAWN]),
      note=THEOREM_NOTE)

# ------------------------------------------------------------------ Theorem 5.1
claim("NWL92-T5.1", "the solution of the Riccati equation from the stable eigenspace, as printed with (5.19)",
      P == X * inv(T(E) * Y1 + T(C) * Y1), sizes=["l", "p", "n"], over={**SPACE, **PSD}, tex=TEX,
      given=[FIRST, SECOND, J_STABLE, SOLVES, DETECTABLE, STABILIZABLE], by=[example(TWO), DRAWN_P],
      repair=repair("index", "in (5.19) the second Y_1 must be Y_2, which is F'Y in the notation (5.2); and (5.18) is meant with J and the sign of S of (5.1)",
                    invertible(T(F) * Yk) & (Pk * (T(F) * Yk) == Xk), sizes=["k", "n"], over=GENERAL, given=GENERAL_GIVEN,
                    by=[GENERAL_PROOF, *GENERAL_FOILS, GENERAL_DRAWN]),
      note=THEOREM_NOTE + "The corrected statement is P(F'Y) = X with invertible F'Y. That there is a solution is Theorem 4.3.")

# ------------------------------------------------------------------ the eigenspace by a Schur decomposition
not_checked("NWL92-E5.22", "the generalized real Schur decomposition of the pencil",
            "a classical theorem, quoted; its orthogonal factors are algebraic numbers of unbounded degree")

Ms, Mr, Mh, Ns, Nr, Nh, MM, NN, Qs, Qr, Zs = symbols("Ms Mr Mh Ns Nr Nh MM NN Qs Qr Zs")
q = sym("q")
DECOMPOSED = {Ms: matrix(n, n), Mr: matrix(n, q), Mh: matrix(q, q), Ns: nonsingular(n), Nr: matrix(n, q), Nh: matrix(q, q)}
M_UPPER, N_UPPER = block([[Ms, Mr], [Zero(q, n), Mh]]), block([[Ns, Nr], [Zero(q, n), Nh]])
CHI_S, CHI_H = det(Ms - Z * Ns), det(Mh - Z * Nh)
claim("NWL92-E5.23", "if M_s and N_s belong to the stable eigenmodes, J is stable",
      schur(J) & (det(M_UPPER - Z * N_UPPER) == CHI_S * CHI_H),
      sizes=["n", "q"], over={**DECOMPOSED, J: matrix(n, n)},
      given=[given("J = N_s^-1 M_s", Ns * J == Ms), given("n stable eigenmodes", inside_roots(CHI_S) == n)],
      by=[*[example({"n": 1, "q": 1, Ms: [[m]], Mr: [[0]], Mh: [[1]], Ns: [[1]], Nr: [[0]], Nh: [[1]], J: [[2]]}) for m in (2, 0)],
          instances(made_by={J: W0 * (1 / (1 + trace(W0 * T(W0)))), Ms: Ns * J}, using={W0: matrix(n, n)}, n=(1, 2), q=(1, 2))],
      note=("The eigenmodes of M - zN are those of both diagonal blocks, and J is N_s^-1 M_s. In the scan the last block of N is N_2, which is read as "
            "that of the same place in M."))

ORTHOGONAL = given("Q is orthogonal", Qs * T(Qs) + Qr * T(Qr) == Identity(k))
UPPER = [given(f"(5.22{letter})", (T(Qs) * whole * Zs == first) & (T(Qr) * whole * Zs == Zero(q, n)))
         for letter, whole, first in (("a", MM, Ms), ("b", NN, Ns))]
Q_ALL, ROTATION = symbols("Qall rot")
Q_MADE = {Q_ALL: inv(Identity(k) + ROTATION - T(ROTATION)) * (Identity(k) - ROTATION + T(ROTATION)), Qs: Q_ALL * vstack(Identity(n), Zero(k - n, n)),
          Qr: Q_ALL * vstack(Zero(n, q), Identity(q)), MM: Qs * Ms * T(Zs) + X * (Identity(k) - Zs * T(Zs)), NN: Qs * Ns * T(Zs) + W0 * (Identity(k) - Zs * T(Zs))}
ZS_ALL, OTHER = symbols("Zall rot2")
Z_MADE = {ZS_ALL: inv(Identity(k) + OTHER - T(OTHER)) * (Identity(k) - OTHER + T(OTHER)), Zs: ZS_ALL * vstack(Identity(n), Zero(k - n, n))}
SCHUR_ONES = {"k": 2, "n": 1, "q": 1, Qs: [[1], [0]], Qr: [[0], [1]], Zs: [[1], [0]], MM: [[2, 0], [0, 0]], NN: [[1, 0], [0, 0]], Ms: [[2]], Ns: [[1]]}
claim("NWL92-E5.24", "the first n columns of Z span an invariant space on which the pencil acts as J",
      MM * Zs == NN * Zs * inv(Ns) * Ms, sizes=["k", "n", "q"],
      over={MM: matrix(k, k), NN: matrix(k, k), Qs: matrix(k, n), Qr: matrix(k, q), Zs: matrix(k, n), Ms: matrix(n, n), Ns: nonsingular(n)},
      given=[ORTHOGONAL, *UPPER],
      by=[order(), example({**SCHUR_ONES, MM: [[3, 0], [0, 0]]}), example({**SCHUR_ONES, NN: [[3, 0], [0, 0]]}), example({**SCHUR_ONES, Qr: [[0], [0]], MM: [[2, 0], [1, 0]]}),
          *[instances(8, made_by={**Z_MADE, **Q_MADE}, using={ROTATION: matrix(k, k), OTHER: matrix(k, k), X: matrix(k, k), W0: matrix(k, k)}, k=n_ + q_, n=n_, q=q_)
            for n_, q_ in ((1, 1), (1, 2), (2, 1))]],
      note="MM and NN are M and N before the decomposition; Qs, Zs are the first n columns of Q, Z, and the first n columns of (5.22) are used. J is N_s^-1 M_s.")
