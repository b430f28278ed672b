"""The corrected formulas give what NumPy gives from the definitions, without SymPy."""

from __future__ import annotations

import inspect
import typing
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose

from omniproof.corrected import (
    FUNCTIONS,
    ballbot,
    omni_arrangement,
    omni_trajectory,
    two_roller_sphere,
)
from omniproof.corrected.formula import Array, Formula

ALPHA = (0.3, 2.1, 4.0)
PHI, L = 0.7, 0.108
EQUILATERAL = np.radians([30.0, 150.0, 270.0])
SPEEDS = (0.11, -0.05, 0.31)


def wheel_matrix(angles: Any, lever: float = 1.0) -> Array:
    """Speeds of omni wheels on a circle by (V_x, V_y, yaw rate): n_k . (V + w x q_k)."""
    angles = np.asarray(angles)
    return np.column_stack([-np.sin(angles), np.cos(angles), np.full(3, lever)])


def wheels_inside_ball(v_x: float, v_y: float, omega: float) -> Array:
    """Speeds of three wheels that stand inside a ball rolling on the ground, from the velocities.

    The ball's centre moves with the platform; its point on the ground is at rest, so it spins with
    (v_y, -v_x, 0) / (its radius) negated. A wheel grips along the tangent of its circle.
    """
    centre = np.array([v_x, v_y, 0.0])
    spin = np.cross(np.array([0, 0, 1.0]), centre) / L
    found = []
    for azimuth in np.radians([180.0, -60.0, 60.0]):
        outward = np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
        contact = L * (np.sin(PHI) * outward + np.array([0, 0, -np.cos(PHI)]))
        tangent = np.cross(np.array([0, 0, 1.0]), outward)
        platform = np.cross(np.array([0, 0, omega]), contact)
        ball = np.cross(spin, contact)
        found.append(float(tangent @ (platform - ball)))
    return np.array(found)


def test_wheels_of_the_ballbot() -> None:
    v_x, v_y, omega = 0.4, -0.3, 0.9
    expected = wheels_inside_ball(v_x, v_y, omega)
    found = ballbot.wheel_matrix(PHI, L) @ np.array([v_x, v_y, omega])
    assert_allclose(found, expected)
    assert_allclose(ballbot.body_matrix(PHI, L) @ expected, [v_x, v_y, omega])
    one_by_one = [
        ballbot.wheel_1_speed(v_y, omega, PHI, L),
        ballbot.wheel_2_speed(v_x, v_y, omega, PHI, L),
        ballbot.wheel_3_speed(v_x, v_y, omega, PHI, L),
    ]
    assert_allclose(one_by_one, expected)


@pytest.mark.parametrize("frame", [ballbot.body_from_wheel_1, ballbot.body_from_wheel_2])
def test_frames_of_wheels_are_rigid_and_on_the_ball(frame: Callable[..., Array]) -> None:
    found = frame(PHI, L)
    assert_allclose(found[:3, :3] @ found[:3, :3].T, np.eye(3), atol=1e-12)
    assert_allclose(np.linalg.det(found[:3, :3]), 1)
    assert_allclose(np.linalg.norm(found[:3, 3]), L)
    assert_allclose(found[3], [0, 0, 0, 1])


def test_inverse_and_volume_of_an_arrangement() -> None:
    matrix = wheel_matrix(ALPHA)
    determinant = np.linalg.det(matrix)
    assert_allclose(
        omni_arrangement.inverse_times_determinant(*ALPHA), np.linalg.inv(matrix) * determinant
    )
    assert_allclose(omni_arrangement.image_volume(*ALPHA), 8 / abs(determinant))
    assert_allclose(omni_arrangement.image_volume(*ALPHA[::-1]), 8 / abs(determinant))


def test_determinant_of_the_matrix_with_a_column_of_ones() -> None:
    assert_allclose(omni_arrangement.determinant(*ALPHA), np.linalg.det(wheel_matrix(ALPHA)))


def test_cofactors_with_the_lever_in_the_third_column() -> None:
    matrix = wheel_matrix(ALPHA, L)
    cofactors = np.linalg.inv(matrix).T * np.linalg.det(matrix)
    assert_allclose(omni_arrangement.cofactor_22(ALPHA[0], ALPHA[2], L), cofactors[1, 1])
    # What the paper calls (1, 3) is where the inverse has it: the cofactor of (3, 1).
    assert_allclose(omni_arrangement.cofactor_13(*ALPHA[:2], L), cofactors[2, 0])


@pytest.mark.parametrize("theta", [0.3, -0.4, 2.5])
def test_volume_of_the_isosceles_family(theta: float) -> None:
    wheels = [theta, np.pi - theta, 1.5 * np.pi]
    expected = 8 / abs(np.linalg.det(wheel_matrix(wheels)))
    assert_allclose(omni_arrangement.image_volume_isosceles(theta), expected)


def test_height_and_volume_are_lengths_and_volumes_of_left_handed_edges_too() -> None:
    edges = np.array([[2.0, 1.0, 5.0], [0.0, 3.0, 6.0], [0.0, 0.0, -7.0]])
    assert_allclose(omni_arrangement.height(edges), 7)
    assert_allclose(omni_arrangement.volume(edges), 42)


