"""A printed formula is laid out as it is printed, and written the same in every notation."""

from __future__ import annotations

import pytest
import typst as program
from generated_trees import TREES
from hypothesis import given, settings

from omniproof.formula import writers
from omniproof.formula.writers import latex_text, plain_text, typst_text
from omniproof.formula.writers.boxes import layout
from omniproof.report.shown import shown
from omniproof.transcription import tokens, tree
from omniproof.transcription.functions import FUNCTIONS, Row
from omniproof.transcription.reader import read


@pytest.mark.parametrize(
    ("latex", "text", "typst"),
    [
        pytest.param(r"\sin^2\alpha_1", "sin² α₁", "attach(sin, t: 2) attach(alpha, b: 1)",
                     id="an exponent at the name of a function"),
        pytest.param(r"(\sin x)^2", "(sin x)²", r"attach(\( sin x \), t: 2)",
                     id="an exponent behind a bracket"),
        pytest.param(r"\tan^{-1} x", "tan⁻¹ x", "attach(tan, t: - 1) x", id="an inverse function"),
        pytest.param(r"\cos(x)", "cos(x)", r"cos \( x \)", id="printed brackets stay"),
        pytest.param(r"\cos{x} y", "cos x y", "cos x y", id="none are added"),
        pytest.param("a + (b + c)", "a + (b + c)", r"a + \( b + c \)", id="also needless ones"),
        pytest.param("(a + b)", "(a + b)", r"\( a + b \)", id="around everything"),
        pytest.param("a - (-b)", "a - (-b)", r"a - \( - b \)", id="around a sign"),
        pytest.param(r"\left[\frac{a}{b}\right]", "[a/b]", r"lr(\[ frac(a, b) \])",
                     id="brackets grow with what is in them"),
        pytest.param("a b/2 + c", "a b/2 + c", r"a b \/ 2 + c", id="a slash is no line"),
        pytest.param(r"\frac{a + b}{2}", "(a + b)/2", "frac(a + b, 2)", id="a line is no slash"),
        pytest.param(r"0 < a \leq b", "0 < a ≤ b", "0 < a lt.eq b", id="two relations"),
        pytest.param(r"a = b = c", "a = b = c", "a = b = c", id="a chain"),
        pytest.param("= b", "= b", "= b", id="a line that goes on"),
        pytest.param(r"\mathbf{n}_k", "nₖ", "attach(bold(upright(n)), b: k)", id="font"),
        pytest.param(r"\dot{\hat{q}}_{12}", "q̂̇₁₂", "attach(dot(hat(q)), b: 12)", id="accents"),
        pytest.param("x'_m", "xₘ′", "attach(x, b: m, t: prime)", id="prime"),
        pytest.param("v_k^T", "vₖᵀ", "attach(v, b: k, t: T)", id="superscript"),
        pytest.param(r"30^\circ", "30°", "30 degree", id="degrees"),
        pytest.param(r"\sqrt{2} L", "√2 L", "sqrt(2) L", id="root"),
        pytest.param(r"\|a\| |b|", "‖a‖ |b|",
                     'class("normal", bar.v.double) a class("normal", bar.v.double) '
                     'class("normal", bar.v) b class("normal", bar.v)', id="bars"),
        pytest.param(r"\begin{bmatrix} 1 & x \\ 0 & -2 \end{bmatrix}", "[1, x; 0, -2]",
                     'mat(delim: "[", 1, x; 0, - 2)', id="matrix in its own brackets"),
        pytest.param(r"\begin{cases} a & b > 0 \\ c & b < 0 \end{cases}", "{a, b > 0; c, b < 0}",
                     "cases(a & b > 0, c & b < 0)", id="cases"),
        pytest.param(r"\int_0^t f(\tau) d\tau", "∫[0, t] f(τ) dτ",
                     r"attach(integral, b: 0, t: t) f \( tau \) d tau", id="integral"),
        pytest.param(r"\{x \mid x \neq 1\}", "{x | x ≠ 1}",
                     r'\{ x class("relation", bar.v) x eq.not 1 \}', id="set"),
        pytest.param(r"\langle a, b \rangle", "⟨a, b⟩", r"chevron.l a \, b chevron.r", id="inner"),
        pytest.param(r"a &= b \tag{3}", "a = b", "a = b", id="alignment and number are left out"),
        pytest.param(r"x \text{ if } y", "x if y", 'x class("normal", " if ") y', id="words"),
        pytest.param(r"v \text{ [m/s]}^2", "v [m/s]²",
                     'v attach(class("normal", " [m/s]"), t: 2)', id="a unit with an exponent"),
        pytest.param(r"e \in \{P\}", "e ∈ {P}", r"e in \{ P \}", id="membership"),
        pytest.param(r"\phi\varphi", "φ φ", "phi.alt phi", id="the two shapes of phi"),
    ],
)  # fmt: skip
def test_as_printed(latex: str, text: str, typst: str) -> None:
    row = shown(latex)
    assert row is not None
    assert writers.text(row) == text
    assert writers.typst(row) == typst


@settings(max_examples=200, deadline=None)
@given(TREES)
def test_what_is_not_printed_is_laid_out_so_that_it_reads_back(node: tree.Node) -> None:
    text = writers.latex(node)
    symbols = ["a", "b_1", r"\theta", r"\dot{\phi}", "v_k^T", r"\det A"]
    assert writers.latex(read(text, symbols=symbols)) == text
    assert shown(writers.display(layout(node))) is not None


SPELLED = sorted(
    {f"\\{letter}" for letter in tokens.GREEK}
    | {f"\\{style}{{a}}" for style in tokens.ACCENTS | tokens.FONTS}
)


@pytest.mark.parametrize("latex", SPELLED)
def test_every_letter_accent_and_font_has_its_form(latex: str) -> None:
    row = shown(latex)
    assert row is not None
    assert "\\" not in writers.text(row)
    assert program.compile(f"${writers.typst(row)}$".encode(), format="svg")


def test_every_kind_of_box_is_written_in_every_notation() -> None:
    assert latex_text.RULES.keys() == plain_text.RULES.keys() == typst_text.RULES.keys()


@pytest.mark.parametrize("row", FUNCTIONS.values(), ids=FUNCTIONS)
def test_typst_knows_the_name_of_every_function(row: Row) -> None:
    assert program.compile(f"${row.typst}$".encode(), format="svg")
