"""Derivatives by rules, held against the power series of ball arithmetic."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq

from omniproof.decide.balls import compile_balls, enclose
from omniproof.formula.derivative import derivative
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.functions import FUNCTIONS, Lacks
from omniproof.formula.term import ONE, ZERO, Call, Symbol, Term, number
from omniproof.formula.unfold import applied, unfold
from omniproof.transcription.reader import read

X, Y = Symbol("x"), Symbol("y")
KNOWN = [row for row in FUNCTIONS.values() if not isinstance(row.derivative, Lacks)]
PLACE = fmpq(2, 7)


def by_series(term: Term) -> arb:
    """Return the first Taylor coefficient at `PLACE`."""
    return compile_balls([term], ["x"]).taylor([arb(PLACE)], [1], 1)[0][1]


@pytest.mark.parametrize("name", [pytest.param(row.name, id=row.name) for row in KNOWN])
def test_every_function_of_the_table(name: str) -> None:
    arguments = (X, number(Fraction(3, 5)))[: FUNCTIONS[name].arguments]
    term = applied(name, arguments)
    found, wanted = enclose(derivative(term, "x"), {"x": PLACE}), by_series(term)
    assert found.overlaps(wanted)
    assert found.is_finite()


@pytest.mark.parametrize(
    "text",
    [
        pytest.param("x^3 - 2x + 5", id="a polynomial"),
        pytest.param(r"\frac{1}{x^2 + 1}", id="a quotient"),
        pytest.param("x x x", id="a product"),
        pytest.param(r"\sin(x^2) \cos(3x)", id="a chain"),
        pytest.param(r"\sqrt{1 + \tan x}", id="a root of a function"),
    ],
)
def test_rules(text: str) -> None:
    term = unfold(read(text), {"x": X}, text)
    assert enclose(derivative(term, "x"), {"x": PLACE}).overlaps(by_series(term))


def test_what_is_constant_gives_0() -> None:
    assert derivative(Call("sin", (Y,)), "x") == ZERO
    assert derivative(X, "x") == ONE


def test_an_unknown_function_has_no_rule() -> None:
    with pytest.raises(UnsupportedError, match="the derivative of atan2 is not known"):
        derivative(Call("atan2", (X, Y)), "x")
