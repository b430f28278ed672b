"""Terms keep what is printed: nothing cancels, and bound variables stay bound."""

from __future__ import annotations

from fractions import Fraction

import pytest

from omniproof.formula.errors import UnsupportedError
from omniproof.formula.monomials import expand, is_plainly_zero
from omniproof.formula.term import (
    ONE,
    PI,
    ZERO,
    Call,
    Integral,
    Power,
    Product,
    Sum,
    Symbol,
    Term,
    add,
    divide,
    multiply,
    negative,
    number,
    rational,
    root,
    substitute,
    subtract,
    symbols,
    walk,
)

x, y, t = Symbol("x"), Symbol("y"), Symbol("t")
AREA = Integral(multiply(x, t), t, ZERO, t)
"""The variable has the name of the upper end, as papers print it."""


@pytest.mark.parametrize(
    ("one", "other"),
    [
        pytest.param(subtract(x, x), ZERO, id="a difference of equals"),
        pytest.param(divide(x, x), ONE, id="a quotient of equals"),
        pytest.param(Sum((x, y)), Sum((y, x)), id="another order"),
        pytest.param(root(Power(x, 2)), Call("abs", (x,)), id="the root of a square"),
        pytest.param(Product((x, y)), Sum((x, y)), id="another sign"),
    ],
)
def test_terms_are_equal_where_they_are_written_alike(one: Term, other: Term) -> None:
    assert one != other
    assert one == substitute(one, {})
    assert hash(one) == hash(substitute(one, {}))


@pytest.mark.parametrize(
    ("term", "value"),
    [
        pytest.param(divide(number(3), number(4)), Fraction(3, 4), id="a fraction"),
        pytest.param(subtract(ONE, number(3)), Fraction(-2), id="a difference"),
        pytest.param(Power(number(2), -3), Fraction(1, 8), id="an inverse power"),
        pytest.param(Power(ZERO, -1), None, id="a division by zero"),
        pytest.param(multiply(ZERO, x), None, id="a symbol, even times zero"),
        pytest.param(PI, None, id="pi"),
    ],
)
def test_numbers_have_a_rational_value(term: Term, value: Fraction | None) -> None:
    assert rational(term) == value


def test_a_bound_variable_is_no_symbol() -> None:
    assert symbols(AREA) == {"x", "t"}
    assert symbols(Integral(t, t, ZERO, ONE)) == set()


def test_a_bound_variable_is_not_replaced() -> None:
    half = number(Fraction(1, 2))
    assert substitute(AREA, {"t": half}) == Integral(multiply(x, t), t, ZERO, half)
    assert substitute(AREA, {"x": t, "t": x}) == Integral(multiply(t, t), t, ZERO, x)


def test_parts_are_met_once_from_the_inside() -> None:
    shared = root(x)
    assert list(walk(add(shared, shared, y))) == [x, shared, y, add(shared, shared, y)]


@pytest.mark.parametrize(
    ("term", "zero"),
    [
        pytest.param(subtract(x, x), True, id="a difference of equals"),
        pytest.param(multiply(ZERO, root(x)), True, id="a product with zero"),
        pytest.param(
            subtract(multiply(add(x, y), add(x, negative(y))), subtract(Power(x, 2), Power(y, 2))),
            True,
            id="a difference of squares",
        ),
        pytest.param(subtract(x, y), False, id="two symbols"),
        pytest.param(subtract(divide(x, x), ONE), True, id="a quotient, where it is defined"),
    ],
)
def test_what_vanishes_when_it_is_multiplied_out(term: Term, zero: bool) -> None:
    assert is_plainly_zero(term) is zero


def test_an_angle_is_taken_apart() -> None:
    found = expand(divide(add(x, multiply(number(3), PI), negative(x), y), number(2)))
    assert found == {
        frozenset({(PI, 1)}): Fraction(3, 2),
        frozenset({(y, 1)}): Fraction(1, 2),
    }


def test_too_many_monomials_are_refused() -> None:
    factors = tuple(Sum((Symbol(f"a_{k}"), Symbol(f"b_{k}"))) for k in range(12))
    with pytest.raises(UnsupportedError, match="more than 1000 monomials"):
        expand(Product(factors))
