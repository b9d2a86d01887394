# SPDX-License-Identifier: MIT
"""Conjunctions shown member by member, and matrices given by their entries as letters: true ones are accepted, forged ones are not."""

from __future__ import annotations

import copy

import pytest

from exactkf._facts import facts_used
from exactkf._wording import proof_in_words
from exactkf.evidence import fact, generic_index, order, use
from exactkf.finders.prove import every_size
from exactkf.kernel.numbers import Unknown
from exactkf.kernel.reader import Reader
from exactkf.kernel.replay import seal
from exactkf.language import (
    Expr,
    Identity,
    Statement,
    T,
    Z,
    charpoly,
    column,
    given,
    inv,
    invertible,
    let,
    matrix,
    matrix_of,
    nonsingular,
    psd,
    standing,
    sum_of,
    sym,
    symbols,
    vector,
    when,
)
from tests.kernel.acceptance import is_accepted

A, B, J, X, alpha, h, i, j, n, m, t = symbols("A B J X alpha h i j n m t")
SHIFT = [let(J, matrix_of(i, j, n, n, when(j == i + 1, 1, 0))), let(h, column(i, n, when(i == 1, 1, 0)))]
MONIC = Z ** n + sum_of(i, 1, n, alpha[i] * Z ** (n - i))
GAMMA = J - alpha * T(h)
COMPANION = generic_index(fact(t, "charpoly", charpoly(GAMMA) == MONIC, (j, Z ** (n - j))), uses=[use(0, t=0, z=sym("z"))])
OVER = {A: matrix(n, n), B: matrix(n, n), X: nonsingular(n), alpha: vector(n)}
TURNED, SAME = inv(X) * GAMMA * X * inv(X) == inv(X) * GAMMA, charpoly(GAMMA) == MONIC


def statement(says: Expr, *hypotheses, where=SHIFT, **more) -> dict:
    return Statement(says, **{"sizes": ["n"], "over": OVER, "given": [standing("n >= 1", n >= 1), *hypotheses], "where": list(where), **more}).to_json()


def accepted(made: dict, evidence: dict, kind: str = "conjunction") -> bool:
    return is_accepted(seal("X", kind, made, evidence))


def found(says: Expr, *by, **more) -> list[dict]:
    """Certificates that the checker accepts."""
    made = statement(says, **more)
    return [c for c in every_size("X", made, list(by), 5.0) if accepted(made, c["evidence"], c["kind"])]


BOTH = statement(TURNED & SAME)
(PROOF,) = [c["evidence"] for c in found(TURNED & SAME, COMPANION) if c["kind"] == "conjunction"]


def test_each_member_in_its_own_way():
    """One about words, one about entries; in either order, and said in words."""
    assert [kind for kind, _ in PROOF["parts"]] == ["membership", "generic index"]
    assert any(c["kind"] == "conjunction" for c in found(SAME & TURNED, COMPANION))
    certificate = seal("X", "conjunction", BOTH, PROOF)
    assert facts_used(certificate) == [] and "expanded in words" in proof_in_words(certificate)
    (definite,) = found(psd(T(A) * A) & SAME & TURNED, COMPANION)
    assert facts_used(definite) == ["congruence"]


def test_members_are_proved_one_by_one():
    """A member missing, proved by what proves another, of an unknown kind, a conjunction again, or too many of them."""
    first, second = PROOF["parts"]
    instance = {"instances": [{"sizes": {"n": 0}, "values": {}}]}
    for parts in ([first], [second, first], [first, first], [first, second, second], [], [first, ["instances", instance]],
                  [first, ["conjunction", {"parts": [second]}]], [first, ["no kind", {}]], [first, ["evaluation", {"cases": [{"n": 0}]}]], [first, second[1]]):
        assert not accepted(BOTH, {"parts": parts})
    assert not accepted(BOTH, {}) and not accepted(statement(TURNED), {"parts": [first]}) and not accepted(statement(TURNED | SAME), PROOF)


@pytest.mark.parametrize("says", [
    TURNED & (charpoly(GAMMA) == MONIC + 1), TURNED & (charpoly(T(GAMMA) * GAMMA) == MONIC), (A * B == B * A) & SAME, (J * A == A * J) & SAME,
    (J == T(J)) & SAME, (J * J == J) & SAME, invertible(J) & SAME, (h == J * h) & SAME, psd(J) & SAME, (inv(J) * J == J) & SAME,
], ids=str)
def test_a_false_member(says):
    """No conjunction with one is proved, and the proof of the true one is none of it."""
    assert not found(says, COMPANION)
    assert not accepted(statement(says), PROOF)


def test_hypotheses_are_those_of_the_statement():
    """What one member says is no hypothesis of the other."""
    equal = given("equal", A == B)
    assert any(c["kind"] == "conjunction" for c in [x for x in every_size("X", statement((A * J == B * J) & SAME, equal), [COMPANION], 5.0)])
    assert not found((A == B) & (A * J == B * J) & SAME, COMPANION)


# ---------------------------------------------------------------------- matrices given by their entries
def test_a_letter_of_its_own():
    """It has the sizes of the definition, no symmetry, and no other matrix is taken for it."""
    reader = Reader(statement(SAME, where=[*SHIFT, let(B_ := sym("K"), matrix_of(i, j, n, n + 1, when(j == i + 1, 1, 0)))]))
    first, again, tall, other = (reader.read(x.tree) for x in (J, J, h, B_))
    assert first == again and reader.transpose(first) != first
    assert (tall.rows, tall.cols) == (((("n", 1),),), ((("", 1),),))
    assert (other.rows, other.cols) == (((("n", 1),),), ((("", 1), ("n", 1)),))
    with pytest.raises(Unknown):
        Reader(statement(SAME, where=[let(J, matrix_of(i, j, n * n, n, 1)), SHIFT[1]])).read(J.tree)


def test_what_is_said_of_every_matrix():
    """Identities of matrices given by their entries; nothing that rests on these."""
    own = {"where": SHIFT, "over": {A: matrix(n, n)}}
    assert found(T(J * A) == T(A) * T(J), order(), **own) and found(psd(T(J) * J), order(), **own)
    assert not found(T(J) * J == Identity(n), order(), **own) and not found(T(h) * h == Identity(1), order(), **own)


def test_an_inverse_in_an_entry():
    """A letter whose entries have inverses is none that a proof may bring in by itself."""
    inverted = let(J, matrix_of(i, j, n, n, inv(A)[i, j]))
    made = statement(A == A, where=[inverted])
    part = {"sum": [], "blocks": [[]]}
    lemma = ["=", list(J.tree), list(J.tree)]
    assert not accepted(made, {"parts": [part, part], "lemmas": [lemma]}, "order")
    assert accepted(made, {"parts": [part], "lemmas": []}, "order")


def test_a_certificate_with_another_statement():
    """The parts belong to the statement that they are sealed with."""
    changed = copy.deepcopy(BOTH)
    changed["where"][0][3] = list(changed["where"][0][3][:5]) + [1]  # all entries one
    assert accepted(BOTH, PROOF) and not accepted(changed, PROOF)
