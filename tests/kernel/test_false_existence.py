# SPDX-License-Identifier: MIT
"""Variables that a theorem gives: what a certificate of them has to show, and what is refused."""

from __future__ import annotations

import pytest

from exactkf.engine import verify_statement
from exactkf.evidence import chosen, instances, order, spectral, square
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.language import (
    Identity,
    Statement,
    T,
    diagonal,
    eq,
    given,
    inv,
    invertible,
    let,
    matrix,
    nonsingular,
    pd,
    positive_definite,
    psd,
    symbols,
    symmetric_matrix,
)

D, L, M, P, Q, S, U, X, Y, d, m = symbols("D L M P Q S U X Y d m")
OVER = {P: positive_definite(d), S: symmetric_matrix(d), X: matrix(d, d), L: nonsingular(d), U: matrix(d, d), D: diagonal(d)}
ORTHOGONAL, TURNED, ROOT = given("orthogonal", T(U) * U == Identity(d)), given("turned", S == U * D * T(U)), given("root", P == L * T(L))
TRUE = T(U) * S * U == D
BOTH = spectral(S, U, D)


def statement(*hypotheses, says=TRUE, **more) -> dict:
    return Statement(says, **{"sizes": ["d", "m"], "over": OVER, "given": list(hypotheses), **more}).to_json()


def exist(made: dict, *choices) -> bool:
    """The checker accepts that these variables exist."""
    hints = chosen(*choices).hints["choices"]
    data = [[theorem, _listed(term), list(names)] for theorem, term, names in hints]
    try:
        replay(seal("X", "existence", made, {"choices": data}))
    except Rejected:
        return False
    return True


def _listed(tree):
    return [_listed(x) for x in tree] if isinstance(tree, tuple) else tree


def test_what_exists():
    """Eigenvectors of a symmetric matrix, a root of a definite one, and one after the other."""
    assert exist(statement(ORTHOGONAL, TURNED), BOTH)
    assert exist(statement(ROOT), square(P, L))
    after = given("in these coordinates", inv(L) * S * T(inv(L)) == U * D * T(U))
    assert exist(statement(ROOT, ORTHOGONAL, after), square(P, L), spectral(inv(L) * S * T(inv(L)), U, D))
    assert not exist(statement(ROOT, ORTHOGONAL, after), spectral(inv(L) * S * T(inv(L)), U, D), square(P, L))  # L comes first
    assert exist(statement(ORTHOGONAL, TURNED, given("of others", psd(X))), BOTH)


@pytest.mark.parametrize("hypotheses", [
    (TURNED,), (ORTHOGONAL,), (), (ORTHOGONAL, TURNED, given("more", psd(D))), (ORTHOGONAL, TURNED, given("more", invertible(U))),
    (given("orthogonal", U * T(U) == Identity(d)), TURNED), (ORTHOGONAL, given("turned", S == T(U) * D * U)),
    (ORTHOGONAL, given("turned", U * D * T(U) == S)),
    (ORTHOGONAL, TURNED, given("fixed", U == X)), (ORTHOGONAL, TURNED, given("fixed", eq(D, S, X))),
    (ORTHOGONAL, TURNED, given("one of two", psd(D) | psd(X)))],
    ids=lambda some: ", ".join(str(g) for g in some)[:60])
def test_what_is_asked_is_what_the_theorem_gives(hypotheses):
    """Neither less nor more."""
    assert not exist(statement(*hypotheses), BOTH)


def test_a_matrix_that_is_not_symmetric():
    """Not by its form, nor because the equation itself would make it so."""
    assert not exist(statement(ORTHOGONAL, given("turned", X == U * D * T(U))), spectral(X, U, D))
    assert not exist(statement(ORTHOGONAL, given("turned", X == U * D * T(U)), given("X is symmetric, through D", X == D)), spectral(X, U, D))
    assert exist(statement(ORTHOGONAL, given("turned", X * T(X) == U * D * T(U))), spectral(X * T(X), U, D))


