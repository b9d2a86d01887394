# SPDX-License-Identifier: MIT
"""Instances found by solving equations satisfy them, and are not all trivial."""

from __future__ import annotations

import pytest
from flint import fmpq

from exactkf.finders.draw import Sampler
from exactkf.kernel.instances import admissible, read_instance
from exactkf.kernel.meaning import World
from exactkf.kernel.numbers import rationals
from exactkf.lemma import read_lemma

# assumptions, and a claim that trivial instances satisfy
CASES = {
    "projection": "sizes n\nmatrix P n n\nassume P*P == P\nclaim P == 0 or P == I",
    "orthogonal": "sizes n\nmatrix X n n\nassume X'*X == I\nclaim X == I or X == -I",
    "nilpotent": "sizes n\nmatrix N n n\nassume N^3 == 0\nclaim N == 0",
    "generalised inverse": "sizes n m\nmatrix A n m\nmatrix X m n\nassume A*X*A == A\nassume X*A*X == X\n"
                           "assume A*X symmetric\nassume X*A symmetric\nclaim A == 0",
    "symplectic blocks": "sizes n\nmatrix A, B, C, D n n\nassume A'*C == C'*A\nassume B'*D == D'*B\nassume A'*D - C'*B == I\nclaim B == 0 or C == 0",
    "Riccati equation": "sizes n p\nmatrix P, Q n n psd\nmatrix F n n\nmatrix M p n\nmatrix V p p pd\n"
                        "assume P == F*P*F' - F*P*M'*inv(M*P*M' + V)*M*P*F' + Q\nclaim M*P*F' == 0",
    "Sylvester equation": "sizes n m\nmatrix R m n\nmatrix T n n\nmatrix J m m\nassume R*T == J*R\nclaim R == 0",
    "commutator": "sizes n\nmatrix A, B n n\nassume A*B - B*A == A\nclaim A == 0",
    "order": "sizes n\nmatrix P, Q n n symmetric\nassume P >= Q\nassume Q >= 0\nclaim P == Q",
    "a premise": "sizes n\nmatrix A n n\nclaim A*A == I => A == I or A == -I",
    "alternatives": "sizes n\nmatrix A n n\nassume A*A == 0 or A*A == A\nclaim A == 0 or A == I",
    "numbers": "scalar a, b, c\nassume a*b == c^2\nassume a > b\nclaim a*b*c == 0",
}


@pytest.mark.parametrize("name", CASES)
def test_equations_are_solved(name):
    """Every instance that comes out satisfies the hypotheses, and some are not trivial."""
    statement = read_lemma(CASES[name]).to_json()
    sampler = Sampler(statement, {"sizes": {n: [1, 2] for n in statement["sizes"]}, "solving": 120}, [], 0)
    with rationals(fmpq):
        found = [(instance, world.value(statement["says"])) for instance, world in sampler.stream(120)]
    assert "" == "".join(admissible(statement, World(statement, read_instance(statement, instance))) for instance, _ in found)
    assert 5 <= len(found)
    assert any(trivial is False for _, trivial in found)


def test_what_cannot_be_met_gives_nothing():
    """No instance for equations without a rational solution."""
    statement = read_lemma("scalar a\nassume a^2 == 2\nclaim a == 0").to_json()
    sampler = Sampler(statement, {"sizes": {}, "solving": 60}, [], 0)
    assert [] == list(sampler.stream(60))
    assert sampler.rejected["the equations of the hypotheses were not solved"] == 60


def test_claims_profit_where_random_draws_miss():
    """Without a hint the sampler of the engine solves equations, too, and the draws of others stay as they were."""
    statement = read_lemma(CASES["projection"]).to_json()
    assert any(True for _ in Sampler(statement, {"sizes": {"n": [2]}}, [], 0).stream(40))
    free = read_lemma("sizes n\nmatrix A n n psd\nclaim A >= 0").to_json()
    plain = [i for i, _ in Sampler(free, {"sizes": {"n": [1, 2]}}, [], 5).stream(20)]
    assert plain == [i for i, _ in Sampler(free, {"sizes": {"n": [1, 2]}, "solving": 0}, [], 5).stream(20)]
