from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omniproof.report.latexfmt import is_settable
from omniproof.report.shorten import differing

TAIL = r"\left( a_{1} + b_{1}^{2} + \sqrt{c} \right) \cos \theta + \frac{1}{2} \sin \theta"


@pytest.mark.parametrize(
    ("printed", "correct", "expected"),
    [
        pytest.param("a + b", "a - b", ("a + b", "a - b"), id="short: whole"),
        pytest.param(
            rf"\int_{{0}}^{{t}} {TAIL}",
            rf"\frac{{1}}{{3}}\int_{{0}}^{{t}} {TAIL}",
            (r"\int_{0}^{t} \dots", r"\frac{1}{3}\int_{0}^{t} \dots"),
            id="a factor in front, with one unit of what follows",
        ),
        pytest.param(
            f"{TAIL} + x = 0",
            f"{TAIL} - x = 0",
            (r"\dots \theta + x \dots", r"\dots \theta - x \dots"),
            id="a sign in the middle",
        ),
        pytest.param(
            rf"y = \frac{{a}}{{b}} + {TAIL}",
            rf"y = \frac{{a}}{{c}} + {TAIL}",
            (r"\dots \frac{a}{b} \dots", r"\dots \frac{a}{c} \dots"),
            id="a command keeps its arguments",
        ),
        pytest.param(
            rf"{TAIL} + x^{{2}}",
            rf"{TAIL} + x^{{3}}",
            (r"\dots x^{2}", r"\dots x^{3}"),
            id="a base keeps its exponent",
        ),
    ],
)
def test_formulas_are_cut_to_where_they_differ(
    printed: str, correct: str, expected: tuple[str, str]
) -> None:
    assert differing(printed, correct) == expected


PIECES = st.sampled_from(
    ["a", r"\alpha_{1}", r"\frac{1}{2}", "+", r"\left( x \right)", "^{2}", r"\sqrt{b}", "{c}", "_i"]
)


@given(st.lists(PIECES, min_size=12, max_size=30), st.integers(0, 11), PIECES)
def test_what_is_cut_can_still_be_set(pieces: list[str], place: int, other: str) -> None:
    """Whatever differs: both sides have closed brackets, and no argument is left alone."""
    changed = [*pieces[:place], other, *pieces[place + 1 :]]
    for side in differing(" ".join(pieces), " ".join(changed)):
        assert is_settable(side)
        assert not side.startswith((r"\dots ^", r"\dots _", r"\dots {"))
