# SPDX-License-Identifier: MIT
"""What the summary says of the results (Chapter IV).

The summary repeats the results without their conditions. A stable equilibrium needs more than
observable random walk and unstable modes: an undriven random walk has the slope one at its
equilibrium 0, and values below it leave. The variance of a random walk mode that is neither
driven nor measured is constant if its estimate is uncorrelated with all that is measured: if
P_0 n is a multiple of the vector v of the mode, then P_k n is. Otherwise what is learned
about the other modes lowers it. And "completely observable" is quoted with the range of P_d
where the definition has that nothing of the mode is orthogonal to it.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, induction, instances, order, part, steps
from exactkf.language import (
    Identity,
    T,
    Zero,
    always,
    block,
    given,
    hstack,
    iff,
    inv,
    let,
    matrix,
    matrix_of,
    nonneg,
    nonsingular,
    pd,
    positive_definite,
    positive_semidefinite,
    rank,
    rec,
    scalar,
    standing,
    symbols,
    symmetric_matrix,
    vector,
    vstack,
    when,
)
from proofs.d71 import section_3_c1 as one_state
from proofs.d71 import section_3_c4b_undriven as undriven
from proofs.d71.notation import H, K, M, P, Phi, V, gain, gram, i, j, k, n, p, step

q, E, c, S, A, B, C, D, Acl, Ha, Va, Pa, Pa0, Pae, Pi, X = symbols("q E c S A B C D Acl Ha Va Pa Pa0 Pae Pi X")
I, Zn = Identity(n), Zero(n, n)
PhiT = inv(T(Phi))

# --- the limit of the actual covariance ------------------------------------------------------------------------------------

COEFFICIENTS = [let(S, gram()), let(A, H*PhiT), let(B, H*PhiT*S + Phi), let(C, -PhiT), let(D, PhiT*S), let(K, gain()), let(Acl, B - P*D)]
SYSTEM = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p), P: positive_semidefinite(n),
          Ha: positive_semidefinite(n), Va: positive_semidefinite(p), Pa0: positive_semidefinite(n)}
NOISE = Phi*K*Va*T(K)*T(Phi) + Ha
RUN = [rec(Pi, k, I, Acl*Pi[k]), rec(Pa, k, Pa0, Acl*Pa[k]*T(Acl) + NOISE)]
REMAINDER = hstack(T(P), I)*block([[T(D)*B, T(D)*A], [-T(C)*B - I, -T(C)*A]])*vstack(P, I)
AROUND = always(k, Pa[k] - Pae == Pi[k]*(Pa0 - Pae)*T(Pi[k]))
EQUILIBRIUM = standing("P is an equilibrium", P == step())
ONE = {"n": 1, "p": 1, "Phi": [[1]], "H": [["1/2"]], "M": [[1]], "V": [[1]], "P": [[1]], "Ha": [["1/2"]], "Va": [[1]], "Pa0": [[1]]}

claim("D71-S69", "the equation cited for the limit of the actual covariance",
      AROUND, sizes=["n", "p"], over=SYSTEM, where=[*COEFFICIENTS, *RUN, let(Pae, REMAINDER)], given=[EQUILIBRIUM],
      by=[example(ONE), instances(n=(1,), p=(1,), horizon=2)],
      repair=repair("cross-reference", "P_ae is the solution of (3.246); (3.101) is the remainder R in the proof of Theorem 3.17",
                    AROUND, sizes=["n", "p"], over={**SYSTEM, Pae: symmetric_matrix(n)}, where=[*COEFFICIENTS, *RUN],
                    given=[EQUILIBRIUM, given("(3.246)", Pae - Acl*Pae*T(Acl) == NOISE)],
                    by=[part("P_k = P_e"), induction(), example({**ONE, "Pae": [[1]]}), example({**ONE, "Pae": [[0]]}),
                        instances(8, n=(1, 2), p=(1, 2), horizon=2, using={E: nonsingular(n), c: vector(n)},
                                  made_by={Phi: E*matrix_of(i, j, n, n, when(i == j, 1/(1 + c[i]**2), 0))*inv(E),
                                           M: matrix_of(i, j, p, n, when(i == j, 1, 0))*inv(E), V: Identity(p),
                                           P: E*matrix_of(i, j, n, n, when(i == j, c[i]**2, 0))*T(E), H: P - Phi*(P - gain()*M*P)*T(Phi),
                                           Ha: H, Va: V, Pae: P})]),
      note="Read as: the matrix of (3.101) is the limit, at which P_a stays. In the counterexample n = 1, P = 1 and H_a = H, V_a = V; R is 3 and P_ae is 1. "
           "The other parts of the item are Theorems 3.24 and 3.25.")

# --- stable equilibria -----------------------------------------------------------------------------------------------------

SLOPE_ONE = "a random walk mode that is observable but undriven has the slope one at its equilibrium; it is to be excluded, too"


def stable_equilibrium():
    """The repair for one state."""
    return repair("missing hypothesis", SLOPE_ONE, one_state.STABLE,
                  over={**one_state.ANY, one_state.r: nonneg()}, where=[one_state.GRAPH, let(one_state.e, one_state.upper)],
                  given=[one_state.EXISTS, given("not an undriven random walk", ~((one_state.h == 0) & (one_state.phi**2 == 1))), one_state.IS_ROOT],
                  by=[part("one state"),
                      steps("D71-E3.8", facts=["A differentiable map is stable at a fixed point where its slope is below one in absolute value."],
                            prose="The equilibria have product -hv/m^2 and the larger one has the smaller slope; the slopes multiply to one."),
                      example(phi=1, m=1, v=1, h=0, r=0), instances(made_by=one_state.FROM_Q, using={one_state.q: scalar()})])


ONE_STATE_NOTE = ("For one state: observable or stable are the processes without an unobservable random walk or unstable mode. The counterexample is phi = m "
                  "= v = 1, h = 0, where 0 is the only equilibrium and values below it leave; see D71-S26 for what stable means. The repair is for one state.")

for id_, title in (("D71-S15", "when there is a stable equilibrium"), ("D71-S75", "observable modes and a stable equilibrium")):
    claim(id_, title, one_state.STABLE,
          over={**one_state.ANY, one_state.r: nonneg()}, where=[one_state.GRAPH, let(one_state.e, one_state.upper)],
          given=[one_state.EXISTS, one_state.IS_ROOT],
          by=[example(phi=1, m=1, v=1, h=0, r=0), instances(made_by=one_state.FROM_Q, using={one_state.q: scalar()})],
          repair=stable_equilibrium(), note=ONE_STATE_NOTE)

claim("D71-S74", "the two equilibria beside an undriven unstable mode",
      pd(P),
      sizes=["n", "p"], over={**undriven.MODEL, undriven.u: vector(n), undriven.l: scalar()}, given=[undriven.EQUILIBRIUM, undriven.INSIDE, *undriven.UNDRIVEN],
      by=[undriven.BOTH, instances(n=(1,), p=(1,))], repair=undriven.only_stable_modes(),
      note=undriven.STABLE_NOTE + "The rest of the item, on what leads to each of the two, is not stated here.")

# --- the variance of a random walk mode ------------------------------------------------------------------------------------

nd, v, s, b, r, P0, Var = symbols("nd v s b r P0 Var")
MODE = {Phi: nonsingular(n), H: positive_semidefinite(n), M: matrix(p, n), V: positive_definite(p), P0: positive_semidefinite(n), nd: matrix(n, q),
        v: matrix(n, q), s: matrix(q, q)}
WALK = [given("undriven", (T(Phi)*nd == nd*T(s)) & (H*nd == Zero(n, q))), given("unobservable", (Phi*v == v*s) & (M*v == Zero(p, q)))]
SOLUTION = [rec(P, k, P0, step(P[k])), let(Var, T(nd)*P0*nd)]
CONSTANT = always(k, T(nd)*P[k]*nd == Var)
CORRELATED = {"n": 2, "p": 1, "Phi": [[1, 0], [0, "1/2"]], "H": [[0, 0], [0, 0]], "M": [[0, 1]], "V": [[1]], "P0": [[1, "1/2"], ["1/2", 1]],
              "q": 1, "nd": [[1], [0]], "v": [[1], [0]], "s": [[1]]}
PLAIN = {"n": 1, "p": 1, "Phi": [[1]], "H": [[0]], "M": [[0]], "V": [[1]], "P0": [[3]], "q": 1, "nd": [[1]], "v": [[1]], "s": [[1]], "b": [[3]]}
REST = n - 1

claim("D71-S72", "the variance of a random walk mode that is neither driven nor measured",
      CONSTANT, sizes=["n", "p", "q"], over=MODE, where=SOLUTION, given=[*WALK, given("random walk", s*T(s) == Identity(q))],
      by=[example(CORRELATED), instances(n=(1,), p=(1,), q=(1,), horizon=2)],
      repair=repair(
          "missing hypothesis", "the variance may fall if the estimate of the mode is correlated with what is measured; it is constant if P_0 n is a multiple of "
                                "the vector of the mode",
          always(k, T(nd)*P[k]*nd == Var), sizes=["n", "p", "q"], over={**MODE, b: matrix(q, q)}, where=SOLUTION,
          given=[*WALK, given("random walk", s*b*T(s) == b), given("uncorrelated", P0*nd == v*b)],
          by=[induction(also=[P[k]*nd == v*b]), example({**CORRELATED, "b": [[1]]}), example({**PLAIN, "Phi": [[2]], "s": [[2]]}), example({**PLAIN, "H": [[1]]}),
              example({**PLAIN, "M": [[1]]}),
              example({**PLAIN, "b": [[2]]}),
              instances(6, n=(2, 3), p=(1,), q=(1,), horizon=2, using={E: nonsingular(n), X: nonsingular(REST), c: matrix(1, REST), D: matrix(REST, REST), r: scalar()},
                        made_by={s: Identity(1), Phi: E*block([[Identity(1), Zero(1, REST)], [Zero(REST, 1), X]])*inv(E),
                                 nd: inv(T(E))*matrix_of(i, j, n, 1, when(i == 1, 1, 0)),
                                 v: E*matrix_of(i, j, n, 1, when(i == 1, 1, 0)), b: r**2*Identity(1), H: Zn, M: hstack(Zero(1, 1), c)*inv(E),
                                 P0: E*block([[r**2*Identity(1), Zero(1, REST)], [Zero(REST, 1), D*T(D)]])*T(E)})]),
      note="The variance of the mode is n*P_k n with Phi'n = s*n and |s| = 1. s and b stand on the right as matrices, so that they may be complex: numbers are "
           "2 x 2 matrices that commute, and s b s* = b says |s| = 1. In the counterexample the other mode, 1/2, is measured, and the first "
           "measurement lowers the variance from 1 to 7/8. That the equilibria form a continuum is not stated here.")

# --- the definition that is recalled --------------------------------------------------------------------------------------

Pd, Ti, N = symbols("Pd Ti N")
SEEN = {Pd: matrix(n, p), Ti: matrix(n, q)}
INDEPENDENT = standing("the columns of T_i are independent", rank(Ti) == q)
IN_RANGE = rank(hstack(Pd, Ti)) == rank(Pd)
OBSERVABLE = rank(T(Pd)*Ti) == q

claim("D71-S76", "completely observable modes, as recalled",
      iff(OBSERVABLE, IN_RANGE),
      sizes=["n", "p", "q"], over=SEEN, given=[INDEPENDENT],
      by=[example(n=2, p=1, q=1, Pd=[[1], [-1]], Ti=[[1], [0]]), instances(n=(1,), p=(1,), q=(1,))],
      repair=repair("other", "the definition of Chapter I is that no vector of the mode but 0 is in the null space of P_d'; a mode inside the range of P_d "
                             "has that property, but not the other way round",
                    OBSERVABLE, sizes=["n", "p", "q"], over={**SEEN, X: matrix(p, q)},
                    given=[given("the columns of T_i are independent", rank(Ti) == q), given("inside the range", Ti == Pd*X)],
                    by=[order([T(Ti)*Ti]), example(n=1, p=1, q=1, Pd=[[1]], Ti=[[0]], X=[[0]]),
                        example(n=2, p=1, q=1, Pd=[[1], [-1]], Ti=[[1], [1]], X=[[0]]),
                        instances(8, n=(2, 3), p=(2, 3), q=(1, 2), made_by={Ti: Pd*X})]),
      note="P_d is n x p here, with any p. The columns of T_i span the mode; it meets the null space of P_d' in 0 only exactly if P_d'T_i has independent "
           "columns. The counterexample is realized by Phi = [[1, 1], [0, 2]] and M = [1, -1]: the mode 2 with the vector (1, 1) is unobservable, P_d has the "
           "columns (1, -1) and (1, -1), and the mode 1, with the vector (1, 0), is observable.")
