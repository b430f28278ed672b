"""The ballbot's law against numeric rigid bodies that share no code with it, and cases by hand.

The oracle knows no velocity formula: it moves ball and platform for a short time, finds where two
material points that touch have gone, and takes differences.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from in_floats import floats
from sympy import Matrix, Rational, cos, diag, eye, pi, simplify, sin, sqrt, symbols, zeros

from omniproof.kinematics import ballbot, frames, omni, rolling

QUICK = settings(deadline=None, max_examples=15)
L, RHO = symbols("L rho", positive=True)
PHI, BETA = symbols("phi beta", real=True)
SMALL = st.fractions(min_value=-2, max_value=2, max_denominator=8).map(Rational)
ANGLE = st.fractions(min_value=Rational(1, 8), max_value=3, max_denominator=8).map(Rational)
LENGTH = st.fractions(min_value=Rational(1, 2), max_value=2, max_denominator=8).map(Rational)
STEP = 1e-5


def turned(axis: Any, angle: float, point: Any) -> Any:
    """Rodrigues' formula in floats."""
    if angle == 0:
        return point
    across = np.cross(axis, point)
    along = axis * (axis @ point)
    return along + math.cos(angle) * (point - along) + math.sin(angle) * across


def ball_point(point: Any, velocity: Any, spin: float, radius: float, time: float) -> Any:
    """Where a material point of the rolling ball is after a short time.

    The ball turns about its lowest point, which rests: a turn about the level axis across the
    travel by distance / radius carries the centre by that distance; the spin is a turn about the
    vertical through the centre.
    """
    distance = np.linalg.norm(velocity) * time
    across = np.array([-velocity[1], velocity[0], 0.0])
    size = np.linalg.norm(across)
    rolled = turned(across / size, distance / radius, point) if size else point
    spun = turned(np.array([0.0, 0.0, 1.0]), spin * time, rolled)
    return spun + np.array([*velocity, 0.0]) * time


def platform_point(point: Any, velocity: Any, yaw_rate: float, time: float) -> Any:
    turned_point = turned(np.array([0.0, 0.0, 1.0]), yaw_rate * time, point)
    return turned_point + np.array([*velocity, 0.0]) * time


def speed_by_differences(contact: Any, driven: Any, motion: Any, radius: float) -> float:
    """Rate at which the platform's point at a contact leaves the ball's point there."""
    *velocity, yaw_rate, spin = motion
    gap = [
        platform_point(contact, velocity, yaw_rate, t)
        - ball_point(contact, velocity, spin, radius, t)
        for t in (STEP, -STEP)
    ]
    return float(driven @ (gap[0] - gap[1]) / (2 * STEP))


def contact_by_hand(azimuth: float, angle: float, radius: float) -> tuple[Any, Any]:
    """Contact at an angle from the lowest point, and the counter-clockwise tangent."""
    level = np.array([math.cos(azimuth), math.sin(azimuth), 0])
    place = radius * (math.sin(angle) * level - math.cos(angle) * np.array([0, 0, 1]))
    return place, np.array([-level[1], level[0], 0])


@QUICK
@given(
    azimuths=st.lists(SMALL, min_size=1, max_size=3),
    angle=ANGLE,
    wall=LENGTH,
    radius=LENGTH,
    motion=st.tuples(SMALL, SMALL, SMALL, SMALL),
)
def test_law_is_what_two_touching_points_do(
    azimuths: Any, angle: Any, wall: Any, radius: Any, motion: Any
) -> None:
    outer = radius + wall
    law = ballbot.wheel_law(angle, radius, outer, azimuths=azimuths)
    found = floats(law * Matrix(motion)).ravel()
    numbers = [float(part) for part in motion]
    for azimuth, speed in zip(azimuths, found, strict=True):
        contact, driven = contact_by_hand(float(azimuth), float(angle), float(radius))
        expected = speed_by_differences(contact, driven, numbers, float(outer))
        assert speed == pytest.approx(expected, abs=1e-7)


def test_the_oracle_rolls_without_slip() -> None:
    """Its lowest point stays, and its highest moves twice as fast as the centre."""
    velocity, radius = np.array([0.3, -0.4]), 1.5
    for height, factor in ((-radius, 0), (radius, 2)):
        ends = [
            ball_point(np.array([0, 0, height]), velocity, 0.7, radius, t) for t in (STEP, -STEP)
        ]
        rate = (ends[0] - ends[1]) / (2 * STEP)
        np.testing.assert_allclose(rate, [*(factor * velocity), 0], atol=1e-6)


V = symbols("v", real=True)
BY_HAND = [
    pytest.param(0, [V, 0, 0, 0], [0, sqrt(3) * V / 2, -sqrt(3) * V / 2], id="at the bottom"),
    pytest.param(pi / 2, [V, 0, 0, 0], [0, 0, 0], id="at the equator the wheels feel no travel"),
    pytest.param(pi, [0, V, 0, 0], [V, -V / 2, -V / 2], id="at the top all is reversed"),
    pytest.param(0, [0, 0, V, 0], [0, 0, 0], id="at the bottom they feel no yaw"),
    pytest.param(pi / 2, [0, 0, V, 0], [V, V, V], id="platform turns"),
    pytest.param(pi / 2, [0, 0, 0, V], [-V, -V, -V], id="ball turns"),
    pytest.param(pi / 6, [0, 0, V, V], [0, 0, 0], id="both turn together"),
    pytest.param(pi / 3, [0, V, 0, 0], [-V / 2, V / 4, V / 4], id="half the speed at 60 degrees"),
]