def test_path_of_constant_speeds_is_the_circle() -> None:
    time = np.linspace(0, 5, 20001)
    samples = [np.full_like(time, speed) for speed in SPEEDS]
    x, y = omni_trajectory.path_x(time, *samples, L), omni_trajectory.path_y(time, *samples, L)
    v_x, v_y, rate = np.linalg.solve(wheel_matrix(EQUILATERAL, L), SPEEDS)
    turned = rate * time
    assert_allclose(x, (v_x * np.sin(turned) + v_y * (np.cos(turned) - 1)) / rate, atol=1e-7)
    assert_allclose(y, (v_y * np.sin(turned) + v_x * (1 - np.cos(turned))) / rate, atol=1e-7)
    centre = omni_trajectory.centre_factor(*SPEEDS, L) * omni_trajectory.centre_vector(*SPEEDS)
    assert_allclose(centre, [-v_y / rate, v_x / rate])
    assert_allclose(omni_trajectory.circle_radius(*SPEEDS, L), np.hypot(v_x, v_y) / abs(rate))
    assert_allclose(omni_trajectory.initial_direction(*SPEEDS), np.arctan2(v_y, v_x))


def test_path_of_changing_speeds() -> None:
    """Wheels in step turn the platform on the spot; opposite sweeps move it along y."""
    time = np.linspace(0, 1, 4001)
    rising = np.sqrt(3) * time / 2
    still = np.zeros_like(time)
    y = omni_trajectory.path_y(time, rising, -rising, still, L)
    assert_allclose(y, time**2 / 2, atol=1e-7)
    assert_allclose(omni_trajectory.path_x(time, rising, -rising, still, L), still, atol=1e-12)


@pytest.mark.parametrize(("v_x", "v_y"), [(1.0, 0.2), (-1.0, 0.2), (-0.3, -2.0)])
def test_direction_knows_its_quadrant(v_x: float, v_y: float) -> None:
    c, s = np.cos(PHI), np.sin(PHI)
    expected = np.arctan2(s * v_x + c * v_y, c * v_x - s * v_y)
    assert_allclose(omni_trajectory.direction(v_x, v_y, PHI), expected)


def test_roller_turns_a_sphere_the_other_way() -> None:
    """Contact x, roller axis z: the driven direction is x x z = -y, so the spin is -nu/r."""
    nu, r = 0.3, 0.2
    spin = np.array([0, 0, float(two_roller_sphere.spin_about_roller_axis(nu, r))])
    assert_allclose(np.cross(spin, [r, 0, 0]) @ np.array([0, -1, 0]), nu)


def test_slip_is_the_sphere_over_the_roller() -> None:
    """Contact x, tangent y, normal z; the roller drives along x cross its axis."""
    spin, nu, alpha, r = np.array([0.5, -0.7, 0.4]), 0.3, 0.6, 0.2
    contact, axis = np.array([r, 0, 0]), np.array([0, np.cos(alpha), np.sin(alpha)])
    slip = np.cross(spin, contact) - nu * np.cross(contact / r, axis)
    assert_allclose(two_roller_sphere.slip_along_normal(spin[1], nu, alpha, r), slip[2])


def test_sum_of_squares() -> None:
    assert_allclose(two_roller_sphere.sum_of_squares(3, 4), 25)


def test_displacement_of_a_wheel_is_seen_from_its_frame() -> None:
    """Small displacement of the wheel's centre, platform and turn, along the axes of its frame."""
    d_x, d_y, turn = 0.003, -0.002, 0.004
    frame = ballbot.body_from_wheel_1(PHI, L)
    moved = np.array([d_x, d_y, 0]) + np.cross([0, 0, turn], frame[:3, 3])
    expected = frame[:3, :3].T @ moved
    assert_allclose(ballbot.wheel_1_displacement(d_x, d_y, turn, PHI, L), expected)


def test_arrays_are_broadcast_and_entries_come_last() -> None:
    phi = np.array([0.2, 0.7])
    many = ballbot.wheel_matrix(phi, L)
    assert many.shape == (2, 3, 3)
    assert_allclose(many[1], ballbot.wheel_matrix(0.7, L))


@pytest.mark.parametrize(
    ("values", "message"),
    [
        pytest.param({"phi": 1.0}, r"eq:10: expected \['L', 'phi'\], found \['phi'\]", id="few"),
        pytest.param({"phi": 1.0, "L": 1.0, "x": 1.0}, "found", id="many"),
    ],
)
def test_symbols_and_values_have_to_fit(values: dict[str, float], message: str) -> None:
    with pytest.raises(TypeError, match=message):
        Formula("ballbot", "eq:10")(**values)


@pytest.mark.parametrize("claim", ["eq:99", "sec:3/motion-by-frames"])
def test_a_claim_without_expression_is_refused(claim: str) -> None:
    with pytest.raises(LookupError, match=claim):
        _ = Formula("ballbot", claim).expression


EVERY = [
    pytest.param(function, id=f"{paper} {claim}")
    for paper, functions in FUNCTIONS.items()
    for claim, function in functions.items()
]


@pytest.mark.parametrize("function", EVERY)
def test_functions_have_types_and_name_their_equation(function: Callable[..., Array]) -> None:
    hints = typing.get_type_hints(function)
    assert set(hints) == {*inspect.signature(function).parameters, "return"}
    assert any(word in str(function.__doc__) for word in ("Eq. (", "Section", "Appendix"))
