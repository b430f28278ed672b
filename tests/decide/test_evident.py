"""Signs that the form of a printed term shows."""

from __future__ import annotations

import pytest

from omniproof.decide.order.evident import is_evident
from omniproof.formula.term import Symbol, Term
from omniproof.formula.unfold import unfold
from omniproof.transcription.reader import read

ASSUMED = frozenset({("a", ">"), ("b", "\\geq"), ("c", "<")})


def printed(text: str) -> Term:
    term = unfold(read(text), {name: Symbol(name) for name in "abcxy"}, text)
    assert isinstance(term, Term)
    return term


@pytest.mark.parametrize(
    ("text", "relation"),
    [
        pytest.param("x^2 + 1", ">", id="a square and a number"),
        pytest.param("x^2 + y^4", "\\geq", id="squares"),
        pytest.param("ab", "\\geq", id="positive and not negative"),
        pytest.param("ac - 1", "<", id="a negative product"),
        pytest.param(r"\frac{1}{b}", ">", id="where it is defined, a divisor is not 0"),
        pytest.param(r"\frac{1}{x^2}", ">", id="a square below"),
        pytest.param(r"\sqrt{x} + a", ">", id="a root is not negative"),
        pytest.param(r"|x| + |y|", "\\geq", id="absolute values"),
        pytest.param("a - c", "\\neq", id="not 0"),
        pytest.param("x^0", ">", id="the power 0"),
        pytest.param(r"\sqrt{2} + \sqrt{3} - \pi", ">", id="a number, by its value"),
        pytest.param(r"2 - \sqrt{4}", "=", id="a number that is 0"),
    ],
)
def test_evident(text: str, relation: str) -> None:
    assert is_evident(printed(text), relation, ASSUMED)


@pytest.mark.parametrize(
    ("text", "relation"),
    [
        pytest.param("x^2", ">", id="0 at 0"),
        pytest.param("x^3", "\\geq", id="an odd power"),
        pytest.param("a + c", ">", id="two signs"),
        pytest.param("x^2 - x + 1", ">", id="true, and not by its form"),
        pytest.param("b", "\\neq", id="may be 0"),
        pytest.param(r"\sin x + 2", ">", id="a sine may be anything here"),
    ],
)
def test_not_evident(text: str, relation: str) -> None:
    assert not is_evident(printed(text), relation, ASSUMED)


def test_what_a_condition_keeps_from_0_is_not_0() -> None:
    distance = printed("x - y")
    assert is_evident(printed("(x - y)^2"), ">", (), {distance})
    assert not is_evident(printed("(x - y)^2"), ">")
