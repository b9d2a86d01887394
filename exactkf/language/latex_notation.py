# SPDX-License-Identifier: MIT
"""LaTeX notation for trees; `exactkf.language.latex` is the way in."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

from exactkf.language.names import Name, tex_name
from exactkf.language.notation import Bind, Form, Notation, rows_of

__all__ = ["LaTeX"]

_COUNT = r"\#\{\,%s : #1=0\,\}"


class LaTeX(Notation):
    """LaTeX notation.

    Parameters
    ----------
    values, functions : collection of str
        See `Notation`.
    tex : mapping of name to LaTeX
        Overrides how a name is printed.
    small : bool
        Write fractions with a slash, as in an index or exponent.
    """

    forms = {
        "z": Form(Bind.ATOM, "z"),
        "-": Form(Bind.SUM, "#1 - #2", (Bind.SUM, Bind.BIG)),
        "/": Form(Bind.FRACTION, r"\frac{#1}{#2}"),
        "sqrt": Form(Bind.FRACTION, r"\sqrt{#1}"),
        "cospi": Form(Bind.ATOM, r"\cos\left(\frac{#1}{#2}\,\pi\right)"),
        "abs": Form(Bind.ATOM, r"\left|#1\right|"),
        "T": Form(Bind.POWER, "#1'", (Bind.ATOM,)),
        "inv": Form(Bind.POWER, "#1^{-1}", (Bind.ATOM,)),
        "det": Form(Bind.ATOM, r"\det\left(#1\right)"),
        "tr": Form(Bind.ATOM, r"\operatorname{tr}\left(#1\right)"),
        "rank": Form(Bind.ATOM, r"\operatorname{rank}\left(#1\right)"),
        "charpoly": Form(Bind.ATOM, r"\det\left(zI - #1\right)", (Bind.BIG,)),
        "stein": Form(Bind.ATOM, r"\operatorname{stein}\left(#1, #2\right)"),
        "kernel": Form(Bind.ATOM, r"\operatorname{null}\left(#1\right)"),
        "nrows": Form(Bind.ATOM, r"\operatorname{rows}\left(#1\right)"),
        "ncols": Form(Bind.ATOM, r"\operatorname{cols}\left(#1\right)"),
        "deg": Form(Bind.ATOM, r"\deg\left(#1\right)"),
        # the brackets in braces: at the head of a row of a matrix TeX would read them as an option
        "coeff": Form(Bind.PRODUCT, r"{[z^{#2}]}\,#1", (Bind.POWER, Bind.LOOSE)),
        "roots_in": Form(Bind.ATOM, _COUNT % r"\left|z\right|<1"),
        "roots_on": Form(Bind.ATOM, _COUNT % r"\left|z\right|=1"),
        "roots_out": Form(Bind.ATOM, _COUNT % r"\left|z\right|>1"),
        "real_roots": Form(Bind.ATOM, _COUNT % r"#2<z\le #3", (Bind.SUM, Bind.SUM, Bind.SUM)),
        "loewner": Form(Bind.RELATION, r"#1 \succeq #2", (Bind.SUM,)),
        "psd": Form(Bind.RELATION, r"#1 \succeq 0", (Bind.SUM,)),
        "pd": Form(Bind.RELATION, r"#1 \succ 0", (Bind.SUM,)),
        "symmetric": Form(Bind.RELATION, r"#1\ \text{symmetric}", (Bind.SUM,)),
        "invertible": Form(Bind.RELATION, r"#1\ \text{invertible}", (Bind.SUM,)),
        "symplectic": Form(Bind.RELATION, r"#1\ \text{symplectic}", (Bind.SUM,)),
        "observable": Form(Bind.RELATION, r"(#1, #2)\ \text{observable}"),
        "detectable": Form(Bind.RELATION, r"(#1, #2)\ \text{detectable}"),
        "schur": Form(Bind.RELATION, r"#1\ \text{Schur stable}", (Bind.SUM,)),
        "defined": Form(Bind.RELATION, r"#1\ \text{defined}", (Bind.SUM,)),
        "similar": Form(Bind.RELATION, r"#1 \sim #2", (Bind.SUM,)),
        "cospectral": Form(Bind.RELATION, r"\det\left(zI - #1\right) = \det\left(zI - #2\right)", (Bind.BIG,)),
        "coprime": Form(Bind.RELATION, r"#1,\ #2\ \text{coprime}", (Bind.SUM,)),
        "pos_circle": Form(Bind.RELATION, r"#1 > 0\ \text{on}\ \left|z\right|=1", (Bind.SUM,)),
        "nonneg_circle": Form(Bind.RELATION, r"#1 \ge 0\ \text{on}\ \left|z\right|=1", (Bind.SUM,)),
        "not": Form(Bind.NOT, r"\neg #1", (Bind.ATOM,)),
        "<=>": Form(Bind.IMPLIES, r"#1 \;\Longleftrightarrow\; #2", (Bind.OR,)),
    }
    relations = {"=": " = ", "!=": r" \neq ", "<": " < ", "<=": r" \le ", ">": " > ", ">=": r" \ge "}
    joints = {"and": r"\ \text{and}\ ", "or": r"\ \text{or}\ ", "=>": r" \;\Longrightarrow\; "}

    def __init__(self, values: Collection[str] = (), functions: Collection[str] = (),
                 tex: Mapping[str, str] | None = None, small: bool = False) -> None:
        super().__init__(values, functions)
        self.tex = dict(tex or {})
        self.small = small

    def parens(self, text: str) -> str:
        return rf"\left({text}\right)"

    def script(self, tree: Any, need: int = Bind.LOOSE) -> str:
        """An index or exponent: fractions with a slash."""
        return LaTeX(self.values, self.functions, self.tex, small=True).arg(tree, need)

    def show(self, tree: Any) -> tuple[str, int]:
        if self.small and isinstance(tree, tuple) and tree[:1] == ("/",):
            return self.arg(tree[1], Bind.PRODUCT) + "/" + self.arg(tree[2], Bind.POWER), Bind.PRODUCT
        return super().show(tree)

    def parts(self, name: str) -> Name:
        """The name in pieces."""
        return Name(self.tex[name]) if name in self.tex else tex_name(name)

    def name(self, name: str) -> tuple[str, int]:
        parts = self.parts(name)
        return parts.tex(), (Bind.POWER if parts.sup else Bind.ATOM)

    def rational(self, over: int, under: int) -> tuple[str, int]:
        if self.small:
            return f"{over}/{under}", (Bind.PRODUCT if over >= 0 else Bind.NEGATIVE)
        sign = "-" if over < 0 else ""
        return rf"{sign}\frac{{{abs(over)}}}{{{under}}}", (Bind.NEGATIVE if sign else Bind.FRACTION)

    def at(self, name: str, *args: Any) -> tuple[str, int]:
        parts = self.parts(name)
        if self.is_subscripted(name, args):
            return parts.tex(*(self.script(a) for a in args)), (Bind.POWER if parts.sup else Bind.ATOM)
        return parts.tex() + rf"\left({self.list_of(args)}\right)", Bind.ATOM

    def entry(self, base: Any, *index: Any) -> tuple[str, int]:
        low = [self.script(i) for i in index]
        joint = "" if all(len(i) == 1 for i in low) else ","
        if isinstance(base, tuple) and base[0] == "sym":
            parts = self.parts(base[1])
            if not parts.sub and not parts.sup:
                return parts.tex(joint.join(low)), Bind.ATOM
        return f"{self.parens(self(base))}_{{{joint.join(low)}}}", Bind.ATOM

    def times(self, *args: Any) -> tuple[str, int]:
        last, strength = self.signed_first(args[0], Bind.FRACTION)
        out = last
        for before, arg in zip(args, args[1:], strict=False):
            text = self.arg(arg, Bind.FRACTION)
            out, last = out + _between(last, text, _numeral(before)) + text, text
        return out, strength

    def power(self, base: Any, exponent: Any) -> tuple[str, int]:
        return f"{self.arg(base, Bind.ATOM)}^{{{self.script(exponent)}}}", Bind.POWER

    def cases(self, condition: Any, then: Any, otherwise: Any) -> tuple[str, int]:
        lines = [rf"{self(then)} & \text{{if}}\ {self(condition)}"]
        while isinstance(otherwise, tuple) and otherwise[0] == "if":
            lines.append(rf"{self(otherwise[2])} & \text{{if}}\ {self(otherwise[1])}")
            otherwise = otherwise[3]
        lines.append(rf"{self(otherwise)} & \text{{otherwise}}")
        return r"\begin{cases}" + r" \\ ".join(lines) + r"\end{cases}", Bind.CASES

    def _big(self, sign: str, index: str, low: Any, high: Any, body: Any) -> tuple[str, int]:
        scope = f"_{{{self.name(index)[0]}={self.script(low)}}}^{{{self.script(high)}}}"
        return f"{sign}{scope} {self.arg(body, Bind.BIG)}", Bind.BIG

    def sum_of(self, *args: Any) -> tuple[str, int]:
        return self._big(r"\sum", *args)

    def product_of(self, *args: Any) -> tuple[str, int]:
        return self._big(r"\prod", *args)

    def mat(self, i: str, j: str, nrows: Any, ncols: Any, body: Any) -> tuple[str, int]:
        part = rows_of((i, j, nrows, ncols, body))
        if part:
            return rf"\operatorname{{{part}}}_{{{self.script(nrows)}}}\left({self(body[1])}\right)", Bind.ATOM
        height, width = self.script(nrows), self.script(ncols)
        upper = height if height == width else f"{height},{width}"
        return rf"\left[{self(body)}\right]_{{{self(('sym', i))},{self(('sym', j))}=1}}^{{{upper}}}", Bind.POWER

    def col(self, i: str, length: Any, body: Any) -> tuple[str, int]:
        return rf"\left[{self(body)}\right]_{{{self(('sym', i))}=1}}^{{{self.script(length)}}}", Bind.POWER

    def block(self, *table: Any) -> tuple[str, int]:
        lines = r" \\ ".join(" & ".join(self(x) for x in row) for row in table)
        return rf"\begin{{bmatrix}}{lines}\end{{bmatrix}}", Bind.ATOM

    rows = block

    def diag(self, *args: Any) -> tuple[str, int]:
        return rf"\operatorname{{diag}}\left({self.list_of(args)}\right)", Bind.ATOM

    def identity(self, size: Any) -> tuple[str, int]:
        return f"I_{{{self.script(size)}}}", Bind.ATOM

    def zero(self, nrows: Any, ncols: Any) -> tuple[str, int]:
        return rf"0_{{{self.script(nrows, Bind.PRODUCT)}\times {self.script(ncols, Bind.PRODUCT)}}}", Bind.ATOM

    def _value(self, poly: Any, point: str) -> str:
        """p(x) for a name p, [compound] at z -> x otherwise."""
        text = self(poly)
        named = isinstance(poly, tuple) and poly[0] in ("sym", "at") and not text.endswith(")")
        return f"{text}({point})" if named else rf"\left[{text}\right]_{{z\to {point}}}"

    def laurent(self, function: Any, k: Any) -> tuple[str, int]:
        power = str(-k) if isinstance(k, int) else f"-{self.script(k, Bind.POWER)}"
        return rf"{{[z^{{{power}}}]}}_{{\infty}}\,{self.arg(function, Bind.POWER)}", Bind.PRODUCT

    def recip(self, poly: Any) -> tuple[str, int]:
        return self._value(poly, "1/z"), Bind.ATOM

    def rev(self, poly: Any, degree: Any) -> tuple[str, int]:
        return f"z^{{{self.script(degree)}}} {self._value(poly, '1/z')}", Bind.PRODUCT

    def subst(self, poly: Any, point: Any) -> tuple[str, int]:
        return self._value(poly, self.script(point)), Bind.ATOM

    def prints(self, value: Any, printed: Any) -> tuple[str, int]:
        if not isinstance(printed, str):
            lines = r" \\ ".join(" & ".join(row) for row in printed)
            printed = rf"\begin{{bmatrix}}{lines}\end{{bmatrix}}"
        return rf"{self.arg(value, Bind.SUM)} \doteq {printed}", Bind.RELATION

    def _quantifier(self, sign: str, index: str, low: Any, high: Any, body: Any) -> tuple[str, int]:
        scope = rf"{self.arg(low, Bind.SUM)}\le {self.name(index)[0]}\le {self.arg(high, Bind.SUM)}"
        return rf"{sign}\,{scope}:\; {self(body)}", Bind.QUANTIFIER

    def every(self, *args: Any) -> tuple[str, int]:
        return self._quantifier(r"\forall", *args)

    def some(self, *args: Any) -> tuple[str, int]:
        return self._quantifier(r"\exists", *args)

    def always(self, index: str, body: Any) -> tuple[str, int]:
        return rf"\forall\,{self.name(index)[0]}\ge 0:\; {self(body)}", Bind.QUANTIFIER


def _between(left: str, right: str, after_numeral: bool) -> str:
    """What keeps two factors apart: nothing between letters, a dot where digits would run together."""
    if right[0].isdigit() or (after_numeral and right.startswith(r"\frac")):
        return r" \cdot "
    if (right.startswith(r"\left(") and not after_numeral) or r"\mathrm" in (left[:7], right[:7]):
        return r"\,"
    return " "


def _numeral(tree: Any) -> bool:
    return isinstance(tree, int) or (isinstance(tree, tuple) and tree[0] == "rat")
