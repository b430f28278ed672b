"""Motion in plain floats, for comparison: Runge and Kutta, with no line in common with the code."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from sympy import MatrixBase, Symbol, lambdify

Twist = Callable[[float], Any]


def driven(twist: Twist, end: float, steps: int = 1000) -> Any:
    """Pose (X, Y, phi) at `end` by the classical Runge-Kutta method: an array of three."""

    def slope(time: float, pose: Any) -> Any:
        v_x, v_y, rate = twist(time)
        c, s = math.cos(pose[2]), math.sin(pose[2])
        return np.array([c * v_x - s * v_y, s * v_x + c * v_y, rate])

    pose, h = np.zeros(3), end / steps
    for k in range(steps):
        time = k * h
        first = slope(time, pose)
        second = slope(time + h / 2, pose + h / 2 * first)
        third = slope(time + h / 2, pose + h / 2 * second)
        fourth = slope(time + h, pose + h * third)
        pose = pose + h / 6 * (first + 2 * second + 2 * third + fourth)
    return pose


def numeric(twist: MatrixBase, time: Symbol) -> Twist:
    """Turn an exact twist into a function of plain floats."""
    return lambdify(time, list(twist), "math")  # type: ignore[no-any-return]


def floats(matrix: MatrixBase) -> Any:
    """Return an exact matrix as a flat array of doubles."""
    return np.array(matrix.evalf(30).tolist(), dtype=float).ravel()
