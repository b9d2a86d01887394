# SPDX-License-Identifier: MIT
"""The bounds in the proofs of local stability and instability (Chapter III, section C.4.a).

Write G = DP - C for the matrix outside the circle and K = B - PD, with GK' = I. If S > 0 and
GSG' = S + T with T > 0, then G' stretches every vector by a factor greater than one in the norm of
S, and a small U does not undo that: so the norm of R_k falls. With an eigenvector v of K outside
the circle U_0 = delta^2 vv' stays a multiple of vv', with the coefficient

    beta_k = y/(1 + mu alpha (y - delta^2)/(mu^2 - 1)),    y = delta^2 mu^{2k},

and with c = (mu^2 - 1)/|mu alpha| the condition y >= c/10 gives |beta_k| >= 1/(1/y + 1/c) >= c/11.

The matrices are real, and norms are numbers.
"""

from exactkf.claims import claim
from exactkf.evidence import example, induction, instances, order, part, positivity, restated, steps
from exactkf.language import (
    Identity,
    T,
    always,
    eq,
    given,
    integer,
    inv,
    let,
    loewner,
    matrix,
    nonneg,
    nonzero,
    positive,
    positive_definite,
    rec,
    scalar,
    standing,
    symbols,
    vector,
)
from proofs.d71.notation import k, n

q, G, D, U, L, R, R1, K, S, W, x, y, e, Pw, L0, e1 = symbols("q G D U L R R1 K S W x y e Pw L0 e1")
I = Identity(n)
SIZES = {"n": (1, 2), "q": (1, 2)}

claim("D71-E3.155", "the vector y",
      eq(y, T(R1)*x) & ((T(G) + T(U)*T(D))*y == T(R)*x), sizes=["n", "q"],
      over={G: matrix(n, n), D: matrix(n, n), L: matrix(n, q), R: matrix(q, n), x: vector(q)},
      where=[let(U, L*R), let(R1, R*inv(G + D*U)), let(y, inv(T(G) + T(U)*T(D))*(T(R)*x))], by=[order(), instances(6, **SIZES)],
      note="G is DP - C and R1 is R_{k+1} of (3.153). With the norm a definition; y is R_{k+1}'x, which is what the norm of R_{k+1} is about.")

claim("D71-E3.157", "the stretching",
      (T(T(G)*y)*S*(T(G)*y) == T(y)*S*y + T(y)*W*y) & (T(T(G)*y)*S*(T(G)*y) >= e1*(T(y)*S*y)), sizes=["n"],
      over={G: matrix(n, n), S: positive_definite(n), e: positive(), y: vector(n)}, where=[let(W, G*S*T(G) - S), let(e1, 1 + e)],
      given=[given("T >= eS", loewner(W, e*S))],
      by=[restated("For S > 0 and T > 0 there is an e > 0 with T >= eS."),
          order([], [T(y)*(W - e*S)*y]), example(n=1, G=[[1]], S=[[1]], e=1, y=[1]), example(n=1, G=[[2]], S=[[1]], e=3, y=[1]),
          instances(6, n=(1, 2), made_by={G: (1 + e)*I}), instances(4, n=(1,))],
      note="W stands for T. Since T > 0 there is an e > 0 with T >= eS, and alpha is the square root of 1 + e.")

claim("D71-E3.158", "the deviation by its factors",
      always(k, T(L[k]*R)*T(D)*y == T(R)*T(L0)*T(Pw[k])*T(D)*y), sizes=["n", "q"],
      over={K: matrix(n, n), D: matrix(n, n), L0: matrix(n, q), R: matrix(q, n), y: vector(n)},
      where=[rec(L, k, L0, K*L[k]), rec(Pw, k, I, K*Pw[k])],
      by=[restated("The norm of a product is at most the product of the norms."),
          induction(also=[L[k] == Pw[k]*L0]), instances(6, horizon=3, **SIZES)],
      note="K is B - PD, Pw_k its power and R is R_k. The norms then multiply, with beta a bound of the norms of the powers.")

