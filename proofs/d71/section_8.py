# SPDX-License-Identifier: MIT
"""Some matrix theorems (Appendix B).

The update P - PM'(MPM' + V)^{-1}MP equals P(I + SP)^{-1} with S = M'V^{-1}M, by
MP(I + SP) = (V + MPM')V^{-1}MP; nothing is asked of P. The inverse exists because
det(I + SP) det V = det(MPM' + V).

The inverse of a transposed Jordan block is similar to a Jordan block: with
mu != 0 and Omega* = mu I + N', X = Omega* X(mu^{-1}I + N) is a recursion for the
entries of X, mu x_{i,j-1} + mu^{-1}x_{i-1,j} + x_{i-1,j-1} = 0, and binomial
coefficients solve it: x_{ij} = (-1)^{j-1} C(j-1, n-i) mu^{n+j-i-1}. X is zero above the
antidiagonal, and det X = mu^{n(n-1)}.

A vector x != 0 with minimal annihilating polynomial phi = g theta makes v = theta(A)x a
nonzero vector with g(A)v = 0; for g = z - lambda that is an eigenvector in the cyclic
space of x.

If all eigenvalues of A lie outside the unit circle, Q = sum_i A^{-i}'RA^{-i} solves
A'QA - Q = R. A null vector n of Q >= 0 gives x = A^{-1}n with x'(Q + R)x = n'Qn = 0, so the
null space of Q is invariant under A^{-1} and lies in that of R; it is zero unless it
contains an eigenvector, by the theorem on cyclic spaces.

A complex number mu = omega* enters as a free symbol where the statement is an
identity; a complex eigenvector u + iv enters through its real and imaginary part.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import combination, example, identity, instances, steps
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    block,
    coeff,
    det,
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
    monic,
    nonsingular,
    nonzero,
    pd,
    positive_definite,
    positive_semidefinite,
    psd,
    rank,
    rows,
    scalar,
    schur,
    substitute,
    sum_of,
    sym,
    symbols,
    symmetric_matrix,
    to_expr,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import M, P, Q, V, gram, i, j, k, n, p, superdiagonal, update

I = Identity(n)  # noqa: E741
SIZES = {"n": (1, 2), "p": (1, 2)}
MORE = {"n": (1, 2, 3), "p": (1, 2, 3)}
S = sym("S")
UPDATE = [let(S, gram()), let(Q, update())]
ANY_P = {P: matrix(n, n), M: matrix(p, n), V: nonsingular(p)}

# --- the matrix inversion lemma without an inverse of P -----------------------------------------------------------------

claim("D71-T8.1", "the update without an inverse of P",
      eq(Q, P*inv(I + S*P), inv(I + P*S)*P),
      sizes=["n", "p"], over=ANY_P, where=UPDATE,
      by=[identity(**SIZES), instances(**MORE)],
      note="P is any square matrix and V any invertible one. That the inverses exist when MPM' + V is invertible is the next claim.")

claim("D71-S77", "why the right side exists",
      invertible(I + S*P) & (det(P) == 0),
      sizes=["n", "p"], over={P: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}, where=[let(S, gram())],
      given=[given("MPM' + V is nonsingular", invertible(M*P*T(M) + V))],
      by=[example(n=1, p=1, P=[[1]], M=[[1]], V=[[1]]), instances(**MORE)],
      repair=repair(
          "cross-reference", "Theorem 3.20 says when a nonnegative definite equilibrium is singular; the existence is Theorem 3.21",
          det(I + S*P)*det(V) == det(M*P*T(M) + V),
          sizes=["n", "p"], over=ANY_P, where=[let(S, gram())],
          by=[identity(n=(1, 2, 3), p=(1, 2)), instances(**MORE)]),
      note="The existence is true, but it is credited to Theorem 3.20, whose conclusion, that P is singular, is put beside it here: it does not "
           "follow from MPM' + V being nonsingular. In the corrected form the determinants vanish together, which is Theorem 3.21.")

x = sym("x")

claim("D71-E8.2", "from the update to the form without an inverse of P",
      eq(Q,
         P*(I - T(M)*inv(M*P*T(M) + V)*M*P)*(I + S*P)*inv(I + S*P),
         P*(I + S*P - T(M)*inv(M*P*T(M) + V)*M*P*(I + S*P))*inv(I + S*P),
         P*(I + S*P - T(M)*inv(M*P*T(M) + V)*(M*P*T(M) + V)*inv(V)*M*P)*inv(I + S*P),
         P*inv(I + S*P)),
      sizes=["n", "p"], over=ANY_P, where=UPDATE,
      by=[identity(**SIZES), instances(**MORE)])

# --- the inverse of a transposed Jordan block ---------------------------------------------------------------------------

mu, Om, X, X4, c, a, b, Ch = symbols("mu Om X X4 c a b Ch")
N = superdiagonal(n)
CHOOSE = function(Ch, [a, b], when((b < 0) | (b > a), 0, when((b == 0) | (b == a), 1, Ch(a - 1, b - 1) + Ch(a - 1, b))))
OMEGA_STAR = let(Om, mu*I + T(N))


def printed_x(lower):
    """The matrix of (8.3) with the given lower index of its binomial coefficient."""
    return let(X, matrix_of(i, j, n, n, when(j > n - i, to_expr(-1)**(j - 1)*Ch(j - 1, lower)*mu**(n + j - i - 1), 0)))


AS_PRINTED, CORRECTED = [CHOOSE, OMEGA_STAR, printed_x(i - n)], [CHOOSE, OMEGA_STAR, printed_x(n - i)]
SQUARE = {"n": range(1, 7)}
WRONG_INDEX = "the lower index of the binomial coefficient is n - i, not i - n, which is negative above the last row"
INTERTWINES = X == Om*X*(I/mu + N)
ALSO = inv(Om)*X == X*(I/mu + N)

claim("D71-T8.2", "the inverse of a transposed Jordan block",
      (inv(Om)*X == X*(I/mu + N)) & (det(X) == mu**(n*(n - 1))),
      sizes=["n"], over={mu: nonzero()}, where=CORRECTED,
      by=[identity(**SQUARE), instances(n=range(1, 6))],
      note="Similarity is shown by its matrix X, the one of (8.3) with the lower index n - i; mu is the conjugate of omega.")

claim("D71-E8.3", "the matrix of the similarity",
      (X == Om*X*(I/mu + N)) & (det(X) == mu**(n*(n - 1))),
      sizes=["n"], over={mu: nonzero()}, where=AS_PRINTED,
      by=[example(n=2, mu=1), instances(n=range(1, 6))],
      repair=repair("index", WRONG_INDEX, (X == Om*X*(I/mu + N)) & (det(X) == mu**(n*(n - 1))),
                    sizes=["n"], over={mu: nonzero()}, where=CORRECTED, by=[identity(**SQUARE), instances(n=range(1, 6))]),
      note="A binomial coefficient with negative lower index is zero. The determinant says that X is nonsingular.")

X_PRINTED = rows([[0, 0, 0, -mu**6], [0, 0, mu**4, -mu**5], [0, -mu**2, mu**3, -mu**4], [1, -mu, mu**2, -mu**3]])
X_CORRECTED = rows([[0, 0, 0, -mu**6], [0, 0, mu**4, -3*mu**5], [0, -mu**2, 2*mu**3, -3*mu**4], [1, -mu, mu**2, -mu**3]])
N4 = superdiagonal(4)

claim("D71-E8.4", "the matrix of the similarity of order four",
      X4 == (mu*Identity(4) + T(N4))*X4*(Identity(4)/mu + N4),
      over={mu: nonzero()}, where=[let(X4, X_PRINTED)],
      by=[example(mu=1), instances()],
      repair=repair(
          "factor", "the binomial coefficients 2, 3, 3 are missing: the entries (3,3), (3,4), (2,4) are 2mu^3, -3mu^4, -3mu^5",
          (X4 == (mu*Identity(4) + T(N4))*X4*(Identity(4)/mu + N4)) & (X4 == X),
          over={mu: nonzero()}, where=[let(n, 4), *CORRECTED, let(X4, X_CORRECTED)],
          by=[identity(), instances()]),
      note="Printed as an example of the matrix that satisfies X = Omega* X(mu^{-1}I + N), which it does not.")

claim("D71-E8.5", "the equation of the similarity",
      INTERTWINES & ALSO,
      sizes=["n"], over={mu: nonzero()}, where=AS_PRINTED,
      by=[example(n=2, mu=1), instances(n=range(1, 6))],
      repair=repair("index", f"X is the matrix of (8.3), where {WRONG_INDEX}", INTERTWINES & ALSO,
                    sizes=["n"], over={mu: nonzero()}, where=CORRECTED, by=[identity(**SQUARE), instances(n=range(1, 6))]))

# --- cyclic subspaces -----------------------------------------------------------------------------------------------------

A, G, C, theta, g, phi, lam, v, al, W, U, R, Kr, zero, one = symbols("A G C theta g phi lam v al W U R Kr zero one")
d, q, e = symbols("d q e")


def first(size):
    """The first unit vector."""
    return matrix_of(i, j, size, 1, when(i == 1, 1, 0))


def companion(polynomial, degree):
    """The matrix that takes e_1 to e_2, e_2 to e_3, ... and the last e_p to what the polynomial says."""
    return matrix_of(i, j, degree, degree, when(j < degree, when(i == j + 1, 1, 0), -coeff(polynomial, i - 1)))


def cyclic_matrix(polynomial, degree):
    """A matrix for which G e_1 has this annihilating polynomial."""
    return G*block([[companion(polynomial, degree), W], [Zero(e, degree), U]])*inv(G)


ANNIHILATING = Z**q - sum_of(i, 1, q, al[i]*Z**(q - i))

claim("D71-E8.8", "the annihilating polynomial of a vector",
      substitute(phi, A)*x == zero,
      sizes=["q", "e"], over={A: matrix(q + e, q + e), x: vector(q + e), al: vector(q)},
      where=[let(phi, ANNIHILATING), let(zero, Zero(q + e, 1))],
      given=[given("A^p x is a combination", A**q*x == sum_of(i, 1, q, al[i]*A**(q - i))*x)],
      by=[combination([(1, "A^p x is a combination", 1)], q=(1, 2), e=(0, 1)),
          instances(q=(2, 4), e=(0, 4), using={G: nonsingular(q + e), W: matrix(q, e), U: matrix(e, e)},
                    made_by={A: cyclic_matrix(ANNIHILATING, q), x: G*first(q + e)})],
      note="Cyclic subspaces and their polynomial are definitions; the content checked is that the relation among the A^i x reads phi(A)x = 0.")

SIZE = d + q + e
KRYLOV = let(Kr, matrix_of(i, j, SIZE, d + q, (A**(j - 1)*x)[i]))
FACTORED = {A: matrix(SIZE, SIZE), x: vector(SIZE), theta: monic(q), g: monic(d)}
MINIMAL = [given("phi(A)x = 0", substitute(g*theta, A)*x == Zero(SIZE, 1)), given("phi is minimal", rank(Kr) == d + q)]

claim("D71-T8.3", "a cyclic subspace contains an eigenvector",
      (substitute(g, A)*v == zero) & (rank(v) == 1) & (rank(hstack(Kr, v)) == rank(Kr)),
      sizes=["d", "q", "e"], over=FACTORED, where=[KRYLOV, let(zero, Zero(SIZE, 1)), let(v, substitute(theta, A)*x)], given=MINIMAL,
      by=[steps("D71-E8.8", facts=["A real polynomial of positive degree has a real factor of degree one or two."],
                prose="g(A)theta(A)x = phi(A)x = 0, and theta(A)x is not zero as theta has a smaller degree than phi."),
          instances(d=(1, 2), q=(1, 4), e=(0,), using={G: nonsingular(SIZE), W: matrix(d + q, e), U: matrix(e, e)},
                    made_by={A: cyclic_matrix(g*theta, d + q), x: G*first(SIZE)})],
      note="phi = g theta is the annihilating polynomial, of positive degree, so x != 0 (the text allows any x, but {0} has no eigenvector). "
           "For deg g = 1, v is an eigenvector; for deg g = 2 with complex roots the span of v and Av contains the two complex ones.")

LINEAR = {A: matrix(1 + q + e, 1 + q + e), x: vector(1 + q + e), theta: monic(q), lam: scalar()}
LINEAR_KRYLOV = let(zero, Zero(1 + q + e, 1)), let(one, Identity(1 + q + e)), let(Kr, matrix_of(i, j, 1 + q + e, 1 + q, (A**(j - 1)*x)[i]))
LINEAR_MINIMAL = [given("phi(A)x = 0", substitute(phi, A)*x == Zero(1 + q + e, 1)), given("phi is minimal", rank(Kr) == 1 + q)]
EIGENVECTOR = eq((A - lam*one)*v, substitute(phi, A)*x, zero) & (rank(v) == 1)
LINEAR_MADE = instances(q=(1, 4), e=(0, 1), using={G: nonsingular(1 + q + e), W: matrix(1 + q, e), U: matrix(e, e)},
                        made_by={A: cyclic_matrix((Z - lam)*theta, 1 + q), x: G*first(1 + q + e)})

claim("D71-E8.11", "the eigenvector",
      EIGENVECTOR,
      sizes=["q", "e"], over=LINEAR, where=[let(phi, (Z - lam)*theta), LINEAR_KRYLOV, let(v, theta*x)], given=LINEAR_MINIMAL,
      by=[example(q=1, e=0, A=[[1, 0], [0, 2]], x=[1, 1], theta=[-2, 1], lam=1), LINEAR_MADE],
      repair=repair(
          "other", "the vector is theta(A)x; theta(lambda)x, a multiple of x, is no eigenvector",
          EIGENVECTOR,
          sizes=["q", "e"], over=LINEAR, where=[let(phi, (Z - lam)*theta), LINEAR_KRYLOV, let(v, substitute(theta, A)*x)],
          given=LINEAR_MINIMAL,
          by=[steps("D71-E8.8", prose="(A - lambda)theta(A) = phi(A), and theta has a smaller degree than phi."), LINEAR_MADE]),
      note="lambda in theta(lambda) is the indeterminate of the polynomial. The next display has theta(A)x.")

# --- the equation A'QA - Q = R --------------------------------------------------------------------------------------------

n1, n2, A1, A2, K, Gr, nv, c1, c2, u = symbols("n1 n2 A1 A2 K Gr nv c1 c2 u")
EXPANDING = given("|eigenvalues of A| > 1", schur(inv(A)))
EQUATION = let(R, T(A)*Q*A - Q)


def expanding(size, gram_part, skew_part):
    """A matrix B with B'B >= 4I: twice the identity, plus nonnegative, plus skew."""
    return 2*Identity(size) + gram_part*T(gram_part) + skew_part - T(skew_part)


