# SPDX-License-Identifier: MIT
"""The grammar of lemmas: what is written is read back, what is wrong is said with its place."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from exactkf import BadInput
from exactkf.language import Statement
from exactkf.lemma import read_lemma, write_lemma

N, P = ("sym", "n"), ("sym", "p")
LETTERS = {(N, N): ["A", "S"], (P, N): ["M"], (P, P): ["V"]}
OVER = {"A": ("matrix", N, N), "S": ("symmetric", N), "M": ("matrix", P, N), "V": ("pd", P), "a": ("scalar",), "b": ("nonzero",)}
NUMBERS = st.one_of(st.integers(0, 9), st.sampled_from([("rat", 1, 2), ("rat", -3, 4), -2]), st.sampled_from([("sym", "a"), ("sym", "b")]))


def terms(rows, cols, depth=2):
    """Terms of a shape, every operation of the grammar among them."""
    zero = [("I", rows)] if rows == cols else [("O", rows, cols)]
    leaf = st.sampled_from([*[("sym", name) for name in LETTERS.get((rows, cols), [])], *zero])
    if not depth:
        return leaf

    def sub(r, c):
        return terms(r, c, depth - 1)

    same = sub(rows, cols)
    options = [
        leaf,
        st.lists(same, min_size=2, max_size=3).map(lambda parts: ("+", *parts)),
        st.tuples(st.just("-"), same, same),
        st.tuples(st.just("neg"), same),
        st.tuples(st.just("T"), sub(cols, rows)),
        st.tuples(st.just("*"), NUMBERS, same),
        st.tuples(st.just("/"), same, st.sampled_from([("sym", "b"), 3])),
        st.sampled_from([N, P]).flatmap(lambda k: st.tuples(st.just("*"), sub(rows, k), sub(k, cols))),
        st.tuples(st.just("*"), sub(rows, rows), sub(rows, cols), sub(cols, cols)),
    ]
    if rows == cols:
        options += [st.tuples(st.just("inv"), same), st.tuples(st.just("^"), same, st.sampled_from([2, 3, -2]))]
    return st.one_of(options)


def blocks():
    return st.tuples(st.just("block"), st.tuples(terms(N, N), terms(N, P)), st.tuples(terms(P, N), terms(P, P)))


def not_zero(tree):
    return tree[0] != "O"


def formulas(depth=1):
    square = terms(N, N)
    plain = st.one_of(
        st.lists(terms(P, N), min_size=2, max_size=3).map(lambda sides: ("=", *sides)),
        st.tuples(st.just("="), blocks(), blocks()),
        st.tuples(st.sampled_from(["psd", "pd", "symmetric", "invertible"]), square),
        st.tuples(st.just("symplectic"), blocks()),
        st.tuples(st.just("loewner"), square, square.filter(not_zero)),
        st.tuples(st.just("!="), terms(P, P), terms(P, P)),
        st.tuples(st.sampled_from([">", ">=", "<", "<="]), st.just(("sym", "a")), st.sampled_from([("sym", "b"), 1, ("rat", 1, 2)])),
        square.map(lambda x: ("=", ("det", x), ("tr", x))),
    )
    if not depth:
        return plain
    part = formulas(depth - 1)
    return st.one_of(plain, st.tuples(st.just("not"), part), st.tuples(st.just("=>"), part, part), st.tuples(st.just("<=>"), part, part),
                     st.tuples(st.just("or"), part, part), st.lists(part, min_size=2, max_size=3).map(lambda parts: ("and", *parts)))


@given(says=formulas(), assumed=st.lists(formulas(), max_size=2), body=terms(N, P))
@settings(max_examples=150, deadline=None)
def test_what_is_written_is_read_back(says, assumed, body):
    """Statement to text to Statement changes nothing."""
    hypotheses = [(f"assumption {k}", f, "needed") for k, f in enumerate(assumed)]
    lemma = Statement(says=says, over=OVER, sizes=["n", "p"], where=[("let", "K", (), body)], given=hypotheses)
    assert lemma == read_lemma(write_lemma(lemma))


def test_a_sequence_is_read_back():
    """First value and step of a sequence, and a claim for all t."""
    text = "sizes n\nmatrix F n n\nmatrix Q n n\nlet X[0] = Q\nlet X[t+1] = F*X[t]*F' + Q\nclaim for all t: X[t] == X[t]'\n"
    lemma = read_lemma(text)
    assert (("rec", "X", "t", 0, (("sym", "Q"),)), ("always", "t")) == (lemma.where[0][:5], lemma.says[:2])
    assert lemma == read_lemma(write_lemma(lemma))


HEAD = "sizes n p\nmatrix P n n\nmatrix M p n\n"


@pytest.mark.parametrize(("line", "tree"), [
    ("P == I", ("=", ("sym", "P"), ("I", N))),
    ("I*P*I == 0", ("=", ("*", ("I", N), ("sym", "P"), ("I", N)), ("O", N, N))),
    ("M*(I - P)' == 0*M", ("=", ("*", ("sym", "M"), ("T", ("-", ("I", N), ("sym", "P")))), ("*", 0, ("sym", "M")))),
    ("inv(I + P) >= 0", ("psd", ("inv", ("+", ("I", N), ("sym", "P"))))),
    ("P > 2*I", ("pd", ("-", ("sym", "P"), ("*", 2, ("I", N))))),
    ("0 <= P", ("psd", ("sym", "P"))),
    ("P^-1 = 0.5*P", ("=", ("inv", ("sym", "P")), ("*", ("rat", 1, 2), ("sym", "P")))),
    ("positive definite P*P'", ("pd", ("*", ("sym", "P"), ("T", ("sym", "P"))))),
    ("[I, M'; M, 0] invertible", ("invertible", ("block", (("I", N), ("T", ("sym", "M"))), (("sym", "M"), ("O", P, P))))),
    ("[P, 0; 0, I]*[M'; I] == [P*M'; I]", None),
    ("M*(2*I - I) == M", None),
    ("(I + I)*M*(I - 1/2*I) == M", None),
])
def test_sizes_of_identities_and_zeros_are_found(line, tree):
    """I and 0 take their sizes from what stands beside them."""
    says = read_lemma(f"{HEAD}claim {line}").says
    assert "I?" not in repr(says)
    if tree is not None:
        assert tree == says


@pytest.mark.parametrize(("text", "place", "words"), [
    ("foo", (1, 1), ["'foo'", "sizes, matrix"]),
    ("", (1, 1), ["claims nothing", "claim ..."]),
    ("sizes n\nmatrix A n n", (2, 13), ["claims nothing"]),
    ("sizes n\nmatrix A n m", (2, 12), ["'m' is not a size", "sizes m"]),
    ("sizes n\nmatrix A n", (2, 11), ["number of columns"]),
    ("sizes n\nmatrix A n 1.5", (2, 12), ["1.5", "whole number"]),
    ("sizes n\nmatrix A n n\nmatrix A n n", (3, 8), ["'A' is declared twice", "line 2", "rename"]),
    ("sizes n\nmatrix I n n", (2, 8), ["'I' has a meaning", "another name"]),
    ("sizes n p\nmatrix A n p symmetric", (2, 10), ["symmetric", "n rows", "p columns"]),
    ("sizes n\nmatrix A n n symplectic", (2, 10), ["assume X symplectic"]),
    ("sizes n\nmatrix A n n nice", (2, 14), ["'nice'", "symmetric"]),
    ("scalar a big", (1, 10), ["'big'", "nonzero"]),
    (HEAD + "claim M*P*M == M", (4, 7), ["the product P*M does not fit", "P is n x n", "M is p x n"]),
    (HEAD + "claim P + M == P", (4, 7), ["in P + M the sizes do not fit", "M is p x n"]),
    (HEAD + "claim P == M*M'", (4, 7), ["P is n x n", "M*M' is p x p"]),
    (HEAD + "claim P + 1 == P", (4, 7), ["the number 1", "write I"]),
    (HEAD + "claim M + I == M", (4, 7), ["identity", "not square"]),
    (HEAD + "claim inv(M) == M", (4, 7), ["inverse inv(M)", "square"]),
    (HEAD + "claim M^2 == M", (4, 7), ["power M^2", "square"]),
    (HEAD + "claim M >= 0", (4, 7), ["p x n", "symmetric ones"]),
    (HEAD + "claim M invertible", (4, 7), ["square", "p x n"]),
    (HEAD + "claim M/P == M", (4, 7), ["divides by", "inv(P)"]),
    (HEAD + "claim [P, M; M, P] == 0", (4, 7), ["block", "does not fit"]),
    (HEAD + "claim [P, M'; M] == 0", (4, 7), ["different numbers of blocks"]),
    (HEAD + "claim I == 0", (4, 7), ["not determined", "I(n)"]),
    (HEAD + "claim [P, M']*[I + I, 0; 0, I] == [2*P, M']", (4, 7), ["not determined", "I(n)"]),
    (HEAD + "claim det(I) == 1", (4, 11), ["not determined", "I(n)"]),
    (HEAD + "claim P*Q == P", (4, 9), ["'Q' is not known", "matrix Q"]),
    (HEAD + "claim P*(P == P", (4, 16), ["')'"]),
    (HEAD + "claim P ==", (4, 11), ["a term"]),
    (HEAD + "claim P P", (4, 9), ["an operation or a relation"]),
    (HEAD + "claim P == P P", (4, 14), ["end of the line"]),
    (HEAD + "claim P @ P", (4, 9), ["'@'"]),
    (HEAD + "claim P*P", (4, 7), ["is a term", "formula"]),
    (HEAD + "let K = P == P\nclaim K == P", (4, 9), ["is a formula"]),
    (HEAD + "let K = K*P\nclaim K == P", (4, 9), ["'K' is not known"]),
    (HEAD + "claim P^T == P", (4, 9), ["X'"]),
    (HEAD + "claim P^n == P", (4, 9), ["whole number as exponent"]),
    (HEAD + "claim 1/0*P == P", (4, 8), ["division by zero"]),
    (HEAD + "claim P == P >= P", (4, 7), ["one chain", "and"]),
    (HEAD + "claim P[1] == P", (4, 7), ["no sequence"]),
    (HEAD + "claim __import__('os') == P", (4, 7), ["'__import__' is not known"]),
    (HEAD + "assume x: P == P\nassume x: P == 0\nclaim P == P", (5, 11), ["'x' is there twice"]),
    (HEAD + "let X[0] = P\nclaim for all t: X[t] == P", (4, 5), ["no step"]),
    (HEAD + "let X[0] = P\nlet X[t+1] = M*X[t]\nclaim P == P", (5, 14), ["another size"]),
    (HEAD + "claim " + "(" * 70 + "P" + ")" * 70 + " == P", (4, 67), ["brackets inside each other"]),
    *((HEAD + f"claim {text}", (4, 7), ["operations inside each other", "a step of the lemma"])
      for text in ("P" + " - P" * 3000 + " == P", "P" + "/2" * 3000 + " == P", "P" + "'" * 3000 + " == P", " <=> ".join(["P == P"] * 1000))),
    (HEAD + "let P0 = P\n" + "\n".join(f"let P{k + 1} = P{k} + P" for k in range(100)) + "\nclaim P100 == P", (44, 11), ["operations inside each other"]),
    (HEAD + "claim " + "not " * 3000 + "P == P", (4, 243), ["inside each other"]),
    (HEAD + "claim " + " => ".join(["P == P"] * 1500), (4, 597), ["inside each other"]),
    (HEAD + "claim (P psd)*P == P", (4, 7), ["(P psd) is a formula", "a term is needed"]),
    (HEAD + "claim (P == P) == (P == P)", (4, 19), ["is a formula", "a term is needed"]),
    (HEAD + "claim (P == P) == P", (4, 7), ["is a formula", "a term is needed"]),
    (HEAD + "claim (P == P)' == P", (4, 7), ["is a formula", "a term is needed"]),
    (HEAD + "claim (P == P) psd", (4, 7), ["is a formula", "a term is needed"]),
    (HEAD + "claim P => P == P", (4, 7), ["P is a term", "a formula is needed"]),
    (HEAD + "claim P == P and P", (4, 18), ["P is a term", "a formula is needed"]),
    (HEAD + "claim not P", (4, 11), ["P is a term", "a formula is needed"]),
    (HEAD + "claim for all t: for all s: P == P", (4, 18), ["'for' has a meaning of its own"]),
    ("matrix A 100000 2", (1, 10), ["100000 is too large", "name it with 'sizes'"]),
])
def test_errors_name_place_fault_and_remedy(text, place, words):
    """One line: where, what, and what to write instead."""
    with pytest.raises(BadInput) as caught:
        read_lemma(text)
    message = str(caught.value)
    assert message.startswith(f"line {place[0]}, column {place[1]}: "), message
    assert "\n" not in message
    for word in words:
        assert word in message


def test_lines_may_be_indented_and_continued():
    """Indented items, comments, and lines that go on with the one before."""
    text = """
        sizes n      # of the state
        matrix A, B
          n n
        claim A*(
B) ==
          A*B
    """
    assert read_lemma("sizes n\nmatrix A, B n n\nclaim A*(B) == A*B") == read_lemma(text)


@pytest.mark.parametrize("value", [None, 3, b"claim"])
def test_only_text_is_read(value):
    """Anything but a str is refused."""
    with pytest.raises(BadInput, match="argument 'source'"):
        read_lemma(value)


@pytest.mark.timeout(20)
def test_long_sums_take_no_longer_than_they_are_long():
    """The parts of a sum are looked at twice, once without and once with their size, but not twice as often for each sum around them."""
    text = f"{HEAD}claim P{' - P' * 70} == P"
    assert read_lemma(text).says[0] == "="
