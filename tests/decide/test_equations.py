"""Equations of terms: where they are asserted, and what a witness shows."""

from __future__ import annotations

import pytest

from omniproof.decide.answer import OnBranch, Proved, Refuted, Undecided
from omniproof.decide.confirm import confirmed_equal
from omniproof.decide.domain import REALS, Domain
from omniproof.decide.zero_test import decide_equal
from omniproof.formula.term import PI, ZERO, Symbol, Term, divide, negative, number, subtract
from omniproof.formula.unfold import unfold
from omniproof.transcription.reader import read

NAMES = {name: Symbol(name) for name in "xyL"}
X, Y = NAMES["x"], NAMES["y"]


def sides(text: str) -> tuple[Term, Term]:
    left, right = unfold(read(text), NAMES)
    return left, right


@pytest.mark.parametrize(
    ("text", "domain", "answer"),
    [
        pytest.param(r"|x| = x", Domain({"x": (ZERO, None)}), Proved, id="a positive symbol"),
        pytest.param(r"|x| = -x", Domain({"x": (None, ZERO)}), Proved, id="a negative one"),
        pytest.param(r"|x| = x", Domain({"x": (subtract(PI, number(3)), None)}), Proved,
                     id="above what is positive"),
        pytest.param(r"|x| = x", Domain({"x": (subtract(number(1), PI), None)}), OnBranch,
                     id="above what is negative"),
        pytest.param(r"|x - y| = x - y", Domain(positive=(subtract(X, Y),)), Proved, id="an order"),
        pytest.param(r"|x - y| = y - x", Domain(positive=(subtract(X, Y),)), Refuted,
                     id="another order"),
        pytest.param(r"|\cos x| = \cos x", Domain({"x": (ZERO, divide(PI, number(2)))}), Proved,
                     id="a quarter of a turn"),
        pytest.param(r"|x| = x", Domain(positive=(X, negative(X))), Undecided, id="no point"),
    ],
)  # fmt: skip
def test_an_equation_is_judged_in_its_domain(text: str, domain: Domain, answer: type) -> None:
    assert isinstance(decide_equal(*sides(text), domain), answer)


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        pytest.param(r"(\sqrt{x})^2 = |x|", Proved, id="a radicand is not negative"),
        pytest.param(r"(\sqrt{-x})^2 = |x|", Proved, id="nor is its opposite"),
        pytest.param(r"(\sqrt{x y})^2 = |x y|", Proved, id="a product"),
        pytest.param(r"\sqrt{x}^2 \sqrt{y}^2 = |x| |y|", Proved, id="two of them"),
        pytest.param(r"|1 - \sin(\arcsin x)| = 1 - x", Proved, id="an arc sine is of at most 1"),
        pytest.param(r"|\cos(\arccos x) + 1| = 1 + x", Proved, id="and of at least -1"),
        pytest.param(r"(\sqrt{x})^2 = -|x|", Refuted, id="false where it is defined"),
        pytest.param(r"\sqrt{x^2} = x", OnBranch, id="a square says nothing of its base"),
    ],
)
def test_an_equation_is_judged_where_it_is_defined(text: str, answer: type) -> None:
    assert isinstance(confirmed_equal(*sides(text)), answer)


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        pytest.param(r"x + y = x", {"x", "y"}, id="what matters"),
        pytest.param(r"x + L - L = 2 x + 1", {"x"}, id="what is taken away again"),
        pytest.param(r"\frac{L x}{L} = y", {"x", "y"}, id="what is divided out"),
        pytest.param(r"0 L + x = 1", {"x"}, id="a multiple of 0"),
    ],
)
def test_a_witness_has_the_symbols_that_matter(text: str, shown: set[str]) -> None:
    answer = confirmed_equal(*sides(text))
    assert isinstance(answer, Refuted)
    assert answer.witness.point.keys() == shown


@pytest.mark.parametrize(
    ("domain", "expected"),
    [
        pytest.param(REALS, True, id="all numbers"),
        pytest.param(Domain({"x": (ZERO, None)}), True, id="a positive symbol"),
        pytest.param(Domain({"x": (None, ZERO)}), False, id="a negative one"),
        pytest.param(Domain({"x": (ZERO, PI)}), False, id="a range"),
        pytest.param(Domain(positive=(X,)), False, id="a condition"),
    ],
)
def test_an_orthant_says_of_symbols_that_they_are_positive(domain: Domain, expected: bool) -> None:
    assert domain.is_orthant is expected
