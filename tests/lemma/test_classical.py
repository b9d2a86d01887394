# SPDX-License-Identifier: MIT
"""Classical facts on semidefinite matrices, as lemmas: true ones proved with the facts named, false neighbours of them not."""

from __future__ import annotations

import copy
from fractions import Fraction

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from exactkf import prove_lemma
from exactkf._facts import facts_used
from exactkf.finders.simplex import combination, vanishing
from exactkf.kernel.order import FACTS
from exactkf.kernel.replay import Rejected, replay, seal
from exactkf.lemma.classical import by_classical_facts
from exactkf.lemma.grammar import read_lemma

PD = "sizes n\nmatrix P, Q n n pd\n"
PSD = "sizes n\nmatrix P, Q n n psd\nmatrix x n 1\n"
SYM = "sizes n\nmatrix A, B, C n n symmetric\n"
BLOCKS = "sizes n m\nmatrix A n n pd\nmatrix B n m\nmatrix C m m symmetric\n"
STEP = "sizes n p\nmatrix A n n\nmatrix C p n\nmatrix Q, P, S n n psd\nmatrix R p p pd\n"
RICCATI = "A*{0}*A' + Q - A*{0}*C'*(C*{0}*C' + R)^-1*C*{0}*A'"

PROVED = {
    "the inverse reverses order": (PD + "assume P >= Q\nclaim inv(Q) >= inv(P)", {"sum", "congruence"}),
    "and strict order": (PD + "assume P > Q\nclaim inv(Q) > inv(P)", {"sum", "congruence", "nonsingular"}),
    "and back": (PD + "claim P >= Q <=> inv(Q) >= inv(P)", {"sum", "congruence"}),
    "Schur complement to blocks": (BLOCKS + "assume C - B'*inv(A)*B >= 0\nclaim [A, B; B', C] >= 0", {"congruence", "block diagonal"}),
    "blocks to Schur complement": (BLOCKS + "assume [A, B; B', C] >= 0\nclaim C - B'*inv(A)*B >= 0", {"congruence"}),
    "definite Schur complement to blocks": (BLOCKS + "assume C > B'*inv(A)*B\nclaim [A, B; B', C] > 0", {"congruence", "block diagonal", "null space"}),
    "definite blocks to Schur complement": (BLOCKS + "assume [A, B; B', C] > 0\nclaim C > B'*inv(A)*B", {"congruence", "null space"}),
    "the other Schur complement": (
        BLOCKS.replace("C m m symmetric", "C m m pd") + "assume A >= B*inv(C)*B'\nclaim C >= B'*inv(A)*B", {"sum", "congruence"}),
    "definite blocks are invertible": (BLOCKS + "assume C > B'*inv(A)*B\nclaim [A, B; B', C] invertible", {"congruence", "right inverse"}),
    "order is transitive": (SYM + "assume A >= B\nassume B >= C\nclaim A >= C", {"hypothesis", "sum"}),
    "strict order too": (SYM + "assume A > B\nassume B >= C\nclaim A > C", {"hypothesis", "sum"}),
    "orders add": (SYM + "scalar a positive\nassume A >= B\nassume B >= C\nclaim a*A + 2*B >= a*B + 2*C", {"number", "sum"}),
    "order is antisymmetric": (SYM + "assume A >= B\nassume B >= A\nclaim A == B", {"sum", "null vectors"}),
    "congruence keeps order": ("sizes n p\nmatrix P, Q n n symmetric\nmatrix F p n\nassume P >= Q\nclaim F*P*F' >= F*Q*F'", {"congruence"}),
    "I + PQ": (PSD + "claim I + P*Q invertible", {"sum", "null vectors", "null space"}),
    "its null vectors": (PSD + "assume (I + P*Q)*x == 0\nclaim x == 0", {"sum", "null vectors"}),
    "its inverse in a claim": (PSD + "claim P*inv(I + Q*P) >= 0", {"sum", "congruence", "null space"}),
    "x'Px": (PSD + "assume x'*P*x == 0\nclaim P*x == 0", {"null vectors"}),
    "x'(P + Q)x": (PSD + "assume x'*(P + Q)*x == 0\nclaim P*x == 0", {"sum", "null vectors"}),
    "x'Px for a definite P": (PD + "matrix x n 1\nassume x'*P*x == 0\nclaim x == 0", {"null vectors", "nonsingular"}),
    "X'PX": ("sizes n k\nmatrix P n n psd\nmatrix X n k\nclaim X'*P*X == 0 <=> P*X == 0", {"null vectors"}),
    "A'A": ("sizes n m\nmatrix A, B m n\nassume A'*A + B'*B == 0\nclaim B == 0", {"sum", "congruence", "null vectors"}),
    "a smaller matrix has more null vectors": (PSD + "assume P >= Q\nassume P*x == 0\nclaim Q*x == 0", {"sum", "null vectors"}),
    "a zero on the diagonal": ("sizes n m\nmatrix B n m\nmatrix C m m symmetric\nassume [0, B; B', C] psd\nclaim B == 0", {"null vectors"}),
    "an orthogonal projection": ("sizes n\nmatrix P n n symmetric\nassume P*P == P\nclaim I >= P and P >= 0", {"congruence"}),
    "arithmetic and geometric mean": ("sizes n\nmatrix P n n pd\nclaim P + inv(P) >= 2*I", {"congruence"}),
    "arithmetic and harmonic mean": (PD + "claim P + Q >= 4*inv(inv(P) + inv(Q))", {"congruence", "inverse"}),
    "the best linear unbiased estimator": (
        "sizes n p\nmatrix H n p\nmatrix V n n pd\nmatrix L p n\n"
        "assume H'*inv(V)*H invertible\nassume L*H == I\nclaim L*V*L' >= inv(H'*inv(V)*H)", {"congruence"}),
    "the best feedback": (
        "sizes n m\nmatrix A n n psd\nmatrix B n m\nmatrix R m m pd\nmatrix K m n\n"
        "claim (I - B*K)'*A*(I - B*K) + K'*R*K >= A - A*B*inv(R + B'*A*B)*B'*A", {"congruence"}),
    "a positive semidefinite Gram matrix": ("sizes n m k\nmatrix A n k\nmatrix B m k\nclaim [A*A', A*B'; B*A', B*B'] >= 0", {"congruence"}),
    "a full step of the Riccati equation is monotone": (
        STEP + "assume P >= S\nclaim " + RICCATI.format("P") + " >= " + RICCATI.format("S"), {"sum", "congruence"}),
    "a full step is semidefinite": (STEP + "claim " + RICCATI.format("P") + " >= 0", {"sum", "congruence"}),
    "a smoothed covariance is semidefinite": (
        "sizes n\nmatrix P n n pd\nmatrix F n n\nmatrix Q n n pd\nmatrix Ps n n psd\nlet M = F*P*F' + Q\nlet G = P*F'*M^-1\nclaim P + G*(Ps - M)*G' >= 0",
        {"sum", "congruence"}),
    "a completed square": ("sizes n\nmatrix P n n pd\nmatrix x, y n 1\nclaim x'*P*x + y'*P^-1*y >= x'*y + y'*x", {"congruence"}),
    "trace and identity": (PSD + "claim P <= trace(P)*I", {"trace"}),
    "solutions of the Riccati equation keep their order": (
        STEP + "let X[0] = P + S\nlet X[t+1] = " + RICCATI.format("X[t]") + "\nlet Y[0] = P\nlet Y[t+1] = " + RICCATI.format("Y[t]")
        + "\nclaim for all t: X[t] >= Y[t]", {"sum", "congruence"}),
    "and stay semidefinite": (STEP + "let X[0] = P\nlet X[t+1] = " + RICCATI.format("X[t]") + "\nclaim for all t: X[t] >= 0", {"sum", "congruence"}),
    "solutions of the Lyapunov equation": (
        PSD + "matrix A n n\nassume P >= Q\nlet X[0] = O(n, n)\nlet X[t+1] = A*X[t]*A' + P\nlet Y[0] = O(n, n)\nlet Y[t+1] = A*Y[t]*A' + Q\n"
        "claim for all t: X[t] >= Y[t]", {"sum", "congruence"}),
    "the determinant of blocks": (
        "sizes n m\nmatrix A n n invertible\nmatrix B n m\nmatrix C m n\nmatrix D m m\n"
        "claim det([A, B; C, D]) == det(A)*det(D - C*inv(A)*B)", {"determinant"}),
    "the same by the other block": (
        "sizes n m\nmatrix D m m pd\nmatrix B n m\nmatrix A n n\nlet M = [A, B; B', D]\nclaim det(M) == det(D)*det(A - B*inv(D)*B')", {"determinant"}),
    "Sylvester's determinants": ("sizes n m\nmatrix B n m\nmatrix C m n\nclaim det(I(n) - B*C) == det(I(m) - C*B)", {"determinant"}),
    "the determinant of an update": (
        "sizes n\nmatrix A n n invertible\nmatrix u, v n 1\nclaim det(A + u*v') == det(A)*(1 + v'*inv(A)*u)", {"determinant"}),
    "a step of the Riccati equation is monotone": (
        "sizes n p\nmatrix P, Q n n psd\nmatrix M p n\nmatrix R p p pd\nassume P >= Q\n"
        "claim P - P*M'*inv(M*P*M' + R)*M*P >= Q - Q*M'*inv(M*Q*M' + R)*M*Q", {"sum", "congruence"}),
    "and in information form": (
        "sizes n p\nmatrix P, Q n n pd\nmatrix M p n\nmatrix R p p pd\nassume P >= Q\n"
        "claim inv(inv(P) + M'*inv(R)*M) >= inv(inv(Q) + M'*inv(R)*M)", {"sum", "congruence", "inverse"}),
    "a covariance falls by an observation": (PSD + "claim P >= P*inv(I + Q*P)", {"sum", "congruence", "null space"}),
    "from the left": (PSD + "claim P >= inv(I + P*Q)*P and inv(I + P*Q)*P >= 0", {"sum", "congruence"}),
    "with Q = M'M": ("sizes n p\nmatrix P n n psd\nmatrix M p n\nclaim P >= P*inv(I + M'*M*P) and P*inv(I + M'*M*P) >= 0", {"sum", "congruence"}),
    "strictly for definite ones": (PD + "claim P > P*inv(I + Q*P)", {"congruence", "nonsingular"}),
    "not by more than PQP": (PSD + "claim P*inv(I + Q*P) >= P - P*Q*P", {"sum", "congruence"}),
    "and so carried on": (PSD + "matrix F n n\nclaim F*P*F' + Q >= F*P*inv(I + Q*P)*F'", {"sum", "congruence"}),
    "the update with the best gain": (
        "sizes n p\nmatrix P n n psd\nmatrix M p n\nmatrix V p p psd\nlet S = M*P*M' + V\nlet K = P*M'*inv(S)\nassume S invertible\n"
        "claim P - K*M*P >= 0 and P >= P - K*M*P", {"sum", "congruence"}),
    "no other gain does better": (
        "sizes n p\nmatrix P n n psd\nmatrix M p n\nmatrix V p p pd\nmatrix L n p\nlet K = P*M'*inv(M*P*M' + V)\n"
        "claim (I - L*M)*P*(I - L*M)' + L*V*L' >= P - K*M*P", {"congruence"}),
}

