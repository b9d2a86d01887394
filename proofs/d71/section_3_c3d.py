# SPDX-License-Identifier: MIT
"""Equilibria after the measurement (Chapter III, section C.3.d).

Q = P - PM'(MPM' + V)^{-1}MP and P = Phi Q Phi' + H determine each other, and so do symmetry,
sign and null vectors of P and Q. Written as Q(I + SP) = P and with P eliminated, the two
equations are a quadratic equation for Q whose block matrix R_q is R_p seen in the basis
[[I, 0], [S, I]]: the same three factors in another order. Hence the same Jordan form, and
Phi' carries the matrix J of P to that of Q.
"""

from exactkf.claims import claim
from exactkf.evidence import example, instances, order
from exactkf.language import (
    Identity,
    T,
    Zero,
    block,
    eq,
    given,
    iff,
    inv,
    let,
    loewner,
    matrix,
    matrix_of,
    nonsingular,
    pd,
    positive_definite,
    psd,
    symbols,
    symmetric,
    symmetric_matrix,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import H, K, M, P, Phi, Q, V, gain, gram, i, j, n, p, step, update

q, S, Fq, Gq, Jq, Gp, Jp, Rq, x, E = symbols("q S Fq Gq Jq Gp Jp Rq x E")
I, Zn = Identity(n), Zero(n, n)
PhiT = inv(T(Phi))
GRAM = let(S, gram())
MORE = {"n": (1, 2, 3), "p": (1, 2)}

UPDATE = given("(1.24)", Q == update())
PREDICTION = given("(1.25)", P == Phi*Q*T(Phi) + H)
ANY = {Phi: nonsingular(n), H: symmetric_matrix(n), M: matrix(p, n), V: positive_definite(p), P: matrix(n, n), Q: matrix(n, n)}
#: the equation solved for H; P is symmetric then or not
SOLVED = {Q: update(), H: P - Phi*Q*T(Phi)}
SOLVING = [instances(**MORE, using={P: symmetric_matrix(n)}, made_by=SOLVED)]

claim("D71-E3.134", "four forms of the update at an equilibrium",
      eq(Q, P - P*T(M)*inv(M*P*T(M) + V)*M*P, P*inv(S*P + I), inv(P*S + I)*P, (I - K*M)*P*(I - T(M)*T(K)) + K*V*T(K)),
      sizes=["n", "p"], over={P: symmetric_matrix(n), M: matrix(p, n), V: positive_definite(p), Q: matrix(n, n)},
      where=[GRAM, let(K, gain())], given=[UPDATE],
      by=[instances(**MORE, made_by={Q: update()})])

claim("D71-E3.135", "the prediction gives the equilibrium back",
      P == Phi*Q*T(Phi) + H,
      sizes=["n", "p"], over=ANY, given=[given("(3.46)", P == step()), UPDATE],
      by=[instances(**MORE, using={P: symmetric_matrix(n)}, made_by=SOLVED)])

d, e, Y = symbols("d e Y")
SAME_SIGN = psd(H) >> iff(psd(P), psd(Q))
#: a contraction and a nonnegative P in one basis, so that H = P - Phi Q Phi' is nonnegative
CONTRACTED = {Phi: E*matrix_of(i, j, n, n, when(i == j, 1/(1 + d[i]**2), 0))*inv(E), P: E*matrix_of(i, j, n, n, when(i == j, e[i]**2, 0))*T(E),
              Q: update(), H: P - Phi*Q*T(Phi)}
SINGULAR_P = {**CONTRACTED, P: E*matrix_of(i, j, n, n, when((i == j) & (i > 1), e[i]**2, 0))*T(E), x: matrix_of(i, j, n, q, inv(T(E))[i, j])}
AUX = {E: nonsingular(n), d: vector(n), e: vector(n)}
ONE = {"n": 1, "p": 1, "q": 1, "Phi": [[1]], "M": [[1]], "V": [[1]], "x": [1]}
#: one of the equilibria of Example 3.1 that are not symmetric
SKEW = {"n": 2, "p": 1, "q": 1, "Phi": [[2, -1], [0, "1/2"]], "H": [[4, 6], [6, 9]], "M": [[-1, "2/3"]], "V": [[1]], "P": [[6, 9], [8, 12]],
        "Q": [["6", "9"], ["8", "12"]], "x": [1, 0]}

claim("D71-S51", "what P and Q share",
      iff(symmetric(P), symmetric(Q)) & SAME_SIGN & iff(P*x == Zero(n, q), Q*x == Zero(n, q))
      & ((symmetric(P) & pd(Y)) >> loewner(P, Q)),
      sizes=["n", "p", "q"], over={**ANY, x: matrix(n, q)}, where=[let(K, gain()), let(Y, M*P*T(M) + V)], given=[UPDATE, PREDICTION],
      by=[order([], [], [(I - K*M)*P*T(I - K*M), K*V*T(K)], [Phi*Q*T(Phi), H], [], [inv(V)], [P*T(M)*inv(Y)*M*P]),
          example({**ONE, "H": [["1/2"]], "P": [["-1/2"]], "Q": [[-1]]}), example({**ONE, "H": [[-4]], "P": [[-2]], "Q": [[2]]}),
          example({**ONE, "H": [[0]], "P": [[-1]], "Q": [[0]]}), example({**ONE, "H": [[-1]], "P": [[0]], "Q": [[1]]}),
          example({**ONE, "H": [[-2]], "P": [[-2]], "Q": [[0]]}), example(SKEW),
          instances(4, n=(1, 2), p=(1, 2), q=(1,), using=AUX, made_by=CONTRACTED), instances(4, n=(1, 2), p=(1,), q=(1,), using=AUX, made_by=SINGULAR_P),
          instances(4, n=(1, 2), p=(1,), q=(1,), made_by=SOLVED)],
      note="Y = MPM' + V. x stands for any vectors, so that the null spaces are compared. H >= 0 is part of the setting; only the second equivalence needs it.")

# --- the quadratic equation of Q ----------------------------------------------------------------------------------------

claim("D71-E3.136", "the quadratic equation of Q",
      H*PhiT + Phi*Q - Q*(S*H + I)*PhiT - Q*S*Phi*Q == Zn,
      sizes=["n", "p"], over=ANY, where=[GRAM], given=[UPDATE, PREDICTION],
      by=[*SOLVING])

R_Q = block([[Phi, H*PhiT], [S*Phi, (S*H + I)*PhiT]])
QUADRATIC = H*PhiT + Phi*Q - Q*(S*H + I)*PhiT - Q*S*Phi*Q
COLUMNS = vstack(Fq, Gq)

claim("D71-E3.138", "its solutions are the invariant subspaces of R_q",
      iff(Rq*COLUMNS == COLUMNS*Jq, (QUADRATIC == Zn) & (Jq == inv(Gq)*(S*Phi*Q + (S*H + I)*PhiT)*Gq)),
      sizes=["n", "p"], over={**ANY, Fq: matrix(n, n), Gq: nonsingular(n), Jq: matrix(n, n)}, where=[GRAM, let(Rq, R_Q)],
      given=[given("Q = F_q Gamma_q^{-1}", Q == Fq*inv(Gq))],
      by=[instances(**MORE, using={P: symmetric_matrix(n)},
                    made_by={Q: update(), H: P - Phi*Q*T(Phi), Fq: Q*Gq, Jq: inv(Gq)*(gram()*Phi*Q + (gram()*H + I)*PhiT)*Gq}),
          instances(8, n=(1, 2), p=(1, 2), made_by={Q: Fq*inv(Gq)})],
      note="Both directions: every solution is F_q Gamma_q^{-1}, with any Gamma_q, and every such matrix is a solution.")

MODEL = {Phi: nonsingular(n), H: symmetric_matrix(n), M: matrix(p, n), V: positive_definite(p)}

claim("D71-E3.139", "factors of R_q",
      R_Q == block([[I, Zn], [S, I]])*block([[I, H], [Zn, I]])*block([[Phi, Zn], [Zn, PhiT]]),
      sizes=["n", "p"], over=MODEL, where=[GRAM], by=[instances(**MORE)])

LOWER, LOWER_INVERSE = block([[I, Zn], [S, I]]), block([[I, Zn], [-S, I]])

claim("D71-E3.140", "R_q is similar to R_p",
      (Rq == LOWER*block([[H*PhiT*S + Phi, H*PhiT], [PhiT*S, PhiT]])*LOWER_INVERSE) & (LOWER*LOWER_INVERSE == Identity(2*n)),
      sizes=["n", "p"], over=MODEL, where=[GRAM, let(Rq, R_Q)], by=[instances(**MORE)],
      note="The second equation says that the outer factors are inverse to each other. The prime of -M'V^{-1}M is read into the scan.")

claim("D71-E3.142", "the matrix J of P, through Q",
      (S*(Phi*Q*T(Phi) + H) + I)*Gp == T(Phi)*Gp*Jp,
      sizes=["n", "p"], over={**ANY, Gp: matrix(n, n), Jp: matrix(n, n)}, where=[GRAM],
      given=[given("(3.141)", (PhiT*S*P + PhiT)*Gp == Gp*Jp), PREDICTION],
      by=[instances(**MORE, using={E: nonsingular(n), P: symmetric_matrix(n), Q: symmetric_matrix(n)},
                    made_by={H: P - Phi*Q*T(Phi), Gp: E, Jp: inv(E)*(PhiT*gram()*P + PhiT)*E})],
      note="(3.141) with D_p = (Phi')^{-1}M'V^{-1}M and C_p = -(Phi')^{-1}.")

claim("D71-E3.144", "the matrix J of Q",
      (S*(Phi*Q*T(Phi) + H) + I)*PhiT*Gq == Gq*Jq,
      sizes=["n", "p"], over={**MODEL, Q: matrix(n, n), Gq: matrix(n, n), Jq: matrix(n, n)}, where=[GRAM],
      given=[given("(3.143)", (S*Phi*Q + (S*H + I)*PhiT)*Gq == Gq*Jq)],
      by=[instances(**MORE, using={E: nonsingular(n)}, made_by={Gq: E, Jq: inv(E)*(gram()*Phi*Q + (gram()*H + I)*PhiT)*E})],
      note="(3.143) with D_q = M'V^{-1}M Phi and C_q = -(M'V^{-1}MH + I)(Phi')^{-1}, the lower half of R_q.")

CARRY = inv(Gq)*T(Phi)*Gp

claim("D71-E3.145", "J of P and J of Q are similar",
      (CARRY*Jp == Jq*CARRY) & (CARRY*(inv(Gp)*PhiT*Gq) == I),
      sizes=["n", "p"], over={**MODEL, Q: matrix(n, n), Gp: nonsingular(n), Jp: matrix(n, n), Gq: nonsingular(n), Jq: matrix(n, n)}, where=[GRAM],
      given=[given("(3.142)", (S*(Phi*Q*T(Phi) + H) + I)*Gp == T(Phi)*Gp*Jp), given("(3.144)", (S*(Phi*Q*T(Phi) + H) + I)*PhiT*Gq == Gq*Jq)],
      by=[instances(**MORE, made_by={Jp: inv(Gp)*PhiT*(gram()*(Phi*Q*T(Phi) + H) + I)*Gp, Jq: inv(Gq)*(gram()*(Phi*Q*T(Phi) + H) + I)*PhiT*Gq})],
      note="The second equation shows the inverse of the matrix that carries one to the other.")
