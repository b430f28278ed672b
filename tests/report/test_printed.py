"""A chapter's formula beside the printed one: what is shown, and what stops the chapter."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest
import sympy as sp

from omniproof.audit.ledger import Verdict
from omniproof.report.printed import StaleTextError, printed

ARRANGEMENT = "omni-arrangement"
A1, A2, A3 = sp.symbols("alpha_1:4", real=True)
RIGHT = sp.sin(A1) - sp.sin(A2)
WRONG = sp.sin(A1) + sp.sin(A2)
DET = sp.sin(A2 - A1) + sp.sin(A3 - A2) + sp.sin(A1 - A3)
V_X, V_Y, ALPHA, L = sp.symbols("V_x V_y alpha_k L", real=True)


def speed(yaw_rate: sp.Symbol) -> Any:
    return -V_X * sp.sin(ALPHA) + V_Y * sp.cos(ALPHA) + L * yaw_rate


def test_a_claim_has_its_latex_its_value_and_its_verdict() -> None:
    entry = printed(ARRANGEMENT, "eq:6[2,3]")
    assert entry.latex == r"\sin \alpha_1 + \sin \alpha_2"
    assert (entry.value, entry.derived) == (WRONG, RIGHT)
    assert entry.verdict is Verdict.ERRATUM
    assert entry._repr_latex_() == rf"$\displaystyle {entry.latex}$"
    assert len(repr(entry)) < 300
    assert printed(ARRANGEMENT, "eq:6").value[1, 2] == WRONG
    assert printed(ARRANGEMENT, "tab:2[X,D_A]").value == sp.Rational(461, 100)


def test_a_fault_is_shown_beside_what_was_derived(outline: Any) -> None:
    shown = printed(ARRANGEMENT, "eq:6[2,3]").should_be(RIGHT, but_is=WRONG)
    page = outline(shown.html)
    assert page.links == ["omni-arrangement.html#eq-6-2-3"]
    assert "v-erratum" in shown.html
    assert r"\changed{+}" in shown.html
    for words in ("printed", "derived", "counterexample", "FLINT, modular arithmetic, Z3"):
        assert words in page.text
    assert "should read" not in page.text  # it is what is derived
    assert shown.name == "omni-arrangement eq:6[2,3]: erratum"


@pytest.mark.parametrize(
    ("claim", "formula", "misprint", "words"),
    [
        pytest.param("eq:7", DET, None, "det", id="a right formula"),
        pytest.param("tab:2[X,D_V]", 16 * sp.sqrt(3) / 9, None, "3.07920 is in", id="rounded"),
        pytest.param("tab:2[X,D_A]", 8 * sp.sqrt(3) / 3, sp.Rational("4.61"), "4.62", id="cut off"),
        pytest.param("eq:11", 8 / sp.Abs(DET), 8 / DET, "true when", id="under a condition"),
    ],
)
def test_what_is_right_and_what_is_not(claim: str, formula: Any, misprint: Any, words: str) -> None:
    place = printed(ARRANGEMENT, claim)
    if misprint is None:
        assert words in place.agrees_with(formula).html
    else:
        assert words in place.should_be(formula, but_is=misprint).html


@pytest.mark.parametrize(
    "yaw_rate",
    [
        pytest.param(sp.Symbol("phidot", nonzero=True), id="a letter by its looks"),
        pytest.param(sp.Symbol(r"\dot{\phi}"), id="by its LaTeX"),
        pytest.param(sp.Symbol("phi_dot"), id="by its name in the data, whatever is assumed of it"),
    ],
)
def test_letters_are_those_of_the_paper(yaw_rate: sp.Symbol) -> None:
    assert printed(ARRANGEMENT, "eq:4").agrees_with(speed(yaw_rate)).name.endswith("verified")


@pytest.mark.parametrize(
    ("say", "message"),
    [
        pytest.param(
            lambda: printed(ARRANGEMENT, "eq:6[2,3]").agrees_with(RIGHT),
            r"omni-arrangement eq:6[2,3]: the chapter says of `\sin \alpha_1 + \sin \alpha_2` that"
            " it is right, but it is judged erratum; mend the chapter, its text or what it derives",
            id="a fault is called right",
        ),
        pytest.param(
            lambda: printed(ARRANGEMENT, "eq:6[1,1]").should_be(
                sp.cos(A2) - sp.cos(A3), but_is=sp.cos(A2) + sp.cos(A3)
            ),
            r"omni-arrangement eq:6[1,1]: the chapter says of `\cos \alpha_2 - \cos \alpha_3` that"
            " it has a fault, but it is judged verified; mend the chapter, its text or what it"
            " derives",
            id="what is right is called a fault",
        ),
        pytest.param(
            lambda: printed(ARRANGEMENT, "eq:6[2,3]").should_be(RIGHT, but_is=-RIGHT),
            r"omni-arrangement eq:6[2,3]: the chapter says of `\sin \alpha_1 + \sin \alpha_2` that"
            r" it says `- \sin {\alpha_1} + \sin {\alpha_2}`, but print is 0.5452 where that is"
            " -1.045 at alpha_1 = 20/9, alpha_2 = -26/9; mend the chapter, its text or what it"
            " derives",
            id="another fault is printed",
        ),
        pytest.param(
            lambda: printed(ARRANGEMENT, "eq:6[2,3]").should_be(WRONG, but_is=RIGHT),
            r"omni-arrangement eq:6[2,3]: the chapter says of `\sin \alpha_1 + \sin \alpha_2` that"
            r" it has to be `\sin {\alpha_1} + \sin {\alpha_2}`, but what mechanics gives is 1.045"
            " where that is 0.5452 at alpha_1 = 20/9, alpha_2 = -26/9; mend the chapter, its text"
            " or what it derives",
            id="the chapter derives something else",
        ),
        pytest.param(
            lambda: printed(ARRANGEMENT, "eq:6[2,3]").agrees_with(sp.eye(2)),
            r"omni-arrangement eq:6[2,3]: the chapter says of `\sin \alpha_1 + \sin \alpha_2` that"
            r" it has to be `\left(\begin{matrix}1 & 0\\0 & 1\end{matrix}\right)`, but what"
            " mechanics gives has another shape; mend the chapter, its text or what it derives",
            id="a matrix for an entry",
        ),
        pytest.param(
            lambda: printed(ARRANGEMENT, "tab:2[X,D_A]").should_be(
                8 * sp.sqrt(3) / 3, but_is=sp.Rational("4.62")
            ),
            "omni-arrangement tab:2[X,D_A]: the chapter says of `4.61` that it says"
            r" `\frac{231}{50}`, but print is 4.610 where that is 4.620; mend the chapter, its text"
            " or what it derives",
            id="a number",
        ),
    ],
)
def test_text_that_is_not_so_stops_the_chapter(say: Callable[[], Any], message: str) -> None:
    with pytest.raises(StaleTextError) as caught:
        say()
    assert str(caught.value) == message


@pytest.mark.parametrize(
    ("ask", "message"),
    [
        pytest.param(
            lambda: printed(ARRANGEMENT, "eq:7").agrees_with(sp.Symbol("alhpa_1")),
            "omni-arrangement has no symbol `alhpa_1`: did you mean `alpha_1`?",
            id="a letter that the paper lacks",
        ),
        pytest.param(
            lambda: printed(ARRANGEMENT, "eq:66"),
            "omni-arrangement derives no claim `eq:66`: did you mean `eq:6`?",
            id="no such claim",
        ),
        pytest.param(
            lambda: printed(ARRANGEMENT, "eq:6[4,3]"),
            "omni-arrangement derives no claim `eq:6[4,3]`: did you mean `eq:6`?",
            id="no such entry",
        ),
        pytest.param(
            lambda: printed(ARRANGEMENT, "sec:3/three-parameters"),
            "omni-arrangement sec:3/three-parameters is no single formula or number",
            id="a sentence",
        ),
        pytest.param(
            lambda: printed("omni", "eq:7"),
            "no folder paper_data/omni here or above: start in the project's folder",
            id="no such paper",
        ),
    ],
)
def test_what_cannot_be_asked(ask: Callable[[], Any], message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        ask()


def test_text_is_no_formula() -> None:
    """SymPy would evaluate a string as Python."""
    with pytest.raises(sp.SympifyError):
        printed(ARRANGEMENT, "eq:7").agrees_with("sin(alpha_1)")
