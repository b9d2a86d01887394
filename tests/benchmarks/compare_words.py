# SPDX-License-Identifier: MIT
"""The same claims, for every matrix size, in exactkf and in what one would use otherwise.

    python tests/benchmarks/compare_words.py [--write]

prints a table; ``--write`` puts it into COMPARISON.md beside this file. Every system gets the same
polynomials in noncommuting letters: what the claim says must vanish, and the assumptions with their
transposes, as `exactkf.kernel.reader` reads them from one statement.

- exactkf: membership with cofactors, and the checker's replay of the certificate;
- Singular, Letterplace (``freegb.lib``): two-sided standard basis up to a degree, normal form;
- Macaulay2 (``AssociativeAlgebras``): noncommutative Groebner basis up to a degree, normal form;
- sympy with ``commutative=False``: each assumption as a substitution for its leading word, ``expand`` until nothing changes.

A system that is not installed is left out. Times are wall clock for the question, without the start of the system
(which is measured on an empty question and subtracted). Answers: *proved* (it is zero under the assumptions),
*no* (a nonzero normal form remains: not proved up to that degree), *stuck* (substitution ended elsewhere), *time* (limit).
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # of a clone; it need not be installed

from exactkf.claims import load
from exactkf.finders.membership import find_membership
from exactkf.kernel.reader import Reader, relations, residual_blocks
from exactkf.kernel.replay import replay, seal
from exactkf.lemma import read_lemma

DEGREE = 8
LIMIT = 60.0  # seconds for one question to another system

UPDATE = "sizes n p\nmatrix P n n symmetric\nmatrix M p n\nmatrix V p p symmetric\nlet K = P*M'*inv(M*P*M' + V)\n"
TEXTS = {
    "D71 Joseph form of the update": UPDATE + "claim (I - K*M)*P*(I - K*M)' + K*V*K' == P - K*M*P",
    "the same with a wrong sign": UPDATE + "claim (I - K*M)*P*(I - K*M)' - K*V*K' == P - K*M*P",
    "NWL92 Woodbury's formula": "sizes n m\nmatrix A n n\nmatrix C m m\nmatrix U n m\nmatrix W m n\n"
                                "claim inv(A + U*C*W) == inv(A) - inv(A)*U*inv(inv(C) + W*inv(A)*U)*W*inv(A)",
    "NWL92 Schur complement, inverse": "sizes n m\nmatrix A n n\nmatrix B n m\nmatrix C m n\nmatrix D m m\nlet S = D - C*inv(A)*B\n"
        "claim [A, B; C, D]*[inv(A) + inv(A)*B*inv(S)*C*inv(A), -inv(A)*B*inv(S); -inv(S)*C*inv(A), inv(S)] == I(n + m)",
    "BLZ94 inverse of a symplectic matrix": "sizes n\nmatrix A, B, C, D n n\nassume [A, B; C, D] symplectic\n"
        "claim [A, B; C, D]*[D', -B'; -C', A'] == I(2*n)",
    "Duffin: (1)-inverses give reflexive ones": "sizes n m\nmatrix A n m\nmatrix X, Y m n\nassume A*X*A == A\nassume A*Y*A == A\nlet Z = X*A*Y\n"
        "claim A*Z*A == A and Z*A*Z == Z",
    "uniqueness of the Moore-Penrose inverse": "sizes n m\nmatrix A n m\nmatrix X, Y m n\n" + "".join(
        f"assume A*{z}*A == A\nassume {z}*A*{z} == {z}\nassume A*{z} symmetric\nassume {z}*A symmetric\n" for z in "XY") + "claim X == Y",
}
LEDGER = ("B93-E8", "B93-E13", "B93-E17", "D71-E1.28e", "D71-E3.48")


@dataclass
class Question:
    """Polynomials as {word: coefficient}, words as tuples of numbers of letters."""

    title: str
    statement: dict
    letters: int
    assumed: list[dict]
    goals: list[dict]


def questions() -> list[Question]:
    claims = load()
    found = [(f"{id} {claims[id].title}", (claims[id].repair or claims[id]).statement) for id in LEDGER]
    return [_question(title, s.to_json()) for title, s in [*found, *((title, read_lemma(text)) for title, text in TEXTS.items())]]


def _question(title: str, statement: dict) -> Question:
    reader = Reader(statement)
    goals = [p for b in residual_blocks(reader, statement["says"]) for p, _, _ in b.cells()]
    assumed = [relation.poly for relation in relations(reader).values()]
    number: dict[str, int] = {}
    for p in (*goals, *assumed):
        for _, word in p:
            for letter in word:
                number.setdefault(letter, len(number))

    def plain(p: dict) -> dict:
        return {tuple(number[a] for a in w): c for (_, w), c in p.items()}

    return Question(title, statement, len(number), [plain(p) for p in assumed if p], [plain(p) for p in goals if p])


def _text(p: dict, one: str = "1", times: str = "*") -> str:
    def term(word: tuple, c: object) -> str:
        return f"({c})" + times + (times.join(f"x{k}" for k in word) or one)

    return " + ".join(term(w, c) for w, c in p.items())


def _run(command: list[str], source: str, suffix: str) -> tuple[str, float]:
    """Output and seconds; 'time' if the limit was reached."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / f"question{suffix}"
        file.write_text(source)
        started = time.perf_counter()
        try:
            done = subprocess.run([*command, str(file)], capture_output=True, text=True, timeout=LIMIT, stdin=subprocess.DEVNULL, check=False)
        except subprocess.TimeoutExpired:
            return "time", LIMIT
        return done.stdout + done.stderr, time.perf_counter() - started


