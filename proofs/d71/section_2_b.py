# SPDX-License-Identifier: MIT
"""Regular processes in continuous time (Chapter II, section B).

A mode of dx/dt = Ax + h is driven if no eigenvector of A' at its eigenvalue is a null vector
of H (Appendix C): the vectors that count are those which a functional of the state sees, the
eigenvectors from the left. If the columns of E are eigenvectors of A, those of the inverse of
E' are eigenvectors of A'.
"""

from exactkf.claims import claim, repair
from exactkf.evidence import example, instances
from exactkf.language import (
    Identity,
    T,
    Zero,
    forall,
    given,
    iff,
    inv,
    invertible,
    let,
    matrix_of,
    nonsingular,
    positive_semidefinite,
    rec,
    symbols,
    vector,
    when,
)
from proofs.d71.notation import H, i, j, k, n

A, E, lam, Rd, Rc, Pw, a, b = symbols("A E lam Rd Rc Pw a b")
DIAGONAL = matrix_of(i, j, n, n, when(i == j, lam[i], 0))


def unit(at):
    """The unit vector e_at."""
    return matrix_of(a, b, n, 1, when(a == at, 1, 0))


SETTING = {E: nonsingular(n), lam: vector(n), H: positive_semidefinite(n)}
UNSTABLE = [given("different eigenvalues", forall(i, 1, n - 1, forall(j, i + 1, n, lam[i] != lam[j])))]
NON_NEGATIVE = given("all of them unstable or random walk", forall(i, 1, n, lam[i] >= 0))
WHERE = [let(A, E*DIAGONAL*inv(E)), rec(Pw, k, Identity(n), A*Pw[k]), rec(Rd, k, Zero(n, n), Rd[k] + Pw[k]*H*T(Pw[k])), let(Rc, Rd[n])]
DRIVEN = invertible(Rc)
#: columns (1, 0) and (1, 1): (1, 0) is driven, but not seen by the functional (0, 1)
LEANING = example(n=2, E=[[1, 1], [0, 1]], lam=[1, 2], H=[[1, 0], [0, 0]])

claim("D71-S12", "regular processes and undriven modes",
      iff(forall(j, 1, n, H*(E*unit(j)) != Zero(n, 1)), DRIVEN),
      sizes=["n"], over=SETTING, where=WHERE, given=[*UNSTABLE, NON_NEGATIVE],
      by=[LEANING, instances(n=(1, 2))],
      repair=repair(
          "other", "part (b) is to ask it of the eigenvectors of A', as Appendix C does; those of A may be driven while a mode is not",
          iff(forall(j, 1, n, H*(inv(T(E))*unit(j)) != Zero(n, 1)), DRIVEN),
          sizes=["n"], over=SETTING, where=WHERE, given=UNSTABLE,
          by=[LEANING, example(n=2, E=[[1, 0], [0, 1]], lam=[1, 1], H=[[1, 1], [1, 1]]), example(n=2, E=[[1, 0], [0, 1]], lam=[1, 2], H=[[0, 0], [0, 1]]),
              example(n=2, E=[[1, 0], [1, 1]], lam=[3, 2], H=[[0, 0], [0, 1]]), instances(8, n=(1, 2, 3))]),
      note="For a process with n different real eigenvalues, all unstable or zero; the columns of E are the eigenvectors of A, those of the inverse of E' the "
           "eigenvectors of A'. All modes are driven exactly if H, AH, ..., A^{n-1}H span the space, that is if the sum R_c of the A^k H A'^k is nonsingular. "
           "In the counterexample the eigenvectors (1, 0) and (1, 1) of A are no null vectors of H = diag(1, 0), but (0, 1) is one and an eigenvector of A' "
           "at 2.")