NOT = {
    "the inverse keeps order": PD + "assume P >= Q\nclaim inv(P) >= inv(Q)",
    "strict from not strict": PD + "assume P >= Q\nclaim inv(Q) > inv(P)",
    "a semidefinite Schur complement makes definite blocks": BLOCKS + "assume C - B'*inv(A)*B >= 0\nclaim [A, B; B', C] > 0",
    "semidefinite diagonal blocks are enough": BLOCKS + "assume C >= 0\nclaim [A, B; B', C] >= 0",
    "both below one": SYM + "assume A >= B\nassume C >= B\nclaim A >= C",
    "strict from two that are not": SYM + "assume A >= B\nassume B >= C\nclaim A > C",
    "one order is an equation": SYM + "assume A >= B\nclaim A == B",
    "I + PQ with an indefinite Q": PSD.replace("P, Q n n psd", "P n n psd\nmatrix Q n n symmetric") + "claim I + P*Q invertible",
    "x'Px with an indefinite P": PSD.replace("psd", "symmetric") + "assume x'*P*x == 0\nclaim P*x == 0",
    "a difference": PSD + "assume x'*(P - Q)*x == 0\nclaim P*x == 0",
    "null vectors of the smaller": PSD + "assume P >= Q\nassume Q*x == 0\nclaim P*x == 0",
    "a corner is definite": "sizes n m\nmatrix A n n symmetric\nmatrix B n m\nmatrix C m m symmetric\nassume [A, B; B', C] >= 0\nclaim A > 0",
    "congruence keeps strict order": "sizes n p\nmatrix P, Q n n symmetric\nmatrix F p n\nassume P > Q\nclaim F*P*F' > F*Q*F'",
    "a sum that vanishes": SYM + "assume A + B == 0\nclaim A == 0",
    "a covariance falls strictly": PSD + "claim P > P*inv(I + Q*P)",
    "it does not grow": PSD + "claim P*inv(I + Q*P) >= P",
    "by more than PQP": PSD + "claim P - P*Q*P >= P*inv(I + Q*P)",
    "the wrong side": PSD + "claim P >= inv(I + Q*P)*P",
    "Q need not be semidefinite": PSD.replace("P, Q n n psd", "P n n psd\nmatrix Q n n symmetric") + "assume (I + Q*P) invertible\nclaim P >= P*inv(I + Q*P)",
    "too large a multiple of the harmonic mean": PD + "claim P + Q >= 5*inv(inv(P) + inv(Q))",
    "an estimator that is biased": "sizes n p\nmatrix H n p\nmatrix V n n pd\nmatrix L p n\nassume H'*inv(V)*H invertible\nclaim L*V*L' >= inv(H'*inv(V)*H)",
    "no number says that it is positive": SYM + "scalar a\nassume A >= B\nclaim a*A >= a*B",
}


