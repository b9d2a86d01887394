# SPDX-License-Identifier: MIT
"""The inverse of an adjoint Jordan block is similar to a Jordan block (Theorem 8.2), for a block of any size.

With mu the eigenvalue of the adjoint block mu I + N', put
x_ij = (-1)^{j-1} C(j-1, m-i) mu^{m+j-i-1}. Row i of the adjoint block adds row i - 1, column
j of I/mu + N adds column j - 1, and what has to vanish is Pascal's rule: X = (mu I + N')X(I/mu + N).
X is zero above its second diagonal, so that it is nonsingular.
"""

from exactkf.evidence import Evidence, generic_index, lemma, use
from exactkf.language import Expr, Identity, T, det, function, let, matrix_of, prod, rec, symbols, when
from proofs.d71.notation import i, j, jordan_block, k, superdiagonal

__all__ = ["PASCAL", "POWERS", "TurnedBlock", "choose", "mu", "turning"]

mu, choose, a_, b_, row, column, t_, Xr, pw, sg = symbols("mu choose a_ b_ row column t Xr pw sg")
#: choose(b, a) is a over b
PASCAL = function(choose, [b_, a_], when(b_ == 0, 1, when((b_ < 0) | (b_ > a_), 0, choose(b_ - 1, a_ - 1) + choose(b_, a_ - 1))))
#: the powers of mu and of -1
POWERS = [rec(pw, t_, 1, mu*pw[t_]), rec(sg, t_, 1, -sg[t_])]


def turning(size: Expr | int, lower: Expr | int) -> Expr:
    """The matrix (8.3) with the lower index of its binomial."""
    return matrix_of(i, j, size, size, when(j > size - i, sg[j - 1]*choose(lower, j - 1)*pw[size + j - i - 1], 0))


class TurnedBlock:
    """What is said of the matrix X of (8.3), with its binomial put right, for blocks of size m.

    ``where`` defines X; ``carries`` is its equation. ``diagonal`` is the determinant of X_r, which is X with its columns in reverse
    order (``reverse`` defines it), and ``regular`` that of the adjoint block; ``by`` shows all of them.
    """

    def __init__(self, m: Expr, X: Expr) -> None:
        self.adjoint, self.turned = mu*Identity(m) + T(superdiagonal(m)), jordan_block(1/mu, m)
        self.where = [PASCAL, *POWERS, let(X, turning(m, m - i))]
        self.reverse = let(Xr, matrix_of(i, j, m, m, X[i, m + 1 - j]))
        self.carries = X == self.adjoint*X*self.turned
        self.diagonal = det(T(Xr)) == prod(k, 1, m, sg[m - k]*pw[m - k + (m - k)])
        self.regular = det(T(self.adjoint)) == prod(k, 1, m, mu)
        self.by = _pascals_rule(m)


def _pascals_rule(m: Expr) -> Evidence:
    """Powers one after the other, a over a, and Pascal's rule where column j - 1 and row i meet."""
    return generic_index(
        lemma(t_, (pw[t_ + 1] == mu*pw[t_]) & (sg[t_ + 1] == -sg[t_]), direct=True),
        lemma(t_, choose(t_, t_) == 1, uses=[use(1, t=t_), use(choose, t_ + 1, t_ + 1), use(choose, t_ + 1, t_)]),
        closed=[choose], triangular=Identity(m),
        uses=[use(1, t=m - column), use(0, t=m + column - row - 1), use(0, t=m + column - row - 2), use(0, t=column - 2),
              use(choose, m - row + 1, column - 1), use(choose, column - 1, column - 2)])
