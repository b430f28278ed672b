"""Planar platform on N omni wheels: wheel matrix and its inverse, from one rolling constraint.

Mechanics enters at one place only, `rolling_speed`, the planar case of `rolling.rolling_speed`; the
wheel matrix is its Jacobian by the twist, and every other function starts from the wheel matrix.
All results are exact SymPy. Inverses are written as adjugate over determinant: a general `simplify`
of the 3x3 symbolic inverse costs seconds and hides the cofactors that the field prints.

Conventions: SI units and radians; x and y of the platform's frame, yaw counter-clockwise positive,
wheel k at the angle alpha_k from x, its driven direction the counter-clockwise tangent.
"""

from __future__ import annotations

from collections.abc import Sequence

from sympy import (
    Dummy,
    Expr,
    ImmutableMatrix,
    MatrixBase,
    Symbol,
    cos,
    diag,
    expand,
    sin,
)

from omniproof.kinematics import rolling
from omniproof.kinematics.scalars import Scalar, exact, tidy, vanishes


def rolling_speed(
    direction: MatrixBase, position: MatrixBase, velocity: MatrixBase, yaw_rate: Scalar
) -> Expr:
    """Speed of a wheel along its driven direction: the rolling constraint n . (V + w z x q).

    `direction` n (2x1, unit), `position` q of the contact (2x1, m), `velocity` V of the body's
    origin (2x1, m/s), `yaw_rate` w (rad/s). Result in m/s. The passive rollers leave the component
    across n free. Source: Siegwart, Nourbakhsh, Scaramuzza, Autonomous Mobile Robots, 3.2.3
    (Swedish wheel, gamma = 0).
    """
    n, q, v = (ImmutableMatrix([x, y, 0]) for x, y in (direction, position, velocity))
    return rolling.rolling_speed(n, q, rolling.Twist(v, ImmutableMatrix([0, 0, yaw_rate])))


def contact_position(angle: Scalar, body_radius: Scalar) -> ImmutableMatrix:
    """Contact of the wheel at `angle` (rad) on a body of `body_radius` (m): 2x1, in m."""
    return ImmutableMatrix([body_radius * cos(angle), body_radius * sin(angle)])


def tangential_direction(angle: Scalar) -> ImmutableMatrix:
    """Counter-clockwise unit tangent at `angle` (rad): 2x1, dimensionless."""
    return ImmutableMatrix([-sin(angle), cos(angle)])


def wheel_matrix(
    angles: Sequence[Scalar], body_radius: Scalar, *, directions: Sequence[Scalar] | None = None
) -> ImmutableMatrix:
    """Matrix from the twist (V_x, V_y, yaw rate) to the N wheel speeds (m/s): N x 3, exact.

    `angles` of the contacts (rad, numbers or symbols); `body_radius` L (m); `directions`: angles of
    the driven directions (rad), by default tangential. With tangential wheels the rows are
    (-sin alpha_k, cos alpha_k, L).

    Conversions: on (V_x, V_y, L * yaw rate), as Kimura, Shigyo, Ishii (2023), Eq. (5) has it,
    divide the third column by L (`velocity_matrix`). ROS (ros2_controllers, omni wheel drive)
    counts a wheel that drives clockwise as positive and gives its rate in rad/s: multiply by
    -1 / wheel radius; the sign alone is `directions = alpha_k - pi/2`.

    Raises `ValueError` for fewer than two wheels and for a wrong number of directions.
    """
    if len(angles) < 2:
        raise ValueError(f"expected at least 2 wheels, got {len(angles)}")
    if directions is not None and len(directions) != len(angles):
        raise ValueError(f"expected {len(angles)} directions, one a wheel, got {len(directions)}")
    driven = (
        [tangential_direction(exact(angle)) for angle in angles]
        if directions is None
        else [_unit_vector(exact(direction)) for direction in directions]
    )
    contacts = [contact_position(exact(angle), exact(body_radius)) for angle in angles]
    return ImmutableMatrix([_row(n, q) for n, q in zip(driven, contacts, strict=True)])


def velocity_matrix(
    angles: Sequence[Scalar], *, directions: Sequence[Scalar] | None = None
) -> ImmutableMatrix:
    """`wheel_matrix` on (V_x, V_y, L * yaw rate): N x 3, dimensionless, all inputs in m/s.

    Source: Kimura, Shigyo, Ishii (2023), Eq. (5). Errors as in `wheel_matrix`.
    """
    body_radius = Symbol("L", positive=True)
    scale = diag(1, 1, 1 / body_radius)
    return ImmutableMatrix(wheel_matrix(angles, body_radius, directions=directions) * scale)


def twist_matrix(matrix: MatrixBase) -> ImmutableMatrix:
    """Matrix from N wheel speeds to the twist: 3 x N, exact.

    The inverse of a 3 x 3 `matrix`; for N > 3 the least-squares inverse (A^T A)^-1 A^T, which
    averages slip over the wheels. Raises `ValueError` for N < 3, and for a singular matrix (the
    driven lines meet in one point or are parallel, so that some motion turns no wheel).
    """
    wheels, columns = matrix.shape
    if columns != 3 or wheels < 3:
        raise ValueError(f"expected a matrix N x 3 with N >= 3, got {wheels} x {columns}")
    square = matrix if wheels == 3 else (matrix.T * matrix).applyfunc(expand)
    determinant = square.det(method="berkowitz")
    if vanishes(determinant):
        raise ValueError("the wheel matrix is singular: some motion turns no wheel")
    inverse = square.adjugate(method="berkowitz") / determinant
    return ImmutableMatrix(inverse if wheels == 3 else inverse * matrix.T)


def singular(angles: Sequence[Scalar]) -> Expr:
    """Determinant of `velocity_matrix` of three wheels; the arrangement is singular where it is 0.

    Raises `ValueError` unless there are three angles (rad).
    """
    if len(angles) != 3:
        raise ValueError(f"expected 3 wheels, got {len(angles)}")
    return velocity_matrix(angles).det(method="berkowitz")


def _row(direction: MatrixBase, position: MatrixBase) -> list[Expr]:
    """Gradient of the rolling speed by the twist."""
    twist = v_x, v_y, yaw_rate = Dummy("V_x"), Dummy("V_y"), Dummy("w")
    speed = rolling_speed(direction, position, ImmutableMatrix([v_x, v_y]), yaw_rate)
    return [tidy(speed.diff(component)) for component in twist]


def _unit_vector(angle: Expr) -> ImmutableMatrix:
    return ImmutableMatrix([cos(angle), sin(angle)])
