from __future__ import annotations

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.report.latexfmt import cell, inline, is_latex, is_settable, math, plain, same


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        pytest.param(r"\sin \alpha_1 + \sin \alpha_2", True, id="formula"),
        pytest.param("13.85", True, id="decimal"),
        pytest.param("D_A", True, id="symbol"),
        pytest.param("D_{Vol}", True, id="symbol with a word below"),
        pytest.param(r"8 / \det \mathbf{A} \text{ [m/s]}^3", True, id="formula with a unit"),
        pytest.param("the shapes are hexagons", False, id="words"),
        pytest.param("Curvic", False, id="one word"),
        pytest.param("Eq. (4)", False, id="abbreviation"),
        pytest.param("the unit vector $n_k$", False, id="words with a formula"),
        pytest.param("", False, id="nothing"),
    ],
)
def test_formulas_are_told_from_words(text: str, expected: bool) -> None:
    assert is_latex(text) is expected


@pytest.mark.parametrize(
    "latex",
    [
        pytest.param(r"\frac{1}{2", id="open brace"),
        pytest.param(r"\begin{pmatrix} 1", id="open environment"),
        pytest.param(r"1 \end{cases}", id="closed before it was opened"),
        pytest.param(r"\left( x", id="open delimiter"),
        pytest.param(r"\href{javascript:alert(1)}{x}", id="a link"),
        pytest.param(r"\newcommand{\x}{1}", id="a macro"),
        pytest.param(r"a \) b", id="an end of the formula"),
        pytest.param("50% of x", id="a comment"),
    ],
)
def test_what_cannot_be_set_is_shown_as_code(latex: str) -> None:
    assert not is_settable(latex)
    assert math(latex).startswith("<code>")


@pytest.mark.parametrize(
    ("latex", "inside"),
    [
        pytest.param("a < b", r"\(a &lt; b\)", id="escaped"),
        pytest.param(r"x \tag{3}", r"\(x\)", id="without its number"),
        pytest.param(
            r"a &= b \\ &= c",
            r"\(\begin{aligned}a &amp;= b \\ &amp;= c\end{aligned}\)",
            id="lines are aligned",
        ),
        pytest.param(
            r"\begin{pmatrix} a & b \end{pmatrix}",
            r"\(\begin{pmatrix} a &amp; b \end{pmatrix}\)",
            id="a matrix is left alone",
        ),
    ],
)
def test_math(latex: str, inside: str) -> None:
    assert math(latex) == f'<span class="math notranslate nohighlight">{inside}</span>'


@pytest.mark.parametrize(
    ("latex", "other", "expected"),
    [
        pytest.param(r"\sin {\alpha_1}", r"\sin \alpha_1", True, id="braces"),
        pytest.param(r"a &= b - c", "b-c", True, id="left side"),
        pytest.param("a + b", "a - b", False, id="sign"),
        pytest.param("", "", False, id="nothing is not a formula"),
    ],
)
def test_same(latex: str, other: str, expected: bool) -> None:
    assert same(latex, other) is expected


def test_words_of_a_formula_can_break_into_lines() -> None:
    html = cell(r"\mathbf{V} \text{ is in the robot frame, or } \phi = 0")
    assert re.sub(r"<[^>]*>", "", html) == r"\(\mathbf{V}\) is in the robot frame, or \(\phi = 0\)"
    inside = r"\frac{\text{speed of the wheel}}{2}"
    assert cell(inside) == math(inside)


def test_words_with_formulas_and_code() -> None:
    assert inline("if $x<1$ & `a_b`") == (
        'if <span class="math notranslate nohighlight">\\(x&lt;1\\)</span> &amp; <code>a_b</code>'
    )


@settings(deadline=None, max_examples=200)
@given(st.text(alphabet=st.sampled_from("ab<>&\"'$`\\{}()[]_^% "), max_size=30))
def test_nothing_becomes_an_element(outline: type, text: str) -> None:
    found = outline(cell(text))
    assert set(found.tags) <= {"span", "code"}


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        pytest.param(r"\sin \alpha_1 + \sin \alpha_2", "sin α₁ + sin α₂", id="greek, index"),
        pytest.param(r"\frac{16 \sqrt{3}}{9}", "(16 √3)/9", id="fraction, root"),
        pytest.param(r"\frac{1}{2}", "1/2", id="plain fraction"),
        pytest.param(r"30^{\circ}", "30°", id="degrees"),
        pytest.param(r"\widetilde{a}_{2,1}", "a\u0303₂,₁", id="accent, two indices"),
        pytest.param(r"x &= a \times b", "x = a × b", id="aligned, product"),
        pytest.param(r"(\det \mathbf{A})^{-1}", "(det A)⁻¹", id="exponent, bold"),
        pytest.param(r"\alpha_1 \leq \alpha_2", "α₁ ≤ α₂", id="sign"),
        pytest.param(r"\begin{pmatrix} 1 \\ 2 \end{pmatrix} x", "[…] x", id="matrix"),
        pytest.param("words with $x_1$ and `code`", "words with x₁ and code", id="mixed"),
        pytest.param(r"\left( a \right)", "( a )", id="delimiters"),
    ],
)
def test_plain(latex: str, expected: str) -> None:
    assert plain(latex) == expected
