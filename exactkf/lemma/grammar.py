# SPDX-License-Identifier: MIT
"""A lemma as a small text file.

::

    # Joseph form of the covariance update
    sizes n p
    matrix P n n symmetric
    matrix M p n
    matrix V p p positive definite
    let S = M*P*M' + V
    let K = P*M'*S^-1
    assume innovation: S invertible
    claim (I - K*M)*P*(I - K*M)' + K*V*K' == P - K*M*P

One item a line; ``#`` starts a comment; a line that begins with a blank, and
one inside brackets, goes on with the line before.

==========================================  =====================================================================
item                                        meaning
==========================================  =====================================================================
``sizes n p``                               whole numbers >= 0 that the claim is for
``matrix A, B n p+1``                       letters of so many rows and columns; a kind may follow: ``symmetric``,
                                            ``positive semidefinite`` (``psd``), ``positive definite`` (``pd``),
                                            ``invertible`` (``nonsingular``), ``diagonal``
``vector x n``                              the same with one column
``scalar a``                                a real number; ``nonzero``, ``positive`` or ``nonnegative`` may follow
``let S = term``                            a name for a term
``let X[0] = term``, ``let X[t+1] = term``  a sequence by its first value and its step, two lines
``assume label: formula``                   an assumption; the label may be left out
``claim formula``                           a conclusion; several are proved together; ``for all t: formula`` for a sequence
==========================================  =====================================================================

Terms, tightest first: ``X'`` transpose, ``X^-1`` or ``inv(X)`` inverse, ``X^3`` power; ``*`` and ``/``; ``+`` and ``-``. ``I`` is an
identity and ``0`` a zero whose size follows from what stands beside it, ``I(n)`` and ``O(n, p)`` say it. ``[A, B; C, D]`` is a
block matrix. ``2``, ``1/3``, ``0.25`` are exact numbers; ``det(X)``, ``trace(X)``, ``rank(X)`` are numbers.

A left or a right inverse of a matrix that need not be square is a letter, and what it does is said by ``assume L*A == I`` or ``assume A*R == I``.

Formulas, tightest first: ``A == B`` (or ``=``; chains are allowed), ``A != B``, ``A >= B`` (order of symmetric matrices, or of numbers), ``A > B``
(the difference is positive definite), ``X symmetric``, ``X psd``, ``X pd``, ``X invertible``, ``X symplectic`` (the property may stand in front);
``not``, ``and``, ``or``, ``=>``, ``<=>``.

Nothing of the text is executed. What cannot be read raises `exactkf.BadInput` with line, column and remedy.

Main definitions
----------------
`read_lemma`
    Text to `exactkf.language.Statement`; `exactkf.lemma.write` goes the other way.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from exactkf._errors import BadInput
from exactkf.language.statement import Statement
from exactkf.language.text import text as tree_text
from exactkf.lemma.sizes import IDENTITY, Misfit, Sizes

__all__ = ["read_lemma"]

_TOKEN = re.compile(r"""
    (?P<blank>[ \t\r]+|\#[^\n]*) | (?P<end>\n) | (?P<number>\d+(?:\.\d+)?) | (?P<name>[A-Za-z_]\w*)
  | (?P<mark><=>|=>|==|!=|>=|<=|[-+*/^'()\[\],;:=<>])
""", re.VERBOSE | re.ASCII)

_ITEMS = ("sizes", "matrix", "vector", "scalar", "let", "assume", "claim")
_GOES_ON = re.compile(rf"[ \t]++(?!(?:{'|'.join(_ITEMS)})\b)")  # an item may be indented, too
_PROPERTIES = {
    "symmetric": "symmetric", "psd": "psd", "pd": "pd", "invertible": "invertible", "nonsingular": "invertible", "symplectic": "symplectic",
}
_KINDS = {**_PROPERTIES, "invertible": "nonsingular", "nonsingular": "nonsingular", "diagonal": "diagonal"}
_SCALARS = {"nonzero": "nonzero", "positive": "positive", "nonnegative": "nonneg"}
_FUNCTIONS = {"det": "det", "trace": "tr", "rank": "rank"}
_RESERVED = {*_ITEMS, *_KINDS, *_SCALARS, *_FUNCTIONS, "symplectic", "semidefinite", "definite", "inv", "I", "O", "and", "or", "not", "for", "all", "horizon"}
_DEEPEST = 60  # brackets inside each other
_MOST_INSIDE = 80  # operations inside each other, definitions opened
_LONGEST = 20_000  # characters of a lemma
_MOST_DIGITS, _LARGEST_POWER, _LARGEST_SIZE = 1000, 1000, 1000


@dataclass(frozen=True)
class _Token:
    kind: str
    text: str
    start: int
    end: int


class _Node(tuple):
    """A tree that knows the part of the source it was read from, and how many operations stand inside each other in it."""

    span: tuple[int, int]
    height: int


def read_lemma(source: str) -> Statement:
    """Read a lemma.

    Parameters
    ----------
    source : str
        Text in the grammar of this module.

    Raises
    ------
    BadInput
        With line and column of what cannot be read, what is wrong and what to write instead.

    Examples
    --------
    >>> print(read_lemma("sizes n\\nmatrix A, B n n\\nassume A*B == I\\nclaim B*A == I").given)
    (('A*B == I', ('=', ('*', ('sym', 'A'), ('sym', 'B')), ('I', ('sym', 'n'))), 'needed'),)
    """
    if not isinstance(source, str):
        raise BadInput(f"argument 'source' = {source!r} is not text; pass the text of a lemma as a str")
    return _Parser(source).lemma()


class _Parser:
    """Recursive descent over the tokens of one lemma."""

    def __init__(self, source: str) -> None:
        self.source = source
        if len(source) > _LONGEST:
            raise self.fail(_LONGEST, f"the lemma is longer than {_LONGEST} characters; state a shorter one")
        self.items = self._items()
        self.tokens: list[_Token] = []
        self.at = 0
        self.sizes: list[str] = []
        self.over: dict[str, tuple] = {}
        self.where: list[tuple] = []
        self.given: list[tuple] = []
        self.says: list[Any] = []
        self.lines: dict[str, int] = {}  # name -> where it was declared
        self.begun: dict[str, tuple[Any, int]] = {}  # sequence -> first value, where
        self.shapes = Sizes([], self._show)
        self.index = ""
        self.depth = 0
        self.heights: dict[str, int] = {}  # of definitions

    # ------------------------------------------------------------------ errors
    def fail(self, start: int, message: str) -> BadInput:
        line = self.source.count("\n", 0, start) + 1
        column = start - (self.source.rfind("\n", 0, start) + 1) + 1
        return BadInput(f"line {line}, column {column}: {' '.join(message.split())}")

    def _show(self, tree: Any) -> str:
        """Source of a tree, or its text."""
        span = getattr(tree, "span", None)
        return " ".join(self.source[span[0]:span[1]].split()) if span else "I" if tree == IDENTITY else tree_text(tree)

    def _expected(self, what: str) -> BadInput:
        token = self._now()
        seen = "the line ends" if token is None else f"{token.text!r} stands"
        return self.fail(self._place(), f"{seen} where {what} is expected")

    def _place(self) -> int:
        token = self._now()
        return token.start if token else self.tokens[-1].end if self.tokens else len(self.source)

    # ------------------------------------------------------------------ tokens
    def _items(self) -> list[list[_Token]]:
        """Tokens of each item: a line with those that go on with it."""
        items: list[list[_Token]] = [[]]
        at, open_ = 0, 0
        while at < len(self.source):
            match = _TOKEN.match(self.source, at)
            if match is None:
                raise self.fail(at, f"{self.source[at]!r} is not a character of the grammar; see exactkf.lemma.grammar for what is")
            kind = str(match.lastgroup)
            if kind == "end":
                if open_ <= 0 and not _GOES_ON.match(self.source, match.end()):
                    items.append([])
                    open_ = 0
            elif kind != "blank":
                open_ += (match.group() in ("(", "[")) - (match.group() in (")", "]"))
                items[-1].append(_Token(kind, match.group(), match.start(), match.end()))
            at = match.end()
        return [item for item in items if item]

    def _now(self) -> _Token | None:
        return self.tokens[self.at] if self.at < len(self.tokens) else None

    def _peek(self, *texts: str) -> bool:
        token = self._now()
        return token is not None and token.text in texts

    def _take(self, *texts: str) -> _Token | None:
        token = self._now()
        if token is None or token.text not in texts:
            return None
        self.at += 1
        return token

    def _need(self, text: str, why: str) -> _Token:
        token = self._take(text)
        if token is None:
            raise self._expected(f"{text!r} {why}")
        return token

    def _number(self) -> Any:
        token = self.tokens[self.at]
        self.at += 1
        if len(token.text) > _MOST_DIGITS:
            raise self.fail(token.start, f"a number of more than {_MOST_DIGITS} digits; write it as a product")
        value = Fraction(token.text)
        return int(value) if value.denominator == 1 else self._node(("rat", value.numerator, value.denominator), token.start)

    def _node(self, tree: tuple, start: int) -> Any:
        node = _Node(tree)
        node.span = (start, self.tokens[self.at - 1].end)
        parts = [cell for row in tree[1:] for cell in row] if tree[0] == "block" else tree[1:]
        node.height = 1 + max((getattr(x, "height", 0) for x in parts), default=0) + (self.heights.get(tree[1], 0) if tree[0] == "sym" else 0)
        if node.height > _MOST_INSIDE:
            raise self.fail(start, f"more than {_MOST_INSIDE} operations inside each other, definitions opened; state a step of the lemma by itself")
        return node

    # ------------------------------------------------------------------ items
    def lemma(self) -> Statement:
        for tokens in self.items:
            self.tokens, self.at, self.depth = tokens, 1, 0
            word = tokens[0].text
            if word not in _ITEMS:
                known = ", ".join(_ITEMS)
                raise self.fail(tokens[0].start, f"a line starts with {word!r}; start it with one of {known}, or with a blank to go on with the line before")
            try:
                getattr(self, f"_item_{word}")()
            except Misfit as error:
                raise self.fail(getattr(error.tree, "span", (tokens[0].start,))[0], str(error)) from error
            if self._now() is not None:
                raise self._expected("the end of the line")
        for name, (_, start) in self.begun.items():
            raise self.fail(start, f"the sequence {name} has no step; add a line 'let {name}[t+1] = ...'")
        if not self.says:
            raise self.fail(len(self.source), "the lemma claims nothing; add a line 'claim ...'")
        says = self.says[0] if len(self.says) == 1 else ("and", *self.says)
        return Statement(says=says, over=self.over, sizes=self.sizes, where=self.where, given=self.given)

    def _new_name(self, what: str) -> str:
        token = self._now()
        if token is None or token.kind != "name":
            raise self._expected(f"the name of a {what}")
        if token.text in _RESERVED:
            raise self.fail(token.start, f"{token.text!r} has a meaning of its own; choose another name for the {what}")
        if token.text in self.lines:
            line = self.source.count("\n", 0, self.lines[token.text]) + 1
            raise self.fail(token.start, f"the name {token.text!r} is declared twice, first in line {line}; rename one")
        self.at += 1
        self.lines[token.text] = token.start
        return token.text

    def _item_sizes(self) -> None:
        while True:
            name = self._new_name("size")
            self.sizes.append(name)
            self.shapes.names.append(name)
            self.shapes.declare(name, ("scalar",))
            if not self._take(",") and self._now() is None:
                return

    def _names(self, what: str) -> list[str]:
        names = [self._new_name(what)]
        while self._take(","):
            names.append(self._new_name(what))
        return names

    def _item_matrix(self) -> None:
        names, start = self._names("matrix"), self._place()
        rows, cols = self._size("rows"), self._size("columns")
        kind = self._property(_KINDS, "a kind of matrix") if self._now() else ""
        if kind == "symplectic":
            raise self.fail(start, "'symplectic' is no kind of letter; add a line 'assume X symplectic'")
        if kind and self.shapes.size(rows) != self.shapes.size(cols):
            raise self.fail(start, f"{names[0]} is {kind}, but has {tree_text(rows)} rows and {tree_text(cols)} columns; only square matrices can be {kind}")
        for name in names:
            self._declare(name, (kind, rows) if kind else ("matrix", rows, cols))

    def _item_vector(self) -> None:
        names = self._names("vector")
        rows = self._size("entries")
        for name in names:
            self._declare(name, ("matrix", rows, 1))

    def _item_scalar(self) -> None:
        names = self._names("scalar")
        token = self._now()
        kind = _SCALARS.get(token.text) if token else "scalar"
        if kind is None:
            raise self._expected("one of nonzero, positive, nonnegative")
        self.at += token is not None
        for name in names:
            self._declare(name, (kind,))

    def _declare(self, name: str, kind: tuple) -> None:
        self.over[name] = kind
        self.shapes.declare(name, kind)

    def _size(self, what: str) -> Any:
        """A sum of named sizes and whole numbers."""
        if self._now() is None:
            raise self._expected(f"the number of {what}")
        start = self._place()
        tree = self._chain({"+": "+", "-": "-"}, self._size_part)
        try:
            self.shapes.size(tree)
        except Misfit as error:
            raise self.fail(start, str(error)) from error
        return _bare(tree)

    def _size_part(self) -> Any:
        token = self._now()
        if token is None or token.kind not in ("number", "name"):
            raise self._expected("a size")
        if token.kind == "number":
            if "." in token.text:
                raise self.fail(token.start, f"{token.text} is no size; write a whole number")
            count = self._number()
            if count > _LARGEST_SIZE:
                raise self.fail(token.start, f"the size {token.text[:20]} is too large; write one up to {_LARGEST_SIZE}, or name it with 'sizes'")
            return self._node(("*", count, self._size_part()), token.start) if self._take("*") else count
        if token.text not in self.sizes:
            comma = ", or part letters with commas" if token.text[0].isupper() else ""
            raise self.fail(token.start, f"{token.text!r} is not a size; declare it with 'sizes {token.text}'{comma}")
        self.at += 1
        return self._node(("sym", token.text), token.start)

    def _item_let(self) -> None:
        token, after = self._now(), self.tokens[self.at + 1:self.at + 2]
        if token is not None and after and after[0].text == "[":
            self._sequence(token)
            return
        name = self._new_name("definition")
        del self.lines[name]  # not known inside its own definition
        self._need("=", "of the definition")
        term = self._term_only()
        self.heights[name] = getattr(term, "height", 0)
        body = self.shapes.define(name, term)
        self.lines[name] = self.tokens[1].start
        self.where.append(("let", name, (), body))

    def _sequence(self, token: _Token) -> None:
        """X[0] = term, then X[t+1] = term."""
        name, first = token.text, token.text not in self.begun
        if first:
            self._new_name("sequence")
        else:
            self.at += 1
        self._need("[", "of the sequence")
        if first:
            self._need("0", f"of the first value, 'let {name}[0] = ...'")
        else:
            index = self._now()
            if index is None or index.kind != "name" or index.text in self.lines or index.text in _RESERVED:
                raise self._expected("an index that is no other name")
            self.at += 1
            self._need("+", f"of the step, 'let {name}[{index.text}+1] = ...'")
            self._need("1", f"of the step, 'let {name}[{index.text}+1] = ...'")
        self._need("]", "after the index")
        self._need("=", "of the definition")
        if first:
            self.begun[name] = (self.shapes.define(name, self._term_only()), token.start)
            return
        self.index = index.text  # type: ignore[union-attr]
        tree = self._term_only()
        done, shape = self.shapes.term(tree)
        if shape != self.shapes.shapes[name]:
            raise Misfit(tree, f"the step of {name} has another size than its first value; make them the same")
        self.where.append(("rec", name, self.index, 0, (self.begun.pop(name)[0],), done))
        self.index = ""

    def _item_assume(self) -> None:
        start = self._place()
        label = ""
        ahead = [t.text for t in self.tokens[self.at:]]
        if ":" in ahead and "for" not in ahead:
            colon = self.at + ahead.index(":")
            label = self.source[start:self.tokens[colon].start].strip()
            if not label:
                raise self._expected("a label before ':'")
            self.at = colon + 1
            start = self._place()
        tree = self._formula_only()
        label = label or self._show_from(start)
        if any(label == known for known, _, _ in self.given):
            raise self.fail(start, f"the assumption {label!r} is there twice; remove one, or label them differently")
        self.given.append((label, self.shapes.formula(tree), "needed"))

    def _show_from(self, start: int) -> str:
        return " ".join(self.source[start:self.tokens[-1].end].split())

    def _item_claim(self) -> None:
        token = self._take("for")
        if token is None:
            self.says.append(self.shapes.formula(self._formula_only()))
            return
        self._need("all", "after 'for'")
        index = self._now()
        if index is None or index.kind != "name" or index.text in self.lines or index.text in _RESERVED:
            raise self._expected("an index that is no other name")
        self.at += 1
        self._need(":", "after the index")
        self.index = index.text
        self.says.append(("always", self.index, self.shapes.formula(self._formula_only())))
        self.index = ""

    # ------------------------------------------------------------------ formulas and terms
    def _term_only(self) -> Any:
        start, tree = self._place(), self._formula()
        if _is_formula(tree):
            raise self.fail(start, f"{self._show(tree)} is a formula; a definition needs a term")
        return tree

    def _formula_only(self) -> Any:
        start, tree = self._place(), self._formula()
        if not _is_formula(tree):
            if self._now() is not None:
                raise self._expected("an operation or a relation")
            raise self.fail(start, f"{self._show(tree)} is a term; write a formula: an equation, an order such as P >= 0, or a property such as 'X invertible'")
        return tree

    def _formula(self) -> Any:
        start = self._place()
        self._deeper(start)
        left = self._implied()
        while self._take("<=>"):
            left = self._node(("<=>", self._said(left, start), self._said_next(self._implied)), start)
        self.depth -= 1
        return left

    def _deeper(self, start: int) -> None:
        self.depth += 1
        if self.depth > _DEEPEST:
            raise self.fail(start, f"more than {_DEEPEST} brackets inside each other; name parts with 'let'")

    def _said(self, tree: Any, start: int) -> Any:
        """A part of a formula that is a formula."""
        if not _is_formula(tree):
            raise self.fail(start, f"{self._show(tree)} is a term where a formula is needed, such as an equation")
        return tree

    def _said_next(self, part: Callable[[], Any]) -> Any:
        start = self._place()
        return self._said(part(), start)

    def _term(self, part: Callable[[], Any]) -> Any:
        """A part of a term that is a term."""
        start = self._place()
        return self._no_formula(part(), start)

    def _no_formula(self, tree: Any, start: int) -> Any:
        if _is_formula(tree):
            raise self.fail(start, f"{self._show(tree)} is a formula where a term is needed")
        return tree

    def _implied(self) -> Any:
        start, left = self._place(), self._joined("or", lambda: self._joined("and", self._negated))
        if not self._take("=>"):
            return left
        self._deeper(start)
        right = self._said_next(self._implied)
        self.depth -= 1
        return self._node(("=>", self._said(left, start), right), start)

    def _joined(self, word: str, part: Callable[[], Any]) -> Any:
        start, parts = self._place(), [part()]
        while self._take(word):
            self._said(parts[0], start)
            parts.append(self._said_next(part))
        return parts[0] if len(parts) == 1 else self._node((word, *parts), start)

    def _negated(self) -> Any:
        start = self._place()
        if self._take("not"):
            self._deeper(start)
            tree = self._node(("not", self._said_next(self._negated)), start)
            self.depth -= 1
            return tree
        if self._peek(*_PROPERTIES, "positive"):
            property_ = self._property(_PROPERTIES, "a property")
            return self._node((property_, self._term(self._sum)), start)
        return self._relation(start)

    def _property(self, known: dict[str, str], what: str) -> str:
        if self._take("positive"):
            return {"semidefinite": "psd", "definite": "pd"}[self._need_one("semidefinite", "definite").text]
        token = self._now()
        if token is None or token.text not in known:
            raise self._expected(f"{what} ({', '.join(known)}, positive semidefinite, positive definite)")
        self.at += 1
        return known[token.text]

    def _need_one(self, *texts: str) -> _Token:
        token = self._take(*texts)
        if token is None:
            raise self._expected(" or ".join(map(repr, texts)))
        return token

    def _relation(self, start: int) -> Any:
        left = self._sum()
        if self._peek(*_PROPERTIES, "positive"):
            return self._node((self._property(_PROPERTIES, "a property"), self._no_formula(left, start)), start)
        parts, ops = [left], []
        while token := self._take("==", "=", "!=", ">=", "<=", ">", "<"):
            ops.append("=" if token.text == "==" else token.text)
            parts.append(self._term(self._sum))
        if not ops:
            return left
        self._no_formula(left, start)
        if len(set(ops)) > 1 or (ops[0] == "!=" and len(ops) > 1):
            raise self.fail(start, f"different relations in one chain, {' '.join(ops)}; write two formulas joined by 'and'")
        return self._node((ops[0], *parts), start)

    def _chain(self, ops: dict[str, str], part: Callable[[], Any]) -> Any:
        """Operations of one level, from the left; sums and products take all their parts at once."""
        start, acc, own = self._place(), part(), False
        while token := self._take(*ops):
            op, right = ops[token.text], self._term(part)
            self._no_formula(acc, start)
            if op == "/" and isinstance(acc, int) and not own and isinstance(right, int):
                if right == 0:
                    raise self.fail(token.start, "division by zero; write a denominator that is not 0")
                value = Fraction(acc, right)
                acc = int(value) if value.denominator == 1 else self._node(("rat", value.numerator, value.denominator), start)
            elif op in "+*" and own and acc[0] == op:
                acc = self._node((*acc, right), start)
            else:
                acc, own = self._node((op, acc, right), start), True
        return acc

    def _sum(self) -> Any:
        return self._chain({"+": "+", "-": "-"}, self._signed) if not self._peek("+") else self._failed_sign()

    def _failed_sign(self) -> Any:
        raise self._expected("a term")

    def _signed(self) -> Any:
        """A product; a minus sign may stand before the first of a sum."""
        token = self._now()
        if token is None or token.text != "-":
            return self._product()
        if self.at and self.tokens[self.at - 1].text in ("+", "-"):
            raise self._expected("a term (put a negative one in brackets)")
        self.at += 1
        tree = self._term(self._product)
        if isinstance(tree, int):
            return -tree
        if tree[0] == "rat":
            return self._node(("rat", -tree[1], tree[2]), token.start)
        return self._node(("neg", tree), token.start)

    def _product(self) -> Any:
        return self._chain({"*": "*", "/": "/"}, self._power)

    def _power(self) -> Any:
        start, tree = self._place(), self._atom()
        while token := self._take("'", "^"):
            self._no_formula(tree, start)
            if token.text == "'":
                tree = self._node(("T", tree), start)
                continue
            minus = self._take("-") is not None
            exponent = self._now()
            if exponent is not None and exponent.text == "T":
                raise self.fail(exponent.start, "^T is not the transpose; write X'")
            if exponent is None or exponent.kind != "number" or "." in exponent.text:
                raise self._expected("a whole number as exponent")
            self.at += 1
            if len(exponent.text) > 4 or int(exponent.text) > _LARGEST_POWER:
                raise self.fail(exponent.start, f"the exponent {exponent.text[:20]} is too large; exponents up to {_LARGEST_POWER} are read")
            k = -int(exponent.text) if minus else int(exponent.text)
            tree = self._node(("inv", tree) if k == -1 else ("^", tree, k), start)
        return tree

    def _atom(self) -> Any:
        token = self._now()
        if token is None:
            raise self._expected("a term")
        if token.kind == "number":
            return self._number()
        if token.text == "(":
            self.at += 1
            tree = self._formula()
            self._need(")", "of the bracket")
            if not isinstance(tree, int):
                tree = self._node(tuple(tree), token.start)
            return tree
        if token.text == "[":
            return self._blocks(token.start)
        if token.kind != "name":
            raise self._expected("a term")
        self.at += 1
        return self._named(token)

    def _blocks(self, start: int) -> Any:
        self.at += 1
        rows, row = [], [self._term_only()]
        while not self._take("]"):
            if self._take(","):
                row.append(self._term_only())
            elif self._take(";"):
                rows.append(tuple(row))
                row = [self._term_only()]
            else:
                raise self._expected("',', ';' or ']' of the block matrix")
        return self._node(("block", *rows, tuple(row)), start)

    def _named(self, token: _Token) -> Any:
        name = token.text
        if name == "I" and not self._peek("("):
            return self._node(IDENTITY, token.start)
        if name in ("I", "O"):
            self._need("(", f"of {name}")
            sizes = [self._size("rows")]
            if name == "O":
                self._need(",", "between rows and columns")
                sizes.append(self._size("columns"))
            self._need(")", f"of {name}")
            return self._node((name, *sizes), token.start)
        if name == "inv" or name in _FUNCTIONS:
            self._need("(", f"of {name}")
            tree = self._term_only()
            self._need(")", f"of {name}")
            return self._node((_FUNCTIONS.get(name, name), tree), token.start)
        if name in _RESERVED:
            raise self.fail(token.start, f"{name!r} has a meaning of its own, and cannot stand here")
        if name not in self.lines or name == self.index:
            remedy = f"declare it before with 'matrix {name} ...', 'scalar {name}' or 'let {name} = ...'"
            raise self.fail(token.start, f"the letter {name!r} is not known here; {remedy}")
        if self._peek("["):
            return self._step_of(token)
        return self._node(("sym", name), token.start)

    def _step_of(self, token: _Token) -> Any:
        """X[t], X[t+1], X[0] for a sequence."""
        known = {*self.begun, *(d[1] for d in self.where if d[0] == "rec")}
        if token.text not in known:
            raise self.fail(token.start, f"{token.text!r} is no sequence; entries of a matrix are not part of the grammar")
        self.at += 1
        start, index = self._place(), self._now()
        if index is not None and index.kind == "name" and index.text == self.index:
            self.at += 1
            tree: Any = self._node(("sym", index.text), start)
            if sign := self._take("+", "-"):
                shift = self._now()
                if shift is None or shift.kind != "number":
                    raise self._expected("a whole number")
                tree = self._node((sign.text, tree, self._number()), start)
        elif index is not None and index.kind == "number":
            tree = self._number()
        else:
            raise self._expected(f"the index {self.index!r} or a whole number" if self.index else "a whole number")
        self._need("]", "after the index")
        return self._node(("at", token.text, tree), token.start)


def _is_formula(tree: Any) -> bool:
    return isinstance(tree, tuple) and tree[0] in {*_PROPERTIES.values(), "=", "!=", ">=", "<=", ">", "<", "and", "or", "not", "=>", "<=>"}


def _bare(tree: Any) -> Any:
    return tuple(_bare(x) for x in tree) if isinstance(tree, tuple) else tree
