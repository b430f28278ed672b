from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omniproof.report.changes import changes
from omniproof.report.latexfmt import is_settable


def bare(latex: str) -> str:
    """A formula without marks, braces and spaces."""
    for mark in (r"\changed", r"\mathbin", r"\mathop", r"\nolimits", "{", "}", " "):
        latex = latex.replace(mark, "")
    return latex


@pytest.mark.parametrize(
    ("printed", "corrected", "parts", "marked"),
    [
        pytest.param(
            r"\sin a + b", r"\sin a - b", [("+", "-")], r"\sin a \mathbin{\changed{-}} b", id="sign"
        ),
        pytest.param("-a b_1", "a b_1", [("-", "")], "a b_1", id="left out"),
        pytest.param(
            "a_1 + b", "a_2 + b", [("a_1", "a_2")], r"{\changed{a_2}} + b", id="index and symbol"
        ),
        pytest.param(
            r"\cos x + y z",
            r"\sin x + y z",
            [(r"\cos", r"\sin")],
            r"\mathop{\changed{\sin}}\nolimits x + y z",
            id="function",
        ),
        pytest.param(
            r"\frac{1}{2} + c + d + e",
            r"\frac{\cos {p}}{2} + c + d + e",
            [("1", r"\cos p")],
            r"\frac{{\changed{\cos p}}}{2} + c + d + e",
            id="in a fraction",
        ),
        pytest.param("x = k/2", "x = k_0/2", [("k", "k_0")], r"x = {\changed{k_0}} / 2", id="base"),
        pytest.param(
            r"\left( \frac{a}{b} - c \right) d e",
            r"\left( \frac{a}{b} + c \right) d e",
            [("-", "+")],
            r"\left( \frac{a}{b} \mathbin{\changed{+}} c \right) d e",
            id="in brackets that grow",
        ),
    ],
)
def test_the_changed_part_is_whole(
    printed: str, corrected: str, parts: list[tuple[str, str]], marked: str
) -> None:
    found = changes(printed, corrected)
    assert found is not None
    assert list(found.parts) == parts
    assert found.corrected == marked
    assert is_settable(found.printed)


@pytest.mark.parametrize(
    ("printed", "corrected"),
    [
        pytest.param("a + b", "a + b", id="nothing changes"),
        pytest.param("a + b", r"\sqrt{c} d^2", id="two formulas"),
        pytest.param("grovel", "a global word", id="words"),
        pytest.param("by two roller.", "by two rollers.", id="a sentence"),
        pytest.param(r"\frac{a}{b", r"\frac{a}{c", id="broken"),
        pytest.param("a+b+c+d+e+f+g+h", "z+b+y+d+x+f+w+h", id="too many"),
    ],
)
def test_no_marks_where_they_would_not_help(printed: str, corrected: str) -> None:
    assert changes(printed, corrected) is None


PIECES = st.sampled_from(
    ["a", "b_1", "x^2", r"\sin x", "+", "-", r"\frac{a}{b}", "(", ")", r"\sqrt{c}", r"\bar{d}", "3"]
)
FORMULAS = st.lists(PIECES, min_size=4, max_size=9).map(" ".join)


@given(FORMULAS, FORMULAS)
def test_marks_change_nothing_else(printed: str, corrected: str) -> None:
    found = changes(printed, corrected)
    if found is not None:
        assert is_settable(found.printed)
        assert is_settable(found.corrected)
        assert bare(found.printed) == bare(printed)
        assert bare(found.corrected) == bare(corrected)
