"""TeX that is no formula of a paper, as Typst: what is known is set, all else refused."""

from __future__ import annotations

import pytest
import typst

from omniproof.report.typstmath import UnsettableError, read, source

MARKS = (
    "#let old(body) = body\n#let new(body) = body\n#let boxed(body) = body\n"
    "#let changed(body) = body\n#let aligned(..rows) = rows.pos().map(row => row.join()).join()\n"
)


def compiles(markup: str) -> bool:
    """Whether Typst takes the markup; it is silent about nothing."""
    document = (MARKS + markup).encode()
    return bool(typst.compile(document, format="svg", ignore_system_fonts=True))


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        pytest.param(r"\alpha_1^2", "$attach(alpha, b: 1, t: 2)$", id="both scripts"),
        pytest.param(r"\frac{1}{2}c", "$frac(1, 2) c$", id="fraction"),
        pytest.param(r"\frac12", "$frac(1, 2)$", id="arguments without braces are one digit"),
        pytest.param("x^10", "$attach(x, t: 1) 0$", id="a script without braces is one digit"),
        pytest.param("4.61", "$4.61$", id="decimal"),
        pytest.param("a,b;c/d", r"$a \, b \; c \/ d$", id="signs that Typst would read as syntax"),
        pytest.param(r"\left(\frac{a}{b}\right)", r"$lr(\( frac(a, b) \))$", id="fences that grow"),
        pytest.param(r"\left.x\right|", '$lr( x class("normal", bar.v))$', id="one fence"),
        pytest.param(r"30^\circ", "$30 degree$", id="degrees"),
        pytest.param("X'_m", "$attach(X, b: m, t: prime)$", id="prime"),
        pytest.param(r"\mathbf{n}_k", "$attach(bold(upright(n)), b: k)$", id="bold is upright"),
        pytest.param(r"\boldsymbol{\eta}", "$bold(eta)$", id="bold Greek stays slanted"),
        pytest.param(r"\phi\varphi", "$phi.alt phi$", id="the two shapes of phi"),
        pytest.param(
            r"\begin{pmatrix} 0 & -1 \\ s & c \end{pmatrix}",
            '$mat(delim: "(", 0, - 1; s, c)$',
            id="matrix",
        ),
        pytest.param(r"x \text{ if } y", '$x class("normal", " if ") y$', id="words"),
        pytest.param(r"\operatorname{atan}_2", '$attach(op("atan"), b: 2)$', id="operator"),
        pytest.param(r"a &= b \tag{3}", "$a = b$", id="alignment and tag are left out"),
        pytest.param(r"\begin{aligned} a &= b \end{aligned}", "$aligned(a, = b;)$", id="aligned"),
        pytest.param(
            r"a \mathbin{\changed{+}} b", '$a class("binary", changed(+)) b$', id="marked"
        ),
        pytest.param(r"\binom{a}{b}", "$binom(a, b)$", id="binomial"),
        pytest.param(r"\frac{}{2}", '$frac("", 2)$', id="empty argument"),
    ],
)
def test_formula(latex: str, expected: str) -> None:
    assert f"${source(read(latex))}$" == expected
    assert compiles(expected)


@pytest.mark.parametrize(
    "latex",
    [
        pytest.param(r"\href{x}{y}", id="unknown command"),
        pytest.param(r"\frac{1}{2", id="open brace"),
        pytest.param("x}", id="brace that closes nothing"),
        pytest.param(r"\left( x", id="open fence"),
        pytest.param(r"\frac{1}", id="missing argument"),
        pytest.param(r"\begin{tikzpicture} x \end{tikzpicture}", id="unknown environment"),
        pytest.param(r"\sqrt[3]{x}", id="root with an index"),
        pytest.param("{" * 500 + "x" + "}" * 500, id="nested too deep"),
    ],
)
def test_what_is_not_known_is_refused(latex: str) -> None:
    with pytest.raises(UnsettableError):
        read(latex)