def test_a_matrix_that_is_not_definite():
    """A semidefinite or a symmetric matrix need not have a nonsingular root."""
    assert not exist(statement(given("root", S == L * T(L))), square(S, L))
    assert not exist(statement(given("root", X * T(X) == L * T(L))), square(X * T(X), L))
    assert not exist(statement(given("root", S == L * T(L)), given("through L", pd(L))), square(S, L))
    assert exist(statement(given("root", S == L * T(L)), given("S > 0", pd(S))), square(S, L))


def test_a_term_without_a_value():
    """An inverse that need not exist, in the term or in the conclusion."""
    turned = given("turned", X * inv(S) * T(X) == U * D * T(U))
    assert not exist(statement(ORTHOGONAL, turned, says=T(U) * U == Identity(d)), spectral(X * inv(S) * T(X), U, D))
    assert exist(statement(ORTHOGONAL, turned, given("S > 0", pd(S)), says=T(U) * U == Identity(d)), spectral(X * inv(S) * T(X), U, D))
    assert not exist(statement(ORTHOGONAL, TURNED, says=D * inv(D) == Identity(d)), BOTH)
    assert exist(statement(ORTHOGONAL, TURNED, says=invertible(D) & (D * inv(D) == Identity(d))), BOTH)
    assert not exist(statement(ORTHOGONAL, TURNED, says=(D * inv(D) == Identity(d)) & invertible(D)), BOTH)


@pytest.mark.parametrize("types", [
    {U: nonsingular(d)}, {U: symmetric_matrix(d)}, {D: matrix(d, d)}, {D: positive_definite(d)},
    {U: matrix(d, m)}, {D: diagonal(m)}, {U: matrix(m, m), D: diagonal(m)}])
def test_other_types(types):
    """A type that asks for more, or another size, is refused."""
    names = {**OVER, **types}
    assert not exist(statement(ORTHOGONAL, TURNED, over=names), BOTH)
    assert not exist(statement(ROOT, over={**OVER, L: positive_definite(d)}), square(P, L))


def test_hidden_dependence():
    """What is chosen may hide in a definition: in the term, and in another hypothesis."""
    hidden = [let(Y, S + U * T(U))]
    assert not exist(statement(ORTHOGONAL, given("turned", Y == U * D * T(U)), where=hidden), spectral(Y, U, D))
    assert not exist(statement(ORTHOGONAL, TURNED, given("more", psd(Y)), where=hidden), BOTH)
    assert exist(statement(ORTHOGONAL, TURNED, where=hidden), BOTH)


def test_choices_that_are_none():
    """No choice, a name twice, a name of nothing, an unknown theorem."""
    made = statement(ORTHOGONAL, TURNED)
    for choices in ([], [["spectral", ["sym", "S"], ["U", "U"]]], [["spectral", ["sym", "S"], ["U", "Z"]]], [["jordan", ["sym", "S"], ["U", "D"]]],
                    [["spectral", ["sym", "S"], ["U"]]], [["spectral", ["sym", "S"], ["U", "D"]]] * 2, [["spectral", ["sym", "S"], ["S", "D"]]]):
        with pytest.raises(Rejected):
            replay(seal("X", "existence", made, {"choices": choices}))


def test_what_a_claim_is_worth():
    """Proved with a certificate of existence, by steps without."""
    more = [order(), instances(d=(1, 2), using={M: matrix(d, d)}, made_by={U: (Identity(d) - (M - T(M))) * inv(Identity(d) + (M - T(M))), S: U * D * T(U)})]
    made = Statement(TRUE, sizes=["d"], over={S: symmetric_matrix(d), U: matrix(d, d), D: diagonal(d)}, given=[ORTHOGONAL, TURNED])
    found = [verify_statement(made, [*more, *claim])["strength"] for claim in ((), (chosen(BOTH),), (chosen(square(S, U)),))]
    assert found == ["proved", "proved", "steps"]
