"""Integrals of unknown functions: equal for all functions, different for some, or not compared."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy as sp

from omniproof.decide.answer import Proved, Refuted, Undecided
from omniproof.decide.in_sympy.counterexample import counterexample
from omniproof.decide.in_sympy.domain import REALS, Domain
from omniproof.decide.in_sympy.equality import confirmed_equal
from omniproof.decide.in_sympy.integrals import flattened, without_integrals
from omniproof.formula.errors import UnsupportedError

t, s = sp.symbols("t s", real=True)
T, L = sp.symbols("T L", positive=True)
f, g = (sp.Function(name, real=True) for name in "fg")
turned = sp.Integral(f(t) + g(t), (t, 0, t)) / L


def up_to_time(integrand: sp.Expr) -> sp.Expr:
    return sp.Integral(integrand, (t, 0, t))


EQUAL = [
    pytest.param(up_to_time(f(t)) + up_to_time(g(t)), up_to_time(f(t) + g(t)), id="linear"),
    pytest.param(up_to_time(f(t) / L), up_to_time(f(t)) / L, id="constant factor"),
    pytest.param(up_to_time(f(s).subs(s, t)), sp.Integral(f(s), (s, 0, t)), id="another variable"),
    pytest.param(up_to_time(2 + f(t)), 2 * t + up_to_time(f(t)), id="a constant gives the length"),
    pytest.param(up_to_time(f(t) * sp.cos(turned)) / 3, up_to_time(f(t) / 3 * sp.cos(turned)),
                 id="one inside another"),
    pytest.param(up_to_time(g(t) * (sp.sin(turned) ** 2 + sp.cos(turned) ** 2) * f(t)),
                 up_to_time(f(t) * g(t)), id="integrands that are equal"),
    pytest.param(sp.sin(2 * turned), 2 * sp.sin(turned) * sp.cos(turned), id="of integrals"),
    pytest.param(sp.Integral(sp.sqrt(f(t) ** 2), (t, 0, T)) / T,
                 sp.Integral(sp.Abs(f(t)) / T, (t, 0, T)), id="up to a fixed time"),
]  # fmt: skip


@pytest.mark.parametrize(("left", "right"), EQUAL)
def test_equal(left: sp.Expr, right: sp.Expr) -> None:
    assert isinstance(confirmed_equal(left, right), Proved)


DIFFERENT = [
    pytest.param(up_to_time(f(t) * sp.cos(turned)), up_to_time(f(t) * sp.cos(turned)) / 3,
                 id="a factor"),
    pytest.param(up_to_time(f(t)), up_to_time(g(t)), id="another function"),
    pytest.param(up_to_time(f(t) * g(t)), up_to_time(f(t) ** 2), id="another integrand"),
    pytest.param(up_to_time(f(t) * up_to_time(g(t))), up_to_time(g(t) * up_to_time(f(t))),
                 id="values and integrals are told apart"),
    pytest.param(up_to_time(f(t)) ** 2, up_to_time(f(t)), id="a power"),
    pytest.param(f(t), f(T), id="values at two times"),
]  # fmt: skip


@pytest.mark.parametrize(("left", "right"), DIFFERENT)
def test_different(left: sp.Expr, right: sp.Expr) -> None:
    assert isinstance(confirmed_equal(left, right), Refuted)


REFUSED = [
    pytest.param(up_to_time(t * f(t)), t * up_to_time(f(t)) - up_to_time(up_to_time(f(t))),
                 "different ranges", id="true by parts, and not seen to be"),
    pytest.param(sp.Integral(f(t) * sp.Abs(t - 1), (t, 0, T)),
                 sp.Integral(f(t) * sp.sqrt((1 - t) ** 2), (t, 0, T)),
                 "fixed time", id="true, time itself up to a fixed time"),
    pytest.param(sp.Integral(f(t) ** 2, (t, 0, T)), up_to_time(f(t) ** 2), "different ranges",
                 id="other limits"),
    pytest.param(t * up_to_time(f(t) ** 2), up_to_time(t * f(t) ** 2), "constant factor",
                 id="a factor that changes"),
    pytest.param(up_to_time(f(t) ** 2) ** 2, up_to_time(f(t) ** 2), "constant factor",
                 id="a power of an integral"),
    pytest.param(sp.Integral(t * f(t), (t, 0, T)), sp.Integral(f(t), (t, 0, T)), "fixed time",
                 id="time itself up to a fixed time"),
    pytest.param(sp.Integral(f(t) * up_to_time(f(t)), (t, 0, T)), up_to_time(f(t)) ** 2 / 2,
                 "fixed time", id="an integral up to a fixed time of one that changes"),
    pytest.param(sp.Integral(sp.sqrt(1 + t * f(t) ** 2), (t, 0, T)),
                 sp.Integral(sp.sqrt(1 + f(t) ** 2), (t, 0, T)), "fixed time",
                 id="no polynomial under the root"),
    pytest.param(sp.Integral(sp.Abs(t - 1) * f(t), (t, 0, T)),
                 sp.Integral((t - 1) * f(t), (t, 0, T)), "fixed time", id="an absolute value"),
]  # fmt: skip


@pytest.mark.parametrize(("left", "right", "reason"), REFUSED)
def test_other_forms_are_not_compared(left: sp.Expr, right: sp.Expr, reason: str) -> None:
    with pytest.raises(UnsupportedError, match=reason):
        without_integrals(left, right)


@pytest.mark.parametrize(("left", "right", "reason"), REFUSED[:2])
def test_what_is_true_in_another_form_stays_undecided(
    left: sp.Expr, right: sp.Expr, reason: str
) -> None:
    answer = confirmed_equal(left, right)
    assert isinstance(answer, Undecided)
    assert reason in answer.reason


@pytest.mark.parametrize("value", [sp.sin(t) / L, sp.Integer(3), sp.ImmutableMatrix([1, 2]), 0.5])
def test_what_has_no_functions_stays_as_it_is(value: object) -> None:
    assert without_integrals(value, value) == (value, value)
    assert flattened(value) is value


@pytest.mark.parametrize(("left", "right"), EQUAL)
def test_a_first_look_takes_equal_for_equal(left: sp.Expr, right: sp.Expr) -> None:
    assert sp.simplify(flattened(left) - flattened(right)) == 0


@pytest.mark.parametrize(
    ("left", "right"),
    [
        pytest.param(up_to_time(f(t)), sp.Integral(f(t), (t, 0, T)), id="other limits"),
        pytest.param(up_to_time(f(t)), up_to_time(g(t)), id="another function"),
        pytest.param(sp.Integral(f(t), (t, 1, t)), up_to_time(f(t)), id="another start"),
    ],
)
def test_a_first_look_tells_others_apart(left: sp.Expr, right: sp.Expr) -> None:
    assert flattened(left) != flattened(right)


NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)


def by_quadrature(value: sp.Expr, time: float) -> float:
    """An expression with f = 1 + t^2 and g = cos t, its integrals summed up numerically."""
    if isinstance(value, sp.Integral):
        ((_, lower, upper),) = value.limits
        low, high = float(lower), time if upper == t else 2.0
        places = (high + low) / 2 + (high - low) / 2 * NODES
        terms = [by_quadrature(value.function, float(x)) for x in places]
        return float(WEIGHTS @ terms) * (high - low) / 2
    known = {f(t): 1 + time**2, g(t): math.cos(time), t: time, T: 2.0, L: 1.5}
    if value in known or not value.args:
        return float(known.get(value, value))
    parts = [sp.Float(by_quadrature(part, time), 17) for part in value.args]
    return float(value.func(*parts))


@pytest.mark.parametrize(("left", "right"), [EQUAL[0], EQUAL[4], EQUAL[5], EQUAL[6]])
def test_what_is_proved_holds_in_numbers(left: sp.Expr, right: sp.Expr) -> None:
    assert by_quadrature(left, 0.7) == pytest.approx(by_quadrature(right, 0.7), rel=1e-9)


def at_witness(side: sp.Expr, point: dict[str, str]) -> float:
    """Evaluate by mpmath with the functions and numbers of a witness (powers are written `^`)."""
    shape = sp.Poly([*map(sp.Rational, SHAPES[point["f(t)"]])], t).as_expr()
    side = side.replace(f, lambda place: shape.subs(t, place))
    numbers = {symbol: sp.Rational(point[symbol.name]) for symbol in side.free_symbols}
    return float(side.subs(numbers).evalf())


SHAPES = {"t/2 + 1": ("1/2", "1"), "t^2/3 + t/2 + 1": ("1/3", "1/2", "1")}


@pytest.mark.parametrize(("left", "right", "reason"), REFUSED[2:])
def test_a_false_comparison_of_another_form_has_a_witness(
    left: sp.Expr, right: sp.Expr, reason: str
) -> None:
    answer = confirmed_equal(left, right)
    assert isinstance(answer, Refuted)
    assert answer.engines == ("flint",)
    sides = [at_witness(side, dict(answer.witness.point)) for side in (left, right)]
    shown = [float(answer.witness.printed), float(answer.witness.derived)]
    assert sides == pytest.approx(shown, rel=1e-3)
    assert sides[0] != pytest.approx(sides[1], rel=1e-6)


def test_a_sum_that_only_lines_pass_is_refuted_by_a_parabola() -> None:
    """The trapezoidal rule is exact for linear functions, and for no parabola."""
    rule = T * (f(0) + f(T)) / 2
    answer = counterexample(sp.Integral(f(t), (t, 0, T)), rule, REALS)
    assert answer is not None
    assert answer.witness.point["f(t)"] == "t^2/3 + t/2 + 1"


def test_a_witness_lies_in_the_domain() -> None:
    narrow = Domain({"T": (sp.Rational(1, 10), sp.Rational(1, 9))})
    answer = counterexample(sp.Integral(t * f(t), (t, 0, T)), f(T), narrow)
    assert answer is not None
    assert 1 / 10 < sp.Rational(answer.witness.point["T"]) < 1 / 9


positive = sp.Function("p", positive=True)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        pytest.param(T, T + 1, id="without unknown functions"),
        pytest.param(positive(t), sp.Abs(f(t)), id="a function with a sign"),
        pytest.param(f(t, s), f(s, t), id="a function of two variables"),
        pytest.param(sp.Integral(sp.gamma(f(t)), (t, 0, T)), f(T), id="a function not enclosed"),
        pytest.param(up_to_time(sp.sin(up_to_time(sp.sin(f(t))))), f(t), id="one inside another"),
        pytest.param(sp.sqrt(-1 - f(t) ** 2), f(t), id="a side that is not real"),
        pytest.param(sp.Integral(1 / (t - T / 2), (t, 0, T)), f(t), id="an integral over a pole"),
    ],
)
def test_no_counterexample(left: sp.Expr, right: sp.Expr) -> None:
    assert counterexample(left, right, REALS) is None
