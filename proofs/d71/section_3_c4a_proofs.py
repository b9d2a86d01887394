# SPDX-License-Identifier: MIT
"""Steps of the local stability theorems (Chapter III, section C.4.a).

Stability: with a norm in which (DP - C)* + U_k*D* stretches every vector by delta > 1, the
vector y that it takes to R_k*x has norm at most |R_k*x|/delta, with equality possible only
where both are zero.

Instability: start at a multiple of vv* for an eigenvector v of K = B - PD, Kv = mu v. If
U = l r* with l and r multiples of v, then U*D* is a multiple of vv*D*, and in
[I + K U*D*]^{-1}K r the bracket takes v to a multiple of v: with mu* for the conjugate of mu
and N_k for the denominator of r_k the next denominator is N_k + delta^2 mu alpha |mu|^{2k}.
Here m_k stands for mu^k, u for the conjugate of v and c_k for that of m_k. The steps use
nothing of u and c_k, so that they hold for complex v and mu, too.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, induction, instances, order
from exactkf.language import (
    Identity,
    T,
    always,
    given,
    inv,
    let,
    loewner,
    matrix,
    nonsingular,
    nonzero,
    positive_definite,
    rec,
    scalar,
    symbols,
    vector,
)
from proofs.d71.notation import n

S, L, R, x, y, delta, d = symbols("S L R x y delta d")
NORMED = {S: positive_definite(n), L: nonsingular(n), R: matrix(n, n), x: vector(n), y: vector(n), delta: nonzero()}
STRETCH = given("(3.161)", loewner(T(L)*S*L, delta**2*S))
IS_Y = given("(3.155)", L*y == T(R)*x)
NORM_Y, NORM_R = T(y)*S*y, T(T(R)*x)*S*(T(R)*x)

claim("D71-E3.162", "the bound on y",
      delta**2*NORM_Y < NORM_R,
      sizes=["n"], over=NORMED, given=[STRETCH, IS_Y],
      by=[example(n=1, S=[[1]], L=[[2]], R=[[1]], x=[0], y=[0], delta=2), instances(n=(1, 2))],
      repair=repair(
          "boundary case", "where R_k*x = 0, as for x = 0, both sides are zero: the sign is <=, as in (3.161) and (3.164)",
          loewner(NORM_R, delta**2*NORM_Y),
          sizes=["n"], over=NORMED, given=[STRETCH, IS_Y],
          by=[order([T(y)*(T(L)*S*L - delta**2*S)*y]), example(n=1, S=[[1]], L=[[1]], R=[[1]], x=[1], y=[1], delta=2),
              example(n=1, S=[[1]], L=[[2]], R=[[1]], x=[1], y=[3], delta=2),
              instances(n=(1, 2), using={d: scalar()},
                        made_by={L: ((1 + d**2)*delta)*Identity(n), R: x*T(y)*(((1 + d**2)*delta)/(T(x)*x))})]),
      note="L is (DP_e - C)* + U_k*D*; norms are squared, |y|^2 = y*Sy. The print has it for all x.")

K, D, v, u, mu, mk, ck, Nk = symbols("K D v u mu mk ck Nk")
ell, r, w, nxt, old, f, P71 = symbols("ell r w nxt old f P71")
RUN = {K: matrix(n, n), D: matrix(n, n), v: vector(n), u: vector(n), mu: nonzero(), mk: nonzero(), ck: nonzero(), Nk: nonzero(), d: scalar()}
EIGEN = given("Kv = mu v", K*v == v*mu)
BRACKET = Identity(n) + (d**2*mu*mk*ck/Nk)*v*T(u)*T(D)
INSERTED = [let(ell, d*ck*u), let(r, (d*mk/Nk)*v), let(nxt, inv(Identity(n) + K*r*T(ell)*T(D))*K*r), let(w, inv(BRACKET)*v)]
ONE = {"n": 1, "K": [[2]], "D": [[1]], "v": [1], "u": [1], "mu": 2, "mk": 1, "ck": 1, "Nk": 1, "d": 1}
MAKE_K = instances(8, n=(1, 2, 3), using={L: nonsingular(n), R: matrix(n, n)},
                   made_by={K: (mu*v*T(v) + R*(T(v)*v*Identity(n) - v*T(v)))*inv(T(v)*v*Identity(n))})


def next_r(power):
    return nxt == d*power/Nk*w


claim("D71-E3.170", "r_k put into its recursion",
      next_r(mk/mu),
      sizes=["n"], over=RUN, where=INSERTED, given=[EIGEN],
      by=[example(ONE), instances(n=(1,), made_by={K: mu*Identity(n)})],
      repair=repair("index", "the factor is mu^{k+1}, as (3.174) has it: (B - P_e D) multiplies mu^k v by mu",
                    next_r(mk*mu), sizes=["n"], over=RUN, where=INSERTED, given=[EIGEN],
                    by=[order(lemmas=[K*r*T(ell)*T(D) == (d**2*mu*mk*ck/Nk)*v*T(u)*T(D)]), example({**ONE, "K": [[3]]}), MAKE_K]),
      note="r_{k+1} = [I + KU_k*D*]^{-1}K r_k with U_k* = r_k l_k*; mk stands for mu^k, Nk for the denominator of (3.169), d for delta and D for any matrix; u and "
           "ck stand for the conjugates of v and mk, and T(ell) for l_k*. "
           "In the counterexample n = 1, mu = 2, and all others are 1: r_{k+1} = 2/3 and w = 1/3.")

ALPHA = T(u)*T(D)*v
NEXT_N = Nk*Identity(1) + d**2*mu*mk*ck*ALPHA


def bracket_removed(multiplied):
    """(3.172) and (3.173), the first as ``multiplied`` w = v."""
    return (multiplied*w == v) & (w + (d**2*mu*mk*ck/Nk)*v*(T(u)*T(D)*w) == v) & (w*NEXT_N == Nk*v)


OVER_W = {key: kind for key, kind in RUN.items() if key.tree[1] != "K"}

claim("D71-E3.172", "the equation for w, and w",
      bracket_removed(P71),
      sizes=["n"], over={**OVER_W, f: vector(n), S: positive_definite(n)}, where=[let(w, inv(BRACKET)*v), let(P71, T(f)*S*f)],
      by=[example(n=1, D=[[1]], v=[1], u=[1], mu=2, mk=1, ck=1, Nk=1, d=1, f=[1], S=[[1]]), instances(n=(1,))],
      repair=repair("cross-reference", "the bracket that is meant stands in (3.171); (3.71) is an equation of two quadratic forms and has none",
                    bracket_removed(BRACKET),
                    sizes=["n"], over=OVER_W, where=[let(w, inv(BRACKET)*v)],
                    by=[order(lemmas=[BRACKET*w == v]), instances(n=(1, 2, 3))]),
      note="Read as printed: premultiplying (3.171) by what stands in (3.71), f*Sf, gives (3.172). The two equations themselves are right; the vector that "
           "the scan of (3.172) calls x is w. u and ck are the conjugates of v and mk. (3.173) is written without its denominator, Nk + delta^2 mu alpha |mu|^{2k}.")

# --- the rest of both proofs ----------------------------------------------------------------------------------------------

k, ms, Ns, rs, cs, mc = symbols("k m N r c mc")
POWERS = [rec(ms, k, 1, mu*ms[k]), rec(cs, k, 1, mc*cs[k]), rec(Ns, k, 1, Ns[k] + d**2*mu*ms[k]*cs[k]*ALPHA)]
R_START, R_STEP = d*v, inv(Identity(n) + K*rs[k]*T(d*cs[k]*u)*T(D))*K*rs[k]
OVER_R = {K: matrix(n, n), D: matrix(n, n), v: vector(n), u: vector(n), mu: nonzero(), mc: nonzero(), d: scalar()}
MADE = instances(6, n=(1, 2), horizon=3, using={L: nonsingular(n), R: matrix(n, n)},
                 made_by={K: (mu*v*T(v) + R*(T(v)*v*Identity(n) - v*T(v)))*inv(T(v)*v*Identity(n))})

claim("D71-E3.169", "r_k in closed form",
      always(k, rs[k]*Ns[k] == d*ms[k]*v),
      sizes=["n"], over=OVER_R, where=[*POWERS, rec(rs, k, R_START, R_STEP)], given=[EIGEN],
      by=[example({**{key: value for key, value in ONE.items() if key not in ("mk", "ck", "Nk")}, "mc": 2, "K": [[3]]}), MADE],
      note="m_k = mu^k and N_k is the denominator; u, mc and c_k are the conjugates of v, mu and m_k. U_k* = r_k l_k* with l_k* = d c_k v*.")

claim("D71-E3.174", "the next r",
      nxt*NEXT_N == d*mk*mu*v,
      sizes=["n"], over=RUN, where=INSERTED, given=[EIGEN],
      by=[order(lemmas=[K*r*T(ell)*T(D) == (d**2*mu*mk*ck/Nk)*v*T(u)*T(D)]), example({**ONE, "K": [[3]]}), MAKE_K],
      note="mk is mu^k and Nk the denominator of r_k; u and ck are the conjugates of v and mk, of which nothing is used.")

claim("D71-E3.175", "the deviation in closed form",
      always(k, (Ns[k] == 1 + d**2*mu*ALPHA*((ms[k]*cs[k] - 1)/(mu*mc - 1))) & ((d*cs[k]*u)*T((d*ms[k]/Ns[k])*v) == (d**2*ms[k]*cs[k]/Ns[k])*u*T(v))),
      sizes=["n"], over={D: matrix(n, n), v: vector(n), u: vector(n), mu: nonzero(), mc: nonzero(), d: scalar()}, where=POWERS,
      by=[instances(8, n=(1, 2), horizon=3)],
      note="Conjugated: U_k is l_k r_k*, and the second equation is for its conjugate, with u, mc and c_k for the conjugates of v, mu and m_k. N_k is "
           "d^2|mu|^{2k} over the conjugate of beta_k; |mu| is not 1.")

U, G, L0, R0 = symbols("U G L0 R0")
claim("D71-E3.152", "the deviation as a product",
      always(k, U[k] == L[k]*R[k]),
      sizes=["n"], over={K: matrix(n, n), D: matrix(n, n), G: matrix(n, n), L0: matrix(n, n), R0: matrix(n, n)},
      where=[rec(U, k, L0*R0, K*U[k]*inv(G + D*U[k])), rec(L, k, L0, K*L[k]), rec(R, k, R0, R[k]*inv(G + D*U[k]))],
      by=[induction(), instances(8, n=(1, 2), horizon=2)],
      note="G is DP_e - C and K is B - P_e D, as in (3.150).")
