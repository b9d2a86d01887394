# SPDX-License-Identifier: MIT
"""Equilibria as solutions of a quadratic matrix equation (Chapter III, section C.3.a).

An equilibrium P of the covariance equation satisfies
P - H = Phi P (I + SP)^{-1} Phi' with S = M'V^{-1}M. Multiplying by (Phi')^{-1} on the
right, then by I + SP, clears the inverse; sorted by degree in P the result is
A + BP + PC - PDP = 0 with A = H(Phi')^{-1}, B = H(Phi')^{-1}S + Phi, C = -(Phi')^{-1},
D = (Phi')^{-1}S. Its block matrix R_p factors into a unit upper triangular matrix
with H, diag(Phi, (Phi')^{-1}) and a unit lower triangular one with S, so it is
invertible.

Clearing the inverse adds no solutions. If P solves the quadratic equation then
(I - S Phi^{-1}(P - H)(Phi')^{-1})(I + SP) = I, so I + SP has an inverse, and the steps
can be taken back.

Nothing here uses that P is symmetric (Example 3.1 has equilibria that are not) or
that H is nonnegative, so P and H are arbitrary square matrices.
"""

from exactkf.claims import claim, not_checked
from exactkf.evidence import combination, identity, instances, order
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    eq,
    given,
    inv,
    invertible,
    let,
    matrix,
    nonsingular,
    positive_definite,
    sym,
    symbols,
)
from proofs.d71.notation import H, M, P, Phi, V, gram, n, p, r_matrix, step, update

A, B, C, D, S, Pe, Rp = symbols("A B C D S Pe Rp")
I = Identity(n)
PhiT = inv(T(Phi))

SMALL = {"n": (1, 2), "p": (1, 2)}
MORE = {"n": (1, 2, 3), "p": (1, 2)}
SYSTEM = {Phi: nonsingular(n), H: matrix(n, n), M: matrix(p, n), V: positive_definite(p)}
DATA = {**SYSTEM, P: matrix(n, n)}
GRAM = let(S, gram())
COEFFICIENTS = [GRAM, let(A, H*PhiT), let(B, H*PhiT*S + Phi), let(C, -PhiT), let(D, PhiT*S)]
EQUILIBRIUM = given("(3.46)", P == step())
MADE = {H: P - Phi*(update())*T(Phi)}
QUADRATIC = H*PhiT + (H*PhiT*S + Phi)*P - P*PhiT - P*(PhiT*S)*P

not_checked("D71-E3.46", "the equation of the equilibria", "a definition: it fixes notation and asserts nothing",
            note="The equilibria are the matrices that satisfy it.")

claim("D71-E3.47", "the equilibrium equation with I + SP inverted",
      (P - H)*PhiT == Phi*P*inv(I + S*P),
      sizes=["n", "p"], over=DATA, where=[GRAM], given=[EQUILIBRIUM],
      by=[combination([(1, "(3.46)", PhiT)], **SMALL), instances(**MORE, made_by=MADE)])

claim("D71-E3.48", "the inverse cleared",
      (P - H)*PhiT*(I + S*P) - Phi*P == Zero(n, n),
      sizes=["n", "p"], over=DATA, where=[GRAM], given=[EQUILIBRIUM],
      by=[combination([(1, "(3.46)", PhiT*(I + S*P))], **SMALL), instances(**MORE, made_by=MADE)])

claim("D71-E3.49", "the quadratic matrix equation",
      QUADRATIC == Zero(n, n),
      sizes=["n", "p"], over=DATA, where=[GRAM], given=[EQUILIBRIUM],
      by=[combination([(-1, "(3.46)", PhiT*(I + S*P))], **SMALL), instances(**MORE, made_by=MADE)])

claim("D71-E3.50", "its coefficients",
      eq(A + B*P + P*C - P*D*P, QUADRATIC, Phi*P - (P - H)*PhiT*(I + S*P)),
      sizes=["n", "p"], over=DATA, where=COEFFICIENTS,
      by=[identity(**SMALL), instances(**MORE)],
      note="The coefficients are definitions; the content checked is that (3.10) with them is (3.49), and minus "
           "(3.48), for every P.")

R_PRINTED = block([[H*PhiT*S + Phi, H*PhiT], [PhiT*S, PhiT]])

claim("D71-E3.51", "the block matrix R_p",
      r_matrix(A, B, C, D) == R_PRINTED,
      sizes=["n", "p"], over=SYSTEM, where=COEFFICIENTS, by=[identity(**SMALL), instances(**MORE)])

Zn = Zero(n, n)

claim("D71-E3.52", "factors of R_p and its inverse",
      (R_PRINTED == block([[I, H], [Zn, I]])*block([[Phi, Zn], [Zn, PhiT]])*block([[I, Zn], [S, I]]))
      & (R_PRINTED*block([[I, Zn], [-S, I]])*block([[inv(Phi), Zn], [Zn, T(Phi)]])*block([[I, -H],
                                                                                          [Zn, I]]) == Identity(2*n)),
      sizes=["n", "p"], over=SYSTEM, where=[GRAM], by=[identity(**SMALL), instances(**MORE)],
      note="R_p is nonsingular: the second equation shows its inverse.")

claim("D71-E3.53", "I + SP and the matrix DP - C",
      I + S*P == T(Phi)*(D*P - C),
      sizes=["n", "p"], over=DATA, where=COEFFICIENTS, by=[identity(**SMALL), instances(**MORE)])

X = sym("X")

claim("D71-S32", "clearing the inverse adds no solutions",
      (X*(I + S*P) == I) & ((inv(V) - inv(V)*M*P*X*T(M)*inv(V))*(M*P*T(M) + V) == Identity(p))
      & (P == Phi*P*X*T(Phi) + H) & (P == step()),
      sizes=["n", "p"], over=DATA, where=[GRAM, let(X, I - S*inv(Phi)*(P - H)*PhiT)],
      given=[given("(3.49)", QUADRATIC == Zero(n, n))],
      by=[order([], [], [], [], [inv(I + S*P)], lemmas=[X*(I + S*P) == I, invertible(I + S*P)]),
          instances(**MORE, made_by=MADE)],
      note="The first two equations show inverses of I + SP and of MPM' + V, the other two the equilibrium equation. "
           "With (3.49) following from (3.46), both equations have the same solutions.")
