# SPDX-License-Identifier: MIT
"""Completion in the free algebra, with cofactors.

Given relations g_i and a goal f, look for f = sum of c s l g_i r with words l, r
and monomials s in commuting scalars. The relations are completed by the
noncommutative Buchberger algorithm up to a degree; each rule remembers how it
came from others, and the cofactors of a goal are written out at the end. The
search is bounded by degree, number of rules and time, and proves nothing: the
checker expands what it returns. Where words are 1 x 1 they become scalars, which
commute and equal their transposes.

A system of rules is kept for the next goals with the same relations.

Main definitions
----------------
`System`
    Relations under completion; `System.express` writes a goal in them.
`Stuck`
    How far a search got that found nothing.

Notation: a monomial is one string: a character for each letter of the word, then
one for each scalar (and another for its inverse), sorted. Monomials are ordered by
the length of the word, the word, then the scalars. Reference: Mora (1986), Groebner
bases for non-commutative polynomial rings.
"""

from __future__ import annotations

import heapq
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from exactkf.finders.effort import clock, spend
from exactkf.kernel.reader import Reader
from exactkf.kernel.words import Poly, Relation, times_scalars

__all__ = ["COMPLETE", "NO_MORE", "OUT_OF_TIME", "TOO_MANY", "Stuck", "System", "system_of"]

OUT_OF_TIME, TOO_MANY, NO_MORE, COMPLETE = "out of time", "too many rules", "no more overlaps up to this degree", "the assumptions are completed"
_FIRST_LETTER, _FIRST_SCALAR = 0x100, 0x8000  # characters; those of a scalar and its inverse differ in the last bit
_MOST_RULES = 600
_SEARCHED = 5  # steps that it takes to look for a rule
_ONE_ROW = (("", 1),)

Origin = list[tuple[Any, str, Any, str, str]]  # c, left, rule or name, right, scalars


@dataclass(frozen=True)
class Stuck:
    """How far a search got: why it ended, rules and degree reached, what is left of the goal."""

    reason: str
    rules: int = 0
    degree: int = 0
    remainder: str = ""

    def __str__(self) -> str:
        if not self.rules:
            return self.reason
        return f"{self.reason}: {self.rules} rules, words up to length {self.degree}; left over: {self.remainder}"


class _Rule:
    """A monic polynomial: leading monomial word and scalars, the other terms, and how it came about."""

    __slots__ = ("lead", "number", "origin", "scalars", "tail")

    def __init__(self, lead: str, scalars: str, tail: dict[str, Any], origin: Origin, number: int) -> None:
        self.lead, self.scalars, self.tail, self.origin, self.number = lead, scalars, tail, origin, number