claim("D71-E8.14", "the solution as a series",
      (Q == sum_of(i, 1, K, T(A**(-i))*R*A**(-i)) + T(A**(-K))*Q*A**(-K)) & (pd(R) >> pd(Q)),
      sizes=["n", "K"], over={A: nonsingular(n), Q: symmetric_matrix(n)}, where=[EQUATION], given=[EXPANDING],
      by=[example(n=1, K=1, A=[["1/2"]], Q=[[-1]]),
          instances(n=(1, 2, 3), K=(1, 2, 3), using={G: nonsingular(n), W: matrix(n, n), U: matrix(n, n), lam: scalar()},
                    made_by={A: inv(G)*expanding(n, W, U)*G, Q: T(G)*G*when(lam > 0, 1, -1)}),
          instances(n=(1, 2, 3), K=(1, 2, 3), using={G: nonsingular(n), W: matrix(n, n), U: matrix(n, n)},
                    made_by={A: inv(G)*expanding(n, W, U)*G})],
      note="The remainder after K terms tends to zero because the eigenvalues of A^{-1} are inside the unit circle; so the series is the "
           "only solution. The equation is solved for R.")

TOTAL = n1 + n2
BLOCK_A = inv(G)*block([[expanding(n1, A1, c1), W], [Zero(n2, n1), expanding(n2, A2, c2)]])*G
BLOCK_Q = T(G)*block([[Zero(n1, n1), Zero(n1, n2)], [Zero(n2, n1), Identity(n2)]])*G
PARTS = {G: nonsingular(TOTAL), A1: matrix(n1, n1), A2: matrix(n2, n2), c1: matrix(n1, n1), c2: matrix(n2, n2), W: matrix(n1, n2)}

