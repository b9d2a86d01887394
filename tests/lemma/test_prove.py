# SPDX-License-Identifier: MIT
"""Lemmas of one's own: the true ones proved, the false ones refuted, and everything else open with its reason."""

from __future__ import annotations

import copy
import json
import subprocess
import sys
from pathlib import Path

import pytest

from exactkf import BadInput, prove_lemma
from exactkf.kernel.instances import admissible, read_instance
from exactkf.kernel.meaning import World
from exactkf.kernel.replay import Rejected, replay
from exactkf.language import Identity, Statement, T, inv, matrix, nonsingular, positive_definite, positive_semidefinite, psd, standing, symbols

UPDATE = "sizes n p\nmatrix P n n symmetric\nmatrix M p n\nmatrix V p p symmetric\nlet S = M*P*M' + V\nlet K = P*M'*S^-1\n"
POSITIVE = UPDATE.replace("P n n symmetric", "P n n psd").replace("V p p symmetric", "V p p pd")
RICCATI = ("sizes n p\nmatrix P, Q n n psd\nmatrix F n n\nmatrix M p n\nmatrix V p p pd\nlet K = F*P*M'*inv(M*P*M' + V)\n"
           "assume are: P == F*P*F' - K*(M*P*M' + V)*K' + Q\n")
PENROSE = "sizes n m\nmatrix A n m\nmatrix X, Y m n\n" + "".join(
    f"assume A*{z}*A == A\nassume {z}*A*{z} == {z}\nassume A*{z} symmetric\nassume {z}*A symmetric\n" for z in "XY")

PROVED = {
    "Joseph form": (UPDATE + "assume S invertible\nclaim (I - K*M)*P*(I - K*M)' + K*V*K' == P - K*M*P", {"membership"}),
    "its inverse exists by order": (POSITIVE + "claim (I - K*M)*P*(I - K*M)' + K*V*K' == P - K*M*P", {"membership", "order"}),
    "an order through a claim on the way": (POSITIVE + "claim P - K*M*P == (I - K*M)*P*(I - K*M)' + K*V*K'\nclaim P - K*M*P >= 0", {"order"}),
    "an order by the form of its update": (POSITIVE + "claim P - K*M*P >= 0", {"order"}),
    "the order of an update": (POSITIVE + "claim P >= K*M*P", {"order"}),
    "an update for noise of covariance I": ("sizes n p\nmatrix P n n psd\nmatrix M p n\nclaim P - P*M'*inv(M*P*M' + I)*M*P >= 0", {"order"}),
    "an update of a definite matrix": (
        POSITIVE.replace("P n n psd", "P n n pd") + "let D = K*M*P\nlet Z = P - D\nclaim Z > 0", {"order"}),
    "push-through, the other inverse shown": (
        "sizes n m\nmatrix P n m\nmatrix Q m n\nassume I + P*Q invertible\nclaim inv(I + P*Q)*P == P*inv(I + Q*P)", {"membership", "order"}),
    "Woodbury, its left side shown to exist": (
        "sizes n m\nmatrix A n n invertible\nmatrix C m m invertible\nmatrix U n m\nmatrix W m n\nassume inv(C) + W*inv(A)*U invertible\n"
        "claim inv(A + U*C*W) == inv(A) - inv(A)*U*inv(inv(C) + W*inv(A)*U)*W*inv(A)", {"membership", "order"}),
    "Schur complement in blocks": (
        "sizes n m\nmatrix A n n invertible\nmatrix B n m\nmatrix C m n\nmatrix D m m\n"
        "claim [A, B; C, D] == [I, 0; C*inv(A), I]*[A, 0; 0, D - C*inv(A)*B]*[I, inv(A)*B; 0, I]", {"membership"}),
    "inverse of a symplectic matrix": (
        "sizes n\nmatrix A, B, C, D n n\nassume [A, B; C, D] symplectic\nclaim [A, B; C, D]*[D', -B'; -C', A'] == I(2*n)", {"membership"}),
    "reflexive inverse": ("sizes n m\nmatrix A n m\nmatrix X m n\nassume A*X*A == A\nlet Z = X*A*X\nclaim A*Z*A == A\nclaim Z*A*Z == Z", {"membership"}),
    "Moore-Penrose inverse": (PENROSE + "claim X == Y", {"membership"}),
    "null vector of a sum": ("sizes n k\nmatrix P, Q n n psd\nmatrix x n k\nassume (P + Q)*x == 0\nclaim P*x == 0", {"order"}),
    "Riccati equation as a Lyapunov equation": (RICCATI + "claim P == (F - K*M)*P*(F - K*M)' + K*V*K' + Q", {"membership"}),
    "a recursion stays semidefinite": (
        "sizes n\nmatrix F n n\nmatrix P, Q n n psd\nlet X[0] = P\nlet X[t+1] = F*X[t]*F' + Q\nclaim for all t: X[t] >= 0", {"word induction"}),
    "an implication grants its inverse": ("sizes n\nmatrix A n n\nclaim A invertible => inv(A)*A == I", {"order"}),
    "a matrix with fewer rows than a size": ("sizes n\nmatrix A n-2 n-2 invertible\nclaim A*inv(A) == I", {"membership"}),
    "numbers alone": ("scalar a, b\nclaim (a + b)^2 == a^2 + 2*a*b + b^2", {"identity"}),
}

