"""Cells of the ledger as Typst markup: formulas set, differences marked, nothing foreign run."""

from __future__ import annotations

import re

import pytest
import typst
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.formula.writers import words
from omniproof.report.typeset import cell, contrasted, inline, is_formula, math

MARKS = "#let old(body) = body\n#let new(body) = body\n#let boxed(body) = body\n"


def bare(markup: str) -> str:
    """Return markup without what is said of its formulas."""
    return re.sub(r'#math\.equation\(alt: "(?:[^"\\]|\\.)*", (\$.*?\$)\);', r"\1", markup)


def refer(claim: str) -> str:
    return f"<{claim}>"


def compiles(markup: str) -> bool:
    """Whether Typst takes the markup; it is silent about nothing."""
    document = (MARKS + markup).encode()
    return bool(typst.compile(document, format="svg", ignore_system_fonts=True))


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
def test_what_cannot_be_set_is_shown_as_code(latex: str) -> None:
    assert math(latex) == f"#raw({words(latex)});"
    assert not is_formula(latex)


SYNTAX = ["#", "$", '"', "\\", "(", ")", "[", "]", "{", "}", "/", "//", "/*", "*", "_", "^", "`"]
OTHER = ["<a>", "@b", "&", ";", ",", "'", "~", "-", "=", " ", "a", "7", "é", "\\frac", "\\left"]
CALLS = ["#panic()", "\\text{#panic()}", '\\operatorname{"}', "eval("]


@settings(max_examples=60, deadline=None)
@given(st.lists(st.sampled_from([*SYNTAX, *OTHER, *CALLS]), max_size=14).map("".join))
def test_foreign_text_never_becomes_code(text: str) -> None:
    """Whatever the paper prints, Typst takes the page, and what it says is not run."""
    assert compiles(f"[{cell(text, words_of)}] {math(text)} {' '.join(contrasted(text, 'a-b'))}")


def words_of(claim: str) -> str:
    return f"#{words(claim)};"


@pytest.mark.parametrize(
    ("printed", "corrected", "expected"),
    [
        pytest.param(
            r"\sin a + b",
            r"\sin a - b",
            ('$sin a class("binary", old(+)) b$', '$sin a class("binary", new(-)) b$'),
            id="a sign keeps its space",
        ),
        pytest.param("a b", "a b c", ("$a b$", "$a b new(c)$"), id="something is missing"),
        pytest.param(
            "= x_1 y",
            "= x_2 y",
            ("$= old(attach(x, b: 1)) y$", "$= new(attach(x, b: 2)) y$"),
            id="an index is marked with its symbol",
        ),
        pytest.param(
            r"r \sqrt{a b}",
            r"r \sqrt{a c}",
            ("$r sqrt(a old(b))$", "$r sqrt(a new(c))$"),
            id="inside of a root",
        ),
        pytest.param(
            r"\{210^\circ, 300^\circ\}",
            r"\{210^\circ, 330^\circ\}",
            (r"$\{ 210 degree \, old(300) degree \}$", r"$\{ 210 degree \, new(330) degree \}$"),
            id="inside of a set",
        ),
        pytest.param(
            r"\frac{2 L}{a}",
            r"\frac{L}{a}",
            ("$frac(2 L, a)$", "$frac(L, a)$"),
            id="a fraction is one thing: no marks",
        ),
        pytest.param("32.9", "33.0", ("$32.9$", "$33.0$"), id="nothing in common, no marks"),
        pytest.param(
            r"\bad x", "x", (r'#raw("\\bad x");', "$x$"), id="what cannot be set has no marks"
        ),
    ],
)
def test_differences_are_marked(printed: str, corrected: str, expected: tuple[str, str]) -> None:
    assert tuple(map(bare, contrasted(printed, corrected))) == expected


def test_words_with_formula_code_and_claim() -> None:
    text = "by $x_1$, see `a*b` and eq:5-1[1,3]."
    expected = '#"by"; $attach(x, b: 1)$#", see"; #raw("a*b"); #"and"; <eq:5-1[1,3]>#".";'
    assert bare(inline(text, refer)) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        pytest.param("x^2", "$attach(x, t: 2)$", id="formula"),
        pytest.param("-1.50", "$- 1.50$", id="decimal keeps its zero"),
        pytest.param("eq:15", "<eq:15>", id="claim"),
        pytest.param("Figure 4", '#"Figure 4";', id="words"),
        pytest.param(
            r"e \in span\{P\}", r"$e in s p a n \{ P \}$", id="TeX with a bare word in it"
        ),
    ],
)
def test_cell(text: str, expected: str) -> None:
    assert bare(cell(text, refer)) == expected


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        pytest.param(r"\sin\alpha_1 \leq 1", "sin α₁ ≤ 1", id="signs"),
        pytest.param(
            r"\begin{pmatrix} a & b \\ c & d \end{pmatrix}^{-1}", "(a, b; c, d)⁻¹", id="matrix"
        ),
        pytest.param(r"\{210, 270\}", "{210, 270}", id="set"),
        pytest.param(r'\text{a "b"}', 'a "b"', id="quotes"),
    ],
)
def test_a_formula_is_spoken(latex: str, expected: str) -> None:
    assert f"alt: {words(expected)}, $" in math(latex)
