"""Integrals of unknown functions: equal for all functions, different for some, or not compared."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy as sp

from omniproof.audit.answer import Proved, Refuted, Undecided
from omniproof.audit.confirm import confirmed_equal
from omniproof.audit.integrals import flattened, without_integrals

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
]  # fmt: skip


@pytest.mark.parametrize(("left", "right", "reason"), REFUSED)
def test_not_compared(left: sp.Expr, right: sp.Expr, reason: str) -> None:
    answer = confirmed_equal(left, right)
    assert isinstance(answer, Undecided)
    assert reason in answer.reason


@pytest.mark.parametrize("value", [sp.sin(t) / L, sp.Integer(3), sp.ImmutableMatrix([1, 2]), 0.5])
def test_what_has_no_functions_stays_as_it_is(value: object) -> None:
    assert without_integrals(value, value) == (value, value)
    assert flattened(value) is value


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