# norms: |s| of the sum, |u| and |w| of its parts, |y|
s, u, w, m, alpha, gamma, r, delta, r1 = symbols("s u w m alpha gamma r delta r1")
claim("D71-E3.161", "the sum is still stretched",
      s >= (alpha - gamma*r)*m, over={name: nonneg() for name in (s, u, w, m, alpha, gamma, r)},
      given=[given("triangle", s + w >= u), given("(3.157)", u >= alpha*m), given("(3.159)", gamma*r*m >= w)],
      by=[restated("The triangle inequality."),
          positivity([(1, 1, ["triangle"]), (1, 1, ["(3.157)"]), (1, 1, ["(3.159)"])]), instances(made_by={u: alpha*m + r, w: gamma*r*m, s: alpha*m + r}),
          instances()],
      note="m is the norm of y, r that of R_k, u and w are the norms of (DP - C)'y and U_k'D'y, and s is that of their sum. With r < (alpha - 1)/gamma the "
           "factor delta is greater than one.")

claim("D71-E3.164", "the norm of R falls",
      delta*r1 <= r, over={r1: nonneg(), m: nonneg(), r: nonneg(), s: nonneg(), delta: positive()},
      given=[given("x attains the maximum", r1 <= m), given("(3.161)", s >= delta*m), given("(3.155)", s <= r)],
      by=[restated("The maximum over the unit sphere is attained.", "What falls by a factor greater than one at each step tends to zero."),
          positivity([(1, 1, ["delta", "x attains the maximum"]), (1, 1, ["(3.161)"]), (1, 1, ["(3.155)"])]),
          instances(made_by={r1: m, s: delta*m, r: delta*m + 1}), instances(made_by={r1: m, s: delta*m, r: delta*m}), instances()],
      note="r1 is the norm of R_{k+1}, attained at an x of norm one with y of norm m; s is the norm of R_k'x.")

#: one state: u+ = kappa^2 u/(1 + c u)
kappa, c, u0, Uk, rate = symbols("kappa c u0 Uk rate")
claim("D71-T3.22", "local stability",
      always(k, abs(Uk[k]) <= rate**k*abs(u0)), over={kappa: scalar(), c: scalar(), u0: scalar(), rate: positive()},
      where=[rec(Uk, k, u0, kappa**2*Uk[k]/(1 + c*Uk[k]))],
      given=[standing("J is outside the circle", kappa**2 < 1), standing("a rate", rate <= 1), given("near", abs(c*u0)*rate <= rate - kappa**2)],
      by=[part("one state"), steps("D71-E3.152", "D71-E3.155", "D71-E3.157", "D71-E3.158", "D71-E3.161", "D71-E3.164",
                facts=["For a matrix inside the circle the equation S - K'SK = T has a solution S > 0 for T > 0."],
                prose="The norm of R_k falls by a factor below one at each step and L_k stays bounded, so U_k = L_kR_k tends to zero. (3.162) is read with "
                      "<=."),
          example(kappa=1, c=1, u0="-1/10", rate="9/10"), example(kappa="1/2", c=1, u0=-2, rate="1/2"), example(kappa="1/2", c=1, u0="-1/2", rate="1/2"),
          example(kappa=2, c=0, u0=1, rate=1),
          instances(made_by={rate: 1, kappa: u/(1 + abs(u)), u0: (1 - (u/(1 + abs(u)))**2)/(1 + abs(c))}, using={u: scalar()}), instances()],
      note="The statement is tested for one state, where u_{k+1} = kappa^2u_k/(1 + cu_k) with kappa = B - PD: from a start with |cu_0| <= 1 - kappa^2/rate "
           "the deviation falls like rate^k. The displayed steps are for every size.")

# --- instability -----------------------------------------------------------------------------------------------------------

