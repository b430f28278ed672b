"""Conditions on signs, by cases: with what is assumed, and without."""

from __future__ import annotations

from typing import Any

import pytest
from sympy import And, Gt, Integer, Lt, Ne, Or, Symbol, pi, symbols

from omniproof.audit.sign_cases import equivalent
from omniproof.decide.answer import Proved, Refuted, Undecided

x, y, z = symbols("x y z", real=True)
u = Symbol("u", positive=True)
n = Symbol("n", real=True, nonzero=True)


@pytest.mark.parametrize(
    ("printed", "derived", "expected"),
    [
        pytest.param(x * y > 0, Or(And(x > 0, y > 0), And(x < 0, y < 0)), Proved,
                     id="a product is positive iff the signs agree"),
        pytest.param(-x * y < 0, x * y > 0, Proved, id="both sides times -1"),
        pytest.param(x * u**2 > 0, x > 0, Proved, id="a positive factor"),
        pytest.param(x * n**2 > 0, x > 0, Proved, id="a square that is not zero"),
        pytest.param(x * y > 0, x > 0, Refuted, id="one sign says nothing of the other"),
        pytest.param(x >= 0, x > 0, Refuted, id="they differ at zero"),
        pytest.param(x * y**2 > 0, x > 0, Refuted, id="a square may be zero"),
    ],
)  # fmt: skip
def test_without_assumptions(printed: Any, derived: Any, expected: type) -> None:
    assert isinstance(equivalent(printed, derived), expected)


@pytest.mark.parametrize(
    ("printed", "derived", "assumed", "expected"),
    [
        pytest.param(x * y > 0, x > 0, [y > 0], Proved, id="a factor is positive"),
        pytest.param(x * y > 0, x > 0, [Lt(0, y)], Proved, id="the same, turned round"),
        pytest.param(x * y > 0, x > 0, [y >= 0], Refuted, id="a factor may be zero"),
        pytest.param(x * y > 0, x > 0, [y > pi / 6], Proved, id="beyond a positive number"),
        pytest.param(x * y > 0, x > 0, [y > -1], Refuted, id="beyond a negative number"),
        pytest.param(x * y < 0, x > 0, [y < -pi], Proved, id="below a negative number"),
        pytest.param(x * y > 0, x > 0, [y < 1], Refuted, id="below a positive number"),
        pytest.param(x * y > 0, x > 0, [And(y > 0, y < pi / 2)], Proved, id="a chain of two"),
        pytest.param(x * y**2 > 0, x > 0, [Ne(y, 0)], Proved, id="not zero"),
        pytest.param(x * y**2 > 0, x > 0, [Ne(y, 1)], Refuted, id="not one"),
        pytest.param(x > 0, y > 0, [x * y > 0], Proved, id="signs that agree"),
        pytest.param(x > 0, y > 0, [x * z > 0, y * z > 0], Proved, id="by way of a third symbol"),
        pytest.param(x > 0, y > 0, [Gt(x, y, evaluate=False)], Undecided, id="an order"),
        pytest.param(x * u > 0, x > 0, [x > y], Proved, id="an order that is not needed"),
    ],
)
def test_with_assumptions(printed: Any, derived: Any, assumed: Any, expected: type) -> None:
    assert isinstance(equivalent(printed, derived, assumed), expected)


def test_the_case_in_which_they_differ_is_shown() -> None:
    answer = equivalent(x >= 0, x > 0)
    assert isinstance(answer, Refuted)
    assert str(answer.witness) == "x=0; printed=true; derived=false"


def test_the_case_is_one_that_may_be() -> None:
    answer = equivalent(x * y > 0, x > 0, [x > Integer(1)])
    assert isinstance(answer, Refuted)
    assert answer.witness.point == {"x": "1", "y": "-1"}


def test_conditions_on_sums_are_undecided() -> None:
    answer = equivalent(x + y > 0, x > 0)
    assert answer == Undecided("a condition is not on the sign of a monomial")


def test_what_cannot_be_used_is_told() -> None:
    assert equivalent(x > 0, y > 0, [x > y]) == Undecided(
        "it is not proved from $x > y$, and false without"
    )