def _answer(output: str, count: int) -> str:
    if output == "time":
        return "time"
    forms = [line.partition(":")[2].strip() for line in output.splitlines() if line.startswith("NF:")]
    if len(forms) != count or "error" in output:
        raise SystemExit(f"a system did not answer:\n{output}")
    return "proved" if all(form == "0" for form in forms) else "no"


# ---------------------------------------------------------------------- the systems
def exactkf_(q: Question) -> tuple[str, float]:
    started = time.perf_counter()
    terms = find_membership(q.statement, DEGREE, LIMIT)
    if terms is not None:
        replay(seal("comparison", "membership", q.statement, {"terms": terms}))
    return "no" if terms is None else "proved", time.perf_counter() - started


def _bound(q: Question) -> int:
    return max(DEGREE, *(len(w) + 1 for p in (*q.goals, *q.assumed) for w in p))


def singular(q: Question) -> tuple[str, float]:
    names = ",".join(f"x{k}" for k in range(q.letters))
    lines = ['LIB "freegb.lib";', f"ring r = 0,({names}),dp;", f"def R = freeAlgebra(r, {_bound(q)});", "setring R;", "option(redSB); option(redTail);",
             f"ideal I = {', '.join(map(_text, q.assumed)) or '0'};", "ideal J = twostd(I);", "poly f;"]
    lines += [f'f = {_text(p)}; print("NF:" + string(reduce(f, J)));' for p in q.goals]
    output, seconds = _run(["Singular", "-q", "--no-rc"], "\n".join([*lines, "quit;"]), ".sing")
    return _answer(output, len(q.goals)), seconds


def macaulay2(q: Question) -> tuple[str, float]:
    names = ",".join(f"x{k}" for k in range(q.letters))
    assumed = ", ".join(_text(p, "1_R") for p in q.assumed) or "0_R"
    lines = ['needsPackage "AssociativeAlgebras"', f"R = QQ<|{names}|>", f"I = ideal{{{assumed}}}", f"G = NCGB(I, {_bound(q)})"]
    lines += [f'print("NF:" | toString NCReductionTwoSided({_text(p, "1_R")}, G))' for p in q.goals]
    output, seconds = _run(["M2", "--script"], "\n".join(lines), ".m2")
    return _answer(output, len(q.goals)), seconds


