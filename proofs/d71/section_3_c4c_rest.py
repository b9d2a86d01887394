# SPDX-License-Identifier: MIT
"""The actual covariance: the Lyapunov function, and the figures of the examples (Chapter III, section C.4.c).

With S - A'SA = I, A = Phi(I - K_eM), the function x'Sx falls by |x|^2 along x+ = Ax, so that it falls
by the factor 1 - 1/sigma at least if S <= sigma I.

The figures are tested at some samples, by exact rational arithmetic. Where n is a null vector of
P_0 and undriven, P_k n = 0 for ever, and n'P_a n obeys a recursion of its own. In the second case of Example
3.5 the entry y_12 grows by y_22(1 + j x_0) in the coordinates y_12(1 + kx_0), so it is unbounded unless
y_22 = 0.
"""

from exactkf.claims import claim, not_checked
from exactkf.evidence import evaluation, example, instances, order, part, restated, within
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    forall,
    given,
    let,
    loewner,
    matrix,
    nonneg,
    pd,
    positive,
    rank,
    rational,
    rec,
    rows,
    scalar,
    schur,
    symbols,
    symmetric_matrix,
    trace,
    vector,
)
from proofs.d71.notation import H, M, P, Phi, V, gain, k, n, step
from proofs.d71.section_3_c4c_examples import COORDINATES, E11, GROWING, NULL, WALKING, modes

A, B, S, x, si, Pa, TT_, x0, Y, Xk, y11, y12, y22, less = symbols("A B S x sigma Pa TT x0 Y Xk y11 y12 y22 less")
I, I2 = Identity(n), Identity(2)
LYAPUNOV = given("(3.253)", S - T(A)*S*A == I)
VECTORS = {"sizes": ["n"], "over": {A: matrix(n, n), S: symmetric_matrix(n), x: vector(n)}}

not_checked("D71-T3.25", "the actual covariance converges", "a limit along two recursions at once; what can be decided are its steps (3.253) to (3.260), of "
                                                            "which the last is misprinted")

claim("D71-E3.253", "the Lyapunov function",
      pd(S) & (T(B*x)*S*(B*x) - T(x)*S*x == T(x)*(T(B)*S*B - S)*x) & (T(A*x)*S*(A*x) - T(x)*S*x == -(T(x)*x)), sizes=["n"],
      over={**VECTORS["over"], B: matrix(n, n)}, given=[LYAPUNOV, given("A is stable", schur(A))],
      by=[restated("Negative definite forms stay so under small changes, and P_k tends to P_e."),
          order([I], [], [], inside=[within(0, stein=T(A))]), example(n=1, A=[[2]], S=[["-1/3"]], x=[1], B=[[1]]),
          example(n=1, A=[["1/2"]], S=[[-1]], x=[1], B=[[1]]),
          example(n=1, A=[["1/2"]], S=[[1]], x=[1], B=[[1]]), instances(4, n=(1, 2), made_by={A: Zero(n, n), S: I}),
          instances(4, n=(1, 2), made_by={A: I/2, S: rational("4/3")*I}),
          example(n=2, A=[[0, 2], [0, 0]], S=[[1, 0], [0, 5]], x=[1, 1], B=[[1, 2], [0, 1]])],
      note="A is Phi(I - K_eM), and B is Phi(I - K_kM). The difference is -|x|^2 for B = A, and so negative definite for every B near A.")

claim("D71-E3.258", "how fast the function falls",
      si*(T(A*x)*S*(A*x)) <= less*(T(x)*S*x), sizes=["n"], over={**VECTORS["over"], si: positive()}, where=[let(less, si - 1)],
      given=[LYAPUNOV, given("S <= sigma", loewner(si*I, S))],
      by=[part("one step of the limit matrix"),
          order([T(x)*(si*I - S)*x]), example(n=1, A=[[2]], S=[[1]], x=[1], sigma=1), example(n=1, A=[["1/2"]], S=[["4/3"]], x=[1], sigma="7/6"),
          example(n=1, A=[["1/2"]], S=[["4/3"]], x=[1], sigma="4/3"),
          instances(4, n=(1, 2), made_by={A: I/2, S: rational("4/3")*I, si: rational("4/3")}),
          example(n=2, A=[[0, 2], [0, 0]], S=[[1, 0], [0, 5]], x=[1, 1], sigma=5)],
      note="For the limit A of the matrices in the product: V falls by the factor 1 - 1/sigma, which gives lambda_1 and c_1. That the matrices come near "
           "their limit, and that D_i tends to zero like a power, is not stated here.")

# --- Examples 3.3 and 3.4 --------------------------------------------------------------------------------------------------


def run(start, actual, driven=None):
    """P_k and P_a(t_k); H_a = H, or another matrix."""
    noise = H if driven is None else driven
    closed = Phi*(I2 - gain(P[k])*M)
    return [rec(P, k, start, step(P[k])), rec(Pa, k, actual, closed*Pa[k]*T(closed) + Phi*gain(P[k])*V*T(gain(P[k]))*T(Phi) + noise)]


def near(value, printed, tolerance):
    return abs(trace(value) - rational(printed)) < rational(tolerance)


LARGE = (rows([[64, 0], [0, 64]]), rows([[49, 0], [0, 49]]))
NOTHING = (Zero(2, 2), I2)
claim("D71-X3.3", "the modes of Example 3.3", modes(rational("3/2")), where=GROWING, by=[part("the modes, not the equilibria"), evaluation()],
      note="The stable mode 1/2 is driven, as H(0, 1) is not zero, the unstable mode 3/2 is not, as H(3, -2) = 0; M sees both eigenvectors. The two "
           "equilibria are D71-E3.262 and D71-E3.263.")

