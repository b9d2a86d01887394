# SPDX-License-Identifier: MIT
"""Products of matrices at a generic index, as sums of words.

The entries of a matrix variable, or of a definition that is closed, say nothing about a product with it; what does is the product itself. So an entry of a
product is multiplied out into words, products of letters: matrices that are not opened further. Each step is an identity of
matrices over a commutative ring, whatever their sizes, which `Terms.shape` checks where a product or a sum is read:

- a transpose goes to the factors, in reverse order; a sum, a multiple, a quotient by a number go to the words;
- a name is replaced by its definition, a recursion at an index at which it may be opened, or by a rule;
- a sum over an index of matrices goes outside; p(F), for a polynomial with exponents 0 .. t, is the sum of p_k F^k;
- where a column meets a row the entry is a product of two;
- F^a F^b = F^(a+b) for a, b >= 0, F^0 = I, and I is left out; P' = P for a variable of a type that says so;
- entry (i, j) of a product is entry (j, i) of its transpose: of the two the one with fewer transposes is taken.
  Where they differ by indices alone, as for an entry of a symmetric matrix, indices decide, but in a sum.

A word is an atom: two words have the same value if they have the same letters with the same indices and the same place.
A sum without terms has no shape of its own, and is refused where a matrix is needed.

Main definitions
----------------
`Chains`
    What `exactkf.kernel.generic.Terms` does with products of matrices.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from typing import Any

from exactkf.kernel.generic_reading import Reading
from exactkf.kernel.numbers import Unknown
from exactkf.kernel.opaque import parsed, with_names
from exactkf.kernel.region import Form, form_key, plus
from exactkf.kernel.symbolic import Symbolic

__all__ = ["Chains"]

_ONE: Form = {"": 1}
_AS_ENTRIES = ("mat", "col", "block")  # matrices given by their entries
Part = tuple[Any, Mapping[str, Form], bool]  # a matrix, its indices, and whether it is transposed


class Chains(Reading):
    """Words in a region; the rest of the reading of terms is elsewhere."""

    def word(self, parts: list[Part], i: Form, j: Form) -> Symbolic:
        """Entry (i, j) of a product of matrices of fitting sizes."""
        if len(parts) == 1 and isinstance(parts[0][0], list) and parts[0][0][0] in _AS_ENTRIES:
            (tree, env, flip), = parts
            return self.entry(tree, j, i, env) if flip else self.entry(tree, i, j, env)
        for k, (tree, env, flip) in enumerate(parts):
            def put(*made: Part, k: int = k) -> Symbolic:
                return self.word([*parts[:k], *made, *parts[k + 1:]], i, j)

            def inside() -> None:
                self._need_within(i, self._width((*parts[0][:2], not parts[0][2])), j, self._width(parts[-1]))

            found = self._rewritten(tree, env, flip, put, len(parts) == 1, inside)
            if found is not None:
                return found
        for k in range(1, len(parts)):
            if self._width(parts[k - 1]) == _ONE:
                return self.word(parts[:k], i, _ONE) * self.word(parts[k:], _ONE, j)
        found = self._by_entries(parts, i, j)
        return self._letters(parts, i, j) if found is None else found

    def _width(self, part: Part) -> Form:
        """Number of columns."""
        tree, env, flip = part
        return self.shape(tree, env)[int(not flip)]

    def _by_entries(self, parts: list[Part], i: Form, j: Form) -> Symbolic | None:
        """A product in which a matrix is given by its entries, and none is an inverse or a power, as a sum over an index; and one of columns alone."""
        if any(tree[0] in ("inv", "^") for tree, _, _ in parts):
            return None
        columns = len(parts) > 1 and not any(self.has_letters(tree) for tree, _, _ in parts)
        at = next((k for k, (tree, _, _) in enumerate(parts) if columns or self._given_by_entries(tree)), None)
        if at is None:
            return None
        cut = max(at, 1)  # what stands before it is one matrix, or it is the first itself
        return self.total(_ONE, self._width(parts[cut - 1]), lambda _, k: self.word(parts[:cut], i, k) * self.word(parts[cut:], k, j))

    def _given_by_entries(self, tree: Any) -> bool:
        if tree[0] in ("sym", "at"):
            d = self.definitions.get(tree[1])
            return d is not None and d[0] == "let" and tree[1] not in self.closed | self.recursive and d[3][0] in _AS_ENTRIES
        return tree[0] in _AS_ENTRIES

    def _rewritten(self, tree: Any, env: Mapping[str, Form], flip: bool, put: Callable[..., Symbolic], alone: bool,
                   inside: Callable[[], None]) -> Symbolic | None:
        """A product with this factor, or this matrix alone, once it is replaced by what it is made of; None for a letter.

        A matrix of one row and column is a number only ``inside`` of the product: for another size the same term is no number, and beyond the
        places of the product another one.
        """
        if not self.is_matrix(tree):
            return self.value(tree, env) * put()
        if self._is_power_of_number(tree, env):
            inside()
            return self.value(tree, env) * put()
        op = tree[0]
        if op == "T":
            return put((tree[1], env, not flip))
        if op == "^" and tree[1][0] == "T":
            return put((["^", tree[1][1], tree[2]], env, not flip))
        if op == "*":
            scalars, chain = self._factors(tree, env)
            if self._are_matrices(scalars):
                inside()
            out = put(*((x, env, flip) for x in (reversed(chain) if flip else chain)))
            for part in scalars:
                out = self._chain(part, _ONE, _ONE, env) * out
            return out
        if op in ("+", "-", "neg"):
            self.shape(tree, env)
            first, *others = (put((x, env, flip)) for x in tree[1:])
            out = -first if op == "neg" else first
            for x in others:
                out = out + x if op == "+" else out - x
            return out
        if op == "/":
            return put((tree[1], env, flip)) / self.value(tree[2], env)
        if op == "I":
            return put()
        if op == "if":
            return put((tree[2] if self.condition(tree[1], env) else tree[3], env, flip))
        if op == "sum":
            return self.matrix_sum(tree, env, lambda body, inner: put((body, inner, flip)))
        if op == "subst":
            return self._polynomial_in(tree, env, lambda power, inner: put((power, inner, flip)))
        return self._named(tree, env, lambda body, inner: put((body, inner, flip)), alone) if op in ("sym", "at") else None

    def matrix_sum(self, tree: Any, env: Mapping[str, Form], read: Callable[..., Symbolic]) -> Symbolic:
        """A sum over an index of matrices, which has a term unless they are of size 1 x 1."""
        _, name, low, high, body = tree
        first, last = self.index(low, env), self.index(high, env)
        if self.shape(tree, env) != (_ONE, _ONE) and not self.region.holds(plus(last, first, -1)):
            raise Unknown("a sum of matrices without terms")
        return self.total(first, last, lambda _, k: read(body, {**env, name: k}))

    def _polynomial_in(self, tree: Any, env: Mapping[str, Form], read: Callable[..., Symbolic]) -> Symbolic:
        """A product with p(F) as its factor, for a polynomial p = X_t with exponents 0 .. t."""
        _, p, matrix = tree
        if p[0] != "at" or p[1] not in self.supported or self.limited:
            raise Unknown("a value of a polynomial whose degree is not known")
        degree, name = self.index(p[-1], env), f"@{len(env)}"
        if not self.region.holds(degree):
            raise Unknown("a polynomial of negative index")
        return self.total({}, degree, lambda _, k: self.coefficient(p, k, env) * read(["^", matrix, ["sym", name]], {**env, name: k}))

    def _named(self, tree: Any, env: Mapping[str, Form], read: Callable[..., Symbolic], alone: bool) -> Symbolic | None:
        """What a name stands for; None where it is not opened, as in a product a matrix given by its entries."""
        name, args = tree[1], tuple(self.index(a, env) for a in tree[2:])
        d = self.definitions.get(name)
        if d is None:
            return None
        if d[0] == "rec":
            self._need_one_shape(d)
        if name in self.inverting:
            self._meet(name, args)
        if name in self.recursive:
            if (found := self._solved(name, args, read)) is not None:
                return found
            if not self._opens(d, args[-1]):
                if self.not_smaller(name, args[-1]):
                    raise Unknown(f"{name} at an index that is not smaller")
                return None
        elif name in self.closed or self._given_by_entries(tree) and not alone:
            return None
        return self.deeper(d, args, read)

    # ------------------------------------------------------------------ letters
    def _letters(self, parts: list[Part], i: Form, j: Form) -> Symbolic:
        """A product of letters as one atom; zero if one of them is, after the inverses in all of them have been met."""
        word: list[tuple[str, list[Form], bool, Form]] = []
        for tree, env, flip in parts:
            power: Form = _ONE
            if tree[0] == "^":
                tree, power = tree[1], self.index(tree[2], env)
                rows, cols = self.shape(tree, env)
                if not self.region.holds(power) or self.region.reduce(plus(rows, cols, -1)):
                    raise Unknown("a power with a negative exponent, or of a matrix that is not square")
            looked_at = power is _ONE and tree[0] == "at" and tree[1] in self.recursive  # at its index
            if not looked_at and self.hides(tree, env):
                raise Unknown("a recursion in a term that is not opened, at an index that may not be smaller")
            text, forms = self.text(tree, env)
            if self.inverts(tree):
                self._meet(text, forms)
            if not power:
                continue
            flip = self._flipped(text, flip)
            if word and word[-1][:3] == (text, forms, flip):
                power = self.region.reduce(plus(power, word.pop()[3]))
            word.append((text, forms, flip, power))
        if any(tree[0] == "O" for tree, _, _ in parts):
            return self.number(0)
        if not word:
            return self.number(int(self.region.zero(plus(i, j, -1))))
        if len(word) == 1 and word[0][3] == _ONE and (tree := parsed(word[0][0]))[0] == "sym" and tree[1] in self.sequences:
            self._need_first(i if word[0][2] else j)
            return self.atom(("at", tree[1], form_key(j if word[0][2] else i)))
        ways = [(*_written(word), form_key(i), form_key(j)), (*_written(self._transposed(word)), form_key(j), form_key(i))]
        moves = any(name.startswith("#") for place in ways[0][1:] for name, _ in place)  # then indices are no reason, as they move in a sum
        return self.atom(("word", *min(ways, key=lambda way: (way[0].count('["T", '), *(way[:1] if moves else way)))))

    def _transposed(self, word: list[tuple[str, list[Form], bool, Form]]) -> list[tuple[str, list[Form], bool, Form]]:
        return [(text, forms, self._flipped(text, not flip), power) for text, forms, flip, power in reversed(word)]

    def _flipped(self, text: str, flip: bool) -> bool:
        """Whether a letter is transposed: one that is symmetric is not."""
        return flip and not ((tree := parsed(text))[0] == "sym" and tree[1] in self.known.symmetric)

    def again(self, key: tuple) -> Symbolic:
        """A word with other indices: where an exponent is zero now, or two letters are the same, it is another one."""
        *forms, i, j = (self.region.reduce(dict(x)) for x in key[2:])
        return self.word([(with_names(key[1]), {f"@{k}": x for k, x in enumerate(forms)}, False)], i, j)


def _written(word: list[tuple[str, list[Form], bool, Form]]) -> tuple:
    """Text of a word without its indices, and these."""
    trees, places = list[Any](), list[Form]()
    for text, forms, flip, power in word:
        tree = parsed(text, len(places))
        places += forms
        if power != _ONE:
            tree, places = ["^", tree, ["#", len(places)]], [*places, power]
        trees.append(["T", tree] if flip else tree)
    return json.dumps(["*", *trees] if len(trees) > 1 else trees[0]), *map(form_key, places)
