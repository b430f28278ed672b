"""Paths against numeric mechanics: NumPy inverts the matrix, Runge and Kutta move the body."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from motion import driven, floats, numeric
from sympy import (
    Function,
    ImmutableMatrix,
    Integral,
    Rational,
    cos,
    exp,
    expand,
    eye,
    oo,
    pi,
    sin,
    sqrt,
    symbols,
)

from omniproof.kinematics import trajectory

T = symbols("t", positive=True)
QUICK = settings(deadline=None, max_examples=20)
NUMBER = st.fractions(min_value=-3, max_value=3, max_denominator=8).map(Rational)
TURNING = NUMBER.filter(lambda rate: abs(rate) >= Rational(1, 8))
TRIANGLE = [pi / 6, 5 * pi / 6, 3 * pi / 2]
SECONDS = 3


def twist_of(*entries: Any) -> ImmutableMatrix:
    return ImmutableMatrix(entries)


# From wheels to the twist


@QUICK
@given(st.tuples(NUMBER, NUMBER, NUMBER))
def test_twist_is_the_numeric_inverse(speeds: Any) -> None:
    rows = [[-math.sin(a), math.cos(a), 0.5] for a in map(float, TRIANGLE)]
    expected = np.linalg.inv(rows) @ [float(speed) for speed in speeds]
    found = floats(trajectory.body_twist(TRIANGLE, Rational(1, 2), speeds))
    np.testing.assert_allclose(found, expected, atol=1e-12)


BY_HAND = [
    pytest.param((1, 1, 1), (0, 0, 2), id="equal speeds: on the spot, v/L"),
    pytest.param((-1, -1, 2), (2, 0, 0), id="the third wheel forwards: along x"),
    pytest.param((1, -1, 0), (0, 2 / sqrt(3), 0), id="two wheels against each other: along y"),
]


@pytest.mark.parametrize(("speeds", "expected"), BY_HAND)
def test_twist_by_hand(speeds: Any, expected: Any) -> None:
    found = trajectory.body_twist(TRIANGLE, Rational(1, 2), speeds)
    assert (found - twist_of(*expected)).applyfunc(expand).is_zero_matrix


# Frames


def test_velocity_seen_from_the_world_by_hand() -> None:
    assert trajectory.world_velocity(twist_of(1, 2, 3), pi / 2) == twist_of(-2, 1, 3)


@QUICK
@given(st.tuples(NUMBER, NUMBER, NUMBER), NUMBER)
def test_the_world_keeps_speed_and_yaw_rate(entries: Any, angle: Any) -> None:
    twist = twist_of(*entries)
    moved = trajectory.world_velocity(twist, angle)
    assert moved[2] == twist[2]
    assert floats(moved[:2, :].T * moved[:2, :]) == pytest.approx(
        floats(twist[:2, :].T * twist[:2, :])
    )


def test_heading_of_unknown_speeds_stays_an_integral() -> None:
    rate = Function("w")(T)
    heading = trajectory.heading(rate, T)
    assert isinstance(heading, Integral)
    assert heading.diff(T) == rate
    assert heading.subs(T, 0).doit() == 0


# Closed forms

A = twist_of(Rational(3, 10), Rational(-1, 5), Rational(4, 5))
B = twist_of(Rational(1, 4), Rational(2, 5), 0)
C = twist_of(Rational(-1, 3), Rational(1, 6), 0)
D = twist_of(Rational(1, 5), Rational(-1, 4), Rational(-3, 5))
RATE = Rational(4, 5)
PATHS = [
    pytest.param(A, trajectory.constant_speed_path(A, T), id="constant, counter-clockwise"),
    pytest.param(D, trajectory.constant_speed_path(D, T), id="constant, clockwise"),
    pytest.param(B, trajectory.constant_speed_path(B, T), id="constant, straight"),
    pytest.param(A * exp(-T / 2), trajectory.common_profile_path(A, exp(-T / 2), T),
                 id="all speeds decay alike"),
    pytest.param(A * cos(T), trajectory.common_profile_path(A, cos(T), T), id="to and fro"),
    pytest.param(A + B * exp(-T / 3), trajectory.exponential_path(A, B, Rational(-1, 3), T),
                 id="exponential, constant sum"),
    pytest.param(B + C * exp(-T / 3), trajectory.exponential_path(B, C, Rational(-1, 3), T),
                 id="exponential, no rotation"),
    pytest.param(A + B * cos(2 * T) + C * sin(2 * T), trajectory.sinusoidal_path(A, B, C, 2, T),
                 id="sinusoidal, constant sum"),
    pytest.param(A + B * cos(RATE * T) + C * sin(RATE * T),
                 trajectory.sinusoidal_path(A, B, C, RATE, T), id="in step with the rotation"),
    pytest.param(A + B * cos(RATE * T) - C * sin(RATE * T),
                 trajectory.sinusoidal_path(A, B, C, -RATE, T), id="against the rotation"),
    pytest.param(A + D * T, trajectory.linear_path(A, D, T), id="linear, turning round"),
    pytest.param(B + A * T, trajectory.linear_path(B, A, T), id="linear, from a translation"),
]  # fmt: skip


@pytest.mark.parametrize(("twist", "path"), PATHS)
def test_closed_forms_end_where_runge_and_kutta_do(twist: Any, path: Any) -> None:
    x, y, _ = driven(numeric(twist, T), SECONDS)
    assert floats(path.subs(T, SECONDS)) == pytest.approx([x, y], abs=1e-9)


@QUICK
@given(NUMBER, NUMBER, TURNING)
def test_a_constant_twist_stays_on_its_circle(v_x: Any, v_y: Any, rate: Any) -> None:
    twist = twist_of(v_x, v_y, rate)
    centre = floats(trajectory.circle_centre(twist))
    radius = float(trajectory.circle_radius(twist))
    for time in (0, 1, Rational(7, 3)):
        place = floats(trajectory.constant_speed_path(twist, time))
        assert np.linalg.norm(place - centre) == pytest.approx(radius, abs=1e-12)


CIRCLES = [
    pytest.param((1, 0, 2), (0, 0.5), 0.5, 1, id="forwards and left: centre on the left"),
    pytest.param((1, 0, -2), (0, -0.5), 0.5, -1, id="forwards and right: centre on the right"),
    pytest.param((0, 3, 1), (-3, 0), 3.0, 1, id="sideways and left: centre behind"),
    pytest.param((0, 0, 5), (0, 0), 0.0, 1, id="on the spot"),
]


@pytest.mark.parametrize(("entries", "centre", "radius", "sense"), CIRCLES)
def test_circles_by_hand(entries: Any, centre: Any, radius: float, sense: int) -> None:
    twist = twist_of(*entries)
    assert floats(trajectory.circle_centre(twist)) == pytest.approx(centre)
    assert float(trajectory.circle_radius(twist)) == radius
    assert trajectory.sense(twist) == sense


QUADRANTS = [
    pytest.param((1, 1), pi / 4, id="first"),
    pytest.param((-1, 1), 3 * pi / 4, id="second, where the quotient says -45 degrees"),
    pytest.param((-1, -1), -3 * pi / 4, id="third, where the quotient says 45 degrees"),
    pytest.param((0, -1), -pi / 2, id="downwards, where the quotient is undefined"),
]


@pytest.mark.parametrize(("velocity", "angle"), QUADRANTS)
def test_direction_knows_its_quadrant(velocity: Any, angle: Any) -> None:
    twist = twist_of(*velocity, 0)
    assert trajectory.direction_angle(twist) == angle
    assert trajectory.direction(twist) == ImmutableMatrix([cos(angle), sin(angle)])


def test_fresnel_path_of_a_growing_spin_winds_up_at_a_finite_place() -> None:
    """Forwards at 1 m/s with the yaw rate t: Euler's spiral, which ends at sqrt(pi)/2 (1, 1)."""
    x, y = trajectory.linear_path(twist_of(1, 0, 0), twist_of(0, 0, 1), T)
    assert x.limit(T, oo) == sqrt(pi) / 2
    assert y.limit(T, oo) == sqrt(pi) / 2


