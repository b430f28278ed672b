"""Identities too large to multiply out, that say something of a few parts only."""

from __future__ import annotations

import pytest

from omniproof.decide.normal_form import recurring
from omniproof.decide.normal_form.form import normal_form
from omniproof.decide.normal_form.recurring import vanishes_in_parts
from omniproof.formula.errors import WorkLimitError
from omniproof.formula.term import Symbol, Term, substitute
from omniproof.formula.unfold import unfold
from omniproof.transcription.reader import read

PLACES = range(1, 8)
LONG = {
    name: " + ".join(rf"{letter}_{k}\sin {letter}_{k}" for k in PLACES)
    for name, letter in (("a", "p"), ("b", "q"), ("c", "s"))
}
"""What is put in: a sum of products of numbers and their sines."""


def printed(text: str) -> Term:
    """Read a formula in a, b and c, with long sums in their places."""
    names = {name: Symbol(name) for name in ["a", "b", "c", "x", "y"]}
    parts = {f"{letter}_{k}": Symbol(f"{letter}_{k}") for letter in "pqs" for k in PLACES}
    values = {name: unfold(read(long), parts, long) for name, long in LONG.items()}
    term = unfold(read(text), names, text)
    return substitute(term, values)


@pytest.mark.parametrize(
    ("left", "right", "said"),
    [
        pytest.param("(a + b)(a - b)", "a^2 - b^2", True, id="as it is"),
        pytest.param(r"\frac{a^3 - b^3}{a - b}", "a^2 + ab + b^2", True, id="a quotient"),
        pytest.param("(a + b + c)^2 - (a + b)^2", "2c(a + b) + c^2", True, id="sums of sums"),
        pytest.param(r"a(\sin(x + y)\cos x - \cos(x + y)\sin x)", r"a\sin y", True,
                     id="an angle stays as it is"),
        pytest.param("(a + b)(a - b)", "a^2 + b^2", False, id="false"),
        pytest.param("(a + b)^2", "(a + b)^2 + c - c + x", False, id="a difference of its own"),
    ],
)  # fmt: skip
def test_parts_that_recur_are_numbers_like_others(left: str, right: str, said: bool) -> None:
    assert vanishes_in_parts(printed(left), printed(right)) is said


def test_what_is_proved_is_too_large_for_the_normal_form_alone() -> None:
    left, right = printed("(a + b + c)^3(a - b)^3"), printed("((a - b)(a + b + c))^3")
    with pytest.raises(WorkLimitError):
        normal_form(left, right)
    assert vanishes_in_parts(left, right)


def test_a_point_alone_proves_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recurring, "_seems_zero", lambda _: True)
    assert not vanishes_in_parts(printed("ab + x"), printed("ba + y"))
