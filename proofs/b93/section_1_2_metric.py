# SPDX-License-Identifier: MIT
"""The contraction property (section 1.2): what is algebra in Proposition 1.6 and Theorem 1.7.

The logarithm inequality (15) is, for a >= b, ((a + r)/(b + r))^(m + r) <= (a/b)^m; it does not
change when all numbers are multiplied by one, so that for rational m and r it is one for
integers. With ratios u = g^(m + r) and w = g^m of forms it becomes a statement without
logarithms: where <Tx, x> <= u <Sx, x>, <(T + P)x, x> <= w <(S + P)x, x>.

A member of H acts as a shift by P, a congruence, an inversion, a shift by Q and an inversion.
The strict inequality of Theorem 1.7 fails for T = S, where both distances are zero.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, instances, order
from exactkf.language import (
    Identity,
    T,
    given,
    inv,
    let,
    loewner,
    nonneg,
    nonsingular,
    pd,
    positive,
    positive_definite,
    positive_semidefinite,
    standing,
    symbols,
    vector,
)
from proofs.b93.notation import d

A, L, M, P, Q, S, U, g, x, X, Y = symbols("A L M P Q S U g x X Y")
TT, S0, a, b, m, r, t, s, p, q = symbols("T S a b m r t s p q")
I = Identity(d)
DISTANCE = ("a statement about sums of squared logarithms of eigenvalues, which have no exact values; its algebra is in the claims on the displayed "
            "steps of its proof")
METRIC = "a theorem of Riemannian geometry that the text quotes"

not_checked("B93-S2", "the contraction property announced", "an announcement of Theorem 1.7, and a remark on another recursion without details")
not_checked("B93-S3", "the main result announced", "an announcement of Theorem 2.4; an almost sure limit has no exact instances")
not_checked("B93-S4", "continuous time", "a remark without a statement that could be checked")
not_checked("B93-S29", "the continuous Riccati equation", "the flow of a differential equation with unspecified coefficients; the text quotes it")
not_checked("B93-D1.4", "the distance", "a definition: it fixes notation; that the eigenvalues are positive is S35")
not_checked("B93-S30", "the distance as a Riemannian one", METRIC)
not_checked("B93-S34", "the operator norm", "a definition: it fixes notation and asserts nothing")

claim("B93-E15", "the logarithm inequality",
      X <= Y, sizes=["m", "r"], over={a: positive(), b: positive()}, where=[let(X, ((a + r) / (b + r)) ** (m + r)), let(Y, (a / b) ** m)],
      given=[given("a <= m", a <= m), standing("b <= m", b <= m), given("a >= b", a >= b), standing("r > 0", r >= 1), standing("m > 0", m >= 1)],
      by=[instances(m=(1, 2, 3), r=(1, 2, 3), made_by={a: m}), instances(m=(1, 2, 3), r=(1, 2, 3), made_by={a: b}), instances(m=(1, 2, 3), r=(1, 2, 3))],
      note="For a >= b and with exponentials taken; for a < b the left side is negative and the right side zero. Multiplying a, b, m, r by one number "
           "changes nothing, so that integers m, r stand for all rational ones.")

claim("B93-S35", "the eigenvalues of T inv(S) are those of a positive symmetric matrix",
      (TT * inv(S0) == L * (inv(L) * TT * inv(T(L))) * inv(L)) & pd(inv(L) * TT * inv(T(L))), sizes=["d"],
      over={TT: positive_definite(d), S0: positive_definite(d), L: nonsingular(d)},
      given=[given("S = LL*", S0 == L * T(L))],
      by=[order([], [inv(L) * TT * T(inv(L))]), instances(d=(1, 2, 3), made_by={S0: L * T(L)})],
      note="With y = L*x the quotient <Tx, x>/<Sx, x> is that of the symmetric matrix at y, for which the min-max formula is the classical one.")

claim("B93-S36", "the ratio of two forms after a shift",
      T(x) * X * x <= g**m * T(x) * Y * x, sizes=["d", "m", "r"],
      over={TT: positive_definite(d), S0: positive_definite(d), P: positive_semidefinite(d), g: positive(), x: vector(d)},
      where=[let(X, TT + P), let(Y, S0 + P)],
      given=[given("||T|| <= alpha", loewner(m * I, TT)), standing("||S|| <= alpha", loewner(m * I, S0)), given("P >= beta", loewner(P, r * I)),
             given("g >= 1", g >= 1), given("the ratio is g^(alpha + beta)", T(x) * TT * x <= g**(m + r) * T(x) * S0 * x)],
      by=[instances(d=(1, 2), m=(1, 2), r=(1, 2), made_by={TT: m * I, S0: m * I / g**(m + r), P: r * I}),
          instances(d=(1, 2), m=(1, 2), r=(0, 1), made_by={TT: I / 2, S0: I / 2, P: r * I, g: 1}),
          instances(d=1, m=(1, 2), r=(1, 2), made_by={TT: m * I / 2, S0: m * I / 2 / g**(m + r), P: r * I})],
      note="alpha and beta are integers m and r, by multiplying T, S, P by one number.")

not_checked("B93-E16", "the k-th eigenvalues after a shift", DISTANCE)
not_checked("B93-P1.6", "a shift contracts the distance", DISTANCE)
not_checked("B93-T1.7.1", "members of H contract", DISTANCE)
not_checked("B93-T1.7.3", "members of H0 contract uniformly", DISTANCE)
not_checked("B93-S39", "isometries and contractions", "S31 for the isometries and Proposition 1.6 for the contractions; it asserts nothing else")
not_checked("B93-S41", "the contraction after the first three maps", DISTANCE)
number = symbols("number")[0]
CONGRUENCE = A * P * T(A) * inv(A * Q * T(A)) == A * (P * inv(Q)) * inv(A)
claim("B93-S42", "the end of the proof of (iii), said to rest on (16)",
      CONGRUENCE & (number == 17), sizes=["d"], over={A: nonsingular(d), P: positive_definite(d), Q: positive_definite(d)}, where=[let(number, 16)],
      by=[example(d=1, A=[[1]], P=[[1]], Q=[[1]]), instances(d=(1, 2))],
      repair=repair("cross-reference", "That the maps of the chain make up the action is (17); (16) is about eigenvalues.",
                    CONGRUENCE, sizes=["d"], over={A: nonsingular(d), P: positive_definite(d), Q: positive_definite(d)}, by=[order(), instances(d=(1, 2))]),
      note="17 is the number of the display that is used. The equation is the isometry of S31, by which the last map does not change the distance.")
not_checked("B93-S43", "a constant for uniform contraction", DISTANCE)
not_checked("B93-S44", "a power of the Hamiltonian matrix is in H0", "Proposition 1.3 for equal factors and the definition of controllability and observability; "
            "see also S59")
not_checked("B93-S45", "convergence to a fixed point", "the fixed point theorem applied to Theorem 1.7; a limit has no exact instances")

PHI = {t: positive(), s: positive(), p: nonneg(), q: nonneg()}
IMAGES = (let(X, (t + p) / (1 + q * (t + p))), let(Y, (s + p) / (1 + q * (s + p))),
          let(P, (t - s) ** 2 / (t * s)), let(Q, (X - Y) ** 2 / (X * Y)))
claim("B93-T1.7.2", "members of H1 or H2 contract strictly",
      Q < P, over=PHI, where=IMAGES, given=[given("in H1 or H2", p + q > 0)],
      by=[example({"t": 1, "s": 1, "p": 1, "q": 0}), instances()],
      repair=repair("boundary case", "For T = S both distances are zero; it holds for T different from S.",
                    Q < P, over=PHI, where=IMAGES,
                    given=[given("in H1 or H2", p + q > 0), given("different", t != s)],
                    by=[example({"t": 1, "s": 1, "p": 1, "q": 0}), example({"t": 1, "s": 2, "p": 0, "q": 0}), instances()]),
      note="For d = 1, where the congruence changes nothing and |log(t/s)| is smaller exactly when t/s + s/t - 2 = (t - s)^2/(ts) is. For any d the "
           "counterexample T = S is the same, and the correction is deduced from Proposition 1.6.")

TAU = let(X, TT + P)
claim("B93-S40", "bounds for the first maps of the chain",
      pd(P) & pd(Q) & loewner(X, P) & loewner(A * X * T(A), A * P * T(A)) & loewner(inv(A * P * T(A)), inv(A * X * T(A))), sizes=["d"],
      over={A: nonsingular(d), U: positive_definite(d), S: positive_definite(d), TT: positive_definite(d)},
      where=[let(P, inv(A) * (A * U)), let(Q, S), TAU],
      by=[order([U], [S], [TT], [A * TT * T(A)], [inv(A * P * T(A) + A * P * T(A) * inv(A * TT * T(A)) * A * P * T(A))]), instances(d=(1, 2))],
      note="For the member of H0 with P = U and Q = S, and T in P0.")
