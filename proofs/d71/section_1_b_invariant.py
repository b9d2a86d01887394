# SPDX-License-Identifier: MIT
"""Controllability and observability of time-invariant systems (Chapter I, section B).

The inputs of n instants add to the state what lies in the range of G, Phi G, ...,
Phi^{n-1}G, and those of more instants no more. A state is brought to zero if Phi^n times it
lies there; for a nonsingular Phi the state itself does then, and else it need not: what Phi
maps to zero goes to zero without any input.

The outputs M Phi^k x tell apart two states whose difference is not orthogonal to M', Phi'M',
..., (Phi')^{n-1}M', and no others. In continuous time the derivatives of the output are
M A^k x, and those of the response to an impulse A^k G.
"""

from exactkf.claims import claim, not_checked, repair
from exactkf.evidence import example, identity, induction, instances
from exactkf.language import (
    T,
    Zero,
    always,
    charpoly,
    coeff,
    forall,
    function,
    hstack,
    iff,
    let,
    matrix,
    nonsingular,
    positive_semidefinite,
    rank,
    rec,
    sequence_of,
    signal_of,
    sum_of,
    symbols,
    vector,
    when,
)
from proofs.d71.notation import M, N, Phi, j, k, n, p
from proofs.d71.section_1_b import G, I, Psi, Zn, q, x, xi

A, Pw, Rd, Wd, Sum, Range, Moved, FIRST, ORTHOGONAL = symbols("A Pw Rd Wd Sum Range Moved FIRST ORTHOGONAL")
INPUTS = [rec(Pw, k, I, Phi*Pw[k]), rec(Rd, k, Zn, Rd[k] + Pw[k]*G*T(G)*T(Pw[k]))]


def within_range(column):
    """The column lies in the range of G, Phi G, ..., Phi^{n-1}G."""
    return rank(hstack(Range, column)) == rank(Range)


INPUTS += [let(Range, Rd[n]), let(Moved, Pw[n]*x)]
CONTROLLED = iff(within_range(Moved), within_range(x))
EDGES = (example(n=1, q=1, Phi=[[1]], G=[[0]], x=[1]), example(n=2, q=1, Phi=[[1, 1], [0, 2]], G=[[1], [0]], x=[1, 1]),
         example(n=2, q=1, Phi=[[1, 1], [0, 2]], G=[[1], [0]], x=[3, 0]), example(n=2, q=1, Phi=[[1, 1], [0, 2]], G=[[1], [1]], x=[1, 0]),
         example(n=2, q=1, Phi=[[0, 1], [1, 0]], G=[[1], [0]], x=[1, 1]),
         example(n=3, q=1, Phi=[[0, 1, 0], [0, 0, 1], [1, 0, 0]], G=[[1], [0], [0]], x=[1, 2, 1]))

claim("D71-E1.46", "states that can be brought to zero",
      CONTROLLED, sizes=["n", "q"], over={Phi: matrix(n, n), G: matrix(n, q), x: vector(n)}, where=INPUTS,
      by=[example(n=1, q=1, Phi=[[0]], G=[[0]], x=[1]), instances(n=(1, 2), q=(1,))],
      repair=repair("missing hypothesis", "Phi is to be nonsingular, which is assumed from Chapter III on; what a singular Phi maps to zero is controllable "
                                          "without any input",
                    CONTROLLED, sizes=["n", "q"], over={Phi: nonsingular(n), G: matrix(n, q), x: vector(n)}, where=INPUTS,
                    by=[*EDGES, instances(8, n=(1, 2, 3), q=(1, 2)), instances(6, n=(2, 3), q=(1,), made_by={G: x})]),
      note="The range of R_d, the sum of the Phi^i GG'(Phi')^i for i < n, is that of Q_d. Inputs bring x to zero exactly if Phi^n x lies there: more than n "
           "instants help no further. The printed statement is about any time-invariant system; processes that come from sampling do have a nonsingular "
           "Phi. In the counterexample Phi = G = 0: every state is zero one instant later, and Q_d has rank 0.")

