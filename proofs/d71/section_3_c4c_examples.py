# SPDX-License-Identifier: MIT
"""Actual covariances when a mode is undriven, and the examples (Chapter III, section C.4.c, end).

If Phi'n = lambda* n and P_k n = 0 then n*Phi(I - K_k M) = lambda n*, so that n*P_a n is
multiplied by |lambda|^2 and increased by n*H_a n. A right eigenvector v at lambda with
n*v = 1 exists if lambda is a simple eigenvalue of Phi(I - K_k M); with a Jordan block there
n is orthogonal to the only eigenvector.

In Example 3.5 the model of Example 3.2 runs on a process that is undriven in fact, too. From
X_0 = diag(0, a), a = 1/10, the gain leaves an error (x_1, x_2) with x_1 - k x_2 constant, and
N_k x_2 changes by -a(k + 1)c at each step, c being that constant. So x_2 is about -3c/2k and
x_1 tends to -c/2: the actual covariance tends to c^2/4 times that of the first coordinate,
and not to zero.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import evaluation, example, identity, induction, instances, part
from exactkf.language import (
    Identity,
    T,
    Z,
    Zero,
    always,
    block,
    diag,
    forall,
    given,
    inv,
    laurent,
    let,
    matrix,
    matrix_of,
    nonsingular,
    pd,
    positive,
    positive_definite,
    positive_semidefinite,
    prints,
    psd,
    rank,
    rational,
    rec,
    rows,
    scalar,
    schur,
    sequence,
    sum_of,
    sym,
    symbols,
    trace,
    vector,
    vstack,
    when,
)
from proofs.d71.notation import H, K, M, P, Phi, V, gain, i, j, k, n, p, step

E, c, X, Y, Ha, Va, Pa, lam, nd, Acl, LESS, D2 = symbols("E c X Y Ha Va Pa lam nd Acl LESS D2")
I = Identity(n)

# --- an undriven unstable mode ----------------------------------------------------------------------------------------------

ACTUAL = {Phi: nonsingular(n), M: matrix(p, n), V: positive_definite(p), P: positive_semidefinite(n), Ha: positive_semidefinite(n),
          Va: positive_semidefinite(p), Pa: positive_semidefinite(n), lam: scalar(), nd: vector(n)}
WHERE = [let(K, gain()), let(Acl, Phi*(I - K*M)), let(LESS, Acl - lam*I)]
MODE = [given("an undriven mode", T(Phi)*nd == lam*nd), given("P_k n = 0", P*nd == Zero(n, 1)), given("n is not zero", nd != Zero(n, 1))]
NEXT_PA = Acl*Pa*T(Acl) + Phi*K*Va*T(K)*T(Phi) + Ha
GROWTH = T(nd)*NEXT_PA*nd == lam**2*(T(nd)*Pa*nd) + T(nd)*Ha*nd
HAS_V = rank(vstack(LESS, T(nd))) == rank(LESS) + 1
SHEAR = {"n": 2, "p": 1, "Phi": [[2, 1], [0, 2]], "M": [[1, 0]], "V": [[1]], "P": [[0, 0], [0, 0]], "Ha": [[0, 0], [0, 0]], "Va": [[1]],
         "Pa": [[1, 0], [0, 1]], "lam": 2, "nd": [0, 1]}
SIMPLE = given("lambda is simple", (rank(LESS) == n - 1) & (rank(LESS*LESS) == n - 1))
PLAIN = {"n": 1, "p": 1, "Phi": [[2]], "M": [[1]], "V": [[1]], "P": [[0]], "Ha": [[1]], "Va": [[1]], "Pa": [[1]], "lam": 2, "nd": [1]}
REST = n - 1
CORNERED = instances(8, n=(2, 3), p=(1, 2), using={E: nonsingular(n), X: matrix(REST, 1), D2: nonsingular(REST), Y: matrix(REST, REST)},
                     made_by={Phi: E*block([[lam*Identity(1), Zero(1, REST)], [X, D2]])*inv(E), P: E*diag(Zero(1, 1), Y*T(Y))*T(E),
                              nd: inv(T(E))*matrix_of(i, j, n, 1, when(i == 1, 1, 0))})

claim("D71-E3.248", "the component along an undriven unstable mode",
      HAS_V & GROWTH,
      sizes=["n", "p"], over=ACTUAL, where=WHERE, given=MODE,
      by=[example(SHEAR), instances(n=(1,), p=(1,))],
      repair=repair(
          "missing hypothesis", "v_k exists if lambda is a simple eigenvalue of Phi(I - K_k M); for a mode with a Jordan block, or a P_k that makes one, n is "
          "orthogonal to the only eigenvector; the equation for n*P_a n holds in any case",
          HAS_V & GROWTH,
          sizes=["n", "p"], over=ACTUAL, where=WHERE, given=[*MODE, SIMPLE],
          by=[part("real lambda"),
              example(SHEAR), example({**PLAIN, "lam": 3}), example({**PLAIN, "P": [[1]], "lam": 1}), example({**PLAIN, "nd": [0]}), example(PLAIN), CORNERED]),
      note="Real lambda; alpha_k is n*P_a(t_k)n, as n*v_k = 1 makes it. A vector v_k with Phi(I - K_k M)v_k = lambda v_k and n*v_k = 1 exists exactly if n* "
           "adds one to the rank of Phi(I - K_k M) - lambda I. The counterexample is Phi = [[2, 1], [0, 2]], H = 0, M = [1, 0] and P_0 = 0, so that K_k = 0; "
           "the text asks for a simple mode in the random walk case alone.")

# --- the bound in the proof of Theorem 3.25 --------------------------------------------------------------------------------

c1, c2, s1, s2, phi, w, w0, d, BOUND, m = symbols("c1 c2 s1 s2 phi w w0 d BOUND m")
DECAY = {c1: positive(), c2: positive(), s1: positive(), s2: positive(), phi: scalar(), w0: scalar(), d: sequence(0, m - 1)}
SCALAR = [rec(w, k, w0, phi**2*w[k] + d[k])]
BOUNDED = [given("(3.258)", forall(k, 0, m, abs(phi)**k <= c1*s1**k)), given("(3.259)", forall(k, 0, m - 1, abs(d[k]) <= c2*s2**k))]


def bounded_by(start):
    return [*SCALAR, let(BOUND, c1**2*s1**(2*m)*start + sum_of(k, 0, m - 1, c1**2*c2*s1**(2*(m - k - 1))*s2**k))]


claim("D71-E3.260", "the bound on W_m",
      abs(w[m]) <= BOUND, sizes=["m"], over=DECAY, where=bounded_by(1), given=BOUNDED,
      by=[example(m=1, c1=1, c2=1, s1="1/2", s2="1/2", phi="1/2", w0=8, d=[0]), instances(m=(1,))],
      repair=repair("factor", "the first term of (3.257) is bounded by c_1^2 exp(-2 lambda_1 m) times the norm of W_0, which is missing",
                    abs(w[m]) <= BOUND, sizes=["m"], over=DECAY, where=bounded_by(abs(w0)), given=BOUNDED,
                    by=[part("one state, a constant coefficient"),
                        example(m=1, c1=1, c2=1, s1="1/2", s2="1/2", phi=2, w0=1, d=[0]), example(m=1, c1=1, c2=1, s1="1/2", s2="1/2", phi=0, w0=0, d=[9]),
                        example(m=2, c1=1, c2=1, s1=1, s2=2, phi=1, w0=1, d=[1, 2]), example(m=2, c1=1, c2=1, s1="1/2", s2=2, phi="-1/2", w0=-3, d=[-1, -2]),
                        example(m=3, c1=1, c2=2, s1="1/2", s2="1/3", phi="1/2", w0=1, d=[2, "2/3", "2/9"]),
                        example(m=2, c1=2, c2=1, s1="1/2", s2=1, phi="1/2", w0=1, d=[1, 1]),
                        instances(8, m=(1, 2, 3), using={c: sequence(0, m - 1)},
                                  made_by={s1: abs(phi), c1: 1 + c2**2, d: (k, c2*s2**k*c[k]/(1 + abs(c[k])))})]),
      note="One state and a constant coefficient phi, so that Phi_x(t_m, t_j) = phi^{m-j}; s1 and s2 stand for exp(-lambda_1) and exp(-lambda_2). c_1 and "
           "c_2 are those of (3.258) and (3.259); a larger c_1 could make up for the missing factor, but is not what the text takes.")

# --- figures and equations that are cited -----------------------------------------------------------------------------------

P0, Pa0, FORM = symbols("P0 Pa0 FORM")
STARTS = [let(P0, rows([[0, 0], [0, 0]])), let(Pa0, rows([[1, 0], [0, 1]]))]
TENTH, E11 = rows([[rational("1/10"), 0], [0, 0]]), rows([[1, 0], [0, 0]])

claim("D71-S66", "the figure for the initial values (3.265)",
      trace(P0) == trace(TENTH), where=STARTS, by=[evaluation()],
      repair=repair("cross-reference", "they are those of Figure 3.9; Figure 3.7 belongs to Example 3.2 and starts at (3.235)",
                    (P0 == Zero(2, 2)) & (Pa0 == Identity(2)), where=STARTS, by=[evaluation()]),
      note="Figure 3.7 is a graph of tr P_k from (3.235), where it is 1/10; from (3.265) it is 0. The repair compares (3.265) with the caption of Figure 3.9.")

SECOND = [let(P0, rows([[40, 60], [60, 90]])), let(Pa0, E11), let(FORM, rows([[4, 6], [6, 9]]))]

claim("D71-S67", "the initial value of the second case",
      (Pa0 == Identity(2)) & (rank(vstack(rows([[1, 0, 0, 1]]), rows([[4, 6, 6, 9]]))) == 2), where=SECOND, by=[evaluation()],
      repair=repair("cross-reference", "the initial value of the second case is (3.268b); (3.269b) is that of the third",
                    (Pa0 == E11) & (rank(vstack(rows([[1, 0, 0, 0]]), rows([[4, 6, 6, 9]]))) == 2) & (P0 == 10*FORM), where=SECOND, by=[evaluation()]),
      note="Pa0 is P_a(t_0) of the second case, (3.268b). The rank says that a matrix, written as a row, is no multiple of [[4, 6], [6, 9]].")

# --- Examples 3.3 and 3.4: a stable mode, and an undriven unstable or random walk mode ---------------------------------------

Pe1, Pe2, root, TT = symbols("Pe1 Pe2 root TT")
HALF, THREE_HALVES = rational("1/2"), rational("3/2")
NOISE = rows([[4, 6], [6, 9]])
TWO_MODES = [let(TT, rows([[2, -1], [3, 0]])), let(H, NOISE), let(M, rows([[-1, 1]])), let(V, rows([[1]]))]
NULL = rows([[3], [-2]])
GROWING = [let(Phi, rows([[THREE_HALVES, -rational("2/3")], [0, HALF]])), *TWO_MODES]
WALKING = [let(Phi, rows([[1, -rational("1/3")], [0, HALF]])), *TWO_MODES]
#: in the field of the square root of 65
ROOTS = [let(Pe1, rows([[1609 + 9*root, 1431 - 9*root], [1431 - 9*root, 1449 + 9*root]])*rational("1/128")),
         let(Pe2, ((1 + root)/8)*NOISE)]
#: root is the square root of 65
IN_FIELD = {"over": {root: scalar()}, "given": [given("a root", root**2 == 65), given("the positive one", root > 0)],
            "by": [example(root=[0, 1], field=[["-65", "0", "1"], "8", "9"]), example(root=[0, 1], field=[["-65", "0", "1"], "-9", "-8"]), example(root=8)]}


def modes(other):
    """The eigenvectors, what drives them and what the measurement sees of them."""
    return ((Phi*TT == TT*diag(HALF, other)) & (M*TT == rows([[1, 1]])) & (T(Phi)*NULL == other*NULL) & (H*NULL == Zero(2, 1))
            & (T(Phi)*rows([[0], [1]]) == HALF*rows([[0], [1]])) & (H*rows([[0], [1]]) == rows([[6], [9]])))


def closed(at):
    return Phi*(Identity(2) - gain(at)*M)


claim("D71-E3.261", "the modes of Example 3.3", modes(THREE_HALVES), where=GROWING, by=[evaluation()],
      note="The columns of T are the eigenvectors of Phi, (3, -2) and (0, 1) those of Phi'.")

claim("D71-E3.262", "the stable equilibrium",
      prints(Pe1, [["13.13719", "10.61281"], ["10.61281", "11.88719"]]) & (step(Pe1) == Pe1) & pd(Pe1) & schur(Acl),
      where=[*GROWING, *ROOTS, let(Acl, closed(Pe1))], **IN_FIELD, note="In closed form over the rational numbers and the square root of 65. Stable: B - PD "
                                                                        "is inside the unit circle.")

claim("D71-E3.263", "the unstable equilibrium",
      prints(Pe2, [["4.53113", "6.79669"], ["6.79669", "10.19504"]]) & (step(Pe2) == Pe2) & psd(Pe2) & (Pe2*NULL == Zero(2, 1))
      & (T(closed(Pe2))*NULL == THREE_HALVES*NULL),
      where=[*GROWING, *ROOTS], **IN_FIELD,
      note="B - PD has the eigenvalue 3/2, with (3, -2) from the left. That there is no third nonnegative equilibrium is not stated here.")

claim("D71-E3.266", "the modes of Example 3.4", modes(rational(1)), where=WALKING, by=[evaluation()])

claim("D71-X3.4", "the equilibrium of Example 3.4",
      (step(Pe2) == Pe2) & psd(Pe2) & (Pe2*NULL == Zero(2, 1)) & (T(Acl)*NULL == NULL) & (trace(Acl) < 2) & (trace(Acl) > 0),
      where=[*WALKING, *ROOTS, let(Acl, closed(Pe2))], **IN_FIELD,
      note="P_e2 of Example 3.3 again. B - PD has the eigenvalue 1, once, as its trace is not 2. That there is no other nonnegative equilibrium is not stated "
           "here.")

# --- Example 3.5 ------------------------------------------------------------------------------------------------------------

Lam, x, y11, y12, y21, y22 = symbols("Lam x y11 y12 y21 y22")
COORDINATES = [let(TT, rows([[2, -1], [3, 0]])), let(Lam, rows([[1, 1], [0, 1]])), let(Phi, TT*Lam*inv(TT)), let(M, rows([[-1, 1]])), let(V, rows([[1]]))]
ENTRIES = {x: scalar(), y11: scalar(), y12: scalar(), y21: scalar(), y22: scalar()}
ON_LINE = TT*rows([[x, 0], [0, 0]])*T(TT)
CARRIED = TT*rows([[y11, y12], [y21, y22]])*T(TT)

claim("D71-E3.271", "the computed covariance of the second case",
      Phi*(P - K*M*P)*T(Phi) == TT*rows([[x/(1 + x), 0], [0, 0]])*T(TT),
      over={x: scalar()}, where=[*COORDINATES, let(P, ON_LINE), let(K, gain())], by=[identity(), instances()])

claim("D71-E3.273", "the actual covariance of the second case",
      Phi*((Identity(2) - K*M)*CARRIED*T(Identity(2) - K*M) + K*T(K))*T(Phi)
      == TT*rows([[(y11 + y12 + y21 + y22 + x**2)/(1 + x)**2, (y12 + y22)/(1 + x)], [(y21 + y22)/(1 + x), y22]])*T(TT),
      over=ENTRIES, where=[*COORDINATES, let(P, ON_LINE), let(K, gain())], by=[identity(), instances()],
      note="V_a = 1 and H_a = 0.")

RUNS = [*COORDINATES, rec(P, k, TENTH, Phi*(P[k] - gain(P[k])*M*P[k])*T(Phi)),
        rec(Pa, k, Identity(2), Phi*((Identity(2) - gain(P[k])*M)*Pa[k]*T(Identity(2) - gain(P[k])*M) + gain(P[k])*T(gain(P[k])))*T(Phi))]
TIME = sym("TIME")


def curves(x):
    """P_k and P_a(t_k) at k = x, from ten and the squares up to x^2, the covariance of x_2 with c and the variance of x_2."""
    squares = 10 + x*(x + 1)*(2*x + 1)/6
    cov, var = (20 - x*(x + 1)/2)/(9*squares), (1300 - 20*x*(x + 1) + (x*(x + 1)/2)**2 + 9*(squares - 10))/(9*squares**2)
    return (TT*rows([[x**2, x], [x, 1]])*T(TT)/squares,
            TT*rows([[x**2*var + 2*x*cov + rational("1/9"), x*var + cov], [x*var + cov, var]])*T(TT))


def limits(computed, actual):
    """Those of the traces, as k grows."""
    return (laurent(trace(curves(Z)[0]), 0) == computed) & (laurent(trace(curves(Z)[1]), 0) == actual)


claim("D71-F3.12", "the actual covariance in the first case", limits(0, 0), where=RUNS, by=[evaluation()],
      repair=repair("other", "P_k converges to 0, but P_a(t_k) to a matrix with the trace 13/36: the gain is blind to a direction in which P_0 vanishes and "
                             "P_a(t_0) does not",
                    always(k, (P[k] == curves(TIME[k])[0]) & (Pa[k] == curves(TIME[k])[1]) & limits(0, rational("13/36"))),
                    where=[*RUNS, rec(TIME, k, 0, TIME[k] + 1)], by=[induction(), instances(horizon=4)]),
      note="The covariances are rational functions of k, as the repair says for all k, and their limits are those of these functions of z. The limit of P_a(t_k) "
           "is [[4, 6], [6, 9]]/36.")