claim("D71-T8.4", "when the solution is singular",
      iff(det(Q) == 0, det(Gr) == 0),
      sizes=["n1", "n2"], over={A: nonsingular(TOTAL), Q: symmetric_matrix(TOTAL)},
      where=[EQUATION, let(Gr, sum_of(k, 0, TOTAL - 1, T(A**k)*R*A**k))],
      given=[EXPANDING, given("R >= 0", psd(R))],
      by=[steps("D71-E8.8", facts=["Q = sum of (A^{-i})'RA^{-i} is nonnegative definite.", "A nonnegative definite matrix vanishes on x if its form does."],
                prose="Null vectors of Q form a subspace invariant under A^{-1} inside the null space of R; a cyclic subspace of it contains an eigenvector."),
          example(n1=0, n2=1, A=[[1]], Q=[[1]]), example(n1=1, n2=1, A=[[2, 1], [0, 2]], Q=[[1, 0], [0, 0]]),
          example(n1=2, n2=0, A=[[2, 1], [0, 3]], Q=[[0, 0], [0, 0]]),
          instances(n1=(0, 1), n2=(1,), using=PARTS, made_by={A: BLOCK_A, Q: BLOCK_Q}),
          instances(n1=(0, 1, 2), n2=(2,), using=PARTS, made_by={A: BLOCK_A, Q: BLOCK_Q})],
      note="Gr = sum_{k<n} (A^k)'RA^k is singular exactly if R vanishes on some x != 0 and on all A^k x, hence (by the theorem on cyclic "
           "subspaces) on an eigenvector of A, which may be complex. The equation is solved for R.")