REFUTED = {
    "commuting": "sizes n\nmatrix A, B n n\nclaim A*B == B*A",
    "a sign": UPDATE + "assume S invertible\nclaim (I - K*M)*P*(I - K*M)' - K*V*K' == P - K*M*P",
    "left inverse of a tall matrix": "sizes n m\nmatrix A n m\nmatrix L m n\nassume L*A == I\nclaim L*A*L == L\nclaim A*L == I",
    "squares keep no order": "sizes n\nmatrix A, B n n pd\nassume A >= B\nclaim A*A >= B*B",
    "projections are symmetric": "sizes n\nmatrix P n n\nassume P*P == P\nclaim P symmetric",
    "orthogonal matrices commute": "sizes n\nmatrix U, V n n\nassume U'*U == I\nassume V'*V == I\nclaim U*V == V*U",
    "reflexive inverses are unique": "sizes n m\nmatrix A n m\nmatrix X, Y m n\nassume A*X*A == A\nassume X*A*X == X\n"
                                     "assume A*Y*A == A\nassume Y*A*Y == Y\nclaim X == Y",
    "nilpotent matrices vanish": "sizes n\nmatrix N n n\nassume N*N*N == 0\nclaim N*N == 0",
    "a term of the Riccati equation dropped": RICCATI + "claim P == (F - K*M)*P*(F - K*M)' + Q",
    "symplectic matrices are symmetric in blocks": "sizes n\nmatrix A, B, C, D n n\nassume [A, B; C, D] symplectic\nclaim A*D' == I",
    "intertwined matrices are equal": "sizes n\nmatrix R, J, K n n\nassume R invertible\nassume R*J == K*R\nclaim J == K",
    "sizes that begin above three": "sizes n\nmatrix A n-4 n\nclaim A*A' == 0",
    "sizes without matrices": "sizes n\nclaim det(2*I(n)) == 2",
    "a recursion stands still": "sizes n\nmatrix F, P, Q n n\nlet X[0] = P\nlet X[t+1] = F*X[t]*F' + Q\nclaim for all t: X[t] == P",
}

OPEN = {
    "contradictory": ("sizes n\nmatrix A n n invertible\nassume square: A*A == 0\nassume more: A == A'\nclaim A == I", ["contradictory", "'square'", "n = 0"]),
    "vacuous": ("sizes n\nmatrix A, B n n pd\nassume fine: A >= B\nassume opposite: A == -B\nclaim A == I",
                ["vacuous", "'opposite' together with those before"]),
    "vacuous premise": ("sizes n\nmatrix A n n\nclaim A'*A == -I => A == 0", ["vacuous", "premise"]),
    "inverse not granted": (UPDATE + "claim (I - K*M)*P*(I - K*M)' + K*V*K' == P - K*M*P",
                            ["proved only where S^-1 exists", "no assumption grants", "need not exist", "add 'assume S invertible'"]),
    "quotient not granted": ("sizes n\nmatrix A n n\nscalar a\nclaim A/a == (1/a)*A", ["proved only where a^-1 exists", "no assumption grants"]),
    "inverse that never exists": ("sizes n\nmatrix N n n\nassume N == 0\nclaim inv(N) == N", ["no value", "on none of"]),
    "outside of words": ("sizes n m\nmatrix A n m\nmatrix B m n\nclaim rank(A*A') == rank(A)", ["no counterexample"]),
}


