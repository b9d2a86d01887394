# SPDX-License-Identifier: MIT
"""The action contracts the distance (section 1.2, Proposition 1.6 and Theorem 1.7).

The distance of T and S is made of the logarithms of the eigenvalues of T inv(S), and what is
shown is said of each of them: in ascending order, the eigenvalues for the images lie nearer to
one. As they are positive, the number of those greater than c is the number of roots of the
characteristic polynomial of T inv(S)/c outside the unit circle; it does not grow for c > 1, and
for c < 1 the number of those inside does not.

A shift by P moves a quotient x'Tx / x'Sx towards one, because the same number is added above
and below; if T and S are at most alpha and P is at least beta, its logarithm becomes smaller by
the factor alpha/(alpha + beta) at least. By Courant and Fischer the eigenvalues do the same.
For whole numbers alpha and beta the factor is an exponent: instead of the logarithms, the
powers with the exponents alpha + beta and alpha are compared. That is no restriction for
rational ones, as alpha and beta, T, S and P can be multiplied by the same number.

Congruence and inversion change the eigenvalues not at all, or into their reciprocals. So the
action of a member of H contracts through its two shifts.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, instances, order, part
from exactkf.language import (
    Identity,
    T,
    Z,
    charpoly,
    cospectral,
    diagonal,
    forall,
    function,
    given,
    inside_roots,
    integer,
    inv,
    let,
    loewner,
    matrix_of,
    nonneg,
    nonsingular,
    outside_roots,
    pd,
    positive,
    positive_definite,
    positive_semidefinite,
    prod,
    standing,
    sum_of,
    symbols,
    symmetric_matrix,
    symplectic,
    vector,
    when,
)
from proofs.b93.notation import Factor, d, i, j, k, member, numbers
from proofs.b93.section_1_2 import BLOCKS, OVER, S0, TT, A, B, C, D, M, P, Q

I = Identity(d)
X, Y, W, U, g, c, u, v, Max, alpha, beta, x, num, den = symbols("X Y W U g c u v Max alpha beta x num den")
m, Ratio, New, tx, sx, px = symbols("m Ratio New tx sx px")
LARGER = function(Max, [u, v], when(u > v, u, v))
DEFINITION = "a definition: it fixes notation and asserts nothing"



def unit(first, last):
    """The unit vectors with these numbers, side by side."""
    return matrix_of(i, j, d, last - first + 1, when(i == j + first - 1, 1, 0))


# --- the distance ----------------------------------------------------------------------------------------------------------

K, Dg, lam, V1, V2 = symbols("K Dg lam V1 V2")
ASCENDING = given("ascending", forall(i, 1, d - 1, Dg[i, i] <= Dg[i + 1, i + 1]))

E0, Lam = symbols("E Lam")
claim("B93-D1.4", "the distance does not depend on the order of the two matrices",
      Q*inv(P)*E0 == E0*inv(Lam), sizes=["d"], over={P: positive_definite(d), Q: positive_definite(d), E0: nonsingular(d), Lam: nonsingular(d)},
      given=[given("eigenvalues and eigenvectors of P inv(Q)", P*inv(Q)*E0 == E0*Lam)],
      by=[order(), instances(6, d=(1, 2, 3), made_by={Lam: inv(E0)*P*inv(Q)*E0})],
      note="A definition. That the distance is symmetric is checked: Lam is the diagonal matrix of the eigenvalues of P inv(Q), or any matrix that is similar "
           "to it, by E, and then Q inv(P) is similar to inv(Lam). So exchanging P and Q replaces the eigenvalues by their reciprocals, with multiplicities; "
           "the squares of their logarithms stay.")

dP, NEW = symbols("dP NEW")
claim("B93-S30", "the arc length is invariant",
      (inv(A*P*T(A))*(A*dP*T(A))*inv(A*P*T(A))*(A*dP*T(A)) == inv(T(A))*(inv(P)*dP*inv(P)*dP)*T(A)), sizes=["d"],
      over={A: nonsingular(d), P: positive_definite(d), dP: symmetric_matrix(d)},
      by=[order(), instances(6, d=(1, 2, 3)), part("that the arc length is invariant")],
      note="The trace of (P^{-1}dP)^2 is that of a similar matrix after the congruence with A. That the distance belongs to this arc length, that the space "
           "is complete, and its topology, are quoted and not stated here.")

not_checked("B93-S34", "the operator norm", DEFINITION)

claim("B93-S35", "the eigenvalues as minima of maxima",
      (charpoly(TT*inv(S0)) == prod(i, 1, d, Z - Dg[i, i])) & (lam > 0) & loewner(lam*T(V1)*S0*V1, T(V1)*TT*V1) & loewner(T(V2)*TT*V2, lam*T(V2)*S0*V2)
      & (TT*num == lam*S0*num),
      sizes=["d", "k"], over={K: nonsingular(d), Dg: diagonal(d)},
      where=[let(S0, T(K)*K), let(TT, T(K)*Dg*K), let(lam, Dg[k, k]), let(V1, inv(K)*unit(1, k)), let(V2, inv(K)*unit(k, d)), let(num, inv(K)*unit(k, k))],
      given=[standing("k is an index", (k >= 1) & (k <= d)), given("T > 0", pd(TT)), ASCENDING],
      by=[example(d=2, k=2, K=[[1, 1], [0, 1]], Dg=[[2, 0], [0, 1]]), example(d=2, k=1, K=[[1, 0], [1, 1]], Dg=[[3, 0], [0, 1]]),
          example(d=1, k=1, K=[[1]], Dg=[[-1]]),
          instances(8, d=(1, 2, 3), k=(1, 2, 3), using={U: vector(d)}, made_by={Dg: matrix_of(i, j, d, d, when(i == j, sum_of(m, 1, i, 1 + U[m]**2), 0))})],
      note="Any two positive matrices are T = K'DK and S = K'K. On the range of V1, of dimension k, the quotient x'Tx / x'Sx is at most the k-th "
           "eigenvalue, which it takes at the vector num; on that of V2, of dimension d - k + 1, it is at least that. Every other subspace of dimension k "
           "meets the range of V2.")

# --- shifts ----------------------------------------------------------------------------------------------------------------

a, b, r = symbols("a b r")
claim("B93-E15", "a shift makes the logarithm of a quotient smaller",
      New**(m + r) <= Ratio**m,
      over={a: positive(), b: positive(), m: integer(1, 4), r: integer(1, 4)}, where=[LARGER, let(New, (a + r)/(b + r)), let(Ratio, Max(a/b, 1))],
      given=[given("a <= m", a <= m), standing("b <= m", b <= m)],
      by=[example(a=4, b=1, m=1, r=1), example(a=1, b="1/2", m=1, r=1), example(a=2, b=4, m=1, r=1),
          instances(using={u: nonneg(), v: nonneg()}, made_by={a: m/(1 + u), b: m/(1 + v)}),
          instances(made_by={a: m, b: m/(1 + 1)})],
      note="The exponential of the printed inequality, multiplied by m + r, for whole numbers m and r. Ratio is the larger of a/b and 1, and New the "
           "quotient after the shift.")

LEVEL = {alpha: integer(1, 3), beta: integer(0, 3)}
BOUNDED = {"using": {U: positive_definite(d), W: positive_definite(d), Y: positive_semidefinite(d)},
           "made_by": {TT: alpha*U*inv(U + I), S0: alpha*W*inv(W + I), P: beta*I + Y}}
BOUNDS = [given("T <= alpha", loewner(alpha*I, TT)), standing("S <= alpha", loewner(alpha*I, S0)), given("P >= beta", loewner(P, beta*I))]
MATRICES = {TT: positive_definite(d), S0: positive_definite(d), P: positive_semidefinite(d)}
FORMS = [let(tx, T(x)*TT*x), let(sx, T(x)*S0*x), let(px, T(x)*P*x), LARGER, let(New, (tx + px)/(sx + px)), let(Ratio, Max(tx/sx, 1))]

claim("B93-S36", "a shift and the quotient of two forms",
      New**(alpha + beta) <= Ratio**alpha,
      sizes=["d"], over={**MATRICES, **LEVEL, x: vector(d)}, where=FORMS, given=BOUNDS,
      by=[instances(8, d=(1, 2), **BOUNDED), instances(8, d=(1, 2), using={Y: positive_semidefinite(d)}, made_by={TT: alpha*I, S0: alpha/2*I, P: beta*I}),
          instances(4, d=(1,), made_by={P: 0*I}), instances(4, d=(1,))],
      note="x'Tx, x'Sx and x'Px are tx, sx and px, and Ratio is the larger of tx/sx and 1; powers instead of logarithms, for whole alpha and beta. The "
           "second statement, on the eigenvalues, is (16).")


Far, Near = symbols("Far Near")


def nearer(after, before):
    """For every k: a power of the k-th eigenvalue of ``after`` is no farther from one than another of that of ``before``; see `powers`."""
    return (((g >= 1) >> (outside_roots(charpoly(after/Near)) <= outside_roots(charpoly(before/Far))))
            & ((g <= 1) >> (inside_roots(charpoly(after/Near)) <= inside_roots(charpoly(before/Far)))))


def powers(near, far):
    """What the eigenvalues after and before are compared with: g^near and g^far, so that the exponents far and near belong to them."""
    return [let(Near, g**near), let(Far, g**far)]


Old, Shifted = symbols("Old Shifted")
QUOTIENTS = [let(Old, TT*inv(S0)), let(Shifted, (TT + P)*inv(S0 + P))]
WHOLE = ("Said of each eigenvalue, in ascending order: so many are greater than g^alpha after the shift, for any g > 1, as at most were greater than "
         "g^(alpha + beta) before, and likewise smaller for g < 1. alpha and beta are whole numbers. ")
NARROW = example(d=1, T=[[3]], S0=[[1]], P=[[1]], alpha=3, beta=1, g="5/4")
BOUNDS_OF_BOTH = [given(label, formula) for label,
                  formula in (("T <= alpha", loewner(alpha*I, TT)), ("S <= alpha", loewner(alpha*I, S0)), ("P >= beta", loewner(P, beta*I)))]
SHARP = [NARROW, example(d=1, T=[[4]], S0=[[1]], P=[[1]], alpha=1, beta=1, g="11/5"), example(d=1, T=[[1]], S0=[[4]], P=[[1]], alpha=1, beta=1, g="5/11"),
         example(d=1, T=[["1/2"]], S0=[[1]], P=[[1]], alpha=1, beta=1, g="4/5"), example(d=1, T=[[1]], S0=[["1/2"]], P=[[1]], alpha=1, beta=1, g="5/4"),
         example(d=2, T=[[1, 0], [0, "1/2"]], S0=[["1/2", 0], [0, 1]], P=[[1, 0], [0, 1]], alpha=1, beta=1, g="4/3")]

for id_, title, more in (("B93-E16", "a shift brings every eigenvalue nearer to one", ""),
                         ("B93-P1.6", "a shift contracts", "The squared distance is the sum of the squares of the logarithms, so it falls by the square of "
                                                           "the factor.")):
    claim(id_, title, nearer(Shifted, Old), sizes=["d"], over={**MATRICES, **LEVEL, g: positive()}, where=[*QUOTIENTS, *powers(alpha, alpha + beta)],
          given=BOUNDS_OF_BOTH,
          by=[*SHARP, instances(8, d=(1, 2), **BOUNDED), instances(4, d=(1,))], note=WHOLE + more)

# --- the action ------------------------------------------------------------------------------------------------------------

After, Image, PhiM = symbols("After Image PhiM")
#: every member of H is made of A, P and Q (S38), and acts like this (17)
ACT = [function(PhiM, [u], inv(inv(A*(u + P)*T(A)) + Q)), let(Old, TT*inv(S0)), let(After, PhiM(TT)*inv(PhiM(S0)))]
MEMBER = {A: nonsingular(d), P: positive_semidefinite(d), Q: positive_semidefinite(d), TT: positive_definite(d), S0: positive_definite(d)}
FORM = "M is given by A, P = A^{-1}B and Q = CA^{-1}, as in (17); PhiM is its action. "
EQUAL_RATE = "Said of each eigenvalue of T inv(S), in ascending order, whose logarithms make up the distance. "
PLAIN = instances(8, d=(1, 2))
#: expanding instead of contracting, if P and Q were negative
WRONG = [example(d=1, A=[[1]], P=[["-1/2"]], Q=[[0]], T=[[2]], S0=[[1]], g="5/2"), example(d=1, A=[[1]], P=[[0]], Q=[["-1/3"]], T=[[2]], S0=[[1]], g="5/2"),
         example(d=1, A=[[1]], P=[[0]], Q=[[0]], T=[[2]], S0=[[1]], g="3/2"), example(d=1, A=[[1]], P=[[0]], Q=[[0]], T=[[1]], S0=[[2]], g="3/4")]

for id_, title, more in (("B93-T1.7.1", "members of H contract", ""),
                         ("B93-S2", "the filter's maps contract",
                          "Stated for all members of H, of which the matrices of the filter are some. What strictness depends on is said by Theorem 1.7; "
                          "the other recursion is not stated here.")):
    claim(id_, title, nearer(After, Old), sizes=["d"], over={**MEMBER, g: positive()}, where=[*ACT, *powers(1, 1)], by=[*WRONG[2:], PLAIN],
          note=FORM + EQUAL_RATE + more)

claim("B93-S39", "what the subsets of H say of the two shifts",
      pd(C*inv(A)) & pd(inv(A)*B), sizes=["d"], over=OVER, where=[BLOCKS],
      given=[given("M in Sp", symplectic(M)), given("M in H1: A*C > 0", pd(T(A)*C)), given("M in H2: BA* > 0", pd(B*T(A)))],
      by=[order([Factor(A, B, C).Q], [Factor(A, B, C).P]), *(example(numbers("A B C D", *entries)) for entries in ((1, 1, -1, 0), (1, -1, 1, 0), (1, 1, 1, 2))),
          instances(6, d=(1, 2), using={U: positive_definite(d), W: positive_definite(d)}, made_by=member(A, B, C, D, U, W)),
          part("that P and Q are positive")],
      note="Q is positive for M in H1, which asks A*C > 0 alone, and P for M in H2, which asks BA* > 0 alone. That congruence and inversion leave the "
           "distance alone is B93-S31, and that shifts contract is B93-P1.6.")

STRICT = [standing("M in H1 or H2", pd(P) | pd(Q))]
claim("B93-T1.7.2", "members of H1 and of H2 contract strictly",
      ~cospectral(After, Old), sizes=["d"], over=MEMBER, where=ACT, given=STRICT,
      by=[example(d=1, A=[[1]], P=[[1]], Q=[[1]], T=[[1]], S0=[[1]]), instances(d=(1,))],
      repair=repair("boundary case", "for T = S both distances are zero; T and S are to be different",
                    ~cospectral(After, Old), sizes=["d"], over=MEMBER, where=ACT,
                    given=[given("M in H1 or H2", pd(P) | pd(Q)), given("T is not S", TT != S0)],
                    by=[example(d=1, A=[[1]], P=[[1]], Q=[[1]], T=[[1]], S0=[[1]]), example(d=1, A=[[1]], P=[[0]], Q=[[0]], T=[[2]], S0=[[1]]),
                        example(d=1, A=[[1]], P=[[1]], Q=[[0]], T=[[2]], S0=[[1]]),
                        instances(8, d=(1, 2), using={U: positive_definite(d)}, made_by={P: U}),
                        instances(8, d=(1, 2), using={U: positive_definite(d)}, made_by={Q: U})]),
      note=FORM + "By (i) each eigenvalue of T inv(S) comes no farther from one; so the distance becomes smaller exactly if the eigenvalues do not all stay "
                  "as they are. In the counterexample T = S = 1.")

zeta, eps = symbols("zeta eps")
RATE = {**MEMBER, P: positive_definite(d), Q: positive_definite(d), zeta: integer(1, 3), eps: integer(1, 3)}
RATE_BOUNDS = [given("(APA*)^{-1} <= zeta", loewner(zeta*I, inv(A*P*T(A)))), given("Q >= epsilon", loewner(Q, eps*I))]
RATE_MADE = {"using": {U: positive_semidefinite(d), W: positive_semidefinite(d)}, "made_by": {P: inv(A)*(I/zeta + U)*inv(T(A)), Q: eps*I + W}}
RATE_SHARP = [example(d=1, A=[[1]], P=[["1/100"]], Q=[[1]], T=[[1]], S0=[["1/100"]], zeta=1, eps=1, g=15),
              example(d=1, A=[[1]], P=[["1/100"]], Q=[[1]], T=[["1/100"]], S0=[[1]], zeta=1, eps=1, g="1/20"),
              example(d=1, A=[[1]], P=[["1/3"]], Q=[["1/100"]], T=[["4/3"]], S0=[["1/3"]], zeta=3, eps=3, g="13/10"),
              example(d=1, A=[[1]], P=[["1/3"]], Q=[["1/100"]], T=[["1/3"]], S0=[["4/3"]], zeta=3, eps=3, g="10/13"),
              example(d=1, A=[[1]], P=[[1]], Q=[[1]], T=[[3]], S0=[[1]], zeta=1, eps=1, g="9/8"),
              example(d=2, A=[[1, 1], [0, 1]], P=[[2, -1], [-1, 1]], Q=[[1, 0], [0, 1]], T=[[3, 0], [0, 1]], S0=[[1, 0], [0, 3]], zeta=1, eps=1, g="3/2")]
for id_, title in (("B93-T1.7.3", "members of H0 contract uniformly"), ("B93-S43", "the factor of the uniform contraction")):
    claim(id_, title, nearer(After, Old), sizes=["d"], over={**RATE, g: positive()}, where=[*ACT, *powers(zeta, zeta + eps)], given=RATE_BOUNDS,
          by=[*RATE_SHARP, instances(8, d=(1, 2), **RATE_MADE), instances(4, d=(1,))],
          note=FORM + EQUAL_RATE + "The factor zeta/(zeta + epsilon) is an exponent, with whole numbers zeta and epsilon that bound the norm of (APA*)^{-1} "
                                   "and Q.")

SELF = Factor(A, B, C)
CHAIN = A*(TT + P)*T(A)
claim("B93-S40", "the images lie in an interval",
      pd(P) & pd(Q) & loewner(TT + P, P) & loewner(CHAIN, A*P*T(A)) & loewner(inv(A*P*T(A)), inv(CHAIN)), sizes=["d"],
      over={**OVER, TT: positive_semidefinite(d)}, where=[BLOCKS, let(P, inv(A)*B), let(Q, C*inv(A))],
      given=[standing("M in Sp", symplectic(M)), given("M: BA* > 0", pd(B*T(A))), given("M: A*C > 0", pd(T(A)*C))],
      by=[order([SELF.P], [SELF.Q], [TT], [A*TT*T(A)], [inv(CHAIN)*(A*TT*T(A))*T(inv(CHAIN)), inv(CHAIN)*(A*TT*T(A))*inv(A*P*T(A))*(A*TT*T(A))*T(inv(CHAIN))]),
          *(example(numbers("A B C D T", *entries)) for entries in ((1, -1, 1, 0, 2), (1, 1, -1, 0, 1))),
          instances(8, d=(1, 2), using={U: positive_definite(d), W: positive_definite(d)}, made_by=member(A, B, C, D, U, W))],
      note="Only that T is nonnegative is used.")

Gone, Half, Shrunk = symbols("Gone Half Shrunk")
claim("B93-S41", "the last shift contracts uniformly",
      nearer(Shrunk, Old), sizes=["d"], over={**RATE, g: positive()},
      where=[let(Old, Half*inv(Gone)), let(Gone, inv(A*(TT + P)*T(A))), let(Half, inv(A*(S0 + P)*T(A))), let(Shrunk, (Half + Q)*inv(Gone + Q)),
             *powers(zeta, zeta + eps)],
      given=RATE_BOUNDS,
      by=[*RATE_SHARP, example(d=1, A=[[1]], P=[["1/100"]], Q=[[1]], T=[[1]], S0=[["1/100"]], zeta=1, eps=1, g=10),
          example(d=1, A=[[1]], P=[["1/3"]], Q=[["1/100"]], T=[["4/3"]], S0=[["1/3"]], zeta=3, eps=3, g="6/5"), instances(6, d=(1, 2), **RATE_MADE)],
      note="Gone and Half are the images of T_1 and T_2 under the inversion after the congruence after the shift by P. " + EQUAL_RATE +
           "The factor is an exponent, with whole numbers zeta and epsilon. That these three maps contract in turn is B93-T1.7.1 with Q = 0.")
