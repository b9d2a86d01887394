# SPDX-License-Identifier: MIT
"""Matrix theorems used by the thesis (Appendix B).

The update through S = M'V^{-1}M: multiply Q = P - PM'(MPM' + V)^{-1}MP by
(I + SP)(I + SP)^{-1}. In M'(MPM' + V)^{-1}MP(I + SP) the factor MPM' + V comes out
on the right of its inverse, so the bracket shrinks to I. The inverse exists
because det(I + SP) det V = det(V + MPM').

A Jordan block turned over: with mu the eigenvalue of the adjoint block mu I + N',
put x_ij = (-1)^{j-1} C(j-1, n-i) mu^{n+j-i-1}. Row i of the adjoint block adds row
i - 1, column j of mu^{-1}I + N adds column j - 1, and what has to vanish is Pascal's
rule. X is zero above its second diagonal, and det X = mu^{n(n-1)}.

Cyclic subspaces: divide the annihilating polynomial phi of x by lambda - lambda_i.
The quotient theta gives (A - lambda_i I) theta(A)x = phi(A)x - phi(lambda_i)x = 0,
while theta(A)x has the coefficient one at the last of the independent vectors
x, Ax, ..., A^{p-1}x.

The equation A'QA - Q = R: put it into itself to get the sum of (A^{-i})'RA^{-i}
up to N and the remainder (A^{-N})'QA^{-N}, which dies out when the eigenvalues of A
lie outside the unit circle. A null vector of Q goes to another one under A^{-1} and
is a null vector of R on the way; so the null space of Q is the largest invariant
subspace inside the null space of R.

The matrices are real here. An eigenvector u + iv to an eigenvalue alpha + i beta is
a pair Au = alpha u - beta v, Av = beta u + alpha v.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import combination, example, identity, induction, instances, order, steps
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    always,
    det,
    diagonal,
    eq,
    forall,
    function,
    given,
    hstack,
    iff,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonsingular,
    nonzero,
    pd,
    positive,
    positive_definite,
    positive_semidefinite,
    rank,
    rec,
    rows,
    scalar,
    schur,
    sequence,
    substitute,
    sum_of,
    sym,
    symbols,
    symmetric_matrix,
    vector,
    when,
)
from proofs.d71.notation import H, M, P, Q, V, gram, i, j, jordan_block, k, n, p, superdiagonal, update

I = Identity(n)  # noqa: E741
S = gram()

# --- the update ---------------------------------------------------------------------------------------------------------

UPDATE_SIZES = {"n": range(1, 4), "p": range(1, 4)}
ANY = {P: symmetric_matrix(n), M: matrix(p, n), V: symmetric_matrix(p)}
V_REGULAR = given("V nonsingular", invertible(V))
MPMV_REGULAR = given("MPM' + V nonsingular", invertible(M*P*T(M) + V))
INNER = T(M)*inv(M*P*T(M) + V)*M*P

claim("D71-T8.1", "the update through M'V^{-1}M",
      invertible(I + S*P) & invertible(I + P*S) & eq(update(), P*inv(I + S*P), inv(I + P*S)*P),
      sizes=["n", "p"], over=ANY, given=[MPMV_REGULAR],
      by=[order([I - INNER], [I - P*T(M)*inv(M*P*T(M) + V)*M], []), instances(**UPDATE_SIZES)],
      note="P and V are any symmetric matrices; V is invertible, as the formulas presuppose; P may be singular.")

CROSS = {P: matrix(n, n), M: matrix(p, n), V: nonsingular(p)}

nd = sym("nd")

claim("D71-S77", "the theorem from which the right side of (8.1a) exists",
      invertible(I + S*P), sizes=["n", "p"], over={**CROSS, nd: vector(n)},
      given=[given("what Theorem 3.20 gives", P*nd == Zero(n, 1)), given("a nonzero vector", nd != Zero(n, 1))],
      by=[example(n=2, p=1, P=[[0, 0], [0, -1]], M=[[0, 1]], V=[[1]], nd=[1, 0]), instances(n=(2,), p=(1,))],
      repair=repair(
          "cross-reference",
          "Theorem 3.20 is about undriven stable modes and gives a null vector of P; the existence of the inverse is Theorem 3.21",
          (invertible(M*P*T(M) + V) >> invertible(I + S*P)) & (invertible(I + S*P) >> invertible(M*P*T(M) + V)), sizes=["n", "p"], over=CROSS,
          by=[instances(**UPDATE_SIZES), example(n=2, p=1, P=[[0, 0], [0, -1]], M=[[0, 1]], V=[[1]]),
              example(n=1, p=2, P=[[-1]], M=[[1], [0]], V=[[1, 0], [0, 1]])]),
      note="Read as: what the cited theorem says about P makes I + M'V^{-1}MP invertible. The existence itself is right and part of D71-T8.1.")

claim("D71-E8.2", "the update step by step",
      eq(update(),
         P*(I - T(M)*inv(M*P*T(M) + V)*M*P)*(I + S*P)*inv(I + S*P),
         P*(I + S*P - INNER*(I + S*P))*inv(I + S*P),
         P*(I + S*P - T(M)*inv(M*P*T(M) + V)*(M*P*T(M) + V)*inv(V)*M*P)*inv(I + S*P),
         P*inv(I + S*P)),
      sizes=["n", "p"], over=ANY,
      by=[identity(n=(1, 2), p=(1, 2)), instances(**UPDATE_SIZES)])

# --- a Jordan block turned over -----------------------------------------------------------------------------------------

mu, X, choose, a_, b_ = symbols("mu X choose a_ b_")
PASCAL = function(choose, [a_, b_], when(b_ == 0, 1, when((b_ < 0) | (b_ > a_), 0, choose(a_ - 1, b_ - 1) + choose(a_ - 1, b_))))
ADJOINT = mu*I + T(superdiagonal(n))
TURNED = jordan_block(1/mu, n)


def turning(size, lower):
    """The matrix (8.3) with the lower index of its binomial."""
    return matrix_of(i, j, size, size, when(j > size - i, (-1)**(j - 1)*choose(j - 1, lower)*mu**(size + j - i - 1), 0))


PRINTED_X = [PASCAL, let(X, turning(n, i - n))]
RIGHT_X = [PASCAL, let(X, turning(n, n - i))]
TO_6 = range(1, 7)
MU_ONE = example(n=2, mu=1)
BINOMIAL = "the lower index of the binomial is n - i; with i - n every row of X but the last vanishes"

claim("D71-T8.2", "the inverse of an adjoint Jordan block is similar to a Jordan block",
      (inv(ADJOINT) == X*TURNED*inv(X)) & (det(X) == mu**(n*(n - 1))),
      sizes=["n"], over={mu: nonzero()}, where=RIGHT_X,
      by=[identity(n=TO_6), instances(n=range(1, 5))],
      note="mu stands for the conjugate of omega and may be complex, as the identities are rational in it; omega is not 0, as the inverse presupposes. "
           "The similarity is given by an explicit X, that of D71-E8.3 with its binomial put right, and the determinant shows that X^{-1} exists.")

claim("D71-E8.3", "the matrix X is nonsingular and carries one block to the other",
      (det(X) == mu**(n*(n - 1))) & (X == ADJOINT*X*TURNED),
      sizes=["n"], over={mu: nonzero()}, where=PRINTED_X,
      by=[MU_ONE, instances(n=range(1, 5))],
      repair=repair("index", BINOMIAL, (det(X) == mu**(n*(n - 1))) & (X == ADJOINT*X*TURNED),
                    sizes=["n"], over={mu: nonzero()}, where=RIGHT_X, by=[identity(n=TO_6), instances(n=range(1, 5))]),
      note="mu stands for the conjugate of omega. A binomial with a negative lower index is 0. That X is nonsingular is stated with the value of its "
           "determinant; the X printed is singular for every n > 1.")


def example_four(two, three):
    """The matrix (8.4) with its two binomials that are not 1."""
    return rows([[0, 0, 0, -mu**6], [0, 0, mu**4, -three*mu**5], [0, -mu**2, two*mu**3, -three*mu**4], [1, -mu, mu**2, -mu**3]])


FOUR = (mu*Identity(4) + T(superdiagonal(4)))*X*jordan_block(1/mu, 4)

claim("D71-E8.4", "the matrix X for n = 4",
      X == FOUR,
      over={mu: nonzero()}, where=[let(X, example_four(1, 1))],
      by=[example(mu=1), instances()],
      repair=repair("factor", "the binomials are missing: 2 mu^3, -3 mu^4 in the third row and -3 mu^5 in the second",
                    eq(X, turning(4, 4 - i), FOUR),
                    over={mu: nonzero()}, where=[PASCAL, let(X, example_four(2, 3))], by=[identity(), instances()]),
      note="The printed example is tested against the equation (8.5) that X is for; it agrees with no choice of index in (8.3) either.")

claim("D71-E8.5", "the equation that X satisfies",
      (X == ADJOINT*X*TURNED) & (inv(ADJOINT)*X == X*TURNED),
      sizes=["n"], over={mu: nonzero()}, where=PRINTED_X,
      by=[MU_ONE, instances(n=range(1, 5))],
      repair=repair("index", f"{BINOMIAL} and the equation fails", (X == ADJOINT*X*TURNED) & (inv(ADJOINT)*X == X*TURNED),
                    sizes=["n"], over={mu: nonzero()}, where=RIGHT_X, by=[identity(n=TO_6), instances(n=range(1, 5))]),
      note="X is the matrix (8.3) as printed. The second equation is the first multiplied by the inverse of the adjoint block.")

# --- cyclic subspaces ---------------------------------------------------------------------------------------------------

A, x, a, phi, theta, v, lam, krylov, q = symbols("A x a phi theta v lam krylov q")
KRYLOV = function(krylov, [q], matrix_of(i, j, n, q, (A**(j - 1)*x)[i]))
LAST = sum_of(k, 1, p, a[k]*A**(p - k)*x)
PHI = let(phi, Z**p - sum_of(k, 1, p, a[k]*Z**(p - k)))
CYCLIC_SIZES = {"n": range(1, 4), "p": range(1, 4)}

claim("D71-E8.8", "the minimal annihilating polynomial",
      substitute(phi, A)*x == A**p*x - sum_of(k, 1, p, a[k]*A**(p - k)*x),
      sizes=["n", "p"], over={A: matrix(n, n), x: vector(n), a: sequence(1, p)}, where=[PHI],
      by=[identity(**CYCLIC_SIZES), instances(**CYCLIC_SIZES)],
      note="A definition; the content checked is that phi(A)x = 0 says the same as (8.8): the two differ by nothing at all.")