claim("D71-F3.8", "both traces approach that of the stable equilibrium",
      forall(k, 16, 20, near(P[k], "25.02438", "1/1000") & near(Pa[k], "25.02438", "1/1000")) & (trace(P[1]) > 26) & (trace(Pa[1]) > 26),
      where=[*GROWING, *run(*LARGE)], by=[part("the samples 1 and 16 to 20"), evaluation()],
      note="25.02438 is the trace of (3.262) as printed. The samples 16 to 20 are within 1/1000 of it.")

claim("D71-F3.9", "the computed trace approaches that of the unstable equilibrium, the actual one grows",
      forall(k, 0, 12, (P[k]*NULL == Zero(2, 1)) & (T(NULL)*Pa[k]*NULL == rows([[13]])*Xk[k])) & near(P[12], "14.72617", "1/1000"),
      where=[*GROWING, rec(Xk, k, 1, Xk[k]*rational("9/4")), *run(*NOTHING)], by=[part("the first twelve samples, without round-off"), evaluation()],
      note="For exact computation, and the first twelve samples: P_kn = 0 with n = (3, -2), and n'P_an = 13(9/4)^k. That round-off ends this is not stated "
           "here. 14.72617 is the trace of (3.263) as printed.")

claim("D71-F3.10", "both traces approach the only equilibrium",
      forall(k, 1, 19, (trace(P[k + 1]) < trace(P[k])) & (trace(P[k]) > rational("14.726")))
      & forall(k, 4, 20, (trace(P[k]) - trace(Pa[k]) < rational("2/5")) & (trace(P[k]) > trace(Pa[k])))
      & (trace(P[20]) - trace(Pa[20]) < rational("1/60")), where=[*WALKING, *run(*LARGE)], by=[part("the first twenty samples"), evaluation()],
      note="For the first twenty samples: from 128 and 98 at the start, the traces are 0.4 apart after four samples and 1/60 after twenty, and the one of "
           "P_k falls towards 14.726.")

claim("D71-F3.11", "the actual trace stays above the computed one",
      forall(k, 0, 12, (P[k]*NULL == Zero(2, 1)) & (T(NULL)*Pa[k]*NULL == rows([[13]]))) & near(P[12], "14.72617", "1/1000") & near(Pa[12], "20.434", "1/100"),
      where=[*WALKING, *run(*NOTHING)], by=[part("the first twelve samples"), evaluation()],
      note="P_kn = 0 and n'P_an = 13, here for twelve samples; the traces are 14.726 and 20.434 after twelve samples.")

# --- Example 3.5 -----------------------------------------------------------------------------------------------------------

SECOND = rows([[40, 60], [60, 90]])
WALK = [*COORDINATES, let(H, Zero(2, 2))]
claim("D71-X3.5", "the process of Example 3.5",
      (step(P) == P) & (Phi*(I2 - gain()*M) == Phi) & ((Phi - I2)*(Phi - I2) == Zero(2, 2)) & (rank(Phi - I2) == 1), where=[*WALK, let(P, Zero(2, 2))],
      by=[part("0 is an equilibrium, and its linear equation; not that it is the only one"), evaluation()],
      note="B - PD is Phi at P = 0, with the double eigenvalue 1 in one Jordan block. That there is no other equilibrium is not stated here.")

claim("D71-F3.13", "the second case",
      forall(k, 1, 19, (trace(P[k + 1]) < trace(P[k])) & (k*trace(P[k]) <= 13)) & forall(k, 6, 20, trace(Pa[k]) > 2*k**2), where=[*WALK, *run(SECOND, E11)],
      by=[part("the first twenty samples"), evaluation()],
      note="For the first twenty samples: the trace of P_k is at most 13/k, that of P_a(t_k) more than 2k^2 from the sixth on.")

claim("D71-F3.14", "the third case",
      (trace(Pa[10]) > 50*trace(Pa[40])) & (trace(Pa[40]) < 2*trace(P[40])) & (trace(Pa[100]) > 2*trace(P[100])) & (trace(Pa[100]) > trace(Pa[80])),
      where=[*WALK, *run(E11/100, I2, E11/500000)], by=[part("four samples"), evaluation()],
      note="P_a(t_k) first grows, comes back to less than twice P_k at the sample 40, and leaves it again; at the sample 100 it is more than twice and grows.")

SIXTH = {y11: scalar(), y12: scalar(), y22: nonneg(), x0: nonneg()}
claim("D71-E3.274", "bounded solutions of the second case",
      always(k, (Y[k]*(1 + k*x0) == y12 + y22*(k + x0*k*(k - 1)/2)) & (TT_*rows([[y11, 0], [0, 0]])*T(TT_) == y11*rows([[4, 6], [6, 9]]))),
      over=SIXTH, where=[let(TT_, rows([[2, -1], [3, 0]])), rec(Xk, k, x0, Xk[k]/(1 + Xk[k])), rec(Y, k, y12, (Y[k] + y22)/(1 + Xk[k]))],
      by=[instances(12, horizon=5)],
      note="Y is the entry y_12 of (3.273); y_22 does not change. It grows like k y_22/2 and is bounded only if y_22 = 0, and then y_12 = 0, as P_a(t_0) >= "
           "0, so that P_a(t_0) has the form (3.274).")
