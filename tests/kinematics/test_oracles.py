"""Wheel speeds, twists and poses that another project states; provenance in tests/oracles."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sympy import ImmutableMatrix, Rational, pi

from omniproof.kinematics.omni import twist_matrix, wheel_matrix
from omniproof.kinematics.trajectory import constant_speed_path

VECTORS = Path(__file__).parents[1] / "oracles" / "vectors.json"
SETS: dict[str, Any] = {entry["id"]: entry for entry in json.loads(VECTORS.read_text())["sets"]}
INVERSE, ODOMETRY = SETS["ros2_omni_ik"], SETS["ros2_omni_odometry"]
EXPECTED_ARC = {
    "1.5*sin(1)+0.5*(cos(1)-1)": 1.5 * math.sin(1) + 0.5 * (math.cos(1) - 1),
    "-1.5*(cos(1)-1)+0.5*sin(1)": -1.5 * (math.cos(1) - 1) + 0.5 * math.sin(1),
}


def regular(count: int, offset: float = 0.0) -> list[Any]:
    return [2 * pi * i / count + Rational(offset) for i in range(count)]


def ros_matrix(count: int, offset: float, body_radius: float, wheel_radius: float) -> Any:
    """Our wheel matrix in the convention of ROS, as the docstring of `wheel_matrix` converts it."""
    matrix = wheel_matrix(regular(count, offset), Rational(str(body_radius)))
    return matrix * (-1 / Rational(str(wheel_radius)))


@pytest.mark.parametrize(
    "case", [pytest.param(case, id=f"{case['n']}-wheels") for case in INVERSE["cases"]]
)
def test_wheel_rates_of_ros(case: Any) -> None:
    matrix = ros_matrix(case["n"], case["offset"], INVERSE["R"], INVERSE["r"])
    rates = np.array(matrix.evalf().tolist(), dtype=float) @ case["twist"]
    np.testing.assert_allclose(rates, case["wheels"], atol=1e-4)


def test_driven_directions_turned_by_half_a_turn_give_the_sign_of_ros() -> None:
    case = INVERSE["cases"][1]
    angles = regular(case["n"])
    clockwise = [angle - pi / 2 for angle in angles]
    matrix = wheel_matrix(angles, Rational(str(INVERSE["R"])), directions=clockwise)
    rates = np.array(matrix.evalf().tolist(), dtype=float) @ case["twist"] / INVERSE["r"]
    np.testing.assert_allclose(rates, case["wheels"], atol=1e-4)


@pytest.mark.parametrize(
    "case", [pytest.param(case, id=case["test"]) for case in ODOMETRY["cases"]]
)
def test_twists_and_poses_of_ros(case: Any) -> None:
    matrix = ros_matrix(ODOMETRY["n"], 0.0, ODOMETRY["R"], ODOMETRY["r"])
    twist = twist_matrix(matrix) * ImmutableMatrix(case["wheels"])
    time = Rational(case["dt"])
    pose = [*constant_speed_path(twist, time), twist[2] * time]
    expected = [float(EXPECTED_ARC.get(value, value)) for value in case["pose"]]
    np.testing.assert_allclose([float(entry) for entry in twist], case["twist"], atol=1e-5)
    np.testing.assert_allclose([float(entry) for entry in pose], expected, atol=1e-5)
