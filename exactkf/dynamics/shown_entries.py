# SPDX-License-Identifier: MIT
"""The numbers and the structure of an answer as labelled entries, in words and in LaTeX.

Main definitions
----------------
``Entry``               a label and what stands behind it, both in words and in LaTeX
``number_entries``      limit, rate, steps
``structure_entries``   `D` on the circle, `S`, its Jordan structure and invariant subspaces
``ahead_entries``       the state far ahead
``shown_number``        an exact number with its digits
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from flint import arb, fmpq, fmpq_poly, fmpz

from exactkf.dynamics.ahead import rounded
from exactkf.dynamics.answer import Answer
from exactkf.dynamics.every_order import limit_digits, rate_digits
from exactkf.dynamics.exact_json import number_latex, number_words, polynomial_latex, polynomial_text, polynomial_words
from exactkf.exact.balls import precision
from exactkf.exact.numberfield import RealField

__all__ = ["Entry", "ahead_entries", "number_entries", "shown_number", "structure_entries"]

_LONGEST = 160  # characters of a matrix on one line
_WIDEST = 10  # columns of a matrix in LaTeX


class Entry(NamedTuple):
    """A label and what stands behind it; LaTeX comes with its dollar signs."""

    label: str
    words: str
    label_latex: str
    latex: str


# ---------------------------------------------------------------------- numbers
def number_entries(answer: Answer, digits: int) -> list[Entry]:
    """The limit and the other numbers of the answer."""
    entries = [*_limit(answer, digits), *_speed(answer, digits)]
    if answer.region:
        entries.append(Entry("start", answer.region, "Start", answer.region.replace("+", "$_+$").replace("-", "$_-$")))
    for label, value, what in (("monotone from step", answer.monotone_from, "Monotone from step"),
                               ("positive real from step", answer.enters_positive_real, "Positive real from step"),
                               ("dimension of the torus", answer.torus_dimension, "Dimension of the torus")):
        if value is not None:
            entries.append(Entry(label, str(value), what, f"${value}$"))
    return entries


def _limit(answer: Answer, digits: int) -> list[Entry]:
    entries = []
    for name, values in (answer.limit or {}).items():
        listed = values if isinstance(values, list) else [values]
        enclosed = limit_digits(answer, digits).alpha if isinstance(listed[0], dict) and "minpoly" not in listed[0] else [None] * len(listed)
        for k, (value, ball) in enumerate(zip(listed, enclosed, strict=True), 1):
            index, below = (f"_{k}", f"_{{{k}, \\infty}}") if len(listed) > 1 else ("", r"_\infty")
            words, latex = _both(value, digits) if ball is None else _ball(ball, digits)
            entries.append(Entry(f"limit of {name}{index}", words, "Limit", f"$\\{name}{below} = {latex}"))
    return entries


def _speed(answer: Answer, digits: int) -> list[Entry]:
    if answer.rate == "0":
        return [Entry("rate", "0 (the orbit rests after finitely many steps)", "Rate", "$0$: the orbit rests after finitely many steps")]
    distance = r"\pi_t - \pi_\infty" if "pi" in (answer.limit or {}) else r"\alpha_t - \alpha_\infty"
    if answer.rate is not None:
        words, latex = _both(answer.rate, digits) if "minpoly" in answer.rate or isinstance(answer.rate, str) else _ball(rate_digits(answer, digits), digits)
        return [Entry("rate", words, "Rate", f"$\\limsup_t \\|{distance}\\|^{{1/t}} = {latex}")]
    if answer.slow is not None:
        return [Entry("rate", f"none; the distance goes to zero like {answer.slow}/t, in proportion to the limit", "Rate",
                      f"none; $\\|{distance}\\|$ goes to zero like ${answer.slow}/t$, in proportion to the limit")]
    return []


def shown_number(value: Any, digits: int) -> str:
    """An exact number of an answer, with its decimal digits; it is rational, the root of a polynomial, or in an interval.

    Examples
    --------
    >>> shown_number("1/3", 5)
    '1/3'
    """
    return _both(value, digits)[0]


def _both(value: Any, digits: int) -> tuple[str, str]:
    """A number in JSON in words and in LaTeX, the latter after an opening dollar sign."""
    if not isinstance(value, dict):
        return str(value), f"{number_latex(_fraction(value))}$"
    if "minpoly" not in value:
        lo, hi = (_fraction(x) for x in value["interval"])
        with precision(64 + 5 * digits):
            return _ball(arb((lo + hi) / 2, (hi - lo) / 2), digits)
    field = RealField(value["minpoly"], value["interval"])
    near = field.gen().enclose(digits).str(digits, radius=False)
    return (f"{near}  (root {field.index + 1} of {polynomial_words(field.minpoly, 'x')}, from the left)",
            f"{_power(near)}$, root {field.index + 1} of ${polynomial_latex(field.minpoly.coeffs(), 'x')}$ from the left")


def _ball(x: arb, digits: int) -> tuple[str, str]:
    with precision(64 + 5 * digits):
        near = f"0 to {digits} digits" if x.contains(0) else x.str(digits, radius=False)
    return f"{near}  (enclosed)", f"{_power(near)}$ (enclosed)"


def _fraction(text: str) -> fmpq:
    return fmpq(*map(fmpz, text.split("/")))


# ---------------------------------------------------------------------- structure
def structure_entries(answer: Answer, digits: int) -> list[Entry]:
    """What is behind the orbit: common factors, D on the circle, S."""
    found = answer.structure
    if not found:
        return []
    read = _reader(found["field"])
    m = found["order"]
    entries = [_polynomial("gcd of a and b", "Greatest common divisor of $a$ and $b$", read(found["gcd"]))]
    if t := found["start"]:
        entries.append(_polynomial(f"after {t} step{'s' * (t > 1)}", f"The same of $a_t$ and $b_t$, $t = {t}$", read(found["factor"])))
    d = read(found["d"])
    n = len(d) - 1
    point = Entry(f"point of P^{n}", f"({' : '.join(map(number_words, d))})", f"Point of $\\mathbb{{P}}^{{{n}}}$", f"$({' : '.join(map(number_latex, d))})$")
    entries += [point, Entry("D on the circle", found["sign"], "$D$ on $|z| = 1$", found["sign"]), _circle(found["circle_zeros"], digits)]
    if found["S"] is None:
        return entries
    entries += [_matrix([read(row) for row in found["S"]]), _jordan([(read(block["polynomial"]), block["size"]) for block in found["jordan"]])]
    return entries + [_subspace(name, found[name], m, digits) for name in ("dominant", "codominant") if found[name] is not None]


def _reader(field: Any) -> Callable[[Sequence[Any]], list[Any]]:
    """What reads the numbers of a structure: rationals, or elements of its field."""
    if field is None:
        return lambda values: [_fraction(x) for x in values]
    over = RealField(field[0], field[1:])
    return lambda values: [over(fmpq_poly([_fraction(c) for c in (x if isinstance(x, list) else [x])])) for x in values]


def _polynomial(label: str, label_latex: str, p: Sequence[Any]) -> Entry:
    return Entry(label, polynomial_text(p), label_latex, f"${polynomial_latex(p)}$")


def _circle(zeros: Sequence[Mapping[str, Any]] | None, digits: int) -> Entry:
    """The zeros of D on the circle, with multiplicities; all of it if D is zero."""
    words, latex = ([], []) if zeros is not None else (["all z"], ["all $z$"])
    for zero in zeros or ():
        x, k = zero["two_cos"], zero["multiplicity"]
        times = {1: "simple", 2: "double"}.get(k, f"of multiplicity {k}")
        if x in ("2", "-2"):
            words.append(f"z = {int(x) // 2}, {times}")
            latex.append(f"$z = {int(x) // 2}$, {times}")
        else:
            near, formula = _brief(x, digits)
            words.append(f"z + 1/z = {near}, {times}")
            latex.append(f"$z + 1/z = {formula}$, {times}")
    return Entry("zeros on the circle", "; ".join(words) or "none", "Zeros of $D$ on $|z| = 1$", "; ".join(latex) or "none")


def _matrix(rows: Sequence[Sequence[Any]]) -> Entry:
    text = "[" + "; ".join(", ".join(map(number_words, row)) for row in rows) + "]"
    if len(text) > _LONGEST:
        text = f"{len(rows)} by {len(rows)}, see --json"
    entries = r" \\ ".join(" & ".join(map(number_latex, row)) for row in rows)
    latex = f"$\\begin{{pmatrix}} {entries} \\end{{pmatrix}}$" if len(rows) <= _WIDEST else f"of size ${len(rows)}$"
    return Entry("S, by rows", text, "$S$", latex)


def _jordan(blocks: Sequence[tuple[Sequence[Any], int]]) -> Entry:
    """One block for each eigenvalue."""
    words = "; ".join(f"of size {size} for each zero of {polynomial_text(p)}" for p, size in blocks)
    latex = "; ".join(f"of size ${size}$ for each zero of ${polynomial_latex(p)}$" for p, size in blocks)
    return Entry("Jordan blocks of S", words, "Jordan blocks of $S$", latex)


def _subspace(name: str, u: Sequence[Any], m: int, digits: int) -> Entry:
    """The subspace spanned by v, Sv, ..."""
    words, latex = zip(*(_brief(x, digits) for x in u), strict=True)
    span = {1: ("v", "$v$"), 2: ("v, Sv", "$v, Sv$")}.get(m, (f"v, ..., S^{m - 1} v", f"$v, \\dots, S^{{{m - 1}}} v$"))
    unit = ", ".join(["1"] + ["0"] * (m - 1))
    return Entry(f"{name} subspace", f"spanned by {span[0]} with v = ({unit}; {', '.join(words)})", f"{name.capitalize()} subspace",
                 f"spanned by {span[1]} with $v = ({unit}; {', '.join(latex)})$")


def _brief(x: Any, digits: int) -> tuple[str, str]:
    """A number in digits only, if it is not rational; JSON has it exactly."""
    words, latex = _both(x, min(digits, 12))
    return words.split("  (")[0], latex.split("$")[0]


# ---------------------------------------------------------------------- far ahead
def ahead_entries(data: Mapping[str, Any], digits: int) -> list[Entry]:
    """The state far ahead, as `exactkf.dynamics.ahead.ahead_data` has it, in LaTeX and in words."""
    T = data["steps"]
    if data["escape"] is not None:
        return [Entry(f"state after {T} steps", "none", f"State after ${T}$ steps", f"none, the orbit escapes at step ${data['escape']}$")]
    entries = []
    for name in "ag":
        for i, x in enumerate(data[name], 1):
            text = rounded(x, digits)
            exact = isinstance(x, str)
            latex = number_latex(_fraction(x)) if exact else _power(text)
            entries.append(Entry(f"{name}_{i}({T})", text, f"State after ${T}$ steps", f"${name}_{{{i}}}({T}) = {latex}$"))
    if not data["never_escapes"]:
        entries.append(Entry("but", "an escape before is not excluded", "But", "an escape before that step is not excluded"))
    return entries


def _power(text: str) -> str:
    """Decimal digits in LaTeX."""
    digits, sign, exponent = text.partition("e")
    if " " in text:
        return f"0\\text{{ {text[2:]}}}"
    return f"{digits}\\ldots" + (f" \\cdot 10^{{{exponent.removeprefix('+')}}}" if sign else "")