@pytest.mark.parametrize("name", PROVED)
def test_classical_facts_are_proved(name):
    """Proved for every size, with certificates that replay and facts that are named."""
    text, facts = PROVED[name]
    outcome = prove_lemma(text, time_limit=90.0, mutants=False)
    assert ("proved", "") == (outcome.verdict, outcome.reason)
    for certificate in outcome.certificates:
        replay(certificate)
    assert facts <= set(outcome.to_json()["facts"])
    assert set(outcome.to_json()["facts"]) <= set(FACTS)


@pytest.mark.parametrize("name", NOT)
def test_false_neighbours_are_not_proved(name):
    """Nothing that is proposed for a false statement is accepted, and its matrices are found."""
    statement = read_lemma(NOT[name]).to_json()
    for evidence in by_classical_facts(statement, 8, 5.0):
        with pytest.raises(Rejected):
            replay(seal("false", "order", statement, evidence))
    assert "refuted" == prove_lemma(NOT[name], time_limit=20.0, mutants=False).verdict


def test_a_proof_of_a_true_lemma_is_none_of_its_false_neighbour():
    """The evidence for one direction is refused for the other, and without the assumption."""
    statement = read_lemma(PROVED["the inverse reverses order"][0]).to_json()
    (evidence,) = by_classical_facts(statement, 8, 5.0)
    replay(seal("true", "order", statement, evidence))
    turned = copy.deepcopy(statement)
    turned["says"][1:] = reversed(turned["says"][1:])
    for false in (turned, {**statement, "given": []}):
        with pytest.raises(Rejected):
            replay(seal("false", "order", false, evidence))