class System:
    """Relations under completion.

    Parameters
    ----------
    reader : Reader
        Of a statement with these relations.
    assumed : mapping of name to Relation
    degree : int
        Longest leading word of an overlap that is looked at.
    """

    def __init__(self, reader: Reader, assumed: Mapping[str, Relation], degree: int) -> None:
        self.reader, self.degree = reader, degree
        self.chars: dict[Any, str] = {}
        self.names: dict[str, Any] = {}
        self.scalar_chars = ""
        self.mixed = False  # scalars, or words that are scalars, occur
        self.rules: dict[str, list[_Rule]] = {}
        self.lengths: list[int] = []
        self.hits: dict[str, Any] = {}
        self.queue: list[tuple] = []
        self.count = self.made = self.reached = 0
        self.deadline = float("inf")
        self.cut = False  # an overlap was longer than the degree allows
        self.written: dict[int, dict] = {}
        self.assumed = dict(assumed)
        self.rows: Any = None  # of the polynomial that is being reduced
        #: relations p q = 1, with p, by the name of q
        self.quotients = {name: (f"quotient {n}", p) for n, (p, name) in enumerate(reader.quotients, 1) if f"quotient {n}" in assumed}
        self.waiting = sorted(assumed.items(), key=lambda item: (max((len(w) for _, w in item[1].poly), default=0), item[0]))

    # ------------------------------------------------------------------ monomials
    def _char(self, name: str) -> str:
        if name not in self.chars:
            self.chars[name] = ch = chr(_FIRST_LETTER + len(self.chars))
            self.names[ch] = name
            rows, cols = self.reader.sizes[name]
            self.mixed = self.mixed or rows == _ONE_ROW or cols == _ONE_ROW
        return self.chars[name]

    def _scalar_char(self, name: str, inverse: bool = False) -> str:
        if ("scalar", name) not in self.chars:
            ch = chr(_FIRST_SCALAR + 2 * sum(isinstance(k, tuple) for k in self.chars))
            self.chars["scalar", name] = ch
            self.names[ch] = name
            self.scalar_chars += ch + chr(ord(ch) + 1)
            self.mixed = True
        ch = self.chars["scalar", name]
        return chr(ord(ch) + 1) if inverse else ch

    def encode(self, p: Poly) -> dict[str, Any]:
        """A polynomial with monomials as strings. What a scalar stands for becomes a rule."""
        # in the order of appearance: that of a set of names is another in each run, and the certificate would be too
        for name in dict.fromkeys(n for s, _ in p for n, _ in s if n in self.reader.numbers and ("scalar", n) not in self.chars):
            own = self.reader.numbers[name]
            for word in dict.fromkeys((own, tuple(self.reader.transposed[a] for a in reversed(own)))):
                self._insert({"".join(map(self._char, word)): 1, self._scalar_char(name): -1}, [(1, "", word, "", "")])
        return {"".join(map(self._char, word)) + "".join(sorted("".join(self._scalar_char(n, e < 0) * abs(e) for n, e in s))): c
                for (s, word), c in p.items()}

    def decode(self, key: str) -> tuple[list[list], list[str]]:
        """Scalars and word of a monomial."""
        word = self._word(key)
        powers: dict[str, int] = {}
        for ch in key[len(word):]:
            name = self.names[chr(ord(ch) & ~1)]
            powers[name] = powers.get(name, 0) + (-1 if ord(ch) & 1 else 1)
        return [[n, e] for n, e in sorted(powers.items())], [self.names[ch] for ch in word]

    def _word(self, key: str) -> str:
        return key.rstrip(self.scalar_chars) if self.scalar_chars else key

    def _join(self, left: str, key: str, right: str, scalars: str) -> str:
        if not self.scalar_chars:
            return left + key + right
        word = self._word(key)
        return left + word + right + _product(key[len(word):], scalars)

    def _order(self, key: str) -> tuple:
        word = self._word(key)
        return (len(word), word, len(key), key)

    # ------------------------------------------------------------------ goals
    def express(self, goal: Poly, deadline: float) -> list[list] | Stuck:
        """Terms [c, left, name, right] (with scalars as a fifth entry, where there are) that add up to the goal."""
        found = self._express(goal, deadline)
        powers = {n: max(-e for s, _ in goal for m, e in s if m == n) for s, _ in goal for n, e in s if e < 0}
        if not isinstance(found, Stuck) or not powers:
            return found
        above, below = (tuple(sorted((n, sign * e) for n, e in powers.items())) for sign in (1, -1))
        cleared = self._express({(times_scalars(s, above), word): c for (s, word), c in goal.items()}, deadline)
        if isinstance(cleared, Stuck):
            return found
        return [[*term[:4], [list(x) for x in times_scalars(tuple((n, e) for n, e in (term[4] if len(term) > 4 else ())), below)]] for term in cleared]

    def _express(self, goal: Poly, deadline: float) -> list[list] | Stuck:
        self.deadline = deadline
        rest, used = self._reduce(self.encode(goal))
        while rest:
            if clock() > deadline:
                return self._stuck(OUT_OF_TIME, rest)
            if not self._grow():
                return self._stuck(self._end(clock() > deadline), rest)
            rest, more = self._reduce(rest)
            used += more
        total: dict = {}
        for c, left, rule, right, scalars in used:
            self._write(total, c, left, rule, right, scalars)
        return self._listed(total)

    def normal_form(self, p: Poly, deadline: float) -> dict[str, Any]:
        """What is left of a polynomial, by keys that are the same for all from when on no rule is added."""
        self._complete(deadline)
        return self._reduce(self.encode(p))[0]

    def bound(self, deadline: float) -> str:
        """What the completion ends at, in the words of `Stuck`."""
        self._complete(deadline)
        return self._end(clock() >= deadline)

    def _complete(self, deadline: float) -> None:
        """Add rules as long as there are any and there is time."""
        self.deadline = deadline
        while clock() < deadline and self._grow():
            pass

    def _end(self, late: bool) -> str:
        """Why no rule was added any more."""
        return OUT_OF_TIME if late else TOO_MANY if self.queue else NO_MORE if self.cut else COMPLETE

    def _listed(self, total: dict) -> list[list]:
        out = []
        for (left, name, right, scalars), c in total.items():
            if isinstance(name, _Rule):  # an equation between numbers, with its proof: it may stand in any size
                equation = [[str(v), self.decode(key)[0]] for key, v in {name.scalars: 1, **name.tail}.items()]
                shown: Any = {"numbers": equation, "terms": self._listed(self._written(name))}
            else:
                shown = name if isinstance(name, str) else list(name)
            term = [str(c), self.decode(left)[1], shown, self.decode(right)[1]]
            out.append(term + ([self.decode(scalars)[0]] if scalars else []))
        return out

    def _stuck(self, reason: str, rest: dict[str, Any]) -> Stuck:
        largest = sorted(rest, key=self._order, reverse=True)[:4]
        shown = []
        for key in largest:
            scalars, word = self.decode(key)
            body = "*".join([*(n if e == 1 else f"{n}^{e}" for n, e in scalars), *word]) or "I"
            shown.append(body if rest[key] == 1 else f"{rest[key]}*{body}")
        more = f" + ... ({len(rest)} terms)" if len(rest) > len(largest) else ""
        return Stuck(reason, sum(map(len, self.rules.values())), self.reached, " + ".join(shown) + more)

    def _write(self, total: dict, c: Any, left: str, ref: Any, right: str, scalars: str) -> None:
        """Add a multiple of a rule, in terms of the relations."""
        if not isinstance(ref, _Rule) or self._between_numbers(ref):
            _bump(total, (left, ref, right, scalars), c)
            return
        for (le, name, ri, s), a in self._written(ref).items():
            _bump(total, (left + le, name, ri + right, _product(s, scalars)), c * a)

    def _between_numbers(self, rule: _Rule) -> bool:
        if not rule.scalars:  # 1 = 0 is I = 0 for one size, and not an equation between numbers
            return False
        return not rule.lead and (len(rule.origin) > 1 or isinstance(rule.origin[0][2], _Rule)) and not any(map(self._word, rule.tail))

    def _written(self, rule: _Rule) -> dict:
        """A rule as multiples of the relations."""
        if rule.number not in self.written:
            own: dict = {}
            for a, left, ref, right, s in rule.origin:
                self._write(own, a, left, ref, right, s)
            self.written[rule.number] = own
        return self.written[rule.number]

    # ------------------------------------------------------------------ reduction
    def _reduce(self, p: dict[str, Any]) -> tuple[dict[str, Any], Origin]:
        """What no rule applies to, and the multiples of rules that were taken off."""
        self.rows = next((self._rows(word, 0) for key in p if (word := self._word(key))), None)
        pending, done, used = dict(p), dict[str, Any](), list[Any]()
        heap = [(-len(key), key) for key in pending]
        heapq.heapify(heap)
        steps = 0
        while heap:
            _, key = heapq.heappop(heap)
            steps += 1
            c = pending.pop(key, 0)
            if not c:
                continue
            hit = self._match(key)
            if hit is None:
                _bump(done, key, c)
                continue
            rule, left, right, scalars = hit
            for k, v in rule.tail.items():
                new = self._join(left, k, right, scalars)
                if new not in pending:
                    heapq.heappush(heap, (-len(new), new))
                    pending[new] = -c * v
                else:
                    pending[new] -= c * v
            used.append((c, left, rule, right, scalars))
            steps += len(rule.tail)
            if not len(used) & 1023:
                spend(steps)
                steps = 0
                if clock() > self.deadline:
                    for k, v in pending.items():
                        _bump(done, k, v)
                    break
        spend(steps)
        return done, used

    def _match(self, key: str) -> tuple | None:
        """A rule that applies, with what stands around its leading monomial."""
        if key in self.hits:
            return self.hits[key]
        word = self._word(key)
        spend(_SEARCHED)
        found = self._search(word, key[len(word):])
        if found is None and self.mixed:
            found = self._number_in(word, key[len(word):])
        if word:  # what applies to an empty word depends on the size
            self.hits[key] = found
        return found

    def _search(self, word: str, scalars: str) -> tuple | None:
        for n in self.lengths:
            for at in range(len(word) - n + 1):
                for rule in self.rules.get(word[at:at + n], ()):
                    if not rule.scalars:
                        if not n and self._rows(word, at) not in (None, self._rows_of(rule)):
                            continue  # I = 0, of one size
                        return rule, word[:at], word[at + n:], scalars
                    if (rest := _quotient(scalars, rule.scalars)) is not None:
                        return rule, word[:at], word[at + n:], rest
        return None

    def _rows(self, word: str, at: int) -> Any:
        """Size between two letters of a word; of an empty word, that of the polynomial it stands in, if that is known."""
        if not word:
            return self.rows
        return self.reader.sizes[self.names[word[at]]][0] if at < len(word) else self.reader.sizes[self.names[word[-1]]][1]

    def _rows_of(self, rule: _Rule) -> Any:
        """Number of rows of a relation, by the way it came about."""
        for _, left, ref, _right, _scalars in rule.origin:
            if left:
                return self._rows(left, 0)
            if isinstance(ref, str) and self.assumed[ref].rows is not None:
                return self.assumed[ref].rows
            if isinstance(ref, _Rule) and (ref.lead or ref.tail or not ref.scalars):
                return self._rows(ref.lead, 0) if ref.lead else self._rows_of(ref)
        return _ONE_ROW

    def _number_in(self, word: str, scalars: str) -> tuple | None:
        """A shortest 1 x 1 part of a word becomes a scalar, by a new rule."""
        best: tuple[int, int] | None = None
        start = None
        for at, ch in enumerate(word):
            rows, cols = self.reader.sizes[self.names[ch]]
            if rows == _ONE_ROW:
                start = at
            if cols == _ONE_ROW and start is not None and (best is None or at + 1 - start < best[1] - best[0]):
                best = start, at + 1
        if best is None:
            return None
        part = word[best[0]:best[1]]
        letters = tuple(self.names[ch] for ch in part)
        rule = self._add(part, "", {self._scalar_char(self.reader.scalar_name(letters)): -1}, [(1, "", letters, "", "")])
        return rule, word[:best[0]], word[best[1]:], scalars

    # ------------------------------------------------------------------ rules
    def _insert(self, p: dict[str, Any], origin: Origin) -> bool:
        p, used = self._reduce(p)
        if not p:
            return False
        origin = origin + [(-c, left, rule, right, s) for c, left, rule, right, s in used]
        if self.scalar_chars:
            p, origin = self._without_units(p, origin)
        lead = max(p, key=self._order)
        c = p.pop(lead)
        if c != 1:
            p, origin = {k: _over(v, c) for k, v in p.items()}, [(_over(a, c), *rest) for a, *rest in origin]  # type: ignore[misc]
        word = self._word(lead)
        self._add(word, lead[len(word):], p, origin)
        return True

    def _without_units(self, p: dict[str, Any], origin: Origin) -> tuple[dict[str, Any], Origin]:
        """Divided by scalars that do not vanish, so that none of them is in every term, or in the leading one."""
        lead = self._word(max(p, key=self._order))
        leading = [key for key in p if self._word(key) == lead]
        pick = leading if len(leading) == 1 else list(p)
        factor = ""
        for name in sorted(self.reader.units):
            if ("scalar", name) not in self.chars:
                continue
            ch, inverse = self._scalar_char(name), self._scalar_char(name, True)
            least = min(key.count(ch) - key.count(inverse) for key in pick)
            factor += inverse * least if least > 0 else ch * -least
            if least > 0 and name in self.quotients:
                self._turn_over(name, inverse)
        if not factor:
            return p, origin
        factor = "".join(sorted(factor))
        return ({self._join("", k, "", factor): v for k, v in p.items()},
                [(c, left, ref, right, _product(s, factor)) for c, left, ref, right, s in origin])

    def _turn_over(self, name: str, inverse: str) -> None:
        """A relation p q = 1 as the rule 1/q -> p, from when on 1/q comes up."""
        relation, p = self.quotients.pop(name)
        self._add("", inverse, {key: -c for key, c in self.encode(p).items()}, [(-1, "", relation, "", inverse)])

    def _add(self, lead: str, scalars: str, tail: dict[str, Any], origin: Origin) -> _Rule:
        self.made += 1
        rule = _Rule(lead, scalars, tail, origin, self.made)
        every = [r for rules in self.rules.values() for r in rules] if lead or scalars else []
        old = [r for r in every if lead in r.lead and _quotient(r.scalars, scalars) is not None]
        for r in old:
            self.rules[r.lead].remove(r)
            if not self.rules[r.lead]:
                del self.rules[r.lead]
        self.rules.setdefault(lead, []).append(rule)
        self.lengths = sorted({len(x) for x in self.rules})
        self.hits.clear()
        spend(2 * sum(map(len, self.rules.values())))
        for rules in list(self.rules.values()):
            for other in rules:
                self._pairs(rule, other)
                if other is not rule:
                    self._pairs(other, rule)
        for r in old:
            self._insert({r.lead + r.scalars: 1, **r.tail}, [(1, "", r, "", "")])
        return rule

    def _pairs(self, first: _Rule, second: _Rule) -> None:
        """Words that start with the first leading word and end with the second; and the second in the first, where scalars differ."""
        u, v = first.lead, second.lead
        for k in range(1, min(len(u), len(v))):
            if u[-k:] == v[:k]:
                self._push(len(u) + len(v) - k, first, v[k:], second, u[:-k], "")
        if first is not second and (first.scalars or second.scalars) and v in u:
            common = set(first.scalars) & set(second.scalars)
            if v or common:
                at = u.find(v)
                self._push(len(u), first, "", second, u[:at], u[at + len(v):])

    def _push(self, length: int, *pair: Any) -> None:
        self.cut = self.cut or length > self.degree
        if length <= self.degree:
            self.count += 1
            heapq.heappush(self.queue, (length + len(pair[0].scalars) + len(pair[2].scalars), self.count, length, pair))

    def _grow(self) -> bool:
        """Take in relations, then treat overlaps until one gives a new rule."""
        while self.waiting:
            name, relation = self.waiting.pop(0)
            if self._insert(self.encode(relation.poly), [(1, "", name, "", "")]):
                return True
        while self.queue and sum(map(len, self.rules.values())) < _MOST_RULES:
            if clock() > self.deadline:
                return False
            _, _, length, (first, right, second, left, behind) = heapq.heappop(self.queue)
            whole = _least_common(first.scalars, second.scalars)
            a, b = _quotient(whole, first.scalars) or "", _quotient(whole, second.scalars) or ""
            p: dict[str, Any] = {}
            for key, v in first.tail.items():
                _bump(p, self._join("", key, right, a), v)
            for key, v in second.tail.items():
                _bump(p, self._join(left, key, behind, b), -v)
            self.reached = max(self.reached, length)
            if self._insert(p, [(1, "", first, right, a), (-1, left, second, behind, b)]):
                return True
        return False