@QUICK
@given(NUMBER, NUMBER, NUMBER)
def test_turning_integral_solves_its_differential_equation(k: Any, n: Any, time: Any) -> None:
    """G' = k G + n J G + 1, which with G(0) = 0 has one solution."""
    assume((k, n) != (0, 0))
    found = trajectory.turning_integral(n, T, k)
    left = found.diff(T)
    right = (k * eye(2) + n * trajectory.QUARTER_TURN) * found + eye(2)
    assert floats((left - right).subs(T, abs(time) + 1)) == pytest.approx(np.zeros(4), abs=1e-9)
    assert floats(found.subs(T, 0)) == pytest.approx(np.zeros(4))


REFUSED = [
    pytest.param(lambda: trajectory.circle_radius(B), "a translation: its path is a line",
                 id="radius of a line"),
    pytest.param(lambda: trajectory.circle_centre(B), "a translation: its path is a line",
                 id="centre of a line"),
    pytest.param(lambda: trajectory.linear_path(A, B, T), "a translation: its path is a line",
                 id="yaw rate that does not grow"),
    pytest.param(lambda: trajectory.exponential_path(A, D, 1, T), "got the yaw rate -3/5",
                 id="exponential rotation"),
    pytest.param(lambda: trajectory.sinusoidal_path(A, B, D, 1, T), "got the yaw rate -3/5",
                 id="sinusoidal rotation"),
]  # fmt: skip


@pytest.mark.parametrize(("call", "message"), REFUSED)
def test_what_has_no_such_form_is_refused(call: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()