claim("D71-E1.47", "a state from its outputs in discrete time",
      always(k, Wd[k]*xi == Sum[k]), sizes=["n", "p"], over={Phi: signal_of(matrix(n, n), 0), M: signal_of(matrix(p, n), 0), xi: vector(n)},
      where=[rec(Psi, k, I, Phi[k]*Psi[k]), rec(x, k, xi, Phi[k]*x[k]), rec(Wd, k, Zn, Wd[k] + T(Psi[k])*T(M[k])*M[k]*Psi[k]),
             rec(Sum, k, Zero(n, 1), Sum[k] + T(Psi[k])*T(M[k])*(M[k]*x[k]))],
      by=[induction(also=[x[k] == Psi[k]*xi]), instances(6, n=(1, 2), p=(1, 2), horizon=2)],
      note="Psi_k is Phi(t_k, t_0), and the right side is computed from the outputs y_i = M_ix_i. If W_d(t_k) > 0, it gives x_0 = xi.")



def silent(last):
    """No output at the instants 0 .. last."""
    return forall(k, 0, last, M*Pw[k]*x == Zero(p, 1))


QUIET = [let(FIRST, silent(n - 1)), let(ORTHOGONAL, Wd[n]*x == Zero(n, 1))]
SEEN = [rec(Pw, k, I, Phi*Pw[k]), rec(Wd, k, Zn, Wd[k] + T(Pw[k])*T(M)*M*Pw[k]), *QUIET]
UNSEEN = (example(n=1, p=1, Phi=[[0]], M=[[1]], x=[1]), example(n=2, p=1, Phi=[[1, 1], [0, 1]], M=[[0, 1]], x=[1, 0]),
          example(n=2, p=1, Phi=[[1, 1], [0, 1]], M=[[1, 0]], x=[0, 1]), example(n=2, p=1, Phi=[[2, 0], [0, 3]], M=[[1, 0]], x=[0, 1]),
          example(n=3, p=1, Phi=[[1, 1, 0], [0, 1, 1], [0, 0, 1]], M=[[1, 0, 0]], x=[0, 0, 1]),
          example(n=3, p=1, Phi=[[1, 1, 0], [0, 1, 1], [0, 0, 1]], M=[[0, 1, 0]], x=[1, 0, 0]), example(n=2, p=1, Phi=[[0, 1], [0, 0]], M=[[1, 0]], x=[0, 1]))

claim("D71-E1.48", "what the outputs say in discrete time",
      iff(FIRST, ORTHOGONAL) & always(k, M*Pw[k + n]*x == -sum_of(j, 0, n - 1, coeff(charpoly(Phi), j)*(M*Pw[k + j]*x))),
      sizes=["n", "p"], over={Phi: matrix(n, n), M: matrix(p, n), x: vector(n)}, where=SEEN,
      by=[*UNSEEN, instances(6, n=(1, 2), p=(1, 2))],
      note="x is the difference of two initial states. W_d(t_n), the sum of the (Phi')^k M'M Phi^k for k < n, has the range of P_d; x is orthogonal to it, "
           "so that the states have the same projection, exactly if they give the same outputs at the first n instants (FIRST). By the second part each "
           "later output is a combination of the n before it.")


def renamed(examples, old, new):
    """The same examples with another name for the matrix of the system."""
    return [example({new if key == old else key: value for key, value in e.hints["values"].items()}) for e in examples]


