# SPDX-License-Identifier: MIT
"""An undriven random walk mode (Chapter III, section C.4.b, end).

Let Kv = mu v with K = B - PD and |mu| = 1, and start at U_0 = beta_0 vv*. In
U_{k+1} = K U_k K*[I + D U_k K*]^{-1} the bracket keeps multiples of v* on its left, so that
U_k = beta_k vv* with beta_{k+1} = beta_k/(1 + mu*(v*Dv) beta_k). The number mu* v*Dv is
v*K*Dv = v*Wv with W = (I + SP)^{-1}S = M'(MPM' + V)^{-1}M, positive unless Mv = 0. If n is
a null vector of P then n*P_k n = beta_k n*vv*n = beta_k |v*n|^2.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, instances, order
from exactkf.language import (
    Identity,
    T,
    Zero,
    eq,
    given,
    inv,
    let,
    matrix,
    matrix_of,
    nonsingular,
    positive_definite,
    scalar,
    symbols,
    symmetric_matrix,
    vector,
    when,
)
from proofs.d71.notation import H, M, P, Phi, V, gain, gram, i, j, n, p, step

q, K, D, S, B, v, mu, b, E, c, L = symbols("q K D S B v mu b E c L")
I = Identity(n)
PhiT = inv(T(Phi))
RUN = {K: matrix(n, n), D: matrix(n, n), v: matrix(n, q), mu: matrix(q, q), b: matrix(q, q)}
EIGEN = given("Kv = mu v", K*v == v*mu)
CIRCLE = given("|mu| = 1", mu*b*T(mu) == b)
U = v*b*T(v)
FORM = T(v)*D*v*b*T(mu)
ONE = {"n": 1, "q": 1, "K": [[1]], "D": [[1]], "v": [[1]], "mu": [[1]], "b": [[1]]}
SIGN = when(c > 0, 1, -1)*Identity(q)
SPREAD = {"using": {L: matrix(n, n), c: scalar()},
          "made_by": {mu: SIGN, K: (when(c > 0, 1, -1)*v*T(v) + L*(T(v)*v*I - v*T(v)))*inv(T(v)*v*I)}}
#: mu = i
TURN = {"n": 2, "q": 2, "K": [[0, -1], [1, 0]], "D": [[1, 0], [0, 2]], "v": [[1, 0], [0, 1]], "mu": [[0, -1], [1, 0]], "b": [[3, 0], [0, 3]]}

claim("D71-E3.196", "the deviation along the random walk mode",
      K*U*T(K)*inv(I + D*U*T(K)) == v*b*inv(Identity(q) + FORM)*T(v),
      sizes=["n", "q"], over=RUN, given=[EIGEN, CIRCLE],
      by=[order(lemmas=[K*U*T(K) == U, D*U*T(K) == D*v*b*T(mu)*T(v), T(v)*(I + D*v*b*T(mu)*T(v)) == (Identity(q) + FORM)*T(v),
                        T(v)*inv(I + D*U*T(K)) == inv(Identity(q) + FORM)*T(v)]),
          example({**ONE, "K": [[2]], "mu": [[2]]}), example({**ONE, "K": [[2]]}), example(TURN), instances(8, n=(1, 2, 3), q=(1,), **SPREAD)],
      note="U_k = v b v* with b for beta_k. mu and b stand on the right of v as matrices: for complex numbers v is two real columns, of the real part and of "
           "the imaginary part, and numbers are 2 x 2 matrices that commute, so that mu b mu* = b says |mu| = 1. D is any matrix.")

SYSTEM = {Phi: nonsingular(n), H: symmetric_matrix(n), M: matrix(p, n), V: positive_definite(p), P: symmetric_matrix(n), v: matrix(n, q), mu: matrix(q, q)}
CLOSED = [let(S, gram()), let(D, PhiT*S), let(B, H*PhiT*S + Phi)]
PLAIN = {"n": 1, "p": 1, "q": 1, "Phi": [[1]], "M": [[1]], "V": [[1]], "P": [[1]], "v": [[1]], "mu": [[1]]}

claim("D71-E3.197", "the number in the denominator",
      eq(T(mu)*(T(v)*D*v), T(v)*inv(S*P + I)*S*v, T(v)*T(M)*inv(M*P*T(M) + V)*M*v),
      sizes=["n", "p", "q"], over=SYSTEM, where=CLOSED, given=[given("P is an equilibrium", P == step()), given("(B - PD)v = mu v", (B - P*D)*v == v*mu)],
      by=[example({**PLAIN, "H": [["1/2"]]}), example({**PLAIN, "H": [[0]]}),
          instances(8, n=(1, 2), p=(1, 2), q=(1,), using={E: nonsingular(n), c: vector(n)},
                    made_by={Phi: E*matrix_of(i, j, n, n, when(i == j, 1 + c[i]**2, 0))*inv(E), P: E*matrix_of(i, j, n, n, when(i == j, 1 + c[i]**2, 0))*T(E),
                             M: matrix_of(i, j, p, n, when(i == j, 1, 0))*inv(E), V: Identity(p), H: P - Phi*(P - gain()*M*P)*T(Phi),
                             v: E*matrix_of(i, j, n, q, when(i == 1, 1, 0)), mu: (1 + c[1]**2)/(2 + c[1]**2)*Identity(q)})],
      note="mu, of any modulus, stands on the right of v as a matrix, so that it may be complex; mu* is its transpose.")

v1, v2, n1, n2, RE, IM, CC, SS = symbols("v1 v2 n1 n2 RE IM CC SS")
PAIRS = {v1: vector(n), v2: vector(n), n1: vector(n), n2: vector(n), b: scalar()}
PARTS = [let(RE, v1*T(v1) + v2*T(v2)), let(IM, v2*T(v1) - v1*T(v2)), let(CC, T(v1)*n1 + T(v2)*n2), let(SS, T(v1)*n2 - T(v2)*n1)]
AT_N = b*(T(n1)*RE*n1 + T(n2)*RE*n2 - T(n1)*IM*n2 + T(n2)*IM*n1)

claim("D71-S57", "the variance along n",
      (AT_N == b*(CC*CC - SS*SS)) & (2*b*CC*SS == Zero(1, 1)),
      sizes=["n"], over=PAIRS, where=PARTS,
      by=[example(n=2, v1=[1, 0], v2=[0, 1], n1=[0, -1], n2=[1, 0], b=1), instances(n=(1,))],
      repair=repair("other", "n*P_k n is beta_k |v*n|^2; the square without the modulus is the same for real vectors only",
                    AT_N == b*(CC*CC + SS*SS), sizes=["n"], over=PAIRS, where=PARTS, by=[order(), instances(n=(1, 2, 3))]),
      note="v = v1 + iv2, n = n1 + in2 and v*n = CC + i SS; the real and the imaginary part of b(v*n)^2 are compared with n*(b vv*)n. The counterexample is "
           "the random walk mode 3/5 + 4i/5 of a rotation with H = 0 and P_e = 0: v = (1, i), n = (i, -1) and v*n = 2i. For the modes 1 and -1 the vectors "
           "may be taken real.")