@pytest.mark.parametrize(("angle", "motion", "speeds"), BY_HAND)
def test_thin_unit_ball_by_hand(angle: Any, motion: Any, speeds: Any) -> None:
    assert ballbot.wheel_law(angle, 1, 1) * Matrix(motion) == Matrix(speeds)


def test_rows_of_the_docstring() -> None:
    scale, lever = L / RHO * cos(PHI), L * sin(PHI)
    row = [-scale * sin(BETA), scale * cos(BETA), lever, -lever]
    assert ballbot.wheel_law(PHI, L, RHO, azimuths=[BETA]) == Matrix([row])


def test_ball_twist_by_hand() -> None:
    """Travel along x turns the ball about y."""
    v_x, v_y, spin = symbols("v_x v_y s", real=True)
    ball = ballbot.ball_twist(v_x, v_y, spin, RHO)
    assert ball.rotation == Matrix([-v_y / RHO, v_x / RHO, spin])
    assert ball.velocity == Matrix([v_x, v_y, 0])


AT_REST = [[0, -1], [sqrt(3) / 2, Rational(1, 2)], [-sqrt(3) / 2, Rational(1, 2)]]


def test_over_a_surface_at_rest_the_zenith_angle_moves_the_yaw_column_only() -> None:
    law = ballbot.law_over_surface_at_rest(PHI, L)
    assert law[:, :2] == Matrix(AT_REST)
    assert list(law[:, 2]) == [L * sin(PHI)] * 3


@pytest.mark.parametrize("azimuth", ballbot.AZIMUTHS, ids=["C_1", "C_2", "C_3"])
def test_contact_frames_stand_as_the_text_says(azimuth: Any) -> None:
    """z to the centre, y level and counter-clockwise: derived from the place alone."""
    frame = ballbot.contact_frame(azimuth, PHI, L)
    assert frames.is_rigid(frame)
    outward = Matrix([sin(PHI) * cos(azimuth), sin(PHI) * sin(azimuth), -cos(PHI)])
    assert frames.origin(frame) == L * outward
    assert frames.axes(frame)[:, 2] == -outward
    assert frames.axes(frame)[:, 1] == Matrix([-sin(azimuth), cos(azimuth), 0])


@QUICK
@given(angle=ANGLE, radius=LENGTH, wall=LENGTH)
def test_relative_law_is_inverted_by_thirds(angle: Any, radius: Any, wall: Any) -> None:
    law = ballbot.relative_law(angle, radius, radius + wall)
    product = floats(omni.twist_matrix(law)) @ floats(law)
    np.testing.assert_allclose(product, np.eye(3), atol=1e-8)


def test_relative_law_leaves_out_the_ball_s_spin() -> None:
    law = ballbot.wheel_law(PHI, L, RHO)
    assert ballbot.relative_law(PHI, L, RHO) == law[:, :3]
    assert law[:, 2] == -law[:, 3]


@pytest.mark.parametrize(
    ("angle", "singular"),
    [
        pytest.param(0, True, id="at the bottom"),
        pytest.param(pi / 2, True, id="at the equator"),
        pytest.param(pi, True, id="at the top"),
        pytest.param(pi / 4, False, id="between"),
    ],
)
def test_singular_angles(angle: Any, singular: bool) -> None:
    assert (ballbot.relative_law(angle, L, RHO).det() == 0) is singular


def test_no_wheels_are_refused() -> None:
    with pytest.raises(ValueError, match="expected at least 1 wheel, got 0"):
        ballbot.wheel_law(PHI, L, RHO, azimuths=[])


def test_four_wheels_are_four_rows() -> None:
    azimuths = [k * pi / 2 for k in range(4)]
    law = ballbot.relative_law(PHI, L, RHO, azimuths=azimuths)
    assert law.shape == (4, 3)
    scale, lever = L / RHO * cos(PHI), L * sin(PHI)
    expected = diag(2 * scale**2, 2 * scale**2, 4 * lever**2)
    assert (law.T * law - expected).applyfunc(simplify) == zeros(3, 3)


def doubled_velocity(n: Any, q: Any, body: Any, surface: Any = rolling.REST) -> Any:
    """A broken constraint: the velocities of the origins count twice."""
    turn = (body.rotation - surface.rotation).cross(q)
    return n.dot(2 * (body.velocity - surface.velocity) + turn)


def test_everything_rests_on_the_rolling_constraint(monkeypatch: pytest.MonkeyPatch) -> None:
    before = ballbot.relative_law(PHI, L, RHO), ballbot.law_over_surface_at_rest(PHI, L)
    planar = omni.wheel_matrix([0, 1, 2], L)
    monkeypatch.setattr(rolling, "rolling_speed", doubled_velocity)
    assert ballbot.relative_law(PHI, L, RHO) == before[0] * diag(2, 2, 1)
    assert ballbot.law_over_surface_at_rest(PHI, L) == before[1] * diag(2, 2, 1)
    assert omni.wheel_matrix([0, 1, 2], L) == planar * diag(2, 2, 1)


def test_a_body_at_rest_on_the_ground_does_not_roll() -> None:
    still = rolling.Twist(zeros(3, 1), zeros(3, 1))
    place = Matrix(symbols("q:3"))
    assert rolling.rolling_speed(eye(3)[:, 0], place, still) == 0
    assert rolling.REST.at(place) == zeros(3, 1)
