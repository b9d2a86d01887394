# SPDX-License-Identifier: MIT
"""Section 3: Schur parameters, Szego polynomials, and the parametrization by (alpha, gamma).

A sequence 1, c_1, c_2, ... has Toeplitz matrices T_t = (c_|i-j|), i, j = 0..t,
and monic polynomials phi_t that are orthogonal for the form which gives z^i and
z^j the product c_|i-j|. They satisfy phi_{t+1} = z phi_t - gamma_t phi_t*, where
phi_t*(z) = z^t phi_t(1/z), and r_{t+1} = (1 - gamma_t^2) r_t is the product of
phi_{t+1} with itself. Hence det T_t = r_0 r_1 ... r_t: T_1, ..., T_t are
nonsingular exactly when none of gamma_0, ..., gamma_{t-1} has modulus one, and
positive definite exactly when all of them are less than one in modulus.

Let psi_t be the polynomials for -gamma_0, -gamma_1, .... The half difference
rho_t of psi_t and phi_t, and their half sum pi_t, obey
rho_{t+1} = z rho_t + gamma_t pi_t*. From this and the orthogonality relations
one gets, by induction on t, the coefficients of rho_t as sums of products
c_j phi_{t,k-j}: the polynomial part of 2(c_1/z + c_2/z^2 + ...) phi_t is
psi_t - phi_t. In matrices, Psi = C Phi. So, if b/a starts like
1 + 2c_1/z + ... + 2c_n/z^n and a = phi_n + alpha_1 phi_{n-1} + ... + alpha_n, then b
has the same coefficients with respect to psi_n, ..., psi_0, and alpha is
determined by a alone, since the phi_k are monic of different degrees.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, generic_index, instances, lemma, steps, use
from exactkf.language import (
    Identity,
    T,
    Z,
    always,
    coeff,
    column,
    coprime,
    defined,
    det,
    eq,
    forall,
    function,
    given,
    iff,
    invertible,
    laurent,
    let,
    matrix_of,
    monic,
    pd,
    polynomial,
    pos_on_circle,
    prod,
    rank,
    rec,
    recip,
    rev,
    scalar,
    schur,
    sequence,
    signal,
    size_of,
    standing,
    substitute,
    sum_of,
    symbols,
    to_expr,
    vector,
    vstack,
    when,
)
from proofs.blz94.lemmas import (
    BOTH_MONIC,
    FOUR,
    LEMMA_3_3,
    MONIC,
    ORTHOGONAL,
    ORTHOGONAL_FREE,
    PAIR,
    REVERSED,
    REVERSED_PSI,
    WITH_C,
    row,
)
from proofs.blz94.lemmas import column as col
from proofs.blz94.lemmas_match import BY_MATRICES, CONCLUDED, MATCH, MATRICES, OPENED_FOR_MATCH, OPENED_FOR_MATRICES, PARTS
from proofs.blz94.notation import (
    CORRELATIONS,
    HALF,
    KIMURA,
    PHI,
    PI,
    PSI,
    RHO,
    SCHUR,
    D,
    Toeplitz,
    a,
    alpha,
    b,
    beta,
    c,
    co,
    gamma,
    i,
    j,
    k,
    m,
    n,
    phi,
    phis,
    pi,
    psi,
    psis,
    r,
    rho,
    s,
    symmetric_part,
    t,
    u,
)

v, w, x, q, y = symbols("v w x q y")
M, Phi, Psi, C, A, W, O, R, tau = symbols("M Phi Psi C A W O R tau")
TOEPLITZ = (function(Toeplitz, [t], matrix_of(i, j, t + 1, t + 1, when(i == j, 1, c[abs(i - j)]))),)
GAMMA = {gamma: sequence(0, n - 1)}
#: the matrices (3.14)
PHI_MATRIX = (let(Phi, matrix_of(i, j, n + 1, n + 1, coeff(phi[n + 1 - j], n + 1 - i))),)
PSI_MATRIX = (let(Psi, matrix_of(i, j, n + 1, n + 1, coeff(psi[n + 1 - j], n + 1 - i))),)
C_MATRIX = (let(C, matrix_of(i, j, n + 1, n + 1, when(i == j, 1, when(i > j, 2 * c[i - j], 0)))),)
#: Schur parameters eta and Szego polynomials w, found from c_1, c_2, ... by (3.6)
eta, ws, xi = symbols("eta ws xi")
BACK = (rec(w, t, 1, Z * w[t] - eta[t] * ws[t]), rec(ws, t, 1, ws[t] - eta[t] * Z * w[t]),
        rec(q, t, 1, (1 - eta[t] ** 2) * q[t]),
        function(eta, [t], 1 / q[t] * sum_of(k, 0, t, coeff(w[t], k) * c[k + 1])))

# ---------------------------------------------------------------------- positive real functions and Toeplitz matrices
claim("BLZ94-S8", "positive real if and only if all Toeplitz matrices are positive definite",
      always(m, pd(Toeplitz[m])) & pos_on_circle(v + recip(v)), sizes=["n"], over={q: polynomial(n)},
      where=[function(c, [k], coeff(q * recip(q), k) / coeff(q * recip(q), 0)), *TOEPLITZ,
             let(v, HALF + sum_of(k, 1, n, c[k] * Z ** (-k)))],
      by=[example(n=1, q=[1, 1]), instances(n=(1, 2, 3))],
      note="Stated for the functions v whose c_k are the normalized autocorrelations of the coefficients of a "
           "polynomial q. They are analytic for |z| >= 1, and every T_t is the Gram matrix of t + 1 shifts of q, "
           "hence positive definite for all t, so that the equivalence demands v(z) + v(1/z) > 0. With q = 1 + z, that is c_1 = 1/2 and all other c_k = 0, v(-1) + v(-1) "
           "= 0.",
      repair=repair("boundary case", "Definite T_t for all t do not exclude zeros of v(z) + v(1/z) (or poles of v) on the unit "
                                     "circle; that positive real functions have definite T_t stands.",
                    R >> always(m, pd(Toeplitz[m])),
                    sizes=["n"], over={a: monic(n), b: monic(n)},
                    where=[let(R, schur(a) & pos_on_circle(D)), let(v, b / (2 * a)), let(D, symmetric_part(a, b)),
                           function(c, [k], laurent(v, k)), *TOEPLITZ],
                    by=[steps("BLZ94-E2.3", facts=["Herglotz: all T_m are nonnegative if and only if v is analytic "
                                                   "with nonnegative real part on |z| > 1",
                                                   "a Toeplitz form is the mean of |x(z)|^2 (v(z) + v(1/z)) over the "
                                                   "circle"],
                              prose="A pole of v on the circle would be a zero of D there."),
                        instances(n=(1, 2), horizon=12),
                        instances(12, n=(1, 2, 3), horizon=8, using={u: monic(n), x: monic(n)},
                                  made_by={a: substitute(u, 4 * Z) / to_expr(4) ** n,
                                           b: substitute(x, 4 * Z) / to_expr(4) ** n})]))

# ---------------------------------------------------------------------- Szego polynomials
_AGAINST = lemma(t, forall(k, 0, t, y(t, k) == when(k == t, r[t], 0)), direct=True, uses=[use(y, t, k), use(2, t=t, k=k)])
_ORTHOGONAL_PARTS = lemma(m, always(t, forall(s, m, t, sum_of(i, 0, m, coeff(phi[s], i) * y(t, i)) == when(m == t, r[t], 0))),
                          uses=[use(4, m=m, t=t, s=s), use(3, t=t, k=m + 1), use(1, t=t)], base=[use(3, t=t, k=0), use(1, t=t)])
claim("BLZ94-E3.5", "phi_t and phi_t* have the shape (3.3), (3.4), and the phi_t are orthogonal",
      forall(t, 0, n, (phi[t] == Z**t + sum_of(k, 1, t, co(phi, t, k) * Z ** (t - k)))
             & (phis[t] == sum_of(k, 1, t, co(phi, t, k) * Z**k) + 1)
             & forall(s, 0, t, sum_of(i, 0, s, coeff(phi[s], i) * y(t, i)) == when(s == t, r[t], 0))),
      sizes=["n"], over=GAMMA, where=[*CORRELATIONS, function(y, [t, i], sum_of(j, 0, t, coeff(phi[t], j) * c[abs(i - j)]))],
      by=[generic_index(REVERSED, MONIC, ORTHOGONAL, _AGAINST, _ORTHOGONAL_PARTS, **PAIR, closed=[c, y], uses=[use(1, t=t), use(4, m=s, t=t, s=s)]),
          instances(n=(1, 2, 3, 4))],
      note="A definition; what is checked is that the recursion produces monic polynomials of the stated form, "
           "orthogonal with respect to the sequence c of (3.10), with squared norms r_t. y(t, i) is the product of phi_t and z^i.")

claim("BLZ94-E3.5b", "the second recursion gives the reversed polynomial",
      forall(t, 0, n, phis[t] == rev(phi[t], t)), sizes=["n"], over=GAMMA, where=[*PHI],
      by=[generic_index(REVERSED), instances(n=(1, 2, 3, 4))])

claim("BLZ94-E3.6", "(3.6) is the choice of gamma_t that makes phi_{t+1} orthogonal to lower powers, with norm r_{t+1}",
      forall(t, 1, n, forall(k, 0, t - 1, sum_of(j, 0, t, coeff(phi[t], j) * tau[j - k]) == 0)
             & (sum_of(j, 0, t, coeff(phi[t], j) * tau[j - t]) == r[t])),
      sizes=["n"], over={c: sequence(1, n)}, where=[*SCHUR, function(tau, [k], when(k == 0, 1, c[abs(k)]))],
      by=[generic_index(REVERSED, MONIC, ORTHOGONAL_FREE, **PAIR, uses=[use(1, t=t), use(2, t=t, k=k), use(2, t=t, k=t)]), instances(n=(1, 2, 3, 4))],
      note="A definition; what is checked is that these gamma_t and r_t belong to the orthogonal polynomials of the "
           "sequence c.")

claim("BLZ94-P3.1", "det T_t = r_0 r_1 ... r_t",
      det(Toeplitz[n]) == prod(k, 0, n, r[k]), sizes=["n"], over={c: sequence(1, n)}, where=[*SCHUR, *TOEPLITZ],
      by=[generic_index(REVERSED, MONIC, ORTHOGONAL_FREE, **PAIR, triangular=matrix_of(i, j, n + 1, n + 1, coeff(phi[i - 1], j - 1)),
                        uses=[use(1, t=row - 1), use(2, t=row - 1, k=col - 1)]), instances(n=(1, 2, 3, 4, 5))])

claim("BLZ94-E3.8", "T_t is positive definite if and only if gamma_0, ..., gamma_{t-1} are less than one in modulus",
      iff(pd(Toeplitz[n]), forall(k, 0, n - 1, abs(gamma[k]) < 1)), sizes=["n"], over={c: signal(1)},
      where=[*SCHUR, *TOEPLITZ],
      given=[standing("gamma_0, ..., gamma_{n-1} are defined", forall(k, 0, n - 2, gamma[k] ** 2 != 1))],
      by=[steps("BLZ94-P3.1", facts=["Sylvester: a symmetric matrix is positive definite if and only if its leading "
                                     "minors are positive"],
                prose="The leading minors of T_t are det T_0, ..., det T_t, so r_0, ..., r_t have to be positive."),
          instances(n=(1, 2, 3, 4)), instances(n=(1, 2, 3, 4), made_by={c: column(i, 8, x[i] / 4)},
                                               using={x: vector(8)})])

claim("BLZ94-S9", "for each t, sequences c with nonsingular T_1, ..., T_t correspond to sequences gamma without "
                  "modulus one",
      iff(prod(k, 1, n, det(Toeplitz[k])) != 0, prod(k, 0, n - 2, 1 - gamma[k] ** 2) != 0),
      sizes=["n"], over=GAMMA, where=[*CORRELATIONS, *TOEPLITZ],
      by=[example(n=1, gamma=[1]), instances(n=(1, 2, 3))],
      note="gamma is mapped to c by (3.10), which inverts (3.6); the two sets correspond if each description is that "
           "of the other.",
      repair=repair("index", "T_t is singular when gamma_{t-1} has modulus one (t = 1, c_1 = gamma_0 = 1), so the "
                             "range is k = 0, ..., t-1; with k = 0, ..., t-2 the condition on the other side would be "
                             "on T_1, ..., T_{t-1}.",
                    iff(prod(k, 1, n, det(Toeplitz[k])) != 0, prod(k, 0, n - 1, 1 - gamma[k] ** 2) != 0),
                    sizes=["n"], over=GAMMA, where=[*CORRELATIONS, *TOEPLITZ],
                    by=[steps("BLZ94-P3.1", "BLZ94-E3.10", prose=
                              "r_k vanishes exactly when one of gamma_0, ..., gamma_{k-1} has modulus one. Where none "
                              "does, (3.10) can be solved for gamma_k and gives (3.6) back, so that every c of the one "
                              "set belongs to one gamma of the other."),
                        instances(40, n=(1, 2, 3))]))

claim("BLZ94-S10", "the Schur parameters go on as long as none has had modulus one",
      iff(defined(gamma[n]), forall(k, 0, n - 1, gamma[k] ** 2 != 1)), sizes=["n"], over={c: sequence(1, n + 1)},
      where=[*SCHUR], by=[steps("BLZ94-E3.6", prose="r_t is the product of the 1 - gamma_k^2, k < t."),
                          instances(40, n=(1, 2, 3, 4)), example(n=2, c=[1, 2, 3]), example(n=2, c=[0, -1, 3]),
                          example(n=3, c=[0, 0, 1, 1])],
      note="gamma_t divides by r_t, which vanishes from the first gamma_k of modulus one on; t = n.")

claim("BLZ94-E3.10", "(3.10) inverts (3.6)",
      forall(k, 0, n - 1, eta[k] == gamma[k]), sizes=["n"], over=GAMMA, where=[*CORRELATIONS, *BACK],
      given=[standing("gamma_k^2 != 1", forall(k, 0, n - 2, gamma[k] ** 2 != 1))],
      by=[generic_index(REVERSED, MONIC, ORTHOGONAL, lemma(t, (w[t] == phi[t]) & (ws[t] == phis[t]) & (q[t] == r[t]), rule=True,
                                                       uses=[use(c, t + 1), use(1, t=t), use(3, t=t)]),
                        **PAIR, **WITH_C, uses=[use(c, k + 1), use(1, t=k)]), instances(n=(1, 2, 3, 4))])

# ---------------------------------------------------------------------- Lemma 3.3
claim("BLZ94-L3.3", "Psi = C Phi", Psi == C * Phi, sizes=["n"], over=GAMMA,
      where=[*CORRELATIONS, *PSI, *PHI_MATRIX, *PSI_MATRIX, *C_MATRIX],
      given=[standing("gamma_k^2 != 1", forall(k, 0, n - 2, gamma[k] ** 2 != 1))],
      by=[generic_index(*LEMMA_3_3, **FOUR, **WITH_C, uses=[use(1, t=n + 1 - col), use(2, t=n + 1 - col, k=n + 1 - row),
                                                              use(4, t=n + 1 - col, k=n + 1 - row)]), instances(n=(1, 2, 3, 4))],
      note="The display (3.14c) lacks the row (2c_1, 1); its size n + 1 and its last row leave no other reading than "
           "the triangular Toeplitz matrix with first column 1, 2c_1, ..., 2c_n.")

claim("BLZ94-S12", "the three matrices are nonsingular: their determinants are one",
      (det(Phi) == 1) & (det(Psi) == 1) & (det(C) == 1), sizes=["n"], over=GAMMA,
      where=[*CORRELATIONS, *PSI, *PHI_MATRIX, *PSI_MATRIX, *C_MATRIX],
      by=[generic_index(REVERSED, REVERSED_PSI, BOTH_MONIC, **FOUR, uses=[use(2, t=n + 1 - col)]), instances(n=(1, 2, 3, 4))])

claim("BLZ94-E3.15a", "coefficients of psi_t in terms of those of phi_t",
      forall(t, 1, n, forall(k, 1, t, co(psi, t, k) == 2 * c[k] + sum_of(j, 1, k - 1, 2 * c[k - j] * co(phi, t, j))
                             + co(phi, t, k))),
      sizes=["n"], over=GAMMA, where=[*CORRELATIONS, *PSI], by=[generic_index(*LEMMA_3_3, **FOUR, **WITH_C, uses=[use(1, t=t), use(4, t=t, k=t - k)]), instances(n=(1, 2, 3, 4))])

claim("BLZ94-E3.15", "coefficients of rho_t, and the same for psi_t",
      forall(t, 1, n, forall(k, 1, t, (co(rho, t, k) == c[k] + sum_of(j, 1, k - 1, c[k - j] * co(phi, t, j)))
                             & (co(psi, t, k) == 2 * co(rho, t, k) + co(phi, t, k)))),
      sizes=["n"], over=GAMMA, where=[*CORRELATIONS, *PSI, *RHO],
      by=[generic_index(*LEMMA_3_3, **FOUR, **WITH_C, uses=[use(1, t=t), use(4, t=t, k=t - k)]), instances(n=(1, 2, 3, 4))])

claim("BLZ94-E3.17", "rho_{t+1} = z rho_t + gamma_t pi_t*",
      forall(t, 0, n - 1, rho[t + 1] == Z * rho[t] + gamma[t] * rev(pi[t], t)), sizes=["n"], over=GAMMA,
      where=[*PHI, *PSI, *RHO, *PI],
      by=[generic_index(REVERSED, REVERSED_PSI), instances(n=(1, 2, 3, 4))])

claim("BLZ94-S13", "the reversed polynomial in (3.17) is z^n pi_t(1/z)",
      forall(t, 0, n - 1, rho[t + 1] == Z * rho[t] + gamma[t] * rev(pi[t], n)), sizes=["n"], over=GAMMA,
      where=[*PHI, *PSI, *RHO, *PI],
      by=[example(n=1, gamma=["1/2"]), instances(n=(1, 2, 3))],
      repair=repair("index", "The reversed polynomial of pi_t is z^t pi_t(1/z): (3.17) is false with z^n unless t = n.",
                    forall(t, 0, n - 1, rho[t + 1] == Z * rho[t] + gamma[t] * rev(pi[t], t)), sizes=["n"], over=GAMMA,
                    where=[*PHI, *PSI, *RHO, *PI], by=[generic_index(REVERSED, REVERSED_PSI), instances(n=(1, 2, 3, 4))]))

_COLUMN = column(i, n + 1, coeff(phi[n], i - 1))  # (phi_tt, ..., phi_t1, 1)' for t = n
claim("BLZ94-E3.19", "normal equations, with the matrix of the display",
      (size_of(T(M)) == size_of(x)) & (M * x == column(i, n, when(i == n, r[n], 0))), sizes=["n"], over=GAMMA,
      where=[*CORRELATIONS, let(M, matrix_of(i, j, n, n, c[abs(i - j)])), let(x, _COLUMN)],
      by=[example(n=1, gamma=["1/2"]), instances(n=(1, 2, 3))],
      note="The display has first row (1, c_1, ..., c_{t-1}), last row (c_{t-1}, ..., 1) and a vector of t + 1 "
           "entries: the product does not exist. All its rows and columns end at index t - 1.",
      repair=repair("index", "The matrix has to be T_t, of size t + 1 with first row (1, c_1, ..., c_t); the one "
                             "displayed is T_{t-1}.",
                    (size_of(T(Toeplitz[n])) == size_of(x)) & (Toeplitz[n] * x
                                                               == column(i, n + 1, when(i == n + 1, r[n], 0))),
                    sizes=["n"], over=GAMMA, where=[*CORRELATIONS, *TOEPLITZ, let(x, _COLUMN)],
                    by=[generic_index(REVERSED, MONIC, ORTHOGONAL, **PAIR, **WITH_C, uses=[use(1, t=n), use(2, t=n, k=row - 1)]), instances(n=(1, 2, 3, 4))]))

claim("BLZ94-S14", "T_t is nonsingular if none of gamma_0, ..., gamma_{t-1} has modulus one",
      invertible(M), sizes=["n"], over=GAMMA, where=[*CORRELATIONS,
                                                     let(M, matrix_of(i, j, n + 1, n + 1, c[abs(i - j)]))],
      given=[given("gamma_k^2 != 1", forall(k, 0, n - 1, gamma[k] ** 2 != 1))],
      by=[steps("BLZ94-P3.1", "BLZ94-E3.10", prose="det T_t is the product of r_0, ..., r_t, which are not zero."),
          instances(n=(1, 2, 3, 4))],
      note="T_t is the matrix (3.2), of size t + 1.")

claim("BLZ94-S15", "constant coefficients of phi_t and psi_t",
      forall(t, 1, n, (co(phi, t, t) == -gamma[t - 1]) & (co(psi, t, t) == gamma[t - 1])), sizes=["n"], over=GAMMA,
      where=[*PHI, *PSI], by=[generic_index(REVERSED, REVERSED_PSI, BOTH_MONIC, **FOUR, shift=1, uses=[use(2, t=t - 1)]), instances(n=(1, 2, 3, 4))])

claim("BLZ94-S16", "the constant coefficients of rho_t and phi_t agree",
      forall(t, 1, n, co(rho, t, t) == co(phi, t, t)), sizes=["n"], over=GAMMA, where=[*PHI, *PSI, *RHO],
      by=[example(n=1, gamma=["1/2"]), instances(n=(1, 2, 3))],
      repair=repair("sign", "rho_tt = gamma_{t-1}, while phi_tt = -gamma_{t-1}.",
                    forall(t, 1, n, co(rho, t, t) == -co(phi, t, t)), sizes=["n"], over=GAMMA, where=[*PHI, *PSI, *RHO],
                    by=[generic_index(REVERSED, REVERSED_PSI, BOTH_MONIC, **FOUR, shift=1, uses=[use(2, t=t - 1)]), instances(n=(1, 2, 3, 4))]))

rho1, pi1 = symbols("rho1 pi1")
_FIRST = given("first normal equation", coeff(phi, 0) + sum_of(j, 1, n, c[j] * coeff(phi, j)) == 0)
_VALUE = given("value of rho_kk", coeff(rho, 0) == -coeff(phi, 0))
claim("BLZ94-S17", "the first normal equation and the value of rho_kk give (3.17) for t = k",
      rho1 == Z * rho + gamma * rev(phi + rho, n), sizes=["n"],
      over={c: sequence(1, n), phi: monic(n), rho: polynomial(n - 1), rho1: polynomial(n), gamma: scalar()},
      given=[_FIRST, _VALUE],
      by=[example(n=1, c=[1], phi=[-1, 1], rho=[1], rho1=[0, 0], gamma=0),
          instances(n=(1, 2, 3), made_by={rho: rho1 - coeff(rho1, 0) - coeff(phi, 0) - coeff(rho1, n) * Z**n,
                                          c: column(i, n, when(i == n, -coeff(phi, 0), 0))})],
      note="Read as a deduction from these two equations alone, with n in place of k: phi, rho, rho1 stand for phi_k, "
           "rho_k, rho_{k+1}. The value of rho_kk is taken with the right sign.",
      repair=repair("cross-reference", "What the two equations give is (3.15) for t = k, the start of the induction; "
                                       "(3.17) is the recursion.",
                    coeff(rho, 0) == c[n] + sum_of(j, 1, n - 1, c[n - j] * coeff(phi, n - j)), sizes=["n"],
                    over={c: sequence(1, n), phi: monic(n), rho: polynomial(n - 1)}, given=[_FIRST, _VALUE, standing("n >= 1", n >= 1)],
                    by=[generic_index(uses=[use("value of rho_kk"), use("first normal equation")]),
                        instances(n=(2, 3, 4), using={x: polynomial(n - 1), y: vector(n)},
                                  made_by={rho: x - coeff(x, 0) - coeff(phi, 0),
                                           c: column(i, n, when(i == n,
                                                                -coeff(phi, 0)
                                                                  - sum_of(j, 1, n - 1, y[j] * coeff(phi, j)),
                                                                  y[i]))})]))

_S = {"sizes": ["n"], "over": GAMMA, "where": [*CORRELATIONS, *PSI, *RHO, *PI]}
claim("BLZ94-S18", "the normal equation for row s - k, written with the coefficients of phi_s",
      forall(s, 1, n, forall(k, 1, s, c[k] + sum_of(j, 1, k - 1, c[k - j] * co(phi, s, j)) + co(phi, s, k)
                             + sum_of(j, 1, s - k, c[j] * co(phi, s, k + j)) == 0)),
      **_S, by=[generic_index(*LEMMA_3_3, **FOUR, **WITH_C, uses=[use(1, t=s), use(2, t=s, k=s - k)]), instances(n=(1, 2, 3, 4))])

claim("BLZ94-E3.20", "coefficients of pi_s",
      forall(s, 1, n, forall(k, 1, s, eq(co(pi, s, k), co(rho, s, k) + co(phi, s, k),
                                         -sum_of(j, 1, s - k, c[j] * co(phi, s, k + j))))),
      **_S, by=[generic_index(*LEMMA_3_3, **FOUR, **WITH_C, uses=[use(1, t=s), use(2, t=s, k=s - k), use(4, t=s, k=s - k)]), instances(n=(1, 2, 3, 4))])

claim("BLZ94-S19", "coefficients of rho_{s+1}",
      forall(s, 1, n - 1, (rho[s + 1] == Z * rho[s] + gamma[s] * rev(pi[s], s))
             & forall(k, 1, s, co(rho, s + 1, k) == co(rho, s, k) + gamma[s] * co(pi, s, s + 1 - k))),
      sizes=["n"], over=GAMMA, where=[*PHI, *PSI, *RHO, *PI],
      by=[generic_index(REVERSED, REVERSED_PSI, **FOUR), instances(n=(2, 3, 4))],
      note="The text takes this from (3.18); the polynomial recursion meant is (3.17), whose coefficients are compared. (3.18) defines pi_t.")

claim("BLZ94-S20", "the step of the induction",
      forall(s, 1, n - 1, forall(k, 1, s, (
          co(rho, s + 1, k) == c[k] + sum_of(j, 1, k - 1, c[k - j] * (co(phi, s, j)
              - gamma[s] * co(phi, s, s + 1 - j))))
          & (co(phi, s + 1, k) == co(phi, s, k) - gamma[s] * co(phi, s, s + 1 - k)))),
      **_S, by=[generic_index(*LEMMA_3_3, **FOUR, **WITH_C, uses=[use(1, t=s), *(use(m, t=s, k=x) for m in (2, 4) for x in (s - k, k - 1))]), instances(n=(2, 3, 4))])

# ---------------------------------------------------------------------- Theorem 3.2
#: lower triangular Toeplitz matrix of the coefficients of a, 1, a_1, ..., a_{n-1}
A_MATRIX = (let(A, matrix_of(i, j, n, n, coeff(a, n - i + j))),)
_MATCH = given("(3.11)", column(k, n, laurent(HALF * b / a, k)) == column(k, n, c[k]))
_VECTOR = column(i, n + 1, when(i == 1, 1, alpha[i - 1]))
_BETA = column(i, n + 1, when(i == 1, 1, beta[i - 1]))

claim("BLZ94-T3.2", "a and b have the same coefficients with respect to the phi_k and the psi_k",
      (b == psi[n] + sum_of(i, 1, n, alpha[i] * psi[n - i])) & (a == phi[n] + sum_of(i, 1, n, alpha[i] * phi[n - i]))
        & (det(Phi) == 1),
      sizes=["n"], over={gamma: sequence(0, n - 1), a: monic(n), b: monic(n)},
      where=[*CORRELATIONS, *PSI, *PHI_MATRIX, *PARTS,
             function(alpha, [k], coeff(a, n - k) - co(phi, n, k)
                      - sum_of(j, 1, k - 1, alpha[j] * coeff(phi[n - j], n - k)))],
      given=[_MATCH, standing("gamma_k^2 != 1", forall(k, 0, n - 2, gamma[k] ** 2 != 1))],
      by=[generic_index(*MATCH, **OPENED_FOR_MATCH, uses=[*CONCLUDED, use(1, t=n + 1 - col)]),
          instances(n=(1, 2, 3), made_by={b: Z**n + sum_of(k, 1, n, Z ** (n - k) * (coeff(a, n - k) + 2 * sum_of(
              j, 1, k, c[j] * coeff(a, n - k + j))))})],
      note="alpha is solved from a; det Phi = 1 says that it is the only one. The polynomials are needed for k = 0, "
           "..., n, one more than the theorem lists. The parts of a and b and the coefficients at infinity, here first, serve the proof alone.")

claim("BLZ94-S21", "(3.11) as a relation of matrices, hence beta = alpha",
      (Psi * _BETA == C * column(i, n + 1, y(i))) & (column(i, n, beta[i]) == column(i, n, alpha[i])), sizes=["n"],
      over={gamma: sequence(0, n - 1), alpha: sequence(1, n), beta: sequence(1, n)},
      where=[*CORRELATIONS, *PSI, *PHI_MATRIX, *PSI_MATRIX, *C_MATRIX,
             let(a, phi[n] + sum_of(i, 1, n, alpha[i] * phi[n - i])),
             let(b, psi[n] + sum_of(i, 1, n, beta[i] * psi[n - i])), function(y, [k], (Phi * _VECTOR)[k]), *PARTS],
      given=[_MATCH],
      by=[generic_index(*MATRICES, **OPENED_FOR_MATRICES, uses=BY_MATRICES),
          instances(n=(1, 2, 3), made_by={beta: column(i, n, alpha[i])})],
      note="y(1), y(2), .. are the entries of Phi (1, alpha')'. The parts of a and b and the coefficients at infinity, here first, serve the proof alone.")

claim("BLZ94-C3.4", "Psi(gamma) = Phi(-gamma), Phi(0) = Psi(0) = I, and (3.21)",
      (Psi == W) & (O == Identity(n + 1)) & (x == Identity(n + 1))
      & (vstack(1, column(i, n, coeff(a, n - i))) == Phi * vstack(1, alpha))
        & (vstack(1, column(i, n, coeff(b, n - i))) == Psi * vstack(1, alpha)),
      sizes=["n"], over={gamma: sequence(0, n - 1), alpha: vector(n)},
      where=[*KIMURA, *PHI_MATRIX, *PSI_MATRIX,
             function(eta, [k], -gamma[k]), rec(w, t, 1, Z * w[t] - eta[t] * ws[t]),
             rec(ws, t, 1, ws[t] - eta[t] * Z * w[t]),
             let(W, matrix_of(i, j, n + 1, n + 1, coeff(w[n + 1 - j], n + 1 - i))),
             function(xi, [k], 0 * gamma[k]), rec(q, t, 1, Z * q[t] - xi[t] * u[t]),
             rec(u, t, 1, u[t] - xi[t] * Z * q[t]),
             let(O, matrix_of(i, j, n + 1, n + 1, coeff(q[n + 1 - j], n + 1 - i))),
             rec(y, t, 1, Z * y[t] + xi[t] * v[t]), rec(v, t, 1, v[t] + xi[t] * Z * y[t]),
             let(x, matrix_of(i, j, n + 1, n + 1, coeff(y[n + 1 - j], n + 1 - i)))],
      by=[generic_index(lemma(t, (w[t] == psi[t]) & (ws[t] == psis[t]), rule=True), lemma(t, (q[t] == Z**t) & (u[t] == 1), rule=True),
                        lemma(t, (y[t] == Z**t) & (v[t] == 1), rule=True), REVERSED, lemma(t, coeff(phi[t], t) == 1, uses=[use(4, t=t)]),
                        lemma(t, coeff(psi[t], t) == 1, uses=[use(4, t=t), use(5, t=t)]), **FOUR,
                        uses=[use(m, t=x) for m in (4, 5) for x in (n, n + 1 - col)]), instances(n=(1, 2, 3))],
      note="w, q, y are the Szego polynomials for the parameters -gamma_k, for zero parameters, and for minus zero "
           "parameters.")

# ---------------------------------------------------------------------- the parametrization of positive real functions
claim("BLZ94-E3.9", "every positive real v of degree n is given by exactly one alpha",
      (b == psi[n] + sum_of(i, 1, n, alpha[i] * psi[n - i])) & (a == phi[n] + sum_of(i, 1, n, alpha[i] * phi[n - i]))
        & (rank(M) == n),
      sizes=["n"], over={a: monic(n), b: monic(n)},
      where=[function(c, [k], laurent(b / (2 * a), k)), *SCHUR, *PSI,
             function(alpha, [k], coeff(a, n - k) - co(phi, n, k)
                      - sum_of(j, 1, k - 1, alpha[j] * coeff(phi[n - j], n - k))),
             let(M, matrix_of(i, j, 2 * n, n, coeff(a * psi[n - j] - b * phi[n - j], i - 1)))],
      given=[given("v has degree n", coprime(a, b)),
             standing("v is analytic on |z| >= 1", schur(a)),
             standing("v(z) + v(1/z) > 0 on |z| = 1", pos_on_circle(symmetric_part(a, b)))],
      by=[steps("BLZ94-T3.2", prose=
                "Two vectors alpha give the same quotient if and only if their difference is in the null space of M. "
                "For such a difference a times a combination of psi_0, ..., psi_{n-1} is b times the same combination "
                "of the phi_k; the degrees are less than n and a, b are coprime, so both combinations are zero."),
          instances(n=(1, 2, 3), made_by={a: substitute(u, 4 * Z) / to_expr(4) ** n,
                                          b: substitute(x, 4 * Z) / to_expr(4) ** n},
                    using={u: monic(n), x: monic(n)})],
      note="v = b/(2a) in lowest terms has degree n, the standing assumption on v. For smaller degree there is more "
           "than one alpha: v = 1/2 has gamma = 0 and any alpha will do.")

claim("BLZ94-S11", "(alpha, gamma) without gamma_k of modulus one correspond to (a, g) with nonsingular T_1, ..., T_n",
      iff(prod(k, 0, n - 1, 1 - gamma[k] ** 2) != 0, prod(k, 1, n, det(Toeplitz[k])) != 0),
      sizes=["n"], over={alpha: sequence(1, n), gamma: sequence(0, n - 1)},
      where=[*KIMURA, function(c, [k], laurent(b / (2 * a), k)), *TOEPLITZ],
      by=[steps("BLZ94-P4.1", "BLZ94-P3.1", facts=["the complement of the zero set of a nonzero "
                                                                "polynomial is open and dense"],
                prose="Proposition 4.1 makes the map a bijection where gamma_0, ..., gamma_{n-2} have not modulus "
                      "one; the condition on gamma_{n-1} is that on T_n, and det T_1 ... det T_n is a polynomial in "
                      "(a, g) that is not zero at (0, 0)."),
          instances(40, n=(1, 2, 3)), example(n=1, alpha=["3/2"], gamma=["1/2"])],
      note="That the map is one-to-one there, and onto, is Proposition 4.1; what is checked here is that the two sets "
           "correspond.")