# ---------------------------------------------------------------------- systems that are kept
_KEPT: dict[Any, System] = {}
_MOST_KEPT = 24


def system_of(reader: Reader, assumed: Mapping[str, Relation], degree: int) -> System:
    """The system of these relations, with the rules that earlier goals have made."""
    key = (degree, tuple(sorted((name, tuple(sorted(r.poly.items()))) for name, r in assumed.items())),
           tuple(sorted(reader.sizes.items())), tuple(sorted(reader.units)))
    found = _KEPT.pop(key, None) or System(reader, assumed, degree)
    _KEPT[key] = found
    if len(_KEPT) > _MOST_KEPT:
        del _KEPT[next(iter(_KEPT))]
    return found


# ---------------------------------------------------------------------- scalars and numbers
def _product(s: str, t: str) -> str:
    if not s or not t:
        return s or t
    both = sorted(s + t)
    out: list[str] = []
    for ch in both:  # a scalar stands right before its inverse
        if out and ord(ch) & 1 and ord(out[-1]) == ord(ch) - 1:
            out.pop()
        else:
            out.append(ch)
    return "".join(out)


def _quotient(s: str, t: str) -> str | None:
    """s / t, or None if t does not divide s."""
    for ch in t:
        if ch not in s:
            return None
        s = s.replace(ch, "", 1)
    return s


def _least_common(s: str, t: str) -> str:
    return "".join(ch * max(s.count(ch), t.count(ch)) for ch in sorted(set(s + t)))


def _over(x: Any, y: Any) -> Any:
    q = Fraction(x) / y
    return q.numerator if q.denominator == 1 else q


def _bump(table: dict[Any, Any], key: Any, by: Any) -> None:
    s = table.get(key, 0) + by
    if s:
        table[key] = s
    else:
        table.pop(key, None)

