# SPDX-License-Identifier: MIT
r"""LaTeX of terms and statements, made from the checked tree.

Main definitions
----------------
`latex`
    LaTeX of one tree.
`statement_latex`
    The whole statement: variables, definitions, hypotheses, conclusion.
`says_latex`, `says_lines`, `over_latex`, `where_latex`, `given_latex`
    Its parts.
`type_latex`, `definition_latex`
    One typed variable, one definition.

Trees may be tuples or, as JSON has them, lists.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import groupby
from typing import Any

from exactkf.language.latex_notation import LaTeX
from exactkf.language.notation import RANGES, Bind, fill, values_and_trees
from exactkf.language.statement import Statement, as_tuples

__all__ = [
    "definition_latex", "given_latex", "latex", "over_latex", "says_latex", "says_lines", "statement_latex",
    "type_latex", "where_latex",
]

#: type -> LaTeX; #1 is the names, #2 and #3 the type's arguments
_TYPES = {
    "scalar": r"#1\in\mathbb{R}",
    "nonzero": r"#1\in\mathbb{R}\setminus\{0\}",
    "positive": r"#1>0",
    "nonneg": r"#1\ge 0",
    "integer": r"#1\in\{#2,\dots,#3\}",
    "sequence": r"#1\in\mathbb{R}",
    "signal": r"#1\in\mathbb{R}",
    "matrix": r"#1\in\mathbb{R}^{#2\times #3}",
    "symmetric": r"#1\in\mathbb{R}^{#2\times #2}\ \text{symmetric}",
    "psd": r"#1\in\mathbb{R}^{#2\times #2},\ #1\succeq 0",
    "pd": r"#1\in\mathbb{R}^{#2\times #2},\ #1\succ 0",
    "nonsingular": r"#1\in\mathbb{R}^{#2\times #2}\ \text{invertible}",
    "diagonal": r"#1\in\mathbb{R}^{#2\times #2}\ \text{diagonal}",
    "poly": r"#1\in\mathbb{R}[z],\ \deg #1\le #2",
    "monic": r"#1\in\mathbb{R}[z]\ \text{monic of degree}\ #2",
}
_ALONE = ("psd", "pd", "poly")  # patterns that name the variable twice


def latex(tree: Any, tex: Mapping[str, str] | None = None) -> str:
    r"""LaTeX of a tree.

    Parameters
    ----------
    tree : tuple or int
        A term or formula, ``expr.tree``.
    tex : mapping of name to LaTeX, optional
        Overrides how a name is printed.

    Examples
    --------
    >>> from exactkf.language import symbols, T
    >>> Phi, P, H = symbols("Phi P H")
    >>> print(latex((Phi * P * T(Phi) + H).tree))
    \Phi P \Phi' + H
    """
    tree = as_tuples(tree)
    return LaTeX(functions=LaTeX().functions_in(tree), tex=tex)(tree)


def type_latex(name: str, type_: Any) -> str:
    r"""LaTeX of one typed variable.

    >>> print(type_latex("P", ("psd", ("sym", "n"))))
    P\in\mathbb{R}^{n\times n},\ P\succeq 0
    """
    printer, type_ = LaTeX(), as_tuples(type_)
    return _typed(printer, _variable(printer, name, type_), type_)


def definition_latex(definition: Any) -> str:
    """LaTeX of one definition, from `let`, `function` or `rec`."""
    definition = as_tuples(definition)
    return _definition(LaTeX(functions=LaTeX().functions_in(definition)), definition)


def says_latex(statement: Statement) -> str:
    """LaTeX of the conclusion."""
    return _printer(statement)(statement.says)


def says_lines(statement: Statement) -> list[str]:
    """LaTeX of the conclusion, the members of a conjunction apart."""
    printer, says = _printer(statement), statement.says
    parts = says[1:] if isinstance(says, tuple) and says[0] == "and" else [says]
    return [printer(part) for part in parts]


def over_latex(statement: Statement) -> list[str]:
    """LaTeX of the sizes and typed variables, those of one type together."""
    printer = _printer(statement)
    out = []
    if statement.sizes:
        out.append(rf"{printer.list_of([('sym', n) for n in statement.sizes])}\in\mathbb{{N}}_{{0}}")
    for type_, group in groupby(statement.over, key=lambda variable: variable[1]):
        names = [_variable(printer, name, type_) for name, _ in group]
        for name in names if type_[0] in _ALONE else [", ".join(names)]:
            out.append(_typed(printer, name, type_))
    return out


def where_latex(statement: Statement) -> list[str]:
    """LaTeX of the definitions, one each."""
    printer = _printer(statement)
    return [_definition(printer, d) for d in statement.where]


def given_latex(statement: Statement) -> list[list[str]]:
    """Hypotheses as ``[label, latex, "needed" or "standing"]``."""
    printer = _printer(statement)
    return [[label, printer(formula), kind] for label, formula, kind in statement.given]


def statement_latex(statement: Statement) -> str:
    r"""LaTeX of the whole statement, one line for each part it has.

    >>> from exactkf.language import Statement, nonzero, symbols
    >>> a, = symbols("a")
    >>> print(statement_latex(Statement(over={"a": nonzero()}, says=a / a == 1)))
    \begin{array}{l} \text{For}\ a\in\mathbb{R}\setminus\{0\}: \\ \frac{a}{a} = 1 \end{array}
    """
    over, where, given = over_latex(statement), where_latex(statement), [g[1] for g in given_latex(statement)]
    lines = [
        *([r"\text{For}\ " + r",\ ".join(over) + ":"] if over else []),
        *([r"\text{with}\ " + r";\quad ".join(where) + ":"] if where else []),
        *([r"\text{if}\ " + r"\ \text{and}\ ".join(given) + r"\ \text{then}"] if given else []),
        says_latex(statement),
    ]
    return lines[0] if len(lines) == 1 else r"\begin{array}{l} " + r" \\ ".join(lines) + r" \end{array}"


def _printer(statement: Statement) -> LaTeX:
    values, trees = values_and_trees(statement)
    return LaTeX(values, LaTeX(values).functions_in(trees), statement.tex)


def _variable(printer: LaTeX, name: str, type_: tuple) -> str:
    if type_[0] in ("signal", "signal_of"):
        first = printer(("at", name, type_[1]))
        return rf"{first},{printer(('at', name, _next(type_[1])))},\dots"
    if type_[0] not in ("sequence", "sequence_of"):
        return printer.name(name)[0]
    return rf"{printer(('at', name, type_[1]))},\dots,{printer(('at', name, type_[2]))}"


def _next(index: Any) -> Any:
    return index + 1 if isinstance(index, int) else ("+", index, 1)


def _typed(printer: LaTeX, names: str, type_: tuple) -> str:
    kind, *args = type_[-1] if type_[0] in ("sequence_of", "signal_of") else type_
    if kind == "matrix" and args[1] == 1:
        return rf"{names}\in\mathbb{{R}}^{{{printer.script(args[0])}}}"
    need = Bind.LOOSE if kind in RANGES else Bind.PRODUCT
    return fill(_TYPES[kind], [names, *(printer.script(a, need) for a in args)])


def _definition(printer: LaTeX, definition: tuple) -> str:
    if definition[0] == "let":
        _, name, params, body = definition
        left = ("at", name, *(("sym", p) for p in params)) if params else ("sym", name)
        return f"{printer(left)} := {printer(body)}"
    _, name, index, start, initial, step = definition
    first = [f"{printer(('at', name, start + k))} := {printer(value)}" for k, value in enumerate(initial)]
    return r",\quad ".join([*first, f"{printer(('at', name, ('+', ('sym', index), 1)))} := {printer(step)}"])
