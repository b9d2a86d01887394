# SPDX-License-Identifier: MIT
"""Matrix theorems used by the thesis (Appendix B).

The update through S = M'V^{-1}M: multiply Q = P - PM'(MPM' + V)^{-1}MP by
(I + SP)(I + SP)^{-1}. In M'(MPM' + V)^{-1}MP(I + SP) the factor MPM' + V comes out
on the right of its inverse, so the bracket shrinks to I. The inverse exists
because det(I + SP) det V = det(V + MPM').

A Jordan block turned over: see `proofs.d71.turned_block`.

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
from exactkf.evidence import example, first, identity, induction, instances, order, restated, within
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    always,
    coeff,
    eq,
    forall,
    function,
    given,
    iff,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonsingular,
    nonzero,
    pd,
    positive_semidefinite,
    prod,
    psd,
    rank,
    rec,
    rows,
    scalar,
    schur,
    sequence,
    standing,
    substitute,
    sum_of,
    sym,
    symbols,
    symmetric_matrix,
    to_expr,
    vector,
    when,
)
from proofs.d71.notation import M, P, Q, V, gram, i, j, jordan_block, k, n, p, superdiagonal, update
from proofs.d71.turned_block import PASCAL, POWERS, TurnedBlock, mu, turning

I = Identity(n)
S = gram()

# --- the update ---------------------------------------------------------------------------------------------------------

UPDATE_SIZES = {"n": range(1, 4), "p": range(1, 4)}
ANY = {P: symmetric_matrix(n), M: matrix(p, n), V: symmetric_matrix(p)}
MPMV_REGULAR = given("MPM' + V nonsingular", invertible(M*P*T(M) + V))
INNER = T(M)*inv(M*P*T(M) + V)*M*P

claim("D71-T8.1", "the update through M'V^{-1}M",
      invertible(I + S*P) & invertible(I + P*S) & eq(update(), P*inv(I + S*P), inv(I + P*S)*P),
      sizes=["n", "p"], over=ANY, given=[MPMV_REGULAR],
      by=[order([I - INNER], [I - P*T(M)*inv(M*P*T(M) + V)*M], []), instances(**UPDATE_SIZES)],
      note="P and V are any symmetric matrices; V is invertible, as the formulas presuppose and the theorem "
           "does not say; P may be singular.")

CROSS = {P: matrix(n, n), M: matrix(p, n), V: nonsingular(p)}

nd = sym("nd")

claim("D71-S77", "the theorem from which the right side of (8.1a) exists",
      invertible(I + S*P), sizes=["n", "p"], over={**CROSS, nd: vector(n)},
      given=[given("what Theorem 3.20 gives", P*nd == Zero(n, 1)), given("a nonzero vector", nd != Zero(n, 1))],
      by=[example(n=2, p=1, P=[[0, 0], [0, -1]], M=[[0, 1]], V=[[1]], nd=[1, 0]), instances(n=(2,), p=(1,))],
      repair=repair(
          "cross-reference",
          "Theorem 3.20 is about undriven stable modes and gives a null vector of P; the existence of the inverse is Theorem 3.21",
          invertible(I + S*P), sizes=["n", "p"], over=CROSS, given=[MPMV_REGULAR],
          by=[order([I - INNER]), instances(**UPDATE_SIZES), example(n=2, p=1, P=[[0, 0], [0, -1]], M=[[0, 1]], V=[[1]])]),
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

X, t_ = symbols("X t")
BLOCK = TurnedBlock(n, X)
CARRIES, DIAGONAL, ADJOINT_REGULAR, PASCALS_RULE = BLOCK.carries, BLOCK.diagonal, BLOCK.regular, BLOCK.by
PRINTED_X, RIGHT_X = [PASCAL, *POWERS, let(X, turning(n, i - n))], BLOCK.where
MU_ONE = example(n=2, mu=1)
BINOMIAL = "the lower index of the binomial is n - i; with i - n every row of X but the last vanishes"

claim("D71-T8.2", "the inverse of an adjoint Jordan block is similar to a Jordan block",
      CARRIES & DIAGONAL & ADJOINT_REGULAR,
      sizes=["n"], over={mu: nonzero()}, where=[*RIGHT_X, BLOCK.reverse], by=[PASCALS_RULE, instances(n=range(1, 5))],
      note="mu stands for the conjugate of omega and may be complex, as the identities are rational in it; omega is not 0, as the inverse presupposes. "
           "The similarity is given by an explicit X, that of D71-E8.3 with its binomial put right: X = Omega* X (I/omega* + N) with nonsingular X and Omega*. "
           "X_r is X with its columns in reverse order, so that det X is det X_r or its negative; pw_k = mu^k and sg_k = (-1)^k.")

claim("D71-E8.3", "the matrix X is nonsingular and carries one block to the other",
      invertible(X) & CARRIES,
      sizes=["n"], over={mu: nonzero()}, where=PRINTED_X,
      by=[MU_ONE, instances(n=range(1, 5))],
      repair=repair("index", BINOMIAL, DIAGONAL & CARRIES,
                    sizes=["n"], over={mu: nonzero()}, where=[*RIGHT_X, BLOCK.reverse], by=[PASCALS_RULE, instances(n=range(1, 5))]),
      note="mu stands for the conjugate of omega, pw_k is mu^k and sg_k is (-1)^k. A binomial with a negative lower index is 0. The X printed is "
           "singular for every n > 1; of the corrected one, with its columns in reverse order, the repair gives the determinant.")


def example_four(two, three):
    """The matrix (8.4) with its two binomials that are not 1."""
    return rows([[0, 0, 0, -mu**6], [0, 0, mu**4, -three*mu**5], [0, -mu**2, two*mu**3, -three*mu**4], [1, -mu, mu**2, -mu**3]])


FOUR = (mu*Identity(4) + T(superdiagonal(4)))*X*jordan_block(1/mu, 4)

claim("D71-E8.4", "the matrix X for n = 4",
      eq(X, turning(4, 4 - i), FOUR),
      over={mu: nonzero()}, where=[PASCAL, *POWERS, let(X, example_four(1, 1))],
      by=[example(mu=1), instances()],
      repair=repair("factor", "the binomials are missing: 2 mu^3, -3 mu^4 in the third row and -3 mu^5 in the second",
                    eq(X, turning(4, 4 - i), FOUR),
                    over={mu: nonzero()}, where=[PASCAL, *POWERS, let(X, example_four(2, 3))], by=[identity(), instances()]),
      note="Tested against (8.3) with its binomial put right and against the equation (8.5) that X is for. All the coefficients in the scan of (8.4) are "
           "1 or -1, which fits neither of them, whichever way the index in (8.3) is read.")

claim("D71-E8.5", "the equation that X satisfies",
      CARRIES & (inv(BLOCK.adjoint)*X == X*BLOCK.turned),
      sizes=["n"], over={mu: nonzero()}, where=PRINTED_X,
      by=[MU_ONE, instances(n=range(1, 5))],
      repair=repair("index", f"{BINOMIAL} and the equation fails", CARRIES & ADJOINT_REGULAR,
                    sizes=["n"], over={mu: nonzero()}, where=RIGHT_X, by=[PASCALS_RULE, instances(n=range(1, 5))]),
      note="X is the matrix (8.3) as printed. The second equation is the first multiplied by the inverse of the adjoint block, which exists by its "
           "determinant, in the repair.")

# --- cyclic subspaces ---------------------------------------------------------------------------------------------------

A, x, a, phi, theta, v, lam, krylov, q = symbols("A x a phi theta v lam krylov q")
KRYLOV = function(krylov, [q], matrix_of(i, j, n, q, (A**(j - 1)*x)[i]))
PHI = let(phi, Z**p - sum_of(k, 1, p, a[k]*Z**(p - k)))
CYCLIC_SIZES = {"n": range(1, 4), "p": range(1, 4)}

horner, power, tail = symbols("horner power tail")

claim("D71-E8.8", "the minimal annihilating polynomial",
      forall(t_, 0, p, horner[t_]*power[p - t_]*x == power[p]*x - tail[t_]*x),
      sizes=["n", "p"], over={A: matrix(n, n), x: matrix(n, 1), a: sequence(1, p)},
      where=[rec(power, t_, I, A*power[t_]), rec(horner, t_, I, A*horner[t_] - a[t_ + 1]*I), rec(tail, t_, Zero(n, n), tail[t_] + a[t_ + 1]*power[p - 1 - t_])],
      given=[standing("the powers, counted from the end", forall(k, 0, p - 1, power[k + 1] == A*power[k]))],
      by=[induction(also=[A*horner[t_] == horner[t_]*A]), instances(**CYCLIC_SIZES)],
      note="A definition; the content checked is that phi(A)x = 0 says the same as (8.8). phi(A) is evaluated by Horner's scheme, horner_p, and the sum on the "
           "right of (8.8) is tail_p: at t = p the two sides are phi(A)x and A^p x less that sum.")

E, d, c = symbols("E d c")
CYCLIC = {A: matrix(n, n), x: vector(n), a: vector(p), lam: scalar()}
EIGHT = given("(8.8)", A**p*x == sum_of(k, 1, p, a[k]*A**(p - k)*x))
SMALLEST = given("p is the smallest", forall(q, 1, p - 1, rank(krylov(q + 1)) > rank(krylov(q))))
ZERO = given("a zero of phi", substitute(phi, lam) == 0)
NOT_ZERO = given("x is not 0", x != Zero(n, 1))
CYCLIC_MADE = {"using": {E: nonsingular(n), d: vector(n)},
               "made_by": {A: E*(matrix_of(i, j, n, n, when(i == j, d[i], 0)) + superdiagonal(n))*inv(E),
                           x: E*matrix_of(i, j, n, 1, when(i == p, 1, 0)),
                           a: matrix_of(i, j, p, 1, -coeff(prod(k, 1, p, Z - d[k]), p - i)),
                           lam: d[1]}}
#: theta = phi/(lambda - lam) by synthetic division
quotient = sym("quotient")
CYCLIC_WHERE = [PHI, function(quotient, [k], when(k == 0, 1, lam*quotient(k - 1) - a[k])),
                let(theta, sum_of(k, 0, p - 1, quotient(k)*Z**(p - 1 - k)))]
SHIFTED = A - lam*I
EIGENVECTOR = (v != Zero(n, 1)) & (theta*(Z - lam) == phi) & (SHIFTED*substitute(theta, A) == substitute(phi, A)) & (A*v == lam*v)

ell, quot, theta_t, r = symbols("ell q theta r")
LESS_LAST = r - t_
REMAINDER = (A - lam*I)*theta_t[t_]*x == power[r + 1]*x - quot[t_]*power[r + 1 - t_]*x - tail[t_]*x
#: the eigenvector theta_{r+1} x from the polynomial of degree p = r + 1
FROM_POLYNOMIAL = {
    "says": ((A - lam*I)*theta_t[r + 1]*x == Zero(n, 1)) & (ell*theta_t[r + 1]*x == Identity(1)),
    "sizes": ["n", "r"],
    "over": {A: matrix(n, n), x: matrix(n, 1), a: sequence(1, r + 1), lam: scalar(), ell: matrix(1, n)},
    "where": [rec(power, t_, I, A*power[t_]), rec(quot, t_, 1, lam*quot[t_] - a[t_ + 1]), rec(theta_t, t_, Zero(n, n), theta_t[t_] + quot[t_]*power[LESS_LAST]),
              rec(tail, t_, Zero(n, n), tail[t_] + a[t_ + 1]*power[LESS_LAST])],
    "given": [standing("the powers, counted from the end", forall(k, 0, r, power[k + 1] == A*power[k])),
              given("(8.8)", power[r + 1]*x == tail[r + 1]*x), given("a zero of phi", quot[r + 1] == 0),
              given("p is the smallest", forall(k, 0, r - 1, ell*power[k]*x == Zero(1, 1)) & (ell*power[r]*x == Identity(1)))],
    "by": [restated("A polynomial has a complex zero, and identities between polynomials that hold for real numbers hold for complex ones."),
           induction(before=[first(forall(t_, 0, r + 1, REMAINDER)), first(forall(t_, 1, r + 1, ell*theta_t[t_]*x == Identity(1)))]),
           example(n=1, r=0, A=[[1]], x=[[1]], a=[2], lam=2, ell=[[1]]), example(n=1, r=0, A=[[1]], x=[[1]], a=[1], lam=2, ell=[[1]]),
           example(n=1, r=0, A=[[1]], x=[[1]], a=[1], lam=1, ell=[[0]]),
           instances(n=range(1, 4), r=range(3), using={E: nonsingular(n), d: vector(n)},
                     made_by={A: E*(matrix_of(i, j, n, n, when(i == j, d[i], 0)) + superdiagonal(n))*inv(E), x: E*matrix_of(i, j, n, 1, when(i == r + 1, 1, 0)),
                              a: (k, -coeff(prod(t_, 1, r + 1, Z - d[t_]), r + 1 - k)), lam: d[1], ell: matrix_of(i, j, 1, n, when(j == 1, 1, 0))*inv(E)})]}

claim("D71-E8.11", "an eigenvector from the annihilating polynomial",
      EIGENVECTOR,
      sizes=["n", "p"], over=CYCLIC, where=[KRYLOV, *CYCLIC_WHERE, let(v, theta*x)], given=[EIGHT, SMALLEST, ZERO, NOT_ZERO],
      by=[example(n=2, p=2, A=[[1, 0], [0, 2]], x=[1, 1], a=[3, -2], lam=1), instances(**CYCLIC_SIZES, **CYCLIC_MADE)],
      repair=repair(
          "other", "v is theta(A)x, the matrix in place of lambda, as the next display of the proof has it; theta(lambda)x is a multiple of x",
          **FROM_POLYNOMIAL),
      note="The quotient theta is written out by synthetic division: q_0 = 1, q_1, ... are its coefficients, in the repair theta_t the sum of the first t "
           "of its terms at A, and p = r + 1. The powers are counted from the end. That p is the smallest says that A^r x is no combination of the powers "
           "before it, and so that some row l has l A^r x = 1 and l A^k x = 0 for k < r; then l v = 1. Real zeros of phi; the equations are polynomial in "
           "the zero.")

claim("D71-T8.3", "a cyclic subspace contains an eigenvector",
      **FROM_POLYNOMIAL,
      note="The eigenvector is theta_{r+1} x, a combination of x, ..., A^r x that is not zero, as the row l takes it to 1: see D71-E8.11. x is not 0, as "
           "the subspace of x = 0 has no vector but zero. Real zeros of phi: a rotation of the plane has complex eigenvectors only, so over the real "
           "numbers the statement needs such a zero.")

# --- the equation A'QA - Q = R ------------------------------------------------------------------------------------------

R, G, t, partial, back = symbols("R G t partial back")
LYAPUNOV = given("A'QA - Q = R", T(A)*Q*A - Q == R)
OUTSIDE = given("the eigenvalues of A lie outside the unit circle", schur(inv(A)))
SUMS = [rec(back, t, I, inv(A)*back[t]), rec(partial, t, Zero(n, n), partial[t] + T(inv(A)*back[t])*R*(inv(A)*back[t]))]


def factor(at):
    """An eigenvalue outside the unit circle, of either sign."""
    return when(at == 2, -1, 1)*(1 + (1 + c[at]**2)/2)


def solved(weight):
    """A = E diag(f) E^{-1} with |f_i| > 1, and Q and R that solve the equation, R congruent to ``weight``."""
    return {"using": {E: nonsingular(n), G: matrix(n, n), c: vector(n)},
            "made_by": {A: E*matrix_of(i, j, n, n, when(i == j, factor(i), 0))*inv(E),
                        R: T(inv(E))*weight*inv(E),
                        Q: T(inv(E))*matrix_of(i, j, n, n, weight[i, j]/(factor(i)*factor(j) - 1))*inv(E)}}


#: weights: any rank, rank one, a zero row and column
FULL = G*T(G)
RANK_ONE = matrix_of(i, j, n, n, G[i, 1]*G[j, 1])
THIN = matrix_of(i, j, n, n, when((i == 1) | (j == 1), 0, FULL[i, j]))

claim("D71-E8.14", "the solution as a series",
      always(t, Q - partial[t] == T(back[t])*Q*back[t]) & (pd(R) >> pd(Q)),
      sizes=["n"], over={A: nonsingular(n), Q: symmetric_matrix(n), R: symmetric_matrix(n)}, where=SUMS, given=[LYAPUNOV, OUTSIDE],
      by=[restated("The powers of a matrix with its eigenvalues inside the unit circle tend to zero."),
          induction(base=(order(), order([T(inv(A))*R*inv(A)], inside=[within(0, stein=T(inv(A)))]))),
          example(n=1, A=[["1/2"]], Q=[[-4]], R=[[3]]), instances(n=range(1, 4), **solved(FULL)), instances(n=range(1, 4), **solved(-FULL))],
      note="Real case. The remainder after N terms is (A^{-N})'QA^{-N} exactly, for every solution Q; as it tends to zero the series converges to Q "
           "and there is one solution only.")

al, be, u, w = symbols("al be u w")

MODULUS = al**2 + be**2 - 1
EIGEN_GIVEN = [LYAPUNOV, given("Ax = lambda x, real part", A*u == al*u - be*w), given("Ax = lambda x, imaginary part", A*w == be*u + al*w),
               given("Ru = 0", R*u == Zero(n, 1)), given("Rw = 0", R*w == Zero(n, 1)), given("|lambda| > 1", al**2 + be**2 > 1)]


ROTATED = matrix_of(i, j, n, n, when((i <= 2) & (j <= 2), when(i == j, al, when(i < j, be, -be)), when(i == j, factor(i), 0)))
STRAIGHT = matrix_of(i, j, n, n, when(i == j, when(i == 1, al, when(i == 2, 1/al, factor(i))), 0))
FLAT = matrix_of(i, j, n, n, when((i <= 2) & (j <= 2), 0, FULL[i, j]))
CROSSED = matrix_of(i, j, n, n, when((i == 1) & (j == 1), 0, when((i == 1) | (j == 1), when(i + j == 3, 1, 0), FULL[i, j])))


def eigenpair(turn, form):
    return {A: E*turn*inv(E), Q: T(inv(E))*form*inv(E), R: T(E*turn*inv(E))*T(inv(E))*form*inv(E)*(E*turn*inv(E)) - T(inv(E))*form*inv(E)}


EIGEN_USING = {E: nonsingular(n), G: matrix(n, n), c: vector(n)}

claim("D71-E8.15", "an eigenvector of A that is a null vector of R",
      (MODULUS*(T(u)*Q*u + T(w)*Q*w) == 0) & (T(u)*Q*u + T(w)*Q*w == 0),
      sizes=["n"], over={A: matrix(n, n), Q: symmetric_matrix(n), R: symmetric_matrix(n), al: scalar(), be: scalar(), u: vector(n), w: vector(n)},
      given=EIGEN_GIVEN,
      by=[order([], [1/MODULUS]),
          example(n=1, A=[[1]], Q=[[1]], R=[[0]], al=1, be=0, u=[1], w=[0]),
          example(n=1, A=[[1]], Q=[[1]], R=[[0]], al=2, be=1, u=[1], w=[1]),
          example(n=1, A=[[1]], Q=[[1]], R=[[0]], al=2, be=-1, u=[1], w=[1]),
          example(n=1, A=[[2]], Q=[[1]], R=[[3]], al=2, be=0, u=[1], w=[0]),
          example(n=1, A=[[2]], Q=[[1]], R=[[3]], al=2, be=0, u=[0], w=[1]),
          instances(n=(2, 3), using=EIGEN_USING,
                    made_by={**eigenpair(ROTATED, FLAT), u: E*matrix_of(i, j, n, 1, when(i == 1, 1, 0)), w: E*matrix_of(i, j, n, 1, when(i == 2, 1, 0))}),
          instances(n=(2, 3), using=EIGEN_USING,
                    made_by={**eigenpair(STRAIGHT, CROSSED), be: to_expr(0), u: 2*E*matrix_of(i, j, n, 1, when(i == 1, 1, 0)),
                             w: 3*E*matrix_of(i, j, n, 1, when(i == 1, 1, 0))})],
      note="x = u + iw and lambda = al + i be may be complex, A, Q and R are real: x*Qx = u'Qu + w'Qw. The text says that "
           "(8.14) makes x*Qx vanish; (8.15) does so at once, and (8.14) too, as its terms all vanish at x.")

n0 = sym("n0")
SUM_NULL = (Q + R)*x == Zero(n, 1)

claim("D71-E8.16", "a null vector of Q goes to another one",
      eq(T(x)*(Q + R)*x, T(n0)*Q*n0, 0) & SUM_NULL & iff(SUM_NULL, (Q*x == Zero(n, 1)) & (R*x == Zero(n, 1))),
      sizes=["n"], over={A: nonsingular(n), Q: positive_semidefinite(n), R: positive_semidefinite(n), n0: vector(n)}, where=[let(x, inv(A)*n0)],
      given=[LYAPUNOV, given("Qn = 0", Q*n0 == Zero(n, 1))],
      by=[order([], [], [Q, R], [Q, R], []),
          instances(n=range(1, 4), using=solved(THIN)["using"], made_by={**solved(THIN)["made_by"], n0: E*matrix_of(i, j, n, 1, when(i == 1, 1, 0))})],
      note="Real case. The form x'(Q + R)x of a nonnegative definite matrix vanishes exactly if (Q + R)x = 0, and then Qx = Rx = 0. As x is again a "
           "null vector of Q, the step repeats for A^{-1}x, A^{-2}x, ...")

x1, x2, n1, n2 = symbols("x1 x2 n1 n2")
GONE = Zero(n, 1)
#: the form x*Qx of an eigenvector that R kills, and x*Rx of one that Q kills
FORM_OF_Q = [T(u)*Q*u, T(w)*Q*w]
FORM_OF_R = [T(x1)*R*x1, T(x2)*R*x2]


def eigenvector(real, imaginary):
    return (A*real == al*real - be*imaginary) & (A*imaginary == be*real + al*imaginary)


X1, X2 = (matrix_of(i, j, n, 1, when(i == k_, 1, 0)) for k_ in (1, 2))
SPIRAL = {al: 2 + c[1]**2, be: c[2], A: E*matrix_of(i, j, 3, 3, when((i == 3) | (j == 3), when(i == j, 2, 0), when(i == j, al, when(i < j, be, -be))))*inv(E),
          R: T(inv(E))*matrix_of(i, j, 3, 3, when((i == 3) & (j == 3), 3*c[3]**2, 0))*inv(E),
          Q: T(inv(E))*matrix_of(i, j, 3, 3, when((i == 3) & (j == 3), c[3]**2, 0))*inv(E)}
ONE = {"n": 1, "A": [[2]], "Q": [[1]], "R": [[3]], "al": 2, "be": 0, **dict.fromkeys(("u", "w", "x1", "x2", "n1"), [0])}
TWO = {"n": 2, "A": [[2, 1], [0, 2]], "Q": [["1/3", "-2/9"], ["-2/9", "5/27"]], "R": [[1, 0], [0, 0]], "al": 2, "be": 0,
       **dict.fromkeys(("u", "w", "x1", "x2", "n1"), [0, 0])}

claim("D71-T8.4", "when the solution is singular",
      (Q*u == GONE) & (Q*w == GONE) & (R*x1 == GONE) & (R*x2 == GONE) & (Q*n2 == GONE) & (R*n2 == GONE),
      sizes=["n"], over={A: nonsingular(n), Q: symmetric_matrix(n), R: positive_semidefinite(n), al: scalar(), be: scalar(),
                         **dict.fromkeys((u, w, x1, x2, n1), vector(n))},
      where=[let(n2, inv(A)*n1)],
      given=[LYAPUNOV, OUTSIDE, standing("|lambda| > 1, as for all eigenvalues", al**2 + be**2 > 1), given("an eigenvector", eigenvector(u, w)),
             given("a null vector of R", (R*u == GONE) & (R*w == GONE)), standing("another eigenvector", eigenvector(x1, x2)),
             given("a null vector of Q", (Q*x1 == GONE) & (Q*x2 == GONE)), given("any null vector of Q", Q*n1 == GONE)],
      by=[restated("An invariant subspace other than {0} contains an eigenvector."),
          order([T(inv(A))*R*inv(A)], [], [1/MODULUS], [], [Q, R], FORM_OF_Q, FORM_OF_Q, FORM_OF_R, FORM_OF_R, [Q, R], [Q, R],
                lemmas=[psd(Q), MODULUS*(T(u)*Q*u + T(w)*Q*w) == 0, (T(u)*Q*u + T(w)*Q*w)*Identity(1) == Zero(1, 1),
                        (T(x1)*R*x1 + T(x2)*R*x2)*Identity(1) == Zero(1, 1), (Q + R)*n2 == GONE],
                inside=[within(0, stein=T(inv(A)))]),
          example({**ONE, "u": [1], "R": [[0]]}), example({**ONE, "u": [1]}), example({**ONE, "x1": [1]}), example({**ONE, "n1": [1]}),
          example({**TWO, "A": [[2, 0], [0, "1/2"]], "Q": [[0, 1], [1, 0]], "R": [[0, 0], [0, 0]], "u": [1, 0]}), example({**TWO, "u": [0, 1]}),
          instances(8, n=(3,), using={E: nonsingular(3), c: vector(3)}, made_by={**SPIRAL, u: E*X1, w: E*X2, x1: E*X1, x2: E*X2, n1: E*(c[2]*X1 + c[3]*X2)}),
          instances(8, n=(2, 3), using={E: nonsingular(n), c: vector(n), G: matrix(n, n)},
                    made_by={al: factor(to_expr(1)), be: to_expr(0), **solved(THIN)["made_by"], u: E*X1, w: 2*E*X1, x1: -E*X1, x2: E*X1, n1: E*X1})],
      note="Real matrices, an eigenvector u + iw of A at lambda = al + i be. An eigenvector that R kills is killed by Q, so that Q is singular; one that Q "
           "kills is killed by R. If Q is singular there is one: A^{-1}, from n1 to n2, takes null vectors of Q to null vectors of Q and R, and an "
           "invariant subspace other than {0} contains a complex eigenvector. The classical fact for Q >= 0 is that the powers of A^{-1} tend to zero.")
