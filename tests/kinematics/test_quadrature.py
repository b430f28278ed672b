"""Enclosed poses: they contain the closed forms, and what Runge and Kutta find for all others."""

from __future__ import annotations

from typing import Any

import pytest
from flint import ctx
from motion import driven, numeric
from sympy import Abs, ImmutableMatrix, Rational, cos, exp, gamma, sin, sqrt, symbols

from omniproof.decide.in_sympy.balls import evaluate
from omniproof.formula.errors import UnsupportedError
from omniproof.kinematics import quadrature, trajectory

T = symbols("t", positive=True)
A = ImmutableMatrix([Rational(3, 10), Rational(-1, 5), Rational(4, 5)])
B = ImmutableMatrix([Rational(1, 4), Rational(2, 5), 0])


CLOSED = [
    pytest.param(A, trajectory.constant_speed_path(A, T), id="circle"),
    pytest.param(B, trajectory.constant_speed_path(B, T), id="line"),
    pytest.param(A + B * exp(-T), trajectory.exponential_path(A, B, -1, T), id="exponential"),
    pytest.param(
        A + B * cos(5 * T), trajectory.sinusoidal_path(A, B, 0 * B, 5, T), id="sinusoidal"
    ),
]


@pytest.mark.parametrize(("twist", "path"), CLOSED)
def test_balls_overlap_those_of_the_closed_form(twist: Any, path: Any) -> None:
    pose = quadrature.pose(twist, T, Rational(7, 3))
    assert pose.error <= quadrature.TOLERANCE
    for ball, coordinate in zip((pose.x, pose.y), path, strict=True):
        assert ball.overlaps(evaluate(coordinate, {T: Rational(7, 3)}))


OTHERS = [
    pytest.param((sin(3 * T), sqrt(1 + T), exp(-(T**2))), id="heading is an error function"),
    pytest.param((1, T, 1 / (1 + T**3)), id="rational yaw rate"),
    pytest.param((cos(T**2), sin(2 * T), sin(5 * T)), id="sum of the speeds oscillates"),
    pytest.param((1, 0, Abs(T + 1)), id="an absolute value without a kink"),
]


@pytest.mark.parametrize("entries", OTHERS)
def test_paths_without_a_closed_form(entries: Any) -> None:
    twist = ImmutableMatrix(entries)
    pose = quadrature.pose(twist, T, 2)
    found = [float(ball.mid()) for ball in (pose.x, pose.y, pose.heading)]
    assert found == pytest.approx(driven(numeric(twist, T), 2.0), abs=1e-9)
    assert pose.error <= quadrature.TOLERANCE


@pytest.mark.parametrize("tolerance", [1e-3, 1e-9, 1e-25])
def test_the_error_bound_is_what_was_asked_for(tolerance: float) -> None:
    assert quadrature.pose(A, T, 3, tolerance=tolerance).error <= tolerance


def test_a_singularity_is_refused_and_settings_are_kept() -> None:
    cap = ctx.cap
    with pytest.raises(ValueError, match="no bound of 1e-12 on the error with 4096 steps"):
        quadrature.pose(ImmutableMatrix([1 / (T - 1), 0, 0]), T, 3)
    assert ctx.cap == cap


def test_an_unknown_function_is_refused() -> None:
    with pytest.raises(UnsupportedError, match="gamma"):
        quadrature.pose(ImmutableMatrix([gamma(T + 1), 0, 0]), T, 1)