CONTINUOUS = [rec(Pw, k, I, A*Pw[k]), rec(Wd, k, Zn, Wd[k] + T(Pw[k])*T(M)*M*Pw[k]), *QUIET]
claim("D71-E1.41", "what the output says in continuous time",
      iff(FIRST, ORTHOGONAL) & always(k, M*Pw[k + n]*x == -sum_of(j, 0, n - 1, coeff(charpoly(A), j)*(M*Pw[k + j]*x))),
      sizes=["n", "p"], over={A: matrix(n, n), M: matrix(p, n), x: vector(n)}, where=CONTINUOUS,
      by=[*renamed(UNSEEN, "Phi", "A"), instances(6, n=(1, 2), p=(1, 2))],
      note="As D71-E1.48: MA^k x is the k-th derivative of the output at the start, and these derivatives determine the output.")

claim("D71-E1.37", "states that can be brought to zero in continuous time",
      iff(FIRST, ORTHOGONAL) & always(k, T(x)*Pw[k + n]*G == -sum_of(j, 0, n - 1, coeff(charpoly(A), j)*(T(x)*Pw[k + j]*G))),
      sizes=["n", "q"], over={A: matrix(n, n), G: matrix(n, q), x: vector(n)},
      where=[rec(Pw, k, I, A*Pw[k]), rec(Rd, k, Zn, Rd[k] + Pw[k]*G*T(G)*T(Pw[k])),
             let(FIRST, forall(k, 0, n - 1, T(x)*Pw[k]*G == Zero(1, q))),
             let(ORTHOGONAL, T(x)*Rd[n] == Zero(1, n))],
      by=[example(n=1, q=1, A=[[0]], G=[[1]], x=[1]), example(n=2, q=1, A=[[1, 0], [1, 1]], G=[[0], [1]], x=[1, 0]),
          example(n=2, q=1, A=[[1, 0], [1, 1]], G=[[1], [0]], x=[0, 1]), example(n=2, q=1, A=[[0, 0], [1, 0]], G=[[1], [0]], x=[0, 1]),
          example(n=3, q=1, A=[[1, 0, 0], [1, 1, 0], [0, 1, 1]], G=[[1], [0], [0]], x=[0, 0, 1]),
          example(n=3, q=1, A=[[1, 0, 0], [1, 1, 0], [0, 1, 1]], G=[[0], [1], [0]], x=[1, 0, 0]), instances(6, n=(1, 2), q=(1, 2))],
      note="The states that inputs bring to zero in a time t are the range of the Gramian of the Phi(-s)G, s < t. A vector x is orthogonal to it exactly if "
           "x'A^kG = 0 for every k, which are the derivatives of x'Phi(s)G at 0; that is, exactly if it is orthogonal to Q_c.")

INTEGRAL = "an integral of the transition matrix of a system that changes with time, which is no exact object; D71-{} is the same in discrete time"
not_checked("D71-E1.35", "a Gramian for controllability in continuous time", INTEGRAL.format("E1.44"))
not_checked("D71-E1.39", "a Gramian for observability in continuous time", INTEGRAL.format("E1.47"))
not_checked("D71-E1.49", "completely driven processes in continuous time", "a definition: it fixes notation and asserts nothing")

Tr, a, b, i, Hs, Cov = symbols("Tr a b i Hs Cov")
DUE = sum_of(i, 0, N - 1, Tr(N, i + 1)*Hs[i]*T(Tr(N, i + 1)))
claim("D71-E1.50", "completely driven processes in discrete time",
      DUE == Cov[N], sizes=["n", "N"], over={Phi: sequence_of(matrix(n, n), 0, N - 1), Hs: sequence_of(positive_semidefinite(n), 0, N - 1)},
      where=[function(Tr, [a, b], when(a == b, I, Phi[a - 1]*Tr(a - 1, b))), rec(Cov, k, Zn, Phi[k]*Cov[k]*T(Phi[k]) + Hs[k])],
      by=[identity(n=1, N=range(1, 5)), identity(n=2, N=(1, 2)), instances(6, n=(1, 2), N=(1, 2, 3))], tex={Hs: "H"},
      note="The definition that the sum is positive definite asserts nothing; that the sum is the covariance of what the inputs add to the state is checked.")