def settle(text: str, **how):
    return prove_lemma(text, time_limit=20.0, mutants=False, **how)


@pytest.mark.parametrize("name", PROVED)
def test_true_lemmas_are_proved_for_every_size(name):
    """Proved, with certificates that replay and are about the lemma and its inverses."""
    text, kinds = PROVED[name]
    outcome = settle(text)
    assert ("proved", "") == (outcome.verdict, outcome.reason)
    assert kinds == {c["kind"] for c in outcome.certificates}
    statement = outcome.statement.to_json()
    for certificate in outcome.certificates:
        replay(certificate)
        assert {k: v for k, v in statement.items() if k != "says"} == {k: v for k, v in certificate["statement"].items() if k != "says"}


@pytest.mark.parametrize("name", REFUTED)
def test_false_lemmas_are_refuted_by_matrices(name):
    """Refuted by an instance that satisfies every assumption and violates the claim, also by an evaluation of its own."""
    outcome = settle(REFUTED[name])
    assert "refuted" == outcome.verdict
    (certificate,) = outcome.certificates
    replay(certificate)
    statement = outcome.statement.to_json()
    assert statement == certificate["statement"]
    world = World(statement, read_instance(statement, outcome.counterexample))
    assert ("", False) == (admissible(statement, world), world.value(statement["says"]))


@pytest.mark.parametrize("name", OPEN)
def test_everything_else_is_open_with_its_reason(name):
    """Contradictory or vacuous assumptions, inverses that nothing grants, and what is out of reach never read as proved."""
    text, words = OPEN[name]
    outcome = settle(text)
    assert "open" == outcome.verdict
    assert "\n" not in outcome.reason
    for word in words:
        assert word in outcome.reason
    for certificate in outcome.certificates:
        replay(certificate)


def test_an_inverse_that_need_not_exist_comes_with_matrices():
    """Where an inverse is not granted and may fail to exist, matrices that show it are among the certificates."""
    outcome = settle(OPEN["inverse not granted"][0])
    shown = next(c for c in outcome.certificates if c["kind"] == "counterexample")
    assert ["invertible", ["sym", "S"]] == shown["statement"]["says"]
    assert any("S is singular" in line for line in outcome.reached)


def test_a_degree_bound_is_said():
    """A claim that needs longer words than allowed is open, and the bound is named; with longer words it is proved."""
    text = "sizes n\nmatrix A, B n n\nassume A*A*B == B*A*A\nassume A^3 == I\nclaim A*B == B*A"
    outcome = settle(text, degree=3)
    assert "open" == outcome.verdict
    assert "up to 3 letters" in outcome.reason and "degree" in outcome.reason
    assert "proved" == settle(text).verdict


def test_claims_are_told_apart():
    """Of several claims those that are proved are named, and those that are not."""
    outcome = settle("sizes n m\nmatrix A n m\nmatrix B m n\nclaim (A*B)' == B'*A'\nclaim rank(A*A') == rank(A)")
    assert "open" == outcome.verdict
    assert any(line.startswith("(A*B)' = B'*A': without assumptions, expanded") for line in outcome.reached)
    assert any(line.startswith("rank(A*A') = rank(A): neither") and "'rank'" in line for line in outcome.reached)


def test_a_changed_lemma_that_holds_too_is_a_warning():
    """An assumption that is not needed, and a changed claim that no instance refutes, are warnings; the lemma stays proved."""
    outcome = prove_lemma("sizes n\nmatrix A n n\nassume idle: A == A'\nclaim (A*A)' == A'*A'")
    assert "proved" == outcome.verdict
    assert any("also holds without assumption 'idle'" in line for line in outcome.warnings)
    assert [] == prove_lemma("sizes n\nmatrix A n n\nassume A*A == 0\nclaim (I + A)*(I - A) == I").warnings


def test_same_seed_same_matrices():
    """The search is reproducible."""
    text = REFUTED["projections are symmetric"]
    assert settle(text, seed=3).counterexample == settle(text, seed=3).counterexample


