# SPDX-License-Identifier: MIT
"""LaTeX and plain text of trees: faithful, with the parentheses that the tree asks for."""

import pytest
from latex2mathml.converter import convert

from exactkf import BadInput
from exactkf.language import (
    OPERATIONS,
    Expr,
    Identity,
    T,
    Zero,
    always,
    block,
    bottom,
    exists,
    forall,
    iff,
    inv,
    loewner,
    matrix_of,
    prints,
    prod,
    psd,
    rational,
    recip,
    rev,
    substitute,
    sum_of,
    symbols,
    top,
    when,
)
from exactkf.language.latex import latex
from exactkf.language.names import tex_name
from exactkf.language.text import text

a, b, c, i, j, k, n, t, M, P, Q, A1, f, phi, phis, gamma = symbols("a b c i j k n t M P Q A1 f phi phis gamma")

NAMES = {
    "alpha": r"\alpha", "Gamma": r"\Gamma", "phi": r"\varphi", "A1": "A_{1}", "A_12": "A_{12}", "P_inf": r"P_{\infty}",
    "phi_star": r"\varphi^{*}", "phis": r"\varphi^{*}", "Qs": "Q^{*}", "x_hat": r"\hat{x}", "xhat": r"\hat{x}",
    "phi_star_1": r"\varphi_{1}^{*}", "i_": r"i^{\prime}", "lhs": r"\mathrm{lhs}", "P_next": r"P_{\mathrm{next}}",
    "beta": r"\beta", "P_plus": "P^{+}", "theta2": r"\theta_{2}",
}

SHOWN = [
    (a - (b - c), r"a - \left(b - c\right)", "a - (b - c)"),
    (a - b - c, "a - b - c", "a - b - c"),
    ((a + b) * c, r"\left(a + b\right) c", "(a + b)*c"),
    (-a * b, "-a b", "-a*b"),
    (c + -a * b, r"c + \left(-a b\right)", "c + (-a*b)"),
    (-(a + b), r"-\left(a + b\right)", "-(a + b)"),
    (Expr(("neg", -2)), r"-\left(-2\right)", "-(-2)"),
    (Expr(-2) ** n, r"\left(-2\right)^{n}", "(-2)^n"),
    (2 * Expr(3), r"2 \cdot 3", "2*3"),
    (2 * (a / b), r"2 \cdot \frac{a}{b}", "2*(a/b)"),
    (a * b / c, r"\frac{a b}{c}", "a*b/c"),
    (a / (b / c), r"\frac{a}{\frac{b}{c}}", "a/(b/c)"),
    (a ** rational("1/2"), "a^{1/2}", "a^(1/2)"),
    (T(M * P), r"\left(M P\right)'", "(M*P)'"),
    (T(inv(P)), r"\left(P^{-1}\right)'", "(P^-1)'"),
    (inv(P + Q), r"\left(P + Q\right)^{-1}", "(P + Q)^-1"),
    (gamma[t + 1], r"\gamma_{t + 1}", "gamma[t + 1]"),
    (phis[t] ** 2, r"\left(\varphi_{t}^{*}\right)^{2}", "phis[t]^2"),
    (f(P), r"f\left(P\right)", "f(P)"),
    (f(P) - f(n), r"f\left(P\right) - f\left(n\right)", "f(P) - f(n)"),
    (M[i, j], "M_{ij}", "M[i, j]"),
    (M[i + 1, j], "M_{i + 1,j}", "M[i + 1, j]"),
    (A1[i, j], r"\left(A_{1}\right)_{ij}", "A1[i, j]"),
    ((M * P)[i, j], r"\left(M P\right)_{ij}", "(M*P)[i, j]"),
    (sum_of(i, 1, n, a[i]) + b, r"\sum_{i=1}^{n} a_{i} + b", "sum(i=1..n: a[i]) + b"),
    (prod(k, 0, t, 1 - a[k]), r"\prod_{k=0}^{t} \left(1 - a_{k}\right)", "prod(k=0..t: 1 - a[k])"),
    (when(t == 0, 1, a), r"\begin{cases}1 & \text{if}\ t = 0 \\ a & \text{otherwise}\end{cases}", "1 if t = 0 else a"),
    (rev(phi, n), r"z^{n} \varphi(1/z)", "z^n * phi(1/z)"),
    (recip(a + b), r"\left[a + b\right]_{z\to 1/z}", "(a + b)(1/z)"),
    (substitute(phi, 1 / a), r"\varphi(1/a)", "phi(1/a)"),
    (prints(a, "3.14"), r"a \doteq 3.14", "a prints 3.14"),
    (loewner(P, Q), r"P \succeq Q", "P >= Q (Loewner)"),
    (always(t, a[t] > 0), r"\forall\,t\ge 0:\; a_{t} > 0", "for all t >= 0: a[t] > 0"),
    (forall(i, 1, n, a[i] > 0) & (b > 0), r"\left(\forall\,1\le i\le n:\; a_{i} > 0\right)\ \text{and}\ b > 0",
     "(for all i=1..n: a[i] > 0) and b > 0"),
    ((a > 0) >> exists(i, 1, n, b == a), r"a > 0 \;\Longrightarrow\; \exists\,1\le i\le n:\; b = a",
     "a > 0 => for some i=1..n: b = a"),
    (iff(a > 0, ~(b > 0)), r"a > 0 \;\Longleftrightarrow\; \neg \left(b > 0\right)", "a > 0 <=> not (b > 0)"),
    (block([[P, T(Q)], [Zero(n, 2 * n), Identity(n)]]),
     r"\begin{bmatrix}P & Q' \\ 0_{n\times 2 n} & I_{n}\end{bmatrix}", "[P, Q'; O(n, 2*n), I(n)]"),
    (top(M, n), r"\operatorname{top}_{n}\left(M\right)", "top(M, n)"),
    (bottom(M, n), r"\operatorname{bottom}_{n}\left(M\right)", "bottom(M, n)"),
    (matrix_of(i, j, n, n, a[i + j]), r"\left[a_{i + j}\right]_{i,j=1}^{n}", "[a[i + j] | i=1..n, j=1..n]"),
    (psd(P - Q), r"P - Q \succeq 0", "P - Q psd"),
]


