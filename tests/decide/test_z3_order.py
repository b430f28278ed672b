"""Points of a range with given signs: found where there are some, and none where there is none."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Abs, Rational, cos, pi, sin, sqrt, tan

from omniproof.decide.balls import enclose
from omniproof.decide.order.confirm_order import region_of
from omniproof.decide.z3 import order
from omniproof.decide.z3.equation import NoAnswer
from omniproof.decide.z3.order import STEPS, Nowhere, OrderAnswer, Region, Somewhere
from omniproof.formula.sympy_terms import assumed_signs, term_of
from omniproof.formula.term import ZERO, Term
from omniproof.formula.value import Comparison

x, y, A, B = sp.symbols("x y A B", real=True)
p, q, r = sp.symbols("p q r", positive=True)
TRIANGLE = {A: (sp.S.Zero, pi), B: (sp.S.Zero, pi)}
SUM = cos(A) + cos(B) - cos(A + B)
MOTZKIN = x**4 * y**2 + x**2 * y**4 + 1 - 3 * x**2 * y**2


Sign = tuple[sp.Expr, str]


def within(
    ranges: Mapping[sp.Symbol, tuple[Any, Any]],
    closed: Mapping[sp.Symbol, tuple[bool, bool]] | None = None,
    conditions: tuple[Any, ...] = (),
    apart: tuple[tuple[Any, ...], ...] = (),
) -> Region:
    return region_of(ranges, closed or {}, conditions, (), apart)


EVERYWHERE = within({})


def on(lower: Any, upper: Any, left: bool = False, right: bool = False) -> Region:
    return within({x: (sp.sympify(lower), sp.sympify(upper))}, {x: (left, right)})


def find_point(signs: Sequence[Sign], region: Region, *, steps: int = STEPS) -> OrderAnswer:
    """Ask for a point at which formulas stand to 0 as they should."""
    assumed = assumed_signs(*(formula for formula, _ in signs))
    statements = [Comparison(term_of(formula), sign, ZERO) for formula, sign in signs]
    own = replace(region, assumed=region.assumed | assumed)
    return order.find_point(statements, own, steps=steps)


def as_float(end: Term | None) -> float:
    assert end is not None
    return float(enclose(end).mid())


NOWHERE = [
    pytest.param(MOTZKIN, "<", EVERYWHERE, id="Motzkin: positive, and no sum of squares"),
    pytest.param(x**2 + x * y + y**2, "<", EVERYWHERE, id="a positive form"),
    pytest.param((p + q) / 2 - sqrt(p * q), "<", EVERYWHERE, id="two means"),
    pytest.param((p + q + r) / 3 - sp.cbrt(p * q * r), "<", EVERYWHERE, id="cube roots"),
    pytest.param(sqrt(x), "<", EVERYWHERE, id="a root is not negative"),
    pytest.param(Abs(x) + Abs(y) - Abs(x + y), "<", EVERYWHERE, id="triangle inequality"),
    pytest.param(p + 1 / p - 2, "<", EVERYWHERE, id="a fraction"),
    pytest.param(SUM - Rational(3, 2), ">", within(TRIANGLE), id="tight: equality inside"),
    pytest.param(SUM - Rational(3, 2), "\\geq", within(TRIANGLE, apart=((pi / 3, pi / 3),)),
                 id="tight: equality there only"),
    pytest.param(x**2 + 1, "=", EVERYWHERE, id="no zero"),
    pytest.param(1 / x, "=", EVERYWHERE, id="undefined is no zero"),
    pytest.param(tan(x), ">", on(pi / 2, pi), id="an obtuse angle"),
    pytest.param(x**2 - x, "\\geq", on(0, 1), id="open ends"),
    pytest.param(x, "<", on(0, 1, True, True), id="closed ends, not strict"),
    pytest.param(x - 4, "\\geq", on(0, pi), id="a transcendental end, rounded outwards"),
    pytest.param(x - y, ">", within({}, conditions=(x < y,)), id="a condition"),
]  # fmt: skip


@pytest.mark.parametrize(("formula", "relation", "region"), NOWHERE)
def test_there_is_no_such_point(formula: sp.Expr, relation: str, region: Region) -> None:
    assert find_point([(formula, relation)], region, steps=500_000) == Nowhere()


SOMEWHERE = [
    pytest.param(MOTZKIN, "\\leq", EVERYWHERE, id="Motzkin touches zero"),
    pytest.param(MOTZKIN - Rational(1, 1000), "<", EVERYWHERE, id="a little less"),
    pytest.param(SUM - Rational(3, 2), "\\geq", within(TRIANGLE), id="tight: strict is false"),
    pytest.param(SUM - Rational(149, 100), ">", within(TRIANGLE), id="not the best bound"),
    pytest.param((p + q) / 2 - sqrt(p * q), "\\leq", EVERYWHERE, id="equal means"),
    pytest.param(sqrt(x) - x, ">", EVERYWHERE, id="a root above its radicand"),
    pytest.param(x**2 - x, "\\geq", on(0, 1, True), id="the lower end belongs to it"),
    pytest.param(x**2 - x, "\\geq", on(0, 1, False, True), id="the upper end belongs to it"),
    pytest.param(sin(x), "\\leq", on(0, pi, True), id="a closed end of half a turn"),
    pytest.param(cos(x) - 1, "\\geq", on(0, 2 * pi, True), id="a closed end of a full turn"),
    pytest.param(cos(x / 2), "<", on(0, 2 * pi), id="half an angle, all the way round"),
]


@pytest.mark.parametrize(("formula", "relation", "region"), SOMEWHERE)
def test_there_is_such_a_point(formula: sp.Expr, relation: str, region: Region) -> None:
    found = find_point([(formula, relation)], region)
    assert isinstance(found, Somewhere)
    assert found.exact
    value = float(
        formula.subs(
            {symbol: sp.Rational(found.point[symbol.name]) for symbol in formula.free_symbols}
        )
    )
    assert value < 1e-9 if relation in {"<", "\\leq"} else value > -1e-9
    for name, (lower, upper) in region.ranges.items():
        assert as_float(lower) - 1e-9 <= found.point[name] <= as_float(upper) + 1e-9


@pytest.mark.parametrize(
    ("formula", "region"),
    [
        pytest.param(x - sin(x), EVERYWHERE, id="angle and number"),
        pytest.param(x - 3, on(0, pi), id="a transcendental end"),
        pytest.param(sin(x), on(-1, 1), id="an angle with a range in radians"),
        pytest.param(cos(A), within({}, conditions=(A < B,)), id="a condition on an angle itself"),
    ],
)
def test_a_question_that_was_widened_finds_candidates_only(
    formula: sp.Expr, region: Region
) -> None:
    found = find_point([(formula, "<")], region)
    assert isinstance(found, Somewhere)
    assert not found.exact


@pytest.mark.parametrize(
    ("formula", "region", "reason"),
    [
        pytest.param(sp.exp(x), EVERYWHERE, "exp is no rational function", id="exponential"),
        pytest.param(x ** Rational(1, 9), EVERYWHERE, "a root of the order 9 is not small",
                     id="root"),
        pytest.param(sp.Add(*(x**k * y for k in range(30)), evaluate=False), EVERYWHERE,
                     "it has more than 127 operations", id="operations"),
        pytest.param(sp.Add(*sp.symbols("a:10", real=True)), EVERYWHERE,
                     "it has more than 9 variables", id="variables"),
        pytest.param(sin(x), within({x: (sp.S.Zero, 3 * pi)}, apart=((pi,),)),
                     "x takes more than one turn", id="one point of two turns"),
        pytest.param(sin(x), within({x: (sp.S.Zero, 2 * pi)}, {x: (True, True)}, apart=((0,),)),
                     "x takes more than one turn", id="both ends of a turn"),
        pytest.param(sin(x), within({x: (sp.S.Zero, pi), y: (sp.S.Zero, pi)}, apart=((pi, 1),)),
                     "it is constant in a symbol, so that no point stands alone", id="constant"),
    ],
)  # fmt: skip
def test_not_asked(formula: sp.Expr, region: Region, reason: str) -> None:
    assert find_point([(formula, ">")], region) == NoAnswer(reason)


def test_the_limit_is_on_steps() -> None:
    found = find_point([(SUM - Rational(3, 2), ">")], within(TRIANGLE), steps=500)
    assert found == NoAnswer("no answer within 500 steps")


def test_several_signs_hold_at_one_point() -> None:
    found = find_point([(x - 1, ">"), (x**2 - 2, "<")], EVERYWHERE)
    assert isinstance(found, Somewhere)
    assert 1 < found.point["x"] < Fraction(3, 2)
    assert find_point([(x - 1, ">"), (x**2 - 1, "<")], EVERYWHERE) == Nowhere()


small = st.integers(-4, 4)


@settings(max_examples=60, deadline=None)
@given(small, small, small)
def test_quadratic_forms(a: int, b: int, c: int) -> None:
    """By Sylvester: a x^2 + b x y + c y^2 is never negative iff a, c and 4ac - b^2 are not."""
    found = find_point([(a * x**2 + b * x * y + c * y**2, "<")], EVERYWHERE)
    never = a >= 0 and c >= 0 and 4 * a * c >= b * b
    assert isinstance(found, Nowhere) == never


@settings(max_examples=80, deadline=None)
@given(st.integers(-12, 12), st.integers(1, 13), st.booleans(), st.booleans(), st.integers(0, 11))
def test_arcs(start: int, length: int, left: bool, right: bool, turn: int) -> None:
    """An angle of 30 degrees times `turn` lies on an arc iff one of its full turns does."""
    end, step = start + length, pi / 6
    at = [(cos(x) - cos(turn * step), "="), (sin(x) - sin(turn * step), "=")]
    found = find_point(at, on(start * step, end * step, left, right))
    among = range(start + (not left), end + right)
    assert isinstance(found, Somewhere) == any((k - turn) % 12 == 0 for k in among)