def test_every_fact_is_a_sentence_with_a_name():
    """The list has one sentence for each name, and the lemma prints those it uses."""
    assert all(name and sentence and not sentence.endswith(".") for name, sentence in FACTS.items())
    printed = str(prove_lemma(PROVED["I + PQ"][0], mutants=False))
    assert f"null space: {FACTS['null space']}" in printed
    assert "square root" not in printed


def test_facts_of_equations_alone_are_none():
    """A membership uses no fact about order."""
    (certificate,) = prove_lemma("sizes n\nmatrix A n n\nassume 2*A == 0\nclaim A == 0", mutants=False).certificates
    assert [] == facts_used(certificate)


def test_primes_that_a_proof_divides_by_are_said():
    """A cofactor 1/2 or 1/6 is a proof over Z[1/2] or Z[1/2, 1/3], and said to be; one over the integers is not."""
    for number, ring in (("2", "over Z[1/2]"), ("6", "over Z[1/2, 1/3]")):
        outcome = prove_lemma(f"sizes n\nmatrix A n n\nassume {number}*A == 0\nclaim A == 0", mutants=False)
        assert "proved" == outcome.verdict
        assert any(line.endswith(ring) for line in outcome.reached)
    outcome = prove_lemma("sizes n\nmatrix A n n\nassume A == 0\nclaim 2*A == 0", mutants=False)
    assert not any("Z[" in line for line in outcome.reached)