FORM = T(u)*Q*u + T(v)*Q*v
TURN = matrix_of(i, j, 2, 2, when(i == j, a, when(i < j, b, -b)))
ROTATED = 2 + e

claim("D71-E8.15", "the equation on an eigenvector of A",
      (a**2 + b**2 - 1)*FORM == T(u)*R*u + T(v)*R*v,
      sizes=["e"], over={A: matrix(ROTATED, ROTATED), Q: symmetric_matrix(ROTATED), u: vector(ROTATED), v: vector(ROTATED), a: scalar(), b: scalar()},
      where=[EQUATION],
      given=[given("Au = au - bv", A*u == a*u - b*v), given("Av = bu + av", A*v == b*u + a*v)],
      by=[combination([(-1, "Au = au - bv'", Q*A*u), (-(T(a*u - b*v)*Q), "Au = au - bv", 1),
                       (-1, "Av = bu + av'", Q*A*v), (-(T(b*u + a*v)*Q), "Av = bu + av", 1)], e=(0, 1, 2)),
          instances(e=(0, 1, 4), using={G: nonsingular(ROTATED), A2: matrix(e, e), W: matrix(2, e)},
                    made_by={A: inv(G)*block([[TURN, W], [Zero(e, 2), A2]])*G, u: inv(G)*first(ROTATED),
                             v: inv(G)*matrix_of(i, j, ROTATED, 1, when(i == 2, 1, 0))})],
      note="The eigenvector is u + iv with the eigenvalue a + ib, and u'Qu + v'Qv is its form; b = 0, v = 0 is the real case. The right side is "
           "the form of R: it vanishes if R(u + iv) = 0, and then the form of Q vanishes too, as a^2 + b^2 > 1.")

claim("D71-E8.16", "the null space of Q is carried into itself",
      eq(T(x)*(Q + R)*x, T(nv)*Q*nv, 0) & (Q*x == Zero(TOTAL, 1)) & (R*x == Zero(TOTAL, 1))
      & forall(i, 1, TOTAL, (Q*A**(-i)*nv == Zero(TOTAL, 1)) & (R*A**(-i)*nv == Zero(TOTAL, 1))),
      sizes=["n1", "n2"], over={A: nonsingular(TOTAL), Q: positive_semidefinite(TOTAL), nv: vector(TOTAL)},
      where=[EQUATION, let(x, inv(A)*nv)],
      given=[given("R >= 0", psd(R)), given("Qn = 0", Q*nv == Zero(TOTAL, 1))],
      by=[example(n1=1, n2=1, A=[[2, 0], [1, 2]], Q=[[0, 0], [0, 1]], nv=[1, 0]),
          *(instances(n1=sizes, n2=sizes, using={**PARTS, U: vector(n1)}, made_by={A: BLOCK_A, Q: BLOCK_Q, nv: inv(G)*vstack(U, Zero(n2, 1))})
            for sizes in (1, 2))],
      note="The equation is solved for R.")