v, mu, dd, ell, rr, Us = symbols("v mu dd ell rr Us")
claim("D71-E3.167", "the deviation as a product of vectors",
      always(k, (Us[k]*y == ell[k]*(T(rr[k])*y)) & (K*ell[k] == ell[k]*mu)), sizes=["n", "q"],
      over={K: matrix(n, n), D: matrix(n, n), v: matrix(n, q), y: vector(n), mu: matrix(q, q), dd: scalar()},
      where=[rec(Us, k, dd**2*v*T(v), K*Us[k]*T(K)*inv(I + D*Us[k]*T(K))), rec(ell, k, dd*v, ell[k]*mu),
             rec(rr, k, dd*v, inv(I + K*T(Us[k])*T(D))*K*rr[k])],
      given=[given("v at mu", K*v == v*mu)],
      by=[induction(also=[Us[k] == ell[k]*T(rr[k])]), example(n=2, q=1, K=[[1, 1], [0, 2]], D=[[1, 0], [1, 1]], v=[[1], [1]], y=[1, 2], mu=[[2]], dd=1),
          example(n=1, q=1, K=[[2]], D=[[1]], v=[[1]], y=[1], mu=[[3]], dd=1),
          instances(6, n=(1, 2), q=(1, 2), horizon=2, using={w: scalar()}, made_by={K: w*I, mu: w*Identity(q)})],
      note="l_k = dd mu^k v, with dd for delta; mu stands on the right as a matrix, so that for a complex mu the columns of v are the two real vectors of a "
           "complex one. Said for any vector y that both sides are applied to.")

alp, dl, Y, beta = symbols("alpha delta Y beta")
claim("D71-E3.176", "the deviation leaves, where alpha is not zero",
      11*abs(mu*alp*beta) >= mu**2 - 1, over={mu: scalar(), alp: nonzero(), dl: positive(), k: integer(1, 4)},
      where=[let(Y, dl**2*mu**(2*k)), let(beta, Y/(1 + mu*alp*(Y - dl**2)/(mu**2 - 1)))],
      given=[standing("|mu| > 1", mu**2 > 1), given("(3.176)", 10*Y*abs(mu*alp) >= mu**2 - 1)],
      by=[part("real mu"), example(mu=2, alpha=1, delta="1/100", k=1), example(mu="1/2", alpha=1, delta=1, k=1), example(mu=2, alpha=1, delta="11/100", k=1),
          example(mu=2, alpha=-1, delta="1/4", k=1), instances(), instances(made_by={dl: 1/(2 + alp**2)})],
      note="The line (3.176) is scrambled in the scan and read as k >= ln((|mu|^2 - 1)/(10 delta^2|mu alpha|))/(2 ln|mu|), whose exponential is stated; Y "
           "is delta^2|mu|^{2k}. For real mu.")

(eps,) = symbols("eps")
claim("D71-E3.176.b", "the deviation leaves, where alpha is zero",
      abs(beta) >= eps, over={mu: nonzero(), dl: positive(), eps: positive(), k: integer(1, 4)},
      where=[let(alp, 0), let(Y, dl**2*mu**(2*k)), let(beta, Y/(1 + mu*alp*(Y - dl**2)/(mu**2 - 1)))], given=[given("the bound on k", Y >= eps)],
      by=[part("real mu"), instances(), instances(made_by={eps: dl**2*mu**(2*k)})],
      note="The exponential of the bound on k; Y is delta^2|mu|^{2k}. For real mu.")

b0, bk, far = symbols("b0 bk far")
claim("D71-T3.23", "local instability",
      abs(b0) >= far, over={mu: scalar(), alp: nonzero(), dl: positive(), far: positive(), k: integer(1, 5)},
      where=[rec(bk, q, dl**2, mu**2*bk[q]/(1 + mu*alp*bk[q])), let(b0, bk[k])],
      given=[standing("an eigenvalue outside", mu**2 > 1), given("late enough", 10*dl**2*mu**(2*k)*abs(mu*alp) >= mu**2 - 1),
             standing("this far", far*11*abs(mu*alp) == mu**2 - 1)],
      by=[part("along an eigenvector, for a real eigenvalue"),
          example(mu=2, alpha=1, delta="1/100", far="3/22", k=1), instances(made_by={far: (mu**2 - 1)/(11*abs(mu*alp))}),
          instances(made_by={dl: 1/(2 + alp**2), far: (mu**2 - 1)/(11*abs(mu*alp))})],
      note="The statement is tested along the eigenvector, where U_k = beta_k vv': however small delta is, beta_k gets as far as (mu^2 - 1)/(11|mu alpha|), "
           "if late.")