@pytest.mark.parametrize("text", [
    PSD + "assume (P + Q)*x == 0\nclaim P*x == 0", PSD + "assume x'*P*x == 0\nclaim P*x == 0",
    "sizes n\nmatrix A, B n n\nassume A*B == I\nassume B*A == I\nclaim A*B*A == A"])
def test_equal_rewritings_are_no_warning(text):
    """A multiple of the goal, or its transpose, is the same claim; nothing is said of it."""
    outcome = prove_lemma(text, time_limit=30.0)
    assert "proved" == outcome.verdict
    assert [] == [line for line in outcome.warnings if "changed lemma" in line]


def test_another_claim_is_still_a_warning():
    """What is no multiple of the claim, and holds as well, is still named."""
    outcome = prove_lemma("sizes n\nmatrix A n n\nassume idle: A == A'\nclaim (A*A)' == A'*A'", time_limit=30.0)
    assert any("also holds without assumption 'idle'" in line for line in outcome.warnings)


WEAK = "sizes n\nmatrix A, B n n\nassume A*A*B == B*A*A\nassume A^3 == I\nclaim A*B == B*A"


def test_the_bound_that_was_reached_is_named():
    """The degree, where longer words would have been looked at; no bound, where there were none; the time, where it ran out."""
    reason = prove_lemma(WEAK, degree=3, mutants=False).reason
    assert reason.startswith("the degree bound was reached") and "--degree" in reason and "--time-limit" not in reason
    reason = prove_lemma("sizes n m\nmatrix A n m\nmatrix B m n\nclaim rank(A*A') == rank(A)", mutants=False).reason
    assert "neither the degree nor the time limit was reached" in reason and "larger" not in reason
    reason = prove_lemma(WEAK.replace("A*A*B == B*A*A", "A*A*B*B*A == B*A*B"), degree=40, time_limit=0.4, mutants=False).reason
    assert reason.startswith("the time limit was reached") and "--time-limit" in reason


@given(st.lists(st.lists(st.integers(-3, 3), min_size=4, max_size=4), min_size=1, max_size=7), st.lists(st.integers(0, 3), min_size=7, max_size=7))
def test_nonnegative_combinations(table, factors):
    """A target that is a nonnegative combination is found to be one; what is found adds up, with positive coefficients."""
    columns = [{n: v for n, v in enumerate(row) if v} for row in table]
    total = [sum(c * row[n] for c, row in zip(factors, table, strict=False)) for n in range(4)]
    target = {n: v for n, v in enumerate(total) if v}
    found = combination(columns, target)
    assert found is not None
    assert _sum(columns, found) == target
    for null in vanishing(columns):
        assert null and _sum(columns, null) == {}
    for k in range(len(columns)):
        with_it = combination(columns, target, [k])
        assert with_it is None or (k in with_it and _sum(columns, with_it) == target)


def _sum(columns, coefficients):
    assert all(c > 0 for c in coefficients.values())
    out = {}
    for k, c in coefficients.items():
        for key, v in columns[k].items():
            out[key] = out.get(key, 0) + Fraction(int(fmpq(c).p), int(fmpq(c).q)) * v
    return {key: v for key, v in out.items() if v}


def test_no_combination_where_a_functional_says_so():
    """A target on the other side of a half plane with all columns is none."""
    assert combination([{"a": 1}, {"a": 1, "b": 1}], {"a": -1}) is None
    assert combination([{"a": 1}, {"a": 2}], {"b": 1}) is None
    assert [] == list(vanishing([{"a": 1, "b": -1}, {"b": 1}]))


def test_an_order_with_a_number_on_the_right():
    """A product of two forms is compared with one: what is not proved is said to be open."""
    text = "sizes n\nmatrix P n n pd\nmatrix x n 1\nassume x'*x == 1\nclaim x'*inv(P)*x*(x'*P*x) >= 1"
    assert "open" == prove_lemma(text, time_limit=5.0, mutants=False).verdict
