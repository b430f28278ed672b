"""Symbols of a formula: how they are spelled, what is assumed of them, what is refused."""

from __future__ import annotations

import pytest
import sympy as sp

from omniproof.audit.setting import Assumptions, settle
from omniproof.decide.in_sympy.domain import in_sympy
from omniproof.formula.sympy_terms import Converter
from omniproof.transcription.tokens import LatexError


def setting(text: str, assumptions: Assumptions | None = None):
    said = assumptions or Assumptions()
    return settle(said.read(text), said)


@pytest.mark.parametrize(
    ("printed", "name", "latex"),
    [
        pytest.param(r"\theta", "theta", r"\theta", id="greek"),
        pytest.param(r"\alpha_1", "alpha_1", r"\alpha_{1}", id="index"),
        pytest.param(r"v_{\text{max}}", "v_max", "v_{max}", id="word as index"),
        pytest.param(r"\alpha_{k,1}", "alpha_k_1", r"\alpha_{k 1}", id="two indices"),
        pytest.param(r"\dot{\phi}", "phidot", r"\dot{\phi}", id="accent"),
        pytest.param(r"\hat{a}_1", "ahat_1", r"\hat{a}_{1}", id="accent and index"),
        pytest.param("a'", "aprime", "{a}'", id="prime"),
        pytest.param(r"\mathbf{L}", "L", "L", id="font"),
        pytest.param(r"\hat{a_1}", r"\hat{a_1}", r"\hat{a_1}", id="no plain spelling"),
    ],
)
def test_a_symbol_is_spelled_without_latex_and_prints_as_latex(printed, name, latex):
    (symbol,) = setting(f"{printed} = 1").letters.values()
    assert (symbol.name, sp.latex(sp.Symbol(symbol.name))) == (name, latex)


def test_two_symbols_never_share_a_spelling():
    found = setting(r"a_{k,1} + a_{k_1} = 1").letters
    assert len({symbol.name for symbol in found.values()}) == 2


@pytest.mark.parametrize(
    ("assumptions", "interval"),
    [
        pytest.param(Assumptions(positive=("x",)), (0, sp.oo), id="positive"),
        pytest.param(Assumptions(between=("x > 2",)), (2, sp.oo), id="above"),
        pytest.param(Assumptions(between=("x < 2",)), (-sp.oo, 2), id="below"),
        pytest.param(Assumptions(between=(r"-1 < x < 90^\circ",)), (-1, sp.pi / 2), id="both"),
        pytest.param(Assumptions(between=(r"\sqrt{2} > x > 1",)), (1, sp.sqrt(2)), id="downwards"),
        pytest.param(Assumptions(("x",), ("-1 < x < 2", "x < 3")), (0, 2), id="several"),
    ],
)
def test_ranges(assumptions, interval):
    found = setting("x = y", assumptions)
    assert in_sympy(found.domain, Converter()).intervals == {"x": interval}
    assert ("x" in found.domain.nonnegative) == (interval[0] >= 0)
    assert "y" not in found.domain.nonnegative


FAULTS = [
    pytest.param("c(x) = 1", Assumptions(functions={"c": "gamma"}), [
        "the function `gamma` is not read",
        "    c=gamma",
        "    ~~~~~~^",
        "    did you mean `c=cos`?"], id="unknown function"),
    pytest.param(r"\alpha_1 = 0", Assumptions(positive=(r"\alpha_2",)), [
        r"the formula has no symbol `\alpha_2`",
        r"    \alpha_2",
        "    ~~~~~~~^",
        r"    did you mean `\alpha_1`?"], id="assumption about no symbol"),
    pytest.param("x = 1", Assumptions(positive=("2x",)), [
        "expected a symbol, found `2`",
        "    2x",
        "    ^"], id="no symbol is positive"),
    pytest.param("x = 1", Assumptions(between=("2 < x < 1",)), [
        "the range of `x` is empty",
        "    2 < x < 1",
        "    ~~~~~~~~^",
        "    write the smaller bound on the left"], id="empty range"),
    pytest.param("x = 1", Assumptions(("x",), ("x < 0",)), [
        "the range of `x` is empty",
        "    x < 0",
        "    ~~~~^",
        "    write the smaller bound on the left"], id="empty together"),
    pytest.param("x = 1", Assumptions(between=(r"0 \leq x < 1",)), [
        "expected a range with `<`",
        r"    0 \leq x < 1",
        "    ~~~~~~~~~~~^",
        "    write `0 < x < 1`: ends do not belong to it"], id="closed range"),
    pytest.param("x = 1", Assumptions(between=("0 < x < y",)), [
        "expected a number as the end of a range",
        "    0 < x < y",
        "    ~~~~~~~~^",
        "    write `0 < x < 1`"], id="symbol as an end"),
    pytest.param("x = 1", Assumptions(between=("0 < 2x",)), [
        "expected one symbol between two numbers",
        "    0 < 2x",
        "    ~~~~~^",
        "    write `0 < x < 1`"], id="product in a range"),
    pytest.param("x = 1", Assumptions(between=(r"x > \sqrt{-1}",)), [
        "expected a number as the end of a range: it is not a finite real number",
        r"    x > \sqrt{-1}",
        "    ~~~~~~~~~~~~^",
        "    write `0 < x < 1`"], id="imaginary end"),
    pytest.param("x = 1", Assumptions(between=("x > (1, 2)",)), [
        "expected a number as the end of a range, found a vector of 2",
        "    x > (1, 2)",
        "    ~~~~~~~~~^",
        "    write `0 < x < 1`"], id="a vector as an end"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "assumptions", "message"), FAULTS)
def test_what_is_refused(text, assumptions, message):
    with pytest.raises(LatexError) as refused:
        setting(text, assumptions)
    assert str(refused.value).splitlines() == message
