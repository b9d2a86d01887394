# SPDX-License-Identifier: MIT
"""The discrete-time filter and the forms of its covariance update (Chapter I, section A).

The filter corrects its prediction by the gain times the innovation and then
predicts again. Subtracting the true state shows what happens to the error:
a measurement takes it from e to (I - KM)e + K dy, the next instant takes that
to Phi times it minus h. As e, dy and h are uncorrelated, covariances follow by
linear algebra: for any gain L the covariance after the measurement is
(I - LM)P(I - LM)' + LVL', and completing the square in L shows that the printed
gain is the best one and that the covariance it leaves is
Q = P - PM'(MPM' + V)^{-1}MP.

The rest are other ways to write Q. Two of them read off the gain, one is the
symmetric form just used, and three go through M'V^{-1}M and need V invertible:
(P^{-1} + M'V^{-1}M)^{-1} also needs P invertible, the other two do not.

Statements on random vectors appear here as the algebra of their covariances.
"""

from exactkf.claims import claim
from exactkf.evidence import identity, instances
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    eq,
    hstack,
    inv,
    let,
    matrix,
    positive_definite,
    positive_semidefinite,
    sym,
    symbols,
    symmetric_matrix,
    vector,
)
from proofs.d71.notation import H, K, M, P, Phi, Q, V, gain, gram, joseph, n, p, step, update

x, xh, dy, h = symbols("x xh dy h")
y, xt, x1, xh1 = symbols("y xt x1 xh1")
L = sym("L")
I = Identity(n)

SIZES = {"n": range(1, 4), "p": range(1, 3)}
SMALL = {"n": range(1, 4), "p": range(1, 4)}
DATA = {P: positive_semidefinite(n), M: matrix(p, n), V: positive_semidefinite(p)}
GAIN = [let(K, gain())]
UPDATE = [let(K, gain()), let(Q, update())]

claim("D71-E1.20", "what the filter does to the estimation error",
      (xt - x == (I - K*M)*(xh - x) + K*dy) & (xh1 - x1 == Phi*(xt - x) - h),
      sizes=["n", "p"],
      over={x: vector(n), xh: vector(n), h: vector(n), dy: vector(p), Phi: matrix(n, n), M: matrix(p, n),
            K: matrix(n, p)},
      where=[let(y, M*x + dy), let(x1, Phi*x + h), let(xt, xh + K*(y - M*xh)), let(xh1, Phi*xt)],
      by=[identity(**SIZES), instances(n=range(2, 4), p=range(2, 4))],
      note="The two filter equations define the estimates; the content checked is the error recursion they give with "
           "y = Mx + dy.")

claim("D71-E1.22", "the gain leaves the least covariance",
      joseph(L) == update() + (L - K)*(M*P*T(M) + V)*T(L - K),
      sizes=["n", "p"], over={**DATA, L: matrix(n, p)}, where=GAIN,
      by=[identity(**SIZES), instances(**SMALL)],
      note="The gain is a definition; the content checked is its optimality: any other gain L adds a nonnegative term.")

claim("D71-E1.24", "covariance of the error after the measurement",
      (hstack(I - K*M, K)*block([[P, Zero(n, p)], [Zero(p, n), V]])*T(hstack(I - K*M, K))
       == P - P*T(M)*inv(M*P*T(M) + V)*M*P),
      sizes=["n", "p"], over=DATA, where=GAIN,
      by=[identity(**SIZES), instances(**SMALL)],
      note="The error after the measurement is [I - KM, K] times the uncorrelated pair (prediction error, measurement "
           "error).")

claim("D71-E1.25", "covariance of the prediction error",
      hstack(Phi, -I)*block([[Q, Zero(n, n)], [Zero(n, n), H]])*T(hstack(Phi, -I)) == Phi*Q*T(Phi) + H,
      sizes=["n"], over={Phi: matrix(n, n), Q: positive_semidefinite(n), H: positive_semidefinite(n)},
      by=[identity(n=range(1, 5)), instances(n=range(1, 5))],
      note="The prediction error is [Phi, -I] times the uncorrelated pair (error after the measurement, process "
           "noise).")

ERRORS = hstack(Phi*(I - K*M), Phi*K, -I)

claim("D71-E1.27", "the covariance equation",
      ERRORS*block([[P, Zero(n, p), Zero(n, n)], [Zero(p, n), V, Zero(p, n)],
                    [Zero(n, n), Zero(n, p), H]])*T(ERRORS) == step(),
      sizes=["n", "p"], over={**DATA, Phi: matrix(n, n), H: positive_semidefinite(n)}, where=GAIN,
      by=[identity(n=range(1, 4), p=(1,)), instances(**SMALL)],
      note="The left side is the covariance of the next prediction error, from the two error equations composed.")

claim("D71-E1.28a", "update with the gain on the left", Q == P - K*M*P,
      sizes=["n", "p"], over=DATA, where=UPDATE, by=[identity(**SIZES), instances(**SMALL)])

claim("D71-E1.28b", "update with the gain on the right", Q == P - P*T(M)*T(K),
      sizes=["n", "p"], over=DATA, where=UPDATE, by=[identity(**SIZES), instances(**SMALL)],
      note="The primes on M and K are read into the scan as in the second line of (1.29); without them the sizes do "
           "not fit.")

claim("D71-E1.28c", "symmetric form of the update", Q == joseph(K),
      sizes=["n", "p"], over=DATA, where=UPDATE, by=[identity(**SIZES), instances(**SMALL)])

claim("D71-E1.28d", "matrix inversion lemma", Q == inv(inv(P) + gram()),
      sizes=["n", "p"], over={P: positive_definite(n), M: matrix(p, n), V: positive_definite(p)}, where=UPDATE,
      by=[identity(**SIZES), instances(**SMALL)],
      note="P and V are taken invertible, which the formula presupposes and the list around it does not say.")

claim("D71-E1.28e", "update through M'V^{-1}M, inverse on the right", Q == P*inv(I + gram()*P),
      sizes=["n", "p"], over={P: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}, where=UPDATE,
      by=[identity(**SIZES), instances(**SMALL)],
      note="V is taken invertible, which the formula presupposes; P may be singular.")

claim("D71-E1.28f", "update through M'V^{-1}M, inverse on the left", Q == inv(I + P*gram())*P,
      sizes=["n", "p"], over={P: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p)}, where=UPDATE,
      by=[identity(**SIZES), instances(**SMALL)],
      note="V is taken invertible, which the formula presupposes; P may be singular.")

claim("D71-E1.29", "from the symmetric form back to Q",
      eq((I - K*M)*P*T(I - K*M) + K*V*T(K),
         P - K*M*P - P*T(M)*T(K) + K*(M*P*T(M) + V)*T(K),
         P - K*M*P - P*T(M)*T(K) + P*T(M)*T(K),
         Q),
      sizes=["n", "p"], over={P: symmetric_matrix(n), M: matrix(p, n), V: symmetric_matrix(p)}, where=UPDATE,
      by=[identity(**SIZES), instances(**SMALL)],
      note="Only the symmetry of P and V is used, not their sign.")