def test_a_lemma_from_python():
    """A Statement, or its parts; 0 takes the size that fits."""
    n, P, Q, x = symbols("n P Q x")
    parts = {"sizes": [n], "over": {P: positive_semidefinite(n), Q: positive_definite(n), x: matrix(n, 1)}, "given": {"null": (P + Q) * x == 0}}
    outcome = prove_lemma(**parts, says=P * x == 0)
    assert "proved" == outcome.verdict
    assert ("O", ("sym", "n"), 1) == outcome.statement.says[2]
    A = symbols("A")[0]
    lemma = Statement(sizes=["n"], over={"A": nonsingular(n)}, says=psd(T(A) * A) & (inv(A) * A == Identity(n)))
    assert "proved" == prove_lemma(lemma).verdict


def test_the_lemma_of_the_readme():
    """The worked file is proved, and read as text or from its path alike."""
    file = Path(__file__).with_name("joseph.lemma")
    outcome = prove_lemma(file)
    assert "proved" == outcome.verdict
    assert outcome.statement == prove_lemma(file.read_text()).statement
    assert ["innovation", "S^-1 exists by assumption 'innovation'"] == outcome.assuming


def test_an_outcome_is_plain_json():
    """Text, LaTeX, verdict and certificates, for other programs."""
    data = json.loads(json.dumps(settle(PROVED["Joseph form"][0]).to_json()))
    assert "proved" == data["verdict"]
    assert data["text"].startswith("sizes n p\n") and "I_{n}" in data["says_latex"]
    replay(data["certificates"][0])


def test_certificates_replay_with_the_standard_library_alone(tmp_path):
    """The checker on its own, with no package of others, accepts what a lemma leaves, and refuses what was changed."""
    for name in ("Woodbury, its left side shown to exist", "a recursion stays semidefinite"):
        for k, certificate in enumerate(settle(PROVED[name][0]).certificates):
            (tmp_path / f"{len(name)}-{k}.json").write_text(json.dumps(certificate))
    certificate = settle(REFUTED["commuting"]).certificates[0]
    (tmp_path / "refuted.json").write_text(json.dumps(certificate))
    program = (f"import json, sys; sys.path.insert(0, {str(Path(__file__).parents[2])!r}); from exactkf.kernel.replay import replay; "
               f"files = {sorted(map(str, tmp_path.iterdir()))!r}; [replay(json.load(open(f))) for f in files]; print('accepted', len(files))")
    done = subprocess.run([sys.executable, "-I", "-S", "-c", program], capture_output=True, text=True, check=False)
    assert ("accepted 4\n", "") == (done.stdout, done.stderr)
    altered = copy.deepcopy(certificate)
    altered["statement"]["says"] = ["=", ["sym", "A"], ["sym", "A"]]
    with pytest.raises(Rejected, match="altered"):
        replay(altered)


@pytest.mark.parametrize(("call", "words"), [
    ({}, ["'says'", "claims nothing"]),
    ({"lemma": 3}, ["'lemma' = 3", "Path"]),
    ({"lemma": "sizes n\nmatrix A n n\nclaim A == A", "sizes": ["n"]}, ["'sizes'", "one or the other"]),
    ({"lemma": "claim 1 == 1", "time_limit": 0}, ["'time_limit' = 0", "above 0"]),
    ({"lemma": "claim 1 == 1", "time_limit": float("nan")}, ["'time_limit' = nan"]),
    ({"lemma": "claim 1 == 1", "degree": 0}, ["'degree' = 0", "1 or more"]),
    ({"lemma": Path("nowhere.lemma")}, ["'nowhere.lemma'", "cannot be read"]),
])
def test_wrong_calls(call, words):
    """One line that names the argument, its value and the remedy."""
    lemma = call.pop("lemma", None)
    with pytest.raises(BadInput) as caught:
        prove_lemma(lemma, **call)
    for word in words:
        assert word in str(caught.value)


def test_sizes_of_a_statement_are_checked():
    """From Python, too, a product that does not fit is named."""
    n, p, P, M = symbols("n p P M")
    with pytest.raises(BadInput, match=r"the product P\*M does not fit: P is n x n, M is p x n"):
        prove_lemma(sizes=[n, p], over={P: matrix(n, n), M: matrix(p, n)}, given=[standing("any", P == P)], says=M * P * M == M)
