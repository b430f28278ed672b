"""Formulas as MathML: spaced as in print, marked where they are wrong, and nothing foreign."""

from __future__ import annotations

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.report.mathml import WIDE, Formula, mathml

ELEMENT = re.compile(r"math|mrow|m[ino]|mtext|mspace|mfrac|msqrt|m(sub)?(sup)?|mt(able|r|d)|code")


def set_(latex: str, *, display: bool = False) -> str:
    formula = Formula(latex, display)
    return mathml([formula])[formula]


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        pytest.param(r"\frac{1}{2}", "<mfrac><mn>1</mn><mn>2</mn></mfrac>", id="fraction"),
        pytest.param(
            r"a \mathbin{\changed{+}} b",
            r'<mrow class="changed"><mo form="prefix">+</mo></mrow>',
            id="what changes",
        ),
        pytest.param(r"\boxed{a}", '<mrow class="boxed"><mi>𝑎</mi></mrow>', id="a boxed entry"),
        pytest.param(
            r"\overline{AB}",
            '<mrow class="overline"><mi>𝐴</mi><mi>𝐵</mi></mrow>',
            id="what MathML Core cannot draw is a class",
        ),
        pytest.param(r"\mathbb{R}", "<mi>ℝ</mi>", id="double-struck"),
        pytest.param(r"\hat{x}", "<mo>ˆ</mo>", id="an accent with a width of its own"),
        pytest.param(
            r"\begin{aligned} a &= b \\ &= c \end{aligned}",
            '<mrow class="aligned"><mrow><mtable><mtr><mtd><mi>𝑎</mi></mtd><mtd>',
            id="lines, aligned at a sign",
        ),
    ],
)
def test_formula(latex: str, expected: str) -> None:
    assert expected in set_(latex)


def test_a_function_keeps_its_distance() -> None:
    found = re.findall(r"<mo [^>]*>(?:sin|cos)</mo>", set_(r"L \sin\alpha \cos\beta"))
    assert all('lspace="0.1666' in sign and 'rspace="0.1666' in sign for sign in found)
    assert len(found) == 2


def test_each_formula_has_its_own() -> None:
    formulas = [Formula("a"), Formula("b", display=True), Formula(r"\nonsense"), Formula("c")]
    found = mathml(formulas)
    assert [re.sub(r"<[^>]*>", "", found[formula]) for formula in formulas] == [
        "𝑎", "𝑏", r"\nonsense", "𝑐",
    ]  # fmt: skip
    assert 'display="block"' in found[formulas[1]]


def test_only_a_wide_formula_says_its_width() -> None:
    assert "--em" not in set_("a + b")
    (width,) = re.findall(r'<math[^>]* style="--em: (\d+)"', set_(" + ".join("abcdefghijklmno")))
    assert WIDE < int(width) < 30


@settings(max_examples=60, deadline=None)
@given(st.lists(st.sampled_from([*r"#$<>&;\{}^_ab1+", r"\frac", r"\left", "#panic()", "]"])))
def test_foreign_text_becomes_neither_markup_nor_code(pieces: list[str]) -> None:
    assert all(map(ELEMENT.fullmatch, re.findall(r"<(\w+)", set_("".join(pieces)))))