_SYMPY = '''
from fractions import Fraction
from sympy import Mul, Rational, expand, symbols
x = symbols("x:{letters}", commutative=False)
def make(p):
    return sum((Rational(c) * Mul(*(x[k] for k in w)) for w, c in p), Rational(0))
assumed, goals = {assumed}, {goals}
rules = []
for p in assumed:
    lead, c = max(p, key=lambda term: (len(term[0]), term[0]))
    rules.append((Mul(*(x[k] for k in lead)), expand(Mul(*(x[k] for k in lead)) - make(p) / Rational(c))))
rules = [(old, new) for old, new in rules if old != new]
for p in goals:
    rest = expand(make(p))
    for _ in range(100):
        before = rest
        for old, new in rules:
            rest = expand(rest.subs(old, new))
        if rest == before:
            break
    print("NF:" + str(rest))
'''


def sympy_(q: Question) -> tuple[str, float]:
    assumed, goals = ([[(list(w), str(c)) for w, c in p.items()] for p in ps] for ps in (q.assumed, q.goals))
    output, seconds = _run([sys.executable], _SYMPY.format(letters=max(q.letters, 1), assumed=assumed, goals=goals), ".py")
    answer = _answer(output, len(q.goals))
    return "stuck" if answer == "no" else answer, seconds


SYSTEMS: dict[str, tuple[str, Callable[[Question], tuple[str, float]]]] = {
    "exactkf": ("", exactkf_), "Singular": ("Singular", singular), "Macaulay2": ("M2", macaulay2), "sympy": ("", sympy_),
}


def table() -> str:
    """The table in Markdown."""
    present = {name: run for name, (program, run) in SYSTEMS.items() if not program or shutil.which(program)}
    empty = Question("", {"sizes": [], "over": [], "where": [], "given": [], "says": ["=", 0, 0]}, 1, [], [{(0,): 1}])
    start = {name: 0.0 if name == "exactkf" else min(run(empty)[1] for _ in range(2)) for name, run in present.items()}
    lines = ["| claim | letters | assumptions | " + " | ".join(present) + " |", "| --- | --: | --: |" + " --- |" * len(present)]
    for q in questions():
        cells = []
        for name, run in present.items():
            answer, seconds = run(q)
            cells.append(answer if answer == "time" else f"{answer}, {max(seconds - start[name], 0.0):.3f} s")
        lines.append(f"| {q.title} | {q.letters} | {len(q.assumed)} | " + " | ".join(cells) + " |")
        print(lines[-1], file=sys.stderr, flush=True)
    missing = [name for name in SYSTEMS if name not in present]
    starts = ", ".join(f"{name} {seconds:.2f} s" for name, seconds in start.items() if seconds)
    notes = [f"Start of the systems, subtracted: {starts}."] + ([f"Not installed, left out: {', '.join(missing)}."] if missing else [])
    return "\n".join([*lines, "", *notes]) + "\n"


HEAD = """# The same claims in other systems

Written by `python tests/benchmarks/compare_words.py --write`, which runs everything again; its first lines say what is compared and how.
Singular and Macaulay2 are Debian's packages (`apt-get install singular-ui singular-modules macaulay2`); a system that is missing is left out.

Only exactkf takes statements about typed matrices, checks sizes, and leaves a certificate that a separate checker replays (its time here
includes that replay). The other systems got the polynomials that exactkf had made of the statement; they know no sizes.
*no* of Macaulay2 on a true claim: for these polynomials, which are not homogeneous, one call of `NCGB` returns a set that is not closed up to
the degree (nor with bounds up to 20 on three of them); called again on its own result, once, for D71-E3.48 twice, it proves all five.
Starting a process takes longer than most of these questions, so that the last hundredths of a second of Singular, and the last tenths of
Macaulay2 and sympy, are noise. *stuck*: sympy has no completion, so a substitution of leading words ends where a consequence of two
assumptions is needed.

"""


if __name__ == "__main__":
    made = table()
    print(made)
    if "--write" in sys.argv[1:]:
        (Path(__file__).parent / "COMPARISON.md").write_text(HEAD + made, encoding="utf-8")