@pytest.mark.parametrize(("name", "tex"), NAMES.items())
def test_names(name, tex):
    assert tex_name(name).tex() == tex


@pytest.mark.parametrize(("expr", "tex", "plain"), SHOWN, ids=[s[2] for s in SHOWN])
def test_trees(expr, tex, plain):
    assert latex(expr.tree) == tex
    assert text(expr.tree) == plain
    assert convert(tex).startswith("<math")


def sample(op):
    """A smallest tree with the operation."""
    p, one = ("sym", "P"), 1
    special = {
        "rat": ("rat", 1, 2), "sym": p, "at": ("at", "P", 1), "prints": ("prints", p, (("1.0",),)),
        "block": ("block", (p, p)), "rows": ("rows", (p, p)),
        "mat": ("mat", "i", "j", 2, 2, p), "col": ("col", "i", 2, p),
        "always": ("always", "t", p), **{q: (q, "i", 1, 2, p) for q in ("sum", "prod", "forall", "exists")},
    }
    return special.get(op) or (op, *[p, one, 2][: OPERATIONS[op][0]])


@pytest.mark.parametrize("op", OPERATIONS)
def test_every_operation_prints(op):
    tree = sample(op)
    assert convert(latex(tree)).startswith("<math")
    assert text(tree).isascii()
    for outer in (("^", tree, 2), ("T", tree), ("*", tree, tree), ("=>", tree, tree)):
        assert latex(outer).count(r"\left") == latex(outer).count(r"\right")
        assert text(outer)


def test_different_trees_read_differently():
    product_of_sum, sum_of_products = (a * (b + c)).tree, (a * b + c).tree
    assert latex(product_of_sum) != latex(sum_of_products)
    assert text(((a > 0) >> ((b > 0) >> (c > 0))).tree) == "a > 0 => (b > 0 => c > 0)"
    assert text((((a > 0) >> (b > 0)) >> (c > 0)).tree) == "(a > 0 => b > 0) => c > 0"


def test_names_can_be_overridden():
    assert latex((P + Q).tree, {"P": r"\mathcal{P}"}) == r"\mathcal{P} + Q"


@pytest.mark.parametrize("tree", [True, 1.5, (), ("nonsense", 1), ("show", 1)])
def test_what_is_no_term_is_refused(tree):
    with pytest.raises(BadInput):
        latex(tree)


def test_repr_of_an_expression_is_its_text():
    assert repr(P * T(Q)) == "P*Q'"
